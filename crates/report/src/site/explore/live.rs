//! Pages that ask the program while they are looked at: under `flockproof serve`.

use super::super::Texts;
use super::cases::{self, Case};
use super::runs::RunsError;
use super::sketches::{self, Sketch};
use super::starts::{
    BIRDS, CERTIFICATE, FORTY_CARS, GAINS, GAP, PAIRS, PAIRS_FLOCK, PATTERN, PHASES, PHASES_SCENARIO, PLAA01, PLAD01,
    PLATOON, SWITCHING, THREE, TWO_CARS,
};
use maud::{Markup, PreEscaped, html};

/// A live page.
pub(in super::super) struct Live {
    /// The name of the page.
    pub name: &'static str,
    pub title: &'static str,
    about: &'static str,
    /// The question it asks, and the command that answers the same.
    ask: &'static str,
    command: &'static str,
    fields: &'static [Field],
    /// What is drawn with the mouse, into which field.
    draws: Option<(&'static str, &'static str)>,
    /// What the static site shows: what it is, and the answer.
    case: Option<(&'static str, Answered)>,
    /// A small picture for the list.
    pub sketch: Option<fn(Texts) -> Sketch>,
    /// Starts to choose from: a name, and what stands in the fields then.
    examples: &'static [(&'static str, &'static [(&'static str, &'static str)])],
}

/// Computes an answer.
type Answered = fn(Texts) -> Case;

/// What is asked for.
struct Field {
    name: &'static str,
    label: &'static str,
    at_first: &'static str,
    kind: Kind,
}

enum Kind {
    Line,
    /// So many lines.
    Text(u8),
    Choice(&'static [&'static str]),
    /// A text that a file can fill.
    File(u8),
}

const fn line(name: &'static str, label: &'static str, at_first: &'static str) -> Field {
    Field { name, label, at_first, kind: Kind::Line }
}

const fn text(name: &'static str, label: &'static str, lines: u8, at_first: &'static str) -> Field {
    Field { name, label, at_first, kind: Kind::Text(lines) }
}

