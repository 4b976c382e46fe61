//! What jumps to a limit leave out, one after the other, against the same flock stepped exactly.
//!
//! After a jump over `s` steps a decision goes on with the limit motion. The twin here takes each of these steps, with rationals; what the
//! two states differ by is what was left out, to all orders.

use super::*;
use crate::averaging::flock::IntegerState;
use crate::averaging::{Weights, transition_matrix};
use arithmetic::Unwatched;
use num_traits::{Signed, ToPrimitive, Zero};

/// Positions and velocities, one row per bird.
#[derive(Clone)]
struct Flock {
    positions: RationalMatrix,
    velocities: RationalMatrix,
}

impl Flock {
    fn new(positions: &[Vec<Rational>], velocities: &[Vec<Rational>]) -> Self {
        let matrix = |rows: &[Vec<Rational>]| RationalMatrix::from_rows(rows).unwrap();
        Flock { positions: matrix(positions), velocities: matrix(velocities) }
    }

    fn moved(&mut self) {
        self.positions = self.positions.plus(&self.velocities).unwrap();
    }

    fn averaged(&mut self, transition: &RationalMatrix) {
        self.velocities = transition.times(&self.velocities).unwrap();
    }

    fn integers(&self) -> IntegerState {
        let unit = self.positions.denominator().lcm(self.velocities.denominator());
        let rows = |matrix: &RationalMatrix| -> Vec<Vec<BigInt>> {
            let factor = &unit / matrix.denominator();
            (0..matrix.rows()).map(|i| matrix.row(i).iter().map(|x| x * &factor).collect()).collect()
        };
        IntegerState { positions: rows(&self.positions), velocities: rows(&self.velocities), unit }
    }
}

/// What happens to a flock.
enum Event {
    /// A jump on a network over so many steps; the last averaging is left to what follows.
    Jump(Graph, u64),
    Average(Graph),
    /// So many times a move and an averaging.
    Steps(Graph, u64),
}

/// The flock as it is, the flock after jumps to limits, and the stages in between.
fn followed(start: &Flock, weights: &Weights, events: &[Event]) -> (Flock, Flock, Vec<Stage>) {
    let (mut truth, mut kept, mut stages) = (start.clone(), start.clone(), Vec::new());
    for event in events {
        match event {
            Event::Jump(graph, steps) => {
                let fixed = FixedNetwork::new(graph, weights, &Unwatched).unwrap();
                let motion = Motion::new(&fixed, &kept.integers(), &Unwatched).unwrap();
                stages
                    .push(Stage::Jump(Box::new(Jump::new(&fixed, &motion, BigInt::from(*steps), &Unwatched).unwrap())));
                for step in 1..=*steps {
                    truth.moved();
                    if step < *steps {
                        truth.averaged(&fixed.transition);
                    }
                }
                let over = |x: &BigInt| Rational::new(x.clone(), motion.unit.clone());
                let place = |i: usize, k: usize| over(&(&motion.place[i][k] + &motion.drift[i][k] * *steps));
                let rows = |entry: &dyn Fn(usize, usize) -> Rational| -> Vec<Vec<Rational>> {
                    (0..motion.place.len()).map(|i| (0..motion.place[i].len()).map(|k| entry(i, k)).collect()).collect()
                };
                kept = Flock::new(&rows(&place), &rows(&|i, k| over(&motion.drift[i][k])));
            }
            Event::Average(graph) => {
                let transition = transition_matrix(graph, weights).unwrap();
                [&mut truth, &mut kept].into_iter().for_each(|flock| flock.averaged(&transition));
                stages.push(Stage::Average(transition));
            }
            Event::Steps(graph, steps) => {
                let transition = transition_matrix(graph, weights).unwrap();
                for _ in 0..*steps {
                    [&mut truth, &mut kept].into_iter().for_each(|flock| {
                        flock.moved();
                        flock.averaged(&transition);
                    });
                }
                stages.push(Stage::Steps { network: graph.clone(), transition, steps: *steps });
            }
        }
    }
    (truth, kept, stages)
}

fn trace(product: &RationalMatrix) -> Rational {
    (0..product.rows()).map(|k| product.entry(k, k)).sum()
}

/// The binary logarithm of the absolute value, to `1e-12` for numbers of some thousand bits.
fn log2(x: &Rational) -> f64 {
    let part = |x: &BigInt| {
        let shift = x.bits().saturating_sub(60);
        (x.abs() >> shift).to_f64().unwrap().log2() + shift as f64
    };
    part(&x.numer()) - part(&x.denom())
}

