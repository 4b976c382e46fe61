//! `sos`: a polynomial that is not negative where others are not, because a positive multiple of it is a sum of squares times products of these.

use crate::Refusal;
use crate::read::Reader;
use crate::statement;
use num_bigint::{BigInt, Sign};
use std::collections::BTreeMap;

const MOST_VARIABLES: usize = 16;
const MOST_POLYNOMIALS: usize = 200;
const MOST_SQUARES: usize = 1000;
const MOST_EXPONENT: usize = 100;

/// Exponents with integer coefficients, none of them 0.
pub type Polynomial = BTreeMap<Vec<usize>, BigInt>;

pub fn check(reader: &mut Reader) -> Result<String, Refusal> {
    let says = reader.value_if_any("says");
    let n = reader.count("variables", 1, MOST_VARIABLES)?;
    let constraints = list(reader, "constraints", "constraint", n)?;
    let equalities = list(reader, "equalities", "equality", n)?;
    let words = reader.value("goal")?;
    let goal = polynomial(reader, words, n)?;
    let relation = reader.value("relation")?;
    reader.require(relation == ">=" || relation == ">", "a relation >= or > is expected")?;
    // A positive constant and squares: above 0 everywhere.
    let (multiplier, positive) = squares(reader, "multiplier", n)?;
    reader.require(positive, "no square of the multiplier is a positive constant")?;
    let mut rest = times(reader, &multiplier, &goal)?;
    let mut strict = false;
    for _ in 0..reader.count("terms", 0, MOST_POLYNOMIALS * MOST_POLYNOMIALS)? {
        let factors = reader.value("factors")?;
        let mut product = Polynomial::from([(vec![0; n], BigInt::from(1))]);
        for word in factors.split(' ').filter(|_| factors != "none") {
            let k = reader.count_of(word, 1, constraints.len().max(1))? - 1;
            reader.require(k < constraints.len(), "there is no such constraint")?;
            product = times(reader, &product, &constraints[k])?;
        }
        let (sum, positive) = squares(reader, "squares", n)?;
        strict |= positive && factors == "none";
        let term = times(reader, &product, &sum)?;
        subtract(&mut rest, term);
    }
    for equality in &equalities {
        let words = reader.value("cofactor")?;
        let cofactor = polynomial(reader, words, n)?;
        let term = times(reader, &cofactor, equality)?;
        subtract(&mut rest, term);
    }
    reader.require(rest.is_empty(), "the two sides of the identity are not the same polynomial")?;
    reader.require(strict || relation == ">=", "no positive constant is left, so that the goal may be 0")?;
    if let Some(text) = says {
        reader.require(equalities.is_empty(), "a statement has no equalities")?;
        statement::check(reader, text, n, &constraints, (&goal, relation))?;
        return Ok(text.to_string());
    }
    let names: Vec<String> = (1..=n).map(|k| format!("x{k}")).collect();
    let above = constraints.iter().map(|p| format!("{} >= 0", shown(p)));
    let assumed: Vec<String> = above.chain(equalities.iter().map(|p| format!("{} = 0", shown(p)))).collect();
    let condition = if assumed.is_empty() { String::new() } else { format!(" with {}", assumed.join(", ")) };
    Ok(format!("for all real {}{condition}: {} {relation} 0", names.join(", "), shown(&goal)))
}

fn list(reader: &mut Reader, name: &str, own: &str, n: usize) -> Result<Vec<Polynomial>, Refusal> {
    let count = reader.count(name, 0, MOST_POLYNOMIALS)?;
    let one = |_| {
        let words = reader.value(own)?;
        polynomial(reader, words, n)
    };
    (0..count).map(one).collect()
}

