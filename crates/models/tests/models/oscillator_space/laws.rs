//! Laws of the particles against naive sums over angles, potentials against duals.

use arithmetic::{Complex, Dual, Rational, rational};
use models::oscillator::{
    CircularGains, Neighbours, State, beacon_control, circle_centres, circular_control, circular_formation,
    linearisation, phase_gradient, phase_potential, phasor, reference_control, relative_position_control,
    sine_of_difference, spacing_control,
};

const OMEGA: f64 = -0.4;
const PHASES: [f64; 4] = [0.3, 1.9, -2.2, 0.8];
const PLACES: [(f64, f64); 4] = [(0.0, 1.0), (2.0, -1.5), (-3.0, 0.5), (1.0, 4.0)];

fn state() -> State<f64> {
    State {
        positions: PLACES.iter().map(|&(x, y)| Complex::new(x, y)).collect(),
        phasors: PHASES.iter().map(|t| Complex::new(t.cos(), t.sin())).collect(),
    }
}

/// 1 senses 2 and 3, the others of the one before.
fn network() -> Neighbours {
    Neighbours::from_fn(4, |k, j| if k == 0 { j == 1 || j == 2 } else { j + 1 == k })
}

fn close(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-12 * (1.0 + b.abs()), "{a} {b}");
}

#[test]
fn circular_control_is_a_sum_over_neighbours() {
    let (spacing, orientation) = (0.7, -0.3);
    let gains = CircularGains { omega: OMEGA, spacing, orientation };
    let control = circular_control(&gains, &network(), &network(), &state()).unwrap();
    let form =
        relative_position_control(&OMEGA, (&(orientation - spacing), &network()), (&spacing, &network()), &state());
    for (k, (u, other)) in control.iter().zip(form.unwrap()).enumerate() {
        let centre = |j: usize| (PLACES[j].0 - PHASES[j].sin() / OMEGA, PLACES[j].1 + PHASES[j].cos() / OMEGA);
        let mut sum = OMEGA;
        for &j in network().of_particle(k) {
            let (own, theirs) = (centre(k), centre(j));
            let ahead = PHASES[k].cos() * (own.0 - theirs.0) + PHASES[k].sin() * (own.1 - theirs.1);
            sum += OMEGA * spacing / 4.0 * ahead + orientation / 4.0 * (PHASES[k] - PHASES[j]).sin();
        }
        close(*u, sum);
        close(other, sum);
    }
}

#[test]
fn beacon_control_points_along_the_heading() {
    let beacon = Complex::new(1.0, -2.0);
    let control = beacon_control(&OMEGA, &0.3, &beacon, &state()).unwrap();
    for (k, u) in control.iter().enumerate() {
        let c = (PLACES[k].0 - PHASES[k].sin() / OMEGA - 1.0, PLACES[k].1 + PHASES[k].cos() / OMEGA + 2.0);
        close(*u, OMEGA * 0.3 * (PHASES[k].cos() * c.0 + PHASES[k].sin() * c.1));
    }
}

#[test]
fn reference_control_is_a_gradient() {
    let phasors: Vec<Complex<Rational>> =
        [(1, 2), (-3, 1), (2, 5)].iter().map(|&(p, q)| phasor(&rational(p, q)).unwrap()).collect();
    let (reference, ring) = (phasor(&rational(7, 3)).unwrap(), Neighbours::circulant(3, &[1]));
    let fixed = Complex::new(Dual::constant(reference.re.clone()), Dual::constant(reference.im.clone()));
    let gradient = phase_gradient(&phasors, |z| Ok(phase_potential(&ring, z, 1)? - z[2].dot(&fixed))).unwrap();
    let gain = rational(5, 7);
    let control = reference_control(&gain, &ring, &reference, &phasors).unwrap();
    assert_eq!(control, gradient.into_iter().map(|g| g * &gain).collect::<Vec<_>>());
    assert_eq!(sine_of_difference(&reference, &reference), rational(0, 1));
}

#[test]
fn formations_have_one_centre_and_rest() {
    let omega = rational(-3, 7);
    let phasors: Vec<Complex<Rational>> =
        [(0, 1), (1, 2), (5, 3)].iter().map(|&(p, q)| phasor(&rational(p, q)).unwrap()).collect();
    let formation = circular_formation(&omega, &phasors).unwrap();
    let origin = Complex::real(rational(0, 1));
    assert!(circle_centres(&omega, &formation).unwrap().iter().all(|c| *c == origin));
    let control = spacing_control(&omega, &rational(2, 1), &Neighbours::complete(3), &formation).unwrap();
    assert!(control.iter().all(|u| *u == rational(0, 1)));
}

#[test]
fn linearisation_agrees_with_differences() {
    let gains = |omega: f64| CircularGains { omega, spacing: 0.7, orientation: -0.3 };
    let rows = linearisation(&state(), &OMEGA, |state| {
        let dual = |x: f64| Dual::constant(x);
        let gains = CircularGains { omega: dual(OMEGA), spacing: dual(0.7), orientation: dual(-0.3) };
        circular_control(&gains, &network(), &network(), state)
    })
    .unwrap();
    let field = |coordinates: &[f64]| -> Vec<f64> {
        let state = State {
            positions: (0..4).map(|k| Complex::new(coordinates[k], coordinates[4 + k])).collect(),
            phasors: (0..4).map(|k| Complex::new(coordinates[8 + k].cos(), coordinates[8 + k].sin())).collect(),
        };
        let u = circular_control(&gains(OMEGA), &network(), &network(), &state).unwrap();
        let re = state.positions.iter().zip(&state.phasors).map(|(r, z)| z.re + OMEGA * r.im);
        let im = state.positions.iter().zip(&state.phasors).map(|(r, z)| z.im - OMEGA * r.re);
        re.chain(im).chain(u).collect()
    };
    let mut at: Vec<f64> = PLACES.iter().map(|p| p.0).chain(PLACES.iter().map(|p| p.1)).chain(PHASES).collect();
    const H: f64 = 1e-5;
    for j in 0..12 {
        let start = at[j];
        at[j] = start + H;
        let above = field(&at);
        at[j] = start - H;
        let below = field(&at);
        at[j] = start;
        for i in 0..12 {
            // The error of the central difference is of the order of H².
            assert!((rows[i][j] - (above[i] - below[i]) / (2.0 * H)).abs() < 1e-8, "{i} {j}");
        }
    }
}
