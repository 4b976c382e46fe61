//! Phases: order parameters, Laplacian potentials, patterns.

use super::*;

fn circle(angles: &[f64]) -> Vec<Z> {
    angles.iter().map(|t| turn(*t)).collect()
}

/// `p_m = (1/(mN)) sum e^{i m theta_k}`.
fn order(angles: &[f64], m: usize) -> Z {
    mean(&angles.iter().map(|t| turn(m as f64 * t)).collect::<Vec<_>>()) * (1.0 / m as f64)
}

fn potential(angles: &[f64], m: usize) -> f64 {
    angles.len() as f64 / 2.0 * dot(order(angles, m), order(angles, m))
}

/// `W_1 = (1/(2N)) <e^{i theta}, L e^{i theta}>`.
fn w1(graph: &Graph, angles: &[f64]) -> f64 {
    let z = circle(angles);
    let sum: f64 = z.iter().zip(laplacian(graph, &z)).map(|(z, l)| dot(*z, l)).sum();
    sum / (2.0 * z.len() as f64)
}

/// `<i e^{i theta_k}, L_k e^{i theta}>`.
fn tau(graph: &Graph, angles: &[f64]) -> Vec<f64> {
    let z = circle(angles);
    z.iter().zip(laplacian(graph, &z)).map(|(z, l)| dot(I * *z, l)).collect()
}

fn spread(angles: &[f64], members: impl Fn(usize) -> bool) -> f64 {
    let own: Vec<f64> = angles.iter().enumerate().filter(|(k, _)| members(*k)).map(|(_, t)| *t).collect();
    own.iter().map(|t| wrap(t - own[0]).abs()).fold(0.0, f64::max)
}

/// The phases of an (M,N)-pattern with members in any order, turned by any angle.
fn pattern(random: &mut Random, clusters: usize, n: usize) -> Vec<f64> {
    let (start, mut list) = (between(random, 0.0, TAU), (0..n).map(|k| k % clusters).collect::<Vec<_>>());
    for k in (1..n).rev() {
        list.swap(k, below(random, k + 1));
    }
    list.into_iter().map(|c| start + TAU * c as f64 / clusters as f64).collect()
}

/// Whether the phases are `M` equal clusters evenly spaced.
fn is_pattern(angles: &[f64], clusters: usize) -> bool {
    let zero = (1..clusters).all(|m| norm(order(angles, m)) < 1e-4);
    zero && (clusters as f64 * norm(order(angles, clusters)) - 1.0).abs() < 1e-4
}

fn u1_u_m(random: &mut Random) -> Option<String> {
    let n = 1 + below(random, 6);
    let (t, m) = (phases(random, n), 1 + below(random, 4));
    let p = order(&t, 1);
    let slopes = gradient(|t| potential(t, 1), &t);
    let sum: f64 = slopes.iter().sum();
    let rate = along(|t| potential(t, 1), &t, &slopes.iter().map(|s| -0.7 * s).collect::<Vec<_>>());
    let square: f64 = slopes.iter().map(|s| s * s).sum();
    let turned: Vec<f64> = t.iter().map(|t| t + 0.3).collect();
    let first = (0..n).find_map(|k| unlike("eq8_10", slopes[k], dot(I * turn(t[k]), p)));
    first
        .or_else(|| unlike("1^T grad", sum, 0.0))
        .or_else(|| unlike("Udot", rate, -0.7 * square))
        .or_else(|| unlike("rotations", potential(&t, m), potential(&turned, m)))
        .or_else(|| (norm(p) > 1.0 + 1e-9).then(|| "eq7".to_string()))
        .or_else(|| {
            let most = n as f64 / (2.0 * (m * m) as f64);
            let all_equal = (0..n).all(|k| wrap(m as f64 * (t[k] - t[0])).abs() < 1e-6);
            ((potential(&t, m) > most + 1e-9) || (all_equal != (potential(&t, m) > most - 1e-9)))
                .then(|| format!("Um, m = {m}, {t:?}"))
        })
}

