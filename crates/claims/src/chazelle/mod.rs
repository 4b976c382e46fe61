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

/// All that are built.
pub fn claims() -> Vec<Box<dyn Claim>> {
    vec![
        Box::new(worked_matrices::stretching()),
        Box::new(worked_matrices::product_a_b()),
        Box::new(ergodicity::coefficient()),
        Box::new(ergodicity::submultiplicative()),
        Box::new(ergodicity::square_root_of_two()),
        Box::new(footprints::monotone()),
        Box::new(four_birds::eigenvector()),
        Box::new(four_birds::closed_form()),
        Box::new(four_birds::alternation()),
        Box::new(hysteresis::rule()),
        Box::new(hysteresis::smaller_threshold()),
        Box::new(hysteresis::near_birds_are_joined()),
        Box::new(hysteresis::far_birds_are_not()),
        Box::new(geometry::quotient_of_angle()),
        Box::new(geometry::angle_decays()),
        Box::new(geometry::no_losses()),
        Box::new(lower_bound::lower_bound()),
        Box::new(lower_bound::single_paths()),
        Box::new(settling::distance_expansion()),
        Box::new(settling::gaps()),
        Box::new(settling::next_contact()),
        Box::new(settling::steady_state()),
        Box::new(fixed_network::spectrum::stationary()),
        Box::new(fixed_network::spectrum::symmetrised()),
        Box::new(fixed_network::powers::powers()),
        Box::new(fixed_network::mixing::second_eigenvalue()),
        Box::new(fixed_network::mixing::entrywise_rate()),
        Box::new(fixed_network::mixing::halving_time()),
        Box::new(fixed_network::fiedler::fiedler_rate()),
        Box::new(fixed_network::limits::limit_of_gamma()),
        Box::new(fixed_network::limits::positions()),
        Box::new(fixed_network::limits::relative_limit()),
        Box::new(fixed_network::denominators::short_limit()),
        Box::new(fixed_network::closed_forms::geometric_sums()),
        Box::new(fixed_network::closed_forms::with_gamma()),
        Box::new(fixed_network::closed_forms::two_birds_apart()),
        Box::new(entries::entries()),
        Box::new(switch_counts::count()),
        Box::new(switch_counts::until_stable()),
        Box::new(stabilisation::nested()),
        Box::new(stabilisation::blocks()),
        Box::new(stabilisation::contraction()),
        Box::new(kronecker::kronecker()),
        Box::new(kronecker::difference()),
        Box::new(model_matrices::stochastic()),
        Box::new(model_matrices::headings()),
        Box::new(velocity_bounds::distance_change()),
        Box::new(velocity_bounds::velocity_norm()),
        Box::new(lengths::product_length()),
        Box::new(lengths::state_length()),
        Box::new(switching::threshold_inequality()),
        Box::new(switching::final_count()),
        Box::new(switching::flocking_switches()),
        Box::new(switching::total_switches()),
    ]
}
