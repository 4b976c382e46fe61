//! `bound`: bounds of rows of a switched linear system `x' = A x + B u + c` at all times, for every start and every input within their bounds, the modes following each
//! other at the times given.
//!
//! An input that keeps one value is a state that does not move; the others are their middle, which joins `c` and makes it `d`, and their radius, which joins its column of `B` and
//! makes it `b`. With `p(r) = row e^(A r)`, backwards through the modes, `row x(t)` is at most `p(t) x(0)` at its worst start plus the integral of `p d + sum |p b|`.
//!
//! In time: each stretch is cut into steps of length `h`. A function is off its chord by at most `h^2/8`, in the mean `h^2/12`, times the largest second derivative, and the
//! absolute value of a chord is below the chord of the absolute values. So the trapezoid rule for `p d` and `|p b|`, with `h^3/12 |p| |A^2 e^(A r) b|` for each step, bounds the
//! integral. Between two nodes, `row x` is at most the larger of the two bounds there, plus `h^2/8` times bounds of `|row A^2 e^(A s) x|` and of the rate of the integrand.
//! The first of these asks how large states become: a bound of that, with the same sentence for the states themselves, is one of the form `X <= M + k X`.
//!
//! Where any order of modes is allowed, with `A`, `d`, `b` the means over the modes, a mode adds `((A_m - A) x + (d_m - d) + ..)_i` to the rate of state `i`. If the system of the means, with
//! disturbances `|w_i(t)| <= w_i` beside its inputs, keeps `|(A_m - A)_i x|` with the bound of the rest strictly below `w_i`, for every mode, then its motions include the switched ones:
//! up to the first time at which a bound is reached, which is one more, they are such motions. In the same way disturbances of two states may be bounded together, by a polygon that is a sum
//! of edges `s g`, `|s| <= 1`: its faces are along its edges, and what is kept is `|n ((A_m - A) x + ..)|` below `sum |n g|` for the normals `n` of all edges.
//!
//! For ever: the modes of the last stretches, a cycle, follow each other again and again as those before them do. The file gives a box `|x_i| < X_i`. Up to the first time at which a motion leaves
//! it, what is in the last cycle, or in a later one, began some whole cycles earlier in the box: so its values there are bounded as above with the box for the start. These bounds are below `X`, so that
//! no motion leaves. Where one mode is on for ever, all times after the end of its stretch lie that long after one in the box.
//!
//! Numbers are integers over `2^96` with bounds of their errors; what is carried through all steps of a stretch has more bits.

mod free;

use crate::Refusal;
use crate::budget::bits;
use crate::matrix::Matrix;
use crate::motion::{Stretch, step};
use crate::read::Reader;
use crate::switching::{Switching, Time};
use crate::system::System;
use num_bigint::{BigInt, Sign};

const MOST_ROWS: usize = 200;
const MOST_STRETCHES: usize = 1000;
const MOST_STEPS: usize = 5000;

/// Bits after the point.
const SCALE: u64 = 96;

/// Integers with a bound of their errors.
#[derive(Clone)]
struct Vector {
    entries: Vec<BigInt>,
    error: BigInt,
}

/// The rows of a square matrix.
struct Square {
    rows: Vec<Vec<BigInt>>,
    error: BigInt,
}

/// What is computed once for all stretches of a mode with the same steps.
struct Flow {
    mode: usize,
    time: (BigInt, BigInt),
    steps: usize,
    /// `A`, with inputs that keep one value as states.
    a: Matrix,
    square: Matrix,
    cube: Matrix,
    /// `d` and each `b` at each node: `e^(A h i) b`.
    nodes: Vec<Vec<Vector>>,
    /// At each node the sums over `d` and all `b` of the errors, and of the absolute values.
    widths: Vec<(BigInt, BigInt)>,
    /// For each step the sum over `d` and all `b` of bounds of `|A^2 e^(A r) b|`, summed over all steps up to it.
    bends: Vec<Vec<BigInt>>,
    /// The transposes of `e^(A h)`, in more bits, and of `e^(A time)`.
    unit: Square,
    fine: u64,
    whole: Square,
}

/// A bound in the making, over `2^(2 SCALE)`.
#[derive(Clone)]
struct Sum {
    middle: BigInt,
    radius: BigInt,
}

impl Sum {
    fn zero() -> Self {
        Sum { middle: BigInt::from(0), radius: BigInt::from(0) }
    }

    fn plus(&self, more: &Sum) -> Sum {
        Sum { middle: &self.middle + &more.middle, radius: &self.radius + &more.radius }
    }
}

