//! Exact flocks against a naive twin over rationals, and what must not change their networks.

use algebra::graph::Graph;
use algebra::matrix::StochasticMatrix;
use arithmetic::{Rational, Sign, rational, sign_of_square_root_difference};
use models::averaging::read::{Model, read_flock};
use models::averaging::{Flock, FlockError, Hysteresis, Start, Weights, transition_matrix};
use proptest::prelude::*;

/// Model D written down directly, over reduced rationals.
pub struct Naive {
    pub start: Start,
    pub network: Graph,
}

impl Naive {
    pub fn new(start: &Start) -> Self {
        let x = &start.positions;
        let network = Graph::from_fn(x.len(), |i, j| squared(&minus(&x[i], &x[j])) <= rational(1, 1));
        Naive { start: start.clone(), network }
    }

    pub fn step(&mut self) {
        let (x, v) = (&self.start.positions, &self.start.velocities);
        let moved: Vec<Vec<Rational>> =
            x.iter().zip(v).map(|(a, b)| a.iter().zip(b).map(|(p, q)| p + q).collect()).collect();
        let epsilon = match &self.start.hysteresis {
            Hysteresis::None => rational(0, 1),
            Hysteresis::Constant(c) => c.clone(),
            Hysteresis::Paper => {
                let n = x.len() as i64;
                rational(1, 1) / rational(n, 1).pow(n.pow(4) as i32)
            }
        };
        let joined = |i: usize, j: usize| {
            let (now, before) = (squared(&minus(&moved[i], &moved[j])), squared(&minus(&x[i], &x[j])));
            let (large, small) = if now > before { (&now, &before) } else { (&before, &now) };
            let held = self.network.has_edge(i, j)
                && sign_of_square_root_difference(large, small, &epsilon) == Some(Sign::Negative);
            now <= rational(1, 1) || held
        };
        self.network = Graph::from_fn(x.len(), joined);
        let p = transition_matrix(&self.network, &self.start.weights).expect("weights for every bird");
        let column = |k: usize| p.apply(&v.iter().map(|row| row[k].clone()).collect::<Vec<_>>()).expect("fits");
        let columns: Vec<Vec<Rational>> = (0..v[0].len()).map(column).collect();
        self.start.velocities = (0..v.len()).map(|i| columns.iter().map(|c| c[i].clone()).collect()).collect();
        self.start.positions = moved;
    }
}

fn minus(a: &[Rational], b: &[Rational]) -> Vec<Rational> {
    a.iter().zip(b).map(|(p, q)| p - q).collect()
}

fn squared(a: &[Rational]) -> Rational {
    a.iter().map(|x| x * x).sum()
}

fn weights(birds: usize) -> impl Strategy<Value = Weights> {
    let given = prop::collection::vec((1i64..7, 100i64..400), birds);
    // Below 1/(n - 1) for every network.
    let given = given.prop_map(move |c| Weights::Given(c.into_iter().map(|(p, q)| rational(p, q)).collect()));
    prop_oneof![Just(Weights::Lazy), Just(Weights::Vicsek), given]
}

fn hysteresis() -> impl Strategy<Value = Hysteresis> {
    prop_oneof![
        Just(Hysteresis::None),
        (0i64..40).prop_map(|k| Hysteresis::Constant(rational(k, 160))),
        Just(Hysteresis::Paper)
    ]
}

/// Flocks of up to six birds in up to three dimensions, crowded enough that their networks change.
pub fn starts() -> impl Strategy<Value = Start> {
    (1usize..=6, 1usize..=3).prop_flat_map(|(birds, dimension)| {
        let vectors = |range: std::ops::Range<i64>, unit: i64| {
            let row = prop::collection::vec(range.prop_map(move |x| rational(x, unit)), dimension);
            prop::collection::vec(row, birds)
        };
        (vectors(0..48, 16), vectors(-6..6, 24), weights(birds), hysteresis()).prop_map(
            |(positions, velocities, weights, hysteresis)| Start { positions, velocities, weights, hysteresis },
        )
    })
}

