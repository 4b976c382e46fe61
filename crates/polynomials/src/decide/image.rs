//! Where a function takes a value: a point of the domain between two at which it lies on both sides of the value.

use super::attained::at_share;
use super::local::sign_at;
use super::places::{Place, has_value, simple, spread};
use crate::function::{Function, Side};
use arithmetic::{ArithmeticError, Number, Rational, Sign, random, rational};
use num_traits::ToPrimitive;

/// Lines along which it is looked for.
const LINES: usize = 24;
/// How far the other numbers may be from those that were drawn.
const COARSE: f64 = 0.02;
/// Times that what is between two points is halved.
const HALVINGS: usize = 60;

/// A function less a number.
struct Less<'a, G>(&'a G, &'a Place);

impl<G: Function> Function for Less<'_, G> {
    fn value<T: Number>(&self, at: &[T]) -> Result<T, ArithmeticError> {
        let like = at.first().ok_or(ArithmeticError::Domain("a variable"))?;
        Ok(self.0.value(at)? - self.1.value(like)?)
    }
}

/// A function that takes a value somewhere, in numbers of which the others are known.
pub(super) struct Image<'a, G> {
    pub function: &'a G,
    pub value: &'a Place,
    /// The numbers that the function depends on.
    pub arguments: &'a [usize],
    /// What is put for all others.
    pub point: Vec<Place>,
}

impl<G: Function> Image<'_, G> {
    /// A point at which the function has the value, and of which more is true.
    pub fn point(&self, domain: &[Side], fits: impl Fn(&[Place]) -> bool) -> Option<Vec<Place>> {
        let target = self.value.value(&0.0).ok()?;
        let mut stream = random::generator("inequality", "images", domain.len() as u64);
        (0..LINES).find_map(|line| {
            let moving = self.arguments[line % self.arguments.len()];
            let number = |(k, side): (usize, &Side)| {
                let drawn = at_share(side, random::uniform(&mut stream));
                match (self.arguments.contains(&k), line < self.arguments.len()) {
                    (true, false) => Some(side.nearest(simple(drawn, COARSE * drawn.abs().max(1.0), i64::MAX)?)),
                    _ => Some(side.middle()),
                }
            };
            let start: Vec<Rational> = domain.iter().enumerate().map(number).collect::<Option<_>>()?;
            let floats: Vec<f64> = start.iter().map(|q| q.to_f64().unwrap_or(0.0)).collect();
            let of = |x: f64| {
                let mut at = floats.clone();
                at[moving] = x;
                self.function.value(&at[..]).ok().map(|value| value - target)
            };
            let points = spread(&domain[moving]);
            points.windows(2).find_map(|ends| {
                (of(ends[0])? * of(ends[1])? < 0.0).then_some(())?;
                let ends = (Rational::from_float(ends[0])?, Rational::from_float(ends[1])?);
                self.between(&start, moving, ends, domain).filter(|places| fits(places))
            })
        })
    }

    /// The point between two, by halving.
    fn between(
        &self,
        start: &[Rational],
        moving: usize,
        (mut lo, mut hi): (Rational, Rational),
        domain: &[Side],
    ) -> Option<Vec<Place>> {
        let at = |x: &Rational| {
            let mut point = start.to_vec();
            point[moving] = x.clone();
            sign_at(&Less(self.function, self.value), &point)
        };
        if !domain[moving].contains(&lo) || !domain[moving].contains(&hi) {
            return None;
        }
        let below = at(&lo).filter(|sign| *sign != Sign::Zero)?;
        at(&hi).filter(|sign| *sign != Sign::Zero && *sign != below)?;
        let mut found = None;
        for _ in 0..HALVINGS {
            let middle = (&lo + &hi) * rational(1, 2);
            match at(&middle)? {
                Sign::Zero => {
                    found = Some(Place::of(middle));
                    break;
                }
                sign if sign == below => lo = middle,
                _ => hi = middle,
            }
        }
        let mut places = self.point.clone();
        for &k in self.arguments {
            places[k] = Place::of(start[k].clone());
        }
        places[moving] = found.unwrap_or_else(|| Place::between(lo, hi));
        // Without a gap between: it is continuous where it has values.
        has_value(self.function, &places).then_some(places)
    }
}