/// Stationary points found by Newton-like descent of the squared gradient: synchronised, balanced, or saddles with all sines zero.
fn critical_points(random: &mut Random) -> Option<String> {
    let n = 2 + below(random, 4);
    let field = |t: &[f64]| gradient(|t| potential(t, 1), t);
    let size = |t: &[f64]| field(t).iter().map(|g| g * g).sum::<f64>();
    let descend = |t: &[f64]| gradient(size, t).iter().map(|g| -4.0 * g).collect::<Vec<f64>>();
    let end = flow(descend, phases(random, n), 0.25, 400);
    if size(&end) > 1e-9 {
        return None;
    }
    let (p, z) = (norm(order(&end, 1)), circle(&end));
    let sines =
        (0..n).flat_map(|k| (0..k).map(move |j| (k, j))).map(|(k, j)| cross(z[k], z[j]).abs()).fold(0.0, f64::max);
    if !(0.02..=0.999).contains(&p) || sines > 0.05 {
        return (p > 0.05 && sines > 0.2).then(|| format!("a critical point off the list: {end:?}"));
    }
    // b of N opposite: (b, N-b-1, 1) positive, negative, zero.
    let few = z.iter().filter(|w| dot(**w, z[0]) < 0.0).count();
    let few = few.min(n - few);
    let exact: Vec<f64> = z.iter().map(|w| if dot(*w, z[0]) < 0.0 { PI } else { 0.0 }).collect();
    let values = eigenvalues(&jacobian(field, &exact));
    let count = |test: fn(f64) -> bool| values.iter().filter(|x| test(**x)).count();
    let found = (count(|x| x > 1e-3), count(|x| x < -1e-3));
    (found != (few, n - few - 1)).then(|| format!("inertia {found:?} with {few} of {n} opposite"))
}

/// Gradient flow of `-K_1 U_1` from random starts: ends synchronised or balanced, as the sign says, and from nowhere else.
fn gradient_flow(random: &mut Random) -> Option<String> {
    let (n, k) = (2 + below(random, 4), sign(random));
    let start: Vec<f64> = (0..n).map(|_| between(random, 0.0, TAU)).collect();
    let end = flow(|t| gradient(|t| potential(t, 1), t).iter().map(|g| -k * g).collect(), start, 0.4, 1500);
    let p = norm(order(&end, 1));
    let right = if k > 0.0 { p < 1e-3 } else { p > 0.999 };
    (!right).then(|| format!("N = {n}, K_1 = {k}: |p| = {p}"))
}

/// Directed and undirected potentials, stationary points, equivalence of forms.
fn laplacian_potential(random: &mut Random) -> Option<String> {
    let n = 1 + below(random, 6);
    let (t, count) = (phases(random, n), n as f64);
    let one_way = directed(random, n);
    let w = w1(&one_way, &t);
    let label = components(&one_way);
    let apart = (0..n).map(|c| spread(&t, |k| label[k] == c)).fold(0.0, f64::max);
    if w < -1e-12 || (w < 1e-12) != (apart < 1e-5) {
        return Some(format!("W_1 = {w} but phases of a component are {apart} apart: {one_way:?}"));
    }
    let graph = undirected(random, n);
    let (slopes, own) = (gradient(|t| w1(&graph, t), &t), tau(&graph, &t));
    let length: f64 = (0..n)
        .flat_map(|k| (0..n).map(move |j| (k, j)))
        .map(|(k, j)| {
            let step = turn(t[k]) - turn(t[j]);
            graph[k][j] * dot(step, step)
        })
        .sum();
    let sines = |k: usize| (0..n).map(|j| graph[k][j] * (t[k] - t[j]).sin()).sum::<f64>();
    let rate = along(|t| w1(&graph, t), &t, &own.iter().map(|x| 0.7 / count * x).collect::<Vec<_>>());
    let square: f64 = own.iter().map(|x| x * x).sum();
    (0..n)
        .find_map(|k| unlike("gradW", slopes[k], own[k] / count).or_else(|| unlike("eq15", own[k], sines(k))))
        .or_else(|| unlike("length", w1(&graph, &t), length / (4.0 * count)))
        .or_else(|| unlike("eq14_15", rate, 0.7 / (count * count) * square))
        .or_else(|| unlike("eq13", w1(&complete(n), &t), count / 2.0 - potential(&t, 1)))
        .or_else(|| {
            let m = 1 + below(random, 4);
            let z: Vec<Z> = t.iter().map(|t| turn(m as f64 * t) * (1.0 / m as f64)).collect();
            let sum: f64 = z.iter().zip(laplacian(&complete(n), &z)).map(|(z, l)| dot(*z, l)).sum();
            unlike("Wm", sum / (2.0 * count), count / (2.0 * (m * m) as f64) - potential(&t, m))
        })
        .or_else(|| unlike("scale.complete", 2.0 / count * w1(&complete(n), &t), 1.0 - dot(order(&t, 1), order(&t, 1))))
        .or_else(|| {
            // The leader's potential is least where all phases are that of the reference.
            let value = w1(&graph, &t) + 1.0 - (0.4 - t[n - 1]).cos();
            let least = w1(&graph, &vec![0.4; n]);
            (value < least - 1e-12).then(|| "ref".to_string())
        })
}

