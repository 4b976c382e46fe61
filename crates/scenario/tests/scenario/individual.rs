//! Large flocks with individual steps against the same flock followed as a whole: of the large one all but a few agents are idle and far away.

use super::run;
use arithmetic::random::{generator, uniform};
use arithmetic::{Unwatched, rational};
use models::double_integrator::{Alignment, EventKind, Flock, Network, Options, Potential, State};
use scenario::{Event, Outcome};

/// With more agents each has steps of its own.
const MANY: usize = 257;

/// The agents that matter: places, and headings or phases.
struct Crowd {
    places: Vec<[f64; 2]>,
    angles: Vec<f64>,
    speeds: Vec<f64>,
}

impl Crowd {
    /// On a lattice, a little moved or not at all, with headings all around.
    fn on_a_lattice(count: usize, moved: f64, seed: u64) -> Self {
        let mut random = generator("individual", "crowd", seed);
        let mut even = |from: f64, to: f64| from + (to - from) * uniform(&mut random);
        let columns = (count as f64).sqrt().ceil() as usize;
        let place = |k: usize, x: f64, y: f64| [(k % columns) as f64 + x, (k / columns) as f64 + y];
        let places = (0..count).map(|k| place(k, even(-moved, moved), even(-moved, moved))).collect();
        let angles = (0..count).map(|_| even(-3.1, 3.1)).collect();
        let speeds = (0..count).map(|_| even(0.5, 1.0)).collect();
        Crowd { places, angles, speeds }
    }

    /// All go out from the middle, or all in, or as the places say: many come to the radius at once.
    fn symmetric(count: usize, angle: impl Fn([f64; 2]) -> f64) -> Self {
        let mut crowd = Crowd::on_a_lattice(count, 0.0, 0);
        let half = (count as f64).sqrt() / 2.0 - 0.5;
        crowd.places.iter_mut().for_each(|r| *r = [r[0] - half, r[1] - half]);
        crowd.angles = crowd.places.iter().map(|r| angle(*r)).collect();
        crowd.speeds = vec![1.0; count];
        crowd
    }

    /// So many others stand far from these and from each other.
    fn among(&self, others: usize) -> Self {
        // Not on a lattice, where the nearest would be at equal distances.
        let far = |k: usize| [30.0 + 12.0 * (k % 20) as f64 + (k as f64).sin(), -30.0 - 12.0 * (k / 20) as f64];
        Crowd {
            places: self.places.iter().copied().chain((0..others).map(far)).collect(),
            angles: self.angles.iter().copied().chain(vec![0.5; others]).collect(),
            speeds: self.speeds.iter().copied().chain(vec![0.25; others]).collect(),
        }
    }

    fn aligning(&self, law: &str, run: &str) -> String {
        let velocities: Vec<[f64; 2]> =
            self.angles.iter().zip(&self.speeds).map(|(a, s)| [s * a.cos(), s * a.sin()]).collect();
        format!(
            "model = \"heading-alignment\"\n[graph]\nkind = \"within\"\nradius = 2\n[state]\npositions = {:?}\nvelocities = {velocities:?}\n[law]\n{law}\n[run]\n{run}\n",
            self.places
        )
    }

    /// Gains that are divided by the number of particles are given for one.
    fn steered(&self, (orientation, spacing): (f64, f64), law: &str, run: &str) -> String {
        let count = self.places.len() as f64;
        format!(
            "model = \"particles\"\n[graph]\nkind = \"within\"\nradius = 2\n[state]\npositions = {:?}\nphases = {:?}\n[law]\nK1 = {:?}\nK0 = {:?}\n{law}\n[run]\n{run}\n",
            self.places,
            self.angles,
            orientation * count,
            spacing * count
        )
    }
}

/// Both ways: in the same steps, and one by one.
fn both(crowd: &Crowd, text: impl Fn(&Crowd) -> String) -> (Outcome, Outcome) {
    let outcomes = (run(&text(crowd)), run(&text(&crowd.among(MANY - crowd.places.len()))));
    let alone = |outcome: &Outcome| outcome.declaration.iter().any(|line| line.contains("individual steps"));
    assert!(!alone(&outcomes.0) && alone(&outcomes.1));
    outcomes
}

