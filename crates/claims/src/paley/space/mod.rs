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

use ledger::Claim;

pub fn claims() -> Vec<Box<dyn Claim>> {
    claims! {
        particles: circle_of_particle, kinetic_energy, relative_equilibria, centre_of_mass_ball;
        spacing: spacing_form, centre_velocity, spacing_descent;
        convergence: theorem2, fixed_centre;
        composite: composite_descent, circular_form, two_networks, pattern_composite;
        stability: synchrony_stable, drift_gain;
        balanced: balanced_stable;
        stability: pattern_stable;
        balanced: larger_gain, unique_maximum;
        symmetry: beacon_form, common_drift;
        fish: euler_step, repulsion_field, attraction_field;
        fish_control: laplacian_form, comparison;
        zones: chord, perceptual_zones;
        figures: motions_figure, cyclic_figure, patterns_figure, tracking_figure, beacon_figure;
        zone_circles: circular_in_zones, circles_and_symmetric_starts;
        bifurcation: fewer_clusters, clusters_of_the_corrected_law;
        zone_patterns: patterns_in_zones;
        fish_data: measured_tracks, difference_inference;
    }
}
