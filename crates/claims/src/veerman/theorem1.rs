//! veerman.thm1_*: the main resonance of large platoons and the expansions in its proof.

use arithmetic::identity::RationalIdentity;
use arithmetic::{ArithmeticError, Complex, Field, Interval, Rational, Real, Ring, Series, Signed, rational};
use ledger::{CheckError, Claim, Control, Evidence, Fault, Grade, Outcome, Repair, Run, interval_value};
use models::platoon::{Gains, Resonance, chebyshev, gamma, resonance, theorem1};

pub(super) const DIGITS: u32 = 36;

/// The gains at which asymptotic statements are checked.
fn gains_list() -> [Gains<Rational>; 3] {
    let gains = |f: (i64, i64), g: (i64, i64)| Gains { f: rational(f.0, f.1), g: rational(g.0, g.1) };
    [gains((-1, 1), (-1, 1)), gains((-2, 1), (-1, 2)), gains((-1, 3), (-2, 1))]
}

/// Sizes M from `first` on in steps of 8: 32 to about 10^6 (10^9 with `--full`).
fn sizes(run: &Run, first: u64) -> Vec<u64> {
    (0..run.cases(6, 9) as u32).map(|k| first * 8u64.pow(k)).collect()
}

/// Certifies that `error(gains, M) M^order` stays bounded: from the smallest to the largest size it does not grow to
/// more than twice its size. An error of a lower order grows by a factor of 8 at least at every step.
fn scaled_error_is_bounded(
    run: &mut Run,
    name: &str,
    order: u64,
    error: impl Fn(&Gains<Rational>, u64) -> Result<Interval, CheckError>,
) -> Result<Outcome, CheckError> {
    scaled_error_is_bounded_from(32, run, name, order, "proof in notes/resonance.md", error)
}

/// The same from another smallest size on; `proof` says where the proof for all is.
pub(super) fn scaled_error_is_bounded_from(
    smallest: u64,
    run: &mut Run,
    name: &str,
    order: u64,
    proof: &str,
    error: impl Fn(&Gains<Rational>, u64) -> Result<Interval, CheckError>,
) -> Result<Outcome, CheckError> {
    let sizes = sizes(run, smallest);
    let mut cases = 0;
    for gains in gains_list() {
        let mut first: Option<Interval> = None;
        for &m in &sizes {
            run.checkpoint()?;
            let error = error(&gains, m)?;
            let scaled = error.clone() * error.integer(m as i64).power(order);
            cases += 1;
            let bound = first.get_or_insert_with(|| scaled.clone() + &scaled);
            if bound.magnitude() < scaled.magnitude() {
                return Ok(Outcome::fails(
                    format!(
                        "{name}, f = {}, g = {}: the error times M^{order} is {} for M = {} and {} for M = {m}",
                        gains.f,
                        gains.g,
                        interval_value(&bound.scaled(-1), 6),
                        sizes[0],
                        interval_value(&scaled, 6),
                    ),
                    Evidence::new(Grade::Certified, name, "enclosures of the true resonance"),
                ));
            }
            if gains.f == rational(-1, 1) && m == sizes[sizes.len() - 1] {
                run.value(&format!("{name}_error_times_M^{order}_at_f_g_-1_M_{m}"), interval_value(&scaled, 8));
            }
        }
    }
    let detail = format!(
        "{proof}; enclosures for M = {}, {}, ..., {} and three pairs (f, g): the error times M^{order} stays at \
         most twice its size at M = {}",
        sizes[0],
        sizes[1],
        sizes[sizes.len() - 1],
        sizes[0]
    );
    Ok(Outcome::Holds(vec![
        Evidence::new(Grade::Certified, format!("{name} up to O(M^-{order})"), detail).cases(cases),
    ]))
}

pub(super) fn enclosed(gains: &Gains<Rational>, m: u64) -> Result<(Resonance, Gains<Interval>), CheckError> {
    let found = resonance(gains, m, DIGITS)?;
    let precision = found.omega.precision();
    Ok((found, gains.map(|q| Interval::from_rational(q, precision))))
}

/// veerman.thm1_omega.
pub struct Frequency;

/// A printed leading term times a factor, for `M + offset` followers, with the order of its error.
#[derive(Clone, Copy)]
pub struct LeadingVariant {
    factor: (i64, i64),
    offset: i64,
    order: u64,
}

