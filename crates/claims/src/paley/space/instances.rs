//! Instances shared by the claims about particles: identities over states, graphs, phasors.

use crate::prelude::*;
use algebra::graph::{Graph, classes};
use arithmetic::Unwatched;
use arithmetic::identity::Probed;
use models::oscillator::{State, phasor};

/// Both sides as a function of the constants and the state.
type SidesAt<'a> = Box<dyn Fn(&[Probe], &State<Probe>) -> Probed + 'a>;

/// An identity between rational functions of some constants and of the state of some particles.
pub struct StateIdentity<'a> {
    particles: usize,
    sides: SidesAt<'a>,
    allowed: fn(&[Rational]) -> bool,
}

impl<'a> StateIdentity<'a> {
    /// On so many particles.
    pub fn new(particles: usize, sides: impl Fn(&[Probe], &State<Probe>) -> Probed + 'a) -> Self {
        StateIdentity { particles, sides: Box::new(sides), allowed: |_| true }
    }

    /// The same with `N` constants.
    pub fn of<const N: usize>(particles: usize, sides: impl Fn(&[Probe; N], &State<Probe>) -> Probed + 'a) -> Self {
        let number = |_| ArithmeticError::Domain("as many constants as the identity has");
        Self::new(particles, move |constants, state| sides(constants.try_into().map_err(number)?, state))
    }

    /// A counterexample may have these variables, constants first.
    pub fn allowing(self, allowed: fn(&[Rational]) -> bool) -> Self {
        StateIdentity { allowed, ..self }
    }
}

/// Tests an identity in the constants, the coordinates and the half-angle tangents of the phases at random points.
pub fn state_identity<S: ToString>(
    identity: StateIdentity,
    constants: &[S],
    part: &str,
    run: &Run,
) -> Result<Outcome, CheckError> {
    let of_particle = |k: usize| [format!("x_{k}"), format!("y_{k}"), format!("tan(th_{k}/2)")];
    let names = constants.iter().map(ToString::to_string);
    let names: Vec<String> = names.chain((1..=identity.particles).flat_map(of_particle)).collect();
    let sides = move |at: &[Probe]| {
        let (constants, coordinates) = at.split_at(constants.len());
        let state = State {
            positions: coordinates.chunks(3).map(|c| Complex::new(c[0].clone(), c[1].clone())).collect(),
            phasors: coordinates.chunks(3).map(|c| phasor(&c[2])).collect::<Result<_, _>>()?,
        };
        (identity.sides)(constants, &state)
    };
    run.identity(&Identity::new(names.len(), sides).within(identity.allowed), &names, part)
}

/// The graphs on which identities are tested: a vertex, a pair, a path of three; with `full`, all on three and one of each kind on four. Every
/// term of the identities belongs to a particle and at most two neighbours.
pub fn identity_graphs(run: &Run) -> Result<Vec<Graph>, CheckError> {
    let wanted = |g: &Graph| g.order() < 3 || *g == Graph::path(3) || run.cases(0, 1) == 1;
    Ok(connected_graphs(false)?.into_iter().filter(wanted).collect())
}

/// All connected graphs on one to three vertices and one of each kind on four; with `full`, all labelled ones on four.
pub fn connected_graphs(full: bool) -> Result<Vec<Graph>, CheckError> {
    let labelled = (1..=if full { 4 } else { 3 }).flat_map(Graph::all).filter(Graph::is_connected);
    let kinds = if full { Vec::new() } else { classes::connected_graphs(4, &Unwatched)? };
    Ok(labelled.chain(kinds).collect())
}

/// The vertices and edges in words, vertices from 1.
pub fn described(graph: &Graph) -> String {
    let edges: Vec<String> = graph.edges().iter().map(|(i, j)| format!("{}-{}", i + 1, j + 1)).collect();
    format!("N = {}, edges {{{}}}", graph.order(), edges.join(", "))
}

/// Unequal phasors with rational coordinates, none opposite to another.
pub fn scattered_phasors(particles: usize) -> Result<Vec<Complex<Rational>>, CheckError> {
    let tangents = [(0, 1), (1, 2), (3, 1), (-1, 3), (-5, 2), (2, 3)];
    Ok(tangents.iter().cycle().take(particles).map(|&(p, q)| phasor(&rational(p, q))).collect::<Result<_, _>>()?)
}

/// The sum of squares.
pub fn sum_of_squares<T: Ring>(terms: &[T], like: &T) -> T {
    terms.iter().fold(like.zero(), |sum, term| sum + term.square())
}
