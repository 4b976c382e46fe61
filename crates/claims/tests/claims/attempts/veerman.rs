//! The statements of Veerman, Stosic and Olvera: platoons in floats, solved from their equations of motion.

use super::{Dice, close};
use std::f64::consts::{PI, SQRT_2};

/// A complex number.
#[derive(Clone, Copy, Debug)]
struct Z(f64, f64);

impl Z {
    fn plus(self, b: Z) -> Z {
        Z(self.0 + b.0, self.1 + b.1)
    }
    fn minus(self, b: Z) -> Z {
        Z(self.0 - b.0, self.1 - b.1)
    }
    fn times(self, b: Z) -> Z {
        Z(self.0 * b.0 - self.1 * b.1, self.0 * b.1 + self.1 * b.0)
    }
    fn over(self, b: Z) -> Z {
        let size = b.0 * b.0 + b.1 * b.1;
        self.times(Z(b.0 / size, -b.1 / size))
    }
    fn scaled(self, x: f64) -> Z {
        Z(self.0 * x, self.1 * x)
    }
    fn size(self) -> f64 {
        self.0.hypot(self.1)
    }
    fn power(self, k: usize) -> Z {
        (0..k).fold(Z(1.0, 0.0), |p, _| p.times(self))
    }
    /// The principal root.
    fn root(self) -> Z {
        let (r, angle) = (self.size().sqrt(), self.1.atan2(self.0) / 2.0);
        Z(r * angle.cos(), r * angle.sin())
    }
    fn is(self, b: Z) -> bool {
        self.minus(b).size() <= 1e-8 * (1.0 + self.size())
    }
}

fn gamma(f: f64, g: f64, w: f64) -> Z {
    Z(f + w * w, w * g).over(Z(f, w * g))
}

/// `a_0 = 1, .., a_M` of system (2), from the last car to the leader.
fn two_sided(f: f64, g: f64, w: f64, m: usize) -> Vec<Z> {
    let gamma = gamma(f, g, w);
    let mut back = vec![Z(1.0, 0.0), gamma];
    for k in 1..m {
        back.push(gamma.times(back[k]).scaled(2.0).minus(back[k - 1]));
    }
    back.iter().rev().map(|b| b.over(back[m])).collect()
}

fn response(f: f64, g: f64, w: f64, m: usize) -> f64 {
    two_sided(f, g, w, m)[m].size()
}

/// Where a function is largest between two arguments: a grid, then golden section.
fn highest(low: f64, high: f64, grid: usize, value: impl Fn(f64) -> f64) -> f64 {
    let step = (high - low) / grid as f64;
    let at = |k: usize| low + step * k as f64;
    let (_, best) = (0..=grid).map(|k| (value(at(k)), k)).max_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
    let (mut a, mut b) = (at(best.max(1) - 1), at((best + 1).min(grid)));
    let golden = 0.618_033_988_749_894_9;
    let (mut c, mut d) = (b - golden * (b - a), a + golden * (b - a));
    let (mut at_c, mut at_d) = (value(c), value(d));
    // 0.618^70 is below the last digit.
    for _ in 0..70 {
        if at_c > at_d {
            (b, d, at_d) = (d, c, at_c);
            c = b - golden * (b - a);
            at_c = value(c);
        } else {
            (a, c, at_c) = (c, d, at_d);
            d = a + golden * (b - a);
            at_d = value(d);
        }
    }
    (a + b) / 2.0
}

/// Frequency and size of the main resonance, whose place is looked for up to twice sqrt|f|.
fn main_resonance(f: f64, g: f64, m: usize) -> (f64, f64) {
    let guess = (-f).sqrt() * PI / (2.0 * SQRT_2 * m as f64);
    let coarse = highest(0.0, 2.0 * (-f).sqrt(), 40 * m.min(60), |w| response(f, g, w, m));
    let near = highest(0.5 * guess, 1.5 * guess, 200, |w| response(f, g, w, m));
    let w = if response(f, g, coarse, m) > response(f, g, near, m) { coarse } else { near };
    (w, response(f, g, w, m))
}

fn gains(dice: &mut Dice) -> (f64, f64) {
    (-10f64.powf(dice.between(-2.0, 2.0)), -10f64.powf(dice.between(-2.0, 2.0)))
}

