//! Polynomials in several variables from -1 to 1, cut at a total degree: which monomials there are, and how they multiply.

use super::bound::Bound;
use arithmetic::{FloatInterval, Ring};
use std::sync::{Arc, OnceLock};

/// The degree in the time of what is measured on a single motion.
const DEGREE_OF_POINTS: usize = 10;

/// The monomials of so many variables up to a total degree, by degree. A polynomial is the list of its coefficients in this order.
#[derive(Debug, Clone)]
pub(super) struct Shape {
    pub variables: usize,
    pub degree: usize,
    /// Exponents of each monomial.
    pub exponents: Vec<Vec<u8>>,
    /// Where the monomials of each degree begin; at the end their number.
    pub starts: Vec<usize>,
    /// For each monomial those that it may be multiplied with, and the product.
    products: Vec<Vec<(u32, u32)>>,
    /// Whether a monomial is a square, and so not negative.
    is_even: Vec<bool>,
    /// For each monomial and variable the monomial with one power less, where there is one.
    lower: Vec<Vec<u32>>,
    /// With the time as one more variable, the last one.
    timed: OnceLock<Timed>,
}

/// A shape, and where it has the monomials of another one.
#[derive(Debug, Clone)]
pub(super) struct Timed {
    pub shape: Arc<Shape>,
    pub places: Vec<usize>,
}

impl Shape {
    pub fn new(variables: usize, degree: usize) -> Self {
        let degree = if variables == 0 { 0 } else { degree };
        let mut exponents = vec![vec![0; variables]];
        let mut starts = vec![0, 1];
        for _ in 1..=degree {
            // Every monomial of the next degree once: the last variable that it has is raised, or a later one.
            let level = exponents[starts[starts.len() - 2]..].to_vec();
            for exponent in level {
                let first = exponent.iter().rposition(|e| *e > 0).unwrap_or(0);
                exponents.extend((first..variables).map(|k| {
                    let mut next: Vec<u8> = exponent.clone();
                    next[k] += 1;
                    next
                }));
            }
            starts.push(exponents.len());
        }
        let place: std::collections::HashMap<&Vec<u8>, usize> = exponents.iter().zip(0..).collect();
        let total = |e: &[u8]| e.iter().map(|k| usize::from(*k)).sum::<usize>();
        let row = |a: &Vec<u8>| {
            let most = starts[degree - total(a) + 1];
            let product = |b: &Vec<u8>| place[&a.iter().zip(b).map(|(x, y)| x + y).collect::<Vec<u8>>()] as u32;
            exponents[..most].iter().zip(0..).map(|(b, j)| (j, product(b))).collect()
        };
        let products = exponents.iter().map(row).collect();
        let is_even = exponents.iter().map(|e| e.iter().all(|k| k % 2 == 0)).collect();
        let less = |e: &Vec<u8>, k: usize| {
            let mut less = e.clone();
            less[k] = less[k].saturating_sub(1);
            place[&less] as u32
        };
        let lower = exponents.iter().map(|e| (0..variables).map(|k| less(e, k)).collect()).collect();
        Shape { variables, degree, starts, products, is_even, lower, timed: OnceLock::new(), exponents }
    }

    /// The shape with the time as one more variable.
    pub fn timed(&self) -> &Timed {
        self.timed.get_or_init(|| {
            let shape =
                Shape::new(self.variables + 1, if self.variables == 0 { DEGREE_OF_POINTS } else { self.degree });
            let places: std::collections::HashMap<&[u8], usize> =
                shape.exponents.iter().zip(0..).map(|(e, place)| (&e[..], place)).collect();
            let place = |e: &Vec<u8>| places[&[&e[..], &[0]].concat()[..]];
            let places = self.exponents.iter().map(place).collect();
            Timed { shape: Arc::new(shape), places }
        })
    }

    /// The polynomial on the half of the cube on one side of a variable, in a variable from -1 to 1 again: `s = (side + t)/2`, `side` -1 or 1.
    pub fn half(&self, a: &[f64], variable: usize, side: f64) -> Vec<f64> {
        let mut sum = vec![0.0; a.len()];
        for (place, (c, exponents)) in a.iter().zip(&self.exponents).enumerate().filter(|(_, (c, _))| **c != 0.0) {
            let power = i32::from(exponents[variable]);
            let (mut place, scaled, mut binomial) = (place, c * 0.5f64.powi(power), 1.0);
            // From the highest power of t; binomial coefficients are exact, so that each term is rounded once.
            for j in (0..=power).rev() {
                sum[place] += scaled * binomial;
                place = self.lower[place][variable] as usize;
                binomial = side * binomial * f64::from(j) / f64::from(power - j + 1);
            }
        }
        sum
    }

    /// The number of monomials.
    pub fn size(&self) -> usize {
        self.exponents.len()
    }

    /// Adds the product of two polynomials to a third one, without what has a higher degree.
    pub fn multiply_add(&self, a: &[f64], b: &[f64], sum: &mut [f64]) {
        for (x, row) in a.iter().zip(&self.products).filter(|(x, _)| **x != 0.0) {
            row.iter().for_each(|&(j, k)| sum[k as usize] += x * b[j as usize]);
        }
    }

    /// A bound of the number of terms that add up to one coefficient of a product.
    pub fn most_terms(&self) -> f64 {
        // Of a monomial with exponents e_i, the product of (e_i + 1); most where they are spread out.
        2f64.powi(self.degree as i32)
    }

    /// The sums of the absolute coefficients of each degree.
    pub fn norms(&self, a: &[f64]) -> impl Iterator<Item = Bound> {
        self.starts.windows(2).map(|w| Bound::total(a[w[0]..w[1]].iter().copied()))
    }

    /// Encloses the value of a polynomial at a point.
    pub fn value(&self, a: &[f64], at: &[f64]) -> FloatInterval {
        let mut sum = FloatInterval::ZERO;
        for (x, exponents) in a.iter().zip(&self.exponents).filter(|(x, _)| **x != 0.0) {
            let powers = exponents.iter().zip(at).map(|(e, s)| FloatInterval::point(*s).power(u64::from(*e)));
            sum = sum + powers.fold(FloatInterval::point(*x), |product, power| product * power);
        }
        sum
    }

    /// Encloses the values of a polynomial on the whole box.
    pub fn range(&self, a: &[f64]) -> FloatInterval {
        let (mut lo, mut hi, mut size) = (a[0], a[0], a[0].abs());
        for (x, is_even) in a.iter().zip(&self.is_even).skip(1).filter(|(x, _)| **x != 0.0) {
            size += x.abs();
            match is_even {
                true if *x > 0.0 => hi += x,
                true => lo += x,
                false => (lo, hi) = (lo - x.abs(), hi + x.abs()),
            }
        }
        // Each of n sums is wrong by half a step of a number of at most the size.
        let slack = if self.size() == 1 { 0.0 } else { size * f64::EPSILON * (self.size() + 1) as f64 };
        FloatInterval::between(lo - slack, hi + slack)
    }
}
