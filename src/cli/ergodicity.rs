//! `ergodicity`: products of a sequence of stochastic matrices.

use super::{CliError, certify, interrupt, output, progress};
use flockproof::arithmetic::Rational;
use flockproof::certificates::{Certificate, Product};
use flockproof::matrix::{
    Footprint, Stabiliser, StochasticMatrix, prefix_products,
    read::{Normalised, read_normalised, read_sequence},
    stabilisers, tau_2_squared,
};
use flockproof::report::Provenance;
use num_traits::ToPrimitive;
use rayon::prelude::*;
use serde_json::json;
use std::path::PathBuf;
use std::process::ExitCode;

#[derive(clap::Args)]
#[command(after_help = "Example:\n  flockproof ergodicity assets/two_matrices.txt --json")]
pub struct Arguments {
    /// Matrices, the first factor P(1) first: text (rows on lines, a blank line between matrices) or JSON
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// Print one JSON document, flockproof.ergodicity/1
    #[arg(long)]
    json: bool,
    /// Divide each row by its sum, for matrices of floats; what was changed is told
    #[arg(long)]
    normalise: bool,
    /// Write tau_1 of the whole product as a certificate, see proofs_checks/README.md
    #[arg(long, value_name = "OUT")]
    certificate: Option<PathBuf>,
}

struct Prefix {
    tau_1: Rational,
    tau_2_squared: Rational,
    footprint: Footprint,
}

impl Prefix {
    fn of(product: &StochasticMatrix) -> Self {
        Prefix {
            tau_1: product.tau_1(),
            tau_2_squared: tau_2_squared(&product.to_rational_matrix()),
            footprint: product.footprint(),
        }
    }
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    certify::check_asked(arguments.certificate.as_deref())?;
    let input = output::read_input(&arguments.file)?;
    let (factors, changed) = factors(arguments, &input.text)?;
    let changed = changes(&changed);
    certify::write_asked(arguments.certificate.as_deref(), || Ok(Certificate::Product(Product::new(&factors)?)))?;
    let work = factors.clone();
    let made = interrupt::results(move |sender| {
        // Each product needs the one before; what is measured of them does not.
        let mut products = prefix_products(&work).peekable();
        let mut count = 1;
        while products.peek().is_some() {
            let some: Vec<_> = products.by_ref().take(count).collect();
            count = (2 * count).min(2 * rayon::current_num_threads());
            let measure = |prefix: Result<StochasticMatrix, _>| prefix.map(|prefix| (Prefix::of(&prefix), prefix));
            let measured: Vec<_> = some.into_par_iter().map(measure).collect();
            if measured.into_iter().any(|measured| sender.send(measured).is_err()) {
                break;
            }
        }
    });
    let mut prefixes = Vec::with_capacity(factors.len());
    let mut product = None;
    let bar = progress::bar();
    bar.set_length(factors.len() as u64);
    bar.set_message("products");
    for prefix in made {
        bar.inc(1);
        let (measured, prefix) = prefix.map_err(|error| CliError::file(&arguments.file, error))?;
        prefixes.push(measured);
        product = Some(prefix);
    }
    bar.finish_and_clear();
    interrupt::finishing();
    let complete = prefixes.len() == factors.len();
    if !complete {
        eprintln!("interrupted: {} of {} products are finished", prefixes.len(), factors.len());
    }
    let factors = &factors[..prefixes.len()];
    let square = factors.iter().all(|m| m.rows() == m.cols());
    let found = if square {
        stabilisers(&factors.iter().map(StochasticMatrix::footprint).collect::<Vec<_>>())
    } else {
        Vec::new()
    };
    let Some(product) = product else { return Ok(interrupt::status(complete)) };
    if arguments.json {
        let configuration = json!({"command": "ergodicity", "file": input.origin, "normalise": arguments.normalise});
        let provenance = Provenance::new("flockproof.ergodicity/1", None, configuration);
        let mut document = document(&product, &prefixes, &found);
        if arguments.normalise {
            document["changed"] = json!(changed);
        }
        output::print_json(&provenance.stamp(document))?;
    } else {
        let changed: String = changed.iter().map(|line| format!("{line}\n")).collect();
        output::print(&(changed + &table(&product, &prefixes, &found)))?;
    }
    Ok(interrupt::status(complete))
}