/// veerman.eq1_matrix, eq2_matrix, dimL: the vector form with the printed matrices against the printed equations; one car alone too.
#[test]
fn vector_forms() {
    let mut dice = Dice::new("vector forms");
    for _ in 0..200 {
        let (n, two) = (1 + dice.below(6), dice.below(2) == 1);
        let (f, g) = (dice.between(-2.0, 2.0), dice.between(-2.0, 2.0));
        let y: Vec<f64> = (0..=n).map(|_| dice.between(-1.0, 1.0)).collect();
        let u: Vec<f64> = (0..=n).map(|_| dice.between(-1.0, 1.0)).collect();
        let laplacian = |i: usize, j: usize| match (i == j, i.abs_diff(j) == 1, two && i < n) {
            (true, ..) => 1.0,
            (_, true, true) => -0.5,
            (_, true, false) if i > j => -1.0,
            _ => 0.0,
        };
        for k in 1..=n {
            let form: f64 = (0..=n).map(|j| laplacian(k, j) * (f * y[j] + g * u[j])).sum();
            let average = |z: &[f64]| if two && k < n { (z[k - 1] + z[k + 1]) / 2.0 } else { z[k - 1] };
            assert!(close(form, f * (y[k] - average(&y)) + g * (u[k] - average(&u))));
        }
    }
}

/// veerman.specP2, eigAK, lem1, beyond.veerman.specM, decay_rate: determinants at the printed numbers, and roots of all modes.
#[test]
fn spectra() {
    // det(P_2 - x) by its recurrence from the last row.
    let determinant = |m: usize, x: f64| {
        // Rows M, M-1, ..: d_1 = 1 - x, d_2 = (1-x)² - 1/2, then d_k = (1-x) d_(k-1) - d_(k-2)/4.
        let (mut before, mut d) = (1.0, 1.0 - x);
        for k in 2..=m {
            (before, d) = (d, (1.0 - x) * d - if k == 2 { 0.5 } else { 0.25 } * before);
        }
        d
    };
    let angle = |m: usize, k: usize| (2 * k - 1) as f64 * PI / (2 * m) as f64;
    for m in 1..=20 {
        for k in 1..=m {
            // Simple: the slope is not zero (it is of the order 2^-m).
            let (x, h) = (1.0 - angle(m, k).cos(), 1e-7);
            let slope = (determinant(m, x + h) - determinant(m, x - h)) / (2.0 * h);
            assert!((determinant(m, x) / slope).abs() < 1e-9 && slope.abs() > 0.5f64.powi(m as i32), "{m}, {k}");
        }
    }
    let mut dice = Dice::new("spectra");
    for _ in 0..400 {
        let (f, g) = [(-1.0, 1.0), (1.0, -1.0), (0.0, -1.0), (-1.0, 0.0), gains(&mut dice)][dice.below(5)];
        let m = 1 + dice.below(40);
        let roots = |lambda: f64| {
            let d = Z(lambda * g * lambda * g + 4.0 * lambda * f, 0.0).root();
            [Z(lambda * g, 0.0).plus(d).scaled(0.5), Z(lambda * g, 0.0).minus(d).scaled(0.5)]
        };
        let mut slowest = f64::NEG_INFINITY;
        for k in 1..=m {
            let lambda = 1.0 - angle(m, k).cos();
            for z in roots(lambda) {
                let rest = z.times(z).minus(z.scaled(lambda * g)).minus(Z(lambda * f, 0.0));
                assert!(rest.size() <= 1e-9 * (1.0 + z.size().powi(2)));
                slowest = slowest.max(z.0);
            }
        }
        let stable = f < 0.0 && g < 0.0;
        let one_sided = roots(1.0).iter().all(|z| z.0 < -1e-12);
        assert_eq!((slowest < -1e-12, one_sided), (stable, stable), "{f} {g} {m}");
        if stable && m as f64 >= g.abs() / (-f).sqrt() {
            let rate = g.abs() * (1.0 - angle(m, 1).cos()) / 2.0;
            assert!(close(slowest / rate, -1.0) && rate < PI * PI * g.abs() / (16.0 * (m * m) as f64));
        }
    }
}

