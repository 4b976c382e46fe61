//! Reading and writing numbers.

use arithmetic::{Interval, NumberError, decimal, decimals, parse_rational, rational, significant_digits};
use proptest::prelude::*;

#[test]
fn reads_integers_fractions_and_decimals() {
    for (text, p, q) in [
        ("3", 3, 1),
        ("-1/2", -1, 2),
        ("-0.5", -1, 2),
        ("+4", 4, 1),
        (".25", 1, 4),
        ("2.", 2, 1),
        ("1e-3", 1, 1000),
        ("2.5E2", 250, 1),
        (" 6/4 ", 3, 2),
        ("0.5/0.25", 2, 1),
        ("-0", 0, 1),
    ] {
        assert_eq!(parse_rational(text), Ok(rational(p, q)), "{text}");
    }
}

#[test]
fn refuses_everything_else() {
    for text in ["", "-", ".", "1/2/3", "one", "1e", "0x10", "--1", "1 2", "NaN", "inf", "1e2.5", "1,5"] {
        assert!(matches!(parse_rational(text), Err(NumberError::NotANumber(_))), "{text:?}");
    }
    for text in ["½", "٣", "\u{2212}1"] {
        assert!(matches!(parse_rational(text), Err(NumberError::OtherDigits(_))), "{text:?}");
    }
    assert_eq!(parse_rational("1/0"), Err(NumberError::ZeroDenominator("1/0".into())));
    assert_eq!(parse_rational("1e999999999"), Err(NumberError::TooLong));
    assert_eq!(parse_rational(&"9".repeat(20_000)), Err(NumberError::TooLong));
}

#[test]
fn writes_decimals_rounded_to_the_asked_side() {
    for (p, q, digits, down, up) in [
        (1, 3, 3, "0.333", "0.334"),
        (-1, 3, 3, "-0.334", "-0.333"),
        (2, 1, 5, "2", "2"),
        (999, 1000, 2, "0.99", "1"),
        (1, 1_000_000_000, 3, "1e-9", "1e-9"),
        (123_456, 1, 3, "123000", "124000"),
        (0, 1, 4, "0", "0"),
        (1, 1_000, 1, "0.001", "0.001"),
    ] {
        let x = rational(p, q);
        assert_eq!((decimal(&x, digits, false).as_str(), decimal(&x, digits, true).as_str()), (down, up), "{p}/{q}");
    }
}

proptest! {
    #[test]
    fn written_decimals_enclose_and_read_back(p in any::<i64>(), q in 1..i64::MAX, digits in 1u32..30) {
        let x = rational(p, q);
        let (lo, hi) = (parse_rational(&decimal(&x, digits, false)), parse_rational(&decimal(&x, digits, true)));
        prop_assert!(lo.clone().unwrap() <= x && x <= hi.clone().unwrap());
        let width = hi.unwrap() - lo.unwrap();
        let bound = num_traits::Signed::abs(&x) * rational(10, 1) / rational(10, 1).pow(digits as i32);
        prop_assert!(width <= bound, "{} is wider than {}", width, bound);
    }

    #[test]
    fn any_text_is_read_or_refused(text in ".{0,40}") {
        let _ = parse_rational(&text);
    }
}

#[test]
fn counts_settled_digits() {
    let x = Interval::hull_of_rationals(&rational(100_000, 1), &rational(100_001, 1), 60);
    assert_eq!(significant_digits(&x), 4);
    assert_eq!(significant_digits(&Interval::hull_of_rationals(&rational(-1, 1), &rational(1, 1), 60)), 0);
}

#[test]
fn messages_show_the_beginning_of_a_text_on_one_line() {
    let shown = |text: &str| match parse_rational(text) {
        Err(NumberError::NotANumber(shown)) => shown,
        other => panic!("{text:?}: {other:?}"),
    };
    assert_eq!(shown(&"x".repeat(60)), "x".repeat(60));
    assert_eq!(shown(&"x".repeat(61)), format!("{}...", "x".repeat(60)));
    assert_eq!(shown("1\u{7}x"), "1\\u{7}x");
    assert_eq!(shown("é x"), "é x");
    assert_eq!(shown("1\u{2028}x\u{2029}y"), "1\\u{2028}x\\u{2029}y");
}

#[test]
fn lengths_up_to_the_limit_are_read() {
    assert!(parse_rational(&"9".repeat(10_000)).is_ok());
    assert_eq!(parse_rational(&"9".repeat(10_001)), Err(NumberError::TooLong));
    assert!(parse_rational("1e10000").is_ok() && parse_rational("1e-10000").is_ok());
    assert!(parse_rational("1e10001").is_err() && parse_rational("1e-10001").is_err());
}

#[test]
fn rounding_that_carries_and_one_digit() {
    assert_eq!(decimal(&rational(-9996, 1000), 3, false), "-10");
    assert_eq!(decimal(&rational(9996, 1000), 3, true), "10");
    assert_eq!(decimal(&rational(1, 3), 1, false), "0.3");
    assert_eq!(decimal(&rational(1, 3), 0, true), "0.4");
    let third = Interval::hull_of_rationals(&rational(1, 3), &rational(2, 3), 60);
    assert_eq!(decimals(&third, 3), ("0.333".to_string(), "0.667".to_string()));
    assert_eq!(significant_digits(&Interval::hull_of_rationals(&rational(5, 1), &rational(5, 1), 60)), u32::MAX);
}
