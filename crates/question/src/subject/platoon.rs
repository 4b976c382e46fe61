//! Platoons: the peak over a whole box of gains, amplitudes at a frequency, stability.
//!
//! On every communication graph the peak depends on the gains through `b = g²/|f|` alone and does not increase in `b`
//! (`notes/questions.md`). Its range over a box of gains is therefore that between two corners. On a line it grows with the number of
//! followers (there, too), so that a range of numbers of followers adds one more side to the box.

use crate::bindings::{Bindings, Value};
use crate::error::Problem;
use crate::failure::Failure;
use crate::timeline::Measured;
use algebra::graph::AnyGraph;
use algebra::matrix::{RationalMatrix, SparseMatrix};
use algebra::spectrum::{Polynomial, matrix_spectrum};
use arithmetic::RealNumber as Number;
use arithmetic::{
    ArithmeticError, Complex, Dyadic, Enclosure, Field, Interval, Number as _, Progress, Rational, Ring, Series, Sign,
    Signed, rational, shown,
};
use models::platoon::vector_form::motion_matrix;
use models::platoon::{
    Communication, CommunicationGraph, Gains, Line, LineError, MOST_FOLLOWERS_PROVED, Parameter, PeakError, Platoon,
    Resonance, ResonanceError, SIGNS, amplitude_one_sided, amplitude_two_sided, gain_squared_one_sided,
    peak_of_platoon, resonance, slowest_rate, strongest_one_sided_square,
};
use motion::sets::Range;
use num_traits::ToPrimitive;

/// A platoon of a case.
pub(crate) struct PlatoonSubject<'p> {
    /// The fewest and the most followers.
    followers: (u64, u64),
    communication: Communication,
    /// Another communication graph; vertex 1 is the leader.
    graph: Option<CommunicationGraph>,
    /// Cars that differ, or track velocities in another way than positions; then `f` and `g` say nothing.
    own: Option<Platoon<Rational>>,
    /// Of gains or weights that are intervals in a way that no response is enclosed over: only what is said of them as a whole.
    wide: Option<Wide>,
    f: (Rational, Rational),
    g: (Rational, Rational),
    progress: &'p dyn Progress,
}

/// A platoon over intervals of weights, or over intervals of gains where cars differ.
struct Wide {
    /// What is an interval, in words.
    what: &'static str,
    /// Whether all modes obey `z² = lambda (f + g z)` with `lambda > 0`, wherever in the intervals.
    real_modes: bool,
}

/// Bits of an abscissa on a graph: each of them costs a test of all roots.
const MOST_BITS: u32 = 64;

/// Digits of the eigenvalues of a graph whose modes are enclosed over a box of gains.
const DIGITS: u32 = 20;

/// Most followers whose response is solved on a graph.
const MOST_ON_GRAPH: usize = MOST_FOLLOWERS_PROVED;

fn refused(message: impl Into<String>) -> Failure {
    Failure::Refused(0, Problem::Other(message.into()))
}

fn open(error: &ArithmeticError) -> Failure {
    Failure::open(format!("the platoon could not be enclosed: {error}"), Some(u64::MAX))
}

