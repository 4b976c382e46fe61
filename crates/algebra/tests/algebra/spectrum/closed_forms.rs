//! Which graphs have a closed form, and what its enclosures and floats promise.

use super::UNIT;
use algebra::graph::{LaplacianKind, NamedGraph};
use algebra::spectrum::{ClosedForm, ClosedValue, CyclotomicSum, Eigenvalue, RootTable, closed_form, named_spectrum};
use arithmetic::{Field, Interval, Number, Rational, Real, Ring, rational};
use num_bigint::BigInt;
use num_traits::ToPrimitive;

fn form(name: &str, kind: LaplacianKind) -> Option<ClosedForm> {
    let graph: NamedGraph = name.parse().unwrap_or_else(|error| panic!("{name}: {error}"));
    closed_form(&graph, kind)
}

#[test]
fn which_graphs_have_a_closed_form() {
    use LaplacianKind::{Adjacency, Combinatorial, InDegree, Normalised, OutDegree, Reduced, Walk};
    let cases: [(&[&str], &[LaplacianKind]); 9] = [
        (&["complete:1", "path:1"], &[Reduced]),
        (&["complete:2", "complete:5", "ring:3", "path:2", "path:3", "path:7"], &[]),
        (&["circulant:6:2,3"], &[Reduced]),
        (&["cycle:1"], &[Reduced, Normalised]),
        (&["cycle:2", "cycle:5"], &[Normalised]),
        (&["star:3", "star:6"], &[Reduced]),
        (&["star:1", "star:2"], &[Combinatorial, OutDegree, InDegree, Normalised, Walk, Reduced, Adjacency]),
        (&["platoon1:1", "platoon1:4"], &[Normalised]),
        (&["platoon2:1", "platoon2:4"], &[InDegree, Normalised]),
    ];
    for (names, without) in cases {
        for name in names {
            for (_, kind) in LaplacianKind::NAMES {
                assert_eq!(form(name, kind).is_none(), without.contains(&kind), "{name} {kind:?}");
            }
        }
    }
}

/// More work than `2^25` sums: the exact comparison is not begun.
#[test]
fn large_circulants_have_none() {
    let offsets: Vec<String> = (1..=33).map(|a| a.to_string()).collect();
    assert!(form(&format!("circulant:1048576:{}", offsets.join(",")), LaplacianKind::Adjacency).is_none());
}

/// Whether a part is as narrow as its digits promise.
fn has_digits(part: &Eigenvalue, digits: u32) -> bool {
    let square = |x: &Interval| x.square().lo().to_rational();
    let size = square(&part.re) + square(&part.im);
    let width = part.re.width().to_rational().max(part.im.width().to_rational());
    width.pow(2) * rational(10, 1).pow(2 * digits as i32) <= size
}

#[test]
fn rational_values_and_roots_have_their_digits() {
    for digits in [1, 3, 20, 100] {
        for (name, kind) in [("complete:4", LaplacianKind::Walk), ("star:7", LaplacianKind::Adjacency)] {
            for part in form(name, kind).expect(name).enclose(digits).expect("enclosed") {
                assert!(part.exact == Some(rational(0, 1)) || has_digits(&part, digits), "{name} {digits} {part:?}");
            }
        }
        // A rational among cosines: cos(pi/3).
        let third = form("ring:6", LaplacianKind::Walk).expect("ring").enclose(digits).expect("enclosed");
        assert!(third.iter().skip(1).all(|part| has_digits(part, digits)));
    }
    // Minus a whole root.
    let parts = form("star:10", LaplacianKind::Adjacency).expect("star").enclose(5).expect("enclosed");
    assert_eq!([0, 2].map(|k| parts[k].exact.clone()), [Some(rational(-3, 1)), Some(rational(3, 1))]);
}

#[test]
fn rational_real_parts_of_complex_values_are_exact() {
    // i and -i; 1 - i and 1 + i.
    for (kind, expected) in [(LaplacianKind::Adjacency, 0), (LaplacianKind::Walk, 1)] {
        let parts = form("cycle:4", kind).expect("cycle").enclose(10).expect("enclosed");
        let complex = parts.iter().filter(|part| !part.is_real());
        let ends: Vec<_> = complex.map(|part| part.re.to_rationals()).collect();
        assert_eq!(ends, vec![(rational(expected, 1), rational(expected, 1)); 2]);
    }
}

/// `z^shift (z^(1/2) - z^(-1/2))^(2k) = z^shift (-4 sin^2(pi/n))^k`: numbers so small that the first precision may not do.
#[test]
fn small_sums_have_their_digits() {
    let one = Interval::from_rational(&rational(1, 1), 400);
    for (k, shift) in [(3u64, 0u64), (4, 0), (4, 1), (5, 0), (5, 7)] {
        for n in (20..400u64).step_by(7) {
            let mut binomials = vec![1i64];
            for j in 0..2 * k {
                binomials.push(binomials[j as usize] * (2 * k - j) as i64 / (j as i64 + 1));
            }
            let term = |(j, &c): (usize, &i64)| (n + shift + j as u64 - k, if j % 2 == 0 { c } else { -c });
            let terms = binomials.iter().enumerate().map(term);
            let values = vec![(ClosedValue::Cyclotomic(CyclotomicSum::new(n, 1, terms).unwrap()), 1)];
            let part = ClosedForm { values, formula: String::new() }.enclose(2).expect("enclosed").remove(0);
            assert!(has_digits(&part, 2), "{k} {shift} {n} {part:?}");
            let turn = one.pi() * one.ratio(2, n as i64);
            let chord = (turn.clone() * one.ratio(1, 2)).sin().expect("a sine").square() * one.integer(4);
            let size = chord.power(k);
            let (sin, cos) = (turn * one.integer(shift as i64)).sin_cos().expect("an angle");
            let sign = if k % 2 == 0 { one.clone() } else { -one.clone() };
            let (re, im) = (size.clone() * cos * sign.clone(), size * sin * sign);
            assert!(part.re.overlaps(&re) && part.im.overlaps(&im), "{k} {shift} {n}");
        }
    }
}

