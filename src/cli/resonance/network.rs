//! A platoon on any communication graph, with gains for each car: its peak, stability, margins and state matrices.

use super::super::{CliError, output, progress, spectrum};
use super::peak::Found;
use super::responses::Responses;
use super::{Arguments, followers, line_error};
use flockproof::arithmetic::{ArithmeticError, Interval, Rational, Unwatched, decimals};
use flockproof::graph::AnyGraph;
use flockproof::platoon::gain_margin::{GainMargin, gain_margin};
use flockproof::platoon::growth::peak_of_car;
use flockproof::platoon::phase_margin::{PhaseMargin, STEPS, phase_margin};
use flockproof::platoon::state_space::StateSpace;
use flockproof::platoon::{
    Communication, CommunicationGraph, Gains, Line, LineError, MOST_FOLLOWERS_PROVED, Parameter, Peak, Platoon,
    peak_of_platoon, resonance,
};
use flockproof::report::{File, NamedMatrix, Provenance, matrix_files};
use num_traits::ToPrimitive;
use serde_json::{Map, Value, json};
use std::process::ExitCode;

/// Most followers: a response costs their number times the square of how far they look.
const MOST: u64 = 2000;
/// Digits of margins.
const DIGITS: u32 = 15;

/// Whom the followers track.
enum Shape {
    /// On a line: whom, with which weights where they track both sides, and how many followers there are.
    Line(Communication, Line, usize),
    Graph(Line, CommunicationGraph),
}

/// Followers whose gains are still open, and the car that is looked at.
pub(super) struct Looked {
    shape: Shape,
    pub car: usize,
    /// What the leader and the followers are called.
    leader: String,
    names: Vec<String>,
    file: Option<Value>,
}

impl Looked {
    fn followers(&self) -> usize {
        self.names.len()
    }

    /// What the car that is looked at is called.
    fn name(&self) -> &str {
        &self.names[self.car - 1]
    }

    /// Whether peaks are proved for so many followers.
    pub fn is_proved(&self) -> bool {
        self.followers() <= MOST_FOLLOWERS_PROVED
    }

    /// The follower of that name.
    fn place(&self, option: &str, word: &str) -> Result<usize, CliError> {
        let found = self.names.iter().position(|name| name == word).map(|k| k + 1);
        found.ok_or_else(|| match &self.shape {
            Shape::Line(.., count) => CliError::Use(format!("--{option}: there are the followers 1 to {count}")),
            Shape::Graph(..) if word == self.leader => {
                CliError::Use(format!("--{option}: vertex {word} leads; another one is to be looked at"))
            }
            Shape::Graph(_, graph) => {
                let order = graph.followers() + 1;
                CliError::Use(format!("--{option}: there is no vertex {word} among the {order}"))
            }
        })
    }

    /// The cars of `--cars`.
    fn cars(&self, arguments: &Arguments) -> Result<Vec<usize>, CliError> {
        let Some(text) = &arguments.cars else { return Ok(vec![self.car]) };
        text.split(',').map(|word| self.place("cars", word.trim())).collect()
    }

    /// The platoon with the gains of `line`.
    pub fn steered(&self, line: &Line) -> Result<Platoon<Rational>, CliError> {
        let with_gains = |weights: &Line| {
            let gains = [Parameter::F, Parameter::G].into_iter();
            gains.fold(weights.clone(), |all, gain| all.with(gain, line.get(gain).unwrap_or_default().to_vec()))
        };
        let built = match &self.shape {
            Shape::Line(Communication::FrontAndBack, weights, followers) => with_gains(weights).platoon(*followers),
            Shape::Line(communication, weights, followers) => CommunicationGraph::of(*communication, *followers)
                .map_err(LineError::from)
                .and_then(|graph| with_gains(weights).on(graph)),
            Shape::Graph(weights, graph) => with_gains(weights).on(graph.clone()),
        };
        built.map_err(|error| line_error(&error))
    }

