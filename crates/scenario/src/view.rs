//! What is measured on: the state at one time, over any scalar, with the network and the law.

use super::model::Model;
use arithmetic::{
    ArithmeticError, Complex, Dyadic, Field, Interval, PreciseNumber, Rational, Real, Ring, Sign, Signed,
};
use models::double_integrator::{self, Potential};
use models::oscillator::{self, Everyone, Interaction, Neighbours, Steering};
use motion::enclose::Expanded;
use polynomials::Symbolic;
use std::borrow::Cow;
use std::cell::LazyCell;

/// Makes rows when they are needed.
type Made<'a, T> = Box<dyn FnOnce() -> Vec<Vec<T>> + 'a>;

/// One row of numbers for each agent.
pub struct Rows<'a, T> {
    agents: usize,
    rows: LazyCell<Vec<Vec<T>>, Made<'a, T>>,
}

impl<'a, T: Field + 'static> Rows<'a, T> {
    /// Of nobody.
    pub fn none() -> Self {
        Rows::of(0, Vec::new)
    }

    /// Of so many agents, made when they are needed.
    pub fn of(agents: usize, rows: impl FnOnce() -> Vec<Vec<T>> + 'a) -> Self {
        Rows { agents, rows: LazyCell::new(Box::new(rows)) }
    }

    /// The number of agents.
    pub fn agents(&self) -> usize {
        self.agents
    }

    /// The rows.
    pub fn list(&self) -> &[Vec<T>] {
        &self.rows
    }

    /// The squared distance of two agents; nothing of rows without numbers.
    fn square(&self, i: usize, j: usize) -> Option<T> {
        let coordinates = self.list()[i].iter().zip(&self.list()[j]);
        coordinates.map(|(x, y)| (x.clone() - y).square()).reduce(|sum, x| sum + x)
    }

    /// The squared distances of all pairs.
    pub fn squares(&self) -> impl Iterator<Item = T> + '_ {
        (0..self.agents).flat_map(move |j| (0..j).filter_map(move |i| self.square(i, j)))
    }

    /// `sum |v_i - mean|²`; nothing for nobody.
    pub fn scatter(&self) -> Option<T> {
        let count = i64::try_from(self.agents).ok()?;
        let like = self.list().first()?.first()?;
        let share = like.ratio(1, count);
        let total = |k: usize| self.list().iter().fold(like.zero(), |sum, row| sum + &row[k]);
        let mean: Vec<T> = (0..self.list()[0].len()).map(|k| total(k) * &share).collect();
        let square = |row: &Vec<T>| row.iter().zip(&mean).map(|(x, m)| (x.clone() - m).square()).reduce(|a, b| a + b);
        self.list().iter().filter_map(square).reduce(|sum, x| sum + x)
    }

    /// The sum of the rows, coordinate by coordinate.
    pub fn total(&self) -> Vec<T> {
        let add = |sum: Vec<T>, row: &Vec<T>| sum.into_iter().zip(row).map(|(x, y)| x + y).collect();
        let Some(first) = self.list().first() else { return Vec::new() };
        self.list().iter().fold(first.iter().map(T::zero).collect(), add)
    }

    /// The rows as vectors of the plane.
    pub fn plane(&self) -> Vec<[T; 2]> {
        self.list().iter().filter_map(|row| Some([row.first()?.clone(), row.get(1)?.clone()])).collect()
    }
}

/// Who is linked with whom.
pub enum Links<'a> {
    /// So many agents with these links; arcs are taken as edges.
    These(usize, Cow<'a, [(usize, usize)]>),
    /// All of so many agents.
    Everyone(usize),
    /// At least the first ones, and at most the second ones.
    Between(usize, [Vec<(usize, usize)>; 2]),
}

/// Who senses whom.
pub enum Sensing<'a> {
    /// Everyone senses everyone.
    Everyone,
    /// These.
    These(Cow<'a, Neighbours>),
}

impl Interaction for Sensing<'_> {
    fn laplacian_of<T: Field>(&self, x: &[Complex<T>]) -> Vec<Complex<T>> {
        match self {
            Sensing::Everyone => Everyone.laplacian_of(x),
            Sensing::These(neighbours) => neighbours.laplacian_of(x),
        }
    }
}

/// What of the law is measured.
pub enum Law<'a, T> {
    /// Nothing.
    Unmeasured,
    /// Agents with potentials, linked within the radius where there is one.
    Agents(&'a Potential, Option<&'a Rational>),
    /// Phases or particles with their controls, and the phasor of the reference phase where there is one.
    Turning(Steering<T>, Option<Complex<T>>),
    /// Cars on a line.
    Cars {
        /// `y_k`, by cars.
        deviations: Vec<T>,
        /// The car that leads, from 0.
        leader: usize,
        /// The desired gap.
        spacing: T,
    },
}

