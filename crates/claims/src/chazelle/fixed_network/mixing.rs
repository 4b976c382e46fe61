//! chazelle.lem3.2, chazelle.eq3.9, chazelle.eq3.10: how fast the powers of the transition matrix converge.

use super::{FAMILY, Family, Kind, Network, exhaustively, power_of_order, too_slow_for};
use crate::prelude::*;
use algebra::matrix::{RationalMatrix, tau_1};
use models::averaging::contraction;
use num_bigint::{BigInt, BigUint};
use num_traits::Signed;

/// Precision of the exponentials.
const PRECISION: u32 = 96;

/// `n^factor e^(-s n^-gap)`, enclosed.
pub(super) fn bound(n: usize, factor: i32, gap: i32, s: &Rational) -> Result<Interval, CheckError> {
    let interval = |q: &Rational| Interval::from_rational(q, PRECISION);
    let decay = interval(&(-s * power_of_order(n, -gap))).exp()?;
    Ok(interval(&power_of_order(n, factor)) * decay)
}

/// Whether `x <= bound`; where the enclosure is too wide to tell, that is an error.
pub(super) fn at_most(x: &Rational, bound: &Interval) -> Result<bool, CheckError> {
    quotient_at_most(&x.numer(), &x.denom(), bound)
}

/// Whether `p/q <= bound`, for long `p` and `q` that need not be in lowest terms.
fn quotient_at_most(p: &BigInt, q: &BigInt, bound: &Interval) -> Result<bool, CheckError> {
    let (lo, hi) = bound.to_rationals();
    match (p * lo.denom() <= lo.numer() * q, p * hi.denom() > hi.numer() * q) {
        (true, _) => Ok(true),
        (_, true) => Ok(false),
        _ => Err(CheckError::Other("an exponential could not be told from a rational".into())),
    }
}

/// The powers of a matrix for the exponents 0, .., 8 and then for powers of two, the last of them at least `8 n³`:
/// there the bounds that are tested have become small.
pub(super) fn some_powers(p: &RationalMatrix) -> Result<Vec<(u64, RationalMatrix)>, CheckError> {
    let last = 8 * (p.rows() as u64).pow(3);
    let mut powers = vec![(0, RationalMatrix::identity(p.rows())?)];
    for s in 1..=8 {
        let next = powers[s as usize - 1].1.times(p)?.reduced();
        powers.push((s, next));
    }
    while powers[powers.len() - 1].0 < last {
        let s = 2 * powers[powers.len() - 1].0;
        let half = &powers[powers.len() - 1].1;
        let next = half.times(half)?;
        powers.push((s, next));
    }
    Ok(powers)
}

/// Which networks, and a factor of the lower bound of `1 - mu`.
#[derive(Clone, Copy)]
pub struct SecondEigenvalueVariant {
    family: Family<'static>,
    factor: (i64, i64),
}

impl SecondEigenvalueVariant {
    /// The bounds of `1 - lambda_2` and `1 + lambda_n`: first for any weights, then by `n` alone.
    fn bounds(&self, network: &Network) -> [(Rational, Rational); 2] {
        let (n, factor) = (network.order(), rational(self.factor.0, self.factor.1));
        let trace: Rational = network.c.iter().map(Rational::recip).sum();
        let least_stay = (0..n).map(|i| network.p.entry(i, i)).min().unwrap_or_default();
        let paths = rational(4, n as i64 - 1) / trace;
        let of_n = match network.kind {
            Kind::Lazy => rational(8, 3) / (power_of_order(n, 1) * power_of_order(n - 1, 2)),
            Kind::Uneven | Kind::Tiny => rational(4, n as i64 - 1) * power_of_order(n, -3),
            Kind::Vicsek | Kind::Uniform | Kind::Whole => rational(4, n as i64 - 1) * power_of_order(n, -2),
        };
        let least_of_n = match network.kind {
            Kind::Lazy => rational(2, 3),
            _ => of_n.clone(),
        };
        [(paths * &factor, least_stay * rational(2, 1) * &factor), (of_n * &factor, least_of_n * &factor)]
    }

    fn fails_at(&self, network: &Network) -> Result<Option<String>, CheckError> {
        let spectrum = network.p.characteristic_polynomial()?;
        if network.order() == 1 {
            // No k > 1: mu is the maximum of nothing, 0 = 1 - n^-a for every a.
            return Ok((spectrum.multiplicity(&rational(1, 1)) != 1).then(|| "P is not [1]".into()));
        }
        for (above, below) in self.bounds(network) {
            let (high, low) = (rational(1, 1) - &above, &below - rational(1, 1));
            let (more, less) = (spectrum.count_above(&high), spectrum.count_below(&low));
            if more != 1 || less != 0 {
                return Ok(Some(format!("{more} eigenvalues lie above {high}, {less} below {low}")));
            }
        }
        Ok(None)
    }
}

