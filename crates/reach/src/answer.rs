//! Answers as a document and as a text.

use crate::decide::{Decided, Part, Verdict};
use crate::system::{Condition, Range, Side, System};
use crate::witness::Witness;
use arithmetic::{Rational, decimal, rational};
use models::platoon::SIGNS;
use num_traits::Signed;
use serde_json::{Value, json};

/// Digits beyond those asked for, so that the ends of an enclosure differ where they do.
const MORE: u32 = 3;

/// An interval rounded outwards.
fn ends(lo: Option<&Rational>, hi: Option<&Rational>, digits: u32) -> Value {
    json!({
        "lo": lo.map(|x| decimal(x, digits + MORE, false)),
        "hi": hi.map(|x| decimal(x, digits + MORE, true)),
    })
}

fn times(range: &Range, digits: u32) -> Value {
    ends(Some(&range.lo), Some(&range.hi), digits)
}

/// The checks as `flockproof.reach/1` has them.
pub fn json(system: &System, decided: &[Decided], digits: u32) -> Value {
    let check = |found: &Decided| {
        let mut value = part(system, found.decisive(), digits);
        value["holds"] = json!(found.check.text);
        value["verdict"] = json!(found.verdict.word());
        if found.parts.len() > 1 {
            value["parts"] = found.parts.iter().map(|found| part(system, found, digits)).collect();
        }
        value
    };
    json!({ "checks": decided.iter().map(check).collect::<Vec<Value>>() })
}

fn part(system: &System, part: &Part, digits: u32) -> Value {
    json!({
        "holds": sentence(system, part),
        "verdict": part.verdict.word(),
        "grades": if part.verdict == Verdict::Undecided { vec![] } else { vec!["certified"] },
        "worst": ends(part.lo.as_ref(), part.hi.as_ref(), digits),
        "margin": part.margin().map(|margin| times(&margin, digits)),
        "at": part.at.as_ref().map(|at| times(at, digits)),
        "witness": part.witness.as_ref().map(|found| witness(system, found, digits)),
        "why": part.why,
    })
}

fn witness(system: &System, found: &Witness, digits: u32) -> Value {
    let inputs = system.inputs.iter().zip(&found.inputs).map(|(input, values)| {
        let values: Vec<Value> =
            values.iter().map(|(from, value)| json!({"from": from.to_string(), "value": value.to_string()})).collect();
        json!({ "name": input.name, "values": values })
    });
    let modes =
        found.modes.iter().map(|(from, mode)| json!({"from": from.to_string(), "mode": system.modes[*mode].name}));
    let start = system.states.iter().zip(&found.start).map(|(name, x)| (name.clone(), json!(x.to_string())));
    json!({
        "at": found.at.to_string(),
        "start": start.collect::<serde_json::Map<String, Value>>(),
        "modes": modes.collect::<Vec<Value>>(),
        "inputs": inputs.collect::<Vec<Value>>(),
        "value": times(&found.value, digits + MORE),
    })
}

/// A condition in its normal form.
fn sentence(system: &System, part: &Part) -> String {
    let condition = &part.condition;
    let relation = match (condition.side, condition.strict) {
        (Side::AtLeast, false) => ">=",
        (Side::AtLeast, true) => ">",
        (Side::AtMost, false) => "<=",
        (Side::AtMost, true) => "<",
    };
    format!("{} {relation} {}", left_side(system, condition), condition.bound)
}

/// The left side of a condition: the states, then a number.
pub fn left_side(system: &System, condition: &Condition) -> String {
    let mut text = String::new();
    for (name, factor) in system.states.iter().zip(&condition.row).filter(|(_, x)| **x != Rational::ZERO) {
        let (minus, size) = if *factor < Rational::ZERO { (true, -factor) } else { (false, factor.clone()) };
        let sign = match (text.is_empty(), minus) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        };
        let size = if size == Rational::ONE { String::new() } else { format!("{size}*") };
        text += &format!("{sign}{size}{name}");
    }
    if condition.constant != Rational::ZERO {
        text += &format!(" + {}", condition.constant);
    }
    text
}

