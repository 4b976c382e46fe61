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

use ledger::Claim;

/// All that are built.
pub fn claims() -> Vec<Box<dyn Claim>> {
    vec![
        Box::new(smallest_entries::smallest_entries()),
        Box::new(fewer_switches::fewer_switches()),
        Box::new(tower::tower()),
        Box::new(recurrent::recurrent()),
        Box::new(virtual_origins::angle()),
        Box::new(virtual_origins::losses()),
        Box::new(next_order::frequency()),
        Box::new(next_order::amplitude()),
        Box::new(decay_rate::slowest_decay()),
        Box::new(growth::growth()),
        Box::new(paley_circulant::circulant_spectrum()),
        Box::new(paley_circulant::cyclic_patterns()),
        Box::new(paley_abscissa::pattern_abscissa()),
        Box::new(phases::inertia()),
        Box::new(phases::cyclic_eigenvectors()),
        Box::new(tanner::two_agents()),
        Box::new(tanner::turning_triangle()),
        Box::new(tanner::alternating_trees()),
        Box::new(tanner::endless_switching()),
        Box::new(tanner::switching_ends()),
        Box::new(certified_split::certified_split()),
        Box::new(table1_reading::table1_reading()),
    ]
}
