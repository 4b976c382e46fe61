//! Who is linked with whom in the states of a piece of time.

use super::at::At;
use arithmetic::{FloatInterval, Ring};
use scenario::ExactMotion;

impl At<'_, '_> {
    /// The least and the largest number of connected parts of the network in force, arcs taken as edges, as `simulate` counts them.
    pub(super) fn components(&self) -> Option<[usize; 2]> {
        let count = |order: usize, pairs: &[(usize, usize)]| algebra::graph::components(order, pairs).len();
        let fixed = match self.motion {
            ExactMotion::Velocities { positions, radius: Some(radius), .. } => match &self.pairs {
                Some(pairs) => count(positions.len(), pairs),
                None => {
                    let square = FloatInterval::from_rational(radius).square();
                    let may = self.near(positions.len(), |apart| apart.lo() <= square.hi());
                    let must = self.near(positions.len(), |apart| apart.hi() < square.lo());
                    return Some([count(positions.len(), &may), count(positions.len(), &must)]);
                }
            },
            ExactMotion::Velocities { positions, pairs, .. } => count(positions.len(), pairs),
            ExactMotion::Phases { network, phases, .. } | ExactMotion::Particles { network, phases, .. } => {
                count(phases.len(), &network.arcs().collect::<Vec<_>>())
            }
            ExactMotion::Platoon { graph, .. } => {
                let cars = 0..=graph.followers();
                let arcs = cars.flat_map(|k| graph.tracked_by(k).iter().map(move |(j, _)| (k, *j)));
                count(graph.followers() + 1, &arcs.collect::<Vec<_>>())
            }
            ExactMotion::Own(own) => count(own.agents(), &own.links()),
            ExactMotion::Other(_) => return None,
        };
        Some([fixed, fixed])
    }
    /// The pairs whose squared distances are as they are wanted.
    fn near(&self, agents: usize, wanted: impl Fn(FloatInterval) -> bool) -> Vec<(usize, usize)> {
        let pairs = (0..agents).flat_map(|j| (0..j).map(move |i| (i, j)));
        pairs.filter(|&(i, j)| wanted(self.square(i, j, 2, 0))).collect()
    }
}
