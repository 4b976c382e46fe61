//! Our side of the peer workloads: prints one JSON line per configuration, like the scripts in `benches/peers/`.
//!
//! usage: cargo bench --bench peer_workloads -- [FILTER]   (FILTER keeps the configurations whose name contains it)

use flockproof::arithmetic::threads::on_a_thread;
use flockproof::arithmetic::{Interval, Rational, Unwatched, decimal, rational};
use flockproof::averaging::{FilteredFlock, Flock, Hysteresis, Start, Weights};
use flockproof::double_integrator::{Potential, State, SwitchingFlock};
use flockproof::graph::{LaplacianKind, NamedGraph};
use flockproof::matrix::{SparseMatrix, StochasticMatrix, prefix_products, product_sequential, product_tree};
use flockproof::motion::Rk4;
use flockproof::oscillator::AllToAll;
use flockproof::platoon::time_domain::Modes;
use flockproof::platoon::{Gains, resonance, theorem1};
use flockproof::question::{Question, Verdict, decide};
use flockproof::scenario::Scenario;
use flockproof::spectrum::{Eigenvalue, closed_form, matrix_spectrum, symmetric_enclosures, tridiagonal_eigenvalues};
use flockproof_benches::{
    circulant, crowd, full_of_rationals, geometric, lattice_flock, phases, ring, stochastic_matrices, weighted_path,
};
use num_bigint::BigUint;
use num_traits::ToPrimitive;
use sha2::{Digest, Sha256};
use std::hint::black_box;
use std::time::Instant;

/// Best wall time of one call over at least five trials; short calls are batched.
fn best_of<T>(mut f: impl FnMut() -> T) -> (f64, T) {
    let start = Instant::now();
    let mut result = f();
    let once = start.elapsed().as_secs_f64();
    let inner = if once < 0.2 { ((0.2 / once.max(1e-7)) as usize).max(1) } else { 1 };
    let mut best = once;
    for _ in 0..5 {
        let start = Instant::now();
        for _ in 0..inner {
            result = black_box(f());
        }
        best = best.min(start.elapsed().as_secs_f64() / inner as f64);
    }
    (best, result)
}

fn sha(text: &str) -> String {
    Sha256::digest(text.as_bytes()).iter().map(|byte| format!("{byte:02x}")).collect()
}

fn emit(workload: &str, peer: &str, size: &str, seconds: f64, checksum: &str) {
    emit_log((workload, peer, size), seconds, checksum, "");
}

/// With the text of which the checksum is, so that texts that differ can be compared.
fn emit_log((workload, peer, size): (&str, &str, &str), seconds: f64, checksum: &str, log: &str) {
    println!(
        "{{\"workload\": \"{workload}\", \"peer\": \"{peer}\", \"size\": \"{size}\", \"seconds\": {seconds:.4e}, \
         \"checksum\": \"{checksum}\", \"log\": \"{log}\"}}"
    );
}

fn joined(numbers: impl Iterator<Item = BigUint>) -> String {
    numbers.map(|x| x.to_string()).collect::<Vec<_>>().join(",")
}

fn products(wanted: &dyn Fn(&str) -> bool) {
    type Product = fn(&[StochasticMatrix]) -> StochasticMatrix;
    let sequence: (&str, Product) = ("flockproof_seq", |f| product_sequential(f).expect("factors fit"));
    let tree: (&str, Product) = ("flockproof_tree", |f| product_tree(f).expect("factors fit"));
    for n in [8usize, 16] {
        for (length, (name, product)) in [(20, sequence), (20, tree), (500, sequence), (500, tree), (5000, tree)] {
            let size = format!("n={n},T={length}");
            if wanted(&format!("W1 {name} {size}")) {
                let factors = stochastic_matrices(n, length, 1000 + n as u64);
                let (seconds, result) = best_of(|| product(&factors));
                emit("W1", name, &size, seconds, &sha(&joined(result.numerators())));
            }
        }
    }
}

