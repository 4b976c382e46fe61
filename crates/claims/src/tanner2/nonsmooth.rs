//! tanner2.lem1, lem2, Q, Qjump, Qdot, eq13, eq13.interval: the saturated potential and the energy Q.

use super::fixtures::{PLANE, apart, energy_decreases, printed as logarithmic, spring};
use crate::prelude::*;
use algebra::graph::Graph;
use models::double_integrator::{
    Kink, Potential, Span, State, TiedRate, dot, fork, random_vectors, rate_along, saturated_rate, tied,
};

/// The saturated potential as a function of the distance `r`, at `r = R`.
fn kink_at(potential: &Potential, threshold: &Rational) -> Result<Kink<Rational>, ArithmeticError> {
    // dV/dr = 2 r V'(r²).
    let square = threshold * threshold;
    Ok(Kink::saturated(potential.slope(&square)? * threshold * rational(2, 1)))
}

fn show(span: &Span<Rational>) -> String {
    if span.is_empty() { "empty".to_string() } else { format!("[{}, {}]", span.lo, span.hi) }
}

/// Regularity of `U` at R, or its two derivatives and the regularity of `-U`.
#[derive(Clone, Copy)]
pub struct RegularVariant {
    regular: bool,
    threshold: (i64, i64),
    /// `U°(R; w)` as a function of `cw`.
    generalised: fn(Rational) -> Rational,
}

fn examine_regular(variant: &RegularVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let (potential, threshold) = (spring(), rational(variant.threshold.0, variant.threshold.1));
    let kink = kink_at(&potential, &threshold)?;
    let (zero, step) = (rational(0, 1), rational(1, 1 << 20));
    let value = |r: &Rational| -> Result<Rational, ArithmeticError> {
        let r = r.min(&threshold);
        potential.rational_value(&(r * r))
    };
    // The upper limit is approached by difference quotients on one side: |quotient - clarke| = O(t).
    let quotient = |w: &Rational, side: i64| -> Result<Rational, ArithmeticError> {
        let y = &threshold + &step * rational(side, 1);
        Ok((value(&(&y + &step * w))? - value(&y)?) / &step)
    };
    let near = |a: &Rational, b: &Rational| num_traits::Signed::abs(&(a - b)) < rational(1, 100);
    let (part, detail) = ("one-sided and generalised derivatives at R", "V = s + 1/s - 2; difference quotients agree");
    let derivatives = run.instances(part, detail, [1, -1], |w| {
        let w = rational(w, 1);
        let (one_sided, clarke, negated) = (kink.directional(&w), kink.clarke(&w), kink.negated());
        let quotients = near(&quotient(&w, 0)?, &one_sided) && near(&quotient(&w, -2)?.max(quotient(&w, 2)?), &clarke);
        let cw = &kink.left * &w;
        let agrees = if variant.regular {
            one_sided == clarke
        } else {
            one_sided == cw.clone().min(zero.clone())
                && clarke == (variant.generalised)(cw)
                && negated.directional(&w) == negated.clarke(&w)
        };
        Ok((!quotients || !agrees).then(|| {
            let text = format!(
                "V = s + 1/s - 2 with s = r², R = {threshold}, w = {w}: U'(R; w) = {one_sided}, but U°(R; w) = {clarke}"
            );
            let witness = Witness::Potential {
                slope: vec![(0, 1.into()), (-2, (-1).into())],
                value: [1.into(), 0.into()],
                tangent: None,
                radius: Some((&threshold).into()),
            };
            Counterexample::new(text, [witness])
        }))
    })?;
    // The printed statement is one clause, the corrected one three.
    if variant.regular {
        return Ok(derivatives.on([1]));
    }
    Run::all([
        Ok(derivatives.on([2, 3])).checks("steps 2 and 3"),
        argued(&[1, 2, 3], "the derivatives", "notes/tanner2.md, Lemmas 1 and 2, steps 1 to 3"),
    ])
}

