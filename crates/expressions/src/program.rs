//! What is computed: each thing once, in the loops where it changes.
//!
//! Things are numbered in the order in which they were made, so that what a thing needs has a smaller number. An *agent variable* (a slot) is bound by
//! a loop; slot 0 stands for the flock, slot 1 for the agent whose rates are asked for. A thing belongs to the innermost slot that it depends on.

use super::function::Function;
use super::syntax::Relation;
use arithmetic::{Rational, Ring, rational};
use num_traits::Zero;
use std::collections::{BTreeSet, HashMap};

/// The number of a thing.
pub(crate) type Id = usize;
/// An agent variable.
pub(crate) type Slot = usize;

/// The slot of the flock.
pub(crate) const FLOCK: Slot = 0;
/// The slot of the agent whose rates are asked for.
pub(crate) const OWN: Slot = 1;

/// Of whom a number of the state is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Of {
    /// The agent of a variable.
    Slot(Slot),
    /// One agent, from 0.
    Agent(usize),
}

/// What a thing is.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(crate) enum Op {
    Number(Rational),
    Pi,
    Time,
    /// The number of agents, in statements about any number of them.
    Agents,
    /// A parameter with one value for each agent.
    Parameter(usize, Of),
    /// A number of the state: where those of agent 0 begin, numbers from one agent to the next, which.
    State {
        start: usize,
        stride: usize,
        component: usize,
        of: Of,
    },
    Negated(Id),
    Sum(Id, Id),
    Difference(Id, Id),
    Product(Id, Id),
    Quotient(Id, Id),
    Power(Id, u32),
    Function(Function, Id),
    /// The angle of `(x, y)`, from y and x.
    Angle(Id, Id),
    Absolute(Id),
    Larger(Id, Id),
    Smaller(Id, Id),
    /// `if`: a condition and two numbers.
    Choice(Id, Id, Id),
    Compared(Relation, Id, Id),
    Both(Id, Id),
    Not(Id),
    /// What a loop has gathered: the loop and which of its results.
    Gathered(usize, usize),
}

/// What a loop does with the numbers of its agents.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Gather {
    Sum,
    Mean,
    Largest,
    Smallest,
    Count,
}

/// A loop over agents: all of them in the flock, those whom an agent hears elsewhere.
#[derive(Debug, Clone)]
pub(crate) struct Loop {
    pub slot: Slot,
    parent: Slot,
    pub condition: Option<Id>,
    pub bodies: Vec<(Gather, Id)>,
    rank: usize,
}

impl Loop {
    /// What one of its results is gathered from: its condition and what is added up.
    pub fn needs(&self, place: usize) -> impl Iterator<Item = Id> + use<> {
        self.condition.into_iter().chain([self.bodies[place].1])
    }
}

/// An agent variable.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Variable {
    /// The variable that is bound outside of it.
    pub parent: Slot,
    /// It runs over those whom this agent hears; over all where nobody is named.
    pub hears: Option<Of>,
    pub name: String,
}

/// Things under construction.
#[derive(Debug, Clone, Default)]
pub(crate) struct Things {
    pub ops: Vec<Op>,
    known: HashMap<Op, Id>,
    /// The innermost agent variable that a thing depends on, and all of them.
    pub slot_of: Vec<Slot>,
    pub free: Vec<BTreeSet<Slot>>,
    /// How many loops stand below a thing, one inside another's argument: loops of one rank never need each other.
    rank: Vec<usize>,
    pub slots: Vec<Variable>,
    pub loops: Vec<Loop>,
}

/// What is done in turn.
#[derive(Debug, Clone)]
pub(crate) enum Step {
    Thing(Id),
    Loop(Box<Round>),
}

/// A loop with what is done for each agent.
#[derive(Debug, Clone)]
pub(crate) struct Round {
    pub number: usize,
    /// Before the condition is looked at.
    pub before: Vec<Step>,
    /// After it.
    pub after: Vec<Step>,
    /// The things that hold the results.
    pub results: Vec<(usize, Id)>,
}

