//! A platoon on any communication graph, with gains for each car: its peak, stability, margins and state matrices.

use super::super::{CliError, output, progress, spectrum};
use super::peak::Found;
use super::{Arguments, followers};
use flockproof::arithmetic::{ArithmeticError, Interval, Rational, Unwatched, decimals};
use flockproof::graph::AnyGraph;
use flockproof::matrix::RationalMatrix;
use flockproof::platoon::gain_margin::{GainMargin, gain_margin};
use flockproof::platoon::growth::peak_of_car;
use flockproof::platoon::phase_margin::{PhaseMargin, STEPS, phase_margin};
use flockproof::platoon::vector_form::motion_rows_of_cars;
use flockproof::platoon::{Communication, CommunicationGraph, Gains, MOST_FOLLOWERS_PROVED, peak_on_graph};
use flockproof::report::{NamedMatrix, Provenance, matrix_files};
use num_traits::{Signed, ToPrimitive};
use serde_json::{Value, json};
use std::path::Path;
use std::process::ExitCode;

/// Most followers: a response costs their number times the square of how far they look.
const MOST: u64 = 2000;
/// Digits of margins.
const DIGITS: u32 = 15;

/// A platoon with the car that is looked at.
pub(super) struct Platoon {
    pub graph: CommunicationGraph,
    pub car: usize,
    /// What the leader and the car are called.
    leader: String,
    name: String,
    file: Option<Value>,
    /// For a line of cars, whom they track.
    line: Option<Communication>,
}

impl Platoon {
    /// Whether peaks are proved for so many followers.
    pub fn is_proved(&self) -> bool {
        self.graph.followers() <= MOST_FOLLOWERS_PROVED
    }
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
    Ok(Platoon { graph, car, leader: "0".to_string(), name: car.to_string(), file: None, line: Some(communication) })
}