fn size(x: &BigInt) -> BigInt {
    BigInt::from(x.magnitude().clone())
}

fn sizes<'a>(entries: impl IntoIterator<Item = &'a BigInt>) -> BigInt {
    entries.into_iter().map(size).sum()
}

/// The quotient of what is not negative, rounded up.
fn up(numerator: BigInt, denominator: &BigInt) -> BigInt {
    (numerator + denominator - 1) / denominator
}

/// What is not negative, over `2^bits` rounded up.
fn shift(x: BigInt, bits: u64) -> BigInt {
    (x >> bits) + 1
}

/// `e^(1/2) x`, rounded up.
fn grown(x: BigInt) -> BigInt {
    up(x * 33, &BigInt::from(20))
}

/// A row of a matrix, with nothing of inputs that keep one value.
fn row_of(rows: &Matrix, i: usize, order: usize) -> Matrix {
    let entry = |j: usize| if j < rows.cols { rows.at(i, j).clone() } else { BigInt::from(0) };
    Matrix::from_fn(1, order, rows.denominator.clone(), |_, j| entry(j))
}

fn unit(k: usize, order: usize) -> Matrix {
    Matrix::from_fn(1, order, BigInt::from(1), |_, j| BigInt::from(j == k))
}

pub fn check(reader: &mut Reader) -> Result<String, Refusal> {
    let system = System::read(reader)?;
    let switching = Switching::read(reader, system.modes.len())?;
    let count = reader.count("rows", 1, MOST_ROWS)?;
    let rows = reader.matrix("row", count, system.states)?;
    let bounds = reader.matrix("bound", 1, count)?;
    let order = reader.value("order")?;
    let own = match (order, &switching) {
        ("free", Some(switching)) => {
            free::check(reader, &system, switching, (&rows, &bounds))?;
            None
        }
        _ => Some(stepped(reader, &system, order, switching.as_ref(), (&rows, &bounds))?),
    };
    let (modes, times) = match (own, &switching) {
        (Some(own), None) => own,
        (_, Some(Switching { until: None, .. })) => (ALLOWED.to_string(), "any time"),
        _ => (ALLOWED.to_string(), "any time up to the last one"),
    };
    Ok(format!(
        "no motion of the system of {} linear modes and {} states below, from a start and with inputs within their bounds and with {modes}, comes at {times} with any of the {count} rows to \
         a value above its bound",
        system.modes.len(),
        system.states
    ))
}

/// How a claim puts the orders of modes where the file says which are allowed.
pub const ALLOWED: &str = "its modes as the switching below allows";

/// Refuses unless no row comes above its bound; how the orders of modes and the times are put where the file does not say which are allowed.
fn stepped(
    reader: &mut Reader,
    system: &System,
    order: &str,
    switching: Option<&Switching>,
    (rows, bounds): (&Matrix, &Matrix),
) -> Result<(String, &'static str), Refusal> {
    let (any, ever) = match order {
        "given" => (false, false),
        "any" => (true, false),
        "given for ever" => (false, true),
        "any for ever" => (true, true),
        _ => return Err(reader.refusal("`order given` or `order any` is expected, and `for ever` where it is so, or `order free` where it is said what is allowed")),
    };
    let (flows, order, kept) = if any { disturbed(reader, system)? } else { flows(reader, system)? };
    let start = start(reader, system)?;
    let cycle = if ever && !any { reader.count("cycle", 1, order.len())? } else { order.len() };
    let repeats = order[cycle..].iter().zip(&order).all(|(later, earlier)| later == earlier);
    reader.require(repeats, "the stretches are not those of a cycle earlier")?;
    if let Some(switching) = switching {
        let time = |flow: &Flow| Time { numerator: flow.time.0.clone(), denominator: flow.time.1.clone() };
        let list: Vec<(usize, Time)> = order.iter().map(|&k| (flows[k].mode, time(&flows[k]))).collect();
        match &switching.until {
            _ if !any => switching.is_fixed_as(reader, &list, ever.then_some(cycle))?,
            Some(until) => reader.require(ever || until.is_at_most(&list[0].1), "the time ends too early")?,
            None => reader.require(ever, "the time ends too early")?,
        }
    }
    let ever = if ever { Some(Ever::read(reader, system, &start, cycle)?) } else { None };
    let n = start[0].entries.len();
    let states = match &ever {
        Some(ever) => ever.states.clone(),
        None => states(reader, &flows, &order, &start)?,
    };
    let mut largest = |row: &Matrix, absolute: bool| -> Result<BigInt, Refusal> {
        let most = nodes(reader, row, &flows, &order, (&start, ever.as_ref()), absolute)?;
        let mut added = BigInt::from(0);
        for flow in &flows {
            let (shares, rest) = flow.between(reader, row)?;
            let moved: BigInt = shares.iter().zip(&states).map(|(k, x)| k * x).sum();
            added = added.max(shift(moved, SCALE) + rest);
        }
        Ok(most + added)
    };
    let mut above = None;
    for i in 0..rows.rows {
        if largest(&row_of(rows, i, n), false)? * &bounds.denominator > (bounds.at(0, i) << SCALE) {
            above = above.or(Some(i + 1));
        }
    }
    let mut closed = true;
    for Kept { row, rest, limit } in &kept {
        closed &= largest(row, true)? + rest < *limit;
    }
    let mut stays = true;
    for (k, limit) in ever.iter().flat_map(|ever| ever.limits.iter().enumerate()) {
        stays &= largest(&unit(k, n), true)? < *limit;
    }
    reader.require(closed, "the disturbances are not shown to stay below their bounds")?;
    reader.require(stays, "the states are not shown to stay in the box")?;
    if let Some(i) = above {
        return Err(reader.refusal(format!("row {i} is not shown to stay within its bound")));
    }
    Ok(match (any, ever.is_some()) {
        (false, false) => ("its modes for the times below".to_string(), "any of these times"),
        (true, false) => ("any measurable choice of its modes up to the time below".to_string(), "any of these times"),
        (false, true) => (format!("its modes for the times below, for ever in cycles of {cycle}"), "any time"),
        (true, true) => ("any measurable choice of its modes".to_string(), "any time"),
    })
}

