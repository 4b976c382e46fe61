//! The largest value of a quotient of polynomials on the half line, enclosed: branch and bound in exact arithmetic.
//!
//! For `h = p/q` with `deg p <= deg q = d` and `q > 0` on `[0, inf)`. The half line is the image of two pieces `0 <= t <= 1`, by
//! `x = X t` and by `x = X/t`. In Bernstein's basis of degree `d` the values of `p - L q` lie between the least and the largest
//! coefficient: where no coefficient `p_i - L q_i` is positive, `h <= L` on the whole piece. A piece for which that is not known is halved
//! (de Casteljau, over the integers), the one with the largest `max p_i/q_i` first; each middle is a value of `h` and may raise `L`.
//!
//! With `t = y/(1 + y)` both are polynomials in `y > 0`, with the coefficients `C(d, i) p_i`, and `h'` has the sign of `k = p' q - p q'`. By
//! Descartes' rule of signs there is no critical point inside a piece if no two of the coefficients of `k` have different signs, so that the
//! largest value is at one of the ends, where it was looked at; and exactly one, simple, if there is one change of sign. That one is
//! a root of an integer polynomial, and as narrow as one likes.
//!
//! So in the end every number is in a piece where `h <= L`, or is one of a few candidates whose values are enclosed. No float decides
//! anything: they order the pieces and tell where Descartes' rule is worth a try.

use super::bernstein::{bernstein, binomials, halves, without_twos};
use super::{Polynomial, RealRoot};
use arithmetic::{
    Cancelled, Field, Interval, Progress, Rational, Ring, Sign, Signed as _, rational, significant_digits,
};
use num_bigint::BigInt;
use num_traits::{Signed, Zero};
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Bits of the coefficients of `k`.
const BITS: u32 = 192;

/// Bits of the number that pieces are compared with: at a flat top of order `m`, what is within `2^-(LEVEL_BITS/m)` of it is not below.
const LEVEL_BITS: u32 = 768;

/// More pieces than any quotient of polynomials should need.
const MOST_PIECES: usize = 100_000;

/// A piece that holds a flat top is halved until its relative width is below `2^-THIN`.
const THIN: u64 = 96;

/// No piece at the end of the half line is halved more often.
const DEEPEST: u64 = 1 << 14;

/// Doublings of the precision, at most, for as many digits as asked for.
const DOUBLINGS: u32 = 7;

/// Doublings after which candidates of the same height are no longer told apart.
const PATIENCE: u32 = 2;

/// Where a largest value is taken.
#[derive(Debug, Clone)]
pub enum Place {
    /// At a number in the interval.
    At(Interval),
    /// Nowhere: it is the limit at infinity.
    Infinity,
}

/// The largest value.
#[derive(Debug, Clone)]
pub struct Largest {
    /// Where it may be taken, so that it is at one of them: one place, unless several are too close in height to be told apart.
    pub places: Vec<Place>,
    /// The value.
    pub value: Interval,
}

/// Why there is no largest value.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum LargestError {
    /// The degree of the numerator is larger.
    #[error("the quotient grows without bound")]
    Unbounded,
    /// A denominator that is zero or negative somewhere.
    #[error("the denominator has a root on the half line")]
    Pole,
    /// The search was given up.
    #[error("the largest value could not be isolated")]
    NotIsolated,
    /// Stopped by the caller.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// Encloses the largest value of `p/q` on `[0, inf)`, with about so many significant digits of the value and of the place, where there is one
/// simple place; the coefficients are given with the constant one first. The denominator is meant to have no root on the half line; where it has one, the
/// answer is an error.
///
/// # Errors
/// [`LargestError`].
pub fn largest_quotient(
    p: &[BigInt],
    q: &[BigInt],
    digits: u32,
    progress: &dyn Progress,
) -> Result<Largest, LargestError> {
    let length = |list: &[BigInt]| list.iter().rposition(|c| !c.is_zero()).map_or(0, |k| k + 1);
    let size = length(q);
    if length(p) > size {
        return Err(LargestError::Unbounded);
    }
    // The sign of q is the same on the half line, and that of both ends.
    let (Some(first), Some(last)) = (q.first(), q[..size].last()) else { return Err(LargestError::Pole) };
    if !first.is_positive() || !last.is_positive() {
        return Err(LargestError::Pole);
    }
    let mut p = p[..length(p)].to_vec();
    p.resize(size, BigInt::ZERO);
    let mut search = Search::new(&p, &q[..size])?;
    search.run(progress)?;
    search.finish(digits)
}

