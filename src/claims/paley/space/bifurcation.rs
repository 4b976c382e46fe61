//! paley.fig8.circ, paley.fig8.neg, paley.fig8.pos: the bifurcation in the size of the orientation zone.

use super::runs::{CLUSTER, DECLARATION, centre_spread, random_start};
use crate::arithmetic::{ArithmeticError, Complex, CosineField, RealCyclotomic, Ring, Signed, rational};
use crate::ledger::{CheckError, Claim, Control, Evidence, Fault, Grade, Outcome, Repair, Run};
use crate::oscillator::{
    CircularGains, Flight, Neighbours, State, Zone, Zones, circular_control, misalignment, relative_position_control,
};
use std::f64::consts::{PI, TAU};

const N: usize = 12;
const OMEGA: f64 = 0.1;
/// The steps of every run: to t = 600.
const STEPS: (f64, usize) = (1.0, 600);
/// The numbers of clusters that name the zones, from the smallest zone to the largest.
const ZONES: [usize; 3] = [12, 8, 2];

/// (29) as printed, or with `K_0` on the attraction network (paley.eq29).
#[derive(Clone, Copy, PartialEq, Eq)]
enum Law {
    Printed,
    Corrected,
}

/// The steering in the zones of radius `2 sin(pi/M)/|omega|` and everywhere, with a blind spot of 60 degrees.
fn steering(
    law: Law,
    spacing: f64,
    orientation: f64,
    zone: usize,
    state: &State<f64>,
) -> Result<Vec<f64>, ArithmeticError> {
    // Zones have no inner radius: the zone of repulsion reaches out to 0 and that of attraction starts there. The clusters of a
    // pattern lie on the boundary of the zone: a margin for rounding counts them in.
    let radius = 2.0 * (PI / zone as f64).sin() / OMEGA.abs() * (1.0 + 1e-9);
    let zones =
        |outer: f64| Zones { repulsion: 0.0, orientation: outer, attraction: outer, blind_cosine_squared: 0.75 };
    let own = zones(radius).network(Zone::Orientation, state);
    let all = zones(1e9).network(Zone::Orientation, state);
    match law {
        Law::Printed => relative_position_control(&OMEGA, (&(orientation - spacing), &own), (&spacing, &all), state),
        Law::Corrected => circular_control(&CircularGains { omega: OMEGA, spacing, orientation }, &own, &all, state),
    }
}

fn fly(law: Law, spacing: f64, orientation: f64, zone: usize, seed: u64, run: &Run) -> Result<Flight, CheckError> {
    run.checkpoint()?;
    let mut flight = random_start(run, seed, N);
    flight.advance(STEPS, &Complex::new(0.0, 0.0), |state| steering(law, spacing, orientation, zone, state))?;
    Ok(flight)
}

fn simulated(part: &str, detail: String, cases: usize) -> Evidence {
    Evidence::new(Grade::Simulated, part, format!("{detail}; {DECLARATION}")).cases(cases)
}

/// paley.fig8.circ.
pub struct CircularInZones;

/// From every initial state and for gains of both signs, or from random ones for `K_1 = -K_0`; the spacing gain; the spread that
/// counts as one circle, as a share of its radius.
#[derive(Clone, Copy)]
pub struct CircularVariant {
    every_state: bool,
    spacing: f64,
    spread: f64,
}

