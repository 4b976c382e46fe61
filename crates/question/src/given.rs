//! Invariants of graphs that a program gives as functions: of another language, or of libraries that this one does not know.

use algebra::graph::AnyGraph;
use arithmetic::Rational;
use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// A value of such a function.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum GivenValue {
    /// An exact number.
    Exact(Rational),
    /// The exact value of a floating-point number, which is nearly what was meant.
    Float(Rational),
    /// There is none for this graph.
    Missing(String),
}

/// What measures a graph.
pub type Measure = Arc<dyn Fn(&AnyGraph) -> GivenValue + Send + Sync>;

/// A function of a graph by its name.
#[derive(Clone)]
pub struct Given {
    /// The name that properties use.
    pub name: String,
    measure: Measure,
    was_float: Arc<AtomicBool>,
}

impl Given {
    /// A function by a name; it must give the same for the same graph.
    pub fn new(name: String, measure: Measure) -> Self {
        Given { name, measure, was_float: Arc::default() }
    }

    pub(crate) fn value(&self, graph: &AnyGraph) -> GivenValue {
        let value = (self.measure)(graph);
        if matches!(value, GivenValue::Float(_)) {
            self.was_float.store(true, Ordering::Relaxed);
        }
        value
    }

    /// Whether some value was a floating-point number.
    pub(crate) fn was_float(&self) -> bool {
        self.was_float.load(Ordering::Relaxed)
    }
}

impl fmt::Debug for Given {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Given({})", self.name)
    }
}
