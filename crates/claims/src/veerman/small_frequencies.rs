//! veerman.cor2, veerman.lem3: without small frequencies there is no resonance in system (2).

use super::one_sided::negative_gains;
use arithmetic::identity::RationalIdentity;
use arithmetic::{ArithmeticError, Complex, Dual, Field, Interval, Rational, Real, Ring, Signed, rational};
use ledger::{CheckError, Claim, Control, Evidence, Grade, Outcome, Run, interval_value};
use models::platoon::{Gains, chebyshev, gamma};

/// Gains and frequencies at which the bounds are checked.
fn points() -> Vec<(Gains<Rational>, Rational)> {
    let gains = [((-1, 1), (-1, 1)), ((-4, 1), (-1, 3)), ((-1, 5), (-3, 1)), ((-1, 1), (-1, 1000))];
    let frequencies = [(1, 100), (1, 10), (1, 1), (7, 5), (20, 1)];
    let pair = |f: (i64, i64), g: (i64, i64)| Gains { f: rational(f.0, f.1), g: rational(g.0, g.1) };
    gains.iter().flat_map(|&(f, g)| frequencies.iter().map(move |w| (pair(f, g), rational(w.0, w.1)))).collect()
}

/// veerman.cor2.
pub struct ExponentialDecay;

/// `|mu_+| != |mu_-|` for `w != 0` (or for all w), and `|a_M| <= 2/(rho^{cM} - rho^{-cM})`, `rho = max |mu_+-|`.
#[derive(Clone, Copy)]
pub struct DecayVariant {
    zero_included: bool,
    rate: (u64, u64),
    /// `Im gamma (f² + w² g²) = sign g w³`.
    sign: i64,
}

/// `gamma` is not real: its imaginary part is `-g w³/(f² + w² g²)`; and `Im gamma` vanishes where `|mu| = 1`.
struct ImaginaryPart(DecayVariant);

impl RationalIdentity for ImaginaryPart {
    fn variables(&self) -> usize {
        5
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [f, g, w, mu_re, mu_im] = at else { return Err(ArithmeticError::Domain("five variables")) };
        let by_gains = gamma(&Gains { f: f.clone(), g: g.clone() }, w)?.im * (f.square() + (w.clone() * g).square());
        let mu = Complex::new(mu_re.clone(), mu_im.clone());
        let by_root = (mu.clone() + mu.recip()?).im * mu.norm_squared();
        let odd = g.integer(self.0.sign) * g * w.power(3);
        Ok((vec![by_gains, by_root], vec![odd, mu_im.clone() * (mu.norm_squared() - f.one())]))
    }

    fn in_domain(&self, at: &[Rational]) -> bool {
        negative_gains(at)
    }
}

/// `rho = e^y` with `cosh y = (|gamma + 1| + |gamma - 1|)/2`.
fn larger_root(gains: &Gains<Interval>, w: &Interval) -> Result<Interval, ArithmeticError> {
    let gamma = gamma(gains, w)?;
    let distance = |to: i64| (gamma.clone() - gamma.integer(to)).norm_squared().sqrt();
    let cosh = (distance(-1)? + distance(1)?).scaled(-1);
    Ok((cosh.square() - cosh.one()).sqrt()? + cosh)
}

impl Claim for ExponentialDecay {
    type Variant = DecayVariant;

    fn id(&self) -> &str {
        "veerman.cor2"
    }

    fn derivation(&self) -> &str {
        "mu_+ mu_- = 1, so equal moduli mean |mu_+| = 1; then gamma = (mu + 1/mu)/2 = Re mu is real. But Im gamma = -g w³/(f² + w² g²) \
         is not 0 for f, g < 0 and w != 0. With rho = max |mu_+-| > 1, which does not depend on N, |a_M| = 2/|mu_+^M + mu_-^M| lies between 2/(rho^M + rho^-M) and \
         2/(rho^M - rho^-M): exponential decay at the exact rate ln rho. (a_N read as the amplitude of the last car; that of its \
         predecessor is gamma times it.) At w = 0 both roots are 1 and a_N = 1."
    }

    fn printed(&self) -> DecayVariant {
        DecayVariant { zero_included: false, rate: (1, 1), sign: -1 }
    }

