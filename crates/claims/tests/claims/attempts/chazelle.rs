//! Chazelle's statements about flocks that move, stepped exactly on the line, and about numbers.

use super::Dice;
use arithmetic::Rational;

pub type Q = Rational;

pub fn q(p: i64, r: i64) -> Q {
    Q::new(p.into(), r.into())
}

pub fn size(x: &Q) -> Q {
    if *x < q(0, 1) { -x.clone() } else { x.clone() }
}

/// A flock on the line: `x(t)`, the velocities of the next step, the edges of `G_t`.
pub struct Birds {
    pub x: Vec<Q>,
    pub v: Vec<Q>,
    pub edges: Vec<Vec<bool>>,
    /// The hysteresis threshold.
    eps: Option<Q>,
    /// `c_i` by the degree.
    c: fn(usize) -> Q,
}

pub const LAZY: fn(usize) -> Q = |d| q(2, 3 * d.max(1) as i64);
pub const VICSEK: fn(usize) -> Q = |d| q(1, d as i64 + 1);

impl Birds {
    pub fn new(x: Vec<Q>, v: Vec<Q>, eps: Option<Q>, c: fn(usize) -> Q) -> Self {
        let n = x.len();
        let near = |i: usize, j: usize| i != j && size(&(&x[i] - &x[j])) <= q(1, 1);
        let edges = (0..n).map(|i| (0..n).map(|j| near(i, j)).collect()).collect();
        Birds { x, v, edges, eps, c }
    }

    /// Moves by one step; whether the network changed.
    pub fn step(&mut self) -> bool {
        let n = self.x.len();
        let next: Vec<Q> = self.x.iter().zip(&self.v).map(|(x, v)| x + v).collect();
        let mut edges = vec![vec![false; n]; n];
        for i in 0..n {
            for j in (0..n).filter(|j| *j != i) {
                let (before, now) = (size(&(&self.x[i] - &self.x[j])), size(&(&next[i] - &next[j])));
                let kept = self.eps.as_ref().is_some_and(|eps| self.edges[i][j] && size(&(&now - &before)) < *eps);
                edges[i][j] = now <= q(1, 1) || kept;
            }
        }
        let heard = |i: usize| -> Vec<usize> { (0..n).filter(|&j| edges[i][j]).collect() };
        let turned = |i: usize| {
            let pull: Q = heard(i).iter().map(|&j| &self.v[j] - &self.v[i]).sum();
            &self.v[i] + (self.c)(heard(i).len()) * pull
        };
        self.v = (0..n).map(turned).collect();
        self.x = next;
        std::mem::replace(&mut self.edges, edges) != self.edges
    }
}

pub fn paper_threshold(n: i64) -> Q {
    q(1, n).pow(n.pow(4) as i32)
}

fn four_birds(eps: Option<Q>) -> Birds {
    let over = |list: [i64; 4], unit: i64| list.map(|x| q(x, unit)).to_vec();
    Birds::new(over([0, 8, 21, 29], 16), over([1, -1, 1, -1], 8), eps, LAZY)
}

/// chazelle.ex4birds.eig, .eq3.14, .alt: the four birds without hysteresis, exactly.
#[test]
fn four_birds_alternate() {
    let mut flock = four_birds(None);
    let (start, v, mut r) = (flock.x.clone(), flock.v.clone(), q(1, 1));
    for t in 0..60 {
        assert_eq!(flock.edges[1][2], t % 2 == 0);
        assert!(
            flock.edges[0][1] && flock.edges[2][3] && !flock.edges[0][2] && !flock.edges[0][3] && !flock.edges[1][3]
        );
        for i in 0..4 {
            assert_eq!(flock.x[i], &start[i] + q(3, 4) * (q(1, 1) - &r) * &v[i]);
        }
        if t >= 1 {
            let (gap, r) = (|i: usize| &flock.x[i + 1] - &flock.x[i], &r * q(-3, 1));
            assert!(
                [0, 2].iter().all(|&i| gap(i) == (q(5, 1) - &r) / q(16, 1) && gap(i) >= q(1, 4) && gap(i) <= q(1, 2))
            );
            assert_eq!(gap(1), q(1, 1) + r / q(16, 1));
        }
        flock.step();
        r *= q(-1, 3);
    }
}

/// chazelle.lem3.6.i, lem3.6.ii, lem3.8, hyst.remark: the four birds with the hysteresis of the paper, and with 2^-100 of it.
#[test]
fn four_birds_settle() {
    for (eps, last) in [(paper_threshold(4), 322), (paper_threshold(4) / q(2, 1).pow(100), 386)] {
        let mut flock = four_birds(Some(eps.clone()));
        let limit = q(1, 1) + q(1, 4).pow(64);
        let mut switched = 0;
        for t in 1..=440 {
            if flock.step() {
                switched = t;
            }
            for (i, j) in (0..4).flat_map(|i| (0..i).map(move |j| (i, j))) {
                let gap = size(&(&flock.x[i] - &flock.x[j]));
                assert!(gap > q(1, 1) || flock.edges[i][j]);
                assert!(gap <= limit || !flock.edges[i][j]);
            }
        }
        // The change of the gap, 3^-t/4, falls below the threshold at the last switch.
        assert_eq!(switched, last, "{eps}");
    }
}