fn coefficients(wanted: &dyn Fn(&str) -> bool) {
    for n in [8usize, 16] {
        let factors = stochastic_matrices(n, 500, 1000 + n as u64);
        let size = format!("n={n},T=500");
        if !wanted(&format!("W2 flockproof {size}")) {
            continue;
        }
        let (seconds, result) = best_of(|| {
            prefix_products(&factors)
                .map(|product| {
                    let product = product.expect("factors fit");
                    (product.tau_1_numerator(), product.denominator().clone())
                })
                .collect::<Vec<_>>()
        });
        let (numerator, denominator) = result.last().expect("not empty").clone();
        let tau = Rational::new(numerator.into(), denominator.into());
        emit("W2", "flockproof", &size, seconds, &sha(&format!("{}/{}", tau.numer(), tau.denom())));
    }
}

/// The enclosures rounded to 25 significant digits, which both ends must agree on, as the Arb script prints them.
fn rounded(x: &Interval) -> String {
    let (lo, hi) = x.to_rationals();
    let round = |q: &Rational| {
        // Half a unit of the 25th digit up, then down.
        let leading = q.to_f64().expect("finite").log10().floor() as i32;
        let half = rational(5, 1) * rational(10, 1).pow(leading - 25);
        decimal(&(q + half), 25, false)
    };
    assert_eq!(round(&lo), round(&hi), "not settled to 25 digits");
    round(&lo)
}

fn peaks(wanted: &dyn Fn(&str) -> bool) {
    let gains = Gains { f: rational(-1, 1), g: rational(-1, 1) };
    for followers in [128u64, 10_000, 1_000_000] {
        let size = format!("M={followers}");
        if wanted(&format!("W3 flockproof {size}")) {
            let (seconds, found) = best_of(|| resonance(&gains, followers, 25).expect("gains are negative"));
            let checksum = format!("w*={} a*={}", rounded(&found.omega), rounded(&found.amplitude));
            emit("W3", "flockproof", &size, seconds, &checksum);
        }
    }
}

/// The spectra, each as floats in order with the sizes of their bounds checked to be small.
fn spectra(wanted: &dyn Fn(&str) -> bool) {
    let sum_of_squares = |values: &[f64]| values.iter().map(|x| x * x).sum::<f64>();
    if wanted("W4 flockproof circulant n=1048576") {
        let n = 1 << 20;
        let matrix = circulant(n);
        let (seconds, found) = best_of(|| matrix.eigenvalues().expect("a bound"));
        let (h, largest) = (found.re(), found.re().iter().fold(0.0, |most: f64, x| most.max(*x)));
        let square = (2.0 * sum_of_squares(h) - h[0] * h[0] - h[n / 2] * h[n / 2]) / n as f64;
        assert!(found.radius(largest) < 1e-13 * largest);
        emit(
            "W4",
            "flockproof",
            &format!("circulant n={n}"),
            seconds,
            &format!("max={largest:.12e} meansq={square:.12e}"),
        );
    }
    let ordered = |values: &[f64]| {
        let (second, last) = (values[1], values[values.len() - 1]);
        format!("lambda2={second:.12e} max={last:.12e} sumsq={:.12e}", sum_of_squares(values))
    };
    let n = 4000;
    if wanted("W4 flockproof path_tridiag n=4000") {
        let (diagonal, beside) = weighted_path(n);
        let (seconds, found) = best_of(|| tridiagonal_eigenvalues(&diagonal, &beside).expect("a bound"));
        assert!(found.iter().all(|part| part.radius < 1e-13));
        let values: Vec<f64> = found.iter().map(|part| part.re).collect();
        emit("W4", "flockproof", &format!("path_tridiag n={n}"), seconds, &ordered(&values));
    }
    if wanted("W4 flockproof path_family n=4000") {
        let (seconds, found) =
            best_of(|| closed_form(&NamedGraph::Path(n), LaplacianKind::Combinatorial).expect("a family").floats());
        assert!(found.iter().all(|part| part.radius < 1e-13));
        let values: Vec<f64> = found.iter().map(|part| part.re).collect();
        emit("W4", "flockproof", &format!("path_family n={n}"), seconds, &ordered(&values));
    }
    let expanded = |parts: &[Eigenvalue]| -> Vec<f64> {
        assert!(parts.iter().all(|part| part.re.width().to_f64() < 1e-10));
        parts.iter().flat_map(|part| std::iter::repeat_n(part.re.to_f64(), part.multiplicity)).collect()
    };
    for (name, shuffled) in [("ring_dense", false), ("ring_perm", true)] {
        let size = format!("{name} n=1000");
        if wanted(&format!("W4 flockproof {size}")) {
            let matrix = ring(1000, shuffled);
            let (seconds, found) = best_of(|| symmetric_enclosures(&matrix).expect("a bound"));
            emit("W4", "flockproof", &size, seconds, &ordered(&expanded(&found)));
        }
    }
    if wanted("W4 flockproof rational_full n=1000") {
        let entries: Vec<(usize, usize, Rational)> = full_of_rationals(1000).collect();
        let (seconds, found) = best_of(|| {
            let matrix = SparseMatrix::from_entries(1000, entries.iter().cloned());
            symmetric_enclosures(&matrix).expect("a bound")
        });
        let values: Vec<f64> = found.iter().map(|part| part.re.to_f64()).collect();
        let largest = values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        assert!(values.len() == 1000 && found.iter().all(|part| part.re.width().to_f64() < 1e-12 * largest));
        emit("W4", "flockproof", "rational_full n=1000", seconds, &ordered(&values));
    }
    if wanted("W4 flockproof rgg_dense n=500") {
        let matrix = geometric(500);
        let (seconds, found) = best_of(|| matrix_spectrum(&matrix, None).expect("a bound"));
        let values = expanded(&found.eigenvalues);
        let below = values.iter().rev().find(|x| **x <= 1.0 - 1e-9).copied().unwrap_or(f64::NAN);
        let (trace, squares) = (values.iter().sum::<f64>(), sum_of_squares(&values));
        let checksum = format!("trace={trace:.12e} sumsq={squares:.12e} first_below_1={below:.12e}");
        emit("W4", "flockproof", "rgg_dense n=500", seconds, &checksum);
    }
}

