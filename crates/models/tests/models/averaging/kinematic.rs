//! Model K against a naive twin in floats; ties, near ties and what cannot be decided.

use algebra::graph::Graph;
use arithmetic::{Complex, Interval, Number, Rational, Real, Ring, rational};
use models::averaging::read::{Model, read_flock};
use models::averaging::{FlockError, Hysteresis, KinematicFlock, KinematicStart, Weights, transition_matrix};
use num_bigint::BigInt;
use num_traits::ToPrimitive;
use proptest::prelude::*;

fn point(x: Rational, y: Rational) -> Complex<Rational> {
    Complex::new(x, y)
}

fn start(speed: Rational, positions: &[(i64, i64)], headings: &[Rational]) -> KinematicStart {
    KinematicStart {
        speed,
        positions: positions.iter().map(|&(x, y)| point(rational(x, 1), rational(y, 1))).collect(),
        headings: headings.to_vec(),
        hysteresis: Hysteresis::None,
    }
}

/// Model K written down directly in floats.
struct Naive {
    speed: f64,
    positions: Vec<(f64, f64)>,
    headings: Vec<f64>,
    threshold: f64,
    network: Graph,
}

/// Comparisons nearer than this say nothing in floats.
const NEAR: f64 = 1e-7;

impl Naive {
    fn new(start: &KinematicStart) -> Self {
        let float = |x: &Rational| x.to_f64().unwrap();
        let n = start.positions.len();
        let threshold = match &start.hysteresis {
            Hysteresis::None => 0.0,
            Hysteresis::Constant(c) => float(c),
            Hysteresis::Paper => (n as f64).powf(-(n as f64).powi(4)),
        };
        let positions: Vec<(f64, f64)> = start.positions.iter().map(|x| (float(&x.re), float(&x.im))).collect();
        let squared = |i: usize, j: usize| (start.positions[i].clone() - &start.positions[j]).norm_squared();
        let network = Graph::from_fn(n, |i, j| squared(i, j) <= rational(1, 1));
        let headings = start.headings.iter().map(float).collect();
        Naive { speed: float(&start.speed), positions, headings, threshold, network }
    }

    /// Whether every comparison was clear.
    fn step(&mut self, kappa: &[f64]) -> bool {
        let n = self.positions.len();
        let distance = |p: &[(f64, f64)], i: usize, j: usize| (p[i].0 - p[j].0).hypot(p[i].1 - p[j].1);
        let move_by = |(&(x, y), &h): (&(f64, f64), &f64)| (x + self.speed * h.cos(), y + self.speed * h.sin());
        let moved: Vec<(f64, f64)> = self.positions.iter().zip(&self.headings).map(move_by).collect();
        let change = |i: usize, j: usize| (distance(&moved, i, j) - distance(&self.positions, i, j)).abs();
        let held = |i, j| self.network.has_edge(i, j) && self.threshold > 0.0 && change(i, j) < self.threshold;
        let clear = (0..n).all(|j| {
            (0..j).all(|i| {
                let d = distance(&moved, i, j);
                let asked = d > 1.0 && self.network.has_edge(i, j) && self.threshold > 0.0;
                (d - 1.0).abs() > NEAR && (!asked || (change(i, j) - self.threshold).abs() > NEAR)
            })
        });
        let network = Graph::from_fn(n, |i, j| distance(&moved, i, j) <= 1.0 || held(i, j));
        self.headings = (0..n)
            .map(|i| {
                let near = network.neighbours(i);
                let sum: f64 = near.iter().map(|&j| self.headings[j as usize]).sum();
                kappa[i] + (self.headings[i] + sum) / (near.len() + 1) as f64
            })
            .collect();
        (self.positions, self.network) = (moved, network);
        clear
    }
}

fn hysteresis() -> impl Strategy<Value = Hysteresis> {
    let constant = (0i64..40).prop_map(|k| Hysteresis::Constant(rational(k, 160)));
    prop_oneof![Just(Hysteresis::None), constant, Just(Hysteresis::Paper)]
}

