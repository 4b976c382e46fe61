//! Chazelle's statements about matrices, products and fixed networks.

use super::{Dice, Matrix, apply, close, identity, largest, times};

pub type Graph = Vec<Vec<bool>>;

fn random_graph(n: usize, joined: f64, dice: &mut Dice) -> Graph {
    let mut graph = vec![vec![false; n]; n];
    for (i, j) in pairs(n) {
        graph[i][j] = dice.unit() < joined;
        graph[j][i] = graph[i][j];
    }
    graph
}

pub fn from_edges(n: usize, joined: impl Fn(usize, usize) -> bool) -> Graph {
    (0..n).map(|i| (0..n).map(|j| i != j && (joined(i, j) || joined(j, i))).collect()).collect()
}

fn degree(graph: &Graph, i: usize) -> usize {
    graph[i].iter().filter(|joined| **joined).count()
}

pub fn connected(graph: &Graph) -> bool {
    let mut reached = vec![false; graph.len()];
    let mut stack = vec![0];
    while let Some(i) = stack.pop() {
        if !std::mem::replace(&mut reached[i], true) {
            stack.extend((0..graph.len()).filter(|&j| graph[i][j]));
        }
    }
    reached.into_iter().all(|r| r)
}

fn connected_graph(n: usize, dice: &mut Dice) -> Graph {
    loop {
        let joined = dice.between(0.2, 1.0);
        let graph = random_graph(n, joined, dice);
        if connected(&graph) {
            return graph;
        }
    }
}

pub fn model_d(graph: &Graph, c: &[f64]) -> Matrix {
    let n = graph.len();
    let entry = |i: usize, j: usize| {
        if i == j { 1.0 - c[i] * degree(graph, i) as f64 } else { c[i] * f64::from(u8::from(graph[i][j])) }
    };
    (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect()
}

/// `c_i = share/d_i`.
pub fn shares(graph: &Graph, mut share: impl FnMut() -> f64) -> Vec<f64> {
    (0..graph.len()).map(|i| share() / degree(graph, i).max(1) as f64).collect()
}

pub fn vicsek(graph: &Graph) -> Vec<f64> {
    (0..graph.len()).map(|i| 1.0 / (degree(graph, i) as f64 + 1.0)).collect()
}

fn tau_1(a: &Matrix) -> f64 {
    pairs(a.len())
        .map(|(i, j)| a[i].iter().zip(&a[j]).map(|(x, y)| (x - y).abs()).sum::<f64>() / 2.0)
        .fold(0.0, f64::max)
}

fn tau_2(a: &Matrix) -> f64 {
    let distance = |(i, j): (usize, usize)| a[i].iter().zip(&a[j]).map(|(x, y)| (x - y).powi(2)).sum::<f64>().sqrt();
    pairs(a.len()).map(distance).fold(0.0, f64::max)
}

fn pairs(n: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..n).flat_map(|i| (0..i).map(move |j| (i, j)))
}

/// chazelle.modelK.matrix, modelD.stoch, foot.mono: lone birds, shares next to 0 and 1, long products.
#[test]
fn matrices_of_the_models() {
    let mut dice = Dice::new("matrices");
    for _ in 0..300 {
        let n = 1 + dice.below(6);
        let graph = random_graph(n, 0.4, &mut dice);
        let theta: Vec<f64> = (0..n).map(|_| dice.between(-9.0, 9.0)).collect();
        let moved = apply(&model_d(&graph, &vicsek(&graph)), &theta);
        for i in 0..n {
            let heard: f64 = (0..n).filter(|&j| graph[i][j]).map(|j| theta[j]).sum();
            assert!(close(moved[i], (theta[i] + heard) / (degree(&graph, i) as f64 + 1.0)));
        }
        for share in [1e-12, 0.5, 1.0 - 1e-12] {
            let p = model_d(&graph, &shares(&graph, || share));
            assert!(p.iter().all(|row| close(row.iter().sum(), 1.0) && row.iter().all(|x| *x >= 0.0)));
            assert!((0..n).all(|i| p[i][i] > 0.0));
        }
        let mut product = identity(n);
        for _ in 0..6 {
            let factor = model_d(&random_graph(n, 0.3, &mut dice), &vec![0.9 / n as f64; n]);
            let next = times(&factor, &product);
            assert!((0..n * n).all(|k| next[k / n][k % n] > 0.0 || product[k / n][k % n] == 0.0));
            product = next;
        }
    }
}

