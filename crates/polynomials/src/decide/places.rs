//! Numbers in closed form at which a function is zero: floats and a search for simple forms propose, exact numbers decide.

use super::Extended;
use super::attained::least;
use super::exact::{self, Exact};
use super::local::{Signs, polish};
use super::solutions::{self, Equation};
use crate::function::{Compared, Function, Literal, Side};
use arithmetic::{
    ArithmeticError, Dual, Field, Number, PreciseNumber, Rational, Series, Sign, Signed, decimal, rational,
    simplest_between,
};
use num_bigint::BigInt;
use num_traits::{ToPrimitive, Zero};
use std::fmt;

/// What is taken of `a + b sqrt(d)`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Outer {
    Itself,
    TimesPi,
    /// Over pi.
    OverPi,
    Exponential,
    /// The root of this degree.
    Root(u32),
    /// The logarithm over this integer.
    Logarithm(i64),
    /// One over the logarithm.
    OverLogarithm,
    /// A number of which it is proved that it lies between `a` and `b`, and is what it is said to be; with an equation, its only solution there.
    Between,
}

/// A function of `a + b sqrt(d)`, the solution of an equation, or a number that is enclosed.
#[derive(Debug, Clone, PartialEq)]
pub struct Place {
    outer: Outer,
    a: Rational,
    b: Rational,
    d: Rational,
    /// Which equation it solves.
    equation: Option<Equation>,
}

/// Points at which floats look for zeros.
const POINTS: usize = 240;

/// Values of this size may be zero.
const NEAR: f64 = 1e-8;

/// Most zeros that are looked for.
const MOST: usize = 12;

impl Place {
    fn rational(outer: Outer, a: Rational) -> Self {
        Place { outer, a, b: rational(0, 1), d: rational(0, 1), equation: None }
    }

    /// A number between two others.
    pub(super) fn between(lo: Rational, hi: Rational) -> Self {
        Place { b: hi, ..Place::rational(Outer::Between, lo) }
    }

    /// The only solution of an equation between two numbers.
    pub(super) fn solution(equation: Equation, lo: Rational, hi: Rational) -> Self {
        Place { equation: Some(equation), ..Place::between(lo, hi) }
    }

    /// Whether no more is known of it than where it lies.
    pub(super) fn is_enclosed(&self) -> bool {
        self.outer == Outer::Between && self.equation.is_none()
    }

    /// The number in closed form, in the scalar of `like`.
    pub(super) fn value<T: Number>(&self, like: &T) -> Result<T, ArithmeticError> {
        let open = || ArithmeticError::Domain("a number in closed form");
        if self.outer == Outer::Between {
            return Err(open());
        }
        let of = |q: &Rational| like.rational(q);
        let inside = if self.b.is_zero() { of(&self.a) } else { of(&self.a) + of(&self.b) * of(&self.d).sqrt()? };
        match self.outer {
            Outer::Itself => Ok(inside),
            Outer::TimesPi => Ok(inside * like.circle()?),
            Outer::OverPi => inside.over(&like.circle()?),
            Outer::Exponential => inside.exp(),
            // Of a negative number, whose degree is odd, the negative of a root.
            Outer::Root(degree) if self.inside_is_negative() => Ok(-(-inside).root(degree.into())?),
            Outer::Root(degree) => inside.root(degree.into()),
            Outer::Logarithm(k) => Ok(inside.ln()? * like.ratio(1, k)),
            Outer::OverLogarithm => inside.ln()?.recip(),
            Outer::Between => Err(open()),
        }
    }

    fn inside_is_negative(&self) -> bool {
        let float = |q: &Rational| q.to_f64().unwrap_or(f64::NAN);
        float(&self.a) + float(&self.b) * float(&self.d).sqrt() < 0.0
    }

    /// The number in closed form, or what its equation says of it.
    pub(super) fn exactly(&self, one: &Exact) -> Option<Exact> {
        match &self.equation {
            Some(equation) => equation.put((&self.a, &self.b), one),
            None => self.value(one).ok(),
        }
    }

    pub(super) fn enclosure(&self) -> Option<Extended> {
        match self.outer {
            Outer::Between => Some(Extended::hull(Some(&self.a), Some(&self.b))),
            _ => self.value(&Extended::between(1.0, 1.0)).ok(),
        }
    }

