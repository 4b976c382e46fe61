//! The analysis as a text of at most 80 columns.

use super::{Known, TracksReport, tables};
use models::tracks::{Choices, Comparison, Delays, Form, NearestRule, NullModels, PositionsUsed, Scale, Smoothing};
use motion::Share;
use std::fmt::Write;

const WIDTH: usize = 80;
/// Most gaps and fish that are printed one by one.
const LISTED: usize = 12;

pub(super) fn text(report: &TracksReport) -> String {
    let mut text = String::new();
    heading(report, &mut text);
    declaration(report, &mut text);
    left_out(report, &mut text);
    each_fish(report, &mut text);
    potentials(report, &mut text);
    snapshot(report, &mut text);
    if let Some(found) = report.delays {
        delays(report, found, &mut text);
    }
    match report.null {
        Some(null) => null_models(report, null, &mut text),
        None if report.analysis.whole_frames() == 0 => {
            text.push_str("No frame has a heading of every fish: nothing is compared with null models.\n");
        }
        None => text.push_str("The null models were not reached.\n"),
    }
    text
}

/// A named paragraph.
fn paragraph(text: &mut String, name: &str, what: &str) {
    let first = format!("{name:15} ");
    let options = textwrap::Options::new(WIDTH).initial_indent(&first).subsequent_indent("                ");
    text.push_str(&textwrap::fill(what, options));
    text.push('\n');
}

/// The start of a text, of at most so many letters.
pub(super) fn cut(text: &str, length: usize) -> String {
    if text.chars().count() <= length {
        return text.to_string();
    }
    text.chars().take(length.saturating_sub(1)).chain(['…']).collect()
}

/// At most four significant digits, for numbers of any size.
fn number(x: f64) -> String {
    if x == 0.0 || (1e-3..1e6).contains(&x.abs()) {
        let digits = (3 - x.abs().max(1e-3).log10().floor() as i32).clamp(0, 6) as usize;
        let text = format!("{x:.digits$}");
        if digits == 0 { text } else { text.trim_end_matches('0').trim_end_matches('.').to_string() }
    } else {
        format!("{x:.3e}")
    }
}

/// Four decimals, without the sign of a rounded zero.
fn four(x: f64) -> String {
    format!("{:.4}", if x.abs() < 5e-5 { 0.0 } else { x })
}

fn heading(report: &TracksReport, text: &mut String) {
    let (tracks, left) = (report.tracks, report.analysis.left_out);
    let ends = [tracks.frames.first(), tracks.frames.last()].map(|frame| number(frame.map_or(0.0, |frame| frame.time)));
    // Writing to a string cannot fail, here and below.
    let _ = writeln!(text, "{}", cut(report.source, WIDTH));
    if tracks.form != Form::Rows {
        let parts = match tracks.parts.as_slice() {
            [] => String::new(),
            [one] => format!(": {one}"),
            several => format!(": the mean of {}", several.join(", ")),
        };
        let _ = writeln!(text, "{}", textwrap::fill(&format!("table: {}{parts}", tracks.form.words()), WIDTH));
    }
    if let Some(start) = &tracks.start {
        let _ = writeln!(text, "t = 0 is {start}");
    }
    let (fish, step, [from, to]) = (tracks.fish(), number(tracks.step), ends);
    let _ = writeln!(text, "{fish} fish, {} frames of {step} s from t = {from} to {to}", left.recorded);
    let unit = report.known.unit.map_or(String::new(), |unit| format!("positions in {unit}; "));
    let _ = writeln!(text, "{unit}times: {}\n", report.known.times);
}

