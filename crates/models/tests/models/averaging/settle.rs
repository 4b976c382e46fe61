//! Jumping against stepping.

use super::flock::starts;
use algebra::graph::Graph;
use algebra::matrix::RationalMatrix;
use arithmetic::{Field, Interval, Number, Rational, Ring, Unwatched, rational};
use models::averaging::settle::{Ending, Limits, Settlement, settle};
use models::averaging::{
    Flock, Hysteresis, Start, Switch, Weights, deviation_matrix, stationary_distribution, transition_matrix,
};
use num_bigint::BigInt;
use proptest::prelude::*;

fn all_switches(start: &Start, limits: &Limits) -> (Vec<Switch>, Settlement) {
    let mut switches = Vec::new();
    let settled = settle(Flock::new(start).unwrap(), limits, &mut |switch| switches.push(switch.clone()), &Unwatched);
    (switches, settled.unwrap())
}

fn line(x: &[(i64, i64)], v: &[(i64, i64)], hysteresis: Hysteresis) -> Start {
    let numbers = |list: &[(i64, i64)]| list.iter().map(|&(p, q)| rational(p, q)).collect();
    Start::on_the_line(numbers(x), numbers(v), Weights::Lazy, hysteresis)
}

fn four_birds(hysteresis: Hysteresis) -> Start {
    line(&[(0, 16), (8, 16), (21, 16), (29, 16)], &[(1, 8), (-1, 8), (1, 8), (-1, 8)], hysteresis)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// The switches up to some time are those of stepping, and what is called steady does not change.
    #[test]
    fn settling_agrees_with_stepping(start in starts()) {
        const UNTIL: u32 = 300;
        let limits = Limits { switches: 400, steps: 6_000, ..Limits::default() };
        let (jumped, settled) = all_switches(&start, &limits);
        let mut flock = Flock::new(&start).unwrap();
        let stepped: Vec<Switch> = (0..UNTIL).filter_map(|_| flock.step().unwrap()).collect();
        let jumped: Vec<Switch> = jumped.into_iter().filter(|s| s.time <= UNTIL.into()).collect();
        match settled.ending {
            Ending::Steady => prop_assert_eq!(jumped, stepped),
            // Stopped on the way: what was found so far.
            _ => prop_assert_eq!(&jumped, &stepped[..jumped.len()]),
        }
    }

}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4))]

    /// Pairs that meet after about 10^4 steps: the exact jump and the limit jump find the same switches.
    #[test]
    fn both_kinds_of_jump_agree(speeds in prop::collection::vec(1i64..9, 2), gaps in prop::collection::vec(20i64..60, 1)) {
        let mut x = vec![rational(0, 1), rational(2, 3)];
        let mut v = Vec::new();
        for gap in &gaps {
            let next = x[x.len() - 1].clone() + rational(*gap, 16);
            x.extend([next.clone(), next + rational(2, 3)]);
        }
        for (k, speed) in speeds.iter().enumerate() {
            let sign = if k % 2 == 0 { 1 } else { -1 };
            v.extend([rational(sign * speed, 30_000), rational(0, 1)]);
        }
        let start = Start::on_the_line(x, v, Weights::Lazy, Hysteresis::None);
        let exact = all_switches(&start, &Limits::default());
        let limit = all_switches(&start, &Limits { jump_bits: 0, ..Limits::default() });
        if matches!(exact.1.ending, Ending::Steady) && matches!(limit.1.ending, Ending::Steady) {
            prop_assert_eq!(exact.0, limit.0);
        } else {
            let common = exact.0.len().min(limit.0.len());
            prop_assert_eq!(&exact.0[..common], &limit.0[..common]);
        }
    }
}

#[test]
fn four_birds_alternate_forever_without_hysteresis() {
    let (switches, settled) = all_switches(&four_birds(Hysteresis::None), &Limits::default());
    assert!(matches!(settled.ending, Ending::Alternating { period: 2 }));
    assert!(switches.iter().enumerate().all(|(k, s)| s.time == (k as u32 + 1).into()));
}

#[test]
fn four_birds_with_the_hysteresis_of_the_paper() {
    // The edge 2-3 is lost at odd t while (1/4) 3^(1-t) >= 4^(-256): 3^(t-1) <= 2^510, t <= 322; it stays at t = 323.
    let (switches, settled) = all_switches(&four_birds(Hysteresis::Paper), &Limits::default());
    assert!(matches!(settled.ending, Ending::Steady));
    assert_eq!(settled.last_switch, 322.into());
    assert_eq!(switches.len(), 322);
    assert_eq!(settled.network.edges(), vec![(0, 1), (1, 2), (2, 3)]);
}

/// The same with the birds in the other order.
#[test]
fn the_order_of_the_birds_does_not_matter_to_a_cycle() {
    let mut start = four_birds(Hysteresis::None);
    start.positions.reverse();
    start.velocities.reverse();
    let (switches, settled) = all_switches(&start, &Limits::default());
    assert!(matches!(settled.ending, Ending::Alternating { period: 2 }));
    assert_eq!(switches[0].lost, [(1, 2)]);
}

