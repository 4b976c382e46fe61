//! What is measured: one row and one function over any scalar for each quantity. Simulation reads them in floats, questions over enclosures and
//! rational numbers; helps and notes print the rows.

use super::model::Model::{self, Fish, Flock, Headings, Noisy, Own, Particles, Phase, Platoon, Velocities, Vicsek};
use super::view::{Amount, Law, Links, Measurable, View};
use algebra::graph::components as parts;
use arithmetic::{ArithmeticError, Field};
use models::double_integrator::{Coordinates, Pair, kinetic_energy, potential_energy, saturated_potential};
use models::oscillator::{
    Flight, circle_centres, cluster_gap, mean, moment, phase_potential as form, spacing_potential as spacing,
};
use std::borrow::Cow;
use std::fmt::Write;

/// A quantity that can be measured.
#[derive(Debug)]
pub struct Quantity {
    /// Its name, the same in every file.
    pub name: &'static str,
    /// Names of its arguments in questions: which of several numbers.
    pub arguments: &'static [&'static str],
    /// Its unit.
    pub unit: &'static str,
    /// What it means.
    pub meaning: &'static str,
    /// The models that have it.
    pub models: &'static [Model],
    /// Why no question decides it, where none does.
    pub undecided: Option<&'static str>,
}

/// What was found; nothing where the state has no such quantity.
pub type Found<T> = Result<Option<Amount<T>>, ArithmeticError>;

macro_rules! quantities {
    ($($function:ident($($argument:literal)?) [$unit:literal] $meaning:literal, $models:expr $(, never decided: $why:literal)?;)*) => {
        /// All quantities.
        pub const QUANTITIES: &[Quantity] = &[$(Quantity {
            name: stringify!($function),
            arguments: &[$($argument)?],
            unit: $unit,
            meaning: $meaning,
            models: $models,
            undecided: [$(Some($why),)? None][0],
        }),*];

        /// The quantity of that name; nothing where there is none, or the model does not have it.
        ///
        /// # Errors
        /// [`ArithmeticError`] where the scalar has no such value.
        pub fn measure<T: Measurable>(name: &str, view: &View<T>) -> Found<T> {
            match QUANTITIES.iter().find(|quantity| quantity.name == name) {
                Some(quantity) if quantity.models.contains(&view.model) => match name {
                    $(stringify!($function) => $function(view),)*
                    _ => Ok(None),
                },
                _ => Ok(None),
            }
        }
    };
}

const OF_PHASES: &[Model] = &[Phase, Particles, Fish, Vicsek];
const OF_LINKED: &[Model] = &[Velocities, Headings];

quantities! {
    order("m") ["1"] "modulus of p_m, the mean of e^(i m theta)/m over the agents, at most 1/m; `order` is `order(1)`",
        &[Phase, Particles, Fish, Vicsek, Noisy, Own];
    phase_potential() ["1"] "W_1 = (1/(2N)) <z, L z> of the phases, z_k = e^(i theta_k): on an undirected network (1/(2N)) times the sum of |z_i - z_j|², each edge once",
        OF_PHASES;
    clusters() ["1"] "clusters of phases less than 10 degrees, and a third of the mean gap 360/N, apart",
        OF_PHASES, never decided: "an integer with a tolerance in degrees, which jumps where two phases come near each other";
    pattern_order() ["1"] "M where each phase is within 5 degrees, and a sixth of the gap 360/M, of one of M evenly spaced places that have N/M phases each; else none",
        OF_PHASES, never decided: "an integer with a tolerance in degrees, which jumps, and which not every state has";
    orientation_potential() ["1/time"] "what the orientation control is the negative gradient of on an undirected network: -K1 W_1, with a reference -K1 (W_1 + 1 - cos(theta_0 - theta_N)), or sum K_m U_m",
        &[Phase, Particles];
    spacing_potential() ["length²"] "S = (1/(2N)) <c, L c> of the centres c_k = r_k + i e^(i theta_k)/omega0 of the circles of steered particles; edges as for phase_potential",
        &[Particles];
    composite_potential() ["length"] "K0 S, or (K0/2) sum |c_k - c_0|² with a beacon, plus orientation_potential/omega0²",
        &[Particles];
    centre_spread() ["length"] "largest distance of a centre of these circles from their mean",
        &[Particles];
    potential() ["(length/time)²"] "sum of the potentials V_ij over the links, each once",
        OF_LINKED;
    kinetic() ["(length/time)²"] "half the sum of the squared speeds",
        OF_LINKED;
    energy() ["(length/time)²"] "potential + kinetic",
        OF_LINKED;
    saturated_energy() ["(length/time)²"] "Q: kinetic, and V at the smaller of distance and radius over all pairs, each once; on fixed graphs the energy",
        &[Velocities];
    heading_spread() ["radians"] "largest angle between two headings",
        &[Headings];
    min_gap() ["length"] "smallest gap x_k - x_(k+1) of two successive cars",
        &[Platoon];
    max_gap() ["length"] "largest gap of two successive cars",
        &[Platoon];
    largest_deviation() ["length"] "largest size of the deviation y_k - y_l of a follower from the leader, car l; y_k = x_k + spacing (k - 1)",
        &[Platoon];
    last_deviation() ["length"] "deviation y_N - y_l of the last car, N, from the leader: 0 if it leads",
        &[Platoon];
    disagreement() ["length/time"] "sqrt(sum |v_i - mean|²)",
        &[Velocities, Headings, Platoon, Vicsek, Own, Flock];
    min_distance() ["length"] "smallest distance of two agents",
        &[Velocities, Headings, Particles, Fish, Platoon, Vicsek, Own, Flock];
    mean_neighbours() ["1"] "neighbours of a bird, itself not counted, on the average",
        &[Noisy], never decided: "only the model with noise has it, whose motion is drawn at random and not enclosed";
    components() ["1"] "number of connected parts of the network in force, arcs taken as edges",
        &[Phase, Particles, Fish, Velocities, Headings, Platoon, Vicsek, Noisy, Own, Flock];
    links() ["1"] "number of edges of the network in force",
        &[Flock];
    momentum("k") ["length/time"] "sum of the velocities, a vector",
        &[Velocities, Headings, Particles, Fish, Vicsek, Noisy];
}

