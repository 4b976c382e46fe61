//! What is said about a question: verdict, evidence, counterexample, in words and as JSON.

use crate::bindings::Bindings;
use crate::decisive::Decisive;
use crate::error::QuestionError;
use crate::made::{Made, MadeControl};
use crate::members::{Listed, Member};
use crate::names::Subject;
use crate::outcome::{Outcome, Spot, Unsettled};
use crate::question::Question;
use crate::scenario_file::is_place;
use crate::shrink::Shrunk;
use crate::syntax::Kind;
use crate::truth::{Margin, Truth};
use algebra::graph::LaplacianKind;
use arithmetic::Progress;
use models::platoon::Communication;
pub use motion::sets::Verdict;
use polynomials::sums::Certificate;
use serde_json::{Map, json};
use std::fmt::Write;

/// A question with its verdict.
#[derive(Debug, Clone)]
pub struct Answer {
    /// The id of the question.
    pub id: String,
    /// The verdict.
    pub verdict: Verdict,
    /// Grades of the evidence.
    pub grades: Vec<&'static str>,
    /// The counterexample, simplified.
    pub counterexample: Option<Bindings>,
    /// The inequality that fails there, with the values of its sides; `None` where no inequality decides.
    pub decisive: Option<Decisive>,
    /// A weaker property that fails there already, because it looks at shorter times; `None` where there is none.
    pub shorter: Option<String>,
    /// A question of this one instance, as the text of a file; `None` where there is no counterexample, or the question is that already.
    pub replay: Option<String>,
    /// Encloses the smallest margin of all cases that were looked at; of a property that is false, the margin at the counterexample.
    pub margin: Option<Margin>,
    /// A point at which the margin is 0, where the property holds on a continuum.
    pub attained: Option<Spot>,
    /// A counterexample with a number in closed form, which no file can say; `None` where there is one of rationals.
    pub closed: Option<Spot>,
    /// Sums of squares that `holds` rests on, for the separate checker.
    pub certificates: Vec<Certificate>,
    /// Parts of the property that were proved without one.
    pub uncertified: u64,
    /// What is open of a continuum.
    pub unsettled: Option<Unsettled>,
    /// More counterexamples, where they were asked for.
    pub counterexamples: Option<Listed>,
    /// Members at which an inequality of the property is an equation, where they were asked for.
    pub tight: Option<Listed>,
    /// The same of each inequality of the property by itself, under the time operators around it; `None` where it was nowhere compared.
    pub inequalities: Vec<(String, Option<Margin>)>,
    /// Whether the smallest margin is the smallest one of these.
    is_conjunction: bool,
    /// Members, or boxes of them, that were looked at.
    pub cases: u64,
    /// Those that stayed undecided.
    pub undecided: u64,
    /// For each control whether it was refuted.
    pub controls: Vec<bool>,
    /// The controls where the program made them itself, because the question has none.
    pub made: Option<Made>,
    /// The reason of the verdict, one sentence or two.
    pub why: String,
}

impl Answer {
    pub(crate) fn judged(
        question: &Question,
        verdict: Verdict,
        outcome: Outcome,
        shrunk: Option<(Shrunk, String)>,
        refuted: &[bool],
    ) -> Self {
        let enclosed = question.subjects().contains(&Subject::Motion);
        let grades = match (verdict, outcome.boxed) {
            (Verdict::Holds, true) => vec!["certified"],
            (Verdict::Holds, false) if enclosed => vec!["exhaustive", "certified"],
            (Verdict::Holds, false) => vec!["exhaustive"],
            (Verdict::False, _) => vec![if question.is_exact() { "exact" } else { "certified" }],
            (Verdict::Undecided, _) if question.is_sample() => vec!["fuzzed"],
            _ => vec![],
        };
        let (found, margin, margins) = match verdict {
            Verdict::Withheld => (None, None, &[][..]),
            _ => (shrunk, outcome.margin, &outcome.inequalities[..]),
        };
        let nodes = question.property.iter().flat_map(|property| &property.inequalities);
        let inequalities = nodes.enumerate().map(|(k, node)| (node.to_string(), margins.get(k).copied())).collect();
        let why = reason(verdict, &outcome, refuted);
        let (counterexample, shorter, replay) = match found {
            None => (None, None, None),
            Some((simpler, replay)) => {
                let own = simpler.property.node.to_string();
                let shorter = question.property.as_ref().is_some_and(|whole| whole.node.to_string() != own);
                let alone = outcome.total == 1 && !outcome.boxed && !shorter;
                (Some(simpler.bindings), shorter.then_some(own), (!alone).then_some(replay))
            }
        };
        Answer {
            id: question.id().to_string(),
            verdict,
            grades,
            counterexample,
            decisive: None,
            shorter,
            replay,
            margin,
            attained: outcome.attained.filter(|_| verdict == Verdict::Holds),
            closed: outcome.closed.filter(|_| verdict == Verdict::False),
            certificates: if verdict == Verdict::Holds { outcome.certificates } else { Vec::new() },
            uncertified: outcome.uncertified,
            unsettled: outcome.unsettled.filter(|_| verdict == Verdict::Undecided),
            inequalities,
            is_conjunction: question.property.as_ref().is_some_and(|whole| matches!(whole.node.kind, Kind::And(_))),
            cases: outcome.cases,
            undecided: outcome.open,
            controls: refuted.to_vec(),
            made: None,
            counterexamples: None,
            tight: None,
            why,
        }
    }

