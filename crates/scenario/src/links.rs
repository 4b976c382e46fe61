//! Links that depend on the positions: which there are, what holds them until the next switch, and the switch.

use super::network::{Change, Network, Pair, Rule};
use super::own;
use motion::{CellList, Margin, nearest};
use std::f64::consts::PI;

/// A condition under which everything that is held between switches is still right. The state is positions, of `width` coordinates each, then
/// velocities, then headings.
#[derive(Debug, Clone, Copy)]
pub(super) enum Guard {
    /// A pair is on its side of the radius.
    Side { pair: Pair, linked: bool, radius: f64, width: usize, slack: f64 },
    /// Of two agents one is nearer to a third.
    Rank { agent: usize, inner: usize, outer: usize, width: usize, slack: f64 },
    /// The component of the state, less another one and an offset, is in `(-pi, pi]`.
    HalfTurn { component: usize, less: Option<usize>, offset: f64, slack: f64 },
    /// The heading of the vector at two places of the state, which goes on from a direction, is in `(-pi, pi]` and not far from it.
    Heading { places: [usize; 2], direction: f64, slack: f64 },
}

impl Margin for Guard {
    fn value(&self, at: &dyn Fn(usize) -> f64) -> f64 {
        match *self {
            Guard::Side { pair, linked, radius, width, slack } => {
                let gap = radius * radius - squared(at, pair, width);
                slack + if linked { gap } else { -gap }
            }
            Guard::Rank { agent, inner, outer, width, slack } => {
                slack + squared(at, (agent, outer), width) - squared(at, (agent, inner), width)
            }
            Guard::HalfTurn { component, less, offset, slack } => {
                slack + PI - (at(component) - less.map_or(0.0, at) - offset).abs()
            }
            Guard::Heading { places, direction, slack } => slack + own::margin(direction, places.map(at)),
        }
    }
}

impl Network {
    /// Makes the links of the positions at the start, where the agents move at the rates.
    pub fn settle(&mut self, positions: &[f64], rates: &[f64]) {
        let pairs = match self.rule() {
            Rule::Fixed => return,
            Rule::Within(radius) => {
                let (square, slack) = (radius * radius, self.slack(&positions[..self.width() * self.order()]));
                let linked = |pair: &Pair| match square - self.squared(positions, *pair) {
                    gap if gap.abs() > slack => gap > 0.0,
                    gap => match self.approach(positions, rates, *pair) {
                        0.0 => gap > 0.0,
                        rate => rate < 0.0,
                    },
                };
                // A little wider, for the pairs at exactly the radius.
                self.within(positions, radius * (1.0 + 1e-9)).into_iter().filter(linked).collect()
            }
            Rule::Nearest(count) => {
                let lists = self.nearest(positions, count);
                lists.into_iter().enumerate().flat_map(|(k, list)| list.into_iter().map(move |j| (k, j))).collect()
            }
        };
        self.set_pairs(pairs);
    }

    /// The pairs that rest at exactly a distance.
    pub fn resting_at(&self, positions: &[f64], rates: &[f64], radius: f64) -> Vec<Pair> {
        let rests = |pair: &Pair| {
            self.squared(positions, *pair) == radius * radius && self.approach(positions, rates, *pair) == 0.0
        };
        self.within(positions, radius * (1.0 + 1e-9)).into_iter().filter(rests).collect()
    }

    /// The first two coordinates of all places, of one coordinate with a second that is 0: no two agents are nearer to each other than these.
    pub fn points(&self, positions: &[f64]) -> Vec<[f64; 2]> {
        let width = self.width();
        let second = |k: usize| if width == 1 { 0.0 } else { positions[width * k + 1] };
        (0..self.order()).map(|k| [positions[width * k], second(k)]).collect()
    }

    /// Whether these say where the agents are.
    pub fn is_planar(&self) -> bool {
        self.width() <= 2
    }

    /// `|r_ij|²`.
    pub fn squared(&self, positions: &[f64], pair: Pair) -> f64 {
        squared(&|c| positions[c], pair, self.width())
    }