impl<'p> PlatoonSubject<'p> {
    /// The platoon with the names `f`, `g` and `followers`, or the first graph.
    pub fn new(bindings: &Bindings, communication: Communication, progress: &'p dyn Progress) -> Result<Self, Failure> {
        let parameters = Parameter::NAMES.iter();
        let is_each = |name: &str| matches!(bindings.get(name), Some(Value::Each(_)));
        let mut said = parameters.filter(|(name, _)| bindings.get(name).is_some());
        if said.any(|(name, parameter)| parameter.is_of_a_side() || is_each(name)) {
            return PlatoonSubject::of_different(bindings, communication, progress);
        }
        let interval = |name: &str| match bindings.get(name) {
            Some(Value::Number(q)) => Ok((q.clone(), q.clone())),
            Some(Value::Box(Range { lo, hi })) => Ok((lo.clone(), hi.clone())),
            _ => Err(refused(format!("`{name}` must be a number or an interval"))),
        };
        let (f, g) = (interval("f")?, interval("g")?);
        if let Some(value) = bindings.get("followers") {
            let not_integer =
                |found: String| Failure::Refused(0, Problem::NotInteger { what: "`followers`".to_string(), found });
            let (least, most) = match value {
                Value::Number(q) if q.is_integer() => (q.clone(), q.clone()),
                Value::Integers(from, to) => (rational(*from, 1), rational(*to, 1)),
                _ => return Err(not_integer(shown(&value.text()))),
            };
            let count = |q: &Rational| {
                let found = q.to_u64().filter(|m| (1..=models::platoon::LARGEST_FOLLOWERS).contains(m));
                let range = || Problem::Range {
                    what: "`followers`".to_string(),
                    expected: format!("between 1 and {}", models::platoon::LARGEST_FOLLOWERS),
                    found: shown(&q.to_string()),
                };
                found.ok_or_else(|| Failure::Refused(0, range()))
            };
            let followers = (count(&least)?, count(&most)?);
            return Ok(PlatoonSubject { followers, communication, graph: None, own: None, wide: None, f, g, progress });
        }
        let graph = graph_of(bindings)?.ok_or_else(|| refused("a platoon needs `followers` or a graph"))?;
        let followers = graph.followers() as u64;
        Ok(PlatoonSubject {
            followers: (followers, followers),
            communication,
            graph: Some(graph),
            own: None,
            wide: None,
            f,
            g,
            progress,
        })
    }

    /// The platoon whose cars have weights ahead and behind, or gains of each.
    fn of_different(
        bindings: &Bindings,
        communication: Communication,
        progress: &'p dyn Progress,
    ) -> Result<Self, Failure> {
        let mut line = Line::default();
        let (mut f, mut g) = (None, None);
        let mut weights: Vec<(Parameter, [Rational; 2])> = Vec::new();
        for (name, parameter) in Parameter::NAMES {
            let ends = match bindings.get(name) {
                None => continue,
                Some(Value::Each(list)) => {
                    line = line.with(parameter, list.to_vec());
                    continue;
                }
                Some(Value::Number(q)) => (q.clone(), q.clone()),
                Some(Value::Box(Range { lo, hi })) => (lo.clone(), hi.clone()),
                Some(_) => {
                    let why = "a number, an interval, or a number for each follower: each:3/5,1/2,1";
                    return Err(refused(format!("`{name}` must be {why}")));
                }
            };
            line = line.with(parameter, vec![ends.0.clone()]);
            match parameter {
                Parameter::F => f = Some(ends),
                Parameter::G => g = Some(ends),
                _ if ends.0 != ends.1 => weights.push((parameter, [ends.0, ends.1])),
                _ => {}
            }
        }
        let told = |error: LineError| refused(error.told(|parameter| format!("`{}`", parameter.name())));
        let built = |line: &Line| match (bindings.get("followers"), communication) {
            (None, _) => {
                let graph = graph_of(bindings)?.ok_or_else(|| refused("a platoon needs `followers` or a graph"))?;
                line.on(graph).map_err(told)
            }
            (Some(Value::Number(q)), communication) => {
                let count = q.is_integer().then(|| q.to_usize()).flatten();
                let count = count.filter(|m| (1..=MOST_ON_GRAPH).contains(m)).ok_or_else(|| {
                    refused(format!(
                        "`followers` with weights or gains of each car is an integer from 1 to {MOST_ON_GRAPH}"
                    ))
                })?;
                match communication {
                    Communication::FrontAndBack => line.platoon(count).map_err(told),
                    Communication::Front => {
                        let graph = CommunicationGraph::of(communication, count).map_err(|error| told(error.into()))?;
                        line.on(graph).map_err(told)
                    }
                }
            }
            _ => Err(refused("`followers` with weights or gains of each car is a single integer")),
        };
        // The graph does not depend on the gains, which may be intervals, or of any sign.
        let one = || vec![rational(-1, 1)];
        let whole = f.is_some() && g.is_some();
        let is_interval = |ends: &Option<(Rational, Rational)>| ends.as_ref().is_some_and(|(lo, hi)| lo != hi);
        let wide_gains = is_interval(&f) || is_interval(&g);
        let unit = if whole { line.clone().with(Parameter::F, one()).with(Parameter::G, one()) } else { line.clone() };
        let negative = || (rational(-1, 1), rational(-1, 1));
        let ends = (f.unwrap_or_else(negative), g.unwrap_or_else(negative));
        let subject = |followers: usize| {
            let (followers, (f, g)) = ((followers as u64, followers as u64), ends.clone());
            PlatoonSubject { followers, communication, graph: None, own: None, wide: None, f, g, progress }
        };
        if !weights.is_empty() {
            let corners = corners(&unit, &weights).iter().map(&built).collect::<Result<Vec<_>, _>>()?;
            let followers = corners.first().map_or(0, Platoon::followers);
            let wide = Wide { what: "intervals of weights", real_modes: whole && corners.iter().all(has_real_modes) };
            return Ok(PlatoonSubject { wide: Some(wide), ..subject(followers) });
        }
        if whole {
            let platoon = built(&unit)?;
            if let Some(graph) = platoon.one_graph() {
                return Ok(PlatoonSubject { graph: Some(graph.clone()), ..subject(platoon.followers()) });
            }
        }
        if wide_gains {
            let what =
                "intervals of gains, where cars have gains of their own or velocities other weights than positions,";
            let wide = Wide { what, real_modes: false };
            return Ok(PlatoonSubject { wide: Some(wide), ..subject(built(&line)?.followers()) });
        }
        let platoon = built(&line)?;
        let (f, g, followers) = (negative(), negative(), platoon.followers());
        Ok(PlatoonSubject { f, g, own: Some(platoon), ..subject(followers) })
    }

