//! What counts as being at the distance `R`, and what is preferred there: both sides of each bound, from its formula.

use arithmetic::{Rational, Unwatched, rational};
use models::double_integrator::{
    Alignment, Branch, Coordinates, EventKind, Flock, Motion, Network, Options, Potential, Prefer, State, Way, fork,
};

const PLANE: Coordinates = Coordinates::Cartesian;
const EPS: f64 = f64::EPSILON;

fn spring() -> Potential {
    Potential::inverse_square_spring(&rational(1, 1), &rational(1, 1))
}

/// With R = 2.
fn flock(potential: Potential, agents: &[([f64; 2], [f64; 2])]) -> Flock {
    let start =
        State { positions: agents.iter().map(|a| a.0).collect(), velocities: agents.iter().map(|a| a.1).collect() };
    Flock::new(Alignment::Velocity, potential, Network::Within(2.0), start).unwrap()
}

fn at_once(flock: &Flock, options: &Options) -> Motion {
    flock.run(0.0, &[], options, &Unwatched).unwrap()
}

/// Position and velocity of an agent, in whole numbers and in floats.
type Whole = ((i64, i64), (i64, i64));
type Floating = ([f64; 2], [f64; 2]);

/// Numbers in quarters, so that floats are exact.
fn quarters(agents: &[Whole]) -> (State<Rational>, Vec<Floating>) {
    let exact = |(x, y): (i64, i64)| [rational(x, 4), rational(y, 4)];
    let float = |(x, y): (i64, i64)| [x as f64 / 4.0, y as f64 / 4.0];
    let state = State {
        positions: agents.iter().map(|a| exact(a.0)).collect(),
        velocities: agents.iter().map(|a| exact(a.1)).collect(),
    };
    (state, agents.iter().map(|a| (float(a.0), float(a.1))).collect())
}

fn float(q: &Rational) -> f64 {
    num_traits::ToPrimitive::to_f64(q).unwrap()
}

/// Starts that are exactly at `R`: the ways on are those of the exact fork, with other links in force, and each of them is followed by
/// its number.
#[test]
fn exact_starts_have_the_ways_of_the_exact_fork() {
    let mut choices = 0;
    for agents in [
        &[((0, 0), (0, 4)), ((8, 0), (0, 0))][..],
        &[((0, 0), (0, 0)), ((8, 0), (0, 0))],
        &[((0, 0), (0, 0)), ((8, 0), (0, 0)), ((14, 0), (0, 0))],
        &[((0, 0), (0, 3)), ((8, 0), (0, 0)), ((8, 5), (1, 0)), ((40, 0), (0, 0)), ((44, 0), (1, 1))],
        &[((-8, 0), (0, 0)), ((0, 0), (0, 4)), ((8, 0), (0, 0))],
        &[((0, 0), (1, 4)), ((8, 0), (0, 0)), ((0, 8), (0, 0))],
    ] {
        let (exact, floats) = quarters(agents);
        let found = fork(&exact, &rational(4, 1), PLANE, &spring()).unwrap();
        let known: Vec<Branch<f64>> = found.branches.iter().map(|branch| branch.map(float)).collect();
        let flock = flock(spring(), &floats);
        let before = flock.links_at_start();
        for (taken, branch) in known.iter().enumerate() {
            let motion = at_once(&flock, &Options { first_branch: Some(taken), ..Options::default() });
            if known.len() > 1 {
                choices += 1;
                assert_eq!((motion.choices.len(), motion.choices[0].taken, motion.choices[0].time), (1, taken, 0.0));
                assert_eq!(motion.choices[0].branches, known, "{agents:?}");
            } else {
                assert!(motion.choices.is_empty());
            }
            // Who leaves was not linked and is not now: no event.
            let kinds: Vec<_> = motion.events.iter().map(|e| (e.pair, e.kind)).collect();
            let told = branch.ways.iter().filter_map(|(pair, way)| match way {
                Way::Leaves => None,
                Way::Enters => Some((*pair, EventKind::Link)),
                Way::Stays(_) => Some((*pair, EventKind::Stay)),
            });
            assert_eq!(kinds, told.collect::<Vec<_>>(), "{agents:?}");
            for event in &motion.events {
                let (i, j) = event.pair;
                let rate = 2.0 * PLANE.product(&flock.start().separation(i, j), &flock.start().relative_velocity(i, j));
                assert_eq!((event.time, event.rate), (0.0, rate));
            }
            let linked = branch.ways.iter().filter(|(_, way)| *way == Way::Enters).map(|(pair, _)| *pair);
            let mut links: Vec<_> = before.iter().copied().chain(linked).collect();
            links.sort_by_key(|&(i, j)| (j, i));
            let after = flock
                .run(0.0, &[0.0], &Options { first_branch: Some(taken), ..Options::default() }, &Unwatched)
                .unwrap();
            assert_eq!(after.samples[0].links, links);
        }
    }
    assert!(choices > 12);
}

