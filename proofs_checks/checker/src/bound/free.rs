//! Switches at free instants: within windows, or after any duration that dwell times allow.
//!
//! Backwards from the time that is looked at, a row `p` of the state at the end of a piece of time becomes rows of the state at its beginning, one for each node at which the switch in it may be.
//! Between nodes, with what comes later at nodes already, what comes earlier at any instants, and the state `x` before the piece, `q` being the row where the switch is:
//! a duration moves `q e^(A s) x` and the integral over it, whose second derivative is at least `-(|q A^2 x| + sum |q A b|)`; an instant in a window, from mode `A` to mode `B`, at least
//! `-(|q C x| + sum over the columns a of the first mode (|q B a| + |q (A - B) a|) + sum over those of the second |q B b|)` with `C = A^2 - 2 B A + B^2`. Corners, where the sign of an integrand changes, are
//! convex. So between nodes at a distance `h` the value is at most the larger of two plus `h^2/8` times that.
//!
//! The states are in the box `|x_i| <= X_i` that the file gives: let `k X` with `k > 1` be the smallest multiple of it that they do not leave up to some time. What is computed is at most `k` times as much
//! with `k X` for `X`, and it is below `X`, so that they would be below `k X`: there is no such `k`. For the same reason what lies further back than one likes may be replaced by the box.
//!
//! Where a duration and a time are free together, as in the piece that is looked at, the time is moved first, to a node or to the switch.

use super::{
    Ever, Flow, SCALE, Square, Sum, Vector, augmented, fixed, grown, row_of, shift, size, start, started, unit, up,
};
use crate::Refusal;
use crate::matrix::Matrix;
use crate::read::Reader;
use crate::switching::{Rule, Stay, Switching, Time};
use crate::system::System;
use num_bigint::BigInt;

const MOST_LEGS: usize = 30;

/// A flow with its powers at each node, and how far it bends between nodes.
struct Leg {
    flow: Flow,
    powers: Vec<Square>,
    bend: Bend,
}

/// A bound of how much a value exceeds what it is at nodes.
struct Bend {
    a: Matrix,
    curve: Matrix,
    columns: Vec<Matrix>,
    states: Vec<BigInt>,
    /// The most that it is for a unit row.
    most: BigInt,
    length: (BigInt, BigInt),
}

/// The matrix of a mode and its columns, `d` first.
struct Mode {
    a: Matrix,
    columns: Vec<Matrix>,
}

fn copy(m: &Matrix) -> Matrix {
    Matrix { entries: m.entries.clone(), denominator: m.denominator.clone(), ..*m }
}

/// A matrix times a column that is written as a row.
fn moved(reader: &mut Reader, m: &Matrix, column: &Matrix) -> Result<Matrix, Refusal> {
    let turned = Matrix::from_fn(m.cols, m.rows, m.denominator.clone(), |i, j| m.at(j, i).clone());
    reader.times(column, &turned)
}

impl Mode {
    fn new(reader: &mut Reader, system: &System, mode: usize) -> Result<Self, Refusal> {
        let (a, columns) = augmented(reader, system, mode)?;
        Ok(Mode { a, columns })
    }

    /// That of a duration.
    fn bend(&self, reader: &mut Reader, states: &[BigInt], length: (BigInt, BigInt)) -> Result<Bend, Refusal> {
        let curve = reader.times(&self.a, &self.a)?;
        let columns = self.columns.iter().map(|v| moved(reader, &self.a, v)).collect::<Result<_, _>>()?;
        Bend::new(reader, &self.a, curve, columns, states, length)
    }

    /// That of the instant of a switch to another mode.
    fn bend_to(
        &self,
        reader: &mut Reader,
        after: &Mode,
        states: &[BigInt],
        length: (BigInt, BigInt),
    ) -> Result<Bend, Refusal> {
        reader.pay(4 * self.a.entries.len(), self.a.bits(), after.a.bits())?;
        let change = self.a.minus(&after.a);
        // (A - B) A - B (A - B).
        let (left, right) = (reader.times(&change, &self.a)?, reader.times(&after.a, &change)?);
        reader.pay(2 * left.entries.len(), left.bits(), right.bits())?;
        let mut columns = Vec::new();
        for v in &self.columns {
            columns.push(moved(reader, &after.a, v)?);
            columns.push(moved(reader, &change, v)?);
        }
        for v in &after.columns {
            columns.push(moved(reader, &after.a, v)?);
        }
        Bend::new(reader, &after.a, left.minus(&right), columns, states, length)
    }
}

