//! Attempts at counterexamples to what holds of Paley's and of Tanner's papers and of our own results about them, made from the statements
//! alone: the formulas are written here once more, from the papers, in floating point. `notes/attempts-oscillators-and-particles.md`
//! lists what was tried.

mod flocks;
mod particles;
mod phases;
mod switching;

use arithmetic::random::{generator, uniform};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::{PI, TAU};
use std::ops::{Add, Mul, Neg, Sub};

pub type Random = ChaCha8Rng;

/// A search for a counterexample: `seek` draws one case and says what is wrong with it.
pub struct Attempt {
    pub name: &'static str,
    pub tries: u64,
    pub seek: fn(&mut Random) -> Option<String>,
}

/// Makes all attempts of a list; panics with the first counterexample.
pub fn survive(attempts: &[Attempt]) {
    for attempt in attempts {
        for k in 0..attempt.tries {
            let found = (attempt.seek)(&mut generator("attempts", attempt.name, k));
            assert!(found.is_none(), "{}, case {k}: {}", attempt.name, found.unwrap_or_default());
        }
    }
}

// --- Numbers ---

/// A vector of the plane, or a complex number.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Z(pub f64, pub f64);

impl Add for Z {
    type Output = Z;
    fn add(self, o: Z) -> Z {
        Z(self.0 + o.0, self.1 + o.1)
    }
}

impl Sub for Z {
    type Output = Z;
    fn sub(self, o: Z) -> Z {
        Z(self.0 - o.0, self.1 - o.1)
    }
}

impl Neg for Z {
    type Output = Z;
    fn neg(self) -> Z {
        Z(-self.0, -self.1)
    }
}

impl Mul for Z {
    type Output = Z;
    fn mul(self, o: Z) -> Z {
        Z(self.0 * o.0 - self.1 * o.1, self.0 * o.1 + self.1 * o.0)
    }
}

impl Mul<f64> for Z {
    type Output = Z;
    fn mul(self, x: f64) -> Z {
        Z(self.0 * x, self.1 * x)
    }
}

pub const I: Z = Z(0.0, 1.0);

pub fn turn(angle: f64) -> Z {
    Z(angle.cos(), angle.sin())
}

/// `<a, b>`.
pub fn dot(a: Z, b: Z) -> f64 {
    a.0 * b.0 + a.1 * b.1
}

/// `a x b`.
pub fn cross(a: Z, b: Z) -> f64 {
    a.0 * b.1 - a.1 * b.0
}

pub fn norm(a: Z) -> f64 {
    dot(a, a).sqrt()
}

pub fn mean(list: &[Z]) -> Z {
    list.iter().fold(Z::default(), |sum, z| sum + *z) * (1.0 / list.len() as f64)
}

/// Whether two numbers agree up to rounding and the error of difference quotients.
pub fn alike(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-5 * (1.0 + a.abs() + b.abs())
}

/// `what` with both numbers where they are not alike.
pub fn unlike(what: &str, a: f64, b: f64) -> Option<String> {
    (!alike(a, b)).then(|| format!("{what}: {a} and {b}"))
}

/// The angle in `(-pi, pi]`.
pub fn wrap(angle: f64) -> f64 {
    let x = angle.rem_euclid(TAU);
    if x > PI { x - TAU } else { x }
}

// --- Draws ---

pub fn between(random: &mut Random, low: f64, high: f64) -> f64 {
    low + (high - low) * uniform(random)
}

pub fn below(random: &mut Random, n: usize) -> usize {
    ((uniform(random) * n as f64) as usize).min(n.saturating_sub(1))
}

pub fn sign(random: &mut Random) -> f64 {
    if uniform(random) < 0.5 { -1.0 } else { 1.0 }
}

pub fn vectors(random: &mut Random, n: usize, size: f64) -> Vec<Z> {
    (0..n).map(|_| Z(between(random, -size, size), between(random, -size, size))).collect()
}

/// Phases: any, or equal, or multiples of a quarter or a third of a turn.
pub fn phases(random: &mut Random, n: usize) -> Vec<f64> {
    let kind = below(random, 5);
    (0..n)
        .map(|_| match kind {
            0 => 1.0,
            1 => below(random, 4) as f64 * PI / 2.0,
            2 => below(random, 3) as f64 * TAU / 3.0,
            _ => between(random, 0.0, TAU),
        })
        .collect()
}

/// All pairs, the larger number first.
pub fn pairs(n: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..n).flat_map(|k| (0..k).map(move |j| (k, j)))
}

/// Rows of 0 and 1; `adj[k][j]` where `j` is a neighbour of `k`.
pub type Graph = Vec<Vec<f64>>;

pub fn complete(n: usize) -> Graph {
    (0..n).map(|k| (0..n).map(|j| f64::from(u8::from(j != k))).collect()).collect()
}

/// Circulant with these offsets, in one direction or both.
pub fn circulant(n: usize, offsets: &[usize], both: bool) -> Graph {
    let mut graph = vec![vec![0.0; n]; n];
    for k in 0..n {
        for d in offsets.iter().filter(|d| *d % n != 0) {
            graph[k][(k + d) % n] = 1.0;
            if both {
                graph[(k + d) % n][k] = 1.0;
            }
        }
    }
    graph
}

/// An undirected graph: none, one, or any number of its edges.
pub fn undirected(random: &mut Random, n: usize) -> Graph {
    let share = [0.0, 0.3, 0.6, 1.0][below(random, 4)];
    let mut graph = vec![vec![0.0; n]; n];
    for (k, j) in pairs(n) {
        let edge = f64::from(u8::from(uniform(random) < share));
        (graph[k][j], graph[j][k]) = (edge, edge);
    }
    graph
}

