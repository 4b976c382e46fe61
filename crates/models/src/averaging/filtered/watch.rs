//! Which pairs have to be looked at, and when: a pair is looked at again only when its status could have changed.
//!
//! An epoch is a number of steps. Flocks that could meet in it form a group. Velocities of a group stay in the box that holds them at the
//! start, so the relative velocity of two birds differs from that of now by the widths of the boxes of their groups at most, and their
//! distance changes accordingly (Lemma 2.1).

use super::balls::Balls;
use super::classes::Classes;
use crate::averaging::boxes::{Between, Boxes};
use std::cell::Cell;

/// The pairs to look at, by time.
#[derive(Debug, Clone, Default)]
pub(super) struct Watch {
    /// The time at which the epoch began; none runs at the start, and where more is known about what stays.
    start: Option<u64>,
    length: u64,
    groups: Groups,
    still: Vec<bool>,
    /// The pairs to look at `1, 2, ..` steps after the start.
    due: Vec<Vec<(u32, u32)>>,
}

/// Flocks that may meet, and how fast they are.
#[derive(Debug, Clone, Default)]
struct Groups {
    /// The group of each bird.
    of: Vec<u32>,
    /// By group: a bound of how much a velocity can still change.
    widths: Vec<f64>,
    /// By bird and coordinate: bounds of the velocities of its group.
    slowest: Vec<f64>,
    fastest: Vec<f64>,
}

/// The longest epoch.
const LONGEST: u64 = 4096;

/// In an epoch the velocities of a group make no more difference than this, unless it is as short as is usual at any rate.
const WIDEST: f64 = 2.0;

/// Rounds in which flocks that may meet are found; then all are taken together.
const ROUNDS: usize = 3;

/// Rounding in double precision, generously.
const SLACK: f64 = 1e-9;

/// For how many steps at least the status of a pair cannot change: from the difference of the positions, that of the velocities of
/// the last move (or of the next), and a bound of how far later ones differ from that.
pub(super) fn quiet_steps(now: &[f64], moved: &[f64], joined: bool, drift: f64, error: f64) -> u64 {
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
        // Below the quotient; the largest number says never, which a rate above 0 does not.
        ((gap / rate * (1.0 - SLACK)) as u64).min(u64::MAX - 1)
    }
}

/// A state in double precision, coordinates of a bird next to each other.
struct Snapshot {
    dimension: usize,
    positions: Vec<f64>,
    velocities: Vec<f64>,
    /// Of a coordinate of a velocity.
    velocity_error: f64,
    /// Of a distance.
    error: f64,
}

impl Snapshot {
    fn of<const L: usize>(balls: &Balls<L>) -> Self {
        let (positions, velocities) = balls.floats();
        let (position_error, velocity_error) = balls.errors();
        let largest = positions.iter().fold(1.0f64, |most, x| most.max(x.abs()));
        // Coordinates of differences err by twice as much as those of birds.
        let root = (balls.dimension() as f64).sqrt();
        let error = 4.0 * root * (position_error + SLACK * 1e-3 * largest + velocity_error);
        Snapshot { dimension: balls.dimension(), positions, velocities, velocity_error, error }
    }

    fn birds(&self) -> usize {
        self.positions.len() / self.dimension
    }

    /// Writes the differences of the positions and of the velocities of two birds.
    fn difference(&self, i: u32, j: u32, now: &mut [f64], moved: &mut [f64]) {
        let (a, b) = (i as usize * self.dimension, j as usize * self.dimension);
        for k in 0..self.dimension {
            now[k] = self.positions[a + k] - self.positions[b + k];
            moved[k] = self.velocities[a + k] - self.velocities[b + k];
        }
    }

    /// The groups with these numbers.
    fn groups(&self, of: Vec<u32>, count: usize) -> Groups {
        let d = self.dimension;
        let mut bounds = vec![(f64::INFINITY, f64::NEG_INFINITY); count * d];
        for (v, &group) in self.velocities.chunks(d).zip(&of) {
            for (&v, (lo, hi)) in v.iter().zip(&mut bounds[group as usize * d..]) {
                (*lo, *hi) = (lo.min(v), hi.max(v));
            }
        }
        for (lo, hi) in &mut bounds {
            let more = self.velocity_error + SLACK * (hi.abs().max(lo.abs()));
            (*lo, *hi) = (*lo - more, *hi + more);
        }
        let width = |b: &[(f64, f64)]| b.iter().map(|(lo, hi)| (hi - lo).powi(2)).sum::<f64>().sqrt() * (1.0 + SLACK);
        let by_bird = |end: fn(&(f64, f64)) -> f64| -> Vec<f64> {
            of.iter().flat_map(|&group| bounds[group as usize * d..(group as usize + 1) * d].iter().map(end)).collect()
        };
        let widths = bounds.chunks(d).map(width).collect();
        Groups { widths, slowest: by_bird(|b| b.0), fastest: by_bird(|b| b.1), of }
    }

