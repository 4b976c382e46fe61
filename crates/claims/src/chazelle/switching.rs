//! chazelle.epsineq, chazelle.lem3.1.count, chazelle.lem3.1 and chazelle.thm1.1.switches: the number of network switches.

use super::sequences::{NetworkHistory, line_networks, paper_threshold, random_graph, random_line_flock, words};
use algebra::graph::Graph;
use arithmetic::{Interval, Rational, Real, Ring, Signed, rational};
use ledger::{CheckError, Claim, Control, Evidence, Fault, Grade, Outcome, Repair, Run};
use models::averaging::Weights;
use num_bigint::BigInt;
use rand_chacha::rand_core::Rng;

const PRECISION: u32 = 128;

fn natural_logarithm(nu: u64) -> Result<Interval, CheckError> {
    Ok(Interval::from_rational(&Rational::from_integer(nu.into()), PRECISION).ln()?)
}

/// chazelle.epsineq.
pub struct ThresholdInequality;

/// The exponents of `e^(-nu^p) < nu^(-nu^q)`.
#[derive(Clone, Copy)]
pub struct ThresholdVariant {
    p: fn(u32) -> u32,
    q: u32,
    /// The other way round.
    reversed: bool,
}

impl Claim for ThresholdInequality {
    type Variant = ThresholdVariant;

    fn id(&self) -> &str {
        "chazelle.epsineq"
    }

    fn derivation(&self) -> &str {
        "It says nu^(nu²) > nu^4 ln nu. nu = 1: 1 > 0. nu = 2: 16 > 16 ln 2. For nu >= 3: nu^(nu²) >= nu^9 > nu^5 > nu^4 ln nu."
    }

    fn printed(&self) -> ThresholdVariant {
        ThresholdVariant { p: |nu| nu * nu, q: 4, reversed: false }
    }

    fn controls(&self) -> Vec<Control<ThresholdVariant>> {
        let printed = self.printed();
        vec![
            Control::new("e^(-nu^nu)", ThresholdVariant { p: |nu| nu, ..printed }),
            Control::new("nu^(-nu^5)", ThresholdVariant { q: 5, ..printed }),
            Control::new("the other way round", ThresholdVariant { reversed: true, ..printed }),
        ]
    }

    fn examine(&self, variant: &ThresholdVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        const LARGEST: u32 = 24;
        for nu in 1..=LARGEST {
            run.checkpoint()?;
            let base = Interval::from_rational(&rational(i64::from(nu), 1), PRECISION);
            let excess = base.power(u64::from((variant.p)(nu)))
                - base.power(u64::from(variant.q)) * natural_logarithm(nu.into())?;
            let excess = if variant.reversed { -excess } else { excess };
            if !excess.is_certainly_positive() {
                let what = format!("nu = {nu}: nu^{} - nu^{} ln nu is not positive", (variant.p)(nu), variant.q);
                return Ok(Outcome::fails(what, Evidence::new(Grade::Certified, "the inequality", "an enclosure")));
            }
        }
        Ok(Outcome::Holds(vec![
            Evidence::new(
                Grade::Certified,
                "the inequality, for all integers nu >= 1",
                "proof in notes/chazelle_switches.md; enclosures of the logarithms of both sides for nu = 1, ..., 24",
            )
            .cases(LARGEST as usize),
        ]))
    }
}

/// chazelle.lem3.1.count.
pub struct FinalCount;

/// What is added to the switches until `T_k`.
#[derive(Clone, Copy)]
pub struct FinalCountVariant {
    /// The number of pairs of `V_k`.
    pairs: bool,
    /// One switch at `T_k + 1`.
    one_more: bool,
    /// The later switches among the birds outside `V_k`.
    others: bool,
}

impl FinalCountVariant {
    /// The failure for `s = 1` and `k`, if any; `None` as well where birds of `V_k` separate after `T_k + 1`.
    fn fails_at(&self, history: &NetworkHistory, k: usize) -> Option<String> {
        let found = history.stabilisers(k);
        let last = found.get(k - 1)?;
        let (time, end) = (last.time, history.constant_from());
        let inside = |t: usize| history.footprint(t).restricted(&last.members);
        if (time + 2..=end).any(|t| !inside(t).contains(&inside(t - 1))) {
            return None;
        }
        let others: Vec<usize> = (0..history.order()).filter(|i| !last.members.contains(i)).collect();
        let size = last.members.len();
        let extra = if self.pairs { size * (size - 1) / 2 } else { 0 }
            + usize::from(self.one_more)
            + if self.others { history.changes_within(&others, time + 2, end) } else { 0 };
        let (until, total) = (history.changes(2, time), history.changes(2, end));
        (total > until + extra).then(|| {
            format!(
                "{}: T_{k} = {time}, |V_{k}| = {size}, {until} switches until T_{k} and at most {extra} more claimed, but {total} in all",
                history.show()
            )
        })
    }
}

