//! A platoon on any communication graph, with gains for each car: its peak, stability, margins and state matrices.

use super::super::{CliError, output, progress, spectrum};
use super::{Arguments, followers};
use flockproof::arithmetic::{ArithmeticError, Complex, Interval, Rational, decimals};
use flockproof::graph::{NamedGraph, WeightedGraph};
use flockproof::matrix::{RationalMatrix, SparseMatrix};
use flockproof::platoon::growth::peak_of_car;
use flockproof::platoon::margins::{Margins, margins, margins_of_cars};
use flockproof::platoon::observe::Extreme;
use flockproof::platoon::vector_form::{self, motion_rows_of_cars};
use flockproof::platoon::{Communication, CommunicationGraph, Gains};
use flockproof::report::{NamedMatrix, Provenance, matrix_files};
use flockproof::spectrum::matrix_spectrum;
use num_traits::{Signed, ToPrimitive};
use serde_json::{Value, json};
use std::path::Path;
use std::process::ExitCode;

/// Most followers: a response costs their number times the square of how far they look.
const MOST: u64 = 2000;
/// Most followers of which the amplitude is enclosed; the cost grows like their cube.
const MOST_ENCLOSED: usize = 64;
/// Most followers of which stability is decided exactly.
const MOST_EXACT: usize = 20;
/// Most followers of which the margins are computed.
const MOST_MARGINS: usize = 400;
/// Most followers with gains of their own of which the margins are computed.
const MOST_OWN_MARGINS: usize = 12;
/// Bits of enclosures.
const PRECISION: u32 = 192;

/// A platoon with the car that is looked at.
pub(super) struct Platoon {
    pub graph: CommunicationGraph,
    pub car: usize,
    /// What the leader and the car are called.
    leader: String,
    name: String,
    file: Option<Value>,
}

/// The platoon of the arguments.
pub(super) fn platoon(arguments: &Arguments) -> Result<Platoon, CliError> {
    let communication = match arguments.graph.as_str() {
        "front" => Communication::Front,
        "front-and-back" => Communication::FrontAndBack,
        _ => return on_a_graph(arguments),
    };
    if arguments.zero_based {
        return Err(spectrum::zero_based_name(&arguments.graph));
    }
    let count = followers(arguments)?;
    if count > MOST {
        return Err(CliError::Use(format!(
            "--followers {count}: without a certificate, for --graph {}, single cars or gains for each, at most {MOST}",
            arguments.graph
        )));
    }
    if arguments.from.as_deref().is_some_and(|from| !["leader", "0"].contains(&from)) {
        return Err(CliError::Use(format!("--from: the leader of --graph {} is in front", arguments.graph)));
    }
    let refuse = |error: &dyn std::fmt::Display| CliError::Use(format!("--followers: {error}"));
    let graph = CommunicationGraph::of(communication, count as usize).map_err(|error| refuse(&error))?;
    let to = arguments.to.as_deref();
    let car = to.map_or(Some(graph.followers()), |word| word.parse().ok());
    let car = car.filter(|car| (1..=graph.followers()).contains(car));
    let car = car.ok_or_else(|| CliError::Use(format!("--to: there are the followers 1 to {count}")))?;
    Ok(Platoon { graph, car, leader: "0".to_string(), name: car.to_string(), file: None })
}