fn starts() -> impl Strategy<Value = KinematicStart> {
    (1usize..=5).prop_flat_map(|birds| {
        let place = (0i64..40, 0i64..40).prop_map(|(x, y)| point(rational(x, 16), rational(y, 16)));
        let heading = (0i64..=62).prop_map(|k| rational(k, 10));
        let (places, headings) = (prop::collection::vec(place, birds), prop::collection::vec(heading, birds));
        (places, headings, 1i64..12, hysteresis()).prop_map(|(positions, headings, speed, hysteresis)| KinematicStart {
            speed: rational(speed, 10),
            positions,
            headings,
            hysteresis,
        })
    })
}

proptest! {
    #[test]
    fn steps_agree_with_floats(start in starts(), kappa in prop::collection::vec(-6i64..6, 5), free in any::<bool>()) {
        let mut flock = KinematicFlock::new(&start).unwrap();
        let mut naive = Naive::new(&start);
        prop_assert_eq!(flock.network(), &naive.network);
        let kappa: Vec<Rational> = kappa[..flock.birds()].iter().map(|&k| rational(if free { 0 } else { k }, 7)).collect();
        let floats: Vec<f64> = kappa.iter().map(|k| k.to_f64().unwrap()).collect();
        for t in 1..=15u64 {
            let before = (flock.network().clone(), flock.headings());
            let clear = naive.step(&floats);
            let switch = if free { flock.step() } else { flock.step_controlled(|_| Some(kappa.clone())) }.unwrap();
            prop_assert_eq!(flock.time(), t);
            if !clear {
                break;
            }
            prop_assert_eq!(flock.network(), &naive.network);
            prop_assert_eq!(switch.is_some(), before.0 != naive.network);
            for (x, &(re, im)) in flock.positions().iter().zip(&naive.positions) {
                prop_assert!((x.re.to_f64() - re).abs() < 1e-9 && (x.im.to_f64() - im).abs() < 1e-9);
            }
            // theta(t+1) = kappa + P(t) theta(t), exactly.
            let p = transition_matrix(flock.network(), &Weights::Vicsek).unwrap();
            let averaged = p.apply(&before.1).unwrap();
            let expected: Vec<Rational> = averaged.iter().zip(&kappa).map(|(a, k)| a + k).collect();
            prop_assert_eq!(flock.headings(), expected);
        }
    }

    /// From one point, a rotation or reflection of all headings changes no network; nor do a translation and another order.
    #[test]
    fn networks_do_not_feel_symmetries(
        headings in prop::collection::vec(0i64..30, 2..6), speed in 5i64..30, turn in 0i64..30, mirror in any::<bool>(),
        shift in (-99i64..99, -99i64..99), hysteresis in hysteresis()
    ) {
        let birds = headings.len();
        let at = |x: i64, y: i64| vec![point(rational(x, 7), rational(y, 7)); birds];
        let turned = |h: &i64| rational(if mirror { 30 - h } else { *h } + turn, 10);
        let one = KinematicStart {
            speed: rational(speed, 10),
            positions: at(0, 0),
            headings: headings.iter().map(|&h| rational(h, 10)).collect(),
            hysteresis,
        };
        let other = KinematicStart {
            positions: at(shift.0, shift.1),
            headings: headings.iter().rev().map(turned).collect(),
            ..one.clone()
        };
        let (mut one, mut other) = (KinematicFlock::new(&one).unwrap(), KinematicFlock::new(&other).unwrap());
        for _ in 0..10 {
            one.step().unwrap();
            other.step().unwrap();
            let back = Graph::from_fn(birds, |i, j| other.network().has_edge(birds - 1 - i, birds - 1 - j));
            prop_assert_eq!(one.network(), &back);
        }
    }

    /// Without control the headings stay within the range of the first ones.
    #[test]
    fn headings_contract(start in starts()) {
        let mut flock = KinematicFlock::new(&start).unwrap();
        let range = |list: &[Rational]| (list.iter().min().unwrap().clone(), list.iter().max().unwrap().clone());
        for _ in 0..6 {
            let (low, high) = range(&flock.headings());
            flock.step().unwrap();
            let (least, most) = range(&flock.headings());
            prop_assert!(low <= least && most <= high);
        }
    }
}