/// Of states without numbers there is nothing to measure.
fn present<T>(amount: Option<Amount<T>>) -> Found<T> {
    Ok(amount)
}

fn order<T: Measurable>(view: &View<T>) -> Found<T> {
    if view.phasors.is_empty() {
        return Ok(None);
    }
    let root = |m: u32| Ok(Amount::Root(moment(&view.phasors, m)?.norm_squared()));
    Ok(Some(Amount::List((1..=view.orders).map(root).collect::<Result<_, ArithmeticError>>()?)))
}

fn phase_potential<T: Measurable>(view: &View<T>) -> Found<T> {
    if view.phasors.is_empty() {
        return Ok(None);
    }
    Ok(Some(Amount::Number(form(&view.sensing, &view.phasors, 1)?)))
}

fn flight<T>(view: &View<T>) -> Option<Flight> {
    (!view.phases.is_empty()).then(|| Flight { positions: Vec::new(), phases: view.phases.to_vec() })
}

fn clusters<T>(view: &View<T>) -> Found<T> {
    let count = |flight: Flight| flight.clusters(cluster_gap(flight.phases.len())).len();
    present(flight(view).map(count).map(|count| Amount::Count(Some([count; 2]))))
}

fn pattern_order<T>(view: &View<T>) -> Found<T> {
    present(flight(view).map(|flight| Amount::Count(models::oscillator::pattern(&flight).map(|order| [order; 2]))))
}

fn orientation_potential<T: Measurable>(view: &View<T>) -> Found<T> {
    let Law::Turning(steering, reference) = &view.law else { return Ok(None) };
    steering.orientation.potential(&view.sensing, reference.as_ref(), &view.phasors).map(Amount::Number).map(Some)
}

/// Without a frequency there are no circles.
fn with_circles<T>(found: Result<Amount<T>, ArithmeticError>) -> Found<T> {
    match found {
        Err(ArithmeticError::DivisionByZero) => Ok(None),
        found => found.map(Some),
    }
}

fn spacing_potential<T: Measurable>(view: &View<T>) -> Found<T> {
    let Law::Turning(steering, _) = &view.law else { return Ok(None) };
    with_circles(spacing(&steering.frequency, &view.sensing, &view.particles()).map(Amount::Number))
}

fn composite_potential<T: Measurable>(view: &View<T>) -> Found<T> {
    let Law::Turning(steering, reference) = &view.law else { return Ok(None) };
    let found = steering.potential(&view.sensing, reference.as_ref(), &view.particles());
    with_circles(found.map(Amount::Number))
}

