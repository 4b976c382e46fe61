//! Numbers of agents that are not there, and lists of other lengths: an answer or an error, never a panic.

use algebra::matrix::SparseMatrix;
use arithmetic::{ArithmeticError, Complex, rational};
use models::double_integrator::{
    Coordinates, State, disagreements, gyroscopic, potential_energy, potential_gradients, velocity_alignment,
};
use models::oscillator::{Interaction, Neighbours, laplacian_rows};
use models::tracks::{Scale, Tracks, nearest_neighbour, partner_potential, smoothed};

#[test]
fn links_to_agents_that_are_not_there_are_refused() {
    let state = State { positions: vec![[0.0, 0.0], [1.0, 0.0]], velocities: vec![[1.0, 0.0], [0.0, 1.0]] };
    let (edges, plane) = (&[(0, 1), (1, 2)][..], Coordinates::Cartesian);
    let slope = |_: usize, _: usize, _: &f64| Ok(1.0);
    let refused = ArithmeticError::Domain("links between agents that are there");
    assert_eq!(potential_gradients(&state.positions, edges, plane, slope), Err(refused.clone()));
    assert_eq!(velocity_alignment(&state, edges, plane, slope), Err(refused.clone()));
    assert_eq!(potential_energy(&state.positions, edges, plane, slope), Err(refused.clone()));
    assert_eq!(gyroscopic(&state, &state.velocities, edges, |_, _| 0.0), Err(refused));
    assert_eq!(disagreements(&state.velocities, edges), disagreements(&state.velocities, &edges[..1]));
}

#[test]
fn networks_leave_out_what_is_not_there() {
    let x: Vec<Complex<f64>> = [1.0, 3.0, 7.0].map(|x| Complex::new(x, 0.0)).to_vec();
    let complete = Neighbours::complete(3);
    assert_eq!(complete.laplacian_of(&x[..2]), Neighbours::complete(2).laplacian_of(&x[..2]));
    assert!(complete.of_particle(3).is_empty());
    assert_eq!(Neighbours::circulant(5, &[1, usize::MAX]), Neighbours::circulant(5, &[1]));
    assert_eq!(Neighbours::circulant(0, &[1]).particles(), 0);
    let entries = [(0, 0, rational(1, 1)), (0, 1, rational(-1, 1)), (1, 1, rational(2, 1))];
    let laplacian = SparseMatrix::from_entries(2, entries);
    assert_eq!(laplacian_rows(&laplacian, &x), laplacian_rows(&laplacian, &x[..2]));
    assert_eq!(laplacian_rows(&laplacian, &x[..1]), x[..1]);
}

#[test]
fn fish_that_are_not_there_have_no_neighbours() {
    let places: Vec<Complex<f64>> = [0.0, 1.0, 3.0].map(|x| Complex::new(x, 0.0)).to_vec();
    assert_eq!(nearest_neighbour(&places, 3, None), 3);
    assert_eq!(nearest_neighbour(&places[..1], 0, Some(1.0)), 0);
    assert_eq!(partner_potential(&[1, 9], &places[..2]), 0.25);
    assert!(Scale::Figure.difference(0, 0.0, 0.0).is_finite());
    let tracks = Tracks::from_csv("t,id,x,y\n0,a,0,0\n0,b,1,0\n1,a,0,1\n1,b,1,1\n2,a,0,2\n2,b,1,2\n").expect("a table");
    assert!(smoothed(&tracks, 7, 1).is_empty());
    assert!(smoothed(&tracks, 0, usize::MAX).iter().all(Option::is_none));
}
