//! chazelle.lem3.5: how long the numbers of the limit configuration are.

use super::limits::limit_of_lemma_3_3;
use super::{FAMILY, Family, Kind, Network, exhaustively, power_of_order};
use crate::prelude::*;
use algebra::matrix::RationalMatrix;
use arithmetic::common_denominator;
use models::averaging::equal_rows;
use num_bigint::BigInt;
use num_traits::{Signed, Zero};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::Rng;

/// The common denominator `D = R^k T p` and the bound of its length.
#[derive(Clone, Copy)]
pub struct ShortLimitVariant {
    /// The power of the common denominator `R` of `pi`.
    of_pi: usize,
    /// Whether the number `T` of spanning trees is a factor.
    trees: bool,
    /// `n^(beta n)` bounds numerators and denominators; otherwise `n^3`.
    exponential: bool,
}

impl ShortLimitVariant {
    fn denominator(&self, network: &Network) -> Result<BigInt, CheckError> {
        let n = network.order();
        let reciprocals: Vec<Rational> = network.c.iter().map(Rational::recip).collect();
        // The number of spanning trees is det(L + J/n²).
        let all_ones = RationalMatrix::from_rows(&vec![vec![power_of_order(n, -2); n]; n])?;
        let trees = network.graph.laplacian()?.plus(&all_ones)?.determinant()?;
        let trees = if self.trees { trees.to_integer() } else { BigInt::from(1) };
        Ok(num_traits::pow(common_denominator(&network.pi()), self.of_pi) * trees * common_denominator(&reciprocals))
    }

    /// `n^(beta n)` with the proved `beta`, for numerators and denominators.
    fn longest(&self, network: &Network) -> Rational {
        let n = network.order();
        let beta = if network.kind == Kind::Uneven { 12 } else { 5 };
        power_of_order(n, if self.exponential { beta * n as i32 } else { 3 })
    }

    fn fails_at(&self, network: &Network, random: &mut ChaCha8Rng) -> Result<Option<String>, CheckError> {
        let n = network.order();
        let Some(gamma) = limit_of_lemma_3_3(network)? else { return Ok(Some("a singular matrix".into())) };
        if n == 1 {
            // No bits are needed: both are 0.
            return Ok((!gamma.entry(0, 0).is_zero()).then(|| "Gamma is not 0".into()));
        }
        let (denominator, longest) = (Rational::from_integer(self.denominator(network)?), self.longest(network));
        let short = |x: &Rational, denominator: &Rational, longest: &Rational| {
            let numerator = x * denominator;
            numerator.is_integer() && numerator.abs() <= *longest && denominator <= longest
        };
        if let Some(x) = gamma.to_rows().iter().flatten().find(|x| !short(x, &denominator, &longest)) {
            return Ok(Some(format!(
                "Gamma has the entry {x}; the common denominator is to be {denominator}, both at most {longest}"
            )));
        }
        // Coordinates with numerators and denominators up to n, in one dimension: 2n numbers, so n^2n bounds their
        // common denominator, and the limit is a sum of at most n^3 times as much.
        let mut coordinate =
            || rational(i64::from(random.next_u32() % (n as u32 + 1)), 1 + i64::from(random.next_u32() % n as u32));
        let (x, v): (Vec<Rational>, Vec<Rational>) = (0..n).map(|_| (coordinate(), coordinate())).unzip();
        let of_input = Rational::from_integer(common_denominator(x.iter().chain(&v)));
        let relative = network.identity()?.minus(&equal_rows(&network.pi())?)?.apply(&x)?;
        let limit = relative.iter().zip(gamma.apply(&v)?).map(|(a, b)| a + b);
        let (denominator, longest) = (denominator * of_input, longest * power_of_order(n, 2 * n as i32 + 3));
        Ok(limit.into_iter().find(|x| !short(x, &denominator, &longest)).map(|x| format!("a coordinate of x^r is {x}")))
    }
}

pub fn short_limit() -> Record<ShortLimitVariant> {
    Record::new(
        "chazelle.lem3.5",
        "Gamma = (I - 1 pi^T) X (I - pi 1^T) C^-1 with X the inverse of the Laplacian without its last row and \
         column, bordered by zeros: its denominator is the number T of spanning trees, at most n^(n-2), and its \
         entries lie in [0, n-1]. With the common denominators R of pi and p of C^-1, D = R² T p is a common \
         denominator of Gamma. R <= n^(a+1) p, p <= n^(an), |Gamma_ij| <= 2(n-1) n^a: numerators and denominators \
         stay below n^((5a+2)n); for lazy weights and c_i = 1/(d_i+1), D <= 2 n^(n+2). x^r needs the denominators of \
         x(0) and v(1) too, at most n^(2adn) (notes/chazelle_fixed_network.md). One bird: both are 0.",
        ShortLimitVariant { of_pi: 2, trees: true, exponential: true },
        check_short_limit,
    )
    .reading("The dimension d is fixed, input and weights have numerators and denominators of at most n^a.")
    .clauses(&[
        "The coordinates of the limit configuration x^r are same-denominator rationals over O(n log n) bits.",
        "The elements of Gamma are same-denominator rationals over O(n log n) bits.",
    ])
    .altered("the denominator of pi only once", |v| v.of_pi = 1)
    .altered("without the spanning trees", |v| v.trees = false)
    .altered("3 log n bits", |v| v.exponential = false)
}

fn check_short_limit(variant: &ShortLimitVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let part = "one denominator D = R² T p for Gamma, and with that of the input for x^r; all below n^(beta n)";
    let networks = Family::PRINTED.networks(run.cases(5, 6))?;
    let mut random = run.random(0);
    let detail =
        format!("{FAMILY} on up to 5 birds (6 with --full), three kinds of weights; for x^r one random input each");
    exhaustively(&networks, run, part, detail, |network| variant.fails_at(network, &mut random)).on([1, 2])
}
