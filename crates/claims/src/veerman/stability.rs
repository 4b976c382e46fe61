//! veerman.specM, veerman.specP2, veerman.eigAK, veerman.lem1: spectra and stability.

use algebra::matrix::RationalMatrix;
use algebra::spectrum::Polynomial;
use arithmetic::identity::RationalIdentity;
use arithmetic::{ArithmeticError, Field, Interval, Rational, Real, Ring, rational};
use ledger::{CheckError, Claim, Control, Evidence, Fault, Grade, Outcome, Repair, Run, interval_value};
use models::platoon::vector_form::{Block, control_block, geodesic_block, motion_matrix};
use models::platoon::{Communication, CommunicationGraph, Gains, slowest_rate};

const SYSTEMS: [Communication; 2] = [Communication::Front, Communication::FrontAndBack];

fn gains(f: &Rational, g: &Rational) -> Gains<Rational> {
    Gains { f: f.clone(), g: g.clone() }
}

/// `A + lambda K`.
fn mode_block<T: Ring>(gains: &Gains<T>, lambda: &T) -> Block<T> {
    let (a, k) = (geodesic_block(&gains.f), control_block(gains));
    [0, 1].map(|i| [0, 1].map(|j| a[i][j].clone() + lambda.clone() * &k[i][j]))
}

/// veerman.specM.
pub struct MotionSpectrum;

/// `spec(M)`, without 0 or with it, is the union of the spectra of `A + lambda K`, where `lambda` runs through the spectrum of
/// `P`, `factor` times.
#[derive(Clone, Copy)]
pub struct SpectrumVariant {
    zero_removed: bool,
    factor: (i64, i64),
    /// `spec(L)` loses this eigenvalue to become `spec(P)`.
    lost: i64,
}

/// The coefficients of `det(xI - M)`, and those of the product of `x² - lambda g x - lambda f` over the spectrum of `P`, which is
/// the sum of `p_k x^{2k} (g x + f)^{m-k}` for `det(yI - P) = sum p_k y^k`.
struct Characteristic {
    reduced: RationalMatrix,
    factor: (i64, i64),
}

impl Characteristic {
    fn product<T: Field>(&self, f: &T, g: &T) -> Result<Vec<T>, ArithmeticError> {
        let of_p = self.reduced.characteristic_polynomial().map_err(|_| ArithmeticError::Domain("square matrices"))?;
        let p = of_p.coefficients();
        let order = p.len() - 1;
        let scale = rational(self.factor.0, self.factor.1);
        let mut sum = vec![f.zero(); 2 * order + 1];
        for (k, coefficient) in p.iter().enumerate() {
            // (g x + f)^(m-k), lowest first.
            let mut power = vec![f.rational(coefficient)];
            for _ in k..order {
                let mut next = vec![f.zero(); power.len() + 1];
                for (n, c) in power.iter().enumerate() {
                    next[n] = next[n].clone() + f.clone() * c * f.rational(&scale);
                    next[n + 1] = g.clone() * c * f.rational(&scale);
                }
                power = next;
            }
            for (n, c) in power.into_iter().enumerate() {
                sum[2 * k + n] = sum[2 * k + n].clone() + c;
            }
        }
        Ok(sum)
    }
}

impl RationalIdentity for Characteristic {
    fn variables(&self) -> usize {
        2
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [f, g] = at else { return Err(ArithmeticError::Domain("two variables")) };
        let gains = Gains { f: f.clone(), g: g.clone() };
        let (a, k) = (geodesic_block(f), control_block(&gains));
        let order = 2 * self.reduced.rows();
        let entry = |i: usize, j: usize| {
            let own = if i / 2 == j / 2 { a[i % 2][j % 2].clone() } else { f.zero() };
            own + f.rational(&self.reduced.entry(i / 2, j / 2)) * &k[i % 2][j % 2]
        };
        let motion: Vec<Vec<T>> = (0..order).map(|i| (0..order).map(|j| entry(i, j)).collect()).collect();
        Ok((characteristic(&motion, f), self.product(f, g)?))
    }
}

