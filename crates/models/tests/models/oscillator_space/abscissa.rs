//! Enclosed abscissae against the eigenvalues of the whole linearisation in floats.

use arithmetic::{ArithmeticError, Complex, Dual, Rational, Ring, rational};
use faer::{Mat, c64};
use models::oscillator::{
    CircularGains, FourierFormation, Neighbours, State, circular_control, circular_formation, linearisation,
    pattern_control, spacing_control,
};
use std::f64::consts::TAU;

/// The largest real part without the eigenvalues nearest to these.
fn naive(
    phases: &[f64],
    omega: f64,
    removed: &[c64],
    steering: impl Fn(&State<Dual<f64>>) -> Result<Vec<Dual<f64>>, ArithmeticError>,
) -> f64 {
    let phasors: Vec<Complex<f64>> = phases.iter().map(|t| Complex::new(t.cos(), t.sin())).collect();
    let rows = linearisation(&circular_formation(&omega, &phasors).unwrap(), &omega, steering).unwrap();
    let matrix = Mat::from_fn(rows.len(), rows.len(), |i, j| rows[i][j]);
    let eigen = matrix.eigen().unwrap();
    let mut values: Vec<c64> = (0..rows.len()).map(|i| eigen.S()[i]).collect();
    for root in removed {
        let distance = |z: &c64| (z - root).norm();
        let nearest = (0..values.len()).min_by(|&i, &j| distance(&values[i]).total_cmp(&distance(&values[j]))).unwrap();
        assert!(distance(&values[nearest]) < 1e-7, "{root} is no eigenvalue");
        values.swap_remove(nearest);
    }
    values.iter().map(|z| z.re).fold(f64::NEG_INFINITY, f64::max)
}

fn symmetries(omega: f64) -> [c64; 3] {
    [c64::new(0.0, 0.0), c64::new(0.0, omega), c64::new(0.0, -omega)]
}

fn float(q: &Rational) -> f64 {
    q.numer().to_string().parse::<f64>().unwrap() / q.denom().to_string().parse::<f64>().unwrap()
}

#[test]
fn patterns_agree_with_the_whole_matrix() {
    for (omega, spacing, below, last) in [((1, 10), (1, 10), (1, 5), (-1, 25)), ((-2, 1), (3, 2), (-1, 7), (1, 3))] {
        let [omega, spacing, below, last] = [omega, spacing, below, last].map(|(p, q)| rational(p, q));
        for particles in [2usize, 3, 5, 8, 12, 18, 24, 30] {
            for clusters in (1..=particles).filter(|m| particles.is_multiple_of(*m)) {
                let gain = |m: usize| if m < clusters { below.clone() * rational(1, m as i64) } else { last.clone() };
                let gains: Vec<Rational> = (1..=clusters).map(gain).collect();
                let formation = FourierFormation::pattern(clusters, particles, (&omega, &spacing), &gains).unwrap();
                let found = formation.transverse().unwrap().unwrap();
                assert_eq!(found.zeros, 1);
                let phases: Vec<f64> = (0..particles).map(|k| TAU * k as f64 / clusters as f64).collect();
                let network = Neighbours::complete(particles);
                let value = naive(&phases, float(&omega), &symmetries(float(&omega)), |state| {
                    let constant = |q: &Rational| Dual::constant(float(q));
                    let pulled = spacing_control(&constant(&omega), &constant(&spacing), &network, state)?;
                    let gains: Vec<Dual<f64>> = gains.iter().map(constant).collect();
                    let turned = pattern_control(&gains, &state.phasors)?;
                    Ok(pulled.into_iter().zip(turned).map(|(s, o)| s + o).collect())
                });
                let enclosed = found.abscissa.to_f64();
                assert!((value - enclosed).abs() < 1e-9, "({clusters},{particles}): {value} {enclosed}");
            }
        }
    }
}

#[test]
fn twisted_states_agree_with_the_whole_matrix() {
    for gain in [rational(-3, 10), rational(3, 10), rational(1, 1)] {
        for (particles, offsets) in [(12usize, vec![1]), (12, vec![1, 6]), (7, vec![1, 2])] {
            for wave in (0..particles).filter(|wave| !(4 * wave).is_multiple_of(particles) || *wave == 0) {
                let (omega, spacing) = (rational(1, 10), rational(6, 5));
                let formation = FourierFormation::new(particles, offsets.clone(), wave, (&omega, &spacing));
                let found = formation.with_alignment(&gain).transverse().unwrap().unwrap();
                let network = Neighbours::circulant(particles, &offsets);
                let gains = CircularGains { omega: 0.1, spacing: 1.2, orientation: float(&gain) }.constant();
                let phases: Vec<f64> = (0..particles).map(|k| TAU * (wave * k) as f64 / particles as f64).collect();
                let mut removed = symmetries(0.1).to_vec();
                removed.resize(removed.len() + found.zeros - 1, c64::new(0.0, 0.0));
                let value = naive(&phases, 0.1, &removed, |state| circular_control(&gains, &network, &network, state));
                let enclosed = found.abscissa.to_f64();
                assert!((value - enclosed).abs() < 1e-8, "{offsets:?}, m = {wave}, {gain}: {value} {enclosed}");
            }
        }
    }
}

#[test]
fn only_eigenvalues_are_removed() {
    let (omega, spacing) = (rational(1, 10), rational(1, 10));
    let gains = [rational(1, 5), rational(1, 5), rational(-1, 25)];
    let formation = FourierFormation::pattern(3, 12, (&omega, &spacing), &gains).unwrap();
    assert!(formation.without(|_| vec![Complex::real(formation.root(0).re.one())]).is_err());
    assert!(formation.without(|q| formation.neutral(q + 1)).is_err());
    let count: usize = (0..12).map(|q| formation.neutral(q).len()).sum();
    assert_eq!(count, 3);
    let kept = formation.without(|_| Vec::new()).unwrap().unwrap();
    assert!(kept.abscissa.contains_zero());
    assert!(FourierFormation::pattern(5, 12, (&omega, &spacing), &gains).is_none());
    let alone = FourierFormation::pattern(1, 1, (&omega, &spacing), &gains[2..]).unwrap();
    assert!(alone.transverse().unwrap().is_none());
}
