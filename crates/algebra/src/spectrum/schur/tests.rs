//! The bounds of the theorem against their formulas, and triangular forms of matrices that are hard to bring to one.

use super::super::testing::{assert_equals, whole};
use super::*;
use arithmetic::Rational;
use num_traits::Signed;

fn complex(re: f64, im: f64) -> c64 {
    c64::new(re, im)
}

fn product(a: &Mat<c64>, b: &Mat<c64>) -> Mat<c64> {
    let order = a.nrows();
    Mat::from_fn(order, order, |i, j| (0..order).fold(ZERO, |sum, k| sum + a[(i, k)] * b[(k, j)]))
}

/// The Frobenius norm, rounded up.
fn frobenius(a: &Mat<c64>) -> f64 {
    let squares = (0..a.nrows()).flat_map(|i| (0..a.ncols()).map(move |j| (i, j))).map(|place| a[place].norm_sqr());
    squares.sum::<f64>().sqrt() * SLACK
}

fn rows_of(order: usize, error: f64, entry: impl Fn(usize, usize) -> f64) -> Vec<Row> {
    let row = |i: usize| (0..order).map(|j| (j, entry(i, j), error)).filter(|(_, x, _)| *x != 0.0).collect();
    (0..order).map(row).collect()
}

#[test]
fn norms_are_rounded_up_and_see_the_least_entries() {
    let a = Mat::from_fn(2, 2, |i, j| [[complex(1.0, -2.0), complex(2.0, 0.0)], [complex(0.0, 4.0), ZERO]][i][j]);
    assert_equals(norm(&a), 5.0 * SLACK, "1 + 4 + 4 + 16");
    assert!(norm(&Mat::from_fn(1, 1, |_, _| complex(1e-170, 1e-170))) >= 1e-169);
    assert_eq!([(0, 0), (0, 1), (1, 0), (1, 1)].map(|(i, j)| unit(i, j).re), [1.0, 0.0, 0.0, 1.0]);
}

/// Whole numbers and quarters, so that nothing is rounded but where the formula says so.
#[test]
fn the_perturbation_is_the_formula() {
    let errors = [0.0f64, 0.25, 1.0, 9.0];
    for (order, error) in [1, 2, 3, 5].into_iter().flat_map(|order| errors.map(|error| (order, error))) {
        let a = Mat::from_fn(order, order, |i, j| complex(whole(i, j), 0.0));
        // Exactly unitary; and with an entry beside the diagonal.
        let turned = |i: usize, j: usize| match (i + 1) % order == j {
            true => [complex(0.0, 1.0), complex(-1.0, 0.0), complex(1.0, 0.0)][i % 3],
            false => ZERO,
        };
        let tilted = |i: usize, j: usize| if (i, j) == (0, 1) { complex(0.0, -0.25) } else { unit(i, j) };
        let longer = |i: usize, j: usize| unit(i, j) * complex(if i == 0 { 1.125 } else { 1.0 }, 0.0);
        for z in
            [Mat::from_fn(order, order, turned), Mat::from_fn(order, order, tilted), Mat::from_fn(order, order, longer)]
        {
            let adjoint = Mat::from_fn(order, order, |i, j| z[(j, i)].conj());
            let gram = product(&adjoint, &z);
            let from_unit = frobenius(&Mat::from_fn(order, order, |i, j| gram[(i, j)] - unit(i, j)));
            let own = product(&adjoint, &product(&a, &z));
            let other =
                Mat::from_fn(order, order, |i, j| if i <= j { complex(whole(j, i), whole(i, 2)) } else { ZERO });
            for t in [own, other] {
                let (image, moved) = (product(&a, &z), product(&z, &t));
                let residual = frobenius(&Mat::from_fn(order, order, |i, j| image[(i, j)] - moved[(i, j)]));
                let (rounding, size) = (8.0 * (order as f64 + 4.0) * UNIT, frobenius(&z));
                let departure = from_unit + rounding * (size * size + 1.0);
                let lost = residual + rounding * (frobenius(&a) + frobenius(&t)) * size;
                let derived = (lost + f64::sqrt(error) * SLACK * size) / (1.0 - departure) * SLACK;
                let found = perturbation(&a, error, &z, &t).expect("nearly unitary");
                assert_equals(found, derived, &format!("{order}, {error}"));
            }
        }
    }
}

