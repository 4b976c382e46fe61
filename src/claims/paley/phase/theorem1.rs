//! paley.thm1.conv, paley.thm1.sync, paley.thm1.bal, paley.thm1.saddle, paley.unbal: the critical points of U_1 and their stability.

use super::common::{Exact, all_equal, all_zero, at, holds, identity_of_phases, names, on_the_line, phasors};
use super::common::{turns, up_to_rotation};
use crate::arithmetic::identity::RationalIdentity;
use crate::arithmetic::{ArithmeticError, Complex, CosineField, Dual, Field, Ring, Sign, Signed, rational};
use crate::ledger::{CheckError, Claim, Control, Evidence, Grade, Outcome, Run};
use crate::matrix::{Inertia, inertia};
use crate::oscillator::{
    gradient_control, moment, moment_gradient, moment_potential, phase_jacobian, rate_of_change, sine_of_difference,
};

/// Most particles of the arrangements at multiples of 1/12 turn.
const MOST: usize = 6;

/// The kinds of critical points of `U_1`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Equal phases.
    Synchronised,
    /// `p = 0`.
    Balanced,
    /// Two clusters of different sizes on opposite sides.
    Unbalanced,
}

/// A critical point.
pub struct Critical {
    /// Which kind.
    pub kind: Kind,
    /// What it looks like.
    pub name: String,
    /// Its phasors.
    pub phasors: Exact,
}

/// The synchronised arrangement, all unbalanced ones, and balanced ones made of triangles and antipodal pairs at different angles,
/// one of each shape modulo rotation.
pub fn critical_points(particles: usize) -> Vec<Critical> {
    let field = CosineField::new(12);
    let line = |minority: usize| {
        let exponents: Vec<usize> = (0..particles).map(|k| if k + minority < particles { 0 } else { 6 }).collect();
        let kind = if minority == 0 { Kind::Synchronised } else { Kind::Unbalanced };
        let name = format!("{} phases opposite to {}", minority, particles - minority);
        Critical { kind, name, phasors: at(&field, &exponents) }
    };
    let mut points: Vec<Critical> = (0..particles.div_ceil(2)).map(line).collect();
    for triangles in 0..=particles / 3 {
        let rest = particles - 3 * triangles;
        if !rest.is_multiple_of(2) {
            continue;
        }
        for step in if rest > 2 || (triangles > 0 && rest > 0) { 0..3 } else { 0..1 } {
            let mut exponents = [0, 4, 8].repeat(triangles);
            exponents.extend((0..rest / 2).flat_map(|pair| [pair * step, pair * step + 6]));
            let name = format!("balanced, {}", turns(&exponents, 12));
            points.push(Critical { kind: Kind::Balanced, name, phasors: at(&field, &exponents) });
        }
    }
    points
}

/// The inertia of the linearisation of (6) with (9) for a gain.
fn linearisation<T: Field + Signed>(z: &[Complex<T>], gain: i64) -> Result<Inertia, CheckError> {
    let jacobian = phase_jacobian(z, |z| gradient_control(&z[0].re.integer(gain), z))?;
    Ok(inertia(&jacobian)?)
}

/// The rates of (6) with (9).
fn rates<T: Field>(z: &[Complex<T>], gain: i64, omega: i64) -> Result<Vec<T>, CheckError> {
    let control = gradient_control(&z[0].re.integer(gain), z)?;
    Ok(control.into_iter().map(|u| u + z[0].re.integer(omega)).collect())
}

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
        let parts = (1..=4).map(|particles| {
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

/// paley.thm1.saddle.
pub struct Saddles;

/// Which critical points are claimed to be what.
#[derive(Clone, Copy)]
pub struct SaddleVariant {
    /// Kinds to which the statement applies.
    applies: fn(Kind) -> bool,
    /// What the inertia of the Hessian must be.
    shape: fn(Inertia) -> bool,
    /// Whether `omega_0` is left out of the equilibria.
    at_rest: bool,
}

impl Claim for Saddles {
    type Variant = SaddleVariant;

    fn id(&self) -> &str {
        "paley.thm1.saddle"
    }

    fn derivation(&self) -> &str {
        "<i z_k, p> = 0 with p != 0 says z_k = ±p/|p|: all phases on a line, sin theta_kj = 0, so the control vanishes and all phases turn at \
         omega_0 (equilibria modulo rotation). Not synchronised and p != 0: a minority and a larger majority of at least two. The Hessian \
         s s^T/N - |p| diag(s) is 1/N + |p| > 0 at a minority phase and -2|p| < 0 along e_i - e_j of two majority phases. N = 1 and 2 have no \
         such points."
    }

    fn printed(&self) -> SaddleVariant {
        let shape = |i: Inertia| i.positive > 0 && i.negative > 0;
        SaddleVariant { applies: |kind| kind == Kind::Unbalanced, shape, at_rest: false }
    }

    fn controls(&self) -> Vec<Control<SaddleVariant>> {
        let printed = self.printed();
        vec![
            Control::new("balanced ones too", SaddleVariant { applies: |kind| kind != Kind::Synchronised, ..printed }),
            Control::new("synchronised ones too", SaddleVariant { applies: |kind| kind != Kind::Balanced, ..printed }),
            Control::new("local maxima", SaddleVariant { shape: |i| i.positive == 0, ..printed }),
            Control::new("at rest for any omega_0", SaddleVariant { at_rest: true, ..printed }),
        ]
    }

    fn examine(&self, variant: &SaddleVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        const MOST_ON_A_LINE: usize = 10;
        let mut cases = 0;
        for particles in 2..=MOST_ON_A_LINE {
            run.checkpoint()?;
            for minority in 0..particles.div_ceil(2) {
                let kind = if minority == 0 { Kind::Synchronised } else { Kind::Unbalanced };
                cases += 1;
                if let Some(what) = not_as_claimed(variant, kind, &on_the_line(particles, minority))? {
                    let what = format!("N = {particles}, {minority} phases opposite to the others: {what}");
                    return Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "saddles", "exact inertia")));
                }
            }
        }
        let mut arrangements = 0;
        for (particles, parts) in [(2, 12), (3, 12), (4, 6)] {
            let field = CosineField::new(parts as u32);
            for exponents in up_to_rotation(particles, parts) {
                run.checkpoint()?;
                let z = at(&field, &exponents);
                arrangements += 1;
                if !all_zero(&moment_gradient(&z, 1)?) {
                    continue;
                }
                let p = moment(&z, 1)?;
                let kind = match (all_equal(&z), p == p.zero()) {
                    (true, _) => Kind::Synchronised,
                    (_, true) => Kind::Balanced,
                    _ => Kind::Unbalanced,
                };
                if let Some(what) = not_as_claimed(variant, kind, &z)? {
                    let what = format!("N = {particles}, {}: {what}", turns(&exponents, parts));
                    return Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "saddles", "exact inertia")));
                }
            }
        }
        holds([
            Evidence::new(
                Grade::Exact,
                "indefinite Hessians, relative equilibria",
                "all of 2 to 10 particles; for every N by the derivation",
            )
            .cases(cases),
            Evidence::new(
                Grade::Exhaustive,
                "no other critical points",
                "all arrangements of 2 and 3 phases at multiples of 1/12 turn and of 4 at multiples of 1/6",
            )
            .cases(arrangements),
        ])
    }
}