/// The middle gap would still tend to 1 if they went on alternating, but a part of 2^-60 falls more slowly than the part that changes its
/// sign, and ends it after some forty steps: it is not taken for a cycle.
#[test]
fn a_cycle_that_ends_is_not_proved() {
    let pairs = Graph::empty(4).with_edges(&[(0, 1), (2, 3)]);
    let matrix = |network: &Graph| transition_matrix(network, &Weights::Lazy).unwrap();
    let one = RationalMatrix::identity(4).unwrap();
    let (first, second) = (matrix(&pairs), matrix(&Graph::path(4)));
    let round = second.times(&first).unwrap();
    let kernel = round.transpose().minus(&one).unwrap().kernel();
    let total: Rational = kernel[0].iter().sum();
    let pi: Vec<Rational> = kernel[0].iter().map(|x| x / &total).collect();
    let gamma = deviation_matrix(&round, &pi).unwrap();
    for sign in [1, -1] {
        let slow = rational(sign, 1 << 60);
        let v: Vec<Rational> =
            [1, -1, 1, -1].iter().zip([1, 1, -1, -1]).map(|(a, b)| rational(*a, 8) + &slow * rational(b, 1)).collect();
        let way = one.plus(&first).unwrap().apply(&gamma.apply(&v).unwrap()).unwrap();
        let middle = rational(1, 2) + rational(1, 1) + &way[1] - &way[2];
        let x = vec![rational(0, 1), rational(1, 2), middle.clone(), middle + rational(1, 2)];
        let start = Start::on_the_line(x, v, Weights::Lazy, Hysteresis::None);
        let (switches, settled) = all_switches(&start, &Limits { switches: 200, ..Limits::default() });
        let mut flock = Flock::new(&start).unwrap();
        let stepped: Vec<Switch> = (0..200).filter_map(|_| flock.step().unwrap()).collect();
        assert!(stepped.len() > 30 && stepped.len() < 60);
        let known: Vec<Switch> = switches.into_iter().filter(|s| s.time <= 200.into()).collect();
        assert_eq!(known, stepped);
        assert!(matches!(settled.ending, Ending::Steady), "{}", settled.why);
    }
}

/// Two groups of four birds that merge after more than 10^84 steps.
fn two_groups() -> Start {
    let x: Vec<Rational> = (0..4).flat_map(|l| [rational(2 * l, 1), rational(6 * l + 2, 3)]).collect();
    let v = [0, 1, 0, -1, 1, 0, -1, 0].map(|s| rational(s, 512)).to_vec();
    Start::on_the_line(x, v, Weights::Lazy, Hysteresis::None)
}

#[test]
fn a_merger_after_many_steps() {
    let (switches, settled) = all_switches(&two_groups(), &Limits::default());
    assert!(matches!(settled.ending, Ending::Steady));
    assert_eq!(switches.len(), 2);
    assert_eq!(switches[0].time, 171.into());
    assert_eq!(switches[1].gained, vec![(3, 4)]);
    assert_eq!(switches[1].time.to_string().len(), 85);
    // By hand: after t = 171 the groups move at a/6 3^-170 towards one another; the gap is the limit of x_5 - x_4.
    let mut flock = Flock::new(&two_groups()).unwrap();
    (0..171).for_each(|_| drop(flock.step().unwrap()));
    let mean = |rows: &[Vec<Rational>]| {
        let weights = [1, 2, 2, 1].map(|w| rational(w, 6));
        rows.iter().zip(weights).map(|(v, w)| &v[0] * w).sum::<Rational>()
    };
    let v = flock.velocities();
    let closing = mean(&v[..4]) - mean(&v[4..]);
    assert!(closing > rational(0, 1));
    (0..2000).for_each(|_| drop(flock.step().unwrap()));
    let x = flock.positions();
    let gap = &x[4][0] - &x[3][0] - rational(1, 1);
    let contact = (gap / closing).ceil().to_integer() + BigInt::from(2171);
    assert_eq!(switches[1].time, contact);
}

/// Mirror images of two groups whose drifts cancel but for what is left of their inner motion.
fn mirror_images() -> Start {
    let patterns: [[(i64, i64); 4]; 4] = [
        [(0, 1), (1, 1), (0, 1), (-1, 1)],
        [(7, 8), (1, 8), (-9, 8), (1, 8)],
        [(-1, 8), (9, 8), (-1, 8), (-7, 8)],
        [(1, 1), (0, 1), (-1, 1), (0, 1)],
    ];
    let x: Vec<Rational> = (0..8).flat_map(|l| [rational(2 * l, 1), rational(6 * l + 2, 3)]).collect();
    let v = patterns.concat().into_iter().map(|(p, q)| rational(p, 512 * q)).collect();
    Start::on_the_line(x, v, Weights::Lazy, Hysteresis::None)
}

