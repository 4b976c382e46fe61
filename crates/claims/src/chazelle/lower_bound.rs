//! chazelle.lower_bound and chazelle.lower_paths: the initial conditions said to need 2^^Omega(log n) steps.

use super::sequences::settled;
use crate::prelude::*;
use algebra::graph::Graph;
use models::averaging::settle::{Ending, Settlement};
use models::averaging::{Hysteresis, Start, Switch, Weights};
use num_bigint::BigInt;

/// The velocities of a group of four birds, in units of 1/8 of the speed `n^-c`.
pub type Group = [i64; 4];

/// As printed: (1, 0, -1, 0).
pub const PRINTED: Group = [8, 0, -8, 0];
/// Its mirror image: (0, 1, 0, -1).
pub const MIRRORED: Group = [0, 8, 0, -8];

/// Groups of four birds with the printed positions, on the line (the common y-speed changes nothing).
pub fn groups(list: &[Group], speed: &Rational, hysteresis: Hysteresis) -> Start {
    let pairs = 2 * list.len() as i64;
    let positions = (0..pairs).flat_map(|l| [rational(2 * l, 1), rational(6 * l + 2, 3)]).collect();
    let velocities = list.iter().flatten().map(|&v| speed * rational(v, 8)).collect();
    Start::on_the_line(positions, velocities, Weights::Lazy, hysteresis)
}

/// `n` and `c` with a moderate `n^c`.
const CASES: [(i64, u32); 22] = [
    (8, 3),
    (8, 1),
    (8, 2),
    (8, 4),
    (8, 5),
    (4, 2),
    (4, 3),
    (4, 4),
    (4, 5),
    (12, 1),
    (12, 2),
    (12, 3),
    (16, 1),
    (16, 2),
    (16, 3),
    (20, 1),
    (20, 2),
    (20, 3),
    (32, 1),
    (32, 2),
    (64, 1),
    (64, 2),
];
/// More of them, for a full run.
const MORE_CASES: [(i64, u32); 6] = [(12, 4), (12, 5), (16, 4), (20, 4), (32, 3), (64, 3)];

/// Those with `n^c` of at least `least`; `n = 4`, `c = 1` is the only one below 8.
fn cases(run: &Run, least: i64) -> Vec<(i64, u32)> {
    let more = &MORE_CASES[..run.cases(0, MORE_CASES.len())];
    [(4, 1)].iter().chain(&CASES).chain(more).copied().filter(|&(n, c)| n.pow(c) >= least).collect()
}

/// The networks `G_0` and those after each switch.
fn networks(start: &Start, switches: &[Switch]) -> Result<Vec<Graph>, CheckError> {
    let mut all = vec![models::averaging::Flock::new(start)?.network().clone()];
    for switch in switches {
        all.push(switch.applied_to(&all[all.len() - 1]));
    }
    Ok(all)
}

/// When the network is said to be steady.
#[derive(Clone, Copy)]
pub struct LowerVariant {
    /// The groups alternate between these two.
    patterns: [Group; 2],
    steady: Steady,
    /// Sizes with `n^c` of at least this.
    least: i64,
}

#[derive(Clone, Copy)]
enum Steady {
    /// Later than every polynomial: in particular later than `n^(c+1)`.
    Late,
    /// At `ceil(n^c/3) + shift`, after one switch in which these birds of each group join.
    AtContact { shift: i64, joined: (usize, usize) },
}

impl LowerVariant {
    fn fails_at(&self, n: i64, c: u32, hysteresis: &Hysteresis, run: &mut Run) -> Result<Option<String>, CheckError> {
        let power = BigInt::from(n).pow(c);
        let list: Vec<Group> = (0..n as usize / 4).map(|k| self.patterns[k % 2]).collect();
        let start = groups(&list, &Rational::new(1.into(), power.clone()), hysteresis.clone());
        let (switches, end) = settled(&start, run)?;
        let steady = matches!(end.ending, Ending::Steady);
        run.value(&format!("steady_from_n_{n}_c_{c}"), end.last_switch.to_string());
        let times: Vec<String> = switches.iter().map(|s| s.time.to_string()).collect();
        let at =
            format!("n = {n}, c = {c}, hysteresis {hysteresis:?}: the network changes at t = {}", times.join(", "));
        Ok(match self.steady {
            Steady::Late => (steady && end.last_switch <= &power * n).then_some(at),
            Steady::AtContact { shift, joined: (i, j) } => {
                let contact: BigInt = (&power + 2) / 3 + shift;
                let pairs: Vec<(usize, usize)> = (0..list.len()).map(|g| (4 * g + i, 4 * g + j)).collect();
                let once = steady && switches.len() == 1;
                if !once || end.last_switch != contact {
                    return Ok(Some(format!("{at}, not just once, at t = {contact}")));
                }
                (switches[0].gained != pairs).then(|| format!("{at}: birds {} and {} do not join", i + 1, j + 1))
            }
        })
    }
}

