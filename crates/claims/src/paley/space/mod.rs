//! Claims about particles in the plane and fish: (1)-(5), (17)-(22), (26)-(29).

mod balanced;
mod bifurcation;
mod composite;
mod convergence;
mod figures;
mod fish;
mod fish_control;
mod fish_data;
mod instances;
mod particles;
mod runs;
mod spacing;
mod stability;
mod symmetry;
mod zone_circles;
mod zone_patterns;
mod zones;

pub use instances::without_symmetries;

use ledger::Claim;

/// All that are built.
pub fn claims() -> Vec<Box<dyn Claim>> {
    vec![
        Box::new(particles::circle_of_particle()),
        Box::new(particles::kinetic_energy()),
        Box::new(particles::relative_equilibria()),
        Box::new(particles::centre_of_mass_ball()),
        Box::new(spacing::spacing_form()),
        Box::new(spacing::centre_velocity()),
        Box::new(spacing::spacing_descent()),
        Box::new(convergence::theorem2()),
        Box::new(convergence::fixed_centre()),
        Box::new(composite::composite_descent()),
        Box::new(composite::circular_form()),
        Box::new(composite::two_networks()),
        Box::new(composite::pattern_composite()),
        Box::new(stability::synchrony_stable()),
        Box::new(stability::drift_gain()),
        Box::new(balanced::balanced_stable()),
        Box::new(stability::pattern_stable()),
        Box::new(balanced::larger_gain()),
        Box::new(balanced::unique_maximum()),
        Box::new(symmetry::beacon_form()),
        Box::new(symmetry::common_drift()),
        Box::new(fish::euler_step()),
        Box::new(fish::repulsion_field()),
        Box::new(fish::attraction_field()),
        Box::new(fish_control::laplacian_form()),
        Box::new(fish_control::comparison()),
        Box::new(zones::chord()),
        Box::new(zones::perceptual_zones()),
        Box::new(figures::motions_figure()),
        Box::new(figures::cyclic_figure()),
        Box::new(figures::patterns_figure()),
        Box::new(figures::tracking_figure()),
        Box::new(figures::beacon_figure()),
        Box::new(zone_circles::circular_in_zones()),
        Box::new(bifurcation::fewer_clusters()),
        Box::new(zone_patterns::patterns_in_zones()),
        Box::new(fish_data::measured_tracks()),
        Box::new(fish_data::difference_inference()),
    ]
}
