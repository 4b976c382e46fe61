//! The ledger of the papers, and the judge for claims that are written in Python.

use super::convert::optional_count;
use super::refuse;
use super::watch::watched;
use flockproof::ledger::{
    CheckError, Claim, Correction, Evidence, Fault, Form, Grade, Ledger, LedgerError, Options, Outcome, Report, Run,
    Scope, Source, Verdict, to_json, to_json_with,
};
use flockproof::report::{explain as explained, ledger_origin, not_found, summary, verdict_table};
use pyo3::prelude::*;
use serde_json::Value;
use std::collections::BTreeMap;

type Row = (String, String, String, String, String, String, String);

fn ledger() -> PyResult<Ledger> {
    flockproof::claims::ledger().map_err(refuse)
}

/// Id, place, statement, recorded verdict, fault, reach and grades of every claim, sorted by id.
#[pyfunction]
pub fn claims() -> PyResult<Vec<Row>> {
    let ledger = ledger()?;
    let known: BTreeMap<_, _> = ledger.recorded().map(|row| (row.id, row)).collect();
    let row = |id: &str| {
        let source = ledger.source(id);
        let (place, statement) = source.map_or_else(Default::default, |s| (s.place.clone(), s.statement.clone()));
        let (verdict, fault, reach, grades) =
            known.get(id).map_or(("", "-", "", ""), |row| (row.verdict, row.fault, row.reach, row.grades));
        let words = [verdict, fault, reach, grades].map(str::to_string);
        let [verdict, fault, reach, grades] = words;
        (id.to_string(), place, statement, verdict, fault, reach, grades)
    };
    Ok(ledger.ids().map(row).collect())
}

/// The JSON document, what differs from the record, what is missing, the table, and the derivations by id.
type Found = (String, Vec<String>, Vec<String>, String, Vec<(String, String)>);

fn found(report: &Report, json: String) -> Found {
    let table = format!("{}\n{}", verdict_table(&report.entries), summary(report));
    let derivations = report.entries.iter().map(|e| (e.id.clone(), e.derivation.clone())).collect();
    (json, report.differences.clone(), report.missing.clone(), table, derivations)
}

/// Checks claims of the papers.
#[pyfunction]
pub fn verify(
    py: Python<'_>,
    papers: Vec<String>,
    claims: Vec<String>,
    seed: String,
    full: bool,
    threads: Option<&Bound<'_, PyAny>>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Found> {
    let ledger = ledger()?;
    let ids = ledger.select(&papers, &claims).map_err(|error| unknown(&ledger, error))?;
    let mut options = Options { seed, full, ..Options::default() };
    if let Some(threads) = optional_count("threads", threads)? {
        if !(1..=1024).contains(&threads) {
            return Err(refuse(format!("threads must lie between 1 and 1024, but it is {threads}")));
        }
        options.threads = threads as usize;
    }
    let more = ledger_origin(&papers, &claims, &options);
    watched(py, progress, move |watch| {
        options.progress = watch.clone();
        let report = ledger.verify(&ids, &options, |_| {});
        found(&report, to_json_with(&report, &options, more))
    })
}

/// A wrong id or paper, with the ids that may be meant.
fn unknown(ledger: &Ledger, error: LedgerError) -> PyErr {
    refuse(not_found(ledger, &[], &error))
}

/// One claim in words.
#[pyfunction]
pub fn explain(py: Python<'_>, id: String, width: usize) -> PyResult<String> {
    let ledger = ledger()?;
    let ids = ledger.select(&[], std::slice::from_ref(&id)).map_err(|error| unknown(&ledger, error))?;
    watched(py, None, move |watch| {
        let options = Options { progress: watch.clone(), ..Options::default() };
        let report = ledger.verify(&ids, &options, |_| {});
        report.entries.iter().map(|entry| explained(entry, &ledger, width)).collect()
    })
}

/// Judges claims whose forms were all examined already: a list of objects as `python/flockproof/claims` writes them. The first
/// four are as in [`verify`]; then the explanations by id.
#[pyfunction]
pub fn judge(py: Python<'_>, document: &str, seed: String) -> PyResult<Found> {
    let document: Value = serde_json::from_str(document).map_err(refuse)?;
    let options = Options { seed, threads: 1, ..Options::default() };
    let claims: Vec<Examined> =
        document.as_array().into_iter().flatten().map(Examined::read).collect::<Result<_, _>>().map_err(refuse)?;
    watched(py, None, move |_| judged(claims, &options))?.map_err(refuse)
}

fn judged(claims: Vec<Examined>, options: &Options) -> Result<Found, LedgerError> {
    let mut ledger = Ledger::new();
    let mut expected = Vec::new();
    let mut corrected = Vec::new();
    for claim in claims {
        expected.extend(claim.expected.clone().map(|(verdict, grades)| (claim.id.clone(), verdict, grades)));
        corrected.extend(claim.correction.is_some().then(|| claim.id.clone()));
        ledger.register(claim)?;
    }
    ledger.register_corrections(|id| corrected.iter().any(|known| known == id))?;
    let ids: Vec<String> = ledger.ids().map(str::to_string).collect();
    let first = ledger.verify(&ids, options, |_| {});
    // What nobody recorded is compared with nothing but the rules.
    for entry in &first.entries {
        ledger.expect(&entry.id, entry.verdict, &entry.grades());
    }
    for (id, verdict, grades) in expected {
        ledger.expect(&id, verdict, &grades);
    }
    let report = ledger.verify(&ids, options, |_| {});
    let explanations = report.entries.iter().map(|e| (e.id.clone(), explained(e, &ledger, 80))).collect();
    let (json, differences, missing, table, _) = found(&report, to_json(&report, options));
    Ok((json, differences, missing, table, explanations))
}

