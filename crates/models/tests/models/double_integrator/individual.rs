//! Large flocks with individual steps against the flock that is followed as a whole.

use arithmetic::{Unwatched, rational};
use models::double_integrator::{
    Alignment, EventKind, Flock, Motion, Network, Options, Pair, Potential, State, VelocityLaw, random_flock,
};
use motion::{IndividualFlock, Pace, Sensing, Switch, Tolerance};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

const RADIUS: f64 = 2.0;

fn potential() -> Potential {
    Potential::inverse_square_log(&rational(1, 1))
}

/// Agents at the points of a lattice, a little moved: about twelve links each, and four switches of each in two units of time.
fn start(count: usize, seed: u64) -> State<f64> {
    let mut state = random_flock(count, 0.3, 1.0, &mut ChaCha8Rng::seed_from_u64(seed));
    let columns = (count as f64).sqrt().ceil() as usize;
    for (k, r) in state.positions.iter_mut().enumerate() {
        r[0] += (k % columns) as f64;
        r[1] += (k / columns) as f64;
    }
    state
}

fn flock(state: &State<f64>) -> Flock {
    Flock::new(Alignment::Velocity, potential(), Network::Within(RADIUS), state.clone()).unwrap()
}

/// All in the same steps, Dormand and Prince of order eight.
fn together(state: &State<f64>, until: f64) -> Motion {
    let tolerance = Tolerance { relative: 1e-13, absolute: 1e-13 };
    flock(state).run(until, &[until], &Options { tolerance, ..Options::default() }, &Unwatched).unwrap()
}

struct Run {
    switches: Vec<Switch>,
    flock: IndividualFlock<VelocityLaw, 0, 2>,
}

fn alone(state: &State<f64>, times: &[f64], pace: Pace) -> Run {
    let links = flock(state).links_at_start();
    let start = state.individuals(&vec![[]; state.count()]);
    let mut flock =
        IndividualFlock::new(VelocityLaw::new(&potential()), Sensing::Within(RADIUS), &start, &links, pace).unwrap();
    let mut switches = Vec::new();
    for &time in times {
        assert!(flock.advance(time, &mut switches, &Unwatched).unwrap());
    }
    Run { switches, flock }
}

fn now(run: &Run) -> State<f64> {
    State::of_individuals(run.flock.agents())
}

fn distance(a: &State<f64>, b: &State<f64>) -> f64 {
    a.to_list().iter().zip(b.to_list()).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
}

fn changes(switches: &[Switch]) -> Vec<(Pair, bool)> {
    switches.iter().map(|s| (s.pair, s.gained)).collect()
}

fn events(motion: &Motion) -> Vec<(Pair, bool)> {
    motion.events.iter().map(|e| (e.pair, e.kind == EventKind::Link)).collect()
}

#[test]
fn the_same_switches_in_the_same_order_and_errors_of_the_tolerance() {
    for (count, seeds) in [(2, 0..4), (8, 0..4), (30, 0..3), (60, 0..2)] {
        for seed in seeds {
            let state = start(count, seed);
            let twin = together(&state, 2.0);
            let mut links = twin.samples[0].links.clone();
            links.sort_unstable();
            for tolerance in [1e-6, 1e-8, 1e-10, 1e-12] {
                let run = alone(&state, &[2.0], Pace::Tolerance(tolerance));
                assert_eq!(changes(&run.switches), events(&twin), "{count} agents, seed {seed}, {tolerance}");
                assert_eq!(run.flock.links(), links);
                // What a step may be wrong by, for some steps, and where the motion is sensitive; the twin has errors too.
                let allowed = 100.0 * (tolerance + 1e-13);
                let late = run.switches.iter().zip(&twin.events).map(|(s, e)| (s.time - e.time).abs());
                assert!(late.fold(0.0, f64::max) < allowed, "{count} agents, seed {seed}, {tolerance}");
                let apart = distance(&now(&run), &twin.samples[0].state);
                assert!(apart < allowed, "{count} agents, seed {seed}, {tolerance}: {apart}");
            }
        }
    }
}

/// The errors fall with the sixth power of the step, across some hundred switches: two halvings divide them by 2^12.
#[test]
fn halving_the_steps_shows_the_order() {
    let mut powers = Vec::new();
    for (count, seed) in [(8, 0), (8, 2), (30, 0), (30, 1), (30, 2), (60, 0), (60, 1)] {
        let state = start(count, seed);
        let twin = together(&state, 2.0);
        let error = |step: f64| {
            let run = alone(&state, &[2.0], Pace::Fixed(step));
            assert_eq!(changes(&run.switches), events(&twin));
            distance(&now(&run), &twin.samples[0].state)
        };
        powers.push((error(0.02) / error(0.005)).log2() / 2.0);
    }
    let mean = powers.iter().sum::<f64>() / powers.len() as f64;
    assert!(mean > 5.5 && powers.iter().all(|power| *power > 5.0), "{powers:?}");
}

