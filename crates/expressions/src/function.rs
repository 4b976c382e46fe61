//! Functions of one number.

use arithmetic::{ArithmeticError, Number};

/// A function of one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Function {
    Root,
    Exponential,
    Logarithm,
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
            Function::Sine => x.sin(),
            Function::Cosine => x.cos(),
        }
    }
}