/// One half of the half line.
struct Side {
    /// Coefficients of `p` and `q` as polynomials of `t`, the constant one first.
    p: Vec<BigInt>,
    q: Vec<BigInt>,
}

/// Numbers `t` between `index/2^level` and `(index + 1)/2^level` of a side.
struct Piece {
    side: usize,
    index: BigInt,
    level: u64,
    /// Bernstein coefficients, times a common number.
    p: Vec<BigInt>,
    q: Vec<BigInt>,
    /// About the logarithm of an upper bound; pieces are taken in this order, then in that of their numbers.
    order: f64,
    number: usize,
}

enum Spot {
    /// An end of pieces, exactly.
    Point(Rational),
    /// The only critical point between two numbers.
    Root(Polynomial, RealRoot),
    /// A piece that was not looked into any further.
    Thin(Rational, Rational),
}

struct Candidate {
    side: usize,
    spot: Spot,
}

struct Search {
    sides: [Side; 2],
    /// `X = 2^scale`.
    scale: i64,
    /// Binomial coefficients `C(d, i)`.
    binomials: Vec<BigInt>,
    heap: BinaryHeap<Piece>,
    made: usize,
    /// The number `L`, not above the value at the best candidate.
    level: Rational,
    /// The best of the ends of pieces.
    point: Candidate,
    candidates: Vec<Candidate>,
}

impl Search {
    fn new(p: &[BigInt], q: &[BigInt]) -> Result<Self, LargestError> {
        let degree = q.len() - 1;
        let bits = |c: &BigInt| c.bits() as i64;
        // About the geometric mean of the moduli of the roots of q.
        let scale = if degree == 0 { 0 } else { (bits(&q[0]) - bits(&q[degree])) / degree as i64 };
        let backwards = |list: &[BigInt]| list.iter().rev().cloned().collect::<Vec<_>>();
        let sides = [
            Side { p: stretched(p, scale), q: stretched(q, scale) },
            Side { p: stretched(&backwards(p), -scale), q: stretched(&backwards(q), -scale) },
        ];
        let binomials = binomials(degree);
        let start = Candidate { side: 0, spot: Spot::Point(rational(0, 1)) };
        let level = rounded_down(&p[0], &q[0]);
        let mut search = Search {
            sides,
            scale,
            binomials,
            heap: BinaryHeap::new(),
            made: 0,
            level,
            point: start,
            candidates: vec![],
        };
        search.look_at(1, rational(0, 1), &p[degree], &q[degree])?;
        // Constant quotients have no critical points to look for.
        if !(0..q.len()).all(|k| &p[k] * &q[0] == &q[k] * &p[0]) {
            for side in 0..2 {
                let Side { p, q } = &search.sides[side];
                let (p, q) = (bernstein(p), bernstein(q));
                search.look_at(side, rational(1, 1), &p[degree], &q[degree])?;
                search.push(side, BigInt::ZERO, 0, (p, q));
            }
        }
        Ok(search)
    }

    /// A value `p/q` of `h` at the number `t`.
    fn look_at(&mut self, side: usize, t: Rational, p: &BigInt, q: &BigInt) -> Result<(), LargestError> {
        if !q.is_positive() {
            return Err(LargestError::Pole);
        }
        if p * self.level.denom() > q * self.level.numer() {
            self.level = rounded_down(p, q);
            self.point = Candidate { side, spot: Spot::Point(t) };
        }
        Ok(())
    }

    fn push(&mut self, side: usize, index: BigInt, level: u64, (p, q): (Vec<BigInt>, Vec<BigInt>)) {
        let order = ratios(&p, &q).map_or(f64::INFINITY, |list| list.into_iter().fold(f64::NEG_INFINITY, f64::max));
        self.made += 1;
        self.heap.push(Piece { side, index, level, p, q, order, number: self.made });
    }

