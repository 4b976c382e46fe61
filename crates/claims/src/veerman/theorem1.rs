//! veerman.thm1_*: the main resonance of large platoons and the expansions in its proof.

use super::gains;
use crate::prelude::*;
use arithmetic::{Series, Signed};
use models::platoon::{Gains, Resonance, gamma_minus_one, larger_root_power, resonance, theorem1};

pub(super) const DIGITS: u32 = 36;

/// The gains at which asymptotic statements are checked.
fn gains_list() -> [Gains<Rational>; 3] {
    [((-1, 1), (-1, 1)), ((-2, 1), (-1, 2)), ((-1, 3), (-2, 1))].map(gains)
}

/// Sizes M from `first` on in steps of 8: 32 to about 10^6 (10^9 with `--full`).
fn sizes(run: &Run, first: u64) -> Vec<u64> {
    (0..run.cases(6, 9) as u32).map(|k| first * 8u64.pow(k)).collect()
}

/// Certifies on three pairs of gains that `error(gains, M) M^order` does not grow from the smallest to the largest size to
/// more than twice its size. An error of a lower order grows by a factor of 8 at least at every step.
pub(crate) fn scaled_error_is_bounded(
    smallest: u64,
    run: &mut Run,
    name: &str,
    order: u64,
    error: impl Fn(&Gains<Rational>, u64) -> Result<Interval, CheckError>,
) -> Result<Outcome, CheckError> {
    let sizes = sizes(run, smallest);
    let last = sizes[sizes.len() - 1];
    let mut reached: Option<Interval> = None;
    let mut first: Option<Interval> = None;
    let detail = format!(
        "enclosures of the true resonance for M = {}, {}, ..., {last} and three pairs (f, g): the error times M^{order} stays at most twice its size at M = {}",
        sizes[0], sizes[1], sizes[0]
    );
    let list = gains_list();
    let cases = list.iter().flat_map(|gains| sizes.iter().map(move |&m| (gains, m)));
    let outcome = run.every(certified(format!("{name} up to O(M^-{order})"), detail), cases, |(gains, m)| {
        let error = error(gains, m)?;
        let scaled = error.clone() * error.integer(m as i64).power(order);
        if m == sizes[0] {
            first = Some(scaled.clone() + &scaled);
        }
        if gains.f == rational(-1, 1) && m == last {
            reached = Some(scaled.clone());
        }
        let exceeded = first.iter().find(|bound| bound.magnitude() < scaled.magnitude());
        Ok(exceeded.map(|bound| {
            let (before, now) = (interval_value(&bound.scaled(-1), 6), interval_value(&scaled, 6));
            let at = format!("{name}, f = {}, g = {}", gains.f, gains.g);
            format!("{at}: the error times M^{order} is {before} for M = {} and {now} for M = {m}", sizes[0])
        }))
    })?;
    if let Some(scaled) = reached {
        run.value(&format!("{name}_error_times_M^{order}_at_f_g_-1_M_{last}"), interval_value(&scaled, 8));
    }
    Ok(outcome)
}

/// The true resonance and the gains as intervals of its precision.
pub(super) fn enclosed(gains: &Gains<Rational>, m: u64) -> Result<(Resonance, Gains<Interval>), CheckError> {
    let found = resonance(gains, m, DIGITS)?;
    let precision = found.omega.precision();
    Ok((found, super::enclosed(gains, precision)))
}

/// A printed leading term times a factor, for `M + offset` followers, with the order of its error.
#[derive(Clone, Copy)]
pub struct LeadingVariant {
    factor: (i64, i64),
    offset: i64,
    order: u64,
}

/// What the theorem says of one quantity.
fn leading(
    id: &'static str,
    derivation: &'static str,
    order: u64,
    examine: fn(&LeadingVariant, &mut Run) -> Result<Outcome, CheckError>,
) -> Record<LeadingVariant> {
    let printed = LeadingVariant { factor: (1, 1), offset: 0, order };
    Record::new(id, derivation, printed, examine)
        .control("an error of the next order", LeadingVariant { order: order + 1, ..printed })
        .control("N instead of N + 1", LeadingVariant { offset: -1, ..printed })
        .control("a coefficient larger by 1/1000", LeadingVariant { factor: (1001, 1000), ..printed })
}