pub fn lem1() -> Record<RegularVariant> {
    Record::new(
        "tanner2.lem1",
        "Let c = V_r(R) > 0. One-sided: U'(R; w) = 0 for w > 0 and cw for w < 0. Generalised: base points y < R give quotients that tend to cw, base points y > R give 0, so \
         U°(R; w) = max(0, cw): it differs in both directions. The printed proof bounds U(y') by V_R but keeps y' >= R for w > 0, and for w < 0 overlooks y > R. \
         A kink where an increasing function becomes flat is concave; regular is its negative. (U is regular where it is smooth, and at a convex kink, R below the desired distance.)",
        RegularVariant { regular: true, threshold: (2, 1), generalised: |cw| cw.max(rational(0, 1)) },
        examine_regular,
    )
    .repaired_by(Fault::False, "", |v| v.regular = false)
    .repaired_clauses(&[
        "For V with a continuous derivative the saturated potential U_ij is regular at every distance but R.",
        "For such V with c = V_r(R) > 0 -U_ij is regular at R.",
        "For V with a continuous derivative and c = V_r(R) > 0 U'(R; w) = min(0, cw) and U°(R; w) = max(0, cw).",
    ])
    .altered("R below the desired distance, c < 0", |v| v.threshold = (1, 2))
    .altered("U°(R; w) = cw", |v| v.generalised = |cw| cw)
}

/// What the generalised gradient at R is said to be: empty, or all `z` from some number to another, times the slope.
#[derive(Clone, Copy)]
pub struct GradientVariant {
    between: Option<(i64, i64)>,
    thresholds: [(i64, i64); 2],
}

fn examine_gradient(variant: &GradientVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let potentials = [spring(), logarithmic()];
    let settings =
        potentials.iter().flat_map(|potential| variant.thresholds.map(move |(p, q)| (potential, rational(p, q))));
    let detail = "values for two potentials and two thresholds; the set {z: U'(R; w) >= z w for all w}, which the printed proof finds, is empty";
    let gradients = run.instances("the generalised gradient at R", detail, settings, |(potential, threshold)| {
        let kink = kink_at(potential, &threshold)?;
        let found = kink.gradient();
        let part = |n: i64| &kink.left * rational(n, 1);
        let agrees = match variant.between {
            None => found.is_empty(),
            Some((lo, hi)) => found == Span { lo: part(lo), hi: part(hi) },
        };
        Ok((!agrees || !kink.subgradient().is_empty()).then(|| {
            let claimed = variant.between.map(|(lo, hi)| format!("[{}, {}]", part(lo), part(hi)));
            format!(
                "V_r(R) = {} at R = {threshold}: the generalised gradient of U(r) is {}, so that of r_i is the segment from 0 to grad_{{r_i}} V_ij, but {} is claimed",
                kink.left,
                show(&found),
                claimed.unwrap_or_else(|| "the empty set".to_string())
            )
        }))
    })?;
    if variant.between.is_none() {
        return Ok(gradients.on([1]));
    }
    let steps = "notes/tanner2.md, Lemmas 1 and 2, steps 2 to 4";
    let quotients = support_by_quotients(variant, run)?;
    Run::all([
        Ok(gradients.on([1])).checks("step 4"),
        Ok(quotients.on([1, 2])).checks("steps 2 and 4"),
        argued(&[1, 2], "the gradient", steps),
    ])
}

