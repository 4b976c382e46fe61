//! veerman.cor1, veerman.cor1_special, veerman.cor1.proof, veerman.gain_iff, veerman.gain_max: tracking only the car in
//! front.

use arithmetic::identity::RationalIdentity;
use arithmetic::{ArithmeticError, Complex, Field, Interval, Rational, Real, Ring, Signed, rational};
use ledger::{CheckError, Claim, Control, Evidence, Fault, Grade, Outcome, Repair, Run, interval_value};
use models::platoon::{
    Communication, Gains, accelerations, amplitude_one_sided, gain_squared_one_sided, strongest_one_sided_square,
};

/// Whether the first two variables, `f` and `g`, are negative and the third one, `w`, is positive.
pub(super) fn negative_gains(at: &[Rational]) -> bool {
    matches!(at, [f, g, w, ..] if f.is_certainly_negative() && g.is_certainly_negative() && w.is_certainly_positive())
}

/// Real and imaginary parts, one after the other.
fn parts<T>(numbers: impl IntoIterator<Item = Complex<T>>) -> Vec<T> {
    numbers.into_iter().flat_map(|z| [z.re, z.im]).collect()
}

fn complex_gains<T: Ring>(f: &T, g: &T) -> Gains<Complex<T>> {
    Gains { f: Complex::real(f.clone()), g: Complex::real(g.clone()) }
}

fn imaginary<T: Ring>(x: &T) -> Complex<T> {
    Complex::new(x.zero(), x.clone())
}

/// veerman.cor1.
pub struct Response;

/// `gamma = (f + damping_sign i w g + square_sign w²)/(f + damping_sign i w g)`, `a_k = gamma^(-k + offset)` or its
/// inverse.
#[derive(Clone, Copy)]
pub struct ResponseVariant {
    damping_sign: i64,
    square_sign: i64,
    inverse: bool,
    offset: u64,
}

/// The amplitudes of the first cars satisfy equation (1).
struct SatisfiesEquation1(ResponseVariant);

const CARS: u64 = 4;

impl RationalIdentity for SatisfiesEquation1 {
    fn variables(&self) -> usize {
        3
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [f, g, w] = at else { return Err(ArithmeticError::Domain("three variables")) };
        let ratio = self.0.ratio(f, g, w)?;
        let amplitudes: Vec<Complex<T>> = (1..=CARS).map(|k| ratio.power(k + self.0.offset)).collect();
        let iw = imaginary(w);
        let rates: Vec<Complex<T>> = amplitudes.iter().map(|a| a.clone() * &iw).collect();
        let forces = accelerations(Communication::Front, &complex_gains(f, g), (&iw.one(), &iw), &amplitudes, &rates);
        let second_rates = rates.iter().map(|u| u.clone() * &iw);
        Ok((parts(second_rates), parts(forces)))
    }

    fn in_domain(&self, at: &[Rational]) -> bool {
        negative_gains(at)
    }
}

/// One step of the recurrence, from any amplitude in front: with the first cars it proves all.
struct StepOfEquation1(ResponseVariant);

impl RationalIdentity for StepOfEquation1 {
    fn variables(&self) -> usize {
        5
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [f, g, w, re, im] = at else { return Err(ArithmeticError::Domain("five variables")) };
        let front = Complex::new(re.clone(), im.clone());
        let iw = imaginary(w);
        let own = front.clone() * self.0.ratio(f, g, w)?;
        let rate = own.clone() * &iw;
        let force = accelerations(
            Communication::Front,
            &complex_gains(f, g),
            (&front, &(front.clone() * &iw)),
            std::slice::from_ref(&own),
            std::slice::from_ref(&rate),
        );
        Ok((parts([rate * iw]), parts(force)))
    }

    fn in_domain(&self, at: &[Rational]) -> bool {
        negative_gains(at)
    }
}

