//! Sets of states: parallelepipeds.

use super::IntervalVector;
use super::linear::{Frame, IntervalMatrix, apply, departure, frame_of, times};
use arithmetic::{FloatInterval, Ring};

/// All `centre + frame r` with `r` in a box that contains zero; the frame is orthogonal up to rounding.
#[derive(Debug, Clone)]
pub struct Parallelepiped {
    centre: Vec<f64>,
    frame: Frame,
    radii: IntervalVector,
}

impl Parallelepiped {
    /// A box.
    pub fn of_box(state: &[FloatInterval]) -> Self {
        let (centre, rest) = around_midpoints(state);
        let radii = rest.into_iter().map(with_zero).collect();
        Parallelepiped { frame: Frame::unit(centre.len()), centre, radii }
    }

    /// A state in the set.
    pub fn centre(&self) -> &[f64] {
        &self.centre
    }

    /// A box that contains the set.
    pub fn hull(&self) -> IntervalVector {
        let row = |(c, row): (&f64, IntervalVector)| {
            row.iter().zip(&self.radii).fold(FloatInterval::point(*c), |sum, (f, r)| sum + *f * r)
        };
        self.centre.iter().zip(self.frame.points()).map(row).collect()
    }

    /// All `image + derivative (x - centre)` for `x` in the set: the image under a map with `image` enclosing that of the centre, and `derivative` its
    /// derivatives on a convex set around this one (mean value theorem, row by row). `None` where a bound is not finite.
    pub(super) fn mapped(&self, image: &[FloatInterval], derivative: &IntervalMatrix) -> Option<Self> {
        let linear = times(derivative, &self.frame.points());
        let lengths: Vec<f64> = self.radii.iter().map(FloatInterval::width).collect();
        let size = self.centre.len();
        let found = frame_of(&linear, &lengths);
        let (frame, lost) = match departure(&found) {
            Some(lost) => (found, lost),
            None => (Frame::unit(size), 0.0),
        };
        let (centre, rest) = around_midpoints(image);
        let back = frame.transposed();
        let turned = apply(&times(&back, &linear), &self.radii);
        let added = apply(&back, &rest);
        let inside = turned.into_iter().zip(added).map(|(a, b)| a + b).collect();
        Parallelepiped { centre, frame, radii: inside }.widened(lost)
    }

    /// The set plus a box.
    pub fn plus(&self, shift: &[FloatInterval]) -> Option<Self> {
        let moved: IntervalVector = self.centre.iter().zip(shift).map(|(c, d)| FloatInterval::point(*c) + d).collect();
        let (centre, rest) = around_midpoints(&moved);
        let lost = departure(&self.frame)?;
        let radii = apply(&self.frame.transposed(), &rest);
        let added = Parallelepiped { centre, frame: self.frame.clone(), radii };
        let mut sum = added.widened(lost)?;
        sum.radii.iter_mut().zip(&self.radii).for_each(|(a, b)| *a = *a + b);
        Some(sum)
    }

    /// With `F⁻¹ = (I + E)Fᵀ` and `‖E‖ <= lost`, from the coordinates `Fᵀx` to those with `F` alone.
    fn widened(mut self, lost: f64) -> Option<Self> {
        let most = self.radii.iter().map(FloatInterval::magnitude).fold(0.0, f64::max);
        let slack = FloatInterval::between(-lost, lost) * FloatInterval::point(most);
        self.radii.iter_mut().for_each(|r| *r = with_zero(*r + slack));
        (self.radii.iter().all(FloatInterval::is_bounded) && self.centre.iter().all(|c| c.is_finite())).then_some(self)
    }
}

/// Midpoints, and the intervals less these.
fn around_midpoints(x: &[FloatInterval]) -> (Vec<f64>, IntervalVector) {
    let centre: Vec<f64> = x.iter().map(FloatInterval::midpoint).collect();
    let rest = x.iter().zip(&centre).map(|(x, c)| *x - FloatInterval::point(*c)).collect();
    (centre, rest)
}

fn with_zero(x: FloatInterval) -> FloatInterval {
    x.hull(&x.zero())
}
