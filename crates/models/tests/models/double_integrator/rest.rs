//! Configurations at rest: what of them is steady, minimal, stable, and how fast they are approached, by hand.

use super::{PLANE, spring, state};
use algebra::graph::Graph;
use algebra::matrix::Inertia;
use arithmetic::rational;
use models::double_integrator::equilibria::{Equilibrium, FLAT, Framework, classes, distances, random_places};
use models::double_integrator::relaxation::relaxation;
use models::double_integrator::{Coordinates, Pair, Potential, SteadyMotion, TiedRate, saturated_rate};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;

type Agents<'a> = &'a [((i64, i64), (i64, i64))];

fn motion(edges: &[Pair], potential: Potential, agents: Agents) -> SteadyMotion {
    SteadyMotion::new("a start", edges, PLANE, potential, agents)
}

fn of_slope(slope: i64) -> Potential {
    Potential::new(vec![(0, rational(slope, 1))], (rational(0, 1), rational(0, 1)))
}

const ALL_OF_THREE: [Pair; 3] = [(0, 1), (0, 2), (1, 2)];

#[test]
fn steady_motions_have_equal_velocities_and_no_forces() {
    // V' = 1 at s = 4: the force on agent 0 is 2 r_ij = (-4, 0) away, and the alignment with (4, 0) makes up for it.
    let strong = Potential::inverse_square_spring(&rational(1, 1), &rational(16, 15));
    let balanced = motion(&[(0, 1)], strong.clone(), &[((0, 0), (4, 0)), ((2, 0), (0, 0))]);
    assert_eq!((balanced.is_steady(), balanced.agrees(), balanced.is_critical()), (Ok(false), false, Ok(false)));
    let apart = motion(&[], strong, &[((0, 0), (4, 0)), ((2, 0), (0, 0))]);
    assert_eq!((apart.is_steady(), apart.agrees(), apart.is_critical()), (Ok(true), false, Ok(true)));
    assert!(apart.squares().is_empty());
    let along_y = motion(&[(0, 1)], spring(), &[((0, 0), (1, 0)), ((1, 0), (1, 2))]);
    assert_eq!((along_y.is_steady(), along_y.agrees()), (Ok(false), false));
    // Who starts in one place.
    let three = |r: [(i64, i64); 3]| motion(&[], spring(), &r.map(|r| (r, (0, 0)))).coincident();
    assert_eq!(three([(0, 0), (1, 1), (0, 0)]), Some((0, 2)));
    assert_eq!(three([(0, 0), (1, 1), (1, 1)]), Some((1, 2)));
    assert_eq!((three([(0, 0), (0, 1), (1, 0)]), three([(2, 2), (2, 2), (2, 2)])), (None, Some((0, 1))));
    // Triangular coordinates: |(1, 1)|² = 3.
    let triangle = SteadyMotion::new(
        "a triangle",
        &ALL_OF_THREE,
        Coordinates::Triangular,
        spring(),
        &[((0, 0), (1, 2)), ((1, 0), (1, 2)), ((1, 1), (1, 2))],
    );
    assert_eq!(triangle.squares(), [1, 3, 1].map(|s| rational(s, 1)));
}

/// A matrix with real eigenvalues has a negative one where its trace or its determinant is negative; 0 is none.
#[test]
fn agents_are_minimised_up_to_second_order() {
    let at_once = |slope: i64| motion(&[(0, 1)], of_slope(slope), &[((1, 1), (0, 0)); 2]).not_minimised();
    assert_eq!((at_once(1), at_once(0), at_once(-1)), (Ok(None), Ok(None), Ok(Some(0))));
    // A row of three at rest, also along the diagonal: across it every agent has a maximum.
    for (step, m) in [((1, 0), (4, 3)), ((1, 1), (8, 3)), ((1, 2), (20, 3))] {
        let log = Potential::inverse_square_log(&rational(m.0, m.1));
        let agents = [-1, 0, 1].map(|k| ((k * step.0, k * step.1), (0, 0)));
        let row = motion(&ALL_OF_THREE, log, &agents);
        assert_eq!((row.is_critical(), row.is_steady(), row.not_minimised()), (Ok(true), Ok(true), Ok(Some(0))));
        assert_eq!(row.is_stable_up_to_motions(), Some(false));
    }
    // Only the middle agent of this row is one: the others are held from afar.
    let cross = [((0, 0), (0, 0)), ((9, 0), (0, 0)), ((9, 1), (0, 0))];
    let late = motion(&[(1, 2)], of_slope(1), &cross).not_minimised();
    assert_eq!(late, Ok(Some(1)), "pushed");
}

