//! The simplest right-hand sides with a jump, and their solutions in the sense of Filippov.

use super::saturated::Span;
use arithmetic::{Rational, rational};

/// A right-hand side on the line with one jump: `left` for `x < 0`, `right` for `x >= 0`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StepField {
    /// The value below 0.
    pub left: i64,
    /// The value from 0 on.
    pub right: i64,
}

impl StepField {
    /// Every such field with values -1, 0, 1.
    pub fn all() -> impl Iterator<Item = StepField> {
        (-1..=1).flat_map(|left| (-1..=1).map(move |right| StepField { left, right }))
    }

    /// `K[f]` on the side that the ray `x = c t` is on for `t > 0`: the hull of both values for `c = 0`.
    pub fn inclusion(self, c: i64) -> Span<Rational> {
        let (left, right) = (rational(self.left, 1), rational(self.right, 1));
        match c.signum() {
            1 => Span { lo: right.clone(), hi: right },
            -1 => Span { lo: left.clone(), hi: left },
            _ => Span { lo: left.clone().min(right.clone()), hi: left.max(right) },
        }
    }

    /// The `c` among -1, 0, 1 for which `x = c t` is a Filippov solution from 0.
    pub fn rays(self) -> Vec<i64> {
        (-1..=1).filter(|&c| self.inclusion(c).contains(&rational(c, 1))).collect()
    }
}