/// Distance exactly 1 in parallel flight, and distances that differ from 1 by less than any float shows.
#[test]
fn parallel_birds_keep_their_exact_distance() {
    let tiny = Rational::new(1.into(), BigInt::from(1) << 4000u32);
    for (by, joined) in [(rational(0, 1), true), (tiny.clone(), false), (-tiny, true)] {
        let mut start = start(rational(1, 10), &[(0, 0), (0, 0)], &[rational(1, 3), rational(1, 3)]);
        start.positions[1] = point(rational(3, 5) + by, rational(4, 5));
        let mut flock = KinematicFlock::new(&start).unwrap();
        for _ in 0..60 {
            assert_eq!(flock.network().has_edge(0, 1), joined);
            assert_eq!(flock.step(), Ok(None));
        }
        assert_eq!(flock.precision(), 128);
    }
}

/// `x_1 - x_2 = -1` becomes `-e^i`: distance 1 again, and floats cannot know.
#[test]
fn a_difference_that_is_only_turned_is_a_tie() {
    let mut flock =
        KinematicFlock::new(&start(rational(1, 1), &[(-1, 0), (0, 0)], &[rational(0, 1), rational(1, 1)])).unwrap();
    for t in 0..40 {
        assert!(flock.network().has_edge(0, 1), "t = {t}");
        assert_eq!(flock.step(), Ok(None));
    }
    assert_eq!(flock.precision(), 128);
    assert_eq!(flock.headings(), [rational(1, 2), rational(1, 2)]);
}

/// Birds that fly each other's headings one after the other return to their first difference.
#[test]
fn exchanged_headings_are_a_tie() {
    let (a, b) = (rational(1, 5), rational(2, 1));
    let mut flock = KinematicFlock::new(&start(rational(1, 3), &[(0, 0), (1, 0)], &[b.clone(), a.clone()])).unwrap();
    let aim = |target: [Rational; 2]| {
        move |flock: &KinematicFlock| {
            let p = transition_matrix(flock.network(), &Weights::Vicsek).unwrap();
            let averaged = p.apply(&flock.headings()).unwrap();
            Some(target.iter().zip(averaged).map(|(to, from)| to - from).collect())
        }
    };
    let lost = flock.step_controlled(aim([a.clone(), b.clone()])).unwrap().expect("the birds part");
    assert_eq!((lost.time, lost.lost, lost.gained), (1.into(), vec![(0, 1)], vec![]));
    let gained = flock.step_controlled(aim([a.clone(), a])).unwrap().expect("they are back at distance 1");
    assert_eq!((gained.time, gained.gained), (2.into(), vec![(0, 1)]));
    assert_eq!(flock.precision(), 128);
    // In parallel from now on.
    for _ in 0..20 {
        assert_eq!(flock.step(), Ok(None));
    }
}

const FINE: u32 = 1000;

fn exactly(x: &Interval) -> Rational {
    x.midpoint(FINE).to_rationals().0
}

/// `sigma sum e^(i theta)` to some 1000 bits.
fn way(speed: &Rational, headings: &[Rational]) -> Complex<Rational> {
    let enclosure = |h: &Rational| Interval::from_rational(h, FINE).sin_cos().expect("an angle");
    let sum = |part: fn(&(Interval, Interval)) -> &Interval| {
        headings.iter().map(|h| exactly(part(&enclosure(h)))).sum::<Rational>() * speed
    };
    point(sum(|(_, cos)| cos), sum(|(sin, _)| sin))
}

