//! Links by distance and by signals, the saturated potential, discontinuous right sides.

use super::flocks::{Flock, join, split, start};
use super::*;

/// Links below `R`; the potential is the same for all pairs.
fn within(r: &[Z], radius: f64) -> Graph {
    let near = |i: usize, j: usize| i != j && norm(r[i] - r[j]) < radius;
    (0..r.len()).map(|i| (0..r.len()).map(|j| f64::from(u8::from(near(i, j)))).collect()).collect()
}

fn flock(graph: Graph) -> Flock {
    let n = graph.len();
    Flock { graph, scale: vec![vec![1.0; n]; n], stiffness: 1.0, logarithmic: false }
}

fn by_distance(x: &[f64], radius: f64) -> Vec<f64> {
    flock(within(&split(x).0, radius)).aligned(x)
}

/// `½ sum_i (sum_j U_ij + |v_i|²)` with `V = s + 1/s - 2`, saturated at `R`.
fn q(x: &[f64], radius: f64) -> f64 {
    let (r, v) = split(x);
    let (n, all) = (r.len(), flock(complete(r.len())));
    let term = |i: usize, j: usize| {
        let s = dot(r[i] - r[j], r[i] - r[j]).min(radius * radius);
        if i == j { 0.0 } else { all.value(i, j, s) }
    };
    (0..n).map(|i| (0..n).map(|j| term(i, j)).sum::<f64>() + dot(v[i], v[i])).sum::<f64>() / 2.0
}

/// The largest difference of a velocity from the mean.
fn disagreement(x: &[f64]) -> f64 {
    let v = split(x).1;
    v.iter().map(|w| norm(*w - mean(&v))).fold(0.0, f64::max)
}

fn is_connected(graph: &Graph) -> bool {
    components(graph).iter().all(|c| *c == 0)
}

/// Both forms of Q, its rate away from ties, the one-sided derivatives at a tie.
fn saturated(random: &mut Random) -> Option<String> {
    let (n, radius) = (1 + below(random, 4), between(random, 1.2, 3.0));
    let x = start(random, n, 2.0, 2.0);
    let (r, v) = split(&x);
    let graph = within(&r, radius);
    let own = flock(graph.clone());
    let unlinked = pairs(n).filter(|(i, j)| graph[*i][*j] == 0.0).count();
    let value = own.value(0, 0, radius * radius);
    let field = by_distance(&x, radius);
    let form: f64 = v.iter().zip(laplacian(&graph, &v)).map(|(v, l)| dot(*v, l)).sum();
    let tied = (0..n).any(|i| (0..i).any(|j| (norm(r[i] - r[j]) - radius).abs() < 1e-3));
    unlike("Q", q(&x, radius), own.energy(&x) + unlinked as f64 * value)
        .or_else(|| if tied { None } else { unlike("Qdot", along(|x| q(x, radius), &x, &field), -form) })
        .or_else(|| {
            // U at R as a function of the distance: U' = min(0, cw), U° = max(0, cw) over base points on both sides.
            let u = |d: f64| own.value(0, 0, d.min(radius).powi(2));
            let c = 2.0 * radius * own.slope(0, 0, radius * radius);
            let (w, h) = (sign(random) * between(random, 0.5, 2.0), 1e-6);
            let one_sided = (u(radius + h * w) - u(radius)) / h;
            let upper = (0..40)
                .map(|k| radius + (f64::from(k) - 20.0) * 0.2 * h)
                .map(|y| (u(y + h * w) - u(y)) / h)
                .fold(f64::MIN, f64::max);
            let near = |a: f64, b: f64| (a - b).abs() < 1e-3 * (1.0 + c.abs());
            (!near(one_sided, (c * w).min(0.0)) || !near(upper, (c * w).max(0.0)))
                .then(|| format!("lem1, lem2: {one_sided}, {upper}, cw = {}", c * w))
        })
}

/// Two agents at R: the derivatives of Q for all weights of the law and of the gradient against the hull of (13).
fn hull(random: &mut Random) -> Option<String> {
    let (radius, v) = (2.0, vectors(random, 2, 3.0));
    let own = flock(complete(2));
    let (d, w) = (Z(-radius, 0.0), v[0] - v[1]);
    let p = own.slope(0, 1, radius * radius) * 2.0 * dot(d, w);
    let square = dot(w, w);
    // z.p - m.(p + q) with m, z in [0, 1]: for which x is there an m for each z?
    let reachable = |x: f64, z: f64| {
        (0..=1000)
            .map(|k| f64::from(k) / 1000.0)
            .any(|m| (z * p - m * (p + square) - x).abs() < 0.004 * (1.0 + p.abs() + square))
    };
    let x = between(random, -square - 2.0, 2.0);
    let inside = (0..=50).all(|k| reachable(x, f64::from(k) / 50.0));
    let slack = 0.01 * (1.0 + p.abs() + square);
    (inside && (x > slack || x < -square - slack)).then(|| format!("eq13: {x} with p = {p}, q = {square}"))
}

