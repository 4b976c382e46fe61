//! Birds in boxes, halved again and again: which pairs may come within a distance, without a look at all of them.

/// Birds in a box that is not halved any more.
const FEW: usize = 8;

/// Bounds of something of every bird, coordinates of a bird next to each other.
#[derive(Clone, Copy)]
pub(super) struct Between<'a> {
    pub lowest: &'a [f64],
    pub highest: &'a [f64],
}

impl<'a> Between<'a> {
    /// What is known to be this.
    pub fn exactly(numbers: &'a [f64]) -> Self {
        Between { lowest: numbers, highest: numbers }
    }
}

/// A tree of boxes, each with the bounds of the positions of its birds and of whatever else is given. Two boxes are looked at once, not each
/// pair in them.
pub(super) struct Boxes {
    dimension: usize,
    /// The birds, those of a box next to each other.
    birds: Vec<u32>,
    /// The first half of a box that is halved comes next after it.
    nodes: Vec<Node>,
    /// For each node and each of the bounds that are given the lowest of all coordinates and then the highest.
    bounds: Vec<f64>,
    /// Of a node.
    width: usize,
}

struct Node {
    from: usize,
    to: usize,
    /// The second half; 0 where the box is not halved.
    second: usize,
}

/// A box in a tree.
pub(super) type Place = usize;

