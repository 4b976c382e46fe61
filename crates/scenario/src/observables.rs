//! What is measured on a state, apart from any integration; formulas are those of the models' own modules.

use arithmetic::{ArithmeticError, Complex};
use models::oscillator::{Flight, Interaction, State, cluster_gap, moment, phase_potential};
use std::borrow::Cow;

/// A measured quantity.
#[derive(Debug, Clone, PartialEq)]
pub struct Observable {
    /// Its name, the same in every file.
    pub name: Cow<'static, str>,
    /// Its value.
    pub value: Value,
}

/// The value of an [`Observable`].
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A number; not finite where there is none.
    Number(f64),
    /// A count; none where the question has no answer.
    Count(Option<usize>),
    /// Several numbers.
    List(Vec<f64>),
}

impl Observable {
    pub(super) fn number(name: impl Into<Cow<'static, str>>, value: f64) -> Self {
        Observable { name: name.into(), value: Value::Number(value) }
    }

    pub(super) fn count(name: impl Into<Cow<'static, str>>, value: impl Into<Option<usize>>) -> Self {
        Observable { name: name.into(), value: Value::Count(value.into()) }
    }

    pub(super) fn list(name: impl Into<Cow<'static, str>>, value: impl Into<Vec<f64>>) -> Self {
        Observable { name: name.into(), value: Value::List(value.into()) }
    }

    /// The numbers with their names in tables: `order` becomes `order_1`, `order_2`, ..; a count without an answer is NaN.
    pub fn columns(&self) -> Vec<(String, f64)> {
        match &self.value {
            Value::Number(x) => vec![(self.name.to_string(), *x)],
            Value::Count(n) => vec![(self.name.to_string(), n.map_or(f64::NAN, |n| n as f64))],
            Value::List(list) => list.iter().zip(1..).map(|(x, k)| (format!("{}_{k}", self.name), *x)).collect(),
        }
    }
}

/// The smallest distance of two agents with the same number of coordinates; infinite for fewer than two. Cost: `N log N` unless many share a strip.
pub fn min_distance(positions: &[Vec<f64>]) -> f64 {
    let first = |place: &Vec<f64>| place.first().copied().unwrap_or(0.0);
    let mut sorted: Vec<&Vec<f64>> = positions.iter().collect();
    sorted.sort_by(|a, b| first(a).total_cmp(&first(b)));
    let mut least = f64::INFINITY;
    for (i, a) in sorted.iter().enumerate() {
        for b in &sorted[i + 1..] {
            if first(b) - first(a) >= least {
                break;
            }
            let square: f64 = a.iter().zip(b.iter()).map(|(x, y)| (x - y) * (x - y)).sum();
            least = least.min(square.sqrt());
        }
    }
    least
}

/// The sum of some vectors.
pub fn total(vectors: impl IntoIterator<Item = [f64; 2]>) -> Vec<f64> {
    vectors.into_iter().fold([0.0, 0.0], |sum, v| [sum[0] + v[0], sum[1] + v[1]]).to_vec()
}

/// The number `M` where the phases form an `(M, N)`-pattern: each is within 5 degrees, and a sixth of the gap, of one of `M` evenly spaced
/// places that have `N/M` phases each.
pub fn pattern_order(flight: &Flight) -> Option<usize> {
    models::oscillator::pattern(flight)
}

/// What `clusters` and `pattern_order` mean.
pub(super) const CLUSTERS: &str = "clusters of phases less than 10 degrees, and a third of the mean gap 360/N, apart; pattern_order M where each phase is within 5 degrees, and a sixth of the gap 360/M, of one of M evenly spaced places that have N/M phases each";

/// What is measured on phases: `order`, `phase_potential`, `clusters`, `pattern_order`.
pub(super) fn of_phases(
    flight: &Flight,
    phasors: &[Complex<f64>],
    network: &impl Interaction,
    orders: u32,
) -> Result<Vec<Observable>, ArithmeticError> {
    let moments = (1..=orders).map(|m| Ok(moment(phasors, m)?.norm_squared().sqrt()));
    Ok(vec![
        Observable::list("order", moments.collect::<Result<Vec<f64>, ArithmeticError>>()?),
        Observable::number("phase_potential", phase_potential(network, phasors, 1)?),
        Observable::count("clusters", flight.clusters(cluster_gap(flight.phases.len())).len()),
        Observable::count("pattern_order", pattern_order(flight)),
    ])
}

/// Positions of a state with phasors as lists.
pub(super) fn places(state: &State<f64>) -> Vec<Vec<f64>> {
    state.positions.iter().map(|r| vec![r.re, r.im]).collect()
}
