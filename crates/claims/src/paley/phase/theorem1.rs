//! paley.thm1.conv, paley.thm1.sync, paley.thm1.bal: convergence and stability.

use super::common::{all_equal, all_zero, holds, identity_of_phases, names, phasors};
use super::critical::{Kind, critical_points, linearisation, rates};
use arithmetic::identity::RationalIdentity;
use arithmetic::{ArithmeticError, Complex, Dual, Field, Ring, Sign, Signed};
use ledger::{CheckError, Claim, Control, Evidence, Grade, Outcome, Run};
use models::oscillator::{gradient_control, moment_gradient, moment_potential, rate_of_change};

/// Most particles of the arrangements at multiples of 1/12 turn.
const MOST: usize = 6;

/// paley.thm1.conv.
pub struct Convergence;

/// Where all solutions are claimed to converge to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Limit {
    /// The critical set of `U_1`.
    Critical,
    /// Arrangements of one kind.
    Only(Kind),
    /// Points at which all phases rest.
    Rest,
}

/// Along (6) with (9) `Udot_1 = -K_1 |grad U_1|^2`, and a critical point turns as a whole; variables are the phases, `K_1` and
/// `omega_0`.
struct Decrease {
    particles: usize,
}

impl RationalIdentity for Decrease {
    fn variables(&self) -> usize {
        self.particles + 2
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [t @ .., gain, omega] = at else { return Err(ArithmeticError::Domain("phases, K_1, omega_0")) };
        let z = phasors(t)?;
        let rates: Vec<T> = gradient_control(gain, &z)?.into_iter().map(|u| u + omega).collect();
        let decrease = rate_of_change(&z, &rates, |z: &[Complex<Dual<T>>]| moment_potential(z, 1))?;
        let squares = moment_gradient(&z, 1)?.iter().fold(gain.zero(), |sum, slope| sum + slope.square());
        Ok((vec![decrease], vec![-(squares * gain)]))
    }
}

impl Claim for Convergence {
    type Variant = Limit;

    fn id(&self) -> &str {
        "paley.thm1.conv"
    }

    fn derivation(&self) -> &str {
        "K_1 != 0. In the frame that turns at the rate omega_0, (6) with (9) is the gradient flow of -K_1 U_1 on a compact torus and the critical \
         set does not change. U_1 is monotone and bounded, so the integral of |grad U_1|^2 over time is finite; its derivative is bounded, so grad U_1 -> 0 \
         (Barbalat), and by compactness the distance to the critical set goes to 0: for all solutions. U_1 is analytic, so in \
         that frame each solution even converges to one point (Lojasiewicz); notes/paley_phases.md."
    }

    fn printed(&self) -> Limit {
        Limit::Critical
    }

    fn controls(&self) -> Vec<Control<Limit>> {
        vec![
            Control::new("all converge to balanced arrangements", Limit::Only(Kind::Balanced)),
            Control::new("all converge to synchronised arrangements", Limit::Only(Kind::Synchronised)),
            Control::new("all converge to rest, for any omega_0", Limit::Rest),
        ]
    }

    fn examine(&self, variant: &Limit, run: &mut Run) -> Result<Outcome, CheckError> {
        // A solution that turns as a whole is its own limit set.
        let mut cases = 0;
        for particles in 2..=MOST {
            run.checkpoint()?;
            for point in critical_points(particles) {
                let z = &point.phasors;
                let turning = rates(z, 1, 1)?;
                let critical = all_zero(&moment_gradient(z, 1)?);
                cases += 1;
                let inside = match variant {
                    Limit::Critical => critical,
                    Limit::Only(kind) => point.kind == *kind,
                    Limit::Rest => all_zero(&turning),
                };
                if all_equal(&turning) && !inside {
                    return Ok(Outcome::fails(
                        format!("N = {particles}, {}: the solution turns as a whole and stays outside", point.name),
                        Evidence::new(Grade::Exact, "limit sets", "a relative equilibrium"),
                    ));
                }
            }
        }
        let parts = (1..=3).map(|particles| {
            let part = format!("Udot_1 = -K_1 |grad U_1|^2, N = {particles}");
            identity_of_phases(run, &Decrease { particles }, &names(particles, &["K1", "omega0"]), &part)
        });
        let identities = Run::all(parts)?;
        let proof = "the argument of the derivation, for every N; proof in notes/paley_phases.md";
        let instances = "relative equilibria of each kind, 2 to 6 particles";
        Run::all([
            Ok(identities),
            holds([
                Evidence::new(Grade::Exact, "convergence of all solutions", proof),
                Evidence::new(Grade::Exact, "solutions outside the claimed limit", instances).cases(cases),
            ]),
        ])
    }
}

/// Which kind is claimed to be asymptotically stable, for which sign of the gain, and in what sense.
#[derive(Clone, Copy)]
pub struct StabilityVariant {
    gain: i64,
    stable: Kind,
    /// Each arrangement on its own modulo rotation, rather than all of them as a set.
    each: bool,
    least_particles: usize,
}

