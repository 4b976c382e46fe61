//! One function on one box: enclosures, slopes, convexity, expansions.

use super::exact::{self, Exact};
use super::places::{Place, exactly, free, only_free, points_near};
use super::tail::{End, Tail};
use super::{Extended, Method};
use crate::function::{Compared, Function, Literal, Side};
use arithmetic::{ArithmeticError, Dual, PreciseNumber, Rational, Ring, Series, Sign, Signed, simplest_between};
use nalgebra::{DMatrix, DVector};

/// What a clause is at a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Signs {
    /// A literal is true; whether one that may be 0 is 0.
    Holds { zero: bool },
    /// All are false.
    Fails,
    /// Not known, or without a value.
    Unknown,
}

/// Bits with which signs at points are tried.
const BITS: [u32; 2] = [64, 256];

/// The same where no identity tells.
const MOST_BITS: u32 = 1024;

/// Largest number of variables for which second derivatives are formed.
const MOST_SECOND: usize = 8;

/// Terms of an expansion.
const ORDER: usize = 12;

/// Terms of an expansion whose signs are found by identities.
const FEW: usize = 5;

/// The exact sign at a rational point, where it can be decided.
pub(super) fn sign_at<F: Function>(function: &F, point: &[Rational]) -> Option<Sign> {
    let precise = |bits: u32| {
        let at: Vec<PreciseNumber> = point.iter().map(|q| PreciseNumber::exact(q.clone(), bits)).collect();
        function.value(&at).ok().and_then(|value| value.sign())
    };
    let found = BITS.iter().find_map(|&bits| precise(bits));
    found
        .or_else(|| exact::computed(|one| function.value(&constants(point, one)).ok()?.sign(), |_| true))
        .or_else(|| precise(MOST_BITS))
}

fn constants(point: &[Rational], one: &Exact) -> Vec<Exact> {
    use arithmetic::Field;
    point.iter().map(|q| one.rational(q)).collect()
}

/// What an expansion says.
enum Expanded {
    True { zero: bool },
    TrueBut,
    Fails,
}

/// `f_0 + f_1 h + ..` by the signs of the coefficients, as far as they are known, and the enclosed remainders after the first ones; `h` is at least 0 where the
/// point is the lower end, at most 0 where it is the upper one.
fn expansion(
    signs: &[Option<Sign>],
    remainders: &[Extended],
    (at_lo, at_hi): (bool, bool),
    strict: bool,
) -> Option<Expanded> {
    let (mut zero, mut above, mut looked) = (true, false, false);
    for (m, sign) in signs.iter().enumerate() {
        // The remainder after the first m coefficients, all of which speak for the sign.
        let Some(rest) = remainders.get(m) else { break };
        let fits = match (at_lo, at_hi, m % 2) {
            (true, _, _) | (_, _, 0) => rest.lo >= 0.0,
            (_, true, _) => rest.hi <= 0.0,
            _ => false,
        };
        if m > 0 && fits && (!strict || !zero) {
            return Some(Expanded::True { zero });
        }
        // A term before the remainder, or the remainder itself, is above 0 wherever `h` is not 0.
        if m > 0 && fits && (above || rest.lo > 0.0 || rest.hi < 0.0) {
            return Some(Expanded::TrueBut);
        }
        let Some(sign) = *sign else { break };
        let speaks = matches!(
            (sign, at_lo, at_hi, m % 2),
            (Sign::Zero, ..) | (Sign::Positive, _, _, 0) | (Sign::Positive, true, _, _) | (Sign::Negative, _, true, 1)
        );
        if m == 0 {
            (zero, looked) = (sign == Sign::Zero, true);
        }
        if !speaks {
            return (m == 0 || strict && zero).then_some(Expanded::Fails);
        }
        above |= sign != Sign::Zero;
    }
    (looked && zero && strict).then_some(Expanded::Fails)
}

/// The truth of a clause at a rational point.
pub(super) fn at_point<F: Function>(clause: &[Literal<F>], point: &[Rational]) -> Signs {
    let (mut fails, mut holds, mut zero) = (true, false, false);
    for literal in clause {
        match sign_at(&literal.function, point) {
            None => fails = false,
            Some(sign) => {
                let own = literal.compared.admits(sign);
                holds |= own;
                fails &= !own;
                zero |= own && sign == Sign::Zero && literal.compared == Compared::NotNegative;
            }
        }
    }
    match (holds, fails) {
        (true, _) => Signs::Holds { zero },
        (_, true) => Signs::Fails,
        _ => Signs::Unknown,
    }
}

