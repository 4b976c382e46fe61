//! Laws of one's own in continuous time.

use super::motions::answered;
use question::{Question, Verdict};

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

/// A start that is exact decides what is attained there; of the motion after it there is no closed form.
#[test]
fn the_start_is_exact() {
    let law =
        PAIR.replace("v = \"mean(j, v[j] - v)/2\"", "v = \"sin(x) - v\"").replace("v = [-1, 1]", "v = [\"13/10\", 1]");
    for (property, verdict) in [
        ("always[0, 0](v[1] <= 13/10 and v[1] >= 13/10)", Verdict::Holds),
        ("always[0, 0](v[1] < 13/10)", Verdict::False),
        ("always[0, 1](v[1] < 13/10)", Verdict::False),
        ("always[0, 1](v[1] <= 13/10)", Verdict::Holds),
        ("always[0, 1](v[1] + v[2]^2 <= 23/10)", Verdict::Holds),
        ("always[0, 1](v[1] + v[2]^2 <= 23/10 - 1/10^18)", Verdict::False),
        ("eventually[0, 1](v[1] >= 13/10)", Verdict::Holds),
        ("eventually[0, 1](v[1] > 13/10)", Verdict::False),
    ] {
        let answer = answered(&law, "n = 1", property, "1 < 0");
        assert_eq!(answer.verdict, verdict, "{property}: {}", answer.why);
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
    let noisy =
        PAIR.replace("continuous", "discrete").replace("law.rates", "law.next").replace("/2\"", "/2 + normal(1)\"");
    let nearest = PAIR.replace("[state]", "[graph]\nkind = \"nearest\"\nnearest = 1\n[state]");
    // Without its noise the law would be enclosed, and the property true.
    let shaken =
        PAIR.replace("[state]", "[law.noise]\nv = \"1\"\n[state]").replace("until = 4", "until = 4\nstep = \"1/100\"");
    for (scenario, why) in [(noisy, "noise"), (nearest, "to the nearest"), (shaken, "laws with noise are not enclosed")]
    {
        let answer = answered(&scenario, "n = 1", "always[0, 1](min_distance > 0)", "1 < 0");
        assert_eq!(answer.verdict, Verdict::Undecided);
        assert!(answer.why.contains(why), "{}", answer.why);
    }
}

/// Headings that are averaged in discrete time (Vicsek's rule without noise), in enclosures: against the same steps in floats.
const HEADINGS: &str = "model = \"own\"\n[law]\ntime = \"discrete\"\nstate = { x = \"vector\", theta = \"angle\" }\n\
    [law.next]\nx = \"x + vector(cos(theta), sin(theta))/10\"\n\
    theta = \"heading(vector(cos(theta), sin(theta)) + sum(j, vector(cos(theta[j]), sin(theta[j]))))\"\n\
    [graph]\nkind = \"within\"\nradius = 1\n[state]\nx = [[0, 0], [\"4/5\", 0], [\"8/5\", \"1/5\"], [5, 5]]\n\
    theta = [0, 1, 2, \"1/2\"]\n[run]\nuntil = 4\n";

/// The headings after some steps, in floats.
fn headings(steps: usize) -> ([f64; 4], [[f64; 2]; 4]) {
    let (mut theta, mut x): ([f64; 4], [[f64; 2]; 4]) =
        ([0.0, 1.0, 2.0, 0.5], [[0.0, 0.0], [0.8, 0.0], [1.6, 0.2], [5.0, 5.0]]);
    for _ in 0..steps {
        let near = |i: usize, j: usize| f64::hypot(x[i][0] - x[j][0], x[i][1] - x[j][1]) <= 1.0;
        let mean = |i: usize| {
            let all = (0..4).filter(|&j| near(i, j)).map(|j| theta[j].sin_cos());
            let (sin, cos) = all.fold((0.0, 0.0), |(s, c), (sin, cos)| (s + sin, c + cos));
            sin.atan2(cos)
        };
        let next = std::array::from_fn(mean);
        x = std::array::from_fn(|i| [x[i][0] + theta[i].cos() / 10.0, x[i][1] + theta[i].sin() / 10.0]);
        theta = next;
    }
    (theta, x)
}

#[test]
fn functions_in_discrete_time_are_enclosed() {
    for steps in [1, 7, 60] {
        let (theta, x) = headings(steps);
        for (name, value) in [("theta[2]", theta[1]), ("theta[3]", theta[2]), ("x[3].2", x[2][1]), ("x[1].1", x[0][0])]
        {
            let close = format!("always[{steps}, {steps}](({name} - {value})^2 < 1/10^18)");
            let answer =
                answered(HEADINGS, "n = 1", &close, &format!("always[{steps}, {steps}]({name} < {})", value - 1e-8));
            assert_eq!((answer.verdict, &answer.controls[..]), (Verdict::Holds, &[true][..]), "{name} {}", answer.why);
        }
    }
    // The size of an angle is one on the circle, which is not that of the number.
    let refused = Question::read(
        "[question]\nid = \"a\"\nscenario = \"law.toml\"\n[holds]\nproperty = \"always[0, 1](abs(theta[1] - theta[2]) <= 1)\"\n",
        &|_: &str| Ok(HEADINGS.to_string()),
    );
    assert!(refused.unwrap_err().to_string().contains("`theta[1]` is an angle"));
    // What never comes to rest in exact numbers is open for ever, and what is false at some time is false.
    let answer = answered(HEADINGS, "n = 1", "always[0, inf](theta[1] < 3)", "always[0, 2](theta[1] > 3)");
    assert_eq!(answer.verdict, Verdict::Undecided, "{}", answer.why);
    assert_eq!(answered(HEADINGS, "n = 1", "always[0, inf](theta[1] < 1/10)", "1 < 0").verdict, Verdict::False);
}

/// A map on one number.
fn map(next: &str, start: &str) -> String {
    format!(
        "model = \"own\"\n[law]\ntime = \"discrete\"\ndimension = 1\nstate = {{ x = \"number\" }}\n\
         [law.next]\nx = \"{next}\"\n[state]\nx = [\"{start}\"]\n[run]\nuntil = 4\n"
    )
}

#[test]
fn enclosures_of_steps_are_made_as_narrow_as_needed() {
    // A map that doubles errors: 300 steps need more than 256 bits. x = sin(y)^2 makes it y -> 2 y.
    let doubling = map("if(x < 1/2, 2*x, 2 - 2*x) + 0*sqrt(2)", "1/3");
    assert_eq!(
        answered(&doubling, "n = 1", "always[1, 300](x[1] = 2/3)", "always[0, 2](x[1] = 2/3)").verdict,
        Verdict::Holds
    );
    let chaotic = map("abs(1 - 2*abs(x)) + sqrt(2) - sqrt(2)", "sqrt2");
    let start = chaotic.replace("\"sqrt2\"", "\"1/5\"");
    // 1/5, 3/5, 1/5, ..: the roots cancel, which enclosures cannot tell, so that every step loses a bit.
    let answer =
        answered(&start, "n = 1", "always[0, 400](x[1] > 19/100 and x[1] < 61/100)", "always[0, 2](x[1] > 1/4)");
    assert_eq!((answer.verdict, &answer.controls[..]), (Verdict::Holds, &[true][..]), "{}", answer.why);
    // A fixed point is reached in the limit only: no step attains it.
    let root = map("sqrt(2 + x)", "1");
    assert_eq!(
        answered(&root, "n = 1", "always[0, 100](x[1] < 2)", "always[0, 5](x[1] < 199/100)").verdict,
        Verdict::Holds
    );
    assert_eq!(answered(&root, "n = 1", "eventually[0, 100](x[1] >= 2)", "1 < 0").verdict, Verdict::False);
    // Equality of numbers by different ways, and a condition on it.
    let two = map("if(sqrt(x)*sqrt(x) = x, 1, 2)", "2");
    assert_eq!(answered(&two, "n = 1", "always[1, 9](x[1] = 1)", "always[0, 2](x[1] = 1)").verdict, Verdict::Holds);
}

#[test]
fn starts_of_steps_may_be_intervals() {
    let averages = OPINIONS.replace("kind = \"within\"\nradius = 1\n", "kind = \"path\"\n");
    let place = "\"state.x[1]\" = \"[-1, 1]\"";
    let property = "always[0, 20](x[2] >= -1 and x[9] <= 5) and always[1, 20](x[1] <= 3)";
    let answer = answered(&averages, place, property, "always[0, 20](x[9] >= 9/2)");
    assert_eq!((answer.verdict, &answer.controls[..]), (Verdict::Holds, &[true][..]), "{}", answer.why);
    // One start of the box fails.
    let answer = answered(&averages, place, "always[0, 20](x[1] > -99/100)", "1 < 0");
    assert_eq!(answer.verdict, Verdict::False, "{}", answer.why);
    // Whether a link is there depends on the start: the box is divided, and what stays open is at the radius.
    let two = OPINIONS.replace("[\"0\", \"1/2\", \"1\", \"3/2\", \"9/4\", \"3\", \"17/5\", \"4\", \"5\"]", "[0, 3]");
    let far = answered(&two, "\"state.x[1]\" = \"[0, 19/10]\"", "always[0, 5](components = 2)", "1 < 0");
    assert_eq!(far.verdict, Verdict::Holds, "{}", far.why);
    let near = answered(&two, "\"state.x[1]\" = \"[0, 2]\"", "always[0, 5](components = 2)", "1 < 0");
    assert_eq!(near.verdict, Verdict::False, "{}", near.why);
}

/// Hegselmann and Krause from a box of starts: the network is the same for all, so that each opinion is an affine function of the start, also where one start is at
/// exactly the radius; a millionth beyond it the groups are three.
#[test]
fn opinions_from_a_box_are_decided_for_ever() {
    let text = OPINIONS.replace("[state]", "[law.observables]\nspread = \"max(i, x[i]) - min(i, x[i])\"\n[state]");
    let property = "eventually[0, 10](always[0, inf](components = 2)) and always[20, inf](min_distance = 0)";
    let place = "\"state.x[1]\" = \"[0, 1/5]\"";
    let answer = answered(&text, place, property, "always[0, inf](components > 2)");
    assert_eq!((answer.verdict, &answer.controls[..]), (Verdict::Holds, &[true][..]), "{}", answer.why);
    assert_eq!(answer.cases, 1);
    let answer = answered(&text, "\"state.x[1]\" = \"[-1/1000000, 1/5]\"", property, "1 < 0");
    assert_eq!(answer.verdict, Verdict::False, "{}", answer.why);
    // In the end the lower group is at 1151/1280 + 19/96 x_1.
    for (bound, verdict) in [("938803", Verdict::Holds), ("938802", Verdict::False)] {
        let answer = answered(&text, place, &format!("always[10, inf](x[1] <= {bound}/1000000)"), "1 < 0");
        assert_eq!(answer.verdict, verdict, "{bound}: {}", answer.why);
    }
}

/// Averages contract, for all starts at once: the differences of three fall to a quarter with each step.
#[test]
fn averages_contract_from_a_box() {
    let start = "[\"0\", \"1/2\", \"1\", \"3/2\", \"9/4\", \"3\", \"17/5\", \"4\", \"5\"]";
    let text = OPINIONS
        .replace("(x + sum(j, x[j])) / (1 + count(j))", "x + mean(j, x[j] - x)/2")
        .replace("kind = \"within\"\nradius = 1\n", "kind = \"complete\"\n")
        .replace(start, "[0, 1, 3]")
        .replace("[state]", "[law.observables]\nspread = \"max(i, x[i]) - min(i, x[i])\"\n[state]");
    let place = "\"state.x[1]\" = \"[-1, 1]\"";
    // 4/4^11 from -1, the largest spread, and 2/4^11 from 1.
    for (property, verdict) in [
        ("always[11, 11](spread <= 1/1048576)", Verdict::Holds),
        ("always[11, 11](spread < 1/1048576)", Verdict::False),
        ("always[11, 11](spread >= 1/2097152)", Verdict::Holds),
        ("always[11, 11](spread > 1/2097152)", Verdict::False),
        ("eventually[0, 20](spread < 1/1000000000)", Verdict::Holds),
        ("always[0, 12](x[2] <= initial(x[2]) + 2/3)", Verdict::Holds),
    ] {
        let answer = answered(&text, place, property, "1 < 0");
        assert_eq!(answer.verdict, verdict, "{property}: {}", answer.why);
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

/// Links that are replaced later move what has come to rest before.
#[test]
fn replaced_links_count_after_a_rest() {
    let text = "model = \"own\"\n[law]\ntime = \"discrete\"\ndimension = 1\nstate = { x = \"number\" }\n[law.next]\nx = \"x + mean(j, x[j] - x)/2\"\n\
                [graph]\nkind = \"edges\"\nedges = [[2, 3]]\nswitches = [{ at = 7, edges = [[1, 2], [2, 3], [1, 3]] }]\n[state]\nx = [0, 0, 1]\n[run]\nuntil = 12\n";
    let property = "always[0, 7](x[1] = 0) and always[8, 12](x[1] > 0) and eventually[12, 12](components = 1)";
    let answer = answered(text, "n = 1", property, "always[0, inf](x[1] = 0)");
    assert_eq!((answer.verdict, &answer.controls[..]), (Verdict::Holds, &[true][..]), "{}", answer.why);
    assert_eq!(answered(text, "n = 1", "always[0, inf](x[1] = 0)", "1 < 0").verdict, Verdict::False);
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

/// An observable without a value says nothing about the others, in both kinds of time.
#[test]
fn observables_are_asked_one_by_one() {
    for text in [PAIR.to_string(), OPINIONS.to_string()] {
        let text = text.replace("[state]", "[law.observables]\nnone = \"1/(x[1] - x[1])\"\nfirst = \"x[1]\"\n[state]");
        let answer = answered(&text, "n = 1", "always[0, 3](first < x[1] + 1/10)", "always[0, 3](first > x[1] + 1/10)");
        assert_eq!((answer.verdict, &answer.controls[..]), (Verdict::Holds, &[true][..]), "{}", answer.why);
        let answer = answered(&text, "n = 1", "always[0, 3](none > 0)", "always[0, 3](none <= 0)");
        assert_ne!(answer.verdict, Verdict::Holds, "{}", answer.why);
    }
}

/// Exact numbers whose digits double at each step are enclosed where they grow too long. Largest value of the orbit of 1/3 up to t = 100, by decimals of 200
/// digits: 0.99994845321270...
#[test]
fn long_rationals_are_enclosed() {
    let text = "model = \"own\"\n[law]\ntime = \"discrete\"\ndimension = 1\nstate = { x = \"number\" }\n[law.next]\nx = \"4*x*(1 - x)\"\n\
                [state]\nx = [\"1/3\"]\n[run]\nuntil = 100\n";
    let [above, below] = [271, 270].map(|last| format!("always[0, 100](x[1] <= 99994845321{last}/100000000000000)"));
    let answer = answered(text, "n = 1", &above, &below);
    assert_eq!((answer.verdict, &answer.controls[..]), (Verdict::Holds, &[true][..]), "{}", answer.why);
}

/// Two agents with links up to the distance 2, of which the second one flies away. While they are linked their relative velocity `w` decays as `exp(-2t)`: from
/// `w = 4` and the distance 1 they are 2 apart at `t = log(2)/2 = 0.3466`, where `w = 2`, and `2 + 2 (t - 0.3466)` later, 3.3069 at `t = 1`.
fn parting(speed: &str) -> String {
    format!(
        "model = \"own\"\n[law]\nstate = {{ x = \"vector\", v = \"vector\" }}\n[law.rates]\nx = \"v\"\nv = \"sum(j, v[j] - v)\"\n\
         [law.observables]\nheard = \"sum(i, sum(j, 1))\"\n[graph]\nkind = \"within\"\nradius = 2\n\
         [state]\nx = [[0, 0], [1, 0]]\nv = [[0, 0], [\"{speed}\", 0]]\n[run]\nuntil = 1\n"
    )
}

/// The same of the built-in law.
fn built_in() -> String {
    "model = \"velocity-alignment\"\n[graph]\nkind = \"within\"\nradius = 2\n[state]\npositions = [[0, 0], [1, 0]]\n\
     velocities = [[0, 0], [4, 0]]\n[law]\npotential = \"none\"\n[run]\nuntil = 1\n"
        .to_string()
}

/// With a link that stayed, the last distance would be 2.73; without links, 5.
#[test]
fn links_by_distance_end_where_the_distance_does() {
    for (property, verdict) in [
        ("always[0, 1](min_distance <= 3307/1000)", Verdict::Holds),
        ("always[0, 1](min_distance <= 3306/1000)", Verdict::False),
        ("eventually[0, 1](min_distance >= 3306/1000)", Verdict::Holds),
        ("always[0, 34/100](components = 1)", Verdict::Holds),
        ("always[0, 36/100](components = 1)", Verdict::False),
        ("always[35/100, 1](components = 2)", Verdict::Holds),
        ("always[34/100, 1](components = 2)", Verdict::False),
        ("always[0, 1](disagreement <= initial(disagreement))", Verdict::Holds),
    ] {
        for scenario in [parting("4"), built_in()] {
            let answer = answered(&scenario, "n = 1", property, "1 < 0");
            assert_eq!(answer.verdict, verdict, "{property}: {}", answer.why);
        }
    }
    for (property, verdict) in [
        ("always[0, 1](0 <= heard <= 2)", Verdict::Holds),
        ("always[0, 34/100](heard = 2) and always[35/100, 1](heard = 0)", Verdict::Holds),
        ("always[0, 1](heard = 2)", Verdict::False),
        ("always[0, 1](v[2].1 + v[1].1 >= 4 - 1/1000000)", Verdict::Holds),
    ] {
        let answer = answered(&parting("4"), "n = 1", property, "1 < 0");
        assert_eq!(answer.verdict, verdict, "{property}: {}", answer.why);
    }
}

/// All starts of a box cross at times of their own, from 0.3346 to 0.3596; at `t = 1` they are 3.2167 to 3.3974 apart.
#[test]
fn links_by_distance_switch_for_all_starts_of_a_box() {
    let family = "\"state.v[2][1]\" = \"[39/10, 41/10]\"";
    for (property, verdict) in [
        ("always[0, 1](min_distance <= 341/100)", Verdict::Holds),
        ("always[0, 1](min_distance <= 339/100)", Verdict::False),
        ("eventually[0, 1](min_distance >= 32/10)", Verdict::Holds),
        ("eventually[0, 1](min_distance >= 33/10)", Verdict::False),
        ("always[0, 33/100](components = 1) and always[37/100, 1](components = 2)", Verdict::Holds),
        ("always[34/100, 1](components = 2)", Verdict::False),
    ] {
        let answer = answered(&parting("4"), family, property, "1 < 0");
        assert_eq!(answer.verdict, verdict, "{property}: {}", answer.why);
    }
}

/// What only touches the radius, or begins at it, is not decided; and an agent that comes from outside gets its link.
#[test]
fn touching_the_radius_stays_open() {
    let swing = |state: &str| {
        format!(
            "model = \"own\"\n[law]\ndimension = 1\nstate = {{ x = \"vector\", v = \"vector\" }}\n[law.rates]\nx = \"v\"\n\
             v = \"-x + sum(j, v[j] - v)*0\"\n[graph]\nkind = \"within\"\nradius = 2\n[state]\n{state}\n[run]\nuntil = 3\n"
        )
    };
    // |x_2 - x_1| = 2 sin(t).
    let open = answered(&swing("x = [[0], [0]]\nv = [[0], [2]]"), "n = 1", "always[0, 3](components = 1)", "1 < 0");
    assert_eq!(open.verdict, Verdict::Undecided, "{}", open.why);
    assert!(open.why.contains("at the threshold"), "{}", open.why);
    let begun =
        answered(&parting("4").replace("[1, 0]]\nv", "[2, 0]]\nv"), "n = 1", "always[0, 1](components = 2)", "1 < 0");
    assert_eq!(begun.verdict, Verdict::Undecided, "{}", begun.why);
    // 5/2 cos(t) comes to 2 at t = 0.6435.
    let near = swing("x = [[0], [\"5/2\"]]\nv = [[0], [0]]");
    let found =
        answered(&near, "n = 1", "always[0, 64/100](components = 2) and always[65/100, 2](components = 1)", "1 < 0");
    assert_eq!(found.verdict, Verdict::Holds, "{}", found.why);
}
