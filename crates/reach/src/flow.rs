//! The adjoint flow `p' = A^T p` of one mode, backwards in time, and what it pairs with: Taylor expansions on a grid of steps, each with a proved
//! remainder.
//!
//! The powers of the flow over whole steps are computed once, by products of pairs, in a higher precision: a vector is then never carried through many
//! steps, and enclosures do not grow with their number.

use crate::prepared::Motion;
use crate::scalar::{Matrix, Scalar, apply, dot, times};
use crate::signs::Expansion;
use arithmetic::{Field, Interval, Rational, Ring, Sign, rational};
use num_traits::{Signed, ToPrimitive, Zero};
use rayon::prelude::*;

/// Steps between two entries of the coarse table.
pub(crate) const BLOCK: usize = 64;

/// Most steps of one leg.
pub(crate) const MOST_STEPS: usize = 1 << 20;

/// Order of the expansion over many steps at once.
const ROUGH: usize = 9;

/// Bits beyond those of the result, for the products of the tables.
const GUARD: u32 = 128;

/// A row that costates are paired with: the drift, or the column of an input.
pub(crate) struct Output<T> {
    pub row: Vec<T>,
    /// For an input: which one, its centre and its radius.
    pub push: Option<(usize, T, T)>,
    /// For each step of a block, from the costate at the start of the block.
    steps: Vec<StepRows<T>>,
    /// The sum of absolute values of the row.
    size: T,
}

/// What a row pairs with over a step, in units of the step.
struct StepRows<T> {
    /// The Taylor coefficients: `row (A^T step)^k / k!` after the steps before.
    taylor: Vec<Vec<T>>,
    /// The integral of the polynomial.
    integral: Vec<T>,
    /// Bounds the costate at the start of the step by that at the start of the block.
    growth: T,
}

/// A product of flows over whole legs: one leg more than its parent.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Link {
    pub parent: Option<usize>,
    pub mode: usize,
    pub duration: Rational,
}

/// The flows of all modes, and products over legs of fixed durations.
pub(crate) struct Flows<T> {
    pub modes: Vec<Flow<T>>,
    pub products: Vec<Matrix<T>>,
}

impl<T: Scalar> Flows<T> {
    /// The flows for up to the given times, one for each mode, and the products, whose legs last at most as long.
    pub fn new(motions: &[Motion], longest: &[Rational], chain: &[Link], like: &T) -> Self {
        let wide = Interval::from_rational(&Rational::ZERO, like.bits() + GUARD);
        let made: Vec<(Powers, Flow<T>)> = motions
            .par_iter()
            .zip(longest)
            .map(|(motion, longest)| {
                let powers = Powers::new(motion, longest, &wide);
                let flow = Flow::new(motion, &powers, like);
                (powers, flow)
            })
            .collect();
        let mut legs: Vec<(usize, &Rational, Matrix<Interval>)> = Vec::new();
        let mut products: Vec<Matrix<Interval>> = Vec::new();
        for link in chain {
            let known = legs.iter().position(|(mode, duration, _)| *mode == link.mode && **duration == link.duration);
            let index = known.unwrap_or_else(|| {
                legs.push((link.mode, &link.duration, made[link.mode].0.over(&link.duration)));
                legs.len() - 1
            });
            let leg = &legs[index].2;
            products.push(link.parent.map_or_else(|| leg.clone(), |parent| times(leg, &products[parent])));
        }
        let products = products.iter().map(|product| rounded(product, like)).collect();
        Flows { modes: made.into_iter().map(|(_, flow)| flow).collect(), products }
    }
}

/// `e^(A^T step i)` for `i` up to a block, and over so many blocks.
struct Powers {
    step: Rational,
    /// `A^T` and `A^T step`.
    adjoint: Matrix<Interval>,
    scaled: Matrix<Interval>,
    fine: Vec<Matrix<Interval>>,
    coarse: Vec<Matrix<Interval>>,
    links: Vec<Vec<bool>>,
    wide: Interval,
}

