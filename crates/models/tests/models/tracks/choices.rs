//! Choices on both sides of their limits, histograms, scales, and what an analysis says of each fish.

use super::measures::{Asked, setting};
use super::nulls::Told;
use arithmetic::{Complex, Unwatched};
use models::tracks::{
    Attributes, BridgeShape, Choices, ChoicesError, Form, Format, Histogram, NearestRule, PositionsUsed, Scale, School,
    Smoothing, Tracks, analyse, smoothed, synthetic_school,
};
use std::sync::atomic::AtomicUsize;

#[test]
fn choices_are_checked_on_both_sides_of_their_limits() {
    let good = Choices::of_sidebar(0.1);
    assert_eq!(good.check(2), Ok(()));
    let with = |change: &dyn Fn(&mut Choices)| {
        let mut choices = good.clone();
        change(&mut choices);
        choices.check(5)
    };
    for window in [1, 3, 51] {
        assert_eq!(with(&|c| c.window = window), Ok(()));
        assert_eq!(with(&|c| c.window = window - 1), Err(ChoicesError::EvenWindow(window - 1)));
    }
    for (length, is_good) in [(0.0, false), (1e-9, true), (-1.0, false), (f64::INFINITY, false), (f64::NAN, false)] {
        assert_eq!(with(&|c| c.body_length = length).is_ok(), is_good, "{length}");
    }
    for (zones, is_good) in [
        ([1.0, 2.0, 3.0], true),
        ([1.0, 2.0, f64::INFINITY], true),
        ([0.0, 2.0, 3.0], false),
        ([2.0, 2.0, 3.0], false),
        ([3.0, 2.0, 4.0], false),
        ([1.0, 3.0, 3.0], false),
        ([1.0, 3.0, 2.0], false),
        ([f64::NAN, 2.0, 3.0], false),
    ] {
        assert_eq!(with(&|c| c.zones = zones).is_ok(), is_good, "{zones:?}");
    }
    for (blind, is_good) in [(0.0, true), (180.0, true), (-0.1, false), (180.1, false)] {
        assert_eq!(with(&|c| c.blind = blind).is_ok(), is_good, "{blind}");
    }
    for (still, is_good) in [(0.0, true), (2.0, true), (-1e-9, false), (f64::INFINITY, false), (f64::NAN, false)] {
        assert_eq!(with(&|c| c.still = still).is_ok(), is_good, "{still}");
    }
    assert_eq!(with(&|c| c.nearest = vec![1, 4]), Ok(()));
    for n in [0, 5] {
        assert_eq!(with(&|c| c.nearest = vec![2, n]), Err(ChoicesError::Neighbours { n, fish: 5 }));
    }
    assert_eq!(ChoicesError::Neighbours { n: 9, fish: 5 }.to_string(), "5 fish have between 1 and 4 neighbours, not 9");
}

/// The odd number of frames closest to five seconds; lengths in body lengths of 5.3.
#[test]
fn the_sidebar_chooses_for_every_step() {
    for (step, window) in
        [(0.1, 51), (1.0, 5), (0.5, 11), (2.0, 3), (5.0, 1), (9.0, 1), (0.3, 17), (1e-30, 2_000_000_001)]
    {
        assert_eq!(Choices::of_sidebar(step).window, window, "{step}");
    }
    let choices = Choices::of_sidebar(0.1);
    assert_eq!((choices.positions, choices.rule), (PositionsUsed::File, NearestRule::SecondInRepulsion));
    assert_eq!((choices.body_length, choices.blind, choices.still), (5.3, 60.0, 0.0));
    let zones = choices.zones();
    assert_eq!((zones.repulsion, zones.orientation, zones.attraction), (1.4 * 5.3, 2.4 * 5.3, f64::INFINITY));
    // 30 degrees on each side.
    assert!((zones.blind_cosine_squared - 0.75).abs() < 1e-15);
    assert_eq!(choices.too_near(), Some(1.4 * 5.3));
    assert_eq!(Choices { rule: NearestRule::Nearest, ..choices }.too_near(), None);
    assert_eq!(Choices::radii_of_zones(&[1.0, 2.0]), Ok([1.0, 2.0, f64::INFINITY]));
    assert_eq!(Choices::radii_of_zones(&[1.0, 2.0, 3.0]), Ok([1.0, 2.0, 3.0]));
    for count in [0, 1, 4] {
        assert_eq!(Choices::radii_of_zones(&vec![1.0; count]), Err(ChoicesError::ZoneCount(count)));
    }
}

