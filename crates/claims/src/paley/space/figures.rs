//! paley.fig1, paley.fig3, paley.fig4, paley.fig5, paley.beacon: the runs of the figures.

use super::runs::{SHOWN, TYPICAL, random_start, simulated};
use crate::shares::judged;
use arithmetic::Complex;
use ledger::{CheckError, Claim, Control, Outcome, Run};
use models::oscillator::{
    CLUSTER, CyclicFormation, DriftingOrbit, Experiment, FourMotions, OMEGA, PARTICLES, PatternFormation,
    ReferenceTracking, centre_spread, order, pattern, shape_rate,
};
use motion::Share;

/// paley.fig1.
pub struct MotionsFigure;

/// The phases synchronise for this sign of `K_1` and balance for the other; the relative equilibria among the four motions
/// (w0 = 0 or not, synchronised or balanced).
#[derive(Clone, Copy)]
pub struct MotionVariant {
    synchronising: f64,
    equilibria: [[bool; 2]; 2],
}

impl Claim for MotionsFigure {
    type Variant = MotionVariant;

    fn id(&self) -> &str {
        "paley.fig1"
    }

    fn derivation(&self) -> &str {
        "Reading: the four runs of the figure, initial states at random (from the unstable equilibria of Theorem 1, a set of measure zero, the phases do not \
         move); every start tried has to do it, more than the rule for reports of runs asks (notes/paley_particles.md). The phases do not depend on the positions, and in their own frame not on w0: K_1 = ±1 chooses the unit of time; w0 = 0, 0.1 is chosen here. Synchronised: u = w0 and, for w0 = 0, equal velocities: the shape is at rest. For w0 != 0 the \
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
        const TOLERANCE: f64 = 1e-4;
        let seeds = run.cases(6, 40);
        for seed in 0..seeds as u64 {
            for (row, omega) in [0.0, OMEGA].into_iter().enumerate() {
                for (column, gain) in [variant.synchronising, -variant.synchronising].into_iter().enumerate() {
                    run.checkpoint()?;
                    let motion = FourMotions { omega, gain };
                    let flight = motion.end(random_start(run, seed))?;
                    let state = flight.state();
                    let (p, steering) = (order(&flight, 1)?, motion.steering(&state)?);
                    let wanted = if column == 0 { p > 1.0 - TOLERANCE } else { p < TOLERANCE };
                    let turning = steering.iter().all(|u| (u - omega).abs() < TOLERANCE);
                    let at_rest = shape_rate(&state, &steering) < 10.0 * TOLERANCE;
                    if !wanted || !turning || at_rest != variant.equilibria[row][column] {
                        let what = format!(
                            "seed {seed}, w0 = {omega}, K_1 = {gain}, t = 100: |p| = {p:.4}, shape at rest: {at_rest}"
                        );
                        return Ok(Outcome::fails(what, simulated("the four motions", "a run", 1)));
                    }
                }
            }
        }
        let detail = "N = 12, control (9), K_1 = ±1, w0 = 0 and 0.1, step 0.2 to t = 100; |p| within 1e-4 of 1 or 0, u_k within 1e-4 of w0";
        Ok(Outcome::Holds(vec![simulated("the four motions", detail, 4 * seeds)]))
    }
}

/// paley.fig3.
pub struct CyclicFigure;

/// The clusters of the pattern seen for `K_1 < 0`, whether one is seen for `K_1 = 0`, and those for `K_1 > 0`.
#[derive(Clone, Copy)]
pub struct CyclicVariant {
    negative: usize,
    zero_arbitrary: bool,
    positive: usize,
}

impl Claim for CyclicFigure {
    type Variant = CyclicVariant;

    fn id(&self) -> &str {
        "paley.fig3"
    }

    fn derivation(&self) -> &str {
        "Read by the rule for reports of runs (notes/paley_particles.md): a panel shows an outcome of the stated law, and no more: the caption itself names two outcomes for K_1 > 0. For every size of K_1 the \
         synchronised formation is exponentially stable where K_1 < 0 (paley.sync.exp), the splay one with neighbours 5/12 apart where K_1 > 0 \
         (paley.fig3.gain), so that each is reached from an open set of states; the runs find that it is reached from random ones. They are not the only outcomes, and the splay one is not the most frequent: for K_1 < 0 about a third of the runs end in a \
         splay formation with neighbours 1/12 apart, stable too; for K_1 > 0 about two of five in the splay formation and three of five in the (2,N)-pattern, whatever the size of K_1 between 0.01 and 1 (values: shares; more in \
         `reproduce paley.basins`). K_1 = ±0.3 is \
         chosen here: with it the slowest motion decays like e^{-0.006 t}, with ±1 like e^{-0.001 t}."
    }