    /// Half the rate of change of `|r_ij|²`.
    fn approach(&self, positions: &[f64], rates: &[f64], (i, j): Pair) -> f64 {
        let [i, j] = [i, j].map(|k| self.width() * k);
        (0..self.width()).map(|c| (positions[i + c] - positions[j + c]) * (rates[i + c] - rates[j + c])).sum()
    }

    /// The pairs below a distance, sorted; none where positions are not finite.
    pub fn within(&self, positions: &[f64], radius: f64) -> Vec<Pair> {
        let mut pairs = CellList::new(&self.points(positions), radius).map(|cells| cells.pairs()).unwrap_or_default();
        if !self.is_planar() {
            pairs.retain(|pair| self.squared(positions, *pair) < radius * radius);
        }
        pairs
    }

    /// The nearest of each agent, sorted; none where positions are not finite.
    fn nearest(&self, positions: &[f64], count: usize) -> Vec<Vec<usize>> {
        if self.is_planar() {
            return nearest(&self.points(positions), count).unwrap_or_default();
        }
        let of = |k: usize| {
            let mut others: Vec<usize> = (0..self.order()).filter(|j| *j != k).collect();
            let square = |j: &usize| self.squared(positions, (k, *j));
            others.sort_by(|a, b| square(a).total_cmp(&square(b)));
            others.truncate(count);
            others.sort_unstable();
            others
        };
        (0..self.order()).map(of).collect()
    }

    /// What rounding may do to a squared distance near a switch, many times over, with coordinates up to these.
    fn slack(&self, coordinates: &[f64]) -> f64 {
        let far = coordinates.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let near = match self.rule() {
            Rule::Within(radius) => radius,
            _ => far,
        };
        64.0 * f64::EPSILON * near * (near + far)
    }

    /// What may fail while no coordinate moves by more than `moved`.
    pub fn guards(&self, state: &[f64], moved: &[f64]) -> Vec<Guard> {
        if !self.switches() {
            return Vec::new();
        }
        let coordinates: Vec<f64> =
            state.iter().zip(moved).take(self.width() * self.order()).map(|(x, moved)| x.abs() + moved).collect();
        let slack = self.slack(&coordinates);
        let reach: Vec<f64> = moved
            .chunks(self.width())
            .take(self.order())
            .map(|row| row.iter().fold(0.0, |h: f64, x| h.hypot(*x)))
            .collect();
        match self.rule() {
            Rule::Fixed => Vec::new(),
            Rule::Within(radius) => self.sides(state, &reach, radius, slack),
            Rule::Nearest(_) => self.ranks(state, &reach, slack),
        }
    }

    /// Pairs that can come to the radius while each agent moves no farther than its reach.
    fn sides(&self, state: &[f64], reach: &[f64], radius: f64, slack: f64) -> Vec<Guard> {
        let most = reach.iter().fold(0.0, |most: f64, reach| most.max(*reach));
        // Distances are rounded by less than this, many times over.
        let rounding = 1e-9 * radius;
        let can = |(pair, linked): &(Pair, bool)| {
            let away = self.squared(state, *pair).sqrt() - radius;
            (if *linked { -away } else { away }) <= reach[pair.0] + reach[pair.1] + rounding
        };
        let near = self.within(state, radius + 2.0 * (most + rounding));
        let apart = near.into_iter().filter(|pair| self.pairs().binary_search(pair).is_err()).map(|pair| (pair, false));
        let linked = self.pairs().iter().map(|pair| (*pair, true));
        let guard = |(pair, linked)| Guard::Side { pair, linked, radius, width: self.width(), slack };
        linked.chain(apart).filter(can).map(guard).collect()
    }

