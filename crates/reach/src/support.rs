//! The integral of `max (lo h, hi h)`, step by step: the greatest value that an input between `lo` and `hi` makes of a response `h`.

use crate::scalar::Scalar;
use crate::signs::Expansion;
use crate::system::Range;
use arithmetic::{Enclosure, FloatInterval, Rational, Sign};
use num_traits::ToPrimitive;

/// A worst case.
pub(crate) struct Found {
    pub value: FloatInterval,
    /// Up to which time the response was followed.
    pub time: Rational,
    /// From which time on the response is positive, or not, backwards from the end.
    pub signs: Vec<(Rational, bool)>,
    /// How much an input with these signs may miss where the sign is not known.
    pub unsigned: f64,
}

/// What was added up so far.
pub(crate) struct Support {
    total: FloatInterval,
    ends: [FloatInterval; 2],
    /// The largest absolute value of the input.
    most: FloatInterval,
    /// See [`Found`].
    time: Rational,
    signs: Vec<(Rational, bool)>,
    unsigned: FloatInterval,
}

impl Support {
    /// Nothing, for inputs in a range around 0.
    pub fn new(range: &Range) -> Self {
        let ends = [&range.lo, &range.hi].map(FloatInterval::from_rational);
        let most = FloatInterval::point(ends[0].magnitude().max(ends[1].magnitude()));
        let (total, unsigned) = (FloatInterval::ZERO, FloatInterval::ZERO);
        Support { total, ends, most, time: Rational::ZERO, signs: Vec::new(), unsigned }
    }

    /// Adds a part of a step, `[0, end]` of it from the time `from` on; the step is given as a float, which it is, and as a rational.
    pub fn add(
        &mut self,
        h: &Expansion<FloatInterval>,
        from: &Rational,
        end: &Rational,
        (step, unit): (f64, &Rational),
    ) {
        let step = FloatInterval::point(step);
        let ends = self.ends;
        let signed = |sign: Sign| if sign == Sign::Positive { ends[1] } else { ends[0] };
        self.time = from + end * unit;
        if let Some(sign) = h.plain_sign(end.to_f64().map_or(1.0, f64::next_up), 0.0) {
            self.total = self.total + h.integral(&Rational::ZERO, end) * signed(sign) * step;
            self.note(from.clone(), sign == Sign::Positive);
            return;
        }
        for part in h.parts(end) {
            let added = match part.sign {
                Some(sign) => {
                    self.note(from + &part.from * unit, sign == Sign::Positive);
                    h.integral(&part.from, &part.to) * signed(sign)
                }
                None => {
                    let width = FloatInterval::from_rational(&(&part.to - &part.from));
                    let most = (h.size(&part.from, &part.to) * width * self.most).top();
                    self.unsigned = (self.unsigned + most * step).top();
                    FloatInterval::ZERO.joined(&most)
                }
            };
            self.total = self.total + added * step;
        }
    }

    fn note(&mut self, from: Rational, positive: bool) {
        if self.signs.last().is_none_or(|(_, last)| *last != positive) {
            self.signs.push((from, positive));
        }
    }

    /// The worst case, where the integral of the absolute value of what was left out of the response is bounded by `missed`.
    pub fn found(self, missed: &FloatInterval) -> Found {
        let value = self.total + FloatInterval::symmetric(&(*missed * self.most).top());
        // An input that rests attains 0.
        let value = value.intersection(&FloatInterval::between(0.0, f64::MAX)).unwrap_or(value);
        Found { value, time: self.time, signs: self.signs, unsigned: self.unsigned.hi() }
    }
}
