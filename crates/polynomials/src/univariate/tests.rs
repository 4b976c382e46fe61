//! Each operation against its definition over the rationals.

use super::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Stops the work when it asks once more than so often.
struct After(AtomicUsize);

impl After {
    fn new(questions: usize) -> Self {
        After(questions.into())
    }
}

impl Progress for After {
    fn is_cancelled(&self) -> bool {
        self.0.fetch_update(Ordering::Relaxed, Ordering::Relaxed, |left| left.checked_sub(1)).is_err()
    }
}

fn integers(coefficients: &[i64]) -> Polynomial {
    Polynomial::new(coefficients.iter().map(|&c| BigInt::from(c)).collect())
}

/// All polynomials with small coefficients of degree 3 at most, the zero polynomial too.
fn small() -> impl Iterator<Item = Polynomial> {
    const SIZES: [i64; 5] = [0, 1, -2, 3, -6];
    (0..625usize).map(|k| integers(&[k % 5, k / 5 % 5, k / 25 % 5, k / 125].map(|digit| SIZES[digit])))
}

/// Every seventh of them, so that pairs are few enough.
fn some() -> Vec<Polynomial> {
    small().step_by(7).collect()
}

fn rationals(p: &Polynomial) -> Vec<Rational> {
    p.coefficients().iter().map(|c| Rational::from_integer(c.clone())).collect()
}

fn times(a: &Polynomial, b: &Polynomial) -> Polynomial {
    let mut product = vec![BigInt::ZERO; a.coefficients.len() + b.coefficients.len()];
    for (i, x) in a.coefficients.iter().enumerate() {
        b.coefficients.iter().enumerate().for_each(|(j, y)| product[i + j] += x * y);
    }
    Polynomial::new(product)
}

/// The quotient and the remainder over the rationals, by the school's method.
fn divided(a: &Polynomial, b: &Polynomial) -> (Polynomial, Polynomial) {
    let (mut rest, b) = (rationals(a), rationals(b));
    let mut quotient = vec![rational(0, 1); rest.len()];
    for shift in (0..(rest.len() + 1).saturating_sub(b.len())).rev() {
        let factor = &rest[shift + b.len() - 1] / &b[b.len() - 1];
        b.iter().enumerate().for_each(|(k, c)| rest[shift + k] -= c * &factor);
        quotient[shift] = factor;
    }
    (Polynomial::from_rationals(&quotient), Polynomial::from_rationals(&rest))
}

/// With a positive leading coefficient: equal for polynomials that are equal up to a factor.
fn monic(p: &Polynomial) -> Polynomial {
    let sign = if p.coefficients.last().is_some_and(Signed::is_negative) { -1 } else { 1 };
    Polynomial::new(p.coefficients.iter().map(|c| c * sign).collect())
}

fn linear(root: i64) -> Polynomial {
    integers(&[-root, 1])
}

#[test]
fn coefficients_have_no_common_factor_and_no_leading_zeros() {
    assert_eq!(integers(&[2, 4, 0, 0]).coefficients, [1, 2].map(BigInt::from));
    assert_eq!(integers(&[-6, 0, 9]).coefficients, [-2, 0, 3].map(BigInt::from));
    assert_eq!(integers(&[-3]).coefficients, [-1].map(BigInt::from));
    assert!(integers(&[0, 0]).is_zero() && integers(&[]).is_zero() && !integers(&[1]).is_zero());
    assert_eq!([integers(&[]), integers(&[7]), integers(&[0, 0, 5])].map(|p| p.degree()), [0, 0, 2]);
    let thirds = [rational(1, 2), rational(0, 1), rational(-2, 3)];
    assert_eq!(Polynomial::from_rationals(&thirds).coefficients, [3, 0, -4].map(BigInt::from));
    assert_eq!(integers(&[5, -2, 3, 10]).derivative().coefficients, [-1, 3, 15].map(BigInt::from));
    assert!(integers(&[4]).derivative().is_zero());
}