/// What is known of a function on a box.
#[derive(Debug)]
pub(super) enum Local {
    /// It has its sign at all points.
    True { method: Method, zero: Option<Vec<Rational>> },
    /// It has its sign at all points, and is 0 at this one.
    TrueAround(Vec<Place>),
    /// It has its sign at all points but this one, at which it is 0.
    TrueBut(Vec<Rational>),
    /// At this point it has not.
    FailsAt(Vec<Rational>),
    /// The same of one in closed form.
    FailsAround(Vec<Place>),
    /// It has its sign at no point.
    False,
    /// Not known; enclosures of the slopes where there are such.
    Open(Vec<Extended>),
}

/// A function or its negative, above zero or at least zero.
#[derive(Clone, Copy)]
pub(super) struct Sided<'a, F> {
    pub function: &'a F,
    pub negative: bool,
    pub strict: bool,
    pub guarded: bool,
}

impl<F: Function> Sided<'_, F> {
    fn value<T: arithmetic::Number>(&self, at: &[T]) -> Result<T, ArithmeticError> {
        let value = self.function.value(at)?;
        Ok(if self.negative { -value } else { value })
    }

    fn sign_at(&self, point: &[Rational]) -> Option<Sign> {
        sign_at(self.function, point).map(|sign| if self.negative { sign.negate() } else { sign })
    }

    fn is_true(&self, sign: Sign) -> bool {
        if self.strict { sign == Sign::Positive } else { sign != Sign::Negative }
    }

    fn suffices(&self, lower: f64) -> bool {
        lower > 0.0 || lower == 0.0 && !self.strict
    }

    /// What the sign at a point that has the least value says.
    fn by_least(&self, point: Vec<Rational>, method: Method) -> Option<Local> {
        let sign = self.sign_at(&point)?;
        if !self.is_true(sign) {
            return Some(Local::FailsAt(point));
        }
        Some(Local::True { method, zero: (sign == Sign::Zero).then_some(point) })
    }

    /// Whether it is nowhere 0 on a box, by its enclosure.
    pub fn is_apart(&self, sides: &[Side]) -> bool {
        let boxed: Vec<Extended> = sides.iter().map(hull).collect();
        self.value(&boxed).is_ok_and(|value| value.defined && !value.is_empty() && (value.lo > 0.0 || value.hi < 0.0))
    }

    /// Decides on a box, as far as that can be done without dividing it.
    pub fn on_box(&self, sides: &[Side]) -> Local {
        let boxed: Vec<Extended> = sides.iter().map(hull).collect();
        let Ok(value) = self.value(&boxed) else { return Local::Open(Vec::new()) };
        if value.is_empty() {
            return if self.guarded { Local::True { method: Method::Enclosures, zero: None } } else { Local::False };
        }
        if (value.defined || self.guarded) && self.suffices(value.lo) {
            return Local::True { method: Method::Enclosures, zero: None };
        }
        if value.hi < 0.0 || value.hi == 0.0 && self.strict {
            return Local::False;
        }
        // What follows needs derivatives at all points.
        if !value.defined {
            return Local::Open(Vec::new());
        }
        match self.by_slopes(sides) {
            found @ (Local::FailsAt(_) | Local::FailsAround(_) | Local::Open(_)) if self.strict => {
                self.but_at_zero(sides).unwrap_or(found)
            }
            found => found,
        }
    }

    /// In one number, above 0 but for one zero.
    fn but_at_zero(&self, sides: &[Side]) -> Option<Local> {
        self.by_expansion(sides, only_free(sides)?).filter(|found| matches!(found, Local::TrueBut(_)))
    }

    /// Variables along which the function only grows, or only falls, are put to their ends; what is left is looked at anew.
    fn by_slopes(&self, sides: &[Side]) -> Local {
        let mut left = sides.to_vec();
        let mut slopes = vec![Extended::between(0.0, 0.0); sides.len()];
        loop {
            let boxed: Vec<Extended> = left.iter().map(hull).collect();
            let mut moved = false;
            for k in 0..left.len() {
                if left[k].as_point().is_some() {
                    continue;
                }
                let seeded: Vec<Dual<Extended>> = seeded(&boxed, k);
                let Some(slope) = self.value(&seeded).ok().filter(is_smooth).map(|value| value.derivative) else {
                    return Local::Open(Vec::new());
                };
                slopes[k] = slope;
                let end = match (slope.lo >= 0.0, slope.hi <= 0.0) {
                    (true, _) => left[k].lo.clone(),
                    (_, true) => left[k].hi.clone(),
                    _ => None,
                };
                if let Some(end) = end {
                    left[k] = Side::point(end);
                    moved = true;
                    break;
                }
            }
            if !moved {
                break;
            }
            let boxed: Vec<Extended> = left.iter().map(hull).collect();
            if self.value(&boxed).is_ok_and(|value| value.defined && self.suffices(value.lo)) {
                return Local::True { method: Method::Slopes, zero: None };
            }
        }
        let free = free(&left);
        if free.is_empty() {
            let point: Option<Vec<Rational>> = left.iter().map(|side| side.as_point().cloned()).collect();
            let found = point.and_then(|point| self.by_least(point, Method::Slopes));
            return found.unwrap_or(Local::Open(slopes));
        }
        if self.by_mean_value(&left, &free, &slopes) {
            return Local::True { method: Method::Slopes, zero: None };
        }
        let found = self.by_convexity(&left, &free).or_else(|| match free[..] {
            // The zero of the side that is left need not be the only one of the box.
            [only] => self.by_expansion(&left, only).map(|found| match found {
                Local::TrueBut(point) => Local::FailsAt(point),
                found => found,
            }),
            _ => None,
        });
        found.unwrap_or(Local::Open(slopes))
    }

    /// `f(c) + sum f'_k (X_k - c_k)` around the middle of a bounded box.
    fn by_mean_value(&self, sides: &[Side], free: &[usize], slopes: &[Extended]) -> bool {
        if free.iter().any(|&k| sides[k].lo.is_none() || sides[k].hi.is_none()) {
            return false;
        }
        let middle: Vec<Extended> = sides.iter().map(|side| Extended::of(&side.middle())).collect();
        let Ok(value) = self.value(&middle) else { return false };
        let change = |&k: &usize| slopes[k] * (hull(&sides[k]) - middle[k]);
        let whole = free.iter().map(change).fold(value, |sum, own| sum + own);
        whole.defined && self.suffices(whole.lo)
    }

    /// A function that is convex on the box has its least value where no direction into the box goes down.
    fn by_convexity(&self, sides: &[Side], free: &[usize]) -> Option<Local> {
        if free.len() > MOST_SECOND {
            return None;
        }
        let boxed: Vec<Extended> = sides.iter().map(hull).collect();
        let n = free.len();
        let mut second = vec![vec![Extended::between(0.0, 0.0); n]; n];
        for i in 0..n {
            for j in 0..=i {
                let value = self.value(&seeded(&seeded(&boxed, free[i]), free[j])).ok()?;
                let entry = value.derivative.derivative;
                if !(entry.defined && value.value.value.defined && entry.lo.is_finite() && entry.hi.is_finite()) {
                    return None;
                }
                second[i][j] = entry;
                second[j][i] = entry;
            }
        }
        if !is_positive_definite(second) {
            return None;
        }
        let ends: Vec<(f64, f64)> = sides.iter().map(Side::floats).collect();
        let mut x: Vec<f64> = sides
            .iter()
            .map(|side| {
                use num_traits::ToPrimitive;
                side.middle().to_f64().unwrap_or(0.0)
            })
            .collect();
        minimise(self, &mut x, &ends, free);
        // The tangent plane at any point lies below.
        let point: Vec<Rational> = x
            .iter()
            .zip(sides)
            .map(|(x, side)| Rational::from_float(*x).map(|q| side.nearest(q)))
            .collect::<Option<_>>()?;
        let bound = self.tangent(&point, sides, free);
        if bound.is_some_and(|bound| bound > 0.0) {
            return Some(Local::True { method: Method::Convexity, zero: None });
        }
        for reach in [1e-3, 1e-5, 1e-7, 1e-10] {
            let simple = near(&x, sides, reach)?;
            if self.is_least(&simple, sides, free) {
                return self.by_least(simple, Method::Convexity);
            }
        }
        if self.sign_at(&point).is_some_and(|sign| !self.is_true(sign)) {
            return Some(Local::FailsAt(point));
        }
        if let Some(found) = self.by_closed_form(&x, sides, free) {
            return Some(found);
        }
        bound.filter(|bound| self.suffices(*bound)).map(|_| Local::True { method: Method::Convexity, zero: None })
    }

    /// The least value of the tangent plane at a point over the box.
    fn tangent(&self, point: &[Rational], sides: &[Side], free: &[usize]) -> Option<f64> {
        let at: Vec<Extended> = point.iter().map(Extended::of).collect();
        let mut sum = self.value(&at).ok()?;
        for &k in free {
            let slope = self.value(&seeded(&at, k)).ok()?.derivative;
            sum = sum + slope * (hull(&sides[k]) - at[k]);
        }
        sum.defined.then_some(sum.lo)
    }

    /// Whether no direction into the box goes down at a point, by exact signs of the slopes.
    fn is_least(&self, point: &[Rational], sides: &[Side], free: &[usize]) -> bool {
        let at: Vec<PreciseNumber> = point.iter().map(|q| PreciseNumber::exact(q.clone(), BITS[1])).collect();
        free.iter().all(|&k| {
            let slope = self.value(&seeded(&at, k)).ok().and_then(|value| value.derivative.sign());
            let slope = slope.or_else(|| {
                let of = |one: &Exact| self.value(&seeded(&constants(point, one), k)).ok()?.derivative.sign();
                exact::computed(of, |_| true)
            });
            self.is_no_way_down(slope, &sides[k], |end| *end == point[k])
        })
    }

    /// What the sign at the least value of a convex function says, where that is 0 at a point in closed form.
    fn by_closed_form(&self, x: &[f64], sides: &[Side], free: &[usize]) -> Option<Local> {
        const NEAR: f64 = 1e-8;
        if !self.value(x).is_ok_and(|value| value.abs() <= NEAR) {
            return None;
        }
        let is_least = |places: &Vec<Place>| {
            free.iter().all(|&k| {
                let of = |one: &Exact| self.value(&seeded(&exactly(places, one)?, k)).ok()?.derivative.sign();
                self.is_no_way_down(exact::computed(of, |_| true), &sides[k], |end| places[k].is(end))
            })
        };
        let places = points_near(self.function, x, sides).find(is_least)?;
        let sign = exact::computed(|one| self.value(&exactly(&places, one)?).ok()?.sign(), |_| true)?;
        match self.is_true(sign) {
            false => Some(Local::FailsAround(places)),
            true if sign == Sign::Zero => Some(Local::TrueAround(places)),
            true => Some(Local::True { method: Method::Convexity, zero: None }),
        }
    }

    /// Whether a slope of this sign does not go down into a side, at a point of it.
    fn is_no_way_down(&self, slope: Option<Sign>, side: &Side, is_at: impl Fn(&Rational) -> bool) -> bool {
        match slope {
            Some(Sign::Zero) => true,
            Some(Sign::Positive) => side.lo.as_ref().is_some_and(is_at),
            Some(Sign::Negative) => side.hi.as_ref().is_some_and(is_at),
            None => false,
        }
    }

    /// One number is left: `f(c + h) = sum_(j<m) f_j h^j + f_m(xi) h^m`, with the exact coefficients at `c` and the enclosed one on the box.
    fn by_expansion(&self, sides: &[Side], free: usize) -> Option<Local> {
        let boxed: Vec<Extended> = sides.iter().map(hull).collect();
        let remainders = self.remainders(&boxed, free)?;
        let mut places: Vec<Rational> = [&sides[free].lo, &sides[free].hi].into_iter().flatten().cloned().collect();
        if let (Some(lo), Some(hi)) = (&sides[free].lo, &sides[free].hi) {
            places.push(simplest_between(lo, hi));
        }
        places.iter().find_map(|place| self.expanded(sides, free, place, &remainders))
    }

    fn expanded(&self, sides: &[Side], free: usize, place: &Rational, remainders: &[Extended]) -> Option<Local> {
        let side = &sides[free];
        let at_lo = side.lo.as_ref() == Some(place);
        let at_hi = side.hi.as_ref() == Some(place);
        let point: Vec<Rational> =
            sides.iter().enumerate().map(|(k, own)| if k == free { place.clone() } else { own.middle() }).collect();
        let at: Vec<Series<PreciseNumber>> = point
            .iter()
            .enumerate()
            .map(|(k, q)| {
                let value = PreciseNumber::exact(q.clone(), BITS[1]);
                let rest: Vec<_> = (1..ORDER).map(|m| value.integer(i64::from(k == free && m == 1))).collect();
                Series::from_coefficients(value, rest)
            })
            .collect();
        let exact = self.value(&at).ok()?;
        let mut signs: Vec<Option<Sign>> = exact.coefficients().iter().map(Signed::sign).collect();
        if signs.contains(&None) {
            let of = |one: &Exact| self.signs(&constants(&point, one), free);
            let known = exact::computed(of, |signs| !signs.contains(&None)).unwrap_or_default();
            signs.iter_mut().zip(known).for_each(|(own, known)| *own = own.or(known));
        }
        expansion(&signs, remainders, (at_lo, at_hi), self.strict).map(|found| match found {
            Expanded::True { zero } => Local::True { method: Method::Expansion, zero: zero.then_some(point) },
            Expanded::TrueBut => Local::TrueBut(point),
            Expanded::Fails => Local::FailsAt(point),
        })
    }

    /// The signs of the first coefficients at a point along one direction.
    fn signs(&self, point: &[Exact], free: usize) -> Option<Vec<Option<Sign>>> {
        let series = |(k, x): (usize, &Exact)| {
            Series::from_coefficients(x.clone(), (1..FEW).map(|m| x.integer(i64::from(k == free && m == 1))))
        };
        let at: Vec<Series<Exact>> = point.iter().enumerate().map(series).collect();
        Some(self.value(&at).ok()?.coefficients().iter().map(Signed::sign).collect())
    }

    /// Whether it has its sign for all `t >= from` at an end of the line of one variable.
    pub fn is_true_at_end(&self, sides: &[Side], free: usize, end: End, from: Extended) -> bool {
        let number = |one: &Exact, (k, side): (usize, &Side)| match k == free {
            true => end.number(&from, one),
            false => Some(Tail::constant(arithmetic::Field::rational(one, &side.middle()), &from, one)),
        };
        let of = |one: &Exact| {
            let at = sides.iter().enumerate().map(|own| number(one, own)).collect::<Option<Vec<Tail>>>()?;
            let value = self.value(&at).ok()?;
            let sign = if self.strict { value.sign() } else { value.side() };
            Some(sign == Some(Sign::Positive))
        };
        exact::computed(of, |is_true| *is_true) == Some(true)
    }

    /// Whether it has its sign on the part of the box on one side of a place inside, which itself is left out.
    pub fn beside(&self, sides: &[Side], free: usize, place: &Place, above: bool) -> bool {
        let Some(at) = place.enclosure() else { return false };
        let whole = hull(&sides[free]);
        let part = if above { Extended::between(at.lo, whole.hi) } else { Extended::between(whole.lo, at.hi) };
        let boxed: Vec<Extended> =
            sides.iter().enumerate().map(|(k, side)| if k == free { part } else { hull(side) }).collect();
        match self.value(&boxed) {
            Ok(value) if (value.defined || self.guarded) && self.suffices(value.lo) => return true,
            Ok(_) => {}
            Err(_) => return false,
        }
        let Some(remainders) = self.remainders(&boxed, free) else {
            let width = if above { part - at } else { at - part };
            let end = if above { End::After(place) } else { End::Before(place) };
            return from_width(width).is_some_and(|from| self.is_true_at_end(sides, free, end, from));
        };
        let point: Vec<Rational> = sides.iter().map(Side::middle).collect();
        let places = place.on_line(&point, free);
        let of = |one: &Exact| self.signs(&exactly(&places, one)?, free);
        let Some(signs) = exact::computed(of, |signs| !signs.contains(&None)) else { return false };
        let found = expansion(&signs, &remainders, (above, !above), self.strict);
        matches!(found, Some(Expanded::True { .. } | Expanded::TrueBut))
    }

    /// The coefficients of the expansion in one variable, enclosed on a box; the first ones, as far as the function is smooth.
    fn remainders(&self, boxed: &[Extended], free: usize) -> Option<Vec<Extended>> {
        let series = |(k, x): (usize, &Extended)| {
            Series::from_coefficients(*x, (1..ORDER).map(|m| x.integer(i64::from(k == free && m == 1))))
        };
        let at: Vec<Series<Extended>> = boxed.iter().enumerate().map(series).collect();
        let on_box = self.value(&at).ok()?;
        Some(on_box.coefficients().iter().take_while(|c| c.defined).copied().collect())
    }
}

