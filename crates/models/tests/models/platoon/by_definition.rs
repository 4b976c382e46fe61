//! Responses, modes and neighbourhoods against the equations themselves.

use algebra::matrix::solve_over_field;
use arithmetic::{Complex, Interval, Rational, Ring, Series, rational};
use models::platoon::modes::Mode;
use models::platoon::{
    Communication, CommunicationError, CommunicationGraph, Gains, Neighbourhood, amplitude_with_first_car,
};

fn real(x: Rational) -> Complex<Rational> {
    Complex::real(x)
}

/// The linear system of the amplitudes, solved: car 1 compares velocities with other weights.
#[test]
fn another_first_car_gives_the_solution_of_the_linear_system() {
    let gains = Gains { f: rational(-2, 1), g: rational(-3, 1) };
    let w = rational(1, 2);
    for weights in [[1, 1, 0], [2, 1, 1], [3, 5, 7]].map(|q| q.map(|q| rational(q, 3))) {
        let [own, leader, behind] = weights.clone();
        for followers in 2..=6usize {
            let (f, damping) = (real(gains.f.clone()), Complex::new(rational(0, 1), &w * &gains.g));
            let half = real(rational(1, 2));
            let row = |k: usize| {
                let mut row = vec![real(rational(0, 1)); followers + 1];
                row[k - 1] = real(&w * &w) + &f;
                if k == 1 {
                    row[0] = row[0].clone() + damping.clone() * &real(own.clone());
                    row[1] = -(f.clone() * &half + damping.clone() * &real(behind.clone()));
                    row[followers] = f.clone() * &half + damping.clone() * &real(leader.clone());
                } else {
                    let both = f.clone() + &damping;
                    row[k - 1] = row[k - 1].clone() + &damping;
                    let ahead = if k == followers { both.clone() } else { both.clone() * &half };
                    row[k - 2] = -ahead;
                    if k < followers {
                        row[k] = -(both * &half);
                    }
                }
                row
            };
            let solution = solve_over_field((1..=followers).map(row).collect()).expect("regular");
            let found = amplitude_with_first_car(&gains, &w, followers as u64, &weights).expect("a response");
            assert_eq!(found, solution[followers - 1], "{followers} followers, {weights:?}");
        }
    }
}

/// `z'' = lambda (f z + g z')` gives `c(2t) = c² - lambda |f| s²`, `s(2t) = 2 s (c - decay s)`, and `s = t - decay t² + ..`.
#[test]
fn motions_of_modes_double_and_begin_as_the_equation_says() {
    let number = |x: Rational| Interval::from_rational(&x, 200);
    let meet = |a: &Interval, b: &Interval| {
        let ((al, ah), (bl, bh)) = (a.to_rationals(), b.to_rationals());
        al <= bh && bl <= ah && &ah - &al < rational(1, 1 << 40)
    };
    for (f, g, lambda) in
        [(-1, -4, (1, 1)), (-1, -1, (1, 3)), (-3, -4, (2, 3)), (-1, -9, (7, 5)), (-1, -2, (1, 1)), (-9, -6, (1, 1))]
    {
        let gains = Gains { f: number(rational(f, 1)), g: number(rational(g, 1)) };
        let lambda = rational(lambda.0, lambda.1);
        let mode = Mode::new(&gains, &number(lambda.clone())).expect("a mode");
        for t in [rational(1, 64), rational(1, 5), rational(2, 3), rational(4, 1)] {
            let at = |t: &Rational| mode.propagator(&number(t.clone())).expect("a motion");
            let ((c, s), (c2, s2)) = (at(&t), at(&(&t + &t)));
            let stiffness = number(&lambda * rational(-f, 1));
            let square = |x: &Interval| x.clone() * x;
            assert!(meet(&c2, &(square(&c) - stiffness * square(&s))), "c, {f} {g} {lambda} at {t}");
            let twice = (c - mode.decay.clone() * &s) * &s;
            assert!(meet(&s2, &(twice.clone() + &twice)), "s, {f} {g} {lambda} at {t}");
        }
        let t = rational(1, 1 << 10);
        let (_, s) = mode.propagator(&number(t.clone())).expect("a motion");
        let decay = &lambda * rational(-g, 2);
        let (lo, hi) = s.to_rationals();
        let rest = (&t - &decay * &t * &t - lo).max(hi - (&t - &decay * &t * &t));
        // The next term is (4 decay² - lambda |f|) t³/6.
        assert!(rest < rational(64, 1) * &t * &t * &t && rest > -(rational(64, 1) * &t * &t * &t));
    }
}