#[test]
fn values_signs_and_enclosures_are_sums_of_powers() {
    for p in small() {
        for (numerator, denominator) in [(0, 1), (1, 1), (-2, 1), (1, 2), (-3, 4), (7, 8)] {
            let x = rational(numerator, denominator);
            let terms = rationals(&p).into_iter().enumerate().map(|(k, c)| c * x.pow(k as i32));
            let naive: Rational = terms.sum();
            assert_eq!(p.at(&x), naive);
            assert_eq!(p.sign_at(&x), naive.cmp(&rational(0, 1)) as i8);
        }
    }
}

#[test]
fn integer_roots_are_divided_out() {
    for rest in [integers(&[1]), integers(&[3, 0, 2]), integers(&[-1, 2])] {
        for root in [-3, 0, 1, 5] {
            let mut p = rest.clone();
            for times_divided in 0..4 {
                assert_eq!(p.without_root(root), (times_divided, rest.clone()));
                p = times(&p, &linear(root));
            }
        }
    }
    assert_eq!(integers(&[]).without_root(2), (0, integers(&[])));
}

#[test]
fn quotients_and_remainders_are_those_of_rationals() {
    for a in small().step_by(3) {
        for b in some().into_iter().filter(|b| !b.is_zero()) {
            let (quotient, rest) = divided(&a, &b);
            assert_eq!(a.positive_remainder(&b), rest, "{a:?} {b:?}");
            assert_eq!(monic(&a.divided_by(&b)), monic(&quotient), "{a:?} {b:?}");
        }
        assert_eq!((a.positive_remainder(&integers(&[])), a.divided_by(&integers(&[]))), (a.clone(), a));
    }
}

#[test]
fn common_divisors_divide_both_and_are_the_greatest() {
    let parts = [integers(&[1]), integers(&[-1, 2]), integers(&[1, 0, 1]), integers(&[-6, 1, 1])];
    for common in &parts {
        // Coprime to each other and to all parts.
        let (a, b) = (times(common, &integers(&[7, 3])), times(common, &integers(&[5, -1, 4])));
        assert_eq!(monic(&a.gcd(&b)), monic(common));
        assert_eq!(monic(&b.gcd(&a)), monic(common));
        assert_eq!((monic(&a.gcd(&integers(&[]))), monic(&integers(&[]).gcd(&a))), (monic(&a), monic(&a)));
    }
}

#[test]
fn factors_without_multiple_roots_with_their_powers() {
    let (one, two, pair) = (linear(1), linear(2), integers(&[1, 0, 3]));
    let power = |p: &Polynomial, k: usize| (0..k).fold(integers(&[1]), |product, _| times(&product, p));
    for (i, j, k) in [(1, 0, 0), (1, 1, 1), (3, 1, 0), (2, 2, 1), (1, 4, 2), (0, 3, 5), (0, 0, 2)] {
        let p = times(&times(&power(&one, i), &power(&two, j)), &power(&pair, k));
        let expected = (1..=5).filter_map(|exponent| {
            let which = [(&one, i), (&two, j), (&pair, k)];
            let parts = which.into_iter().filter(|(_, times)| *times == exponent);
            let product = parts.fold(integers(&[1]), |product, (part, _)| times(&product, part));
            (product.degree() > 0).then_some((product, exponent))
        });
        let found = p.square_free_factors().into_iter().map(|(factor, exponent)| (monic(&factor), exponent));
        assert_eq!(found.collect::<Vec<_>>(), expected.collect::<Vec<_>>(), "{i} {j} {k}");
        assert_eq!(p.is_square_free(), i.max(j).max(k) <= 1);
    }
    assert!(integers(&[5]).square_free_factors().is_empty());
    assert!(integers(&[5]).is_square_free() && !integers(&[]).is_square_free());
}

/// Whether the ends are what a root promises: the root is one of both, or strictly between and the only one.
fn assert_isolated(p: &Polynomial, root: &RealRoot, exact: &Rational) {
    let is_exact = root.lo == *exact && root.hi == *exact;
    let is_between = root.lo < *exact && *exact < root.hi && p.sign_at(&root.lo) * p.sign_at(&root.hi) == -1;
    assert!(is_exact || is_between, "{root:?} {exact}");
    assert_eq!(root.exact(), is_exact.then_some(exact));
}