#[test]
fn histograms_count_every_value_once() {
    let mut histogram = Histogram::of(-1.0, 3.0, 4, [-1.0, -0.5, 0.0, 0.99, 1.0, 2.5, 3.0, -1.01, 3.01, 4.0]);
    assert_eq!((&histogram.counts[..], histogram.outside, histogram.total()), (&[2, 2, 1, 2][..], (1, 2), 10));
    // The ends up to rounding.
    [-1.0 - 3e-12, 3.0 + 3e-12].into_iter().for_each(|x| histogram.add(x));
    assert_eq!((&histogram.counts[..], histogram.outside), (&[3, 2, 1, 3][..], (1, 2)));
    [-1.0 - 5e-12, 3.0 + 5e-12].into_iter().for_each(|x| histogram.add(x));
    assert_eq!((&histogram.counts[..], histogram.outside), (&[3, 2, 1, 3][..], (2, 3)));
    let other = Histogram { range: (-1.0, 3.0), counts: vec![10, 20, 30, 40], outside: (5, 6) };
    histogram.merge(&other);
    assert_eq!((&histogram.counts[..], histogram.outside), (&[13, 22, 31, 43][..], (7, 9)));
    assert_eq!(histogram.total(), 125);
    let bins: Vec<_> = histogram.bins().collect();
    let known = [(-1.0, 0.0, 13), (0.0, 1.0, 22), (1.0, 2.0, 31), (2.0, 3.0, 43)];
    assert_eq!(bins, known.map(|(from, to, count)| (from, to, count, count as f64 / 125.0)));
    let outline = Histogram { range: (0.0, 2.0), counts: vec![1, 3], outside: (0, 0) }.outline();
    let corners = [(0.0, 0.0), (0.0, 0.25), (1.0, 0.25), (1.0, 0.75), (2.0, 0.75), (2.0, 0.0)];
    assert_eq!(outline, corners);
    let empty = Histogram::new(0.0, 1.0, 0);
    assert_eq!((empty.counts.len(), empty.total(), empty.bins().next()), (1, 0, Some((0.0, 1.0, 0, 0.0))));
}

#[test]
fn scales_are_their_printed_factors() {
    assert_eq!(Scale::ALL.map(Scale::name), ["2/(n+1)", "2/n+1", "1/n"]);
    for n in [1i64, 2, 7] {
        assert_eq!(Scale::ALL.map(|scale| scale.ratio(n)), [(2, n + 1), (n + 2, n), (1, n)]);
        let x = n as f64;
        assert_eq!(Scale::ALL.map(|scale| scale.factor(n as usize)), [2.0 / (x + 1.0), (x + 2.0) / x, 1.0 / x]);
    }
    // Six fish: n = 5 and n = 1.
    let found = Scale::ALL.map(|scale| scale.difference(6, 0.9, 0.2));
    let known = [0.9 / 3.0 - 0.2, 0.9 * 1.4 - 0.6, 0.9 / 5.0 - 0.2];
    assert!(found.iter().zip(known).all(|(a, b)| (a - b).abs() < 1e-15), "{found:?}");
}

/// Three fish on lines: the first at rest in the middle, the third missing for two frames, in a table that skips a frame.
fn three() -> Tracks {
    let mut text = "t,id,x,y\n".to_string();
    for i in (0..30).filter(|i| *i != 20) {
        let (t, x) = (f64::from(i) * 0.5, f64::from(i));
        let first = if (8..=14).contains(&i) { 8.0 } else { x.min(8.0) + (x - 14.0).max(0.0) };
        text.push_str(&format!("{t},1,{first},0\n{t},2,{x},{}\n", 3.0 + 0.5 * x));
        if !(4..=5).contains(&i) {
            text.push_str(&format!("{t},3,{},-4\n", -2.0 * x));
        }
    }
    Tracks::from_csv(&text).expect("a recording")
}