/// How far the first agents are apart at the end, and how many switches both have; simultaneous ones in any order.
fn compared((together, alone): &(Outcome, Outcome), count: usize, allowed: f64, what: &str) -> usize {
    let same = |event: &Event| (event.pair, event.gained);
    let sorted = |outcome: &Outcome| {
        // Of links that come at the very start only some are told.
        let later = outcome.events.iter().filter(|event| event.time > 0.0 && event.pair.0 <= count);
        let mut events: Vec<_> = later.map(|event| (same(event), event.time)).collect();
        events.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        events
    };
    let (those, these) = (sorted(together), sorted(alone));
    let kinds =
        |events: &[((_, bool), f64)]| events.iter().map(|(kind, _)| *kind).collect::<Vec<((usize, usize), bool)>>();
    assert_eq!(kinds(&those), kinds(&these), "{what}");
    let late = those.iter().zip(&these).map(|(a, b)| (a.1 - b.1).abs()).fold(0.0, f64::max);
    assert!(late < allowed, "{what}: {late}");
    let last = |outcome: &Outcome| {
        let frame = &outcome.rows.last().expect("a row").frame;
        let of = |vectors: &[Vec<f64>]| vectors.iter().take(count).flatten().copied().collect::<Vec<f64>>();
        [of(&frame.positions), of(&frame.velocities), frame.phases.iter().take(count).copied().collect()].concat()
    };
    let far = last(together).iter().zip(last(alone)).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
    assert!(far < allowed, "{what}: {far}");
    these.len()
}

/// Three agents in a row of which links push the outer two off the middle one: it comes to the radius of the first and stays there for a while.
fn row(apart: f64, moving: f64) -> Crowd {
    let (back, still) = (std::f64::consts::PI, 0.0);
    Crowd {
        places: vec![[0.0, 0.0], [2.0 + apart, 0.0], [3.95 + apart, 0.0]],
        angles: vec![0.0, back, 0.0],
        speeds: vec![still, moving, still],
    }
}

#[test]
fn pairs_stay_at_the_radius_in_large_flocks_too() {
    let law = "potential = { slope = [[0, \"1/9\"], [-2, -9]], at = 9, value = 0 }";
    // At the radius, into it and out of it slowly; ever faster to and fro without staying; once over it.
    let slow = [(0.0, 0.0, 1), (1e-8, 1e-5, 1), (-1e-8, -1e-5, 1)];
    for (apart, moving, least) in slow.into_iter().chain([(1e-6, 1e-4, 0), (0.0, 0.05, 0)]) {
        let run = "until = 3\nsamples = [\"1/100\", \"1/2\", 1, 3]\nrows = 30\ntolerance = 1e-10";
        let text = |crowd: &Crowd| crowd.aligning(law, run).replace("heading-alignment", "velocity-alignment");
        let outcomes = both(&row(apart, moving), text);
        compared(&outcomes, 3, 1e-7, &format!("{apart}, {moving}"));
        let stays = |outcome: &Outcome| outcome.remarks.iter().filter(|line| line.contains("1 and 2 stay")).count();
        assert!(stays(&outcomes.0) >= least && stays(&outcomes.0) == stays(&outcomes.1), "{:?}", outcomes.1.remarks);
        for (together, alone) in outcomes.0.rows.iter().zip(&outcomes.1.rows) {
            let far = (0..3).map(|k| (together.frame.positions[k][0] - alone.frame.positions[k][0]).abs());
            assert!(far.fold(0.0, f64::max) < 1e-7 && together.time == alone.time);
        }
    }
}

/// The same among others that move, meet and part: against the library's motion of all together.
#[test]
fn the_others_go_on_while_a_pair_stays() {
    let mut crowd = row(0.0, 0.0);
    let others = Crowd::on_a_lattice(256, 0.2, 5);
    crowd.places.extend(others.places.iter().map(|r| [3.0 * r[0] - 20.0, 3.0 * r[1] + 10.0]));
    crowd.angles.extend(others.angles);
    crowd.speeds.extend(others.speeds);
    let law = "potential = { slope = [[0, \"1/9\"], [-2, -9]], at = 9, value = 0 }";
    let run_until = "until = \"3/2\"\nsamples = [\"1/10\", \"3/2\"]\nrows = 2\ntolerance = 1e-10";
    let outcome = run(&crowd.aligning(law, run_until).replace("heading-alignment", "velocity-alignment"));
    assert!(outcome.remarks.iter().any(|line| line.contains("1 and 2 stay")), "{:?}", outcome.remarks);
    let potential = Potential::inverse_square_spring(&rational(9, 1), &rational(1, 1));
    let velocities = crowd.angles.iter().zip(&crowd.speeds).map(|(a, s)| [s * a.cos(), s * a.sin()]).collect();
    let start = State { positions: crowd.places, velocities };
    let flock = Flock::new(Alignment::Velocity, potential, Network::Within(2.0), start).expect("a flock");
    let motion = flock.run(1.5, &[0.1, 1.5], &Options::default(), &Unwatched).expect("a motion");
    let switch = |kind| matches!(kind, EventKind::Link | EventKind::Unlink);
    let those: Vec<_> = motion.events.iter().filter(|e| switch(e.kind)).map(|e| (e.pair.0 + 1, e.pair.1 + 1)).collect();
    assert_eq!(outcome.events.iter().map(|event| event.pair).collect::<Vec<_>>(), those);
    assert!(those.len() > 50, "{}", those.len());
    for (row, sample) in outcome.samples().zip(&motion.samples) {
        let far =
            row.frame.positions.iter().zip(&sample.state.positions).map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]));
        let far = far.fold(0.0, f64::max);
        assert!(far < 1e-7, "t = {}: {far}", row.time);
    }
}