    /// Whether a quantity is enclosed for no box of gains or weights, however small.
    pub fn is_of_points_only(&self, name: &str) -> bool {
        match &self.wide {
            Some(wide) => name != "stable" || !wide.real_modes,
            None => {
                self.is_box()
                    && (name == "peak_frequency"
                        || name == "abscissa" && self.graph.is_none() && self.both_negative() == Some(false))
            }
        }
    }

    /// Whether gains are intervals.
    fn is_box(&self) -> bool {
        self.f.0 != self.f.1 || self.g.0 != self.g.1
    }

    /// Whether there are several numbers of followers, on a line.
    fn is_range(&self) -> bool {
        self.followers.0 != self.followers.1
    }

    fn gains(&self, precision: u32) -> Gains<Interval> {
        let hull = |(lo, hi): &(Rational, Rational)| Interval::hull_of_rationals(lo, hi, precision);
        Gains { f: hull(&self.f), g: hull(&self.g) }
    }

    /// A quantity by its name.
    pub fn measure(&self, name: &str, arguments: &[Number], precision: u32) -> Result<Measured, Failure> {
        if let Some(wide) = &self.wide {
            if name == "stable" && wide.real_modes {
                return self.stable();
            }
            let what = wide.what;
            return Err(Failure::open(
                format!("over {what} `{name}` is known at single numbers only, as in a list in [for]"),
                None,
            ));
        }
        match name {
            "stable" => self.stable(),
            "peak" => self.peak(precision).map(|(_, peak)| Measured::Number(Number::interval(peak))),
            "peak_frequency" if self.is_box() => {
                Err(Failure::open("the frequency of the peak is enclosed for single gains only", None))
            }
            "peak_frequency" if self.is_range() && self.communication == Communication::FrontAndBack => {
                Err(Failure::open("the frequency of the peak is enclosed for single numbers of followers only", None))
            }
            "peak_frequency" => self.peak(precision).map(|(w, _)| Measured::Number(Number::interval(w))),
            "gain" => self.gain(arguments, precision).map(|gain| Measured::Number(Number::interval(gain))),
            _ => self.abscissa(precision).map(|x| Measured::Number(Number::interval(x))),
        }
    }

    /// Where both gains are negative; `None` where that differs within the box.
    fn both_negative(&self) -> Option<bool> {
        let sign = |(lo, hi): &(Rational, Rational)| match (lo.sign(), hi.sign()) {
            (_, Some(Sign::Negative)) => Some(true),
            (Some(Sign::Zero | Sign::Positive), _) => Some(false),
            _ => None,
        };
        match (sign(&self.f), sign(&self.g)) {
            (Some(true), Some(true)) => Some(true),
            (Some(false), _) | (_, Some(false)) => Some(false),
            _ => None,
        }
    }