fn declaration(report: &TracksReport, text: &mut String) {
    let choices = &report.analysis.choices;
    let seconds = number(choices.window as f64 * report.tracks.step);
    let bridges = if report.tracks.bridged.is_empty() { "" } else { " that is not bridged" };
    paragraph(
        text,
        "headings",
        &format!(
            "direction of the velocity: {}; nothing crosses a gap{bridges}; at rest at a speed of at most {}",
            velocity(choices, &seconds),
            number(choices.still)
        ),
    );
    let positions = match choices.positions {
        PositionsUsed::File => "for distances and networks: as in the file",
        PositionsUsed::Smoothed => "for distances and networks: smoothed",
    };
    paragraph(text, "positions", positions);
    paragraph(text, "zones", &zones(report));
    let single = match choices.rule {
        NearestRule::SecondInRepulsion => {
            "the nearest neighbour, or the second nearest where the nearest is in the zone of repulsion"
        }
        NearestRule::Nearest => "the nearest neighbour",
    };
    paragraph(text, "n = 1", &format!("{single}; of two at one distance the first in the list"));
    text.push('\n');
}

/// Where velocities come from.
fn velocity(choices: &Choices, seconds: &str) -> String {
    let window = choices.window;
    match choices.smoothing {
        Smoothing::Mean => format!(
            "central differences of the positions averaged over {window} frames ({seconds} s), so that speeds along a curved path are below \
             those of the fish"
        ),
        Smoothing::SavitzkyGolay => {
            format!("slope of the cubic through {window} frames ({seconds} s) by least squares (Savitzky and Golay)")
        }
        Smoothing::Spline => format!(
            "slope of the smoothing spline that keeps half of an oscillation with a period of {window} frames ({seconds} s)"
        ),
    }
}

fn zones(report: &TracksReport) -> String {
    let choices = &report.analysis.choices;
    let [repulsion, orientation, attraction] = choices.zones;
    let last = if attraction.is_finite() { format!("to {attraction}") } else { "without end".to_string() };
    let whose = match (report.known.body_length, report.known.unit) {
        (Known::OF_SIDEBAR, Some(unit)) if unit != "cm" => {
            format!(" (that of the sidebar in cm, which means nothing for positions in {unit}: say the body length)")
        }
        (Known::OF_SIDEBAR, None) => {
            " (that of the sidebar in cm, while nobody says the unit of the positions: in another one say the body length)".to_string()
        }
        (Known::OF_SIDEBAR, _) => " (that of the sidebar in cm; --body-length says another)".to_string(),
        (from, _) => format!(" ({from})"),
    };
    format!(
        "repulsion to {repulsion}, orientation to {orientation}, attraction {last} body lengths of {}{whose}; \
         blind spot {} degrees",
        number(choices.body_length),
        choices.blind
    )
}

fn left_out(report: &TracksReport, text: &mut String) {
    let (tracks, analysis, left) = (report.tracks, report.analysis, report.analysis.left_out);
    let fish = tracks.fish();
    let (who, too_many) = match analysis.choices.min_fish {
        None => ("every fish".to_string(), ["a fish is", "a window meets", "a fish"]),
        Some(least) => {
            (format!("at least {least} of {fish} fish"), ["too many are", "too many windows meet", "too many"])
        }
    };
    let mut counts = format!(
        "{} of {} have a heading of {who}; left out: {} where {} missing, {} where {} a gap or an end, {} with {} at rest",
        left.used, left.recorded, left.missing, too_many[0], left.window, too_many[1], left.still, too_many[2]
    );
    if analysis.choices.min_fish.is_some() {
        let mean = left.members as f64 / left.used as f64;
        let _ = write!(counts, "; in those that are used {mean:.2} fish have one in the mean");
    }
    paragraph(text, "frames", &counts);
    bridges(report, text);
    for gap in analysis.gaps.iter().take(LISTED) {
        let what = format!(
            "fish {}: {} frames missing from t = {} to {} ({})",
            cut(&tracks.ids[gap.fish], 20),
            gap.frames,
            number(gap.from),
            number(gap.to),
            tables::place(gap.at_start, gap.at_end)
        );
        paragraph(text, "gap", &what);
    }
    if analysis.gaps.len() > LISTED {
        paragraph(text, "gaps", &format!("{} more, see gaps.csv", analysis.gaps.len() - LISTED));
    }
    text.push('\n');
}