/// What is known where time does not end.
struct Ever {
    /// How many of the last stretches follow each other for ever.
    cycle: usize,
    /// The box, of inputs that keep one value too, as a start.
    start: [Vector; 2],
    /// The sizes of its sides, rounded up, and those below which states are to stay, rounded down.
    states: Vec<BigInt>,
    limits: Vec<BigInt>,
}

impl Ever {
    fn read(reader: &mut Reader, system: &System, start: &[Vector; 2], cycle: usize) -> Result<Self, Refusal> {
        let sides = reader.matrix("box", 1, system.states)?;
        let positive = sides.entries.iter().all(|x| x.sign() == Sign::Plus);
        reader.require(positive, "a side of the box is not positive")?;
        reader.pay(4 * system.states, sides.bits() + SCALE, sides.bits())?;
        let mut own = start.clone();
        let mut states: Vec<BigInt> =
            own[0].entries.iter().zip(&own[1].entries).map(|(m, r)| size(m) + r + 1).collect();
        let mut limits = Vec::new();
        for (i, side) in sides.entries.iter().enumerate() {
            states[i] = up(side << SCALE, &sides.denominator);
            limits.push((side << SCALE) / &sides.denominator);
            own[0].entries[i] = BigInt::from(0);
            own[1].entries[i] = states[i].clone();
        }
        Ok(Ever { cycle, start: own, states, limits })
    }
}

/// How large states become: X <= M + k X + l.
fn states(reader: &mut Reader, flows: &[Flow], order: &[usize], start: &[Vector; 2]) -> Result<Vec<BigInt>, Refusal> {
    let n = start[0].entries.len();
    let mut known = Vec::new();
    for k in 0..n {
        let unit = unit(k, n);
        let most = nodes(reader, &unit, flows, order, (start, None), true)?;
        let (mut share, mut rest) = (BigInt::from(0), BigInt::from(0));
        for flow in flows {
            let between = flow.between(reader, &unit)?;
            share = share.max(between.0.iter().sum());
            rest = rest.max(between.1);
        }
        known.push((most, share, rest));
    }
    let one = BigInt::from(1) << SCALE;
    let share = known.iter().map(|x| x.1.clone()).max().unwrap_or_default();
    reader.require(share < one, "the steps are too long")?;
    let largest = known.iter().map(|x| &x.0 + &x.2).max().unwrap_or_default();
    let largest = up(largest << SCALE, &(&one - share));
    Ok(known.into_iter().map(|(m, k, l)| m + shift(k * &largest, SCALE) + l).collect())
}

/// A row whose absolute value, with the rest, is to stay below a limit, all over `2^SCALE` but the row.
struct Kept {
    row: Matrix,
    rest: BigInt,
    limit: BigInt,
}

/// Flows, for each stretch which of them it is, and what is to be kept for it.
type Walked = (Vec<Flow>, Vec<usize>, Vec<Kept>);

/// A face of the set of disturbances: its normal, and what is below the limit along it, which is over the denominator of the edges.
struct Face {
    normal: Vec<(usize, BigInt)>,
    limit: BigInt,
}

