//! Agents that align their headings or velocities: their law and what is measured on them.

use super::individual::{Located, Sampling};
use super::known::{Known, options};
use super::links::Guard;
use super::model::Model;
use super::network::{Change, Network};
use super::observables::{Observable, measure, observe};
use super::potential::PairPotential;
use super::simulation::{Frame, Law};
use super::turns::Turns;
use super::view::{Amount, Law as Measured, Rows, View};
use arithmetic::ArithmeticError;
use models::double_integrator::{
    self, Coordinates, Flock, Pair, State, Vector, gyroscopic, heading_rate, potential_gradients, velocity_alignment,
};
use motion::Moving;

/// Most agents of a flock of which a pair may stay at the radius: all pairs are looked at in each step then.
const MOST_STAYING: usize = 10_000;

pub(super) const PLANE: Coordinates = Coordinates::Cartesian;

/// What aligns the agents.
pub(super) enum Alignment {
    /// Equation (4) of the second paper.
    Velocities,
    /// Equations (4) and (5) of the first paper; the headings are states too.
    Headings(Turns),
}

/// Agents with accelerations.
pub(super) struct Agents {
    pub network: Network,
    pub potential: PairPotential,
    pub alignment: Alignment,
    pub count: usize,
    /// How a random start was drawn.
    pub drawn: Option<String>,
}

/// The state of so many agents, from a list that may hold headings too.
pub(super) fn state_of(count: usize, list: &[f64]) -> State<f64> {
    let empty = State { positions: Vec::new(), velocities: Vec::new() };
    State::from_list(count, &list[..4 * count]).unwrap_or(empty)
}

impl Agents {
    /// Sets the links.
    pub fn relink(&mut self, pairs: &[Pair]) {
        self.network.set_pairs(pairs.iter().map(|&(i, j)| (i.min(j), i.max(j))).collect());
    }

    /// The jumps of the heading differences.
    fn count_turns(&mut self, list: &[f64]) {
        if let Alignment::Headings(turns) = &mut self.alignment {
            turns.update(&list[4 * self.count..], self.network.pairs());
        }
    }

    fn state(&self, list: &[f64]) -> State<f64> {
        state_of(self.count, list)
    }

    fn headings<'a>(&self, list: &'a [f64]) -> &'a [f64] {
        &list[4 * self.count..]
    }

    /// What is measured on a state.
    fn view<'a>(&'a self, list: &'a [f64]) -> View<'a, f64> {
        let model = match self.alignment {
            Alignment::Velocities => Model::Velocities,
            Alignment::Headings(_) => Model::Headings,
        };
        let rows = |list: &'a [f64]| move || list.chunks_exact(2).map(<[f64]>::to_vec).collect();
        let (positions, rest) = list.split_at(2 * self.count);
        let (velocities, headings) = rest.split_at(2 * self.count);
        View {
            positions: Rows::of(self.count, rows(positions)),
            velocities: Rows::of(self.count, rows(velocities)),
            headings: Rows::of(headings.len(), || headings.iter().map(|theta| vec![*theta]).collect()),
            law: Measured::Agents(self.potential.exact(), self.network.exact_radius()),
            ..View::new(model, self.network.shown())
        }
    }

    fn accelerations(&self, state: &State<f64>, headings: &[f64]) -> Result<Vec<Vector<f64>>, ArithmeticError> {
        let (edges, slope) = (self.network.pairs(), |_: usize, _: usize, s: &f64| self.potential.slope(s));
        match &self.alignment {
            Alignment::Velocities => velocity_alignment(state, edges, PLANE, slope),
            Alignment::Headings(turns) => {
                let gradients = potential_gradients(&state.positions, edges, PLANE, slope)?;
                gyroscopic(state, &gradients, edges, |i, j| turns.difference(headings, i, j))
            }
        }
    }
}

impl Located<0> for Agents {
    const STAYING: Option<&str> = Some(
        "while a pair stays at the radius (Filippov), all agents take the same steps, by Dormand and Prince's method of order 8 with the same tolerance; remarks tell when; a flock of more than 10000 agents ends there",
    );

    fn network(&mut self) -> &mut Network {
        &mut self.network
    }

    fn list(agents: &[Moving<f64, 0>]) -> Vec<f64> {
        State::of_individuals(agents.iter().copied()).to_list()
    }

    fn agents(&self, list: &[f64]) -> Vec<Moving<f64, 0>> {
        self.state(list).individuals(&vec![[]; self.count])
    }

    fn stay(&self, from: f64, list: &[f64], to: &Sampling) -> Option<Known> {
        let radius = self.network.radius().filter(|_| self.count <= MOST_STAYING)?;
        let network = double_integrator::Network::Within(radius);
        let aligned = double_integrator::Alignment::Velocity;
        let flock = Flock::new(aligned, self.potential.exact().clone(), network, self.state(list)).ok()?;
        let motion = flock.run_staying(from, self.network.pairs(), to.times, &options(to.tolerance), to.progress);
        Some(Known::new(motion))
    }

