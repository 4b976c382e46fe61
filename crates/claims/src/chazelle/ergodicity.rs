//! chazelle.tau1, chazelle.lem2.4 and chazelle.tau2sqrt2: the diameters of the rows.

use crate::prelude::*;
use algebra::matrix::{Norm, RationalMatrix, diameter, tau_1, tau_2_squared, tau_infinity};
use num_bigint::BigInt;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::Rng;

fn show(matrix: &RationalMatrix) -> String {
    format!("[{}]", list(matrix.to_rows().iter().map(|row| format!("[{}]", list(row)))))
}

fn size(random: &mut ChaCha8Rng, largest: usize) -> usize {
    1 + random.next_u32() as usize % largest
}

/// Which combination of the overlaps is compared with which multiple of the diameter.
#[derive(Clone, Copy)]
pub struct CoefficientVariant {
    share_of_diameter: (i64, i64),
    /// `1 - min` over pairs of rows, or `1 - max` over pairs of different rows.
    least_overlap: bool,
    /// The overlap is the sum of the smaller entries, or of the larger ones.
    smaller_entries: bool,
    /// All rows are divided by this: 1 keeps them stochastic.
    row_sum_divisor: i64,
}

impl CoefficientVariant {
    fn right_side(&self, a: &RationalMatrix) -> Rational {
        let overlap = |i: usize, j: usize| -> BigInt {
            let pairs = a.row(i).iter().zip(a.row(j));
            pairs.map(|(x, y)| if self.smaller_entries { x.min(y) } else { x.max(y) }).sum()
        };
        let pairs = (0..a.rows()).flat_map(|i| (0..a.rows()).map(move |j| (i, j)));
        // A row overlaps with itself most.
        let pairs = pairs.filter(|(i, j)| self.least_overlap || i != j || a.rows() == 1);
        let all = pairs.map(|(i, j)| overlap(i, j));
        let chosen = if self.least_overlap { all.min() } else { all.max() };
        rational(1, 1) - Rational::new(chosen.unwrap_or_default(), a.denominator().clone())
    }

    fn fails_at(&self, a: &RationalMatrix) -> Option<String> {
        let (p, q) = self.share_of_diameter;
        let left = diameter(a, Norm::One) * rational(p, q);
        let right = self.right_side(a);
        (left != right || left < rational(0, 1) || left > rational(1, 1))
            .then(|| format!("A = {}: {p}/{q} of the diameter is {left}, the right side is {right}", show(a)))
    }
}

pub fn coefficient() -> Record<CoefficientVariant> {
    let printed = CoefficientVariant {
        share_of_diameter: (1, 2),
        least_overlap: true,
        smaller_entries: true,
        row_sum_divisor: 1,
    };
    Record::new(
        "chazelle.tau1",
        "|a - b| = a + b - 2 min(a, b). Summed over the entries of two rows that sum to one: half the l1-distance is \
         1 - sum_k min(a_ik, a_jk). It is at least 0 and, the minima being non-negative, at most 1. The diameter of \
         the convex hull is attained at two rows because a norm is convex (notes/chazelle.md).",
        printed,
        check_coefficient,
    )
    .clauses(&[
        "For row-stochastic A, 0 <= tau_1(A) = 1 - min_{i,j} sum_k min{a_ik, a_jk} <= 1.",
        "tau_1(A) is half the l_1-diameter of the rows.",
    ])
    .altered("the whole diameter", |v| v.share_of_diameter = (1, 1))
    .altered("the largest overlap of two rows", |v| v.least_overlap = false)
    .altered("the larger entries", |v| v.smaller_entries = false)
    .altered("rows that sum to 1/2", |v| v.row_sum_divisor = 2)
}