    /// What rests on functions that gave floating-point numbers is no proof, either way.
    pub(crate) fn without_floats(&mut self, names: &[&str]) {
        if names.is_empty() || matches!(self.verdict, Verdict::Withheld | Verdict::Undecided) {
            return;
        }
        let listed = names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(" and ");
        let found = if self.verdict == Verdict::Holds { "hold" } else { "fail" };
        self.why = format!(
            "{listed} gave floating-point numbers; taken as exact they make the property {found}, which proves nothing. {}",
            self.why
        );
        (self.verdict, self.grades) = (Verdict::Undecided, vec!["simulated"]);
    }

    /// The document `flockproof.check/1`; `replay` is the file where the counterexample was written.
    pub fn json(&self, replay: Option<&str>) -> serde_json::Value {
        let named = |bindings: &Bindings| {
            let pairs = bindings.iter().map(|(name, value)| (name.to_string(), json!(value.text())));
            serde_json::Value::Object(pairs.collect::<Map<_, _>>())
        };
        let spot = |own: &Spot| {
            let pairs = own.iter().map(|(name, text)| (name.to_string(), json!(text)));
            serde_json::Value::Object(pairs.collect::<Map<_, _>>())
        };
        let enclosed =
            |margin: Option<&Margin>| margin.and_then(Margin::decimals).map(|(lo, hi)| json!({"lo": lo, "hi": hi}));
        let sides = |own: &Decisive| json!({"inequality": own.inequality, "left": own.left, "right": own.right, "time": own.time});
        let own = |(text, margin): &(String, Option<Margin>)| json!({"inequality": text, "margin": enclosed(margin.as_ref())});
        let member = |own: &Member| {
            let decisive = own.decisive.as_ref().map(sides);
            json!({"member": named(&own.bindings), "decisive": decisive, "margin": enclosed(Some(&own.margin))})
        };
        let listed = |list: &Listed| json!({"what": list.what, "members": list.members.iter().map(member).collect::<Vec<_>>(), "cut": list.cut});
        let mut document = json!({
            "schema": "flockproof.check/1",
            "id": self.id,
            "verdict": self.verdict.word(),
            "grades": self.grades,
            "counterexample": self.counterexample.as_ref().map(named).or(self.closed.as_ref().map(spot)),
            "decisive": self.decisive.as_ref().map(sides),
            "replay": replay,
            "margin": enclosed(self.margin.as_ref()),
            "attained": self.attained.as_ref().map(spot),
            "open": self.unsettled.as_ref().map(|open| json!({"share": open.share.map(|share| format!("~{share:.3e}")), "boxes": open.boxes.iter().map(named).collect::<Vec<_>>()})),
            "inequalities": self.inequalities.iter().map(own).collect::<Vec<_>>(),
            "cases": self.cases,
            "undecided": self.undecided,
            "controls": {"refuted": self.refuted(), "total": self.controls.len(), "made": self.made.is_some()},
            "why": self.why,
        });
        if let Some(Made { controls, why_none, .. }) = &self.made {
            document["controls"]["what"] = controls.iter().map(|own| json!(own.property)).collect();
            document["controls"]["fails_at"] = controls.iter().map(|own| named(&own.fails_at)).collect();
            document["controls"]["why_none"] = json!(why_none);
        }
        for (key, list) in [("counterexamples", &self.counterexamples), ("tight", &self.tight)] {
            if let Some(list) = list {
                document[key] = listed(list);
            }
        }
        document
    }

