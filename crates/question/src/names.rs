//! All names that an expression may use, with what they mean: the source of `check --names` and of the page in the notes.

use crate::error::Problem;
use scenario::Model;
use std::fmt::Write;
use std::sync::LazyLock;

/// What a quantity is measured on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Subject {
    /// A graph that is bound in `[for]`.
    Graph,
    /// A platoon with the gains `f` and `g`.
    Platoon,
    /// A sequence of stochastic matrices.
    Matrices,
    /// An averaging flock (a scenario in JSON).
    Flock,
    /// A continuous motion (a scenario in TOML).
    Motion,
}

impl Subject {
    /// In a sentence.
    pub fn words(self) -> &'static str {
        match self {
            Subject::Graph => "a graph",
            Subject::Platoon => "a platoon",
            Subject::Matrices => "a sequence of stochastic matrices",
            Subject::Flock => "an averaging flock",
            Subject::Motion => "a continuous motion",
        }
    }

    /// What a question must have for it.
    pub fn needs(self) -> &'static str {
        match self {
            Subject::Graph => "no name in [for] ranges over graphs",
            Subject::Platoon => {
                "that needs the gains `f` and `g` in [for], and `followers` or a graph (weights of the cars ahead and behind are `ahead`, `behind`, `f_ahead`, ..)"
            }
            Subject::Matrices => "no name in [for] ranges over stochastic matrices",
            Subject::Flock => "`scenario` names no flock in JSON",
            Subject::Motion => "`scenario` names no motion in TOML",
        }
    }
}

/// A quantity of a subject.
#[derive(Debug, Clone)]
pub struct Quantity {
    /// Its name.
    pub name: &'static str,
    /// What it is measured on.
    pub subject: Subject,
    /// Names of its arguments.
    pub arguments: &'static [&'static str],
    /// Whether it is true or false rather than a number.
    pub is_truth: bool,
    /// Whether it changes in time.
    pub moves: bool,
    /// What it means.
    pub meaning: &'static str,
}

const fn fixed(
    subject: Subject,
    name: &'static str,
    arguments: &'static [&'static str],
    meaning: &'static str,
) -> Quantity {
    Quantity { name, subject, arguments, is_truth: false, moves: false, meaning }
}

const fn truth(
    subject: Subject,
    name: &'static str,
    arguments: &'static [&'static str],
    meaning: &'static str,
) -> Quantity {
    Quantity { name, subject, arguments, is_truth: true, moves: false, meaning }
}

/// A number of a law of one's own: of its state, or an observable, by a name of its own.
pub(crate) static OWN: Quantity = Quantity {
    name: "a number of the law",
    subject: Subject::Motion,
    arguments: &[],
    is_truth: false,
    moves: true,
    meaning: "a number of the state, `x[2].1`, or an observable of the law",
};

/// A function of a graph that a program gives, by a name of its own.
pub(crate) static GIVEN: Quantity =
    fixed(Subject::Graph, "a function of a graph", &[], "a function that the program was given");

