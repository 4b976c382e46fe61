//! The models in discrete time.

use super::super::{Checked, Stop, Tested};
use super::naive::square;
use super::{agree, eighths, places, signed, simulated};
use crate::draws::Draws;

/// Comparisons nearer to a tie than this are left alone: floats cannot tell.
const TIE: f64 = 1e-6;

fn tie() -> Stop {
    Stop::Undecided("a comparison is too close for floats".to_string())
}

pub(super) fn vicsek(draws: &mut Draws, tested: Tested) -> Checked {
    let birds = draws.between(1, 6);
    let (positions, mut x) = places(draws, birds);
    let (steps, headings) = (draws.between(1, 6), draws.once_in(2));
    // Odd sixteenths, so that fewer distances are the radius.
    let radius = 2 * draws.between(4, 16) + 1;
    let (state, law, mut own) = if headings {
        let (list, own) = eighths(&(0..birds).map(|_| draws.below(48) as i64).collect::<Vec<_>>());
        (format!("phases = {list}"), "[law]\nspeed = \"1/4\"\n", own)
    } else {
        let rows: Vec<_> = (0..birds).map(|_| eighths(&[signed(draws, 4), signed(draws, 4)])).collect();
        let texts: Vec<String> = rows.iter().map(|(text, _)| text.clone()).collect();
        (format!("velocities = [{}]", texts.join(", ")), "", rows.into_iter().flat_map(|(_, v)| v).collect())
    };
    let text = format!(
        "model = \"vicsek\"\n[graph]\nkind = \"within\"\nradius = \"{radius}/16\"\n[state]\npositions = {positions}\n{state}\n{law}[run]\nuntil = {steps}\n"
    );
    let radius = radius as f64 / 16.0;
    let width = own.len() / birds;
    for _ in 0..steps {
        for k in 0..birds {
            let v = if headings { [0.25 * own[k].cos(), 0.25 * own[k].sin()] } else { [own[2 * k], own[2 * k + 1]] };
            (x[2 * k], x[2 * k + 1]) = (x[2 * k] + v[0], x[2 * k + 1] + v[1]);
        }
        let before = own.clone();
        for k in 0..birds {
            let gap = |j: &usize| square(&x, k, *j) - radius * radius;
            if (0..birds).any(|j| j != k && gap(&j).abs() < TIE) {
                return Err(tie());
            }
            let mut near: Vec<usize> = (0..birds).filter(|j| gap(j) <= 0.0).collect();
            near.retain(|j| *j != k || !tested.is_altered());
            if near.is_empty() {
                continue;
            }
            for c in 0..width {
                own[width * k + c] = near.iter().map(|j| before[width * j + c]).sum::<f64>() / near.len() as f64;
            }
        }
    }
    agree(&simulated(&text)?.list, &[x, own].concat(), &text)?;
    Ok(None)
}

/// The gains and zones of fish.
struct School {
    omega: f64,
    gains: [f64; 3],
    /// Outer radii.
    zones: [f64; 3],
    /// Half the width of the blind spot, in radians.
    blind: f64,
    laplacians: bool,
}

impl School {
    /// The zone in which one fish sees another, or that it sees nothing there.
    fn zone(&self, state: &[f64], k: usize, j: usize) -> Result<Option<usize>, Stop> {
        let fish = state.len() / 3;
        let distance = square(state, k, j).sqrt();
        if self.zones.iter().any(|radius| (distance - radius).abs() < TIE) {
            return Err(tie());
        }
        let (x, y) = (state[2 * j] - state[2 * k], state[2 * j + 1] - state[2 * k + 1]);
        let theta = state[2 * fish + k];
        let behind = (-(theta.cos() * x + theta.sin() * y) / distance).clamp(-1.0, 1.0).acos();
        if self.blind > 0.0 && (behind - self.blind).abs() < TIE {
            return Err(tie());
        }
        Ok(if behind < self.blind { None } else { self.zones.iter().position(|radius| distance < *radius) })
    }

    fn turning(&self, state: &[f64], k: usize) -> Result<f64, Stop> {
        let fish = state.len() / 3;
        let theta = |k: usize| state[2 * fish + k];
        // <i e^(i theta_k), v>.
        let across = |x: f64, y: f64| theta(k).cos() * y - theta(k).sin() * x;
        let mut sum = self.omega;
        for j in (0..fish).filter(|j| *j != k) {
            let Some(zone) = self.zone(state, k, j)? else { continue };
            let (x, y) = (state[2 * j] - state[2 * k], state[2 * j + 1] - state[2 * k + 1]);
            let length = if self.laplacians { 1.0 } else { x.hypot(y) };
            let towards = across(x, y) / length;
            sum += match zone {
                0 if self.laplacians => 0.0,
                0 => -self.gains[0] * towards,
                1 => self.gains[1] * (theta(j) - theta(k)).sin(),
                _ => self.gains[2] * towards,
            };
        }
        Ok(sum)
    }
}

pub(super) fn fish(draws: &mut Draws, tested: Tested) -> Checked {
    let fish = draws.between(1, 6);
    let (positions, mut state) = places(draws, fish);
    let (list, phases) = eighths(&(0..fish).map(|_| signed(draws, 32)).collect::<Vec<_>>());
    state.extend(phases);
    let (omega, steps) = (signed(draws, 8), draws.between(1, 8));
    let gains = [0; 3].map(|_| signed(draws, 8));
    let inner = draws.between(4, 12);
    let zones = [inner, inner + draws.between(2, 8), inner + draws.between(10, 24)];
    let (blind, laplacians) = (*draws.choice(&[0, 60, 120, 180]), draws.once_in(2));
    let steering = if laplacians { "laplacians" } else { "behaviours" };
    let text = format!(
        "model = \"fish\"\n[state]\npositions = {positions}\nphases = {list}\n[law]\nT = \"1/4\"\nomega0 = \"{omega}/8\"\nKrep = \"{}/8\"\nKori = \"{}/8\"\n\
         Katt = \"{}/8\"\nrepulsion = \"{}/8\"\norientation = \"{}/8\"\nattraction = \"{}/8\"\nblind_angle = {blind}\nsteering = \"{steering}\"\n[run]\nuntil = \
         \"{steps}/4\"\n",
        gains[0], gains[1], gains[2], zones[0], zones[1], zones[2]
    );
    let blind = if tested.is_altered() { 0.0 } else { f64::from(blind).to_radians() / 2.0 };
    let school = School {
        omega: omega as f64 / 8.0,
        gains: gains.map(|x| x as f64 / 8.0),
        zones: zones.map(|x| x as f64 / 8.0),
        blind,
        laplacians,
    };
    for _ in 0..steps {
        let turning = (0..fish).map(|k| school.turning(&state, k)).collect::<Result<Vec<_>, _>>()?;
        for k in 0..fish {
            let theta = state[2 * fish + k];
            state[2 * k] += 0.25 * theta.cos();
            state[2 * k + 1] += 0.25 * theta.sin();
            state[2 * fish + k] += 0.25 * turning[k];
        }
    }
    agree(&simulated(&text)?.list, &state, &text)?;
    Ok(None)
}
