//! Velocity alignment in large flocks, linked wherever `|r_ij| < R`: neighbours by cells, several pairs at once, all processors.
//!
//! The law is that of [`velocity_alignment`](super::velocity_alignment), put together from the same parts over
//! vectors of floats: `vdot_i = -sum over |r_ij| < R of [(v_i - v_j) + 2 V'(s_ij) r_ij]` (Tanner, Jadbabaie and Pappas, Flocking in fixed and
//! switching networks, equation (4) with the graph of Section 5).

use crate::double_integrator::laws::{Coordinates, Potential, Slope, State, Vector, difference, pull, sum};
use arithmetic::threads::while_one_waits;
use motion::{CellError, CellList, Lanes, VectorField, first_not_finite};
use pulp::Simd;
use rayon::prelude::*;

/// Why a flock has no accelerations. Agents are counted from 0.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum FlockError {
    /// A radius that is not positive, or so large that its square is not a float.
    #[error("the radius must be a positive number below 1e150, but it is {0}")]
    Radius(f64),
    /// A coefficient of the potential that is not a finite float.
    #[error("a coefficient of the potential is too large for floating point")]
    Potential,
    /// Positions and velocities of different numbers, or a flat state that is not `x, y` and then `v_x, v_y` of every agent.
    #[error("the flock has {positions} coordinates of positions and {velocities} of velocities")]
    Length {
        /// Coordinates of positions.
        positions: usize,
        /// Coordinates of velocities.
        velocities: usize,
    },
    /// A position that is not finite.
    #[error("the position of agent {0} (counted from 0) is not finite")]
    Position(usize),
    /// A velocity that is not finite.
    #[error("the velocity of agent {0} (counted from 0) is not finite")]
    Velocity(usize),
    /// Two agents in the same place, where the potential has no slope.
    #[error("agents {0} and {1} (counted from 0) are in the same place, where the potential has no slope")]
    Coincident(usize, usize),
    /// An acceleration that is not a finite float: the agent is too close to another, or something is too fast.
    #[error("the acceleration of agent {0} (counted from 0) is too large for floating point")]
    Acceleration(usize),
}

/// A flock on its way: the rate of change of the state `x_1, y_1, ..., x_N, y_N, v_x1, v_y1, ...` (the order of
/// [`State::to_list`]). O(N) for a bounded density. The answer does not depend on the number of threads.
///
/// As a [`VectorField`] it fills the rate with NaN where there is none, and keeps the reason for [`Self::take_failure`].
#[derive(Debug, Clone)]
pub struct SwitchingFlock {
    radius: f64,
    slope: Slope<f64>,
    /// `x`, `y`, `v_x` and `v_y`, in the order of the cells.
    sorted: [Vec<f64>; 4],
    /// Accelerations, first and second coordinates, in that order.
    found: [Vec<f64>; 2],
    /// Where in that order an agent is, for many of them.
    places: Vec<usize>,
    failure: Option<FlockError>,
}

/// Agents that one task works on.
const TASK: usize = 256;

/// Agents for whom the copying is shared out among processors.
const MANY: usize = 8192;

impl SwitchingFlock {
    /// With a potential of the squared distance and the radius `R` of the links.
    ///
    /// # Errors
    /// [`FlockError::Radius`], [`FlockError::Potential`].
    pub fn new(potential: &Potential, radius: f64) -> Result<Self, FlockError> {
        if !(radius > 0.0 && radius < 1e150) {
            return Err(FlockError::Radius(radius));
        }
        let slope = potential.slope_over(&1.0);
        if !slope.coefficients().all(|c| c.is_finite()) {
            return Err(FlockError::Potential);
        }
        let (sorted, found, places) = Default::default();
        Ok(SwitchingFlock { radius, slope, sorted, found, places, failure: None })
    }

    /// The flat state of a flock that has accelerations.
    ///
    /// # Errors
    /// [`FlockError`].
    pub fn start(&mut self, state: &State<f64>) -> Result<Vec<f64>, FlockError> {
        let list = state.to_list();
        let mut accelerations = vec![[0.0; 2]; state.positions.len()];
        self.accelerations(&state.positions, &state.velocities, &mut accelerations)?;
        Ok(list)
    }

