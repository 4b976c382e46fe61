//! chazelle.Nts and chazelle.eq3.4: counting network switches while the columns of `P(t, s)` fill.

use super::sequences::{histories, in_turn, show_history};
use crate::prelude::*;
use models::averaging::{Filling, GroupRule, Hysteresis, NetworkHistory, Start, Weights};

/// Which `u` are counted, and what is claimed of one step.
#[derive(Clone, Copy)]
pub struct CountVariant {
    with_s: bool,
    with_t: bool,
    /// One step counts exactly 1, or at most 1.
    exactly_one: bool,
    /// The first summand of the sum over `k`.
    first_summand: usize,
}

impl CountVariant {
    fn count(&self, history: &NetworkHistory, s: usize, t: usize) -> usize {
        let first = if self.with_s { s } else { s + 1 };
        // G_0 is not part of the sequence, and so u = 1 is not counted.
        if self.with_t { history.changes(first.max(2), t) } else { history.changes(first.max(2), t - 1) }
    }

    /// What fails for a column and `s`, if anything: one step, the sum.
    fn failures(&self, history: &NetworkHistory, column: usize, s: usize) -> [Option<Counterexample>; 2] {
        let mut times = vec![s];
        times.extend(history.growth_times(column, s));
        let one_step = times.windows(2).skip(1).filter(|pair| pair[1] == pair[0] + 1).find_map(|pair| {
            let count = self.count(history, pair[0], pair[1]);
            let wrong = if self.exactly_one { count != 1 } else { count > 1 };
            wrong.then(|| format!("N({}, {}) = {count}", pair[1], pair[0]))
        });
        let last = times[times.len() - 1];
        let summands = times.windows(2).skip(self.first_summand - 1);
        let (whole, sum) =
            (self.count(history, s, last), summands.map(|p| self.count(history, p[0], p[1])).sum::<usize>());
        let additivity = (whole != sum).then(|| format!("N({last}, {s}) = {whole}, but the sum is {sum}"));
        let place = |what: String| {
            let text = format!("{}, s = {s}, column {}: {what}", show_history(history), column + 1);
            Counterexample::new(text, [in_turn(history.graphs())])
        };
        let compared = |mut found: Counterexample| {
            let [whole, sum] = [whole, sum].map(|count| rational(count as i64, 1));
            found.witnesses.push(Witness::compared(&format!("N({last}, {s})"), &whole, "the sum", &sum));
            found
        };
        [one_step.map(place), additivity.map(place).map(compared)]
    }
}

/// Exact flocks, counterexamples within the model: three birds at rest in a row, and birds that meet one after the other.
fn small_flocks() -> Result<Vec<NetworkHistory>, CheckError> {
    let eighths = |x: &[i64]| x.iter().map(|&x| rational(x, 8)).collect::<Vec<_>>();
    [([0, 8, 16], [0, 0, 0]), ([0, 12, 40], [0, -3, -10]), ([0, 12, 24], [1, 0, -2])]
        .iter()
        .map(|(x, v)| {
            let start = Start::on_the_line(eighths(x), eighths(v), Weights::Lazy, Hysteresis::Paper);
            Ok(NetworkHistory::of_flock(&start, 12)?)
        })
        .collect()
}

pub fn count() -> Record<CountVariant> {
    Record::new(
        "chazelle.Nts",
        "With s < u < t there is no u between t_k and t_k + 1, so N(t_{k+1}, t_k) = 0; and the changes at u = t_1, \
         ..., t_{l-1} are in no summand. With s < u <= t the intervals are disjoint and fill (s, t_l], so N is \
         additive. One step contains one u, which counts where G_u differs from G_{u-1}: a column can grow while the \
         network rests (three birds at rest in a row), so N = 1 is N <= 1. t_1 = s, because P(s,s) has a first \
         column. Neither slip matters for what follows.",
        CountVariant { with_s: false, with_t: false, exactly_one: true, first_summand: 1 },
        check_count,
    )
    .clauses(&[
        "With N(t,s) the number of integers u, s < u < t, such that the footprint of P(u) differs from that of P(u-1): \
         N(t_{k+1}, t_k) = 1 when t_{k+1} = t_k + 1.",
        "N(t_l, s) = sum_{k=1}^l N(t_k, t_{k-1}).",
    ])
    .repaired_by(Fault::Slip, "", |v| (v.with_t, v.exactly_one) = (true, false))
    .repaired_clauses(&[
        "Let P(s), P(s+1), ... be matrices, s an integer, and for integers t >= t' >= s let N(t,t') be the number of integers u, t' < u <= \
         t, such that the footprint of P(u) (the places of its nonzero entries) differs from that of P(u-1): N(t_{k+1}, t_k) <= 1 for \
         integers t_k >= s and t_{k+1} = t_k + 1.",
        "With the same N and integers s = t_0 <= t_1 <= ... <= t_l, N(t_l, s) = sum_{k=1}^l N(t_k, t_{k-1}).",
    ])
    .altered("strict at both ends, at most 1", |v| v.with_t = false)
    .altered("both ends counted", |v| v.with_s = true)
    .altered("s < u <= t, exactly 1", |v| v.exactly_one = true)
    .altered("the sum from k = 3", |v| v.first_summand = 3)
}