/// The summaries by what is known of the lines.
#[test]
fn fish_are_summarised_as_they_swim() {
    let choices = Choices { window: 3, body_length: 2.0, nearest: vec![2], ..Choices::of_sidebar(0.5) };
    let tracks = three();
    let analysis = analyse(&tracks, &choices, &Unwatched).expect("analysed");
    let left = analysis.left_out;
    // The frames 4, 5 and 20 miss a fish; a velocity takes two frames on each side.
    assert_eq!((left.recorded, left.missing), (30, 3));
    let present = |i: i32| (0..30).contains(&i) && ![4, 5, 20].contains(&i);
    let window = (0..30).filter(|i| present(*i) && !(i - 2..=i + 2).all(present)).count() as u64;
    // Fish 1 is in one place from frame 8 to 14, so that it rests from 10 to 12.
    assert_eq!((left.window, left.still, left.used), (window, 3, 27 - window - 3));
    let [first, second, third] = &analysis.fish[..] else { panic!("{:?}", analysis.fish) };
    assert_eq!((first.seen, second.seen, third.seen), (29, 29, 27));
    assert_eq!((first.missing, second.missing, third.missing), ((1, 1), (1, 1), (3, 2)));
    assert_eq!((first.still, second.still, third.still), (3, 0, 0));
    let speed = |x: Option<f64>, known: f64| assert!(x.is_some_and(|x| (x - known).abs() < 1e-12), "{x:?} {known}");
    speed(second.speed, 2.0 * 1.25f64.sqrt());
    speed(third.speed, 4.0);
    assert_eq!(analysis.speeds().count(), analysis.motion.velocities.iter().flatten().flatten().count());
    // Distances where all are seen.
    let mut sums = [0.0; 3];
    let mut frames = 0.0;
    for i in 0..tracks.frames.len() {
        let Some(all) = (0..3).map(|k| tracks.positions[k][i].clone()).collect::<Option<Vec<Complex<f64>>>>() else {
            continue;
        };
        frames += 1.0;
        for (k, sum) in sums.iter_mut().enumerate() {
            let to = |j: usize| (all[j].re - all[k].re).hypot(all[j].im - all[k].im);
            *sum += (0..3).filter(|&j| j != k).map(to).fold(f64::INFINITY, f64::min);
        }
    }
    for (fish, sum) in analysis.fish.iter().zip(sums) {
        speed(fish.distance, sum / frames);
    }
    assert!((analysis.distances().sum::<f64>() - sums.iter().sum::<f64>()).abs() < 1e-9);
    // Zones: the shares of the frames in which the measures have them.
    for (k, fish) in analysis.fish.iter().enumerate() {
        let seen: Vec<_> = analysis.frames.iter().filter_map(|frame| frame.zones[k]).collect();
        let share = |zone: usize| seen.iter().filter(|zones| zones[zone]).count() as f64 / seen.len() as f64;
        let found = fish.zones.expect("frames");
        (0..3).for_each(|zone| speed(Some(found[zone]), share(zone)));
    }
    let groups: Vec<_> = analysis.groups().collect();
    assert_eq!(groups.len() as u64, left.used);
    assert!(groups.iter().all(|(time, _)| analysis.frames.iter().any(|frame| frame.time == *time)));
    speed(Some(analysis.mean(|group| group.momentum)), {
        groups.iter().map(|(_, group)| group.momentum).sum::<f64>() / groups.len() as f64
    });
    assert_eq!(analysis.sample().frames(), groups.len());
}

