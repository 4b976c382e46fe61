//! beyond.veerman.resonance_frequency, beyond.veerman.resonance_amplitude: the resonance to the next order, with explicit bounds
//! of the error.

use arithmetic::identity::RationalIdentity;
use arithmetic::{ArithmeticError, Complex, Field, Interval, Rational, Real, Ring, Series, Signed, rational};
use ledger::{CheckError, Claim, Control, Evidence, Grade, Outcome, Run, Source, interval_value};
use models::platoon::{Gains, Resonance, next_order, resonance, theorem1};

const DIGITS: u32 = 40;

/// The correction to Theorem 1 times a factor, for `M + offset` followers, and the claimed bound of the error times another.
#[derive(Clone, Copy)]
pub struct NextOrderVariant {
    correction: (i64, i64),
    bound: (i64, i64),
    offset: i64,
}

const PRINTED: NextOrderVariant = NextOrderVariant { correction: (1, 1), bound: (1, 1), offset: 0 };

fn controls() -> Vec<Control<NextOrderVariant>> {
    vec![
        Control::new("without the correction", NextOrderVariant { correction: (0, 1), ..PRINTED }),
        Control::new("the correction with the opposite sign", NextOrderVariant { correction: (-1, 1), ..PRINTED }),
        Control::new("a correction larger by 1/1000", NextOrderVariant { correction: (1001, 1000), ..PRINTED }),
        Control::new("an error bound 500 times smaller", NextOrderVariant { bound: (1, 500), ..PRINTED }),
        Control::new("N instead of N + 1", NextOrderVariant { offset: -1, ..PRINTED }),
    ]
}

fn gains_list() -> Vec<Gains<Rational>> {
    let numbers =
        [((-1, 1), (-1, 1)), ((-2, 1), (-1, 2)), ((-1, 3), (-2, 1)), ((-1, 1), (-1, 1000)), ((-9, 1), (-60, 1))];
    numbers.iter().map(|&(f, g)| Gains { f: rational(f.0, f.1), g: rational(g.0, g.1) }).collect()
}

/// A formula of M cars.
type Formula = fn(&Gains<Interval>, u64) -> Result<Interval, ArithmeticError>;

/// A constant, of the precision of a number.
type Constant = fn(&Interval) -> Result<Interval, ArithmeticError>;

/// The expansion of both proofs, as exact power series in `a`: with `theta = x - iy = sqrt2 a H`,
/// `H = 1 + a²/12 - 3c²/8 - i (c/2)(1 + a²/4 - 5c²/8) + O(a⁴)`, `c = ab`, `cos theta` is `gamma = 1 - a²/(1 + ic)` up to `O(a⁶)`.
struct Expansion;

/// Coefficients that are compared: up to `a⁵`.
const ORDER: usize = 6;

impl RationalIdentity for Expansion {
    fn variables(&self) -> usize {
        1
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [b] = at else { return Err(ArithmeticError::Domain("one variable")) };
        let real = |p, q| Complex::real(b.ratio(p, q));
        let a = Series::variable(real(1, 1), ORDER);
        let ic = Series::variable(Complex::new(b.zero(), b.clone()), ORDER);
        let (s, c2) = (a.square(), -ic.square());
        let bracket = |first: (i64, i64), second: (i64, i64)| {
            s.one() + s.scale(&real(first.0, first.1)) - c2.scale(&real(second.0, second.1))
        };
        let h = bracket((1, 12), (3, 8)) - ic.scale(&real(1, 2)) * bracket((1, 4), (5, 8));
        // cos(sqrt2 a H) = 1 - (aH)² + (aH)⁴/6 - ...
        let square = (a * h).square();
        let cosine = s.one() - &square + square.square().scale(&real(1, 6));
        let gamma = s.one() - s.clone() * (s.one() + ic).recip()?;
        let split = |series: Series<Complex<T>>| {
            series.coefficients().iter().flat_map(|z| [z.re.clone(), z.im.clone()]).collect::<Vec<T>>()
        };
        Ok((split(cosine), split(gamma)))
    }
}

