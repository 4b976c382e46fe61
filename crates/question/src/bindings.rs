//! What the names of a question stand for in one case.

use algebra::graph::AnyGraph;
use algebra::matrix::StochasticMatrix;
use arithmetic::{Rational, rational, simplest_between};
use motion::sets::Range;
use polynomials::Side;
use std::fmt;
use std::sync::Arc;

/// What a name stands for.
#[derive(Debug, Clone)]
pub enum Value {
    /// A number.
    Number(Rational),
    /// Every number between two.
    Box(Range),
    /// Every integer between two, the second one larger.
    Integers(i64, i64),
    /// Every real number.
    Any,
    /// A graph.
    Graph(Arc<AnyGraph>),
    /// A sequence of stochastic matrices, the first factor first.
    Matrices(Arc<Vec<StochasticMatrix>>),
    /// One number for each follower of a platoon.
    Each(Arc<Vec<Rational>>),
}

impl Value {
    /// Whether it is a continuum.
    pub fn is_interval(&self) -> bool {
        matches!(self, Value::Box(..) | Value::Any)
    }

    /// The smallest and the largest number of a box.
    pub fn ends(&self) -> Option<Range> {
        match self {
            Value::Box(range) => Some(range.clone()),
            Value::Integers(from, to) => Some(Range { lo: rational(*from, 1), hi: rational(*to, 1) }),
            _ => None,
        }
    }

    /// The two halves of a box.
    pub(crate) fn halves(&self) -> Option<[Value; 2]> {
        match self {
            Value::Box(range) => {
                let (Range { lo, hi }, middle) = (range.clone(), range.centre());
                Some([Range { lo, hi: middle.clone() }, Range { lo: middle, hi }].map(Value::Box))
            }
            Value::Integers(from, to) => {
                let middle = from + (to - from) / 2;
                Some([Value::integers(*from, middle), Value::integers(middle + 1, *to)])
            }
            _ => None,
        }
    }

    /// All integers between two: a number where they are one.
    pub(crate) fn integers(from: i64, to: i64) -> Self {
        if from == to { Value::Number(rational(from, 1)) } else { Value::Integers(from, to) }
    }

    /// The simplest number near the middle of a box.
    fn middle(&self) -> Option<Rational> {
        match self {
            Value::Box(range) => {
                let (middle, quarter) = (range.centre(), range.radius() * rational(1, 2));
                Some(simplest_between(&(&middle - &quarter), &(&middle + &quarter)))
            }
            Value::Integers(from, to) => Some(rational(from + (to - from) / 2, 1)),
            Value::Any => Some(rational(0, 1)),
            _ => None,
        }
    }

    /// A text that stands for it in a question, without quotes.
    pub fn text(&self) -> String {
        match self {
            Value::Number(q) => q.to_string(),
            Value::Box(Range { lo, hi }) => format!("[{lo}, {hi}]"),
            Value::Integers(from, to) => format!("integers({from}, {to})"),
            Value::Any => "any".to_string(),
            Value::Graph(graph) => graph.to_string(),
            Value::Each(list) => format!("each:{}", list.iter().map(ToString::to_string).collect::<Vec<_>>().join(",")),
            Value::Matrices(list) => {
                let row = |row: &Vec<Rational>| row.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ");
                let matrix = |m: &StochasticMatrix| {
                    m.to_rational_matrix().to_rows().iter().map(row).collect::<Vec<_>>().join("; ")
                };
                format!("matrices:{}", list.iter().map(matrix).collect::<Vec<_>>().join(" | "))
            }
        }
    }
}

/// The names of a case with what they stand for, in the order of the question.
#[derive(Debug, Clone, Default)]
pub struct Bindings {
    entries: Vec<(Arc<str>, Value)>,
}

impl Bindings {
    /// What a name stands for.
    pub fn get(&self, name: &str) -> Option<&Value> {
        self.entries.iter().find(|(known, _)| known.as_ref() == name).map(|(_, value)| value)
    }

    /// All names with their values.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &Value)> {
        self.entries.iter().map(|(name, value)| (name.as_ref(), value))
    }

    /// The first names with their values.
    pub(crate) fn first(&self, count: usize) -> Self {
        Bindings { entries: self.entries.iter().take(count).cloned().collect() }
    }

    pub(crate) fn push(&mut self, name: Arc<str>, value: Value) {
        self.entries.push((name, value));
    }

    pub(crate) fn pop(&mut self) {
        self.entries.pop();
    }

    pub(crate) fn set(&mut self, place: usize, value: Value) {
        if let Some(entry) = self.entries.get_mut(place) {
            entry.1 = value;
        }
    }

    /// The names that stand for boxes, with their places.
    pub(crate) fn boxes(&self) -> Vec<(usize, Range)> {
        let ends = |(k, (_, value)): (usize, &(Arc<str>, Value))| value.ends().map(|range| (k, range));
        self.entries.iter().enumerate().filter_map(ends).collect()
    }

    /// The names that stand for more than one number, with their places.
    pub(crate) fn sides(&self) -> Vec<(usize, Side)> {
        let side = |(k, (_, value)): (usize, &(Arc<str>, Value))| match value {
            Value::Box(Range { lo, hi }) => Some((k, Side::between(lo.clone(), hi.clone()))),
            Value::Integers(from, to) => Some((k, Side::integers(*from, *to))),
            Value::Any => Some((k, Side::line())),
            _ => None,
        };
        self.entries.iter().enumerate().filter_map(side).collect()
    }

    /// Whether a name stands for all reals.
    pub(crate) fn has_line(&self) -> bool {
        self.entries.iter().any(|(_, value)| matches!(value, Value::Any))
    }

    /// The two halves of the box that stands in a place.
    pub(crate) fn halves(&self, place: usize) -> Option<[Self; 2]> {
        let with = |value: Value| {
            let mut half = self.clone();
            half.set(place, value);
            half
        };
        Some(self.entries.get(place)?.1.halves()?.map(with))
    }

    /// Every box replaced by its simplest number near the middle.
    pub(crate) fn middle(&self) -> Self {
        self.at(Value::middle)
    }

    /// Every box replaced by its simplest number.
    pub(crate) fn simplest(&self) -> Self {
        self.at(|value| match value {
            Value::Any => Some(rational(0, 1)),
            value => value.ends().map(|Range { lo, hi }| simplest_between(&lo, &hi)),
        })
    }

    fn at(&self, number: impl Fn(&Value) -> Option<Rational>) -> Self {
        let mut point = self.clone();
        for (_, value) in &mut point.entries {
            if let Some(number) = number(value) {
                *value = Value::Number(number);
            }
        }
        point
    }
}

impl fmt::Display for Bindings {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (k, (name, value)) in self.iter().enumerate() {
            write!(f, "{}{name} = {}", if k > 0 { ", " } else { "" }, value.text())?;
        }
        Ok(())
    }
}
