//! One case of a question: bound names, and the subjects that they make.

use crate::bindings::{Bindings, Value};
use crate::error::Problem;
use crate::failure::Failure;
use crate::given::GivenValue;
use crate::names::{GIVEN, OWN, Quantity, Subject, quantity_of, unknown_quantity};
use crate::question::Question;
use crate::subject::flock::FlockSubject;
use crate::subject::graph::GraphSubject;
use crate::subject::matrices;
use crate::subject::motion::MotionSubject;
use crate::subject::platoon::PlatoonSubject;
use crate::subject::run::FloatRun;
use crate::subject::steps::StepsSubject;
use crate::timeline::{Measured, Timeline};
use arithmetic::Progress;
use arithmetic::RealNumber as Number;
use std::cell::{Cell, OnceCell, RefCell};
use std::collections::BTreeMap;
use std::rc::Rc;

/// A case with what has been computed of it.
pub(crate) struct Case<'q> {
    pub question: &'q Question,
    pub bindings: Bindings,
    /// Whether something was asked for that no box, however small, has.
    pub points_only: Cell<bool>,
    /// The vertices that names inside sums over a graph stand for, the innermost last.
    pub places: RefCell<Vec<(String, usize)>>,
    /// Values of functions of graphs that the program was given, by the name of the graph and of the function.
    values: RefCell<BTreeMap<(String, String), GivenValue>>,
    progress: &'q dyn Progress,
    graphs: RefCell<BTreeMap<String, Rc<GraphSubject<'q>>>>,
    moving: OnceCell<Result<Moving<'q>, Failure>>,
}