/// So many vectors that the rounding of their products, `8 (n + 4) u (n + 1)`, shows.
#[test]
fn the_rounding_of_the_departure_counts() {
    let n = 120;
    let times = |x: f64| Mat::from_fn(n, n, |i, j| unit(i, j) * complex(x, 0.0));
    let (rounding, root) = (8.0 * (n as f64 + 4.0) * UNIT, (n as f64).sqrt() * SLACK);
    let lost = root + rounding * 3.0 * root * root;
    let derived = lost / (1.0 - rounding * (root * root + 1.0)) * SLACK;
    assert_equals(perturbation(&times(1.0), 0.0, &times(1.0), &times(2.0)).expect("unitary"), derived, "the identity");
}

#[test]
fn what_is_far_from_unitary_is_refused() {
    let one = Mat::from_fn(1, 1, |_, _| complex(1.0, 0.0));
    for (z, is_near) in [(1.0, true), (1.1875, true), (0.75, true), (1.25, false), (0.5, false), (f64::NAN, false)] {
        let z = Mat::from_fn(1, 1, |_, _| complex(z, 0.0));
        assert_eq!(perturbation(&one, 0.0, &z, &one).is_some(), is_near);
    }
}

/// `sqrt(‖.‖_1 ‖.‖_∞)` of `sum_k N^k/r^(k+1)`.
fn inverse_norm(above: &Mat<f64>, r: f64) -> f64 {
    let order = above.nrows();
    let mut power = Mat::<f64>::identity(order, order);
    let mut sum = Mat::<f64>::zeros(order, order);
    for k in 0..order {
        for (i, j) in (0..order).flat_map(|i| (0..order).map(move |j| (i, j))) {
            sum[(i, j)] += power[(i, j)] / r.powi(k as i32 + 1);
        }
        power = &power * above;
    }
    let rows = (0..order).map(|i| (0..order).map(|j| sum[(i, j)]).sum()).fold(0.0, f64::max);
    let columns = (0..order).map(|j| (0..order).map(|i| sum[(i, j)]).sum()).fold(0.0, f64::max);
    f64::sqrt(rows * columns)
}

#[test]
fn the_radius_is_nearly_the_least_that_is_enough() {
    for delta in [1e-14, 0.01, 3.0] {
        for order in [1, 2, 3, 6] {
            for scale in [0.0, 0.5, 1000.0] {
                let entry = |i: usize, j: usize| if i < j { scale * whole(i, j + 2).abs() } else { 0.0 };
                let above = Mat::from_fn(order, order, entry);
                let found = radius(&above, delta).expect("a radius");
                let size = delta * inverse_norm(&above, found);
                assert!(size * (1.0 + 0.99e-6) < 1.0 && size > 1.0 - 2e-6, "{order}, {delta}, {scale}: {size}");
            }
        }
        // (δ + sqrt(δ² + 4aδ))/2 for one entry a.
        let a = 7.0;
        let one = Mat::from_fn(2, 2, |i, j| if i < j { a } else { 0.0 });
        let exact = (delta + (delta * delta + 4.0 * a * delta).sqrt()) / 2.0;
        let found = radius(&one, delta).expect("a radius");
        assert!(exact < found && found < exact * (1.0 + 2e-6), "{found} {exact}");
    }
    for bad in [f64::NAN, f64::INFINITY] {
        assert!(radius(&Mat::from_fn(2, 2, |i, j| if i < j { 1.0 } else { 0.0 }), bad).is_none());
        assert!(radius(&Mat::from_fn(2, 2, |i, j| if i < j { bad } else { 0.0 }), 1.0).is_none());
    }
}

