//! Short gaps bridged by straight lines.

use super::{Frame, Gap, Tracks, gaps};
use std::collections::BTreeSet;

impl Tracks {
    /// The recording with every gap of at most so many frames bridged: on the straight line from the last position before it to the first
    /// one after it, at a constant velocity. A gap at the start or the end of the recording has no such line and stays. Frames without
    /// any row that a bridge crosses are added. What was bridged is in [`Tracks::bridged`].
    pub fn bridge(mut self, longest: u64) -> Tracks {
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
        for gap in &bridged {
            let place = |number: u64| self.frames.binary_search_by_key(&number, |frame| frame.number).ok();
            // The frames of a bridge and the two at its ends are there, in a row.
            let Some((before, after)) = gap.first.checked_sub(1).and_then(place).zip(place(gap.first + gap.frames))
            else {
                continue;
            };
            let places = &mut self.positions[gap.fish];
            if let (Some(a), Some(b)) = (places[before].clone(), places[after].clone()) {
                let steps = (gap.frames + 1) as f64;
                for (k, place) in (1u64..).zip(&mut places[before + 1..after]) {
                    let share = k as f64 / steps;
                    *place = Some(a.scale(&(1.0 - share)) + &b.scale(&share));
                }
            }
        }
        self.bridged.extend(bridged);
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
