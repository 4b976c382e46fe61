//! What can be seen of a simulated flock: at one time, over a run, between start and end.

use super::input::Flock;
use super::motion::{EventKind, Motion, MotionError, Options, Sample};
use crate::double_integrator::laws::{
    Coordinates, Pair, Potential, State, Vector, difference, disagreement, heading, heading_spread, potential_energy,
    potential_gradients,
};
use algebra::graph::Graph;
use arithmetic::{ArithmeticError, Unwatched};

const PLANE: Coordinates = Coordinates::Cartesian;

/// What can be seen at one time. Distances are in the unit of positions, speeds per unit of time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Observation {
    /// When.
    pub time: f64,
    /// `sqrt(sum |v_i - mean|²)`.
    pub disagreement: f64,
    /// The largest disagreement within a component of the graph of links.
    pub component_disagreement: f64,
    /// The largest wrapped difference of two headings, in radians; agents at rest do not count.
    pub heading_spread: f64,
    /// The least distance of two agents, linked or not.
    pub least_distance: f64,
    /// The least distance of two agents that are not linked; infinite if all are.
    pub least_unlinked: f64,
    /// The largest distance from the mean position.
    pub radius: f64,
    /// The largest `|grad V_i|`.
    pub gradient: f64,
    /// The sum of `V_ij` over the links.
    pub potential: f64,
    /// `W`, equation (6) of the second paper, on given graphs; `Q`, equation (11), with links within a radius.
    pub energy: f64,
    /// Connected components of the graph of links.
    pub components: usize,
    /// Links.
    pub links: usize,
    /// Pairs of agents.
    pub pairs: usize,
}

impl Observation {
    /// What is seen of a sample.
    ///
    /// # Errors
    /// [`ArithmeticError`] where linked agents coincide; [`ArithmeticError::Domain`] where there is not a velocity for each position, for a link to an
    /// agent that is not there, and for no agents.
    pub fn of(sample: &Sample, potential: &Potential) -> Result<Self, ArithmeticError> {
        let Sample { state, links, .. } = sample;
        state.check()?;
        let count = state.count();
        let graph = Graph::from_fn(count, |i, j| links.contains(&(i, j)));
        let distance = |(i, j): Pair| length(&state.separation(i, j));
        let least = |pairs: &mut dyn Iterator<Item = Pair>| pairs.map(distance).fold(f64::INFINITY, f64::min);
        let components = graph.components();
        let within = components.iter().map(|members| {
            disagreement(&State {
                positions: members.iter().map(|&i| state.positions[i]).collect(),
                velocities: members.iter().map(|&i| state.velocities[i]).collect(),
            })
        });
        let slope = potential.slope_over(&1.0);
        let gradients = potential_gradients(&state.positions, links, PLANE, |_, _, s| slope.at(s))?;
        let value = potential.value_over(&1.0)?;
        let headings: Vec<f64> = state.velocities.iter().filter_map(|v| heading(v).ok()).collect();
        Ok(Observation {
            time: sample.time,
            disagreement: disagreement(state),
            component_disagreement: within.fold(0.0, f64::max),
            heading_spread: heading_spread(&headings),
            least_distance: least(&mut pairs(count)),
            least_unlinked: least(&mut pairs(count).filter(|&(i, j)| !graph.has_edge(i, j))),
            radius: radius(&state.positions),
            gradient: gradients.iter().map(length).fold(0.0, f64::max),
            potential: potential_energy(&state.positions, links, PLANE, |_, _, s| value.at(s))?,
            energy: sample.energy,
            components: components.len(),
            links: links.len(),
            pairs: count * (count - 1) / 2,
        })
    }

    /// What the figures of the first paper show at their end: a common heading, a tight formation and a potential minimum, told from the
    /// heading spread, the radius and the largest gradient.
    pub fn is_formation(&self, headings: f64, gradient: f64, radius: f64) -> bool {
        self.heading_spread < headings && self.gradient < gradient && self.radius < radius
    }

    /// Links over pairs.
    pub fn density(&self) -> f64 {
        self.links as f64 / self.pairs.max(1) as f64
    }
}

/// Start and end of a run, and what happened between.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trial {
    /// At time 0.
    pub start: Observation,
    /// At the end.
    pub end: Observation,
    /// The least distance of any two agents at any time, by cubics between samples.
    pub closest: f64,
    /// Whether the graph of links was connected all the time.
    pub stayed_connected: bool,
    /// Whether the energy rose nowhere beyond what tolerance and rounding allow.
    pub energy_fell: bool,
}

impl Trial {
    /// Whether the disagreement at the end is below this part of that at the start.
    pub fn agrees(&self, part: f64) -> bool {
        self.end.disagreement < part * self.start.disagreement
    }

    /// Whether that holds within each component of the final graph.
    pub fn components_agree(&self, part: f64) -> bool {
        self.end.component_disagreement < part * self.start.disagreement
    }
}

impl Flock {
    /// A run with samples every `every`, or only at its ends.
    ///
    /// # Errors
    /// [`MotionError`].
    pub fn trial(&self, until: f64, every: Option<f64>, options: &Options) -> Result<Trial, MotionError> {
        let steps = every.map_or(1, |every| (until / every).ceil().max(1.0) as usize);
        let times: Vec<f64> = (0..=steps).map(|k| until * k as f64 / steps as f64).collect();
        let motion = self.run(until, &times, options, &Unwatched)?;
        let seen = |sample: Option<&Sample>| {
            let sample = sample.ok_or(ArithmeticError::Domain("runs with a start and an end"))?;
            Observation::of(sample, &self.potential)
        };
        Ok(Trial {
            start: seen(motion.samples.first())?,
            end: seen(motion.samples.last())?,
            closest: closest(&motion.samples),
            stayed_connected: self.stayed_connected(&motion),
            energy_fell: motion.energy.is_monotone(),
        })
    }

