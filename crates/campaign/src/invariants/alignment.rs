//! Energies and momentum of agents with accelerations (Tanner, Jadbabaie and Pappas), exact by dual numbers.

use super::{Checked, Invariant, OrFails, Tested, require, shown};
use crate::draws::Draws;
use crate::strategies::{fraction, graph, positive, potential, separated_state};
use algebra::graph::Graph;
use arithmetic::{ArithmeticError, Dual, Rational, rational};
use models::double_integrator::{
    Coordinates, Potential, State, gyroscopic, kinetic_energy, linked_within, potential_energy, potential_gradients,
    velocity_alignment,
};
use num_traits::{Signed, ToPrimitive, Zero};

pub(super) const TABLE: &[Invariant] = &[
    Invariant {
        id: "energy.velocity_alignment",
        statement: "Along velocity alignment the energy changes at the rate of minus the sum of |v_i - v_j|^2 over the links, so that it never \
                    grows, in Cartesian and in triangular coordinates.",
        control: "the potential of the energy is one part in 8 larger than that of the law",
        block: 100,
        check: velocity_energy,
    },
    Invariant {
        id: "energy.heading_alignment",
        statement: "A force normal to the velocity leaves the energy of heading alignment as it is, whatever the heading differences.",
        control: "the potential of the energy is one part in 8 larger than that of the law",
        block: 100,
        check: heading_energy,
    },
    Invariant {
        id: "momentum.velocity_alignment",
        statement: "The accelerations of velocity alignment sum to zero on every undirected network, with any potential of the distances.",
        control: "the acceleration of the last agent is that of a potential twice as strong",
        block: 100,
        check: momentum,
    },
    Invariant {
        id: "potential.slope_is_derivative",
        statement: "The slope of a potential is the derivative of its value, and its curvature that of its slope.",
        control: "the value of the potential plus s/8",
        block: 200,
        check: slope,
    },
];

/// A flock with its potential and links.
struct Setting {
    state: State<Rational>,
    potential: Potential,
    network: Graph,
    coordinates: Coordinates,
}

impl Setting {
    fn draw(draws: &mut Draws) -> Self {
        let agents = draws.between(2, 5);
        let (state, potential) = (separated_state(draws, agents), potential(draws));
        let coordinates = *draws.choice(&[Coordinates::Cartesian, Coordinates::Triangular]);
        let network = match draws.below(2) {
            0 => graph(draws, agents),
            _ => linked_within(&state.positions, &positive(draws, 20, 1), coordinates),
        };
        Setting { state, potential, network, coordinates }
    }

    fn describe(&self) -> String {
        let rows = |rows: &[[Rational; 2]]| shown(rows.iter().map(shown));
        format!(
            "positions {}, velocities {}, links {:?}, {:?} coordinates, {:?}",
            rows(&self.state.positions),
            rows(&self.state.velocities),
            self.network.edges(),
            self.coordinates,
            self.potential
        )
    }

    /// The rate of the energy with a potential along given accelerations.
    fn rate(&self, potential: &Potential, accelerations: &[[Rational; 2]]) -> Result<Rational, ArithmeticError> {
        let moving: State<Dual<Rational>> = self.state.moving(accelerations);
        let value = |_, _, s: &Dual<Rational>| potential.rational_value(s);
        let stored = potential_energy(&moving.positions, &self.network.edges(), self.coordinates, value)?;
        Ok((stored + kinetic_energy(&moving.velocities, self.coordinates)?).derivative)
    }

    /// The potential of the energy: that of the law, unless altered.
    fn measured(&self, tested: Tested) -> Potential {
        if tested.is_altered() { self.potential.times(&rational(9, 8)) } else { self.potential.clone() }
    }
}

fn velocity_energy(draws: &mut Draws, tested: Tested) -> Checked {
    let setting = Setting::draw(draws);
    let edges = setting.network.edges();
    let slope = |_, _, s: &Rational| setting.potential.slope(s);
    let forces = velocity_alignment(&setting.state, &edges, setting.coordinates, slope).or_fails("no law")?;
    let rate = setting.rate(&setting.measured(tested), &forces).or_fails("no energy")?;
    let spread = |&(i, j): &(usize, usize)| setting.coordinates.square(&setting.state.relative_velocity(i, j));
    let lost: Rational = edges.iter().map(spread).sum();
    let why = format!("the energy changes at the rate {rate}, not {}", -lost.clone());
    require(rate == -lost.clone() && !lost.is_negative(), why, || setting.describe())?;
    Ok(lost.to_f64())
}

fn heading_energy(draws: &mut Draws, tested: Tested) -> Checked {
    let setting = Setting { coordinates: Coordinates::Cartesian, ..Setting::draw(draws) };
    let edges = setting.network.edges();
    let differences: Vec<Rational> = edges.iter().map(|_| fraction(draws, 3, 5)).collect();
    let slope = |_, _, s: &Rational| setting.potential.slope(s);
    let gradients = potential_gradients(&setting.state.positions, &edges, setting.coordinates, slope);
    let gradients = gradients.or_fails("no gradients")?;
    let differ = |i: usize, j: usize| {
        let place = edges.iter().position(|&edge| edge == (i, j));
        place.map_or(Rational::zero(), |k| differences[k].clone())
    };
    let forces = gyroscopic(&setting.state, &gradients, &edges, differ).or_fails("no law")?;
    let rate = setting.rate(&setting.measured(tested), &forces).or_fails("no energy")?;
    let described = || format!("{}, heading differences {}", setting.describe(), shown(&differences));
    require(rate.is_zero(), format!("the energy changes at the rate {rate}"), described)?;
    Ok(None)
}

fn momentum(draws: &mut Draws, tested: Tested) -> Checked {
    let setting = Setting::draw(draws);
    let edges = setting.network.edges();
    let law = |potential: &Potential| {
        let slope = |_, _, s: &Rational| potential.slope(s);
        velocity_alignment(&setting.state, &edges, setting.coordinates, slope)
    };
    let mut forces = law(&setting.potential).or_fails("no law")?;
    if tested.is_altered() {
        let stronger = law(&setting.potential.times(&rational(2, 1))).or_fails("no law")?;
        forces.truncate(forces.len() - 1);
        forces.extend(stronger.into_iter().next_back());
    }
    let total = [0, 1].map(|k| forces.iter().map(|force| force[k].clone()).sum::<Rational>());
    let why = format!("the accelerations sum to {}", shown(&total));
    require(total.iter().all(Zero::is_zero), why, || setting.describe())?;
    Ok(None)
}

fn slope(draws: &mut Draws, tested: Tested) -> Checked {
    let (potential, s) = (potential(draws), positive(draws, 30, 7));
    let moving = Dual::new(s.clone(), rational(1, 1));
    let value = potential.rational_value(&moving).or_fails("no value")?;
    let extra = if tested.is_altered() { rational(1, 8) } else { rational(0, 1) };
    let slope = potential.slope(&s).or_fails("no slope")?;
    let curvature = potential.curvature(&s).or_fails("no curvature")?;
    let bent = potential.slope_over(&moving).at(&moving).or_fails("no slope")?.derivative;
    let found = value.derivative + extra;
    let why = format!("the slope is {slope}, the derivative {found}; the curvature {curvature}, the derivative {bent}");
    require(slope == found && curvature == bent, why, || format!("{potential:?} at s = {s}"))?;
    Ok(None)
}
