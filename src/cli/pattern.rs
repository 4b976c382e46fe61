//! `pattern`: which symmetric patterns of steered particles are stable under given gains.

use super::{CliError, interrupt, output, progress};
use flockproof::arithmetic::{Progress, Rational, decimals, parse_rational};
use flockproof::report::{PatternRow, Provenance};
use serde_json::{Value, json};
use std::process::ExitCode;

/// Most particles.
pub const LARGEST: u64 = PatternRow::MOST_PARTICLES as u64;

#[derive(clap::Args)]
#[command(
    after_help = "N particles in M clusters of equal size, evenly spaced on one circle, for each M that divides N: stable if every eigenvalue of the linearisation lies \
in the left half plane but for those of rotation and translation. All-to-all coupling, control (20) with (25) of Sepulchre, Paley and Leonard as paley prints it.\n\n\
Examples:\n  flockproof pattern --particles 12 --gains 1/5,1/5,-1/25\n  flockproof pattern --particles 8 --gains=-1 --omega0 1/2 --json"
)]
pub struct Arguments {
    /// Number of particles, up to 60
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=LARGEST))]
    particles: u64,
    /// The gains K_1,K_2,.. of the orientation control, up to the last that is not zero
    #[arg(long, value_name = "K1,K2,..", allow_hyphen_values = true)]
    gains: String,
    /// Turning rate of a particle without control, not 0
    #[arg(long, value_name = "OMEGA0", default_value = "1/10", allow_hyphen_values = true)]
    omega0: String,
    /// Gain of the spacing control
    #[arg(long, value_name = "K0", default_value = "1/10", allow_hyphen_values = true)]
    spacing: String,
    /// Print one JSON document, flockproof.pattern/1
    #[arg(long)]
    json: bool,
}

/// What is asked, numbers as they are written.
pub struct Asked {
    pub particles: usize,
    pub gains: String,
    pub omega0: String,
    pub spacing: String,
}

/// What was found: a row for each number of clusters.
pub struct Found {
    particles: usize,
    omega0: Rational,
    spacing: Rational,
    pub gains: Vec<Rational>,
    pub rows: Vec<PatternRow>,
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    let Arguments { gains, omega0, spacing, .. } = arguments;
    let asked = Asked {
        particles: arguments.particles as usize,
        gains: gains.clone(),
        omega0: omega0.clone(),
        spacing: spacing.clone(),
    };
    let watch = interrupt::Watch::with(progress::bar());
    let found = find(&asked, &watch);
    watch.finish();
    if interrupt::happened() {
        return Ok(interrupt::status(false));
    }
    let found = found?;
    if arguments.json {
        output::print_json(&found.document())?
    } else {
        output::print_folded(&found.text())?
    }
    Ok(ExitCode::SUCCESS)
}

/// Every pattern with its verdict.
///
/// # Errors
/// Numbers that make no sense; the work was stopped.
pub fn find(asked: &Asked, progress: &dyn Progress) -> Result<Found, CliError> {
    let number =
        |name: &str, text: &str| parse_rational(text).map_err(|error| CliError::Use(format!("{name}: {error}")));
    let (omega0, spacing) = (number("omega0", &asked.omega0)?, number("K0", &asked.spacing)?);
    let gains = asked.gains.split(',').map(|text| number("gains", text)).collect::<Result<Vec<_>, _>>()?;
    let rows = PatternRow::all(asked.particles, (&omega0, &spacing), &gains, progress);
    let rows = rows.map_err(|error| CliError::Use(error.to_string()))?;
    Ok(Found { particles: asked.particles, omega0, spacing, gains, rows })
}

impl Found {
    /// The document `flockproof.pattern/1`.
    pub fn document(&self) -> Value {
        let gains: Vec<String> = self.gains.iter().map(Rational::to_string).collect();
        let (omega0, spacing) = (self.omega0.to_string(), self.spacing.to_string());
        let configuration = json!({
            "command": "pattern", "particles": self.particles, "gains": gains, "omega0": omega0, "K0": spacing,
        });
        let row = |row: &PatternRow| {
            let abscissa = row.abscissa.as_ref().map(|x| {
                let (lo, hi) = decimals(x, PatternRow::DIGITS);
                json!({"lo": lo, "hi": hi})
            });
            json!({"clusters": row.clusters, "verdict": row.verdict(), "zeros": row.zeros, "abscissa": abscissa, "wave": row.wave})
        };
        Provenance::new("flockproof.pattern/1", None, configuration).stamp(json!({
            "particles": self.particles, "gains": gains, "omega0": omega0, "K0": spacing,
            "patterns": self.rows.iter().map(row).collect::<Vec<Value>>(),
        }))
    }

    fn text(&self) -> String {
        let gains: Vec<String> = self.gains.iter().map(Rational::to_string).collect();
        let mut text = format!(
            "{} particles, all-to-all, omega0 = {}, K0 = {}, K = {}\nclusters  verdict    spectral abscissa, symmetry modes left out\n",
            self.particles,
            self.omega0,
            self.spacing,
            gains.join(", ")
        );
        for row in &self.rows {
            text += &format!("{:>8}  {:<9}  {}\n", row.clusters, row.verdict(), row.abscissa_text());
        }
        text
    }
}
