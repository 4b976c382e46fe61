//! An input, a start and an order of modes that attain a value, and that value computed forwards in time, apart from the search that found them.

use crate::flow::Flows;
use crate::prepared::Prepared;
use crate::scalar::{Matrix, apply, times};
use crate::system::{Range, System};
use crate::walk::{Leg, trace};
use arithmetic::{Enclosure, Field, FloatInterval, Interval, Rational, Ring, rational};
use num_traits::{Signed, Zero};

/// A motion of the system. Times are from the start.
#[derive(Debug, Clone, PartialEq)]
pub struct Witness {
    /// When it is looked at.
    pub at: Rational,
    /// The states at time 0.
    pub start: Vec<Rational>,
    /// From when each mode is on, by its index.
    pub modes: Vec<(Rational, usize)>,
    /// For each input of the system, from when it has which value.
    pub inputs: Vec<Vec<(Rational, Rational)>>,
    /// For each condition's left side: between these.
    pub value: Range,
}

/// Decimals of the instants at which inputs of a witness change.
const DECIMALS: u32 = 12;

/// The bang-bang input that is worst for a row along an order of modes, with its value.
pub(crate) fn attaining(
    system: &System,
    prepared: &Prepared,
    flows: &Flows<FloatInterval>,
    row: &[Rational],
    legs: &[(usize, Rational)],
) -> Witness {
    let legs: Vec<(usize, Rational)> = legs.iter().filter(|(_, duration)| !duration.is_zero()).cloned().collect();
    let walk: Vec<Leg> = legs.iter().map(Leg::fixed).collect();
    let floats: Vec<FloatInterval> = row.iter().map(FloatInterval::from_rational).collect();
    let (stretches, corner) = trace(flows, &floats, &walk, &prepared.start);
    let at: Rational = legs.iter().map(|(_, duration)| duration.clone()).sum();
    let mut inputs: Vec<Vec<(Rational, Rational)>> = Vec::new();
    let mut constants = corner[system.states.len()..].iter();
    for (j, input) in system.inputs.iter().enumerate() {
        if input.constant {
            inputs.push(vec![(Rational::ZERO, constants.next().cloned().unwrap_or_else(|| input.range.lo.clone()))]);
            continue;
        }
        let mut values: Vec<(Rational, Rational)> = Vec::new();
        // Backwards stretches, forwards in time.
        for stretch in stretches.iter().rev().filter(|stretch| stretch.input == j) {
            let from = rounded(&(&at - &stretch.to)).max(Rational::ZERO);
            let value = if stretch.positive { input.range.hi.clone() } else { input.range.lo.clone() };
            if values.last().is_none_or(|(_, last)| *last != value) {
                values.push((from, value));
            }
        }
        match values.first_mut() {
            Some(first) => first.0 = Rational::ZERO,
            None => values.push((Rational::ZERO, input.range.lo.clone())),
        }
        inputs.push(values);
    }
    let mut modes = Vec::new();
    let mut time = Rational::ZERO;
    for (mode, duration) in legs.iter().rev() {
        modes.push((time.clone(), *mode));
        time += duration;
    }
    let start = corner[..system.states.len()].to_vec();
    Witness { at, start, modes, inputs, value: Range::point(Rational::ZERO) }
}

/// To the decimals that are shown.
fn rounded(time: &Rational) -> Rational {
    let unit = rational(10, 1).power(u64::from(DECIMALS));
    (time * &unit + rational(1, 2)).floor() / unit
}

impl Witness {
    /// Encloses the states at its time: on each stretch of constant input the motion is one matrix exponential.
    pub fn states(&self, system: &System, bits: u32) -> Vec<Interval> {
        let zero = Interval::from_rational(&Rational::ZERO, bits);
        let mut state: Vec<Interval> = self.start.iter().map(|x| zero.rational(x)).chain([zero.one()]).collect();
        for (mode, time, inputs) in self.stretches() {
            let mode = &system.modes[mode];
            let forcing = |i: usize| &mode.c[i] + mode.b[i].iter().zip(&inputs).map(|(b, u)| b * u).sum::<Rational>();
            let n = system.states.len();
            let mut rows: Vec<Vec<Rational>> =
                (0..n).map(|i| mode.a[i].iter().cloned().chain([forcing(i)]).collect()).collect();
            rows.push(vec![Rational::ZERO; n + 1]);
            state = apply(&exponential(&rows, &time, &zero), &state);
        }
        state.truncate(self.start.len());
        state
    }