impl Face {
    fn along<'a>(&self, entry: impl Fn(usize) -> &'a BigInt) -> BigInt {
        self.normal.iter().map(|(i, n)| n * entry(*i)).sum()
    }
}

const MOST_EDGES: usize = 200;

/// The edges whose sum the disturbances lie in, a row each, and its faces: a limit for each state, or a polygon for each pair of states.
fn faces(reader: &mut Reader, states: usize) -> Result<(Matrix, Vec<Face>), Refusal> {
    let zero = BigInt::from(0);
    let alone = |i: usize, limit: BigInt| Face { normal: vec![(i, BigInt::from(1))], limit };
    let Some(count) = reader.value_if_any("edges") else {
        let limits = reader.matrix("disturbance", 1, states)?;
        let own: Vec<usize> = (0..states).filter(|&i| *limits.at(0, i) != zero).collect();
        let entry = |k: usize, j: usize| if own[k] == j { limits.at(0, j).clone() } else { zero.clone() };
        let edges = Matrix::from_fn(own.len(), states, limits.denominator.clone(), entry);
        return Ok((edges, (0..states).map(|i| alone(i, limits.at(0, i).clone())).collect()));
    };
    let count = reader.count_of(count, 1, MOST_EDGES)?;
    let edges = reader.matrix("edge", count, states)?;
    let mut partner = vec![None; states];
    for k in 0..count {
        let own: Vec<usize> = (0..states).filter(|&i| *edges.at(k, i) != zero).collect();
        let fits = match own[..] {
            [i, j] => {
                let free = partner[i].is_none_or(|other| other == j) && partner[j].is_none_or(|other| other == i);
                (partner[i], partner[j]) = (Some(j), Some(i));
                free
            }
            _ => own.len() == 1,
        };
        reader
            .require(fits, &format!("edge {} does not lead through one state, or through one pair of states", k + 1))?;
    }
    reader.pay(4 * count * count, edges.bits(), edges.bits())?;
    let mut faces = Vec::new();
    for (i, partner) in partner.into_iter().enumerate() {
        let Some(j) = partner else {
            faces.push(alone(i, sizes((0..count).map(|k| edges.at(k, i)))));
            continue;
        };
        let own: Vec<usize> = (0..count).filter(|&k| *edges.at(k, i) != zero || *edges.at(k, j) != zero).collect();
        let mut open = false;
        for &k in own.iter().filter(|_| i < j) {
            let mut face =
                Face { normal: vec![(i, edges.at(k, j).clone()), (j, -edges.at(k, i))], limit: zero.clone() };
            face.limit = own.iter().map(|&l| size(&face.along(|state| edges.at(l, state)))).sum();
            open |= face.limit != zero;
            faces.push(face);
        }
        reader.require(open || i > j, "the edges of a pair of states are parallel")?;
    }
    Ok((edges, faces))
}

/// The mean of the modes with its disturbances.
fn disturbed(reader: &mut Reader, system: &System) -> Result<Walked, Refusal> {
    let (edges, faces) = faces(reader, system.states)?;
    let time = reader.fraction("time")?;
    reader.require(time.is_positive(), "a time is not positive")?;
    let steps = reader.count("steps", 1, MOST_STEPS)?;
    let mut all = Vec::new();
    for mode in 0..system.modes.len() {
        let (a, mut columns) = augmented(reader, system, mode)?;
        columns.insert(0, a);
        all.push(columns);
    }
    let parts = all[0].len();
    let mut means = Vec::new();
    for part in 0..parts {
        means.push(mean(reader, &all.iter().map(|mode| &mode[part]).collect::<Vec<_>>())?);
    }
    let mut kept = Vec::new();
    for mode in &all {
        let mut off = Vec::new();
        for (own, mean) in mode.iter().zip(&means) {
            reader.pay(2 * own.entries.len(), own.bits(), mean.bits())?;
            off.push(own.minus(mean));
        }
        for face in &faces {
            reader.pay(2 * off[0].entries.len(), off[0].bits(), edges.bits())?;
            let row =
                Matrix::from_fn(1, off[0].cols, off[0].denominator.clone(), |_, j| face.along(|i| off[0].at(i, j)));
            let rest: BigInt =
                off[1..].iter().map(|v| up(size(&face.along(|i| v.at(0, i))) << SCALE, &v.denominator)).sum();
            if !row.is_zero() || rest.sign() != Sign::NoSign {
                kept.push(Kept { row, rest, limit: (&face.limit << SCALE) / &edges.denominator });
            }
        }
    }
    let (a, mut columns) = (means.remove(0), means);
    for k in 0..edges.rows {
        let entry = |j: usize| if j < edges.cols { edges.at(k, j).clone() } else { BigInt::from(0) };
        columns.push(Matrix::from_fn(1, a.cols, edges.denominator.clone(), |_, j| entry(j)));
    }
    let flow = Flow::new(reader, usize::MAX, a, columns, (time.numerator, time.denominator), steps)?;
    Ok((vec![flow], vec![0], kept))
}