    fn refuted(&self) -> usize {
        self.controls.iter().filter(|refuted| **refuted).count()
    }

    /// A few plain sentences.
    pub fn text(&self, replay: Option<&str>) -> String {
        let mut text = format!("{}: {}", self.id, self.verdict.word());
        if !self.grades.is_empty() {
            let _ = write!(text, " ({})", self.grades.join(", "));
        }
        let _ = write!(text, "\n{}\n", self.why);
        if let Some(bindings) = self.counterexample.as_ref().filter(|bindings| bindings.iter().next().is_some()) {
            let _ = writeln!(text, "counterexample: {bindings}");
        }
        if let Some(spot) = &self.closed {
            let how = if spot.is_enclosed() { "at one point in it, which is proved" } else { "exactly" };
            let _ = writeln!(text, "counterexample: {spot}, {how}");
        }
        if let Some(Decisive { inequality, left, right, time, .. }) = &self.decisive {
            let at = time.as_ref().map_or(String::new(), |time| format!(", at t = {time}"));
            let _ = writeln!(text, "there {inequality} has {left} on its left and {right} on its right{at}");
        }
        if let Some(shorter) = &self.shorter {
            let _ = writeln!(text, "fails already: {shorter}");
        }
        let between = |margin: Option<&Margin>| {
            let (lo, hi) = margin.and_then(Margin::decimals)?;
            Some(if lo == hi { format!("= {lo}") } else { format!("in [{lo}, {hi}]") })
        };
        if let Some(between) = between(self.margin.as_ref()) {
            let at = self.attained.as_ref().map_or(String::new(), |at| format!(" at ({at})"));
            let what = if self.verdict == Verdict::False { "margin there" } else { "smallest margin" };
            let _ = writeln!(text, "{what} {between}{at}");
        } else if let Some(between) = between(self.decisive.as_ref().map(|own| &own.margin)) {
            // Not all of the property was looked at.
            let _ = writeln!(text, "margin of that inequality {between}");
        }
        let several = self.is_conjunction && self.inequalities.len() > 1;
        for (inequality, margin) in self.inequalities.iter().filter(|_| several) {
            if let Some(between) = between(margin.as_ref()) {
                let _ = writeln!(text, "  of {inequality}: {between}");
            }
        }
        match &self.made {
            None => {
                let _ = writeln!(text, "controls refuted: {} of {}", self.refuted(), self.controls.len());
            }
            Some(Made { why_none: Some(why), .. }) => {
                let _ = writeln!(text, "no control could be made by the program: {why}");
            }
            Some(Made { controls, .. }) => {
                let _ = writeln!(text, "controls made by the program, all refuted: {}", controls.len());
                for MadeControl { property, fails_at } in controls {
                    let is_somewhere = fails_at.iter().next().is_some();
                    let at = if is_somewhere { format!("; fails at {fails_at}") } else { String::new() };
                    let _ = writeln!(text, "  {property}{at}");
                }
            }
        }
        let lists = [("counterexamples", &self.counterexamples), ("members with equality", &self.tight)];
        for (what, list) in lists.into_iter().filter_map(|(what, list)| Some((what, list.as_ref()?))) {
            let more = if list.cut { ", and there are more" } else { "" };
            let _ = writeln!(text, "{what}: {}{more}", list.members.len());
            for Member { bindings, decisive, margin } in &list.members {
                let sides =
                    decisive.as_ref().map(|own| format!("; {}: {} and {}", own.inequality, own.left, own.right));
                let own = || between(decisive.as_ref().map(|own| &own.margin));
                let margin = between(Some(margin)).or_else(own).map(|between| format!("; margin {between}"));
                let _ = writeln!(text, "  {bindings}{}{}", sides.unwrap_or_default(), margin.unwrap_or_default());
            }
        }
        if let Some(file) = replay {
            let _ = writeln!(text, "replay: flockproof check {file}");
        }
        text
    }
}