/// chazelle.tau1, lem2.4, tau2sqrt2: single rows and columns, and a climb towards a larger quotient.
#[test]
fn diameters() {
    let mut dice = Dice::new("diameters");
    let stochastic = |rows: usize, cols: usize, dice: &mut Dice| -> Matrix {
        let row = |dice: &mut Dice| {
            let weights: Vec<f64> = (0..cols).map(|_| if dice.below(2) == 0 { 0.0 } else { dice.unit() }).collect();
            let sum: f64 = weights.iter().sum();
            if sum == 0.0 { identity(cols)[0].clone() } else { weights.iter().map(|w| w / sum).collect() }
        };
        (0..rows).map(|_| row(dice)).collect()
    };
    for _ in 0..3000 {
        let [rows, inner, cols] = [1 + dice.below(5), 1 + dice.below(5), 1 + dice.below(5)];
        let (a, b) = (stochastic(rows, inner, &mut dice), stochastic(inner, cols, &mut dice));
        let overlap = (0..rows)
            .flat_map(|i| (0..rows).map(move |j| (i, j)))
            .map(|(i, j)| a[i].iter().zip(&a[j]).map(|(x, y)| x.min(*y)).sum::<f64>())
            .fold(1.0, f64::min);
        let tau = tau_1(&a);
        assert!((-1e-12..=1.0 + 1e-12).contains(&tau) && close(tau, 1.0 - overlap));
        assert!(tau_2(&times(&a, &b)) <= tau * tau_2(&b) + 1e-12);
        let middle = tau * tau_2(&identity(inner));
        assert!(tau_2(&a) <= middle + 1e-12 && middle <= 2f64.sqrt() * tau + 1e-12);
    }
    // The worst of many small steps away from a start.
    let (mut a, mut b, mut worst) = (stochastic(2, 4, &mut dice), stochastic(4, 3, &mut dice), 0.0);
    for _ in 0..4000 {
        let mix = |old: &Matrix, new: Matrix| -> Matrix {
            old.iter().zip(new).map(|(x, y)| x.iter().zip(y).map(|(x, y)| 0.9 * x + 0.1 * y).collect()).collect()
        };
        let (c, d) = (mix(&a, stochastic(2, 4, &mut dice)), mix(&b, stochastic(4, 3, &mut dice)));
        let quotient = tau_2(&times(&c, &d)) / (tau_1(&c) * tau_2(&d)).max(1e-9);
        if quotient > worst {
            (a, b, worst) = (c, d, quotient);
        }
    }
    assert!(worst <= 1.0 + 1e-9, "{worst}");
}

/// chazelle.lem2.2.entries, beyond.chazelle.entries: at every step the networks that leave the smallest entries.
#[test]
fn smallest_entries() {
    for n in 2..=4usize {
        let lazy = |g: &Graph| shares(g, || 2.0 / 3.0);
        let factorial: f64 = (1..=n).map(|k| k as f64).product();
        let floors = [1.0 / factorial, 2f64.powi(n as i32 - 2) * n as f64 / (3f64.powi(n as i32 - 1) * factorial)];
        for (weights, floor) in [&vicsek as &dyn Fn(&Graph) -> Vec<f64>, &lazy].into_iter().zip(floors) {
            let graphs = (0..1usize << (n * (n - 1) / 2))
                .map(|code| from_edges(n, |i, j| i > j && code >> (i * (i - 1) / 2 + j) & 1 == 1));
            let factors: Vec<Matrix> = graphs.map(|g| model_d(&g, &weights(&g))).collect();
            let smallest = |m: &Matrix| m.iter().flatten().copied().filter(|x| *x > 0.0).fold(1.0, f64::min);
            let mut beam = vec![identity(n)];
            let mut least: f64 = 1.0;
            for _ in 0..2 * n {
                let mut next: Vec<Matrix> = beam.iter().flat_map(|m| factors.iter().map(|p| times(p, m))).collect();
                next.sort_by(|a, b| smallest(a).total_cmp(&smallest(b)));
                next.truncate(40);
                least = least.min(smallest(&next[0]));
                beam = next;
            }
            assert!(least >= floor * (1.0 - 1e-9) && least <= floor * (1.0 + 1e-9), "n = {n}: {least}, {floor}");
        }
    }
}

