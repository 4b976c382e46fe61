//! paley.Wm, paley.Um: the potentials of the moments.

use super::common::{Exact, all_equal, all_zero, at, complete, holds, identity_of_phases, laplacian, names, phasors};
use super::common::{squared_lengths, turns, up_to_rotation};
use algebra::matrix::{Inertia, SparseMatrix, inertia};
use arithmetic::identity::RationalIdentity;
use arithmetic::{ArithmeticError, CosineField, Field, Rational, Sign, Signed, rational};
use ledger::{CheckError, Claim, Control, Evidence, Fault, Grade, Outcome, Repair, Run};
use models::oscillator::{moment, moment_gradient, moment_potential, phase_jacobian, phase_potential, powers};

/// paley.Wm.
pub struct LaplacianMoments;

/// The constant in `W_m = constant - U_m`, given `N` and `m`.
type ConstantOf = fn(particles: i64, m: i64) -> Rational;

struct LaplacianMomentIdentity {
    laplacian: SparseMatrix,
    constant: ConstantOf,
    m: u32,
}

impl RationalIdentity for LaplacianMomentIdentity {
    fn variables(&self) -> usize {
        self.laplacian.order()
    }

    fn sides<T: Field>(&self, t: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let z = phasors(t)?;
        let constant = t[0].rational(&(self.constant)(z.len() as i64, i64::from(self.m)));
        Ok((vec![phase_potential(&self.laplacian, &z, self.m)?], vec![constant - moment_potential(&z, self.m)?]))
    }
}

impl Claim for LaplacianMoments {
    type Variant = ConstantOf;

    fn id(&self) -> &str {
        "paley.Wm"
    }

    fn derivation(&self) -> &str {
        "With L = N I - 1 1^T and x = e^{i m theta}/m: <x, L x> = N * N/m^2 - N^2 |p_m|^2, because (23) has its own 1/m. Divided by 2N: N/(2m^2) - U_m. The printed N/2 \
         is right for m = 1 only."
    }

    fn printed(&self) -> ConstantOf {
        |particles, _| rational(particles, 2)
    }

    fn repair(&self) -> Option<Repair<ConstantOf>> {
        Some(Repair {
            fault: Fault::Slip,
            clauses: Vec::new(),
            statement: "If G is complete, then W_m(theta) = Q_L((1/m) e^{i m theta}) = N/(2 m^2) - U_m(theta)."
                .to_string(),
            variant: |particles, m| rational(particles, 2 * m * m),
        })
    }

    fn controls(&self) -> Vec<Control<ConstantOf>> {
        vec![
            Control::new("N/(2m)", |particles, m| rational(particles, 2 * m)),
            Control::new("N/m^2", |particles, m| rational(particles, m * m)),
        ]
    }

    fn examine(&self, variant: &ConstantOf, run: &mut Run) -> Result<Outcome, CheckError> {
        let mut parts = Vec::new();
        for particles in 2..=3usize {
            for m in 1..=3 {
                let laplacian = laplacian(&complete(particles))?;
                let identity = LaplacianMomentIdentity { laplacian, constant: *variant, m };
                let part = format!("W_{m} on the complete graph, N = {particles}");
                parts.push(identity_of_phases(run, &identity, &names(particles, &[]), &part));
            }
        }
        let identities = Run::all(parts)?;
        Run::all([Ok(identities), holds([Evidence::new(Grade::Exact, "every N and m", "the derivation")])])
    }
}

/// paley.Um.
pub struct MomentPotential;

/// Where the extremes are claimed to be, and what the other stationary points are.
#[derive(Clone, Copy)]
pub struct MomentVariant {
    /// The maximum is where differences are multiples of `1/(divisor m)` of a turn.
    divisor: u32,
    /// Minimum and maximum exchanged.
    exchanged: bool,
    /// The inertia of the Hessian at the other stationary points.
    others: fn(Inertia) -> bool,
}

/// `N/(2m^2) - U_m = (1/(2N m^2)) sum of |z_k^m - z_j^m|^2` over pairs.
struct Deficit {
    particles: usize,
    m: u32,
}

impl RationalIdentity for Deficit {
    fn variables(&self) -> usize {
        self.particles
    }

    fn sides<T: Field>(&self, t: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let z = phasors(t)?;
        let (n, square) = (self.particles as i64, i64::from(self.m * self.m));
        let squares = squared_lengths(&complete(self.particles), &powers(&z, self.m), &t[0]);
        let largest = t[0].ratio(n, 2 * square);
        Ok((vec![largest - moment_potential(&z, self.m)?], vec![squares * t[0].ratio(1, 4 * n * square)]))
    }
}

impl Claim for MomentPotential {
    type Variant = MomentVariant;

    fn id(&self) -> &str {
        "paley.Um"
    }