fn mean(reader: &mut Reader, list: &[&Matrix]) -> Result<Matrix, Refusal> {
    let first = list[0];
    let mut sum = Matrix::from_fn(first.rows, first.cols, BigInt::from(1), |_, _| BigInt::from(0));
    for more in list {
        reader.pay(2 * sum.entries.len(), sum.bits(), more.bits())?;
        let turned = Matrix::from_fn(more.rows, more.cols, more.denominator.clone(), |i, j| -more.at(i, j));
        sum = sum.minus(&turned);
    }
    sum.denominator *= list.len();
    Ok(sum)
}

/// The flows of the stretches.
fn flows(reader: &mut Reader, system: &System) -> Result<Walked, Refusal> {
    let count = reader.count("stretches", 1, MOST_STRETCHES)?;
    let (mut flows, mut order, mut all): (Vec<Flow>, Vec<usize>, usize) = (Vec::new(), Vec::new(), 0);
    for _ in 0..count {
        let mode = reader.count("mode", 1, system.modes.len())? - 1;
        let time = reader.fraction("time")?;
        reader.require(time.is_positive(), "a time is not positive")?;
        let steps = reader.count("steps", 1, MOST_STEPS)?;
        all += steps;
        reader.require(all <= MOST_STEPS, "there are too many steps")?;
        let time = (time.numerator, time.denominator);
        let known = flows.iter().position(|flow| (flow.mode, &flow.time, flow.steps) == (mode, &time, steps));
        order.push(known.unwrap_or(flows.len()));
        if known.is_none() {
            let (a, columns) = augmented(reader, system, mode)?;
            flows.push(Flow::new(reader, mode, a, columns, time, steps)?);
        }
    }
    Ok((flows, order, Vec::new()))
}

/// The middle and the radius of the start, of inputs that keep one value too.
fn start(reader: &mut Reader, system: &System) -> Result<[Vector; 2], Refusal> {
    let mut parts = [Vec::new(), Vec::new()];
    let (states, kept) = (system.states, (0..system.kept.len()).filter(|&j| system.is_kept(j)));
    let all =
        (0..states).map(|i| (&system.start, i)).chain(kept.flat_map(|j| system.limits.iter().map(move |l| (l, j))));
    for ([least, most], j) in all {
        reader.pay(8, least.bits(), most.bits() + SCALE)?;
        let (least_j, most_j) = (least.at(0, j) * &most.denominator, most.at(0, j) * &least.denominator);
        reader.require(least_j <= most_j, "a start or an input has no values")?;
        let twice = &least.denominator * &most.denominator * 2;
        parts[0].push(((&least_j + &most_j) << SCALE) / &twice);
        parts[1].push(up((most_j - least_j) << SCALE, &twice));
    }
    let error = BigInt::from(1);
    Ok(parts.map(|entries| Vector { entries, error: error.clone() }))
}

/// The largest bound of a row, or of its absolute value, at all nodes.
fn nodes(
    reader: &mut Reader,
    row: &Matrix,
    flows: &[Flow],
    order: &[usize],
    (start, ever): (&[Vector; 2], Option<&Ever>),
    absolute: bool,
) -> Result<BigInt, Refusal> {
    let mut most: Option<BigInt> = None;
    for (k, &last) in order.iter().enumerate() {
        let flow = &flows[last];
        let costates = flow.costates(reader, row)?;
        let sums = flow.sums(reader, &costates[0], flow.steps, true)?;
        for (i, (p, sum)) in costates.into_iter().zip(sums).enumerate() {
            let (mut p, mut sum) = (p, sum);
            for &earlier in order[..k].iter().rev() {
                let flow = &flows[earlier];
                for more in flow.sums(reader, &p, flow.steps, false)? {
                    sum = sum.plus(&more);
                }
                p = flow.whole.applied(reader, &p, SCALE)?;
            }
            let far =
                if order.len() == 1 { i == flow.steps } else { ever.is_some_and(|own| k + own.cycle >= order.len()) };
            for start in [Some(start), ever.filter(|_| far).map(|ever| &ever.start)].into_iter().flatten() {
                let value = started(reader, &p, start, sum.clone(), absolute)?;
                if most.as_ref().is_none_or(|most| value > *most) {
                    most = Some(value);
                }
            }
        }
    }
    Ok(most.unwrap_or_default())
}

