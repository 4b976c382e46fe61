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

pub fn claims() -> Vec<Box<dyn Claim>> {
    claims! {
        turning: gyro, eq6, eq6b, eq7;
        energy_rates: eq8, eq9_chain, eq9, vt_inv, decoupled;
        fields: laplacian, ones, weighted, fig2, monotone, any_potential, vt;
        line: distances, headings, cases;
        figures: complete, incomplete;
        sets: eq2, smooth, closed, bounded, collision, ratio;
    }
}
