//! Arrays as files that other programs read: CSV, NumPy, Matrix Market, one file of MATLAB's version 4 for several matrices, one NPZ for
//! several arrays.

use super::file::File;
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
        let data = matrix.rows.iter().flatten().copied();
        files.push(file(format!("{}.npy", matrix.name), npy(&[matrix.rows.len(), matrix.columns()], data)));
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
fn npy(shape: &[usize], data: impl Iterator<Item = f64>) -> Vec<u8> {
    let mut lengths = shape.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
    // One length alone is a tuple only with a comma.
    lengths.extend((shape.len() == 1).then_some(','));
    let mut header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({lengths}), }}");
    // The data begin at a multiple of 64 bytes, the 10 bytes before the header and its last newline included.
    while (10 + header.len() + 1) % 64 != 0 {
        header.push(' ');
    }
    header.push('\n');
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((header.len() as u16).to_le_bytes());
    bytes.extend(header.into_bytes());
    bytes.extend(data.flat_map(f64::to_le_bytes));
    bytes
}

/// An array of floats with a name.
#[derive(Debug, Clone, PartialEq)]
pub struct NamedArray {
    /// Letters, digits and underscores.
    pub name: String,
    /// The lengths of its axes.
    pub shape: Vec<usize>,
    /// Its entries, the last axis going fastest.
    pub data: Vec<f64>,
}

/// All arrays in one file for `numpy.load`: a ZIP archive of NPY files, not compressed. At most 4 GiB and 65535 arrays fit.
pub fn npz(arrays: &[NamedArray]) -> Vec<u8> {
    let (mut bytes, mut directory) = (Vec::new(), Vec::new());
    for array in arrays {
        let (name, contents) = (format!("{}.npy", array.name), npy(&array.shape, array.data.iter().copied()));
        let (sum, size, place) = (crc32fast::hash(&contents), contents.len() as u32, bytes.len() as u32);
        // Version 2.0, stored, the first of January 1980 at midnight: the same arrays give the same bytes.
        let mut common = Vec::new();
        [20u16, 0, 0, 0, 0x21].into_iter().for_each(|x| common.extend(x.to_le_bytes()));
        [sum, size, size].into_iter().for_each(|x| common.extend(x.to_le_bytes()));
        [name.len() as u16, 0].into_iter().for_each(|x| common.extend(x.to_le_bytes()));
        bytes.extend(b"PK\x03\x04");
        bytes.extend(&common);
        bytes.extend(name.bytes());
        bytes.extend(contents);
        directory.extend(b"PK\x01\x02\x14\x00");
        directory.extend(&common);
        // No comment, on the first disk, binary, no attributes.
        directory.extend([0; 10]);
        directory.extend(place.to_le_bytes());
        directory.extend(name.bytes());
    }
    let (count, start) = (arrays.len() as u16, bytes.len() as u32);
    bytes.extend(&directory);
    bytes.extend(b"PK\x05\x06\x00\x00\x00\x00");
    [count, count].into_iter().for_each(|x| bytes.extend(x.to_le_bytes()));
    [directory.len() as u32, start].into_iter().for_each(|x| bytes.extend(x.to_le_bytes()));
    bytes.extend([0; 2]);
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