impl Bend {
    fn new(
        reader: &mut Reader,
        a: &Matrix,
        curve: Matrix,
        columns: Vec<Matrix>,
        states: &[BigInt],
        length: (BigInt, BigInt),
    ) -> Result<Self, Refusal> {
        let n = a.rows;
        reader.pay(2 * n * (n + columns.len()), curve.bits() + SCALE, SCALE)?;
        let of = |l: usize| {
            let curved: BigInt = curve.row(l).iter().zip(states).map(|(c, x)| size(c) * x).sum();
            let pushed = columns.iter().map(|v| up(size(v.at(0, l)) << SCALE, &v.denominator));
            up(curved, &curve.denominator) + pushed.sum::<BigInt>()
        };
        let most = (0..n).map(of).max().unwrap_or_default();
        Ok(Bend { a: copy(a), curve, columns, states: states.to_vec(), most, length })
    }

    /// `|q m|` for each column, over `2^SCALE`.
    fn sizes_of(reader: &mut Reader, q: &Vector, m: &Matrix) -> Result<Vec<BigInt>, Refusal> {
        let n = q.entries.len();
        reader.pay(2 * n * m.cols, m.bits(), crate::budget::bits(&q.entries).max(q.error.bits()))?;
        let of = |j: usize| {
            let (mut value, mut wide) = (BigInt::from(0), BigInt::from(0));
            for (l, q) in q.entries.iter().enumerate() {
                value += q * m.at(l, j);
                wide += size(m.at(l, j));
            }
            up(size(&value) + wide * &q.error, &m.denominator)
        };
        Ok((0..m.cols).map(of).collect())
    }

    /// The bound from a node on: for a row `q e^(A s)` with `s` up to a step.
    fn at(&self, reader: &mut Reader, q: &Vector) -> Result<BigInt, Refusal> {
        let curved = Self::sizes_of(reader, q, &self.curve)?;
        let mut sum = shift(curved.iter().zip(&self.states).map(|(c, x)| c * x).sum(), SCALE);
        for v in &self.columns {
            let column = Matrix { rows: v.cols, cols: 1, ..copy(v) };
            sum += Self::sizes_of(reader, q, &column)?.into_iter().sum::<BigInt>();
        }
        let further: BigInt = Self::sizes_of(reader, q, &self.a)?.into_iter().sum();
        Ok(sum + up(grown(shift(further * &self.most, SCALE)) * &self.length.0, &self.length.1))
    }

    /// `h^2/8` of it.
    fn over(&self, most: BigInt) -> BigInt {
        let (h, k) = &self.length;
        up(most * h * h, &(k * k * 8))
    }
}

impl Leg {
    fn new(
        reader: &mut Reader,
        (mode, own): (usize, &Mode),
        time: &Time,
        steps: usize,
        states: &[BigInt],
    ) -> Result<Self, Refusal> {
        let columns = own.columns.iter().map(copy).collect();
        let time = (time.numerator.clone(), time.denominator.clone());
        let flow = Flow::new(reader, mode, copy(&own.a), columns, time, steps)?;
        let powers = powers(reader, &flow)?;
        let bend = own.bend(reader, states, flow.length())?;
        Ok(Leg { flow, powers, bend })
    }
}