/// All of them.
pub(in super::super) const LIVE: &[Live] = &[
    Live {
        name: "live-resonance",
        title: "Resonance of a platoon",
        about: "The frequency at which the last car of a two-sided platoon swings most, and how much, with certified digits, beside Theorem 1 and its next order; \
                the curve, and the gains with a smaller peak.",
        ask: "resonance",
        command: "flockproof resonance --followers 128 --f -1 --g -1 --digits 15 --json",
        fields: &[
            line("followers", "Followers", "128"),
            line("f", "f, of positions, below 0", "-1"),
            line("g", "g, of velocities, below 0", "-1"),
        ],
        draws: None,
        case: Some(("128 followers, f = g = -1", cases::resonance)),
        sketch: Some(sketches::resonance),
        examples: &[],
    },
    Live {
        name: "live-spectra",
        title: "Spectra of graphs",
        about: "Eigenvalues of a matrix of a graph, enclosed. Name a graph: ring:12, path:30, complete:5, star:7, circulant:12:1,3 and others; or draw \
                one: click for a vertex, drag from one to another for an edge.",
        ask: "spectrum",
        command: "flockproof spectrum --graph ring:12 --json",
        fields: &[
            line("graph", "Name of the graph; empty for the drawn one", "ring:12"),
            Field {
                name: "kind",
                label: "Matrix",
                at_first: "laplacian",
                kind: Kind::Choice(&[
                    "laplacian",
                    "out-degree",
                    "in-degree",
                    "normalised",
                    "walk",
                    "reduced",
                    "adjacency",
                ]),
            },
            text(
                "edges",
                "Edges of the drawn graph: vertices N, then a line i j for each",
                5,
                "vertices 4\n1 2\n2 3\n3 1\n3 4\n",
            ),
        ],
        draws: Some(("graph", "edges")),
        case: Some(("the Laplacian of ring:12", cases::spectrum)),
        sketch: Some(sketches::spectrum),
        examples: &[],
    },
    Live {
        name: "live-flock",
        title: "A flock of your own, settled exactly",
        about: "Averaging birds in the plane: drag to set a bird and its velocity, or write them. The program finds every switch of the network, \
                and whether it can ever change again.",
        ask: "flock",
        command: "flockproof flock settle FILE --json",
        fields: &[text("flock", "The flock", 6, BIRDS)],
        draws: Some(("flock", "flock")),
        case: Some(("three birds", cases::flock)),
        sketch: Some(sketches::flock),
        examples: &[],
    },
    Live {
        name: "live-patterns",
        title: "Patterns of particles and their stability",
        about: "N steered particles in M clusters, evenly spaced on one circle, for each M that divides N: which of these patterns are stable under the gains of the \
                orientation control? The linearisation is exact, its largest real part enclosed.",
        ask: "pattern",
        command: "flockproof pattern --particles 12 --gains 1/5,1/5,-1/25 --json",
        fields: &[
            line("particles", "Particles", "12"),
            line("gains", "Gains K_1, K_2, ..", "1/5,1/5,-1/25"),
            line("omega0", "ω_0, rate of turning", "1/10"),
            line("K0", "K_0, gain of spacing", "1/10"),
        ],
        draws: None,
        case: Some(("twelve particles, K = (1/5, 1/5, -1/25)", cases::patterns)),
        sketch: Some(sketches::patterns),
        examples: &[],
    },
    Live {
        name: "live-question",
        title: "A question of your own, decided",
        about: "What a property ranges over, the property, and controls that must turn out false. The program decides it, and draws a counterexample. \
                flockproof check --names lists all names that a question may use.",
        ask: "question",
        command: "flockproof check QUESTION.toml --json",
        fields: &[
            text("question", "The question", 14, GAP),
            text("beside", "The scenario or graph that the question names, if it names one", 6, ""),
        ],
        draws: None,
        case: Some(("the question gap_and_diameter", cases::question)),
        sketch: Some(sketches::question),
        examples: &[
            ("A gap and a diameter", &[("question", GAP), ("beside", "")]),
            ("Gains of platoons", &[("question", GAINS), ("beside", "")]),
            ("Two pairs of birds", &[("question", PAIRS), ("beside", PAIRS_FLOCK)]),
            ("Phases that repel", &[("question", PHASES), ("beside", PHASES_SCENARIO)]),
            (
                "A law, for every number of agents",
                &[("question", "assets/laws/questions/cucker_smale.toml"), ("beside", "assets/laws/cucker_smale.toml")],
            ),
        ],
    },
    Live {
        name: "live-scenario",
        title: "A scenario of your own, run",
        about: "Any model of the papers: phases, steered particles, fish, heading and velocity alignment, platoons, averaging flocks. The run is in floating point.",
        ask: "scenario",
        command: "flockproof simulate CONFIG.toml --json",
        fields: &[text("scenario", "The scenario", 18, SWITCHING)],
        draws: None,
        case: Some(("six agents, links within 5/2", cases::scenario)),
        sketch: Some(sketches::scenario),
        examples: &[
            ("Six agents, links within 5/2", &[("scenario", SWITCHING)]),
            ("Twelve particles form a pattern", &[("scenario", PATTERN)]),
            ("Three agents agree", &[("scenario", THREE)]),
            ("A platoon near its resonance", &[("scenario", PLATOON)]),
        ],
    },
    Live {
        name: "live-law",
        title: "A law of your own, run",
        about: "A law that is written in the file: what each agent has, its rates of change, and what is measured. Begin with one of the literature.",
        ask: "scenario",
        command: "flockproof simulate CONFIG.toml --json",
        fields: &[text("scenario", "The scenario with its law", 24, "assets/laws/boids.toml")],
        draws: None,
        case: None,
        sketch: Some(sketches::law),
        examples: &[
            ("Boids", &[("scenario", "assets/laws/boids.toml")]),
            ("Circling particles", &[("scenario", "assets/laws/circling.toml")]),
            ("Couzin and others", &[("scenario", "assets/laws/couzin.toml")]),
            ("Cucker and Smale", &[("scenario", "assets/laws/cucker_smale.toml")]),
            ("D'Orsogna and others", &[("scenario", "assets/laws/dorsogna.toml")]),
            ("Fish", &[("scenario", "assets/laws/fish.toml")]),
            ("Heading alignment", &[("scenario", "assets/laws/heading_alignment.toml")]),
            ("Hegselmann and Krause", &[("scenario", "assets/laws/hegselmann_krause.toml")]),
            ("Intelligent driver", &[("scenario", "assets/laws/intelligent_driver.toml")]),
            ("Jadbabaie, Lin and Morse", &[("scenario", "assets/laws/jadbabaie.toml")]),
            ("Kuramoto", &[("scenario", "assets/laws/kuramoto.toml")]),
            ("Lazy averaging", &[("scenario", "assets/laws/lazy_averaging.toml")]),
            ("Moreau", &[("scenario", "assets/laws/moreau.toml")]),
            ("Motsch and Tadmor", &[("scenario", "assets/laws/motsch_tadmor.toml")]),
            ("Olfati-Saber", &[("scenario", "assets/laws/olfati_saber.toml")]),
            ("Phase model", &[("scenario", "assets/laws/phase_model.toml")]),
            ("Platoon behind", &[("scenario", "assets/laws/platoon_behind.toml")]),
            ("Platoon both sides", &[("scenario", "assets/laws/platoon_both_sides.toml")]),
            ("Sakaguchi and Kuramoto", &[("scenario", "assets/laws/sakaguchi.toml")]),
            ("Velocity alignment", &[("scenario", "assets/laws/velocity_alignment.toml")]),
            ("Vicsek and others", &[("scenario", "assets/laws/vicsek.toml")]),
        ],
    },
    Live {
        name: "live-reach",
        title: "Worst cases of a switched system",
        about: "Linear modes with bounded inputs, switched in turn, at unknown times or at will: how small can a distance become? For a fixed order of modes the worst \
                case is enclosed, with the input that attains it. The same of platoons behind a leader of bounded acceleration: how far apart must cars drive so that they never touch?",
        ask: "system",
        command: "flockproof reach SYSTEM.toml --json",
        fields: &[text("system", "The system", 18, TWO_CARS)],
        draws: None,
        case: None,
        sketch: Some(sketches::worst_cases),
        examples: &[
            ("Two cars, communication on and off", &[("system", TWO_CARS)]),
            ("Three followers, on and off in turn (PLAD01)", &[("system", PLAD01)]),
            ("Three followers, any loss (PLAA01)", &[("system", PLAA01)]),
            ("How far apart must forty cars drive?", &[("system", FORTY_CARS)]),
        ],
    },
    Live {
        name: "live-certificate",
        title: "A certificate, checked",
        about: "The small separate checker, which shares no code with what wrote the certificate, reads it and says what it shows. \
                Certificates are written by flockproof certify, resonance --certificate and others.",
        ask: "certificate",
        command: "flockproof-checker FILE",
        fields: &[Field { name: "certificate", label: "The certificate", at_first: CERTIFICATE, kind: Kind::File(10) }],
        draws: None,
        case: None,
        sketch: None,
        examples: &[("The limit of one pair of birds", &[("certificate", CERTIFICATE)])],
    },
];

