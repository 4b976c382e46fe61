//! The noisy model of Vicsek and others in a periodic square, in floating point.

use super::described::{Built, Described};
use super::error::{ConfigError, RunError};
use super::exact::ExactMotion;
use super::model::Model;
use super::observables::{Observable, observe};
use super::simulation::{Event, Frame, Simulation};
use super::source::Source;
use super::start::{Needs, Start};
use super::view::{Links, Rows, View};
use arithmetic::random::generator;
use arithmetic::{ArithmeticError, Complex, Progress, rational};
use models::averaging::NoisyFlock;
use rand_chacha::ChaCha8Rng;

/// A flock with what its noise is drawn by.
pub(super) struct Noisy {
    flock: NoisyFlock,
    random: ChaCha8Rng,
    seed: usize,
    time: u64,
    drawn: Option<String>,
}

impl Described for Noisy {
    fn exact(&self) -> ExactMotion {
        ExactMotion::Other("its law is not among those that are enclosed")
    }

    fn simulation(self: Box<Self>, _: &Source, _: f64) -> Result<Built, ConfigError> {
        Ok((self, Some(rational(1, 1))))
    }
}

impl Noisy {
    /// Reads the model.
    pub fn read(source: &Source) -> Result<Self, ConfigError> {
        let start = Start::read(source, Needs { dimension: 2, velocities: false, phases: true })?;
        if let Some(section) = source.section("graph")? {
            section.allow(&[], " of the vicsek-noise model, whose `radius` in [law] makes the network")?;
        }
        let law = source.needed("law")?;
        law.allow(&["box", "radius", "speed", "noise", "seed"], " of the vicsek-noise model")?;
        let side = law.need("box", "the side of the periodic square, a number above 0")?.positive()?;
        let radius = law.get("radius").map_or(Ok(1.0), |entry| entry.positive())?;
        if 2.0 * radius > side {
            let entry = law.need("box", "the side of the periodic square")?;
            return Err(
                entry.range(format!("at least twice the radius {radius}, so that no bird is its own neighbour"))
            );
        }
        let speed = law.need("speed", "the distance of a step, a number above 0")?.positive()?;
        let noise = law.get("noise").map_or(Ok(0.0), |entry| entry.not_negative())?;
        let seed = law.get("seed").map_or(Ok(1), |entry| entry.count(0, usize::MAX))?;
        let mut flock = NoisyFlock { positions: Vec::new(), headings: start.flat_phases(), side, radius, speed, noise };
        flock.positions =
            start.flat_positions().chunks_exact(2).map(|r| [flock.wrapped(r[0]), flock.wrapped(r[1])]).collect();
        let random = generator(&seed.to_string(), "vicsek.noise", source.replica);
        Ok(Noisy { flock, random, seed, time: 0, drawn: start.drawn })
    }

    fn failed(&self) -> RunError {
        RunError::law(self.time as f64, ArithmeticError::Domain("places that stay finite"))
    }

    fn phasors(&self) -> Vec<Complex<f64>> {
        self.flock.headings.iter().map(|theta| Complex::new(theta.cos(), theta.sin())).collect()
    }
}

impl Simulation for Noisy {
    fn advance(&mut self, until: f64, _: &mut Vec<Event>, progress: &dyn Progress) -> Result<bool, RunError> {
        while (self.time as f64) < until.round() {
            if progress.is_cancelled() {
                return Ok(false);
            }
            self.flock.step(&mut self.random).map_err(|_| self.failed())?;
            self.time += 1;
        }
        Ok(true)
    }

    fn frame(&self) -> Frame {
        let positions = self.flock.positions.iter().map(|r| r.to_vec()).collect();
        Frame { positions, phases: self.flock.headings.clone(), ..Frame::default() }
    }

    fn observe(&self) -> Result<Vec<Observable>, ArithmeticError> {
        let (phasors, birds, speed) = (self.phasors(), self.flock.headings.len(), self.flock.speed);
        let links = self.flock.links().map_err(|_| ArithmeticError::Domain("places that stay finite"))?;
        let view = View {
            velocities: Rows::of(birds, || phasors.iter().map(|z| vec![speed * z.re, speed * z.im]).collect()),
            phasors: phasors.clone(),
            orders: 4.min(birds as u32),
            ..View::new(Model::Noisy, Links::These(birds, links.into()))
        };
        observe(&view, &[])
    }

    fn declaration(&self) -> Vec<String> {
        let NoisyFlock { side, radius, speed, noise, .. } = &self.flock;
        let mut lines = vec![
            format!(
                "simulated: model of Vicsek and others (1995) in floating point, in the periodic square of side {side}: r_k(t+1) = r_k(t) + {speed} e^(i theta_k(t)), theta_k(t+1) = arg sum e^(i theta_j(t)) + noise, over all j at a distance below {radius}, k included"
            ),
            format!("noise: uniform in [-{noise}/2, {noise}/2] radians (ChaCha8, seed {}), anew for every bird and step", self.seed),
            "observables: order |p_m| with p_m = (1/(m N)) sum e^(i m theta_k), at most 1/m; mean_neighbours of a bird, itself not counted; components of the network; momentum is the sum of the velocities".to_string(),
        ];
        lines.extend(self.drawn.clone());
        lines
    }
}
