//! Networks and starts in words, all histories of some sizes, and what becomes of a flock.

use crate::prelude::*;
use algebra::graph::Graph;
use algebra::matrix::RationalMatrix;
use models::averaging::settle::{Limits, Settlement, settle};
use models::averaging::{Flock, Hysteresis, NetworkHistory, Start, Switch, Weights};

/// The edges of a network, birds from 1.
pub(super) fn show(graph: &Graph) -> String {
    let edges: Vec<String> = graph.edges().iter().map(|(i, j)| format!("{}-{}", i + 1, j + 1)).collect();
    if edges.is_empty() { "no edges".to_string() } else { edges.join(" ") }
}

/// The initial conditions of a flock.
pub(super) fn show_start(start: &Start) -> String {
    let rows = |rows: &[Vec<Rational>]| list(rows.iter().map(|row| format!("({})", list(row))));
    let (x, v) = (rows(&start.positions), rows(&start.velocities));
    let hysteresis = match &start.hysteresis {
        Hysteresis::None => "none".to_string(),
        Hysteresis::Paper => "that of the paper".to_string(),
        Hysteresis::Constant(threshold) => format!("with the threshold {threshold}"),
    };
    let weights = match &start.weights {
        Weights::Lazy => "lazy".to_string(),
        Weights::Vicsek => "c_i = 1/(d_i+1)".to_string(),
        Weights::Given(c) => format!("c = ({})", list(c)),
    };
    format!("x(0) = {x}, v(1) = {v}, weights {weights}, hysteresis {hysteresis}")
}

/// The networks one after the other.
pub(super) fn show_all(graphs: &[Graph]) -> String {
    graphs.iter().map(show).collect::<Vec<_>>().join(", then ")
}

/// Networks in the order of time.
pub(super) fn in_turn(graphs: &[Graph]) -> Witness {
    Witness::networks(graphs.first().map_or(0, Graph::order), graphs.iter().map(Graph::edges).collect())
}

/// The networks of a history.
pub(super) fn show_history(history: &NetworkHistory) -> String {
    format!("{} birds, {}, and so for ever", history.order(), show_all(history.graphs()))
}

/// The matrix in which `i` no longer sees `j > i` (its weight stays with `i`): not of the model.
pub(super) fn seen_from_one_side(matrix: &RationalMatrix) -> Result<RationalMatrix, CheckError> {
    let mut rows = matrix.to_rows();
    for (i, row) in rows.iter_mut().enumerate() {
        for j in i + 1..row.len() {
            let moved = std::mem::replace(&mut row[j], rational(0, 1));
            row[i] += moved;
        }
    }
    Ok(RationalMatrix::from_rows(&rows)?)
}

/// All sequences of so many networks on so many birds, with a constant end.
pub(super) fn histories(sizes: impl IntoIterator<Item = (usize, usize)>) -> impl Iterator<Item = NetworkHistory> {
    sizes.into_iter().flat_map(|(order, length)| NetworkHistory::all(order, length))
}

/// All switches of a flock and what becomes of it.
pub fn settled(start: &Start, run: &Run) -> Result<(Vec<Switch>, Settlement), CheckError> {
    let mut switches = Vec::new();
    let settled = settle(Flock::new(start)?, &Limits::default(), &mut |switch| switches.push(switch.clone()), run)?;
    run.checkpoint()?;
    Ok((switches, settled))
}
