//! Operations that are done at once, so that what is between them is neither written nor read: squares of differences, products with differences that are summed,
//! and the reciprocal of a fourth root, which needs neither roots nor divisions.

use super::code::{Body, Inner, Instruction, Level, Load, Register, Step};
use crate::program::Gather;
use std::collections::HashMap;

/// Fuses what a loop does for its lanes. Each register is written once.
pub(super) fn inside(inner: &mut Inner) {
    let mut fuser = Fuser::of(&inner.level, &inner.results);
    let whole = inner.level.condition.is_none();
    for (gather, body, _) in &mut inner.results {
        // Without a condition the lanes of a sum are added as they are.
        if whole && matches!(gather, Gather::Sum | Gather::Mean) {
            *body = fuser.summed(*body);
        }
    }
    for steps in [&mut inner.level.before, &mut inner.level.after] {
        for step in steps.iter_mut() {
            if let Step::Straight(list) = step {
                for (to, instruction) in list.iter_mut() {
                    *instruction = fuser.fused(*instruction);
                    fuser.made.insert(*to, *instruction);
                }
                list.retain(|(to, _)| fuser.uses.get(to).is_some_and(|uses| *uses > 0));
            }
        }
    }
}

struct Fuser {
    /// What computes a register.
    made: HashMap<Register, Instruction>,
    /// How often it is read.
    uses: HashMap<Register, usize>,
}

impl Fuser {
    fn of(level: &Level, results: &[(Gather, Body, Register)]) -> Self {
        let mut fuser = Fuser { made: HashMap::new(), uses: HashMap::new() };
        for step in level.before.iter().chain(&level.after) {
            match step {
                Step::Straight(list) => {
                    for (to, instruction) in list {
                        fuser.made.insert(*to, *instruction);
                        operands(*instruction).into_iter().flatten().for_each(|own| fuser.count(own));
                    }
                }
                Step::Loop(inner) => {
                    for (_, load) in &inner.level.loads {
                        if let Load::Outer(own) = load {
                            fuser.count(*own);
                        }
                    }
                }
            }
        }
        level.condition.into_iter().for_each(|own| fuser.count(own));
        for (_, body, _) in results {
            match body {
                Body::Own(own) => fuser.count(*own),
                Body::Scaled(a, b, c) => [*a, *b, *c].into_iter().for_each(|own| fuser.count(own)),
            }
        }
        fuser
    }

    fn count(&mut self, register: Register) {
        *self.uses.entry(register).or_default() += 1;
    }

    /// What computes a register that is read so often and no more.
    fn only(&self, register: Register, uses: usize) -> Option<Instruction> {
        self.made.get(&register).copied().filter(|_| self.uses.get(&register) == Some(&uses))
    }

    /// A register that is read no more, whose operands another instruction takes over.
    fn taken(&mut self, register: Register) {
        self.uses.insert(register, 0);
    }

    fn summed(&mut self, body: Body) -> Body {
        let Body::Own(register) = body else { return body };
        let Some(Instruction::Product(a, b)) = self.only(register, 1) else { return body };
        for (factor, difference) in [(a, b), (b, a)] {
            if let Some(Instruction::Difference(x, y)) = self.only(difference, 1).filter(|_| a != b) {
                self.taken(register);
                self.taken(difference);
                return Body::Scaled(factor, x, y);
            }
        }
        body
    }

    fn fused(&mut self, instruction: Instruction) -> Instruction {
        match instruction {
            Instruction::Product(a, b) if a == b => match self.only(a, 2) {
                Some(Instruction::Difference(x, y)) => {
                    self.taken(a);
                    Instruction::Square(x, y)
                }
                _ => instruction,
            },
            Instruction::Product(a, b) => {
                for (factor, difference) in [(a, b), (b, a)] {
                    if let Some(Instruction::Difference(x, y)) = self.only(difference, 1) {
                        self.taken(difference);
                        return Instruction::Scaled(x, y, factor);
                    }
                }
                instruction
            }
            Instruction::Sum(a, b) => {
                for (rest, square) in [(a, b), (b, a)] {
                    if let Some(Instruction::Square(x, y)) = self.only(square, 1).filter(|_| a != b) {
                        self.taken(square);
                        return Instruction::SquareAdded(x, y, rest);
                    }
                }
                instruction
            }
            Instruction::Quotient(c, root) => {
                let inner = match self.only(root, 1) {
                    Some(Instruction::Root(inner)) => inner,
                    _ => return instruction,
                };
                match self.only(inner, 1) {
                    Some(Instruction::Root(x)) => {
                        self.taken(root);
                        self.taken(inner);
                        Instruction::InverseFourthRoot(c, x)
                    }
                    _ => instruction,
                }
            }
            other => other,
        }
    }
}

/// The registers that an instruction reads.
fn operands(instruction: Instruction) -> [Option<Register>; 3] {
    use Instruction::{
        Absolute, Angle, Both, Choice, Compared, Difference, InverseFourthRoot, Larger, Negated, Not, Of, Product,
        Quotient, Root, Scaled, Smaller, Square, SquareAdded, Sum,
    };
    match instruction {
        Negated(a) | Root(a) | Of(_, a) | Absolute(a) | Not(a) => [Some(a), None, None],
        Sum(a, b)
        | Difference(a, b)
        | Product(a, b)
        | Quotient(a, b)
        | Angle(a, b)
        | Larger(a, b)
        | Smaller(a, b)
        | Compared(_, a, b)
        | Both(a, b)
        | Square(a, b)
        | InverseFourthRoot(a, b) => [Some(a), Some(b), None],
        Choice(a, b, c) | SquareAdded(a, b, c) | Scaled(a, b, c) => [Some(a), Some(b), Some(c)],
    }
}