    /// The place on the only line of a domain, at which all literals are false; it has to lie in the domain.
    pub(super) fn fails<F: Function>(&self, clause: &[Literal<F>], domain: &[Side]) -> Option<Vec<Place>> {
        let free = only_free(domain).filter(|&k| self.lies_in(&domain[k]))?;
        let point: Vec<Rational> = domain.iter().map(Side::middle).collect();
        Some(self.on_line(&point, free)).filter(|places| truth(clause, places) == Signs::Fails)
    }

    /// Whether it is known to be the number.
    pub(super) fn is(&self, q: &Rational) -> bool {
        self.outer == Outer::Itself && self.b.is_zero() && self.a == *q
    }

    /// Whether it is in a side, exactly.
    pub(super) fn is_in(&self, side: &Side) -> bool {
        match (self.outer, self.b.is_zero()) {
            (Outer::Itself, true) => side.contains(&self.a),
            _ => !side.integer && self.lies_in(side),
        }
    }

    /// Whether it is known to lie within a side, exactly; at an end of it, it is a rational point, which is looked at as such.
    fn lies_in(&self, side: &Side) -> bool {
        let end = |end: &Option<Rational>, sign: Sign| {
            let apart = |q: &Rational| exact::computed(|one| (self.exactly(one)? - one.rational(q)).sign(), |_| true);
            end.as_ref().is_none_or(|q| apart(q) == Some(sign))
        };
        end(&side.lo, Sign::Positive) && end(&side.hi, Sign::Negative)
    }

    /// The point with this number in the place of one of its own.
    pub(super) fn on_line(&self, point: &[Rational], free: usize) -> Vec<Place> {
        let own = |(k, q): (usize, &Rational)| if k == free { self.clone() } else { Place::of(q.clone()) };
        point.iter().enumerate().map(own).collect()
    }

    pub(super) fn of(q: Rational) -> Self {
        Place::rational(Outer::Itself, q)
    }

    /// The square root of a number, or its negative.
    pub(super) fn root(square: Rational, sign: Sign) -> Self {
        let b = rational(if sign == Sign::Negative { -1 } else { 1 }, 1);
        match square.sqrt() {
            Ok(root) => Place::of(b * root),
            Err(_) => Place { b, d: square, ..Place::of(rational(0, 1)) },
        }
    }

    /// The exponential of a number.
    pub(super) fn exponential(q: Rational) -> Self {
        Place::rational(Outer::Exponential, q)
    }
}

/// The numbers of a point.
pub(super) fn exactly(places: &[Place], one: &Exact) -> Option<Vec<Exact>> {
    places.iter().map(|place| place.exactly(one)).collect()
}

/// Whether a function is 0 at a point, exactly.
pub(super) fn vanishes<F: Function>(function: &F, places: &[Place]) -> bool {
    sign(function, places) == Some(Sign::Zero)
}

/// Whether a function has a value near a point, by an enclosure.
pub(super) fn has_value<F: Function>(function: &F, places: &[Place]) -> bool {
    enclosed(function, places).is_some_and(|value| !value.is_empty())
}

/// Encloses a function at a point, where it has a value all around it.
fn enclosed<F: Function>(function: &F, places: &[Place]) -> Option<Extended> {
    let boxed: Vec<Extended> = places.iter().map(Place::enclosure).collect::<Option<_>>()?;
    function.value(&boxed).ok().filter(|value| value.defined)
}

/// The sign of a function at a point, exactly; by an enclosure where the point is enclosed.
fn sign<F: Function>(function: &F, places: &[Place]) -> Option<Sign> {
    if places.iter().any(Place::is_enclosed) {
        return enclosed(function, places)?.sign();
    }
    exact::computed(|one| function.value(&exactly(places, one)?).ok()?.sign(), |_| true)
}

