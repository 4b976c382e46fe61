use arithmetic::{Rational, Unwatched, rational};
use polynomials::Multivariate;
use polynomials::sums::{Certificate, Problem, Search};

type P = Multivariate<Rational>;

fn x(k: usize) -> P {
    Multivariate::x(k)
}
fn c(p: i64, q: i64) -> P {
    Multivariate::of(rational(p, q))
}

fn search(goal: P, strict: bool, constraints: Vec<P>) -> Option<Certificate> {
    let problem = Problem { goal, strict, constraints, relations: Vec::new(), zeros: Vec::new() };
    match problem.search(&Unwatched).unwrap() {
        Search::Found(found) => {
            checked(&found);
            Some(*found)
        }
        Search::Nothing(_) => None,
    }
}

/// The separate checker takes the file, and refuses it with another goal.
fn checked(found: &Certificate) {
    let text = found.text();
    let accepted = flockproof_checker::check(text.as_bytes()).unwrap_or_else(|refusal| panic!("{refusal:?}\n{text}"));
    assert_eq!(accepted.claim, found.claim());
    for small in [rational(1, 1000), rational(1, 1_000_000)] {
        let mut altered = found.clone();
        altered.goal = altered.goal - Multivariate::of(small);
        assert!(!altered.is_valid());
        let refusal = flockproof_checker::check(altered.text().as_bytes()).expect_err("another goal");
        assert!(refusal.reason.contains("not the same polynomial"), "{refusal:?}");
    }
}

fn box_of(n: usize, lo: i64, hi: i64) -> Vec<P> {
    (0..n).flat_map(|k| [x(k) - c(lo, 1), c(hi, 1) - x(k)]).collect()
}

fn motzkin() -> P {
    let (x2, y2) = (x(0) * x(0), x(1) * x(1));
    x2.clone() * &x2 * &y2 + x2.clone() * &y2 * &y2 - c(3, 1) * x2 * y2 + c(1, 1)
}

#[test]
fn classical_polynomials_are_sums_of_squares() {
    let mean = (x(0) + x(1)) * (x(0) + x(1)) * c(1, 4) - x(0) * x(1);
    assert!(search(mean, false, Vec::new()).is_some());
    let sum = |f: &dyn Fn(usize) -> P, n: usize| (0..n).map(f).fold(c(0, 1), |s, t| s + t);
    for n in 2..4 {
        let cauchy = sum(&|k| x(k) * x(k), n) * sum(&|k| x(n + k) * x(n + k), n)
            - sum(&|k| x(k) * x(n + k), n) * sum(&|k| x(k) * x(n + k), n);
        assert!(search(cauchy, false, Vec::new()).is_some(), "Cauchy in {n}");
    }
    assert!(search(motzkin(), false, Vec::new()).is_some());
    assert!(search(motzkin() + c(1, 1000), true, Vec::new()).is_some());
    assert!(search(motzkin() - c(1, 1000), false, Vec::new()).is_none());
}

#[test]
fn constraints_are_used() {
    // x (1 - x) >= 0, x² <= x, x + y - 1 <= x y on the unit square.
    assert!(search(x(0) - x(0) * x(0), false, box_of(1, 0, 1)).is_some());
    assert!(search(x(0) * x(1) - x(0) - x(1) + c(1, 1), false, box_of(2, 0, 1)).is_some());
    assert!(search(x(0) * x(1) - x(0) - x(1) + c(1, 1), false, Vec::new()).is_none());
    assert!(search(x(0) * x(1) - x(0) - x(1) + c(999, 1000), false, box_of(2, 0, 1)).is_none());
    assert!(search(motzkin(), false, box_of(2, -2, 2)).is_some());
}
