//! `resonance` on graphs of one's own, sweeps and state matrices.

use super::{assert_refused, file, flockproof, folder, stdout};
use serde_json::Value;

fn json(arguments: &[&str]) -> Value {
    let output = flockproof(&[&["resonance"], arguments, &["--json"]].concat());
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_str(&stdout(&output)).expect("one JSON document")
}

fn float(value: &Value) -> f64 {
    value.as_str().expect("a text").trim_start_matches('~').parse().expect("a float")
}

/// The lower end of an amplitude that is certified.
fn amplitude(document: &Value) -> f64 {
    float(&document["peak"]["amplitude"]["lo"])
}

/// A narrow peak between the frequencies of a grid, on a graph and by the matrices of the same platoon; and as many digits as asked for.
#[test]
fn narrow_peaks_are_found_with_all_digits() {
    let folder = folder("resonance_narrow");
    let edges = "directed\n2 6 10\n3 5\n4 7\n4 3 100\n5 6\n5 3 100\n6 4 10\n7 1 100\n7 5\n";
    let path = file(&folder, "seven.txt", edges.as_bytes());
    let out = folder.join("matrices");
    let out = out.to_str().expect("UTF-8");
    let gains = ["--f=-10,-1,-1,-2,-2,-2", "--g=-1/10,-1,-1/100,-1/2,-1/10,-1"];
    let asked =
        [&["--graph", &path, "--from", "1", "--to", "5", "--digits", "60", "--export", out][..], &gains].concat();
    let found = json(&asked);
    assert!((amplitude(&found) - 168.164).abs() < 1e-3, "{found}");
    let ends = [&found["peak"]["omega"]["lo"], &found["peak"]["omega"]["hi"]].map(|end| end.as_str().expect("a text"));
    assert!(ends[0].starts_with("0.0080049") && ends[0][..60] == ends[1][..60], "{ends:?}");
    let again = json(&["--state", out]);
    assert!((amplitude(&again) / amplitude(&found) - 1.0).abs() < 1e-9 && again["stable"] == true);
}

/// What is not stable has no peak and no margins, and the first line says so.
#[test]
fn unstable_platoons_have_no_peak() {
    let folder = folder("resonance_unstable");
    // Three in a circle, hardly led.
    let path = file(&folder, "circle.txt", b"directed\nb a 1\nb d 9\nc b\nd c\n");
    let asked = ["resonance", "--graph", &path, "--from", "a", "--f=-5", "--g=-1/10"];
    let text = stdout(&flockproof(&asked));
    let first = text.lines().next().expect("a line");
    assert!(
        first.contains("NOT stable, so there is no peak") && !text.contains("margin") && !text.contains("omega"),
        "{text}"
    );
    let found = json(&asked[1..]);
    assert!(found["peak"].is_null() && found["stable"] == false && found["margins"].is_null());
    let table =
        stdout(&flockproof(&["resonance", "--graph", &path, "--from", "a", "--f=-5", "--sweep", "g=-10..-1/10:2"]));
    assert!(table.starts_with("certified") && table.lines().count() == 4, "{table}");
    assert!(table.lines().last().expect("a line").ends_with("not stable"), "{table}");
    // With stronger gains it is stable down to a factor.
    let margins = &json(&["--graph", &path, "--from", "a", "--f=-5", "--g=-10"])["margins"];
    let below = float(&margins["gain"]["below"]["lo"]);
    assert!(below > 0.0 && below < 1.0 && margins["gain"]["above"].is_null(), "{margins}");
    let open = stdout(&flockproof(&[
        "resonance",
        "--followers",
        "13",
        "--f=-1,-2,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1,-1",
        "--g=-1",
    ]));
    assert!(open.contains("gain margin: not decided (more than 12 cars)"), "{open}");
}

