//! The expansion of the distance of two birds against powers of the transition matrix.

use algebra::graph::Graph;
use arithmetic::{Rational, rational};
use models::averaging::{Separation, Transients, Weights};

#[test]
fn the_expansion_is_the_distance() {
    let flock = |n: usize| {
        let mut next = 1;
        Transients::new(&Graph::path(n), &Weights::Lazy, |_| {
            next += 1;
            vec![rational(next, 8), rational(1 - next, 4)]
        })
        .unwrap()
        .unwrap()
    };
    let (p, q) = (flock(4), flock(2));
    let separation = Separation::new(vec![rational(3, 5), rational(4, 5)], (&p, 1), (&q, 0));
    let excess = separation.excess((&p, 1), (&q, 0), 12).unwrap();
    for (s, excess) in excess.iter().enumerate().skip(1) {
        let sign = rational(if s % 2 == 0 { 1 } else { -1 }, 1);
        let term = |(rho, (plus, minus)): (Rational, (Rational, Rational))| (plus + minus * &sign) * rho.pow(s as i32);
        assert_eq!(separation.expansion().into_iter().map(term).sum::<Rational>(), *excess, "s = {s}");
    }
    let none = Transients::new(&Graph::path(5), &Weights::Vicsek, |_| Vec::new()).unwrap();
    assert!(none.is_none());
}
