//! Claims of Chazelle, Natural Algorithms.

pub(super) mod entries;
mod ergodicity;
mod fixed_network;
mod footprints;
mod four_birds;
pub(super) mod geometry;
mod hysteresis;
mod kronecker;
mod lengths;
pub(super) mod lower_bound;
mod model_matrices;
pub(super) mod sequences;
mod settling;
mod stabilisation;
mod switch_counts;
pub(super) mod switching;
mod velocity_bounds;
mod worked_matrices;

use ledger::Claim;

pub fn claims() -> Vec<Box<dyn Claim>> {
    let others: Vec<Box<dyn Claim>> = claims! {
        worked_matrices: stretching, product_a_b;
        ergodicity: coefficient, submultiplicative, square_root_of_two;
        footprints: monotone;
        four_birds: eigenvector, closed_form, alternation;
        hysteresis: rule, smaller_threshold, near_birds_are_joined, far_birds_are_not;
        geometry: quotient_of_angle, angle_decays, no_losses;
        lower_bound: lower_bound, single_paths;
        settling: distance_expansion, gaps, next_contact, steady_state;
        entries: entries;
        switch_counts: count, until_stable;
        stabilisation: nested, blocks, contraction;
        kronecker: kronecker, difference;
        model_matrices: stochastic, headings;
        velocity_bounds: distance_change, velocity_norm;
        lengths: product_length, state_length;
        switching: threshold_inequality, final_count, flocking_switches, total_switches;
    };
    others.into_iter().chain(fixed_network::claims()).collect()
}