    fn run(&mut self, progress: &dyn Progress) -> Result<(), LargestError> {
        while let Some(piece) = self.heap.pop() {
            progress.checkpoint()?;
            if self.made > MOST_PIECES {
                return Err(LargestError::NotIsolated);
            }
            if self.is_below(&piece) || self.is_settled(&piece) {
                continue;
            }
            if piece.is_thin() {
                self.keep_thin(&piece)?;
                continue;
            }
            self.halve(piece)?;
        }
        Ok(())
    }

    /// Whether `h <= L` on the piece, by its coefficients.
    fn is_below(&self, piece: &Piece) -> bool {
        let (above, below) = (self.level.numer(), self.level.denom());
        piece.q.iter().all(Signed::is_positive) && piece.p.iter().zip(&piece.q).all(|(p, q)| p * &below <= q * &above)
    }

    /// Whether all that the piece holds is known by Descartes' rule: that there is no maximum inside, or one that becomes a candidate.
    fn is_settled(&mut self, piece: &Piece) -> bool {
        let Some(ratios) = ratios(&piece.p, &piece.q) else { return false };
        if turns(&ratios) > 1 {
            return false;
        }
        let Some(signs) = self.critical_signs(piece) else { return false };
        let known: Vec<Sign> = signs.iter().copied().filter(|sign| *sign != Sign::Zero).collect();
        let changes = known.windows(2).filter(|pair| pair[0] != pair[1]).count();
        match (changes, known.first(), signs.first(), signs.last()) {
            (0, ..) | (1, Some(Sign::Negative), ..) => true,
            // An end that is critical too would be taken for the root inside.
            (1, _, Some(first), Some(last)) if *first != Sign::Zero && *last != Sign::Zero => {
                self.keep_root(piece);
                true
            }
            _ => false,
        }
    }

    /// The signs of the coefficients of `k`, the constant one first; `None` where they are not known.
    fn critical_signs(&self, piece: &Piece) -> Option<Vec<Sign>> {
        let number = |(c, b): (&BigInt, &BigInt)| Interval::from_rational(&Rational::from_integer(c * b), BITS);
        let p: Vec<Interval> = piece.p.iter().zip(&self.binomials).map(number).collect();
        let q: Vec<Interval> = piece.q.iter().zip(&self.binomials).map(number).collect();
        let degree = p.len() - 1;
        let mut signs = Vec::with_capacity(2 * degree);
        for m in 1..2 * degree {
            let mut sum = q[0].zero();
            for j in m.saturating_sub(degree)..m.div_ceil(2) {
                // i > j: the terms (i - j) (p_i q_j - p_j q_i).
                let i = m - j;
                let minor = p[i].clone() * &q[j] - p[j].clone() * &q[i];
                sum = sum + minor * q[0].integer((i - j) as i64);
            }
            signs.push(sum.sign()?);
        }
        Some(signs)
    }

    fn keep_root(&mut self, piece: &Piece) {
        let Side { p, q } = &self.sides[piece.side];
        let polynomial = critical(p, q);
        let (lo, hi) = piece.ends();
        let mut root = RealRoot::between(lo, hi);
        // Precise enough for a height that others can be compared with.
        polynomial.refine(&mut root, (piece.level + u64::from(BITS) / 2) as u32);
        let (p, q) = (value(p, root.hi()), value(q, root.hi()));
        let ratio = p / q;
        if ratio > self.level {
            self.level = rounded_down(&ratio.numer(), &ratio.denom());
        }
        self.candidates.push(Candidate { side: piece.side, spot: Spot::Root(polynomial, root) });
    }

    /// A thin piece is a candidate as a whole, if the denominator is known to be positive there.
    fn keep_thin(&mut self, piece: &Piece) -> Result<(), LargestError> {
        if !piece.q.iter().all(Signed::is_positive) {
            return Err(LargestError::Pole);
        }
        let (lo, hi) = piece.ends();
        self.candidates.push(Candidate { side: piece.side, spot: Spot::Thin(lo, hi) });
        Ok(())
    }