/// `U°(r; w)` from quotients of values of `U` at base points on both sides of R, in the plane: it must be the largest `<z, w>` over the
/// claimed segment. Directions along `r` are the case of the distance alone.
fn support_by_quotients(variant: &GradientVariant, run: &Run) -> Result<Outcome, CheckError> {
    let potential = spring();
    let [lo, hi] = variant.between.map_or([0, 0], |(lo, hi)| [lo, hi]).map(|n| rational(n, 1));
    let directions = [(3, 4), (-3, -4), (4, -3), (1, 0), (-1, 0), (0, 1), (2, -3), (-2, 1)];
    let cases = variant.thresholds.into_iter().flat_map(|(p, q)| directions.map(|w| (rational(p, q), w)));
    let (part, detail) =
        ("U° by quotients", "V = s + 1/s - 2, quotients at base points on both sides of R, eight directions");
    run.instances(part, detail, cases, |(threshold, w)| {
        let step = rational(1, 1 << 20);
        let place = [rational(3, 5), rational(4, 5)].map(|x| x * &threshold);
        let w = [rational(w.0, 1), rational(w.1, 1)];
        let value = |at: &[Rational; 2]| {
            let squared: Rational = at.iter().map(|x| x * x).sum();
            potential.rational_value(&squared.min(&threshold * &threshold))
        };
        let quotient = |side: i64| -> Result<Rational, ArithmeticError> {
            let base = place.clone().map(|x| &x * (rational(1, 1) + &step * rational(8 * side, 1)));
            let moved = [&base[0] + &step * &w[0], &base[1] + &step * &w[1]];
            Ok((value(&moved)? - value(&base)?) / &step)
        };
        let found = quotient(-1)?.max(quotient(1)?);
        // grad_{r_i} V_ij = 2 V'(R²) r_ij.
        let slope = potential.slope(&(&threshold * &threshold))? * rational(2, 1);
        let along = (&place[0] * &w[0] + &place[1] * &w[1]) * slope;
        let claimed = (&along * &lo).max(&along * &hi);
        let differs = num_traits::Signed::abs(&(&found - &claimed)) > rational(1, 100);
        Ok(differs.then(|| {
            format!("R = {threshold}, w = ({}, {}): U°(r; w) is near {}, not {claimed}", w[0], w[1], found.round())
        }))
    })
}

pub fn lem2() -> Record<GradientVariant> {
    Record::new(
        "tanner2.lem2",
        "The generalised gradient of a locally Lipschitz function is never empty (Clarke): it is the hull of the limits of gradients, here of 0 and grad_{r_i} V_ij. The printed proof puts \
         U'(R; w) in place of U°(R; w), which Lemma 1 wrongly says is the same.",
        GradientVariant { between: None, thresholds: [(2, 1), (3, 2)] },
        examine_gradient,
    )
    .repaired_by(Fault::False, "", |v| v.between = Some((0, 1)))
    .repaired_clauses(&[
        "For V with a continuous derivative and c = V_r(R) > 0 the generalised gradient of U_ij as a function of the distance is [0, c] at R.",
        "For such V, with respect to r_i at |r_ij| = R it is the segment co{0, grad_{r_i} V_ij}.",
    ])
    .altered("R below the desired distance, c < 0", |v| v.thresholds = [(1, 2), (2, 3)])
    .altered("grad V alone", |v| v.between = Some((1, 1)))
}

/// How the two sums of (11) count.
#[derive(Clone, Copy)]
pub struct SumVariant {
    /// A pair that is not linked counts this often on the left.
    unlinked: i64,
    /// The terms `j = i` on the right.
    own: bool,
}

/// Values of the potentials as variables: `V_ij` of linked pairs, `V_ij(R)` of the others, `U_ii`, and the squared speeds.
fn two_sums(graph: Graph, variant: &SumVariant) -> Identity<'_> {
    Identity::new(graph.order() * (graph.order() + 3) / 2, move |at| {
        let count = graph.order();
        let (pairs, rest) = at.split_at(count * (count - 1) / 2);
        let (own, squares) = rest.split_at(count);
        let pair = |i: usize, j: usize| pairs[i.max(j) * (i.max(j) - 1) / 2 + i.min(j)].clone();
        let like = &at[0];
        let (mut left, mut right) = (like.zero(), like.zero());
        for i in 0..count {
            let linked = graph.neighbours(i).iter().fold(like.zero(), |sum, &j| sum + pair(i, j as usize));
            left = left + (linked + &squares[i]) * like.ratio(1, 2);
            let all = (0..count).filter(|&j| j != i).fold(squares[i].clone(), |sum, j| sum + pair(i, j));
            let all = if variant.own { all + &own[i] } else { all };
            right = right + all * like.ratio(1, 2);
        }
        for (i, j) in (0..count).flat_map(|j| (0..j).map(move |i| (i, j))).filter(|&(i, j)| !graph.has_edge(i, j)) {
            left = left + pair(i, j) * like.integer(variant.unlinked);
        }
        Ok((vec![left], vec![right]))
    })
}