/// What moves in a case.
enum Moving<'q> {
    Flock(Box<FlockSubject<'q>>),
    Motion(Box<MotionSubject<'q>>),
    Steps(Box<StepsSubject<'q>>),
    Floats(FloatRun),
}

impl<'q> Case<'q> {
    pub fn new(question: &'q Question, bindings: Bindings, progress: &'q dyn Progress) -> Self {
        let points_only = Cell::new(false);
        Case {
            question,
            bindings,
            points_only,
            places: RefCell::default(),
            values: RefCell::default(),
            progress,
            graphs: RefCell::default(),
            moving: OnceCell::new(),
        }
    }

    /// A case whose motion is a run in floating point.
    pub fn of_floats(question: &'q Question, bindings: Bindings, run: FloatRun, progress: &'q dyn Progress) -> Self {
        let case = Case::new(question, bindings, progress);
        Case { moving: OnceCell::from(Ok(Moving::Floats(run))), ..case }
    }

    /// What is told of long work, and what stops it.
    pub fn progress(&self) -> &dyn Progress {
        self.progress
    }

    /// The quantity of that name, of the subjects of the question.
    pub fn quantity(&self, owner: Option<&str>, name: &str) -> Result<&'static Quantity, Problem> {
        let subjects = self.question.subjects();
        let full = owner.map_or(name.to_string(), |owner| format!("{owner}.{name}"));
        if self.question.is_own(&full) {
            return Ok(&OWN);
        }
        if self.question.given(name).is_some() {
            return Ok(&GIVEN);
        }
        quantity_of(name, subjects).ok_or_else(|| unknown_quantity(owner, name, &self.question.known_names()))
    }

    /// A quantity that does not move, of its subject.
    pub fn measure(
        &self,
        quantity: &'static Quantity,
        owner: Option<&str>,
        arguments: &[Number],
        precision: u32,
    ) -> Result<Measured, Failure> {
        match quantity.subject {
            Subject::Graph => {
                let graph = self.graph(owner).ok_or_else(|| missing(quantity))?;
                graph.measure(quantity.name, arguments, precision)
            }
            Subject::Platoon => {
                let platoon = PlatoonSubject::new(&self.bindings, self.question.communication(), self.progress)?;
                if platoon.is_of_points_only(quantity.name) {
                    self.points_only.set(true);
                }
                platoon.measure(quantity.name, arguments, precision)
            }
            Subject::Matrices => {
                let found = self.bindings.iter().find_map(|(name, value)| match value {
                    Value::Matrices(list) if owner.is_none_or(|owner| owner == name) => Some(list),
                    _ => None,
                });
                let list = found.ok_or_else(|| missing(quantity))?;
                matrices::measure(quantity.name, list, precision)
            }
            Subject::Flock | Subject::Motion => match self.moving()? {
                Moving::Flock(flock) if !quantity.moves => flock.measure(quantity.name),
                _ => Err(Failure::open("a moving quantity has no value without a time", None)),
            },
        }
    }

    /// The value of a function of a graph that the program was given, asked for once.
    pub fn given(&self, name: &str, owner: Option<&str>) -> Result<Measured, Failure> {
        let refused = |why: String| Failure::Refused(0, Problem::Other(why));
        let given = self.question.given(name).ok_or_else(|| missing(&GIVEN))?;
        let graph = self.graph(owner).ok_or_else(|| missing(&GIVEN))?;
        let key = (owner.unwrap_or_default().to_string(), name.to_string());
        let value = self.values.borrow().get(&key).cloned();
        let value = value.unwrap_or_else(|| given.value(graph.graph()));
        self.values.borrow_mut().insert(key, value.clone());
        match value {
            GivenValue::Exact(q) | GivenValue::Float(q) => Ok(Measured::Number(Number::Exact(q))),
            GivenValue::Missing(why) => Err(refused(format!("`{name}` has no value: {why}"))),
        }
    }

    /// The graph of that name, or the first one.
    pub fn graph(&self, owner: Option<&str>) -> Option<Rc<GraphSubject<'q>>> {
        let mut graphs = self.bindings.iter().filter_map(|(name, value)| match value {
            Value::Graph(graph) if owner.is_none_or(|owner| owner == name) => Some((name, graph)),
            _ => None,
        });
        let (name, graph) = graphs.next()?;
        if let Some(known) = self.graphs.borrow().get(name) {
            return Some(known.clone());
        }
        let subject = Rc::new(GraphSubject::new(graph.clone(), self.question.kind(), self.progress));
        self.graphs.borrow_mut().insert(name.to_string(), subject.clone());
        Some(subject)
    }

    fn moving(&self) -> Result<&Moving<'q>, Failure> {
        let made = self.moving.get_or_init(|| {
            let scenario = self
                .question
                .scenario()
                .ok_or_else(|| Failure::Refused(0, Problem::Other("the question has no `scenario`".to_string())))?;
            let refused = |message: String| Failure::Refused(0, Problem::Other(message));
            if scenario.is_flock() {
                let start = scenario.flock(&self.bindings).map_err(refused)?;
                return Ok(Moving::Flock(Box::new(FlockSubject::new(start, self.progress))));
            }
            if let Some(flock) = scenario.steps(&self.bindings).map_err(refused)? {
                let flock = flock.map_err(|why| Failure::open(why, None))?;
                return Ok(Moving::Steps(Box::new(StepsSubject::new(flock, self.progress))));
            }
            let (motion, wide) = scenario.motion(&self.bindings).map_err(refused)?;
            Ok(Moving::Motion(Box::new(MotionSubject::new(motion, wide, self.progress))))
        });
        made.as_ref().map_err(Clone::clone)
    }

    /// What moves, with its times.
    pub fn timeline(&self) -> Result<&dyn Timeline, Failure> {
        Ok(match self.moving()? {
            Moving::Flock(flock) => flock.as_ref(),
            Moving::Motion(motion) => motion.as_ref(),
            Moving::Steps(flock) => flock.as_ref(),
            Moving::Floats(run) => run,
        })
    }
}

fn missing(quantity: &Quantity) -> Failure {
    let problem = Problem::NoSubject {
        name: quantity.name.to_string(),
        subject: quantity.subject.words(),
        missing: quantity.subject.needs().to_string(),
    };
    Failure::Refused(0, problem)
}