/// Gaps of one fish, and a frame that nobody has: all swim on lines, so bridges are where they would have been.
#[test]
fn bridges_lie_on_lines() {
    let tracks = three().bridge(2, BridgeShape::Line);
    assert_eq!((tracks.frames.len(), tracks.bridged.len()), (30, 4));
    let at = |fish: usize, i: usize| tracks.positions[fish][i].as_ref().map(|r| (r.re, r.im));
    let close = |found: Option<(f64, f64)>, (x, y): (f64, f64)| {
        assert!(found.is_some_and(|(a, b)| (a - x).hypot(b - y) < 1e-12), "{found:?} {x} {y}");
    };
    close(at(2, 4), (-8.0, -4.0));
    close(at(2, 5), (-10.0, -4.0));
    close(at(1, 20), (20.0, 13.0));
    close(at(0, 20), (14.0, 0.0));
    assert_eq!(tracks.frames[20].time, 10.0);
    let on = tracks.on_bridges();
    assert_eq!((on[4], on[5], on[20], on.iter().sum::<usize>()), (1, 1, 3, 5));
    // Of two fish the bridges of these two.
    let two = tracks.only(&["2".to_string(), "3".to_string()]).expect("fish");
    assert_eq!((two.bridged.len(), two.bridged[2].fish), (3, 1));
    // A single frame is bridged, two are not; what is gone at an end has no other side.
    assert_eq!(three().bridge(1, BridgeShape::Line).bridged.len(), 3);
    assert_eq!(three().bridge(0, BridgeShape::Line), three());
    // Of a part of the recording the bridges that it has, the last one as far as it goes.
    for frames in 0..=30 {
        let part = tracks.first(frames);
        let known: usize = on[..frames].iter().sum();
        assert_eq!(part.bridged.iter().map(|gap| gap.frames as usize).sum::<usize>(), known, "{frames}");
        assert_eq!(part.on_bridges(), on[..frames]);
    }
    // A stop right after a start that is missing: what was seen is never less than nothing.
    let ways = (0..40).map(|i| {
        format!("{i},a,{i},0\n{}", if (2..30).contains(&i) { String::new() } else { format!("{i},b,{i},1\n") })
    });
    let gappy = Tracks::from_csv(&format!("t,id,x,y\n{}", ways.collect::<String>())).expect("a recording");
    let gappy = gappy.bridge(40, BridgeShape::Line);
    let choices = Choices { window: 1, ..Choices::of_sidebar(1.0) };
    let stopped = analyse(&gappy, &choices, &Asked(AtomicUsize::new(6))).expect("as far as it went");
    let seen = stopped.fish[1].seen + stopped.fish[1].missing.0;
    assert!(stopped.frames.len() < 40 && seen == stopped.left_out.recorded, "{:?}", stopped.fish);
    let ends = "t,id,x,y\n0,a,0,0\n1,a,1,0\n2,a,2,0\n1,b,0,0\n";
    assert!(Tracks::from_csv(ends).expect("a recording").bridge(9, BridgeShape::Line).bridged.is_empty());
}

/// A spline goes through parabolas without an error that a line has, and where no second position is there it is the line.
#[test]
fn splines_keep_positions_and_velocities() {
    // Fish a along x = t^3 - t, y = 5 t, without frames 4 to 6; fish b has a row at one side of its gap only.
    let mut text = String::from("t,id,x,y\n");
    for t in 0..12 {
        if !(4..=6).contains(&t) {
            text += &format!("{t},a,{},{}\n", t * t * t - t, 5 * t);
        }
        if ![1, 4, 5].contains(&t) {
            text += &format!("{t},b,{t},{}\n", t * t);
        }
    }
    let tracks = Tracks::from_csv(&text).expect("a recording").bridge(3, BridgeShape::Spline);
    assert_eq!((tracks.bridged.len(), tracks.bridged_by), (3, BridgeShape::Spline));
    let at = |fish: usize, i: usize| tracks.positions[fish][i].as_ref().map(|r| (r.re, r.im)).expect("a place");
    // The cubic of Hermite by its four conditions: p(0) = 24, p(1) = 336, slopes 4 (24 - 6) and 4 (504 - 336).
    let cubic = |s: f64| {
        let (h00, h10) = ((1.0 + 2.0 * s) * (1.0 - s).powi(2), s * (1.0 - s).powi(2));
        let (h01, h11) = (s * s * (3.0 - 2.0 * s), s * s * (s - 1.0));
        24.0 * h00 + 72.0 * h10 + 336.0 * h01 + 672.0 * h11
    };
    for i in 4..7 {
        let (x, y) = at(0, i);
        assert!((x - cubic((i - 3) as f64 / 4.0)).abs() < 1e-12 && (y - 5.0 * i as f64).abs() < 1e-12, "{i}: {x}");
    }
    // Frame 1 of b: no row before frame 0, so the slope there is that of the line, 4 in a bridge; after it 2 (9 - 4).
    assert!((at(1, 1).1 - (2.0 - (2.0 * 5.0 - 4.0) / 8.0)).abs() < 1e-12, "{:?}", at(1, 1));
}