/// A graph and the edges of a random tree.
pub fn with_tree(random: &mut Random, mut graph: Graph) -> Graph {
    for (k, j) in (1..graph.len()).map(|k| (k, below(random, k))) {
        (graph[k][j], graph[j][k]) = (1.0, 1.0);
    }
    graph
}

/// A connected undirected graph: a random tree and some more edges.
pub fn connected(random: &mut Random, n: usize) -> Graph {
    let graph = if uniform(random) < 0.5 { vec![vec![0.0; n]; n] } else { undirected(random, n) };
    with_tree(random, graph)
}

pub fn directed(random: &mut Random, n: usize) -> Graph {
    let mut graph = undirected(random, n);
    for (k, row) in graph.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate() {
            *entry = if k != j && uniform(random) < 0.5 { 1.0 } else { 0.0 };
        }
    }
    graph
}

/// `L x` for `L = D - A`.
pub fn laplacian(graph: &Graph, x: &[Z]) -> Vec<Z> {
    let row = |k: usize| (0..x.len()).fold(Z::default(), |sum, j| sum + (x[k] - x[j]) * graph[k][j]);
    (0..x.len()).map(row).collect()
}

/// `L` with weights.
pub fn matrix(graph: &Graph) -> Vec<Vec<f64>> {
    let n = graph.len();
    let entry = |k: usize, j: usize| if k == j { graph[k].iter().sum() } else { -graph[k][j] };
    (0..n).map(|k| (0..n).map(|j| entry(k, j)).collect()).collect()
}

/// The component of each vertex, ignoring directions.
pub fn components(graph: &Graph) -> Vec<usize> {
    let n = graph.len();
    let mut label: Vec<usize> = (0..n).collect();
    for _ in 0..n {
        for k in 0..n {
            for j in 0..n {
                if graph[k][j] > 0.0 || graph[j][k] > 0.0 {
                    let least = label[k].min(label[j]);
                    (label[k], label[j]) = (least, least);
                }
            }
        }
    }
    label
}

// --- Calculus ---

/// The eigenvalues of a symmetric matrix, smallest first (Jacobi).
pub fn eigenvalues(matrix: &[Vec<f64>]) -> Vec<f64> {
    let (mut a, n) = (matrix.to_vec(), matrix.len());
    for _ in 0..60 {
        for p in 0..n {
            for q in p + 1..n {
                if a[p][q].abs() < 1e-14 {
                    continue;
                }
                let t = 0.5 * (2.0 * a[p][q]).atan2(a[q][q] - a[p][p]);
                let (s, c) = t.sin_cos();
                for row in &mut a {
                    (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
                }
                let [first, second] = a.get_disjoint_mut([p, q]).unwrap();
                for (x, y) in first.iter_mut().zip(second) {
                    (*x, *y) = (c * *x - s * *y, s * *x + c * *y);
                }
            }
        }
    }
    let mut values: Vec<f64> = (0..n).map(|k| a[k][k]).collect();
    values.sort_by(f64::total_cmp);
    values
}

/// The determinant of a complex matrix.
pub fn determinant(mut a: Vec<Vec<Z>>) -> Z {
    let (n, mut product) = (a.len(), Z(1.0, 0.0));
    for p in 0..n {
        let best = (p..n).max_by(|i, j| norm(a[*i][p]).total_cmp(&norm(a[*j][p]))).unwrap_or(p);
        if best != p {
            a.swap(best, p);
            product = -product;
        }
        product = product * a[p][p];
        let square = dot(a[p][p], a[p][p]);
        if square == 0.0 {
            return Z::default();
        }
        let inverse = Z(a[p][p].0, -a[p][p].1) * (1.0 / square);
        let (above, rest) = a.split_at_mut(p + 1);
        for row in rest {
            let factor = row[p] * inverse;
            for (x, pivot) in row[p..].iter_mut().zip(&above[p][p..]) {
                *x = *x - factor * *pivot;
            }
        }
    }
    product
}

const SMALL: f64 = 1e-4;

/// `d/dt f(x + t v)` at `t = 0`, with an error of the fourth order.
pub fn along(f: impl Fn(&[f64]) -> f64, x: &[f64], v: &[f64]) -> f64 {
    let at = |t: f64| f(&x.iter().zip(v).map(|(x, v)| x + t * v).collect::<Vec<_>>());
    (8.0 * (at(SMALL) - at(-SMALL)) - at(2.0 * SMALL) + at(-2.0 * SMALL)) / (12.0 * SMALL)
}

/// The partial derivatives.
pub fn gradient(f: impl Fn(&[f64]) -> f64, x: &[f64]) -> Vec<f64> {
    let unit = |k: usize| (0..x.len()).map(|j| f64::from(u8::from(j == k))).collect::<Vec<_>>();
    (0..x.len()).map(|k| along(&f, x, &unit(k))).collect()
}

/// The derivative of a vector field.
pub fn jacobian(f: impl Fn(&[f64]) -> Vec<f64>, x: &[f64]) -> Vec<Vec<f64>> {
    let n = f(x).len();
    (0..n).map(|row| gradient(|y| f(y)[row], x)).collect()
}

/// The state after some steps of Runge and Kutta's method.
pub fn flow(f: impl Fn(&[f64]) -> Vec<f64>, mut x: Vec<f64>, step: f64, steps: usize) -> Vec<f64> {
    let moved = |x: &[f64], k: &[f64], h: f64| x.iter().zip(k).map(|(x, k)| x + h * k).collect::<Vec<f64>>();
    for _ in 0..steps {
        let a = f(&x);
        let b = f(&moved(&x, &a, step / 2.0));
        let c = f(&moved(&x, &b, step / 2.0));
        let d = f(&moved(&x, &c, step));
        for k in 0..x.len() {
            x[k] += step / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]);
        }
    }
    x
}