/// The nearest `n` neighbours of random places: the scales of Figure S3.
fn scales(random: &mut Random) -> Option<String> {
    let fish = 2 + below(random, 6);
    let (places, t) = (vectors(random, fish, 1.0), phases(random, fish));
    let nearest = |n: usize| -> Graph {
        let mut graph = vec![vec![0.0; fish]; fish];
        for k in 0..fish {
            let mut others: Vec<usize> = (0..fish).filter(|j| *j != k).collect();
            others.sort_by(|a, b| norm(places[*a] - places[k]).total_cmp(&norm(places[*b] - places[k])));
            others.iter().take(n).for_each(|j| graph[k][*j] = 1.0);
        }
        graph
    };
    (1..fish)
        .find_map(|n| {
            let w = w1(&nearest(n), &t);
            let figure = 2.0 / (n as f64 + 1.0) * w;
            let extreme = n == 1 || n + 1 == fish;
            let outside = |x: f64| !(-1e-12..=1.0 + 1e-12).contains(&x);
            (outside(w / n as f64) || extreme && outside(figure)).then(|| format!("scale, n = {n}: {w}"))
        })
        .or_else(|| {
            // Per arc, the sign of the difference is that of the synchrony of neighbours against all pairs.
            let arcs = |graph: &Graph| {
                let pairs = (0..fish).flat_map(|k| (0..fish).map(move |j| (k, j))).filter(|(k, j)| graph[*k][*j] > 0.0);
                let list: Vec<f64> = pairs.map(|(k, j)| 1.0 - (t[k] - t[j]).cos()).collect();
                list.iter().sum::<f64>() / list.len() as f64
            };
            let (all, one) = (nearest(fish - 1), nearest(1));
            let difference = w1(&all, &t) / (fish as f64 - 1.0) - w1(&one, &t);
            unlike("figS3.difference", 2.0 * difference, arcs(&all) - arcs(&one))
        })
}

/// Patterns: moments, `U^{M,N}`, balance.
fn patterns(random: &mut Random) -> Option<String> {
    let n = 1 + below(random, 8);
    let divisors: Vec<usize> = (1..=n).filter(|m| n.is_multiple_of(*m)).collect();
    let m = divisors[below(random, divisors.len())];
    let t = pattern(random, m, n);
    if !is_pattern(&t, m) || m > 1 && norm(order(&t, 1)) > 1e-9 {
        return Some(format!("eq23: ({m},{n})"));
    }
    // The least value of U^{M,N} by descent from anywhere is that of the pattern, and only patterns reach it.
    let gains: Vec<f64> =
        (1..=m).map(|j| if j < m { between(random, 0.5, 2.0) } else { -between(random, 0.1, 2.0) }).collect();
    let value = |t: &[f64]| gains.iter().enumerate().map(|(j, k)| k * potential(t, j + 1)).sum::<f64>();
    let start: Vec<f64> = (0..n).map(|_| between(random, 0.0, TAU)).collect();
    let end = flow(|t| gradient(value, t).iter().map(|g| -g).collect(), start, 0.2, 600);
    let (least, found) = (value(&t), value(&end));
    let lower = found < least - 1e-7;
    let other = found < least + 1e-9 && !is_pattern(&end, m);
    (lower || other).then(|| format!("thm3.min: ({m},{n}), {found} and {least} at {end:?}"))
}