fn check_coefficient(variant: &CoefficientVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let scale = |a: RationalMatrix| -> Result<RationalMatrix, CheckError> {
        let divisor = rational(variant.row_sum_divisor, 1);
        let rows: Vec<Vec<Rational>> =
            a.to_rows().into_iter().map(|row| row.into_iter().map(|x| x / &divisor).collect()).collect();
        Ok(RationalMatrix::from_rows(&rows)?)
    };
    let upto = |cols: usize, largest: u32| (1..=largest).map(move |denominator| (2, cols, denominator));
    let families = [(1, 1, 1), (1, 3, 4), (2, 1, 3)].into_iter().chain(upto(2, 12));
    let families = families.chain([(3, 3, 3)]).chain(upto(3, 6)).chain(upto(4, 4));
    let all = families.map(|(rows, cols, denominator)| RationalMatrix::all_stochastic(rows, cols, denominator));
    let all = all.collect::<Result<Vec<_>, _>>()?.into_iter().flatten();
    let mut random = run.random(0);
    let part = "equality and both bounds, for every row-stochastic matrix";
    let detail = "every pair of rows with a common denominator up to 12 (2 columns), 6 (3), 4 (4), and every 3 x 3 matrix over 3";
    Run::all([
        run.every(exhaustive(part, detail), all, |a| Ok(variant.fails_at(&scale(a)?))),
        run.every(fuzzed("the same", "random rectangular matrices up to 9 x 9"), 0..run.cases(300, 5000), |_| {
            let (rows, cols) = (size(&mut random, 9), size(&mut random, 9));
            Ok(variant.fails_at(&scale(RationalMatrix::random_stochastic(rows, cols, &mut random)?)?))
        }),
    ])
    .on([1, 2])
}

/// The factor in front of `tau_2(B)`.
#[derive(Clone, Copy)]
pub struct SubmultiplicativeVariant {
    /// The diameter of `A` that is used.
    left: LeftDiameter,
    /// A factor on the right side, squared.
    squared_factor: (i64, i64),
    /// Whether `A` is row-stochastic; otherwise its second row is halved.
    stochastic: bool,
}

/// A diameter of the left matrix.
#[derive(Clone, Copy)]
enum LeftDiameter {
    One,
    Two,
    Infinity,
}

impl SubmultiplicativeVariant {
    fn fails_at(&self, a: &RationalMatrix, b: &RationalMatrix) -> Result<Option<String>, CheckError> {
        let squared_left = match self.left {
            LeftDiameter::One => tau_1(a).square(),
            LeftDiameter::Two => tau_2_squared(a),
            LeftDiameter::Infinity => tau_infinity(a).square(),
        };
        let product = tau_2_squared(&a.times(b)?);
        let (p, q) = self.squared_factor;
        let bound = squared_left * tau_2_squared(b) * rational(p, q);
        Ok((product > bound)
            .then(|| format!("A = {}, B = {}: tau_2(AB)² = {product} exceeds {bound}", show(a), show(b))))
    }
}

/// The matrix with its second row halved.
fn spoiled(a: &RationalMatrix) -> Result<RationalMatrix, CheckError> {
    let mut rows = a.to_rows();
    if let Some(row) = rows.get_mut(1) {
        row.iter_mut().for_each(|x| *x /= rational(2, 1));
    }
    Ok(RationalMatrix::from_rows(&rows)?)
}

pub fn submultiplicative() -> Record<SubmultiplicativeVariant> {
    Record::new(
        "chazelle.lem2.4",
        "Row i minus row j of AB is sum_k u_k b_k with u = a_i - a_j. The positive and the negative part of u both \
         sum to t <= tau_1(A), so it is t times the difference of two convex combinations of rows of B, whose \
         distance is at most tau_2(B). The argument uses no special norm (notes/chazelle.md).",
        SubmultiplicativeVariant { left: LeftDiameter::One, squared_factor: (1, 1), stochastic: true },
        check_submultiplicative,
    )
    .altered("tau_2(A) instead of tau_1(A)", |v| v.left = LeftDiameter::Two)
    .altered("tau_infinity(A)", |v| v.left = LeftDiameter::Infinity)
    .altered("a bound smaller by 1/200", |v| v.squared_factor = (99, 100))
    .altered("A not stochastic", |v| v.stochastic = false)
}