/// chazelle.eq2.3, beyond.chazelle.recurrent: velocities under the networks that keep them apart longest.
#[test]
fn velocities() {
    let mut dice = Dice::new("velocities");
    for n in 2..=4usize {
        let c = |g: &Graph| vicsek(g);
        let alpha = 1.0 / n as f64;
        for _ in 0..40 {
            let mut v: Vec<f64> = (0..n).map(|_| dice.between(-1.0, 1.0)).collect();
            let (first, most) = (range(&v), largest(v.iter().map(|x| x.abs())));
            let mut windows = 0;
            for _ in 0..12 {
                // A window that joins a spanning path edge by edge, in the order in which the least is lost.
                let mut order: Vec<usize> = (0..n).collect();
                order.sort_by_key(|_| dice.below(1000));
                let mut edges: Vec<(usize, usize)> = order.windows(2).map(|w| (w[0], w[1])).collect();
                while !edges.is_empty() {
                    let after = |e: &(usize, usize)| {
                        let g = from_edges(n, |i, j| (i, j) == *e);
                        apply(&model_d(&g, &c(&g)), &v)
                    };
                    let pick =
                        (0..edges.len()).max_by(|a, b| range(&after(&edges[*a])).total_cmp(&range(&after(&edges[*b]))));
                    v = after(&edges.swap_remove(pick.unwrap()));
                }
                windows += 1;
                let bound = (1.0 - alpha.powi(n as i32 - 1)).powi(windows / (n as i32 - 1));
                assert!(range(&v) <= bound * first + 1e-12, "n = {n}, {windows} windows");
                let norm = v.iter().map(|x| x * x).sum::<f64>().sqrt();
                assert!(norm <= (n as f64).sqrt() * most + 1e-12);
            }
        }
    }
    // Directed: only one bird is heard, along a path, one arc at a time (B = n - 1).
    for n in 2..=4usize {
        for own in [0.5, 0.1, 0.9] {
            let alpha = f64::min(own, 1.0 - own);
            let mut product = identity(n);
            for t in 1..=8 * (n - 1) {
                let k = (t - 1) % (n - 1);
                let mut p = identity(n);
                // Heard from the far end first: news travels slowly.
                let bird = n - 1 - k;
                (p[bird][bird], p[bird][bird - 1]) = (own, 1.0 - own);
                product = times(&p, &product);
                let bound = (1.0 - alpha.powi(((n - 1) * (n - 1)) as i32)).powi((t / ((n - 1) * (n - 1))) as i32);
                assert!(tau_1(&product) <= bound + 1e-12, "n = {n}, t = {t}, {own}");
            }
        }
    }
}

fn range(v: &[f64]) -> f64 {
    largest(v.iter().copied()) + largest(v.iter().map(|x| -x))
}

