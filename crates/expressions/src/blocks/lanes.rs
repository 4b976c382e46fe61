//! What is done with the lanes of registers: loops that the compiler makes vectors of.

use super::code::{Body, Instruction, Register};
use crate::function::Function;
use crate::syntax::Relation;
use arithmetic::Number;
use motion::sin_cos_of;
use pulp::{Simd, WithSimd};

/// Most lanes of a block.
pub(super) const BLOCK: usize = 256;

/// What the lanes of a register hold.
#[derive(Debug, Clone, Copy)]
pub(super) enum Source {
    /// The same number in every lane; it stands in the first one.
    Same,
    /// Numbers of its own.
    Own,
    /// Those of a column, from an agent on.
    Column(usize, usize),
}

/// The registers of a level.
#[derive(Debug, Clone)]
pub(super) struct Registers {
    numbers: Vec<f64>,
    sources: Vec<Source>,
}

/// The lanes of a register.
#[derive(Debug, Clone, Copy)]
pub(super) enum View<'a> {
    Same(f64),
    Each(&'a [f64]),
}

impl View<'_> {
    pub fn at(&self, lane: usize) -> f64 {
        match self {
            View::Same(x) => *x,
            View::Each(list) => list[lane],
        }
    }
}

impl Registers {
    pub fn new(count: usize) -> Self {
        Registers { numbers: vec![0.0; count * BLOCK], sources: vec![Source::Same; count] }
    }

    pub fn view<'a>(&'a self, register: Register, lanes: usize, columns: &'a [Vec<f64>]) -> View<'a> {
        view(&self.numbers, &self.sources, register, lanes, columns)
    }

    /// The same number in every lane.
    pub fn set_same(&mut self, register: Register, x: f64) {
        self.numbers[register * BLOCK] = x;
        self.sources[register] = Source::Same;
    }

    pub fn set_column(&mut self, register: Register, column: usize, from: usize) {
        self.sources[register] = Source::Column(column, from);
    }

    /// Room for numbers of its own.
    pub fn own(&mut self, register: Register, lanes: usize) -> &mut [f64] {
        self.sources[register] = Source::Own;
        &mut self.numbers[register * BLOCK..][..lanes]
    }
}

#[inline(always)]
fn view<'a>(
    numbers: &'a [f64],
    sources: &[Source],
    register: Register,
    lanes: usize,
    columns: &'a [Vec<f64>],
) -> View<'a> {
    match sources[register] {
        Source::Same => View::Same(numbers[register * BLOCK]),
        Source::Own => View::Each(&numbers[register * BLOCK..][..lanes]),
        Source::Column(column, from) => View::Each(&columns[column][from..from + lanes]),
    }
}

/// Instructions that are done one after the other.
pub(super) struct Straight<'a> {
    pub instructions: &'a [(Register, Instruction)],
    pub registers: &'a mut Registers,
    pub lanes: usize,
    pub columns: &'a [Vec<f64>],
}

impl WithSimd for Straight<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Straight { instructions, registers: Registers { numbers, sources }, lanes, columns } = self;
        for &(to, instruction) in instructions {
            // Operands have smaller numbers.
            let (below, above) = numbers.split_at_mut(to * BLOCK);
            let out = &mut above[..lanes];
            let of = |register| view(below, sources, register, lanes, columns);
            sources[to] = done(instruction, out, of);
        }
    }
}

/// Truth as a number.
#[inline(always)]
fn truth(holds: bool) -> f64 {
    if holds { 1.0 } else { 0.0 }
}

/// A comparison, which has no value where one of the two has none.
#[inline(always)]
fn compared(a: f64, b: f64, holds: bool) -> f64 {
    if a.is_nan() | b.is_nan() { f64::NAN } else { truth(holds) }
}

