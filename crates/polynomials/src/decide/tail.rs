//! What a function of one number is from some number on: a sum of scales with coefficients that are known exactly, or to lie between two numbers. Near a number
//! `c` it is the same in `t` with `x = c + 1/t` or `x = c - 1/t`: so ends without bound and places without derivatives are decided alike.

use super::Extended;
use super::exact::Exact;
use super::places::Place;
use super::scale::Scale;
use arithmetic::{ArithmeticError, Field, Number, Rational, Ring, Sign, Signed, operators, rational};
use std::cmp::Ordering;

/// Terms of the expansions of functions.
const ORDER: usize = 6;

/// More terms are brought together, the smallest ones first.
const MOST_TERMS: usize = 24;

/// What a scale is multiplied by: the same number for all `x`, or at each `x` one in an interval.
#[derive(Debug, Clone)]
enum Coefficient {
    Constant(Box<Exact>),
    Within(Extended),
}

impl Coefficient {
    fn constant(c: Exact) -> Self {
        Coefficient::Constant(Box::new(c))
    }

    fn enclosed(&self) -> Extended {
        match self {
            Coefficient::Constant(c) => c.enclosed(),
            Coefficient::Within(range) => *range,
        }
    }

    /// Two that belong to one `x`.
    fn with(&self, other: &Self, exact: fn(Exact, &Exact) -> Exact, of: fn(Extended, Extended) -> Extended) -> Self {
        match (self, other) {
            (Coefficient::Constant(a), Coefficient::Constant(b)) => Coefficient::constant(exact(a.as_ref().clone(), b)),
            _ => Coefficient::Within(of(self.enclosed(), other.enclosed())),
        }
    }

    fn plus(&self, other: &Self) -> Self {
        self.with(other, |a, b| a + b, |a, b| a + b)
    }

    fn times(&self, other: &Self) -> Self {
        self.with(other, |a, b| a * b, |a, b| a * b)
    }

    fn square(&self) -> Self {
        match self {
            Coefficient::Constant(c) => Coefficient::constant(c.square()),
            Coefficient::Within(range) => Coefficient::Within(range.square()),
        }
    }

    fn is_zero(&self) -> bool {
        match self {
            Coefficient::Constant(c) => c.sign() == Some(Sign::Zero),
            Coefficient::Within(range) => range.lo == 0.0 && range.hi == 0.0,
        }
    }
}

/// A function of `x` for all `x >= from`, which is above 1: the sum of its terms, by falling scales.
#[derive(Debug, Clone)]
pub(super) struct Tail {
    one: Exact,
    from: Extended,
    terms: Vec<(Scale, Coefficient)>,
}

/// A leading term `c s` and `e` in `c s (1 + e)`, with the enclosure of `e`.
struct Split {
    lead: (Scale, Coefficient),
    rest: Tail,
    range: Extended,
}

/// Where on a line a function is looked at, by a number `t` that grows without bound.
#[derive(Debug, Clone, Copy)]
pub(super) enum End<'a> {
    /// `x = t`.
    Above,
    /// `x = -t`.
    Below,
    /// `x = c + 1/t`.
    After(&'a Place),
    /// `x = c - 1/t`.
    Before(&'a Place),
}

impl End<'_> {
    /// The number `x`, for all `t >= from`.
    pub fn number(self, from: &Extended, one: &Exact) -> Option<Tail> {
        let near = |place: &Place, up: bool| {
            let apart = Tail::power_of_argument(rational(-1, 1), from, one);
            let at = Tail::constant(place.exactly(one)?, from, one);
            Some(if up { at + apart } else { at - apart })
        };
        let far = Tail::power_of_argument(rational(1, 1), from, one);
        match self {
            End::Above => Some(far),
            End::Below => Some(-far),
            End::After(place) => near(place, true),
            End::Before(place) => near(place, false),
        }
    }
}