#[test]
fn stability_leaves_out_the_five_motions_of_a_body() {
    let stable = |edges: &[Pair], agents: Agents| {
        SteadyMotion::new("a body", edges, Coordinates::Triangular, spring(), agents).is_stable_up_to_motions()
    };
    let corners: Agents = &[((0, 0), (0, 0)), ((1, 0), (0, 0)), ((0, 1), (0, 0))];
    assert_eq!(stable(&ALL_OF_THREE, corners), Some(true));
    // A hinge: one eigenvalue 0 more. Two bodies: four more.
    assert_eq!(stable(&[(0, 1), (0, 2)], corners), Some(false));
    assert_eq!(stable(&[(0, 1)], corners), Some(false));
}

/// R = 2: agents 0 and 1 are linked at distance 1, agent 2 is tied to agent 1 and approaches or leaves.
#[test]
fn ties_are_rated_by_their_slope_and_speed() {
    for speed in [-3, 0, 5] {
        let state = state(&[(0, 0), (2, 0), (2, 4)], &[(2, 0), (0, 0), (0, 2 * speed)]);
        let square = rational(4, 1);
        let found = TiedRate::of(&state, &square, &spring()).unwrap();
        // Velocities are given in halves: v = (1, 0), (0, 0), (0, speed). V'(4) = 15/16.
        let known = (rational(15, 16) * rational(4 * speed, 1), rational(speed * speed, 1));
        assert_eq!((found.base.clone(), &found.ties[..]), (rational(-1, 1), &[known.clone()][..]));
        assert_eq!(found.all_linked(), -rational(1 + speed * speed, 1));
        assert_eq!((found.hull().lo, found.hull().hi), (-rational(1 + speed * speed, 1), rational(-1, 1)));
        // Forward in time an approaching pair pulls: the energy of the outer side would not change with the distance.
        let (rate, form) = saturated_rate(&state, &square, &spring()).unwrap();
        assert_eq!(form, rational(-1, 1));
        assert_eq!(rate, rational(-1, 1) + known.0.clone().min(rational(0, 1)));
        // z p - m (p + q) for all z in [0, 1]: what every interval [z p - (p + q), z p] has in common.
        let (p, q) = known;
        let derivative = found.derivative();
        for k in -400..=400 {
            let x = rational(k, 8);
            let inside = (0..=8).all(|z| {
                let (a, b) = (&p * rational(z, 8), &p * rational(z, 8) - (&p + &q));
                a.clone().min(b.clone()) <= x && x <= a.max(b)
            });
            assert_eq!(derivative.contains(&(&x - rational(1, 1))), inside, "{speed}: {x}");
        }
    }
}

fn complete(count: usize) -> Framework {
    let graph = Graph::from_fn(count, |_, _| true);
    Framework { edges: graph.edges(), potential: Potential::inverse_square_log(&rational(1, 1)) }
}

fn triangle() -> Equilibrium {
    complete(3).descend(&[[0.0, 0.0], [1.2, 0.1], [0.4, 0.8]]).unwrap()
}

/// Bars of stiffness 4: the triangle breathes with 12 and bends with 6, twice, and the alignment has the eigenvalue 3 for all but uniform
/// motions: `mu² + 3 mu + 12`, `mu² + 3 mu + 6`, and `mu (mu + 3)` for rotations.
#[test]
fn the_rates_of_a_triangle_are_known() {
    let found = relaxation(&complete(3), &triangle()).unwrap();
    assert!((found.rate - 1.5).abs() < 1e-7 && found.swings && found.neutral == 1, "{found:?}");
    assert!(found.residual < 1e-9, "{found:?}");
    let soft = Framework { potential: complete(3).potential.times(&rational(1, 64)), ..complete(3) };
    let found = relaxation(&soft, &triangle()).unwrap();
    let slow = (3.0 - (9.0f64 - 24.0 / 64.0).sqrt()) / 2.0;
    assert!((found.rate - slow).abs() < 1e-7 && !found.swings && found.neutral == 1, "{found:?} {slow}");
    assert!(found.residual < 1e-9, "{found:?}");
    // A path of three with a right angle bends freely, with mu = 0 beside that of rotations.
    let path = Framework { edges: Graph::path(3).edges(), ..complete(3) };
    let hinge = path.descend(&[[1.0, 0.0], [0.0, 0.0], [0.0, 1.0]]).unwrap();
    let found = relaxation(&path, &hinge).unwrap();
    assert!(found.neutral == 2 && found.rate > 0.1 && found.residual < 1e-9, "{found:?}");
    let alone = Equilibrium {
        positions: vec![[1.0, 2.0]],
        energy: 0.0,
        inertia: Inertia { positive: 0, negative: 0, zero: 2 },
    };
    let found = relaxation(&complete(1), &alone).unwrap();
    assert_eq!((found.rate, found.swings, found.neutral, found.residual), (f64::INFINITY, false, 0, 0.0));
}