/// The state at one time; what the model does not have is empty.
pub struct View<'a, T> {
    /// Whose state it is.
    pub model: Model,
    /// Where the agents are.
    pub positions: Rows<'a, T>,
    /// Their velocities.
    pub velocities: Rows<'a, T>,
    /// Headings that are followed continuously, a row of one number each.
    pub headings: Rows<'a, T>,
    /// `e^(i theta_k)`.
    pub phasors: Vec<Complex<T>>,
    /// `theta_k`, in floats.
    pub phases: &'a [f64],
    /// How many moments of the phasors are measured.
    pub orders: u32,
    /// Who is linked.
    pub links: Links<'a>,
    /// Who senses whom, where phases are compared.
    pub sensing: Sensing<'a>,
    /// What of the law is measured.
    pub law: Law<'a, T>,
}

impl<'a, T: Field + 'static> View<'a, T> {
    /// Of a model with these links, as yet without a state.
    pub fn new(model: Model, links: Links<'a>) -> Self {
        View {
            model,
            positions: Rows::none(),
            velocities: Rows::none(),
            headings: Rows::none(),
            phasors: Vec::new(),
            phases: &[],
            orders: 1,
            links,
            sensing: Sensing::Everyone,
            law: Law::Unmeasured,
        }
    }

    /// Positions and phasors of particles in the plane.
    pub fn particles(&self) -> oscillator::State<T> {
        let positions = self.positions.plane().into_iter().map(|[re, im]| Complex::new(re, im)).collect();
        oscillator::State { positions, phasors: self.phasors.clone() }
    }
}

/// What was measured.
#[derive(Debug, Clone, PartialEq)]
pub enum Amount<T> {
    /// A number.
    Number(T),
    /// The square root of a number that is not negative.
    Root(T),
    /// A count: at least and at most so many; none where the question has no answer.
    Count(Option<[usize; 2]>),
    /// Several of them.
    List(Vec<Amount<T>>),
    /// It is not known, or does not exist, and why.
    Unknown(&'static str),
}

/// A potential of the squared distance.
pub type ValueAt<'p, T> = Box<dyn Fn(&T) -> Result<T, ArithmeticError> + 'p>;

/// What measuring needs of a scalar beside arithmetic.
pub trait Measurable: Field + 'static {
    /// The smaller of two numbers; of enclosures one that contains it.
    fn lesser(self, other: Self) -> Self;

    /// The larger of two numbers.
    fn greater(self, other: Self) -> Self;

    /// The absolute value.
    fn size(&self) -> Self;

    /// The potential as a function of the squared distance.
    ///
    /// # Errors
    /// [`ArithmeticError`] where it has no value.
    fn potential<'p>(potential: &'p Potential, like: &Self) -> Result<ValueAt<'p, Self>, ArithmeticError>;

    /// The least squared distance of two rows; nothing for fewer than two.
    fn least_square(rows: &Rows<Self>) -> Option<Self> {
        rows.squares().reduce(Self::lesser)
    }

    /// The largest angle between two headings, as far as it is known.
    fn heading_spread(headings: &Rows<Self>) -> Amount<Self>;
}

impl Measurable for f64 {
    fn lesser(self, other: Self) -> Self {
        self.min(other)
    }

    fn greater(self, other: Self) -> Self {
        self.max(other)
    }

    fn size(&self) -> Self {
        self.abs()
    }

    fn potential<'p>(potential: &'p Potential, like: &Self) -> Result<ValueAt<'p, Self>, ArithmeticError> {
        let value = potential.value_over(like)?;
        Ok(Box::new(move |s| value.at(s)))
    }

    /// By a sweep along the first coordinate: `N log N` unless many share a strip.
    fn least_square(rows: &Rows<Self>) -> Option<Self> {
        let first = |place: &Vec<f64>| place.first().copied().unwrap_or(0.0);
        let mut sorted: Vec<&Vec<f64>> = rows.list().iter().collect();
        sorted.sort_by(|a, b| first(a).total_cmp(&first(b)));
        let (mut least, mut distance) = (f64::INFINITY, f64::INFINITY);
        for (i, a) in sorted.iter().enumerate() {
            for b in &sorted[i + 1..] {
                if first(b) - first(a) >= distance {
                    break;
                }
                let square: f64 = a.iter().zip(b.iter()).map(|(x, y)| (x - y) * (x - y)).sum();
                if square < least {
                    (least, distance) = (square, square.sqrt());
                }
            }
        }
        (rows.agents() > 1).then_some(least)
    }

    /// Headings in floats may be any number of turns apart.
    fn heading_spread(headings: &Rows<Self>) -> Amount<Self> {
        Amount::Number(double_integrator::heading_spread(&headings.list().concat()))
    }
}

