//! Complex roots of integer polynomials, isolated in discs.
//!
//! **Theorem** (Smith 1970, by Gershgorin's theorem on a companion matrix). Let `f` have degree `m` and leading coefficient
//! `c`, and let `z_1, .., z_m` be different. All roots lie in the union of the discs around `z_i` with radius
//! `m |f(z_i)| / |c prod_{j != i} (z_i - z_j)|`, and a disc that meets no other one holds exactly one root.

use super::enclosed::bits;
use super::{Polynomial, RealRoot};
use arithmetic::{Complex, Dyadic, Field, Interval, Number, Rational, Ring};
use num_traits::ToPrimitive;

/// Bits beyond what the digits need: more than a start in floats can be wrong by and still lead to its root.
const SPARE_BITS: u32 = 64;

/// Steps of the search in floats.
const MOST_STEPS: usize = 500;

/// Enclosures of the roots in the upper half plane of a polynomial without multiple roots, given all its real roots, to
/// `digits` digits of the modulus. `None` where the search fails.
pub(super) fn complex_roots(f: &Polynomial, real: &[RealRoot], digits: u32) -> Option<Vec<Complex<Interval>>> {
    let pairs = (f.degree() - real.len()) / 2;
    let mut starts = aberth(f)?;
    starts.sort_by(|a, b| b.1.total_cmp(&a.1));
    starts.truncate(pairs);
    isolated(f, real, &starts, digits, bits(digits) + SPARE_BITS)
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
    let radii = radii(&coefficients, &centres)?;
    if !are_apart(&centres, &radii) {
        return None;
    }
    upper.iter().zip(&radii).map(|(z, r)| disc(z, r, digits, precision)).collect()
}

/// Smith's radii around the centres, rounded up, where these are as many as the degree.
fn radii(coefficients: &[Interval], centres: &[Complex<Interval>]) -> Option<Vec<Dyadic>> {
    let lead = Complex::real(coefficients.last()?.clone());
    let mut radii = Vec::new();
    for (i, z) in centres.iter().enumerate() {
        let others = centres.iter().enumerate().filter(|&(j, _)| j != i);
        let product = others.fold(lead.clone(), |product, (_, other)| product * (z.clone() - other));
        let quotient = horner(coefficients, z).0.over(&product).ok()?;
        let radius = quotient.norm_squared().sqrt().ok()? * z.re.integer(centres.len() as i64);
        radii.push(radius.hi().clone());
    }
    (radii.len() + 1 == coefficients.len()).then_some(radii)
}

/// Whether no two discs have a point in common.
fn are_apart(centres: &[Complex<Interval>], radii: &[Dyadic]) -> bool {
    let apart = |i: usize, j: usize| {
        let distance = (centres[i].clone() - &centres[j]).norm_squared().sqrt();
        distance.is_ok_and(|distance| *distance.lo() > radii[i].plus(&radii[j]))
    };
    (0..centres.len()).all(|i| (0..i).all(|j| apart(i, j)))
}

/// The square around a disc, where it lies in the upper half plane and has the digits that are asked for.
fn disc(z: &Complex<Interval>, r: &Dyadic, digits: u32, precision: u32) -> Option<Complex<Interval>> {
    let widened = |x: &Interval| Interval::between(x.lo().plus(&r.negated()), x.hi().plus(r), precision);
    let (re, im) = (widened(&z.re), widened(&z.im));
    let modulus = z.norm_squared().sqrt().ok()?;
    let thin = r.top() + i64::from(bits(digits)) + 2 <= modulus.lo().top();
    (thin && im.lo().is_positive()).then_some(Complex::new(re, im))
}

#[cfg(test)]
mod tests {
    use super::*;
    use arithmetic::rational;

    fn number(x: Rational) -> Interval {
        Interval::from_rational(&x, 200)
    }

    fn at(re: (i64, i64), im: (i64, i64)) -> Complex<Interval> {
        Complex::new(number(rational(re.0, re.1)), number(rational(im.0, im.1)))
    }

    fn dyadic(x: f64) -> Dyadic {
        Dyadic::from_f64(x).expect("finite")
    }