    /// Neighbours and others that can change places while each agent moves no farther than its reach.
    fn ranks(&self, state: &[f64], reach: &[f64], slack: f64) -> Vec<Guard> {
        let distance = |k: usize, j: usize| self.squared(state, (k, j)).sqrt();
        let most = reach.iter().fold(0.0, |most: f64, reach| most.max(*reach));
        let farthest = |k: usize| self.neighbours(k).iter().map(|&j| distance(k, j)).fold(0.0, f64::max);
        // Where others can be that may become nearer than the farthest neighbour, rounding included.
        let far: Vec<f64> = (0..self.order()).map(|k| (farthest(k) + 4.0 * most) * (1.0 + 1e-9)).collect();
        let typical = far.iter().sum::<f64>() / far.len() as f64;
        let mut guards = Vec::new();
        let Ok(cells) = CellList::new(&self.points(state), if typical > 0.0 { typical } else { 1.0 }) else {
            return guards;
        };
        for (place, &agent) in cells.numbers().iter().enumerate() {
            let near = self.neighbours(agent);
            let inner: Vec<(usize, f64)> = near.iter().map(|&j| (j, distance(agent, j))).collect();
            cells.visit_up_to(place, far[agent], |outer, _| {
                if near.binary_search(&outer).is_ok() {
                    return;
                }
                let away = distance(agent, outer) * (1.0 - 1e-9) - 2.0 * reach[agent] - reach[outer];
                let can = inner.iter().filter(|&&(j, distance)| away <= distance + reach[j]);
                guards.extend(can.map(|&(inner, _)| Guard::Rank { agent, inner, outer, width: self.width(), slack }));
            });
        }
        guards
    }

    /// Changes the links whose switch has come.
    pub fn switch(&mut self, positions: &[f64]) -> Vec<Change> {
        if !self.switches() {
            return Vec::new();
        }
        let due = self.slack(&positions[..self.width() * self.order()]) / 2.0;
        let square = |i: usize, j: usize| self.squared(positions, (i, j));
        let mut changes = Vec::new();
        match self.rule() {
            Rule::Fixed => {}
            Rule::Within(radius) => {
                let lost = self.pairs().iter().filter(|&&(i, j)| square(i, j) >= radius * radius + due);
                changes.extend(lost.map(|&pair| Change { gained: false, pair }));
                let near = self.within(positions, radius).into_iter();
                let gained = near.filter(|&(i, j)| square(i, j) <= radius * radius - due);
                let new = gained.filter(|pair| self.pairs().binary_search(pair).is_err());
                changes.extend(new.map(|pair| Change { gained: true, pair }));
                changes.sort_by_key(|change| change.pair);
            }
            Rule::Nearest(count) => {
                for (k, new) in self.nearest(positions, count).into_iter().enumerate() {
                    let old = self.neighbours(k);
                    let lost = || old.iter().copied().filter(|j| new.binary_search(j).is_err());
                    let gained = || new.iter().copied().filter(|j| old.binary_search(j).is_err());
                    // The nearest of the others is one that is gained, the farthest neighbour one that is lost.
                    let outer = gained().map(|j| square(k, j)).fold(f64::INFINITY, f64::min);
                    let inner = lost().map(|j| square(k, j)).fold(0.0, f64::max);
                    if outer - inner <= -due {
                        changes.extend(lost().map(|j| Change { gained: false, pair: (k, j) }));
                        changes.extend(gained().map(|j| Change { gained: true, pair: (k, j) }));
                    }
                }
            }
        }
        let mut pairs = self.pairs().to_vec();
        for Change { gained, pair } in &changes {
            match (gained, pairs.binary_search(pair)) {
                (true, Err(place)) => pairs.insert(place, *pair),
                (false, Ok(place)) => drop(pairs.remove(place)),
                _ => {}
            }
        }
        self.set_pairs(pairs);
        changes
    }
}

/// `|r_ij|²`.
fn squared(at: &dyn Fn(usize) -> f64, (i, j): Pair, width: usize) -> f64 {
    (0..width).map(|c| at(width * i + c) - at(width * j + c)).map(|x| x * x).sum()
}

#[cfg(test)]
mod tests {
    use super::{Guard, Network, Rule};
    use crate::network::Pair;
    use arithmetic::random::{generator, uniform};
    use motion::Margin;