/// Circulant graphs, one-way too: the splay state is balanced and stationary; eigenvectors of C_N with entries of modulus one.
fn circulants(random: &mut Random) -> Option<String> {
    let n = 2 + below(random, 9);
    let offsets: Vec<usize> = (1..n).filter(|_| below(random, 3) == 0).collect();
    let (both, column) = (below(random, 2) == 0, below(random, n));
    let graph = circulant(n, &offsets, both);
    if n > 2 {
        let (whole, ring) = (matrix(&complete(n)), matrix(&circulant(n, &[1], true)));
        let joined = components(&circulant(n, &[1], true)).iter().all(|c| *c == 0);
        let row = |j: usize| if j == 0 { 2.0 } else { -f64::from(u8::from(j == 1 || j + 1 == n)) };
        let wrong = |j: usize| whole[0][j] != if j == 0 { n as f64 - 1.0 } else { -1.0 } || ring[0][j] != row(j);
        if !joined || (0..n).any(|j| wrong(j) || ring[j][j] != 2.0 || whole[j][j] != n as f64 - 1.0) {
            return Some(format!("CN: {n}"));
        }
    }
    let t: Vec<f64> = (0..n).map(|k| TAU * (column * k % n) as f64 / n as f64).collect();
    let z = circle(&t);
    let image = laplacian(&graph, &z);
    let factor = image[0];
    if (0..n).any(|k| norm(image[k] - factor * z[k]) > 1e-9) {
        return Some("graph: the Fourier columns diagonalise a circulant Laplacian".to_string());
    }
    // Stationary for W_1 itself, directed or not.
    let slopes = gradient(|t| w1(&graph, t), &t);
    if column > 0 && (norm(mean(&z)) > 1e-9 || slopes.iter().any(|g| g.abs() > 1e-6)) {
        return Some(format!("balexist: column {column} of {n}, offsets {offsets:?}"));
    }
    let clusters = n / gcd(n, column);
    (!is_pattern(&t, clusters)).then(|| format!("eig.sym: column {column} of {n}"))
}

fn gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// Combinations of the two columns of a double eigenvalue of C_N with entries of modulus one: columns only, but for eigenvalue 2.
fn double_eigenvalues(random: &mut Random) -> Option<String> {
    let n = 3 + below(random, 10);
    let m = 1 + below(random, (n - 1) / 2);
    let (a, b) = (between(random, 0.0, 1.0), between(random, 0.0, TAU));
    let vector: Vec<Z> = (0..n)
        .map(|k| {
            let phase = TAU * (m * k % n) as f64 / n as f64;
            turn(phase) * a.sqrt() + turn(b - phase) * (1.0 - a).sqrt()
        })
        .collect();
    let off = vector.iter().map(|z| (norm(*z) - norm(vector[0])).abs()).fold(0.0, f64::max);
    let mixed = a > 0.01 && a < 0.99;
    if n.is_multiple_of(4) {
        // (u, v, -u, -v, ..): always of the eigenvalue 2, and hardly ever a pattern.
        let (u, v) = (between(random, 0.0, TAU), between(random, 0.0, TAU));
        let t: Vec<f64> = (0..n).map(|k| [u, v, u + PI, v + PI][k % 4]).collect();
        let z = circle(&t);
        let image = laplacian(&circulant(n, &[1], true), &z);
        let symmetric = (1..=n).any(|m| n.is_multiple_of(m) && is_pattern(&t, m));
        let special = (0..8).any(|k| wrap(v - u - f64::from(k) * PI / 4.0).abs() < 1e-2);
        if (0..n).any(|k| norm(image[k] - z[k] * 2.0) > 1e-9) || symmetric && !special {
            return Some(format!("C_{n}: {u}, {v}"));
        }
    }
    (off < 1e-9 && mixed && 4 * m != n).then(|| format!("C_{n}, column {m}: {vector:?}"))
}