/// Numbers that are computed together, for the flock or for each agent.
#[derive(Debug, Clone)]
pub struct Program {
    pub(crate) ops: Vec<Op>,
    pub(crate) loops: Vec<Loop>,
    /// Once.
    pub(crate) once: Vec<Step>,
    /// For each agent.
    pub(crate) each: Vec<Step>,
    /// The results.
    pub(crate) outputs: Vec<Id>,
    /// All that these need.
    pub(crate) wanted: BTreeSet<Id>,
    /// The agent variables that a thing depends on.
    pub(crate) free: Vec<BTreeSet<Slot>>,
    pub(crate) slots: Vec<Variable>,
}

impl Op {
    /// What it is computed from; what a loop gathers is not among it.
    pub fn needs(&self) -> Vec<Id> {
        let mut needs = Vec::new();
        self.with(|id| {
            needs.push(id);
            id
        });
        needs
    }

    /// The same of other things.
    pub fn with(&self, mut other: impl FnMut(Id) -> Id) -> Op {
        let mut of = |id: &Id| other(*id);
        match self {
            Op::Negated(a) => Op::Negated(of(a)),
            Op::Power(a, k) => Op::Power(of(a), *k),
            Op::Function(function, a) => Op::Function(*function, of(a)),
            Op::Absolute(a) => Op::Absolute(of(a)),
            Op::Not(a) => Op::Not(of(a)),
            Op::Sum(a, b) => Op::Sum(of(a), of(b)),
            Op::Difference(a, b) => Op::Difference(of(a), of(b)),
            Op::Product(a, b) => Op::Product(of(a), of(b)),
            Op::Quotient(a, b) => Op::Quotient(of(a), of(b)),
            Op::Angle(a, b) => Op::Angle(of(a), of(b)),
            Op::Larger(a, b) => Op::Larger(of(a), of(b)),
            Op::Smaller(a, b) => Op::Smaller(of(a), of(b)),
            Op::Compared(relation, a, b) => Op::Compared(*relation, of(a), of(b)),
            Op::Both(a, b) => Op::Both(of(a), of(b)),
            Op::Choice(a, b, c) => Op::Choice(of(a), of(b), of(c)),
            Op::Number(_)
            | Op::Pi
            | Op::Time
            | Op::Agents
            | Op::Parameter(..)
            | Op::State { .. }
            | Op::Gathered(..) => self.clone(),
        }
    }

    /// The same with other agent variables.
    pub fn of(&self, mut other: impl FnMut(Slot) -> Slot) -> Op {
        let mut of = |of: &Of| of.of(&mut other);
        match self {
            Op::Parameter(list, agent) => Op::Parameter(*list, of(agent)),
            Op::State { start, stride, component, of: agent } => {
                Op::State { start: *start, stride: *stride, component: *component, of: of(agent) }
            }
            _ => self.clone(),
        }
    }

    /// The agent variable that stands in it.
    pub fn slot(&self) -> Option<Slot> {
        match self {
            Op::Parameter(_, Of::Slot(slot)) | Op::State { of: Of::Slot(slot), .. } => Some(*slot),
            _ => None,
        }
    }
}

impl Of {
    /// The same with another agent variable.
    pub fn of(&self, other: impl FnOnce(Slot) -> Slot) -> Of {
        match self {
            Of::Slot(slot) => Of::Slot(other(*slot)),
            Of::Agent(agent) => Of::Agent(*agent),
        }
    }
}

impl Things {
    /// The flock and an agent of its own.
    pub fn new() -> Self {
        let variable = |name: &str| Variable { parent: FLOCK, hears: None, name: name.to_string() };
        Things { slots: vec![variable(""), variable("i")], ..Things::default() }
    }

