//! Where a flock goes that follows a cycle of networks, against the same flock stepped exactly.

use super::*;
use crate::averaging::{Hysteresis, Weights};
use arithmetic::Unwatched;
use arithmetic::random::generator;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::Rng;

/// A number below `end`.
fn below(random: &mut ChaCha8Rng, end: u64) -> u64 {
    random.next_u64() % end
}

/// Birds of which only those on one side of `apart` are ever linked, and a cycle of networks.
fn random_case(random: &mut ChaCha8Rng) -> (Flock, Vec<Graph>, Vec<Vec<usize>>) {
    let (birds, dimension) = (3 + below(random, 3) as usize, 1 + below(random, 2) as usize);
    let apart = below(random, birds as u64) as usize;
    // Some flocks are so far apart, and so slow, that they meet late.
    let (far, slow) = [(1, 1), (40, 1), (40, 64), (400, 64)][below(random, 4) as usize];
    let mut number = |scale: i64, unit: i64| rational(scale * (below(random, 33) as i64 - 16), 8 * unit);
    let place = |i: usize, number: &mut dyn FnMut(i64, i64) -> Rational| {
        (0..dimension).map(|_| number(if i < apart { far } else { 1 }, 1)).collect::<Vec<_>>()
    };
    let positions = (0..birds).map(|i| place(i, &mut number)).collect();
    let velocities = (0..birds).map(|_| (0..dimension).map(|_| number(1, slow)).collect()).collect();
    let cycle: Vec<Graph> = (0..2 + below(random, 2))
        .map(|_| {
            let links = random.next_u64();
            Graph::from_fn(birds, |i, j| (i < apart) == (j < apart) && links >> (i * birds + j) & 1 == 1)
        })
        .collect();
    let union = Graph::from_fn(birds, |i, j| cycle.iter().any(|network| network.has_edge(i, j)));
    let start = Start { positions, velocities, weights: Weights::Lazy, hysteresis: Hysteresis::None };
    (Flock::new(&start).unwrap(), cycle, union.components())
}

fn minus(rows: &[Vec<Rational>], i: usize, j: usize) -> Vec<Rational> {
    rows[i].iter().zip(&rows[j]).map(|(x, y)| x - y).collect()
}

fn square(x: &[Rational]) -> Rational {
    x.iter().map(|x| x * x).sum()
}

/// The most rounds that a meeting is waited for.
const MOST: u64 = 24;

#[test]
fn rounds_of_a_cycle_go_where_they_are_said_to_go() {
    let mut seen = [0; 6];
    for case in 0..160 {
        let (mut flock, cycle, parts) = random_case(&mut generator("rounds", "cycle", case));
        let networks: Vec<&Graph> = cycle.iter().collect();
        let rounds = Rounds::new(&flock, &networks, &parts, &Unwatched).unwrap();
        let part = |i: usize| parts.iter().position(|part| part.contains(&i)).unwrap();
        let pairs: Vec<(usize, usize)> = (0..flock.birds()).flat_map(|j| (0..j).map(move |i| (i, j))).collect();
        for k in 0..=40u64 {
            let positions = flock.positions();
            for &(i, j) in &pairs {
                let (place, drift) = (minus(&rounds.place, i, j), minus(&rounds.drift, i, j));
                let difference = minus(&positions, i, j);
                let expected = place.iter().zip(&drift).map(|(a, b)| a + b * rational(k as i64, 1));
                let transient: Rational = difference.iter().zip(expected).map(|(x, y)| (x - y).abs()).sum();
                let (f, g) = (part(i), part(j));
                let share = |f: usize| &rounds.size[f] * rational(2, 1).pow(-((k / rounds.halving[f]) as i32));
                let bound = if f == g { share(f) } else { share(f) + share(g) };
                assert!(transient <= bound, "case {case}, birds {i} and {j}, round {k}: {transient} {bound}");
                let near = square(&difference) <= rational(1, 1);
                match rounds.long_run(i, j, MOST) {
                    Run::Keeps { near: said, rounds } if k >= rounds => {
                        assert_eq!(near, said, "case {case}, birds {i} and {j}, round {k} of {rounds}");
                        seen[usize::from(said)] += 1;
                    }
                    Run::Keeps { .. } => {}
                    Run::Tie => {
                        assert!(drift.iter().all(Rational::is_zero) && square(&place) == rational(1, 1));
                        seen[2] += 1;
                    }
                    Run::Meet => seen[3] += 1,
                    Run::MeetLater => {
                        // Far from one another when it is no more waited for, and still coming nearer.
                        let ahead: Rational =
                            place.iter().zip(&drift).map(|(a, b)| (a + b * rational(MOST as i64, 1)) * b).sum();
                        assert!(ahead.is_negative());
                        assert!(k != MOST || !near, "case {case}, birds {i} and {j}");
                        seen[4] += 1;
                    }
                    Run::Approach { from, to } => {
                        assert!(!(from..=to).contains(&k) || !near, "case {case}, birds {i} and {j}, round {k}");
                        // It ends when they are about to be near, but for small transients, or are not waited for.
                        let then: Vec<Rational> =
                            place.iter().zip(&drift).map(|(a, b)| a + b * rational(to as i64 + 1, 1)).collect();
                        let past = then.iter().zip(&drift).map(|(x, b)| x * b).sum::<Rational>().is_positive();
                        assert!(to == MOST || past || square(&then) < rational(1025, 1024));
                        seen[5] += 1;
                    }
                }
            }
            cycle.iter().for_each(|network| flock.step_on(network).unwrap());
        }
    }
    assert!(seen.iter().enumerate().all(|(kind, &count)| count > 0 || kind == 2), "{seen:?}");
}