fn check_count(variant: &CountVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let detail = "all columns, s = 1 and 2, all sequences of 6, 4, 2 networks on 2, 3, 4 birds with a constant end";
    // Each clause has its own counterexample.
    let (mut examples, mut evidence, mut failed_later) = (Vec::new(), Vec::new(), Vec::new());
    for (clause, part) in ["one step", "the sum"].into_iter().enumerate() {
        let flocks = exact(format!("{part}, flocks"), "exact flocks of three birds with the hysteresis of the paper");
        let all = exhaustive(format!("{part}, all sequences"), detail);
        let wrong = |history: NetworkHistory| {
            let mut columns = (1..=2).flat_map(|s| (0..history.order()).map(move |column| (s, column)));
            Ok(columns.find_map(|(s, column)| variant.failures(&history, column, s)[clause].take()))
        };
        let sequences = histories([(1, 3), (2, 6), (3, 4), (4, 2)]);
        let outcome = Run::all([run.every(flocks, small_flocks()?, wrong), run.every(all, sequences, wrong)])?;
        match outcome.on([clause + 1]) {
            Outcome::Fails { counterexample, evidence: more, later } => {
                examples.push(counterexample);
                evidence.extend(more);
                failed_later.extend(later);
            }
            Outcome::Holds(more) if examples.is_empty() => evidence.extend(more),
            _ => {}
        }
    }
    if examples.is_empty() {
        return Ok(Outcome::Holds(evidence));
    }
    evidence.retain(|e: &Evidence| e.grade == Grade::Exact);
    let text = examples.iter().map(|example| example.text.as_str()).collect::<Vec<_>>().join("; ");
    let witnesses = examples.into_iter().flat_map(|example: Counterexample| example.witnesses);
    let counterexample = Counterexample::new(text, witnesses);
    Ok(Outcome::Fails { counterexample, evidence, later: failed_later })
}

/// A bound of the switches until the footprint is stable.
#[derive(Clone, Copy)]
pub struct UntilStableVariant {
    /// The bound as a function of `n` and `N(n - 1)`.
    bound: fn(u64, u64) -> u64,
    /// Count to `T_1`, or count all switches.
    until_stable: bool,
}

pub fn until_stable() -> Record<UntilStableVariant> {
    Record::new(
        "chazelle.eq3.4",
        "T_1 is the last growth time t_l of some column, and the count for that column is the count of the whole \
         network, so no factor for n columns is needed. Between t_k and t_{k+1} the column's birds and the others do \
         not meet: N(n_k) + N(n - n_k) switches, one at t_{k+1}, and one the paper forgets, at t_k + 1, when an edge \
         between the two sides breaks (whether its display without that one fails for flocks is not decided). There are l - 1 <= n - 1 intervals (t_1 = s), which makes (n-1)(2N(n-1)+2) <= \
         2nN(n-1)+n, because N(n-1) >= (n-2)/2 (pairs that meet at different times).",
        UntilStableVariant { bound: |n, before| 2 * n * before + n, until_stable: true },
        check_until_stable,
    )
    .reading(
        "N(n) is the maximum over a class of motions that contains the continuation of a motion from any time and of \
         any group that meets no other bird (positions, old edges and weights arbitrary, speeds bounded); N(t,s) \
         counts s < u <= t.",
    )
    .altered("one interval only", |v| v.bound = |_, before| 2 * before + 1)
    .altered("N(n-1) + n", |v| v.bound = |n, before| before + n)
    .altered("all switches", |v| v.until_stable = false)
}

fn check_until_stable(variant: &UntilStableVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let settings =
        [(3, vec![0, 0, 1]), (3, vec![0, 0, 2]), (3, vec![0, 0, 3]), (4, vec![0, 0, 1, 1]), (4, vec![0, 0, 1, 2])];
    let mut found = Vec::new();
    let classes = run.every(
        exhaustive(
            "the bound",
            "the longest sequences in which each group of birds that meets no other has at most N switches, on 3 and \
             4 birds",
        ),
        settings,
        |(order, most): (usize, Vec<u64>)| {
            let bound = (variant.bound)(order as u64, most[order - 1]);
            let place =
                format!("sequences of networks on {order} birds with N(2), ..., N({}) = {:?}", order - 1, &most[2..]);
            let name = format!("most_switches_{order}_birds_N_{}", most[order - 1]);
            let search = Filling::new(GroupRule { order, most }, variant.until_stable);
            match search.and_then(|mut search| search.longest()) {
                Some(count) if count <= bound => found.push((name, count)),
                Some(count) => return Ok(Some(format!("{place}: {count} switches, more than {bound}"))),
                None => return Ok(Some(format!("{place}: there is no largest number of switches"))),
            }
            Ok(None)
        },
    )?;
    found.into_iter().for_each(|(name, count)| run.value(&name, count.to_string()));
    let mut random = run.random(0);
    let flocks =
        (0..run.cases(60, 1500)).map(|_| NetworkHistory::of_flock(&Start::random_on_the_line(&mut random), 14));
    let detail = "exact flocks on the line, continued with their last network; N(n-1) >= floor((n-1)/2)";
    Run::all([
        Ok(classes).checks("the conclusion"),
        run.every(fuzzed("flocks", detail), flocks, |history| {
            let history = history?;
            let n = history.order();
            let stable = (0..n).filter_map(|j| history.growth_times(j, 1).last().copied()).max().unwrap_or(1);
            let end = if variant.until_stable { stable } else { history.constant_from() };
            let (count, bound) = (history.changes(2, end) as u64, (variant.bound)(n as u64, (n as u64 - 1) / 2));
            Ok((count > bound).then(|| format!("{}: {count} switches, more than {bound}", show_history(&history))))
        })
        .checks("the conclusion"),
        argued(
            &[],
            "the bound, for every class of sequences closed under continuation and separation",
            "notes/chazelle_switches.md, Until the footprint is stable, steps 1-4",
        ),
    ])
}