/// One of the two claims: beyond.veerman.resonance_frequency, beyond.veerman.resonance_amplitude.
pub struct NextOrder {
    id: &'static str,
    name: &'static str,
    statement: &'static str,
    derivation: &'static str,
    found: fn(Resonance) -> Interval,
    leading: Formula,
    next: Formula,
    bound: (i64, i64),
    /// `power` such that `M^power (found - leading)` tends to a constant, and that constant for f = g = -1.
    limit: (u64, Constant),
}

/// Enclosures against the formula, from the smallest size of the statement on.
fn examine(part: &NextOrder, variant: &NextOrderVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut cases = 0;
    let mut worst: Option<Interval> = None;
    for exact in gains_list() {
        let smallest = smallest_size(&exact)?;
        let mut sizes = vec![smallest, smallest + 1, 2 * smallest, 7 * smallest, 100 * smallest, 10_000 * smallest];
        if run.cases(0, 1) == 1 {
            sizes.extend(smallest..smallest + 60);
        }
        for m in sizes {
            run.checkpoint()?;
            let found = (part.found)(resonance(&exact, m, DIGITS)?);
            let gains = exact.map(|q| Interval::from_rational(q, found.precision()));
            let size = m.saturating_add_signed(variant.offset);
            let (leading, next) = ((part.leading)(&gains, size)?, (part.next)(&gains, size)?);
            let correction = (next - &leading) * leading.ratio(variant.correction.0, variant.correction.1);
            let relative = (found - &leading - correction).over(&leading)?;
            // In units of (a0 max(1, b))^4.
            let b2 = next_order::relative_damping_square(&gains)?;
            let larger = if (b2.clone() - b2.one()).is_certainly_positive() { b2.clone() } else { b2.one() };
            let unit = (next_order::square_of_leading(&b2, m)? * larger).square();
            let scaled = relative.over(&unit)?;
            let limit = rational(part.bound.0 * variant.bound.0, part.bound.1 * variant.bound.1);
            let (lo, hi) = scaled.to_rationals();
            cases += 1;
            if lo < -limit.clone() || hi > limit {
                return Ok(Outcome::fails(
                    format!(
                        "f = {}, g = {}, {m} followers: the relative error of the {} is {} (a0 max(1, b))^4",
                        exact.f,
                        exact.g,
                        part.name,
                        interval_value(&scaled, 6)
                    ),
                    Evidence::new(Grade::Certified, part.name, "enclosures of the true resonance"),
                ));
            }
            if worst.as_ref().is_none_or(|w| w.magnitude() < scaled.magnitude()) {
                worst = Some(scaled);
            }
        }
    }
    if let Some(worst) = worst {
        run.value("largest_error_met_in_units_of_the_fourth_power", interval_value(&worst, 6));
    }
    let detail = "proof in notes/veerman_next_order.md for all f, g < 0 and M >= 5 max(1, b); enclosures for five pairs (f, g), b from 1/1000 to 20, and \
                  sizes from the smallest to 10^4 times that";
    let enclosures = Outcome::Holds(vec![Evidence::new(Grade::Certified, part.name, detail).cases(cases)]);
    let expansion = run.identity(&Expansion, &["b"], "the expansions of x and y in a, exact power series");
    Run::all([Ok(enclosures), expansion])
}

/// The least integer M with `M >= 5 max(1, b)`, from `M² |f| >= 25 g²`.
fn smallest_size(gains: &Gains<Rational>) -> Result<u64, CheckError> {
    let ratio = (gains.g.square() * rational(25, 1)).over(&-gains.f.clone())?;
    let mut m = next_order::SMALLEST_SIZE;
    while rational(m as i64, 1).square() < ratio {
        m += 1;
    }
    Ok(m)
}

