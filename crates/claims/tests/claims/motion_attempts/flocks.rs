//! Flocks on fixed graphs: heading alignment and velocity alignment with potentials that differ from pair to pair.

use super::*;

/// Positions and velocities, `x_1, y_1, vx_1, vy_1, ...`.
pub fn split(x: &[f64]) -> (Vec<Z>, Vec<Z>) {
    (x.chunks(4).map(|c| Z(c[0], c[1])).collect(), x.chunks(4).map(|c| Z(c[2], c[3])).collect())
}

pub fn join(r: &[Z], v: &[Z]) -> Vec<f64> {
    r.iter().zip(v).flat_map(|(r, v)| [r.0, r.1, v.0, v.1]).collect()
}

/// Potentials of Definition 3: `k(s/m + m/s - 2)` or `k(m/s + log(s/m) - 1)`, with a least value 0 at `s = m`, one for each pair.
#[derive(Clone)]
pub struct Flock {
    pub graph: Graph,
    pub scale: Vec<Vec<f64>>,
    pub stiffness: f64,
    pub logarithmic: bool,
}

impl Flock {
    pub fn value(&self, i: usize, j: usize, s: f64) -> f64 {
        let m = self.scale[i][j];
        self.stiffness * if self.logarithmic { m / s + (s / m).ln() - 1.0 } else { s / m + m / s - 2.0 }
    }

    pub fn slope(&self, i: usize, j: usize, s: f64) -> f64 {
        let m = self.scale[i][j];
        self.stiffness * if self.logarithmic { 1.0 / s - m / (s * s) } else { 1.0 / m - m / (s * s) }
    }

    pub fn draw(random: &mut Random, graph: Graph, alike: bool) -> Self {
        let n = graph.len();
        let mut scale = vec![vec![1.0; n]; n];
        for (i, j) in pairs(n) {
            let m = if alike { 1.0 } else { [1.0, between(random, 0.3, 3.0), 30.0][below(random, 3)] };
            (scale[i][j], scale[j][i]) = (m, m);
        }
        Flock { graph, scale, stiffness: between(random, 0.5, 2.0), logarithmic: below(random, 2) == 0 }
    }

    fn count(&self) -> usize {
        self.graph.len()
    }

    pub fn edges(&self) -> Vec<(usize, usize)> {
        let n = self.count();
        (0..n).flat_map(|j| (0..j).map(move |i| (i, j))).filter(|(i, j)| self.graph[*i][*j] > 0.0).collect()
    }

    /// `grad_{r_i} V_i`.
    pub fn gradients(&self, r: &[Z]) -> Vec<Z> {
        let mut sums = vec![Z::default(); r.len()];
        for (i, j) in self.edges() {
            let d = r[i] - r[j];
            let g = d * (2.0 * self.slope(i, j, dot(d, d)));
            (sums[i], sums[j]) = (sums[i] + g, sums[j] - g);
        }
        sums
    }

    /// Equation (4) of the second paper.
    pub fn aligned(&self, x: &[f64]) -> Vec<f64> {
        let (r, v) = split(x);
        let (damping, push) = (laplacian(&self.graph, &v), self.gradients(&r));
        let a: Vec<Z> = damping.iter().zip(push).map(|(d, g)| -*d - g).collect();
        join(&v, &a)
    }

    /// Equations (4), (5) of the first paper, for the heading difference that `differ` makes of two headings.
    fn gyroscopic(&self, x: &[f64], differ: fn(f64, f64) -> f64) -> Vec<f64> {
        let (r, v) = split(x);
        let mut a: Vec<Z> = self.gradients(&r).into_iter().map(|g| -g).collect();
        for (i, j) in self.edges() {
            let d = differ(heading(v[i]), heading(v[j])) / dot(r[i] - r[j], r[i] - r[j]);
            (a[i], a[j]) = (a[i] - I * v[i] * d, a[j] + I * v[j] * d);
        }
        join(&v, &a)
    }

    /// `V_i`.
    fn own(&self, r: &[Z], i: usize) -> f64 {
        (0..r.len()).filter(|j| self.graph[i][*j] > 0.0).map(|j| self.value(i, j, dot(r[i] - r[j], r[i] - r[j]))).sum()
    }