    fn integers(coefficients: &[i64]) -> Polynomial {
        Polynomial::new(coefficients.iter().map(|&c| c.into()).collect())
    }

    #[test]
    fn radii_are_those_of_the_theorem() {
        // 3 (z² + 1) (z - 2) at i/2, -i/2 and 3: |f| = 3 (3/4) sqrt(17/4) and 30, products 1 sqrt(37/4) and 37/4.
        let coefficients = [-6, 3, -6, 3].map(|c| number(rational(c, 1)));
        let centres = [at((0, 1), (1, 2)), at((0, 1), (-1, 2)), at((3, 1), (0, 1))];
        let found = radii(&coefficients, &centres).expect("radii");
        let side = 2.25 * (17.0f64 / 37.0).sqrt();
        for (radius, expected) in found.iter().zip([side, side, 90.0 / (3.0 * 9.25)]) {
            assert!((radius.to_f64() - expected).abs() < 1e-14, "{} {expected}", radius.to_f64());
        }
        // Rounded up: 2 |f(i)| / (3 |2i|) = 2 |9 - 3|/ 6 = 2 of 3 z² + 9 exactly, with less precision above it.
        let exact = radii(&[9, 0, 3].map(|c| number(rational(c, 1))), &[at((0, 1), (1, 1)), at((0, 1), (-1, 1))]);
        assert!(exact.expect("radii").iter().all(|r| r.to_rational() >= rational(2, 1) && r.to_f64() < 2.0 + 1e-15));
        // Equal centres, and too few.
        assert!(radii(&coefficients, &[centres[0].clone(), centres[0].clone(), centres[2].clone()]).is_none());
        assert!(radii(&coefficients, &centres[..2]).is_none());
    }

    #[test]
    fn discs_that_touch_are_not_apart() {
        let centres = [at((0, 1), (1, 1)), at((0, 1), (-1, 1)), at((9, 1), (0, 1))];
        let apart = |radii: [f64; 3]| are_apart(&centres, &radii.map(dyadic));
        assert!(apart([1.0, 0.999, 1.0]) && apart([0.0, 0.0, 9.0]));
        assert!(!apart([1.0, 1.0, 1.0]) && !apart([2.5, 0.0, 0.0]));
        assert!(!apart([0.5, 0.5, 9.0]) && !apart([0.5, 9.0, 0.5]));
        // sqrt 2 with eight bits: what counts is the lower end.
        let one = Interval::from_rational(&rational(1, 1), 8);
        let pair = [Complex::real(one.zero()), Complex::new(one.clone(), one.clone())];
        let root = (one.clone() + &one).sqrt().expect("a root");
        assert!(root.lo() < root.hi());
        assert!(!are_apart(&pair, &[root.lo().clone(), dyadic(0.0)]));
        assert!(are_apart(&pair, &[root.lo().plus(&dyadic(-1e-9)), dyadic(0.0)]));
    }

    #[test]
    fn squares_hold_the_disc_to_the_digits_in_the_upper_half_plane() {
        let power = |k: i32| dyadic(2f64.powi(k));
        let with = |centre: &Complex<Interval>, r: &Dyadic| disc(centre, r, 3, 200);
        // Three digits: ten bits, and one for the radius. The modulus is 1.
        let found = with(&at((0, 1), (1, 1)), &power(-12)).expect("thin");
        assert_eq!(found.re.to_rationals(), (rational(-1, 4096), rational(1, 4096)));
        assert_eq!(found.im.to_rationals(), (rational(4095, 4096), rational(4097, 4096)));
        assert!(with(&at((0, 1), (1, 1)), &power(-11)).is_none());
        assert!(with(&at((0, 1), (-1, 1)), &power(-12)).is_none() && with(&at((1, 1), (0, 1)), &power(-12)).is_none());
        // Here the modulus is only known to be a little less than 1, if it is not 1.
        let one = at((3, 5), (4, 5));
        assert!(with(&one, &power(-13)).is_some() && with(&one, &power(-12)).is_none());
        // Around a centre that is only known to lie in an interval.
        let between = |lo, hi| Interval::hull_of_rationals(&lo, &hi, 200);
        let (low, high) = (rational(1, 1), rational(4097, 4096));
        let wide = Complex::new(between(low.clone(), high.clone()), between(low.clone(), high.clone()));
        let found = with(&wide, &power(-12)).expect("thin");
        let r = rational(1, 4096);
        assert_eq!(found.re.to_rationals(), (&low - &r, &high + &r));
        assert_eq!(found.im.to_rationals(), (low - &r, high + r));
        // A disc that has the digits, but reaches the axis.
        let flat = at((1, 1), (1, 1 << 13));
        assert!(with(&flat, &power(-14)).is_some() && with(&flat, &power(-13)).is_none());
    }

