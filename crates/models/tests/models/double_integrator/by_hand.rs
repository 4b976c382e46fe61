//! Weights of the swing, fields with a jump, modes of loops and rates along the ways on, by hand.

use super::{PLANE, spring};
use algebra::spectrum::Polynomial;
use arithmetic::{ArithmeticError, Rational, rational};
use models::double_integrator::{
    Coordinates, Pair, Potential, Span, State, StepField, Way, loop_modes, rate_along, real_decaying_modes,
    swing_weights,
};

fn whole(x: i64) -> Rational {
    rational(x, 1)
}

fn state(positions: &[(i64, i64)], velocities: &[(i64, i64)]) -> State<Rational> {
    let vectors = |list: &[(i64, i64)]| list.iter().map(|&(x, y)| [whole(x), whole(y)]).collect();
    State { positions: vectors(positions), velocities: vectors(velocities) }
}

/// `2 V'(d²) d` for `V = s + 1/s - 2`.
fn force(d: Rational) -> Rational {
    (&d - whole(1) / (&d * &d * &d)) * whole(2)
}

/// Links pull with `force(d)` and drag with the difference of the velocities. Agent 3 in the middle with velocity 1/50: it has the
/// acceleration -2/50 of the pair, to which its own drag adds 1/50 at both agents.
#[test]
fn the_swing_at_the_middle() {
    let found = swing_weights(&whole(0), &whole(1)).unwrap().unwrap();
    let (near, far) = (force(rational(9, 10)), force(rational(9, 5)));
    let expected = [(rational(-3, 50) - &near) / &far, (rational(3, 50) - &near) / &far];
    assert_eq!(found, expected);
    assert_eq!(found, [rational(32203, 118720), rational(36577, 118720)]);
    let [one, two] = found;
    assert_eq!(swing_weights(&whole(0), &whole(-1)).unwrap(), Some([two, one]), "the mirrored motion");
}

/// Agent 3 at rest, at distances 23/25 and 22/25, with the acceleration of the pair minus 1/50.
#[test]
fn the_swing_at_its_end() {
    let (left, right, far) = (force(rational(23, 25)), force(rational(22, 25)), force(rational(9, 5)));
    let pair = &right - &left + rational(1, 50);
    let expected = [(&pair - &left) / &far, -(&pair + &right) / &far];
    assert_eq!(swing_weights(&whole(1), &whole(0)).unwrap(), Some(expected));
    // At 44/50 from the middle both distances are below 9/5, at 46/50 one is not.
    assert!(swing_weights(&whole(-44), &whole(0)).unwrap().is_some());
    assert_eq!([46, -46].map(|sine| swing_weights(&whole(sine), &whole(0))), [Ok(None), Ok(None)]);
}

#[test]
fn solutions_from_a_jump() {
    let fields: Vec<StepField> = StepField::all().collect();
    assert_eq!(fields.len(), 9);
    for (left, right, rays) in [
        (-1, -1, vec![-1]),
        (-1, 0, vec![-1, 0]),
        (-1, 1, vec![-1, 0, 1]),
        (0, -1, vec![0]),
        (0, 0, vec![0]),
        (0, 1, vec![0, 1]),
        (1, -1, vec![0]),
        (1, 0, vec![0]),
        (1, 1, vec![1]),
    ] {
        let field = StepField { left, right };
        assert!(fields.contains(&field));
        assert_eq!(field.rays(), rays, "{field:?}");
    }
    let span = |lo, hi| Span { lo: whole(lo), hi: whole(hi) };
    let field = StepField { left: 3, right: -2 };
    assert_eq!([-5, 0, 5].map(|c| field.inclusion(c)), [span(3, 3), span(-2, 3), span(-2, -2)]);
}

/// With `r = r_1 - r_2` the law is `r'' = -2 r' - 4 V'(s) r`, and the centre moves freely: four zeros.
#[test]
fn modes_of_two_agents() {
    let of = |places, links: &[Pair], coordinates, potential: &Potential| {
        loop_modes(&state(places, &[(0, 0); 2]), links, coordinates, potential)
    };
    let polynomial = |c: &[i64]| Polynomial::from_rationals(&c.iter().map(|&c| whole(c)).collect::<Vec<_>>());
    // At length 1, where V' = 0 and V'' = 2 k: along the bar x² + 2 x + 16 k, across it x (x + 2).
    let half = Potential::inverse_square_spring(&whole(1), &rational(1, 2));
    let apart: &[(i64, i64)] = &[(0, 0), (1, -1)];
    let linked = of(apart, &[(0, 1)], Coordinates::Triangular, &half);
    assert_eq!(linked, Ok((5, polynomial(&[16, 12, 4, 1]))));
    // At s = 2, where V' = 3/4 and V'' = 1/4: along x² + 2 x + 4 (V' + 2 s V''), across x² + 2 x + 4 V'.
    let stretched = of(apart, &[(0, 1)], PLANE, &spring());
    assert_eq!(stretched, Ok((4, polynomial(&[21, 20, 14, 4, 1]))));
    assert_eq!(of(apart, &[], PLANE, &spring()), Ok((8, polynomial(&[1]))));
    let none = loop_modes(&state(&[], &[]), &[], PLANE, &spring());
    assert_eq!(none, Err(ArithmeticError::Domain("at least one agent")));
}

