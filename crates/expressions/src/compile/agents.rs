//! What is gathered over agents: `sum(j, e)` and its like.

use super::names::parts;
use super::{Compiler, FUNCTIONS, LOOPS, Made, Scope, Value};
use crate::function::Function;
use crate::problem::Problem;
use crate::program::{Gather, Id, Of, Op, Slot};
use crate::syntax::{Node, NodeKind, Relation};

impl Compiler<'_> {
    /// Whether `max(j, e)` runs over agents: its first argument is a name that means nothing else, or has a condition.
    pub(super) fn is_over_agents(&self, gather: Gather, arguments: &[Node]) -> bool {
        let Some(first) = arguments.first() else { return false };
        let own_name = match &first.kind {
            NodeKind::Where(..) => return true,
            NodeKind::Name { name, called: false, .. } => name,
            _ => return !matches!(gather, Gather::Largest | Gather::Smallest),
        };
        let (base, ..) = parts(own_name);
        let known = self.variables.iter().any(|variable| variable.name == base)
            || self.text.parameters.iter().any(|(name, _)| name == base)
            || self.definitions.contains_key(base)
            || FUNCTIONS.iter().any(|(name, ..)| *name == base);
        !known || !matches!(gather, Gather::Largest | Gather::Smallest)
    }

    pub(super) fn over_agents(
        &mut self,
        node: &Node,
        gather: Gather,
        arguments: &[Node],
        scope: &Scope,
    ) -> Made<Value> {
        let word = LOOPS.iter().find(|(_, known)| *known == gather).map_or("", |(word, _)| word);
        let count = gather == Gather::Count;
        let expected = if count { "an agent and, if wanted, a condition" } else { "an agent and an expression" };
        if arguments.is_empty() || arguments.len() > 2 || (!count && arguments.len() < 2) {
            let (name, expected, found) = (word.to_string(), expected.to_string(), arguments.len());
            return self.refuse(node.at, Problem::Arguments { name, expected, found });
        }
        let (agent, filter) = match &arguments[0].kind {
            NodeKind::Where(agent, filter) => (agent.as_ref(), Some(filter.as_ref())),
            _ => (&arguments[0], None),
        };
        let NodeKind::Name { name, called: false, .. } = &agent.kind else {
            return self.refuse(agent.at, Problem::expected("a name for an agent", format!("`{agent}`")));
        };
        if scope.agents.iter().any(|(known, _)| known == name) {
            return self.refuse(agent.at, Problem::Bound(name.clone()));
        }
        let slot = self.things.slot(scope.innermost, scope.hears, name);
        let of = Of::Slot(slot);
        let mut inner = Scope { innermost: slot, hears: Some(of), ..scope.clone() };
        inner.agents.push((name.clone(), of));
        let mut conditions = Vec::new();
        if let Some(filter) = filter {
            conditions.push(self.condition(filter, &inner)?);
        }
        if count {
            if let Some(condition) = arguments.get(1) {
                conditions.push(self.condition(condition, &inner)?);
            }
            let condition = if conditions.is_empty() { None } else { Some(self.all_of(conditions)) };
            let one = self.things.integer(1);
            return Ok(Value::Number(self.things.gather(slot, condition, gather, one)));
        }
        let condition = conditions.pop();
        let value = self.value(&arguments[1], &inner)?;
        self.gathered(&arguments[1], slot, condition, gather, value)
    }

    pub(super) fn gathered(
        &mut self,
        node: &Node,
        slot: Slot,
        condition: Option<Id>,
        gather: Gather,
        value: Value,
    ) -> Made<Value> {
        let things = &mut self.things;
        Ok(match value {
            Value::Number(id) => Value::Number(things.gather(slot, condition, gather, id)),
            // The direction of the mean of the unit vectors; zero over none.
            Value::Angle(id) if gather == Gather::Mean => {
                let mut total = |function| {
                    let part = things.add(Op::Function(function, id));
                    things.gather(slot, condition, Gather::Sum, part)
                };
                let (sine, cosine) = (total(Function::Sine), total(Function::Cosine));
                let (zero, one) = (things.integer(0), things.integer(1));
                let count = things.gather(slot, condition, Gather::Count, one);
                let (angle, none) =
                    (things.add(Op::Angle(sine, cosine)), things.add(Op::Compared(Relation::Equal, count, zero)));
                Value::Angle(things.add(Op::Choice(none, zero, angle)))
            }
            Value::Angle(id) => Value::Angle(things.gather(slot, condition, gather, id)),
            Value::Vector(ids) if matches!(gather, Gather::Sum | Gather::Mean) => {
                Value::Vector(ids.into_iter().map(|id| things.gather(slot, condition, gather, id)).collect())
            }
            other => return self.refuse(node.at, Problem::expected("a number", other.words())),
        })
    }
}
