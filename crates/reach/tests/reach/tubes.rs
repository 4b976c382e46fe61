//! What is drawn of a quantity over time encloses the worst cases at single times.

use super::{decided, one_mode, read};
use arithmetic::Unwatched;
use num_traits::ToPrimitive;
use reach::{Tube, tube};

fn drawn(text: &str, samples: usize) -> Tube {
    let found = decided(text, 8);
    tube(&read(text), found[0].decisive(), samples, &Unwatched).expect("not stopped")
}

#[test]
fn a_tube_that_grows_is_exact_at_the_ends_of_its_sections() {
    let text = one_mode("[\"x\"]", "{ u = [-1, 2] }", "{ x = 0 }", "[[-1]]", "[[1]]", "2", &["2*x + 1 <= 9"]);
    let tube = drawn(&text, 40);
    assert_eq!((tube.quantity.as_str(), tube.sections.len()), ("2*x + 1", 40));
    for [from, to, least, most] in tube.sections {
        let grown = 1.0 - (-to).exp();
        assert!((to - from - 0.05).abs() < 1e-12);
        assert!(most >= 4.0 * grown + 1.0 - 1e-14 && most <= 4.0 * grown + 1.0 + 1e-9, "{to}: {most}");
        assert!(least <= 1.0 - 2.0 * grown + 1e-14 && least >= 1.0 - 2.0 * grown - 1e-9, "{to}: {least}");
    }
    let [_, end, value, _] = *tube.runs[0].last().expect("a motion");
    assert!((end - 2.0).abs() < 1e-9 && (value - 5.0 + 4.0 * (-2.0f64).exp()).abs() < 1e-6, "{end} {value}");
}

#[test]
fn sections_enclose_the_worst_cases_at_their_times() {
    let head = "[system]\nstates = [\"x\", \"v\"]\ninputs = { u = [-1, \"1/2\"] }\nstart = { x = [0, \"1/10\"], v = 0 }\n\
        [[mode]]\nname = \"a\"\nA = [[0, 1], [-2, -1]]\nB = [[0], [1]]\n[[mode]]\nname = \"b\"\nA = [[0, 1], [-9, -1]]\nB = [[0], [2]]\nc = [0, \"1/5\"]\n";
    for switching in [
        "kind = \"periodic\"\norder = [\"a\", \"b\"]\nperiod = \"3/2\"",
        "kind = \"windows\"\norder = [\"b\", \"a\"]\nwindows = [2]",
    ] {
        let text = format!("{head}[switching]\n{switching}\n[run]\nuntil = 8\n[[check]]\nholds = \"x <= 9\"\n");
        let samples = 80;
        let tube = drawn(&text, samples);
        assert_eq!(tube.sections.len(), samples);
        // In a section of 1/10 the quantity changes by so much at most; the mean value form may double it.
        let fastest = ["v", "-v"].map(|row| super::worst(&text.replace("x <= 9", &format!("{row} <= 99")), 6).1);
        let change = 0.2 * fastest[0].clone().max(fastest[1].clone()).to_f64().expect("finite");
        for k in [1, 7, 14, 15, 16, 33, 61, 80] {
            // At an end of two sections and in the middle of one.
            for at in [format!("{k}/10"), format!("{}/20", 2 * k - 1)] {
                for (row, sign) in [("x", 1.0), ("-x", -1.0)] {
                    let check = format!("[[check]]\nholds = \"{row} <= 9\"\nat = \"{at}\"\n");
                    let one = text.replace("[[check]]\nholds = \"x <= 9\"\n", &check);
                    let (lo, hi) = super::worst(&one, 8);
                    let time = arithmetic::parse_rational(&at).expect("a number").to_f64().expect("finite");
                    let (lo, hi) = (lo.to_f64().expect("finite"), hi.to_f64().expect("finite"));
                    let around = tube.sections.iter().filter(|own| own[0] - 1e-9 <= time && time <= own[1] + 1e-9);
                    for [_, _, least, most] in around {
                        let edge = if sign > 0.0 { *most } else { -*least };
                        assert!(edge >= lo - 1e-9 && edge <= hi + change, "{switching} {row} {at}: {edge} {lo} {hi}");
                    }
                }
            }
        }
        for point in &tube.runs[0] {
            let around = tube.sections.iter().filter(|own| own[0] <= point[0] && point[0] <= own[1]);
            for section in around {
                assert!(point[2] >= section[2] - 1e-6 && point[2] <= section[3] + 1e-6, "{section:?} {point:?}");
            }
        }
    }
}

#[test]
fn what_has_no_fixed_order_is_drawn_by_its_motion_alone() {
    let text = "[system]\nstates = [\"x\"]\ninputs = { u = [-1, 1] }\nstart = { x = 0 }\n[[mode]]\nname = \"a\"\nA = [[-1]]\nB = [[1]]\n\
        [[mode]]\nname = \"b\"\nA = [[-2]]\nB = [[1]]\n[switching]\nkind = \"arbitrary\"\n[run]\nuntil = 3\n[[check]]\nholds = \"x <= 9\"\n";
    let tube = drawn(text, 30);
    assert!(tube.sections.is_empty() && tube.runs.len() == 1, "{tube:?}");
}
