//! beyond.chazelle.tower: sixteen birds whose network changes at times that are levels of exponentials apart.

use crate::chazelle::lower_bound::{Group, MIRRORED, PRINTED, groups};
use crate::chazelle::sequences::settled;
use crate::prelude::*;
use arithmetic::{Signed, decimals};
use models::averaging::settle::Ending;
use models::averaging::{Hysteresis, Switch};
use num_bigint::BigInt;

/// A group whose drift after its merger is that of the mirrored one, but not the rest of its motion.
const TWISTED: Group = [-1, 9, -1, -7];
/// Its mirror image.
const TWISTED_MIRRORED: Group = [7, 1, -9, 1];

/// The groups, and bounds of the binary logarithm of the time of the third switch, in units of 10^84.
#[derive(Clone, Copy)]
pub struct TowerVariant {
    groups: [Group; 4],
    log2: ((i64, i64), (i64, i64)),
}

pub fn tower() -> Record<TowerVariant> {
    Record::new(
        "beyond.chazelle.tower",
        "Four groups of four merge at t = 171 and drift at speeds of about 10^-84; neighbours meet after 10^84 steps. \
         The drifts of the two that form a flock of eight cancel exactly, and what is left of their inner motion \
         gives the eight a drift of about 3^-s, s the second time: its sign and size are those of the leading term of \
         a linear recurrence in s, the coefficient of (2/3)^s being zero. Two mirrored flocks of eight approach at \
         that speed. Exact jumps for two switches, enclosed logarithms for the third (notes/settling.md).",
        TowerVariant { groups: [MIRRORED, TWISTED_MIRRORED, TWISTED, PRINTED], log2: ((2116, 1000), (2117, 1000)) },
        check_tower,
    )
    .stated("what the initial conditions at the end of Section 1 can be changed into", "")
    .clauses(&[
        "Sixteen birds on the line in model D with the lazy weights c_i = 2/(3 d_i), x(0) = (0, 2/3, 2, 8/3, ..., 14, 44/3) and v(1) = (0, \
         8, 0, -8, 7, 1, -9, 1, -1, 9, -1, -7, 8, 0, -8, 0)/4096: the network changes first at t = 171, with the hysteresis of the paper or \
         without.",
        "The second change is at a time of 85 digits, with the hysteresis of the paper or without.",
        "The third change is at a time between 2^(2.116 10^84) and 2^(2.117 10^84), with the hysteresis of the paper or \
         without.",
    ])
    .altered("mirrored groups, whose drifts cancel altogether", |v| v.groups = [MIRRORED, PRINTED, MIRRORED, PRINTED])
    .altered("the leading term (2/3)^s", |v| v.log2 = ((781, 1000), (782, 1000)))
    .altered("the flocks of eight exchanged", |v| v.groups = [TWISTED, PRINTED, MIRRORED, TWISTED_MIRRORED])
}

fn check_tower(variant: &TowerVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    for hysteresis in [Hysteresis::None, Hysteresis::Paper] {
        let (switches, end) = settled(&groups(&variant.groups, &rational(1, 512), hysteresis), run)?;
        let fails = |what: String| Ok(Outcome::fails(what, certified("the switches", "settled exactly")));
        let times: Vec<String> = switches.iter().map(|s: &Switch| s.time.to_string()).collect();
        let Ending::Beyond { log2_steps, .. } = &end.ending else {
            return fails(format!("switches at t = {}, then: {}", times.join(", "), end.why));
        };
        let unit = BigInt::from(10).pow(81);
        let bound = |(p, q): (i64, i64)| -> Interval {
            log2_steps.integer(p)
                * arithmetic::Field::rational(log2_steps, &(arithmetic::Rational::from_integer(&unit * 1000 / q)))
        };
        let (low, high) = (bound(variant.log2.0), bound(variant.log2.1));
        let inside = (log2_steps.clone() - low).is_certainly_positive() && (high - log2_steps).is_certainly_positive();
        let (lo, hi) = decimals(log2_steps, 12);
        if times.len() != 2 || times[0] != "171" || times[1].len() != 85 || !inside {
            return fails(format!("switches at t = {}, the next at 2^L, L in [{lo}, {hi}]", times.join(", ")));
        }
        run.value("second_switch", times[1].clone());
        run.value("log2_of_the_third", format!("[{lo}, {hi}]"));
    }
    let second = "the quadratic polynomial of the limit motion on the fixed network, exactly, before and at the contact; \
                  the transients that are left out are bounded far below its value (notes/settling.md, How flock settle \
                  decides, 4 and 5)";
    let third = "the relative drift as the leading term of its shortest recurrence, sign and logarithm enclosed \
                 (notes/settling.md, the same)";
    Ok(Outcome::Holds(vec![
        exact("the first switch", "every step up to it taken by the rule").on([1]).for_all(),
        certified("the second switch", second).on([2]).for_all(),
        certified("the third", third).on([3]).for_all(),
    ]))
}
