//! Continuous motions on validated enclosures: velocity and heading alignment, the phase model, steered particles, platoons. Platoons on a line are the exact
//! sum over their modes instead.

mod at;
mod closed;
mod constants;
mod curve;
mod exact;
mod laws;
mod modes;
mod numbers;

pub(crate) use numbers::Start;

use crate::error::Problem;
use crate::failure::Failure;
use crate::timeline::{Covered, Curve, Field, Moment, Piece, Timeline, clock};
use crate::truth::Doubt;
use arithmetic::{FloatInterval, Number, Progress, Rational, Ring, rational};
use at::At;
use closed::ClosedForm;
use constants::names_of;
use curve::OnCurve;
use exact::Holds;
use laws::{HeadingLaw, ParticleLaw, PhaseLaw, PlatoonLaw};
use models::double_integrator::{
    Coordinates, EnclosedFlock, EnclosedRun, EnclosureError, FixedNetwork, HeadingDifference, Pair, State,
    SwitchingMotion, linked_within,
};
use models::oscillator::Neighbours;
use modes::ModalPlatoon;
use motion::System;
use motion::enclose::{Expanded, Flow, IntervalVector, Set, Step};
use num_traits::{ToPrimitive, Zero};
use numbers::point;
use scenario::ExactMotion;
use std::cell::{OnceCell, RefCell};
use std::rc::Rc;

/// A motion of a case, enclosed as far as it was needed.
pub(crate) struct MotionSubject<'c> {
    motion: ExactMotion,
    /// Numbers of the start that are intervals: list, agent and coordinate, from 0.
    wide: Vec<(Start, usize, usize, Rational, Rational)>,
    /// Those among them that are numbers of a built-in law, by their names and entries.
    constants: Vec<(String, Option<usize>)>,
    progress: &'c dyn Progress,
    tube: RefCell<Rc<Tube>>,
    modal: OnceCell<Option<ModalPlatoon>>,
    closed: OnceCell<Option<ClosedForm>>,
    rests: OnceCell<bool>,
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

/// States as polynomials in the start, and the links; `None` while they change.
type Enclosed = (Vec<Expanded>, Option<Rc<Vec<Pair>>>);

/// Most sections of a tube.
const MOST_SECTIONS: usize = 50_000;

/// Why a motion has no closed form.
const SWITCHED: &str = "links switch at a distance, and a motion that they switch has no closed form";

/// Most agents.
const MOST_AGENTS: usize = 16;

impl<'c> MotionSubject<'c> {
    pub fn new(
        motion: ExactMotion,
        wide: Vec<(Start, usize, usize, Rational, Rational)>,
        progress: &'c dyn Progress,
    ) -> Self {
        // Open parameters of laws of one's own are numbers of their states.
        let constants = if matches!(motion, ExactMotion::Own(_)) { Vec::new() } else { names_of(&wide) };
        MotionSubject {
            motion,
            wide,
            constants,
            progress,
            tube: RefCell::default(),
            modal: OnceCell::new(),
            closed: OnceCell::new(),
            rests: OnceCell::new(),
        }
    }

    /// A number of the start, or its interval.
    fn start(&self, list: &Start, agent: usize, coordinate: usize, value: &Rational) -> FloatInterval {
        let own = self.wide.iter().find(|(l, a, c, ..)| (l, *a, *c) == (list, agent, coordinate));
        own.map_or_else(|| point(value), |(_, _, _, lo, hi)| point(lo).hull(&point(hi)))
    }

    fn vectors(&self, list: &Start, rows: &[Vec<Rational>]) -> Vec<[FloatInterval; 2]> {
        let row = |(agent, row): (usize, &Vec<Rational>)| {
            let coordinate = |k: usize| row.get(k).map_or(point(&rational(0, 1)), |x| self.start(list, agent, k, x));
            [coordinate(0), coordinate(1)]
        };
        rows.iter().enumerate().map(row).collect()
    }

    /// The intervals of the phases.
    fn angles(&self, phases: &[Rational]) -> IntervalVector {
        phases.iter().enumerate().map(|(agent, phase)| self.start(&Start::Phases, agent, 0, phase)).collect()
    }

