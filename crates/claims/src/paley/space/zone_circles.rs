//! paley.fig8.circ and beyond.paley.fig8.circ: whether the particles of Figure 8 converge to one circle; and splay formations in zones with a blind spot.

use super::runs::{SPACING, TYPICAL, random_start, simulated};
use crate::prelude::*;
use crate::shares::{Seen, judged, report};
use arithmetic::{CosineField, RealCyclotomic, Signed};
use models::oscillator::{Flight, Neighbours, centre_spread, misalignment, shape_rate};
use motion::Share;
use runs::{Experiment, OMEGA, PARTICLES, ZoneFormation, ZoneLaw};

/// A gain `K_1` and its runs in each zone.
#[derive(Clone, Copy)]
struct Trial {
    orientation: f64,
    /// Hundreds of time units for which a run is followed unless it has converged, in ordinary and full runs.
    hundreds: (usize, usize),
    /// Runs for each zone, likewise.
    starts: (usize, usize),
}

/// The gains that are tried, the spacing gain, what counts as convergence, and where no symmetric motion is said to converge.
#[derive(Clone, Copy)]
pub struct CircularVariant {
    trials: &'static [Trial],
    spacing: f64,
    /// The rate of turning over `omega_0` for which the centres are taken.
    rate: f64,
    /// Some `(K_1 - K_0)/K_0`.
    excesses: &'static [i64],
}

/// At `K_1 = -K_0` most runs have converged by then.
const SHORT: Trial = Trial { orientation: -SPACING, hundreds: (6, 6), starts: (8, 40) };

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
    const LARGE: Trial = Trial { orientation: 5.0 * SPACING, hundreds: (12, 60), ..SHORT };
    Record::new(
        "paley.fig8.circ",
        "The figure has K_1 of both signs, and the paper gives no size. For K_1 = ±K_0 nearly \
         every run comes to one circle, most by t = 600, some by 2400; at K_1 = K_0 the zone has no effect \
         (paley.fig8.pos). Not all: a few in a thousand end in rigid circular \
         motion at another common rate (for instance K_1 = -K_0, M = 8: u_k = 0.0988 for all k, \
         one particle 40 degrees ahead of one that senses it). For K_1 = -5 K_0, -10 K_0 runs converge \
         slowly. With K_1 = 5 K_0 no run tried \
         comes to a circular formation of any radius in the time it is followed; the shape does not \
         come to rest, so that the wider sense of paley.releq, in which the common rate takes the place of \
         w0, does not help. That they converge later is not excluded. From symmetric starts no motion with K_1 >= K_0 converges \
         (beyond.paley.fig8.circ): as a statement about every start it would be false.",
        CircularVariant { trials: &[SHORT, LARGE], spacing: SPACING, rate: 1.0, excesses: &[] },
        |variant, run| Ok(report(shares(variant, run)?.into_iter().map(|(_, seen)| seen).collect(), false)),
    )
    .reading(
        "A report of runs (\"in our simulations\", two sentences later) with (29) as printed: typical, more than half of the runs from \
         random states in each zone, for every size and sign of K_1, since the paper gives none (notes/guarantees.md).",
    )
    .altered("no spacing control", |v| (v.trials, v.spacing) = (&[SHORT], 0.0))
    .altered("K_1 = 5 K_0 only", |v| v.trials = &[LARGE])
}