fn counted(count: u64, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

fn reason(verdict: Verdict, outcome: &Outcome, refuted: &[bool]) -> String {
    let unit = if outcome.boxed { "box" } else { "case" };
    let looked = if outcome.boxed && outcome.cases != 1 {
        format!("{} boxes", outcome.cases)
    } else {
        counted(outcome.cases, unit)
    };
    match verdict {
        Verdict::Withheld => {
            let kept: Vec<String> =
                refuted.iter().zip(1..).filter(|(refuted, _)| !**refuted).map(|(_, k)| k.to_string()).collect();
            let plural = if kept.len() == 1 { "control" } else { "controls" };
            format!(
                "{plural} {} could not be refuted, so that the check is not seen to bite and no verdict is given.",
                kept.join(", ")
            )
        }
        Verdict::Holds if outcome.boxed => {
            format!("The property is proved for the whole family: {looked}.")
        }
        Verdict::Holds => format!("The property is proved for all members of the family: {looked}."),
        Verdict::False => format!(
            "The property fails for a member of the family, found after {looked} and confirmed on exact or enclosed numbers."
        ),
        Verdict::Undecided => {
            let doubt = match &outcome.truth {
                Truth::Unknown(doubt) => Some(&doubt.why),
                _ => None,
            };
            match doubt {
                Some(why) => format!("{} of {looked} stayed undecided: {why}.", outcome.open),
                None => format!("No counterexample among {}; a sample proves nothing for all.", outcome.cases),
            }
        }
    }
}

impl Question {
    /// A question of one instance, as the text of a file. Its controls are those of this question that fail there, too, if there are any.
    pub(crate) fn replay(&self, found: &Shrunk, progress: &dyn Progress) -> Result<String, QuestionError> {
        let quoted = |text: &str| serde_json::Value::from(text).to_string();
        let mut text = format!("[question]\nid = {}\n", quoted(&format!("{}.counterexample", self.id())));
        if let Some(statement) = self.statement() {
            let _ = writeln!(text, "statement = {}", quoted(statement));
        }
        if self.kind() != LaplacianKind::Combinatorial {
            let _ = writeln!(text, "kind = {}", quoted(self.kind().name()));
        }
        if self.communication() == Communication::Front {
            let _ = writeln!(text, "communication = \"front\"");
        }
        if let Some(scenario) = self.scenario() {
            let _ = writeln!(text, "scenario = {}", quoted(&scenario.name));
        }
        if let Some(law) = self.law_name() {
            let _ = writeln!(text, "law = {}", quoted(law));
        }
        let property = found.property.node.to_string();
        let (mut controls, mut nodes) = (Vec::new(), vec![&found.property.node]);
        for control in &self.controls {
            // One that makes no sense there is no control there.
            let judged = self.decide_point(control, &found.bindings, progress);
            if let Err(QuestionError::Cancelled(cancelled)) = judged {
                return Err(cancelled.into());
            }
            let same = control.node.to_string() == property;
            if !same && judged.is_ok_and(|judged| judged.truth == Truth::False) {
                controls.push(quoted(&control.node.to_string()));
                nodes.push(&control.node);
            }
        }
        let _ = writeln!(text, "\n[for]");
        // Names that only made others are not needed here.
        for (name, value) in found.bindings.iter().filter(|(name, _)| self.law().is_some() || self.uses(&nodes, name)) {
            let key = if is_place(name) { quoted(name) } else { name.to_string() };
            let _ = writeln!(text, "{key} = {}", quoted(&value.text()));
        }
        let _ = writeln!(text, "\n[holds]\nproperty = {}", quoted(&property));
        // Without any, those of the replay are made by the program.
        if !controls.is_empty() {
            let _ = writeln!(text, "controls = [{}]", controls.join(", "));
        }
        Ok(text)
    }

    /// Whether the property is decided without enclosures: only rational quantities and operations.
    pub(crate) fn is_exact(&self) -> bool {
        const ENCLOSED: [&str; 18] = [
            "sqrt",
            "sin",
            "cos",
            "exp",
            "log",
            "pi",
            "lambda",
            "spectral_radius",
            "second_modulus",
            "fiedler_sign",
            "peak",
            "peak_frequency",
            "gain",
            "abscissa",
            "tau_2",
            "disagreement",
            "min_distance",
            "order",
        ];
        let mut exact = true;
        if let Some(property) = &self.property {
            property.node.visit(&mut |node| {
                if let Kind::Name { name, .. } = &node.kind {
                    let own = name.rsplit('.').next().unwrap_or(name);
                    exact &= !ENCLOSED.contains(&own) && !self.subjects().contains(&Subject::Motion);
                }
            });
        }
        exact
    }
}
