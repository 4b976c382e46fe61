//! tanner2.lem1, lem2, Q, Qjump, Qdot, eq13, eq13.interval: the saturated potential and the energy Q.

use super::arbitrary::dot;
use super::random_vectors;
use algebra::graph::Graph;
use arithmetic::identity::RationalIdentity;
use arithmetic::{ArithmeticError, Dual, Field, Rational, Signed, rational};
use ledger::Record;
use ledger::{CheckError, Evidence, Fault, Grade, Outcome, Run};
use models::double_integrator::{
    Coordinates, Kink, Pair, Potential, Span, State, kinetic_energy, linked_within, potential_energy, tied,
    velocity_alignment,
};

const PLANE: Coordinates = Coordinates::Cartesian;

fn spring() -> Potential {
    Potential::inverse_square_spring(&rational(1, 1), &rational(1, 1))
}

/// The saturated potential as a function of the distance `r`, at `r = R`.
fn kink_at(potential: &Potential, threshold: &Rational) -> Result<Kink<Rational>, ArithmeticError> {
    // dV/dr = 2 r V'(r²).
    let square = threshold * threshold;
    Ok(Kink::saturated(potential.slope(&square)? * threshold * rational(2, 1)))
}

fn show(span: &Span<Rational>) -> String {
    if span.is_empty() { "empty".to_string() } else { format!("[{}, {}]", span.lo, span.hi) }
}

// --- Lemma 1 ---

/// Regularity of `sign U` in these directions.
#[derive(Clone, Copy)]
pub struct RegularVariant {
    sign: i64,
    directions: &'static [i64],
}

fn examine_regular(variant: &RegularVariant, _run: &mut Run) -> Result<Outcome, CheckError> {
    let (potential, threshold) = (spring(), rational(2, 1));
    let kink = kink_at(&potential, &threshold)?;
    let kink = if variant.sign < 0 { kink.negated() } else { kink };
    // The upper limit is approached by difference quotients on one side: |quotient - clarke| = O(t).
    let (sign, step) = (rational(variant.sign, 1), rational(1, 1 << 20));
    let value = |r: &Rational| -> Result<Rational, ArithmeticError> {
        let r = r.min(&threshold);
        Ok(potential.rational_value(&(r * r))? * &sign)
    };
    for &w in variant.directions {
        let w = rational(w, 1);
        let (one_sided, clarke) = (kink.directional(&w), kink.clarke(&w));
        let mut best: Option<Rational> = None;
        for side in [-2, 2] {
            let y = &threshold + &step * rational(side, 1);
            let quotient = (value(&(&y + &step * &w))? - value(&y)?) / &step;
            best = Some(best.map_or(quotient.clone(), |b| b.max(quotient)));
        }
        let near = best.is_some_and(|b| num_traits::Signed::abs(&(b - &clarke)) < rational(1, 1000));
        let evidence = Evidence::new(
            Grade::Exact,
            "one-sided and generalised derivatives at R",
            "V = s + 1/s - 2, R = 2; difference quotients agree",
        );
        if !near || one_sided != clarke {
            let what =
                format!("V = s + 1/s - 2 with s = r², R = 2, w = {w}: U'(R; w) = {one_sided}, but U°(R; w) = {clarke}");
            return Ok(Outcome::fails(what, evidence));
        }
    }
    Ok(Outcome::Holds(vec![Evidence::new(
        Grade::Exact,
        "one-sided and generalised derivatives at R",
        "for all potentials with c = V_r(R) > 0: U'(R; w) = min(0, cw), U°(R; w) = max(0, cw), and for -U both are max(0, -cw); values for V = s + 1/s - 2, R = 2",
    )]))
}

pub fn lem1() -> Record<RegularVariant> {
    Record::new(
        "tanner2.lem1",
        "Let c = V_r(R) > 0. One-sided: U'(R; w) = 0 for w > 0 and cw for w < 0. Generalised: base points y < R give quotients that tend to cw, base points y > R give 0, so \
         U°(R; w) = max(0, cw): it differs in both directions. The printed proof bounds U(y') by V_R but keeps y' >= R for w > 0, and for w < 0 overlooks y > R. \
         A kink where an increasing function becomes flat is concave; regular is its negative. (U is regular where it is smooth, and at a convex kink, R below the desired distance.)",
        RegularVariant { sign: 1, directions: &[1, -1] },
        examine_regular,
    )
    .repaired(
        Fault::False,
        "U_ij is regular everywhere but at R; there -U_ij is regular: U'(R; w) = min(0, cw) and U°(R; w) = max(0, cw) with c = V_r(R) > 0.",
        RegularVariant { sign: -1, directions: &[1, -1] },
    )
    .control("in the outward direction", RegularVariant { sign: 1, directions: &[1] })
    .control("in the inward direction", RegularVariant { sign: 1, directions: &[-1] })
}