/// A matrix that is triangular already is its own form, so that the discs are known.
#[test]
fn discs_lie_around_the_diagonal_entries() {
    for (order, error) in [(1, 0.0), (2, 0.0), (4, 0.5), (4, 0.0)] {
        let entry = |i: usize, j: usize| if i <= j { whole(i, j) + 0.5 } else { 0.0 };
        let found = triangular_spectrum(&rows_of(order, error, entry)).expect("a form");
        let a = Mat::from_fn(order, order, |i, j| complex(entry(i, j), 0.0));
        let above = Mat::from_fn(order, order, |i, j| if i < j { entry(i, j).abs() } else { 0.0 });
        let errors = error * error * (order * (order + 1) / 2) as f64;
        let delta = perturbation(&a, errors, &Mat::from_fn(order, order, unit), &a).expect("unitary");
        let r = radius(&above, delta).expect("a radius") * SLACK;
        assert_eq!(found.len(), order);
        for (i, part) in found.iter().enumerate() {
            for (interval, centre) in [(&part.re, entry(i, i)), (&part.im, 0.0)] {
                let middle =
                    interval.lo().midpoint(interval.hi()).to_rational() - Rational::from_float(centre).expect("finite");
                assert!(middle.abs() <= Rational::from_float(1e-9 * r).expect("finite"), "{order}: {middle}");
                let reach = interval.width().to_f64() / 2.0;
                // Up to the outward steps beside a centre near 4.
                assert!((reach - r).abs() <= 1e-9 * r + 4e-15, "{reach} is not {r}");
            }
            assert_eq!((part.multiplicity, part.exact.is_none()), (1, true));
        }
    }
}

/// Complex eigenvalues with complex numbers above the diagonal: both parts of each count.
#[test]
fn discs_of_complex_forms_have_the_radius_of_the_theorem() {
    for order in [2, 3, 5] {
        let entry = |i: usize, j: usize| if (i + 1) % order == j { 4.0 } else { whole(i, j) };
        let a = Mat::from_fn(order, order, |i, j| complex(entry(i, j), 0.0));
        let Triangular { z, t } = Triangular::of(&a).expect("it converges");
        let modulus = |i: usize, j: usize| t[(i, j)].re.hypot(t[(i, j)].im);
        let above = Mat::from_fn(order, order, |i, j| if i < j { modulus(i, j) } else { 0.0 });
        let r = radius(&above, perturbation(&a, 0.0, &z, &t).expect("unitary")).expect("a radius") * SLACK;
        for (i, part) in triangular_spectrum(&rows_of(order, 0.0, entry)).expect("a form").iter().enumerate() {
            for (interval, centre) in [(&part.re, t[(i, i)].re), (&part.im, t[(i, i)].im)] {
                let off =
                    interval.lo().midpoint(interval.hi()).to_rational() - Rational::from_float(centre).expect("finite");
                assert!(off.abs() <= Rational::from_float(4e-15).expect("finite"), "{order}: {off}");
                let reach = interval.width().to_f64() / 2.0;
                assert!((reach - r).abs() <= 1e-9 * r + 4e-15, "{reach} is not {r}");
            }
        }
    }
}

