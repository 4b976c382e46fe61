//! Levels run over blocks of lanes: the flock, agents, those whom they hear, those whom these hear, ..

use super::code::{Code, Heard, Inner, Level, Load, Step};
use super::lanes::{BLOCK, Registers, Straight, Sums, View};
use crate::evaluate::Hearing;
use crate::program::Gather;

/// Neighbours from which on the lanes of a block are those of one agent: what is its own is then the same in all of them.
const MANY: usize = 48;

/// Who the agents of the lanes are.
#[derive(Debug, Clone)]
enum Agents {
    /// From one on, in order.
    From(usize),
    Listed(Vec<usize>),
}

/// The lanes of a level: blocks are filled with them in turn.
#[derive(Debug, Clone)]
struct Frame {
    registers: Registers,
    lanes: usize,
    agents: Agents,
    /// Whose lanes they are: lanes of the level around this one, each with where its lanes begin and end.
    parts: Vec<(usize, usize, usize)>,
    /// The level around this one.
    outer: usize,
    /// Of the loop that this level is: how many lanes each lane around it has had.
    counts: Vec<f64>,
}

/// What is the same for all blocks.
pub(super) struct Moment<'a> {
    pub arch: pulp::Arch,
    pub time: f64,
    pub columns: &'a [Vec<f64>],
    pub hearing: &'a dyn Hearing,
}

/// Working space: the lanes of every level.
#[derive(Debug, Clone)]
pub(super) struct Space {
    frames: Vec<Frame>,
}

impl Space {
    pub fn new(code: &Code) -> Self {
        let frame = |&registers: &usize| Frame {
            registers: Registers::new(registers),
            lanes: 1,
            agents: Agents::From(0),
            parts: Vec::new(),
            outer: 0,
            counts: Vec::new(),
        };
        let mut space = Space { frames: code.levels.iter().map(frame).collect() };
        space.fill_constants(&code.flock);
        if code.agents.number < space.frames.len() {
            space.fill_constants(&code.agents);
        }
        space
    }

    fn fill_constants(&mut self, level: &Level) {
        for &(register, x) in &level.constants {
            self.frames[level.number].registers.set_same(register, x);
        }
        for step in level.before.iter().chain(&level.after) {
            if let Step::Loop(inner) = step {
                self.frames[inner.level.number].outer = level.number;
                self.fill_constants(&inner.level);
            }
        }
    }

    /// Runs the level of the flock.
    pub fn flock(&mut self, code: &Code, moment: &Moment) {
        self.run(&code.flock, moment);
    }

    /// The registers of the flock as another space has them.
    pub fn take_flock(&mut self, code: &Code, from: &[f64]) {
        let registers = &mut self.frames[code.flock.number].registers;
        from.iter().enumerate().for_each(|(register, x)| registers.set_same(register, *x));
    }

    /// All registers of the flock.
    pub fn flock_numbers(&self, code: &Code, moment: &Moment) -> Vec<f64> {
        (0..code.flock.registers).map(|register| self.number(code.flock.number, register, moment)).collect()
    }

    fn number(&self, level: usize, register: usize, moment: &Moment) -> f64 {
        let frame = &self.frames[level];
        frame.registers.view(register, frame.lanes, moment.columns).at(0)
    }

    /// Runs the level of the agents for some of them, at most a block, and writes their outputs, agent by agent.
    pub fn agents(&mut self, code: &Code, moment: &Moment, from: usize, outputs: &mut [f64]) {
        let (level, width) = (code.agents.number, code.outputs.len().max(1));
        let frame = &mut self.frames[level];
        let count = outputs.len() / width;
        frame.lanes = count;
        frame.agents = Agents::From(from);
        frame.parts.clear();
        frame.parts.push((0, 0, count));
        self.run(&code.agents, moment);
        let frame = &self.frames[level];
        for (k, &register) in code.outputs.iter().enumerate() {
            let view = frame.registers.view(register, count, moment.columns);
            outputs.chunks_exact_mut(width).enumerate().for_each(|(agent, row)| row[k] = view.at(agent));
        }
    }

    fn run(&mut self, level: &Level, moment: &Moment) {
        self.load(level, moment);
        self.steps(&level.before, level, moment);
        self.steps(&level.after, level, moment);
    }

