//! Every law commutes with a new numbering of the agents, and with translations, changes of the moving frame and rotations.

use super::{Checked, Invariant, OrFails, Stop, Tested, require, shown};
use crate::draws::Draws;
use crate::strategies::{
    digraph, flock, fraction, graph, list, permutation, phasors, platoon_gains, positive, potential, separated_state,
    start, tracking, unit_phasor,
};
use algebra::graph::{Graph, LaplacianKind, WeightedGraph};
use arithmetic::{Complex, Rational, rational};
use models::averaging::{Flock, Start, Switch, Weights};
use models::double_integrator::{Coordinates, State, gyroscopic, potential_gradients, velocity_alignment};
use models::oscillator::{BehaviourGains, ZoneNetworks};
use models::oscillator::{
    CircularGains, Neighbours, State as Particles, Zone, Zones, circular_control, laplacian_behaviour_control,
    laplacian_control, pattern_control,
};
use models::platoon::{CommunicationGraph, amplitudes_two_sided};

pub(super) const TABLE: &[Invariant] = &[
    Invariant {
        id: "symmetry.averaging_numbering",
        statement: "A flock of model D with its birds in another order moves as before, bird for bird, and has the same switches.",
        control: "the given weights, or the velocities, stay in the old order",
        block: 10,
        check: averaging_numbering,
    },
    Invariant {
        id: "symmetry.averaging_galilean",
        statement: "Translated, and with one velocity added to all, a flock of model D has the same switches at the same times.",
        control: "the velocity is added to all birds but the first",
        block: 10,
        check: averaging_galilean,
    },
    Invariant {
        id: "symmetry.alignment_numbering",
        statement: "Velocity and heading alignment give each agent the same acceleration in every numbering.",
        control: "the links stay those of the old numbering",
        block: 50,
        check: alignment_numbering,
    },
    Invariant {
        id: "symmetry.alignment_galilean",
        statement: "Accelerations of velocity alignment turn with the frame and do not feel translations and a common velocity.",
        control: "the positions are one part in 8 longer",
        block: 50,
        check: alignment_galilean,
    },
    Invariant {
        id: "symmetry.phase_numbering",
        statement: "Phase, pattern, circular and fish controls give each particle the same turn in every numbering.",
        control: "the arcs of the networks stay those of the old numbering",
        block: 50,
        check: phase_numbering,
    },
    Invariant {
        id: "symmetry.phase_rotation",
        statement: "Phase, pattern, circular and fish controls do not feel a rotation of the plane and a translation.",
        control: "the last particle is not rotated",
        block: 50,
        check: phase_rotation,
    },
    Invariant {
        id: "symmetry.platoon",
        statement: "The accelerations of a platoon do not feel a common shift and a common velocity of leader and followers, and follow a new \
                    numbering of the followers.",
        control: "the leader is not shifted",
        block: 50,
        check: platoon,
    },
    Invariant {
        id: "platoon.response",
        statement: "The amplitudes of the two-sided platoon by the three-term recurrence solve the equations of its communication graph.",
        control: "the recurrence at twice the frequency",
        block: 20,
        check: response,
    },
];

/// A list in another order.
fn ordered<T: Clone>(list: &[T], order: &[usize]) -> Vec<T> {
    order.iter().map(|&k| list[k].clone()).collect()
}

/// A graph whose vertex `i` is the vertex `order[i]` of the old one.
fn renumbered(graph: &Graph, order: &[usize]) -> Graph {
    Graph::from_fn(graph.order(), |i, j| graph.has_edge(order[i], order[j]))
}

fn switches_of(start: &Start, steps: u64) -> Result<(Vec<Switch>, Flock), Stop> {
    let mut flock = Flock::new(start).or_fails("a flock is refused")?;
    let mut switches = Vec::new();
    for _ in 0..steps {
        switches.extend(flock.step().or_fails("a step is refused")?);
    }
    Ok((switches, flock))
}

