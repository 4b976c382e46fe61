//! paley.fig1, paley.fig3, paley.fig4, paley.fig5, paley.beacon: the runs of the figures.

use super::runs::{CLUSTER, DECLARATION, centre_spread, is_pattern, random_start};
use crate::arithmetic::{ArithmeticError, Complex};
use crate::ledger::{CheckError, Claim, Control, Evidence, Grade, Outcome, Run};
use crate::oscillator::{
    CircularGains, Flight, Neighbours, State, beacon_control, circular_control, gradient_control, laplacian_control,
    mean, pattern_control, quarter_turn, reference_control, spacing_control,
};
use crate::simulate::Share;
use std::f64::consts::{FRAC_PI_8, PI, TAU};

const N: usize = 12;

fn still() -> Complex<f64> {
    Complex::new(0.0, 0.0)
}

fn order(flight: &Flight) -> Result<f64, ArithmeticError> {
    Ok(mean(&flight.state().phasors)?.norm_squared().sqrt())
}

fn simulated(part: &str, detail: String, cases: usize) -> Evidence {
    Evidence::new(Grade::Simulated, part, format!("{detail}; {DECLARATION}")).cases(cases)
}

/// paley.fig1.
pub struct FourMotions;

/// The phases synchronise for this sign of `K_1` and balance for the other; the relative equilibria among the four motions
/// (w0 = 0 or not, synchronised or balanced).
#[derive(Clone, Copy)]
pub struct MotionVariant {
    synchronising: f64,
    equilibria: [[bool; 2]; 2],
}

/// The largest rate of change of a relative position `r_kj e^{-i theta_k}` or relative phase.
fn shape_rate(state: &State<f64>, steering: &[f64]) -> f64 {
    let mut largest: f64 = 0.0;
    for (k, (r, z)) in state.positions.iter().zip(&state.phasors).enumerate() {
        for (j, (s, w)) in state.positions.iter().zip(&state.phasors).enumerate() {
            let turning = quarter_turn(&(r.clone() - s)).scale(&steering[k]);
            let rate = z.clone() - w - turning;
            largest = largest.max(rate.norm_squared().sqrt()).max((steering[k] - steering[j]).abs());
        }
    }
    largest
}

impl Claim for FourMotions {
    type Variant = MotionVariant;

    fn id(&self) -> &str {
        "paley.fig1"
    }

    fn derivation(&self) -> &str {
        "Reading: the four runs of the figure, initial states at random (from the unstable equilibria of Theorem 1, a set of measure zero, the phases do not \
         move); K_1 = ±1 and w0 = 0, 0.1 are chosen here. Synchronised: u = w0 and, for w0 = 0, equal velocities: the shape is at rest. For w0 != 0 the \
         circle centres differ as at the start, so the shape turns (paley.releq); balanced: velocities differ. In both balanced cases |Rdot| = |p_theta| -> 0."
    }

    fn printed(&self) -> MotionVariant {
        MotionVariant { synchronising: -1.0, equilibria: [[true, false], [false, false]] }
    }

    fn controls(&self) -> Vec<Control<MotionVariant>> {
        let printed = self.printed();
        vec![
            Control::new("K_1 > 0 synchronises", MotionVariant { synchronising: 1.0, ..printed }),
            Control::new(
                "synchronised circles are a relative equilibrium",
                MotionVariant { equilibria: [[true, false], [true, false]], ..printed },
            ),
            Control::new(
                "balanced straight motion is one",
                MotionVariant { equilibria: [[true, true], [false, false]], ..printed },
            ),
        ]
    }

    fn examine(&self, variant: &MotionVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        const STEPS: (f64, usize) = (0.2, 500);
        const TOLERANCE: f64 = 1e-4;
        let seeds = run.cases(4, 40);
        for seed in 0..seeds as u64 {
            for (row, omega) in [0.0, 0.1].into_iter().enumerate() {
                for (column, gain) in [variant.synchronising, -variant.synchronising].into_iter().enumerate() {
                    run.checkpoint()?;
                    let law = |state: &State<f64>| {
                        Ok(gradient_control(&gain, &state.phasors)?.into_iter().map(|u| u + omega).collect())
                    };
                    let mut flight = random_start(run, seed, N);
                    flight.advance(STEPS, &still(), law)?;
                    let (p, steering) = (order(&flight)?, law(&flight.state())?);
                    let wanted = if column == 0 { p > 1.0 - TOLERANCE } else { p < TOLERANCE };
                    let turning = steering.iter().all(|u| (u - omega).abs() < TOLERANCE);
                    let at_rest = shape_rate(&flight.state(), &steering) < 10.0 * TOLERANCE;
                    if !wanted || !turning || at_rest != variant.equilibria[row][column] {
                        let what = format!(
                            "seed {seed}, w0 = {omega}, K_1 = {gain}, t = 100: |p| = {p:.4}, shape at rest: {at_rest}"
                        );
                        return Ok(Outcome::fails(what, simulated("the four motions", "a run".to_string(), 1)));
                    }
                }
            }
        }
        let detail = "N = 12, control (9), K_1 = ±1, w0 = 0 and 0.1, step 0.2 to t = 100; |p| within 1e-4 of 1 or 0, u_k within 1e-4 of w0";
        Ok(Outcome::Holds(vec![simulated("the four motions", detail.to_string(), 4 * seeds)]))
    }
}