    pub fn energy(&self, x: &[f64]) -> f64 {
        let (r, v) = split(x);
        (0..r.len()).map(|i| self.own(&r, i) + dot(v[i], v[i])).sum::<f64>() / 2.0
    }

    /// The largest distance with `V_ij <= c`, by halving.
    fn reach(&self, i: usize, j: usize, c: f64) -> f64 {
        let (mut low, mut high) = (self.scale[i][j].sqrt(), 1e12);
        for _ in 0..200 {
            let middle = (low * high).sqrt();
            if self.value(i, j, middle * middle) <= c { low = middle } else { high = middle }
        }
        high
    }
}

fn heading(v: Z) -> f64 {
    v.1.atan2(v.0)
}

fn raw(a: f64, b: f64) -> f64 {
    a - b
}

fn wrapped(a: f64, b: f64) -> f64 {
    wrap(a - b)
}

/// Agents not too close and not at rest.
pub fn start(random: &mut Random, n: usize, size: f64, speed: f64) -> Vec<f64> {
    loop {
        let (r, v) = (vectors(random, n, size), vectors(random, n, speed));
        let near = (0..n).any(|i| (0..i).any(|j| norm(r[i] - r[j]) < 0.6));
        if !near && v.iter().all(|v| norm(*v) > 0.2 * speed) {
            return join(&r, &v);
        }
    }
}

fn velocity_alignment(random: &mut Random) -> Option<String> {
    let n = 1 + below(random, 5);
    let graph = undirected(random, n);
    let flock = Flock::draw(random, graph, false);
    let x = start(random, n, 2.0, 2.0);
    let (r, v) = split(&x);
    let (field, l, g) = (flock.aligned(&x), laplacian(&flock.graph, &v), flock.gradients(&r));
    let a = split(&field).1;
    let rate = along(|x| flock.energy(x), &x, &field);
    let form: f64 = v.iter().zip(&l).map(|(v, l)| dot(*v, *l)).sum();
    let work: f64 = v.iter().zip(&g).map(|(v, g)| dot(*v, *g)).sum();
    let half = along(|x| (0..n).map(|i| flock.own(&split(x).0, i)).sum::<f64>() / 2.0, &x, &field);
    let edges = flock.edges();
    let pair = |i: usize, j: usize| (r[i] - r[j]) * (2.0 * flock.slope(i, j, dot(r[i] - r[j], r[i] - r[j])));
    let relative: f64 = edges.iter().map(|(i, j)| dot(v[*i] - v[*j], pair(*i, *j))).sum();
    let middle = mean(&v);
    let parts: Vec<Z> = v.iter().map(|v| *v - middle).collect();
    let normal: f64 = parts.iter().zip(laplacian(&flock.graph, &parts)).map(|(p, l)| dot(*p, l)).sum();
    unlike("eq9", rate, -form)
        .or_else(|| {
            unlike("eq8", rate, half - v.iter().zip(&l).zip(&g).map(|((v, l), g)| dot(*v, *l + *g)).sum::<f64>())
        })
        .or_else(|| unlike("eq8, pairs", half, relative))
        .or_else(|| unlike("eq8, agents", half, work))
        .or_else(|| unlike("cor2_decomp", rate, -normal))
        .or_else(|| unlike("eq14", norm(mean(&a)), 0.0))
        .or_else(|| (flock.energy(&x) < 0.0).then(|| "eq6: W < 0".to_string()))
        .or_else(|| {
            let slopes = gradient(|x| flock.energy(x), &x);
            (0..n)
                .find_map(|i| unlike("eq6", slopes[4 * i], g[i].0).or_else(|| unlike("eq6", slopes[4 * i + 3], v[i].1)))
        })
        .or_else(|| {
            // B with -1 where an edge leaves; at equal velocities vdot is B times the pair gradients.
            let mut image = vec![Z::default(); n];
            for (i, j) in edges {
                (image[i], image[j]) = (image[i] - pair(i, j), image[j] + pair(i, j));
            }
            (0..n).find_map(|i| unlike("vdotB", norm(image[i] + g[i]), 0.0))
        })
        .or_else(|| {
            let graph = connected(random, n.max(2));
            let v = vectors(random, graph.len(), 1.0);
            let second = eigenvalues(&matrix(&graph))[1];
            let middle = mean(&v);
            let square: f64 = v.iter().map(|v| dot(*v - middle, *v - middle)).sum();
            let form: f64 = v.iter().zip(laplacian(&graph, &v)).map(|(v, l)| dot(*v, l)).sum();
            (form < second * square - 1e-9).then(|| "cor2_sub".to_string())
        })
}