// --- Lemma 2 ---

/// What the generalised gradient at R is said to be.
#[derive(Clone, Copy)]
pub enum GradientVariant {
    /// Empty.
    Empty,
    /// All `z` from `lo` to `hi` times the slope.
    Between((i64, i64), (i64, i64)),
}

fn examine_gradient(variant: &GradientVariant, _run: &mut Run) -> Result<Outcome, CheckError> {
    let evidence = Evidence::new(
        Grade::Exact,
        "the generalised gradient at R",
        "for all potentials with c = V_r(R) > 0 it is [0, c]; values for two potentials and two thresholds. The set {z: U'(R; w) >= z w for all w}, which the printed proof finds, is empty",
    );
    let mut cases = 0;
    for potential in [spring(), Potential::inverse_square_log(&rational(1, 1))] {
        for threshold in [rational(2, 1), rational(3, 2)] {
            let kink = kink_at(&potential, &threshold)?;
            let found = kink.gradient();
            let claimed = match *variant {
                GradientVariant::Empty => None,
                GradientVariant::Between(lo, hi) => {
                    Some(Span { lo: &kink.left * rational(lo.0, lo.1), hi: &kink.left * rational(hi.0, hi.1) })
                }
            };
            let agrees = claimed.as_ref().map_or(found.is_empty(), |claimed| *claimed == found);
            if !agrees || !kink.subgradient().is_empty() {
                let what = format!(
                    "V_r(R) = {} at R = {threshold}: the generalised gradient of U(r) is {}, so that of r_i is the segment from 0 to grad_{{r_i}} V_ij",
                    kink.left,
                    show(&found)
                );
                return Ok(Outcome::fails(what, evidence));
            }
            cases += 1;
        }
    }
    Ok(Outcome::Holds(vec![evidence.cases(cases)]))
}

pub fn lem2() -> Record<GradientVariant> {
    Record::new(
        "tanner2.lem2",
        "The generalised gradient of a locally Lipschitz function is never empty (Clarke): it is the hull of the limits of gradients, here of 0 and grad_{r_i} V_ij. The printed proof puts \
         U'(R; w) in place of U°(R; w), which Lemma 1 wrongly says is the same.",
        GradientVariant::Empty,
        examine_gradient,
    )
    .repaired(
        Fault::False,
        "The generalised gradient of U_ij with respect to r_i at |r_ij| = R is the segment co{0, grad_{r_i} V_ij}.",
        GradientVariant::Between((0, 1), (1, 1)),
    )
    .control("0 alone", GradientVariant::Between((0, 1), (0, 1)))
    .control("grad V alone", GradientVariant::Between((1, 1), (1, 1)))
    .control("from -grad V to 0", GradientVariant::Between((-1, 1), (0, 1)))
}

// --- Equation (11) ---

/// How the two sums of (11) count.
#[derive(Clone, Copy)]
pub struct SumVariant {
    /// A pair that is not linked counts this often on the left.
    unlinked: i64,
    /// The terms `j = i` on the right.
    own: bool,
}

/// Values of the potentials as variables: `V_ij` of linked pairs, `V_ij(R)` of the others, `U_ii`, and the squared speeds.
struct TwoSums(Graph, SumVariant);

impl RationalIdentity for TwoSums {
    fn variables(&self) -> usize {
        self.0.order() * (self.0.order() + 3) / 2
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let count = self.0.order();
        let (pairs, rest) = at.split_at(count * (count - 1) / 2);
        let (own, squares) = rest.split_at(count);
        let pair = |i: usize, j: usize| pairs[i.max(j) * (i.max(j) - 1) / 2 + i.min(j)].clone();
        let like = &at[0];
        let (mut left, mut right) = (like.zero(), like.zero());
        for i in 0..count {
            let linked = self.0.neighbours(i).into_iter().fold(like.zero(), |sum, j| sum + pair(i, j));
            left = left + (linked + &squares[i]) * like.ratio(1, 2);
            let all = (0..count).filter(|&j| j != i).fold(squares[i].clone(), |sum, j| sum + pair(i, j));
            let all = if self.1.own { all + &own[i] } else { all };
            right = right + all * like.ratio(1, 2);
        }
        for (i, j) in (0..count).flat_map(|j| (0..j).map(move |i| (i, j))).filter(|&(i, j)| !self.0.has_edge(i, j)) {
            left = left + pair(i, j) * like.integer(self.1.unlinked);
        }
        Ok((vec![left], vec![right]))
    }
}