/// Those that do not move.
const FIXED: &[Quantity] = &[
    fixed(Subject::Graph, "n", &[], "number of vertices"),
    fixed(Subject::Graph, "edges", &[], "number of edges; of a directed graph, of arcs"),
    fixed(
        Subject::Graph,
        "min_degree",
        &[],
        "smallest number of neighbours; of a directed graph, of arcs from a vertex",
    ),
    fixed(
        Subject::Graph,
        "max_degree",
        &[],
        "largest number of neighbours; of a directed graph, of arcs from a vertex",
    ),
    fixed(Subject::Graph, "degree", &["i"], "number of neighbours of vertex i; of a directed graph, of arcs from it"),
    fixed(Subject::Graph, "in_degree", &["i"], "number of arcs to vertex i; of an undirected graph, its degree"),
    truth(
        Subject::Graph,
        "adjacent",
        &["i", "j"],
        "vertices i and j are joined; of a directed graph, by an arc from i to j",
    ),
    fixed(
        Subject::Graph,
        "distance",
        &["i", "j"],
        "least number of edges, or arcs, from vertex i to vertex j; only where there is a way",
    ),
    fixed(
        Subject::Graph,
        "eccentricity",
        &["i"],
        "largest distance from vertex i; only where every vertex can be reached from it",
    ),
    fixed(
        Subject::Graph,
        "diameter",
        &[],
        "largest distance of two vertices along edges; only where every vertex can be reached from every other",
    ),
    fixed(
        Subject::Graph,
        "radius",
        &[],
        "smallest eccentricity; only where every vertex can be reached from every other",
    ),
    fixed(Subject::Graph, "girth", &[], "length of a shortest cycle; only where there is one"),
    truth(
        Subject::Graph,
        "connected",
        &[],
        "every vertex can be reached from every other, along arcs in a directed graph",
    ),
    truth(Subject::Graph, "bipartite", &[], "two colours are enough: there is no odd cycle"),
    truth(Subject::Graph, "regular", &[], "all vertices have the same number of neighbours"),
    truth(Subject::Graph, "planar", &[], "it can be drawn in the plane without crossings"),
    truth(Subject::Graph, "tree", &[], "connected and without cycles"),
    fixed(
        Subject::Graph,
        "edge_connectivity",
        &[],
        "least number of edges whose removal disconnects it; 0 of a single vertex",
    ),
    fixed(
        Subject::Graph,
        "vertex_connectivity",
        &[],
        "least number of vertices whose removal leaves it disconnected or with a single vertex",
    ),
    fixed(Subject::Graph, "clique_number", &[], "number of vertices of a largest clique, up to 64 vertices"),
    fixed(
        Subject::Graph,
        "independence_number",
        &[],
        "largest number of vertices of which no two are joined, up to 64 vertices",
    ),
    fixed(Subject::Graph, "chromatic_number", &[], "least number of colours, up to 64 vertices"),
    fixed(Subject::Graph, "matching_number", &[], "number of edges of a largest matching"),
    fixed(Subject::Graph, "spanning_trees", &[], "number of spanning trees"),
    fixed(
        Subject::Graph,
        "resistance",
        &["i", "j"],
        "effective resistance between vertices i and j, every edge being a resistance of 1; only of connected graphs",
    ),
    fixed(
        Subject::Graph,
        "kirchhoff_index",
        &[],
        "sum of the effective resistances of all pairs of vertices; only of connected graphs",
    ),
    fixed(
        Subject::Graph,
        "cheeger",
        &[],
        "Cheeger constant: least size of a cut over the smaller sum of degrees of its two sides, up to 24 vertices",
    ),
    fixed(
        Subject::Graph,
        "isoperimetric_number",
        &[],
        "least size of a cut over the number of vertices on its smaller side, up to 24 vertices",
    ),
    fixed(Subject::Graph, "automorphisms", &[], "number of automorphisms, up to 64 vertices"),
    fixed(
        Subject::Graph,
        "lambda",
        &["k", "kind"],
        "k-th smallest eigenvalue (of a directed graph: real part), counted with multiplicity, of the matrix that `kind` names; `lambda(k)` of that of `kind` in [question]",
    ),
    fixed(
        Subject::Graph,
        "spectral_radius",
        &[],
        "largest modulus of an eigenvalue of the matrix of weights, none of which may be negative",
    ),
    fixed(
        Subject::Graph,
        "fiedler_sign",
        &["i"],
        "-1, 0 or 1: the sign at vertex i of the eigenvector of the second smallest Laplacian eigenvalue, whose first entry that is not 0 is positive; only where that eigenvalue is simple",
    ),
    truth(Subject::Graph, "rooted", &[], "some vertex is reached from every other along arcs"),
    truth(Subject::Graph, "strongly_connected", &[], "the same as `connected`"),
    fixed(
        Subject::Graph,
        "period",
        &[],
        "greatest common divisor of the lengths of all closed walks; only where every vertex can be reached from every other",
    ),
    fixed(
        Subject::Graph,
        "second_modulus",
        &[],
        "second largest modulus of an eigenvalue, counted with multiplicity, of the stochastic matrix D^-1 A; only where every vertex has a neighbour and no weight is negative",
    ),
    fixed(
        Subject::Platoon,
        "peak",
        &[],
        "largest amplitude of the last car over all frequencies, per unit amplitude of the leader",
    ),
    fixed(Subject::Platoon, "peak_frequency", &[], "angular frequency of the peak, rad/s"),
    fixed(Subject::Platoon, "gain", &["k", "w"], "amplitude of follower k at the angular frequency w"),
    truth(Subject::Platoon, "stable", &[], "the followers come to rest behind a leader at rest"),
    fixed(Subject::Platoon, "abscissa", &[], "largest real part of the modes of the platoon, 1/s"),
    fixed(
        Subject::Matrices,
        "tau_1",
        &[],
        "coefficient of ergodicity of the product: half the largest distance of two rows in the 1-norm",
    ),
    fixed(
        Subject::Matrices,
        "tau_2",
        &[],
        "largest distance of two rows of the product in the 2-norm, as `ergodicity` prints it",
    ),
    fixed(
        Subject::Matrices,
        "second_modulus",
        &[],
        "second largest modulus of an eigenvalue of the product, counted with multiplicity",
    ),
    fixed(Subject::Flock, "last_switch", &[], "last time at which the network changes; 0 where it never does"),
    fixed(Subject::Flock, "switches", &[], "number of times at which the network changes"),
    fixed(Subject::Flock, "flocks", &[], "number of connected parts of the network at the end"),
    truth(Subject::Flock, "steady", &[], "the network changes finitely often and then never again"),
];

