//! Continuous motions on validated enclosures: velocity alignment, the phase model, platoons.

use crate::error::Problem;
use crate::evaluate::{Failure, Measured, Moment};
use crate::names::Quantity;
use crate::number::Number;
use crate::time::{Covered, Piece, Timeline};
use crate::truth::Doubt;
use arithmetic::{
    ArithmeticError, Complex, Dyadic, Field, FloatInterval, Interval, Progress, Rational, Real, Ring, rational,
};
use models::double_integrator::{
    Coordinates, EnclosedFlock, FixedNetwork, Pair, Potential, State, kinetic_energy, linked_within, potential_energy,
};
use models::oscillator::{Neighbours, laplacian_control, moment, phase_potential};
use models::platoon::{CommunicationGraph, Gains};
use motion::validated::{Flow, IntervalVector, Parallelepiped, SmoothLaw, Step};
use num_traits::ToPrimitive;
use scenario::ExactMotion;
use std::cell::RefCell;
use std::rc::Rc;

/// A motion of a case, enclosed as far as it was needed.
pub(crate) struct MotionSubject<'c> {
    motion: ExactMotion,
    /// Numbers of the start that are intervals: list, agent and coordinate, from 0.
    wide: Vec<(Start, usize, usize, Rational, Rational)>,
    progress: &'c dyn Progress,
    tube: RefCell<Rc<Tube>>,
}

/// Which list of the start.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Start {
    Positions,
    Velocities,
    Phases,
}

/// Enclosures of the states, one after the other.
#[derive(Default)]
struct Tube {
    sections: Vec<Section>,
    /// The time that was asked for.
    asked: f64,
    /// Why it ends earlier.
    failure: Option<String>,
}

/// A short time with the states in it.
struct Section {
    from: f64,
    to: f64,
    states: States,
    /// The links; `None` while they change.
    pairs: Option<Rc<Vec<Pair>>>,
}

enum States {
    Step(Step),
    Box(IntervalVector),
}

/// Most sections of a tube.
const MOST_SECTIONS: usize = 50_000;

/// Most agents.
const MOST_AGENTS: usize = 16;

/// Bits of what is measured.
const BITS: u32 = 64;

/// The phase model as phasors: `z' = i (omega_0 + u) z`, real parts and imaginary parts by turns.
struct PhaseLaw<'a> {
    frequency: &'a Rational,
    gain: &'a Rational,
    network: &'a Neighbours,
}

impl SmoothLaw for PhaseLaw<'_> {
    fn rate<T: Field>(&self, state: &[T]) -> Result<Vec<T>, ArithmeticError> {
        let Some(like) = state.first() else { return Ok(Vec::new()) };
        let phasors = phasors_of(state);
        let (frequency, gain) = (like.rational(self.frequency), like.rational(self.gain));
        let control = laplacian_control(&gain, self.network, &phasors)?;
        let turned = phasors.into_iter().zip(control).flat_map(|(z, u)| {
            let rate = u + &frequency;
            [-(z.im * &rate), z.re * rate]
        });
        Ok(turned.collect())
    }
}

fn phasors_of<T: Ring>(state: &[T]) -> Vec<Complex<T>> {
    state.chunks_exact(2).map(|pair| Complex::new(pair[0].clone(), pair[1].clone())).collect()
}

/// Deviations, rates, and the swing `(A cos wt, A sin wt)` of the leader at the end.
struct PlatoonLaw<'a> {
    gains: &'a (Rational, Rational),
    graph: &'a CommunicationGraph,
    frequency: &'a Rational,
}

