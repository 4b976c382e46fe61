//! A motion that the player of a page shows: frames of agents with links and trails.

use arithmetic::Rational;
use maud::{Markup, PreEscaped, html};
use models::averaging::{Flock, FlockError, Start};
use num_traits::ToPrimitive;
use scenario::{Outcome, Row};
use std::fmt::Write;

/// The program that plays motions.
pub(crate) const PLAYER: &str = include_str!("player.js");

/// Most frames of a motion, and most numbers in all of them.
const FRAMES: usize = 600;
const NUMBERS: usize = 400_000;
/// Most points of a way in a small picture, and most ways.
const MOST_POINTS: usize = 150;
const MOST_WAYS: usize = 24;

/// A pair of agents from 0.
pub(crate) type Link = (usize, usize);

/// One motion.
pub(crate) struct Motion {
    pub title: String,
    pub times: Vec<f64>,
    /// What is said of each time, where it is not `t = ..`.
    pub said: Vec<String>,
    /// For each time the places of the agents.
    pub points: Vec<Vec<[f64; 2]>>,
    /// For each time directions of motion; none where they are not drawn.
    pub directions: Vec<Vec<[f64; 2]>>,
    /// For each time the links, agents from 0.
    pub links: Vec<Vec<Link>>,
    /// Whether it is seen from the middle of the agents.
    pub follow: bool,
    /// Whether one unit is equally long in both directions.
    pub equal: bool,
    /// How many times before are drawn as a trail.
    pub trail: usize,
    pub labels: [&'static str; 2],
}

impl Motion {
    /// A motion without frames.
    pub fn new(title: impl Into<String>, labels: [&'static str; 2]) -> Self {
        Motion {
            title: title.into(),
            times: Vec::new(),
            said: Vec::new(),
            points: Vec::new(),
            directions: Vec::new(),
            links: Vec::new(),
            follow: false,
            equal: false,
            trail: 0,
            labels,
        }
    }

    /// The run of a scenario: paths in the plane, places on the line, or phases on the circle; nothing where there is no row.
    pub fn of_outcome(outcome: &Outcome, title: impl Into<String>) -> Option<Self> {
        let first = outcome.rows.first()?;
        let agents = first.frame.agents();
        let most = FRAMES.min(NUMBERS / agents.max(1)).max(2);
        let every = outcome.rows.len().div_ceil(most).max(1);
        let rows: Vec<&Row> = outcome.rows.iter().step_by(every).collect();
        let pair = |list: &Vec<f64>| [list.first().copied().unwrap_or(0.0), list.get(1).copied().unwrap_or(0.0)];
        let circle = |phase: &f64| [phase.cos(), phase.sin()];
        let dimension = first.frame.positions.first().map_or(0, Vec::len);
        let points = |row: &&Row| match dimension {
            0 => row.frame.phases.iter().map(circle).collect(),
            _ => row.frame.positions.iter().map(pair).collect::<Vec<_>>(),
        };
        let direction = |row: &&Row| -> Vec<[f64; 2]> {
            match (dimension, row.frame.phases.is_empty()) {
                (2, true) => row.frame.velocities.iter().map(pair).collect(),
                (2, false) => row.frame.phases.iter().map(circle).collect(),
                _ => Vec::new(),
            }
        };
        let labels = match dimension {
            0 => ["cos", "sin"],
            1 => ["place", ""],
            _ => ["x", "y"],
        };
        Some(Motion {
            times: rows.iter().map(|row| row.time).collect(),
            points: rows.iter().map(points).collect(),
            directions: rows.iter().map(direction).collect(),
            links: rows.iter().map(|row| row.links.to_vec()).collect(),
            follow: dimension == 2 && agents > 1,
            equal: dimension != 1,
            trail: if dimension == 2 && agents <= 64 { 60 } else { 0 },
            ..Motion::new(title, labels)
        })
    }

    /// An exact flock in the plane or on the line for so many steps, rounded for drawing.
    ///
    /// # Errors
    /// Whatever the flock refuses.
    pub fn of_flock(start: &Start, steps: usize, title: impl Into<String>) -> Result<Self, FlockError> {
        let mut flock = Flock::new(start)?;
        let line = flock.dimension() < 2;
        let mut motion =
            Motion { equal: !line, ..Motion::new(title, if line { ["position", ""] } else { ["x", "y"] }) };
        for t in 0..=steps {
            motion.times.push(t as f64);
            motion.points.push(places(&flock));
            motion.links.push(flock.network().edges());
            flock.step()?;
        }
        Ok(motion)
    }

    /// A further frame.
    pub fn frame(&mut self, said: String, points: Vec<[f64; 2]>, links: Vec<Link>) {
        self.times.push(self.times.len() as f64);
        self.said.push(said);
        self.points.push(points);
        self.links.push(links);
    }

    /// The same agents with those of another motion of the same length in a row below.
    pub fn above(mut self, other: &Motion) -> Self {
        for (frame, below) in self.points.iter_mut().zip(&other.points) {
            frame.extend(below.iter().map(|[x, y]| [*x, y - 1.0]));
        }
        let count = self.points.first().map_or(0, Vec::len) - other.points.first().map_or(0, Vec::len);
        for (links, below) in self.links.iter_mut().zip(&other.links) {
            links.extend(below.iter().map(|(i, j)| (i + count, j + count)));
        }
        self
    }

    /// A small picture of the ways of the first agents, with a dot where each ends; on the line over the time, which runs to the right.
    pub fn thumbnail(&self) -> Markup {
        const SIZE: [f64; 2] = [160.0, 100.0];
        const MARGIN: f64 = 6.0;
        let on_line = self.labels[1].is_empty();
        let every = self.points.len().div_ceil(MOST_POINTS).max(1);
        let frames: Vec<(usize, &Vec<[f64; 2]>)> = self.points.iter().enumerate().step_by(every).collect();
        let agents = frames.iter().map(|(_, points)| points.len()).min().unwrap_or(0).min(MOST_WAYS);
        let seen = |(t, points): &(usize, &Vec<[f64; 2]>), agent: usize| -> [f64; 2] {
            let middle = match self.follow && !on_line {
                true => [0, 1].map(|axis| points.iter().map(|p| p[axis]).sum::<f64>() / points.len() as f64),
                false => [0.0; 2],
            };
            let [x, y] = points[agent];
            if on_line { [*t as f64, x + y] } else { [x - middle[0], y - middle[1]] }
        };
        let ways: Vec<Vec<[f64; 2]>> =
            (0..agents).map(|agent| frames.iter().map(|frame| seen(frame, agent)).collect()).collect();
        let ends = [0, 1].map(|axis| {
            let values = || ways.iter().flatten().map(|point| point[axis]);
            (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max))
        });
        let mut scale = [0, 1].map(|axis| (SIZE[axis] - 2.0 * MARGIN) / (ends[axis].1 - ends[axis].0).max(1e-9));
        if self.equal && !on_line {
            scale = [scale[0].min(scale[1]); 2];
        }
        let place = |point: &[f64; 2]| -> [f64; 2] {
            let at = |axis: usize| (point[axis] - (ends[axis].0 + ends[axis].1) / 2.0) * scale[axis];
            [SIZE[0] / 2.0 + at(0), SIZE[1] / 2.0 - at(1)]
        };
        let path = |way: &Vec<[f64; 2]>| -> String {
            way.iter().map(place).map(|[x, y]| format!("{x:.1},{y:.1}")).collect::<Vec<_>>().join(" ")
        };
        html! {
            svg.thumbnail viewBox={ "0 0 " (SIZE[0]) " " (SIZE[1]) } aria-hidden="true" {
                @for way in &ways { polyline points=(path(way)) {} }
                @for [x, y] in ways.iter().filter_map(|way| way.last()).map(place) {
                    circle cx=(format!("{x:.1}")) cy=(format!("{y:.1}")) r="2" {}
                }
            }
        }
    }

