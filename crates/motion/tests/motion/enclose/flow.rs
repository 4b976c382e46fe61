use arithmetic::{ArithmeticError, FloatInterval, Interval, Number, rational};
use motion::System;
use motion::enclose::{Flow, Set, ValidationError};

/// `x' = v, v' = -x`.
struct Oscillator;

impl System for Oscillator {
    fn rate<T: Number>(&self, _: &T, y: &[T]) -> Result<Vec<T>, ArithmeticError> {
        Ok(vec![y[1].clone(), -y[0].clone()])
    }
}

/// `y' = y²`, with the solution `1/(c - t)`.
struct Explosion;

impl System for Explosion {
    fn rate<T: Number>(&self, _: &T, y: &[T]) -> Result<Vec<T>, ArithmeticError> {
        Ok(vec![y[0].square()])
    }
}

/// `y' = 1/y`, with the solution `sqrt(c + 2t)`.
struct Root;

impl System for Root {
    fn rate<T: Number>(&self, _: &T, y: &[T]) -> Result<Vec<T>, ArithmeticError> {
        Ok(vec![y[0].recip()?])
    }
}

/// `y' = y cos t`, with the solution `c exp(sin t)`.
struct Driven;

impl System for Driven {
    fn rate<T: Number>(&self, time: &T, y: &[T]) -> Result<Vec<T>, ArithmeticError> {
        Ok(vec![time.cos()? * &y[0]])
    }
}

fn follow<L: System>(law: L, start: Set, until: f64) -> Result<Vec<FloatInterval>, ValidationError> {
    let (mut flow, mut set, mut time) = (Flow::new(law, 0.1), start, 0.0);
    while time < until {
        let step = flow.step(&set, time, until)?;
        // The expansion over the step agrees with its end.
        for (inner, end) in step.states(step.span).iter().zip(step.end.hull()) {
            assert!(inner.lo() <= end.hi() && end.lo() <= inner.hi());
        }
        (set, time) = (step.end, step.until);
    }
    Ok(set.hull())
}

fn point(state: &[f64]) -> Set {
    Set::of_box(&state.iter().map(|&x| FloatInterval::point(x)).collect::<Vec<_>>())
}

fn overlap(x: &FloatInterval, truth: &Interval) -> bool {
    let (lo, hi) = truth.to_rationals();
    let own = |q: f64| arithmetic::Dyadic::from_f64(q).expect("finite").to_rational();
    own(x.lo()) <= lo && hi <= own(x.hi())
}

#[test]
fn an_oscillator_stays_enclosed_for_a_long_time() {
    let end = follow(Oscillator, point(&[1.0, 0.0]), 100.0).expect("a solution");
    let (sin, cos) = Interval::from_rational(&rational(100, 1), 120).sin_cos().expect("an angle");
    assert!(overlap(&end[0], &cos) && overlap(&end[1], &-sin));
    assert!(end[0].width() < 1e-11 && end[1].width() < 1e-11, "{end:?}");
}

#[test]
fn a_turning_box_is_not_wrapped() {
    let side = FloatInterval::between(-0.001, 0.001);
    let start = Set::of_box(&[FloatInterval::point(1.0) + side, side]);
    let end = follow(Oscillator, start, 50.0).expect("a solution");
    // A turned square of side 0.002 fits into one of side 0.0029.
    assert!(end.iter().all(|x| x.width() < 0.0029 && x.width() > 0.0019), "{end:?}");
}

#[test]
fn rational_laws_match_their_closed_forms_and_an_explosion_ends() {
    let end = follow(Explosion, point(&[1.0]), 0.875).expect("a solution");
    assert!(end[0].contains(8.0) && end[0].width() < 1e-11, "{end:?}");
    assert!(follow(Explosion, point(&[1.0]), 1.5).is_err());
    let end = follow(Root, point(&[1.0]), 4.0).expect("a solution");
    assert!(end[0].contains(3.0) && end[0].width() < 1e-13, "{end:?}");
    let zero = follow(Root, point(&[0.0]), 1.0);
    assert!(matches!(zero, Err(ValidationError::Law { .. })));
}

#[test]
fn a_box_contains_the_solutions_from_its_points() {
    let (lo, hi) = (0.5, 0.75);
    let end = follow(Explosion, Set::of_box(&[FloatInterval::between(lo, hi)]), 1.0).expect("solutions");
    for x in [lo, 0.6, hi] {
        assert!(end[0].contains(1.0 / (1.0 / x - 1.0)), "{x}");
    }
}

#[test]
fn right_hand_sides_may_depend_on_the_time() {
    let end = follow(Driven, Set::of_box(&[FloatInterval::between(1.0, 2.0)]), 10.0).expect("solutions");
    let growth =
        Interval::from_rational(&rational(10, 1), 120).sin().and_then(|sin| sin.exp()).expect("a value").to_f64();
    assert!(end[0].contains(growth) && end[0].contains(2.0 * growth) && end[0].width() < 1.01 * growth, "{end:?}");
    let end = follow(Driven, point(&[1.0]), 10.0).expect("a solution");
    assert!(end[0].contains(growth) && end[0].width() < 1e-12, "{end:?}");
}