#[test]
fn a_contact_beyond_all_digits() {
    let (switches, settled) = all_switches(&mirror_images(), &Limits::default());
    assert_eq!(switches.len(), 2);
    let Ending::Beyond { pairs, log2_steps } = settled.ending else { panic!("{:?}", settled.ending) };
    assert_eq!(pairs, [(7, 8)]);
    // The relative drift falls like 3^-s, because the contributions of the eigenvalue 2/3 cancel.
    let s = switches[1].time.clone() - 171u32;
    let ratio = log2_steps.to_f64() / s.to_string().parse::<f64>().unwrap();
    assert!((ratio - 3f64.log2()).abs() < 1e-9, "{ratio}");
}

/// As above, with numbers: from the motion of the eight birds after the first contact, by eigenvectors.
#[test]
fn the_time_of_a_contact_beyond_all_digits() {
    let start = mirror_images();
    let (switches, settled) = all_switches(&start, &Limits::default());
    let Ending::Beyond { log2_steps, .. } = settled.ending else { panic!("{:?}", settled.ending) };
    let mut flock = Flock::new(&start).unwrap();
    (0..171).for_each(|_| drop(flock.step().unwrap()));
    let column = |rows: Vec<Vec<Rational>>| -> Vec<Rational> { rows.into_iter().map(|row| row[0].clone()).collect() };
    let (x, v) = (column(flock.positions()), column(flock.velocities()));
    let steps = Rational::from_integer(switches[1].time.clone() - 171u32);
    // Where velocities go on a path, and what positions gain beside.
    let limits = |v: &[Rational]| {
        let path = Graph::path(v.len());
        let pi = stationary_distribution(&path, &Weights::Lazy).unwrap();
        let gamma = deviation_matrix(&transition_matrix(&path, &Weights::Lazy).unwrap(), &pi).unwrap();
        let drift: Rational = pi.iter().zip(v).map(|(p, v)| p * v).sum();
        (drift, gamma.apply(v).unwrap())
    };
    let (mut places, mut drifts, mut swings) = (Vec::new(), Vec::new(), Vec::new());
    for group in 0..4 {
        let v = &v[4 * group..4 * group + 4];
        let (drift, rest) = limits(v);
        // The part of (1, -1, 1, -1), for the weights (1, 2, 2, 1)/6.
        swings.push((&v[0] - &v[1] * rational(2, 1) + &v[2] * rational(2, 1) - &v[3]) * rational(1, 6));
        places.extend((0..4).map(|i| &x[4 * group + i] + &rest[i] + &drift * &steps));
        drifts.extend(vec![drift; 4]);
    }
    let ends = [0, 8].map(|first| {
        let (drift, rest) = limits(&drifts[first..first + 8]);
        assert!(num_traits::Zero::is_zero(&drift));
        (&places[first] + &rest[0], &places[first + 7] + &rest[7])
    });
    let gap = &ends[1].0 - &ends[0].1 - rational(1, 1);
    // A path of eight has the weights (1, 2, 2, 2, 2, 2, 2, 1)/14: (1, -1, 1, -1) leaves -1/14 on the left and 1/14 on the right.
    let drift = (&swings[3] - &swings[2] - &swings[1] + &swings[0]) * rational(1, 14);
    assert!(gap > rational(0, 1) && drift != rational(0, 1));
    let log2 = |q: Rational| {
        let q = Interval::from_rational(&q, 512);
        q.ln().unwrap().over(&q.integer(2).ln().unwrap()).unwrap()
    };
    let three = log2(rational(3, 1)) * Interval::from_rational(&(steps - rational(1, 1)), 512);
    let expected = log2(gap / num_traits::Signed::abs(&drift)) + three;
    // The enclosures overlap, and what they leave open together is little.
    let apart = log2_steps - expected;
    let (low, high) = apart.to_rationals();
    let most = rational(1, 1 << 28);
    assert!(apart.contains_zero() && -&most <= low && high <= most, "{}", apart.to_f64());
}

/// A pair that swings, and a bird that comes to distance 1 from it after `n` steps but for what is left of the swing; others may follow.
fn swinging(contacts: &[i64], hysteresis: Hysteresis) -> Start {
    let speed = rational(1, 1 << 14);
    let (mut x, mut v) = (Vec::new(), Vec::new());
    for (k, n) in contacts.iter().enumerate() {
        let at = rational(10_000 * k as i64, 1);
        x.extend([at.clone(), &at + rational(1, 2)]);
        // The pair ends 3/16 farther apart.
        x.push(at + rational(1, 2) + rational(3, 32) + rational(1, 1) + &speed * rational(*n, 1));
        v.extend([rational(-1, 8), rational(1, 8), -speed.clone()]);
    }
    Start::on_the_line(x, v, Weights::Lazy, hysteresis)
}

