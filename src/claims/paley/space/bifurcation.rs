//! paley.fig8.circ, paley.fig8.neg, paley.fig8.pos: the bifurcation in the size of the orientation zone.

use super::instances::{StateIdentity, one_way_ring, state_identity};
use super::runs::{random_start, simulated};
use crate::arithmetic::{ArithmeticError, Complex, CosineField, Field, RealCyclotomic, Ring, Signed};
use crate::ledger::{CheckError, Claim, Control, Evidence, Fault, Grade, Outcome, Repair, Run};
use crate::oscillator::{
    CLUSTER, Experiment, Flight, Neighbours, OMEGA, PARTICLES, State, ZoneFormation, ZoneLaw, centre_spread,
    misalignment, relative_position_control, shape_rate,
};
use crate::simulate::Share;
use std::f64::consts::TAU;

/// The run of a replicate to its end.
fn fly(formation: &ZoneFormation, seed: u64, run: &Run) -> Result<Flight, CheckError> {
    run.checkpoint()?;
    Ok(formation.end(random_start(run, seed))?)
}

/// Sizes of `K_1` over `K_0` that are tried: in an ordinary run the first ones only.
fn sizes(run: &Run, ordinary: usize) -> &'static [f64] {
    const SIZES: [f64; 5] = [1.0, 0.5, 2.0, 5.0, 10.0];
    &SIZES[..run.cases(ordinary, SIZES.len())]
}

/// `K_0`.
const SPACING: f64 = 0.1;

/// paley.fig8.circ.
pub struct CircularInZones;

/// The gains `K_1` for which all runs converge, the spacing gain, and the spread that counts as one circle, as a share of its radius.
#[derive(Clone, Copy)]
pub struct CircularVariant {
    orientation: &'static [f64],
    spacing: f64,
    spread: f64,
}

/// Whether `u_k < omega` near the splay formation for every way to decide the ties: the particle 30 degrees ahead on the boundary of the
/// zone, the one 60 degrees behind on the edge of the blind spot. `excess = (K_1 - K_0)/K_0`.
fn splay_turns_slower(excess: i64) -> bool {
    let field = CosineField::new(PARTICLES as u32);
    let phasors: Vec<Complex<RealCyclotomic>> = (0..PARTICLES as i64).map(|k| field.phasor(k)).collect();
    // Particle 0 senses the one `steps` ahead; those behind by less than 60 degrees are blind.
    let tau = |senses: &dyn Fn(usize) -> bool| {
        let network = Neighbours::from_fn(PARTICLES, |k, j| senses((j + PARTICLES - k) % PARTICLES));
        misalignment(&network, &phasors)[0].clone()
    };
    let mut slower = true;
    for behind_seen in [false, true] {
        let seen = |steps: usize| steps != PARTICLES - 1 && (steps != PARTICLES - 2 || behind_seen);
        let attracted = tau(&seen);
        for zone in ZoneFormation::CLUSTERS {
            for edge in [false, true] {
                let oriented = tau(&|steps: usize| match zone {
                    12 => steps == 1 && edge,
                    8 => steps == 1,
                    _ => seen(steps),
                });
                // (N/K_0)(u - omega) in the formation, where <e^{i theta}, L^att r> = tau^att/omega.
                let turning = oriented.clone() * oriented.integer(excess) + &attracted;
                slower &= turning.is_certainly_negative();
            }
        }
    }
    slower
}

impl Claim for CircularInZones {
    type Variant = CircularVariant;

    fn id(&self) -> &str {
        "paley.fig8.circ"
    }

