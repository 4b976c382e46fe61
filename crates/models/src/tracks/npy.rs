//! Arrays of NumPy (`.npy`) with positions of shape (frames, fish, 2); NaN where a fish was not seen.

use super::read::{LARGEST, Row, TracksError, shown};
use super::{Form, Format, Tracks};
use arithmetic::Complex;

/// How such a file begins.
const MAGIC: &[u8] = b"\x93NUMPY";

/// What the header says.
struct Header {
    bytes_each: usize,
    is_big_endian: bool,
    /// Whether the first index runs fastest.
    is_fortran: bool,
    shape: [usize; 3],
}

impl Tracks {
    /// Whether a file is an array of NumPy.
    pub fn is_npy(bytes: &[u8]) -> bool {
        bytes.starts_with(MAGIC)
    }

    /// Reads an array of floats of shape (frames, fish, 2); fish are called 1, 2, .., and the format has the frames per second.
    ///
    /// # Errors
    /// [`TracksError`].
    pub fn from_npy(bytes: &[u8], format: &Format) -> Result<Tracks, TracksError> {
        // What cannot be read at all is said before what is missing beside it.
        let (header, data) = header(bytes)?;
        let [frames, fish, _] = header.shape;
        let values = floats(&header, data)?;
        let Some(rate) = format.fps else { return Err(TracksError::NoRate { form: Form::Array.words() }) };
        if format.part.is_some() || format.least_score > 0.0 {
            return Err(TracksError::NoParts { form: Form::Array.words() });
        }
        let place = |frame: usize, k: usize, axis: usize| match header.is_fortran {
            false => (frame * fish + k) * 2 + axis,
            true => (axis * fish + k) * frames + frame,
        };
        let mut rows = Vec::new();
        for frame in 0..frames {
            for k in 0..fish {
                let [x, y] = [0, 1].map(|axis| values[place(frame, k, axis)]);
                if x.is_nan() || y.is_nan() {
                    continue;
                }
                if !(x.abs() <= LARGEST && y.abs() <= LARGEST) {
                    return Err(array(format!("fish {} in frame {frame} is at ({x}, {y}), beyond 1e100", k + 1)));
                }
                let (id, place) = ((k + 1).to_string(), Complex::new(x, y));
                rows.push(Row { line: frame as u64 + 1, time: frame as f64 / rate, date: None, id, place });
            }
        }
        if rows.is_empty() {
            return Err(array("no fish was seen in any frame".to_string()));
        }
        Ok(Tracks { form: Form::Array, ..Tracks::from_rows(&rows)? })
    }
}

fn array(what: String) -> TracksError {
    TracksError::Array { what }
}

/// The header and the bytes after it.
fn header(bytes: &[u8]) -> Result<(Header, &[u8]), TracksError> {
    let cut = || array("it is cut short".to_string());
    let length = |from: usize, size: usize| -> Result<usize, TracksError> {
        let bytes = bytes.get(from..from + size).ok_or_else(cut)?;
        Ok(bytes.iter().rev().fold(0, |length, byte| length << 8 | usize::from(*byte)))
    };
    // Versions from 2 on have a longer number.
    let version = *bytes.get(MAGIC.len()).ok_or_else(cut)?;
    let size = if version == 1 { 2 } else { 4 };
    let from = MAGIC.len() + 2 + size;
    let end = from.saturating_add(length(MAGIC.len() + 2, size)?);
    let text = std::str::from_utf8(bytes.get(from..end).ok_or_else(cut)?);
    let text = text.map_err(|_| array("its header is no text".to_string()))?;
    let descr = after(text, "descr").and_then(|rest| rest.split(['\'', '"']).nth(1)).unwrap_or("");
    let (bytes_each, is_big_endian) = match descr {
        "<f8" => (8, false),
        ">f8" => (8, true),
        "<f4" => (4, false),
        ">f4" => (4, true),
        "|O" => {
            let what = "it holds objects of Python; flockproof.tracks in Python reads those of idtracker.ai, without running them";
            return Err(array(what.to_string()));
        }
        other => return Err(array(format!("its numbers are `{}`; floats are needed (<f8 or <f4)", shown(other, 40)))),
    };
    let is_fortran = after(text, "fortran_order").is_some_and(|rest| rest.trim_start().starts_with("True"));
    let listed = after(text, "shape").and_then(|rest| Some(rest.split_once('(')?.1.split_once(')')?.0)).unwrap_or("");
    let shape: Option<Vec<usize>> =
        listed.split(',').map(str::trim).filter(|size| !size.is_empty()).map(|size| size.parse().ok()).collect();
    match shape.as_deref() {
        Some(&[frames, fish, 2]) => {
            Ok((Header { bytes_each, is_big_endian, is_fortran, shape: [frames, fish, 2] }, &bytes[end..]))
        }
        _ => Err(array(format!("its shape is ({}); (frames, fish, 2) is needed", shown(listed, 40)))),
    }
}

/// What follows a key of the header.
fn after<'a>(text: &'a str, key: &str) -> Option<&'a str> {
    let (_, rest) = text.split_once(key)?;
    Some(rest.split_once(':')?.1)
}

fn floats(header: &Header, data: &[u8]) -> Result<Vec<f64>, TracksError> {
    let count = header.shape.iter().try_fold(1usize, |count, size| count.checked_mul(*size));
    let expected = count.and_then(|count| count.checked_mul(header.bytes_each));
    if expected != Some(data.len()) {
        let [frames, fish, axes] = header.shape;
        return Err(array(format!("{} bytes are no array of shape ({frames}, {fish}, {axes})", data.len())));
    }
    let one = |bytes: &[u8]| {
        let mut bits = [0u8; 8];
        bits[..bytes.len()].copy_from_slice(bytes);
        if header.is_big_endian {
            bits[..bytes.len()].reverse();
        }
        match bytes.len() {
            4 => f64::from(f32::from_le_bytes([bits[0], bits[1], bits[2], bits[3]])),
            _ => f64::from_le_bytes(bits),
        }
    };
    Ok(data.chunks_exact(header.bytes_each).map(one).collect())
}
