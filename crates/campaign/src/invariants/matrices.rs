//! Products of stochastic matrices (Chazelle, section 2).

use super::{Checked, Invariant, OrFails, Stop, Tested, require, shown};
use crate::draws::Draws;
use crate::strategies::{rational_matrix, stochastic_sequence};
use algebra::matrix::{Footprint, RationalMatrix, StochasticMatrix, product_sequential, product_tree, tau_1};
use arithmetic::{Rational, rational};
use num_bigint::BigUint;
use num_traits::{Signed, ToPrimitive, Zero};

pub(super) const TABLE: &[Invariant] = &[
    Invariant {
        id: "matrix.product_is_stochastic",
        statement: "A product of row-stochastic matrices has entries >= 0 and rows that sum to 1, and tau_1 in [0, 1].",
        control: "one unit of the common denominator is moved out of the last row",
        block: 500,
        check: product_is_stochastic,
    },
    Invariant {
        id: "matrix.tau_1_of_products",
        statement: "tau_1(P Q) <= tau_1(P) tau_1(Q).",
        control: "tau_1(P Q) of the product without the factor P",
        block: 1000,
        check: tau_1_of_products,
    },
    Invariant {
        id: "matrix.tau_1_twin",
        statement: "tau_1 of the fast kernel is half the largest l1 distance of two rows, and 1 - min over i, j of sum_k min(a_ik, a_jk).",
        control: "the distances of neighbouring rows only",
        block: 500,
        check: tau_1_twin,
    },
    Invariant {
        id: "matrix.footprint_of_products",
        statement: "The footprint of P Q is the Boolean product of the footprints of P and Q.",
        control: "the Boolean product in the other order",
        block: 500,
        check: footprint_of_products,
    },
    Invariant {
        id: "matrix.product_tree",
        statement: "A product by a balanced tree is the product one after the other, and that of plain rational matrices.",
        control: "the first two factors of the tree exchanged",
        block: 100,
        check: tree_is_sequential,
    },
    Invariant {
        id: "matrix.inverse",
        statement: "A matrix times its inverse is the identity, its determinant is not zero, and A x = b is solved by x = inverse b.",
        control: "the inverse of the transpose",
        block: 100,
        check: inverse,
    },
];

fn instance(factors: &[StochasticMatrix]) -> String {
    let rows = |m: &StochasticMatrix| shown(m.to_rational_matrix().to_rows().iter().map(shown));
    format!("factors, the first on the right: {}", shown(factors.iter().map(rows)))
}

fn sequence(draws: &mut Draws, most: usize, length: usize) -> Result<Vec<StochasticMatrix>, Stop> {
    let (order, length) = (draws.between(1, most), draws.between(2, length));
    stochastic_sequence(draws, order, length, 12).or_fails("a stochastic matrix is refused")
}

fn product_is_stochastic(draws: &mut Draws, tested: Tested) -> Checked {
    let factors = sequence(draws, 5, 4)?;
    let product = product_sequential(&factors).or_fails("the product is refused")?;
    let (rows, cols) = (product.rows(), product.cols());
    let mut entries: Vec<BigUint> = product.numerators().collect();
    if tested.is_altered()
        && let Some(last) = entries.last_mut().filter(|last| !last.is_zero())
    {
        *last -= 1u32;
    }
    for i in 0..rows {
        let sum: BigUint = entries[i * cols..(i + 1) * cols].iter().sum();
        let why = || format!("row {} of the product sums to {sum} of {}", i + 1, product.denominator());
        require(sum == *product.denominator(), why(), || instance(&factors))?;
    }
    let tau = product.tau_1();
    let (zero, one) = (rational(0, 1), rational(1, 1));
    require(zero <= tau && tau <= one, format!("tau_1 of the product is {tau}"), || instance(&factors))?;
    Ok(None)
}

fn tau_1_of_products(draws: &mut Draws, tested: Tested) -> Checked {
    let order = draws.between(1, 4);
    let factors = stochastic_sequence(draws, order, 2, 12).or_fails("a stochastic matrix is refused")?;
    let [right, left] = &factors[..] else { return Ok(None) };
    let product = left.times(right).or_fails("the product is refused")?;
    let product = if tested.is_altered() { right } else { &product };
    // Over the product of the two denominators nothing is divided.
    let over = |matrix: &StochasticMatrix| matrix.tau_1_numerator() * (left.denominator() * right.denominator());
    let (before, after) = (left.tau_1_numerator() * right.tau_1_numerator() * product.denominator(), over(product));
    let holds = after <= before;
    let why = || {
        let (p, q, pq) = (left.tau_1(), right.tau_1(), product.tau_1());
        format!("tau_1(P Q) = {pq} is more than tau_1(P) tau_1(Q) = {p} * {q}")
    };
    if !holds {
        require(false, why(), || instance(&factors))?;
    }
    let unit = left.denominator() * right.denominator() * product.denominator();
    let margin = (before - after).to_f64().zip(unit.to_f64()).map(|(margin, unit)| margin / unit);
    Ok(margin)
}

