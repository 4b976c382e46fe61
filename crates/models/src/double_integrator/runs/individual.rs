//! The laws of both papers for large flocks whose agents have steps of their own.

use crate::double_integrator::laws::{
    Coordinates, HeadingDifference, Potential, Slope, State, difference, heading_rate, pull, sum, turned, turning,
};
use arithmetic::{ArithmeticError, Field};
use motion::{IndividualLaw, Moving, Rates, Turns};

const PLANE: Coordinates = Coordinates::Cartesian;

/// Velocity alignment, equation (4) of the second paper.
#[derive(Debug, Clone)]
pub struct VelocityLaw {
    slope: Slope<f64>,
}

impl VelocityLaw {
    /// With a potential of the squared distance.
    pub fn new(potential: &Potential) -> Self {
        VelocityLaw { slope: potential.slope_over(&1.0) }
    }
}

impl IndividualLaw<0, 2> for VelocityLaw {
    #[inline(always)]
    fn pair<T: Field + Copy>(
        &self,
        own: &Moving<T, 0>,
        other: &Moving<T, 0>,
        number: impl Fn(f64) -> T + Copy,
    ) -> Result<[T; 2], ArithmeticError> {
        let separation = difference(&own.position, &other.position);
        let slope = self.slope.over(&PLANE.square(&separation), |&c| number(c))?;
        Ok(sum(&difference(&own.velocity, &other.velocity), &pull(&separation, slope)))
    }

    #[inline(always)]
    fn rates<T: Field + Copy>(
        &self,
        _: &Moving<T, 0>,
        [x, y]: &[T; 2],
        _: impl Fn(f64) -> T + Copy,
    ) -> Result<Rates<T, 0>, ArithmeticError> {
        Ok(Rates { velocity: [-*x, -*y], further: [] })
    }

    fn push(&self, square: f64) -> f64 {
        self.slope.at(&square).map_or(0.0, |slope| (-8.0 * slope * square).max(0.0))
    }
}

/// Heading alignment, equations (4) and (5) of the first paper; the heading is the further state.
#[derive(Debug, Clone)]
pub struct HeadingLaw {
    slope: Slope<f64>,
    reading: HeadingDifference,
}

impl HeadingLaw {
    /// With a potential of the squared distance and what the difference of two headings means.
    pub fn new(potential: &Potential, reading: HeadingDifference) -> Self {
        HeadingLaw { slope: potential.slope_over(&1.0), reading }
    }
}

impl IndividualLaw<1, 3> for HeadingLaw {
    /// The gradient, then the rate of turning.
    #[inline(always)]
    fn pair<T: Field + Copy>(
        &self,
        own: &Moving<T, 1>,
        other: &Moving<T, 1>,
        number: impl Fn(f64) -> T + Copy,
    ) -> Result<[T; 3], ArithmeticError> {
        let separation = difference(&own.position, &other.position);
        let square = PLANE.square(&separation);
        let [x, y] = pull(&separation, self.slope.over(&square, |&c| number(c))?);
        Ok([x, y, turning(own.further[0] - other.further[0], &square)?])
    }

    #[inline(always)]
    fn rates<T: Field + Copy>(
        &self,
        own: &Moving<T, 1>,
        [x, y, turning]: &[T; 3],
        _: impl Fn(f64) -> T + Copy,
    ) -> Result<Rates<T, 1>, ArithmeticError> {
        let velocity = turned(&own.velocity, turning, &[*x, *y]);
        let further = [heading_rate(&own.velocity, &velocity)?];
        Ok(Rates { velocity, further })
    }

    fn turns(&self) -> Turns {
        match self.reading {
            HeadingDifference::Raw => Turns::OfAgents,
            HeadingDifference::Wrapped => Turns::OfPairs,
            HeadingDifference::Unwrapped => Turns::Never,
        }
    }
}

impl State<f64> {
    /// Each agent alone, with its further states.
    pub fn individuals<const F: usize>(&self, further: &[[f64; F]]) -> Vec<Moving<f64, F>> {
        let agents = self.positions.iter().zip(&self.velocities).zip(further);
        agents.map(|((r, v), further)| Moving { position: *r, velocity: *v, further: *further }).collect()
    }

    /// The positions and velocities of agents.
    pub fn of_individuals<const F: usize>(agents: impl Iterator<Item = Moving<f64, F>>) -> Self {
        let (positions, velocities) = agents.map(|agent| (agent.position, agent.velocity)).unzip();
        State { positions, velocities }
    }
}
