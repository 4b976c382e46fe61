//! Families whose eigenvalues have a formula.
//!
//! With `c(t) = cos(2 pi t)`:
//!
//! | graph | matrix | eigenvalues |
//! |---|---|---|
//! | circulant with offsets `s` | any | `a_k = sum_s (z^(ks) + z^(-ks))`, `z = e^(2 pi i/n)`; `d - a_k`, `1 - a_k/d` |
//! | cycle | any | `z^k`, `1 - z^k` |
//! | complete | any | `n - 1` and `-1` (n - 1 times), and so on |
//! | path | `laplacian` | `2 - 2 c(k/2n)`, `0 <= k < n` |
//! | path | `walk` | `1 - c(k/(2n - 2))`, `0 <= k < n`, for `n >= 2` |
//! | path | `adjacency` | `2 c(k/(2n + 2))`, `1 <= k <= n` |
//! | path | `reduced` | `2 - 2 c((2k - 1)/(4n - 2))`, `1 <= k < n` |
//! | star | any but `reduced` | 0, 1 (n - 2 times), n or 2; `+-sqrt(n - 1)`, 0 |
//! | platoon1 | any | triangular matrices: their diagonals |
//! | platoon2 | rows | `1 - c((2k - 1)/4M)`, `1 <= k <= M`, and 0 of the leader; `adjacency`: `c(..)` and 0 |
//!
//! The formulas for paths are those of reflected and fixed ends; the tests compare all of them with exact characteristic
//! polynomials for small orders. The reduced matrix of platoon2 is zero where `T_M(1 - x) = 0`, as in Lemma 2 of Veerman
//! et al.

use super::enclosed::{FloatEnclosure, bits, least_top, order};
use super::float_bounds::{nearest, nearest_root};
use super::{CyclotomicSum, Eigenvalue, RootTable};
use crate::graph::{LaplacianKind, NamedGraph};
use arithmetic::threads::map;
use arithmetic::{ArithmeticError, Interval, Number, Rational, Ring, rational};
use num_bigint::BigInt;
use rayon::prelude::*;
use std::collections::hash_map::Entry;
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// One of the different eigenvalues.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ClosedValue {
    /// A rational.
    Rational(Rational),
    /// A combination of roots of unity.
    Cyclotomic(CyclotomicSum),
    /// `sign * sqrt(radicand)`.
    SquareRoot {
        /// 1 or -1.
        sign: i64,
        /// What the root is taken of.
        radicand: u64,
    },
}

/// The different eigenvalues with their multiplicities.
#[derive(Debug, Clone)]
pub struct ClosedForm {
    /// In no particular order.
    pub values: Vec<(ClosedValue, usize)>,
    /// The formula.
    pub formula: String,
}

/// Work, in terms of sums, beyond which the eigenvalues of circulants are not told apart exactly.
const MOST_TERMS: usize = 1 << 25;

/// The closed form for that matrix of a named graph, where there is one (and such a graph).
pub fn closed_form(graph: &NamedGraph, kind: LaplacianKind) -> Option<ClosedForm> {
    use LaplacianKind::{Adjacency, Normalised, Reduced, Walk};
    graph.check().ok()?;
    let n = graph.order();
    let walk = matches!(kind, Walk | Normalised);
    match graph {
        NamedGraph::Complete(_) if kind != Reduced => Some(complete(n as i64, kind)),
        // Without the first vertex a complete graph leaves nI - J of order n - 1.
        NamedGraph::Complete(_) if n >= 2 => {
            Some(rationals(vec![(rational(1, 1), 1), (rational(n as i64, 1), n - 2)], "1, and n"))
        }
        NamedGraph::Ring(_) if kind != Reduced => Some(circulant(n, &[1, n - 1], kind, true)?),
        // The ring without a vertex is a path with both ends held.
        NamedGraph::Ring(_) => Some(cosines((1..n).map(|k| (k, 2 * n)), 2, -1, 1, "2 - 2 cos(pi k/n), 0 < k < n")),
        NamedGraph::Cycle(_) if kind == Reduced && n >= 2 => Some(rationals(vec![(rational(1, 1), n - 1)], "1")),
        NamedGraph::Cycle(_) if matches!(kind, Reduced | Normalised) => None,
        NamedGraph::Cycle(_) => circulant(n, &[1 % n], kind, true),
        NamedGraph::Circulant(_, offsets) if kind != Reduced => {
            let both: BTreeSet<usize> = offsets.iter().flat_map(|&a| [a, n - a]).collect();
            circulant(n, &both.into_iter().collect::<Vec<_>>(), kind, false)
        }
        NamedGraph::Path(1) if kind != Reduced => Some(rationals(vec![(Rational::ZERO, 1)], "0")),
        NamedGraph::Path(_) => match kind {
            Reduced if n < 2 => None,
            Reduced => {
                let turns = (1..n).map(|k| (2 * k - 1, 4 * n - 2));
                Some(cosines(turns, 2, -1, 1, "2 - 2 cos(pi (2k - 1)/(2n - 1)), 0 < k < n"))
            }
            Adjacency => Some(cosines((1..=n).map(|k| (k, 2 * n + 2)), 0, 1, 1, "2 cos(pi k/(n + 1)), 0 < k <= n")),
            _ if walk => Some(cosines((0..n).map(|k| (k, 2 * n - 2)), 2, -1, 2, "1 - cos(pi k/(n - 1)), 0 <= k < n")),
            _ => Some(cosines((0..n).map(|k| (k, 2 * n)), 2, -1, 1, "2 - 2 cos(pi k/n), 0 <= k < n")),
        },
        NamedGraph::Star(_) if n >= 3 && kind != Reduced => Some(star(n, kind)),
        NamedGraph::PlatoonOne(m) => Some(platoon_one(*m, kind)).filter(|_| kind != Normalised),
        NamedGraph::PlatoonTwo(m) => platoon_two(*m, kind),
        _ => None,
    }
}

