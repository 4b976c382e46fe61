//! Pairs at distance exactly `R`: the ways on, exactly and followed.

use arithmetic::{Rational, Unwatched, rational};
use models::double_integrator::{
    Alignment, Branch, Coordinates, EventKind, Flock, Fork, ForkError, MotionError, Network, Options, Potential,
    Prefer, State, Way, fork,
};

const PLANE: Coordinates = Coordinates::Cartesian;

type Agents<'a> = &'a [((i64, i64), (i64, i64))];

fn spring() -> Potential {
    Potential::inverse_square_spring(&rational(1, 1), &rational(1, 1))
}

/// Numbers are halves.
fn state(agents: Agents) -> State<Rational> {
    let vector = |(x, y): (i64, i64)| [rational(x, 2), rational(y, 2)];
    State {
        positions: agents.iter().map(|a| vector(a.0)).collect(),
        velocities: agents.iter().map(|a| vector(a.1)).collect(),
    }
}

/// With R = 2.
fn ways(agents: Agents) -> Fork<Rational> {
    fork(&state(agents), &rational(4, 1), PLANE, &spring()).unwrap()
}

fn flock(agents: Agents) -> Flock {
    let start = state(agents)
        .map(|x| x.numer().to_string().parse::<f64>().unwrap() / x.denom().to_string().parse::<f64>().unwrap());
    Flock::new(Alignment::Velocity, spring(), Network::Within(2.0), start).unwrap()
}

fn prefer(prefer: Prefer) -> Options {
    Options { prefer, ..Options::default() }
}

const AT_REST: Agents = &[((0, 0), (0, 0)), ((4, 0), (0, 0))];
const ACROSS: Agents = &[((0, 0), (0, 2)), ((4, 0), (0, 0))];

#[test]
fn two_agents_at_rest_stay_or_fall_together() {
    let found = ways(AT_REST);
    let decided = |way| Branch { ways: vec![((0, 1), way)], decided: true };
    assert_eq!(found.branches, [decided(Way::Enters), decided(Way::Stays(rational(0, 1)))]);
    assert_eq!(found.grazing, [(0, 1)]);
    let rest = flock(AT_REST).run(5.0, &[5.0], &Options::default(), &Unwatched).unwrap();
    assert_eq!(&rest.samples[0].state, flock(AT_REST).start());
    assert_eq!((rest.choices.len(), rest.choices[0].taken), (1, 1));
    let fall = flock(AT_REST).run(5.0, &[5.0], &prefer(Prefer::Enter), &Unwatched).unwrap();
    assert_eq!(fall.events[0].kind, EventKind::Link);
    assert!((PLANE.square(&fall.samples[0].state.separation(0, 1)) - 1.0).abs() < 0.2);
    assert!(fall.energy.is_monotone());
}

