//! Degrees and sizes of coefficients, found by running an expression.

use arithmetic::{DegreeBound, Field, Ring, rational};

fn bound(numerator: u64, denominator: u64, numerator_bits: u64, denominator_bits: u64) -> DegreeBound {
    DegreeBound { numerator, denominator, numerator_bits, denominator_bits }
}

#[test]
fn constants_have_the_bits_of_their_integers() {
    let x = DegreeBound::VARIABLE;
    assert_eq!(x, bound(1, 0, 0, 0));
    assert_eq!((x.integer(-5), x.integer(8)), (bound(0, 0, 3, 0), bound(0, 0, 4, 0)));
    assert_eq!(x.rational(&rational(-5, 33)), bound(0, 0, 3, 6));
}

#[test]
fn fractions_are_put_over_a_common_denominator() {
    // (n1 d2 + n2 d1)/(d1 d2), where each of the two terms may be the larger one.
    let (a, b) = (bound(7, 2, 11, 5), bound(3, 4, 6, 9));
    for sum in [a + b, b + a, a - b] {
        assert_eq!(sum, bound(11, 6, 21, 14));
    }
    let c = bound(1, 9, 2, 20);
    for sum in [a + c, c + a] {
        assert_eq!(sum, bound(16, 11, 32, 25));
    }
    let d = bound(8, 1, 12, 3);
    assert_eq!((c + d, d + c), (bound(17, 10, 33, 23), bound(17, 10, 33, 23)));
    assert_eq!((a * b, -a), (bound(10, 6, 17, 14), a));
    assert_eq!(a.recip(), Ok(bound(2, 7, 5, 11)));
}
