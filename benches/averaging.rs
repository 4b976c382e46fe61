//! Exact flocks: stepping, and settling against the length of the answer.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use flockproof::arithmetic::{Rational, Unwatched, rational};
use flockproof::averaging::settle::{Limits, settle};
use flockproof::averaging::{FilteredFlock, Flock, Hysteresis, Start, Weights};
use flockproof_benches::crowd;
use std::hint::black_box;

/// Two groups of four birds at speed `1/speed`, the first mirrored: they merge after about `3^(speed/3)` steps.
fn two_groups(speed: i64) -> Start {
    let x: Vec<Rational> = (0..4).flat_map(|l| [rational(2 * l, 1), rational(6 * l + 2, 3)]).collect();
    let v = [0, 1, 0, -1, 1, 0, -1, 0].map(|s| rational(s, speed)).to_vec();
    Start::on_the_line(x, v, Weights::Lazy, Hysteresis::Paper)
}

fn stepping(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("1000 steps of eight birds");
    for dimension in [1usize, 2, 3] {
        let line = two_groups(512);
        let lift = |rows: &[Vec<Rational>]| -> Vec<Vec<Rational>> {
            rows.iter().map(|row| (0..dimension).map(|k| &row[0] * rational(1, k as i64 + 1)).collect()).collect()
        };
        let start = Start { positions: lift(&line.positions), velocities: lift(&line.velocities), ..line };
        group.bench_function(BenchmarkId::new("dimension", dimension), |bencher| {
            bencher.iter(|| {
                let mut flock = Flock::new(&start).expect("a flock");
                (0..1000).for_each(|_| drop(black_box(flock.step().expect("lazy weights suit every network"))));
                flock
            });
        });
    }
    group.finish();
}

fn settling(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("settle two groups");
    // Odd contact times: the groups approach.
    for speed in [63i64, 513, 4095, 32_763] {
        let start = two_groups(speed);
        let mut digits = 0;
        let mut run = || {
            let mut watch = |switch: &flockproof::averaging::Switch| {
                digits = digits.max(switch.time.to_string().len());
            };
            settle(Flock::new(&start).expect("a flock"), &Limits::default(), &mut watch, &Unwatched).expect("settles")
        };
        run();
        group.bench_function(BenchmarkId::new("digits", digits), |bencher| {
            bencher.iter(|| {
                settle(Flock::new(&start).expect("a flock"), &Limits::default(), &mut |_| {}, &Unwatched)
                    .expect("settles")
            });
        });
    }
    group.finish();
}

/// Birds of the plane: 1000 steps, and the settling decision, for three sizes each.
fn crowds(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("crowds");
    group.sample_size(10);
    for birds in [125usize, 250, 500] {
        let start = crowd(birds);
        group.bench_function(BenchmarkId::new("1000 steps, birds", birds), |bencher| {
            bencher.iter(|| {
                let mut flock = FilteredFlock::new(&start).expect("a flock");
                (0..1000)
                    .for_each(|_| drop(black_box(flock.step(&Unwatched).expect("lazy weights suit every network"))));
            });
        });
        group.bench_function(BenchmarkId::new("settle, birds", birds), |bencher| {
            bencher.iter(|| {
                settle(Flock::new(&start).expect("a flock"), &Limits::default(), &mut |_| {}, &Unwatched)
                    .expect("settles")
            });
        });
    }
    group.finish();
}

criterion_group!(benches, stepping, settling, crowds);
criterion_main!(benches);