    /// Nothing yet, with the agent variables of a program.
    pub fn with_slots_of(program: &Program) -> Self {
        Things { slots: program.slots.clone(), ..Things::default() }
    }

    /// The variable of a loop of that name inside another variable's scope, over those whom an agent hears.
    pub fn slot(&mut self, parent: Slot, hears: Option<Of>, name: &str) -> Slot {
        let wanted = Variable { parent, hears, name: name.to_string() };
        let found = (OWN + 1..self.slots.len()).find(|&slot| self.slots[slot] == wanted);
        found.unwrap_or_else(|| {
            self.slots.push(wanted);
            self.slots.len() - 1
        })
    }

    /// The variable that is bound last.
    pub fn deepest(&self, slots: impl Iterator<Item = Slot>) -> Slot {
        slots.fold(FLOCK, |a, b| self.deeper(a, b))
    }

    fn depth(&self, mut slot: Slot) -> usize {
        let mut depth = 0;
        while slot != FLOCK {
            slot = self.slots[slot].parent;
            depth += 1;
        }
        depth
    }

    fn deeper(&self, a: Slot, b: Slot) -> Slot {
        if self.depth(b) > self.depth(a) { b } else { a }
    }

    fn constant(&self, id: Id) -> Option<&Rational> {
        match &self.ops[id] {
            Op::Number(q) => Some(q),
            _ => None,
        }
    }

    /// The same from constants, computed once.
    fn folded(&self, op: &Op) -> Option<Rational> {
        let of = |id: &Id| self.constant(*id);
        match op {
            Op::Negated(a) => of(a).map(|a| -a),
            Op::Sum(a, b) => Some(of(a)? + of(b)?),
            Op::Difference(a, b) => Some(of(a)? - of(b)?),
            Op::Product(a, b) => Some(of(a)? * of(b)?),
            Op::Quotient(a, b) => of(b).filter(|b| !b.is_zero()).and_then(|b| Some(of(a)? / b)),
            Op::Power(a, k) if *k <= 64 => of(a).map(|a| a.power(u64::from(*k))),
            // Roots of squares, and what is 0 or 1.
            Op::Function(function, a) => of(a).and_then(|a| function.at(a).ok()),
            _ => None,
        }
    }

    /// What it is the same as without computing anything.
    fn simplified(&self, op: &Op) -> Option<Id> {
        let is = |id: &Id, n: i64| self.constant(*id).is_some_and(|q| *q == rational(n, 1));
        match op {
            Op::Sum(a, b) if is(a, 0) => Some(*b),
            Op::Sum(a, b) | Op::Difference(a, b) if is(b, 0) => Some(*a),
            Op::Product(a, b) if is(a, 1) => Some(*b),
            Op::Product(a, b) | Op::Quotient(a, b) if is(b, 1) => Some(*a),
            Op::Power(a, 1) => Some(*a),
            _ => None,
        }
    }

    /// The number of a thing, which is made where it is new.
    pub fn add(&mut self, op: Op) -> Id {
        let op = self.folded(&op).map_or(op, Op::Number);
        if let Some(id) = self.simplified(&op).or_else(|| self.known.get(&op).copied()) {
            return id;
        }
        let needs = op.needs();
        let own = match &op {
            Op::Gathered(number, _) => self.loops[*number].parent,
            _ => op.slot().unwrap_or(FLOCK),
        };
        let slot = needs.iter().fold(own, |slot, id| self.deeper(slot, self.slot_of[*id]));
        let own = match &op {
            Op::Gathered(number, _) => self.loops[*number].rank + 1,
            _ => 0,
        };
        let rank = needs.iter().fold(own, |rank, id| rank.max(self.rank[*id]));
        let id = self.ops.len();
        self.free.push(self.free_of(&op, &needs));
        self.known.insert(op.clone(), id);
        self.ops.push(op);
        self.slot_of.push(slot);
        self.rank.push(rank);
        id
    }