impl LeadingVariant {
    fn followers(&self, m: u64) -> u64 {
        m.saturating_add_signed(self.offset)
    }
}

/// What is altered in either leading term.
fn leading_controls(printed: LeadingVariant) -> Vec<Control<LeadingVariant>> {
    vec![
        Control::new("an error of the next order", LeadingVariant { order: printed.order + 1, ..printed }),
        Control::new("N instead of N + 1", LeadingVariant { offset: -1, ..printed }),
        Control::new("a coefficient larger by 1/1000", LeadingVariant { factor: (1001, 1000), ..printed }),
    ]
}

impl Claim for Frequency {
    type Variant = LeadingVariant;

    fn id(&self) -> &str {
        "veerman.thm1_omega"
    }

    fn derivation(&self) -> &str {
        "With a = w/sqrt|f|, b = |g|/sqrt|f| and gamma = cos(x - i y): x = sqrt2 a (1 + O(a²)), y = a² b/sqrt2 (1 + O(a²)). \
         F = cos²(Mx) + sinh²(My) is least where x' sin(2Mx) = y' sinh(2My), so Mx = pi/2 + O(M^-2), which gives \
         a = pi/(2 sqrt2 M) + O(M^-3). That this minimum is the main resonance is proved in notes/resonance.md for all \
         f, g < 0 and all M."
    }

    fn printed(&self) -> LeadingVariant {
        LeadingVariant { factor: (1, 1), offset: 0, order: 3 }
    }

    fn controls(&self) -> Vec<Control<LeadingVariant>> {
        leading_controls(self.printed())
    }

    fn examine(&self, variant: &LeadingVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let (p, q) = variant.factor;
        scaled_error_is_bounded(run, "omega", variant.order, |gains, m| {
            let (found, in_intervals) = enclosed(gains, m)?;
            let leading = theorem1::frequency(&in_intervals, variant.followers(m))?;
            Ok(found.omega - leading.ratio(p, q) * leading)
        })
    }
}

/// veerman.thm1_amp.
pub struct Amplitude;

impl Claim for Amplitude {
    type Variant = LeadingVariant;

    fn id(&self) -> &str {
        "veerman.thm1_amp"
    }

    fn derivation(&self) -> &str {
        "At the resonance F = cos²(Mx) + sinh²(My) with Mx = pi/2 + O(M^-2), so 1/sqrt F = 1/sinh(My) (1 + O(M^-2)), and \
         My = pi² b/(8 sqrt2 M) (1 + O(M^-2)): A = 8 sqrt(2|f|) M/(pi² |g|) + O(M^-1) (notes/resonance.md)."
    }

    fn printed(&self) -> LeadingVariant {
        LeadingVariant { factor: (1, 1), offset: 0, order: 1 }
    }

    fn controls(&self) -> Vec<Control<LeadingVariant>> {
        leading_controls(self.printed())
    }

    fn examine(&self, variant: &LeadingVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let (p, q) = variant.factor;
        scaled_error_is_bounded(run, "amplitude", variant.order, |gains, m| {
            let (found, in_intervals) = enclosed(gains, m)?;
            let leading = theorem1::amplitude(&in_intervals, variant.followers(m))?;
            Ok(found.amplitude - leading.ratio(p, q) * leading)
        })
    }
}

/// The exact expansion behind the proof: with `r = sqrt|f|`, `G = |g|` and series in `w`, `epsilon = sqrt(gamma² - 1) =
/// i sqrt2 (w/r) E(w)`; returns `gamma` and `E`.
fn expansion<T: Field>(r: &T, g: &T, order: usize) -> Result<[Series<Complex<T>>; 2], ArithmeticError> {
    let size = r.square();
    let constant = |z: Complex<T>| Series::constant(z, order);
    let w = Series::variable(Complex::real(r.one()), order);
    // q = 1 - gamma = w²/(|f| + i w |g|).
    let denominator =
        constant(Complex::real(size.clone())) + Series::variable(Complex::new(r.zero(), g.clone()), order);
    let inverse = denominator.recip()?;
    let q = w.square() * &inverse;
    // gamma² - 1 = -q (2 - q) = -2 (w²/|f|) S with S = |f|/(|f| + i w |g|) (1 - q/2).
    let half = Complex::real(r.ratio(1, 2));
    let s = inverse.scale(&Complex::real(size)) * (q.one() - q.scale(&half));
    Ok([q.one() - q, s.sqrt_of_unit()?])
}

