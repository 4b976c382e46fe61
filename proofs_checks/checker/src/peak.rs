//! `peak`: the main resonance of the two-sided platoon.
//!
//! Followers 1 .. M with `gamma a_k = (a_(k-1) + a_(k+1))/2`, `gamma a_M = a_(M-1)`, `a_0 = 1`, where
//! `gamma = 1 + w²/z`, `z = f + i w g`. Backwards from the last car, `t_k = z^k a_(M-k)/a_M` is a polynomial:
//! `t_0 = 1`, `t_1 = z + w²`, `t_(k+1) = 2 (z + w²) t_k - z² t_(k-1)`. So `|a_M|² = Q^M/N` with `N = |t_M|²`,
//! `Q = |z|² = f² + g² s`, both polynomials in `s = w²`.

use crate::Refusal;
use crate::budget::bits;
use crate::read::{Fraction, Reader};
use num_bigint::{BigInt, Sign};

const MOST_FOLLOWERS: usize = 96;
const DEEPEST: usize = 256;

/// Coefficients, the constant one first.
type Polynomial = Vec<BigInt>;

pub fn check(reader: &mut Reader) -> Result<String, Refusal> {
    let followers = reader.count("followers", 1, MOST_FOLLOWERS)?;
    let (f, g) = (reader.fraction("f")?, reader.fraction("g")?);
    let negative = |x: &Fraction| x.numerator.sign() == Sign::Minus;
    reader.require(negative(&f) && negative(&g), "the gains are not negative")?;
    let (low, high) = reader.range("frequency")?;
    reader.require(low.is_positive(), "the frequency is not positive")?;
    let at = reader.fraction("at")?;
    reader.require(low.is_less_than(&at) && at.is_less_than(&high), "the frequency is not between the ends")?;
    let (least, most) = reader.range("amplitude")?;
    reader.require(least.is_positive(), "the amplitude is not positive")?;

    let (n, q) = response(reader, followers, &f, &g)?;
    let mut q_power = vec![BigInt::from(1)];
    for _ in 0..followers {
        q_power = times(reader, &q_power, &q)?;
    }
    // The sign of d(N/Q^M)/ds is that of N' Q - M Q' N.
    let derivative: Polynomial = n.iter().enumerate().skip(1).map(|(k, c)| c * k).collect();
    let falling = times(reader, &derivative, &q)?;
    let slope = minus(falling, n.iter().map(|c| c * &q[1] * followers));
    let ends = (sign_at(reader, &slope, &low)?, sign_at(reader, &slope, &high)?);
    reader.require(ends.0 == Sign::Minus, "the amplitude does not grow at the lower end")?;
    reader.require(ends.1 == Sign::Plus, "the amplitude does not fall at the upper end")?;

    // N A² - Q^M has the sign of A² - |a_M|².
    let above = |amplitude: &Fraction| -> Polynomial {
        let (p, q) = (&amplitude.numerator * &amplitude.numerator, &amplitude.denominator * &amplitude.denominator);
        minus(n.iter().map(|c| c * &p).collect(), q_power.iter().map(|c| c * &q))
    };
    let (above_least, above_most) = (above(&least), above(&most));
    let reached = sign_at(reader, &above_least, &at)? != Sign::Plus;
    reader.require(reached, "the lower amplitude is not reached at that frequency")?;
    let parts = [
        ("lower", "below the lower end", scaled(reader, &above_least, &low)?),
        ("lower", "above the upper end", reversed(scaled(reader, &above_least, &high)?)),
        ("upper", "up to the upper end", scaled(reader, &above_most, &high)?),
        ("upper", "above the upper end", reversed(scaled(reader, &above_most, &high)?)),
    ];
    for (amplitude, place, part) in parts {
        let positive = is_positive_on_unit(reader, part)?;
        reader.require(positive, &format!("the amplitude is not shown to stay under the {amplitude} one {place}"))?;
    }
    Ok(format!(
        "of all frequencies w > 0 the last of the {followers} followers of the two-sided platoon with f = {} and g = {} has its \
         largest amplitude only between w = {} and w = {}, and that amplitude lies between {} and {}",
        f.text, g.text, low.text, high.text, least.text, most.text
    ))
}

/// `N` and `Q` times the same positive power: integers, with `f` and `g` over one denominator `d`.
fn response(
    reader: &mut Reader,
    followers: usize,
    f: &Fraction,
    g: &Fraction,
) -> Result<(Polynomial, Polynomial), Refusal> {
    let d = &f.denominator * &g.denominator;
    let (f, g) = (&f.numerator * &g.denominator, &g.numerator * &f.denominator);
    // Numbers a + b i w, where (i w)² = -s.
    let u = (vec![&f * 2, &d * 2], vec![&g * 2]);
    let square = (vec![&f * &f, -(&g * &g)], vec![&f * &g * 2]);
    let mut before = (vec![BigInt::from(1)], Vec::new());
    let mut last = (vec![f.clone(), d], vec![g.clone()]);
    for _ in 1..followers {
        let (next, lost) = (product(reader, &u, &last)?, product(reader, &square, &before)?);
        before = std::mem::replace(&mut last, (minus(next.0, lost.0), minus(next.1, lost.1)));
    }
    let (re, im) = (times(reader, &last.0, &last.0)?, times(reader, &last.1, &last.1)?);
    Ok((minus(re, shifted_up(&im).into_iter().map(|c| -c)), vec![&f * &f, &g * &g]))
}