/// The bound with the worst start, over `2^SCALE`.
fn started(
    reader: &mut Reader,
    p: &Vector,
    [middle, radius]: &[Vector; 2],
    sum: Sum,
    absolute: bool,
) -> Result<BigInt, Refusal> {
    let n = p.entries.len();
    reader.pay(4 * n, bits(&p.entries), bits(&middle.entries).max(bits(&radius.entries)))?;
    let centre: BigInt = p.entries.iter().zip(&middle.entries).map(|(p, x)| p * x).sum::<BigInt>() + sum.middle;
    let reach: BigInt = p.entries.iter().zip(&radius.entries).map(|(y, x)| (size(y) + &p.error) * x).sum();
    let off = &p.error * (sizes(&middle.entries) + BigInt::from(n)) + sizes(&p.entries);
    let centre = if absolute { size(&centre) } else { centre };
    Ok(((centre + reach + off + sum.radius) >> SCALE) + 1)
}

impl Square {
    /// The matrix times a vector, both over `2^scale`.
    fn applied(&self, reader: &mut Reader, v: &Vector, scale: u64) -> Result<Vector, Refusal> {
        let n = v.entries.len();
        let longest = self.rows.iter().map(bits).max().unwrap_or(0);
        reader.pay(n * n + 4 * n, bits(&v.entries).max(v.error.bits()), longest.max(self.error.bits()))?;
        let entry = |row: &Vec<BigInt>| row.iter().zip(&v.entries).map(|(a, x)| a * x).sum::<BigInt>() >> scale;
        let widest = self.rows.iter().map(sizes).max().unwrap_or_default();
        let error = widest * &v.error + sizes(&v.entries) * &self.error + &v.error * &self.error * BigInt::from(n);
        Ok(Vector { entries: self.rows.iter().map(entry).collect(), error: shift(error, scale) + 1 })
    }
}

impl Vector {
    /// With fewer bits.
    fn rounded(&self, from: u64) -> Vector {
        let entries = self.entries.iter().map(|x| x >> (from - SCALE)).collect();
        Vector { entries, error: shift(self.error.clone(), from - SCALE) + 1 }
    }
}

/// A row of numbers over one denominator.
fn fixed(row: &Matrix, scale: u64) -> Vector {
    let entries = row.entries.iter().map(|x| (x << scale) / &row.denominator).collect();
    Vector { entries, error: BigInt::from(1) }
}

impl Flow {
    fn new(
        reader: &mut Reader,
        mode: usize,
        a: Matrix,
        outputs: Vec<Matrix>,
        time: (BigInt, BigInt),
        steps: usize,
    ) -> Result<Self, Refusal> {
        let n = a.rows;
        reader.pay(2 * n, a.bits(), time.0.bits().max(time.1.bits()))?;
        let norm = (0..n).map(|i| sizes(a.row(i))).max().unwrap_or_default();
        let short = &norm * 2 * &time.0 <= &a.denominator * &time.1 * steps;
        reader.require(short, "the steps are too long")?;
        // Bits for the errors, which grow by e^(|A| h) in a step; they are counted, so that too few of them refuse but do not err.
        let columns = (0..n).map(|j| sizes((0..n).map(|i| a.at(i, j)))).max().unwrap_or_default();
        let growth = norm.max(columns) * 3 * &time.0 / (&a.denominator * &time.1 * 2);
        let growth = u64::try_from(&growth).unwrap_or(u64::MAX).min(2 * steps as u64);
        let square = reader.times(&a, &a)?;
        let cube = reader.times(&square, &a)?;
        let fine = 2 * SCALE + growth;
        let stretch =
            Stretch { m: Matrix { entries: a.entries.clone(), denominator: a.denominator.clone(), ..a }, time, steps };
        // Columns of e^(A h), which are the rows of its transpose.
        let (mut unit, mut error) = (Vec::new(), BigInt::from(0));
        for j in 0..n {
            let mut y: Vec<BigInt> = (0..n).map(|i| BigInt::from(i == j) << fine).collect();
            let mut own = BigInt::from(0);
            step(reader, &stretch, &mut y, &mut own)?;
            unit.push(y);
            error = error.max(own);
        }
        let unit = Square { rows: unit, error };
        let turned = Square {
            rows: (0..n).map(|i| unit.rows.iter().map(|column| column[i].clone()).collect()).collect(),
            error: unit.error.clone(),
        };
        let carried = |reader: &mut Reader, from: Vector, by: &Square| -> Result<Vec<Vector>, Refusal> {
            let (mut list, mut v) = (vec![from.rounded(fine)], from);
            for _ in 0..steps {
                v = by.applied(reader, &v, fine)?;
                list.push(v.rounded(fine));
            }
            Ok(list)
        };
        let mut nodes = Vec::new();
        // The first is d, whose sign counts; others that are zero say nothing.
        for output in outputs.iter().enumerate().filter(|(k, output)| *k == 0 || !output.is_zero()).map(|x| x.1) {
            nodes.push(carried(reader, fixed(output, fine), &turned)?);
        }
        // Columns of e^(A time): rows of its transpose.
        let (mut rows, mut error) = (Vec::new(), BigInt::from(0));
        for j in 0..n {
            if let Some(column) = carried(reader, fixed(&self::unit(j, n), fine), &turned)?.pop() {
                error = error.max(column.error);
                rows.push(column.entries);
            }
        }
        let whole = Square { rows, error };
        let Stretch { m: a, time, .. } = stretch;
        let mut flow = Flow {
            mode,
            time,
            steps,
            a,
            square,
            cube,
            nodes,
            widths: Vec::new(),
            bends: Vec::new(),
            unit,
            fine,
            whole,
        };
        flow.widths = (0..=steps).map(|i| flow.width(i)).collect();
        flow.bends = flow.bends(reader)?;
        Ok(flow)
    }

