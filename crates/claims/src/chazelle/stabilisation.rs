//! chazelle.stab, chazelle.eq3.5 and chazelle.eq3.6: the stabilisers and the product of their blocks.

use super::entries::small_weights;
use super::sequences::{histories, in_turn, show_history};
use crate::prelude::*;
use algebra::matrix::{RationalMatrix, Stabiliser, tau_1, tau_2_squared};
use models::averaging::{NetworkHistory, Weights, transition_matrix};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::Rng;

const LEVELS: usize = 3;

/// Checks all sequences of 6, 4, 2 networks on 2, 3, 4 birds (`shorter`: 4, 3, 1) with a constant end, then random
/// ones on up to 6.
fn over_histories<C: Into<Counterexample>>(
    run: &Run,
    shorter: bool,
    part: &str,
    detail: &str,
    mut fails: impl FnMut(&NetworkHistory, &mut ChaCha8Rng) -> Result<Option<C>, CheckError>,
) -> Result<Outcome, CheckError> {
    let mut random = run.random(0);
    let lengths = if shorter { [1, 4, 3, 1] } else { [3, 6, 4, 2] };
    let all = exhaustive(format!("{part}, all sequences"), detail);
    let sampled = fuzzed(format!("{part}, random sequences"), "random sequences of 8 networks on 3 to 6 birds");
    Run::all([
        run.every(all, histories((1..).zip(lengths)), |history| fails(&history, &mut random)),
        run.every(sampled, 0..run.cases(60, 2000), |_| {
            let order = 3 + random.next_u32() as usize % 4;
            let history = NetworkHistory::random(order, 8, 1, &mut random);
            fails(&history, &mut random)
        }),
    ])
}

/// `V_0 = [n]`, `V_1`, ... and `T_0 = 0`, `T_1`, ... for `s = 1`.
struct Levels {
    members: Vec<Vec<usize>>,
    times: Vec<usize>,
}

impl Levels {
    fn of(history: &NetworkHistory) -> Self {
        let found = history.stabilisers(LEVELS);
        let first = Stabiliser { time: 0, members: (0..history.order()).collect() };
        let (times, members) = std::iter::once(first).chain(found).map(|s| (s.time, s.members)).unzip();
        Levels { members, times }
    }
}

#[derive(Clone, Copy)]
pub struct NestedVariant {
    strictly: bool,
    /// Separation for `t > T_1` or already for `t >= T_1`.
    at_t1: bool,
    /// The column that is claimed to be positive.
    column: usize,
    /// `V_1` from the first row instead of the first column.
    from_row: bool,
}

impl NestedVariant {
    fn fails_at(&self, history: &NetworkHistory) -> Option<String> {
        let levels = Levels::of(history);
        let place = |what: String| Some(format!("{}: {what}", show_history(history)));
        for k in 1..levels.members.len() {
            let (outer, inner) = (&levels.members[k - 1], &levels.members[k]);
            if !inner.iter().all(|i| outer.contains(i)) || (self.strictly && inner.len() == outer.len()) {
                return place(format!("V_{} = {}, V_{k} = {}", k - 1, birds(outer), birds(inner)));
            }
            if levels.times[k] <= levels.times[k - 1] {
                return place(format!("T_{k} = {}", levels.times[k]));
            }
            // The product P(T_k, T_{k-1} + 1) of all birds: the block must be positive there.
            let (first, last) = (levels.times[k - 1] + 1, levels.times[k]);
            let product = (first + 1..=last)
                .fold(history.footprint(first).clone(), |product, t| history.footprint(t).times(&product));
            if let Some(&column) = outer.get(self.column)
                && let Some(i) = inner.iter().find(|&&i| !product.get(i, column))
            {
                return place(format!("P({last}, {first}) is 0 at ({}, {})", i + 1, column + 1));
            }
            let stable = levels.times[k];
            let inner = if self.from_row && k == 1 {
                outer.iter().copied().filter(|&j| product.get(0, j)).collect()
            } else {
                inner.clone()
            };
            let from = if self.at_t1 { stable } else { stable + 1 };
            for t in from..=history.constant_from().max(from) {
                let outside = |j: &usize| outer.contains(j) && !inner.contains(j);
                let graph = history.at(t);
                let edge = graph
                    .edges()
                    .into_iter()
                    .find(|(i, j)| (inner.contains(i) && outside(j)) || (inner.contains(j) && outside(i)));
                if let Some((i, j)) = edge {
                    let set = birds(&inner);
                    return place(format!(
                        "T_{k} = {stable}, V_{k} = {set}, and {}-{} is an edge at t = {t}",
                        i + 1,
                        j + 1
                    ));
                }
            }
        }
        None
    }
}