/// All quantities: those that do not move, then the observables of flocks and of motions.
pub fn quantities() -> &'static [Quantity] {
    static ALL: LazyLock<Vec<Quantity>> = LazyLock::new(|| {
        let of = |subject: Subject| {
            let decided = scenario::QUANTITIES.iter().filter(move |row| {
                let has = |model: &Model| match subject {
                    Subject::Flock => *model == Model::Flock,
                    _ => model.is_enclosed(),
                };
                row.undecided.is_none() && row.models.iter().any(has)
            });
            decided.map(move |row| Quantity {
                name: row.name,
                subject,
                arguments: row.arguments,
                is_truth: false,
                moves: true,
                meaning: row.meaning,
            })
        };
        FIXED.iter().cloned().chain(of(Subject::Flock)).chain(of(Subject::Motion)).collect()
    });
    &ALL
}

/// Observables of `simulate` that no question decides, with the reason.
pub fn not_decided() -> impl Iterator<Item = (&'static str, &'static str)> {
    scenario::QUANTITIES.iter().filter_map(|row| Some((row.name, row.undecided?)))
}

/// A function of numbers, or a constant.
#[derive(Debug)]
pub struct Function {
    /// Its name.
    pub name: &'static str,
    /// Least and largest number of arguments.
    pub arguments: (usize, usize),
    /// What it means.
    pub meaning: &'static str,
}

const fn function(name: &'static str, least: usize, most: usize, meaning: &'static str) -> Function {
    Function { name, arguments: (least, most), meaning }
}

/// Most arguments of `min`, `max` and `gcd`.
const MANY: usize = 1000;