fn examine_sums(variant: &SumVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    Run::all((1..=3).flat_map(Graph::all).map(|graph| {
        let part = format!("equation (11), {} agents, edges {:?}, any values", graph.order(), graph.edges());
        run.identity(&TwoSums(graph, *variant), &["V_ij", "U_ii", "|v_i|²"], &part)
    }))
}

pub fn q_sums() -> Record<SumVariant> {
    let printed = SumVariant { unlinked: 1, own: false };
    Record::new(
        "tanner2.Q",
        "U_ij is V_ij on linked pairs and V_ij(R) on the others, and half the double sum counts each pair of different agents once. Pairs are pairs of different agents: the terms j = i, which \
         V_ij does not define (V_ii(0) would be infinite), are left out, and each pair that is not linked is meant once.",
        printed,
        examine_sums,
    )
    .control("unlinked pairs counted in both orders", SumVariant { unlinked: 2, ..printed })
    .control("with the terms j = i", SumVariant { own: true, ..printed })
    .control("without the unlinked pairs", SumVariant { unlinked: 0, ..printed })
}

// --- Q is continuous and has kinks ---

/// Whether the potential stays at `V(R)` beyond `R` (or falls to 0), and the potential with `R²`.
#[derive(Clone)]
pub struct KinkVariant {
    saturated: bool,
    settings: Vec<(Potential, Rational)>,
}

fn examine_kinks(variant: &KinkVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut random = run.random(0);
    let mut cases = 0;
    let evidence = |detail: &str| Evidence::new(Grade::Exact, "Q at |r_ij| = R", detail.to_string());
    for (potential, square) in &variant.settings {
        let beyond = if variant.saturated { potential.rational_value(square)? } else { rational(0, 1) };
        let jump = potential.rational_value(square)? - beyond;
        if jump != rational(0, 1) {
            return Ok(Outcome::fails(
                format!("R² = {square}: the terms of a pair jump by {jump} at R"),
                evidence("exact values"),
            ));
        }
        // Moving with velocities w and with -w: the one-sided derivatives of Q sum to zero where Q is differentiable.
        let slope = potential.slope(square)?;
        for ties in 1..=3 {
            let directions = random_vectors(ties, &mut random);
            let threshold_points = random_vectors(ties, &mut random);
            let rates: Vec<Rational> =
                directions.iter().zip(&threshold_points).map(|(w, r)| dot(w, r) * rational(2, 1)).collect();
            let kink = Kink::saturated(slope.clone());
            let both: Rational = rates.iter().map(|rate| kink.directional(rate) + kink.directional(&-rate)).sum();
            cases += 1;
            if both == rational(0, 1) {
                let what =
                    format!("V'(R²) = {slope} at R² = {square}: the derivatives of Q in opposite directions cancel");
                return Ok(Outcome::fails(what, evidence("exact one-sided derivatives")));
            }
        }
    }
    let detail = "continuous because U is; with V'(R²) > 0 the one-sided derivatives in opposite directions w and -w sum to minus the sum of V'(R²) |ds_ij(w)| over the tied pairs, \
                  which is negative for every w that changes one of them: the kinks are all concave and do not cancel; exact values";
    Ok(Outcome::Holds(vec![evidence(detail).cases(cases)]))
}

pub fn q_jump() -> Record<KinkVariant> {
    let printed =
        KinkVariant { saturated: true, settings: vec![(spring(), rational(4, 1)), (spring(), rational(9, 4))] };
    Record::new(
        "tanner2.Qjump",
        "Read where no two agents coincide, and with V_ij increasing at R with a positive slope, as Figure 3 and Lemma 1 have it (c < 0 there). U_ij is continuous and has a concave kink at R. \
         A sum of concave kinks is never smooth where one of them is.",
        printed.clone(),
        examine_kinks,
    )
    .control("0 in place of V(R) beyond R", KinkVariant { saturated: false, ..printed.clone() })
    .control("V increasing at R with slope zero", KinkVariant {
        settings: vec![(Potential::with_inflection(&rational(4, 1)), rational(4, 1))],
        ..printed
    })
}