impl ResponseVariant {
    /// `a_k/a_{k-1}` as claimed.
    fn ratio<T: Field>(&self, f: &T, g: &T, w: &T) -> Result<Complex<T>, ArithmeticError> {
        let z = Complex::new(f.clone(), f.integer(self.damping_sign) * g * w);
        let numerator = z.clone() + Complex::real(f.integer(self.square_sign) * w.square());
        if self.inverse { z.over(&numerator) } else { numerator.over(&z) }
    }
}

impl Claim for Response {
    type Variant = ResponseVariant;

    fn id(&self) -> &str {
        "veerman.cor1"
    }

    fn derivation(&self) -> &str {
        "x_k is read as the deviation x_k - h_k, as in equation (3), and w >= 0. Put a_k e^{iwt} and its derivative \
         i w a_k e^{iwt} into equation (1): -w² a_k = (f + i w g)(a_k - a_{k-1}), so \
         a_k (f + i w g + w²) = (f + i w g) a_{k-1}. For f, g < 0 neither factor vanishes. The step from a_{k-1} to a_k is the same for every k and is tested for any a_{k-1}."
    }

    fn printed(&self) -> ResponseVariant {
        ResponseVariant { damping_sign: 1, square_sign: 1, inverse: true, offset: 0 }
    }

    fn controls(&self) -> Vec<Control<ResponseVariant>> {
        let printed = self.printed();
        vec![
            Control::new("- w² in gamma", ResponseVariant { square_sign: -1, ..printed }),
            Control::new("- i w g in gamma", ResponseVariant { damping_sign: -1, ..printed }),
            Control::new("a_k = gamma^k", ResponseVariant { inverse: false, ..printed }),
            Control::new("a_k = gamma^-(k+1)", ResponseVariant { offset: 1, ..printed }),
        ]
    }

    fn examine(&self, variant: &ResponseVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let names = ["f", "g", "w", "Re a_{k-1}", "Im a_{k-1}"];
        Run::all([
            run.identity(&SatisfiesEquation1(*variant), &names[..3], "equation (1) for the first four cars, a_0 = 1"),
            run.identity(&StepOfEquation1(*variant), &names, "equation (1) for a_k = a_{k-1}/gamma, any k and a_{k-1}"),
        ])
    }
}

/// veerman.cor1_special.
pub struct SpecialResponse;

/// `a_k = (1 + sign i sqrt|f|/g)^k` at `w² = |f|`, or with the power of the root and the gains exchanged.
#[derive(Clone, Copy)]
pub struct SpecialVariant {
    sign: i64,
    exchanged: bool,
}

struct AtSpecialFrequency(SpecialVariant);

impl RationalIdentity for AtSpecialFrequency {
    fn variables(&self) -> usize {
        2
    }

    /// Variables `r = sqrt|f| = w` and `g`; so `f = -r²`.
    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [r, g] = at else { return Err(ArithmeticError::Domain("two variables")) };
        let gains = Gains { f: -r.square(), g: g.clone() };
        let quotient = if self.0.exchanged { g.over(r)? } else { r.over(g)? };
        let ratio = Complex::new(r.one(), r.integer(self.0.sign) * quotient);
        let printed = (1..=CARS).map(|k| ratio.power(k));
        let true_ones: Vec<Complex<T>> =
            (1..=CARS).map(|k| amplitude_one_sided(&gains, r, k)).collect::<Result<_, _>>()?;
        // At the negative root the amplitudes are the conjugates.
        let at_negative: Vec<Complex<T>> =
            (1..=CARS).map(|k| Ok(amplitude_one_sided(&gains, &-r.clone(), k)?.conj())).collect::<Result<_, _>>()?;
        let printed: Vec<Complex<T>> = printed.collect();
        Ok(([parts(true_ones), parts(at_negative)].concat(), [parts(printed.clone()), parts(printed)].concat()))
    }
}

impl Claim for SpecialResponse {
    type Variant = SpecialVariant;

    fn id(&self) -> &str {
        "veerman.cor1_special"
    }

