//! A law of one's own in continuous time.

use super::headings::Headings;
use super::measured::{Heard, frame, in_words, observe};
use super::read::Described;
use crate::error::Problem;
use crate::error::RunError;
use crate::links::Guard;
use crate::network::{Change, Network, Rule};
use crate::observables::Observable;
use crate::simulation::{Frame, Law};
use crate::stepped::Stepped;
use arithmetic::ArithmeticError;
use expressions::{Blocks, Fault, Hearing};
use motion::{FollowError, IntegrationError, NearLists};
use std::cell::RefCell;
use std::sync::Arc;

/// The law with its network.
pub(super) struct Moving {
    law: Arc<expressions::Law>,
    network: Network,
    rates: RefCell<Blocks>,
    headings: Headings,
    observed: RefCell<Blocks>,
    declaration: Vec<String>,
    /// What had no value last.
    fault: RefCell<Option<Fault>>,
}

impl Moving {
    pub fn new(own: Described) -> Self {
        let complete = own.network.is_all_to_all();
        let (rates, observed) = (Blocks::rates(&own.law, complete), Blocks::observables(&own.law, complete));
        Moving {
            headings: Headings::default(),
            rates: RefCell::new(rates),
            observed: RefCell::new(observed),
            law: own.law,
            network: own.network,
            declaration: own.declaration,
            fault: RefCell::new(None),
        }
    }

    /// The law and its network.
    pub fn parts(&self) -> (&expressions::Law, &Network) {
        (&self.law, &self.network)
    }

    /// Makes the links of the start, and looks whether the law has a value there.
    pub fn start(&mut self, state: &[f64]) -> Result<(), Problem> {
        self.settle(state);
        let mut rates = vec![0.0; state.len()];
        self.written(0.0, state, &mut rates).map_err(|fault| Problem::Start(in_words(&self.law, &fault)))
    }

    fn written(&self, time: f64, state: &[f64], rates: &mut [f64]) -> Result<(), Fault> {
        self.written_as_heard(time, state, &Heard(&self.network), rates)
    }

    fn written_as_heard(
        &self,
        time: f64,
        state: &[f64],
        hearing: &dyn Hearing,
        rates: &mut [f64],
    ) -> Result<(), Fault> {
        self.rates.borrow_mut().write_rates(&self.law, (time, state), hearing, rates)
    }

    /// With headings that are held from a state on, and jumps that are located; otherwise steps go over them.
    pub fn located(mut self, state: &[f64]) -> Self {
        let mut rates = Blocks::held_rates(&self.law, self.network.is_all_to_all());
        self.headings = Headings::of(&rates, self.law.agents());
        self.headings.settle(state, &mut rates);
        self.rates = RefCell::new(rates);
        self
    }

    /// In fixed steps, each stage with the links of its positions.
    pub fn stepped(self, state: Vec<f64>, step: f64) -> Stepped<Self> {
        let Rule::Within(radius) = self.network.rule() else { return Stepped::settled(self, state, step) };
        let rate = move |law: &mut Self, time: f64, state: &[f64], rates: &mut [f64]| {
            let points = law.network.points(state);
            let mut near =
                NearLists::new(&points, radius).map_err(|_| FollowError::from(IntegrationError::Stuck(time)))?;
            if !law.network.is_planar() {
                near.retain(|i, j| law.network.squared(state, (i, j)) <= radius * radius);
            }
            let written = law.written_as_heard(time, state, &Near(&near), rates);
            law.kept(written).map_err(|error| RunError::law(time, error))
        };
        Stepped::new(self, state, step, Box::new(rate))
    }

    fn kept<T>(&self, result: Result<T, Fault>) -> Result<T, ArithmeticError> {
        result.map_err(|fault| {
            let error = fault.error.clone();
            self.fault.replace(Some(fault));
            error
        })
    }
}

/// Neighbours within a radius as the law hears them.
struct Near<'a>(&'a NearLists);

impl Hearing for Near<'_> {
    fn agents(&self) -> usize {
        self.0.points()
    }

    fn heard(&self, agent: usize) -> Option<&[usize]> {
        Some(self.0.of(agent))
    }
}

impl Law for Moving {
    fn rate(&self, time: f64, state: &[f64], rates: &mut [f64]) -> Result<(), ArithmeticError> {
        self.kept(self.written(time, state, rates))
    }

    fn switches(&self) -> bool {
        !self.headings.is_empty() || self.network.switches()
    }

    fn guards(&self, state: &[f64], moved: &[f64]) -> Vec<Guard> {
        let mut guards = self.network.guards(state, moved);
        guards.extend(self.headings.guards(state, moved));
        guards
    }

    fn switch(&mut self, state: &[f64]) -> Vec<Change> {
        self.headings.go_on(state, self.rates.get_mut());
        self.network.switch(state)
    }

    fn next_time(&self) -> Option<f64> {
        self.network.next_time()
    }

    fn replace(&mut self, _: &[f64]) -> Vec<Change> {
        self.network.replace()
    }

    fn settle(&mut self, state: &[f64]) {
        if !self.network.switches() {
            return;
        }
        let mut rates = vec![0.0; state.len()];
        // Where the law has no value yet, agents at exactly the radius count as resting.
        if self.written(0.0, state, &mut rates).is_err() {
            rates.fill(0.0);
        }
        self.network.settle(state, &rates);
        if let Rule::Within(radius) = self.network.rule() {
            let resting = self.network.resting_at(state, &rates, radius);
            let pairs = self.network.pairs().iter().copied().chain(resting).collect();
            self.network.set_pairs(pairs);
        }
    }

    fn frame(&self, _: f64, state: &[f64]) -> Frame {
        frame(&self.law, state)
    }

    fn links(&self) -> Vec<(usize, usize)> {
        // Pictures of everybody with everybody say nothing.
        if self.network.is_all_to_all() { Vec::new() } else { self.network.links() }
    }

    fn observe(&self, time: f64, state: &[f64]) -> Result<Vec<Observable>, ArithmeticError> {
        self.kept(observe(&self.law, &self.network, (&mut self.observed.borrow_mut(), time), state))
    }

    fn declaration(&self) -> Vec<String> {
        let jumps = "headings are in (-pi, pi]; where one passes pi it jumps, which is located";
        let jumps = (!self.headings.is_empty()).then(|| jumps.to_string());
        self.declaration.iter().cloned().chain(jumps).collect()
    }

    fn remarks(&self) -> Vec<String> {
        let fault = self.fault.borrow();
        fault.iter().map(|fault| format!("a number had no value: {}", in_words(&self.law, fault))).collect()
    }
}