/// A pair that mixes slowly, so that steps are needed before a jump to a bird that comes after two million more.
#[test]
fn a_jump_after_steps_starts_from_where_they_started() {
    let (share, speed, n) = (rational(1, 128), rational(1, 1 << 14), 1i64 << 21);
    let swing = rational(1, 1024);
    // The second bird ends 64 times its velocity to the right.
    let contact = rational(3, 2) + &swing * rational(64, 1) + &speed * (rational(n, 1) - rational(1, 2));
    let start = Start::on_the_line(
        vec![rational(0, 1), rational(1, 2), contact],
        vec![-swing.clone(), swing, -speed],
        Weights::Given(vec![share; 3]),
        Hysteresis::None,
    );
    for jump_bits in [0, 1 << 22] {
        let (switches, settled) = all_switches(&start, &Limits { jump_bits, ..Limits::default() });
        assert_eq!(switches.len(), 1);
        assert_eq!((&switches[0].time, &switches[0].gained), (&n.into(), &vec![(1, 2)]));
        assert!(matches!(settled.ending, Ending::Steady), "{}", settled.why);
        assert_eq!(settled.network.edges(), [(0, 1), (1, 2)]);
    }
}

/// After an even number of steps the pair is closer together than in the limit, after an odd one wider.
#[test]
fn what_a_jump_leaves_out_decides_ties() {
    let contact = |n: i64| if n % 2 == 0 { n + 1 } else { n };
    let cases = [9_000, 9_001].into_iter().flat_map(|n| [vec![n], vec![n, 9_010], vec![n, 9_011]]);
    let (mut beyond, mut steady) = (0, 0);
    for contacts in cases {
        let start = swinging(&contacts, Hysteresis::None);
        let (exact, known) = all_switches(&start, &Limits { steps: 2_000, ..Limits::default() });
        let (found, settled) = all_switches(&start, &Limits { jump_bits: 0, steps: 2_000, ..Limits::default() });
        assert_eq!(found, exact[..found.len()]);
        for (k, &n) in contacts.iter().enumerate() {
            let first = exact.iter().find(|switch| switch.gained.contains(&(3 * k + 1, 3 * k + 2))).unwrap();
            assert_eq!(first.time, contact(n).into());
        }
        match settled.ending {
            Ending::Steady => {
                steady += 1;
                assert!(matches!(known.ending, Ending::Steady) && found.len() == exact.len());
            }
            // The next contact has thousands of digits.
            Ending::Beyond { pairs, log2_steps } => {
                beyond += 1;
                let next = &exact[found.len()];
                assert!(next.gained.iter().all(|pair| pairs.contains(pair)) && next.lost.is_empty());
                let steps = Interval::from_rational(&Rational::from_integer(&next.time - &settled.last_switch), 256);
                let log2 = steps.ln().unwrap().over(&steps.integer(2).ln().unwrap()).unwrap();
                assert!(log2_steps.overlaps(&log2));
                assert!((log2_steps - log2).to_f64().abs() < 1.0);
            }
            ending => panic!("{ending:?}"),
        }
    }
    assert_eq!((beyond, steady), (2, 4));
}

/// A short jump after one that is too long for exact numbers: it starts from a limit, and cannot be exact however short it is. What the long one left out decides
/// the second contact, and is said to be open.
#[test]
fn a_short_jump_after_a_long_one_does_not_forget_it() {
    let contact = |n: i64| BigInt::from(n + i64::from(n % 2 == 0));
    for contacts in [[3_000_001, 3_000_200], [3_000_001, 3_000_201], [3_000_000, 3_000_200], [3_000_000, 3_000_201]] {
        let (found, settled) = all_switches(&swinging(&contacts, Hysteresis::None), &Limits::default());
        let gains = |pair: (usize, usize)| found.iter().filter(move |switch| switch.gained.contains(&pair));
        assert_eq!(gains((1, 2)).next().map(|switch| &switch.time), Some(&contact(contacts[0])));
        assert_eq!(gains((4, 5)).count(), 0);
        assert!(matches!(settled.ending, Ending::Undecided(_)), "{:?}", settled.ending);
    }
}

/// After jumps of hundreds of steps what they leave out is still too large to be left out.
#[test]
fn what_a_short_jump_leaves_out_is_not_forgotten() {
    for contacts in [vec![3_000], vec![9_000, 9_300], vec![9_000, 30_000]] {
        let limits = Limits { jump_bits: 0, steps: 2_000, ..Limits::default() };
        let (switches, settled) = all_switches(&swinging(&contacts, Hysteresis::None), &limits);
        assert_eq!(switches.len(), contacts.len() - 1);
        assert!(
            matches!(settled.ending, Ending::Undecided(_)) && settled.why.contains("told apart"),
            "{}",
            settled.why
        );
    }
}

