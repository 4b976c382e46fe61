//! Some agents at one time: what a switch or the end of a series makes anew.

use super::path::Path;

/// The series of some agents, all from the same time on.
#[derive(Debug, Clone)]
pub struct Together<const F: usize> {
    /// For each agent the number of the last round in which it was here, and where; in which it was asked; and in which it changed.
    here: Vec<(u64, usize)>,
    seen: Vec<u64>,
    changed: Vec<u64>,
    pub round: u64,
    paths: Vec<Path<F>>,
    /// The same as they were.
    old: Vec<Path<F>>,
}

impl<const F: usize> Together<F> {
    /// Nobody yet, of so many agents.
    pub fn new(count: usize) -> Self {
        let (paths, old) = (Vec::new(), Vec::new());
        Together { here: vec![(0, 0); count], seen: vec![0; count], changed: vec![0; count], round: 0, paths, old }
    }

    /// Forgets all.
    pub fn begin(&mut self) {
        self.round += 1;
        self.paths.clear();
        self.old.clear();
    }

    fn is_here(&self, agent: usize) -> bool {
        self.here[agent].0 == self.round
    }

    pub fn add(&mut self, agent: usize, path: impl FnOnce() -> Path<F>) {
        if !self.is_here(agent) {
            self.here[agent] = (self.round, self.paths.len());
            let path = path();
            self.paths.push(path);
            self.old.push(path);
        }
    }

    /// Of an agent that is here.
    pub fn path(&self, agent: usize) -> &Path<F> {
        &self.paths[self.here[agent].1]
    }

    pub fn old(&self, agent: usize) -> &Path<F> {
        &self.old[self.here[agent].1]
    }

    pub fn is_changed(&self, agent: usize) -> bool {
        self.changed[agent] == self.round
    }

    pub fn set_changed(&mut self, agent: usize) {
        self.changed[agent] = self.round;
    }

    pub fn path_mut(&mut self, agent: usize) -> &mut Path<F> {
        &mut self.paths[self.here[agent].1]
    }

    /// Whether an agent is looked at for the first time.
    pub fn see(&mut self, agent: usize) -> bool {
        std::mem::replace(&mut self.seen[agent], self.round) != self.round
    }
}
