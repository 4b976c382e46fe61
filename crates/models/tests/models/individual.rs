//! Headings and steered particles with individual steps: the order of the method, and results that depend on nothing but the start.

use arithmetic::random::{generator, uniform};
use arithmetic::{Complex, Unwatched, rational};
use models::double_integrator::{HeadingDifference, HeadingLaw, Potential};
use models::oscillator::{Neighbours, ParticleLaw};
use motion::{FollowError, IndividualFlock, IndividualLaw, Moving, Pace, Sensing, Switch};
use std::f64::consts::PI;

const RADIUS: f64 = 2.0;

const FINE: Pace = Pace::Fixed(0.001);

/// On a lattice, a little moved, with headings all around; the further state is the heading.
fn start(count: usize, seed: u64) -> Vec<Moving<f64, 1>> {
    heading(count, seed, |_| 0.0, 3.1)
}

/// The same with given headings, up to a little.
fn heading(count: usize, seed: u64, angle: impl Fn(usize) -> f64, little: f64) -> Vec<Moving<f64, 1>> {
    let mut random = generator("individual", "start", seed);
    let mut even = |from: f64, to: f64| from + (to - from) * uniform(&mut random);
    let columns = (count as f64).sqrt().ceil() as usize;
    let agent = |k: usize| {
        let position = [(k % columns) as f64 + even(-0.3, 0.3), (k / columns) as f64 + even(-0.3, 0.3)];
        let theta = angle(k) + even(-little, little);
        Moving { position, velocity: [theta.cos(), theta.sin()], further: [theta] }
    };
    (0..count).map(agent).collect()
}

struct Run {
    switches: Vec<Switch>,
    agents: Vec<Moving<f64, 1>>,
    restarts: u64,
}

fn run<const M: usize>(
    law: &(impl IndividualLaw<1, M> + Clone),
    start: &[Moving<f64, 1>],
    times: &[f64],
    pace: Pace,
) -> Run {
    run_with(law, Sensing::Within(RADIUS), &pairs_within(start), start, times, pace)
}

fn pairs_within(start: &[Moving<f64, 1>]) -> Vec<(usize, usize)> {
    let near = |i: usize, j: usize| {
        let (a, b) = (start[i].position, start[j].position);
        (a[0] - b[0]).hypot(a[1] - b[1]) < RADIUS
    };
    (0..start.len()).flat_map(|i| (0..i).map(move |j| (j, i))).filter(|&(i, j)| near(i, j)).collect()
}

fn run_with<const M: usize>(
    law: &(impl IndividualLaw<1, M> + Clone),
    sensing: Sensing,
    links: &[(usize, usize)],
    start: &[Moving<f64, 1>],
    times: &[f64],
    pace: Pace,
) -> Run {
    let mut flock = IndividualFlock::new(law.clone(), sensing, start, links, pace).unwrap();
    let mut switches = Vec::new();
    times.iter().for_each(|time| assert!(flock.advance(*time, &mut switches, &Unwatched).unwrap()));
    Run { switches, agents: flock.agents().collect(), restarts: flock.restarts() }
}

/// Angles up to whole turns: a raw heading jumps.
fn distance(a: &Run, b: &Run) -> f64 {
    let apart = |(a, b): (&Moving<f64, 1>, &Moving<f64, 1>)| {
        let vectors = [0, 1].map(|c| (a.position[c] - b.position[c]).abs().max((a.velocity[c] - b.velocity[c]).abs()));
        vectors[0].max(vectors[1]).max(models::angles::modulo_turns(a.further[0] - b.further[0]).abs())
    };
    a.agents.iter().zip(&b.agents).map(apart).fold(0.0, f64::max)
}

fn headings(reading: HeadingDifference) -> HeadingLaw {
    HeadingLaw::new(&Potential::inverse_square_log(&rational(1, 1)), reading)
}

fn particles() -> ParticleLaw {
    let drift = Complex { re: 0.25, im: -0.5 };
    ParticleLaw { frequency: 0.5, orientation: -0.3, spacing: 0.1, beacon: None, drift }
}

fn power<const M: usize>(law: &(impl IndividualLaw<1, M> + Clone), start: &[Moving<f64, 1>], step: f64) -> f64 {
    power_with(law, Sensing::Within(RADIUS), &pairs_within(start), start, step)
}

fn power_with<const M: usize>(
    law: &(impl IndividualLaw<1, M> + Clone),
    sensing: Sensing,
    links: &[(usize, usize)],
    start: &[Moving<f64, 1>],
    step: f64,
) -> f64 {
    let until = [50.0 * step];
    let finest = run_with(law, sensing, links, start, &until, Pace::Fixed(step / 32.0));
    let error = |step: f64| {
        let run = run_with(law, sensing, links, start, &until, Pace::Fixed(step));
        assert_eq!(run.switches.len(), finest.switches.len());
        distance(&run, &finest)
    };
    (error(step) / error(step / 4.0)).log2() / 2.0
}