pub fn circles_and_symmetric_starts() -> Record<CircularVariant> {
    const LONG: Trial = Trial { orientation: -SPACING, hundreds: (24, 24), starts: (12, 200) };
    const TRIALS: &[Trial] = &[LONG, Trial { orientation: SPACING, ..LONG }];
    Record::new(
        "beyond.paley.fig8.circ",
        "Start in r_k = e^{2 pi i k/12} r, theta_k = 2 pi k/12 + theta. The law \
         keeps the symmetry. Convergence to a circular formation of radius 1/|w0| would bring the centres \
         to 0 and u_k near w0 + ((K_1 - K_0) tau^ori + K_0 tau^att)/N at the splay phases; a particle does \
         not see the one 30 degrees behind, so tau^att <= -1/2 and tau^ori <= 0: u_k <= w0 - K_0/(2N) \
         whichever way the ties at the boundaries are decided. But with c near 0 and 1 - u/w0 >= epsilon > \
         0, (d/dt) <c, e^{i theta}> = 1 - u/w0 + small: contradiction.",
        CircularVariant { trials: TRIALS, spacing: SPACING, rate: 1.0, excesses: &[0, 1, 4] },
        examine_circles,
    )
    .stated("beyond the text on Figure 8", "")
    .clauses(&[
        "Under (29) as printed with w0 = K_0 = 0.1, N = 12, the blind spot of 60 degrees and K_1 = -K_0, in each zone most runs (a share \
         whose whole 95% interval lies above one half) from positions uniform in a square of half-width 10 and uniform phases come to one \
         circle of radius 1/|w0| by t = 2400, the centres within 2% of it.",
        "Under (29) as printed with K_1 = K_0, where the zone has no effect, most runs from such starts do, in the same sense.",
        "With the same w0, K_0, N and blind spot and K_1 >= K_0 no motion r_k = e^{2 pi i k/12} r(t), theta_k = 2 pi k/12 + theta(t) under \
         (29) as printed, for any of the zones, converges to a circular formation of radius 1/w0.",
    ])
    .altered("no spacing control", |v| (v.trials, v.spacing) = (&[SHORT], 0.0))
    .altered("a circle of half the radius", |v| {
        (v.trials, v.rate) = (&[SHORT, Trial { orientation: SPACING, ..SHORT }], 2.0);
    })
    .altered("K_1 = 2 K_0", |v| {
        v.trials = &[Trial { orientation: 2.0 * SPACING, hundreds: (12, 12), ..SHORT }];
    })
    .altered("no symmetric motion with K_1 = -K_0 either", |v| v.excesses = &[-2])
}

/// The shares of runs that converge, gain by gain and zone by zone, with the place of the gain.
fn shares(variant: &CircularVariant, run: &mut Run) -> Result<Vec<(usize, Seen)>, CheckError> {
    let mut seen = Vec::new();
    for (place, trial) in (1..).zip(variant.trials) {
        // At K_1 = K_0 the printed law does not contain the zone: the runs for all M are the same.
        let zones = if trial.orientation == SPACING { 1 } else { ZoneFormation::CLUSTERS.len() };
        for &clusters in &ZoneFormation::CLUSTERS[..zones] {
            let formation = ZoneFormation::new(ZoneLaw::Printed, (variant.spacing, trial.orientation), clusters);
            seen.push((place, examine_zone(variant, (trial, place), &formation, run)?));
        }
    }
    Ok(seen)
}

fn examine_circles(variant: &CircularVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let detail = "K_1 = K_0, 2 K_0, 5 K_0: near the circular formation of radius 1/w0 every u_k < w0 by exact sines, \
         for every way to decide the ties";
    let faster = variant.excesses.iter().find(|&&excess| !splay_turns_slower(excess));
    let what = faster.map(|excess| {
        format!("K_1 = {} K_0: near the circular formation u_k >= w0 for some way to decide the ties", excess + 1)
    });
    let symmetric = unless(what, exact("symmetric motions", detail).on([3])).checks("the sign in step 3");
    // What exact sines refute needs no runs.
    if let Ok(Outcome::Fails { .. }) = symmetric {
        return symmetric;
    }
    let circles = shares(variant, run)?.into_iter().map(|(clause, Seen { part, what, share })| {
        let detail = format!("(29) as printed, w0 = 0.1, K_0 = {}, step 1: {what}", variant.spacing);
        Ok(judged(share, TYPICAL, what, simulated(&part, &detail, share.of).on([clause])))
    });
    let proof = argued(&[3], "every K_1 >= K_0", "notes/paley_particles.md, Figure 8, steps 1 to 4");
    Run::all([symmetric, proof].into_iter().chain(circles))
}

/// The share of runs that converge with this gain and zone, and how near the others come.
fn examine_zone(
    variant: &CircularVariant,
    (trial, place): (&Trial, usize),
    formation: &ZoneFormation,
    run: &mut Run,
) -> Result<Seen, CheckError> {
    let of = |(ordinary, many): (usize, usize)| run.cases(ordinary, many);
    let (hundreds, starts) = (of(trial.hundreds), of(trial.starts));
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
    let part = format!("one circle of radius 1/|w0|, gain {place}, {zone}");
    Ok(Seen { part, what, share: converged })
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
