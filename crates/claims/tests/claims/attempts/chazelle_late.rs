//! Chazelle's statements about times, switches and numbers that no run from the start reaches: extreme weights, adversaries that choose
//! the weights, and exact jumps over the time in which the network stays as it is.

use super::chazelle::{Birds, LAZY, Q, VICSEK, paper_threshold, q, size};
use super::chazelle_networks::{Graph, connected, from_edges, model_d, modes, shares, vicsek};
use super::{Dice, Matrix, times};
use num_traits::ToPrimitive;

/// `c_i` by the degree.
type Weights = fn(usize) -> Q;

/// The network of the path `0 - 1 - .. - (n-1)`, shares `c_i d_i` all equal to `share`.
fn path_matrix(n: usize, share: &Q) -> Vec<Vec<Q>> {
    let degree = |i: usize| i64::from(i > 0) + i64::from(i + 1 < n);
    let entry = |i: usize, j: usize| match i.abs_diff(j) {
        0 => q(1, 1) - share,
        1 => share / q(degree(i), 1),
        _ => q(0, 1),
    };
    (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect()
}

/// What is stationary on that path: by degrees.
fn path_mean(v: &[Q]) -> Q {
    let n = v.len();
    let degree = |i: usize| q(i64::from(i > 0) + i64::from(i + 1 < n), 1);
    (0..n).map(|i| degree(i) * &v[i]).sum::<Q>() / (0..n).map(degree).sum::<Q>()
}

fn image(m: &[Vec<Q>], v: &[Q]) -> Vec<Q> {
    m.iter().map(|row| row.iter().zip(v).map(|(a, x)| a * x).sum()).collect()
}

/// `sum_s (P^s v - mean)` on the path: the solution `z` of `(I - P) z = v - mean` with the mean 0.
fn path_ahead(share: &Q, v: &[Q]) -> Vec<Q> {
    // z_(i+1) - z_i follows from row i, from the first bird on.
    let (n, mean) = (v.len(), path_mean(v));
    let mut z = vec![q(0, 1)];
    for i in 0..n - 1 {
        let off = (&v[i] - &mean) / share;
        // share (z_i - average of the neighbours) = v_i - mean.
        let next = if i == 0 { &z[0] - off } else { q(2, 1) * (&z[i] - off) - &z[i - 1] };
        z.push(next);
    }
    let middle = path_mean(&z);
    z.iter().map(|x| x - &middle).collect()
}

/// chazelle.lem3.1, thm1.1.switches, beyond.chazelle.switches: the more a bird gives to its neighbours, the longer the four birds switch.
#[test]
fn extreme_weights() {
    let weights: [(Weights, usize); 3] =
        [(|d| q(5, 8 * d as i64), 257), (|d| q(3, 4 * d as i64), 512), (|d| q(7, 8 * d as i64), 1236)];
    for (c, most) in weights {
        // The gap in the middle is 1 - (1 - 2 share)^t/(8 share).
        let share = c(1);
        let middle = q(1, 1) - q(1, 8) / &share;
        let half = q(1, 2);
        let x = vec![q(0, 1), half.clone(), &half + &middle, &half + &middle + &half];
        let mut flock = Birds::new(x, [1, -1, 1, -1].map(|v| q(v, 8)).to_vec(), Some(paper_threshold(4)), c);
        let switches: Vec<usize> = (1..=most + 20).filter(|_| flock.step()).collect();
        assert!(switches.len() <= most && switches.last() == Some(&switches.len()), "{share}: {}", switches.len());
        // Entries are at least 4^-2, speeds at most 1: 4^(2 9 + 9 3 + 1).
        assert!((switches.len() as u128) < 1 << (2 * 46));
    }
}

/// The same and beyond.chazelle.switches: at every step an adversary chooses the shares, for the most switches and for gaps near 1.
#[test]
fn adversarial_weights() {
    #[derive(Clone)]
    struct State {
        x: Vec<Q>,
        v: Vec<Q>,
        edges: Vec<Vec<bool>>,
        switches: usize,
    }
    let mut dice = Dice::new("adversary");
    let mut most = [0; 6];
    for n in [2; 20].into_iter().chain((3..=5usize).flat_map(|n| [n; 3])) {
        // Entries of at least n^-2, speeds up to n: a = 2, c = 1.
        let least = q(1, (n * n) as i64);
        let eps = paper_threshold(n as i64);
        let x: Vec<Q> = (0..n).map(|k| q(15 * k as i64 + dice.below(9) as i64, 16)).collect();
        let v: Vec<Q> = (0..n).map(|_| q(dice.below(9) as i64 - 4, 8)).collect();
        let start = Birds::new(x.clone(), v.clone(), None, LAZY);
        let mut beam = vec![State { x, v, edges: start.edges, switches: 0 }];
        for t in 1..=18 {
            let mut next = Vec::new();
            for state in &beam {
                let x: Vec<Q> = state.x.iter().zip(&state.v).map(|(x, v)| x + v).collect();
                let gap = |x: &[Q], i: usize, j: usize| size(&(&x[i] - &x[j]));
                let joined = |i: usize, j: usize| {
                    let change = size(&(gap(&x, i, j) - gap(&state.x, i, j)));
                    i != j && (gap(&x, i, j) <= q(1, 1) || state.edges[i][j] && change < eps)
                };
                let edges: Vec<Vec<bool>> = (0..n).map(|i| (0..n).map(|j| joined(i, j)).collect()).collect();
                let switches = state.switches + usize::from(t >= 2 && edges != state.edges);
                for choice in 0..1 << n.min(3) {
                    let v = (0..n)
                        .map(|i| {
                            let heard: Vec<usize> = (0..n).filter(|&j| edges[i][j]).collect();
                            let d = q(heard.len().max(1) as i64, 1);
                            let high = choice >> (i % 3) & 1 == 1;
                            let c = if high { (q(1, 1) - &least) / &d } else { least.clone() };
                            let pull: Q = heard.iter().map(|&j| &state.v[j] - &state.v[i]).sum();
                            &state.v[i] + c * pull
                        })
                        .collect();
                    next.push(State { x: x.clone(), v, edges: edges.clone(), switches });
                }
            }
            let near = |s: &State| {
                (1..n).map(|i| size(&(size(&(&s.x[i] + &s.v[i] - &s.x[i - 1] - &s.v[i - 1])) - q(1, 1)))).min()
            };
            next.sort_by_cached_key(|s| (std::cmp::Reverse(s.switches), near(s)));
            next.truncate(8);
            beam = next;
        }
        most[n] = most[n].max(beam[0].switches);
        let exponent = 2 * (n - 1) * (n - 1) + 10 * (n - 1) + 1;
        assert!((beam[0].switches as f64).ln() <= exponent as f64 * (n as f64).ln());
    }
    // Two birds that have parted with the weights as they are never meet again.
    assert!(most[2] <= 2 && most[3] >= 6, "{most:?}");
}

/// beyond.chazelle.losses, chazelle.lem3.8: two birds that approach so slowly that the edge is lost as late as possible, and just not.
#[test]
fn late_losses() {
    let weights: [(Weights, i64, i64); 3] = [(LAZY, 1, 3), (|d| q(15, 16 * d.max(1) as i64), 7, 8), (VICSEK, 0, 1)];
    for n in [4i64, 5, 6] {
        let eps = paper_threshold(n);
        for (c, p, r) in weights {
            for lost in [true, false] {
                // Joined birds change their relative velocity by the factor -p/r: the change of the gap is eps, or a bit less.
                let factor = if p == 0 { q(1, 1) } else { q(p, r) };
                let rate = if lost { eps.clone() } else { &eps * q(4095, 4096) } / &factor;
                // From one end to the other of [-n, n]; the gap reaches 1 or a little less.
                let steps = ((q(2 * n - 2, 1) - q(1, 1)) / &rate).ceil() - q(1, 1);
                let gap = q(1, 1) + &rate * &steps - &rate / q(1024, 1);
                let mut x = vec![q(-n, 1), q(-n, 1) + &gap];
                // The others stand together at the other end, all within 1 of each other.
                x.extend((2..n).map(|k| q(n, 1) - q(k, 8)));
                let mut v = vec![q(0, 1); n as usize];
                v[0] = rate.clone();
                let mut flock = Birds::new(x, v, Some(eps.clone()), c);
                assert!(!flock.step());
                // As long as nobody meets, velocities stay: the rest of the way but two steps at once.
                let jump = &steps - q(3, 1);
                let leap: Vec<Q> = flock.v.iter().map(|v| v * &jump).collect();
                flock.x.iter_mut().zip(&leap).for_each(|(x, d)| *x += d);
                let changes: Vec<usize> = (0..30).filter(|_| flock.step()).collect();
                // The contact, and where the factor turns the motion round, the loss one step later.
                let expected: &[usize] = if lost && p > 0 { &[1, 2] } else { &[1] };
                assert_eq!(changes, expected, "n = {n}, factor {p}/{r}, lost {lost}");
                if lost && p > 0 {
                    let k = n as i32 - 1;
                    let bound = q(n, 1).pow(n.pow(4) as i32 + 2 * k * k + 10 * k + 17);
                    assert!(steps > q(1, 1) / &eps && steps < bound);
                }
            }
        }
    }
}

/// beyond.chazelle.tower (clauses 2 and 3), chazelle.lem3.9 (clause 1), thm1.1.time: the sixteen birds by jumps. No edge is ever lost, so that
/// the hysteresis changes nothing.
#[test]
fn sixteen_birds_later() {
    let lazy = q(2, 3);
    let v = [0, 8, 0, -8, 7, 1, -9, 1, -1, 9, -1, -7, 8, 0, -8, 0].map(|v| q(v, 4096)).to_vec();
    let x = (0..8).flat_map(|l| [q(2 * l, 1), q(6 * l + 2, 3)]).collect();
    let mut flock = Birds::new(x, v, None, LAZY);
    let paths = |edges: &[Vec<bool>], length: usize| {
        (0..16).all(|i| (0..16).all(|j| edges[i][j] == (i.abs_diff(j) == 1 && i / length == j / length)))
    };
    assert!((1..=170).all(|_| !flock.step()) && paths(&flock.edges, 2) && flock.step() && paths(&flock.edges, 4));
    // From t_1 = 171: x(t_1 + s) = x + s mean + ahead - P^s ahead, each group on its own.
    let (x, velocities) = (flock.x.clone(), flock.v.clone());
    let drift: Vec<Q> = (0..16).map(|i| path_mean(&velocities[i / 4 * 4..i / 4 * 4 + 4])).collect();
    let ahead: Vec<Q> = velocities.chunks(4).flat_map(|v| path_ahead(&lazy, v)).collect();
    let limit: Vec<Q> = x.iter().zip(&ahead).map(|(x, a)| x + a).collect();
    assert!((0..60).all(|_| !flock.step()));
    let left = (0..16).map(|i| size(&(&limit[i] + q(60, 1) * &drift[i] - &flock.x[i]))).max().unwrap();
    assert!(left < q(1, 1 << 20));
    // Pairs of one group stay on their side of 1, all others are further apart than neighbours of two groups.
    for (i, j) in (0..16).flat_map(|i| (0..i).map(move |j| (i, j))).filter(|(i, j)| i / 4 == j / 4) {
        let off = &limit[i] - &limit[j] - q(1, 1);
        assert!((off < q(0, 1)) == (i == j + 1) && size(&off) > q(1, 1 << 10));
    }
    let meet = |g: usize| {
        let (gap, rate) = (&limit[4 * g] - &limit[4 * g - 1], &drift[4 * g] - &drift[4 * g - 1]);
        assert!(gap > q(1025, 1024));
        (rate < q(0, 1)).then(|| ((gap - q(1, 1)) / -rate).ceil())
    };
    let steps = meet(1).unwrap();
    assert!(meet(3).as_ref() == Some(&steps) && meet(2).is_none_or(|later| later > steps));
    let gap = |s: &Q| &limit[4] - &limit[3] + s * (&drift[4] - &drift[3]);
    assert!(gap(&steps) < q(1, 1) && gap(&(&steps - q(1, 1))) > q(1, 1));
    let second = &steps + q(171, 1);
    assert_eq!(second.numer().to_string().len(), 85);
    // At that time, what is left of the inner motion, (2/3)^(10^84), is left out of the places.
    let x: Vec<Q> = (0..16).map(|i| &limit[i] + &steps * &drift[i]).collect();
    let eight = path_matrix(8, &lazy);
    let v: Vec<Q> = drift.chunks(8).flat_map(|v| image(&eight, v)).collect();
    let ahead: Vec<Q> = v.chunks(8).flat_map(|v| path_ahead(&lazy, v)).collect();
    assert!(v.chunks(8).all(|v| path_mean(v) == q(0, 1)));
    let mut flock = Birds::new(x.clone(), v, None, LAZY);
    assert!(paths(&flock.edges, 8) && (0..48).all(|_| !flock.step()));
    let limit: Vec<Q> = x.iter().zip(&ahead).map(|(x, a)| x + a).collect();
    let left = (0..16).map(|i| size(&(&limit[i] - &flock.x[i]))).max().unwrap();
    for (i, j) in (0..16).flat_map(|i| (0..i).map(move |j| (i, j))) {
        let off = &limit[i] - &limit[j] - q(1, 1);
        assert!((off < q(0, 1)) == (i == j + 1 && i / 8 == j / 8) && size(&off) > q(2, 1) * &left, "{i}, {j}");
    }
    // The drift of an eight: from the parts of the inner motion of its groups, of the eigenvalues 2/3 and -1/3.
    let four = path_matrix(4, &lazy);
    let all = [q(1, 1), q(2, 3), q(0, 1), q(-1, 3)];
    let part = |mu: &Q| -> Vec<Q> {
        let project = |v: &[Q]| {
            all.iter().filter(|other| *other != mu).fold(v.to_vec(), |v, other| {
                image(&four, &v).iter().zip(&v).map(|(p, v)| (p - other * v) / (mu - other)).collect()
            })
        };
        let parts: Vec<Q> = velocities.chunks(4).flat_map(project).collect();
        parts.chunks(8).map(path_mean).collect()
    };
    assert!(part(&all[0]).iter().chain(&part(&all[1])).all(|c| *c == q(0, 1)));
    let coefficients = part(&all[3]);
    // (-1/3)^(steps - 1).
    let odd = (&steps / q(2, 1)).ceil() != &steps / q(2, 1);
    let rate = (&coefficients[1] - &coefficients[0]) * q(if odd { 1 } else { -1 }, 1);
    assert!(rate < q(0, 1));
    let start = ((&limit[8] - &limit[7] - q(1, 1)) / -rate).to_f64().unwrap().log2();
    let third = start + steps.to_f64().unwrap() * 3f64.log2();
    assert!(third > 2.116e84 && third < 2.117e84, "{third}");
    // log2 t is far below t_1 n log2 n, and t below 2^^5.
    assert!(third < steps.to_f64().unwrap() * 64.0);
}

/// chazelle.lem3.9 (clause 2), lem3.10: a path of four, eigenvalues 4/5, 2/5, 1/5, whose first and third birds meet the later the smaller
/// the part of 4/5 is: linearly in its bits.
#[test]
fn late_contacts() {
    for bits in [6, 12, 24, 48, 96i32] {
        let (slow, fast) = (q(-2, 15) / q(2, 1).pow(bits), q(1, 10));
        // Right eigenvectors (1, 1/2, -1/2, -1) and (1, -1/2, -1/2, 1).
        let half = q(1, 2);
        let v = vec![&slow + &fast, (&slow - &fast) * &half, -(&slow + &fast) * &half, &fast - &slow];
        // Places such that x_3 - x_1 tends to 1.
        let ahead = path_ahead(&q(2, 5), &v);
        let limit = [q(0, 1), half.clone(), q(1, 1), q(19, 10)];
        let x = limit.iter().zip(&ahead).map(|(x, a)| x - a).collect();
        let mut flock = Birds::new(x, v, Some(paper_threshold(4)), |d| q(2, 5 * d as i64));
        let edges = flock.edges.clone();
        assert!((0..4).all(|i| (0..4).all(|j| edges[i][j] == (i.abs_diff(j) == 1))));
        let meeting = (1..=2 * bits).find(|_| flock.step());
        assert!(meeting == Some(bits - 2) && flock.edges[0][2], "{bits}: {meeting:?}");
    }
}

/// chazelle.lem3.10 (all clauses), lem3.9 (clause 2): the moduli and coefficients of (3.18) for all connected networks of 2 to 4 birds with
/// shares next to 0 and 1 and for those of 5 birds with the usual weights: nearly equal moduli, coefficients that are nearly zero or large.
#[test]
fn separations() {
    let mut dice = Dice::new("separations");
    let mut nearest: f64 = 1.0;
    for n in 2..=5usize {
        let graphs = (0..1usize << (n * (n - 1) / 2))
            .map(|code| from_edges(n, |i, j| i > j && code >> (i * (i - 1) / 2 + j) & 1 == 1))
            .filter(connected);
        for graph in graphs {
            let mut weights = vec![vicsek(&graph), shares(&graph, || 2.0 / 3.0)];
            if n < 5 {
                weights.extend((0..9).map(|_| shares(&graph, || [1.0, 7.0, 8.0, 15.0][dice.below(4)] / 16.0)));
            }
            for c in weights {
                nearest = nearest.min(expansion(&graph, &c, &mut dice));
            }
        }
    }
    // Found 0.0013 (with 64ths for n^-a the statement has room down to 2^-27 already for three birds).
    assert!(nearest > 2f64.powi(-27), "{nearest}");
}

/// The least `1 - rho_2/rho_1` for pairs of this flock; panics where a coefficient is not as stated.
fn expansion(graph: &Graph, c: &[f64], dice: &mut Dice) -> f64 {
    let (n, p) = (graph.len(), model_d(graph, c));
    let m: Matrix = (0..n).map(|i| (0..n).map(|j| p[i][j] * (c[j] / c[i]).sqrt()).collect()).collect();
    let v: Vec<f64> = (0..n).map(|_| dice.below(17) as f64 / 8.0 - 1.0).collect();
    let modes: Vec<(f64, Vec<f64>)> = modes(&m).into_iter().skip(1).collect();
    let (i, j) = (dice.below(n), dice.below(n));
    let psi: Vec<f64> = modes
        .iter()
        .map(|(mu, u)| {
            let part: f64 = (0..n).map(|k| u[k] / c[k].sqrt() * v[k]).sum();
            (c[i].sqrt() * u[i] - c[j].sqrt() * u[j]) * part / (1.0 - mu)
        })
        .collect();
    // (1 - sum psi mu^s)² - 1: (value, coefficient).
    let mut terms: Vec<(f64, f64)> = modes.iter().zip(&psi).map(|((mu, _), psi)| (*mu, -2.0 * psi)).collect();
    for (a, (mu, _)) in modes.iter().enumerate() {
        terms.extend(modes.iter().enumerate().map(|(b, (nu, _))| (mu * nu, psi[a] * psi[b])));
    }
    let mut moduli: Vec<f64> = terms.iter().map(|(x, _)| x.abs()).filter(|x| *x > 1e-9).collect();
    moduli.sort_by(|x, y| y.total_cmp(x));
    moduli.dedup_by(|x, y| (*x - *y).abs() < 1e-9);
    // Entries of at least 1/64: n^-a with a = 6 for two birds, less for more.
    let most = (n as f64).powi(8) * 64.0;
    for rho in &moduli {
        for sign in [1.0, -1.0] {
            let own: f64 = terms
                .iter()
                .filter(|(x, _)| (x.abs() - rho).abs() < 1e-9)
                .map(|(x, c)| if *x > 0.0 { *c } else { sign * c })
                .sum();
            assert!(own.abs() < most && !(1e-11..1e-8).contains(&own.abs()), "{graph:?} {c:?} {rho}: {own}");
        }
    }
    if moduli.len() > 1 { 1.0 - moduli[1] / moduli[0] } else { 1.0 }
}

/// chazelle.lem3.7, beyond.chazelle.angle: lifted angles of 2 to 5 birds in one to three dimensions, with weights next to 0 and 1, until long
/// after n^(n^3) for two birds; with the constant 1 in the exponents.
#[test]
fn angles_far_out() {
    let mut dice = Dice::new("angles far out");
    for case in 0..40 {
        let (n, d) = (2 + case % 4, 1 + dice.below(3));
        let least = 1.0 / (n * n) as f64;
        let share = [least, 2.0 / 3.0, 1.0 - least][dice.below(3)];
        let (eps, reach) = ((n as f64).powi(-(n as i32).pow(4)), n as f64);
        let mut x: Vec<Vec<f64>> = (0..n).map(|_| (0..d).map(|_| dice.between(-1.5, 1.5)).collect()).collect();
        let mut v: Vec<Vec<f64>> = (0..n).map(|_| (0..d).map(|_| dice.between(-1.0, 1.0)).collect()).collect();
        if case % 3 == 0 {
            // Near each other in one direction, fast in common.
            v.iter_mut().for_each(|v| v.iter_mut().for_each(|v| *v = *v / 50.0 + reach / 2.0));
        }
        let apart = |x: &[Vec<f64>], i: usize, j: usize| {
            x[i].iter().zip(&x[j]).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
        };
        let mut edges = from_edges(n, |i, j| apart(&x, i, j) <= 1.0);
        let far = x.iter().flatten().fold(0.0, |m: f64, x| m.max(x.abs()));
        let mut switches = 0;
        for t in 1..=1500 {
            let before = x.clone();
            x.iter_mut().zip(&v).for_each(|(x, v)| x.iter_mut().zip(v).for_each(|(x, v)| *x += v));
            let next = from_edges(n, |i, j| {
                let (was, now) = (apart(&before, i, j), apart(&x, i, j));
                now <= 1.0 || edges[i][j] && (now - was).abs() < eps
            });
            let time = f64::from(t);
            // x(t) and v(t).
            for (x, v) in x.iter().zip(&v) {
                let off: f64 = x.iter().zip(v).map(|(x, v)| (v - x / time).powi(2)).sum::<f64>().sqrt();
                let dot: f64 = 1.0 + x.iter().zip(v).map(|(x, v)| v * x / time).sum::<f64>();
                let long: f64 = 1.0 + v.iter().map(|v| v * v).sum::<f64>();
                let wide: f64 = 1.0 + x.iter().map(|x| (x / time).powi(2)).sum::<f64>();
                let angle = (long * wide - dot * dot).max(0.0).sqrt().atan2(dot);
                assert!(angle <= off + 1e-7);
                // least = n^-2, at most n - 1 neighbours: entries of at least n^-3.
                let bound = far + 4.0 * f64::from(switches + 1) * reach.powi(9);
                assert!(off * time <= bound * (d as f64).sqrt());
                let late = time > reach.powi((n as i32).pow(3));
                assert!(
                    !late || angle <= time.ln() / time * reach.powi((n as i32).pow(3)),
                    "n = {n}, t = {t}: {angle}"
                );
            }
            switches += i32::from(next != edges);
            edges = next;
            let c = shares(&edges, || share);
            let p = model_d(&edges, &c);
            v = p.iter().map(|row| (0..d).map(|q| row.iter().zip(&v).map(|(p, v)| p * v[q]).sum()).collect()).collect();
        }
    }
}

/// beyond.chazelle.chi: exact factors of model D that change with time, all i != j.
#[test]
fn rows_of_differences() {
    let mut dice = Dice::new("chi");
    for n in (2..=5usize).flat_map(|n| [n; 6]) {
        let first: Vec<Q> = (0..n).map(|_| q(dice.below(19) as i64 - 9, 7)).collect();
        let mut v = first.clone();
        let mut rows: Vec<Vec<Q>> = (0..n).map(|i| (0..n).map(|j| q(i64::from(i == j), 1)).collect()).collect();
        for _ in 1..=5 {
            for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))).filter(|(i, j)| i != j) {
                let right: Q = (0..n).map(|k| (&rows[i][k] - &rows[j][k]) * &first[k]).sum();
                assert_eq!(&v[i] - &v[j], right);
            }
            let code = dice.below(1 << (n * (n - 1) / 2));
            let graph = from_edges(n, |i, j| i > j && code >> (i * (i - 1) / 2 + j) & 1 == 1);
            let p: Vec<Vec<Q>> = (0..n)
                .map(|i| {
                    let d = graph[i].iter().filter(|e| **e).count() as i64;
                    let c = q(1, d + 1 + dice.below(3) as i64);
                    (0..n)
                        .map(|j| if i == j { q(1, 1) - q(d, 1) * &c } else { q(i64::from(graph[i][j]), 1) * &c })
                        .collect()
                })
                .collect();
            v = image(&p, &v);
            rows = p
                .iter()
                .map(|row| (0..n).map(|k| row.iter().zip(&rows).map(|(p, line)| p * &line[k]).sum()).collect())
                .collect();
        }
    }
}