fn centre_spread<T: Measurable>(view: &View<T>) -> Found<T> {
    let Law::Turning(steering, _) = &view.law else { return Ok(None) };
    let spread = || {
        let centres = circle_centres(&steering.frequency, &view.particles())?;
        let middle = mean(&centres)?;
        let squares = centres.into_iter().map(|c| (c - &middle).norm_squared());
        Ok(squares.reduce(T::greater).map_or(Amount::Unknown("there are no particles"), Amount::Root))
    };
    with_circles(spread())
}

const UNSURE: &str = "the links change at that time";

fn potential<T: Measurable>(view: &View<T>) -> Found<T> {
    let Law::Agents(potential, _) = &view.law else { return Ok(None) };
    let Links::These(_, pairs) = &view.links else { return Ok(Some(Amount::Unknown(UNSURE))) };
    let positions = view.positions.plane();
    let Some([like, _]) = positions.first() else { return Ok(None) };
    let value = T::potential(potential, like)?;
    let sum = potential_energy(&positions, pairs, Coordinates::Cartesian, |_, _, s| value(s))?;
    Ok(Some(Amount::Number(sum)))
}

fn kinetic<T: Measurable>(view: &View<T>) -> Found<T> {
    let velocities = view.velocities.plane();
    if velocities.is_empty() {
        return Ok(None);
    }
    Ok(Some(Amount::Number(kinetic_energy(&velocities, Coordinates::Cartesian)?)))
}

fn energy<T: Measurable>(view: &View<T>) -> Found<T> {
    Ok(match (potential(view)?, kinetic(view)?) {
        (Some(Amount::Number(own)), Some(Amount::Number(kinetic))) => Some(Amount::Number(own + kinetic)),
        (unknown, _) => unknown,
    })
}

fn saturated_energy<T: Measurable>(view: &View<T>) -> Found<T> {
    let Law::Agents(potential, radius) = &view.law else { return Ok(None) };
    let Some(radius) = radius else { return energy(view) };
    let (positions, kinetic) = (view.positions.plane(), kinetic(view)?);
    let (Some([like, _]), Some(Amount::Number(kinetic))) = (positions.first(), kinetic) else { return Ok(None) };
    let (value, square) = (T::potential(potential, like)?, like.rational(radius).square());
    let own = match &view.links {
        Links::These(_, pairs) => {
            saturated_potential(&positions, pairs, Coordinates::Cartesian, |_, _, s| value(s), &value(&square)?)?
        }
        // V at the smaller of distance and radius has no jump where a link changes, so that the links need not be known.
        _ => {
            let all: Vec<Pair> = (0..positions.len()).flat_map(|j| (0..j).map(move |i| (i, j))).collect();
            let value = |_: usize, _: usize, s: &T| value(&s.clone().lesser(square.clone()));
            potential_energy(&positions, &all, Coordinates::Cartesian, value)?
        }
    };
    Ok(Some(Amount::Number(own + kinetic)))
}

fn heading_spread<T: Measurable>(view: &View<T>) -> Found<T> {
    present((view.headings.agents() > 0).then(|| T::heading_spread(&view.headings)))
}

fn gaps<T: Field>(deviations: &[T], spacing: &T) -> impl Iterator<Item = T> {
    deviations.windows(2).map(|pair| spacing.clone() + &pair[0] - &pair[1])
}

const ONE_CAR: &str = "one car has no gap";

fn min_gap<T: Measurable>(view: &View<T>) -> Found<T> {
    let Law::Cars { deviations, spacing, .. } = &view.law else { return Ok(None) };
    let least = gaps(deviations, spacing).reduce(T::lesser);
    present(Some(least.map_or(Amount::Unknown(ONE_CAR), Amount::Number)))
}

fn max_gap<T: Measurable>(view: &View<T>) -> Found<T> {
    let Law::Cars { deviations, spacing, .. } = &view.law else { return Ok(None) };
    let most = gaps(deviations, spacing).reduce(T::greater);
    present(Some(most.map_or(Amount::Unknown(ONE_CAR), Amount::Number)))
}

fn largest_deviation<T: Measurable>(view: &View<T>) -> Found<T> {
    let Law::Cars { deviations, leader, spacing } = &view.law else { return Ok(None) };
    let Some(own) = deviations.get(*leader) else { return Ok(None) };
    let followers = deviations.iter().enumerate().filter(|(car, _)| car != leader);
    let sizes = followers.map(|(_, y)| (y.clone() - own).size());
    present(Some(Amount::Number(sizes.fold(spacing.zero(), T::greater))))
}

