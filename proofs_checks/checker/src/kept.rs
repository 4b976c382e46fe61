//! `kept`: a set that no motion of a switched linear system `x' = A x + B u + c` leaves, whichever mode is on, and bounds of rows in it.
//!
//! With `|x| = sqrt(x^T P x)`, `P > 0` and `-(A^T P + P A + alpha P) > 0` the rate of `|x|` is at most `beta - alpha/2 |x|`, where `beta` is at least `|c + B u|`. So `|x| <= rho` stays so
//! where `beta <= alpha rho/2`. With `P y = r` a row `r` is at most `rho sqrt(r y)` there (Cauchy and Schwarz). Norms are rounded up to multiples of `2^-96`; the rest is exact.

use crate::Refusal;
use crate::bound::ALLOWED;
use crate::matrix::Matrix;
use crate::read::{Fraction, Reader};
use crate::switching::Switching;
use crate::system::System;
use num_bigint::{BigInt, Sign};

const MOST_ROWS: usize = 200;

/// Bits after the point.
const SCALE: u64 = 96;

pub fn check(reader: &mut Reader) -> Result<String, Refusal> {
    let system = System::read(reader)?;
    let n = system.states;
    let switching = Switching::read(reader, system.modes.len())?;
    let count = reader.count("rows", 1, MOST_ROWS)?;
    let rows = reader.matrix("row", count, n)?;
    let bounds = reader.matrix("bound", 1, count)?;
    let p = reader.matrix("P", n, n)?;
    reader.require((0..n).all(|i| (0..i).all(|j| p.at(i, j) == p.at(j, i))), "the matrix is not symmetric")?;
    let positive = is_positive(reader, &p)?;
    reader.require(positive, "P is not positive definite")?;
    let (rate, radius) = (reader.fraction("rate")?, reader.fraction("radius")?);
    reader.require(rate.is_positive() && radius.is_positive(), "the rate and the radius are not positive")?;
    let y = reader.matrix("y", count, n)?;
    let [least, most] = &system.start;
    let [middle, sides] = middle(reader, least, most)?;
    let mut size = norm(reader, &p, &middle)?;
    for i in 0..n {
        let side =
            Matrix::from_fn(
                1,
                n,
                sides.denominator.clone(),
                |_, j| if j == i { sides.at(0, i).clone() } else { zero() },
            );
        size += norm(reader, &p, &side)?;
    }
    let within = size * &radius.denominator <= &radius.numerator << SCALE;
    reader.require(within, "the start is not in the set")?;
    for k in 0..system.modes.len() {
        decreases(reader, &system, k, &p, &rate)?;
        let push = push(reader, &system, k, &p)?;
        let weak = push * 2 * &rate.denominator * &radius.denominator <= (&rate.numerator * &radius.numerator) << SCALE;
        reader.require(weak, &format!("mode {} may leave the set", k + 1))?;
    }
    let turned = Matrix::from_fn(n, count, y.denominator.clone(), |i, j| y.at(j, i).clone());
    let solved = reader.times(&p, &turned)?;
    reader.pay(2 * n * count, solved.bits(), rows.bits())?;
    for i in 0..count {
        let same = (0..n).all(|j| solved.at(j, i) * &rows.denominator == rows.at(i, j) * &solved.denominator);
        reader.require(same, &format!("P y is not row {i}", i = i + 1))?;
        reader.pay(n + 8, rows.bits() + radius.numerator.bits(), y.bits() + bounds.bits())?;
        let square: BigInt = (0..n).map(|j| rows.at(i, j) * y.at(i, j)).sum();
        let bound = bounds.at(0, i);
        // rho^2 r y <= bound^2.
        let low = square * &radius.numerator * &radius.numerator * &bounds.denominator * &bounds.denominator;
        let high = bound * bound * &rows.denominator * &y.denominator * &radius.denominator * &radius.denominator;
        let stays = bound.sign() != Sign::Minus && low <= high;
        reader.require(stays, &format!("row {} is not shown to stay within its bound", i + 1))?;
    }
    let (modes, times) = match &switching {
        None => ("any measurable choice of its modes", "any time"),
        Some(Switching { until: None, .. }) => (ALLOWED, "any time"),
        Some(_) => (ALLOWED, "any time up to the last one"),
    };
    Ok(format!(
        "no motion of the system of {} linear modes and {n} states below, from a start and with inputs within their bounds and with {modes}, comes at {times} with any of \
         the {count} rows to a value above its bound",
        system.modes.len()
    ))
}

fn zero() -> BigInt {
    BigInt::from(0)
}

