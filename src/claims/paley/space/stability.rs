//! paley.sync.exp, paley.bal.circ, paley.thm3.stab, paley.fig6.gain, paley.fig3.gain, paley.fig3.max: which circular formations are
//! stable.
//!
//! `notes/paley_particles.md` proves: at a circular formation that is a relative equilibrium of (5) with (20) and the negative
//! gradient of a phase potential `U`, the linearisation has on the unstable side as many eigenvalues as the Hessian of `U` has
//! negative ones; it is exponentially stable up to the symmetries where that Hessian is positive definite up to rotation.

use super::instances::{connected_graphs, described, scattered_phasors, stability};
use crate::arithmetic::{Complex, CosineField, Dual, Field, Rational, Ring, Signed, rational};
use crate::graph::Graph;
use crate::ledger::{CheckError, Claim, Control, Evidence, Fault, Grade, Outcome, Repair, Run};
use crate::matrix::{Inertia, inertia};
use crate::oscillator::{
    CircularGains, Neighbours, circular_control, circular_formation, linearisation, mean, misalignment,
    pattern_control, pattern_gradient, phase_jacobian, phase_potential, spacing_control, symmetric_pattern,
};

/// The inertia of the Hessian of `sign W_1`.
fn hessian_inertia<T: Field + Signed>(
    network: &Neighbours,
    phasors: &[Complex<T>],
    sign: i64,
) -> Result<Inertia, CheckError> {
    let hessian = phase_jacobian(phasors, |z| {
        let terms = misalignment(network, z);
        Ok(terms.into_iter().map(|term| term.clone() * term.integer(sign)).collect())
    })?;
    Ok(inertia(&hessian)?)
}

/// paley.sync.exp and paley.fig6.gain: the synchronised circular formation under (22).
#[derive(Clone, Copy)]
pub struct SynchronyVariant {
    /// The sign of `K_1`.
    orientation: i64,
    /// The sign of `K_0`.
    spacing: i64,
    connected: bool,
}

impl SynchronyVariant {
    const STABLE: Self = SynchronyVariant { orientation: -1, spacing: 1, connected: true };
}

fn examine_synchrony(variant: &SynchronyVariant, run: &Run) -> Result<Outcome, CheckError> {
    let graphs = if variant.connected { connected_graphs(run.cases(0, 1) == 1) } else { vec![Graph::empty(2)] };
    let mut cases = 0;
    for graph in graphs.iter().filter(|graph| graph.order() > 1) {
        for ((p, q), gain) in [((1, 10), (1, 10)), ((-1, 10), (1, 10)), ((2, 1), (5, 1))] {
            run.checkpoint()?;
            cases += 1;
            let omega = rational(p, q);
            let gains = CircularGains {
                omega: omega.clone(),
                spacing: rational(variant.spacing, 10),
                orientation: rational(variant.orientation * gain.0, gain.1),
            };
            let network = Neighbours::of(graph);
            let phasors = vec![scattered_phasors(2)?[1].clone(); graph.order()];
            let state = circular_formation(&omega, &phasors)?;
            let constant = gains.constant();
            let rows = linearisation(&state, &omega, |state| circular_control(&constant, &network, &network, state))?;
            let found = stability(&rows, &omega, true)?;
            if !found.stable || found.zeros != 1 {
                let how =
                    if found.positive { "has a positive eigenvalue" } else { "does not decay up to the symmetries" };
                let what = format!(
                    "{}, w0 = {omega}, K_0 = {}, K_1 = {}: the linearised synchronised circular formation {how}",
                    described(graph),
                    gains.spacing,
                    gains.orientation
                );
                return Ok(Outcome::fails(
                    what,
                    Evidence::new(Grade::Exact, "linearisation", "exact characteristic polynomial"),
                ));
            }
        }
    }
    let detail = "exact characteristic polynomials: 0 once, ± i w0 once, the others decay; proof for all connected graphs in \
                  notes/paley_particles.md: s^3 + (k_0 - k_1) s^2 + w0^2 s - k_1 w0^2 for each eigenvalue of L";
    Ok(Outcome::Holds(vec![Evidence::new(Grade::Exact, "linearisation", detail).cases(cases)]))
}