/// `zero`, or terms `c,e1,..,en` in the order of their exponents.
fn polynomial(reader: &Reader, text: &str, n: usize) -> Result<Polynomial, Refusal> {
    let mut found = Polynomial::new();
    if text == "zero" {
        return Ok(found);
    }
    for word in text.split(' ') {
        let mut parts = word.split(',');
        let coefficient = reader.integer(parts.next().unwrap_or(""))?;
        reader.require(coefficient.sign() != Sign::NoSign, "a coefficient is 0")?;
        let exponents =
            parts.map(|part| reader.count_of(part, 0, MOST_EXPONENT)).collect::<Result<Vec<usize>, Refusal>>()?;
        reader.require(exponents.len() == n, "a term has not one exponent for each variable")?;
        let in_order = found.last_key_value().is_none_or(|(last, _)| *last < exponents);
        reader.require(in_order, "the terms are not in the order of their exponents")?;
        found.insert(exponents, coefficient);
    }
    Ok(found)
}

/// The sum of weighted squares, with weights that are not negative; whether the square of a constant is among them.
fn squares(reader: &mut Reader, name: &str, n: usize) -> Result<(Polynomial, bool), Refusal> {
    let (mut sum, mut positive) = (Polynomial::new(), false);
    for _ in 0..reader.count(name, 0, MOST_SQUARES)? {
        let line = reader.value("square")?;
        let (weight, words) = line.split_once(' ').ok_or_else(|| reader.refusal("a weight and terms are expected"))?;
        let weight = reader.integer(weight)?;
        reader.require(weight.sign() != Sign::Minus, "a weight is negative")?;
        let root = polynomial(reader, words, n)?;
        // A root and its negative have the same square: one of them is written.
        let first = root.first_key_value().is_none_or(|(_, c)| c.sign() == Sign::Plus);
        reader.require(first, "the first coefficient of a root is negative")?;
        positive |= weight.sign() == Sign::Plus && root.len() == 1 && root.keys().all(|e| e.iter().all(|e| *e == 0));
        let weighted = times(reader, &root, &Polynomial::from([(vec![0; n], weight)]))?;
        let square = times(reader, &weighted, &root)?;
        square.into_iter().for_each(|(exponents, c)| add(&mut sum, exponents, c));
    }
    Ok((sum, positive))
}

pub fn add(sum: &mut Polynomial, exponents: Vec<usize>, c: BigInt) {
    let total = sum.remove(&exponents).unwrap_or_default() + c;
    if total.sign() != Sign::NoSign {
        sum.insert(exponents, total);
    }
}

fn subtract(rest: &mut Polynomial, term: Polynomial) {
    term.into_iter().for_each(|(exponents, c)| add(rest, exponents, -c));
}

pub fn times(reader: &mut Reader, a: &Polynomial, b: &Polynomial) -> Result<Polynomial, Refusal> {
    reader.pay(
        (a.len() * b.len()).saturating_mul(8) + 1,
        crate::budget::bits(a.values()),
        crate::budget::bits(b.values()),
    )?;
    let mut product = Polynomial::new();
    for (first, c) in a {
        for (second, d) in b {
            add(&mut product, first.iter().zip(second).map(|(x, y)| x + y).collect(), c * d);
        }
    }
    Ok(product)
}

/// From the last exponents to the first, as `2*x1^2*x2 - 1`.
fn shown(p: &Polynomial) -> String {
    let mut text = String::new();
    for (exponents, c) in p.iter().rev() {
        let power = |(k, e): (usize, &usize)| if *e == 1 { format!("x{}", k + 1) } else { format!("x{}^{e}", k + 1) };
        let powers: Vec<String> = exponents.iter().enumerate().filter(|(_, e)| **e > 0).map(power).collect();
        let negative = c.sign() == Sign::Minus;
        text += match (text.is_empty(), negative) {
            (true, true) => "-",
            (true, false) => "",
            (false, true) => " - ",
            (false, false) => " + ",
        };
        let size = c.magnitude().to_string();
        text += &match (size == "1", powers.is_empty()) {
            (_, true) => size,
            (true, false) => powers.join("*"),
            (false, false) => format!("{size}*{}", powers.join("*")),
        };
    }
    if text.is_empty() { "0".to_string() } else { text }
}