/// veerman.thm1_eps.
pub struct Epsilon;

/// The second-order bracket `(w²/2)(damping g²/f² + stiffness/|f|)`, and how many coefficients of the bracket are
/// compared.
#[derive(Clone, Copy)]
pub struct EpsilonVariant {
    damping: (i64, i64),
    stiffness: (i64, i64),
    coefficients: usize,
}

struct Bracket(EpsilonVariant);

impl RationalIdentity for Bracket {
    fn variables(&self) -> usize {
        2
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [r, g] = at else { return Err(ArithmeticError::Domain("two variables")) };
        let [_, bracket] = expansion(r, g, self.0.coefficients)?;
        let size = r.square();
        let second = (g.ratio(self.0.damping.0, 2 * self.0.damping.1) * g.square()).over(&size.square())?
            + g.ratio(self.0.stiffness.0, 2 * self.0.stiffness.1).over(&size)?;
        let printed = [
            Complex::real(r.one()),
            Complex::new(r.zero(), (-g.clone()).over(&(size.clone() + &size))?),
            Complex::real(second),
            Complex::real(r.zero()),
        ];
        let split = |z: &Complex<T>| [z.re.clone(), z.im.clone()];
        Ok((
            bracket.coefficients().iter().flat_map(split).collect(),
            printed[..self.0.coefficients].iter().flat_map(split).collect(),
        ))
    }

    fn in_domain(&self, at: &[Rational]) -> bool {
        at.iter().all(Signed::is_certainly_positive)
    }

    fn components(&self) -> Vec<String> {
        (0..self.0.coefficients)
            .flat_map(|n| {
                ["real", "imaginary"].map(|part| format!("the {part} part of the coefficient of w^{n} in the bracket"))
            })
            .collect()
    }
}

impl Claim for Epsilon {
    type Variant = EpsilonVariant;

    fn id(&self) -> &str {
        "veerman.thm1_eps"
    }

    fn derivation(&self) -> &str {
        "epsilon² = gamma² - 1 = -(2w²/|f|) S with S = (1 + i w|g|/|f|)^-1 (1 - q/2). The square root of S = 1 + s_1 w + s_2 w² \
         is 1 + s_1 w/2 + (s_2/2 - s_1²/8) w²; the paper drops the term -s_1²/8 = g²/(8 f²). The coefficient is -3/4 g²/f², \
         not -g²/f². The error is O(w³) and does not change the theorem. For w > 0 the imaginary part of gamma² - 1 is positive and its \
         angle near pi, so the root with angle in (-pi/2, pi/2] is the one with +i."
    }

    fn printed(&self) -> EpsilonVariant {
        EpsilonVariant { damping: (-1, 1), stiffness: (-1, 2), coefficients: 3 }
    }

    fn repair(&self) -> Option<Repair<EpsilonVariant>> {
        Some(Repair {
            fault: Fault::Slip,
            clauses: Vec::new(),
            statement:
                "eps = i sqrt(2) (w/sqrt(|f|)) ( (1 - i w |g|/(2|f|)) + (w^2/2)(- (3/4) g^2/f^2 - 1/(2|f|)) ) + O(w^4)."
                    .to_string(),
            variant: EpsilonVariant { damping: (-3, 4), ..self.printed() },
        })
    }

    fn controls(&self) -> Vec<Control<EpsilonVariant>> {
        let repaired = EpsilonVariant { damping: (-3, 4), ..self.printed() };
        vec![
            Control::new("+ 3/4 g²/f²", EpsilonVariant { damping: (3, 4), ..repaired }),
            Control::new("- 1/|f|", EpsilonVariant { stiffness: (-1, 1), ..repaired }),
            Control::new("an error O(w^5)", EpsilonVariant { coefficients: 4, ..repaired }),
        ]
    }

    fn examine(&self, variant: &EpsilonVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        run.identity(&Bracket(*variant), &["sqrt|f|", "|g|"], "coefficients of the expansion, exact power series")
    }
}

