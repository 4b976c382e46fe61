//! Sets of states: a polynomial image of a cube, and what lies around it.

use super::IntervalVector;
use super::bound::{Bound, values};
use super::cascade::Cascade;
use super::expanded::{Expanded, MOST_VARIABLES, degree_of};
use super::expansion::range;
use super::shape::Shape;
use arithmetic::FloatInterval;
use std::sync::Arc;

/// All `P(s) + x` with `s` in the cube `[-1, 1]^m` and `x` in a sum of parallelepipeds around zero. The variables `s` are the numbers of the start that are
/// intervals, so that a set that the motion contracts is one whose coefficients shrink.
#[derive(Debug, Clone)]
pub struct Set {
    pub(super) shape: Arc<Shape>,
    /// One for each number of the state.
    pub(super) polynomials: Vec<Vec<f64>>,
    pub(super) rest: Cascade,
}

/// The part of the radius of a set that the rest may have before the set gets new variables.
const LARGEST_REST: f64 = 0.2;

/// A rest below this, relative to the state, is none to care for.
const TINY_REST: f64 = 1e-9;

/// New variables are taken where they make the rest smaller by this factor.
const LEAST_GAIN: f64 = 0.5;

/// Edges shorter than this part of the longest one are no variables.
const SHORT_EDGE: f64 = 1e-3;

/// A set in new variables may be wider by this factor; else it becomes a box.
const MOST_GROWTH: f64 = 1.2;

/// The longest edge of a box.
pub(super) fn longest_edge(hull: &[FloatInterval]) -> f64 {
    hull.iter().map(FloatInterval::width).fold(0.0, f64::max)
}

impl Set {
    /// A box.
    pub fn of_box(state: &[FloatInterval]) -> Self {
        Set::of_numbers(&Expanded::of_start(state))
    }

    /// All states whose numbers these are, of the same start each.
    pub fn of_numbers(numbers: &[Expanded]) -> Self {
        let shape = numbers.first().map_or_else(|| Arc::new(Shape::new(0, 0)), |number| number.parts().0.clone());
        let polynomials = numbers.iter().map(|number| number.parts().1.to_vec()).collect();
        let errors: Vec<f64> = numbers.iter().map(|number| number.parts().2).collect();
        Set { shape, polynomials, rest: Cascade::of_box(&errors) }
    }

    /// The numbers of a state.
    pub fn dimension(&self) -> usize {
        self.polynomials.len()
    }

    /// A box that contains the set.
    pub fn hull(&self) -> IntervalVector {
        let whole = FloatInterval::between(0.0, 1.0);
        let around = |r: &f64| FloatInterval::between(-r, *r);
        self.polynomials.iter().zip(&self.rest.radii()).map(|(p, r)| range(&self.shape, p, whole) + around(r)).collect()
    }

    /// The longest edge of its [hull](Self::hull).
    pub fn width(&self) -> f64 {
        longest_edge(&self.hull())
    }

    /// How far the polynomials are from the set, at most.
    pub fn rest_radius(&self) -> f64 {
        self.rest.radii().into_iter().fold(0.0, f64::max)
    }

    /// The variables of the polynomials: the numbers of the start that are wide, the widest first, each from -1 to 1 on its interval; or new ones, where the
    /// set was [renewed](super::Flow::step).
    pub fn variables(&self) -> usize {
        self.shape.variables
    }

    /// Encloses the states of the set for one value of the variables.
    pub fn at(&self, variables: &[f64]) -> IntervalVector {
        let around = |r: &f64| FloatInterval::between(-r, *r);
        let value = |p: &Vec<f64>| self.shape.value(p, variables);
        self.polynomials.iter().zip(&self.rest.radii()).map(|(p, r)| value(p) + around(r)).collect()
    }

    /// A set around it in variables of its own, the longest edges of a parallelepiped, where the rest has become a large part of a set that is not tiny.
    pub fn renewed(&self) -> Option<Self> {
        let radius = |p: &Vec<f64>| Bound::total(p[1..].iter().copied()).value();
        let own = self.polynomials.iter().map(radius).fold(0.0, f64::max);
        let size = self.polynomials.iter().fold(1.0, |most: f64, p| most.max(p[0].abs()));
        let rest = self.rest_radius();
        if self.shape.variables == 0 || rest <= LARGEST_REST * own || rest <= TINY_REST * size {
            return None;
        }
        let (mut middles, mut radii) = (Vec::new(), Vec::new());
        for p in &self.polynomials {
            // What is not linear is a box around its middle.
            let mut curved = p.clone();
            curved[..=self.shape.variables].fill(0.0);
            let around = self.shape.range(&curved) + FloatInterval::point(p[0]);
            let middle = around.midpoint();
            radii.push((around - FloatInterval::point(middle)).magnitude());
            middles.push(middle);
        }
        let columns = (1..=self.shape.variables).map(|k| self.polynomials.iter().map(|p| p[k]).collect()).collect();
        let (frame, mut lengths) = self.rest.around(columns, &radii);
        // The longest edges are the variables.
        let mut order: Vec<usize> = (0..frame.len()).collect();
        order.sort_by(|i, j| lengths[*j].total_cmp(&lengths[*i]));
        let longest = order.first().map_or(0.0, |k| lengths[*k]);
        order.retain(|k| lengths[*k] > SHORT_EDGE * longest);
        order.truncate(MOST_VARIABLES);
        let shape = Shape::new(order.len(), degree_of(order.len()));
        let mut rounded = vec![Bound::ZERO; middles.len()];
        let mut polynomials = vec![vec![0.0; shape.size()]; middles.len()];
        for (i, polynomial) in polynomials.iter_mut().enumerate() {
            polynomial[0] = middles[i];
            for (variable, k) in order.iter().enumerate() {
                let exact = FloatInterval::point(frame[*k][i]) * FloatInterval::point(lengths[*k]);
                let near = exact.midpoint();
                polynomial[1 + variable] = near;
                rounded[i] = rounded[i] + Bound::of((exact - FloatInterval::point(near)).magnitude());
            }
        }
        order.iter().for_each(|k| lengths[*k] = 0.0);
        let around = Cascade::of_edges(frame, lengths).plus(&values(&rounded))?;
        let found = Set { shape: Arc::new(shape), polynomials, rest: around };
        // With more wide numbers than variables the rest stays, and the set would only grow.
        if found.rest_radius() > rest * LEAST_GAIN {
            return None;
        }
        // A parallelepiped around a box, as after a jump, may be much wider than the box.
        let hull = self.hull();
        Some(if found.width() > longest_edge(&hull) * MOST_GROWTH { Set::of_box(&hull) } else { found })
    }

    /// The set plus a box; `None` where it is not bounded.
    pub fn plus(&self, shift: &[FloatInterval]) -> Option<Self> {
        // The middle goes to the polynomials, where it is rounded.
        let (mut set, mut radii) = (self.clone(), Vec::with_capacity(shift.len()));
        for (polynomial, x) in set.polynomials.iter_mut().zip(shift) {
            let before = FloatInterval::point(polynomial[0]);
            polynomial[0] += x.midpoint();
            radii.push((before + x - FloatInterval::point(polynomial[0])).magnitude());
        }
        set.rest = set.rest.plus(&radii)?;
        Some(set)
    }
}
