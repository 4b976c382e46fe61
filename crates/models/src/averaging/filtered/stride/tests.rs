//! Strides against single steps, and their probabilities against exact ones.

use super::*;
use crate::averaging::filtered::balls::Balls;
use crate::averaging::{Flock, Hysteresis, Start, Weights};
use arithmetic::{Unwatched, rational};
use num_bigint::BigInt;
use num_traits::ToPrimitive;

/// Binomial coefficients, exactly; what is beyond the last place is far below the rounding.
#[test]
fn places_of_a_walk_have_their_probabilities() {
    for steps in [512u64, 1001, 4096] {
        let degree = degree_for(steps, LIMBS);
        let found = walk(steps, degree);
        let mut number = BigInt::from(1);
        let all = BigInt::from(1) << steps;
        for heads in 0..=steps / 2 {
            let place = steps - 2 * heads;
            if place <= degree {
                let sides = if place == 0 { 1 } else { 2 };
                let exact: BigInt = ((&number * sides) << 200u32) / &all;
                let exact = exact.to_f64().unwrap() / 2f64.powi(200);
                let error = 4.0 * (degree as f64 + 1.0) * f64::EPSILON;
                assert!((found[place as usize] - exact).abs() <= error * exact + 1e-21, "{steps} {place}");
            }
            number = number * (steps - heads) / (heads + 1);
        }
        assert!((found.iter().sum::<f64>() - 1.0).abs() < 1e-13);
    }
}

fn balls(birds: i64, weights: Weights) -> Balls<2> {
    let x = (0..birds).map(|k| rational(9 * k, 10)).collect();
    let v = (0..birds).map(|k| rational((7 * k * k) % 11 - 5, 1000)).collect();
    let flock = Flock::new(&Start::on_the_line(x, v, weights, Hysteresis::None)).unwrap();
    Balls::new(&flock.integers(), flock.network().clone(), flock.weights(), (0, 0)).unwrap().unwrap()
}

/// The same as single steps, up to what both say they err by; less than a thousandth of what a stride may add is used on short ways.
#[test]
fn a_stride_is_as_many_steps() {
    for (birds, weights) in [(2, Weights::Lazy), (9, Weights::Vicsek), (60, Weights::Lazy)] {
        let balls = balls(birds, weights);
        let wholes = balls.wholes();
        assert_eq!(wholes.len(), 1);
        let ahead = || Ahead::new(&wholes[0], |i, j, k| balls.position_difference(i, j, k), 1e-12, 1);
        for steps in [512u64, 1501, 5000] {
            let (mut one, mut many) = (ahead(), ahead());
            let start = one.error;
            (0..steps).for_each(|_| many.step());
            one.spare = 1.0;
            assert!(one.stride(steps, &Unwatched).unwrap());
            assert_eq!((one.steps, one.patient), (steps, steps));
            let added = one.error - start;
            assert!(added > 0.0 && added < 1e-4 && one.spare == 1.0 - added, "{birds} {steps}: {added}");
            for (a, b) in one.rest.iter().zip(&many.rest) {
                assert!((a - b).abs() <= added + (many.error - start), "{birds} {steps}: {a} {b}");
                assert!((a - b).abs() < 1e-12, "{birds} {steps}: {a} {b}");
            }
            assert!(one.largest >= one.rest.iter().fold(0.0, |most: f64, z| most.max(z.abs())));
        }
        // Without room for its rounding it is not made, and not tried again at once.
        let (mut one, same) = (ahead(), ahead());
        one.spare = 0.0;
        assert!(!one.stride(4096, &Unwatched).unwrap());
        assert_eq!((one.steps, one.error, &one.rest), (0, same.error, &same.rest));
        assert!(one.patient > 512);
    }
}
