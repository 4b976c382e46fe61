//! How motions are put together: samples, runs that are stopped, runs that stay at `R`, headings.

use algebra::graph::Graph;
use arithmetic::{ArithmeticError, Progress, Unwatched, rational};
use models::double_integrator::{
    Alignment, Coordinates, EventKind, Flock, HeadingDifference, MotionError, Network, Options, Potential, Prefer,
    State, follow, gyroscopic, heading, potential_gradients,
};
use motion::Tolerance;
use std::sync::atomic::{AtomicUsize, Ordering};

const PLANE: Coordinates = Coordinates::Cartesian;

fn spring() -> Potential {
    Potential::inverse_square_spring(&rational(1, 1), &rational(1, 1))
}

fn start() -> State<f64> {
    State {
        positions: vec![[0.0, 0.0], [1.2, 0.1], [2.0, 1.0], [0.5, 2.0]],
        velocities: vec![[1.0, 0.0], [0.0, -0.5], [0.3, 0.3], [-0.2, 0.1]],
    }
}

fn flock(network: Network) -> Flock {
    Flock::new(Alignment::Velocity, spring(), network, start()).unwrap()
}

fn distance(a: &State<f64>, b: &State<f64>) -> f64 {
    a.to_list().iter().zip(b.to_list()).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
}

/// Stops after it was asked so often.
struct After(usize, AtomicUsize);

impl Progress for After {
    fn is_cancelled(&self) -> bool {
        self.1.fetch_add(1, Ordering::Relaxed) >= self.0
    }
}

/// What was reached before is kept, with the time of the stop, and it is what an undisturbed run has.
#[test]
fn stopped_runs_keep_what_they_reached() {
    let flock = flock(Network::Fixed(Graph::path(4)));
    let times: Vec<f64> = (0..=50).map(|k| f64::from(k) * 0.1).collect();
    let whole = flock.run(5.0, &times, &Options::default(), &Unwatched).unwrap();
    let mut before = 0.0;
    for steps in [0, 1, 3, 5] {
        let (motion, end) = flock.run_as_far(5.0, &times, &Options::default(), &After(steps, AtomicUsize::new(0)));
        let Err(MotionError::Halted(time)) = end else { panic!("{end:?}") };
        assert!(if steps == 0 { time == 0.0 } else { time > before }, "{steps} {time}");
        assert_eq!(motion.samples.len(), times.iter().filter(|t| **t < time).count());
        assert_eq!(motion.samples, whole.samples[..motion.samples.len()]);
        before = time;
    }
    let (motion, end) = flock.run_as_far(5.0, &times, &Options::default(), &Unwatched);
    assert_eq!((motion, end), (whole, Ok(())));
}

/// As many arrivals are allowed as is said: one that enters and leaves has two.
#[test]
fn arrivals_are_counted() {
    let nothing = Potential::new(Vec::new(), (rational(1, 1), rational(0, 1)));
    let start = State { positions: vec![[-5.0, 1.99], [0.0, 0.0]], velocities: vec![[1.0, 0.0], [0.0, 0.0]] };
    let flock = Flock::new(Alignment::Velocity, nothing, Network::Within(2.0), start).unwrap();
    let run = |most_events| flock.run(20.0, &[], &Options { most_events, ..Options::default() }, &Unwatched);
    let all = run(2).unwrap();
    assert_eq!(all.events.len(), 2);
    for count in [0, 1] {
        let time = all.events[count].time;
        assert_eq!(run(count), Err(MotionError::TooManyEvents { count, time, pair: (0, 1) }));
    }
}

/// The limits of tolerances, ends and samples.
#[test]
fn limits_of_runs_are_those_that_are_told() {
    let flock = flock(Network::Fixed(Graph::path(4)));
    let with = |relative, absolute| {
        let tolerance = Tolerance { relative, absolute };
        flock.run(0.0, &[], &Options { tolerance, ..Options::default() }, &Unwatched).map(|motion| motion.steps)
    };
    for bad in [0.0, 1.0, -1e-9, f64::INFINITY] {
        assert!(with(bad, 1e-9).is_err() && with(1e-9, bad).is_err(), "{bad}");
    }
    assert!(with(0.99, 0.99).is_ok());
    let run =
        |until, samples: &[f64]| flock.run(until, samples, &Options::default(), &Unwatched).map(|m| m.samples.len());
    assert_eq!(run(f64::INFINITY, &[]), Err(MotionError::Until(f64::INFINITY)));
    assert_eq!(run(0.1, &[0.0, 0.0, 0.05, 0.1, 0.1]), Ok(5));
    for (samples, sample) in [(&[0.05, 0.2][..], 0.2), (&[-0.1], -0.1), (&[0.1, 0.05], 0.05)] {
        assert_eq!(run(0.1, samples), Err(MotionError::Samples { until: 0.1, sample }));
    }
}

