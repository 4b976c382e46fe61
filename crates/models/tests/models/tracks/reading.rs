//! The table: what is read, what is refused and how it is said.

use models::tracks::{Tracks, TracksError, gaps};

fn refused(text: &str) -> String {
    match Tracks::from_csv(text) {
        Ok(tracks) => panic!("accepted: {tracks:?}"),
        Err(error) => error.to_string(),
    }
}

fn read(text: &str) -> Tracks {
    Tracks::from_csv(text).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn order_of_rows_and_columns_and_other_columns_do_not_matter() {
    let plain = read("t,id,x,y\n0,1,0,1\n0,2,5,6\n0.5,1,0.25,1\n0.5,2,5,7\n1,1,2e0,1\n1,2,5,8\n");
    let mixed = read(
        "\u{feff}y, z ,id,x,comment,t\n8,0,2,5,\"a, b\",1\n1,0,1,0,,0\n6,0,2,5,,0\n7,0,2,5,,0.5\n1,0,1,2,,1.0\n1,0,1,.25,,5e-1\n",
    );
    assert_eq!(plain, mixed);
    assert_eq!((plain.fish(), plain.recorded_frames(), plain.step), (2, 3, 0.5));
    assert_eq!(read(&plain.to_csv()), plain);
}

#[test]
fn names_are_sorted_as_numbers_where_they_are_numbers() {
    let tracks = read("t,id,x,y\n0,10,0,0\n0,9,1,1\n1,10,0,0\n1,9,1,1\n0,left,2,2\n1,left,2,2\n");
    assert_eq!(tracks.ids, ["9", "10", "left"]);
    assert_eq!(tracks.only(&["left".into(), "9".into()]).map(|t| t.ids), Ok(vec!["9".to_string(), "left".to_string()]));
    assert!(matches!(tracks.only(&["8".into()]), Err(TracksError::UnknownFish { .. })));
    assert!(matches!(tracks.only(&["9".into()]), Err(TracksError::OneFish(_))));
}

#[test]
fn bad_tables_are_refused_with_the_line() {
    for (text, said) in [
        ("", "no rows"),
        ("\n\n", "no rows"),
        ("t,id,x,y\n", "no rows"),
        ("t,id,x\n0,1,2\n", "line 1: the header has no column `y`"),
        ("T,id,x,y\n0,1,2,3\n", "line 1: the header has no column `t`"),
        ("0,1,2,3\n1,1,2,3\n", "line 1: the header has no column `t`"),
        ("t,id,x,y,x\n0,1,2,3,4\n", "line 1: the header has the column `x` twice"),
        ("t,id,x,y\n0,1,2\n", "line 2: there are 3 fields where the header has 4"),
        ("t,id,x,y\n0,1,2,3\n1,1,2,3,4\n", "line 3: there are 5 fields"),
        ("t,id,x,y\n0,1,NaN,3\n", "line 2: x is `NaN`"),
        ("t,id,x,y\n0,1,1,3\n0,2,1,-inf\n", "line 3: y is `-inf`"),
        ("t,id,x,y\n0,1,,3\n", "line 2: x is ``"),
        ("t,id,x,y\n0,1,one,3\n", "line 2: x is `one`"),
        ("t,id,x,y\n0,1,1e200,3\n", "line 2: x is 1e200, beyond 1e100"),
        ("t,id,x,y\nnow,1,1,3\n", "line 2: t is `now`"),
        ("t,id,x,y\n0, ,1,3\n", "line 2: id is empty"),
        ("t,id,x,y\n0,\"a\nb\",1,3\n", "line 2: id is empty or has a control character"),
        ("t,id,x,y\n0,1,\"1\n2\",3\n", "line 2: x is `1?2`"),
        ("t;id;x;y\n0;1;2;3\n", "it has t;id;x;y"),
        ("t,id,x,y\n0,1,1,3\n0,2,1,1\n-0.0,1,5,5\n", "line 4: fish 1 at t = 0 is there twice, first in line 2"),
        ("t,id,x,y\n0,1,1,3\n1,1,1,3\n2,1,1,3\n", "only one fish, 1"),
        ("t,id,x,y\n3,1,1,3\n3,2,1,3\n", "the same time t = 3"),
        ("t,id,x,y\n0,1,1,3\n1,2,1,3\n2,1,1,3\n2.5,2,1,3\n3.5,2,1,3\n", "line 5: the frame times are not uniform: 0.5"),
        ("t,id,x,y\n0,1,1,3\n1,2,1,3\n2,1,1,3\n9.3,2,1,3\n", "line 5: the frame times are not uniform: 7.3"),
        ("t,id,x,y\n0,1,1,3\n1,2,1,3\n1.0000001,1,1,3\n2,2,1,3\n3,2,1,3\n", "the frame times are not uniform"),
        ("t,id,x,y\n0,1,1,3\n1,2,1,3\n2,2,1,3\n1e90,1,1,3\n", "line 5: the frame times are not uniform"),
    ] {
        let error = refused(text);
        assert!(error.contains(said), "{text:?}: `{error}` does not say `{said}`");
        assert_eq!(error.lines().count(), 1, "{error}");
    }
}

#[test]
fn times_rounded_to_three_decimals_are_uniform() {
    let mut text = String::from("t,id,x,y\n");
    for i in 0..900 {
        let t = f64::from(i) / 60.0;
        text.push_str(&format!("{t:.3},a,{i},0\n{t:.3},b,{i},1\n"));
    }
    let tracks = read(&text);
    assert_eq!(tracks.recorded_frames(), 900);
    assert!((tracks.step - 1.0 / 60.0).abs() < 1e-6, "{}", tracks.step);
    // After a long hole the step is known to 1 in 2000 only.
    let holed: String =
        text.lines().enumerate().filter(|(i, _)| !(21..1600).contains(i)).map(|(_, l)| format!("{l}\n")).collect();
    assert!(read(&holed).recorded_frames().abs_diff(900) <= 1);
}

#[test]
fn gaps_are_found_where_they_were_planted() {
    let mut text = String::from("t,id,x,y\n");
    for i in 0..20 {
        // Frame 11 is missing for all; a comes at 2, b leaves after 15 and is away at 5 and 6.
        let here = |id: &str| match id {
            "a" => i >= 2,
            "b" => i <= 15 && i != 5 && i != 6,
            _ => true,
        };
        for id in ["a", "b", "c"].into_iter().filter(|id| i != 11 && here(id)) {
            text.push_str(&format!("{},{id},0,{i}\n", 0.25 * f64::from(i)));
        }
    }
    let tracks = read(&text);
    assert_eq!((tracks.recorded_frames(), tracks.frames.len()), (20, 19));
    let found: Vec<_> =
        gaps(&tracks).into_iter().map(|g| (g.fish, g.from, g.to, g.frames, g.at_start, g.at_end)).collect();
    assert_eq!(
        found,
        [
            (0, 0.0, 0.25, 2, true, false),
            (0, 2.75, 2.75, 1, false, false),
            (1, 1.25, 1.5, 2, false, false),
            (1, 2.75, 2.75, 1, false, false),
            (1, 4.0, 4.75, 4, false, true),
            (2, 2.75, 2.75, 1, false, false),
        ]
    );
}

/// Two fish at these times, read and with its step, or what is said.
fn at(times: &[f64]) -> Result<Tracks, String> {
    let row = |t: &f64| format!("{t},a,0,0\n{t},b,1,{t}\n");
    Tracks::from_csv(&format!("t,id,x,y\n{}", times.iter().map(row).collect::<String>())).map_err(|e| e.to_string())
}

/// Forty steps of 1, then one of another length, then three more.
fn after_a_step_of(last: f64) -> Result<Tracks, String> {
    let tail = (0..4).map(|i| 40.0 + last + f64::from(i));
    at(&(0..=40).map(f64::from).chain(tail).collect::<Vec<_>>())
}

/// A tenth of a step, and a hundredth of a hole.
#[test]
fn steps_may_be_a_little_off_the_grid() {
    for (good, bad, frames) in
        [(1.08, 1.12, 45), (0.92, 0.88, 45), (2.08, 2.13, 46), (20.18, 20.25, 64), (1e9, 1.1e9, 1_000_000_044)]
    {
        assert_eq!(after_a_step_of(good).map(|tracks| tracks.recorded_frames()), Ok(frames), "{good}");
        assert!(after_a_step_of(bad).is_err_and(|said| said.contains("not uniform")), "{bad}");
    }
    // What is said of the others leaves out the one that is off.
    assert!(after_a_step_of(1.25).is_err_and(|said| said.ends_with("but 1 elsewhere")));
}

/// The frame step is the middle one of all steps, the smaller of two.
#[test]
fn the_frame_step_is_the_median() {
    let of = |steps: &[f64]| {
        let mut time = 5.0;
        at(&[5.0]
            .into_iter()
            .chain(steps.iter().map(|step| {
                time += step;
                time
            }))
            .collect::<Vec<_>>())
        .map(|tracks| (tracks.step, tracks.recorded_frames()))
    };
    assert_eq!(of(&[0.5, 0.5]), Ok((0.5, 3)));
    assert_eq!(of(&[1.5, 0.5]), Ok((0.5, 5)));
    assert_eq!(of(&[0.5, 1.5, 0.5, 1.5]), Ok((0.5, 9)));
    for steps in [&[0.5, 1.5, 1.5][..], &[0.5, 0.5, 1.5, 1.5, 1.5]] {
        assert!(of(steps).is_err_and(|said| said.ends_with("0.5 from the frame before to t = 5.5, but 1.5 elsewhere")));
    }
}

#[test]
fn names_with_marks_come_back_from_the_table() {
    let tracks = read("t,id,x,y\n0,\"a, b\",0,0\n0,\"say \"\"c\"\"\",1,1\n1,\"a, b\",0,0\n1,\"say \"\"c\"\"\",1,2\n");
    assert_eq!(tracks.ids, ["a, b", "say \"c\""]);
    assert_eq!(read(&tracks.to_csv()), tracks);
}

#[test]
fn numbers_are_read_up_to_their_limit() {
    assert_eq!(read("t,id,x,y\n0,1,1e100,0\n0,2,-1e100,0\n1,1,0,0\n1,2,0,0\n").fish(), 2);
    for x in ["1.1e100", "-1.1e100"] {
        assert!(refused(&format!("t,id,x,y\n0,1,{x},0\n")).contains("beyond 1e100"));
    }
}