/// `AZ = ZT` and `ZᴴZ = I` up to rounding, with nothing below the diagonal of `T`.
#[test]
fn triangular_forms_are_found() {
    let jordan = |i: usize, j: usize| f64::from(u8::from(i == j || i + 1 == j));
    let cycle = |order: usize| move |i: usize, j: usize| f64::from(u8::from((i + 1) % order == j));
    for order in [1, 2, 3, 4, 7, 12] {
        let shapes: [&dyn Fn(usize, usize) -> f64; 7] = [
            &whole,
            &jordan,
            &|i, j| jordan(j, i),
            &cycle(order),
            &|i, j| if i + j + 1 == order { 1.0 } else { 0.0 },
            &|i, j| if i <= j + 1 { whole(i, j) } else { 0.0 },
            &|_, _| 0.0,
        ];
        for (number, shape) in shapes.into_iter().enumerate() {
            let a = Mat::from_fn(order, order, |i, j| complex(shape(i, j), 0.0));
            let Triangular { z, t } = Triangular::of(&a).expect("it converges");
            assert!((0..order).all(|i| (0..i).all(|j| t[(i, j)] == ZERO)));
            let delta = perturbation(&a, 0.0, &z, &t).expect("unitary");
            assert!(delta <= 1e-13 * (order as f64 + frobenius(&a)) * order as f64, "{number} of {order}: {delta}");
        }
    }
    assert!(Triangular::of(&Mat::from_fn(3, 3, |_, _| complex(f64::NAN, 0.0))).is_none());
}

/// With the unit vectors of two complex numbers: what turns the first entry up and the second away, on both sides.
#[test]
fn rotations_are_similarities() {
    let (x, y) = (complex(0.0, 3.0), complex(4.0, 0.0));
    let a = Mat::from_fn(4, 4, |i, j| complex(whole(i, j), whole(j, i + 1)));
    let mut form = Triangular { z: Mat::from_fn(4, 4, unit), t: a.clone() };
    form.rotate(1, x, y, 0, 4);
    // Rows 1 and 2 are turned by the adjoint of z.
    let adjoint = Mat::from_fn(4, 4, |i, j| form.z[(j, i)].conj());
    let (gram, moved) = (product(&adjoint, &form.z), product(&product(&adjoint, &a), &form.z));
    let turned = [1, 2].map(|i| adjoint[(i, 1)] * x + adjoint[(i, 2)] * y);
    assert!((turned[0] - complex(5.0, 0.0)).norm() < 1e-14 && turned[1].norm() < 1e-14);
    for (i, j) in (0..4).flat_map(|i| (0..4).map(move |j| (i, j))) {
        assert!((gram[(i, j)] - unit(i, j)).norm() < 1e-14 && (form.t[(i, j)] - moved[(i, j)]).norm() < 1e-13);
    }
    let before = form.t.clone();
    form.rotate(1, x, ZERO, 0, 4);
    assert!(form.t == before);
}

/// The eigenvalue of the last two rows that is nearer to the last entry: of (2 1; 3 4), 1 and 5.
#[test]
fn shifts_are_eigenvalues_of_the_last_two_rows() {
    let form = |entries: [[c64; 2]; 2]| {
        let t = Mat::from_fn(3, 3, |i, j| if i > 0 && j > 0 { entries[i - 1][j - 1] } else { complex(9.0, 0.0) });
        Triangular { z: Mat::from_fn(3, 3, unit), t }
    };
    let real = |entries: [[f64; 2]; 2]| form(entries.map(|row| row.map(|x| complex(x, 0.0))));
    for (entries, shift) in [
        ([[2.0, 1.0], [3.0, 4.0]], complex(5.0, 0.0)),
        ([[4.0, 1.0], [3.0, 2.0]], complex(1.0, 0.0)),
        ([[3.0, 5.0], [0.0, 3.0]], complex(3.0, 0.0)),
        ([[7.0, 5.0], [0.0, 3.0]], complex(3.0, 0.0)),
        ([[1.0, -4.0], [1.0, 1.0]], complex(1.0, 2.0)),
    ] {
        let found = real(entries).shift(2);
        assert!((found - shift).norm() < 1e-14 || (found - shift.conj()).norm() < 1e-14, "{entries:?}: {found:?}");
    }
    let small = |x: f64| real([[1.0, 0.0], [x, 1.0]]).deflates(2);
    assert!(
        small(0.0) && small(2.0 * f64::EPSILON) && !small(2.1 * f64::EPSILON) && small(-f64::EPSILON) && !small(1.0)
    );
}
