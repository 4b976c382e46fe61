//! Matrices as files that other programs read: CSV, NumPy, Matrix Market, and one file of MATLAB's version 4 for several.

use super::File;
use std::fmt::Write;

/// A matrix of floats with a name, all rows of the same length.
#[derive(Debug, Clone, PartialEq)]
pub struct NamedMatrix {
    /// A letter, then letters and digits.
    pub name: &'static str,
    /// Its rows.
    pub rows: Vec<Vec<f64>>,
}

impl NamedMatrix {
    fn columns(&self) -> usize {
        self.rows.first().map_or(0, Vec::len)
    }

    /// The entries by columns.
    fn by_columns(&self) -> impl Iterator<Item = f64> + '_ {
        (0..self.columns()).flat_map(|j| self.rows.iter().map(move |row| row[j]))
    }
}

/// NAME.csv, NAME.npy and NAME.mtx for each matrix, and all of them in `all.mat`.
pub fn matrix_files(matrices: &[NamedMatrix]) -> Vec<File> {
    let file = |name: String, contents: Vec<u8>| File { name, contents };
    let mut files = Vec::new();
    for matrix in matrices {
        files.push(file(format!("{}.csv", matrix.name), csv(matrix).into_bytes()));
        files.push(file(format!("{}.npy", matrix.name), npy(matrix)));
        files.push(file(format!("{}.mtx", matrix.name), matrix_market(matrix).into_bytes()));
    }
    files.push(file("all.mat".to_string(), matrices.iter().flat_map(mat).collect()));
    files
}

/// Rows of shortest decimals that give the same floats, without a header.
fn csv(matrix: &NamedMatrix) -> String {
    let line = |row: &Vec<f64>| row.iter().map(|x| format!("{x:?}")).collect::<Vec<_>>().join(",") + "\n";
    matrix.rows.iter().map(line).collect()
}

/// NumPy's format 1.0: `numpy.load`.
fn npy(matrix: &NamedMatrix) -> Vec<u8> {
    let (rows, columns) = (matrix.rows.len(), matrix.columns());
    let mut header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({rows}, {columns}), }}");
    // The data begin at a multiple of 64 bytes, the 10 bytes before the header and its last newline included.
    while (10 + header.len() + 1) % 64 != 0 {
        header.push(' ');
    }
    header.push('\n');
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((header.len() as u16).to_le_bytes());
    bytes.extend(header.into_bytes());
    bytes.extend(matrix.rows.iter().flatten().flat_map(|x| x.to_le_bytes()));
    bytes
}

/// Matrix Market, all entries other than zero.
fn matrix_market(matrix: &NamedMatrix) -> String {
    let entries = matrix.rows.iter().zip(1..).flat_map(|(row, i)| row.iter().zip(1..).map(move |(x, j)| (i, j, *x)));
    let entries: Vec<(usize, usize, f64)> = entries.filter(|(_, _, x)| *x != 0.0).collect();
    let (rows, columns) = (matrix.rows.len(), matrix.columns());
    let mut text = format!("%%MatrixMarket matrix coordinate real general\n{rows} {columns} {}\n", entries.len());
    for (i, j, x) in entries {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{i} {j} {x:?}");
    }
    text
}

/// One matrix of a MAT-file of version 4: `load all.mat` in MATLAB and Octave, `scipy.io.loadmat`.
fn mat(matrix: &NamedMatrix) -> Vec<u8> {
    // Little-endian doubles, a full matrix; rows, columns, no imaginary part, the length of the name with its zero byte.
    let head = [0, matrix.rows.len() as u32, matrix.columns() as u32, 0, matrix.name.len() as u32 + 1];
    let mut bytes: Vec<u8> = head.into_iter().flat_map(u32::to_le_bytes).collect();
    bytes.extend(matrix.name.bytes().chain([0]));
    bytes.extend(matrix.by_columns().flat_map(f64::to_le_bytes));
    bytes
}
