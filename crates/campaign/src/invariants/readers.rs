//! Readers: what is written is read as it was, and no text makes one panic.

use super::{Checked, Invariant, OrFails, Stop, Tested, require, shown};
use crate::draws::Draws;
use crate::strategies::{digraph, fraction, list, start, stochastic_sequence};
use algebra::graph::read::read_graph;
use algebra::graph::{AnyGraph, NamedGraph, WeightedGraph};
use algebra::matrix::StochasticMatrix;
use algebra::matrix::read::read_sequence;
use arithmetic::{Rational, decimal, parse_rational, rational};
use models::averaging::read::{Model, read_flock};
use models::averaging::{Hysteresis, Start, Weights};
use models::tracks::{School, Setting, Tracks, synthetic_school};
use question::Question;
use reach::System;
use scenario::Scenario;
use serde_json::json;

pub(super) const TABLE: &[Invariant] = &[
    Invariant {
        id: "read.numbers",
        statement: "A rational is read as it is printed, and its decimals rounded down and up to any digits enclose it within a unit of the last.",
        control: "decimals with one digit less in the last place",
        block: 200,
        check: numbers,
    },
    Invariant {
        id: "read.matrices",
        statement: "A sequence of stochastic matrices is read as it is written, as text and as JSON.",
        control: "the matrices are written in the other order",
        block: 50,
        check: matrices,
    },
    Invariant {
        id: "read.graphs",
        statement: "A weighted digraph is read as it is written, as a list of edges and as Matrix Market.",
        control: "the arcs are written backwards",
        block: 50,
        check: graphs,
    },
    Invariant {
        id: "read.flocks",
        statement: "A flock is read as it is written in JSON.",
        control: "the first two birds are written in the other order",
        block: 50,
        check: flocks,
    },
    Invariant {
        id: "read.tracks",
        statement: "Tracks are read as they are written in CSV, with names and gaps.",
        control: "the first row of the file is left out",
        block: 10,
        check: tracks,
    },
    Invariant {
        id: "read.scenarios",
        statement: "A scenario in TOML with its sections and keys in any order declares the same and starts in the same state.",
        control: "the first number of the file is another one",
        block: 20,
        check: scenarios,
    },
    Invariant {
        id: "read.nonsense",
        statement: "No reader panics on a text with parts left out, repeated, exchanged or replaced; what is refused is refused in one line.",
        control: "the sentence of the refusal is followed by another line",
        block: 20,
        check: nonsense,
    },
];

fn numbers(draws: &mut Draws, tested: Tested) -> Checked {
    let scale = Rational::from_integer(num_bigint::BigInt::from(10).pow(draws.below(30) as u32));
    let number = fraction(draws, 1 << 40, 1 << 20);
    let number = if draws.once_in(2) { number / scale } else { number * scale };
    let digits = draws.between(1, 40) as u32;
    let described = || format!("{number} to {digits} digits");
    let again = parse_rational(&number.to_string()).or_fails("a printed number is refused")?;
    require(again == number, format!("{again} is read"), described)?;
    let mut ends = [false, true].map(|up| decimal(&number, digits, up));
    if tested.is_altered() {
        ends[1] = ends[0].clone();
    }
    let [lo, hi] = [parse_rational(&ends[0]), parse_rational(&ends[1])];
    let (lo, hi) = (lo.or_fails("a decimal is refused")?, hi.or_fails("a decimal is refused")?);
    require(lo <= number && number <= hi, format!("it is not between {} and {}", ends[0], ends[1]), described)?;
    let unit = Rational::from_integer(num_bigint::BigInt::from(10).pow(digits.saturating_sub(1)));
    let size = if number < rational(0, 1) { -number.clone() } else { number.clone() };
    // A unit of the last of so many digits is at most the number over 10^(digits - 1).
    require((&hi - &lo) * unit <= size, format!("{} and {} are too far apart", ends[0], ends[1]), described)?;
    Ok(None)
}

fn matrix_text(factors: &[StochasticMatrix], separator: &str) -> String {
    let row = |row: &Vec<Rational>| row.iter().map(ToString::to_string).collect::<Vec<_>>().join(separator) + "\n";
    let matrix = |m: &StochasticMatrix| m.to_rational_matrix().to_rows().iter().map(row).collect::<String>();
    factors.iter().map(matrix).collect::<Vec<_>>().join("\n")
}

fn matrix_json(factors: &[StochasticMatrix]) -> String {
    let rows = |m: &StochasticMatrix| -> Vec<Vec<String>> {
        let rows = m.to_rational_matrix().to_rows();
        rows.iter().map(|row| row.iter().map(ToString::to_string).collect()).collect()
    };
    json!(factors.iter().map(rows).collect::<Vec<_>>()).to_string()
}

