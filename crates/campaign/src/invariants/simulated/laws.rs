//! The models in continuous time.

use super::super::{Checked, Tested};
use super::naive::{Arc, Links, Naive, square};
use super::networks::{Allowed, Drawn, network};
use super::{agree, eighths, exact_arcs, places, signed, simulated};
use crate::draws::Draws;

const FREE: &dyn Fn(&[f64]) -> Option<&'static str> = &|_| None;

fn run_section(draws: &mut Draws) -> (String, f64) {
    let until = *draws.choice(&[0.5, 0.25, 1.0]);
    (format!("[run]\nuntil = {until}\nrows = 1\ntolerance = 1e-12\n"), until)
}

/// The links with every arc taken for an edge where `both`.
fn doubled(links: &Links, both: bool) -> Links {
    let turned = |arcs: &[Arc]| {
        let mut all: Vec<Arc> = arcs.iter().flat_map(|&(k, j)| [(k, j), (j, k)]).collect();
        all.sort_unstable();
        all.dedup();
        all
    };
    match links {
        Links::Timed(list) if both => Links::Timed(list.iter().map(|(at, arcs)| (*at, turned(arcs))).collect()),
        links => links.clone(),
    }
}

/// The arcs at the start where they stay; nothing where they are replaced or depend on the distances.
fn lasting(links: &Links) -> Option<&[Arc]> {
    match links {
        Links::Timed(list) if list.len() == 1 => Some(&list[0].1),
        _ => None,
    }
}

/// What an orientation control adds, with its text: by `K1` alone, a reference, or gains of harmonics where all sense all.
enum Orientation {
    First(f64),
    Reference(f64, f64),
    Harmonics(Vec<f64>),
}

impl Orientation {
    fn drawn(draws: &mut Draws, agents: usize, all_to_all: bool) -> (String, Self) {
        let gain = signed(draws, 24);
        match draws.below(4) {
            2 => {
                let start = signed(draws, 16);
                let text = format!("K1 = \"{gain}/8\"\nreference = \"{start}/8\"\n");
                (text, Orientation::Reference(gain as f64 / 8.0, start as f64 / 8.0))
            }
            3 if all_to_all => {
                let divisors: Vec<usize> = (1..=agents).filter(|m| agents.is_multiple_of(*m)).collect();
                let count = *draws.choice(&divisors);
                let gains: Vec<i64> = (0..count).map(|_| signed(draws, 16)).collect();
                let (text, gains) = eighths(&gains);
                (format!("K = {text}\n"), Orientation::Harmonics(gains))
            }
            _ => (format!("K1 = \"{gain}/8\"\n"), Orientation::First(gain as f64 / 8.0)),
        }
    }

    /// `u_k^ori`, one for each agent.
    fn control(&self, time: f64, frequency: f64, phases: &[f64], arcs: &[Arc]) -> Vec<f64> {
        let agents = phases.len();
        let share = 1.0 / agents as f64;
        let mut control = vec![0.0; agents];
        match self {
            Orientation::First(gain) | Orientation::Reference(gain, _) => {
                arcs.iter().for_each(|&(k, j)| control[k] += gain * share * (phases[k] - phases[j]).sin());
            }
            Orientation::Harmonics(gains) => {
                for (gain, m) in gains.iter().zip(1..) {
                    let m = f64::from(m);
                    for (k, own) in control.iter_mut().enumerate() {
                        *own +=
                            phases.iter().map(|other| gain * share / m * (m * (phases[k] - other)).sin()).sum::<f64>();
                    }
                }
            }
        }
        if let Orientation::Reference(gain, start) = self {
            control[agents - 1] += gain * (phases[agents - 1] - (start + frequency * time)).sin();
        }
        control
    }
}

/// Whether a scenario with these arcs may have gains of harmonics.
fn all_to_all(drawn: &Drawn, agents: usize) -> bool {
    lasting(&drawn.links).is_some_and(|arcs| arcs.len() == agents * (agents - 1))
}

