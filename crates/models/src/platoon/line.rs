//! A platoon on a line as users say it: gains, and weights of the car ahead and of the car behind, one number for all followers or one for each.
//!
//! In the field's words: a *bidirectional* platoon is *symmetric* where both weights are equal, *asymmetric* where they are not, and *heterogeneous*
//! where cars differ. Weights are shares: those of a car are scaled to a sum of one, so that the last car, which has nobody behind, has the weight one
//! ahead (system (2) of Veerman and others has the weights 1/2 and 1/2). In place of `f`, the gains of the two links, `f_ahead` and `f_behind`,
//! may be given, as for the front and the rear gain of Hao and Barooah and others; then the last car has that of its one link. Likewise `g`.

use super::cars::Platoon;
use super::communication_graph::{CommunicationError, CommunicationGraph, check_count};
use super::law::{Gains, SIGNS};
use arithmetic::{NumberError, Rational, Sign, Signed, parse_rational, rational, shown};
use std::fmt;

/// Numbers of a platoon as they are written everywhere, one for all followers or one for each: `-1,-2,-1`, `[-1, -2, -1]` and `each:-1,-2,-1` are
/// the same list.
///
/// # Errors
/// [`NumberError`] with the part at fault.
pub fn read_numbers(text: &str) -> Result<Vec<Rational>, NumberError> {
    let text = text.trim();
    let text = text.strip_prefix("each:").map_or(text, str::trim);
    let inner = text.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')).unwrap_or(text);
    inner.split(',').map(|part| parse_rational(part.trim())).collect()
}

/// What is given of a platoon on a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Parameter {
    /// Gains of the positions, 1/s², negative.
    F,
    /// Gains of the velocities, 1/s, negative.
    G,
    /// Weights of the car ahead, for positions and velocities.
    Ahead,
    /// Weights of the car behind, for positions and velocities.
    Behind,
    /// The weight of the position of the car ahead; without [`Parameter::F`] the gain of its link.
    FAhead,
    /// Likewise of the car behind.
    FBehind,
    /// The weight of the velocity of the car ahead; without [`Parameter::G`] the gain of its link.
    GAhead,
    /// Likewise of the car behind.
    GBehind,
}

use Parameter::{Ahead, Behind, F, FAhead, FBehind, G, GAhead, GBehind};

impl Parameter {
    /// All of them with the names that they have in files and in Python.
    pub const NAMES: [(&str, Parameter); 8] = [
        ("f", F),
        ("g", G),
        ("ahead", Ahead),
        ("behind", Behind),
        ("f_ahead", FAhead),
        ("f_behind", FBehind),
        ("g_ahead", GAhead),
        ("g_behind", GBehind),
    ];

    /// Its name.
    pub fn name(self) -> &'static str {
        Parameter::NAMES[self as usize].0
    }

    /// The parameter of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        Parameter::NAMES.iter().find(|(known, _)| *known == name).map(|(_, parameter)| *parameter)
    }

    /// Whether it is about the car ahead or behind.
    pub fn is_of_a_side(self) -> bool {
        !matches!(self, F | G)
    }
}

/// Why the numbers of a platoon on a line are refused.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum LineError {
    /// A number that is needed.
    Missing {
        /// What is missing.
        parameter: Parameter,
        /// What it is for.
        why: &'static str,
    },
    /// Two that say the same.
    Both {
        /// The one.
        one: Parameter,
        /// The other.
        other: Parameter,
    },
    /// A list of another length.
    Count {
        /// The list.
        parameter: Parameter,
        /// Its length.
        given: usize,
        /// The followers.
        followers: usize,
    },
    /// A gain that is not negative.
    Sign {
        /// The gain.
        parameter: Parameter,
        /// Its value.
        value: Rational,
    },
    /// A gain of a link that is positive.
    Link {
        /// The gain.
        parameter: Parameter,
        /// That of which it would be a weight.
        whole: Parameter,
        /// Its value.
        value: Rational,
    },
    /// A weight below zero, or above one where the other weight is the rest to one.
    Weight {
        /// The weight.
        parameter: Parameter,
        /// Its value.
        value: Rational,
        /// What is allowed.
        range: &'static str,
    },
    /// A car that would track nobody.
    Nobody {
        /// The car, from 1.
        car: usize,
        /// Whether it is the last one.
        is_last: bool,
        /// Positions or velocities.
        what: &'static str,
    },
    /// A weight where there is no line of cars.
    OnGraph {
        /// The weight.
        parameter: Parameter,
    },
    /// Of the graph.
    Graph(CommunicationError),
}

impl LineError {
    /// What is at fault, where it is one parameter.
    pub fn parameter(&self) -> Option<Parameter> {
        match self {
            LineError::Missing { parameter, .. }
            | LineError::Both { other: parameter, .. }
            | LineError::Count { parameter, .. }
            | LineError::Sign { parameter, .. }
            | LineError::Link { parameter, .. }
            | LineError::Weight { parameter, .. }
            | LineError::OnGraph { parameter } => Some(*parameter),
            LineError::Nobody { .. } | LineError::Graph(_) => None,
        }
    }