    /// The potential of each linked pair.
    pub fn potential(&self) -> &Potential {
        &self.potential
    }

    /// Whether the graph of links was connected at every instant of a motion: links that change at once do so together.
    fn stayed_connected(&self, motion: &Motion) -> bool {
        let connected =
            |links: &[Pair]| Graph::from_fn(self.start.count(), |i, j| links.contains(&(i, j))).is_connected();
        let mut links = self.links_at_start();
        connected(&links)
            && motion.events.chunk_by(|a, b| a.time == b.time).all(|together| {
                for event in together {
                    match event.kind {
                        EventKind::Link => links.push(event.pair),
                        EventKind::Unlink => links.retain(|pair| *pair != event.pair),
                        EventKind::Touch | EventKind::Stay => {}
                    }
                }
                connected(&links)
            })
    }
}

fn pairs(count: usize) -> impl Iterator<Item = Pair> {
    (0..count).flat_map(|j| (0..j).map(move |i| (i, j)))
}

fn length(vector: &Vector<f64>) -> f64 {
    PLANE.square(vector).sqrt()
}

fn radius(positions: &[Vector<f64>]) -> f64 {
    let count = positions.len().max(1) as f64;
    let mean = [0, 1].map(|k| positions.iter().map(|r| r[k]).sum::<f64>() / count);
    positions.iter().map(|r| length(&difference(r, &mean))).fold(0.0, f64::max)
}

/// The least distance of two agents over samples and, where two come nearer and part between two samples, on the cubic
/// through positions and velocities at both.
fn closest(samples: &[Sample]) -> f64 {
    let mut least = f64::INFINITY;
    let count = samples.first().map_or(0, |sample| sample.state.count());
    for (i, j) in pairs(count) {
        let seen = |sample: &Sample| (sample.state.separation(i, j), sample.state.relative_velocity(i, j));
        for sample in samples {
            least = least.min(PLANE.square(&seen(sample).0));
        }
        for two in samples.windows(2) {
            let ends = [seen(&two[0]), seen(&two[1])];
            let [opening, closing] = ends.each_ref().map(|(r, v)| PLANE.product(r, v));
            if opening < 0.0 && closing > 0.0 {
                least = least.min(turning_point(&ends, two[1].time - two[0].time));
            }
        }
    }
    least.sqrt()
}

/// The squared length where a vector that comes nearer at the beginning and leaves at the end of a stretch of time turns, by
/// bisection on the cubic through positions and velocities at both ends.
fn turning_point(ends: &[(Vector<f64>, Vector<f64>); 2], time: f64) -> f64 {
    let [(r0, v0), (r1, v1)] = ends;
    let at = |x: f64| {
        let rest = 1.0 - x;
        let place = |k: usize| {
            (1.0 + 2.0 * x) * rest * rest * r0[k] + x * rest * rest * time * v0[k] + x * x * (3.0 - 2.0 * x) * r1[k]
                - x * x * rest * time * v1[k]
        };
        let slope = |k: usize| {
            6.0 * x * rest * (r1[k] - r0[k]) + rest * (1.0 - 3.0 * x) * time * v0[k]
                - x * (2.0 - 3.0 * x) * time * v1[k]
        };
        ([place(0), place(1)], [slope(0), slope(1)])
    };
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        let (r, v) = at(middle);
        if PLANE.product(&r, &v) < 0.0 { low = middle } else { high = middle }
    }
    PLANE.square(&at(low).0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `r(t)` with these coefficients of `1, t, t², t³`, and its derivative.
    fn moving(c: &[[f64; 2]; 4], t: f64) -> (Vector<f64>, Vector<f64>) {
        let r = [0, 1].map(|k| c[0][k] + t * (c[1][k] + t * (c[2][k] + t * c[3][k])));
        let v = [0, 1].map(|k| c[1][k] + t * (2.0 * c[2][k] + t * 3.0 * c[3][k]));
        (r, v)
    }

    /// A motion that is a cubic is its own interpolation: where it turns is found among many instants.
    #[test]
    fn cubics_turn_where_they_are_nearest() {
        for (c, time) in [
            ([[3.0, 1.0], [-2.0, 0.25], [0.0, 0.0], [0.0, 0.0]], 4.0),
            ([[2.0, -1.0], [-3.0, 1.5], [1.0, 0.25], [0.125, -0.0625]], 2.0),
            ([[1.0, 0.5], [-8.0, 0.5], [6.0, 4.0], [24.0, -10.0]], 0.5),
            ([[0.5, -2.0], [0.25, 1.0], [-0.25, 0.125], [0.03125, 0.015625]], 6.0),
        ] {
            let ends = [moving(&c, 0.0), moving(&c, time)];
            assert!(PLANE.product(&ends[0].0, &ends[0].1) < 0.0 && PLANE.product(&ends[1].0, &ends[1].1) > 0.0);
            let squares = (0..=100_000).map(|k| PLANE.square(&moving(&c, time * f64::from(k) / 1e5).0));
            let known = squares.fold(f64::INFINITY, f64::min);
            let found = turning_point(&ends, time);
            assert!((found - known).abs() < 1e-7 * known.max(1e-3), "{c:?}: {found} {known}");
        }
    }
}