fn birds(members: &[usize]) -> String {
    let names: Vec<String> = members.iter().map(|i| (i + 1).to_string()).collect();
    format!("{{{}}}", names.join(", "))
}

pub fn nested() -> Record<NestedVariant> {
    Record::new(
        "chazelle.stab",
        "V_k indexes rows of a matrix on V_{k-1}, so it is contained in it. An edge at t > T_k between i in V_k and j \
         in V_{k-1} \\ V_k would give the column a one in row j after T_k, when nothing changes any more. So P(t) on \
         V_{k-1} is block diagonal for t > T_k, and products of restrictions are restrictions of products. The first \
         bird stays first: its diagonal entry is positive, so it belongs to every V_k, and the rows of V_k are by \
         definition those with a positive entry in its column.",
        NestedVariant { strictly: false, at_t1: false, column: 0, from_row: false },
        |variant, run| {
            let cases = "all sequences of 6, 4, 2 networks on 2, 3, 4 birds with a constant end, three levels";
            over_histories(run, false, "nested, block diagonal, positive first columns", cases, |history, _| {
                Ok(variant.fails_at(history))
            })
            .on([1, 2, 3])
        },
    )
    .clauses(&[
        "The stabilizers are nested, V_1 contains V_2 contains ....",
        "For t > T_1 no edge of G_t joins V_1 to its complement, so P(t) is block diagonal.",
        "The first column of each P_{|V_i x V_{i-1}}(T_i, T_{i-1}+1) consists entirely of positive entries.",
    ])
    .altered("strictly nested", |v| v.strictly = true)
    .altered("separated at t = T_1 already", |v| v.at_t1 = true)
    .altered("the second column", |v| v.column = 1)
    .altered("V_1 from the first row", |v| v.from_row = true)
}

/// `P(t)` for all `t` of a history, with exact products.
struct Factors<'a> {
    history: &'a NetworkHistory,
    matrices: Vec<RationalMatrix>,
}

impl<'a> Factors<'a> {
    /// Lazy weights on up to 3 birds, random ones of denominator `n²` on more.
    fn new(history: &'a NetworkHistory, random: &mut ChaCha8Rng) -> Result<Self, CheckError> {
        let matrix = |t: usize| {
            let graph = history.at(t);
            let weights = if history.order() <= 3 { Weights::Lazy } else { small_weights(graph, 2, random) };
            Ok(transition_matrix(graph, &weights)?)
        };
        Ok(Factors { history, matrices: (1..=history.constant_from()).map(matrix).collect::<Result<_, CheckError>>()? })
    }

    /// `P(t, s)`; the identity for `t < s`.
    fn product(&self, t: usize, s: usize) -> Result<RationalMatrix, CheckError> {
        let at = |u: usize| &self.matrices[u.min(self.matrices.len()) - 1];
        let identity = RationalMatrix::identity(self.history.order())?;
        (s..=t).try_fold(identity, |product, u| Ok(at(u).times(&product)?.reduced()))
    }
}

/// The index sets of two factors, and where the products start.
#[derive(Clone, Copy)]
pub struct BlocksVariant {
    /// The columns of the factor of `T_2`: `V_1`, or `V_k`.
    second_has_v1: bool,
    /// The rows of the factor of `T_1`: `V_1`, or `V_k`.
    first_has_v1: bool,
    /// The product after `T_{i-1}` starts this many steps later.
    gap: usize,
}