pub(super) fn phase(draws: &mut Draws, tested: Tested) -> Checked {
    let agents = draws.between(1, 5);
    let drawn = network(draws, agents, Allowed { directed: true, positions: false, timed: true });
    let phases: Vec<i64> = (0..agents).map(|_| signed(draws, 32)).collect();
    let (list, start) = eighths(&phases);
    let omega = signed(draws, 8);
    let (gains, orientation) = Orientation::drawn(draws, agents, all_to_all(&drawn, agents));
    let (run, until) = run_section(draws);
    let text = format!(
        "model = \"phase\"\n{}[state]\nphases = {list}\n[law]\nomega0 = \"{omega}/8\"\n{gains}{run}",
        drawn.text
    );
    let omega = omega as f64 / 8.0;
    let half = agents * (agents - 1) / 2;
    let counted = |arcs: &[Arc]| tested.is_altered() && arcs.len() == half;
    let all: Vec<Arc> = (0..agents).flat_map(|k| (0..agents).filter(move |j| *j != k).map(move |j| (k, j))).collect();
    let rate = |time: f64, phases: &[f64], arcs: &[Arc]| {
        let control = orientation.control(time, omega, phases, if counted(arcs) { &all } else { arcs });
        control.iter().map(|u| omega + u).collect::<Vec<f64>>()
    };
    let naive = Naive { agents, start, links: drawn.links.clone(), rate: &rate, doubt: FREE };
    if let (Orientation::First(_), Some(arcs)) = (&orientation, lasting(&drawn.links)) {
        exact_arcs(&text, arcs)?;
    }
    agree(&simulated(&text)?.list, &naive.at(until)?, &text)?;
    Ok(None)
}

/// What keeps particles on circles.
enum Spacing {
    None,
    Circle(f64),
    Beacon(f64, [f64; 2]),
}

impl Spacing {
    fn drawn(draws: &mut Draws, omega: i64) -> (String, Self) {
        let gain = 1 + draws.below(8) as i64;
        match draws.below(3) {
            1 if omega != 0 => (format!("K0 = \"{gain}/8\"\n"), Spacing::Circle(gain as f64 / 8.0)),
            2 if omega != 0 => {
                let (place, numbers) = eighths(&[signed(draws, 8), signed(draws, 8)]);
                let text = format!("K0 = \"{gain}/8\"\nbeacon = {place}\n");
                (text, Spacing::Beacon(gain as f64 / 8.0, [numbers[0], numbers[1]]))
            }
            _ => (String::new(), Spacing::None),
        }
    }

    /// What is added to `u_k`.
    fn control(&self, omega: f64, state: &[f64], arcs: &[Arc]) -> Vec<f64> {
        let agents = state.len() / 3;
        let phase = |k: usize| state[2 * agents + k];
        // c_k = r_k + i e^(i theta_k)/omega0.
        let centre = |k: usize| [state[2 * k] - phase(k).sin() / omega, state[2 * k + 1] + phase(k).cos() / omega];
        let along = |k: usize, v: [f64; 2]| phase(k).cos() * v[0] + phase(k).sin() * v[1];
        let apart = |a: [f64; 2], b: [f64; 2]| [a[0] - b[0], a[1] - b[1]];
        let mut control = vec![0.0; agents];
        match self {
            Spacing::None => {}
            Spacing::Circle(gain) => {
                for &(k, j) in arcs {
                    control[k] += omega * gain / agents as f64 * along(k, apart(centre(k), centre(j)));
                }
            }
            Spacing::Beacon(gain, place) => {
                for (k, own) in control.iter_mut().enumerate() {
                    *own += omega * gain * along(k, apart(centre(k), *place));
                }
            }
        }
        control
    }
}

pub(super) fn particles(draws: &mut Draws, tested: Tested) -> Checked {
    let agents = draws.between(1, 5);
    let drawn = network(draws, agents, Allowed { directed: true, positions: true, timed: true });
    let (positions, mut start) = places(draws, agents);
    let phases: Vec<i64> = (0..agents).map(|_| signed(draws, 32)).collect();
    let (list, phases) = eighths(&phases);
    start.extend(phases);
    let omega = signed(draws, 12);
    let (gains, orientation) = Orientation::drawn(draws, agents, all_to_all(&drawn, agents));
    let (spacing_text, spacing) = Spacing::drawn(draws, omega);
    let (drift_text, drift) = eighths(&[signed(draws, 4), signed(draws, 4)]);
    let (run, until) = run_section(draws);
    let text = format!(
        "model = \"particles\"\n{}[state]\npositions = {positions}\nphases = {list}\n[law]\nomega0 = \"{omega}/8\"\n{gains}{spacing_text}drift = \
         {drift_text}\n{run}",
        drawn.text
    );
    let omega = omega as f64 / 8.0;
    let rate = |time: f64, state: &[f64], arcs: &[Arc]| {
        let phases = &state[2 * agents..];
        let turning = orientation.control(time, omega, phases, arcs);
        let moving = phases.iter().flat_map(|theta| [theta.cos() + drift[0], theta.sin() + drift[1]]);
        let steering = turning.iter().zip(spacing.control(omega, state, arcs)).map(|(u, s)| omega + u + s);
        moving.chain(steering).collect::<Vec<f64>>()
    };
    let links = doubled(&drawn.links, tested.is_altered() && drawn.directed);
    let naive = Naive { agents, start, links, rate: &rate, doubt: FREE };
    if let (Orientation::First(_), Some(arcs), false) = (&orientation, lasting(&drawn.links), tested.is_altered()) {
        exact_arcs(&text, arcs)?;
    }
    agree(&simulated(&text)?.list, &naive.at(until)?, &text)?;
    Ok(None)
}