/// `e^(A h i)` at each node, as rows of its transpose.
fn powers(reader: &mut Reader, flow: &Flow) -> Result<Vec<Square>, Refusal> {
    let n = flow.a.rows;
    let turned = Square {
        rows: (0..n).map(|i| flow.unit.rows.iter().map(|column| column[i].clone()).collect()).collect(),
        error: flow.unit.error.clone(),
    };
    let one = |j: usize| fixed(&unit(j, n), flow.fine);
    let mut columns: Vec<Vector> = (0..n).map(one).collect();
    let mut powers = Vec::new();
    for i in 0..=flow.steps {
        let rounded: Vec<Vector> = columns.iter().map(|column| column.rounded(flow.fine)).collect();
        let error = rounded.iter().map(|column| column.error.clone()).max().unwrap_or_default();
        powers.push(Square { rows: rounded.into_iter().map(|column| column.entries).collect(), error });
        if i < flow.steps {
            for column in &mut columns {
                *column = turned.applied(reader, column, flow.fine)?;
            }
        }
    }
    Ok(powers)
}

/// As [`Flow::sums`]; as there are many of few steps, they count for more.
fn sums_of(reader: &mut Reader, flow: &Flow, p: &Vector, steps: usize, each: bool) -> Result<Vec<Sum>, Refusal> {
    let products = (flow.nodes.len() + 1) * (steps + 1) * p.entries.len();
    reader.pay(3 * products + if each { 40 * (steps + 1) } else { 0 }, 2 * SCALE, 2 * SCALE)?;
    flow.sums(reader, p, steps, each)
}

/// A piece of time: of one leg, or with a switch from one to another at some instant, or none before its end.
enum Piece {
    One(usize),
    Two { before: usize, after: usize, bend: Box<Bend> },
}

/// Where motions begin, and the box that they stay in.
struct Ends<'a> {
    start: &'a [Vector; 2],
    inside: &'a [Vector; 2],
    absolute: bool,
}

struct Windows {
    legs: Vec<Leg>,
    pieces: Vec<Piece>,
    for_ever: bool,
}

/// The pieces of time between and in the windows: modes before and after, and how long.
fn pieces(
    reader: &mut Reader,
    turns: &[usize],
    windows: &[[Time; 2]],
    until: Option<&Time>,
) -> Result<Vec<([usize; 2], Time)>, Refusal> {
    let mut now = Time { numerator: BigInt::from(0), denominator: BigInt::from(1) };
    let mut ends: Vec<([usize; 2], Time)> = Vec::new();
    for (k, [lo, hi]) in windows.iter().enumerate() {
        ends.push(([turns[k], turns[k]], lo.clone()));
        ends.push(([turns[k], turns[k + 1]], hi.clone()));
    }
    let last = turns[turns.len() - 1];
    ends.push((
        [last, last],
        match until {
            Some(until) => until.clone(),
            None => {
                let time = reader.fraction("last")?;
                reader.require(time.is_positive(), "a time is not positive")?;
                let more = Time { numerator: time.numerator, denominator: time.denominator };
                windows.last().map_or(&now, |[_, hi]| hi).plus(reader, &more, 1)?
            }
        },
    ));
    let mut list = Vec::new();
    for (modes, end) in ends {
        reader.pay(8, end.numerator.bits() + end.denominator.bits(), now.numerator.bits() + now.denominator.bits())?;
        let end = match until {
            Some(until) if until.is_at_most(&end) => until.clone(),
            _ => end,
        };
        if !end.is_at_most(&now) {
            list.push((modes, end.plus(reader, &now, -1)?));
            now = end;
        }
    }
    reader.require(!list.is_empty(), "no time passes")?;
    Ok(list)
}

impl Windows {
    fn read(
        reader: &mut Reader,
        modes: &[Mode],
        list: Vec<([usize; 2], Time)>,
        states: &[BigInt],
        for_ever: bool,
    ) -> Result<Self, Refusal> {
        let (mut legs, mut pieces): (Vec<Leg>, Vec<Piece>) = (Vec::new(), Vec::new());
        for ([before, after], time) in list {
            let steps = reader.count("steps", 1, super::MOST_STEPS)?;
            for mode in [before, after].into_iter().take(if before == after { 1 } else { 2 }) {
                legs.push(Leg::new(reader, (mode, &modes[mode]), &time, steps, states)?);
            }
            let last = legs.len() - 1;
            pieces.push(if before == after {
                Piece::One(last)
            } else {
                let length = legs[last].flow.length();
                let bend = modes[before].bend_to(reader, &modes[after], states, length)?;
                Piece::Two { before: last - 1, after: last, bend: Box::new(bend) }
            });
        }
        Ok(Windows { legs, pieces, for_ever })
    }