impl Powers {
    /// Those for up to the given time.
    fn new(motion: &Motion, longest: &Rational, wide: &Interval) -> Self {
        let n = motion.a.len();
        let columns = (0..n).map(|j| motion.a.iter().map(|row| row[j].abs()).sum::<Rational>());
        let norm = columns.max().unwrap_or_default();
        let mut step = Rational::ONE;
        let half = rational(1, 2);
        while &step * &norm > Rational::ONE {
            step *= &half;
        }
        let matrix = |scale: &Rational| -> Matrix<Interval> {
            (0..n).map(|i| (0..n).map(|j| wide.rational(&(&motion.a[j][i] * scale))).collect()).collect()
        };
        let (adjoint, scaled) = (matrix(&Rational::ONE), matrix(&step));
        let links = links(motion);
        let one_step = exponential(&scaled, &links, wide);
        let blocks = integer_below(&(longest / (&step * rational(BLOCK as i64, 1)))).min(MOST_STEPS / BLOCK);
        let fine = powers(&one_step, BLOCK, wide);
        let coarse = powers(&fine[BLOCK], blocks, wide);
        Powers { step, adjoint, scaled, fine, coarse, links, wide: wide.clone() }
    }

    /// `e^(A^T duration)`.
    fn over(&self, duration: &Rational) -> Matrix<Interval> {
        let steps = integer_below(&(duration / &self.step));
        let rest = duration / &self.step - rational(steps as i64, 1);
        let whole = times(&self.fine[steps % BLOCK], &self.coarse[steps / BLOCK]);
        if rest.is_zero() {
            return whole;
        }
        let part = self.wide.rational(&rest);
        let scaled: Matrix<Interval> =
            self.scaled.iter().map(|row| row.iter().map(|x| x.clone() * &part).collect()).collect();
        times(&exponential(&scaled, &self.links, &self.wide), &whole)
    }
}

fn rounded<T: Scalar>(matrix: &Matrix<Interval>, like: &T) -> Matrix<T> {
    matrix.iter().map(|row| row.iter().map(|x| like.of(x)).collect()).collect()
}

/// The flow of one mode.
pub(crate) struct Flow<T> {
    /// Length of a step, a power of two.
    pub step: Rational,
    pub step_scalar: T,
    /// `e^(A^T step i)` for `i` up to a block, and over so many blocks.
    fine: Vec<Matrix<T>>,
    coarse: Vec<Matrix<T>>,
    /// `A^T`.
    pub adjoint: Matrix<T>,
    /// `A^T step`.
    scaled: Matrix<T>,
    /// The drift, then the inputs.
    pub outputs: Vec<Output<T>>,
    /// Bounds what follows the last Taylor coefficient, for up to two steps.
    remainder: T,
    /// The same after the short expansion.
    rough: T,
    order: usize,
    /// Whether the derivative of the costate of one state can ever depend on that of another: `links[j][i]`.
    links: Vec<Vec<bool>>,
}

fn integer_below(q: &Rational) -> usize {
    q.floor().to_integer().to_usize().unwrap_or(usize::MAX)
}

impl<T: Scalar> Flow<T> {
    /// The flow for up to the time of the powers.
    fn new(motion: &Motion, powers: &Powers, like: &T) -> Self {
        let order = taylor_order(like.bits());
        let tables = |list: &[Matrix<Interval>]| list.iter().map(|m| rounded(m, like)).collect::<Vec<_>>();
        let mut flow = Flow {
            step_scalar: like.rational(&powers.step),
            step: powers.step.clone(),
            fine: tables(&powers.fine),
            coarse: tables(&powers.coarse),
            adjoint: rounded(&powers.adjoint, like),
            scaled: rounded(&powers.scaled, like),
            outputs: Vec::new(),
            remainder: remainder(order, like),
            rough: remainder(ROUGH.min(order), like),
            order,
            links: powers.links.clone(),
        };
        if motion.drift.iter().any(|x| !x.is_zero()) {
            flow.outputs.push(Output::new(&motion.drift, None, &flow, powers));
        }
        for push in &motion.pushes {
            let range = (push.input, like.rational(&push.centre), like.rational(&push.radius));
            flow.outputs.push(Output::new(&push.column, Some(range), &flow, powers));
        }
        flow
    }

