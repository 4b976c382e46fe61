//! Intervals with infinite ends that remember whether every operation was defined on all of its arguments: enclosures of values where there are any.

use arithmetic::{
    ArithmeticError, Field, FloatInterval, Interval, Number, Rational, Real, Ring, Sign, Signed, operators,
};

/// Encloses the values at all points of a box at which the function is defined. Empty where it is defined nowhere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Extended {
    pub lo: f64,
    pub hi: f64,
    /// Whether it is defined at all points.
    pub defined: bool,
}

const LINE: Extended = Extended { lo: f64::NEG_INFINITY, hi: f64::INFINITY, defined: true };

/// Bits of the enclosures behind the functions.
const BITS: u32 = 80;

impl Extended {
    pub fn between(lo: f64, hi: f64) -> Self {
        Extended { lo, hi, defined: true }
    }

    pub fn of(q: &Rational) -> Self {
        Extended::from_floats(&FloatInterval::from_rational(q))
    }

    pub fn hull(lo: Option<&Rational>, hi: Option<&Rational>) -> Self {
        Extended::between(
            lo.map_or(f64::NEG_INFINITY, |q| Extended::of(q).lo),
            hi.map_or(f64::INFINITY, |q| Extended::of(q).hi),
        )
    }

    pub fn is_empty(&self) -> bool {
        self.lo > self.hi
    }

    fn from_floats(x: &FloatInterval) -> Self {
        Extended::between(x.lo(), x.hi())
    }

    fn floats(&self) -> FloatInterval {
        FloatInterval::between(self.lo, self.hi)
    }

    fn is_zero(&self) -> bool {
        self.lo == 0.0 && self.hi == 0.0
    }

    fn and(self, other: bool) -> Self {
        Extended { defined: self.defined && other, ..self }
    }

    /// Rounded outward; what is not a number is not known.
    fn outward(lo: f64, hi: f64) -> Self {
        let lo = if lo.is_nan() { f64::NEG_INFINITY } else { lo.next_down() };
        let hi = if hi.is_nan() { f64::INFINITY } else { hi.next_up() };
        // An end that overflowed is finite in truth.
        let lo = if lo == f64::INFINITY { f64::MAX } else { lo };
        let hi = if hi == f64::NEG_INFINITY { f64::MIN } else { hi };
        Extended::between(lo, hi)
    }

    /// Between the least and the largest of rounded results with their errors: outward, unless nothing was rounded.
    fn of_results(results: &[(f64, f64)]) -> Self {
        let down = |(x, e): &(f64, f64)| if *e >= 0.0 { *x } else { x.next_down() };
        let up = |(x, e): &(f64, f64)| if *e <= 0.0 { *x } else { x.next_up() };
        // An error that is not a number is not known.
        let lo = results.iter().map(|r| if r.1.is_nan() { Extended::outward(r.0, r.0).lo } else { down(r) });
        let hi = results.iter().map(|r| if r.1.is_nan() { Extended::outward(r.0, r.0).hi } else { up(r) });
        Extended::between(lo.fold(f64::INFINITY, f64::min), hi.fold(f64::NEG_INFINITY, f64::max))
    }

    fn empty() -> Self {
        Extended { lo: f64::INFINITY, hi: f64::NEG_INFINITY, defined: false }
    }

    fn joined(a: &Self, b: &Self, of: impl Fn() -> Self) -> Self {
        if a.is_empty() || b.is_empty() { Extended::empty() } else { of().and(a.defined && b.defined) }
    }

    fn plus(a: &Self, b: &Self) -> Self {
        Extended::joined(a, b, || match (a.is_zero(), b.is_zero()) {
            (true, _) => *b,
            (_, true) => *a,
            _ => {
                let (least, most) = (sum(a.lo, b.lo), sum(a.hi, b.hi));
                Extended { lo: Extended::of_results(&[least]).lo, ..Extended::of_results(&[most]) }
            }
        })
    }