/// 200 steps of the phase model in which all are coupled.
fn phase_model(wanted: &dyn Fn(&str) -> bool) {
    let (n, steps, dt) = (100_000, 200, 0.01);
    let size = format!("N={n},steps={steps}");
    if !wanted(&format!("W5 flockproof {size}")) {
        return;
    }
    let start = phases(n);
    let (seconds, state) = best_of(|| {
        let (mut state, mut field, mut method) = (start.clone(), AllToAll::new(0.1, -1.0), Rk4::new(n));
        (0..steps).for_each(|k| method.step(&mut field, f64::from(k) * dt, dt, &mut state));
        state
    });
    let (c, s) = AllToAll::new(0.1, -1.0).order_parameter(&state);
    let mean = state.iter().sum::<f64>() / n as f64;
    let checksum = format!("order={:.12} mean={mean:.12} theta0={:.12}", c.hypot(s), state[0]);
    emit("W5", "flockproof", &size, seconds, &checksum);
}

/// 50 steps of velocity alignment with neighbours found anew at each stage.
fn switching_flock(wanted: &dyn Fn(&str) -> bool) {
    let (steps, dt) = (50, 0.002);
    for (columns, rows) in [(50, 40), (200, 100)] {
        let n = columns * rows;
        let size = format!("N={n},steps={steps}");
        if !wanted(&format!("W6 flockproof {size}")) {
            continue;
        }
        let start = lattice_flock(columns, rows).to_list();
        let mut flock = SwitchingFlock::new(&Potential::inverse_square_log(&rational(1, 1)), 2.0).expect("a radius");
        let (seconds, state) = best_of(|| {
            let (mut state, mut method) = (start.clone(), Rk4::new(4 * n));
            on_a_thread(|| (0..steps).for_each(|k| method.step(&mut flock, f64::from(k) * dt, dt, &mut state)));
            state
        });
        let end = State::from_list(n, &state).expect("four numbers for each");
        let square = |x: &[f64; 2]| x[0] * x[0] + x[1] * x[1];
        let mean = [0, 1].map(|k| end.positions.iter().map(|x| x[k]).sum::<f64>() / n as f64);
        let spread = end.positions.iter().map(|x| square(&[x[0] - mean[0], x[1] - mean[1]])).sum::<f64>() / n as f64;
        let kinetic = end.velocities.iter().map(square).sum::<f64>() / (2 * n) as f64;
        let checksum = format!("kinetic={kinetic:.10} spread={spread:.10} x0={:.9}", end.positions[0][0]);
        emit("W6", "flockproof", &size, seconds, &checksum);
    }
}