impl SmoothLaw for PlatoonLaw<'_> {
    fn rate<T: Field>(&self, state: &[T]) -> Result<Vec<T>, ArithmeticError> {
        let cars = self.graph.followers() + 1;
        let (Some(swing), Some(like)) = (state.get(2 * cars..), state.first()) else { return Ok(Vec::new()) };
        let w = like.rational(self.frequency);
        let swing_rate = [-(swing[1].clone() * &w), swing[0].clone() * &w];
        let place = state[0].clone() + &swing[0];
        let speed = state[cars].clone() + &swing_rate[0];
        let gains = Gains { f: like.rational(&self.gains.0), g: like.rational(&self.gains.1) };
        let (positions, velocities) = (&state[1..cars], &state[cars + 1..2 * cars]);
        let forces = self.graph.accelerations(&gains, (&place, &speed), positions, velocities);
        let rates = state[cars..2 * cars].iter().cloned();
        Ok(rates.chain([like.zero()]).chain(forces).chain(swing_rate).collect())
    }
}

fn point(q: &Rational) -> FloatInterval {
    FloatInterval::from_rational(q)
}

fn widened(x: &FloatInterval) -> Interval {
    let end = |x: f64| Dyadic::from_f64(x);
    match (end(x.lo()), end(x.hi())) {
        (Some(lo), Some(hi)) => Interval::between(lo, hi, BITS),
        _ => {
            // Unbounded: nothing is known.
            let far = Dyadic::new(1.into(), 4096);
            Interval::between(far.negated(), far, BITS)
        }
    }
}

impl<'c> MotionSubject<'c> {
    pub fn new(
        motion: ExactMotion,
        wide: Vec<(Start, usize, usize, Rational, Rational)>,
        progress: &'c dyn Progress,
    ) -> Self {
        MotionSubject { motion, wide, progress, tube: RefCell::default() }
    }

    /// A number of the start, or its interval.
    fn start(&self, list: Start, agent: usize, coordinate: usize, value: &Rational) -> FloatInterval {
        let own = self.wide.iter().find(|(l, a, c, ..)| (*l, *a, *c) == (list, agent, coordinate));
        own.map_or_else(|| point(value), |(_, _, _, lo, hi)| point(lo).hull(&point(hi)))
    }

    fn vectors(&self, list: Start, rows: &[Vec<Rational>]) -> Vec<[FloatInterval; 2]> {
        let row = |(agent, row): (usize, &Vec<Rational>)| {
            let coordinate = |k: usize| row.get(k).map_or(point(&rational(0, 1)), |x| self.start(list, agent, k, x));
            [coordinate(0), coordinate(1)]
        };
        rows.iter().enumerate().map(row).collect()
    }

    /// The tube at least up to a time, or as far as it goes.
    fn tube(&self, until: f64) -> Result<Rc<Tube>, Failure> {
        {
            let tube = self.tube.borrow();
            if tube.asked >= until && !tube.sections.is_empty() {
                return Ok(tube.clone());
            }
        }
        self.progress.checkpoint()?;
        // A section of no length is needed for time 0.
        let until = until.max(1e-3);
        let tube = Rc::new(self.enclosed(until)?);
        *self.tube.borrow_mut() = tube.clone();
        Ok(tube)
    }

