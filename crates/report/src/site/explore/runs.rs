//! The runs behind the motions.

use arithmetic::{Unwatched, rational};
use models::averaging::{Flock, FlockError, Hysteresis, Start, Weights};
use num_traits::ToPrimitive;
use scenario::{ConfigError, Outcome, Scenario};
use std::fmt::Write;

/// Why a motion could not be computed.
#[derive(Debug, thiserror::Error)]
pub enum RunsError {
    /// The exact flock.
    #[error(transparent)]
    Flock(#[from] FlockError),
    /// The scenario.
    #[error(transparent)]
    Scenario(#[from] ConfigError),
}

/// One motion.
pub(super) struct Run {
    pub title: String,
    pub times: Vec<f64>,
    /// For each time the places of the agents.
    points: Vec<Vec<[f64; 2]>>,
    /// For each time directions of motion; none where they are not drawn.
    directions: Vec<Vec<[f64; 2]>>,
    /// For each time the links, agents from 0.
    links: Vec<Vec<(usize, usize)>>,
    /// Whether it is seen from the middle of the agents.
    follow: bool,
    /// Whether one unit is equally long in both directions.
    equal: bool,
    /// How many times before are drawn as a trail.
    trail: usize,
    labels: [&'static str; 2],
}

impl Run {
    /// The motion as JSON for the player.
    pub fn json(&self) -> String {
        let pairs = |list: &[[f64; 2]]| {
            list.iter().map(|[x, y]| format!("{},{}", number(*x), number(*y))).collect::<Vec<_>>().join(",")
        };
        let frames = |list: &[Vec<[f64; 2]>]| {
            list.iter().map(|frame| format!("[{}]", pairs(frame))).collect::<Vec<_>>().join(",\n")
        };
        let mut kinds: Vec<&Vec<(usize, usize)>> = Vec::new();
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
        let mut out = String::from("{");
        // Writing to a string cannot fail.
        let _ = write!(
            out,
            "\"follow\":{},\"equal\":{},\"trail\":{},\"labels\":[\"{}\",\"{}\"],\"kinds\":[{}],\"links\":[{}],\"times\":[{}],\n\"points\":[{}],\n\"directions\":[{}]",
            self.follow,
            self.equal,
            self.trail,
            self.labels[0],
            self.labels[1],
            kinds.join(","),
            which.join(","),
            times.join(","),
            frames(&self.points),
            frames(&self.directions)
        );
        out + "}"
    }
}

/// Four decimals at most.
fn number(x: f64) -> String {
    let text = format!("{x:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_string() } else { text.to_string() }
}

/// The four birds without hysteresis in the upper row, with that of the paper in the lower one.
pub(super) fn four_birds() -> Result<Vec<Run>, RunsError> {
    const STEPS: usize = 340;
    let start = |hysteresis| {
        let positions = [(0, 1), (1, 2), (21, 16), (29, 16)].map(|(p, q)| rational(p, q)).to_vec();
        let velocities = [1, -1, 1, -1].map(|p| rational(p, 8)).to_vec();
        Start::on_the_line(positions, velocities, Weights::Lazy, hysteresis)
    };
    let mut flocks = [Flock::new(&start(Hysteresis::None))?, Flock::new(&start(Hysteresis::Paper))?];
    let mut run = Run {
        title: "without hysteresis (above) and with the hysteresis of the paper (below)".to_string(),
        times: Vec::new(),
        points: Vec::new(),
        directions: Vec::new(),
        links: Vec::new(),
        follow: false,
        equal: false,
        trail: 0,
        labels: ["position", ""],
    };
    for t in 0..=STEPS {
        run.times.push(t as f64);
        let (mut points, mut links) = (Vec::new(), Vec::new());
        for (row, flock) in flocks.iter().enumerate() {
            let place = |bird: &Vec<arithmetic::Rational>| {
                [bird.first().and_then(ToPrimitive::to_f64).unwrap_or(f64::NAN), -(row as f64)]
            };
            let first = points.len();
            points.extend(flock.positions().iter().map(place));
            let network = flock.network();
            let n = network.order();
            links.extend(
                (0..n)
                    .flat_map(|i| (i + 1..n).map(move |j| (i, j)))
                    .filter(|&(i, j)| network.has_edge(i, j))
                    .map(|(i, j)| (first + i, first + j)),
            );
        }
        run.points.push(points);
        run.links.push(links);
        for flock in &mut flocks {
            flock.step()?;
        }
    }
    Ok(vec![run])
}

/// How a run of a scenario is drawn.
struct View {
    title: String,
    /// Links at the start; events change them.
    links: Vec<(usize, usize)>,
    follow: bool,
    trail: usize,
}

fn plane(text: &str, view: View) -> Result<Run, RunsError> {
    let outcome = Scenario::read(text)?.run(&Unwatched);
    let pair = |list: &Vec<f64>| [list.first().copied().unwrap_or(0.0), list.get(1).copied().unwrap_or(0.0)];
    let direction = |row: &scenario::Row| -> Vec<[f64; 2]> {
        if row.frame.phases.is_empty() {
            row.frame.velocities.iter().map(pair).collect()
        } else {
            row.frame.phases.iter().map(|phase| [phase.cos(), phase.sin()]).collect()
        }
    };
    Ok(Run {
        title: view.title,
        times: outcome.rows.iter().map(|row| row.time).collect(),
        points: outcome.rows.iter().map(|row| row.frame.positions.iter().map(pair).collect()).collect(),
        directions: outcome.rows.iter().map(direction).collect(),
        links: outcome.rows.iter().map(|row| links_at(&outcome, &view.links, row.time)).collect(),
        follow: view.follow,
        equal: true,
        trail: view.trail,
        labels: ["x", "y"],
    })
}

/// The links at a time: those of the start, with what came and went.
fn links_at(outcome: &Outcome, start: &[(usize, usize)], time: f64) -> Vec<(usize, usize)> {
    let mut links = start.to_vec();
    for event in outcome.events.iter().filter(|event| event.time <= time) {
        let pair = (event.pair.0 - 1, event.pair.1 - 1);
        links.retain(|link| *link != pair);
        if event.gained {
            links.push(pair);
        }
    }
    links
}

pub(super) fn two_agents() -> Result<Vec<Run>, RunsError> {
    let text = "model = \"heading-alignment\"\n[graph]\nkind = \"complete\"\n[state]\npositions = [[0, 0], [2, 0]]\n\
                velocities = [[2, 0], [2, 0]]\n[law]\npotential = \"inverse-square-log\"\nheading_difference = \"wrapped\"\n\
                [run]\nuntil = 20\nrows = 400\n";
    Ok(vec![plane(text, View { title: "two linked agents".to_string(), links: vec![(0, 1)], follow: true, trail: 0 })?])
}

pub(super) fn turning_triangle() -> Result<Vec<Run>, RunsError> {
    // Radius sqrt(2/3) and speed 1 belong to the squared side 2 and the squared angular velocity 3/2.
    let (radius, third) = ((2f64 / 3.0).sqrt(), std::f64::consts::TAU / 3.0);
    let corner = |k: i32| third * f64::from(k);
    let list = |f: &dyn Fn(f64) -> [f64; 2]| {
        (0..3).map(|k| f(corner(k))).map(|[x, y]| format!("[{x:.17}, {y:.17}]")).collect::<Vec<_>>().join(", ")
    };
    let positions = list(&|angle| [radius * angle.cos(), radius * angle.sin()]);
    let velocities = list(&|angle| [-angle.sin(), angle.cos()]);
    let text = format!(
        "model = \"heading-alignment\"\n[graph]\nkind = \"complete\"\n[state]\npositions = [{positions}]\nvelocities = [{velocities}]\n\
         [law]\npotential = \"inverse-square-log\"\nheading_difference = \"wrapped\"\n[run]\nuntil = 20\nrows = 400\ntolerance = 1e-12\n"
    );
    let view = View {
        title: "three linked agents".to_string(),
        links: vec![(0, 1), (0, 2), (1, 2)],
        follow: false,
        trail: 400,
    };
    Ok(vec![plane(&text, view)?])
}

pub(super) fn split() -> Result<Vec<Run>, RunsError> {
    let text = "model = \"velocity-alignment\"\n[graph]\nkind = \"within\"\nradius = 2\n[state]\n\
                positions = [[0, 0], [1, 0], [\"5/2\", 0]]\nvelocities = [[0, 0], [0, 0], [4, 0]]\n[law]\n\
                potential = \"inverse-square-spring\"\n[run]\nuntil = 2\nrows = 200\n";
    Ok(vec![plane(
        text,
        View {
            title: "three agents, links within 2".to_string(),
            links: vec![(0, 1), (1, 2)],
            follow: false,
            trail: 200,
        },
    )?])
}

pub(super) fn patterns() -> Result<Vec<Run>, RunsError> {
    [2usize, 3, 4, 6, 12]
        .into_iter()
        .map(|clusters| {
            let mut gains = vec!["0.2".to_string(); clusters - 1];
            gains.push("-0.04".to_string());
            let text = format!(
                "model = \"particles\"\n[graph]\nkind = \"all-to-all\"\n[state]\nrandom = {{ agents = 12, seed = 1, half = 10 }}\n\
                 [law]\nomega0 = 0.1\nK0 = 0.1\nK = [{}]\n[run]\nuntil = 500\nrows = 250\n",
                gains.join(", ")
            );
            plane(&text, View { title: format!("{clusters} clusters"), links: Vec::new(), follow: false, trail: 25 })
        })
        .collect()
}

pub(super) fn platoon() -> Result<Vec<Run>, RunsError> {
    const FOLLOWERS: usize = 20;
    let positions: Vec<String> = (0..=FOLLOWERS).map(|k| format!("[-{k}]")).collect();
    let still = vec!["[0]"; FOLLOWERS + 1];
    // The main resonance by Theorem 1, with N + 1 followers.
    let frequency = std::f64::consts::PI / (FOLLOWERS as f64 * 2.0 * std::f64::consts::SQRT_2);
    let text = format!(
        "model = \"platoon\"\n[state]\npositions = [{}]\nvelocities = [{}]\n[law]\nf = -1\ng = -1\nspacing = 1\n\
         leader = {{ amplitude = 1, frequency = {frequency:.12} }}\n[run]\nuntil = 1200\nrows = 600\n",
        positions.join(", "),
        still.join(", ")
    );
    let outcome = Scenario::read(&text)?.run(&Unwatched);
    let deviation = |row: &scenario::Row| -> Vec<[f64; 2]> {
        let cars = row.frame.positions.iter().enumerate();
        cars.map(|(k, x)| [k as f64, x.first().copied().unwrap_or(0.0) + k as f64]).collect()
    };
    let links: Vec<(usize, usize)> = (0..FOLLOWERS).map(|k| (k, k + 1)).collect();
    Ok(vec![Run {
        title: "deviations of all cars".to_string(),
        times: outcome.rows.iter().map(|row| row.time).collect(),
        points: outcome.rows.iter().map(deviation).collect(),
        directions: Vec::new(),
        links: vec![links; outcome.rows.len()],
        follow: false,
        equal: false,
        trail: 0,
        labels: ["car", "deviation"],
    }])
}