// --- Qdot away from the threshold ---

/// `Qdot = factor v^T (L kron I_2) v`, away from ties or at ties too.
#[derive(Clone, Copy)]
pub struct AwayVariant {
    factor: i64,
    ties: bool,
}

/// `U` of a point that moves: the potential within `R`, constant from `R` on.
fn saturated_value(
    potential: &Potential,
    square: &Rational,
    s: &Dual<Rational>,
) -> Result<Dual<Rational>, ArithmeticError> {
    let inward = s.value == *square && s.derivative.is_certainly_negative();
    if s.value < *square || inward {
        potential.rational_value(s)
    } else {
        Ok(Dual::constant(potential.rational_value(square)?))
    }
}

fn all_pairs(count: usize) -> Vec<Pair> {
    (0..count).flat_map(|j| (0..j).map(move |i| (i, j))).collect()
}

/// The forward derivative of Q, and `-v^T (L kron I_2) v`.
fn rates_of_q(state: &State<Rational>, square: &Rational) -> Result<(Rational, Rational), ArithmeticError> {
    let potential = spring();
    let edges = linked_within(&state.positions, square, PLANE).edges();
    let accelerations = velocity_alignment(state, &edges, PLANE, |_, _, s| potential.slope(s))?;
    let moving = state.moving(&accelerations);
    let pairs = all_pairs(state.count());
    let value = |_: usize, _: usize, s: &Dual<Rational>| saturated_value(&potential, square, s);
    let energy =
        potential_energy(&moving.positions, &pairs, PLANE, value)? + kinetic_energy(&moving.velocities, PLANE)?;
    let form: Rational = edges.iter().map(|&(i, j)| PLANE.square(&state.relative_velocity(i, j))).sum();
    Ok((energy.derivative, -form))
}

fn examine_away(variant: &AwayVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut random = run.random(0);
    let mut states = Vec::new();
    if variant.ties {
        states.push((approaching_at_threshold(), rational(4, 1)));
    }
    for case in 0..run.cases(60, 600) {
        let count = 1 + case % 5;
        let state =
            State { positions: random_vectors(count, &mut random), velocities: random_vectors(count, &mut random) };
        states.push((state, rational(1 + case as i64 % 23, 2)));
    }
    let mut cases = 0;
    for (state, square) in &states {
        run.checkpoint()?;
        if !variant.ties && !tied(&state.positions, square, PLANE).is_empty() {
            continue;
        }
        let Ok((rate, form)) = rates_of_q(state, square) else { continue };
        let claimed = form * rational(-variant.factor, 1);
        cases += 1;
        if rate != claimed {
            let places: Vec<String> = state
                .positions
                .iter()
                .zip(&state.velocities)
                .map(|(r, v)| format!("({}, {}) with velocity ({}, {})", r[0], r[1], v[0], v[1]))
                .collect();
            let what =
                format!("R² = {square}, agents at {}: dQ/dt = {rate}, but {claimed} is claimed", places.join("; "));
            return Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "dQ/dt", "exact rate of change")));
        }
    }
    let detail = "random rational states of up to 5 agents, distances compared with R exactly, connected or not; for all potentials by equation (9) on the graph at hand, which is constant near the state";
    let instances = Outcome::Holds(vec![Evidence::new(Grade::Exact, "dQ/dt", detail).cases(cases)]);
    let identity = super::energy::on_connected(
        run,
        "on a fixed graph dW/dt is minus the sum of |v_i - v_j|² over the edges",
        super::energy::EdgeSum,
    );
    Run::all([Ok(instances), identity])
}

/// Two agents at distance 2 that approach each other.
fn approaching_at_threshold() -> State<Rational> {
    let q = |n| rational(n, 1);
    State { positions: vec![[q(0), q(0)], [q(2), q(0)]], velocities: vec![[q(1), q(0)], [q(0), q(0)]] }
}

pub fn q_dot() -> Record<AwayVariant> {
    let printed = AwayVariant { factor: -1, ties: false };
    Record::new(
        "tanner2.Qdot",
        "Near such a point no link changes and Q is W of the graph at hand plus a constant: equation (9).",
        printed,
        examine_away,
    )
    .control("twice", AwayVariant { factor: -2, ..printed })
    .control("the other sign", AwayVariant { factor: 1, ..printed })
    .control("at ties too, with the graph at that instant", AwayVariant { ties: true, ..printed })
}