/// Half the sum and half the difference.
fn middle(reader: &mut Reader, least: &Matrix, most: &Matrix) -> Result<[Matrix; 2], Refusal> {
    reader.pay(4 * least.cols, least.bits(), most.bits())?;
    let twice: BigInt = &least.denominator * &most.denominator * 2;
    let ends = |j: usize| (least.at(0, j) * &most.denominator, most.at(0, j) * &least.denominator);
    let ordered = (0..least.cols).all(|j| ends(j).0 <= ends(j).1);
    reader.require(ordered, "a start or an input has no values")?;
    let part = |sign: i32| {
        Matrix::from_fn(1, least.cols, twice.clone(), |_, j| {
            let (low, high) = ends(j);
            high + low * sign
        })
    };
    Ok([part(1), part(-1)])
}

/// Whether a symmetric matrix is positive definite: its leading minors are positive (Sylvester), here by elimination without fractions.
fn is_positive(reader: &mut Reader, m: &Matrix) -> Result<bool, Refusal> {
    let n = m.rows;
    let mut rows: Vec<Vec<BigInt>> = (0..n).map(|i| m.row(i).to_vec()).collect();
    let mut before = BigInt::from(1);
    for k in 0..n {
        let pivot = rows[k][k].clone();
        if pivot.sign() != Sign::Plus {
            return Ok(false);
        }
        let longest = rows.iter().map(crate::budget::bits).max().unwrap_or(0);
        reader.pay(3 * (n - k) * (n - k), longest, longest)?;
        let own = rows[k].clone();
        for row in &mut rows[k + 1..] {
            let factor = row[k].clone();
            for (x, y) in row.iter_mut().zip(&own).skip(k) {
                *x = (&*x * &pivot - &factor * y) / &before;
            }
        }
        before = pivot;
    }
    Ok(true)
}

/// Refuses unless `-(A^T P + P A + alpha P) > 0`.
fn decreases(reader: &mut Reader, system: &System, k: usize, p: &Matrix, rate: &Fraction) -> Result<(), Refusal> {
    let a = &system.modes[k].a;
    let product = reader.times(p, a)?;
    reader.pay(
        4 * product.entries.len(),
        product.bits() + a.bits(),
        rate.numerator.bits() + rate.denominator.bits(),
    )?;
    let change = Matrix::from_fn(p.rows, p.cols, BigInt::from(1), |i, j| {
        -((product.at(i, j) + product.at(j, i)) * &rate.denominator + p.at(i, j) * &rate.numerator * &a.denominator)
    });
    let positive = is_positive(reader, &change)?;
    reader.require(positive, &format!("the norm does not decrease in mode {}", k + 1))
}

/// A bound of the norm of `c + B u`, over `2^SCALE`.
fn push(reader: &mut Reader, system: &System, k: usize, p: &Matrix) -> Result<BigInt, Refusal> {
    let mode = &system.modes[k];
    let (Some(b), Some([least, most])) = (&mode.b, &system.limits) else { return norm(reader, p, &mode.c) };
    let [middle, sides] = middle(reader, least, most)?;
    let turned = Matrix::from_fn(b.cols, b.rows, b.denominator.clone(), |i, j| -b.at(j, i));
    let pushed = reader.times(&middle, &turned)?;
    reader.pay(2 * b.rows, pushed.bits(), mode.c.bits())?;
    let mut sum = norm(reader, p, &mode.c.minus(&pushed))?;
    for j in 0..b.cols {
        reader.pay(b.rows, b.bits(), sides.bits())?;
        let denominator = &b.denominator * &sides.denominator;
        let column = Matrix::from_fn(1, b.rows, denominator, |_, i| b.at(i, j) * sides.at(0, j));
        sum += norm(reader, p, &column)?;
    }
    Ok(sum)
}

/// A bound of `sqrt(v^T P v)` for a row `v`, over `2^SCALE`.
fn norm(reader: &mut Reader, p: &Matrix, v: &Matrix) -> Result<BigInt, Refusal> {
    let moved = reader.times(v, p)?;
    reader.pay(v.cols, moved.bits(), v.bits())?;
    let square: BigInt = moved.entries.iter().zip(&v.entries).map(|(x, y)| x * y).sum();
    let denominator = moved.denominator * &v.denominator;
    reader.pay(4, square.bits() + 2 * SCALE, square.bits() + denominator.bits())?;
    let scaled: BigInt = (square << (2 * SCALE)) / denominator + 1;
    Ok(scaled.sqrt() + 1)
}