fn rationals(values: Vec<(Rational, usize)>, formula: &str) -> ClosedForm {
    let mut joined: BTreeMap<Rational, usize> = BTreeMap::new();
    for (value, multiplicity) in values.into_iter().filter(|&(_, multiplicity)| multiplicity > 0) {
        *joined.entry(value).or_default() += multiplicity;
    }
    let values = joined.into_iter().map(|(value, multiplicity)| (ClosedValue::Rational(value), multiplicity)).collect();
    ClosedForm { values, formula: formula.to_string() }
}

/// `(constant + 2 half cos(2 pi p/q))/denominator` for different cosines.
fn cosines(
    turns: impl Iterator<Item = (usize, usize)>,
    constant: i64,
    half: i64,
    denominator: i64,
    formula: &str,
) -> ClosedForm {
    let value = |(p, q): (usize, usize)| {
        let (p, q) = (p as u64, q as u64);
        let terms = [(0, constant), (p, half), (q - p % q, half)];
        (ClosedValue::Cyclotomic(CyclotomicSum::of(q, denominator, terms)), 1)
    };
    ClosedForm { values: turns.map(value).collect(), formula: formula.to_string() }
}

fn complete(n: i64, kind: LaplacianKind) -> ClosedForm {
    let others = (n - 1) as usize;
    match kind {
        LaplacianKind::Adjacency => {
            rationals(vec![(rational(n - 1, 1), 1), (rational(-1, 1), others)], "n - 1, and -1")
        }
        LaplacianKind::Walk | LaplacianKind::Normalised => {
            // Of one vertex there are no others.
            let rest = rational(n, (n - 1).max(1));
            rationals(vec![(Rational::ZERO, 1), (rest, others)], "0, and n/(n - 1)")
        }
        _ => rationals(vec![(Rational::ZERO, 1), (rational(n, 1), others)], "0, and n"),
    }
}

fn star(n: usize, kind: LaplacianKind) -> ClosedForm {
    let (zero, one) = (Rational::ZERO, rational(1, 1));
    match kind {
        LaplacianKind::Adjacency => {
            let root = |sign| (ClosedValue::SquareRoot { sign, radicand: n as u64 - 1 }, 1);
            let values = vec![root(-1), (ClosedValue::Rational(zero), n - 2), root(1)];
            ClosedForm { values, formula: "0, and +-sqrt(n - 1)".to_string() }
        }
        LaplacianKind::Walk | LaplacianKind::Normalised => {
            rationals(vec![(zero, 1), (one, n - 2), (rational(2, 1), 1)], "0, 1 and 2")
        }
        _ => rationals(vec![(zero, 1), (one, n - 2), (rational(n as i64, 1), 1)], "0, 1 and n"),
    }
}

fn platoon_one(m: usize, kind: LaplacianKind) -> ClosedForm {
    let (zero, one) = (Rational::ZERO, rational(1, 1));
    match kind {
        LaplacianKind::Adjacency => rationals(vec![(zero, m + 1)], "0: the matrix is triangular"),
        LaplacianKind::Reduced => rationals(vec![(one, m)], "1: the matrix is triangular"),
        _ => rationals(vec![(zero, 1), (one, m)], "0 and 1: the matrix is triangular"),
    }
}