#[test]
fn a_file_that_says_the_same_has_the_same_peak() {
    let folder = folder("resonance_graph");
    // Two-sided with a leader: every car tracks both neighbours, the last one the car in front.
    let edges = "directed\nb, a\nb, c\nc, b\nc, d\nd, c\n";
    let path = file(&folder, "cars.txt", edges.as_bytes());
    let own = json(&["--graph", &path, "--from", "a", "--f", "-1", "--g", "-2"]);
    let certified = json(&["--followers", "3", "--f", "-1", "--g", "-2"]);
    let lo = float(&certified["amplitude"]["lo"]);
    // The enclosures are those of the line, digit for digit but for the width.
    assert!((amplitude(&own) / lo - 1.0).abs() < 1e-12 && own["peak"]["grade"] == "certified");
    assert_eq!((&own["followers"], &own["from"], &own["to"]), (&3.into(), &"a".into(), &"d".into()));
    assert_eq!(own["stable"], true);
    let inner = json(&["--graph", &path, "--from", "a", "--to", "b", "--f", "-1", "--g", "-2"]);
    assert!(amplitude(&inner) < lo);
    let other = json(&["--graph", "front-and-back", "--followers", "3", "--f=-1,-2,-3", "--g", "-2"]);
    assert!((amplitude(&other) / lo - 1.0).abs() > 1e-3);
    // Margins of gains of their own are those of the loop turned as a whole.
    let phase = &other["margins"]["phase"];
    assert!(float(&phase["hi"]) > 0.5 && phase["lo"].is_null() && phase["decided"] == false, "{phase}");
    assert!(other["margins"]["critical_factor"].is_null());
    assert_eq!(other["margins"]["gain"]["decided"], true);
    let phase = &json(&["--graph", "circulant:9:1,2", "--f", "-1", "--g", "-1"])["margins"]["phase"];
    let (lo, hi) = (float(&phase["lo"]), float(&phase["hi"]));
    assert!(phase["decided"] == true && lo <= hi && hi - lo < 1e-9 && lo > 0.0, "{phase}");
    // A car that nobody leads stays at rest.
    let cut = file(&folder, "cut.txt", b"directed\n2 1\n3 4\n4 3\n");
    assert_refused(&["resonance", "--graph", &cut, "--f", "-1", "--g", "-1"], "does not reach car 4");
}

#[test]
fn sweeps_are_tables_of_certified_rows() {
    let swept = json(&["--followers", "8", "--sweep", "f=-2..-1:3,g=-1", "--digits", "10"]);
    let rows = swept["rows"].as_array().expect("a list");
    let gains: Vec<&str> = rows.iter().filter_map(|row| row["f"].as_str()).collect();
    assert_eq!((gains, &swept["grade"]), (vec!["-2", "-3/2", "-1"], &"certified".into()));
    let single = json(&["--followers", "8", "--f=-3/2", "--g", "-1", "--digits", "10"]);
    assert_eq!((&rows[1]["omega"], &rows[1]["amplitude"]), (&single["omega"], &single["amplitude"]));
    let text =
        stdout(&flockproof(&["resonance", "--graph", "front", "--followers", "5", "--f=-1", "--sweep", "g=-2..-1:2"]));
    assert!(text.starts_with("certified") && text.lines().count() == 4, "{text}");
    let long = ["resonance", "--graph", "front", "--followers", "101", "--f=-1", "--sweep", "g=-2"];
    assert!(stdout(&flockproof(&long)).starts_with("search, without proof"));
    for (sweep, named) in [
        ("f=-2..-1", "the number of values is missing"),
        ("h=-1", "only f and g"),
        ("f", "it should be f=FROM..TO:COUNT"),
        ("f=-2..-1:1", "from 2 to 100000"),
        ("f=-1,f=-2", "f is there twice"),
        ("f=-1..-2:300,g=-1..-2:400", "120000 rows are more than 100000"),
        ("f=x", "`x` is not an integer"),
        ("f=-1", "--g is needed"),
    ] {
        assert_refused(&["resonance", "--followers", "4", "--sweep", sweep], named);
    }
}