/// Runs with links by distance: Q does not increase, nobody collides; while the graph stays connected, velocities come to agree.
fn distance_runs(random: &mut Random) -> Option<String> {
    let n = 2 + below(random, 3);
    let radius = between(random, 1.6, 2.5);
    let mut x = start(random, n, 1.2, 0.6);
    let (first, mut joined) = (q(&x, radius), true);
    let mut before = first;
    for _ in 0..120 {
        for _ in 0..100 {
            x = flow(|x| by_distance(x, radius), x, 0.005, 1);
            joined &= is_connected(&within(&split(&x).0, radius));
        }
        let now = q(&x, radius);
        if now > before + 2e-2 || !now.is_finite() {
            return Some(format!("eq13, thm2_coll: Q from {before} to {now}"));
        }
        before = now;
    }
    let off = disagreement(&x);
    // Away from ties the forces vanish too.
    let r = split(&x).0;
    let tied = pairs(n).any(|(i, j)| (norm(r[i] - r[j]) - radius).abs() < 2e-2);
    let force = flock(within(&r, radius)).gradients(&r).iter().map(|g| norm(*g)).fold(0.0, f64::max);
    if joined && !tied && force > 5e-2 {
        return Some(format!("thm2_pot: {force} from Q = {first}"));
    }
    (joined && off > 2e-2).then(|| format!("thm2_vel: {off} from Q = {first}"))
}

/// Two paths through four agents in turn: the velocities do not come to agree.
fn two_paths(random: &mut Random) -> Option<String> {
    let tree = |edges: [(usize, usize); 3]| {
        let mut graph = vec![vec![0.0; 4]; 4];
        edges.iter().for_each(|(i, j)| (graph[*i][*j], graph[*j][*i]) = (1.0, 1.0));
        flock(graph)
    };
    let paths = [tree([(0, 1), (1, 2), (2, 3)]), tree([(1, 3), (0, 3), (0, 2)])];
    let (period, mut x) = (between(random, 0.3, 1.5), start(random, 4, 1.5, 0.5));
    let mut late = 0.0f64;
    for turn in 0..120 {
        x = flow(|x| paths[turn % 2].aligned(x), x, period / 200.0, 200);
        if !x[0].is_finite() {
            return None;
        }
        if turn > 100 {
            late = late.max(disagreement(&x));
        }
    }
    (late < 1e-3).then(|| format!("alternating_trees, arbswitch: {late} with the period {period}"))
}

/// Near the rhombus whose long diagonal is R, with slope zero there, symmetric motions pass R again and again.
fn rhombus(random: &mut Random) -> Option<String> {
    rhombus_passes(between(random, -0.02, 0.02), between(random, -0.02, 0.02))
}

/// The same from starts in one mode of the linked loop: the stiffness of the half diagonals is a multiple of ((3, √3), (√3, 5)).
fn rhombus_modes(random: &mut Random) -> Option<String> {
    let (size, root) = (sign(random) * 0.01, 3f64.sqrt());
    rhombus_passes(root * size, -size).or_else(|| rhombus_passes(size, root * size))
}

/// From the half diagonals moved by `a` and `b`.
fn rhombus_passes(a: f64, b: f64) -> Option<String> {
    let slope = |s: f64| (s - 1.0) * (s - 3.0).powi(2) * (s + 0.6) / (s * s);
    let field = |x: &[f64]| -> Vec<f64> {
        let (r, v) = split(x);
        let graph = within(&r, 3f64.sqrt());
        let damping = laplacian(&graph, &v);
        let push = |i: usize| {
            (0..4).filter(|j| graph[i][*j] > 0.0).fold(Z::default(), |sum, j| {
                let d = r[i] - r[j];
                sum + d * (2.0 * slope(dot(d, d)))
            })
        };
        join(&v, &(0..4).map(|i| -damping[i] - push(i)).collect::<Vec<_>>())
    };
    let (long, short) = (0.75f64.sqrt() + a, 0.5 + b);
    let r = [Z(long, 0.0), Z(0.0, short), Z(-long, 0.0), Z(0.0, -short)];
    let mut x = join(&r, &[Z::default(); 4]);
    let (mut passes, mut last) = (0, None);
    for _ in 0..2500 {
        x = flow(field, x, 0.002, 1);
        let r = split(&x).0;
        let inside = norm(r[0] - r[2]) < 3f64.sqrt();
        passes += usize::from(last.is_some_and(|was| was != inside));
        last = Some(inside);
    }
    (passes < 3).then(|| format!("endless_switching: {passes} passes from {a}, {b}"))
}