    fn controls(&self) -> Vec<Control<DecayVariant>> {
        let printed = self.printed();
        vec![
            Control::new("for w = 0 too", DecayVariant { zero_included: true, ..printed }),
            Control::new("a rate larger by 1/10", DecayVariant { rate: (11, 10), ..printed }),
            Control::new("the opposite sign of Im gamma", DecayVariant { sign: 1, ..printed }),
        ]
    }

    fn examine(&self, variant: &DecayVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let names = ["f", "g", "w", "Re mu", "Im mu"];
        let part = "Im gamma by the gains and by mu: |mu| = 1 only at w = 0";
        let parts = run.identity(&ImaginaryPart(*variant), &names, part);
        Run::all([parts, at_zero(variant), decay_bounds(variant, run)])
    }
}

/// At w = 0, gamma = 1 exactly and both roots are 1.
fn at_zero(variant: &DecayVariant) -> Result<Outcome, CheckError> {
    let gains = Gains { f: rational(-1, 1), g: rational(-1, 1) };
    let gamma = gamma(&gains, &rational(0, 1))?;
    let evidence = Evidence::new(Grade::Exact, "w = 0", "gamma = 1 and mu_+ = mu_- = 1, which the statement excludes");
    let equal = gamma == gamma.one();
    if variant.zero_included && equal {
        return Ok(Outcome::fails("w = 0: |mu_+| = |mu_-| = 1", evidence));
    }
    Ok(Outcome::Holds(vec![evidence]))
}

fn decay_bounds(variant: &DecayVariant, run: &Run) -> Result<Outcome, CheckError> {
    const PRECISION: u32 = 400;
    let mut cases = 0;
    for (gains, w) in points() {
        run.checkpoint()?;
        let interval = gains.map(|q| Interval::from_rational(q, PRECISION));
        let w_interval = Interval::from_rational(&w, PRECISION);
        let rho = larger_root(&interval, &w_interval)?;
        let distance = gamma(&interval, &w_interval)? - Complex::real(w_interval.one());
        for m in [1, 2, 3, 10, 100, 1000] {
            let inverse = chebyshev(m, &distance).0.norm_squared().sqrt()?;
            let power = rho.power(m);
            let claimed = {
                // rho^(pM/q) by logarithms.
                let (p, q) = variant.rate;
                if p == q { power.clone() } else { (rho.ln()? * rho.ratio((p * m) as i64, q as i64)).exp()? }
            };
            cases += 1;
            let at_most = |power: &Interval| Ok::<_, ArithmeticError>((power.clone() - power.recip()?).scaled(-1));
            let upper = inverse.clone() - at_most(&claimed)?;
            let lower = (power.clone() + power.recip()?).scaled(-1) - &inverse;
            // Ties are possible where the terms are parallel; they are decided up to 2^-64 of the value.
            let slack = inverse.scaled(-64);
            let violated = [upper, lower].iter().any(|gap| (gap.clone() + &slack).is_certainly_negative());
            if !(rho.clone() - rho.one()).is_certainly_positive() || violated {
                return Ok(Outcome::fails(
                    format!(
                        "f = {}, g = {}, w = {w}, {m} followers: 1/|a| = {}",
                        gains.f,
                        gains.g,
                        interval_value(&inverse, 8)
                    ),
                    Evidence::new(Grade::Certified, "decay", "enclosures of the response and of rho"),
                ));
            }
        }
    }
    let detail = "rho > 1 and (rho^M - rho^-M)/2 <= 1/|a_M| <= (rho^M + rho^-M)/2 up to a relative 2^-64, M up to 1000";
    Ok(Outcome::Holds(vec![Evidence::new(Grade::Certified, "decay at the rate ln rho", detail).cases(cases)]))
}

/// veerman.lem3.
pub struct OnlySmallFrequencies;

/// `|a_M(w)| Im(gamma(w)) M^power <= bound`.
#[derive(Clone, Copy)]
pub struct SmallVariant {
    bound: (i64, i64),
    power: u64,
}

/// The derivative of `Im gamma = b a³/(1 + b² a²)` is `b a² (3 + b² a²)/(1 + b² a²)²`, positive for `a, b > 0`.
struct Increasing;