    /// The length of a step.
    fn length(&self) -> (BigInt, BigInt) {
        (self.time.0.clone(), &self.time.1 * self.steps)
    }

    /// Bounds of `|m v|` for a vector over `2^SCALE`.
    fn sizes_of(reader: &mut Reader, m: &Matrix, v: &Vector) -> Result<Vec<BigInt>, Refusal> {
        let n = m.rows;
        reader.pay(n * n + 2 * n, m.bits(), bits(&v.entries))?;
        let entry = |i: usize| {
            let row = m.row(i);
            let value: BigInt = row.iter().zip(&v.entries).map(|(a, x)| a * x).sum();
            up(size(&value) + sizes(row) * &v.error, &m.denominator)
        };
        Ok((0..n).map(entry).collect())
    }

    fn width(&self, i: usize) -> (BigInt, BigInt) {
        let at = || self.nodes.iter().map(|output| &output[i]);
        let more = BigInt::from(self.a.rows);
        (at().map(|v| &v.error).sum(), at().map(|v| sizes(&v.entries) + &v.error * &more).sum())
    }

    fn bends(&self, reader: &mut Reader) -> Result<Vec<Vec<BigInt>>, Refusal> {
        let h = self.length();
        let mut sums = vec![vec![BigInt::from(0); self.a.rows]];
        for i in 0..self.steps {
            let mut sum = sums[i].clone();
            for output in &self.nodes {
                let bend = Self::sizes_of(reader, &self.square, &output[i])?;
                let more = Self::sizes_of(reader, &self.cube, &output[i])?.into_iter().max().unwrap_or_default();
                let more = up(grown(more) * &h.0, &h.1);
                sum.iter_mut().zip(bend).for_each(|(sum, bend)| *sum += bend + &more);
            }
            sums.push(sum);
        }
        Ok(sums)
    }

    /// A row times `e^(A h i)`.
    fn costates(&self, reader: &mut Reader, row: &Matrix) -> Result<Vec<Vector>, Refusal> {
        let mut v = fixed(row, self.fine);
        let mut list = vec![v.rounded(self.fine)];
        for _ in 0..self.steps {
            v = self.unit.applied(reader, &v, self.fine)?;
            list.push(v.rounded(self.fine));
        }
        Ok(list)
    }