pub fn q_sums() -> Record<SumVariant> {
    Record::new(
        "tanner2.Q",
        "U_ij is V_ij on linked pairs and V_ij(R) on the others, and half the double sum counts each pair of different agents once. Pairs are pairs of different agents: the terms j = i, which \
         V_ij does not define (V_ii(0) would be infinite), are left out, and each pair that is not linked is meant once.",
        SumVariant { unlinked: 1, own: false },
        |variant, run| {
            Run::all((1..=3).flat_map(Graph::all).map(|graph| {
                let part = format!("equation (11), {} agents, edges {:?}, any values", graph.order(), graph.edges());
                run.identity(&two_sums(graph, variant), &["V_ij", "U_ii", "|v_i|²"], &part)
            }))
        },
    )
    .reading("pairs are unordered pairs of different agents")
    .altered("unlinked pairs counted in both orders", |v| v.unlinked = 2)
    .altered("with the terms j = i", |v| v.own = true)
    .altered("without the unlinked pairs", |v| v.unlinked = 0)
}

/// Whether the potential stays at `V(R)` beyond `R` (or falls to 0), and the potential with `R²`.
#[derive(Clone)]
pub struct KinkVariant {
    saturated: bool,
    settings: Vec<(Potential, Rational)>,
}

fn examine_kinks(variant: &KinkVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let jumps =
        run.instances("the terms of a pair at R", "exact values", &variant.settings, |(potential, square)| {
            let value = potential.rational_value(square)?;
            let jump = if variant.saturated { rational(0, 1) } else { value };
            Ok((jump != rational(0, 1)).then(|| format!("R² = {square}: the terms of a pair jump by {jump} at R")))
        })?;
    let mut random = run.random(0);
    let mut cases = Vec::new();
    for (potential, square) in &variant.settings {
        for ties in 1..=3 {
            let (directions, places) = (random_vectors(ties, &mut random), random_vectors(ties, &mut random));
            let mut rates: Vec<Rational> =
                directions.iter().zip(&places).map(|(w, r)| dot(w, r) * rational(2, 1)).collect();
            // One pair along r_ij, so that not all directions are at right angles to the distances.
            rates[0] = square * rational(2, 1);
            cases.push((square, potential.slope(square)?, rates));
        }
    }
    // Moving with velocities w and with -w: the one-sided derivatives of Q sum to zero where Q is differentiable.
    let detail = "exact one-sided derivatives in opposite directions, one to three tied pairs";
    let kinks = run.instances("Q at |r_ij| = R", detail, cases, |(square, slope, rates)| {
        let kink = Kink::saturated(slope.clone());
        let both: Rational = rates.iter().map(|rate| kink.directional(rate) + kink.directional(&-rate)).sum();
        Ok((both == rational(0, 1))
            .then(|| format!("V'(R²) = {slope} at R² = {square}: the derivatives of Q in opposite directions cancel")))
    })?;
    let steps = "notes/tanner2.md, Lemmas 1 and 2, step 5";
    Run::all([
        Ok(jumps.on([1])).checks("step 5"),
        Ok(kinks.on([2])).checks("step 5"),
        argued(&[1, 2], "Q at |r_ij| = R", steps),
    ])
}

