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
