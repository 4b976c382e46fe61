//! Potentials of circular formations against sums over pairs, and modes of formations against their matrices.

use arithmetic::{Complex, Dual, Field, Rational, Ring, Sign, Signed, rational};
use models::oscillator::{
    CircularGains, FourierFormation, Interaction, Mode, Neighbours, State, beacon_control, beacon_potential,
    centre_spread, circle_centres, circular_control, composite_potential, heading_components, phase_potential, phasor,
    spacing_potential,
};
use std::f64::consts::TAU;

type Exact = Complex<Rational>;

fn state() -> State<Rational> {
    let phasors = [(0, 1), (1, 2), (-5, 3), (2, 7)].map(|(p, q)| phasor(&rational(p, q)).unwrap()).to_vec();
    let places = [(1, 2), (-3, 1), (4, -5), (0, 7)].map(|(x, y)| Complex::new(rational(x, 3), rational(y, 2)));
    State { positions: places.to_vec(), phasors }
}

fn omega() -> Rational {
    rational(-2, 5)
}

fn ring() -> Neighbours {
    Neighbours::circulant(4, &[1])
}

/// `r + i z/omega`.
fn centres() -> Vec<Exact> {
    let state = state();
    let turned = |z: &Exact| Complex::new(-z.im.clone() / omega(), z.re.clone() / omega());
    state.positions.iter().zip(&state.phasors).map(|(r, z)| r.clone() + turned(z)).collect()
}

#[test]
fn potentials_are_sums_over_pairs() {
    let c = centres();
    assert_eq!(circle_centres(&omega(), &state()).unwrap(), c);
    // Half of the sum over the edges, over N.
    let edges = [(0, 1), (1, 2), (2, 3), (0, 3)];
    let total: Rational = edges.iter().map(|&(i, j): &(usize, usize)| (c[i].clone() - &c[j]).norm_squared()).sum();
    let spacing = total / rational(8, 1);
    assert_eq!(spacing_potential(&omega(), &ring(), &state()), Ok(spacing.clone()));
    let phases = phase_potential(&ring(), &state().phasors, 1).unwrap();
    let both = composite_potential(&omega(), (&rational(3, 1), &rational(-7, 2)), &ring(), &state());
    assert_eq!(both, Ok(rational(3, 1) * spacing - rational(7, 2) * phases));
    let beacon = Complex::new(rational(1, 2), rational(-3, 1));
    let total: Rational = c.iter().map(|c| (c.clone() - &beacon).norm_squared()).sum();
    assert_eq!(beacon_potential(&omega(), &beacon, &state()), Ok(total / rational(8, 1)));
    let components = heading_components(&ring(), &state().phasors, &c);
    for (k, found) in components.iter().enumerate() {
        let pull =
            ring().of_particle(k).iter().fold(Complex::real(rational(0, 1)), |sum, &j| sum + (c[k].clone() - &c[j]));
        assert_eq!(*found, state().phasors[k].dot(&pull));
    }
}

/// Particles that turn at the rates `omega + u` move their centres at the rates `-u/omega` along their headings, so that the potential of
/// the beacon falls by `gain/N` times the squares of what the control measures.
#[test]
fn the_beacon_draws_the_centres() {
    let (gain, beacon) = (rational(3, 7), Complex::new(rational(1, 2), rational(-3, 1)));
    let control = beacon_control(&omega(), &gain, &beacon, &state()).unwrap();
    let steering: Vec<Rational> = control.iter().map(|u| u + omega()).collect();
    let fixed = |z: &Exact| Complex::new(Dual::constant(z.re.clone()), Dual::constant(z.im.clone()));
    let rate = beacon_potential(&Dual::constant(omega()), &fixed(&beacon), &state().moving(&steering, &[]));
    let lost: Rational = control.iter().map(|u| u * u).sum();
    assert_eq!(rate.unwrap().derivative, -lost / (omega() * omega() * &gain * rational(4, 1)));
}