/// veerman.cor1, cor1_special, beyond.veerman.cor1.proof, gain_iff, gain_max, sep_remark, prop1.
#[test]
fn one_sided() {
    let mut dice = Dice::new("one-sided");
    for _ in 0..400 {
        let ((f, g), k) = (gains(&mut dice), 1 + dice.below(8));
        let w = [0.0, 10f64.powf(dice.between(-3.0, 3.0)), (-f).sqrt(), (-2.0 * f).sqrt()][dice.below(4)];
        let ratio = Z(1.0, 0.0).over(gamma(f, g, w));
        let (front, own) = (ratio.power(k - 1), ratio.power(k));
        // -w² a_k = (f + iwg)(a_k - a_(k-1)).
        let force = Z(f, w * g).times(own.minus(front));
        assert!(own.scaled(-w * w).minus(force).size() <= 1e-7 * (1.0 + own.size()) * (w * w - f + w * g.abs()));
        let special = Z(1.0, 0.0).over(gamma(f, g, (-f).sqrt())).power(k);
        assert!(special.is(Z(1.0, (-f).sqrt() / g).power(k)));
        let gain = ratio.size();
        if (w * w + 2.0 * f).abs() > 1e-9 * -f && w * w > 1e-5 * -f && w * w < 1e6 * (1.0 - f) {
            assert_eq!(gain > 1.0, w * w < -2.0 * f, "{f} {g} {w} {gain}");
        }
        let v = f * f / (g * g) * ((1.0 - 2.0 * g * g / f).sqrt() - 1.0);
        let best = Z(1.0, 0.0).over(gamma(f, g, v.sqrt())).size();
        assert!(gain <= best * (1.0 + 1e-9) && v < -f * (1.0 + 1e-6));
        let (a, t) = (dice.between(0.1, 9.0), dice.between(0.0, 9.0));
        let phase = Z((w * t).cos(), (w * t).sin());
        let place = |k: usize| k as f64 + a * ratio.power(k).times(phase).0;
        let apart = a * ratio.power(k + 1).times(phase).0 - a * ratio.power(k).times(phase).0 + 1.0;
        assert!((place(k + 1) - place(k) - apart).abs() < 1e-9 * (1.0 + a * gain.powi(9)));
        // Proposition 1: D just above and below what the car N + 1 = k needs.
        let needed = special.size();
        for d in [0.999 * needed, 1.001 * needed] {
            let growth = (1.0 - f / (g * g)).ln();
            assert!(growth < 1e-6 || (needed <= d) == (k as f64 <= 2.0 * d.ln() / growth));
        }
    }
}

/// veerman.lem2, lem2_eigvec, cor2, lem3 for all sizes from one car on, w = 0 and negative frequencies.
#[test]
fn chains() {
    let mut dice = Dice::new("chains");
    for _ in 0..400 {
        let ((f, g), m) = (gains(&mut dice), 1 + dice.below(12));
        let w = [0.0, 1.0, -1.0][dice.below(3)] * (-f).sqrt() * dice.between(0.01, 1.5);
        let (gamma, a) = (gamma(f, g, w), two_sided(f, g, w, m));
        for k in 1..=m {
            // The equation of motion itself.
            let average = if k < m { a[k - 1].plus(a[k + 1]).scaled(0.5) } else { a[k - 1] };
            let rest = Z(f, w * g).times(a[k].minus(average)).plus(a[k].scaled(w * w));
            assert!(rest.size() <= 1e-8 * (1.0 + a[k].size()) * (w * w - f + (w * g).abs()));
            if k < m {
                assert!(gamma.times(a[k]).scaled(2.0).minus(a[k - 1]).is(a[k + 1]));
            }
        }
        let s = gamma.times(gamma).minus(Z(1.0, 0.0)).root();
        let (plus, minus) = (gamma.plus(s), gamma.minus(s));
        assert!(Z(1.0, 0.0).minus(gamma.times(plus)).is(s.times(plus).scaled(-1.0)));
        assert!(Z(1.0, 0.0).minus(gamma.times(minus)).is(s.times(minus)));
        let trace = plus.power(m).plus(minus.power(m));
        assert!(Z(2.0, 0.0).over(trace).minus(a[m]).size() <= 1e-7 * a[m].size(), "{f} {g} {w} {m}");
        let c = minus.power(m).over(trace);
        for (k, a) in a.iter().enumerate() {
            let sum = c.times(plus.power(k)).plus(Z(1.0, 0.0).minus(c).times(minus.power(k)));
            assert!(sum.minus(*a).size() <= 1e-6 * (1.0 + a.size()));
        }
        if w != 0.0 {
            assert!((plus.size() - minus.size()).abs() > 0.0);
            let imaginary = (g * w * w * w / (f * f + w * w * g * g)).abs();
            assert!(a[m].size() * m as f64 * imaginary <= 1.0 + 1e-9);
        }
    }
}

