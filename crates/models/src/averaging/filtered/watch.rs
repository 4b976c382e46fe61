//! Which pairs have to be looked at, and when: a pair is looked at again only when its status could have changed.
//!
//! Velocities of a flock stay in the box that holds them now, as long as no other flock joins it. In an epoch (until flocks
//! merge, or some number of steps) the relative velocity of two birds differs from that of now by the widths of the boxes of
//! their flocks at most, and their distance changes accordingly (Lemma 2.1).

use super::balls::Balls;
use super::classes::Classes;
use algebra::graph::Graph;
use motion::CellList;

/// The pairs to look at, by time.
#[derive(Debug, Clone, Default)]
pub(super) struct Watch {
    /// The time at which the epoch began; none runs after flocks have merged.
    start: Option<u64>,
    length: u64,
    wanted_length: u64,
    component_of: Vec<usize>,
    /// By component: a bound of how much a velocity can still change.
    widths: Vec<f64>,
    still: Vec<bool>,
    /// The pairs to look at `1, 2, ..` steps after the start.
    due: Vec<Vec<(u32, u32)>>,
}

/// The longest epoch.
const LONGEST: u64 = 4096;

/// Rounding in double precision, generously.
const SLACK: f64 = 1e-9;

/// For how many steps at least the status of a pair cannot change: from the difference of the positions, that of the velocities of
/// the last move (or of the next), and a bound of how far later ones differ from that.
fn quiet_steps(now: &[f64], moved: &[f64], joined: bool, drift: f64, error: f64) -> u64 {
    let dot = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(x, y)| x * y).sum() };
    let distance = dot(now, now).sqrt();
    let speed = dot(moved, moved).sqrt();
    let slack = SLACK * (1.0 + distance) + error;
    let (gap, approach) = if joined {
        (1.0 - distance, speed)
    } else {
        // The distance on a straight way is a convex function of time: at least its tangent.
        (distance - 1.0, -dot(now, moved) / distance + SLACK * speed)
    };
    let rate = approach * (1.0 + SLACK) + drift;
    let gap = gap - slack;
    if gap.is_nan() || gap <= 0.0 || rate.is_nan() {
        0
    } else if rate <= 0.0 {
        u64::MAX
    } else {
        // Below the quotient.
        (gap / rate * (1.0 - SLACK)) as u64
    }
}

impl Watch {
    /// The pairs to look at in the next step.
    pub fn due<const L: usize>(&mut self, balls: &Balls<L>, network: &Graph, classes: &Classes) -> Vec<(u32, u32)> {
        let running = self.start.is_some_and(|start| balls.time < start + self.length);
        if !running {
            self.begin(balls, network, classes);
        }
        let step = (balls.time - self.start.unwrap_or(balls.time)) as usize;
        self.due.get_mut(step).map(std::mem::take).unwrap_or_default()
    }

    /// Ends the epoch where a pair that has joined connects different flocks.
    pub fn note_joined(&mut self, (i, j): (u32, u32)) {
        if self.component_of[i as usize] != self.component_of[j as usize] {
            self.start = None;
            self.wanted_length = (self.wanted_length / 2).max(1);
        }
    }

    /// Ends the epoch: more is known about what stays.
    pub fn renew(&mut self) {
        self.start = None;
    }

    /// Puts a pair on the list again that was looked at in the next step, of which `now` and `moved` are the differences.
    pub fn schedule(&mut self, pair: (u32, u32), now: &[f64], moved: &[f64], joined: bool, (time, error): (u64, f64)) {
        let Some(start) = self.start else { return };
        let steps = self.quiet(pair, now, moved, joined, error);
        self.put(pair, (time - start).saturating_add(steps));
    }

    fn quiet(&self, (i, j): (u32, u32), now: &[f64], moved: &[f64], joined: bool, error: f64) -> u64 {
        let (f, g) = (self.component_of[i as usize], self.component_of[j as usize]);
        if f == g && self.still[f] {
            // The two move alike for ever.
            return u64::MAX;
        }
        let drift = if f == g { self.widths[f] * 2.0 } else { self.widths[f] + self.widths[g] };
        quiet_steps(now, moved, joined, drift, error)
    }

