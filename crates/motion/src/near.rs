//! The neighbours of all points of the plane within a radius, as lists.

use super::cells::{CellError, CellList};
use rayon::prelude::*;

/// Points whose neighbours one task looks up.
const TASK: usize = 256;

/// For each point the others at a distance up to a radius, in the order of their cells. O(N) for points that are spread evenly.
#[derive(Debug, Clone)]
pub struct NearLists {
    /// Where each point stands among the tasks' lists.
    places: Vec<usize>,
    tasks: Vec<Lists>,
}

#[derive(Debug, Clone, Default)]
struct Lists {
    /// Where each list begins, and the end of the last one.
    starts: Vec<usize>,
    numbers: Vec<usize>,
}

impl NearLists {
    /// Looks up all lists. The result does not depend on the number of threads.
    ///
    /// # Errors
    /// [`CellError`].
    pub fn new(points: &[[f64; 2]], radius: f64) -> Result<Self, CellError> {
        let cells = CellList::new(points, radius)?;
        let mut places = vec![0; points.len()];
        cells.numbers().iter().enumerate().for_each(|(place, &number)| places[number] = place);
        let task = |first: usize| {
            let mut lists = Lists { starts: vec![0], numbers: Vec::new() };
            for place in first..(first + TASK).min(points.len()) {
                cells.visit_up_to(place, radius, |other, _| lists.numbers.push(other));
                lists.starts.push(lists.numbers.len());
            }
            lists
        };
        let tasks = (0..points.len()).into_par_iter().step_by(TASK).map(task).collect();
        Ok(NearLists { places, tasks })
    }

    /// The neighbours of a point.
    pub fn of(&self, point: usize) -> &[usize] {
        let place = self.places[point];
        let (lists, k) = (&self.tasks[place / TASK], place % TASK);
        &lists.numbers[lists.starts[k]..lists.starts[k + 1]]
    }

    /// Leaves of each point's neighbours those that are meant, asked with both numbers.
    pub fn retain(&mut self, keep: impl Fn(usize, usize) -> bool) {
        let mut points = vec![0; self.places.len()];
        self.places.iter().enumerate().for_each(|(point, &place)| points[place] = point);
        for (lists, points) in self.tasks.iter_mut().zip(points.chunks(TASK)) {
            let old = std::mem::take(lists);
            lists.starts.push(0);
            for (ends, &point) in old.starts.windows(2).zip(points) {
                lists.numbers.extend(old.numbers[ends[0]..ends[1]].iter().filter(|other| keep(point, **other)));
                lists.starts.push(lists.numbers.len());
            }
        }
    }

    /// The number of points.
    pub fn points(&self) -> usize {
        self.places.len()
    }
}
