//! Interval operations at the precision that most enclosures use.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use flockproof::arithmetic::{Field, Interval, Number, Ring, rational};
use std::hint::black_box;

fn intervals(c: &mut Criterion) {
    let mut group = c.benchmark_group("interval");
    for precision in [64u32, 192, 1024] {
        let x = Interval::from_rational(&rational(1, 3), precision);
        let y = Interval::from_rational(&rational(-22, 7), precision);
        let name = |operation| BenchmarkId::new(operation, precision);
        group.bench_function(name("add"), |b| b.iter(|| black_box(&x).clone() + black_box(&y)));
        group.bench_function(name("mul"), |b| b.iter(|| black_box(&x).clone() * black_box(&y)));
        group.bench_function(name("square"), |b| b.iter(|| black_box(&x).square()));
        group.bench_function(name("div"), |b| b.iter(|| black_box(&x).over(black_box(&y))));
        group.bench_function(name("sqrt"), |b| b.iter(|| black_box(&x).sqrt()));
        group.bench_function(name("exp"), |b| b.iter(|| black_box(&x).exp()));
        group.bench_function(name("ln"), |b| b.iter(|| black_box(&x).ln()));
        group.bench_function(name("sin and cos"), |b| b.iter(|| black_box(&x).sin_cos()));
        group.bench_function(name("atan"), |b| b.iter(|| black_box(&x).atan()));
    }
    group.finish();
}

criterion_group!(benches, intervals);
criterion_main!(benches);