/// paley.sync.exp.
pub struct SynchronyStable;

impl Claim for SynchronyStable {
    type Variant = SynchronyVariant;

    fn id(&self) -> &str {
        "paley.sync.exp"
    }

    fn derivation(&self) -> &str {
        "In the turning frame with c_k = (a_k + i b_k) e^{i theta}: v = w0 (K_0/N) L a + (K_1/N) L phi, adot = w0 b - v/w0, bdot = -w0 a, phidot = v. On an \
         eigenvector of L with eigenvalue lambda, k_m = K_m lambda/N, the characteristic polynomial is s^3 + (k_0 - k_1) s^2 + w0^2 s - k_1 w0^2. By \
         Routh it is stable iff k_1 < 0 and (k_0 - k_1) w0^2 > -k_1 w0^2, that is k_0 > 0 (then k_0 - k_1 > 0). So for K_0 > 0 and K_1 < 0, for either \
         sign of w0, all but the symmetries decay exponentially (lambda > 0 for all but the constant vector on a connected graph)."
    }

    fn printed(&self) -> SynchronyVariant {
        SynchronyVariant::STABLE
    }

    fn controls(&self) -> Vec<Control<SynchronyVariant>> {
        vec![
            Control::new("K_1 > 0", SynchronyVariant { orientation: 1, ..SynchronyVariant::STABLE }),
            Control::new("K_1 = 0", SynchronyVariant { orientation: 0, ..SynchronyVariant::STABLE }),
            Control::new("K_0 < 0", SynchronyVariant { spacing: -1, ..SynchronyVariant::STABLE }),
            Control::new(
                "a graph that is not connected",
                SynchronyVariant { connected: false, ..SynchronyVariant::STABLE },
            ),
        ]
    }

    fn examine(&self, variant: &SynchronyVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        examine_synchrony(variant, run)
    }
}

/// paley.fig6.gain.
pub struct DriftGain;

impl Claim for DriftGain {
    type Variant = SynchronyVariant;

    fn id(&self) -> &str {
        "paley.fig6.gain"
    }

    fn derivation(&self) -> &str {
        "In a drift common to all the relative motion is that without drift (paley.drift). By the cubic of paley.sync.exp the product of the three \
         eigenvalues of each mode is k_1 w0^2: for K_1 > 0 there is a positive one on every connected graph with N >= 2, N = 12 included, so the \
         synchronised circular formation is not stabilised. The caption contradicts the convention of the article (K_1 < 0 synchronises): a sign slip."
    }

    fn printed(&self) -> SynchronyVariant {
        SynchronyVariant { orientation: 1, ..SynchronyVariant::STABLE }
    }

    fn repair(&self) -> Option<Repair<SynchronyVariant>> {
        Some(Repair {
            fault: Fault::Misprint,
            statement: "Stabilizing the synchronized circular formation in a drift field: f_k = -0.1, N = 12, w0 = K_0 = 0.1 and K_1 < 0.".to_string(),
            variant: SynchronyVariant::STABLE,
        })
    }

    fn controls(&self) -> Vec<Control<SynchronyVariant>> {
        vec![
            Control::new("K_1 = 0", SynchronyVariant { orientation: 0, ..SynchronyVariant::STABLE }),
            Control::new("K_0 < 0", SynchronyVariant { spacing: -1, ..SynchronyVariant::STABLE }),
        ]
    }

    fn examine(&self, variant: &SynchronyVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        examine_synchrony(variant, run)
    }
}

/// paley.bal.circ.
pub struct BalancedStable;

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

