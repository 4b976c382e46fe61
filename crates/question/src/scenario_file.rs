//! The scenario of a question: a flock in JSON or a motion in TOML, with the bound numbers put in.

use crate::bindings::{Bindings, Value};
use crate::subject::motion::Start as List;
use arithmetic::{Rational, rational};
use expressions::Law;
use models::averaging::Start;
use models::averaging::read::{Model, flock_of};
use motion::sets::Range;
use scenario::{ConfigError, ExactMotion, OwnFlock, Path, Scenario, Source, Step, WithLaw, own_law, with_law};
use serde_json::Value as Json;
use std::sync::Arc;

/// Gives the text of a file that a question names, or why there is none.
pub type Files<'a> = &'a dyn Fn(&str) -> Result<String, String>;

/// A scenario as its file has it.
#[derive(Debug, Clone)]
pub(crate) struct ScenarioFile {
    pub name: String,
    whole: WithLaw,
    file: File,
    /// The law of one's own that it has.
    own: Option<Arc<Law>>,
}

#[derive(Debug, Clone)]
enum File {
    Flock(Json),
    Motion { source: Box<Source>, is_drawn: bool },
}

/// Numbers of the start that are intervals.
pub(crate) type Wide = Vec<(List, usize, usize, Rational, Rational)>;

/// Whether a name of `[for]` is a place in the scenario.
pub(crate) fn is_place(name: &str) -> bool {
    name.contains(['.', '['])
}

impl ScenarioFile {
    /// Reads it once as it is, so that its own errors come first; the file of its law lies beside it.
    pub fn read(name: &str, text: &str, files: Files) -> Result<Self, String> {
        let problem = |error: &dyn std::fmt::Display| format!("{name}: {error}");
        let (whole, file);
        if text.trim_start().starts_with('{') {
            // No key may stand twice.
            let json = algebra::json::parse(text);
            file = File::Flock(json.map_err(|error| problem(&format!("not valid JSON: {error}")))?);
            whole = WithLaw::alone(text);
        } else {
            let folder = name.rsplit_once('/').map_or("", |(folder, _)| folder);
            let beside =
                |law: &str| files(&if folder.is_empty() { law.to_string() } else { format!("{folder}/{law}") });
            whole = with_law(text, &beside).map_err(|error| problem(&error))?;
            let told = |error: ConfigError| problem(&whole.told(&error));
            let source = Box::new(Source::parse(whole.text()).map_err(told)?);
            let is_drawn = source.is_drawn().map_err(told)?;
            file = File::Motion { source, is_drawn };
        }
        let own = match &file {
            File::Motion { source, .. } => own_law(source),
            File::Flock(_) => None,
        };
        let file = ScenarioFile { name: name.to_string(), whole, file, own };
        match file.is_flock() {
            true => file.flock(&Bindings::default()).map(drop)?,
            false => file.motion(&Bindings::default()).map(drop)?,
        }
        Ok(file)
    }

    fn problem(&self, error: &dyn std::fmt::Display) -> String {
        format!("{}: {error}", self.name)
    }

    fn refused(&self, error: &ConfigError) -> String {
        self.problem(&self.whole.told(error))
    }

    /// The text as one line, for the canonical form of a question.
    pub fn digest(&self) -> String {
        format!("{:?}", self.whole.text())
    }

    /// Whether it is the name of a number of its law of one's own.
    pub fn is_own(&self, name: &str) -> bool {
        self.own.as_ref().is_some_and(|law| law.number(name).is_some())
    }

    /// Whether it is the name of an angle of its law of one's own.
    pub fn is_angle(&self, name: &str) -> bool {
        self.own.as_ref().is_some_and(|law| law.is_angle(name))
    }

    /// Whether it is an averaging flock.
    pub fn is_flock(&self) -> bool {
        matches!(self.file, File::Flock(_))
    }

    /// Whether a bound `seed` draws its start.
    pub fn is_drawn(&self) -> bool {
        matches!(self.file, File::Motion { is_drawn: true, .. })
    }

    /// Whether it is a law of one's own in discrete time, whose future may be decided.
    pub fn is_discrete(&self) -> bool {
        matches!(&self.file, File::Motion { source, .. } if OwnFlock::is_of(source))
    }

    fn no_place(&self, name: &str) -> String {
        self.problem(&format!("there is no number at `{name}`"))
    }

    fn place(&self, name: &str) -> Result<Path, String> {
        Path::parse(name).ok_or_else(|| self.no_place(name))
    }

    /// Whether a place is there.
    pub fn check_place(&self, name: &str) -> Result<(), String> {
        let path = self.place(name)?;
        let is_there = match &self.file {
            File::Flock(json) => number_at(&mut json.clone(), &path).is_some(),
            File::Motion { source, .. } => source.with([(&path, rational(1, 1))]).is_ok(),
        };
        if is_there { Ok(()) } else { Err(self.no_place(name)) }
    }

