//! Which names of `[for]` something uses: one that nothing uses would be ignored silently, and one that says the same as another would hide it.

use super::Question;
use super::count::mentions;
use crate::domain::Sort;
use crate::error::{Problem, QuestionError};
use crate::names::{Subject, quantity_of};
use crate::scenario_file::is_place;
use crate::syntax::{Kind, Node};
use models::platoon::Parameter;

impl Question {
    /// Refuses names that nothing uses, and those of quantities that they would hide.
    pub(super) fn check_bounds(&self) -> Result<(), QuestionError> {
        let expressions = [&self.restriction, &self.property].into_iter().flatten().chain(&self.controls);
        let expressions = expressions.chain(self.asked_values().iter().map(|own| &own.expression));
        let nodes: Vec<&Node> = expressions.map(|expression| &expression.node).collect();
        for (place, bound) in self.bounds.iter().enumerate() {
            let name = bound.name.as_ref();
            // `n` is compared with the order of the graph, case by case.
            if name != "n"
                && let Some(quantity) = quantity_of(name, self.subjects())
            {
                let message =
                    format!("`{name}` is a quantity of {}, and cannot be bound beside it", quantity.subject.words());
                return Err(self.at(bound.key_at, Problem::Other(message)));
            }
            let later = || self.bounds[place + 1..].iter().any(|later| mentions(&later.domain, name));
            if !self.uses(&nodes, name) && !later() {
                return Err(self.at(bound.key_at, Problem::Unused(name.to_string())));
            }
        }
        Ok(())
    }

    /// Whether an expression uses a bound name: as it stands, or by a quantity of what it stands for.
    pub(crate) fn uses(&self, expressions: &[&Node], name: &str) -> bool {
        // A place puts its number into the scenario, and the seed draws without being named.
        let mut used = is_place(name) || name == "seed";
        if let Some(law) = self.law() {
            used |= name == "agents" || name == "t" || self.sort(name) == Some(Sort::Graph);
            used |= law.law.parameters.iter().any(|(known, _)| known == name);
        }
        for node in expressions {
            node.visit(&mut |node| {
                if let Kind::Name { name: own, called, .. } = &node.kind {
                    used |= self.asks_for(own, *called, name);
                }
            });
        }
        used
    }

    /// Whether the name `own` of an expression asks for the bound `name`.
    fn asks_for(&self, own: &str, called: bool, name: &str) -> bool {
        if !called && self.sort(own).is_some() {
            return own == name;
        }
        let (owner, quantity) = own.split_once('.').map_or((None, own), |(owner, rest)| (Some(owner), rest));
        let sort = self.sort(name);
        let is_owner = owner.is_none_or(|owner| owner == name);
        if called && ["sum", "count"].contains(&quantity) || self.given(quantity).is_some() {
            return sort == Some(Sort::Graph) && is_owner;
        }
        match quantity_of(quantity, self.subjects()).map(|quantity| quantity.subject) {
            Some(Subject::Graph) => sort == Some(Sort::Graph) && is_owner,
            Some(Subject::Matrices) => sort == Some(Sort::Matrices) && is_owner,
            Some(Subject::Platoon) => {
                name == "followers" || Parameter::from_name(name).is_some() || sort == Some(Sort::Graph)
            }
            _ => false,
        }
    }
}