    fn derivation(&self) -> &str {
        "U_m(theta) = U_1(m theta)/m^2, and theta -> m theta is a local diffeomorphism of the torus: all is as for U_1 (paley.thm1.saddle). At the other stationary points \
         the Hessian is s s^T/N - |q| diag(s), q = m p_m, with kernel exactly span{1}: v_k = (s.v)/(N |q|) for all k. So they are saddles and isolated modulo rotation, in \
         shape space, which is what the paper means by isolating (\"no other solutions in shape space\"); in T^N each lies on its circle of rotations (a control). \
         N >= 2: one particle never has p_m = 0."
    }

    fn printed(&self) -> MomentVariant {
        let others = |i: Inertia| i.positive > 0 && i.negative > 0 && i.zero == 1;
        MomentVariant { divisor: 1, exchanged: false, others }
    }

    fn controls(&self) -> Vec<Control<MomentVariant>> {
        let printed = self.printed();
        vec![
            Control::new("isolated in T^N", MomentVariant { others: |i| i.zero == 0, ..printed }),
            Control::new("local maxima", MomentVariant { others: |i| i.positive == 0, ..printed }),
            Control::new("maximum at multiples of pi/m", MomentVariant { divisor: 2, ..printed }),
            Control::new("minimum and maximum exchanged", MomentVariant { exchanged: true, ..printed }),
        ]
    }

    fn examine(&self, variant: &MomentVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        const PARTS: usize = 12;
        let field = CosineField::new(PARTS as u32);
        let mut cases = 0;
        for (particles, m) in [(2usize, 1u32), (2, 2), (2, 3), (3, 1), (3, 2), (3, 3)] {
            for exponents in up_to_rotation(particles, PARTS) {
                run.checkpoint()?;
                cases += 1;
                if let Some(what) = stationary_contradiction(variant, m, &at(&field, &exponents))? {
                    return Ok(Outcome::fails(
                        format!("m = {m}, {}: {what}", turns(&exponents, PARTS)),
                        Evidence::new(Grade::Exact, "stationary points of U_m", "exact values"),
                    ));
                }
            }
        }
        // Larger groups: phases at multiples of pi/m, so that m theta is on a line.
        for (particles, m) in [(4usize, 1u32), (5, 2), (6, 3), (7, 1)] {
            let field = CosineField::new(2 * m);
            for minority in 0..particles.div_ceil(2) {
                run.checkpoint()?;
                let exponents: Vec<usize> =
                    (0..particles).map(|k| 2 * (k % m as usize) + usize::from(k < minority)).collect();
                cases += 1;
                if let Some(what) = stationary_contradiction(variant, m, &at(&field, &exponents))? {
                    return Ok(Outcome::fails(
                        format!("m = {m}, {}: {what}", turns(&exponents, 2 * m as usize)),
                        Evidence::new(Grade::Exact, "stationary points of U_m", "exact values"),
                    ));
                }
            }
        }
        let identities = Run::all([(2, 2), (2, 3), (3, 1)].map(|(particles, m)| {
            let part = format!("N/(2m^2) - U_m as a sum of squares, N = {particles}, m = {m}");
            identity_of_phases(run, &Deficit { particles, m }, &names(particles, &[]), &part)
        }))?;
        let detail = "all arrangements of 2 and 3 phases at multiples of 1/12 turn, m = 1 to 3; two clusters modulo 2 pi/m for N up to 7";
        Run::all([
            Ok(identities),
            holds([
                Evidence::new(Grade::Exact, "every N >= 2 and m", "the derivation"),
                Evidence::new(Grade::Exhaustive, "extremes and saddles", detail).cases(cases),
            ]),
        ])
    }
}

/// What contradicts the claim at an arrangement.
fn stationary_contradiction(variant: &MomentVariant, m: u32, z: &Exact) -> Result<Option<String>, CheckError> {
    let value = moment_potential(z, m)?;
    let largest = value.ratio(z.len() as i64, 2 * i64::from(m * m));
    let balanced = moment(z, m)?.norm_squared().sign() == Some(Sign::Zero);
    let together = all_equal(&powers(z, m * variant.divisor));
    let (low, high) = if variant.exchanged { (together, balanced) } else { (balanced, together) };
    let above = (value.clone() - &largest).sign();
    if value.sign() == Some(Sign::Negative) || above == Some(Sign::Positive) {
        return Ok(Some("U_m is out of its range".to_string()));
    }
    if low != (value.sign() == Some(Sign::Zero)) || high != (above == Some(Sign::Zero)) {
        return Ok(Some(format!("U_m = {:?} is not where it is claimed to be extreme", value.rational_value())));
    }
    if low || high || !all_zero(&moment_gradient(z, m)?) {
        return Ok(None);
    }
    let found = inertia(&phase_jacobian(z, |z| moment_gradient(z, m))?)?;
    Ok((!(variant.others)(found)).then(|| format!("a stationary point with {found:?}")))
}
