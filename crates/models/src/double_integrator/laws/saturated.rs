//! One-sided and generalised derivatives at a kink, such as that of the saturated potential at `|r_ij| = R`.

use arithmetic::{Ring, Sign, Signed};

/// A function of one variable at a point where it is continuous and has the two one-sided slopes `left` and `right`, and on
/// either side of which it is continuously differentiable up to that point.
#[derive(Debug, Clone, PartialEq)]
pub struct Kink<T> {
    /// The slope just below the point.
    pub left: T,
    /// The slope just above the point.
    pub right: T,
}

/// All numbers from `lo` to `hi`; none where `lo > hi`.
#[derive(Debug, Clone, PartialEq)]
pub struct Span<T> {
    /// Lower end.
    pub lo: T,
    /// Upper end.
    pub hi: T,
}

impl<T: Ring + Signed + Ord> Kink<T> {
    /// The saturated potential at the threshold: the potential's slope below, zero above.
    pub fn saturated(slope: T) -> Self {
        let right = slope.zero();
        Kink { left: slope, right }
    }

    /// The function times -1.
    pub fn negated(&self) -> Self {
        Kink { left: -self.left.clone(), right: -self.right.clone() }
    }

    /// The one-sided directional derivative `f'(x; w)`, the limit of `(f(x + tw) - f(x))/t` as `t` falls to 0.
    pub fn directional(&self, w: &T) -> T {
        let slope = if w.sign() == Some(Sign::Negative) { &self.left } else { &self.right };
        slope.clone() * w
    }

    /// Clarke's generalised directional derivative, the upper limit of `(f(y + tw) - f(y))/t` as `y` tends to `x` and `t` falls to
    /// 0: the larger of the two slopes times `w` (each is a mean of slopes near `x`, and either slope is reached on its side).
    pub fn clarke(&self, w: &T) -> T {
        (self.left.clone() * w).max(self.right.clone() * w)
    }

    /// Clarke's generalised gradient: all `z` with `clarke(w) >= z w` for every `w`.
    pub fn gradient(&self) -> Span<T> {
        Span::below(|w| self.clarke(w), &self.left)
    }

    /// All `z` with `directional(w) >= z w` for every `w`: the gradient if the function is regular, no number at a concave kink.
    pub fn subgradient(&self) -> Span<T> {
        Span::below(|w| self.directional(w), &self.left)
    }
}

impl<T: Ring + Signed + Ord> Span<T> {
    /// All `z` with `support(w) >= z w` for `w = 1` and `w = -1`; `support` is positively homogeneous.
    fn below(support: impl Fn(&T) -> T, like: &T) -> Self {
        Span { lo: -support(&like.integer(-1)), hi: support(&like.one()) }
    }

    /// Whether there is no such number.
    pub fn is_empty(&self) -> bool {
        self.lo > self.hi
    }

    /// Whether `z` is one of the numbers.
    pub fn contains(&self, z: &T) -> bool {
        &self.lo <= z && z <= &self.hi
    }

    /// Whether all its numbers lie in `other`.
    pub fn is_within(&self, other: &Self) -> bool {
        self.is_empty() || (other.lo <= self.lo && self.hi <= other.hi)
    }

    /// The numbers in both.
    pub fn intersection(&self, other: &Self) -> Self {
        Span { lo: self.lo.clone().max(other.lo.clone()), hi: self.hi.clone().min(other.hi.clone()) }
    }

    /// All sums of a number of each.
    pub fn plus(&self, other: &Self) -> Self {
        Span { lo: self.lo.clone() + &other.lo, hi: self.hi.clone() + &other.hi }
    }
}
