//! `resonance --response` and `--plot`: responses at given frequencies, enclosed, and Bode's diagram.

use super::super::{CliError, output};
use super::{Arguments, numbers};
use flockproof::arithmetic::{ArithmeticError, Complex, Interval, Rational, decimals, parse_rational};
use flockproof::platoon::bode::{Polar, Sample, sampled};
use flockproof::report::{Curves, bode};
use num_traits::ToPrimitive;
use serde_json::{Value, json};
use std::path::Path;

/// Most rows of a table.
const MOST_FREQUENCIES: usize = 10_000;

/// Digits of the table, which has to fit into 80 columns; documents have as many as are asked for.
const SHOWN: u32 = 7;

/// The response of some cars.
pub(super) struct Responses<'a> {
    /// What the cars are called.
    pub names: Vec<String>,
    /// Moduli and phases at a frequency to so many digits; nothing where there are too many followers for that.
    pub enclosed: Option<Enclosed<'a>>,
    /// Amplitudes at a frequency in floating point.
    pub float: Float<'a>,
    /// Frequencies and amplitudes of their peaks, and whether these are proved.
    pub peaks: Vec<(f64, f64)>,
    pub proved: bool,
    /// What is not stable has a response that nobody sees.
    pub stable: Option<bool>,
}

const NOT_STABLE: &str = "It is not stable: these are the values of its transfer function, which no motion shows.";

type Enclosed<'a> = Box<dyn Fn(&Rational, u32) -> Result<Vec<Polar>, ArithmeticError> + 'a>;
type Float<'a> = Box<dyn Fn(f64) -> Result<Vec<Complex<f64>>, ArithmeticError> + 'a>;

/// The frequencies of `--response`.
fn frequencies(text: &str) -> Result<Vec<Rational>, CliError> {
    let refuse = |why: &str| CliError::Use(format!("--response {text}: {why}"));
    let list = match ends(text)? {
        None => numbers("response", text)?,
        Some((from, to, count)) => {
            let [from, to] = [from, to].map(|x| x.to_f64().unwrap_or(f64::NAN));
            let at = |k: usize| from * (to / from).powf(k as f64 / (count - 1) as f64);
            // Six digits are enough for a table, and exact.
            let exact =
                |k: usize| parse_rational(&format!("{:.5e}", at(k))).map_err(|error| refuse(&error.to_string()));
            (0..count).map(exact).collect::<Result<_, _>>()?
        }
    };
    if list.len() > MOST_FREQUENCIES {
        return Err(refuse(&format!("{} frequencies are more than {MOST_FREQUENCIES}", list.len())));
    }
    let zero = Rational::default();
    if list.iter().any(|w| *w < zero || w.to_f64().is_none_or(|w| !w.is_finite())) {
        return Err(refuse("frequencies are not negative"));
    }
    Ok(list)
}

/// The ends and the number of frequencies in equal ratios, where these are given.
fn ends(text: &str) -> Result<Option<(Rational, Rational, usize)>, CliError> {
    let refuse = |why: &str| CliError::Use(format!("--response {text}: {why}"));
    let Some((from, rest)) = text.split_once("..") else { return Ok(None) };
    let (to, count) =
        rest.split_once(':').ok_or_else(|| refuse("the number of frequencies is missing: FROM..TO:COUNT"))?;
    let count = count.parse().ok().filter(|count| (2..=MOST_FREQUENCIES).contains(count));
    let count = count.ok_or_else(|| refuse("the number of frequencies must be a whole number from 2 to 10000"))?;
    let number = |text: &str| parse_rational(text).map_err(|error| CliError::Use(format!("--response: {error}")));
    let (from, to) = (number(from)?, number(to)?);
    let is_positive = |x: &Rational| x.to_f64().is_some_and(|x| x > 1e-300 && x < 1e300);
    if !is_positive(&from) || !is_positive(&to) || from >= to {
        return Err(refuse("FROM should be above 0 and TO above FROM"));
    }
    Ok(Some((from, to, count)))
}