/// Others whose distance tends to 1, or is 1: after a jump what was left out would decide.
#[test]
fn other_ties_are_open_after_a_jump() {
    let far = rational(100, 1);
    let third = |s: i64| (&far + rational(s, 1) * (rational(1, 1) - rational(3, 64)), rational(s, 32));
    let path = [third(-1), third(0), third(1)];
    let still = [(far.clone(), rational(0, 1)), (&far + rational(1, 1), rational(0, 1))];
    for others in [&path[..], &still] {
        let mut start = swinging(&[9_000], Hysteresis::None);
        for (x, v) in others {
            start.positions.push(vec![x.clone()]);
            start.velocities.push(vec![v.clone()]);
        }
        let limits = Limits { steps: 2_000, ..Limits::default() };
        let (exact, known) = all_switches(&start, &limits);
        let (switches, settled) = all_switches(&start, &Limits { jump_bits: 0, ..limits });
        assert_eq!(switches, exact);
        assert!(matches!(known.ending, Ending::Steady));
        assert!(matches!(settled.ending, Ending::Undecided(why) if why.starts_with("birds 4 and 5: ")));
    }
}

/// With a threshold a change of distance could tie with that too, as soon as an edge is longer than 1.
#[test]
fn held_edges_are_not_followed_after_a_jump() {
    let limits = Limits { jump_bits: 0, steps: 2_000, ..Limits::default() };
    for (n, is_decided) in [(9_000, true), (9_001, false)] {
        let start = swinging(&[n], Hysteresis::Constant(rational(1, 1 << 10)));
        let (exact, _) = all_switches(&start, &Limits { steps: 2_000, ..Limits::default() });
        let (switches, settled) = all_switches(&start, &limits);
        assert_eq!(switches, exact);
        assert_eq!(matches!(settled.ending, Ending::Steady), is_decided, "{}", settled.why);
        assert!(is_decided || settled.why.contains("told apart"), "{}", settled.why);
    }
}

#[test]
fn the_number_of_switches_is_limited() {
    let (switches, settled) = all_switches(&four_birds(Hysteresis::None), &Limits { switches: 3, ..Limits::default() });
    assert_eq!(switches.iter().map(|s| s.time.clone()).collect::<Vec<_>>(), [1, 2, 3].map(BigInt::from));
    assert!(matches!(settled.ending, Ending::Undecided(_)));
    assert_eq!((settled.why.as_str(), settled.last_switch), ("stopped after 3 switches", 3.into()));
}

#[test]
fn small_cases() {
    // One bird; two that part; two that meet at distance exactly 1 and part again, because the one ahead becomes the faster
    // one; two that pass one another at more than distance 1, and at exactly 1.
    let steady = |start: &Start| {
        let (switches, settled) = all_switches(start, &Limits::default());
        assert!(matches!(settled.ending, Ending::Steady), "{:?}", settled.why);
        switches.into_iter().map(|s| s.time.to_string()).collect::<Vec<_>>()
    };
    assert!(steady(&line(&[(0, 1)], &[(5, 1)], Hysteresis::Paper)).is_empty());
    let one = all_switches(&line(&[(0, 1)], &[(5, 1)], Hysteresis::None), &Limits::default()).1;
    assert_eq!(one.why, "one bird has no edges");
    assert!(steady(&line(&[(0, 1), (2, 1)], &[(-1, 1), (1, 1)], Hysteresis::None)).is_empty());
    assert_eq!(steady(&line(&[(0, 1), (1001, 1)], &[(1, 10), (0, 1)], Hysteresis::None)), ["10000", "10001"]);
    let plane = |y: (i64, i64)| Start {
        positions: vec![vec![rational(-1000, 1), rational(0, 1)], vec![rational(0, 1), rational(y.0, y.1)]],
        velocities: vec![vec![rational(1, 1), rational(0, 1)], vec![rational(0, 1); 2]],
        weights: Weights::Given(vec![rational(1, 1_000_000); 2]),
        hysteresis: Hysteresis::None,
    };
    assert!(steady(&plane((1_000_001, 1_000_000))).is_empty());
    assert_eq!(steady(&plane((1, 1)))[0], "1000");
}

#[test]
fn contacts_that_are_not_reached() {
    // The limit of the distance of birds 2 and 3 is exactly 1 at t = 200 (and t = 201), and what is left of the inner motion of the
    // pair pushes apart: no contact then, one step later yes.
    for n in [200i64, 201] {
        let gap = rational(1, 2) + rational(3, 32) + rational(1, 1) + rational(n, 1000);
        let x = vec![rational(0, 1), rational(1, 2), gap];
        let v = vec![rational(-1, 8), rational(1, 8), rational(-1, 1000)];
        let start = Start::on_the_line(x, v, Weights::Lazy, Hysteresis::None);
        let (switches, _) = all_switches(&start, &Limits::default());
        let mut flock = Flock::new(&start).unwrap();
        let stepped: Vec<Switch> = (0..400).filter_map(|_| flock.step().unwrap()).collect();
        let jumped: Vec<Switch> = switches.into_iter().filter(|s| s.time <= 400.into()).collect();
        assert_eq!(jumped, stepped);
    }
}