/// The set, and the sign of `K_1`.
#[derive(Clone, Copy)]
pub struct BalancedVariant {
    set: BalancedSet,
    gain: i64,
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
    let still = |x: &T| x.sign() == Some(crate::arithmetic::Sign::Zero);
    let momentum = mean(phasors)?;
    if !still(&momentum.re) || !still(&momentum.im) {
        return Ok(Some("the phases are not balanced"));
    }
    if !misalignment(network, phasors).iter().all(still) {
        return Ok(Some("u_k = w0 fails, so that the centres part and the solution leaves the set at once"));
    }
    // K_1 W_1 grows along the phases' own motion: directions in which it can grow are unstable.
    let growing = hessian_inertia(network, phasors, gain)?.positive;
    Ok((growing > 0).then_some("W_1 has directions of growth, which are unstable"))
}

impl Claim for BalancedStable {
    type Variant = BalancedVariant;

    fn id(&self) -> &str {
        "paley.bal.circ"
    }

    fn derivation(&self) -> &str {
        "A stable closed set is invariant. On C_4 the phases (0, a, a + pi, pi) are balanced, but tau = -+ sin a: with c = c_0 1, cdot_k = -e^{i theta_k} K_1 \
         tau_k/(w0 N) differs between particles, so the solution leaves the set of balanced circular formations at once. Nor are the balanced equilibria \
         in it stable: on C_N the pattern theta_k = 2 pi m k/N has unstable directions where cos(2 pi m/N) > 0. What is stable for K_1 > 0: by V = K_0 S \
         - K_1 w0^-2 W_1 (paley.eq21) the circular formations that maximise W_1. On a circulant graph W_1 <= lambda_max/2 is attained by a Fourier \
         column, and e^{i theta} is then an eigenvector of lambda_max > 0, so these formations are balanced. On complete graphs they are all \
         the balanced ones."
    }

    fn printed(&self) -> BalancedVariant {
        BalancedVariant { set: BalancedSet::Balanced, gain: 1 }
    }

    fn repair(&self) -> Option<Repair<BalancedVariant>> {
        Some(Repair {
            fault: Fault::False,
            statement: "If G is circulant and connected, N >= 2, then under (22) with K_0, K_1 > 0 the set of circular formations whose phases maximise W_1 \
                        (all of them balanced: L e^{i theta} = lambda_max e^{i theta}) is asymptotically stable. It is the set of all balanced \
                        circular formations if G is complete."
                .to_string(),
            variant: BalancedVariant { set: BalancedSet::Largest, gain: 1 },
        })
    }

    fn controls(&self) -> Vec<Control<BalancedVariant>> {
        vec![
            Control::new("the largest W_1 with K_1 < 0", BalancedVariant { set: BalancedSet::Largest, gain: -1 }),
            Control::new("all symmetric patterns", BalancedVariant { set: BalancedSet::Patterns, gain: 1 }),
        ]
    }

    fn examine(&self, variant: &BalancedVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let mut cases = 0;
        for (order, offsets) in circulants(run.cases(6, 12)) {
            run.checkpoint()?;
            let network = Neighbours::circulant(order, &offsets);
            let fails = |phases: String, why: &str| {
                let what = format!("N = {order}, circulant graph with offsets {offsets:?}, phases {phases}: {why}");
                Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "the set", "exact phasors")))
            };
            if variant.set == BalancedSet::Balanced && order % 2 == 0 {
                // Two antipodal pairs next to each other, the other particles paired with their opposites.
                let phasors = antipodal_pairs(order)?;
                if let Some(why) = refutation(&network, &phasors, variant.gain)? {
                    return fails("(0, a, a + pi, pi), cos a = 3/5, and further antipodal pairs".to_string(), why);
                }
            }
            let field = CosineField::new(order as u32);
            let column = |m: usize| (0..order).map(|k| field.phasor((m * k) as i64)).collect::<Vec<_>>();
            let columns: Vec<_> = (1..order).map(|m| (m, column(m))).collect();
            let values: Vec<_> =
                columns.iter().map(|(_, z)| phase_potential(&network, z, 1)).collect::<Result<_, _>>()?;
            for ((m, phasors), value) in columns.iter().zip(&values) {
                let largest = !values.iter().any(|other| (other.clone() - value).is_certainly_positive());
                if variant.set == BalancedSet::Largest && !largest {
                    continue;
                }
                cases += 1;
                if let Some(why) = refutation(&network, phasors, variant.gain)? {
                    return fails(format!("2 pi {m} k/{order}"), why);
                }
            }
        }
        Ok(Outcome::Holds(vec![
            Evidence::new(
                Grade::Exact,
                "asymptotic stability, all circulant graphs",
                "Lyapunov function and proof in notes/paley_particles.md",
            ),
            Evidence::new(
                Grade::Exhaustive,
                "balanced, in equilibrium, no direction of growth",
                "exact Fourier columns on circulant graphs",
            )
            .cases(cases),
        ]))
    }
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

