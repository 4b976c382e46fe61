//! Figures and tables of the papers. One file and one row of [`FIGURES`] each: a name, what it shows, and the function that
//! makes it. All of them are deterministic.

mod paley;
mod paley_abscissa;
mod paley_basins;
mod paley_fig1;
mod paley_fig2;
mod paley_fig3;
mod paley_fig4;
mod paley_fig5;
mod paley_fig6;
mod paley_fig7;
mod paley_fig8;
mod paley_fish_data;
mod tanner;
mod tanner1_fig2;
mod tanner1_flocking;
mod tanner2_fig4;
mod tanner2_switching;
mod tanner_equilibria;
mod tanner_rates;
mod veerman;
mod veerman_fig1;
mod veerman_fig2;
mod veerman_fig3;
mod veerman_fig4;
mod veerman_fig5;
mod veerman_observation;
mod veerman_procedures;
mod veerman_sweep;
mod veerman_table1;

use super::plot::{Picture, PictureError};
use ledger::CheckError;

/// A figure or table that can be made again.
#[derive(Debug, Clone, Copy)]
pub struct Figure {
    /// Paper and number, as in the ids of claims.
    pub name: &'static str,
    /// What it shows, one line.
    pub about: &'static str,
    make: fn() -> Result<Reproduced, CheckError>,
}

/// All figures and tables, in the order in which `reproduce all` makes them.
pub const FIGURES: &[Figure] = &[
    figure("veerman.table1", "the printed resonances beside certified ones", veerman_table1::reproduce),
    figure(
        "veerman.table1_readings",
        "by which procedure its simulated columns come out",
        veerman_procedures::reproduce,
    ),
    figure("veerman.fig1", "the response of the last car over the frequency", veerman_fig1::reproduce),
    figure("veerman.fig2", "a flock behind a periodic leader, with collision check", veerman_fig2::reproduce),
    figure("veerman.fig3", "a flock behind an abrupt leader, with collision check", veerman_fig3::reproduce),
    figure("veerman.fig4", "resonance against the number of cars", veerman_fig4::reproduce),
    figure("veerman.fig5", "differences from Theorem 1 and their regression lines", veerman_fig5::reproduce),
    figure(
        "veerman.observation_time",
        "how the measured peak converges to the certified one",
        veerman_observation::reproduce,
    ),
    figure("veerman.communication_sweep", "exploration: linear or exponential growth", veerman_sweep::reproduce),
    figure("paley.fig1", "four types of motion under the all-to-all control", paley_fig1::reproduce),
    figure("paley.fig2", "the eigenvectors of the cyclic graph as polygons", paley_fig2::reproduce),
    figure("paley.fig3", "circular formations on the cyclic graph", paley_fig3::reproduce),
    figure("paley.fig4", "the six symmetric circular formations", paley_fig4::reproduce),
    figure("paley.fig5", "a group that tracks a reference direction", paley_fig5::reproduce),
    figure("paley.fig6", "a circular formation in a drift field, with a beacon", paley_fig6::reproduce),
    figure("paley.fig7", "the perceptual zones of a fish", paley_fig7::reproduce),
    figure("paley.fig8", "circular formations for growing zones of orientation", paley_fig8::reproduce),
    figure("paley.abscissa", "enclosed rates of decay to symmetric circular formations", paley_abscissa::reproduce),
    figure("paley.basins", "exploration: which share of starts ends where", paley_basins::reproduce),
    figure("paley.figS2", "fish, headings and zones of orientation, on synthetic schools", paley_fish_data::snapshots),
    figure("paley.figS3", "scaled phase potentials and null models, on synthetic schools", paley_fish_data::potentials),
    figure("tanner1.fig2", "the potential of two agents", tanner1_fig2::reproduce),
    figure("tanner1.figs3_6", "heading alignment on the complete graph, with shares", tanner1_flocking::complete),
    figure("tanner1.figs7_10", "heading alignment on incomplete graphs, with shares", tanner1_flocking::incomplete),
    figure("tanner2.fig4", "velocity alignment on a fixed network, and collisions", tanner2_fig4::reproduce),
    figure("tanner2.fig5", "links within 2 m, a flock that stays connected", tanner2_switching::connected),
    figure("tanner2.fig6", "links within 2 m, a flock that is torn apart", tanner2_switching::torn),
    figure("tanner.rates", "exploration: rate of approach against connectivity", tanner_rates::reproduce),
    figure("tanner.equilibria", "exploration: equilibria, minima and saddles", tanner_equilibria::reproduce),
];