#[test]
fn state_matrices_are_those_of_the_equations() {
    let folder = folder("resonance_export");
    let out = folder.join("matrices");
    let arguments = ["--followers", "2", "--f=-1,-3", "--g=-2", "--export", out.to_str().expect("UTF-8")];
    json(&arguments);
    let read = |name: &str| std::fs::read(out.join(name)).expect(name);
    let text = |name: &str| String::from_utf8(read(name)).expect("text");
    // y_1'' = -1 (y_1 - (y_0 + y_2)/2) - 2 (u_1 - ..), y_2'' = -3 (y_2 - y_1) - 2 (u_2 - u_1).
    let expected = "0.0,1.0,0.0,0.0\n-1.0,-2.0,0.5,1.0\n0.0,0.0,0.0,1.0\n3.0,2.0,-3.0,-2.0\n";
    assert_eq!(text("A.csv").replace("-0.0", "0.0"), expected);
    assert_eq!(text("B.csv").replace("-0.0", "0.0"), "0.0,0.0\n0.5,1.0\n0.0,0.0\n0.0,0.0\n");
    assert_eq!(text("C.csv"), "0.0,0.0,1.0,0.0\n");
    assert!(text("A.mtx").starts_with("%%MatrixMarket matrix coordinate real general\n4 4 "));
    let npy = read("A.npy");
    assert!(npy.starts_with(b"\x93NUMPY\x01\x00") && npy.len() % 64 == 0 && npy.len() == 128 + 16 * 8);
    let last: [u8; 8] = npy[npy.len() - 8..].try_into().expect("8 bytes");
    assert_eq!(f64::from_le_bytes(last), -2.0);
    // Four matrices: 20 bytes of head, the name with a zero byte, the entries.
    assert_eq!(read("all.mat").len(), 4 * 22 + 8 * (16 + 8 + 4 + 2));
    assert!(text("about.txt").contains("flockproof.response/1"));
}

#[test]
fn wrong_graphs_and_gains_are_refused() {
    let ask = |arguments: &[&str], named: &str| assert_refused(&[&["resonance"], arguments].concat(), named);
    ask(&["--f", "-1", "--g", "-1"], "--followers M is needed");
    ask(&["--f", "-1,-2", "--g", "-1", "--followers", "3"], "--f has 2 numbers for 3 followers");
    ask(&["--f", "-1,-2", "--g", "-1,-2,-3", "--followers", "3"], "--f has 2 numbers for 3 followers");
    ask(
        &["--graph", "front", "--followers", "3", "--f", "1", "--g", "-1"],
        "--f must be negative, but it is 1: the law is y'' = f e + g e'",
    );
    ask(&["--graph", "front", "--followers", "3000", "--f", "-1", "--g", "-1"], "at most 2000");
    ask(&["--graph", "front", "--followers", "3", "--f", "-1", "--g", "-1", "--to", "4"], "the followers 1 to 3");
    ask(&["--graph", "ring:5", "--followers", "3", "--f", "-1", "--g", "-1"], "this one tells how many");
    ask(&["--graph", "ring:5", "--f", "-1", "--g", "-1", "--to", "1"], "vertex 1 leads");
    ask(&["--graph", "ring:5", "--f", "-1", "--g", "-1", "--from", "x"], "no vertex x");
    ask(&["--graph", "no.txt", "--f", "-1", "--g", "-1"], "neither front, front-and-back nor a file");
    ask(
        &["--graph", "front", "--followers", "3", "--f=-1", "--g=-1", "--certificate", "c"],
        "--certificate: only the two-sided",
    );
}

/// What was written is read again, from CSV and from NumPy: the same system has the same peak.
#[test]
fn state_matrices_are_read_as_they_are_written() {
    let folder = folder("resonance_state");
    let out = folder.join("matrices");
    let path = out.to_str().expect("UTF-8");
    let known = json(&["--followers", "3", "--f=-1,-3,-2", "--g=-2", "--export", path]);
    let same = |found: &Value| {
        let (found, known) = (amplitude(found), amplitude(&known));
        assert!((found / known - 1.0).abs() < 1e-9, "{found} {known}");
    };
    let found = json(&["--state", path]);
    same(&found);
    assert_eq!((&found["states"], &found["inputs"], &found["stable"]), (&6.into(), &2.into(), &true.into()));
    for name in ["A", "B", "C", "D"] {
        std::fs::remove_file(out.join(format!("{name}.csv"))).expect("written before");
    }
    same(&json(&["--state", path]));
}

