//! Headings that go on smoothly past the half turn. `heading(v[i])` lies in `(-pi, pi]` and jumps there; whoever follows a motion up to the jump needs a law that goes on as if there
//! were none. It is then `b + heading(v[i] turned by -b)`, with a direction b of each agent that is held: smooth as long as the heading is within half a turn of b.

use crate::program::{Of, Op, Program, Things};

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
    let (mut found, mut headings) = (Vec::with_capacity(program.ops.len()), Vec::new());
    for op in &program.ops {
        let id = match op {
            Op::Gathered(number, place) => {
                let this = &program.loops[*number];
                let (gather, body) = this.bodies[*place];
                things.gather(this.slot, this.condition.map(|id| found[id]), gather, found[body])
            }
            Op::Angle(y, x) => match heading(&program.ops[*y], &program.ops[*x]) {
                Some((heading, of)) => {
                    let place = headings.iter().position(|known| *known == heading).unwrap_or(headings.len());
                    if place == headings.len() {
                        headings.push(heading);
                    }
                    let [b, cosine, sine] = [0, 1, 2].map(|k| things.add(Op::Parameter(lists + LISTS * place + k, of)));
                    let mut product = |a, b| things.add(Op::Product(a, b));
                    let (x, y) = (found[*x], found[*y]);
                    let (cx, sy, cy, sx) = (product(cosine, x), product(sine, y), product(cosine, y), product(sine, x));
                    let (along, across) = (things.add(Op::Sum(cx, sy)), things.add(Op::Difference(cy, sx)));
                    let turned = things.add(Op::Angle(across, along));
                    things.add(Op::Sum(b, turned))
                }
                None => things.add(op.with(|id| found[id])),
            },
            _ => things.add(op.with(|id| found[id])),
        };
        found.push(id);
    }
    (things.program(program.outputs.iter().map(|&id| found[id]).collect()), headings)
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
