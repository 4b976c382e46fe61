//! Schools made by a rule, for tests, examples and figures: what the analysis should find is known.

use super::read::{Frame, Tracks};
use super::{BridgeShape, Choices, Vector};
use crate::oscillator::{State, Zone, alignment, attraction, repulsion, steering_towards};
use arithmetic::Complex;
use arithmetic::random::{generator, normal, uniform};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::TAU;

/// Speed in body lengths per second.
const SPEED: f64 = 2.0;
/// Half the width of the tank in body lengths: 1 m for 5.3 cm.
const HALF_TANK: f64 = 9.4;

/// How the fish of a synthetic school move. Lengths in body lengths; all swim at 2 body lengths per second.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum School {
    /// A formation with spacing 1.8 that is carried along a circle without turning: all headings agree.
    Polarised,
    /// All on one circle, evenly spaced, 1.9 apart (radius at least 2.5): the headings balance.
    Milling,
    /// The same on a circle of radius 7: the zones are empty.
    DiffuseMilling,
    /// Random walks in a tank, each fish for itself.
    Independent,
    /// The fish model (26), (27) in a tank: repulsion, orientation and attraction in the zones of the sidebar, and noise.
    Coupled,
}

impl School {
    /// Every kind with its name.
    pub const ALL: [(&'static str, School); 5] = [
        ("polarised", School::Polarised),
        ("milling", School::Milling),
        ("diffuse-milling", School::DiffuseMilling),
        ("independent", School::Independent),
        ("coupled", School::Coupled),
    ];
}

/// The size of a synthetic recording.
#[derive(Debug, Clone, PartialEq)]
pub struct Setting {
    /// Number of fish.
    pub fish: usize,
    /// Number of frames.
    pub frames: usize,
    /// Frame step in seconds.
    pub step: f64,
    /// Body length: the unit of all lengths.
    pub body_length: f64,
    /// Seed of the random motion.
    pub seed: String,
}

/// A number that wanders around 0 with this standard deviation and correlation time (Ornstein and Uhlenbeck).
#[derive(Clone)]
struct Wander {
    value: f64,
    deviation: f64,
    time: f64,
}

impl Wander {
    fn new(deviation: f64, time: f64) -> Self {
        Wander { value: 0.0, deviation, time }
    }

