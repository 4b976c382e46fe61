//! Figures S2 and S3 of Paley and others, the analysis of fish data, on synthetic schools: the measured tracks are not
//! published. Figure S1 is a photograph.

use super::{Reproduced, csv};
use crate::plot::Picture;
use crate::tracks::{Known, TracksReport, difference_panel, potential_panel, scaled_panel, snapshot_panel};
use arithmetic::Unwatched;
use ledger::CheckError;
use models::tracks::{Analysis, Choices, NullModels, School, Setting, Tracks, analyse, null_models, synthetic_school};
use motion::Share;
use std::fmt::Write;

/// Ten minutes, as in the paper; the frame step is chosen.
const FRAMES: usize = 6000;
const STEP: f64 = 0.1;
const BODY_LENGTH: f64 = 5.3;
/// Shifts of each kind.
const SHIFTS: usize = 39;

/// The three experiments of the paper and what stands for them, and schools without interaction of the same sizes.
const SCHOOLS: [(&str, School, usize); 3] = [
    ("a) four fish, coupled", School::Coupled, 4),
    ("b) eight fish, tight mill", School::Milling, 8),
    ("c) eight fish, diffuse mill", School::DiffuseMilling, 8),
];
const ALONE: (&str, School, usize) = ("d) eight fish, independent", School::Independent, 8);

const DECLARATION: &str = "\
SYNTHETIC SCHOOLS: the measured tracks of the paper are not published, so these
figures show the analysis, not the data. Ten minutes in steps of 0.1 s (chosen),
b = 5.3 cm, speed 2 b/s (chosen); velocities averaged over 51 frames (5.1 s; the
paper: 5 s); zones 1.4 b to 2.4 b, blind spot 60 degrees; n = 1: the second
nearest where the nearest is within 1.4 b. Schools: a) the fish model (26), (27)
with noise in a tank of 1 m; b), c) mills of radius 2.5 b and 7 b, where each
fish circles by itself, with noise. (Figure S1 is a photograph.)
";

/// One school with its analysis.
struct Made {
    name: &'static str,
    tracks: Tracks,
    analysis: Analysis,
    null: NullModels,
}

impl Made {
    fn new((name, school, fish): (&'static str, School, usize), shifts: usize) -> Result<Made, CheckError> {
        let seed = "flockproof".to_string();
        let setting = Setting { fish, frames: FRAMES, step: STEP, body_length: BODY_LENGTH, seed };
        let tracks = synthetic_school(school, &setting);
        let analysis = analyse(&tracks, &Choices::of_sidebar(tracks.step), &Unwatched)
            .map_err(|error| CheckError::Other(format!("{name}: {error}")))?;
        let null = null_models(&analysis.sample(), shifts, name, &Unwatched)
            .map_err(|stopped| CheckError::Other(stopped.to_string()))?;
        Ok(Made { name, tracks, analysis, null })
    }

    fn report(&self) -> TracksReport<'_> {
        TracksReport {
            source: self.name,
            tracks: &self.tracks,
            analysis: &self.analysis,
            null: Some(&self.null),
            delays: None,
            snapshot_at: None,
            known: Known::of_sidebar(),
        }
    }
}

/// Figure S2.
pub(super) fn snapshots() -> Result<Reproduced, CheckError> {
    let mut picture =
        Picture::new("Figure S2 on SYNTHETIC schools (the measured tracks are not published)").grid(3, (350.0, 370.0));
    let mut text = format!("{DECLARATION}\n  school                       empty zones of orientation   mean |p_1|\n");
    let mut rows = Vec::new();
    for school in SCHOOLS {
        let made = Made::new(school, 0)?;
        let report = made.report();
        picture = picture.panel(snapshot_panel(&report, made.name));
        let zones = made.analysis.frames.iter().flat_map(|frame| frame.zones.iter().flatten());
        let (empty, all) =
            zones.fold((0usize, 0usize), |(empty, all), zones| (empty + usize::from(!zones[1]), all + 1));
        let share = empty as f64 / all as f64;
        let order = made.analysis.mean(|g| g.order[0]);
        // Writing to a string cannot fail.
        let _ = writeln!(text, "  {:28} {share:>15.3} {order:>23.3}", made.name);
        rows.push([made.name.to_string(), format!("{share:.6}"), format!("{order:.6}")]);
    }
    text.push_str(
        "\nThe text says that zones of diffuse mills are mostly empty, so that W_1 on them\nis small without any synchronisation.\n",
    );
    Ok(Reproduced::new(text).table("", csv("school,share_of_empty_zones,order", rows)).picture("", picture))
}

/// Figure S3.
pub(super) fn potentials() -> Result<Reproduced, CheckError> {
    let mut picture = Picture::new(
        "Figure S3 on SYNTHETIC schools (the measured tracks are not published), with schools without interaction beside them",
    )
    .grid(3, (350.0, 280.0));
    let mut text = format!(
        "{DECLARATION}Added: d) eight fish that swim independently. Null models: independent uniform\n\
         headings; headings shifted in time ({SHIFTS} circular shifts).\n\n\
         Share of frames in which 2/(n+1) W_1 is larger for n = N-1 than for n = 1, and\n\
         the mean of W_1/n for n = N-1 less n = 1 (above 0: neighbours more in step):\n\n\
         \x20                             share > 0  indep. uniform [95%]  shifted  W_1/n\n"
    );
    let mut rows = Vec::new();
    for school in SCHOOLS.into_iter().chain([ALONE]) {
        let made = Made::new(school, SHIFTS)?;
        let report = made.report();
        picture = picture
            .panel(potential_panel(&report, made.name))
            .panel(scaled_panel(&report, "histograms"))
            .panel(difference_panel(&report, "difference"));
        let (low, high) = Share::new(made.null.uniform.positive[0], made.null.uniform.draws).interval();
        let observed = &made.null.observed;
        let shifted =
            made.null.shifted.first().and_then(|(_, comparisons, _)| comparisons[0]).map_or(f64::NAN, |c| c.mean);
        let _ = writeln!(
            text,
            "  {:28} {:>8.3}      [{low:.4}, {high:.4}]  {shifted:>7.3} {:>7.3}",
            made.name, observed.positive[0], observed.difference[2]
        );
        for (kind, histogram) in [("recording", Some(&observed.histogram))]
            .into_iter()
            .chain([("independent", Some(&made.null.uniform.histograms[2]))])
            .chain([("headings shifted", made.null.shifted.first().map(|(_, _, histogram)| histogram))])
        {
            rows.extend(histogram.into_iter().flat_map(|histogram| histogram.bins()).map(|(from, to, _, share)| {
                [
                    made.name.to_string(),
                    kind.to_string(),
                    format!("{from:.3}"),
                    format!("{to:.3}"),
                    format!("{share:.6}"),
                ]
            }));
        }
    }
    text.push_str(
        "\nThe paper takes a difference that is nearly always positive as evidence for\n\
         local synchronisation. Schools without any interaction have it too (b, c, d and\n\
         both null models), and more often than the coupled school a: see\n\
         paley.figS3.difference. In pairs of mutual neighbours it is never negative,\n\
         whatever the headings.\n",
    );
    Ok(Reproduced::new(text).table("", csv("school,what,from,to,share", rows)).picture("", picture))
}