/// What was left out of a functional, as the stages tell it and as it is.
fn left_out(
    events: &[Event],
    weights: &Weights,
    start: &Flock,
    of: &dyn Fn() -> Functional,
) -> (Result<Magnitude, SettleError>, Rational) {
    let (truth, kept, stages) = followed(start, weights, events);
    let value = |flock: &Flock| {
        let of = of();
        trace(&of.positions.times(&flock.positions).unwrap()) + trace(&of.velocities.times(&flock.velocities).unwrap())
    };
    (value_of(&stages, of(), &Unwatched), value(&truth) - value(&kept))
}

/// Asks that the stages tell the sign of what was left out, and enclose its logarithm as closely as they can.
fn check(events: &[Event], weights: &Weights, start: &Flock, of: &dyn Fn() -> Functional) {
    let (told, truth) = left_out(events, weights, start, of);
    let Magnitude::Known(leading) = told.unwrap() else {
        return assert!(truth.is_zero(), "{truth}");
    };
    assert_eq!(leading.sign, if truth.is_negative() { Sign::Negative } else { Sign::Positive });
    let (lo, hi) = leading.log2.to_rationals();
    let (lo, hi) = (lo.to_f64().unwrap(), hi.to_f64().unwrap());
    assert!(lo - 1e-9 <= log2(&truth) && log2(&truth) <= hi + 1e-9, "{lo} {} {hi}", log2(&truth));
    let jumps = events.iter().filter(|event| matches!(event, Event::Jump(..))).count();
    // Several jumps: the others add less than a sixty-fourth, which is said with an eighth of a digit.
    let width = if jumps > 1 { 0.2500001 } else { 1e-6 };
    assert!(hi - lo < width, "{lo} {hi}");
}

fn graph(order: usize, edges: &[(usize, usize)]) -> Graph {
    Graph::from_edges(order, edges).unwrap()
}

fn line(values: &[i64]) -> Vec<Vec<Rational>> {
    values.iter().map(|&x| vec![rational(x, 8)]).collect()
}

fn pairs() -> Graph {
    graph(4, &[(0, 1), (2, 3)])
}

/// Other pairs.
fn crossed() -> Graph {
    graph(4, &[(0, 2), (1, 3)])
}

fn complete() -> Graph {
    Graph::from_fn(4, |_, _| true)
}

fn cycle() -> Graph {
    graph(4, &[(0, 1), (1, 2), (2, 3), (3, 0)])
}

fn star() -> Graph {
    graph(4, &[(0, 1), (0, 2), (0, 3)])
}

/// Four birds on a line with mixed velocities.
fn four() -> Flock {
    Flock::new(&line(&[0, 5, 9, 17]), &line(&[3, -8, 13, 1]))
}

/// Positions and velocities of two pairs, with weights.
fn mixed() -> Functional {
    let part = |pair, weight| difference_functional(4, pair, &[weight]).unwrap();
    Functional { positions: part((0, 1), rational(1, 1)), velocities: part((2, 3), rational(-3, 2)) }
}

fn of_positions() -> Functional {
    let positions = difference_functional(4, (1, 3), &[rational(1, 1)]).unwrap();
    Functional { velocities: positions.scaled(&rational(0, 1)), positions }
}

fn of_velocities() -> Functional {
    let velocities = difference_functional(4, (0, 2), &[rational(1, 1)]).unwrap();
    Functional { positions: velocities.scaled(&rational(0, 1)), velocities }
}

const FUNCTIONALS: [fn() -> Functional; 3] = [mixed, of_positions, of_velocities];

/// Weights that differ, so that stationary distributions do too.
fn uneven() -> Weights {
    Weights::Given(vec![rational(1, 4), rational(1, 8), rational(3, 16), rational(1, 8)])
}

#[test]
fn one_jump() {
    for weights in [Weights::Lazy, Weights::Vicsek, uneven()] {
        for steps in [800, 801] {
            for of in FUNCTIONALS {
                check(&[Event::Jump(Graph::path(4), steps)], &weights, &four(), &of);
                check(&[Event::Jump(pairs(), steps)], &weights, &four(), &of);
            }
        }
    }
}

#[test]
fn a_jump_and_steps_after_it() {
    for of in FUNCTIONALS {
        let events =
            |then: Vec<Event>| [vec![Event::Jump(Graph::path(4), 800)], then].into_iter().flatten().collect::<Vec<_>>();
        check(&events(vec![Event::Average(complete())]), &uneven(), &four(), &of);
        check(&events(vec![Event::Average(cycle()), Event::Steps(star(), 3)]), &uneven(), &four(), &of);
        check(&events(vec![Event::Steps(star(), 2), Event::Steps(Graph::path(4), 1)]), &uneven(), &four(), &of);
    }
}