    fn negated(a: &Self) -> Self {
        Extended { lo: -a.hi, hi: -a.lo, defined: a.defined }
    }

    fn minus(a: &Self, b: &Self) -> Self {
        Extended::plus(a, &Extended::negated(b))
    }

    fn times(a: &Self, b: &Self) -> Self {
        Extended::joined(a, b, || {
            if a.is_zero() || b.is_zero() {
                return Extended::between(0.0, 0.0);
            }
            let whole = Extended::of_results(&[
                product(a.lo, b.lo),
                product(a.lo, b.hi),
                product(a.hi, b.lo),
                product(a.hi, b.hi),
            ]);
            // A product of numbers that are not negative is not negative, whatever rounding says.
            let same = a.lo >= 0.0 && b.lo >= 0.0 || a.hi <= 0.0 && b.hi <= 0.0;
            let other = a.lo >= 0.0 && b.hi <= 0.0 || a.hi <= 0.0 && b.lo >= 0.0;
            Extended {
                lo: if same { whole.lo.max(0.0) } else { whole.lo },
                hi: if other { whole.hi.min(0.0) } else { whole.hi },
                defined: true,
            }
        })
    }

    /// A function of the part that lies in its domain, from `least` on; where `open`, without that end itself.
    fn within(&self, least: f64, open: bool) -> Self {
        let outside = self.lo < least || open && self.lo == least;
        let inside = Extended { lo: self.lo.max(least), ..*self }.and(!outside);
        if inside.is_empty() || open && inside.hi <= least { Extended::empty() } else { inside }
    }

    /// A monotone function, given by enclosures of its values at finite ends and limits at infinite ones.
    fn monotone(&self, at: impl Fn(f64) -> Option<(f64, f64)>) -> Self {
        if self.is_empty() {
            return *self;
        }
        let end = |x: f64| at(x).unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
        Extended { lo: end(self.lo).0, hi: end(self.hi).1, defined: self.defined }
    }
}

/// The rounded sum and its error, which is a float (Knuth, Moeller); not a number where that is not known.
fn sum(x: f64, y: f64) -> (f64, f64) {
    let s = x + y;
    let t = s - x;
    (s, (x - (s - t)) + (y - t))
}

/// The rounded product and its error (Dekker, Veltkamp); not a number where that is not known.
fn product(x: f64, y: f64) -> (f64, f64) {
    /// Beyond these parts of numbers may overflow, or errors be too small for floats.
    const LARGE: f64 = 1e140;
    const SMALL: f64 = 1e-120;
    // Zero times an infinite end is zero: the end is not a value.
    if x == 0.0 || y == 0.0 {
        return (0.0, 0.0);
    }
    let p = x * y;
    if ![x, y].iter().all(|x| (SMALL..LARGE).contains(&x.abs())) {
        return (p, f64::NAN);
    }
    let split = |x: f64| {
        let c = 134_217_729.0 * x;
        let high = c - (c - x);
        (high, x - high)
    };
    let ((a, b), (c, d)) = (split(x), split(y));
    (p, ((a * c - p) + a * d + b * c) + b * d)
}

operators!([] Extended, Extended::plus, Extended::minus, Extended::times, Extended::negated);

impl Ring for Extended {
    fn integer(&self, n: i64) -> Self {
        Extended::from_floats(&FloatInterval::point(0.0).integer(n))
    }

    fn square(&self) -> Self {
        if self.is_empty() || self.is_zero() {
            return *self;
        }
        let contains = self.lo <= 0.0 && self.hi >= 0.0;
        let square = Extended::of_results(&[product(self.lo, self.lo), product(self.hi, self.hi)]);
        Extended { lo: if contains { 0.0 } else { square.lo.max(0.0) }, hi: square.hi, defined: self.defined }
    }