const fn figure(name: &'static str, about: &'static str, make: fn() -> Result<Reproduced, CheckError>) -> Figure {
    Figure { name, about, make }
}

impl Figure {
    /// The figure of that name, or all that have it without their paper.
    pub fn named(name: &str) -> Vec<&'static Figure> {
        let short = |figure: &&Figure| figure.name.split_once('.').is_some_and(|(_, rest)| rest == name);
        match FIGURES.iter().find(|figure| figure.name == name) {
            Some(figure) => vec![figure],
            None => FIGURES.iter().filter(short).collect(),
        }
    }

    /// Makes it: the text for the terminal and the files.
    ///
    /// # Errors
    /// [`FigureError`].
    pub fn reproduce(&self) -> Result<(String, Vec<File>), FigureError> {
        let made = (self.make)()?;
        let file = |part: &str, kind: &str, contents: Vec<u8>| {
            let hyphen = if part.is_empty() { "" } else { "-" };
            File { name: format!("{}{hyphen}{part}.{kind}", self.name), contents }
        };
        // What was chosen stands beside the numbers.
        let mut files = vec![file("", "txt", made.text.clone().into_bytes())];
        files.extend(made.tables.into_iter().map(|(part, csv)| file(part, "csv", csv.into_bytes())));
        for (part, picture) in made.pictures {
            files.push(file(part, "svg", picture.svg().into_bytes()));
            files.push(file(part, "png", picture.png()?));
        }
        Ok((made.text, files))
    }
}

/// A file of a figure.
#[derive(Debug, Clone)]
pub struct File {
    /// Its name, without a folder.
    pub name: String,
    /// Its contents.
    pub contents: Vec<u8>,
}

/// Why a figure could not be made.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FigureError {
    /// The computation.
    #[error("{0}")]
    Check(String),
    /// The drawing.
    #[error(transparent)]
    Picture(#[from] PictureError),
}

impl From<CheckError> for FigureError {
    fn from(error: CheckError) -> Self {
        FigureError::Check(error.to_string())
    }
}

/// What the function of a figure returns.
#[derive(Debug, Clone)]
struct Reproduced {
    text: String,
    tables: Vec<(&'static str, String)>,
    pictures: Vec<(&'static str, Picture)>,
}

impl Reproduced {
    /// A figure with a summary of at most 80 columns: what it shows, the parameters that the paper does not give, the main
    /// numbers.
    fn new(text: impl Into<String>) -> Self {
        Reproduced { text: text.into(), tables: Vec::new(), pictures: Vec::new() }
    }

    /// Adds a CSV file; `part` tells several apart and is empty for the only one.
    fn table(mut self, part: &'static str, csv: String) -> Self {
        self.tables.push((part, csv));
        self
    }

    /// Adds a picture, which becomes an SVG and a PNG file.
    fn picture(mut self, part: &'static str, picture: Picture) -> Self {
        self.pictures.push((part, picture));
        self
    }
}

/// A CSV document of rows that need no quotes.
fn csv<R: IntoIterator<Item = String>>(header: &str, rows: impl IntoIterator<Item = R>) -> String {
    let mut text = format!("{header}\n");
    for row in rows {
        text.push_str(&row.into_iter().collect::<Vec<_>>().join(","));
        text.push('\n');
    }
    text
}
