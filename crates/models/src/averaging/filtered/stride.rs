//! Many steps of what is left of a flock's way at once, in double precision: by Chebyshev polynomials of the transition matrix, as a leap.
//!
//! `notes/exact_flocks.md`, step 15.

use super::ahead::{Ahead, average};
use super::leap::degree_for;
use arithmetic::{Cancelled, Progress};

/// Fewer steps are as quick one by one.
pub(super) const SHORTEST_STRIDE: u64 = 512;

/// More steps are made in several strides.
const LONGEST_STRIDE: u64 = 1 << 20;

/// What double precision needs: the polynomials beyond that degree add up to less than `2^-71`.
const LIMBS: usize = 1;

/// The probabilities of the places 0, 1, .. of a walk of so many steps, on both sides together, up to a place; relative errors are below
/// `4 (degree + 1)` units of rounding, and what is beyond is shared out.
fn walk(steps: u64, degree: u64) -> Vec<f64> {
    let mut places = vec![0.0; degree as usize + 1];
    let mut number = 1.0;
    for place in (0..=degree - (steps - degree) % 2).rev().step_by(2) {
        places[place as usize] = if place == 0 { number } else { 2.0 * number };
        number *= (steps + place) as f64 / (steps + 2 - place) as f64;
    }
    let total: f64 = places.iter().sum();
    places.iter_mut().for_each(|p| *p /= total);
    places
}

impl Ahead<'_> {
    /// As many of these steps as one stride has; whether it was done, as far as there is room for its rounding.
    pub(super) fn stride(&mut self, steps: u64, progress: &dyn Progress) -> Result<bool, Cancelled> {
        let steps = steps.min(LONGEST_STRIDE);
        let degree = degree_for(steps, LIMBS);
        let places = walk(steps, degree);
        let (mut before, mut now) = (self.rest.clone(), self.rest.clone());
        let mut next = vec![0.0; now.len()];
        let mut sum: Vec<f64> = now.iter().map(|z| places[0] * z).collect();
        let (mut largest, mut steepest) = (self.largest, 0.0f64);
        for (j, p) in places.iter().enumerate().skip(1) {
            progress.checkpoint()?;
            steepest = steepest.max(average(self.part, self.dimension, &now, &mut next).1);
            // T_(j+1) = 2 P T_j - T_(j-1), but T_1 = P.
            for ((w, old), z) in next.iter_mut().zip(&before).zip(&mut sum) {
                if j > 1 {
                    *w = 2.0 * *w - old;
                }
                *z += p * *w;
                largest = largest.max(w.abs());
            }
            std::mem::swap(&mut before, &mut now);
            std::mem::swap(&mut now, &mut next);
        }
        let added = self.stride_error(degree as f64 + 1.0, largest, steepest);
        // Not again before that has cost less than single steps.
        self.patient = self.steps + 4 * degree;
        if added.is_nan() || added > self.spare {
            return Ok(false);
        }
        self.spare -= added;
        self.error += added;
        self.largest = sum.iter().fold(0.0, |most: f64, z| most.max(z.abs()));
        self.rest = sum;
        self.steps += steps;
        self.patient = self.steps;
        Ok(true)
    }

    /// What a difference of two is off by after a stride with so many polynomials that have no larger numbers than this, nor larger differences
    /// of neighbours.
    fn stride_error(&self, count: f64, largest: f64, steepest: f64) -> f64 {
        let root = (self.part.reciprocals.iter().sum::<f64>() * (1.0 + 1e-9)).sqrt();
        let ulp = f64::EPSILON * (self.dimension as f64).sqrt();
        // Each step of the recurrence errs by this, which becomes no more than as many times as large as steps follow.
        let each = self.rounding * steepest + 4.0 * ulp * largest;
        let recurrence = root * each * count * count / 2.0;
        let sums = 16.0 * ulp * count * largest;
        let beyond = root * ulp * 2f64.powi(-17) * largest;
        2.0 * (recurrence + sums + beyond) * 1.001
    }
}

#[cfg(test)]
mod tests;