    /// Why the last rates were NaN, and forgets it; an integrator with adaptive steps may have tried others since.
    pub fn take_failure(&mut self) -> Option<FlockError> {
        self.failure.take()
    }

    /// The accelerations of all agents.
    ///
    /// # Errors
    /// [`FlockError`]; then the accelerations are of no use.
    pub fn accelerations(
        &mut self,
        positions: &[Vector<f64>],
        velocities: &[Vector<f64>],
        accelerations: &mut [Vector<f64>],
    ) -> Result<(), FlockError> {
        let count = positions.len();
        if velocities.len() != count || accelerations.len() != count {
            return Err(FlockError::Length { positions: 2 * count, velocities: 2 * velocities.len() });
        }
        if let Some(agent) = first_not_finite(velocities) {
            return Err(FlockError::Velocity(agent));
        }
        let cells = if count > TASK {
            while_one_waits(|| self.cells(positions, velocities))?
        } else {
            self.cells(positions, velocities)?
        };
        self.found.iter_mut().for_each(|found| found.resize(count, 0.0));
        let arch = pulp::Arch::new();
        let (slope, sorted, [first, second]) = (&self.slope, &self.sorted, &mut self.found);
        let radius = self.radius;
        first.par_chunks_mut(TASK).zip(second.par_chunks_mut(TASK)).enumerate().for_each(|(task, (x, y))| {
            arch.dispatch(Sums { cells: &cells, sorted, slope, radius, from: task * TASK, found: [x, y] });
        });
        let at = |place: usize| [self.found[0][place], self.found[1][place]];
        let is_finite = |a: Vector<f64>| a[0].is_finite() & a[1].is_finite();
        // Handing over to another thread takes longer than copying a few.
        let finite = if count < MANY {
            cells.numbers().iter().enumerate().fold(true, |all, (place, &agent)| {
                accelerations[agent] = at(place);
                all & is_finite(accelerations[agent])
            })
        } else {
            self.places.resize(count, 0);
            cells.numbers().iter().enumerate().for_each(|(place, &agent)| self.places[agent] = place);
            let pairs = self.places.par_iter().zip(accelerations).with_min_len(TASK);
            let collect = |(&place, acceleration): (&usize, &mut Vector<f64>)| {
                *acceleration = at(place);
                is_finite(*acceleration)
            };
            pairs.map(collect).reduce(|| true, |a, b| a && b)
        };
        if finite { Ok(()) } else { Err(self.reason(&cells, positions)) }
    }

    /// Cells, and positions and velocities in their order.
    fn cells(&mut self, positions: &[Vector<f64>], velocities: &[Vector<f64>]) -> Result<CellList, FlockError> {
        let cells = CellList::new(positions, self.radius).map_err(|error| match error {
            CellError::Position(agent) => FlockError::Position(agent),
            CellError::Radius(radius) => FlockError::Radius(radius),
        })?;
        self.sort(cells.numbers(), positions, velocities);
        Ok(cells)
    }

    fn sort(&mut self, numbers: &[usize], positions: &[Vector<f64>], velocities: &[Vector<f64>]) {
        self.sorted.iter_mut().for_each(|sorted| sorted.resize(numbers.len(), 0.0));
        let [x, y, u, v] = &mut self.sorted;
        let copy = |agent: usize, x: &mut f64, y: &mut f64, u: &mut f64, v: &mut f64| {
            [*x, *y] = positions[agent];
            [*u, *v] = velocities[agent];
        };
        if numbers.len() < MANY {
            let all = numbers.iter().zip(x).zip(y).zip(u).zip(v);
            all.for_each(|((((&agent, x), y), u), v)| copy(agent, x, y, u, v));
        } else {
            let all = numbers.par_iter().zip(x).zip(y).zip(u).zip(v).with_min_len(TASK);
            all.for_each(|((((&agent, x), y), u), v)| copy(agent, x, y, u, v));
        }
    }

