//! Which orders of modes are allowed, as the lines `switching ..` to `until ..` of `motion`, `bound` and `kept` say.
//!
//! `any`; `periodic`: the modes in turn, each for the period; `windows`: the modes in turn, the k-th switch at an instant of the k-th window; `dwell`: any mode after another one, each
//! for a duration within its limits, the last one cut off.

use crate::Refusal;
use crate::read::{Fraction, Reader};
use num_bigint::{BigInt, Sign};

const MOST_TURNS: usize = 1000;

/// A number that is not negative.
#[derive(Clone, PartialEq, Eq)]
pub struct Time {
    pub numerator: BigInt,
    pub denominator: BigInt,
}

/// How long a mode lasts: at least, and at most where there is a limit.
pub struct Stay {
    pub least: Time,
    pub most: Option<Time>,
}

pub enum Rule {
    Any,
    Periodic { turns: Vec<usize>, period: Time },
    Windows { turns: Vec<usize>, windows: Vec<[Time; 2]> },
    Dwell { first: Option<usize>, stays: Vec<Stay> },
}

pub struct Switching {
    pub rule: Rule,
    /// The last time that is looked at; none where it goes on for ever.
    pub until: Option<Time>,
}

impl Time {
    fn zero() -> Self {
        Time { numerator: BigInt::from(0), denominator: BigInt::from(1) }
    }

    pub fn is_at_most(&self, other: &Time) -> bool {
        &self.numerator * &other.denominator <= &other.numerator * &self.denominator
    }

    fn is(&self, other: &Time) -> bool {
        self.is_at_most(other) && other.is_at_most(self)
    }

    /// The sum, or the difference to a time that is not earlier, in lowest terms.
    pub fn plus(&self, reader: &mut Reader, other: &Time, sign: i32) -> Result<Time, Refusal> {
        let bits = self.denominator.bits() + other.denominator.bits();
        let bits = bits.max(self.numerator.bits() + other.numerator.bits());
        reader.pay(bits as usize + 8, bits, 64)?;
        let numerator = &self.numerator * &other.denominator + &other.numerator * &self.denominator * sign;
        let denominator = &self.denominator * &other.denominator;
        let (mut a, mut b) = (numerator.clone(), denominator.clone());
        while b.sign() != Sign::NoSign {
            let rest = a % &b;
            a = std::mem::replace(&mut b, rest);
        }
        Ok(Time { numerator: numerator / &a, denominator: denominator / a })
    }

    /// How often another time, which is not 0, goes into it.
    fn over(&self, other: &Time) -> BigInt {
        (&self.numerator * &other.denominator) / (&self.denominator * &other.numerator)
    }
}

impl Switching {
    /// The lines, where they stand.
    pub fn read(reader: &mut Reader, modes: usize) -> Result<Option<Self>, Refusal> {
        let Some(kind) = reader.value_if_any("switching") else { return Ok(None) };
        let rule = match kind {
            "any" => Rule::Any,
            "periodic" => {
                let turns = turns(reader, modes)?;
                let word = reader.value("period")?;
                let period = time(reader, word)?;
                reader.require(period.numerator.sign() == Sign::Plus, "the period is not positive")?;
                Rule::Periodic { turns, period }
            }
            "windows" => {
                let turns = turns(reader, modes)?;
                let mut windows: Vec<[Time; 2]> = Vec::new();
                for _ in 1..turns.len() {
                    let value = reader.value("window")?;
                    let [lo, hi] = pair(reader, value)?;
                    let (lo, hi) = (time(reader, lo)?, time(reader, hi)?);
                    let ordered = lo.is_at_most(&hi) && windows.last().is_none_or(|[_, before]| before.is_at_most(&lo));
                    reader.require(ordered, "the windows do not follow each other")?;
                    windows.push([lo, hi]);
                }
                Rule::Windows { turns, windows }
            }
            "dwell" => {
                let first = match reader.value("first")? {
                    "any" => None,
                    word => Some(reader.count_of(word, 1, modes)? - 1),
                };
                let mut stays = Vec::new();
                for _ in 0..modes {
                    let value = reader.value("stay")?;
                    let [least, most] = pair(reader, value)?;
                    let least = time(reader, least)?;
                    let most = if most == "none" { None } else { Some(time(reader, most)?) };
                    let positive = |most: &Time| most.numerator.sign() == Sign::Plus && least.is_at_most(most);
                    reader.require(most.as_ref().is_none_or(positive), "a mode stays for no time")?;
                    stays.push(Stay { least, most });
                }
                Rule::Dwell { first, stays }
            }
            _ => return Err(reader.refusal("`switching any`, `periodic`, `windows` or `dwell` is expected")),
        };
        let until = match reader.value("until")? {
            "ever" => None,
            word => Some(time(reader, word)?),
        };
        Ok(Some(Switching { rule, until }))
    }

    /// Refuses unless modes that follow each other so from time 0 are allowed, the last one cut off; the time at which they end.
    pub fn follow(&self, reader: &mut Reader, order: &[(usize, Time)]) -> Result<Time, Refusal> {
        let end = match &self.rule {
            Rule::Any => total(reader, order)?,
            Rule::Periodic { turns, period } => periodic(reader, turns, period, order)?,
            Rule::Windows { turns, windows } => within(reader, turns, windows, order)?,
            Rule::Dwell { first, stays } => dwell(reader, *first, stays, order)?,
        };
        let early = self.until.as_ref().is_none_or(|until| end.is_at_most(until));
        reader.require(early, "the modes last longer than what is looked at")?;
        Ok(end)
    }