    fn put(&mut self, pair: (u32, u32), place: u64) {
        if let Some(list) = usize::try_from(place).ok().and_then(|place| self.due.get_mut(place)) {
            list.push(pair);
        }
    }

    /// A new epoch from the state of now on.
    fn begin<const L: usize>(&mut self, balls: &Balls<L>, network: &Graph, classes: &Classes) {
        let (positions, velocities) = balls.floats();
        let dimension = positions.len() / network.order();
        let (position_error, velocity_error) = balls.errors();
        let (component_of, components) = balls.links.components();
        self.still = classes.is_still(&component_of, components);
        self.component_of = component_of;
        let box_width = |birds: &mut dyn Iterator<Item = usize>| {
            let mut bounds = vec![(f64::INFINITY, f64::NEG_INFINITY); dimension];
            for i in birds {
                for (k, (lo, hi)) in bounds.iter_mut().enumerate() {
                    let v = velocities[i * dimension + k];
                    (*lo, *hi) = (lo.min(v), hi.max(v));
                }
            }
            let size = |(lo, hi): &(f64, f64)| (hi - lo) + 2.0 * velocity_error + SLACK * (hi.abs().max(lo.abs()));
            bounds.iter().map(|b| size(b).powi(2)).sum::<f64>().sqrt() * (1.0 + SLACK)
        };
        let mut members = vec![Vec::new(); components];
        for (i, &component) in self.component_of.iter().enumerate() {
            members[component].push(i);
        }
        self.widths = members.iter().map(|list| box_width(&mut list.iter().copied())).collect();
        let all = box_width(&mut (0..network.order()));
        if self.start.is_some() {
            self.wanted_length = (self.wanted_length * 2).min(LONGEST);
        }
        // An epoch in which birds move about as far as the radius costs least.
        let usual = if all > 0.0 { (1.0 / all) as u64 } else { LONGEST };
        self.length = self.wanted_length.max(usual).clamp(1, LONGEST);
        self.start = Some(balls.time);
        self.due.clear();
        self.due.resize(self.length as usize, Vec::new());
        let largest = positions.iter().fold(1.0f64, |most, x| most.max(x.abs()));
        let error = 4.0 * (position_error + SLACK * 1e-3 * largest) + 4.0 * velocity_error;
        let reach = (1.0 + self.length as f64 * all) * (1.0 + SLACK) + error * 4.0 + SLACK;
        let (mut now, mut moved) = (vec![0.0; dimension], vec![0.0; dimension]);
        let mut look = |i: usize, j: usize, joined: bool| {
            for k in 0..dimension {
                now[k] = positions[i * dimension + k] - positions[j * dimension + k];
                moved[k] = velocities[i * dimension + k] - velocities[j * dimension + k];
            }
            let pair = (i.min(j) as u32, i.max(j) as u32);
            let steps = self.quiet(pair, &now, &moved, joined, error);
            self.put(pair, steps);
        };
        for i in 0..network.order() {
            for &j in balls.links.near(i).iter().filter(|&&j| (j as usize) > i) {
                look(i, j as usize, true);
            }
        }
        for (i, j) in close_pairs(&positions, dimension, reach) {
            if !network.has_edge(i, j) {
                look(i, j, false);
            }
        }
    }
}

