//! Sums of sines and cosines over everybody: `sin(a + b) = sin a cos b + cos a sin b`, so that where everybody hears everybody, a sum of products of what is the agent's own
//! with sines and cosines of the other's is one of sums over the flock. Sums over one agent's neighbours under several conditions are made one loop.
//!
//! A sum over the flock has the rounding of its largest terms, and an agent's own term is taken from it again. So only sines and cosines are summed up, which are of one size, and
//! only where the sum is added up further: not where it is compared, divided by, or taken a function of, since a difference of two phases that is small, or none, would
//! lose its digits there. Differences as `x[j] - x` stay what they are.

use crate::function::Function;
use crate::program::{FLOCK, Gather, Id, Of, Op, Program, Slot, Things};
use std::collections::{BTreeMap, BTreeSet};

/// How deep an expression is looked into.
const DEPTH: usize = 12;

/// Most products of a sum that is taken apart.
const MOST: usize = 8;

/// A program that computes the same; `complete` says that everybody hears all others.
pub(super) fn separated(program: &Program, complete: bool) -> Program {
    let mut separating = Separating { things: Things::with_slots_of(program), complete };
    let exact = needed_exactly(program);
    let mut found: Vec<Id> = Vec::with_capacity(program.ops.len());
    // What a thing needs has a smaller number.
    for (id, op) in program.ops.iter().enumerate() {
        let id = match op {
            Op::Gathered(number, place) => {
                let this = &program.loops[*number];
                let (gather, body) = this.bodies[*place];
                let several = program.loops.iter().filter(|l| l.slot == this.slot && l.condition.is_some()).count() > 1;
                match (this.condition, gather) {
                    (Some(condition), Gather::Sum | Gather::Count) if several => {
                        Some(separating.chosen(this.slot, found[condition], found[body]))
                    }
                    (None, Gather::Sum | Gather::Mean) if !exact[id] => {
                        separating.apart(this.slot, gather, found[body])
                    }
                    _ => None,
                }
            }
            _ => None,
        };
        let id = id.unwrap_or_else(|| separating.things.again(program, op, |id| found[id], |slot| slot));
        found.push(id);
    }
    separating.things.program(program.outputs.iter().map(|&id| found[id]).collect())
}

/// What is compared, divided by or taken a function of, and all that this needs.
fn needed_exactly(program: &Program) -> Vec<bool> {
    let mut exact = vec![false; program.ops.len()];
    for &id in program.wanted.iter().rev() {
        let op = &program.ops[id];
        let whole = match op {
            Op::Sum(..) | Op::Difference(..) | Op::Product(..) | Op::Negated(_) | Op::Power(..) => exact[id],
            Op::Quotient(a, b) => {
                exact[*a] |= exact[id];
                exact[*b] = true;
                continue;
            }
            Op::Gathered(number, place) => {
                let this = &program.loops[*number];
                let (gather, body) = this.bodies[*place];
                exact[body] |= exact[id] || matches!(gather, Gather::Largest | Gather::Smallest);
                this.condition.into_iter().for_each(|condition| exact[condition] = true);
                continue;
            }
            _ => true,
        };
        op.needs().into_iter().for_each(|need| exact[need] |= whole);
    }
    exact
}

struct Separating {
    things: Things,
    complete: bool,
}

/// What belongs to one side each: what does not depend on an agent variable, and what depends on nothing else.
type Sides = (Option<Id>, Option<Id>);

impl Separating {
    fn is_without(&self, id: Id, slot: Slot) -> bool {
        !self.things.free[id].contains(&slot)
    }

    fn is_of(&self, id: Id, slot: Slot) -> bool {
        self.things.free[id].len() == 1 && self.things.free[id].contains(&slot)
    }