proptest! {
    #[test]
    fn steps_agree_with_the_naive_twin(start in starts()) {
        let mut naive = Naive::new(&start);
        let mut flock = Flock::new(&start).unwrap();
        prop_assert_eq!(flock.network(), &naive.network);
        for t in 1..=25u32 {
            let before = flock.network().clone();
            naive.step();
            let switch = flock.step().unwrap();
            prop_assert_eq!(flock.time(), &t.into());
            prop_assert_eq!(flock.network(), &naive.network);
            prop_assert_eq!(switch.is_some(), before != naive.network);
            prop_assert_eq!(&flock.positions(), &naive.start.positions);
            prop_assert_eq!(&flock.velocities(), &naive.start.velocities);
        }
    }

    /// A common velocity, a translation, a quarter turn and another order of the birds change nothing but themselves.
    #[test]
    fn networks_do_not_feel_symmetries(start in starts(), shift in -99i64..99, common in -99i64..99, turn in any::<bool>()) {
        let birds = start.positions.len();
        let map = |rows: &[Vec<Rational>], by: Rational| -> Vec<Vec<Rational>> {
            let moved = |row: &Vec<Rational>| {
                let mut row: Vec<Rational> = row.iter().map(|x| x + &by).collect();
                if turn && row.len() >= 2 {
                    row.swap(0, 1);
                    row[0] = -row[0].clone();
                }
                row
            };
            rows.iter().rev().map(moved).collect()
        };
        let reversed = match &start.weights {
            Weights::Given(c) => Weights::Given(c.iter().rev().cloned().collect()),
            other => other.clone(),
        };
        let other = Start {
            positions: map(&start.positions, rational(shift, 7)),
            velocities: map(&start.velocities, rational(common, 11)),
            weights: reversed,
            hysteresis: start.hysteresis.clone(),
        };
        let (mut one, mut two) = (Flock::new(&start).unwrap(), Flock::new(&other).unwrap());
        for _ in 0..15 {
            one.step().unwrap();
            two.step().unwrap();
            let mirrored = Graph::from_fn(birds, |i, j| two.network().has_edge(birds - 1 - i, birds - 1 - j));
            prop_assert_eq!(one.network(), &mirrored);
        }
    }

    /// Velocities stay within the box of the first ones, and transition matrices are stochastic with full diagonal.
    #[test]
    fn velocities_contract(start in starts()) {
        let mut flock = Flock::new(&start).unwrap();
        let bounds = |rows: &[Vec<Rational>], k: usize| {
            let column = || rows.iter().map(|row| row[k].clone());
            (column().min().unwrap(), column().max().unwrap())
        };
        for _ in 0..12 {
            let before = flock.velocities();
            flock.step().unwrap();
            let after = flock.velocities();
            for k in 0..flock.dimension() {
                let ((low, high), (least, most)) = (bounds(&before, k), bounds(&after, k));
                prop_assert!(low <= least && most <= high);
            }
            let p = transition_matrix(flock.network(), flock.weights()).unwrap();
            let print = StochasticMatrix::try_from(&p).unwrap().footprint();
            prop_assert!(print.has_full_diagonal() && print.is_symmetric());
        }
    }
}

#[test]
fn huge_denominators_take_the_long_way() {
    // Weights whose common denominator does not fit a limb.
    let c = [(1i64 << 40) + 15, (1 << 41) + 27, (1 << 42) + 15].map(|q| rational(q / 5, q)).to_vec();
    let start = Start {
        positions: vec![vec![rational(0, 1)], vec![rational(1, 2)], vec![rational(4, 3)]],
        velocities: vec![vec![rational(1, 7)], vec![rational(-1, 9)], vec![rational(-1, 5)]],
        weights: Weights::Given(c),
        hysteresis: Hysteresis::Constant(rational(1, 1000)),
    };
    let (mut naive, mut flock) = (Naive::new(&start), Flock::new(&start).unwrap());
    for _ in 0..30 {
        naive.step();
        flock.step().unwrap();
        assert_eq!(flock.network(), &naive.network);
        assert_eq!(flock.positions(), naive.start.positions);
        assert_eq!(flock.velocities(), naive.start.velocities);
    }
}

#[test]
fn ties_are_exact() {
    // Distance exactly 1, and an irrational distance just above 1.
    let at = |x: Rational, y: Rational| {
        let start = Start {
            positions: vec![vec![rational(0, 1), rational(0, 1)], vec![x, y]],
            velocities: vec![vec![rational(0, 1); 2]; 2],
            weights: Weights::Lazy,
            hysteresis: Hysteresis::None,
        };
        Flock::new(&start).unwrap().network().has_edge(0, 1)
    };
    assert!(at(rational(3, 5), rational(4, 5)));
    let tiny = Rational::new(1.into(), num_bigint::BigInt::from(1) << 400u32);
    assert!(!at(rational(3, 5) + &tiny, rational(4, 5)));
    assert!(at(rational(3, 5) - tiny, rational(4, 5)));
}

