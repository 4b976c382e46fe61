//! Unknown instants, dwell times, any switching: bounds against all that fixed orders attain.

use super::{consistent, decided, worst};
use arithmetic::{Rational, rational};
use reach::Verdict;

/// Two modes of a damped oscillator that is pushed strongly or weakly.
fn two(switching: &str, until: &str, check: &str) -> String {
    format!(
        "[system]\nstates = [\"x\", \"v\"]\ninputs = {{ u = [-1, 1] }}\nstart = {{ x = 0, v = 0 }}\n\
         [[mode]]\nname = \"stiff\"\nA = [[0, 1], [-2, -2]]\nB = [[0], [1]]\n\
         [[mode]]\nname = \"soft\"\nA = [[0, 1], [-1, -2]]\nB = [[0], [1]]\n\
         [switching]\n{switching}\n[run]\nuntil = {until}\n[[check]]\nholds = \"{check}\"\n"
    )
}

const CHECK: &str = "x <= 10";

fn tenths(k: i64) -> String {
    format!("\"{k}/10\"")
}

#[test]
fn windows_are_the_worst_of_their_instants() {
    let of = |windows: &str| {
        worst(
            &two(
                &format!("kind = \"windows\"\norder = [\"stiff\", \"soft\", \"stiff\"]\nwindows = {windows}"),
                "4",
                CHECK,
            ),
            7,
        )
    };
    let whole = of("[[1, 2], [\"5/2\", 3]]");
    let mut most = Rational::ZERO;
    for k in 10..=20 {
        for l in [25, 27, 30] {
            let one = of(&format!("[{}, {}]", tenths(k), tenths(l)));
            assert!(one.0 <= whole.1, "{k} {l}: {one:?} {whole:?}");
            most = most.max(one.1);
        }
    }
    assert!(whole.0 <= &most + rational(1, 100) && &whole.1 - &whole.0 <= rational(1, 1_000_000), "{whole:?} {most}");
}

#[test]
fn a_window_of_one_instant_is_a_period() {
    let windows = two("kind = \"windows\"\norder = [\"stiff\", \"soft\"]\nwindows = [2]", "4", CHECK);
    let periodic = two("kind = \"periodic\"\norder = [\"stiff\", \"soft\"]\nperiod = 2", "4", CHECK);
    let (a, b) = (worst(&windows, 12), worst(&periodic, 12));
    assert!(a.0 <= b.1 && b.0 <= a.1, "{a:?} {b:?}");
}

#[test]
fn dwell_times_allow_every_period_within_them() {
    let dwell = worst(
        &two(
            "kind = \"dwell\"\nfirst = \"stiff\"\nat_least = { stiff = 1, soft = 1 }\nat_most = { stiff = 2, soft = 2 }",
            "3",
            CHECK,
        ),
        6,
    );
    for k in [10, 13, 17, 20] {
        let one = worst(
            &two(&format!("kind = \"periodic\"\norder = [\"stiff\", \"soft\"]\nperiod = {}", tenths(k)), "3", CHECK),
            8,
        );
        assert!(one.0 <= dwell.1, "{k}: {one:?} {dwell:?}");
    }
    assert!(&dwell.1 - &dwell.0 <= rational(1, 50), "{dwell:?}");
}

#[test]
fn any_switching_is_bounded_and_attained() {
    for until in ["4", "\"inf\""] {
        let found = decided(&two("kind = \"arbitrary\"", until, CHECK), 8).remove(0);
        assert_eq!(found.verdict, Verdict::Holds);
        let part = &found.parts[0];
        consistent(part);
        let (lo, hi) = (part.lo.clone().expect("attained"), part.hi.clone().expect("a bound"));
        for k in [2, 5, 10, 15, 20] {
            let one = worst(
                &two(
                    &format!("kind = \"periodic\"\norder = [\"soft\", \"stiff\"]\nperiod = {}", tenths(k)),
                    "4",
                    CHECK,
                ),
                8,
            );
            assert!(one.0 <= hi, "{k}: {one:?} {hi}");
        }
        let soft = worst(&two("kind = \"constant\"\nmode = \"soft\"", "4", CHECK), 8);
        assert!(lo >= &soft.0 - rational(1, 100), "{lo} {soft:?}");
    }
    let planted = two("kind = \"arbitrary\"", "4", "x <= 4/5");
    assert_eq!(decided(&planted, 8)[0].verdict, Verdict::False);
}

#[test]
fn a_period_for_ever_is_the_limit_of_long_times() {
    let of =
        |until: &str| worst(&two("kind = \"periodic\"\norder = [\"stiff\", \"soft\"]\nperiod = 1", until, CHECK), 8);
    let (long, ever) = (of("40"), of("\"inf\""));
    assert!((&ever.1 - &long.0) <= rational(1, 1_000_000) && long.0 <= ever.1, "{long:?} {ever:?}");
}