/// Forces of a pair are taken at different times for its two ends: the momentum is kept as far as the tolerance goes, and so is the fall of
/// the energy. Both are kept to rounding, and to the tolerance, where all have the same steps.
#[test]
fn momentum_is_kept_and_energy_falls_within_the_tolerance() {
    use models::double_integrator::{Coordinates, kinetic_energy, saturated_potential};
    let state = start(60, 5);
    let energy = |state: &State<f64>, links: &[Pair]| {
        let value = potential().value_over(&1.0).unwrap();
        let beyond = value.at(&(RADIUS * RADIUS)).unwrap();
        let plane = Coordinates::Cartesian;
        let potential = saturated_potential(&state.positions, links, plane, |_, _, s| value.at(s), &beyond).unwrap();
        potential + kinetic_energy(&state.velocities, plane).unwrap()
    };
    let momentum = |state: &State<f64>, c: usize| state.velocities.iter().map(|v| v[c]).sum::<f64>();
    for tolerance in [1e-6, 1e-8, 1e-10] {
        let mut before = f64::INFINITY;
        let mut run = alone(&state, &[], Pace::Tolerance(tolerance));
        for k in 1..=8 {
            assert!(run.flock.advance(f64::from(k) * 0.25, &mut run.switches, &Unwatched).unwrap());
            let there = now(&run);
            for c in [0, 1] {
                let lost = (momentum(&there, c) - momentum(&state, c)).abs();
                assert!(lost < 60.0 * tolerance, "{tolerance}: {lost}");
            }
            let now = energy(&there, &run.flock.links());
            assert!(now < before + 60.0 * tolerance, "{tolerance}: {now} after {before}");
            before = now;
        }
    }
}

#[test]
fn the_times_asked_for_change_no_bit() {
    let state = start(40, 1);
    let pace = Pace::Tolerance(1e-8);
    let once = alone(&state, &[2.0], pace);
    let often: Vec<f64> = (1..=200).map(|k| f64::from(k) / 100.0).collect();
    let often = alone(&state, &often, pace);
    assert_eq!(once.switches, often.switches);
    assert_eq!(now(&once), now(&often));
    assert_eq!(once.flock.restarts(), often.flock.restarts());
}

/// r = (5 - t, 6/5): |r| = 2 at 5 - t = 8/5. Four at once for agents that leave the corners of a square, and the same in a flock so wide that
/// agents far apart share a cell.
#[test]
fn crossings_in_free_flight_are_located_to_rounding() {
    let state = State { positions: vec![[5.0, 1.2], [0.0, 0.0]], velocities: vec![[-1.0, 0.0], [0.0, 0.0]] };
    let run = alone(&state, &[3.41], Pace::Tolerance(1e-10));
    assert_eq!(changes(&run.switches), [((0, 1), true)]);
    assert!((run.switches[0].time - 3.4).abs() < 4e-15, "{}", run.switches[0].time);
    for (far, slack) in [(0.0, 1e-14), (1e6, 1e-9)] {
        let corner = |k: usize, out: f64| [(k % 2) as f64 * out + far, (k / 2) as f64 * out - far];
        let inward = |k: usize| [0.5 - (k % 2) as f64, 0.5 - (k / 2) as f64];
        let mut state =
            State { positions: (0..4).map(|k| corner(k, 2.5)).collect(), velocities: (0..4).map(inward).collect() };
        // Others, far away: the same places modulo the width of all cells together, or not.
        for k in 0..12 {
            state.positions.push([f64::from(k) * 10.0 - 200.0 + far, 77.0 - far]);
            state.velocities.push([0.0, 0.0]);
        }
        let run = alone(&state, &[0.6], Pace::Tolerance(1e-10));
        // The sides shrink at rate 1 from 5/2 to 2.
        let mut pairs = changes(&run.switches);
        pairs.sort_unstable();
        assert_eq!(pairs, [((0, 1), true), ((0, 2), true), ((1, 3), true), ((2, 3), true)]);
        assert!(run.switches.iter().all(|s| (s.time - 0.5).abs() < slack), "{:?}", run.switches);
    }
}

/// A lattice that grows evenly: all pairs inside cross at once, to rounding.
#[test]
fn many_switches_at_once_are_no_sliding() {
    let mut state = start(100, 0);
    for (k, (r, v)) in state.positions.iter_mut().zip(&mut state.velocities).enumerate() {
        *r = [0.999 * (k % 10) as f64, 0.999 * (k / 10) as f64];
        *v = [0.1 * r[0], 0.1 * r[1]];
    }
    let twin = together(&state, 0.05);
    let run = alone(&state, &[0.05], Pace::Tolerance(1e-10));
    assert!(run.switches.len() > 50, "{}", run.switches.len());
    let sorted = |mut all: Vec<(Pair, bool)>| {
        all.sort_unstable();
        all
    };
    assert_eq!(sorted(changes(&run.switches)), sorted(events(&twin)));
    assert!(distance(&now(&run), &twin.samples[0].state) < 1e-8);
}
