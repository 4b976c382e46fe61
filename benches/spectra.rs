//! Spectra with proved bounds, by method and size.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use flockproof::graph::{LaplacianKind, NamedGraph};
use flockproof::spectrum::{Circulant, closed_form, matrix_spectrum, symmetric_enclosures, tridiagonal_eigenvalues};
use flockproof_benches::{Lcg, circulant, geometric, ring, weighted_path};

fn circulants(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("circulant");
    for bits in [10u32, 15, 20] {
        let few = circulant(1 << bits);
        group.bench_function(BenchmarkId::new("16 offsets, order 2^", bits), |b| b.iter(|| few.eigenvalues()));
        for n in [1usize << bits, (1 << bits) - 1] {
            let mut random = Lcg(1);
            let row: Vec<f64> = (0..n).map(|_| random.unit() - 0.5).collect();
            let full = Circulant::from_first_row(&row).expect("in range");
            group.bench_function(BenchmarkId::new("all offsets, order", n), |b| b.iter(|| full.eigenvalues()));
        }
    }
    group.finish();
}

fn matrices(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("matrix");
    group.sample_size(10);
    for n in [1000usize, 4000] {
        let (diagonal, beside) = weighted_path(n);
        group.bench_function(BenchmarkId::new("weighted path", n), |b| {
            b.iter(|| tridiagonal_eigenvalues(&diagonal, &beside))
        });
        let form = || closed_form(&NamedGraph::Path(n), LaplacianKind::Combinatorial).expect("a family");
        group.bench_function(BenchmarkId::new("path, 15 digits", n), |b| b.iter(|| form().floats()));
        group.bench_function(BenchmarkId::new("path, 20 digits", n), |b| b.iter(|| form().enclose(20)));
    }
    for n in [250usize, 500, 1000] {
        let matrix = ring(n, true);
        group.bench_function(BenchmarkId::new("shuffled ring", n), |b| b.iter(|| symmetric_enclosures(&matrix)));
    }
    for n in [250usize, 500] {
        let matrix = geometric(n);
        group.bench_function(BenchmarkId::new("geometric graph", n), |b| b.iter(|| matrix_spectrum(&matrix, None)));
    }
    group.finish();
}

criterion_group!(benches, circulants, matrices);
criterion_main!(benches);