    fn advance(&mut self, step: f64, random: &mut ChaCha8Rng) -> f64 {
        let kept = (-step / self.time).exp();
        self.value = kept * self.value + self.deviation * (1.0 - kept * kept).sqrt() * normal(random);
        self.value
    }
}

/// Makes a recording. Without fish or frames it is empty.
pub fn synthetic_school(school: School, setting: &Setting) -> Tracks {
    let mut random = generator(&setting.seed, "tracks.synthetic", 0);
    let places = match school {
        School::Polarised => polarised(setting, &mut random),
        School::Milling => {
            let spacing = 1.9 / (2.0 * (TAU / 2.0 / setting.fish as f64).sin());
            mill(setting, spacing.max(2.5), &mut random)
        }
        School::DiffuseMilling => mill(setting, 7.0, &mut random),
        School::Independent => in_a_tank(setting, |_, _| 0.0, 0.8, &mut random),
        School::Coupled => {
            let choices = Choices { body_length: 1.0, zones: [1.4, 2.4, 8.0], ..Choices::of_sidebar(setting.step) };
            let zones = choices.zones();
            let steering = |state: &State<f64>, k: usize| {
                let sensed = |zone: Zone| -> Vec<usize> {
                    let offset = |j: usize| state.positions[j].clone() - &state.positions[k];
                    (0..setting.fish).filter(|&j| j != k && zones.senses(zone, &state.phasors[k], &offset(j))).collect()
                };
                coupled(state, k, &sensed)
            };
            in_a_tank(setting, steering, 0.5, &mut random)
        }
    };
    let scaled = |k: usize| places.iter().map(|frame| Some(frame[k].scale(&setting.body_length))).collect();
    Tracks {
        ids: (1..=setting.fish).map(|k| k.to_string()).collect(),
        // Three more decimals than the step needs would only lengthen the file.
        frames: (0..setting.frames)
            .map(|i| Frame { number: i as u64, time: (i as f64 * setting.step * 1e6).round() / 1e6 })
            .collect(),
        step: setting.step,
        positions: (0..setting.fish).map(scaled).collect(),
        form: super::Form::Rows,
        parts: vec![],
        bridged: vec![],
        bridged_by: BridgeShape::Line,
        start: None,
    }
}

/// The points of all frames, `[frame][fish]`, in body lengths.
type Places = Vec<Vec<Vector>>;

fn on_circle(radius: f64, angle: f64) -> Vector {
    let (sin, cos) = angle.sin_cos();
    Complex::new(radius * cos, radius * sin)
}

fn polarised(setting: &Setting, random: &mut ChaCha8Rng) -> Places {
    const RADIUS: f64 = 5.0;
    let side = (1..).find(|side| side * side >= setting.fish).unwrap_or(1);
    let mut wander = vec![[Wander::new(0.15, 3.0), Wander::new(0.15, 3.0)]; setting.fish];
    let frame = |i: usize| {
        let centre = on_circle(RADIUS, SPEED * i as f64 * setting.step / RADIUS);
        let fish = wander.iter_mut().enumerate().map(|(k, [x, y])| {
            let place = |n: usize| 1.8 * (n as f64 - (side - 1) as f64 / 2.0);
            let (x, y) = (x.advance(setting.step, random), y.advance(setting.step, random));
            // Every second row is moved, so that no two distances are equal by construction.
            let shifted = 0.3 * (k / side % 2) as f64;
            centre.clone() + Complex::new(place(k % side) + shifted + x, place(k / side) + y)
        });
        fish.collect()
    };
    (0..setting.frames).map(frame).collect()
}

fn mill(setting: &Setting, radius: f64, random: &mut ChaCha8Rng) -> Places {
    let mut wander = vec![(Wander::new(0.2, 4.0), Wander::new(0.25, 4.0)); setting.fish];
    let frame = |i: usize| {
        let turn = SPEED * i as f64 * setting.step / radius;
        let fish = wander.iter_mut().enumerate().map(|(k, (out, along))| {
            let even = TAU * k as f64 / setting.fish as f64;
            on_circle(radius + out.advance(setting.step, random), turn + even + along.advance(setting.step, random))
        });
        fish.collect()
    };
    (0..setting.frames).map(frame).collect()
}

/// Fish that start anywhere in a tank and are steered, turned by noise and reflected by the walls. The noise is in radians per
/// square root of a second.
fn in_a_tank(
    setting: &Setting,
    steering: impl Fn(&State<f64>, usize) -> f64,
    noise: f64,
    random: &mut ChaCha8Rng,
) -> Places {
    let anywhere = |random: &mut ChaCha8Rng| HALF_TANK * (2.0 * uniform(random) - 1.0);
    let mut state = State {
        positions: (0..setting.fish).map(|_| Complex::new(anywhere(random), anywhere(random))).collect(),
        phasors: (0..setting.fish).map(|_| on_circle(1.0, TAU * uniform(random))).collect(),
    };
    let mut places = Vec::with_capacity(setting.frames);
    for _ in 0..setting.frames {
        places.push(state.positions.clone());
        let turns: Vec<f64> = (0..setting.fish)
            .map(|k| steering(&state, k) * setting.step + noise * setting.step.sqrt() * normal(random))
            .collect();
        for ((r, z), turn) in state.positions.iter_mut().zip(&mut state.phasors).zip(turns) {
            *r = z.scale(&(SPEED * setting.step)) + &*r;
            *z = z.clone() * on_circle(1.0, turn);
            for (x, direction) in [(&mut r.re, &mut z.re), (&mut r.im, &mut z.im)] {
                if x.abs() > HALF_TANK {
                    *x = x.signum() * HALF_TANK;
                    *direction = -x.signum() * direction.abs();
                }
            }
        }
    }
    places
}

/// The steering (27) with the directions of repulsion, orientation and attraction as unit vectors, and a turn away from the walls.
fn coupled(state: &State<f64>, k: usize, sensed: &dyn Fn(Zone) -> Vec<usize>) -> f64 {
    let (heading, place) = (&state.phasors[k], &state.positions[k]);
    let unit = |v: Vector| {
        let length = v.norm_squared().sqrt();
        if length > 0.0 { v.scale(&(1.0 / length)) } else { v }
    };
    let away = |zone: Zone| -> Vec<Vector> {
        sensed(zone).into_iter().map(|j| unit(place.clone() - &state.positions[j])).collect()
    };
    let headings: Vec<Vector> = sensed(Zone::Orientation).into_iter().map(|j| state.phasors[j].clone()).collect();
    let mut desired = vec![
        (2.0, unit(repulsion(heading, &away(Zone::Repulsion)))),
        (2.0, unit(alignment(heading, &headings))),
        (0.7, unit(attraction(heading, &away(Zone::Attraction)))),
    ];
    if place.re.abs().max(place.im.abs()) > HALF_TANK - 2.0 {
        desired.push((2.0, unit(-place.clone())));
    }
    desired.iter().map(|(gain, direction)| gain * steering_towards(heading, direction)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The deviation, and what is left of a value after a step, from 40000 steps: both are known to 2%.
    #[test]
    fn numbers_wander_with_their_deviation_and_time() {
        let mut random = generator("test", "wander", 0);
        for (deviation, time, step) in [(0.5, 2.0, 1.0), (3.0, 0.5, 1.0), (1.0, 1.0, 0.5)] {
            let mut wander = Wander::new(deviation, time);
            let values: Vec<f64> = (0..40_000).map(|_| wander.advance(step, &mut random)).collect();
            let squares = values.iter().map(|x| x * x).sum::<f64>() / 40_000.0;
            let products = values.windows(2).map(|two| two[0] * two[1]).sum::<f64>() / 40_000.0;
            assert!((squares / (deviation * deviation) - 1.0).abs() < 0.1, "{squares}");
            assert!((products / squares - f64::exp(-step / time)).abs() < 0.05, "{products} {squares}");
        }
    }

    /// The steering of a fish that heads north, by what it senses in the zones of repulsion, orientation and attraction.
    fn steered(place: [f64; 2], others: &[([f64; 2], [f64; 2])], zone: Option<Zone>) -> f64 {
        let point = |[x, y]: [f64; 2]| Complex::new(x, y);
        let state = State {
            positions: [point(place)]
                .into_iter()
                .chain(others.iter().map(|(r, _)| point(place) + &point(*r)))
                .collect(),
            phasors: [point([0.0, 1.0])].into_iter().chain(others.iter().map(|(_, z)| point(*z))).collect(),
        };
        let sensed = |of: Zone| if Some(of) == zone { (1..=others.len()).collect() } else { Vec::new() };
        coupled(&state, 0, &sensed)
    }

    /// By hand: turns to the left are positive. Only directions count, not distances.
    #[test]
    fn fish_turn_away_along_and_towards() {
        let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-12, "{a} {b}");
        let (middle, north, west) = ([0.5, -0.25], [0.0, 1.0], [-1.0, 0.0]);
        near(steered(middle, &[], None), 0.0);
        let one = |zone: Zone, offset: [f64; 2]| steered(middle, &[(offset, north)], Some(zone));
        let (away, towards) = (one(Zone::Repulsion, [1.0, 0.0]), one(Zone::Attraction, [-4.0, 0.0]));
        assert!(away > 0.0 && towards > 0.0);
        near(one(Zone::Repulsion, [0.25, 0.0]), away);
        near(one(Zone::Repulsion, [-0.25, 0.0]), -away);
        near(one(Zone::Repulsion, [0.0, 0.5]), 0.0);
        near(one(Zone::Repulsion, [0.3, 0.4]), 0.6 * away);
        near(one(Zone::Attraction, [-0.5, 0.0]), towards);
        near(one(Zone::Attraction, [4.0, 0.0]), -towards);
        near(one(Zone::Attraction, [-3.0, 4.0]), 0.6 * towards);
        // Two on both sides, at any distances.
        near(steered(middle, &[([0.5, 0.0], north), ([-0.9, 0.0], north)], Some(Zone::Repulsion)), 0.0);
        // The mean direction of itself and one, then two fish that swim to the west.
        let along = |count: usize| steered(middle, &vec![([2.0, 0.0], west); count], Some(Zone::Orientation));
        assert!(along(1) > 0.0);
        near(along(2) / along(1), (2.0 / 5f64.sqrt()) / 0.5f64.sqrt());
        near(one(Zone::Orientation, [2.0, 0.0]), 0.0);
    }

    /// Near a wall, and only there, a fish turns to the middle of the tank.
    #[test]
    fn fish_turn_from_the_walls() {
        let alone = |x: f64, y: f64| steered([x, y], &[], None);
        let wall = alone(9.0, 0.0);
        assert!(wall > 0.0);
        for (x, y, share) in [
            (8.0, 0.0, 1.0),
            (-8.0, 0.0, -1.0),
            (-9.0, 0.0, -1.0),
            (0.0, 9.0, 0.0),
            (6.0, 8.0, 0.6),
            (6.0, -8.0, 0.6),
            (-6.0, 8.0, -0.6),
            (8.0, 6.0, 0.8),
            (7.0, 0.0, 0.0),
            (7.0, 7.0, 0.0),
            (-7.0, -7.0, 0.0),
        ] {
            assert!((alone(x, y) - share * wall).abs() < 1e-12, "{x} {y}");
        }
    }
}
