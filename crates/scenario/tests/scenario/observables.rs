//! Each row of the observables over floats, rationals and enclosures, beside formulas that are written out.

use arithmetic::{Complex, Field, Interval, Number, Rational, Ring, rational};
use models::double_integrator::Potential;
use models::oscillator::{Orientation, Spacing, Steering};
use proptest::prelude::*;
use scenario::{Amount, Law, Links, Measurable, Model, QUANTITIES, Rows, View, measure};

const BITS: u32 = 80;

/// The state of some agents in rational numbers.
#[derive(Debug, Clone)]
struct Start {
    places: Vec<[Rational; 2]>,
    velocities: Vec<[Rational; 2]>,
    /// Half tangents of the phases.
    tangents: Vec<Rational>,
    links: Vec<(usize, usize)>,
}

fn steering() -> Steering<Rational> {
    let orientation = Orientation::Laplacian(rational(-2, 3));
    Steering { frequency: rational(1, 2), orientation, spacing: Spacing::Circle(rational(1, 5)) }
}

fn phasor(t: &Rational) -> Complex<Rational> {
    let length = rational(1, 1) + t * t;
    Complex::new((rational(1, 1) - t * t) / &length, rational(2, 1) * t / length)
}

impl Start {
    /// The state as a model sees it, over a scalar.
    fn view<T: Measurable>(&self, model: Model, like: &T, law: Law<'static, T>) -> View<'static, T> {
        let agents = self.places.len();
        let rows = |list: &[[Rational; 2]], width: usize| {
            let list: Vec<Vec<T>> =
                list.iter().map(|row| row[..width].iter().map(|x| like.rational(x)).collect()).collect();
            Rows::of(agents, move || list)
        };
        let width = if model == Model::Platoon { 1 } else { 2 };
        let number = |z: Complex<Rational>| Complex::new(like.rational(&z.re), like.rational(&z.im));
        let turns = matches!(model, Model::Phase | Model::Particles | Model::Fish | Model::Noisy);
        View {
            positions: rows(&self.places, width),
            velocities: rows(&self.velocities, width),
            phasors: self.tangents.iter().filter(|_| turns).map(|t| number(phasor(t))).collect(),
            orders: 3,
            law,
            ..View::new(model, Links::These(agents, self.links.clone().into()))
        }
    }

    /// Deviations of cars, which are the first coordinates.
    fn cars<T: Field>(&self, like: &T) -> Law<'static, T> {
        let deviations = self.places.iter().map(|row| like.rational(&row[0])).collect();
        Law::Cars { deviations, leader: 0, spacing: like.rational(&rational(3, 2)) }
    }
}

fn numbers<T: Clone>(amount: &Amount<T>, root: &impl Fn(&T) -> T) -> Vec<T> {
    match amount {
        Amount::Number(x) => vec![x.clone()],
        Amount::Root(x) => vec![root(x)],
        Amount::List(list) => list.iter().flat_map(|amount| numbers(amount, root)).collect(),
        Amount::Count(_) | Amount::Unknown(_) => Vec::new(),
    }
}

fn start() -> impl Strategy<Value = Start> {
    let number = || (-60i64..60, 1i64..9).prop_map(|(p, q)| rational(p, q));
    let vector = move || [number(), number()];
    (2usize..6).prop_flat_map(move |agents| {
        let list = prop::collection::vec(vector(), agents);
        let links = prop::collection::vec((0..agents, 0..agents), 0..8);
        (list.clone(), list, prop::collection::vec(number(), agents), links).prop_map(
            |(places, velocities, tangents, links)| {
                let mut links: Vec<(usize, usize)> =
                    links.into_iter().filter(|(i, j)| i != j).map(|(i, j)| (i.min(j), i.max(j))).collect();
                links.sort_unstable();
                links.dedup();
                Start { places, velocities, tangents, links }
            },
        )
    })
}

/// The laws over a scalar, with the models that have them.
fn laws<T: Field>(start: &Start, like: &T) -> Vec<(Model, Law<'static, T>)> {
    static POTENTIAL: std::sync::LazyLock<Potential> =
        std::sync::LazyLock::new(|| Potential::inverse_square_log(&rational(1, 1)));
    vec![
        (Model::Velocities, Law::Agents(&POTENTIAL, None)),
        (Model::Phase, Law::Turning(steering().over(like), None)),
        (Model::Particles, Law::Turning(steering().over(like), None)),
        (Model::Fish, Law::Unmeasured),
        (Model::Noisy, Law::Unmeasured),
        (Model::Flock, Law::Unmeasured),
        (Model::Platoon, start.cars(like)),
    ]
}

