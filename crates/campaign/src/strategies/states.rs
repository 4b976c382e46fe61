//! States of the continuous models, exact.

use super::list;
use super::numbers::{fraction, integer, positive};
use crate::draws::Draws;
use arithmetic::{Complex, Rational, rational};
use models::double_integrator::{Potential, State};
use models::oscillator::phasor;
use models::platoon::Gains;

/// A point of the unit circle with rational coordinates.
pub fn unit_phasor(draws: &mut Draws) -> Complex<Rational> {
    let t = fraction(draws, 6, 4);
    let one = rational(1, 1);
    // The opposite has no parameter of its own.
    let (one, zero) = (one.clone(), &one - &one);
    let z = phasor(&t).unwrap_or_else(|_| Complex::new(one, zero));
    if draws.once_in(2) { -z } else { z }
}

/// So many phasors.
pub fn phasors(draws: &mut Draws, count: usize) -> Vec<Complex<Rational>> {
    list(draws, count, unit_phasor)
}

/// Agents in the plane, no two at the same place.
pub fn separated_state(draws: &mut Draws, agents: usize) -> State<Rational> {
    let mut positions: Vec<[Rational; 2]> = Vec::new();
    for _ in 0..agents {
        let mut place = [fraction(draws, 8, 3), fraction(draws, 8, 3)];
        while positions.contains(&place) {
            place[0] += rational(1, 1);
        }
        positions.push(place);
    }
    let velocities = list(draws, agents, |draws| [fraction(draws, 6, 3), fraction(draws, 6, 3)]);
    State { positions, velocities }
}

/// A potential without logarithm: its slope is a sum of powers of the squared distance.
pub fn potential(draws: &mut Draws) -> Potential {
    match draws.below(2) {
        0 => {
            let minimum = positive(draws, 4, 3);
            Potential::inverse_square_spring(&minimum, &positive(draws, 3, 2))
        }
        _ => {
            let terms = [-3, -2, 0, 1, 2].map(|exponent| (exponent, rational(integer(draws, 3), 1)));
            Potential::new(terms.to_vec(), (rational(1, 1), rational(0, 1)))
        }
    }
}

/// Gains of a platoon, both negative.
pub fn platoon_gains(draws: &mut Draws) -> Gains<Rational> {
    Gains { f: -positive(draws, 8, 4), g: -positive(draws, 8, 4) }
}