/// The sum over the pairs of 0 for what is wanted, 1 for a side that is kept, 2 for staying, 3 for the rest; of equals what is decided, then
/// the first.
#[test]
fn the_way_that_is_preferred_is_followed() {
    let across: &[Whole] = &[((0, 0), (0, 4)), ((8, 0), (0, 0))];
    let at_rest: &[Whole] = &[((0, 0), (0, 0)), ((8, 0), (0, 0))];
    let both: Vec<_> = across.iter().copied().chain(at_rest.iter().map(|a| ((a.0.0 + 400, a.0.1), a.1))).collect();
    let way = |agents: &[Whole], prefer: Prefer| -> Vec<&'static str> {
        let motion = at_once(&flock(spring(), &quarters(agents).1), &Options { prefer, ..Options::default() });
        let choice = &motion.choices[0];
        let name = |way: &Way<f64>| match way {
            Way::Leaves => "leaves",
            Way::Enters => "enters",
            Way::Stays(_) => "stays",
        };
        choice.branches[choice.taken].ways.iter().map(|(_, way)| name(way)).collect()
    };
    // Of a pair at rest there is no leaving.
    for (prefer, first, second) in [
        (Prefer::Keep, "leaves", "stays"),
        (Prefer::Leave, "leaves", "stays"),
        (Prefer::Enter, "enters", "enters"),
        (Prefer::Stay, "stays", "stays"),
    ] {
        assert_eq!(way(across, prefer), [first]);
        assert_eq!(way(at_rest, prefer), [second]);
        assert_eq!(way(&both, prefer), [first, second]);
    }
}

/// `| |r|² - R² | <= 4 · 16 eps R (x_i + x_j + R)` at the start, with the largest coordinates of both: on a line `4 |d - 2|`.
#[test]
fn ties_are_those_within_rounding() {
    for (at, bound) in [(0.0, 4.0 * 16.0 * EPS * 2.0 * 4.0), (30.0, 4.0 * 16.0 * EPS * 2.0 * 64.0)] {
        for side in [-1.0, 1.0] {
            let is_tie = |share: f64| {
                let place = at + 2.0 + side * share * bound / 4.0;
                let pair = [([at, 0.0], [0.0, 0.0]), ([place, 0.0], [0.0, 0.0])];
                !at_once(&flock(spring(), &pair), &Options::default()).choices.is_empty()
            };
            assert!(is_tie(0.9) && !is_tie(1.1), "{at} {side}");
            let upright = |share: f64| {
                let place = at + 2.0 + side * share * bound / 4.0;
                let pair = [([0.0, at], [0.0, 0.0]), ([0.0, place], [0.0, 0.0])];
                !at_once(&flock(spring(), &pair), &Options::default()).choices.is_empty()
            };
            assert!(upright(0.9) && !upright(1.1), "{at} {side}");
        }
    }
}

/// `rate² <= 2 bend least` with `bend = 2 (|v|² + R (|a_i| + |a_j|)) + 8 R² |V'|`, where `least` is four times the rounding.
#[test]
fn pairs_graze_whose_turn_would_not_show() {
    // (6/5, 8/5) is no float: a tie by rounding only. Velocities along it, and across.
    let pair = |along: f64, across: f64| {
        let v = [0.6 * along - 0.8 * across, 0.8 * along + 0.6 * across];
        [([0.0, 0.0], [0.0, 0.0]), ([1.2, 1.6], v)]
    };
    let rounding = 16.0 * EPS * 2.0 * (1.6 + 2.0);
    let slope = 15.0 / 16.0;
    for across in [0.0f64, 1.0, 3.0] {
        // Nobody is linked: no accelerations.
        let bend = 2.0 * across * across + 8.0 * 4.0 * slope;
        let bound = (2.0 * bend * 4.0 * rounding).sqrt() / 4.0;
        let of = |along: f64| at_once(&flock(spring(), &pair(along, across)), &Options::default());
        for side in [-1.0, 1.0] {
            assert_eq!(of(side * 0.97 * bound).choices.len(), 1, "{across} {side}");
            let beyond = of(side * 1.03 * bound);
            assert!(beyond.choices.is_empty() && beyond.events.len() == usize::from(side < 0.0), "{across} {side}");
        }
    }
    // A third agent pulls both: 2 V' r at distance 3/2 from the first, and more from the second.
    let third = |along: f64| {
        let [one, two] = pair(along, 0.0);
        [one, two, ([0.0, 1.5], [0.0, 0.0])]
    };
    let (near, far) = (2.25f64, 1.44 + 0.01);
    let pull = |s: f64| 2.0 * (1.0 - 1.0 / (s * s)) * s.sqrt();
    // The velocity, far smaller, does not count.
    let bend = 2.0 * 2.0 * (pull(near) + pull(far)) + 8.0 * 4.0 * slope;
    let bound = (2.0 * bend * 4.0 * rounding).sqrt() / 4.0;
    let grazes = |along: f64| {
        let motion = at_once(&flock(spring(), &third(along)), &Options::default());
        // What the third agent pulls together enters; a pair that leaves does so only where it does not graze.
        motion.events.iter().any(|e| e.pair == (0, 1) && e.kind == EventKind::Link) || !motion.choices.is_empty()
    };
    assert!(grazes(0.98 * bound) && !grazes(1.02 * bound));
}