    /// The integral over so many steps, or over each number of steps up to that.
    fn sums(&self, reader: &mut Reader, p: &Vector, steps: usize, each: bool) -> Result<Vec<Sum>, Refusal> {
        let n = p.entries.len();
        let longest = self.nodes.iter().flatten().map(|v| bits(&v.entries)).max().unwrap_or(0);
        let products = (self.nodes.len() + 1) * (steps + 1) * n;
        reader.pay(products, bits(&p.entries), longest)?;
        let (h, width) = (self.length(), sizes(&p.entries));
        // p d and sum |p b| at a node.
        let at = |i: usize| {
            let (errors, values) = &self.widths[i];
            let mut sum = Sum { middle: BigInt::from(0), radius: errors * &width + &p.error * values };
            for (k, output) in self.nodes.iter().enumerate() {
                let value: BigInt = p.entries.iter().zip(&output[i].entries).map(|(p, x)| p * x).sum();
                if k == 0 { sum.middle += value } else { sum.radius += size(&value) }
            }
            sum
        };
        let mut sums = Vec::new();
        let mut twice = Sum::zero();
        let mut before = at(0);
        for i in 0..=steps {
            if i > 0 {
                let next = at(i);
                twice.middle += &before.middle + &next.middle;
                twice.radius += &before.radius + &next.radius;
                before = next;
            }
            if !each && i < steps {
                continue;
            }
            // h/2 of the sum, and h^3/12 |p| of the bends.
            let bend: BigInt = p.entries.iter().zip(&self.bends[i]).map(|(y, b)| (size(y) + &p.error) * b).sum();
            let bend = up(bend * &h.0 * &h.0 * &h.0, &(&h.1 * &h.1 * &h.1 * 12));
            let middle = &twice.middle * &h.0 / (&h.1 * 2);
            sums.push(Sum { middle, radius: up(&twice.radius * &h.0, &(&h.1 * 2)) + bend + 1 });
        }
        Ok(sums)
    }

    /// What a row gains between two nodes: by so much of each state, and by so much more.
    fn between(&self, reader: &mut Reader, row: &Matrix) -> Result<(Vec<BigInt>, BigInt), Refusal> {
        let h = self.length();
        let eighth = |x: BigInt| up(x * &h.0 * &h.0, &(&h.1 * &h.1 * 8));
        let over_step = |x: BigInt| up(grown(x) * &h.0, &h.1);
        let [first, second, third] =
            [reader.times(row, &self.a)?, reader.times(row, &self.square)?, reader.times(row, &self.cube)?];
        let scaled = |x: BigInt, m: &Matrix| up(x << SCALE, &m.denominator);
        let further = over_step(scaled(sizes(&third.entries), &third));
        let shares = second.entries.iter().map(|x| eighth(scaled(size(x), &second) + &further)).collect();
        let mut rest = BigInt::from(0);
        for output in &self.nodes {
            let v = &output[0];
            rest += Self::sizes_of(reader, &first, v)?.into_iter().sum::<BigInt>();
            let largest = v.entries.iter().map(size).max().unwrap_or_default() + &v.error;
            let further = up(sizes(&second.entries) * largest, &second.denominator);
            rest += over_step(further);
        }
        Ok((shares, eighth(rest)))
    }
}

/// `A` with inputs that keep one value as states, `d`, and the columns `b`.
fn augmented(reader: &mut Reader, system: &System, mode: usize) -> Result<(Matrix, Vec<Matrix>), Refusal> {
    let mode = &system.modes[mode];
    let kept: Vec<usize> = (0..system.kept.len()).filter(|&j| system.is_kept(j)).collect();
    let (n, order) = (system.states, system.states + kept.len());
    let zero = || BigInt::from(0);
    let mut drift =
        Matrix::from_fn(
            1,
            order,
            mode.c.denominator.clone(),
            |_, i| {
                if i < n { mode.c.at(0, i).clone() } else { zero() }
            },
        );
    let mut columns = Vec::new();
    let mut a = Matrix::from_fn(order, order, mode.a.denominator.clone(), |i, j| {
        if i < n && j < n { mode.a.at(i, j).clone() } else { zero() }
    });
    if let (Some(b), Some([least, most])) = (&mode.b, &system.limits) {
        reader.pay(4 * order * (order + system.kept.len()), b.bits() + mode.a.bits(), least.bits() + most.bits())?;
        a = Matrix::from_fn(order, order, &mode.a.denominator * &b.denominator, |i, j| match (i < n, j < n) {
            (true, true) => mode.a.at(i, j) * &b.denominator,
            (true, false) => b.at(i, kept[j - n]) * &mode.a.denominator,
            _ => zero(),
        });
        let twice = &least.denominator * &most.denominator * 2;
        for j in (0..system.kept.len()).filter(|&j| !system.is_kept(j)) {
            let (low, high) = (least.at(0, j) * &most.denominator, most.at(0, j) * &least.denominator);
            reader.require(low <= high, "a start or an input has no values")?;
            let column =
                |factor: BigInt| {
                    Matrix::from_fn(1, order, &b.denominator * &twice, |_, i| {
                        if i < n { b.at(i, j) * &factor } else { zero() }
                    })
                };
            drift = drift.minus(&column(-(&low + &high)));
            reader.pay(4 * order, drift.bits(), b.bits())?;
            columns.push(column(high - low));
        }
    }
    columns.insert(0, drift);
    Ok((a, columns))
}
