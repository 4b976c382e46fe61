//! The site: what is written in the ledger is escaped, formulas are set, links lead to pages, and bytes are the same.

use ledger::Document;
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

fn pages(text: &str) -> Vec<Page> {
    let document = Document::read(text).expect("a ledger");
    let ledger = claims::ledger().expect("the claims");
    Site::new(&document, &ledger, &[]).pages().expect("the pages")
}

fn page(pages: &[Page], path: &str) -> String {
    let page = pages.iter().find(|page| page.path == path).unwrap_or_else(|| panic!("{path} is missing"));
    String::from_utf8(page.contents.clone()).expect("text")
}

/// The formulas of a statement as they stand on its page.
fn statement(text: &str) -> String {
    let pages = pages(&ledger("veerman.own", text));
    let page = page(&pages, "claims/veerman.own.html");
    let (_, rest) = page.split_once("<blockquote class=\"statement\"><p>").expect("the statement");
    rest.split_once("</p>").expect("its end").0.to_string()
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
fn the_same_ledger_gives_the_same_bytes_without_times() {
    let text = ledger("veerman.own", "x = 1");
    let pages = [pages(&text), pages(&text.replace("1.5", "2.5"))];
    assert_eq!(pages[0], pages[1]);
}

#[test]
fn one_claim_stands_alone() {
    let text = ledger("veerman.own", "x = 1");
    let document = Document::read(&text).expect("a ledger");
    let ledger = claims::ledger().expect("the claims");
    let page = Site::new(&document, &ledger, &[]).alone("veerman.own").expect("the page");
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