    /// The most of `p x + sum` for states `x` at the beginning of a piece.
    fn back(&self, reader: &mut Reader, p: &Vector, sum: Sum, piece: usize, ends: &Ends) -> Result<BigInt, Refusal> {
        let Some(before) = piece.checked_sub(1) else { return started(reader, p, ends.start, sum, ends.absolute) };
        match &self.pieces[before] {
            Piece::One(leg) => self.through(reader, p, sum, (*leg, self.legs[*leg].flow.steps, before), ends),
            Piece::Two { after, .. } => {
                let steps = self.legs[*after].flow.steps;
                self.switched(reader, p, sum, (before, steps), ends)
            }
        }
    }

    /// As `back`, of states so many steps after the beginning of a piece, in which one mode is on.
    fn through(
        &self,
        reader: &mut Reader,
        p: &Vector,
        sum: Sum,
        (leg, steps, piece): (usize, usize, usize),
        ends: &Ends,
    ) -> Result<BigInt, Refusal> {
        let Leg { flow, powers, .. } = &self.legs[leg];
        let more = sums_of(reader, flow, p, steps, false)?.pop();
        let sum = more.map_or(sum.clone(), |more| sum.plus(&more));
        let q = powers[steps].applied(reader, p, SCALE)?;
        self.back(reader, &q, sum, piece, ends)
    }

    /// As `back`, of states so many steps after the beginning of a piece, the switch being before.
    fn switched(
        &self,
        reader: &mut Reader,
        p: &Vector,
        sum: Sum,
        (piece, steps): (usize, usize),
        ends: &Ends,
    ) -> Result<BigInt, Refusal> {
        let Piece::Two { before, after, bend } = &self.pieces[piece] else { return Ok(BigInt::from(0)) };
        let Leg { flow, powers, .. } = &self.legs[*after];
        let sums = sums_of(reader, flow, p, steps, true)?;
        let (mut most, mut bent): (Option<BigInt>, BigInt) = (None, BigInt::from(0));
        for (k, more) in sums.into_iter().enumerate() {
            let q = powers[k].applied(reader, p, SCALE)?;
            bent = bent.max(bend.at(reader, &q)?);
            let value = self.through(reader, &q, sum.plus(&more), (*before, steps - k, piece), ends)?;
            most = most.max(Some(value));
        }
        Ok(most.unwrap_or_default() + bend.over(bent))
    }

    /// The most of a row at all times.
    fn most(&self, reader: &mut Reader, row: &Matrix, ends: &Ends) -> Result<BigInt, Refusal> {
        let row = fixed(row, SCALE);
        let mut most: Option<BigInt> = None;
        for piece in 0..self.pieces.len() {
            let value = match &self.pieces[piece] {
                Piece::One(leg) => self.during(reader, &row, (*leg, piece), ends)?,
                Piece::Two { before, after, .. } => {
                    // The time is that of the switch, or comes after it and is at a node.
                    let mut value = self.during(reader, &row, (*before, piece), ends)?;
                    let Leg { flow, powers, bend } = &self.legs[*after];
                    let mut bent = BigInt::from(0);
                    for (steps, power) in powers.iter().enumerate().take(flow.steps + 1) {
                        let q = power.applied(reader, &row, SCALE)?;
                        bent = bent.max(bend.at(reader, &q)?);
                        value = value.max(self.switched(reader, &row, Sum::zero(), (piece, steps), ends)?);
                    }
                    value + bend.over(bent)
                }
            };
            most = most.max(Some(value));
        }
        Ok(most.unwrap_or_default())
    }