fn tau_1_twin(draws: &mut Draws, tested: Tested) -> Checked {
    let factors = sequence(draws, 5, 2)?;
    let product = product_sequential(&factors).or_fails("the product is refused")?;
    let plain = product.to_rational_matrix();
    let rows = plain.to_rows();
    let near = |i: usize, j: usize| !tested.is_altered() || i + 1 == j;
    let pairs = || (0..rows.len()).flat_map(|j| (0..j).map(move |i| (i, j))).filter(|&(i, j)| near(i, j));
    let common = |i: usize, j: usize| -> Rational { rows[i].iter().zip(&rows[j]).map(|(a, b)| a.min(b).clone()).sum() };
    let least = pairs().map(|(i, j)| common(i, j)).min().unwrap_or(rational(1, 1));
    let (fast, twin) = (product.tau_1(), rational(1, 1) - least);
    let half = tau_1(&plain);
    let why = format!("the kernel gives {fast}, the definition {half}, the minimum of the rows {twin}");
    require(fast == twin && fast == half, why, || instance(&factors))?;
    Ok(None)
}

fn footprint_of_products(draws: &mut Draws, tested: Tested) -> Checked {
    let order = draws.between(1, 5);
    let factors = stochastic_sequence(draws, order, 2, 5).or_fails("a stochastic matrix is refused")?;
    let [right, left] = &factors[..] else { return Ok(None) };
    let found = left.times(right).or_fails("the product is refused")?.footprint();
    let (a, b) = (left.footprint(), right.footprint());
    let expected: Footprint = if tested.is_altered() { b.times(&a) } else { a.times(&b) };
    let why = format!("the footprint of the product is {found}, the product of the footprints {expected}");
    require(found == expected, why, || instance(&factors))?;
    Ok(None)
}

fn tree_is_sequential(draws: &mut Draws, tested: Tested) -> Checked {
    let factors = sequence(draws, 4, 12)?;
    let mut order = factors.clone();
    if tested.is_altered() {
        order.swap(0, 1);
    }
    let tree = product_tree(&order).or_fails("the product by a tree is refused")?;
    let steps = product_sequential(&factors).or_fails("the product is refused")?;
    let plain: Vec<RationalMatrix> = factors.iter().map(StochasticMatrix::to_rational_matrix).collect();
    let first = plain[0].clone();
    let naive = plain[1..].iter().try_fold(first, |product, factor| factor.times(&product));
    let naive = naive.or_fails("the product of rational matrices is refused")?;
    let tree = tree.to_rational_matrix().reduced();
    let same = tree == steps.to_rational_matrix().reduced() && tree == naive.reduced();
    require(same, "the product by a tree is another one", || instance(&factors))?;
    Ok(None)
}

fn inverse(draws: &mut Draws, tested: Tested) -> Checked {
    let order = draws.between(1, 4);
    let matrix = rational_matrix(draws, order, order).or_fails("a matrix is refused")?;
    let right = rational_matrix(draws, order, 1).or_fails("a matrix is refused")?;
    let described =
        || format!("A = {}, b = {}", shown(matrix.to_rows().iter().map(shown)), shown(right.to_rows().concat()));
    let determinant = matrix.determinant().or_fails("the determinant is refused")?;
    let altered = if tested.is_altered() { matrix.transpose() } else { matrix.clone() };
    let Ok(inverse) = altered.inverse() else {
        require(determinant.is_zero(), format!("the determinant {determinant} is not zero"), described)?;
        return Ok(None);
    };
    require(!determinant.abs().is_zero(), "the determinant is zero, and there is an inverse", described)?;
    let identity = RationalMatrix::identity(order).or_fails("the identity is refused")?;
    let product = matrix.times(&inverse).or_fails("the product is refused")?.reduced();
    require(product == identity.reduced(), "the product with the inverse is not the identity", described)?;
    let solved = matrix.solve(&right).or_fails("the equation is refused")?.reduced();
    let applied = inverse.times(&right).or_fails("the product is refused")?.reduced();
    require(solved == applied, "the solution is not the inverse times the right side", described)?;
    Ok(None)
}