/// Bird 1 alone for ever, birds 2 and 3 (`c_i = 1/4`) joined until time `k` and not after, with the hysteresis of the paper.
/// From then on the network is known for all time: there is no edge, velocities are constant, bird 1 rests behind, and
/// bird 3 flies ahead of bird 2 and faster.
fn leaving_pair(k: usize) -> Result<NetworkHistory, CheckError> {
    // x_3 - x_2 at time t is -1 + w (2 - 2^(1-t)): 1 at t = k.
    let w = rational(1, 1) / (rational(1, 1) - rational(1, 2).pow(k as i32));
    let weights = Weights::Given(vec![rational(1, 4); 3]);
    let positions = vec![rational(0, 1), rational(11, 1), rational(10, 1)];
    let velocities = vec![rational(0, 1), rational(3, 1), rational(3, 1) + w];
    let networks = line_networks(positions, velocities, &weights, Some(paper_threshold(3)), k + 2)?;
    Ok(NetworkHistory::new(networks))
}

impl Claim for FinalCount {
    type Variant = FinalCountVariant;

    fn id(&self) -> &str {
        "chazelle.lem3.1.count"
    }

    fn derivation(&self) -> &str {
        "Only pairs inside V_k are counted. Birds outside V_k can go on switching among themselves: bird 1 alone gives V_k = {1}, T_k = \
         T_1 + k - 1, whatever the others do later. They meet no bird of V_k after T_k, so they are a group of their own: N(n - |V_k|) \
         more. Edges inside V_k last from T_k + 1 on, so the network may also change once at T_k + 1. With both added the count is \
         right, and the recursion for N(n) survives (notes/chazelle_switches.md)."
    }

    fn printed(&self) -> FinalCountVariant {
        FinalCountVariant { pairs: true, one_more: false, others: false }
    }

    fn repair(&self) -> Option<Repair<FinalCountVariant>> {
        Some(Repair {
            fault: Fault::False, clauses: Vec::new(),
            statement: "When birds of V_k joined at time T_k+1 or later always remain so, the total number of network changes is at most \
                        N(T_k,T_{k-1}) + ... + N(T_1,1) + 1 + binom(|V_k|,2) + N(n-|V_k|)."
                .to_string(),
            variant: FinalCountVariant { pairs: true, one_more: true, others: true },
        })
    }

    fn controls(&self) -> Vec<Control<FinalCountVariant>> {
        let corrected = FinalCountVariant { pairs: true, one_more: true, others: true };
        vec![
            Control::new("without the birds outside V_k", FinalCountVariant { others: false, ..corrected }),
            Control::new("without the switch at T_k + 1", FinalCountVariant { one_more: false, ..corrected }),
            Control::new("without the pairs", FinalCountVariant { pairs: false, ..corrected }),
        ]
    }

    fn examine(&self, variant: &FinalCountVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        const FLOCKS: usize = 40;
        for k in 1..=FLOCKS {
            if let Some(what) = variant.fails_at(&leaving_pair(k)?, k) {
                let what = format!("x(0) = (0, 11, 10), v(1) = (0, 3, 3 + 1/(1 - 2^-{k})), c_i = 1/4: {what}");
                return Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "the count", "an exact flock")));
            }
        }
        let mut cases = 0;
        let exact = || Evidence::new(Grade::Exact, "the count", "one sequence with a constant end");
        for (order, length) in [(1, 1), (2, 6), (3, 4), (4, 2)] {
            let graphs: Vec<Graph> = Graph::all(order).collect();
            for word in words(graphs.len(), length) {
                run.checkpoint()?;
                let history = NetworkHistory::new(word.iter().map(|&k| graphs[k].clone()).collect());
                for k in 1..=3 {
                    cases += 1;
                    if let Some(what) = variant.fails_at(&history, k) {
                        return Ok(Outcome::fails(what, exact()));
                    }
                }
            }
        }
        let mut random = run.random(0);
        let sampled = run.cases(300, 6000);
        for _ in 0..sampled {
            run.checkpoint()?;
            let order = 3 + random.next_u32() as usize % 3;
            let history = NetworkHistory::new((0..6).map(|_| random_graph(order, 1, &mut random)).collect());
            if let Some(what) = (1..=3).find_map(|k| variant.fails_at(&history, k)) {
                return Ok(Outcome::fails(what, exact()));
            }
        }
        Ok(Outcome::Holds(vec![
            Evidence::new(
                Grade::Exhaustive,
                "the count",
                "proof in notes/chazelle_switches.md; all sequences of 6, 4, 2 networks on 2, 3, 4 birds with a constant end, k = 1, 2, 3",
            )
            .cases(cases),
            Evidence::new(Grade::Fuzzed, "the same", "random sequences of six networks on 3 to 5 birds").cases(sampled),
            Evidence::new(Grade::Exact, "flocks", "three birds of which two part at time k + 1").cases(FLOCKS),
        ]))
    }
}