/// At a start that is a tie by rounding the signs of what vanishes are open: a pair that moves along together may part, come near or stay,
/// and only coming near is certain.
#[test]
fn open_signs_leave_ways_undecided() {
    let along = [([0.0, 0.0], [0.3, 0.1]), ([1.2, 1.6], [0.3, 0.1])];
    let motion = at_once(&flock(spring(), &along), &Options::default());
    let branches = &motion.choices[0].branches;
    assert_eq!(branches.len(), 3);
    for (branch, (leaves, decided)) in branches.iter().zip([(true, false), (false, true), (false, false)]) {
        assert_eq!((branch.ways[0].1 == Way::Leaves, branch.decided), (leaves, decided), "{branches:?}");
    }
    assert!(matches!(branches[2].ways[0].1, Way::Stays(weight) if weight.abs() < 1e-12));
    // At rest nothing is open: an equilibrium stays one, or the pair is linked and falls together.
    let rest = [([0.0, 0.0], [0.0, 0.0]), ([1.2, 1.6], [0.0, 0.0])];
    let motion = at_once(&flock(spring(), &rest), &Options::default());
    assert!(motion.choices[0].branches.len() == 2 && motion.choices[0].branches.iter().all(|b| b.decided));
    // Across, all three are certain, with the weight 2/30.
    let across = [([0.0, 0.0], [0.0, 0.0]), ([1.2, 1.6], [-0.8, 0.6])];
    let motion = at_once(&flock(spring(), &across), &Options::default());
    let branches = &motion.choices[0].branches;
    assert!(branches.len() == 3 && branches.iter().all(|branch| branch.decided));
    assert!(matches!(branches[2].ways[0].1, Way::Stays(weight) if (weight - 1.0 / 15.0).abs() < 1e-12));
    // One exact tie and one by rounding.
    let mixed = [rest[0], rest[1], ([100.0, 0.0], [0.0, 0.0]), ([102.0, 0.0], [0.0, 0.0])];
    let motion = at_once(&flock(spring(), &mixed), &Options::default());
    assert_eq!(motion.choices[0].branches.len(), 4);
}

/// Free flight into the threshold at `t = 3`, with the rate `-4`: the jump of the energy may be as large as rounding before and after, and
/// `2 V'(R²)` times what `|r|² - R²` may be off.
#[test]
fn the_jump_that_is_allowed_is_that_of_rounding() {
    let motion = flock(spring(), &[([5.0, 0.0], [-1.0, 0.0]), ([0.0, 0.0], [0.0, 0.0])]).run(
        3.0001,
        &[],
        &Options::default(),
        &Unwatched,
    );
    let motion = motion.unwrap();
    assert_eq!(motion.events.iter().map(|e| e.kind).collect::<Vec<_>>(), [EventKind::Link]);
    let energy = 0.5 + 2.25;
    let rounding = 16.0 * EPS * 2.0 * (2.0 + 0.0 + 2.0);
    let slack = 4.0 * (rounding + 4.0 * EPS * 3.0);
    let allowed = (18.0 + 19.0) * EPS * energy + 15.0 / 16.0 * 2.0 * slack;
    assert!((motion.energy.jump.allowed / allowed - 1.0).abs() < 1e-9, "{:?} {allowed}", motion.energy.jump);
    assert!((motion.energy.jump.time - 3.0).abs() < 1e-14);
    // After a stay, the drift that the integrator's tolerance allows comes to it: 1000 R (absolute + relative R).
    let pair = [([0.0, 0.0], [0.0, 1.0]), ([2.0, 0.0], [0.0, 0.0])];
    let options = Options { prefer: Prefer::Stay, ..Options::default() };
    let stay = flock(spring(), &pair).run(1.0, &[], &options, &Unwatched).unwrap();
    assert!(stay.energy.jump.time == 0.0 && stay.energy.jump.allowed < 1e-11, "{:?}", stay.energy.jump);
    assert!(stay.energy.is_monotone());
}