/// paley.thm3.stab.
pub struct PatternStable;

/// Signs of the gains of (25) below `M` and at `M`, sign of `K_0`, and whether the spacing network is connected.
#[derive(Clone, Copy)]
pub struct PatternVariant {
    below: i64,
    last: i64,
    spacing: i64,
    connected: bool,
}

impl PatternVariant {
    fn gains<T: Field>(&self, clusters: usize, like: &T) -> Vec<T> {
        (1..=clusters)
            .map(|m| if m < clusters { like.integer(4 * self.below) } else { like.ratio(self.last, 3) })
            .collect()
    }
}

impl Claim for PatternStable {
    type Variant = PatternVariant;

    fn id(&self) -> &str {
        "paley.thm3.stab"
    }

    fn derivation(&self) -> &str {
        "Reading: isolated and stabilised up to rotation and translation, that is, in shape space; (20) with K_0 > 0 on a connected undirected graph, w0 != 0. At \
         an (M,N)-pattern the Hessian of U_m, m < M, is (1/N)(cos m theta_kj), positive semidefinite, and that of U_M is -(I - J/N): the Hessian of \
         (25) is at least |K_M| (I - J/N), positive definite up to rotation, for every M dividing N. With V = K_0 S + w0^-2 U and Vdot = -w0^-2 sum (u_k - \
         w0)^2 (paley.VMN) the quadratic parts give a linearisation whose only eigenvalues off the left half plane are the three of the symmetries: \
         exponentially stable and isolated, for either sign of w0."
    }

    fn printed(&self) -> PatternVariant {
        PatternVariant { below: 1, last: -1, spacing: 1, connected: true }
    }

    fn controls(&self) -> Vec<Control<PatternVariant>> {
        let printed = self.printed();
        vec![
            Control::new("K_M > 0", PatternVariant { last: 1, ..printed }),
            Control::new("K_m < 0 below M", PatternVariant { below: -1, ..printed }),
            Control::new("K_0 < 0", PatternVariant { spacing: -1, ..printed }),
            Control::new("spacing network not connected", PatternVariant { connected: false, ..printed }),
        ]
    }