/// Weights ahead and behind: the one of the paper, the same as an edge list, and what is asked of each of them.
#[test]
fn asymmetric_platoons_are_said_in_one_line() {
    let peak =
        |arguments: &[&str]| json(&[&["--followers", "4", "--f=-1", "--g=-2"], arguments].concat())["peak"].clone();
    let (plain, half) = (json(&["--followers", "4", "--f=-1", "--g=-2"]), peak(&["--ahead", "1/2"]));
    // Two ways to the same peak, whose last digits differ.
    for name in ["omega", "amplitude"] {
        let [one, other] =
            [&plain, &half].map(|found| found[name]["lo"].as_str().expect("a decimal")[..24].to_string());
        assert_eq!(one, other);
    }
    let folder = folder("resonance_weights");
    let edges = "directed\na leader 0.6\na b 0.4\nb a 3\nb c 2\nc b 0.6\nc d 0.4\nd c\n";
    let path = file(&folder, "weights.txt", edges.as_bytes());
    let graph = json(&["--graph", &path, "--f=-1", "--g=-2"]);
    let weights = peak(&["--ahead", "0.6", "--behind", "0.4"]);
    assert_eq!(graph["peak"], weights);
    // One of them alone, lists, shares of another size, and the two kinds apart.
    for same in [
        &["--ahead", "0.6"][..],
        &["--behind=0.4,0.4,0.4,0"],
        &["--ahead=3,6,0.6,1", "--behind=2,4,0.4,1"],
        &["--ahead=[3, 6, 0.6, 1]", "--behind=each:2,4,0.4,1"],
        &["--f-ahead", "0.6", "--g-behind", "0.4"],
    ] {
        assert_eq!(peak(same), weights, "{same:?}");
    }
    assert_ne!(peak(&["--f-ahead", "0.6", "--g-ahead", "0.5"]), weights);
    assert_ne!(peak(&["--f-ahead", "0.6"]), weights);
    // Gains of the links: the last car has one link.
    let links = ["--followers", "4", "--f-ahead=-0.6", "--f-behind=-0.4", "--g-ahead=-1.2", "--g-behind=-0.8"];
    let own = ["--followers", "4", "--ahead=0.6", "--f=-1,-1,-1,-0.6", "--g=-2,-2,-2,-1.2"];
    assert_eq!(json(&links)["peak"], json(&own)["peak"]);
    let lists = ["resonance", "--followers", "4", "--f=-1", "--g=-2", "--ahead=0.6,0.8,0.5,1"];
    let said = stdout(&flockproof(&lists));
    assert!(said.contains("weights: 4 ahead (least 1/2, largest 1), scaled to a sum of one for each car\n"), "{said}");
    let table = stdout(&flockproof(&["resonance", "--followers", "4", "--g=-2", "--ahead", "0.6", "--sweep", "f=-1"]));
    let amplitude = weights["amplitude"]["lo"].as_str().expect("a decimal");
    assert!(table.contains(&amplitude[..12]), "{table} {amplitude}");
    for (arguments, named) in [
        (&["--f=-1", "--g=-1", "--ahead", "0.6", "--f-ahead", "1"][..], "--ahead and --f-ahead cannot both be given"),
        (&["--f=-1", "--g=-1", "--ahead", "0.6,0.5"], "--ahead has 2 numbers for 4 followers: one, or one for each"),
        (&["--f=-1", "--g=-1", "--ahead", "x"], "--ahead: `x` is not an integer"),
        (&["--f=-1", "--g=-1", "--ahead", "0.6 0.5 1 1"], "a list is 0.6,0.5,1"),
        (&["--f=-1", "--g=-1", "--g-behind", "1.5"], "--g-behind is 3/2, but a weight is between 0 and 1"),
        (&["--f=-1", "--g=-1", "--ahead", "-1", "--behind", "1"], "--ahead is -1, but a weight is not negative"),
        (&["--f-ahead=-1", "--g=-1"], "--f-behind is needed"),
        (&["--f-ahead=1", "--f-behind=1", "--g=-1"], "--f-ahead is 1, but without --f it is the gain of a link"),
        (&["--f=-1", "--g=-1", "--behind", "1"], "car 4 has the weight zero ahead, and nobody behind"),
        (&["--f=-1", "--g=-1", "--ahead", "0.6", "--certificate", "c"], "only the two-sided platoon with equal gains"),
        (&["--f=-1", "--g=-1", "--ahead", "0.6", "--graph", "front"], "--ahead is for cars on a line"),
    ] {
        assert_refused(&[&["resonance", "--followers", "4"], arguments].concat(), named);
    }
    assert_refused(
        &["resonance", "--graph", "ring:4", "--f=-1", "--g=-1", "--g-ahead", "1"],
        "--g-ahead is for cars on a line",
    );
}

