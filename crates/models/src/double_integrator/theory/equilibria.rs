//! Configurations at rest on a fixed graph: searched for in floats, then proved to exist and classified by intervals.

use super::linearisation::hessian;
use crate::double_integrator::laws::{
    Coordinates, Pair, Potential, Vector, difference, potential_energy, potential_gradients,
};
use algebra::faer::Mat;
use algebra::matrix::floating::{SymmetricEigen, symmetric_eigen};
use algebra::matrix::{Inertia, inertia};
use arithmetic::random::uniform;
use arithmetic::{ArithmeticError, Dyadic, Field, Interval, Ring};
use rand_chacha::ChaCha8Rng;

const PLANE: Coordinates = Coordinates::Cartesian;

/// Bits of the intervals.
const PRECISION: u32 = 80;
/// Half the side of the box in which an equilibrium is proved.
const BOX: f64 = 1e-9;
/// A gradient below this ends a search.
const AT_REST: f64 = 1e-11;
const MOST_STEPS: usize = 400;
/// Longest step of a descent.
const LONGEST: f64 = 0.5;
/// An eigenvalue of a Hessian below this counts as zero. In floats the zeros of translations and rotations are about `1e-14`.
pub const FLAT: f64 = 1e-6;

/// A potential on the links of a graph.
#[derive(Debug, Clone)]
pub struct Framework {
    /// The links.
    pub edges: Vec<Pair>,
    /// The potential of each.
    pub potential: Potential,
}

/// A critical configuration in floats.
#[derive(Debug, Clone, PartialEq)]
pub struct Equilibrium {
    /// Where the agents are.
    pub positions: Vec<Vector<f64>>,
    /// The sum of the potentials.
    pub energy: f64,
    /// Signs of the eigenvalues of the Hessian; zero means below [`FLAT`] in floats.
    pub inertia: Inertia,
}

impl Framework {
    /// The gradient of the potential, `x_1, y_1, x_2, ...`.
    fn gradient<T: Field>(&self, positions: &[Vector<T>]) -> Result<Vec<T>, ArithmeticError> {
        let slope = self.potential.slope_over(&positions[0][0]);
        let gradients = potential_gradients(positions, &self.edges, PLANE, |_, _, s| slope.at(s))?;
        Ok(gradients.into_iter().flatten().collect())
    }

    fn float_gradient(&self, positions: &[Vector<f64>]) -> Option<Vec<f64>> {
        let gradient = self.gradient(positions).ok()?;
        gradient.iter().all(|x| x.is_finite()).then_some(gradient)
    }

    /// The Hessian in floats.
    ///
    /// # Errors
    /// [`ArithmeticError::DivisionByZero`] where linked agents coincide.
    pub fn float_hessian(&self, positions: &[Vector<f64>]) -> Result<Mat<f64>, ArithmeticError> {
        let rows = hessian(positions, &self.edges, PLANE, &self.potential)?;
        Ok(Mat::from_fn(rows.len(), rows.len(), |i, j| rows[i][j]))
    }

    fn energy(&self, positions: &[Vector<f64>]) -> Option<f64> {
        potential_energy(positions, &self.edges, PLANE, |_, _, s| self.potential.value(s))
            .ok()
            .filter(|e| e.is_finite())
    }

    /// Goes down from a start to a minimum, by Newton's steps with the absolute values of the curvatures; `None` where it
    /// does not come to rest.
    pub fn descend(&self, start: &[Vector<f64>]) -> Option<Equilibrium> {
        let mut positions = start.to_vec();
        let mut energy = self.energy(&positions)?;
        for _ in 0..MOST_STEPS {
            let gradient = self.float_gradient(&positions)?;
            if norm(&gradient) < AT_REST {
                break;
            }
            let size = norm(&gradient);
            let eigen = symmetric_eigen(&self.float_hessian(&positions).ok()?).ok()?;
            let step = along_axes(&eigen, &gradient, |g, curvature| -g / (curvature.abs() + 1e-3 * size));
            let mut length = (LONGEST / largest(&step)).min(1.0);
            // Halve until the energy does not rise, up to the rounding of the energy itself.
            let next = loop {
                let moved = moved(&positions, &step, length);
                match self.energy(&moved) {
                    Some(e) if e <= energy + 1e-14 * energy.abs() => break Some((moved, e)),
                    _ if length < 1e-12 => break None,
                    _ => length /= 2.0,
                }
            };
            let Some((moved, e)) = next else { break };
            (positions, energy) = (moved, e);
        }
        self.at_rest(positions)
    }

