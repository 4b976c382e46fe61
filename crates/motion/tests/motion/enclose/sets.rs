//! Sets that are wide.

use arithmetic::{ArithmeticError, FloatInterval, Number, rational};
use motion::System;
use motion::enclose::{Flow, Set};

/// Three agents with velocity alignment and the potential `1/s² + log s²` of all pairs.
struct Aligned;

impl System for Aligned {
    fn rate<T: Number>(&self, _: &T, y: &[T]) -> Result<Vec<T>, ArithmeticError> {
        let mut rates: Vec<T> = y[6..].to_vec();
        for i in 0..3 {
            let mut force = [y[0].zero(), y[0].zero()];
            for j in (0..3).filter(|j| *j != i) {
                let apart = [0, 1].map(|k| y[2 * i + k].clone() - &y[2 * j + k]);
                let s = apart[0].square() + apart[1].square();
                let over = s.recip()?;
                let slope = (over.clone() - over.square()) * y[0].integer(2);
                for k in 0..2 {
                    force[k] = force[k].clone() + &y[6 + 2 * j + k] - &y[6 + 2 * i + k] - apart[k].clone() * &slope;
                }
            }
            rates.extend(force);
        }
        Ok(rates)
    }
}

/// Laub and Loomis.
struct Enzymes;

impl System for Enzymes {
    fn rate<T: Number>(&self, _: &T, x: &[T]) -> Result<Vec<T>, ArithmeticError> {
        let c = |p: i64, q: i64| x[0].rational(&rational(p, q));
        Ok(vec![
            c(14, 10) * &x[2] - c(9, 10) * &x[0],
            c(25, 10) * &x[4] - c(15, 10) * &x[1],
            c(6, 10) * &x[6] - c(8, 10) * &x[1] * &x[2],
            c(2, 1) - c(13, 10) * &x[2] * &x[3],
            c(7, 10) * &x[0] - x[3].clone() * &x[4],
            c(3, 10) * &x[0] - c(31, 10) * &x[5],
            c(18, 10) * &x[5] - c(15, 10) * &x[1] * &x[6],
        ])
    }
}

/// Two coupled oscillators of van der Pol.
struct Oscillators(i64);

impl System for Oscillators {
    fn rate<T: Number>(&self, _: &T, x: &[T]) -> Result<Vec<T>, ArithmeticError> {
        let own = |k: usize, other: usize| {
            let damping = (x[0].one() - x[k].square()) * x[0].integer(self.0);
            damping * &x[k + 1] - x[0].integer(2) * &x[k] + &x[other]
        };
        Ok(vec![x[1].clone(), own(0, 2), x[3].clone(), own(2, 0)])
    }
}

fn boxed(list: &[(f64, f64)]) -> Vec<FloatInterval> {
    list.iter().map(|(lo, hi)| FloatInterval::between(*lo, *hi)).collect()
}

fn agents(widths: &[(usize, f64)]) -> Vec<FloatInterval> {
    let start = [0.0, 0.0, 2.0, 0.0, 1.0, 2.0, 1.0, 0.0, 0.5, 0.5, 0.0, -1.0];
    let mut list: Vec<FloatInterval> = start.iter().map(|x| FloatInterval::point(*x)).collect();
    for (place, width) in widths {
        list[*place] = list[*place] + FloatInterval::between(-width / 2.0, width / 2.0);
    }
    list
}

/// The end of a motion, and the largest value of a number on the way.
fn followed(system: impl System, start: &[FloatInterval], until: f64, watched: usize) -> (Set, f64) {
    let (mut flow, mut set, mut time, mut most) = (Flow::new(system, 0.01), Set::of_box(start), 0.0, f64::NEG_INFINITY);
    while time < until {
        let step = flow
            .step(&set, time, until)
            .unwrap_or_else(|error| panic!("{error}: {:?} rest {}", set.hull(), set.rest_radius()));
        for k in 0..8 {
            let part = |k: usize| step.span.hi() * f64::from(k as u32) / 8.0;
            most = most.max(step.states(FloatInterval::between(part(k), part(k + 1)))[watched].hi());
        }
        (set, time) = (step.end, step.until);
    }
    (set, most)
}

/// Floats at points of a box lie in the enclosure at the end, and the enclosure is not much wider than they are apart.
fn is_enclosed(system: impl System, start: &[FloatInterval], until: f64, set: &Set, excess: f64) {
    let mut random = arithmetic::random::generator("enclose", "points of a box", 0);
    let hull = set.hull();
    let (mut lo, mut hi) = (vec![f64::INFINITY; hull.len()], vec![f64::NEG_INFINITY; hull.len()]);
    for k in 0..60 {
        let at = |x: &FloatInterval| {
            // Corners first.
            let share = if k < 30 {
                f64::from(u8::from(arithmetic::random::uniform(&mut random) < 0.5))
            } else {
                arithmetic::random::uniform(&mut random)
            };
            x.lo() + share * (x.hi() - x.lo())
        };
        let mut state: Vec<f64> = start.iter().map(at).collect();
        let mut rk4 = motion::Rk4::new(state.len());
        let steps = (until * 400.0) as usize;
        let length = until / steps as f64;
        let mut field = |time: f64, y: &[f64], rate: &mut [f64]| {
            rate.copy_from_slice(&system.rate(&time, y).expect("a rate"));
        };
        for step in 0..steps {
            rk4.step(&mut field, step as f64 * length, length, &mut state);
        }
        for (i, x) in state.iter().enumerate() {
            assert!(hull[i].lo() - 1e-7 <= *x && *x <= hull[i].hi() + 1e-7, "{i}: {x} in {}", hull[i]);
            (lo[i], hi[i]) = (lo[i].min(*x), hi[i].max(*x));
        }
    }
    let apart = lo.iter().zip(&hi).map(|(a, b)| b - a).fold(0.0, f64::max);
    let width = hull.iter().map(FloatInterval::width).fold(0.0, f64::max);
    assert!(width < excess * apart, "{width} for {apart}");
}

#[test]
fn a_wide_velocity_of_three_agents_is_one_box() {
    let start = agents(&[(6, 0.2)]);
    let (set, _) = followed(Aligned, &start, 10.0, 0);
    is_enclosed(Aligned, &start, 10.0, &set, 1.1);
}

#[test]
fn laub_and_loomis_in_one_box() {
    for radius in [0.01, 0.05] {
        let start = boxed(&[1.2, 1.05, 1.5, 2.4, 1.0, 0.1, 0.45].map(|x| (x - radius, x + radius)));
        let (set, most) = followed(Enzymes, &start, 20.0, 3);
        assert!(most < 4.5, "{radius}: {most}");
        is_enclosed(Enzymes, &start, 20.0, &set, 3.0);
    }
}

#[test]
fn coupled_oscillators_in_one_box() {
    let start = boxed(&[(1.25, 1.55), (2.35, 2.45), (1.25, 1.55), (2.35, 2.45)]);
    let (set, _) = followed(Oscillators(1), &start, 7.0, 1);
    is_enclosed(Oscillators(1), &start, 7.0, &set, 2.0);
}

#[test]
fn a_point_stays_narrow() {
    let (set, _) = followed(Aligned, &agents(&[]), 10.0, 0);
    let width = set.hull().iter().map(FloatInterval::width).fold(0.0, f64::max);
    assert!(width < 1e-9, "{width}");
}
