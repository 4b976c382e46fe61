//! `resonance`: the main resonance of the two-sided platoon.

use super::{CliError, certify, output};
use flockproof::arithmetic::{Interval, Rational, decimal, decimals, parse_rational};
use flockproof::certificates::{Certificate, Peak};
use flockproof::platoon::{Gains, resonance, theorem1};
use flockproof::report::Provenance;
use serde_json::json;
use std::path::PathBuf;
use std::process::ExitCode;

#[derive(clap::Args)]
#[command(
    after_help = "Frequencies are in radians per unit of time, amplitudes are those of the last car for a leader that swings with amplitude 1.\n\n\
Examples:\n  flockproof resonance --followers 128 --f -1 --g -1\n  flockproof resonance --followers 1000000000 --f=-1/2 --g=-3 --digits 12 --json"
)]
pub struct Arguments {
    /// Number of followers, from 1 to 10^9
    #[arg(long, value_name = "M", allow_negative_numbers = true)]
    followers: u64,
    /// Gain of the positions: an integer, a fraction or a decimal below 0
    #[arg(long, value_name = "F", allow_hyphen_values = true)]
    f: String,
    /// Gain of the velocities: an integer, a fraction or a decimal below 0
    #[arg(long, value_name = "G", allow_hyphen_values = true)]
    g: String,
    /// Significant digits, from 1
    #[arg(long, value_name = "D", default_value_t = 25, allow_negative_numbers = true)]
    digits: u32,
    /// Print one JSON document, flockproof.resonance/1
    #[arg(long)]
    json: bool,
    /// Write the peak as a certificate, for at most 96 followers, see proofs_checks/README.md
    #[arg(long, value_name = "OUT")]
    certificate: Option<PathBuf>,
}

fn number(name: &str, text: &str) -> Result<Rational, CliError> {
    parse_rational(text).map_err(|error| CliError::Use(format!("--{name}: {error}")))
}

/// The value of Theorem 1 to the asked digits, rounded down.
fn leading(x: &Interval, digits: u32) -> String {
    let (lo, _) = x.to_rationals();
    decimal(&lo, digits, false)
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    let gains = Gains { f: number("f", &arguments.f)?, g: number("g", &arguments.g)? };
    let (m, digits) = (arguments.followers, arguments.digits);
    let refuse = |error: &dyn std::fmt::Display| CliError::Use(error.to_string());
    certify::check_asked(arguments.certificate.as_deref())?;
    let found = resonance(&gains, m, digits).map_err(|error| refuse(&error))?;
    certify::write_asked(arguments.certificate.as_deref(), || Ok(Certificate::Peak(Peak::new(&gains, m)?)))?;
    let intervals = gains.map(|q| Interval::from_rational(q, 4 * digits + 64));
    let first_frequency = theorem1::frequency(&intervals, m).map_err(|error| refuse(&error))?;
    let first_amplitude = theorem1::amplitude(&intervals, m).map_err(|error| refuse(&error))?;
    let (omega, amplitude) = (decimals(&found.omega, digits + 3), decimals(&found.amplitude, digits + 3));
    let (first_frequency, first_amplitude) = (leading(&first_frequency, digits), leading(&first_amplitude, digits));
    if arguments.json {
        let configuration = json!({
            "command": "resonance", "followers": m, "f": gains.f.to_string(), "g": gains.g.to_string(), "digits": digits,
        });
        let provenance = Provenance::new("flockproof.resonance/1", None, configuration);
        output::print_json(&provenance.stamp(json!({
            "followers": m,
            "f": gains.f.to_string(),
            "g": gains.g.to_string(),
            "omega": {"lo": omega.0, "hi": omega.1},
            "amplitude": {"lo": amplitude.0, "hi": amplitude.1},
            "theorem1": {"omega": first_frequency, "amplitude": first_amplitude},
        })))?;
    } else {
        output::print(&format!(
            "main resonance of {m} followers, front and back tracked, f = {}, g = {}\n\
             omega      in [{},\n                {}]\n\
             amplitude  in [{},\n                {}]\n\
             Theorem 1: omega ~ {first_frequency}, amplitude ~ {first_amplitude}\n\
             No omega > 0 gives the last car a larger amplitude: notes/resonance.md.\n",
            gains.f, gains.g, omega.0, omega.1, amplitude.0, amplitude.1
        ))?;
    }
    Ok(ExitCode::SUCCESS)
}