fn platoon_two(m: usize, kind: LaplacianKind) -> Option<ClosedForm> {
    let turns = || (1..=m).map(|k| (2 * k - 1, 4 * m));
    let zero = |mut form: ClosedForm| {
        form.values.push((ClosedValue::Rational(Rational::ZERO), 1));
        form
    };
    match kind {
        LaplacianKind::InDegree | LaplacianKind::Normalised => None,
        LaplacianKind::Reduced => Some(cosines(turns(), 2, -1, 2, "1 - cos(pi (2k - 1)/2M), 0 < k <= M followers")),
        LaplacianKind::Adjacency => {
            // For odd M the middle cosine is zero as well.
            let others = turns().filter(|&(p, q)| 4 * p != q);
            let mut form = zero(cosines(others, 0, 1, 2, "0, and cos(pi (2k - 1)/2M), 0 < k <= M followers"));
            if let Some((_, multiplicity)) = form.values.last_mut() {
                *multiplicity += m % 2;
            }
            Some(form)
        }
        _ => Some(zero(cosines(turns(), 2, -1, 2, "0, and 1 - cos(pi (2k - 1)/2M), 0 < k <= M followers"))),
    }
}

/// The circulant in which `i` senses `i + a` for each step `a` with weight 1. `apart` tells that equal eigenvalues
/// are those of `k` and `n - k` for symmetric steps, and that there are none for one step.
fn circulant(n: usize, steps: &[usize], kind: LaplacianKind, apart: bool) -> Option<ClosedForm> {
    let degree = steps.len() as i64;
    let (constant, sign, denominator) = match kind {
        LaplacianKind::Adjacency => (0, 1, 1),
        LaplacianKind::Walk | LaplacianKind::Normalised => (degree, -1, degree),
        _ => (degree, -1, 1),
    };
    let order = n as u64;
    let value = |k: usize| {
        let terms = steps.iter().map(|&a| ((a as u64 * k as u64) % order, sign));
        CyclotomicSum::of(order, denominator, terms.chain([(0, constant)]))
    };
    let symmetric = steps.iter().all(|&a| steps.contains(&((n - a) % n)));
    // The eigenvalues of k and n - k are equal.
    let mirrored = |k: usize| if k == 0 || 2 * k == n { 1 } else { 2 };
    let candidates: Vec<(usize, usize)> =
        if symmetric { (0..=n / 2).map(|k| (k, mirrored(k))).collect() } else { (0..n).map(|k| (k, 1)).collect() };
    let formula = match (degree, kind) {
        (1, LaplacianKind::Adjacency) => "e^(2 pi i k/n), 0 <= k < n".to_string(),
        (1, _) => "1 - e^(2 pi i k/n), 0 <= k < n".to_string(),
        (_, LaplacianKind::Adjacency) => format!("sum of cos(2 pi k a/n) over the {degree} steps a, 0 <= k < n"),
        (_, LaplacianKind::Walk | LaplacianKind::Normalised) => {
            format!("1 - mean of cos(2 pi k a/n) over the {degree} steps a, 0 <= k < n")
        }
        _ => format!("sum of 1 - cos(2 pi k a/n) over the {degree} steps a, 0 <= k < n"),
    };
    if apart {
        let values = candidates.into_iter().map(|(k, times)| (ClosedValue::Cyclotomic(value(k)), times)).collect();
        return Some(ClosedForm { values, formula });
    }
    if candidates.len().saturating_mul(steps.len()) > MOST_TERMS {
        return None;
    }
    let mut places: HashMap<Vec<(u64, i128)>, usize> = HashMap::new();
    let mut values: Vec<(ClosedValue, usize)> = Vec::new();
    for (k, times) in candidates {
        let value = value(k);
        let place = *places.entry(value.canonical()).or_insert(values.len());
        match values.get_mut(place) {
            Some((_, multiplicity)) => *multiplicity += times,
            None => values.push((ClosedValue::Cyclotomic(value), times)),
        }
    }
    Some(ClosedForm { values, formula })
}