/// The platoon of a named graph or of a file.
fn on_a_graph(arguments: &Arguments) -> Result<Platoon, CliError> {
    if arguments.followers.is_some() {
        let why = "--followers is for the graphs front and front-and-back; this one tells how many there are";
        return Err(CliError::Use(why.to_string()));
    }
    let path = Path::new(&arguments.graph);
    let (weighted, labels, file) = match arguments.graph.parse::<AnyGraph>() {
        Ok(_) if arguments.zero_based => return Err(spectrum::zero_based_name(&arguments.graph)),
        Ok(found) => (found.weighted(), None, None),
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
    let graph =
        CommunicationGraph::behind(&weighted, leader).map_err(|error| CliError::Use(format!("--graph: {error}")))?;
    let place = car + usize::from(car < leader);
    Ok(Platoon { graph, car: place, leader: called(leader), name: called(car), file, line: None })
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

/// The peak of the car: with proof, or searched among more followers.
pub(super) fn response(platoon: &Platoon, gains: &[Gains<Rational>], digits: u32) -> Result<Found, CliError> {
    if !platoon.graph.reached_by_leader()[platoon.car] {
        let (leader, car) = (&platoon.leader, &platoon.name);
        return Err(CliError::Use(format!("the leader {leader} does not reach car {car}, which stays at rest")));
    }
    let followers = platoon.graph.followers();
    if platoon.is_proved() {
        return Found::proved(peak_on_graph(&platoon.graph, gains, platoon.car, digits, &Unwatched));
    }
    let refuse = |error: ArithmeticError| CliError::Use(format!("no peak was found: {error}"));
    let found = peak_of_car(&platoon.graph, &floats(gains), platoon.car).map_err(refuse)?;
    let peak = found.ok_or_else(|| {
        CliError::Use("a mode is too slow for floats, or some followers are not reached by the leader".to_string())
    })?;
    let how = format!(
        "48 frequencies for each factor of 10 and around the slowest mode, in floating point ({followers} followers are more than the {MOST_FOLLOWERS_PROVED} \
         of which the peak is proved)"
    );
    Ok(Found::Searched { peak, how })
}

/// Whether a line of cars is stable, as the paper proves for negative gains: behind the front car alone, or with equal gains (Lemma 1).
fn is_stable_line(platoon: &Platoon, gains: &[Gains<Rational>]) -> Option<bool> {
    match platoon.line? {
        Communication::Front => Some(true),
        Communication::FrontAndBack => gains.iter().all(|other| *other == gains[0]).then_some(true),
    }
}

/// How far a stable platoon is from instability.
struct Margins {
    phase: PhaseMargin,
    gain: GainMargin,
}

impl Margins {
    fn of(reduced: &RationalMatrix, gains: &[Gains<Rational>]) -> Option<Self> {
        Some(Margins { phase: phase_margin(reduced, gains).ok()?, gain: gain_margin(reduced, gains).ok()? })
    }

    fn document(&self) -> Value {
        let of =
            |x: &Option<Interval>| x.as_ref().map(|x| decimals(x, DIGITS)).map(|(lo, hi)| json!({"lo": lo, "hi": hi}));
        let gain = match &self.gain {
            GainMargin::Infinite => json!({"decided": true, "below": null, "above": null, "why": null}),
            GainMargin::Ends { below, above } => {
                json!({"decided": true, "below": of(below), "above": of(above), "why": null})
            }
            GainMargin::Open(why) => json!({"decided": false, "below": null, "above": null, "why": why}),
        };
        let critical = match &self.gain {
            GainMargin::Ends { below: Some(k), .. } => Some(format!("~{:?}", k.to_f64())),
            _ => None,
        };
        let phase = match &self.phase {
            PhaseMargin::Enclosed(x) => {
                let (lo, hi) = decimals(x, DIGITS);
                json!({"decided": true, "lo": lo, "hi": hi, "why": null})
            }
            PhaseMargin::AtMost(x) => {
                json!({"decided": false, "lo": null, "hi": decimals(x, DIGITS).1, "why": searched()})
            }
            PhaseMargin::Open(why) => json!({"decided": false, "lo": null, "hi": null, "why": why}),
        };
        json!({"phase": phase, "critical_factor": critical, "gain": gain})
    }

    fn text(&self) -> String {
        let phase = match &self.phase {
            PhaseMargin::Enclosed(x) => format!("{:.6} rad", x.to_f64()),
            PhaseMargin::AtMost(x) => format!("at most {:.6} rad ({})", x.to_f64(), searched()),
            PhaseMargin::Open(why) => format!("not decided ({why})"),
        };
        let gain = match &self.gain {
            GainMargin::Infinite => "infinite: stable whatever factor the gains are multiplied by".to_string(),
            GainMargin::Ends { below, above } => {
                let ends = [below, above].into_iter().flatten().map(|k| format!("{:.6}", k.to_f64()));
                let ends = ends.collect::<Vec<_>>().join(" or ");
                format!("stability ends where the gains are multiplied by {ends}")
            }
            GainMargin::Open(why) => format!("not decided ({why})"),
        };
        format!("phase margin: {phase}\ngain margin: {gain}\n")
    }
}

/// What a phase margin that is only a bound from above rests on.
fn searched() -> String {
    format!("a search: stable at all smaller multiples of pi/{STEPS}, not proved between them")
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

pub fn run(arguments: &Arguments, given: &[Gains<Rational>]) -> Result<ExitCode, CliError> {
    let platoon = platoon(arguments)?;
    let gains = of_cars(given, platoon.graph.followers())?;
    arguments.export.as_deref().map_or(Ok(()), output::make_folder)?;
    let bar = progress::spinner("searching the peak");
    let found = response(&platoon, &gains, arguments.digits);
    bar.finish_and_clear();
    let found = found?;
    let reduced = platoon.graph.reduced_laplacian().map_err(|error| CliError::Use(error.to_string()))?;
    let stable = found.stable().or_else(|| is_stable_line(&platoon, &gains));
    // What is not stable has no margins.
    let margins = if stable == Some(true) { Margins::of(&reduced, &gains) } else { None };
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
        output::print_json(&provenance.stamp(json!({
            "graph": arguments.graph, "followers": gains.len(), "from": platoon.leader, "to": platoon.name, "f": f, "g": g,
            "peak": found.document(arguments.digits),
            "stable": stable,
            "margins": margins.as_ref().map(Margins::document),
        })))?;
        return Ok(ExitCode::SUCCESS);
    }
    let (followers, graph) = (gains.len(), &arguments.graph);
    let followers = output::counted(followers, "follower");
    let head = format!("{followers} on {graph}, leader {}, car {}", platoon.leader, platoon.name);
    let mut text = found.text(&head, arguments.digits, stable);
    text += &margins.map_or(String::new(), |margins| margins.text());
    output::print_folded(&text)?;
    Ok(ExitCode::SUCCESS)
}
