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

/// The groups, the speed whose eighth is the unit of their velocities, and bounds of the binary logarithm of the time of the third switch, in
/// units of 10^84.
#[derive(Clone, Copy)]
pub struct TowerVariant {
    groups: [Group; 4],
    speed: (i64, i64),
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
        TowerVariant {
            groups: [MIRRORED, TWISTED_MIRRORED, TWISTED, PRINTED],
            speed: (1, 512),
            log2: ((2116, 1000), (2117, 1000)),
        },
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
    .altered("one and a half times the speed", |v| v.speed = (3, 1024))
    .altered("the leading term (2/3)^s", |v| v.log2 = ((781, 1000), (782, 1000)))
    .altered("the flocks of eight exchanged", |v| v.groups = [TWISTED, PRINTED, MIRRORED, TWISTED_MIRRORED])
}

fn check_tower(variant: &TowerVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let (mut first, mut second, mut third) = (None, None, None);
    for hysteresis in [Hysteresis::None, Hysteresis::Paper] {
        let speed = rational(variant.speed.0, variant.speed.1);
        let (switches, end) = settled(&groups(&variant.groups, &speed, hysteresis), run)?;
        let times: Vec<String> = switches.iter().map(|s: &Switch| s.time.to_string()).collect();
        let found = format!("switches at t = {}, then: {}", times.join(", "), end.why);
        if times.first().is_none_or(|time| time != "171") {
            first.get_or_insert(found.clone());
        }
        match times.get(1).filter(|time| time.len() == 85) {
            Some(time) => run.value("second_switch", time.clone()),
            None => drop(second.get_or_insert(found.clone())),
        }
        match &end.ending {
            Ending::Beyond { log2_steps, .. } if times.len() == 2 => {
                let (lo, hi) = decimals(log2_steps, 12);
                run.value("log2_of_the_third", format!("[{lo}, {hi}]"));
                if !variant.contains(log2_steps) {
                    third.get_or_insert(format!("{found}; the next at 2^L, L in [{lo}, {hi}]"));
                }
            }
            _ => drop(third.get_or_insert(found)),
        }
    }
    let quadratic = "the quadratic polynomial of the limit motion on the fixed network, exactly, before and at the contact; \
                     the transients that are left out are bounded far below its value (notes/settling.md, How flock settle \
                     decides, 4 and 5)";
    let drift = "the relative drift as the leading term of its shortest recurrence, sign and logarithm enclosed \
                 (notes/settling.md, the same)";
    Run::all([
        unless(first, exact("the first switch", "every step up to it taken by the rule").on([1])).for_all(),
        unless(second, certified("the second switch", quadratic).on([2])).for_all(),
        unless(third, certified("the third", drift).on([3])).for_all(),
    ])
}

impl TowerVariant {
    /// Whether the logarithm lies between the bounds.
    fn contains(&self, log2: &Interval) -> bool {
        let unit = BigInt::from(10).pow(81);
        let bound = |(p, q): (i64, i64)| log2.integer(p) * log2.rational(&Rational::from_integer(&unit * 1000 / q));
        (log2.clone() - bound(self.log2.0)).is_certainly_positive()
            && (bound(self.log2.1) - log2).is_certainly_positive()
    }
}