fn open<T>() -> Result<T, ArithmeticError> {
    Err(ArithmeticError::UNDECIDED_SIGN)
}

impl Tail {
    /// A constant.
    pub fn constant(c: Exact, from: &Extended, one: &Exact) -> Self {
        Tail { one: one.clone(), from: *from, terms: Vec::new() }.made(vec![(Scale::one(), Coefficient::constant(c))])
    }

    /// `x^power`.
    pub fn power_of_argument(power: Rational, from: &Extended, one: &Exact) -> Self {
        let terms = vec![(Scale::power(power), Coefficient::constant(one.clone()))];
        Tail { one: one.clone(), from: *from, terms }
    }

    fn of(&self, c: Exact) -> Self {
        Tail::constant(c, &self.from, &self.one)
    }

    fn within(&self, range: Extended) -> Self {
        self.made(vec![(Scale::one(), Coefficient::Within(range))])
    }

    /// Terms of one scale are added; of too many the smallest ones.
    fn made(&self, terms: Vec<(Scale, Coefficient)>) -> Self {
        let mut own: Vec<(Scale, Coefficient)> = Vec::new();
        for (scale, c) in terms {
            match own.iter_mut().find(|known| known.0 == scale) {
                Some(known) => known.1 = known.1.plus(&c),
                None => own.push((scale, c)),
            }
        }
        own.retain(|(_, c)| !c.is_zero());
        own.sort_by(|a, b| b.0.over(&a.0).growth());
        while own.len() > MOST_TERMS {
            let (Some(last), Some(before)) = (own.pop(), own.pop()) else { break };
            // Where their quotient is not known to fall from here on the sum says nothing.
            let ratio = last.0.over(&before.0).enclosed(&self.from);
            let ratio = ratio.unwrap_or(Extended::between(0.0, f64::INFINITY));
            own.push((before.0, Coefficient::Within(before.1.enclosed() + last.1.enclosed() * ratio)));
        }
        Tail { terms: own, ..self.clone() }
    }

    fn plus(a: &Self, b: &Self) -> Self {
        a.made(a.terms.iter().chain(&b.terms).cloned().collect())
    }

    fn negated(a: &Self) -> Self {
        let minus = Coefficient::constant(-a.one.clone());
        Tail { terms: a.terms.iter().map(|(scale, c)| (scale.clone(), c.times(&minus))).collect(), ..a.clone() }
    }

    fn minus(a: &Self, b: &Self) -> Self {
        Tail::plus(a, &Tail::negated(b))
    }

    fn times(a: &Self, b: &Self) -> Self {
        let product = |(s, c): &(Scale, Coefficient), (t, d): &(Scale, Coefficient)| (s.times(t), c.times(d));
        a.made(a.terms.iter().flat_map(|own| b.terms.iter().map(move |other| product(own, other))).collect())
    }

    fn times_term(&self, (scale, c): &(Scale, Coefficient)) -> Self {
        self.made(self.terms.iter().map(|(s, d)| (s.times(scale), d.times(c))).collect())
    }

    /// Encloses all values.
    fn enclosed(&self) -> Option<Extended> {
        let one = |(scale, c): &(Scale, Coefficient)| Some(c.enclosed() * scale.enclosed(&self.from)?);
        self.terms.iter().try_fold(Extended::between(0.0, 0.0), |sum, term| Some(sum + one(term)?))
    }

    /// Whether it is at least 0 everywhere, and whether above 0; `None` where that is not known. Either the first term is at least 0 and so are the others, or it
    /// is so large that they cannot outweigh it.
    fn is_above(&self, terms: &[(Scale, Coefficient)]) -> Option<bool> {
        let Some(((scale, c), rest)) = terms.split_first() else { return Some(false) };
        let lead = c.enclosed();
        if lead.lo >= 0.0
            && let Some(strict) = self.is_above(rest)
        {
            return Some(strict || lead.lo > 0.0);
        }
        let relative = |(s, d): &(Scale, Coefficient)| Some(d.enclosed() * s.over(scale).enclosed(&self.from)?);
        let sum = rest.iter().try_fold(lead, |sum, term| Some(sum + relative(term)?))?;
        (sum.lo > 0.0).then_some(true)
    }