/// The truth of a clause at a point.
pub(super) fn truth<F: Function>(clause: &[Literal<F>], places: &[Place]) -> Signs {
    let signs: Vec<Option<Sign>> = clause.iter().map(|literal| sign(&literal.function, places)).collect();
    // What is enclosed from 0 on is not negative, whatever its sign.
    let not_below = |function: &F| enclosed(function, places).is_some_and(|value| !value.is_empty() && value.lo >= 0.0);
    let own = |(sign, literal): (&Option<Sign>, &Literal<F>)| match (sign, literal.compared) {
        (None, Compared::NotNegative) => not_below(&literal.function).then_some(true),
        (sign, compared) => sign.map(|sign| compared.admits(sign)),
    };
    let truths: Vec<Option<bool>> = signs.iter().zip(clause).map(own).collect();
    if truths.contains(&Some(true)) {
        Signs::Holds { zero: signs.contains(&Some(Sign::Zero)) }
    } else if truths.iter().all(|truth| *truth == Some(false)) {
        Signs::Fails
    } else {
        Signs::Unknown
    }
}

/// Points near floats, in a box, at which a function may be known exactly: those in closed form, then those with solutions of equations that its parts give.
pub(super) fn points_near<F: Function>(function: &F, x: &[f64], sides: &[Side]) -> impl Iterator<Item = Vec<Place>> {
    let solutions = move || {
        let found = solutions::near(function, x, sides);
        let any = found.iter().any(|own| !own.is_empty());
        if any { points_of(x, sides, &found) } else { Vec::new() }
    };
    points_of(x, sides, &vec![Vec::new(); sides.len()]).into_iter().chain(std::iter::once_with(solutions).flatten())
}

/// Of each number these solutions, or a few simple forms.
fn points_of(x: &[f64], sides: &[Side], solutions: &[Vec<Place>]) -> Vec<Vec<Place>> {
    const MOST_FORMS: usize = 3;
    const MOST_POINTS: usize = 16;
    let mut points = vec![Vec::new()];
    for ((x, side), solutions) in x.iter().zip(sides).zip(solutions) {
        let own = match side.as_point() {
            Some(q) => vec![Place::of(q.clone())],
            None => {
                let (lo, hi) = side.floats();
                let ends = [(lo, &side.lo), (hi, &side.hi)].into_iter().filter(|(end, _)| end == x);
                let ends = ends.filter_map(|(_, end)| end.clone().map(Place::of));
                let known = ends.chain(forms(*x)).filter(|form| form.is_in(side)).take(MOST_FORMS);
                solutions.iter().filter(|own| own.is_in(side)).cloned().chain(known).collect()
            }
        };
        let longer = |before: &Vec<Place>| -> Vec<Vec<Place>> {
            own.iter().map(|form| before.iter().chain([form]).cloned().collect()).collect()
        };
        points = points.iter().flat_map(longer).take(MOST_POINTS).collect();
    }
    points
}

/// As the language writes it.
impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // `3*pi/4`, `sqrt(2)/2`.
        let times = |q: &Rational, what: &str| {
            let over = if q.is_integer() { String::new() } else { format!("/{}", q.denom()) };
            match q.numer().to_i64() {
                Some(1) => format!("{what}{over}"),
                Some(-1) => format!("-{what}{over}"),
                _ => format!("{}*{what}{over}", q.numer()),
            }
        };
        if self.outer == Outer::Between {
            let end = |q: &Rational, up: bool| decimal(q, 12, up);
            return write!(f, "[{}, {}]", end(&self.a, false), end(&self.b, true));
        }
        let root = || times(&self.b, &format!("sqrt({})", self.d));
        let inside = match (self.b.is_zero(), self.a.is_zero()) {
            (true, _) => self.a.to_string(),
            (_, true) => root(),
            _ => format!("{} + {}", self.a, root()),
        };
        match self.outer {
            Outer::Itself => f.write_str(&inside),
            Outer::TimesPi => f.write_str(&times(&self.a, "pi")),
            Outer::OverPi if self.a.is_integer() => write!(f, "{}/pi", self.a),
            Outer::OverPi => write!(f, "{}/({}*pi)", self.a.numer(), self.a.denom()),
            Outer::Exponential => write!(f, "exp({inside})"),
            Outer::Root(degree) => match (self.inside_is_negative(), self.b.is_zero()) {
                (false, true) if self.a.is_integer() => write!(f, "{inside}^(1/{degree})"),
                (false, _) => write!(f, "({inside})^(1/{degree})"),
                (true, true) if self.a.is_integer() => write!(f, "-{}^(1/{degree})", -self.a.clone()),
                (true, true) => write!(f, "-({})^(1/{degree})", -self.a.clone()),
                (true, false) => write!(f, "-(-({inside}))^(1/{degree})"),
            },
            Outer::Logarithm(1) => write!(f, "log({inside})"),
            Outer::Logarithm(k) => write!(f, "log({inside})/{k}"),
            Outer::OverLogarithm => write!(f, "1/log({inside})"),
            Outer::Between => Ok(()),
        }
    }
}