    /// Whether the number at a place may range over an interval; of averaging flocks that is told later.
    pub fn check_wide(&self, name: &str) -> Result<(), String> {
        let File::Motion { source, .. } = &self.file else { return Ok(()) };
        let (list, ..) = self.wide_place(source, name)?;
        if self.is_discrete() {
            return Ok(());
        }
        let (motion, _) = self.motion(&Bindings::default())?;
        match uncarried(&motion, &list) {
            true => Err(format!("`{name}` is a single number in this model; {MAY_BE_WIDE}")),
            false => Ok(()),
        }
    }

    /// What of the start or the law is at a place that ranges over an interval.
    fn wide_place(&self, source: &Source, name: &str) -> Result<(List, usize, usize), String> {
        let path = self.place(name)?;
        let is_law = matches!(path.steps(), [Step::Key(law), ..] if law == "law");
        let place = if is_law { self.constant(source, &path) } else { start_place(&path) };
        place.ok_or_else(|| unmoved(name))
    }

    /// The flock with the numbers that are bound.
    pub fn flock(&self, bindings: &Bindings) -> Result<Start, String> {
        let File::Flock(json) = &self.file else { return Err(self.problem(&"it is a motion in TOML")) };
        let mut json = json.clone();
        for (name, bound) in bindings.iter().filter(|(name, _)| is_place(name)) {
            let Value::Number(q) = bound else {
                return Err(format!("`{name}`: the numbers of an averaging flock are single ones, not intervals"));
            };
            if let Some(place) = Path::parse(name).and_then(|path| number_at(&mut json, &path)) {
                *place = Json::from(q.to_string());
            }
        }
        match flock_of(json).map_err(|error| self.problem(&error))?.model {
            Model::D { start, control: None } => Ok(start),
            _ => Err(self.problem(&"questions are about flocks of model D without `control`")),
        }
    }

    /// The scenario until a time, with the numbers that are bound.
    pub fn source(&self, bindings: &Bindings, until: &Rational) -> Result<Source, String> {
        let until = (self.place("run.until")?, until.clone());
        Ok(self.bound(bindings, Some(until))?.0)
    }

    /// A run of it until a time.
    pub fn run(&self, bindings: &Bindings, until: &Rational) -> Result<Scenario, String> {
        Scenario::of(&self.source(bindings, until)?).map_err(|error| self.refused(&error))
    }

    /// The flock under a law of one's own in discrete time, where it is one, with the intervals of its start; or why it is not followed.
    pub fn steps(&self, bindings: &Bindings) -> Result<Option<Result<OwnFlock, String>>, String> {
        let (source, wide) = self.bound(bindings, None)?;
        let found = OwnFlock::of_open(&source, &open_parameters(&wide)).map_err(|error| self.refused(&error))?;
        let Some(Ok(mut flock)) = found else { return Ok(found.map(|flock| flock.map_err(str::to_string))) };
        for (list, agent, coordinate, lo, hi) in wide {
            if !flock.widen(list.part(), agent, coordinate, [lo, hi]) {
                return Err(self.problem(&format!("`{}` has no such number", list.part())));
            }
        }
        Ok(Some(Ok(flock)))
    }

    /// The motion with the numbers that are bound, and those that are intervals.
    pub fn motion(&self, bindings: &Bindings) -> Result<(ExactMotion, Wide), String> {
        let (source, wide) = self.bound(bindings, None)?;
        let motion = ExactMotion::of_open(&source, &open_parameters(&wide)).map_err(|error| self.refused(&error))?;
        // What a file may not say at an end of an interval is not asked either.
        if wide.iter().any(|(list, ..)| matches!(list, List::Constant { .. })) {
            for end in [|range: &Range| range.lo.clone(), |range: &Range| range.hi.clone()] {
                let (source, _) = self.bound_at(bindings, None, end)?;
                ExactMotion::of(&source).map_err(|error| self.refused(&error))?;
            }
        }
        Ok((motion, wide))
    }

    /// `law.f[2]` as the number of a law and its entry from 0; `law.parameters.K` of a law of one's own as `K`.
    fn constant(&self, source: &Source, path: &Path) -> Option<(List, usize, usize)> {
        let (keys, entry) = match path.steps().split_last()? {
            (Step::Index(entry), keys) => (keys, Some(*entry)),
            _ => (path.steps(), None),
        };
        let keys: Vec<&str> = keys
            .iter()
            .skip(1)
            .map(|step| if let Step::Key(key) = step { Some(key.as_str()) } else { None })
            .collect::<Option<_>>()?;
        let name = match (&self.own, &keys[..]) {
            (Some(_), ["parameters", name]) => (*name).to_string(),
            (Some(_), _) | (None, []) => return None,
            (None, keys) => keys.join("."),
        };
        // A list of one number is that of all cars.
        let second = Path::parse(&format!("law.{name}[2]"));
        let is_alone = second.is_none_or(|second| source.with([(&second, rational(1, 1))]).is_err());
        let listed = entry.is_some() && (self.own.is_some() || !is_alone);
        Some((List::Constant { name, listed }, entry.unwrap_or(0), 0))
    }

