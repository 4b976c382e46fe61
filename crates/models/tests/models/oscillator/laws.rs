//! Laws of the phase model against naive sums over angles, and gradients against duals.

use algebra::graph::{LaplacianKind, NamedGraph, WeightedGraph};
use arithmetic::{Complex, CosineField, Dual, Rational, Ring, rational};
use models::oscillator::{
    Interaction, Neighbours, circulant_eigenvalue, clusters_of_pattern, gradient_control, laplacian_control,
    misalignment, moment, moment_gradient, moment_potential, pairwise_control, pattern_control, pattern_gradient,
    pattern_potential, phase_gradient, phase_jacobian, phase_potential, phase_potential_gradient, phasor,
    symmetric_pattern,
};

const ANGLES: [f64; 5] = [0.3, 1.7, -2.1, 2.9, -0.4];

fn floats() -> Vec<Complex<f64>> {
    ANGLES.iter().map(|a| Complex::new(a.cos(), a.sin())).collect()
}

fn exact() -> Vec<Complex<Rational>> {
    [(0, 1), (1, 2), (-3, 1), (5, 7), (-1, 1)].iter().map(|&(p, q)| phasor(&rational(p, q)).unwrap()).collect()
}

/// 1 has the neighbours 2 and 3, 2 has 3, 3 has 1 with weight 2, 4 and 5 have each other.
fn digraph() -> WeightedGraph {
    let arcs = [(0, 1, 1), (0, 2, 1), (1, 2, 1), (2, 0, 2), (3, 4, 1), (4, 3, 1)];
    WeightedGraph::from_arcs(5, arcs.map(|(i, j, weight)| (i, j, rational(weight, 1))))
}

fn close(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-13, "{a} {b}");
}

#[test]
fn moments_and_potentials_are_sums_over_angles() {
    let z = floats();
    let n = ANGLES.len() as f64;
    for m in 1..=4u32 {
        let (order, sum) = (f64::from(m), |f: fn(f64) -> f64| ANGLES.iter().map(|a| f(f64::from(m) * a)).sum::<f64>());
        let (cos, sin) = (sum(f64::cos) / (order * n), sum(f64::sin) / (order * n));
        let p = moment(&z, m).unwrap();
        close(p.re, cos);
        close(p.im, sin);
        close(moment_potential(&z, m).unwrap(), n / 2.0 * (cos * cos + sin * sin));
    }
    assert!(moment::<f64>(&[], 1).is_err());
    assert!(moment(&z, 0).is_err());
}

#[test]
fn phase_potentials_are_sums_over_arcs() {
    let (z, graph) = (floats(), digraph());
    let laplacian = graph.matrix(LaplacianKind::OutDegree).unwrap();
    for m in 1..=3u32 {
        let mut sum = 0.0;
        for (k, j, weight) in graph.adjacency().entries() {
            let weight = if *weight == rational(2, 1) { 2.0 } else { 1.0 };
            sum += weight * (1.0 - (f64::from(m) * (ANGLES[k] - ANGLES[j])).cos());
        }
        close(phase_potential(&laplacian, &z, m).unwrap(), sum / (10.0 * f64::from(m * m)));
    }
    let control = pairwise_control(&3.0, &graph, &z).unwrap();
    for k in 0..5 {
        let entries = graph.adjacency().entries().filter(|(i, _, _)| *i == k);
        let weight = |w: &Rational| if *w == rational(2, 1) { 2.0 } else { 1.0 };
        let sum: f64 = entries.map(|(_, j, w)| weight(w) * (ANGLES[k] - ANGLES[j]).sin()).sum();
        close(control[k], 3.0 * sum / 5.0);
    }
}