/// Laplacians of directed graphs: no eigenvalue in the open left half plane (determinants at random points there), `L 1 = 0`, zero simple on
/// strongly connected graphs.
fn laplacians(random: &mut Random) -> Option<String> {
    let n = 1 + below(random, 6);
    let graph = directed(random, n);
    let l = matrix(&graph);
    let s = Z(-between(random, 1e-3, 4.0), between(random, -4.0, 4.0));
    let shifted = |s: Z| -> Vec<Vec<Z>> {
        (0..n).map(|k| (0..n).map(|j| Z(-l[k][j], 0.0) + if k == j { s } else { Z::default() }).collect()).collect()
    };
    if norm(determinant(shifted(s))) < 1e-9 * norm(s).powi(n as i32)
        || l.iter().any(|row| row.iter().sum::<f64>().abs() > 1e-12)
    {
        return Some(format!("graph: {graph:?} at {s:?}"));
    }
    let reaches = |start: usize| {
        let mut seen = vec![false; n];
        let mut stack = vec![start];
        while let Some(k) = stack.pop() {
            if !std::mem::replace(&mut seen[k], true) {
                stack.extend((0..n).filter(|j| graph[k][*j] > 0.0));
            }
        }
        seen.into_iter().all(|s| s)
    };
    if n > 1 && (0..n).all(reaches) {
        // det(s - L)/s at s -> 0 is not zero.
        let quotient = norm(determinant(shifted(Z(1e-6, 0.0)))) / 1e-6;
        return (quotient < 1e-3).then(|| format!("graph: zero not simple for {graph:?}"));
    }
    let both = undirected(random, n);
    (eigenvalues(&matrix(&both))[0] < -1e-9).then(|| "graph: not semidefinite".to_string())
}

/// One (b, N-b) arrangement that is not half and half: pushed off it, the phases leave, for both signs of `K_1`.
fn unbalanced(random: &mut Random) -> Option<String> {
    let n = 3 + below(random, 3);
    let few = 1 + below(random, n - 1);
    if 2 * few == n {
        return None;
    }
    let rest: Vec<f64> = (0..n).map(|k| if k < few { PI } else { 0.0 }).collect();
    let pushed: Vec<f64> = rest.iter().map(|t| t + between(random, -1e-3, 1e-3)).collect();
    let k = sign(random);
    let end = flow(|t| gradient(|t| potential(t, 1), t).iter().map(|g| -k * g).collect(), pushed.clone(), 0.4, 400);
    let away = (0..n).map(|j| wrap(end[j] - end[0] - rest[j] + rest[0]).abs()).fold(0.0, f64::max);
    (away < 0.05).then(|| format!("unbal: {few} of {n}, K_1 = {k}: {pushed:?} stays"))
}

/// Opposite pairs and triangles at any angles, on a line or not: the Hessian of `U_1` has rank 2 or 1, positive.
fn balanced(random: &mut Random) -> Option<String> {
    let (pairs, triangles) = (1 + below(random, 3), below(random, 2));
    let straight = triangles == 0 && below(random, 2) == 0;
    let mut t = Vec::new();
    for k in 0..pairs {
        let start = if straight { 0.3 } else { 0.3 + k as f64 * between(random, 0.4, 0.9) };
        t.extend([start, start + PI]);
    }
    (0..triangles).for_each(|_| t.extend([0.1, 0.1 + TAU / 3.0, 0.1 + 2.0 * TAU / 3.0]));
    let line = triangles == 0 && (straight || pairs == 1);
    let values = eigenvalues(&jacobian(|t| gradient(|t| potential(t, 1), t), &t));
    let found = (values.iter().filter(|x| **x > 1e-3).count(), values.iter().filter(|x| **x < -1e-3).count());
    (found != (if line { 1 } else { 2 }, 0)).then(|| format!("inertia: {found:?} at {t:?}"))
}