/// Dates: seconds from the first one, in any order of rows, with and without an offset; one way of writing in a file.
#[test]
fn times_may_be_dates() {
    let table = |dates: [&str; 3]| {
        let rows = dates.iter().enumerate().flat_map(|(i, t)| ["a", "b"].map(|id| format!("{t},{id},{i},{id}\n")));
        format!("t,id,x,y\n{}", rows.collect::<String>().replace(",a\n", ",0\n").replace(",b\n", ",1\n"))
    };
    let zoned =
        Tracks::from_csv(&table(["2024-05-01T12:00:00.08Z", "2024-05-01T12:00:00Z", "2024-05-01T14:00:00.04+02"]));
    let zoned = zoned.expect("a recording");
    assert_eq!(zoned.start.as_deref(), Some("2024-05-01T12:00:00Z"));
    assert_eq!(zoned.frames.iter().map(|frame| frame.time).collect::<Vec<_>>(), [0.0, 0.04, 0.08]);
    assert_eq!(zoned.positions[0][2].as_ref().map(|r| r.re), Some(0.0));
    let local = Tracks::from_csv(&table(["2024-02-28 23:59:59", "2024-02-29 00:00:00", "2024-02-29 00:00:01"]));
    let local = local.expect("a recording");
    assert_eq!((local.start.as_deref(), local.step), (Some("2024-02-28T23:59:59"), 1.0));
    let refused = |dates, fps| {
        let format = Format::new::<&str>(&[], fps).expect("a format");
        Tracks::from_table(&table(dates), &format).expect_err("no recording").to_string()
    };
    let mixed = refused(["2024-05-01T12:00:00Z", "2024-05-01T12:00:01", "2"], None);
    assert!(mixed.contains("line 4: t is `2024-05-01T12:00:01`, not a date like that of the first row"), "{mixed}");
    let mixed = refused(["2024-05-01T12:00:00", "2024-05-01T12:00:01Z", "2"], None);
    assert!(mixed.contains("line 4: t is `2024-05-01T12:00:01Z`"), "{mixed}");
    assert!(refused(["1", "2024-05-01T12:00:01Z", "2"], None).contains("neither a number nor a date"));
    let rate = refused(["2024-05-01T12:00:00Z", "2024-05-01T12:00:01Z", "2024-05-01T12:00:02Z"], Some(25.0));
    assert!(rate.contains("dates need none"), "{rate}");
}

/// Other names of columns, and times in frames.
#[test]
fn tables_of_other_forms_are_read() {
    let (plain, frames) = ("t,id,x,y\n", "frame,particle,x_mm,y\n");
    let rows =
        |step: f64| (0..4).map(move |i| format!("{},a,{i},0\n{},b,{i},1\n", f64::from(i) * step, f64::from(i) * step));
    let seconds = format!("{plain}{}", rows(0.5).collect::<String>());
    let counted = format!("{frames}{}", rows(1.0).collect::<String>());
    let format = Format::new(&["frame=t", "particle=id", "x_mm=x"], Some(2.0)).expect("a format");
    assert_eq!(Tracks::from_table(&counted, &format), Tracks::from_csv(&seconds));
    let refused = Tracks::from_table(&seconds, &format).expect_err("no such column").to_string();
    assert!(refused.contains("no column `frame`"), "{refused}");
    let wrong = |columns: &[&str], fps| Format::new(columns, fps).expect_err("no format").to_string();
    assert!(wrong(&["frame"], None).contains("`frame` is not NAME=t"));
    assert!(wrong(&["frame=z"], None).contains("`frame=z` is not NAME=t"));
    assert!(wrong(&["a=t", "b=t"], None).contains("two columns are to be t"));
    assert!(wrong(&[], Some(0.0)).contains("not a positive number"));
    // Seconds are no numbers of frames.
    let rated = Format::new::<&str>(&[], Some(2.0)).expect("a format");
    let refused = Tracks::from_table(&seconds, &rated).expect_err("fractions").to_string();
    assert!(refused.contains("line 4: t is `0.5`, not a whole number of frames"), "{refused}");
}