/// veerman.thm1_omega, thm1_amp, beyond.veerman.thm1_x, resonance_frequency, resonance_amplitude, veerman.prop2: the bounds at the
/// smallest size, for damping from weak to strong.
#[test]
fn resonances() {
    let mut dice = Dice::new("resonances");
    for k in 0..60 {
        let f = -10f64.powf(dice.between(-1.0, 1.0));
        let b = if k < 20 { [0.01, 0.3, 0.9, 1.0, 1.1][k % 5] } else { 10f64.powf(dice.between(-2.0, 1.2)) };
        let g = -b * (-f).sqrt();
        let m = (5.0 * b.max(1.0)).ceil() as usize + dice.below(3) * dice.below(20);
        let (w, peak) = main_resonance(f, g, m);
        let a0 = PI / (2.0 * SQRT_2 * m as f64);
        let unit = (a0 * b.max(1.0)).powi(4);
        let (w0, peak0) = ((-f).sqrt() * a0, 8.0 * SQRT_2 * m as f64 / (PI * PI * b));
        let e = w / w0 - (1.0 - a0 * a0 * (1.0 / 12.0 + b * b / 8.0));
        assert!(e.abs() <= 1.7 * unit + 1e-7, "b = {b}, M = {m}: {}", e / unit);
        let e = peak / peak0 - (1.0 - a0 * a0 * (1.0 / 12.0 - 3.0 * b * b / 8.0 + PI * PI * b * b / 96.0));
        assert!(e.abs() <= 11.0 * unit + 1e-9, "b = {b}, M = {m}: {}", e / unit);
        // Proposition 2 at the tie: N = M - 1 stays below X D/a_0.
        assert!(((m - 1) as f64) < PI * PI * b / (8.0 * SQRT_2) * peak);
        let x = PI * PI * b / (8.0 * SQRT_2);
        let mu = gamma(f, g, w).plus(gamma(f, g, w).times(gamma(f, g, w)).minus(Z(1.0, 0.0)).root());
        let scaled = (mu.size().powi(m as i32) - (x / m as f64).exp()) * (m as f64).powi(3);
        assert!(scaled.abs() <= 60.0 * (1.0 + b.powi(4)), "b = {b}, M = {m}: {scaled}");
    }
    // The errors of Theorem 1 times M^3 and M stay bounded.
    for (f, g) in [(-1.0, -1.0), (-0.2, -1.5), (-5.0, -0.1)] {
        let b = -g / f64::sqrt(-f);
        for m in [40, 160, 640] {
            let (w, peak) = main_resonance(f, g, m);
            let w0 = f64::sqrt(-f) * PI / (2.0 * SQRT_2 * m as f64);
            assert!(
                ((w - w0) * (m as f64).powi(3)).abs() < 2.0 * f64::sqrt(-f) * (1.0 + b * b),
                "{f} {g} {m}: {w} {w0} {peak}"
            );
            assert!(((peak - 8.0 * SQRT_2 * m as f64 / (PI * PI * b)) * m as f64).abs() < 2.0 * (b + 1.0 / b));
        }
    }
}

