//! `pattern`: the verdicts that the theory knows, and what is refused.

use super::{assert_refused, flockproof, stdout};
use serde_json::Value;

fn verdicts(particles: &str, gains: &str) -> Vec<(u64, String)> {
    let output = flockproof(&["pattern", "--particles", particles, "--gains", gains, "--json"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let document: Value = serde_json::from_str(&stdout(&output)).expect("JSON");
    let rows = document["patterns"].as_array().expect("a list").iter();
    rows.map(|row| (row["clusters"].as_u64().expect("a number"), row["verdict"].as_str().expect("a word").to_string()))
        .collect()
}

#[test]
fn gains_of_theorem_3_stabilise_their_pattern() {
    // K_m > 0 below M, K_M < 0: the (M,N)-pattern is exponentially stable.
    for clusters in [1, 2, 3, 4, 6, 12] {
        let gains: Vec<&str> = (1..clusters).map(|_| "1/5").chain(["-1/25"]).collect();
        let stable = (clusters, "stable".to_string());
        assert!(verdicts("12", &gains.join(",")).contains(&stable), "{clusters} clusters");
    }
    // With the signs turned it is not.
    assert!(verdicts("12", "-1/5,-1/5,1/25").contains(&(3, "unstable".to_string())));
    // Balanced phases without further pattern cost nothing under K_1 alone.
    assert!(verdicts("12", "1/5").contains(&(12, "undecided".to_string())));
}

/// Twelve balanced phases under K_1 alone: further eigenvalues 0, and all others to the left. The largest real part is 0, and not that of the others.
#[test]
fn eigenvalues_0_that_rotation_does_not_force_are_counted() {
    let text = stdout(&flockproof(&["pattern", "--particles", "12", "--gains", "1/5"]));
    let row = text.lines().last().expect("a row");
    assert_eq!(row.split_whitespace().collect::<Vec<_>>(), ["12", "undecided", "0"]);
    let document: Value =
        serde_json::from_str(&stdout(&flockproof(&["pattern", "--particles", "12", "--gains", "1/5", "--json"])))
            .expect("JSON");
    for row in document["patterns"].as_array().expect("a list") {
        let number = |end: &str| row["abscissa"][end].as_str().expect("a number").parse::<f64>().expect("a number");
        let (lo, hi, zeros) = (number("lo"), number("hi"), row["zeros"].as_u64().expect("a number"));
        assert!(lo <= hi && (zeros == 1 || lo >= 0.0), "{row}");
        match row["verdict"].as_str() {
            Some("stable") => assert!(hi < 0.0 && zeros == 1, "{row}"),
            Some("unstable") => assert!(lo > 0.0, "{row}"),
            _ => assert!(lo <= 0.0 && hi >= 0.0, "{row}"),
        }
    }
}

#[test]
fn long_numbers_are_folded() {
    let output = flockproof(&["pattern", "--particles", "4", "--gains=1e400"]);
    let text = stdout(&output);
    assert!(output.status.success() && text.starts_with("4 particles") && text.contains("clusters  verdict"), "{text}");
    assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
}

#[test]
fn what_makes_no_sense_is_refused() {
    assert_refused(&["pattern", "--particles", "0", "--gains", "1"], "particles");
    assert_refused(&["pattern", "--particles", "61", "--gains", "1"], "60");
    assert_refused(&["pattern", "--particles", "4", "--gains", "x"], "gains");
    assert_refused(&["pattern", "--particles", "4", "--gains", "1", "--omega0", "0"], "omega0");
    assert_refused(&["pattern", "--particles", "2", "--gains", "1,1,1"], "at most 2");
}
