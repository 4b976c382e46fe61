//! Single members of a family, chosen by someone else: for campaigns, which need no count of all members.

use crate::bindings::{Bindings, Value};
use crate::error::QuestionError;
use crate::question::Question;
use crate::shrink::{Shrunk, shorter_times};
use arithmetic::{Progress, rational, simplest_between};
use motion::sets::Range;

/// An interval gives its simplest number, or an end of one of its `2^k` equal parts with `k` up to this.
const FINEST: u64 = 20;

impl Question {
    /// The member that `choose` picks: it is asked for a number below its argument, once for each name and twice for an interval, of which a
    /// point is taken; 0 is the simplest. `None` where a name has no values, given the earlier ones.
    ///
    /// # Errors
    /// [`QuestionError`] where a family is wrong.
    pub fn member(
        &self,
        choose: &mut dyn FnMut(u64) -> u64,
        progress: &dyn Progress,
    ) -> Result<Option<Bindings>, QuestionError> {
        let mut bindings = Bindings::default();
        for (place, bound) in self.bounds.iter().enumerate() {
            let members = self.members(place, &bindings, progress)?;
            let value = match members.len() {
                0 => None,
                count => members.get(choose(count).min(count - 1)),
            };
            let value = match value {
                None => return Ok(None),
                Some(Value::Box(Range { lo, hi })) => {
                    let parts = choose(FINEST + 2).min(FINEST + 1).checked_sub(1).map(|power| 1u64 << power);
                    let part = choose(parts.unwrap_or(0) + 1).min(parts.unwrap_or(0));
                    Value::Number(match parts {
                        None => simplest_between(&lo, &hi),
                        Some(parts) => (&hi - &lo) * rational(part as i64, parts as i64) + lo,
                    })
                }
                Some(Value::Any) => {
                    // Up to 1, 4, 16, .., in parts of a 64th.
                    let size = 64i64 << (2 * choose(6).min(5));
                    let part = choose(2 * size as u64 + 1).min(2 * size as u64) as i64;
                    // 0, 1, -1, 2, -2, ..
                    Value::Number(rational(if part % 2 == 1 { (part + 1) / 2 } else { -part / 2 }, 64))
                }
                Some(Value::Integers(from, to)) => {
                    let count = (to - from) as u64 + 1;
                    Value::Number(rational(from + choose(count).min(count - 1) as i64, 1))
                }
                Some(value) => value,
            };
            bindings.push(bound.name.clone(), value);
        }
        Ok(Some(bindings))
    }

    /// A question of one member, as the text of a file that decides it alone, with a shorter time where the property fails in it already.
    ///
    /// # Errors
    /// [`QuestionError`] where the question is wrong there, or has no property.
    pub fn instance(&self, bindings: &Bindings, progress: &dyn Progress) -> Result<String, QuestionError> {
        let property = shorter_times(self, self.asked()?, bindings, progress)?;
        self.replay(&Shrunk { bindings: bindings.clone(), property }, progress)
    }
}
