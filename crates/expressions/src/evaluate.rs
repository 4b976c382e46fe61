//! Programs over any scalar.

use super::program::{Gather, OWN, Of, Op, Program, Round, Step};
use super::syntax::Relation;
use arithmetic::{ArithmeticError, Number, Rational, Sign};
use std::sync::Arc;

/// Whom each agent hears.
pub trait Hearing: Sync {
    /// The number of agents.
    fn agents(&self) -> usize;

    /// Those whom an agent hears, from 0, in order; nothing where that is everyone else.
    fn heard(&self, agent: usize) -> Option<&[usize]>;
}

/// So many agents, of whom each hears all others.
#[derive(Debug, Clone, Copy)]
pub struct Everyone(pub usize);

impl Hearing for Everyone {
    fn agents(&self) -> usize {
        self.0
    }

    fn heard(&self, _: usize) -> Option<&[usize]> {
        None
    }
}

/// A number that has no value.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{}{error}", agent.map_or(String::new(), |agent| format!("of agent {}: ", agent + 1)))]
pub struct Fault {
    /// The agent from 0, of whom it would be.
    pub agent: Option<usize>,
    /// Which of the numbers asked for.
    pub output: usize,
    /// Why.
    pub error: ArithmeticError,
}

/// What is known of a thing.
#[derive(Debug, Clone)]
enum Known<T> {
    Nothing,
    Number(T),
    Truth(bool),
    Missing(ArithmeticError),
}

/// A program with its working space; used again and again, it allocates nothing.
#[derive(Debug, Clone)]
pub struct Evaluator<T> {
    program: Arc<Program>,
    lists: Vec<Vec<T>>,
    like: T,
    known: Vec<Known<T>>,
    bound: Vec<usize>,
}

impl<T: Number> Evaluator<T> {
    /// An evaluator for scalars like this one; `lists` are the parameters with one value for each agent.
    pub(crate) fn new(program: &Arc<Program>, lists: &[Vec<Rational>], like: &T) -> Self {
        let lists = lists.iter().map(|list| list.iter().map(|q| like.rational(q)).collect()).collect();
        let mut known = vec![Known::Nothing; program.ops.len()];
        // Constants are turned into the scalar once.
        for (place, op) in known.iter_mut().zip(&program.ops) {
            if let Op::Number(q) = op {
                *place = Known::Number(like.rational(q));
            }
        }
        let program = program.clone();
        Evaluator { bound: vec![0; program.slots.len()], program, lists, like: like.clone(), known }
    }

    /// Sets the numbers that were drawn for this step: of each list one for each agent.
    pub fn set_drawn(&mut self, drawn: &[Vec<T>]) {
        let first = self.lists.len() - drawn.len().min(self.lists.len());
        self.lists[first..].iter_mut().zip(drawn).for_each(|(list, drawn)| list.clone_from(drawn));
    }

    /// The numbers of the flock, in their order.
    ///
    /// # Errors
    /// [`Fault`] where one has no value.
    pub fn flock(&mut self, time: &T, state: &[T], hearing: &dyn Hearing) -> Result<Vec<T>, Fault> {
        let program = self.program.clone();
        self.steps(&program.once, &Moment { time, state, hearing });
        self.results(None, |_, value| Ok(value))
    }

    /// The numbers of some agents, from 0, in turn.
    ///
    /// # Errors
    /// [`Fault`] where one has no value.
    pub fn agents(
        &mut self,
        agents: impl Iterator<Item = usize>,
        (time, state): (&T, &[T]),
        hearing: &dyn Hearing,
        mut write: impl FnMut(usize, usize, T),
    ) -> Result<(), Fault> {
        let (program, moment) = (self.program.clone(), Moment { time, state, hearing });
        self.steps(&program.once, &moment);
        for agent in agents {
            self.bound[OWN] = agent;
            self.steps(&program.each, &moment);
            self.results(Some(agent), |output, value| {
                write(agent, output, value);
                Ok(())
            })?;
        }
        Ok(())
    }