fn matrices(draws: &mut Draws, tested: Tested) -> Checked {
    let (order, length) = (draws.between(1, 4), draws.between(1, 4));
    let factors = stochastic_sequence(draws, order, length, 12).or_fails("a stochastic matrix is refused")?;
    let mut written = factors.clone();
    if tested.is_altered() {
        written.reverse();
    }
    let separator = *draws.choice(&[" ", ", ", "\t"]);
    for text in [matrix_text(&written, separator), matrix_json(&written)] {
        let again = read_sequence(&text).or_fails("what is written is refused")?;
        require(again == factors, "other matrices are read", || text.clone())?;
    }
    Ok(None)
}

fn arcs(graph: &WeightedGraph) -> Vec<(usize, usize, Rational)> {
    graph.adjacency().entries().map(|(i, j, weight)| (i, j, weight.clone())).collect()
}

fn edge_list(order: usize, arcs: &[(usize, usize, Rational)]) -> String {
    let lines: String = arcs.iter().map(|(i, j, weight)| format!("{} {} {weight}\n", i + 1, j + 1)).collect();
    format!("directed\nvertices {order}\n{lines}")
}

fn matrix_market(order: usize, arcs: &[(usize, usize, Rational)]) -> String {
    let lines: String = arcs.iter().map(|(i, j, weight)| format!("{} {} {weight}\n", i + 1, j + 1)).collect();
    format!("%%MatrixMarket matrix coordinate real general\n{order} {order} {}\n{lines}", arcs.len())
}

fn graphs(draws: &mut Draws, tested: Tested) -> Checked {
    let order = draws.between(1, 6);
    let graph = digraph(draws, order);
    let mut written = arcs(&graph);
    if tested.is_altered() {
        written = written.into_iter().map(|(i, j, weight)| (j, i, weight)).collect();
    }
    for text in [edge_list(order, &written), matrix_market(order, &written)] {
        let again = read_graph(&text).or_fails("what is written is refused")?;
        let same = again.order() == order && arcs(&again) == arcs(&graph);
        require(same, "another graph is read", || text.clone())?;
    }
    Ok(None)
}

fn flock_text(start: &Start) -> String {
    let rows = |rows: &[Vec<Rational>]| -> Vec<Vec<String>> {
        rows.iter().map(|row| row.iter().map(ToString::to_string).collect()).collect()
    };
    let weights = match &start.weights {
        Weights::Lazy => json!("lazy"),
        Weights::Vicsek => json!("vicsek"),
        Weights::Given(c) => json!({"c": c.iter().map(ToString::to_string).collect::<Vec<_>>()}),
    };
    let hysteresis = match &start.hysteresis {
        Hysteresis::None => "none".to_string(),
        Hysteresis::Paper => "paper".to_string(),
        Hysteresis::Constant(threshold) => threshold.to_string(),
    };
    json!({
        "model": "D", "dimension": start.positions[0].len(), "weights": weights, "positions": rows(&start.positions),
        "velocities": rows(&start.velocities), "hysteresis": hysteresis
    })
    .to_string()
}

fn flocks(draws: &mut Draws, tested: Tested) -> Checked {
    let start = start(draws);
    let mut written = start.clone();
    if tested.is_altered() && written.positions.len() > 1 {
        written.positions.swap(0, 1);
    }
    let text = flock_text(&written);
    let again = read_flock(&text).or_fails("what is written is refused")?;
    let same = matches!(&again.model, Model::D { start: found, control: None } if *found == start);
    require(same, format!("{:?} is read", again.model), || text.clone())?;
    Ok(None)
}

fn school(draws: &mut Draws) -> Tracks {
    let setting = Setting {
        fish: draws.between(2, 4),
        frames: draws.between(3, 8),
        step: 0.5 * draws.between(1, 3) as f64,
        body_length: 1.0,
        seed: draws.below(1000).to_string(),
    };
    let kinds = [School::Polarised, School::Milling, School::Independent];
    let mut tracks = synthetic_school(*draws.choice(&kinds), &setting);
    if draws.once_in(2) {
        // Names sort as the alphabet does once one of them is no number.
        for (k, id) in tracks.ids.iter_mut().enumerate() {
            *id = format!("{}, \"{k}\"", ["a", "b", "c", "d"][k % 4]);
        }
    }
    // A gap, but no frame that is gone as a whole.
    if draws.once_in(2) {
        let frame = 1 + draws.below(setting.frames as u64 - 2) as usize;
        tracks.positions[0][frame] = None;
    }
    tracks
}