/// beyond.chazelle.lower_bound, chazelle.lower_paths: n^c = 8 and just above, where the groups contract most.
#[test]
fn lower_bound_flocks() {
    for (n, power) in [(8, 8), (12, 12), (4, 16), (8, 64)] {
        let x = (0..n / 2).flat_map(|l| [q(2 * l, 1), q(6 * l + 2, 3)]).collect();
        let v = (0..n).map(|i| q([1, 0, -1, 0][i as usize % 4], power)).collect();
        for eps in [None, Some(paper_threshold(n.min(4)))] {
            let mut flock = Birds::new(Vec::clone(&x), Vec::clone(&v), eps, LAZY);
            for t in 1..=power / 3 + 60 {
                let changed = flock.step();
                assert_eq!(changed, t == (power + 2) / 3, "n = {n}, n^c = {power}, t = {t}");
                for (i, row) in flock.edges.iter().enumerate() {
                    assert!((0..n as usize).all(|j| !row[j] || i.abs_diff(j) == 1 && i / 4 == j / 4));
                }
            }
        }
    }
}

/// The same where n^c is no integer, or divisible by 3, so that the gap at the contact is exactly 1.
#[test]
fn contacts_between_integers() {
    for power in [(17, 2), (25, 3), (9, 1), (31, 3), (12, 1), (24, 1)] {
        let x = [q(0, 1), q(2, 3), q(2, 1), q(8, 3)].to_vec();
        let v = [1, 0, -1, 0].map(|sign| q(sign * power.1, power.0)).to_vec();
        for eps in [None, Some(paper_threshold(4))] {
            let mut flock = Birds::new(x.clone(), v.clone(), eps, LAZY);
            let changes: Vec<i64> = (1..=60).filter(|_| flock.step()).collect();
            let contact = (power.0 + 3 * power.1 - 1) / (3 * power.1);
            assert_eq!(changes, [contact], "n^c = {power:?}");
        }
    }
}

/// beyond.chazelle.tower, first clause: sixteen birds until well after their first contact.
#[test]
fn sixteen_birds() {
    let v = [0, 8, 0, -8, 7, 1, -9, 1, -1, 9, -1, -7, 8, 0, -8, 0].map(|v| q(v, 4096)).to_vec();
    let x = (0..8).flat_map(|l| [q(2 * l, 1), q(6 * l + 2, 3)]).collect();
    let mut flock = Birds::new(x, v, None, LAZY);
    let changes: Vec<u32> = (1..=230).filter(|_| flock.step()).collect();
    assert_eq!(changes, [171]);
}

/// chazelle.lem3.1, thm1.1.switches, beyond.chazelle.switches, chazelle.eq3.4: the flocks of two and three birds on a grid that switch
/// most often.
#[test]
fn most_switches() {
    let mut most = [0; 4];
    for c in [LAZY, VICSEK] {
        for code in 0..5 * 7 {
            let (x, v) = (vec![q(0, 1), q(4 + code % 5, 5)], vec![q(0, 1), q(code / 5 - 3, 3)]);
            let mut flock = Birds::new(x, v, Some(paper_threshold(2)), c);
            most[2] = most[2].max((1..=40).filter(|t| flock.step() && *t >= 2).count());
        }
        let mut dice = Dice::new("switches");
        for _ in 0..150 {
            let x = (0..3).map(|k| q(5 * k + dice.below(5) as i64, 6)).collect();
            let v = (0..3).map(|_| q(dice.below(13) as i64 - 6, 8)).collect();
            let mut flock = Birds::new(x, v, Some(paper_threshold(3)), c);
            most[3] = most[3].max((1..=16).filter(|t| flock.step() && *t >= 2).count());
        }
    }
    // n^(a(n-1)² + (c+9)(n-1) + 1) with a = c = 1, and 2n N(n-1) + n.
    assert!(most[2] <= 1 << 12 && most[3] <= 3usize.pow(25), "{most:?}");
    assert!(most[2] <= 2 && most[3] <= 2 * 3 * 2 + 3, "{most:?}");
}

