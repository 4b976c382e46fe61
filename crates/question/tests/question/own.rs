//! Laws of one's own in continuous time.

use super::motions::answered;
use question::Verdict;

/// Two agents on a line whose relative velocity decays as `exp(-t)`: `x_2 - x_1 = 1 + 2 (1 - exp(-t))`.
const PAIR: &str = "model = \"own\"\n[law]\ntime = \"continuous\"\ndimension = 1\nstate = { x = \"number\", v = \"number\" }\n\
    [law.rates]\nx = \"v\"\nv = \"mean(j, v[j] - v)/2\"\n[state]\nx = [0, 1]\nv = [-1, 1]\n[run]\nuntil = 4\n";

#[test]
fn a_law_of_ones_own_is_enclosed() {
    // The least distance is 1, at the start, the largest 3 - 2 exp(-4) = 2.9634 at the end; sqrt 2 of disagreement decays.
    let property =
        "always[0, 4](min_distance > 99/100 and min_distance < 297/100) and eventually[0, 4](disagreement < 27/1000)";
    for control in ["always[0, 4](min_distance < 296/100)", "eventually[0, 4](disagreement < 25/1000)"] {
        let answer = answered(PAIR, "n = 1", property, control);
        assert_eq!(answer.verdict, Verdict::Holds, "{}", answer.why);
        assert_eq!(answer.controls, [true], "{control}");
    }
}

#[test]
fn numbers_of_its_start_may_be_intervals() {
    let place = "\"state.v[2]\" = \"[1, 3/2]\"";
    // The distance at t = 4 is 1 + (1 + v)(1 - exp(-4)): 2.96 to 3.46.
    assert_eq!(answered(PAIR, place, "always[0, 4](min_distance < 347/100)", "1 < 0").verdict, Verdict::Holds);
    assert_eq!(answered(PAIR, place, "always[0, 4](min_distance < 344/100)", "1 < 0").verdict, Verdict::False);
}

#[test]
fn what_is_not_enclosed_says_so() {
    let discrete =
        PAIR.replace("continuous", "discrete").replace("law.rates", "law.next").replace("/2\"", "/2 + sin(v)\"");
    let within = PAIR.replace("[state]", "[graph]\nkind = \"within\"\nradius = 2\n[state]");
    for (scenario, why) in [(discrete, "discrete time"), (within, "do not depend on the distances")] {
        let answer = answered(&scenario, "n = 1", "always[0, 1](min_distance > 0)", "1 < 0");
        assert_eq!(answer.verdict, Verdict::Undecided);
        assert!(answer.why.contains(why), "{}", answer.why);
    }
}

const OPINIONS: &str = "model = \"own\"\n[law]\ntime = \"discrete\"\ndimension = 1\nstate = { x = \"number\" }\n\
    [law.next]\nx = \"(x + sum(j, x[j])) / (1 + count(j))\"\n[graph]\nkind = \"within\"\nradius = 1\n\
    [state]\nx = [\"0\", \"1/2\", \"1\", \"3/2\", \"9/4\", \"3\", \"17/5\", \"4\", \"5\"]\n[run]\nuntil = 10\n";

/// Hegselmann and Krause: after finitely many steps nothing changes any more, so that all times are decided.
#[test]
fn opinions_are_decided_exactly_for_ever() {
    let answer = answered(
        OPINIONS,
        "n = 1",
        "eventually[0, 10](always[0, inf](components = 2)) and always[20, inf](min_distance = 0)",
        "always[0, inf](components > 2)",
    );
    assert_eq!(answer.verdict, Verdict::Holds, "{}", answer.why);
    assert_eq!(answer.controls, [true]);
    let answer = answered(OPINIONS, "n = 1", "always[0, 3](components <= 1)", "1 < 0");
    assert_eq!(answer.verdict, Verdict::False, "{}", answer.why);
    // At exactly the radius: linked.
    let two = OPINIONS.replace("[\"0\", \"1/2\", \"1\", \"3/2\", \"9/4\", \"3\", \"17/5\", \"4\", \"5\"]", "[0, 1]");
    assert_eq!(answered(&two, "n = 1", "always[0, 0](components = 1)", "1 < 0").verdict, Verdict::Holds);
    let apart = two.replace("[0, 1]", "[0, \"1000000000000000000000001/1000000000000000000000000\"]");
    assert_eq!(answered(&apart, "n = 1", "always[0, inf](components = 2)", "1 < 0").verdict, Verdict::Holds);
    // What depends on the time never rests for good.
    let timed = two.replace("/ (1 + count(j))", "/ (1 + count(j)) + if(t < 5, 0, 1)*x");
    let answer = answered(&timed.replace("[0, 1]", "[2, 4]"), "n = 1", "always[0, inf](components = 2)", "1 < 0");
    assert_eq!(answer.verdict, Verdict::Undecided, "{}", answer.why);
}

/// Components of the state and observables, in both kinds of time.
#[test]
fn numbers_of_the_law_have_their_names() {
    let observed = |text: &str| {
        text.replace("[state]", "[law.observables]\nmomentum = \"sum(i, v[i])\"\nfirst = \"x[1]\"\n[state]")
    };
    // v_2 = exp(-t): 0.0183 at t = 4. Two components are bounded each alone, so that their sum is known as well as the pieces of time are short.
    let property = "always[0, 4](v[2] > 18/1000 and v[2] + v[1] < 1/100 and abs(momentum) < 1/1000000) and eventually[0, 4](x[2] > 196/100)";
    let answer = answered(&observed(PAIR), "n = 1", property, "always[0, 4](v[2] > 1/10)");
    assert_eq!((answer.verdict, &answer.controls[..]), (Verdict::Holds, &[true][..]), "{}", answer.why);
    let plain = observed(OPINIONS).replace("sum(i, v[i])", "sum(i, x[i])");
    let property = "always[0, inf](x[1] >= 0 and x[9] <= 5 and first = x[1]) and eventually[0, 10](x[1] = x[2])";
    let answer = answered(&plain, "n = 1", property, "always[0, inf](momentum = 75/4)");
    assert_eq!((answer.verdict, &answer.controls[..]), (Verdict::Holds, &[true][..]), "{}", answer.why);
    // A clock goes on when opinions rest.
    let timed = plain.replace("[law.observables]", "[law.observables]\nclock = \"t\"");
    let answer = answered(&timed, "n = 1", "always[0, inf](clock <= 20)", "always[0, 3](clock <= 2)");
    assert_ne!(answer.verdict, Verdict::Holds, "{}", answer.why);
}