    fn derivation(&self) -> &str {
        "With f = -w², 1/gamma = (f + i w g)/(i w g) = 1 + f/(i w g) = 1 + i w/g. A frequency is read as w >= 0, because \
         the leader moves as cos w t, so w² = |f| means w = +sqrt|f|; at w = -sqrt|f| the amplitudes are the conjugates, which is \
         tested too."
    }

    fn printed(&self) -> SpecialVariant {
        SpecialVariant { sign: 1, exchanged: false }
    }

    fn controls(&self) -> Vec<Control<SpecialVariant>> {
        vec![
            Control::new("1 - i sqrt|f|/g", SpecialVariant { sign: -1, exchanged: false }),
            Control::new("1 + i g/sqrt|f|", SpecialVariant { sign: 1, exchanged: true }),
            Control::new("1 + 2 i sqrt|f|/g", SpecialVariant { sign: 2, exchanged: false }),
        ]
    }

    fn examine(&self, variant: &SpecialVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        run.identity(
            &AtSpecialFrequency(*variant),
            &["sqrt|f|", "g"],
            "a_1, ..., a_4 at w = +sqrt|f|, and their conjugates at w = -sqrt|f|",
        )
    }
}

/// veerman.cor1.proof.
pub struct Substitution;

/// What is substituted: `u_k = factor i w`, times `a_k` or not; `a_k` for `x_k - h_k` or for `x_k`. The common factor
/// `e^{iwt}` is left out (it is 1 at t = 0).
#[derive(Clone, Copy)]
pub struct SubstitutionVariant {
    factor: i64,
    with_amplitude: bool,
    of_deviation: bool,
}

struct GivesPrintedEquation(SubstitutionVariant);

impl RationalIdentity for GivesPrintedEquation {
    fn variables(&self) -> usize {
        9
    }

    fn components(&self) -> Vec<String> {
        let named = |what: &str| [format!("the real part of {what}"), format!("the imaginary part of {what}")];
        ["the left side of (1)", "the right side of (1)", "the derivative of x_k"].into_iter().flat_map(named).collect()
    }

    /// Variables f, g, w, the complex amplitudes `a_{k-1}`, `a_k` and the desired positions. The substitution must turn
    /// both sides of equation (1) into the printed ones and agree with `x' = u`.
    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [f, g, w, front_re, front_im, own_re, own_im, front_place, own_place] = at else {
            return Err(ArithmeticError::Domain("nine variables"));
        };
        let front = Complex::new(front_re.clone(), front_im.clone());
        let own = Complex::new(own_re.clone(), own_im.clone());
        let deviation = |a: &Complex<T>, place: &T| {
            if self.0.of_deviation { a.clone() } else { a.clone() - Complex::real(place.clone()) }
        };
        let (front_deviation, own_deviation) = (deviation(&front, front_place), deviation(&own, own_place));
        let iw = imaginary(w);
        let rate = |a: &Complex<T>| {
            let base = iw.clone() * iw.integer(self.0.factor);
            if self.0.with_amplitude { base * a } else { base }
        };
        let (front_rate, own_rate) = (rate(&front), rate(&own));
        let force = accelerations(
            Communication::Front,
            &complex_gains(f, g),
            (&front_deviation, &front_rate),
            std::slice::from_ref(&own_deviation),
            std::slice::from_ref(&own_rate),
        );
        let difference = own.clone() - &front;
        let printed_force = difference.scale(f) + iw.clone() * difference.scale(g);
        let left = [own_rate.clone() * &iw].into_iter().chain(force).chain([own.clone() * &iw]);
        let right = [-own.scale(&w.square()), printed_force, own_rate];
        Ok((parts(left), parts(right)))
    }

    fn in_domain(&self, at: &[Rational]) -> bool {
        negative_gains(at)
    }
}

impl Claim for Substitution {
    type Variant = SubstitutionVariant;

    fn id(&self) -> &str {
        "veerman.cor1.proof"
    }