/// chazelle.lem2.1, beyond.chazelle.angle: random flocks without and with hysteresis, and birds far away.
#[test]
fn virtual_origins() {
    let mut dice = Dice::new("origins");
    for k in 0..60 {
        let n = 1 + dice.below(4);
        let start: Vec<Q> = (0..n)
            .map(|i| q(7 * i as i64 + dice.below(9) as i64, 8) + q(if k % 5 == 0 { 1000 } else { 0 }, 1))
            .collect();
        let v = (0..n).map(|_| q(dice.below(9) as i64 - 4, 8)).collect();
        let (c, a) = if k % 2 == 0 { (LAZY, 2) } else { (VICSEK, 1) };
        let eps = (k % 3 == 0).then(|| q(1, 40));
        let mut flock = Birds::new(start.clone(), v, eps, c);
        let far = start.iter().map(size).max().unwrap();
        let mut switches = 0;
        for t in 1..=24 {
            let (before, v) = (flock.x.clone(), flock.v.clone());
            let changed = flock.step();
            let bound = &far + q(4 * (switches + 1), 1) * q((n as i64).pow(2 * a + 3), 1);
            for i in 0..n {
                let e = &flock.x[i] - q(t, 1) * &v[i];
                assert!(size(&e) <= bound);
                let (x, e) = (&flock.x[i] / q(t, 1), e / q(t, 1));
                let float = |x: &Q| num_traits::ToPrimitive::to_f64(x).unwrap();
                let angle = (float(&v[i]).atan() - float(&x).atan()).abs();
                assert!(angle <= float(&size(&e)) + 1e-9);
                for j in 0..i {
                    let change = size(&(&flock.x[i] - &flock.x[j])) - size(&(&before[i] - &before[j]));
                    assert!(size(&change) <= size(&(&v[i] - &v[j])));
                }
            }
            switches += i64::from(changed);
        }
    }
}

/// chazelle.eq3.15: opposite, near and far vectors in one to three dimensions.
#[test]
fn angles_and_distances() {
    let mut dice = Dice::new("angles");
    for _ in 0..4000 {
        let d = 1 + dice.below(3);
        let scale = 10f64.powf(dice.between(-3.0, 4.0));
        let v: Vec<f64> = (0..d).map(|_| scale * dice.between(-1.0, 1.0)).collect();
        let w: Vec<f64> = match dice.below(3) {
            0 => v.iter().map(|x| -x).collect(),
            1 => v.iter().map(|x| x * 1.01).collect(),
            _ => (0..d).map(|_| scale * dice.between(-1.0, 1.0)).collect(),
        };
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let difference: Vec<f64> = v.iter().zip(&w).map(|(a, b)| a - b).collect();
        let distance = dot(&difference, &difference).sqrt();
        // The sine from |v - w|² + |v|²|w|² - (v.w)² = |v - w|² + (area of v, w)².
        let area = (dot(&v, &v) * dot(&w, &w) - dot(&v, &w).powi(2)).max(0.0);
        let angle = (distance * distance + area).sqrt().atan2(1.0 + dot(&v, &w));
        let reach = dot(&v, &v).max(dot(&w, &w));
        let quotient = angle / distance;
        assert!(quotient <= 1.0 + 1e-6 && quotient >= (1.0 - 1e-6) / (1.0 + reach), "{v:?} {w:?} {quotient}");
    }
}

/// chazelle.lem2.2.bits, lem2.3, lem3.5: coprime denominators of about n² make the lengths grow as fast as they can.
#[test]
fn lengths() {
    let primes = [11i64, 13, 17, 19, 23, 29];
    let n = 4;
    let bits = |list: &[Q]| list.iter().map(|x| x.denom().bits().max(x.numer().bits())).max().unwrap();
    let mut x: Vec<Q> = (0..n).map(|i| q(1, primes[i])).collect();
    let mut v: Vec<Q> = (0..n).map(|i| q(primes[i + 1], primes[i] + 2)).collect();
    let mut reached = Vec::new();
    for t in 1..=48 {
        // A path whose weights change with time: c_i = 1/p.
        x = x.iter().zip(&v).map(|(x, v)| x + v).collect();
        let c = |i: usize| q(1, primes[(i + t) % 6]);
        let pull = |i: usize| -> Q { (0..n).filter(|&j| i.abs_diff(j) == 1).map(|j| &v[j] - &v[i]).sum() };
        v = (0..n).map(|i| &v[i] + c(i) * pull(i)).collect();
        reached.push(bits(&x).max(bits(&v)));
        // a = 5 log2(29)/log2(4): one denominator up to 29 for each bird and step, and the input's.
        assert!(reached[t - 1] as f64 <= 5.0 * (n * (t + 6)) as f64);
    }
    assert!(reached[47] < 2 * reached[23] + 64, "linear in t: {reached:?}");
}

/// chazelle.epsineq and the inequality behind hyst.remark, in logarithms of logarithms.
#[test]
fn thresholds() {
    for nu in 1..=60u32 {
        let nu = f64::from(nu);
        // nu^(nu²) > nu^4 ln nu.
        assert!(nu * nu * nu.ln() > 4.0 * nu.ln() + nu.ln().max(1e-300).ln());
        if nu >= 4.0 {
            let needed = (nu.powi(4) * nu.ln() + 100.0 * 2f64.ln()).ln();
            assert!(nu * nu * nu.ln() > needed);
        }
    }
}