fn examine_leading(
    name: &str,
    variant: &LeadingVariant,
    run: &mut Run,
    found: impl Fn(Resonance) -> Interval,
    leading: impl Fn(&Gains<Interval>, u64) -> Result<Interval, ArithmeticError>,
) -> Result<Outcome, CheckError> {
    let (p, q) = variant.factor;
    scaled_error_is_bounded(32, run, name, variant.order, |gains, m| {
        let (resonance, gains) = enclosed(gains, m)?;
        let leading = leading(&gains, m.saturating_add_signed(variant.offset))?;
        Ok(found(resonance) - leading.ratio(p, q) * leading)
    })
}

pub fn frequency() -> Record<LeadingVariant> {
    leading(
        "veerman.thm1_omega",
        "With a = w/sqrt|f|, b = |g|/sqrt|f| and gamma = cos(x - i y): x = sqrt2 a (1 + O(a²)), y = a² b/sqrt2 (1 + O(a²)). \
         F = cos²(Mx) + sinh²(My) is least where x' sin(2Mx) = y' sinh(2My), so Mx = pi/2 + O(M^-2), which gives \
         a = pi/(2 sqrt2 M) + O(M^-3). That this minimum is the main resonance is proved in notes/resonance.md for all \
         f, g < 0 and all M.",
        3,
        |variant, run| examine_leading("omega", variant, run, |found| found.omega, theorem1::frequency),
    )
}

pub fn amplitude() -> Record<LeadingVariant> {
    leading(
        "veerman.thm1_amp",
        "At the resonance F = cos²(Mx) + sinh²(My) with Mx = pi/2 + O(M^-2), so 1/sqrt F = 1/sinh(My) (1 + O(M^-2)), and \
         My = pi² b/(8 sqrt2 M) (1 + O(M^-2)): A = 8 sqrt(2|f|) M/(pi² |g|) + O(M^-1) (notes/resonance.md).",
        1,
        |variant, run| examine_leading("amplitude", variant, run, |found| found.amplitude, theorem1::amplitude),
    )
}

/// `sign i sqrt(two) (w/sqrt|f|)` times a bracket with the second-order term `(w²/2)(damping g²/f² + stiffness/|f|)`, of which so many
/// coefficients are compared.
#[derive(Clone, Copy)]
pub struct EpsilonVariant {
    sign: i64,
    two: i64,
    damping: (i64, i64),
    stiffness: (i64, i64),
    coefficients: usize,
}

impl EpsilonVariant {
    /// The coefficients of the claimed bracket, with `r = sqrt|f|` and `g` for `|g|`.
    fn bracket<T: Field>(&self, r: &T, g: &T) -> Result<Vec<Complex<T>>, ArithmeticError> {
        let size = r.square();
        let second = (g.ratio(self.damping.0, 2 * self.damping.1) * g.square()).over(&size.square())?
            + g.ratio(self.stiffness.0, 2 * self.stiffness.1).over(&size)?;
        let mut list = vec![
            Complex::real(r.one()),
            Complex::new(r.zero(), (-g.clone()).over(&(size.clone() + &size))?),
            Complex::real(second),
            Complex::real(r.zero()),
        ];
        list.truncate(self.coefficients);
        Ok(list)
    }
}

fn bracket_of_epsilon(variant: &EpsilonVariant) -> Identity<'_> {
    Identity::of(move |[r, g]| {
        let [_, bracket] = theorem1::expansion(r, g, variant.coefficients)?;
        let split = |z: &Complex<Probe>| [z.re.clone(), z.im.clone()];
        Ok((
            bracket.coefficients().iter().flat_map(split).collect(),
            variant.bracket(r, g)?.iter().flat_map(split).collect(),
        ))
    })
    .within(|at| at.iter().all(Signed::is_certainly_positive))
    .named((0..variant.coefficients).flat_map(|n| {
        ["real", "imaginary"].map(|part| format!("the {part} part of the coefficient of w^{n} in the bracket"))
    }))
}