/// All functions.
pub const FUNCTIONS: &[Function] = &[
    function("sqrt", 1, 1, "square root"),
    function("abs", 1, 1, "absolute value"),
    function("min", 1, MANY, "smallest of its arguments"),
    function("max", 1, MANY, "largest of its arguments"),
    function("sin", 1, 1, "sine of an angle in radians; exact at rational multiples of pi"),
    function("cos", 1, 1, "cosine of an angle in radians; exact at rational multiples of pi"),
    function("exp", 1, 1, "exponential"),
    function("log", 1, 1, "natural logarithm"),
    function("gcd", 2, MANY, "greatest common divisor of integers"),
    function("pi", 0, 0, "the circle constant"),
    function("initial", 1, 1, "a moving quantity at time 0"),
];

/// What goes through the vertices, the edges or the pairs of a graph.
const SUMS: [(&str, &str); 7] = [
    ("sum(i, e)", "sum of e over all vertices i, numbers from 1"),
    (
        "sum(edge(i, j), e)",
        "the same over all edges, each once with i < j; of a directed graph over all arcs from i to j",
    ),
    ("sum(pair(i, j), e)", "the same over all pairs of vertices i < j"),
    ("sum(i where p, e)", "the same over those for which p is true; also of edges and pairs"),
    ("count(i, p)", "for how many p is true; also of edges and pairs"),
    ("max(vertex(i), e)", "largest value of e; also of edges and pairs, and only where there is one"),
    ("min(vertex(i), e)", "smallest value of e; also of edges and pairs, and only where there is one"),
];

/// A family in `[for]`.
#[derive(Debug)]
pub struct Family {
    /// How it is written.
    pub form: &'static str,
    /// Its name, up to the bracket; empty where it is no function.
    pub name: &'static str,
    /// Number of arguments.
    pub arguments: (usize, usize),
    /// What it ranges over.
    pub meaning: &'static str,
}

const fn family(form: &'static str, name: &'static str, least: usize, most: usize, meaning: &'static str) -> Family {
    Family { form, name, arguments: (least, most), meaning }
}