/// beyond.chazelle.recurrent (clauses 3 and 4), chazelle.foot.mono (clause 2): windows that never end and never have the same root.
#[test]
fn windows_without_end() {
    let mut dice = Dice::new("windows");
    let spread = |v: &[f64]| v.iter().fold(f64::MIN, |a, b| a.max(*b)) - v.iter().fold(f64::MAX, |a, b| a.min(*b));
    for n in 2..=4usize {
        let mut v: Vec<f64> = (0..n).map(|i| i as f64).collect();
        // Undirected: a star around a bird that changes, one edge at a time, each repeated until its birds agree nearly.
        for window in 0..400 {
            for other in (0..n).filter(|other| *other != window % n) {
                for _ in 0..1 + dice.below(6) {
                    let graph = from_edges(n, |i, j| i == window % n && j == other);
                    v = super::apply(&model_d(&graph, &vicsek(&graph)), &v);
                }
            }
        }
        assert!(spread(&v) < 1e-6, "{n}: {v:?}");
        // Directed: news runs to the right, then to the left, one arc at a time, so that every 2n - 3 times have a root.
        let (alpha, span) = (0.25f64, ((n - 1) * (2 * n - 3)) as i32);
        let mut v: Vec<f64> = (0..n).map(|_| dice.unit()).collect();
        let (first, mut states) = (spread(&v), Vec::new());
        for t in 0..6 * n * n {
            let (back, k) = (t / (n - 1) % 2 == 1, t % (n - 1));
            let (bird, heard) = if back { (n - 2 - k, n - 1 - k) } else { (k + 1, k) };
            v[bird] = if (t + bird) % 3 == 0 { alpha } else { 1.0 - alpha } * v[bird]
                + if (t + bird) % 3 == 0 { 1.0 - alpha } else { alpha } * v[heard];
            states.push(v.clone());
        }
        for (t, state) in states.iter().enumerate() {
            let bound = (1.0 - alpha.powi(span)).powi((t as i32 + 1) / span) * first;
            assert!(spread(state) <= bound + 1e-12 && (0..n).all(|i| (state[i] - v[0]).abs() <= bound + 1e-12));
        }
    }
    let news = [from_edges(3, |i, j| (i, j) == (0, 1)), from_edges(3, |i, j| (i, j) == (1, 2))];
    let product = times(&model_d(&news[1], &vicsek(&news[1])), &model_d(&news[0], &vicsek(&news[0])));
    assert!(product[2][0] > 0.0 && product[0][2] == 0.0);
}