impl Responses<'_> {
    /// The table that is asked for: as the field `response` of a document, and in words.
    pub fn table(&self, arguments: &Arguments) -> Result<Option<(Value, String)>, CliError> {
        let Some(text) = arguments.response.as_deref() else { return Ok(None) };
        let refuse =
            |error: &ArithmeticError| CliError::Use(format!("--response: the response does not exist: {error}"));
        let mut rows = Vec::new();
        let mut table = match self.enclosed {
            Some(_) => "response, enclosed: amplitude for an amplitude 1 of the leader, phase in radians\n".to_string(),
            None => "response in floating point, without proof: amplitude, phase in radians\n".to_string(),
        };
        if self.stable == Some(false) {
            table += &format!("{NOT_STABLE}\n");
        }
        let car_width = self.names.iter().map(String::len).max().unwrap_or(1).max(3);
        table += &format!("{:<11} {:<car_width$} {:<27} phase\n", "omega", "car", "amplitude");
        for w in frequencies(text)? {
            let (float, exact) = (w.to_f64().unwrap_or(f64::NAN), w.to_string());
            // A frequency with a short decimal is shown as that.
            let decimal = format!("{float}");
            let shown = if parse_rational(&decimal).as_ref() == Ok(&w) { decimal } else { exact.clone() };
            let mut row = |name: &str, [amplitude, phase]: [Value; 2], words: [String; 2]| {
                rows.push(json!({"omega": exact, "car": name, "amplitude": amplitude, "phase": phase}));
                table += &format!("{shown:<11} {name:<car_width$} {:<27} {}\n", words[0], words[1]);
            };
            match &self.enclosed {
                Some(enclosed) => {
                    let found = enclosed(&w, arguments.digits).map_err(|error| refuse(&error))?;
                    for (name, polar) in self.names.iter().zip(&found) {
                        let of = |x: &Interval, digits: u32| decimals(x, digits);
                        let value = |x: &Interval| {
                            let (lo, hi) = of(x, arguments.digits + 3);
                            json!({"lo": lo, "hi": hi})
                        };
                        let words = |x: &Interval| {
                            let (lo, hi) = of(x, arguments.digits.min(SHOWN));
                            format!("[{lo}, {hi}]")
                        };
                        let phase = polar.phase.as_ref();
                        row(
                            name,
                            [value(&polar.amplitude), phase.map_or(Value::Null, value)],
                            [words(&polar.amplitude), phase.map_or("-".to_string(), words)],
                        );
                    }
                }
                None => {
                    let found = (self.float)(float).map_err(|error| refuse(&error))?;
                    for (name, z) in self.names.iter().zip(&found) {
                        let words = [z.re.hypot(z.im), z.im.atan2(z.re)].map(|x| format!("~{x:?}"));
                        row(name, words.clone().map(Value::String), words);
                    }
                }
            }
        }
        Ok(Some((Value::Array(rows), table)))
    }

    /// Where the curves begin and end: as asked, or from well below the slowest peak to where all amplitudes are small.
    fn samples(&self, arguments: &Arguments) -> Result<Vec<Sample>, CliError> {
        let refuse = |error: ArithmeticError| CliError::Use(format!("--plot: the response does not exist: {error}"));
        let near: Vec<f64> = self.peaks.iter().map(|peak| peak.0).collect();
        if let Some((from, to, _)) = arguments.response.as_deref().map(ends).transpose()?.flatten() {
            let range = (from.to_f64().unwrap_or(f64::NAN), to.to_f64().unwrap_or(f64::NAN));
            return sampled(range, &near, &self.float).map_err(refuse);
        }
        let slowest = near.iter().copied().fold(f64::INFINITY, f64::min);
        let fastest = near.iter().copied().fold(0.0, f64::max);
        let (low, high) = if near.is_empty() { (1e-2, 1e2) } else { (slowest / 20.0, fastest * 1e3) };
        let mut samples = sampled((low, high), &near, &self.float).map_err(refuse)?;
        // Behind the last frequency at which some car still answers with a hundredth there is nothing to see.
        let last = samples.iter().rposition(|sample| sample.amplitudes.iter().any(|a| *a > 1e-2));
        samples.truncate(last.map_or(samples.len(), |last| (last + 2).min(samples.len())));
        Ok(samples)
    }

    /// Writes the diagram that is asked for, and tells what was written.
    pub fn draw(&self, arguments: &Arguments, title: &str, caption: &str) -> Result<String, CliError> {
        let Some(path) = arguments.plot.as_deref() else { return Ok(String::new()) };
        let names: Vec<String> = self.names.iter().map(|name| format!("car {name}")).collect();
        let mark = if self.proved { "peak, certified" } else { "peak, searched" };
        let samples = self.samples(arguments)?;
        let caption = &match self.stable {
            Some(false) => format!("{caption} {NOT_STABLE}"),
            _ => caption.to_string(),
        };
        let picture = bode(&Curves { title, caption, names: &names, samples: &samples, peaks: &self.peaks, mark });
        let contents = match extension(path).as_deref() {
            Some("svg") => picture.svg().into_bytes(),
            Some("png") => picture.png().map_err(|error| CliError::file(path, error))?,
            _ => return Err(CliError::file(path, "the name of a picture should end in .svg or .png")),
        };
        output::write_file(path, &contents)?;
        Ok(format!("written: {}: magnitude and phase of {}\n", path.display(), names.join(", ")))
    }
}

fn extension(path: &Path) -> Option<String> {
    path.extension().map(|end| end.to_string_lossy().to_ascii_lowercase())
}