    /// The scenario with the numbers that are bound and one more, and the intervals among them, which have their middles in it.
    fn bound(&self, bindings: &Bindings, further: Option<(Path, Rational)>) -> Result<(Source, Wide), String> {
        self.bound_at(bindings, further, Range::centre)
    }

    /// The same with another number of each interval of the law in it.
    fn bound_at(
        &self,
        bindings: &Bindings,
        further: Option<(Path, Rational)>,
        of: impl Fn(&Range) -> Rational,
    ) -> Result<(Source, Wide), String> {
        let File::Motion { source, is_drawn } = &self.file else {
            return Err("an averaging flock is exact".to_string());
        };
        let (mut numbers, mut wide) = (Vec::new(), Vec::new());
        for (name, bound) in bindings.iter() {
            match bound {
                Value::Number(q) if is_place(name) => numbers.push((self.place(name)?, q.clone())),
                Value::Number(q) if name == "seed" && *is_drawn => {
                    numbers.push((self.place("state.random.seed")?, q.clone()));
                }
                Value::Integers(..) if name == "seed" && *is_drawn => {
                    return Err("`seed` takes single integers, as in seed = \"1..1000\"".to_string());
                }
                value if is_place(name) => {
                    let Some(range) = value.ends() else {
                        return Err(format!("`{name}` should be a number or an interval, not `{}`", value.text()));
                    };
                    let (list, agent, coordinate) = self.wide_place(source, name)?;
                    let is_constant = matches!(list, List::Constant { .. });
                    numbers.push((self.place(name)?, if is_constant { of(&range) } else { range.centre() }));
                    wide.push((list, agent, coordinate, range.lo, range.hi));
                }
                _ => {}
            }
        }
        numbers.extend(further);
        let numbers = numbers.iter().map(|(path, number)| (path, number.clone()));
        Ok((source.with(numbers).map_err(|error| self.problem(&error))?, wide))
    }
}

/// What may range over an interval.
const MAY_BE_WIDE: &str = "intervals are for numbers of [state], and of [law] for omega0, K0, K1, drift, beacon, f, g, spacing, leader.amplitude, leader.frequency and the parameters of laws of one's own";

/// Why the number in that place is a single one.
fn unmoved(name: &str) -> String {
    match name {
        "graph.radius" => "`graph.radius`: a radius is a single number, since who is linked is decided for one; list several, \"graph.radius\" = [\"1\", \"2\"]".to_string(),
        _ => format!("`{name}` is a single number; {MAY_BE_WIDE}"),
    }
}

/// The parameters of a law of one's own that range over intervals.
fn open_parameters(wide: &Wide) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for (list, ..) in wide {
        if let List::Constant { name, .. } = list
            && !names.contains(&name.as_str())
        {
            names.push(name);
        }
    }
    names
}

/// Whether it is a number of a law that the enclosure of this motion does not carry as an interval.
fn uncarried(motion: &ExactMotion, list: &List) -> bool {
    let List::Constant { name, .. } = list else { return false };
    let carried: &[&str] = match motion {
        ExactMotion::Phases { .. } => &["omega0", "K1"],
        ExactMotion::Particles { .. } => &["omega0", "K0", "K1", "drift", "beacon"],
        ExactMotion::Platoon { .. } => &["f", "g", "spacing", "leader.amplitude", "leader.frequency"],
        ExactMotion::Velocities { .. } => &[],
        // Those of laws of one's own were looked up, and of a motion that is not enclosed the reason says more.
        ExactMotion::Own(_) | ExactMotion::Other(_) => return false,
    };
    !carried.contains(&name.as_str())
}

/// `state.velocities[2][1]` as list, agent and coordinate from 0.
fn start_place(path: &Path) -> Option<(List, usize, usize)> {
    let (agent, coordinate, list) = match path.steps() {
        [Step::Key(state), Step::Key(list), Step::Index(agent)] if state == "state" => (*agent, 0, list),
        [Step::Key(state), Step::Key(list), Step::Index(agent), Step::Index(coordinate)] if state == "state" => {
            (*agent, *coordinate, list)
        }
        _ => return None,
    };
    let list = match list.as_str() {
        "positions" => List::Positions,
        "velocities" => List::Velocities,
        "phases" => List::Phases,
        own => List::Own(own.to_string()),
    };
    Some((list, agent, coordinate))
}

/// The number at a place of a JSON document.
fn number_at<'v>(value: &'v mut Json, path: &Path) -> Option<&'v mut Json> {
    let place = path.steps().iter().try_fold(value, |place, step| match step {
        Step::Key(name) => place.get_mut(name),
        Step::Index(index) => place.get_mut(*index),
    })?;
    (place.is_string() || place.is_number()).then_some(place)
}
