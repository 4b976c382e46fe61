//! The laws of single agents, summed over their neighbours, against the laws of whole flocks.

use arithmetic::{Complex, rational};
use models::double_integrator::{
    Coordinates, HeadingDifference, HeadingLaw, Pair, Potential, State, VelocityLaw, gyroscopic, heading, heading_rate,
    potential_gradients, velocity_alignment,
};
use models::oscillator::{CircularGains, Everyone, ParticleLaw, beacon_control, circular_control};
use motion::{IndividualLaw, Moving, Rates, Turns};

const PLANE: Coordinates = Coordinates::Cartesian;
const PLACES: [[f64; 2]; 4] = [[0.0, 0.3], [1.1, -0.4], [0.7, 1.5], [-1.3, 0.8]];
const SPEEDS: [[f64; 2]; 4] = [[0.6, 0.2], [-0.3, 0.9], [0.1, -1.2], [0.8, 0.5]];

fn close(found: [f64; 2], known: [f64; 2]) {
    let off = (found[0] - known[0]).hypot(found[1] - known[1]);
    assert!(off < 1e-12 * (1.0 + known[0].hypot(known[1])), "{found:?} {known:?}");
}

fn potential() -> Potential {
    Potential::inverse_square_log(&rational(3, 2))
}

/// The rates of every agent, all others being its neighbours.
fn rates<const F: usize, const M: usize>(
    law: &impl IndividualLaw<F, M>,
    agents: &[Moving<f64, F>],
) -> Vec<Rates<f64, F>> {
    let of = |i: usize| {
        let mut total = [0.0; M];
        for j in (0..agents.len()).filter(|&j| j != i) {
            let influence = law.pair(&agents[i], &agents[j], |x| x).unwrap();
            total.iter_mut().zip(influence).for_each(|(sum, x)| *sum += x);
        }
        law.rates(&agents[i], &total, |x| x).unwrap()
    };
    (0..agents.len()).map(of).collect()
}

fn state() -> State<f64> {
    State { positions: PLACES.to_vec(), velocities: SPEEDS.to_vec() }
}

fn all_pairs() -> Vec<Pair> {
    (0..4).flat_map(|j| (0..j).map(move |i| (i, j))).collect()
}

#[test]
fn velocity_alignment_is_the_sum_over_pairs() {
    let law = VelocityLaw::new(&potential());
    let agents = state().individuals(&[[]; 4]);
    let known = velocity_alignment(&state(), &all_pairs(), PLANE, |_, _, s| potential().slope(s)).unwrap();
    rates(&law, &agents).iter().zip(known).for_each(|(found, known)| close(found.velocity, known));
    assert_eq!((law.turns(), law.velocity(&agents[2])), (Turns::Never, SPEEDS[2]));
    assert_eq!(State::of_individuals(agents.into_iter()), state());
    // V' = 1/s - 3/(2 s²): -8 s V' = 12/s - 8, which is negative from 3/2 on.
    for (s, push) in [(0.5, 16.0), (1.0, 4.0), (1.5, 0.0), (2.0, 0.0), (0.0, 0.0)] {
        assert_eq!(law.push(s), push, "{s}");
    }
    let at = |place: [f64; 2]| Moving { position: place, velocity: [0.0, 0.0], further: [] };
    assert!(law.pair(&at([1.0, 2.0]), &at([1.0, 2.0]), |x| x).is_err());
}

#[test]
fn heading_alignment_is_the_sum_over_pairs() {
    // Headings in other turns: the law reads them as they are.
    let turns = [0.0, 1.0, -1.0, 2.0].map(|n| n * std::f64::consts::TAU);
    let angles: Vec<f64> = SPEEDS.iter().zip(turns).map(|(v, turn)| heading(v).unwrap() + turn).collect();
    let further: Vec<[f64; 1]> = angles.iter().map(|angle| [*angle]).collect();
    let gradients = potential_gradients(&PLACES, &all_pairs(), PLANE, |_, _, s| potential().slope(s)).unwrap();
    let known = gyroscopic(&state(), &gradients, &all_pairs(), |i, j| angles[i] - angles[j]).unwrap();
    for (reading, turns) in [
        (HeadingDifference::Raw, Turns::OfAgents),
        (HeadingDifference::Wrapped, Turns::OfPairs),
        (HeadingDifference::Unwrapped, Turns::Never),
    ] {
        let law = HeadingLaw::new(&potential(), reading);
        assert_eq!(law.turns(), turns);
        assert_eq!(law.push(0.5), 0.0);
        for ((found, known), v) in rates(&law, &state().individuals(&further)).iter().zip(&known).zip(&SPEEDS) {
            close(found.velocity, *known);
            assert!((found.further[0] - heading_rate(v, known).unwrap()).abs() < 1e-12);
        }
    }
}

/// With and without spacing control, a beacon and a drift.
#[test]
fn steering_is_the_sum_over_pairs() {
    let phases = [0.3, 1.9, -2.2, 0.8];
    let flat = models::oscillator::State {
        positions: PLACES.iter().map(|r| Complex::new(r[0], r[1])).collect(),
        phasors: phases.iter().map(|t: &f64| Complex::new(t.cos(), t.sin())).collect(),
    };
    let (omega, beacon) = (-0.4, Complex::new(1.5, -0.7));
    for (spacing, gain, drift) in
        [(0.0, 0.0, (0.0, 0.0)), (0.7, 0.0, (0.2, -0.1)), (0.0, 0.3, (0.0, 0.5)), (0.7, 0.3, (1.0, 2.0))]
    {
        let law = ParticleLaw {
            frequency: omega,
            orientation: -0.6 / 4.0,
            spacing: omega * spacing / 4.0,
            beacon: (gain != 0.0).then(|| (omega * gain, beacon.clone())),
            drift: Complex::new(drift.0, drift.1),
        };
        let agents: Vec<Moving<f64, 1>> = (0..4)
            .map(|k| {
                let z = &flat.phasors[k];
                Moving { position: PLACES[k], velocity: [z.re + drift.0, z.im + drift.1], further: [phases[k]] }
            })
            .collect();
        let gains = CircularGains { omega, spacing, orientation: -0.6 };
        let control = circular_control(&gains, &Everyone, &Everyone, &flat).unwrap();
        let towards = beacon_control(&omega, &gain, &beacon, &flat).unwrap();
        for (k, found) in rates(&law, &agents).iter().enumerate() {
            let (turning, z) = (control[k] + towards[k], &flat.phasors[k]);
            assert!((found.further[0] - turning).abs() < 1e-12, "{k} {spacing} {gain}");
            close(found.velocity, [-z.im * turning, z.re * turning]);
            close(law.velocity(&agents[k]), agents[k].velocity);
        }
        assert_eq!(law.turns(), Turns::Never);
    }
}