/// Eigenvalues, decreasing, and orthonormal eigenvectors of a symmetric matrix (Jacobi).
pub fn modes(m: &Matrix) -> Vec<(f64, Vec<f64>)> {
    let n = m.len();
    let (mut a, mut u) = (m.clone(), identity(n));
    for (p, q) in (0..12).flat_map(|_| pairs(n)) {
        let (sin, cos) = (0.5 * (2.0 * a[p][q]).atan2(a[q][q] - a[p][p])).sin_cos();
        let turn = |x: f64, y: f64| (cos * x - sin * y, sin * x + cos * y);
        for row in a.iter_mut().chain(&mut u) {
            (row[p], row[q]) = turn(row[p], row[q]);
        }
        let [first, second] = a.get_disjoint_mut([p, q]).unwrap();
        for (x, y) in first.iter_mut().zip(second) {
            (*x, *y) = turn(*x, *y);
        }
    }
    let mut all: Vec<(f64, Vec<f64>)> = (0..n).map(|k| (a[k][k], u.iter().map(|row| row[k]).collect())).collect();
    all.sort_by(|x, y| y.0.total_cmp(&x.0));
    all
}

/// Connected networks with the shares that mix worst, single birds among them.
fn networks(dice: &mut Dice) -> Vec<(Graph, Vec<f64>)> {
    let mut all = Vec::new();
    for _ in 0..60 {
        let n = 1 + dice.below(5);
        let graph = connected_graph(n, dice);
        let c = match dice.below(3) {
            0 => vicsek(&graph),
            1 => shares(&graph, || 2.0 / 3.0),
            _ => shares(&graph, || dice.between(0.05, 0.95)),
        };
        all.push((graph, c));
    }
    all
}

/// chazelle.pi, eq3.7, eq3.8, eq3.12-13, lem3.3, lem3.4 with irrational spectra.
#[test]
fn fixed_networks() {
    let mut dice = Dice::new("fixed");
    for (graph, c) in networks(&mut dice) {
        let (n, p) = (graph.len(), model_d(&graph, &c));
        let trace: f64 = c.iter().map(|c| 1.0 / c).sum();
        let pi: Vec<f64> = c.iter().map(|c| 1.0 / (c * trace)).collect();
        assert!((0..n).all(|j| close((0..n).map(|i| pi[i] * p[i][j]).sum(), pi[j])));
        let m: Matrix = (0..n).map(|i| (0..n).map(|j| p[i][j] * (c[j] / c[i]).sqrt()).collect()).collect();
        assert!(pairs(n).all(|(i, j)| close(m[i][j], m[j][i])));
        let modes = modes(&m);
        assert!(close(modes[0].0, 1.0) && modes.iter().skip(1).all(|(l, _)| *l < 1.0 - 1e-9 && *l >= -1.0));
        assert!((0..n).all(|i| close(modes[0].1[i].abs(), pi[i].sqrt())));
        let term = |(_, u): &(f64, Vec<f64>), i: usize, j: usize| c[i].sqrt() * u[i] * u[j] / c[j].sqrt();
        let mut power = identity(n);
        for s in 0..5 {
            for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
                let sum: f64 = modes.iter().skip(1).map(|m| m.0.powi(s) * term(m, i, j)).sum();
                assert!(close(power[i][j], pi[j] + sum));
            }
            power = times(&p, &power);
        }
        for (eigenvalue, u) in &modes {
            let right: Vec<f64> = (0..n).map(|i| c[i].sqrt() * u[i]).collect();
            let left: Vec<f64> = (0..n).map(|i| u[i] / c[i].sqrt()).collect();
            let found = apply(&p, &right);
            assert!((0..n).all(|i| close(found[i], eigenvalue * right[i])));
            assert!((0..n).all(|j| close((0..n).map(|i| left[i] * p[i][j]).sum(), eigenvalue * left[j])));
        }
        // Gamma_t by its definition against (I - 1 pi^T | 0)(I - P | 1)^-1, and the flight of birds.
        let (mut gamma, mut power) = (vec![vec![0.0; n]; n], identity(n));
        let steps = 4000;
        for _ in 0..steps {
            for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
                gamma[i][j] += power[i][j] - pi[j];
            }
            power = times(&p, &power);
        }
        let bordered: Matrix = (0..n)
            .map(|i| (0..n).map(|j| if j + 1 == n { 1.0 } else { f64::from(u8::from(i == j)) - p[i][j] }).collect())
            .collect();
        let product = times(&gamma, &bordered);
        for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
            let expected = if j + 1 == n { 0.0 } else { f64::from(u8::from(i == j)) - pi[j] };
            assert!((product[i][j] - expected).abs() < 1e-6, "{graph:?} {c:?}");
        }
        let (x0, v1): (Vec<f64>, Vec<f64>) = (0..n).map(|_| (dice.between(-1.0, 1.0), dice.between(-1.0, 1.0))).unzip();
        let mean = |x: &[f64]| x.iter().zip(&pi).map(|(x, p)| x * p).sum::<f64>();
        let (mut x, mut v) = (x0.clone(), v1.clone());
        for t in 1..=steps {
            (0..n).for_each(|i| x[i] += v[i]);
            assert!((mean(&x) - mean(&x0) - f64::from(t) * mean(&v1)).abs() < 1e-7);
            v = apply(&p, &v);
        }
        let limit = apply(&gamma, &v1);
        assert!((0..n).all(|i| (x[i] - mean(&x) - (x0[i] - mean(&x0) + limit[i])).abs() < 1e-6));
    }
}