/// The coefficients of `det(xI - A)`, lowest first, by Faddeev and LeVerrier.
fn characteristic<T: Field>(matrix: &[Vec<T>], like: &T) -> Vec<T> {
    let order = matrix.len();
    let mut coefficients = vec![like.one()];
    let mut auxiliary: Vec<Vec<T>> =
        (0..order).map(|i| (0..order).map(|j| like.integer(i64::from(i == j))).collect()).collect();
    for k in 1..=order {
        let entry =
            |i: usize, j: usize| (0..order).fold(like.zero(), |s, l| s + matrix[i][l].clone() * &auxiliary[l][j]);
        let mut product: Vec<Vec<T>> = (0..order).map(|i| (0..order).map(|j| entry(i, j)).collect()).collect();
        let trace = (0..order).fold(like.zero(), |sum, i| sum + &product[i][i]);
        let next = trace * like.ratio(-1, k as i64);
        for (i, row) in product.iter_mut().enumerate() {
            row[i] = row[i].clone() + &next;
        }
        auxiliary = product;
        coefficients.push(next);
    }
    coefficients.reverse();
    coefficients
}

impl Claim for MotionSpectrum {
    type Variant = SpectrumVariant;

    fn id(&self) -> &str {
        "veerman.specM"
    }

    fn derivation(&self) -> &str {
        "M = I ⊗ A + P ⊗ K. With P = S T S^-1, T triangular, M is similar to I ⊗ A + T ⊗ K, block triangular with the blocks \
         A + lambda K: spec(M) is the union, for all real f and g and every P. L has the leader's zero row, so \
         spec(L) = {0} and spec(P), and 0 is not in spec(P) (det P_1 = 1, det P_2 = 2^-N). As printed the left side loses the \
         eigenvalue 0 but the right side does not: at f = 0 (f and g are any real constants in Section 2) A + lambda K has the eigenvalue 0. For f != 0 neither side \
         contains 0 and the printed equation holds. (The cited papers remove 0 because their M contains the leader.)"
    }

    fn printed(&self) -> SpectrumVariant {
        SpectrumVariant { zero_removed: true, factor: (1, 1), lost: 0 }
    }

    fn repair(&self) -> Option<Repair<SpectrumVariant>> {
        Some(Repair {
            fault: Fault::Slip,
            clauses: Vec::new(),
            statement:
                "spec(M) = union over lambda in spec(L_i) \\ {0} of spec(A + lambda K), and spec(L_i) \\ {0} equals \
                        spec(P_i), for all real f and g (as printed, with spec(M) \\ {0}, for f != 0 only)."
                    .to_string(),
            variant: SpectrumVariant { zero_removed: false, ..self.printed() },
        })
    }

    fn controls(&self) -> Vec<Control<SpectrumVariant>> {
        let repaired = SpectrumVariant { zero_removed: false, ..self.printed() };
        vec![
            Control::new("A - lambda K", SpectrumVariant { factor: (-1, 1), ..repaired }),
            Control::new("A + lambda K/2", SpectrumVariant { factor: (1, 2), ..repaired }),
            Control::new("spec(L) without 1", SpectrumVariant { lost: 1, ..repaired }),
        ]
    }

    fn examine(&self, variant: &SpectrumVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        const IDENTITIES: usize = 3;
        let mut results = Vec::new();
        for communication in SYSTEMS {
            for followers in 1..=IDENTITIES {
                let reduced = CommunicationGraph::of(communication, followers)?.reduced_laplacian()?;
                let part = format!("det(xI - M) is the product over spec(P), {communication:?}, {followers} followers");
                results.push(run.identity(&Characteristic { reduced, factor: variant.factor }, &["f", "g"], &part));
            }
        }
        results.push(exact_spectra(variant, run));
        Run::all(results)
    }
}

/// Exact characteristic polynomials: the relation of L and P, and whether 0 belongs to both sides at small gains.
fn exact_spectra(variant: &SpectrumVariant, run: &Run) -> Result<Outcome, CheckError> {
    const MOST: usize = 6;
    let mut cases = 0;
    for communication in SYSTEMS {
        for followers in 1..=MOST {
            run.checkpoint()?;
            let graph = CommunicationGraph::of(communication, followers)?;
            let reduced = graph.reduced_laplacian()?;
            let integer = |m: &RationalMatrix| -> Result<Polynomial, CheckError> {
                Ok(Polynomial::from_rationals(&m.characteristic_polynomial()?.coefficients()))
            };
            let (times, rest) = integer(&graph.laplacian()?)?.without_root(variant.lost);
            if times == 0 || rest != integer(&reduced)? {
                return Ok(Outcome::fails(
                    format!(
                        "{communication:?}, {followers} followers: spec(L) without {} is not spec(P)",
                        variant.lost
                    ),
                    Evidence::new(Grade::Exact, "spec(L) and spec(P)", "characteristic polynomials"),
                ));
            }
            for (f, g) in [(-1, -1), (1, -1), (0, -1), (-1, 0), (0, 1), (0, 0)] {
                let (f, g) = (rational(f, 1), rational(g, 1));
                let motion = motion_matrix(&reduced, &gains(&f, &g))?;
                let left = integer(&motion)?;
                let characteristic = Characteristic { reduced: reduced.clone(), factor: variant.factor };
                let right = Polynomial::from_rationals(&characteristic.product(&f, &g)?);
                let zero_left = !variant.zero_removed && left.without_root(0).0 > 0;
                let zero_right = right.without_root(0).0 > 0;
                cases += 1;
                if left != right || zero_left != zero_right {
                    let what = if left == right { "0 is on one side only" } else { "the spectra differ" };
                    return Ok(Outcome::fails(
                        format!("{communication:?}, {followers} followers, f = {f}, g = {g}: {what}"),
                        Evidence::new(Grade::Exact, "f = 0", "characteristic polynomials of M and of the modes"),
                    ));
                }
            }
        }
    }
    let detail = format!(
        "exact characteristic polynomials, both systems, up to {MOST} followers, six pairs (f, g), f = 0 among them"
    );
    Ok(Outcome::Holds(vec![Evidence::new(Grade::Exact, "spec(M), spec(L), spec(P)", detail).cases(cases)]))
}

