//! Schools made by a rule: the analysis finds what was put in.

use super::measures::setting;
use arithmetic::Unwatched;
use models::tracks::{
    Analysis, BridgeShape, Choices, NullModels, School, Tracks, analyse, null_models, synthetic_school,
};
use motion::Share;

fn analysed(school: School, fish: usize, frames: usize) -> Analysis {
    // Through the table, as a user would.
    let text = synthetic_school(school, &setting(fish, frames)).to_csv();
    let tracks = Tracks::from_csv(&text).expect("a recording");
    analyse(&tracks, &Choices::of_sidebar(tracks.step), &Unwatched).expect("analysed")
}

fn compared(analysis: &Analysis, shifts: usize) -> NullModels {
    null_models(&analysis.sample(), shifts, "test", &Unwatched).expect("to its end")
}

#[test]
fn a_polarised_school_is_found_polarised() {
    let analysis = analysed(School::Polarised, 8, 600);
    assert_eq!(analysis.left_out.used, 600 - 52);
    let order = analysis.mean(|g| g.order[0]);
    assert!(order > 0.99, "{order}");
    // |p_2| is half of a mean of phasors.
    assert!((analysis.mean(|g| g.order[1]) - 0.5).abs() < 0.02);
    assert!(analysis.mean(|g| g.complete) < 0.1 && analysis.mean(|g| g.rotation).abs() < 0.2);
    let present = analysis.fish.iter().map(|fish| fish.zones.expect("frames")[1]).sum::<f64>() / 8.0;
    assert!(present > 0.8, "a neighbour in the zone of orientation in {present}");
}

#[test]
fn a_mill_is_found_balanced_and_turning() {
    for (school, spacing) in [(School::Milling, 1.9), (School::DiffuseMilling, 5.4)] {
        let analysis = analysed(school, 8, 1200);
        let (order, rotation) = (analysis.mean(|g| g.order[0]), analysis.mean(|g| g.rotation));
        assert!(order < 0.25 && rotation > 0.85, "|p_1| = {order}, rotation = {rotation}");
        let distance = analysis.distances().sum::<f64>() / analysis.distances().count() as f64 / 5.3;
        assert!(distance < spacing && distance > 0.5 * spacing, "{distance}");
    }
    let diffuse = analysed(School::DiffuseMilling, 8, 1200);
    let empty = diffuse.mean(|g| f64::from(g.orientation_arcs == 0));
    assert!(empty > 0.5, "zones are empty in {empty} of the frames");
}

#[test]
fn independent_headings_give_the_null_shares() {
    for (fish, share) in [(4, 0.945), (8, 0.9983)] {
        let null = compared(&analysed(School::Independent, fish, 3000), 0);
        let (low, high) = Share::new(null.uniform.positive[0], null.uniform.draws).interval();
        // The shares for positions uniform in a square, 200000 draws of an independent program: 0.9454 and 0.9984. The network of the
        // recording and the rule for n = 1 differ a little.
        assert!(low - 0.02 < share && share < high + 0.02, "[{low}, {high}] for {fish} fish");
        let per_arc = null.uniform.positive[2] as f64 / null.uniform.draws as f64;
        assert!((per_arc - 0.49).abs() < 0.04, "{per_arc}");
    }
}

#[test]
fn fish_alone_look_like_their_shifted_tracks_and_coupled_fish_do_not() {
    let alone = compared(&analysed(School::Independent, 6, 3000), 99);
    let coupled = compared(&analysed(School::Coupled, 6, 3000), 99);
    for (_, comparisons, _) in &alone.shifted {
        let c = comparisons[5].expect("a comparison");
        assert!(c.share_at_least > 0.02, "{c:?}");
    }
    for (_, comparisons, _) in &coupled.shifted {
        let order = comparisons[6].expect("a comparison");
        assert!(order.share_at_least <= 0.02, "{order:?}");
    }
    // What the sidebar looks at is the same for both.
    assert!(alone.observed.positive[0] > 0.9, "{:?}", alone.observed);
}

