//! Short gaps bridged by straight lines or cubics.

use super::{Frame, Gap, Tracks, Vector, gaps};
use std::collections::BTreeSet;

/// The way of a fish over a bridge.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BridgeShape {
    /// The straight line from the last position before it to the first one after it, at a constant velocity.
    Line,
    /// The cubic with these positions, and with the velocities from the two positions next to each end: a spline of Hermite. Where a
    /// second position is missing, the velocity there is that of the straight line.
    Spline,
}

impl BridgeShape {
    /// All, with their names.
    pub const ALL: [(&'static str, BridgeShape); 2] = [("line", BridgeShape::Line), ("spline", BridgeShape::Spline)];

    /// In words, for what is printed.
    pub fn words(self) -> &'static str {
        match self {
            BridgeShape::Line => "straight lines at constant velocity",
            BridgeShape::Spline => "cubics with the positions and velocities at both ends",
        }
    }

    /// The position at a share of the way from `a` to `b`, with the velocities there times the time of the bridge.
    fn at(self, share: f64, [a, b]: [&Vector; 2], [from, to]: [&Vector; 2]) -> Vector {
        let line = a.scale(&(1.0 - share)) + &b.scale(&share);
        match self {
            BridgeShape::Line => line,
            BridgeShape::Spline => {
                // What the velocities at the ends differ from that of the line, times the cubics with slope 1 at one end.
                let straight = b.clone() - a;
                let (before, after) = (from.clone() - &straight, to.clone() - &straight);
                let (s, r) = (share, 1.0 - share);
                line + &before.scale(&(s * r * r)) - &after.scale(&(s * s * r))
            }
        }
    }
}

impl Tracks {
    /// The recording with every gap of at most so many frames bridged. A gap at the start or the end of the recording has no other side and stays. Frames without
    /// any row that a bridge crosses are added. What was bridged is in [`Tracks::bridged`].
    pub fn bridge(mut self, longest: u64, shape: BridgeShape) -> Tracks {
        let bridged: Vec<Gap> =
            gaps(&self).into_iter().filter(|gap| gap.frames <= longest && !gap.at_start && !gap.at_end).collect();
        if bridged.is_empty() {
            return self;
        }
        let numbers: BTreeSet<u64> = self.frames.iter().map(|frame| frame.number).collect();
        let crossed: BTreeSet<u64> = bridged.iter().flat_map(|gap| gap.first..gap.first + gap.frames).collect();
        let frames: Vec<Frame> =
            numbers.union(&crossed).map(|&number| Frame { number, time: self.time_of(number) }).collect();
        for places in &mut self.positions {
            let mut known = self.frames.iter().map(|frame| frame.number).zip(std::mem::take(places)).peekable();
            *places = frames.iter().map(|frame| known.next_if(|(number, _)| *number == frame.number)?.1).collect();
        }
        self.frames = frames;
        for (k, gap) in bridged.iter().enumerate() {
            let place = |number: u64| self.frames.binary_search_by_key(&number, |frame| frame.number).ok();
            // The frames of a bridge and the two at its ends are there, in a row.
            let Some((before, after)) = gap.first.checked_sub(1).and_then(place).zip(place(gap.first + gap.frames))
            else {
                continue;
            };
            let places = &mut self.positions[gap.fish];
            if let (Some(a), Some(b)) = (places[before].clone(), places[after].clone()) {
                let steps = (gap.frames + 1) as f64;
                let straight = b.clone() - &a;
                // The second position next to an end: a row in the next frame on the grid, not a place on another bridge.
                let second = |i: usize, number: u64| {
                    let others = [k.checked_sub(1), Some(k + 1)].into_iter().flatten().filter_map(|k| bridged.get(k));
                    let on_bridge = |gap: &Gap| (gap.first..gap.first + gap.frames).contains(&number);
                    let free = !others.into_iter().any(|other| other.fish == gap.fish && on_bridge(other));
                    self.frames.get(i).filter(|frame| frame.number == number && free)?;
                    places.get(i)?.clone()
                };
                let from = before.checked_sub(1).and_then(|i| second(i, gap.first.wrapping_sub(2)));
                let from = from.map_or(straight.clone(), |r| (a.clone() - &r).scale(&steps));
                let to = second(after + 1, gap.first + gap.frames + 1);
                let to = to.map_or(straight, |r| (r - &b).scale(&steps));
                for (step, place) in (1u64..).zip(&mut places[before + 1..after]) {
                    let share = step as f64 / steps;
                    *place = Some(shape.at(share, [&a, &b], [&from, &to]));
                }
            }
        }
        self.bridged.extend(bridged);
        self.bridged_by = shape;
        self
    }

    /// For each frame, of how many fish the position lies on a bridge.
    pub fn on_bridges(&self) -> Vec<usize> {
        let place = |number: u64| self.frames.partition_point(|frame| frame.number < number);
        let mut count = vec![0; self.frames.len()];
        for gap in &self.bridged {
            count[place(gap.first)..place(gap.first + gap.frames)].iter_mut().for_each(|count| *count += 1);
        }
        count
    }
}
