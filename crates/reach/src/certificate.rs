//! The worst motion that was found, as a certificate of kind `motion` for the separate checker: it follows the motion itself.

use crate::decide::Part;
use crate::system::{Range, Side, System};
use arithmetic::{Rational, common_denominator, decimal, parse_rational, rational};
use num_traits::Zero;

/// Digits of the bound beyond which the motion comes.
const DIGITS: u32 = 12;

/// The certificate that the witness of a condition comes beyond its value rounded against it; none where there is no witness.
pub fn certificate(system: &System, part: &Part) -> Option<String> {
    let witness = part.witness.as_ref().filter(|witness| !witness.at.is_zero() && system.is_written_out())?;
    let condition = &part.condition;
    let turned = condition.side == Side::AtLeast;
    // Row and value as a greatest value, without the constant.
    let row: Vec<Rational> = condition.row.iter().map(|x| if turned { -x } else { x.clone() }).collect();
    let value = if turned { &condition.constant - &witness.value.hi } else { &witness.value.lo - &condition.constant };
    let unit = rational(1, 1_000_000_000_000);
    let bound = parse_rational(&decimal(&(value - unit), DIGITS, false)).ok()?;
    let (n, inputs, modes) = (system.states.len(), system.inputs.len(), system.modes.len());
    let mut text = format!(
        "flockproof-certificate 1 motion\nclaim a motion of the system of {modes} linear modes and {n} states below, from its start, with its inputs within their \
         bounds and its modes for the times below, ends with row x > {bound}\nstates {n}\ninputs {inputs}\nmodes {modes}\n"
    );
    ends(&mut text, ["start_least", "start_most"], &system.start);
    if inputs > 0 {
        ends(
            &mut text,
            ["input_least", "input_most"],
            &system.inputs.iter().map(|input| input.range.clone()).collect::<Vec<_>>(),
        );
        let kept = system.inputs.iter().map(|input| rational(i64::from(input.constant), 1)).collect();
        matrix(&mut text, "constant", &[kept]);
    }
    for mode in &system.modes {
        matrix(&mut text, "A", &mode.a);
        if inputs > 0 {
            matrix(&mut text, "B", &mode.b);
        }
        matrix(&mut text, "c", std::slice::from_ref(&mode.c));
    }
    matrix(&mut text, "row", &[row]);
    text += &format!("bound {bound}\n");
    matrix(&mut text, "start", std::slice::from_ref(&witness.start));
    let stretches = witness.stretches();
    text += &format!("stretches {}\n", stretches.len());
    for (mode, time, values) in stretches {
        text += &format!("mode {}\ntime {time}\n", mode + 1);
        if inputs > 0 {
            matrix(&mut text, "u", &[values]);
        }
    }
    text += "end\n";
    Some(text)
}

fn ends(text: &mut String, names: [&str; 2], ranges: &[Range]) {
    matrix(text, names[0], &[ranges.iter().map(|range| range.lo.clone()).collect()]);
    matrix(text, names[1], &[ranges.iter().map(|range| range.hi.clone()).collect()]);
}

/// A matrix over its least common denominator, a line for each row.
fn matrix(text: &mut String, name: &str, rows: &[Vec<Rational>]) {
    let denominator = common_denominator(rows.iter().flatten());
    *text += &format!("{name} over {denominator}\n");
    let scale = Rational::from_integer(denominator);
    for row in rows {
        let entries: Vec<String> = row.iter().map(|x| (x * &scale).to_string()).collect();
        *text += &format!("{}\n", entries.join(" "));
    }
}
