//! The stabilisers of a sequence of matrices (Chazelle, proof of Lemma 3.1), found while the sequence runs.

use super::Footprint;

/// One stabiliser of a sequence, as far as it has been seen.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Stabiliser {
    /// `T_k`: the number of factors after which the footprint, restricted to the previous stabiliser and started after
    /// `T_{k-1}`, no longer changes within the sequence.
    pub time: usize,
    /// `V_k`: the vertices (from 0) with a one in the first column of that footprint.
    pub members: Vec<usize>,
}

/// The stabilisers `V_1 ⊇ V_2 ⊇ ...` of a sequence whose factors arrive one at a time.
///
/// In the paper `T_k` is the last change over all future time; after finitely many factors it is the last change so far,
/// and a later factor may move it. Memory: one footprint for each level, whatever the length of the sequence. A factor
/// costs at most one product of footprints for each level.
#[derive(Debug, Clone)]
pub struct StabiliserStream {
    order: usize,
    most_levels: usize,
    factors: usize,
    levels: Vec<Level>,
    /// The levels that differ from the one before in domain or product, in order: the others change when those do.
    heads: Vec<usize>,
    /// The last factor, where it changed nothing: pushed again, it changes nothing.
    idle: Option<Footprint>,
}

/// The product since `T_{k-1}` on `V_{k-1}`, and the stabiliser that it shows.
#[derive(Debug, Clone)]
struct Level {
    domain: Vec<usize>,
    product: Footprint,
    found: Stabiliser,
}

impl Level {
    fn started(domain: Vec<usize>, factor: &Footprint, time: usize) -> Self {
        let product = factor.restricted(&domain);
        let members = first_column(&domain, &product);
        Level { domain, product, found: Stabiliser { time, members } }
    }

    /// Multiplies by a factor; whether the footprint changed.
    fn push(&mut self, factor: &Footprint, time: usize) -> bool {
        let next = factor.restricted(&self.domain).times(&self.product);
        if next == self.product {
            return false;
        }
        self.found = Stabiliser { time, members: first_column(&self.domain, &next) };
        self.product = next;
        true
    }
}

fn first_column(domain: &[usize], product: &Footprint) -> Vec<usize> {
    product.column(0).into_iter().map(|i| domain[i]).collect()
}

impl StabiliserStream {
    /// An empty sequence of square footprints of this order, of which the first `most_levels` stabilisers are kept.
    pub fn new(order: usize, most_levels: usize) -> Self {
        StabiliserStream { order, most_levels, factors: 0, levels: Vec::new(), heads: Vec::new(), idle: None }
    }

    /// The next factor of the sequence, a square footprint of the order of the stream; outside of it there are only zeros.
    pub fn push(&mut self, factor: &Footprint) {
        self.factors += 1;
        if self.idle.as_ref() == Some(factor) {
            return;
        }
        self.idle = None;
        for place in 0..self.heads.len() {
            let k = self.heads[place];
            if self.levels[k].push(factor, self.factors) {
                // What follows T_k starts again, with the next factor.
                self.levels.truncate(k + 1);
                self.heads.truncate(place + 1);
                return;
            }
        }
        if self.levels.len() == self.most_levels {
            self.idle = Some(factor.clone());
            return;
        }
        let domain = self.levels.last().map_or_else(|| (0..self.order).collect(), |last| last.found.members.clone());
        if domain.is_empty() {
            self.idle = Some(factor.clone());
        } else {
            let level = Level::started(domain, factor, self.factors);
            if self.levels.last().is_none_or(|last| (&last.domain, &last.product) != (&level.domain, &level.product)) {
                self.heads.push(self.levels.len());
            }
            self.levels.push(level);
        }
    }

    /// The stabilisers that the factors so far support, in order.
    pub fn stabilisers(&self) -> impl Iterator<Item = &Stabiliser> {
        self.levels.iter().map(|level| &level.found)
    }
}

/// All stabilisers that a finite sequence of square footprints of the same order supports; they end when the factors are
/// used up.
pub fn stabilisers(factors: &[Footprint]) -> Vec<Stabiliser> {
    let order = factors.first().map_or(0, Footprint::rows);
    let mut stream = StabiliserStream::new(order, usize::MAX);
    factors.iter().for_each(|factor| stream.push(factor));
    stream.stabilisers().cloned().collect()
}
