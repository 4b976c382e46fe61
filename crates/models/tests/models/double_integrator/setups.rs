//! What experiments are drawn from: the numbers of the papers, and every draw from its numbers between 0 and 1.

use algebra::graph::Graph;
use arithmetic::random::uniform;
use arithmetic::rational;
use models::double_integrator::{
    Alignment, HeadingDifference, HeadingReading, InputError, LinkRule, Options, Potential, Prefer, Setup, StartRule,
    State, random_flock,
};
use motion::Tolerance;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use std::f64::consts::TAU;

fn random(seed: u64) -> ChaCha8Rng {
    ChaCha8Rng::seed_from_u64(seed)
}

/// Positions even in a square, speeds even up to a number, angles even.
fn square(count: usize, half: f64, speed: f64, even: &mut dyn FnMut() -> f64) -> State<f64> {
    let positions = (0..count).map(|_| [even(), even()].map(|u| 2.0 * half * u - half)).collect();
    let mut velocity = || {
        let (size, (sin, cos)) = (speed * even(), (TAU * even()).sin_cos());
        [size * cos, size * sin]
    };
    State { positions, velocities: (0..count).map(|_| velocity()).collect() }
}

/// Even in the discs: the square of a radius is even up to that of the disc.
fn discs(count: usize, radii: [f64; 2], even: &mut dyn FnMut() -> f64) -> State<f64> {
    let [positions, velocities] = radii.map(|radius| {
        let mut point = || {
            let (size, (sin, cos)) = ((radius * radius * even()).sqrt(), (TAU * even()).sin_cos());
            [size * cos, size * sin]
        };
        (0..count).map(|_| point()).collect()
    });
    State { positions, velocities }
}

fn assert_near(a: &State<f64>, b: &State<f64>) {
    let off = a.to_list().iter().zip(b.to_list()).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
    assert!(a.count() == b.count() && off < 1e-13, "{off}");
}

#[test]
fn starts_are_drawn_evenly() {
    for seed in 0..5 {
        let mut own = random(seed);
        assert_near(&random_flock(6, 2.5, 0.5, &mut random(seed)), &square(6, 2.5, 0.5, &mut || uniform(&mut own)));
        for (start, radii) in [(StartRule::Discs(20.0, 1.0), [20.0, 1.0]), (StartRule::Discs(3.0, 5.0), [3.0, 5.0])] {
            let setup = Setup { start, ..Setup::heading_alignment(true, HeadingReading::Printed) };
            let (flock, mut own) = (setup.draw(&mut random(seed)).unwrap(), random(seed));
            assert_near(flock.start(), &discs(10, radii, &mut || uniform(&mut own)));
            assert_eq!(flock.links_at_start(), Graph::from_fn(10, |_, _| true).edges());
        }
    }
}

/// A network, and after it a start: each pair with its probability, all again until the graph is connected.
#[test]
fn random_networks_are_drawn_until_they_are_connected() {
    let mut tries = Vec::new();
    for (seed, probability) in (0..12).flat_map(|seed| [(seed, 0.5), (seed, 0.3)]) {
        let setup = Setup { agents: 5, ..Setup::velocity_alignment(LinkRule::Random(probability)) };
        let (flock, mut own) = (setup.draw(&mut random(seed)).unwrap(), random(seed));
        let mut even = || uniform(&mut own);
        let graph = (1..)
            .find_map(|k| {
                let table: Vec<Vec<f64>> = (0..5).map(|_| (0..5).map(|_| even()).collect()).collect();
                let graph = Graph::from_fn(5, |i, j| table[i.min(j)][i.max(j)] < probability);
                graph.is_connected().then(|| {
                    tries.push(k);
                    graph
                })
            })
            .unwrap();
        assert_eq!(flock.links_at_start(), graph.edges());
        assert_near(flock.start(), &square(5, 2.5, 1.0, &mut even));
    }
    assert!(tries.contains(&1) && tries.iter().any(|&k| k > 2), "{tries:?}");
}

