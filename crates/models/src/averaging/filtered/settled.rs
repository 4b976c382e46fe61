//! Flocks that have settled for ever are left behind: from then on they are not stepped any more.
//!
//! `notes/exact_flocks.md`, step 16.

use super::balls::Balls;
use super::classes::Classes;
use super::outlook::outlook;
use super::watch::groups_for_ever;
use super::{FilteredFlock, State};
use crate::averaging::weights::FlockError;
use arithmetic::Progress;

/// What is known of the birds that were left behind.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Left {
    /// Pairs with a certain relative drift of which one or both were left behind.
    pub drifting: usize,
    /// Up to this time all of them were followed.
    pub until: u64,
}

impl FilteredFlock {
    /// Leaves behind groups of flocks that never meet anyone else, whatever happens there, and whose own networks stay for ever, as far as
    /// following them for so many steps shows it.
    ///
    /// # Errors
    /// [`FlockError::Cancelled`].
    pub(in crate::averaging) fn leave_settled(
        &mut self,
        steps: u64,
        progress: &dyn Progress,
    ) -> Result<(), FlockError> {
        // Known ties are of all birds together.
        let State::Balls(balls) = &self.state else { return Ok(()) };
        if self.classes.are_known() {
            return Ok(());
        }
        let (of, count) = groups_for_ever(balls);
        if count < 2 {
            return Ok(());
        }
        let mut groups = vec![Vec::new(); count];
        of.iter().enumerate().for_each(|(i, &group)| groups[group as usize].push(i));
        let (mut left, mut others, mut stay) = (self.left, of.len(), Vec::new());
        for group in groups {
            let ahead = outlook(&balls.part(&group), &self.threshold, &Classes::default(), steps, progress)?;
            if ahead.is_steady() {
                // Groups that never meet because of their velocities have different ones.
                others -= group.len();
                left.drifting += ahead.drifting + group.len() * others;
                left.until = left.until.max(self.time.saturating_add(ahead.looked));
            } else {
                stay.extend(group);
            }
        }
        if !stay.is_empty() && stay.len() < of.len() {
            stay.sort_unstable();
            let rest: Balls<2> = balls.part(&stay);
            self.names = stay.iter().map(|&i| self.names[i]).collect();
            self.left = left;
            self.state = State::Balls(Box::new(rest));
            self.classes = Classes::default();
            self.watch.renew();
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