/// What was bridged, and how much of the recording it is.
fn bridges(report: &TracksReport, text: &mut String) {
    let bridged = &report.tracks.bridged;
    if bridged.is_empty() {
        return;
    }
    let positions: u64 = bridged.iter().map(|gap| gap.frames).sum();
    let frames = report.tracks.on_bridges().iter().filter(|&&fish| fish > 0).count();
    let longest = bridged.iter().map(|gap| gap.frames).max().unwrap_or(0);
    let what = format!(
        "{} gaps, the longest of {longest} frames, {positions} positions in {frames} frames, on {}; \
         see gaps.csv and the column bridged of frames.csv",
        bridged.len(),
        report.tracks.bridged_by.words()
    );
    paragraph(text, "bridged", &what);
}

/// A sentence where what is said rests on few frames.
fn few(report: &TracksReport, used: u64) -> Option<String> {
    let recorded = report.analysis.left_out.recorded;
    report.is_few(used).then(|| format!("Few frames: this rests on {used} of {recorded}."))
}

/// Over how many frames the means of the fish go.
fn over(report: &TracksReport) -> String {
    let range = |which: usize| {
        let counts = || report.analysis.fish.iter().map(|fish| fish.over[which]);
        let (least, most) = (counts().min().unwrap_or(0), counts().max().unwrap_or(0));
        if least == most { format!("{most}") } else { format!("{least} to {most}") }
    };
    format!(
        "mean speeds go over {} frames of a fish, distances over {}, shares over {}; of each fish in fish.csv",
        range(0),
        range(1),
        range(2)
    )
}

fn each_fish(report: &TracksReport, text: &mut String) {
    text.push_str("fish         frames  at rest     speed   nearest  share with a neighbour in zone\n");
    text.push_str("                                       (b lengths)  repulsion  orient.  attract.\n");
    let shown = |x: Option<f64>| x.map_or_else(|| "-".to_string(), number);
    let b = report.analysis.choices.body_length;
    for (id, fish) in report.tracks.ids.iter().zip(&report.analysis.fish).take(LISTED) {
        let share = |z: usize| fish.zones.map_or_else(|| "-".to_string(), |zones| format!("{:.3}", zones[z]));
        let _ = writeln!(
            text,
            "{:11} {:>7} {:>8} {:>9} {:>11} {:>10} {:>8} {:>9}",
            cut(id, 11),
            fish.seen,
            fish.still,
            shown(fish.speed),
            shown(fish.distance.map(|d| d / b)),
            share(0),
            share(1),
            share(2)
        );
    }
    if report.tracks.fish() > LISTED {
        let _ = writeln!(text, "{} more, see fish.csv", report.tracks.fish() - LISTED);
    }
    paragraph(text, "frames of each", &over(report));
    text.push('\n');
}

fn potentials(report: &TracksReport, text: &mut String) {
    let analysis = report.analysis;
    let used = analysis.left_out.used;
    let whole = analysis.whole_frames() as u64;
    if let Some(few) = few(report, used) {
        let _ = writeln!(text, "{few}");
    }
    let over =
        if whole == used { format!("{used} frames") } else { format!("{used} frames, {whole} of them with all fish") };
    paragraph(text, "means", &format!("over {over}"));
    let order = format!(
        "polarisation |p_1| {:.3}, |p_2| {:.3} (at most 1/2), rotation (milling) {:.3}, momentum {}",
        analysis.mean(|g| g.order[0]),
        analysis.mean(|g| g.order[1]),
        analysis.mean(|g| g.rotation),
        number(analysis.mean(|g| g.momentum))
    );
    paragraph(text, "order (means)", &order);
    if let Some(distance) = analysis.mean_nearest() {
        let lengths = number(distance / analysis.choices.body_length);
        paragraph(
            text,
            "nearest (mean)",
            &format!("{} in the unit of the file, {lengths} body lengths", number(distance)),
        );
    }
    let arcs = analysis.mean(|g| g.orientation_arcs as f64);
    let zone = format!(
        "W_1 {:.4} on {arcs:.2} arcs of the zones of orientation (an empty zone counts as synchronised)",
        analysis.mean(|g| g.orientation)
    );
    paragraph(text, "zones (means)", &zone);
    text.push_str("\nscaled W_1 (means)    n = N-1     n = 1     all n in [0, 1]?\n");
    for scale in Scale::ALL {
        let inside = match scale {
            Scale::Figure => "n = 1, N-1 only (Figure S3)",
            Scale::Text => "no (the text)",
            Scale::PerArc => "yes; compares mean 1 - cos per arc",
        };
        let complete = analysis.mean(|g| g.complete(scale));
        let single = analysis.mean(|g| g.single(scale));
        let _ = writeln!(text, "{:18} {complete:>10.4} {single:>9.4}     {inside}", scale.name());
    }
    for (i, n) in analysis.choices.nearest.iter().enumerate() {
        let w = analysis.mean(|g| g.others[i]);
        let per_arc = Scale::PerArc.factor(*n) * w;
        let _ = writeln!(text, "{:18} {w:>10.4} {:>9} W_1/n = {per_arc:.4}", format!("W_1, n = {n}"), "");
    }
    text.push('\n');
}

