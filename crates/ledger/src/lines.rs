//! Lines of evidence as they are recorded: which there are, how many cases each rests on, and which controls fail through it.

use super::{Entry, Evidence, Scope};
use std::collections::{BTreeMap, VecDeque};

/// The head of the table of recorded evidence.
const HEAD: &str = "id\tpart\tgrade\tscope\tclauses\tcontrols\tcases\tfull";

/// What stands for a line that only the other kind of run has.
const ABSENT: &str = "absent";

/// What stands for a number that no run has given yet; it is no number, so it differs from every one.
const UNKNOWN: &str = "?";

/// One piece of evidence, in the words of the table. Everything but the number of cases is the same in every run.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
struct Line {
    part: String,
    grade: String,
    scope: String,
    clauses: String,
    controls: String,
}

impl Line {
    fn of(evidence: &Evidence) -> Self {
        let clauses: Vec<String> = evidence.clauses.iter().map(usize::to_string).collect();
        let or_dash = |text: String| if text.is_empty() { "-".to_string() } else { text };
        Line {
            part: evidence.part.clone(),
            grade: evidence.grade.word().to_string(),
            scope: evidence.scope.map_or("-", Scope::word).to_string(),
            clauses: or_dash(clauses.join(",")),
            controls: or_dash(evidence.controls.join(",")),
        }
    }

    /// The same for whatever controls.
    fn without_controls(&self) -> Self {
        Line { controls: String::new(), ..self.clone() }
    }

    fn words(&self, cases: &str) -> String {
        let cases = match cases {
            "-" => String::new(),
            number => format!(", cases {number}"),
        };
        let Line { part, grade, scope, clauses, controls } = self;
        format!("\"{part}\" ({grade}, {scope}, clauses {clauses}, controls {controls}{cases})")
    }
}

/// The lines of an entry with their numbers of cases, in order; what was computed beside a proof follows it.
fn lines(entry: &Entry) -> Vec<(Line, String)> {
    let cases = |e: &Evidence| e.cases.map_or("-".to_string(), |cases| cases.to_string());
    let beside = |e: &Evidence| -> Vec<(Line, String)> {
        let part = |step: &Evidence| format!("{}, beside it: {}", e.part, step.part);
        e.steps.iter().map(|step| (Line { part: part(step), ..Line::of(step) }, cases(step))).collect()
    };
    entry.evidence.iter().flat_map(|e| std::iter::once((Line::of(e), cases(e))).chain(beside(e))).collect()
}

/// The recorded lines of one claim.
#[derive(Debug, Clone, Default)]
struct Rows(Vec<(Line, [String; 2])>);

/// The evidence that the claims of a ledger are recorded with: one row for each line, with its number of cases in an ordinary run
/// and in a full one.
#[derive(Debug, Clone, Default)]
pub(super) struct Lines(BTreeMap<String, Rows>);

impl Lines {
    /// Reads what [`Lines::table`] writes; rows of another shape are passed over, and what they recorded is then missed.
    pub fn read(table: &str) -> Self {
        let mut lines = Lines::default();
        for row in table.lines().skip(1) {
            if let [id, part, grade, scope, clauses, controls, cases, full] = row.split('\t').collect::<Vec<_>>()[..] {
                let [part, grade, scope, clauses, controls] = [part, grade, scope, clauses, controls].map(String::from);
                let line = Line { part, grade, scope, clauses, controls };
                lines.0.entry(id.to_string()).or_default().0.push((line, [cases.to_string(), full.to_string()]));
            }
        }
        lines
    }

    /// The table of these entries after an ordinary or a full run. The numbers of the other kind of run stay as they were recorded.
    pub fn table(&self, entries: &[Entry], full: bool) -> String {
        let mut text = format!("{HEAD}\n");
        let (own, other) = (usize::from(full), usize::from(!full));
        for entry in entries {
            let mut before: BTreeMap<Line, VecDeque<(Line, [String; 2])>> = BTreeMap::new();
            for (line, cases) in self.0.get(&entry.id).into_iter().flat_map(|rows| rows.0.clone()) {
                before.entry(line.without_controls()).or_default().push_back((line, cases));
            }
            let mut rows = Vec::new();
            for (line, reached) in lines(entry) {
                let known = before.get_mut(&line.without_controls()).and_then(VecDeque::pop_front);
                let (recorded, mut cases) = known.unwrap_or_else(|| (line.clone(), [UNKNOWN; 2].map(String::from)));
                cases[own] = reached;
                // More cases may refute more controls; those that fail in an ordinary run are recorded.
                rows.push((if full { recorded } else { line }, cases));
            }
            let kept = before.into_values().flatten();
            for (line, mut cases) in kept.filter(|(_, cases)| ![ABSENT, UNKNOWN].contains(&cases[other].as_str())) {
                cases[own] = ABSENT.to_string();
                rows.push((line, cases));
            }
            for (Line { part, grade, scope, clauses, controls }, [cases, full]) in rows {
                let row = [&entry.id, &part, &grade, &scope, &clauses, &controls, &cases, &full].map(String::as_str);
                text += &(row.join("\t") + "\n");
            }
        }
        text
    }

    /// One sentence for each line of an entry that is not recorded so, and for each recorded line that it lacks. Which controls fail in a line of random
    /// cases may depend on the seed and on how many there are, so they are compared `with_controls` only, and in ordinary runs.
    pub fn differences(&self, entry: &Entry, full: bool, with_controls: bool) -> Vec<String> {
        let with_controls = with_controls && !full;
        let same = |a: &Line, b: &Line| {
            (a.controls == b.controls || !with_controls) && a.without_controls() == b.without_controls()
        };
        let mut missed: Vec<(&Line, &str)> = Vec::new();
        if let Some(rows) = self.0.get(&entry.id) {
            let own = rows.0.iter().map(|(line, cases)| (line, cases[usize::from(full)].as_str()));
            missed.extend(own.filter(|(_, cases)| *cases != ABSENT));
        }
        let mut sentences = Vec::new();
        for (line, cases) in &lines(entry) {
            match missed.iter().position(|(recorded, count)| same(recorded, line) && *count == cases.as_str()) {
                Some(at) => drop(missed.remove(at)),
                None => sentences.push(format!("the evidence {} differs from what is recorded", line.words(cases))),
            }
        }
        let lost =
            missed.iter().map(|(line, cases)| format!("the recorded evidence {} was not reached", line.words(cases)));
        sentences.extend(lost);
        sentences
    }
}