/// The table against the formula of the paper, `a_k = T_(M-k)/T_M`; a diagram with its marks.
#[test]
fn responses_are_tabulated_and_drawn() {
    let found = json(&["--followers", "2", "--f=-1", "--g=-1", "--cars", "1,2", "--response", "0,1", "--digits", "12"]);
    // gamma = 1 + w²/(f + iwg) = 1 - 1/(1 + i) = (1 + i)/2 at w = 1: T_1 = (1 + i)/2, T_2 = 2 gamma² - 1 = -1 + i.
    let number = |x: &Value| x.as_str().expect("a decimal").parse::<f64>().expect("a float");
    for (row, (car, amplitude, phase)) in found["response"].as_array().expect("rows").iter().zip([
        ("1", 1.0, 0.0),
        ("2", 1.0, 0.0),
        ("1", 0.5, -std::f64::consts::FRAC_PI_2),
        ("2", 0.5f64.sqrt(), -0.75 * std::f64::consts::PI),
    ]) {
        assert_eq!(row["car"], car);
        for (x, known) in [(&row["amplitude"], amplitude), (&row["phase"], phase)] {
            let (lo, hi) = (number(&x["lo"]), number(&x["hi"]));
            assert!(lo <= known + 1e-14 && known - 1e-14 <= hi && hi - lo < 1e-11, "{row}");
        }
    }
    let folder = folder("resonance_bode");
    for (name, start) in [("a.svg", &b"<svg"[..]), ("a.png", b"\x89PNG")] {
        let path = folder.join(name);
        let plot = [
            "resonance",
            "--followers",
            "3",
            "--f=-1",
            "--g=-1",
            "--ahead",
            "0.6",
            "--plot",
            path.to_str().expect("UTF-8"),
        ];
        let text = stdout(&flockproof(&plot)).split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(text.ends_with(&format!("written: {}: magnitude and phase of car 3", path.display())), "{text}");
        assert!(std::fs::read(&path).expect(name).starts_with(start));
    }
    let text = std::fs::read_to_string(folder.join("a.svg")).expect("text");
    for words in ["peak, certified", "car 3", "magnitude (dB)", "phase (degrees)", "ahead 3/5"] {
        assert!(text.contains(words), "{words}");
    }
    let ask = |arguments: &[&str], named: &str| {
        assert_refused(&[&["resonance", "--followers", "3", "--f=-1", "--g=-1"], arguments].concat(), named);
    };
    ask(&["--plot", "x.pdf"], "x.pdf: the name of a picture should end in .svg or .png");
    ask(&["--cars", "2"], "--cars names the cars of --response and --plot, and neither is given");
    ask(&["--cars", "4", "--response", "1"], "--cars: there are the followers 1 to 3");
    ask(&["--response", "1..2"], "the number of frequencies is missing");
    ask(&["--response", "0..2:3"], "FROM should be above 0");
    ask(&["--response", "-1"], "frequencies are not negative");
    ask(&["--response", "1", "--sweep", "f=-1"], "--sweep makes a table only");
}

/// Positions heard more from behind than velocities: not stable, and the table says so.
#[test]
fn what_is_not_stable_has_a_response_that_nobody_sees() {
    let asked = ["resonance", "--followers", "60", "--f=-1", "--g=-1", "--f-ahead", "0.6", "--g-ahead", "0.5"];
    let text = stdout(&flockproof(&[&asked[..], &["--response", "1"]].concat()));
    assert!(text.contains("NOT stable, so there is no peak") && text.contains("which no motion"), "{text}");
}