    /// The modes obey `z² = lambda (f + g z)` with `lambda > 0`: stable if and only if both gains are negative (Lemma 1).
    fn stable(&self) -> Result<Measured, Failure> {
        if let Some(own) = &self.own {
            return Ok(Measured::Truth(polynomial(own)?.is_hurwitz_watched(self.progress)?));
        }
        let Some(graph) = &self.graph else {
            let unknown = || Failure::open("both signs of a gain lie in the box", None);
            return self.both_negative().map(Measured::Truth).ok_or_else(unknown);
        };
        // A matrix of weights has a real eigenvalue that is not negative, and its mode is unstable with a gain that is not negative.
        match self.both_negative() {
            None => return Err(Failure::open("both signs of a gain lie in the box", None)),
            Some(false) => return Ok(Measured::Truth(false)),
            Some(true) => {}
        }
        // A mode with eigenvalue p + iq is stable if and only if p > 0 and g²/|f| > q²/(p (p² + q²)): the corners of the box decide.
        let stable = |f: &Rational, g: &Rational| {
            Ok::<bool, Failure>(characteristic(graph, f, g)?.is_hurwitz_watched(self.progress)?)
        };
        if stable(&self.f.0, &self.g.1)? {
            return Ok(Measured::Truth(true));
        }
        if self.is_box() && stable(&self.f.1, &self.g.0)? {
            return Err(Failure::open("some of the gains in the box are stable and some are not", None));
        }
        Ok(Measured::Truth(false))
    }

    /// Frequency and height of the peak; over a box the frequency is that of the higher end.
    fn peak(&self, precision: u32) -> Result<(Interval, Interval), Failure> {
        if let Some(own) = &self.own {
            return self.peak_of_cars(own, precision);
        }
        if let Some(graph) = &self.graph {
            return self.peak_of_graph(graph, precision);
        }
        if self.both_negative() != Some(true) {
            let range = |name: &str| Problem::Range {
                what: format!("`{name}`"),
                expected: format!("negative: only then is the platoon stable and has a peak ({SIGNS})"),
                found: shown(&if name == "f" { &self.f.1 } else { &self.g.1 }.to_string()),
            };
            let name = if self.f.1.is_certainly_negative() { "g" } else { "f" };
            return Err(Failure::Refused(0, range(name)));
        }
        self.between_corners(|gains, followers| self.peak_at(gains, followers, precision))
    }

    /// The peak at the corners of the box with the most followers and the smallest `b` and with the fewest and the largest, between which all others lie.
    fn between_corners(
        &self,
        peak: impl Fn(&Gains<Rational>, u64) -> Result<(Interval, Interval), Failure>,
    ) -> Result<(Interval, Interval), Failure> {
        let (w, most) = peak(&Gains { f: self.f.0.clone(), g: self.g.1.clone() }, self.followers.1)?;
        if !self.is_box() && !self.is_range() {
            return Ok((w, most));
        }
        let (_, least) = peak(&Gains { f: self.f.1.clone(), g: self.g.0.clone() }, self.followers.0)?;
        Ok((w, most.hull(&least)))
    }

    /// The peak of the last car over all frequencies on any graph.
    fn peak_of_graph(&self, graph: &CommunicationGraph, precision: u32) -> Result<(Interval, Interval), Failure> {
        match self.stable()? {
            Measured::Truth(true) => {}
            _ => return Err(Failure::Refused(0, Problem::NotStable)),
        }
        self.between_corners(|gains, _| {
            let cars = vec![gains.clone(); graph.followers()];
            let platoon = Platoon::new(graph.clone(), cars).map_err(|error| refused(error.to_string()))?;
            self.peak_of_cars(&platoon, precision)
        })
    }

    /// The peak of the last car of a platoon with single gains.
    fn peak_of_cars(&self, platoon: &Platoon<Rational>, precision: u32) -> Result<(Interval, Interval), Failure> {
        let digits = ((f64::from(precision) * std::f64::consts::LOG10_2) as u32).max(5);
        let found = peak_of_platoon(platoon, platoon.followers(), digits, self.progress);
        let open = |error: PeakError| match error {
            PeakError::Cancelled(cancelled) => cancelled.into(),
            PeakError::NotStable => Failure::Refused(0, Problem::NotStable),
            other => Failure::open(format!("the peak over all frequencies: {other}"), None),
        };
        let found = found.map_err(open)?;
        let zero = Interval::from_rational(&rational(0, 1), precision);
        Ok((found.omega.unwrap_or(zero), found.amplitude))
    }

