//! chazelle.ex15 and chazelle.exAB: the two worked examples with small matrices.

use crate::prelude::*;
use crate::printed_decimal;
use algebra::graph::Graph;
use algebra::matrix::{RationalMatrix, StochasticMatrix, prefix_products};
use models::averaging::{Affine, Weights, transition_matrix};
use num_traits::Zero;

/// What Remark 2 prints.
#[derive(Clone, Copy)]
pub struct StretchingVariant {
    numerators: [[i64; 2]; 2],
    denominator: i64,
    second_eigenvalue: &'static str,
    stretched_length: &'static str,
}

/// Whether `x` rounds to the printed decimal: at most half a unit of its last place away.
fn rounds_to(x: &Rational, printed: &str) -> Result<bool, CheckError> {
    let (value, unit) = printed_decimal(printed)?;
    let half_unit = unit / rational(2, 1);
    Ok(value.clone() - &half_unit <= *x && *x <= value + half_unit)
}

pub fn stretching() -> Record<StretchingVariant> {
    let printed = StretchingVariant {
        numerators: [[12, 3], [10, 5]],
        denominator: 15,
        second_eigenvalue: "0.133",
        stretched_length: "1.041",
    };
    Record::new(
        "chazelle.ex15",
        "P = I - CL for one edge with c = (3/15, 10/15), so 0 < c_i d_i < 1. The eigenvalues of a stochastic 2 x 2 \
         matrix are 1 and trace - 1 = 2/15. The length of P(1,0) is sqrt(244)/15. The right eigenvector for 2/15 is \
         (3,-10), whose entries do not sum to zero, and P(1,-1) = (9,5)/15 leaves the orthogonal complement of (1,1).",
        printed,
        check_stretching,
    )
    .clauses(&[
        "P = (1/15) [[12,3],[10,5]] is a matrix of model D.",
        "Its eigenvalues are 1 and 0.133.",
        "It stretches the unit vector (1,0) to one of length 1.041.",
        "The right eigenspace for the subdominant eigenvalue is not orthogonal to 1.",
        "1^perp is not invariant.",
    ])
    .altered("eigenvalue 0.134", |v| v.second_eigenvalue = "0.134")
    .altered("length 1.042", |v| v.stretched_length = "1.042")
    .altered("a row that sums to 16/15", |v| v.numerators = [[12, 4], [10, 5]])
    .control(
        "the symmetric matrix [[12,3],[3,12]]/15, which keeps 1^perp",
        StretchingVariant {
            numerators: [[12, 3], [3, 12]],
            second_eigenvalue: "0.6",
            stretched_length: "0.825",
            ..printed
        },
    )
    .altered("a diagonal entry 0", |v| v.numerators = [[12, 3], [15, 0]])
}

fn check_stretching(variant: &StretchingVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let p = RationalMatrix::from_integers(&variant.numerators, variant.denominator)?;
    let part = |clause: usize, part: &str, detail: String, wrong: Option<String>| {
        unless(wrong, exact(part, detail).on([clause])).for_all()
    };
    let second = p.entry(0, 0) + p.entry(1, 1) - rational(1, 1);
    let other = (!rounds_to(&second, variant.second_eigenvalue)?).then(|| format!("the second eigenvalue is {second}"));
    let image = p.apply(&[rational(1, 1), rational(0, 1)])?;
    let squared: Rational = image.iter().map(Ring::square).sum();
    let (length, unit) = printed_decimal(variant.stretched_length)?;
    let half = unit / rational(2, 1);
    let rounds = (length.clone() - &half).square() <= squared && squared <= (length + half).square();
    let shorter = (!rounds || squared <= rational(1, 1)).then(|| format!("|P(1,0)|² = {squared}"));
    let vector = [p.entry(0, 1), second.clone() - p.entry(0, 0)];
    let scaled: Vec<Rational> = vector.iter().map(|x| x * &second).collect();
    let eigenvector_sum = vector[0].clone() + &vector[1];
    let orthogonal = (p.apply(&vector)? != scaled || eigenvector_sum.is_zero())
        .then(|| format!("the eigenvector for {second} sums to {eigenvector_sum}"));
    let image_sum: Rational = p.apply(&[rational(1, 1), rational(-1, 1)])?.into_iter().sum();
    let invariant = image_sum.is_zero().then(|| "P(1,-1) sums to 0".to_string());
    run.value("second_eigenvalue", second.to_string());
    run.value("stretched_length_squared", squared.to_string());
    Run::all([
        part(1, "a matrix of model D", "I - CL of one edge, 0 < c_i d_i < 1".to_string(), other_than_model_d(&p)?),
        part(2, "the eigenvalues", format!("1 and trace - 1 = {second}"), other),
        part(3, "the stretched length", format!("|P(1,0)|² = {squared}"), shorter),
        part(4, "the eigenvector", format!("multiplied out; it sums to {eigenvector_sum}"), orthogonal),
        part(5, "1^perp", format!("P(1,-1) sums to {image_sum}"), invariant),
    ])
}