    /// The message, with parameters called as the reader knows them.
    pub fn told(&self, name: impl Fn(Parameter) -> String) -> String {
        match self {
            LineError::Missing { parameter, why } => format!("{} is needed: {why}", name(*parameter)),
            LineError::Both { one, other } => format!("{} and {} cannot both be given", name(*one), name(*other)),
            LineError::Count { parameter, given, followers } => {
                let list = name(*parameter);
                format!("{list} has {given} numbers for {followers} followers: one, or one for each follower")
            }
            LineError::Sign { parameter, value } => {
                format!("{} must be negative, but it is {}: {SIGNS}", name(*parameter), shown(&value.to_string()))
            }
            LineError::Link { parameter, whole, value } => format!(
                "{} is {}, but without {} it is the gain of a link, which is negative or zero: {SIGNS}",
                name(*parameter),
                shown(&value.to_string()),
                name(*whole)
            ),
            LineError::Weight { parameter, value, range } => {
                format!("{} is {}, but a weight is {range}", name(*parameter), shown(&value.to_string()))
            }
            LineError::Nobody { car, is_last, what } => {
                let behind = if *is_last { ", and nobody behind" } else { " and behind" };
                format!("car {car} has the weight zero ahead{behind}: it would not keep track of any {what}")
            }
            LineError::OnGraph { parameter } => {
                let name = name(*parameter);
                format!(
                    "{name} is for cars on a line that track both sides; what else is tracked has weights of its own"
                )
            }
            LineError::Graph(error) => error.to_string(),
        }
    }
}

impl fmt::Display for LineError {
    /// Parameters are called as in files.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.told(|parameter| parameter.name().to_string()))
    }
}

impl std::error::Error for LineError {}

impl From<CommunicationError> for LineError {
    fn from(error: CommunicationError) -> Self {
        LineError::Graph(error)
    }
}

/// The numbers of a platoon on a line: for each parameter nothing, one number, or one for each follower.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Line {
    lists: [Option<Vec<Rational>>; 8],
}

impl Line {
    /// The same with another parameter; an empty list is none.
    #[must_use]
    pub fn with(mut self, parameter: Parameter, numbers: Vec<Rational>) -> Self {
        self.lists[parameter as usize] = Some(numbers).filter(|list| !list.is_empty());
        self
    }

    /// What is given of a parameter.
    pub fn get(&self, parameter: Parameter) -> Option<&[Rational]> {
        self.lists[parameter as usize].as_deref()
    }

    /// Whether something is said of the car ahead or the car behind.
    pub fn is_asymmetric(&self) -> bool {
        Parameter::NAMES.iter().any(|(_, parameter)| parameter.is_of_a_side() && self.get(*parameter).is_some())
    }

    /// The number of a follower, from 1.
    fn of(&self, parameter: Parameter, car: usize) -> Option<&Rational> {
        let list = self.get(parameter)?;
        list.get(if list.len() == 1 { 0 } else { car - 1 })
    }

    /// The same gains for cars that track others as a graph says, which has weights of its own.
    ///
    /// # Errors
    /// [`LineError`].
    pub fn on(&self, graph: CommunicationGraph) -> Result<Platoon<Rational>, LineError> {
        let side = Parameter::NAMES.into_iter().find(|(_, side)| side.is_of_a_side() && self.get(*side).is_some());
        if let Some((_, parameter)) = side {
            return Err(LineError::OnGraph { parameter });
        }
        let [f, g] = self.gains(graph.followers())?;
        let gains = f.into_iter().zip(g).map(|(f, g)| Gains { f, g }).collect();
        Ok(Platoon::new(graph, gains)?)
    }

