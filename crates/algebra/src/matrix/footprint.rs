//! Footprints: 0/1 matrices as bitsets.

/// Which entries of a matrix are not zero; each row is a bitset.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Footprint {
    rows: usize,
    cols: usize,
    words: usize,
    bits: Vec<u64>,
}

impl Footprint {
    /// The footprint whose entry `(i, j)`, counted from 0, is `f(i, j)`.
    pub fn from_fn(rows: usize, cols: usize, mut f: impl FnMut(usize, usize) -> bool) -> Self {
        let words = cols.div_ceil(64);
        let mut bits = vec![0; rows * words];
        for i in 0..rows {
            for j in (0..cols).filter(|&j| f(i, j)) {
                bits[i * words + j / 64] |= 1 << (j % 64);
            }
        }
        Footprint { rows, cols, words, bits }
    }

    /// The footprint with so many columns that has these ones in its rows.
    pub(crate) fn from_ones(cols: usize, rows: impl ExactSizeIterator<Item = impl Iterator<Item = usize>>) -> Self {
        let (count, words) = (rows.len(), cols.div_ceil(64));
        let mut bits = vec![0; count * words];
        for (i, row) in rows.enumerate() {
            row.for_each(|j| bits[i * words + j / 64] |= 1 << (j % 64));
        }
        Footprint { rows: count, cols, words, bits }
    }

    /// The columns with a one in row `i`, in order.
    pub(crate) fn ones(&self, i: usize) -> impl Iterator<Item = usize> {
        self.row(i).iter().enumerate().flat_map(|(word, &bits)| {
            // Without the last one, again and again.
            std::iter::successors(Some(bits), |&bits| Some(bits & bits.wrapping_sub(1)))
                .take_while(|&bits| bits != 0)
                .map(move |bits| word * 64 + bits.trailing_zeros() as usize)
        })
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Whether entry `(i, j)`, counted from 0, is not zero; outside the matrix there are only zeros.
    pub fn get(&self, i: usize, j: usize) -> bool {
        i < self.rows && j < self.cols && self.bits[i * self.words + j / 64] >> (j % 64) & 1 == 1
    }

    fn row(&self, i: usize) -> &[u64] {
        &self.bits[i * self.words..(i + 1) * self.words]
    }

    /// The footprint of a product of non-negative matrices with these footprints; where `right` has fewer rows than this has
    /// columns, rows of zeros make up for them.
    pub fn times(&self, right: &Self) -> Self {
        let mut bits = vec![0u64; self.rows * right.words];
        for i in 0..self.rows {
            let out = &mut bits[i * right.words..(i + 1) * right.words];
            for k in self.ones(i).take_while(|&k| k < right.rows) {
                out.iter_mut().zip(right.row(k)).for_each(|(word, &other)| *word |= other);
            }
        }
        Footprint { rows: self.rows, cols: right.cols, words: right.words, bits }
    }

    /// The ones of both; where `other` has another shape, those of it that lie outside are left out.
    pub fn or(&self, other: &Self) -> Self {
        if (self.rows, self.cols) != (other.rows, other.cols) {
            return Footprint::from_fn(self.rows, self.cols, |i, j| self.get(i, j) || other.get(i, j));
        }
        let bits = self.bits.iter().zip(&other.bits).map(|(a, b)| a | b).collect();
        Footprint { bits, ..*self }
    }

    /// Whether some column is reached from all rows along the ones, `i` to `j` for a one at `(i, j)`: whether some bird is heard by all,
    /// through others.
    pub fn is_rooted(&self) -> bool {
        let mut reached = self.closed();
        // Paths of up to so many arcs as there are rows.
        for _ in 0..self.rows.next_power_of_two().ilog2() {
            reached = reached.times(&reached);
        }
        (0..self.cols).any(|root| (0..self.rows).all(|i| reached.get(i, root)))
    }

    /// Whether `other` has the same shape and every one of it is a one here too.
    pub fn contains(&self, other: &Self) -> bool {
        let same_shape = (self.rows, self.cols) == (other.rows, other.cols);
        same_shape && self.bits.iter().zip(&other.bits).all(|(&a, &b)| b & !a == 0)
    }

    /// Whether the footprint is square and equal to its transpose.
    pub fn is_symmetric(&self) -> bool {
        self.rows == self.cols && (0..self.rows).all(|i| (0..i).all(|j| self.get(i, j) == self.get(j, i)))
    }

    /// Whether every diagonal entry is a one.
    pub fn has_full_diagonal(&self) -> bool {
        (0..self.rows.min(self.cols)).all(|i| self.get(i, i))
    }

    /// With ones on the diagonal too.
    fn closed(&self) -> Self {
        let mut closed = self.clone();
        (0..self.rows.min(self.cols)).for_each(|i| closed.bits[i * self.words + i / 64] |= 1 << (i % 64));
        closed
    }

    /// The square submatrix with these rows and columns, counted from 0.
    pub fn restricted(&self, to: &[usize]) -> Self {
        if self.rows == self.cols && to.iter().copied().eq(0..self.rows) {
            return self.clone();
        }
        // By the ones, of which a network has few.
        let mut places = vec![Vec::new(); self.cols];
        for (place, &j) in to.iter().enumerate().filter(|(_, j)| **j < self.cols) {
            places[j].push(place);
        }
        let words = to.len().div_ceil(64);
        let mut bits = vec![0; to.len() * words];
        for (row, &i) in bits.chunks_mut(words.max(1)).zip(to).filter(|(_, i)| **i < self.rows) {
            for &place in self.ones(i).flat_map(|j| &places[j]) {
                row[place / 64] |= 1 << (place % 64);
            }
        }
        Footprint { rows: to.len(), cols: to.len(), words, bits }
    }

    /// The rows with a one in column `j`, counted from 0, in order.
    pub fn column(&self, j: usize) -> Vec<usize> {
        (0..self.rows).filter(|&i| self.get(i, j)).collect()
    }
}

impl std::fmt::Display for Footprint {
    /// Rows of 0 and 1, separated by spaces.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for i in 0..self.rows {
            let row: String = (0..self.cols).map(|j| if self.get(i, j) { '1' } else { '0' }).collect();
            write!(f, "{}{row}", if i == 0 { "" } else { " " })?;
        }
        Ok(())
    }
}