/// d²s/dt² is 2 without the link and 30 less with it; a weight 1/15 keeps the distance.
#[test]
fn two_agents_moving_across_can_do_three_things() {
    let decided = |way| Branch { ways: vec![((0, 1), way)], decided: true };
    let expected = [Way::Leaves, Way::Enters, Way::Stays(rational(1, 15))].map(decided);
    assert_eq!(ways(ACROSS).branches, expected);
    let times = [1.0, 10.0, 100.0];
    // Leaving: free flight.
    let away = flock(ACROSS).run(100.0, &times, &prefer(Prefer::Leave), &Unwatched).unwrap();
    for sample in &away.samples {
        assert!((PLANE.square(&sample.state.separation(0, 1)) - 4.0 - sample.time * sample.time).abs() < 1e-8);
    }
    // Entering: the distance falls at once.
    let in_ = flock(ACROSS).run(0.1, &[0.1], &prefer(Prefer::Enter), &Unwatched).unwrap();
    let s = PLANE.square(&in_.samples[0].state.separation(0, 1));
    assert!((s - (4.0 - 14.0 * 0.01)).abs() < 0.01, "{s}");
    // Staying: the relative speed u obeys u' = -2m u with the weight m = 2u²/30, so u = 1/sqrt(1 + 8t/30).
    let stay = flock(ACROSS).run(100.0, &times, &prefer(Prefer::Stay), &Unwatched).unwrap();
    for sample in &stay.samples {
        let (r, v) = (sample.state.separation(0, 1), sample.state.relative_velocity(0, 1));
        let speed = 1.0 / (1.0 + 8.0 * sample.time / 30.0).sqrt();
        assert!((PLANE.square(&r) - 4.0).abs() < 1e-7 && (PLANE.square(&v).sqrt() - speed).abs() < 1e-7);
    }
    assert_eq!((stay.events.len(), stay.events[0].kind), (1, EventKind::Stay));
    assert!(stay.energy.is_monotone(), "{:?}", stay.energy);
    // By number.
    let first = |k| Options { first_branch: Some(k), ..Options::default() };
    assert_eq!(flock(ACROSS).run(100.0, &times, &first(2), &Unwatched).unwrap(), stay);
    let refused = flock(ACROSS).run(1.0, &[], &first(3), &Unwatched);
    assert_eq!(refused, Err(MotionError::NoSuchBranch { index: 3, count: 3 }));
}

#[test]
fn pairs_that_move_radially_have_one_way_on() {
    let only = |agents| {
        let fork = ways(agents);
        assert_eq!((fork.branches.len(), fork.grazing.len()), (1, 0));
        fork.branches[0].ways.clone()
    };
    assert_eq!(only(&[((0, 0), (1, 3)), ((4, 0), (0, 0))]), [((0, 1), Way::Enters)]);
    assert_eq!(only(&[((0, 0), (-1, 3)), ((4, 0), (0, 0))]), [((0, 1), Way::Leaves)]);
    assert_eq!(only(&[((0, 0), (0, 0)), ((3, 0), (0, 0))]), []);
    // Strong attraction of a third agent decides a grazing pair.
    let pulled = ways(&[((-2, 0), (0, 0)), ((2, 0), (0, 0)), ((0, 2), (0, 0))]);
    assert_eq!(pulled.branches, [Branch { ways: vec![((0, 1), Way::Enters)], decided: true }]);
    // Fast enough, it leaves either way: 2 |v|² > 30.
    let fast = ways(&[((0, 0), (0, 8)), ((4, 0), (0, 0))]);
    assert_eq!(fast.branches, [Branch { ways: vec![((0, 1), Way::Leaves)], decided: true }]);
}

/// At equality the third derivative decides: 2 |v|² = 30 - a with the alignment that slows the pair down.
#[test]
fn equality_is_decided_by_the_third_derivative() {
    // V'(R²) = 1/16 gives 8 V'(R²) R² = 2 = 2 |v|² for |v| = 1: with the link d²s/dt² = 0, and then it falls, since v shrinks.
    let potential = Potential::inverse_square_spring(&rational(1, 1), &rational(1, 15));
    let found = fork(&state(ACROSS), &rational(4, 1), PLANE, &potential).unwrap();
    let ways: Vec<_> = found.branches.iter().map(|b| (b.ways[0].1.clone(), b.decided)).collect();
    assert_eq!(ways, [(Way::Leaves, true), (Way::Enters, true), (Way::Stays(rational(1, 1)), true)]);
}

#[test]
fn two_ties_multiply() {
    // Two pairs far from each other, and a path of three with both links at R.
    let far = ways(&[((0, 0), (0, 2)), ((4, 0), (0, 0)), ((100, 0), (0, 0)), ((104, 0), (0, 0))]);
    assert_eq!(far.branches.len(), 6);
    assert!(far.branches.iter().all(|b| b.decided && b.ways.len() == 2));
    let path = ways(&[((-4, 0), (0, 0)), ((0, 0), (0, 2)), ((4, 0), (0, 0))]);
    assert_eq!(path.grazing, [(0, 1), (1, 2)]);
    // By symmetry the middle agent keeps the line if both do the same.
    let both: Vec<_> = path.branches.iter().filter(|b| b.ways[0].1 == b.ways[1].1).collect();
    assert_eq!(both.len(), 3);
    let ring: Vec<_> =
        (0..8).map(|k| ((200 * k, 0), (0, 0))).flat_map(|(r, v)| [(r, v), ((r.0 + 4, 0), (0, 0))]).collect();
    assert_eq!(fork(&state(&ring), &rational(4, 1), PLANE, &spring()), Err(ForkError::TooMany(8)));
}