/// `x` from -4 to 4, in sixths: ends of ranges that are roots count at the top and not at the bottom.
#[test]
fn roots_of_half_open_ranges_are_isolated() {
    let halves = [-7, -4, 0, 1, 2, 3, 8];
    let p = halves.iter().fold(integers(&[1, 1, 1]), |product, &x| times(&product, &integers(&[-x, 2])));
    for lo in -24..24 {
        for hi in (lo + 1..=24).step_by(5) {
            let (from, to) = (rational(lo, 6), rational(hi, 6));
            let exact: Vec<Rational> =
                halves.iter().map(|&x| rational(x, 2)).filter(|x| from < *x && *x <= to).collect();
            let found = p.roots_in(&from, &to);
            assert_eq!(found.len(), exact.len(), "{from} {to}");
            for (root, exact) in found.iter().zip(&exact) {
                assert!(from <= root.lo && root.hi <= to);
                assert_isolated(&p, root, exact);
            }
            assert!(found.windows(2).all(|pair| pair[0].hi <= pair[1].lo));
        }
    }
    assert!(integers(&[1]).roots_in(&rational(0, 1), &rational(1, 1)).is_empty());
}

#[test]
fn the_chain_and_the_search_can_be_stopped() {
    let p = (1..6).fold(integers(&[1]), |product, x| times(&product, &linear(x)));
    // A remainder for each degree from 3 down to 0, then the range and its parts.
    assert_eq!(p.is_square_free_watched(&After::new(4)), Ok(true));
    let (lo, hi) = (rational(0, 1), rational(8, 1));
    for count in 0..4 {
        assert_eq!(p.is_square_free_watched(&After::new(count)), Err(Cancelled));
    }
    for count in 0..=4 {
        assert_eq!(p.roots_in_watched(&lo, &hi, &After::new(count)), Err(Cancelled));
    }
    assert_eq!(p.roots_in_watched(&lo, &hi, &Unwatched).map(|roots| roots.len()), Ok(5));
}

/// Enclosures are refined as far as asked for; those that are narrow enough stay.
#[test]
fn refined_enclosures_are_as_narrow_as_asked_for() {
    // The roots of 2 and of 1/3, and thirds: none is dyadic.
    for (p, exact) in [
        (integers(&[-2, 0, 1]), 2f64.sqrt()),
        (integers(&[-1, 0, 3]), (1.0f64 / 3.0).sqrt()),
        (integers(&[-1, 3]), 1.0 / 3.0),
        (integers(&[2, 1, -12, -6, 3]), 0.4157),
    ] {
        for (denominator, start) in [(1, 1), (4, 4), (3, 3)] {
            let near = (exact * f64::from(denominator)).floor() as i64;
            let wide = RealRoot { lo: rational(near, start), hi: rational(near + 1, start) };
            if p.sign_at(&wide.lo) * p.sign_at(&wide.hi) >= 0 {
                continue;
            }
            for bits in [0, 1, 2, 3, 10, 64, 300] {
                let mut root = wide.clone();
                p.refine(&mut root, bits);
                let width = Rational::new(1.into(), BigInt::from(1) << bits);
                assert!(&root.hi - &root.lo <= width, "{p:?} {bits} {root:?}");
                assert!(wide.lo <= root.lo && root.hi <= wide.hi);
                assert_eq!(p.sign_at(&root.lo) * p.sign_at(&root.hi), -1);
                if &wide.hi - &wide.lo <= width {
                    assert_eq!(root, wide);
                }
                assert!((root.enclosure(64).to_f64() - exact).abs() < 1e-3 || bits < 10);
            }
        }
    }
}

