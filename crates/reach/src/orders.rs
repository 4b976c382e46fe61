//! Which orders of modes lead to a time that is looked at, as families.

use crate::family::{Family, Length};
use crate::flow::Link;
use crate::system::{Range, Stay, Switching};
use arithmetic::{Rational, rational};
use num_traits::{Signed, ToPrimitive};

/// Most families; orders of more modes are left to the bounds for arbitrary switching.
const FAMILIES: usize = 4000;

/// Most modes in turn with a duration of their own each.
const LEGS: usize = 8;

/// Which times are looked at.
#[derive(Debug, Clone)]
pub(crate) enum Times {
    /// One time.
    At(Rational),
    /// From 0 to this.
    Until(Rational),
    /// For ever: what was more than so long ago is replaced by bounds of the states at any time.
    Forever { back: Rational, rest: Vec<Range> },
}

/// Families, the products that their legs start from, and how long each mode lasts at most.
#[derive(Debug, Clone, Default)]
pub(crate) struct Orders {
    pub families: Vec<Family>,
    pub chain: Vec<Link>,
    pub longest: Vec<Rational>,
}

/// All orders; none where there are too many, or where any may be.
pub(crate) fn orders(switching: &Switching, modes: usize, start: &[Range], times: &Times) -> Option<Orders> {
    let mut orders = Orders { longest: vec![Rational::ZERO; modes], ..Orders::default() };
    match switching {
        Switching::Arbitrary => return None,
        Switching::Periodic { order, period } => orders.periodic(order, period, start, times)?,
        Switching::Windows { order, windows } => orders.windows(order, windows, start, times),
        Switching::Dwell { first, stays } => orders.dwell(*first, stays, start, times)?,
    }
    orders.measure();
    Some(orders)
}

impl Orders {
    /// How long each mode lasts at most.
    fn measure(&mut self) {
        for family in &self.families {
            for leg in family.legs(&family.variables) {
                let longest = &mut self.longest[leg.mode];
                *longest = longest.clone().max(leg.duration.hi);
            }
        }
    }

    fn push(&mut self, legs: Vec<Length>, variables: Vec<Range>, start: &[Range], attained: bool) {
        self.families.push(Family { legs, variables, most: None, latest: None, start: start.to_vec(), attained });
    }

    fn periodic(&mut self, order: &[usize], period: &Rational, start: &[Range], times: &Times) -> Option<()> {
        let turns = |time: &Rational| (time / period).floor().to_integer().to_usize().filter(|k| *k < FAMILIES);
        let (last, at) = match times {
            Times::At(time) | Times::Until(time) => (turns(time)?, matches!(times, Times::At(_)).then_some(time)),
            Times::Forever { back, .. } => (turns(back)? + order.len() + 1, None),
        };
        let mode = |k: usize| order[k % order.len()];
        // The product over `count` legs that end with the one before turn `k` depends on `k` modulo the length of the order only.
        let mut products: Vec<Vec<usize>> = vec![Vec::new(); order.len()];
        for k in 0..=last {
            let chain = &mut products[(k + order.len() - 1) % order.len()];
            while chain.len() + 1 < k {
                let link =
                    Link { parent: chain.last().copied(), mode: mode(k - 1 - chain.len()), duration: period.clone() };
                chain.push(self.chain.len());
                self.chain.push(link);
            }
            let begun = period * rational(k as i64, 1);
            let mut legs = vec![Length::variable(mode(k), 0)];
            legs.extend((1..=k).map(|i| Length {
                start: i.checked_sub(2).map(|i| chain[i]),
                ..Length::fixed(mode(k - i), period.clone())
            }));
            match (at, times) {
                (Some(time), _) if k == last => {
                    legs[0] = Length::fixed(mode(k), time - &begun);
                    self.push(legs, Vec::new(), start, true);
                }
                (Some(_), _) => {}
                (None, Times::Until(time)) => {
                    let most = (time - &begun).min(period.clone());
                    self.push(legs, vec![Range { lo: Rational::ZERO, hi: most }], start, true);
                }
                (None, _) => {
                    let whole = vec![Range { lo: Rational::ZERO, hi: period.clone() }];
                    self.push(legs.clone(), whole.clone(), start, true);
                    if let Times::Forever { rest, .. } = times
                        && k + order.len() > last
                    {
                        self.push(legs, whole, rest, false);
                    }
                }
            }
        }
        Some(())
    }

