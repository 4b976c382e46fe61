//! What people read: the table of the ledger, the explanation of one claim, tables and figures of the papers.

mod explain;
mod figures;
pub mod plot;
mod table;
mod tracks;

pub use explain::explain;
pub use figures::{FIGURES, Figure, FigureError, File};
pub use table::{summary, verdict_table};
pub use tracks::TracksReport;