    fn printed(&self) -> CyclicVariant {
        CyclicVariant { negative: 1, zero_arbitrary: true, positive: PARTICLES }
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
        // The rarest of the three is seen in two of five runs: that none of so many shows it has the probability 10^-5.
        let starts = run.cases(24, 100);
        Run::all(
            [-1.0, 0.0, 1.0]
                .map(|sign| (sign * CyclicFormation::GAIN, starts))
                .into_iter()
                .map(|panel| variant.panel(panel, run)),
        )
    }
}

impl CyclicVariant {
    /// The panel with this `K_1`.
    fn panel(&self, (orientation, starts): (f64, usize), run: &mut Run) -> Result<Outcome, CheckError> {
        let (name, what) = match orientation {
            k if k < 0.0 => ("share_synchronised_K1_negative", format!("clusters: {}", self.negative)),
            k if k > 0.0 => ("share_splay_K1_positive", format!("clusters: {}", self.positive)),
            _ => ("share_arbitrary_K1_zero", format!("no pattern: {}", self.zero_arbitrary)),
        };
        let mut seen = Share::default();
        for seed in 0..starts as u64 {
            run.checkpoint()?;
            let flight = CyclicFormation::new(orientation).end(random_start(run, seed))?;
            // One circle, within a hundredth of its radius.
            let circular = centre_spread(&OMEGA, &flight.state())? * OMEGA < 0.01;
            let shown = match orientation {
                k if k < 0.0 => flight.forms_pattern(self.negative, CLUSTER),
                k if k > 0.0 => flight.forms_pattern(self.positive, CLUSTER),
                _ => pattern(&flight).is_none() == self.zero_arbitrary,
            };
            seen = seen.with(circular && shown);
        }
        run.value(name, seen.enclosure());
        let what = format!("K_1 = {orientation}, {what}: a circular formation with it ends {seen}");
        let detail = format!("C_12, w0 = 0.1, K_0 = 1.2, step 2 to t = 1200, centres within 1% of the radius; {what}");
        Ok(judged(seen, SHOWN, what, simulated("an outcome as in the panel", &detail, seen.of)))
    }
}

/// paley.fig4.
pub struct PatternsFigure;

/// Signs of the gains below `M` and at `M`.
#[derive(Clone, Copy)]
pub struct GainsVariant {
    below: f64,
    last: f64,
}

impl Claim for PatternsFigure {
    type Variant = GainsVariant;

    fn id(&self) -> &str {
        "paley.fig4"
    }

    fn derivation(&self) -> &str {
        "Read by the rule for reports of runs (notes/paley_particles.md): a panel shows an outcome. For all sizes of the gains the six patterns are exponentially stable (paley.thm3.stab), so that each is reached from an \
         open set of states; the runs find that it is reached from random ones. w0 = K_0 = 0.1; the sizes chosen here are K_m = 0.2 for m < M and \
         K_M = -0.04, with which nearly every run reaches its pattern: in `reproduce paley.basins` 395 of 400 for M = 2, all 400 for M = 3, 4, 6 and 12. With larger |K_M| fewer do (K_M = -0.2: a third for M = 3), since other \
         local minima of (25) exist, for instance 4-2-4-2 for M = 4 and K_m = -K_M."
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
        let starts = run.cases(4, 20);
        let (below, last) = PatternFormation::GAINS;
        let mut evidence = Vec::new();
        for clusters in [1, 2, 3, 4, 6, 12] {
            let gain = |m: usize| if m < clusters { below * variant.below } else { last * variant.last };
            let formation = PatternFormation::new((1..=clusters).map(gain).collect());
            let mut reached = Share::default();
            for seed in 0..starts as u64 {
                run.checkpoint()?;
                let flight = formation.end(random_start(run, seed))?;
                let circular = centre_spread(&OMEGA, &flight.state())? * OMEGA < 0.05;
                reached = reached.with(circular && flight.forms_pattern(clusters, CLUSTER));
            }
            run.value(&format!("share_M_{clusters}"), reached.enclosure());
            let what = format!("M = {clusters}: the pattern is reached in {reached}");
            let detail = format!(
                "all-to-all, N = 12, w0 = K_0 = 0.1, K_m = {}, K_M = {}, step 2 to t = 1200; equal clusters, evenly spaced within 5 degrees, centres within 5% of the radius; {what}",
                below * variant.below,
                last * variant.last
            );
            match judged(reached, SHOWN, what, simulated("an outcome as in the panel", &detail, reached.of)) {
                Outcome::Holds(more) => evidence.extend(more),
                other => return Ok(other),
            }
        }
        Ok(Outcome::Holds(evidence))
    }
}

/// paley.fig5.
pub struct TrackingFigure;

/// Sign of `K_1`, and whether a particle is coupled to the reference.
#[derive(Clone, Copy)]
pub struct ReferenceVariant {
    gain: f64,
    coupled: bool,
}

impl Claim for TrackingFigure {
    type Variant = ReferenceVariant;

    fn id(&self) -> &str {
        "paley.fig5"
    }