    /// Goes from a start to a critical configuration of any kind, by Levenberg's and Marquardt's steps on the gradient; `None`
    /// where it does not come to one.
    pub fn approach(&self, start: &[Vector<f64>]) -> Option<Equilibrium> {
        let mut positions = start.to_vec();
        let mut gradient = self.float_gradient(&positions)?;
        let mut damping = 1.0;
        for _ in 0..MOST_STEPS {
            if norm(&gradient) < AT_REST {
                break;
            }
            let eigen = symmetric_eigen(&self.float_hessian(&positions).ok()?).ok()?;
            // Not along the rigid motions, whose curvatures are zero.
            let step = along_axes(&eigen, &gradient, |g, curvature| {
                if curvature.abs() < 1e-9 { 0.0 } else { -g * curvature / (curvature * curvature + damping) }
            });
            let moved = moved(&positions, &step, (LONGEST / largest(&step)).min(1.0));
            match self.float_gradient(&moved) {
                Some(next) if norm(&next) < norm(&gradient) => {
                    (positions, gradient, damping) = (moved, next, (damping / 4.0f64).max(1e-20));
                }
                _ if damping > 1e12 => break,
                _ => damping *= 4.0,
            }
        }
        self.at_rest(positions)
    }

    /// The configuration as an equilibrium; `None` where it is not at rest, or spread so wide that rest means little.
    fn at_rest(&self, positions: Vec<Vector<f64>>) -> Option<Equilibrium> {
        let widest = distances(&positions).last().copied().unwrap_or(0.0);
        if norm(&self.float_gradient(&positions)?) > 100.0 * AT_REST || widest > 10.0 * positions.len() as f64 {
            return None;
        }
        let eigenvalues = symmetric_eigen(&self.float_hessian(&positions).ok()?).ok()?.values;
        let count = |passes: fn(f64) -> bool| eigenvalues.iter().filter(|x| passes(**x)).count();
        let inertia =
            Inertia { positive: count(|x| x > FLAT), negative: count(|x| x < -FLAT), zero: count(|x| x.abs() <= FLAT) };
        Some(Equilibrium { energy: self.energy(&positions)?, positions, inertia })
    }

    /// Proves that there is exactly one equilibrium near this one, up to translations and rotations, and encloses the signs of its
    /// Hessian besides the three zeros of these motions; `None` where that fails, as for a configuration that can be bent.
    ///
    /// Agent 0 is put at the origin and the agent farthest from it, `k`, on the first axis. Left are `2N - 3` coordinates, and the
    /// same components of the gradient: if these vanish, all do, as gradients and torques sum to zero. Krawczyk's test in a
    /// box around the configuration; then the inertia of the Hessian over the box, in a basis of approximate eigenvectors. The
    /// space of these coordinates is a complement of the translations and rotations, so the signs are those of the whole
    /// Hessian (Sylvester).
    pub fn enclose(&self, equilibrium: &Equilibrium) -> Option<Inertia> {
        self.enclose_in(equilibrium, BOX)
    }