pub fn q_jump() -> Record<KinkVariant> {
    Record::new(
        "tanner2.Qjump",
        "U_ij is continuous and has a concave kink at R. A sum of concave kinks is never smooth where one of them is.",
        KinkVariant { saturated: true, settings: vec![(spring(), rational(4, 1)), (spring(), rational(9, 4))] },
        examine_kinks,
    )
    .clauses(&["Q is continuous everywhere.", "Q is nonsmooth whenever ||r_ij|| = R for some (i, j)."])
    .reading("where no two agents coincide, and with V_ij increasing at R with a positive slope, as Figure 3 and Lemma 1 have it (c < 0 there)")
    .altered("0 in place of V(R) beyond R", |v| v.saturated = false)
    .altered("V increasing at R with slope zero", |v| {
        v.settings = vec![(Potential::with_inflection(&rational(4, 1)), rational(4, 1))]
    })
}

/// `Qdot = factor v^T (L kron I_2) v`, away from ties or at ties too.
#[derive(Clone, Copy)]
pub struct AwayVariant {
    factor: i64,
    ties: bool,
}

fn examine_away(variant: &AwayVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut random = run.random(0);
    let mut states = Vec::new();
    if variant.ties {
        states.push((approaching_at_threshold(), rational(4, 1)));
    }
    for case in 0..run.cases(60, 600) {
        let square = rational(1 + case as i64 % 23, 2);
        // States at ties that are not meant are drawn again: the number of cases does not depend on the seed.
        let meant = |state: &State<Rational>| variant.ties || tied(&state.positions, &square, PLANE).is_empty();
        let state = loop {
            run.checkpoint()?;
            let state = apart(1 + case % 5, &mut random);
            if meant(&state) {
                break state;
            }
        };
        states.push((state, square));
    }
    let rates = states
        .iter()
        .filter_map(|(state, square)| Some((state, square, saturated_rate(state, square, &spring()).ok()?)));
    let detail = "random rational states of up to 5 agents, distances compared with R exactly, connected or not";
    let instances = run.instances("dQ/dt", detail, rates, |(state, square, (rate, form))| {
        let claimed = form * rational(-variant.factor, 1);
        let agents = state.positions.iter().zip(&state.velocities);
        let places = agents.map(|(r, v)| format!("({}, {}) with velocity ({}, {})", r[0], r[1], v[0], v[1]));
        Ok((rate != claimed).then(|| {
            let places = places.collect::<Vec<_>>().join("; ");
            format!("R² = {square}, agents at {places}: dQ/dt = {rate}, but {claimed} is claimed")
        }))
    });
    Run::all([instances, energy_decreases(run, 1)])
}

/// Two agents at distance 2 that approach each other.
fn approaching_at_threshold() -> State<Rational> {
    let q = |n| rational(n, 1);
    State { positions: vec![[q(0), q(0)], [q(2), q(0)]], velocities: vec![[q(1), q(0)], [q(0), q(0)]] }
}

pub fn q_dot() -> Record<AwayVariant> {
    Record::new(
        "tanner2.Qdot",
        "Near such a point no link changes and Q is W of the graph at hand plus a constant: equation (9).",
        AwayVariant { factor: -1, ties: false },
        examine_away,
    )
    .altered("twice", |v| v.factor = -2)
    .altered("at ties too, with the graph at that instant", |v| v.ties = true)
}

/// What the generalised time derivative of Q is compared with.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum HullVariant {
    /// A subset of the hull over the graphs that meet at the state.
    Subset,
    /// Equal to that hull.
    Equal,
    /// The value of the graph with every tied pair linked.
    Linked,
    /// Below zero.
    Negative,
    /// The rate of Q along solutions, with potentials that are not cut off at R.
    Uncut,
}

