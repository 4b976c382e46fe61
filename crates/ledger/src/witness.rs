//! A counterexample: its sentence, and what is in it, with its numbers.

use arithmetic::Rational;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt;
use std::ops::Deref;
use std::str::FromStr;

/// An exact number, `"p/q"` in documents.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Number(pub Rational);

impl Serialize for Number {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(&self.0)
    }
}

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        Rational::from_str(&text).map(Number).map_err(serde::de::Error::custom)
    }
}

impl From<&Rational> for Number {
    fn from(q: &Rational) -> Self {
        Number(q.clone())
    }
}

impl From<i64> for Number {
    fn from(n: i64) -> Self {
        Number(Rational::from_integer(n.into()))
    }
}

/// A pair of agents, from 0; of an arc the one that senses the other first.
pub type Link = (usize, usize);

/// A point or a vector of the plane.
pub type Point = [Number; 2];

/// What a counterexample consists of. Agents are counted from 0.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Witness {
    /// Agents in the plane, with their velocities where these are given, and the links between them.
    Agents {
        /// Where they are.
        places: Vec<Point>,
        /// Their velocities, or nothing.
        velocities: Vec<Point>,
        /// Who is linked.
        links: Vec<Link>,
    },
    /// Networks in the order of time.
    Networks {
        /// How many agents there are.
        order: usize,
        /// The links of each.
        networks: Vec<Vec<Link>>,
        /// Whether they are arcs.
        directed: bool,
    },
    /// Phases in parts of a turn.
    Phases {
        /// One for each agent.
        turns: Vec<Number>,
    },
    /// Phases as the points of the unit circle where they are.
    Directions {
        /// One for each agent.
        points: Vec<Point>,
    },
    /// The numbers that variables have.
    Variables {
        /// Names with their numbers.
        values: Vec<(String, Number)>,
    },
    /// What a quantity is, and what it is said to be.
    Compared {
        /// The quantity.
        subject: String,
        /// What it is.
        found: Number,
        /// Who says otherwise.
        says: String,
        /// What it is said to be.
        claimed: Number,
    },
    /// The squared amplitude of a follower per car of the platoon that looks ahead, over the squared frequency.
    Gain {
        /// Gain of positions.
        f: Number,
        /// Gain of velocities.
        g: Number,
        /// Squared frequencies with the values there.
        marks: Vec<Point>,
    },
    /// A potential of the squared distance `s`.
    Potential {
        /// Exponents and coefficients of `V'(s)`.
        slope: Vec<(i32, Number)>,
        /// A squared distance and the value there.
        value: Point,
        /// A place and a slope that is named.
        tangent: Option<Point>,
        /// The distance from which on it is constant.
        radius: Option<Number>,
    },
}

impl Witness {
    /// Networks of so many agents, one after the other.
    pub fn networks(order: usize, networks: Vec<Vec<Link>>) -> Self {
        Witness::Networks { order, networks, directed: false }
    }

    /// A quantity that is not what it is said to be.
    pub fn compared(subject: &str, found: &Rational, says: &str, claimed: &Rational) -> Self {
        let (subject, says) = (subject.to_string(), says.to_string());
        Witness::Compared { subject, found: found.into(), says, claimed: claimed.into() }
    }

    /// Agents in places, with velocities or without.
    pub fn agents(places: &[[Rational; 2]], velocities: &[[Rational; 2]], links: &[Link]) -> Self {
        let points = |list: &[[Rational; 2]]| list.iter().map(|row| row.each_ref().map(Number::from)).collect();
        Witness::Agents { places: points(places), velocities: points(velocities), links: links.to_vec() }
    }
}

/// Where a statement fails, so that anyone can check.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Counterexample {
    /// The sentence.
    pub text: String,
    /// What is in it.
    pub witnesses: Vec<Witness>,
}

impl Counterexample {
    /// A sentence with what is in it.
    pub fn new(text: impl Into<String>, witnesses: impl IntoIterator<Item = Witness>) -> Self {
        Counterexample { text: text.into(), witnesses: witnesses.into_iter().collect() }
    }
}

impl From<String> for Counterexample {
    fn from(text: String) -> Self {
        Counterexample { text, witnesses: Vec::new() }
    }
}

impl From<&str> for Counterexample {
    fn from(text: &str) -> Self {
        text.to_string().into()
    }
}

impl Deref for Counterexample {
    type Target = str;

    fn deref(&self) -> &str {
        &self.text
    }
}

impl fmt::Display for Counterexample {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}
