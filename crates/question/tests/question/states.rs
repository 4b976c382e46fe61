//! Questions about all states of a law.

use arithmetic::Unwatched;
use question::{Answer, Question, Verdict, decide};

const CUCKER_SMALE: &str = "[law]\ndimension = 2\nstate = { x = \"vector\", v = \"vector\" }\nparameters = { K = 1, beta = \"1/4\" }\n\
[law.define]\ncentre = \"mean(k, v[k])\"\n\"weight(i, j)\" = \"K / (1 + norm2(x[j] - x[i]))^beta\"\n[law.rates]\nx = \"v\"\nv = \"mean(j, weight(i, j) * (v[j] - v))\"\n\
[law.observables]\nmomentum = \"sum(i, v[i])\"\nfluctuation = \"sum(i, norm2(v[i] - centre)) / 2\"\n";

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
fn a_counterexample_shows_both_sides_and_the_margin() {
    let point = "agents = 2\nx = \"[0, 0]\"\nv = \"[0, 0]\"\n\"v[1].1\" = 3\n\"v[1].2\" = -1";
    let sides = |property: &str| {
        let found = answer(point, property, "\"x[1].1 > 0\"");
        assert_eq!(found.verdict, Verdict::False, "{}", found.why);
        let there = found.decisive.expect("what decides");
        assert!(found.margin.is_some_and(|own| own == there.margin));
        (there.inequality, there.left, there.right, there.margin.lo)
    };
    let known = |inequality: &str, left: &str, right: &str, margin: f64| {
        (inequality.to_string(), left.to_string(), right.to_string(), margin)
    };
    assert_eq!(sides("v[1].1 <= v[2].1 + 1"), known("v[1].1 <= v[2].1 + 1", "3", "1", -2.0));
    // The second component is the first that differs from what is claimed.
    let second = known("momentum = vector(3, 0), component 2,", "-1", "0", -1.0);
    assert_eq!(sides("momentum = vector(3, 0)"), second);
    // All of `or` fail, the first one by less; an implication fails by what it says.
    assert_eq!(sides("v[1].1 < 2 or v[1].1 < 1"), known("v[1].1 < 2", "3", "2", -1.0));
    assert_eq!(sides("v[1].1 > 1 implies v[1].1 > 7"), known("v[1].1 > 7", "3", "7", -4.0));
    // Of `and` the part that fails by most.
    assert_eq!(sides("v[1].1 < 2 and v[1].2 > 4"), known("v[1].2 > 4", "-1", "4", -5.0));
}

