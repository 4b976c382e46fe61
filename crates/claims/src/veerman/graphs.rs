//! veerman.nth_neighbour, veerman.onlytwo: other communication graphs on the line.

use super::{gains, negative_gains, parts, unit, within};
use crate::prelude::*;
use models::platoon::{
    Communication, CommunicationGraph, Gains, amplitude_one_sided, amplitudes_two_sided, gain_squared_one_sided,
    resonance,
};

/// For every `n >= smallest`: the graph is connected or not, and the followers that are not joined to the leader, or all, stay behind.
#[derive(Clone, Copy)]
pub struct NeighbourVariant {
    smallest: usize,
    connected: bool,
    all_stay: bool,
}

pub fn nth_neighbour() -> Record<NeighbourVariant> {
    Record::new(
        "veerman.nth_neighbour",
        "Tracking joins agents whose numbers differ by n, so it stays within the residue classes modulo n; the leader is in the class of \
         0. For n >= 2 agent 1 is in another one: the graph of the agents 0 to N + 1 is not connected, and agents of the other classes, \
         at rest in formation, stay at rest whatever the leader does. For n = 1 the \
         graph is the path of system (2): connected, and everyone follows. The statement needs n >= 2, which it does not say.",
        NeighbourVariant { smallest: 1, connected: false, all_stay: false },
        examine_neighbour,
    )
    .reading("An agent that has no n-th agent in front of it tracks the n-th one behind it only, one that has none behind it the n-th one in front only, like the last car of (2), and one that has neither tracks nobody.")
    .clauses(&[
        "If each agent keeps track of only the n-th agent in front and behind it, the communication graph is not connected.",
        "Some agents will stay behind.",
    ])
    .repaired_by(Fault::Hypothesis, "", |v| v.smallest = 2)
    .repaired_clauses(&[
        "If each of the agents 1 to N + 1 behind the leader, number 0, keeps track of only the n-th agent in front and behind it, with n >= \
         2 (of the one of the two that there is, where the other is missing, and of nobody where both are), the communication graph is not \
         connected.",
        "The followers that are not joined to the leader (agent 1 among them), if they start at rest in their places, stay there whatever the leader does: they stay behind one that leaves.",
    ])
    .altered("connected for n >= 2", |v| v.connected = true)
    .altered("all agents stay behind", |v| v.all_stay = true)
}

fn examine_neighbour(variant: &NeighbourVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    const MOST_N: usize = 8;
    const MOST: usize = 14;
    let detail = format!("n = {} to {MOST_N}, 1 to {MOST} followers; accelerations exact", variant.smallest);
    let cases = (variant.smallest..=MOST_N).flat_map(|n| (1..=MOST).map(move |followers| (n, followers)));
    let graphs = run.instances("communication graphs", &detail, cases, |(n, followers)| {
        let graph = CommunicationGraph::nth_neighbours(n, followers)?;
        let behind = graph.staying_at_rest(&gains(((-2, 1), (-1, 3))));
        let class = |k: &usize| variant.all_stay || !k.is_multiple_of(n);
        let claimed: Vec<usize> = (1..=followers).filter(class).collect();
        let as_claimed = behind == claimed && behind.contains(&1);
        let connected = graph.is_connected();
        let what = || {
            let what = if connected { "connected" } else { "not connected" };
            let names: Vec<String> = behind.iter().map(ToString::to_string).collect();
            let stay = match names.as_slice() {
                [] => "every follower moves".to_string(),
                all if all.len() == followers => "every follower stays at rest".to_string(),
                [one] => format!("of the followers 1 to {followers} only {one} stays at rest"),
                more => format!("of the followers 1 to {followers} only {} stay at rest", more.join(", ")),
            };
            format!("n = {n}, N = {}: the graph is {what}, and {stay}", followers - 1)
        };
        Ok((connected != variant.connected || !as_claimed).then(what))
    })?;
    let proof = argued(&[1, 2], "all n >= 2 and N", "notes/veerman_platoons.md, other graphs, steps 1 to 3");
    Run::all([Ok(graphs.on([1, 2])).checks("steps 2 and 3"), proof])
}