/// Two at rest at `R`, the second one pulled by a third: held back, until no weight in `[0, 1]` holds it.
fn held() -> Flock {
    let start = State { positions: vec![[0.0, 0.0], [2.0, 0.0], [3.5, 0.0]], velocities: vec![[0.0, 0.0]; 3] };
    Flock::new(Alignment::Velocity, spring(), Network::Within(2.0), start).unwrap()
}

/// From any time on, until no pair stays: the same motion, which ends after the step in which the pair has left.
#[test]
fn runs_that_stay_end_where_none_stays() {
    let options = Options { prefer: Prefer::Stay, ..Options::default() };
    let times: Vec<f64> = (0..=20).map(|k| f64::from(k) * 0.05).collect();
    let whole = held().run(1.0, &times, &options, &Unwatched).unwrap();
    let left = whole.events.iter().find(|e| e.pair == (0, 1) && e.kind != EventKind::Stay).unwrap().time;
    for from in [0.0, 7.0] {
        let later: Vec<f64> = times.iter().map(|t| from + t).collect();
        let links = held().links_at_start();
        let (motion, end) = held().run_staying(from, &links, &later, &options, &Unwatched);
        end.unwrap();
        let kinds =
            |events: &[models::double_integrator::Event]| events.iter().map(|e| (e.pair, e.kind)).collect::<Vec<_>>();
        assert_eq!(kinds(&motion.events), kinds(&whole.events[..motion.events.len()]));
        assert!((motion.events.last().unwrap().time - from - left).abs() < 1e-7);
        let last = motion.samples.last().unwrap();
        assert!(last.time > from + left && last.time < from + 1.0, "{} {left}", last.time);
        for (sample, known) in motion.samples.iter().zip(&whole.samples).take(motion.samples.len() - 1) {
            assert!((sample.time - from - known.time).abs() < 1e-12 && distance(&sample.state, &known.state) < 1e-7);
        }
        let there = held().run(last.time - from, &[last.time - from], &options, &Unwatched).unwrap();
        assert!(distance(&there.samples[0].state, &last.state) < 1e-7);
        // No longer than asked for.
        let (short, end) = held().run_staying(from, &links, &[from + 0.1], &options, &Unwatched);
        assert_eq!((short.samples.len(), short.samples[0].time, end), (1, from + 0.1, Ok(())));
    }
    let bad = Options { tolerance: Tolerance { relative: 0.0, absolute: 1e-9 }, ..options };
    let refused = held().run_staying(0.0, &[(1, 2)], &[1.0], &bad, &Unwatched);
    assert_eq!(refused.1, Err(MotionError::Tolerance(bad.tolerance)));
    let (none, end) = held().run_staying(3.0, &[(1, 2)], &[], &options, &Unwatched);
    assert_eq!((none.samples.len(), none.samples[0].time, end), (1, 3.0, Ok(())));
    // Without a pair that stays: one step.
    let away = Options { prefer: Prefer::Enter, ..options };
    let (motion, end) = held().run_staying(0.0, &[(1, 2)], &[50.0], &away, &Unwatched);
    assert!(end.is_ok() && motion.samples[0].time < 5.0, "{:?}", motion.samples[0].time);
}