fn tracks(draws: &mut Draws, tested: Tested) -> Checked {
    let tracks = school(draws);
    let mut text = tracks.to_csv();
    if tested.is_altered() {
        text = text.lines().enumerate().filter(|(k, _)| *k != 1).map(|(_, line)| line.to_string() + "\n").collect();
    }
    let again = Tracks::from_csv(&text).or_fails("what is written is refused")?;
    let same = again.ids == tracks.ids && again.frames == tracks.frames && again.positions == tracks.positions;
    require(same, "other tracks are read", || text.clone())?;
    Ok(None)
}

/// A scenario as sections of lines.
fn sections(draws: &mut Draws) -> Vec<Vec<String>> {
    let agents = draws.between(2, 4);
    let mut number = |most: u64| fraction(draws, most, 4);
    let point = |x: Rational, y: Rational| format!("[\"{x}\", \"{y}\"]");
    let places: Vec<String> = (0..agents).map(|k| point(number(2) + rational(5 * k as i64, 1), number(3))).collect();
    let speeds: Vec<String> = (0..agents).map(|_| point(number(3), number(3))).collect();
    let samples = [rational(1, 2), rational(1, 1)].map(|t| t.to_string());
    vec![
        vec!["model = \"velocity-alignment\"".to_string()],
        vec![
            "[state]".to_string(),
            format!("positions = {}", shown(&places)),
            format!("velocities = {}", shown(&speeds)),
        ],
        vec!["[graph]".to_string(), "kind = \"complete\"".to_string()],
        vec!["[law]".to_string(), "potential = \"inverse-square-log\"".to_string()],
        vec![
            "[run]".to_string(),
            "until = 2".to_string(),
            format!("samples = [\"{}\", \"{}\"]", samples[0], samples[1]),
            format!("rows = {}", 2 + draws.below(5)),
        ],
    ]
}

fn scenarios(draws: &mut Draws, tested: Tested) -> Checked {
    let sections = sections(draws);
    let text = |sections: &[Vec<String>]| sections.iter().map(|lines| lines.join("\n") + "\n").collect::<String>();
    let mut other = sections.clone();
    // The key outside any section stays first, and so does the header of each section.
    if draws.once_in(2) {
        other[1..].reverse();
    }
    for lines in other.iter_mut().skip(1) {
        if draws.once_in(2) {
            lines[1..].reverse();
        }
    }
    let (first, mut second) = (text(&sections), text(&other));
    if tested.is_altered() {
        second = second.replacen("until = 2", "until = 3", 1);
    }
    let read = |text: &str| Scenario::read(text).map(|scenario| (scenario.declaration(), scenario.until()));
    let (a, b) = (read(&first).or_fails("what is written is refused")?, read(&second).or_fails("it is refused")?);
    require(a == b, "it is read as another one", || format!("{first}\nand\n{second}"))?;
    Ok(None)
}