/// A potential as text, and its slope `V'(s)` where `s` is the squared distance.
fn potential(draws: &mut Draws) -> (String, Box<dyn Fn(f64) -> f64>) {
    let eighth = 4 + draws.below(12) as i64;
    let m = eighth as f64 / 8.0;
    match draws.below(3) {
        0 => {
            let text = format!("potential = \"inverse-square-log\"\nminimum = \"{eighth}/8\"\n");
            (text, Box::new(move |s| 1.0 / s - m / (s * s)))
        }
        1 => {
            let text =
                format!("potential = \"inverse-square-spring\"\nminimum = \"{eighth}/8\"\nstiffness = \"1/4\"\n");
            (text, Box::new(move |s| 0.25 * (1.0 / m - m / (s * s))))
        }
        _ => ("potential = \"none\"\n".to_string(), Box::new(|_| 0.0)),
    }
}

pub(super) fn velocities(draws: &mut Draws, tested: Tested) -> Checked {
    aligned(draws, tested, false)
}

pub(super) fn headings(draws: &mut Draws, tested: Tested) -> Checked {
    aligned(draws, tested, true)
}

/// Both models of alignment. Headings are states of their own, as the law reads them where they do not jump.
fn aligned(draws: &mut Draws, tested: Tested, headings: bool) -> Checked {
    let agents = draws.between(1, 5);
    let drawn = network(draws, agents, Allowed { directed: false, positions: true, timed: true });
    let (positions, mut start) = places(draws, agents);
    // To the right, so that no heading is near pi.
    let rows: Vec<(String, Vec<f64>)> =
        (0..agents).map(|_| eighths(&[4 + draws.below(8) as i64, signed(draws, 8)])).collect();
    let texts: Vec<String> = rows.iter().map(|(text, _)| text.clone()).collect();
    start.extend(rows.iter().flat_map(|(_, v)| v.clone()));
    if headings {
        start.extend(rows.iter().map(|(_, v)| v[1].atan2(v[0])));
    }
    let (potential, slope) = potential(draws);
    let (run, until) = run_section(draws);
    let model = if headings { "heading-alignment" } else { "velocity-alignment" };
    let text = format!(
        "model = \"{model}\"\n{}[state]\npositions = {positions}\nvelocities = [{}]\n[law]\n{potential}{run}",
        drawn.text,
        texts.join(", ")
    );
    let rate = |_: f64, state: &[f64], arcs: &[Arc]| {
        let v = |k: usize| [state[2 * (agents + k)], state[2 * (agents + k) + 1]];
        let mut forces = vec![[0.0; 2]; agents];
        for &(k, j) in arcs.iter().skip(usize::from(tested.is_altered())) {
            let s = square(state, k, j);
            let turned = [-v(k)[1], v(k)[0]];
            for (c, force) in forces[k].iter_mut().enumerate() {
                *force -= 2.0 * slope(s) * (state[2 * k + c] - state[2 * j + c]);
                *force -= match headings {
                    true => (state[4 * agents + k] - state[4 * agents + j]) / s * turned[c],
                    false => v(k)[c] - v(j)[c],
                };
            }
        }
        let turning = |k: usize| {
            let ([vx, vy], [ax, ay]) = (v(k), forces[k]);
            (vx * ay - vy * ax) / (vx * vx + vy * vy)
        };
        let turns: Vec<f64> = if headings { (0..agents).map(turning).collect() } else { Vec::new() };
        state[2 * agents..4 * agents].iter().copied().chain(forces.iter().flatten().copied()).chain(turns).collect()
    };
    let doubt = |state: &[f64]| {
        let close = (0..agents).any(|k| (0..k).any(|j| square(state, k, j) < 0.1));
        let slow = |k: usize| state[2 * (agents + k)].hypot(state[2 * (agents + k) + 1]) < 0.2;
        let angles = state.get(4 * agents..).unwrap_or_default();
        let far = angles.iter().any(|a| a.abs() > 3.0 || angles.iter().any(|b| (a - b).abs() > 3.0));
        if close {
            Some("two agents come close")
        } else if headings && (far || (0..agents).any(slow)) {
            Some("a heading may jump")
        } else {
            None
        }
    };
    if let Some(arcs) = lasting(&drawn.links) {
        exact_arcs(&text, arcs)?;
    }
    let naive = Naive { agents, start, links: drawn.links, rate: &rate, doubt: &doubt };
    let expected = naive.at(until)?;
    agree(&simulated(&text)?.list, &expected[..4 * agents], &text)?;
    Ok(None)
}

