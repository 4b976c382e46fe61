//! Questions about all states of a law.

use arithmetic::Unwatched;
use question::{Answer, Question, Verdict, decide};

const CUCKER_SMALE: &str = "[law]\ndimension = 2\nstate = { x = \"vector\", v = \"vector\" }\nparameters = { K = 1, beta = \"1/4\" }\n\
[law.define]\n\"weight(i, j)\" = \"K / (1 + norm2(x[j] - x[i]))^beta\"\n[law.rates]\nx = \"v\"\nv = \"mean(j, weight(i, j) * (v[j] - v))\"\n\
[law.observables]\nmomentum = \"sum(i, v[i])\"\nfluctuation = \"sum(i, norm2(v[i] - mean(k, v[k]))) / 2\"\n";

fn read(family: &str, property: &str, controls: &str) -> Result<Question, String> {
    let text = format!(
        "[question]\nid = \"mine.states\"\nlaw = \"law.toml\"\n[for]\n{family}\n[holds]\nproperty = \"{property}\"\ncontrols = [{controls}]\n"
    );
    let files = |name: &str| match name {
        "law.toml" => Ok(CUCKER_SMALE.to_string()),
        other => Err(format!("no {other}")),
    };
    Question::read(&text, &files).map_err(|error| error.to_string())
}

fn answer(family: &str, property: &str, controls: &str) -> Answer {
    decide(&read(family, property, controls).unwrap(), &Unwatched).unwrap()
}

const ALL: &str = "agents = \"2..4\"\nx = \"any\"\nv = \"any\"";

#[test]
fn momentum_is_conserved_where_everybody_hears_everybody() {
    let found = answer(ALL, "rate(momentum) = 0", "\"rate(momentum) = v[1]/100\", \"rate(momentum.1) <= -x[1].1^2\"");
    assert_eq!((found.verdict, &found.grades[..]), (Verdict::Holds, &["identity"][..]), "{}", found.why);
    assert!(found.why.contains("random primes"));
    // A mean over those whom an agent hears is not symmetric where some hear more than others.
    let paths = ALL.replace("\"2..4\"", "\"3..4\"") + "\ngraph = \"path(agents)\"";
    let found = answer(&paths, "rate(momentum) = 0", "\"rate(momentum) = v[1]\"");
    assert_eq!(found.verdict, Verdict::False, "{}", found.why);
    let replay = found.replay.expect("a question of one state");
    assert!(replay.contains("law = \"law.toml\"") && replay.contains("\"v[3].2\" = "), "{replay}");
    let files = |_: &str| Ok(CUCKER_SMALE.to_string());
    let again = decide(&Question::read(&replay, &files).unwrap(), &Unwatched).unwrap();
    assert_eq!((again.verdict, &again.grades[..]), (Verdict::False, &["exact"][..]));
}

#[test]
fn a_false_rate_is_refuted_at_a_state() {
    let found = answer(ALL, "rate(fluctuation) <= -fluctuation", "\"rate(fluctuation) < -1\"");
    assert_eq!(found.verdict, Verdict::False, "{}", found.why);
    let boxed = "agents = 2\nx = \"[-1, 1]\"\nv = \"[0, 1]\"";
    let found = answer(boxed, "v[1].1 >= 0 implies rate(x[1].1) >= 0", "\"rate(x[1].1) > 0\"");
    assert_eq!((found.verdict, &found.grades[..]), (Verdict::Holds, &["certified"][..]), "{}", found.why);
}

#[test]
fn inequalities_on_boxes_that_are_not_attained() {
    let boxed = "agents = 2\nx = \"[-1, 1]\"\nv = \"any\"\n\"v[1].1\" = \"[1, 2]\"\n\"v[2].1\" = \"[-1, 0]\"\n\"v[1].2\" = 0\n\"v[2].2\" = 0";
    let found = answer(boxed, "rate(v[1].1) < -1/10", "\"rate(v[1].1) < -1\"");
    assert_eq!((found.verdict, &found.grades[..]), (Verdict::Holds, &["certified"][..]), "{}", found.why);
    // Attained where all velocities are equal: not decided by boxes.
    let found =
        answer("agents = 2\nx = \"[-1, 1]\"\nv = \"[-1, 1]\"", "rate(fluctuation) <= 0", "\"rate(fluctuation) < -1\"");
    assert_eq!(found.verdict, Verdict::Undecided, "{}", found.why);
}

#[test]
fn what_is_wrong_has_its_place() {
    let told = |family: &str, property: &str| match read(family, property, "\"1 < 0\"") {
        Err(error) => error,
        Ok(question) => decide(&question, &Unwatched).map(|found| found.why).unwrap_err().to_string(),
    };
    assert!(
        told(ALL, "rate(momentm) = 0")
            .contains("line 9, column 18: there is no name `momentm`; the nearest known name is `momentum`")
    );
    assert!(told("agents = 2\nx = \"any\"", "rate(momentum) = 0").contains("`v` is missing in [for]"));
    assert!(told("x = \"any\"\nv = \"any\"", "rate(momentum) = 0").contains("needs `agents`, or a graph"));
    assert!(told(&ALL.replace("x = \"any\"", "x = \"all\""), "rate(momentum) = 0").contains("\"any\", or an interval"));
    assert!(told(&format!("{ALL}\n\"x[1].3\" = 0"), "rate(momentum) = 0").contains("there is no number at `x[1].3`"));
    assert!(told(&format!("{ALL}\nwhere = \"agents > 2\""), "rate(momentum) = 0").contains("left out"));
}
