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

pub use common::on_the_line;
pub use critical::{Kind, critical_points};
pub use eigenvectors::CyclicVariant;
pub use figure2::{Polygon, printed_column, rhombus, value_of};

use ledger::AnyClaim;

/// All that are built.
pub fn claims() -> Vec<Box<dyn AnyClaim>> {
    vec![
        Box::new(order::Synchronised),
        Box::new(order::OrderParameter),
        Box::new(order::Extremes),
        Box::new(order::GradientLaw),
        Box::new(theorem1::Convergence),
        Box::new(theorem1::SynchronisedStable),
        Box::new(theorem1::BalancedStable),
        Box::new(saddles::Saddles),
        Box::new(saddles::Unbalanced),
        Box::new(graphs::EdgeLength),
        Box::new(graphs::Kernel),
        Box::new(graphs::Incidence),
        Box::new(tutorial::Laplacians),
        Box::new(tutorial::NamedLaplacians),
        Box::new(laplacian_potential::Complete),
        Box::new(laplacian_potential::Gradient),
        Box::new(laplacian_potential::Law),
        Box::new(zero_set::Connected),
        Box::new(zero_set::StrongSubgraphs),
        Box::new(zero_set::FishSubgraphs),
        Box::new(stationary::StationaryPoints),
        Box::new(stationary::EigenvectorsAreStationary),
        Box::new(stationary::BalancedPoint),
        Box::new(eigenvectors::CirculantEigenvectors),
        Box::new(eigenvectors::CyclicEigenvectors),
        Box::new(figure2::Columns),
        Box::new(nearest::Scale),
        Box::new(nearest::CompleteScale),
        Box::new(nearest::ThreeAndOne),
        Box::new(patterns::TwoPatterns),
        Box::new(patterns::MomentsOfPatterns),
        Box::new(moment_potentials::LaplacianMoments),
        Box::new(moment_potentials::MomentPotential),
        Box::new(patterns::Minimisers),
        Box::new(reference::ReferencePhase),
    ]
}