/// A lazy path of four in the plane whose inner motion dies out like (2/3)^s across and (1/3)^s along the way of a fifth bird, which passes
/// (or meets) the end of the path at distance exactly 1 in the limit: the second order decides, and it is not guessed.
#[test]
fn ties_of_second_order_are_not_guessed() {
    let n = 3_000_000i64;
    for tangential in [true, false] {
        let along = [-1, 1, -1, 1].map(|m| rational(m, 1000));
        let across = [(1, 1), (1, 2), (-1, 2), (-1, 1)].map(|(p, q)| rational(p, 100 * q));
        // Gamma v: 1/(1 - lambda) times the modes.
        let place = |k: i64| vec![rational(2 * k, 3), rational(0, 1)];
        let end = [rational(2, 1) + rational(1, 1000) * rational(3, 4), rational(-1, 100) * rational(3, 1)];
        let speed = if tangential {
            vec![rational(0, 1), rational(-1, 1_000_000)]
        } else {
            vec![rational(-1, 1_000_000), rational(0, 1)]
        };
        let fifth = vec![&end[0] + rational(1, 1) - &speed[0] * rational(n, 1), &end[1] - &speed[1] * rational(n, 1)];
        let mut positions: Vec<Vec<Rational>> = (0..4).map(place).collect();
        positions.push(fifth);
        let mut velocities: Vec<Vec<Rational>> = along.into_iter().zip(across).map(|(a, b)| vec![a, b]).collect();
        velocities.push(speed);
        let start = Start { positions, velocities, weights: Weights::Lazy, hysteresis: Hysteresis::None };
        let (switches, settled) = all_switches(&start, &Limits { jump_bits: 0, ..Limits::default() });
        assert!(switches.is_empty(), "{switches:?}");
        assert!(matches!(settled.ending, Ending::Undecided(_)), "{:?}", settled.why);
    }
}

/// Four birds of the plane that alternate, and others.
fn alternating_in_the_plane(others: &[[(i64, i64); 4]]) -> Start {
    let mut positions: Vec<Vec<Rational>> =
        [(0, 1), (1, 2), (21, 16), (29, 16)].map(|(p, q)| vec![rational(p, q), rational(0, 1)]).to_vec();
    let mut velocities: Vec<Vec<Rational>> = [1, -1, 1, -1].map(|p| vec![rational(p, 8), rational(0, 1)]).to_vec();
    for [x, y, u, v] in others {
        positions.push([x, y].map(|&(p, q)| rational(p, q)).to_vec());
        velocities.push([u, v].map(|&(p, q)| rational(p, q)).to_vec());
    }
    Start { positions, velocities, weights: Weights::Lazy, hysteresis: Hysteresis::None }
}

#[test]
fn alternating_birds_and_others_far_away() {
    let plane = [
        alternating_in_the_plane(&[[(10, 1), (3, 1), (1, 7), (0, 1)]]),
        alternating_in_the_plane(&[
            [(10, 1), (3, 1), (1, 7), (0, 1)],
            [(20, 1), (5, 1), (1, 5), (0, 1)],
            [(41, 2), (5, 1), (1, 5), (1, 16)],
        ]),
    ];
    let fifth = |speed: i64| {
        let x = [(0, 16), (8, 16), (21, 16), (29, 16), (160, 16)].map(|(p, q)| rational(p, q)).to_vec();
        let mut v = [1, -1, 1, -1].map(|p| rational(p, 8)).to_vec();
        v.push(rational(speed, 1_000_000_000_000));
        Start::on_the_line(x, v, Weights::Lazy, Hysteresis::None)
    };
    for start in plane.iter().chain([&fifth(1)]) {
        let (switches, settled) = all_switches(start, &Limits::default());
        assert!(matches!(settled.ending, Ending::Alternating { period: 2 }), "{}", settled.why);
        assert!(switches.iter().enumerate().all(|(k, s)| s.time == (k as u32 + 1).into()));
    }
    // Coming back at that speed it will meet the others, at a time that is not waited for.
    let (_, settled) = all_switches(&fifth(-1), &Limits::default());
    assert!(matches!(settled.ending, Ending::Undecided(_)));
    assert!(settled.why.contains("birds 4 and 5 approach") && settled.why.contains("400000"), "{}", settled.why);
}

/// Four birds that alternate, and a fifth at distance 10 that comes back at speed `1/q`.
fn coming_back(q: i64) -> Start {
    let x = [(0, 16), (8, 16), (21, 16), (29, 16), (160, 16)].map(|(p, q)| rational(p, q)).to_vec();
    let mut v = [1, -1, 1, -1].map(|p| rational(p, 8)).to_vec();
    v.push(rational(-1, q));
    Start::on_the_line(x, v, Weights::Lazy, Hysteresis::None)
}

