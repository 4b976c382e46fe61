//! Numbers as people write them: integers, fractions and decimals in, decimals with a stated rounding out.

use super::Rational;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{Pow, Signed, Zero};

/// Longest number that is read, in characters; also the largest decimal exponent.
const LONGEST: usize = 10_000;

/// Why a text is not a number.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum NumberError {
    /// Not an integer, a fraction or a decimal.
    #[error("`{0}` is not an integer, a fraction p/q or a decimal")]
    NotANumber(String),
    /// Digits of another script, which look like a number and are none here.
    #[error("`{0}` has digits other than 0 to 9, or a sign other than - and +")]
    OtherDigits(String),
    /// A fraction with denominator zero.
    #[error("`{0}` has a zero denominator")]
    ZeroDenominator(String),
    /// Too many digits or too large an exponent.
    #[error("a number of more than {LONGEST} digits is not read")]
    TooLong,
}

/// At most so many characters of a text stand in a message.
const LONGEST_SHOWN: usize = 60;

/// A text as a message shows it: its beginning where it is long, on one line.
pub fn shown(text: &str) -> String {
    let mut start: String = text.chars().take(LONGEST_SHOWN).flat_map(one_line).collect();
    if text.chars().nth(LONGEST_SHOWN).is_some() {
        start.push_str("...");
    }
    start
}

/// Control characters and line separators as escapes.
fn one_line(c: char) -> Vec<char> {
    if c.is_control() || matches!(c, '\u{2028}' | '\u{2029}') { c.escape_default().collect() } else { vec![c] }
}

/// Whether a text has digits or a minus of another script.
fn has_other_digits(text: &str) -> bool {
    text.chars().any(|c| c.is_numeric() && !c.is_ascii_digit() || ['\u{2212}', '\u{2013}', '\u{ff0d}'].contains(&c))
}

/// Reads an integer `-3`, a fraction `-1/2` or a decimal `-0.5`, `2.5e-3`, exactly.
///
/// # Errors
/// [`NumberError`] with the text at fault.
pub fn parse_rational(text: &str) -> Result<Rational, NumberError> {
    let text = text.trim();
    if text.len() > LONGEST {
        return Err(NumberError::TooLong);
    }
    if let Some((p, q)) = text.split_once('/') {
        let (p, q) = (parse_decimal(p, text)?, parse_decimal(q, text)?);
        if q.is_zero() {
            return Err(NumberError::ZeroDenominator(shown(text)));
        }
        return Ok(p / q);
    }
    parse_decimal(text, text)
}

fn parse_decimal(part: &str, whole: &str) -> Result<Rational, NumberError> {
    let refuse = || match has_other_digits(whole) {
        true => NumberError::OtherDigits(shown(whole)),
        false => NumberError::NotANumber(shown(whole)),
    };
    let (digits, exponent) = match part.split_once(['e', 'E']) {
        Some((digits, exponent)) => (digits, exponent.parse::<i64>().map_err(|_| refuse())?),
        None => (part, 0),
    };
    let (negative, digits) = match digits.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, digits.strip_prefix('+').unwrap_or(digits)),
    };
    let (before, after) = digits.split_once('.').unwrap_or((digits, ""));
    let all = format!("{before}{after}");
    if all.is_empty() || !all.bytes().all(|b| b.is_ascii_digit()) {
        return Err(refuse());
    }
    let shift = exponent - after.len() as i64;
    if shift.unsigned_abs() > LONGEST as u64 {
        return Err(NumberError::TooLong);
    }
    let magnitude: BigInt = all.parse().map_err(|_| refuse())?;
    let signed = if negative { -magnitude } else { magnitude };
    let power = BigInt::from(10).pow(shift.unsigned_abs());
    Ok(if shift < 0 { Rational::new(signed, power) } else { Rational::from_integer(signed * power) })
}

/// `q` to `digits` significant decimal digits, rounded down (`up = false`) or up.
///
/// Plain notation for exponents from -5 to 20, otherwise `d.ddde±x`.
pub fn decimal(q: &Rational, digits: u32, up: bool) -> String {
    if q.is_zero() {
        return "0".to_string();
    }
    let digits = digits.max(1);
    let limit = BigInt::from(10).pow(digits);
    // |q| > 2^(bits - 1): not above floor(log10 |q|).
    let bits = q.numer().bits() as i64 - q.denom().bits() as i64;
    let mut exponent = ((bits - 1) as f64 * std::f64::consts::LOG10_2 - 1e-6).floor() as i64;
    let mut scaled = loop {
        let down = round_scaled(q, i64::from(digits) - 1 - exponent, q.is_negative());
        if down.abs() < limit {
            break round_scaled(q, i64::from(digits) - 1 - exponent, up);
        }
        exponent += 1;
    };
    // Rounding may carry into one more digit.
    if scaled.abs() >= limit {
        exponent += 1;
        scaled /= 10;
    }
    layout(&scaled.abs().to_string(), exponent, scaled.is_negative())
}

/// Significant digits of a number that is printed without asking for a precision.
const USUAL_DIGITS: u32 = 20;

/// A number as intervals print their ends.
pub(super) fn significant(q: &Rational, up: bool) -> String {
    decimal(q, USUAL_DIGITS, up)
}

/// `q` with so many digits after the point, rounded down (`up = false`) or up.
pub(super) fn fixed(q: &Rational, places: usize, up: bool) -> String {
    let scaled = round_scaled(q, places as i64, up);
    let digits = format!("{:0>width$}", scaled.abs().to_string(), width = places + 1);
    let (whole, part) = digits.split_at(digits.len() - places);
    let sign = if scaled.is_negative() { "-" } else { "" };
    if places == 0 { format!("{sign}{whole}") } else { format!("{sign}{whole}.{part}") }
}

fn round_scaled(q: &Rational, shift: i64, up: bool) -> BigInt {
    let power = BigInt::from(10).pow(shift.unsigned_abs());
    let (numerator, denominator) =
        if shift >= 0 { (q.numer() * power, q.denom()) } else { (q.numer(), q.denom() * power) };
    if up { numerator.div_ceil(&denominator) } else { numerator.div_floor(&denominator) }
}

fn layout(digits: &str, exponent: i64, negative: bool) -> String {
    let sign = if negative { "-" } else { "" };
    let point = |head: &str, tail: &str| {
        let tail = tail.trim_end_matches('0');
        if tail.is_empty() { head.to_string() } else { format!("{head}.{tail}") }
    };
    match exponent {
        0..=20 => {
            let whole = exponent as usize + 1;
            let padded = format!("{digits:0<whole$}");
            format!("{sign}{}", point(&padded[..whole], &padded[whole..]))
        }
        -5..=-1 => format!("{sign}0.{}{}", "0".repeat((-exponent - 1) as usize), digits.trim_end_matches('0')),
        _ => format!("{sign}{}e{exponent}", point(&digits[..1], &digits[1..])),
    }
}
