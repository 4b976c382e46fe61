//! Measures against naive twins.

use arithmetic::random::{generator, uniform};
use arithmetic::{Cancelled, Complex, Progress, Unwatched};
use models::oscillator::{Neighbours, phase_potential};
use models::tracks::{
    Choices, ChoicesError, Histogram, Motion, NearestRule, NullKind, Scale, School, Setting, Smoothing, Statistics,
    Tracks, Vector, analyse, complete_potential, gaps, nearest_neighbour, null_models, partner_potential, smoothed,
    synthetic_school,
};
use std::collections::HashMap;
use std::sync::atomic::{AtomicUsize, Ordering};

pub fn setting(fish: usize, frames: usize) -> Setting {
    Setting { fish, frames, step: 0.1, body_length: 5.3, seed: "test".to_string() }
}

/// A school with rows taken out at random, through its table.
fn holed(school: School, fish: usize, frames: usize, left_out: f64) -> Tracks {
    let mut random = generator("test", "holes", fish as u64);
    let whole = synthetic_school(school, &setting(fish, frames)).to_csv();
    let mut lines = whole.lines();
    let mut text = format!("{}\n", lines.next().expect("a header"));
    for line in lines.filter(|_| uniform(&mut random) >= left_out) {
        text.push_str(&format!("{line}\n"));
    }
    Tracks::from_csv(&text).expect("still a recording")
}

/// The mean over the window of central differences, by frame number.
fn naive_velocity(tracks: &Tracks, fish: usize, number: u64, window: usize) -> Option<Vector> {
    let by_number: HashMap<u64, &Vector> =
        tracks.frames.iter().zip(&tracks.positions[fish]).filter_map(|(f, r)| Some((f.number, r.as_ref()?))).collect();
    let half = (window / 2) as u64;
    let at = |n: u64| by_number.get(&n).copied();
    let mut sum = Complex::new(0.0, 0.0);
    for n in number.checked_sub(half)?..=number + half {
        at(n)?;
        sum = sum + (at(n + 1)?.clone() - at(n.checked_sub(1)?)?).scale(&(0.5 / tracks.step));
    }
    Some(sum.scale(&(1.0 / window as f64)))
}

#[test]
fn velocities_are_means_of_central_differences_inside_a_run() {
    let tracks = holed(School::Independent, 3, 300, 0.02);
    for window in [1, 3, 11, 51] {
        let motion = Motion::new(&tracks, Smoothing::Mean, window, 0.0);
        let mut found = 0;
        for fish in 0..3 {
            for (i, frame) in tracks.frames.iter().enumerate() {
                let (ours, naive) = (&motion.velocities[fish][i], naive_velocity(&tracks, fish, frame.number, window));
                match (ours, naive) {
                    (None, None) => {}
                    (Some(a), Some(b)) => {
                        found += 1;
                        // Sums of some dozen positions below 100 over a time of 0.1.
                        assert!((a.clone() - &b).norm_squared().sqrt() < 1e-10, "{a:?} {b:?}");
                    }
                    other => panic!("window {window}, fish {fish}, frame {}: {other:?}", frame.number),
                }
            }
        }
        assert!(found > 0, "no velocity with a window of {window}");
    }
}

/// Momentum and rotation from the velocities, and what is counted where a fish is missing.
#[test]
fn frames_are_measured_as_defined() {
    let tracks = synthetic_school(School::Milling, &setting(5, 200));
    let choices = Choices { window: 5, ..Choices::of_sidebar(0.1) };
    let analysis = analyse(&tracks, &choices, &Unwatched).expect("analysed");
    let motion = Motion::new(&tracks, Smoothing::Mean, 5, choices.still);
    let mean =
        |list: &[Vector]| list.iter().fold(Complex::new(0.0, 0.0), |a, b| a + b).scale(&(1.0 / list.len() as f64));
    let mut compared = 0;
    for (i, frame) in analysis.frames.iter().enumerate() {
        let Some(group) = &frame.group else { continue };
        let places: Vec<Vector> = (0..5).map(|k| tracks.positions[k][i].clone().expect("seen")).collect();
        let velocities: Vec<Vector> = (0..5).map(|k| motion.velocities[k][i].clone().expect("moves")).collect();
        let centre = mean(&places);
        let turn = |(r, v): (&Vector, &Vector)| {
            let arm = r.clone() - &centre;
            (arm.re * v.im - arm.im * v.re) / (arm.norm_squared() * v.norm_squared()).sqrt()
        };
        let rotation = places.iter().zip(&velocities).map(turn).sum::<f64>() / 5.0;
        assert!((group.momentum - mean(&velocities).norm_squared().sqrt()).abs() < 1e-9);
        assert!((group.rotation - rotation).abs() < 1e-9);
        compared += 1;
    }
    assert!(compared > 100);
    let holed = analyse(&holed(School::Polarised, 3, 300, 0.02), &choices, &Unwatched).expect("analysed");
    assert!(holed.frames.iter().any(|frame| frame.seen == 3 && frame.moving < 3));
    assert!(holed.frames.iter().all(|frame| frame.moving <= frame.seen && frame.headed <= frame.moving));
}

