//! The site: what is written in the ledger is escaped, formulas are set, links lead to pages, and bytes are the same.

use arithmetic::{Rational, rational};
use ledger::{Document, Ledger, Number, Witness};
use report::{FIGURES, Page, Site};
use std::collections::BTreeSet;

/// A ledger with one entry of the user's.
fn ledger(id: &str, statement: &str) -> String {
    let clauses = serde_json::json!([statement]);
    serde_json::json!({
        "schema": "flockproof.ledger/2", "version": "0.1.0", "seed": "flockproof",
        "claims": [{
            "id": id, "paper": "veerman", "place": "Lemma 1", "statement": statement, "clauses": clauses, "reading": null,
            "verdict": "holds", "fault": null, "corrected": null, "counterexample": null,
            "evidence": [{"grade": "exact", "clauses": [1], "scope": "instances", "part": "a part", "detail": "notes/settling.md",
                "cases": 3, "error_bound": "2^-64"}],
            "controls": {"refuted": 1, "total": 1, "what": ["a sign"], "failed": ["at 1/2"]},
            "values": {}, "why": null, "seconds": 1.5
        }]
    })
    .to_string()
}

/// Small texts in the place of the files that the program brings.
fn texts(path: &str) -> Option<&'static str> {
    match path {
        "assets/questions/gap_and_diameter.toml" => Some(
            "[question]\nid = \"mine\"\n[for]\nn = \"3\"\ngraph = \"connected(n)\"\n[holds]\nproperty = \"diameter < 3\"\n\
             controls = [\"diameter < 2\"]\n",
        ),
        "assets/scenarios/switching_flock.toml" => Some(
            "model = \"velocity-alignment\"\n[graph]\nkind = \"within\"\nradius = 2\n[state]\npositions = [[0, 0], [1, 0]]\n\
             velocities = [[1, 0], [0, 1]]\n[law]\npotential = \"inverse-square-log\"\n[run]\nuntil = 1\n",
        ),
        _ => path.strip_prefix("notes/").map(|_| {
            "# A note\n\nA sentence.\n\n| name of `it` | what \"it\" is |\n|---|---|\n| one | 1 |\n| two | |\n\n\
             | other |\n|---|\n| three |\n"
        }),
    }
}

fn pages(text: &str) -> Vec<Page> {
    let document = Document::read(text).expect("a ledger");
    let ledger = claims::ledger().expect("the claims");
    Site::new(&document, &ledger, &[], texts).pages().expect("the pages")
}

/// The formulas of a statement as they stand on its page.
fn statement(text: &str) -> String {
    let text = ledger("veerman.own", text);
    let document = Document::read(&text).expect("a ledger");
    let ledger = Ledger::new();
    let page = Site::new(&document, &ledger, &[], texts).alone("veerman.own").expect("the page");
    let (_, rest) = page.split_once("<blockquote class=\"statement\"><p>").expect("the statement");
    rest.split_once("</p>").expect("its end").0.to_string()
}

#[test]
fn an_explanation_is_as_narrow_as_is_asked() {
    let long = "Section 2, Ergodicity, the third paragraph after equation (12), with the figure on the page before and its caption";
    let text = ledger("veerman.own", &"a statement of many words ".repeat(9)).replace("Lemma 1", long);
    let document = Document::read(&text).expect("a ledger");
    for width in [40, 80] {
        let text = report::explain(&document.claims[0], &Ledger::new(), width);
        assert!(text.lines().all(|line| line.chars().count() <= width), "{text}");
        assert_eq!(text.lines().next().and_then(|line| line.split("  (").next()), Some("veerman.own"));
        let place = text.split("\n  printed").next().expect("the first lines");
        assert!(place.split_whitespace().collect::<Vec<_>>().join(" ").ends_with(&format!("({long})")), "{place}");
    }
}

#[test]
fn what_the_ledger_says_is_escaped() {
    let hostile = "<script>alert(1)</script> \"a\" & <b onclick='x'> </p>";
    for page in pages(&ledger("veerman.own", hostile)).iter().filter(|page| page.path.ends_with(".html")) {
        let text = String::from_utf8_lossy(&page.contents);
        assert!(!text.contains("<script>alert") && !text.contains("<b onclick"), "{}", page.path);
    }
}

#[test]
fn ids_that_are_no_names_of_files_are_refused() {
    for id in ["../x", "a/b", "", "a..b", ".a", "a b", "a\u{0}", "<b>"] {
        assert!(Document::read(&ledger(id, "x")).is_err(), "{id:?}");
    }
    assert!(Document::read("{}").is_err() && Document::read("[1").is_err());
    assert!(Document::read(&ledger("a.b", "x").replace("ledger/2", "ledger/9")).is_err());
}