/// Incidence matrices with one column for each edge, directed either way, and with one for each direction; no edges too.
fn incidence(random: &mut Random) -> Option<String> {
    let n = 1 + below(random, 5);
    let graph = undirected(random, n);
    let l = matrix(&graph);
    let (mut once, mut twice) = (vec![vec![0.0; n]; n], vec![vec![0.0; n]; n]);
    for (k, j) in pairs(n).filter(|(k, j)| graph[*k][*j] > 0.0) {
        let way = sign(random);
        for (product, ways) in [(&mut once, vec![way]), (&mut twice, vec![1.0, -1.0])] {
            for way in ways {
                let column: Vec<f64> = (0..n)
                    .map(|i| {
                        if i == k {
                            way
                        } else if i == j {
                            -way
                        } else {
                            0.0
                        }
                    })
                    .collect();
                for (row, x) in product.iter_mut().zip(&column) {
                    row.iter_mut().zip(&column).for_each(|(entry, y)| *entry += x * y);
                }
            }
        }
    }
    let same = (0..n).all(|k| (0..n).all(|j| l[k][j] == once[k][j] && 2.0 * l[k][j] == twice[k][j]));
    (!same).then(|| format!("incid: {graph:?}"))
}

/// All ways to put four fish at two opposite headings, by number.
fn four_fish(_: &mut Random) -> Option<String> {
    let unbalanced: Vec<(u32, f64)> = (1..15u32)
        .map(|code| {
            (code.count_ones(), (0..4).map(|k| if code >> k & 1 == 1 { PI } else { 0.0 }).collect::<Vec<f64>>())
        })
        .filter(|(_, t)| norm(order(t, 1)) > 1e-9)
        .map(|(few, t)| (few.min(4 - few), 2.0 / 4.0 * w1(&complete(4), &t)))
        .collect();
    let wrong = unbalanced.iter().any(|(few, value)| *few != 1 || (value - 0.75).abs() > 1e-12);
    // On a square each hears the two next to it, all opposite: 4/3.
    let square = 2.0 / 3.0 * w1(&circulant(4, &[1], true), &[0.0, PI, 0.0, PI]);
    if (square - 4.0 / 3.0).abs() > 1e-12 {
        return Some(format!("scale: {square}"));
    }
    (unbalanced.len() != 8 || wrong).then(|| format!("fishpeak: {unbalanced:?}"))
}

#[test]
fn phases_survive() {
    survive(&[
        Attempt { name: "order parameters", tries: 300, seek: u1_u_m },
        Attempt { name: "critical points of U_1", tries: 6, seek: critical_points },
        Attempt { name: "gradient flow of U_1", tries: 12, seek: gradient_flow },
        Attempt { name: "Laplacian potentials", tries: 200, seek: laplacian_potential },
        Attempt { name: "scales", tries: 200, seek: scales },
        Attempt { name: "patterns", tries: 8, seek: patterns },
        Attempt { name: "circulant graphs", tries: 200, seek: circulants },
        Attempt { name: "double eigenvalues of C_N", tries: 300, seek: double_eigenvalues },
        Attempt { name: "Laplacians", tries: 300, seek: laplacians },
        Attempt { name: "unbalanced arrangements", tries: 12, seek: unbalanced },
        Attempt { name: "balanced arrangements", tries: 30, seek: balanced },
        Attempt { name: "incidence", tries: 60, seek: incidence },
        Attempt { name: "four fish", tries: 1, seek: four_fish },
    ]);
}
