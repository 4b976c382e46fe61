//! Exact cosines and sines against intervals, the degree of their field, inverses and signs; least squares; roots of series.

use arithmetic::{
    CosineField, Field, Interval, Number, Rational, Real, Ring, Series, Sign, Signed, rational, regression_line,
};

fn turn(k: i64, parts: u32) -> (Interval, Interval) {
    let one = Interval::from_rational(&rational(1, 1), 80);
    let (sine, cosine) = (one.pi() * one.ratio(2 * k, i64::from(parts))).sin_cos().unwrap();
    (cosine, sine)
}

#[test]
fn cosines_sines_and_their_sums_products_and_inverses() {
    for parts in 1..=17u32 {
        let field = CosineField::new(parts);
        for k in -3..=(parts as i64 + 2) {
            let (cosine, sine) = turn(k, parts);
            for (exact, near) in [(field.cos(k), &cosine), (field.sin(k), &sine)] {
                let found = exact.enclose(80).unwrap();
                assert!(found.overlaps(near) && found.width() < near.one().ratio(1, 1 << 40).hi().clone());
                assert!(near.sign().is_none_or(|sign| exact.sign() == Some(sign)));
                let one = field.number(&rational(1, 1));
                match exact.recip() {
                    Ok(inverse) => assert!(inverse * &exact == one),
                    Err(_) => assert_eq!(exact.sign(), Some(Sign::Zero)),
                }
                let shifted = exact.clone() + field.number(&rational(5, 3));
                assert!(shifted.recip().unwrap() * &shifted == one);
                let product = exact.clone() * field.cos(1) - field.sin(2);
                let twin = near.clone() * turn(1, parts).0 - turn(2, parts).1;
                assert!(product.enclose(80).unwrap().overlaps(&twin));
            }
            assert!(field.cos(k).square() + field.sin(k).square() == field.number(&rational(1, 1)));
            let phasor = field.phasor(k);
            assert!(phasor.re == field.cos(k) && phasor.im == field.sin(k));
        }
    }
}

#[test]
fn rational_values_and_degrees() {
    let value = |parts: u32, k: i64| CosineField::new(parts).cos(k).rational_value().cloned();
    assert_eq!(value(6, 1), Some(rational(1, 2)));
    assert_eq!(value(3, 1), Some(rational(-1, 2)));
    assert_eq!(value(4, 1), Some(rational(0, 1)));
    assert_eq!(value(5, 1), None);
    assert_eq!(CosineField::new(0).cos(1).rational_value(), Some(&rational(1, 1)));
    // Cosines and sines of a twelfth: sqrt 3. Of a twentieth: degree 4. Of an eighth: sqrt 2.
    assert_eq!([12, 8, 4, 20].map(|parts| CosineField::new(parts).degree()), [2, 2, 1, 4]);
    let (third, half) = (rational(1, 3), rational(1, 2));
    let field = CosineField::new(5);
    assert_eq!(field.number(&third).rational_value(), Some(&third));
    assert!(field.cos(1) != field.cos(2) && field.cos(1) == field.cos(4) && field.cos(1) != CosineField::new(7).cos(1));
    assert!(field.cos(1) + field.cos(2) == field.number(&-half));
}

#[test]
fn fields_of_one_degree_and_signs_of_small_numbers() {
    // Half of 2 cos in both fields, with the degree 2: cos(pi/6) and cos(pi/4).
    let (twelfths, eighths) = (CosineField::new(12), CosineField::new(8));
    assert!(twelfths.cos(1) != eighths.cos(1) && twelfths.cos(1) == twelfths.cos(-1));
    // (2 cos(pi/6))^2 = 3, and (2 - sqrt 3)^60 = a - b sqrt 3 is below 2^-110.
    let small = (twelfths.number(&rational(2, 1)) - twelfths.cos(1) * twelfths.number(&rational(2, 1))).power(60);
    assert_eq!(small.sign(), Some(Sign::Positive));
    assert_eq!((-small).sign(), Some(Sign::Negative));
}

#[test]
fn a_least_squares_line() {
    let points = |list: &[(i64, i64)]| -> Vec<(Rational, Rational)> {
        list.iter().map(|&(x, y)| (rational(x, 1), rational(y, 1))).collect()
    };
    let line = |list: &[(i64, i64)]| regression_line(&points(list));
    assert_eq!(line(&[(1, 5), (3, 11), (4, 14)]), Ok((rational(3, 1), rational(2, 1))));
    // sum dx dy / sum dx² = 10/14, through the mean (2, 7/4).
    assert_eq!(line(&[(0, 0), (1, 2), (2, 1), (5, 4)]), Ok((rational(5, 7), rational(9, 28))));
    assert!(line(&[]).is_err() && line(&[(1, 2), (1, 3)]).is_err());
}

#[test]
fn roots_and_multiples_of_series() {
    let of = |list: &[i64]| {
        let rest = list[1..].iter().map(|&n| rational(n, 1));
        Series::from_coefficients(rational(list[0], 1), rest)
    };
    let root = of(&[1, 2, -3, 5, 7]);
    assert_eq!(root.square().sqrt_of_unit().unwrap(), root);
    assert_eq!(root.scale(&rational(2, 1)), of(&[2, 4, -6, 10, 14]));
    assert_eq!(of(&[1, 2, 3]) * of(&[4, 5]), of(&[4, 13]));
    assert_eq!(root.recip().unwrap() * &root, of(&[1, 0, 0, 0, 0]));
    assert_eq!(root.integer(3), of(&[3, 0, 0, 0, 0]));
    assert_eq!(of(&[1, 2, 3]) - of(&[4, 7]), of(&[-3, -5]));
    assert_eq!(of(&[1, 2, 3]) + of(&[4, 7, 1]), of(&[5, 9, 4]));
    // One coefficient is enough.
    let single = of(&[1]);
    assert_eq!((single.sqrt_of_unit().unwrap(), single.recip().unwrap()), (single.clone(), single.clone()));
    assert_eq!((single.integer(5), single.rational(&rational(5, 1))), (of(&[5]), of(&[5])));
    assert_eq!(of(&[3]) * of(&[4, 1]), of(&[12]));
}