    /// Both gains of each follower.
    fn gains(&self, followers: usize) -> Result<[Vec<Rational>; 2], LineError> {
        self.check_counts(followers)?;
        let list = |parameter: Parameter, why: &'static str| {
            let gain = |car: usize| match self.of(parameter, car) {
                None => Err(LineError::Missing { parameter, why }),
                Some(value) if value.sign() == Some(Sign::Negative) => Ok(value.clone()),
                Some(value) => Err(LineError::Sign { parameter, value: value.clone() }),
            };
            (1..=followers).map(gain).collect::<Result<Vec<_>, _>>()
        };
        Ok([list(F, "the gain of the positions")?, list(G, "the gain of the velocities")?])
    }

    fn check_counts(&self, followers: usize) -> Result<(), LineError> {
        for (_, parameter) in Parameter::NAMES {
            if let Some(given) = self.get(parameter).map(<[_]>::len).filter(|n| ![1, followers].contains(n)) {
                return Err(LineError::Count { parameter, given, followers });
            }
        }
        Ok(())
    }

    /// The platoon of so many followers; whose weights are not given track the car ahead and the car behind alike, as system (2) does.
    ///
    /// # Errors
    /// [`LineError`].
    pub fn platoon(&self, followers: usize) -> Result<Platoon<Rational>, LineError> {
        check_count(followers)?;
        self.check_counts(followers)?;
        for (one, others) in [(Ahead, [FAhead, GAhead]), (Behind, [FBehind, GBehind])] {
            let both = others.into_iter().find(|other| self.get(one).is_some() && self.get(*other).is_some());
            if let Some(other) = both {
                return Err(LineError::Both { one, other });
            }
        }
        let (f, positions) = self.tracked(followers, F, [FAhead, FBehind], "positions")?;
        let (g, velocities) = self.tracked(followers, G, [GAhead, GBehind], "velocities")?;
        let gains = f.into_iter().zip(g).map(|(f, g)| Gains { f, g }).collect();
        Ok(Platoon::new(positions, gains)?.with_velocities(velocities)?)
    }

    /// Gains and weights of positions or of velocities.
    fn tracked(
        &self,
        followers: usize,
        whole: Parameter,
        sides: [Parameter; 2],
        what: &'static str,
    ) -> Result<(Vec<Rational>, CommunicationGraph), LineError> {
        let given = [Ahead, Behind].map(|both| self.get(both).map(|_| both));
        let named = [0, 1].map(|k| if self.get(sides[k]).is_some() { Some(sides[k]) } else { given[k] });
        let (mut gains, mut rows) = (Vec::with_capacity(followers), Vec::with_capacity(followers));
        for car in 1..=followers {
            let (gain, [ahead, behind]) = match self.of(whole, car) {
                Some(gain) if gain.sign() != Some(Sign::Negative) => {
                    return Err(LineError::Sign { parameter: whole, value: gain.clone() });
                }
                Some(gain) => (Some(gain.clone()), self.weights(car, named)?),
                None => (None, self.links(car, whole, sides)?),
            };
            let is_last = car == followers;
            let behind = if is_last { rational(0, 1) } else { behind };
            let sum = &ahead + &behind;
            if !sum.is_certainly_positive() {
                return Err(LineError::Nobody { car, is_last, what });
            }
            let share = |weight: Rational| (weight.sign() != Some(Sign::Zero)).then(|| weight / &sum);
            rows.push(
                [(car - 1, share(ahead)), (car + 1, share(behind))]
                    .into_iter()
                    .filter_map(|(agent, share)| Some((agent, share?)))
                    .collect(),
            );
            gains.push(gain.unwrap_or_else(|| -sum.clone()));
        }
        Ok((gains, CommunicationGraph::new(rows)?))
    }

    /// The weights of a car ahead and behind, not yet scaled.
    fn weights(&self, car: usize, named: [Option<Parameter>; 2]) -> Result<[Rational; 2], LineError> {
        let one = || rational(1, 1);
        let rest = |parameter: Parameter, value: &Rational| {
            let weight = one() - value;
            let range = "between 0 and 1 where the other one is the rest to one";
            let refused = LineError::Weight { parameter, value: value.clone(), range };
            if weight.sign() == Some(Sign::Negative) { Err(refused) } else { Ok(weight) }
        };
        let own = |parameter: Option<Parameter>| -> Result<Option<(Parameter, Rational)>, LineError> {
            let Some(parameter) = parameter else { return Ok(None) };
            let Some(value) = self.of(parameter, car) else { return Ok(None) };
            match value.sign() {
                Some(Sign::Negative) => {
                    Err(LineError::Weight { parameter, value: value.clone(), range: "not negative" })
                }
                _ => Ok(Some((parameter, value.clone()))),
            }
        };
        match (own(named[0])?, own(named[1])?) {
            (Some((_, ahead)), Some((_, behind))) => Ok([ahead, behind]),
            (Some((name, ahead)), None) => rest(name, &ahead).map(|behind| [ahead, behind]),
            (None, Some((name, behind))) => rest(name, &behind).map(|ahead| [ahead, behind]),
            (None, None) => Ok([one(), one()]),
        }
    }

    /// The sizes of the gains of the two links of a car.
    fn links(&self, car: usize, whole: Parameter, sides: [Parameter; 2]) -> Result<[Rational; 2], LineError> {
        let why = if whole == F { "the gain of the positions" } else { "the gain of the velocities" };
        let mut sizes = [rational(0, 1), rational(0, 1)];
        if sides.iter().all(|side| self.get(*side).is_none()) {
            return Err(LineError::Missing { parameter: whole, why });
        }
        for (size, parameter) in sizes.iter_mut().zip(sides) {
            let value = self.of(parameter, car);
            let value = value
                .ok_or(LineError::Missing { parameter, why: "the gain of the link on its other side is given" })?;
            if value.sign() == Some(Sign::Positive) {
                return Err(LineError::Link { parameter, whole, value: value.clone() });
            }
            *size = -value.clone();
        }
        Ok(sizes)
    }
}