/// Eight birds on a line, two groups of four on a collision course of their own.
fn eight_birds() -> Flock {
    let positions = (0..4).flat_map(|l| [rational(2 * l, 1), rational(6 * l + 2, 3)]).collect();
    let velocities = [1, 0, -1, 0, 1, 0, -1, 0].map(|v| rational(v, 512)).to_vec();
    Flock::new(&Start::on_the_line(positions, velocities, Weights::Lazy, Hysteresis::None)).expect("a flock")
}

fn stepping(wanted: &dyn Fn(&str) -> bool) {
    for steps in [1000usize, 10_923] {
        let size = format!("n=8,steps={steps}");
        if wanted(&format!("W7 flockproof {size}")) {
            let (seconds, flock) = best_of(|| {
                let mut flock = eight_birds();
                (0..steps).for_each(|_| drop(flock.step().expect("lazy weights suit every network")));
                flock
            });
            let positions: Vec<String> =
                flock.positions().iter().map(|x| format!("{}/{}", x[0].numer(), x[0].denom())).collect();
            emit("W7", "flockproof", &size, seconds, &sha(&positions.join(",")));
        }
    }
}

/// The exact network log of 1000 birds of the plane over 10 000 steps.
fn network_log(wanted: &dyn Fn(&str) -> bool) {
    const BIRDS: usize = 1000;
    const STEPS: usize = 10_000;
    let size = format!("n={BIRDS},steps={STEPS}");
    if wanted(&format!("W9 flockproof {size}")) {
        let start = crowd(BIRDS);
        let (seconds, log) = best_of(|| {
            let mut flock = FilteredFlock::new(&start).expect("a flock");
            let step = |_| flock.step(&Unwatched).expect("lazy weights suit every network");
            (0..STEPS).filter_map(step).collect::<Vec<_>>()
        });
        let mut entries = Vec::new();
        for switch in &log {
            let mut pairs: Vec<(usize, usize)> =
                switch.gained.iter().chain(&switch.lost).map(|&(i, j)| (j, i)).collect();
            pairs.sort_unstable();
            entries.extend(pairs.into_iter().map(|(j, i)| format!("{}:{j}-{i}", switch.time)));
        }
        let log = entries.join(",");
        emit_log(("W9", "flockproof", &size), seconds, &sha(&log), &log);
    }
}

/// The start of 128 cars behind a leader at the leading resonance: all positions and velocities at time 2000.
fn platoon(wanted: &dyn Fn(&str) -> bool) {
    const FOLLOWERS: u64 = 128;
    let size = format!("M={FOLLOWERS},t=2000");
    if wanted(&format!("W8 flockproof {size}")) {
        let gains = Gains { f: -1.0, g: -1.0 };
        let w = theorem1::frequency(&gains, FOLLOWERS).expect("negative gains");
        let (seconds, cars) = best_of(|| {
            let start = Modes::new(&gains, FOLLOWERS).and_then(|modes| modes.behind_harmonic_leader(&w));
            start.and_then(|start| start.followers(&2000.0)).expect("distinct roots")
        });
        emit("W8", "flockproof", &size, seconds, &format!("{:.8}", cars.positions[FOLLOWERS as usize - 1]));
    }
}

/// One spectral inequality, proved for all graphs on 8 vertices; making the graphs is timed, too.
fn small_graphs(wanted: &dyn Fn(&str) -> bool) {
    let size = "n=8,graphs=12346";
    if wanted(&format!("W10 flockproof {size}")) {
        let text = "[question]\nid = \"fiedler\"\n[for]\ngraph = \"all(8)\"\n[holds]\nproperty = \"lambda(2) <= n*min_degree/(n - 1)\"\n\
                    controls = [\"lambda(2) <= min_degree - 1\"]\n";
        let none = |_: &str| Err("there are no files".to_string());
        let (seconds, answer) = best_of(|| {
            let question = Question::read(text, &none).expect("a question");
            decide(&question, &Unwatched).expect("an answer")
        });
        assert!((answer.verdict, answer.cases) == (Verdict::Holds, 12_346), "{}", answer.why);
        emit("W10", "flockproof", size, seconds, "violations=0");
    }
}