    /// A number as a sum of what does not depend on an agent variable and what depends on it alone.
    fn added(&mut self, id: Id, slot: Slot, depth: usize) -> Option<Sides> {
        if self.is_without(id, slot) {
            return Some((Some(id), None));
        }
        if self.is_of(id, slot) {
            return Some((None, Some(id)));
        }
        let depth = depth.checked_sub(1)?;
        match self.things.ops[id].clone() {
            Op::Negated(a) => {
                let (own, other) = self.added(a, slot, depth)?;
                Some((own.map(|id| self.negated(id)), other.map(|id| self.negated(id))))
            }
            Op::Sum(a, b) => {
                let (a, b) = (self.added(a, slot, depth)?, self.added(b, slot, depth)?);
                Some((self.joined(a.0, b.0), self.joined(a.1, b.1)))
            }
            Op::Difference(a, b) => {
                let (a, b) = (self.added(a, slot, depth)?, self.added(b, slot, depth)?);
                Some((self.less(a.0, b.0), self.less(a.1, b.1)))
            }
            Op::Product(a, b) => {
                let (factor, rest) = if self.things.free[a].is_empty() { (a, b) } else { (b, a) };
                if !self.things.free[factor].is_empty() {
                    return None;
                }
                let (own, other) = self.added(rest, slot, depth)?;
                let mut times = |id: Id| self.things.add(Op::Product(factor, id));
                Some((own.map(&mut times), other.map(&mut times)))
            }
            _ => None,
        }
    }

    fn negated(&mut self, id: Id) -> Id {
        self.things.add(Op::Negated(id))
    }

    fn joined(&mut self, a: Option<Id>, b: Option<Id>) -> Option<Id> {
        match (a, b) {
            (Some(a), Some(b)) => Some(self.things.add(Op::Sum(a, b))),
            (one, other) => one.or(other),
        }
    }

    fn less(&mut self, a: Option<Id>, b: Option<Id>) -> Option<Id> {
        match (a, b) {
            (Some(a), Some(b)) => Some(self.things.add(Op::Difference(a, b))),
            (one, other) => one.or(other.map(|b| self.negated(b))),
        }
    }

    /// A sum over those who fulfil a condition as one over all, with 0 for the others: sums over one agent's neighbours under several conditions are then
    /// one loop.
    fn chosen(&mut self, slot: Slot, condition: Id, body: Id) -> Id {
        let zero = self.things.integer(0);
        let body = self.things.add(Op::Choice(condition, body, zero));
        self.things.gather(slot, None, Gather::Sum, body)
    }

    /// A sum or mean as one over the flock.
    fn apart(&mut self, slot: Slot, gather: Gather, body: Id) -> Option<Id> {
        let variable = &self.things.slots[slot];
        let of_all = match variable.hears {
            Some(Of::Slot(hears)) => self.complete && hears == variable.parent,
            Some(Of::Agent(_)) => false,
            None => variable.parent != FLOCK,
        };
        let products = if of_all { self.products(body, slot, DEPTH)? } else { return None };
        self.over_the_flock(slot, gather, &products)
    }

    /// `sin(a + b)` or `cos(a + b)` as such a sum.
    fn of_a_sum(&mut self, function: Function, angle: Id, slot: Slot, depth: usize) -> Option<Vec<(Id, Id)>> {
        let (Some(a), Some(b)) = self.added(angle, slot, depth)? else { return None };
        if !self.is_plain(b) {
            return None;
        }
        let mut of = |function: Function, id: Id| self.things.add(Op::Function(function, id));
        let [(sine, cosine), (other_sine, other_cosine)] =
            [a, b].map(|id| (of(Function::Sine, id), of(Function::Cosine, id)));
        Some(match function {
            Function::Sine => vec![(sine, other_cosine), (cosine, other_sine)],
            _ => vec![(cosine, other_cosine), (self.negated(sine), other_sine)],
        })
    }

    /// A number as a sum of products of what does not depend on an agent variable and of sines and cosines of that agent.
    fn products(&mut self, id: Id, slot: Slot, depth: usize) -> Option<Vec<(Id, Id)>> {
        let depth = depth.checked_sub(1)?;
        if self.is_summable(id, slot, depth) {
            return Some(vec![(self.things.integer(1), id)]);
        }
        let products = match self.things.ops[id].clone() {
            Op::Function(function @ (Function::Sine | Function::Cosine), angle) => {
                self.of_a_sum(function, angle, slot, depth)?
            }
            Op::Negated(a) => {
                let list = self.products(a, slot, depth)?;
                list.into_iter().map(|(own, other)| (self.negated(own), other)).collect()
            }
            Op::Sum(a, b) => [self.products(a, slot, depth)?, self.products(b, slot, depth)?].concat(),
            Op::Difference(a, b) => {
                let (mut list, taken) = (self.products(a, slot, depth)?, self.products(b, slot, depth)?);
                list.extend(taken.into_iter().map(|(own, other)| (self.negated(own), other)));
                list
            }
            Op::Product(a, b) => match (self.is_without(a, slot), self.is_without(b, slot)) {
                (true, false) if self.is_summable(b, slot, depth) => vec![(a, b)],
                (false, true) if self.is_summable(a, slot, depth) => vec![(b, a)],
                (true, false) => self.multiplied(a, (b, slot), depth)?,
                (false, true) => self.multiplied(b, (a, slot), depth)?,
                (false, false) if self.is_summable(a, slot, depth) => self.weighted(a, (b, slot), depth)?,
                (false, false) if self.is_summable(b, slot, depth) => self.weighted(b, (a, slot), depth)?,
                _ => return None,
            },
            _ => return None,
        };
        (products.len() <= MOST).then_some(products)
    }