/// chazelle.lem3.2, eq3.9, eq3.10, beyond.chazelle.fiedler.rate: paths, stars, kites and barbells.
#[test]
fn slow_mixing() {
    for n in [2, 3, 4, 5, 8, 14usize] {
        let half = n / 2;
        let clique = |i: usize| usize::from(i >= half);
        let shapes: [Graph; 4] = [
            from_edges(n, |i, j| i + 1 == j),
            from_edges(n, |i, j| i == 0 && j > 0),
            from_edges(n, |i, j| i + 1 == j || (i < half && j < half)),
            from_edges(n, |i, j| clique(i) == clique(j) || (i + 1 == half && j == half)),
        ];
        for graph in &shapes {
            let laplacian: Matrix = (0..n)
                .map(|i| {
                    (0..n)
                        .map(|j| if i == j { degree(graph, i) as f64 } else { -f64::from(u8::from(graph[i][j])) })
                        .collect()
                })
                .collect();
            let fiedler = modes(&laplacian)[n - 2].0;
            assert!(fiedler >= 4.0 / (n * (n - 1)) as f64 * (1.0 - 1e-9), "{n}: {fiedler}");
            for c in [vicsek(graph), shares(graph, || 2.0 / 3.0)] {
                let p = model_d(graph, &c);
                let trace: f64 = c.iter().map(|c| 1.0 / c).sum();
                let (mut power, mut s) = (p.clone(), 1.0);
                let cube = (n as f64).powi(3);
                // s = 1, 2, 4, ..: the bounds that the notes give, with n^3 in the exponent.
                while s < 8.0 * cube {
                    for row in &power {
                        let off = largest(row.iter().zip(&c).map(|(x, c)| (x - 1.0 / (c * trace)).abs()));
                        assert!(off <= n as f64 * f64::exp(-s / cube), "{n} birds, s = {s}: {off}");
                    }
                    assert!(tau_1(&power) <= n as f64 * f64::exp2(-s / cube));
                    (power, s) = (times(&power, &power), 2.0 * s);
                }
                assert!(tau_1(&power) < 0.5);
            }
        }
    }
}