    fn derivation(&self) -> &str {
        "Reading, the same for the three claims on Figure 8: runs from random initial states, N = 12, K_1 of any size (the figure has both signs, the paper gives no \
         size). Under (29) as printed with K_1 = 5 K_0 and 10 K_0 no run comes to a circular formation of any radius: the shape is never at rest, so that the wider \
         sense of paley.releq, in which the common rate takes the place of w0, does not help. (K_1 = 2 K_0: the same for M = 12, 8; three of four runs converge for M = 2.) For K_1 = \
         ±K_0 every run converges; at K_1 = K_0 the zone has no effect (paley.fig8.pos). For K_1 = -5 K_0, -10 K_0 runs converge too, but slowly. There are exact exceptions from symmetric states: start in r_k = \
         e^{2 pi i k/12} r, theta_k = 2 pi k/12 + theta. The law keeps the symmetry. Convergence to a circular formation of radius 1/|w0| would bring the centres to 0 \
         and u_k near w0 + ((K_1 - K_0) tau^ori + K_0 tau^att)/N at the splay phases; a particle does not see the one 30 degrees behind, so tau^att <= -1/2 and tau^ori \
         <= 0: u_k <= w0 - K_0/(2N) for K_1 >= K_0 whichever way the ties at the boundaries fall. But with c near 0 and 1 - u/w0 >= epsilon > 0, (d/dt) <c, e^{i \
         theta}> = 1 - u/w0 + small: contradiction. (In the wider sense some of these symmetric states are circular formations of another radius.)"
    }

    fn printed(&self) -> CircularVariant {
        CircularVariant { orientation: &[0.5, 1.0, -0.1, 0.1], spacing: SPACING, spread: 0.02 }
    }

    fn repair(&self) -> Option<Repair<CircularVariant>> {
        Some(Repair {
            fault: Fault::False,
            statement: "Under (29) with w0 = K_0 = 0.1, N = 12, the blind spot of 60 degrees and K_1 = ±K_0, runs from random initial states converge \
                        to a circular formation of radius 1/|w0| (for K_1 = 5 K_0 and 10 K_0 they converge to none)."
                .to_string(),
            variant: CircularVariant { orientation: &[-0.1, 0.1], spacing: SPACING, spread: 0.02 },
        })
    }

    fn controls(&self) -> Vec<Control<CircularVariant>> {
        vec![
            Control::new("no spacing control", CircularVariant { orientation: &[-0.1], spacing: 0.0, spread: 0.02 }),
            Control::new(
                "exactly on one circle at t = 600",
                CircularVariant { orientation: &[-0.1], spacing: SPACING, spread: 1e-9 },
            ),
            Control::new("K_1 = 2 K_0", CircularVariant { orientation: &[0.2], spacing: SPACING, spread: 0.02 }),
        ]
    }

    fn examine(&self, variant: &CircularVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let seeds = run.cases(2, 8);
        // Hundreds of time units for which a run that is not on one circle is followed.
        let longer = run.cases(6, 54);
        let mut runs = 0;
        for &orientation in variant.orientation {
            let mut off: Vec<Astray> = Vec::new();
            for clusters in ZoneFormation::CLUSTERS {
                let formation =
                    ZoneFormation { law: ZoneLaw::Printed, spacing: variant.spacing, orientation, clusters };
                for seed in 0..seeds as u64 {
                    runs += 1;
                    let flight = fly(&formation, seed, run)?;
                    if centre_spread(&OMEGA, &flight.state())? * OMEGA > variant.spread {
                        off.push(Astray::follow(&formation, flight, longer)?);
                    }
                }
            }
            if !off.is_empty() {
                let least = |of: fn(&Astray) -> f64| off.iter().map(of).fold(f64::INFINITY, f64::min);
                let what = format!(
                    "K_1 = {orientation}: in {} of {} runs (M = 12, 8, 2) the centres are at least {:.3} of the radius from their mean at each multiple of 100 \
                     from t = 600 to {}, and relative positions or phases change there at a rate of at least {:.3}",
                    off.len(),
                    3 * seeds,
                    least(|run| run.spread),
                    600 + 100 * longer,
                    least(|run| run.rate)
                );
                let detail = format!("(29) as printed, w0 = K_0 = 0.1, step 1 to t = {}", 600 + 100 * longer);
                let mut evidence = vec![simulated("no circular formation of any radius", &detail, off.len())];
                if orientation >= SPACING && [0, 1, 4].into_iter().all(splay_turns_slower) {
                    let detail = "r_k = e^{2 pi i k/12} r, theta_k = 2 pi k/12 + theta, K_1 = K_0, 2 K_0, 5 K_0: near the circular formation of radius 1/w0 every u_k < w0; \
                                  exact sines, every way to decide the ties";
                    evidence.push(Evidence::new(Grade::Exact, "symmetric initial states", detail));
                }
                return Ok(Outcome::Fails { counterexample: what, evidence });
            }
        }
        let detail = format!(
            "(29) as printed, w0 = K_0 = 0.1, K_1 = {:?}, zones M = 2, 8, 12, step 1 to t = 600; centres within 2% of the radius",
            variant.orientation
        );
        Ok(Outcome::Holds(vec![simulated("circular formation", &detail, runs)]))
    }
}

