//! Every quantity that directed graphs have against its definition, over random graphs of arcs with loops.

use super::{asked, refusal, verdict};
use num_integer::gcd;
use question::Verdict::Holds;

/// Numbers below a bound, the same in every run.
fn numbers(mut state: u64) -> impl FnMut(usize) -> usize {
    move |below| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % below
    }
}

/// Who has an arc to whom.
type Arcs = Vec<Vec<bool>>;

fn text(arcs: &Arcs) -> String {
    let n = arcs.len();
    let pairs = (0..n).flat_map(|i| (0..n).map(move |j| (i, j))).filter(|&(i, j)| arcs[i][j]);
    let list: Vec<String> = pairs.map(|(i, j)| format!("{}-{}", i + 1, j + 1)).collect();
    format!("graph = \"arcs:{n}:{}\"", list.join(","))
}

/// Lengths of shortest ways, by trying every vertex in between.
fn ways(arcs: &Arcs) -> Vec<Vec<Option<usize>>> {
    let n = arcs.len();
    let first = |i: usize, j: usize| if i == j { Some(0) } else { arcs[i][j].then_some(1) };
    let mut ways: Vec<Vec<Option<usize>>> = (0..n).map(|i| (0..n).map(|j| first(i, j)).collect()).collect();
    for k in 0..n {
        for i in 0..n {
            for j in 0..n {
                let through = ways[i][k].zip(ways[k][j]).map(|(a, b)| a + b);
                ways[i][j] = [ways[i][j], through].into_iter().flatten().min();
            }
        }
    }
    ways
}

/// The greatest common divisor of the lengths of closed walks of at most `n²` steps.
fn period(arcs: &Arcs) -> usize {
    let n = arcs.len();
    let mut walks: Arcs = (0..n).map(|i| (0..n).map(|j| i == j).collect()).collect();
    let mut divisor = 0;
    for length in 1..=n * n {
        walks = (0..n).map(|i| (0..n).map(|j| (0..n).any(|k| walks[i][k] && arcs[k][j])).collect()).collect();
        if (0..n).any(|i| walks[i][i]) {
            divisor = gcd(divisor, length);
        }
    }
    divisor
}

