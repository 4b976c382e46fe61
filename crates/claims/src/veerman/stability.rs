//! veerman.specM, veerman.specP2, veerman.eigAK, veerman.lem1: spectra and stability.

use super::{enclosed, unit};
use crate::prelude::*;
use algebra::matrix::{RationalMatrix, characteristic_coefficients};
use algebra::spectrum::Polynomial;
use arithmetic::Series;
use models::platoon::vector_form::{characteristic_by_modes, is_stable, mode_block, motion_matrix, motion_rows};
use models::platoon::{Communication, CommunicationGraph, Gains, chebyshev, slowest_rate};

const SYSTEMS: [Communication; 2] = [Communication::Front, Communication::FrontAndBack];

/// Both systems with 1 to `most` followers.
fn systems(most: usize) -> impl Iterator<Item = (Communication, usize)> {
    SYSTEMS.into_iter().flat_map(move |communication| (1..=most).map(move |followers| (communication, followers)))
}

/// `det(xI - A)` up to a factor, over the integers.
fn polynomial(matrix: &RationalMatrix) -> Result<Polynomial, CheckError> {
    Ok(matrix.primitive_characteristic()?)
}

/// `spec(M)`, without 0 or with it, is the union of the spectra of `A + factor lambda K`, where `lambda` runs through the spectrum of
/// `P`.
#[derive(Clone, Copy)]
pub struct SpectrumVariant {
    zero_removed: bool,
    factor: i64,
    /// `spec(L)` loses this eigenvalue to become `spec(P)`.
    lost: i64,
}

/// The coefficients of `det(xI - M)`, and those of the product over the spectrum of `P`.
fn characteristic(reduced: &RationalMatrix, factor: i64) -> Identity<'_> {
    Identity::of(move |[f, g]| {
        let gains = Gains { f: f.clone(), g: g.clone() };
        Ok((characteristic_coefficients(&motion_rows(reduced, &gains), f), over_modes(reduced, factor, &gains)?))
    })
}

fn over_modes<T: Field>(reduced: &RationalMatrix, factor: i64, gains: &Gains<T>) -> Result<Vec<T>, ArithmeticError> {
    let of_p = reduced.characteristic_polynomial().map_err(|_| ArithmeticError::Domain("square matrices"))?;
    Ok(characteristic_by_modes(&of_p.coefficients(), &gains.map(|x| x.integer(factor) * x)))
}

/// `det(A + factor lambda K)`, and what it is said to be.
fn block_determinant(factor: i64) -> Identity<'static> {
    Identity::of(move |[f, g, lambda]| {
        let gains = Gains { f: f.integer(factor) * f, g: f.integer(factor) * g };
        let [[a, b], [c, d]] = mode_block(&gains, lambda);
        Ok((vec![a * d - b * c], vec![-(lambda.clone() * f)]))
    })
}

pub fn motion_spectrum() -> Record<SpectrumVariant> {
    Record::new(
        "veerman.specM",
        "M = I ⊗ A + P ⊗ K. With P = S T S^-1, T triangular, M is similar to I ⊗ A + T ⊗ K, block triangular with the blocks \
         A + lambda K: spec(M) is the union, for all real f and g and every P. L has the leader's zero row, so \
         spec(L) = {0} and spec(P), and 0 is not in spec(P) (det P_1 = 1, det P_2 = 2^-N). As printed the left side loses the \
         eigenvalue 0 but the right side does not: at f = 0 (f and g are any real constants in Section 2) A + lambda K has the eigenvalue 0. For f != 0 neither side \
         contains 0 and the printed equation holds. (The cited papers remove 0 because their M contains the leader.)",
        SpectrumVariant { zero_removed: true, factor: 1, lost: 0 },
        examine_spectrum,
    )
    .clauses(&[
        "spec(M) \\ {0} = union over lambda in spec(L_i) \\ {0} of spec(A + lambda K) = union of spec [[0,1],[lambda f, lambda g]].",
        "spec(L_i) \\ {0} equals spec(P_i).",
    ])
    .repaired_by(Fault::Hypothesis, "", |v| v.zero_removed = false)
    .repaired_clauses(&[
        "With A = [[0,1],[0,0]], K = [[0,0],[f,g]] and M = I kron A + P_i kron K the matrix of system (i), i = 1, 2, where L_i is the \
         Laplacian with the leader and P_i the one without the row and the column of the leader: spec(M) = union over lambda in spec(L_i) \
         \\ {0} of spec(A + lambda K), for all real f and g.",
        "For f != 0, 0 is not in spec(M), so that the union is spec(M) \\ {0} too.",
        "spec(L_i) \\ {0} equals spec(P_i).",
    ])
    .altered("A - lambda K", |v| v.factor = -1)
    .altered("spec(L) without 1", |v| v.lost = 1)
}