pub fn second_eigenvalue() -> Record<SecondEigenvalueVariant> {
    Record::new(
        "chazelle.lem3.2",
        "Rayleigh quotient: the edges of a path between the largest and the least value of f give the Dirichlet form \
         at least (max f - min f)²/((n-1) tr C^-1), the variance is at most (max f - min f)²/4, so 1 - lambda_2 >= \
         4/((n-1) tr C^-1). P - (min p_ii) I is a multiple of a stochastic matrix, so 1 + lambda_n >= 2 min p_ii. \
         Hence 1 - mu >= 4/((n-1) n^(a+1)) >= n^-(a+2); for lazy weights 1 - mu >= min(2/3, 8/(3n(n-1)²)), for c_i = \
         1/(d_i+1) 1 - mu >= 4/(n²(n-1)). Two birds attain the bound of lambda_2. A single bird has no lambda_k, k > \
         1, and mu = 0 (notes/chazelle_fixed_network.md).",
        SecondEigenvalueVariant { family: Family::PRINTED, factor: (1, 1) },
        check_second_eigenvalue,
    )
    .reading(
        "Weights are rationals of O(log n) bits, denominators at most n^a (Remark 3, Lemma 2.2); without that mu \
              can be as near to 1 as one likes.",
    )
    .altered("bounds larger by 1/100", |v| v.factor = (101, 100))
    .altered("not connected", |v| v.family = Family::ANY_GRAPH)
    .altered("c_i d_i = 1", |v| v.family = Family::WHOLE)
    .altered("weights of 2n bits", |v| v.family = Family::TINY)
}

fn check_second_eigenvalue(variant: &SecondEigenvalueVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let part = "1 - mu >= n^-(a+2), for weights with denominators up to n^a";
    let networks = variant.family.networks(run.cases(6, 7))?;
    let detail = format!(
        "{FAMILY} on up to 6 birds (7 with --full), three kinds of weights; eigenvalues beyond the proved bounds \
         counted exactly"
    );
    exhaustively(&networks, run, part, detail, |network| variant.fails_at(network))
}

/// `|(P^s)_ij - pi_j| <= n^factor e^(-s n^-gap)`, exponents shifted from the proved ones.
#[derive(Clone, Copy)]
pub struct EntrywiseVariant {
    family: Family<'static>,
    factor_shift: i32,
    gap_shift: i32,
    /// `pi_j`, or `pi_i`.
    by_column: bool,
}

impl EntrywiseVariant {
    fn fails_at(&self, network: &Network) -> Result<Option<String>, CheckError> {
        let (n, exponents, pi) = (network.order(), network.exponents(), network.pi());
        for (s, power) in some_powers(&network.p)? {
            let (factor, gap) = (exponents.factor + self.factor_shift, exponents.gap + self.gap_shift);
            let bound = bound(n, factor, gap, &rational(s as i64, 1))?;
            let denominator = power.denominator();
            for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
                let pi = &pi[if self.by_column { j } else { i }];
                let difference = (&power.row(i)[j] * pi.denom() - pi.numer() * denominator).abs();
                let scale = denominator * pi.denom();
                if !quotient_at_most(&difference, &scale, &bound)? {
                    let difference = Rational::new(difference, scale);
                    return Ok(Some(format!("s = {s}: entry ({}, {}) differs by {difference}", i + 1, j + 1)));
                }
            }
        }
        Ok(None)
    }
}

pub fn entrywise_rate() -> Record<EntrywiseVariant> {
    Record::new(
        "chazelle.eq3.9",
        "By (3.8) and Cauchy-Schwarz, |(P^s)_ij - pi_j| <= sqrt(c_i/c_j) sqrt((1-pi_i)(1-pi_j)) mu^s for all s >= 0. \
         With Lemma 3.2 (weights with denominators up to n^a) the right side is at most n^(a/2) e^(-s n^-(a+2)); for \
         lazy weights and for c_i = 1/(d_i+1) it is at most n e^(-s n^-3) (notes/chazelle_fixed_network.md).",
        EntrywiseVariant { family: Family::PRINTED, factor_shift: 0, gap_shift: 0, by_column: true },
        check_entrywise_rate,
    )
    .altered("1/n in place of n^O(1)", |v| v.factor_shift = -2)
    .altered("e^(-s n^-2)", |v| v.gap_shift = -1)
    .altered("pi_i in place of pi_j", |v| v.by_column = false)
    .altered("not connected", |v| v.family = Family::ANY_GRAPH)
    .altered("c_i d_i = 1", |v| v.family = Family::WHOLE)
}

fn check_entrywise_rate(variant: &EntrywiseVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let part = "|(P^s)_ij - pi_j| <= n^(a/2) e^(-s n^-(a+2))";
    let networks = variant.family.networks(run.cases(5, 6))?;
    let detail = format!(
        "{FAMILY} on up to 5 birds (6 with --full), three kinds of weights, s up to 8 n^3 and more; powers exact, \
         exponentials enclosed"
    );
    let exponent =
        exact("the exponent of n", "lazy barbells of 6, 24 and 78 birds are not slower, by Rayleigh quotients");
    Run::all([
        exhaustively(&networks, run, part, detail, |network| variant.fails_at(network)),
        run.every(exponent, [3 + variant.gap_shift], too_slow_for),
    ])
}