/// Birds 1 and 2 fly together; bird 3 comes from afar and is at distance `1 + by` of bird 1 at `t = 4`.
fn appointment(by: &Rational) -> (KinematicStart, Vec<Rational>) {
    let kappa = vec![rational(1, 6), rational(-1, 9), rational(-1, 4)];
    let two = start(rational(1, 2), &[(0, 0), (0, 1)], &[rational(1, 2), rational(3, 4)]);
    let mut flock = KinematicFlock::new(&two).unwrap();
    let mut first = Vec::new();
    for _ in 0..4 {
        first.push(flock.headings()[0].clone());
        flock.step_controlled(|_| Some(kappa[..2].to_vec())).unwrap();
    }
    let third: Vec<Rational> = (0..4).map(|t| rational(4, 1) + &kappa[2] * rational(t, 1)).collect();
    let mut all = two.clone();
    all.headings.push(third[0].clone());
    let ahead = point(rational(1, 1) + by, rational(0, 1));
    all.positions.push(way(&two.speed, &first) - way(&two.speed, &third) + ahead);
    (all, kappa)
}

#[test]
fn near_ties_are_refined_and_never_guessed() {
    for sign in [-1, 1] {
        let by = Rational::new(sign.into(), BigInt::from(1) << 400u32);
        let (start, kappa) = appointment(&by);
        let fly = |flock: &mut KinematicFlock| flock.step_controlled(|_| Some(kappa.clone()));
        let mut flock = KinematicFlock::new(&start).unwrap();
        for _ in 0..3 {
            fly(&mut flock).unwrap();
            assert!(!flock.network().has_edge(0, 2) && flock.precision() == 128);
        }
        let mut coarse = flock.clone().with_most_bits(256);
        fly(&mut flock).unwrap();
        assert_eq!((flock.network().has_edge(0, 2), flock.precision()), (sign < 0, 512));
        let error = fly(&mut coarse).unwrap_err();
        assert_eq!(error, FlockError::Undecided { pair: (1, 3), time: 4, against: "distance 1", bits: 256 });
        assert!(error.to_string().contains("birds 1 and 3 at t = 4"));
        // Computed again from the start, with the networks and the control as they were.
        assert!(flock.positions().iter().all(|x| x.re.width().top() < -490));
        let exact = flock.positions()[2].clone() - &flock.positions()[0];
        assert!(exact.re.contains(&(rational(1, 1) + &by)) && exact.im.contains_zero());
    }
}

/// The upper of two birds at distance 1 rises by `sigma sin(delta)`, far below every float but either side of the threshold
/// `4^(-256)` of four birds.
#[test]
fn the_threshold_of_the_paper() {
    let power = |k: u32| Rational::new(1.into(), BigInt::from(1) << (2 * k));
    for (delta, held) in [(power(250), false), (power(260), true)] {
        let mut birds = start(rational(1, 4), &[(0, 0), (0, 1), (10, 0), (20, 0)], &vec![rational(0, 1); 4]);
        birds.headings[1] = delta;
        let mut bare = KinematicFlock::new(&birds).unwrap();
        birds.hysteresis = Hysteresis::Paper;
        let mut flock = KinematicFlock::new(&birds).unwrap();
        flock.step().unwrap();
        assert_eq!(flock.network().has_edge(0, 1), held);
        // What is held needs no decision about its length.
        assert!(if held { flock.precision() == 128 } else { flock.precision() >= 512 });
        assert!(bare.step().unwrap().is_some_and(|switch| switch.lost == [(0, 1)]));
        assert!(bare.precision() >= 512);
    }
}