    /// Why an acceleration is not finite.
    fn reason(&self, cells: &CellList, positions: &[Vector<f64>]) -> FlockError {
        let failed = |place: &usize| !(self.found[0][*place].is_finite() && self.found[1][*place].is_finite());
        let apart = |i: usize, j: usize| Coordinates::Cartesian.square(&difference(&positions[i], &positions[j]));
        let numbers = cells.numbers();
        let place = (0..numbers.len()).filter(failed).min_by_key(|&place| numbers[place]).unwrap_or(0);
        let agent = numbers[place];
        let near = cells.neighbourhood(place, 1).1.into_iter().flatten().map(|place| numbers[place]);
        match near.filter(|&other| other != agent && apart(agent, other) == 0.0).min() {
            Some(other) => FlockError::Coincident(agent.min(other), agent.max(other)),
            None => FlockError::Acceleration(agent),
        }
    }
}

impl VectorField for SwitchingFlock {
    fn rate(&mut self, _time: f64, state: &[f64], rate: &mut [f64]) {
        let half = state.len() / 2;
        let ((x, v), (xdot, vdot)) = (state.split_at(half), rate.split_at_mut(half));
        let result = match (x.as_chunks(), v.as_chunks(), vdot.as_chunks_mut()) {
            ((x, []), (v, []), (vdot, [])) => self.accelerations(x, v, vdot),
            _ => Err(FlockError::Length { positions: half, velocities: state.len() - half }),
        };
        match result {
            Ok(()) => xdot.copy_from_slice(v),
            Err(error) => {
                self.failure = Some(error);
                rate.fill(f64::NAN);
            }
        }
    }
}

/// The accelerations of the agents in some places: a few agents next to each other in the lanes, all that may be near one of
/// them in turn. So each agent's sum has the same order whatever the number of lanes; who is too far adds zero.
struct Sums<'a> {
    cells: &'a CellList,
    sorted: &'a [Vec<f64>; 4],
    slope: &'a Slope<f64>,
    radius: f64,
    from: usize,
    found: [&'a mut [f64]; 2],
}

impl pulp::WithSimd for Sums<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let splat = |x: f64| Lanes::splat(simd, x);
        let slope = self.slope.map(|&c| splat(c));
        let [first, second] = self.found;
        let until = self.from + first.len();
        let (limit, zero, one) = (splat(self.radius * self.radius), splat(0.0), splat(1.0));
        let (infinity, numbers) = (splat(f64::INFINITY), Lanes::numbers(simd));
        let [xs, ys, us, vs] = self.sorted.each_ref().map(Vec::as_slice);
        let mut met = Vec::new();
        let mut place = self.from;
        while place < until {
            let (own, stretches) = self.cells.neighbourhood(place, Lanes::<S>::WIDTH.min(until - place));
            let [x, y, u, v] = [xs, ys, us, vs].map(|numbers| Lanes::load(simd, &numbers[own.clone()]));
            let apart = |x_j: f64, y_j: f64| difference(&[x, y], &[splat(x_j), splat(y_j)]);
            // First who is near anybody here, without waiting for comparisons: others are overwritten by the next.
            met.resize(stretches.iter().map(|stretch| stretch.len()).sum::<usize>().max(met.len()), 0);
            let mut count = 0;
            for stretch in stretches {
                for ((&x_j, &y_j), j) in xs[stretch.clone()].iter().zip(&ys[stretch.clone()]).zip(stretch) {
                    met[count] = j;
                    count += usize::from(Coordinates::Cartesian.square(&apart(x_j, y_j)).any_less(limit));
                }
            }
            let mut total = [zero; 2];
            for &j in &met[..count] {
                let separation = apart(xs[j], ys[j]);
                let mut square = Coordinates::Cartesian.square(&separation);
                if own.contains(&j) {
                    // Nobody is a neighbour of itself: an infinite distance in its lane.
                    let lane = splat((j - place) as f64);
                    square = square.select(numbers.less(lane), square.select(lane.less(numbers), infinity));
                }
                let near = square.less(limit);
                // Lanes that take no part must not divide by zero.
                let Ok(slope) = slope.at(&square.select(near, one)) else { continue };
                let force = sum(&difference(&[u, v], &[splat(us[j]), splat(vs[j])]), &pull(&separation, slope));
                total = difference(&total, &force.map(|part| part.select(near, zero)));
            }
            let at = place - self.from..own.end - self.from;
            total[0].store(&mut first[at.clone()]);
            total[1].store(&mut second[at]);
            place = own.end;
        }
    }
}