/// The cycle is gone round as long as the fifth cannot be there, and what follows is what stepping finds.
#[test]
fn a_bird_that_comes_back_ends_a_cycle_when_it_arrives() {
    for q in [20, 61, 100] {
        let (switches, settled) = all_switches(&coming_back(q), &Limits { switches: 2000, ..Limits::default() });
        let mut flock = Flock::new(&coming_back(q)).unwrap();
        let until = switches[switches.len() - 1].time.clone().min((8 * q + 100).into());
        let mut stepped = Vec::new();
        while *flock.time() < until {
            stepped.extend(flock.step().unwrap());
        }
        let jumped: Vec<Switch> = switches.into_iter().filter(|s| s.time <= until).collect();
        assert!(jumped == stepped, "{q}: {} {}", jumped.len(), stepped.len());
        assert!(jumped.iter().any(|s| s.gained.contains(&(3, 4))), "{q}: {}", settled.why);
    }
    // By hand: the third and fourth bird end with 29/16 as the largest limit, so the contact comes after about (10 - 29/16 - 1) q steps.
    let (switches, _) = all_switches(&coming_back(3000), &Limits::default());
    let contact = switches.iter().find(|s| s.gained.contains(&(3, 4))).expect("a contact");
    let steps = contact.time.to_string().parse::<f64>().unwrap() / 3000.0;
    assert!((7.0..7.4).contains(&steps), "{steps}");
}

/// A contact after more switches than are allowed: so many are reported, and the limit is named.
#[test]
fn a_cycle_is_left_at_the_limit_of_switches() {
    let (switches, settled) = all_switches(&coming_back(30_000), &Limits { switches: 20_000, ..Limits::default() });
    assert_eq!(settled.why, "stopped after 20000 switches");
    assert!(matches!(settled.ending, Ending::Undecided(_)));
    assert_eq!((switches.len(), &settled.last_switch), (20_000, &20_000.into()));
    assert!(switches.iter().enumerate().all(|(k, s)| s.time == (k as u32 + 1).into()));
    // The edge of the second and third bird is there at even times.
    assert_eq!(settled.network.edges(), [(0, 1), (1, 2), (2, 3)]);
}

/// Contacts just before, at and just after the step at which exact numbers are taken, and from which a jump may start.
#[test]
fn lone_birds_meet_when_they_must() {
    let speed = rational(1, 8);
    for t in 47..52 {
        for beyond in [rational(0, 1), rational(7, 8)] {
            let far = rational(1, 1) + &speed * (rational(t, 1) - beyond);
            let (x, v) = (vec![rational(0, 1), far], vec![rational(0, 1), -speed.clone()]);
            let start = Start::on_the_line(x, v, Weights::Lazy, Hysteresis::None);
            for (steps, jump_bits) in [(0, 0), (0, 1 << 22), (1, 0), (5, 1 << 22), (400, 0)] {
                let (switches, _) = all_switches(&start, &Limits { steps, jump_bits, ..Limits::default() });
                assert_eq!(switches[0].time, t.into(), "{steps} {jump_bits}");
            }
        }
    }
}

#[test]
fn lone_birds_leave_nothing_out() {
    // The first two meet after so many steps, in passing; nothing has a transient before.
    let far = Rational::from_integer(num_traits::Pow::pow(BigInt::from(10), 60u32));
    let row = |x: Rational, y: i64| vec![x, rational(y, 1)];
    let start = Start {
        positions: vec![row(rational(0, 1), 0), row(far.clone(), 0), row(rational(-5, 1), 7)],
        velocities: vec![row(rational(0, 1), 0), row(rational(-1, 1), 0), row(rational(-1, 1), 0)],
        weights: Weights::Lazy,
        hysteresis: Hysteresis::None,
    };
    let (switches, settled) = all_switches(&start, &Limits::default());
    assert!(matches!(settled.ending, Ending::Steady), "{}", settled.why);
    assert_eq!(switches[0].time, (far - rational(1, 1)).to_integer());
    assert_eq!(switches[0].gained, [(0, 1)]);
}

/// Pairs whose members swing, which come together after more than a million steps: by balls in milliseconds, and the same by exact jumps.
#[test]
fn a_jump_over_a_million_steps() {
    let x = [(0, 1), (1, 2), (1_400_000, 1), (2_800_001, 2)].map(|(p, q)| rational(p, q)).to_vec();
    let v = [(1, 8), (-1, 8), (-15, 16), (-17, 16)].map(|(p, q)| rational(p, q)).to_vec();
    let start = Start::on_the_line(x, v, Weights::Lazy, Hysteresis::None);
    let (switches, settled) = all_switches(&start, &Limits::default());
    assert!(matches!(settled.ending, Ending::Steady), "{}", settled.why);
    let (limit, _) = all_switches(&start, &Limits { jump_bits: 0, steps: 100, ..Limits::default() });
    assert_eq!(switches, limit);
    assert!(switches[0].time > 1_399_990.into() && switches[0].time < 1_400_010.into());
}