/// beyond.veerman.thm1_eps, veerman.thm1_mod: small frequencies.
#[test]
fn expansions() {
    let mut dice = Dice::new("expansions");
    for _ in 0..100 {
        let (f, g) = (-10f64.powf(dice.between(-1.0, 1.0)), -10f64.powf(dice.between(-1.0, 1.0)));
        let error = |w: f64| {
            let gamma = gamma(f, g, w);
            let root = gamma.times(gamma).minus(Z(1.0, 0.0)).root();
            let bracket = Z(1.0 + w * w / 2.0 * (-0.75 * g * g / (f * f) + 0.5 / f), w * g / (-2.0 * f));
            let printed = bracket.times(Z(0.0, SQRT_2 * w / (-f).sqrt()));
            let term = SQRT_2 * w * w * -g / (-f).powf(1.5);
            let moduli = [gamma.plus(root).size().powi(2) - 1.0 - term, gamma.minus(root).size().powi(2) - 1.0 + term];
            [root.minus(printed).size(), moduli[0].abs(), moduli[1].abs()]
        };
        // Halving w divides an error of order 4 by 16.
        let w = 0.02 * f64::min((-f).sqrt(), f / g);
        for (large, small) in error(w).into_iter().zip(error(w / 2.0)) {
            assert!(small < 1e-13 || large / small > 12.0, "{f} {g}: {large} {small}");
        }
    }
}

/// veerman.fig1, cor3, sec7.omega0, fig4, fig5 and the corrected claims about Table 1.
#[test]
fn figures_and_table() {
    for (m, printed) in [(99, 0.011), (1000, 0.0011)] {
        let w = highest(1e-4, 0.1, 20_000, |w| response(-1.0, -1.0, w, m));
        assert!((w / printed - 1.0).abs() < 0.05, "{m}: {w}");
    }
    let (m, w1) = (4000, main_resonance(-1.0, -1.0, 4000));
    for k in 2..=4 {
        let odd = f64::from(2 * k - 1);
        let w = highest((odd - 0.5) * w1.0, (odd + 0.5) * w1.0, 200, |w| response(-1.0, -1.0, w, m));
        assert!((w / w1.0 / odd - 1.0).abs() < 0.01 && response(-1.0, -1.0, w, m) < w1.1 / 2.0);
    }
    // N, NFREQ, NAMP, TFREQ, TAMP.
    let table = [
        (4, 0.2776801836, 4.58527335, 0.2727291, 4.49064609),
        (8, 0.1388400918, 9.17054669, 0.1382221, 9.11739657),
        (16, 0.0694200459, 18.34109338, 0.06934994, 18.3135253),
        (32, 0.0347100229, 36.68218677, 0.03470038, 36.6683866),
        (64, 0.0173550115, 73.36437354, 0.017353935, 73.3562112),
        (128, 0.0086775057, 146.72874707, 0.008677381, 146.7227220),
    ];
    let (mut sums, rows) = ([0.0; 4], table.len() as f64);
    for (n, nfreq, namp, tfreq, tamp) in table {
        let m = n as f64;
        let (w0, a0) = (PI * SQRT_2 / (4.0 * m), 8.0 * SQRT_2 * m / (PI * PI));
        assert!((nfreq - w0).abs() < 1e-10 && (namp - a0).abs() < 1e-8);
        let (w, peak) = main_resonance(-1.0, -1.0, n);
        for (cell, truth, last) in [(nfreq, w, 1e-10), (namp, peak, 1e-8), (tamp, peak, 1e-7)] {
            assert!(f64::abs(cell - truth) > 3.0 * last, "{n}");
        }
        assert!(f64::abs(tfreq - w) < f64::abs(tfreq - w0) && f64::abs(tfreq / w - 1.0) < 0.0014);
        assert!(tamp < peak && tamp > peak * (1.0 - 0.0353));
        if n == 128 {
            assert!(f64::abs(tfreq / w - 1.0) < 1e-5 && tamp > peak * (1.0 - 6e-5));
        }
        // Excellent agreement, and the regression line.
        let limit = if n < 32 { 0.025 } else { 0.0005 };
        assert!((w / w0 - 1.0).abs() < limit && (peak / a0 - 1.0).abs() < limit);
        let (x, y) = (m.ln(), (w0 - w).ln());
        sums = [sums[0] + x, sums[1] + y, sums[2] + x * x, sums[3] + x * y];
        for (freq, amp) in [(nfreq, namp), (tfreq, tamp)] {
            assert!(f64::abs(freq / w - 1.0) < 0.02 && f64::abs(amp / peak - 1.0) < 0.04);
        }
    }
    let slope = (rows * sums[3] - sums[0] * sums[1]) / (rows * sums[2] - sums[0] * sums[0]);
    assert!((slope + 3.0).abs() < 0.1, "{slope}");
}

