//! Motions of two and three agents that are known exactly for all time.

use super::steady::SteadyMotion;
use crate::double_integrator::laws::{Coordinates, Potential};
use arithmetic::rational;

const PLANE: Coordinates = Coordinates::Cartesian;

/// `s + 1/s - 2`.
fn spring() -> Potential {
    Potential::inverse_square_spring(&rational(1, 1), &rational(1, 1))
}

impl SteadyMotion {
    /// Three agents at rest in a row on the complete graph, the middle one half way: `V = m/s + log(s/m)` with `m = 4/3`, so that
    /// the outward push at distance 1 and the inward pull at distance 2 cancel.
    pub fn row_of_three() -> Self {
        SteadyMotion::new(
            "three agents at (-1, 0), (0, 0), (1, 0), all linked, V = m/s + log(s/m) with m = 4/3",
            &[(0, 1), (0, 2), (1, 2)],
            PLANE,
            Potential::inverse_square_log(&rational(4, 3)),
            &[((-1, 0), (0, 0)), ((0, 0), (0, 0)), ((1, 0), (0, 0))],
        )
    }

    /// The equilateral triangle at the desired distance, at rest.
    pub fn triangle() -> Self {
        SteadyMotion::new(
            "an equilateral triangle, all linked, V = 1/s + log s",
            &[(0, 1), (0, 2), (1, 2)],
            Coordinates::Triangular,
            Potential::inverse_square_log(&rational(1, 1)),
            &[((0, 0), (0, 0)), ((1, 0), (0, 0)), ((0, 1), (0, 0))],
        )
    }

    /// Two agents at the desired distance that move together.
    pub fn pair() -> Self {
        SteadyMotion::new(
            "two linked agents at distance 1 with velocities (1, 0), V = s + 1/s - 2",
            &[(0, 1)],
            PLANE,
            spring(),
            &[((0, 0), (1, 0)), ((1, 0), (1, 0))],
        )
    }

    /// Two agents at rest at a distance where the slope of a potential of Definition 3 vanishes, though not its minimum.
    pub fn inflected_pair() -> Self {
        SteadyMotion::new(
            "two linked agents at rest at |r|² = 4, with V' = (s - 1)(s - 4)²(s + 2/3)/s² and V(1) = 0",
            &[(0, 1)],
            PLANE,
            Potential::with_inflection(&rational(4, 1)),
            &[((0, 0), (0, 0)), ((2, 0), (0, 0))],
        )
    }

    /// A path of three agents at rest, in a row, at right angles, and folded so that its ends coincide.
    pub fn paths() -> [Self; 3] {
        let path = |name, last| {
            let agents = [((1, 0), (0, 0)), ((0, 0), (0, 0)), (last, (0, 0))];
            SteadyMotion::new(name, &[(0, 1), (1, 2)], PLANE, spring(), &agents)
        };
        [
            path("the path 1-2-3 at (1, 0), (0, 0), (-1, 0), V = s + 1/s - 2", (-1, 0)),
            path("the path 1-2-3 at (1, 0), (0, 0), (0, 1), V = s + 1/s - 2", (0, 1)),
            path("the path 1-2-3 at (1, 0), (0, 0), (1, 0), V = s + 1/s - 2", (1, 0)),
        ]
    }

    /// Two agents without a link that part.
    pub fn strangers() -> Self {
        SteadyMotion::new(
            "two agents that are not linked, at (0, 0) and (1, 0) with velocities (0, 0) and (1, 0)",
            &[],
            PLANE,
            spring(),
            &[((0, 0), (0, 0)), ((1, 0), (1, 0))],
        )
    }

    /// All of them, natural ones first.
    pub fn all_known() -> Vec<Self> {
        let mut all = vec![Self::pair(), Self::row_of_three(), Self::triangle()];
        all.extend(Self::paths());
        all.extend([Self::strangers(), Self::inflected_pair()]);
        all
    }
}
