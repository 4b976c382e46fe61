//! `motion`: a motion of a switched linear system `x' = A x + B u + c` with constant inputs on stretches, and how far it comes.
//!
//! Numbers are integers over `2^S` with a bound `E` of their errors, in the same unit. On each stretch `y = (x, 1)` obeys `y' = M y`; steps have
//! `|M| h <= 1/2` in the norm of absolute row sums, so that a term of the exponential series is at most half the one before, errors grow by less than
//! `e^(1/2) < 33/20`, and each rounded term is off by less than 2.

use crate::Refusal;
use crate::budget::bits;
use crate::matrix::Matrix;
use crate::read::Reader;
use crate::switching::{Switching, Time};
use crate::system::System;
use num_bigint::BigInt;

const MOST_STEPS: usize = 5000;
const MOST_TERMS: usize = 5000;

/// A stretch: the matrix `M` over one denominator, how long it lasts as a fraction, and in how many steps.
pub struct Stretch {
    pub m: Matrix,
    pub time: (BigInt, BigInt),
    pub steps: usize,
}

pub fn check(reader: &mut Reader) -> Result<String, Refusal> {
    let system = System::read(reader)?;
    let (n, modes) = (system.states, system.modes.len());
    let switching = Switching::read(reader, modes)?;
    let row = reader.matrix("row", 1, n)?;
    let bound = reader.fraction("bound")?;
    let x = reader.matrix("start", 1, n)?;
    within(reader, &x, &system.start, "the start is not within its bounds")?;
    let (stretches, order) = stretches(reader, &system)?;
    if let Some(switching) = &switching {
        switching.follow(reader, &order)?;
    }
    let steps: usize = stretches.iter().map(|stretch| stretch.steps).sum();
    reader.require(steps <= MOST_STEPS, "the motion takes too many steps")?;
    let scale = 192 + steps as u64;
    let mut y: Vec<BigInt> = x.entries.iter().map(|entry| (entry << scale) / &x.denominator).collect();
    y.push(BigInt::from(1) << scale);
    let mut error = BigInt::from(1);
    for stretch in &stretches {
        for _ in 0..stretch.steps {
            step(reader, stretch, &mut y, &mut error)?;
        }
    }
    // row y > bound, with the error against it.
    let value: BigInt = row.entries.iter().zip(&y).map(|(c, y)| c * y).sum();
    let size = row.entries.iter().map(|c| BigInt::from(c.magnitude().clone())).sum::<BigInt>() * error;
    let reached = (value - size) * &bound.denominator > ((&bound.numerator * &row.denominator) << scale);
    reader.require(reached, "the motion does not come beyond the bound")?;
    let allowed = if switching.is_some() { ", as the switching below allows" } else { "" };
    Ok(format!(
        "a motion of the system of {modes} linear modes and {n} states below, from its start, with its inputs within their bounds and its modes for the times \
         below{allowed}, ends with row x > {}",
        bound.text
    ))
}

/// The same matrix.
fn copy(matrix: &Matrix) -> Matrix {
    Matrix { entries: matrix.entries.clone(), denominator: matrix.denominator.clone(), ..*matrix }
}

fn within(reader: &mut Reader, x: &Matrix, [least, most]: &[Matrix; 2], reason: &str) -> Result<(), Refusal> {
    reader.pay(4 * x.cols, x.bits(), least.bits().max(most.bits()))?;
    let ordered =
        |a: &Matrix, b: &Matrix| (0..a.cols).all(|j| a.at(0, j) * &b.denominator <= b.at(0, j) * &a.denominator);
    reader.require(ordered(least, x) && ordered(x, most), reason)
}

/// What follows each other, with the modes and their times.
type Followed = (Vec<Stretch>, Vec<(usize, Time)>);

fn stretches(reader: &mut Reader, system: &System) -> Result<Followed, Refusal> {
    let count = reader.count("stretches", 1, MOST_STEPS)?;
    let (mut stretches, mut order, mut first): (Vec<Stretch>, Vec<(usize, Time)>, Option<Matrix>) =
        (Vec::new(), Vec::new(), None);
    for _ in 0..count {
        let index = reader.count("mode", 1, system.modes.len())? - 1;
        let mode = &system.modes[index];
        let time = reader.fraction("time")?;
        reader.require(time.is_positive(), "a time is not positive")?;
        order.push((index, Time { numerator: time.numerator.clone(), denominator: time.denominator.clone() }));
        let mut force = copy(&mode.c);
        if let (Some(limits), Some(b)) = (&system.limits, &mode.b) {
            let u = reader.matrix("u", 1, system.kept.len())?;
            within(reader, &u, limits, "an input is not within its bounds")?;
            let before = first.get_or_insert_with(|| copy(&u));
            let same = |j: usize| u.at(0, j) * &before.denominator == before.at(0, j) * &u.denominator;
            let constant = (0..system.kept.len()).all(|j| !system.is_kept(j) || same(j));
            reader.require(constant, "a constant input changes")?;
            let transposed = Matrix::from_fn(b.cols, b.rows, b.denominator.clone(), |i, j| b.at(j, i).clone());
            let pushed = reader.times(&u, &transposed)?;
            force = force.minus(&Matrix::from_fn(1, b.rows, pushed.denominator.clone(), |_, j| -pushed.at(0, j)));
        }
        let n = mode.a.rows;
        reader.pay(2 * n * (n + 1), mode.a.bits(), force.bits())?;
        // M = (A, force; 0, 0).
        let m = Matrix::from_fn(n + 1, n + 1, &mode.a.denominator * &force.denominator, |i, j| match (i < n, j < n) {
            (true, true) => mode.a.at(i, j) * &force.denominator,
            (true, false) => force.at(0, i) * &mode.a.denominator,
            _ => BigInt::from(0),
        });
        let size = |i: usize| m.row(i).iter().map(|x| BigInt::from(x.magnitude().clone())).sum::<BigInt>();
        let norm = (0..=n).map(size).max().unwrap_or_default();
        // Steps so that |M| h <= 1/2.
        let steps = norm * 2 * &time.numerator / (&m.denominator * &time.denominator) + 1;
        let steps = usize::try_from(&steps).ok().filter(|steps| *steps <= MOST_STEPS);
        let Some(steps) = steps else { return Err(reader.refusal("a stretch takes too many steps")) };
        stretches.push(Stretch { m, time: (time.numerator, time.denominator), steps });
    }
    Ok((stretches, order))
}

/// One step of the exponential series, where `|M| time <= steps/2`.
pub fn step(reader: &mut Reader, stretch: &Stretch, y: &mut [BigInt], error: &mut BigInt) -> Result<(), Refusal> {
    let (m, order) = (&stretch.m, y.len());
    let divisor = &m.denominator * &stretch.time.1 * stretch.steps;
    let mut term = y.to_vec();
    for k in 1..=MOST_TERMS {
        reader.pay(order * order + 2 * order, bits(&term), m.bits() + divisor.bits())?;
        let over = &divisor * k;
        let product = |i: usize| m.row(i).iter().zip(&term).map(|(a, t)| a * t).sum::<BigInt>();
        term = (0..order).map(|i| product(i) * &stretch.time.0 / &over).collect();
        y.iter_mut().zip(&term).for_each(|(y, t)| *y += t);
        if term.iter().all(|t| t.bits() <= 1) {
            // Rounding of k terms, the terms that are left out, and what was there before.
            *error = &*error * 33 / 20 + 1 + 2 * k + 4;
            return Ok(());
        }
    }
    Err(reader.refusal("the series does not end"))
}