/// Cucker and Smale as a law of one's own, from its text: gathered over all others, or over those within distance 2.
fn cucker_smale(gather: &str, graph: &str, state: &str, run: &str) -> String {
    format!(
        "model = \"own\"\n[law]\ndimension = 2\nstate = {{ x = \"vector\", v = \"vector\" }}\nparameters = {{ K = 1, beta = \"1/4\" }}\n\
         [law.define]\n\"weight(i, j)\" = \"K / (1 + norm2(x[j] - x[i]))^beta\"\n\
         [law.rates]\nx = \"v\"\nv = \"{gather}(j, weight(i, j) * (v[j] - v))\"\n[graph]\n{graph}\n[state]\n{state}\n[run]\nrows = 1\n\
         observables = [\"min_distance\"]\n{run}\n"
    )
}

/// Laws of one's own, as a user runs them. Reading the file is not timed.
fn laws(wanted: &dyn Fn(&str) -> bool) {
    let timed = |text: &str, trials: usize| {
        let run = || {
            let scenario = Scenario::read(text).expect("a scenario");
            let start = Instant::now();
            let outcome = scenario.run(&Unwatched);
            (start.elapsed().as_secs_f64(), outcome)
        };
        (0..trials).map(|_| run()).min_by(|a, b| a.0.total_cmp(&b.0)).expect("a trial")
    };
    let listed = |list: &[[f64; 2]]| list.iter().map(|[x, y]| format!("[{x:?}, {y:?}]")).collect::<Vec<_>>().join(", ");
    let cases = [
        ("all", 50, 40, 100, "mean", "kind = \"complete\""),
        ("near", 200, 100, 20, "sum", "kind = \"within\"\nradius = 2"),
    ];
    for (name, columns, rows, steps, gather, graph) in cases {
        let (n, size) = (columns * rows, format!("{name} N={},steps={steps}", columns * rows));
        if wanted(&format!("W12 flockproof {size}")) {
            let start = lattice_flock(columns, rows);
            let state = format!("x = [{}]\nv = [{}]", listed(&start.positions), listed(&start.velocities));
            let run = format!("until = \"{steps}/100\"\nstep = \"1/100\"");
            let (seconds, outcome) = timed(&cucker_smale(gather, graph, &state, &run), 3);
            let frame = &outcome.rows.last().expect("an end").frame;
            let kinetic = frame.velocities.iter().flatten().map(|v| v * v).sum::<f64>() / (2 * n) as f64;
            emit("W12", "flockproof", &size, seconds, &format!("kinetic={kinetic:.9} x0={:.8}", frame.positions[0][0]));
        }
    }
    if wanted("W12 flockproof three t=40") {
        let state = "x = [[0, 0], [1, 0], [0, 2]]\nv = [[1, 0], [0, 1], [0, 0]]";
        let text = cucker_smale("mean", "kind = \"complete\"", state, "until = 40\ntolerance = 1e-10");
        let (seconds, outcome) = timed(&text, 200);
        let x0 = outcome.rows.last().expect("an end").frame.positions[0][0];
        emit("W12", "flockproof", "three t=40", seconds, &format!("x0={x0:.7}"));
    }
}

fn main() {
    // Cargo passes `--bench`; everything else is the filter.
    let filter: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with("--")).collect();
    let wanted = |name: &str| filter.iter().all(|part| name.contains(part.as_str()));
    products(&wanted);
    coefficients(&wanted);
    peaks(&wanted);
    spectra(&wanted);
    phase_model(&wanted);
    switching_flock(&wanted);
    stepping(&wanted);
    network_log(&wanted);
    platoon(&wanted);
    small_graphs(&wanted);
    laws(&wanted);
}
