//! What the report prints and draws.

extern crate flockproof_report as report;

mod fold;
mod plot;
mod site;