    /// The platoon as the sum over its modes, where it is one on a line.
    fn modal(&self) -> Option<&ModalPlatoon> {
        let made = self.modal.get_or_init(|| match &self.motion {
            ExactMotion::Platoon { deviations, rates, platoon, swing, .. } => {
                let start = |list: &Start, agent: usize| {
                    let values = if *list == Start::Positions { deviations } else { rates };
                    values.get(agent).map_or(point(&rational(0, 1)), |x| self.start(list, agent, 0, x))
                };
                let narrow = self.wide.iter().all(|(list, ..)| *list == Start::Velocities);
                narrow.then(|| ModalPlatoon::new(start, platoon, swing)).flatten()
            }
            _ => None,
        });
        made.as_ref()
    }

    /// The motion in closed form, where its law is linear, its exponents are rational, and its agents are few; of a platoon relative to its leader without the swing.
    fn closed(&self) -> Option<&ClosedForm> {
        let made = || match &self.motion {
            _ if !self.wide.is_empty() => None,
            ExactMotion::Velocities { positions, velocities, potential, pairs, radius: None, headings: None } => {
                let law = FixedNetwork { potential, edges: pairs };
                let start = [positions.concat(), velocities.concat()].concat();
                self.small(positions.len()).ok().and_then(|()| ClosedForm::of(&law, &start))
            }
            ExactMotion::Platoon { deviations, rates, platoon, swing, .. } => {
                let law = PlatoonLaw { platoon, frequency: &swing.1, constants: self.constants() };
                let relative = |list: &[Rational]| list.iter().map(|x| x - &list[0]).collect::<Vec<_>>();
                let swing = vec![swing.0.clone(), rational(0, 1)];
                let start = [relative(deviations), relative(rates), swing].concat();
                self.small(deviations.len()).ok().and_then(|()| ClosedForm::of(&law, &start))
            }
            ExactMotion::Own(own) if own.radius().is_none() => {
                self.small(own.agents()).ok().and_then(|()| ClosedForm::of(own.as_ref(), &own.start))
            }
            _ => None,
        };
        self.closed.get_or_init(made).as_ref()
    }

