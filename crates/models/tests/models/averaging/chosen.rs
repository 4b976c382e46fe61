//! Weights chosen by their shares and virtual origins, by hand.

use algebra::graph::Graph;
use arithmetic::{Rational, rational};
use models::averaging::{Flock, Hysteresis, Start, Weights, transition_matrix};

/// Degrees 3, 2, 2, 1 and a bird alone.
fn network() -> Graph {
    Graph::from_edges(5, &[(0, 1), (0, 2), (0, 3), (1, 2)]).unwrap()
}

/// The weights of the birds with neighbours; the one alone keeps its velocity whatever its weight.
fn chosen(weights: &Weights) -> Vec<Rational> {
    let matrix = transition_matrix(&network(), weights).unwrap();
    assert_eq!(matrix.to_rows()[4], [0, 0, 0, 0, 1].map(|x| rational(x, 1)));
    weights.all(&network()).unwrap()[..4].to_vec()
}

#[test]
fn one_share_for_all_is_divided_among_the_neighbours() {
    let found = chosen(&Weights::of_share(&network(), &rational(3, 5)));
    assert_eq!(found, [(1, 5), (3, 10), (3, 10), (3, 5)].map(|(p, q)| rational(p, q)));
}

/// The shares are 1/2, 2/3, 3/4, 4/5.
#[test]
fn uneven_shares_differ_from_bird_to_bird() {
    let found = chosen(&Weights::uneven(&network()));
    assert_eq!(found, [(1, 6), (1, 3), (3, 8), (4, 5)].map(|(p, q)| rational(p, q)));
}

/// `v(1) = (1/5, 0), (0, 2/5)`, and at distance 1/2 the birds are linked at `t = 1`, so that `v(2) = (3/20, 1/10), (1/15, 4/15)` and
/// `x(2) = (7/20, 1/10), (17/30, 2/3)`.
#[test]
fn virtual_origins_are_where_the_last_velocity_would_have_started() {
    let rows = |rows: [[(i64, i64); 2]; 2]| rows.map(|row| row.map(|(p, q)| rational(p, q)).to_vec()).to_vec();
    let start = Start {
        positions: rows([[(0, 1), (0, 1)], [(1, 2), (0, 1)]]),
        velocities: rows([[(1, 5), (0, 1)], [(0, 1), (2, 5)]]),
        weights: Weights::Given(vec![rational(1, 4), rational(1, 3)]),
        hysteresis: Hysteresis::None,
    };
    let mut flock = Flock::new(&start).unwrap();
    flock.step().unwrap();
    assert_eq!(flock.virtual_origins(&start.positions), start.positions);
    let before = flock.positions();
    flock.step().unwrap();
    assert_eq!(flock.virtual_origins(&before), rows([[(1, 20), (-1, 10)], [(13, 30), (2, 15)]]));
}