    fn peak_at(
        &self,
        gains: &Gains<Rational>,
        followers: u64,
        precision: u32,
    ) -> Result<(Interval, Interval), Failure> {
        let unproved = |error: ResonanceError| refused(error.to_string());
        match self.communication {
            Communication::FrontAndBack => {
                let digits = (f64::from(precision) * std::f64::consts::LOG10_2) as u32;
                let Resonance { omega, amplitude } = resonance(gains, followers, digits.max(5)).map_err(unproved)?;
                Ok((omega, amplitude))
            }
            Communication::Front => {
                let bits = precision + 2 * (u64::BITS - followers.leading_zeros());
                let gains = gains.map(|q| Interval::from_rational(q, bits));
                let found = || -> Result<_, ArithmeticError> {
                    let square = strongest_one_sided_square(&gains)?;
                    let gain = gain_squared_one_sided(&gains, &square)?.sqrt()?;
                    Ok((square.sqrt()?, gain.power(followers)))
                };
                found().map_err(|error| open(&error))
            }
        }
    }

    fn gain(&self, arguments: &[Number], precision: u32) -> Result<Interval, Failure> {
        // Behind the front car alone nobody notices who follows.
        if self.is_range()
            && (self.communication == Communication::FrontAndBack
                || arguments.first().is_some_and(|k| k.as_integer().is_none()))
        {
            return Err(Failure::open("this gain is enclosed for single numbers of followers only", None));
        }
        let followers = self.followers.0;
        let Some(k) = arguments.first().and_then(Number::as_integer) else {
            let found = arguments.first().map_or("nothing".to_string(), Number::text);
            return Err(Failure::Refused(0, Problem::NotInteger { what: "the follower of `gain`".to_string(), found }));
        };
        let range = || Problem::Range {
            what: "the follower of `gain`".to_string(),
            expected: format!("between 1 and {followers}"),
            found: k.to_string(),
        };
        let k = k.to_u64().filter(|k| (1..=followers).contains(k));
        let k = k.ok_or_else(|| Failure::Refused(0, range()))?;
        let bits = precision + 2 * (u64::BITS - followers.leading_zeros()) + 16;
        let w = arguments.get(1).map_or_else(|| Interval::from_rational(&rational(0, 1), bits), |w| w.enclosure(bits));
        let w = w.with_precision(bits);
        let gains = self.gains(bits);
        let amplitude = || -> Result<Complex<Interval>, ArithmeticError> {
            let all = match (&self.graph, &self.own) {
                (Some(graph), _) => Some(graph.response(&gains, &w)?),
                (None, Some(own)) => Some(own.map(|q| w.rational(q)).response(&w)?),
                (None, None) => None,
            };
            if let Some(all) = all {
                return Ok(all.into_iter().nth(k as usize - 1).unwrap_or_else(|| Complex::real(w.zero())));
            }
            match self.communication {
                Communication::Front => amplitude_one_sided(&gains, &w, k),
                Communication::FrontAndBack => amplitude_two_sided(&gains, &w, followers, k),
            }
        };
        let found = amplitude().and_then(|z| z.norm_squared().sqrt());
        let found = found.map_err(|error| open(&error))?;
        Ok(self.near_rest(&gains, &w, k).and_then(|near| near.common(&found)).unwrap_or(found))
    }

    /// The gain at frequencies from 0 on, on a line: `|a_k|²` is even in `w` and 1 at `w = 0`, so that it is `1 + w² c` with its second coefficient `c`
    /// somewhere between 0 and `w`.
    fn near_rest(&self, gains: &Gains<Interval>, w: &Interval, k: u64) -> Option<Interval> {
        let wide = w.contains_zero() && !w.lo().is_negative() && !w.hi().is_zero();
        if self.graph.is_some() || self.own.is_some() || !wide || self.both_negative() != Some(true) {
            return None;
        }
        let one = w.one();
        let series = |c: &Interval| Series::constant(c.clone(), 3);
        let w_series = Series::from_coefficients(w.clone(), [one.clone(), one.zero()]);
        let gains = Gains { f: series(&gains.f), g: series(&gains.g) };
        let amplitude = match self.communication {
            Communication::Front => amplitude_one_sided(&gains, &w_series, k),
            Communication::FrontAndBack => amplitude_two_sided(&gains, &w_series, self.followers.0, k),
        };
        let square = amplitude.ok()?.norm_squared();
        let change = square.coefficients().get(2)?.clone() * w.square();
        // The square is not negative, whatever rounding says.
        let sum = one + change;
        let zero = Dyadic::zero();
        Interval::between(sum.lo().clone().max(zero.clone()), sum.hi().clone().max(zero), sum.precision()).sqrt().ok()
    }

