//! Bounds of switches at free instants against a slow twin: sums over small steps in floats, for switches on a grid.

use flockproof_checker::check;

/// A system of two states and two modes with one input in [-1, 1], from rest.
struct System {
    a: [[[i64; 2]; 2]; 2],
    b: [[i64; 2]; 2],
    c: [[i64; 2]; 2],
}

/// Entries are quarters.
const PARTS: f64 = 4.0;

/// Steps of the twin in a unit of time.
const FINE: usize = 64;

type Order = Vec<(usize, usize)>;

impl System {
    /// Stable modes, always the same.
    fn drawn(seed: u64) -> Self {
        let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15);
        let mut next = |least: i64, most: i64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            least + ((state >> 33) as i64) % (most - least + 1)
        };
        let mut mode = || [[next(-8, -4), next(-5, 5)], [next(-3, 3), next(-9, -4)]];
        let a = [mode(), mode()];
        let mut pair = || [next(-4, 4), next(-4, 4)];
        System { a, b: [pair(), pair()], c: [pair(), pair()] }
    }

    /// The most of a row after modes in turn, each for so many small steps: the row is carried backwards.
    fn value(&self, row: [f64; 2], order: &Order) -> f64 {
        let (mut p, mut sum) = (row, 0.0);
        let h = 1.0 / FINE as f64;
        for &(mode, steps) in order.iter().rev() {
            let a = |i: usize, j: usize| self.a[mode][i][j] as f64 / PARTS;
            let turned = |p: [f64; 2]| [p[0] * a(0, 0) + p[1] * a(1, 0), p[0] * a(0, 1) + p[1] * a(1, 1)];
            let along = |p: [f64; 2], v: [i64; 2]| (p[0] * v[0] as f64 + p[1] * v[1] as f64) / PARTS;
            let rate = |p: [f64; 2]| along(p, self.c[mode]) + along(p, self.b[mode]).abs();
            for _ in 0..steps {
                // Half a step twice, by the series.
                for _ in 0..2 {
                    sum += h / 4.0 * rate(p);
                    let (mut term, mut next) = (p, p);
                    for k in 1..6 {
                        term = turned(term).map(|x| x * h / 2.0 / f64::from(k));
                        next = [next[0] + term[0], next[1] + term[1]];
                    }
                    p = next;
                    sum += h / 4.0 * rate(p);
                }
            }
        }
        sum
    }

    fn certificate(&self, switching: &str, until: &str, bound: f64, side: f64, body: &str) -> String {
        let row = |v: &[i64; 2]| format!("{} {}\n", v[0], v[1]);
        let mut modes = String::new();
        for k in 0..2 {
            modes += &format!("A over 4\n{}{}", row(&self.a[k][0]), row(&self.a[k][1]));
            modes += &format!("B over 4\n{}\n{}\nc over 4\n{}", self.b[k][0], self.b[k][1], row(&self.c[k]));
        }
        let times = if until == "ever" { "any time" } else { "any time up to the last one" };
        let scaled = |x: f64| (x * 1e6).round() as i64;
        format!(
            "flockproof-certificate 1 bound\nclaim no motion of the system of 2 linear modes and 2 states below, from a start and with inputs within their bounds and with its modes as the \
             switching below allows, comes at {times} with any of the 1 rows to a value above its bound\nstates 2\ninputs 1\nmodes 2\nstart_least over 1\n0 0\nstart_most over 1\n0 0\n\
             input_least over 1\n-1\ninput_most over 1\n1\nconstant over 1\n0\n{modes}{switching}until {until}\nrows 1\nrow over 1\n1 1\nbound over 1000000\n{}\norder free\n\
             box over 1000000\n{} {}\n{body}end\n",
            scaled(bound),
            scaled(side),
            scaled(side)
        )
    }
}

/// The most of the row that is bounded, and of the states, over orders.
fn most(system: &System, orders: &[Order]) -> (f64, f64) {
    let largest = |row: [f64; 2]| orders.iter().map(|order| system.value(row, order)).fold(0.0, f64::max);
    let side = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]].map(largest);
    (largest([1.0, 1.0]), side.into_iter().fold(0.0, f64::max))
}