    /// Stretches of one mode and constant inputs: the mode, how long it lasts, the values of the inputs.
    pub fn stretches(&self) -> Vec<(usize, Rational, Vec<Rational>)> {
        let mut instants: Vec<&Rational> = self.modes.iter().map(|(time, _)| time).collect();
        instants.extend(self.inputs.iter().flatten().map(|(time, _)| time));
        instants.retain(|time| **time < self.at);
        instants.sort();
        instants.dedup();
        let ends = instants.iter().skip(1).copied().chain([&self.at]);
        let stretch = |(from, to): (&&Rational, &Rational)| {
            let mode = latest(&self.modes, from).copied().unwrap_or_default();
            let inputs = self.inputs.iter().map(|input| latest(input, from).cloned().unwrap_or_default());
            (mode, to - *from, inputs.collect())
        };
        instants.iter().zip(ends).map(stretch).collect()
    }

    /// Encloses the value of a row at its time.
    pub fn value_of(&self, system: &System, row: &[Rational], bits: u32) -> Interval {
        let zero = Interval::from_rational(&Rational::ZERO, bits);
        self.states(system, bits).into_iter().zip(row).fold(zero.clone(), |sum, (x, c)| sum + x * zero.rational(c))
    }
}

/// What holds from the last instant that is not after a time.
fn latest<'a, V>(list: &'a [(Rational, V)], time: &Rational) -> Option<&'a V> {
    list.iter().rev().find(|(from, _)| from <= time).map(|(_, value)| value)
}

/// `e^(A t)` by scaling, a Taylor sum with its remainder, and squaring.
fn exponential(rows: &[Vec<Rational>], time: &Rational, zero: &Interval) -> Matrix<Interval> {
    let n = rows.len();
    let norm = rows.iter().map(|row| row.iter().map(|x| x.abs()).sum::<Rational>()).max().unwrap_or_default() * time;
    let (mut squarings, mut scale) = (0, time.clone());
    let mut size = norm;
    while size > rational(1, 2) {
        size *= rational(1, 2);
        scale *= rational(1, 2);
        squarings += 1;
    }
    let scaled: Matrix<Interval> =
        rows.iter().map(|row| row.iter().map(|x| zero.rational(&(x * &scale))).collect()).collect();
    let mut sum: Matrix<Interval> = (0..n).map(|i| (0..n).map(|j| zero.integer(i64::from(i == j))).collect()).collect();
    let mut term = sum.clone();
    // Where nothing moves, everything stays exactly what it is.
    if squarings == 0 && size.is_zero() {
        return sum;
    }
    // The rest after order k is below twice the next term, at norm 1/2: 2^-k / k!.
    let mut rest = Rational::ONE;
    let smallest = rational(1, 2).power(u64::from(zero.precision()));
    for k in 1.. {
        rest *= rational(1, 2 * k);
        if rest < smallest {
            break;
        }
        term = times(&term, &scaled)
            .into_iter()
            .map(|row| row.into_iter().map(|x| x * zero.ratio(1, k)).collect())
            .collect();
        for (row, added) in sum.iter_mut().zip(&term) {
            row.iter_mut().zip(added).for_each(|(x, y)| *x = x.clone() + y);
        }
    }
    let rest = rest * rational(2, 1);
    let around = zero.around(&-rest.clone(), &rest);
    sum.iter_mut().flatten().for_each(|x| *x = x.clone() + &around);
    for _ in 0..squarings {
        sum = times(&sum, &sum);
    }
    sum
}
