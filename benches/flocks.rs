//! Large groups: rates and steps of flocks with links that depend on the distance, and of phases that are all coupled.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use flockproof::arithmetic::rational;
use flockproof::double_integrator::{Potential, SwitchingFlock};
use flockproof::motion::{Rk4, VectorField};
use flockproof::oscillator::AllToAll;
use flockproof_benches::{Lcg, lattice_flock};

fn flocks(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("switching flock");
    for (columns, rows) in [(50, 20), (100, 100), (400, 250)] {
        let agents = columns * rows;
        let start = lattice_flock(columns, rows).to_list();
        let mut flock = SwitchingFlock::new(&Potential::inverse_square_log(&rational(1, 1)), 2.0).expect("a radius");
        group.throughput(Throughput::Elements(agents as u64));
        let mut rate = vec![0.0; start.len()];
        group.bench_function(BenchmarkId::new("rate, agents", agents), |b| {
            b.iter(|| flock.rate(0.0, &start, &mut rate));
        });
        let mut method = Rk4::new(start.len());
        group.bench_function(BenchmarkId::new("step, agents", agents), |b| {
            let mut state = start.clone();
            b.iter(|| {
                // Always the same step.
                state.copy_from_slice(&start);
                method.step(&mut flock, 0.0, 0.002, &mut state);
            });
        });
    }
    group.finish();
}

/// The phase model with all coupled to all: the cost of a particle in a step of order four should not depend on their number.
fn phases(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("phases");
    group.sample_size(10);
    for count in [1_000usize, 10_000, 100_000, 1_000_000] {
        group.throughput(Throughput::Elements(count as u64));
        let mut random = Lcg(5);
        let start: Vec<f64> = (0..count).map(|_| std::f64::consts::PI * random.unit()).collect();
        let (mut state, mut field, mut method) = (start, AllToAll::new(0.1, -1.0), Rk4::new(count));
        group.bench_function(BenchmarkId::new("step, particles", count), |b| {
            b.iter(|| method.step(&mut field, 0.0, 0.01, &mut state));
        });
    }
    group.finish();
}

criterion_group!(benches, phases, flocks);
criterion_main!(benches);