#[inline(always)]
fn done<'a>(instruction: Instruction, out: &mut [f64], of: impl Fn(Register) -> View<'a>) -> Source {
    match instruction {
        Instruction::Negated(a) => one(out, of(a), |a| -a),
        Instruction::Sum(a, b) => two(out, of(a), of(b), |a, b| a + b),
        Instruction::Difference(a, b) => two(out, of(a), of(b), |a, b| a - b),
        Instruction::Product(a, b) => two(out, of(a), of(b), |a, b| a * b),
        Instruction::Quotient(a, b) => two(out, of(a), of(b), |a, b| if b == 0.0 { f64::NAN } else { a / b }),
        Instruction::Root(a) => one(out, of(a), f64::sqrt),
        Instruction::Of(function, a) => function_of(function, out, of(a)),
        Instruction::Angle(y, x) => two(out, of(y), of(x), |y, x| f64::angle(&y, &x).unwrap_or(f64::NAN)),
        Instruction::Absolute(a) => one(out, of(a), f64::abs),
        Instruction::Larger(a, b) => two(out, of(a), of(b), |a, b| if b.is_nan() | (a < b) { b } else { a }),
        Instruction::Smaller(a, b) => two(out, of(a), of(b), |a, b| if b.is_nan() | (a > b) { b } else { a }),
        Instruction::Choice(c, a, b) => three(out, (of(c), of(a), of(b)), |c, a, b| {
            let chosen = if c == 0.0 { b } else { a };
            if c.is_nan() { c } else { chosen }
        }),
        Instruction::Compared(relation, a, b) => {
            let (a, b) = (of(a), of(b));
            match relation {
                Relation::Equal => two(out, a, b, |a, b| compared(a, b, a == b)),
                Relation::Different => two(out, a, b, |a, b| compared(a, b, a != b)),
                Relation::Less => two(out, a, b, |a, b| compared(a, b, a < b)),
                Relation::AtMost => two(out, a, b, |a, b| compared(a, b, a <= b)),
                Relation::Greater => two(out, a, b, |a, b| compared(a, b, a > b)),
                Relation::AtLeast => two(out, a, b, |a, b| compared(a, b, a >= b)),
            }
        }
        // Whatever the other one is, false decides.
        Instruction::Both(a, b) => two(out, of(a), of(b), |a, b| if (a == 0.0) | (b == 0.0) { 0.0 } else { a * b }),
        Instruction::Not(a) => one(out, of(a), |a| 1.0 - a),
        Instruction::Square(a, b) => two(out, of(a), of(b), |a, b| (a - b) * (a - b)),
        Instruction::SquareAdded(a, b, c) => three(out, (of(c), of(a), of(b)), |c, a, b| (a - b) * (a - b) + c),
        Instruction::Scaled(a, b, c) => three(out, (of(c), of(a), of(b)), |c, a, b| (a - b) * c),
        Instruction::InverseFourthRoot(c, x) => {
            let source = inverse_fourth_roots(out, of(x));
            match (of(c), source) {
                (View::Same(1.0), source) => source,
                (View::Same(c), Source::Same) => {
                    out[0] *= c;
                    Source::Same
                }
                (View::Same(c), _) => {
                    out.iter_mut().for_each(|out| *out *= c);
                    Source::Own
                }
                (View::Each(c), Source::Same) => {
                    let root = out[0];
                    out.iter_mut().zip(c).for_each(|(out, c)| *out = root * c);
                    Source::Own
                }
                (View::Each(c), _) => {
                    out.iter_mut().zip(c).for_each(|(out, c)| *out *= c);
                    Source::Own
                }
            }
        }
    }
}

#[inline(always)]
fn inverse_fourth_roots(out: &mut [f64], x: View) -> Source {
    // Beyond these powers of x and of its root leave the normal numbers.
    const ORDINARY: std::ops::Range<f64> = 1e-250..1e250;
    let slow = |x: f64| {
        let root = x.sqrt().sqrt();
        if root == 0.0 { f64::NAN } else { 1.0 / root }
    };
    match x {
        View::Same(x) => {
            out[0] = if ORDINARY.contains(&x) { inverse_fourth_root(x) } else { slow(x) };
            Source::Same
        }
        View::Each(x) => {
            let ordinary = x.iter().fold(true, |all, x| all & (*x >= ORDINARY.start) & (*x < ORDINARY.end));
            if ordinary {
                out.iter_mut().zip(x).for_each(|(out, x)| *out = inverse_fourth_root(*x));
            } else {
                let of = |x: &f64| if ORDINARY.contains(x) { inverse_fourth_root(*x) } else { slow(*x) };
                out.iter_mut().zip(x).for_each(|(out, x)| *out = of(x));
            }
            Source::Own
        }
    }
}