#[test]
fn what_switching_makes_unstable_has_no_bound() {
    // Two stable modes that turn the plane the other way round each: switched well, everything grows.
    let text = "[system]\nstates = [\"x\", \"y\"]\nstart = { x = [-1, 1], y = [-1, 1] }\n\
        [[mode]]\nname = \"a\"\nA = [[\"-1/10\", 1], [-10, \"-1/10\"]]\n[[mode]]\nname = \"b\"\nA = [[\"-1/10\", 10], [-1, \"-1/10\"]]\n\
        [switching]\nkind = \"arbitrary\"\n[run]\nuntil = \"inf\"\n[[check]]\nholds = \"x <= 1000\"\n";
    let found = decided(text, 6).remove(0);
    assert_eq!(found.verdict, Verdict::False);
    assert_eq!(found.parts[0].hi, None);
}

/// A mode that may last longer than is looked back is not cut off there.
#[test]
fn long_stays_count_for_ever() {
    let slow = "[system]\nstates = [\"x\"]\ninputs = { u = [0, 1] }\nstart = { x = 0 }\n[[mode]]\nname = \"off\"\nA = [[-1]]\nB = [[0]]\n\
        [[mode]]\nname = \"on\"\nA = [[\"-1/40\"]]\nB = [[1]]\n[switching]\nkind = \"dwell\"\nfirst = \"off\"\nat_least = { off = 10 }\n\
        at_most = { on = 30 }\n[run]\nuntil = \"inf\"\n[[check]]\nholds = \"x <= 100\"\n";
    let ever = worst(slow, 4);
    // 30 on from nothing: 40 (1 - e^(-3/4)) > 21.
    assert!(ever.1 > rational(21, 1), "{ever:?}");
}

/// A start beyond the bound refutes it, though all motions lead away from there.
#[test]
fn the_start_is_a_motion_too() {
    for until in ["3", "\"inf\""] {
        let text = format!(
            "[system]\nstates = [\"x\"]\ninputs = {{}}\nstart = {{ x = [1, 5] }}\n[[mode]]\nname = \"a\"\nA = [[-1]]\n[[mode]]\nname = \"b\"\nA = [[\"-3/2\"]]\n\
             [switching]\nkind = \"arbitrary\"\n[run]\nuntil = {until}\n[[check]]\nholds = \"x <= 4\"\n[[check]]\nholds = \"x <= 6\"\n"
        );
        let found = decided(&text, 8);
        assert_eq!([&found[0].verdict, &found[1].verdict], [&Verdict::False, &Verdict::Holds], "{until}");
        let witness = found[0].parts[0].witness.as_ref().expect("a motion");
        assert_eq!((&witness.at, &witness.start[0]), (&Rational::ZERO, &rational(5, 1)));
    }
}

/// Two rows differ, in opposite ways: what switching adds to both is bounded together. A twin in floats tries orders of modes, input and start by the thousands.
#[test]
fn no_order_of_modes_that_a_twin_tries_leaves_the_bound() {
    let a = [
        [[0.0, 1.0, 0.0], [-2.0, -2.0, 1.0], [0.5, 0.0, -1.0]],
        [[0.0, 1.0, 0.0], [-1.0, -2.0, -1.0], [-0.5, 0.5, -1.5]],
    ];
    let rows = |m: usize| format!("{:?}", a[m].map(|row| row.map(|x| format!("{}/2", 2.0 * x))));
    let text = |check: &str| {
        format!(
            "[system]\nstates = [\"x\", \"y\", \"z\"]\ninputs = {{ u = [-2, 1] }}\nstart = {{ x = [0, 1], y = 0, z = 0 }}\n\
             [[mode]]\nname = \"a\"\nA = {}\nB = [[0], [1], [0]]\n[[mode]]\nname = \"b\"\nA = {}\nB = [[0], [1], [1]]\n\
             [switching]\nkind = \"arbitrary\"\n[run]\nuntil = 6\n[[check]]\nholds = \"{check}\"\n",
            rows(0),
            rows(1)
        )
    };
    let b = [[0.0, 1.0, 0.0], [0.0, 1.0, 1.0]];
    let mut seed = 1u64;
    let mut draw = || {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (seed >> 40) as f64 / f64::from(1u32 << 24)
    };
    for (check, row) in [("x <= 0", [1.0, 0.0, 0.0]), ("z <= 0", [0.0, 0.0, 1.0]), ("x + z >= 0", [-1.0, 0.0, -1.0])] {
        let part = decided(&text(check), 6).remove(0).parts.remove(0);
        consistent(&part);
        let ends = if check.contains(">=") { (part.hi.map(|x| -x), part.lo.map(|x| -x)) } else { (part.lo, part.hi) };
        let float = |x: Option<Rational>| x.and_then(|x| num_traits::ToPrimitive::to_f64(&x)).expect("a number");
        let (lo, hi) = (float(ends.0), float(ends.1));
        let mut most = f64::NEG_INFINITY;
        for _ in 0..2000 {
            // Backwards along the costate, with the worst input at each instant.
            let (mut p, mut sum, mut mode, h) = (row, 0.0, 0, 0.01);
            let (mut left, time) = (0, (draw() * 600.0) as usize);
            for _ in 0..time {
                if left == 0 {
                    (mode, left) = ((draw() * 2.0) as usize, 1 + (draw() * 150.0) as usize);
                }
                left -= 1;
                let push: f64 = (0..3).map(|i| b[mode][i] * p[i]).sum();
                sum += h * (push * 1.0).max(push * -2.0);
                let change = |j: usize| p[j] + h * (0..3).map(|i| a[mode][i][j] * p[i]).sum::<f64>();
                p = [change(0), change(1), change(2)];
            }
            most = most.max(sum + p[0].max(0.0));
        }
        assert!(most <= hi + 0.02 && lo >= most - 0.1, "{check}: {most} in {lo} {hi}");
    }
}