/// A run that is on no circle of radius `1/omega` at its end: the least spread of the centres over the radius and the least rate of
/// change of the shape in the time that follows.
struct Astray {
    spread: f64,
    rate: f64,
}

impl Astray {
    /// Follows the run for so many hundreds of time units.
    fn follow(formation: &ZoneFormation, mut flight: Flight, hundreds: usize) -> Result<Self, CheckError> {
        let mut least = Astray { spread: f64::INFINITY, rate: f64::INFINITY };
        for _ in 0..=hundreds {
            let state = flight.state();
            least.spread = least.spread.min(centre_spread(&OMEGA, &flight.state())? * OMEGA);
            least.rate = least.rate.min(shape_rate(&state, &formation.steering(&state)?));
            formation.advance(&mut flight, 100)?;
        }
        Ok(least)
    }
}

/// paley.fig8.neg.
pub struct FewerClusters;

/// The sign of `K_1`, and whether clusters are fewer in larger zones.
#[derive(Clone, Copy)]
pub struct FewerVariant {
    sign: f64,
    growing: bool,
}

impl Claim for FewerClusters {
    type Variant = FewerVariant;

    fn id(&self) -> &str {
        "paley.fig8.neg"
    }

    fn derivation(&self) -> &str {
        "Readings: particles \"in overlapping orientation zones\" are those of which one senses the other in its zone (zones of clusters a chord apart overlap as \
         discs in Figure 8(b) too, so that cannot be meant); they end within 10 degrees of each other. Random initial states and K_1 of any size as in paley.fig8.circ (ordinary runs: \
         K_1 = -K_0; full ones from -K_0/2 to -10 K_0, where the approach is slow); from symmetric states particles can stay in each other's zones for ever, apart. Runs with \
         the printed (29) and with the corrected one. Over the same random starts the number of clusters does not increase with the zone, from the smallest \
         zone to a single cluster in the largest (values: mean numbers, M = 12, 8, 2; with the printed law M = 12 and 8 hardly differ)."
    }

    fn printed(&self) -> FewerVariant {
        FewerVariant { sign: -1.0, growing: true }
    }

    fn controls(&self) -> Vec<Control<FewerVariant>> {
        vec![
            Control::new("K_1 > 0", FewerVariant { sign: 1.0, growing: true }),
            Control::new("more clusters in larger zones", FewerVariant { sign: -1.0, growing: false }),
        ]
    }

    fn examine(&self, variant: &FewerVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let seeds = run.cases(3, 6);
        let gains = sizes(run, 1);
        for law in [ZoneLaw::Printed, ZoneLaw::Corrected] {
            for &size in gains {
                let orientation = variant.sign * size * SPACING;
                let mut totals = Vec::new();
                for clusters in ZoneFormation::CLUSTERS {
                    let formation = ZoneFormation { law, spacing: SPACING, orientation, clusters };
                    let total = clusters_reached(&formation, (seeds, if gains.len() > 1 { 3 } else { 1 }), run)?;
                    let total = match total {
                        Ok(total) => total,
                        Err(what) => return Ok(Outcome::fails(what, simulated("synchronised clusters", "a run", 1))),
                    };
                    let name = format!("mean_clusters_{}_K1_{orientation:.2}_M_{clusters}", law.word());
                    run.value(&name, format!("~{:.2}", total as f64 / seeds as f64));
                    totals.push(total);
                }
                let fewer =
                    totals.windows(2).all(|pair| pair[1] <= pair[0]) && totals[2] < totals[0] && totals[2] == seeds;
                if fewer != variant.growing {
                    let what = format!(
                        "{} (29), K_1 = {orientation}: {totals:?} clusters in {seeds} runs for M = 12, 8, 2",
                        law.word()
                    );
                    return Ok(Outcome::fails(what, simulated("number of clusters", "runs", 3 * seeds)));
                }
            }
        }
        let detail = format!(
            "printed and corrected (29), N = 12, w0 = K_0 = 0.1, K_1 = -K_0 times {gains:?}, blind spot 60 degrees, step 1 to t = 600 (1800 in full runs)"
        );
        let cases = 6 * seeds * gains.len();
        Ok(Outcome::Holds(vec![simulated("fewer, larger, synchronised clusters", &detail, cases)]))
    }
}

