//! `reach`: worst cases of switched linear systems with bounded inputs.

use super::{CliError, certify, interrupt, output, progress};
use flockproof::arithmetic::Progress;
use flockproof::reach::{
    Decided, ReachError, System, Unbounded, Unshown, Verdict, answer, bounded, certificate, decide,
};
use flockproof::report::{Provenance, shown};
use serde_json::{Value, json};
use std::path::PathBuf;
use std::process::ExitCode;

/// Most digits.
const DIGITS: i64 = 200;

#[derive(clap::Args)]
#[command(after_help = "Example:\n  flockproof reach assets/systems/platoon_plad01.toml --digits 10 --json")]
pub struct Arguments {
    /// The system: modes, inputs, start, switching and checks, as notes/reach.md describes it
    #[arg(value_name = "SYSTEM.toml")]
    file: PathBuf,
    /// Significant digits of worst cases for a fixed order of modes
    #[arg(long, default_value_t = 10, value_parser = clap::value_parser!(u32).range(1..=DIGITS))]
    digits: u32,
    /// Print one JSON document, flockproof.reach/1
    #[arg(long)]
    json: bool,
    /// Write the motion found for the first check that is false, or else the first, as a certificate, see proofs_checks/README.md
    #[arg(long, value_name = "OUT")]
    certificate: Option<PathBuf>,
    /// Write that no motion violates the checks that hold at all times, as a certificate
    #[arg(long, value_name = "OUT")]
    bound: Option<PathBuf>,
    /// Draw the tube of each quantity with the worst motion, its modes and inputs
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
}

/// A system with what was found about it.
pub struct Answered {
    system: System,
    decided: Vec<Decided>,
    digits: u32,
    document: Value,
}

/// Decides the checks of a system.
pub fn answered(
    system: System,
    input: &output::Input,
    digits: u32,
    progress: &dyn Progress,
) -> Result<Option<Answered>, String> {
    let decided = match decide(&system, digits, progress) {
        Ok(decided) => decided,
        Err(ReachError::Cancelled(_)) => return Ok(None),
        Err(error) => return Err(error.to_string()),
    };
    let configuration = json!({"command": "reach", "system": input.origin, "digits": digits});
    let document =
        Provenance::new("flockproof.reach/1", None, configuration).stamp(answer::json(&system, &decided, digits));
    Ok(Some(Answered { system, decided, digits, document }))
}

impl Answered {
    /// The document and a piece of a page; none where the work was stopped.
    pub fn shown(self, progress: &dyn Progress) -> Option<(Value, String)> {
        let shown = shown::reach(&self.system, &self.decided, self.digits, progress).ok()?;
        Some((self.document, shown))
    }

    /// That of the check of which most is to be said against it.
    fn status(&self) -> u8 {
        self.decided.iter().map(|found| found.verdict).max().map_or(0, Verdict::status)
    }
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    arguments.plot.as_deref().map_or(Ok(()), output::check_writable)?;
    certify::check_asked(arguments.certificate.as_deref())?;
    certify::check_asked(arguments.bound.as_deref())?;
    let input = output::read_input(&arguments.file)?;
    let system = System::read_beside(&input.text, &output::beside(&arguments.file));
    let system = system.map_err(|error| CliError::file(&arguments.file, error))?;
    let watch = interrupt::Watch::with(progress::spinner("worst cases"));
    let found = answered(system, &input, arguments.digits, &watch);
    let found = found.map_err(|error| CliError::file(&arguments.file, error))?;
    let Some(found) = found else {
        watch.finish();
        return Ok(interrupt::status(false));
    };
    // What could not be written is told after the answer, which is there all the same.
    let (mut written, mut missed) = (Vec::new(), Vec::new());
    if let Some(path) = &arguments.certificate {
        let wanted = found.decided.iter().find(|found| found.verdict == Verdict::False).or(found.decided.first());
        let text = wanted.ok_or(Unshown::Missing);
        match text.and_then(|found_of| certificate(&found.system, found_of.decisive())) {
            Ok(text) => {
                output::write_file(path, text.as_bytes())?;
                written.push(path);
            }
            Err(error) => missed.push(format!("--certificate: {error}")),
        }
    }
    if let Some(path) = &arguments.bound {
        match bounded(&found.system, &found.decided, &watch) {
            Ok(text) => {
                output::write_file(path, text.as_bytes())?;
                written.push(path);
            }
            Err(Unbounded::Cancelled(_)) => {
                watch.finish();
                return Ok(interrupt::status(false));
            }
            Err(error) => missed.push(format!("--bound: {error}")),
        }
    }
    if let Some(path) = &arguments.plot {
        let Ok(picture) = shown::worst_cases(&found.system, &found.decided, &watch) else {
            watch.finish();
            return Ok(interrupt::status(false));
        };
        output::write_file(path, picture.svg().as_bytes())?;
        written.push(path);
    }
    watch.finish();
    if arguments.json {
        output::print_json(&found.document)?;
    } else {
        output::print_folded(&answer::text(&found.system, &found.decided, found.digits))?;
        for path in written {
            output::print(&format!("written: {}\n", path.display()))?;
        }
    }
    if !missed.is_empty() {
        return Err(CliError::Use(missed.join("; ")));
    }
    Ok(ExitCode::from(found.status()))
}