    /// The peak of a car: with proof, or searched among more followers.
    pub fn peak(&self, platoon: &Platoon<Rational>, car: usize, digits: u32) -> Result<Found, CliError> {
        if !platoon.reached_by_leader()[car] {
            let (leader, car) = (&self.leader, &self.names[car - 1]);
            return Err(CliError::Use(format!("the leader {leader} does not reach car {car}, which stays at rest")));
        }
        let followers = platoon.followers();
        if self.is_proved() {
            return Found::proved(peak_of_platoon(platoon, car, digits, &Unwatched));
        }
        if let Some(gains) = two_sided(platoon).filter(|_| car == followers) {
            let found = resonance(gains, followers as u64, digits).map_err(|error| CliError::Use(error.to_string()))?;
            return Ok(Found::Certified(Peak { omega: Some(found.omega), amplitude: found.amplitude }));
        }
        let refuse = |error: ArithmeticError| CliError::Use(format!("no peak was found: {error}"));
        let floats = platoon.map(|q| q.to_f64().unwrap_or(f64::NAN));
        let peak = peak_of_car(&floats, car).map_err(refuse)?.ok_or_else(|| {
            CliError::Use("a mode is too slow for floats, or some followers are not reached by the leader".to_string())
        })?;
        let how = format!(
            "48 frequencies for each factor of 10 and around the slowest mode, in floating point ({followers} followers are more than the \
             {MOST_FOLLOWERS_PROVED} of which the peak is proved)"
        );
        Ok(Found::Searched { peak, how })
    }

    /// Whether a line of cars is stable, which is known for negative gains in two cases. Behind the front car alone each car is a loop of its own. With
    /// equal gains and positions and velocities tracked alike (Lemma 1 of the paper is the case of equal weights): the reduced Laplacian is tridiagonal,
    /// with entries beside the diagonal of which no two opposite ones have different signs, so that its eigenvalues are real, and positive where the
    /// leader reaches all cars.
    fn is_stable_line(&self, platoon: &Platoon<Rational>) -> Option<bool> {
        let Shape::Line(..) = &self.shape else { return None };
        let in_front = |(k, agent): (usize, usize)| agent < k;
        let alone = platoon.links().into_iter().all(in_front);
        let equal =
            platoon.with_equal_gains().is_some() && platoon.reached_by_leader().into_iter().all(|reached| reached);
        (alone || equal).then_some(true)
    }

    /// What `--response` and `--plot` show, with the peaks of all their cars where a diagram marks them; `known` is that of the car that is looked at.
    fn responses<'a>(
        &self,
        arguments: &Arguments,
        platoon: &'a Platoon<Rational>,
        cars: &'a [usize],
        known: &Found,
    ) -> Result<Responses<'a>, CliError> {
        let (mut peaks, mut proved) = (Vec::new(), true);
        for &car in cars.iter().filter(|_| arguments.plot.is_some()) {
            let own = if car == self.car { None } else { Some(self.peak(platoon, car, 15)?) };
            let found = own.as_ref().unwrap_or(known);
            proved &= matches!(found, Found::Certified(_));
            peaks.extend(found.place());
        }
        let enclosed = move |w: &Rational, digits: u32| {
            let all = platoon.enclosed_response(w, digits)?;
            Ok(cars.iter().map(|car| all[car - 1].clone()).collect())
        };
        Ok(Responses {
            names: cars.iter().map(|car| self.names[car - 1].clone()).collect(),
            enclosed: if self.is_proved() { Some(Box::new(enclosed)) } else { None },
            float: Box::new(platoon.float_response(cars)),
            peaks,
            proved,
            stable: known.stable(),
        })
    }
}

/// The gains of a platoon in which all track the cars in front and behind alike.
fn two_sided(platoon: &Platoon<Rational>) -> Option<&Gains<Rational>> {
    let (graph, gains) = platoon.with_equal_gains()?;
    let line = CommunicationGraph::of(Communication::FrontAndBack, graph.followers()).ok()?;
    (line == *graph).then_some(gains)
}

/// The followers of the arguments.
pub(super) fn looked(arguments: &Arguments) -> Result<Looked, CliError> {
    let communication = match arguments.graph.as_str() {
        "front" => Communication::Front,
        "front-and-back" => Communication::FrontAndBack,
        _ => return on_a_graph(arguments),
    };
    if arguments.zero_based {
        return Err(spectrum::zero_based_name(&arguments.graph));
    }
    let weights = arguments.line()?;
    let count = followers(arguments)?;
    if count > MOST {
        return Err(CliError::Use(format!(
            "--followers {count}: without a certificate, for --graph {}, single cars, weights or gains for each, at most {MOST}",
            arguments.graph
        )));
    }
    if arguments.from.as_deref().is_some_and(|from| !["leader", "0"].contains(&from)) {
        return Err(CliError::Use(format!("--from: the leader of --graph {} is in front", arguments.graph)));
    }
    let count = count as usize;
    if count == 0 {
        return Err(CliError::Use("--followers: a platoon needs at least one follower".to_string()));
    }
    let names = (1..=count).map(|car| car.to_string()).collect();
    let shape = Shape::Line(communication, weights, count);
    let mut looked = Looked { shape, car: count, leader: "0".to_string(), names, file: None };
    if let Some(word) = arguments.to.as_deref() {
        looked.car = looked.place("to", word)?;
    }
    Ok(looked)
}