    fn power(&self, exponent: u64) -> Self {
        match exponent {
            0 => self.one().and(self.defined),
            1 => *self,
            _ if exponent.is_multiple_of(2) => self.square().power(exponent / 2),
            // Odd powers grow: by the ends.
            _ if self.is_empty() => *self,
            _ => {
                let at = |x: f64| {
                    let point = Extended::between(x, x);
                    let value = point.square().power(exponent / 2) * point;
                    (value.lo, value.hi)
                };
                Extended { lo: at(self.lo).0, hi: at(self.hi).1, defined: self.defined }
            }
        }
    }
}

impl Field for Extended {
    fn rational(&self, q: &Rational) -> Self {
        Extended::of(q)
    }

    /// Of the numbers other than zero.
    fn recip(&self) -> Result<Self, ArithmeticError> {
        if self.is_empty() || self.is_zero() {
            return Ok(Extended::empty());
        }
        let defined = self.defined && !(self.lo <= 0.0 && self.hi >= 0.0);
        if self.lo < 0.0 && self.hi > 0.0 {
            return Ok(LINE.and(false));
        }
        // An end at zero is no value: the other side of it has no end.
        let inverse = |x: f64| {
            let q = 1.0 / x;
            // Exact where the product is.
            if product(q, x) == (1.0, 0.0) { Extended::between(q, q) } else { Extended::outward(q, q) }
        };
        let lo = if self.hi == 0.0 { f64::NEG_INFINITY } else { inverse(self.hi).lo };
        let hi = if self.lo == 0.0 { f64::INFINITY } else { inverse(self.lo).hi };
        let whole = Extended { lo, hi, defined };
        Ok(if self.lo >= 0.0 {
            Extended { lo: whole.lo.max(0.0), ..whole }
        } else {
            Extended { hi: whole.hi.min(0.0), ..whole }
        })
    }
}

/// A function of a float by the general intervals; `None` where they do not have it.
fn general(x: f64, f: impl Fn(&Interval) -> Result<Interval, ArithmeticError>) -> Option<(f64, f64)> {
    let x = arithmetic::Dyadic::from_f64(x)?;
    let value = f(&Interval::between(x.clone(), x, BITS)).ok()?;
    let floats = FloatInterval::from_interval(&value);
    floats.is_bounded().then(|| (floats.lo(), floats.hi()))
}

impl Real for Extended {
    fn pi(&self) -> Self {
        Extended::from_floats(&FloatInterval::point(0.0).pi())
    }
}

impl Number for Extended {
    fn circle(&self) -> Result<Self, ArithmeticError> {
        Ok(self.pi())
    }

    fn sqrt(&self) -> Result<Self, ArithmeticError> {
        let inside = self.within(0.0, false);
        let root = |x: f64| {
            if x.is_infinite() {
                None
            } else {
                let root = x.sqrt();
                let exact = product(root, root) == (x, 0.0);
                Some(if exact { (root, root) } else { (root.next_down().max(0.0), root.next_up()) })
            }
        };
        Ok(inside.monotone(|x| if x == 0.0 { Some((0.0, 0.0)) } else { root(x) }))
    }

    fn root(&self, degree: u64) -> Result<Self, ArithmeticError> {
        let share = Interval::from_rational(&Rational::new(1.into(), degree.into()), BITS);
        let inside = self.within(0.0, false);
        Ok(inside.monotone(|x| match x {
            0.0 | 1.0 => Some((x, x)),
            x if x == f64::INFINITY => Some((0.0, x)),
            x => general(x, |x| (x.ln()? * &share).exp()),
        }))
    }

    fn exp(&self) -> Result<Self, ArithmeticError> {
        // Beyond these the ends are not worth a long computation.
        const LARGE: f64 = 700.0;
        Ok(self.monotone(|x| match x {
            0.0 => Some((1.0, 1.0)),
            // e^-700 is below this.
            x if x < -LARGE => Some((0.0, 1e-304)),
            x if x > LARGE => Some((1e300, f64::INFINITY)),
            x => general(x, Interval::exp),
        }))
    }