fn averaging_numbering(draws: &mut Draws, tested: Tested) -> Checked {
    let start = start(draws);
    let birds = start.positions.len();
    let order = permutation(draws, birds);
    let kept = |weights: &Weights| match weights {
        Weights::Given(c) => Weights::Given(ordered(c, &order)),
        other => other.clone(),
    };
    let velocities = if tested.is_altered() { start.velocities.clone() } else { ordered(&start.velocities, &order) };
    let other = Start {
        positions: ordered(&start.positions, &order),
        velocities,
        weights: kept(&start.weights),
        hysteresis: start.hysteresis.clone(),
    };
    let described = || format!("{start:?}, in the order {order:?}");
    let ((before, old), (after, new)) = (switches_of(&start, 12)?, switches_of(&other, 12)?);
    let times = |list: &[Switch]| list.iter().map(|switch| switch.time.clone()).collect::<Vec<_>>();
    require(times(&before) == times(&after), "the switches have other times", described)?;
    require(renumbered(old.network(), &order) == *new.network(), "the network is another one", described)?;
    require(ordered(&old.positions(), &order) == new.positions(), "the positions are others", described)?;
    require(ordered(&old.velocities(), &order) == new.velocities(), "the velocities are others", described)?;
    Ok(None)
}

fn averaging_galilean(draws: &mut Draws, tested: Tested) -> Checked {
    let (birds, dimension) = (draws.between(1, 4), draws.between(1, 2));
    let start = flock(draws, birds, dimension, 8);
    let shift = list(draws, dimension, |draws| fraction(draws, 20, 7));
    let boost = list(draws, dimension, |draws| fraction(draws, 20, 7));
    let added = |rows: &[Vec<Rational>], by: &[Rational], from: usize| -> Vec<Vec<Rational>> {
        let row = |(k, row): (usize, &Vec<Rational>)| {
            if k < from { row.clone() } else { row.iter().zip(by).map(|(x, d)| x + d).collect() }
        };
        rows.iter().enumerate().map(row).collect()
    };
    let other = Start {
        positions: added(&start.positions, &shift, 0),
        velocities: added(&start.velocities, &boost, usize::from(tested.is_altered())),
        ..start.clone()
    };
    let ((before, _), (after, _)) = (switches_of(&start, 20)?, switches_of(&other, 20)?);
    require(before == after, "the switches are others", || {
        format!("{start:?}, translated by {} and moved by {}", shown(&shift), shown(&boost))
    })?;
    Ok(None)
}

fn alignment_numbering(draws: &mut Draws, tested: Tested) -> Checked {
    let agents = draws.between(2, 5);
    let (state, potential, network) = (separated_state(draws, agents), potential(draws), graph(draws, agents));
    let order = permutation(draws, agents);
    let headings = list(draws, agents, |draws| fraction(draws, 5, 4));
    let other = State { positions: ordered(&state.positions, &order), velocities: ordered(&state.velocities, &order) };
    let links = if tested.is_altered() { network.clone() } else { renumbered(&network, &order) };
    let both = |state: &State<Rational>, edges: &[(usize, usize)], headings: &[Rational]| {
        let slope = |_, _, s: &Rational| potential.slope(s);
        let aligned = velocity_alignment(state, edges, Coordinates::Cartesian, slope)?;
        let gradients = potential_gradients(&state.positions, edges, Coordinates::Cartesian, slope)?;
        let turned = gyroscopic(state, &gradients, edges, |i, j| &headings[i] - &headings[j])?;
        Ok::<_, arithmetic::ArithmeticError>((aligned, turned))
    };
    let (aligned, turned) = both(&state, &network.edges(), &headings).or_fails("no law")?;
    let found = both(&other, &links.edges(), &ordered(&headings, &order)).or_fails("no law")?;
    let same = found == (ordered(&aligned, &order), ordered(&turned, &order));
    require(same, "the accelerations are others", || {
        format!("{state:?}, links {:?}, headings {}, in the order {order:?}", network.edges(), shown(&headings))
    })?;
    Ok(None)
}

