//! `flock run`: exact steps with a log of what changes.

use super::super::interrupt::{self, Watch};
use super::super::{CliError, certify, output, progress};
use super::observed::{Lengths, observed_json, observed_text};
use super::output::{Log, SwitchLine, flocks, switch_json, tell};
use super::stepped::SteppedFlock;
use flockproof::arithmetic::Progress;
use flockproof::averaging::read::Model;
use flockproof::averaging::{FlockError, Observer};
use flockproof::certificates::{Certificate, Switches};
use flockproof::matrix::MatrixError;
use flockproof::report::Provenance;
use serde_json::json;
use std::path::PathBuf;
use std::process::ExitCode;

#[derive(clap::Args)]
#[command(after_help = "Times are whole numbers of steps; birds are counted from 1.\n\n\
Examples:\n  flockproof flock run assets/four_birds.json --until 64 --products\n  flockproof flock run birds.json --until 1000 --json --log log.jsonl")]
pub struct Arguments {
    /// The flock as JSON
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// Last time, a whole number of steps
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    until: u64,
    /// Print one JSON document, flockproof.flock-run/1
    #[arg(long)]
    json: bool,
    /// Footprints, stabilisers and ergodicity coefficients of P(t, S) = P(t) ... P(S)
    #[arg(long, value_name = "S", default_value_t = 1)]
    from: u64,
    /// Footprint and stabilisers of more than 1000 birds too: a digit for each pair of birds
    #[arg(long)]
    footprints: bool,
    /// Multiply the exact product P(t, S) too: tau_1 and tau_2 at S, S + 1, S + 3, S + 7, ...
    #[arg(long)]
    products: bool,
    /// Write every change as it happens to this file, one JSON object per line
    #[arg(long, value_name = "LOG")]
    log: Option<PathBuf>,
    /// Write the switches as a certificate (model D without control), see proofs_checks/README.md
    #[arg(long, value_name = "OUT")]
    certificate: Option<PathBuf>,
}

/// Birds whose footprints are kept without being asked for.
const FOOTPRINTS: usize = 1000;

/// Birds moved between two looks at the bar.
const TOLD: usize = 1 << 20;

/// Most steps: about a day for three birds.
const MOST_STEPS: u64 = 100_000_000_000;

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    let refuse = |error: flockproof::averaging::FlockError| CliError::file(&arguments.file, error);
    if arguments.until > MOST_STEPS {
        let until = arguments.until;
        return Err(CliError::Use(format!(
            "--until {until}: more than {MOST_STEPS} exact steps, one after the other, do not end; `flock settle` jumps"
        )));
    }
    if arguments.from == 0 || (arguments.from > arguments.until && arguments.until > 0) {
        let (from, until) = (arguments.from, arguments.until);
        return Err(CliError::Use(format!("--from {from}: products start at a time from 1 to --until {until}")));
    }
    certify::check_asked(arguments.certificate.as_deref())?;
    let (flock, origin) = super::read(&arguments.file)?;
    let model = flock.model;
    if arguments.certificate.is_some() {
        let Model::D { start, control: None } = &model else {
            return Err(CliError::Use("--certificate: only flocks of model D without control have one".to_string()));
        };
        let switches = || Ok(Certificate::Switches(Switches::new(start, arguments.until)?));
        certify::write_asked(arguments.certificate.as_deref(), switches)?;
    }
    let mut flock = SteppedFlock::new(model).map_err(refuse)?;
    let mut log = Log::new(arguments.log.as_deref())?;
    let watch = Watch::with(progress::styled("{bar:30} t = {pos} of {len}, {eta} left"));
    tell(arguments.json, &format!("{}\n", flock.declaration()))?;
    let birds = flock.network().order();
    let kept = birds <= FOOTPRINTS || arguments.footprints || arguments.products;
    let observer = Observer::new(birds, arguments.from, arguments.products);
    let mut observer = if kept { observer } else { observer.without_footprints() };
    let told = (TOLD / birds.max(1)).clamp(1, 1024) as u64;
    let mut switches = Vec::new();
    let mut line = SwitchLine::new(flock.network());
    let mut t = 0;
    while t < arguments.until && !watch.is_cancelled() {
        let switch = match flock.step(&watch) {
            Err(FlockError::Cancelled(_)) => break,
            step => step.map_err(refuse)?,
        };
        t += 1;
        let observed = observer.push(t, flock.network(), flock.weights(), &watch);
        if let Some(switch) = switch {
            let event = switch_json(&switch);
            log.write(&event)?;
            if !arguments.json {
                watch.bar().suspend(|| tell(false, &line.of(&switch, flock.network())))?;
            }
            switches.push(event);
        }
        match observed {
            // The step is kept; what it does to the product is not.
            Err(MatrixError::Cancelled(_)) => break,
            other => other.map_err(|error| CliError::file(&arguments.file, error))?,
        }
        if t % told == 0 {
            watch.tell("steps", t, Some(arguments.until));
        }
    }
    watch.finish();
    let interrupted = t < arguments.until || interrupt::happened();
    let why = match interrupted {
        true => format!("interrupted after t = {t}"),
        false if flock.can_be_settled() => {
            format!("stepped to t = {t}; `flock settle` decides whether the network can ever change again")
        }
        false => format!("stepped to t = {t}; nothing is said about later times"),
    };
    let lengths = Lengths::new(&flock, t, &watch);
    interrupt::finishing();
    if arguments.json {
        let mut document = json!({
            "declaration": flock.declaration(),
            "switches": switches,
            "flocks": flocks(flock.network()),
            "steady_from": null,
            "until": t,
            "denominator_bits": flock.denominator_bits(),
            "why": why,
        });
        if let Some(bits) = flock.precision() {
            document["precision_bits"] = json!(bits);
        }
        observed_json(&observer, &lengths, &mut document);
        let configuration = json!({
            "command": "flock run", "file": origin, "until": arguments.until, "from": arguments.from,
            "products": arguments.products,
        });
        let provenance = Provenance::new("flockproof.flock-run/1", None, configuration);
        output::print_json(&provenance.stamp(document))?;
    } else {
        let list: Vec<String> = flocks(flock.network()).iter().map(|flock| format!("{flock:?}")).collect();
        let denominator = flock.denominator_bits();
        let size = match flock.precision() {
            Some(bits) => {
                format!("common denominator of the headings, not reduced: {denominator} bits; positions: {bits} bits")
            }
            None => format!("common denominator of the state, not reduced: {denominator} bits"),
        };
        let text = format!(
            "{} switches; flocks: {}\n{size}\n{}{why}",
            switches.len(),
            list.join(" "),
            observed_text(&observer, &lengths)
        );
        output::print(&(textwrap::fill(&text, output::width().min(100)) + "\n"))?;
    }
    Ok(if interrupted { ExitCode::from(interrupt::STATUS) } else { ExitCode::SUCCESS })
}
