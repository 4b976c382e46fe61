//! The members of a family: how many there are, and which one has a number.

use super::Question;
use crate::bindings::{Bindings, Value};
use crate::domain::{Domain, Members};
use crate::error::{Problem, QuestionError};
use crate::failure::Failure;
use crate::family::Maker;
use crate::syntax::Kind;
use arithmetic::Progress;
use std::sync::{Arc, OnceLock};

impl Question {
    /// Number of members of the family, a continuum counting as one; those that `where` leaves out are counted, too.
    ///
    /// # Errors
    /// [`QuestionError`] where a family is wrong, empty, or larger than the budget.
    pub fn cases(&self, progress: &dyn Progress) -> Result<u64, QuestionError> {
        let starts = self.starts(progress)?;
        let total = starts.last().copied().unwrap_or(1);
        if total == 0 {
            let empty = self.bounds.first().map_or(0, |bound| bound.base);
            return Err(self.at(empty, Problem::Empty("no member has all the names bound".to_string())));
        }
        if total > self.budget {
            let base = self.bounds.first().map_or(0, |bound| bound.base);
            return Err(self.at(base, Problem::TooMany { size: at_least(total), budget: self.budget }));
        }
        Ok(total)
    }

    /// How many members come before each member of the first name, and in all.
    fn starts(&self, progress: &dyn Progress) -> Result<&[u64], QuestionError> {
        if let Some(known) = self.starts.get() {
            return Ok(known);
        }
        let mut bindings = Bindings::default();
        let mut starts = vec![0];
        match self.bounds.first() {
            None => starts = vec![0, 1],
            Some(first) => {
                let members = self.members(0, &bindings, progress)?;
                let later = self.later_depend_on(0);
                let size = members.len();
                if !later || size == 0 {
                    let each = match members.get(0) {
                        Some(value) => self.counted_with(0, &first.name, value, &mut bindings, progress)?,
                        None => 0,
                    };
                    starts.push(each.saturating_mul(size));
                } else {
                    let mut total = 0u64;
                    for k in 0..size {
                        let Some(value) = members.get(k) else { break };
                        total =
                            total.saturating_add(self.counted_with(0, &first.name, value, &mut bindings, progress)?);
                        starts.push(total);
                        if total > self.budget {
                            break;
                        }
                    }
                }
            }
        }
        Ok(self.starts.get_or_init(|| starts))
    }

    fn counted_with(
        &self,
        place: usize,
        name: &Arc<str>,
        value: Value,
        bindings: &mut Bindings,
        progress: &dyn Progress,
    ) -> Result<u64, QuestionError> {
        bindings.push(name.clone(), value);
        let count = self.counted(place + 1, bindings, progress);
        bindings.pop();
        count
    }

    /// Members of the names from a place on, given the earlier ones; no more than a little above the budget are counted.
    fn counted(&self, place: usize, bindings: &mut Bindings, progress: &dyn Progress) -> Result<u64, QuestionError> {
        let Some(bound) = self.bounds.get(place) else { return Ok(1) };
        let members = self.members(place, bindings, progress)?;
        let size = members.len();
        if place + 1 == self.bounds.len() || size == 0 {
            return Ok(size);
        }
        if !self.later_depend_on(place) {
            let Some(value) = members.get(0) else { return Ok(0) };
            return Ok(self.counted_with(place, &bound.name, value, bindings, progress)?.saturating_mul(size));
        }
        let mut total = 0u64;
        for k in 0..size {
            let Some(value) = members.get(k) else { break };
            total = total.saturating_add(self.counted_with(place, &bound.name, value, bindings, progress)?);
            if total > self.budget {
                break;
            }
        }
        Ok(total)
    }

    pub(crate) fn members(
        &self,
        place: usize,
        bindings: &Bindings,
        progress: &dyn Progress,
    ) -> Result<Arc<Members>, QuestionError> {
        progress.checkpoint()?;
        let bound = &self.bounds[place];
        let cell = self.alone.get(place).filter(|_| is_alone(&bound.domain));
        if let Some(known) = cell.and_then(OnceLock::get) {
            return Ok(known.clone());
        }
        let made = Maker { question: self, bindings, progress }.members(&bound.domain);
        let named = |failure| match failure {
            Failure::Refused(at, problem) if cell.is_none() => self.at(bound.base + at, problem.there(bindings)),
            failure => self.refused(failure, bound.base),
        };
        let made = Arc::new(made.map_err(named)?);
        Ok(cell.map_or(made.clone(), |cell| cell.get_or_init(|| made).clone()))
    }