/// beyond.veerman.table1_reading: the first follower takes the velocity of the leader as 0.
#[test]
fn reading_of_the_table() {
    let altered = |w: f64, m: usize| {
        // -w² a_1 = (f + iwg)(a_1 - (a_0 + a_2)/2) with i w g a_0 left out; the other cars as in (2).
        let gamma = gamma(-1.0, -1.0, w);
        let mut back = vec![Z(1.0, 0.0), gamma];
        for k in 1..m {
            back.push(gamma.times(back[k]).scaled(2.0).minus(back[k - 1]));
        }
        // a_0 enters as f/(f + iwg) a_0.
        Z(-1.0, 0.0).over(Z(-1.0, -w)).over(back[m]).size()
    };
    let rows = [
        (4, 0.2727291, 4.49064609),
        (8, 0.1382221, 9.11739657),
        (16, 0.06934994, 18.3135253),
        (32, 0.03470038, 36.6683866),
        (64, 0.017353935, 73.3562112),
        (128, 0.008677381, 146.7227220),
    ];
    for (m, w, size) in rows {
        assert!((altered(w, m) / size - 1.0).abs() <= 1.8e-5, "{m}");
        let place = highest(0.8 * w, 1.2 * w, 400, |w| altered(w, m));
        let near = (place / w - 1.0).abs();
        assert!(near <= if m == 4 { 2.6e-5 } else { 3.2e-4 }, "{m}: {near}");
    }
}

/// beyond.veerman.nth_neighbour, growth.
#[test]
fn other_graphs() {
    for (n, followers) in (2..9usize).flat_map(|n| (1..20usize).map(move |m| (n, m))) {
        let mut reached = vec![false; followers + 1];
        let mut stack = vec![0];
        while let Some(k) = stack.pop() {
            if !std::mem::replace(&mut reached[k], true) {
                stack.extend([k.wrapping_sub(n), k + n].into_iter().filter(|j| *j <= followers));
            }
        }
        assert!(!reached[1]);
    }
    // Platoons in series: the peak of the last car grows like M^p; system (1): more than any power.
    for p in 1..=3i32 {
        let peak = |m: usize| main_resonance(-1.0, -1.0, m).1.powi(p);
        let growth = peak(512) / peak(64) / 8f64.powi(p);
        assert!((growth - 1.0).abs() < 0.02, "{p}: {growth}");
    }
    let gain = Z(1.0, 0.0).over(gamma(-3.0, -0.2, 1.0)).size();
    assert!(gain > 1.0);
}

/// Where hypotheses just hold: beyond.veerman.decay_rate at M = b, prop1 with less room than the leader takes, gain_iff beside its ends,
/// growth for degrees that are no integers.
#[test]
fn ends_of_the_hypotheses() {
    for m in [1usize, 2, 3, 7, 12] {
        for f in [-0.04f64, -1.0, -25.0] {
            // |g| = M sqrt|f|; x² + |g| lambda x + |f| lambda = 0 for every mode.
            let g = m as f64 * (-f).sqrt();
            let rate = |k: usize| {
                let lambda = 1.0 - (PI * (2 * k - 1) as f64 / (2 * m) as f64).cos();
                let square = (g * lambda).powi(2) + 4.0 * f * lambda;
                (g * lambda - square.max(0.0).sqrt()) / 2.0
            };
            let slowest = (1..=m).map(rate).fold(f64::INFINITY, f64::min);
            assert!(close(slowest, g * (1.0 - (PI / (2 * m) as f64).cos()) / 2.0), "M = {m}, f = {f}");
        }
    }
    let mut dice = Dice::new("ends");
    for _ in 0..400 {
        let ((f, g), [a0, d]) = (gains(&mut dice), [0, 1].map(|_| 10f64.powf(dice.between(-2.0, 2.0))));
        let size = dice.below(40) + 1;
        let amplitude = a0 * Z(1.0, 0.0).over(gamma(f, g, (-f).sqrt())).size().powi(size as i32);
        let most = 2.0 * (d / a0).ln() / (1.0 - f / (g * g)).ln();
        assert!((amplitude <= d) == (size as f64 <= most) || close(amplitude, d), "{f} {g} {a0} {d} {size}");
        for (factor, above) in [(1e-3, true), (1.0 - 1e-6, true), (1.0 + 1e-6, false)] {
            let gain = Z(1.0, 0.0).over(gamma(f, g, (-2.0 * f).sqrt() * factor)).size();
            assert!((gain > 1.0) == above || (gain - 1.0).abs() < 1e-12, "{f} {g} {factor}");
        }
    }
    // k platoons of M^(p/k) cars: p = 1/2, 3/2, 5/4.
    for (k, p) in [(1, 0.5), (2, 1.5), (2, 1.25)] {
        let peak = |all: f64| main_resonance(-1.0, -1.0, all.powf(p / f64::from(k)) as usize).1.powi(k);
        let growth = peak(2f64.powi(18)) / peak(2f64.powi(12));
        assert!((growth / 64f64.powf(p) - 1.0).abs() < 0.05, "p = {p}: {growth}");
    }
}