    /// The flocks with these numbers, taken together where they could meet in so many steps; all of them after so many rounds, or looks at
    /// pairs of boxes or birds.
    fn joined(&self, flocks: (Vec<u32>, usize), length: u64, (rounds, most): (usize, usize)) -> (Groups, Boxes) {
        let looks = Cell::new(0);
        let enough = || {
            looks.set(looks.get() + 1);
            looks.get() > most
        };
        let (mut of, mut count) = flocks;
        let (mut now, mut moved) = (vec![0.0; self.dimension], vec![0.0; self.dimension]);
        for round in 0.. {
            let groups = self.groups(of, count);
            let boxes = self.boxes(&groups);
            let mut union: Vec<u32> = (0..count as u32).collect();
            boxes.pairs(
                |places| enough() || self.are_far(&boxes, places, length) || groups.share_one(&boxes, places),
                |i, j| {
                    let (f, g) = (root(&mut union, groups.of[i as usize]), root(&mut union, groups.of[j as usize]));
                    if !enough() && f != g {
                        self.difference(i, j, &mut now, &mut moved);
                        let quiet = quiet_steps(&now, &moved, false, groups.drift(i, j), self.error);
                        if quiet < length && !self.part_for_ever(&groups, (i, j), &now) {
                            union[f.max(g) as usize] = f.min(g);
                        }
                    }
                },
            );
            // The numbers of those that stay.
            let mut next = 0;
            let names: Vec<u32> = (0..count as u32)
                .map(|group| {
                    let name = next;
                    next += u32::from(union[group as usize] == group);
                    name
                })
                .collect();
            if next as usize == count && looks.get() <= most {
                return (groups, boxes);
            }
            of = groups.of.iter().map(|&group| names[root(&mut union, group) as usize]).collect();
            count = next as usize;
            if round + 1 >= rounds || looks.get() > most {
                (of, count) = (vec![0; self.birds()], 1);
                looks.set(0);
            }
        }
        unreachable!("the number of groups falls")
    }

    /// Whether no velocities of the groups of two birds take these nearer to one another: along the line between them, by the bounds of each
    /// coordinate.
    fn part_for_ever(&self, groups: &Groups, (i, j): (u32, u32), now: &[f64]) -> bool {
        let distance = now.iter().map(|x| x * x).sum::<f64>().sqrt();
        let (a, b) = (i as usize * self.dimension, j as usize * self.dimension);
        let closing = |(k, x): (usize, &f64)| {
            let slowest = groups.slowest[a + k] - groups.fastest[b + k];
            let fastest = groups.fastest[a + k] - groups.slowest[b + k];
            let along = x / distance;
            (-along * slowest).max(-along * fastest) + SLACK * slowest.abs().max(fastest.abs())
        };
        distance - 1.0 > SLACK * (1.0 + distance) + self.error && now.iter().enumerate().map(closing).sum::<f64>() < 0.0
    }

    fn boxes(&self, groups: &Groups) -> Boxes {
        let velocities = Between { lowest: &groups.slowest, highest: &groups.fastest };
        let given = [Between::exactly(&self.positions), velocities];
        Boxes::new(self.dimension, &given, (0..self.birds() as u32).collect())
    }

    /// Whether two boxes are out of reach of each other in so many steps.
    fn are_far(&self, boxes: &Boxes, places: (usize, usize), length: u64) -> bool {
        let steps = if length == u64::MAX { f64::INFINITY } else { length as f64 };
        boxes.stay_apart(places, (1.0 + 4.0 * self.error) * (1.0 + SLACK) + SLACK, steps)
    }
}

/// Rounds, and looks for each bird, after which flocks that never meet are not told apart any longer.
const ROUNDS_FOR_EVER: usize = 32;
const LOOKS_FOR_EVER: usize = 256;

