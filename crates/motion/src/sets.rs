//! What questions about sets of motions share, whoever answers them: intervals of starts, inputs and parameters, verdicts, and quantities over time.

use arithmetic::{Rational, rational};

/// From `lo` to `hi`, both included. A box of starts, inputs or parameters has one for each of its names.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Range {
    /// The lower end.
    pub lo: Rational,
    /// The upper end, not below the lower one.
    pub hi: Rational,
}

impl Range {
    /// One number.
    pub fn point(x: Rational) -> Self {
        Range { lo: x.clone(), hi: x }
    }

    /// Half the sum of the ends.
    pub fn centre(&self) -> Rational {
        (&self.lo + &self.hi) * rational(1, 2)
    }

    /// Half the difference of the ends.
    pub fn radius(&self) -> Rational {
        (&self.hi - &self.lo) * rational(1, 2)
    }

    /// Whether it is one number.
    pub fn is_point(&self) -> bool {
        self.lo == self.hi
    }

    /// Both ends moved by the same number.
    pub fn moved(&self, by: &Rational) -> Self {
        Range { lo: &self.lo + by, hi: &self.hi + by }
    }

    /// All negatives.
    pub fn negated(&self) -> Self {
        Range { lo: -&self.hi, hi: -&self.lo }
    }
}

/// What was found about a statement on all motions of a set. The larger one says more against it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// True for all of them, proved.
    Holds,
    /// Neither could be established.
    Undecided,
    /// False for one of them.
    False,
    /// A control was not refuted, so that nothing is said.
    Withheld,
}

impl Verdict {
    /// One word.
    pub fn word(self) -> &'static str {
        match self {
            Verdict::Holds => "holds",
            Verdict::False => "false",
            Verdict::Undecided => "undecided",
            Verdict::Withheld => "withheld",
        }
    }

    /// The exit status of the command line.
    pub fn status(self) -> u8 {
        match self {
            Verdict::Holds => 0,
            Verdict::False => 1,
            Verdict::Undecided => 3,
            Verdict::Withheld => 4,
        }
    }
}

/// A quantity over time: `[from, to, least, most]` for one short time after the other.
#[derive(Debug, Clone, PartialEq)]
pub struct Tube {
    /// The quantity as the question writes it.
    pub quantity: String,
    /// Of all motions of the set: no value lies outside. Empty where that is not known.
    pub sections: Vec<[f64; 4]>,
    /// Of single motions.
    pub runs: Vec<Vec<[f64; 4]>>,
}
