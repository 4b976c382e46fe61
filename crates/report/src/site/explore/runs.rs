//! The runs behind the motions.

use crate::page::player::Motion;
use algebra::matrix::MatrixError;
use arithmetic::{Rational, Unwatched, rational};
use models::averaging::settle::{Ending, Limits, SettleError, settle};
use models::averaging::{Flock, FlockError, Hysteresis, Start, Weights, stationary_distribution};
use num_traits::ToPrimitive;
use scenario::{ConfigError, Outcome, Scenario};

/// Why a motion could not be computed.
#[derive(Debug, thiserror::Error)]
pub enum RunsError {
    /// The exact flock.
    #[error(transparent)]
    Flock(#[from] FlockError),
    /// What becomes of it.
    #[error(transparent)]
    Settle(#[from] SettleError),
    /// The mean velocity of a flock.
    #[error(transparent)]
    Matrix(#[from] MatrixError),
    /// The case that a live page shows.
    #[error("{0}")]
    Case(String),
    /// The scenario.
    #[error(transparent)]
    Scenario(#[from] ConfigError),
}

type Runs = Result<Vec<Motion>, RunsError>;

/// The four birds without hysteresis in the upper row, with that of the paper in the lower one.
pub(super) fn four_birds() -> Runs {
    const STEPS: usize = 340;
    let flock = |hysteresis| {
        let positions = [(0, 1), (1, 2), (21, 16), (29, 16)].map(|(p, q)| rational(p, q)).to_vec();
        let velocities = [1, -1, 1, -1].map(|p| rational(p, 8)).to_vec();
        let title = "without hysteresis (above) and with the hysteresis of the paper (below)";
        Motion::of_flock(&Start::on_the_line(positions, velocities, Weights::Lazy, hysteresis), STEPS, title)
    };
    Ok(vec![flock(Hysteresis::None)?.above(&flock(Hysteresis::Paper)?)])
}

fn run(text: &str) -> Result<Outcome, RunsError> {
    Ok(Scenario::read(text)?.run(&Unwatched))
}

/// A run in the plane.
fn plane(text: &str, title: &str) -> Result<Motion, RunsError> {
    let motion = Motion::of_outcome(&run(text)?, title).unwrap_or_else(|| Motion::new(title, ["x", "y"]));
    Ok(Motion { follow: false, ..motion })
}

pub(super) fn two_agents() -> Runs {
    let text = "model = \"heading-alignment\"\n[graph]\nkind = \"complete\"\n[state]\npositions = [[0, 0], [2, 0]]\n\
                velocities = [[2, 0], [2, 0]]\n[law]\npotential = \"inverse-square-log\"\nheading_difference = \"wrapped\"\n\
                [run]\nuntil = 20\nrows = 400\n";
    Ok(vec![Motion { follow: true, trail: 0, ..plane(text, "two linked agents")? }])
}

pub(super) fn turning_triangle() -> Runs {
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
    Ok(vec![Motion { trail: 400, ..plane(&text, "three linked agents")? }])
}

/// Three agents in a row that come to rest at a saddle; below, the same with the middle one moved aside by a thousandth.
pub(super) fn saddle() -> Runs {
    let run = |aside: &str, title: &str| {
        let text = format!(
            "model = \"velocity-alignment\"\n[graph]\nkind = \"complete\"\n[state]\npositions = [[\"-5/4\", 0], [0, {aside}], [\"5/4\", 0]]\n\
             velocities = [[\"1/4\", 0], [0, 0], [\"-1/4\", 0]]\n[law]\npotential = \"inverse-square-log\"\n[run]\nuntil = 40\nrows = 400\n"
        );
        plane(&text, title).map(|motion| Motion { trail: 60, ..motion })
    };
    Ok(vec![run("0", "exactly in a row")?, run("\"1/1000\"", "the middle agent moved aside by 1/1000")?])
}

/// Steps after the first switch that are taken exactly, so that what is inside the flocks has settled as far as can be seen.
const SETTLING: usize = 150;
/// Frames of each stretch of the logarithmic clock.
const FRAMES: usize = 90;

/// Sixteen birds whose networks change at times that are levels of exponentials apart.
pub(super) fn tower() -> Runs {
    let speeds = [0, 8, 0, -8, 7, 1, -9, 1, -1, 9, -1, -7, 8, 0, -8, 0];
    let positions = (0..8).flat_map(|l| [rational(2 * l, 1), rational(6 * l + 2, 3)]).collect();
    let velocities = speeds.map(|v| rational(v, 4096)).to_vec();
    let start = Start::on_the_line(positions, velocities, Weights::Lazy, Hysteresis::None);
    let mut switches = Vec::new();
    let settled =
        settle(Flock::new(&start)?, &Limits::default(), &mut |switch| switches.push(switch.clone()), &Unwatched)?;
    let [first, second] = switches.as_slice() else { return Ok(Vec::new()) };
    let Ending::Beyond { log2_steps, .. } = &settled.ending else { return Ok(Vec::new()) };
    let exact = first.time.to_usize().unwrap_or(0) + SETTLING;
    let mut motion = Motion::of_flock(&start, exact, "sixteen birds on the line, on a logarithmic clock")?;
    motion.said = (0..=exact).map(|t| format!("t = {t}")).collect();
    let (at, drifts) = drifting(&start, exact)?;
    // From the first switch to the second, which is far away.
    let second_at = second.time.to_f64().unwrap_or(f64::INFINITY);
    let (from, to) = ((exact as f64).log10(), second_at.log10());
    let places = |t: f64| at.iter().zip(&drifts).map(|(x, v)| [x + v * (t - exact as f64), 0.0]).collect::<Vec<_>>();
    for k in 1..=FRAMES {
        let digits = from + (to - from) * k as f64 / FRAMES as f64;
        let network = if k == FRAMES {
            second.applied_to(&first.applied_to(Flock::new(&start)?.network()))
        } else {
            first.applied_to(Flock::new(&start)?.network())
        };
        motion.frame(format!("t = 10^{digits:.1}"), places(10f64.powf(digits)), network.edges());
    }
    // From the second to the third, whose time has about 6 10^83 digits: the exponent of the exponent goes on evenly.
    let third = log2_steps.to_f64() * std::f64::consts::LOG10_2;
    let (met, joined) = (places(second_at), settled.network.edges());
    let gap = met.get(8).map_or(1.0, |x| x[0]) - met.get(7).map_or(0.0, |x| x[0]);
    let frame = |share: f64| -> Vec<[f64; 2]> {
        // The two flocks of eight come nearer by what is missing to distance 1, evenly in time.
        let moved = (gap - 1.0) / 2.0 * share;
        met.iter().enumerate().map(|(bird, [x, y])| [if bird < 8 { x + moved } else { x - moved }, *y]).collect()
    };
    for k in 1..=FRAMES {
        let level = to.log10() + (third.log10() - to.log10()) * k as f64 / (FRAMES + 1) as f64;
        motion.frame(format!("t = 10^(10^{level:.2})"), frame(0.0), joined.clone());
    }
    for tenth in 1..=10 {
        let said = format!("t = {} of the third switch, 10^(10^{:.2})", tenth as f64 / 10.0, third.log10());
        let links = if tenth == 10 { [joined.clone(), vec![(7, 8)]].concat() } else { joined.clone() };
        motion.frame(said, frame(f64::from(tenth) / 10.0), links);
    }
    Ok(vec![motion])
}

/// Where the birds are at a time, and the exact mean velocity of the flock of each, rounded.
fn drifting(start: &Start, time: usize) -> Result<(Vec<f64>, Vec<f64>), RunsError> {
    let mut flock = Flock::new(start)?;
    for _ in 0..time {
        flock.step()?;
    }
    let (places, velocities) = (flock.positions(), flock.velocities());
    let mut drifts = vec![0.0; places.len()];
    for birds in flock.network().components() {
        let shares = stationary_distribution(&flock.network().induced(&birds), flock.weights())?;
        let drift: Rational = birds.iter().zip(&shares).map(|(bird, share)| &velocities[*bird][0] * share).sum();
        birds.iter().for_each(|bird| drifts[*bird] = drift.to_f64().unwrap_or(0.0));
    }
    Ok((places.iter().map(|row| row[0].to_f64().unwrap_or(f64::NAN)).collect(), drifts))
}

pub(super) fn split() -> Runs {
    let text = "model = \"velocity-alignment\"\n[graph]\nkind = \"within\"\nradius = 2\n[state]\n\
                positions = [[0, 0], [1, 0], [\"5/2\", 0]]\nvelocities = [[0, 0], [0, 0], [4, 0]]\n[law]\n\
                potential = \"inverse-square-spring\"\n[run]\nuntil = 2\nrows = 200\n";
    Ok(vec![Motion { trail: 200, ..plane(text, "three agents, links within 2")? }])
}

pub(super) fn patterns() -> Runs {
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
            let motion = plane(&text, &format!("{clusters} clusters"))?;
            // All-to-all: the links say nothing.
            Ok(Motion { trail: 25, links: vec![Vec::new(); motion.times.len()], ..motion })
        })
        .collect()
}

pub(super) fn platoon() -> Runs {
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
    let outcome = run(&text)?;
    let deviation = |row: &scenario::Row| -> Vec<[f64; 2]> {
        let cars = row.frame.positions.iter().enumerate();
        cars.map(|(k, x)| [k as f64, x.first().copied().unwrap_or(0.0) + k as f64]).collect()
    };
    let links: Vec<(usize, usize)> = (0..FOLLOWERS).map(|k| (k, k + 1)).collect();
    Ok(vec![Motion {
        times: outcome.rows.iter().map(|row| row.time).collect(),
        points: outcome.rows.iter().map(deviation).collect(),
        links: vec![links; outcome.rows.len()],
        ..Motion::new("deviations of all cars", ["car", "deviation"])
    }])
}
