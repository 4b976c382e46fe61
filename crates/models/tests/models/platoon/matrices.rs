//! Systems given by matrices: responses and peaks that are known by hand, and matrices that fit no system.

use arithmetic::{Complex, Rational, rational};
use models::platoon::state_space::{StateSpace, StateSpaceError};

type Rows = Vec<Vec<Rational>>;

fn rows(list: &[&[i64]]) -> Rows {
    list.iter().map(|row| row.iter().map(|&x| rational(x, 1)).collect()).collect()
}

/// `(s + 1)(s + 2)` below, `b (s + 3) + c` above.
#[test]
fn responses_are_those_of_the_transfer_function() {
    let a = rows(&[&[0, 1], &[-2, -3]]);
    let w = rational(3, 2);
    let s = Complex::new(rational(0, 1), w.clone());
    let real = |x: i64| Complex::real(rational(x, 1));
    // x_1 = u_2 + (s + 3) u_1, x_2 = s u_2 - 2 u_1, all over (s + 1)(s + 2).
    let below = (s.clone() + real(1)) * (s.clone() + real(2));
    for (inputs, c, d) in [
        (rows(&[&[0], &[1]]), rows(&[&[1, 0]]), None),
        (rows(&[&[5], &[7]]), rows(&[&[1, 4]]), Some(rows(&[&[2]]))),
        (rows(&[&[5, 1], &[7, -2]]), rows(&[&[3, 4]]), Some(rows(&[&[2, 6]]))),
        (rows(&[&[5, 1], &[7, -2]]), rows(&[&[3, 4]]), None),
    ] {
        let system = StateSpace::new(&a, &inputs, &c, d.as_deref()).unwrap();
        // The second input is the velocity of the leader.
        let driven = |row: &[Rational]| {
            let first = Complex::real(row[0].clone());
            row.get(1).map_or(first.clone(), |q| first + s.clone() * &Complex::real(q.clone()))
        };
        let (first, second) = (driven(&inputs[0]), driven(&inputs[1]));
        let one = second.clone() + (s.clone() + real(3)) * &first;
        let two = s.clone() * &second - real(2) * &first;
        let direct = d.as_ref().map_or(real(0), |d| driven(&d[0]));
        let above = Complex::real(c[0][0].clone()) * &one + Complex::real(c[0][1].clone()) * &two;
        let found = system.response(&w).unwrap();
        assert_eq!((found - direct) * &below, above);
        assert_eq!(system.states(), 2);
    }
    // On the pole itself there is no response.
    let swing = StateSpace::new(&rows(&[&[0, 1], &[-4, 0]]), &rows(&[&[0], &[1]]), &rows(&[&[1, 0]]), None).unwrap();
    assert!(swing.response(&rational(2, 1)).is_err());
}

/// `x'' + d x' + k x = k u` has the peak `k/(d sqrt(k - d²/4))` at `sqrt(k - d²/2)`.
#[test]
fn peaks_of_swinging_systems_are_known() {
    for (k, d) in [((1, 1), (1, 1)), ((4, 1), (1, 10)), ((1, 9), (1, 1000)), ((1, 1), (1, 1_000_000))] {
        let (k, d) = (rational(k.0, k.1), rational(d.0, d.1));
        let float = |q: &Rational| num_traits::ToPrimitive::to_f64(q).unwrap();
        let a = vec![vec![rational(0, 1), rational(1, 1)], vec![-&k, -&d]];
        let b = vec![vec![rational(0, 1)], vec![k.clone()]];
        let found = StateSpace::new(&a, &b, &rows(&[&[1, 0]]), None).unwrap().searched_peak().unwrap();
        let (k, d) = (float(&k), float(&d));
        let (value, at) = (k / (d * (k - 0.25 * d * d).sqrt()), (k - 0.5 * d * d).sqrt());
        assert!((found.value / value - 1.0).abs() < 1e-9, "{k} {d}: {found:?} {value}");
        assert!((found.at / at - 1.0).abs() < 1e-6, "{k} {d}: {found:?} {at}");
    }
    // Two at once, far apart, the higher peak first or last: (x'' + x'/100 + x = u) and (y'' + q y' + 10^4 y = 10^4 u).
    for (q, value, at) in [((1, 10), 1e3, 1e2), ((10, 1), 1e2, 1.0)] {
        let mut a = rows(&[&[0, 1, 0, 0], &[-1, 0, 0, 0], &[0, 0, 0, 1], &[0, 0, -10_000, 0]]);
        (a[1][1], a[3][3]) = (rational(-1, 100), rational(-q.0, q.1));
        let b = rows(&[&[0], &[1], &[0], &[10_000]]);
        let found = StateSpace::new(&a, &b, &rows(&[&[1, 0, 1, 0]]), None).unwrap().searched_peak().unwrap();
        assert!((found.value / value - 1.0).abs() < 1e-2 && (found.at / at - 1.0).abs() < 1e-3, "{found:?}");
    }
}

