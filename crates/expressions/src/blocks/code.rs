//! From the plan of a program to code for blocks: registers numbered, each level with its constants, what it loads and what comes from outside.

use super::fuse;
use crate::function::Function;
use crate::program::{FLOCK, Gather, Id, OWN, Of, Op, Program, Round, Slot, Step as Planned};
use crate::syntax::Relation;
use num_traits::ToPrimitive;
use std::collections::HashMap;

/// The number of a register of a level. What a register is computed from has smaller numbers.
pub(super) type Register = usize;

/// Numbers of all agents, one after the other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Column {
    /// Of the state: where those of agent 0 begin, numbers from one agent to the next, which.
    State { start: usize, stride: usize, component: usize },
    /// A parameter with one value for each agent.
    Parameter(usize),
}

/// What a register holds before anything is computed.
#[derive(Debug, Clone, Copy)]
pub(super) enum Load {
    /// A number of the agent of each lane: the number of a column.
    Each(usize),
    /// A number of one agent.
    One(usize, usize),
    Time,
    /// A register of the level around this one.
    Outer(Register),
}

/// What is done with every lane. Something that has no value is not a number.
#[derive(Debug, Clone, Copy)]
pub(super) enum Instruction {
    Negated(Register),
    Sum(Register, Register),
    Difference(Register, Register),
    Product(Register, Register),
    Quotient(Register, Register),
    Root(Register),
    Of(Function, Register),
    Angle(Register, Register),
    Absolute(Register),
    Larger(Register, Register),
    Smaller(Register, Register),
    Choice(Register, Register, Register),
    /// Truth is 1, falsehood 0.
    Compared(Relation, Register, Register),
    Both(Register, Register),
    Not(Register),
    /// `(a - b)²`.
    Square(Register, Register),
    /// `(a - b)² + c`.
    SquareAdded(Register, Register, Register),
    /// `(a - b) c`.
    Scaled(Register, Register, Register),
    /// `c x^(-1/4)`: c and x.
    InverseFourthRoot(Register, Register),
}

/// What a loop gathers of each lane.
#[derive(Debug, Clone, Copy)]
pub(super) enum Body {
    Own(Register),
    /// `c (a - b)`: c, a and b.
    Scaled(Register, Register, Register),
}

/// What a level does in turn.
#[derive(Debug, Clone)]
pub(super) enum Step {
    /// Instructions with where their results go.
    Straight(Vec<(Register, Instruction)>),
    Loop(Box<Inner>),
}

/// Whose lanes a loop runs over.
#[derive(Debug, Clone, Copy)]
pub(super) enum Heard {
    All,
    /// Those whom the agent of this level hears.
    Of(usize),
    /// Those whom one agent hears.
    Agent(usize),
}

/// A loop: each lane of the level around it has the lanes of its agents here.
#[derive(Debug, Clone)]
pub(super) struct Inner {
    pub heard: Heard,
    pub level: Level,
    /// What is gathered, from which register of the level, into which of the level around it.
    pub results: Vec<(Gather, Body, Register)>,
}

/// Code that runs over lanes of one sort: once for the flock, for agents, for pairs, ..
#[derive(Debug, Clone, Default)]
pub(super) struct Level {
    /// Larger than that of the level around it.
    pub number: usize,
    pub loads: Vec<(Register, Load)>,
    pub constants: Vec<(Register, f64)>,
    pub before: Vec<Step>,
    /// Lanes where this is not true count for nothing.
    pub condition: Option<Register>,
    pub after: Vec<Step>,
    pub registers: usize,
}

/// A program for blocks.
#[derive(Debug, Clone)]
pub(super) struct Code {
    pub columns: Vec<Column>,
    pub flock: Level,
    pub agents: Level,
    /// Registers of the agents' level; of the flock's where there are no agents.
    pub outputs: Vec<Register>,
    /// How many levels there are, and registers in each.
    pub levels: Vec<usize>,
}

/// A level under construction.
struct Draft {
    slot: Slot,
    level: Level,
    known: HashMap<Id, Register>,
    constants: HashMap<u64, Register>,
}

struct Builder<'a> {
    program: &'a Program,
    columns: Vec<Column>,
    /// The levels inside each other, the flock first.
    open: Vec<Draft>,
    levels: Vec<usize>,
}

