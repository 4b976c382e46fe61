//! What `simulate` shows of every model, kind of network and direction, against a naive second way: the law summed arc by arc.

mod discrete;
mod laws;
mod naive;
mod networks;

use super::{Invariant, OrFails, Stop, require};
use crate::draws::Draws;
use arithmetic::Unwatched;
use scenario::{End, ExactMotion, Scenario};

pub(super) const TABLE: &[Invariant] = &[
    Invariant {
        id: "simulate.phase",
        statement: "The phases that simulate shows are those of the law summed arc by arc, up to 1e-7: every network and direction, replaced links, a reference, \
                    gains for each harmonic.",
        control: "the reference takes a network of N(N-1)/2 arcs for all-to-all",
        block: 20,
        check: laws::phase,
    },
    Invariant {
        id: "simulate.particles",
        statement: "The particles that simulate shows move by the law summed arc by arc, up to 1e-7: every network and direction, distances and the \
                    nearest too.",
        control: "the reference takes every arc for an edge",
        block: 20,
        check: laws::particles,
    },
    Invariant {
        id: "simulate.velocity_alignment",
        statement: "The agents that simulate shows align their velocities by the law summed arc by arc, up to 1e-7, on fixed, replaced and distance-switched links.",
        control: "the reference forgets the first arc",
        block: 20,
        check: laws::velocities,
    },
    Invariant {
        id: "simulate.heading_alignment",
        statement: "The agents that simulate shows align their headings by the law summed arc by arc, up to 1e-7, on fixed, replaced and distance-switched links.",
        control: "the reference forgets the first arc",
        block: 20,
        check: laws::headings,
    },
    Invariant {
        id: "simulate.platoon",
        statement: "The cars that simulate shows follow the mean of those that they track, up to 1e-7, whichever car leads, on every network and direction, and \
                    last_deviation is that of car N from the leader.",
        control: "every car of the reference compares itself with the first one that it tracks",
        block: 20,
        check: laws::platoon,
    },
    Invariant {
        id: "simulate.vicsek",
        statement: "The birds that simulate shows average with the weights 1/(d_i + 1) over those within the radius, from velocities and from headings, up to 1e-7.",
        control: "a bird of the reference does not count itself where it has neighbours",
        block: 40,
        check: discrete::vicsek,
    },
    Invariant {
        id: "simulate.fish",
        statement: "The fish that simulate shows steer by (27) or (28) summed over those that they see in each zone, up to 1e-7.",
        control: "the fish of the reference see behind themselves, too",
        block: 40,
        check: discrete::fish,
    },
];

/// What step control, rounding and the naive run may add up to.
const SLACK: f64 = 1e-7;

/// The numbers of the last row: positions, velocities, phases; and an observable.
struct Shown {
    list: Vec<f64>,
    last_deviation: Option<f64>,
}

/// Runs a scenario to its end.
fn simulated(text: &str) -> Result<Shown, Stop> {
    let fails = |why: String| Stop::Fails { why, instance: text.to_string() };
    let scenario = Scenario::read(text).map_err(|error| fails(error.to_string()))?;
    let outcome = scenario.run(&Unwatched);
    if let End::Failed(error) = &outcome.end {
        return Err(fails(error.to_string()));
    }
    let row = outcome.rows.last().ok_or_else(|| fails("it shows nothing".to_string()))?;
    let frame = &row.frame;
    let places = frame.positions.iter().chain(&frame.velocities).flatten().chain(&frame.phases);
    let last = row.observables.iter().find(|observable| observable.name == "last_deviation");
    Ok(Shown { list: places.copied().collect(), last_deviation: last.and_then(number) })
}

/// An observable that is one number.
fn number(observable: &scenario::Observable) -> Option<f64> {
    match observable.value {
        scenario::Value::Number(x) => Some(x),
        _ => None,
    }
}

/// Requires that two lists agree.
fn agree(shown: &[f64], naive: &[f64], text: &str) -> Result<(), Stop> {
    let same = |(a, b): (&f64, &f64)| (a - b).abs() <= SLACK * b.abs().max(1.0);
    let agree = shown.len() == naive.len() && shown.iter().zip(naive).all(same);
    require(agree, format!("simulate shows {shown:?}, the sum over arcs gives {naive:?}"), || text.to_string())
}

/// Requires that the motion that is enclosed has the same arcs.
fn exact_arcs(text: &str, arcs: &[naive::Arc]) -> Result<(), Stop> {
    let mut found = match ExactMotion::read(text).or_fails("it is refused where it is to be enclosed")? {
        ExactMotion::Phases { network, .. } | ExactMotion::Particles { network, .. } => network.arcs().collect(),
        ExactMotion::Velocities { pairs, radius: None, .. } => {
            pairs.iter().flat_map(|&(i, j)| [(i, j), (j, i)]).collect::<Vec<_>>()
        }
        _ => return Ok(()),
    };
    found.sort_unstable();
    let mut wanted = arcs.to_vec();
    wanted.sort_unstable();
    require(found == wanted, format!("{found:?} are enclosed, and not {wanted:?}"), || text.to_string())
}

/// Some numbers in eighths as a list of TOML, and as floats.
fn eighths(numbers: &[i64]) -> (String, Vec<f64>) {
    let texts: Vec<String> = numbers.iter().map(|x| format!("\"{x}/8\"")).collect();
    (format!("[{}]", texts.join(", ")), numbers.iter().map(|x| *x as f64 / 8.0).collect())
}

/// Places in the plane, no two nearer than 5/8: a row of a list of TOML for each agent, and the floats one after the other.
fn places(draws: &mut Draws, agents: usize) -> (String, Vec<f64>) {
    let mut squares: Vec<usize> = (0..16).collect();
    let mut rows = Vec::new();
    let mut all = Vec::new();
    for _ in 0..agents {
        let place = squares.remove(draws.below(squares.len() as u64) as usize);
        let mut part = |base: usize| 8 * base as i64 + draws.below(4) as i64;
        let (text, numbers) = eighths(&[part(place % 4), part(place / 4)]);
        rows.push(text);
        all.extend(numbers);
    }
    (format!("[{}]", rows.join(", ")), all)
}

/// A number in eighths, its size at most that many.
fn signed(draws: &mut Draws, most: u64) -> i64 {
    crate::strategies::integer(draws, most)
}
