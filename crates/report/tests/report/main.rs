//! What the report prints and draws.

mod fold;
mod plot;
mod site;