/// The matrices of a file, and the rows that were changed.
fn factors(arguments: &Arguments, text: &str) -> Result<(Vec<StochasticMatrix>, Vec<Normalised>), CliError> {
    let found = match arguments.normalise {
        true => read_normalised(text),
        false => read_sequence(text).map(|factors| (factors, Vec::new())),
    };
    found.map_err(|error| {
        let sentence = error.to_string();
        let advice = if sentence.contains("sums to") && !arguments.normalise {
            "; --normalise divides each row by its sum"
        } else {
            ""
        };
        CliError::file(&arguments.file, sentence + advice)
    })
}

/// What was changed, a line for each of the first rows.
fn changes(changed: &[Normalised]) -> Vec<String> {
    const MOST: usize = 20;
    let line = |row: &Normalised| {
        let excess = (&row.sum - Rational::from_integer(1.into())).to_f64().unwrap_or(f64::NAN);
        format!("matrix {}, row {}: divided by its sum, 1 {excess:+.3e}", row.matrix, row.row)
    };
    let mut lines: Vec<String> = changed.iter().take(MOST).map(line).collect();
    if changed.len() > MOST {
        lines.push(format!("and {} more rows", changed.len() - MOST));
    }
    lines
}

fn members(stabiliser: &Stabiliser) -> Vec<usize> {
    stabiliser.members.iter().map(|i| i + 1).collect()
}

fn document(product: &StochasticMatrix, prefixes: &[Prefix], found: &[Stabiliser]) -> serde_json::Value {
    let rows = product.to_rational_matrix().to_rows();
    let rows: Vec<Vec<String>> = rows.iter().map(|row| row.iter().map(ToString::to_string).collect()).collect();
    let prefixes: Vec<serde_json::Value> = prefixes
        .iter()
        .enumerate()
        .map(|(k, p)| {
            json!({
                "t": k + 1,
                "tau_1": p.tau_1.to_string(),
                "tau_2_squared": p.tau_2_squared.to_string(),
                "footprint": p.footprint.to_string(),
            })
        })
        .collect();
    let found: Vec<serde_json::Value> = found.iter().map(|s| json!({"time": s.time, "members": members(s)})).collect();
    json!({"product": rows, "prefixes": prefixes, "stabilisers": found})
}

fn table(product: &StochasticMatrix, prefixes: &[Prefix], found: &[Stabiliser]) -> String {
    let float = |x: &Rational| x.to_f64().unwrap_or(f64::NAN);
    let mut text = format!(
        "P(t,1) = P(t) ... P(1) of {} factors, computed exactly; the decimals are rounded\n{:>6} {:>22} {:>22} {:>9}  footprint\n",
        prefixes.len(),
        "t",
        "tau_1",
        "tau_2",
        "ones"
    );
    const WIDEST_FOOTPRINT: usize = 24;
    for (k, p) in prefixes.iter().enumerate() {
        let footprint = p.footprint.to_string();
        let ones = footprint.matches('1').count();
        let shown = if footprint.len() > WIDEST_FOOTPRINT { String::new() } else { footprint };
        text.push_str(&format!(
            "{:>6} {:>22.15e} {:>22.15e} {ones:>9}  {shown}\n",
            k + 1,
            float(&p.tau_1),
            float(&p.tau_2_squared).sqrt()
        ));
    }
    if let Some(last) = prefixes.last() {
        let exact = last.tau_1.to_string();
        if exact.len() <= 60 {
            text.push_str(&format!("tau_1 of the whole product: {exact}\n"));
        }
    }
    // That of the factors one after the other is not the least one.
    let least = product.to_rational_matrix().reduced();
    text.push_str(&format!("least common denominator of the product: {} bits\n", least.denominator().bits()));
    for (k, s) in found.iter().enumerate() {
        let list: Vec<String> = members(s).iter().map(ToString::to_string).collect();
        text.push_str(&format!("stabiliser V_{} = {{{}}} from T_{} = {}\n", k + 1, list.join(", "), k + 1, s.time));
    }
    text
}