/// Pairs that need not be looked at for long are looked at in time: far ones that meet, near ones that part.
#[test]
fn quiet_pairs_are_looked_at_in_time() {
    let tenths = |list: &[i64]| list.iter().map(|k| rational(*k, 10)).collect::<Vec<_>>();
    let placed = |speed: Rational, unit: i64, positions: &[(i64, i64)], headings: &[i64]| KinematicStart {
        positions: positions.iter().map(|&(x, y)| point(rational(x, unit), rational(y, unit))).collect(),
        ..start(speed, &[], &tenths(headings))
    };
    // The last one and its control in the first step.
    for (birds, kappa, steps) in [
        (placed(rational(1, 2), 1, &[(0, 0), (10, 0)], &[0, 31]), 0, 30),
        (placed(rational(1, 2), 1, &[(10, 0), (0, 0)], &[31, 0]), 0, 30),
        (placed(rational(3, 1), 1, &[(0, 0), (96, -2)], &[0, 31]), 0, 20),
        (placed(rational(1, 5), 16, &[(29, 30), (14, 23), (18, 26)], &[6, 59, 5]), 0, 12),
        (placed(rational(1, 5), 16, &[(29, 18), (1, 13), (15, 21)], &[47, 1, 56]), 0, 12),
        (placed(rational(1, 2), 16, &[(-27, 148), (0, 0)], &[0, 22]), -1, 30),
    ] {
        let (mut flock, mut naive) = (KinematicFlock::new(&birds).unwrap(), Naive::new(&birds));
        let mut switches = 0;
        for t in 1..=steps {
            let turn = if t == 1 { kappa } else { 0 };
            assert!(naive.step(&vec![turn as f64; birds.headings.len()]));
            let control = |flock: &KinematicFlock| (turn != 0).then(|| vec![rational(turn, 1); flock.birds()]);
            switches += usize::from(flock.step_controlled(control).unwrap().is_some());
            assert_eq!(flock.network(), &naive.network, "t = {t} of {birds:?}");
        }
        assert!(switches > 0, "{birds:?}");
    }
}

/// Birds 1 and 2 at distance `1 - 85/10^18`, which in floats is `1 - 2^-53`, nearer to 1 by a quarter: the 18 birds that turn bird 2 have it part
/// by `9/10^17` in the second step, of at most `10^-16` that any two birds part in a step.
#[test]
fn quiet_pairs_are_not_trusted_within_the_rounding_of_floats() {
    let tiny = |p: i64, digits: u32| rational(p, 1) / rational(10, 1).power(u64::from(digits));
    let mut birds = start(tiny(1, 13), &[], &[]);
    let height = rational(1, 1) - tiny(85, 18);
    birds.positions = vec![point(rational(0, 1), rational(0, 1)), point(rational(0, 1), height.clone())];
    birds.headings = vec![rational(0, 1); 2];
    birds.positions.extend(vec![point(rational(0, 1), height + rational(1, 2)); 18]);
    birds.headings.extend(vec![rational(1, 1000); 18]);
    let mut flock = KinematicFlock::new(&birds).unwrap();
    flock.step().unwrap();
    assert!(flock.network().has_edge(0, 1) && flock.network().has_edge(1, 2) && !flock.network().has_edge(0, 2));
    assert!(flock.step().unwrap().is_some_and(|switch| switch.lost == [(0, 1)]));
}

/// Birds 1 and 2 with headings 0 and `h` from the difference `D`: `D + sigma - sigma e^(ih)` has nearly the length 1, or is `D` turned.
#[test]
fn differences_that_are_not_only_turned_are_refined() {
    let hair = |bits: u32| Rational::new(1.into(), BigInt::from(1) << bits);
    let pair = |difference: (Rational, Rational), at: (i64, i64), speed: Rational, heading: Rational| {
        let at = point(rational(at.0, 7), rational(at.1, 7));
        let mut birds = start(speed, &[], &[rational(0, 1), heading]);
        birds.positions = vec![point(difference.0, difference.1) + &at, at];
        let mut flock = KinematicFlock::new(&birds).unwrap();
        flock.step().map(|_| (flock.network().has_edge(0, 1), flock.precision() > 128))
    };
    let one = || rational(1, 1);
    let zero = || rational(0, 1);
    for at in [(0, 0), (5, 3)] {
        assert_eq!(pair((-one(), zero()), at, one(), one()), Ok((true, false)), "turned");
        // 1 + 3/4 h² and 1 - 1/4 h².
        assert_eq!(pair((one(), zero()), at, rational(1, 2), hair(80)), Ok((false, true)));
        assert_eq!(pair((-one(), zero()), at, rational(1, 2), hair(80)), Ok((true, true)));
        // 1 + 24/25 sin h and 1 - 24/25 sin h.
        assert_eq!(pair((rational(-3, 5), rational(-4, 5)), at, rational(3, 5), hair(140)), Ok((false, true)));
        assert_eq!(pair((rational(-3, 5), rational(4, 5)), at, rational(3, 5), hair(140)), Ok((true, true)));
        // Turned, but of another length.
        let long = one() + hair(200);
        assert_eq!(pair((-&long, zero()), at, long, one()), Ok((false, true)));
    }
}