/// The platoon of a named graph or of a file.
fn on_a_graph(arguments: &Arguments) -> Result<Platoon, CliError> {
    if arguments.followers.is_some() {
        let why = "--followers is for the graphs front and front-and-back; this one tells how many there are";
        return Err(CliError::Use(why.to_string()));
    }
    let path = Path::new(&arguments.graph);
    let (weighted, labels, file) = match arguments.graph.parse::<NamedGraph>() {
        Ok(_) if arguments.zero_based => return Err(spectrum::zero_based_name(&arguments.graph)),
        Ok(named) => {
            let built = named.build().map_err(|error| CliError::Use(format!("--graph: {error}")))?;
            (built, None, None)
        }
        Err(_) if path.exists() || arguments.graph == "-" => {
            let (file, origin) = spectrum::read_file(path, arguments.zero_based)?;
            (file.graph, file.labels, Some(origin))
        }
        Err(error) => {
            return Err(CliError::Use(format!("--graph: neither front, front-and-back nor a file, and {error}")));
        }
    };
    let order = weighted.order();
    let called = |vertex: usize| labels.as_ref().map_or((vertex + 1).to_string(), |labels| labels[vertex].clone());
    let vertex = |option: &str, word: &str| {
        let found = (0..order).find(|&vertex| called(vertex) == word);
        found.ok_or_else(|| CliError::Use(format!("--{option}: there is no vertex {word} among the {order}")))
    };
    let usual = (0..order).find(|&vertex| called(vertex) == "leader").unwrap_or(0);
    let leader = arguments.from.as_deref().map_or(Ok(usual), |word| vertex("from", word))?;
    let last = (0..order).rev().find(|&vertex| vertex != leader).unwrap_or(leader);
    let car = arguments.to.as_deref().map_or(Ok(last), |word| vertex("to", word))?;
    if car == leader {
        return Err(CliError::Use(format!("--to: vertex {} leads; another one is to be looked at", called(car))));
    }
    if order as u64 > MOST + 1 {
        return Err(CliError::Use(format!("--graph: {order} vertices are more than {}", MOST + 1)));
    }
    let graph = behind(&weighted, leader).map_err(|error| CliError::Use(format!("--graph: {error}")))?;
    let place = car + usize::from(car < leader);
    Ok(Platoon { graph, car: place, leader: called(leader), name: called(car), file })
}

/// Each vertex but the leader follows those that its arcs lead to, weighted to a sum of one.
fn behind(graph: &WeightedGraph, leader: usize) -> Result<CommunicationGraph, flockproof::platoon::CommunicationError> {
    let agent = |vertex: usize| if vertex == leader { 0 } else { vertex + usize::from(vertex < leader) };
    let row = |vertex: usize| {
        let arcs = graph.adjacency().row(vertex);
        let sum: Rational = arcs.iter().map(|(_, weight)| weight).sum();
        // A sum of zero is refused with the weights.
        let share = |weight: &Rational| if sum.is_positive() { weight / &sum } else { weight.clone() };
        arcs.iter().map(|(to, weight)| (agent(*to), share(weight))).collect()
    };
    CommunicationGraph::new((0..graph.order()).filter(|&vertex| vertex != leader).map(row).collect())
}

/// What is known of the response.
pub(super) struct Found {
    pub peak: Extreme,
    /// Encloses the amplitude at the frequency of the peak.
    pub amplitude: Option<(String, String)>,
}

/// One pair of gains for each follower, below zero.
pub(super) fn of_cars(gains: &[Gains<Rational>], followers: usize) -> Result<Vec<Gains<Rational>>, CliError> {
    if gains.len() != 1 && gains.len() != followers {
        let given = gains.len();
        return Err(CliError::Use(format!("there are {given} gains for {followers} followers")));
    }
    for (name, value) in gains.iter().flat_map(|gains| [("f", &gains.f), ("g", &gains.g)]) {
        if !value.is_negative() {
            return Err(CliError::Use(format!("{name} must be negative, but it is {value}")));
        }
    }
    Ok((0..followers).map(|k| gains[k.min(gains.len() - 1)].clone()).collect())
}

fn floats(gains: &[Gains<Rational>]) -> Vec<Gains<f64>> {
    gains.iter().map(|gains| gains.map(|q| q.to_f64().unwrap_or(f64::NAN))).collect()
}