impl Measurable for Rational {
    fn lesser(self, other: Self) -> Self {
        self.min(other)
    }

    fn greater(self, other: Self) -> Self {
        self.max(other)
    }

    fn size(&self) -> Self {
        num_traits::Signed::abs(self)
    }

    fn potential<'p>(_: &'p Potential, _: &Self) -> Result<ValueAt<'p, Self>, ArithmeticError> {
        Err(ArithmeticError::Domain("a scalar with logarithms"))
    }

    fn heading_spread(_: &Rows<Self>) -> Amount<Self> {
        Amount::Unknown("headings are no rational numbers")
    }
}

impl Measurable for Interval {
    fn lesser(self, other: Self) -> Self {
        let (lo, hi) = (self.lo().min(other.lo()).clone(), self.hi().min(other.hi()).clone());
        Interval::between(lo, hi, self.precision())
    }

    fn greater(self, other: Self) -> Self {
        let (lo, hi) = (self.lo().max(other.lo()).clone(), self.hi().max(other.hi()).clone());
        Interval::between(lo, hi, self.precision())
    }

    fn size(&self) -> Self {
        match self.sign() {
            Some(Sign::Negative) => -self.clone(),
            Some(_) => self.clone(),
            None => Interval::between(Dyadic::zero(), self.magnitude(), self.precision()),
        }
    }

    fn potential<'p>(potential: &'p Potential, like: &Self) -> Result<ValueAt<'p, Self>, ArithmeticError> {
        let value = potential.value_over(like)?;
        Ok(Box::new(move |s| value.at(s)))
    }

    /// Headings are followed continuously: as long as no two are opposite, their differences are the angles between them.
    fn heading_spread(headings: &Rows<Self>) -> Amount<Self> {
        match headings.squares().reduce(Self::greater) {
            None => Amount::Unknown("one agent has no heading different from others"),
            Some(most) if (most.pi().square() - &most).is_certainly_positive() => Amount::Root(most),
            Some(_) => Amount::Unknown("two agents may move in opposite directions"),
        }
    }
}

impl Measurable for PreciseNumber {
    fn lesser(self, other: Self) -> Self {
        PreciseNumber { number: self.number.extreme(&other.number, false, self.precision), ..self }
    }

    fn greater(self, other: Self) -> Self {
        PreciseNumber { number: self.number.extreme(&other.number, true, self.precision), ..self }
    }

    fn size(&self) -> Self {
        PreciseNumber { number: self.number.absolute(self.precision), ..*self }
    }

    fn potential<'p>(potential: &'p Potential, like: &Self) -> Result<ValueAt<'p, Self>, ArithmeticError> {
        let value = potential.value_over(like)?;
        Ok(Box::new(move |s| value.at(s)))
    }

    fn heading_spread(_: &Rows<Self>) -> Amount<Self> {
        Amount::Unknown("headings are not known in closed form")
    }
}

impl Measurable for Expanded {
    fn lesser(self, other: Self) -> Self {
        -(-self).greater(-other)
    }

    fn greater(self, other: Self) -> Self {
        Expanded::greater(&self, &other)
    }

    fn size(&self) -> Self {
        Expanded::size(self)
    }

    fn potential<'p>(potential: &'p Potential, like: &Self) -> Result<ValueAt<'p, Self>, ArithmeticError> {
        let value = potential.value_over(like)?;
        Ok(Box::new(move |s| value.at(s)))
    }

    /// As for intervals.
    fn heading_spread(headings: &Rows<Self>) -> Amount<Self> {
        let half_turn = |most: &Self| most.range().pi().square().lo();
        match headings.squares().reduce(Measurable::greater) {
            None => Amount::Unknown("one agent has no heading different from others"),
            Some(most) if most.range().hi() < half_turn(&most) => Amount::Root(most),
            Some(_) => Amount::Unknown("two agents may move in opposite directions"),
        }
    }
}

impl Measurable for Symbolic {
    fn lesser(self, other: Self) -> Self {
        self.extreme(&other, false)
    }

    fn greater(self, other: Self) -> Self {
        self.extreme(&other, true)
    }

    fn size(&self) -> Self {
        Symbolic::size(self)
    }

    fn potential<'p>(potential: &'p Potential, like: &Self) -> Result<ValueAt<'p, Self>, ArithmeticError> {
        let value = potential.value_over(like)?;
        Ok(Box::new(move |s| value.at(s)))
    }

    fn heading_spread(_: &Rows<Self>) -> Amount<Self> {
        Amount::Unknown("headings are no quotients of polynomials")
    }
}