    /// How much of the start holds at all times of a piece.
    fn holds(&self, piece: &Piece) -> Holds {
        let is_start = piece.from == rational(0, 1) && piece.to.as_ref() == Some(&piece.from);
        if is_start || *self.rests.get_or_init(|| self.is_at_rest()) { Holds::All } else { Holds::Conserved }
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
            ExactMotion::Velocities { positions, velocities, potential, pairs, radius, headings } => {
                self.small(positions.len())?;
                let start = State {
                    positions: self.vectors(&Start::Positions, positions),
                    velocities: self.vectors(&Start::Velocities, velocities),
                };
                if let Some(reading) = headings {
                    return self.turning(&start, HeadingLaw { potential, edges: pairs }, *reading, until);
                }
                if let Some(radius) = radius {
                    let square = radius * radius;
                    let flock = EnclosedFlock { potential: potential.clone(), threshold: Some(square.clone()) };
                    let links = linked_within(&start.positions, &point(&square), Coordinates::Cartesian).edges();
                    let mut steps = Vec::new();
                    let run = flock.run(&start, &[], until, |from, step| steps.push((from, step.clone())));
                    return Ok(Tube::of_switches(links, steps, run, until));
                }
                let law = FixedNetwork { potential, edges: pairs };
                let mut tube = self.followed(law, &Expanded::of_start(&start.to_list()), until)?;
                let pairs = Rc::new(pairs.clone());
                tube.sections.iter_mut().for_each(|section| section.pairs = Some(pairs.clone()));
                Ok(tube)
            }
            ExactMotion::Phases { phases, frequency, gain, network } => {
                self.small(phases.len())?;
                let start = Expanded::of_start(&[self.angles(phases), self.ranges()].concat());
                let (angles, still) = start.split_at(phases.len());
                let law = PhaseLaw { frequency, gain, network, constants: self.constants() };
                self.followed(law, &[&phasors(angles)?, still].concat(), until)
            }
            ExactMotion::Particles { positions, phases, frequency, gain, spacing, drift, network, radius } => {
                self.small(phases.len())?;
                let places = self.vectors(&Start::Positions, positions).concat();
                let start = Expanded::of_start(&[places, self.angles(phases), self.ranges()].concat());
                let (places, rest) = start.split_at(2 * positions.len());
                let (angles, still) = rest.split_at(phases.len());
                let state = [places, &phasors(angles)?, still].concat();
                let steering = (frequency, gain, spacing);
                let law = ParticleLaw { steering, drift, network, constants: self.constants() };
                let tube = self.followed(law, &state, until)?;
                Ok(match radius {
                    Some(radius) => while_linked(tube, network, &(radius * radius)),
                    None => tube,
                })
            }
            ExactMotion::Own(own) => {
                self.small(own.agents())?;
                let mut state: IntervalVector = own.start.iter().map(point).collect();
                for (list, agent, coordinate, lo, hi) in &self.wide {
                    let place = own.place(list.part(), *agent, *coordinate);
                    if let Some(number) = place.and_then(|place| state.get_mut(place)) {
                        *number = point(lo).hull(&point(hi));
                    }
                }
                let start = Expanded::of_start(&state);
                let Some(radius) = own.radius() else { return self.followed(own.as_ref(), &start, until) };
                let motion = SwitchingMotion::new(own.as_ref(), Some(&(radius * radius)));
                let mut steps = Vec::new();
                let run = motion.run(&Set::of_numbers(&start), until, |from, step| steps.push((from, step.clone())));
                Ok(Tube::of_switches(motion.links(&state).edges(), steps, run, until))
            }
            ExactMotion::Platoon { deviations, rates, platoon, spacing, swing } => {
                self.small(deviations.len())?;
                let list = |list: &Start, values: &[Rational]| -> IntervalVector {
                    values.iter().enumerate().map(|(agent, x)| self.start(list, agent, 0, x)).collect()
                };
                if self.wide.iter().any(|(list, ..)| *list == Start::Positions) {
                    return Err(Failure::open("positions of cars are single numbers", None));
                }
                let mut state = list(&Start::Positions, deviations);
                state.extend(list(&Start::Velocities, rates));
                state.extend([point(&swing.0), point(&rational(0, 1))]);
                state.extend(self.ranges());
                let mut state = Expanded::of_start(&state);
                self.constants().set_out(spacing, &mut state, deviations.len());
                let law = PlatoonLaw { platoon, frequency: &swing.1, constants: self.constants() };
                self.followed(law, &state, until)
            }
        }
    }

    /// The states at all times of a piece that lies in one section of the tube, and the links.
    fn enclosed_at(&self, piece: &Piece) -> Result<Enclosed, Failure> {
        let last = piece.to.as_ref().unwrap_or(&piece.from);
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
        if piece.from < exact(section.from) || *last > exact(section.to) {
            return Err(Failure::open("a piece of time lies across two steps", None));
        }
        let state = match &section.states {
            States::Box(states) => Expanded::of_box(states),
            States::Step(step) => {
                let after = begin.hull(&end) - FloatInterval::point(section.from);
                let after = FloatInterval::between(
                    after.lo().clamp(0.0, step.span.hi()),
                    after.hi().clamp(0.0, step.span.hi()),
                );
                step.expanded(after)
            }
        };
        Ok((state, section.pairs.clone()))
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
    fn followed(&self, law: impl System, start: &[Expanded], until: f64) -> Result<Tube, Failure> {
        const FIRST_STEP: f64 = 0.01;
        let mut flow = Flow::new(law, FIRST_STEP);
        let (mut set, mut time) = (Set::of_numbers(start), 0.0);
        let mut tube = Tube { sections: Vec::new(), asked: until, failure: None };
        let none = Rc::new(Vec::new());
        // Where what is not known of the set as polynomials is wider than this, it only grows, in ever shorter steps.
        let mut widest = (8.0 * set.width()).max(0.25);
        let mut is_renewed = false;
        while time < until {
            self.progress.checkpoint()?;
            if tube.sections.len() >= MOST_SECTIONS {
                tube.failure = Some(format!("no enclosure beyond t = {}: too many steps", clock(time)));
                break;
            }
            match flow.step(&set, time, until) {
                Ok(step) => {
                    set = step.end.clone();
                    if step.is_renewed && !is_renewed {
                        (is_renewed, widest) = (true, widest.max(8.0 * set.width()));
                    }
                    let unknown = if is_renewed { set.width() } else { 2.0 * set.rest_radius() };
                    if unknown > widest {
                        let width = set.width();
                        tube.failure = Some(format!("at t = {} the enclosure is {width:.2} wide", clock(time)));
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

    /// Heading alignment, up to where the reading of the heading differences may jump.
    fn turning(
        &self,
        start: &State<FloatInterval>,
        law: HeadingLaw,
        reading: HeadingDifference,
        until: f64,
    ) -> Result<Tube, Failure> {
        let mut list = Expanded::of_start(&start.to_list());
        let velocities = list[2 * start.count()..].to_vec();
        for (v, agent) in velocities.chunks_exact(2).zip(1..) {
            let unknown =
                |_| Failure::open(format!("agent {agent} may be at rest or turn through pi at the start"), None);
            list.push(Expanded::angle(&v[1], &v[0]).map_err(unknown)?);
        }
        let (pairs, first) = (Rc::new(law.edges.to_vec()), 4 * start.count());
        let mut tube = self.followed(law, &list, until)?;
        let jumps = |section: &Section| {
            let States::Step(step) = &section.states else { return true };
            let states = step.expanded(FloatInterval::between(0.0, step.span.hi()));
            let angles = &states[first..];
            let beyond = |angle: Expanded| angle.range().magnitude() >= std::f64::consts::PI;
            match reading {
                HeadingDifference::Unwrapped => false,
                HeadingDifference::Raw => angles.iter().cloned().any(beyond),
                HeadingDifference::Wrapped => pairs.iter().any(|&(i, j)| beyond(angles[i].clone() - &angles[j])),
            }
        };
        if let Some(place) = tube.sections.iter().position(jumps) {
            let why = match reading {
                HeadingDifference::Raw => "a heading may pass pi, where differences of headings jump",
                _ => "two linked agents may move in opposite directions, where differences of headings jump",
            };
            tube.sections.truncate(place);
            tube.failure = Some(why.to_string());
        }
        tube.sections.iter_mut().for_each(|section| section.pairs = Some(pairs.clone()));
        Ok(tube)
    }
}

impl Tube {
    /// Of agents whose links switch at a distance, with the links at the start.
    fn of_switches<E>(
        mut links: Vec<Pair>,
        steps: Vec<(f64, Step)>,
        run: Result<EnclosedRun<E>, EnclosureError>,
        until: f64,
    ) -> Self {
        let failure = run.as_ref().err().map(ToString::to_string);
        let mut events: Vec<_> = run.as_ref().map(|run| run.events.clone()).unwrap_or_default();
        events.reverse();
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

/// Cosine and sine of each phase.
fn phasors(angles: &[Expanded]) -> Result<Vec<Expanded>, Failure> {
    let parts = |angle: &Expanded| angle.sin_cos().map(|(sin, cos)| [cos, sin]);
    let all = angles.iter().map(parts).collect::<Result<Vec<_>, _>>();
    Ok(all.map_err(|error| Failure::open(error.to_string(), None))?.concat())
}

/// The tube of a fixed network up to where two particles may pass the radius: until then it is that of the network within the radius.
fn while_linked(mut tube: Tube, network: &Neighbours, square: &Rational) -> Tube {
    const HALVINGS: usize = 12;
    let agents = network.particles();
    let square = point(square);
    let until = |section: &Section, to: f64| {
        let after = FloatInterval::point(to) - FloatInterval::point(section.from);
        let state = match &section.states {
            States::Step(step) => step.expanded(FloatInterval::between(0.0, after.hi().min(step.span.hi()))),
            States::Box(states) => Expanded::of_box(states),
        };
        let apart = |i: usize, j: usize| (state[i].clone() - &state[j]).square();
        let distance = |i: usize, j: usize| (apart(2 * i, 2 * j) + apart(2 * i + 1, 2 * j + 1)).range();
        let passes = |&(i, j): &Pair| match network.of_particle(i).contains(&j) {
            true => distance(i, j).hi() >= square.lo(),
            false => distance(i, j).lo() < square.hi(),
        };
        (0..agents).flat_map(|j| (0..j).map(move |i| (i, j))).find(passes)
    };
    let first = tube.sections.iter().enumerate().find_map(|(k, section)| Some((k, until(section, section.to)?)));
    let Some((place, pair)) = first else { return tube };
    tube.sections.truncate(place + 1);
    // As much of the step as is certain.
    let mut end = tube.sections.first().map_or(0.0, |section| section.from);
    if let Some(section) = tube.sections.last_mut() {
        end = section.from;
        let mut beyond = section.to;
        for _ in 0..HALVINGS {
            let middle = f64::midpoint(end, beyond);
            if until(section, middle).is_none() { end = middle } else { beyond = middle }
        }
        section.to = end;
    }
    tube.sections.retain(|section| section.from < section.to);
    let (i, j) = (pair.0 + 1, pair.1 + 1);
    tube.failure = Some(format!("particles {i} and {j} may pass the radius after t = {}", clock(end)));
    tube
}

impl Timeline for MotionSubject<'_> {
    fn pieces(&self, from: &Rational, to: Option<&Rational>, _: &[&str]) -> Result<Covered, Failure> {
        let Some(to) = to else {
            return Err(Failure::Refused(0, Problem::Unbounded));
        };
        // At the start everything is known exactly.
        let start = from.is_zero().then(|| Piece { from: from.clone(), to: Some(from.clone()) });
        if self.modal().is_some() {
            let pieces = start.into_iter().chain(equal_parts(from, to)).collect();
            return Ok(Covered { pieces, rest: None });
        }
        let tube = self.tube(point(to).hi())?;
        let exact = |x: f64| Rational::from_float(x).unwrap_or_else(|| rational(0, 1));
        let mut pieces: Vec<Piece> = start.into_iter().filter(|_| !tube.sections.is_empty()).collect();
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
            Some(Doubt { why: format!("the motion is enclosed only up to t = {}: {why}", clock(end)), bits: None })
        };
        Ok(Covered { pieces, rest })
    }

    fn moment<'t>(&'t self, piece: &Piece) -> Result<Box<dyn Moment + 't>, Failure> {
        let last = piece.to.as_ref().unwrap_or(&piece.from);
        if let Some(platoon) = self.modal() {
            self.progress.checkpoint()?;
            let state = platoon.states(&piece.from, last)?;
            return Ok(Box::new(At {
                subject: self,
                motion: &self.motion,
                holds: self.holds(piece),
                state: Expanded::of_box(&state),
                pairs: None,
            }));
        }
        let (state, pairs) = self.enclosed_at(piece)?;
        let holds = self.holds(piece);
        Ok(Box::new(At { subject: self, motion: &self.motion, holds, state, pairs }))
    }

    fn has_instants(&self) -> bool {
        self.closed().is_some()
    }

    fn without_instants(&self) -> &'static str {
        match &self.motion {
            _ if !self.wide.is_empty() => "it is about all starts of a box, which have no closed form together",
            ExactMotion::Velocities { radius: Some(_), .. } | ExactMotion::Particles { radius: Some(_), .. } => {
                SWITCHED
            }
            ExactMotion::Own(own) if own.radius().is_some() => SWITCHED,
            _ => "the motion has no closed form with rational exponents and frequencies",
        }
    }

    fn instants<'t>(&'t self, piece: &Piece, precision: u32) -> Vec<(Piece, Box<dyn Moment + 't>)> {
        let Some((to, closed)) = piece.to.as_ref().zip(self.closed()) else { return Vec::new() };
        let states = closed.states(&piece.from, to, precision).into_iter();
        let instants = states.map(|(from, to, state)| {
            let times = Piece { from, to: Some(to) };
            let at = At { subject: self, motion: &self.motion, holds: self.holds(&times), state, pairs: None };
            (times, Box::new(at) as Box<dyn Moment>)
        });
        instants.collect()
    }

    fn field<'t>(&'t self, piece: &Piece) -> Option<Box<dyn Field + 't>> {
        Some(Box::new(self.on_states(piece)?))
    }

    fn curve<'t>(&'t self, piece: &Piece, precision: u32) -> Option<Box<dyn Curve + 't>> {
        let (state, range) = self.closed()?.curve(&piece.from, piece.to.as_ref()?, precision)?;
        let at = At { subject: self, motion: &self.motion, holds: self.holds(piece), state, pairs: None };
        Some(Box::new(OnCurve { at, range }))
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
        if self.modal().is_some() {
            return Ok(());
        }
        self.tube(point(until).hi()).map(|_| ())
    }

    fn inside(&self, from: Rational, to: Option<Rational>) -> (Rational, Option<Rational>) {
        (from, to)
    }
}

/// A stretch of time in equal parts of at most a quarter, as long as these are not too many.
fn equal_parts(from: &Rational, to: &Rational) -> Vec<Piece> {
    const MOST: i64 = 4096;
    let count = ((to - from) * rational(4, 1)).ceil().to_i64().unwrap_or(MOST).clamp(1, MOST);
    let at = |k: i64| from + (to - from) * rational(k, count);
    (0..count).map(|k| Piece { from: at(k), to: Some(at(k + 1)) }).collect()
}