#[test]
fn inequalities_on_boxes_that_are_not_attained() {
    let boxed = "agents = 2\nx = \"[-1, 1]\"\nv = \"any\"\n\"v[1].1\" = \"[1, 2]\"\n\"v[2].1\" = \"[-1, 0]\"\n\"v[1].2\" = 0\n\"v[2].2\" = 0";
    let found = answer(boxed, "rate(v[1].1) < -1/10", "\"rate(v[1].1) < -1\"");
    assert_eq!((found.verdict, &found.grades[..]), (Verdict::Holds, &["certified"][..]), "{}", found.why);
    // Attained where all velocities are equal.
    let found =
        answer("agents = 2\nx = \"[-1, 1]\"\nv = \"[-1, 1]\"", "rate(fluctuation) <= 0", "\"rate(fluctuation) < -1\"");
    assert_eq!(found.verdict, Verdict::Holds, "{}", found.why);
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

/// The law with sums, which are the same for both of a pair on every network without directions.
fn by_sums(weight: &str) -> String {
    CUCKER_SMALE.replace("mean(j, weight", "sum(j, weight").replace("K / (1 + norm2(x[j] - x[i]))^beta", weight)
}

const WEIGHT: &str = "K / (1 + norm2(x[j] - x[i]))^beta";
const COMPLETE: &str = "agents = \"any\"\nx = \"any\"\nv = \"any\"";
const EVERY: &str = "agents = \"any\"\ngraph = \"any\"\nx = \"any\"\nv = \"any\"";

fn answer_of(law: &str, family: &str, property: &str, control: &str) -> Answer {
    let text = format!(
        "[question]\nid = \"mine.states\"\nlaw = \"law.toml\"\n[for]\n{family}\n[holds]\nproperty = \"{property}\"\ncontrols = [\"{control}\"]\n"
    );
    decide(&Question::read(&text, &|_: &str| Ok(law.to_string())).unwrap(), &Unwatched).unwrap()
}

#[test]
fn velocities_come_together_in_flocks_of_every_size() {
    let both = "rate(momentum) = 0 and rate(fluctuation) <= 0";
    let control = "rate(fluctuation) <= -fluctuation/100";
    for (law, family) in [(CUCKER_SMALE.to_string(), COMPLETE), (by_sums(WEIGHT), COMPLETE), (by_sums(WEIGHT), EVERY)] {
        let found = answer_of(&law, family, both, control);
        assert_eq!((found.verdict, &found.controls[..]), (Verdict::Holds, &[true][..]), "{}", found.why);
        assert!(found.why.contains("for every number of agents"), "{}", found.why);
        assert!(found.grades.contains(&"identity"), "{:?}", found.grades);
    }
    // One flock, pair by pair.
    let found = answer_of(
        &by_sums(WEIGHT),
        "agents = 4\ngraph = \"connected(agents)\"\nx = \"any\"\nv = \"any\"",
        both,
        control,
    );
    assert_eq!(found.verdict, Verdict::Holds, "{}", found.why);
    assert!(found.why.contains("sum over pairs"), "{}", found.why);
}

/// What looks like a sum over pairs of terms of one sign and is none.
#[test]
fn what_is_no_sum_over_pairs_of_one_sign_does_not_hold() {
    let falls = "rate(fluctuation) <= 0";
    let control = "rate(fluctuation) <= -1";
    // A mean over those whom an agent hears.
    let found = answer_of(CUCKER_SMALE, EVERY, "rate(momentum) = 0", "rate(momentum) = v[1]");
    assert_eq!(found.verdict, Verdict::False, "{}", found.why);
    // Weights that are negative far away, or at one distance only.
    let far = answer_of(&by_sums("1 - norm2(x[j] - x[i])/100000000"), EVERY, falls, control);
    assert_eq!(far.verdict, Verdict::False, "{}", far.why);
    let narrow = answer_of(&by_sums("(norm2(x[j] - x[i]) - 21/10)^2 - 1/100000000"), EVERY, falls, control);
    assert_ne!(narrow.verdict, Verdict::Holds, "{}", narrow.why);
    // Weights of a sign for each agent: the terms of some pairs are positive.
    let signs = by_sums("m[i]*m[j]").replace("K = 1", "m = [1, 1, -1]");
    let three = "agents = 3\nx = \"any\"\nv = \"any\"";
    assert_eq!(answer_of(&signs, three, falls, control).verdict, Verdict::False);
    let positive = signs.replace("-1]", "2]");
    let found = answer_of(&positive, three, falls, control);
    assert_eq!(found.verdict, Verdict::Holds, "{}", found.why);
    // Not the same for both: the momentum is not conserved, and the terms are not of one sign.
    assert_eq!(answer_of(&positive.replace("m[i]*", ""), three, "rate(momentum) = 0", "1 < 0").verdict, Verdict::False);
    // Arcs without one back.
    let arcs = "agents = 3\ngraph = \"arcs:3:1-2,2-3\"\nx = \"any\"\nv = \"any\"";
    assert_eq!(answer_of(&by_sums(WEIGHT), arcs, falls, control).verdict, Verdict::False);
    // Weights that are positive for few agents only.
    let few = by_sums("7 - agents");
    let found = answer_of(&few, COMPLETE, falls, control);
    assert_ne!(found.verdict, Verdict::Holds, "{}", found.why);
}

/// Identities that hold for few agents only.
#[test]
fn what_holds_for_few_agents_does_not_hold_for_all() {
    let zeros: Vec<String> = (1..=6).map(|n| format!("(agents - {n})")).collect();
    let few = format!("{}*sum(i, v[i].1) = 0", zeros.join("*"));
    let found = answer_of(&by_sums(WEIGHT), COMPLETE, &few, "1 < 0");
    assert_ne!(found.verdict, Verdict::Holds, "{}", found.why);
    let counted =
        "(count(i) - 1)*(count(i) - 2)*(count(i) - 3)*(count(i) - 4)*(count(i) - 5)*(count(i) - 6)*sum(i, v[i].1) = 0";
    assert_ne!(answer_of(&by_sums(WEIGHT), COMPLETE, counted, "1 < 0").verdict, Verdict::Holds);
    // Differences around a triple are antisymmetric: their product sums to 0, its square does not, but for two agents.
    let odd = "sum(i, sum(j, sum(k, (v[i].1 - v[j].1)*(v[j].1 - v[k].1)*(v[k].1 - v[i].1)))) = 0";
    assert_eq!(answer_of(&by_sums(WEIGHT), COMPLETE, odd, "sum(i, v[i].1) = 0").verdict, Verdict::Holds);
    let product = "(v[i].1 - v[j].1)*(v[j].1 - v[k].1)*(v[k].1 - v[i].1)";
    let square = odd.replace(product, &format!("({product})^2"));
    assert_eq!(answer_of(&by_sums(WEIGHT), COMPLETE, &square, "1 < 0").verdict, Verdict::False);
}

/// On a sphere, in a ball, on a set that is left.
#[test]
fn sets_that_are_not_left() {
    let alone = "agents = 1\nx = \"any\"\nv = \"any\"";
    let speed = CUCKER_SMALE.replace("mean(j, weight(i, j) * (v[j] - v))", "(1 - norm2(v))*v");
    let found = answer_of(
        &speed,
        alone,
        "norm2(v[1]) = 1 implies rate(norm2(v[1])) = 0",
        "norm2(v[1]) = 2 implies rate(norm2(v[1])) = 0",
    );
    assert_eq!((found.verdict, &found.controls[..]), (Verdict::Holds, &[true][..]), "{}", found.why);
    let found = answer_of(
        &speed,
        alone,
        "norm2(v[1]) = 2 implies rate(norm2(v[1])) < 0",
        "norm2(v[1]) = 1/2 implies rate(norm2(v[1])) < 0",
    );
    assert_eq!((found.verdict, &found.controls[..]), (Verdict::Holds, &[true][..]), "{}", found.why);
    // The unit ball is not left; half of it is.
    let found = answer_of(
        &speed,
        alone,
        "norm2(v[1]) >= 1 implies rate(norm2(v[1])) <= 0",
        "norm2(v[1]) >= 1/2 implies rate(norm2(v[1])) <= 0",
    );
    assert_eq!((found.verdict, &found.controls[..]), (Verdict::Holds, &[true][..]), "{}", found.why);
}

/// A law on numbers, with a question about three agents.
fn numbers(rates: &str, time: &str, family: &str, property: &str, control: &str) -> Answer {
    let law = format!("[law]\ndimension = 1\ntime = \"{time}\"\nstate = {{ h = \"number\" }}\n{rates}\n");
    let text = format!(
        "[question]\nid = \"mine.numbers\"\nlaw = \"law.toml\"\n[for]\n{family}\nh = \"any\"\n[holds]\nproperty = \"{property}\"\ncontrols = [\"{control}\"]\n"
    );
    decide(&Question::read(&text, &|_: &str| Ok(law.clone())).unwrap(), &Unwatched).unwrap()
}

/// One graph of each class stands for all only where agents are alike: here the middle of a path jumps up, whichever number it has.
#[test]
fn agents_that_are_named_are_looked_at_in_every_place() {
    let jumps =
        "[law.next]\nh = \"(h + sum(j, h[j])) / (1 + count(j)) + if(count(j) = 2 and sum(j, count(k)) = 2, 1, 0)\"";
    let three = "agents = 3\ngraph = \"connected(agents)\"";
    let largest = |k: usize| format!("h[{k}] >= h[1] and h[{k}] >= h[2] and h[{k}] >= h[3] implies rate(h[{k}]) <= 0");
    for k in 1..=3 {
        let found = numbers(jumps, "discrete", three, &largest(k), "h[1] >= h[2] implies rate(h[1]) <= 0");
        assert_eq!(found.verdict, Verdict::False, "{k}: {}", found.why);
    }
    let averages = jumps.replace(" + if(count(j) = 2 and sum(j, count(k)) = 2, 1, 0)", "");
    let found = numbers(&averages, "discrete", three, &largest(2), "h[1] >= h[2] implies rate(h[1]) <= 0");
    assert_eq!((found.verdict, found.cases), (Verdict::Holds, 4), "{}", found.why);
    // Two that are alike in one labelling of the path, and not in another.
    let consensus = "[law.rates]\nh = \"sum(j, h[j] - h)\"";
    let found =
        numbers(consensus, "continuous", three, "h[1] = h[2] implies rate(h[1]) = rate(h[2])", "rate(h[1]) = 1");
    assert_eq!(found.verdict, Verdict::False, "{}", found.why);
    // Where nobody is named one of each class is enough.
    let found = numbers(
        consensus,
        "continuous",
        "agents = 4\ngraph = \"connected(agents)\"",
        "rate(sum(i, h[i])) = 0",
        "rate(sum(i, h[i])) = 1",
    );
    assert_eq!((found.verdict, found.cases), (Verdict::Holds, 6), "{}", found.why);
    let seven = "agents = 7\ngraph = \"connected(agents)\"";
    let law = |_: &str| {
        Ok("[law]\ndimension = 1\nstate = { h = \"number\" }\n[law.rates]\nh = \"sum(j, h[j] - h)\"\n".to_string())
    };
    let text = format!(
        "[question]\nid = \"a\"\nlaw = \"law.toml\"\n[for]\n{seven}\nh = \"any\"\n[holds]\nproperty = \"h[1] >= h[2]\"\n"
    );
    let refused = Question::read(&text, &law).and_then(|question| decide(&question, &Unwatched).map(drop));
    assert!(refused.unwrap_err().to_string().contains("up to 6 vertices"));
}

/// The sum over pairs is the other side's multiple by a number below 0, so that no factor helps: this is a question of numbers.
#[test]
fn sums_over_pairs_of_opposite_signs_are_compared() {
    let rates = "[law.rates]\nh = \"mean(j, h[j] - h)\"\n";
    let spread = "sum(i, (h[i] - mean(k, h[k]))^2)";
    let of = |factor: &str| format!("rate(sum(i, h[i]^2)) <= {factor}*{spread}");
    let found = numbers(rates, "continuous", "agents = 3", &of("-1"), &of("-4"));
    assert_eq!(found.verdict, Verdict::Holds, "{}", found.why);
}

/// What has no value at any state holds nowhere: it is not said to hold.
#[test]
fn statements_without_values_do_not_hold() {
    let still = "[law.rates]\nh = \"0\"";
    for property in
        ["1/0 > 0", "1/0 < 0", "sqrt(-1) > 3", "h[1]/0 >= h[2]", "sqrt(-1 - h[1]^2) <= -1", "h[1] > 0 implies 1/0 > 0"]
    {
        let found = numbers(still, "continuous", "agents = 2", property, "h[1] > 0");
        assert_eq!(found.verdict, Verdict::Undecided, "{property}: {}", found.why);
    }
    // Somewhere it has one.
    let found = numbers(still, "continuous", "agents = 2", "sqrt(h[1]) >= 0", "sqrt(h[1]) > 0");
    assert_eq!(found.verdict, Verdict::Holds, "{}", found.why);
    // A largest value over nobody has none, whatever the largest over somebody does.
    let found = numbers(still, "continuous", "agents = \"any\"", "sum(i, max(j, h[j])) >= 1/0", "sum(i, h[i]) > 0");
    assert_ne!(found.verdict, Verdict::Holds, "{}", found.why);
}

/// Inside a sum a mean runs over those whom that agent hears: with everybody linked `N/(N - 1)` times the distance from the mean of all. So the factor of the sum over
/// pairs is a number of its own for each size.
#[test]
fn means_inside_sums_are_sums_over_pairs() {
    let law = |dimension: u32| {
        format!(
            "[law]\ndimension = {dimension}\nstate = {{ x = \"vector\", v = \"vector\" }}\n[law.rates]\nx = \"v\"\n\
             v = \"sum(j, (v[j] - v)/(1 + norm2(x[j] - x)))\"\n"
        )
    };
    let spread = "sum(i, norm2(v[i] - mean(k, v[k])))";
    for dimension in 1..=3 {
        let holds = |property: &str| {
            let found = answer_of(&law(dimension), "agents = 3\nx = \"any\"\nv = \"any\"", property, "1 < 0");
            assert_eq!(found.verdict, Verdict::Holds, "{property}: {}", found.why);
        };
        holds(&format!("rate({spread}) <= 0"));
        holds("rate(sum(i, sum(j, norm2(v[i] - v[j])))) <= 0");
    }
    let six = "agents = 6\nx = \"any\"\nv = \"any\"";
    let found = answer_of(&law(2), six, &format!("rate({spread}) <= 0"), "1 < 0");
    assert_eq!(found.verdict, Verdict::Holds, "{}", found.why);
    // Planted: nearly the same, and false far apart; another sign; one agent that does not hear the others.
    for property in [
        format!("rate({spread}) <= -1/1000000*{spread}"),
        format!("rate({spread}) >= 0"),
        format!("rate({spread}) <= 1/1000000*sum(i, dot(x[i], v[i]))"),
    ] {
        let found = answer_of(&law(2), "agents = 3\nx = \"any\"\nv = \"any\"", &property, "1 < 0");
        assert_eq!(found.verdict, Verdict::False, "{property}: {}", found.why);
    }
    let arcs = "graph = \"arcs:3:1-2,2-1,1-3\"\nx = \"any\"\nv = \"any\"";
    let found = answer_of(&law(2), arcs, &format!("rate({spread}) <= 0"), "1 < 0");
    assert_ne!(found.verdict, Verdict::Holds, "{}", found.why);
}
