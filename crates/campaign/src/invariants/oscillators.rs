//! Potentials along the flows of oscillators and steered particles (Paley and others), exact over rational points of the circle.

use super::{Checked, Invariant, OrFails, Tested, require, shown};
use crate::draws::Draws;
use crate::strategies::{digraph, fraction, graph, phasors, positive};
use algebra::graph::LaplacianKind;
use arithmetic::{Complex, Dual, Rational, Ring, rational};
use models::oscillator::{
    CircularGains, Neighbours, State, beacon_control, beacon_potential, circular_control, composite_potential,
    laplacian_control, moment, pairwise_control, pattern_control, pattern_potential, phase_gradient, phase_potential,
    rate_of_change,
};
use num_traits::ToPrimitive;

pub(super) const TABLE: &[Invariant] = &[
    Invariant {
        id: "energy.phase_pattern",
        statement: "Along the gradient control of several moments the potential falls at the rate of the sum of the squared controls.",
        control: "the last gain of the law is 1 larger than that of the potential",
        block: 100,
        check: pattern_energy,
    },
    Invariant {
        id: "energy.phase_laplacian",
        statement: "On an undirected network the Laplacian control is K dW_1/dtheta, and W_1 changes at the rate K |grad W_1|^2.",
        control: "the control without the last link",
        block: 100,
        check: laplacian_energy,
    },
    Invariant {
        id: "oscillator.pairs_are_laplacian",
        statement: "The law as a sum over pairs is the law by the Laplacian, on every weighted digraph.",
        control: "the law over the pairs of the reversed digraph",
        block: 100,
        check: pairs_are_laplacian,
    },
    Invariant {
        id: "oscillator.order_at_most_one",
        statement: "The moment p_m of phases has |p_m| <= 1/m.",
        control: "the moment of phasors one part in 8 too long",
        block: 200,
        check: order_parameter,
    },
    Invariant {
        id: "energy.circular_motion",
        statement: "Along the spacing control on an undirected network K_0 dS/dt is minus the sum of ((u_k - omega)/omega)^2, and along the beacon \
                    control N K_0 times the rate of the beacon potential is.",
        control: "the angular velocity of the potential is one part in 8 larger",
        block: 50,
        check: circular_energy,
    },
];

fn pattern_energy(draws: &mut Draws, tested: Tested) -> Checked {
    let count = draws.between(1, 5);
    let phases = phasors(draws, count);
    let gains: Vec<Rational> = (0..draws.between(1, 3)).map(|_| fraction(draws, 4, 3)).collect();
    let mut used = gains.clone();
    if tested.is_altered()
        && let Some(last) = used.last_mut()
    {
        *last += rational(1, 1);
    }
    let control = pattern_control(&used, &phases).or_fails("no law")?;
    let constant = |gain: &Rational| Dual::constant(gain.clone());
    let moving: Vec<Dual<Rational>> = gains.iter().map(constant).collect();
    let rate = rate_of_change(&phases, &control, |z| pattern_potential(&moving, z)).or_fails("no potential")?;
    let lost: Rational = control.iter().map(Ring::square).sum();
    let why = format!("the potential changes at the rate {rate}, not {}", -lost.clone());
    require(rate == -lost.clone(), why, || format!("phasors {}, gains {}", points(&phases), shown(&gains)))?;
    Ok(lost.to_f64())
}

fn points(list: &[Complex<Rational>]) -> String {
    shown(list.iter().map(|z| format!("({}, {})", z.re, z.im)))
}

fn laplacian_energy(draws: &mut Draws, tested: Tested) -> Checked {
    let count = draws.between(2, 6);
    let (phases, network) = (phasors(draws, count), graph(draws, count));
    let gain = fraction(draws, 4, 3);
    let described = || format!("phasors {}, links {:?}, K = {gain}", points(&phases), network.edges());
    let last = network.edges().pop();
    let used = Neighbours::from_fn(count, |k, j| {
        network.has_edge(k, j) && !(tested.is_altered() && Some((k.min(j), k.max(j))) == last)
    });
    let control = laplacian_control(&gain, &used, &phases).or_fails("no law")?;
    let whole = Neighbours::of(&network);
    let gradient = phase_gradient(&phases, |z| phase_potential(&whole, z, 1)).or_fails("no gradient")?;
    let expected: Vec<Rational> = gradient.iter().map(|slope| slope * &gain).collect();
    let why = format!("the control is {}, the gradient times K {}", shown(&control), shown(&expected));
    require(control == expected, why, described)?;
    let rate = rate_of_change(&phases, &control, |z| phase_potential(&whole, z, 1)).or_fails("no potential")?;
    let squares: Rational = gradient.iter().map(Ring::square).sum();
    require(rate == &squares * &gain, format!("W_1 changes at the rate {rate}"), described)?;
    Ok(None)
}