    fn enclosed(&self, until: f64) -> Result<Tube, Failure> {
        match &self.motion {
            ExactMotion::Other(why) => {
                Ok(Tube { sections: Vec::new(), asked: until, failure: Some((*why).to_string()) })
            }
            ExactMotion::Velocities { positions, velocities, potential, pairs, radius } => {
                self.small(positions.len())?;
                let start = State {
                    positions: self.vectors(Start::Positions, positions),
                    velocities: self.vectors(Start::Velocities, velocities),
                };
                if let Some(radius) = radius {
                    return Ok(self.switching(&start, potential, radius, until));
                }
                let mut tube = self.followed(FixedNetwork { potential, edges: pairs }, &start.to_list(), until)?;
                let pairs = Rc::new(pairs.clone());
                tube.sections.iter_mut().for_each(|section| section.pairs = Some(pairs.clone()));
                Ok(tube)
            }
            ExactMotion::Phases { phases, frequency, gain, network } => {
                self.small(phases.len())?;
                let phasor = |(agent, phase): (usize, &Rational)| {
                    let angle = widened(&self.start(Start::Phases, agent, 0, phase));
                    let exact = if self.wide.is_empty() { Interval::from_rational(phase, BITS) } else { angle };
                    let (sin, cos) = exact.sin_cos().map_err(|error| Failure::open(error.to_string(), None))?;
                    Ok([narrowed(&cos), narrowed(&sin)])
                };
                let state: Vec<[FloatInterval; 2]> =
                    phases.iter().enumerate().map(phasor).collect::<Result<_, Failure>>()?;
                let law = PhaseLaw { frequency, gain, network };
                self.followed(law, &state.into_iter().flatten().collect::<Vec<_>>(), until)
            }
            ExactMotion::Platoon { deviations, rates, gains, graph, swing, .. } => {
                self.small(deviations.len())?;
                let list = |list: Start, values: &[Rational]| -> IntervalVector {
                    values.iter().enumerate().map(|(agent, x)| self.start(list, agent, 0, x)).collect()
                };
                if self.wide.iter().any(|(list, ..)| *list == Start::Positions) {
                    return Err(Failure::open("positions of cars are single numbers", None));
                }
                let mut state = list(Start::Positions, deviations);
                state.extend(list(Start::Velocities, rates));
                state.extend([point(&swing.0), point(&rational(0, 1))]);
                self.followed(PlatoonLaw { gains, graph, frequency: &swing.1 }, &state, until)
            }
        }
    }

    fn small(&self, agents: usize) -> Result<(), Failure> {
        if agents <= MOST_AGENTS {
            return Ok(());
        }
        Err(Failure::open(
            format!("motions of more than {MOST_AGENTS} agents are not enclosed, and this one has {agents}"),
            None,
        ))
    }

    /// Steps of a smooth law.
    fn followed(&self, law: impl SmoothLaw, start: &[FloatInterval], until: f64) -> Result<Tube, Failure> {
        const FIRST_STEP: f64 = 0.01;
        let mut flow = Flow::new(law, FIRST_STEP);
        let (mut set, mut time) = (Parallelepiped::of_box(start), 0.0);
        let mut tube = Tube { sections: Vec::new(), asked: until, failure: None };
        let none = Rc::new(Vec::new());
        // Beyond this it only grows, in ever shorter steps.
        let first = start.iter().map(FloatInterval::width).fold(0.0, f64::max);
        let widest = (8.0 * first).max(0.25);
        while time < until {
            self.progress.checkpoint()?;
            if tube.sections.len() >= MOST_SECTIONS {
                tube.failure = Some(format!("no enclosure beyond t = {time:.6}: too many steps"));
                break;
            }
            match flow.step(&set, time, until) {
                Ok(step) => {
                    set = step.end.clone();
                    let width = set.hull().iter().map(FloatInterval::width).fold(0.0, f64::max);
                    if width > widest {
                        tube.failure = Some(format!("at t = {time:.6} the enclosure is {width:.2} wide"));
                        break;
                    }
                    let to = step.until;
                    tube.sections.push(Section {
                        from: time,
                        to,
                        states: States::Step(step),
                        pairs: Some(none.clone()),
                    });
                    time = to;
                }
                Err(error) => {
                    tube.failure = Some(error.to_string());
                    break;
                }
            }
        }
        Ok(tube)
    }