/// Three fish that drift together, the middle one at their centre, where it counts as 0.
#[test]
fn a_fish_at_the_centre_does_not_turn() {
    let mut text = String::from("t,id,x,y\n");
    for i in 0..9 {
        let (x, y) = (f64::from(i), f64::from(i) / 8.0);
        text.push_str(&format!("{i},a,{},{y}\n{i},b,{x},0\n{i},c,{},{}\n", x + 0.25, x - 0.25, -y));
    }
    let tracks = Tracks::from_csv(&text).expect("a recording");
    let analysis = analyse(&tracks, &Choices { window: 1, ..Choices::of_sidebar(1.0) }, &Unwatched).expect("analysed");
    let naive = |time: f64| 0.5 / 8.0 / (65f64 / 64.0 * (1.0 / 16.0 + (time / 8.0).powi(2))).sqrt() / 3.0;
    let found: Vec<(f64, f64)> = analysis.groups().map(|(time, g)| (time, g.rotation)).collect();
    assert!(found.len() >= 5 && found.iter().all(|(time, x)| (x - naive(*time)).abs() < 1e-12), "{found:?}");
}

/// Stops the work when it has been asked so many times.
pub struct Asked(pub AtomicUsize);

impl Progress for Asked {
    fn is_cancelled(&self) -> bool {
        self.0.fetch_update(Ordering::Relaxed, Ordering::Relaxed, |left| left.checked_sub(1)).is_err()
    }
}

#[test]
fn what_was_reached_of_an_analysis_is_that_of_the_first_frames() {
    let tracks = holed(School::Polarised, 3, 300, 0.02);
    let choices = Choices { window: 5, ..Choices::of_sidebar(0.1) };
    let whole = analyse(&tracks, &choices, &Unwatched).expect("analysed");
    // Once before the work, and once for each frame.
    for asked in [0, 1, 2] {
        let stopped = analyse(&tracks, &choices, &Asked(AtomicUsize::new(asked)));
        assert_eq!(stopped.expect_err("no headings in the first frame"), ChoicesError::Cancelled(Cancelled));
    }
    for frames in [40, tracks.frames.len() - 1, tracks.frames.len()] {
        let reached = analyse(&tracks, &choices, &Asked(AtomicUsize::new(1 + frames))).expect("analysed");
        let first = tracks.first(frames);
        assert_eq!(reached.frames, whole.frames[..frames]);
        assert_eq!(reached.gaps, gaps(&first));
        let counts = reached.left_out;
        assert_eq!(counts.recorded, first.recorded_frames());
        assert_eq!(counts.recorded, counts.missing + counts.window + counts.still + counts.used);
        let rows = reached.positions.iter().chain(&reached.motion.velocities).chain(&reached.motion.headings);
        assert!(rows.into_iter().all(|row| row.len() == frames));
        let seen: Vec<u64> = first.positions.iter().map(|row| row.iter().flatten().count() as u64).collect();
        assert_eq!(reached.fish.iter().map(|fish| fish.seen).collect::<Vec<_>>(), seen);
    }
}

#[test]
fn a_window_as_long_as_the_recording_leaves_nothing_and_says_so() {
    let tracks = synthetic_school(School::Polarised, &setting(4, 60));
    assert_eq!(smoothed(&tracks, 0, Smoothing::Mean, 61).0.iter().flatten().count(), 0);
    assert_eq!(smoothed(&tracks, 0, Smoothing::Mean, 59).0.iter().flatten().count(), 2);
    let choices = Choices { window: 59, ..Choices::of_sidebar(0.1) };
    let error = analyse(&tracks, &choices, &Unwatched).expect_err("no velocity").to_string();
    assert!(error.contains("no frame has a heading of all 4 fish") && error.contains("--window"), "{error}");
    assert!(analyse(&tracks, &Choices { window: 57, ..choices }, &Unwatched).is_ok());
}

