//! The energy along a run: that it does not rise between switches and does not jump at switches by distance, within what the
//! integrator's tolerance and rounding allow.
//!
//! **Margin.** A step of the integrator is accepted when its estimated errors `e_k` in the components fulfil `sum (e_k/s_k)² <= n`, with
//! `s_k = absolute + relative |y_k|` and `n` components. To first order they move the energy by `sum g_k e_k`, with `g` its gradient
//! (`grad_{r_i} V_i`, `v_i`), which is at most `sqrt(n sum (g_k s_k)²)` (Cauchy and Schwarz). Rounding adds a few units in the last place
//! of each term. The exact motion loses energy, so that a rise by more than this is no effect of the steps.

use super::{
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
    /// The sum of the jumps at switches that a signal makes, which may be of any size and sign.
    pub imposed: f64,
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
