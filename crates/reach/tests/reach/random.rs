//! Random systems against a twin in floats: small steps along the costate, and a grid of times.

use super::{consistent, decided};
use num_traits::ToPrimitive;
use proptest::prelude::*;
use reach::Verdict;

#[derive(Debug, Clone)]
struct Drawn {
    a: [Vec<Vec<i64>>; 2],
    b: [Vec<i64>; 2],
    input: (i64, i64),
    start: Vec<(i64, i64)>,
    row: Vec<i64>,
    period: i64,
}

fn drawn() -> impl Strategy<Value = Drawn> {
    (1usize..4).prop_flat_map(|n| {
        let matrix = move || prop::collection::vec(prop::collection::vec(-4i64..5, n), n);
        let vector = move || prop::collection::vec(-3i64..4, n);
        let range = || (-3i64..4, 0i64..4).prop_map(|(lo, width)| (lo, lo + width));
        (matrix(), matrix(), vector(), vector(), range(), prop::collection::vec(range(), n), vector(), 1i64..4)
            .prop_map(|(a0, a1, b0, b1, input, start, row, period)| Drawn {
                a: [a0, a1],
                b: [b0, b1],
                input,
                start,
                row,
                period,
            })
    })
}

impl Drawn {
    /// Entries of the matrices in quarters, the period in halves, two and a half periods.
    fn text(&self, bound: f64) -> String {
        let n = self.row.len();
        let states: Vec<String> = (0..n).map(|i| format!("\"x{i}\"")).collect();
        let start: Vec<String> =
            self.start.iter().enumerate().map(|(i, (lo, hi))| format!("x{i} = [{lo}, {hi}]")).collect();
        let row: Vec<String> = self.row.iter().enumerate().map(|(i, c)| format!("{c}*x{i}")).collect();
        let mut text = format!(
            "[system]\nstates = [{}]\ninputs = {{ u = [{}, {}] }}\nstart = {{ {} }}\n",
            states.join(", "),
            self.input.0,
            self.input.1,
            start.join(", ")
        );
        for mode in 0..2 {
            let rows: Vec<String> = self.a[mode]
                .iter()
                .map(|row| format!("[{}]", row.iter().map(|x| format!("\"{x}/4\"")).collect::<Vec<_>>().join(", ")))
                .collect();
            let b: Vec<String> = self.b[mode].iter().map(|x| format!("[{x}]")).collect();
            text += &format!("[[mode]]\nname = \"m{mode}\"\nA = [{}]\nB = [{}]\n", rows.join(", "), b.join(", "));
        }
        text + &format!(
            "[switching]\nkind = \"periodic\"\norder = [\"m0\", \"m1\"]\nperiod = \"{}/2\"\n[run]\nuntil = \"{}/4\"\n[[check]]\nholds = \"{} + 0 <= {bound:.12}\"\n",
            self.period,
            5 * self.period,
            row.join(" + ")
        )
    }

    /// The greatest value at a time, by the middle rule along the costate, with steps that end at the switches.
    fn naive(&self, time: f64) -> f64 {
        let n = self.row.len();
        let period = self.period as f64 / 2.0;
        let mut p: Vec<f64> = self.row.iter().map(|x| *x as f64).collect();
        let mut sum = 0.0;
        for piece in (0..3).rev().filter(|piece| f64::from(*piece) * period < time) {
            let mode = piece as usize % 2;
            let length = time.min(f64::from(piece + 1) * period) - f64::from(piece) * period;
            let steps = (length * 2000.0).ceil() as usize;
            let h = length / steps.max(1) as f64;
            let rate = |p: &[f64]| -> Vec<f64> {
                (0..n).map(|j| (0..n).map(|i| self.a[mode][i][j] as f64 / 4.0 * p[i]).sum()).collect()
            };
            for _ in 0..steps {
                let half: Vec<f64> = p.iter().zip(rate(&p)).map(|(x, r)| x + h / 2.0 * r).collect();
                let g: f64 = half.iter().zip(&self.b[mode]).map(|(p, b)| p * *b as f64).sum();
                sum += h * (g * self.input.0 as f64).max(g * self.input.1 as f64);
                p = p.iter().zip(rate(&half)).map(|(x, r)| x + h * r).collect();
            }
        }
        sum + p.iter().zip(&self.start).map(|(p, (lo, hi))| (p * *lo as f64).max(p * *hi as f64)).sum::<f64>()
    }

    fn naive_worst(&self) -> f64 {
        let until = 5.0 * self.period as f64 / 4.0;
        (0..=60).map(|k| self.naive(until * f64::from(k) / 60.0)).fold(f64::NEG_INFINITY, f64::max)
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, ..ProptestConfig::default() })]

    #[test]
    fn worst_cases_are_those_of_the_twin(drawn in drawn()) {
        prop_assume!(drawn.row.iter().any(|x| *x != 0));
        let naive = drawn.naive_worst();
        let found = decided(&drawn.text(0.0), 9).remove(0);
        let part = &found.parts[0];
        consistent(part);
        let (lo, hi) = (part.lo.clone().expect("lo").to_f64().expect("finite"), part.hi.clone().expect("hi").to_f64().expect("finite"));
        let scale = naive.abs().max(1.0);
        prop_assert!(hi - lo <= 1e-8 * scale, "{lo} {hi}");
        // No motion of the twin is worse, but for its own steps.
        prop_assert!(naive <= hi + 1e-3 * scale, "{naive} above {hi}");
        // The grid of times misses the worst one by little.
        prop_assert!(naive >= lo - 0.15 * scale, "{naive} far below {lo}");
        // Statements that are false, and true, by little.
        let margin = 1e-6 * scale;
        let verdict = |bound: f64| decided(&drawn.text(bound), 9)[0].verdict;
        prop_assert_eq!(verdict(lo - margin), Verdict::False);
        prop_assert_eq!(verdict(hi + margin), Verdict::Holds);
    }
}