impl BlocksVariant {
    fn fails_at(
        &self,
        history: &NetworkHistory,
        random: &mut ChaCha8Rng,
    ) -> Result<Option<Counterexample>, CheckError> {
        let levels = Levels::of(history);
        let factors = Factors::new(history, random)?;
        for k in 1..levels.members.len() {
            let (sets, times) = (&levels.members, &levels.times);
            for t in times[k] + 1..=times[k] + 2 {
                let left = factors.product(t, 1)?.block(&sets[k], &sets[0])?;
                let mut right = factors.product(t, times[k] + self.gap)?.block(&sets[k], &sets[k])?;
                for i in (1..=k).rev() {
                    let rows = if i == 1 && !self.first_has_v1 { &sets[k] } else { &sets[i] };
                    let cols = if i == 2 && !self.second_has_v1 { &sets[k] } else { &sets[i - 1] };
                    let gap = if i == 1 { 1 } else { self.gap };
                    let factor = factors.product(times[i], times[i - 1] + gap)?.block(rows, cols)?;
                    if right.cols() != factor.rows() {
                        let text = format!(
                            "{}, k = {k}: {} columns meet {} rows at the factor of T_{i}",
                            show_history(history),
                            right.cols(),
                            factor.rows()
                        );
                        return Ok(Some(Counterexample::new(text, [in_turn(history.graphs())])));
                    }
                    right = right.times(&factor)?.reduced();
                }
                if left != right {
                    let entry = |m: &RationalMatrix| {
                        m.to_rows()
                            .iter()
                            .map(|r| r.iter().map(ToString::to_string).collect::<Vec<_>>().join(" "))
                            .collect::<Vec<_>>()
                            .join("; ")
                    };
                    let text = format!(
                        "{}, lazy weights, s = 1, k = {k}, T = {:?}, V_{k} = {}, t = {t}: the block is [{}], the \
                         product is [{}]",
                        show_history(history),
                        &times[1..=k],
                        birds(&sets[k]),
                        entry(&left),
                        entry(&right)
                    );
                    return Ok(Some(Counterexample::new(text, [in_turn(history.graphs())])));
                }
            }
        }
        Ok(None)
    }
}

pub fn blocks() -> Record<BlocksVariant> {
    Record::new(
        "chazelle.eq3.5",
        "After T_i the matrices on V_{i-1} are block diagonal with the block V_i, so the rows V_i of P(t, T_{i-1}+1) \
         on V_{i-1} are P_{|V_i x V_i}(t, T_i+1) P_{|V_i x V_{i-1}}(T_i, T_{i-1}+1); the rows V_k of that are rows of \
         the left factor only. Iterated, the factor of T_2 has the columns V_1 and the factor of T_1 the rows V_1. \
         With V_k in both places the paths through V_1 \\ V_k are lost.",
        BlocksVariant { second_has_v1: false, first_has_v1: false, gap: 1 },
        |variant, run| {
            let cases = "all sequences of 4, 3, 1 networks on 2, 3, 4 birds with a constant end, k = 1, 2, 3, exact products";
            over_histories(run, true, "the factorisation", cases, |history, random| variant.fails_at(history, random))
        },
    )
    .reading(
        "the stabilisers of the proof of Lemma 3.1, for P(t) with positive diagonals and symmetric footprints: V_0 is the \
         set of all birds and T_0 = s - 1; T_k is the first time after T_(k-1) from which on the footprint of \
         P_{|V_(k-1) x V_(k-1)}(t, T_(k-1)+1) stays the same, and V_k is the set of the rows of that footprint with a one \
         in the column of the first bird",
    )
    .repaired(
        Fault::Typo,
        "Let P(s), P(s+1), ... be stochastic n x n matrices with positive diagonals and symmetric footprints (the places of the nonzero \
         entries), P(t,s) = P(t) P(t-1) ... P(s), and A_{|U x W} the rows U and columns W of A. Let V_0 be the set of all birds 1, ..., n, \
         T_0 = s-1, and for k = 1, 2, ... T_k the first time after T_{k-1} from which on the footprint of P_{|V_{k-1} x V_{k-1}}(t, \
         T_{k-1}+1) stays the same, and V_k (the stabiliser) the set of the rows of that footprint with a one in the column of bird 1. Then \
         for k >= 1 and t > T_k: P_{|V_k x V_0}(t,s) = P_{|V_k x V_k}(t,T_k+1) P_{|V_k x V_{k-1}}(T_k,T_{k-1}+1) ... P_{|V_2 x \
         V_1}(T_2,T_1+1) P_{|V_1 x V_0}(T_1,T_0+1).",
        BlocksVariant { second_has_v1: true, first_has_v1: true, gap: 1 },
    )
    .altered("V_2 x V_k, V_1 x V_0", |v| v.second_has_v1 = false)
    .altered("V_2 x V_1, V_k x V_0", |v| v.first_has_v1 = false)
    .altered("the factor at T_i taken twice", |v| v.gap = 0)
    .altered("the factor at T_i + 1 left out", |v| v.gap = 2)
}

