//! The float motion: against a fixed-step twin, conserved momentum, falling energy.

use algebra::graph::Graph;
use arithmetic::{Unwatched, rational};
use models::double_integrator::{
    Alignment, Coordinates, Flock, Network, Options, Pair, Potential, State, Vector, disagreement, follow,
    random_flock, velocity_alignment,
};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

const PLANE: Coordinates = Coordinates::Cartesian;
const EDGES: [Pair; 3] = [(0, 1), (1, 2), (2, 3)];

fn law(state: &State<f64>) -> Vec<Vector<f64>> {
    let potential = Potential::inverse_square_log(&rational(1, 1));
    velocity_alignment(state, &EDGES, PLANE, |_, _, s| potential.slope(s)).unwrap()
}

/// The classical method of order 4 with a fixed step.
fn naive(start: &State<f64>, until: f64, steps: usize) -> State<f64> {
    let h = until / steps as f64;
    let add = |s: &State<f64>, d: &(Vec<Vector<f64>>, Vec<Vector<f64>>), by: f64| State {
        positions: s.positions.iter().zip(&d.0).map(|(r, v)| [r[0] + by * v[0], r[1] + by * v[1]]).collect(),
        velocities: s.velocities.iter().zip(&d.1).map(|(v, a)| [v[0] + by * a[0], v[1] + by * a[1]]).collect(),
    };
    let rate = |s: &State<f64>| (s.velocities.clone(), law(s));
    (0..steps).fold(start.clone(), |s, _| {
        let k1 = rate(&s);
        let k2 = rate(&add(&s, &k1, h / 2.0));
        let k3 = rate(&add(&s, &k2, h / 2.0));
        let k4 = rate(&add(&s, &k3, h));
        [(k1, 1.0), (k2, 2.0), (k3, 2.0), (k4, 1.0)].iter().fold(s, |s, (k, w)| add(&s, k, h * w / 6.0))
    })
}

fn start() -> State<f64> {
    State {
        positions: vec![[0.0, 0.0], [1.2, 0.1], [2.0, 1.0], [0.5, 2.0]],
        velocities: vec![[1.0, 0.0], [0.0, -0.5], [0.3, 0.3], [-0.2, 0.1]],
    }
}

fn flock() -> Flock {
    let potential = Potential::inverse_square_log(&rational(1, 1));
    let network = Network::Fixed(Graph::from_edges(4, &EDGES).unwrap());
    Flock::new(Alignment::Velocity, potential, network, start()).unwrap()
}

#[test]
fn both_methods_agree() {
    let found = flock().run(3.0, &[3.0], &Options::default(), &Unwatched).unwrap().samples.remove(0).state;
    let by_law = follow(&start(), &[3.0], Options::default().tolerance, |s| Ok(law(s))).unwrap().remove(0);
    let naive = naive(&start(), 3.0, 3000);
    for (a, b) in found.positions.iter().chain(&found.velocities).zip(naive.positions.iter().chain(&naive.velocities)) {
        assert!((a[0] - b[0]).abs() < 1e-9 && (a[1] - b[1]).abs() < 1e-9, "{a:?} {b:?}");
    }
    for (a, b) in found.positions.iter().zip(&by_law.positions) {
        assert!((a[0] - b[0]).abs() < 1e-8 && (a[1] - b[1]).abs() < 1e-8, "{a:?} {b:?}");
    }
}

#[test]
fn momentum_stays_and_energy_falls() {
    let times: Vec<f64> = (0..=200).map(|k| f64::from(k) / 10.0).collect();
    let motion = flock().run(20.0, &times, &Options::default(), &Unwatched).unwrap();
    assert!(motion.energy.is_monotone(), "{:?}", motion.energy);
    assert!(motion.samples.windows(2).all(|w| w[1].energy <= w[0].energy + 1e-9));
    assert_eq!(motion.samples[0].energy, motion.energy.first);
    let end = &motion.samples[200].state;
    let momentum = |s: &State<f64>| s.velocities.iter().map(|v| v[0]).sum::<f64>();
    assert!((momentum(end) - momentum(&start())).abs() < 1e-9);
    assert!(disagreement(end) < 0.01 * disagreement(&start()));
}

#[test]
fn random_flocks_repeat() {
    let draw = || random_flock(10, 2.5, 1.0, &mut ChaCha8Rng::seed_from_u64(5));
    assert_eq!(draw(), draw());
    assert!(draw().positions.iter().flatten().all(|x| x.abs() < 2.5));
    assert!(draw().velocities.iter().all(|v| PLANE.square(v) < 1.0));
}