/// chazelle.xi.closed, beyond.chazelle.eq3.16, eq3.17: two flocks with irrational spectra, and one bird alone.
#[test]
fn closed_forms() {
    let mut dice = Dice::new("closed");
    let all = networks(&mut dice);
    for pair in all.windows(2) {
        let mut sides = Vec::new();
        for (graph, c) in pair {
            let (n, p) = (graph.len(), model_d(graph, c));
            let m: Matrix = (0..n).map(|i| (0..n).map(|j| p[i][j] * (c[j] / c[i]).sqrt()).collect()).collect();
            let x: Vec<f64> = (0..n).map(|_| dice.between(-3.0, 3.0)).collect();
            let v: Vec<f64> = (0..n).map(|_| dice.between(-1.0, 1.0)).collect();
            let trace: f64 = c.iter().map(|c| 1.0 / c).sum();
            let y: f64 = v.iter().zip(c).map(|(v, c)| v / (c * trace)).sum();
            let i = dice.below(n);
            let phi = |(l, u): &(f64, Vec<f64>)| {
                (*l, c[i].sqrt() * u[i] * (0..n).map(|j| u[j] / c[j].sqrt() * v[j]).sum::<f64>())
            };
            let phis: Vec<(f64, f64)> = modes(&m).iter().skip(1).map(phi).collect();
            let ahead: f64 = phis.iter().map(|(l, phi)| phi / (1.0 - l)).sum();
            sides.push((p, x, v, i, y, phis, ahead));
        }
        let start: Vec<f64> = sides.iter().map(|s| s.1[s.3]).collect();
        for steps in 0..30i32 {
            let sums: Vec<f64> =
                sides.iter().map(|s| s.5.iter().map(|(l, phi)| l.powi(steps) * phi / (1.0 - l)).sum()).collect();
            for (k, (_, x, _, i, y, phis, ahead)) in sides.iter().enumerate() {
                let geometric: f64 = phis.iter().map(|(l, phi)| (1.0 - l.powi(steps)) / (1.0 - l) * phi).sum();
                assert!((x[*i] - start[k] - f64::from(steps) * y - geometric).abs() < 1e-7);
                assert!((x[*i] - start[k] - ahead - f64::from(steps) * y + sums[k]).abs() < 1e-7);
            }
            let (a, b) = (start[0] - start[1] + sides[0].6 - sides[1].6, sides[0].4 - sides[1].4);
            let apart = sides[0].1[sides[0].3] - sides[1].1[sides[1].3];
            assert!((apart - a - b * f64::from(steps) + sums[0] - sums[1]).abs() < 1e-7);
            for (p, x, v, ..) in &mut sides {
                (0..x.len()).for_each(|i| x[i] += v[i]);
                *v = apply(p, v);
            }
        }
    }
}

/// chazelle.eq3.18: pairs of pairs at the limit distance 1, eigenvalues 0, equal and opposite among them.
#[test]
fn distances_in_the_limit() {
    let values: [f64; 7] = [0.0, 0.25, -0.25, 0.5, -0.5, 0.75, -0.75];
    let amplitudes: [f64; 4] = [0.5, -0.5, 1.0, -2.0];
    for (l, m) in values.iter().flat_map(|l| values.map(|m| (*l, m))) {
        for (a, b) in amplitudes.iter().flat_map(|a| amplitudes.map(|b| (*a, b))) {
            // x_i - x_j = 1 - a l^s - b m^s, squared: terms (base, coefficient).
            let terms = [(l, -2.0 * a), (m, -2.0 * b), (l * l, a * a), (m * m, b * b), (l * m, 2.0 * a * b)];
            let mut moduli: Vec<f64> = terms.iter().map(|(x, _)| x.abs()).filter(|x| *x > 0.0).collect();
            moduli.sort_by(f64::total_cmp);
            moduli.dedup();
            assert!(moduli.len() < 16 && moduli.iter().all(|x| *x < 1.0));
            for s in 1..9i32 {
                let apart = 1.0 - a * l.powi(s) - b * m.powi(s);
                let upsilon = |rho: &f64, sign: f64| -> f64 {
                    terms.iter().filter(|(x, _)| *x == sign * rho).map(|(_, c)| c).sum()
                };
                let parity = if s % 2 == 0 { 1.0 } else { -1.0 };
                let sum: f64 = moduli.iter().map(|r| (upsilon(r, 1.0) + parity * upsilon(r, -1.0)) * r.powi(s)).sum();
                assert!(close(apart * apart - 1.0, sum));
            }
        }
    }
}