    fn results<R>(
        &self,
        agent: Option<usize>,
        mut of: impl FnMut(usize, T) -> Result<R, Fault>,
    ) -> Result<Vec<R>, Fault> {
        let outputs = self.program.outputs.iter().enumerate();
        let value = |(output, &id): (usize, &usize)| match &self.known[id] {
            Known::Number(value) => of(output, value.clone()),
            Known::Truth(truth) => of(output, self.like.integer(i64::from(*truth))),
            Known::Missing(error) => Err(Fault { agent, output, error: error.clone() }),
            Known::Nothing => Err(Fault { agent, output, error: ArithmeticError::Domain("a value") }),
        };
        outputs.map(value).collect()
    }

    fn steps(&mut self, steps: &[Step], moment: &Moment<T>) {
        for step in steps {
            match step {
                Step::Thing(id) => self.known[*id] = self.thing(*id, moment),
                Step::Loop(round) => self.round(round, moment),
            }
        }
    }

    fn number(&self, id: usize) -> Result<&T, ArithmeticError> {
        match &self.known[id] {
            Known::Number(value) => Ok(value),
            Known::Missing(error) => Err(error.clone()),
            _ => Err(ArithmeticError::Domain("a number")),
        }
    }

    fn truth(&self, id: usize) -> Result<bool, ArithmeticError> {
        match &self.known[id] {
            Known::Truth(value) => Ok(*value),
            Known::Missing(error) => Err(error.clone()),
            _ => Err(ArithmeticError::Domain("a condition")),
        }
    }

    fn agent(&self, of: Of) -> usize {
        match of {
            Of::Slot(slot) => self.bound[slot],
            Of::Agent(agent) => agent,
        }
    }

    fn thing(&self, id: usize, moment: &Moment<T>) -> Known<T> {
        if let Op::Number(_) = self.program.ops[id] {
            return self.known[id].clone();
        }
        match self.value(&self.program.ops[id], moment) {
            Ok(Some(value)) => Known::Number(value),
            Ok(None) => self.condition(&self.program.ops[id]).map_or_else(Known::Missing, Known::Truth),
            Err(error) => Known::Missing(error),
        }
    }

    /// A number; nothing for a condition.
    fn value(&self, op: &Op, moment: &Moment<T>) -> Result<Option<T>, ArithmeticError> {
        let of = |id: &usize| self.number(*id);
        Ok(Some(match op {
            Op::Number(q) => self.like.rational(q),
            Op::Pi => self.like.circle()?,
            Op::Time => moment.time.clone(),
            Op::Parameter(list, agent) => self.lists[*list][self.agent(*agent)].clone(),
            Op::State { start, stride, component, of } => {
                moment.state[start + self.agent(*of) * stride + component].clone()
            }
            Op::Negated(a) => -of(a)?.clone(),
            Op::Sum(a, b) => of(a)?.clone() + of(b)?,
            Op::Difference(a, b) => of(a)?.clone() - of(b)?,
            Op::Product(a, b) if a == b => of(a)?.square(),
            Op::Product(a, b) => of(a)?.clone() * of(b)?,
            Op::Quotient(a, b) => of(a)?.over(of(b)?)?,
            Op::Power(a, k) => of(a)?.power(u64::from(*k)),
            Op::Function(function, a) => function.at(of(a)?)?,
            Op::Angle(y, x) => T::angle(of(y)?, of(x)?)?,
            Op::Absolute(a) => of(a)?.absolute()?,
            Op::Larger(a, b) => of(a)?.larger(of(b)?)?,
            Op::Smaller(a, b) => of(a)?.smaller(of(b)?)?,
            Op::Choice(condition, a, b) => if self.truth(*condition)? { of(a)? } else { of(b)? }.clone(),
            Op::Compared(..) | Op::Both(..) | Op::Not(_) => return Ok(None),
            Op::Gathered(..) => return Err(ArithmeticError::Domain("a loop")),
        }))
    }

    /// The sign of a difference.
    fn sign(&self, a: usize, b: usize) -> Result<Sign, ArithmeticError> {
        (self.number(a)?.clone() - self.number(b)?).sign().ok_or(ArithmeticError::UNDECIDED_SIGN)
    }

