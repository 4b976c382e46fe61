//! The energy along a run: that it does not rise between switches and does not jump at switches by distance, within what the
//! integrator's tolerance and rounding allow.
//!
//! **Margin.** A step of the integrator is accepted when its estimated errors `e_k` in the components fulfil `sum (e_k/s_k)² <= n`, with
//! `s_k = absolute + relative |y_k|` and `n` components. To first order they move the energy by `sum g_k e_k`, with `g` its gradient
//! (`grad_{r_i} V_i`, `v_i`), which is at most `sqrt(n sum (g_k s_k)²)` (Cauchy and Schwarz). Rounding adds a few units in the last place
//! of each term. The exact motion loses energy, so that a rise by more than this is no effect of the steps.

use crate::double_integrator::laws::{
    Coordinates, Pair, Potential, Slope, State, Value, kinetic_energy, potential_energy, potential_gradients,
    saturated_potential,
};
use arithmetic::ArithmeticError;
use motion::Tolerance;

const PLANE: Coordinates = Coordinates::Cartesian;

/// A change of the energy that should not be, with what is allowed.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Excess {
    /// The change.
    pub change: f64,
    /// What the tolerance and rounding allow.
    pub allowed: f64,
    /// When.
    pub time: f64,
}

impl Excess {
    /// The larger one, compared with what is allowed.
    fn worst(self, other: Excess) -> Self {
        if other.change * self.allowed > self.change * other.allowed || self.allowed == 0.0 { other } else { self }
    }

    /// Whether it is within what is allowed.
    pub fn is_allowed(&self) -> bool {
        self.change <= self.allowed
    }
}

/// The energy along a run.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct EnergyLog {
    /// At the start.
    pub first: f64,
    /// At the end.
    pub last: f64,
    /// The largest rise in a step, compared with what is allowed; negative or zero where there is none.
    pub rise: Excess,
    /// The largest jump at a switch by distance, compared with what is allowed.
    pub jump: Excess,
}

impl EnergyLog {
    /// Whether the energy rose nowhere between switches and jumped at no switch by distance, beyond what is allowed.
    pub fn is_monotone(&self) -> bool {
        self.rise.is_allowed() && self.jump.is_allowed()
    }

    /// After a step.
    pub(super) fn step(&mut self, time: f64, from: f64, to: f64, allowed: f64) {
        self.rise = self.rise.worst(Excess { change: to - from, allowed, time });
        self.last = to;
    }

    /// At a switch by distance.
    pub(super) fn switch(&mut self, time: f64, from: f64, to: f64, allowed: f64) {
        self.jump = self.jump.worst(Excess { change: (to - from).abs(), allowed, time });
        self.last = to;
    }
}

/// The energy of a network: kinetic energy, the potentials of the links, each once, and for switching by distance `V(R²)` for every other
/// pair: `Q` of the second paper, (11).
pub(super) struct Energy {
    value: Value<f64>,
    slope: Slope<f64>,
    /// `V(R²)`.
    beyond: Option<f64>,
}

impl Energy {
    pub fn new(potential: &Potential, radius: Option<f64>) -> Result<Self, ArithmeticError> {
        let value = potential.value_over(&1.0)?;
        let beyond = radius.map(|r| value.at(&(r * r))).transpose()?;
        Ok(Energy { value, slope: potential.slope_over(&1.0), beyond })
    }

    /// The value, and the size of its rounding error.
    pub fn of(&self, state: &State<f64>, links: &[Pair]) -> Result<(f64, f64), ArithmeticError> {
        let potential = |size: fn(f64) -> f64| {
            let value = |_: usize, _: usize, s: &f64| self.value.at(s).map(size);
            match self.beyond {
                None => potential_energy(&state.positions, links, PLANE, value),
                Some(beyond) => saturated_potential(&state.positions, links, PLANE, value, &size(beyond)),
            }
        };
        let kinetic = kinetic_energy(&state.velocities, PLANE)?;
        let terms = (links.len() + state.count() + 16) as f64;
        Ok((kinetic + potential(|v| v)?, terms * f64::EPSILON * (kinetic + potential(f64::abs)?)))
    }