#[test]
fn moments_symbols_and_margins_of_wide_rules() {
    let rule = |weights: &[(i64, i64)]| Neighbourhood::new(weights.iter().map(|&(d, w)| (d, rational(w, 1))));
    let wide = rule(&[(-3, 2), (-1, 1), (2, 1)]).expect("a rule");
    assert_eq!([1, 2, 3].map(|n| wide.moment(n)), [rational(-5, 4), rational(23, 4), rational(-47, 4)]);
    for q in [0.3f64, 1.0, 2.5] {
        let l = wide.symbol(q);
        let re = 1.0 - (2.0 * (3.0 * q).cos() + q.cos() + (2.0 * q).cos()) / 4.0;
        let im = -(-2.0 * (3.0 * q).sin() - q.sin() + (2.0 * q).sin()) / 4.0;
        assert!((l.re - re).abs() < 1e-14 && (l.im - im).abs() < 1e-14);
    }
    // Nearest neighbours alike: l = 1 - cos q = 2 sin²(q/2), the margin is g²/8 at every wave number.
    let margin = rule(&[(-1, 1), (1, 1)]).expect("a rule").wave_margin(&Gains { f: -3.0, g: -2.0 });
    assert!((margin - 0.5).abs() < 1e-9, "{margin}");
    // One more behind than in front: waves with (Im l)² |f| above g² Re l |l|² grow, for strong f only.
    let uneven = rule(&[(-1, 1), (1, 2)]).expect("a rule");
    assert!(uneven.wave_margin(&Gains { f: -0.001, g: -3.0 }) < 0.0);
    let own = Gains { f: -0.5, g: -3.0 };
    let at = |k: u32| {
        let q = std::f64::consts::PI * f64::from(k) / 720.0;
        let l = uneven.symbol(q);
        (9.0 * l.re * (l.re * l.re + l.im * l.im) - 0.5 * l.im * l.im) / (2.0 * (0.5 * q).sin()).powi(6)
    };
    let least = (2..=720).map(at).fold(f64::INFINITY, f64::min);
    assert!((uneven.wave_margin(&own) / least - 1.0).abs() < 1e-12);
    let thirds = Neighbourhood::new([(-1, rational(1, 3)), (1, rational(1, 6))]).expect("weights below one");
    assert_eq!(thirds.weights(), [(-1, rational(2, 3)), (1, rational(1, 3))]);
    assert_eq!(rule(&[(0, 1)]), Err(CommunicationError::Weights(0)));
    let sums = [rule(&[]), rule(&[(0, 1)]), rule(&[(-1, -1), (1, 3)]), rule(&[(-1, 0)])];
    assert!(sums.iter().all(Result::is_err));
}

/// Nobody is so far away; sums of offsets and places do not overflow.
#[test]
fn offsets_of_any_size_lead_to_nobody() {
    let far = Neighbourhood::new([(i64::MIN, rational(1, 1)), (-1, rational(1, 1)), (i64::MAX, rational(1, 1))]);
    let far = far.expect("a rule");
    assert_eq!(far.graph(3), CommunicationGraph::of(Communication::Front, 3));
    assert_eq!(far.graph(usize::MAX), Err(CommunicationError::TooManyFollowers(usize::MAX)));
}

#[test]
fn communication_graphs_are_connected_whichever_way_they_track() {
    let graph = |tracked: &[&[usize]]| {
        CommunicationGraph::with_equal_weights(&tracked.iter().map(|row| row.to_vec()).collect::<Vec<_>>())
            .expect("a graph")
    };
    // Car 2 tracks car 1, and nobody tracks the leader but car 1; or car 1 tracks car 2 alone.
    for (tracked, connected, reached) in [
        (vec![&[0usize][..], &[1]], true, vec![true, true, true]),
        (vec![&[2usize][..], &[0]], true, vec![true, true, true]),
        (vec![&[2usize][..], &[1]], false, vec![true, false, false]),
        (vec![&[0usize][..], &[3], &[2]], false, vec![true, true, false, false]),
    ] {
        let graph = graph(&tracked);
        assert_eq!((graph.is_connected(), graph.reached_by_leader()), (connected, reached), "{tracked:?}");
    }
}

/// `gamma² - 1 = -2 (w²/|f|) E²` to the order asked for, and `gamma = 1 - w²/(|f| + i w |g|)`.
#[test]
fn the_expansion_of_theorem_1_fulfils_its_equation_to_every_order() {
    for (r, g) in [(rational(2, 3), rational(5, 7)), (rational(3, 1), rational(1, 9))] {
        let order = 9;
        let [gamma, e] = models::platoon::theorem1::expansion(&r, &g, order).expect("a unit");
        let constant = |x: Rational| Series::constant(Complex::real(x), order);
        let w = Series::variable(Complex::real(rational(1, 1)), order);
        let size = &r * &r;
        let two = Complex::real(rational(2, 1) / &size);
        let left = gamma.square() - constant(rational(1, 1)) + (w.square() * e.square()).scale(&two);
        assert!(left.coefficients().iter().all(|c| *c == Complex::real(rational(0, 1))), "{left:?}");
        let denominator = constant(size) + Series::variable(Complex::new(rational(0, 1), g), order);
        let right = w.square() - (constant(rational(1, 1)) - &gamma) * &denominator;
        assert!(right.coefficients().iter().all(|c| *c == Complex::real(rational(0, 1))), "{right:?}");
    }
}