/// With half diagonals `X = 1/2` and `Y = sqrt3/2`, `A = V''(1)` and `B = V''(3)`, small changes of both obey `x² + 4 x + k` with the
/// eigenvalues `k` of `[[10 A, 2 sqrt3 A], [2 sqrt3 A, 6 A + 24 B]]`: real and decaying where `0 < k < 4`.
#[test]
fn modes_of_the_rhombus() {
    let three = whole(3);
    let modes = |potential: &Potential, square: &Rational| real_decaying_modes(potential, square).unwrap();
    // A = 32/5 and B = 0: k = 4 A and 12 A, so up to the factor 5/96.
    let flat = Potential::with_inflection(&three);
    let times = |p: i64, q: i64| flat.times(&rational(p, q));
    assert_eq!(modes(&times(1, 20), &three), Some(4));
    assert_eq!(modes(&times(1, 19), &three), None, "two turn");
    assert_eq!(modes(&times(-1, 20), &three), None, "two grow");
    assert_eq!(modes(&times(1, 20), &whole(2)), None, "the long diagonal is not at R");
    assert_eq!(modes(&spring(), &three), None, "the long diagonal is stretched");
    // (s - 1)(s - 2)(s - 3), with A = B = 2: k = 40 + sqrt 448 and 40 - sqrt 448, so up to the factor 0.0654.
    let slope = [(3, 1), (2, -6), (1, 11), (0, -6)].map(|(k, c)| (k, whole(c)));
    let cubic = Potential::new(slope.to_vec(), (whole(1), whole(0)));
    assert_eq!(modes(&cubic.times(&rational(1, 16)), &three), Some(4));
    assert_eq!(modes(&cubic.times(&rational(1, 15)), &three), None);
}

/// Agents at (0, 0), (2, 0), (0, 1) and `R = 2`: the first two are tied, the first and the third linked, the others beyond `R`. The link in
/// force turns potential into motion and loses `|v_1 - v_3|² = 2`, a tied pair its weight times `|v_1 - v_2|²`.
#[test]
fn rates_along_the_ways_on() {
    // V' = 1/2 - 2/s²: 3/8 at s = 4 and 21/50 at s = 5.
    let potential = Potential::inverse_square_spring(&whole(2), &whole(1));
    let rates = |speed: i64, way: Way<Rational>| {
        let state = state(&[(0, 0), (2, 0), (0, 1)], &[(0, 0), (speed, 3), (1, -1)]);
        let ways = [((0, 1), way)];
        [true, false].map(|cut| rate_along(&state, &whole(4), &potential, &ways, cut).unwrap())
    };
    // Potentials that are not cut off also change with the pairs that no link joins: s grows at 4 and at -8.
    let parting = rational(3, 8) * whole(4) - rational(21, 50) * whole(8);
    assert_eq!(rates(1, Way::Leaves), [(whole(-2), whole(-2)), (whole(-2) + parting, whole(-2))]);
    // |v_1 - v_2|² = 10; the last two approach with the rate -16 of s.
    let beyond = rational(21, 50) * whole(-16);
    assert_eq!(rates(-1, Way::Enters), [(whole(-12), whole(-12)), (whole(-12) + beyond, whole(-12))]);
    // |v_1 - v_2|² = 9 with weight 1/3, at rest radially; the last two approach with the rate -12 of s.
    let beyond = rational(21, 50) * whole(-12);
    assert_eq!(rates(0, Way::Stays(rational(1, 3))), [(whole(-5), whole(-5)), (whole(-5) + beyond, whole(-5))]);
    let pair = state(&[(0, 0), (2, 0)], &[(0, 0), (0, 3)]);
    for way in [((0, 2), Way::Enters), ((0, 7), Way::Leaves), ((1, 1), Way::Enters)] {
        let missing = rate_along(&pair, &whole(4), &potential, &[way], true);
        assert!(matches!(missing, Err(ArithmeticError::Domain(_))));
    }
}
