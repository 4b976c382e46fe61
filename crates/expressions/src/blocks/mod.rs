//! Programs over floats, many lanes at a time: agents, pairs of them and what else a law loops over stand side by side in blocks, and every operation is
//! done for a whole block. What is written once for one agent so runs at the pace of vectors. [`crate::Evaluator`] computes the same one number
//! after the other over any scalar; it is the reference, and it tells why a number has no value.
//!
//! As little as possible is done for each pair: sums of sines over everybody are sums over the flock (`separate.rs`), and what depends on one agent alone is computed ahead (`ahead.rs`).
//!
//! Results depend neither on the number of threads nor on the processor: which lanes stand in a block depends on the network only.

mod ahead;
mod code;
mod fuse;
mod held;
mod lanes;
mod part;
mod run;
mod separate;

use crate::evaluate::{Evaluator, Fault, Hearing};
use crate::law::Law;
use crate::program::Program;
pub use held::Heading;
use part::Part;

/// A program for blocks with its working space; used again and again, it allocates little.
#[derive(Debug)]
pub struct Blocks {
    /// What is computed ahead, for each agent.
    first: Option<Part>,
    rest: Part,
    /// The numbers of the first part, and those of the rest.
    ahead: Vec<f64>,
    outputs: Vec<f64>,
    /// Lists of the law; behind them are those of directions that are held, and then what is computed ahead.
    lists: usize,
    headings: Vec<Heading>,
    /// What computes single numbers, where one has no value.
    slow: Evaluator<f64>,
}

impl Blocks {
    /// For the rates of a law; `complete` promises that everybody hears all others.
    pub fn rates(law: &Law, complete: bool) -> Self {
        Blocks::new(&law.rates, law, law.evaluator(&0.0), (true, complete))
    }

    /// For the observables of a law; `complete` promises that everybody hears all others.
    pub fn observables(law: &Law, complete: bool) -> Self {
        Blocks::new(&law.observed, law, law.observing(&0.0), (false, complete))
    }

    /// The same rates with headings that go on smoothly from directions that are held ([`Self::hold`]), which have to be set first.
    pub fn held_rates(law: &Law, complete: bool) -> Self {
        let (program, headings) = held::held(&law.rates, law.lists.len());
        let lists = law.lists.len() + held::LISTS * headings.len();
        Blocks { headings, ..Blocks::of(&program, law, law.evaluator(&0.0), (true, complete, lists)) }
    }

    fn new(program: &Program, law: &Law, slow: Evaluator<f64>, (of_agents, complete): (bool, bool)) -> Self {
        Blocks::of(program, law, slow, (of_agents, complete, law.lists.len()))
    }

    /// `behind`: so many lists are known before anything is computed ahead.
    fn of(
        program: &Program,
        law: &Law,
        slow: Evaluator<f64>,
        (of_agents, complete, behind): (bool, bool, usize),
    ) -> Self {
        let divided = ahead::divided(&separate::separated(program, complete), behind);
        let first = divided.first.map(|program| Part::new(&program, law, true));
        let rest = Part::new(&divided.rest, law, of_agents);
        let (ahead, outputs, headings) = (Vec::new(), Vec::new(), Vec::new());
        Blocks { first, rest, ahead, outputs, lists: law.lists.len(), headings, slow }
    }

    /// The headings that are held.
    pub fn headings(&self) -> &[Heading] {
        &self.headings
    }

    /// Holds directions in radians: of each heading one for each agent.
    pub fn hold(&mut self, directions: &[Vec<f64>]) {
        for part in self.first.iter_mut().chain([&mut self.rest]) {
            part.set_parameters(|list, numbers| {
                let Some(k) = list.checked_sub(self.lists) else { return };
                let Some(held) = directions.get(k / held::LISTS) else { return };
                let of = [|b: f64| b, f64::cos, f64::sin][k % held::LISTS];
                numbers.iter_mut().zip(held).for_each(|(to, b)| *to = of(*b));
            });
        }
    }

    /// Sets the numbers that were drawn for this step: of each list one for each agent.
    pub fn set_drawn(&mut self, drawn: &[Vec<f64>]) {
        self.slow.set_drawn(drawn);
        let begin = self.lists - drawn.len().min(self.lists);
        for part in self.first.iter_mut().chain([&mut self.rest]) {
            part.set_parameters(|list, numbers| {
                if let Some(drawn) = list.checked_sub(begin).and_then(|k| drawn.get(k)) {
                    numbers.clone_from(drawn);
                }
            });
        }
    }

    fn look_ahead(&mut self, time: f64, state: &[f64], hearing: &dyn Hearing) {
        let Some(first) = &mut self.first else { return };
        first.agents(time, state, hearing, &mut self.ahead);
        let (width, lists) = (first.width(), self.lists + held::LISTS * self.headings.len());
        self.rest.set_parameters(|list, numbers| {
            if let Some(k) = list.checked_sub(lists) {
                numbers.iter_mut().zip(self.ahead.chunks_exact(width)).for_each(|(to, row)| *to = row[k]);
            }
        });
    }

    /// Writes the rates, or the next state, of a state.
    ///
    /// # Errors
    /// [`Fault`] where a number has no value.
    pub fn write_rates(
        &mut self,
        law: &Law,
        (time, state): (f64, &[f64]),
        hearing: &dyn Hearing,
        rates: &mut [f64],
    ) -> Result<(), Fault> {
        self.look_ahead(time, state, hearing);
        self.rest.agents(time, state, hearing, &mut self.outputs);
        let rows = || self.outputs.chunks_exact(law.targets.len().max(1)).enumerate();
        for (agent, row) in rows() {
            row.iter().enumerate().for_each(|(output, x)| law.put(agent, output, *x, rates));
        }
        let missing = |row: &[f64]| row.iter().any(|x| x.is_nan());
        let open: Vec<usize> = rows().filter(|(_, row)| missing(row)).map(|(agent, _)| agent).collect();
        if open.is_empty() {
            return Ok(());
        }
        // The slow way decides what is missing and why, with headings in `(-pi, pi]`.
        law.write_rates_of(open.into_iter(), &mut self.slow, (&time, state), hearing, rates)
    }

    /// The numbers of all observables, in their order.
    ///
    /// # Errors
    /// [`Fault`] where a number has no value.
    pub fn observe(&mut self, time: f64, state: &[f64], hearing: &dyn Hearing) -> Result<Vec<f64>, Fault> {
        self.look_ahead(time, state, hearing);
        let found = self.rest.flock(time, state, hearing);
        if found.iter().any(|x| x.is_nan()) { self.slow.flock(&time, state, hearing) } else { Ok(found) }
    }
}
