//! The distance from the expansion: a sum of parallelepipeds of different ages.
//!
//! A parallelepiped that is put into another frame at every step grows by that alone. So what a step adds stays a term of its own, which later steps only
//! multiply, and two terms that were united as often as each other are united: each error is put into another frame as often as the number of steps has
//! binary digits.

use super::IntervalVector;
use super::linear::{IntervalMatrix, departure, frame_of, unit_columns};
use arithmetic::FloatInterval;

/// All sums of `G r` over the terms, with `|r_i| <= radii_i`.
#[derive(Debug, Clone)]
pub(super) struct Cascade {
    size: usize,
    /// The oldest first.
    terms: Vec<Term>,
}

#[derive(Debug, Clone)]
struct Term {
    /// How often it was united.
    level: u32,
    /// The columns of `G`.
    columns: Vec<Vec<f64>>,
    radii: Vec<f64>,
}

fn point(x: f64) -> FloatInterval {
    FloatInterval::point(x)
}

const ZERO: FloatInterval = FloatInterval::ZERO;

/// `sum a_k x_k`.
fn dot(a: &[FloatInterval], x: &[f64]) -> FloatInterval {
    a.iter().zip(x).filter(|(_, x)| **x != 0.0).fold(ZERO, |sum, (a, x)| sum + *a * point(*x))
}

impl Term {
    fn of_box(radii: &[f64]) -> Self {
        Term { level: 0, columns: unit_columns(radii.len()), radii: radii.to_vec() }
    }

    /// Adds a bound of coordinate `i` to a sum.
    fn add_to(&self, sum: FloatInterval, i: usize) -> FloatInterval {
        self.columns.iter().zip(&self.radii).fold(sum, |sum, (column, r)| sum + point(column[i].abs()) * point(*r))
    }
}

impl Cascade {
    /// All `x` with `|x_i| <= radii_i`.
    pub fn of_box(radii: &[f64]) -> Self {
        Cascade { size: radii.len(), terms: vec![Term::of_box(radii)] }
    }

    /// A box that contains the set, by its radii.
    pub fn radii(&self) -> Vec<f64> {
        (0..self.size).map(|i| self.terms.iter().fold(ZERO, |sum, term| term.add_to(sum, i)).hi()).collect()
    }

    /// A parallelepiped, by its edges and their half lengths.
    pub fn of_edges(columns: Vec<Vec<f64>>, radii: Vec<f64>) -> Self {
        Cascade { size: radii.len(), terms: vec![Term { level: 0, columns, radii }] }
    }

    /// A parallelepiped around all sums of the set and of the columns times numbers from -1 to 1: its edges, each as a column of at most unit length and its
    /// half length.
    pub fn around(&self, columns: Vec<Vec<f64>>, radii: &[f64]) -> (Vec<Vec<f64>>, Vec<f64>) {
        let mut terms = self.terms.clone();
        let lengths = vec![1.0; columns.len()];
        terms.extend([Term { level: 0, columns, radii: lengths }, Term::of_box(radii)]);
        let term = united(0, &terms);
        (term.columns, term.radii)
    }

    /// All `derivative x + y` for `x` in the set and `|y_i| <= added_i`. `None` where a bound is not finite.
    pub fn mapped(&self, derivative: &IntervalMatrix, added: &[f64]) -> Option<Self> {
        let mut added: IntervalVector = added.iter().map(|x| point(*x)).collect();
        let mut terms = Vec::with_capacity(self.terms.len() + 1);
        for term in &self.terms {
            let mut columns = Vec::with_capacity(self.size);
            for (column, r) in term.columns.iter().zip(&term.radii) {
                let image: IntervalVector = derivative.iter().map(|row| dot(row, column)).collect();
                let middle: Vec<f64> = image.iter().map(FloatInterval::midpoint).collect();
                for (sum, (x, c)) in added.iter_mut().zip(image.iter().zip(&middle)) {
                    *sum = *sum + point((*x - point(*c)).magnitude()) * point(*r);
                }
                columns.push(middle);
            }
            terms.push(Term { level: term.level, columns, radii: term.radii.clone() });
        }
        let radii: Vec<f64> = added.iter().map(FloatInterval::hi).collect();
        Cascade { size: self.size, terms }.plus(&radii)
    }

    /// The set plus a box.
    pub fn plus(mut self, radii: &[f64]) -> Option<Self> {
        self.terms.push(Term::of_box(radii));
        while let [.., older, newer] = &self.terms[..]
            && older.level <= newer.level
        {
            let level = newer.level + 1;
            let last = self.terms.split_off(self.terms.len() - 2);
            self.terms.push(united(level, &last));
        }
        let is_finite = |term: &Term| term.radii.iter().chain(term.columns.iter().flatten()).all(|x| x.is_finite());
        self.terms.iter().all(is_finite).then_some(self)
    }
}

/// A parallelepiped around the sum of some terms.
fn united(level: u32, terms: &[Term]) -> Term {
    let size = terms.first().map_or(0, |term| term.radii.len());
    let columns: Vec<(&Vec<f64>, f64)> =
        terms.iter().flat_map(|term| term.columns.iter().zip(term.radii.iter().copied())).collect();
    let lengths: Vec<Vec<f64>> = columns.iter().map(|(column, r)| column.iter().map(|x| x * r).collect()).collect();
    let frame = frame_of(lengths);
    let Some(lost) = departure(&frame) else {
        let radii = (0..size).map(|i| terms.iter().fold(ZERO, |sum, term| term.add_to(sum, i)).hi());
        return Term { level, ..Term::of_box(&radii.collect::<Vec<_>>()) };
    };
    let along = |row: &IntervalVector| {
        columns.iter().fold(ZERO, |sum, (column, r)| sum + point(dot(row, column).magnitude()) * point(*r))
    };
    let coordinates: IntervalVector = frame.transposed().iter().map(along).collect();
    // With F⁻¹ = (I + E)Fᵀ and ‖E‖ <= lost.
    let most = coordinates.iter().map(FloatInterval::hi).fold(0.0, f64::max);
    let slack = point(lost) * point(most);
    Term { level, radii: coordinates.iter().map(|r| (*r + slack).hi()).collect(), columns: frame.into_columns() }
}