/// The degrees `p` of the families of graphs that are looked at; that of degree p is claimed to have the degree `p + shift`.
#[derive(Clone, Copy)]
pub struct GrowthVariant {
    pub(crate) degrees: &'static [u32],
    pub(crate) shift: u32,
    /// The gain per car of system (1) at `w = 1` is claimed to be this power of `|1/gamma|²`.
    pub(crate) power: u64,
    /// So many platoons, or cars that track the leader, are counted that are not there.
    pub(crate) more: u64,
}

impl GrowthVariant {
    /// The quadratic case first: it needs the nearest cars only. Degree 0 is the star.
    pub(crate) const TRUE: Self = GrowthVariant { degrees: &[2, 1, 3], shift: 0, power: 1, more: 0 };
}

/// Everyone tracks the leader: all amplitudes are 1/gamma.
fn star(followers: usize, more: u64) -> Identity<'static> {
    Identity::of(move |[f, g, w]| {
        let gains = Gains { f: f.clone(), g: g.clone() };
        let graph =
            CommunicationGraph::star(followers).map_err(|_| ArithmeticError::Domain("at least one follower"))?;
        let one = amplitude_one_sided(&gains, w, 1 + more)?;
        Ok((parts(graph.response(&gains, w)?), parts(vec![one; followers])))
    })
    .within(negative_gains)
}

/// `platoons` two-sided platoons of `length` cars in series behind `spare` cars that track the leader: the last car has the power of the
/// single platoon's last amplitude.
fn series(spare: usize, length: usize, platoons: usize, more: u64) -> Identity<'static> {
    Identity::of(move |[f, g, w]| {
        let gains = Gains { f: f.clone(), g: g.clone() };
        let graph = CommunicationGraph::in_series_behind(spare, &vec![length; platoons])
            .map_err(|_| ArithmeticError::Domain("at least one follower"))?;
        let last = |amplitudes: Vec<Complex<Probe>>| {
            amplitudes.last().cloned().ok_or(ArithmeticError::Domain("at least one follower"))
        };
        let whole = last(graph.response(&gains, w)?)?;
        let single = last(amplitudes_two_sided(&gains, w, length)?)?;
        Ok((parts([whole]), parts([single.power(platoons as u64 + more)])))
    })
    .within(negative_gains)
}

/// The experiments of the paper are not described, and what they indicate depends on the graphs that are meant.
pub fn only_two() -> Record<()> {
    Record::new(
        "veerman.onlytwo",
        "For all graphs on a line the two possibilities are not the only ones: two two-sided platoons of m cars behind each other have a peak that grows like the square of their number \
         (beyond.veerman.growth), and if everyone tracks the leader the peak does not grow. Where all inner cars follow one rule, all rules of notes/communication_sweep.md \
         that were decided show exponential or linear growth, in floats; whether it is always so for rules of a finite range is open.",
        (),
        |(), _| {
            let why = "a report of experiments whose communication graphs the paper does not give: for all graphs on a line it is false (beyond.veerman.growth: \
                       two platoons in series grow quadratically, and if everyone tracks the leader nothing grows), for graphs in which all inner cars follow one rule of a finite range no counterexample is known and no proof";
            Ok(Outcome::Undecided(why.to_string()))
        },
    )
    .reading("\"Communication graphs of agents on a line\": all of them, or those in which all inner cars follow one rule of a finite range.")
}

/// The check of beyond.veerman.growth; clause 1 is exponential growth, clause 2 that of every degree.
pub(crate) fn examine_growth(variant: &GrowthVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut results = vec![exponential(variant, run).on([1]).checks("step 4")];
    for &degree in variant.degrees {
        results.push(growth(degree, variant, run).on([2]).checks("step 7"));
    }
    let names = ["f", "g", "w"];
    for followers in 1..=4 {
        let part = format!("p = 0, everyone tracks the leader: all amplitudes are 1/gamma, {followers} followers");
        results.push(run.identity(&star(followers, variant.more), &names, &part).on([2]).checks("step 8"));
    }
    for (length, platoons) in [(2, 1), (1, 2), (2, 2), (1, 3)] {
        let part = format!("{platoons} platoons of {length} in series: the power of a_{length}");
        results.push(run.identity(&series(0, length, platoons, variant.more), &names, &part).on([2]).checks("step 6"));
    }
    for (spare, length, platoons) in [(1, 2, 1), (2, 1, 2)] {
        let part = format!(
            "{platoons} platoons of {length} behind {spare} cars that track the leader: the power of a_{length}"
        );
        results
            .push(run.identity(&series(spare, length, platoons, variant.more), &names, &part).on([2]).checks("step 9"));
    }
    results.push(between_degrees(variant, run).on([2]).checks("step 9"));
    results.push(argued(&[1], "system (1)", "notes/veerman_platoons.md, other graphs, step 4"));
    results.push(argued(&[2], "platoons in series", "notes/veerman_platoons.md, other graphs, steps 5 to 9"));
    Run::all(results)
}

