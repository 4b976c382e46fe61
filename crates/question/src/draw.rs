//! Single members of a family, chosen by someone else: for campaigns, which need no count of all members.

use crate::bindings::{Bindings, Value};
use crate::error::QuestionError;
use crate::question::Question;
use arithmetic::{Progress, rational};

/// Denominators of the parts into which an interval is divided are powers of two up to this.
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
                Some(Value::Box(lo, hi)) => {
                    let parts = 1u64 << choose(FINEST + 1).min(FINEST);
                    let part = choose(parts + 1).min(parts);
                    Value::Number((&hi - &lo) * rational(part as i64, parts as i64) + lo)
                }
                Some(value) => value,
            };
            bindings.push(bound.name.clone(), value);
        }
        Ok(Some(bindings))
    }

    /// A question of one member, as the text of a file that decides it alone.
    pub fn instance(&self, bindings: &Bindings) -> String {
        self.replay(bindings)
    }
}
