//! Functions of one number.

use arithmetic::{ArithmeticError, Number};

const BASE: ArithmeticError =
    ArithmeticError::Domain("a number above 0 where a power has an exponent that is not a whole number");

/// A function of one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Function {
    Root,
    Exponential,
    Logarithm,
    /// The logarithm of what is raised to a power.
    LogarithmOfBase,
    Sine,
    Cosine,
}

impl Function {
    /// Its value.
    pub fn at<T: Number>(self, x: &T) -> Result<T, ArithmeticError> {
        match self {
            Function::Root => x.sqrt(),
            Function::Exponential => x.exp(),
            Function::Logarithm => x.ln(),
            Function::LogarithmOfBase => x.ln().map_err(|error| match error {
                ArithmeticError::Argument(_) => BASE,
                other => other,
            }),
            Function::Sine => x.sin(),
            Function::Cosine => x.cos(),
        }
    }
}
