//! Who may come near: agents in square cells, moved one by one.

/// An agent in its cell: where its piece of motion begins, and how far it goes on it.
#[derive(Debug, Clone, Copy)]
pub struct Place {
    pub agent: usize,
    pub anchor: [f64; 2],
    pub reach: f64,
}

/// Square cells of one width. Their columns and rows are counted modulo a power of two, so that the plane needs no bounds: agents far from each
/// other may share a cell, and the distance tells them apart.
#[derive(Debug, Clone)]
pub struct Cells {
    cells: Vec<Vec<Place>>,
    /// The cell of each agent.
    home: Vec<usize>,
    per_width: f64,
    /// Columns, which are as many as rows, less one.
    mask: i64,
}

impl Cells {
    /// No agents yet, room for so many.
    pub fn new(count: usize, width: f64) -> Self {
        // At least four, so that a cell and the eight around it are nine.
        let columns = ((count as f64).sqrt().ceil() as usize).next_power_of_two().max(4);
        let cells = vec![Vec::new(); columns * columns];
        Cells { cells, home: vec![usize::MAX; count], per_width: 1.0 / width, mask: columns as i64 - 1 }
    }

    fn corner(&self, [x, y]: [f64; 2]) -> (i64, i64) {
        ((x * self.per_width).floor() as i64, (y * self.per_width).floor() as i64)
    }

    fn number(&self, column: i64, row: i64) -> usize {
        ((row & self.mask) * (self.mask + 1) + (column & self.mask)) as usize
    }

    /// Puts an agent where it is now.
    pub fn put(&mut self, place: Place) {
        let (column, row) = self.corner(place.anchor);
        let cell = self.number(column, row);
        let home = self.home[place.agent];
        let found = self.cells.get(home).and_then(|old| old.iter().position(|other| other.agent == place.agent));
        match found {
            Some(k) if home == cell => {
                self.cells[cell][k] = place;
                return;
            }
            Some(k) => drop(self.cells[home].swap_remove(k)),
            None => {}
        }
        self.cells[cell].push(place);
        self.home[place.agent] = cell;
    }

    /// All in the cell of a point and the eight around it, and perhaps others.
    pub fn around(&self, point: [f64; 2]) -> impl Iterator<Item = &Place> {
        let (column, row) = self.corner(point);
        let offsets =
            (-1..=1).flat_map(move |dy| (-1..=1).map(move |dx| (column.wrapping_add(dx), row.wrapping_add(dy))));
        offsets.flat_map(move |(column, row)| &self.cells[self.number(column, row)])
    }

    /// All in the cells that a square of this half side around a point touches, and perhaps others; nobody twice.
    pub fn near(&self, point: [f64; 2], half: f64) -> impl Iterator<Item = &Place> {
        let (left, bottom) = self.corner(point.map(|x| x - half));
        let (right, top) = self.corner(point.map(|x| x + half));
        let whole_round = |from: i64, to: i64| from..=to.min(from.saturating_add(self.mask));
        let columns = whole_round(left, right);
        let cells = whole_round(bottom, top).flat_map(move |row| columns.clone().map(move |column| (column, row)));
        cells.flat_map(|(column, row)| &self.cells[self.number(column, row)])
    }
}