    fn derivation(&self) -> &str {
        "u_k is the derivative of x_k = a_k e^{iwt}, that is i w a_k e^{iwt}. The printed u_k = i w e^{iwt} lacks a_k; with \
         it u_k - u_{k-1} would be zero and the left side -w². And a_k e^{iwt} stands for the deviation x_k - h_k (the paper's \
         z = x - h), since equation (1) contains the desired positions. The resulting equation is the right one."
    }

    fn printed(&self) -> SubstitutionVariant {
        SubstitutionVariant { factor: 1, with_amplitude: false, of_deviation: false }
    }

    fn repair(&self) -> Option<Repair<SubstitutionVariant>> {
        Some(Repair {
            fault: Fault::Slip,
            clauses: Vec::new(),
            statement: "Substituting x_k - h_{x,k} = a_k e^{i w t} and u_k = i w a_k e^{i w t} in Equation (1) gives \
                        - w^2 a_k = f (a_k - a_{k-1}) + i w g (a_k - a_{k-1})."
                .to_string(),
            variant: SubstitutionVariant { factor: 1, with_amplitude: true, of_deviation: true },
        })
    }

    fn controls(&self) -> Vec<Control<SubstitutionVariant>> {
        let repaired = SubstitutionVariant { factor: 1, with_amplitude: true, of_deviation: true };
        vec![
            Control::new("u_k = - i w a_k e^{iwt}", SubstitutionVariant { factor: -1, ..repaired }),
            Control::new("u_k = 2 i w a_k e^{iwt}", SubstitutionVariant { factor: 2, ..repaired }),
            Control::new("u_k = i w e^{iwt}", SubstitutionVariant { with_amplitude: false, ..repaired }),
            Control::new("x_k = a_k e^{iwt}, not x_k - h_k", SubstitutionVariant { of_deviation: false, ..repaired }),
        ]
    }

    fn examine(&self, variant: &SubstitutionVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let names = ["f", "g", "w", "Re a_{k-1}", "Im a_{k-1}", "Re a_k", "Im a_k", "h_{k-1}", "h_k"];
        run.identity(&GivesPrintedEquation(*variant), &names, "both sides of equation (1), and u_k = x_k'")
    }
}

/// veerman.gain_iff.
pub struct GainAboveOne;

/// `|1/gamma| > 1` iff `w² < bound |f|` (or `<=`), for all `w >= 0` or for `w > 0`.
#[derive(Clone, Copy)]
pub struct GainVariant {
    bound: i64,
    zero_included: bool,
    bound_included: bool,
}

/// `(|1/gamma|² - 1) |gamma denominator|² = w² (bound |f| - w²)`.
struct GainFactors(i64);

impl RationalIdentity for GainFactors {
    fn variables(&self) -> usize {
        3
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [f, g, w] = at else { return Err(ArithmeticError::Domain("three variables")) };
        let y = w.square();
        let gains = Gains { f: f.clone(), g: g.clone() };
        let denominator = (f.clone() + &y).square() + g.square() * &y;
        let left = (gain_squared_one_sided(&gains, &y)? - f.one()) * denominator;
        let right = (-(f.integer(self.0) * f) - &y) * &y;
        Ok((vec![left], vec![right]))
    }

    fn in_domain(&self, at: &[Rational]) -> bool {
        negative_gains(at)
    }
}

impl Claim for GainAboveOne {
    type Variant = GainVariant;

    fn id(&self) -> &str {
        "veerman.gain_iff"
    }

    fn derivation(&self) -> &str {
        "(|1/gamma|² - 1) ((f + w²)² + g² w²) = w² (2|f| - w²), and the factor on the left is positive for f, g < 0. So \
         |1/gamma| > 1 exactly for 0 < w² < 2|f|. At w = 0 the car follows without amplification: |1/gamma| = 1, although \
         0 < 2|f|. A frequency is read as w >= 0, with 0 allowed: the text itself \
         treats w = 0 apart in Corollary 2."
    }

