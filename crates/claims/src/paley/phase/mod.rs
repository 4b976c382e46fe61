//! Claims about phases: the phase model, its potentials and the graphs (equations (7)-(16), (23)-(25)).

mod common;
mod critical;
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

pub use critical::{
    Kind, arrangements, critical_points, hessian, is_critical, is_on_a_line, linearisation, two_clusters,
};
pub use eigenvectors::CyclicVariant;
pub use figure2::{Polygon, printed_column, rhombus, value_of};

use ledger::Claim;

/// All that are built.
pub fn claims() -> Vec<Box<dyn Claim>> {
    vec![
        Box::new(order::synchronised()),
        Box::new(order::order_parameter()),
        Box::new(order::extremes()),
        Box::new(order::gradient_law()),
        Box::new(theorem1::convergence()),
        Box::new(theorem1::synchronised_stable()),
        Box::new(theorem1::balanced_stable()),
        Box::new(saddles::saddles()),
        Box::new(saddles::unbalanced()),
        Box::new(graphs::edge_length()),
        Box::new(graphs::kernel()),
        Box::new(graphs::incidence()),
        Box::new(tutorial::laplacians()),
        Box::new(tutorial::named_laplacians()),
        Box::new(laplacian_potential::complete_potential()),
        Box::new(laplacian_potential::gradient()),
        Box::new(laplacian_potential::law()),
        Box::new(zero_set::connected()),
        Box::new(zero_set::strong_subgraphs()),
        Box::new(zero_set::fish_subgraphs()),
        Box::new(stationary::stationary_points()),
        Box::new(stationary::eigenvectors_are_stationary()),
        Box::new(stationary::balanced_point_exists()),
        Box::new(eigenvectors::circulant_eigenvectors()),
        Box::new(eigenvectors::cyclic_eigenvectors()),
        Box::new(figure2::columns()),
        Box::new(nearest::scale()),
        Box::new(nearest::complete_scale()),
        Box::new(nearest::three_and_one()),
        Box::new(patterns::two_patterns()),
        Box::new(patterns::moments_of_patterns()),
        Box::new(moment_potentials::laplacian_moments()),
        Box::new(moment_potentials::moment_potentials()),
        Box::new(patterns::minimisers()),
        Box::new(reference::reference_phase()),
    ]
}