fn alignment_galilean(draws: &mut Draws, tested: Tested) -> Checked {
    let agents = draws.between(2, 5);
    let (state, potential, network) = (separated_state(draws, agents), potential(draws), graph(draws, agents));
    let turn = unit_phasor(draws);
    let [shift, boost] = [0, 1].map(|_| [fraction(draws, 9, 4), fraction(draws, 9, 4)]);
    let rotated = |[x, y]: &[Rational; 2]| [x * &turn.re - y * &turn.im, x * &turn.im + y * &turn.re];
    let moved = |v: &[Rational; 2], by: &[Rational; 2]| {
        let [x, y] = rotated(v);
        [x + &by[0], y + &by[1]]
    };
    let longer = if tested.is_altered() { rational(9, 8) } else { rational(1, 1) };
    let other = State {
        positions: state.positions.iter().map(|r| moved(&[&r[0] * &longer, &r[1] * &longer], &shift)).collect(),
        velocities: state.velocities.iter().map(|v| moved(v, &boost)).collect(),
    };
    let law = |state: &State<Rational>| {
        velocity_alignment(state, &network.edges(), Coordinates::Cartesian, |_, _, s| potential.slope(s))
    };
    let (before, after) = (law(&state).or_fails("no law")?, law(&other).or_fails("no law")?);
    require(before.iter().map(rotated).eq(after), "the accelerations are others", || {
        format!("{state:?}, links {:?}, turned by ({}, {})", network.edges(), turn.re, turn.im)
    })?;
    Ok(None)
}

/// Particles with gains and the digraphs of their networks.
struct School {
    state: Particles<Rational>,
    arcs: Vec<(usize, usize)>,
    gains: CircularGains<Rational>,
    zones: Zones<Rational>,
}

impl School {
    fn draw(draws: &mut Draws) -> Self {
        let count = draws.between(1, 5);
        let place = |draws: &mut Draws| Complex::new(fraction(draws, 6, 2), fraction(draws, 6, 2));
        let state = Particles { positions: list(draws, count, place), phasors: phasors(draws, count) };
        let arcs = digraph(draws, count).adjacency().entries().map(|(i, j, _)| (i, j)).collect();
        let mut gain = || fraction(draws, 4, 3);
        let (spacing, orientation) = (gain(), gain());
        let zones = Zones {
            repulsion: rational(1, 1),
            orientation: rational(2, 1),
            attraction: rational(5, 1),
            blind_cosine_squared: rational(draws.below(3) as i64, 2),
        };
        School { state, arcs, gains: CircularGains { omega: positive(draws, 4, 3), spacing, orientation }, zones }
    }

    fn describe(&self) -> String {
        format!("{:?}, arcs {:?}, {:?}", self.state, self.arcs, self.gains)
    }

    /// The controls of another state on a network.
    fn controls(&self, state: &Particles<Rational>, arcs: &[(usize, usize)]) -> Result<Vec<Vec<Rational>>, Stop> {
        let count = state.phasors.len();
        let network = Neighbours::from_arcs(count, arcs.iter().copied());
        let fish = ZoneNetworks {
            repulsion: self.zones.network(Zone::Repulsion, state),
            orientation: self.zones.network(Zone::Orientation, state),
            attraction: self.zones.network(Zone::Attraction, state),
        };
        let one = rational(1, 1);
        let behaviour = BehaviourGains { repulsion: one.clone(), orientation: one.clone(), attraction: one.clone() };
        let weighted = WeightedGraph::from_arcs(count, arcs.iter().map(|&(k, j)| (k, j, one.clone())));
        let laplacian = weighted.matrix(LaplacianKind::OutDegree).or_fails("no Laplacian")?;
        let pattern = [self.gains.spacing.clone(), self.gains.orientation.clone()];
        Ok(vec![
            laplacian_control(&self.gains.orientation, &laplacian, &state.phasors).or_fails("no law")?,
            pattern_control(&pattern, &state.phasors).or_fails("no law")?,
            circular_control(&self.gains, &network, &network, state).or_fails("no law")?,
            laplacian_behaviour_control(&one, &behaviour, &fish, state),
        ])
    }
}

fn phase_numbering(draws: &mut Draws, tested: Tested) -> Checked {
    let school = School::draw(draws);
    let order = permutation(draws, school.state.phasors.len());
    let place = |k: usize| order.iter().position(|&old| old == k).unwrap_or(k);
    let mut arcs: Vec<(usize, usize)> = school.arcs.iter().map(|&(k, j)| (place(k), place(j))).collect();
    if tested.is_altered() {
        arcs.clone_from(&school.arcs);
    }
    let other = Particles {
        positions: ordered(&school.state.positions, &order),
        phasors: ordered(&school.state.phasors, &order),
    };
    let before = school.controls(&school.state, &school.arcs)?;
    let after = school.controls(&other, &arcs)?;
    let same = before.iter().map(|control| ordered(control, &order)).eq(after);
    require(same, "the controls are others", || format!("{}, in the order {order:?}", school.describe()))?;
    Ok(None)
}

