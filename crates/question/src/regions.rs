//! Where in a continuum a property holds, where it fails, and where that is open: a certified map.

use crate::bindings::Bindings;
use crate::division::{Division, halved};
use crate::error::QuestionError;
use crate::question::{Expression, Question};
use crate::truth::Truth;
use arithmetic::Progress;
use std::collections::VecDeque;

/// What is known of all points of a box.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Standing {
    /// The property holds at all of them.
    Holds,
    /// It fails at all of them.
    Fails,
    /// Neither was proved.
    Open,
}

impl Standing {
    /// One word.
    pub fn word(self) -> &'static str {
        match self {
            Standing::Holds => "holds",
            Standing::Fails => "fails",
            Standing::Open => "open",
        }
    }
}

/// A box with what is known of it.
#[derive(Debug, Clone)]
pub struct Region {
    /// The names with their numbers and intervals.
    pub bindings: Bindings,
    /// What is known of it.
    pub standing: Standing,
}

impl Question {
    /// Divides the intervals of one member into at most about `most` boxes, all equally fine, until the property is decided on each. What `where` leaves out is
    /// in no box.
    ///
    /// # Errors
    /// [`QuestionError`] where the question is wrong there, or has no property.
    pub fn regions(&self, member: &Bindings, most: u64, progress: &dyn Progress) -> Result<Vec<Region>, QuestionError> {
        let expression = self.asked()?;
        let without_margins = Expression::like(expression, expression.node.clone());
        let division = Division { question: self, expression: &without_margins, progress, most };
        let whole = member.boxes();
        let mut regions = Vec::new();
        let mut queue = VecDeque::from([member.clone()]);
        while let Some(bindings) = queue.pop_front() {
            progress.checkpoint()?;
            let standing = match division.on_box(&bindings)?.truth {
                None => continue,
                Some(Truth::True) => Standing::Holds,
                Some(Truth::False) => Standing::Fails,
                Some(Truth::Unknown(_)) => {
                    let room = (regions.len() + queue.len() + 2) as u64 <= most;
                    if let Some((_, halves)) = halved(&bindings, &whole, &[]).filter(|_| room) {
                        queue.extend(halves);
                        continue;
                    }
                    // Where equality stands in the way.
                    if division.holds_where_attained(&bindings)? { Standing::Holds } else { Standing::Open }
                }
            };
            regions.push(Region { bindings, standing });
        }
        Ok(regions)
    }
}