/// veerman.thm1_mod.
pub struct Modulus;

/// `|mu_+-|² = 1 +- coefficient sqrt2 w² |g|/|f|^(power/2) + O(w^order)`.
#[derive(Clone, Copy)]
pub struct ModulusVariant {
    coefficient: i64,
    power: u64,
    order: usize,
}

struct SquaredModulus(ModulusVariant);

impl RationalIdentity for SquaredModulus {
    fn variables(&self) -> usize {
        2
    }

    /// `|mu_+-|² = A +- sqrt2 B` with `A = |gamma|² + |epsilon|²` and `sqrt2 B = 2 Re(conj(gamma) epsilon)`.
    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [r, g] = at else { return Err(ArithmeticError::Domain("two variables")) };
        let order = self.0.order;
        let [gamma, bracket] = expansion(r, g, order)?;
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
            *slot = (r.integer(self.0.coefficient) * g).over(&r.power(self.0.power))?;
        }
        let real = |series: &Series<Complex<T>>| series.coefficients().iter().map(|c| c.re.clone()).collect::<Vec<_>>();
        Ok(([real(&even), real(&odd)].concat(), expected))
    }

    fn in_domain(&self, at: &[Rational]) -> bool {
        at.iter().all(Signed::is_certainly_positive)
    }
}

impl Claim for Modulus {
    type Variant = ModulusVariant;

    fn id(&self) -> &str {
        "veerman.thm1_mod"
    }

    fn derivation(&self) -> &str {
        "|gamma +- epsilon|² = |gamma|² + |epsilon|² +- 2 Re(conj(gamma) epsilon). The first two terms sum to 1 + O(w⁴); the \
         last is sqrt2 w² |g|/|f|^(3/2) + O(w⁴). Exact power series in w; the faulty term of eps enters at w⁴ only. mu_+ is the root with the principal \
         square root, for w > 0 the one with +i (see veerman.thm1_eps)."
    }

    fn printed(&self) -> ModulusVariant {
        ModulusVariant { coefficient: 1, power: 3, order: 4 }
    }

    fn controls(&self) -> Vec<Control<ModulusVariant>> {
        let printed = self.printed();
        vec![
            Control::new("2 sqrt2", ModulusVariant { coefficient: 2, ..printed }),
            Control::new("the signs exchanged", ModulusVariant { coefficient: -1, ..printed }),
            Control::new("|f| instead of |f|^(3/2)", ModulusVariant { power: 2, ..printed }),
            Control::new("an error O(w^5)", ModulusVariant { order: 5, ..printed }),
        ]
    }

    fn examine(&self, variant: &ModulusVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        run.identity(&SquaredModulus(*variant), &["sqrt|f|", "|g|"], "coefficients of |mu|², exact power series")
    }
}

/// veerman.thm1_x.
pub struct Exponent;

/// `x = pi² |g|/(divisor sqrt2 |f|^(power/2))`.
#[derive(Clone, Copy)]
pub struct ExponentVariant {
    divisor: i64,
    power: u64,
    /// Order of the error of `|mu_+-|^(N+1)`.
    order: u64,
}

/// In units of pi² and squared: `2x/M²` is `sqrt2 w² |g|/|f|^(3/2)` at the frequency of Theorem 1, and `(N+1)/x` its
/// amplitude.
struct ExponentDefinition(ExponentVariant);

impl RationalIdentity for ExponentDefinition {
    fn variables(&self) -> usize {
        2
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [r, g] = at else { return Err(ArithmeticError::Domain("two variables")) };
        let x_squared =
            g.square().over(&(r.integer(2 * self.0.divisor * self.0.divisor) * r.power(2 * self.0.power)))?;
        // w² = |f| pi²/(8 M²); |f| = r².
        let from_modulus = (g.integer(2) * g.square() * r.power(4)).over(&(r.integer(64) * r.power(6)))?;
        let from_theorem = (r.integer(128) * r.square()).over(&g.square())?;
        Ok((vec![x_squared.clone() * x_squared.integer(4), x_squared.recip()?], vec![from_modulus, from_theorem]))
    }

    fn in_domain(&self, at: &[Rational]) -> bool {
        at.iter().all(Signed::is_certainly_positive)
    }
}