/// veerman.specP2.
pub struct ReducedSpectrum;

/// `1 + sign cos((2k + offset) pi/(2 (N + 1 + shift)))` for k = 1 to N + 1.
#[derive(Clone, Copy)]
pub struct ReducedSpectrumVariant {
    sign: i64,
    offset: i64,
    shift: i64,
}

impl Claim for ReducedSpectrum {
    type Variant = ReducedSpectrumVariant;

    fn id(&self) -> &str {
        "veerman.specP2"
    }

    fn derivation(&self) -> &str {
        "P_2 v = lambda v with v_0 = 0 is v_{k-1} = 2(1 - lambda) v_k - v_{k+1}, and v_{M-1} = (1 - lambda) v_M in the last row. So \
         v_{M-j} = T_j(1 - lambda) v_M with v_M != 0, and v_0 = 0 says T_M(1 - lambda) = 0: 1 - lambda = cos((2k-1) pi/(2M)) for \
         k = 1, ..., M. These are M different real numbers because the angles differ and lie in (0, pi)."
    }

    fn printed(&self) -> ReducedSpectrumVariant {
        ReducedSpectrumVariant { sign: -1, offset: -1, shift: 0 }
    }

    fn controls(&self) -> Vec<Control<ReducedSpectrumVariant>> {
        let printed = self.printed();
        vec![
            Control::new("2k + 1", ReducedSpectrumVariant { offset: 1, ..printed }),
            Control::new("2k", ReducedSpectrumVariant { offset: 0, ..printed }),
            Control::new("N + 2 in the denominator", ReducedSpectrumVariant { shift: 1, ..printed }),
        ]
    }

    fn examine(&self, variant: &ReducedSpectrumVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        const PRECISION: u32 = 96;
        const BITS: u32 = 60;
        let most = run.cases(12, 24);
        for followers in 1..=most {
            run.checkpoint()?;
            let reduced = CommunicationGraph::of(Communication::FrontAndBack, followers)?.reduced_laplacian()?;
            let polynomial = Polynomial::from_rationals(&reduced.characteristic_polynomial()?.coefficients());
            let evidence = Evidence::new(Grade::Certified, "eigenvalues", "isolated by Sturm's theorem");
            let mut roots = polynomial.roots_in(&rational(0, 1), &rational(2, 1));
            if polynomial != shifted_chebyshev(followers) || !polynomial.is_square_free() || roots.len() != followers {
                let what = format!(
                    "{followers} followers: det(xI - P_2) is not a multiple of T_M(1 - x) with simple real roots"
                );
                return Ok(Outcome::fails(what, evidence));
            }
            let one = Interval::from_rational(&rational(1, 1), PRECISION);
            let mut claimed = Vec::new();
            for k in 1..=followers as i64 {
                let angle = one.pi() * one.ratio(2 * k + variant.offset, 2 * (followers as i64 + variant.shift));
                claimed.push(one.clone() + one.integer(variant.sign) * angle.cos()?);
            }
            // Both lists increase: k-th with k-th.
            for (k, (root, claimed)) in roots.iter_mut().zip(&claimed).enumerate() {
                polynomial.refine(root, BITS);
                let enclosure = root.enclosure(PRECISION);
                if !enclosure.overlaps(claimed) {
                    let (found, claimed) = (interval_value(&enclosure, 12), interval_value(claimed, 12));
                    let what = format!("N = {}: eigenvalue {} of P_2 is {found}, not {claimed}", followers - 1, k + 1);
                    return Ok(Outcome::fails(what, evidence));
                }
            }
        }
        let exact = format!("det(xI - P_2) is a multiple of T_M(1 - x) without multiple roots, M = 1 to {most}");
        let certified = format!("every claimed number meets its own root, isolated to 2^-{BITS}, M = 1 to {most}");
        Ok(Outcome::Holds(vec![
            Evidence::new(Grade::Exact, "characteristic polynomial", exact).cases(most),
            Evidence::new(Grade::Certified, "eigenvalues", certified).cases(most * (most + 1) / 2),
        ]))
    }
}

