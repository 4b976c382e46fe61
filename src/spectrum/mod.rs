//! Exact and enclosed spectra: integer polynomials with their real roots, and sequences that obey a linear recurrence.

mod block;
mod choose;
mod closed_form;
mod cyclotomic;
mod enclosed;
mod exact;
mod float_bounds;
mod polynomial;
mod recurrence;
mod symmetric;

pub use choose::{
    LARGEST_DENSE_ORDER, LARGEST_DIGITS, LARGEST_EXACT_ORDER, SpectrumError, matrix_spectrum, named_spectrum,
};
pub use closed_form::{ClosedForm, ClosedValue, closed_form};
pub use cyclotomic::{CyclotomicSum, RootTable};
pub use enclosed::{Eigenvalue, Method, Spectrum};
pub use exact::real_spectrum;
pub use polynomial::{Polynomial, RealRoot};
pub use recurrence::{Eventual, Leading, Recurrence, RecurrenceError};