    fn halve(&mut self, piece: Piece) -> Result<(), LargestError> {
        let (left_p, right_p) = halves(piece.p);
        let (left_q, right_q) = halves(piece.q);
        let (mut left, mut right) = ((left_p, left_q), (right_p, right_q));
        without_twos(&mut [&mut left.0, &mut left.1]);
        without_twos(&mut [&mut right.0, &mut right.1]);
        let index: BigInt = &piece.index * 2;
        let (p, q) = (&right.0[0], &right.1[0]);
        let level = piece.level + 1;
        self.look_at(piece.side, at(&index + 1, level), p, q)?;
        self.push(piece.side, index.clone(), level, left);
        self.push(piece.side, index + 1, level, right);
        Ok(())
    }

    /// Refines the candidates until they are as narrow as asked for and, if that is soon, told apart.
    fn finish(mut self, digits: u32) -> Result<Largest, LargestError> {
        let all = self.candidates.drain(..).chain([Candidate { side: self.point.side, spot: self.point.spot }]);
        let mut all: Vec<Candidate> = all.collect();
        let mut bits = 2 * (f64::from(digits) * std::f64::consts::LOG2_10) as u32 + 64;
        for doubling in 0..=DOUBLINGS {
            let mut found = Vec::new();
            for candidate in &mut all {
                found.push(candidate.enclosed(&self.sides, self.scale, bits));
            }
            let least = found.iter().flatten().map(|(_, value)| value.lo()).max().cloned();
            let is_high = |(_, value): &(Place, Interval)| least.as_ref().is_none_or(|least| value.hi() >= least);
            let keep: Vec<bool> = found.iter().map(|one| one.as_ref().is_none_or(is_high)).collect();
            let mut kept = keep.iter();
            all.retain(|_| kept.next().copied().unwrap_or_default());
            let kept: Option<Vec<(Place, Interval)>> =
                found.into_iter().zip(&keep).filter(|(_, keep)| **keep).map(|(one, _)| one).collect();
            let done = |kept: &Vec<(Place, Interval)>| {
                let narrow = kept.iter().zip(&all).all(|(one, candidate)| is_narrow(one, digits, &candidate.spot));
                doubling == DOUBLINGS || narrow && (kept.len() == 1 || doubling >= PATIENCE)
            };
            if let Some(kept) = kept
                && done(&kept)
            {
                return together(kept, bits).ok_or(LargestError::NotIsolated);
            }
            bits *= 2;
        }
        Err(LargestError::NotIsolated)
    }
}

impl Candidate {
    /// Place and value; `None` where a denominator is not separated from zero at this precision.
    fn enclosed(&mut self, sides: &[Side; 2], scale: i64, bits: u32) -> Option<(Place, Interval)> {
        let Side { p, q } = &sides[self.side];
        let (lo, hi) = match &mut self.spot {
            Spot::Point(t) => (t.clone(), t.clone()),
            Spot::Thin(lo, hi) => (lo.clone(), hi.clone()),
            Spot::Root(polynomial, root) => {
                polynomial.refine(root, bits);
                (root.lo().clone(), root.hi().clone())
            }
        };
        let t = Interval::hull_of_rationals(&lo, &hi, 2 * bits);
        let number = |c: &BigInt| Interval::from_rational(&Rational::from_integer(c.clone()), 2 * bits);
        let value = |list: &[BigInt]| list.iter().rev().fold(t.zero(), |sum, c| sum * &t + number(c));
        let height = value(p).over(&value(q)).ok()?;
        let place = match self.side {
            0 => Place::At(t.scaled(scale)),
            _ if hi.numer().is_zero() => Place::Infinity,
            _ => Place::At(t.recip().ok()?.scaled(scale)),
        };
        Some((place, height))
    }
}

/// Whether place and value have so many digits, or will not have more.
fn is_narrow((place, value): &(Place, Interval), digits: u32, spot: &Spot) -> bool {
    let thin = matches!(spot, Spot::Thin(..));
    let place = match place {
        Place::At(x) => significant_digits(x) >= digits,
        Place::Infinity => true,
    };
    thin || place && (significant_digits(value) >= digits)
}