/// Two and three agents, no pair, one pair, two pairs at the threshold R = 2; at rest, at random velocities, and at random
/// ones across the first pair.
fn tied_states(run: &Run) -> Vec<(String, State<Rational>)> {
    let mut random = run.random(0);
    let q = |n| rational(n, 1);
    let places: [Vec<[Rational; 2]>; 5] = [
        vec![[q(0), q(0)], [q(1), q(0)]],
        vec![[q(0), q(0)], [q(2), q(0)]],
        vec![[q(0), q(0)], [q(1), q(0)], [q(2), q(0)]],
        vec![[q(0), q(0)], [q(2), q(0)], [q(1), q(1)]],
        // (6/5, 8/5) has length 2.
        vec![[q(0), q(0)], [q(2), q(0)], [rational(6, 5), rational(8, 5)]],
    ];
    let mut found = Vec::new();
    for positions in places {
        let count = positions.len();
        let rest = vec![[q(0), q(0)]; count];
        let sample: Vec<_> = (0..run.cases(40, 400)).map(|_| random_vectors(count, &mut random)).collect();
        let across = sample.iter().map(|vectors| vectors.iter().map(|[_, y]| [q(0), y.clone()]).collect());
        for velocities in std::iter::once(rest).chain(across).chain(sample.iter().cloned()) {
            let list = |vectors: &[[Rational; 2]]| {
                vectors.iter().map(|v| format!("({}, {})", v[0], v[1])).collect::<Vec<_>>().join(", ")
            };
            let name = format!("R = 2, agents at {}, velocities {}", list(&positions), list(&velocities));
            found.push((name, State { positions: positions.clone(), velocities }));
        }
    }
    found
}

/// Compares the generalised derivative of Q with a hull at states with ties.
pub(super) fn hulls(variant: &HullVariant, run: &Run) -> Result<Outcome, CheckError> {
    let detail =
        "with the true generalised gradient co{0, grad V} of the tied pairs; exact sets for no, one and two tied pairs";
    run.instances("(13) at ties", detail, tied_states(run), |(name, start)| {
        let state = TiedRate::of(&start, &rational(4, 1), &spring())?;
        let (derivative, hull) = (state.derivative(), state.hull());
        let point = |x: Rational| Span { lo: x.clone(), hi: x };
        let agrees = match variant {
            HullVariant::Subset | HullVariant::Uncut => {
                derivative.is_within(&hull) && (derivative.is_empty() || derivative.hi <= rational(0, 1))
            }
            HullVariant::Equal => derivative == hull,
            HullVariant::Linked => derivative.is_within(&point(state.all_linked())),
            HullVariant::Negative => derivative.is_empty() || derivative.hi < rational(0, 1),
        };
        let (derivative, hull) = (show(&derivative), show(&hull));
        Ok((!agrees).then(|| format!("{name}: the generalised derivative of Q is {derivative}, the hull {hull}")))
    })
}

/// Q along all ways on from the tied states: its rate is the damping of the links and weights in force.
pub(super) fn along_solutions(variant: &HullVariant, run: &Run) -> Result<Outcome, CheckError> {
    let detail = "every way on from no, one and two tied pairs, with weights that keep a pair at R: rates by exact accelerations";
    let square = rational(4, 1);
    run.instances("Q along solutions of (10) through ties", detail, tied_states(run), |(name, state)| {
        for branch in fork(&state, &square, PLANE, &spring())?.branches {
            let (rate, damping) = rate_along(&state, &square, &spring(), &branch.ways, *variant != HullVariant::Uncut)?;
            if rate != damping || rate > rational(0, 1) {
                return Ok(Some(format!("{name}: Q has the rate {rate}, where the damping is {damping}")));
            }
        }
        Ok(None)
    })
}