/// How far a number in closed form may be from its float.
fn fine(x: f64) -> f64 {
    1e-12 * x.abs().max(1e-3)
}

/// A simple rational near a float: of this size at most away from it, with this denominator at most.
pub(super) fn simple(x: f64, reach: f64, most: i64) -> Option<Rational> {
    let (exact, reach) = (Rational::from_float(x)?, Rational::from_float(reach)?);
    let found = simplest_between(&(&exact - &reach), &(exact + reach));
    (found.denom() <= most.into()).then_some(found)
}

/// A rational or a root of a quadratic equation with small coefficients near a float: `a`, `b`, `d` of `a + b sqrt(d)`.
fn quadratic(x: f64) -> Option<(Rational, Rational, Rational)> {
    const DENOMINATOR: i64 = 2000;
    const LEAD: i64 = 36;
    const MIDDLE: i64 = 40;
    if !x.is_finite() || x.abs() > 1e6 {
        return None;
    }
    if let Some(q) = simple(x, fine(x), DENOMINATOR) {
        return Some((q, rational(0, 1), rational(0, 1)));
    }
    let middles = || std::iter::once(0).chain((1..=MIDDLE).flat_map(|b| [b, -b]));
    let equation = (1..=LEAD).flat_map(|a| middles().map(move |b| (a, b))).find_map(|(a, b)| {
        let sum = a as f64 * x * x + b as f64 * x;
        let size = a as f64 * x * x + (b as f64 * x).abs();
        let c = -sum.round();
        let discriminant = (b * b) as f64 - 4.0 * a as f64 * c;
        let fits = (sum + c).abs() <= 1e-12 * size.max(1.0) && c.abs() < 1e6 && discriminant > 0.0;
        fits.then_some((a, b, c as i64))
    })?;
    let (a, b, c) = equation;
    let mut factor = if x * 2.0 * a as f64 + b as f64 > 0.0 { 1 } else { -1 };
    let mut discriminant = b * b - 4 * a * c;
    for p in [2, 3, 5, 7, 11, 13] {
        while discriminant % (p * p) == 0 {
            (discriminant, factor) = (discriminant / (p * p), factor * p);
        }
    }
    Some((rational(-b, 2 * a), rational(factor, 2 * a), rational(discriminant, 1)))
}

/// Closed forms near a float.
fn forms(x: f64) -> Vec<Place> {
    const PARTS: i64 = 24;
    const MULTIPLES: i64 = 4;
    const DEGREES: [u32; 4] = [3, 5, 6, 7];
    let mut list: Vec<Place> = Vec::new();
    let mut push = |outer: Outer, y: f64| {
        list.extend(quadratic(y).map(|(a, b, d)| Place { outer, a, b, d, equation: None }));
    };
    push(Outer::Itself, x);
    (1..=MULTIPLES).for_each(|k| push(Outer::Logarithm(k), (k as f64 * x).exp()));
    push(Outer::Exponential, x.ln());
    push(Outer::OverLogarithm, (1.0 / x).exp());
    DEGREES.into_iter().filter(|degree| x > 0.0 || degree % 2 == 1).for_each(|degree| {
        push(Outer::Root(degree), x.powi(degree as i32));
    });
    let turns = x / std::f64::consts::PI;
    list.extend(simple(turns, fine(turns), PARTS).map(|q| Place::rational(Outer::TimesPi, q)));
    let over = x * std::f64::consts::PI;
    list.extend(simple(over, fine(over), PARTS).map(|q| Place::rational(Outer::OverPi, q)));
    list
}