/// paley.fig3.
pub struct CyclicFormations;

/// The clusters of the pattern seen for `K_1 < 0`, whether one is seen for `K_1 = 0`, and those for `K_1 > 0`.
#[derive(Clone, Copy)]
pub struct CyclicVariant {
    negative: usize,
    zero_arbitrary: bool,
    positive: usize,
}

impl Claim for CyclicFormations {
    type Variant = CyclicVariant;

    fn id(&self) -> &str {
        "paley.fig3"
    }

    fn derivation(&self) -> &str {
        "Reading: what the three panels show are outcomes of the stated law, and no more: the caption itself names two outcomes for K_1 > 0. The \
         synchronised formation is exponentially stable for K_1 < 0 (paley.sync.exp), the splay one with neighbours 5/12 apart for K_1 > 0 \
         (paley.fig3.gain), and each is reached from random states. They are not the only ones: for K_1 < 0 about half of the runs end in the \
         splay formation with neighbours 1/12 apart, stable too; for K_1 > 0 many in the (2,N)-pattern (values: shares). K_1 = ±1 is chosen here."
    }

    fn printed(&self) -> CyclicVariant {
        CyclicVariant { negative: 1, zero_arbitrary: true, positive: N }
    }

    fn controls(&self) -> Vec<Control<CyclicVariant>> {
        let printed = self.printed();
        vec![
            Control::new("two clusters for K_1 < 0", CyclicVariant { negative: 2, ..printed }),
            Control::new("synchronised for K_1 > 0", CyclicVariant { positive: 1, ..printed }),
            Control::new("a pattern for K_1 = 0", CyclicVariant { zero_arbitrary: false, ..printed }),
        ]
    }

    fn examine(&self, variant: &CyclicVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        const STEPS: (f64, usize) = (1.0, 800);
        const OMEGA: f64 = 0.1;
        let network = Neighbours::circulant(N, &[1]);
        let seeds = run.cases(4, 60);
        let mut seen = [0; 3];
        for seed in 0..seeds as u64 {
            for (panel, orientation) in [-1.0, 0.0, 1.0].into_iter().enumerate() {
                run.checkpoint()?;
                let gains = CircularGains { omega: OMEGA, spacing: N as f64 * OMEGA, orientation };
                let mut flight = random_start(run, seed, N);
                flight.advance(STEPS, &still(), |state| circular_control(&gains, &network, &network, state))?;
                seen[panel] += usize::from(match panel {
                    0 => is_pattern(&flight, variant.negative),
                    1 => centre_spread(OMEGA, &flight) < 0.1 && (1..=N).all(|m| !is_pattern_divisor(&flight, m)),
                    _ => is_pattern(&flight, variant.positive),
                });
            }
        }
        let [negative, zero, positive] = seen;
        run.value("share_synchronised_K1_negative", Share::new(negative, seeds).enclosure());
        run.value("share_splay_K1_positive", Share::new(positive, seeds).enclosure());
        let evidence = simulated(
            "outcomes of the three panels",
            format!(
                "C_12, w0 = 0.1, K_0 = 1.2, K_1 = -1, 0, 1, step 1 to t = 800; seen in {negative}, {zero}, {positive} of {seeds} runs"
            ),
            3 * seeds,
        );
        let arbitrary = zero == seeds;
        if negative == 0 || positive == 0 || arbitrary != variant.zero_arbitrary {
            let what = format!("seen in {negative}, {zero} and {positive} of {seeds} runs with K_1 = -1, 0, 1");
            return Ok(Outcome::fails(what, evidence));
        }
        Ok(Outcome::Holds(vec![evidence]))
    }
}

fn is_pattern_divisor(flight: &Flight, clusters: usize) -> bool {
    N.is_multiple_of(clusters) && is_pattern(flight, clusters)
}

/// paley.fig4.
pub struct SixPatterns;

/// Signs of the gains below `M` and at `M`.
#[derive(Clone, Copy)]
pub struct GainsVariant {
    below: f64,
    last: f64,
}

impl Claim for SixPatterns {
    type Variant = GainsVariant;

    fn id(&self) -> &str {
        "paley.fig4"
    }