#[test]
fn draws_that_are_never_connected_end() {
    let nowhere = LinkRule::Within { radius: 1e-9, connected: true };
    for links in [LinkRule::Random(0.0), LinkRule::Random(f64::NAN), nowhere] {
        let setup = Setup { agents: 3, ..Setup::velocity_alignment(links) };
        assert_eq!(setup.draw(&mut random(0)).err(), Some(InputError::NeverConnected(Setup::DRAWS)), "{links:?}");
    }
}

/// Starts whose pairs closer than the radius make a connected graph, drawn until they do; or any.
#[test]
fn starts_within_a_radius_are_drawn_until_they_are_connected() {
    let mut redrawn = 0;
    for seed in 0..12 {
        for connected in [true, false] {
            let links = LinkRule::Within { radius: Setup::RADIUS, connected };
            let setup = Setup { agents: 4, ..Setup::velocity_alignment(links) };
            let (flock, mut own) = (setup.draw(&mut random(seed)).unwrap(), random(seed));
            let near = |state: &State<f64>| {
                let apart = |i: usize, j: usize| state.separation(i, j).map(|x| x * x).iter().sum::<f64>();
                Graph::from_fn(4, |i, j| apart(i, j) < 4.0)
            };
            let first = square(4, 2.5, 1.0, &mut || uniform(&mut own));
            let mut start = first.clone();
            while connected && !near(&start).is_connected() {
                start = square(4, 2.5, 1.0, &mut || uniform(&mut own));
            }
            redrawn += usize::from(start != first);
            assert_near(flock.start(), &start);
            assert_eq!(flock.links_at_start(), near(&start).edges());
        }
    }
    assert!((1..12).contains(&redrawn), "{redrawn}");
}

/// Section V of the first paper in its three readings, Section 6 of the second one.
#[test]
fn setups_have_the_numbers_of_the_papers() {
    let one = rational(1, 1);
    let (log, spring) = (Potential::inverse_square_log(&one), Potential::inverse_square_spring(&one, &one));
    for (reading, speed, potential) in [
        (HeadingReading::Printed, 20.0, &log),
        (HeadingReading::Spring, 20.0, &spring),
        (HeadingReading::Slow, 1.0, &log),
    ] {
        for (complete, links) in [(true, LinkRule::Complete), (false, LinkRule::Random(0.5))] {
            let known = Setup {
                agents: 10,
                links,
                start: StartRule::Discs(20.0, speed),
                alignment: Alignment::Heading(HeadingDifference::Raw),
                potential: potential.clone(),
            };
            assert_eq!(Setup::heading_alignment(complete, reading), known);
        }
    }
    let (links, start) = (LinkRule::Complete, StartRule::Square(2.5, 1.0));
    let known = Setup { agents: 10, links, start, alignment: Alignment::Velocity, potential: log };
    assert_eq!((Setup::velocity_alignment(links), Setup::RADIUS), (known, 2.0));
    let Options { tolerance, prefer, first_branch, most_events } = Setup::OPTIONS;
    assert_eq!(tolerance, Tolerance { relative: 1e-7, absolute: 1e-7 });
    assert_eq!((prefer, first_branch, most_events), (Prefer::Keep, None, 100_000));
}

/// A pair whose number is the probability itself is not linked.
#[test]
fn a_number_as_large_as_the_probability_links_nobody() {
    let mut own = random(3);
    let numbers: Vec<f64> = (0..60).map(|_| uniform(&mut own)).collect();
    let setup = Setup { agents: 2, ..Setup::velocity_alignment(LinkRule::Random(numbers[1])) };
    let connected = (0..9).find(|k| numbers[4 * k + 1] < numbers[1]).unwrap();
    assert!(connected > 0);
    let start = setup.draw(&mut random(3)).unwrap().start().clone();
    let mut rest = numbers[4 * connected + 4..].iter().copied();
    assert_near(&start, &square(2, 2.5, 1.0, &mut || rest.next().unwrap()));
}