    fn printed(&self) -> GainVariant {
        GainVariant { bound: 2, zero_included: true, bound_included: false }
    }

    fn repair(&self) -> Option<Repair<GainVariant>> {
        Some(Repair {
            fault: Fault::Slip,
            clauses: Vec::new(),
            statement: "|gamma^{-1}| is greater than one if and only if 0 < w^2 < 2|f| (f, g < 0).".to_string(),
            variant: GainVariant { zero_included: false, ..self.printed() },
        })
    }

    fn controls(&self) -> Vec<Control<GainVariant>> {
        let repaired = GainVariant { zero_included: false, ..self.printed() };
        vec![
            Control::new("0 < w² < |f|", GainVariant { bound: 1, ..repaired }),
            Control::new("0 < w² < 4|f|", GainVariant { bound: 4, ..repaired }),
            Control::new("0 < w² <= 2|f|", GainVariant { bound_included: true, ..repaired }),
        ]
    }

    fn examine(&self, variant: &GainVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let factors = run.identity(
            &GainFactors(variant.bound),
            &["f", "g", "w"],
            "the sign of |1/gamma| - 1 is that of w² (2|f| - w²), for all f, g < 0",
        )?;
        let minus_one = Gains { f: rational(-1, 1), g: rational(-1, 1) };
        let gain = |y| Ok::<_, CheckError>(gain_squared_one_sided(&minus_one, &y)?);
        if variant.zero_included && gain(rational(0, 1))? <= rational(1, 1) {
            return Ok(Outcome::fails(
                "w = 0, any f, g < 0: w² = 0 < 2|f|, but gamma = 1 and |1/gamma| = 1 is not greater than one",
                Evidence::new(Grade::Exact, "w = 0", "gamma = 1 + w²/(f + i w g) = 1"),
            ));
        }
        let at_bound = Evidence::new(Grade::Exact, "w² = 2|f|", "f = g = -1: |1/gamma| = 1 exactly, not greater");
        let exceeds = gain(rational(2, 1))? > rational(1, 1);
        let tie = if exceeds == variant.bound_included {
            Outcome::Holds(vec![at_bound])
        } else {
            Outcome::fails("f = g = -1, w² = 2: |1/gamma| = 1", at_bound)
        };
        Run::all([Ok(factors), Ok(tie)])
    }
}

/// veerman.gain_max, and with the corrected location beyond.veerman.one_sided_peak.
pub struct StrongestGain;

/// Where `|1/gamma|` is claimed to be largest, as a multiple of `|f|` and of the true location `v`.
#[derive(Clone, Copy)]
pub struct StrongestVariant {
    pub(crate) of_f: (i64, i64),
    pub(crate) of_location: (i64, i64),
}

impl StrongestVariant {
    pub(crate) const TRUE_LOCATION: Self = StrongestVariant { of_f: (0, 1), of_location: (1, 1) };
}

/// With `|f| = v + 2u²` and `g = 2|f|u/v`, `v` is the positive root of `g² y² + 2f² y - 2|f|³ = 0`; every `f, g < 0`
/// arises so with `0 < v < |f|`. The identity says that `|1/gamma|²` at the claimed place exceeds it at `y` by a
/// non-negative multiple of the squared distance.
struct PerfectSquare(StrongestVariant);

impl RationalIdentity for PerfectSquare {
    fn variables(&self) -> usize {
        3
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [v, u, y] = at else { return Err(ArithmeticError::Domain("three variables")) };
        let size = v.clone() + v.integer(2) * u.square();
        let gains = Gains { f: -size.clone(), g: (v.integer(2) * &size * u).over(v)? };
        let multiple = |(p, q): (i64, i64), x: &T| x.ratio(p, q) * x;
        let place = multiple(self.0.of_f, &size) + multiple(self.0.of_location, v);
        let largest = gain_squared_one_sided(&gains, &place)?;
        let denominator = (y.clone() + &gains.f).square() + gains.g.square() * y;
        let left = (largest.clone() - gain_squared_one_sided(&gains, y)?) * denominator;
        Ok((vec![left], vec![largest * (y.clone() - place).square()]))
    }
}