/// Positions as in the file or averaged over the window.
#[test]
fn positions_are_those_that_are_chosen() {
    let tracks = synthetic_school(School::Milling, &setting(4, 60));
    let of = |positions| {
        analyse(&tracks, &Choices { window: 5, positions, ..Choices::of_sidebar(0.1) }, &Unwatched).unwrap()
    };
    assert_eq!(of(PositionsUsed::File).positions, tracks.positions);
    let means: Vec<_> = (0..4).map(|k| smoothed(&tracks, k, Smoothing::Mean, 5).0).collect();
    let averaged = of(PositionsUsed::Smoothed);
    assert_eq!(averaged.positions, means);
    assert_eq!(averaged.positions[0].iter().flatten().count(), 56);
    assert_eq!(averaged.left_out, of(PositionsUsed::File).left_out);
}

/// Why nothing is left, in words.
#[test]
fn a_recording_without_headings_says_why() {
    let tracks = three();
    let error = analyse(&tracks, &Choices { window: 15, ..Choices::of_sidebar(0.5) }, &Unwatched);
    let known = "no frame has a heading of all 3 fish: of 30 frames, a fish is missing in 3, the window of 15 frames meets a gap or \
                 an end in 27, a fish is at rest in 0; fish 3 is seen least, in 27 frames; choose a smaller --window, bridge short gaps with \
                 --max-gap, count frames with --min-fish, or choose fish with --ids";
    assert_eq!(error.expect_err("nothing left").to_string(), known);
}

/// Each frame is told before it is measured; choices are checked first.
#[test]
fn an_analysis_tells_its_frames_and_checks_its_choices() {
    let (tracks, told) = (three(), Told::default());
    let choices = Choices { window: 3, ..Choices::of_sidebar(0.5) };
    let whole = analyse(&tracks, &choices, &told).expect("analysed");
    let frames = tracks.frames.len() as u64;
    assert_eq!(told.all(), (0..frames).map(|i| (i, "frames".to_string(), Some(frames))).collect::<Vec<_>>());
    // Fish 3 swims 4 in a second, always in one direction.
    let (own, all) = (whole.motion.velocities[2].iter().flatten().count(), whole.speeds().count());
    assert!(whole.speeds().skip(all - own).all(|speed| (speed - 4.0).abs() < 1e-12));
    // Where the work was stopped, the last frame may have headings that know what came after; it is in the sample too.
    let reached = analyse(&tracks, &choices, &Asked(AtomicUsize::new(1 + 10))).expect("analysed");
    assert!(reached.frames.last().is_some_and(|frame| frame.group.is_some()));
    assert_eq!(reached.sample().frames(), reached.groups().count());
    let error = analyse(&tracks, &Choices { window: 4, ..choices }, &Unwatched).expect_err("no middle frame");
    assert_eq!(error, ChoicesError::EvenWindow(4));
}

#[test]
fn no_fish_and_any_number_of_neighbours_are_answered() {
    let nobody = synthetic_school(School::Milling, &setting(0, 0));
    let error = analyse(&nobody, &Choices::of_sidebar(0.1), &Unwatched).expect_err("no fish");
    assert_eq!(error, ChoicesError::NothingLeft("there are no fish in the recording".into()));
    assert_eq!(Scale::ALL.map(|scale| scale.ratio(i64::MAX)), [(2, i64::MAX), (i64::MAX, i64::MAX), (1, i64::MAX)]);
}