fn examine_spectrum(variant: &SpectrumVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    const IDENTITIES: usize = 3;
    const MOST: usize = 6;
    let mut results = Vec::new();
    for (communication, followers) in systems(IDENTITIES) {
        let reduced = CommunicationGraph::of(communication, followers)?.reduced_laplacian()?;
        let part = format!("det(xI - M) is the product over spec(P), {communication:?}, {followers} followers");
        results.push(run.identity(&characteristic(&reduced, variant.factor), &["f", "g"], &part).on([1]));
    }
    let detail = format!("exact characteristic polynomials, both systems, up to {MOST} followers");
    results.push(
        run.instances("spec(L) and spec(P)", &detail, systems(MOST), |(communication, followers)| {
            let graph = CommunicationGraph::of(communication, followers)?;
            let (times, rest) = polynomial(&graph.laplacian()?)?.without_root(variant.lost);
            let wrong = times == 0 || rest != polynomial(&graph.reduced_laplacian()?)?;
            let lost = variant.lost;
            Ok(wrong
                .then(|| format!("{communication:?}, {followers} followers: spec(L) without {lost} is not spec(P)")))
        })
        .on([3])
        .checks("step 4, and that 0 is not in spec(P), steps 2 and 3"),
    );
    results.push(zero_on_both_sides(variant, MOST, run).checks("steps 5 and 6"));
    let part = "det(A + lambda K) = - lambda f: with clause 1, 0 is in spec(M) only where f = 0";
    results.push(
        run.identity(&block_determinant(variant.factor), &["f", "g", "lambda"], part)
            .on([2])
            .for_all()
            .checks("the determinant of step 5"),
    );
    results.push(argued(&[2], "spec(M) for f != 0", "notes/veerman_platoons.md, spectra, steps 3 to 6"));
    results.push(argued(&[3], "spec(L) and spec(P)", "notes/veerman_platoons.md, spectra, steps 1 to 4"));
    Run::all(results)
}

/// Whether the characteristic polynomials agree at small gains, and 0 is on both sides or on none.
fn zero_on_both_sides(variant: &SpectrumVariant, most: usize, run: &Run) -> Result<Outcome, CheckError> {
    let pairs = [(-1, -1), (1, -1), (0, -1), (-1, 0), (0, 1), (0, 0)];
    let cases = systems(most).flat_map(|system| pairs.map(|pair| (system, pair)));
    let detail = format!(
        "exact characteristic polynomials of M and of the modes, both systems, up to {most} followers, six pairs (f, g), f = 0 among them"
    );
    let outcome = run.instances("spec(M)", &detail, cases, |((communication, followers), (f, g))| {
        let gains = Gains { f: rational(f, 1), g: rational(g, 1) };
        let reduced = CommunicationGraph::of(communication, followers)?.reduced_laplacian()?;
        let left = polynomial(&motion_matrix(&reduced, &gains)?)?;
        let right = Polynomial::from_rationals(&over_modes(&reduced, variant.factor, &gains)?);
        let zero_left = left.without_root(0).0 > 0;
        let what = match () {
            () if left != right => "the spectra differ",
            () if (zero_left && !variant.zero_removed) != (right.without_root(0).0 > 0) => "0 is on one side only",
            () if f != 0 && zero_left => "0 is an eigenvalue of M",
            () => return Ok(None),
        };
        Ok(Some(format!("{communication:?}, {followers} followers, f = {f}, g = {g}: {what}")))
    })?;
    Ok(match outcome {
        Outcome::Holds(_) => outcome.on([1, 2]),
        failed => failed.on([1]),
    })
}