fn phase_rotation(draws: &mut Draws, tested: Tested) -> Checked {
    let school = School::draw(draws);
    let turn = unit_phasor(draws);
    let shift = Complex::new(fraction(draws, 9, 4), fraction(draws, 9, 4));
    let count = school.state.phasors.len();
    let turned = |k: usize, z: &Complex<Rational>| {
        if tested.is_altered() && k + 1 == count { z.clone() } else { z.clone() * &turn }
    };
    let all = |list: &[Complex<Rational>]| -> Vec<_> { list.iter().enumerate().map(|(k, z)| turned(k, z)).collect() };
    let other = Particles {
        positions: all(&school.state.positions).into_iter().map(|r| r + &shift).collect(),
        phasors: all(&school.state.phasors),
    };
    let (before, after) = (school.controls(&school.state, &school.arcs)?, school.controls(&other, &school.arcs)?);
    require(before == after, "the controls are others", || {
        format!("{}, turned by ({}, {})", school.describe(), turn.re, turn.im)
    })?;
    Ok(None)
}

fn platoon(draws: &mut Draws, tested: Tested) -> Checked {
    let followers = draws.between(1, 5);
    let tracked = tracking(draws, followers);
    let gains = platoon_gains(draws);
    let (y, u) = (list(draws, followers + 1, |d| fraction(d, 9, 4)), list(draws, followers + 1, |d| fraction(d, 9, 4)));
    let order = permutation(draws, followers);
    let (shift, boost) = (fraction(draws, 9, 4), fraction(draws, 9, 4));
    let graph = CommunicationGraph::new(tracked.clone()).or_fails("a communication graph is refused")?;
    let before = graph.accelerations(&gains, (&y[0], &u[0]), &y[1..], &u[1..]);
    // Follower k of the new platoon is follower order[k] of the old one.
    let agent = |old: usize| if old == 0 { 0 } else { 1 + order.iter().position(|&k| k + 1 == old).unwrap_or(0) };
    let renamed = |row: &Vec<(usize, Rational)>| {
        let mut row: Vec<_> = row.iter().map(|(old, weight)| (agent(*old), weight.clone())).collect();
        row.sort_by_key(|(agent, _)| *agent);
        row
    };
    let other = CommunicationGraph::new(ordered(&tracked, &order).iter().map(renamed).collect());
    let other = other.or_fails("a communication graph is refused")?;
    let moved = |x: &[Rational], by: &Rational| ordered(x, &order).iter().map(|x| x + by).collect::<Vec<_>>();
    let leader = if tested.is_altered() { y[0].clone() } else { &y[0] + &shift };
    let velocity = &u[0] + &boost;
    let after = other.accelerations(&gains, (&leader, &velocity), &moved(&y[1..], &shift), &moved(&u[1..], &boost));
    require(ordered(&before, &order) == after, "the accelerations are others", || {
        format!("{graph:?}, {gains:?}, y = {}, u = {}, shift {shift}, order {order:?}", shown(&y), shown(&u))
    })?;
    Ok(None)
}

fn response(draws: &mut Draws, tested: Tested) -> Checked {
    let followers = draws.between(1, 7);
    let (gains, w) = (platoon_gains(draws), positive(draws, 9, 5));
    let asked = if tested.is_altered() { &w + &w } else { w.clone() };
    let tracked: Vec<Vec<usize>> =
        (1..=followers).map(|k| if k < followers { vec![k - 1, k + 1] } else { vec![k - 1] }).collect();
    let graph = CommunicationGraph::with_equal_weights(&tracked).or_fails("a communication graph is refused")?;
    let (Ok(found), Ok(solved)) = (amplitudes_two_sided(&gains, &asked, followers), graph.response(&gains, &w)) else {
        return Err(Stop::Undecided("there is no response at this frequency".to_string()));
    };
    require(found == solved, "the amplitudes are others", || format!("{followers} followers, {gains:?}, w = {w}"))?;
    Ok(None)
}