/// One enclosure for people: the digits that both ends have in common, a fraction that is known exactly, or both ends.
fn shown(lo: Option<&Rational>, hi: Option<&Rational>, digits: u32) -> String {
    let (low, high) = (lo.map(|x| decimal(x, digits + MORE, false)), hi.map(|x| decimal(x, digits + MORE, true)));
    match (low, high) {
        (Some(low), Some(high)) if low == high => low,
        (Some(low), Some(_)) if lo == hi && lo.is_some_and(|x| x.to_string().len() <= low.len()) => {
            lo.map(ToString::to_string).unwrap_or(low)
        }
        (Some(low), Some(high)) => format!("[{low}, {high}]"),
        (low, high) => format!("[{}, {}]", low.as_deref().unwrap_or("-inf"), high.as_deref().unwrap_or("inf")),
    }
}

/// A line for each gain of a platoon that does not pull, with the convention; empty where both do.
fn pushing(system: &System) -> String {
    let Some(platoon) = &system.platoon else { return String::new() };
    let gains = [("f", &platoon.gains.f), ("g", &platoon.gains.g)].into_iter().filter(|(_, gain)| !gain.is_negative());
    let line = |(name, gain): (&str, &Rational)| format!("{name} = {gain} is not below 0: {SIGNS}\n");
    gains.map(line).collect()
}

/// The answers for people.
pub fn text(system: &System, decided: &[Decided], digits: u32) -> String {
    let mut text = String::new();
    for found in decided {
        text += &format!("{}: {}\n", found.check.text, found.verdict.word());
        for part in &found.parts {
            if found.parts.len() > 1 {
                text += &format!("  {}: {}\n", sentence(system, part), part.verdict.word());
            }
            let what = if part.condition.side == Side::AtLeast { "least" } else { "greatest" };
            text += &format!("  {what} value {}", shown(part.lo.as_ref(), part.hi.as_ref(), digits));
            if let Some(at) = &part.at {
                text += &format!(" at t = {}", shown(Some(&at.lo), Some(&at.hi), digits));
            }
            text += if part.is_unattained { ", which no motion attains" } else { "" };
            text += &apart(part).map_or("\n".to_string(), |apart| format!("; the ends are {apart} apart\n"));
            if let Some(witness) = &part.witness {
                text += &motion(system, witness, digits).map_or(String::new(), |motion| format!("  {motion}\n"));
            }
            if found.verdict == Verdict::Undecided || part.lo.is_none() || part.hi.is_none() {
                text += &format!("  {}\n", part.why);
            }
        }
    }
    text + &pushing(system)
}

/// The distance between bound and attained value, where they have few digits in common.
fn apart(part: &Part) -> Option<String> {
    let (lo, hi) = (part.lo.as_ref()?, part.hi.as_ref()?);
    let width = hi - lo;
    (&width * rational(1000, 1) > hi.abs().max(Rational::ONE)).then(|| decimal(&width, 3, true))
}

/// Most modes, or values of an input, in a text; a document has them all.
const MOST_SHOWN: usize = 12;

/// The first of them, and how many more there are.
fn listed<T>(all: &[T], one: impl Fn(&T) -> String) -> String {
    let mut shown: Vec<String> = all.iter().take(MOST_SHOWN).map(one).collect();
    if all.len() > MOST_SHOWN {
        shown.push(format!("and {} more", all.len() - MOST_SHOWN));
    }
    shown.join(", ")
}

/// The witness in one line; none where there is one motion only, of which nothing can be chosen.
fn motion(system: &System, witness: &Witness, digits: u32) -> Option<String> {
    let digits = digits.min(9);
    let number = |x: &Rational| decimal(x, digits, false);
    let mut parts = Vec::new();
    if system.modes.len() > 1 {
        let mode = |(from, mode): &(Rational, usize)| format!("{} from {}", system.modes[*mode].name, number(from));
        parts.push(listed(&witness.modes, mode));
    }
    for (input, all) in system.inputs.iter().zip(&witness.inputs) {
        let value = |(from, value): &(Rational, Rational)| format!("{} from {}", number(value), number(from));
        parts.push(format!("{} = {}", input.name, listed(all, value)));
    }
    let free = system.states.iter().zip(&system.start).zip(&witness.start).filter(|((_, range), _)| !range.is_point());
    parts.extend(free.map(|((name, _), x)| format!("{name}(0) = {}", number(x))));
    (!parts.is_empty()).then(|| format!("near it at t = {}: {}", number(&witness.at), parts.join("; ")))
}