/// `1 + sign cos((2k + offset) pi/(2 (N + 1 + shift)))` for k = 1 to N + 1.
#[derive(Clone, Copy)]
pub struct ReducedSpectrumVariant {
    sign: i64,
    offset: i64,
    shift: i64,
    /// How much more than M the degree of the Chebyshev polynomial is.
    degree: usize,
}

pub fn reduced_spectrum() -> Record<ReducedSpectrumVariant> {
    Record::new(
        "veerman.specP2",
        "P_2 v = lambda v with v_0 = 0 is v_{k-1} = 2(1 - lambda) v_k - v_{k+1}, and v_{M-1} = (1 - lambda) v_M in the last row. So \
         v_{M-j} = T_j(1 - lambda) v_M with v_M != 0, and v_0 = 0 says T_M(1 - lambda) = 0: 1 - lambda = cos((2k-1) pi/(2M)) for \
         k = 1, ..., M. These are M different real numbers because the angles differ and lie in (0, pi).",
        ReducedSpectrumVariant { sign: -1, offset: -1, shift: 0, degree: 0 },
        examine_reduced_spectrum,
    )
    .clauses(&[
        "The spectrum of P_2 is {1 - cos((2k-1) pi/(2(N+1))) : k = 1,...,N+1}.",
        "All these eigenvalues are simple and real.",
    ])
    .altered("2k + 1", |v| v.offset = 1)
    .altered("2k", |v| v.offset = 0)
    .altered("N + 2 in the denominator", |v| v.shift = 1)
    .altered("a multiple of T_(M+1)(1 - x)", |v| v.degree = 1)
}

fn examine_reduced_spectrum(variant: &ReducedSpectrumVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    const BITS: u32 = 60;
    let most = run.cases(12, 24);
    let isolated = |followers: usize| -> Result<_, CheckError> {
        let reduced = CommunicationGraph::of(Communication::FrontAndBack, followers)?.reduced_laplacian()?;
        let polynomial = polynomial(&reduced)?;
        let roots = polynomial.roots_in(&rational(0, 1), &rational(2, 1));
        Ok((polynomial, roots))
    };
    let detail = format!("det(xI - P_2) is a multiple of T_M(1 - x) with M simple roots in (0, 2), M = 1 to {most}");
    let exact = run.instances("characteristic polynomial", &detail, 1..=most, |followers| {
        let (polynomial, roots) = isolated(followers)?;
        let wrong = polynomial != shifted_chebyshev(followers + variant.degree)
            || !polynomial.is_square_free()
            || roots.len() != followers;
        let what = "det(xI - P_2) is not a multiple of T_M(1 - x) with simple real roots";
        Ok(wrong.then(|| format!("{followers} followers: {what}")))
    })?;
    let detail = format!("every claimed number meets its own root, isolated to 2^-{BITS}, M = 1 to {most}");
    let enclosed = run.every(certified("eigenvalues", detail), 1..=most, |followers| {
        let (polynomial, mut roots) = isolated(followers)?;
        // Both lists increase: k-th with k-th.
        for (k, root) in (1..).zip(roots.iter_mut()) {
            polynomial.refine(root, BITS);
            let (enclosure, claimed) = (root.enclosure(PRECISION), variant.eigenvalue(followers, k)?);
            if !enclosure.overlaps(&claimed) {
                let (found, claimed) = (interval_value(&enclosure, 12), interval_value(&claimed, 12));
                let what = format!("N = {}: eigenvalue {k} of P_2 is {found}, not {claimed}", followers - 1);
                return Ok(Some(what));
            }
        }
        Ok(None)
    })?;
    Run::all([Ok(exact.on([1, 2])), Ok(enclosed.on([1]))])
}