    fn free_of(&self, op: &Op, needs: &[Id]) -> BTreeSet<Slot> {
        let union = |needs: &[Id]| -> BTreeSet<Slot> { needs.iter().flat_map(|id| &self.free[*id]).copied().collect() };
        let Op::Gathered(number, place) = op else {
            return union(needs).into_iter().chain(op.slot()).collect();
        };
        let this = &self.loops[*number];
        let needs: Vec<Id> = this.needs(*place).collect();
        let hears = match self.slots[this.slot].hears {
            Some(Of::Slot(slot)) => Some(slot),
            _ => None,
        };
        union(&needs).into_iter().chain(hears).filter(|slot| *slot != this.slot).collect()
    }

    pub fn number(&mut self, q: Rational) -> Id {
        self.add(Op::Number(q))
    }

    pub fn integer(&mut self, n: i64) -> Id {
        self.number(rational(n, 1))
    }

    /// What a loop over a variable gathers; loops over the same agents are one where neither needs the other.
    pub fn gather(&mut self, slot: Slot, condition: Option<Id>, gather: Gather, body: Id) -> Id {
        let parent = self.slots[slot].parent;
        let rank = self.rank[body].max(condition.map_or(0, |id| self.rank[id]));
        let same = |l: &Loop| (l.slot, l.condition, l.rank) == (slot, condition, rank);
        let number = self.loops.iter().position(same).unwrap_or_else(|| {
            self.loops.push(Loop { slot, parent, condition, bodies: Vec::new(), rank });
            self.loops.len() - 1
        });
        let bodies = &mut self.loops[number].bodies;
        let place = bodies.iter().position(|known| *known == (gather, body)).unwrap_or_else(|| {
            bodies.push((gather, body));
            bodies.len() - 1
        });
        self.add(Op::Gathered(number, place))
    }

    /// A thing of a program once more, of other things and agent variables.
    pub fn again(&mut self, program: &Program, op: &Op, of: impl Fn(Id) -> Id, slot: impl Fn(Slot) -> Slot) -> Id {
        let Op::Gathered(number, place) = op else { return self.add(op.with(of).of(slot)) };
        let this = &program.loops[*number];
        let (gather, body) = this.bodies[*place];
        self.gather(slot(this.slot), this.condition.map(&of), gather, of(body))
    }

    /// The things of a slot that these need, in turn, and what they need from outside.
    fn plan(
        &self,
        slot: Slot,
        roots: &[Id],
        (done, wanted): (&BTreeSet<Id>, &BTreeSet<Id>),
    ) -> (Vec<Step>, BTreeSet<Id>, BTreeSet<Id>) {
        let (mut here, mut outside) = (BTreeSet::new(), BTreeSet::new());
        let mut rounds: HashMap<usize, Round> = HashMap::new();
        let mut open = roots.to_vec();
        while let Some(id) = open.pop() {
            if done.contains(&id) {
                continue;
            }
            if self.slot_of[id] != slot {
                outside.insert(id);
                continue;
            }
            if !here.insert(id) {
                continue;
            }
            open.extend(self.ops[id].needs());
            if let Op::Gathered(number, place) = self.ops[id] {
                let round = rounds.entry(number).or_insert_with(|| {
                    let (round, needed) = self.round(number, wanted);
                    open.extend(needed);
                    round
                });
                round.results.push((place, id));
            }
        }
        let gathered = |id: &Id| matches!(self.ops[*id], Op::Gathered(..));
        let things = here.iter().filter(|id| !gathered(id)).map(|&id| ((self.rank[id], 0, id), Step::Thing(id)));
        let mut steps: Vec<_> = things.collect();
        steps.extend(rounds.into_values().map(|mut round| {
            round.results.sort_unstable();
            ((self.loops[round.number].rank, 1, round.number), Step::Loop(Box::new(round)))
        }));
        steps.sort_by_key(|(key, _)| *key);
        (steps.into_iter().map(|(_, step)| step).collect(), here, outside)
    }

