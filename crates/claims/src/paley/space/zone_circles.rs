//! paley.fig8.circ: whether the particles of Figure 8 converge to one circle; and splay formations in zones with a blind spot.

use super::runs::{SPACING, TYPICAL, random_start, simulated};
use crate::shares::judged;
use arithmetic::{Complex, CosineField, RealCyclotomic, Ring, Signed};
use ledger::{CheckError, Evidence, Fault, Grade, Outcome, Record, Run};
use models::oscillator::{Flight, Neighbours, centre_spread, misalignment, shape_rate};
use motion::Share;
use runs::{Experiment, OMEGA, PARTICLES, ZoneFormation, ZoneLaw};

/// The gains `K_1` for which runs converge, the spacing gain, and what counts as convergence.
#[derive(Clone, Copy)]
pub struct CircularVariant {
    orientation: &'static [f64],
    spacing: f64,
    /// The rate of turning over `omega_0` for which the centres are taken.
    rate: f64,
    /// Hundreds of time units for which a run is followed unless it has converged, in ordinary and full runs.
    hundreds: (usize, usize),
    /// Runs for each zone, likewise.
    starts: (usize, usize),
}

/// `tau_0 = <i e^{i theta_0}, L_0 e^{i theta}>` at the splay phases where particle 0 senses those `steps` ahead for which `senses` says so.
fn splay_misalignment(senses: impl Fn(usize) -> bool) -> RealCyclotomic {
    let field = CosineField::new(PARTICLES as u32);
    let phasors: Vec<Complex<RealCyclotomic>> = (0..PARTICLES as i64).map(|k| field.phasor(k)).collect();
    let network = Neighbours::from_fn(PARTICLES, |k, j| senses((j + PARTICLES - k) % PARTICLES));
    misalignment(&network, &phasors)[0].clone()
}

/// Who is seen in a splay formation by the steps ahead: not the one 30 degrees behind; the one 60 degrees behind is on the edge
/// of the blind spot.
fn seen(steps: usize, edge: bool) -> bool {
    steps != PARTICLES - 1 && (steps != PARTICLES - 2 || edge)
}

/// Whether `tau_0 < 0` at the splay phases where all are sensed but those in the blind spot, for either way to decide the tie.
pub fn splay_pulls_back() -> bool {
    [false, true].into_iter().all(|edge| splay_misalignment(|steps| seen(steps, edge)).is_certainly_negative())
}

/// Whether `u_k < omega` near the splay formation for every way to decide the ties: the particle 30 degrees ahead on the boundary of the
/// zone, the one 60 degrees behind on the edge of the blind spot. `excess = (K_1 - K_0)/K_0`.
fn splay_turns_slower(excess: i64) -> bool {
    let ties = [(false, false), (false, true), (true, false), (true, true)];
    let slower = |zone: usize, (behind, ahead): (bool, bool)| {
        let oriented = splay_misalignment(|steps| match zone {
            12 => steps == 1 && ahead,
            8 => steps == 1,
            _ => seen(steps, behind),
        });
        // (N/K_0)(u - omega) in the formation, where <e^{i theta}, L^att r> = tau^att/omega.
        let turning = oriented.clone() * oriented.integer(excess) + splay_misalignment(|steps| seen(steps, behind));
        turning.is_certainly_negative()
    };
    ZoneFormation::CLUSTERS.into_iter().all(|zone| ties.into_iter().all(|tie| slower(zone, tie)))
}

/// The spread of the centres that counts as one circle, as a share of its radius.
const ONE_CIRCLE: f64 = 0.02;

pub fn circular_in_zones() -> Record<CircularVariant> {
    let printed =
        CircularVariant { orientation: &[0.5], spacing: SPACING, rate: 1.0, hundreds: (12, 60), starts: (8, 40) };
    let repaired = CircularVariant { orientation: &[-0.1, 0.1], hundreds: (24, 24), starts: (12, 200), ..printed };
    let short = CircularVariant { orientation: &[-0.1], hundreds: (6, 6), starts: (8, 8), ..printed };
    Record::new(
        "paley.fig8.circ",
        "The figure has K_1 of both signs, and the paper gives no size. Exact exceptions for every K_1 >= \
         K_0 under (29) as printed: start in r_k = e^{2 pi i k/12} r, theta_k = 2 pi k/12 + theta. The law \
         keeps the symmetry. Convergence to a circular formation of radius 1/|w0| would bring the centres \
         to 0 and u_k near w0 + ((K_1 - K_0) tau^ori + K_0 tau^att)/N at the splay phases; a particle does \
         not see the one 30 degrees behind, so tau^att <= -1/2 and tau^ori <= 0: u_k <= w0 - K_0/(2N) \
         whichever way the ties at the boundaries are decided. But with c near 0 and 1 - u/w0 >= epsilon > \
         0, (d/dt) <c, e^{i theta}> = 1 - u/w0 + small: contradiction (steps in notes/paley_particles.md, \
         Figure 8). Nor is this a matter of special starts: with K_1 = 5 K_0 no run tried from random \
         states comes to a circular formation of any radius in the time it is followed; the shape does not \
         come to rest, so that the wider sense of paley.releq, in which the common rate takes the place of \
         w0, does not help. (Runs alone would not refute that they converge later.) For K_1 = ±K_0 nearly \
         every run converges, most by t = 600, some by 2400; at K_1 = K_0 the zone has no effect \
         (paley.fig8.pos), so that its runs are counted once. Not all: a few in a thousand end in rigid \
         circular motion at another common rate (for instance K_1 = -K_0, M = 8: u_k = 0.0988 for all k, \
         one particle 40 degrees ahead of one that senses it). For K_1 = -5 K_0, -10 K_0 runs converge \
         slowly.",
        printed,
        examine_circular_in_zones,
    )
    .reading(
        "A statement about (29), from every initial state as in Theorem 2, and for every size of K_1 of \
         either sign (the paper gives none).",
    )
    .repaired(Fault::False, "", repaired)
    .repaired_clauses(&[
        "Under (29) as printed with w0 = K_0 = 0.1, N = 12, the blind spot of 60 degrees and K_1 = -K_0, in each zone \
         most runs from positions uniform in a square of half-width 10 and uniform phases come to one circle of radius \
         1/|w0| by t = 2400, the centres within 2% of it.",
        "Under (29) as printed with K_1 = K_0, where the zone has no effect, most runs from such starts do, in the same sense.",
    ])
    .repaired_reading("\"Most\": more than half of the runs, with the whole 95% interval.")
    .control("no spacing control", CircularVariant { spacing: 0.0, ..short })
    .control("a circle of half the radius", CircularVariant { rate: 2.0, ..short })
    .control("K_1 = 2 K_0", CircularVariant { orientation: &[0.2], hundreds: (12, 12), ..short })
}

