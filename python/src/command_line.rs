//! The command line inside the wheel.

use pyo3::prelude::*;
use std::ffi::OsString;

/// Runs the command line with these arguments, the first of which is the name of the program; its exit status.
#[pyfunction]
pub fn command_line(py: Python<'_>, arguments: Vec<OsString>) -> u8 {
    py.detach(|| flockproof::command_line(arguments))
}
