//! Random choices: drawn from the stream of a case, or given as a list. A generator is a function of [`Draws`], so that every case is
//! the list of its draws, and simpler lists are simpler cases.

use arithmetic::random::generator;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::Rng;

/// A source of choices that remembers what it gave. In every choice 0 is the simplest.
#[derive(Debug)]
pub struct Draws {
    source: Source,
    taken: Vec<u64>,
}

#[derive(Debug)]
enum Source {
    Random(Box<ChaCha8Rng>),
    Given(Vec<u64>),
}

impl Draws {
    /// The stream of one case: it is derived from the version, the canonical text and the case.
    pub fn random(version: &str, canonical: &str, case: u64) -> Self {
        Draws { source: Source::Random(Box::new(generator(version, canonical, case))), taken: Vec::with_capacity(64) }
    }

    /// A list of choices; after its end all are 0.
    pub fn given(list: &[u64]) -> Self {
        Draws { source: Source::Given(list.to_vec()), taken: Vec::new() }
    }

    /// A number below `bound`; 0 where there is none.
    pub fn below(&mut self, bound: u64) -> u64 {
        let bound = bound.max(1);
        let value = match &mut self.source {
            // The bias is below 2^-64 times the bound.
            Source::Random(random) => ((u128::from(random.next_u64()) * u128::from(bound)) >> 64) as u64,
            Source::Given(list) => list.get(self.taken.len()).map_or(0, |value| value % bound),
        };
        self.taken.push(value);
        value
    }

    /// A number from `low` to `high`, `low` the simplest.
    pub fn between(&mut self, low: usize, high: usize) -> usize {
        low + self.below((high.max(low) - low) as u64 + 1) as usize
    }

    /// Whether something that happens once in `times` happens; `false` is the simplest.
    pub fn once_in(&mut self, times: u64) -> bool {
        self.below(times) + 1 == times.max(1)
    }

    /// One of a list that is not empty, the first the simplest.
    pub fn choice<'a, T>(&mut self, list: &'a [T]) -> &'a T {
        &list[self.below(list.len() as u64) as usize]
    }

    /// What was given so far.
    pub fn taken(&self) -> &[u64] {
        &self.taken
    }
}

/// Makes a failing list of choices simpler: shorter, and with smaller numbers, as long as `fails`; after `most` trials what is reached.
pub fn shrunk(start: &[u64], most: usize, fails: impl Fn(&[u64]) -> bool) -> Vec<u64> {
    let mut shrinking = Shrinking { best: start.to_vec(), left: most, fails };
    loop {
        let before = shrinking.best.clone();
        shrinking.lower_each();
        shrinking.leave_out();
        shrinking.lower_and_leave_out();
        shrinking.lower_and_replace();
        if shrinking.left == 0 || shrinking.best == before {
            while shrinking.best.last() == Some(&0) {
                shrinking.best.pop();
            }
            return shrinking.best;
        }
    }
}

struct Shrinking<F> {
    best: Vec<u64>,
    left: usize,
    fails: F,
}

impl<F: Fn(&[u64]) -> bool> Shrinking<F> {
    /// Takes a simpler list if it fails too.
    fn is_taken(&mut self, trial: Vec<u64>) -> bool {
        if self.left == 0 || trial == self.best {
            return false;
        }
        self.left -= 1;
        let fails = (self.fails)(&trial);
        if fails {
            self.best = trial;
        }
        fails
    }

    /// Every number as small as bisection makes it.
    fn lower_each(&mut self) {
        for k in 0..self.best.len() {
            let with = |best: &[u64], value: u64| {
                let mut trial = best.to_vec();
                trial[k] = value;
                trial
            };
            if self.best[k] == 0 || self.is_taken(with(&self.best, 0)) {
                continue;
            }
            // `low` is known to hold, and what stands there fails.
            let mut low = 0;
            while self.left > 0 && low + 1 < self.best[k] {
                let middle = low + (self.best[k] - low) / 2;
                if !self.is_taken(with(&self.best, middle)) {
                    low = middle;
                }
            }
        }
    }

    /// Leaves out runs of choices.
    fn leave_out(&mut self) {
        for length in [16, 8, 4, 2, 1] {
            let mut k = self.best.len();
            while k >= length {
                let mut trial = self.best.clone();
                trial.drain(k - length..k);
                self.is_taken(trial);
                k = k.min(self.best.len() + 1) - 1;
            }
        }
    }

    /// Leaves out a run and lowers a count before it by one.
    fn lower_and_leave_out(&mut self) {
        for k in 0..self.best.len().min(6) {
            for length in 1..=4 {
                let mut at = k + 1;
                while self.best.get(k).is_some_and(|count| *count > 0) && at + length <= self.best.len() {
                    let mut trial = self.best.clone();
                    trial[k] -= 1;
                    trial.drain(at..at + length);
                    if !self.is_taken(trial) {
                        at += 1;
                    }
                    if self.left == 0 {
                        return;
                    }
                }
            }
        }
    }

    /// Lowers a count by one and looks for what may come after it: members of another family are numbered otherwise.
    fn lower_and_replace(&mut self) {
        const TRIED: u64 = 32;
        for k in 0..self.best.len().saturating_sub(1).min(4) {
            while self.best[k] > 0 {
                let before = self.best[k];
                for next in 0..TRIED {
                    let mut trial = self.best.clone();
                    trial[k] -= 1;
                    trial[k + 1] = next;
                    if self.is_taken(trial) {
                        break;
                    }
                }
                if self.best[k] == before {
                    break;
                }
            }
        }
    }
}