    /// Whether what a later name ranges over may depend on this one.
    fn later_depend_on(&self, place: usize) -> bool {
        let name = self.bounds[place].name.as_ref();
        self.bounds[place + 1..].iter().any(|bound| mentions(&bound.domain, name))
    }

    /// The member of that number, counted from 0, as [`Question::cases`] counts them.
    ///
    /// # Errors
    /// [`QuestionError`] where a family is wrong.
    pub fn case(&self, number: u64, progress: &dyn Progress) -> Result<Option<Bindings>, QuestionError> {
        let starts = self.starts(progress)?;
        let mut bindings = Bindings::default();
        let Some(first) = self.bounds.first() else { return Ok((number == 0).then_some(bindings)) };
        if starts.last().is_none_or(|total| number >= *total) {
            return Ok(None);
        }
        let members = self.members(0, &bindings, progress)?;
        let (place, within) = if starts.len() as u64 == members.len() + 1 {
            let place = starts.partition_point(|start| *start <= number) - 1;
            (place as u64, number - starts[place])
        } else {
            let each = starts.last().map_or(1, |total| total / members.len().max(1)).max(1);
            (number / each, number % each)
        };
        let Some(value) = members.get(place) else { return Ok(None) };
        bindings.push(first.name.clone(), value);
        self.descend(1, within, bindings, progress)
    }

    fn descend(
        &self,
        place: usize,
        number: u64,
        mut bindings: Bindings,
        progress: &dyn Progress,
    ) -> Result<Option<Bindings>, QuestionError> {
        let Some(bound) = self.bounds.get(place) else { return Ok(Some(bindings)) };
        let members = self.members(place, &bindings, progress)?;
        let mut left = number;
        let independent = place + 1 < self.bounds.len() && !self.later_depend_on(place);
        if place + 1 == self.bounds.len() || independent {
            let each = match members.get(0) {
                Some(value) if independent => self.counted_with(place, &bound.name, value, &mut bindings, progress)?,
                _ => 1,
            };
            let Some(value) = members.get(left / each.max(1)) else { return Ok(None) };
            bindings.push(bound.name.clone(), value);
            return self.descend(place + 1, left % each.max(1), bindings, progress);
        }
        for k in 0..members.len() {
            let Some(value) = members.get(k) else { break };
            let count = self.counted_with(place, &bound.name, value.clone(), &mut bindings, progress)?;
            if left < count {
                bindings.push(bound.name.clone(), value);
                return self.descend(place + 1, left, bindings, progress);
            }
            left -= count;
        }
        Ok(None)
    }
}

/// A count that stopped soon after the budget.
fn at_least(total: u64) -> String {
    if total == u64::MAX { "more than 10^19".to_string() } else { format!("at least {total}") }
}

/// Whether a domain uses no other name.
fn is_alone(domain: &Domain) -> bool {
    match domain {
        Domain::Given(_) => true,
        Domain::List(list) => list.iter().all(|(_, domain)| is_alone(domain)),
        Domain::Written(node) => {
            let mut alone = !domain.is_sample();
            node.visit(&mut |inner| {
                // The family itself has brackets.
                alone &= !matches!(&inner.kind, Kind::Name { called: false, .. });
            });
            alone
        }
    }
}

/// Whether a domain uses a name.
pub(super) fn mentions(domain: &Domain, name: &str) -> bool {
    match domain {
        Domain::Given(_) => false,
        Domain::List(list) => list.iter().any(|(_, domain)| mentions(domain, name)),
        Domain::Written(node) => {
            // Random families use the seed without naming it, but give one member for each.
            let mut found = false;
            node.visit(&mut |node| {
                found |= matches!(&node.kind, Kind::Name { name: used, .. } if used == name);
            });
            found
        }
    }
}
