//! Velocities and headings.

use super::{Smoothing, Tracks, Vector, smoothed};

/// Smoothed positions, velocities and headings, `[fish][frame]`.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// In the unit of the file; `None` where the window meets a gap or an end.
    pub smoothed: Vec<Vec<Option<Vector>>>,
    /// Unit of the file per second; `None` where the window meets a gap or an end.
    pub velocities: Vec<Vec<Option<Vector>>>,
    /// Unit vectors along the velocity; `None` also where the speed is at most the speed of a fish at rest.
    pub headings: Vec<Vec<Option<Vector>>>,
}

impl Motion {
    /// From smoothed positions. With the moving mean `s` the velocity is `v_i = (s_{i+1} - s_{i-1})/(2 dt)`, which is the mean over the window of
    /// the central differences of the positions. Nothing runs across a gap. A fish with a speed of at most `still` has no heading.
    pub fn new(tracks: &Tracks, smoothing: Smoothing, window: usize, still: f64) -> Motion {
        let of_fish = |fish| smoothed(tracks, fish, smoothing, window);
        let (smoothed, velocities): (Vec<_>, Vec<_>) = (0..tracks.fish()).map(of_fish).unzip();
        let heading = |v: &Option<Vector>| {
            let v = v.as_ref()?;
            let speed = v.norm_squared().sqrt();
            (speed > still).then(|| v.scale(&(1.0 / speed)))
        };
        let of_row = |row: &Vec<Option<Vector>>| row.iter().map(heading).collect();
        let headings = velocities.iter().map(of_row).collect();
        Motion { smoothed, velocities, headings }
    }
}
