//! Claims about phases: the phase model, its potentials and the graphs (equations (7)-(16), (23)-(25)).

mod common;
mod eigenvectors;
mod figure2;
mod graphs;
mod laplacian_potential;
mod moment_potentials;
mod nearest;
mod order;
mod patterns;
mod reference;
mod saddles;
mod stationary;
mod theorem1;
mod tutorial;
mod zero_set;

pub use eigenvectors::CyclicVariant;

use ledger::Claim;

pub fn claims() -> Vec<Box<dyn Claim>> {
    claims! {
        order: synchronised, order_parameter, extremes, gradient_law;
        theorem1: convergence, synchronised_stable, balanced_stable;
        saddles: saddles, unbalanced;
        graphs: edge_length, kernel, incidence;
        tutorial: laplacians, named_laplacians;
        laplacian_potential: complete_potential, gradient, law;
        zero_set: connected, strong_subgraphs, fish_subgraphs;
        stationary: stationary_points, eigenvectors_are_stationary, balanced_point_exists;
        eigenvectors: circulant_eigenvectors, cyclic_eigenvectors;
        figure2: columns;
        nearest: scale, complete_scale, three_and_one;
        patterns: two_patterns, moments_of_patterns;
        moment_potentials: laplacian_moments, moment_potentials;
        patterns: minimisers;
        reference: reference_phase;
    }
}