/// beyond.veerman.resonance_frequency.
pub const FREQUENCY: NextOrder = NextOrder {
    id: "beyond.veerman.resonance_frequency",
    name: "frequency",
    statement: "For all f, g < 0 and M = N + 1 >= 5 max(1, b), b = |g|/sqrt|f|, the main resonance of system (2) lies at \
                w = w_0 (1 - a0^2 (1/12 + b^2/8) + e), w_0 = sqrt|f| a0, a0 = pi/(2 sqrt(2) M), with \
                |e| <= 1.7 (a0 max(1, b))^4.",
    derivation: "With gamma = cos(x - iy): x = sqrt2 a (1 + a²/12 - 3a²b²/8 + O(4)) and y = (a² b/sqrt2)(1 + a²/4 - 5a²b²/8 + O(4)). The resonance has \
                 Mx = pi/2 - delta, 2 delta = (pi/2)(a/a0) a² b² (1 + O(2)). Together a/a0 = 1/(1 + a²/12 + a²b²/8 + r), |r| <= 1.2 (a max(1, b))^4. All remainders are \
                 bounded in notes/veerman_next_order.md.",
    found: |resonance| resonance.omega,
    leading: theorem1::frequency,
    next: next_order::frequency,
    bound: next_order::FREQUENCY_BOUND,
    limit: (3, |one| {
        // -(pi³/(16 sqrt2)) (1/12 + 1/8).
        (one.pi().power(3) * one.ratio(-5, 24)).over(&(one.integer(16) * one.integer(2).sqrt()?))
    }),
};

/// beyond.veerman.resonance_amplitude.
pub const AMPLITUDE: NextOrder = NextOrder {
    id: "beyond.veerman.resonance_amplitude",
    name: "amplitude",
    statement: "For all f, g < 0 and M = N + 1 >= 5 max(1, b), b = |g|/sqrt|f|, the peak of system (2) is \
                A = A_0 (1 - a0^2 (1/12 - 3 b^2/8 + pi^2 b^2/96) + e), A_0 = 8 sqrt(2) M/(pi^2 b), a0 = pi/(2 sqrt(2) M), with \
                |e| <= 11 (a0 max(1, b))^4. So M (A - A_0) -> sqrt(2) (b (36 - pi^2)/96 - 1/(12 b)).",
    derivation: "1/A² = sin² delta + sinh²(My) with delta and y of beyond.veerman.resonance_frequency: relative to 1/A_0² the terms of order a0² are b² from \
                 delta, 1/2 - 5b²/4 from y, -1/3 - b²/2 from the shift of a, and pi² b²/48 from sinh. Their sum is 1/6 - 3b²/4 + pi² b²/48, and the \
                 amplitude has minus half of it. All remainders are bounded in notes/veerman_next_order.md.",
    found: |resonance| resonance.amplitude,
    leading: theorem1::amplitude,
    next: next_order::amplitude,
    bound: next_order::AMPLITUDE_BOUND,
    limit: (1, |one| {
        let constant = (one.integer(36) - one.pi().square()) * one.ratio(1, 96) - one.ratio(1, 12);
        Ok(constant * one.integer(2).sqrt()?)
    }),
};

impl Claim for NextOrder {
    type Variant = NextOrderVariant;

    fn id(&self) -> &str {
        self.id
    }

    fn source(&self) -> Option<Source> {
        Some(Source { place: "sharpens veerman, Theorem 1".to_string(), statement: self.statement.to_string() })
    }

    fn derivation(&self) -> &str {
        self.derivation
    }

    fn printed(&self) -> NextOrderVariant {
        PRINTED
    }

    fn controls(&self) -> Vec<Control<NextOrderVariant>> {
        controls()
    }

    fn examine(&self, variant: &NextOrderVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        const LARGE: u64 = 1_000_000;
        let found = (self.found)(resonance(&Gains { f: rational(-1, 1), g: rational(-1, 1) }, LARGE, DIGITS)?);
        let gains = Gains { f: found.integer(-1), g: found.integer(-1) };
        let (power, limit) = self.limit;
        let scaled = (found - (self.leading)(&gains, LARGE)?) * gains.f.integer(LARGE as i64).power(power);
        run.value(&format!("M^{power}_(found_-_Theorem_1)_f_g_-1_M_{LARGE}"), interval_value(&scaled, 10));
        run.value("its_limit", interval_value(&limit(&gains.f.one())?, 10));
        examine(self, variant, run)
    }
}