/// Which frame the snapshot shows where another one was asked for.
fn snapshot(report: &TracksReport, text: &mut String) {
    let shown = report.analysis.frames[report.snapshot_frame()].time;
    if let Some(at) = report.snapshot_at.filter(|at| (shown - at).abs() > 1e-6 * report.tracks.step) {
        let what = format!("t = {} s: of the frames that are used the closest to t = {} s", number(shown), number(at));
        paragraph(text, "snapshot", &what);
        text.push('\n');
    }
}

fn delays(report: &TracksReport, delays: &Delays, text: &mut String) {
    let (tracks, step) = (report.tracks, report.tracks.step);
    let what = format!(
        "of headings, up to {} s: the lag at which the mean cosine between the heading of the first fish and that of the second one later \
         is largest; positive where the second follows. p: share of windows of lags beyond, up to half of the recording, that reach it \
         (neighbouring windows are not independent; - where there are fewer than 19, as a smaller largest delay gives more). The pairs of the \
         fish that leads most come first",
        number(delays.largest as f64 * step)
    );
    paragraph(text, "delays", &what);
    text.push_str("first        second       delay (s)    cosine   at once         p   frames\n");
    let pairs = delays.leading();
    for pair in pairs.iter().take(LISTED) {
        let [first, second] = pair.pair.map(|k| cut(&tracks.ids[k], 11));
        let shown = |x: Option<f64>| x.map_or_else(|| "-".to_string(), |x| format!("{x:.3}"));
        let _ = writeln!(
            text,
            "{first:12} {second:11} {:>10} {:>9.3} {:>9} {:>9} {:>8}",
            number(pair.frames as f64 * step),
            pair.correlation,
            shown(pair.at_once),
            shown(pair.share_at_least()),
            pair.both
        );
    }
    if pairs.len() > LISTED {
        let _ = writeln!(text, "{} more, see delays.csv", pairs.len() - LISTED);
    }
    if let Some(least) = pairs.iter().map(|pair| pair.both as u64).min()
        && let Some(few) = few(report, least)
    {
        let _ = writeln!(text, "{few} So does the lead of its fish.");
    }
    let mut fish: Vec<(f64, &String)> =
        delays.lead.iter().zip(&tracks.ids).filter_map(|(lead, id)| Some(((*lead)?, id))).collect();
    fish.sort_by(|a, b| b.0.total_cmp(&a.0));
    let order = fish.iter().take(LISTED).map(|(lead, id)| format!("{} {}", cut(id, 11), number(lead * step)));
    paragraph(text, "lead (s)", &format!("the others follow in the mean by: {}", order.collect::<Vec<_>>().join(", ")));
    text.push('\n');
}

/// The place of the distance to the nearest neighbour: small where fish keep together.
const NEAREST: usize = 9;

/// The place of the cosine in the zone of orientation, which has no value where all these zones are empty.
const ALIGNMENT: usize = 7;

/// The statistics that the text shows: their place among the names, and what they are called here.
const SHOWN: [(usize, &str); 9] = [
    (0, "share > 0, 2/(n+1)"),
    (1, "share > 0, 2/n+1"),
    (2, "share > 0, 1/n"),
    (3, "mean, 2/(n+1)"),
    (5, "mean, 1/n"),
    (ALIGNMENT, "cos in orient. zone"),
    (6, "polarisation |p_1|"),
    (8, "|rotation|"),
    (NEAREST, "nearest (b lengths)"),
];