fn last_deviation<T: Measurable>(view: &View<T>) -> Found<T> {
    let Law::Cars { deviations, leader, .. } = &view.law else { return Ok(None) };
    let ends = deviations.last().zip(deviations.get(*leader));
    present(ends.map(|(last, own)| Amount::Number(last.clone() - own)))
}

fn disagreement<T: Measurable>(view: &View<T>) -> Found<T> {
    present(view.velocities.scatter().map(Amount::Root))
}

fn min_distance<T: Measurable>(view: &View<T>) -> Found<T> {
    let least = || T::least_square(&view.positions);
    let alone = Amount::Unknown("one agent has no distance to others");
    present((view.positions.agents() > 0).then(|| least().map_or(alone, Amount::Root)))
}

fn mean_neighbours<T: Measurable>(view: &View<T>) -> Found<T> {
    let (Links::These(agents, pairs), Some(z)) = (&view.links, view.phasors.first()) else { return Ok(None) };
    present(Some(Amount::Number(z.re.ratio(2 * pairs.len() as i64, (*agents).max(1) as i64))))
}

fn components<T>(view: &View<T>) -> Found<T> {
    let count = |order: usize, pairs: &[Pair]| parts(order, pairs).len();
    let counts = match &view.links {
        Links::Everyone(order) => [(*order).min(1); 2],
        Links::These(order, pairs) => [count(*order, pairs); 2],
        Links::Between(order, [must, may]) => [count(*order, may), count(*order, must)],
    };
    present(Some(Amount::Count(Some(counts))))
}

fn links<T>(view: &View<T>) -> Found<T> {
    let Links::These(_, pairs) = &view.links else { return Ok(None) };
    present(Some(Amount::Count(Some([pairs.len(); 2]))))
}

fn momentum<T: Measurable>(view: &View<T>) -> Found<T> {
    let total = view.velocities.total();
    present((total.len() == 2).then(|| Amount::List(total.into_iter().map(Amount::Number).collect())))
}

/// A measured quantity of a run.
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
    pub(super) fn new(name: impl Into<Cow<'static, str>>, value: Value) -> Self {
        Observable { name: name.into(), value }
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

fn value(amount: Amount<f64>) -> Value {
    match amount {
        Amount::Number(x) => Value::Number(x),
        Amount::Root(x) => Value::Number(x.sqrt()),
        Amount::Count(counts) => Value::Count(counts.map(|[count, _]| count)),
        Amount::List(list) => Value::List(list.into_iter().map(|amount| number(value(amount))).collect()),
        Amount::Unknown(_) => Value::Number(f64::INFINITY),
    }
}

fn number(value: Value) -> f64 {
    match value {
        Value::Number(x) => x,
        Value::Count(count) => count.map_or(f64::NAN, |count| count as f64),
        Value::List(_) => f64::NAN,
    }
}

/// All that a state has, in the order of the rows but for some names that come first.
pub(super) fn observe(view: &View<f64>, first: &[&str]) -> Result<Vec<Observable>, ArithmeticError> {
    let others = QUANTITIES.iter().map(|quantity| quantity.name).filter(|name| !first.contains(name));
    let named = QUANTITIES.iter().map(|quantity| quantity.name);
    let first = first.iter().flat_map(|name| named.clone().find(|known| known == name));
    let mut all = Vec::new();
    for name in first.chain(others) {
        all.extend(measure(name, view)?.map(|amount| Observable::new(name, value(amount))));
    }
    Ok(all)
}

/// The rows as Markdown: for the notes.
pub fn observables_as_markdown() -> String {
    let mut text = "| observable | unit | meaning | models |\n|---|---|---|---|\n".to_string();
    for quantity in QUANTITIES.iter().filter(|quantity| quantity.models != [Flock]) {
        let models = quantity.models.iter().filter(|model| **model != Flock).map(|model| model.name());
        let (meaning, models) = (quantity.meaning.replace('|', "\\|"), models.collect::<Vec<_>>().join(", "));
        let _ = writeln!(text, "| `{}` | {} | {meaning} | {models} |", quantity.name, quantity.unit);
    }
    text
}

/// What `clusters` and `pattern_order` mean.
pub(super) const CLUSTERS: &str = "clusters of phases less than 10 degrees, and a third of the mean gap 360/N, apart; pattern_order M where each phase is within 5 degrees, and a sixth of the gap 360/M, of one of M evenly spaced places that have N/M phases each";

/// Positions of a state with phasors as lists.
pub(super) fn places(state: &models::oscillator::State<f64>) -> Vec<Vec<f64>> {
    state.positions.iter().map(|r| vec![r.re, r.im]).collect()
}