/// Whether `u_k < omega` near the splay formation for every way to decide the ties: the particle 30 degrees ahead on the boundary of the
/// zone, the one 60 degrees behind on the edge of the blind spot. `excess = (K_1 - K_0)/K_0`.
fn splay_turns_slower(excess: i64) -> bool {
    let field = CosineField::new(N as u32);
    let phasors: Vec<Complex<RealCyclotomic>> = (0..N as i64).map(|k| field.phasor(k)).collect();
    // Particle 0 senses the one `steps` ahead; those behind by less than 60 degrees are blind.
    let tau = |senses: &dyn Fn(usize) -> bool| {
        let network = Neighbours::from_fn(N, |k, j| senses((j + N - k) % N));
        misalignment(&network, &phasors)[0].clone()
    };
    let mut slower = true;
    for behind_seen in [false, true] {
        let seen = |steps: usize| steps != N - 1 && (steps != N - 2 || behind_seen);
        let attracted = tau(&seen);
        for zone in ZONES {
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
        "Circular formation as in Theorem 2: c = c_0 1 with the centres (3), radius 1/|w0|. (In paley.releq the common rate takes the place of w0; in that wider sense some \
         of the states below are circular formations, of another radius.) Under (29) with the blind spot, N = 12: start in any state with the symmetry r_k = e^{2 pi i k/12} r, theta_k = 2 pi k/12 + theta. The law keeps the \
         symmetry. Convergence to a circular formation of radius 1/|w0| would bring the centres to 0 and u_k near w0 + ((K_1 - K_0) tau^ori + K_0 \
         tau^att)/N at the splay phases; a particle does not see the one 30 degrees behind, so tau^att <= -1/2 and tau^ori <= 0: u_k <= w0 - K_0/(2N) for K_1 >= \
         K_0 whichever way the ties at the boundaries fall. But with c near 0 and 1 - u/w0 >= epsilon > 0, (d/dt) <c, e^{i theta}> = 1 - u/w0 + small: \
         contradiction. For K_1 = 2 K_0 random states do not converge either (the centres stay 5 to 20% of the radius apart). For K_1 = -K_0 every \
         run from a random state converges. The size of K_1 is not in the paper."
    }

    fn printed(&self) -> CircularVariant {
        CircularVariant { every_state: true, spacing: 0.1, spread: 0.02 }
    }

    fn repair(&self) -> Option<Repair<CircularVariant>> {
        Some(Repair {
            fault: Fault::False,
            statement: "Under (29) with w0 = K_0 = 0.1, K_1 = -K_0, N = 12 and the blind spot of 60 degrees, runs from random initial states converge \
                        to a circular formation of radius 1/|w0| (not from every state, and not for K_1 >= K_0)."
                .to_string(),
            variant: CircularVariant { every_state: false, spacing: 0.1, spread: 0.02 },
        })
    }

    fn controls(&self) -> Vec<Control<CircularVariant>> {
        vec![
            Control::new("no spacing control", CircularVariant { every_state: false, spacing: 0.0, spread: 0.02 }),
            Control::new(
                "exactly on one circle at t = 600",
                CircularVariant { every_state: false, spacing: 0.1, spread: 1e-9 },
            ),
        ]
    }

    fn examine(&self, variant: &CircularVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        if variant.every_state && [0, 1, 4].into_iter().all(splay_turns_slower) {
            let what = "N = 12, r_k = e^{2 pi i k/12} r, theta_k = 2 pi k/12 + theta, K_1 >= K_0 (tested: K_0, 2 K_0, 5 K_0): near the circular formation of radius 1/w0 every u_k < w0";
            return Ok(Outcome::fails(
                what,
                Evidence::new(Grade::Exact, "symmetric initial states", "exact sines, every way to decide the ties"),
            ));
        }
        let seeds = run.cases(2, 20);
        for zone in ZONES {
            for seed in 0..seeds as u64 {
                let flight = fly(Law::Printed, variant.spacing, -0.1, zone, seed, run)?;
                let spread = centre_spread(OMEGA, &flight) * OMEGA;
                if spread > variant.spread {
                    let what =
                        format!("M = {zone}, seed {seed}, t = 600: the centres are {spread:.4} of the radius apart");
                    return Ok(Outcome::fails(what, simulated("one circle", "a run".to_string(), 1)));
                }
            }
        }
        let detail = "(29) as printed, w0 = K_0 = 0.1, K_1 = -0.1, zones M = 2, 8, 12, step 1 to t = 600; centres within 2% of the radius";
        Ok(Outcome::Holds(vec![simulated("circular formation", detail.to_string(), 3 * seeds)]))
    }
}

/// paley.fig8.neg.
pub struct FewerClusters;

/// Zones from the smallest to the largest, and the sign of `K_1`.
#[derive(Clone, Copy)]
pub struct FewerVariant {
    orientation: f64,
    growing: bool,
}

impl Claim for FewerClusters {
    type Variant = FewerVariant;

    fn id(&self) -> &str {
        "paley.fig8.neg"
    }

    fn derivation(&self) -> &str {
        "Readings: particles \"in overlapping orientation zones\" are those of which one senses the other in its zone (zones of clusters a chord apart overlap as \
         discs in Figure 8(b) too, so that cannot be meant); they end within 10 degrees of each other. K_1 = -0.1, N = 12 and random initial states are chosen here (from symmetric states particles can stay in each other's zones for ever, apart); runs with \
         the printed (29) and with the corrected one. Over the same random starts the number of clusters does not increase with the zone, from the smallest \
         zone to a single cluster in the largest (values: mean numbers, M = 12, 8, 2; with the printed law M = 12 and 8 hardly differ)."
    }

    fn printed(&self) -> FewerVariant {
        FewerVariant { orientation: -0.1, growing: true }
    }

    fn controls(&self) -> Vec<Control<FewerVariant>> {
        vec![
            Control::new("K_1 > 0", FewerVariant { orientation: 0.1, growing: true }),
            Control::new("more clusters in larger zones", FewerVariant { orientation: -0.1, growing: false }),
        ]
    }

    fn examine(&self, variant: &FewerVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let seeds = run.cases(2, 40);
        for (law, name) in [(Law::Printed, "printed"), (Law::Corrected, "corrected")] {
            let mut totals = Vec::new();
            for zone in ZONES {
                let mut total = 0;
                for seed in 0..seeds as u64 {
                    let flight = fly(law, 0.1, variant.orientation, zone, seed, run)?;
                    if let Some(angle) = sensed_but_apart(zone, &flight) {
                        let what = format!(
                            "{name} (29), M = {zone}, seed {seed}: a particle senses one that is {angle:.0} degrees ahead or behind"
                        );
                        return Ok(Outcome::fails(what, simulated("synchronised clusters", "a run".to_string(), 1)));
                    }
                    total += flight.clusters(CLUSTER).len();
                }
                run.value(&format!("mean_clusters_{name}_M_{zone}"), format!("~{:.2}", total as f64 / seeds as f64));
                totals.push(total);
            }
            let fewer = totals.windows(2).all(|pair| pair[1] <= pair[0]) && totals[2] < totals[0] && totals[2] == seeds;
            if fewer != variant.growing {
                let what = format!("{name} (29): {totals:?} clusters in {seeds} runs for M = {ZONES:?}");
                return Ok(Outcome::fails(what, simulated("number of clusters", "runs".to_string(), 3 * seeds)));
            }
        }
        let detail =
            "printed and corrected (29), N = 12, w0 = K_0 = 0.1, K_1 = -0.1, blind spot 60 degrees, step 1 to t = 600";
        Ok(Outcome::Holds(vec![simulated("fewer, larger, synchronised clusters", detail.to_string(), 6 * seeds)]))
    }
}

/// The largest angle in degrees, 10 or more, between particles of which one senses the other in its orientation zone.
fn sensed_but_apart(zone: usize, flight: &Flight) -> Option<f64> {
    let radius = 2.0 * (PI / zone as f64).sin() / OMEGA;
    let zones = Zones { repulsion: 0.0, orientation: radius, attraction: radius, blind_cosine_squared: 0.75 };
    let network = zones.network(Zone::Orientation, &flight.state());
    let pairs = (0..N).flat_map(|k| network.of_particle(k).iter().map(move |&j| (k, j)));
    let apart = |(k, j): (usize, usize)| ((flight.phases[k] - flight.phases[j] + PI).rem_euclid(TAU) - PI).abs();
    pairs.map(apart).filter(|&angle| angle >= CLUSTER).map(f64::to_degrees).reduce(f64::max)
}

/// paley.fig8.pos.
pub struct PatternsInZones;

/// The law, and the share of the chord angle that clusters keep apart.
#[derive(Clone, Copy)]
pub struct PatternsVariant {
    law: Law,
    orientation: f64,
    apart: f64,
}

impl Claim for PatternsInZones {
    type Variant = PatternsVariant;

    fn id(&self) -> &str {
        "paley.fig8.pos"
    }

    fn derivation(&self) -> &str {
        "Reading: for every K_1 > 0 (no size is given) the clusters suit the zone: for M = 12 and 8 their number is within 25% of M, at least 75% of the zone's \
         angle 2 pi/M apart on average, and the largest zone has at most four. Under (29) as printed the orientation term has the gain K_1 - K_0: at K_1 = K_0 the law does not contain the orientation \
         zone at all, so one and the same run results for all M (two or three clusters), and below it aligns. (The text grants that clusters are \"not necessarily M in number\"; but nothing can suit the size of a zone that the law does not contain.) With K_0 on the attraction network (paley.eq29) the runs show what the text describes: \
         about 12, about 8 and two to three clusters, nearly evenly spaced."
    }

    fn printed(&self) -> PatternsVariant {
        PatternsVariant { law: Law::Printed, orientation: 0.1, apart: 0.75 }
    }

    fn repair(&self) -> Option<Repair<PatternsVariant>> {
        Some(Repair {
            fault: Fault::False,
            statement: "With (29) corrected (paley.eq29), K_1 = K_0 = w0 = 0.1, N = 12, the particles form 9 to 12 clusters for M = 12, 6 to 10 for M = 8 and at most \
                        four for M = 2, in runs from random states."
                .to_string(),
            variant: PatternsVariant { law: Law::Corrected, orientation: 0.1, apart: 0.75 },
        })
    }

    fn controls(&self) -> Vec<Control<PatternsVariant>> {
        vec![
            Control::new("K_1 < 0", PatternsVariant { law: Law::Corrected, orientation: -0.1, apart: 0.75 }),
            Control::new(
                "farther apart than the zone reaches",
                PatternsVariant { law: Law::Corrected, orientation: 0.1, apart: 1.5 },
            ),
        ]
    }

    fn examine(&self, variant: &PatternsVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let seeds = run.cases(2, 20);
        for zone in ZONES {
            for seed in 0..seeds as u64 {
                let flight = fly(variant.law, 0.1, variant.orientation, zone, seed, run)?;
                let clusters = flight.clusters(CLUSTER);
                let (count, wanted) = (clusters.len() as f64, zone as f64);
                let mean_gap = clusters.iter().map(|&(_, gap)| gap).sum::<f64>() / count;
                let suits = match zone {
                    2 => count <= 4.0,
                    _ => (0.75 * wanted..=1.25 * wanted).contains(&count) && mean_gap >= variant.apart * TAU / wanted,
                };
                if !suits {
                    let what = format!(
                        "{:?} law, K_1 = {}, M = {zone}, seed {seed}: {count} clusters, on average {:.0} degrees apart",
                        if variant.law == Law::Printed { "printed" } else { "corrected" },
                        variant.orientation,
                        mean_gap.to_degrees()
                    );
                    let mut evidence = vec![simulated("clusters", "a run".to_string(), 1)];
                    if variant.law == Law::Printed && variant.orientation == 0.1 {
                        let exact = rational(1, 10) - rational(1, 10);
                        let detail =
                            format!("at K_1 = K_0 = 1/10 the factor of the orientation network in (29) is {exact}");
                        evidence.push(Evidence::new(Grade::Exact, "no effect of the zone", detail));
                    }
                    return Ok(Outcome::Fails { counterexample: what, evidence });
                }
            }
        }
        let detail = "N = 12, w0 = K_0 = K_1 = 0.1, blind spot 60 degrees, clusters at 10 degrees, step 1 to t = 600";
        Ok(Outcome::Holds(vec![simulated("clusters that suit the zone", detail.to_string(), 3 * seeds)]))
    }
}