    fn derivation(&self) -> &str {
        "Read by the rule for reports of runs (notes/paley_particles.md): a sentence on what the particles do. All-to-all control (14) plus the gradient of 1 - cos(theta_0 - theta_N) on particle N, both with the gain K_1, whose size \
         is the unit of time: K_1 = -1. The lengths of the legs are not printed: 320 time units here, long against the \
         slowest rate of the synchronised group, about |K_1|/(2N). At the end of each leg every heading agrees with the reference and the group moves along \
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
        const TOLERANCE: f64 = 1e-2;
        // Legs twice as long as in the picture: the slowest decay over one is e^-13.
        const LENGTHS: usize = 2;
        let (mut tracked, mut worst) = (Share::default(), 0.0_f64);
        for seed in 0..run.cases(12, 40) as u64 {
            run.checkpoint()?;
            let (mut flight, mut off) = (random_start(run, seed), 0.0_f64);
            for tracking in ReferenceTracking::legs(variant.gain, variant.coupled) {
                tracking.advance(&mut flight, LENGTHS * ReferenceTracking::STEPS)?;
                off = off.max(tracking.error(&flight));
            }
            tracked = tracked.with(off <= TOLERANCE);
            worst = worst.max(off);
        }
        run.value("share_tracking", tracked.enclosure());
        let what = format!(
            "every heading is within {TOLERANCE} of the reference at the end of each leg in {tracked}; at most {worst:.1e} in any"
        );
        let detail = format!("N = 12, w0 = 0, K_1 = {}, all-to-all, four legs of 320, step 0.5; {what}", variant.gain);
        Ok(judged(tracked, TYPICAL, what, simulated("tracking", &detail, tracked.of)))
    }
}

/// paley.beacon.
pub struct BeaconFigure;

/// Whether there is a beacon, and whether the orbit's centre is claimed to be the beacon itself.
#[derive(Clone, Copy)]
pub struct OrbitVariant {
    beacon: bool,
    at_beacon: bool,
}

impl Claim for BeaconFigure {
    type Variant = OrbitVariant;

    fn id(&self) -> &str {
        "paley.beacon"
    }

    fn derivation(&self) -> &str {
        "Readings (rule for reports of runs in notes/paley_particles.md; every start tried has to do it): control (14) with K_1 = -0.1 (the caption's K_1 > 0 does not synchronise, paley.fig6.gain) plus the beacon's w0 K_0 <e^{i theta_k}, c_k - c_0>, all-to-all. \
         Averaged over a turn, to first order, cdot = -(K_0/2)(c - c_0) + f, which balances at c_0 + 2 f/K_0 = 8: the orbit closes around a fixed point, but that \
         is not the beacon at 10 (values: mean position over a turn, which is that of the circle centres plus i f/w0 because the mean velocity is 0). Without the beacon it moves on by 2 pi f/w0 in each turn."
    }

    fn printed(&self) -> OrbitVariant {
        OrbitVariant { beacon: true, at_beacon: false }
    }

    fn controls(&self) -> Vec<Control<OrbitVariant>> {
        vec![
            Control::new("no beacon, the spacing control instead", OrbitVariant { beacon: false, at_beacon: false }),
            Control::new("the centre of the orbit is the beacon", OrbitVariant { beacon: true, at_beacon: true }),
        ]
    }

    fn examine(&self, variant: &OrbitVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        const TOLERANCE: f64 = 0.1;
        let orbit = if variant.beacon { DriftingOrbit::around_beacon(-0.1) } else { DriftingOrbit::free(-0.1) };
        let seeds = run.cases(2, 20);
        for seed in 0..seeds as u64 {
            run.checkpoint()?;
            let mut flight = orbit.end(random_start(run, seed))?;
            let centres = [orbit.turn(&mut flight)?, orbit.turn(&mut flight)?, orbit.turn(&mut flight)?];
            let apart = |a: &Complex<f64>, b: &Complex<f64>| (a.clone() - b).norm_squared().sqrt();
            let moved = apart(&centres[0], &centres[2]);
            let off = apart(&centres[2], &DriftingOrbit::BEACON);
            let together = flight.clusters(CLUSTER).len() == 1;
            // A turn holds a whole number of steps up to one: the mean is off by less than step/turn of the radius, 0.05.
            if moved > TOLERANCE || !together || variant.at_beacon && off > TOLERANCE {
                let what = format!(
                    "seed {seed}: the mean position over a turn moves by {moved:.3} in two turns and is {off:.3} from the beacon"
                );
                return Ok(Outcome::fails(what, simulated("the orbit", "a run", 1)));
            }
            run.value("orbit_centre_re", format!("~{:.2}", centres[2].re));
            run.value("orbit_centre_im", format!("~{:.2}", centres[2].im));
        }
        let detail = "N = 12, f = -0.1, w0 = K_0 = 0.1, K_1 = -0.1, beacon 10, step 0.2, three turns after t = 400; synchronised, mean position fixed within 0.1";
        Ok(Outcome::Holds(vec![simulated("a fixed centre", detail, seeds)]))
    }
}