/// `T_M(1 - x)`, primitive, with the sign of `det(xI - P)`.
fn shifted_chebyshev(order: usize) -> Polynomial {
    let mut previous = vec![rational(1, 1)];
    let mut current = vec![rational(1, 1), rational(-1, 1)];
    for _ in 1..order {
        // T_{n+1} = 2 (1 - x) T_n - T_{n-1}.
        let mut next = vec![rational(0, 1); current.len() + 1];
        for (k, c) in current.iter().enumerate() {
            next[k] += rational(2, 1) * c;
            next[k + 1] -= rational(2, 1) * c;
        }
        for (k, c) in previous.iter().enumerate() {
            next[k] -= c;
        }
        previous = std::mem::replace(&mut current, next);
    }
    let sign = rational(if order.is_multiple_of(2) { 1 } else { -1 }, 1);
    Polynomial::from_rationals(&current.iter().map(|c| c * &sign).collect::<Vec<_>>())
}

/// veerman.eigAK.
pub struct ModeEigenvalues;

/// `x² - lambda g x + sign lambda f = 0` and `x = half (lambda g ± sqrt((lambda g)² + four lambda f))`.
#[derive(Clone, Copy)]
pub struct ModeVariant {
    sign: i64,
    half: (i64, i64),
    four: i64,
}

/// Characteristic equation and roots; `r` is the square root, so `f = (r² - lambda² g²)/(four lambda)`.
struct ModeIdentity(ModeVariant);

impl RationalIdentity for ModeIdentity {
    fn variables(&self) -> usize {
        4
    }

    fn components(&self) -> Vec<String> {
        let names =
            ["det(xI - A - lambda K)", "the polynomial at x_+", "the polynomial at x_-", "x_+ + x_-", "x_+ x_-"];
        names.map(String::from).to_vec()
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [lambda, g, r, x] = at else { return Err(ArithmeticError::Domain("four variables")) };
        let damping = lambda.clone() * g;
        let f = (r.square() - damping.square()).over(&(lambda.integer(self.0.four) * lambda))?;
        let polynomial = |x: &T| x.square() - damping.clone() * x + lambda.integer(self.0.sign) * (lambda.clone() * &f);
        let [[a, b], [c, d]] = mode_block(&Gains { f: f.clone(), g: g.clone() }, lambda);
        let determinant = (x.clone() - a) * (x.clone() - d) - b * c;
        let half = lambda.ratio(self.0.half.0, self.0.half.1);
        let (plus, minus) = (half.clone() * (damping.clone() + r), half * (damping.clone() - r));
        // Both are roots of the claimed polynomial, and their sum and product say that they are all its roots.
        let values = [polynomial(&plus), polynomial(&minus)];
        let symmetric = [plus.clone() + &minus, plus * minus];
        let constant = polynomial(&x.zero());
        let left = [determinant].into_iter().chain(values).chain(symmetric);
        Ok((left.collect(), vec![polynomial(x), x.zero(), x.zero(), damping, constant]))
    }
}

impl Claim for ModeEigenvalues {
    type Variant = ModeVariant;

    fn id(&self) -> &str {
        "veerman.eigAK"
    }

    fn derivation(&self) -> &str {
        "det(xI - A - lambda K) = x (x - lambda g) - lambda f. The quadratic formula, with multiplicity: sum lambda g, product \
         -lambda f. For lambda = 0 both are 0. The square root may be imaginary; either branch gives the same pair."
    }

    fn printed(&self) -> ModeVariant {
        ModeVariant { sign: -1, half: (1, 2), four: 4 }
    }

    fn controls(&self) -> Vec<Control<ModeVariant>> {
        let printed = self.printed();
        vec![
            Control::new("+ lambda f", ModeVariant { sign: 1, ..printed }),
            Control::new("- 4 lambda f under the root", ModeVariant { four: -4, ..printed }),
            Control::new("1 instead of 1/2", ModeVariant { half: (1, 1), ..printed }),
        ]
    }

