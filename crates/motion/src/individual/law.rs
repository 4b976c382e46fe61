//! What a law says of one agent among its neighbours.

use arithmetic::{ArithmeticError, Field};

/// An agent as a law reads it: over numbers at one time, over series in time. `F` is the number of further states, as a heading.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moving<T, const F: usize> {
    /// In the plane.
    pub position: [T; 2],
    /// Its rate of change.
    pub velocity: [T; 2],
    /// Further states; if there is an angle, it is the first.
    pub further: [T; F],
}

/// How an agent changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rates<T, const F: usize> {
    /// The acceleration.
    pub velocity: [T; 2],
    /// The rates of change of the further states.
    pub further: [T; F],
}

/// Where the first further state, an angle in radians, jumps by a whole turn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Turns {
    /// Nowhere: it is followed continuously, or there is none.
    Never,
    /// Where it leaves `(-pi, pi]`.
    OfAgents,
    /// In what a law reads of two linked agents, where their difference leaves `(-pi, pi]`.
    OfPairs,
}

/// The law of agents in the plane: influences of the neighbours, which are summed, and the rates of change under the sum. `F` further states,
/// `M` influences. It does not depend on the time, and knows the angles of others up to whole turns as [`Self::turns`] tells.
///
/// Both functions are computed over vectors of the processor; they should be inlined always.
pub trait IndividualLaw<const F: usize, const M: usize> {
    /// What one neighbour adds to the influences on an agent; `number` makes a constant.
    ///
    /// # Errors
    /// Where the law has no value.
    fn pair<T: Field + Copy>(
        &self,
        own: &Moving<T, F>,
        other: &Moving<T, F>,
        number: impl Fn(f64) -> T + Copy,
    ) -> Result<[T; M], ArithmeticError>;

    /// The rates of change of an agent, affine in the sum of the influences on it.
    ///
    /// # Errors
    /// Where the law has no value.
    fn rates<T: Field + Copy>(
        &self,
        own: &Moving<T, F>,
        influences: &[T; M],
        number: impl Fn(f64) -> T + Copy,
    ) -> Result<Rates<T, F>, ArithmeticError>;

    /// Where angles jump.
    fn turns(&self) -> Turns {
        Turns::Never
    }

    /// By how much the second derivative of a squared distance rises where a link comes into force at this one, if it rises: then a pair can stay
    /// there. 0 where that is not to be told.
    fn push(&self, _square: f64) -> f64 {
        0.0
    }

    /// The velocity of an agent, where its further states determine it; it is brought back to this at the beginning of each series.
    fn velocity(&self, at: &Moving<f64, F>) -> [f64; 2] {
        at.velocity
    }
}