    /// Its leading term, other than 0 everywhere, and what it is multiplied by.
    fn split(&self) -> Option<Split> {
        let ((scale, c), rest) = self.terms.split_first()?;
        let inverse = match c {
            Coefficient::Constant(c) => Coefficient::constant(c.sign().and_then(|_| c.recip().ok())?),
            Coefficient::Within(range) => Coefficient::Within(range.recip().ok().filter(|inverse| inverse.defined)?),
        };
        let rest = Tail { terms: rest.to_vec(), ..self.clone() }.times_term(&(scale.raised(&rational(-1, 1)), inverse));
        let range = rest.enclosed()?;
        (range.lo > -1.0).then(|| Split { lead: (scale.clone(), c.clone()), rest, range })
    }

    /// `sum a_k e^k`, with the enclosure of what the last power is multiplied by.
    fn expanded(&self, coefficients: &[Exact], remainder: Extended) -> Self {
        let Some(first) = coefficients.first() else { return self.within(remainder) };
        let (mut sum, mut power) = (self.of(first.clone()), self.of(self.one.clone()));
        if self.terms.is_empty() {
            return sum;
        }
        for a in &coefficients[1..] {
            power = power * self;
            sum = sum + power.times_term(&(Scale::one(), Coefficient::constant(a.clone())));
        }
        power = power * self;
        sum + power.times_term(&(Scale::one(), Coefficient::Within(remainder)))
    }

    /// `(1 + e)^q` by its binomial series, with Lagrange's remainder.
    fn binomial(&self, q: &Rational, range: Extended) -> Result<Self, ArithmeticError> {
        let mut coefficients = vec![rational(1, 1)];
        for k in 0..ORDER as i64 {
            let last = coefficients[k as usize].clone();
            coefficients.push(last * (q - rational(k, 1)) / rational(k + 1, 1));
        }
        let last = coefficients.pop().unwrap_or_else(|| rational(0, 1));
        let base = with_zero(range) + Extended::between(1.0, 1.0);
        let power = (base.ln()? * Extended::of(&(q - rational(ORDER as i64, 1)))).exp()?;
        let exact: Vec<Exact> = coefficients.iter().map(|c| self.one.rational(c)).collect();
        Ok(self.expanded(&exact, power * Extended::of(&last)))
    }

    /// The power `q` of what is above 0, or of anything where `q = -1`.
    fn raised(
        &self,
        q: &Rational,
        exact: impl Fn(&Exact) -> Result<Exact, ArithmeticError>,
        of: impl Fn(&Extended) -> Result<Extended, ArithmeticError>,
    ) -> Result<Self, ArithmeticError> {
        let whole = || -> Option<Tail> {
            let split = self.split()?;
            let lead = match &split.lead.1 {
                Coefficient::Constant(c) => Coefficient::constant(exact(c).ok()?),
                Coefficient::Within(range) => Coefficient::Within(of(range).ok().filter(|value| value.defined)?),
            };
            Some(split.rest.binomial(q, split.range).ok()?.times_term(&(split.lead.0.raised(q), lead)))
        };
        whole().map_or_else(|| self.by_range(of), Ok)
    }

    /// By the enclosure alone.
    fn by_range(&self, of: impl Fn(&Extended) -> Result<Extended, ArithmeticError>) -> Result<Self, ArithmeticError> {
        let Some(range) = self.enclosed() else { return open() };
        let value = of(&range)?;
        if value.defined && !value.is_empty() { Ok(self.within(value)) } else { open() }
    }