    fn examine(&self, variant: &ModeVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        run.identity(
            &ModeIdentity(*variant),
            &["lambda", "g", "r", "x"],
            "characteristic equation and its roots, (lambda g)² + 4 lambda f = r²",
        )
    }
}

/// veerman.lem1.
pub struct Stabilised;

/// When a platoon of any size is claimed to be stable.
#[derive(Clone, Copy)]
pub struct StabilityVariant {
    condition: fn(f: &Rational, g: &Rational) -> bool,
}

impl Claim for Stabilised {
    type Variant = StabilityVariant;

    fn id(&self) -> &str {
        "veerman.lem1"
    }

    fn derivation(&self) -> &str {
        "Stabilised means, as the text before says, that all eigenvalues of M have negative real parts; uniformly in N is read as: under one and the \
         same condition for every N. The eigenvalues are the roots of x² - lambda g x - lambda f with lambda in spec(P), and all \
         lambda are positive. A real quadratic x² + p x + q has both roots in the left half plane exactly if p > 0 and q > 0 (sum -p and \
         product q; complex roots have real part -p/2), so exactly if g < 0 and f < 0: for each N, and for all N together. Read as one rate of decay for \
         all N the lemma would hold for system (1) only: beyond.veerman.decay_rate."
    }

    fn printed(&self) -> StabilityVariant {
        StabilityVariant { condition: |f, g| *f < rational(0, 1) && *g < rational(0, 1) }
    }

    fn controls(&self) -> Vec<Control<StabilityVariant>> {
        vec![
            Control::new("f <= 0", StabilityVariant { condition: |f, g| *f <= rational(0, 1) && *g < rational(0, 1) }),
            Control::new("g <= 0", StabilityVariant { condition: |f, g| *f < rational(0, 1) && *g <= rational(0, 1) }),
            Control::new("f < 0 only", StabilityVariant { condition: |f, _| *f < rational(0, 1) }),
            Control::new(
                "g² > 4|f| too",
                StabilityVariant {
                    condition: |f, g| *f < rational(0, 1) && *g < rational(0, 1) && g * g > rational(-4, 1) * f,
                },
            ),
        ]
    }

    fn examine(&self, variant: &StabilityVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        const MOST: usize = 4;
        const VALUES: [(i64, i64); 7] = [(-3, 1), (-1, 1), (-1, 100), (0, 1), (1, 100), (1, 1), (3, 1)];
        let mut cases = 0;
        for communication in SYSTEMS {
            for followers in 1..=MOST {
                run.checkpoint()?;
                let reduced = CommunicationGraph::of(communication, followers)?.reduced_laplacian()?;
                for (f, g) in VALUES.iter().flat_map(|f| VALUES.iter().map(move |g| (f, g))) {
                    let (f, g) = (rational(f.0, f.1), rational(g.0, g.1));
                    let motion = motion_matrix(&reduced, &gains(&f, &g))?;
                    let stable =
                        Polynomial::from_rationals(&motion.characteristic_polynomial()?.coefficients()).is_hurwitz();
                    cases += 1;
                    if stable != (variant.condition)(&f, &g) {
                        let is = if stable { "stable" } else { "not stable" };
                        return Ok(Outcome::fails(
                            format!("{communication:?}, N = {}, f = {f}, g = {g}: M is {is}", followers - 1),
                            Evidence::new(Grade::Exact, "instances", "Routh's table of det(xI - M)"),
                        ));
                    }
                }
            }
        }
        let detail = format!(
            "Routh's table of the exact characteristic polynomial of M, both systems, up to {MOST} followers, f and g of either sign and zero; proof in \
             the derivation for all"
        );
        let minus_one = Gains { f: rational(-1, 1), g: rational(-1, 1) }.map(|q| Interval::from_rational(q, 64));
        for followers in [10, 100] {
            run.value(
                &format!("slowest_decay_rate_of_system_2_f_g_-1_M_{followers}"),
                interval_value(&slowest_rate(&minus_one, followers)?, 8),
            );
        }
        let quadratic = run.identity(
            &ModeIdentity(ModeEigenvalues.printed()),
            &["lambda", "g", "r", "x"],
            "the quadratic of every mode, whose coefficients decide",
        );
        Run::all([quadratic, Ok(Outcome::Holds(vec![Evidence::new(Grade::Exact, "instances", detail).cases(cases)]))])
    }
}