    /// The most of a row while the first mode of a piece is on.
    fn during(
        &self,
        reader: &mut Reader,
        row: &Vector,
        (leg, piece): (usize, usize),
        ends: &Ends,
    ) -> Result<BigInt, Refusal> {
        let Leg { flow, powers, bend } = &self.legs[leg];
        let (mut most, mut bent): (Option<BigInt>, BigInt) = (None, BigInt::from(0));
        let sums = sums_of(reader, flow, row, flow.steps, true)?;
        for (k, sum) in sums.into_iter().enumerate() {
            let q = powers[k].applied(reader, row, SCALE)?;
            bent = bent.max(bend.at(reader, &q)?);
            if self.for_ever && k == flow.steps && piece + 1 == self.pieces.len() {
                most = most.max(Some(started(reader, &q, ends.inside, sum.clone(), ends.absolute)?));
            }
            most = most.max(Some(self.back(reader, &q, sum, piece, ends)?));
        }
        Ok(most.unwrap_or_default() + bend.over(bent))
    }
}

struct Dwell<'a> {
    legs: Vec<Leg>,
    first: Option<usize>,
    stays: &'a [Stay],
    until: Option<BigInt>,
    /// What is further back, in time or in legs, is replaced by the box.
    back: BigInt,
    most_legs: usize,
}

/// How far back a leg ends: not less than `least`, and about `about`, over `2^SCALE`; and how many legs come after it.
#[derive(Clone)]
struct Past {
    least: BigInt,
    about: BigInt,
    legs: usize,
}

/// How many steps a time takes, rounded down.
fn steps_of(time: &Time, length: &(BigInt, BigInt)) -> BigInt {
    &time.numerator * &length.1 / (&time.denominator * &length.0)
}

