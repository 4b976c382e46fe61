//! Complex roots of integer polynomials, isolated in discs.
//!
//! **Theorem** (Smith 1970, by Gershgorin's theorem on a companion matrix). Let `f` have degree `m` and leading coefficient
//! `c`, and let `z_1, .., z_m` be different. All roots lie in the union of the discs around `z_i` with radius
//! `m |f(z_i)| / |c prod_{j != i} (z_i - z_j)|`, and a disc that meets no other one holds exactly one root.

use super::closed_form::bits;
use super::{Polynomial, RealRoot};
use arithmetic::{Complex, Dyadic, Field, Interval, Rational, Real, Ring};
use num_traits::ToPrimitive;

/// Precision at which isolating roots is given up, beyond what the digits need.
const MOST_DOUBLINGS: u32 = 5;

/// Steps of the search in floats.
const MOST_STEPS: usize = 500;

/// Enclosures of the roots in the upper half plane of a polynomial without multiple roots, given all its real roots, to
/// `digits` digits of the modulus. `None` where the search fails.
pub(super) fn complex_roots(f: &Polynomial, real: &[RealRoot], digits: u32) -> Option<Vec<Complex<Interval>>> {
    let pairs = (f.degree() - real.len()) / 2;
    let mut starts = aberth(f)?;
    starts.sort_by(|a, b| b.1.total_cmp(&a.1));
    starts.truncate(pairs);
    let mut precision = bits(digits) + 64;
    for _ in 0..MOST_DOUBLINGS {
        if let Some(found) = isolated(f, real, &starts, digits, precision) {
            return Some(found);
        }
        precision *= 2;
    }
    None
}

/// The method of Ehrlich and Aberth in floats: no promise.
fn aberth(f: &Polynomial) -> Option<Vec<(f64, f64)>> {
    let lead = Rational::from_integer(f.coefficients().last()?.clone());
    let coefficients: Option<Vec<f64>> =
        f.coefficients().iter().map(|c| (Rational::from_integer(c.clone()) / &lead).to_f64()).collect();
    let coefficients = coefficients.filter(|all| all.iter().all(|c| c.is_finite()))?;
    let degree = f.degree();
    // Fujiwara's bound of the roots.
    let size = |(k, c): (usize, &f64)| c.abs().powf(1.0 / (degree - k) as f64);
    let radius = 2.0 * coefficients.iter().take(degree).enumerate().map(size).fold(0.0, f64::max);
    let angle = |k: usize| std::f64::consts::TAU * (k as f64 + 0.3) / degree as f64;
    let mut z: Vec<Complex<f64>> =
        (0..degree).map(|k| Complex::new(radius / 2.0 * angle(k).cos(), radius / 2.0 * angle(k).sin())).collect();
    for _ in 0..MOST_STEPS {
        let mut moved = 0.0;
        for i in 0..degree {
            let (value, slope) = horner(&coefficients, &z[i]);
            let Ok(newton) = value.over(&slope) else { continue };
            let others = (0..degree).filter(|&j| j != i).filter_map(|j| (z[i].clone() - &z[j]).recip().ok());
            let pull = others.fold(Complex::real(0.0), |sum, x| sum + x);
            let Ok(step) = newton.over(&(Complex::real(1.0) - newton.clone() * pull)) else { continue };
            moved = f64::max(moved, step.norm_squared().sqrt());
            z[i] = z[i].clone() - step;
        }
        if moved <= 1e-15 * radius {
            break;
        }
    }
    Some(z.into_iter().map(|z| (z.re, z.im)).collect())
}

/// The value and the derivative.
fn horner<T: Ring>(coefficients: &[T], z: &Complex<T>) -> (Complex<T>, Complex<T>) {
    let zero = z.zero();
    coefficients.iter().rev().fold((zero.clone(), zero), |(value, slope), c| {
        let next = value.clone() * z + Complex::real(c.clone());
        (next, slope * z + value)
    })
}

fn isolated(
    f: &Polynomial,
    real: &[RealRoot],
    starts: &[(f64, f64)],
    digits: u32,
    precision: u32,
) -> Option<Vec<Complex<Interval>>> {
    let constant = |c| Interval::from_rational(&Rational::from_integer(c), precision);
    let coefficients: Vec<Interval> = f.coefficients().iter().cloned().map(constant).collect();
    let middle = |z: Complex<Interval>| Complex::new(z.re.midpoint(precision), z.im.midpoint(precision));
    let point = |x: f64| Dyadic::from_f64(x).map(|x| Interval::between(x.clone(), x, precision));
    let mut upper = Vec::new();
    for &(re, im) in starts {
        let mut z = Complex::new(point(re)?, point(im)?);
        // Each step doubles the digits of a start that has some.
        for _ in 0..precision.ilog2() {
            let (value, slope) = horner(&coefficients, &z);
            z = middle(z - value.over(&slope).ok()?);
        }
        upper.push(z);
    }
    let mut centres = upper.clone();
    centres.extend(upper.iter().map(Complex::conj));
    for root in real {
        let mut root = root.clone();
        f.refine(&mut root, precision);
        centres.push(Complex::real(root.enclosure(precision).midpoint(precision)));
    }
    let distance = |a: &Complex<Interval>, b: &Complex<Interval>| (a.clone() - b).norm_squared().sqrt().ok();
    let lead = Complex::real(coefficients.last()?.clone());
    let mut radii = Vec::new();
    for (i, z) in centres.iter().enumerate() {
        let others = centres.iter().enumerate().filter(|&(j, _)| j != i);
        let product = others.fold(lead.clone(), |product, (_, other)| product * (z.clone() - other));
        let quotient = horner(&coefficients, z).0.over(&product).ok()?;
        let radius = quotient.norm_squared().sqrt().ok()? * z.re.integer(centres.len() as i64);
        radii.push(radius.hi().clone());
    }
    let apart = |i: usize, j: usize| {
        let distance = distance(&centres[i], &centres[j]);
        distance.is_some_and(|distance| *distance.lo() > radii[i].plus(&radii[j]))
    };
    if !(0..centres.len()).all(|i| (0..i).all(|j| apart(i, j))) {
        return None;
    }
    let widened = |x: &Interval, r: &Dyadic| Interval::between(x.lo().plus(&r.negated()), x.hi().plus(r), precision);
    let enclosed = upper.iter().zip(&radii).map(|(z, r)| {
        let im = widened(&z.im, r);
        let modulus = z.norm_squared().sqrt().ok()?;
        let thin = r.top() + i64::from(bits(digits)) + 2 <= modulus.lo().top() || r.is_zero();
        (thin && im.lo().is_positive()).then(|| Complex::new(widened(&z.re, r), im))
    });
    enclosed.collect()
}