    /// The abscissa over a box of gains: a mode for each eigenvalue of the reduced Laplacian.
    fn abscissa_of_box(&self, graph: &CommunicationGraph, precision: u32) -> Result<Interval, Failure> {
        let gains = self.gains(precision);
        let unclosed = |why: String| Failure::open(format!("the abscissa could not be enclosed: {why}"), None);
        let reduced = graph.reduced_laplacian().map_err(|error| refused(error.to_string()))?;
        let rows = reduced.to_rows();
        let entries =
            rows.into_iter().enumerate().flat_map(|(i, row)| row.into_iter().enumerate().map(move |(j, x)| (i, j, x)));
        let matrix = SparseMatrix::from_entries(reduced.rows(), entries);
        // Where digits cannot be had, what floating point encloses.
        let spectrum = matrix_spectrum(&matrix, Some(DIGITS)).or_else(|_| matrix_spectrum(&matrix, None));
        let spectrum = spectrum.map_err(|error| unclosed(error.to_string()))?;
        let mut largest: Option<Interval> = None;
        for part in &spectrum.eigenvalues {
            let (re, im) = (part.re.with_precision(precision), part.im.with_precision(precision));
            let own = largest_real_part(&re, &im, &gains).map_err(|error| unclosed(error.to_string()))?;
            largest = Some(match largest {
                None => own,
                Some(before) => {
                    let end = |a: &Dyadic, b: &Dyadic| a.max(b).clone();
                    Interval::between(end(before.lo(), own.lo()), end(before.hi(), own.hi()), precision)
                }
            });
        }
        largest.ok_or_else(|| unclosed("there is no follower".to_string()))
    }

    fn abscissa(&self, precision: u32) -> Result<Interval, Failure> {
        if let Some(own) = &self.own {
            let found = polynomial(own)?.abscissa(precision.min(MOST_BITS));
            return found.ok_or_else(|| Failure::open("the abscissa could not be enclosed", None));
        }
        if let Some(graph) = &self.graph {
            if self.is_box() {
                return self.abscissa_of_box(graph, precision + 16);
            }
            let found = characteristic(graph, &self.f.0, &self.g.0)?.abscissa(precision.min(MOST_BITS));
            return found.ok_or_else(|| Failure::open("the abscissa could not be enclosed", None));
        }
        if self.both_negative() != Some(true) {
            return Err(Failure::open("the abscissa is enclosed for negative gains only", None));
        }
        let gains = self.gains(precision + 16);
        let rate = |followers| slowest_rate(&gains, followers).map_err(|error| open(&error));
        Ok(-match self.communication {
            // The slowest rate does not grow with the number of followers.
            Communication::FrontAndBack if self.is_range() => rate(self.followers.0)?.hull(&rate(self.followers.1)?),
            Communication::FrontAndBack => rate(self.followers.0)?,
            // All modes have the eigenvalue 1, as for one follower.
            Communication::Front => rate(1)?,
        })
    }
}

/// That a gain is not negative, and what gains mean, for who takes them for positive.
pub(crate) fn signs(bindings: &Bindings) -> Option<String> {
    let largest = |name: &str| match bindings.get(name)? {
        Value::Number(q) => Some(q.clone()),
        value => value.ends().map(|range| range.hi),
    };
    let wrong = ["f", "g"].into_iter().filter_map(|name| Some((name, largest(name)?)));
    let wrong = wrong.filter(|(_, q)| q.sign() != Some(Sign::Negative));
    let told: Vec<String> = wrong.map(|(name, q)| format!("`{name}` is {}", shown(&q.to_string()))).collect();
    (!told.is_empty()).then(|| format!("{}, not negative: {SIGNS}.", told.join(" and ")))
}

