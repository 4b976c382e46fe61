//! Questions of one's own, and campaigns over them and over the built-in invariants, in shards.

use super::convert::count;
use super::refuse;
use super::watch::watched;
use flockproof::arithmetic::{Progress, Rational};
use flockproof::campaign::fuzz::{Attack, Fuzz, Summary};
use flockproof::campaign::invariants::table;
use flockproof::campaign::job::Campaign;
use flockproof::campaign::store::{Shard, merge, run_shard};
use flockproof::campaign::sweep::{Sweep, Table};
use flockproof::graph::AnyGraph;
use flockproof::question::{Given, GivenValue, Question, Value, decide};
use num_bigint::BigInt;
use pyo3::prelude::*;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The contents of the files that a question names.
type Contents = BTreeMap<String, String>;

fn read(text: &str, files: &Contents) -> Result<Question, String> {
    let file = |name: &str| files.get(name).cloned().ok_or_else(|| format!("there is no file `{name}`"));
    Question::read(text, &file).map_err(|error| error.to_string())
}

/// The first file that a question names and that is not among these.
#[pyfunction]
pub fn question_needs(text: &str, files: Contents) -> Option<String> {
    let missing = RefCell::new(None);
    let file = |name: &str| {
        let found = files.get(name).cloned();
        if found.is_none() {
            missing.borrow_mut().get_or_insert_with(|| name.to_string());
        }
        found.ok_or_else(String::new)
    };
    // What else is wrong is told when it is read.
    let _ = Question::read(text, &file);
    missing.into_inner()
}

/// A graph in graph6, or as `edges:N:..` or `arcs:N:..` with its weights and loops.
fn member(graph: &AnyGraph) -> String {
    let plain = graph.simple().filter(|_| graph.is_unweighted() && graph.first_loop().is_none());
    plain.and_then(|graph| graph.graph6()).unwrap_or_else(|| graph.unnamed().to_string())
}

/// A function of a graph of Python's, called with the text of [`member`]; it gives `exact`, `float` or `missing`, a
/// numerator, a denominator, and why there is no value.
fn given(name: String, function: Py<PyAny>) -> Given {
    let measure = move |graph: &AnyGraph| {
        let found = Python::attach(|py| {
            let value = function.bind(py).call1((member(graph),))?;
            value.extract::<(String, BigInt, BigInt, String)>()
        });
        match found {
            Ok((kind, numerator, denominator, _)) if kind != "missing" && denominator != BigInt::ZERO => {
                let value = Rational::new(numerator, denominator);
                if kind == "exact" { GivenValue::Exact(value) } else { GivenValue::Float(value) }
            }
            Ok((.., why)) => GivenValue::Missing(why),
            Err(error) => GivenValue::Missing(error.to_string()),
        }
    };
    Given::new(name, Arc::new(measure))
}

/// The JSON of `check`, its text, and the question of the counterexample.
#[pyfunction]
pub fn check(
    py: Python<'_>,
    text: String,
    files: Contents,
    progress: Option<&Bound<'_, PyAny>>,
    functions: Vec<(String, Py<PyAny>)>,
    counterexamples: &Bound<'_, PyAny>,
    tight: &Bound<'_, PyAny>,
) -> PyResult<(String, String, Option<String>)> {
    let (counterexamples, tight) = (count("counterexamples", counterexamples)?, count("tight", tight)?);
    let functions: Vec<Given> = functions.into_iter().map(|(name, function)| given(name, function)).collect();
    let work = move |watch: &Arc<super::watch::Watch>| {
        let file = |name: &str| files.get(name).cloned().ok_or_else(|| format!("there is no file `{name}`"));
        let mut question = Question::read_with(&text, &file, functions).map_err(|error| error.to_string())?;
        (question.listed_counterexamples, question.listed_tight) = (counterexamples, tight);
        let answer = decide(&question, &**watch).map_err(|error| error.to_string())?;
        Ok::<_, String>((answer.json(None).to_string(), answer.text(None), answer.replay))
    };
    watched(py, progress, work)?.map_err(refuse)
}

/// The graphs of a family such as `connected(8)`, one after the other: in graph6, those with arcs, weights or loops as `arcs:N:..` or `edges:N:..`.
#[pyfunction]
pub fn graphs(py: Python<'_>, family: String, progress: Option<&Bound<'_, PyAny>>) -> PyResult<Vec<String>> {
    let work = move |watch: &Arc<super::watch::Watch>| {
        let quoted = serde_json::Value::from(family.as_str());
        let text = format!("[question]\nid = \"graphs\"\n[for]\ngraph = {quoted}\n[values]\norder = \"edges\"\n");
        let question = read(&text, &Contents::new())?;
        let found = (0..question.cases(&**watch).map_err(|error| error.to_string())?).map(|number| {
            let case = question.case(number, &**watch).map_err(|error| error.to_string())?;
            match case.as_ref().and_then(|case| case.get("graph")) {
                Some(Value::Graph(graph)) => Ok(member(graph)),
                _ => Err("it is no family of graphs".to_string()),
            }
        });
        found.collect::<Result<Vec<String>, String>>()
    };
    watched(py, progress, work)?.map_err(refuse)
}