/// Why a matrix of two birds is none of model D.
fn other_than_model_d(p: &RationalMatrix) -> Result<Option<String>, CheckError> {
    if let Err(error) = StochasticMatrix::try_from(p) {
        return Ok(Some(format!("P is not row-stochastic: {error}")));
    }
    let (weights, edge) = (Weights::Given(vec![p.entry(0, 1), p.entry(1, 0)]), Graph::path(2));
    let is_one = weights.are_admissible(&edge) && transition_matrix(&edge, &weights)? == *p;
    Ok((!is_one).then(|| "P is not a matrix of model D".to_string()))
}

/// The two matrices and the closed form: entries affine in `u = 2^(-t/2)`, given as `(constant, slope)`.
#[derive(Clone, Copy)]
pub struct ProductABVariant {
    a: [[i64; 3]; 3],
    /// Over 2.
    b: [[i64; 3]; 3],
    form: [[(i64, i64); 3]; 3],
    a_first: bool,
}

impl ProductABVariant {
    fn form_at(&self, u: &Rational) -> Result<RationalMatrix, CheckError> {
        let entry = |&(constant, slope): &(i64, i64)| {
            Affine { constant: rational(constant, 1), slope: rational(slope, 1) }.at(u)
        };
        let rows: Vec<Vec<Rational>> = self.form.iter().map(|row| row.iter().map(entry).collect()).collect();
        Ok(RationalMatrix::from_rows(&rows)?)
    }
}

pub fn product_a_b() -> Record<ProductABVariant> {
    let printed = ProductABVariant {
        a: [[0, 1, 0], [1, 0, 0], [0, 0, 1]],
        b: [[0, 2, 0], [1, 0, 1], [0, 2, 0]],
        form: [[(0, 1), (1, -2), (0, 1)], [(0, 0), (1, 0), (0, 0)], [(0, 0), (1, 0), (0, 0)]],
        a_first: true,
    };
    Record::new(
        "chazelle.exAB",
        "With u = 2^(-t/2) the printed form is affine in u. It equals AB at u = 1/2, and AB times the form at u is \
         the form at u/2: two affine functions of u that agree at two points. By induction it is (AB)^(t/2) for all \
         even t. Both matrices are I - CL with c_i d_i = 1 for birds with neighbours.",
        printed,
        check_product_a_b,
    )
    .altered("the product BA", |v| v.a_first = false)
    .altered("0 for 1 - 2^(1-t/2), as at t = 2", |v| {
        v.form = [[(0, 1), (0, 0), (0, 1)], [(0, 0), (1, 0), (0, 0)], [(0, 0), (1, 0), (0, 0)]]
    })
    .altered("rows 1 and 3 exchanged", |v| {
        v.form = [[(0, 0), (1, 0), (0, 0)], [(0, 0), (1, 0), (0, 0)], [(0, 1), (1, -2), (0, 1)]]
    })
    .altered("B with a positive diagonal", |v| v.b = [[1, 1, 0], [1, 0, 1], [0, 1, 1]])
}

