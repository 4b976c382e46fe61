//! Headings that go on smoothly past the half turn. `heading(v[i])` lies in `(-pi, pi]` and jumps there; whoever follows a motion up to the jump needs a law that goes on as if there
//! were none. It is then `b + heading(v[i] turned by -b)`, with a direction b of each agent that is held: smooth as long as the heading is within half a turn of b.
//!
//! Where a whole turn makes no difference, as in `sin(heading(v[j]) - heading(v[i]))`, nothing jumps and nothing is held.

use crate::function::Function;
use crate::program::{Gather, Id, Of, Op, Program, Things};

/// A heading of each agent in a law: where the components of its vector stand in the state.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Heading {
    /// Where those of agent 0 begin, and numbers from one agent to the next.
    start: usize,
    stride: usize,
    components: [usize; 2],
}

impl Heading {
    /// The two places in the state of the vector of an agent.
    pub fn places(&self, agent: usize) -> [usize; 2] {
        self.components.map(|component| self.start + agent * self.stride + component)
    }
}

/// The directions of the agents that are held for one heading: angle, cosine, sine.
pub(super) const LISTS: usize = 3;

/// The same program with headings that are held, in parameters behind those of the law, three for each.
pub(super) fn held(program: &Program, lists: usize) -> (Program, Vec<Heading>) {
    let mut things = Things::with_slots_of(program);
    let feels = feel_turns(program);
    let (mut found, mut headings) = (Vec::with_capacity(program.ops.len()), Vec::new());
    for (id, op) in program.ops.iter().enumerate() {
        let held = match op {
            Op::Angle(y, x) if feels[id] => heading(&program.ops[*y], &program.ops[*x]).map(|own| (own, *y, *x)),
            _ => None,
        };
        let id = match held {
            Some(((heading, of), y, x)) => {
                let place = headings.iter().position(|known| *known == heading).unwrap_or(headings.len());
                if place == headings.len() {
                    headings.push(heading);
                }
                let [b, cosine, sine] = [0, 1, 2].map(|k| things.add(Op::Parameter(lists + LISTS * place + k, of)));
                let mut product = |a, b| things.add(Op::Product(a, b));
                let (x, y) = (found[x], found[y]);
                let (cx, sy, cy, sx) = (product(cosine, x), product(sine, y), product(cosine, y), product(sine, x));
                let (along, across) = (things.add(Op::Sum(cx, sy)), things.add(Op::Difference(cy, sx)));
                let turned = things.add(Op::Angle(across, along));
                things.add(Op::Sum(b, turned))
            }
            None => things.again(program, op, |id| found[id], |slot| slot),
        };
        found.push(id);
    }
    (things.program(program.outputs.iter().map(|&id| found[id]).collect()), headings)
}

/// For each thing whether the results would be others if a whole turn were added to it.
fn feel_turns(program: &Program) -> Vec<bool> {
    let mut feels = vec![false; program.ops.len()];
    program.outputs.iter().for_each(|&id| feels[id] = true);
    for &id in program.wanted.iter().rev() {
        let op = &program.ops[id];
        let is_integer = |id: Id| matches!(&program.ops[id], Op::Number(q) if q.is_integer());
        let turns = match op {
            Op::Function(Function::Sine | Function::Cosine, _) => false,
            Op::Sum(..) | Op::Difference(..) | Op::Negated(_) => feels[id],
            Op::Product(a, b) if is_integer(*a) || is_integer(*b) => feels[id],
            Op::Gathered(number, place) => {
                let this = &program.loops[*number];
                let (gather, body) = this.bodies[*place];
                feels[body] |= feels[id] || gather != Gather::Sum;
                this.condition.into_iter().for_each(|condition| feels[condition] = true);
                false
            }
            Op::Choice(condition, a, b) => {
                feels[*condition] = true;
                [*a, *b].into_iter().for_each(|chosen| feels[chosen] |= feels[id]);
                continue;
            }
            _ => true,
        };
        op.needs().into_iter().for_each(|need| feels[need] |= turns);
    }
    feels
}

/// The heading of a vector of the state, and whose.
fn heading(y: &Op, x: &Op) -> Option<(Heading, Of)> {
    match (y, x) {
        (
            Op::State { start, stride, component: second, of },
            Op::State { start: other, stride: same, component: first, of: whose },
        ) if (start, stride, of) == (other, same, whose) => {
            Some((Heading { start: *start, stride: *stride, components: [*first, *second] }, *of))
        }
        _ => None,
    }
}
