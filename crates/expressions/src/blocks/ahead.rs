//! What is computed ahead: functions and quotients that depend on one of two agents alone are computed once for each agent, not for each pair; so are sums over those whom the
//! other agent hears.

use crate::program::{FLOCK, Id, OWN, Of, Op, Program, Slot, Things};
use std::collections::HashMap;

/// A program in two.
pub(super) struct Divided {
    /// What is computed ahead, for each agent; nothing where that is nothing.
    pub first: Option<Program>,
    /// The rest. The numbers of the first one are parameters there, behind those of the law.
    pub rest: Program,
}

/// Divides a program of a law with so many lists of parameters.
pub(super) fn divided(program: &Program, lists: usize) -> Divided {
    let dividing = Dividing::new(program);
    let chosen = dividing.chosen();
    if chosen.is_empty() {
        return Divided { first: None, rest: program.clone() };
    }
    let place = |id: &Id| chosen.iter().position(|known| known == id);
    let mut rest = Things::with_slots_of(program);
    let mut found: Vec<Id> = Vec::with_capacity(program.ops.len());
    for (id, op) in program.ops.iter().enumerate() {
        let ahead = dividing.alone[id].and_then(|slot| Some((slot, place(dividing.keys[slot].get(&id)?)?)));
        found.push(match ahead {
            Some((slot, place)) => rest.add(Op::Parameter(lists + place, Of::Slot(slot))),
            None => rest.again(program, op, |id| found[id], |slot| slot),
        });
    }
    let rest = rest.program(program.outputs.iter().map(|&id| found[id]).collect());
    Divided { first: Some(dividing.first.program(chosen)), rest }
}

struct Dividing<'a> {
    program: &'a Program,
    /// The only agent variable that a thing depends on.
    alone: Vec<Option<Slot>>,
    /// Whether it is worth a list of its own.
    dear: Vec<bool>,
    /// What the first program computes.
    first: Things,
    /// For each agent variable the things that depend on it alone, as the first program has them.
    keys: Vec<HashMap<Id, Id>>,
}

impl<'a> Dividing<'a> {
    fn new(program: &'a Program) -> Self {
        let (mut alone, mut dear): (Vec<Option<Slot>>, Vec<bool>) = (Vec::new(), Vec::new());
        for (id, op) in program.ops.iter().enumerate() {
            let free = &program.free[id];
            alone.push(free.first().copied().filter(|_| free.len() == 1));
            let own = matches!(op, Op::Function(..) | Op::Angle(..) | Op::Quotient(..) | Op::Gathered(..));
            dear.push(!free.is_empty() && (own || op.needs().iter().any(|id| dear[*id])));
        }
        let mut dividing = Dividing { program, alone, dear, first: Things::new(), keys: Vec::new() };
        dividing.keys = (0..program.slots.len()).map(|slot| dividing.keys_of(slot)).collect();
        dividing
    }

    /// All things that depend on a variable, and on those of loops inside its scope, with the agent of the first program in its place.
    fn keys_of(&mut self, root: Slot) -> HashMap<Id, Id> {
        let program = self.program;
        let mut keys = HashMap::new();
        if root == FLOCK {
            return keys;
        }
        let mut slots: HashMap<Slot, Slot> = HashMap::from([(FLOCK, FLOCK), (root, OWN)]);
        // Variables of loops are made after those around them.
        for (slot, variable) in program.slots.iter().enumerate() {
            let known = |slot: Slot| slots.get(&slot).copied();
            let Some(parent) = known(variable.parent).filter(|_| slot > OWN && slot != root) else { continue };
            let hears = match variable.hears {
                Some(Of::Slot(hears)) => match known(hears) {
                    Some(hears) => Some(Of::Slot(hears)),
                    None => continue,
                },
                other => other,
            };
            let new = self.first.slot(parent, hears, &variable.name);
            slots.insert(slot, new);
        }
        for (id, op) in program.ops.iter().enumerate() {
            if !program.free[id].iter().all(|slot| slots.contains_key(slot)) {
                continue;
            }
            let known = match op {
                Op::Gathered(number, place) => {
                    let this = &program.loops[*number];
                    slots.contains_key(&this.slot) && this.needs(*place).all(|id| keys.contains_key(&id))
                }
                _ => op.needs().iter().all(|id| keys.contains_key(id)),
            };
            if !known {
                continue;
            }
            let new = self.first.again(program, op, |id| keys[&id], |slot| slots[&slot]);
            keys.insert(id, new);
        }
        keys
    }

    /// What is computed ahead: the largest parts that depend on one agent of a loop inside a loop over agents; those of loops over the flock where the agent itself needs the same.
    fn chosen(&self) -> Vec<Id> {
        let program = self.program;
        let of_itself: Vec<Id> = self.keys.get(OWN).into_iter().flat_map(|keys| keys.values().copied()).collect();
        let mut chosen = Vec::new();
        let mut used = |id: Id, by: Option<Slot>| {
            let Some(slot) = self.alone[id].filter(|slot| *slot != OWN && by != Some(*slot) && self.dear[id]) else {
                return;
            };
            let Some(&key) = self.keys[slot].get(&id) else { return };
            let shared = program.slots[slot].parent != FLOCK || of_itself.contains(&key);
            // A loop inside of another one, though nothing in it depends on that one's agent, stays there.
            let is_own = self.first.slot_of[key] == OWN;
            if shared && is_own && !chosen.contains(&key) {
                chosen.push(key);
            }
        };
        for &id in &program.wanted {
            let op = &program.ops[id];
            op.needs().into_iter().for_each(|need| used(need, self.alone[id]));
            if let Op::Gathered(number, place) = op {
                program.loops[*number].needs(*place).for_each(|need| used(need, self.alone[id]));
            }
        }
        chosen
    }
}
