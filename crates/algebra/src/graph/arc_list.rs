//! Arcs and edges as somebody lists them: each at most once.

use arithmetic::Rational;
use std::collections::BTreeMap;

/// Arcs with the places where they were listed. An edge is an arc each way, so that no arc between its ends may stand beside it; everything that reads
/// edges, from files, names, scenarios, reads them by this one rule.
#[derive(Debug, Clone)]
pub struct ArcList<P> {
    places: BTreeMap<(usize, usize), P>,
    list: Vec<(usize, usize, Rational)>,
    count: usize,
}

impl<P> Default for ArcList<P> {
    fn default() -> Self {
        ArcList { places: BTreeMap::new(), list: Vec::new(), count: 0 }
    }
}

impl<P: Clone> ArcList<P> {
    /// Adds the arc from `i` to `j` with its weight, and the one back where it is an edge.
    ///
    /// # Errors
    /// The place where one of them was listed before.
    pub fn add(&mut self, (i, j): (usize, usize), weight: Rational, is_edge: bool, place: P) -> Result<(), P> {
        let back = (is_edge && i != j).then_some((j, i));
        let arcs = [Some((i, j)), back].into_iter().flatten();
        if let Some(before) = arcs.clone().find_map(|arc| self.places.get(&arc)) {
            return Err(before.clone());
        }
        for (from, to) in arcs {
            self.places.insert((from, to), place.clone());
            self.list.push((from, to, weight.clone()));
        }
        self.count += 1;
        Ok(())
    }

    /// How many arcs and edges were listed.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Whether nothing was listed.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// All arcs, both of each edge.
    pub fn into_arcs(self) -> Vec<(usize, usize, Rational)> {
        self.list
    }
}