/// The line at each choice of ends of the intervals of weights.
fn corners(line: &Line, weights: &[(Parameter, [Rational; 2])]) -> Vec<Line> {
    weights.iter().fold(vec![line.clone()], |lines, (parameter, ends)| {
        lines.iter().flat_map(|line| ends.iter().map(|q| line.clone().with(*parameter, vec![q.clone()]))).collect()
    })
}

/// Whether the reduced Laplacian has positive eigenvalues only: cars on a line that track positions and velocities alike. It is tridiagonal and no two opposite
/// entries beside the diagonal have different signs, so that its eigenvalues are real, and it is `1 - T` with weights `T` of a spectral radius below 1 where the
/// leader reaches all cars. A share `a/(a + b)` grows in the weight `a` and falls in `b`: where it is positive at all corners of a box of weights, it is in the box.
fn has_real_modes(platoon: &Platoon<Rational>) -> bool {
    let on_a_line = platoon.links().into_iter().all(|(k, agent)| agent.abs_diff(k) == 1);
    on_a_line && platoon.one_graph().is_some() && platoon.reached_by_leader().into_iter().all(|reached| reached)
}

/// The largest real part of the two roots of `z² = lambda (f + g z)`: `(Re(lambda g) + Re sqrt(lambda² g² + 4 lambda f))/2`, where
/// `Re sqrt(w) = sqrt((|w| + Re w)/2)`.
fn largest_real_part(re: &Interval, im: &Interval, gains: &Gains<Interval>) -> Result<Interval, ArithmeticError> {
    let lambda = Complex { re: re.clone(), im: im.clone() };
    let scaled = |z: &Complex<Interval>, by: &Interval| Complex { re: z.re.clone() * by, im: z.im.clone() * by };
    let through = scaled(&lambda, &gains.g);
    let four = re.integer(4);
    let under = through.clone() * &through + scaled(&lambda, &(gains.f.clone() * &four));
    let half = re.integer(2).recip()?;
    let sum = (under.norm_squared().sqrt()? + &under.re) * &half;
    // It is not negative, whatever rounding says.
    let zero = Dyadic::zero();
    let sum = Interval::between(sum.lo().clone().max(zero.clone()), sum.hi().clone().max(zero), sum.precision());
    Ok((through.re + &sum.sqrt()?) * &half)
}

/// Who tracks whom in the first graph that is bound.
fn graph_of(bindings: &Bindings) -> Result<Option<CommunicationGraph>, Failure> {
    let graph = bindings.iter().find_map(|(_, value)| match value {
        Value::Graph(graph) => Some(graph),
        _ => None,
    });
    graph.map(|graph| tracked(graph)).transpose()
}

/// Who tracks whom: the arcs of the graph with their shares, vertex 1 the leader.
fn tracked(graph: &AnyGraph) -> Result<CommunicationGraph, Failure> {
    let weighted = graph.weighted();
    if weighted.order() > MOST_ON_GRAPH + 1 {
        let beyond = "`flockproof resonance --graph` searches the peak of more, without proof";
        return Err(refused(format!("platoons on a graph have at most {MOST_ON_GRAPH} followers; {beyond}")));
    }
    CommunicationGraph::behind(&weighted, 0).map_err(|error| refused(error.to_string()))
}

/// The characteristic polynomial of the motion `y'' = P (f y + g y')`, with the reduced Laplacian `P`.
fn characteristic(graph: &CommunicationGraph, f: &Rational, g: &Rational) -> Result<Polynomial, Failure> {
    let gains = Gains { f: f.clone(), g: g.clone() };
    let motion = graph.reduced_laplacian().and_then(|reduced| motion_matrix(&reduced, &gains));
    motion.and_then(|motion| motion.primitive_characteristic()).map_err(|error| refused(error.to_string()))
}

/// The characteristic polynomial of the motion of a platoon with single gains.
fn polynomial(platoon: &Platoon<Rational>) -> Result<Polynomial, Failure> {
    let motion = platoon.motion_rows().and_then(|rows| RationalMatrix::from_rows(&rows));
    motion.and_then(|motion| motion.primitive_characteristic()).map_err(|error| refused(error.to_string()))
}