impl Code {
    /// Code for the agents' numbers; for those of the flock where the program is about it.
    pub fn new(program: &Program, of_agents: bool) -> Self {
        let mut builder = Builder { program, columns: Vec::new(), open: Vec::new(), levels: Vec::new() };
        builder.enter(FLOCK);
        let before = builder.steps(&program.once);
        builder.open[0].level.before = before;
        let find = |builder: &mut Builder| program.outputs.iter().map(|&id| builder.register(id)).collect();
        let (agents, outputs);
        if of_agents {
            builder.enter(OWN);
            let before = builder.steps(&program.each);
            builder.open[1].level.before = before;
            outputs = find(&mut builder);
            agents = builder.leave();
        } else {
            outputs = find(&mut builder);
            agents = Level { number: usize::MAX, ..Level::default() };
        }
        let flock = builder.leave();
        Code { columns: builder.columns, flock, agents, outputs, levels: builder.levels }
    }

    /// Whether an agent's numbers need loops over others.
    pub fn looks_at_others(&self) -> bool {
        self.agents.before.iter().chain(&self.agents.after).any(|step| matches!(step, Step::Loop(_)))
    }
}

impl Builder<'_> {
    fn enter(&mut self, slot: Slot) {
        let level = Level { number: self.levels.len(), ..Level::default() };
        self.levels.push(0);
        self.open.push(Draft { slot, level, known: HashMap::new(), constants: HashMap::new() });
    }

    fn leave(&mut self) -> Level {
        let level = self.open.pop().map(|draft| draft.level).unwrap_or_default();
        if let Some(registers) = self.levels.get_mut(level.number) {
            *registers = level.registers;
        }
        level
    }

    /// A new register of the level that is `depth` levels inside of the flock.
    fn fresh(&mut self, depth: usize) -> Register {
        let level = &mut self.open[depth].level;
        level.registers += 1;
        level.registers - 1
    }

    fn constant(&mut self, x: f64) -> Register {
        let depth = self.open.len() - 1;
        if let Some(&register) = self.open[depth].constants.get(&x.to_bits()) {
            return register;
        }
        let register = self.fresh(depth);
        self.open[depth].constants.insert(x.to_bits(), register);
        self.open[depth].level.constants.push((register, x));
        register
    }

    /// The register that holds a thing on the innermost level.
    fn register(&mut self, id: Id) -> Register {
        match &self.program.ops[id] {
            Op::Number(q) => self.constant(q.to_f64().unwrap_or(f64::NAN)),
            Op::Pi => self.constant(std::f64::consts::PI),
            _ => {
                let depth = self.open.len() - 1;
                self.brought(id, depth)
            }
        }
    }

    fn brought(&mut self, id: Id, depth: usize) -> Register {
        if let Some(&register) = self.open[depth].known.get(&id) {
            return register;
        }
        if depth == 0 {
            // What nothing has computed has no value.
            let register = self.fresh(0);
            self.open[0].level.constants.push((register, f64::NAN));
            return register;
        }
        let load = Load::Outer(self.brought(id, depth - 1));
        self.loaded(id, depth, load)
    }

    fn loaded(&mut self, id: Id, depth: usize, load: Load) -> Register {
        let register = self.fresh(depth);
        self.open[depth].level.loads.push((register, load));
        self.open[depth].known.insert(id, register);
        register
    }

    fn column(&mut self, column: Column) -> usize {
        let known = self.columns.iter().position(|known| *known == column);
        known.unwrap_or_else(|| {
            self.columns.push(column);
            self.columns.len() - 1
        })
    }

    fn steps(&mut self, planned: &[Planned]) -> Vec<Step> {
        let mut steps = Vec::new();
        for step in planned {
            match step {
                Planned::Thing(id) => self.thing(*id, &mut steps),
                Planned::Loop(round) => {
                    let inner = self.inner(round);
                    steps.push(Step::Loop(Box::new(inner)));
                }
            }
        }
        steps
    }

    fn thing(&mut self, id: Id, steps: &mut Vec<Step>) {
        let depth = self.open.len() - 1;
        if self.open[depth].known.contains_key(&id) {
            return;
        }
        let of = |builder: &mut Self, column: Column, of: Of| {
            let column = builder.column(column);
            match of {
                Of::Slot(_) => Load::Each(column),
                Of::Agent(agent) => Load::One(column, agent),
            }
        };
        let load = match self.program.ops[id].clone() {
            Op::Number(_) | Op::Pi => return,
            Op::Time => Load::Time,
            Op::Parameter(list, agent) => of(self, Column::Parameter(list), agent),
            Op::State { start, stride, component, of: agent } => {
                of(self, Column::State { start, stride, component }, agent)
            }
            Op::Power(base, exponent) => {
                let base = self.register(base);
                let register = self.power(base, exponent, steps);
                self.open[depth].known.insert(id, register);
                return;
            }
            op => {
                let Some(instruction) = self.instruction(&op) else { return };
                let register = self.then(instruction, steps);
                self.open[depth].known.insert(id, register);
                return;
            }
        };
        self.loaded(id, depth, load);
    }

    /// One more instruction, and where its result goes.
    fn then(&mut self, instruction: Instruction, steps: &mut Vec<Step>) -> Register {
        let register = self.fresh(self.open.len() - 1);
        match steps.last_mut() {
            Some(Step::Straight(list)) => list.push((register, instruction)),
            _ => steps.push(Step::Straight(vec![(register, instruction)])),
        }
        register
    }

    fn instruction(&mut self, op: &Op) -> Option<Instruction> {
        let mut of = |id: &Id| self.register(*id);
        Some(match op {
            Op::Negated(a) => Instruction::Negated(of(a)),
            Op::Sum(a, b) => Instruction::Sum(of(a), of(b)),
            Op::Difference(a, b) => Instruction::Difference(of(a), of(b)),
            Op::Product(a, b) => Instruction::Product(of(a), of(b)),
            Op::Quotient(a, b) => Instruction::Quotient(of(a), of(b)),
            Op::Function(Function::Root, a) => Instruction::Root(of(a)),
            Op::Function(function, a) => Instruction::Of(*function, of(a)),
            Op::Angle(y, x) => Instruction::Angle(of(y), of(x)),
            Op::Absolute(a) => Instruction::Absolute(of(a)),
            Op::Larger(a, b) => Instruction::Larger(of(a), of(b)),
            Op::Smaller(a, b) => Instruction::Smaller(of(a), of(b)),
            Op::Choice(c, a, b) => Instruction::Choice(of(c), of(a), of(b)),
            Op::Compared(relation, a, b) => Instruction::Compared(*relation, of(a), of(b)),
            Op::Both(a, b) => Instruction::Both(of(a), of(b)),
            Op::Not(a) => Instruction::Not(of(a)),
            _ => return None,
        })
    }

    /// By squares and products.
    fn power(&mut self, base: Register, exponent: u32, steps: &mut Vec<Step>) -> Register {
        let digits = u32::BITS - exponent.leading_zeros();
        let mut product = if exponent == 0 { self.constant(1.0) } else { base };
        for digit in (0..digits.saturating_sub(1)).rev() {
            product = self.then(Instruction::Product(product, product), steps);
            if exponent >> digit & 1 == 1 {
                product = self.then(Instruction::Product(product, base), steps);
            }
        }
        product
    }

    fn inner(&mut self, round: &Round) -> Inner {
        let this = &self.program.loops[round.number];
        let heard = match self.program.slots[this.slot].hears {
            None => Heard::All,
            Some(Of::Agent(agent)) => Heard::Agent(agent),
            Some(Of::Slot(slot)) => {
                let draft = self.open.iter().rev().find(|draft| draft.slot == slot);
                draft.map_or(Heard::All, |draft| Heard::Of(draft.level.number))
            }
        };
        self.enter(this.slot);
        let depth = self.open.len() - 1;
        self.open[depth].level.before = self.steps(&round.before);
        self.open[depth].level.condition = this.condition.map(|id| self.register(id));
        self.open[depth].level.after = self.steps(&round.after);
        let gathered = |builder: &mut Self, place: usize| {
            let (gather, body) = this.bodies[place];
            (gather, builder.register(body))
        };
        let bodies: Vec<_> = round.results.iter().map(|&(place, id)| (id, gathered(self, place))).collect();
        let level = self.leave();
        let results = bodies.into_iter().map(|(id, (gather, body))| {
            let to = self.fresh(depth - 1);
            self.open[depth - 1].known.insert(id, to);
            (gather, Body::Own(body), to)
        });
        let mut inner = Inner { heard, results: results.collect(), level };
        fuse::inside(&mut inner);
        inner
    }
}