    fn multiplied(&mut self, factor: Id, (id, slot): (Id, Slot), depth: usize) -> Option<Vec<(Id, Id)>> {
        let products = self.products(id, slot, depth)?;
        let times = |(own, other)| (self.things.add(Op::Product(factor, own)), other);
        Some(products.into_iter().map(times).collect())
    }

    fn weighted(&mut self, factor: Id, (id, slot): (Id, Slot), depth: usize) -> Option<Vec<(Id, Id)>> {
        let products = self.products(id, slot, depth)?;
        let times = |(own, other)| (own, self.things.add(Op::Product(factor, other)));
        Some(products.into_iter().map(times).collect())
    }

    /// Sines and cosines of an agent, and products of them.
    fn is_summable(&self, id: Id, slot: Slot, depth: usize) -> bool {
        let Some(depth) = depth.checked_sub(1) else { return false };
        match &self.things.ops[id] {
            Op::Function(Function::Sine | Function::Cosine, _) => self.is_of(id, slot) && self.is_plain(id),
            Op::Negated(a) => self.is_summable(*a, slot, depth),
            Op::Product(a, b) => self.is_summable(*a, slot, depth) && self.is_summable(*b, slot, depth),
            _ => false,
        }
    }

    /// Without loops.
    fn is_plain(&self, id: Id) -> bool {
        let (mut seen, mut open) = (BTreeSet::from([id]), vec![id]);
        while let Some(id) = open.pop() {
            if matches!(self.things.ops[id], Op::Gathered(..)) {
                return false;
            }
            open.extend(self.things.ops[id].needs().into_iter().filter(|need| seen.insert(*need)));
        }
        true
    }

    /// The same of another agent; what is not plain is not asked for.
    fn renamed(&mut self, id: Id, from: Slot, to: Slot) -> Id {
        let mut needed = BTreeSet::from([id]);
        let mut open = vec![id];
        while let Some(id) = open.pop() {
            open.extend(self.things.ops[id].needs().into_iter().filter(|need| needed.insert(*need)));
        }
        // What a thing needs has a smaller number.
        let mut new: BTreeMap<Id, Id> = BTreeMap::new();
        for old in needed {
            let op = self.things.ops[old].with(|need| new[&need]).of(|slot| if slot == from { to } else { slot });
            new.insert(old, self.things.add(op));
        }
        new[&id]
    }

    fn over_the_flock(&mut self, slot: Slot, gather: Gather, products: &[(Id, Id)]) -> Option<Id> {
        // A loop inside of this one, though nothing in it depends on the agent, stays inside.
        if products.iter().any(|(own, _)| self.things.slot_of[*own] == slot) {
            return None;
        }
        let variable = self.things.slots[slot].clone();
        let all = self.things.slot(FLOCK, None, &variable.name);
        let one = self.things.integer(1);
        let mut total = None;
        for &(own, other) in products {
            let term = self.renamed(other, slot, all);
            let mut sum = self.things.gather(all, None, Gather::Sum, term);
            if variable.hears.is_some() {
                // Nobody hears itself.
                let itself = self.renamed(other, slot, variable.parent);
                sum = self.things.add(Op::Difference(sum, itself));
            }
            let term = self.things.add(Op::Product(own, sum));
            total = self.joined(total, Some(term));
        }
        let total = total?;
        if gather == Gather::Sum {
            return Some(total);
        }
        let mut count = self.things.gather(all, None, Gather::Count, one);
        if variable.hears.is_some() {
            count = self.things.add(Op::Difference(count, one));
        }
        Some(self.things.add(Op::Quotient(total, count)))
    }
}
