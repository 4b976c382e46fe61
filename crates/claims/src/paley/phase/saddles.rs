//! paley.thm1.saddle, paley.unbal: the other critical points of U_1.

use super::common::{all_equal, all_zero, at, holds, on_the_line, turns, up_to_rotation};
use super::critical::{Kind, linearisation, rates};
use algebra::matrix::{Inertia, inertia};
use arithmetic::{Complex, CosineField, Field, Ring, Signed, rational};
use ledger::{CheckError, Claim, Control, Evidence, Grade, Outcome, Run};
use models::oscillator::{moment, moment_gradient, phase_jacobian, sine_of_difference};

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
