//! The two-sided platoon with equal gains: enclosures to any number of digits.

use super::super::{CliError, certify, output, progress};
use super::responses::Responses;
use super::{Arguments, followers};
use flockproof::arithmetic::{Field, Interval, Rational, decimal, decimals};
use flockproof::certificates::{Certificate, Peak};
use flockproof::platoon::bode::enclosed as enclosed_response;
use flockproof::platoon::{Gains, Resonance, amplitude_two_sided, resonance, theorem1};
use flockproof::report::Provenance;
use num_traits::ToPrimitive;
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

    /// What `--response` and `--plot` show of the last car.
    fn responses(&self) -> Responses<'_> {
        let (gains, m) = (&self.gains, self.followers);
        let last = move |w: &Interval| {
            let gains = gains.map(|q| w.rational(q));
            Ok(vec![amplitude_two_sided(&gains, w, m, m)?])
        };
        let floats = gains.map(|q| q.to_f64().unwrap_or(f64::NAN));
        Responses {
            names: vec![m.to_string()],
            enclosed: Some(Box::new(move |w: &Rational, digits: u32| enclosed_response(w, digits, last))),
            float: Box::new(move |w| Ok(vec![amplitude_two_sided(&floats, &w, m, m)?])),
            peaks: vec![(self.found.omega.to_f64(), self.found.amplitude.to_f64())],
            proved: true,
            stable: Some(true),
        }
    }

    fn text(&self) -> String {
        let (m, [omega, amplitude], [first_omega, first_amplitude]) = (self.followers, self.ends(), &self.theorem1);
        let (omega, amplitude) = (enclosed("omega", omega), enclosed("amplitude", amplitude));
        let followers = output::counted(m, "follower");
        format!(
            "main resonance of {followers}, front and back tracked, f = {}, g = {}\n\
             {omega}{amplitude}\
             Theorem 1: omega ~ {first_omega}, amplitude ~ {first_amplitude}\n\
             No omega > 0 (rad/s) gives the last car a larger amplitude: notes/resonance.md.\n",
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
    let responses = found.responses();
    let followers = output::counted(m, "follower");
    let title = format!("{followers}, front and back tracked, f = {}, g = {}", gains.f, gains.g);
    let certificate = arguments
        .certificate
        .as_deref()
        .map(|path| format!("written: {}: the peak as a certificate for flockproof-checker\n", path.display()));
    let written = responses.draw(arguments, &title, "")? + &certificate.unwrap_or_default();
    let table = responses.table(arguments)?;
    if arguments.json {
        let mut document = found.document();
        if let Some((rows, _)) = table {
            document["response"] = rows;
        }
        output::print_json(&document)?
    } else {
        output::print_folded(&(found.text() + &table.map_or(String::new(), |(_, table)| table) + &written))?
    }
    Ok(ExitCode::SUCCESS)
}
