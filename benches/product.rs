//! Exact products of stochastic matrices and their ergodicity coefficients; the cost is driven by order³ x limbs².

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use flockproof::matrix::{prefix_products, product_sequential, product_tree};
use flockproof_benches::stochastic_matrices;

fn products(c: &mut Criterion) {
    let mut group = c.benchmark_group("product");
    group.sample_size(20);
    for n in [8usize, 16] {
        let factors = stochastic_matrices(n, 500, 1000 + n as u64);
        group.bench_function(BenchmarkId::new("sequential", n), |b| b.iter(|| product_sequential(&factors)));
        group.bench_function(BenchmarkId::new("tree", n), |b| b.iter(|| product_tree(&factors)));
        group.bench_function(BenchmarkId::new("tau_1 of every prefix", n), |b| {
            b.iter(|| prefix_products(&factors).flatten().map(|p| p.tau_1_numerator()).collect::<Vec<_>>())
        });
        // One multiplication of two long products: what the splitting threshold is chosen by.
        let half = product_tree(&factors[..250]).expect("factors fit");
        group.bench_function(BenchmarkId::new("two long factors", n), |b| b.iter(|| half.times(&half)));
    }
    group.finish();
}

criterion_group!(benches, products);
criterion_main!(benches);
