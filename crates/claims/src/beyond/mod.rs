//! Results beyond the papers: corrected theorems and sharper statements, checked like any claim.

mod certified_split;
mod decay_rate;
mod fewer_switches;
mod next_order;
mod one_sided_peak;
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

use ledger::AnyClaim;

/// All that are built.
pub fn claims() -> Vec<Box<dyn AnyClaim>> {
    vec![
        Box::new(one_sided_peak::OneSidedPeak),
        Box::new(smallest_entries::SmallestEntries),
        Box::new(fewer_switches::FewerSwitches),
        Box::new(tower::Tower),
        Box::new(recurrent::Recurrent),
        Box::new(virtual_origins::Angle),
        Box::new(virtual_origins::Losses),
        Box::new(next_order::FREQUENCY),
        Box::new(next_order::AMPLITUDE),
        Box::new(decay_rate::SlowestDecay),
        Box::new(paley_circulant::CirculantSpectrum),
        Box::new(paley_circulant::CyclicPatterns),
        Box::new(paley_abscissa::pattern_abscissa()),
        Box::new(phases::CriticalInertia),
        Box::new(phases::CyclicClassification),
        Box::new(tanner::two_agents()),
        Box::new(tanner::turning_triangle()),
        Box::new(tanner::alternating_trees()),
        Box::new(tanner::endless_switching()),
        Box::new(certified_split::certified_split()),
        Box::new(table1_reading::Table1Reading),
    ]
}