/// No change of distance is below 0: the threshold 0 is no hysteresis.
#[test]
fn the_threshold_zero_holds_nothing() {
    let start = |hysteresis| {
        let numbers = |list: [(i64, i64); 4]| list.map(|(p, q)| rational(p, q)).to_vec();
        let (x, v) = ([(0, 1), (0, 1), (23, 16), (1, 16)], [(-5, 24), (0, 1), (-5, 24), (1, 6)]);
        Start::on_the_line(numbers(x), numbers(v), Weights::Lazy, hysteresis)
    };
    let (zero, none) = (start(Hysteresis::Constant(rational(0, 1))), start(Hysteresis::None));
    let (mut zero, mut none) = (Flock::new(&zero).unwrap(), Flock::new(&none).unwrap());
    for _ in 0..30 {
        assert_eq!(zero.step().unwrap(), none.step().unwrap());
    }
}

#[test]
fn flocks_that_are_refused() {
    let line = |x: &[i64], v: &[i64], weights: Weights, hysteresis: Hysteresis| {
        let numbers = |list: &[i64]| list.iter().map(|&x| rational(x, 4)).collect();
        Flock::new(&Start::on_the_line(numbers(x), numbers(v), weights, hysteresis)).map(|_| ())
    };
    let none = || Hysteresis::None;
    assert_eq!(line(&[], &[], Weights::Lazy, none()), Err(FlockError::NoBirds));
    assert_eq!(line(&[0], &[], Weights::Lazy, none()), Err(FlockError::Velocities { birds: 1, found: 0 }));
    let thirds = || Weights::Given(vec![rational(1, 3)]);
    assert_eq!(line(&[0, 1], &[0, 0], thirds(), none()), Err(FlockError::Weights { birds: 2, bird: 2 }));
    // Too heavy for one neighbour, or for the two that are there.
    let given = |c| Weights::Given(vec![c; 3]);
    for (c, degree) in [(rational(1, 1), 1), (rational(0, 1), 1), (rational(1, 2), 2)] {
        let refused = line(&[0, 1, 2], &[0, 0, 0], given(c), none());
        assert!(
            matches!(refused, Err(FlockError::Inadmissible { bird: 1, degree: d, .. }) if d == degree),
            "{refused:?}"
        );
    }
    let negative = Hysteresis::Constant(rational(-1, 2));
    assert_eq!(line(&[0], &[0], Weights::Lazy, negative), Err(FlockError::NegativeHysteresis("-1/2".to_string())));
    // Far apart at first: refused when they meet.
    let start = Start::on_the_line(
        vec![rational(0, 1), rational(1, 2), rational(3, 1)],
        vec![rational(1, 1), rational(1, 1), rational(0, 1)],
        given(rational(1, 2)),
        Hysteresis::None,
    );
    let mut flock = Flock::new(&start).unwrap();
    flock.step().unwrap();
    assert!(matches!(flock.step(), Err(FlockError::Inadmissible { bird: 1, degree: 2, .. })));
}

#[test]
fn files_of_flocks() {
    let good = r#"{"model": "D", "dimension": 2, "weights": {"c": ["1/4", 0.25]}, "positions": [[0, "1/3"], ["-1e-2", 2]],
                   "velocities": [["0", "0"], ["1", "-1"]], "hysteresis": "1/1024", "ids": ["a", "b"]}"#;
    let file = read_flock(good).unwrap();
    let Model::D { start, control: None } = &file.model else { panic!("{file:?}") };
    assert_eq!(start.positions[1], [rational(-1, 100), rational(2, 1)]);
    assert_eq!(start.weights, Weights::Given(vec![rational(1, 4); 2]));
    assert_eq!(start.hysteresis, Hysteresis::Constant(rational(1, 1024)));
    let bad = |from: &str, to: &str, named: &str| {
        assert!(good.contains(from), "{from}");
        let error = read_flock(&good.replace(from, to)).unwrap_err().to_string();
        assert!(error.contains(named), "{error} does not name {named}");
    };
    bad("\"D\"", "\"E\"", "model");
    bad("\"D\"", "\"K\"", "weights");
    bad("\"dimension\": 2", "\"dimension\": 3", "dimension");
    bad("{\"c\": [\"1/4\", 0.25]}", "\"heavy\"", "weights");
    bad("\"1/4\"", "\"4\"", "c = 4");
    bad("\"1/3\"", "\"one third\"", "bird 1");
    bad("\"1/3\"", "\"1/0\"", "zero denominator");
    bad("\"1/3\"", "null", "bird 1");
    bad("[0, \"1/3\"]", "[0]", "bird 2");
    bad("[\"0\", \"0\"], ", "", "velocities");
    bad("1/1024", "-1/1024", "negative");
    bad("\"b\"", "\"a\"", "two birds");
    bad(", \"b\"", "", "ids");
    bad("\"ids\"", "\"names\"", "names");
    bad("\"model\": \"D\", ", "", "model");
    assert!(read_flock("[1]").is_err() && read_flock("{").is_err());
}
