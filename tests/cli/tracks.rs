//! `tracks`: the contract and refusals.

use super::{assert_refused, file, flockproof, folder, stdout};

#[test]
fn a_synthetic_school_can_be_analysed_again_from_its_table() {
    let folder = folder("tracks");
    let out = folder.join("made");
    let out = out.to_str().expect("UTF-8");
    let made = flockproof(&[
        "tracks",
        "--synthetic",
        "polarized",
        "--fish",
        "5",
        "--frames",
        "200",
        "--null",
        "9",
        "--out",
        out,
    ]);
    assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
    let text = stdout(&made);
    assert!(text.lines().all(|line| line.chars().count() <= 80), "wider than 80 columns:\n{text}");
    for part in ["synthetic", "window", "blind spot 60", "|p_1|", "2/(n+1)", "headings shifted"] {
        assert!(text.contains(part), "{part} is missing in\n{text}");
    }
    let csv = format!("{out}/tracks.csv");
    let again = folder.join("again");
    let again = again.to_str().expect("UTF-8");
    let read = flockproof(&[
        "tracks",
        &csv,
        "--null",
        "9",
        "--nearest",
        "2,3",
        "--delays",
        "1",
        "--at",
        "10",
        "--out",
        again,
        "--json",
    ]);
    assert!(read.status.success() && read.stderr.is_empty());
    let printed: serde_json::Value = serde_json::from_str(&stdout(&read)).expect("one JSON document");
    assert_eq!((printed["fish"].as_u64(), printed["frames"].as_u64()), (Some(5), Some(200)));
    assert!(printed["means"]["p_1"].as_f64().is_some_and(|p| p > 0.95));
    assert!(printed["means"]["W_nearest"]["3"].is_number());
    assert!(printed["means"]["nearest_distance"].as_f64().is_some_and(|distance| distance > 0.0));
    assert!(printed["few_frames"]["means"].is_boolean() && printed["snapshot"].as_f64() == Some(10.0), "{printed}");
    assert!(printed["per_fish"][0]["speed_frames"].as_u64().is_some_and(|frames| frames > 0 && frames < 200));
    let on_disk = std::fs::read_to_string(format!("{again}/summary.json")).expect("written");
    assert_eq!(serde_json::from_str::<serde_json::Value>(&on_disk).expect("JSON"), printed);
    for name in [
        "frames.csv",
        "fish.csv",
        "gaps.csv",
        "histograms.csv",
        "histograms.svg",
        "order.svg",
        "potentials.png",
        "snapshot.svg",
    ] {
        assert!(std::path::Path::new(again).join(name).exists(), "{name}");
    }
    let frames = std::fs::read_to_string(format!("{again}/frames.csv")).expect("written");
    let fields = frames.lines().next().map_or(0, |line| line.split(',').count());
    assert_eq!(frames.lines().count(), 201);
    assert!(frames.lines().all(|line| line.split(',').count() == fields));
    // Without delays those of the run before are still there, and it is said. At the very start no fish has a heading yet.
    let other = stdout(&flockproof(&["tracks", &csv, "--null", "0", "--at", "0", "--out", again]));
    assert!(other.contains("of an earlier run there: delays.csv, delays.svg,"), "{other}");
    assert!(other.contains("of the frames that are used the closest to t = 0 s"), "{other}");
}

/// Two fish that meet for five frames only: most shifts of their tracks leave the zones of orientation empty, and it is said in how many the
/// cosine has a value.
#[test]
fn shifts_without_a_cosine_are_counted() {
    let folder = folder("tracks_without_arcs");
    let mut table = String::from("t,id,x,y\n");
    for i in 0..60 {
        let other = if (28..=32).contains(&i) { (10 * i, 10) } else { (0, 5000 + i) };
        table += &format!("{i},a,{},0\n{i},b,{},{}\n", 10 * i, other.0, other.1);
    }
    let path = file(&folder, "met.csv", table.as_bytes());
    let out = folder.join("out");
    let text =
        stdout(&flockproof(&["tracks", &path, "--window", "1", "--null", "19", "--out", out.to_str().expect("UTF-8")]));
    let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains("With tracks shifted the cosine has a value in"), "{text}");
    let summary = std::fs::read_to_string(out.join("summary.json")).expect("written");
    let summary: serde_json::Value = serde_json::from_str(&summary).expect("JSON");
    let shifts = &summary["null_models"]["shifted"]["tracks shifted"]["zone_alignment"]["shifts"];
    assert!(shifts.as_u64().is_some_and(|shifts| shifts < 19), "{summary}");
}