/// The page.
///
/// # Errors
/// The sentence of what could not be computed.
pub(super) fn body(live: &Live, texts: Texts) -> Result<Markup, RunsError> {
    let case = live.case.map(|(what, case)| Ok::<_, RunsError>((what, case(texts)?))).transpose()?;
    Ok(html! {
        h1 { (live.title) }
        p.lead { (live.about) }
        p #away { "This page asks the program. Start it with " code { "flockproof serve" } " and open the address that it prints; or ask on the command line: "
            code { (live.command) } "." }
        form #ask data-ask=(live.ask) hidden {
            @if !live.examples.is_empty() {
                label { span { "Example" } select #example {
                    @for (name, _) in live.examples { option { (name) } }
                } }
            }
            @if let Some((what, field)) = live.draws {
                div.words { canvas #drawing data-draws=(what) data-field=(field) width="640" height="360" role="img" aria-label="What is written below, drawn" {} }
            }
            @for field in live.fields { (input(field, texts)) }
            span.buttons {
                button #go type="submit" { "Ask" }
                " " button #stop type="button" disabled { "Stop" }
                @if live.draws.is_some() { " " button type="button" #clear { "Empty" } }
            }
        }
        @for (name, fields) in live.examples {
            template data-example=(name) { @for (field, text) in *fields { textarea data-name=(field) { (filled(text, texts)) } } }
        }
        div #work hidden { progress #bar aria-label="Progress" {} " " span #stage {} }
        p #state role="status" {}
        section #answer aria-label="Answer" {
            @if let Some((what, shown)) = &case { h2 { "An answer: " (what) } (PreEscaped(shown)) }
        }
        details #document hidden { summary { "The same as JSON" } pre tabindex="0" { code {} } p.small { "As " code { (live.command) } " prints it." } }
        script src="../explore.js" defer {}
        script src="../live.js" defer {}
    })
}

/// A text, or that of the file of which it is the path.
fn filled(text: &'static str, texts: Texts) -> &'static str {
    texts(text).unwrap_or(text)
}

fn input(field: &Field, texts: Texts) -> Markup {
    let Field { name, label, kind, .. } = field;
    let at_first = &filled(field.at_first, texts);
    html! {
        @match kind {
            Kind::Line => label { span { (label) } input name=(name) value=(at_first) autocomplete="off" spellcheck="false"; },
            Kind::Choice(words) => label { span { (label) } select name=(name) {
                @for word in *words { option selected[word == at_first] { (word) } }
            } },
            // The first line break of a text area is not its own.
            Kind::Text(lines) => label.words { span { (label) } textarea name=(name) rows=(lines) spellcheck="false" { "\n" (at_first) } },
            Kind::File(lines) => {
                label { span { "From a file" } input #file type="file"; }
                label.words { span { (label) } textarea name=(name) rows=(lines) spellcheck="false" { "\n" (at_first) } }
            },
        }
    }
}