fn check_submultiplicative(variant: &SubmultiplicativeVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let prepare = |a: RationalMatrix| if variant.stochastic { Ok(a) } else { spoiled(&a) };
    let mut pairs = Vec::new();
    // Both sides are attained at two rows of A, so two rows are enough.
    for (inner, cols, of_a, of_b) in [(1, 2, 2, 3), (2, 2, 6, 4), (2, 3, 4, 3), (3, 2, 3, 2), (3, 3, 3, 2)] {
        let lefts =
            RationalMatrix::all_stochastic(2, inner, of_a)?.into_iter().map(prepare).collect::<Result<Vec<_>, _>>()?;
        let rights = RationalMatrix::all_stochastic(inner, cols, of_b)?;
        pairs.extend(rights.iter().flat_map(|b| lefts.iter().map(move |a| (a.clone(), b.clone()))));
    }
    // Equality, and the reason why tau_1 cannot be replaced: rows spread over many entries.
    let spread = RationalMatrix::from_integers(&[[1, 1, 1, 0, 0, 0], [0, 0, 0, 1, 1, 1]], 3)?;
    let split = RationalMatrix::from_integers(&[[1, 0], [1, 0], [1, 0], [0, 1], [0, 1], [0, 1]], 1)?;
    run.value("tau_2_squared_where_equal", tau_2_squared(&spread.times(&split)?).to_string());
    let attained = exact("the bound is attained", "A = [[1,1,1,0,0,0],[0,0,0,1,1,1]]/3 and B that merges the columns");
    let attained = unless(variant.fails_at(&prepare(spread)?, &split)?, attained);
    let mut random = run.random(0);
    let part = "the bound, for all row-stochastic A and B that can be multiplied";
    let detail = "all pairs with A of two rows and inner size up to 3 over small denominators";
    Run::all([
        run.every(exhaustive(part, detail), &pairs, |(a, b)| variant.fails_at(a, b)),
        attained,
        run.every(fuzzed("the same", "random rectangular matrices up to 7 x 7"), 0..run.cases(200, 4000), |_| {
            let (rows, inner, cols) = (size(&mut random, 7), size(&mut random, 7), size(&mut random, 7));
            let a = prepare(RationalMatrix::random_stochastic(rows, inner, &mut random)?)?;
            variant.fails_at(&a, &RationalMatrix::random_stochastic(inner, cols, &mut random)?)
        }),
    ])
}

/// The squared constant, and a squared factor of the middle term.
#[derive(Clone, Copy)]
pub struct SquareRootOfTwoVariant {
    squared_constant: (i64, i64),
    middle_factor: (i64, i64),
    stochastic: bool,
}

pub fn square_root_of_two() -> Record<SquareRootOfTwoVariant> {
    Record::new(
        "chazelle.tau2sqrt2",
        "Lemma 2.4 with B = I. Two rows of the identity have distance sqrt(2); with one column there is only one row \
         and tau_2(I) = 0 (notes/chazelle.md).",
        SquareRootOfTwoVariant { squared_constant: (2, 1), middle_factor: (1, 1), stochastic: true },
        check_square_root_of_two,
    )
    .clauses(&["tau_2(A) <= tau_1(A) tau_2(I) for row-stochastic A.", "tau_1(A) tau_2(I) <= sqrt(2) tau_1(A)."])
    .altered("the constant 1.41", |v| v.squared_constant = (19881, 10000))
    .altered("a smaller middle term", |v| v.middle_factor = (99, 100))
    .altered("the constant 1", |v| v.squared_constant = (1, 1))
    .altered("A not stochastic", |v| v.stochastic = false)
}

fn check_square_root_of_two(variant: &SquareRootOfTwoVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let (p, q) = variant.squared_constant;
    let fails_at = |a: &RationalMatrix| -> Result<Option<String>, CheckError> {
        let identity = RationalMatrix::identity(a.cols())?;
        let coefficient = tau_1(a).square();
        let (part, whole) = variant.middle_factor;
        let middle = coefficient.clone() * tau_2_squared(&identity) * rational(part, whole);
        let chain = [tau_2_squared(a), middle, coefficient * rational(p, q)];
        let ordered = chain.windows(2).all(|pair| pair[0] <= pair[1]);
        Ok((!ordered).then(|| format!("A = {}: the squares are {}, {}, {}", show(a), chain[0], chain[1], chain[2])))
    };
    let fails = |a: RationalMatrix| fails_at(&if variant.stochastic { a } else { spoiled(&a)? });
    let families = [(1, 1, 1), (2, 1, 1), (2, 2, 12), (2, 3, 6), (2, 4, 4), (3, 3, 3)];
    let all = families.map(|(rows, cols, denominator)| RationalMatrix::all_stochastic(rows, cols, denominator));
    let all = all.into_iter().collect::<Result<Vec<_>, _>>()?.into_iter().flatten();
    let part = "both inequalities, for every row-stochastic matrix";
    let mut random = run.random(0);
    Run::all([
        run.every(exhaustive(part, "all pairs of rows over small denominators"), all, fails),
        run.every(fuzzed("the same", "random rectangular matrices up to 9 x 9"), 0..run.cases(300, 5000), |_| {
            let (rows, cols) = (size(&mut random, 9), size(&mut random, 9));
            fails(RationalMatrix::random_stochastic(rows, cols, &mut random)?)
        }),
    ])
    .on([1, 2])
}