/// The floats at which a function changes its sign, or its slope does, between neighbours among points.
fn turns(of: impl Fn(f64) -> Option<(f64, f64)>, points: &[f64]) -> Vec<f64> {
    const STEPS: usize = 90;
    let mut found = Vec::new();
    let values: Vec<Option<(f64, f64)>> = points.iter().map(|&x| of(x)).collect();
    for (place, pair) in values.windows(2).enumerate() {
        let (Some(left), Some(right)) = (pair[0], pair[1]) else { continue };
        for (first, second, slope) in [(left.0, right.0, false), (left.1, right.1, true)] {
            if first * second > 0.0 || first == 0.0 && second == 0.0 || first.is_nan() || second.is_nan() {
                continue;
            }
            let (mut lo, mut hi) = (points[place], points[place + 1]);
            for _ in 0..STEPS {
                let middle = lo + (hi - lo) / 2.0;
                let Some(own) = of(middle) else { break };
                let own = if slope { own.1 } else { own.0 };
                if own == 0.0 {
                    (lo, hi) = (middle, middle);
                } else if (own > 0.0) == (first > 0.0 || first == 0.0 && second < 0.0) {
                    lo = middle;
                } else {
                    hi = middle;
                }
            }
            found.push(lo + (hi - lo) / 2.0);
        }
    }
    found
}

/// Points of a side, nearer together around 0 where it has no end.
pub(super) fn spread(side: &Side) -> Vec<f64> {
    let (lo, hi) = side.floats();
    let share = |k: usize| (k as f64 + 0.5) / POINTS as f64;
    let point = |k: usize| match (lo.is_finite(), hi.is_finite()) {
        (true, true) => lo + (hi - lo) * k as f64 / (POINTS - 1) as f64,
        (true, false) => lo + 3.0 * share(k) / (1.0 - share(k)),
        (false, true) => hi - 3.0 * (1.0 - share(k)) / share(k),
        (false, false) => {
            let t = 2.0 * share(k) - 1.0;
            4.0 * t / (1.0 - t * t)
        }
    };
    (0..POINTS).map(point).collect()
}

/// The sides that are not numbers.
pub(super) fn free(sides: &[Side]) -> Vec<usize> {
    (0..sides.len()).filter(|&k| sides[k].as_point().is_none()).collect()
}

/// The only side that is not a number.
pub(super) fn only_free(sides: &[Side]) -> Option<usize> {
    if let [only] = free(sides)[..] { Some(only) } else { None }
}

/// Floats in the domain, which has one free number, near which a literal may be 0.
fn near<F: Function>(clause: &[Literal<F>], domain: &[Side], free: usize) -> Vec<f64> {
    let floats: Vec<f64> = domain.iter().map(|side| side.middle().to_f64().unwrap_or(0.0)).collect();
    let points = spread(&domain[free]);
    let (lo, hi) = domain[free].floats();
    let mut near: Vec<f64> = Vec::new();
    for literal in clause {
        let of = |x: f64| {
            let seeded: Vec<Dual<f64>> = floats
                .iter()
                .enumerate()
                .map(|(k, y)| if k == free { Dual::new(x, 1.0) } else { Dual::new(*y, 0.0) })
                .collect();
            literal.function.value(&seeded).ok().map(|value| (value.value, value.derivative))
        };
        for x in turns(of, &points) {
            let is_zero = of(x).is_some_and(|(value, _)| value.abs() <= NEAR) && lo <= x && x <= hi;
            if is_zero && !near.iter().any(|own| (own - x).abs() <= 1e-9 * x.abs().max(1.0)) {
                near.push(x);
            }
        }
    }
    near.truncate(MOST);
    near
}

/// Places in the domain, which has one free number, at which a literal is exactly 0.
pub(super) fn zeros<F: Function>(clause: &[Literal<F>], domain: &[Side]) -> Vec<Place> {
    let Some(free) = only_free(domain).filter(|&k| !domain[k].integer) else { return Vec::new() };
    let point: Vec<Rational> = domain.iter().map(Side::middle).collect();
    let is_zero = |place: &Place| {
        if !place.lies_in(&domain[free]) {
            return false;
        }
        let places = place.on_line(&point, free);
        clause.iter().any(|literal| sign(&literal.function, &places) == Some(Sign::Zero))
    };
    let at = |x: f64| -> Vec<f64> {
        let own = |(k, q): (usize, &Rational)| if k == free { x } else { q.to_f64().unwrap_or(0.0) };
        point.iter().enumerate().map(own).collect()
    };
    let solutions = |x: f64, literal: &Literal<F>| solutions::near(&literal.function, &at(x), domain).swap_remove(free);
    let found = |x: f64| {
        let known = forms(x).into_iter().find(&is_zero);
        known.or_else(|| clause.iter().flat_map(|literal| solutions(x, literal)).find(&is_zero))
    };
    near(clause, domain, free).into_iter().filter_map(found).collect()
}

