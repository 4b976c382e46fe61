//! Questions without controls, hypotheses that are never met, and lists of members.

use super::{answer, read};
use arithmetic::Unwatched;
use question::{Answer, Verdict, decide};

fn without(family: &str, property: &str) -> String {
    format!("[question]\nid = \"test\"\n[for]\n{family}\n[holds]\nproperty = \"{property}\"\n")
}

fn listed(text: &str, counterexamples: u64, tight: u64) -> Answer {
    let mut question = read(text).expect("a question");
    (question.listed_counterexamples, question.listed_tight) = (counterexamples, tight);
    decide(&question, &Unwatched).expect("an answer")
}

fn texts(answer: &Answer) -> Vec<String> {
    answer.made.as_ref().expect("made").controls.iter().map(|control| control.property.clone()).collect()
}

const CONNECTED: &str = "n = \"2..5\"\ngraph = \"connected(n)\"";

#[test]
fn controls_are_made_and_refuted() {
    let found = answer(&without(CONNECTED, "lambda(2) >= 2*(1 - cos(pi/n))"));
    assert_eq!(found.verdict, Verdict::Holds);
    let made = texts(&found);
    assert_eq!(found.controls.len(), 2);
    assert_eq!(made, ["not lambda(2) >= 2*(1 - cos(pi/n))", "lambda(2) >= 2*(1 - cos(pi/n)) + 1/100"]);
    let json = found.json(None);
    assert_eq!((&json["controls"]["made"], &json["controls"]["refuted"]), (&true.into(), &2.into()));
    // Each of them is false by the same check.
    for control in made {
        assert_eq!(answer(&without(CONNECTED, &control)).verdict, Verdict::False, "{control}");
    }
    let given = answer(&super::asked(CONNECTED, "edges > 0", "edges > 1"));
    assert_eq!((given.made.is_none(), &given.json(None)["controls"]["made"]), (true, &false.into()));
}

#[test]
fn a_hypothesis_is_left_out_and_looked_for() {
    let needed = answer(&without(CONNECTED, "tree implies edges <= n - 1"));
    assert_eq!(needed.verdict, Verdict::Holds);
    assert!(texts(&needed).contains(&"edges <= n - 1".to_string()), "{needed:?}");
    let idle = answer(&without(CONNECTED, "tree implies edges >= n - 1"));
    assert!(idle.why.contains("without the hypothesis"), "{}", idle.why);
    for text in [
        without(CONNECTED, "max_degree > n implies edges > 100"),
        super::asked(CONNECTED, "max_degree > n implies edges > 100", "edges > 100"),
    ] {
        let never = answer(&text);
        assert_eq!(never.verdict, Verdict::Holds);
        assert!(never.why.contains("No member of the family meets the hypothesis max_degree > n"), "{}", never.why);
    }
    assert!(!needed.why.contains("meets the hypothesis"));
    for (range, property, said) in [
        (
            "n = \"1..3\"",
            "n = 2 implies (n = 100 implies n > 1000)",
            "No member of the family meets the hypothesis n = 2 and n = 100",
        ),
        ("n = \"[0, 1]\"", "n > 2 implies n < 0", "No point of the family meets the hypothesis n > 2"),
        ("n = \"any\"", "n > 1 and n < 0 implies n = 3", "No point of the family meets the hypothesis n > 1 and n < 0"),
    ] {
        let never = answer(&without(range, property));
        assert_eq!(never.verdict, Verdict::Holds, "{range}");
        assert!(never.why.contains(said), "{}", never.why);
    }
    let nowhere = answer(&without(CONNECTED, "edges > 100"));
    assert_eq!((nowhere.verdict, nowhere.controls.len()), (Verdict::False, 0));
    assert!(nowhere.why.contains("every member"), "{}", nowhere.why);
    let text = nowhere.text(None);
    assert!(text.contains("no control could be made by the program: not edges > 100 holds for every member"), "{text}");
    assert!(!text.contains("refuted: 0"), "{text}");
    // Its replay has no control either, and is decided alike.
    let alone = answer(nowhere.replay.as_ref().expect("a replay"));
    assert_eq!((alone.verdict, alone.text(None).contains("no control could be made")), (Verdict::False, true));
}

/// Every made control of a question, each refuted by the same check, and false at the member that it names: as a question of that member alone.
fn refuted_where_they_say(family: &str, property: &str) -> Vec<String> {
    let found = answer(&without(family, property));
    assert_eq!(found.verdict, Verdict::Holds, "{property}: {}", found.why);
    for control in &found.made.as_ref().expect("made").controls {
        let bound = |(name, value): (&str, &question::Value)| format!("{name} = \"{}\"\n", value.text());
        let alone: String = control.fails_at.iter().map(bound).collect();
        let text = format!("{}where = \"n > 0\"\n", alone);
        let there = answer(&without(&text, &control.property));
        assert_eq!((there.verdict, there.cases), (Verdict::False, 1), "{} at {}", control.property, control.fails_at);
        assert!(answer(&without(family, &control.property)).counterexample.is_some());
    }
    texts(&found)
}