    /// How many whole steps are in a duration.
    pub fn whole_steps(&self, duration: &Rational) -> usize {
        integer_below(&(duration / &self.step))
    }

    /// The costate at the start of a block.
    pub fn block(&self, index: usize, p: &[T]) -> Vec<T> {
        apply(&self.coarse[index], p)
    }

    /// The costate after so many steps.
    fn after(&self, steps: usize, p: &[T]) -> Vec<T> {
        let block = self.block(steps / BLOCK, p);
        if steps.is_multiple_of(BLOCK) { block } else { apply(&self.fine[steps % BLOCK], &block) }
    }

    /// `e^(A^T step part) p` for a part of a step, at most two.
    fn partly(&self, part: &T, p: &[T], order: usize) -> Vec<T> {
        if part.sign() == Some(Sign::Zero) {
            return p.to_vec();
        }
        let remainder = self.remainder_after(order);
        let mut sum = p.to_vec();
        let mut term = p.to_vec();
        for k in 1..=order {
            let over = part.clone() * part.ratio(1, k as i64);
            term = apply(&self.scaled, &term).into_iter().map(|x| x * &over).collect();
            for (s, x) in sum.iter_mut().zip(&term) {
                *s = s.clone() + x;
            }
        }
        let rest = T::symmetric(&(remainder.clone() * largest(p)));
        // What cannot depend on anything that is not zero stays exactly what it is.
        sum.into_iter().enumerate().map(|(j, x)| if self.moves(j, p) { x + &rest } else { x }).collect()
    }

    /// Everything that the costate is at durations from `from` to `to`.
    pub fn over(&self, from: &Rational, to: &Rational, p: &[T]) -> Vec<T> {
        let part = |step: usize, a: &Rational, b: &Rational, order: usize| {
            let before = rational(step as i64, 1);
            self.partly(
                &p[0].around(&(a / &self.step - &before), &(b / &self.step - &before)),
                &self.after(step, p),
                order,
            )
        };
        let (first, last) = (self.whole_steps(from), self.whole_steps(to));
        if last <= first + 1 {
            return part(first, from, to, self.order);
        }
        // Over many steps the hull is wide, and a short expansion will do.
        let rough = ROUGH.min(self.order);
        let mut hull = part(first, from, &(&self.step * rational(first as i64 + 1, 1)), rough);
        for step in first + 1..=last {
            let start = &self.step * rational(step as i64, 1);
            let end = (&start + &self.step).min(to.clone());
            for (x, y) in hull.iter_mut().zip(part(step, &start, &end, rough)) {
                *x = x.joined(&y);
            }
        }
        hull
    }

    /// What an output pairs with over a step of a block, from the costate at the start of the block; exactly zero where nothing can depend on it.
    pub fn expansion(&self, output: &Output<T>, step: usize, p: &Start<T>) -> Expansion<T> {
        self.expanded(output, step, p, self.order)
    }

    /// The same to a low order, which often has a sign already.
    pub fn short(&self, output: &Output<T>, step: usize, p: &Start<T>) -> Expansion<T> {
        self.expanded(output, step, p, ROUGH.min(self.order))
    }

    fn expanded(&self, output: &Output<T>, step: usize, p: &Start<T>, order: usize) -> Expansion<T> {
        let zero = self.step_scalar.zero();
        if !self.touches(output, &p.costate) {
            return Expansion { coefficients: vec![zero.clone()], error: zero };
        }
        let rows = &output.steps[step].taylor[..=order];
        let coefficients = rows.iter().map(|row| dot(row, &p.costate, &zero)).collect();
        Expansion { coefficients, error: self.error(output, step, p, self.remainder_after(order)) }
    }