    /// The motion as JSON for the player.
    fn json(&self) -> String {
        let pairs = |list: &[[f64; 2]]| {
            list.iter().map(|[x, y]| format!("{},{}", number(*x), number(*y))).collect::<Vec<_>>().join(",")
        };
        let frames = |list: &[Vec<[f64; 2]>]| {
            list.iter().map(|frame| format!("[{}]", pairs(frame))).collect::<Vec<_>>().join(",\n")
        };
        let mut kinds: Vec<&Vec<Link>> = Vec::new();
        let mut which = Vec::new();
        for links in &self.links {
            let at = kinds.iter().position(|known| *known == links).unwrap_or_else(|| {
                kinds.push(links);
                kinds.len() - 1
            });
            which.push(at.to_string());
        }
        let kinds: Vec<String> = kinds
            .iter()
            .map(|links| format!("[{}]", links.iter().map(|(i, j)| format!("[{i},{j}]")).collect::<Vec<_>>().join(",")))
            .collect();
        let times: Vec<String> = self.times.iter().map(|t| number(*t)).collect();
        let said: Vec<String> =
            self.said.iter().map(|text| serde_json::Value::from(text.as_str()).to_string()).collect();
        let mut out = String::from("{");
        // Writing to a string cannot fail.
        let _ = write!(
            out,
            "\"follow\":{},\"equal\":{},\"trail\":{},\"labels\":[\"{}\",\"{}\"],\"kinds\":[{}],\"links\":[{}],\"times\":[{}],\"said\":[{}],\n\
             \"points\":[{}],\n\"directions\":[{}]",
            self.follow,
            self.equal,
            self.trail,
            self.labels[0],
            self.labels[1],
            kinds.join(","),
            which.join(","),
            times.join(","),
            said.join(",").replace('<', "\\u003c"),
            frames(&self.points),
            frames(&self.directions)
        );
        out + "}"
    }

    /// The place of a page where it is played; `about` is what is to be seen.
    pub fn section(&self, about: &str) -> Markup {
        html! {
            canvas width="736" height="414" role="img" aria-label=(about) {}
            div.controls hidden {
                button.play type="button" { "Play" }
                button.back type="button" aria-label="One step back" { "‹" }
                button.on type="button" aria-label="One step on" { "›" }
                input.time type="range" min="0" max=(self.times.len().saturating_sub(1)) value="0" aria-label="Time";
                output { }
            }
            script type="application/json" { (PreEscaped(self.json())) }
            noscript { p { "The motion is drawn by a small script. Its numbers stand in the source of this page." } }
        }
    }
}

/// Where the birds are, rounded for drawing.
fn places(flock: &Flock) -> Vec<[f64; 2]> {
    let float = |row: &Vec<Rational>, k: usize| row.get(k).map_or(0.0, |x| x.to_f64().unwrap_or(f64::NAN));
    flock.positions().iter().map(|row| [float(row, 0), float(row, 1)]).collect()
}

/// Four decimals at most, and six digits of what is small or large.
fn number(x: f64) -> String {
    match x.abs() {
        _ if !x.is_finite() => return "null".to_string(),
        size if size != 0.0 && !(1e-2..1e7).contains(&size) => return format!("{x:.5e}"),
        _ => {}
    }
    let text = format!("{x:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_string() } else { text.to_string() }
}