    /// Velocity alignment with links that switch at a distance.
    fn switching(&self, start: &State<FloatInterval>, potential: &Potential, radius: &Rational, until: f64) -> Tube {
        let flock = EnclosedFlock { potential: potential.clone(), threshold: Some(radius * radius) };
        let mut steps: Vec<(f64, Step)> = Vec::new();
        let run = flock.run(start, &[], until, |from, step| steps.push((from, step.clone())));
        let failure = run.as_ref().err().map(ToString::to_string);
        let mut events: Vec<_> = run.as_ref().map(|run| run.events.clone()).unwrap_or_default();
        events.reverse();
        let square = point(&(radius * radius));
        let mut links = linked_within(&start.positions, &square, Coordinates::Cartesian).edges();
        let mut current = Rc::new(links.clone());
        // Without the events of a run that failed the links are only known where there are none to change.
        let known = failure.is_none();
        let mut sections: Vec<Section> = Vec::new();
        for (from, step) in steps {
            while let Some(event) = events.pop_if(|event| event.to <= from) {
                links.retain(|pair| *pair != event.pair);
                if event.linked {
                    links.push(event.pair);
                }
                current = Rc::new(links.clone());
            }
            let pairs = known.then(|| current.clone());
            sections.push(Section { from, to: step.until, states: States::Step(step), pairs });
        }
        if let Ok(run) = run {
            sections.extend(run.crossings.into_iter().map(|crossing| Section {
                from: crossing.from,
                to: crossing.to,
                states: States::Box(crossing.states),
                pairs: None,
            }));
            sections.sort_by(|a, b| a.from.total_cmp(&b.from));
        }
        Tube { sections, asked: until, failure }
    }
}

/// An enclosure between floats.
fn narrowed(x: &Interval) -> FloatInterval {
    let (lo, hi) = x.to_rationals();
    FloatInterval::between(point(&lo).lo(), point(&hi).hi())
}

impl Timeline for MotionSubject<'_> {
    fn pieces(&self, from: &Rational, to: Option<&Rational>, _: &[&str]) -> Result<Covered, Failure> {
        let Some(to) = to else {
            return Err(Failure::Refused(0, Problem::Unbounded));
        };
        let tube = self.tube(point(to).hi())?;
        let exact = |x: f64| Rational::from_float(x).unwrap_or_else(|| rational(0, 1));
        let mut pieces = Vec::new();
        let mut reached = None;
        for section in &tube.sections {
            let (begin, end) = (exact(section.from).max(from.clone()), exact(section.to).min(to.clone()));
            if begin <= end {
                // Sections follow each other without gaps.
                if reached.as_ref().is_some_and(|reached| *reached != begin) {
                    break;
                }
                reached = Some(end.clone());
                pieces.push(Piece { from: begin, to: Some(end) });
            }
        }
        let rest = if reached.as_ref().is_some_and(|reached| reached >= to) {
            None
        } else {
            let end = tube.sections.last().map_or(0.0, |section| section.to);
            let why = tube.failure.clone().unwrap_or_else(|| "a gap in the enclosure".to_string());
            Some(Doubt { why: format!("the motion is enclosed up to t = {end:.6} only: {why}"), bits: None })
        };
        Ok(Covered { pieces, rest })
    }

    fn moment<'t>(&'t self, piece: &Piece) -> Result<Box<dyn Moment + 't>, Failure> {
        let tube = self.tube.borrow().clone();
        let begin = point(&piece.from);
        let end = piece.to.as_ref().map_or(begin, point);
        let float = |q: &Rational| q.to_f64().unwrap_or(0.0);
        let middle = piece.to.as_ref().map_or(piece.from.clone(), |to| (&piece.from + to) * rational(1, 2));
        let place = tube.sections.partition_point(|section| section.from <= float(&middle)).saturating_sub(1);
        let Some(section) = tube.sections.get(place) else {
            return Err(Failure::open("the motion is not enclosed at that time", None));
        };
        let exact = |x: f64| Rational::from_float(x).unwrap_or_else(|| rational(0, 1));
        let last = piece.to.as_ref().unwrap_or(&piece.from);
        if piece.from < exact(section.from) || *last > exact(section.to) {
            return Err(Failure::open("a piece of time lies across two steps", None));
        }
        let (state, differences) = match &section.states {
            States::Box(states) => (states.clone(), None),
            States::Step(step) => {
                let after = begin.hull(&end) - FloatInterval::point(section.from);
                let after = FloatInterval::between(
                    after.lo().clamp(0.0, step.span.hi()),
                    after.hi().clamp(0.0, step.span.hi()),
                );
                (step.states(after), Some((step.clone(), after)))
            }
        };
        Ok(Box::new(At { motion: &self.motion, state, differences, pairs: section.pairs.clone() }))
    }

    fn halves(&self, piece: &Piece) -> Option<[Piece; 2]> {
        let to = piece.to.as_ref()?;
        if *to <= piece.from {
            return None;
        }
        let middle = (&piece.from + to) * rational(1, 2);
        Some([
            Piece { from: piece.from.clone(), to: Some(middle.clone()) },
            Piece { from: middle, to: Some(to.clone()) },
        ])
    }

    fn prepare(&self, until: &Rational) -> Result<(), Failure> {
        self.tube(point(until).hi()).map(|_| ())
    }

    fn inside(&self, from: Rational, to: Option<Rational>) -> (Rational, Option<Rational>) {
        (from, to)
    }
}

