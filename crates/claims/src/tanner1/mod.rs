//! Claims of Tanner, Jadbabaie and Pappas, Stable flocking of mobile agents, part I.
//!
//! Reading of the text: the heading is (2), the two-argument arctangent of a velocity that is not zero; `theta_i - theta_j` is the
//! difference of these numbers ("raw"); a statement that depends on this says so. The potential is the printed `1/s + log s`, with
//! `s = |r_ij|²`, where a statement needs more than symmetry.

mod closed_loop;
mod energy_rates;
mod fields;
mod figures;
mod line;
mod sets;
mod turning;

use ledger::Claim;

/// All that are built.
pub fn claims() -> Vec<Box<dyn Claim>> {
    vec![
        Box::new(turning::gyro()),
        Box::new(turning::eq6()),
        Box::new(turning::eq6b()),
        Box::new(turning::eq7()),
        Box::new(energy_rates::eq8()),
        Box::new(energy_rates::eq9_chain()),
        Box::new(energy_rates::eq9()),
        Box::new(energy_rates::vt_inv()),
        Box::new(energy_rates::decoupled()),
        Box::new(fields::laplacian()),
        Box::new(fields::ones()),
        Box::new(fields::weighted()),
        Box::new(fields::fig2()),
        Box::new(fields::monotone()),
        Box::new(fields::any_potential()),
        Box::new(fields::vt()),
        Box::new(line::distances()),
        Box::new(line::headings()),
        Box::new(line::cases()),
        Box::new(figures::complete()),
        Box::new(figures::incomplete()),
        Box::new(sets::eq2()),
        Box::new(sets::smooth()),
        Box::new(sets::closed()),
        Box::new(sets::bounded()),
        Box::new(sets::collision()),
        Box::new(sets::ratio()),
    ]
}