/// The text of a network or of a way to communicate, who tracks whom, and whether it is the line of cars.
fn tracked(draws: &mut Draws, cars: usize) -> (String, Vec<Arc>, bool) {
    let back = |k: usize| (k + 1 < cars).then_some((k, k + 1));
    match draws.below(4) {
        0 => (String::new(), (1..cars).flat_map(|k| [Some((k, k - 1)), back(k)]).flatten().collect(), true),
        1 => {
            let text = "communication = \"front\"\n".to_string();
            (text, (1..cars).map(|k| (k, k - 1)).collect(), true)
        }
        _ => {
            let drawn = network(draws, cars, Allowed { directed: true, positions: false, timed: false });
            let arcs = lasting(&drawn.links).unwrap_or_default().to_vec();
            (drawn.text, arcs, false)
        }
    }
}

pub(super) fn platoon(draws: &mut Draws, tested: Tested) -> Checked {
    let cars = draws.between(2, 5);
    let other = draws.between(0, cars - 1);
    let (network, arcs, line) = tracked(draws, cars);
    let leader = if line { 0 } else { other };
    let positions: Vec<i64> = (0..cars as i64).map(|k| signed(draws, 3) - 8 * k).collect();
    let velocities: Vec<i64> = (0..cars).map(|_| signed(draws, 6)).collect();
    let ((places, x), (speeds, v)) = (eighths(&positions), eighths(&velocities));
    let (f, g) = (-(1 + draws.below(24) as i64), -(1 + draws.below(24) as i64));
    let (size, w) = (signed(draws, 4), draws.below(24) as i64);
    let (run, until) = run_section(draws);
    let (graph, communication) = if line { (String::new(), network) } else { (network, String::new()) };
    let text = format!(
        "model = \"platoon\"\n{graph}[state]\npositions = {places}\nvelocities = {speeds}\n[law]\nf = \"{f}/8\"\ng = \"{g}/8\"\n{communication}leader = {{ \
         agent = {}, amplitude = \"{size}/8\", frequency = \"{w}/8\" }}\n{run}",
        leader + 1
    );
    let [f, g, size, w] = [f, g, size, w].map(|x| x as f64 / 8.0);
    // y_k = x_k + k, agents from 0, with the leader's swing.
    let deviations: Vec<f64> = x.iter().zip(0..).map(|(x, k)| x + f64::from(k)).collect();
    let lead = |t: f64| {
        let (sin, cos) = (w * t).sin_cos();
        (deviations[leader] + v[leader] * t + size * cos, v[leader] - size * w * sin)
    };
    let rate = |t: f64, state: &[f64], _: &[Arc]| {
        let at = |k: usize| if k == leader { lead(t) } else { (state[k], state[cars + k]) };
        let force = |k: usize| {
            let mut others: Vec<usize> = arcs.iter().filter(|(own, _)| *own == k).map(|(_, j)| *j).collect();
            others.truncate(if tested.is_altered() { 1 } else { cars });
            // Who tracks nobody keeps its speed.
            let share = 1.0 / others.len() as f64;
            let apart = others.iter().map(|&j| (share * (at(k).0 - at(j).0), share * (at(k).1 - at(j).1)));
            let (e, rate) = apart.fold((0.0, 0.0), |(e, rate), (x, v)| (e + x, rate + v));
            if k == leader { 0.0 } else { f * e + g * rate }
        };
        state[cars..].iter().copied().chain((0..cars).map(force)).collect()
    };
    let start = deviations.iter().chain(&v).copied().collect();
    let links = Links::Timed(vec![(0.0, Vec::new())]);
    let naive = Naive { agents: cars, start, links, rate: &rate, doubt: FREE };
    let mut end = naive.at(until)?;
    (end[leader], end[cars + leader]) = lead(until);
    let last = end[cars - 1] - end[leader];
    (0..cars).for_each(|k| end[k] -= k as f64);
    let shown = simulated(&text)?;
    agree(&shown.list, &end, &text)?;
    agree(&[shown.last_deviation.unwrap_or(f64::NAN)], &[last], &text)?;
    Ok(None)
}