    fn derivation(&self) -> &str {
        "All six patterns are exponentially stable (paley.thm3.stab). The figure's runs: w0 = K_0 = 0.1; the gains are chosen here, K_m = 0.2 for m < M and \
         K_M = -0.04. Every run from a random state reached its pattern. With larger |K_M| other local minima of (25) exist, for instance 4-2-4-2 for M = 4 and K_m = -K_M."
    }

    fn printed(&self) -> GainsVariant {
        GainsVariant { below: 1.0, last: -1.0 }
    }

    fn controls(&self) -> Vec<Control<GainsVariant>> {
        vec![
            Control::new("K_M > 0", GainsVariant { below: 1.0, last: 1.0 }),
            Control::new("K_m < 0 below M", GainsVariant { below: -1.0, last: -1.0 }),
        ]
    }

    fn examine(&self, variant: &GainsVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        const STEPS: (f64, usize) = (1.0, 600);
        const OMEGA: f64 = 0.1;
        let network = Neighbours::complete(N);
        let seeds = run.cases(1, 10);
        for clusters in [1, 2, 3, 4, 6, 12] {
            let gain = |m: usize| if m < clusters { 0.2 * variant.below } else { 0.04 * variant.last };
            let gains: Vec<f64> = (1..=clusters).map(gain).collect();
            let mut reached = 0;
            for seed in 0..seeds as u64 {
                run.checkpoint()?;
                let mut flight = random_start(run, seed, N);
                flight.advance(STEPS, &still(), |state| {
                    let pulled = spacing_control(&OMEGA, &0.1, &network, state)?;
                    let turned = pattern_control(&gains, &state.phasors)?;
                    Ok(pulled.into_iter().zip(turned).map(|(s, o)| s + o + OMEGA).collect())
                })?;
                reached += usize::from(is_pattern(&flight, clusters) && centre_spread(OMEGA, &flight) < 1.0);
            }
            if reached == 0 {
                let what = format!("M = {clusters}: none of {seeds} runs reached the pattern");
                return Ok(Outcome::fails(what, simulated("the patterns", "runs".to_string(), seeds)));
            }
            run.value(&format!("share_M_{clusters}"), Share::new(reached, seeds).enclosure());
        }
        let detail = "all-to-all, N = 12, w0 = K_0 = 0.1, K_m = 0.2, K_M = -0.04, step 1 to t = 600; equal clusters, evenly spaced within 5 degrees";
        Ok(Outcome::Holds(vec![simulated("M = 1, 2, 3, 4, 6, 12 are reached", detail.to_string(), 6 * seeds)]))
    }
}

/// paley.fig5.
pub struct ReferenceTracking;

/// Sign of `K_1`, and whether a particle is coupled to the reference.
#[derive(Clone, Copy)]
pub struct ReferenceVariant {
    gain: f64,
    coupled: bool,
}

impl Claim for ReferenceTracking {
    type Variant = ReferenceVariant;

    fn id(&self) -> &str {
        "paley.fig5"
    }

    fn derivation(&self) -> &str {
        "Reading: all-to-all control (14) with K_1 = -1 plus the gradient of 1 - cos(theta_0 - theta_N) on particle N; legs of 160 time units, long against the \
         slowest rate of the synchronised group, about |K_1|/N. At the end of each leg every heading agrees with the reference and the group moves along \
         a straight line in that direction: theta = theta_0 1 is the only stable equilibrium, the minimum of W_1 + 1 - cos(theta_0 - theta_N)."
    }

    fn printed(&self) -> ReferenceVariant {
        ReferenceVariant { gain: -1.0, coupled: true }
    }

    fn controls(&self) -> Vec<Control<ReferenceVariant>> {
        vec![
            Control::new("K_1 > 0", ReferenceVariant { gain: 1.0, coupled: true }),
            Control::new("nobody coupled to the reference", ReferenceVariant { gain: -1.0, coupled: false }),
        ]
    }

    fn examine(&self, variant: &ReferenceVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        const LEG: (f64, usize) = (0.5, 320);
        const TOLERANCE: f64 = 1e-2;
        let network = Neighbours::complete(N);
        let seeds = run.cases(3, 30);
        for seed in 0..seeds as u64 {
            let mut flight = random_start(run, seed, N);
            for (leg, reference) in [FRAC_PI_8, -3.0 * FRAC_PI_8, FRAC_PI_8, -3.0 * FRAC_PI_8].into_iter().enumerate() {
                run.checkpoint()?;
                let direction = Complex::new(reference.cos(), reference.sin());
                flight.advance(LEG, &still(), |state| match variant.coupled {
                    true => reference_control(&variant.gain, &network, &direction, &state.phasors),
                    false => laplacian_control(&variant.gain, &network, &state.phasors),
                })?;
                let off = |theta: &f64| ((theta - reference + PI).rem_euclid(TAU) - PI).abs();
                let worst = flight.phases.iter().map(off).fold(0.0, f64::max);
                if worst > TOLERANCE {
                    let what = format!("seed {seed}, leg {}: a heading is {worst:.3} from the reference", leg + 1);
                    return Ok(Outcome::fails(what, simulated("tracking", "a run".to_string(), 1)));
                }
            }
        }
        let detail = "N = 12, w0 = 0, K_1 = -1, all-to-all, four legs of 160, step 0.5; every heading within 0.01 of the reference at the end of each leg";
        Ok(Outcome::Holds(vec![simulated("tracking", detail.to_string(), seeds)]))
    }
}