    #[test]
    fn starts_that_miss_a_root_and_too_few_bits_are_refused() {
        // (z² + 1) (z² + 4) (z - 3)
        let f = integers(&[-12, 4, -15, 5, -3, 1]);
        let real = f.roots_in(&rational(-9, 1), &rational(9, 1));
        let found = |starts: &[(f64, f64)], digits| isolated(&f, &real, starts, digits, 64);
        let roots = found(&[(0.1, 1.1), (0.1, 1.9)], 9).expect("discs");
        for (root, im) in roots.iter().zip([1, 2]) {
            assert!(root.re.contains_zero() && root.im.contains(&rational(im, 1)));
        }
        assert!(found(&[(0.1, 1.1), (0.1, -1.9)], 9).is_none() && found(&[(0.1, 1.1), (0.2, 1.0)], 9).is_none());
        assert!(found(&[(0.1, 1.1)], 9).is_none() && found(&[(0.1, 1.1), (0.1, 1.9)], 40).is_none());
        assert!(isolated(&f, &[], &[(0.1, 1.1), (0.1, 1.9)], 9, 64).is_none());
    }

    #[test]
    fn few_digits_of_roots_and_close_pairs() {
        let f = integers(&[5, 2, 3]);
        let root = complex_roots(&f, &[], 1).expect("a pair").remove(0);
        assert!(root.re.contains(&rational(-1, 3)) && root.im.square().contains(&rational(14, 9)));
        assert!(root.re.width().to_f64() < 0.1);
        // z (z² + 1)
        let f = integers(&[0, 1, 0, 1]);
        let real = f.roots_in(&rational(-9, 1), &rational(9, 1));
        assert!(complex_roots(&f, &real, 3).expect("a pair")[0].im.contains(&rational(1, 1)));
        // (z² + 1) (z² + 1 + 2^-k) 2^k
        for k in 1..=20 {
            let power = 1i64 << k;
            let f = integers(&[power + 1, 0, 2 * power + 1, 0, power]);
            let roots = complex_roots(&f, &[], 20).unwrap_or_else(|| panic!("{k}"));
            let squares = [rational(1, 1), rational(power + 1, power)];
            for square in &squares {
                assert_eq!(roots.iter().filter(|z| z.im.square().contains(square)).count(), 1, "{k}");
            }
            assert!(roots.iter().all(|z| z.re.contains_zero() && z.im.width().to_f64() < 1e-20), "{k}");
        }
    }

    #[test]
    fn few_bits_for_a_close_pair() {
        // (z² + 1) (z² + 1 + 2^-20) 2^20: refused, or each square holds one root.
        let power = 1i64 << 20;
        let f = integers(&[power + 1, 0, 2 * power + 1, 0, power]);
        let (first, second) = (rational(1, 1), rational(power + 1, power));
        let starts = [(0.0, 1.0), (0.0, second.to_f64().expect("a float").sqrt())];
        let found = |precision| isolated(&f, &[], &starts, 1, precision);
        for precision in 8..80 {
            for square in [&first, &second] {
                let holding = |roots: &Vec<Complex<Interval>>| {
                    roots.iter().filter(|z| z.im.square().contains(square)).count() == 1
                };
                assert!(found(precision).as_ref().is_none_or(holding), "{precision}");
            }
        }
        assert!(found(80).is_some());
    }
}
