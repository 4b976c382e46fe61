//! Results beyond the papers: corrected theorems and sharper statements, checked like any claim.

mod certified_split;
mod decay_rate;
mod fewer_switches;
mod growth;
mod next_order;
mod paley_abscissa;
mod paley_circulant;
mod paley_modes;
mod phases;
mod recurrent;
mod smallest_entries;
mod table1_reading;
mod tanner;
mod tower;
mod virtual_origins;
mod worst_cases;

use ledger::Claim;

pub fn claims() -> Vec<Box<dyn Claim>> {
    claims! {
        smallest_entries: smallest_entries;
        fewer_switches: fewer_switches;
        tower: tower;
        recurrent: recurrent;
        virtual_origins: angle, losses;
        next_order: frequency, amplitude;
        decay_rate: slowest_decay;
        growth: growth;
        worst_cases: worst_cases;
        paley_circulant: circulant_spectrum, cyclic_patterns;
        paley_abscissa: pattern_abscissa;
        phases: inertia, cyclic_eigenvectors;
        tanner: two_agents, turning_triangle, alternating_trees, endless_switching, switching_ends;
        certified_split: certified_split;
        table1_reading: table1_reading;
    }
}