    fn margin(network: &Network, positions: &[f64]) -> f64 {
        let guards = network.guards(positions, &vec![10.0; positions.len()]);
        guards.iter().map(|guard| guard.value(&|c| positions[c])).fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn resting_ties_stay_and_crossings_switch_together() {
        let mut network = Network::switching(3, Rule::Within(1.0), false, String::new());
        // A pair at rest at exactly the radius is not linked; one that approaches is.
        let positions = [0.0, 0.0, 1.0, 0.0, 0.0, 1.0];
        network.settle(&positions, &[0.0, 0.0, 0.0, 0.0, 0.0, -1.0]);
        assert_eq!(network.pairs(), [(0, 2)]);
        assert!(margin(&network, &positions) > 0.0);
        // Both pairs of a symmetric motion switch at once, whatever rounding does to each.
        network.settle(&[0.0, 0.0, 0.9, 0.0, 0.0, 0.9], &[0.0; 6]);
        let apart = 1.0 + 1e-13;
        let after = [0.0, 0.0, apart, 0.0, 0.0, apart + 1e-16];
        assert!(margin(&network, &after) <= 0.0);
        assert_eq!(network.switch(&after).len(), 2);
        assert!(network.pairs().is_empty() && margin(&network, &after) > 0.0);
    }

    fn places(numbers: usize, size: f64, seed: u64) -> Vec<f64> {
        let mut random = generator("links", "places", seed);
        (0..numbers).map(|_| size * uniform(&mut random)).collect()
    }

    /// Whether what is watched is all that can fail: every pair, or pair of neighbour and other, is asked.
    fn assert_watched(network: &Network, from: &[f64], to: &[f64], moved: &[f64]) {
        let order = network.order();
        let square = |list: &[f64], pair: Pair| network.squared(list, pair);
        let guards = network.guards(from, moved);
        let failed = |guard: &&Guard| guard.value(&|c| to[c]) < 0.0;
        let found: Vec<String> = guards.iter().filter(failed).map(|guard| format!("{guard:?}")).collect();
        let mut count = 0;
        for i in 0..order {
            match network.rule() {
                Rule::Within(radius) => {
                    let linked = |j: usize| network.pairs().contains(&(i, j));
                    count += (i + 1..order).filter(|&j| linked(j) != (square(to, (i, j)) < radius * radius)).count();
                }
                _ => {
                    let near = network.neighbours(i);
                    for outer in (0..order).filter(|j| *j != i && !near.contains(j)) {
                        count += near.iter().filter(|&&j| square(to, (i, outer)) < square(to, (i, j))).count();
                    }
                }
            }
        }
        assert_eq!(found.len(), count);
    }

    #[test]
    fn cells_watch_every_pair_that_can_switch() {
        for width in 1..=3 {
            for (seed, count) in [1, 2, 3, 10, 60, 200].into_iter().enumerate() {
                let rules = [Rule::Within(1.0), Rule::Within(30.0), Rule::Nearest(1), Rule::Nearest(5)];
                for rule in rules.into_iter().filter(|rule| !matches!(rule, Rule::Nearest(n) if *n >= count)) {
                    assert_every_pair_is_watched(width, count, rule, seed as u64);
                }
            }
        }
    }

    fn assert_every_pair_is_watched(width: usize, count: usize, rule: Rule, seed: u64) {
        let from = places(width * count, 10.0, seed);
        let step = places(width * count, 1.0, 100 + seed);
        for size in [0.01, 0.3, 4.0] {
            let to: Vec<f64> = from.iter().zip(&step).map(|(x, step)| x + size * (step - 0.5)).collect();
            let moved: Vec<f64> = step.iter().map(|step| size * (step - 0.5).abs()).collect();
            let directed = matches!(rule, Rule::Nearest(_));
            let fresh = || Network::switching(count, rule, directed, String::new()).of_width(width);
            let mut network = fresh();
            network.settle(&from, &vec![0.0; from.len()]);
            assert_watched(&network, &from, &to, &moved);
            // What switches leads to the links of the new positions.
            let before = network.pairs().to_vec();
            let changes = network.switch(&to);
            let after = network.pairs().to_vec();
            let mut anew = fresh();
            anew.settle(&to, &vec![0.0; to.len()]);
            assert_eq!(after, anew.pairs());
            let gained = after.iter().filter(|pair| !before.contains(pair)).count();
            let lost = before.iter().filter(|pair| !after.contains(pair)).count();
            assert_eq!(changes.iter().filter(|change| change.gained).count(), gained);
            assert_eq!(changes.len(), gained + lost);
        }
    }
}
