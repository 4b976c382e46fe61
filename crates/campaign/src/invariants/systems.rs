//! Worst cases of switched systems against random motions.

use super::{Checked, Invariant, OrFails, Tested, require};
use crate::draws::Draws;
use arithmetic::{Enclosure, Rational, Unwatched, rational};
use reach::{Range, Switching, System, Witness, decide};

pub(super) const TABLE: &[Invariant] = &[Invariant {
    id: "reach.motions",
    statement: "No motion of a switched system is worse than its worst case, computed forwards in time, and the motion that is given as the worst one is.",
    control: "the worst case is made smaller by a millionth",
    block: 5,
    check: motions,
}];

/// Quarters of a small integer; 0 is the simplest.
fn quarter(draws: &mut Draws) -> Rational {
    let size = draws.below(9) as i64;
    rational(if draws.once_in(2) { -size } else { size }, 4)
}

/// A system of one to three states with two modes in turn.
fn text(draws: &mut Draws) -> String {
    let n = draws.between(1, 3);
    let list = |items: Vec<String>| format!("[{}]", items.join(", "));
    let row = |draws: &mut Draws, count: usize| list((0..count).map(|_| format!("\"{}\"", quarter(draws))).collect());
    let states = list((0..n).map(|i| format!("\"x{i}\"")).collect());
    let start: Vec<String> = (0..n).map(|i| format!("x{i} = {}", draws.below(3))).collect();
    let mut text = format!(
        "[system]\nstates = {states}\ninputs = {{ u = [-1, {}] }}\nstart = {{ {} }}\n",
        draws.below(3),
        start.join(", ")
    );
    for mode in 0..2 {
        let a = list((0..n).map(|_| row(draws, n)).collect());
        let b = list((0..n).map(|_| row(draws, 1)).collect());
        text += &format!("[[mode]]\nname = \"m{mode}\"\nA = {a}\nB = {b}\n");
    }
    let period = rational(1 + draws.below(4) as i64, 2);
    text + &format!(
        "[switching]\nkind = \"periodic\"\norder = [\"m0\", \"m1\"]\nperiod = \"{period}\"\n[run]\nuntil = 2\n[[check]]\nholds = \"x0 <= 0\"\n"
    )
}

/// A motion up to a time: an input that is constant on sixteen parts of it.
fn drawn(draws: &mut Draws, system: &System, at: Rational) -> Option<Witness> {
    let Switching::Periodic { order, period } = &system.switching else { return None };
    let range = &system.inputs[0].range;
    let values = (0..16).map(|k| {
        let value = if draws.once_in(2) { range.hi.clone() } else { range.lo.clone() };
        (&at * rational(k, 16), value)
    });
    let inputs = vec![values.collect()];
    let modes = (0..5).map(|k| (period * rational(k, 1), order[k as usize % order.len()])).collect();
    let start = system.start.iter().map(|range| range.lo.clone()).collect();
    Some(Witness { at, start, modes, inputs, value: Range::point(Rational::ZERO) })
}

fn motions(draws: &mut Draws, tested: Tested) -> Checked {
    let text = text(draws);
    let system = System::read(&text).or_fails("the system is refused")?;
    let decided = decide(&system, 9, &Unwatched).or_fails("there is no answer")?;
    let part = &decided[0].parts[0];
    let (mut hi, witness) = (part.hi.clone().or_fails("no bound")?, part.witness.clone().or_fails("no witness")?);
    let size = rational(1, 1_000_000) * (Rational::ONE + if hi < Rational::ZERO { -hi.clone() } else { hi.clone() });
    if tested.is_altered() {
        hi -= &size;
    }
    let at = rational(1 + draws.below(16) as i64, 8);
    let random = drawn(draws, &system, at).or_fails("no motion")?;
    for motion in [&random, &witness] {
        let value = motion.value_of(&system, &part.condition.row, 200).ends().or_fails("no value")?.0;
        require(value <= hi, format!("{motion:?} reaches {value}, above {hi}"), || text.clone())?;
    }
    let reached = witness.value_of(&system, &part.condition.row, 200).ends().or_fails("no value")?.1;
    require(&hi - &reached <= size, format!("the worst motion reaches {reached} only, below {hi}"), || text.clone())?;
    Ok(None)
}