/// A name of a reader, and the reader: what it says of a text that it refuses.
pub type Reader = (&'static str, fn(&str) -> Result<(), String>);

/// Products of words: what is beyond is arithmetic, not reading.
const WORK_ON_A_CERTIFICATE: u64 = 1 << 20;

/// Every reader of the program; the targets of the folder `fuzz/` are the same.
pub const READERS: [Reader; 10] = [
    ("numbers", |text| parse_rational(text).map(drop).map_err(|error| error.to_string())),
    ("matrices", |text| read_sequence(text).map(drop).map_err(|error| error.to_string())),
    ("graphs", |text| read_graph(text).map(drop).map_err(|error| error.to_string())),
    ("graph_names", |text| {
        let found = text.parse::<NamedGraph>().map(drop).or_else(|_| text.parse::<AnyGraph>().map(drop));
        found.map_err(|error| error.to_string())
    }),
    ("flocks", |text| read_flock(text).map(drop).map_err(|error| error.to_string())),
    ("tracks", |text| Tracks::from_csv(text).map(drop).map_err(|error| error.to_string())),
    ("scenarios", |text| Scenario::read(text).map(drop).map_err(|error| error.to_string())),
    ("questions", |text| {
        let none = |name: &str| Err(format!("there is no file {name}"));
        Question::read(text, &none).map(drop).map_err(|error| error.to_string())
    }),
    ("certificates", |text| {
        let checked = flockproof_checker::check_within(text.as_bytes(), WORK_ON_A_CERTIFICATE);
        checked.map(drop).map_err(|refusal| refusal.reason)
    }),
    ("systems", |text| System::read(text).map(drop).map_err(|error| error.to_string())),
];

/// A system to begin with.
const SYSTEM: &str = "[system]\nstates = [\"x\"]\ninputs = { u = [-1, 1], w = { box = [0, 1], constant = true } }\nstart = { x = [0, \"1/2\"] }\n\
     [[mode]]\nname = \"a\"\nA = [[-1]]\nB = [[1, 1]]\nc = [0]\n[switching]\nkind = \"periodic\"\norder = [\"a\"]\nperiod = 1\n\
     [run]\nuntil = 2\n[[check]]\nholds = \"x <= 2 and -x < 1\"\nat = 1\n";

/// Questions to begin with.
const QUESTIONS: [&str; 3] = [
    "[question]\nid = \"a\"\n[for]\nn = \"2..5\"\ngraph = \"connected(n)\"\n[holds]\nproperty = \"lambda(2) >= 2*(1 - cos(pi/n))\"\n\
     controls = [\"lambda(2) > 1/100 and not n = 3\"]\n",
    "[question]\nid = \"b\"\n[for]\nf = \"[-4, -1/10]\"\nn = [\"1\", \"3\"]\nwhere = \"gcd(n, 2) = 1\"\n[values]\nx = \"abs(f)^n/(n + 1)\"\n",
    "[question]\nid = \"c\"\n[for]\nfollowers = \"1..4\"\nf = \"-1\"\ng = \"-1/2\"\n[values]\np = \"peak / followers\"\n",
];

/// Pieces that readers may stumble over.
const PIECES: [&str; 24] = [
    "",
    "0",
    "-1",
    "1/0",
    "1e9999",
    "99999999999999999999",
    "nan",
    "inf",
    "\"",
    "'",
    "[",
    "]",
    "{",
    "}",
    ",",
    "\n",
    "\r\n",
    "\t",
    "\0",
    "\u{feff}",
    "é",
    "=",
    "#",
    "1e-9999",
];

fn nonsense(draws: &mut Draws, tested: Tested) -> Checked {
    let reader = draws.below(READERS.len() as u64) as usize;
    let (name, read) = READERS[reader];
    let mut text = valid(draws, name)?;
    for _ in 0..draws.between(1, 4) {
        text = mangled(draws, &text);
    }
    let mut said = read(&text).err().unwrap_or_default();
    if tested.is_altered() {
        said.push_str("\nand more");
    }
    require(!said.contains('\n'), format!("{name} are refused in several lines: {said}"), || text.clone())?;
    Ok(None)
}

/// A text that a reader reads.
fn valid(draws: &mut Draws, name: &str) -> Result<String, Stop> {
    Ok(match name {
        "systems" => SYSTEM.to_string(),
        "numbers" => fraction(draws, 10_000, 1000).to_string(),
        "graphs" => {
            let order = draws.between(1, 5);
            let arcs = arcs(&digraph(draws, order));
            if draws.once_in(2) { matrix_market(order, &arcs) } else { edge_list(order, &arcs) }
        }
        "graph_names" => {
            let names = ["ring:12", "path:5", "complete:4", "circulant:12:1,3", "platoon2:8", "geometric:9:1/2:1"];
            (*draws.choice(&names)).to_string()
        }
        "flocks" => flock_text(&start(draws)),
        "tracks" => school(draws).to_csv(),
        "questions" => QUESTIONS[draws.below(QUESTIONS.len() as u64) as usize].to_string(),
        "scenarios" => sections(draws).iter().map(|lines| lines.join("\n") + "\n").collect(),
        _ => {
            let factors = stochastic_sequence(draws, 2, 2, 9).or_fails("a stochastic matrix is refused")?;
            if name == "certificates" {
                use proofs::certificates::{Certificate, Product};
                Certificate::Product(Product::new(&factors).or_fails("no certificate is made")?).text()
            } else if draws.once_in(2) {
                matrix_json(&factors)
            } else {
                matrix_text(&factors, " ")
            }
        }
    })
}

/// A part of the text replaced by a piece, by another part, or left out.
fn mangled(draws: &mut Draws, text: &str) -> String {
    let places: Vec<usize> = text.char_indices().map(|(at, _)| at).chain([text.len()]).collect();
    let from = draws.below(places.len() as u64) as usize;
    let to = (from + draws.below(9) as usize).min(places.len() - 1);
    let (from, to) = (places[from], places[to]);
    let piece = match draws.below(3) {
        0 => PIECES[draws.below(PIECES.len() as u64) as usize].to_string(),
        1 => list(draws, 2, |_| text[from..to].to_string()).concat(),
        _ => String::new(),
    };
    format!("{}{piece}{}", &text[..from], &text[to..])
}
