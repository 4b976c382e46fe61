//! The two-sided platoon with equal gains: enclosures to any number of digits.

use super::super::{CliError, certify, output};
use super::{Arguments, followers};
use flockproof::arithmetic::{Interval, Rational, decimal, decimals};
use flockproof::certificates::{Certificate, Peak};
use flockproof::platoon::{Gains, resonance, theorem1};
use flockproof::report::Provenance;
use serde_json::json;
use std::process::ExitCode;

/// The value of Theorem 1 to the asked digits, rounded down.
fn leading(x: &Interval, digits: u32) -> String {
    let (lo, _) = x.to_rationals();
    decimal(&lo, digits, false)
}

pub fn run(arguments: &Arguments, gains: &Gains<Rational>) -> Result<ExitCode, CliError> {
    let (m, digits) = (followers(arguments)?, arguments.digits);
    let refuse = |error: &dyn std::fmt::Display| CliError::Use(error.to_string());
    certify::check_asked(arguments.certificate.as_deref())?;
    let found = resonance(gains, m, digits).map_err(|error| refuse(&error))?;
    certify::write_asked(arguments.certificate.as_deref(), || Ok(Certificate::Peak(Peak::new(gains, m)?)))?;
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