/// Tables of trackers: fish in one row, body parts with scores, and what is missing in them.
#[test]
fn tables_of_trackers_are_read() {
    let at = |tracks: &Tracks, fish: usize, i: usize| tracks.positions[fish][i].as_ref().map(|r| (r.re, r.im));
    let wide = "time,x1,y1,x2,y2,x10\n0,1,2,3,4,5\n0.5,1,2,,4,5\n1,1,2,nan,nan,5\n1.5,7,8,9,10,5\n";
    let tracks = Tracks::from_csv(wide).expect("a recording");
    assert_eq!((tracks.form, tracks.fish(), tracks.step), (Form::Wide, 2, 0.5));
    assert_eq!((at(&tracks, 1, 0), at(&tracks, 1, 1), at(&tracks, 1, 2)), (Some((3.0, 4.0)), None, None));
    let frames = Format::new::<&str>(&[], Some(2.0)).expect("a rate");
    let counted = wide.replace("time", "frame").replace("\n0.5,", "\n1,").replace("\n1,1,2,nan", "\n2,1,2,nan");
    let counted = counted.replace("\n1.5,", "\n3,");
    assert_eq!(Tracks::from_table(&counted, &frames), Ok(tracks));
    let error = |text: &str, format: &Format| Tracks::from_table(text, format).expect_err("refused").to_string();
    assert!(error(&counted, &Format::default()).contains("how many frames there are in a second"));
    assert!(error("when,x1,y1,x2,y2\n0,1,1,1,1\n", &frames).contains("no column `time`"));
    assert!(error("time,x1,y1,x2,y2\n0,1,1,one,1\n", &frames).contains("line 2: x is `one`"));
    let lab = "scorer,n,n,n,n,n,n,n,n,n,n,n,n\nindividuals,a,a,a,a,a,a,b,b,b,b,b,b\n\
               bodyparts,nose,nose,nose,tail,tail,tail,nose,nose,nose,tail,tail,tail\n\
               coords,x,y,likelihood,x,y,likelihood,x,y,likelihood,x,y,likelihood\n\
               0,0,0,0.9,2,4,0.9,10,10,1,12,10,0.2\n1,0,0,0.9,,,,10,10,1,12,10,0.2\n2,0,0,0.1,2,4,0.1,10,10,1,12,10,1\n";
    let tracks = Tracks::from_table(lab, &frames).expect("a recording");
    assert_eq!((tracks.form, tracks.ids.as_slice()), (Form::DeepLabCut, ["a", "b"].map(str::to_string).as_slice()));
    assert_eq!(
        (at(&tracks, 0, 0), at(&tracks, 0, 1), at(&tracks, 1, 0)),
        (Some((1.0, 2.0)), Some((0.0, 0.0)), Some((11.0, 10.0)))
    );
    let sure = Tracks::from_table(lab, &frames.clone().of_parts(None, 0.6)).expect("a recording");
    assert_eq!((at(&sure, 0, 2), at(&sure, 1, 0), at(&sure, 1, 2)), (None, Some((10.0, 10.0)), Some((11.0, 10.0))));
    let tail = Tracks::from_table(lab, &frames.clone().of_parts(Some("tail".to_string()), 0.0)).expect("a recording");
    assert_eq!((at(&tail, 0, 0), at(&tail, 0, 1)), (Some((2.0, 4.0)), None));
    assert_eq!((tail.parts.as_slice(), sure.parts.len()), (["tail".to_string()].as_slice(), 2));
    assert!(
        error(lab, &frames.clone().of_parts(None, 1.5))
            .contains("no body part that was seen has a score of at least 1.5")
    );
    assert!(error(wide, &Format::default().of_parts(None, 0.5)).contains("no body parts and no scores"));
    let fin = frames.clone().of_parts(Some("fin".to_string()), 0.0);
    assert!(error(lab, &fin).contains("no body part `fin`; there are nose, tail"));
    assert!(error(lab, &Format::default()).contains("frames"));
    let leap = "track,frame_idx,instance.score,nose.x,nose.y,nose.score,tail.x,tail.y,tail.score\n\
                track_0,0,0.9,0,0,0.9,2,4,0.9\ntrack_1,0,0.9,10,10,1,12,10,0.2\ntrack_0,1,0.9,0,0,0.9,,,\ntrack_1,1,1,10,10,1,12,10,0.2\n\
                track_1,2,1,10,10,1,12,10,1\ntrack_0,2,1,0,0,0.1,2,4,0.1\n";
    for format in
        [frames.clone(), frames.clone().of_parts(None, 0.6), frames.clone().of_parts(Some("tail".to_string()), 0.0)]
    {
        let (lab, leap) = (Tracks::from_table(lab, &format).unwrap(), Tracks::from_table(leap, &format).unwrap());
        assert_eq!(lab.positions, leap.positions);
    }
    assert!(error("track,frame_idx\na,0\n", &frames).contains("no column `NAME.x`"));
    assert!(error("scorer,a\ncoords,x\n", &frames).contains("no column `bodyparts`"));
    assert!(error("t,id,x,y\n0,a,1,1\n", &fin).contains("no body part"));
}