/// `tau(P^s) <= 1 - sum_k (pi_k + sign n^factor e^(-s n^-gap)) < most` for `s > n^(gap + margin)`.
#[derive(Clone, Copy)]
pub struct HalvingVariant {
    family: Family<'static>,
    sign: i64,
    factor_shift: i32,
    margin: i32,
    most: (i64, i64),
}

/// Numbers of birds for which the second inequality is evaluated.
const MOST_BIRDS: usize = 64;

impl HalvingVariant {
    /// `1 - sum_k (pi_k + sign epsilon)`.
    fn middle(&self, pi: &[Rational], n: usize, epsilon: &Interval) -> Interval {
        let rest = rational(1, 1) - pi.iter().sum::<Rational>();
        epsilon.rational(&rest) + epsilon.integer(-self.sign * n as i64) * epsilon
    }

    /// The first inequality on a network, and that `tau` is below `most` in time.
    fn fails_at(&self, network: &Network) -> Result<Option<String>, CheckError> {
        let (n, exponents, pi) = (network.order(), network.exponents(), network.pi());
        for (s, power) in some_powers(&network.p)?.into_iter().skip(1) {
            let epsilon = bound(n, exponents.factor + self.factor_shift, exponents.gap, &rational(s as i64, 1))?;
            let tau = tau_1(&power);
            if !at_most(&tau, &self.middle(&pi, n, &epsilon))? {
                return Ok(Some(format!("s = {s}: tau is {tau}, the sum over pi = ({}) is smaller", list(&pi))));
            }
        }
        // tau(P^2k) <= tau(P^k)² <= 1/4, and tau does not increase.
        let steps = contraction(&network.p)?.steps * 2u8;
        let limit = BigUint::from(n).pow((exponents.gap + self.margin).unsigned_abs());
        Ok((steps > limit + 1u8).then(|| format!("tau is shown to be 1/4 only after {steps} steps")))
    }

    /// The second inequality at the first `s`, for the exponents of all kinds: `sum pi_k = 1` is all it needs.
    fn second_fails(&self, n: usize, gap: i32) -> Result<Option<String>, CheckError> {
        let first = power_of_order(n, gap + self.margin) + rational(1, 1);
        let middle = self.middle(&[rational(1, 1)], n, &bound(n, 1 + self.factor_shift, gap, &first)?);
        let exceeds = middle.to_rationals().1 >= rational(self.most.0, self.most.1);
        Ok(exceeds.then(|| format!("n = {n}, s = {first}: the sum is {}", interval_value(&middle, 6))))
    }
}

pub fn halving_time() -> Record<HalvingVariant> {
    Record::new(
        "chazelle.eq3.10",
        "tau_1(P^s) = 1 - min_ij sum_k min((P^s)_ik, (P^s)_jk), and by (3.9) both entries are at least pi_k - eps \
         with eps = n^(a/2) e^(-s n^-(a+2)). The sum over k is 1 - n eps. For s > n^(2a+4) n eps <= sqrt(x) e^-x with \
         x = n^(a+2) >= 1, which is at most 1/e < 1/2. For lazy weights and for c_i = 1/(d_i+1), eps = n e^(-s n^-3) \
         and c_0 = 5 will do (notes/chazelle_fixed_network.md).",
        HalvingVariant { family: Family::PRINTED, sign: -1, factor_shift: 0, margin: 2, most: (1, 2) },
        check_halving_time,
    )
    .reading("tau is tau_1; weights with denominators up to n^a.")
    .clauses(&[
        "For s > n^{c_0}, tau(P^s) <= 1 - sum_k (pi_k - n^{O(1)} e^{-s n^{-O(1)}}).",
        "For s > n^{c_0}, 1 - sum_k (pi_k - n^{O(1)} e^{-s n^{-O(1)}}) < 1/2.",
    ])
    .altered("pi_k + n^O(1) e^..", |v| v.sign = 1)
    .altered("1/n in place of n^O(1)", |v| v.factor_shift = -2)
    .altered("for s > n^3", |v| v.margin = 0)
    .altered("less than 1/8 at once", |v| v.most = (1, 8))
    .altered("not connected", |v| v.family = Family::ANY_GRAPH)
}

fn check_halving_time(variant: &HalvingVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let networks = variant.family.networks(run.cases(5, 6))?;
    let detail = format!(
        "{FAMILY} on up to 5 birds (6 with --full), three kinds of weights, s from 1 to 8 n^3 and more; and powers \
         until tau <= 1/4"
    );
    let part = "the first inequality, and tau(P^s) < 1/2";
    let second =
        certified("the second inequality", "at s = n^c_0 + 1 for n = 1, .., 64, where it decreases from then on");
    let cases = (1..=MOST_BIRDS).flat_map(|n| [3, 4].map(|gap| (n, gap)));
    Run::all([
        exhaustively(&networks, run, part, detail, |network| variant.fails_at(network)).on([1]),
        run.every(second.on([2]), cases, |(n, gap)| variant.second_fails(n, gap)),
    ])
}
