//! What people read: the table of the ledger, the explanation of one claim, tables and figures of the papers,
//! files and pictures of simulated scenarios.

mod explain;
mod figures;
pub mod plot;
mod simulation;
mod site;
mod table;
mod tracks;

/// Stands in signatures.
pub use serde_json;

pub use explain::explain;
pub use figures::{FIGURES, Figure, FigureError, File};
pub use simulation::{observables_csv, sample_table, simulation_pictures, simulation_summary, trajectory_csv};
pub use site::{Made, Page, Site, SiteError};
pub use table::{summary, verdict_table};
pub use tracks::TracksReport;