/// Energies, signs and distances of what is found: the triangle, and the row of three with neighbours at the distance `sqrt(3/4)`.
#[test]
fn equilibria_are_described_by_their_numbers() {
    let known = |found: &Equilibrium, energy: f64, sides: [f64; 3], signs: [usize; 3]| {
        assert!((found.energy - energy).abs() < 1e-9, "{found:?}");
        assert!(distances(&found.positions).iter().zip(sides).all(|(a, b)| (a - b).abs() < 1e-7), "{found:?}");
        assert_eq!([found.inertia.negative, found.inertia.zero, found.inertia.positive], signs);
    };
    known(&triangle(), 3.0, [1.0; 3], [0, 3, 3]);
    // V = 1/s + ln s: 4/3 + ln(3/4) twice, 1/3 + ln 3.
    let a = 0.75f64.sqrt();
    let row = complete(3).approach(&[[0.1 - a, 0.0], [0.0, 0.0], [a, 0.0]]).unwrap();
    known(&row, 3.0 + 2.0 * 0.75f64.ln() + 3f64.ln(), [a, a, 2.0 * a], [1, 3, 2]);
    let up = complete(3).approach(&[[1.0, -a - 0.05], [1.0, 0.0], [1.0, a]]).unwrap();
    let all = classes([triangle(), row.clone(), triangle(), up, row, triangle()]);
    let counts: Vec<usize> = all.iter().map(|(_, times)| *times).collect();
    assert_eq!(counts, [3, 3]);
    assert!(all[0].0.energy < all[1].0.energy);
    assert_eq!(FLAT, 1e-6);
    assert_eq!(distances(&[[0.0, 0.0], [3.0, 4.0], [0.0, 1.0]]), [1.0, 18f64.sqrt(), 5.0]);
    assert!(complete(2).approach(&[[0.0, 0.0], [0.0, 0.0]]).is_none(), "no slope");
    assert!(complete(2).descend(&[[0.0, 0.0], [0.0, 0.0]]).is_none());
    let places = random_places(2000, &mut ChaCha8Rng::seed_from_u64(3));
    let all = || places.iter().flatten().copied();
    assert!((0.0..0.01).contains(&all().fold(9.0, f64::min)) && (1.99..=2.0).contains(&all().fold(0.0, f64::max)));
}

/// What is spread over more than ten times as many units as there are agents is not at rest, though nothing pulls any more.
#[test]
fn agents_far_from_each_other_are_not_at_rest() {
    // V' falls like 1/s²: below any bound soon, at no distance zero.
    let repelling = Framework {
        edges: vec![(0, 1)],
        potential: Potential::new(vec![(-9, rational(-1, 1))], (rational(1, 1), rational(1, 1))),
    };
    let near = |x: f64| repelling.approach(&[[0.0, 0.0], [x, 0.0]]).is_some();
    assert_eq!((near(19.9), near(20.1)), (true, false));
    assert!(near(9.0), "2 V' r = 2/9^17");
}

/// A certificate is refused where it would not be true: three agents on a line whose neighbours have no stiffness, and starts that are far off.
#[test]
fn certificates_need_a_hessian_without_further_zeros() {
    let frame = complete(3);
    let proved = frame.enclose(&triangle()).unwrap();
    assert_eq!((proved.negative, proved.zero, proved.positive), (0, 0, 3));
    // Turned and moved, and named in another order.
    let (s, c) = 2.1f64.sin_cos();
    let turned = |r: &[f64; 2]| [3.0 + c * r[0] - s * r[1], -7.0 + s * r[0] + c * r[1]];
    let positions: Vec<[f64; 2]> = triangle().positions.iter().rev().map(turned).collect();
    assert_eq!(frame.enclose(&Equilibrium { positions: positions.clone(), ..triangle() }), Some(proved));
    // All in one place, and a potential whose Hessian vanishes at the minimum: V' = (s - 1)³.
    assert!(frame.enclose(&Equilibrium { positions: vec![[1.0, 1.0]; 3], ..triangle() }).is_none());
    let cubic = Potential::new(
        [(3, 1), (2, -3), (1, 3), (0, -1)].map(|(k, c)| (k, rational(c, 1))).to_vec(),
        (rational(1, 1), rational(0, 1)),
    );
    let flat = Framework { potential: cubic, ..frame };
    assert!(flat.enclose(&Equilibrium { positions, ..triangle() }).is_none());
}