/// `|1 + 1/2 - e^(ih)/2|`, which differs from 1 after some 8400 bits.
#[test]
fn distances_are_compared_with_so_many_bits_and_no_more() {
    let hair = Rational::new(1.into(), BigInt::from(1) << 4200u32);
    let birds = start(rational(1, 2), &[(1, 0), (0, 0)], &[rational(0, 1), hair]);
    let undecided = FlockError::Undecided { pair: (1, 2), time: 1, against: "distance 1", bits: 8192 };
    assert_eq!(KinematicFlock::new(&birds).unwrap().step(), Err(undecided));
}

/// Headings that converge for long, with and without hysteresis, ask for little precision.
#[test]
fn long_runs_stay_cheap() {
    let mut birds = start(rational(1, 4), &[(0, 0), (1, 0), (0, 1), (1, 1)], &[]);
    birds.headings = (0..4).map(|i| rational(i, 40)).collect();
    for hysteresis in [Hysteresis::None, Hysteresis::Paper] {
        birds.hysteresis = hysteresis;
        let mut flock = KinematicFlock::new(&birds).unwrap();
        (0..300).for_each(|_| drop(flock.step().unwrap()));
        assert_eq!(flock.precision(), 128);
    }
}

#[test]
fn hysteresis_holds_and_lets_go() {
    // The first step widens the distance from 1 to sqrt(1 + 4 sin²(1/16)/16 ..): compare with floats either side.
    let mut birds = start(rational(1, 4), &[(0, 0), (0, 1)], &[rational(0, 1), rational(1, 8)]);
    let after = (1.0 + 0.25 * 0.125f64.sin()).hypot(0.25 * (1.0 - 0.125f64.cos()));
    for (threshold, held) in [(after - 1.0 - 1e-12, false), (after - 1.0 + 1e-12, true)] {
        birds.hysteresis = Hysteresis::Constant(Rational::from_float(threshold).unwrap());
        let mut flock = KinematicFlock::new(&birds).unwrap();
        flock.step().unwrap();
        assert_eq!(flock.network().has_edge(0, 1), held);
    }
    birds.hysteresis = Hysteresis::Constant(rational(0, 1));
    let mut flock = KinematicFlock::new(&birds).unwrap();
    assert!(flock.step().unwrap().is_some());
}

#[test]
fn a_lonely_bird_obeys_its_control() {
    let mut flock = KinematicFlock::new(&start(rational(2, 1), &[(0, 0)], &[rational(1, 1)])).unwrap();
    for t in 1..=10i64 {
        let kappa = |flock: &KinematicFlock| flock.time().is_multiple_of(2).then(|| vec![rational(1, 3)]);
        assert_eq!(flock.step_controlled(kappa), Ok(None));
        assert_eq!(flock.headings(), [rational(1, 1) + rational(t / 2, 3)]);
    }
    let headings: Vec<Rational> = (1..=10).map(|t| rational(1, 1) + rational((t - 1) / 2, 3)).collect();
    let (expected, found) = (way(&rational(2, 1), &headings), &flock.positions()[0]);
    assert!(found.re.contains(&expected.re) && found.im.contains(&expected.im));
    assert!(found.re.width().top() < -110);
    assert_eq!(flock.step_controlled(|_| Some(vec![])), Err(FlockError::Kappa { birds: 1, found: 0 }));
}