// --- Equation (13) ---

/// What the generalised time derivative of Q is compared with.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum HullVariant {
    /// A subset of the hull over the graphs that meet at the state.
    Subset,
    /// Equal to that hull.
    Equal,
    /// The value of the graph with every tied pair linked.
    Linked,
    /// The value of the graph with no tied pair linked.
    Unlinked,
}

/// A state with tied pairs: what (13) needs of it.
struct Tied {
    name: String,
    /// `-v^T (L kron I_2) v` of the links that are not tied.
    base: Rational,
    /// For each tied pair `V'(R²) ds/dt` and `|v_i - v_j|²`.
    ties: Vec<(Rational, Rational)>,
}

impl Tied {
    fn read(state: &State<Rational>, square: &Rational, name: String) -> Result<Self, ArithmeticError> {
        let slope = spring().slope(square)?;
        let linked = linked_within(&state.positions, square, PLANE).edges();
        let speed = |&(i, j): &Pair| PLANE.square(&state.relative_velocity(i, j));
        let base: Rational = linked.iter().map(speed).sum();
        let ties = tied(&state.positions, square, PLANE);
        let rate = |&(i, j): &Pair| dot(&state.separation(i, j), &state.relative_velocity(i, j)) * rational(2, 1);
        Ok(Tied { name, base: -base, ties: ties.iter().map(|pair| (&slope * rate(pair), speed(pair))).collect() })
    }

    /// The intersection over all generalised gradients of their products with `K[f]`, by (A.2).
    ///
    /// A tied pair contributes `z p - m (p + q)`, `z` in [0, 1] from the gradient of Q and `m` in [0, 1] from the law. Both ends are
    /// sums over the pairs and linear in each `z`, so `z = 0` and `z = 1` give the intersection.
    fn derivative(&self) -> Span<Rational> {
        let start = Span { lo: self.base.clone(), hi: self.base.clone() };
        self.ties.iter().fold(start, |sum, (p, q)| {
            let zero = rational(0, 1);
            let law = Span { lo: (-(p + q)).min(zero.clone()), hi: (-(p + q)).max(zero) };
            let with = Span { lo: &law.lo + p, hi: &law.hi + p };
            sum.plus(&law.intersection(&with))
        })
    }

    /// `-co{v_x^T L v_x + v_y^T L v_y}` over the graphs that meet at the state.
    fn hull(&self) -> Span<Rational> {
        let start = Span { lo: self.base.clone(), hi: self.base.clone() };
        self.ties.iter().fold(start, |sum, (_, q)| sum.plus(&Span { lo: -q.clone(), hi: rational(0, 1) }))
    }
}

/// Two and three agents, no pair, one pair, two pairs at the threshold.
fn tied_states(run: &Run) -> Result<Vec<Tied>, ArithmeticError> {
    let mut random = run.random(0);
    let q = |n| rational(n, 1);
    let square = q(4);
    let places: [Vec<[Rational; 2]>; 5] = [
        vec![[q(0), q(0)], [q(1), q(0)]],
        vec![[q(0), q(0)], [q(2), q(0)]],
        vec![[q(0), q(0)], [q(1), q(0)], [q(2), q(0)]],
        vec![[q(0), q(0)], [q(2), q(0)], [q(1), q(1)]],
        // (6/5, 8/5) has length 2.
        vec![[q(0), q(0)], [q(2), q(0)], [rational(6, 5), rational(8, 5)]],
    ];
    let mut found = Vec::new();
    for (k, positions) in places.into_iter().enumerate() {
        let count = positions.len();
        let rest = vec![[q(0), q(0)]; count];
        let sample = (0..run.cases(40, 400)).map(|_| random_vectors(count, &mut random));
        for velocities in std::iter::once(rest).chain(sample) {
            let shown: Vec<String> = velocities.iter().map(|v| format!("({}, {})", v[0], v[1])).collect();
            let name = format!(
                "R = 2, configuration {}, agents at {:?}, velocities {}",
                k + 1,
                positions.iter().map(|r| format!("({}, {})", r[0], r[1])).collect::<Vec<_>>(),
                shown.join(", ")
            );
            found.push(Tied::read(&State { positions: positions.clone(), velocities }, &square, name)?);
        }
    }
    Ok(found)
}