/// `x^(-1/4)` to 2 units in the last place, without roots and divisions: the exponent is divided by -4, which leaves `|1 - x y^4| < 0.125`; then
/// twice `y (1 - r)^(-1/4)` with `r = 1 - x y^4` up to the third power of r, whose relative errors are `195/2048 r^4 < 2.5e-5` and less than the rounding.
#[inline(always)]
fn inverse_fourth_root(x: f64) -> f64 {
    let mut y = f64::from_bits(0x4feb_020c_49ba_6000 - (x.to_bits() >> 2));
    for _ in 0..2 {
        let square = y * y;
        let r = (-x).mul_add(square * square, 1.0);
        let series = (15.0f64 / 128.0).mul_add(r, 5.0 / 32.0).mul_add(r, 0.25);
        y = (y * r).mul_add(series, y);
    }
    y
}

#[inline(always)]
fn one(out: &mut [f64], a: View, f: impl Fn(f64) -> f64) -> Source {
    match a {
        View::Same(a) => {
            out[0] = f(a);
            Source::Same
        }
        View::Each(a) => {
            out.iter_mut().zip(a).for_each(|(out, a)| *out = f(*a));
            Source::Own
        }
    }
}

#[inline(always)]
fn two(out: &mut [f64], a: View, b: View, f: impl Fn(f64, f64) -> f64) -> Source {
    match (a, b) {
        (View::Same(a), View::Same(b)) => {
            out[0] = f(a, b);
            return Source::Same;
        }
        (View::Same(a), View::Each(b)) => out.iter_mut().zip(b).for_each(|(out, b)| *out = f(a, *b)),
        (View::Each(a), View::Same(b)) => out.iter_mut().zip(a).for_each(|(out, a)| *out = f(*a, b)),
        (View::Each(a), View::Each(b)) => {
            out.iter_mut().zip(a).zip(b).for_each(|((out, a), b)| *out = f(*a, *b));
        }
    }
    Source::Own
}

#[inline(always)]
fn three(out: &mut [f64], (c, a, b): (View, View, View), f: impl Fn(f64, f64, f64) -> f64) -> Source {
    if let (View::Same(c), View::Same(a), View::Same(b)) = (c, a, b) {
        out[0] = f(c, a, b);
        return Source::Same;
    }
    match c {
        View::Same(c) => return two(out, a, b, |a, b| f(c, a, b)),
        View::Each(c) => match (a, b) {
            (View::Same(a), View::Same(b)) => out.iter_mut().zip(c).for_each(|(out, c)| *out = f(*c, a, b)),
            (View::Same(a), View::Each(b)) => {
                out.iter_mut().zip(c).zip(b).for_each(|((out, c), b)| *out = f(*c, a, *b));
            }
            (View::Each(a), View::Same(b)) => {
                out.iter_mut().zip(c).zip(a).for_each(|((out, c), a)| *out = f(*c, *a, b));
            }
            (View::Each(a), View::Each(b)) => {
                out.iter_mut().zip(c).zip(a).zip(b).for_each(|(((out, c), a), b)| *out = f(*c, *a, *b));
            }
        },
    }
    Source::Own
}

fn function_of(function: Function, out: &mut [f64], a: View) -> Source {
    let logarithm = |x: f64| if x <= 0.0 { f64::NAN } else { x.ln() };
    match (function, a) {
        (Function::Root, _) => one(out, a, f64::sqrt),
        (Function::Exponential, _) => one(out, a, f64::exp),
        (Function::Logarithm | Function::LogarithmOfBase, _) => one(out, a, logarithm),
        (Function::Sine, View::Same(_)) => one(out, a, f64::sin),
        (Function::Cosine, View::Same(_)) => one(out, a, f64::cos),
        (Function::Sine, View::Each(angles)) => {
            sin_cos_of(angles, out, &mut [0.0; BLOCK][..angles.len()]);
            Source::Own
        }
        (Function::Cosine, View::Each(angles)) => {
            sin_cos_of(angles, &mut [0.0; BLOCK][..angles.len()], out);
            Source::Own
        }
    }
}

/// The lanes of what is gathered.
#[derive(Debug, Clone, Copy)]
pub(super) enum Lanes<'a> {
    Own(View<'a>),
    /// `c (a - b)`.
    Scaled(View<'a>, View<'a>, View<'a>),
}

impl Lanes<'_> {
    pub fn at(&self, lane: usize) -> f64 {
        match self {
            Lanes::Own(view) => view.at(lane),
            Lanes::Scaled(c, a, b) => (a.at(lane) - b.at(lane)) * c.at(lane),
        }
    }
}