#[test]
fn the_spread_of_centres_is_the_largest_distance_from_their_mean() {
    let float = |q: &Rational| num_traits::ToPrimitive::to_f64(q).unwrap();
    let floats = |list: Vec<Exact>| list.iter().map(|z| Complex::new(float(&z.re), float(&z.im))).collect::<Vec<_>>();
    let c = floats(centres());
    let (x, y) = c.iter().fold((0.0, 0.0), |(x, y), c| (x + c.re / 4.0, y + c.im / 4.0));
    let naive = c.iter().map(|c| (c.re - x).hypot(c.im - y)).fold(0.0, f64::max);
    let flat = State { positions: floats(state().positions), phasors: floats(state().phasors) };
    assert!((centre_spread(&-0.4, &flat).unwrap() - naive).abs() < 1e-12);
    let gains = CircularGains { omega: rational(1, 3), spacing: rational(2, 5), orientation: rational(-1, 7) };
    let constant = gains.constant();
    let found = [constant.omega, constant.spacing, constant.orientation];
    for (found, known) in found.iter().zip([gains.omega, gains.spacing, gains.orientation]) {
        assert_eq!((&found.value, &found.derivative), (&known, &rational(0, 1)));
    }
}

/// `det(s - block)` at more points than the degree.
#[test]
fn the_cubic_of_a_mode_is_that_of_its_matrix() {
    let mode = Mode { omega: rational(-3, 2), pull: rational(2, 5), twist: rational(-1, 3), hessian: rational(4, 7) };
    let block = mode.block().unwrap();
    for (re, im) in [(0, 0), (1, 0), (-2, 1), (3, -1), (0, 2)] {
        let s = Complex::new(rational(re, 1), rational(im, 1));
        let entry = |i: usize, j: usize| if i == j { s.clone() - &block[i][j] } else { -block[i][j].clone() };
        let minor = |i: usize, j: usize| entry(1, i) * &entry(2, j) - entry(1, j) * &entry(2, i);
        let det = entry(0, 0) * &minor(1, 2) - entry(0, 1) * &minor(0, 2) + entry(0, 2) * &minor(0, 1);
        let cubic = mode.cubic();
        assert_eq!(cubic.len(), 4);
        let value = cubic.iter().rev().fold(Complex::real(rational(0, 1)), |sum, c| sum * &s + c);
        assert_eq!(det, value, "{s:?}");
    }
    // As it is written: adot = omega b - v/omega, bdot = -omega a, phidot = v = omega (pull a + i twist b) - hessian phi.
    let [a, b, phi] = [(2, 1), (-1, 3), (5, -4)].map(|(x, y)| Complex::new(rational(x, 1), rational(y, 1)));
    let i = Complex::new(rational(0, 1), rational(1, 1));
    let real = |x: &Rational| Complex::real(x.clone());
    let v = real(&mode.omega) * &(real(&mode.pull) * &a + i * &real(&mode.twist) * &b) - real(&mode.hessian) * &phi;
    let rates = [real(&mode.omega) * &b - real(&mode.omega.recip()) * &v, -(real(&mode.omega) * &a), v];
    for (row, rate) in block.iter().zip(rates) {
        assert_eq!(row[0].clone() * &a + row[1].clone() * &b + row[2].clone() * &phi, rate);
    }
    assert!(Mode { omega: rational(0, 1), ..mode }.block().is_err());
}