fn examine_stability(variant: &StabilityVariant, run: &Run) -> Result<Outcome, CheckError> {
    let mut cases = 0;
    for particles in variant.least_particles..=MOST {
        run.checkpoint()?;
        let points = critical_points(particles);
        let levels = points.iter().map(|point| moment_potential(&point.phasors, 1)).collect::<Result<Vec<_>, _>>()?;
        for (point, level) in points.iter().zip(&levels) {
            cases += 1;
            let around = linearisation(&point.phasors, variant.gain)?;
            let fails = |what: String| {
                let what = format!("N = {particles}, K_1 = {}, {}: {what}", variant.gain, point.name);
                Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "stability", "exact levels and linearisations")))
            };
            if !all_equal(&rates(&point.phasors, variant.gain, 1)?) {
                return fails("no relative equilibrium".to_string());
            }
            if point.kind != variant.stable {
                if around.positive == 0 {
                    return fails("the linearisation has no unstable direction".to_string());
                }
                continue;
            }
            // K_1 U_1 decreases: the lowest critical level and that one only.
            for (other, above) in points.iter().zip(&levels).filter(|(other, _)| other.kind != variant.stable) {
                let room = (above.clone() - level) * level.integer(variant.gain);
                if room.sign() != Some(Sign::Positive) {
                    return fails(format!("K_1 U_1 is not lower than at {}", other.name));
                }
            }
            // Two independent conditions p = 0 leave a manifold of dimension N - 2; rotation is one of them.
            let rank = around.positive + around.negative;
            if variant.each && particles > rank + 1 {
                return fails(format!("the critical points nearby form a manifold of dimension {}", particles - rank));
            }
        }
    }
    let proof = "K_1 U_1 is a strict Lyapunov function around the lowest critical level; indefinite Hessians elsewhere, for every N >= 2: \
                 notes/paley_phases.md";
    holds([
        Evidence::new(Grade::Exact, "stable set and unstable rest", proof),
        Evidence::new(
            Grade::Exact,
            "levels and linearisations",
            "the synchronised, all unbalanced and many balanced arrangements of 2 to 6 particles",
        )
        .cases(cases),
    ])
}

/// paley.thm1.sync.
pub struct SynchronisedStable;

impl Claim for SynchronisedStable {
    type Variant = StabilityVariant;

    fn id(&self) -> &str {
        "paley.thm1.sync"
    }

    fn derivation(&self) -> &str {
        "Equilibria are taken modulo rotation, in shape space, as the paper does: with omega_0 != 0 all phases turn at that rate. There the \
         synchronised arrangements are one point: the strict maximum of U_1, with Hessian 11^T/N - I, definite modulo rotation. (A single \
         arrangement in T^N is stable but not attractive: its rotations are as good.) At a balanced arrangement the Hessian is positive \
         semidefinite with trace 1, at an unbalanced one a minority phase has second derivative 1/N + |p| > 0: both unstable for K_1 < 0."
    }

    fn printed(&self) -> StabilityVariant {
        StabilityVariant { gain: -1, stable: Kind::Synchronised, each: true, least_particles: 2 }
    }

    fn controls(&self) -> Vec<Control<StabilityVariant>> {
        let printed = self.printed();
        vec![
            Control::new("K_1 > 0", StabilityVariant { gain: 1, ..printed }),
            Control::new("balanced arrangements for K_1 < 0", StabilityVariant { stable: Kind::Balanced, ..printed }),
            Control::new("unbalanced ones for K_1 < 0", StabilityVariant { stable: Kind::Unbalanced, ..printed }),
        ]
    }

    fn examine(&self, variant: &StabilityVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        examine_stability(variant, run)
    }
}

/// paley.thm1.bal.
pub struct BalancedStable;

impl Claim for BalancedStable {
    type Variant = StabilityVariant;

    fn id(&self) -> &str {
        "paley.thm1.bal"
    }

    fn derivation(&self) -> &str {
        "Read of the set of balanced arrangements (of \"the set of balanced circular formations\" the paper speaks later), N >= 2 and modulo \
         omega_0. U_1 >= 0 vanishes exactly there, and every other critical point has |p| >= 1/N, U_1 >= 1/(2N): below that level U_1 decreases strictly, \
         so the compact set p = 0 is asymptotically stable, also at its singular points (collinear ones). At the others two majority phases \
         can part: second derivative -2|p| along e_i - e_j, unstable. Each balanced arrangement on its own is stable (a minimum of an analytic \
         function) but for N >= 4 not attractive, even modulo rotation: the balanced ones nearby form a continuum (a control). For N = 1 nothing \
         is unstable (a control)."
    }

    fn printed(&self) -> StabilityVariant {
        StabilityVariant { gain: 1, stable: Kind::Balanced, each: false, least_particles: 2 }
    }

    fn controls(&self) -> Vec<Control<StabilityVariant>> {
        let printed = self.printed();
        vec![
            Control::new("K_1 < 0", StabilityVariant { gain: -1, ..printed }),
            Control::new("each of them on its own, modulo rotation", StabilityVariant { each: true, ..printed }),
            Control::new("one particle too", StabilityVariant { least_particles: 1, ..printed }),
            Control::new("unbalanced ones", StabilityVariant { stable: Kind::Unbalanced, ..printed }),
        ]
    }

    fn examine(&self, variant: &StabilityVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        examine_stability(variant, run)
    }
}
