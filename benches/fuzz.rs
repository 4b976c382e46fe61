//! Random cases of the built-in invariants, on one thread: the time of one case.

use criterion::{Criterion, criterion_group, criterion_main};
use flockproof::campaign::fuzz::one_case;
use flockproof::campaign::invariants::{Tested, find};

fn cases(c: &mut Criterion) {
    let mut group = c.benchmark_group("fuzz");
    for name in ["matrix.tau_1_of_products", "interval.contains_exact", "energy.velocity_alignment", "spectrum.exact"] {
        let Some(invariant) = find(name) else { continue };
        let mut case = 0;
        group.bench_function(name, |b| {
            b.iter(|| {
                case += 1;
                one_case(invariant, "bench", case, Tested::AsItIs)
            })
        });
    }
    group.finish();
}

criterion_group!(benches, cases);
criterion_main!(benches);