/// Certifies how the peak of the family of degree p grows from m cars per platoon to 8m and 64m: by `8^degree` up to 1 per cent.
fn growth(p: u32, variant: &GrowthVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let degree = p + variant.shift;
    let peak =
        |m: u64| -> Result<Interval, CheckError> { Ok(resonance(&unit(), m, 20)?.amplitude.power(u64::from(p))) };
    let peaks = [32, 256, 2048].map(peak).into_iter().collect::<Result<Vec<_>, _>>()?;
    let name = format!("{p} platoons in series");
    let numbers: Vec<String> = peaks.iter().map(|peak| interval_value(peak, 8)).collect();
    run.value(&format!("peak_degree_{p}_platoons_of_256"), numbers[1].clone());
    let numbers = numbers.join(", ");
    let detail = format!("peaks {numbers} for platoons of 32, 256, 2048 cars, f = g = -1");
    run.every(certified(&name, detail), peaks.windows(2), |pair| {
        let ratio = pair[1].over(&pair[0])? * pair[0].rational(&rational(1, 8i64.pow(degree)));
        let grows = within(&ratio, &rational(1, 1), &rational(1, 100));
        Ok((!grows).then(|| format!("{name}, f = g = -1: the peak does not grow like M^{degree}: {numbers}")))
    })
}

/// `p = 1/2` and `3/2`: one platoon of `M^(1/2)` cars, two of `M^(3/4)`, all other cars track the leader.
fn between_degrees(variant: &GrowthVariant, run: &Run) -> Result<Outcome, CheckError> {
    // M = 2^(4e), the platoons have M^(p/k) cars, k = 1 and 2; the peak must grow by 2^(4p) per step of e.
    let part = "p = 1/2 and 3/2, the other cars track the leader";
    let detail =
        "M = 2^20, 2^24, 2^28, f = g = -1: from each size to the next the peak grows by 2^(4p) up to 1 per cent";
    run.every(certified(part, detail), [(1u32, 2u32), (2, 3)], |(platoons, step)| {
        let peak = |e: u32| -> Result<Interval, CheckError> {
            Ok(resonance(&unit(), 1 << (step * e), 20)?.amplitude.power(u64::from(platoons)))
        };
        let growth = 1i64 << (step * platoons + 4 * variant.shift);
        for e in 5..7 {
            let ratio = peak(e + 1)?.over(&peak(e)?)?;
            if !within(&(ratio.clone() * ratio.rational(&rational(1, growth))), &rational(1, 1), &rational(1, 100)) {
                return Ok(Some(format!(
                    "{platoons} platoons of M^({step}/4) cars, M = 2^{}: the peak grows by {ratio}",
                    4 * e
                )));
            }
        }
        Ok(None)
    })
}

/// System (1) grows exponentially: the amplitude is the M-th power of a number above 1, exactly that of the graph.
fn exponential(variant: &GrowthVariant, run: &Run) -> Result<Outcome, CheckError> {
    let w = rational(1, 1);
    let gain = gain_squared_one_sided(&unit(), &w.square())?.power(variant.power);
    let detail = "system (1), f = g = -1, w = 1: |a_M|² = 2^M exactly, 1 to 8 followers";
    run.every(exact("exponential growth", detail), 1..=8, |followers| {
        let last = CommunicationGraph::of(Communication::Front, followers)?.response(&unit(), &w)?.pop();
        let size = last.map(|a| a.norm_squared());
        let wrong = size != Some(gain.power(followers as u64)) || gain <= rational(1, 1);
        Ok(wrong.then(|| format!("system (1), {followers} followers, w = 1: |a_M|² is not {gain}^M")))
    })
}