/// The clusters in all runs together, each `lengths` times as long as usual; or where a particle senses one that is apart.
fn clusters_reached(
    formation: &ZoneFormation,
    (seeds, lengths): (usize, usize),
    run: &Run,
) -> Result<Result<usize, String>, CheckError> {
    let mut total = 0;
    for seed in 0..seeds as u64 {
        let mut flight = fly(formation, seed, run)?;
        formation.advance(&mut flight, (lengths - 1) * ZoneFormation::STEPS)?;
        let apart = formation.sensed_apart(&flight);
        if apart >= CLUSTER {
            return Ok(Err(format!(
                "{} (29), K_1 = {}, M = {}, seed {seed}: a particle senses one that is {:.0} degrees ahead or behind",
                formation.law.word(),
                formation.orientation,
                formation.clusters,
                apart.to_degrees()
            )));
        }
        total += flight.clusters(CLUSTER).len();
    }
    Ok(Ok(total))
}

/// paley.fig8.pos.
pub struct PatternsInZones;

/// The law, and the share of the chord angle that clusters keep apart.
#[derive(Clone, Copy)]
pub struct PatternsVariant {
    law: ZoneLaw,
    orientation: f64,
    apart: f64,
}

impl Claim for PatternsInZones {
    type Variant = PatternsVariant;

    fn id(&self) -> &str {
        "paley.fig8.pos"
    }

    fn derivation(&self) -> &str {
        "Under (29) as printed the orientation term has the gain K_1 - K_0. At K_1 = K_0 the law does not contain the orientation network at all (identity): one and the same \
         run results for M = 2, 8 and 12, with two or three clusters, and nothing can suit the size of a zone that the law does not contain; for 0 < K_1 < K_0 the term \
         even aligns. Reading: random initial states and K_1 of any size as in paley.fig8.circ; the clusters suit the zone where for M = 12 and 8 their number is within 25% of M and \
         they are at least 75% of the zone's angle 2 pi/M apart on average, and the largest zone has at most four, in more than half of the runs. (The text grants that clusters are \"not necessarily M \
         in number\".) With K_0 on the attraction network (paley.eq29) and K_1 = K_0 the runs show what the text describes: about 12, about 8 and two to three \
         clusters in most runs, nearly evenly spaced, though not at rest (`reproduce paley.fig8`)."
    }

    fn printed(&self) -> PatternsVariant {
        PatternsVariant { law: ZoneLaw::Printed, orientation: 0.1, apart: 0.75 }
    }

    fn repair(&self) -> Option<Repair<PatternsVariant>> {
        Some(Repair {
            fault: Fault::False,
            statement: "With (29) corrected (paley.eq29), K_1 = K_0 = w0 = 0.1, N = 12, the particles form 9 to 12 clusters for M = 12, 6 to 10 for M = 8 and at most \
                        four for M = 2, in most runs from random states."
                .to_string(),
            variant: PatternsVariant { law: ZoneLaw::Corrected, orientation: 0.1, apart: 0.75 },
        })
    }

    fn controls(&self) -> Vec<Control<PatternsVariant>> {
        vec![
            Control::new("K_1 < 0", PatternsVariant { law: ZoneLaw::Corrected, orientation: -0.1, apart: 0.75 }),
            Control::new(
                "farther apart than the zone reaches",
                PatternsVariant { law: ZoneLaw::Corrected, orientation: 0.1, apart: 1.5 },
            ),
        ]
    }