/// A network over time that stays as it ends, with the footprints of the products from time 1 on.
struct History {
    graphs: Vec<Graph>,
}

impl History {
    fn at(&self, t: usize) -> &Graph {
        &self.graphs[(t - 1).min(self.graphs.len() - 1)]
    }

    fn changes(&self, first: usize, last: usize, birds: &[usize]) -> usize {
        let differ =
            |t: &usize| birds.iter().any(|&i| birds.iter().any(|&j| self.at(*t)[i][j] != self.at(t - 1)[i][j]));
        (first.max(2)..=last).filter(differ).count()
    }

    /// From the sets of birds outside: the time from which the footprint of `P(t, s)` on `birds` is final, and the rows of its
    /// first column.
    fn stable(&self, s: usize, birds: &[usize]) -> (usize, Vec<usize>) {
        let n = birds.len();
        let mut product: Vec<Vec<bool>> = (0..n).map(|i| (0..n).map(|j| i == j).collect()).collect();
        let mut last = s;
        for t in s..=self.graphs.len().max(s) + n * n + 1 {
            let g = self.at(t);
            let hears = |i: usize, k: usize| i == k || g[birds[i]][birds[k]];
            let next: Vec<Vec<bool>> =
                (0..n).map(|i| (0..n).map(|j| (0..n).any(|k| hears(i, k) && product[k][j])).collect()).collect();
            if next != product && t > s {
                last = t;
            }
            product = next;
        }
        (last, (0..n).filter(|&i| product[i][0]).map(|i| birds[i]).collect())
    }
}

/// chazelle.stab, beyond.chazelle.eq3.5, lem3.1.count, chazelle.eq3.6: random networks over time.
#[test]
fn stabilisers() {
    let mut dice = Dice::new("stabilisers");
    for _ in 0..400 {
        let (n, joined) = (1 + dice.below(5), dice.between(0.1, 0.7));
        let graphs: Vec<Graph> = (0..1 + dice.below(9)).map(|_| random_graph(n, joined, &mut dice)).collect();
        let history = History { graphs };
        let factors: Vec<Matrix> = (1..=history.graphs.len() + 60)
            .map(|t| model_d(history.at(t), &shares(history.at(t), || dice.between(0.1, 0.9))))
            .collect();
        let product = |t: usize, s: usize, rows: &[usize], cols: &[usize]| -> Matrix {
            let all = (s..=t).fold(identity(n), |p, u| times(&factors[u - 1], &p));
            rows.iter().map(|&i| cols.iter().map(|&j| all[i][j]).collect()).collect()
        };
        let everyone: Vec<usize> = (0..n).collect();
        let (mut sets, mut stops) = (vec![everyone.clone()], vec![0]);
        for k in 1..=3 {
            let (time, members) = history.stable(stops[k - 1] + 1, &sets[k - 1]);
            assert!(members.contains(&0) && members.iter().all(|i| sets[k - 1].contains(i)));
            for t in time + 1..time + 12 {
                let outside = sets[k - 1].iter().filter(|i| !members.contains(i));
                assert!(outside.clone().all(|&j| members.iter().all(|&i| !history.at(t)[i][j])));
            }
            let block = product(time, stops[k - 1] + 1, &members, &sets[k - 1]);
            assert!(block.iter().all(|row| row[0] > 0.0));
            sets.push(members);
            stops.push(time);
            // (3.5) as corrected and (3.6).
            let t = time + 1 + dice.below(3);
            let whole = product(t, 1, &sets[k], &sets[0]);
            let mut parts = product(t, time + 1, &sets[k], &sets[k]);
            let mut contraction = tau_1(&parts);
            for i in (1..=k).rev() {
                let factor = product(stops[i], stops[i - 1] + 1, &sets[i], &sets[i - 1]);
                contraction *= tau_1(&factor);
                parts = times(&parts, &factor);
            }
            assert!(whole.iter().flatten().zip(parts.iter().flatten()).all(|(x, y)| close(*x, *y)));
            assert!(tau_2(&whole) <= 2f64.sqrt() * contraction + 1e-12);
            // Entries of at least 1/40: n^-4 for three birds or more, and shares of a tenth for two.
            let size = n as f64;
            assert!(contraction <= (-(k as f64) * size.powf(-4.0 * size * size)).exp() + 1e-12);
            // The count, where joined birds of V_k remain so.
            let end = history.graphs.len() + 1;
            let v = &sets[k];
            let parts_later = (time + 2..=end)
                .any(|t| v.iter().any(|&i| v.iter().any(|&j| history.at(t - 1)[i][j] && !history.at(t)[i][j])));
            if !parts_later {
                let others: Vec<usize> = (0..n).filter(|i| !v.contains(i)).collect();
                let counted: usize =
                    (1..=k).map(|i| history.changes(stops[i - 1].max(1) + 1, stops[i], &everyone)).sum();
                let bound = counted + 1 + v.len() * (v.len() - 1) / 2 + history.changes(time + 2, end, &others);
                assert!(history.changes(2, end, &everyone) <= bound);
            }
        }
    }
}

