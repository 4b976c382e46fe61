//! What is measured on the enclosed states of a piece of time.

use super::MotionSubject;
use super::exact::Holds;
use super::laws::phasors_of;
use super::numbers::{BITS, narrowed, widened};
use crate::error::Problem;
use crate::failure::Failure;
use crate::names::Quantity;
use crate::timeline::{Measured, Moment};
use arithmetic::RealNumber as Number;
use arithmetic::{ArithmeticError, Complex, Dyadic, Field, FloatInterval, Interval, Rational, Real, Ring, rational};
use models::double_integrator::{Coordinates, Pair, Potential, State, kinetic_energy, potential_energy};
use models::oscillator::{
    self, Neighbours, beacon_potential, circle_centres, moment, phase_potential, spacing_potential,
};
use motion::validated::{IntervalVector, Step};
use num_traits::ToPrimitive;
use scenario::{ExactMotion, ExactSpacing};
use std::rc::Rc;

/// The states at all times of a piece.
pub(super) struct At<'m, 'c> {
    pub subject: &'m MotionSubject<'c>,
    pub motion: &'m ExactMotion,
    /// What of the start holds at these times.
    pub holds: Holds,
    pub state: IntervalVector,
    /// For narrower differences of coordinates.
    pub differences: Option<(Step, FloatInterval)>,
    pub pairs: Option<Rc<Vec<Pair>>>,
}

impl At<'_, '_> {
    /// Coordinate `i` less coordinate `j`.
    fn difference(&self, i: usize, j: usize) -> FloatInterval {
        match &self.differences {
            Some((step, after)) => step.difference(i, j, *after),
            None => self.state[i] - self.state[j],
        }
    }

    /// The square of the distance of two vectors of `dimension` coordinates whose first ones begin at `offset`.
    pub(super) fn square(&self, i: usize, j: usize, dimension: usize, offset: usize) -> FloatInterval {
        let part = |k: usize| self.difference(offset + dimension * i + k, offset + dimension * j + k).square();
        (0..dimension).map(part).fold(FloatInterval::point(0.0), |sum, x| sum + x)
    }

    /// The distances of all pairs, squared.
    fn squares(&self, agents: usize, dimension: usize, offset: usize) -> Vec<FloatInterval> {
        let pairs = (0..agents).flat_map(|j| (0..j).map(move |i| (i, j)));
        pairs.map(|(i, j)| self.square(i, j, dimension, offset)).collect()
    }

    fn agent_count(&self) -> (usize, usize) {
        match self.motion {
            ExactMotion::Velocities { positions, .. } => (positions.len(), 2),
            ExactMotion::Particles { positions, .. } => (positions.len(), 2),
            ExactMotion::Platoon { deviations, .. } => (deviations.len(), 1),
            _ => (0, 0),
        }
    }

    fn min_distance(&self) -> Result<Interval, Failure> {
        let (agents, dimension) = self.agent_count();
        let squares = match self.motion {
            ExactMotion::Platoon { .. } => squared_differences(&self.places()),
            _ => self.squares(agents, dimension, 0).iter().map(widened).collect::<Vec<_>>(),
        };
        let least =
            extreme(&squares, false).ok_or_else(|| Failure::open("one agent has no distance to others", None))?;
        root_of_squares(least)
    }

    /// From the sum over pairs: `N sum |v_i - mean|² = sum over pairs of |v_i - v_j|²`.
    fn disagreement(&self) -> Result<Interval, Failure> {
        let (agents, dimension) = self.agent_count();
        let squares = match self.motion {
            ExactMotion::Platoon { .. } => squared_differences(&self.speeds()),
            _ => self.squares(agents, dimension, agents * dimension).iter().map(widened).collect::<Vec<_>>(),
        };
        let zero = Interval::from_rational(&rational(0, 1), BITS);
        let sum = squares.into_iter().fold(zero, |sum, x| sum + x);
        let mean = sum.over(&sum.integer(agents.max(1) as i64)).map_err(unmeasured)?;
        root_of_squares(mean)
    }

    /// Actual places `x_k` of the cars.
    fn places(&self) -> Vec<Interval> {
        let ExactMotion::Platoon { deviations, spacing, .. } = self.motion else { return Vec::new() };
        let deviation = self.deviations();
        (0..deviations.len())
            .map(|k| {
                let own = deviation[k].clone();
                let shift = own.rational(&(spacing * rational(k as i64, 1)));
                own - shift
            })
            .collect()
    }

