//! The scenario of a question: a flock in JSON or a motion in TOML, with the bound numbers put in.

use crate::bindings::{Bindings, Value};
use crate::subject::motion::Start as List;
use arithmetic::{Rational, rational};
use models::averaging::Start;
use models::averaging::read::{Model, read_flock};
use scenario::{ExactMotion, is_drawn, with_numbers};

/// A scenario as its file has it.
#[derive(Debug, Clone)]
pub(crate) struct ScenarioFile {
    pub name: String,
    text: String,
    pub is_flock: bool,
    is_drawn: bool,
}

/// Numbers of the start that are intervals.
pub(crate) type Wide = Vec<(List, usize, usize, Rational, Rational)>;

/// Whether a name of `[for]` is a place in the scenario.
pub(crate) fn is_place(name: &str) -> bool {
    name.contains(['.', '['])
}

impl ScenarioFile {
    /// Reads it once as it is, so that its own errors come first.
    pub fn read(name: &str, text: &str) -> Result<Self, String> {
        let is_flock = text.trim_start().starts_with('{');
        let mut file = ScenarioFile { name: name.to_string(), text: text.to_string(), is_flock, is_drawn: false };
        if is_flock {
            file.flock(&Bindings::default())?;
        } else {
            file.motion(&Bindings::default())?;
            file.is_drawn = is_drawn(text).map_err(|error| file.problem(&error))?;
        }
        Ok(file)
    }

    fn problem(&self, error: &dyn std::fmt::Display) -> String {
        format!("{}: {error}", self.name)
    }

    /// A flock as JSON, in which no key may stand twice.
    fn json(&self) -> Result<serde_json::Value, String> {
        algebra::json::parse(&self.text).map_err(|error| self.problem(&format!("not valid JSON: {error}")))
    }

    /// The text as one line, for the canonical form of a question.
    pub fn digest(&self) -> String {
        format!("{:?}", self.text)
    }

    /// Whether a bound `seed` draws its start.
    pub fn is_drawn(&self) -> bool {
        self.is_drawn
    }

    /// Whether a place is there.
    pub fn check_place(&self, name: &str) -> Result<(), String> {
        let numbers = [(name.to_string(), rational(1, 1))];
        if self.is_flock {
            let mut value = self.json()?;
            return match json_place(&mut value, name) {
                Some(_) => Ok(()),
                None => Err(format!("{}: there is no number at `{name}`", self.name)),
            };
        }
        with_numbers(&self.text, &numbers).map(|_| ()).map_err(|error| self.problem(&error))
    }

    /// The flock with the numbers that are bound.
    pub fn flock(&self, bindings: &Bindings) -> Result<Start, String> {
        let mut value = self.json()?;
        for (name, bound) in bindings.iter().filter(|(name, _)| is_place(name)) {
            let Value::Number(q) = bound else {
                return Err(format!("`{name}`: the numbers of an averaging flock are single ones, not intervals"));
            };
            if let Some(place) = json_place(&mut value, name) {
                *place = serde_json::Value::from(q.to_string());
            }
        }
        match read_flock(&value.to_string()).map_err(|error| self.problem(&error))?.model {
            Model::D { start, control: None } => Ok(start),
            _ => Err(format!("{}: questions are about flocks of model D without `control`", self.name)),
        }
    }

    /// The scenario of a run until a time, with the numbers that are bound.
    pub fn run_text(&self, bindings: &Bindings, until: &Rational) -> Result<String, String> {
        if self.is_flock {
            return Err("an averaging flock is exact".to_string());
        }
        let mut numbers = self.numbers(bindings)?.0;
        numbers.push(("run.until".to_string(), until.clone()));
        with_numbers(&self.text, &numbers).map_err(|error| self.problem(&error))
    }

    /// The motion with the numbers that are bound, and those that are intervals.
    pub fn motion(&self, bindings: &Bindings) -> Result<(ExactMotion, Wide), String> {
        let (numbers, wide) = self.numbers(bindings)?;
        let text = with_numbers(&self.text, &numbers).map_err(|error| self.problem(&error))?;
        let motion = ExactMotion::read(&text).map_err(|error| self.problem(&error))?;
        Ok((motion, wide))
    }

    /// Places with their numbers, and the intervals among them.
    fn numbers(&self, bindings: &Bindings) -> Result<(Vec<(String, Rational)>, Wide), String> {
        let (mut numbers, mut wide) = (Vec::new(), Vec::new());
        for (name, bound) in bindings.iter() {
            match bound {
                Value::Number(q) if is_place(name) => numbers.push((name.to_string(), q.clone())),
                Value::Number(q) if name == "seed" && self.is_drawn => {
                    numbers.push(("state.random.seed".to_string(), q.clone()));
                }
                Value::Integers(..) if name == "seed" && self.is_drawn => {
                    return Err("`seed` takes single integers, as in seed = \"1..1000\"".to_string());
                }
                value if is_place(name) => {
                    let Some((lo, hi)) = value.ends() else { continue };
                    let (list, agent, coordinate) = start_place(name).ok_or_else(|| {
                        format!("`{name}`: only positions, velocities and phases of [state] may range over an interval")
                    })?;
                    numbers.push((name.to_string(), (&lo + &hi) * rational(1, 2)));
                    wide.push((list, agent, coordinate, lo, hi));
                }
                _ => {}
            }
        }
        Ok((numbers, wide))
    }
}

/// `state.velocities[2][1]` as list, agent and coordinate from 0.
fn start_place(name: &str) -> Option<(List, usize, usize)> {
    let (list, rest) = name.strip_prefix("state.")?.split_once('[')?;
    let list = match list {
        "positions" => List::Positions,
        "velocities" => List::Velocities,
        "phases" => List::Phases,
        own => List::Own(own.to_string()),
    };
    let mut indices = rest.strip_suffix(']')?.split("][").map(|index| index.parse::<usize>().ok()?.checked_sub(1));
    let agent = indices.next()??;
    let coordinate = indices.next().unwrap_or(Some(0))?;
    Some((list, agent, coordinate))
}

/// The number at `velocities[2][1]` of a JSON document, indices from 1.
fn json_place<'v>(value: &'v mut serde_json::Value, name: &str) -> Option<&'v mut serde_json::Value> {
    let (key, rest) = name.split_once('[').map_or((name, ""), |(key, _)| (key, &name[key.len()..]));
    let mut place = value.get_mut(key)?;
    for index in rest.split('[').skip(1) {
        let index: usize = index.strip_suffix(']')?.parse().ok()?;
        place = place.get_mut(index.checked_sub(1)?)?;
    }
    (place.is_string() || place.is_number()).then_some(place)
}
