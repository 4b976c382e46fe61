//! paley.bal.circ, paley.fig3.gain, paley.fig3.max: which balanced circular formations on circulant graphs are stable.
//!
//! `notes/paley_particles.md` proves: at a circular formation that is a relative equilibrium of (5) with (20) and the negative
//! gradient of a phase potential `U`, the linearisation has on the unstable side as many eigenvalues as the Hessian of `U` has
//! negative ones; it is exponentially stable up to the symmetries where that Hessian is positive definite up to rotation.

use super::instances::scattered_phasors;
use crate::prelude::*;
use algebra::graph::Graph;
use algebra::matrix::{Inertia, RationalMatrix};
use arithmetic::{CosineField, Sign, Signed};
use models::oscillator::critical::laplacian_hessian;
use models::oscillator::{Neighbours, fourier_column, mean, misalignment, on_the_line, phase_potential, quarter_turn};

/// Which set of circular formations is asymptotically stable for `gain K_1 > 0`.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum BalancedSet {
    /// `p_theta = 0`.
    Balanced,
    /// Balanced symmetric patterns along the circulant graph, `theta_k = 2 pi m k/N`.
    Patterns,
    /// The phases at which `W_1` is largest.
    Largest,
}

/// The set, the sign of `K_1`, and whether it is all balanced formations on complete graphs only, or on cycles.
#[derive(Clone, Copy)]
pub struct BalancedVariant {
    set: BalancedSet,
    gain: i64,
    complete: bool,
}

/// Connected circulant graphs with up to `most` vertices, as offsets.
fn circulants(most: usize) -> Vec<(usize, Vec<usize>)> {
    let mut graphs = Vec::new();
    for order in 2..=most {
        for bits in 1u32..1 << (order / 2) {
            let offsets: Vec<usize> = (1..=order / 2).filter(|a| bits >> (a - 1) & 1 == 1).collect();
            if offsets.iter().fold(order, |g, &a| num_integer::gcd(g, a)) == 1 {
                graphs.push((order, offsets));
            }
        }
    }
    graphs
}

/// Why phases in the set refute its stability, or `None`.
fn refutation<T: Field + Signed>(
    network: &Neighbours,
    phasors: &[Complex<T>],
    gain: i64,
) -> Result<Option<&'static str>, CheckError> {
    let still = |x: &T| x.sign() == Some(Sign::Zero);
    let momentum = mean(phasors)?;
    if !still(&momentum.re) || !still(&momentum.im) {
        return Ok(Some("the phases are not balanced"));
    }
    if !misalignment(network, phasors).iter().all(still) {
        return Ok(Some("u_k = w0 fails, so that the centres part and the solution leaves the set at once"));
    }
    // K_1 W_1 grows along the phases' own motion: directions in which it can grow are unstable.
    let growing = laplacian_hessian(network, phasors, gain)?.positive;
    Ok((growing > 0).then_some("W_1 has directions of growth, which are unstable"))
}

pub fn balanced_stable() -> Record<BalancedVariant> {
    Record::new(
        "paley.bal.circ",
        "A stable closed set is invariant. On C_4 the phases (0, a, a + pi, pi) are balanced, but tau = -+ \
         sin a: with c = c_0 1, cdot_k = -e^{i theta_k} K_1 tau_k/(w0 N) differs between particles, so the \
         solution leaves the set of balanced circular formations at once. Nor are the balanced equilibria \
         in it stable: on C_N the pattern theta_k = 2 pi m k/N has unstable directions where cos(2 pi m/N) \
         > 0. What is stable for K_1 > 0: by V = K_0 S - K_1 w0^-2 W_1 (paley.eq21) the circular formations \
         that maximise W_1. On a circulant graph W_1 <= lambda_max/2 is attained by a Fourier column, and \
         e^{i theta} is then an eigenvector of lambda_max > 0, so these formations are balanced. On \
         complete graphs they are all the balanced ones.",
        BalancedVariant { set: BalancedSet::Balanced, gain: 1, complete: true },
        examine_balanced_stable,
    )
    .repaired(Fault::False, "", BalancedVariant { set: BalancedSet::Largest, gain: 1, complete: true })
    .repaired_clauses(&[
        "If G is undirected, circulant and connected, N >= 2, then under (22) with w0 != 0 and K_0, K_1 > 0 the set of circular formations \
         whose phases maximise W_1 is asymptotically stable.",
        "All of them are balanced: L e^{i theta} = lambda_max e^{i theta}.",
        "It is the set of all balanced circular formations if G is complete.",
    ])
    .altered("the largest W_1 with K_1 < 0", |v| v.gain = -1)
    .altered("all symmetric patterns", |v| v.set = BalancedSet::Patterns)
    .altered("all balanced formations on cycles too", |v| v.complete = false)
}