/// The square of the claimed expansion is `gamma² - 1`, as far as its coefficients reach.
fn square_of_epsilon(variant: &EpsilonVariant) -> Identity<'_> {
    let order = variant.coefficients + 2;
    Identity::of(move |[r, g]| {
        let [gamma, _] = theorem1::expansion(r, g, order)?;
        let left = gamma.square() - Series::constant(Complex::real(r.one()), order);
        let mut claimed = variant.bracket(r, g)?;
        claimed.resize(order, Complex::real(r.zero()));
        let bracket = Series::from_coefficients(Complex::real(r.one()), claimed.into_iter().skip(1));
        let w = Series::variable(Complex::real(r.one()), order);
        let factor = Complex::real(r.integer(-variant.two).over(&r.square())?);
        let right = (w.square() * bracket.square()).scale(&factor);
        let split = |series: &Series<Complex<Probe>>| {
            series.coefficients().iter().flat_map(|z| [z.re.clone(), z.im.clone()]).collect()
        };
        Ok((split(&left), split(&right)))
    })
    .within(|at| at.iter().all(Signed::is_certainly_positive))
    .named((0..order).flat_map(|n| {
        ["real", "imaginary"].map(|part| format!("the {part} part of the coefficient of w^{n} in gamma² - 1"))
    }))
}

/// Whether the principal square root of `gamma² - 1` is nearer to the claimed expansion than to minus it.
fn root_of_epsilon(variant: &EpsilonVariant, run: &Run) -> Result<Outcome, CheckError> {
    let part = "the principal root of gamma² - 1";
    let detail = "enclosures at w = 1/8, 1/64, 1/512 for sqrt|f|, |g| = 1/2, 1, 2: nearer to the claimed expansion than to minus it";
    let numbers = [(1, 2), (1, 1), (2, 1)].map(|(p, q)| rational(p, q));
    let cases = numbers.iter().flat_map(|r| numbers.iter().map(move |g| (r, g)));
    let cases = cases.flat_map(|(r, g)| [8, 64, 512].map(|n| (r, g, rational(1, n))));
    run.every(certified(part, detail), cases, |(root, damping, frequency)| {
        let [r, g, w] = [root, damping, &frequency].map(|q| Interval::from_rational(q, 128));
        let q = gamma_minus_one(&Gains { f: -r.square(), g: -g.clone() }, &w)?;
        // (gamma - 1)(gamma + 1), and its root with a positive real part.
        let square = q.clone() * (q + Complex::real(r.integer(2)));
        let length = square.norm_squared().sqrt()?;
        let half = r.ratio(1, 2);
        let [re, im] = [length.clone() + &square.re, length - &square.re].map(|x| x * &half);
        let (re, im) = (re.sqrt()?, im.sqrt()?);
        let im = if at_most(&square.im, &r.zero())? { -im } else { im };
        let mut bracket = Complex::real(r.zero());
        for coefficient in variant.bracket(&r, &g)?.iter().rev() {
            bracket = bracket.scale(&w) + coefficient.clone();
        }
        let size = (r.integer(variant.two).sqrt()? * &w * r.integer(variant.sign)).over(&r)?;
        let claimed = bracket * Complex::new(r.zero(), size);
        let along = re.clone() * &claimed.re + im.clone() * &claimed.im;
        Ok(at_most(&along, &r.zero())?.then(|| {
            let at = format!("sqrt|f| = {root}, |g| = {damping}, w = {frequency}");
            let [re, im, a, b] = [&re, &im, &claimed.re, &claimed.im].map(Interval::to_f64);
            format!("{at}: the principal root of gamma² - 1 is {re:.6} + ({im:.6})i, the claimed expansion {a:.6} + ({b:.6})i")
        }))
    })
}

pub fn epsilon() -> Record<EpsilonVariant> {
    Record::new(
        "veerman.thm1_eps",
        "epsilon² = gamma² - 1 = -(2w²/|f|) S with S = (1 + i w|g|/|f|)^-1 (1 - q/2). The square root of S = 1 + s_1 w + s_2 w² \
         is 1 + s_1 w/2 + (s_2/2 - s_1²/8) w²; the paper drops the term -s_1²/8 = g²/(8 f²). The coefficient is -3/4 g²/f², \
         not -g²/f². The error is O(w³) and does not change the theorem. For w > 0 the imaginary part of gamma² - 1 is positive and its \
         angle near pi, so the root with angle in (-pi/2, pi/2] is the one with +i.",
        EpsilonVariant { sign: 1, two: 2, damping: (-1, 1), stiffness: (-1, 2), coefficients: 3 },
        |variant, run| {
            let names = ["sqrt|f|", "|g|"];
            let part = "coefficients of the expansion, exact power series";
            let square = "the square of the expansion, exact power series";
            Run::all([
                run.identity(&bracket_of_epsilon(variant), &names, part),
                run.identity(&square_of_epsilon(variant), &names, square),
                root_of_epsilon(variant, run),
                argued(&[1], "the root and the error", "notes/veerman.md, The root of gamma^2 - 1, steps 1 to 4"),
            ])
        },
    )
    .reading("eps = sqrt(gamma^2 - 1), the principal root, for w > 0.")
    .repaired_by(
        Fault::Slip,
        "For w > 0 and f, g < 0, eps = sqrt(gamma^2 - 1), the principal root, = i sqrt(2) (w/sqrt(|f|)) ( (1 - i w |g|/(2|f|)) + (w^2/2)(- \
         (3/4) g^2/f^2 - 1/(2|f|)) ) + O(w^4) as w -> 0, for fixed f and g.",
        |v| v.damping = (-3, 4),
    )
    .altered("+ 3/4 g²/f²", |v| v.damping = (3, 4))
    .altered("- 1/|f|", |v| v.stiffness = (-1, 1))
    .altered("an error O(w^5)", |v| v.coefficients = 4)
    .altered("w/sqrt|f| without sqrt 2", |v| v.two = 1)
    .altered("-i in place of i", |v| v.sign = -1)
}