/// beyond.chazelle.Nts, chazelle.foot.mono (clause 3): any times t_0 = s < t_1 < ..., any networks, shares next to 1.
#[test]
fn counted_changes() {
    let mut dice = Dice::new("counts");
    for _ in 0..300 {
        let n = 1 + dice.below(4);
        let footprints: Vec<Vec<Vec<bool>>> = (0..12)
            .map(|_| {
                let code = dice.below(8);
                let graph = from_edges(n, |i, j| i > j && code >> (i * (i - 1) / 2 + j) & 1 == 1);
                let p = model_d(&graph, &shares(&graph, || 1.0 - 1e-12));
                assert!((0..n).all(|i| p[i][i] > 0.0 && (0..n).all(|j| (p[i][j] > 0.0) == (p[j][i] > 0.0))));
                p.iter().map(|row| row.iter().map(|x| *x > 0.0).collect()).collect()
            })
            .collect();
        let count = |t: usize, s: usize| (s + 1..=t).filter(|&u| footprints[u] != footprints[u - 1]).count();
        let s = dice.below(4);
        let mut stops = vec![s];
        stops.extend((s + 1..12).filter(|_| dice.below(2) == 0));
        let sum: usize = stops.windows(2).map(|k| count(k[1], k[0])).sum();
        assert_eq!(count(*stops.last().unwrap(), s), sum);
        assert!(stops.windows(2).all(|k| k[1] != k[0] + 1 || count(k[1], k[0]) <= 1));
    }
}

