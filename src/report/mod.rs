//! What people read: the table of the ledger, the explanation of one claim, tables and pictures of the papers.

mod explain;
mod picture;
mod table;
mod table1;

pub use explain::explain;
pub use picture::{PictureError, svg_to_png};
pub use table::{summary, verdict_table};
pub use table1::{Cell, Table1, Table1Row, table1};
