//! Claims of Tanner, Jadbabaie and Pappas, Flocking in fixed and switching networks.
//!
//! Reading of the text: the potentials are those of Definition 3 with a continuous gradient ("the control laws are smooth",
//! Section 4); pairs are pairs of different agents; no linked agents coincide at the start.

mod bounds;
mod collisions;
mod energy;
mod figures;
mod filippov;
pub(super) mod fixtures;
pub(super) mod graphs;
mod limits;
mod nonsmooth;
mod rates;
pub(super) mod switching;
pub(super) mod wording;

use ledger::Claim;

pub fn claims() -> Vec<Box<dyn Claim>> {
    claims! {
        energy: eq6, eq8, eq9, cor2_decomp, s_config, eq14, vdot_b;
        graphs: laplacian, range, merris;
        bounds: bound_r, bound_v, eq7, cor2_sub;
        nonsmooth: lem1, lem2, q_sums, q_jump, q_dot, eq13, eq13_interval;
        wording: eq2, figure_references, theorem5_use;
        filippov: uniqueness, definition4, chain_rule, existence;
        limits: thm1a, thm1c, flocking, definition3, cor1, thm2_vel, thm2_pot;
        collisions: thm1b, cor3, thm2_coll, noninter;
        rates: rate;
        switching: arbitrary, stops;
        figures: fig4, fig4_close, fig5, fig6;
    }
}
