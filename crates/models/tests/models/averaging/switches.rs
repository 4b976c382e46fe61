//! Switches applied to networks, single birds, weights that are not admissible.

use algebra::graph::Graph;
use arithmetic::{Rational, rational};
use models::averaging::{Flock, FlockError, Hysteresis, Start, Switch, Weights};
use num_bigint::BigInt;

#[test]
fn a_switch_makes_the_network_after_it_from_any_before() {
    for (old, new) in Graph::all(4).step_by(5).zip(Graph::all(4).skip(3)) {
        let switch = Switch::between(&old, &new, BigInt::from(7));
        assert_eq!((switch.applied_to(&old), switch.applied_to(&new)), (new.clone(), new.clone()));
        let mut network = old.clone();
        switch.apply_to(&mut network);
        assert_eq!((network, switch.time), (new, BigInt::from(7)));
    }
}

fn started(places: &[i64], weights: &[Rational]) -> Result<(), FlockError> {
    let positions = places.iter().map(|x| rational(*x, 2)).collect();
    let rest = vec![rational(0, 1); places.len()];
    Flock::new(&Start::on_the_line(positions, rest, Weights::Given(weights.to_vec()), Hysteresis::None)).map(drop)
}

/// A bird alone has no term to weigh; of several each needs a weight in (0, 1), and with `d` neighbours one below `1/d`.
#[test]
fn weights_are_asked_for_where_they_weigh() {
    for c in [rational(1, 1), rational(0, 1), rational(5, 1)] {
        assert_eq!(started(&[0], &[c]), Ok(()));
    }
    let bad = |bird: usize, degree: usize, c: &str| {
        Err(FlockError::Inadmissible { bird, degree, c: c.to_string(), time: "0".to_string() })
    };
    let third = || rational(1, 3);
    assert_eq!(started(&[0, 9], &[rational(9, 10), third()]), Ok(()));
    assert_eq!(started(&[0, 9], &[third(), rational(1, 1)]), bad(2, 1, "1"));
    assert_eq!(started(&[0, 1], &[third(), rational(-1, 3)]), bad(2, 1, "-1/3"));
    assert_eq!(started(&[0, 1, 2], &[third(), rational(49, 100), third()]), Ok(()));
    assert_eq!(started(&[0, 2, 4], &[third(), rational(1, 2), third()]), bad(2, 2, "1/2"));
    // Beyond what the start asks for: a negative weight on a network that comes later.
    assert_eq!(started(&[0, 1], &[third()]), Err(FlockError::Weights { birds: 2, bird: 2 }));
}