#[test]
fn the_default_window_is_the_odd_one_closest_to_five_seconds() {
    for (step, window) in [(0.1, 51), (1.0 / 30.0, 151), (1.0, 5), (5.0, 1), (100.0, 1), (2.0, 3), (0.04, 125)] {
        assert_eq!(Choices::of_sidebar(step).window, window, "{step}");
    }
}

#[test]
fn a_fish_at_rest_has_no_heading() {
    let mut text = String::from("t,id,x,y\n");
    for i in 0..9 {
        text.push_str(&format!("{i},moves,{i},0\n{i},rests,0.1,0.7\n{i},starts,{},3\n", (i - 4).max(0)));
    }
    let tracks = Tracks::from_csv(&text).expect("a recording");
    let analysis = analyse(&tracks, &Choices { window: 1, ..Choices::of_sidebar(1.0) }, &Unwatched);
    let Err(ChoicesError::NothingLeft(why)) = analysis else { panic!("used {analysis:?}") };
    assert!(why.contains("at rest in 7"), "{why}");
    let two = tracks.only(&["moves".into(), "starts".into()]).expect("two fish");
    let choices = Choices { window: 1, ..Choices::of_sidebar(1.0) };
    let analysis = analyse(&two, &choices, &Unwatched).expect("analysed");
    let left = analysis.left_out;
    assert_eq!((left.recorded, left.missing, left.window, left.still, left.used), (9, 0, 2, 3, 4));
    assert_eq!((analysis.fish[0].still, analysis.fish[1].still), (0, 3));
    assert!(analysis.groups().all(|(_, g)| (g.order[0] - 1.0).abs() < 1e-12 && g.momentum > 0.7));
    // Half a unit per frame is rest if one says so.
    let slower = analyse(&two, &Choices { still: 0.5, ..choices }, &Unwatched).expect("analysed");
    assert_eq!(slower.left_out.still, 4);
}

#[test]
fn neighbours_and_potentials_agree_with_the_general_ones() {
    let mut random = generator("test", "twin", 0);
    for case in 0..200 {
        let fish = 2 + case % 7;
        // On a small lattice distances tie; off it they do not.
        let coordinate = |random: &mut _| if case % 2 == 0 { uniform(random) } else { (4.0 * uniform(random)).floor() };
        let positions: Vec<Vector> =
            (0..fish).map(|_| Complex::new(coordinate(&mut random), coordinate(&mut random))).collect();
        let headings: Vec<Vector> = (0..fish)
            .map(|_| {
                let (s, c) = (std::f64::consts::TAU * uniform(&mut random)).sin_cos();
                Complex::new(c, s)
            })
            .collect();
        let (first, two) = (Neighbours::nearest(&positions, 1), Neighbours::nearest(&positions, 2));
        let partners: Vec<usize> = (0..fish).map(|k| nearest_neighbour(&positions, k, None)).collect();
        for (k, &j) in partners.iter().enumerate() {
            assert_eq!(first.of_particle(k), [j]);
            let distance = (positions[j].clone() - &positions[k]).norm_squared().sqrt();
            let second = two.of_particle(k).iter().copied().find(|&i| i != j).unwrap_or(j);
            assert_eq!(nearest_neighbour(&positions, k, Some(distance * (1.0 + 1e-9))), second);
            if distance > 0.0 {
                assert_eq!(nearest_neighbour(&positions, k, Some(distance * (1.0 - 1e-9))), j);
            }
        }
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-12, "{a} {b}");
        near(partner_potential(&partners, &headings), phase_potential(&first, &headings, 1).expect("fish"));
        let all = Neighbours::complete(fish);
        near(complete_potential(&headings), phase_potential(&all, &headings, 1).expect("fish"));
    }
}

#[test]
fn the_three_scales_are_those_of_the_paper() {
    assert_eq!(Scale::ALL.map(|scale| scale.ratio(3)), [(2, 4), (5, 3), (1, 3)]);
    // Independent headings: W_1 has the mean n/2, so the difference has the mean 1/2 - 1/N, (N - 2)/2, 0.
    let means = Scale::ALL.map(|scale| scale.difference(8, 3.5, 0.5));
    assert!(means.iter().zip([0.375, 3.0, 0.0]).all(|(a, b)| (a - b).abs() < 1e-15), "{means:?}");
}