    fn examine(&self, variant: &PatternsVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        if variant.law == ZoneLaw::Printed && variant.orientation == SPACING {
            return no_effect_of_the_zone(run);
        }
        let seeds = run.cases(3, 20);
        for clusters in ZoneFormation::CLUSTERS {
            let formation =
                ZoneFormation { law: variant.law, spacing: SPACING, orientation: variant.orientation, clusters };
            let (mut suiting, mut last) = (Share::default(), String::new());
            for seed in 0..seeds as u64 {
                let found = fly(&formation, seed, run)?.clusters(CLUSTER);
                let (count, wanted) = (found.len() as f64, clusters as f64);
                let mean_gap = found.iter().map(|&(_, gap)| gap).sum::<f64>() / count;
                let suits = match clusters {
                    2 => count <= 4.0,
                    _ => (0.75 * wanted..=1.25 * wanted).contains(&count) && mean_gap >= variant.apart * TAU / wanted,
                };
                if !suits {
                    last =
                        format!("seed {seed}: {count} clusters, on average {:.0} degrees apart", mean_gap.to_degrees());
                }
                suiting = suiting.with(suits);
            }
            run.value(&format!("share_suiting_M_{clusters}"), suiting.enclosure());
            if 2 * suiting.found <= suiting.of {
                let what = format!(
                    "{} law, K_1 = {}, M = {clusters}: the clusters suit the zone in {} of {} runs ({last})",
                    variant.law.word(),
                    variant.orientation,
                    suiting.found,
                    suiting.of
                );
                return Ok(Outcome::fails(what, simulated("clusters", "runs", seeds)));
            }
        }
        let detail = "N = 12, w0 = K_0 = K_1 = 0.1, blind spot 60 degrees, clusters at 10 degrees, step 1 to t = 600";
        Ok(Outcome::Holds(vec![simulated("clusters that suit the zone", detail, 3 * seeds)]))
    }
}

/// (29) as printed with two orientation networks on one attraction network, at `K_1 = K_0`.
struct TwoZones {
    networks: [Neighbours; 2],
    attraction: Neighbours,
}

impl StateIdentity for TwoZones {
    fn particles(&self) -> usize {
        self.attraction.particles()
    }

    fn sides<T: Field>(&self, constants: &[T], state: &State<T>) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [omega, spacing] = constants else { return Err(ArithmeticError::Domain("two constants")) };
        let alignment = spacing.clone() - spacing;
        let control =
            |network| relative_position_control(omega, (&alignment, network), (spacing, &self.attraction), state);
        Ok((control(&self.networks[0])?, control(&self.networks[1])?))
    }
}

/// At `K_1 = K_0` the printed law is the same for all zones; how many clusters it makes then.
fn no_effect_of_the_zone(run: &mut Run) -> Result<Outcome, CheckError> {
    let identity =
        TwoZones { networks: [one_way_ring(3), Neighbours::complete(3)], attraction: Neighbours::complete(3) };
    let part = "the printed law at K_1 = K_0 with one orientation network and with another";
    let same = state_identity(&identity, &["w0", "K_0"], part, run)?;
    let Outcome::Holds(mut evidence) = same else { return Ok(same) };
    let formation = ZoneFormation { law: ZoneLaw::Printed, spacing: SPACING, orientation: SPACING, clusters: 12 };
    let clusters = fly(&formation, 0, run)?.clusters(CLUSTER).len();
    evidence.push(simulated("clusters at K_1 = K_0, any zone", "w0 = K_0 = 0.1, step 1 to t = 600", 1));
    let counterexample = format!(
        "K_1 = K_0: the factor (K_1 - K_0)/N of the orientation network is 0, so that the runs for M = 2, 8 and 12 are one and the same from every start \
         ({clusters} clusters from start 0 with w0 = K_0 = 0.1)"
    );
    Ok(Outcome::Fails { counterexample, evidence })
}