fn heading_alignment(random: &mut Random) -> Option<String> {
    let n = 1 + below(random, 4);
    let graph = undirected(random, n);
    let flock = Flock::draw(random, graph, false);
    let x = start(random, n, 2.0, 2.0);
    let (r, v) = split(&x);
    // The difference quotients must not pass the negative x axis.
    if v.iter().any(|v| heading(*v).abs() > 3.1) {
        return None;
    }
    let (field, g) = (flock.gyroscopic(&x, raw), flock.gradients(&r));
    let a = split(&field).1;
    let s = |i: usize, j: usize| dot(r[i] - r[j], r[i] - r[j]);
    let sum = |i: usize| {
        (0..n).filter(|j| *j != i).map(|j| flock.graph[i][j] * (heading(v[i]) - heading(v[j])) / s(i, j)).sum::<f64>()
    };
    let own = |i: usize| -cross(v[i], g[i]) / dot(v[i], v[i]);
    let rate = |i: usize| along(|x| heading(split(x).1[i]), &x, &field);
    let v_t = |x: &[f64]| flock.energy(x) + split(x).1.iter().map(|v| heading(*v).powi(2)).sum::<f64>() / 2.0;
    let theta: Vec<f64> = v.iter().map(|v| heading(*v)).collect();
    (0..n)
        .find_map(|i| {
            unlike("eq7", rate(i), own(i) - sum(i))
                .or_else(|| unlike("gyro", dot(v[i], a[i] + g[i]), 0.0))
                .or_else(|| unlike("eq2", norm(v[i] - turn(theta[i]) * norm(v[i])), 0.0))
        })
        .or_else(|| unlike("Vt_inv", along(|x| flock.energy(x), &x, &field), 0.0))
        .or_else(|| {
            let weighted = |f: &dyn Fn(usize) -> f64| (0..n).map(|i| dot(r[i], v[i]) * f(i)).sum::<f64>();
            unlike("eq6b", weighted(&rate), weighted(&|i| own(i) - sum(i)))
        })
        .or_else(|| unlike("eq9.chain", along(v_t, &x, &field), (0..n).map(|i| theta[i] * rate(i)).sum()))
        .or_else(|| unlike("eq9", along(v_t, &x, &field), (0..n).map(|i| theta[i] * (own(i) - sum(i))).sum()))
        .or_else(|| {
            let torque: f64 = (0..n).map(|i| cross(r[i], a[i])).sum();
            unlike("eq6", torque, (0..n).map(|i| -dot(r[i], v[i]) * sum(i)).sum())
        })
        .or_else(|| {
            let half = along(|x| (0..n).map(|i| flock.own(&split(x).0, i)).sum::<f64>() / 2.0, &x, &field);
            unlike("eq8", half, (0..n).map(|i| dot(g[i], v[i])).sum())
        })
        .or_else(|| {
            // Equal headings: the forces are those of the potentials.
            let same: Vec<Z> = v.iter().map(|v| turn(0.7) * norm(*v)).collect();
            let field = flock.gyroscopic(&join(&r, &same), raw);
            (0..n).find_map(|i| unlike("proof_cases, proof_ratio", norm(split(&field).1[i] + g[i]), 0.0))
        })
        .or_else(|| (v_t(&x) < 0.0).then(|| "Vt".to_string()))
        .or_else(|| {
            // Two agents with wrapped differences.
            if n != 2 || flock.graph[0][1] == 0.0 {
                return None;
            }
            let field = flock.gyroscopic(&x, wrapped);
            let total = |x: &[f64]| dot(split(x).1[0] + split(x).1[1], split(x).1[0] + split(x).1[1]) / 2.0;
            let d = wrap(theta[0] - theta[1]);
            let claimed = 2.0 * norm(v[0]) * norm(v[1]) * d * d.sin() / s(0, 1);
            unlike("two_agents", along(total, &x, &field), claimed)
                .or_else(|| (claimed < -1e-12).then(|| "two_agents".to_string()))
        })
}