fn examine_circular_in_zones(variant: &CircularVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut parts = Vec::new();
    for (clause, &orientation) in (1..).zip(variant.orientation) {
        // At K_1 = K_0 the printed law does not contain the zone: the runs for all M are the same.
        let zones = if orientation == SPACING { 1 } else { ZoneFormation::CLUSTERS.len() };
        for &clusters in &ZoneFormation::CLUSTERS[..zones] {
            let formation = ZoneFormation::new(ZoneLaw::Printed, (variant.spacing, orientation), clusters);
            match examine_zone(variant, &formation, run)?.on([clause]) {
                Outcome::Holds(more) => parts.extend(more),
                Outcome::Fails { counterexample, mut evidence } => {
                    if orientation < SPACING || ![0, 1, 4].into_iter().all(splay_turns_slower) {
                        return Ok(Outcome::Fails { counterexample, evidence });
                    }
                    let detail = "K_1 = K_0, 2 K_0, 5 K_0: near the circular formation of radius 1/w0 every u_k < w0 by exact sines, \
                     for every way to decide the ties; notes/paley_particles.md, Figure 8, steps 1-4";
                    evidence.insert(0, Evidence::new(Grade::Exact, "symmetric initial states", detail));
                    let symmetric = "from r_k = e^{2 pi i k/12} r, theta_k = 2 pi k/12 + theta no solution with K_1 >= K_0 converges to \
                     a circular formation of radius 1/w0";
                    return Ok(Outcome::Fails { counterexample: format!("{symmetric}; {counterexample}"), evidence });
                }
                other => return Ok(other),
            }
        }
    }
    Ok(Outcome::Holds(parts))
}

/// The share of runs that converge with this gain and zone, and how near the others come.
fn examine_zone(variant: &CircularVariant, formation: &ZoneFormation, run: &mut Run) -> Result<Outcome, CheckError> {
    let of = |(ordinary, many): (usize, usize)| run.cases(ordinary, many);
    let (hundreds, starts) = (of(variant.hundreds), of(variant.starts));
    let (mut converged, mut astray) = (Share::default(), Astray::default());
    for seed in 0..starts as u64 {
        run.checkpoint()?;
        let nearest = Astray::follow(formation, random_start(run, seed), (variant.rate, hundreds))?;
        converged = converged.with(nearest.is_none());
        astray = nearest.map_or(astray, |nearest| astray.nearer(nearest));
    }
    let any = formation.orientation == SPACING;
    let zone = if any { "any M".to_string() } else { format!("M = {}", formation.clusters) };
    let name = zone.replace(" = ", "_").replace(' ', "_");
    run.value(&format!("share_converged_K1_{:.2}_{name}", formation.orientation), converged.enclosure());
    let mut what = format!(
        "K_1 = {}, {zone}: the centres are within {ONE_CIRCLE} of the radius of their mean at a multiple of \
         100 up to t = {} in {converged}",
        formation.orientation,
        100 * hundreds
    );
    if converged.found < converged.of {
        what += &format!(
            "; in the others they come no nearer than {:.3}, and relative positions or phases change at a rate \
             of at least {:.1e}",
            astray.spread, astray.rate
        );
    }
    let detail = format!("(29) as printed, w0 = 0.1, K_0 = {}, step 1: {what}", variant.spacing);
    Ok(judged(converged, TYPICAL, what, simulated("one circle of radius 1/|w0|", &detail, converged.of)))
}

/// How near runs that do not converge come: the least spread of the centres over the radius and the least rate of change of the
/// shape at the times looked at.
#[derive(Clone, Copy)]
struct Astray {
    spread: f64,
    rate: f64,
}

impl Default for Astray {
    fn default() -> Self {
        Astray { spread: f64::INFINITY, rate: f64::INFINITY }
    }
}

impl Astray {
    fn nearer(self, other: Self) -> Self {
        Astray { spread: self.spread.min(other.spread), rate: self.rate.min(other.rate) }
    }

    /// Follows a run for so many hundreds of time units; `None` once it is on one circle, turning at `rate omega`.
    fn follow(
        formation: &ZoneFormation,
        start: Flight,
        (rate, hundreds): (f64, usize),
    ) -> Result<Option<Self>, CheckError> {
        let mut least = Astray::default();
        let converged = formation.until(start, (100, 100 * hundreds), |flight| {
            let state = flight.state();
            let now = Astray {
                spread: centre_spread(&(rate * OMEGA), &state)? * rate * OMEGA,
                rate: shape_rate(&state, &formation.steering(&state)?),
            };
            least = least.nearer(now);
            Ok((least.spread <= ONE_CIRCLE).then_some(()))
        })?;
        Ok(converged.is_none().then_some(least))
    }
}