fn check_product_a_b(variant: &ProductABVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let (a, b) = (StochasticMatrix::from_integers(&variant.a, 1)?, StochasticMatrix::from_integers(&variant.b, 2)?);
    let (last, first) = if variant.a_first { (a.clone(), b.clone()) } else { (b.clone(), a.clone()) };
    Run::all([
        for_every_even_time(variant, &last.times(&first)?.to_rational_matrix()),
        multiplied_out(variant, [first, last], run),
        unless(
            within_model_d(&a, &b)?,
            exact("without c_i d_i < 1", "A is I - CL for the edge 1-2, B for the path 1-2-3, each with c_i d_i = 1"),
        ),
    ])
}

/// Why A is not `I - CL` of an edge with `c_i d_i = 1` for birds with neighbours, or B that of a path.
fn within_model_d(a: &StochasticMatrix, b: &StochasticMatrix) -> Result<Option<String>, CheckError> {
    let edge = Graph::from_fn(3, |i, j| (i, j) == (0, 1));
    let unit = |second: Rational| Weights::Given(vec![rational(1, 1), second, rational(1, 1)]);
    for (name, matrix, graph, weights) in
        [("A", a, edge, unit(rational(1, 1))), ("B", b, Graph::path(3), unit(rational(1, 2)))]
    {
        if matrix.to_rational_matrix() != transition_matrix(&graph, &weights)? || weights.are_admissible(&graph) {
            return Ok(Some(format!("{name} is not I - CL with c_i d_i = 1")));
        }
    }
    Ok(None)
}

/// The form is the pair of factors at `t = 2`, and two more factors halve `u`: by induction, for affine functions of `u`, at two points.
fn for_every_even_time(variant: &ProductABVariant, pair: &RationalMatrix) -> Result<Outcome, CheckError> {
    let half = rational(1, 2);
    let form = variant.form_at(&half)?;
    let entries = (0..3).flat_map(|i| (0..3).map(move |j| (i, j)));
    let mut wrong = entries.into_iter().find(|&(i, j)| pair.entry(i, j) != form.entry(i, j)).map(|(i, j)| {
        let (found, claimed) = (pair.entry(i, j), form.entry(i, j));
        format!("t = 2: the entry ({}, {}) of the product is {found}, but the form has {claimed}", i + 1, j + 1)
    });
    for u in [rational(0, 1), rational(1, 1)] {
        if pair.times(&variant.form_at(&u)?)? != variant.form_at(&(u.clone() * &half))? {
            wrong.get_or_insert(format!("two more factors do not halve 2^(-t/2): not at u = {u}"));
        }
    }
    let detail = "base case and induction step, both sides affine in 2^(-t/2)";
    unless(wrong, exact("P(t,1) for every even t", detail)).for_all()
}

/// The same by multiplication, and the smallest nonzero entry goes to zero.
fn multiplied_out(
    variant: &ProductABVariant,
    [first, last]: [StochasticMatrix; 2],
    run: &mut Run,
) -> Result<Outcome, CheckError> {
    const LARGEST_EVEN: usize = 64;
    let factors: Vec<StochasticMatrix> =
        (1..=LARGEST_EVEN).map(|t| if t % 2 == 0 { last.clone() } else { first.clone() }).collect();
    let mut u = rational(1, 1);
    let even = prefix_products(&factors).enumerate().filter(|(k, _)| k % 2 == 1);
    let outcome = run.instances("P(t,1) for t = 2, 4, ..., 64", "multiplied out", even, |(k, product)| {
        u *= rational(1, 2);
        let wrong = product?.to_rational_matrix() != variant.form_at(&u)?;
        Ok(wrong.then(|| format!("t = {}: the product is not the printed form", k + 1)))
    });
    run.value("smallest_entry_at_t_64", u.to_string());
    outcome
}
