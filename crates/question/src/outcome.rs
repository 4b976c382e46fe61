//! What was found for a point, for a case, for a whole family.

use crate::bindings::{Bindings, Value};
use crate::truth::{Margin, Truth};
use polynomials::sums::Certificate;
use std::fmt;

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

/// A member with a number in closed form among its values, `x = 1/2*pi`, which the language has as an expression only, or with one that is enclosed: `x in [..]`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Spot(Vec<(String, String)>);

impl Spot {
    /// A member with a text in the place of some values.
    pub(crate) fn of(bindings: &Bindings, texts: &[(usize, String)]) -> Self {
        let text = |(place, (name, value)): (usize, (&str, &Value))| {
            let own = texts.iter().find(|(own, _)| *own == place).map(|(_, text)| text.clone());
            (name.to_string(), own.unwrap_or_else(|| value.text()))
        };
        Spot(bindings.iter().enumerate().map(text).collect())
    }

    /// Whether a number is enclosed, and not in closed form.
    pub fn is_enclosed(&self) -> bool {
        self.iter().any(|(_, text)| text.starts_with('['))
    }

    /// Names with the texts of their values.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &str)> {
        self.0.iter().map(|(name, text)| (name.as_str(), text.as_str()))
    }
}

impl fmt::Display for Spot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let is = |text: &str| if text.starts_with('[') { "in" } else { "=" };
        let pairs: Vec<String> = self.iter().map(|(name, text)| format!("{name} {} {text}", is(text))).collect();
        f.write_str(&pairs.join(", "))
    }
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
    pub attained: Option<Spot>,
    /// A number in closed form at which the property fails, where it fails at no rational one that was found.
    pub closed: Option<Spot>,
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
    /// The first names for which the margin is 0, where the property holds.
    pub attained: Option<Spot>,
    /// A number in closed form at which the property fails, where it fails at no rational one that was found.
    pub closed: Option<Spot>,
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
            closed: None,
            certificates: Vec::new(),
            uncertified: 0,
            unsettled: None,
        }
    }
}