    fn condition(&self, op: &Op) -> Result<bool, ArithmeticError> {
        Ok(match op {
            Op::Compared(relation, a, b) => {
                let sign = self.sign(*a, *b)?;
                match relation {
                    Relation::Equal => sign == Sign::Zero,
                    Relation::Different => sign != Sign::Zero,
                    Relation::Less => sign == Sign::Negative,
                    Relation::AtMost => sign != Sign::Positive,
                    Relation::Greater => sign == Sign::Positive,
                    Relation::AtLeast => sign != Sign::Negative,
                }
            }
            // Whatever the other one is, false decides.
            Op::Both(a, b) => match (self.truth(*a), self.truth(*b)) {
                (Ok(false), _) | (_, Ok(false)) => false,
                (first, second) => first? && second?,
            },
            Op::Not(a) => !self.truth(*a)?,
            _ => return Err(ArithmeticError::Domain("a condition")),
        })
    }

    fn round(&mut self, round: &Round, moment: &Moment<T>) {
        let program = self.program.clone();
        let this = &program.loops[round.number];
        let mut gathered: Vec<Gathered<T>> = round.results.iter().map(|_| Gathered::Empty).collect();
        let hears = program.slots[this.slot].hears.map(|of| self.agent(of));
        let mut count = 0;
        let mut visit = |machine: &mut Self, agent: usize| {
            machine.bound[this.slot] = agent;
            machine.steps(&round.before, moment);
            match this.condition.map_or(Ok(true), |id| machine.truth(id)) {
                Ok(false) => return,
                Ok(true) => {}
                Err(error) => gathered.iter_mut().for_each(|all| *all = Gathered::Missing(error.clone())),
            }
            machine.steps(&round.after, moment);
            count += 1;
            for (all, (place, _)) in gathered.iter_mut().zip(&round.results) {
                let (gather, body) = this.bodies[*place];
                all.take(gather, machine.number(body));
            }
        };
        let heard = hears.and_then(|agent| moment.hearing.heard(agent));
        match heard {
            Some(list) => list.iter().for_each(|&other| visit(self, other)),
            None => {
                (0..moment.hearing.agents()).filter(|agent| Some(*agent) != hears).for_each(|agent| visit(self, agent))
            }
        }
        for (all, &(place, id)) in gathered.into_iter().zip(&round.results) {
            self.known[id] = all.ended(this.bodies[place].0, count, &self.like);
        }
    }
}

/// A time with a state and a network.
struct Moment<'a, T> {
    time: &'a T,
    state: &'a [T],
    hearing: &'a dyn Hearing,
}

/// What a loop has gathered so far.
enum Gathered<T> {
    Empty,
    Number(T),
    Missing(ArithmeticError),
}

impl<T: Number> Gathered<T> {
    fn take(&mut self, gather: Gather, value: Result<&T, ArithmeticError>) {
        let so_far = std::mem::replace(self, Gathered::Empty);
        *self = match (so_far, value) {
            (Gathered::Missing(error), _) => Gathered::Missing(error),
            (_, Err(error)) => Gathered::Missing(error),
            (Gathered::Empty, Ok(value)) => Gathered::Number(value.clone()),
            (Gathered::Number(all), Ok(value)) => match gather {
                Gather::Sum | Gather::Mean | Gather::Count => Gathered::Number(all + value),
                Gather::Largest | Gather::Smallest => {
                    let wanted = if gather == Gather::Largest { Sign::Negative } else { Sign::Positive };
                    match (all.clone() - value).sign() {
                        None => Gathered::Missing(ArithmeticError::UNDECIDED_SIGN),
                        Some(sign) if sign == wanted => Gathered::Number(value.clone()),
                        Some(_) => Gathered::Number(all),
                    }
                }
            },
        };
    }

    /// A sum and a mean over none are zero.
    fn ended(self, gather: Gather, count: usize, like: &T) -> Known<T> {
        match (self, gather) {
            (Gathered::Missing(error), _) => Known::Missing(error),
            (Gathered::Empty, Gather::Largest | Gather::Smallest) => Known::Missing(ArithmeticError::Domain(
                "somebody whom the agent hears, for a largest or smallest value",
            )),
            (Gathered::Empty, _) => Known::Number(like.zero()),
            (Gathered::Number(all), Gather::Mean) => Known::Number(all * &like.ratio(1, count.max(1) as i64)),
            (Gathered::Number(all), _) => Known::Number(all),
        }
    }
}
