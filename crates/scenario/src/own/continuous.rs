//! A law of one's own in continuous time.

use super::measured::{Heard, frame, in_words, observe};
use super::read::Described;
use crate::error::Problem;
use crate::links::Guard;
use crate::network::{Change, Network, Rule};
use crate::observables::Observable;
use crate::simulation::{Frame, Law};
use arithmetic::ArithmeticError;
use expressions::{Evaluator, Fault};
use std::cell::RefCell;
use std::sync::Arc;

/// The law with its network.
pub(super) struct Moving {
    law: Arc<expressions::Law>,
    network: Network,
    rates: RefCell<Evaluator<f64>>,
    observed: RefCell<Evaluator<f64>>,
    declaration: Vec<String>,
    /// What had no value last.
    fault: RefCell<Option<Fault>>,
}

impl Moving {
    pub fn new(own: Described) -> Self {
        let (rates, observed) = (own.law.evaluator(&0.0), own.law.observing(&0.0));
        Moving {
            rates: RefCell::new(rates),
            observed: RefCell::new(observed),
            law: own.law,
            network: own.network,
            declaration: own.declaration,
            fault: RefCell::new(None),
        }
    }

    /// Makes the links of the start, and looks whether the law has a value there.
    pub fn start(&mut self, state: &[f64]) -> Result<(), Problem> {
        self.settle(state);
        let mut rates = vec![0.0; state.len()];
        self.written(0.0, state, &mut rates).map_err(|fault| Problem::Start(in_words(&self.law, &fault)))
    }

    fn written(&self, time: f64, state: &[f64], rates: &mut [f64]) -> Result<(), Fault> {
        rates.fill(0.0);
        self.law.write_rates(&mut self.rates.borrow_mut(), (&time, state), &Heard(&self.network), rates)
    }

    fn kept<T>(&self, result: Result<T, Fault>) -> Result<T, ArithmeticError> {
        result.map_err(|fault| {
            let error = fault.error.clone();
            self.fault.replace(Some(fault));
            error
        })
    }
}

impl Law for Moving {
    fn rate(&self, time: f64, state: &[f64], rates: &mut [f64]) -> Result<(), ArithmeticError> {
        self.kept(self.written(time, state, rates))
    }

    fn switches(&self) -> bool {
        self.network.switches()
    }

    fn guards(&self, state: &[f64], moved: &[f64]) -> Vec<Guard> {
        self.network.guards(state, moved)
    }

    fn switch(&mut self, state: &[f64]) -> Vec<Change> {
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
        self.declaration.clone()
    }

    fn remarks(&self) -> Vec<String> {
        let fault = self.fault.borrow();
        fault.iter().map(|fault| format!("a number had no value: {}", in_words(&self.law, fault))).collect()
    }
}