/// All families.
pub const FAMILIES: &[Family] = &[
    family("a..b", "", 0, 0, "the integers from a to b"),
    family("[a, b]", "", 0, 0, "all real numbers from a to b: a continuum, covered by boxes"),
    family("any", "", 0, 0, "all real numbers; for properties of numbers and functions of them alone"),
    family("integers(a, b)", "integers", 2, 2, "the integers from a to b, covered by boxes instead of one by one"),
    family("x", "", 0, 0, "one number, which may use earlier names"),
    family("[.., ..] (a TOML list)", "", 0, 0, "the members of all that are listed"),
    family("connected(n)", "connected", 1, 1, "all connected graphs on n vertices up to isomorphism, n <= 9"),
    family("all(n)", "all", 1, 1, "all graphs on n vertices up to isomorphism, n <= 9"),
    family("trees(n)", "trees", 1, 1, "all trees on n vertices up to isomorphism, n <= 16"),
    family("digraphs(n)", "digraphs", 1, 1, "all directed graphs on n vertices up to isomorphism, n <= 5"),
    family(
        "bipartite(n)",
        "bipartite",
        1,
        1,
        "all bipartite graphs on n vertices up to isomorphism, connected or not, n <= 11",
    ),
    family("planar(n)", "planar", 1, 1, "all planar graphs on n vertices up to isomorphism, connected or not, n <= 9"),
    family(
        "regular(n, d)",
        "regular",
        2,
        2,
        "all graphs on n vertices of degree d up to isomorphism, connected or not, n <= 11",
    ),
    family(
        "random(n, p)",
        "random",
        2,
        2,
        "a graph on n vertices, each edge there with probability p; needs `seed` before it: a sample",
    ),
    family("with_link(g)", "with_link", 1, 1, "all graphs with one link more than the graph g that was bound before"),
    family(
        "without_link(g)",
        "without_link",
        1,
        1,
        "all graphs with one link less than the graph g that was bound before",
    ),
    family("ring(n)", "ring", 1, 1, "the graph ring:n of `spectrum --graph`, n >= 3"),
    family("cycle(n)", "cycle", 1, 1, "the directed graph cycle:n"),
    family("path(n)", "path", 1, 1, "the graph path:n"),
    family("complete(n)", "complete", 1, 1, "the graph complete:n"),
    family("star(n)", "star", 1, 1, "the graph star:n"),
    family("wheel(n)", "wheel", 1, 1, "the graph wheel:n, n >= 4"),
    family("hypercube(d)", "hypercube", 1, 1, "the graph hypercube:d"),
    family("empty(n)", "empty", 1, 1, "the graph empty:n, without edges"),
    family("platoon1(m)", "platoon1", 1, 1, "the communication graph platoon1:m"),
    family("platoon2(m)", "platoon2", 1, 1, "the communication graph platoon2:m"),
    family(
        "petersen, grid:3x4, bipartite:3,4, circulant:12:1,3, ..",
        "",
        0,
        0,
        "a graph by its name, as for `spectrum --graph`",
    ),
    family("edges:4:1-2,2-3 and arcs:4:1-2,2-3", "", 0, 0, "the graph on 4 vertices with these edges, or arcs"),
    family("graph6:.., sparse6:.., digraph6:..", "", 0, 0, "the graph in that format of nauty and networkx"),
    family(
        "file:NAME",
        "",
        0,
        0,
        "the graph, each of the graphs in graph6 or sparse6, or the sequence of stochastic matrices, in a file, as for `spectrum` and `ergodicity`",
    ),
    family(
        "each:-1,-2,-1",
        "",
        0,
        0,
        "for `f`, `g`, `ahead`, `behind`, `f_ahead`, .. of a platoon: a number for each follower, in order",
    ),
    family(
        "stochastic(n, d)",
        "stochastic",
        2,
        2,
        "all row-stochastic matrices of order n with entries that are multiples of 1/d",
    ),
    family("products(n, d, k)", "products", 3, 3, "all sequences of k such matrices"),
    family("joined(a, b)", "joined", 2, 2, "the matrices of a and then those of b, which were bound before"),
    family(
        "random_products(n, k)",
        "random_products",
        2,
        2,
        "k stochastic matrices of order n at random; needs `seed` before it: a sample",
    ),
];

/// The names in `[for]` that make a platoon.
const PLATOON: [(&str, &str); 9] = [
    ("followers", "number of cars on a line behind the leader"),
    (
        "graph, or any name",
        "in place of `followers`: a graph of who tracks whom, an edge i j for i tracks j; vertex 1 leads",
    ),
    (
        "f",
        "gain of the positions, 1/s\u{b2}, below 0: one for all, an interval, or one for each follower: \"each:-1,-2,-1\"",
    ),
    ("g", "gain of the velocities, 1/s, likewise"),
    (
        "ahead",
        "weight of the car ahead, for positions and velocities: one for all, an interval, or one for each follower: \"0.6,0.5,1\"; those of a car are scaled to a sum of one",
    ),
    ("behind", "weight of the car behind, likewise; with one of the two alone the other is the rest to one"),
    ("f_ahead, f_behind", "weights for positions only; without `f` the gains of the two links, below 0"),
    ("g_ahead, g_behind", "weights for velocities only; without `g` the gains of the two links, below 0"),
    (
        "communication",
        "in [question], not in [for]: front-and-back, or front, where each car tracks the one ahead alone",
    ),
];

