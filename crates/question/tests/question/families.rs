use super::{answer, asked, read, refusal, verdict};
use algebra::graph::Graph;
use algebra::graph::classes::{connected_graphs, digraphs, graphs, trees};
use arithmetic::Unwatched;
use question::Verdict;

fn counts<T>(orders: std::ops::RangeInclusive<usize>, list: impl Fn(usize) -> Vec<T>) -> Vec<usize> {
    orders.map(|order| list(order).len()).collect()
}

#[test]
fn classes_of_graphs_have_the_known_numbers() {
    assert_eq!(counts(1..=8, |n| graphs(n, &Unwatched).expect("graphs")), [1, 2, 4, 11, 34, 156, 1044, 12346]);
    assert_eq!(counts(1..=8, |n| connected_graphs(n, &Unwatched).expect("graphs")), [1, 1, 2, 6, 21, 112, 853, 11117]);
    assert_eq!(counts(1..=12, |n| trees(n, &Unwatched).expect("trees")), [1, 1, 1, 2, 3, 6, 11, 23, 47, 106, 235, 551]);
    assert_eq!(counts(1..=5, |n| digraphs(n, &Unwatched).expect("digraphs")), [1, 3, 16, 218, 9608]);
}

#[test]
fn classes_are_those_of_the_naive_enumeration() {
    for order in 1..=6 {
        let codes = |list: Vec<Graph>| {
            let mut codes: Vec<_> = list.iter().map(Graph::isomorphism_code).collect();
            codes.sort();
            codes
        };
        let found = connected_graphs(order, &Unwatched).expect("graphs");
        assert_eq!(codes(found), codes(Graph::connected_up_to_isomorphism(order)));
    }
}

#[test]
fn cases_are_numbered_without_gaps() {
    for (family, property, number) in [
        ("n = \"2..5\"\ngraph = \"connected(n)\"", "edges > 0", 30),
        ("a = \"1..3\"\nb = \"a..4\"\nc = \"1..2\"", "b > c", 18),
        ("a = \"1..3\"\nb = \"1..4\"", "a > b", 12),
        ("a = [1, 5, \"7/2\"]\nb = \"a + 1\"", "b > 0", 3),
        ("graph = [\"ring:5\", \"path(4)\", \"edges:3:1-2,2-3\"]", "edges > 0", 3),
    ] {
        let question = read(&asked(family, property, "1 < 0")).expect("a question");
        assert_eq!(question.cases(&Unwatched), Ok(number), "{family}");
        let texts: std::collections::BTreeSet<String> =
            (0..number).map(|k| question.case(k, &Unwatched).expect("a case").expect("a member").to_string()).collect();
        assert_eq!(texts.len() as u64, number, "{family}");
        assert!(question.case(number, &Unwatched).expect("no error").is_none());
    }
}

#[test]
fn where_restricts() {
    let coprime = asked("n = \"1..6\"\nm = \"1..6\"\nwhere = \"gcd(n, m) = 1\"", "n != m or n = 1", "n = m");
    let answer = answer(&coprime);
    assert_eq!((answer.verdict, answer.cases), (Verdict::Holds, 23));
    assert_eq!(verdict("x = \"[0, 2]\"\nwhere = \"x >= 1\"", "x > 1/2"), Verdict::Holds);
}

#[test]
fn samples_never_hold() {
    let family = "seed = \"1..20\"\nn = \"6\"\ngraph = \"random(n, 1/2)\"";
    let answer = answer(&asked(family, "edges <= 15", "edges < 3"));
    assert_eq!((answer.verdict, answer.cases, &answer.grades[..]), (Verdict::Undecided, 20, &["fuzzed"][..]));
    assert_eq!(verdict(family, "edges <= 8"), Verdict::False);
}

/// Arcs each way are two arcs, in a family, in a text and in a file; what is found false is said with arcs again, and stays so when it is decided once more.
#[test]
fn directed_graphs_stay_directed() {
    let family = "n = \"2..3\"\ng = \"digraphs(n)\"";
    assert_eq!(verdict(family, "connected implies edges >= n"), Verdict::Holds);
    let found = answer(&asked(family, "connected implies edges > 2", "n < 0"));
    assert_eq!(found.counterexample.expect("a counterexample").to_string(), "n = 2, g = arcs:2:1-2,2-1");
    let again = answer(&found.replay.expect("a replay"));
    assert_eq!(
        (again.verdict, again.counterexample.expect("it").to_string()),
        (Verdict::False, "n = 2, g = arcs:2:1-2,2-1".to_string())
    );
    for (graph, edges) in [
        ("arcs:2:1-2,2-1", 2),
        ("arcs:3:1-2*2,2-1*2", 2),
        ("edges:2:1-2", 1),
        ("edges:3:1-2*2,2-3", 2),
        ("cycle:2", 2),
        ("cycle:3", 3),
        ("ring:3", 3),
        ("platoon2:1", 1),
        ("complete:3", 3),
    ] {
        assert_eq!(verdict(&format!("g = \"{graph}\""), &format!("edges = {edges}")), Verdict::Holds, "{graph}");
    }
    for (file, edges) in [
        ("1 2\n", 1),
        ("directed\n1 2\n2 1\n", 2),
        ("%%MatrixMarket matrix coordinate pattern symmetric\n2 2 1\n2 1\n", 1),
        ("%%MatrixMarket matrix coordinate pattern general\n2 2 2\n2 1\n1 2\n", 2),
    ] {
        let text = asked("g = \"file:net\"", &format!("edges = {edges}"), "edges < 0");
        let question = question::Question::read(&text, &|_| Ok(file.to_string())).expect("a question");
        assert_eq!(question::decide(&question, &Unwatched).expect("an answer").verdict, Verdict::Holds, "{file}");
    }
}

/// An edge that is listed twice is refused, in either direction and with any weight, with both places.
#[test]
fn edges_are_listed_once() {
    for (graph, second, first) in [
        ("edges:3:1-2,2-3,1-2", 3, 1),
        ("edges:3:1-2,2-1", 2, 1),
        ("edges:3:1-2,2-1*2", 2, 1),
        ("arcs:3:1-2,2-1,1-2*3", 3, 1),
    ] {
        let message = refusal(&asked(&format!("g = \"{graph}\""), "edges > 0", "edges < 0"));
        let places = format!("number {second} of the list, is its number {first} already");
        assert!(message.starts_with("line 4") && message.contains(&places), "{message}");
    }
    let message = refusal(&asked("g = \"edges:3:1-2,2-1\"", "edges > 0", "edges < 0"));
    assert!(message.starts_with("line 4, column 18: "), "{message}");
}