fn pairs_are_laplacian(draws: &mut Draws, tested: Tested) -> Checked {
    let count = draws.between(1, 5);
    let (phases, network) = (phasors(draws, count), digraph(draws, count));
    let gain = fraction(draws, 4, 3);
    let arcs = || network.adjacency().entries().map(|(i, j, weight)| (i, j, weight.clone()));
    let reversed = algebra::graph::WeightedGraph::from_arcs(count, arcs().map(|(i, j, weight)| (j, i, weight)));
    let used = if tested.is_altered() { &reversed } else { &network };
    let pairs = pairwise_control(&gain, used, &phases).or_fails("no law")?;
    let laplacian = network.matrix(LaplacianKind::OutDegree).or_fails("no Laplacian")?;
    let found = laplacian_control(&gain, &laplacian, &phases).or_fails("no law")?;
    let why = format!("pairs give {}, the Laplacian {}", shown(&pairs), shown(&found));
    require(pairs == found, why, || {
        let arcs = arcs().map(|(i, j, weight)| format!("({i}, {j}, {weight})"));
        format!("phasors {}, arcs {}, K = {gain}", points(&phases), shown(arcs))
    })?;
    Ok(None)
}

fn order_parameter(draws: &mut Draws, tested: Tested) -> Checked {
    let (count, m) = (draws.between(1, 6), draws.between(1, 4) as u32);
    let phases = phasors(draws, count);
    let longer = rational(9, 8);
    let used: Vec<_> = phases.iter().map(|z| if tested.is_altered() { z.scale(&longer) } else { z.clone() }).collect();
    let square = moment(&used, m).or_fails("no moment")?.norm_squared();
    let margin = rational(1, i64::from(m * m)) - &square;
    let why = format!("|p_{m}|^2 = {square}");
    require(margin >= rational(0, 1), why, || format!("phasors {}", points(&phases)))?;
    Ok(margin.to_f64())
}

fn circular_energy(draws: &mut Draws, tested: Tested) -> Checked {
    let count = draws.between(1, 4);
    let positions = (0..count).map(|_| Complex::new(fraction(draws, 6, 2), fraction(draws, 6, 2))).collect();
    let state = State { positions, phasors: phasors(draws, count) };
    let (omega, gain) = (positive(draws, 4, 3), fraction(draws, 4, 3));
    let gains = CircularGains { omega, spacing: gain, orientation: fraction(draws, 4, 3) };
    let network = Neighbours::of(&graph(draws, count));
    let beacon = Complex::new(fraction(draws, 4, 2), fraction(draws, 4, 2));
    let described = || {
        format!("positions {}, phasors {}, {gains:?}, {network:?}", points(&state.positions), points(&state.phasors))
    };
    let longer = if tested.is_altered() { rational(9, 8) } else { rational(1, 1) };
    let measured = Dual::constant(&gains.omega * &longer);
    // dS/dt = sum_k <e^(i theta_k), L_k c>/N (1 - u_k/omega) and u_k = omega + K_0 omega <..>/N: so dS/dt = -K_0 |..|^2.
    let none = CircularGains { orientation: rational(0, 1), ..gains.clone() };
    let control = circular_control(&none, &network, &network, &state).or_fails("no law")?;
    let weights = (&Dual::constant(rational(1, 1)), &Dual::constant(rational(0, 1)));
    let moving = state.moving(&control, &[]);
    let rate = composite_potential(&measured, weights, &network, &moving).or_fails("no potential")?.derivative;
    let turned: Vec<Rational> = control.iter().map(|u| (u - &gains.omega) / &gains.omega).collect();
    let squares: Rational = turned.iter().map(Ring::square).sum();
    // K_0 dS/dt = -sum ((u_k - omega)/omega)^2.
    require(&rate * &gains.spacing == -squares, format!("S changes at the rate {rate}"), described)?;
    let steering = beacon_control(&gains.omega, &gains.spacing, &beacon, &state).or_fails("no law")?;
    let control: Vec<Rational> = steering.iter().map(|u| u + &gains.omega).collect();
    let moving = state.moving(&control, &[]);
    let constant = Complex::new(Dual::constant(beacon.re.clone()), Dual::constant(beacon.im.clone()));
    let rate = beacon_potential(&measured, &constant, &moving).or_fails("no potential")?.derivative;
    let squares: Rational = steering.iter().map(|u| (u / &gains.omega).square()).sum();
    let share = rational(count as i64, 1);
    require(rate * share * &gains.spacing == -squares, "the beacon potential changes otherwise", described)?;
    Ok(None)
}