/// The least `t` of `c + 1/t` up to a width away from `c`.
pub(super) fn from_width(width: Extended) -> Option<Extended> {
    let least = arithmetic::Field::recip(&Extended::between(width.hi, width.hi)).ok()?.lo;
    (least > 1.0).then(|| Extended::between(least, least))
}

fn is_smooth(value: &Dual<Extended>) -> bool {
    value.value.defined && value.derivative.defined && !value.derivative.is_empty()
}

pub(super) fn hull(side: &Side) -> Extended {
    Extended::hull(side.lo.as_ref(), side.hi.as_ref())
}

/// Encloses the values of a function on a domain, where it has some.
pub(super) fn enclosed_on<F: Function>(function: &F, domain: &[Side]) -> Option<Extended> {
    let boxed: Vec<Extended> = domain.iter().map(hull).collect();
    function.value(&boxed).ok().filter(|value| !value.is_empty())
}

/// A point that moves with one of its numbers; twice, with two of them, for second derivatives.
pub(super) fn seeded<T: Ring>(at: &[T], k: usize) -> Vec<Dual<T>> {
    at.iter().enumerate().map(|(j, x)| Dual::new(x.clone(), x.integer(i64::from(j == k)))).collect()
}

/// Simple rationals near floats, in the box.
fn near(x: &[f64], sides: &[Side], reach: f64) -> Option<Vec<Rational>> {
    let one = |(x, side): (&f64, &Side)| {
        let exact = Rational::from_float(*x)?;
        let size = Rational::from_float(reach * x.abs().max(1.0))?;
        Some(
            side.as_point()
                .cloned()
                .unwrap_or_else(|| side.nearest(simplest_between(&(&exact - &size), &(exact + size)))),
        )
    };
    x.iter().zip(sides).map(one).collect()
}