    /// Refuses unless this order of modes, the last `cycle` of which follow each other for ever where there is one, is all that is allowed.
    pub fn is_fixed_as(
        &self,
        reader: &mut Reader,
        order: &[(usize, Time)],
        cycle: Option<usize>,
    ) -> Result<(), Refusal> {
        let end = self.follow(reader, order)?;
        let turn = match &self.rule {
            Rule::Periodic { turns, period } => {
                let count = BigInt::from(turns.len());
                Some(Time { numerator: &period.numerator * count, denominator: period.denominator.clone() })
            }
            Rule::Windows { turns, windows } if windows.iter().all(|[lo, hi]| lo.is(hi)) => {
                (turns.len() == 1).then(Time::zero)
            }
            _ => return Err(reader.refusal("the switching allows other orders of modes")),
        };
        match (&self.until, cycle) {
            (Some(until), None) => reader.require(until.is(&end), "the modes do not last as long as what is looked at"),
            (None, Some(cycle)) => {
                let length = total(reader, &order[order.len() - cycle..])?;
                let whole = |turn: &Time| {
                    turn.numerator.sign() == Sign::NoSign
                        || (&length.numerator * &turn.denominator) % (&length.denominator * &turn.numerator)
                            == BigInt::from(0)
                };
                reader.require(turn.as_ref().is_some_and(whole), "the cycle is not that of the switching")
            }
            _ => Err(reader.refusal("`for ever` stands where `until ever` does")),
        }
    }
}

fn pair<'a>(reader: &Reader<'a>, value: &'a str) -> Result<[&'a str; 2], Refusal> {
    match value.split_once(' ') {
        Some((first, second)) => Ok([first, second]),
        None => Err(reader.refusal("two numbers are expected")),
    }
}

fn time(reader: &Reader, word: &str) -> Result<Time, Refusal> {
    let Fraction { numerator, denominator, .. } = reader.fraction_of(word)?;
    reader.require(numerator.sign() != Sign::Minus, "a time is negative")?;
    Ok(Time { numerator, denominator })
}

fn turns(reader: &mut Reader, modes: usize) -> Result<Vec<usize>, Refusal> {
    let words: Vec<&str> = reader.value("turns")?.split(' ').collect();
    reader.require(words.len() <= MOST_TURNS, "there are too many turns")?;
    words.into_iter().map(|word| Ok(reader.count_of(word, 1, modes)? - 1)).collect()
}

fn total(reader: &mut Reader, order: &[(usize, Time)]) -> Result<Time, Refusal> {
    order.iter().try_fold(Time::zero(), |sum, (_, time)| sum.plus(reader, time, 1))
}

const WRONG: &str = "the switching does not allow this order of modes";

fn periodic(reader: &mut Reader, turns: &[usize], period: &Time, order: &[(usize, Time)]) -> Result<Time, Refusal> {
    let mut now = Time::zero();
    for (mode, time) in order {
        let end = now.plus(reader, time, 1)?;
        while !end.is_at_most(&now) {
            reader.pay(64, now.numerator.bits() + period.denominator.bits(), period.numerator.bits())?;
            let turn = now.over(period);
            let at = usize::try_from(&turn % BigInt::from(turns.len())).unwrap_or_default();
            reader.require(turns[at] == *mode, WRONG)?;
            let next = Time { numerator: &period.numerator * (turn + 1), denominator: period.denominator.clone() };
            now = if end.is_at_most(&next) { end.clone() } else { next };
        }
    }
    Ok(now)
}

/// The switch to the next turn is as late as it can be.
fn within(
    reader: &mut Reader,
    turns: &[usize],
    windows: &[[Time; 2]],
    order: &[(usize, Time)],
) -> Result<Time, Refusal> {
    let (mut now, mut turn) = (Time::zero(), 0);
    for (mode, time) in order {
        let end = now.plus(reader, time, 1)?;
        reader.pay(8 * turns.len(), end.numerator.bits() + end.denominator.bits(), end.denominator.bits())?;
        while turns[turn] != *mode || windows.get(turn).is_some_and(|[_, hi]| !end.is_at_most(hi)) {
            let Some([lo, hi]) = windows.get(turn) else { return Err(reader.refusal(WRONG)) };
            // Now, or, where the next mode is the same, at the end of the window.
            let at_once = lo.is_at_most(&now) && now.is_at_most(hi);
            let stays = turns[turn] == *mode && turns[turn + 1] == *mode && now.is_at_most(hi);
            reader.require(at_once || stays, WRONG)?;
            turn += 1;
        }
        now = end;
    }
    Ok(now)
}

fn dwell(reader: &mut Reader, first: Option<usize>, stays: &[Stay], order: &[(usize, Time)]) -> Result<Time, Refusal> {
    let mut merged: Vec<(usize, Time)> = Vec::new();
    for (mode, time) in order {
        match merged.last_mut() {
            Some((known, sum)) if known == mode => *sum = sum.plus(reader, time, 1)?,
            _ => merged.push((*mode, time.clone())),
        }
    }
    let begun = merged.first().is_none_or(|(mode, _)| first.is_none_or(|first| first == *mode));
    reader.require(begun, WRONG)?;
    for (k, (mode, time)) in merged.iter().enumerate() {
        reader.pay(8, time.numerator.bits() + time.denominator.bits(), time.denominator.bits())?;
        let Stay { least, most } = &stays[*mode];
        let long = k + 1 == merged.len() || least.is_at_most(time);
        reader.require(long && most.as_ref().is_none_or(|most| time.is_at_most(most)), WRONG)?;
    }
    total(reader, &merged)
}