/// Id and statement of the built-in invariants.
#[pyfunction]
pub fn invariants() -> Vec<(&'static str, &'static str)> {
    table().map(|invariant| (invariant.id, invariant.statement)).collect()
}

/// What a campaign is; the same on every machine.
#[derive(FromPyObject, Clone)]
#[pyo3(from_item_all)]
pub struct Plan {
    /// `sweep`, `attack` (both need a question) or `fuzz`.
    kind: String,
    question: String,
    files: Contents,
    invariants: Vec<String>,
    cases: u64,
    seed: String,
}

impl Plan {
    fn campaign(&self, progress: &dyn Progress) -> Result<Box<dyn Campaign + Send>, String> {
        Ok(match self.kind.as_str() {
            "sweep" => {
                let question = read(&self.question, &self.files)?;
                Box::new(Sweep::new(question, progress).map_err(|error| error.to_string())?)
            }
            "attack" => {
                let question = read(&self.question, &self.files)?;
                Box::new(Attack::new(question, self.cases, &self.seed).map_err(|error| error.to_string())?)
            }
            _ => Box::new(Fuzz::new(&self.invariants, self.cases, &self.seed).map_err(|error| error.to_string())?),
        })
    }
}

/// The canonical text and the number of jobs of a campaign.
#[pyfunction]
pub fn campaign_size(py: Python<'_>, plan: Plan) -> PyResult<(String, u64)> {
    let work = move |watch: &Arc<super::watch::Watch>| {
        let campaign = plan.campaign(&**watch)?;
        Ok::<_, String>((campaign.canonical(), campaign.cases()))
    };
    watched(py, None, work)?.map_err(refuse)
}

/// Runs one shard, or what is missing of it, on so many threads; how many jobs are finished, and of how many.
#[pyfunction]
pub fn campaign_shard(
    py: Python<'_>,
    plan: Plan,
    store: PathBuf,
    index: &Bound<'_, PyAny>,
    of: &Bound<'_, PyAny>,
    resume: bool,
    threads: usize,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<(u64, u64)> {
    let shard: Shard = format!("{}/{}", count("index", index)?, count("of", of)?).parse().map_err(refuse)?;
    let work = move |watch: &Arc<super::watch::Watch>| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().map_err(|error| error.to_string())?;
        let campaign = plan.campaign(&**watch)?;
        let run = pool.install(|| run_shard(&*campaign, &store, shard, resume, &**watch));
        let run = run.map_err(|error| error.to_string())?;
        Ok::<_, String>((run.rows.len() as u64, run.cases))
    };
    watched(py, progress, work)?.map_err(refuse)
}

/// Puts the shards of a folder together; the text that is written, the same for any number of shards.
#[pyfunction]
pub fn campaign_merge(py: Python<'_>, store: PathBuf) -> PyResult<String> {
    watched(py, None, move |_| merge(&store).map(|merged| merged.text()))?.map_err(refuse)
}

/// The finished table of a sweep as JSON lines, CSV and text, with the names of the family and of the quantities.
#[pyfunction]
pub fn sweep_table(py: Python<'_>, store: PathBuf) -> PyResult<(String, String, String, Vec<String>, Vec<String>)> {
    let table = watched(py, None, move |_| {
        let merged = merge(&store).map_err(|error| error.to_string())?;
        Table::new(&merged.header.campaign, &merged.rows).map_err(|error| error.to_string())
    })?;
    let table = table.map_err(refuse)?;
    let csv = table.csv().map_err(refuse)?;
    Ok((table.json_lines(), csv, table.text(40, 80), table.names.clone(), table.columns.clone()))
}

/// The JSON summary of a campaign of `fuzz` with its questions of counterexamples by invariant and case.
#[pyfunction]
pub fn fuzz_summary(py: Python<'_>, store: PathBuf) -> PyResult<(String, Vec<(String, u64, Option<String>)>)> {
    watched(py, None, move |_| summary(&store))?.map_err(refuse)
}

fn summary(store: &Path) -> Result<(String, Vec<(String, u64, Option<String>)>), String> {
    let merged = merge(store).map_err(|error| error.to_string())?;
    let summary = if let Some((id, seed)) = Attack::named(&merged.header.campaign) {
        Summary::new(&[&id], &seed, merged.header.cases, &merged.rows)
    } else {
        let fuzz = Fuzz::read(&merged.header.campaign).map_err(|error| error.to_string())?;
        Summary::new(&fuzz.names(), fuzz.seed(), merged.header.cases, &merged.rows)
    };
    let summary = summary.map_err(|error| error.to_string())?;
    let failures = summary.invariants.iter().flat_map(|own| own.failures.iter().map(move |f| (own, f)));
    let failures = failures.map(|(own, failed)| (own.id.clone(), failed.case, failed.question.clone())).collect();
    Ok((summary.to_json().to_string(), failures))
}
