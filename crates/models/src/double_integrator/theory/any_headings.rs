//! The closed loop (1), (4), (5) of the first paper at an arbitrary state with arbitrary potentials and headings.
//!
//! The headings are variables of their own: an identity that holds for any numbers `theta_i` whose rates are those of the headings of
//! `v_i` holds under every reading of `theta_i - theta_j` away from its jumps.

use super::any_potentials::AnyPotentials;
use crate::double_integrator::laws::{Vector, dot, gyroscopic, heading_rate, sum};
use algebra::graph::Graph;
use arithmetic::{ArithmeticError, Dual, Field, Ring};

/// The closed loop at one state, with headings.
pub struct AnyHeadings<T> {
    /// Positions, velocities, slopes of the potentials.
    pub flock: AnyPotentials<T>,
    /// `theta_i`.
    pub headings: Vec<T>,
    /// `grad_{r_i} V_i`.
    pub gradients: Vec<Vector<T>>,
    /// Those of (4), (5).
    pub accelerations: Vec<Vector<T>>,
}

/// A factor, as numerator and denominator.
type Ratio = (i64, i64);

impl AnyHeadings<()> {
    /// The number of variables: those of [`AnyPotentials`] and a heading for each agent.
    pub fn variables(graph: &Graph) -> usize {
        AnyPotentials::variables(graph) + graph.order()
    }
}

impl<T: Field> AnyHeadings<T> {
    /// From the list of the variables.
    ///
    /// # Errors
    /// [`ArithmeticError::Domain`] where the list is too short, [`ArithmeticError::DivisionByZero`] where linked agents coincide.
    pub fn read(graph: &Graph, at: &[T]) -> Result<Self, ArithmeticError> {
        let short = ArithmeticError::Domain("a heading for each vertex");
        let (own, headings) = at.split_at_checked(AnyPotentials::variables(graph)).ok_or(short.clone())?;
        if headings.len() != graph.order() {
            return Err(short);
        }
        let flock = AnyPotentials::read(graph, own)?;
        let gradients = flock.gradients()?;
        let accelerations =
            gyroscopic(&flock.state, &gradients, &flock.edges, |i, j| headings[i].clone() - &headings[j])?;
        Ok(AnyHeadings { flock, headings: headings.to_vec(), gradients, accelerations })
    }

    /// The alignment forces alone.
    pub fn alignment(&self) -> Vec<Vector<T>> {
        self.accelerations.iter().zip(&self.gradients).map(|(a, g)| sum(a, g)).collect()
    }

    /// `thetadot_i = (v_i x vdot_i)/|v_i|²`.
    ///
    /// # Errors
    /// [`ArithmeticError::DivisionByZero`] for an agent at rest; so in what follows.
    pub fn heading_rates(&self) -> Result<Vec<T>, ArithmeticError> {
        self.flock.state.velocities.iter().zip(&self.accelerations).map(|(v, a)| heading_rate(v, a)).collect()
    }

    /// What the potentials alone do to the headings, `-(v_i x grad_{r_i} V_i)/|v_i|²`.
    ///
    /// # Errors
    /// As [`Self::heading_rates`].
    pub fn potential_rates(&self) -> Result<Vec<T>, ArithmeticError> {
        let rate = |(v, g): (&Vector<T>, &Vector<T>)| Ok(-heading_rate(v, g)?);
        self.flock.state.velocities.iter().zip(&self.gradients).map(rate).collect()
    }

    /// `(L_w theta)_i`, summed over the neighbours of each agent.
    ///
    /// # Errors
    /// [`ArithmeticError::DivisionByZero`] where linked agents coincide.
    pub fn laplacian(&self) -> Result<Vec<T>, ArithmeticError> {
        let near = |i: usize| {
            let other = move |&(a, b): &(usize, usize)| (a == i).then_some(b).or((b == i).then_some(a));
            self.flock.edges.iter().filter_map(other)
        };
        let term = |i: usize, j: usize| {
            let r = self.flock.state.separation(i, j);
            (self.headings[i].clone() - &self.headings[j]).over(&dot(&r, &r))
        };
        let row = |i: usize| near(i).try_fold(self.headings[i].zero(), |total, j| Ok(total + term(i, j)?));
        (0..self.headings.len()).map(row).collect()
    }

    /// `d/dt` of `potentials sum V_i + kinetic sum |v_i|² + headings sum theta_i²`.
    ///
    /// # Errors
    /// As [`Self::heading_rates`].
    pub fn rate_of(&self, potentials: Ratio, kinetic: Ratio, headings: Ratio) -> Result<T, ArithmeticError> {
        let moving = self.flock.state.moving(&self.accelerations);
        let energy = self.flock.energy(&moving, potentials)?;
        let zero = energy.zero();
        let speeds = moving.velocities.iter().fold(zero.clone(), |sum, v| sum + dot(v, v));
        let rest = zero.ratio(kinetic.0, kinetic.1) - zero.ratio(1, 2);
        let angles = self.headings.iter().zip(self.heading_rates()?).map(|(x, rate)| Dual::new(x.clone(), rate));
        let squares = angles.fold(zero.clone(), |sum, x| sum + x.clone() * x);
        Ok((energy + speeds * rest + squares * zero.ratio(headings.0, headings.1)).derivative)
    }
}