/// The errors fall with the sixth power of the step, across all switches and turns.
#[test]
fn halving_the_steps_shows_the_order_of_every_law() {
    let readings = [HeadingDifference::Raw, HeadingDifference::Wrapped, HeadingDifference::Unwrapped];
    for seed in [2, 5, 6] {
        for reading in readings {
            let found = power(&headings(reading), &start(9, seed), 0.008);
            assert!(found > 5.0, "{reading:?}, seed {seed}: {found}");
        }
    }
    for (count, seed) in [(9, 4), (25, 5), (25, 6)] {
        let found = power(&particles(), &start(count, seed), 0.04);
        assert!(found > 5.0, "{count} particles, seed {seed}: {found}");
    }
}

/// Headings near a half turn, and pairs in nearly opposite directions: what is read jumps soon, and the order is kept.
#[test]
fn half_turns_of_headings_are_located() {
    let unwrapped = headings(HeadingDifference::Unwrapped);
    let mut turned = [0, 0];
    for seed in 0..6 {
        let near = heading(9, seed, |_| 3.0, 0.1);
        let mut opposite = heading(9, seed, |k| 2.95 * (k % 2) as f64, 0.09);
        // Slow ones are turned by the gradients.
        opposite.iter_mut().for_each(|agent| agent.velocity = agent.velocity.map(|v| 0.3 * v));
        for (reading, start) in [(HeadingDifference::Raw, near), (HeadingDifference::Wrapped, opposite)] {
            let law = headings(reading);
            let (jumps, not) = (run(&law, &start, &[0.2], FINE), run(&unwrapped, &start, &[0.2], FINE));
            let apart = distance(&jumps, &not);
            turned[usize::from(reading == HeadingDifference::Raw)] += usize::from(apart > 1e-3);
            assert!(!(1e-12..1e-3).contains(&apart), "the readings are the same up to the first jump");
            if reading == HeadingDifference::Raw {
                assert!(jumps.agents.iter().all(|agent| agent.further[0].abs() <= PI));
                assert!(apart < 1e-12 || not.agents.iter().any(|agent| agent.further[0].abs() > PI));
            }
            let found = power(&law, &start, 0.004);
            assert!(found > 4.5, "{reading:?}, seed {seed}: {found}");
        }
    }
    assert!(turned.iter().all(|count| *count > 1), "{turned:?}");
}

/// `d theta/dt = omega_0`, and velocities that keep their length whatever the number of series.
#[test]
fn particles_without_gains_go_round_on_circles() {
    let law = ParticleLaw { orientation: 0.0, spacing: 0.0, ..particles() };
    let start = start(25, 7);
    let end = run(&law, &start, &[40.0], Pace::Tolerance(1e-9));
    assert!(end.restarts > 1000);
    for (from, to) in start.iter().zip(&end.agents) {
        let (theta, drift) = (from.further[0], [0.25 * 40.0, -0.5 * 40.0]);
        assert!((to.further[0] - theta - 20.0).abs() < 1e-9);
        let [x, y] = [0, 1].map(|c| to.position[c] - from.position[c] - drift[c]);
        let sine = ((theta + 20.0).sin() - theta.sin()) / 0.5;
        let cosine = (theta.cos() - (theta + 20.0).cos()) / 0.5;
        assert!((x - sine).abs() < 1e-7 && (y - cosine).abs() < 1e-7, "{x} {sine} {y} {cosine}");
    }
}

#[test]
fn the_times_asked_for_change_no_bit_of_any_law() {
    let start = start(30, 8);
    let often: Vec<f64> = (1..=50).map(|k| f64::from(k) / 50.0).collect();
    let pace = Pace::Tolerance(1e-8);
    let same = |a: Run, b: Run| {
        assert_eq!((a.switches, a.agents, a.restarts), (b.switches, b.agents, b.restarts));
    };
    let raw = headings(HeadingDifference::Raw);
    same(run(&raw, &start, &[1.0], pace), run(&raw, &start, &often, pace));
    same(run(&particles(), &start, &[1.0], pace), run(&particles(), &start, &often, pace));
    let arcs = nearest(&start, 4);
    let [once, often] =
        [&[1.0][..], &often].map(|times| run_with(&particles(), Sensing::Nearest, &arcs, &start, times, pace));
    same(once, often);
}