#[test]
fn modes_that_are_all_alike_are_one() {
    let one = "A = [[0, 1], [-1, -2]]\nB = [[0], [1]]\n";
    let of = |switching: &str| {
        worst(
            &format!(
                "[system]\nstates = [\"x\", \"v\"]\ninputs = {{ u = [-1, 1] }}\nstart = {{ x = 0, v = 0 }}\n[[mode]]\nname = \"a\"\n{one}[[mode]]\nname = \"b\"\n{one}\
                 [switching]\n{switching}\n[run]\nuntil = \"inf\"\n[[check]]\nholds = \"x <= 1\"\n"
            ),
            10,
        )
    };
    for switching in ["kind = \"periodic\"\norder = [\"a\", \"b\"]\nperiod = 1", "kind = \"arbitrary\""] {
        super::close(&of(switching), &super::number("1"), 10);
    }
}

/// A mode that grows and is left again is no obstacle for ever.
#[test]
fn only_the_last_mode_lasts() {
    let text = |until: &str, check: &str| {
        format!(
            "[system]\nstates = [\"x\"]\ninputs = {{ u = [-1, 1] }}\nstart = {{ x = 0 }}\n[[mode]]\nname = \"up\"\nA = [[1]]\nB = [[1]]\n\
             [[mode]]\nname = \"down\"\nA = [[-1]]\nB = [[1]]\n[switching]\nkind = \"windows\"\norder = [\"up\", \"down\"]\nwindows = [[1, 2]]\n\
             [run]\nuntil = {until}\n[[check]]\nholds = \"{check}\"\n"
        )
    };
    // e^2 - 1 at t = 2.
    let (lo, hi) = worst(&text("\"inf\"", "x <= 7"), 5);
    assert!(
        lo <= rational(6389057, 1000000) && hi >= rational(6389056, 1000000) && &hi - &lo < rational(1, 100),
        "{lo} {hi}"
    );
    for (check, verdict) in [("x <= 64/10", Verdict::Holds), ("x <= 63/10", Verdict::False)] {
        assert_eq!(decided(&text("\"inf\"", check), 5)[0].verdict, verdict);
    }
}

/// Switching makes stable oscillators grow without end: the motion of 600 units of time, as long as motions are remembered, is lost in its enclosure, and a shorter one
/// violates the bounds.
#[test]
fn what_grows_without_end_is_false_by_a_motion_that_is_not_lost() {
    for until in ["\"inf\"", "600"] {
        let text = format!(
            "[system]\nstates = [\"x\", \"v\"]\nstart = {{ x = 1, v = 0 }}\n[[mode]]\nname = \"soft\"\nA = [[0, 1], [-1, \"-1/10\"]]\n[[mode]]\nname = \"stiff\"\n\
             A = [[0, 1], [-4, \"-1/10\"]]\n[switching]\nkind = \"arbitrary\"\n[run]\nuntil = {until}\n[[check]]\nholds = \"x <= 1000\"\n[[check]]\nholds = \"x >= -5\"\n"
        );
        for found in decided(&text, 10) {
            assert_eq!(found.verdict, Verdict::False, "{until}: {}", found.check.text);
            let part = &found.parts[0];
            consistent(part);
            assert!(part.witness.as_ref().is_some_and(|witness| witness.at <= rational(600, 1)), "{until}");
        }
    }
}
