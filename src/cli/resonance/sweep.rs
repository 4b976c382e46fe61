//! `resonance --sweep`: a table over values of the gains.

use super::super::interrupt::{self, Watch};
use super::super::{CliError, output, progress};
use super::{Arguments, followers, is_certified, network, numbers};
use flockproof::arithmetic::{Progress, Rational, decimals};
use flockproof::platoon::{Gains, Line, Parameter, resonance};
use flockproof::report::Provenance;
use serde_json::json;
use std::process::ExitCode;

/// Most rows of a table.
const MOST_ROWS: usize = 100_000;

/// The values of one part `f=-4..-1:4` or `f=-1`.
fn values(part: &str) -> Result<(&str, Vec<Rational>), CliError> {
    let refuse = |why: &str| CliError::Use(format!("--sweep {part}: {why}"));
    let (name, range) = part.split_once('=').ok_or_else(|| refuse("it should be f=FROM..TO:COUNT or f=VALUE"))?;
    if !["f", "g"].contains(&name) {
        return Err(refuse("only f and g can be swept"));
    }
    let number = |text: &str| numbers("sweep", text).map(|mut list| list.remove(0));
    let Some((from, rest)) = range.split_once("..") else { return Ok((name, vec![number(range)?])) };
    let (to, count) = rest.split_once(':').ok_or_else(|| refuse("the number of values is missing: FROM..TO:COUNT"))?;
    let count = count.parse().ok().filter(|count| (2..=MOST_ROWS as i64).contains(count));
    let count: i64 = count.ok_or_else(|| refuse("the number of values must be a whole number from 2 to 100000"))?;
    let (from, to) = (number(from)?, number(to)?);
    let step = (&to - &from) / Rational::from_integer((count - 1).into());
    Ok((name, (0..count).map(|k| &from + &step * Rational::from_integer(k.into())).collect()))
}

/// The gains of all rows: those of the sweep, the others as they are given.
fn grid(arguments: &Arguments) -> Result<Vec<Gains<Rational>>, CliError> {
    let mut swept: [Option<Vec<Rational>>; 2] = [None, None];
    for part in arguments.sweep.as_deref().unwrap_or_default().split(',') {
        let (name, list) = values(part)?;
        if swept[usize::from(name == "g")].replace(list).is_some() {
            return Err(CliError::Use(format!("--sweep: {name} is there twice")));
        }
    }
    let [f, g] = swept;
    let list = |name: &str, swept: Option<Vec<Rational>>, given: &Option<String>| match (swept, given) {
        (Some(_), Some(_)) => Err(CliError::Use(format!("--{name} and --sweep {name}=.. cannot both be given"))),
        (Some(list), None) => Ok(list),
        (None, Some(text)) => match numbers(name, text)?.as_slice() {
            [one] => Ok(vec![one.clone()]),
            _ => Err(CliError::Use(format!("--{name}: with --sweep all cars have the same gain"))),
        },
        (None, None) => Err(CliError::Use(format!("--{name} is needed, or a part {name}=.. of --sweep"))),
    };
    let (f, g) = (list("f", f, &arguments.f)?, list("g", g, &arguments.g)?);
    if f.len().saturating_mul(g.len()) > MOST_ROWS {
        return Err(CliError::Use(format!("--sweep: {} rows are more than {MOST_ROWS}", f.len() * g.len())));
    }
    Ok(f.iter().flat_map(|f| g.iter().map(move |g| Gains { f: f.clone(), g: g.clone() })).collect())
}

/// Frequency and amplitude of one row, each as its two ends; nothing where the platoon is not stable.
type Row = Option<[(String, String); 2]>;

fn row(arguments: &Arguments, looked: Option<&network::Looked>, gains: &Gains<Rational>) -> Result<Row, CliError> {
    let digits = arguments.digits.min(15);
    let Some(looked) = looked else {
        let found =
            resonance(gains, followers(arguments)?, digits).map_err(|error| CliError::Use(error.to_string()))?;
        return Ok(Some([decimals(&found.omega, digits + 3), decimals(&found.amplitude, digits + 3)]));
    };
    let line = Line::default().with(Parameter::F, vec![gains.f.clone()]).with(Parameter::G, vec![gains.g.clone()]);
    Ok(looked.peak(&looked.steered(&line)?, looked.car, digits)?.ends(digits))
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    let files = [&arguments.certificate, &arguments.export, &arguments.plot];
    if files.iter().any(|file| file.is_some()) || arguments.response.is_some() {
        let why = "--sweep makes a table only, without --certificate, --export, --plot and --response";
        return Err(CliError::Use(why.to_string()));
    }
    let grid = grid(arguments)?;
    let looked = if is_certified(arguments) { None } else { Some(network::looked(arguments)?) };
    let watch = Watch::with(progress::bar());
    let mut rows = Vec::new();
    for gains in &grid {
        if watch.is_cancelled() {
            break;
        }
        rows.push((gains, row(arguments, looked.as_ref(), gains)?));
        watch.tell("gains", rows.len() as u64, Some(grid.len() as u64));
    }
    watch.finish();
    interrupt::finishing();
    let complete = rows.len() == grid.len();
    if !complete {
        eprintln!("interrupted: {} of {} rows are computed", rows.len(), grid.len());
    }
    let proved = looked.as_ref().is_none_or(network::Looked::is_proved);
    let (grade, word) = if proved { ("certified", "certified") } else { ("simulated", "search, without proof") };
    if arguments.json {
        let configuration = json!({
            "command": "resonance", "graph": arguments.graph, "followers": arguments.followers, "from": arguments.from,
            "to": arguments.to, "ahead": arguments.ahead, "behind": arguments.behind, "f_ahead": arguments.f_ahead,
            "f_behind": arguments.f_behind, "g_ahead": arguments.g_ahead, "g_behind": arguments.g_behind, "sweep": arguments.sweep, "f": arguments.f, "g": arguments.g, "digits": arguments.digits,
        });
        let provenance = Provenance::new("flockproof.resonance-sweep/1", None, configuration);
        let ends = |(lo, hi): &(String, String)| json!({"lo": lo, "hi": hi});
        let row = |(gains, row): &(&Gains<Rational>, Row)| {
            let (f, g) = (gains.f.to_string(), gains.g.to_string());
            let [omega, amplitude] = [0, 1].map(|k| row.as_ref().map(|row| ends(&row[k])));
            json!({"f": f, "g": g, "omega": omega, "amplitude": amplitude})
        };
        let rows: Vec<_> = rows.iter().map(row).collect();
        output::print_json(&provenance.stamp(json!({"grade": grade, "rows": rows})))?;
    } else {
        let mut text = format!(
            "{word}; omega and amplitude rounded down\n{:>12} {:>12} {:>22} {:>22}\n",
            "f", "g", "omega", "amplitude"
        );
        for (gains, row) in &rows {
            let (f, g) = (gains.f.to_string(), gains.g.to_string());
            let (omega, amplitude) = row.as_ref().map_or(("-", "not stable"), |[w, a]| (&w.0, &a.0));
            text += &format!("{f:>12} {g:>12} {omega:>22} {amplitude:>22}\n");
        }
        output::print(&text)?;
    }
    Ok(interrupt::status(complete))
}