/// What the first jump left out goes through the second one, to which it gives another drift for all its steps; or the second one leaves out more.
#[test]
fn two_jumps_one_of_which_outweighs() {
    for of in FUNCTIONALS {
        // In the second network the birds of a functional can be in one flock, or in two that part.
        for (first, second, network) in [(900, 3500, star()), (3500, 901, star()), (900, 3500, crossed())] {
            let events = [
                Event::Jump(pairs(), first),
                Event::Average(cycle()),
                Event::Steps(cycle(), 2),
                Event::Jump(network.clone(), second),
                Event::Average(Graph::path(4)),
            ];
            check(&events, &uneven(), &four(), &of);
        }
    }
}

/// What the second jump could have left out, and what it did to the remainder of the first, may be as large as that remainder.
#[test]
fn two_jumps_that_cannot_be_told_apart() {
    let events =
        |first, second| [Event::Jump(Graph::path(4), first), Event::Average(cycle()), Event::Jump(star(), second)];
    for (first, second) in [(3000, 100), (3000, 1)] {
        let (told, truth) = left_out(&events(first, second), &uneven(), &four(), &mixed);
        assert!(!truth.is_zero());
        assert_eq!(told.unwrap_err(), SettleError::Unresolved);
    }
    // Of two jumps that leave out nothing that the functional sees it is not said that there is nothing.
    let nothing = || Functional { positions: of_velocities().positions, velocities: of_velocities().positions };
    let (told, truth) = left_out(&events(900, 900), &uneven(), &four(), &nothing);
    assert!(truth.is_zero());
    assert_eq!(told.unwrap_err(), SettleError::Unresolved);
    let (told, _) = left_out(&events(900, 900)[..2], &uneven(), &four(), &nothing);
    assert!(matches!(told.unwrap(), Magnitude::Zero));
}

fn bits(x: &Rational) -> i64 {
    x.numer().bits() as i64 - x.denom().bits() as i64
}

fn largest(flock: &Flock) -> Rational {
    let entries = |matrix: &RationalMatrix| -> Vec<Rational> {
        (0..matrix.rows())
            .flat_map(|i| (0..matrix.cols()).map(move |k| (i, k)))
            .map(|(i, k)| matrix.entry(i, k).abs())
            .collect()
    };
    entries(&flock.positions).into_iter().chain(entries(&flock.velocities)).max().unwrap()
}

/// What a jump leaves out is below the bound that it gives, whatever the scale; and the bound is not much worse than half a digit for each time in
/// which velocities are halved.
#[test]
fn what_a_jump_leaves_out_is_below_its_bound() {
    // Pairs whose differences of velocities are halved in each step.
    let halving = Weights::Given(vec![rational(1, 4); 4]);
    for scale in [1, 3, 255, 256, 1 << 40] {
        for steps in [1, 2, 64, 65] {
            let start = Flock::new(&line(&[0, 0, 0, 0]), &line(&[scale, -scale, 0, 2 * scale - 1]));
            let (truth, kept, stages) = followed(&start, &halving, &[Event::Jump(pairs(), steps)]);
            let Some(Stage::Jump(jump)) = stages.first() else { panic!("a jump") };
            let difference = Flock {
                positions: truth.positions.plus(&kept.positions.scaled(&rational(-1, 1))).unwrap(),
                velocities: truth.velocities.plus(&kept.velocities.scaled(&rational(-1, 1))).unwrap(),
            };
            let smallness = jump.smallness.to_i64().unwrap();
            // bits(x) > log2 |x| and bits(x) - 2 < log2 |x|.
            assert!(bits(&largest(&difference)) - 1 <= -smallness, "{scale} {steps} {smallness}");
            assert!(bits(&largest(&difference)) + 7 >= -smallness, "{scale} {steps} {smallness}");
        }
    }
}

/// Steps and jumps make a remainder larger by at most the bits that they say, and the steps can come within a factor of 4 of that.
#[test]
fn what_was_left_out_grows_by_less_than_the_bits_that_are_counted() {
    let grown = |events: &[Event], positions: i64, velocities: i64| {
        let remainder = |p: i64, v: i64| Flock::new(&line(&[8 * p; 4]), &line(&[8 * v; 4]));
        let (after, _, stages) = followed(&remainder(positions, velocities), &uneven(), events);
        let size = largest(&after);
        let counted: u64 = stages.iter().map(Stage::growth_bits).sum();
        (size, counted)
    };
    for k in 1..12 {
        let steps = (1 << k) - 1;
        let (size, counted) = grown(&[Event::Steps(cycle(), steps)], 1, 1);
        assert_eq!(size, rational(1 << k, 1));
        assert_eq!(counted, k + 1);
        let (size, counted) = grown(&[Event::Jump(cycle(), steps)], 1, 1);
        assert!(size <= rational(1 << counted, 1));
        // The entries of Gamma, summed over four birds, are below 2^7.
        assert_eq!(counted, k + 9);
    }
    assert_eq!(grown(&[Event::Average(star())], 1, 1), (rational(1, 1), 0));
}