/// Starts of the box of the certified split.
fn split_box(random: &mut Random) -> Option<String> {
    let mut x =
        [0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 2.5, 0.0, 4.0, 0.0].map(|c| c + between(random, -1e-5, 1e-5)).to_vec();
    let mut changes = Vec::new();
    let mut graph = within(&split(&x).0, 2.0);
    if !is_connected(&graph) {
        return Some("certified_split: not connected at first".to_string());
    }
    for step in 1..=8000 {
        x = flow(|x| by_distance(x, 2.0), x, 0.001, 1);
        let now = within(&split(&x).0, 2.0);
        if now != graph {
            changes.push(f64::from(step) * 0.001);
            graph = now;
        }
    }
    let parted = graph[0][1] > 0.0 && graph[0][2] + graph[1][2] == 0.0;
    (changes.len() != 1 || changes[0] > 0.17 || !parted).then(|| format!("certified_split: {changes:?}, {graph:?}"))
}

/// A start that crosses R with a rate: two step lengths give the same motion.
fn crossing(random: &mut Random) -> Option<String> {
    let radius = 2.0;
    let v = sign(random) * between(random, 0.3, 1.0);
    let x = join(&[Z(0.0, 0.0), Z(radius, 0.0)], &[Z(0.0, between(random, -0.3, 0.3)), Z(v, 0.0)]);
    let run = |steps: usize| flow(|x| by_distance(x, radius), x.clone(), 0.3 / steps as f64, steps);
    let (coarse, fine) = (run(1000), run(3000));
    let off = coarse.iter().zip(&fine).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    (off > 2e-2).then(|| format!("eq10_exist: {off} with rate {v}"))
}

/// Step fields on the line: downward jumps keep two solutions together; along solutions `|x| + 3t` has a rate in the set (A.2).
fn filippov(random: &mut Random) -> Option<String> {
    let (left, right) = (between(random, -1.0, 1.0), between(random, -1.0, 1.0));
    // A solution from x: with the field, and at 0 the slow way where the field points inwards from both sides.
    let rate = |x: f64| match x {
        x if x.abs() > 1e-9 => {
            if x < 0.0 {
                left
            } else {
                right
            }
        }
        _ if left >= 0.0 && right <= 0.0 => 0.0,
        _ if right > 0.0 => right,
        _ => left.min(0.0),
    };
    let ends = |mut x: f64| {
        for _ in 0..1000 {
            let next = x + 1e-3 * rate(x);
            x = if x * next < 0.0 && left >= 0.0 && right <= 0.0 { 0.0 } else { next };
        }
        x
    };
    let (a, b) = (between(random, -0.5, 0.5), between(random, -0.5, 0.5));
    if right <= left && (ends(a) - ends(b)).abs() > (a - b).abs() + 1e-2 {
        return Some(format!("appA_uniq: {left}, {right} from {a}, {b}"));
    }
    // At 0: is the rate in K[f](0), and 3 + |x|' in z K + 3 for z in [-1, 1]?
    let own = rate(0.0);
    let (low, high) = (left.min(right), left.max(right));
    let in_hull = own >= low - 1e-12 && own <= high + 1e-12;
    let stays = own == 0.0;
    let chain = !stays || (low <= 0.0 && high >= 0.0);
    (!in_hull || !chain).then(|| format!("appA.def4, appA.thm4: {left}, {right}"))
}

#[test]
fn switching_survives() {
    survive(&[
        Attempt { name: "the saturated potential", tries: 200, seek: saturated },
        Attempt { name: "the hull of (13)", tries: 100, seek: hull },
        Attempt { name: "runs with links by distance", tries: 3, seek: distance_runs },
        Attempt { name: "two paths in turn", tries: 4, seek: two_paths },
        Attempt { name: "the rhombus", tries: 3, seek: rhombus },
        Attempt { name: "the rhombus, one mode", tries: 2, seek: rhombus_modes },
        Attempt { name: "the certified split", tries: 2, seek: split_box },
        Attempt { name: "crossing R", tries: 8, seek: crossing },
        Attempt { name: "step fields", tries: 100, seek: filippov },
    ]);
}