fn examine_balanced_stable(variant: &BalancedVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    const PART: &str = "balanced, in equilibrium, no direction of growth";
    let mut cases = 0;
    for (order, offsets) in circulants(run.cases(6, 12)) {
        run.checkpoint()?;
        let network = Neighbours::circulant(order, &offsets);
        let graph = Graph::from_fn(order, |i, j| offsets.iter().any(|a| (i + a) % order == j || (j + a) % order == i));
        let fails = |phases: String, why: &str, seen: Option<Witness>| {
            let what = format!("N = {order}, circulant graph with offsets {offsets:?}, phases {phases}: {why}");
            let seen = std::iter::once(Witness::networks(order, vec![graph.edges()])).chain(seen);
            Ok(Outcome::fails(Counterexample::new(what, seen), exact(PART, "exact phasors")))
        };
        if variant.set == BalancedSet::Balanced && order % 2 == 0 {
            // Two antipodal pairs next to each other, the other particles paired with their opposites.
            let pairs = antipodal_pairs(order)?;
            if let Some(why) = refutation(&network, &pairs, variant.gain)? {
                let points = pairs.iter().map(|z| [(&z.re).into(), (&z.im).into()]).collect();
                let phases = "(0, a, a + pi, pi), cos a = 3/5, and further antipodal pairs".to_string();
                return fails(phases, why, Some(Witness::Directions { points }));
            }
        }
        let field = CosineField::new(order as u32);
        let columns: Vec<_> = (1..order).map(|m| fourier_column(&field, order, m)).collect();
        let values: Vec<_> = columns.iter().map(|z| phase_potential(&network, z, 1)).collect::<Result<_, _>>()?;
        for (m, (phasors, value)) in (1..).zip(columns.iter().zip(&values)) {
            let largest = !values.iter().any(|other| (other.clone() - value).is_certainly_positive());
            if variant.set == BalancedSet::Largest && !largest {
                continue;
            }
            cases += 1;
            if let Some(why) = refutation(&network, phasors, variant.gain)? {
                return fails(format!("2 pi {m} k/{order}"), why, None);
            }
        }
    }
    let section = "notes/paley_particles.md, Balanced formations on circulant graphs, steps 1-5";
    let detail = "exact Fourier columns on circulant graphs";
    Run::all([
        argued(&[1, 2, 3], "all circulant graphs", section),
        holds(exhaustive(PART, detail).cases(cases).on([1, 2])).checks("step 2 and the conclusion"),
        balanced_are_largest(variant, run).checks("step 3").on([3]),
    ])
}

/// On complete graphs balanced phases that are no pattern reach the bound `lambda_max/2 = N/2` of `W_1`.
fn balanced_are_largest(variant: &BalancedVariant, run: &Run) -> Result<Outcome, CheckError> {
    let field = CosineField::new(12);
    let part = "balanced phases on complete graphs reach the bound of W_1";
    run.instances(part, "antipodal pairs, with a triangle for odd N = 2 to 9", 2..=9usize, |order| {
        let network = if variant.complete { Neighbours::complete(order) } else { Neighbours::circulant(order, &[1]) };
        let triangle: &[i64] = if order % 2 == 1 { &[0, 4, 8] } else { &[] };
        let pairs = (0..).flat_map(|k| [k, k + 6]).take(order - triangle.len());
        let phasors: Vec<_> = triangle.iter().copied().chain(pairs).map(|k| field.phasor(k)).collect();
        let value = phase_potential(&network, &phasors, 1)?;
        let wrong = (value.clone() - value.ratio(order as i64, 2)).sign() != Some(Sign::Zero);
        let graph = if variant.complete { "complete graph" } else { "cycle" };
        Ok(wrong
            .then(|| format!("N = {order}, {graph}: balanced phases, two of them antipodal, have not the largest W_1")))
    })
}