#[test]
fn a_ledger_is_read_as_it_was_written() {
    let text = ledger("veerman.own", "x = 1");
    let document = Document::read(&text).expect("a ledger");
    let again = Document::read(&document.json()).expect("the same");
    assert_eq!(again.json(), document.json());
}

#[test]
fn formulas_are_set_and_prose_is_not() {
    assert_eq!(statement("K_0 birds"), "<math><msub><mi>K</mi><mn>0</mn></msub></math> birds");
    assert_eq!(
        statement("n^-2"),
        "<math><msup><mi>n</mi><mrow><mo form=\"prefix\">−</mo><mn>2</mn></mrow></msup></math>"
    );
    assert!(statement("thdot_k is zero").starts_with("<math><msub><mover><mi>θ</mi>"));
    assert!(statement("at most sqrt(2)").contains("<msqrt><mn>2</mn></msqrt>"));
    assert!(statement("M = [[1,2],[3,4]]").contains("<mtr><mtd><mn>3</mn></mtd><mtd><mn>4</mn></mtd></mtr>"));
    assert!(statement("<x, L x> >= 0").contains("⟨"));
    // Words, references, edges of graphs, units and abbreviations stay as they are.
    for prose in [
        "A flock that stays",
        "by (22) and Lemma 3.1",
        "edges {1-2, 2-3}",
        "within 2 m of it",
        "a.e., that is, not always",
        "m/s",
    ] {
        assert_eq!(statement(prose), prose);
    }
    assert_eq!(
        statement("see $a + b$"),
        "see <math><mi>a</mi></math><wbr><math><mo form=\"infix\" stretchy=\"false\">+</mo><mi>b</mi></math>"
    );
}

#[test]
fn any_text_gives_tags_that_match() {
    for text in [
        "((a_1",
        "x^",
        "_",
        "^^",
        "a_{b",
        "<x, y",
        "sqrt(",
        "binom(n",
        "[[1,2],[3",
        "|x|^",
        "'",
        "2^^Omega(n)",
        "$",
        "a $b",
        "∞²",
        "é_ü",
    ] {
        let set = statement(text);
        for tag in ["math", "mrow", "msup", "msub", "mi", "mo", "span"] {
            let (open, close) = (
                set.matches(&format!("<{tag}>")).count() + set.matches(&format!("<{tag} ")).count(),
                set.matches(&format!("</{tag}>")).count(),
            );
            assert_eq!(open, close, "{tag} in {set}");
        }
    }
}

#[test]
fn brackets_within_brackets_end_somewhere() {
    for text in ["(".repeat(20_000), "(a_1 ".repeat(5_000), format!("{}x{}", "[".repeat(5_000), "]".repeat(5_000))] {
        assert!(statement(&text).starts_with(&text[..1]));
    }
}

#[test]
fn the_same_ledger_gives_the_same_bytes_without_times() {
    let text = ledger("veerman.own", "x = 1");
    let pages = [pages(&text), pages(&text.replace("1.5", "2.5"))];
    assert_eq!(pages[0], pages[1]);
}

/// Narrow windows show the name of a column beside each of its cells.
#[test]
fn cells_of_notes_have_the_names_of_their_columns() {
    let pages = pages(&ledger("veerman.own", "one is one"));
    let note = pages.iter().find(|page| page.path == "guarantees.html").expect("the note");
    let text = String::from_utf8_lossy(&note.contents);
    let cells = [
        "<th>name of <code>it</code></th><th>what",
        "<td data-label=\"name of it\">one</td><td data-label=\"what &quot;it&quot; is\">1</td>",
        "<td data-label=\"name of it\">two</td><td data-label=\"what &quot;it&quot; is\"></td>",
        "<td data-label=\"other\">three</td>",
    ];
    for cell in cells {
        assert!(text.contains(cell), "{cell}: {text}");
    }
}

#[test]
fn one_claim_stands_alone() {
    let text = ledger("veerman.own", "x = 1");
    let document = Document::read(&text).expect("a ledger");
    let ledger = claims::ledger().expect("the claims");
    let page = Site::new(&document, &ledger, &[], texts).alone("veerman.own").expect("the page");
    assert!(!page.contains("href=\"../") && !page.contains("src="), "it needs no other file");
}

