//! One rate of change of large flocks with links that depend on the distance, and one step of order four.

#[path = "support/mod.rs"]
mod support;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use flockproof::arithmetic::rational;
use flockproof::double_integrator::{Potential, SwitchingFlock};
use flockproof::simulate::{Rk4, VectorField};
use support::lattice_flock;

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

criterion_group!(benches, flocks);
criterion_main!(benches);