/// A third agent first holds the second one back and then pushes it: staying ends by itself.
#[test]
fn staying_ends_where_no_weight_does() {
    let agents: Agents = &[((0, 0), (0, 0)), ((4, 0), (0, 0)), ((7, 0), (0, 0))];
    let found = ways(agents);
    assert_eq!(found.branches.len(), 3);
    let motion = flock(agents).run(2.0, &[0.1, 2.0], &prefer(Prefer::Stay), &Unwatched).unwrap();
    assert_eq!(motion.events[0].kind, EventKind::Stay);
    assert!((PLANE.square(&motion.samples[0].state.separation(0, 1)) - 4.0).abs() < 1e-9);
    let next = motion.events.iter().find(|e| e.pair == (0, 1) && e.kind != EventKind::Stay).unwrap();
    assert_eq!(next.kind, EventKind::Link);
    assert!(next.time > 0.1 && motion.energy.is_monotone(), "{:?}", motion.energy);
}

/// With R below the desired distance links push apart: the threshold attracts, and staying is the only way on.
#[test]
fn where_links_push_apart_pairs_stay_at_the_threshold() {
    let wide = Potential::inverse_square_spring(&rational(9, 1), &rational(1, 1));
    let flock = |speed: f64| {
        let start = State {
            positions: vec![[0.0, 0.0], [2.0, 0.0], [3.95, 0.0]],
            velocities: vec![[0.0, 0.0], [-speed, 0.0], [0.0, 0.0]],
        };
        Flock::new(Alignment::Velocity, wide.clone(), Network::Within(2.0), start).unwrap()
    };
    let exact = State {
        positions: [(0, 1), (2, 1), (79, 20)].map(|(p, q)| [rational(p, q), rational(0, 1)]).to_vec(),
        velocities: vec![[rational(0, 1), rational(0, 1)]; 3],
    };
    let found = fork(&exact, &rational(4, 1), PLANE, &wide).unwrap();
    assert_eq!(found.branches.len(), 1);
    assert!(found.branches[0].decided && matches!(found.branches[0].ways[0].1, Way::Stays(_)));
    let still = flock(0.0).run(3.0, &[0.01], &Options::default(), &Unwatched).unwrap();
    assert!(still.events[0].kind == EventKind::Stay && still.choices.iter().all(|c| c.time > 0.0));
    assert!((PLANE.square(&still.samples[0].state.separation(0, 1)) - 4.0).abs() < 1e-12);
    // Near it the pair switches ever faster until it stays.
    let moving = flock(0.05).run(3.0, &[], &Options::default(), &Unwatched).unwrap();
    assert!(moving.events.len() < 10_000 && moving.energy.is_monotone(), "{} {:?}", moving.events.len(), moving.energy);
}

/// Six pairs at rest far from each other, as many as are gone through, have two ways on each; in triangular coordinates too.
#[test]
fn as_many_pairs_are_gone_through_as_is_said() {
    let pairs = |count: i64| -> Vec<_> {
        (0..count).flat_map(|k| [((200 * k, 0), (0, 0)), ((200 * k + 4, 0), (0, 0))]).collect()
    };
    let found = fork(&state(&pairs(6)), &rational(4, 1), PLANE, &spring()).unwrap();
    assert_eq!((found.branches.len(), found.grazing.len()), (64, 6));
    assert!(found.branches.iter().all(|b| b.decided && b.ways.len() == 6));
    let refused = fork(&state(&pairs(7)), &rational(4, 1), PLANE, &spring());
    assert_eq!(refused, Err(ForkError::TooMany(7)));
    let oblique = fork(&state(AT_REST), &rational(4, 1), Coordinates::Triangular, &spring()).unwrap();
    assert_eq!(oblique, ways(AT_REST));
}