    fn cars(&self) -> usize {
        self.state.len() / 2 - 1
    }

    /// Deviations `y_k` of the cars, that of the leader with its swing.
    fn deviations(&self) -> Vec<Interval> {
        let cars = self.cars();
        let mut all: Vec<Interval> = self.state[..cars].iter().map(widened).collect();
        if let Some(first) = all.first_mut() {
            *first = first.clone() + widened(&self.state[2 * cars]);
        }
        all
    }

    fn speeds(&self) -> Vec<Interval> {
        let ExactMotion::Platoon { swing, .. } = self.motion else { return Vec::new() };
        let cars = self.cars();
        let mut all: Vec<Interval> = self.state[cars..2 * cars].iter().map(widened).collect();
        if let Some(first) = all.first_mut() {
            let w = first.rational(&swing.1);
            *first = first.clone() - widened(&self.state[2 * cars + 1]) * w;
        }
        all
    }

    fn energies(&self, name: &str, potential: &Potential, radius: Option<&Rational>) -> Result<Interval, Failure> {
        let numbers: Vec<Interval> = self.state.iter().map(widened).collect();
        let agents = self.agent_count().0;
        let state = numbers.get(..4 * agents).and_then(|list| State::from_list(agents, list));
        let state = state.ok_or_else(|| Failure::open("a state of another size", None))?;
        let kinetic = || kinetic_energy(&state.velocities, Coordinates::Cartesian).map_err(unmeasured);
        if name == "kinetic" {
            return kinetic();
        }
        if name == "saturated_energy"
            && let Some(radius) = radius
        {
            // V at the smaller of distance and radius has no jump where a link changes, so that the links need not be known.
            let square = kinetic()?.rational(&(radius * radius));
            let all: Vec<Pair> = (0..agents).flat_map(|j| (0..j).map(move |i| (i, j))).collect();
            let value = |_: usize, _: usize, s: &Interval| {
                potential.value(&extreme(&[s.clone(), square.clone()], false).unwrap_or_else(|| square.clone()))
            };
            let own = potential_energy(&state.positions, &all, Coordinates::Cartesian, value).map_err(unmeasured)?;
            return Ok(own + kinetic()?);
        }
        let Some(pairs) = &self.pairs else { return Err(Failure::open("the links change at that time", None)) };
        let value = |_: usize, _: usize, s: &Interval| potential.value(s);
        let own = potential_energy(&state.positions, pairs, Coordinates::Cartesian, value).map_err(unmeasured)?;
        if name == "potential" { Ok(own) } else { Ok(own + kinetic()?) }
    }

    /// The largest angle between two headings, which are followed continuously.
    fn heading_spread(&self, agents: usize) -> Result<Interval, Failure> {
        let pairs = (0..agents).flat_map(|j| (0..j).map(move |i| (i, j)));
        let first = 4 * agents;
        let sizes: Vec<Interval> = pairs
            .map(|(i, j)| Number::interval(widened(&self.difference(first + i, first + j))))
            .map(|angle| angle.absolute(BITS).enclosure(BITS))
            .collect();
        if sizes.iter().any(|size| narrowed(size).hi() >= std::f64::consts::PI) {
            return Err(Failure::open("two agents may move in opposite directions", None));
        }
        extreme(&sizes, true).ok_or_else(|| Failure::open("one agent has no heading different from others", None))
    }

    /// One of the two numbers of the sum of the velocities.
    fn momentum(&self, arguments: &[Number]) -> Result<Interval, Failure> {
        let range = || Problem::Range {
            what: "the index of `momentum`".to_string(),
            expected: "1 or 2".to_string(),
            found: arguments.first().map_or(String::new(), Number::text),
        };
        let index = arguments.first().and_then(Number::as_integer).and_then(|k| k.to_usize());
        let axis = index.filter(|k| (1..=2).contains(k)).ok_or_else(|| Failure::Refused(0, range()))? - 1;
        let agents = self.agent_count().0;
        let zero = Interval::from_rational(&rational(0, 1), BITS);
        // Velocities, or the phasors to which the drift is added, follow the places.
        let own = (0..agents).map(|k| widened(&self.state[2 * (agents + k) + axis]));
        let sum = own.fold(zero, |sum, v| sum + v);
        Ok(match self.motion {
            ExactMotion::Particles { drift, .. } => {
                let drifts = sum.rational(&(&drift[axis] * rational(agents as i64, 1)));
                sum + drifts
            }
            _ => sum,
        })
    }

