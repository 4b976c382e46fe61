//! Claims of Tanner, Jadbabaie and Pappas, Flocking in fixed and switching networks.
//!
//! Reading of the text: the potentials are those of Definition 3 with a continuous gradient ("the control laws are smooth",
//! Section 4); pairs are pairs of different agents; no linked agents coincide at the start.

mod agentwise;
mod bounds;
mod collisions;
mod energy;
pub(super) mod figures;
mod filippov;
pub(super) mod fixtures;
pub(super) mod graphs;
mod limits;
mod motions;
mod nonsmooth;
mod rates;
pub(super) mod switching;
pub(super) mod wording;

use ledger::Claim;

/// All that are built.
pub fn claims() -> Vec<Box<dyn Claim>> {
    vec![
        Box::new(energy::eq6()),
        Box::new(energy::eq8()),
        Box::new(energy::eq9()),
        Box::new(energy::cor2_decomp()),
        Box::new(energy::s_config()),
        Box::new(energy::eq14()),
        Box::new(energy::vdot_b()),
        Box::new(graphs::laplacian()),
        Box::new(graphs::range()),
        Box::new(graphs::merris()),
        Box::new(bounds::bound_r()),
        Box::new(bounds::bound_v()),
        Box::new(bounds::eq7()),
        Box::new(bounds::cor2_sub()),
        Box::new(nonsmooth::lem1()),
        Box::new(nonsmooth::lem2()),
        Box::new(nonsmooth::q_sums()),
        Box::new(nonsmooth::q_jump()),
        Box::new(nonsmooth::q_dot()),
        Box::new(nonsmooth::eq13()),
        Box::new(nonsmooth::eq13_interval()),
        Box::new(wording::eq2()),
        Box::new(wording::figure_references()),
        Box::new(wording::theorem5_use()),
        Box::new(filippov::uniqueness()),
        Box::new(filippov::definition4()),
        Box::new(filippov::chain_rule()),
        Box::new(filippov::existence()),
        Box::new(limits::thm1a()),
        Box::new(limits::thm1c()),
        Box::new(limits::flocking()),
        Box::new(limits::definition3()),
        Box::new(limits::cor1()),
        Box::new(limits::thm2_vel()),
        Box::new(limits::thm2_pot()),
        Box::new(collisions::thm1b()),
        Box::new(collisions::cor3()),
        Box::new(collisions::thm2_coll()),
        Box::new(collisions::noninter()),
        Box::new(rates::rate()),
        Box::new(switching::arbitrary()),
        Box::new(switching::stops()),
        Box::new(figures::fig4()),
        Box::new(figures::fig4_close()),
        Box::new(figures::fig5()),
        Box::new(figures::fig6()),
    ]
}