#[test]
fn flocks_that_are_refused() {
    let zero = || rational(0, 1);
    let refuse = |start: &KinematicStart| KinematicFlock::new(start).map(|_| ()).unwrap_err();
    assert_eq!(refuse(&start(rational(1, 1), &[], &[])), FlockError::NoBirds);
    assert_eq!(refuse(&start(zero(), &[(0, 0)], &[zero()])), FlockError::Speed("0".to_string()));
    assert_eq!(refuse(&start(rational(-1, 2), &[(0, 0)], &[zero()])), FlockError::Speed("-1/2".to_string()));
    assert_eq!(refuse(&start(rational(1, 1), &[(0, 0)], &[])), FlockError::Headings { birds: 1, found: 0 });
    let heading = |h: Rational| KinematicFlock::new(&start(rational(1, 1), &[(0, 0)], &[h])).map(|_| ());
    assert!(matches!(heading(rational(-1, 1000)), Err(FlockError::Heading { bird: 1, .. })));
    assert!(matches!(heading(rational(7, 1)), Err(FlockError::Heading { .. })));
    let two = start(rational(1, 1), &[(0, 0); 3], &[zero(), rational(7, 1), rational(8, 1)]);
    assert_eq!(refuse(&two), FlockError::Heading { bird: 2, heading: "7".to_string() });
    // 2 pi to 900 bits, from below and from above.
    let (below, above) = (rational(1, 1), rational(-1, 1));
    let two_pi = exactly(&Interval::from_rational(&below, FINE).pi().scaled(1));
    let ulp = Rational::new(1.into(), BigInt::from(1) << 900u32);
    assert_eq!(heading(two_pi.clone() - below * &ulp), Ok(()));
    assert!(heading(two_pi - above * ulp).is_err());
    let negative = KinematicStart {
        hysteresis: Hysteresis::Constant(rational(-1, 2)),
        ..start(rational(1, 1), &[(0, 0)], &[zero()])
    };
    assert_eq!(refuse(&negative), FlockError::NegativeHysteresis("-1/2".to_string()));
}

#[test]
fn files_of_flocks() {
    let good = r#"{"model": "K", "dimension": 2, "speed": "1/10", "headings": ["0", 0.5], "positions": [[0, 0], ["1/2", 1]],
                   "hysteresis": "paper", "kappa": ["0", "1/100"], "ids": ["a", "b"]}"#;
    let Model::K { start, control } = read_flock(good).unwrap().model else { panic!("{good}") };
    assert_eq!(start.positions[1], point(rational(1, 2), rational(1, 1)));
    assert_eq!((start.headings, start.hysteresis), (vec![rational(0, 1), rational(1, 2)], Hysteresis::Paper));
    assert_eq!(control, Some(vec![rational(0, 1), rational(1, 100)]));
    let bad = |from: &str, to: &str, named: &str| {
        assert!(good.contains(from), "{from}");
        let error = read_flock(&good.replace(from, to)).unwrap_err().to_string();
        assert!(error.contains(named), "{error} does not name {named}");
    };
    bad("\"dimension\": 2", "\"dimension\": 3", "dimension");
    bad("\"dimension\": 2", "\"weights\": \"lazy\"", "no field `weights`");
    bad("\"dimension\": 2", "\"velocities\": [[0, 0], [0, 0]]", "no field `velocities`");
    bad("\"dimension\": 2", "\"control\": [[1]]", "kappa");
    bad("\"1/10\"", "0", "speed must be positive");
    bad("\"1/10\"", "\"-1/10\"", "speed must be positive");
    bad("\"1/10\"", "\"NaN\"", "`speed`");
    bad("\"speed\": \"1/10\", ", "", "speed");
    bad("0.5", "\"NaN\"", "headings, bird 2");
    bad("0.5", "NaN", "JSON");
    bad("0.5", "6.2832", "2 pi");
    bad("0.5", "-1", "2 pi");
    bad(", 0.5", "", "1 headings");
    bad("[0, 0]", "[0]", "1 coordinates");
    bad("[\"1/2\", 1]", "[1, 2, 3]", "3 coordinates");
    bad(", \"1/100\"", "", "kappa");
    bad("\"1/100\"", "{}", "kappa, bird 2");
    bad("\"paper\"", "-1", "negative");
    bad(", \"b\"", "", "ids");
}
