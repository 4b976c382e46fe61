//! The noisy flock against a naive twin.

use arithmetic::random::{generator, uniform};
use models::averaging::{NoisyError, NoisyFlock};
use std::f64::consts::TAU;

/// The shortest vector from one place to the other in the periodic square.
fn shortest(a: [f64; 2], b: [f64; 2], side: f64) -> [f64; 2] {
    [0, 1].map(|axis| {
        let d = b[axis] - a[axis];
        d - side * (d / side).round()
    })
}

#[test]
fn neighbours_and_steps_are_those_of_all_pairs() {
    for (count, side, radius) in [(40, 3.0, 1.0), (25, 2.0, 1.0), (60, 10.0, 1.5), (1, 5.0, 1.0)] {
        let mut random = generator("noisy", "start", count as u64);
        let positions: Vec<[f64; 2]> =
            (0..count).map(|_| [side * uniform(&mut random), side * uniform(&mut random)]).collect();
        let headings: Vec<f64> = (0..count).map(|_| TAU * uniform(&mut random)).collect();
        let mut flock = NoisyFlock { positions, headings, side, radius, speed: 0.3, noise: 0.0 };
        for _ in 0..20 {
            let before = flock.clone();
            let near = |i: usize, j: usize| {
                let [x, y] = shortest(before.positions[i], before.positions[j], side);
                x.hypot(y) < radius
            };
            let links: Vec<(usize, usize)> =
                (0..count).flat_map(|i| (i + 1..count).map(move |j| (i, j))).filter(|(i, j)| near(*i, *j)).collect();
            assert_eq!(flock.links().unwrap(), links);
            flock.step(&mut random).unwrap();
            for i in 0..count {
                let theta = before.headings[i];
                let moved = [0, 1].map(|k| before.positions[i][k] + 0.3 * [theta.cos(), theta.sin()][k]);
                let [x, y] = shortest(flock.positions[i], moved, side);
                assert!(x.hypot(y) < 1e-12 && flock.positions[i].iter().all(|x| (0.0..side).contains(x)));
                let sum = (0..count).filter(|&j| j == i || near(i, j)).fold([0.0, 0.0], |sum: [f64; 2], j| {
                    [sum[0] + before.headings[j].cos(), sum[1] + before.headings[j].sin()]
                });
                let turned = flock.headings[i] - sum[1].atan2(sum[0]);
                // Sums in another order; the mean of nearly opposite headings is not compared.
                assert!(sum[0].hypot(sum[1]) < 1e-6 || (turned - TAU * (turned / TAU).round()).abs() < 1e-9);
            }
        }
    }
}

#[test]
fn noise_stays_in_its_range() {
    let mut random = generator("noisy", "noise", 0);
    let mut flock =
        NoisyFlock { positions: vec![[0.5, 0.5]], headings: vec![0.0], side: 2.0, radius: 1.0, speed: 0.1, noise: 0.5 };
    let mut largest = 0.0f64;
    for _ in 0..1000 {
        let before = flock.headings[0];
        let drawn = uniform(&mut random.clone()) - 0.5;
        flock.step(&mut random).unwrap();
        let turned = flock.headings[0] - before.sin().atan2(before.cos());
        assert!((turned - 0.5 * drawn).abs() < 1e-14);
        assert!(turned.abs() <= 0.25 + 1e-12);
        largest = largest.max(turned.abs());
    }
    assert!(largest > 0.2);
}

/// Just below zero the remainder is rounded to the side, which is zero again.
#[test]
fn places_are_wrapped_into_the_square() {
    let flock = NoisyFlock { positions: vec![], headings: vec![], side: 2.0, radius: 1.0, speed: 0.1, noise: 0.0 };
    let wrapped = [-1e-20, 0.0, 1.5, 2.0, 3.5, -0.5].map(|x| flock.wrapped(x));
    assert_eq!(wrapped, [0.0, 0.0, 1.5, 0.0, 1.5, 1.5]);
}

#[test]
fn birds_without_a_heading_are_refused() {
    let mut random = generator("noisy", "headings", 0);
    for (birds, found) in [(2, 1), (1, 2), (0, 1)] {
        let (positions, headings) = (vec![[0.5, 0.5]; birds], vec![0.0; found]);
        let mut flock = NoisyFlock { positions, headings, side: 2.0, radius: 1.0, speed: 0.1, noise: 0.0 };
        assert_eq!(flock.step(&mut random), Err(NoisyError::Headings { birds, found }));
    }
}