fn matrices(random: &mut Random) -> Option<String> {
    let n = 1 + below(random, 7);
    let mut graph = undirected(random, n);
    let weighted = below(random, 2) == 0;
    let mut product = vec![vec![0.0; n]; n];
    let mut columns = Vec::new();
    for (i, j) in pairs(n) {
        if graph[i][j] > 0.0 {
            let w = if weighted { between(random, 0.1, 5.0) } else { 1.0 };
            (graph[i][j], graph[j][i]) = (w, w);
            let direction = sign(random);
            let mut column = vec![0.0; n];
            (column[i], column[j]) = (direction, -direction);
            for (row, x) in product.iter_mut().zip(&column) {
                for (entry, y) in row.iter_mut().zip(&column) {
                    *entry += w * x * y;
                }
            }
            columns.push(column);
        }
    }
    let l = matrix(&graph);
    let label = components(&graph);
    let parts = (0..n).filter(|k| label[*k] == *k).count();
    let values = eigenvalues(&l);
    let zeros = values.iter().filter(|x| x.abs() < 1e-9).count();
    let differs = (0..n).any(|a| (0..n).any(|b| (l[a][b] - product[a][b]).abs() > 1e-9));
    // Rank of the columns by their Gram matrix.
    let gram: Vec<Vec<f64>> =
        columns.iter().map(|a| columns.iter().map(|b| a.iter().zip(b).map(|(x, y)| x * y).sum()).collect()).collect();
    let rank = eigenvalues(&gram).iter().filter(|x| **x > 1e-9).count();
    if differs || zeros != parts || values[0] < -1e-9 || rank != n - parts {
        return Some(format!("L, Lw, L.ones, rangeB: {graph:?}"));
    }
    let free: Vec<(usize, usize)> = pairs(n).filter(|(i, j)| graph[*i][*j] == 0.0).collect();
    let (i, j) = *free.get(below(random, free.len().max(1)))?;
    (graph[i][j], graph[j][i]) = (1.0, 1.0);
    let more = eigenvalues(&matrix(&graph));
    let gained: f64 = more.iter().sum::<f64>() - values.iter().sum::<f64>();
    let lower = values.iter().zip(&more).any(|(a, b)| b < &(a - 1e-9));
    (lower || !alike(gained, 2.0)).then(|| format!("cor2_merris: {graph:?}"))
}

/// Rows with all the energy in the edges, in the speeds, or shared, and any states.
fn bounds(random: &mut Random) -> Option<String> {
    let n = 1 + below(random, 5);
    let graph = if below(random, 2) == 0 { circulant(n, &[], true) } else { connected(random, n) };
    let mut flock = Flock::draw(random, graph, false);
    let mut r = vectors(random, n, 3.0);
    if flock.edges().len() + 1 < n {
        // A row in which every edge is stretched to what some energy allows.
        for k in 1..n {
            (flock.graph[k][k - 1], flock.graph[k - 1][k]) = (1.0, 1.0);
            r[k] = r[k - 1] + Z(flock.reach(k, k - 1, [0.0, 1.0, 5.0][below(random, 3)]), 0.0);
        }
    }
    let speed = [0.0, 1.0][below(random, 2)];
    let v = vectors(random, n, speed);
    let c = flock.energy(&join(&r, &v));
    let most = flock.edges().iter().map(|(i, j)| flock.reach(*i, *j, c)).fold(0.0, f64::max);
    let far = pairs(n).map(|(i, j)| norm(r[i] - r[j])).fold(0.0, f64::max);
    let fast = v.iter().map(|v| dot(*v, *v)).fold(0.0, f64::max);
    (far > (n as f64 - 1.0) * most + 1e-6 || fast > 2.0 * c + 1e-9)
        .then(|| format!("bound_r, bound_v, eq7: {r:?}, c = {c}"))
}