/// In words, where the two sides of a clause in one free number agree to very many digits, but no identity is known that makes them equal.
pub(super) fn coincidence<F: Function>(clause: &[Literal<F>], domain: &[Side]) -> Option<String> {
    const FEWEST: i64 = 100;
    let free = only_free(domain).filter(|&k| !domain[k].integer)?;
    let point: Vec<Rational> = domain.iter().map(Side::middle).collect();
    let known: Vec<Place> = zeros(clause, domain);
    let found = near(clause, domain, free).into_iter().filter(|x| {
        let apart = |place: &Place| {
            let reach = 1e-9 * x.abs().max(1.0);
            place.enclosure().is_some_and(|own| own.hi < x - reach || x + reach < own.lo)
        };
        known.iter().all(apart)
    });
    let mut all =
        found.flat_map(|x| clause.iter().flat_map(move |literal| [false, true].map(|slope| (x, literal, slope))));
    all.find_map(|(x, literal, slope)| {
        let bits = agreement(&literal.function, &point, free, x, slope).filter(|bits| *bits >= FEWEST)?;
        Some(format!(
            "where the only number is near {x}, the two sides agree to 2^-{bits}, and no identity tells whether they are equal there"
        ))
    })
}

/// In words, where the two sides of a clause in several numbers all but agree: near an open box.
pub(super) fn all_but_equal<F: Function>(clause: &[Literal<F>], sides: &[Side], domain: &[Side]) -> Option<String> {
    const SMALL: f64 = 1e-12;
    let ends: Vec<(f64, f64)> = domain.iter().map(Side::floats).collect();
    let near_zero = |literal: &Literal<F>| {
        let mut x: Vec<f64> = sides.iter().map(|side| side.middle().to_f64().unwrap_or(0.0)).collect();
        polish(&literal.function, &mut x, &ends);
        let value = literal.function.value(&x).ok()?;
        (value.abs() <= SMALL).then(|| (least(&literal.function, &x, domain), x))
    };
    let (least, x) = clause.iter().find_map(near_zero)?;
    let numbers: Vec<String> = x.iter().map(ToString::to_string).collect();
    let near = format!("near ({})", numbers.join(", "));
    Some(match least {
        Some(value) => format!(
            "{near} there is one point, proved by Newton's method in intervals, at which their difference is least; it is at most 10^-{} there, and no identity tells \
             whether it is 0",
            (-value.lo.abs().max(value.hi.abs()).log10()).floor().clamp(0.0, 300.0)
        ),
        None => format!(
            "{near} the two sides differ by less than 10^-12, and whether they are equal there no identity tells, or no rule decides what follows"
        ),
    })
}

/// To how many bits a function is zero near a float: after steps of Newton's method, towards a zero of the slope if that is asked for.
fn agreement<F: Function>(function: &F, point: &[Rational], free: usize, x: f64, slope: bool) -> Option<i64> {
    const BITS: u32 = 320;
    const STEPS: usize = 4;
    let number = |q: Rational| PreciseNumber::exact(q, BITS);
    let mut x = Rational::from_float(x)?;
    for step in 0..=STEPS {
        let at: Vec<Series<PreciseNumber>> = point
            .iter()
            .enumerate()
            .map(|(k, q)| {
                let moves = |m: i64| number(rational(i64::from(k == free && m == 1), 1));
                Series::from_coefficients(number(if k == free { x.clone() } else { q.clone() }), (1..3).map(moves))
            })
            .collect();
        let value = function.value(&at).ok()?;
        let [f, first, second] = value.coefficients() else { return None };
        if step == STEPS {
            return Some((-f.number.enclosure(BITS).magnitude().top()).min(i64::from(BITS)));
        }
        let change = if slope { first.over(&(second.clone() + second)) } else { f.over(first) }.ok()?;
        let (lo, hi) = change.number.enclosure(BITS).to_rationals();
        // Of as many bits as matter.
        let next = &x - (lo + hi) * rational(1, 2);
        let scale = Rational::from_integer(BigInt::from(1) << BITS);
        x = (next * &scale).floor() / scale;
    }
    None
}