    /// The terms that grow, that do neither, and that fall to 0.
    fn parts(&self) -> [Tail; 3] {
        [Ordering::Greater, Ordering::Equal, Ordering::Less].map(|growth| {
            let terms = self.terms.iter().filter(|(scale, _)| scale.growth() == growth).cloned().collect();
            Tail { terms, ..self.clone() }
        })
    }

    /// The constant that it is; `None` where it changes.
    fn as_constant(&self) -> Option<Exact> {
        match &self.terms[..] {
            [] => Some(self.one.zero()),
            [(scale, Coefficient::Constant(c))] if scale.growth() == Ordering::Equal => Some(c.as_ref().clone()),
            _ => None,
        }
    }

    /// `exp` of terms that grow, as a scale.
    fn exponential_scale(&self) -> Option<Scale> {
        let mut whole = Scale::one();
        for (scale, c) in &self.terms {
            let Coefficient::Constant(c) = c else { return None };
            whole = whole.times(&scale.exponential(&c.as_rational()?)?);
        }
        Some(whole)
    }

    fn expanded_exp(&self) -> Option<Self> {
        let [growing, constant, falling] = self.parts();
        let scale = growing.exponential_scale()?;
        let lead = match constant.as_constant() {
            Some(c) => Coefficient::constant(c.exp().ok()?),
            None => Coefficient::Within(constant.enclosed()?.exp().ok()?),
        };
        let remainder = with_zero(falling.enclosed()?).exp().ok()? * Extended::of(&factorial(ORDER).recip());
        let coefficients: Vec<Exact> = (0..ORDER).map(|k| self.one.rational(&factorial(k).recip())).collect();
        Some(falling.expanded(&coefficients, remainder).times_term(&(scale, lead)))
    }

    fn expanded_log(&self) -> Option<Self> {
        let Split { lead: (scale, c), rest, range } = self.split()?;
        let first = match &c {
            Coefficient::Constant(c) => Coefficient::constant(c.ln().ok()?),
            Coefficient::Within(range) => Coefficient::Within(range.ln().ok().filter(|value| value.defined)?),
        };
        let mut terms = vec![(Scale::one(), first)];
        for (scale, factor) in scale.logarithm()? {
            terms.push((scale, Coefficient::constant(self.one.rational(&factor))));
        }
        let sign = |k: usize| if k % 2 == 1 { 1 } else { -1 };
        let coefficient = |k: usize| match k {
            0 => self.one.zero(),
            _ => self.one.ratio(sign(k), k as i64),
        };
        let base = with_zero(range) + Extended::between(1.0, 1.0);
        let remainder = base.power(ORDER as u64).recip().ok().filter(|inverse| inverse.defined)?;
        let remainder = remainder * Extended::of(&rational(sign(ORDER), ORDER as i64));
        let coefficients: Vec<Exact> = (0..ORDER).map(coefficient).collect();
        Some(self.made(terms) + rest.expanded(&coefficients, remainder))
    }

    /// Sine and cosine of a constant and what falls to 0.
    fn expanded_sin_cos(&self) -> Option<(Self, Self)> {
        let [growing, constant, falling] = self.parts();
        if !growing.terms.is_empty() {
            return None;
        }
        let c = constant.as_constant()?;
        let exact = c.sin_cos().ok()?;
        let range = with_zero(falling.enclosed()?) + c.enclosed();
        let enclosed = range.sin_cos().ok()?;
        let turned = |k: usize, (sin, cos): (Exact, Exact)| match k % 4 {
            0 => sin,
            1 => cos,
            2 => -sin,
            _ => -cos,
        };
        let of = |shift: usize| {
            let coefficient = |k: usize| turned(k + shift, exact.clone()) * self.one.rational(&factorial(k).recip());
            let last = match (ORDER + shift) % 4 {
                0 => enclosed.0,
                1 => enclosed.1,
                2 => -enclosed.0,
                _ => -enclosed.1,
            };
            let coefficients: Vec<Exact> = (0..ORDER).map(coefficient).collect();
            falling.expanded(&coefficients, last * Extended::of(&factorial(ORDER).recip()))
        };
        Some((of(0), of(1)))
    }
}