    /// What a step's error may add.
    pub fn margin(&self, state: &State<f64>, links: &[Pair], tolerance: Tolerance) -> Result<f64, ArithmeticError> {
        let gradients = potential_gradients(&state.positions, links, PLANE, |_, _, s| self.slope.at(s))?;
        let all = gradients.iter().chain(&state.velocities).flatten();
        let values = state.positions.iter().chain(&state.velocities).flatten();
        let squares = all.zip(values).map(|(g, y)| {
            let size = g * (tolerance.absolute + tolerance.relative * y.abs());
            size * size
        });
        Ok((4.0 * state.count() as f64 * squares.sum::<f64>()).sqrt())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use arithmetic::rational;

    fn spring() -> Potential {
        Potential::inverse_square_spring(&rational(1, 1), &rational(1, 1))
    }

    /// Three agents: distances 1, 2 and the root of 5.
    fn state() -> State<f64> {
        State {
            positions: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 2.0]],
            velocities: vec![[3.0, 0.0], [0.0, -4.0], [1.0, 1.0]],
        }
    }

    /// `W` and `Q` by hand, with the sizes of their rounding: a unit of rounding for each of so many terms, of the sum of their sizes.
    #[test]
    fn energies_are_those_of_the_papers() {
        // V = s + 1/s - 2: 0 at 1, 9/4 at 4. The kinetic energy is (9 + 16 + 2)/2.
        let links = [(0, 1), (0, 2)];
        let (fixed, terms) = (Energy::new(&spring(), None).unwrap(), 5.0 + 16.0);
        assert_eq!(fixed.of(&state(), &links), Ok((15.75, terms * f64::EPSILON * 15.75)));
        // R = 3/2: V(9/4) = 9/4 + 4/9 - 2 for the other two pairs.
        let within = Energy::new(&spring(), Some(1.5)).unwrap();
        let beyond = 2.25 + 4.0 / 9.0 - 2.0;
        let (value, rounding) = within.of(&state(), &links[..1]).unwrap();
        assert!((value - (13.5 + 2.0 * beyond)).abs() < 1e-14);
        assert!((rounding / (20.0 * f64::EPSILON * value) - 1.0).abs() < 1e-14);
        // Terms of both signs: V = 2 - s.
        let falling = Potential::new(vec![(0, rational(-1, 1))], (rational(2, 1), rational(0, 1)));
        let (value, rounding) = Energy::new(&falling, Some(2.0)).unwrap().of(&state(), &links).unwrap();
        assert!((value - (13.5 + 1.0 - 2.0 - 2.0)).abs() < 1e-14);
        assert!((rounding / (terms * f64::EPSILON * (13.5 + 1.0 + 2.0 + 2.0)) - 1.0).abs() < 1e-14);
    }

    /// `sqrt(n sum (g s)²)` with the gradient `g`, `s = absolute + relative |y|` and `n = 4N`.
    #[test]
    fn the_margin_is_that_of_cauchy_and_schwarz() {
        let tolerance = Tolerance { absolute: 0.25, relative: 0.5 };
        let energy = Energy::new(&spring(), None).unwrap();
        // 2 V' r = 0 at distance 1, 2 (15/16) 2 at distance 2, against and along the second axis.
        let pull = 3.75;
        let terms = [
            // Positions: agents 0 and 2 with the second coordinates 0 and 2.
            (pull, 0.25),
            (pull, 1.25),
            // Velocities.
            (3.0, 1.75),
            (4.0, 2.25),
            (1.0, 0.75),
            (1.0, 0.75),
        ];
        let sum: f64 = terms.iter().map(|(g, s)| (g * s) * (g * s)).sum();
        let found = energy.margin(&state(), &[(0, 1), (0, 2)], tolerance).unwrap();
        assert!((found - (12.0 * sum).sqrt()).abs() < 1e-13, "{found}");
    }

    /// The worst is the one that uses most of what is allowed, the first of equals.
    #[test]
    fn the_worst_change_is_kept_with_its_time() {
        let mut log = EnergyLog { first: 9.0, last: 9.0, ..EnergyLog::default() };
        for (time, from, to, allowed) in
            [(1.0, 9.0, 8.0, 0.5), (2.0, 8.0, 8.25, 0.5), (3.0, 8.25, 8.75, 2.0), (4.0, 8.75, 8.8125, 0.125)]
        {
            log.step(time, from, to, allowed);
            assert_eq!(log.last, to);
        }
        // Shares -2, 1/2, 1/4 and 1/2.
        assert_eq!(log.rise, Excess { change: 0.25, allowed: 0.5, time: 2.0 });
        assert!(log.is_monotone() && log.jump == Excess::default());
        log.switch(5.0, 8.8125, 8.5625, 1.0);
        assert_eq!((log.jump, log.last), (Excess { change: 0.25, allowed: 1.0, time: 5.0 }, 8.5625));
        log.switch(6.0, 8.0, 8.5, 1.0);
        log.switch(7.0, 8.5, 8.25, 1.0);
        assert_eq!((log.jump, log.last), (Excess { change: 0.5, allowed: 1.0, time: 6.0 }, 8.25));
        assert!(log.is_monotone());
        for excess in [(1.0, 1.0, true), (1.5, 1.0, false), (-1.0, 0.0, true), (0.0, 0.0, true)] {
            let (change, allowed, is_allowed) = excess;
            let one = Excess { change, allowed, time: 0.0 };
            assert_eq!(one.is_allowed(), is_allowed);
            assert_eq!(EnergyLog { rise: one, ..EnergyLog::default() }.is_monotone(), is_allowed);
            assert_eq!(EnergyLog { jump: one, ..EnergyLog::default() }.is_monotone(), is_allowed);
        }
        // Nothing allowed: any rise is worse, and a further one takes its place only where it is one.
        let none = Excess { change: 0.0, allowed: 0.0, time: 0.0 };
        let some = Excess { change: -1.0, allowed: 2.0, time: 1.0 };
        assert_eq!((none.worst(some), some.worst(Excess { time: 2.0, ..some })), (some, some));
    }
}