/// What the twin attains is never shown to be avoided, and somewhat more is shown.
fn compared(
    system: &System,
    orders: &[Order],
    switching: &str,
    until: &str,
    bodies: &[String],
    slack: f64,
    name: &str,
) {
    let (row, side) = most(system, orders);
    let text = |bound: f64, body: &String| system.certificate(switching, until, bound, 1.5 * side, body);
    let mut shown = false;
    for body in bodies {
        let below = check(text(row - 2e-3 * (side + row), body).as_bytes());
        let reason = below.expect_err(name).reason;
        assert!(reason.contains("not shown"), "{name}: {reason}");
        shown |= check(text(row + slack * (side + row), body).as_bytes()).is_ok();
    }
    let last = bodies.last().map(|body| check(text(row + slack * (side + row), body).as_bytes()));
    assert!(shown, "{name}: {row} {side} {last:?}");
}

#[test]
fn windows_agree_with_a_slow_twin() {
    let quarter = FINE / 4;
    for seed in 0..2 {
        let system = System::drawn(seed);
        let mut orders: Vec<Order> = Vec::new();
        for end in 0..=12 {
            for first in 2..=5 {
                for second in 6..=8 {
                    let times = [first.min(end), second.min(end), end];
                    let legs = [(0, times[0]), (1, times[1] - times[0]), (0, end - times[1])];
                    orders.push(legs.iter().map(|(mode, time)| (*mode, time * quarter)).collect());
                }
            }
        }
        let switching = "switching windows\nturns 1 2 1\nwindow 1/2 5/4\nwindow 3/2 2\n";
        let body = |finer: usize| {
            format!(
                "steps {}\nsteps {}\nsteps {}\nsteps {}\nsteps {}\n",
                4 * finer,
                6 * finer,
                2 * finer,
                4 * finer,
                8 * finer
            )
        };
        compared(&system, &orders, switching, "3", &[body(1)], 0.06, &format!("windows {seed}"));
    }
}

/// Orders with durations of quarters: mode 1 first and for at least so many, mode 2 for at most two.
fn dwelling(last: usize, least: usize) -> Vec<Order> {
    let quarter = FINE / 4;
    let mut open: Vec<Order> = vec![Vec::new()];
    let mut orders = Vec::new();
    while let Some(order) = open.pop() {
        let mode = order.len() % 2;
        let past: usize = order.iter().map(|leg| leg.1 / quarter).sum();
        let longest = if mode == 0 { last - past } else { 2.min(last - past) };
        for time in 0..=longest {
            let more: Order = order.iter().copied().chain([(mode, time * quarter)]).collect();
            orders.push(more.clone());
            if (mode == 1 || time >= least) && past + time < last && order.len() < 6 {
                open.push(more);
            }
        }
    }
    orders
}

const DWELL: &str = "switching dwell\nfirst 1\nstay 1 none\nstay 0 1/2\n";

#[test]
fn dwell_times_agree_with_a_slow_twin() {
    for seed in 0..2 {
        let system = System::drawn(seed);
        let body =
            |finer: usize| format!("back 3\nlegs 8\ntime 2\nsteps {}\ntime 1/2\nsteps {}\n", 16 * finer, 4 * finer);
        compared(&system, &dwelling(6, 4), DWELL, "3/2", &[body(1)], 0.08, &format!("dwell {seed}"));
        // The next one remembers for too long.
        if seed > 0 {
            continue;
        }
        let ever =
            |finer: usize| format!("back 4\nlegs 4\ntime 4\nsteps {}\ntime 1/2\nsteps {}\n", 28 * finer, 4 * finer);
        compared(
            &system,
            &dwelling(14, 8),
            &DWELL.replace("stay 1", "stay 2"),
            "ever",
            &[ever(1)],
            0.25,
            &format!("for ever {seed}"),
        );
    }
}