#[test]
fn planted_gaps_are_reported_and_left_out() {
    let whole = synthetic_school(School::Polarised, &setting(4, 400)).to_csv();
    // Fish 3 is away from t = 20 to t = 20.9.
    let missing = |line: &&str| {
        let mut fields = line.split(',');
        let t: f64 = fields.next().and_then(|t| t.parse().ok()).unwrap_or(-1.0);
        !((20.0..20.95).contains(&t) && fields.next() == Some("3"))
    };
    let text: String = whole.lines().filter(missing).map(|line| format!("{line}\n")).collect();
    let tracks = Tracks::from_csv(&text).expect("a recording");
    let analysis = analyse(&tracks, &Choices::of_sidebar(tracks.step), &Unwatched).expect("analysed");
    let [gap] = analysis.gaps.as_slice() else { panic!("{:?}", analysis.gaps) };
    assert_eq!((gap.fish, gap.from, gap.to, gap.frames), (2, 20.0, 20.9, 10));
    // The window of 51 frames and the difference take 26 frames at each end and on each side of the gap.
    let left = analysis.left_out;
    assert_eq!((left.missing, left.window, left.still, left.used), (10, 4 * 26, 0, 400 - 10 - 4 * 26));
    // The distances of the other fish are not known either: the missing one may be the nearest.
    let unknown = |frame: &&models::tracks::FrameMeasures| frame.distances.iter().all(Option::is_none);
    assert_eq!(analysis.frames.iter().filter(unknown).count(), 10);
    assert_eq!(analysis.motion.velocities[0].iter().flatten().count(), 400 - 52);
    of_those_that_are_there(&tracks);
    // A bridge of ten frames on the straight line, and none of nine.
    assert_eq!(tracks.clone().bridge(9, BridgeShape::Line), tracks);
    let bridged = tracks.clone().bridge(10, BridgeShape::Line);
    assert_eq!((&bridged.bridged[..], bridged.on_bridges().iter().sum::<usize>()), (std::slice::from_ref(gap), 10));
    let place = |i: usize| bridged.positions[2][i].clone().expect("a position");
    let (a, b) = (place(199), place(210));
    for i in 200..210 {
        let share = (i - 199) as f64 / 11.0;
        let (x, y) = (a.re + share * (b.re - a.re), a.im + share * (b.im - a.im));
        assert!((place(i).re - x).hypot(place(i).im - y) < 1e-12, "{i}");
    }
    let analysis = analyse(&bridged, &Choices::of_sidebar(bridged.step), &Unwatched).expect("analysed");
    assert_eq!((analysis.gaps.len(), analysis.left_out.used, analysis.whole_frames()), (0, 400 - 52, 400 - 52));
    // Places on a bridge are not seen.
    assert_eq!((analysis.fish[2].seen, analysis.fish[2].missing), (390, (10, 1)));
    let double = format!("{text}20,1,0,0\n");
    assert!(
        Tracks::from_csv(&double).expect_err("a duplicate").to_string().contains("fish 1 at t = 20 is there twice")
    );
}

/// Fish 3 of four is away for a while: with three fish at least, each frame has what a recording of those that have a heading has.
fn of_those_that_are_there(tracks: &Tracks) {
    let choices = |min_fish| Choices { min_fish, ..Choices::of_sidebar(tracks.step) };
    let analysis = analyse(tracks, &choices(Some(3)), &Unwatched).expect("analysed");
    let left = analysis.left_out;
    assert_eq!((left.missing, left.window, left.used, left.members), (0, 52, 348, 3 * 348 + 286));
    assert_eq!(analysis.whole_frames(), analysis.sample().frames());
    let others = tracks.only(&["1", "2", "4"].map(str::to_string)).expect("fish");
    let others = analyse(&others, &choices(None), &Unwatched).expect("analysed");
    let all = analyse(tracks, &choices(None), &Unwatched).expect("analysed");
    let mut three = 0;
    for (i, frame) in analysis.frames.iter().enumerate() {
        let Some(group) = &frame.group else { continue };
        let twin = if group.members.len() == 4 { &all } else { &others };
        three += usize::from(group.members == [0, 1, 3]);
        let twin = twin.frames[i].group.as_ref().expect("a group");
        let numbers = |g: &models::tracks::GroupState| {
            ([g.order[0], g.order[1], g.momentum, g.rotation, g.single, g.complete, g.orientation], g.partners.clone())
        };
        assert_eq!(numbers(group), numbers(twin), "{i}");
    }
    assert_eq!(three, 348 - 286);
    // Null models need frames with all fish: there are some, and none where one fish was seen once only.
    assert!(analysis.null_models(0, "x", &Unwatched).expect("to its end").is_some());
    let mut once = tracks.clone();
    once.positions[2].iter_mut().skip(1).for_each(|place| *place = None);
    let without = analyse(&once, &choices(Some(3)), &Unwatched).expect("analysed");
    assert_eq!(without.whole_frames(), 0);
    assert!(without.null_models(0, "x", &Unwatched).expect("to its end").is_none());
    let refused = |least| analyse(tracks, &choices(Some(least)), &Unwatched).expect_err("refused").to_string();
    assert!(refused(1).contains("between 2 and 4") && refused(5).contains("at least 5 fish"));
}

#[test]
fn the_same_seed_gives_the_same_numbers() {
    let of = |seed: &str| {
        let setting = models::tracks::Setting { seed: seed.to_string(), ..setting(4, 300) };
        synthetic_school(School::Coupled, &setting).to_csv()
    };
    assert_eq!(of("a"), of("a"));
    assert_ne!(of("a"), of("b"));
    let analysis = analysed(School::Coupled, 4, 300);
    let (first, second) = (compared(&analysis, 9), compared(&analysis, 9));
    assert_eq!(format!("{first:?}"), format!("{second:?}"));
}