    /// A loop, and what it needs from outside.
    fn round(&self, number: usize, wanted: &BTreeSet<Id>) -> (Round, BTreeSet<Id>) {
        let this = &self.loops[number];
        let first: Vec<Id> = this.condition.into_iter().collect();
        let (before, done, mut outside) = self.plan(this.slot, &first, (&BTreeSet::new(), wanted));
        let is_wanted =
            |place: usize| self.known.get(&Op::Gathered(number, place)).is_some_and(|id| wanted.contains(id));
        let bodies = this.bodies.iter().enumerate().filter(|(place, _)| is_wanted(*place)).map(|(_, (_, body))| *body);
        let bodies: Vec<Id> = bodies.collect();
        let (after, _, further) = self.plan(this.slot, &bodies, (&done, wanted));
        outside.extend(further);
        (Round { number, before, after, results: Vec::new() }, outside)
    }

    /// All that some things need: of what a loop gathers for several programs, each takes its own.
    pub fn wanted(&self, outputs: &[Id]) -> BTreeSet<Id> {
        let (mut wanted, mut open) = (BTreeSet::new(), outputs.to_vec());
        while let Some(id) = open.pop() {
            if !wanted.insert(id) {
                continue;
            }
            open.extend(self.ops[id].needs());
            if let Op::Gathered(number, place) = self.ops[id] {
                open.extend(self.loops[number].needs(place));
            }
        }
        wanted
    }

    /// The program that computes these things: of each agent where they may depend on it, of the flock otherwise.
    pub fn program(&self, outputs: Vec<Id>) -> Program {
        let (none, wanted) = (BTreeSet::new(), self.wanted(&outputs));
        let (each, _, outside) = self.plan(OWN, &outputs, (&none, &wanted));
        let outside: Vec<Id> = outside.into_iter().collect();
        let (once, ..) = self.plan(FLOCK, &outside, (&none, &wanted));
        let (ops, loops, free, slots) = (self.ops.clone(), self.loops.clone(), self.free.clone(), self.slots.clone());
        Program { ops, loops, once, each, outputs, wanted, free, slots }
    }
}

impl Program {
    /// Whether the time does not occur.
    pub(crate) fn is_autonomous(&self) -> bool {
        !self.ops.iter().any(|op| matches!(op, Op::Time))
    }

    /// How many functions stand in it.
    pub(crate) fn functions(&self) -> usize {
        self.ops.iter().filter(|op| matches!(op, Op::Function(..) | Op::Angle(..) | Op::Pi)).count()
    }

    /// How many loops stand inside each other at most.
    pub(crate) fn depth(&self) -> usize {
        let depth = |mut slot: Slot| {
            let mut depth = 0;
            while slot != FLOCK {
                slot = self.slots[slot].parent;
                depth += 1;
            }
            depth
        };
        (0..self.slots.len()).map(depth).max().unwrap_or(0)
    }

    /// Whether no agent is named and no parameter has a value for each.
    pub(crate) fn is_symmetric(&self) -> bool {
        let own = |op: &Op| matches!(op, Op::Parameter(..) | Op::State { of: Of::Agent(_), .. });
        !self.ops.iter().any(own) && !self.slots.iter().any(|slot| matches!(slot.hears, Some(Of::Agent(_))))
    }

    /// Whether every number in it is rational where the state is.
    pub fn is_rational(&self) -> bool {
        let needed = |step: &Step| self.irrational(step);
        !self.once.iter().chain(&self.each).any(needed)
    }

    fn irrational(&self, step: &Step) -> bool {
        match step {
            Step::Thing(id) => matches!(self.ops[*id], Op::Function(..) | Op::Pi | Op::Angle(..)),
            Step::Loop(round) => round.before.iter().chain(&round.after).any(|step| self.irrational(step)),
        }
    }
}
