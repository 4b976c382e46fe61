//! The exact motion of the platoon in time: one car and all cars, in floats and enclosed.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use flockproof::arithmetic::{Interval, rational};
use flockproof::platoon::Gains;
use flockproof::platoon::time_domain::Modes;

fn motions(c: &mut Criterion) {
    let mut group = c.benchmark_group("platoon");
    for followers in [32u64, 128, 1024] {
        let modes = Modes::new(&Gains { f: -1.0, g: -1.0 }, followers).expect("distinct roots");
        let harmonic = modes.behind_harmonic_leader(&(1.0 / followers as f64)).expect("a periodic motion");
        let abrupt = modes.behind_accelerating_leader(&[(0.0, 1.0), (10.0, -1.0)]).expect("distinct roots");
        let named = |name| BenchmarkId::new(name, followers);
        group.bench_function(named("modes"), |b| b.iter(|| Modes::new(&Gains { f: -1.0, g: -1.0 }, followers)));
        group.bench_function(named("last car"), |b| b.iter(|| harmonic.last(&2000.0)));
        group.bench_function(named("all cars"), |b| b.iter(|| harmonic.followers(&2000.0)));
        group.bench_function(named("all cars after an abrupt start"), |b| b.iter(|| abrupt.deviations(&2000.0)));
    }
    let interval = |p, q| Interval::from_rational(&rational(p, q), 72);
    let modes = Modes::new(&Gains { f: interval(-1, 1), g: interval(-1, 1) }, 32).expect("distinct roots");
    let enclosed = modes.behind_harmonic_leader(&interval(1, 32)).expect("a periodic motion");
    group.bench_function("last of 32 cars, enclosed", |b| b.iter(|| enclosed.last(&interval(2000, 1))));
    group.finish();
}

criterion_group!(benches, motions);
criterion_main!(benches);