    fn steps(&mut self, steps: &[Step], level: &Level, moment: &Moment) {
        for step in steps {
            match step {
                Step::Straight(instructions) => {
                    let Frame { registers, lanes, .. } = &mut self.frames[level.number];
                    moment.arch.dispatch(Straight { instructions, registers, lanes: *lanes, columns: moment.columns });
                }
                Step::Loop(inner) => self.gather(inner, level, moment),
            }
        }
    }

    fn load(&mut self, level: &Level, moment: &Moment) {
        let (outside, inside) = self.frames.split_at_mut(level.number);
        let frame = &mut inside[0];
        for &(register, load) in &level.loads {
            let (lanes, registers) = (frame.lanes, &mut frame.registers);
            match load {
                Load::Time => registers.set_same(register, moment.time),
                Load::One(column, agent) => registers.set_same(register, moment.columns[column][agent]),
                Load::Each(column) => match &frame.agents {
                    Agents::From(from) => registers.set_column(register, column, *from),
                    Agents::Listed(list) => {
                        let column = &moment.columns[column][..];
                        registers.own(register, lanes).iter_mut().zip(list).for_each(|(x, agent)| *x = column[*agent]);
                    }
                },
                Load::Outer(from) => {
                    let outer = &outside[frame.outer];
                    let view = outer.registers.view(from, outer.lanes, moment.columns);
                    match (&frame.parts[..], view) {
                        (_, View::Same(x)) => registers.set_same(register, x),
                        (&[(lane, ..)], view) => registers.set_same(register, view.at(lane)),
                        (parts, view) => {
                            let to = registers.own(register, lanes);
                            parts.iter().for_each(|&(lane, begin, end)| to[begin..end].fill(view.at(lane)));
                        }
                    }
                }
            }
        }
    }

    /// The agent of a lane's level or of one around it.
    fn agent_of(&self, mut level: usize, mut lane: usize, wanted: usize) -> usize {
        while level != wanted {
            let frame = &self.frames[level];
            let part = frame.parts.partition_point(|(_, _, end)| *end <= lane);
            lane = frame.parts.get(part).map_or(0, |(outer, ..)| *outer);
            level = frame.outer;
        }
        match &self.frames[level].agents {
            Agents::From(from) => from + lane,
            Agents::Listed(list) => list[lane],
        }
    }

    /// Runs a loop for all lanes of a level.
    fn gather(&mut self, inner: &Inner, level: &Level, moment: &Moment) {
        let (outer, own) = (level.number, inner.level.number);
        let lanes = self.frames[outer].lanes;
        for &(gather, _, to) in &inner.results {
            let first = match gather {
                Gather::Largest => f64::NEG_INFINITY,
                Gather::Smallest => f64::INFINITY,
                _ => 0.0,
            };
            self.frames[outer].registers.own(to, lanes).fill(first);
        }
        let frame = &mut self.frames[own];
        frame.counts.clear();
        frame.counts.resize(lanes, 0.0);
        self.begin(own);
        let agents = moment.hearing.agents();
        for lane in 0..lanes {
            let hears = match inner.heard {
                Heard::All => None,
                Heard::Agent(agent) => Some(agent),
                Heard::Of(wanted) => Some(self.agent_of(outer, lane, wanted)),
            };
            match hears.and_then(|agent| moment.hearing.heard(agent)) {
                Some(list) => self.listed(inner, moment, lane, list),
                None => {
                    let own = hears.unwrap_or(agents);
                    self.stretch(inner, moment, lane, (0, own));
                    self.stretch(inner, moment, lane, (own + 1, agents));
                }
            }
        }
        self.finish_block(inner, moment);
        self.close(inner, outer);
    }

    fn begin(&mut self, own: usize) {
        let frame = &mut self.frames[own];
        frame.lanes = 0;
        frame.parts.clear();
        match &mut frame.agents {
            Agents::Listed(list) => list.clear(),
            other => *other = Agents::Listed(Vec::with_capacity(BLOCK)),
        }
    }

    /// Lanes of a list of agents: a few share a block with those of other lanes, many have blocks of their own.
    fn listed(&mut self, inner: &Inner, moment: &Moment, lane: usize, list: &[usize]) {
        if list.len() >= MANY {
            self.finish_block(inner, moment);
            for piece in list.chunks(BLOCK) {
                self.add(inner, lane, piece.iter().copied());
                self.finish_block(inner, moment);
            }
        } else if !list.is_empty() {
            if self.frames[inner.level.number].lanes + list.len() > BLOCK {
                self.finish_block(inner, moment);
            }
            self.add(inner, lane, list.iter().copied());
        }
    }

