//! Tables and attacks of questions of one's own.

use arithmetic::Unwatched;
use campaign::fuzz::{Attack, FuzzError, Summary};
use campaign::job::Campaign;
use campaign::store::run_in_memory;
use campaign::sweep::{Sweep, Table, TableRow};
use question::Question;

fn read(text: &str) -> Question {
    Question::read(text, &|name| Err(format!("there is no file {name}"))).expect("a question")
}

fn stated(family: &str, property: &str, control: &str) -> Question {
    read(&format!(
        "[question]\nid = \"test\"\n[for]\n{family}\n[holds]\nproperty = \"{property}\"\ncontrols = [\"{control}\"]\n"
    ))
}

fn summary(attack: &Attack) -> Summary {
    let run = run_in_memory(attack, &Unwatched).expect("it runs");
    Summary::new(&[attack.id()], attack.seed(), run.cases, &run.rows).expect("rows of an attack")
}

#[test]
fn a_true_statement_survives() {
    let question = stated("n = \"2..6\"\ngraph = \"connected(n)\"", "lambda(2) > 0", "lambda(2) > 1");
    let attack = Attack::new(question, 100, "0").unwrap();
    let summary = summary(&attack);
    assert_eq!((summary.cases(), summary.failed()), (100, 0));
    let margin = summary.invariants[0].margin.expect("an inequality").value;
    // The least of them all is the path of six: 2 - 2 cos(pi/6).
    assert!((0.26..1.0).contains(&margin), "{margin}");
}

/// True for almost all: chance alone does not hit the one counterexample, steps along the margin do.
#[test]
fn the_worst_case_is_made_worse() {
    let question = stated("x = \"0..1000000\"", "abs(x - 123456) > 0", "x > 5");
    let attack = Attack::new(question, 64, "0").unwrap();
    let before = summary(&attack).invariants[0].margin.expect("an inequality").value;
    assert!(before < 15_000.0, "{before}");
    let near = stated("x = \"0..3000\"", "abs(x - 1234) > 0", "x > 5");
    let found = summary(&Attack::new(near, 64, "0").unwrap());
    assert_eq!(found.failed(), 1);
    assert_eq!(found.invariants[0].failures[0].instance, "x = 1234");
}

#[test]
fn every_inequality_of_a_question_has_its_smallest_margin() {
    let question = stated("x = \"0..100\"\ny = \"0..3\"", "x + 2 > 0 and (y < 5 or x < 7)", "x > 5");
    let attack = Attack::new(question, 130, "0").unwrap();
    let found = summary(&attack);
    let each: Vec<(&str, f64)> = found.invariants[0]
        .inequalities
        .iter()
        .map(|(text, own)| (text.as_str(), own.expect("a margin").value))
        .collect();
    let [(first, two), (second, five), (third, seven)] = each[..] else { panic!("{each:?}") };
    assert_eq!([first, second, third], ["x + 2 > 0", "y < 5", "x < 7"]);
    // Steps along the margin of the whole reach it where it is least, at x = 0 and y = 3.
    assert_eq!((two, five), (2.0, 2.0));
    // No case has a smaller one than that of the largest x.
    assert!((-93.0..0.0).contains(&seven), "{seven}");
    let json = found.to_json();
    assert_eq!(json["invariants"][0]["inequalities"][1]["margin"]["value"], "~2.0");
}

#[test]
fn a_counterexample_is_a_question_of_its_own() {
    let question = stated("n = \"2..6\"\ngraph = \"connected(n)\"\nx = \"[0, 3]\"", "lambda(2) > x", "lambda(2) > 5");
    let found = summary(&Attack::new(question, 50, "0").unwrap());
    assert!(found.failed() > 0);
    let failed = &found.invariants[0].failures[0];
    // Simplest: the fewest vertices with which it fails, and the only connected graph on two has the eigenvalue 2.
    assert_eq!(failed.instance, "n = 2, graph = edges:2:1-2, x = 3");
    let again = read(failed.question.as_deref().expect("a question"));
    let answer = question::decide(&again, &Unwatched).expect("decided");
    assert_eq!(answer.verdict, question::Verdict::False);
}

#[test]
fn members_without_values_are_passed_over() {
    let question = stated("n = \"2..4\"\nm = \"n..3\"\nwhere = \"gcd(n, m) = 1\"", "n < m", "n > m");
    let found = summary(&Attack::new(question, 40, "0").unwrap());
    assert_eq!((found.cases(), found.failed()), (40, 0));
}

