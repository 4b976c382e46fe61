//! Right-hand sides, written once over the scalar.

use arithmetic::{ArithmeticError, Number};

/// A right-hand side `dy/dt = f(t, y)`. What is made of the operations of a field and of functions of [`Number`] has derivatives of every order where
/// it has a value; a right-hand side that asks for signs is looked at only where they are certain.
pub trait System: Sync {
    /// `f(time, state)`, as long as the state.
    ///
    /// # Errors
    /// Where it has no value, for instance at a division by zero, or where the scalar cannot tell.
    fn rate<T: Number>(&self, time: &T, state: &[T]) -> Result<Vec<T>, ArithmeticError>;
}

impl<S: System> System for &S {
    fn rate<T: Number>(&self, time: &T, state: &[T]) -> Result<Vec<T>, ArithmeticError> {
        (**self).rate(time, state)
    }
}