/// veerman.sec6_fig2, fig3: the platoon in time, by Runge and Kutta.
#[test]
fn in_time() {
    /// Deviations and velocities after a step of `h`, behind a leader at `lead(t)`, position and velocity.
    fn step(y: &mut [[f64; 2]], t: f64, h: f64, lead: &dyn Fn(f64) -> [f64; 2]) {
        let m = y.len();
        let rates = |y: &[[f64; 2]], t: f64| -> Vec<[f64; 2]> {
            let at = |k: usize| if k == 0 { lead(t) } else { y[k - 1] };
            let average = |k: usize, c: usize| if k < m { (at(k - 1)[c] + at(k + 1)[c]) / 2.0 } else { at(k - 1)[c] };
            (1..=m).map(|k| [at(k)[1], -(at(k)[0] - average(k, 0)) - (at(k)[1] - average(k, 1))]).collect()
        };
        let moved = |y: &[[f64; 2]], d: &[[f64; 2]], h: f64| -> Vec<[f64; 2]> {
            y.iter().zip(d).map(|(y, d)| [y[0] + h * d[0], y[1] + h * d[1]]).collect()
        };
        let a = rates(y, t);
        let b = rates(&moved(y, &a, h / 2.0), t + h / 2.0);
        let c = rates(&moved(y, &b, h / 2.0), t + h / 2.0);
        let d = rates(&moved(y, &c, h), t + h);
        for (k, y) in y.iter_mut().enumerate() {
            (0..2).for_each(|i| y[i] += h / 6.0 * (a[k][i] + 2.0 * b[k][i] + 2.0 * c[k][i] + d[k][i]));
        }
    }
    let m = 32;
    let (w, size) = main_resonance(-1.0, -1.0, m);
    let amplitude = two_sided(-1.0, -1.0, w, m)[m];
    let lead = move |t: f64| [(w * t).cos(), -w * (w * t).sin()];
    let period = 2.0 * PI / w;
    let (h, mut t, mut y) = (period / 900.0, 0.0, vec![[0.0; 2]; m]);
    for k in 0..60 * 900 {
        step(&mut y, t, h, &lead);
        t += h;
        let lacking = y[m - 1][0] - amplitude.0 * (w * t).cos() + amplitude.1 * (w * t).sin();
        if k < 900 {
            assert!(y[m - 1][0].abs() < size / 4.0);
        }
        if k > 55 * 900 {
            assert!(lacking.abs() < size / 100.0);
        }
    }
    // The leader accelerates during 10 units and then keeps its velocity: passages of the last car by its place.
    let m = 20;
    let w = main_resonance(-1.0, -1.0, m).0;
    let lead = |t: f64| if t < 10.0 { [t * t / 2.0, t] } else { [50.0 + 10.0 * (t - 10.0), 10.0] };
    let (h, mut t, mut y, mut passages, mut before) = (0.02, 0.0, vec![[0.0; 2]; m], Vec::new(), 0.0);
    while passages.len() < 6 && t < 1000.0 {
        step(&mut y, t, h, &lead);
        t += h;
        let deviation = y[m - 1][0] - lead(t)[0];
        if t > 10.0 + h && deviation * before < 0.0 {
            passages.push(t);
        }
        before = deviation;
    }
    assert!(passages.windows(2).all(|p| ((p[1] - p[0]) * w / PI - 1.0).abs() < 0.01), "{passages:?}");
}

