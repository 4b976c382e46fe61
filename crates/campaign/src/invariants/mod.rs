//! What must always be true, in one table: statement, generator and check of each, and an altered computation that the same check must refute.
//!
//! A check draws its instance itself, so that a case is its list of draws and is made simpler by making the list simpler.

mod alignment;
mod averaging;
mod certificates;
mod inequalities;
mod matrices;
mod motions;
mod numbers;
mod oscillators;
mod platoons;
mod questions;
mod readers;
mod simulated;
mod spectra;
mod symmetries;
mod systems;
mod traces;

pub use readers::{READERS, Reader};

use crate::draws::Draws;
use std::fmt::Display;

/// What a check computes: the thing itself, or the altered one of its control.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tested {
    /// The thing itself.
    AsItIs,
    /// The planted fault, which has to be found.
    Altered,
}

impl Tested {
    /// Whether the fault is planted.
    pub fn is_altered(self) -> bool {
        self == Tested::Altered
    }
}

/// Why a case does not hold.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Stop {
    /// It could not be decided, and why.
    Undecided(String),
    /// It fails.
    Fails {
        /// In one sentence.
        why: String,
        /// The instance, in words and numbers.
        instance: String,
    },
}

/// A case that holds has a margin where the statement is an inequality: how far it is from failing, rounded.
pub type Checked = Result<Option<f64>, Stop>;

/// One row of the table.
pub struct Invariant {
    /// Its name.
    pub id: &'static str,
    /// What is claimed, for every instance.
    pub statement: &'static str,
    /// What the planted fault alters.
    pub control: &'static str,
    /// Cases in one job; more where a case is quick.
    pub block: u64,
    /// Draws an instance and checks it.
    pub check: fn(&mut Draws, Tested) -> Checked,
}

/// All of them.
pub fn table() -> impl Iterator<Item = &'static Invariant> {
    [
        numbers::TABLE,
        matrices::TABLE,
        spectra::TABLE,
        averaging::TABLE,
        alignment::TABLE,
        oscillators::TABLE,
        platoons::TABLE,
        symmetries::TABLE,
        motions::TABLE,
        simulated::TABLE,
        readers::TABLE,
        questions::TABLE,
        inequalities::TABLE,
        certificates::TABLE,
        traces::TABLE,
        systems::TABLE,
    ]
    .into_iter()
    .flatten()
}

/// The one with this name.
pub fn find(id: &str) -> Option<&'static Invariant> {
    table().find(|invariant| invariant.id == id)
}

/// The outcome of one case, with the draws that it took; a panic is a failure.
pub fn decide(invariant: &Invariant, draws: &mut Draws, tested: Tested) -> Checked {
    let checked = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| (invariant.check)(draws, tested)));
    checked.unwrap_or_else(|panic| {
        let said = panic.downcast_ref::<String>().map(String::as_str).or(panic.downcast_ref::<&str>().copied());
        let why = format!("it panics: {}", said.unwrap_or("without a message"));
        Err(Stop::Fails { why, instance: String::new() })
    })
}

/// Fails unless `holds`.
fn require(holds: bool, why: impl Display, instance: impl FnOnce() -> String) -> Result<(), Stop> {
    if holds { Ok(()) } else { Err(Stop::Fails { why: why.to_string(), instance: instance() }) }
}

/// For results that must be there.
trait OrFails<T> {
    /// The result, or a failure that says what was refused.
    fn or_fails(self, what: &str) -> Result<T, Stop>;
}

impl<T> OrFails<T> for Option<T> {
    fn or_fails(self, what: &str) -> Result<T, Stop> {
        self.ok_or_else(|| Stop::Fails { why: what.to_string(), instance: String::new() })
    }
}

impl<T, E: Display> OrFails<T> for Result<T, E> {
    fn or_fails(self, what: &str) -> Result<T, Stop> {
        self.map_err(|error| Stop::Fails { why: format!("{what}: {error}"), instance: String::new() })
    }
}

/// A list of numbers as a text.
fn shown<T: Display>(numbers: impl IntoIterator<Item = T>) -> String {
    let numbers: Vec<String> = numbers.into_iter().map(|x| x.to_string()).collect();
    format!("[{}]", numbers.join(", "))
}