#[test]
fn what_cannot_be_attacked_is_refused() {
    let values = || read("[question]\nid = \"a\"\n[for]\nn = \"1..3\"\n[values]\nsquare = \"n^2\"\n");
    let refused = Attack::new(values(), 10, "0").err().expect("only values").to_string();
    assert!(refused.starts_with("line 5, column 1: ") && refused.contains("no property to attack"), "{refused}");
    let question = stated("n = \"1..3\"", "n > 0", "n > 1");
    assert!(matches!(Attack::new(question, 0, "0"), Err(FuzzError::Cases(0))));
}

fn table(question: Question) -> Table {
    let sweep = Sweep::new(question, &Unwatched).expect("a family");
    let run = run_in_memory(&sweep, &Unwatched).expect("it runs");
    Table::new(&sweep.canonical(), &run.rows).expect("a table")
}

#[test]
fn tables_have_a_row_for_each_member() {
    let table = table(read(
        "[question]\nid = \"a\"\n[for]\nn = \"1..4\"\nwhere = \"not n = 3\"\n[values]\nsquare = \"n^2/2\"\nroot = \"sqrt(n)\"\n",
    ));
    assert_eq!(table.names, ["n"]);
    assert_eq!(table.rows.len(), 3);
    let csv = table.csv().expect("CSV");
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(lines[0], "n,square,root.lo,root.hi");
    assert_eq!(lines[1], "1,1/2,1,1");
    assert!(lines[2].starts_with("2,2,1.41421356237309504"), "{}", lines[2]);
    let first = table.json_lines();
    let first: serde_json::Value = serde_json::from_str(first.lines().nth(1).expect("a line")).expect("JSON");
    assert_eq!((&first["n"], &first["square"]), (&"2".into(), &"2".into()));
    assert!(first["root"]["lo"].as_str().is_some_and(|lo| lo.starts_with("1.4142135623730950488")));
    let text = table.text(2, 80);
    assert!(text.contains("1.4142135623..") || text.contains("1.414213562373.."), "{text}");
    assert!(text.ends_with("and 1 more rows\n"));
}

/// Graphs are read again, so that they are never cut: a long one stands at the end of its line.
#[test]
fn tables_do_not_cut_graphs() {
    let table = table(read(
        "[question]\nid = \"a\"\n[for]\nn = \"4..6\"\ngraph = \"connected(n)\"\nwhere = \"edges = n*(n - 1)/2\"\n[values]\ndegree = \"max_degree\"\nroot = \"sqrt(n)\"\n",
    ));
    for width in [20, 40, 80] {
        let text = table.text(10, width);
        for row in &table.rows {
            assert!(text.contains(&row.names[1]), "{width}: {text}");
        }
        assert!(!text.contains("1-2.."), "{text}");
    }
    assert!(table.text(10, 40).lines().nth(1).expect("a row").ends_with("edges:4:1-2,1-3,1-4,2-3,2-4,3-4"));
}

#[test]
fn tables_put_together_by_hand_may_lack_cells() {
    let row = TableRow { names: vec!["1".into()], values: vec![true.into()], regions: serde_json::Value::Null };
    let (id, names) = ("a".to_string(), vec!["n".to_string()]);
    let table = Table { id, names, columns: vec!["holds".into(), "margin".into()], rows: vec![row] };
    assert_eq!(table.text(1, 80), "n  holds  margin\n1   true\n");
    assert!(table.csv().is_err());
}

#[test]
fn a_property_is_tabulated_with_its_margin() {
    let table = table(stated("n = \"1..3\"", "n > 3/2", "n > 2"));
    let csv = table.csv().expect("CSV");
    assert_eq!(csv, "n,holds,margin.lo,margin.hi\n1,false,-0.5,-0.5\n2,true,0.5,0.5\n3,true,1.5,1.5\n");
}

#[test]
fn controls_are_run_with_the_cases() {
    let bites = stated("n = \"1..50\"", "n > 0", "n < 40");
    assert!(summary(&Attack::new(bites, 200, "0").unwrap()).controls_bite());
    // Only 1 of a million refutes it, and no case has it.
    let blunt = stated("n = \"1..1000000\"", "n > 0", "n != 777777");
    let found = summary(&Attack::new(blunt, 64, "0").unwrap());
    assert!(!found.controls_bite() && found.failed() == 0);
    assert_eq!(found.to_json()["invariants"][0]["controls"], serde_json::json!({"refuted": 0, "total": 1}));
}