    /// The variables are the time and the instants of the switches before it.
    fn windows(&mut self, order: &[usize], windows: &[Range], start: &[Range], times: &Times) {
        for done in 0..=windows.len() {
            let least = done.checked_sub(1).map_or(Rational::ZERO, |i| windows[i].lo.clone());
            let next = windows.get(done).map(|window| window.hi.clone());
            let last = match times {
                Times::At(time) | Times::Until(time) => next.map_or(time.clone(), |next| next.min(time.clone())),
                Times::Forever { back, .. } => {
                    next.unwrap_or_else(|| back + windows.last().map_or(Rational::ZERO, |window| window.hi.clone()))
                }
            };
            let at = if let Times::At(time) = times { Some(time) } else { None };
            if last < least || at.is_some_and(|time| *time > last) {
                continue;
            }
            let mut variables = vec![at.map_or(Range { lo: least, hi: last }, |time| Range::point(time.clone()))];
            variables.extend(windows[..done].iter().cloned());
            let legs = (0..=done).rev().map(|i| {
                let mut terms = vec![(if i == done { 0 } else { i + 1 }, false)];
                if i > 0 {
                    terms.push((i, true));
                }
                Length { mode: order[i], constant: Rational::ZERO, terms, start: None }
            });
            self.push(legs.collect(), variables, start, true);
        }
        if let (Times::Forever { back, rest }, Some(&mode)) = (times, order.last()) {
            self.push(vec![Length::fixed(mode, back.clone())], Vec::new(), rest, false);
        }
        self.settle();
    }

    /// Variables that are numbers become constants, so that they need no derivative.
    fn settle(&mut self) {
        for family in &mut self.families {
            let mut index = vec![None; family.variables.len()];
            for (kept, i) in (0..index.len()).filter(|&i| !family.variables[i].is_point()).enumerate() {
                index[i] = Some(kept);
            }
            for leg in &mut family.legs {
                let mut open = Vec::new();
                for &(i, minus) in &leg.terms {
                    let x = &family.variables[i].lo;
                    match index[i] {
                        Some(i) => open.push((i, minus)),
                        None => leg.constant = if minus { &leg.constant - x } else { &leg.constant + x },
                    }
                }
                leg.terms = open;
            }
            family.variables.retain(|range| !range.is_point());
        }
        self.families
            .retain(|family| family.legs.iter().all(|leg| !leg.terms.is_empty() || !leg.constant.is_negative()));
    }

    /// Legs backwards from the time that is looked at; the first one in time starts at 0.
    fn dwell(&mut self, first: Option<usize>, stays: &[Stay], start: &[Range], times: &Times) -> Option<()> {
        let all = match times {
            Times::At(time) | Times::Until(time) => time,
            Times::Forever { back, .. } => back,
        };
        let mut orders: Vec<Vec<usize>> = (0..stays.len()).map(|mode| vec![mode]).collect();
        while let Some(order) = orders.pop() {
            if self.families.len() > FAMILIES || order.len() > LEGS {
                return None;
            }
            let least: Rational = order[1..].iter().map(|&mode| stays[mode].least.clone()).sum();
            let last = order[order.len() - 1];
            if let Times::Forever { rest, .. } = times {
                if least >= *all {
                    self.stayed(&order, stays, all, rest, times, Some(&stays[last].least));
                    continue;
                }
                // What lasts longer than is looked back.
                if stays[last].most.as_ref().is_none_or(|most| most > all) {
                    self.stayed(&order, stays, all, rest, times, Some(all));
                }
            }
            if least > *all {
                continue;
            }
            if first.is_none_or(|first| first == last) {
                self.stayed(&order, stays, all, start, times, None);
            }
            for mode in (0..stays.len()).filter(|mode| order.last() != Some(mode)) {
                orders.push(order.iter().copied().chain([mode]).collect());
            }
        }
        Some(())
    }

    /// One order whose modes stay as long as they may; the first of them in time is followed back for the given time only, where there is one.
    fn stayed(
        &mut self,
        order: &[usize],
        stays: &[Stay],
        all: &Rational,
        start: &[Range],
        times: &Times,
        cut: Option<&Rational>,
    ) {
        let (mut variables, mut legs) = (Vec::new(), Vec::new());
        for (i, &mode) in order.iter().enumerate() {
            if let Some(cut) = cut.filter(|_| i + 1 == order.len()) {
                legs.push(Length::fixed(mode, cut.clone()));
                continue;
            }
            let lo = if i == 0 { Rational::ZERO } else { stays[mode].least.clone() };
            let hi = stays[mode].most.clone().unwrap_or(all.clone()).min(all.clone()).max(lo.clone());
            legs.push(Length::variable(mode, variables.len()));
            variables.push(Range { lo, hi });
        }
        let mut family =
            Family { legs, variables, most: None, latest: None, start: start.to_vec(), attained: cut.is_none() };
        match times {
            Times::Forever { .. } => {}
            Times::Until(time) => family.most = Some(time.clone()),
            Times::At(time) => {
                // The last leg takes what the others leave.
                let terms = (0..family.variables.len() - 1).map(|i| (i, true)).collect();
                family.variables.remove(0);
                family.legs[1..].iter_mut().for_each(|leg| leg.terms.iter_mut().for_each(|(i, _)| *i -= 1));
                family.legs[0] = Length { mode: order[0], constant: time.clone(), terms, start: None };
                family.latest = stays[order[0]].most.clone();
            }
        }
        self.families.push(family);
        self.settle();
    }
}