/// paley.beacon.
pub struct BeaconOrbit;

/// Gain of the beacon, and whether the orbit's centre is claimed to be the beacon itself.
#[derive(Clone, Copy)]
pub struct OrbitVariant {
    beacon: f64,
    at_beacon: bool,
}

impl Claim for BeaconOrbit {
    type Variant = OrbitVariant;

    fn id(&self) -> &str {
        "paley.beacon"
    }

    fn derivation(&self) -> &str {
        "Readings: control (14) with K_1 = -0.1 (the caption's K_1 > 0 does not synchronise, paley.fig6.gain) plus the beacon's w0 K_0 <e^{i theta_k}, c_k - c_0>, all-to-all. \
         Averaged over a turn cdot = -(K_0/2)(c - c_0) + f, which balances at c_0 + 2 f/K_0 = 8: the orbit closes around a fixed point, but that \
         is not the beacon at 10 (values: mean position over a turn). Without the beacon it moves on by 2 pi f/w0 in each turn."
    }

    fn printed(&self) -> OrbitVariant {
        OrbitVariant { beacon: 0.1, at_beacon: false }
    }

    fn controls(&self) -> Vec<Control<OrbitVariant>> {
        vec![
            Control::new("no beacon", OrbitVariant { beacon: 0.0, at_beacon: false }),
            Control::new("the centre of the orbit is the beacon", OrbitVariant { beacon: 0.1, at_beacon: true }),
        ]
    }

    fn examine(&self, variant: &OrbitVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        const OMEGA: f64 = 0.1;
        const STEP: f64 = 0.2;
        const TOLERANCE: f64 = 1e-2;
        let (network, beacon, drift) = (Neighbours::complete(N), Complex::new(10.0, 0.0), Complex::new(-0.1, 0.0));
        let law = |state: &State<f64>| {
            let turned = laplacian_control(&-0.1, &network, &state.phasors)?;
            let pulled = beacon_control(&OMEGA, &variant.beacon, &beacon, state)?;
            Ok(pulled.into_iter().zip(turned).map(|(s, o)| s + o + OMEGA).collect())
        };
        let seeds = run.cases(2, 20);
        for seed in 0..seeds as u64 {
            run.checkpoint()?;
            let mut flight = random_start(run, seed, N);
            flight.advance((STEP, 2000), &drift, law)?;
            // The mean position over each of three turns of the first particle.
            let mut centres = Vec::new();
            for _ in 0..3 {
                let (until, mut sum, mut steps) = (flight.phases[0] + TAU, still(), 0.0);
                while flight.phases[0] < until && steps < 1e4 {
                    sum = sum + mean(&flight.positions)?;
                    steps += 1.0;
                    flight.advance((STEP, 1), &drift, law)?;
                }
                centres.push(sum.scale(&(1.0 / steps)));
            }
            let apart = |a: &Complex<f64>, b: &Complex<f64>| (a.clone() - b).norm_squared().sqrt();
            let moved = apart(&centres[0], &centres[2]);
            let off = apart(&centres[2], &beacon);
            let together = flight.clusters(CLUSTER).len() == 1;
            // A turn holds a whole number of steps up to one: the mean is off by less than step/turn of the radius, 0.05.
            if moved > 10.0 * TOLERANCE || !together || variant.at_beacon && off > 10.0 * TOLERANCE {
                let what = format!(
                    "seed {seed}: the mean position over a turn moves by {moved:.3} in two turns and is {off:.3} from the beacon"
                );
                return Ok(Outcome::fails(what, simulated("the orbit", "a run".to_string(), 1)));
            }
            run.value("orbit_centre_re", format!("~{:.2}", centres[2].re));
            run.value("orbit_centre_im", format!("~{:.2}", centres[2].im));
        }
        let detail = "N = 12, f = -0.1, w0 = K_0 = 0.1, K_1 = -0.1, beacon 10, step 0.2, three turns after t = 400; synchronised, mean position fixed within 0.1";
        Ok(Outcome::Holds(vec![simulated("a fixed centre", detail.to_string(), seeds)]))
    }
}