impl RationalIdentity for Increasing {
    fn variables(&self) -> usize {
        2
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [a, b] = at else { return Err(ArithmeticError::Domain("two variables")) };
        let dual = |x: &T, slope: i64| Dual::new(x.clone(), x.integer(slope));
        let gains = Gains { f: dual(&-a.one(), 0), g: dual(&-b.clone(), 0) };
        let imaginary = gamma(&gains, &dual(a, 1))?.im;
        let c2 = (a.clone() * b).square();
        let claimed = (b.clone() * a.square() * (a.integer(3) + &c2)).over(&(c2.clone() + a.one()).square())?;
        Ok((vec![imaginary.derivative], vec![claimed]))
    }
}

impl Claim for OnlySmallFrequencies {
    type Variant = SmallVariant;

    fn id(&self) -> &str {
        "veerman.lem3"
    }

    fn derivation(&self) -> &str {
        "Read as: in large flocks only small frequencies are amplified, that is if |a_M(w_M)| >= A > 0 for all M then w_M -> 0. Made explicit: \
         |a_M(w)| <= 1/(M Im gamma(w)) for all f, g < 0, w > 0 and M >= 1. With gamma = cos(x - iy): \
         1/|a_M|² = cos²(Mx) + sinh²(My) >= (M sinh y)² >= (M sin x sinh y)² = (M Im gamma)². Im gamma = b a³/(1 + a² b²) (a = w/sqrt|f|, \
         b = |g|/sqrt|f|) is 0 at w = 0 and increases, so |a_M| >= A forces w below the root of Im gamma = 1/(AM), which tends to 0."
    }

    fn printed(&self) -> SmallVariant {
        SmallVariant { bound: (1, 1), power: 1 }
    }

    fn controls(&self) -> Vec<Control<SmallVariant>> {
        vec![
            Control::new("a bound smaller by 1/100", SmallVariant { bound: (99, 100), power: 1 }),
            Control::new("M² instead of M", SmallVariant { bound: (1, 1), power: 2 }),
        ]
    }

    fn examine(&self, variant: &SmallVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let mut cases = 0;
        for (gains, w) in points() {
            run.checkpoint()?;
            let gamma = gamma(&gains, &w)?;
            for m in [1u64, 2, 3, 5, 8, 20] {
                // Squared: F bound² >= M^{2 power} (Im gamma)², exactly.
                let inverse_square = chebyshev(m, &(gamma.clone() - gamma.one())).0.norm_squared();
                let bound = rational(variant.bound.0, variant.bound.1).square() * &inverse_square;
                cases += 1;
                if bound < (rational(m as i64, 1).power(variant.power) * &gamma.im).square() {
                    let size = Interval::from_rational(&inverse_square, 80).recip()?.sqrt()?;
                    return Ok(Outcome::fails(
                        format!(
                            "f = {}, g = {}, w = {w}, {m} followers: |a_M| is {}, Im gamma {}",
                            gains.f,
                            gains.g,
                            interval_value(&size, 8),
                            interval_value(&Interval::from_rational(&gamma.im, 80), 8)
                        ),
                        Evidence::new(Grade::Exact, "bound of the response", "compared exactly"),
                    ));
                }
            }
        }
        for m in [100, 10_000, 1_000_000] {
            run.value(&format!("w_above_which_nothing_is_amplified_f_g_-1_M_{m}"), interval_value(&threshold(m)?, 6));
        }
        let detail = "|a_M| M Im gamma <= 1 exactly; f, g < 0, frequencies from 1/100 to 20, up to 20 followers; proof in the derivation for all";
        let instances = Outcome::Holds(vec![Evidence::new(Grade::Exact, "bound of the response", detail).cases(cases)]);
        let increasing = run.identity(&Increasing, &["w/sqrt|f|", "|g|/sqrt|f|"], "Im gamma increases with w");
        Run::all([Ok(instances), increasing])
    }
}

/// The root of `a³/(1 + a²) = 1/M`, between two decimals found by bisection.
fn threshold(m: i64) -> Result<Interval, CheckError> {
    let beyond = |a: &Rational| a.power(3) * rational(m, 1) > rational(1, 1) + a.square();
    let (mut low, mut high) = (rational(0, 1), rational(2, 1));
    for _ in 0..40 {
        let middle = (&low + &high) / rational(2, 1);
        if beyond(&middle) { high = middle } else { low = middle }
    }
    Ok(Interval::hull_of_rationals(&low, &high, 60))
}