/// The peak of the car, and its amplitude there.
pub(super) fn response(platoon: &Platoon, gains: &[Gains<Rational>], digits: u32) -> Result<Found, CliError> {
    let refuse = |error: ArithmeticError| CliError::Use(format!("no peak was found: {error}"));
    if !platoon.graph.reached_by_leader()[platoon.car] {
        let (leader, car) = (&platoon.leader, &platoon.name);
        return Err(CliError::Use(format!("the leader {leader} does not reach car {car}, which stays at rest")));
    }
    let found = peak_of_car(&platoon.graph, &floats(gains), platoon.car).map_err(refuse)?;
    let peak = found.ok_or_else(|| {
        CliError::Use("a mode is too slow for floats, or some followers are not reached by the leader".to_string())
    })?;
    let enclosed = || -> Option<(String, String)> {
        let w = Interval::from_rational(&Rational::from_float(peak.at)?, PRECISION);
        let gains: Vec<Gains<Interval>> =
            gains.iter().map(|gains| gains.map(|q| Interval::from_rational(q, PRECISION))).collect();
        let all = platoon.graph.response_of_cars(&gains, &w).ok()?;
        let size = all.get(platoon.car - 1)?.norm_squared();
        flockproof::arithmetic::Real::sqrt(&size).ok().map(|size| decimals(&size, digits + 3))
    };
    let small = platoon.graph.followers() <= MOST_ENCLOSED;
    Ok(Found { peak, amplitude: if small { enclosed() } else { None } })
}

/// Whether all motions of the followers behind a resting leader die out; nothing for more than a few followers.
fn is_stable(reduced: &RationalMatrix, gains: &[Gains<Rational>]) -> Option<bool> {
    if gains.len() > MOST_EXACT {
        return None;
    }
    let motion = RationalMatrix::from_rows(&motion_rows_of_cars(reduced, |k| &gains[k])).ok()?;
    vector_form::is_stable(&motion).ok()
}

/// The margins.
fn margins_of(reduced: &RationalMatrix, gains: &[Gains<Rational>]) -> Option<Margins> {
    let equal = gains.iter().all(|other| *other == gains[0]);
    if !equal {
        return if gains.len() <= MOST_OWN_MARGINS { margins_of_cars(reduced, gains).ok() } else { None };
    }
    if gains.len() > MOST_MARGINS {
        return None;
    }
    let spectrum = matrix_spectrum(&SparseMatrix::from_dense(reduced).ok()?, None).ok()?;
    let values: Vec<Complex<f64>> =
        spectrum.eigenvalues.iter().map(|part| Complex::new(part.re.to_f64(), part.im.to_f64())).collect();
    margins(&floats(&gains[..1])[0], &values)
}

/// `x' = A x + B u, y = C x`: the state is `y_1, u_1, y_2, u_2, ..`, the input position and velocity of the leader, the output the
/// position of the car.
fn state_matrices(platoon: &Platoon, reduced: &RationalMatrix, gains: &[Gains<Rational>]) -> Vec<NamedMatrix> {
    let gains = floats(gains);
    let followers = gains.len();
    let column = platoon.graph.leader_column().unwrap_or_default();
    let mut input = vec![vec![0.0; 2]; 2 * followers];
    for (k, weight) in column.iter().enumerate() {
        let weight = weight.to_f64().unwrap_or(f64::NAN);
        input[2 * k + 1] = vec![gains[k].f * weight, gains[k].g * weight];
    }
    let mut output = vec![0.0; 2 * followers];
    output[2 * (platoon.car - 1)] = 1.0;
    let matrix = |name, rows| NamedMatrix { name, rows };
    vec![
        matrix("A", motion_rows_of_cars(reduced, |k| &gains[k])),
        matrix("B", input),
        matrix("C", vec![output]),
        matrix("D", vec![vec![0.0; 2]]),
    ]
}

