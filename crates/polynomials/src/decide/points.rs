//! Points first: corners, middles, simple numbers, random ones, and where a descent leads. Floats choose, exact numbers decide.

use super::local::{self, Signs};
use crate::function::{Compared, Function, Literal, Side};
use arithmetic::{Cancelled, Progress, Rational, random, rational, simplest_between};
use num_traits::ToPrimitive;
use rand_chacha::rand_core::Rng;

/// What was seen at points.
#[derive(Debug, Default)]
pub(super) struct Seen {
    pub counterexample: Option<Vec<Rational>>,
    /// Points at which a function that may be 0 is 0.
    pub zeros: Vec<Vec<Rational>>,
}

/// Most corners.
const CORNERS: usize = 64;
const RANDOM: u64 = 96;
/// Most zeros that are kept.
const ZEROS: usize = 24;
/// Values of this size may be zero.
const NEAR: f64 = 1e-7;
/// Largest number of variables for steps with second derivatives.
const NEWTON: usize = 12;

/// How far a literal is from being false, in floats: negative where it is false. `None` where the function has no value.
pub(super) fn slack<F: Function>(literal: &Literal<F>, x: &[f64]) -> Option<f64> {
    let value = literal.function.value(x).ok().filter(|v| v.is_finite())?;
    Some(match literal.compared {
        Compared::Positive | Compared::NotNegative => value,
        Compared::Zero => -value.abs(),
        Compared::NotZero => value.abs(),
    })
}

/// The largest slack of a clause.
fn clause_slack<F: Function>(clause: &[Literal<F>], x: &[f64]) -> Option<f64> {
    clause.iter().map(|literal| slack(literal, x)).try_fold(f64::NEG_INFINITY, |most, own| own.map(|own| most.max(own)))
}

fn floats(point: &[Rational]) -> Vec<f64> {
    point.iter().map(|q| q.to_f64().unwrap_or(0.0)).collect()
}

struct Search<'a, F> {
    clause: &'a [Literal<F>],
    domain: &'a [Side],
    seen: Seen,
    looked: u32,
}

/// Exact looks at most.
const LOOKS: u32 = 600;