/// Ten fish at 25 frames a second, 2 % of the positions missing and two long gaps, in a table with other names: with bridges and fewer
/// fish than all it is analysed, and what it rests on is said.
#[test]
fn a_recording_with_gaps_is_bridged_and_says_on_what_it_rests() {
    let folder = folder("gappy_tracks");
    let mut table = String::from("frame,particle,x,y\n");
    for frame in 0..600 {
        for fish in 0..10 {
            let away = (fish == 3 && (100..220).contains(&frame)) || (fish == 7 && (300..420).contains(&frame));
            if !away && (frame * 7 + fish * 31) % 50 != 0 {
                let turn = 0.01 * f64::from(frame) + 0.6 * f64::from(fish);
                table += &format!("{frame},{fish},{:.4},{:.4}\n", 30.0 * turn.cos(), 30.0 * turn.sin());
            }
        }
    }
    let path = file(&folder, "school.csv", table.as_bytes());
    let out = folder.join("out");
    let read = ["tracks", &path, "--columns", "frame=t,particle=id", "--fps", "25", "--window", "25", "--null", "9"];
    let with = |more: &[&str]| flockproof(&[&read[..], &["--out", out.to_str().expect("UTF-8")], more].concat());
    // Without either no frame is left, and the sentence names both.
    let refused = with(&[]);
    let error = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert_eq!(refused.status.code(), Some(2));
    assert!(error.contains("--max-gap") && error.contains("--min-fish"), "{error}");
    let spline = with(&["--max-gap", "5", "--min-fish", "8", "--bridge", "spline"]);
    assert!(stdout(&spline).contains("positions and velocities at both ends"), "{}", stdout(&spline));
    let analysed = with(&["--max-gap", "5", "--min-fish", "8"]);
    let text = stdout(&analysed);
    assert!(analysed.status.success(), "{}", String::from_utf8_lossy(&analysed.stderr));
    assert!(text.lines().all(|line| line.chars().count() <= 80), "wider than 80 columns:\n{text}");
    for part in [
        "at least 8 of 10 fish",
        "mean speeds go over",
        "bridged",
        "with all fish",
        "rotation (milling) 0.998",
        "a heading of every fish",
    ] {
        let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(words(&text).contains(part), "{part} is missing in\n{text}");
    }
    let gaps = std::fs::read_to_string(out.join("gaps.csv")).expect("written");
    assert!(
        gaps.lines().any(|gap| gap.ends_with("between,true")) && gaps.contains("3,4,8.76,120,between,false"),
        "{gaps}"
    );
    let frames = std::fs::read_to_string(out.join("frames.csv")).expect("written");
    assert!(frames.starts_with("t,left_out,seen,bridged,headings,") && frames.contains(",window,10,"));
}

#[test]
fn bad_tracks_are_refused() {
    let folder = folder("bad_tracks");
    let out = folder.join("out");
    let out = out.to_str().expect("UTF-8");
    let refuse = |name: &str, text: &str, extra: &[&str], named: &str| {
        let path = file(&folder, name, text.as_bytes());
        let mut arguments = vec!["tracks", &path, "--out", out];
        arguments.extend(extra);
        assert_refused(&arguments, named);
    };
    let good: String = (0..9).map(|i| format!("{i},a,{i},0\n{i},b,{i},9\n{i},c,{},{i}\n", 20 - i)).collect();
    let good = format!("t,id,x,y\n{good}");
    refuse("empty.csv", "", &[], "empty.csv: there are no rows");
    refuse("delays.csv", &good, &["--delays", "9"], "--delays: the largest delay of 9 s is not between");
    refuse("arc.csv", &good, &["--bridge", "arc"], "there are line, spline");
    let dates = good.replace("\n8,", "\n2024-05-01,");
    refuse("dates.csv", &dates, &[], "dates.csv: line");
    refuse("text.csv", "t,id,x,y\n0,a,1,2\n0,b,here,2\n", &[], "text.csv: line 3: x is `here`");
    refuse("twice.csv", &format!("{good}3,b,0,0\n"), &[], "twice.csv: line 29: fish b at t = 3 is there twice");
    refuse("good.csv", &good, &["--zones", "2.4,1.4", "--window", "1"], "the zones 2.4, 1.4");
    refuse("good.csv", &good, &["--zones", "2.4"], "--zones");
    refuse("good.csv", &good, &["--zones", "a,b"], "--zones");
    refuse("good.csv", &good, &["--window", "4"], "--window: the window of 4 frames");
    refuse("good.csv", &good, &["--window", "9"], "no frame has a heading of all 3 fish");
    refuse("good.csv", &good, &["--window", "18446744073709551615"], "no frame has a heading");
    refuse("good.csv", &good, &["--window", "-1"], "-1");
    refuse("good.csv", &good, &["--window", "1", "--ids", "a,z"], "no fish z");
    refuse("good.csv", &good, &["--window", "1", "--ids", "a"], "only one fish");
    refuse("good.csv", &good, &["--window", "1", "--nearest", "3"], "--nearest: 3 fish have between 1 and 2");
    refuse("good.csv", &good, &["--window", "1", "--min-fish", "4"], "--min-fish: frames");
    refuse("good.csv", &good, &["--columns", "frame=t"], "no column `frame`");
    refuse("good.csv", &good, &["--columns", "t"], "--columns: `t` is not NAME=t");
    refuse("good.csv", &good, &["--fps", "0"], "--fps: 0 frames per second");
    refuse("good.csv", &good, &["--window", "1", "--body-length", "0"], "body length 0");
    refuse("good.csv", &good, &["--window", "1", "--body-length", "nan"], "`nan` is not an integer");
    refuse("good.csv", &good, &["--window", "1", "--blind", "400"], "--blind: the blind spot of 400");
    refuse("good.csv", &good, &["--window", "1", "--null", "99999999"], "--null 99999999");
    refuse("good.csv", &good, &["--synthetic", "milling"], "--synthetic");
    assert_refused(&["tracks", "/nowhere/at/all.csv", "--out", out], "/nowhere/at/all.csv");
    assert_refused(&["tracks", "--out", out], "FILE.csv");
    assert_refused(&["tracks", "--synthetic", "swarm", "--out", out], "swarm");
    assert_refused(&["tracks", "--synthetic", "milling", "--fish", "1", "--out", out], "--fish");
    let path = file(&folder, "fine.csv", good.as_bytes());
    let fine = flockproof(&["tracks", &path, "--window", "1", "--null", "3", "--out", out]);
    assert!(fine.status.success(), "{}", String::from_utf8_lossy(&fine.stderr));
    let occupied = file(&folder, "occupied", b"");
    assert_refused(&["tracks", &path, "--window", "1", "--null", "3", "--out", &occupied], "occupied");
}