/// Without a slope at `R` no weight matters: a pair at rest stays an equilibrium, and one that moves across leaves, however it is linked.
#[test]
fn weights_that_do_not_matter_are_none() {
    let flat = Potential::new(vec![(1, rational(1, 1)), (0, rational(-4, 1))], (rational(1, 1), rational(5, 1)));
    let of = |agents: Agents| fork(&state(agents), &rational(4, 1), PLANE, &flat).unwrap().branches;
    assert_eq!(of(AT_REST), [Branch { ways: vec![((0, 1), Way::Stays(rational(0, 1)))], decided: true }]);
    assert_eq!(of(ACROSS), [Branch { ways: vec![((0, 1), Way::Leaves)], decided: true }]);
}

/// A pair that comes near while another one grazes is linked for it: it pulls agent 0 by `1 - 15/4`, so that `d²s/dt²` of the grazing pair is
/// `2 (-2) (-11/4) = 11` without its own link, and 30 less with it.
#[test]
fn pairs_that_enter_pull_at_those_that_graze() {
    let found = ways(&[((0, 0), (0, 0)), ((4, 0), (0, 0)), ((-4, 0), (2, 0))]);
    assert_eq!(found.grazing, [(0, 1)]);
    let ways: Vec<_> = found.branches.iter().map(|b| (b.ways.clone(), b.decided)).collect();
    let both = |way| (vec![((0, 2), Way::Enters), ((0, 1), way)], true);
    assert_eq!(ways, [Way::Leaves, Way::Enters, Way::Stays(rational(11, 30))].map(both));
    // Nothing to be decided is decided.
    for agents in [&[((0, 0), (1, 3)), ((4, 0), (0, 0))], &[((0, 0), (-1, 3)), ((4, 0), (0, 0))]] {
        assert!(self::ways(agents).branches[0].decided);
    }
}

/// One agent rests, alone. Another one at `R` from it has no velocity and no acceleration either, but is linked to a third that moves across: `a = -(v_j - v_k) - 2 V' r = 0`
/// with `r = (0, 1/2)`, `V'(1/4) = -15` and `v_j - v_k = (0, 15)`, while its jerk is `-2 V' v - 2 V'' (2 r.v) r = (0, 450 - 1920)`. So it moves across as well,
/// like `t³`, and leaves: what rests on one side only is no equilibrium, and the first three derivatives do not tell.
#[test]
fn one_side_at_rest_is_no_equilibrium() {
    let agents = [((0, 0), (0, 0)), ((4, 0), (0, 0)), ((4, -1), (0, -30))];
    for order in [[0, 1, 2], [1, 0, 2], [2, 1, 0]] {
        let found = ways(&order.map(|k| agents[k]));
        let kinds: Vec<_> = found.branches.iter().map(|b| (b.ways[0].1.clone(), b.decided)).collect();
        assert_eq!(
            kinds,
            [(Way::Leaves, false), (Way::Enters, true), (Way::Stays(rational(0, 1)), false)],
            "{order:?}"
        );
    }
    // The same by following it: without the link the distance grows like the square of the way across.
    let [start, later] = [0.0, 0.004].map(|time| {
        let motion = flock(&agents).run(time, &[time], &prefer(Prefer::Leave), &Unwatched).unwrap();
        PLANE.square(&motion.samples[0].state.separation(0, 1))
    });
    let across = 1470.0 * 0.004f64.powi(3) / 6.0;
    assert!(start == 4.0 && ((later - 4.0) / (across * across) - 1.0).abs() < 0.5, "{later} {across}");
}