/// A bound of the number of switches with the choices that its proof makes. Positive entries of `P(t)` are at least
/// `n^-a`, speeds at most `n^c`.
#[derive(Clone, Copy)]
pub struct SwitchesVariant {
    /// The exponent `E` of `N(n) <= n^E`, from `n`, `a`, `c`.
    pub exponent: fn(u64, u64, u64) -> u64,
    /// `k = nu^(a (nu-1) + room)`, from `c`.
    pub room: fn(u64) -> u64,
    /// Another bound in place of `n^E`.
    pub count: Option<fn(u64) -> u64>,
}

impl SwitchesVariant {
    /// `n^O(n³)`, as printed.
    pub const CUBIC: Self =
        SwitchesVariant { exponent: |n, a, c| (a + c + 9) * n.pow(3), room: |c| c + 6, count: None };
    /// What the proof gives with the sharper bound of the entries.
    pub const QUADRATIC: Self =
        SwitchesVariant { exponent: |n, a, c| a * (n - 1).pow(2) + (c + 9) * (n - 1) + 1, ..Self::CUBIC };
}

/// The `(a, c)` that are tried.
const CONSTANTS: [(u64, u64); 4] = [(1, 1), (2, 1), (1, 4), (3, 2)];

/// Decides a bound of the number of switches: the contraction that makes edges last, the recursion, flocks.
pub fn examine_switches(variant: &SwitchesVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    Run::all([edges_last(variant, run), recursion(variant, run), flocks(variant, run)])
}

/// `2 nu^c (1 - beta)^k < nu^(-nu^4)` with `beta = nu^(-a (nu-1))`, by `(1 - beta)^k <= e^(-k beta)`.
fn edges_last(variant: &SwitchesVariant, run: &Run) -> Result<Outcome, CheckError> {
    const LARGEST: u64 = 40;
    for (nu, (_, c)) in (2..=LARGEST).flat_map(|nu| CONSTANTS.map(|constants| (nu, constants))) {
        run.checkpoint()?;
        let base = Interval::from_rational(&Rational::from_integer(nu.into()), PRECISION);
        // k beta = nu^room, whatever a is.
        let gain = base.power((variant.room)(c));
        let needed = (base.power(4) + base.integer(c as i64)) * natural_logarithm(nu)? + natural_logarithm(2)?;
        if !(gain - needed).is_certainly_positive() {
            let what = format!("nu = {nu}, c = {c}: k beta = nu^{} is too small for the threshold", (variant.room)(c));
            return Ok(Outcome::fails(what, Evidence::new(Grade::Certified, "edges last", "an enclosure")));
        }
    }
    let detail = "k beta > (nu^4 + c) ln nu + ln 2 for nu = 2, ..., 40; proof for all nu in notes/chazelle_switches.md";
    Ok(Outcome::Holds(vec![Evidence::new(Grade::Certified, "edges inside V_k last after T_k + 1", detail)]))
}

/// `N(m) <= k (2m - 1) + 1 + m (m-1)/2 + (2k (m-1) + 1) N(m-1)` from `N(1) = 0`, for `m` up to `nu`.
fn recursion(variant: &SwitchesVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    const LARGEST: u64 = 12;
    for (nu, (a, c)) in (2..=LARGEST).flat_map(|nu| CONSTANTS.map(|constants| (nu, constants))) {
        run.checkpoint()?;
        let power = |exponent: u64| BigInt::from(nu).pow(exponent as u32);
        let k = power(a * (nu - 1) + (variant.room)(c));
        let bound = (2..=nu).fold(BigInt::from(0), |before, m| {
            &k * (2 * m - 1) + 1 + m * (m - 1) / 2 + (&k * 2 * (m - 1) + 1) * before
        });
        let claimed = variant.count.map_or_else(|| power((variant.exponent)(nu, a, c)), |count| count(nu).into());
        if variant.count.is_none() && bound > claimed {
            let what = format!(
                "nu = {nu}, a = {a}, c = {c}: the recursion gives more than nu^{}",
                (variant.exponent)(nu, a, c)
            );
            return Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "the recursion", "exact integers")));
        }
        if (a, c) == (1, 1) && nu <= 4 {
            run.value(&format!("recursion_bound_for_{nu}_birds"), bound.to_string());
        }
    }
    let detail = "exact integers, n = 2, ..., 12; proof for all n in notes/chazelle_switches.md";
    Ok(Outcome::Holds(vec![Evidence::new(Grade::Exact, "the recursion for N(n)", detail).cases(11 * CONSTANTS.len())]))
}

