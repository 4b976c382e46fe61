//! Three truth values, and how far an inequality is from failing.

use arithmetic::{Dyadic, decimal};

/// True, false, or not known yet.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Truth {
    /// Proved.
    True,
    /// Refuted.
    False,
    /// Not known, with what stands in the way.
    Unknown(Doubt),
}

/// What stands in the way of a decision.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Doubt {
    /// In words.
    pub why: String,
    /// Bits of precision that will decide it, where that is known; `None` where more precision does not help.
    pub bits: Option<u64>,
}

impl Truth {
    pub(crate) fn of(value: bool) -> Self {
        if value { Truth::True } else { Truth::False }
    }

    pub(crate) fn unknown(why: impl Into<String>, bits: Option<u64>) -> Self {
        Truth::Unknown(Doubt { why: why.into(), bits })
    }

    pub(crate) fn negated(self) -> Self {
        match self {
            Truth::True => Truth::False,
            Truth::False => Truth::True,
            unknown => unknown,
        }
    }

    pub(crate) fn and(self, other: Self) -> Self {
        match (self, other) {
            (Truth::False, _) | (_, Truth::False) => Truth::False,
            (Truth::True, other) => other,
            (unknown, _) => unknown,
        }
    }
}

/// An enclosure of the margin: how much both sides of the decisive inequality may move before the property fails; negative where it
/// fails. `and` takes the smaller of two, `or` the larger, `always` the smallest over the time. Infinite where nothing is compared.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Margin {
    /// Lower end.
    pub lo: f64,
    /// Upper end.
    pub hi: f64,
}

impl Margin {
    /// That of a comparison that is known to hold: its smallest value is at least 0, and what is below in its enclosure is not met.
    pub(crate) fn held(self) -> Self {
        Margin { lo: self.lo.max(0.0).min(self.hi.max(0.0)), hi: self.hi.max(0.0) }
    }

    /// Nothing is known.
    pub(crate) const ANY: Margin = Margin { lo: f64::NEG_INFINITY, hi: f64::INFINITY };

    /// Of something that is true or false without comparison.
    pub(crate) fn of_truth(value: bool) -> Self {
        let end = if value { f64::INFINITY } else { f64::NEG_INFINITY };
        Margin { lo: end, hi: end }
    }

    /// Between two dyadics, rounded outward.
    pub(crate) fn between(lo: &Dyadic, hi: &Dyadic) -> Self {
        let exceeds = |x: f64, q: &Dyadic| Dyadic::from_f64(x).is_none_or(|x| x > *q);
        let below = |x: f64, q: &Dyadic| Dyadic::from_f64(x).is_none_or(|x| x < *q);
        let (a, b) = (lo.to_f64(), hi.to_f64());
        Margin { lo: if exceeds(a, lo) { a.next_down() } else { a }, hi: if below(b, hi) { b.next_up() } else { b } }
    }

    pub(crate) fn negated(self) -> Self {
        Margin { lo: -self.hi, hi: -self.lo }
    }

    pub(crate) fn least(self, other: Self) -> Self {
        Margin { lo: self.lo.min(other.lo), hi: self.hi.min(other.hi) }
    }

    pub(crate) fn largest(self, other: Self) -> Self {
        Margin { lo: self.lo.max(other.lo), hi: self.hi.max(other.hi) }
    }

    /// The smaller one of each two of two lists; an empty list says nothing.
    pub(crate) fn least_of_each(all: &mut Vec<Margin>, others: &[Margin]) {
        if all.is_empty() {
            all.extend_from_slice(others);
        }
        all.iter_mut().zip(others).for_each(|(own, other)| *own = own.least(*other));
    }

    /// Both ends as decimals rounded outward; `None` where there is no finite one.
    pub fn decimals(&self) -> Option<(String, String)> {
        let end = |x: f64, up: bool| Dyadic::from_f64(x).map(|q: Dyadic| decimal(&q.to_rational(), 12, up));
        end(self.lo, false).zip(end(self.hi, true))
    }
}