/// A claim with what its check said of each form.
struct Examined {
    id: String,
    place: String,
    statement: String,
    derivation: String,
    clauses: Vec<String>,
    reading: Option<String>,
    correction: Option<Correction>,
    alterations: Vec<String>,
    expected: Option<(Verdict, Vec<Grade>)>,
    printed: Value,
    corrected: Value,
    controls: Vec<Value>,
}

fn text(value: &Value, key: &str) -> Result<String, String> {
    value[key].as_str().map(str::to_string).ok_or_else(|| format!("`{key}` should be a text"))
}

fn texts(value: &Value) -> Vec<String> {
    value.as_array().into_iter().flatten().filter_map(|x| x.as_str().map(str::to_string)).collect()
}

impl Examined {
    fn read(value: &Value) -> Result<Self, String> {
        let correction = match &value["correction"] {
            Value::Null => None,
            repair => Some(Correction {
                fault: fault(&text(repair, "fault")?)?,
                statement: text(repair, "statement")?,
                clauses: texts(&repair["clauses"]),
            }),
        };
        let expected = match value["expected"].as_str() {
            None => None,
            Some(verdict) => {
                let grades = texts(&value["expected_grades"]);
                Some((self::verdict(verdict)?, grades.iter().map(|g| grade(g)).collect::<Result<_, _>>()?))
            }
        };
        let controls = || value["controls"].as_array().into_iter().flatten();
        Ok(Examined {
            id: text(value, "id")?,
            place: text(value, "place")?,
            statement: text(value, "statement")?,
            derivation: text(value, "derivation")?,
            clauses: texts(&value["clauses"]),
            reading: value["reading"].as_str().map(str::to_string),
            correction,
            alterations: controls().map(|control| text(control, "what")).collect::<Result<_, _>>()?,
            expected,
            printed: value["printed"].clone(),
            corrected: value["corrected"].clone(),
            controls: controls().map(|control| control["outcome"].clone()).collect(),
        })
    }
}

fn one_of<T: Copy>(what: &str, word: &str, all: &[T], name: fn(T) -> &'static str) -> Result<T, String> {
    all.iter().copied().find(|x| name(*x) == word).ok_or_else(|| {
        let known: Vec<&str> = all.iter().map(|x| name(*x)).collect();
        format!("{what}: `{word}` is none of {}", known.join(", "))
    })
}

fn fault(word: &str) -> Result<Fault, String> {
    one_of("fault", word, &[Fault::Hypothesis, Fault::Typo, Fault::Slip, Fault::False], Fault::word)
}

fn verdict(word: &str) -> Result<Verdict, String> {
    one_of("expected", word, &Verdict::ALL, Verdict::word)
}

fn grade(word: &str) -> Result<Grade, String> {
    // Kernel is for what Coq says; Python does not ask it. Identities come from questions.
    let all: Vec<Grade> = Grade::ALL.into_iter().filter(|grade| !matches!(grade, Grade::Kernel)).collect();
    one_of("grade", word, &all, Grade::word)
}

fn evidence(value: &Value) -> Result<Evidence, String> {
    let mut evidence = Evidence::new(grade(&text(value, "grade")?)?, text(value, "part")?, text(value, "detail")?);
    let clauses = value["clauses"].as_array().into_iter().flatten().filter_map(Value::as_u64);
    evidence = evidence.on(clauses.map(|k| k as usize).collect::<Vec<_>>());
    if value["scope"] == "all" {
        evidence.scope = Some(Scope::All);
    }
    evidence.cases = value["cases"].as_u64();
    Ok(evidence)
}

fn outcome(value: &Value) -> Result<Outcome, CheckError> {
    let support = || -> Result<Vec<Evidence>, CheckError> {
        let list = value["evidence"].as_array().into_iter().flatten();
        list.map(evidence).collect::<Result<_, _>>().map_err(CheckError::Other)
    };
    let why = || value["why"].as_str().unwrap_or_default().to_string();
    match value["outcome"].as_str() {
        Some("holds") => Ok(Outcome::Holds(support()?)),
        Some("fails") => Ok(Outcome::failure(why(), support()?)),
        Some("undecided") => Ok(Outcome::Undecided(why())),
        Some("not_checkable") => Ok(Outcome::NotCheckable(why(), support()?)),
        _ => Err(CheckError::Other(why())),
    }
}

impl Claim for Examined {
    fn id(&self) -> &str {
        &self.id
    }

    fn source(&self) -> Option<Source> {
        Some(Source { place: self.place.clone(), statement: self.statement.clone() })
    }

    fn derivation(&self) -> &str {
        &self.derivation
    }

    fn clauses(&self) -> Vec<String> {
        self.clauses.clone()
    }

    fn reading(&self) -> Option<String> {
        self.reading.clone()
    }

    fn correction(&self) -> Option<Correction> {
        self.correction.clone()
    }

    fn alterations(&self) -> Vec<&str> {
        self.alterations.iter().map(String::as_str).collect()
    }

    fn examine(&self, form: Form, run: &mut Run) -> Result<Outcome, CheckError> {
        let examined = match form {
            Form::Printed => &self.printed,
            Form::Corrected => &self.corrected,
            Form::Control(k) => self.controls.get(k).unwrap_or(&Value::Null),
        };
        for (name, number) in examined["values"].as_object().into_iter().flatten() {
            run.value(name, number.as_str().unwrap_or_default());
        }
        outcome(examined)
    }
}
