//! Sets of starts: answers for all starts of a box.

use super::motions::answered;
use question::Verdict;

/// Three agents; the least distance of the motion from the middle of all boxes here is 0.9255.
const AGENTS: &str = "model = \"velocity-alignment\"\n[graph]\nkind = \"within\"\nradius = \"5/2\"\n[state]\n\
    positions = [[0, 0], [2, 0], [1, 2]]\nvelocities = [[1, 0], [\"1/2\", \"1/2\"], [0, -1]]\n[law]\n\
    potential = \"inverse-square-log\"\n[run]\nuntil = 10\n";

fn first_velocity(half: &str) -> String {
    format!("\"state.velocities[1][1]\" = \"[1 - {half}, 1 + {half}]\"")
}

#[test]
fn a_velocity_may_be_as_wide_as_a_fifth() {
    for (half, boxes) in [("1/10000", 1), ("1/1000", 1), ("1/10", 8)] {
        let always = "always[0, 10](min_distance > 8/10)";
        let answer = answered(AGENTS, &first_velocity(half), always, "always[0, 10](min_distance > 93/100)");
        assert_eq!(answer.verdict, Verdict::Holds, "{half}: {}", answer.why);
        assert!(answer.cases <= boxes, "{half}: {} boxes", answer.cases);
    }
}

/// Phases of a wide box are no boxes of phasors.
#[test]
fn phases_may_be_wide() {
    let phases = "model = \"phase\"\n[state]\nphases = [0, 1, 2]\n[law]\nomega0 = 1\nK1 = -1\n[run]\nuntil = 4\n";
    let family = "\"state.phases[1]\" = \"[-3/10, 3/10]\"";
    let answer = answered(phases, family, "always[0, 4](order > 1/2)", "always[0, 4](order < 7/10)");
    assert_eq!(answer.verdict, Verdict::Holds, "{}", answer.why);
}

/// The reactions of Laub and Loomis, from a box of seven numbers: the largest value of the fourth up to t = 20 is 4.519, from a corner.
fn enzymes(radius: &str) -> (String, String) {
    let state = ["a", "b", "c", "d", "e", "f", "g"];
    let start = ["6/5", "21/20", "3/2", "12/5", "1", "1/10", "9/20"];
    let rates = [
        "7/5*c - 9/10*a",
        "5/2*e - 3/2*b",
        "3/5*g - 4/5*b*c",
        "2 - 13/10*c*d",
        "7/10*a - d*e",
        "3/10*a - 31/10*f",
        "9/5*f - 3/2*b*g",
    ];
    let joined = |each: &dyn Fn(usize) -> String, by: &str| (0..7).map(each).collect::<Vec<String>>().join(by);
    let names = joined(&|k| format!("{} = \"number\"", state[k]), ", ");
    let laws = joined(&|k| format!("{} = \"{}\"", state[k], rates[k]), "\n");
    let places = joined(&|k| format!("{} = [\"{}\"]", state[k], start[k]), "\n");
    let scenario = format!(
        "model = \"own\"\n[law]\ntime = \"continuous\"\ndimension = 1\nstate = {{ {names} }}\n[law.rates]\n{laws}\n[state]\n{places}\n[run]\nuntil = 20\n"
    );
    let side = |k: usize| format!("\"state.{}[1]\" = \"[{} - {radius}, {} + {radius}]\"", state[k], start[k], start[k]);
    (scenario, joined(&side, "\n"))
}

/// Boxes alone would come to a corner last.
#[test]
fn the_worst_corner_comes_before_boxes() {
    let (scenario, family) = enzymes("1/10");
    let answer = answered(&scenario, &family, "always[0, 20](d[1] < 4518/1000)", "1 < 0");
    assert_eq!(answer.verdict, Verdict::False, "{}", answer.why);
    assert_eq!(answer.cases, 1);
}

/// Two coupled oscillators of van der Pol, from a box of four numbers; the largest velocity up to t = 7 is 2.6863, from a corner.
#[test]
fn coupled_oscillators_take_one_box() {
    let oscillators = "model = \"own\"\n[law]\ndimension = 1\nstate = { x = \"number\", y = \"number\" }\n[law.rates]\nx = \"y\"\n\
        y = \"(1 - x^2)*y - 2*x + sum(j, x[j])\"\n[state]\nx = [\"7/5\", \"7/5\"]\ny = [\"12/5\", \"12/5\"]\n[run]\nuntil = 7\n";
    let side = |k: usize| format!("\"state.x[{k}]\" = \"[5/4, 31/20]\"\n\"state.y[{k}]\" = \"[47/20, 49/20]\"\n");
    let family = side(1) + &side(2);
    let answer = answered(
        oscillators,
        &family,
        "always[0, 7](y[1] <= 11/4 and y[2] <= 11/4)",
        "always[0, 7](y[1] <= 2686/1000)",
    );
    assert_eq!((answer.verdict, &answer.controls[..]), (Verdict::Holds, &[true][..]), "{}", answer.why);
    assert_eq!(answer.cases, 1);
}
