//! The certified main resonance; the cost grows like log M and with the digits.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use flockproof::arithmetic::rational;
use flockproof::platoon::{Gains, resonance};

fn resonances(c: &mut Criterion) {
    let gains = Gains { f: rational(-1, 1), g: rational(-1, 1) };
    let mut group = c.benchmark_group("resonance");
    for followers in [4u64, 128, 10_000, 1_000_000, 1_000_000_000] {
        group.bench_function(BenchmarkId::new("25 digits", followers), |b| b.iter(|| resonance(&gains, followers, 25)));
    }
    for digits in [50u32, 100, 1000] {
        group.bench_function(BenchmarkId::new("128 followers, digits", digits), |b| {
            b.iter(|| resonance(&gains, 128, digits))
        });
    }
    // Strong damping: the start comes from certified bisection.
    let damped = Gains { f: rational(-1, 1), g: rational(-1_000_000_000, 1) };
    group.bench_function("25 digits, strongly damped, 7 followers", |b| b.iter(|| resonance(&damped, 7, 25)));
    group.finish();
}

criterion_group!(benches, resonances);
criterion_main!(benches);
