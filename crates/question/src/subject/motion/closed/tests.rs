//! States in closed form against sums of Taylor's series.

use super::ClosedForm;
use arithmetic::{ArithmeticError, Number, Rational, rational};
use motion::System;
use num_traits::ToPrimitive;

/// `x'' = a x + b x' + c y, y'' = d y`: damped, resonant and growing motions.
struct Oscillator([Rational; 4]);

impl System for Oscillator {
    fn rate<T: Number>(&self, _: &T, state: &[T]) -> Result<Vec<T>, ArithmeticError> {
        let [x, v, y, w] = state else { return Ok(Vec::new()) };
        let [a, b, c, d] = &self.0;
        let times = |q: &Rational, value: &T| value.rational(q) * value;
        Ok(vec![v.clone(), times(a, x) + times(b, v) + times(c, y), w.clone(), times(d, y)])
    }
}

fn float(q: &Rational) -> f64 {
    q.to_f64().expect("finite")
}

/// The state by 80 terms in double precision.
fn series(law: &Oscillator, start: &[Rational], time: f64) -> Vec<f64> {
    let [a, b, c, d] = law.0.clone().map(|q| float(&q));
    let mut term: Vec<f64> = start.iter().map(float).collect();
    let mut sum = term.clone();
    for k in 1..80 {
        let [x, v, y, w] = term[..] else { panic!("four numbers") };
        term = [v, a * x + b * v + c * y, w, d * y].map(|rate| rate * time / f64::from(k)).to_vec();
        sum.iter_mut().zip(&term).for_each(|(sum, term)| *sum += term);
    }
    sum
}

#[test]
fn states_are_those_of_taylors_series() {
    let q = rational;
    let laws = [
        // Undamped; damped by 1 with frequency 2; critically damped; growing; in resonance, t cos t; driven by another frequency; by itself.
        [q(-4, 1), q(0, 1), q(0, 1), q(-1, 1)],
        [q(-5, 1), q(-2, 1), q(0, 1), q(-1, 1)],
        [q(-1, 4), q(-1, 1), q(0, 1), q(-1, 1)],
        [q(-5, 1), q(2, 1), q(1, 1), q(-1, 1)],
        [q(-1, 1), q(0, 1), q(1, 1), q(-1, 1)],
        [q(-9, 4), q(0, 1), q(2, 1), q(-1, 1)],
        [q(0, 1), q(0, 1), q(1, 1), q(0, 1)],
        [q(2, 1), q(1, 1), q(3, 1), q(-4, 1)],
    ];
    let starts = [
        [q(1, 1), q(0, 1), q(0, 1), q(1, 1)],
        [q(2, 3), q(-1, 2), q(1, 1), q(-1, 5)],
        [q(0, 1), q(0, 1), q(1, 1), q(0, 1)],
        [q(0, 1), q(0, 1), q(0, 1), q(0, 1)],
    ];
    let mut compared = 0;
    for (law, start) in laws.iter().flat_map(|law| starts.iter().map(move |start| (law, start))) {
        let law = Oscillator(law.clone());
        let closed = ClosedForm::of(&law, start).expect("linear, with rational exponents");
        for (from, to) in
            [(q(0, 1), q(1, 1000)), (q(3, 10), q(301, 1000)), (q(2, 1), q(2001, 1000)), (q(3, 1), q(31, 10))]
        {
            for (first, last, state) in closed.states(&from, &to, 120) {
                assert!(first >= from && last <= to && first <= last);
                let [early, late] = [&first, &last].map(|time| series(&law, start, float(time)));
                for ((x, a), b) in state.iter().zip(early).zip(late) {
                    // Between the two times a state moves by at most its rates, below 2000 here.
                    let room = 1e-9 + 2000.0 * (float(&last) - float(&first));
                    let (low, high) = x.number.enclosure(120).to_rationals();
                    let inside = float(&high) >= a.min(b) - room && float(&low) <= a.max(b) + room;
                    assert!(inside, "{low} {high} {a} {b} from {first} to {last}");
                    compared += 1;
                }
            }
        }
    }
    assert!(compared > 1000, "{compared}");
}

/// Irrational exponents are no closed form.
#[test]
fn irrational_exponents_have_no_closed_form() {
    let start = [rational(1, 1), rational(0, 1), rational(0, 1), rational(0, 1)];
    for law in [[-2, 0], [1, 1], [-1, -1]] {
        let law = Oscillator([rational(law[0], 1), rational(law[1], 1), rational(0, 1), rational(0, 1)]);
        assert!(ClosedForm::of(&law, &start).is_none());
    }
}
