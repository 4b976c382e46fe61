//! The analysis of trajectories as people read it: a text with all choices, tables, a summary in JSON, pictures.

mod pictures;
mod summary;
mod tables;
mod text;

pub(super) use pictures::{difference_panel, potential_panel, scaled_panel, snapshot_panel};

use super::file::File;
use super::plot::PictureError;
use super::provenance::Provenance;
use models::tracks::{Analysis, Delays, NullModels, Tracks};

/// A recording, its analysis and the null models.
#[derive(Debug, Clone, Copy)]
pub struct TracksReport<'a> {
    /// Where the trajectories come from: a file, or the rule of a synthetic school.
    pub source: &'a str,
    /// The trajectories.
    pub tracks: &'a Tracks,
    /// What was measured.
    pub analysis: &'a Analysis,
    /// The null models; `None` before they are finished.
    pub null: Option<&'a NullModels>,
    /// Delays between headings, where they are asked for.
    pub delays: Option<&'a Delays>,
    /// Time of the snapshot in seconds; without it the middle of the frames that are used.
    pub snapshot_at: Option<f64>,
    /// Units, and where they come from.
    pub known: Known<'a>,
}

/// Units of a recording, and where its rate and its body length come from, in words.
#[derive(Debug, Clone, Copy)]
pub struct Known<'a> {
    /// The unit of the positions; none where nobody says it.
    pub unit: Option<&'a str>,
    /// Where the times come from.
    pub times: &'a str,
    /// Where the body length comes from.
    pub body_length: &'a str,
}

impl Known<'_> {
    /// Times that stand in the file.
    pub const IN_FILE: &'static str = "the file";
    /// What was chosen by whoever asks.
    pub const CHOSEN: &'static str = "chosen";
    /// A body length that nobody says.
    pub const OF_SIDEBAR: &'static str = "the sidebar's, in cm";

    /// Of a made school, or of tables whose unit is that of the sidebar.
    pub fn of_sidebar() -> Known<'static> {
        Known { unit: Some("cm"), times: Known::IN_FILE, body_length: Known::OF_SIDEBAR }
    }
}

/// Fewer frames than this, or a smaller share of the recording than [`SMALL_SHARE`], are few.
const FEW_FRAMES: u64 = 100;
const SMALL_SHARE: f64 = 0.1;

impl TracksReport<'_> {
    /// The text for the terminal, of at most 80 columns.
    pub fn text(&self) -> String {
        text::text(self)
    }

    /// `summary.json`.
    pub fn summary(&self) -> serde_json::Value {
        summary::summary(self)
    }

    /// The summary and the tables, with where they come from.
    pub fn tables(&self, provenance: &Provenance) -> Vec<File> {
        let text = |name: &str, contents: String| File { name: name.to_string(), contents: contents.into_bytes() };
        let summary = provenance.stamp(self.summary());
        let mut files = vec![
            text("summary.json", format!("{summary:#}\n")),
            text("frames.csv", tables::frames(self)),
            text("fish.csv", tables::fish(self)),
            text("gaps.csv", tables::gaps(self)),
            text("histograms.csv", tables::histograms(self)),
        ];
        files.extend(self.delays.map(|delays| text("delays.csv", tables::delays(self, delays))));
        files.push(text("about.txt", provenance.about(&files)));
        files
    }

    /// Whether so many frames are too few to rest much on.
    fn is_few(&self, frames: u64) -> bool {
        frames < FEW_FRAMES || (frames as f64) < SMALL_SHARE * self.analysis.left_out.recorded as f64
    }

    /// The number of the frame that the snapshot shows: of those that are used the one closest to the time that is asked for.
    fn snapshot_frame(&self) -> usize {
        let frames = &self.analysis.frames;
        let mut used = (0..frames.len()).filter(|&i| frames[i].group.is_some());
        let found = match self.snapshot_at {
            None => used.nth(self.analysis.left_out.used as usize / 2),
            Some(t) => used.min_by(|&i, &j| (frames[i].time - t).abs().total_cmp(&(frames[j].time - t).abs())),
        };
        found.unwrap_or(0)
    }

    /// Files of this analysis by other choices, which an earlier run may have left in the folder.
    pub const NOT_ALWAYS: [&'static str; 4] = ["delays.csv", "delays.svg", "delays.png", "tracks.csv"];

    /// The pictures.
    ///
    /// # Errors
    /// [`PictureError`].
    pub fn pictures(&self) -> Result<Vec<File>, PictureError> {
        let pictures = [
            ("histograms", pictures::histograms(self)),
            ("order", pictures::order(self)),
            ("potentials", pictures::potentials(self)),
            ("snapshot", pictures::snapshot(self)),
        ];
        let mut files = Vec::new();
        let delays = self.delays.map(|delays| ("delays", pictures::delays(self, delays)));
        for (name, picture) in pictures.into_iter().chain(delays) {
            files.push(File { name: format!("{name}.svg"), contents: picture.svg().into_bytes() });
            files.push(File { name: format!("{name}.png"), contents: picture.png()? });
        }
        Ok(files)
    }
}