/// Whether every symmetric matrix with entries in these intervals is positive definite: all pivots are.
pub(super) fn is_positive_definite(mut matrix: Vec<Vec<Extended>>) -> bool {
    use arithmetic::Field;
    let n = matrix.len();
    for k in 0..n {
        if matrix[k][k].lo <= 0.0 || matrix[k][k].lo.is_nan() {
            return false;
        }
        let Ok(inverse) = matrix[k][k].recip() else { return false };
        for i in k + 1..n {
            for j in k + 1..=i {
                let less = if i == j { matrix[i][k].square() } else { matrix[i][k] * matrix[j][k] } * inverse;
                matrix[i][j] = matrix[i][j] - less;
                matrix[j][i] = matrix[i][j];
            }
        }
    }
    true
}

/// Newton's method within the box, in floats.
fn minimise<F: Function>(sided: &Sided<F>, x: &mut [f64], ends: &[(f64, f64)], free: &[usize]) {
    let turned = if sided.negative { -1.0 } else { 1.0 };
    newton(sided.function, turned, x, ends, free);
}

/// A few steps of Newton's method towards a critical point within the box.
pub(super) fn polish<F: Function>(function: &F, x: &mut [f64], ends: &[(f64, f64)]) {
    let free: Vec<usize> = (0..x.len()).filter(|&k| ends[k].0 < ends[k].1).collect();
    newton(function, 1.0, x, ends, &free);
}

