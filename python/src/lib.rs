//! The native half of the Python package `flockproof`: it converts arguments, calls the crates without holding the interpreter,
//! and converts what they return. The names and the documentation that users see are in `python/flockproof/`.

mod command_line;
mod convert;
mod flock;
mod ledger;
mod queries;
mod questions;
mod runs;
mod watch;

use pyo3::prelude::*;

/// What `python/flockproof/` is built on; not for direct use.
#[pymodule]
mod _native {
    use pyo3::prelude::*;

    #[pymodule_export]
    use super::command_line::command_line;
    #[pymodule_export]
    use super::convert::ratio;
    #[pymodule_export]
    use super::flock::{flock_check, flock_run, flock_settle};
    #[pymodule_export]
    use super::ledger::{claims, explain, judge, verify};
    #[pymodule_export]
    use super::queries::{
        ergodicity, graph_name_problem, peak, platoon_matrices, platoon_peak, platoon_poles, platoon_response, reach,
        reach_tube, read_sequence, resonance, spectrum, system_peak, theorem_1,
    };
    #[pymodule_export]
    use super::questions::{
        campaign_merge, campaign_shard, campaign_size, check, fuzz_summary, graphs, invariants, question_needs,
        sweep_table,
    };
    #[pymodule_export]
    use super::runs::{named_files, simulate, tracks};

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}

/// What a person can mend by other arguments: `ValueError` with the sentence of the command line.
fn refuse(error: impl std::fmt::Display) -> PyErr {
    pyo3::exceptions::PyValueError::new_err(error.to_string())
}