    fn remainder_after(&self, order: usize) -> &T {
        if order == self.order { &self.remainder } else { &self.rough }
    }

    /// The integral over a whole step of a block.
    pub fn integral(&self, output: &Output<T>, step: usize, p: &Start<T>) -> T {
        let zero = self.step_scalar.zero();
        if !self.touches(output, &p.costate) {
            return zero;
        }
        dot(&output.steps[step].integral, &p.costate, &zero)
            + T::symmetric(&self.error(output, step, p, &self.remainder))
    }

    /// Bounds what a remainder adds over a step.
    fn error(&self, output: &Output<T>, step: usize, p: &Start<T>, remainder: &T) -> T {
        if !output.row.iter().enumerate().any(|(j, y)| !is_zero(y) && self.moves(j, &p.costate)) {
            return self.step_scalar.zero();
        }
        (remainder.clone() * &output.size * &output.steps[step].growth * &p.size).top()
    }

    /// Bounds what an output pairs with over a step: within the step the costate grows by less than `e`.
    pub fn size(&self, output: &Output<T>, step: usize, p: &Start<T>) -> f64 {
        output.size.largest() * output.steps[step].growth.largest() * p.size.largest() * 2.72
    }

    fn touches(&self, output: &Output<T>, p: &[T]) -> bool {
        output.row.iter().enumerate().any(|(j, y)| !is_zero(y) && (!is_zero(&p[j]) || self.moves(j, p)))
    }

    /// Whether the costate of a state may change.
    fn moves(&self, j: usize, p: &[T]) -> bool {
        p.iter().zip(&self.links[j]).any(|(x, linked)| *linked && !is_zero(x))
    }
}

/// A costate at the start of a block, with its largest absolute value.
#[derive(Debug, Clone)]
pub(crate) struct Start<T> {
    pub costate: Vec<T>,
    size: T,
}

impl<T: Scalar> Start<T> {
    pub fn new(costate: Vec<T>) -> Self {
        let size = largest(&costate);
        Start { costate, size }
    }
}

/// One over the first integers.
fn inverses<T: Scalar>(order: usize, like: &T) -> Vec<T> {
    (0..=order as i64).map(|k| like.ratio(1, k + 1)).collect()
}

impl<T: Scalar> Output<T> {
    fn new(
        row: &[Rational],
        push: Option<(usize, T, T)>,
        flow: &Flow<T>,
        Powers { scaled, wide, .. }: &Powers,
    ) -> Self {
        let like = &flow.step_scalar;
        let mut term: Vec<Interval> = row.iter().map(|q| wide.rational(q)).collect();
        let mut taylor = Vec::new();
        for k in 0..=flow.order {
            taylor.push(term.iter().map(|x| like.of(x)).collect::<Vec<T>>());
            // The row times the matrix, over k + 1.
            let over = wide.ratio(1, k as i64 + 1);
            let entry = |j: usize| term.iter().zip(scaled).fold(wide.zero(), |sum, (x, row)| sum + x.clone() * &row[j]);
            term = (0..row.len()).map(|j| entry(j) * &over).collect();
        }
        let inverses = inverses(flow.order, like);
        let steps = flow.fine[..BLOCK].iter().map(|fine| StepRows::new(&taylor, fine, &inverses)).collect();
        let size = like.rational(&row.iter().map(|q| q.abs()).sum());
        Output { row: row.iter().map(|q| like.rational(q)).collect(), push, steps, size }
    }
}