#[test]
fn dyadic_roots_are_met_exactly() {
    // x - 5/1024 times a factor without other roots nearby; the last is met at the upper end of a part.
    for (p, root) in [
        (integers(&[-5, 1024]), rational(5, 1024)),
        (times(&integers(&[-5, 1024]), &integers(&[1, 0, 1])), rational(5, 1024)),
        (times(&integers(&[-5, 1024]), &integers(&[9, 1])), rational(5, 1024)),
        (times(&integers(&[-5, 1024]), &integers(&[9, -1])), rational(5, 1024)),
        (integers(&[-1, 0, 4]), rational(1, 2)),
    ] {
        let mut found = RealRoot { lo: rational(0, 1), hi: rational(1, 1) };
        p.refine(&mut found, 300);
        assert_eq!(found.exact(), Some(&root), "{p:?}");
    }
    // The chord of 4x² - 1 between 0 and 1 falls into the second quarter, whose upper end is the root; that of 4x - 1 to its lower end.
    for (p, root) in [(integers(&[-1, 0, 4]), rational(1, 2)), (integers(&[-1, 4]), rational(1, 4))] {
        for sign in [1, -1] {
            let p = Polynomial { coefficients: p.coefficients.iter().map(|c| c * sign).collect() };
            let mut found = RealRoot { lo: rational(0, 1), hi: rational(1, 1) };
            assert!(p.refine_by_chord(&mut found, 2));
            assert_eq!(found.exact(), Some(&root));
        }
    }
    // The third quarter is not where the root of x^8 - 1/4 is: nothing changes.
    let flat = integers(&[-1, 0, 0, 0, 0, 0, 0, 0, 4]);
    let wide = RealRoot { lo: rational(0, 1), hi: rational(1, 1) };
    let mut found = wide.clone();
    assert!(!flat.refine_by_chord(&mut found, 2) && found == wide);
}

#[test]
fn rational_roots_are_told_from_their_neighbours() {
    // Between 3/8 and 5/8 there are two multiples of 1/5, and one between 3/8 and 1/2.
    for (lo, hi) in [((3, 8), (5, 8)), ((1, 4), (3, 4)), ((0, 1), (1, 1)), ((2, 5), (2, 5))] {
        let mut root = RealRoot { lo: rational(lo.0, lo.1), hi: rational(hi.0, hi.1) };
        assert_eq!(integers(&[-2, 5]).rational_root(&mut root), Some(rational(2, 5)));
        assert_eq!(integers(&[2, -5]).rational_root(&mut root), Some(rational(2, 5)));
    }
    for p in [integers(&[-2, 0, 1]), integers(&[-3, 0, 4, 0, 1]), integers(&[-1, 1, 7])] {
        let mut root = p.roots_in(&rational(0, 1), &rational(4, 1)).remove(0);
        assert_eq!(p.rational_root(&mut root), None);
    }
    assert_eq!(integers(&[]).rational_root(&mut RealRoot { lo: rational(0, 1), hi: rational(1, 1) }), None);
}

#[test]
fn ends_and_enclosures_of_roots() {
    let root = RealRoot { lo: rational(1, 4), hi: rational(3, 4) };
    assert_eq!((root.lo(), root.hi(), root.exact()), (&rational(1, 4), &rational(3, 4), None));
    assert_eq!(root.enclosure(64).to_rationals(), (rational(1, 4), rational(3, 4)));
    assert_eq!((root.enclosure(64).precision(), root.enclosure(64).to_f64()), (64, 0.5));
}

/// The leading bits of a value at a dyadic number: `m 2^e` is the value cut off after at least as many bits as asked for.
#[test]
fn leading_bits_of_values() {
    let p = integers(&[3, -5, 0, 7]);
    for (x, bits) in
        [(rational(3, 4), 4), (rational(-5, 1), 4), (Rational::new(BigInt::from(3), BigInt::from(1) << 90u32), 7)]
    {
        let (m, e) = p.leading_value(&x, bits).expect("a dyadic number");
        let cut = Rational::from_integer(m.clone()) * rational(2, 1).pow(e as i32);
        let left = p.at(&x) - cut;
        assert!(left >= rational(0, 1) && left < rational(2, 1).pow(e as i32), "{x}");
        assert!(m.bits() <= u64::from(bits) + 64);
    }
    assert!(p.leading_value(&rational(1, 3), 4).is_none());
}