/// chazelle.lem3.5: paths on which every bird has a prime of its own in its weight, all columns of Gamma.
#[test]
fn lengths_of_limits() {
    let primes = [11i64, 13, 17, 19, 23, 29, 31, 37, 41, 43];
    for n in 2..=10usize {
        // c_i = 1/p_i, at most n^4; pi is p_i over the sum.
        let all = q(primes[..n].iter().sum(), 1);
        let mut denominator = q(1, 1);
        let mut most = 0;
        for column in 0..n {
            let mean = q(primes[column], 1) / &all;
            let mut z = vec![q(0, 1)];
            for i in 0..n - 1 {
                let off = (q(i64::from(i == column), 1) - &mean) * q(primes[i], 1);
                let before = if i == 0 { q(0, 1) } else { &z[i] - &z[i - 1] };
                z.push(&z[i] + before - off);
            }
            let middle: Q = z.iter().zip(primes).map(|(z, p)| z * q(p, 1)).sum::<Q>() / &all;
            // The entries of this column of Gamma; x^r adds I - 1 pi^T, with the denominator `all`.
            for entry in z.iter().map(|z| z - &middle) {
                // What the common denominator still lacks.
                denominator *= Q::new((&denominator * &entry).denom().clone(), 1.into());
                most = most.max(entry.numer().bits());
            }
        }
        let room = 8.0 * n as f64 * (n as f64).log2() + 8.0;
        assert!(denominator.numer().bits() as f64 <= room && most as f64 <= room, "{n}: {denominator}, {most} bits");
    }
}