#[test]
fn gradients_are_those_of_the_potentials() {
    let z = exact();
    for m in 1..=4 {
        assert_eq!(moment_gradient(&z, m).unwrap(), phase_gradient(&z, |z| moment_potential(z, m)).unwrap());
    }
    let laplacian = digraph().matrix(LaplacianKind::OutDegree).unwrap();
    let claimed = phase_potential_gradient(&laplacian, &z).unwrap();
    assert_eq!(claimed, phase_gradient(&z, |z| phase_potential(&laplacian, z, 1)).unwrap());
    let gains = [2, -3, 5].map(|k| rational(k, 1));
    let slopes = phase_gradient(&z, |z| pattern_potential(&gains.clone().map(Dual::constant), z));
    assert_eq!(pattern_gradient(&gains, &z).unwrap(), slopes.unwrap());
    assert_eq!(pattern_control(&gains, &z).unwrap()[1], -pattern_gradient(&gains, &z).unwrap()[1].clone());
}

#[test]
fn the_two_controls_agree_on_the_complete_graph() {
    let (z, gain) = (exact(), rational(-7, 3));
    let complete = NamedGraph::Complete(5).build().unwrap();
    let laplacian = complete.matrix(LaplacianKind::OutDegree).unwrap();
    let control = gradient_control(&gain, &z).unwrap();
    assert_eq!(control, laplacian_control(&gain, &laplacian, &z).unwrap());
    assert_eq!(control, pairwise_control(&gain, &complete, &z).unwrap());
}

#[test]
fn hessians_are_symmetric() {
    let z = exact();
    let hessian = phase_jacobian(&z, |z| moment_gradient(z, 3)).unwrap();
    for (i, row) in hessian.iter().enumerate() {
        let column: Vec<Rational> = hessian.iter().map(|row| row[i].clone()).collect();
        assert_eq!(*row, column);
        // Rotation changes nothing.
        assert_eq!(row.iter().sum::<Rational>(), rational(0, 1));
    }
}

#[test]
fn patterns_are_recognised() {
    for particles in 1..=12 {
        for clusters in 1..=particles {
            let pattern = symmetric_pattern(clusters, particles);
            assert_eq!(pattern.is_some(), particles % clusters == 0);
            let Some(z) = pattern else { continue };
            assert_eq!(clusters_of_pattern(&z), Some(clusters));
            let next = (clusters > 1).then(|| z[..z.len() - 1].to_vec());
            assert!(next.is_none_or(|z| clusters_of_pattern(&z) != Some(clusters)));
            assert!(symmetric_pattern(0, particles).is_none());
        }
    }
    assert!(symmetric_pattern(0, 0).is_none());
    // A rhombus and three quarters of a square are none.
    let z = exact();
    assert_eq!(clusters_of_pattern(&[z[0].clone(), z[1].clone(), -z[0].clone(), -z[1].clone()]), None);
    let i = z[0].integer(0) + Complex::new(rational(0, 1), rational(1, 1));
    assert_eq!(clusters_of_pattern(&[z[0].clone(), i.clone(), -z[0].clone()]), None);
    let ring = NamedGraph::Ring(4).build().unwrap().matrix(LaplacianKind::OutDegree).unwrap();
    let rhombus = [z[0].clone(), z[1].clone(), -z[0].clone(), -z[1].clone()];
    assert!(misalignment(&ring, &rhombus).iter().all(|x| *x == rational(0, 1)));
}

#[test]
fn eigenvalues_of_circulants_belong_to_fourier_columns() {
    for (order, offsets) in [(5usize, vec![1usize]), (6, vec![1, 3, 5]), (7, vec![2, 3])] {
        let field = CosineField::new(order as u32);
        let column = |q: usize| (0..order).map(|k| field.phasor((q * k) as i64)).collect::<Vec<_>>();
        let network = Neighbours::from_fn(order, |k, j| offsets.contains(&((j + order - k) % order)));
        for q in 0..order {
            let value = circulant_eigenvalue(&column(1), offsets.iter().copied(), q);
            for (image, x) in network.laplacian_of(&column(q)).into_iter().zip(column(q)) {
                assert_eq!(image, x * &value);
            }
        }
    }
}