/// A peak in words, with its enclosed amplitude and stability where they are known.
pub(super) fn peak_text(peak: &Extreme, amplitude: Option<&(String, String)>, stable: Option<bool>) -> String {
    let mut text = format!("peak found in floating point: omega ~ {:?},\n  amplitude ~ {:?}\n", peak.at, peak.value);
    if let Some((lo, hi)) = amplitude {
        text += &format!("amplitude at exactly this omega in [{lo},\n                                   {hi}]\n");
    }
    match stable {
        Some(true) => text += "stable: every motion behind a resting leader dies out (decided exactly)\n",
        Some(false) => text += "NOT stable: some motion behind a resting leader does not die out (decided exactly)\n",
        None => {}
    }
    text
}

pub fn run(arguments: &Arguments, given: &[Gains<Rational>]) -> Result<ExitCode, CliError> {
    let platoon = platoon(arguments)?;
    let gains = of_cars(given, platoon.graph.followers())?;
    arguments.export.as_deref().map_or(Ok(()), output::make_folder)?;
    let bar = progress::spinner("searching the peak");
    let found = response(&platoon, &gains, arguments.digits);
    bar.finish_and_clear();
    let found = found?;
    let reduced = platoon.graph.reduced_laplacian().map_err(|error| CliError::Use(error.to_string()))?;
    let (stable, margins) = (is_stable(&reduced, &gains), margins_of(&reduced, &gains));
    let list =
        |value: fn(&Gains<Rational>) -> &Rational| given.iter().map(|g| value(g).to_string()).collect::<Vec<_>>();
    let (f, g) = (list(|gains| &gains.f), list(|gains| &gains.g));
    let configuration = json!({
        "command": "resonance", "graph": arguments.graph, "file": platoon.file, "zero_based": arguments.zero_based,
        "followers": gains.len(), "from": platoon.leader, "to": platoon.name, "f": f, "g": g, "digits": arguments.digits,
    });
    let provenance = Provenance::new("flockproof.response/1", None, configuration);
    if let Some(folder) = &arguments.export {
        let mut files = matrix_files(&state_matrices(&platoon, &reduced, &gains));
        files.push(flockproof::report::File {
            name: "about.txt".to_string(),
            contents: provenance.about(&[]).into_bytes(),
        });
        files.iter().try_for_each(|file| output::write_file(&folder.join(&file.name), &file.contents))?;
    }
    if arguments.json {
        let amplitude = found.amplitude.as_ref().map(|(lo, hi)| json!({"lo": lo, "hi": hi}));
        output::print_json(&provenance.stamp(json!({
            "graph": arguments.graph, "followers": gains.len(), "from": platoon.leader, "to": platoon.name, "f": f, "g": g,
            "peak": {
                "omega": format!("~{:?}", found.peak.at), "amplitude": format!("~{:?}", found.peak.value),
                "amplitude_at_omega": amplitude, "grade": "simulated",
            },
            "stable": stable,
            "margins": margins.map(|m| json!({
                "phase": m.phase.map(|phase| format!("~{phase:?}")), "critical_factor": m.critical_factor.map(|k| format!("~{k:?}")),
            })),
        })))?;
        return Ok(ExitCode::SUCCESS);
    }
    let (followers, graph) = (gains.len(), &arguments.graph);
    let word = if followers == 1 { "follower" } else { "followers" };
    let mut text = format!("{followers} {word} on {graph}, leader {}, car {}\n", platoon.leader, platoon.name);
    text += &peak_text(&found.peak, found.amplitude.as_ref(), stable);
    if let Some(margins) = margins {
        let factor = margins.critical_factor.map_or("at no common factor of the gains".to_string(), |k| {
            format!("where the gains are multiplied by {k:.6}")
        });
        let phase = margins.phase.map_or("none".to_string(), |phase| format!("~ {phase:.6} rad"));
        text += &format!("phase margin {phase}; on the verge {factor}\n");
    }
    output::print(&text)?;
    Ok(ExitCode::SUCCESS)
}
