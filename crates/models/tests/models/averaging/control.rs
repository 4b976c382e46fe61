//! Control of model D against equation (1.2) written down directly.

use super::flock::starts;
use algebra::matrix::RationalMatrix;
use arithmetic::{Rational, rational};
use models::averaging::read::{Model, read_flock};
use models::averaging::{Flock, FlockError, transition_matrix};
use proptest::prelude::*;

fn small_matrix(seed: u64, order: usize, time: u64) -> RationalMatrix {
    let entry = |k: u64| ((seed.wrapping_mul(k + 3 + 7 * time) >> 11) % 7) as i64 - 3;
    let rows: Vec<Vec<i64>> = (0..order).map(|i| (0..order).map(|j| entry((i * order + j) as u64)).collect()).collect();
    RationalMatrix::from_integers(&rows, 3).expect("a matrix")
}

proptest! {
    /// `x(t) = x(t-1) + v(t)`, `v(t+1) = K (P(t) (x) I_d) v(t)` for a control that changes with `t` and rests at times.
    #[test]
    fn controlled_steps_satisfy_the_equation(start in starts(), seed in any::<u64>()) {
        let mut flock = Flock::new(&start).unwrap();
        let dimension = flock.dimension();
        let order = flock.birds() * dimension;
        let lift = RationalMatrix::identity(dimension).unwrap();
        for t in 1..=6u64 {
            let (x, v) = (flock.positions().concat(), flock.velocities().concat());
            let control = (t % 3 != 0).then(|| small_matrix(seed, order, t));
            flock.step_controlled(|flock| {
                // The control sees x(t), G_t and v(t).
                assert_eq!(flock.velocities().concat(), v);
                assert_eq!(*flock.time(), t.into());
                control.clone()
            }).unwrap();
            let moved: Vec<Rational> = x.iter().zip(&v).map(|(x, v)| x + v).collect();
            prop_assert_eq!(flock.positions().concat(), moved);
            let p = transition_matrix(flock.network(), flock.weights()).unwrap();
            let averaged = p.kronecker(&lift).apply(&v).unwrap();
            let expected = control.map_or(averaged.clone(), |k| k.apply(&averaged).unwrap());
            prop_assert_eq!(flock.velocities().concat(), expected);
        }
    }

    #[test]
    fn the_identity_controls_nothing(start in starts()) {
        let (mut free, mut controlled) = (Flock::new(&start).unwrap(), Flock::new(&start).unwrap());
        let identity = RationalMatrix::identity(free.birds() * free.dimension()).unwrap();
        for _ in 0..8 {
            let switch = free.step().unwrap();
            prop_assert_eq!(controlled.step_controlled(|_| Some(identity.clone())).unwrap(), switch);
            prop_assert_eq!(controlled.velocities(), free.velocities());
            prop_assert_eq!(controlled.positions(), free.positions());
        }
    }
}

#[test]
fn control_from_a_file() {
    let good = r#"{"model": "D", "weights": "lazy", "positions": [[0, 0], [5, 5]], "velocities": [[1, 0], [0, 1]],
                   "control": [[0, -1, 0, 0], [1, 0, 0, 0], [0, 0, "1/2", 0], [0, 0, 0, "1/2"]]}"#;
    let Model::D { start, control: Some(control) } = read_flock(good).unwrap().model else { panic!("{good}") };
    let mut flock = Flock::new(&start).unwrap();
    // Bird 1 turns left, bird 2 slows down.
    for _ in 0..4 {
        flock.step_controlled(|_| Some(control.clone())).unwrap();
    }
    assert_eq!(flock.velocities(), [[rational(1, 1), rational(0, 1)], [rational(0, 1), rational(1, 16)]]);
    let refuse = |from: &str, to: &str, named: &str| {
        assert!(good.contains(from), "{from}");
        let error = read_flock(&good.replace(from, to)).unwrap_err().to_string();
        assert!(error.contains(named), "{error} does not name {named}");
    };
    refuse("[0, -1, 0, 0], ", "", "4 x 4");
    refuse("[0, -1, 0, 0]", "[0, -1]", "control");
    refuse("[0, -1, 0, 0]", "[0, \"i\", 0, 0]", "row 1, 2");
    refuse("[0, -1, 0, 0]", "0", "control");
    refuse("\"control\"", "\"kappa\"", "kappa");
    let wrong = RationalMatrix::identity(2).unwrap();
    let expected = FlockError::Control { expected: 4, rows: 2, cols: 2 };
    assert_eq!(flock.step_controlled(|_| Some(wrong)), Err(expected));
}

#[test]
fn no_matrix_controls_more_birds_than_there_can_be() {
    let two = RationalMatrix::identity(2).unwrap();
    let refused = FlockError::Control { expected: usize::MAX, rows: 2, cols: 2 };
    assert_eq!(models::averaging::check_control(&two, usize::MAX, 2), Err(refused));
}