    fn ln(&self) -> Result<Self, ArithmeticError> {
        let inside = self.within(0.0, true);
        Ok(inside.monotone(|x| match x {
            1.0 => Some((0.0, 0.0)),
            x if x == f64::INFINITY => Some((0.0, f64::INFINITY)),
            0.0 => None,
            x => general(x, Interval::ln),
        }))
    }

    fn sin_cos(&self) -> Result<(Self, Self), ArithmeticError> {
        if self.is_empty() {
            return Ok((*self, *self));
        }
        const LARGE: f64 = 1e9;
        let all = Extended::between(-1.0, 1.0).and(self.defined);
        if self.lo < -LARGE || self.hi > LARGE {
            return Ok((all, all));
        }
        if self.is_zero() {
            return Ok((*self, self.one().and(self.defined)));
        }
        let (sin, cos) = self.floats().sin_cos()?;
        let clamped = |x: FloatInterval| Extended::between(x.lo().max(-1.0), x.hi().min(1.0)).and(self.defined);
        let (sin, cos) = (clamped(sin), clamped(cos));
        // Within half a turn, of which most is enough, the sine has the sign of the angle, whatever rounding says.
        const HALF: f64 = 3.0;
        let sin = match (self.lo >= 0.0 && self.hi <= HALF, self.hi <= 0.0 && self.lo >= -HALF) {
            (true, _) => Extended { lo: sin.lo.max(0.0), ..sin },
            (_, true) => Extended { hi: sin.hi.min(0.0), ..sin },
            _ => sin,
        };
        Ok((sin, cos))
    }

    fn atan(&self) -> Result<Self, ArithmeticError> {
        let quarter = (self.pi() * Extended::of(&arithmetic::rational(1, 2))).hi;
        Ok(self.monotone(|x| {
            if x.is_infinite() {
                Some((x.signum() * quarter, x.signum() * quarter))
            } else {
                general(x, Interval::atan)
            }
        }))
    }

    fn sinh_cosh(&self) -> Result<(Self, Self), ArithmeticError> {
        let up = self.exp()?;
        let down = Extended::negated(self).exp()?;
        let half = Extended::of(&arithmetic::rational(1, 2));
        Ok(((up - down) * half, (up + down) * half))
    }
}

impl Signed for Extended {
    fn absolute(&self) -> Result<Self, ArithmeticError> {
        Ok(match self.sign() {
            Some(Sign::Negative) => Extended::negated(self),
            Some(_) => *self,
            None if self.is_empty() => *self,
            None => Extended { lo: 0.0, hi: self.hi.max(-self.lo), defined: self.defined },
        })
    }

    fn larger(&self, other: &Self) -> Result<Self, ArithmeticError> {
        Ok(Extended::joined(self, other, || Extended::between(self.lo.max(other.lo), self.hi.max(other.hi))))
    }

    fn smaller(&self, other: &Self) -> Result<Self, ArithmeticError> {
        Ok(Extended::joined(self, other, || Extended::between(self.lo.min(other.lo), self.hi.min(other.hi))))
    }

    fn side(&self) -> Option<Sign> {
        let known = self.sign();
        match (self.is_empty(), self.lo >= 0.0, self.hi <= 0.0) {
            _ if known.is_some() => known,
            (false, true, _) => Some(Sign::Positive),
            (false, _, true) => Some(Sign::Negative),
            _ => None,
        }
    }

    fn sign(&self) -> Option<Sign> {
        match (self.lo > 0.0, self.hi < 0.0, self.is_zero()) {
            _ if self.is_empty() => None,
            (true, _, _) => Some(Sign::Positive),
            (_, true, _) => Some(Sign::Negative),
            (_, _, true) => Some(Sign::Zero),
            _ => None,
        }
    }
}