pub(super) fn examine_hull(variant: &HullVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let states = tied_states(run)?;
    for state in &states {
        let (derivative, hull) = (state.derivative(), state.hull());
        let all_linked = state.ties.iter().fold(state.base.clone(), |sum, (_, q)| sum - q);
        let point = |x: &Rational| Span { lo: x.clone(), hi: x.clone() };
        let agrees = match variant {
            HullVariant::Subset => {
                derivative.is_within(&hull) && (derivative.is_empty() || derivative.hi <= rational(0, 1))
            }
            HullVariant::Equal => derivative == hull,
            HullVariant::Linked => derivative.is_within(&point(&all_linked)),
            HullVariant::Unlinked => derivative.is_within(&point(&state.base)),
        };
        if !agrees {
            let what = format!(
                "{}: the generalised derivative of Q is {}, the hull {}",
                state.name,
                show(&derivative),
                show(&hull)
            );
            return Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "(13) at ties", "exact sets")));
        }
    }
    let detail = "with the true generalised gradient co{0, grad V} of the tied pairs; for all states and any number of ties, and for Q along every solution: proof in notes/tanner2.md; \
                  exact sets for no, one and two tied pairs";
    Ok(Outcome::Holds(vec![Evidence::new(Grade::Exact, "(13) at ties", detail).cases(states.len())]))
}

pub fn eq13() -> Record<HullVariant> {
    Record::new(
        "tanner2.eq13",
        "Take (A.2) with the true gradient of Lemma 2 (not empty) and K of the whole vector field (Definition 4), not agent by agent. The law and the gradient of Q switch together: the hull of the graphs that meet at the state acts on both, with weights m and z. \
         x lies in the intersection over z only if for each z some m gives it; a fixed point m = z (Kakutani) leaves x = -v^T (L_m kron I_2) v, a point of the hull. So q <= 0. Q is not regular, so \
         Theorem 4 does not give Q's monotony, but it holds: almost everywhere on |r_ij| = R the distance has derivative zero, and dQ/dt = -v^T (L_m kron I_2) v.",
        HullVariant::Subset,
        examine_hull,
    )
    .control("equality", HullVariant::Equal)
    .control("the value with tied pairs linked", HullVariant::Linked)
    .control("the value with tied pairs not linked", HullVariant::Unlinked)
}

/// What the right side of (13) is said to be.
#[derive(Clone, Copy)]
pub enum IntervalVariant {
    /// `[e, 0]` with `e < 0`.
    ToZero,
    /// `[e, 0]` with `e <= 0`.
    ToZeroOrPoint,
    /// `[e, f]` with `e <= f <= 0`, and 0 in it on a connected graph only where velocities are equal.
    NonPositive,
    /// `[e, f]` with `e <= f < 0`.
    Negative,
}

fn examine_interval(variant: &IntervalVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let states = tied_states(run)?;
    let zero = rational(0, 1);
    for state in &states {
        let hull = state.hull();
        let agrees = match variant {
            IntervalVariant::ToZero => hull.hi == zero && hull.lo < zero,
            IntervalVariant::ToZeroOrPoint => hull.hi == zero,
            IntervalVariant::NonPositive => hull.lo <= hull.hi && hull.hi <= zero,
            IntervalVariant::Negative => hull.hi < zero,
        };
        if !agrees {
            let what = format!("{}: the right side of (13) is {}", state.name, show(&hull));
            return Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "the right side of (13)", "exact sets")));
        }
    }
    let detail = "a sum of squares over the links, each weight in [0, 1], with the sign reversed; the zero of a connected graph by equation (9)";
    Ok(Outcome::Holds(vec![Evidence::new(Grade::Exact, "the right side of (13)", detail).cases(states.len())]))
}

pub fn eq13_interval() -> Record<IntervalVariant> {
    Record::new(
        "tanner2.eq13.interval",
        "Away from ties the hull is the one number -v^T (L kron I_2) v, negative on a connected graph unless all velocities are equal: it is no interval [e, 0] with e < 0. (The next sentence of the \
         text says that 0 belongs to it only for equal velocities.) Equal velocities give {0}.",
        IntervalVariant::ToZero,
        examine_interval,
    )
    .repaired(Fault::False, "The right side of (13) is an interval [e, f] with e <= f <= 0; away from ties e = f = -v^T (L kron I_2) v.", IntervalVariant::NonPositive)
    .control("[e, 0] with e <= 0", IntervalVariant::ToZeroOrPoint)
    .control("[e, f] with f < 0", IntervalVariant::Negative)
}