fn newton<F: Function>(function: &F, turned: f64, x: &mut [f64], ends: &[(f64, f64)], free: &[usize]) {
    const STEPS: usize = 12;
    for _ in 0..STEPS {
        let slope = |k: usize| function.value(&seeded(x, k)).map(|value| turned * value.derivative);
        let Ok(slopes) = free.iter().map(|&k| slope(k)).collect::<Result<Vec<f64>, _>>() else { return };
        // Variables that are held at an end.
        let active: Vec<(usize, f64)> = free
            .iter()
            .zip(slopes)
            .filter(|&(&k, slope)| !(x[k] <= ends[k].0 && slope > 0.0 || x[k] >= ends[k].1 && slope < 0.0))
            .map(|(&k, slope)| (k, slope))
            .collect();
        let n = active.len();
        if n == 0 {
            return;
        }
        let second = |i: usize, j: usize| {
            let point = seeded(&seeded(x, active[i].0), active[j].0);
            function.value(&point).map_or(f64::NAN, |value| turned * value.derivative.derivative)
        };
        let matrix = DMatrix::from_fn(n, n, |i, j| second(i.max(j), i.min(j)));
        let right = DVector::from_iterator(n, active.iter().map(|(_, slope)| -slope));
        let Some(step) = matrix.lu().solve(&right).filter(|step| step.iter().all(|x| x.is_finite())) else { return };
        let mut moved = 0.0f64;
        for ((k, _), change) in active.iter().zip(step.iter()) {
            let next = (x[*k] + change).clamp(ends[*k].0, ends[*k].1);
            moved = moved.max((next - x[*k]).abs());
            x[*k] = next;
        }
        if moved == 0.0 {
            return;
        }
    }
}
