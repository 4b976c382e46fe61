//! What was found for a point, for a case, for a whole family.

use crate::bindings::Bindings;
use crate::truth::{Margin, Truth};
use polynomials::sums::Certificate;

/// What was found for one point.
#[derive(Debug, Clone)]
pub(crate) struct Judged {
    pub truth: Truth,
    pub margin: Margin,
    pub inequalities: Vec<Margin>,
}

/// What is open of a continuum.
#[derive(Debug, Clone)]
pub struct Unsettled {
    /// Its share of the volume.
    pub share: Option<f64>,
    /// Boxes of it, not all where there are very many.
    pub boxes: Vec<Bindings>,
}

/// What was found for one case.
#[derive(Debug, Clone)]
pub struct Decided {
    /// Whether the property holds for all that the names stand for.
    pub truth: Truth,
    /// Encloses the smallest margin.
    pub margin: Margin,
    /// The same of each inequality of the property by itself.
    pub inequalities: Vec<Margin>,
    /// Whether `where` leaves the case out.
    pub excluded: bool,
    /// Members or boxes that were looked at.
    pub boxes: u64,
    /// Boxes that stayed undecided.
    pub open: u64,
    /// Names for which the property fails, confirmed.
    pub counterexample: Option<Bindings>,
    /// Names for which the margin is 0, where the property holds.
    pub attained: Option<Bindings>,
    /// Sums of squares that the decision rests on.
    pub certificates: Vec<Certificate>,
    /// Parts of the property that were proved without one.
    pub uncertified: u64,
    /// Share of the volume that is open, with boxes of it, where boxes were not enough.
    pub unsettled: Option<Unsettled>,
}

/// The outcome of a property over a whole family.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// True for all, false for some, or not known.
    pub truth: Truth,
    /// Encloses the smallest margin of all that were looked at.
    pub margin: Option<Margin>,
    /// The same of each inequality of the property by itself.
    pub inequalities: Vec<Margin>,
    /// Members of the family, a continuum counting as one.
    pub total: u64,
    /// Members, or boxes of members, that were looked at.
    pub cases: u64,
    /// Those that stayed undecided.
    pub open: u64,
    /// Whether a continuum was among them.
    pub boxed: bool,
    /// The first counterexample.
    pub counterexample: Option<Bindings>,
    /// Names for which the margin is 0, where the property holds and a continuum was divided.
    pub attained: Option<Bindings>,
    /// Sums of squares that the decision rests on.
    pub certificates: Vec<Certificate>,
    /// Parts of the property that were proved without one.
    pub uncertified: u64,
    /// What is open of the first member that is.
    pub unsettled: Option<Unsettled>,
}

impl Decided {
    /// Nothing was looked at yet.
    pub(crate) fn nothing() -> Self {
        Decided {
            truth: Truth::True,
            margin: Margin::of_truth(true),
            inequalities: Vec::new(),
            excluded: false,
            boxes: 0,
            open: 0,
            counterexample: None,
            attained: None,
            certificates: Vec::new(),
            uncertified: 0,
            unsettled: None,
        }
    }
}