/// The states at all times of a piece.
struct At<'m> {
    motion: &'m ExactMotion,
    state: IntervalVector,
    differences: Option<(Step, FloatInterval)>,
    pairs: Option<Rc<Vec<Pair>>>,
}

impl At<'_> {
    /// Coordinate `i` less coordinate `j`.
    fn difference(&self, i: usize, j: usize) -> FloatInterval {
        match &self.differences {
            Some((step, after)) => step.difference(i, j, *after),
            None => self.state[i] - self.state[j],
        }
    }

    /// The square of the distance of two vectors of `dimension` coordinates whose first ones begin at `offset`.
    fn square(&self, i: usize, j: usize, dimension: usize, offset: usize) -> FloatInterval {
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
        least.sqrt().map_err(unmeasured)
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
        mean.sqrt().map_err(unmeasured)
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

    fn energies(&self, name: &str, potential: &Potential) -> Result<Interval, Failure> {
        let numbers: Vec<Interval> = self.state.iter().map(widened).collect();
        let state = State::from_list(numbers.len() / 4, &numbers)
            .ok_or_else(|| Failure::open("a state of another size", None))?;
        let kinetic = || kinetic_energy(&state.velocities, Coordinates::Cartesian).map_err(unmeasured);
        if name == "kinetic" {
            return kinetic();
        }
        let Some(pairs) = &self.pairs else { return Err(Failure::open("the links change at that time", None)) };
        let value = |_: usize, _: usize, s: &Interval| potential.value(s);
        let own = potential_energy(&state.positions, pairs, Coordinates::Cartesian, value).map_err(unmeasured)?;
        if name == "potential" { Ok(own) } else { Ok(own + kinetic()?) }
    }

    fn of_phases(&self, name: &str, network: &Neighbours, arguments: &[Number]) -> Result<Interval, Failure> {
        let numbers: Vec<Interval> = self.state.iter().map(widened).collect();
        let phasors = phasors_of(&numbers);
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
        moment(&phasors, order).and_then(|p| p.norm_squared().sqrt()).map_err(unmeasured)
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

impl Moment for At<'_> {
    fn measure(&self, quantity: &Quantity, arguments: &[Number], _: u32) -> Result<Measured, Failure> {
        let name = quantity.name;
        let not_here = || {
            let why = format!("`{name}` is no observable of this model");
            Failure::Refused(0, Problem::Other(why))
        };
        let found = match (self.motion, name) {
            (ExactMotion::Velocities { .. } | ExactMotion::Platoon { .. }, "min_distance") => self.min_distance(),
            (ExactMotion::Velocities { .. } | ExactMotion::Platoon { .. }, "disagreement") => self.disagreement(),
            (ExactMotion::Velocities { potential, .. }, "potential" | "kinetic" | "energy") => {
                self.energies(name, potential)
            }
            (ExactMotion::Phases { network, .. }, "order" | "phase_potential") => {
                self.of_phases(name, network, arguments)
            }
            (ExactMotion::Platoon { spacing, .. }, "min_gap" | "max_gap" | "largest_deviation" | "last_deviation") => {
                self.of_platoon(name, spacing).ok_or_else(not_here)
            }
            _ => return Err(not_here()),
        };
        found.map(|x| Measured::Number(Number::interval(x)))
    }
}
