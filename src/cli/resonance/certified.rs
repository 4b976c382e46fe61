//! The two-sided platoon with equal gains: enclosures to any number of digits.

use super::super::{CliError, certify, output, progress};
use super::{Arguments, followers};
use flockproof::arithmetic::{Interval, Rational, decimal, decimals};
use flockproof::certificates::{Certificate, Peak};
use flockproof::platoon::{Gains, Resonance, resonance, theorem1};
use flockproof::report::Provenance;
use serde_json::{Value, json};
use std::process::ExitCode;

/// The value of Theorem 1 to the asked digits, rounded down.
fn leading(x: &Interval, digits: u32) -> String {
    let (lo, _) = x.to_rationals();
    decimal(&lo, digits, false)
}

/// A resonance that was enclosed, with Theorem 1 beside it.
pub struct Certified {
    gains: Gains<Rational>,
    followers: u64,
    digits: u32,
    pub found: Resonance,
    /// Frequency and amplitude of Theorem 1.
    theorem1: [String; 2],
}

impl Certified {
    /// Encloses the main resonance.
    ///
    /// # Errors
    /// Gains or numbers out of range.
    pub fn find(gains: &Gains<Rational>, followers: u64, digits: u32) -> Result<Self, CliError> {
        let refuse = |error: &dyn std::fmt::Display| CliError::Use(error.to_string());
        let found = resonance(gains, followers, digits).map_err(|error| refuse(&error))?;
        let intervals = gains.map(|q| Interval::from_rational(q, 4 * digits + 64));
        let first = [theorem1::frequency(&intervals, followers), theorem1::amplitude(&intervals, followers)];
        let [frequency, amplitude] = first.map(|x| x.map(|x| leading(&x, digits)).map_err(|error| refuse(&error)));
        Ok(Certified { gains: gains.clone(), followers, digits, found, theorem1: [frequency?, amplitude?] })
    }

    /// Frequency and amplitude as decimals of their ends.
    fn ends(&self) -> [(String, String); 2] {
        [&self.found.omega, &self.found.amplitude].map(|x| decimals(x, self.digits + 3))
    }

    /// The document `flockproof.resonance/1`.
    pub fn document(&self) -> Value {
        let (f, g) = (self.gains.f.to_string(), self.gains.g.to_string());
        let (m, digits, [omega, amplitude]) = (self.followers, self.digits, self.ends());
        let configuration = json!({"command": "resonance", "followers": m, "f": f, "g": g, "digits": digits});
        Provenance::new("flockproof.resonance/1", None, configuration).stamp(json!({
            "followers": m,
            "f": f,
            "g": g,
            "omega": {"lo": omega.0, "hi": omega.1},
            "amplitude": {"lo": amplitude.0, "hi": amplitude.1},
            "theorem1": {"omega": self.theorem1[0], "amplitude": self.theorem1[1]},
        }))
    }

    fn text(&self) -> String {
        let (m, [omega, amplitude], [first_omega, first_amplitude]) = (self.followers, self.ends(), &self.theorem1);
        let (omega, amplitude) = (enclosed("omega", omega), enclosed("amplitude", amplitude));
        let followers = output::counted(m, "follower");
        format!(
            "main resonance of {followers}, front and back tracked, f = {}, g = {}\n\
             {omega}{amplitude}\
             Theorem 1: omega ~ {first_omega}, amplitude ~ {first_amplitude}\n\
             No omega > 0 gives the last car a larger amplitude: notes/resonance.md.\n",
            self.gains.f, self.gains.g
        )
    }
}

/// A number between its ends, one above the other.
pub(super) fn enclosed(name: &str, (lo, hi): (String, String)) -> String {
    let beside = 16 + lo.len().max(hi.len()) < output::width();
    let (before, indent) = if beside { (format!("{name:<10} in"), 16) } else { (format!("{name} in\n "), 3) };
    format!("{before} [{lo},\n{:indent$}{hi}]\n", "")
}

pub fn run(arguments: &Arguments, gains: &Gains<Rational>) -> Result<ExitCode, CliError> {
    let (m, digits) = (followers(arguments)?, arguments.digits);
    certify::check_asked(arguments.certificate.as_deref())?;
    let bar = progress::spinner("enclosing the peak");
    let found = Certified::find(gains, m, digits);
    bar.finish_and_clear();
    let found = found?;
    certify::write_asked(arguments.certificate.as_deref(), || Ok(Certificate::Peak(Peak::new(gains, m)?)))?;
    if arguments.json {
        output::print_json(&found.document())?
    } else {
        output::print_folded(&found.text())?
    }
    Ok(ExitCode::SUCCESS)
}
