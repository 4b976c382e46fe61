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
}

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

    /// The pictures; the snapshot shows the frame with all headings that is closest to `snapshot_at`.
    ///
    /// # Errors
    /// [`PictureError`].
    pub fn pictures(&self, snapshot_at: Option<f64>) -> Result<Vec<File>, PictureError> {
        let pictures = [
            ("histograms", pictures::histograms(self)),
            ("order", pictures::order(self)),
            ("potentials", pictures::potentials(self)),
            ("snapshot", pictures::snapshot(self, snapshot_at)),
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