    /// The same in a box with half of this side.
    fn enclose_in(&self, equilibrium: &Equilibrium, half: f64) -> Option<Inertia> {
        let (mut positions, free) = gauge(&equilibrium.positions)?;
        let restricted = |rows: &[Vec<f64>]| Mat::from_fn(free.len(), free.len(), |i, j| rows[free[i]][free[j]]);
        let float = |p: &[Vector<f64>]| Some(restricted(&hessian(p, &self.edges, PLANE, &self.potential).ok()?));
        for _ in 0..3 {
            let gradient = self.float_gradient(&positions)?;
            let gradient: Vec<f64> = free.iter().map(|&i| gradient[i]).collect();
            let eigen = symmetric_eigen(&float(&positions)?).ok()?;
            let step = along_axes(&eigen, &gradient, |g, curvature| g / curvature);
            for (&index, s) in free.iter().zip(step) {
                positions[index / 2][index % 2] -= s;
            }
        }
        let eigen = symmetric_eigen(&float(&positions)?).ok()?;
        let inverse = inverse(&eigen);
        let point = |x: f64| Some(Interval::between(Dyadic::from_f64(x)?, Dyadic::from_f64(x)?, PRECISION));
        let whole = Interval::between(Dyadic::from_f64(-half)?, Dyadic::from_f64(half)?, PRECISION);
        let (mut at, mut around) = (Vec::new(), Vec::new());
        for (agent, r) in positions.iter().enumerate() {
            let exact = [point(r[0])?, point(r[1])?];
            around.push([0, 1].map(|k| match free.contains(&(2 * agent + k)) {
                true => exact[k].clone() + &whole,
                false => exact[k].clone(),
            }));
            at.push(exact);
        }
        let gradient = self.gradient(&at).ok()?;
        let rows = hessian(&around, &self.edges, PLANE, &self.potential).ok()?;
        let rows: Vec<Vec<Interval>> =
            free.iter().map(|&i| free.iter().map(|&j| rows[i][j].clone()).collect()).collect();
        let gradient: Vec<Interval> = free.iter().map(|&i| gradient[i].clone()).collect();
        let inverse = exact_rows(&inverse)?;
        let product = times(&inverse, &rows);
        for (i, (row, y)) in product.iter().zip(&inverse).enumerate() {
            let mut image = y.iter().zip(&gradient).fold(whole.zero(), |sum, (y, f)| sum - y.clone() * f);
            for (j, x) in row.iter().enumerate() {
                let unit = if i == j { x.clone() - whole.one() } else { x.clone() };
                image = image - unit * &whole;
            }
            if !whole.encloses(&image) || image.lo() == whole.lo() || image.hi() == whole.hi() {
                return None;
            }
        }
        let basis = exact_rows(&eigen.vectors)?;
        let turned: Vec<Vec<Interval>> =
            (0..free.len()).map(|j| basis.iter().map(|row| row[j].clone()).collect()).collect();
        inertia(&times(&times(&turned, &rows), &basis)).ok().filter(|found| found.zero == 0)
    }
}

/// Places even in a square of side 2: about as wide as a flock of a few agents at rest with desired distance 1, from which more
/// searches succeed than from wider ones.
pub fn random_places(count: usize, random: &mut ChaCha8Rng) -> Vec<Vector<f64>> {
    let mut even = || 2.0 * uniform(random);
    (0..count).map(|_| [even(), even()]).collect()
}

fn moved(positions: &[Vector<f64>], step: &[f64], length: f64) -> Vec<Vector<f64>> {
    positions.iter().zip(step.as_chunks().0).map(|(r, [x, y])| [r[0] + length * x, r[1] + length * y]).collect()
}

fn norm(x: &[f64]) -> f64 {
    x.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn largest(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |most, x| x.abs().max(most))
}

/// A vector whose components along the axes of a symmetric matrix are changed, each with the curvature there.
fn along_axes(eigen: &SymmetricEigen, vector: &[f64], change: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    let mut sum = vec![0.0; vector.len()];
    for (k, &curvature) in eigen.values.iter().enumerate() {
        let axis = eigen.vectors.col_as_slice(k);
        let changed = change(axis.iter().zip(vector).map(|(a, x)| a * x).sum(), curvature);
        sum.iter_mut().zip(axis).for_each(|(s, a)| *s += changed * a);
    }
    sum
}

/// The inverse of a symmetric matrix, nearly.
fn inverse(eigen: &SymmetricEigen) -> Mat<f64> {
    let (order, vectors) = (eigen.values.len(), &eigen.vectors);
    let term = |i: usize, j: usize| move |(k, value): (usize, &f64)| vectors[(i, k)] * vectors[(j, k)] / value;
    Mat::from_fn(order, order, |i, j| eigen.values.iter().enumerate().map(term(i, j)).sum())
}