/// The constants of the two inequalities.
#[derive(Clone, Copy)]
pub struct ContractionVariant {
    /// The square of the constant that is printed as the square root of 2.
    squared_constant: (i64, i64),
    /// `e(nu)` in `e^(-k nu^(-a e(nu)))`, a = 2.
    exponent: fn(u32) -> u32,
    /// Whether the last block `P_{|V_k x V_k}` is in the product.
    last_block: bool,
    /// A power of the whole product.
    power: u64,
}

impl ContractionVariant {
    fn fails_at(&self, history: &NetworkHistory, random: &mut ChaCha8Rng) -> Result<Option<String>, CheckError> {
        const DENOMINATOR_POWER: u32 = 2;
        const PRECISION: u32 = 128;
        let levels = Levels::of(history);
        let factors = Factors::new(history, random)?;
        let (sets, times) = (&levels.members, &levels.times);
        let nu = history.order() as i64;
        let beta = rational(1, nu).pow((DENOMINATOR_POWER * (self.exponent)(nu as u32)) as i32);
        let mut contraction = rational(1, 1);
        for k in 1..sets.len() {
            let factor = factors.product(times[k], times[k - 1] + 1)?;
            contraction *= tau_1(&factor.block(&sets[k], &sets[k - 1])?);
            let exponent = Interval::from_rational(&-(beta.clone() * rational(k as i64, 1)), PRECISION);
            let (bound, _) = exponent.exp()?.to_rationals();
            for t in times[k] + 1..=times[k] + 2 {
                let last = tau_1(&factors.product(t, times[k] + 1)?.block(&sets[k], &sets[k])?);
                let product = if self.last_block { contraction.clone() * last } else { contraction.clone() };
                let left = tau_2_squared(&factors.product(t, 1)?.block(&sets[k], &sets[0])?);
                let (p, q) = self.squared_constant;
                let place = |what: String| Ok(Some(format!("{}, k = {k}, t = {t}: {what}", show_history(history))));
                let right = product.power(self.power).square() * rational(p, q);
                if left > right {
                    return place(format!("tau_2 squared is {left}, more than {right}"));
                }
                if product > bound {
                    return place(format!(
                        "the product of the coefficients is {product}, more than exp(-{k} * {beta})"
                    ));
                }
            }
        }
        Ok(None)
    }
}

pub fn contraction() -> Record<ContractionVariant> {
    Record::new(
        "chazelle.eq3.6",
        "The blocks of (3.5) as corrected are row-stochastic. Lemma 2.4, once for each factor, and tau_2(I) <= \
         sqrt(2) give the first inequality. The first column of each P_{|V_i x V_{i-1}} is at least beta = \
         nu^(-a(nu-1)), which is more than nu^(-a nu²) (lem2.2.entries): any two rows overlap by beta, tau_1 <= 1 - \
         beta <= e^(-beta), and the coefficient of the last block is at most 1. Checked with a = 2.",
        ContractionVariant { squared_constant: (2, 1), exponent: |nu| nu * nu, last_block: true, power: 1 },
        |variant, run| {
            let cases =
                "all sequences of 4, 3, 1 networks on 2, 3, 4 birds with a constant end, k = 1, 2, 3, exact products";
            over_histories(run, true, "both inequalities", cases, |history, random| variant.fails_at(history, random))
                .on([1, 2])
        },
    )
    .clauses(&[
        "tau_2(P_{|V_k x V_0}(t,s)) <= sqrt(2) tau_1(P_{|V_k x V_k}(t,T_k+1)) prod_{i=1}^k tau_1(P_{|V_i x \
         V_{i-1}}(T_i,T_{i-1}+1)).",
        "The right side is at most sqrt(2) e^{-k nu^{-O(nu^2)}}.",
    ])
    .altered("1.41 for sqrt(2)", |v| v.squared_constant = (19881, 10000))
    .altered("e^(-k)", |v| v.exponent = |_| 0)
    .altered("the square of the product", |v| v.power = 2)
}