/// Without swinging modes: `a/(s + a)` falls, so that the first frequency has the largest value, a tenth of the rate; `s/(s + a)` rises up
/// to ten times of it; `s/((s + 1)(s + 4))` has 1/5 at 2.
#[test]
fn peaks_of_other_systems_are_known() {
    let system = |a: Rows, b: Rows, c: Rows, d: Option<Rows>| StateSpace::new(&a, &b, &c, d.as_deref()).unwrap();
    let falling = system(rows(&[&[-3]]), rows(&[&[3]]), rows(&[&[1]]), None).searched_peak().unwrap();
    assert!((falling.at - 0.3).abs() < 1e-12 && (falling.value - 1.0 / 1.01f64.sqrt()).abs() < 1e-12, "{falling:?}");
    let rising = system(rows(&[&[-3]]), rows(&[&[-3]]), rows(&[&[1]]), Some(rows(&[&[1]]))).searched_peak().unwrap();
    assert!((rising.at - 30.0).abs() < 1e-9 && (rising.value - 10.0 / 101f64.sqrt()).abs() < 1e-12, "{rising:?}");
    let middle =
        system(rows(&[&[0, 1], &[-4, -5]]), rows(&[&[0], &[1]]), rows(&[&[0, 1]]), None).searched_peak().unwrap();
    assert!((middle.at - 2.0).abs() < 1e-5 && (middle.value - 0.2).abs() < 1e-12, "{middle:?}");
    // Slow, and beside a state that rests: 3/100 below and above.
    let slow = |k: i64| rational(k, 100);
    let (a, b) = (vec![vec![slow(0), slow(0)], vec![slow(0), slow(-3)]], vec![vec![slow(700)], vec![slow(-3)]]);
    let found = system(a.clone(), b.clone(), rows(&[&[0, 1]]), Some(rows(&[&[1]]))).searched_peak().unwrap();
    assert!((found.at - 0.3).abs() < 1e-9 && (found.value - 10.0 / 101f64.sqrt()).abs() < 1e-12, "{found:?}");
    let found = system(a, b, rows(&[&[0, -1]]), None).searched_peak().unwrap();
    assert!((found.at - 0.003).abs() < 1e-12 && (found.value - 1.0 / 1.01f64.sqrt()).abs() < 1e-12, "{found:?}");
    let still = system(rows(&[&[0]]), rows(&[&[1]]), rows(&[&[1]]), None);
    assert!(still.searched_peak().is_err());
}

#[test]
fn matrices_that_fit_no_system_are_refused() {
    let (a, b, c, d) = (rows(&[&[0, 1], &[-2, -3]]), rows(&[&[0], &[1]]), rows(&[&[1, 0]]), rows(&[&[1]]));
    let shape = |name, found: &str, expected: &str| {
        Err(StateSpaceError::Shape { name, found: found.to_string(), expected: expected.to_string() })
    };
    let build = |a: &Rows, b: &Rows, c: &Rows, d: Option<&Rows>| {
        StateSpace::new(a, b, c, d.map(Vec::as_slice)).map(|system| system.states())
    };
    assert_eq!(build(&a, &b, &c, Some(&d)), Ok(2));
    assert_eq!(build(&vec![], &b, &c, None), shape("A", "0 rows", "1 rows of 1 numbers"));
    let uneven = rows(&[&[0, 1], &[-2]]);
    assert_eq!(build(&uneven, &b, &c, None), shape("A", "a row of 1 numbers", "2 rows of 2 numbers"));
    let wide = rows(&[&[0, 1, 2], &[-2, 1, 2]]);
    assert_eq!(build(&wide, &b, &c, None), shape("A", "a row of 3 numbers", "2 rows of 2 numbers"));
    assert_eq!(build(&a, &rows(&[&[1]]), &c, None), shape("B", "1 rows", "2 rows of 1 numbers"));
    let three = rows(&[&[1, 1, 1], &[1, 1, 1]]);
    assert_eq!(build(&a, &three, &c, None), shape("B", "a row of 3 numbers", "2 rows of 1 numbers"));
    assert_eq!(build(&a, &rows(&[&[], &[]]), &c, None), shape("B", "a row of 0 numbers", "2 rows of 1 numbers"));
    assert_eq!(build(&a, &b, &rows(&[&[1]]), None), shape("C", "a row of 1 numbers", "1 rows of 2 numbers"));
    assert_eq!(build(&a, &b, &rows(&[]), None), shape("C", "0 rows", "1 rows of 2 numbers"));
    let pair = rows(&[&[1, 1]]);
    assert_eq!(build(&a, &b, &c, Some(&pair)), shape("D", "a row of 2 numbers", "1 rows of 1 numbers"));
    let double = rows(&[&[0, 1], &[1, 1]]);
    assert_eq!(build(&a, &double, &c, Some(&d)), shape("D", "a row of 1 numbers", "1 rows of 2 numbers"));
    assert_eq!(build(&a, &double, &c, Some(&pair)), Ok(2));
    let falling = rows(&[&[0, 1], &[1]]);
    assert_eq!(build(&a, &falling, &c, None), shape("B", "a row of 1 numbers", "2 rows of 2 numbers"));
    let rising = rows(&[&[0], &[1, 1]]);
    assert_eq!(build(&a, &rising, &c, None), shape("B", "a row of 2 numbers", "2 rows of 1 numbers"));
}