fn factorial(k: usize) -> Rational {
    (1..=k as i64).map(|k| rational(k, 1)).product()
}

/// From 0 to all of it: where the intermediate point of a remainder lies.
fn with_zero(range: Extended) -> Extended {
    Extended { lo: range.lo.min(0.0), hi: range.hi.max(0.0), ..range }
}

operators!([] Tail, Tail::plus, Tail::minus, Tail::times, Tail::negated);

impl Ring for Tail {
    fn integer(&self, n: i64) -> Self {
        self.of(self.one.integer(n))
    }

    fn square(&self) -> Self {
        let two = Coefficient::constant(self.one.integer(2));
        let mut terms = Vec::new();
        for (k, (s, c)) in self.terms.iter().enumerate() {
            terms.push((s.times(s), c.square()));
            terms.extend(self.terms[k + 1..].iter().map(|(t, d)| (s.times(t), c.times(d).times(&two))));
        }
        self.made(terms)
    }
}

impl Field for Tail {
    fn rational(&self, q: &Rational) -> Self {
        self.of(self.one.rational(q))
    }

    fn recip(&self) -> Result<Self, ArithmeticError> {
        self.raised(&rational(-1, 1), Field::recip, Field::recip)
    }
}

impl Signed for Tail {
    fn sign(&self) -> Option<Sign> {
        match (self.terms.is_empty(), self.is_above(&self.terms), self.is_above(&Tail::negated(self).terms)) {
            (true, ..) => Some(Sign::Zero),
            (_, Some(true), _) => Some(Sign::Positive),
            (_, _, Some(true)) => Some(Sign::Negative),
            _ => None,
        }
    }

    fn side(&self) -> Option<Sign> {
        match (self.is_above(&self.terms), self.is_above(&Tail::negated(self).terms)) {
            (Some(_), _) => Some(Sign::Positive),
            (_, Some(_)) => Some(Sign::Negative),
            _ => None,
        }
    }
}

impl Number for Tail {
    fn circle(&self) -> Result<Self, ArithmeticError> {
        Ok(self.of(self.one.circle()?))
    }

    fn sqrt(&self) -> Result<Self, ArithmeticError> {
        match self.terms.is_empty() {
            true => Ok(self.clone()),
            false => self.raised(&rational(1, 2), Number::sqrt, Number::sqrt),
        }
    }

    fn root(&self, degree: u64) -> Result<Self, ArithmeticError> {
        match (self.terms.is_empty(), i64::try_from(degree)) {
            (true, _) => Ok(self.clone()),
            (_, Ok(n)) => self.raised(&rational(1, n), |c| c.root(degree), |range| range.root(degree)),
            _ => open(),
        }
    }

    fn exp(&self) -> Result<Self, ArithmeticError> {
        self.expanded_exp().map_or_else(|| self.by_range(Number::exp), Ok)
    }

    fn ln(&self) -> Result<Self, ArithmeticError> {
        self.expanded_log().map_or_else(|| self.by_range(Number::ln), Ok)
    }

    fn sin_cos(&self) -> Result<(Self, Self), ArithmeticError> {
        if let Some(found) = self.expanded_sin_cos() {
            return Ok(found);
        }
        let range = self.enclosed().unwrap_or(Extended::between(f64::NEG_INFINITY, f64::INFINITY));
        let (sin, cos) = range.sin_cos()?;
        Ok((self.within(sin), self.within(cos)))
    }

    fn atan(&self) -> Result<Self, ArithmeticError> {
        self.by_range(Number::atan)
    }

    fn sinh_cosh(&self) -> Result<(Self, Self), ArithmeticError> {
        let (up, down) = (self.exp()?, Tail::negated(self).exp()?);
        let half = self.ratio(1, 2);
        Ok(((up.clone() - &down) * &half, (up + down) * half))
    }
}
