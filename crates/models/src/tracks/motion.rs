//! Smoothed positions, velocities and headings.

use super::{Tracks, Vector};
use arithmetic::Complex;

/// Velocities and headings, `[fish][frame]`.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// Unit of the file per second; `None` where the window meets a gap or an end.
    pub velocities: Vec<Vec<Option<Vector>>>,
    /// Unit vectors along the velocity; `None` also where the speed is at most the speed of a fish at rest.
    pub headings: Vec<Vec<Option<Vector>>>,
}

/// Whether the frames next to frame `i` are `i - 1` and `i + 1` on the grid too.
fn inside_a_run(tracks: &Tracks, i: usize) -> bool {
    let number = |i: usize| tracks.frames.get(i).map(|frame| frame.number);
    let next = |i: usize| number(i).and_then(|n| n.checked_add(1));
    i > 0 && next(i - 1) == number(i) && next(i).is_some() && next(i) == number(i + 1)
}

/// Positions of one fish averaged over `window` frames (odd) around each; `None` where the window is not filled without a gap. A
/// fish that is not there has no positions.
pub fn smoothed(tracks: &Tracks, fish: usize, window: usize) -> Vec<Option<Vector>> {
    let places: &[Option<Vector>] = tracks.positions.get(fish).map_or(&[], Vec::as_slice);
    let half = window / 2;
    let average = |i: usize| {
        let (from, to) = (i.checked_sub(half)?, i.checked_add(half)?);
        let (first, last) = (tracks.frames.get(from)?, tracks.frames.get(to)?);
        if last.number.checked_sub(first.number)? != 2 * half as u64 {
            return None;
        }
        let mut sum = Complex::new(0.0, 0.0);
        for r in places.get(from..=to)? {
            sum = sum + r.as_ref()?;
        }
        Some(sum.scale(&(1.0 / (2 * half + 1) as f64)))
    };
    (0..places.len()).map(average).collect()
}

impl Motion {
    /// Central differences of the smoothed positions: `v_i = (s_{i+1} - s_{i-1})/(2 dt)`, which is the mean over the window of the
    /// central differences of the positions. No window and no difference runs across a gap. A fish with a speed of at most
    /// `still` has no heading.
    pub fn new(tracks: &Tracks, window: usize, still: f64) -> Motion {
        let scale = 0.5 / tracks.step;
        let velocities: Vec<Vec<Option<Vector>>> = (0..tracks.fish())
            .map(|fish| {
                let s = smoothed(tracks, fish, window);
                let velocity = |i: usize| {
                    if !inside_a_run(tracks, i) || s[i].is_none() {
                        return None;
                    }
                    Some((s.get(i + 1)?.clone()? - s[i - 1].as_ref()?).scale(&scale))
                };
                (0..s.len()).map(velocity).collect()
            })
            .collect();
        let heading = |v: &Option<Vector>| {
            let v = v.as_ref()?;
            let speed = v.norm_squared().sqrt();
            (speed > still).then(|| v.scale(&(1.0 / speed)))
        };
        let headings = velocities.iter().map(|row| row.iter().map(heading).collect()).collect();
        Motion { velocities, headings }
    }
}
