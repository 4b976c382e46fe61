//! The system as the algorithms see it: unknown constants are states that do not move, and every input is its centre and a radius.

use crate::system::{Range, System};
use arithmetic::{Rational, rational};
use num_traits::Zero;

/// A measurable input of a mode: within its radius of its centre, along its column.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Push {
    /// Which input of the system.
    pub input: usize,
    pub centre: Rational,
    pub radius: Rational,
    pub column: Vec<Rational>,
}

/// `x' = A x + drift + sum column_j u_j`, `|u_j - centre_j| <= radius_j`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Motion {
    pub a: Vec<Vec<Rational>>,
    pub drift: Vec<Rational>,
    pub pushes: Vec<Push>,
}

/// All modes, and where the states start.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Prepared {
    pub motions: Vec<Motion>,
    pub start: Vec<Range>,
}

impl Motion {
    /// Whether a state never moves.
    pub fn stands(&self, i: usize) -> bool {
        self.a[i].iter().all(Zero::is_zero)
            && self.drift[i].is_zero()
            && self.pushes.iter().all(|push| push.column[i].is_zero())
    }
}

impl Prepared {
    pub fn new(system: &System) -> Self {
        let constants: Vec<usize> = (0..system.inputs.len()).filter(|&j| system.inputs[j].constant).collect();
        let mut start = system.start.clone();
        start.extend(constants.iter().map(|&j| system.inputs[j].range.clone()));
        let motions = (0..system.modes.len()).map(|k| motion(system, k, &constants)).collect();
        Prepared { motions, start }
    }

    /// How many states.
    pub fn order(&self) -> usize {
        self.start.len()
    }

    /// Each state as a row, in both signs.
    pub fn sides(&self) -> Vec<Vec<Rational>> {
        let n = self.order();
        let unit = |i: usize, sign: i64| (0..n).map(|j| rational(if i == j { sign } else { 0 }, 1)).collect();
        (0..n).flat_map(|i| [unit(i, 1), unit(i, -1)]).collect()
    }
}

fn motion(system: &System, mode: usize, constants: &[usize]) -> Motion {
    let (mode, extra) = (&system.modes[mode], constants.len());
    let column = |j: usize| mode.b.iter().map(move |row| row[j].clone()).chain((0..extra).map(|_| Rational::ZERO));
    // What is always 0 moves nothing, and a number is no input.
    let is_zero = |j: usize| system.inputs[j].range == Range::point(Rational::ZERO);
    let mut a: Vec<Vec<Rational>> = Vec::new();
    for (row, inputs) in mode.a.iter().zip(&mode.b) {
        let factor = |&j: &usize| if is_zero(j) { Rational::ZERO } else { inputs[j].clone() };
        a.push(row.iter().cloned().chain(constants.iter().map(factor)).collect());
    }
    a.extend((0..extra).map(|_| vec![Rational::ZERO; system.states.len() + extra]));
    let mut drift: Vec<Rational> = mode.c.iter().cloned().chain((0..extra).map(|_| Rational::ZERO)).collect();
    let mut pushes = Vec::new();
    for (j, input) in system.inputs.iter().enumerate().filter(|(_, input)| !input.constant) {
        let column: Vec<Rational> = column(j).collect();
        if input.range.is_point() {
            drift.iter_mut().zip(&column).for_each(|(sum, x)| *sum += x * &input.range.lo);
        } else if column.iter().any(|x| !x.is_zero()) {
            pushes.push(Push { input: j, centre: input.range.centre(), radius: input.range.radius(), column });
        }
    }
    Motion { a, drift, pushes }
}