    /// Of particles the second half of the state, the first being places.
    fn phasors(&self) -> Vec<Complex<Interval>> {
        let numbers: Vec<Interval> = self.state.iter().map(widened).collect();
        match self.motion {
            ExactMotion::Particles { .. } => phasors_of(&numbers[numbers.len() / 2..]),
            _ => phasors_of(&numbers),
        }
    }

    /// What the control (14) with the gain `K_1` lowers.
    fn orientation_potential(&self, gain: &Rational, network: &Neighbours) -> Result<Interval, Failure> {
        let phase = phase_potential(network, &self.phasors(), 1).map_err(unmeasured)?;
        let gain = phase.rational(gain);
        Ok(-(phase * gain))
    }

    fn of_phases(&self, name: &str, network: &Neighbours, arguments: &[Number]) -> Result<Interval, Failure> {
        let phasors = self.phasors();
        if name == "phase_potential" {
            return phase_potential(network, &phasors, 1).map_err(unmeasured);
        }
        let order = match arguments.first() {
            None => 1,
            Some(number) => {
                let range = || Problem::Range {
                    what: "the index of `order`".to_string(),
                    expected: "an integer from 1 to 64".to_string(),
                    found: number.text(),
                };
                let order = number.as_integer().and_then(|m| m.to_u32()).filter(|m| (1..=64).contains(m));
                order.ok_or_else(|| Failure::Refused(0, range()))?
            }
        };
        root_of_squares(moment(&phasors, order).map_err(unmeasured)?.norm_squared())
    }

    /// What the spacing control and the orientation control lower together.
    fn composite_potential(&self) -> Result<Interval, Failure> {
        let ExactMotion::Particles { frequency, gain, spacing, network, .. } = self.motion else {
            return Err(Failure::open("it is no motion of particles", None));
        };
        let omega = Interval::from_rational(frequency, BITS);
        let orientation = self.orientation_potential(gain, network)?.over(&omega.square()).map_err(unmeasured)?;
        Ok(match spacing {
            ExactSpacing::None => orientation,
            ExactSpacing::Circle(strength) => {
                orientation + self.of_centres("spacing_potential", frequency, network)? * omega.rational(strength)
            }
            ExactSpacing::Beacon(strength, place) => {
                let state = self.particles();
                let beacon = Complex::new(omega.rational(&place[0]), omega.rational(&place[1]));
                let share = beacon_potential(&omega, &beacon, &state).map_err(unmeasured)?;
                orientation + share * omega.rational(&(strength * rational(state.phasors.len() as i64, 1)))
            }
        })
    }

    /// Positions and phasors.
    fn particles(&self) -> oscillator::State<Interval> {
        let numbers: Vec<Interval> = self.state.iter().map(widened).collect();
        let mut positions = phasors_of(&numbers);
        let phasors = positions.split_off(positions.len() / 2);
        oscillator::State { positions, phasors }
    }

    /// Of the centres of the circles: (17), or their largest distance from their mean.
    fn of_centres(&self, name: &str, frequency: &Rational, network: &Neighbours) -> Result<Interval, Failure> {
        let state = self.particles();
        let omega = Interval::from_rational(frequency, BITS);
        if name == "spacing_potential" {
            return spacing_potential(&omega, network, &state).map_err(unmeasured);
        }
        let centres = circle_centres(&omega, &state).map_err(unmeasured)?;
        let middle = oscillator::mean(&centres).map_err(unmeasured)?;
        let squares: Vec<Interval> = centres.into_iter().map(|c| (c - &middle).norm_squared()).collect();
        let most = extreme(&squares, true).ok_or_else(|| Failure::open("there are no particles", None))?;
        root_of_squares(most)
    }