#[test]
fn mutual_pairs_never_have_a_negative_difference() {
    let mut random = generator("test", "pairs", 0);
    let partners: Vec<usize> = (0..8).map(|k| k ^ 1).collect();
    for _ in 0..2000 {
        let (complete, single) = models::tracks::uniform_draw(&partners, &mut random);
        assert!(Scale::Figure.difference(8, complete, single) > -1e-12);
    }
}

#[test]
fn no_shift_changes_nothing_and_a_common_shift_of_tracks_neither() {
    let tracks = synthetic_school(School::Coupled, &setting(5, 400));
    let analysis = analyse(&tracks, &Choices::of_sidebar(0.1), &Unwatched).expect("analysed");
    let sample = analysis.sample();
    let observed = sample.statistics(NullKind::Headings, &[0; 5]);
    assert_eq!(observed, sample.statistics(NullKind::Tracks, &[0; 5]));
    let shifted = sample.statistics(NullKind::Tracks, &[17; 5]);
    for (a, b) in observed.values().iter().zip(shifted.values()) {
        assert!((a.expect("a number") - b.expect("a number")).abs() < 1e-12);
    }
    // The naive sums over the frames.
    let difference = analysis.mean(|g| Scale::Figure.difference(5, g.complete, g.single));
    assert!((difference - observed.difference[0]).abs() < 1e-12);
    let arcs = analysis.mean(|g| g.orientation_arcs as f64);
    let cosine = 1.0 - analysis.mean(|g| g.orientation) * 10.0 / arcs;
    assert!((cosine - observed.zone_alignment.expect("arcs")).abs() < 1e-12);
    assert!((analysis.mean(|g| g.rotation.abs()) - observed.rotation).abs() < 1e-12);
    // All frames have all fish, and all those have a heading but at the ends.
    let mean = |values: Vec<f64>| values.iter().sum::<f64>() / values.len() as f64;
    let used = analysis.frames.iter().filter(|frame| frame.group.is_some());
    let nearest = mean(used.filter_map(|frame| frame.mean_distance()).collect());
    assert!((nearest - observed.nearest).abs() < 1e-12);
    // Distances are those of the file under shifted headings, and are not compared; one shifted fish is elsewhere.
    let null = null_models(&sample, 3, "x", &Unwatched).expect("to its end");
    let place = Statistics::NAMES.iter().position(|name| *name == "nearest_distance").expect("a name");
    assert!(null.shifted[0].1[place].is_none());
    let tracks = null.shifted[1].1[place].expect("compared");
    assert!(tracks.mean != tracks.observed && tracks.share_at_least + tracks.share_at_most >= 1.0);
    assert_eq!(null_models(&sample, 0, "x", &Unwatched).expect("to its end").shifted.len(), 0);
}

#[test]
fn choices_that_make_no_sense_are_refused() {
    let good = Choices::of_sidebar(0.1);
    assert_eq!(good.check(4), Ok(()));
    let bad = |choices: Choices, said: &str| {
        let error = choices.check(4).expect_err(said).to_string();
        assert!(error.contains(said), "{error}");
    };
    bad(Choices { window: 10, ..good.clone() }, "10 frames has no middle");
    bad(Choices { window: 0, ..good.clone() }, "0 frames");
    bad(Choices { body_length: -1.0, ..good.clone() }, "body length -1");
    bad(Choices { body_length: f64::NAN, ..good.clone() }, "body length NaN");
    bad(Choices { zones: [2.4, 1.4, 9.0], ..good.clone() }, "growing radii");
    bad(Choices { zones: [1.4, f64::NAN, 9.0], ..good.clone() }, "growing radii");
    bad(Choices { zones: [0.0, 1.4, 9.0], ..good.clone() }, "growing radii");
    bad(Choices { blind: 181.0, ..good.clone() }, "blind spot");
    bad(Choices { still: -0.1, ..good.clone() }, "at rest");
    bad(Choices { nearest: vec![2, 4], ..good.clone() }, "between 1 and 3");
    bad(Choices { nearest: vec![0], ..good }, "not 0");
}