/// Runs of (4): velocities agree in the mean of the start, linked agents stay apart, forces vanish, trees settle.
fn limits(random: &mut Random) -> Option<String> {
    let n = 1 + below(random, 4);
    let tree = below(random, 2) == 0;
    let mut graph = connected(random, n);
    if tree {
        graph = with_tree(random, vec![vec![0.0; n]; n]);
    } else if below(random, 3) == 0 {
        graph = complete(n);
    }
    let mut flock = Flock::draw(random, graph, true);
    flock.logarithmic = false;
    let x = start(random, n, 1.5, 1.0);
    let (mut end, middle) = (x.clone(), mean(&split(&x).1));
    let c = flock.energy(&x);
    for _ in 0..20 {
        end = flow(|x| flock.aligned(x), end, 0.01, 600);
        let r = split(&end).0;
        let near = flock.edges().iter().any(|(i, j)| flock.value(*i, *j, dot(r[*i] - r[*j], r[*i] - r[*j])) > c + 1e-6);
        if near {
            return Some("thm1b, cor3: closer than the energy allows".to_string());
        }
    }
    let (r, v) = split(&end);
    let off = v.iter().map(|v| norm(*v - middle)).fold(0.0, f64::max);
    let force = flock.gradients(&r).iter().map(|g| norm(*g)).fold(0.0, f64::max);
    let unset = flock.edges().iter().map(|(i, j)| (norm(r[*i] - r[*j]) - 1.0).abs()).fold(0.0, f64::max);
    (off > 1e-2 || force > 1e-2 || tree && unset > 1e-2)
        .then(|| format!("thm1a, thm1c, cor1: {off}, {force}, {unset} for {:?} from {x:?}", flock.graph))
}

/// Two agents without link collide from some start, on any graph that leaves them unlinked.
fn collisions(random: &mut Random) -> Option<String> {
    let n = 3 + below(random, 2);
    let mut graph = connected(random, n);
    (graph[0][1], graph[1][0]) = (0.0, 0.0);
    let flock = Flock::draw(random, graph, true);
    let mut x = start(random, n, 2.0, 1.0);
    (x[4], x[5]) = (x[0], x[1]);
    let back = flow(|x| flock.aligned(x).iter().map(|y| -y).collect(), x, 1e-3, 100);
    let forth = split(&flow(|x| flock.aligned(x), back.clone(), 1e-3, 100)).0;
    let (r, _) = split(&back);
    let apart = pairs(n).all(|(i, j)| norm(r[i] - r[j]) > 1e-4);
    (!apart || norm(forth[0] - forth[1]) > 1e-6).then(|| "noninter".to_string())
}

/// Without potentials: the disagreement decays at `lambda_2` at least, exactly so for its eigenvectors.
fn rates(random: &mut Random) -> Option<String> {
    let n = 2 + below(random, 4);
    let graph = connected(random, n);
    let second = eigenvalues(&matrix(&graph))[1];
    let v: Vec<f64> = (0..n).map(|_| between(random, -1.0, 1.0)).collect();
    let field =
        |v: &[f64]| (0..n).map(|i| -(0..n).map(|j| graph[i][j] * (v[i] - v[j])).sum::<f64>()).collect::<Vec<f64>>();
    let off = |v: &[f64]| {
        let middle = v.iter().sum::<f64>() / n as f64;
        v.iter().map(|x| (x - middle).powi(2)).sum::<f64>().sqrt()
    };
    let end = flow(field, v.clone(), 0.002, 500);
    (off(&end) > (-second).exp() * off(&v) + 1e-8).then(|| format!("cor2_rate: {graph:?}"))
}

