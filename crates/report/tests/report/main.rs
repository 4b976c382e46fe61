//! What the report prints and draws.

mod plot;
mod site;