const PRECISION: u32 = 96;

impl ReducedSpectrumVariant {
    /// The claimed `k`-th eigenvalue.
    fn eigenvalue(&self, followers: usize, k: i64) -> Result<Interval, ArithmeticError> {
        let one = Interval::from_rational(&rational(1, 1), PRECISION);
        let angle = one.pi() * one.ratio(2 * k + self.offset, 2 * (followers as i64 + self.shift));
        Ok(one.clone() + one.integer(self.sign) * angle.cos()?)
    }
}

/// `T_M(1 - x)`, primitive, with the sign of `det(xI - P)`.
fn shifted_chebyshev(order: usize) -> Polynomial {
    let (t, _) = chebyshev(order as u64, &Series::variable(rational(-1, 1), order + 1));
    let sign = rational(if order.is_multiple_of(2) { 1 } else { -1 }, 1);
    Polynomial::from_rationals(t.scale(&sign).coefficients())
}

/// `x² - lambda g x + sign lambda f = 0` and `x = half (lambda g ± sqrt((lambda g)² + four lambda f))`.
#[derive(Clone, Copy)]
pub struct ModeVariant {
    sign: i64,
    half: (i64, i64),
    four: i64,
}

/// Characteristic equation and roots; `r` is the square root, so `f = (r² - lambda² g²)/(four lambda)`.
fn mode_sides(variant: &ModeVariant) -> Identity<'_> {
    Identity::of(move |[lambda, g, r, x]| {
        let damping = lambda.clone() * g;
        let f = (r.square() - damping.square()).over(&(lambda.integer(variant.four) * lambda))?;
        let polynomial =
            |x: &Probe| x.square() - damping.clone() * x + lambda.integer(variant.sign) * (lambda.clone() * &f);
        let [[a, b], [c, d]] = mode_block(&Gains { f: f.clone(), g: g.clone() }, lambda);
        let determinant = (x.clone() - a) * (x.clone() - d) - b * c;
        let half = lambda.ratio(variant.half.0, variant.half.1);
        let (plus, minus) = (half.clone() * (damping.clone() + r), half * (damping.clone() - r));
        // Both are roots of the claimed polynomial, and their sum and product say that they are all its roots.
        let values = [polynomial(&plus), polynomial(&minus)];
        let symmetric = [plus.clone() + &minus, plus * minus];
        let constant = polynomial(&x.zero());
        let left = [determinant].into_iter().chain(values).chain(symmetric);
        Ok((left.collect(), vec![polynomial(x), x.zero(), x.zero(), damping, constant]))
    })
    .named(["det(xI - A - lambda K)", "the polynomial at x_+", "the polynomial at x_-", "x_+ + x_-", "x_+ x_-"])
}

const MODE: ModeVariant = ModeVariant { sign: -1, half: (1, 2), four: 4 };

pub fn mode_eigenvalues() -> Record<ModeVariant> {
    Record::new(
        "veerman.eigAK",
        "det(xI - A - lambda K) = x (x - lambda g) - lambda f. The quadratic formula, with multiplicity: sum lambda g, product \
         -lambda f. For lambda = 0 both are 0. The square root may be imaginary; either branch gives the same pair.",
        MODE,
        |variant, run| {
            let part = "characteristic equation and its roots, (lambda g)² + 4 lambda f = r², lambda != 0";
            run.identity(&mode_sides(variant), &["lambda", "g", "r", "x"], part).on([1, 2])
        },
    )
    .clauses(&[
        "The eigenvalues of A + lambda K are the solutions of x^2 - lambda g x - lambda f = 0.",
        "They are x_+- = (1/2)(lambda g +- sqrt((lambda g)^2 + 4 lambda f)).",
    ])
    .altered("+ lambda f", |v| v.sign = 1)
    .altered("- 4 lambda f under the root", |v| v.four = -4)
    .altered("1 instead of 1/2", |v| v.half = (1, 1))
}