/// beyond.veerman.worst_cases: motions behind a leader whose acceleration is 1 for ever, or a cosine, by Runge and Kutta, should stay below the
/// bounds that worst cases are said to exceed.
#[test]
fn worst_cases() {
    /// The largest `|y_k - y_0|` and `|y_k - y_(k-1)|` after the time `from`, for each follower.
    fn largest(
        [f, g]: [f64; 2],
        m: usize,
        is_two_sided: bool,
        [from, until]: [f64; 2],
        a: &dyn Fn(f64) -> f64,
    ) -> Vec<[f64; 2]> {
        let rates = |x: &[[f64; 2]], t: f64| -> Vec<[f64; 2]> {
            let at = |k: usize, c: usize| if k == 0 { 0.0 } else { x[k - 1][c] };
            let heard = |k: usize, c: usize| match is_two_sided && k < m {
                true => (at(k - 1, c) + at(k + 1, c)) / 2.0,
                false => at(k - 1, c),
            };
            let force = |k: usize| f * (at(k, 0) - heard(k, 0)) + g * (at(k, 1) - heard(k, 1)) - a(t);
            (1..=m).map(|k| [at(k, 1), force(k)]).collect()
        };
        let moved = |x: &[[f64; 2]], d: &[[f64; 2]], h: f64| -> Vec<[f64; 2]> {
            x.iter().zip(d).map(|(x, d)| [x[0] + h * d[0], x[1] + h * d[1]]).collect()
        };
        let (h, mut x, mut most) = (0.02, vec![[0.0; 2]; m], vec![[0.0f64; 2]; m]);
        for step in 0..(until / h) as usize {
            let t = step as f64 * h;
            let one = rates(&x, t);
            let two = rates(&moved(&x, &one, h / 2.0), t + h / 2.0);
            let three = rates(&moved(&x, &two, h / 2.0), t + h / 2.0);
            let four = rates(&moved(&x, &three, h), t + h);
            for (k, x) in x.iter_mut().enumerate() {
                (0..2).for_each(|i| x[i] += h / 6.0 * (one[k][i] + 2.0 * two[k][i] + 2.0 * three[k][i] + four[k][i]));
            }
            for k in (0..m).filter(|_| t >= from) {
                let before = if k == 0 { 0.0 } else { x[k - 1][0] };
                let found = [x[k][0].abs(), (x[k][0] - before).abs()];
                (0..2).for_each(|i| most[k][i] = most[k][i].max(found[i]));
            }
        }
        most
    }
    for gains in [[-1.0, -1.0], [-0.5, -2.0], [-3.0, -0.7], [-0.25, -1.5]] {
        let [f, g] = gains;
        for m in 1..=4usize {
            let (both, one) =
                (largest(gains, m, true, [0.0, 400.0], &|_| 1.0), largest(gains, m, false, [0.0, 400.0], &|_| 1.0));
            for k in 1..=m {
                let reached = |value: f64, bound: f64| assert!(value >= bound * (1.0 - 1e-6), "{value} for {bound}");
                reached(both[k - 1][0], (k * (2 * m - k)) as f64 / -f);
                reached(both[k - 1][1], (2 * (m - k) + 1) as f64 / -f);
                reached(one[k - 1][0], k as f64 / -f);
            }
        }
        for w in [0.2, 0.45, 0.9, 1.6] {
            let swung = largest(gains, 4, false, [150.0, 250.0], &|t| (w * t).cos());
            for k in 1..=4 {
                let bound = gamma(f, g, w).size().powi(1 - k) / Z(f + w * w, w * g).size();
                assert!(swung[k as usize - 1][1] >= bound * (1.0 - 1e-3), "f = {f}, g = {g}, w = {w}, k = {k}");
            }
        }
    }
}