/// Mirror images of two groups whose drifts cancel but for what is left of their inner motion, in the order in which they part: the
/// drift, of the order of 3^-s with s of 85 digits, is said.
#[test]
fn a_hidden_drift_is_named() {
    let patterns: [[(i64, i64); 4]; 4] = [
        [(-1, 8), (9, 8), (-1, 8), (-7, 8)],
        [(1, 1), (0, 1), (-1, 1), (0, 1)],
        [(0, 1), (1, 1), (0, 1), (-1, 1)],
        [(7, 8), (1, 8), (-9, 8), (1, 8)],
    ];
    let x: Vec<Rational> = (0..8).flat_map(|l| [rational(2 * l, 1), rational(6 * l + 2, 3)]).collect();
    let v = patterns.concat().into_iter().map(|(p, q)| rational(p, 512 * q)).collect();
    let (_, settled) = all_switches(&Start::on_the_line(x, v, Weights::Lazy, Hysteresis::None), &Limits::default());
    assert!(matches!(settled.ending, Ending::Steady), "{}", settled.why);
    let said = "; 64 pairs of which the relative drift is too small to be written as a number move apart";
    assert!(settled.why.ends_with(said), "{}", settled.why);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Crowds of the plane: the switches are those of stepping, and what is called steady does not change.
    #[test]
    fn crowds_settle_as_they_step(
        rows in prop::collection::vec(prop::collection::vec(0i64..4096, 2), 20..40),
        speeds in prop::collection::vec(prop::collection::vec(-64i64..64, 2), 40),
    ) {
        let numbers = |rows: &[Vec<i64>]| rows.iter().map(|r| r.iter().map(|&p| rational(p, 1024)).collect()).collect();
        let (weights, hysteresis) = (Weights::Vicsek, Hysteresis::Paper);
        let velocities = numbers(&speeds[..rows.len()]);
        let start = Start { positions: numbers(&rows), velocities, weights, hysteresis };
        let (jumped, settled) = all_switches(&start, &Limits::default());
        prop_assert!(matches!(settled.ending, Ending::Steady), "{}", settled.why);
        let mut flock = models::averaging::FilteredFlock::new(&start).unwrap();
        let stepped: Vec<Switch> = (0..4000).filter_map(|_| flock.step(&Unwatched).unwrap()).collect();
        let jumped: Vec<Switch> = jumped.into_iter().filter(|s| s.time <= 4000.into()).collect();
        prop_assert_eq!(jumped, stepped);
    }
}

/// A flock in the plane from decimals.
fn planar(positions: &[[&str; 2]], velocities: &[[&str; 2]]) -> Start {
    let read = |rows: &[[&str; 2]]| {
        rows.iter().map(|row| row.iter().map(|x| arithmetic::parse_rational(x).unwrap()).collect()).collect()
    };
    Start {
        positions: read(positions),
        velocities: read(velocities),
        weights: Weights::Lazy,
        hysteresis: Hysteresis::None,
    }
}

/// Two birds that meet after more than 2^64 steps meet all the same: beside birds that settle at once, which are left behind, and among
/// pairs that a tree of boxes tells apart.
#[test]
fn what_comes_very_late_comes() {
    let behind = planar(
        &[
            ["0", "0"],
            ["100", "0"],
            ["0", "1000"],
            ["0", "49849/50"],
            ["0", "2000"],
            ["0", "2010"],
            ["0", "2020"],
            ["0", "2030"],
        ],
        &[
            ["0", "0"],
            ["-1/1000000000000000000", "0"],
            ["0", "1/10"],
            ["0", "11/100"],
            ["0", "1"],
            ["0", "11/10"],
            ["0", "12/10"],
            ["0", "13/10"],
        ],
    );
    let mut apart = planar(&[["0", "0"], ["1000", "0"]], &[["0", "0"], ["-1/1000000000000000000000", "0"]]);
    for k in 1..=4 {
        for side in [-1, 1] {
            apart.positions.push(vec![rational(if side < 0 { 0 } else { 1000 }, 1), rational(10 * side * k, 1)]);
            apart.velocities.push(vec![rational(0, 1), rational(side * (9 + k), 10_000_000_000_000)]);
        }
    }
    let late = BigInt::from(10).pow(18);
    for (start, most) in [(behind, 3), (apart, 1)] {
        let (switches, settled) = all_switches(&start, &Limits::default());
        let last = switches.last().map(|switch| switch.time.clone()).unwrap_or_default();
        assert!(
            !matches!(settled.ending, Ending::Steady) || (switches.len() >= most && last > late),
            "steady after {} switches, the last at {last}",
            switches.len()
        );
    }
}