/// When a platoon of any size is claimed to be stable, and the quadratic of a mode that is to decide it.
#[derive(Clone, Copy)]
pub struct StabilityVariant {
    condition: fn(f: &Rational, g: &Rational) -> bool,
    mode: ModeVariant,
}

pub fn stabilised() -> Record<StabilityVariant> {
    Record::new(
        "veerman.lem1",
        "The eigenvalues are the roots of x² - lambda g x - lambda f with lambda in spec(P), and all \
         lambda are positive. A real quadratic x² + p x + q has both roots in the left half plane exactly if p > 0 and q > 0 (sum -p and \
         product q; complex roots have real part -p/2), so exactly if g < 0 and f < 0: for each N, and for all N together. Read as one rate of decay for \
         all N the lemma would hold for system (1) only: beyond.veerman.decay_rate.",
        StabilityVariant { condition: |f, g| *f < rational(0, 1) && *g < rational(0, 1), mode: MODE },
        examine_stability,
    )
    .reading("Stabilised means, as the text before says, that all eigenvalues of M have negative real parts; uniformly in N: under one and the same condition for every N.")
    .clauses(&[
        "If both f and g are strictly smaller than zero, systems (1) and (2) are stabilized for every N.",
        "If systems (1) and (2) are stabilized for every N, both f and g are strictly smaller than zero.",
    ])
    .altered("f <= 0", |v| v.condition = |f, g| *f <= rational(0, 1) && *g < rational(0, 1))
    .altered("g <= 0", |v| v.condition = |f, g| *f < rational(0, 1) && *g <= rational(0, 1))
    .altered("g² > 4|f| too", |v| {
        v.condition = |f, g| *f < rational(0, 1) && *g < rational(0, 1) && g * g > rational(-4, 1) * f;
    })
    .altered("x² - lambda g x + lambda f, the quadratic of a mode", |v| v.mode.sign = 1)
}

fn examine_stability(variant: &StabilityVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    const MOST: usize = 4;
    const VALUES: [(i64, i64); 7] = [(-3, 1), (-1, 1), (-1, 100), (0, 1), (1, 100), (1, 1), (3, 1)];
    let detail = format!(
        "Routh's table of the exact characteristic polynomial of M, both systems, up to {MOST} followers, f and g of either sign and zero"
    );
    let pairs = || VALUES.iter().flat_map(|f| VALUES.iter().map(move |g| super::gains((*f, *g))));
    let cases = systems(MOST).flat_map(|system| pairs().map(move |gains| (system, gains)));
    let instances = run.instances("instances", &detail, cases, |((communication, followers), gains)| {
        let reduced = CommunicationGraph::of(communication, followers)?.reduced_laplacian()?;
        let stable = is_stable(&motion_matrix(&reduced, &gains)?)?;
        let is = if stable { "stable" } else { "not stable" };
        let Gains { f, g } = gains;
        let what = || format!("{communication:?}, N = {}, f = {f}, g = {g}: M is {is}", followers - 1);
        Ok((stable != (variant.condition)(&f, &g)).then(what))
    })?;
    let minus_one = enclosed(&unit(), 64);
    for followers in [10, 100] {
        let name = format!("slowest_decay_rate_of_system_2_f_g_-1_M_{followers}");
        run.value(&name, interval_value(&slowest_rate(&minus_one, followers)?, 8));
    }
    let part = "the quadratic of every mode, whose coefficients decide";
    let quadratic = run.identity(&mode_sides(&variant.mode), &["lambda", "g", "r", "x"], part);
    Run::all([quadratic, Ok(instances)]).on([1, 2])
}