/// The wave that attains the abscissa, against the roots of every mode by deflation in floats.
#[test]
fn the_abscissa_is_attained_at_the_wave_that_is_told() {
    let real_parts = |mode: &[Complex<f64>; 4], neutral: &[Complex<f64>]| -> Vec<f64> {
        // Weierstrass' iteration.
        let value = |z: &Complex<f64>| mode.iter().rev().fold(Complex::real(0.0), |sum, c| sum * z + c);
        let mut roots: Vec<Complex<f64>> =
            (0..3).map(|k| Complex::new(0.4, 0.9).power(k) * Complex::real(0.7)).collect();
        for _ in 0..2000 {
            for k in 0..3 {
                let others = (0..3).filter(|&l| l != k);
                let product = others.fold(Complex::real(1.0), |p, l| p * &(roots[k].clone() - &roots[l]));
                if product.norm_squared() > 0.0 {
                    roots[k] = roots[k].clone() - value(&roots[k]) * &product.recip().unwrap();
                }
            }
        }
        for known in neutral {
            let off = |z: &Complex<f64>| (z.clone() - known).norm_squared();
            let nearest = (0..roots.len()).min_by(|&i, &j| off(&roots[i]).total_cmp(&off(&roots[j]))).unwrap();
            roots.swap_remove(nearest);
        }
        roots.iter().map(|z| z.re).collect()
    };
    let mut waves = std::collections::BTreeSet::new();
    for (particles, offsets, wave, gain) in [
        (7usize, vec![1], 1, (-3, 10)),
        (7, vec![1, 2], 2, (3, 10)),
        (9, vec![2], 4, (1, 2)),
        (12, vec![1], 5, (1, 1)),
        (8, vec![1, 3], 0, (-1, 5)),
    ] {
        let formation = FourierFormation::new(particles, offsets, wave, (&rational(1, 2), &rational(6, 5)));
        assert_eq!((formation.order(), formation.wave()), (particles, wave));
        let formation = formation.with_alignment(&rational(gain.0, gain.1));
        let found = formation.transverse().unwrap().unwrap();
        let float = |z: &Complex<arithmetic::RealCyclotomic>| {
            Complex::new(z.re.enclose(128).unwrap().to_f64(), z.im.enclose(128).unwrap().to_f64())
        };
        let abscissa = |q: usize| {
            let cubic = formation.mode(q).cubic();
            let neutral: Vec<_> = formation.neutral(q).iter().map(float).collect();
            let cubic = [float(&cubic[0]), float(&cubic[1]), float(&cubic[2]), float(&cubic[3])];
            real_parts(&cubic, &neutral).into_iter().fold(f64::NEG_INFINITY, f64::max)
        };
        let all: Vec<f64> = (0..=particles / 2).map(abscissa).collect();
        let most = all.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        assert!((found.abscissa.to_f64() - most).abs() < 1e-6, "{particles} {wave}: {most} {:?}", found.abscissa);
        assert!(found.abscissa.width().to_f64() < 1e-15);
        assert!(most - all[found.wave] < 1e-6, "{particles} {wave}: {all:?} {}", found.wave);
        let zeros = (0..particles).filter(|&q| formation.mode(q).hessian.sign() == Some(Sign::Zero)).count();
        assert_eq!(found.zeros, zeros);
        waves.insert(found.wave);
        for (k, z) in formation.phasors().iter().enumerate() {
            let angle = TAU * (wave * k) as f64 / particles as f64;
            let z = float(z);
            assert!((z.re - angle.cos()).abs() + (z.im - angle.sin()).abs() < 1e-12);
            assert_eq!(formation.root(k), formation.root(k + particles));
        }
    }
    assert!(waves.len() > 1, "{waves:?}");
}

/// No particles count as one; a pattern of clusters that do not divide them is none.
#[test]
fn formations_of_no_particles_are_refused_or_one() {
    let circular = (&rational(1, 2), &rational(1, 1));
    assert_eq!(FourierFormation::new(0, [], 0, circular).order(), 1);
    assert_eq!(FourierFormation::new(5, [1], 7, circular).wave(), 2);
    for (clusters, particles) in [(0, 0), (0, 4), (3, 4), (5, 4), (1, 0)] {
        assert!(FourierFormation::pattern(clusters, particles, circular, &[]).is_none());
    }
    assert_eq!(FourierFormation::pattern(2, 6, circular, &[]).unwrap().wave(), 3);
    let control = circular_control(
        &CircularGains { omega: rational(1, 2), spacing: rational(1, 1), orientation: rational(1, 1) },
        &ring(),
        &ring(),
        &State { positions: vec![], phasors: vec![] },
    );
    assert!(control.is_err() && ring().laplacian_of::<Rational>(&[]).is_empty());
}