    /// Lanes of agents from one up to another.
    fn stretch(&mut self, inner: &Inner, moment: &Moment, lane: usize, (mut from, to): (usize, usize)) {
        let count = to.saturating_sub(from);
        let own = inner.level.number;
        if count >= MANY {
            self.finish_block(inner, moment);
            while from < to {
                let lanes = (to - from).min(BLOCK);
                let frame = &mut self.frames[own];
                frame.lanes = lanes;
                frame.parts.push((lane, 0, lanes));
                let list = std::mem::replace(&mut frame.agents, Agents::From(from));
                self.block(inner, moment);
                self.frames[own].agents = list;
                self.begin(own);
                from += lanes;
            }
        } else if count > 0 {
            if self.frames[own].lanes + count > BLOCK {
                self.finish_block(inner, moment);
            }
            self.add(inner, lane, from..to);
        }
    }

    fn add(&mut self, inner: &Inner, lane: usize, agents: impl Iterator<Item = usize>) {
        let frame = &mut self.frames[inner.level.number];
        if let Agents::Listed(list) = &mut frame.agents {
            let begin = list.len();
            list.extend(agents);
            frame.parts.push((lane, begin, list.len()));
            frame.lanes = list.len();
        }
    }

    fn finish_block(&mut self, inner: &Inner, moment: &Moment) {
        let own = inner.level.number;
        if self.frames[own].lanes > 0 {
            self.block(inner, moment);
            self.begin(own);
        }
    }

    /// Computes a block and adds it to what has been gathered.
    fn block(&mut self, inner: &Inner, moment: &Moment) {
        let level = &inner.level;
        self.load(level, moment);
        self.steps(&level.before, level, moment);
        if let Some(condition) = level.condition {
            let frame = &self.frames[level.number];
            let view = frame.registers.view(condition, frame.lanes, moment.columns);
            if (0..frame.lanes).all(|lane| view.at(lane) == 0.0) {
                return;
            }
        }
        self.steps(&level.after, level, moment);
        let (outside, inside) = self.frames.split_at_mut(level.number);
        let frame = &mut inside[0];
        let outer = &mut outside[frame.outer];
        let condition = level.condition.map(|register| frame.registers.view(register, frame.lanes, moment.columns));
        for &(lane, begin, end) in &frame.parts {
            match condition {
                None => frame.counts[lane] += (end - begin) as f64,
                // Not a number where one of the conditions has no value.
                Some(condition) => frame.counts[lane] += (begin..end).map(|k| condition.at(k)).sum::<f64>(),
            }
        }
        let outer_lanes = outer.lanes;
        let mut chosen = Vec::new();
        for &(gather, body, to) in &inner.results {
            let lanes = frame.registers.lanes(body, frame.lanes, moment.columns);
            let results = outer.registers.own(to, outer_lanes);
            if matches!(gather, Gather::Sum | Gather::Mean | Gather::Count) {
                moment.arch.dispatch(Sums { lanes, condition, parts: &frame.parts, results });
                continue;
            }
            for &(lane, begin, end) in &frame.parts {
                chosen.clear();
                let counts = |k: &usize| condition.is_none_or(|condition| condition.at(*k) != 0.0);
                chosen.extend((begin..end).filter(counts).map(|k| lanes.at(k)));
                join(gather, &mut results[lane], &chosen);
            }
        }
    }

    /// Means from sums; nobody has no largest value, and a count without a value is none.
    fn close(&mut self, inner: &Inner, outer: usize) {
        let (outside, inside) = self.frames.split_at_mut(inner.level.number);
        let (outer, counts) = (&mut outside[outer], &inside[0].counts);
        let lanes = outer.lanes;
        for &(gather, _, to) in &inner.results {
            for (result, count) in outer.registers.own(to, lanes).iter_mut().zip(counts) {
                *result = match gather {
                    _ if count.is_nan() => f64::NAN,
                    Gather::Mean if *count > 0.0 => *result * (1.0 / count),
                    Gather::Largest | Gather::Smallest if *count == 0.0 => f64::NAN,
                    _ => *result,
                };
            }
        }
    }
}

/// The largest or the smallest so far.
fn join(gather: Gather, result: &mut f64, lanes: &[f64]) {
    for &x in lanes {
        let better = if gather == Gather::Largest { x > *result } else { x < *result };
        if better || x.is_nan() {
            *result = x;
        }
    }
}
