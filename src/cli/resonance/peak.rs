//! What is known of the peak of a linear system, in words and as JSON: proved, searched, or none.

use super::super::CliError;
use super::certified::enclosed;
use flockproof::arithmetic::{Interval, decimals};
use flockproof::platoon::observe::Extreme;
use flockproof::platoon::{Peak, PeakError};
use serde_json::{Value, json};

/// What is known.
pub(super) enum Found {
    /// Over all frequencies, with proof; the system is stable.
    Certified(Peak),
    /// Some motion without input does not die out: there is no peak.
    NotStable,
    /// The largest amplitude that a search met, and what was searched.
    Searched { peak: Extreme, how: String },
}

impl Found {
    /// A peak with proof, or that there is none.
    ///
    /// # Errors
    /// Where nothing is proved.
    pub fn proved(peak: Result<Peak, PeakError>) -> Result<Self, CliError> {
        match peak {
            Ok(peak) => Ok(Found::Certified(peak)),
            Err(PeakError::NotStable) => Ok(Found::NotStable),
            Err(error) => Err(CliError::Use(format!("no peak: {error}"))),
        }
    }

    /// Whether the system is stable, as far as the peak tells.
    pub fn stable(&self) -> Option<bool> {
        match self {
            Found::Certified(_) => Some(true),
            Found::NotStable => Some(false),
            Found::Searched { .. } => None,
        }
    }

    /// The field `peak` of a document.
    pub fn document(&self, digits: u32) -> Value {
        let ends = |(lo, hi): (String, String)| json!({"lo": lo, "hi": hi});
        let of = |x: &Interval| ends(decimals(x, digits + 3));
        match self {
            Found::Certified(Peak { omega, amplitude }) => {
                json!({"omega": omega.as_ref().map(of), "amplitude": of(amplitude), "grade": "certified"})
            }
            Found::NotStable => Value::Null,
            Found::Searched { peak, how } => json!({
                "omega": format!("~{:?}", peak.at), "amplitude": format!("~{:?}", peak.value),
                "grade": "simulated", "search": how,
            }),
        }
    }

    /// Frequency and amplitude in floating point, where there is a peak at a frequency above 0.
    pub fn place(&self) -> Option<(f64, f64)> {
        let place = match self {
            Found::Certified(Peak { omega, amplitude }) => (omega.as_ref()?.to_f64(), amplitude.to_f64()),
            Found::NotStable => return None,
            Found::Searched { peak, .. } => (peak.at, peak.value),
        };
        (place.0 > 0.0).then_some(place)
    }

    /// Frequency and amplitude, each as its two ends; nothing where there is none.
    pub fn ends(&self, digits: u32) -> Option<[(String, String); 2]> {
        let of = |x: &Interval| decimals(x, digits + 3);
        match self {
            Found::Certified(Peak { omega, amplitude }) => Some([of(omega.as_ref()?), of(amplitude)]),
            Found::NotStable => None,
            Found::Searched { peak, .. } => Some([peak.at, peak.value].map(|x| (format!("~{x:?}"), format!("~{x:?}")))),
        }
    }

    /// The lines after the head line `head`, which they end if there is no peak; `stable` is what else is known of stability.
    pub fn text(&self, head: &str, digits: u32, stable: Option<bool>) -> String {
        let of = |name: &str, x: &Interval| enclosed(name, decimals(x, digits + 3));
        match self {
            Found::NotStable => {
                format!(
                    "NOT stable, so there is no peak: {head}\nsome motion behind a resting leader does not die out (decided exactly)\n"
                )
            }
            Found::Certified(Peak { omega, amplitude }) => {
                let place = match omega {
                    Some(omega) => of("omega", omega),
                    None => "omega without bound: the amplitude is a limit\n".to_string(),
                };
                format!(
                    "{head}\n{place}{}No omega >= 0 (rad/s) gives a larger amplitude: notes/resonance.md.\n\
                     stable: every motion behind a resting leader dies out (decided exactly)\n",
                    of("amplitude", amplitude)
                )
            }
            Found::Searched { peak, how } => {
                let mut text =
                    format!("{head}\nsearch, without proof: omega ~ {:?},\n  amplitude ~ {:?}\n", peak.at, peak.value);
                text += &format!("searched: {how}\n");
                text += match stable {
                    Some(_) => "stable: every motion behind a resting leader dies out\n",
                    None => "whether it is stable is not decided; if it is not, there is no peak\n",
                };
                text
            }
        }
    }
}