    fn examine(&self, variant: &PatternVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let fails =
            |what: String| Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "the pattern", "exact phasors")));
        let mut linearised = 0;
        for (order, clusters, spacing) in
            [(1, 1, 0), (2, 1, 0), (2, 2, 0), (3, 1, 1), (4, 1, 0), (4, 2, 0), (4, 2, 1), (4, 4, 0), (4, 4, 1)]
        {
            let graph = match (variant.connected, spacing) {
                (false, _) => Graph::empty(order),
                (true, 0) => Graph::from_fn(order, |_, _| true),
                (true, _) => Graph::path(order),
            };
            for (p, q) in [(1, 10), (-2, 1)] {
                run.checkpoint()?;
                linearised += 1;
                let omega = rational(p, q);
                let quarter =
                    [(1, 0), (0, 1), (-1, 0), (0, -1)].map(|(x, y)| Complex::new(rational(x, 1), rational(y, 1)));
                let phasors: Vec<_> = (0..order).map(|k| quarter[k % clusters * (4 / clusters)].clone()).collect();
                let network = Neighbours::of(&graph);
                let rows = linearisation(&circular_formation(&omega, &phasors)?, &omega, |state| {
                    let like = Dual::constant(omega.clone());
                    let pulled = spacing_control(&like, &like.ratio(variant.spacing, 10), &network, state)?;
                    let turned = pattern_control(&variant.gains(clusters, &like), &state.phasors)?;
                    Ok(pulled.into_iter().zip(turned).map(|(s, o)| s + o).collect())
                })?;
                let found = stability(&rows, &omega, true)?;
                if !found.stable || found.zeros != 1 {
                    return fails(format!(
                        "M = {clusters}, spacing {}, w0 = {omega}: the linearisation does not decay up to the symmetries",
                        described(&graph)
                    ));
                }
            }
        }
        let mut patterns = 0;
        let mut orders: Vec<usize> = (1..=run.cases(4, 11)).collect();
        orders.push(12);
        for order in orders {
            for clusters in (1..=order).filter(|m| order % m == 0) {
                run.checkpoint()?;
                let Some(phasors) = symmetric_pattern(clusters as u32, order as u32) else { continue };
                let hessian = phase_jacobian(&phasors, |z| pattern_gradient(&variant.gains(clusters, &z[0].re), z))?;
                let found = inertia(&hessian)?;
                patterns += 1;
                if found != (Inertia { positive: order - 1, negative: 0, zero: 1 }) {
                    return fails(format!(
                        "M = {clusters}, N = {order}: the Hessian of (25) has {} negative eigenvalues and zero {} times",
                        found.negative, found.zero
                    ));
                }
            }
        }
        Ok(Outcome::Holds(vec![
            Evidence::new(
                Grade::Exact,
                "exponential stability, all M, N",
                "proof in notes/paley_particles.md; exact characteristic polynomials, M = 1, 2, 4",
            )
            .cases(linearised),
            Evidence::new(
                Grade::Exhaustive,
                "Hessian of (25)",
                "inertia (N - 1, 0, 1) over exact cosines, N up to 4 (11 in full runs) and 12, all M",
            )
            .cases(patterns),
        ]))
    }
}

/// paley.fig3.gain.
pub struct LargerGain;

/// With `offset` steps between neighbours on `C_12` the pattern stops being stable for large `K_1`; its cluster number.
#[derive(Clone, Copy)]
pub struct GainVariant {
    /// The pattern `theta_k = 2 pi offset k/12` of Figure 3(c).
    offset: usize,
    /// Whether the claim says that large gains destroy it (as printed), or that it stays.
    destroyed: bool,
}

impl Claim for LargerGain {
    type Variant = GainVariant;

    fn id(&self) -> &str {
        "paley.fig3.gain"
    }

    fn derivation(&self) -> &str {
        "The splay formations of C_12 that are stable for K_1 > 0 have neighbours 5 or 7 twelfths of a turn apart (with 1 or 11, W_1 grows). At \
         theta_k = 2 pi m k/N the Hessian of W_1 is (1/N) cos(2 pi m/N) L: for m = 5 negative definite up to rotation. W_1 is an isolated strict maximum \
         there, so by V = K_0 S - K_1 w0^-2 W_1 the formation is exponentially stable for every K_1 > 0: no gain turns Figure 3(c) into the \
         (2,N)-pattern (m = 6), which is stable for every K_1 > 0 as well. Which of the two is reached depends on the \
         initial state at every gain (shares: paley.fig3). Reading: the gain is raised on the formation of Figure 3(c). Started anew from one initial state, a larger gain can \
         end in the other pattern."
    }

    fn printed(&self) -> GainVariant {
        GainVariant { offset: 5, destroyed: true }
    }

    fn repair(&self) -> Option<Repair<GainVariant>> {
        Some(Repair {
            fault: Fault::False,
            statement: "The splay circular formation of Figure 3(c) (neighbours 5/12 of a turn apart) and the balanced (2,N)-pattern are both \
                        exponentially stable up to symmetry for every K_1 > 0; increasing the gain does not lead from one to the other."
                .to_string(),
            variant: GainVariant { offset: 5, destroyed: false },
        })
    }

    fn controls(&self) -> Vec<Control<GainVariant>> {
        vec![
            Control::new("neighbours one twelfth apart are stable", GainVariant { offset: 1, destroyed: false }),
            Control::new("a quarter turn apart", GainVariant { offset: 3, destroyed: false }),
            Control::new("the (2,N)-pattern is destroyed", GainVariant { offset: 6, destroyed: true }),
        ]
    }

