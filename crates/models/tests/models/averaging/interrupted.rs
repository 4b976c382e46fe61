//! Work that is stopped on its way, at every place where it asks.

use super::flock::starts;
use algebra::matrix::MatrixError;
use arithmetic::{Cancelled, Progress};
use models::averaging::settle::{Ending, Limits, settle};
use models::averaging::{
    Flock, Hysteresis, Start, Switch, Weights, contraction_watched, deviation_matrix_watched, stationary_distribution,
    transition_matrix,
};
use proptest::prelude::*;
use std::sync::atomic::{AtomicU64, Ordering};

/// Stops after being asked so many times.
struct Asked {
    most: u64,
    asked: AtomicU64,
}

impl Asked {
    fn at_most(most: u64) -> Self {
        Asked { most, asked: AtomicU64::new(0) }
    }

    fn count(&self) -> u64 {
        self.asked.load(Ordering::Relaxed)
    }
}

impl Progress for Asked {
    fn is_cancelled(&self) -> bool {
        self.asked.fetch_add(1, Ordering::Relaxed) >= self.most
    }
}

fn settled(start: &Start, progress: &Asked) -> (Vec<Switch>, Ending) {
    let mut switches = Vec::new();
    let limits = Limits { switches: 20, steps: 500, ..Limits::default() };
    let settled = settle(Flock::new(start).unwrap(), &limits, &mut |switch| switches.push(switch.clone()), progress);
    (switches, settled.unwrap().ending)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    /// Wherever it is stopped, the switches are the first of all, and nobody asks again after a stop.
    #[test]
    fn a_stopped_decision_keeps_its_switches(start in starts(), parts in 1u64..40) {
        let whole = Asked::at_most(u64::MAX);
        let (all, _) = settled(&start, &whole);
        let most = whole.count() * parts / 40;
        let stopped = Asked::at_most(most);
        let (some, ending) = settled(&start, &stopped);
        prop_assert!(matches!(ending, Ending::Interrupted), "{:?}", ending);
        prop_assert_eq!(&some[..], &all[..some.len()]);
        prop_assert_eq!(stopped.count(), most + 1);
    }
}

#[test]
fn exact_linear_algebra_asks() {
    let graph = algebra::graph::Graph::path(12);
    let transition = transition_matrix(&graph, &Weights::Lazy).unwrap();
    let pi = stationary_distribution(&graph, &Weights::Lazy).unwrap();
    for most in [0, 1, 60] {
        let stopped = Err(MatrixError::Cancelled(Cancelled));
        assert_eq!(deviation_matrix_watched(&transition, &pi, &Asked::at_most(most)), stopped);
        let contraction = contraction_watched(&transition, &Asked::at_most(most.min(1)));
        assert_eq!(contraction, Err(MatrixError::Cancelled(Cancelled)));
    }
    let start = Start::on_the_line(
        vec![arithmetic::rational(0, 1)],
        vec![arithmetic::rational(1, 1)],
        Weights::Lazy,
        Hysteresis::None,
    );
    assert!(matches!(settled(&start, &Asked::at_most(0)).1, Ending::Interrupted));
}

/// Four birds that alternate until a fifth comes back: stopped while they go round, the network is that after the last switch that was found.
#[test]
fn a_cycle_that_is_gone_round_can_be_stopped() {
    let number = |p: i64, q: i64| arithmetic::rational(p, q);
    let x = [0, 8, 21, 29, 160].map(|p| number(p, 16)).to_vec();
    let v = [number(1, 8), number(-1, 8), number(1, 8), number(-1, 8), number(-1, 1000)].to_vec();
    let start = Start::on_the_line(x, v, Weights::Lazy, Hysteresis::None);
    let initial = Flock::new(&start).unwrap().network().clone();
    let mut found_by = Vec::new();
    for most in [6000, 6001] {
        let (mut network, mut count) = (initial.clone(), 0);
        let mut found = |switch: &Switch| {
            switch.apply_to(&mut network);
            count += 1;
        };
        let flock = Flock::new(&start).unwrap();
        let settled = settle(flock, &Limits::default(), &mut found, &Asked::at_most(most)).unwrap();
        assert!(matches!(settled.ending, Ending::Interrupted));
        assert_eq!((settled.network, settled.last_switch), (network, count.into()));
        found_by.push(count);
    }
    // One step more between two questions: they were stopped while they went round.
    assert_eq!(found_by[1], found_by[0] + 1);
}