/// All distances in order: equal for congruent configurations, however the agents are named.
pub fn distances(positions: &[Vector<f64>]) -> Vec<f64> {
    let pairs = (0..positions.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
    let mut all: Vec<f64> =
        pairs.map(|(i, j)| PLANE.square(&difference(&positions[i], &positions[j])).sqrt()).collect();
    all.sort_by(f64::total_cmp);
    all
}

/// One of each class of configurations with the same distances, within `1e-5`, by energy, with how often it was found.
pub fn classes(found: impl IntoIterator<Item = Equilibrium>) -> Vec<(Equilibrium, usize)> {
    let mut known: Vec<(Vec<f64>, Equilibrium, usize)> = Vec::new();
    for one in found {
        let own = distances(&one.positions);
        let same = |other: &Vec<f64>| own.iter().zip(other).all(|(a, b)| (a - b).abs() < 1e-5);
        match known.iter_mut().find(|(other, ..)| same(other)) {
            Some((.., times)) => *times += 1,
            None => known.push((own, one, 1)),
        }
    }
    let mut all: Vec<(Equilibrium, usize)> = known.into_iter().map(|(_, one, times)| (one, times)).collect();
    all.sort_by(|a, b| a.0.energy.total_cmp(&b.0.energy));
    all
}

/// The configuration with agent 0 at the origin and the farthest agent on the first axis, and the indices of the
/// coordinates that are left; `None` where all agents are in one place.
fn gauge(positions: &[Vector<f64>]) -> Option<(Vec<Vector<f64>>, Vec<usize>)> {
    let relative: Vec<Vector<f64>> = positions.iter().map(|r| difference(r, &positions[0])).collect();
    let far = (0..relative.len()).max_by(|&i, &j| PLANE.square(&relative[i]).total_cmp(&PLANE.square(&relative[j])))?;
    let [x, y] = relative[far];
    let length = x.hypot(y);
    if length < 0.1 {
        return None;
    }
    let turn = |r: &Vector<f64>| [(x * r[0] + y * r[1]) / length, (x * r[1] - y * r[0]) / length];
    let mut turned: Vec<Vector<f64>> = relative.iter().map(turn).collect();
    turned[far] = [length, 0.0];
    let free = (2..2 * positions.len()).filter(|&index| index != 2 * far + 1).collect();
    Some((turned, free))
}

/// A matrix of floats as exact intervals.
fn exact_rows(matrix: &Mat<f64>) -> Option<Vec<Vec<Interval>>> {
    let point = |x: &f64| Dyadic::from_f64(*x).map(|x| Interval::between(x.clone(), x, PRECISION));
    (0..matrix.nrows()).map(|i| (0..matrix.ncols()).map(|j| point(&matrix[(i, j)])).collect()).collect()
}

fn times(left: &[Vec<Interval>], right: &[Vec<Interval>]) -> Vec<Vec<Interval>> {
    let columns = right.first().map_or(0, Vec::len);
    let entry = |row: &[Interval], j: usize| {
        let mut products = row.iter().zip(right).map(|(a, b)| a.clone() * &b[j]);
        let first = products.next();
        first.map(|first| products.fold(first, |sum, x| sum + x))
    };
    left.iter().map(|row| (0..columns).filter_map(|j| entry(row, j)).collect()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use algebra::graph::Graph;
    use arithmetic::rational;

    fn complete(count: usize) -> Framework {
        let potential = Potential::inverse_square_log(&rational(1, 1));
        Framework { edges: Graph::complete(count).edges(), potential }
    }

    fn at(positions: Vec<Vector<f64>>) -> Equilibrium {
        Equilibrium { positions, energy: 0.0, inertia: Inertia { positive: 0, negative: 0, zero: 0 } }
    }

    /// `V = 1/r² + 2 ln r` has the second derivative `H = 6/r⁴ - 2/r²`, 4 at rest: the test is passed where `|1 - H/4| < 1` on the whole box. At
    /// the near end `1 - a` this is `H < 8`: `3/r⁴ - 1/r² = 4` gives `r² = (sqrt 49 - 1)/8 = 3/4`, so that `a < 1 - sqrt(3/4)`, but for what
    /// the intervals of `r` in numerator and denominator add.
    #[test]
    fn a_box_of_a_pair_is_as_wide_as_the_contraction_allows() {
        for (angle, shift) in [(0.0f64, 0.0), (1.0, 3.0), (2.5, -2.0), (4.0, 0.5)] {
            let (sin, cos) = angle.sin_cos();
            let pair = at(vec![[shift, 1.0], [shift + cos, 1.0 + sin]]);
            let found = |half: f64| complete(2).enclose_in(&pair, half);
            for half in [1e-12, 1e-6, 1e-2, 0.02] {
                assert_eq!(found(half), Some(Inertia { positive: 1, negative: 0, zero: 0 }), "{angle} {half}");
            }
            for half in [0.135, 0.2, 0.5, 1.5] {
                assert_eq!(found(half), None, "{angle} {half}");
            }
        }
    }

    /// Three Newton steps bring a start that is off by a thousandth into the box.
    #[test]
    fn starts_that_are_off_are_refined() {
        let a = 0.75f64.sqrt();
        let row = |off: f64| at(vec![[off - a, 0.3 * off], [0.0, 0.0], [a + off, -off]]);
        let triangle = |off: f64| at(vec![[0.0, off], [1.0 - off, off], [0.5, a + off]]);
        for angle in [0.0f64, 0.7, 2.0, 4.0] {
            let (sin, cos) = angle.sin_cos();
            let turned = |one: &Equilibrium| {
                at(one.positions.iter().map(|r| [5.0 + cos * r[0] - sin * r[1], sin * r[0] + cos * r[1]]).collect())
            };
            for off in [0.0, 1e-6, 1e-3] {
                let of =
                    |one: Equilibrium| complete(3).enclose(&turned(&one)).map(|i| (i.negative, i.zero, i.positive));
                assert_eq!(of(row(off)), Some((1, 0, 2)), "{angle} {off}");
                assert_eq!(of(triangle(off)), Some((0, 0, 3)), "{angle} {off}");
            }
        }
        // Smaller flocks too, but not all in one place.
        let small = Framework { potential: Potential::inverse_square_log(&rational(1, 49)), ..complete(2) };
        assert!(small.enclose(&at(vec![[0.0, 0.0], [1.0 / 7.0, 0.0]])).is_some());
        assert!(small.enclose(&at(vec![[1.0, 1.0], [1.0, 1.0]])).is_none());
    }

    /// A box around the triangle, until bars in it are too soft or too stiff; every coordinate has its width.
    #[test]
    fn a_box_of_a_triangle_holds_one_equilibrium() {
        let a = 0.75f64.sqrt();
        for order in [[0usize, 1, 2], [1, 2, 0], [2, 0, 1]] {
            let corners = [[0.0, 0.0], [1.0, 0.0], [0.5, a]];
            let triangle = at(order.map(|k| corners[k]).to_vec());
            for half in [1e-12, 1e-3, 5e-3] {
                assert!(complete(3).enclose_in(&triangle, half).is_some(), "{half}");
            }
            for half in [0.1, 0.3, 1.0] {
                assert!(complete(3).enclose_in(&triangle, half).is_none(), "{half}");
            }
        }
    }

    #[test]
    fn vectors_have_their_sizes() {
        assert_eq!((norm(&[3.0, -4.0]), norm(&[]), largest(&[1.0, -5.0, 2.0]), largest(&[-0.5])), (5.0, 0.0, 5.0, 0.5));
        assert_eq!(moved(&[[1.0, 2.0], [3.0, 4.0]], &[10.0, 20.0, 30.0, 40.0], 0.5), [[6.0, 12.0], [18.0, 24.0]]);
        let (turned, free) = gauge(&[[1.0, 1.0], [1.0, 3.0], [4.0, 5.0]]).expect("apart");
        // The farthest is the third, at (3, 4): the second, at (0, 2), is (8/5, 6/5) from there.
        let close = |a: Vector<f64>, b: Vector<f64>| (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-14;
        assert!(close(turned[0], [0.0, 0.0]) && close(turned[1], [1.6, 1.2]) && turned[2] == [5.0, 0.0]);
        assert_eq!(free, [2, 3, 4]);
        let (_, free) = gauge(&[[0.0, 0.0], [9.0, 1.0], [4.0, 5.0]]).expect("apart");
        assert_eq!(free, [2, 4, 5]);
        let rows = [[1.0, 2.0], [2.0, 5.0]];
        let eigen = symmetric_eigen(&Mat::from_fn(2, 2, |i, j| rows[i][j])).expect("symmetric");
        let inverse = inverse(&eigen);
        for (i, known) in [[5.0, -2.0], [-2.0, 1.0]].iter().enumerate() {
            (0..2).for_each(|j| assert!((inverse[(i, j)] - known[j]).abs() < 1e-12));
        }
        // (1, 1) times the matrix.
        let product = along_axes(&eigen, &[1.0, 1.0], |x, value| x * value);
        assert!((product[0] - 3.0).abs() < 1e-12 && (product[1] - 7.0).abs() < 1e-12, "{product:?}");
    }

    /// One distance that agrees does not make two configurations one; `1e-5` is near enough, either way.
    #[test]
    fn classes_compare_all_distances() {
        let row = |b: f64, energy: f64| Equilibrium { energy, ..at(vec![[0.0, 0.0], [1.0, 0.0], [1.0 + b, 0.0]]) };
        let found =
            classes([row(2.0, 5.0), row(3.0, 1.0), row(2.0 + 8e-6, 5.0), row(2.0 - 8e-6, 5.0), row(2.0 + 1.5e-5, 9.0)]);
        let told: Vec<(f64, usize)> = found.iter().map(|(one, times)| (one.energy, *times)).collect();
        assert_eq!(told, [(1.0, 1), (5.0, 3), (9.0, 1)]);
    }
}