    fn of_platoon(&self, name: &str, spacing: &Rational) -> Option<Interval> {
        let deviations = self.deviations();
        let (leader, followers) = deviations.split_first()?;
        let size = |x: &Interval| Number::interval(x.clone()).absolute(BITS).enclosure(BITS);
        match name {
            "last_deviation" => followers.last().map(|x| x.clone() - leader),
            "largest_deviation" => {
                let sizes: Vec<Interval> = followers.iter().map(|x| size(&(x.clone() - leader))).collect();
                extreme(&sizes, true)
            }
            _ => {
                let gap = |pair: &[Interval]| pair[0].clone() - &pair[1] + pair[0].rational(spacing);
                let gaps: Vec<Interval> = deviations.windows(2).map(gap).collect();
                extreme(&gaps, name == "max_gap")
            }
        }
    }
}

fn unmeasured(error: ArithmeticError) -> Failure {
    Failure::open(format!("it cannot be measured on the enclosure: {error}"), None)
}

/// The root of a sum of squares, which is not negative whatever rounding says.
fn root_of_squares(sum: Interval) -> Result<Interval, Failure> {
    let zero = Dyadic::zero();
    let from = |end: &Dyadic| end.clone().max(zero.clone());
    Interval::between(from(sum.lo()), from(sum.hi()), sum.precision()).sqrt().map_err(unmeasured)
}

/// `(x_i - x_j)²` of all pairs.
fn squared_differences(list: &[Interval]) -> Vec<Interval> {
    let pairs = (0..list.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
    pairs.map(|(i, j)| (list[i].clone() - &list[j]).square()).collect()
}

/// Encloses the largest, or the smallest, of some numbers.
fn extreme(list: &[Interval], largest: bool) -> Option<Interval> {
    list.iter().cloned().reduce(|a, b| {
        let end = |x: &Dyadic, y: &Dyadic| if (x >= y) == largest { x.clone() } else { y.clone() };
        Interval::between(end(a.lo(), b.lo()), end(a.hi(), b.hi()), BITS)
    })
}

impl Moment for At<'_, '_> {
    fn measure(&self, quantity: &Quantity, arguments: &[Number], precision: u32) -> Result<Measured, Failure> {
        let name = quantity.name;
        if let Some(exact) = self.subject.exact(name, arguments, self.holds, precision) {
            return Ok(Measured::Number(exact));
        }
        let not_here = || {
            let why = format!("`{name}` is no observable of this model");
            Failure::Refused(0, Problem::Other(why))
        };
        if name == "components" {
            let counts = self.components().ok_or_else(not_here)?;
            let [least, most] = counts.map(|count| Number::integer(count as i64));
            let hull = |a: &Number, b: &Number| Number::interval(a.enclosure(BITS).hull(&b.enclosure(BITS)));
            return Ok(Measured::Number(if counts[0] == counts[1] { least } else { hull(&least, &most) }));
        }
        let found = match (self.motion, name) {
            (ExactMotion::Phases { .. } | ExactMotion::Other(_), "min_distance") => return Err(not_here()),
            (_, "min_distance") => self.min_distance(),
            (ExactMotion::Velocities { .. } | ExactMotion::Platoon { .. }, "disagreement") => self.disagreement(),
            (ExactMotion::Velocities { positions, headings: Some(_), .. }, "heading_spread") => {
                self.heading_spread(positions.len())
            }
            (ExactMotion::Velocities { headings: Some(_), .. }, "saturated_energy") => return Err(not_here()),
            (
                ExactMotion::Velocities { potential, radius, .. },
                "potential" | "kinetic" | "energy" | "saturated_energy",
            ) => self.energies(name, potential, radius.as_ref()),
            (ExactMotion::Velocities { .. } | ExactMotion::Particles { .. }, "momentum") => self.momentum(arguments),
            (
                ExactMotion::Phases { gain, network, .. } | ExactMotion::Particles { gain, network, .. },
                "orientation_potential",
            ) => self.orientation_potential(gain, network),
            (
                ExactMotion::Phases { network, .. } | ExactMotion::Particles { network, .. },
                "order" | "phase_potential",
            ) => self.of_phases(name, network, arguments),
            (ExactMotion::Particles { .. }, "composite_potential") => self.composite_potential(),
            (ExactMotion::Particles { frequency, network, .. }, "spacing_potential" | "centre_spread") => {
                self.of_centres(name, frequency, network)
            }
            (ExactMotion::Platoon { spacing, .. }, "min_gap" | "max_gap" | "largest_deviation" | "last_deviation") => {
                self.of_platoon(name, spacing).ok_or_else(not_here)
            }
            _ => return Err(not_here()),
        };
        found.map(|x| Measured::Number(Number::interval(x)))
    }
}
