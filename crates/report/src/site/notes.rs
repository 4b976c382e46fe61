//! The notes as pages: what verdicts promise, results, proofs on paper.

/// Notes by their names.
pub(super) const NOTES: &[&str] = &[
    "chazelle",
    "chazelle_fixed_network",
    "chazelle_switches",
    "communication_sweep",
    "guarantees",
    "integrators",
    "model_k",
    "paley_particles",
    "paley_phases",
    "resonance",
    "results",
    "settling",
    "spectra",
    "tanner1",
    "tanner2",
    "tracks",
    "validated",
    "veerman",
    "veerman_next_order",
    "veerman_platoons",
    "veerman_time_domain",
];

/// Where the page of a note is.
pub(super) fn path(name: &str) -> String {
    if ["guarantees", "results"].contains(&name) { format!("{name}.html") } else { format!("notes/{name}.html") }
}

/// The first heading of a note.
pub(super) fn title(text: &str) -> &str {
    text.lines().find_map(|line| line.strip_prefix("# ")).unwrap_or_default()
}