impl<T: Scalar> StepRows<T> {
    fn new(taylor: &[Vec<T>], fine: &Matrix<T>, inverses: &[T]) -> Self {
        let zero = inverses[0].zero();
        let n = fine.len();
        let times = |row: &Vec<T>| -> Vec<T> {
            (0..n)
                .map(|j| row.iter().zip(fine).fold(zero.clone(), |sum, (x, fine)| sum + x.clone() * &fine[j]))
                .collect()
        };
        let taylor: Vec<Vec<T>> = taylor.iter().map(times).collect();
        let integral = (0..n)
            .map(|j| taylor.iter().zip(inverses).fold(zero.clone(), |sum, (row, over)| sum + row[j].clone() * over));
        let growth = fine.iter().map(|row| row.iter().fold(zero.clone(), |sum, x| sum + x.magnitude()));
        let growth = growth.fold(zero.clone(), |most, x| most.joined(&x).top());
        StepRows { integral: integral.collect(), growth, taylor }
    }
}

/// The largest absolute value.
fn largest<T: Scalar>(p: &[T]) -> T {
    p.iter().fold(p[0].zero(), |most, x| most.joined(&x.magnitude()).top())
}

/// The order after which a step of norm at most 1, or two of them, leave less than the last bit.
fn taylor_order(bits: u32) -> usize {
    let mut order = 1;
    // log2 of 2^(k+1) / (k+1)!, with room.
    let mut size = 1.0;
    while size > -f64::from(bits) - 4.0 {
        order += 1;
        size += 1.0 - (order as f64).log2();
    }
    order
}

/// `sum_(k > order) 2^k / k! <= 2^(order + 1) / (order + 1)! * 1 / (1 - 2 / (order + 2))`, the norm of a step being at most 1.
fn remainder<T: Scalar>(order: usize, like: &T) -> T {
    let mut bound = Rational::ONE;
    for k in 1..=order as i64 + 1 {
        bound *= rational(2, k);
    }
    like.rational(&(bound * rational(order as i64 + 2, order as i64))).top()
}

/// The exponential of a matrix whose rows have absolute sums of at most 1.
fn exponential(scaled: &Matrix<Interval>, links: &[Vec<bool>], wide: &Interval) -> Matrix<Interval> {
    let n = scaled.len();
    let identity: Matrix<Interval> =
        (0..n).map(|i| (0..n).map(|j| wide.integer(i64::from(i == j))).collect()).collect();
    let order = taylor_order(wide.precision());
    let (mut sum, mut term) = (identity.clone(), identity);
    for k in 1..=order {
        let over = wide.ratio(1, k as i64);
        term = times(&term, scaled).into_iter().map(|row| row.into_iter().map(|x| x * &over).collect()).collect();
        for (row, added) in sum.iter_mut().zip(&term) {
            for (x, y) in row.iter_mut().zip(added) {
                *x = x.clone() + y;
            }
        }
    }
    let rest = Interval::symmetric(&remainder(order, wide));
    let entry = |(x, linked): (Interval, &bool)| if *linked { x + &rest } else { x };
    sum.into_iter().zip(links).map(|(row, links)| row.into_iter().zip(links).map(entry).collect()).collect()
}

/// The derivatives of which costates can depend on which, through any number of others.
fn links(motion: &Motion) -> Vec<Vec<bool>> {
    let n = motion.a.len();
    let mut links: Vec<Vec<bool>> = (0..n).map(|j| (0..n).map(|i| !motion.a[i][j].is_zero()).collect()).collect();
    for k in 0..n {
        let through = links[k].clone();
        for row in links.iter_mut().filter(|row| row[k]) {
            for (x, y) in row.iter_mut().zip(&through) {
                *x |= y;
            }
        }
    }
    links
}

fn is_zero<T: Scalar>(x: &T) -> bool {
    x.sign() == Some(Sign::Zero)
}

/// The powers up to the given one, each from two of half its exponent.
fn powers(one: &Matrix<Interval>, most: usize, wide: &Interval) -> Vec<Matrix<Interval>> {
    let n = one.len();
    let identity = (0..n).map(|i| (0..n).map(|j| wide.integer(i64::from(i == j))).collect()).collect();
    let mut powers: Vec<Matrix<Interval>> = vec![identity];
    for k in 1..=most {
        powers.push(if k == 1 { one.clone() } else { times(&powers[k / 2], &powers[k - k / 2]) });
    }
    powers
}