/// `|mu_+|^M = e^{My}` at the resonance, from `|T_M|² + |gamma² - 1| |U_{M-1}|² = 1 + 2 sinh²(My)`.
fn modulus_power(gains: &Gains<Interval>, w: &Interval, m: u64) -> Result<Interval, ArithmeticError> {
    let d = gamma(gains, w)? - Complex::real(w.one());
    let (t, u) = chebyshev(m, &d);
    let s2 = d.clone() * (d.one() + d.one() + d);
    let root = s2.norm_squared().sqrt()?;
    let double = t.norm_squared() + root * u.norm_squared() - w.one();
    let sinh = double.scaled(-1).sqrt()?;
    Ok((sinh.square() + w.one()).sqrt()? + sinh)
}

impl Claim for Exponent {
    type Variant = ExponentVariant;

    fn id(&self) -> &str {
        "veerman.thm1_x"
    }

    fn derivation(&self) -> &str {
        "|mu_+-|² = 1 +- sqrt2 w² |g|/|f|^(3/2) at w = sqrt|f| pi/(2 sqrt2 M) is 1 +- pi² |g|/(4 sqrt2 sqrt|f| M²), which is \
         1 +- 2x/M² for x = pi² |g|/(8 sqrt2 sqrt|f|). The printed |f| instead of sqrt|f| would also contradict the amplitude \
         of the theorem, M/x; for f = -1 the two agree."
    }

    fn printed(&self) -> ExponentVariant {
        ExponentVariant { divisor: 8, power: 2, order: 3 }
    }

    fn repair(&self) -> Option<Repair<ExponentVariant>> {
        Some(Repair {
            fault: Fault::Slip,
            clauses: Vec::new(),
            statement:
                "With x := pi^2 |g|/(8 sqrt(2) sqrt(|f|)), |mu_+-|^{N+1} = e^{+-x/(N+1)} + O(N^{-3}) at the principal \
                        resonance and A = |a_{N+1}| = (N+1)/x + O(N^{-1})."
                    .to_string(),
            variant: ExponentVariant { power: 1, ..self.printed() },
        })
    }

    fn controls(&self) -> Vec<Control<ExponentVariant>> {
        let repaired = ExponentVariant { power: 1, ..self.printed() };
        vec![
            Control::new("4 sqrt2 instead of 8 sqrt2", ExponentVariant { divisor: 4, ..repaired }),
            Control::new("|f|^(3/2)", ExponentVariant { power: 3, ..repaired }),
            Control::new("an error O(N^-4)", ExponentVariant { order: 4, ..repaired }),
        ]
    }

    fn examine(&self, variant: &ExponentVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let x_over_m = |gains: &Gains<Interval>, m: u64| -> Result<Interval, ArithmeticError> {
            let root = (-gains.f.clone()).sqrt()?.power(variant.power);
            let numerator = gains.f.pi().square() * -gains.g.clone();
            numerator.over(
                &(root * gains.f.integer(variant.divisor) * gains.f.integer(2).sqrt()? * gains.f.integer(m as i64)),
            )
        };
        let plus = scaled_error_is_bounded(run, "modulus_plus", variant.order, |gains, m| {
            let (found, intervals) = enclosed(gains, m)?;
            Ok(modulus_power(&intervals, &found.omega, m)? - x_over_m(&intervals, m)?.exp()?)
        })?;
        let minus = scaled_error_is_bounded(run, "modulus_minus", variant.order, |gains, m| {
            let (found, intervals) = enclosed(gains, m)?;
            Ok(modulus_power(&intervals, &found.omega, m)?.recip()? - (-x_over_m(&intervals, m)?).exp()?)
        })?;
        let amplitude = scaled_error_is_bounded(run, "amplitude", 1, |gains, m| {
            let (found, intervals) = enclosed(gains, m)?;
            Ok(found.amplitude - x_over_m(&intervals, m)?.recip()?)
        })?;
        let definition = run.identity(
            &ExponentDefinition(*variant),
            &["sqrt|f|", "|g|"],
            "2x/M² is the term of |mu|² at the frequency of Theorem 1, and (N+1)/x its amplitude",
        );
        Run::all([Ok(amplitude), Ok(plus), Ok(minus), definition])
    }
}