/// `|mu_+-|² = 1 +- coefficient sqrt2 w² |g|/|f|^(power/2) + O(w^order)`.
#[derive(Clone, Copy)]
pub struct ModulusVariant {
    coefficient: i64,
    power: u64,
    order: usize,
}

/// `|mu_+-|² = A +- sqrt2 B` with `A = |gamma|² + |epsilon|²` and `sqrt2 B = 2 Re(conj(gamma) epsilon)`.
fn squared_modulus(variant: &ModulusVariant) -> Identity<'_> {
    Identity::of(move |[r, g]| {
        let order = variant.order;
        let [gamma, bracket] = theorem1::expansion(r, g, order)?;
        let w = Series::variable(Complex::real(r.one()), order);
        let inverse = r.recip()?;
        let epsilon = (w * bracket).scale(&Complex::new(r.zero(), inverse));
        let mixed = gamma.map(Complex::conj) * &epsilon;
        let two = Complex::real(r.integer(2));
        let even =
            gamma.clone() * gamma.map(Complex::conj) + (epsilon.clone() * epsilon.map(Complex::conj)).scale(&two);
        let odd = mixed.clone() + mixed.map(Complex::conj);
        let zero = r.zero();
        let mut expected = vec![zero.clone(); 2 * order];
        expected[0] = r.one();
        if let Some(slot) = expected.get_mut(order + 2) {
            *slot = (r.integer(variant.coefficient) * g).over(&r.power(variant.power))?;
        }
        let real =
            |series: &Series<Complex<Probe>>| series.coefficients().iter().map(|c| c.re.clone()).collect::<Vec<_>>();
        Ok(([real(&even), real(&odd)].concat(), expected))
    })
    .within(|at| at.iter().all(Signed::is_certainly_positive))
}

pub fn modulus() -> Record<ModulusVariant> {
    Record::new(
        "veerman.thm1_mod",
        "|gamma +- epsilon|² = |gamma|² + |epsilon|² +- 2 Re(conj(gamma) epsilon). The first two terms sum to 1 + O(w⁴); the \
         last is sqrt2 w² |g|/|f|^(3/2) + O(w⁴). Exact power series in w; the faulty term of eps enters at w⁴ only. mu_+ is the root with the principal \
         square root, for w > 0 the one with +i (see veerman.thm1_eps).",
        ModulusVariant { coefficient: 1, power: 3, order: 4 },
        |variant, run| {
            let part = "coefficients of |mu|², exact power series";
            run.identity(&squared_modulus(variant), &["sqrt|f|", "|g|"], part).for_all()
        },
    )
    .altered("2 sqrt2", |v| v.coefficient = 2)
    .altered("the signs exchanged", |v| v.coefficient = -1)
    .altered("|f| instead of |f|^(3/2)", |v| v.power = 2)
    .altered("an error O(w^5)", |v| v.order = 5)
}

/// `x = pi² |g|/(divisor sqrt2 |f|^(power/2))`.
#[derive(Clone, Copy)]
pub struct ExponentVariant {
    pub(super) divisor: i64,
    pub(super) power: u64,
    /// Order of the error of `|mu_+-|^(N+1)`, and in Proposition 2 of the size.
    pub(super) order: u64,
}

impl ExponentVariant {
    /// `x`: that of the library for the divisor 8 and the power 1.
    pub(super) fn value(&self, gains: &Gains<Interval>) -> Result<Interval, ArithmeticError> {
        let root = (-gains.f.clone()).sqrt()?;
        let altered = root.ratio(8, self.divisor) * &root;
        (theorem1::exponent(gains)? * altered).over(&root.power(self.power))
    }
}