const RUN: &str = "until = 2\nrows = 2\ntolerance = 1e-10";

#[test]
fn headings_one_by_one_switch_and_turn_as_all_together() {
    for reading in ["raw", "wrapped", "unwrapped"] {
        let law = format!("potential = \"inverse-square-log\"\nheading_difference = \"{reading}\"");
        for (count, seed) in [(2, 0), (9, 1), (16, 2), (25, 3)] {
            let crowd = Crowd::on_a_lattice(count, 0.3, seed);
            let outcomes = both(&crowd, |crowd| crowd.aligning(&law, RUN));
            let switches = compared(&outcomes, count, 1e-6, &format!("{reading}, {count} agents"));
            assert!(count < 9 || switches > 5, "{switches}");
        }
    }
    // Headings near a half turn, and nearly opposite ones.
    for (reading, first, between) in [("raw", 3.0, 0.0), ("wrapped", 0.0, 2.95)] {
        for seed in 0..4 {
            let mut crowd = Crowd::on_a_lattice(16, 0.2, seed);
            let angle = |k: usize, little: f64| first + between * (k % 2) as f64 + 0.03 * little;
            crowd.angles.iter_mut().enumerate().for_each(|(k, a)| *a = angle(k, *a));
            let law = format!("potential = \"inverse-square-log\"\nheading_difference = \"{reading}\"");
            let outcomes = both(&crowd, |crowd| crowd.aligning(&law, &RUN.replace("until = 2", "until = \"2/5\"")));
            compared(&outcomes, 16, 1e-6, &format!("{reading}, seed {seed}"));
        }
    }
}

#[test]
fn particles_one_by_one_switch_as_all_together() {
    for (gains, law) in [
        ((-0.2, 0.0), ""),
        ((0.3, 0.0), "omega0 = \"1/2\"\ndrift = [\"1/4\", \"-1/3\"]"),
        ((-0.1, 0.2), "omega0 = \"-3/4\""),
        ((-0.1, 0.001), "omega0 = 1\nbeacon = [1, 2]"),
    ] {
        for (count, seed) in [(2, 10), (25, 12)] {
            let crowd = Crowd::on_a_lattice(count, 0.3, seed);
            // The gain of a beacon is not divided.
            let text = |crowd: &Crowd| {
                let spacing = if law.contains("beacon") { 0.5 / crowd.places.len() as f64 } else { gains.1 };
                crowd.steered((gains.0, spacing), law, "until = 1\nrows = 2\ntolerance = 1e-9")
            };
            let switches = compared(&both(&crowd, text), count, 1e-7, &format!("{law}, {count} particles"));
            assert!(count < 9 || switches > 5, "{switches}");
            for nearest in [1, 4].into_iter().filter(|nearest| *nearest < count) {
                let text = |crowd: &Crowd| {
                    text(crowd).replace("\"within\"\nradius = 2", &format!("\"nearest\"\nnearest = {nearest}"))
                };
                let what = format!("{law}, {nearest} nearest of {count} particles");
                let switches = compared(&both(&crowd, text), count, 1e-7, &what);
                assert!(count < 9 || switches > 5, "{switches}");
            }
        }
    }
}

/// Lattices that grow, shrink and turn, with all pairs at the radius at once, exactly or nearly, and some at it from the start.
#[test]
fn many_at_the_radius_at_once_are_told_alike() {
    let out = |r: [f64; 2]| f64::atan2(r[1], r[0]);
    let around = |r: [f64; 2]| f64::atan2(r[0], -r[1]);
    // Two halves that move on as they are: what is at the radius in one of them would stay there.
    let apart = |r: [f64; 2]| if r[0] < 0.0 { 3.0 } else { 0.1 };
    let mut halves = Crowd::symmetric(36, apart);
    halves.places.iter_mut().for_each(|r| *r = [0.97 * r[0], 0.97 * r[1]]);
    let potential = "potential = \"none\"\nheading_difference = \"unwrapped\"";
    for (name, mut crowd) in
        [("out", Crowd::symmetric(36, out)), ("around", Crowd::symmetric(36, around)), ("apart", halves)]
    {
        for near in [0.0, 1e-9, 1e-3] {
            crowd.places.iter_mut().enumerate().for_each(|(k, r)| r[0] += near * (k % 7) as f64);
            let what = format!("{name}, {near}");
            let particles = both(&crowd, |crowd| crowd.steered((-0.05, 0.0), "", "until = 1\nrows = 2"));
            assert!(compared(&particles, 36, 1e-6, &what) > 0, "{what}");
            let headings = both(&crowd, |crowd| crowd.aligning(potential, "until = 1\nrows = 2"));
            compared(&headings, 36, 1e-6, &what);
        }
    }
}