    fn examine(&self, variant: &GainVariant, _run: &mut Run) -> Result<Outcome, CheckError> {
        const N: usize = 12;
        let network = Neighbours::circulant(N, &[1]);
        let field = CosineField::new(N as u32);
        let mut evidence = Vec::new();
        for offset in [variant.offset, N / 2] {
            let phasors: Vec<_> = (0..N).map(|k| field.phasor((offset * k) as i64)).collect();
            let found = hessian_inertia(&network, &phasors, 1)?;
            let stable = found == Inertia { positive: 0, negative: N - 1, zero: 1 };
            let detail = format!(
                "Hessian of W_1 on C_12: {} negative, {} zero, {} positive; proof in the notes",
                found.negative, found.zero, found.positive
            );
            let exact =
                Evidence::new(Grade::Exact, format!("neighbours {offset}/12 of a turn apart, every K_1 > 0"), detail);
            let meant = offset == variant.offset;
            if stable == (meant && variant.destroyed) {
                let what = format!(
                    "C_12, theta_k = 2 pi {offset} k/12: a circular formation that is {} for every K_1 > 0",
                    if stable { "exponentially stable up to symmetry" } else { "not exponentially stable" }
                );
                return Ok(Outcome::fails(what, exact));
            }
            evidence.push(exact);
        }
        Ok(Outcome::Holds(evidence))
    }
}

/// paley.fig3.max.
pub struct UniqueMaximum;

/// On `C_order` the maximisers of `W_1` are one alternating pattern, up to rotation or not; or every (2,N)-pattern is one.
#[derive(Clone, Copy)]
pub struct MaximumVariant {
    order: usize,
    up_to_rotation: bool,
    any_labels: bool,
}

impl Claim for UniqueMaximum {
    type Variant = MaximumVariant;

    fn id(&self) -> &str {
        "paley.fig3.max"
    }

    fn derivation(&self) -> &str {
        "Reading: unique up to a rotation of all phases, as everywhere in the article; the configuration is the (2,N)-pattern in which neighbours on the \
         cycle are opposite (other placements of two clusters of six have a smaller W_1). W_1 = (1/(2N)) <x, L x> <= lambda_max/2 for |x|^2 = N, with \
         equality iff L x = lambda_max x. On C_12 lambda_max = 4 is simple with eigenvector (-1)^k, so e^{i theta} = e^{i alpha} (-1)^k."
    }

    fn printed(&self) -> MaximumVariant {
        MaximumVariant { order: 12, up_to_rotation: true, any_labels: false }
    }

    fn controls(&self) -> Vec<Control<MaximumVariant>> {
        let printed = self.printed();
        vec![
            Control::new("C_11", MaximumVariant { order: 11, ..printed }),
            Control::new("unique, rotations counted", MaximumVariant { up_to_rotation: false, ..printed }),
            Control::new("every (2,N)-pattern maximises", MaximumVariant { any_labels: true, ..printed }),
        ]
    }

    fn examine(&self, variant: &MaximumVariant, _run: &mut Run) -> Result<Outcome, CheckError> {
        let order = variant.order;
        let fails = |what: &str| {
            Ok(Outcome::fails(
                format!("N = {order}: {what}"),
                Evidence::new(Grade::Exact, "the maximum", "exact kernel of L - 4"),
            ))
        };
        let graph = Graph::from_fn(order, |i, j| j == i + 1 || (i == 0 && j + 1 == order));
        let laplacian = graph.laplacian()?;
        let four = crate::matrix::RationalMatrix::identity(order)?.scaled(&rational(4, 1));
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
        let halves: Vec<_> = (0..order).map(|k| one(if 2 * k < order { 1 } else { -1 })).collect();
        let turned: Vec<_> = alternate.iter().map(crate::oscillator::quarter_turn).collect();
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
        Ok(Outcome::Holds(vec![Evidence::new(Grade::Exact, "unique maximiser up to rotation", detail)]))
    }
}
