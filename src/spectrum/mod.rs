//! Exact and enclosed spectra: integer polynomials with their real roots, and sequences that obey a linear recurrence.

mod polynomial;
mod recurrence;
mod stability;

pub use polynomial::{Polynomial, RealRoot};
pub use recurrence::{Eventual, Leading, Recurrence, RecurrenceError};