/// The law of the first paper, with wrapped differences and raw ones.
#[test]
fn heading_alignment_follows_its_law() {
    let edges = [(0, 1), (1, 2), (2, 3)];
    for reading in [HeadingDifference::Wrapped, HeadingDifference::Raw] {
        let network = Network::Fixed(Graph::path(4));
        let flock = Flock::new(Alignment::Heading(reading), spring(), network, start()).unwrap();
        let found = flock.run(1.0, &[1.0], &Options::default(), &Unwatched).unwrap();
        let law = |state: &State<f64>| -> Result<_, ArithmeticError> {
            let gradients = potential_gradients(&state.positions, &edges, PLANE, |_, _, s| spring().slope(s))?;
            let angles = state.velocities.iter().map(heading).collect::<Result<Vec<f64>, _>>()?;
            gyroscopic(state, &gradients, &edges, |i, j| reading.read(angles[i] - angles[j]))
        };
        let known = follow(&start(), &[1.0], Options::default().tolerance, law).unwrap();
        assert!(distance(&found.samples[0].state, &known[0]) < 1e-7, "{reading:?}");
        // The force does no work: mechanical energy stays.
        assert!((found.energy.last - found.energy.first).abs() < 1e-8);
    }
}

/// Two at rest at `R`, pulled apart by one more on each side that moves away at a speed, all on a line and symmetric. As long as the two stay, the
/// distance `x` of the outer ones from them obeys `x'' = -x' - 2 V'(x²) x`, and the weight of the link, `(x' + 2 V'(x²) x)/(2 V'(4) 2)`, grows to 1:
/// then they part. The time is that of the closed loop of `x` by small steps, wherever in a step of the integrator it comes.
#[test]
fn pairs_part_where_the_weight_would_be_more_than_one() {
    let pull = |x: f64| 2.0 * (1.0 - 1.0 / (x * x * x * x)) * x;
    let options = Options { prefer: Prefer::Stay, ..Options::default() };
    for k in 0..12 {
        let (start, speed) = (1.05 + 0.01 * f64::from(k), 2.5 - 0.03 * f64::from(k));
        let rate = |(x, u): (f64, f64)| (u, -u - pull(x));
        let step = |at: (f64, f64), h: f64| {
            let by = |d: (f64, f64), h: f64| (at.0 + h * d.0, at.1 + h * d.1);
            let one = rate(at);
            let two = rate(by(one, h / 2.0));
            let three = rate(by(two, h / 2.0));
            let four = rate(by(three, h));
            by((one.0 + 2.0 * (two.0 + three.0) + four.0, one.1 + 2.0 * (two.1 + three.1) + four.1), h / 6.0)
        };
        let room = |(x, u): (f64, f64)| 3.75 - u - pull(x);
        let (mut at, mut time) = ((start, speed), 0.0);
        for h in [1e-3, 1e-5, 1e-7] {
            while room(step(at, h)) > 0.0 {
                (at, time) = (step(at, h), time + h);
            }
        }
        let agents = [[-1.0 - start, -1.0, 1.0, 1.0 + start], [-speed, 0.0, 0.0, speed]];
        let [positions, velocities] = agents.map(|x| x.map(|x| [x, 0.0]).to_vec());
        let flock =
            Flock::new(Alignment::Velocity, spring(), Network::Within(2.0), State { positions, velocities }).unwrap();
        let motion = flock.run(time + 0.01, &[], &options, &Unwatched).unwrap();
        let events: Vec<_> = motion.events.iter().map(|e| (e.pair, e.kind)).collect();
        assert_eq!(events, [((1, 2), EventKind::Stay), ((1, 2), EventKind::Unlink)], "{k} {time}");
        assert!((motion.events[1].time - time).abs() < 3e-7, "{k}: {} {time}", motion.events[1].time);
    }
}

/// The steps before an arrival count, and those after it.
#[test]
fn steps_before_and_after_an_arrival_are_counted() {
    let start = State { positions: vec![[5.0, 0.0], [0.0, 0.0]], velocities: vec![[-1.0, 0.0], [0.0, 0.0]] };
    let steps = |until: f64| {
        let flock = Flock::new(Alignment::Velocity, spring(), Network::Within(2.0), start.clone()).unwrap();
        flock.run(until, &[], &Options::default(), &Unwatched).unwrap().steps
    };
    // One more, cut short by the end.
    assert!(steps(2.999) > 1);
    assert_eq!(steps(3.0 + 1e-6), steps(2.999) + 1);
}

/// What is computed where nothing else is asked for.
#[test]
fn options_have_their_defaults() {
    let Options { tolerance, prefer, first_branch, most_events } = Options::default();
    assert_eq!(tolerance, Tolerance { relative: 1e-10, absolute: 1e-10 });
    assert_eq!((prefer, first_branch, most_events), (Prefer::Keep, None, 100_000));
}