/// The complex roots of the characteristic polynomial: its coefficients by Faddeev and LeVerrier, all roots at once by Durand and Kerner.
fn eigenvalues(matrix: &[Vec<f64>]) -> Vec<(f64, f64)> {
    let n = matrix.len();
    let mut power = vec![vec![0.0; n]; n];
    let mut coefficients = vec![1.0];
    for k in 1..=n {
        let last = coefficients[k - 1];
        let before = power.clone();
        let entry = |i: usize, j: usize| {
            (0..n).map(|m| matrix[i][m] * before[m][j]).sum::<f64>() + if i == j { last } else { 0.0 }
        };
        power = (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect();
        let trace: f64 = (0..n).map(|i| (0..n).map(|m| matrix[i][m] * power[m][i]).sum::<f64>()).sum();
        coefficients.push(-trace / k as f64);
    }
    let times = |a: (f64, f64), b: (f64, f64)| (a.0 * b.0 - a.1 * b.1, a.0 * b.1 + a.1 * b.0);
    let over = |a: (f64, f64), b: (f64, f64)| {
        let size = b.0 * b.0 + b.1 * b.1;
        times(a, (b.0 / size, -b.1 / size))
    };
    let mut roots: Vec<(f64, f64)> = Vec::new();
    (0..n).for_each(|k| roots.push(roots.get(k.wrapping_sub(1)).map_or((1.3, 0.4), |&root| times(root, (0.4, 0.9)))));
    for _ in 0..3000 {
        for k in 0..n {
            let x = roots[k];
            let value = coefficients.iter().fold((0.0, 0.0), |sum, c| (times(sum, x).0 + c, times(sum, x).1));
            let others = (0..n).filter(|&j| j != k).map(|j| (x.0 - roots[j].0, x.1 - roots[j].1));
            let product = others.fold((1.0, 0.0), times);
            // Roots that have met stay together.
            if product.0.hypot(product.1) > 1e-100 {
                let step = over(value, product);
                roots[k] = (x.0 - step.0, x.1 - step.1);
            }
        }
    }
    roots
}

fn sorted(mut list: Vec<f64>) -> Vec<f64> {
    list.sort_by(f64::total_cmp);
    list
}

/// That a quantity is within 1/50 of a number: a root of multiplicity five is found to the fifth root of the error of floating point.
fn near(quantity: &str, number: f64) -> String {
    format!("abs({quantity} - {:.6}) < 1/50", number + 0.0).replace("- -", "+ ")
}

fn facts(arcs: &Arcs) -> Vec<String> {
    let n = arcs.len();
    let (ways, all) = (ways(arcs), 0..n);
    let out = |i: usize| arcs[i].iter().filter(|has| **has).count();
    let into = |j: usize| arcs.iter().filter(|row| row[j]).count();
    let count: usize = all.clone().map(out).sum();
    let said = |is: bool, what: &str| if is { what.to_string() } else { format!("not {what}") };
    let strong = ways.iter().flatten().all(Option::is_some);
    let mut facts = vec![
        format!("n = {n}"),
        format!("edges = {count}"),
        format!("min_degree = {}", all.clone().map(out).min().unwrap()),
        format!("max_degree = {}", all.clone().map(out).max().unwrap()),
        said(strong, "connected"),
        said(strong, "strongly_connected"),
        said(all.clone().any(|root| ways.iter().all(|row| row[root].is_some())), "rooted"),
        "sum(i, degree(i)) = edges and sum(i, in_degree(i)) = edges".to_string(),
        "count(edge(i, j), adjacent(i, j)) = edges".to_string(),
    ];
    let weighted = all.clone().flat_map(|i| (0..n).map(move |j| (i, j))).filter(|&(i, j)| arcs[i][j]);
    let sum: usize = weighted.map(|(i, j)| (i + 1) + 10 * (j + 1)).sum();
    facts.push(format!("sum(edge(i, j), i + 10*j) = {sum}"));
    for i in 0..n {
        facts.push(format!("degree({0}) = {1} and in_degree({0}) = {2}", i + 1, out(i), into(i)));
        for j in 0..n {
            facts.push(said(arcs[i][j], &format!("adjacent({}, {})", i + 1, j + 1)));
            facts.extend(ways[i][j].map(|length| format!("distance({}, {}) = {length}", i + 1, j + 1)));
        }
        let largest: Option<usize> =
            ways[i].iter().copied().collect::<Option<Vec<_>>>().and_then(|row| row.into_iter().max());
        facts.extend(largest.map(|most| format!("eccentricity({}) = {most}", i + 1)));
    }
    if strong {
        let largest = |row: &Vec<Option<usize>>| row.iter().flatten().copied().max().unwrap();
        facts.push(format!("diameter = {}", ways.iter().map(largest).max().unwrap()));
        facts.push(format!("radius = {}", ways.iter().map(largest).min().unwrap()));
        if period(arcs) > 0 {
            facts.push(format!("period = {}", period(arcs)));
        }
    }
    let weight = |i: usize, j: usize| f64::from(u8::from(arcs[i][j]));
    let less = |degree: &dyn Fn(usize) -> usize, skipped: usize| -> Vec<Vec<f64>> {
        let entry = |i: usize, j: usize| if i == j { degree(i) as f64 } else { 0.0 } - weight(i, j);
        (skipped..n).map(|i| (skipped..n).map(|j| entry(i, j)).collect()).collect()
    };
    let share = |i: usize, j: usize| if out(i) > 0 { weight(i, j) / out(i) as f64 } else { 0.0 };
    let square = |entry: &dyn Fn(usize, usize) -> f64| -> Vec<Vec<f64>> {
        (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect()
    };
    let kinds = [
        ("laplacian", less(&out, 0)),
        ("out_degree", less(&out, 0)),
        ("in_degree", less(&into, 0)),
        ("reduced", less(&out, 1)),
        ("adjacency", square(&weight)),
        ("walk", square(&|i, j| if i == j && out(i) > 0 { 1.0 } else { 0.0 } - share(i, j))),
    ];
    for (kind, matrix) in kinds {
        let real = sorted(eigenvalues(&matrix).into_iter().map(|(re, _)| re).collect());
        facts.extend(real.iter().enumerate().map(|(k, re)| near(&format!("lambda({}, {kind})", k + 1), *re)));
    }
    let moduli = |matrix: &[Vec<f64>]| sorted(eigenvalues(matrix).iter().map(|(re, im)| re.hypot(*im)).collect());
    facts.extend(moduli(&square(&weight)).last().map(|most| near("spectral_radius", *most)));
    if n > 1 && all.clone().all(|i| out(i) > 0) {
        facts.push(near("second_modulus", moduli(&square(&share))[n - 2]));
    }
    facts
}

#[test]
fn quantities_of_digraphs_are_those_of_their_definitions() {
    let mut next = numbers(3);
    let (mut strong, mut without_a_way) = (0, 0);
    for k in 0..60 {
        let (n, share) = (1 + k % 5, 1 + next(6));
        let arcs: Arcs = (0..n).map(|_| (0..n).map(|_| next(10) < share).collect()).collect();
        let family = text(&arcs);
        let facts = facts(&arcs);
        if verdict(&family, &facts.join(" and ")) != Holds {
            let wrong: Vec<&String> = facts.iter().filter(|fact| verdict(&family, fact) != Holds).collect();
            panic!("{family}: {wrong:?}");
        }
        // One number more is noticed.
        let planted = facts[1].replace("edges = ", "edges + 1 = ");
        assert_eq!(verdict(&family, &planted), question::Verdict::False);
        let ways = ways(&arcs);
        match (0..n * n).find(|place| ways[place / n][place % n].is_none()) {
            None => strong += 1,
            Some(place) => {
                without_a_way += 1;
                for quantity in
                    [&format!("distance({}, {})", place / n + 1, place % n + 1), "diameter", "radius", "period"]
                {
                    let message = refusal(&asked(&family, &format!("{quantity} >= 0"), "1 < 0"));
                    assert!(message.contains("does not exist"), "{family}: {quantity}: {message}");
                }
            }
        }
    }
    assert!(strong > 10 && without_a_way > 10, "{strong} {without_a_way}");
}

/// Of graphs in which all arcs go both ways, the quantities of both sorts agree.
#[test]
fn arcs_both_ways_are_edges() {
    for (edges, both) in [
        ("edges:4:1-2,2-3,3-4", "arcs:4:1-2,2-1,2-3,3-2,3-4,4-3"),
        ("edges:4:1-2,1-3,2-3,3-4", "arcs:4:1-2,2-1,1-3,3-1,2-3,3-2,3-4,4-3"),
        ("edges:3:1-2", "arcs:3:1-2,2-1"),
    ] {
        let family = format!("g = \"{edges}\"\nh = \"{both}\"");
        let mut same: Vec<String> =
            ["min_degree", "max_degree", "spectral_radius"].map(|q| format!("g.{q} = h.{q}")).to_vec();
        same.extend(
            (1..=3).map(|k| format!("g.lambda({k}, walk) = h.lambda({k}, walk) and g.lambda({k}) = h.lambda({k})")),
        );
        same.push("2*g.edges = h.edges".to_string());
        let connected = verdict(&format!("g = \"{edges}\""), "connected") == Holds;
        assert_eq!(verdict(&format!("h = \"{both}\""), "connected") == Holds, connected);
        if connected {
            same.extend(["diameter", "radius", "period", "second_modulus"].map(|q| format!("g.{q} = h.{q}")));
        }
        for fact in same {
            assert_eq!(verdict(&family, &fact), Holds, "{edges}: {fact}");
        }
    }
}