/// Tables with names of their own for the columns: idtracker.ai, trackpy and Ctrax; what was not seen is left out.
#[test]
fn names_of_columns_of_other_software_are_known() {
    let plain = Tracks::from_csv("t,id,x,y\n0,0,1,2\n0,1,3,4\n0.5,0,5,6\n1,0,7,8\n1,1,9,10\n").expect("a recording");
    let frames = Format::new::<&str>(&[], Some(2.0)).expect("a rate");
    let none = Format::default();
    let tidy = "frame,time,individual,x,y,probability\n0,0,0,1,2,1\n0,0,1,3,4,1\n1,0.5,0,5,6,1\n1,0.5,1,nan,nan,nan\n2,1,0,7,8,1\n2,1,1,9,10,1\n";
    let trackpy = "y,x,mass,frame,particle\n2,1,9,0,0\n4,3,9,0,1\n6,5,9,1,0\n8,7,9,2,0\n10,9,9,2,1\n";
    let flies = "timestamp,identity,x_pos,y_pos,angle\n0,0,1,2,0\n0,1,3,4,0\n0.5,0,5,6,0\n1,0,7,8,0\n1,1,9,10,0\n";
    for (text, format, form) in
        [(tidy, &none, Form::Tidy), (trackpy, &frames, Form::Trackpy), (flies, &none, Form::Ctrax)]
    {
        let tracks = Tracks::from_table(text, format).expect("a recording");
        assert_eq!((tracks.form, tracks.form.unit()), (form, Some("pixels")));
        assert_eq!((tracks.ids, tracks.positions, tracks.step), (plain.ids.clone(), plain.positions.clone(), 0.5));
    }
    let error = |text: &str, format: &Format| Tracks::from_table(text, format).expect_err("refused").to_string();
    assert!(error(trackpy, &none).contains("how many frames there are in a second"));
    assert!(error("identity,x_pos,y_pos\n0,1,2\n", &none).contains("no column `timestamp`"));
    // Named columns come first.
    let named = Format::new(&["frame=t", "particle=id"], Some(2.0)).expect("a format");
    assert_eq!(Tracks::from_table(trackpy, &named).map(|tracks| tracks.form), Ok(Form::Rows));
    // Named after frames and without their rate: refused, unless it holds other numbers.
    let seconds = Format::new(&["frame=t", "particle=id"], None).expect("a format");
    assert!(error(trackpy, &seconds).contains("`frame` and holds whole numbers"));
    let fractions = "frame,particle,x,y\n0.5,a,0,0\n0.5,b,1,0\n1.0,a,0,1\n1.0,b,1,1\n1.5,a,0,2\n1.5,b,1,2\n";
    assert_eq!(Tracks::from_table(fractions, &seconds).map(|tracks| tracks.step), Ok(0.5));
}

/// What idtracker.ai writes beside a table; what is no length is none.
#[test]
fn attributes_beside_a_table() {
    let length = |text| Attributes::read(text).and_then(|said| said.body_length);
    assert_eq!(length(r#"{"body_length": 7.5, "length_unit": null}"#), Some(7.5));
    for none in ["", "[7.5]", r#"{"body_length": null}"#, r#"{"body_length": 0}"#, r#"{"body_length": -1}"#, "{"] {
        assert_eq!(length(none), None, "{none}");
    }
    assert_eq!(Attributes::file(Form::Tidy), Some("attributes_tidy.json"));
    assert_eq!(Attributes::file(Form::Rows), None);
}