/// What contradicts the claim at a critical point.
fn not_as_claimed<T: Field + Signed + PartialEq>(
    variant: &SaddleVariant,
    kind: Kind,
    z: &[Complex<T>],
) -> Result<Option<String>, CheckError> {
    if !(variant.applies)(kind) {
        return Ok(None);
    }
    let pairs = z.iter().flat_map(|a| z.iter().map(move |b| sine_of_difference(a, b)));
    if !all_zero(&pairs.collect::<Vec<_>>()) {
        return Ok(Some("some sin theta_kj is not zero".to_string()));
    }
    let rates = rates(z, 1, 1)?;
    if !all_equal(&rates) || (variant.at_rest && !all_zero(&rates)) {
        return Ok(Some("no equilibrium of (6), omega_0 = 1".to_string()));
    }
    let shape = inertia(&phase_jacobian(z, |z| moment_gradient(z, 1))?)?;
    Ok((!(variant.shape)(shape)).then(|| format!("{shape:?}")))
}

/// paley.unbal.
pub struct Unbalanced;

/// The `M` of `N` for which the statement is made, and the gains for which it says unstable.
#[derive(Clone, Copy)]
pub struct UnbalancedVariant {
    applies: fn(m: usize, n: usize) -> bool,
    unstable: bool,
}

impl Claim for Unbalanced {
    type Variant = UnbalancedVariant;

    fn id(&self) -> &str {
        "paley.unbal"
    }

    fn derivation(&self) -> &str {
        "The sentence gives an example of the critical points \"other than the synchronised and balanced\", so 1 <= M < N and M != N/2: M = N/2 \
         is balanced, two equal clusters, stable for K_1 > 0, and M = 0 is synchronised, stable for K_1 < 0 (controls). The Hessian of U_1 is indefinite \
         there (paley.thm1.saddle), so the linearisation has an unstable direction for either sign of K_1; equilibria modulo rotation."
    }

    fn printed(&self) -> UnbalancedVariant {
        UnbalancedVariant { applies: |m, n| m >= 1 && 2 * m != n, unstable: true }
    }

    fn controls(&self) -> Vec<Control<UnbalancedVariant>> {
        vec![
            Control::new("M = N/2 too", UnbalancedVariant { applies: |m, _| m >= 1, unstable: true }),
            Control::new("M = 0 too", UnbalancedVariant { applies: |m, n| 2 * m != n, unstable: true }),
            Control::new("stable for one sign", UnbalancedVariant { unstable: false, ..self.printed() }),
        ]
    }

    fn examine(&self, variant: &UnbalancedVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        const MOST_ON_A_LINE: usize = 9;
        let mut cases = 0;
        for n in 2..=MOST_ON_A_LINE {
            run.checkpoint()?;
            for m in (0..n).filter(|&m| (variant.applies)(m, n)) {
                let z = on_the_line(n, n - m);
                cases += 1;
                let fails = |what: &str| {
                    let what = format!("N = {n}, M = {m}: {what}");
                    Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "two clusters", "exact linearisation")))
                };
                let (decreasing, increasing) = (linearisation(&z, 1)?, linearisation(&z, -1)?);
                let unstable = decreasing.positive > 0 && increasing.positive > 0;
                if !all_equal(&rates(&z, 1, 0)?) {
                    return fails("no relative equilibrium");
                }
                if unstable != variant.unstable {
                    return fails(if unstable {
                        "unstable for both signs of K_1"
                    } else {
                        "stable for one sign of K_1"
                    });
                }
                let first = z.iter().filter(|z| **z == Complex::real(rational(1, 1))).count();
                if first == n - first || first == 0 || first == n {
                    return fails("not two clusters of different sizes");
                }
            }
        }
        holds([Evidence::new(
            Grade::Exact,
            "unstable equilibria of two unequal clusters",
            "the exact linearisation for both signs of K_1, all M for N up to 9; for every N by paley.thm1.saddle",
        )
        .cases(cases)])
    }
}