proptest! {
    #[test]
    fn floats_and_rationals_lie_in_the_enclosures(start in start()) {
        let mut distinct = start.places.clone();
        distinct.sort();
        prop_assume!(distinct.windows(2).all(|pair| pair[0] != pair[1]));
        let like = Interval::from_rational(&rational(0, 1), BITS);
        let (over, floats, exact) = (laws(&start, &like), laws(&start, &0.0), laws(&start, &rational(0, 1)));
        for (((model, law), (_, float)), (_, own)) in over.into_iter().zip(floats).zip(exact) {
            let enclosed = start.view(model, &like, law);
            let floats = start.view(model, &0.0, float);
            let exact = start.view(model, &rational(0, 1), own);
            for quantity in QUANTITIES {
                let name = quantity.name;
                let Ok(Some(found)) = measure(name, &enclosed) else { continue };
                let near = measure(name, &floats).expect("floats").expect("the same rows");
                let (wide, near) = (numbers(&found, &|x| x.sqrt().expect("a root")), numbers(&near, &|x| f64::sqrt(*x)));
                prop_assert_eq!(wide.len(), near.len());
                for (wide, near) in wide.iter().zip(near) {
                    let (lo, hi) = wide.to_rationals();
                    let slack = rational(1, 1 << 30) * (lo.clone().max(-lo.clone()) + rational(1, 1));
                    let near = Rational::from_float(near).expect("a number");
                    prop_assert!(&lo - &slack <= near && near <= hi + slack, "{name} of {model:?}: {near} outside {wide}");
                }
                match (&found, measure(name, &exact)) {
                    (Amount::Number(wide) | Amount::Root(wide), Ok(Some(Amount::Number(q) | Amount::Root(q)))) => {
                        let (lo, hi) = wide.to_rationals();
                        prop_assert!(lo <= q && q <= hi, "{name} of {model:?}: {q} outside {wide}");
                    }
                    (Amount::Count(counts), Ok(Some(Amount::Count(own)))) => prop_assert_eq!(*counts, own),
                    _ => {}
                }
            }
        }
    }

    #[test]
    fn the_rows_are_their_formulas(start in start()) {
        let zero = rational(0, 1);
        let count = rational(start.places.len() as i64, 1);
        let square = |a: &[Rational; 2], b: &[Rational; 2]| {
            a.iter().zip(b).map(|(x, y)| (x - y).square()).sum::<Rational>()
        };
        let sum = |k: usize| start.velocities.iter().map(|v| v[k].clone()).sum::<Rational>();
        let mean = [sum(0) / &count, sum(1) / &count];
        let apart: Rational = start.velocities.iter().map(|v| square(v, &mean)).sum();
        let pairs = || (0..start.places.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
        let least = pairs().map(|(i, j)| square(&start.places[i], &start.places[j])).min().expect("two agents");
        let agents = start.view(Model::Flock, &zero, Law::Unmeasured);
        prop_assert_eq!(measure("disagreement", &agents), Ok(Some(Amount::Root(apart.clone()))));
        prop_assert_eq!(measure("min_distance", &agents), Ok(Some(Amount::Root(least))));
        prop_assert_eq!(measure("links", &agents), Ok(Some(Amount::Count(Some([start.links.len(); 2])))));
        let fish = start.view(Model::Fish, &zero, Law::Unmeasured);
        let total = Amount::List(vec![Amount::Number(sum(0)), Amount::Number(sum(1))]);
        prop_assert_eq!(measure("momentum", &fish), Ok(Some(total)));
        let platoon = start.view(Model::Platoon, &zero, start.cars(&zero));
        let gap = |pair: &[[Rational; 2]]| &pair[0][0] - &pair[1][0] + rational(3, 2);
        let gaps: Vec<Rational> = start.places.windows(2).map(gap).collect();
        let number = |q: Option<&Rational>| Ok(q.cloned().map(Amount::Number));
        prop_assert_eq!(measure("min_gap", &platoon), number(gaps.iter().min()));
        prop_assert_eq!(measure("max_gap", &platoon), number(gaps.iter().max()));
    }
}

#[test]
fn links_that_are_not_known_are_counted_from_both_sides() {
    let unsure = View::<f64>::new(Model::Velocities, Links::Between(3, [vec![(0, 1)], vec![(0, 1), (1, 2)]]));
    assert_eq!(measure("components", &unsure), Ok(Some(Amount::Count(Some([1, 2])))));
    // A row that the model does not have, and a name that is none.
    assert_eq!(measure("order", &unsure), Ok(None));
    assert_eq!(measure("nothing", &unsure), Ok(None));
}