/// The check of [`StrongestGain`], shared with the corrected statement.
pub(crate) fn examine_strongest(variant: &StrongestVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let square = run.identity(
        &PerfectSquare(*variant),
        &["v", "u", "y"],
        "largest at the claimed w² and nowhere else, for all f, g < 0 (|f| = v + 2u², g = -2|f|u/v)",
    )?;
    if let Outcome::Fails { .. } = square {
        let gains = Gains { f: rational(-1, 1), g: rational(-1, 1) };
        let (at_f, beside) =
            (gain_squared_one_sided(&gains, &rational(1, 1))?, gain_squared_one_sided(&gains, &rational(3, 4))?);
        let printed = variant.of_f == (1, 1) && variant.of_location == (0, 1) && beside > at_f;
        let counterexample = if printed {
            format!("f = g = -1: |1/gamma|² is {at_f} at w² = |f| = 1 and {beside} at w² = 3/4")
        } else {
            "the difference to the claimed maximum is not a perfect square".to_string()
        };
        return Ok(Outcome::fails(counterexample, Evidence::new(Grade::Exact, "the place", "compared exactly")));
    }
    let gains = Gains { f: rational(-1, 1), g: rational(-1, 1) }.map(|q| Interval::from_rational(q, 120));
    let peak = strongest_one_sided_square(&gains)?;
    let closed = peak.integer(3).sqrt()? - peak.one();
    run.value("w_squared_for_f_g_minus_1", interval_value(&peak, 20));
    run.value("gain_for_f_g_minus_1", interval_value(&gain_squared_one_sided(&gains, &peak)?.sqrt()?, 20));
    let instance = Evidence::new(Grade::Certified, "f = g = -1", "the root of the quadratic encloses sqrt(3) - 1");
    let agrees =
        if peak.overlaps(&closed) { Outcome::Holds(vec![instance]) } else { Outcome::fails("f = g = -1", instance) };
    Run::all([Ok(square), Ok(agrees)])
}

impl Claim for StrongestGain {
    type Variant = StrongestVariant;

    fn id(&self) -> &str {
        "veerman.gain_max"
    }

    fn derivation(&self) -> &str {
        "With y = w², |1/gamma|² = (f² + g² y)/((y - |f|)² + g² y). Its derivative vanishes where g² y² + 2 f² y = 2|f|³. At \
         y = |f| the left side exceeds the right one by g² f² > 0, so the maximum always lies below |f|. \
         That the root v is the only place of the maximum: max - value = max (y - v)²/((y - |f|)² + g² y)."
    }

    fn printed(&self) -> StrongestVariant {
        StrongestVariant { of_f: (1, 1), of_location: (0, 1) }
    }

    fn repair(&self) -> Option<Repair<StrongestVariant>> {
        Some(Repair {
            fault: Fault::False,
            clauses: Vec::new(),
            statement:
                "|gamma^{-1}| is strongest when w^2 = (f^2/g^2) (sqrt(1 + 2 g^2/|f|) - 1) (f, g < 0), which is always \
                        less than |f|; for f = g = -1 it is sqrt(3) - 1."
                    .to_string(),
            variant: StrongestVariant::TRUE_LOCATION,
        })
    }

    fn controls(&self) -> Vec<Control<StrongestVariant>> {
        vec![
            Control::new("half the root", StrongestVariant { of_f: (0, 1), of_location: (1, 2) }),
            Control::new("the mean of |f| and the root", StrongestVariant { of_f: (1, 2), of_location: (1, 2) }),
            Control::new("w² = 2|f|", StrongestVariant { of_f: (2, 1), of_location: (0, 1) }),
        ]
    }

    fn examine(&self, variant: &StrongestVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        examine_strongest(variant, run)
    }
}