pub fn eq13() -> Record<HullVariant> {
    Record::new(
        "tanner2.eq13",
        "The law and the gradient of Q switch together: the hull of the graphs that meet at the state acts on both, with weights m and z. \
         x lies in the intersection over z only if for each z some m gives it; the z at which the gradients take most leaves x at most some -v^T (L_m kron I_2) v, the one at which they take least at least some: a point of the hull. So q <= 0. Q is not regular, so \
         Theorem 4 does not give Q's monotony, but it is true: almost everywhere on |r_ij| = R the distance has derivative zero, and dQ/dt = -v^T (L_m kron I_2) v.",
        HullVariant::Subset,
        |variant, run| Run::all([
            hulls(variant, run).checks("Equation (13), step 4").on([1, 2]),
            argued(&[1, 2], "(13)", "notes/tanner2.md, Equation (13), steps 1 to 4"),
            along_solutions(variant, run).checks("Section 5, step 3").on([3]),
            argued(&[3], "Q along solutions", "notes/tanner2.md, Section 5, steps 1 to 3"),
        ]),
    )
    .clauses(&[
        "Qdot is a subset of -co{v_x^T L_t v_x + v_y^T L_t v_y}.",
        "q <= 0 for all q in Qdot.",
        "Q is nonincreasing.",
    ])
    .reading("potentials of Definition 3 with a continuous gradient; (A.2) with the true gradient of Lemma 2, which is not empty, and K of the whole vector field (Definition 4), not agent by agent as in (10b)")
    .control("equality", HullVariant::Equal)
    .control("the value with tied pairs linked", HullVariant::Linked)
    .control("q < 0", HullVariant::Negative)
    .control("Q with potentials that are not cut off at R", HullVariant::Uncut)
}

/// What the right side of (13) is said to be.
#[derive(Clone, Copy)]
pub enum IntervalVariant {
    /// `[e, 0]` with `e < 0`.
    ToZero,
    /// `[e, 0]` with `e <= 0`.
    ToZeroOrPoint,
    /// `[e, f]` with `e <= f <= 0`, this multiple of `-v^T (L kron I_2) v` away from ties.
    NonPositive(i64),
}

fn examine_interval(variant: &IntervalVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let zero = rational(0, 1);
    let sides = run.instances("the right side of (13)", "exact sets", tied_states(run), |(name, start)| {
        let state = TiedRate::of(&start, &rational(4, 1), &spring())?;
        let hull = state.hull();
        let (agrees, claimed) = match variant {
            IntervalVariant::ToZero => (hull.hi == zero && hull.lo < zero, "[e, 0] with e < 0".to_string()),
            IntervalVariant::ToZeroOrPoint => (hull.hi == zero, "[e, 0] with e <= 0".to_string()),
            IntervalVariant::NonPositive(factor) => {
                let base = &state.base * rational(*factor, 1);
                let point = hull.lo == base && hull.hi == base;
                let agrees = hull.lo <= hull.hi && hull.hi <= zero && (point || !state.ties.is_empty());
                (agrees, format!("{base} away from ties"))
            }
        };
        let text = || format!("{name}: the right side of (13) is {}, but {claimed} is claimed", show(&hull));
        let seen = || Witness::agents(&start.positions, &start.velocities, &[]);
        Ok((!agrees).then(|| Counterexample::new(text(), [seen()])))
    })?;
    Ok(match variant {
        IntervalVariant::NonPositive(_) => Run::all([
            Ok(sides.on([1, 2])).checks("step 5"),
            argued(&[1, 2], "a sum of squares", "notes/tanner2.md, Equation (13), step 5"),
        ])?,
        _ => sides.on([1]),
    })
}

pub fn eq13_interval() -> Record<IntervalVariant> {
    Record::new(
        "tanner2.eq13.interval",
        "Away from ties the hull is the one number -v^T (L kron I_2) v, negative on a connected graph unless all velocities are equal: it is no interval [e, 0] with e < 0. (The next sentence of the \
         text says that 0 belongs to it only for equal velocities.) Equal velocities give {0}. The use that is made of it, q <= 0, is right.",
        IntervalVariant::ToZero,
        examine_interval,
    )
    .repaired(Fault::Slip, "", IntervalVariant::NonPositive(1))
    .repaired_clauses(&[
        "The right side of (13) is an interval [e, f] with e <= f <= 0.",
        "Away from ties e = f = -v^T (L kron I_2) v.",
    ])
    .control("[e, 0] with e <= 0", IntervalVariant::ToZeroOrPoint)
    .control("twice the form away from ties", IntervalVariant::NonPositive(2))
}