#[test]
fn figures_name_claims_that_exist() {
    let ledger = claims::ledger().expect("the claims");
    let known: BTreeSet<&str> = ledger.ids().collect();
    for figure in FIGURES {
        assert!(!figure.claims.is_empty(), "{} belongs to no claim", figure.name);
        for id in figure.claims {
            assert!(known.contains(id), "{}: there is no claim {id}", figure.name);
        }
    }
}

/// What is drawn of a counterexample: the names of the pictures.
fn drawn(witnesses: &[Witness]) -> Vec<String> {
    let mut entry: serde_json::Value = serde_json::from_str(&ledger("veerman.own", "x")).expect("a ledger");
    entry["claims"][0]["counterexample"] = "somewhere".into();
    entry["claims"][0]["witnesses"] = serde_json::to_value(witnesses).expect("JSON");
    let text = entry.to_string();
    let document = Document::read(&text).expect("a ledger");
    let ledger = Ledger::new();
    let page = Site::new(&document, &ledger, &[], texts).alone("veerman.own").expect("the page");
    let Some((_, rest)) = page.split_once("<div class=\"drawings\">") else { return Vec::new() };
    let (section, _) = rest.split_once("</section>").expect("its end");
    section.split(" aria-label=\"").skip(1).map(|rest| rest.split('"').next().unwrap_or_default().to_string()).collect()
}

fn point(x: i64, y: i64) -> [Rational; 2] {
    [x, y].map(|x| rational(x, 1))
}

#[test]
fn counterexamples_are_drawn_from_their_numbers() {
    let (half, zero) = (rational(1, 2), rational(0, 1));
    let two = [point(0, 0), point(1, 1)];
    assert_eq!(
        drawn(&[
            Witness::agents(&two, &[point(0, 2), point(0, 1)], &[]),
            Witness::compared("the sum", &half, "claimed", &zero)
        ]),
        ["The 2 points, with arrows for velocities.", "computed 1/2, claimed 0"]
    );
    let swinging = Witness::agents(&two, &[point(2, 0), point(2, 0)], &[(0, 1)]);
    assert_eq!(drawn(&[swinging]), ["The 2 points, with arrows for velocities; lines are links."]);
    assert_eq!(
        drawn(&[Witness::networks(3, vec![vec![], vec![(0, 1)], vec![(0, 1), (1, 2)]])]),
        ["Graph with 3 vertices and 0 edges", "Graph with 3 vertices and 1 edge", "Graph with 3 vertices and 2 edges"]
    );
    let arc = Witness::Networks { order: 2, networks: vec![vec![(0, 1)]], directed: true };
    let turns = Witness::Phases { turns: vec![Number(zero.clone()), Number(rational(1, 4))] };
    assert_eq!(drawn(&[arc, turns]), ["Graph with 2 vertices and 1 arc", "Phases on the circle"]);
    let points = vec![[3.into(), 4.into()], [(-3).into(), (-4).into()]];
    assert_eq!(drawn(&[Witness::Directions { points }]), ["Phases on the circle"]);
    // A network of the agents that variables place is drawn with them.
    let values = ["x_1", "y_1", "tan(th_1/2)", "x_2", "y_2", "tan(th_2/2)"].map(|name| (name.to_string(), 1.into()));
    let placed = Witness::Variables { values: values[..3].to_vec() };
    assert_eq!(drawn(&[placed]), ["The point, with arrows for velocities."]);
    let placed = Witness::Variables { values: values.to_vec() };
    assert_eq!(
        drawn(&[Witness::networks(2, vec![vec![(0, 1)]]), placed]),
        ["The 2 points, with arrows for velocities; lines are links."]
    );
    let marks = vec![[1.into(), 2.into()]];
    let gain = Witness::Gain { f: (-1).into(), g: (-1).into(), marks };
    assert_eq!(drawn(&[gain]).len(), 1);
}

#[test]
fn what_does_not_fit_is_not_drawn() {
    let unknown = Witness::Variables { values: vec![("K_1".to_string(), 1.into())] };
    let nobody = Witness::agents(&[], &[], &[]);
    let strangers = Witness::agents(&[point(0, 0)], &[], &[(0, 1)]);
    let unequal = Witness::agents(&[point(0, 0)], &[point(0, 0), point(1, 0)], &[]);
    let beyond = Witness::networks(2, vec![vec![(0, 99)]]);
    let (slope, value) = (Vec::new(), [1.into(), 0.into()]);
    let flat = Witness::Potential { slope, value, tangent: None, radius: None };
    for witness in [unknown, nobody, strangers, unequal, beyond, flat] {
        assert_eq!(drawn(std::slice::from_ref(&witness)), [""; 0], "{witness:?}");
    }
}