/// The table as text of so many columns: for `check --names`.
pub fn as_text(columns: usize) -> String {
    let mut text = String::new();
    for (title, rows) in sections() {
        let _ = writeln!(text, "{title}");
        // Long names stand in a line of their own.
        let widest = columns / 3;
        let width = rows.iter().map(|(name, _)| name.len()).filter(|width| *width <= widest).max().unwrap_or(0);
        let indent = " ".repeat(width + 4);
        for (name, meaning) in rows {
            let mut line =
                if name.len() > width { format!("  {name}\n{indent}") } else { format!("  {name:<width$}  ") };
            let mut used = indent.len();
            for (k, word) in meaning.split(' ').enumerate() {
                let room = word.chars().count() + usize::from(k > 0);
                if k > 0 && used + room > columns {
                    line += &format!("\n{indent}");
                    used = indent.len() + room - 1;
                } else {
                    line += if k > 0 { " " } else { "" };
                    used += room;
                }
                line += word;
            }
            let _ = writeln!(text, "{line}");
        }
        let _ = writeln!(text);
    }
    text.truncate(text.trim_end().len());
    text.push('\n');
    text
}

/// The table as Markdown: for the notes.
pub fn as_markdown() -> String {
    let mut text = String::new();
    for (title, rows) in sections() {
        let _ = writeln!(text, "**{title}**\n\n| name | meaning |\n|---|---|");
        for (name, meaning) in rows {
            let _ = writeln!(text, "| `{}` | {} |", name, meaning.replace('|', "\\|"));
        }
        let _ = writeln!(text);
    }
    text.truncate(text.trim_end().len());
    text.push('\n');
    text
}

/// Titles and rows of the table.
fn sections() -> Vec<(String, Vec<(String, &'static str)>)> {
    let with_arguments = |name: &str, arguments: &[&str]| {
        if arguments.is_empty() { name.to_string() } else { format!("{name}({})", arguments.join(", ")) }
    };
    let mut sections = vec![
        ("Families".to_string(), FAMILIES.iter().map(|family| (family.form.to_string(), family.meaning)).collect()),
        (
            "A platoon in [for]".to_string(),
            PLATOON.iter().map(|(name, meaning)| (name.to_string(), *meaning)).collect(),
        ),
        (
            "Functions".to_string(),
            FUNCTIONS.iter().map(|function| (function.name.to_string(), function.meaning)).collect(),
        ),
        ("Over a graph".to_string(), SUMS.iter().map(|(form, meaning)| (form.to_string(), *meaning)).collect()),
    ];
    for subject in [Subject::Graph, Subject::Platoon, Subject::Matrices, Subject::Flock, Subject::Motion] {
        let own = quantities().iter().filter(|quantity| quantity.subject == subject);
        let rows = own.map(|quantity| (with_arguments(quantity.name, quantity.arguments), quantity.meaning));
        sections.push((format!("Quantities of {}", subject.words()), rows.collect()));
    }
    let others = not_decided().map(|(name, why)| (name.to_string(), why));
    sections.push(("Observables of `simulate` that no question decides".to_string(), others.collect()));
    sections
}

/// The quantity of that name, of one of these subjects.
pub(crate) fn quantity_of(name: &str, subjects: &[Subject]) -> Option<&'static Quantity> {
    quantities().iter().find(|quantity| quantity.name == name && subjects.contains(&quantity.subject))
}

/// What is wrong with a name that is no quantity of the subjects: another subject's, or none.
pub(crate) fn unknown_quantity(owner: Option<&str>, name: &str, known: &[String]) -> Problem {
    if let Some(quantity) = quantities().iter().find(|quantity| quantity.name == name) {
        return Problem::NoSubject {
            name: name.to_string(),
            subject: quantity.subject.words(),
            missing: quantity.subject.needs().to_string(),
        };
    }
    if let Some((_, why)) = not_decided().find(|(other, _)| *other == name) {
        return Problem::Other(format!("`{name}` is an observable of `simulate` that no question decides: {why}"));
    }
    if let ("true" | "false", None) = (name, owner) {
        let written = if name == "true" { "0 = 0" } else { "0 = 1" };
        let why =
            format!("a property is made of comparisons: `{name}` is no name in it, and can be written `{written}`");
        return Problem::Other(why);
    }
    let full = owner.map_or(name.to_string(), |owner| format!("{owner}.{name}"));
    Problem::unknown("name", &full, known.iter().map(String::as_str))
}