fn null_models(report: &TracksReport, null: &NullModels, text: &mut String) {
    let fish = report.tracks.fish();
    text.push_str("Difference of the scaled potentials, n = N-1 less n = 1, beside schools without\n");
    text.push_str("interaction. p: share of shifts with at least the value of the recording; of the\n");
    text.push_str("distance to the nearest neighbour: with at most that value.\n\n");
    text.push_str("                     recording  indep.   headings shifted    tracks shifted\n");
    text.push_str("                                uniform  mean         p      mean         p\n");
    let observed = null.observed.values();
    for (place, name) in SHOWN {
        let uniform = match place {
            0..=2 => four(null.uniform.positive[place] as f64 / null.uniform.draws as f64),
            // W_1 has the mean n/2.
            3..=5 => four(Scale::ALL[place - 3].difference(fish, (fish - 1) as f64 / 2.0, 0.5)),
            ALIGNMENT => "0".to_string(),
            _ => "-".to_string(),
        };
        let unit = if place == NEAREST { report.analysis.choices.body_length } else { 1.0 };
        let seen = observed[place].map_or_else(|| "-".to_string(), |x| four(x / unit));
        let _ = write!(text, "{name:20} {seen:>9} {uniform:>8}");
        for (_, comparisons, _) in &null.shifted {
            let compared = |c: Comparison| {
                let p = if place == NEAREST { c.share_at_most } else { c.share_at_least };
                format!("{:>9} {p:>9.3}", four(c.mean / unit))
            };
            let _ = write!(text, " {:>19}", comparisons[place].map_or_else(|| "-".to_string(), compared));
        }
        text.push('\n');
    }
    text.push('\n');
    let whole = report.analysis.whole_frames() as u64;
    let mut verdict = format!("Over the {whole} frames with a heading of every fish. ");
    if let Some(few) = few(report, whole) {
        let _ = write!(verdict, "{few} ");
    }
    verdict.push_str(&reading(fish, null));
    for (kind, comparisons, _) in &null.shifted {
        let counted = comparisons[ALIGNMENT].map_or(0, |c| c.at_least.1);
        if observed[ALIGNMENT].is_some() && counted < null.shifts {
            let _ = write!(
                verdict,
                "With {} the cosine has a value in {counted} of {} shifts: in the others no fish has another in its zone of orientation. ",
                kind.name(),
                null.shifts
            );
        }
    }
    verdict.push_str(&match null.shifts {
        0 => "No shifts were made (--null 0).".to_string(),
        shifts => {
            format!("{shifts} circular time shifts of each kind; p is at least {:.4}. \
             Interaction shows in small p of |p_1|, of the cosine, of the mean with 1/n and of the distance under shifted tracks; \
             shifted headings also differ where fish only share a circulation, and rotation is large under both if they do.", 1.0 / (shifts + 1) as f64)
        }
    });
    let _ = writeln!(text, "{}", textwrap::fill(&verdict, WIDTH));
}

/// What the difference of Figure S3 says here.
fn reading(fish: usize, null: &NullModels) -> String {
    if fish == 2 {
        return "With two fish n = N-1 is n = 1 and there is no difference. ".to_string();
    }
    let (low, high) = Share::new(null.uniform.positive[0], null.uniform.draws).interval();
    let nearly_always = "so a difference that is nearly always positive is no sign of interaction";
    format!(
        "With the scale of Figure S3 independent uniform headings give a positive difference in [{low:.4}, {high:.4}] of the draws \
         (95%, {} draws; exact mean 1/2 - 1/N), {}. In {:.1}% of the frames the neighbours for n = 1 form pairs; there it is never \
         negative, whatever the headings. The scale 1/n compares neighbours with the school: mean 0 for independent headings. ",
        null.uniform.draws,
        if low > 0.9 { nearly_always } else { "with which the share of the recording has to be compared" },
        100.0 * null.in_pairs
    )
}