/// In units of pi² and squared: `2x/M²` is `sqrt2 w² |g|/|f|^(3/2)` at the frequency of Theorem 1, and `(N+1)/x` its
/// amplitude.
fn exponent_definition(variant: &ExponentVariant) -> Identity<'_> {
    Identity::of(move |[r, g]| {
        let x_squared =
            g.square().over(&(r.integer(2 * variant.divisor * variant.divisor) * r.power(2 * variant.power)))?;
        // w² = |f| pi²/(8 M²); |f| = r².
        let from_modulus = (g.integer(2) * g.square() * r.power(4)).over(&(r.integer(64) * r.power(6)))?;
        let from_theorem = (r.integer(128) * r.square()).over(&g.square())?;
        Ok((vec![x_squared.clone() * x_squared.integer(4), x_squared.recip()?], vec![from_modulus, from_theorem]))
    })
    .within(|at| at.iter().all(Signed::is_certainly_positive))
}

pub fn exponent() -> Record<ExponentVariant> {
    Record::new(
        "veerman.thm1_x",
        "|mu_+-|² = 1 +- sqrt2 w² |g|/|f|^(3/2) at w = sqrt|f| pi/(2 sqrt2 M) is 1 +- pi² |g|/(4 sqrt2 sqrt|f| M²), which is \
         1 +- 2x/M² for x = pi² |g|/(8 sqrt2 sqrt|f|). The printed |f| instead of sqrt|f| would also contradict the amplitude \
         of the theorem, M/x; for f = -1 the two agree.",
        ExponentVariant { divisor: 8, power: 2, order: 3 },
        examine_exponent,
    )
    .clauses(&[
        "With x := pi^2 |g|/(8 sqrt(2) |f|), |mu_+-|^{N+1} = e^{+-x/(N+1)} + O(N^{-3}) at the principal resonance.",
        "A = |a_{N+1}| = (N+1)/x + O(N^{-1}).",
    ])
    .repaired_by(Fault::Typo, "", |v| v.power = 1)
    .repaired_clauses(&[
        "For f, g < 0 and x := pi^2 |g|/(8 sqrt(2) sqrt(|f|)), |mu_+-|^{N+1} = e^{+-x/(N+1)} + O(N^{-3}) at the principal resonance of \
         system (2), for fixed f and g and a leader of amplitude 1.",
        "For f, g < 0 and the same x, A = |a_{N+1}| = (N+1)/x + O(N^{-1}) there.",
    ])
    .altered("4 sqrt2 instead of 8 sqrt2", |v| v.divisor = 4)
    .altered("|f|^(3/2)", |v| v.power = 3)
    .altered("an error O(N^-4)", |v| v.order = 4)
}

fn examine_exponent(variant: &ExponentVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let x_over_m =
        |gains: &Gains<Interval>, m: u64| Ok::<_, CheckError>(variant.value(gains)?.over(&gains.f.integer(m as i64))?);
    let modulus = |gains: &Gains<Rational>, m: u64| {
        let (found, gains) = enclosed(gains, m)?;
        Ok::<_, CheckError>((larger_root_power(&gains, &found.omega, m)?, x_over_m(&gains, m)?))
    };
    let plus = scaled_error_is_bounded(32, run, "modulus_plus", variant.order, |gains, m| {
        let (power, x) = modulus(gains, m)?;
        Ok(power - x.exp()?)
    })?;
    let minus = scaled_error_is_bounded(32, run, "modulus_minus", variant.order, |gains, m| {
        let (power, x) = modulus(gains, m)?;
        Ok(power.recip()? - (-x).exp()?)
    })?;
    let amplitude = scaled_error_is_bounded(32, run, "amplitude", 1, |gains, m| {
        let (found, gains) = enclosed(gains, m)?;
        Ok(found.amplitude - x_over_m(&gains, m)?.recip()?)
    })?;
    let part = "2x/M² is the term of |mu|² at the frequency of Theorem 1, and (N+1)/x its amplitude";
    let definition = run.identity(&exponent_definition(variant), &["sqrt|f|", "|g|"], part)?;
    Run::all([Ok(amplitude.on([2])), Ok(plus.on([1])), Ok(minus.on([1])), Ok(definition.on([1, 2]))])
}