/// chazelle.kron, exAB, ex15: written out by hand.
#[test]
fn worked_matrices() {
    let mut dice = Dice::new("worked");
    let random = |rows: usize, cols: usize, dice: &mut Dice| -> Matrix {
        (0..rows).map(|_| (0..cols).map(|_| dice.between(-2.0, 2.0)).collect()).collect()
    };
    let kron = |a: &Matrix, b: &Matrix| -> Matrix {
        let (p, q) = (b.len(), b[0].len());
        (0..a.len() * p).map(|r| (0..a[0].len() * q).map(|s| a[r / p][s / q] * b[r % p][s % q]).collect()).collect()
    };
    for _ in 0..50 {
        let [m, n, p, q, r, s] = [0; 6].map(|_| 1 + dice.below(3));
        let (a, b, c, d) =
            (random(m, n, &mut dice), random(p, q, &mut dice), random(n, r, &mut dice), random(q, s, &mut dice));
        let (left, right) = (times(&kron(&a, &b), &kron(&c, &d)), kron(&times(&a, &c), &times(&b, &d)));
        assert!(left.iter().flatten().zip(right.iter().flatten()).all(|(x, y)| close(*x, *y)));
    }
    let a = vec![vec![0.0, 1.0, 0.0], vec![1.0, 0.0, 0.0], vec![0.0, 0.0, 1.0]];
    let b = vec![vec![0.0, 1.0, 0.0], vec![0.5, 0.0, 0.5], vec![0.0, 1.0, 0.0]];
    let mut product = identity(3);
    for t in (2..=60).step_by(2) {
        product = times(&a, &times(&b, &product));
        let u = f64::powi(0.5, t / 2);
        let printed = [[u, 1.0 - 2.0 * u, u], [0.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
        assert!((0..9).all(|k| close(product[k / 3][k % 3], printed[k / 3][k % 3])));
    }
    let p = vec![vec![0.8, 0.2], vec![2.0 / 3.0, 1.0 / 3.0]];
    // Model D with c_1 = 1/5, c_2 = 2/3; (3, -10) belongs to 2/15, and neither it nor the image of (1, -1) has the sum 0.
    assert_eq!(p, vec![vec![1.0 - 0.2, 0.2], vec![2.0 / 3.0, 1.0 / 3.0]]);
    let mode = apply(&p, &[3.0, -10.0]);
    assert!(close(mode[0], 3.0 * 2.0 / 15.0) && close(mode[1], -10.0 * 2.0 / 15.0));
    let off = apply(&p, &[1.0, -1.0]);
    assert!((off[0] + off[1]).abs() > 0.1);
    let image = apply(&p, &[1.0, 0.0]);
    assert!((image[0].hypot(image[1]) - 1.041).abs() < 5e-4 && (p[0][0] + p[1][1] - 1.0 - 0.133).abs() < 5e-4);
}