/// The platoon of a named graph or of a file.
fn on_a_graph(arguments: &Arguments) -> Result<Looked, CliError> {
    if arguments.followers.is_some() {
        let why = "--followers is for the graphs front and front-and-back; this one tells how many there are";
        return Err(CliError::Use(why.to_string()));
    }
    let path = spectrum::named_file(&arguments.graph);
    let (weighted, labels, file) = match arguments.graph.parse::<AnyGraph>() {
        Ok(_) if arguments.zero_based => return Err(spectrum::zero_based_name(&arguments.graph)),
        Ok(found) => (found.weighted(), None, None),
        Err(_) if path.exists() || arguments.graph == "-" || arguments.graph.starts_with("file:") => {
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
    if order as u64 > MOST + 1 {
        return Err(CliError::Use(format!("--graph: {order} vertices are more than {}", MOST + 1)));
    }
    let graph =
        CommunicationGraph::behind(&weighted, leader).map_err(|error| CliError::Use(format!("--graph: {error}")))?;
    let names: Vec<String> = (0..order).filter(|&vertex| vertex != leader).map(called).collect();
    let mut looked =
        Looked { car: names.len(), shape: Shape::Graph(arguments.line()?, graph), leader: called(leader), names, file };
    if let Some(word) = arguments.to.as_deref() {
        looked.car = looked.place("to", word)?;
    }
    Ok(looked)
}

/// How far a stable platoon is from instability.
struct Margins {
    phase: PhaseMargin,
    gain: GainMargin,
}

impl Margins {
    fn of(platoon: &Platoon<Rational>) -> Option<Self> {
        let Some(graph) = platoon.one_graph() else {
            let open = || "velocities are tracked with other weights than positions".to_string();
            return Some(Margins { phase: PhaseMargin::Open(open()), gain: GainMargin::Open(open()) });
        };
        let (reduced, gains) = (graph.reduced_laplacian().ok()?, platoon.gains());
        Some(Margins { phase: phase_margin(&reduced, gains).ok()?, gain: gain_margin(&reduced, gains).ok()? })
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

/// `x' = A x + B u, y = C x`: the state is `y_1, u_1, y_2, u_2, ..`, the inputs position and velocity of the leader, the output the
/// position of the car; as matrices, and what their rows and columns are called. With the shapes of the matrices in words.
fn state_files(looked: &Looked, platoon: &Platoon<Rational>) -> Result<(Vec<File>, String), CliError> {
    let refuse = |error: &dyn std::fmt::Display| CliError::Use(error.to_string());
    let system = StateSpace::of_platoon(platoon, looked.car).map_err(|error| refuse(&error))?;
    let float = |row: Vec<Rational>| row.iter().map(|q| q.to_f64().unwrap_or(f64::NAN)).collect();
    let matrices = ["A", "B", "C", "D"].into_iter().zip(system.matrices());
    let matrices = matrices.map(|(name, rows)| NamedMatrix { name, rows: rows.into_iter().map(float).collect() });
    let matrices: Vec<NamedMatrix> = matrices.collect();
    let shape =
        |own: &NamedMatrix| format!("{} ({} x {})", own.name, own.rows.len(), own.rows.first().map_or(0, Vec::len));
    let shapes = matrices.iter().map(shape).collect::<Vec<_>>().join(", ");
    let mut files = matrix_files(&matrices);
    let names = json!({
        "states": looked.names.iter().flat_map(|car| [format!("y_{car}"), format!("u_{car}")]).collect::<Vec<_>>(),
        "inputs": [format!("y_{}", looked.leader), format!("u_{}", looked.leader)],
        "outputs": [format!("y_{}", looked.name())],
        "about": INPUTS,
    });
    files.push(File { name: "names.json".to_string(), contents: format!("{names:#}\n").into_bytes() });
    Ok((files, shapes))
}

/// What the columns of `B` are, which a reader of the matrices has to know.
const INPUTS: &str = "y is a deviation from the desired position, u = y' its rate. The inputs are the position and the velocity of the leader; for a leader e^(iwt) \
the velocity is iw times the position, so that the response is that of the first input plus iw times that of the second. The first input alone has another peak.";

/// The numbers that were given, by their names.
fn given(line: &Line) -> Map<String, Value> {
    let texts = |list: &[Rational]| Value::from(list.iter().map(ToString::to_string).collect::<Vec<_>>());
    let entry = |(name, parameter): &(&str, Parameter)| Some((name.to_string(), texts(line.get(*parameter)?)));
    Parameter::NAMES.iter().filter_map(entry).collect()
}

/// The weights in words, where there are any.
fn weights(line: &Line) -> String {
    let words = |(name, parameter): &(&str, Parameter)| {
        let list = line.get(*parameter).filter(|_| parameter.is_of_a_side())?;
        let name = name.replace('_', " ");
        Some(match list {
            [one] => format!("{name} {one}"),
            several => {
                let (least, largest) = (several.iter().min()?, several.iter().max()?);
                format!("{} {name} (least {least}, largest {largest})", several.len())
            }
        })
    };
    let all: Vec<String> = Parameter::NAMES.iter().filter_map(words).collect();
    if all.is_empty() {
        return String::new();
    }
    let gains = [Parameter::F, Parameter::G].iter().any(|whole| line.get(*whole).is_none());
    format!(
        "{}: {}{}\n",
        if gains { "weights or gains of links" } else { "weights" },
        all.join(", "),
        if gains { "" } else { ", scaled to a sum of one for each car" }
    )
}

pub fn run(arguments: &Arguments, line: &Line) -> Result<ExitCode, CliError> {
    let looked = looked(arguments)?;
    let (platoon, cars) = (looked.steered(line)?, looked.cars(arguments)?);
    arguments.export.as_deref().map_or(Ok(()), output::make_folder)?;
    let bar = progress::spinner("searching the peak");
    let found = looked.peak(&platoon, looked.car, arguments.digits);
    bar.finish_and_clear();
    let found = found?;
    let responses = looked.responses(arguments, &platoon, &cars, &found)?;
    let stable = found.stable().or_else(|| looked.is_stable_line(&platoon));
    // What is not stable has no margins.
    let margins = if stable == Some(true) { Margins::of(&platoon) } else { None };
    let mut given = given(line);
    let [f, g] = ["f", "g"].map(|name| given.remove(name).unwrap_or_else(|| json!([])));
    let configuration = json!({
        "command": "resonance", "graph": arguments.graph, "file": looked.file, "zero_based": arguments.zero_based,
        "followers": looked.followers(), "from": looked.leader, "to": looked.name(), "f": f, "g": g, "weights": given,
        "cars": arguments.cars, "response": arguments.response, "digits": arguments.digits,
    });
    let provenance = Provenance::new("flockproof.response/1", None, configuration);
    let mut exported = String::new();
    if let Some(folder) = &arguments.export {
        let (mut files, shapes) = state_files(&looked, &platoon)?;
        files.push(File {
            name: "about.txt".to_string(),
            contents: format!("{}\n{INPUTS}\n", provenance.about(&[])).into_bytes(),
        });
        files.iter().try_for_each(|file| output::write_file(&folder.join(&file.name), &file.contents))?;
        let folder = folder.display();
        exported =
            format!("written: {folder}: {shapes}, each as .csv, .npy and .mtx, all.mat, names.json, about.txt\n");
    }
    let followers = output::counted(looked.followers(), "follower");
    let title = format!("{followers} on {}, leader {}", arguments.graph, looked.leader);
    let list = |name: &str, list: &Value| match list.as_array().map(Vec::as_slice) {
        Some([one]) => format!("{name} = {}. ", one.as_str().unwrap_or_default()),
        Some([]) | None => String::new(),
        Some(_) => format!("{name} of each car. "),
    };
    let caption = format!("{}{}{}", list("f", &f), list("g", &g), weights(line).trim_end());
    let drawn = responses.draw(arguments, &title, &caption)?;
    let table = responses.table(arguments)?;
    if arguments.json {
        let mut document = json!({
            "graph": arguments.graph, "followers": looked.followers(), "from": looked.leader, "to": looked.name(), "f": f, "g": g,
            "weights": given,
            "peak": found.document(arguments.digits),
            "stable": stable,
            "margins": margins.as_ref().map(Margins::document),
        });
        if let Some((rows, _)) = table {
            document["response"] = rows;
        }
        output::print_json(&provenance.stamp(document))?;
        return Ok(ExitCode::SUCCESS);
    }
    let head = format!("{title}, car {}", looked.name());
    let mut text = found.text(&head, arguments.digits, stable);
    text.insert_str(text.find('\n').map_or(text.len(), |end| end + 1), &weights(line));
    text += &margins.map_or(String::new(), |margins| margins.text());
    text += &table.map_or(String::new(), |(_, table)| table);
    output::print_folded(&(text + &drawn + &exported))?;
    Ok(ExitCode::SUCCESS)
}