impl Registers {
    pub fn lanes<'a>(&'a self, body: Body, lanes: usize, columns: &'a [Vec<f64>]) -> Lanes<'a> {
        let of = |register| self.view(register, lanes, columns);
        match body {
            Body::Own(register) => Lanes::Own(of(register)),
            Body::Scaled(c, a, b) => Lanes::Scaled(of(c), of(a), of(b)),
        }
    }
}

/// Adds up lanes part by part: each part of them belongs to a lane of the level around.
pub(super) struct Sums<'a> {
    pub lanes: Lanes<'a>,
    /// Which lanes count.
    pub condition: Option<View<'a>>,
    pub parts: &'a [(usize, usize, usize)],
    pub results: &'a mut [f64],
}

impl WithSimd for Sums<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        let Sums { lanes, condition, parts, results } = self;
        for &(lane, begin, end) in parts {
            results[lane] += match lanes {
                lanes if condition.is_some() => chosen_sum(lanes, condition, (begin, end)),
                Lanes::Own(View::Same(x)) => sum_of(end - begin, |_| x),
                Lanes::Own(View::Each(list)) => sum_each([&list[begin..end]], |[x]| x),
                Lanes::Scaled(View::Each(c), View::Each(a), View::Same(b)) => {
                    sum_each([&c[begin..end], &a[begin..end]], |[c, a]| (a - b) * c)
                }
                Lanes::Scaled(View::Each(c), View::Each(a), View::Each(b)) => {
                    sum_each([&c[begin..end], &a[begin..end], &b[begin..end]], |[c, a, b]| (a - b) * c)
                }
                _ => sum_of(end - begin, |k| lanes.at(begin + k)),
            };
        }
    }
}

/// The sum of the lanes that count.
#[inline(always)]
fn chosen_sum(lanes: Lanes, condition: Option<View>, (begin, end): (usize, usize)) -> f64 {
    let chosen = |counts: f64, x: f64| if counts == 0.0 { 0.0 } else { x };
    match (condition, lanes) {
        (Some(View::Each(counts)), Lanes::Own(View::Each(list))) => {
            sum_each([&counts[begin..end], &list[begin..end]], |[counts, x]| chosen(counts, x))
        }
        (Some(counts), lanes) => sum_of(end - begin, |k| chosen(counts.at(begin + k), lanes.at(begin + k))),
        (None, lanes) => sum_of(end - begin, |k| lanes.at(begin + k)),
    }
}

/// The sum of a function of some lists: eight partial sums, whatever the processor.
#[inline(always)]
fn sum_each<const N: usize>(lists: [&[f64]; N], f: impl Fn([f64; N]) -> f64) -> f64 {
    let count = lists[0].len();
    let eights = lists.map(|list| list.as_chunks::<8>().0);
    let mut partial = [0.0; 8];
    for k in 0..count / 8 {
        let rows = eights.map(|list| list[k]);
        for (place, sum) in partial.iter_mut().enumerate() {
            *sum += f(rows.map(|row| row[place]));
        }
    }
    (count - count % 8..count).fold(together(partial), |sum, k| sum + f(lists.map(|list| list[k])))
}

/// The same for numbers by their places.
#[inline(always)]
fn sum_of(count: usize, f: impl Fn(usize) -> f64) -> f64 {
    let mut partial = [0.0; 8];
    for k in 0..count / 8 {
        partial.iter_mut().enumerate().for_each(|(place, sum)| *sum += f(8 * k + place));
    }
    (count - count % 8..count).fold(together(partial), |sum, k| sum + f(k))
}

#[inline(always)]
fn together([a, b, c, d, e, f, g, h]: [f64; 8]) -> f64 {
    ((a + e) + (b + f)) + ((c + g) + (d + h))
}

#[cfg(test)]
mod tests {
    use super::inverse_fourth_root;

    #[test]
    fn fourth_roots_are_as_exact_as_roots_of_roots() {
        let mut x = 1.1e-250;
        while x < 1e250 {
            let (y, wanted) = (inverse_fourth_root(x), 1.0 / x.sqrt().sqrt());
            assert!((y - wanted).abs() <= 4.0 * f64::EPSILON * wanted, "{x:e}: {y:e} {wanted:e}");
            x *= 1.003_7;
        }
    }
}
