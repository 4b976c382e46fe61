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
mod veerman_worst;

use super::file::File;
use super::papers::paper;
use super::plot::{Picture, PictureError};
use ledger::CheckError;

/// A figure or table that can be made again.
#[derive(Debug, Clone, Copy)]
pub struct Figure {
    /// Paper and number, as in the ids of claims.
    pub name: &'static str,
    /// What it shows, one line.
    pub about: &'static str,
    /// The claims that it bears on.
    pub claims: &'static [&'static str],
    make: fn() -> Result<Reproduced, CheckError>,
}

/// All figures and tables with the claims they bear on, in the order in which `reproduce all` makes them.
pub const FIGURES: &[Figure] = &[
    figure(
        "veerman.table1",
        "the printed resonances beside certified ones",
        &["veerman.table1_numeric", "veerman.table1_theory", "veerman.table1.size", "veerman.sec7.system"],
        veerman_table1::reproduce,
    ),
    figure(
        "veerman.table1_readings",
        "by which procedure its simulated columns come out",
        &["veerman.table1_theory", "beyond.veerman.table1_reading"],
        veerman_procedures::reproduce,
    ),
    figure(
        "veerman.fig1",
        "the response of the last car over the frequency",
        &["veerman.fig1", "beyond.veerman.growth"],
        veerman_fig1::reproduce,
    ),
    figure(
        "veerman.fig2",
        "a flock behind a periodic leader, with collision check",
        &["veerman.sec6_fig2"],
        veerman_fig2::reproduce,
    ),
    figure(
        "veerman.fig3",
        "a flock behind an abrupt leader, with collision check",
        &["veerman.fig3"],
        veerman_fig3::reproduce,
    ),
    figure(
        "veerman.fig4",
        "resonance against the number of cars",
        &["veerman.fig4", "veerman.thm1_omega", "veerman.thm1_amp"],
        veerman_fig4::reproduce,
    ),
    figure(
        "veerman.fig5",
        "differences from Theorem 1 and their regression lines",
        &["veerman.fig5", "beyond.veerman.resonance_frequency", "beyond.veerman.resonance_amplitude"],
        veerman_fig5::reproduce,
    ),
    figure(
        "veerman.observation_time",
        "how the measured peak converges to the certified one",
        &["veerman.table1_numeric", "beyond.veerman.decay_rate"],
        veerman_observation::reproduce,
    ),
    figure(
        "veerman.communication_sweep",
        "exploration: linear or exponential growth",
        &["veerman.onlytwo", "veerman.nth_neighbour"],
        veerman_sweep::reproduce,
    ),
    figure(
        "veerman.worst_cases",
        "worst lags and gaps behind a leader of bounded acceleration",
        &["beyond.veerman.worst_cases", "beyond.veerman.growth"],
        veerman_worst::reproduce,
    ),
    figure(
        "paley.fig1",
        "four types of motion under the all-to-all control",
        &["paley.fig1", "paley.releq", "paley.eq3"],
        paley_fig1::reproduce,
    ),
    figure(
        "paley.fig2",
        "the eigenvectors of the cyclic graph as polygons",
        &["paley.fig2", "paley.fig2.caption", "paley.eig.sym", "beyond.paley.cyclic_eigenvectors"],
        paley_fig2::reproduce,
    ),
    figure(
        "paley.fig3",
        "circular formations on the cyclic graph",
        &["paley.fig3", "paley.fig3.gain", "paley.fig3.max", "beyond.paley.cyclic_patterns"],
        paley_fig3::reproduce,
    ),
    figure(
        "paley.fig4",
        "the six symmetric circular formations",
        &["paley.fig4", "paley.thm3.stab"],
        paley_fig4::reproduce,
    ),
    figure(
        "paley.fig5",
        "a group that tracks a reference direction",
        &["paley.fig5", "paley.ref"],
        paley_fig5::reproduce,
    ),
    figure(
        "paley.fig6",
        "a circular formation in a drift field, with a beacon",
        &["paley.drift", "paley.fig6.gain", "paley.beacon", "paley.beacon.form"],
        paley_fig6::reproduce,
    ),
    figure("paley.fig7", "the perceptual zones of a fish", &["paley.fig7"], paley_fig7::reproduce),
    figure(
        "paley.fig8",
        "circular formations for growing zones of orientation",
        &["paley.fig8.circ", "paley.fig8.neg", "paley.fig8.pos", "paley.chord", "paley.eq29"],
        paley_fig8::reproduce,
    ),
    figure(
        "paley.abscissa",
        "enclosed rates of decay to symmetric circular formations",
        &["beyond.paley.abscissa", "paley.thm3.stab"],
        paley_abscissa::reproduce,
    ),
    figure(
        "paley.basins",
        "exploration: which share of starts ends where",
        &["paley.fig3.gain", "beyond.paley.cyclic_patterns"],
        paley_basins::reproduce,
    ),
    figure(
        "paley.figS2",
        "fish, headings and zones of orientation, on synthetic schools",
        &["paley.figS1_S3"],
        paley_fish_data::snapshots,
    ),
    figure(
        "paley.figS3",
        "scaled phase potentials and null models, on synthetic schools",
        &["paley.figS1_S3", "paley.figS3.difference", "paley.scale"],
        paley_fish_data::potentials,
    ),
    figure("tanner1.fig2", "the potential of two agents", &["tanner1.fig2", "tanner1.anyV"], tanner1_fig2::reproduce),
    figure(
        "tanner1.figs3_6",
        "heading alignment on the complete graph, with shares",
        &["tanner1.figs3_6"],
        tanner1_flocking::complete,
    ),
    figure(
        "tanner1.figs7_10",
        "heading alignment on incomplete graphs, with shares",
        &["tanner1.figs7_10"],
        tanner1_flocking::incomplete,
    ),
    figure(
        "tanner2.fig4",
        "velocity alignment on a fixed network, and collisions",
        &["tanner2.fig4", "tanner2.fig4.close"],
        tanner2_fig4::reproduce,
    ),
    figure(
        "tanner2.fig5",
        "links within 2 m, a flock that stays connected",
        &["tanner2.fig5"],
        tanner2_switching::connected,
    ),
    figure("tanner2.fig6", "links within 2 m, a flock that is torn apart", &["tanner2.fig6"], tanner2_switching::torn),
    figure(
        "tanner.rates",
        "exploration: rate of approach against connectivity",
        &["tanner2.cor2_rate"],
        tanner_rates::reproduce,
    ),
    figure(
        "tanner.equilibria",
        "exploration: equilibria, minima and saddles",
        &["tanner2.thm1c", "beyond.tanner2.thm1c", "tanner2.sec4.flocking"],
        tanner_equilibria::reproduce,
    ),
];

const fn figure(
    name: &'static str,
    about: &'static str,
    claims: &'static [&'static str],
    make: fn() -> Result<Reproduced, CheckError>,
) -> Figure {
    Figure { name, about, claims, make }
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

    /// All figures that bear on a claim.
    pub fn of_claim(id: &str) -> impl Iterator<Item = &'static Figure> {
        FIGURES.iter().filter(move |figure| figure.claims.contains(&id))
    }

    /// The paper it belongs to; what is about both papers of Tanner and others stands with the second.
    pub fn paper(&self) -> &'static str {
        match self.name.split('.').next() {
            Some("tanner") | None => "tanner2",
            Some(paper) => paper,
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
        let paper = paper(self.paper()).map_or(String::new(), |paper| format!("{} {}", paper.short, paper.year));
        let caption = format!("{}: {}. Claims: {}", self.name, self.about, self.claims.join(", "));
        for (part, picture) in made.pictures {
            let picture = picture.of(&paper).caption(&caption);
            files.push(file(part, "svg", picture.svg().into_bytes()));
            files.push(file(part, "png", picture.png()?));
        }
        Ok((made.text, files))
    }
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