    fn energy(&self, list: &[f64]) -> Result<Option<f64>, ArithmeticError> {
        Ok(match measure("saturated_energy", &self.view(list))? {
            Some(Amount::Number(energy)) => Some(energy),
            _ => None,
        })
    }
}

impl Located<1> for Agents {
    fn network(&mut self) -> &mut Network {
        &mut self.network
    }

    fn list(agents: &[Moving<f64, 1>]) -> Vec<f64> {
        let headings = agents.iter().flat_map(|agent| agent.further);
        State::of_individuals(agents.iter().copied()).to_list().into_iter().chain(headings).collect()
    }

    fn agents(&self, list: &[f64]) -> Vec<Moving<f64, 1>> {
        let headings: Vec<[f64; 1]> = self.headings(list).iter().map(|theta| [*theta]).collect();
        self.state(list).individuals(&headings)
    }
}

impl Law for Agents {
    fn rate(&self, _: f64, list: &[f64], rate: &mut [f64]) -> Result<(), ArithmeticError> {
        let state = self.state(list);
        let accelerations = self.accelerations(&state, self.headings(list))?;
        let (velocities, rest) = rate.split_at_mut(2 * self.count);
        velocities.copy_from_slice(&list[2 * self.count..4 * self.count]);
        let (forces, turning) = rest.split_at_mut(2 * self.count);
        forces.iter_mut().zip(accelerations.iter().flatten()).for_each(|(rate, a)| *rate = *a);
        for ((rate, v), a) in turning.iter_mut().zip(&state.velocities).zip(&accelerations) {
            *rate = heading_rate(v, a)?;
        }
        Ok(())
    }

    fn switches(&self) -> bool {
        let turns = match &self.alignment {
            Alignment::Velocities => false,
            Alignment::Headings(turns) => turns.switch(),
        };
        turns || self.network.switches()
    }

    fn guards(&self, list: &[f64], moved: &[f64]) -> Vec<Guard> {
        let mut guards = self.network.guards(list, moved);
        if let Alignment::Headings(turns) = &self.alignment {
            guards.extend(turns.guards(list, moved, self.network.pairs()));
        }
        guards
    }

    fn switch(&mut self, list: &[f64]) -> Vec<Change> {
        let changes = self.network.switch(list);
        self.count_turns(list);
        changes
    }

    fn next_time(&self) -> Option<f64> {
        self.network.next_time()
    }

    fn replace(&mut self, list: &[f64]) -> Vec<Change> {
        let changes = self.network.replace();
        self.count_turns(list);
        changes
    }

    fn settle(&mut self, list: &[f64]) {
        let (positions, velocities) = list.split_at(2 * self.count);
        self.network.settle(positions, velocities);
        self.count_turns(list);
    }

    fn frame(&self, _: f64, list: &[f64]) -> Frame {
        let state = self.state(list);
        let lists = |vectors: &[Vector<f64>]| vectors.iter().map(|v| v.to_vec()).collect();
        Frame { positions: lists(&state.positions), velocities: lists(&state.velocities), ..Frame::default() }
    }

    fn links(&self) -> Vec<(usize, usize)> {
        self.network.links()
    }

    fn observe(&self, _: f64, list: &[f64]) -> Result<Vec<Observable>, ArithmeticError> {
        observe(&self.view(list), &[])
    }

    fn declaration(&self) -> Vec<String> {
        let mut lines = match &self.alignment {
            Alignment::Velocities => vec![
                "velocity alignment, equation (4) of Tanner and others (fixed and switching networks): dv_i/dt = -sum over j ~ i of (v_i - v_j) - grad_i V_i, unit masses".to_string(),
                "observables: potential is the sum of V_ij over the links, each once; kinetic (1/2) sum |v_i|²; energy their sum, W of (6)".to_string(),
                match self.network.radius() {
                    None => "saturated_energy Q is the energy: no pair saturates on a fixed graph".to_string(),
                    Some(radius) => format!(
                        "saturated_energy Q is kinetic plus the sum over all pairs, each once, of V at the distance, or at {radius} beyond it"
                    ),
                },
            ],
            Alignment::Headings(turns) => vec![
                "heading alignment, equations (4) and (5) of Tanner and others (part I): dv_i/dt = -grad_i V_i - sum over j ~ i of (theta_i - theta_j)/|r_ij|² (z x v_i), unit masses".to_string(),
                turns.declaration().to_string(),
                "observables: potential is the sum of V_ij over the links, each once; kinetic (1/2) sum |v_i|²; energy their sum; heading_spread the largest angle between two headings".to_string(),
            ],
        };
        lines.push(self.potential.declaration());
        lines.push(self.network.declaration().to_string());
        lines.push("disagreement sqrt(sum |v_i - mean|²); momentum the sum of the velocities".to_string());
        lines.extend(self.drawn.clone());
        lines
    }
}