/// Flocks in groups that never meet, whatever happens in each of them: the group of each bird, and their number.
pub(super) fn groups_for_ever<const L: usize>(balls: &Balls<L>) -> (Vec<u32>, usize) {
    let most = (ROUNDS_FOR_EVER, LOOKS_FOR_EVER * balls.network.order());
    let (groups, _) = Snapshot::of(balls).joined(balls.network.component_numbers(), u64::MAX, most);
    (groups.of, groups.widths.len())
}

/// The number that stands for a group; the way there is halved.
fn root(union: &mut [u32], mut group: u32) -> u32 {
    while union[group as usize] != group {
        union[group as usize] = union[union[group as usize] as usize];
        group = union[group as usize];
    }
    group
}

impl Groups {
    /// How far the relative velocity of two birds can get from that of now.
    fn drift(&self, i: u32, j: u32) -> f64 {
        let width = |bird: u32| self.widths[self.of[bird as usize] as usize];
        width(i) + width(j)
    }

    /// Whether all birds of two boxes are of one group.
    fn share_one(&self, boxes: &Boxes, (a, b): (usize, usize)) -> bool {
        let group = |bird: &u32| self.of[*bird as usize];
        let first = group(&boxes.birds(a)[0]);
        boxes.birds(a).iter().chain(boxes.birds(b)).all(|bird| group(bird) == first)
    }

    fn widest(&self) -> f64 {
        self.widths.iter().fold(0.0, |most: f64, &width| most.max(width))
    }
}

impl Watch {
    /// The pairs to look at in the next step.
    pub fn due<const L: usize>(&mut self, balls: &Balls<L>, classes: &Classes) -> Vec<(u32, u32)> {
        let running = self.start.is_some_and(|start| balls.time < start + self.length);
        if !running {
            self.begin(balls, classes);
        }
        let step = (balls.time - self.start.unwrap_or(balls.time)) as usize;
        self.due.get_mut(step).map(std::mem::take).unwrap_or_default()
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
        let (f, g) = (self.groups.of[i as usize], self.groups.of[j as usize]);
        if f == g && self.still[f as usize] {
            // The two move alike for ever.
            return u64::MAX;
        }
        quiet_steps(now, moved, joined, self.groups.drift(i, j), error)
    }

    fn put(&mut self, pair: (u32, u32), place: u64) {
        if let Some(list) = usize::try_from(place).ok().and_then(|place| self.due.get_mut(place)) {
            list.push(pair);
        }
    }