/// All places, and the largest value.
fn together(kept: Vec<(Place, Interval)>, bits: u32) -> Option<Largest> {
    let lo = kept.iter().map(|(_, value)| value.lo()).max()?.clone();
    let hi = kept.iter().map(|(_, value)| value.hi()).max()?.clone();
    Some(Largest {
        value: Interval::between(lo, hi, 2 * bits),
        places: kept.into_iter().map(|(place, _)| place).collect(),
    })
}

impl Piece {
    fn ends(&self) -> (Rational, Rational) {
        (at(self.index.clone(), self.level), at(&self.index + 1, self.level))
    }

    fn is_thin(&self) -> bool {
        // The relative width is about 1/index.
        if self.index.is_zero() { self.level > DEEPEST } else { self.index.bits() > THIN }
    }
}

impl PartialEq for Piece {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Piece {}

impl PartialOrd for Piece {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Piece {
    fn cmp(&self, other: &Self) -> Ordering {
        self.order.total_cmp(&other.order).then(other.number.cmp(&self.number))
    }
}

/// `index/2^level`.
fn at(index: BigInt, level: u64) -> Rational {
    Rational::new(index, BigInt::from(1) << level)
}

/// Coefficients of `f(2^scale t)`, times a power of two.
fn stretched(coefficients: &[BigInt], scale: i64) -> Vec<BigInt> {
    let top = coefficients.len() - 1;
    let shift = |k: usize| scale.unsigned_abs() * if scale < 0 { top - k } else { k } as u64;
    coefficients.iter().enumerate().map(|(k, c)| c << shift(k)).collect()
}

/// A number with some bits that is not above `p/q`, for `p >= 0` and `q > 0`.
fn rounded_down(p: &BigInt, q: &BigInt) -> Rational {
    let shift = i64::from(LEVEL_BITS) - (p.bits() as i64 - q.bits() as i64);
    let (above, below) = if shift < 0 { (p.clone(), q << (-shift) as u64) } else { (p << shift as u64, q.clone()) };
    let rounded = Rational::from_integer(above / below);
    let power = Rational::from_integer(BigInt::from(1) << shift.unsigned_abs());
    if shift < 0 { rounded * power } else { rounded / power }
}

/// About `log2(p_i/q_i)`; `None` where a `q_i` is not positive.
fn ratios(p: &[BigInt], q: &[BigInt]) -> Option<Vec<f64>> {
    let size = |c: &BigInt| {
        let shift = c.bits().saturating_sub(64);
        let head = c.magnitude() >> shift;
        head.iter_u64_digits().next().map_or(f64::NEG_INFINITY, |head| (head as f64).log2() + shift as f64)
    };
    let ratio = |(p, q): (&BigInt, &BigInt)| {
        let p = if p.is_positive() { size(p) } else { f64::NEG_INFINITY };
        q.is_positive().then(|| p - size(q))
    };
    p.iter().zip(q).map(ratio).collect()
}

/// How often a list turns from growing to falling or back; what floats cannot tell apart counts as level.
fn turns(list: &[f64]) -> usize {
    let steps = list.windows(2).map(|pair| pair[1] - pair[0]).filter(|step| step.abs() > 1e-10);
    let rising: Vec<bool> = steps.map(|step| step > 0.0).collect();
    rising.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

/// `p' q - p q'`.
fn critical(p: &[BigInt], q: &[BigInt]) -> Polynomial {
    let mut all = vec![BigInt::ZERO; p.len() + q.len()];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate().filter(|(j, _)| *j != i) {
            all[i + j - 1] += a * b * (i as i64 - j as i64);
        }
    }
    Polynomial::new(all)
}

fn value(coefficients: &[BigInt], t: &Rational) -> Rational {
    coefficients.iter().rev().fold(rational(0, 1), |sum, c| sum * t + Rational::from_integer(c.clone()))
}

#[cfg(test)]
mod tests;