/// All pairs at a distance below the reach, and others too.
fn close_pairs(positions: &[f64], dimension: usize, reach: f64) -> Vec<(usize, usize)> {
    let birds = positions.len() / dimension;
    let point = |i: usize| {
        let at = |k: usize| if k < dimension { positions[i * dimension + k] } else { 0.0 };
        [at(0), at(1)]
    };
    let points: Vec<[f64; 2]> = (0..birds).map(point).collect();
    match CellList::new(&points, reach) {
        Ok(list) if birds > 16 => list.pairs(),
        // Without cells: all.
        _ => (0..birds).flat_map(|j| (0..j).map(move |i| (i, j))).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::super::links::Links;
    use super::*;
    use crate::averaging::{Flock, Hysteresis, Start, Weights};
    use arithmetic::random::{generator, uniform};
    use arithmetic::rational;

    const EVER: u64 = u64::MAX;

    /// By hand: a joined pair parts at most as fast as it moves and drifts; another one comes as near as its tangent says, less what it
    /// drifts. The quotients are no whole numbers.
    #[test]
    fn steps_without_a_change_are_distances_over_rates() {
        let nothing = f64::NAN;
        for (now, moved, joined, drift, error, known) in [
            ([0.45, 0.0], [0.1, 0.0], true, 0.0, 0.0, 5),
            ([0.27, 0.36], [0.0, -0.1], true, 0.0, 0.0, 5),
            ([0.45, 0.0], [0.06, 0.08], true, 0.1, 0.0, 2),
            ([0.45, 0.0], [0.1, 0.0], true, 0.0, 0.06, 4),
            ([0.45, 0.0], [0.0, 0.0], true, 0.0, 0.0, EVER),
            ([0.0, 0.0], [0.3, 0.0], true, 0.0, 0.0, 3),
            // Joined by hysteresis, beyond the distance.
            ([1.2, 0.0], [0.0, 0.0], true, 0.0, 0.0, 0),
            ([1.2, 0.0], [0.1, 0.0], true, 0.0, 0.0, 0),
            ([1.55, 0.0], [-0.1, 0.0], false, 0.0, 0.0, 5),
            ([0.93, 1.24], [-0.06, -0.08], false, 0.0, 0.0, 5),
            ([1.55, 0.0], [-0.1, 0.0], false, 0.1, 0.0, 2),
            ([1.55, 0.0], [-0.1, 0.0], false, 0.0, 0.06, 4),
            ([1.55, 0.0], [0.1, 0.0], false, 0.0, 0.0, EVER),
            ([1.55, 0.0], [0.1, 0.0], false, 0.05, 0.0, EVER),
            ([1.55, 0.0], [0.1, 0.0], false, 0.2, 0.0, 5),
            ([1.550_000_5, 0.0], [-1e-6, 0.0], false, 0.0, 0.0, 550_000),
            // Rounding is doubted on both sides of the distance.
            ([1.0 + 1e-9, 0.0], [-1e-12, 0.0], false, 0.0, 0.0, 0),
            ([1.0 - 1e-9, 0.0], [1e-12, 0.0], true, 0.0, 0.0, 0),
            ([nothing, 0.0], [0.0, 0.0], true, 0.0, 0.0, 0),
            ([0.45, 0.0], [nothing, 0.0], true, 0.0, 0.0, 0),
            ([0.0, 0.0], [-0.1, 0.0], false, 0.0, 0.0, 0),
        ] {
            assert_eq!(
                quiet_steps(&now, &moved, joined, drift, error),
                known,
                "{now:?} {moved:?} {joined} {drift} {error}"
            );
        }
    }

    /// Birds on the line in hundredths.
    fn on_the_line(places: &[i64], speeds: &[i64]) -> (Balls<2>, Graph, Flock) {
        let hundredths = |list: &[i64]| list.iter().map(|&x| rational(x, 100)).collect();
        let start = Start::on_the_line(hundredths(places), hundredths(speeds), Weights::Lazy, Hysteresis::None);
        let flock = Flock::new(&start).expect("a flock");
        let links = Links::new(flock.network());
        let balls = Balls::new(&flock.integers(), links, flock.weights(), (0, 0)).expect("weights").expect("room");
        (balls, flock.network().clone(), flock)
    }

    /// The pairs of each step of the first epoch, without what is looked at again, and the number of the first step with a switch.
    fn first_epoch(places: &[i64], speeds: &[i64]) -> (Vec<Vec<(u32, u32)>>, Option<usize>) {
        let (mut balls, network, mut flock) = on_the_line(places, speeds);
        let mut watch = Watch::default();
        let mut lists = vec![watch.due(&balls, &network, &Classes::default())];
        let length = watch.length as usize;
        let switch = (0..length).find(|_| flock.step().expect("a step").is_some());
        for _ in 1..length {
            balls.step(&[]).expect("a step");
            let mut list = watch.due(&balls, &network, &Classes::default());
            list.sort_unstable();
            lists.push(list);
        }
        (lists, switch)
    }

    /// By hand: lengths of epochs are 1 over the width of all velocities, and pairs are due in the first step that could change them.
    #[test]
    fn pairs_are_due_when_they_could_first_change() {
        type Line = &'static [i64];
        type Due = &'static [(usize, (u32, u32))];
        type Case = (Line, Line, usize, Due, Option<usize>);
        let cases: [Case; 6] = [
            // 65 at a rate of 24.
            (&[0, 165], &[12, -12], 4, &[(2, (0, 1))], Some(2)),
            // Joined: 75 at a rate of 12 and twice the width 12.
            (&[0, 25], &[0, 12], 8, &[(2, (0, 1))], None),
            // A pair of width 6 and one alone: 50 at 6 + 12, 32 at 6 + 6, 82 at 6. In n steps the second bird moves
            // 3 (n + 3/4) or nearly so, and is 32 nearer after the tenth.
            (&[0, 50, 182], &[0, 6, 0], 16, &[(2, (0, 1)), (2, (1, 2)), (13, (0, 2))], Some(9)),
            // The same with the numbers the other way round, mirrored.
            (&[182, 50, 0], &[0, 6, 0], 16, &[(2, (0, 1)), (2, (1, 2)), (13, (0, 2))], Some(9)),
            // Too far for this epoch, and away from each other.
            (&[0, 1000, 9000], &[12, -12, 12], 4, &[], None),
            // Faster than the radius in a step.
            (&[0, 1000], &[-60, 80], 1, &[], None),
        ];
        for (places, speeds, length, due, switch) in cases {
            let (lists, first) = first_epoch(places, speeds);
            let found: Vec<(usize, (u32, u32))> =
                lists.iter().enumerate().flat_map(|(step, list)| list.iter().map(move |&pair| (step, pair))).collect();
            assert_eq!((lists.len(), &found[..], first), (length, due, switch), "{places:?} {speeds:?}");
        }
        // Where all velocities agree an epoch is as long as it may be.
        let (balls, network, _) = on_the_line(&[0, 50, 1000], &[1, 1, 1]);
        let mut watch = Watch::default();
        watch.due(&balls, &network, &Classes::default());
        assert_eq!((watch.length, watch.due.len() as u64), (LONGEST, LONGEST));
    }

    /// A pair at the distance 1 is due in every step, unless its whole flock is known to move alike.
    #[test]
    fn flocks_that_move_alike_are_not_looked_at() {
        let (balls, network, _) = on_the_line(&[0, 100, 900], &[1, 1, 1]);
        let due = |classes: &Classes| Watch::default().due(&balls, &network, classes);
        assert_eq!(due(&Classes::default()), [(0, 1)]);
        let mut classes = Classes::default();
        classes.note((0, 1), || vec![4, 4, 5]);
        assert_eq!(due(&classes), []);
    }

    /// A pair that joins two flocks ends the epoch, one of the same flock does not.
    #[test]
    fn epochs_end_where_flocks_meet() {
        let (balls, network, _) = on_the_line(&[0, 50, 182], &[0, 6, 0]);
        let mut watch = Watch::default();
        watch.due(&balls, &network, &Classes::default());
        watch.note_joined((0, 1));
        assert_eq!(watch.start, Some(0));
        watch.note_joined((1, 2));
        assert_eq!(watch.start, None);
    }

    /// All pairs below the reach, each once, with cells and without; all there are where the reach is no number.
    #[test]
    fn close_pairs_are_all_pairs_below_the_reach() {
        let mut random = generator("watch", "close pairs", 0);
        for (birds, dimension) in [(10, 2), (40, 1), (40, 2), (40, 3)] {
            let positions: Vec<f64> = (0..birds * dimension).map(|_| 8.0 * uniform(&mut random)).collect();
            let distance = |i: usize, j: usize| {
                let square = |k: usize| (positions[i * dimension + k] - positions[j * dimension + k]).powi(2);
                (0..dimension).map(square).sum::<f64>().sqrt()
            };
            for reach in [1.0, 2.5, f64::INFINITY, f64::NAN] {
                let mut found = close_pairs(&positions, dimension, reach);
                found.iter_mut().for_each(|(i, j)| (*i, *j) = (*i.min(j), *i.max(j)));
                found.sort_unstable();
                assert!(found.windows(2).all(|two| two[0] != two[1]));
                for (i, j) in (0..birds).flat_map(|j| (0..j).map(move |i| (i, j))) {
                    let close = !reach.is_finite() || distance(i, j) < reach;
                    assert!(!close || found.binary_search(&(i, j)).is_ok(), "{i} {j} {reach} {dimension}");
                }
            }
        }
    }
}
