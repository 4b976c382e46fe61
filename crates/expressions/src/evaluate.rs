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
    /// A condition that is true or false, which this number stands for: 1 or 0.
    Share(T),
    /// A condition that has a truth value, but which one cannot be told.
    Unsure,
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
    /// Of each agent and each other one how much it hears of it, row by row: what a sum over those whom an agent hears takes of each.
    weights: Option<Vec<T>>,
    /// Divisors and arguments of functions, in turn, where they are kept.
    trail: Option<Vec<T>>,
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
        let bound = vec![0; program.slots.len()];
        Evaluator { bound, program, lists, like: like.clone(), known, weights: None, trail: None }
    }

    /// The same on a network with weights, one row for each agent, of which only sums make use; means, counts and conditions have no values.
    pub(crate) fn weighted(self, weights: Vec<T>) -> Self {
        Evaluator { weights: Some(weights), ..self }
    }

    /// The same, which keeps what is divided by and what functions are taken of.
    pub(crate) fn trailed(self) -> Self {
        Evaluator { trail: Some(Vec::new()), ..self }
    }

    /// What was kept.
    pub(crate) fn into_trail(self) -> Vec<T> {
        self.trail.unwrap_or_default()
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
        self.flock_each(time, state, hearing).into_iter().collect()
    }

    /// The numbers of the flock, in their order, each with a value or why it has none.
    pub fn flock_each(&mut self, time: &T, state: &[T], hearing: &dyn Hearing) -> Vec<Result<T, Fault>> {
        let program = self.program.clone();
        self.steps(&program.once, &Moment { time, state, hearing });
        self.results(None).map(|(_, value)| value).collect()
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
            for (output, value) in self.results(Some(agent)) {
                write(agent, output, value?);
            }
        }
        Ok(())
    }

    fn results(&self, agent: Option<usize>) -> impl Iterator<Item = (usize, Result<T, Fault>)> {
        self.program.outputs.iter().enumerate().map(move |(output, &id)| {
            let error = match &self.known[id] {
                Known::Number(value) | Known::Share(value) => return (output, Ok(value.clone())),
                Known::Truth(truth) => return (output, Ok(self.like.integer(i64::from(*truth)))),
                Known::Unsure => ArithmeticError::UNDECIDED_SIGN,
                Known::Missing(error) => error.clone(),
                Known::Nothing => ArithmeticError::Domain("a value"),
            };
            (output, Err(Fault { agent, output, error }))
        })
    }

    fn steps(&mut self, steps: &[Step], moment: &Moment<T>) {
        for step in steps {
            match step {
                Step::Thing(id) => {
                    self.keep_trail(*id);
                    self.known[*id] = self.thing(*id, moment);
                }
                Step::Loop(round) => self.round(round, moment),
            }
        }
    }

    fn keep_trail(&mut self, id: usize) {
        let Some(trail) = &mut self.trail else { return };
        let kept = match &self.program.ops[id] {
            Op::Quotient(_, a) | Op::Function(_, a) => [Some(*a), None],
            Op::Angle(a, b) => [Some(*a), Some(*b)],
            _ => return,
        };
        for id in kept.into_iter().flatten() {
            if let Known::Number(value) = &self.known[id] {
                trail.push(value.clone());
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
            Ok(None) => self.condition(&self.program.ops[id]),
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
            Op::Agents => self.like.integer(moment.hearing.agents() as i64),
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
            Op::Choice(condition, a, b) => match &self.known[*condition] {
                Known::Truth(true) => of(a)?.clone(),
                Known::Truth(false) => of(b)?.clone(),
                Known::Share(share) => of(b)?.clone() + (of(a)?.clone() - of(b)?) * share,
                Known::Unsure => of(a)?.either(of(b)?).ok_or(ArithmeticError::UNDECIDED_SIGN)?,
                Known::Missing(error) => return Err(error.clone()),
                _ => return Err(ArithmeticError::Domain("a condition")),
            },
            Op::Compared(..) | Op::Both(..) | Op::Not(_) => return Ok(None),
            Op::Gathered(..) => return Err(ArithmeticError::Domain("a loop")),
        }))
    }

    fn condition(&self, op: &Op) -> Known<T> {
        match op {
            Op::Compared(relation, a, b) => match (self.number(*a), self.number(*b)) {
                (Ok(a), Ok(b)) => compared(*relation, a, b),
                (Err(error), _) | (_, Err(error)) => Known::Missing(error),
            },
            Op::Both(a, b) => match (&self.known[*a], &self.known[*b]) {
                // Whatever the other one is, false decides.
                (Known::Truth(false), _) | (_, Known::Truth(false)) => Known::Truth(false),
                (Known::Truth(true), other) | (other, Known::Truth(true)) => other.clone(),
                (Known::Share(a), Known::Share(b)) => Known::Share(a.clone() * b),
                (Known::Missing(error), _) | (_, Known::Missing(error)) => Known::Missing(error.clone()),
                _ => Known::Unsure,
            },
            Op::Not(a) => match &self.known[*a] {
                Known::Truth(truth) => Known::Truth(!truth),
                Known::Share(share) => Known::Share(share.one() - share),
                other => other.clone(),
            },
            _ => Known::Missing(ArithmeticError::Domain("a condition")),
        }
    }

    fn round(&mut self, round: &Round, moment: &Moment<T>) {
        let program = self.program.clone();
        let this = &program.loops[round.number];
        let mut gathered: Vec<Gathered<T>> = round.results.iter().map(|_| Gathered::Empty).collect();
        let hears = program.slots[this.slot].hears.map(|of| self.agent(of));
        // Everybody is heard with the weight 1 where a sum runs over all.
        let row = hears.filter(|_| self.weights.is_some()).map(|agent| agent * moment.hearing.agents());
        let mut count = 0;
        let mut visit = |machine: &mut Self, agent: usize| {
            machine.bound[this.slot] = agent;
            machine.steps(&round.before, moment);
            let condition = this.condition.map_or(&Known::Truth(true), |id| &machine.known[id]);
            let part = match condition {
                Known::Truth(false) => return,
                Known::Truth(true) => row.and_then(|row| machine.weights.as_ref()?.get(row + agent)).cloned(),
                Known::Share(share) if row.is_none() => Some(share.clone()),
                Known::Missing(error) => {
                    gathered.iter_mut().for_each(|all| *all = Gathered::Missing(error.clone()));
                    None
                }
                _ => {
                    gathered.iter_mut().for_each(|all| *all = Gathered::Missing(ArithmeticError::UNDECIDED_SIGN));
                    None
                }
            };
            machine.steps(&round.after, moment);
            count += 1;
            for (all, (place, _)) in gathered.iter_mut().zip(&round.results) {
                let (gather, body) = this.bodies[*place];
                match &part {
                    None => all.take(gather, machine.number(body)),
                    Some(part)
                        if matches!(gather, Gather::Sum) || this.condition.is_some() && gather == Gather::Count =>
                    {
                        let product = machine.number(body).map(|value| value.clone() * part);
                        all.take(gather, product.as_ref().map_err(Clone::clone));
                    }
                    Some(_) => all.take(gather, Err(ArithmeticError::Domain("a sum"))),
                }
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

/// Whether two numbers are related so.
fn compared<T: Number>(relation: Relation, a: &T, b: &T) -> Known<T> {
    let difference = a.clone() - b;
    let Some(sign) = difference.sign() else {
        let negative = |difference: &T| difference.indicator().map_or(Known::Unsure, Known::Share);
        let not = |known: Known<T>| match known {
            Known::Share(share) => Known::Share(share.one() - &share),
            other => other,
        };
        return match relation {
            Relation::Less => negative(&difference),
            Relation::AtLeast => not(negative(&difference)),
            Relation::Greater => negative(&-difference),
            Relation::AtMost => not(negative(&-difference)),
            Relation::Equal | Relation::Different => Known::Unsure,
        };
    };
    Known::Truth(match relation {
        Relation::Equal => sign == Sign::Zero,
        Relation::Different => sign != Sign::Zero,
        Relation::Less => sign == Sign::Negative,
        Relation::AtMost => sign != Sign::Positive,
        Relation::Greater => sign == Sign::Positive,
        Relation::AtLeast => sign != Sign::Negative,
    })
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
                Gather::Largest => all.larger(value).map_or_else(Gathered::Missing, Gathered::Number),
                Gather::Smallest => all.smaller(value).map_or_else(Gathered::Missing, Gathered::Number),
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
