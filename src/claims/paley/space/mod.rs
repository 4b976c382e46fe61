//! Claims about particles in the plane and fish: (1)-(5), (17)-(22), (26)-(29).

mod bifurcation;
mod composite;
mod figures;
mod fish;
mod fish_data;
mod instances;
mod particles;
mod runs;
mod spacing;
mod stability;
mod symmetry;

use crate::ledger::AnyClaim;

/// All that are built.
pub fn claims() -> Vec<Box<dyn AnyClaim>> {
    vec![
        Box::new(particles::CircleOfParticle),
        Box::new(particles::KineticEnergy),
        Box::new(particles::RelativeEquilibria),
        Box::new(particles::CentreOfMassBall),
        Box::new(spacing::SpacingPotential),
        Box::new(spacing::CentreVelocity),
        Box::new(spacing::SpacingDescent),
        Box::new(spacing::Theorem2),
        Box::new(spacing::FixedCentre),
        Box::new(composite::CompositePotential),
        Box::new(composite::CircularControl),
        Box::new(composite::TwoNetworks),
        Box::new(composite::PatternPotential),
        Box::new(stability::SynchronyStable),
        Box::new(stability::DriftGain),
        Box::new(stability::BalancedStable),
        Box::new(stability::PatternStable),
        Box::new(stability::LargerGain),
        Box::new(stability::UniqueMaximum),
        Box::new(symmetry::BeaconForm),
        Box::new(symmetry::CommonDrift),
        Box::new(fish::EulerStep),
        Box::new(fish::RepulsionField),
        Box::new(fish::AttractionField),
        Box::new(fish::LaplacianForm),
        Box::new(fish::Comparison),
        Box::new(fish::Chord),
        Box::new(fish::PerceptualZones),
        Box::new(figures::MotionsFigure),
        Box::new(figures::CyclicFigure),
        Box::new(figures::PatternsFigure),
        Box::new(figures::TrackingFigure),
        Box::new(figures::BeaconFigure),
        Box::new(bifurcation::CircularInZones),
        Box::new(bifurcation::FewerClusters),
        Box::new(bifurcation::PatternsInZones),
        Box::new(fish_data::MeasuredTracks),
        Box::new(fish_data::DifferenceInference),
    ]
}