impl Boxes {
    /// The boxes of these birds; the first bounds are those of positions, by which they are halved.
    pub fn new(dimension: usize, given: &[Between<'_>], birds: Vec<u32>) -> Self {
        let count = birds.len();
        let width = 2 * dimension * given.len();
        let mut boxes = Boxes { dimension, birds, nodes: Vec::new(), bounds: Vec::new(), width };
        if count > 0 {
            boxes.halve(given, 0, count);
        }
        boxes
    }

    fn halve(&mut self, given: &[Between<'_>], from: usize, to: usize) -> Place {
        let d = self.dimension;
        let place = self.nodes.len();
        self.nodes.push(Node { from, to, second: 0 });
        let start = self.bounds.len();
        for both in given {
            for k in 0..d {
                let numbers = self.birds[from..to].iter().map(|&i| both.lowest[i as usize * d + k]);
                self.bounds.push(numbers.fold(f64::INFINITY, |a, b| if b < a || b.is_nan() { b } else { a }));
            }
            for k in 0..d {
                let numbers = self.birds[from..to].iter().map(|&i| both.highest[i as usize * d + k]);
                self.bounds.push(numbers.fold(f64::NEG_INFINITY, |a, b| if b > a || b.is_nan() { b } else { a }));
            }
        }
        if to - from > FEW {
            let side = |k: usize| self.bounds[start + d + k] - self.bounds[start + k];
            let longest = (0..d).fold(0, |best, k| if side(k) > side(best) { k } else { best });
            let middle = (to - from) / 2;
            let key = |&i: &u32| given[0].lowest[i as usize * d + longest];
            // Those in the same place by their number, so that the boxes do not depend on how this is done.
            self.birds[from..to]
                .select_nth_unstable_by(middle, |a, b| key(a).total_cmp(&key(b)).then_with(|| a.cmp(b)));
            self.halve(given, from, from + middle);
            let second = self.halve(given, from + middle, to);
            self.nodes[place].second = second;
        }
        place
    }

    /// The birds of a box.
    pub fn birds(&self, place: Place) -> &[u32] {
        let node = &self.nodes[place];
        &self.birds[node.from..node.to]
    }

    /// The least and the greatest of what coordinate `k` of the difference can be, for one bird in the first box and one in the second.
    fn difference(&self, (a, b): (Place, Place), given: usize, k: usize) -> (f64, f64) {
        let d = self.dimension;
        let at = |place: Place, end: usize| self.bounds[self.width * place + (2 * given + end) * d + k];
        (at(a, 0) - at(b, 1), at(a, 1) - at(b, 0))
    }

    /// Whether no bird of the first box comes within `reach` of one of the second in so many steps, with velocities within the second bounds.
    pub fn stay_apart(&self, places: (Place, Place), reach: f64, steps: f64) -> bool {
        let mut squared = 0.0;
        for k in 0..self.dimension {
            let (mut least, mut most) = self.difference(places, 0, k);
            if steps > 0.0 {
                let (slowest, fastest) = self.difference(places, 1, k);
                (least, most) = (least + (steps * slowest).min(0.0), most + (steps * fastest).max(0.0));
            }
            let gap = least.max(-most).max(0.0);
            squared += gap * gap;
        }
        squared > reach * reach
    }

    /// The earliest time at which a bird of the first box may be within `reach` of one of the second, on straight ways from positions within
    /// the bounds `from` at velocities within `by`; infinite where none ever is.
    pub fn earliest(&self, places: (Place, Place), (from, by): (usize, usize), reach: f64) -> f64 {
        let (mut first, mut last) = (0.0f64, f64::INFINITY);
        for k in 0..self.dimension {
            let (least, most) = self.difference(places, from, k);
            let (slowest, fastest) = self.difference(places, by, k);
            // The times with least + s slowest <= reach and most + s fastest >= -reach.
            for (gap, closing) in [(least - reach, -slowest), (-most - reach, fastest)] {
                if gap > 0.0 {
                    first = if closing > 0.0 { first.max(gap / closing) } else { f64::INFINITY };
                } else if closing < 0.0 {
                    last = last.min(gap / closing);
                }
            }
        }
        // Times are rounded.
        if first * (1.0 - 1e-9) > last { f64::INFINITY } else { first * (1.0 - 1e-9) }
    }

    /// Visits every pair of birds, each once, but for those in pairs of boxes that are `far` apart (a box is not far from itself).
    pub fn pairs(&self, mut far: impl FnMut((Place, Place)) -> bool, mut each: impl FnMut(u32, u32)) {
        let mut open = Vec::new();
        if !self.nodes.is_empty() {
            open.push((0, 0));
        }
        while let Some((a, b)) = open.pop() {
            let (first, second) = (&self.nodes[a], &self.nodes[b]);
            if a == b {
                if first.second == 0 {
                    let birds = self.birds(a);
                    birds.iter().enumerate().for_each(|(k, &i)| birds[..k].iter().for_each(|&j| each(i, j)));
                } else {
                    open.extend([(a + 1, a + 1), (first.second, first.second), (a + 1, first.second)]);
                }
                continue;
            }
            if far((a, b)) {
                continue;
            }
            if first.second == 0 && second.second == 0 {
                self.birds(a).iter().for_each(|&i| self.birds(b).iter().for_each(|&j| each(i, j)));
            } else if first.to - first.from >= second.to - second.from && first.second != 0 || second.second == 0 {
                open.extend([(a + 1, b), (first.second, b)]);
            } else {
                open.extend([(a, b + 1), (a, second.second)]);
            }
        }
    }

    /// Visits all pairs of birds at a distance up to `reach` now, each once, and others too.
    pub fn near_pairs(&self, reach: f64, each: impl FnMut(u32, u32)) {
        self.pairs(|places| self.stay_apart(places, reach, 0.0), each);
    }
}

/// The boxes of points that stay where they are.
pub(super) fn of_points(dimension: usize, positions: &[f64], birds: Vec<u32>) -> Boxes {
    Boxes::new(dimension, &[Between::exactly(positions)], birds)
}

#[cfg(test)]
mod tests {
    use super::*;
    use arithmetic::random::{generator, uniform};

    fn distance(dimension: usize, positions: &[f64], i: u32, j: u32) -> f64 {
        let (i, j) = (i as usize * dimension, j as usize * dimension);
        (0..dimension).map(|k| (positions[i + k] - positions[j + k]).powi(2)).sum::<f64>().sqrt()
    }

    fn found(boxes: &Boxes, far: impl FnMut((Place, Place)) -> bool) -> Vec<(u32, u32)> {
        let mut pairs = Vec::new();
        boxes.pairs(far, |i, j| pairs.push((i.min(j), i.max(j))));
        pairs.sort_unstable();
        pairs
    }

    /// All pairs where nothing is far, each once; with a reach all below it, also where many are in one place.
    #[test]
    fn near_pairs_are_all_pairs_below_the_reach() {
        let mut random = generator("boxes", "near pairs", 0);
        for (birds, dimension, sorts) in
            [(0, 2, 9), (1, 1, 9), (9, 2, 9), (60, 1, 9), (60, 2, 9), (60, 3, 2), (60, 5, 3)]
        {
            let positions: Vec<f64> =
                (0..birds * dimension).map(|_| (sorts as f64 * uniform(&mut random)).floor() * 0.7).collect();
            let boxes = of_points(dimension, &positions, (0..birds as u32).collect());
            let all: Vec<(u32, u32)> =
                (0..birds as u32).flat_map(|i| (i + 1..birds as u32).map(move |j| (i, j))).collect();
            assert_eq!(found(&boxes, |_| false), all);
            for reach in [0.5, 1.4, f64::INFINITY] {
                let mut pairs = Vec::new();
                boxes.near_pairs(reach, |i, j| pairs.push((i.min(j), i.max(j))));
                pairs.sort_unstable();
                assert!(pairs.windows(2).all(|two| two[0] != two[1]));
                for &(i, j) in all.iter().filter(|&&(i, j)| distance(dimension, &positions, i, j) <= reach) {
                    assert!(pairs.binary_search(&(i, j)).is_ok(), "{i} {j} {reach}");
                }
                assert!(reach > 1.0 || birds < 60 || dimension > 2 || pairs.len() < all.len() / 2);
            }
        }
    }

    /// Whoever comes within the reach in some step is found.
    #[test]
    fn boxes_stay_apart_as_long_as_all_their_birds_do() {
        let mut random = generator("boxes", "moving", 0);
        let (birds, dimension) = (80, 2);
        let mut number = |scale: f64| scale * (2.0 * uniform(&mut random) - 1.0);
        let positions: Vec<f64> = (0..birds * dimension).map(|_| number(20.0)).collect();
        let slowest: Vec<f64> = (0..birds * dimension).map(|_| number(0.3)).collect();
        let fastest: Vec<f64> = slowest.iter().map(|v| v + number(0.05).abs()).collect();
        let given = [Between::exactly(&positions), Between { lowest: &slowest, highest: &fastest }];
        let boxes = Boxes::new(dimension, &given, (0..birds as u32).collect());
        let steps = 30;
        let pairs = found(&boxes, |places| boxes.stay_apart(places, 1.0, f64::from(steps)));
        assert!(pairs.len() < birds * (birds - 1) / 2 * 9 / 10);
        let earliest = |s: f64| found(&boxes, |places| boxes.earliest(places, (0, 1), 1.0) > s);
        let by_time: Vec<_> = (0..=steps).map(|s| earliest(f64::from(s))).collect();
        assert!(by_time[0].len() < by_time[30].len() && by_time[30].len() < pairs.len() * 2);
        let mut near = 0;
        for share in [0.0, 0.3, 1.0] {
            for s in 0..=steps {
                let at = |k: usize| positions[k] + f64::from(s) * (slowest[k] + share * (fastest[k] - slowest[k]));
                let now: Vec<f64> = (0..positions.len()).map(at).collect();
                for (i, j) in (0..birds as u32).flat_map(|j| (0..j).map(move |i| (i, j))) {
                    if distance(dimension, &now, i, j) <= 1.0 {
                        assert!(pairs.binary_search(&(i, j)).is_ok(), "{i} {j} at {s}");
                        assert!(by_time[s as usize].binary_search(&(i, j)).is_ok(), "{i} {j} at {s}");
                        near += 1;
                    }
                }
            }
        }
        assert!(near > 100, "{near}");
    }
}