impl ClosedForm {
    /// Encloses all values to `digits` significant digits (of the modulus, for complex ones).
    ///
    /// # Errors
    /// [`ArithmeticError`], which does not happen: a number that is not zero is told from zero at some precision.
    pub fn enclose(&self, digits: u32) -> Result<Vec<Eigenvalue>, ArithmeticError> {
        let mut tables: HashMap<u64, RootTable> = HashMap::new();
        for (value, _) in &self.values {
            if let ClosedValue::Cyclotomic(sum) = value
                && let Entry::Vacant(place) = tables.entry(sum.order())
            {
                place.insert(RootTable::new(sum.order(), first_precision(sum, digits))?);
            }
        }
        let enclose = |(value, multiplicity): &(ClosedValue, usize)| match value {
            ClosedValue::Rational(q) => Ok(Eigenvalue::rational(q.clone(), *multiplicity, bits(digits) + 8)),
            ClosedValue::SquareRoot { sign, radicand } => square_root(*sign, *radicand, *multiplicity, digits),
            ClosedValue::Cyclotomic(sum) => enclose_sum(sum, *multiplicity, digits, tables.get(&sum.order())),
        };
        let enclosed = map(self.values.len(), |k| enclose(&self.values[k]));
        let mut found: Vec<Eigenvalue> = enclosed.into_iter().collect::<Result<_, _>>()?;
        found.par_sort_by(order);
        Ok(found)
    }
}

impl ClosedForm {
    /// All values in floats with proved bounds, by increasing real part: the fast way where 15 digits do.
    pub fn floats(&self) -> Vec<FloatEnclosure> {
        // Out of the range of floats nothing is known.
        let real =
            |part: Option<(f64, f64)>| part.map_or((f64::NAN, 0.0, f64::INFINITY), |(re, radius)| (re, 0.0, radius));
        let float = |(value, multiplicity): &(ClosedValue, usize)| {
            let (re, im, radius) = match value {
                ClosedValue::Cyclotomic(sum) if sum.is_real() => {
                    let (re, _, radius) = sum.to_floats();
                    (re, 0.0, radius)
                }
                ClosedValue::Cyclotomic(sum) => sum.to_floats(),
                ClosedValue::Rational(q) => real(nearest(q)),
                ClosedValue::SquareRoot { sign, radicand } => {
                    real(nearest_root(&Rational::from_integer(BigInt::from(*radicand)), *sign as f64))
                }
            };
            FloatEnclosure { re, im, radius, multiplicity: *multiplicity }
        };
        let mut found: Vec<FloatEnclosure> = self.values.iter().map(float).collect();
        found.sort_by(|a, b| a.re.total_cmp(&b.re).then_with(|| a.im.total_cmp(&b.im)));
        found
    }
}

fn square_root(sign: i64, radicand: u64, multiplicity: usize, digits: u32) -> Result<Eigenvalue, ArithmeticError> {
    let precision = bits(digits) + 8;
    let root = radicand.isqrt();
    if root * root == radicand {
        let value = Rational::from_integer(BigInt::from(root) * sign);
        return Ok(Eigenvalue::rational(value, multiplicity, precision));
    }
    let radicand = Rational::from_integer(BigInt::from(radicand));
    let root = Interval::from_rational(&radicand, precision).sqrt()?;
    Ok(Eigenvalue::real(root.clone() * root.integer(sign), multiplicity))
}

fn enclose_sum(
    sum: &CyclotomicSum,
    multiplicity: usize,
    digits: u32,
    first: Option<&RootTable>,
) -> Result<Eigenvalue, ArithmeticError> {
    let real = sum.is_real();
    let mut precision = first_precision(sum, digits);
    let mut finer: Option<RootTable> = None;
    loop {
        let z = match finer.as_ref().or(first) {
            Some(table) => sum.enclose(table)?,
            None => sum.enclose(finer.insert(RootTable::new(sum.order(), precision)?))?,
        };
        if real && let Some(exact) = sum.exact(&z.re) {
            return Ok(Eigenvalue::rational(exact, multiplicity, bits(digits) + 8));
        }
        let (re, im) = if real {
            let zero = z.im.zero();
            (z.re, zero)
        } else {
            // The real part may be rational, as that of i is.
            let exact = sum.real_part().exact(&z.re).map(|q| Interval::from_rational(&q, precision));
            (exact.unwrap_or(z.re), z.im)
        };
        let width = re.width().top().max(im.width().top());
        // The modulus is at least this power of two; a part that may be zero has a larger width.
        let size = least_top(&re).max(least_top(&im));
        if width + i64::from(bits(digits)) <= size {
            return Ok(Eigenvalue { re, im, multiplicity, exact: None });
        }
        precision = precision.checked_mul(2).ok_or(ArithmeticError::Argument("the enclosure of an eigenvalue"))?;
        finer = Some(RootTable::new(sum.order(), precision)?);
    }
}

/// Bits that nearly always do: the least eigenvalues of a ring or path are of the size order^-2.
fn first_precision(sum: &CyclotomicSum, digits: u32) -> u32 {
    bits(digits) + 2 * (u64::BITS - sum.order().leading_zeros()) + 24
}