pub fn lower_bound() -> Record<LowerVariant> {
    Record::new(
        "chazelle.lower_bound",
        "All groups of four birds start alike, 4 apart, and are 4/3 apart at first: as long as no two groups meet, \
         they move alike, so their distances never change and they never meet. Inside a group the gap of the middle \
         birds is 4/3 - t/n^c until it is at most 1, at t = ceil(n^c/3); after that the path keeps its edges and \
         gains none (closed form in notes/settling.md, for n^c >= 8). So the network is steady after n^c/3 steps, \
         which is polynomial. What the sentence needs is groups that approach each other: with every second group \
         mirrored two groups of four merge after 10^84 steps (n = 8, c = 3), and beyond.chazelle.tower climbs one \
         level more. The bound itself is not refuted, the printed initial conditions are.",
        LowerVariant { patterns: [PRINTED; 2], steady: Steady::Late, least: 8 },
        check_lower_bound,
    )
    .repaired_by(Fault::False, "", |v| v.steady = Steady::AtContact { shift: 0, joined: (1, 2) })
    .repaired_clauses(&[
        "In model D on the line, from x(0) = (0, 2/3, 2, 8/3, ..., 2l, 2l+2/3, ..., n-2, n-4/3) and v(1) = n^-c (1, 0, -1, 0, ..., 1, 0, \
         -1, 0), with every bird that has neighbours giving the weight 1/3 to itself and equal weights to them (n a multiple of 4, n^c >= \
         8), the network changes at t = ceil(n^c/3), with or without hysteresis.",
        "From this start and with these weights the network changes at no other time.",
    ])
    .altered("one step later", |v| v.steady = Steady::AtContact { shift: 1, joined: (1, 2) })
    .altered("birds 1 and 3 of each group join", |v| v.steady = Steady::AtContact { shift: 0, joined: (0, 2) })
    .altered("n = 4, c = 1 as well", |v| v.least = 4)
    .altered("every second group mirrored", |v| v.patterns = [MIRRORED, PRINTED])
}

fn check_lower_bound(variant: &LowerVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let flocks = cases(run, variant.least).into_iter().flat_map(|(n, c)| {
        let kinds = [Hysteresis::None, Hysteresis::Paper].into_iter();
        // The largest flock takes long with hysteresis.
        kinds.filter(move |kind| n < 64 || c == 1 || *kind == Hysteresis::None).map(move |kind| (n, c, kind))
    });
    let detail = "settled exactly for n = 4, 8, 12, 16, 20, 32, 64 and several c, with and without hysteresis";
    let mut settled = 0;
    for (n, c, hysteresis) in flocks {
        settled += 1;
        if let Some(what) = variant.fails_at(n, c, &hysteresis, run)? {
            return Ok(Outcome::fails(what, exact("every switch and the end", "settled exactly")));
        }
    }
    let part = "every switch and the end, for all n and c with n^c >= 8";
    Run::all([
        holds(exact("every switch and the end", detail).on([1, 2]).cases(settled))
            .checks("the time of step 1, steps 3 and 4"),
        argued(&[1, 2], part, "notes/settling.md, The lower bound, steps 1-4"),
    ])
}

/// The flocks are paths, from `n^c >= least` on, of at most so many birds.
#[derive(Clone, Copy)]
pub struct PathsVariant {
    least: i64,
    longest: usize,
    patterns: [Group; 2],
}

pub fn single_paths() -> Record<PathsVariant> {
    Record::new(
        "chazelle.lower_paths",
        "Pairs until ceil(n^c/3), then paths of four: the birds of a group stay more than 5/3 - 4.12/n^c > 1 from the \
         next but one, and groups stay at least 4/3 apart (closed form in notes/settling.md). For n = 4, c = 1 the \
         group contracts so much that two more birds join at t = 5: not a path.",
        PathsVariant { least: 8, longest: 4, patterns: [PRINTED; 2] },
        check_single_paths,
    )
    .reading("n^c >= 8: \"n is assumed to be large enough\".")
    .altered("n = 4, c = 1 as well", |v| v.least = 4)
    .altered("pairs for ever", |v| v.longest = 2)
    .altered("every second group mirrored", |v| v.patterns = [MIRRORED, PRINTED])
}

fn check_single_paths(variant: &PathsVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let all = cases(run, variant.least);
    for &(n, c) in &all {
        let list: Vec<Group> = (0..n as usize / 4).map(|k| variant.patterns[k % 2]).collect();
        let start = groups(&list, &rational(1, n.pow(c)), Hysteresis::None);
        let (switches, end): (Vec<Switch>, Settlement) = settled(&start, run)?;
        if !matches!(end.ending, Ending::Steady) {
            return Ok(Outcome::Undecided(end.why));
        }
        for (k, network) in networks(&start, &switches)?.iter().enumerate() {
            let (flocks, most) = (network.components(), variant.longest);
            if let Some(odd) = flocks.iter().find(|f| f.len() > most || !network.induced(f).is_path()) {
                let birds: Vec<usize> = odd.iter().map(|i| i + 1).collect();
                let what =
                    format!("n = {n}, c = {c}: after switch {k} birds {birds:?} are no path of at most {most} birds");
                return Ok(Outcome::fails(what, exact("all flocks at all times", "settled exactly")));
            }
        }
    }
    let detail = "settled exactly for n = 4, 8, 12, 16, 20, 32, 64 and several c";
    Run::all([
        holds(exact("all flocks at all times", detail).cases(all.len())).checks("steps 3 and 4"),
        argued(&[], "all flocks at all times, n^c >= 8", "notes/settling.md, The lower bound, steps 1-4"),
    ])
}