    /// A new epoch from the state of now on.
    fn begin<const L: usize>(&mut self, balls: &Balls<L>, classes: &Classes) {
        let state = Snapshot::of(balls);
        let flocks = balls.network.component_numbers();
        let all = state.groups(vec![0; state.birds()], 1).widest();
        // An epoch in which birds move about as far as the radius costs least.
        let usual = if all > 0.0 { (1.0 / all) as u64 } else { LONGEST };
        let usual = usual.clamp(1, LONGEST);
        // As long as its groups are narrow it may be longer.
        let mut length = if self.start.is_some() { (self.length * 2).clamp(usual, LONGEST) } else { usual };
        let (groups, boxes) = loop {
            let (groups, boxes) = state.joined(flocks.clone(), length, (ROUNDS, usize::MAX));
            if length == usual || groups.widest() * length as f64 <= WIDEST {
                break (groups, boxes);
            }
            length = (length / 2).max(usual);
        };
        self.still = classes.is_still(&groups.of, groups.widths.len());
        self.groups = groups;
        self.length = length;
        self.start = Some(balls.time);
        self.due.iter_mut().for_each(Vec::clear);
        self.due.resize(length as usize, Vec::new());
        let (mut now, mut moved) = (vec![0.0; state.dimension], vec![0.0; state.dimension]);
        let mut look = |i: u32, j: u32, joined: bool| {
            state.difference(i, j, &mut now, &mut moved);
            let pair = (i.min(j), i.max(j));
            let steps = self.quiet(pair, &now, &moved, joined, state.error);
            self.put(pair, steps);
        };
        for i in 0..balls.network.order() as u32 {
            for &j in balls.network.neighbours(i as usize).iter().filter(|&&j| j > i) {
                look(i, j, true);
            }
        }
        boxes.pairs(
            |places| state.are_far(&boxes, places, length),
            |i, j| {
                if !balls.network.has_edge(i as usize, j as usize) {
                    look(i, j, false);
                }
            },
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::averaging::{Flock, Hysteresis, Start, Weights};

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
    fn on_the_line(places: &[i64], speeds: &[i64]) -> (Balls<2>, Flock) {
        let hundredths = |list: &[i64]| list.iter().map(|&x| rational(x, 100)).collect();
        let start = Start::on_the_line(hundredths(places), hundredths(speeds), Weights::Lazy, Hysteresis::None);
        let flock = Flock::new(&start).expect("a flock");
        let network = flock.network().clone();
        let balls = Balls::new(&flock.integers(), network, flock.weights(), (0, 0)).expect("weights").expect("room");
        (balls, flock)
    }

    /// The pairs of each step of the first epoch, without what is looked at again, and the number of the first step with a switch.
    fn first_epoch(places: &[i64], speeds: &[i64]) -> (Vec<Vec<(u32, u32)>>, Option<usize>) {
        let (mut balls, mut flock) = on_the_line(places, speeds);
        let mut watch = Watch::default();
        let mut lists = vec![watch.due(&balls, &Classes::default())];
        let length = watch.length as usize;
        let switch = (0..length).find(|_| flock.step().expect("a step").is_some());
        for _ in 1..length {
            balls.step(&[]).expect("a step");
            let mut list = watch.due(&balls, &Classes::default());
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
        let cases: [Case; 7] = [
            // 65 at a rate of 24, and each may change by 24 when they have met.
            (&[0, 165], &[12, -12], 4, &[(0, (0, 1))], Some(2)),
            // Joined: 75 at a rate of 12 and twice the width 12.
            (&[0, 25], &[0, 12], 8, &[(2, (0, 1))], None),
            // A pair of width 6 and one alone that it may meet, so of its width too: 50 at 6 + 12, 32 at 6 + 12, 82 at 12. In n steps the second
            // bird moves 3 (n + 3/4) or nearly so, and is 32 nearer after the tenth.
            (&[0, 50, 182], &[0, 6, 0], 16, &[(1, (1, 2)), (2, (0, 1)), (6, (0, 2))], Some(9)),
            // The same with the numbers the other way round, mirrored.
            (&[182, 50, 0], &[0, 6, 0], 16, &[(1, (0, 1)), (2, (1, 2)), (6, (0, 2))], Some(9)),
            // So far away that they cannot meet: 250 at 6 + 6 in 16 steps.
            (&[0, 50, 400], &[0, 6, 0], 16, &[(2, (0, 1))], None),
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
        let (balls, _) = on_the_line(&[0, 50, 1000], &[1, 1, 1]);
        let mut watch = Watch::default();
        watch.due(&balls, &Classes::default());
        assert_eq!((watch.length, watch.due.len() as u64), (LONGEST, LONGEST));
    }

    /// A pair at the distance 1 is due in every step, unless its whole flock is known to move alike.
    #[test]
    fn flocks_that_move_alike_are_not_looked_at() {
        let (balls, _) = on_the_line(&[0, 100, 900], &[1, 1, 1]);
        let due = |classes: &Classes| Watch::default().due(&balls, classes);
        assert_eq!(due(&Classes::default()), [(0, 1)]);
        let mut classes = Classes::default();
        classes.note((0, 1), || vec![4, 4, 5]);
        assert_eq!(due(&classes), []);
    }

    /// Flocks that may meet within the epoch are taken together, and those that may meet them; the velocities of all are counted then.
    #[test]
    fn flocks_that_may_meet_are_one_group() {
        let groups = |places: &[i64], speeds: &[i64], length: u64| {
            let (balls, _) = on_the_line(places, speeds);
            Snapshot::of(&balls).joined(balls.network.component_numbers(), length, (ROUNDS, usize::MAX)).0
        };
        // The second comes to the first after 25 steps.
        for (length, of) in [(24, [0, 1, 2]), (27, [0, 0, 1])] {
            assert_eq!(groups(&[0, 200, 9000], &[0, -4, 0], length).of, of);
        }
        // Its speed takes the first, once they are one, to the third in 25 steps more.
        let all = groups(&[0, 200, -200], &[0, -4, 0], 27);
        assert_eq!((&all.of[..], all.widths.len()), (&[0, 0, 0][..], 1));
        assert!((all.widths[0] - 0.04).abs() < 1e-9);
        assert_eq!(groups(&[0, 200, -210], &[0, -4, 0], 27).of, [0, 0, 1]);
    }
}
