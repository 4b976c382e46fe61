//! Numbers between Python and the crates, always exactly.

use super::refuse;
use flockproof::arithmetic::{Interval, Rational, decimals, parse_rational};
use flockproof::matrix::{MatrixError, RationalMatrix};
use num_bigint::BigInt;
use pyo3::exceptions::{PyAttributeError, PyTypeError};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyFloat, PyInt, PyString};

/// Longest integer that is taken, in bits: the 10 000 digits of the command line.
const LONGEST: u64 = 33_220;

/// Two decimals, rounded outward.
pub type Ends = (String, String);
/// Numerator and denominator.
pub type Ratio = (BigInt, BigInt);

/// Numerator and denominator of a number as Python has it: int, float (its exact value), str, Fraction, Decimal and what is like them.
#[pyfunction]
pub fn ratio(name: &str, value: &Bound<'_, PyAny>) -> PyResult<Ratio> {
    exact(name, value).map(pair)
}

pub fn pair(x: Rational) -> Ratio {
    x.into_raw()
}

/// The exact value of a number; `name` is the argument at fault.
pub fn exact(name: &str, value: &Bound<'_, PyAny>) -> PyResult<Rational> {
    let named = |error: &dyn std::fmt::Display| refuse(format!("{name}: {error}"));
    if value.is_instance_of::<PyBool>() {
        return Err(no_number(name, value));
    }
    if value.is_instance_of::<PyInt>() {
        return Ok(Rational::from_integer(integer(name, value)?));
    }
    if let Ok(float) = value.cast::<PyFloat>() {
        let float = float.value();
        return Rational::from_float(float).ok_or_else(|| named(&format!("`{float}` is not a number")));
    }
    if let Ok(text) = value.cast::<PyString>() {
        return parse_rational(text.to_str()?).map_err(|error| named(&error));
    }
    // Fraction, the integers of NumPy and whatever else calls itself rational; then Decimal and the floats of NumPy.
    if let (Ok(p), Ok(q)) = (value.getattr("numerator"), value.getattr("denominator")) {
        return quotient(name, value, &p, &q);
    }
    match value.call_method0("as_integer_ratio") {
        Ok(parts) => {
            let (p, q): (Bound<'_, PyAny>, Bound<'_, PyAny>) = parts.extract().map_err(|_| no_number(name, value))?;
            quotient(name, value, &p, &q)
        }
        Err(error) if error.is_instance_of::<PyAttributeError>(value.py()) => Err(no_number(name, value)),
        Err(_) => Err(named(&format!("`{}` is not a number", shown(value)))),
    }
}

fn quotient(name: &str, value: &Bound<'_, PyAny>, p: &Bound<'_, PyAny>, q: &Bound<'_, PyAny>) -> PyResult<Rational> {
    let (p, q) = match (integer(name, p), integer(name, q)) {
        (Ok(p), Ok(q)) => (p, q),
        (Err(error), _) | (_, Err(error)) if error.is_instance_of::<pyo3::exceptions::PyValueError>(value.py()) => {
            return Err(error);
        }
        _ => return Err(no_number(name, value)),
    };
    if q == BigInt::ZERO {
        return Err(refuse(format!("{name}: `{}` has a zero denominator", shown(value))));
    }
    Ok(Rational::new(p, q))
}

fn integer(name: &str, value: &Bound<'_, PyAny>) -> PyResult<BigInt> {
    if let Ok(small) = value.extract::<i64>() {
        return Ok(BigInt::from(small));
    }
    let large: BigInt = value.extract().map_err(|_| no_number(name, value))?;
    if large.bits() > LONGEST {
        return Err(refuse(format!("{name}: a number of more than 10000 digits is not read")));
    }
    Ok(large)
}

/// A count from 0; `name` is the argument at fault.
pub fn count(name: &str, value: &Bound<'_, PyAny>) -> PyResult<u64> {
    let index = match value.is_instance_of::<PyBool>() {
        true => None,
        false => value.call_method0("__index__").ok(),
    };
    let Some(index) = index else {
        return Err(PyTypeError::new_err(format!("{name} must be an integer, but it is `{}`", shown(value))));
    };
    index.extract().map_err(|_| {
        refuse(format!("{name} must be an integer from 0 to 18446744073709551615, but it is {}", shown(&index)))
    })
}

/// A count that may be left out.
pub fn optional_count(name: &str, value: Option<&Bound<'_, PyAny>>) -> PyResult<Option<u64>> {
    value.map(|value| count(name, value)).transpose()
}

/// Digits: those that no `u32` holds are too many for every function.
pub fn digits(value: &Bound<'_, PyAny>) -> PyResult<u32> {
    let digits = count("digits", value)?;
    let most = flockproof::spectrum::LARGEST_DIGITS;
    let told = || refuse(format!("the number of digits must lie between 1 and {most}, but it is {digits}"));
    u32::try_from(digits).map_err(|_| told())
}

fn no_number(name: &str, value: &Bound<'_, PyAny>) -> PyErr {
    PyTypeError::new_err(format!("{name}: `{}` is not an integer, a fraction p/q or a decimal", shown(value)))
}

/// The first characters of a value as Python shows it.
pub fn shown(value: &Bound<'_, PyAny>) -> String {
    const MOST: usize = 60;
    let text = value.str().map(|text| text.to_string_lossy().into_owned()).unwrap_or_else(|_| "?".to_string());
    if text.chars().count() <= MOST { text } else { text.chars().take(MOST).chain("..".chars()).collect() }
}

/// The ends of an enclosure as the command line prints them.
pub fn ends(x: &Interval, digits: u32) -> Ends {
    decimals(x, digits)
}

/// A matrix as integers over a common denominator, row by row.
#[derive(FromPyObject)]
pub struct Matrix {
    rows: usize,
    columns: usize,
    numerators: Vec<Whole>,
    denominator: BigInt,
}

/// An integer; the short ones, which are almost all, by the short way.
struct Whole(BigInt);

impl<'a, 'py> FromPyObject<'a, 'py> for Whole {
    type Error = PyErr;

    fn extract(value: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        match value.extract::<i64>() {
            Ok(small) => Ok(Whole(BigInt::from(small))),
            Err(_) => value.extract().map(Whole),
        }
    }
}

impl Matrix {
    pub fn into_matrix(self) -> Result<RationalMatrix, MatrixError> {
        let numerators = self.numerators.into_iter().map(|whole| whole.0).collect();
        RationalMatrix::new(self.rows, self.columns, numerators, self.denominator)
    }
}

/// A matrix for Python: rows, columns, numerators row by row, common denominator.
pub fn matrix(matrix: &RationalMatrix) -> (usize, usize, Vec<BigInt>, BigInt) {
    let numerators = (0..matrix.rows()).flat_map(|i| matrix.row(i).to_vec()).collect();
    (matrix.rows(), matrix.cols(), numerators, matrix.denominator().clone())
}
