//! Exact and enclosed spectra of matrices and graphs; integer polynomials with their roots; sequences that obey a linear
//! recurrence.
//!
//! [`named_spectrum`] and [`matrix_spectrum`] choose the method and say which: a closed form, the exact characteristic
//! polynomial, or floating point with proved bounds. Every number comes with its enclosure, or there is an error.

mod block;
mod choose;
mod circulant;
mod closed_form;
mod cyclotomic;
mod enclosed;
mod error;
mod exact;
mod float_bounds;
mod fourier;
mod general;
mod recurrence;
mod reduction;
mod reflections;
mod schur;
mod small;
mod smith;
mod symmetric;
#[cfg(test)]
mod testing;
mod trailing;
mod tridiagonal;
mod turn;

pub use choose::{circulant_spectrum, graph_spectrum, matrix_spectrum, named_spectrum, symmetric_enclosures};
pub use circulant::{Circulant, CirculantSpectrum};
pub use closed_form::{ClosedForm, ClosedValue, closed_form};
pub use cyclotomic::{CyclotomicSum, RootTable};
pub use enclosed::{Eigenvalue, FloatEnclosure, Method, Spectrum};
pub use error::{
    LARGEST_DENSE_ORDER, LARGEST_DIGITS, LARGEST_EXACT_ORDER, LARGEST_GENERAL_ORDER, LARGEST_TRIDIAGONAL_ORDER,
    SpectrumError,
};
pub use exact::real_spectrum;
pub use polynomials::univariate::{
    Largest, LargestError, Nearest, Place, Polynomial, RealRoot, complex_abscissa, largest_quotient, roots_are_left_of,
};
pub use recurrence::{Eventual, Leading, Recurrence, RecurrenceError};
pub use small::small_symmetric_eigenvalues;
pub use tridiagonal::tridiagonal_eigenvalues;