#[test]
fn others_are_reported_for_the_asked_numbers_of_neighbours() {
    let tracks = synthetic_school(School::Milling, &setting(6, 120));
    let choices = Choices { nearest: vec![1, 5], rule: NearestRule::Nearest, window: 5, ..Choices::of_sidebar(0.1) };
    let analysis = analyse(&tracks, &choices, &Unwatched).expect("analysed");
    for (_, g) in analysis.groups() {
        assert!((g.others[0] - g.single).abs() < 1e-12 && (g.others[1] - g.complete).abs() < 1e-12);
    }
}

#[test]
fn histograms_count_everything() {
    let histogram = Histogram::of(0.0, 1.0, 4, [0.0, 0.25, 0.5, 1.0, 1.0 + 1e-15, -1e-16, 2.0, -1.0]);
    assert_eq!((histogram.counts.clone(), histogram.outside), (vec![2, 1, 1, 2], (1, 1)));
    assert_eq!(histogram.total(), 8);
}

#[test]
fn what_is_no_number_is_not_counted() {
    let values = [0.25, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    let histogram = Histogram::of(0.0, 1.0, 2, values);
    assert_eq!((histogram.counts.clone(), histogram.outside, histogram.total()), (vec![1, 0], (1, 1), 3));
}

/// By sorting all distances; of equal ones the smaller number.
#[test]
fn nearest_neighbours_are_those_of_sorted_distances() {
    let mut random = generator("test", "nearest", 0);
    for case in 0..300 {
        // On a lattice, with many ties.
        let fish = 1 + case % 6;
        let place = |random: &mut _| (4.0 * arithmetic::random::uniform(random)).floor() + 5.0;
        let positions: Vec<Complex<f64>> =
            (0..fish).map(|_| Complex::new(place(&mut random), place(&mut random))).collect();
        for k in 0..fish {
            let mut others: Vec<(f64, usize)> = (0..fish)
                .filter(|&j| j != k)
                .map(|j| ((positions[j].clone() - &positions[k]).norm_squared(), j))
                .collect();
            others.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            let named = |place: usize| others.get(place).map_or(k, |(_, j)| *j);
            assert_eq!(nearest_neighbour(&positions, k, None), named(0), "{positions:?}");
            for radius in [0.5f64, 1.0, 2.0] {
                let near = others.first().is_some_and(|(square, _)| *square <= radius * radius) && others.len() > 1;
                assert_eq!(nearest_neighbour(&positions, k, Some(radius)), named(usize::from(near)), "{positions:?}");
            }
        }
        assert_eq!(nearest_neighbour(&positions, fish, None), fish);
    }
}

/// Recordings have public parts, which somebody may put together so that they do not fit.
#[test]
fn recordings_whose_parts_do_not_fit_are_refused() {
    let whole = synthetic_school(School::Milling, &setting(3, 9));
    let choices = Choices { window: 1, ..Choices::of_sidebar(0.1) };
    assert!(analyse(&whole, &choices, &Unwatched).is_ok());
    let broken = |break_it: &dyn Fn(&mut Tracks)| {
        let mut tracks = whole.clone();
        break_it(&mut tracks);
        tracks
    };
    let cases = [
        broken(&|tracks| tracks.positions[1].truncate(4)),
        broken(&|tracks| drop(tracks.positions.pop())),
        broken(&|tracks| tracks.positions.push(Vec::new())),
        broken(&|tracks| tracks.frames.truncate(5)),
        broken(&|tracks| tracks.frames.reverse()),
        broken(&|tracks| tracks.frames[8].number = u64::MAX),
    ];
    for (place, tracks) in cases.iter().enumerate() {
        let error = ChoicesError::Recording { fish: 3, frames: tracks.frames.len() };
        // A gap is no fault of a recording.
        assert_eq!(analyse(tracks, &choices, &Unwatched).err(), (place < 5).then_some(error), "{place}");
        Motion::new(tracks, Smoothing::Mean, 3, 0.0);
        assert!(tracks.to_csv().starts_with("t,id,x,y\n") && tracks.recorded_frames() > 0);
        assert!(tracks.only(&["1".into(), "3".into()]).is_ok());
    }
    let error = Choices { nearest: vec![1], ..choices }.check(0).expect_err("no fish");
    assert_eq!(error.to_string(), "0 fish have between 1 and 0 neighbours, not 1");
}