/// A pair of agents on a line swings between fixed distances; a triangle of squared side 2 turns for ever.
fn exact_motions(_: &mut Random) -> Option<String> {
    let pair = Flock { graph: complete(2), scale: vec![vec![1.0; 2]; 2], stiffness: 1.0, logarithmic: true };
    let mut x = vec![0.0, 0.0, 2.0, 0.0, 2.0, 0.0, 2.0, 0.0];
    let (mut least, mut most, mut pushes) = (f64::INFINITY, 0.0f64, [false; 2]);
    for step in 0..4000 {
        x = flow(|x| pair.gyroscopic(x, raw), x, 0.005, 1);
        let (r, v) = split(&x);
        if v.iter().any(|v| v.1.abs() > 1e-9 || v.0 <= 0.0) {
            return Some("propIV3b: a heading turns".to_string());
        }
        if step > 2000 {
            (least, most) = (least.min(norm(r[0] - r[1])), most.max(norm(r[0] - r[1])));
            pushes[usize::from(dot(pair.gradients(&r)[0], v[0]) > 0.0)] = true;
        }
    }
    if (most - 2.0).abs() > 1e-2 || least > 0.9 || pushes != [true; 2] {
        return Some(format!("propIV3b, proof_cases: {least} to {most}"));
    }
    // Two with the same heading, at (0, 0) and (1, 1), whose V_t grows.
    let start = [0.0, 0.0, 0.0, 2.0, 1.0, 1.0, 0.0, 1.0];
    let v_t = |x: &[f64]| pair.energy(x) + split(x).1.iter().map(|v| heading(*v).powi(2)).sum::<f64>() / 2.0;
    let grows = along(v_t, &start, &pair.gyroscopic(&start, raw));
    if (grows - PI / 8.0).abs() > 1e-6 {
        return Some(format!("eq9: {grows}"));
    }
    let three = Flock { graph: complete(3), scale: vec![vec![1.0; 3]; 3], stiffness: 1.0, logarithmic: true };
    let (radius, omega) = ((2.0f64 / 3.0).sqrt(), 1.5f64.sqrt());
    let r: Vec<Z> = (0..3).map(|k| turn(0.3 + TAU * f64::from(k) / 3.0) * radius).collect();
    let v: Vec<Z> = r.iter().map(|r| I * *r * omega).collect();
    let off = |r: &[Z]| r.iter().map(|r| (norm(*r) - radius).abs()).fold(0.0, f64::max);
    let end = flow(|x| three.gyroscopic(x, wrapped), join(&r, &v), 1e-3, 5000);
    (off(&split(&end).0) > 1e-5).then(|| format!("turning_triangle: {}", off(&split(&end).0)))
}

/// Near the triangle and the pair at the desired distance: back to it; and the rates of the linearised loop by hand: a mode of damping `l`
/// and stiffness `h` has the slower root of `s^2 + l s + h`.
fn near_minima(random: &mut Random) -> Option<String> {
    let n = 2 + below(random, 2);
    let flock = Flock { graph: complete(n), scale: vec![vec![1.0; n]; n], stiffness: 1.0, logarithmic: false };
    let r = [Z(0.0, 0.0), Z(1.0, 0.0), Z(0.5, 0.75f64.sqrt())];
    let nudge = vectors(random, n, 0.05);
    let r: Vec<Z> = r[..n].iter().zip(nudge).map(|(r, d)| *r + d).collect();
    let common = Z(between(random, -1.0, 1.0), 0.3);
    let v: Vec<Z> = vectors(random, n, 0.05).into_iter().map(|v| v + common).collect();
    let (r, _) = split(&flow(|x| flock.aligned(x), join(&r, &v), 0.01, 3000));
    let off = flock.edges().iter().map(|(i, j)| (norm(r[*i] - r[*j]) - 1.0).abs()).fold(0.0, f64::max);
    let slow = |l: f64, h: f64| if l * l > 4.0 * h { (l - (l * l - 4.0 * h).sqrt()) / 2.0 } else { l / 2.0 };
    // With V = k(s + 1/s - 2) an edge of length 1 has the stiffness 8k: pair 16k, row 8k and 24k, triangle 12k and 24k.
    let k = 1.0 / 32.0;
    let pair = slow(2.0, 16.0) > 0.5 && slow(2.0, 16.0 * k) < 0.5;
    let row = slow(1.0, 8.0 * k).min(slow(3.0, 24.0 * k)) > 0.2;
    let triangle = slow(3.0, 12.0 * k).min(slow(3.0, 24.0 * k)) < 0.2;
    (off > 1e-3 || !pair || !row || !triangle).then(|| format!("sec4.flocking, cor2_rate: {off}"))
}

