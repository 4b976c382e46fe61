//! What is done with the lanes of registers: loops that the compiler makes vectors of.

use super::code::{Instruction, Register};
use crate::function::Function;
use crate::syntax::Relation;
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
        Instruction::Angle(y, x) => {
            two(out, of(y), of(x), |y, x| if y == 0.0 && x == 0.0 { f64::NAN } else { y.atan2(x) })
        }
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
    }
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
        (Function::Logarithm, _) => one(out, a, logarithm),
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

/// The sum of some lanes: eight partial sums, whatever the processor.
pub(super) fn sum(lanes: &[f64]) -> f64 {
    let (eights, rest) = lanes.as_chunks::<8>();
    let mut partial = [0.0; 8];
    for eight in eights {
        partial.iter_mut().zip(eight).for_each(|(sum, x)| *sum += x);
    }
    let [a, b, c, d, e, f, g, h] = partial;
    let all = ((a + e) + (b + f)) + ((c + g) + (d + h));
    rest.iter().fold(all, |sum, x| sum + x)
}