#[test]
fn floats_are_within_their_bounds() {
    let names = [
        "ring:7",
        "ring:8",
        "cycle:6",
        "cycle:9",
        "path:9",
        "complete:8",
        "star:9",
        "star:10",
        "platoon2:5",
        "circulant:9:1,3",
    ];
    for name in names {
        for (_, kind) in LaplacianKind::NAMES {
            let Some(form) = form(name, kind) else { continue };
            let (floats, exact) = (form.floats(), form.enclose(30).expect("enclosed"));
            assert!(floats.is_sorted_by(|a, b| (a.re, a.im) <= (b.re, b.im)), "{name} {kind:?}");
            assert_eq!(floats.len(), exact.len());
            for part in &exact {
                let off = |x: f64, y: &Interval| {
                    let x = Rational::from_float(x).expect("finite");
                    (Interval::from_rational(&x, 200) - y).magnitude().to_f64()
                };
                let near = floats.iter().filter(|float| {
                    off(float.re, &part.re).max(off(float.im, &part.im)) <= float.radius + 1e-30
                        && float.multiplicity == part.multiplicity
                        && (!part.is_real() || float.im == 0.0)
                });
                assert_eq!(near.count(), 1, "{name} {kind:?} {part:?}");
            }
            assert!(floats.iter().all(|float| float.radius < 1e-13));
        }
    }
}

#[test]
fn floats_of_rationals_and_roots() {
    let of = |value| ClosedForm { values: vec![(value, 3)], formula: String::new() }.floats().remove(0);
    let exact = |p: BigInt, q: i64| of(ClosedValue::Rational(Rational::new(p, q.into())));
    let found = exact((-7).into(), 1);
    assert_eq!((found.re, found.im, found.radius, found.multiplicity), (-7.0, 0.0, 0.0, 3));
    let found = exact((-7).into(), 3);
    assert_eq!((found.re, found.im, found.radius), (-7.0 / 3.0, 0.0, 4.0 * UNIT * (7.0 / 3.0)));
    let long: BigInt = (BigInt::from(1) << 70) + 1;
    assert_eq!(exact(long.clone(), 1).radius, 4.0 * UNIT * long.to_f64().expect("a float"));
    let huge = exact(BigInt::from(1) << 2000, 1);
    assert!(huge.re.is_nan() && huge.im == 0.0 && huge.radius == f64::INFINITY);
    for sign in [1i64, -1] {
        let found = of(ClosedValue::SquareRoot { sign, radicand: 2 });
        assert_eq!((found.re, found.im), (sign as f64 * 2f64.sqrt(), 0.0));
        assert_eq!(found.radius, 4.0 * UNIT * 2f64.sqrt());
    }
}

/// Numbers that no name has: an error or nothing, never a panic.
#[test]
fn graphs_that_are_none_have_no_spectrum() {
    let offsets = |list: &[usize]| list.iter().copied().collect();
    let graphs = [
        NamedGraph::Ring(0),
        NamedGraph::Ring(2),
        NamedGraph::Cycle(0),
        NamedGraph::Path(0),
        NamedGraph::Path(usize::MAX),
        NamedGraph::Complete(0),
        NamedGraph::Star(0),
        NamedGraph::Circulant(0, offsets(&[])),
        NamedGraph::Circulant(5, offsets(&[7])),
        NamedGraph::Circulant(5, offsets(&[])),
        NamedGraph::PlatoonOne(0),
        NamedGraph::PlatoonTwo(0),
        NamedGraph::PlatoonTwo(usize::MAX),
        NamedGraph::Geometric { order: 0, radius: rational(1, 1), seed: 1 },
        NamedGraph::Geometric { order: 3, radius: rational(0, 1), seed: 1 },
    ];
    for graph in graphs {
        assert!(graph.check().is_err() && graph.build().is_err(), "{graph}");
        for kind in
            [LaplacianKind::Combinatorial, LaplacianKind::Adjacency, LaplacianKind::Walk, LaplacianKind::Reduced]
        {
            assert!(closed_form(&graph, kind).is_none(), "{graph}");
            assert!(named_spectrum(&graph, kind, None).is_err(), "{graph}");
        }
    }
}

#[test]
fn sums_of_no_roots_of_unity_are_refused() {
    let sum = |order, denominator, coefficient| CyclotomicSum::new(order, denominator, [(1, coefficient)]);
    assert!(sum(1 << 31, 1 << 31, -(1 << 31)).is_ok());
    for refused in
        [(0, 1, 1), (1 << 32, 1, 1), (3, 0, 1), (3, -1, 1), (3, 1 << 32, 1), (3, 1, 1 << 32), (3, 1, i64::MIN)]
    {
        assert!(sum(refused.0, refused.1, refused.2).is_err(), "{refused:?}");
    }
    assert!(RootTable::new(0, 64).is_err());
    let five = RootTable::new(5, 64).unwrap();
    assert!(sum(7, 1, 1).unwrap().enclose(&five).is_err() && sum(5, 1, 1).unwrap().enclose(&five).is_ok());
    // A real sum is its own real part, however often that is taken.
    let half = sum(5, 3, 1).unwrap().real_part();
    assert_eq!(half.real_part(), half);
}