fn flocks(variant: &SwitchesVariant, run: &Run) -> Result<Outcome, CheckError> {
    // Two lazy birds meet at time 2 and bounce off each other: two switches.
    let bounce = line_networks(
        vec![rational(0, 1), rational(2, 1)],
        vec![rational(0, 1), rational(-1, 2)],
        &Weights::Lazy,
        Some(paper_threshold(2)),
        6,
    )?;
    let mut random = run.random(0);
    let sampled = run.cases(80, 2000);
    let mut most = 0;
    for case in 0..=sampled {
        run.checkpoint()?;
        let history = if case == 0 { NetworkHistory::new(bounce.clone()) } else { random_line_flock(&mut random, 16)? };
        let n = history.order() as u64;
        let switches = history.changes(2, history.constant_from()) as u64;
        most = most.max(switches);
        let exceeded = match variant.count {
            Some(count) => switches > count(n),
            None => BigInt::from(switches) > BigInt::from(n).pow((variant.exponent)(n, 1, 1) as u32),
        };
        if exceeded {
            let what = format!("{}: {switches} switches", history.show());
            return Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "flocks", "an exact flock")));
        }
    }
    let detail = format!("exact flocks of 2 to 5 birds on the line, 16 steps, at most {most} switches");
    Ok(Outcome::Holds(vec![Evidence::new(Grade::Fuzzed, "flocks", detail).cases(sampled)]))
}

fn switch_controls() -> Vec<Control<SwitchesVariant>> {
    let printed = SwitchesVariant::CUBIC;
    vec![
        Control::new("at most n - 1 switches", SwitchesVariant { count: Some(|n| n - 1), ..printed }),
        Control::new(
            "the recursion solved as n^O(n)",
            SwitchesVariant { exponent: |n, a, c| (a + c + 9) * n, ..printed },
        ),
        Control::new("k smaller by a factor nu^3", SwitchesVariant { room: |c| c + 3, ..printed }),
    ]
}

/// chazelle.lem3.1.
pub struct FlockingSwitches;

impl Claim for FlockingSwitches {
    type Variant = SwitchesVariant;

    fn id(&self) -> &str {
        "chazelle.lem3.1"
    }

    fn derivation(&self) -> &str {
        "Reading: O(log n)-bit inputs, used only as positive entries of P(t) >= n^-a and speeds <= n^c; hysteresis as printed. The printed \
         proof forgets the birds outside V_k and the switches at T_i + 1 and t_k + 1 (lem3.1.count, eq3.4); completed, it gives \
         N(n) <= k(2n-1) + 1 + n(n-1)/2 + (2k(n-1)+1) N(n-1) with k = nu^(a(nu-1)+c+6), and so \
         N(n) <= n^(a(n-1)² + (c+9)(n-1) + 1), less than n^((a+c+9)n³). Proof in notes/chazelle_switches.md."
    }

    fn printed(&self) -> SwitchesVariant {
        SwitchesVariant::CUBIC
    }

    fn controls(&self) -> Vec<Control<SwitchesVariant>> {
        switch_controls()
    }

    fn examine(&self, variant: &SwitchesVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        examine_switches(variant, run)
    }
}

/// chazelle.thm1.1.switches.
pub struct TotalSwitches;

impl Claim for TotalSwitches {
    type Variant = SwitchesVariant;

    fn id(&self) -> &str {
        "chazelle.thm1.1.switches"
    }

    fn derivation(&self) -> &str {
        "Model D: lem3.1. Model K with kappa = 0: theta(t+1) = P(t) theta(t) with entries >= 1/n, and a distance changes by at most \
         sigma |e^(i theta_i) - e^(i theta_j)| <= sigma |theta_i - theta_j|, where theta starts in [0, 2 pi): the same argument with \
         2 pi sigma <= 2 n^c for the diameter of the velocities. The extra rule that the paper adds to model K \"to simplify the proofs\" is not \
         stated there; the reading is the hysteresis rule as printed. Proof in notes/chazelle_switches.md."
    }

    fn printed(&self) -> SwitchesVariant {
        SwitchesVariant::CUBIC
    }

    fn controls(&self) -> Vec<Control<SwitchesVariant>> {
        switch_controls()
    }

    fn examine(&self, variant: &SwitchesVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        examine_switches(variant, run)
    }
}