/// The arcs to the nearest, found among all.
fn nearest(agents: &[Moving<f64, 1>], count: usize) -> Vec<(usize, usize)> {
    let places: Vec<Complex<f64>> =
        agents.iter().map(|agent| Complex::new(agent.position[0], agent.position[1])).collect();
    Neighbours::nearest(&places, count).arcs().collect()
}

/// Whether two others are as good as equally far from one agent, so that either may be the nearer one.
fn has_ties(agents: &[Moving<f64, 1>]) -> bool {
    agents.iter().any(|own| {
        let square = |other: &Moving<f64, 1>| {
            let [x, y] = [0, 1].map(|c| other.position[c] - own.position[c]);
            x * x + y * y
        };
        let mut squares: Vec<f64> = agents.iter().map(square).collect();
        squares.sort_by(f64::total_cmp);
        squares.windows(2).any(|pair| pair[1] - pair[0] < 1e-10 * (1.0 + pair[1]))
    })
}

/// At all times that are looked at the arcs lead to the nearest, in flocks that stay, spread out, gather, and have members far away.
#[test]
fn the_nearest_are_found_whatever_the_flock_does() {
    let still = |k: usize, count: usize| if k < count / 2 { 0.0 } else { PI };
    let gathering = ParticleLaw { beacon: Some((0.4, Complex { re: 3.0, im: 3.0 })), ..particles() };
    let flying = ParticleLaw { frequency: 0.0, orientation: 0.01, spacing: 0.0, ..particles() };
    for (name, law) in [("circles", particles()), ("gathering", gathering), ("flying apart", flying)] {
        for (count, sensed, seed) in [(2, 1, 1), (9, 3, 2), (40, 1, 3), (40, 6, 4), (40, 39, 5), (100, 4, 6)] {
            let mut start = heading(count, seed, |k| still(k, count), 1.5);
            // Some are far away from all others.
            start.iter_mut().skip(2).step_by(13).for_each(|agent| agent.position[0] += 40.0);
            let arcs = nearest(&start, sensed);
            let mut flock =
                IndividualFlock::new(law.clone(), Sensing::Nearest, &start, &arcs, Pace::Tolerance(1e-8)).unwrap();
            let (mut switches, mut looked) = (Vec::new(), 0);
            for time in (1..=12).map(|k| 0.5 * f64::from(k)) {
                assert!(flock.advance(time, &mut switches, &Unwatched).unwrap());
                let now: Vec<Moving<f64, 1>> = flock.agents().collect();
                if !has_ties(&now) {
                    assert_eq!(flock.links(), nearest(&now, sensed), "{name}, {sensed} of {count}, t = {time}");
                    looked += 1;
                }
            }
            assert!(looked > 8, "{looked}");
            assert!(
                switches.len() > 10 || count < 40 || sensed == 39,
                "{name}, {sensed} of {count}: {}",
                switches.len()
            );
            let gained = switches.iter().filter(|switch| switch.gained).count();
            assert_eq!(2 * gained, switches.len());
        }
    }
}

#[test]
fn the_order_is_kept_where_the_nearest_change() {
    for (count, sensed, seed) in [(9, 2, 1), (25, 3, 2), (25, 5, 3)] {
        let start = start(count, seed);
        let found = power_with(&particles(), Sensing::Nearest, &nearest(&start, sensed), &start, 0.04);
        assert!(found > 5.0, "{sensed} of {count}, seed {seed}: {found}");
    }
}

/// A lattice that moves on as it is: everyone has others at exactly the same distance all the time, and rounding changes no neighbour.
#[test]
fn rows_and_columns_that_move_together_keep_their_neighbours() {
    let law = ParticleLaw { frequency: 0.0, orientation: 0.0, spacing: 0.0, ..particles() };
    let mut start = heading(49, 1, |_| 0.7, 0.0);
    start.iter_mut().enumerate().for_each(|(k, agent)| agent.position = [(k % 7) as f64, (k / 7) as f64]);
    let arcs = nearest(&start, 3);
    let run = run_with(&law, Sensing::Nearest, &arcs, &start, &[30.0], Pace::Tolerance(1e-8));
    assert_eq!(run.switches, []);
}

#[test]
fn links_are_between_two_agents_that_are_there() {
    let law = HeadingLaw::new(&Potential::inverse_square_log(&rational(1, 1)), HeadingDifference::Wrapped);
    for sensing in [Sensing::Within(RADIUS), Sensing::Nearest] {
        for pair in [(0, 4), (9, 1), (2, 2)] {
            let flock = IndividualFlock::new(law.clone(), sensing, &start(4, 1), &[(0, 1), pair], FINE);
            assert_eq!(flock.err(), Some(FollowError::Link { pair, count: 4 }));
        }
    }
}