impl<F: Function> Search<'_, F> {
    /// Looks exactly where floats have a doubt; whether the search is over.
    fn look(&mut self, point: Vec<Rational>) -> bool {
        let point: Vec<Rational> = point.into_iter().zip(self.domain).map(|(q, side)| side.nearest(q)).collect();
        let slack = clause_slack(self.clause, &floats(&point));
        let doubtful = slack.is_none_or(|slack| slack <= NEAR);
        if !doubtful || self.looked >= LOOKS {
            return false;
        }
        self.looked += 1;
        match local::at_point(self.clause, &point) {
            Signs::Fails => {
                self.seen.counterexample = Some(point);
                return true;
            }
            Signs::Holds { zero: true } if self.seen.zeros.len() < ZEROS && !self.seen.zeros.contains(&point) => {
                self.seen.zeros.push(point);
            }
            _ => {}
        }
        false
    }

    fn corner(&self, choice: impl Fn(usize) -> bool) -> Vec<Rational> {
        let end = |(k, side): (usize, &Side)| {
            let end = if choice(k) { &side.hi } else { &side.lo };
            end.clone().unwrap_or_else(|| side.nearest(rational(if choice(k) { 1 } else { -1 }, 1)))
        };
        self.domain.iter().enumerate().map(end).collect()
    }

    fn simple(&mut self) -> bool {
        let n = self.domain.len();
        let mut list = vec![
            self.domain.iter().map(|side| side.nearest(rational(0, 1))).collect::<Vec<_>>(),
            self.domain.iter().map(Side::middle).collect(),
        ];
        if n <= 6 {
            list.extend((0..1usize << n).take(CORNERS).map(|bits| self.corner(|k| bits >> k & 1 == 1)));
        } else {
            list.extend([
                self.corner(|_| false),
                self.corner(|_| true),
                self.corner(|k| k % 2 == 0),
                self.corner(|k| k % 2 == 1),
            ]);
        }
        for (p, q) in [(1, 1), (-1, 1), (1, 2), (-1, 2), (2, 1), (-2, 1), (10, 1), (-10, 1)] {
            list.push(self.domain.iter().map(|side| side.nearest(rational(p, q))).collect());
        }
        for k in 0..n {
            for base in [0, 1] {
                let from = list[base].clone();
                for end in [true, false] {
                    let mut point = from.clone();
                    point[k] = self.corner(|_| end)[k].clone();
                    list.push(point);
                }
            }
        }
        list.into_iter().any(|point| self.look(point))
    }

    /// Of few integers all pairs, or triples, of small ones.
    fn small_integers(&mut self) -> bool {
        const MOST: usize = 3;
        let all = self.domain.iter().all(|side| side.integer || side.as_point().is_some());
        if self.domain.len() > MOST || !all {
            return false;
        }
        let mut points: Vec<Vec<Rational>> = vec![Vec::new()];
        for side in self.domain {
            let mut own: Vec<Rational> = (-6..=12).map(|k| side.nearest(rational(k, 1))).collect();
            own.dedup();
            let longer = |point: &Vec<Rational>| -> Vec<Vec<Rational>> {
                own.iter().map(|q| point.iter().chain([q]).cloned().collect()).collect()
            };
            points = points.iter().flat_map(longer).collect();
        }
        points.into_iter().any(|point| self.look(point))
    }

    fn random(&mut self) -> Vec<Vec<Rational>> {
        let mut stream = random::generator("inequality", "points", self.domain.len() as u64);
        let draw = |side: &Side, round: u64, bits: u64| {
            // Coarse grids first, whose points are often those of equality.
            let parts = [4, 8, 12, 60, 1 << 16][(round % 5) as usize];
            let share = rational((bits % (parts + 1)) as i64, parts as i64);
            match (&side.lo, &side.hi) {
                (Some(lo), Some(hi)) => lo + (hi - lo) * share,
                _ => {
                    let reach = rational([1, 3, 10, 1000][(round % 4) as usize], 1);
                    side.nearest((share * rational(2, 1) - rational(1, 1)) * reach)
                }
            }
        };
        (0..RANDOM)
            .map(|round| self.domain.iter().map(|side| draw(side, round, stream.next_u64() >> 8)).collect())
            .collect()
    }

    /// A point to which a descent leads, near the one it starts from.
    fn descend(&self, start: &[f64]) -> Vec<f64> {
        let ends: Vec<(f64, f64)> = self.domain.iter().map(Side::floats).collect();
        let scale: Vec<f64> =
            ends.iter().map(|(lo, hi)| if (hi - lo).is_finite() { (hi - lo).max(1e-9) } else { 1.0 }).collect();
        let mut x = start.to_vec();
        let Some(mut value) = clause_slack(self.clause, &x) else { return x };
        for _ in 0..40 {
            let Some(slope) = self.slope(&x) else { return x };
            let size = slope.iter().zip(&scale).map(|(g, w)| (g * w).abs()).fold(0.0, f64::max);
            if size == 0.0 || !size.is_finite() {
                break;
            }
            let mut step = 0.5 / size;
            let mut better = None;
            for _ in 0..24 {
                let next: Vec<f64> = (0..x.len())
                    .map(|k| (x[k] - step * slope[k] * scale[k] * scale[k]).clamp(ends[k].0, ends[k].1))
                    .collect();
                match clause_slack(self.clause, &next) {
                    Some(lower) if lower < value => {
                        better = Some((next, lower));
                        break;
                    }
                    _ => step *= 0.4,
                }
            }
            let Some((next, lower)) = better else { break };
            (x, value) = (next, lower);
        }
        if let [literal] = self.clause
            && x.len() <= NEWTON
        {
            local::polish(&literal.function, &mut x, &ends);
        }
        x
    }

    /// The slope of the literal that is nearest to being true.
    fn slope(&self, x: &[f64]) -> Option<Vec<f64>> {
        let slacks = self.clause.iter().map(|literal| slack(literal, x)).collect::<Option<Vec<f64>>>()?;
        let place = (0..slacks.len()).max_by(|&a, &b| slacks[a].total_cmp(&slacks[b]))?;
        let literal = &self.clause[place];
        let turned = match literal.compared {
            Compared::Zero => -literal.function.value(x).ok()?.signum(),
            Compared::NotZero => literal.function.value(x).ok()?.signum(),
            _ => 1.0,
        };
        let along = |k: usize| literal.function.value(&local::seeded(x, k)).ok().map(|value| turned * value.derivative);
        (0..x.len()).map(along).collect()
    }

    /// Looks at rationals near a point of floats.
    fn look_near(&mut self, x: &[f64]) -> bool {
        for reach in [1e-2, 1e-4, 1e-6, 0.0] {
            let near = |(x, side): (&f64, &Side)| {
                let exact = Rational::from_float(*x)?;
                let size = Rational::from_float(reach * x.abs().max(1.0))?;
                Some(side.nearest(simplest_between(&(&exact - &size), &(exact + size))))
            };
            let Some(point) = x.iter().zip(self.domain).map(near).collect::<Option<Vec<_>>>() else { return false };
            if self.look(point) {
                return true;
            }
        }
        false
    }
}

/// Looks at points until one refutes the clause.
pub(super) fn search<F: Function>(
    clause: &[Literal<F>],
    domain: &[Side],
    progress: &dyn Progress,
) -> Result<Seen, Cancelled> {
    let mut search = Search { clause, domain, seen: Seen::default(), looked: 0 };
    progress.checkpoint()?;
    if search.simple() || search.small_integers() {
        return Ok(search.seen);
    }
    let random = search.random();
    for point in &random {
        progress.checkpoint()?;
        if search.look(point.clone()) {
            return Ok(search.seen);
        }
    }
    let middle: Vec<Rational> = domain.iter().map(Side::middle).collect();
    let starts = if domain.len() > 20 { 3 } else { 10 };
    for start in std::iter::once(&middle).chain(random.iter().skip(4).step_by(5)).take(starts) {
        progress.checkpoint()?;
        let lowest = search.descend(&floats(start));
        if search.look_near(&lowest) {
            return Ok(search.seen);
        }
    }
    Ok(search.seen)
}
