//! Evidence: its grade, and which clauses it bears on.

use serde::{Deserialize, Serialize};

/// Grades of evidence, strongest first; `notes/guarantees.md` says what each promises.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Grade {
    /// Stated and proved in Coq for all parameters.
    Kernel,
    /// Exact identity of rational functions, tested at random points with an error bound.
    Identity,
    /// Every case of a finite family.
    Exhaustive,
    /// Interval enclosures that imply the statement, for a box of parameters or an instance.
    Certified,
    /// A proof on paper in notes/, with its computed checks beside it.
    Argued,
    /// Exact arithmetic on named instances; also a counterexample.
    Exact,
    /// Floating-point run with a derived tolerance.
    Simulated,
    /// Property test.
    Fuzzed,
    /// Internal consistency of the text only.
    Text,
}

impl Grade {
    /// All grades, strongest first.
    pub const ALL: [Grade; 9] = [
        Grade::Kernel,
        Grade::Identity,
        Grade::Exhaustive,
        Grade::Certified,
        Grade::Argued,
        Grade::Exact,
        Grade::Simulated,
        Grade::Fuzzed,
        Grade::Text,
    ];

    /// Whether evidence of this grade says how many cases it rests on.
    pub fn counts_cases(self) -> bool {
        matches!(self, Grade::Identity | Grade::Exhaustive | Grade::Fuzzed)
    }

    /// What it means, in a few words; `notes/guarantees.md` has the whole.
    pub fn meaning(self) -> &'static str {
        match self {
            Grade::Kernel => "proved in Coq",
            Grade::Identity => "identity tested at random points, with a bound on the error",
            Grade::Exhaustive => "every case of a finite family",
            Grade::Certified => "implied by enclosures",
            Grade::Argued => "proof on paper, with computed checks",
            Grade::Exact => "exact arithmetic on named instances",
            Grade::Simulated => "floating-point runs",
            Grade::Fuzzed => "random cases",
            Grade::Text => "the text against itself",
        }
    }

    /// The word used in the ledger.
    pub fn word(self) -> &'static str {
        match self {
            Grade::Kernel => "kernel",
            Grade::Identity => "identity",
            Grade::Exhaustive => "exhaustive",
            Grade::Certified => "certified",
            Grade::Argued => "argued",
            Grade::Exact => "exact",
            Grade::Simulated => "simulated",
            Grade::Fuzzed => "fuzzed",
            Grade::Text => "text",
        }
    }
}

/// How far a piece of evidence reaches.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Scope {
    /// All parameters of its clauses.
    All,
    /// Some of them.
    Instances,
}

impl Scope {
    /// The word used in the tables.
    pub fn word(self) -> &'static str {
        match self {
            Scope::All => "all",
            Scope::Instances => "instances",
        }
    }
}

/// One piece of evidence for a stated part of a claim.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Evidence {
    /// Its grade.
    pub grade: Grade,
    /// The clauses that it bears on, counted from 1.
    pub clauses: Vec<usize>,
    /// How far it reaches; nothing for the text against itself.
    pub scope: Option<Scope>,
    /// The part of the claim it supports.
    pub part: String,
    /// What was done.
    pub detail: String,
    /// Number of cases, where cases were counted.
    pub cases: Option<u64>,
    /// `2^-k`, for identities.
    pub error_bound: Option<String>,
    /// Whether it speaks against its clauses: how a counterexample was found, or a proof of the negation.
    #[serde(skip)]
    pub refutes: bool,
    /// The negative controls, counted from 1, whose check fails in this part; `p` for the printed form, from which a correction is
    /// to be told apart.
    #[serde(skip)]
    pub controls: Vec<String>,
    /// What was computed of a proof on paper beside it, where that bears on no clause by itself.
    #[serde(skip)]
    pub steps: Vec<Evidence>,
}

impl Evidence {
    /// Evidence on instances, without a count or bound. It bears on the only clause of a statement that has one; for others
    /// see [`Evidence::on`].
    pub fn new(grade: Grade, part: impl Into<String>, detail: impl Into<String>) -> Self {
        let scope = (grade != Grade::Text).then_some(Scope::Instances);
        Evidence {
            grade,
            clauses: Vec::new(),
            scope,
            part: part.into(),
            detail: detail.into(),
            cases: None,
            error_bound: None,
            refutes: false,
            controls: Vec::new(),
            steps: Vec::new(),
        }
    }

    /// A proof on paper for all parameters; `place` names the note and its steps.
    pub fn argued(part: impl Into<String>, place: impl Into<String>) -> Self {
        Evidence::new(Grade::Argued, part, place).for_all()
    }

    /// The same for these clauses, counted from 1.
    pub fn on(mut self, clauses: impl Into<Vec<usize>>) -> Self {
        self.clauses = clauses.into();
        self
    }

    /// The same for all parameters of its clauses. To be said only where the evidence would change if the clause were false for any of them.
    pub fn for_all(mut self) -> Self {
        self.scope = Some(Scope::All);
        self
    }

    /// The same against its clauses.
    pub fn refuting(mut self) -> Self {
        self.refutes = true;
        self
    }

    /// The same with a number of cases.
    pub fn cases(mut self, cases: usize) -> Self {
        self.cases = Some(cases as u64);
        self
    }

    /// The same with what was computed beside it ([`Evidence::steps`]).
    pub fn beside(mut self, steps: Vec<Evidence>) -> Self {
        self.steps = steps;
        self
    }

    /// The piece that looked at nothing, this one or one beside it: where cases are counted, none is no evidence.
    pub(super) fn empty(&self) -> Option<&Evidence> {
        let is_empty = |e: &&Evidence| e.cases == Some(0) || e.cases.is_none() && e.grade.counts_cases();
        std::iter::once(self).find(is_empty).or_else(|| self.steps.iter().find_map(Evidence::empty))
    }

    /// The same with an error bound of `2^-bits`.
    pub fn error_bits(mut self, bits: u64) -> Self {
        self.error_bound = Some(format!("2^-{bits}"));
        self
    }
}