impl<'a> Dwell<'a> {
    fn read(
        reader: &mut Reader,
        modes: &[Mode],
        (first, stays): (Option<usize>, &'a [Stay]),
        until: Option<&Time>,
        states: &[BigInt],
    ) -> Result<Self, Refusal> {
        let back = reader.fraction("back")?;
        let most_legs = reader.count("legs", 1, MOST_LEGS)?;
        let mut legs = Vec::new();
        for (k, mode) in modes.iter().enumerate() {
            let time = reader.fraction("time")?;
            reader.require(time.is_positive(), "a time is not positive")?;
            let time = Time { numerator: time.numerator, denominator: time.denominator };
            let steps = reader.count("steps", 1, super::MOST_STEPS)?;
            legs.push(Leg::new(reader, (k, mode), &time, steps, states)?);
        }
        let scaled = |time: &Time| up(&time.numerator << SCALE, &time.denominator);
        let back = (back.numerator << SCALE) / back.denominator;
        Ok(Dwell { legs, first, stays, until: until.map(scaled), back, most_legs })
    }

    /// The most of `p x + sum` for states `x` at the end of a leg of a mode, or, where nothing comes after it, at any time in it.
    fn back(
        &self,
        reader: &mut Reader,
        (p, sum): (&Vector, &Sum),
        mode: usize,
        past: &Past,
        ends: &Ends,
    ) -> Result<Option<BigInt>, Refusal> {
        let Leg { flow, powers, bend } = &self.legs[mode];
        let Stay { least, most } = &self.stays[mode];
        let length = flow.length();
        reader.pay(8, length.0.bits() + length.1.bits(), least.numerator.bits() + least.denominator.bits())?;
        let from = if past.legs == 0 { BigInt::from(0) } else { steps_of(least, &length) };
        let to = most.as_ref().map(|most| up(&most.numerator * &length.1, &(&most.denominator * &length.0)));
        let to = to.filter(|to| *to <= BigInt::from(flow.steps));
        let at = |k: usize| ((&length.0 * k) << SCALE) / &length.1;
        let past = |k: usize| Past {
            least: &past.least + at(k.saturating_sub(1)),
            about: &past.about + at(k),
            legs: past.legs + 1,
        };
        let is_early = |past: &Past| self.until.as_ref().is_some_and(|until| past.least > *until);
        // The last node that matters, and whether the box is taken there.
        let (mut last, mut boxed) = (0, false);
        for k in 0..=flow.steps {
            let own = past(k);
            if is_early(&own) {
                break;
            }
            (last, boxed) = (k, own.about >= self.back || k == flow.steps && to.is_none());
            if boxed || to.as_ref().is_some_and(|to| BigInt::from(k) >= *to) {
                break;
            }
        }
        let (mut largest, mut bent): (Option<BigInt>, BigInt) = (None, BigInt::from(0));
        for (k, more) in sums_of(reader, flow, p, last, true)?.into_iter().enumerate() {
            let (q, sum) = (powers[k].applied(reader, p, SCALE)?, sum.plus(&more));
            bent = bent.max(bend.at(reader, &q)?);
            if boxed && k == last {
                largest = largest.max(Some(started(reader, &q, ends.inside, sum, ends.absolute)?));
            } else if BigInt::from(k) >= from {
                largest = largest.max(self.before(reader, (&q, &sum), mode, &past(k), ends)?);
            }
        }
        Ok(largest.map(|largest| largest + bend.over(bent)))
    }

    /// The most of `p x + sum` for states at the beginning of a leg.
    fn before(
        &self,
        reader: &mut Reader,
        (p, sum): (&Vector, &Sum),
        mode: usize,
        past: &Past,
        ends: &Ends,
    ) -> Result<Option<BigInt>, Refusal> {
        let mut most = None;
        if self.first.is_none_or(|first| first == mode) {
            most = Some(started(reader, p, ends.start, sum.clone(), ends.absolute)?);
        }
        let others = (0..self.legs.len()).filter(|&other| other != mode);
        if past.legs >= self.most_legs {
            if others.count() > 0 {
                most = most.max(Some(started(reader, p, ends.inside, sum.clone(), ends.absolute)?));
            }
            return Ok(most);
        }
        for other in others {
            most = most.max(self.back(reader, (p, sum), other, past, ends)?);
        }
        Ok(most)
    }

    fn most(&self, reader: &mut Reader, row: &Matrix, ends: &Ends) -> Result<BigInt, Refusal> {
        let row = fixed(row, SCALE);
        let now = Past { least: BigInt::from(0), about: BigInt::from(0), legs: 0 };
        let mut most = None;
        for mode in 0..self.legs.len() {
            most = most.max(self.back(reader, (&row, &Sum::zero()), mode, &now, ends)?);
        }
        Ok(most.unwrap_or_default())
    }
}

enum Free<'a> {
    Windows(Windows),
    Dwell(Dwell<'a>),
}

/// Reads what follows `order free`; refuses unless no row comes above its bound.
pub fn check(
    reader: &mut Reader,
    system: &System,
    switching: &Switching,
    (rows, bounds): (&Matrix, &Matrix),
) -> Result<(), Refusal> {
    let mut modes = Vec::new();
    for mode in 0..system.modes.len() {
        modes.push(Mode::new(reader, system, mode)?);
    }
    let start = start(reader, system)?;
    let ever = Ever::read(reader, system, &start, 1)?;
    let until = switching.until.as_ref();
    let free = match &switching.rule {
        Rule::Windows { turns, windows } => {
            let list = pieces(reader, turns, windows, until)?;
            Free::Windows(Windows::read(reader, &modes, list, &ever.states, until.is_none())?)
        }
        Rule::Dwell { first, stays } => Free::Dwell(Dwell::read(reader, &modes, (*first, stays), until, &ever.states)?),
        _ => return Err(reader.refusal("the instants of its switches are not free")),
    };
    let n = start[0].entries.len();
    let mut most = |row: &Matrix, absolute: bool| {
        let ends = Ends { start: &start, inside: &ever.start, absolute };
        match &free {
            Free::Windows(windows) => windows.most(reader, row, &ends),
            Free::Dwell(dwell) => dwell.most(reader, row, &ends),
        }
    };
    let (mut above, mut stays) = (None, true);
    for i in 0..rows.rows {
        if most(&row_of(rows, i, n), false)? * &bounds.denominator > (bounds.at(0, i) << SCALE) {
            above = above.or(Some(i + 1));
        }
    }
    for (k, limit) in ever.limits.iter().enumerate() {
        stays &= most(&unit(k, n), true)? < *limit;
    }
    reader.require(stays, "the states are not shown to stay in the box")?;
    match above {
        Some(i) => Err(reader.refusal(format!("row {i} is not shown to stay within its bound"))),
        None => Ok(()),
    }
}