/// Phases 0, a, a + pi, pi and further antipodal pairs, with rational phasors.
fn antipodal_pairs(order: usize) -> Result<Vec<Complex<Rational>>, CheckError> {
    let pairs = scattered_phasors(order / 2)?;
    let (first, second) = (pairs[0].clone(), pairs.get(1).cloned());
    let mut phasors = vec![first.clone()];
    if let Some(second) = second {
        phasors.extend([second.clone(), -second]);
    }
    phasors.push(-first);
    phasors.extend(pairs.iter().skip(2).flat_map(|z| [z.clone(), -z.clone()]));
    Ok(phasors)
}

/// With `offset` steps between neighbours on `C_12` the pattern stops being stable for large `K_1`; its cluster number.
#[derive(Clone, Copy)]
pub struct GainVariant {
    /// The pattern `theta_k = 2 pi offset k/12` of Figure 3(c).
    offset: usize,
    /// Whether the claim says that large gains destroy it (as printed), or that it stays.
    destroyed: bool,
    /// Twelfths of a turn by which one particle is moved along the circle before it is said to be in equilibrium.
    moved: usize,
}

pub fn larger_gain() -> Record<GainVariant> {
    Record::new(
        "paley.fig3.gain",
        "The splay formations of C_12 that are stable for K_1 > 0 have neighbours 5 or 7 twelfths of a turn \
         apart (with 1 or 11, W_1 grows). At theta_k = 2 pi m k/N the Hessian of W_1 is (1/N) cos(2 pi m/N) \
         L: for m = 5 negative definite up to rotation. W_1 is an isolated strict maximum there, so by V = \
         K_0 S - K_1 w0^-2 W_1 the formation is exponentially stable for every K_1 > 0: no gain turns \
         Figure 3(c) into the (2,N)-pattern (m = 6), which is stable for every K_1 > 0 as well. Which of \
         the two is reached depends on the initial state at every gain (shares: paley.fig3). Started anew \
         from one initial state, a larger gain can end in the other pattern; but from random states three of five runs end in \
         the (2,N)-pattern at any gain, so that it is no effect of the increase.",
        GainVariant { offset: 5, destroyed: true, moved: 0 },
        examine_larger_gain,
    )
    .reading("The increase is what leads from the formation of Figure 3(c) to the pattern: the gain is raised on that formation.")
    .repaired(Fault::False, "", GainVariant { offset: 5, destroyed: false, moved: 0 })
    .repaired_clauses(&[
        "Under (22) on C_12 with w0 != 0 the splay circular formation of Figure 3(c) (neighbours 5/12 of a turn apart) is exponentially \
         stable up to rotation and translation for every K_1 > 0 and K_0 > 0.",
        "The (2,12)-pattern in which neighbours are opposite is too.",
        "The formation of Figure 3(c) is an equilibrium, up to rotation, at every K_1 and K_0, so that a change of the gain leaves it where it is.",
    ])
    .altered("neighbours one twelfth apart are stable", |v| v.offset = 1)
    .altered("a quarter turn apart", |v| v.offset = 3)
    .altered("one particle elsewhere on the circle", |v| v.moved = 1)
}

fn examine_larger_gain(variant: &GainVariant, _run: &mut Run) -> Result<Outcome, CheckError> {
    const N: usize = 12;
    let network = Neighbours::circulant(N, &[1]);
    let field = CosineField::new(N as u32);
    let mut evidence = Vec::new();
    for (clause, offset) in [(1, variant.offset), (2, N / 2)] {
        let phasors = fourier_column(&field, N, offset);
        let found = laplacian_hessian(&network, &phasors, 1)?;
        let stable = found == Inertia { positive: 0, negative: N - 1, zero: 1 };
        let detail = format!(
            "Hessian of W_1 on C_12: {} negative, {} zero, {} positive; proof in the notes",
            found.negative, found.zero, found.positive
        );
        let exact = exact(format!("neighbours {offset}/12 of a turn apart, every K_1 > 0"), detail);
        let meant = offset == variant.offset;
        if stable == (meant && variant.destroyed) {
            let what = format!(
                "C_12, theta_k = 2 pi {offset} k/12: a circular formation that is {} for every K_1 > 0",
                if stable { "exponentially stable up to symmetry" } else { "not exponentially stable" }
            );
            return Ok(Outcome::fails(what, exact));
        }
        evidence.push(exact.on([clause]));
    }
    // With all centres in one place u_k - w0 is the K_1 term of (22) alone.
    let step = |k: usize| variant.offset * k + if k == 0 { variant.moved } else { 0 };
    let phasors: Vec<_> = (0..N).map(|k| field.phasor(step(k) as i64)).collect();
    let still = misalignment(&network, &phasors).iter().all(|term| term.sign() == Some(Sign::Zero));
    let equilibrium =
        exact("u_k = w0, whatever K_1", "<i e^{i theta_k}, L_k e^{i theta}> = 0 for all twelve particles");
    if !still {
        let what = "C_12, one particle a twelfth of a turn off: u_k = w0 fails for every K_1 other than 0";
        return Ok(Outcome::fails(what, equilibrium));
    }
    evidence.push(equilibrium.on([3]).for_all());
    let steps = "notes/paley_particles.md, Linearisation at a circular formation, steps 1 to 3 and 6";
    Run::all([Ok(Outcome::Holds(evidence)).checks("step 6"), argued(&[1, 2, 3], "every K_1 > 0", steps)])
}