type Pair = (Polynomial, Polynomial);

fn product(reader: &mut Reader, x: &Pair, y: &Pair) -> Result<Pair, Refusal> {
    let (real, imaginary) = (times(reader, &x.0, &y.0)?, times(reader, &x.1, &y.1)?);
    let (left, right) = (times(reader, &x.0, &y.1)?, times(reader, &x.1, &y.0)?);
    Ok((minus(real, shifted_up(&imaginary)), minus(left, right.into_iter().map(|c| -c))))
}

/// Times `s`.
fn shifted_up(p: &Polynomial) -> Polynomial {
    std::iter::once(BigInt::ZERO).chain(p.iter().cloned()).collect()
}

fn minus(mut p: Polynomial, q: impl IntoIterator<Item = BigInt>) -> Polynomial {
    for (k, c) in q.into_iter().enumerate() {
        match p.get_mut(k) {
            Some(x) => *x -= c,
            None => p.push(-c),
        }
    }
    p
}

fn times(reader: &mut Reader, p: &Polynomial, q: &Polynomial) -> Result<Polynomial, Refusal> {
    reader.pay(p.len() * q.len(), bits(p), bits(q))?;
    let mut product = vec![BigInt::ZERO; (p.len() + q.len()).saturating_sub(1)];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            product[i + j] += a * b;
        }
    }
    Ok(product)
}

/// The sign at `s = w²`.
fn sign_at(reader: &mut Reader, p: &Polynomial, w: &Fraction) -> Result<Sign, Refusal> {
    Ok(scaled(reader, p, w)?.iter().sum::<BigInt>().sign())
}

/// A positive multiple of `p(w² x)`.
fn scaled(reader: &mut Reader, p: &Polynomial, w: &Fraction) -> Result<Polynomial, Refusal> {
    let (u, v) = (&w.numerator * &w.numerator, &w.denominator * &w.denominator);
    let longest = u.bits().max(v.bits()) * p.len() as u64;
    reader.pay(4 * p.len(), longest, bits(p).max(longest))?;
    let mut result = p.clone();
    let mut power = BigInt::from(1);
    for c in &mut result {
        *c *= &power;
        power *= &u;
    }
    power = BigInt::from(1);
    for c in result.iter_mut().rev() {
        *c *= &power;
        power *= &v;
    }
    Ok(result)
}

/// `x^n p(1/x)`.
fn reversed(mut p: Polynomial) -> Polynomial {
    p.reverse();
    p
}

/// `p(x + 1)`.
fn shifted(reader: &mut Reader, mut p: Polynomial) -> Result<Polynomial, Refusal> {
    reader.pay(p.len() * p.len() / 2 + 1, bits(&p), 0)?;
    for i in 0..p.len() {
        for k in (i..p.len() - 1).rev() {
            let (low, high) = p.split_at_mut(k + 1);
            low[k] += &high[0];
        }
    }
    Ok(p)
}

/// Whether `p > 0` on `[0, 1]`, by Descartes' rule of signs and halving; false where that is not shown.
fn is_positive_on_unit(reader: &mut Reader, p: Polynomial) -> Result<bool, Refusal> {
    let is_positive = |x: &BigInt| x.sign() == Sign::Plus;
    let positive_at_ends = |p: &Polynomial| p.first().is_some_and(is_positive) && is_positive(&p.iter().sum());
    let mut parts = vec![(p, 0)];
    while let Some((p, depth)) = parts.pop() {
        if !positive_at_ends(&p) || depth > DEEPEST {
            return Ok(false);
        }
        // x -> 1/(1 + x) maps (0, infinity) to (0, 1).
        let seen = shifted(reader, reversed(p.clone()))?;
        if seen.iter().all(|c| c.sign() != Sign::Minus) {
            continue;
        }
        let mut left = p;
        let degree = left.len() - 1;
        reader.pay(left.len(), bits(&left) + degree as u64, 64)?;
        left.iter_mut().enumerate().for_each(|(k, c)| *c <<= degree - k);
        parts.push((shifted(reader, left.clone())?, depth + 1));
        parts.push((left, depth + 1));
    }
    Ok(true)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_positive(coefficients: &[i64]) -> bool {
        let mut reader = Reader::new(b"\n", 1 << 31).unwrap();
        is_positive_on_unit(&mut reader, coefficients.iter().map(|c| BigInt::from(*c)).collect()).unwrap()
    }

    #[test]
    fn zeros_at_ends_and_at_halves_and_double_ones_are_seen() {
        // 2 - x, and (10x - 3)² + 1, which has to be halved.
        assert!(is_positive(&[2, -1]) && is_positive(&[10, -60, 100]));
        // x, 1 - x, (2x - 1)², (3x - 1)², 1 - 3x + 3x² - 2x³.
        for p in [&[0, 1][..], &[1, -1], &[1, -4, 4], &[1, -6, 9], &[1, -3, 3, -2]] {
            assert!(!is_positive(p), "{p:?}");
        }
    }
}
