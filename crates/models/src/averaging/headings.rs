//! The headings of model K, exact: numerators over one common denominator, and the way they went so far.

use super::kinematic_start::KinematicStart;
use super::rule::Rule;
use super::weights::{FlockError, Weights};
use algebra::graph::Graph;
use algebra::matrix::IntegerRows;
use arithmetic::{Dyadic, Field, Interval, Rational, common_denominator, lcm};
use num_bigint::BigInt;
use num_traits::Zero;
use std::collections::BTreeMap;

/// `theta(t)` in radians.
#[derive(Debug, Clone)]
pub(super) struct Headings {
    numerators: IntegerRows,
    denominator: BigInt,
    scratch: IntegerRows,
}

impl Headings {
    pub fn new(headings: &[Rational]) -> Self {
        let denominator = common_denominator(headings);
        let over = |x: &Rational| x.numer() * (&denominator / x.denom());
        let numerators = IntegerRows::new(&headings.iter().map(over).collect::<Vec<_>>());
        Headings { scratch: numerators.clone(), numerators, denominator }
    }

    pub fn value(&self, i: usize) -> Rational {
        Rational::new(self.numerators.value(i), self.denominator.clone())
    }

    /// Bits of the common denominator, not reduced.
    pub fn denominator_bits(&self) -> u64 {
        self.denominator.bits()
    }

    pub fn are_equal(&self, i: usize, j: usize) -> bool {
        self.numerators.difference(i, j).is_zero()
    }

    /// Encloses `theta_i`.
    pub fn enclosure(&self, i: usize, precision: u32) -> Interval {
        self.over_denominator(self.numerators.value(i), precision)
    }

    /// Encloses `(theta_i - theta_j)/2` and `(theta_i + theta_j)/2`, both with small relative width.
    pub fn half_difference_and_mean(&self, i: usize, j: usize, precision: u32) -> (Interval, Interval) {
        let (difference, sum) = (self.numerators.difference(i, j), self.numerators.value(i) + self.numerators.value(j));
        let half = |x: BigInt| self.over_denominator(x, precision).scaled(-1);
        (half(difference), half(sum))
    }

    fn over_denominator(&self, numerator: BigInt, precision: u32) -> Interval {
        let exactly = |n: BigInt| {
            let n = Dyadic::new(n, 0);
            Interval::between(n.clone(), n, precision)
        };
        let numerator = exactly(numerator);
        // The denominator is positive, so there is a quotient.
        numerator.over(&exactly(self.denominator.clone())).unwrap_or(numerator)
    }

    /// `theta = P theta`.
    fn average(&mut self, rule: &Rule) {
        self.scratch.average(&mut self.numerators, &rule.rows);
        std::mem::swap(&mut self.scratch, &mut self.numerators);
        self.denominator *= &rule.multiplier;
    }

    /// `theta = theta + kappa`.
    fn add(&mut self, kappa: &[Rational]) {
        let denominator = lcm(&self.denominator, &common_denominator(kappa));
        let factor = &denominator / &self.denominator;
        let sum =
            |(i, k): (usize, &Rational)| self.numerators.value(i) * &factor + k.numer() * (&denominator / k.denom());
        self.numerators = IntegerRows::new(&kappa.iter().enumerate().map(sum).collect::<Vec<_>>());
        self.denominator = denominator;
    }
}

/// What it takes to go the same way again: the start, and every change of the network and of the control.
#[derive(Debug, Clone)]
pub(super) struct History {
    pub start: KinematicStart,
    /// `(t, G_t)` where `G_t` is not `G_(t-1)`.
    networks: Vec<(u64, Graph)>,
    /// `(t, kappa(t))` where it is not `kappa(t-1)`; empty for none.
    controls: Vec<(u64, Vec<Rational>)>,
}

impl History {
    pub fn new(start: KinematicStart, network: Graph) -> Self {
        History { start, networks: vec![(0, network)], controls: vec![(0, Vec::new())] }
    }

    pub fn network(&self) -> &Graph {
        &self.networks[self.networks.len() - 1].1
    }

    pub fn switch_to(&mut self, time: u64, network: Graph) {
        self.networks.push((time, network));
    }

    /// Notes the control of time `t`; `None` for none.
    pub fn note_control(&mut self, time: u64, kappa: Option<Vec<Rational>>) {
        let kappa = kappa.filter(|kappa| !kappa.iter().all(Zero::is_zero)).unwrap_or_default();
        if self.controls.last().is_none_or(|(_, last)| *last != kappa) {
            self.controls.push((time, kappa));
        }
    }

    /// The headings one step on: `kappa(t) + P(t) theta(t)` with the network and the control noted last.
    pub fn turn(&self, headings: &mut Headings, rule: &Rule) {
        turn(headings, rule, &self.controls[self.controls.len() - 1].1);
    }

    /// Calls `visit` with `theta(1), .., theta(until)`.
    pub fn replay(&self, until: u64, mut visit: impl FnMut(&Headings)) -> Result<(), FlockError> {
        let mut headings = Headings::new(&self.start.headings);
        let (mut networks, mut controls) = (self.networks.iter().peekable(), self.controls.iter().peekable());
        let (mut rule, mut kappa) = (None, &[][..]);
        for t in 1..=until {
            visit(&headings);
            while let Some((_, network)) = networks.next_if(|(time, _)| *time <= t) {
                rule = Some(averaging(network, t)?);
            }
            while let Some((_, next)) = controls.next_if(|(time, _)| *time <= t) {
                kappa = next;
            }
            if let Some(rule) = rule.as_ref().filter(|_| t < until) {
                turn(&mut headings, rule, kappa);
            }
        }
        Ok(())
    }

    /// Whether `x_i(t) - x_j(t)` is its start times one `e^(i phi)`, as a formal sum: see [`super::KinematicFlock`].
    pub fn is_turned_start(&self, i: usize, j: usize, time: u64) -> Result<bool, FlockError> {
        let mut terms: BTreeMap<Rational, i64> = BTreeMap::new();
        self.replay(time, |headings| {
            for (bird, sign) in [(i, 1), (j, -1)] {
                let heading = headings.value(bird);
                let count = terms.entry(heading.clone()).or_default();
                *count += sign;
                if *count == 0 {
                    terms.remove(&heading);
                }
            }
        })?;
        // e^0 = 1 belongs to the start.
        let straight = terms.remove(&Rational::zero()).unwrap_or(0);
        let (x, y) = (&self.start.positions[i], &self.start.positions[j]);
        let re = &x.re - &y.re + &self.start.speed * BigInt::from(straight);
        let constant = usize::from(!re.is_zero() || x.im != y.im);
        Ok(constant + terms.len() <= 1)
    }
}

/// The averaging of model K: `c_i = 1/(d_i + 1)`.
pub(super) fn averaging(network: &Graph, time: u64) -> Result<Rule, FlockError> {
    Rule::new(network, &Weights::Vicsek, 1, &time.into())
}

fn turn(headings: &mut Headings, rule: &Rule, kappa: &[Rational]) {
    headings.average(rule);
    if !kappa.is_empty() {
        headings.add(kappa);
    }
}