#[test]
fn each_bound_is_made_sharper_past_its_smallest_margin() {
    for (property, sharper) in [
        // Each part of a conjunction, and each link of a chain.
        ("edges >= n - 1 and max_degree < n", &["edges >= n - 1 + 1/100", "max_degree < n - 101/100"][..]),
        ("1 <= diameter < n", &["1 <= diameter - 1/100", "diameter < n - 101/100"]),
        // After its hypotheses alone: of trees of three vertices and more.
        (
            "n >= 3 implies (tree implies max_degree >= 3/2)",
            &["tree implies max_degree >= 3/2", "n >= 3 implies tree implies max_degree >= 3/2 + 501/1000"],
        ),
        // Where the other parts of a disjunction fail.
        ("tree or girth >= 3", &["tree or girth >= 3 + 1/100"]),
        (
            "edges <= 2*n - 3 or max_degree >= 3",
            &["edges <= 2*n - 3 - 1/100 or max_degree >= 3", "edges <= 2*n - 3 or max_degree >= 3 + 1/100"],
        ),
        // Neither is needed where the other one is true everywhere.
        ("edges <= n + 5 or diameter <= 4", &[]),
        // A small margin is passed by little.
        ("edges + 1/300 >= n - 1", &["edges + 1/300 >= n - 1 + 167/50000"]),
        ("edges >= n - 300", &["edges >= n - 300 + 300"]),
        // A negation is made sharper by no rule.
        ("not max_degree > n + 6", &[]),
    ] {
        assert_eq!(refuted_where_they_say(CONNECTED, property)[1..], *sharper, "{property}");
    }
    // Margins that are enclosed.
    refuted_where_they_say(CONNECTED, "lambda(n) <= max_degree + 3 and (bipartite or lambda(2) <= n)");
}

#[test]
fn a_margin_beside_an_implication_is_that_of_its_conclusion() {
    // K4 is the first to have more than 5 edges; the hypothesis is met there by 1 and by 3.
    for (hypothesis, margin) in [("edges > 5", -97.0), ("edges > 3", -97.0)] {
        let found = answer(&without("graph = \"complete:4\"", &format!("{hypothesis} implies edges >= 103")));
        assert_eq!(found.margin.map(|margin| (margin.lo, margin.hi)), Some((margin, margin)), "{hypothesis}");
    }
    // Where no member meets the hypothesis there is none.
    let never = answer(&without(CONNECTED, "edges > 100 implies diameter < 50"));
    assert!(!never.text(None).contains("margin"), "{}", never.text(None));
    // The smallest one is that of the members that meet it.
    let some = answer(&without(CONNECTED, "n >= 4 implies edges >= n - 2"));
    assert_eq!(some.margin.map(|margin| (margin.lo, margin.hi)), Some((1.0, 1.0)));
}

#[test]
fn counterexamples_and_extremal_graphs_are_listed_in_order() {
    let text = without(CONNECTED, "edges <= n");
    let found = listed(&text, 3, 100);
    let list = found.counterexamples.as_ref().expect("counterexamples");
    let graphs: Vec<String> = list.members.iter().map(|own| own.bindings.to_string()).collect();
    assert_eq!((graphs.len(), list.cut), (3, true));
    assert!(graphs[0].starts_with("n = 4, ") && graphs[2].starts_with("n = 5, "), "{graphs:?}");
    assert_eq!(Some(graphs[0].clone()), found.counterexample.as_ref().map(ToString::to_string));
    for own in &list.members {
        let sides = own.decisive.as_ref().expect("sides");
        assert_eq!(sides.inequality, "edges <= n");
        let [left, right] = [&sides.left, &sides.right].map(|text| text.parse::<f64>().expect("an integer"));
        assert_eq!((own.margin.lo, own.margin.hi), (right - left, right - left));
    }
    // One cycle: 1 graph of three vertices, 2 of four, 5 of five (OEIS A001429).
    let tight = found.tight.as_ref().expect("a list");
    assert_eq!((tight.what.as_str(), tight.members.len(), tight.cut), ("edges = n", 8, false));
    assert!(tight.members.iter().all(|own| own.margin.lo == 0.0 && own.margin.hi == 0.0));
    // The margin beside the counterexample is its own.
    assert_eq!(found.margin.map(|margin| (margin.lo, margin.hi)), Some((-1.0, -1.0)));
    assert!(found.text(None).contains("margin there = -1"), "{}", found.text(None));
    // The path alone attains Fiedler's bound; where the hypothesis fails nothing is attained.
    let fiedler = listed(&without(CONNECTED, "n > 3 implies lambda(2) >= 2*(1 - cos(pi/n))"), 0, 10);
    let graphs: Vec<String> =
        fiedler.tight.expect("a list").members.iter().map(|own| own.bindings.to_string()).collect();
    assert_eq!(graphs.len(), 2, "{graphs:?}");
    assert!(fiedler.counterexamples.is_none());
    // What is shown is the equation, not a hypothesis that happens to be one; kinds of matrices have their names with a hyphen, too.
    let girth =
        "edges <= n*(n - 1)/2 and not tree implies girth <= n and lambda(2, out-degree) = lambda(2, out_degree)";
    let rings = listed(&without(CONNECTED, girth), 0, 10).tight.expect("a list");
    let shown: Vec<_> =
        rings.members.iter().map(|own| own.decisive.as_ref().expect("sides").inequality.as_str()).collect();
    assert_eq!(shown, ["girth = n"; 3]);
    assert!(listed(&without(CONNECTED, "planar or edges > 0"), 0, 10).tight.is_none());
    assert!(listed(&without(CONNECTED, "planar"), 5, 0).counterexamples.is_some());
}