/// On `C_order` the maximisers of `W_1` are one alternating pattern, up to rotation or not; or every (2,N)-pattern is one.
#[derive(Clone, Copy)]
pub struct MaximumVariant {
    order: usize,
    up_to_rotation: bool,
    any_labels: bool,
}

pub fn unique_maximum() -> Record<MaximumVariant> {
    Record::new(
        "paley.fig3.max",
        "W_1 = (1/(2N)) <x, L x> <= lambda_max/2 for |x|^2 = N, with equality iff L x = lambda_max x. On \
         C_12 lambda_max = 4 is simple with eigenvector (-1)^k, so e^{i theta} = e^{i alpha} (-1)^k.",
        MaximumVariant { order: 12, up_to_rotation: true, any_labels: false },
        examine_unique_maximum,
    )
    .clauses(&["The balanced (2,N)-pattern maximizes W_1.", "It is the unique configuration that does."])
    .reading(
        "Unique up to a rotation of all phases; the (2,N)-pattern in which neighbours on the cycle are \
         opposite.",
    )
    .altered("C_11", |v| v.order = 11)
    .altered("unique, rotations counted", |v| v.up_to_rotation = false)
    .altered("every (2,N)-pattern maximises", |v| v.any_labels = true)
}

fn examine_unique_maximum(variant: &MaximumVariant, _run: &mut Run) -> Result<Outcome, CheckError> {
    let order = variant.order;
    let fails = |what: &str| {
        Ok(Outcome::fails(
            format!("N = {order}: {what}"),
            exact("unique maximiser up to rotation", "exact kernel of L - 4"),
        ))
    };
    let graph = Graph::ring(order);
    let laplacian = graph.laplacian()?;
    let four = RationalMatrix::identity(order)?.scaled(&rational(4, 1));
    // 4 is the largest eigenvalue if it is one: 4 - L is positive semidefinite (Gershgorin).
    let maximisers = laplacian.minus(&four)?.kernel();
    let [vector] = maximisers.as_slice() else {
        return fails("4 is no eigenvalue of L, so the alternating pattern is none");
    };
    let alternating = vector.windows(2).all(|pair| pair[0] == -pair[1].clone());
    if !alternating {
        return fails("the eigenvector does not alternate");
    }
    let network = Neighbours::of(&graph);
    let value = |phasors: &[Complex<Rational>]| phase_potential(&network, phasors, 1);
    let one = |sign: i64| Complex::real(rational(sign, 1));
    let alternate: Vec<_> = (0..order).map(|k| one(if k % 2 == 0 { 1 } else { -1 })).collect();
    let halves = on_the_line(order, order / 2);
    let turned: Vec<_> = alternate.iter().map(quarter_turn).collect();
    if value(&alternate)? != rational(2, 1) {
        return fails("the alternating pattern does not reach lambda_max/2");
    }
    if variant.any_labels && value(&halves)? != rational(2, 1) {
        return fails("the (2,N)-pattern of two halves of the cycle has a smaller W_1");
    }
    if !variant.up_to_rotation && value(&turned)? == rational(2, 1) {
        return fails("the pattern turned by a quarter maximises W_1 too");
    }
    let detail = "kernel of L - 4 on C_12 spanned by (-1)^k, and W_1 = 2 there; 4 bounds the spectrum (Gershgorin)";
    holds(exact("unique maximiser up to rotation", detail).on([1, 2]).for_all())
}