/// Under (4), (5) of the first paper linked agents fly at each other: no nearer, and on connected graphs no further, than the energy allows.
fn head_on(random: &mut Random) -> Option<String> {
    let n = 2 + below(random, 2);
    let graph = connected(random, n);
    let flock = Flock::draw(random, graph, true);
    let mut x = start(random, n, 2.0, 1.0);
    let (i, j) = flock.edges()[0];
    let way = split(&x).0[j] - split(&x).0[i];
    for (k, side) in [(i, 3.0), (j, -3.0)] {
        (x[4 * k + 2], x[4 * k + 3]) = (way.0 * side / norm(way), way.1 * side / norm(way) + 1e-3);
    }
    let c = flock.energy(&x);
    let most = flock.edges().iter().map(|(i, j)| flock.reach(*i, *j, c)).fold(0.0, f64::max);
    for _ in 0..40 {
        x = flow(|x| flock.gyroscopic(x, wrapped), x, 5e-4, 100);
        let r = split(&x).0;
        let near = flock.edges().iter().any(|(i, j)| flock.value(*i, *j, dot(r[*i] - r[*j], r[*i] - r[*j])) > c + 1e-2);
        let far = pairs(n).any(|(i, j)| norm(r[i] - r[j]) > (n as f64 - 1.0) * most + 1e-2);
        if near || far || (flock.energy(&x) - c).abs() > 1e-2 * (1.0 + c) {
            return Some(format!("collision, anyV, Vt_inv: from {c} to {}", flock.energy(&x)));
        }
    }
    None
}

/// Second differences of the controls of the first paper where velocities are equal, along the positive x axis, or any: they settle.
fn smooth_controls(random: &mut Random) -> Option<String> {
    let n = 1 + below(random, 3);
    let graph = connected(random, n);
    let flock = Flock::draw(random, graph, true);
    let mut x = start(random, n, 2.0, 2.0);
    match below(random, 3) {
        0 => (0..n).for_each(|i| (x[4 * i + 2], x[4 * i + 3]) = (0.7, 0.4)),
        1 => (0..n).for_each(|i| (x[4 * i + 2], x[4 * i + 3]) = (1.0 + i as f64, 0.0)),
        _ => (),
    }
    if split(&x).1.iter().any(|v| heading(*v).abs() > 3.0) {
        return None;
    }
    let way: Vec<f64> = x.iter().map(|_| between(random, -1.0, 1.0)).collect();
    let second = |h: f64| -> Vec<f64> {
        let at = |t: f64| flock.gyroscopic(&x.iter().zip(&way).map(|(x, w)| x + t * w).collect::<Vec<_>>(), raw);
        at(h).iter().zip(at(0.0)).zip(at(-h)).map(|((a, b), c)| (a - 2.0 * b + c) / (h * h)).collect()
    };
    let pairs = second(1e-3).into_iter().zip(second(5e-4));
    pairs
        .map(|(a, b)| (a - b).abs() / (1.0 + a.abs()))
        .find(|off| *off > 0.05)
        .map(|off| format!("smooth: {off}, {x:?}"))
}

/// `1/d² + log d²` from a thousandth to a thousand: down to 1, up from there.
fn figure_2(_: &mut Random) -> Option<String> {
    let value = |k: i32| (10f64.powf(f64::from(k) / 100.0).powi(2)).ln() + 10f64.powf(-f64::from(k) / 50.0);
    let wrong = (-300..300).find(|k| (value(*k) > value(k + 1)) != (*k < 0));
    wrong.map(|k| format!("Vmono, fig2: at 10^({k}/100)"))
}

#[test]
fn flocks_survive() {
    survive(&[
        Attempt { name: "velocity alignment", tries: 150, seek: velocity_alignment },
        Attempt { name: "heading alignment", tries: 200, seek: heading_alignment },
        Attempt { name: "matrices", tries: 200, seek: matrices },
        Attempt { name: "bounds", tries: 300, seek: bounds },
        Attempt { name: "limits", tries: 8, seek: limits },
        Attempt { name: "collisions", tries: 20, seek: collisions },
        Attempt { name: "rates without potentials", tries: 40, seek: rates },
        Attempt { name: "exact motions", tries: 1, seek: exact_motions },
        Attempt { name: "near minima", tries: 4, seek: near_minima },
        Attempt { name: "straight at each other", tries: 8, seek: head_on },
        Attempt { name: "smooth controls", tries: 60, seek: smooth_controls },
        Attempt { name: "the potential of Figure 2", tries: 1, seek: figure_2 },
    ]);
}
