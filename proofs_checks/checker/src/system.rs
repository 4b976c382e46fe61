//! A switched linear system `x' = A x + B u + c` as `motion` and `bound` have it.

use crate::Refusal;
use crate::matrix::Matrix;
use crate::read::Reader;
use num_bigint::{BigInt, Sign};

const LARGEST: usize = 200;

pub struct Mode {
    pub a: Matrix,
    /// None where there are no inputs.
    pub b: Option<Matrix>,
    pub c: Matrix,
}

pub struct System {
    pub states: usize,
    pub modes: Vec<Mode>,
    /// The least and the most of each state at the start.
    pub start: [Matrix; 2],
    /// The least and the most of each input; none where there are no inputs.
    pub limits: Option<[Matrix; 2]>,
    /// Not zero where an input keeps one value.
    pub kept: Vec<BigInt>,
}

impl System {
    pub fn read(reader: &mut Reader) -> Result<Self, Refusal> {
        let states = reader.count("states", 1, LARGEST)?;
        let inputs = reader.count("inputs", 0, LARGEST)?;
        let count = reader.count("modes", 1, LARGEST)?;
        let start = bounds(reader, ["start_least", "start_most"], states)?;
        let limits = if inputs > 0 { Some(bounds(reader, ["input_least", "input_most"], inputs)?) } else { None };
        let kept = if inputs > 0 { reader.matrix("constant", 1, inputs)?.entries } else { Vec::new() };
        let mut modes = Vec::new();
        for _ in 0..count {
            let a = reader.matrix("A", states, states)?;
            let b = if inputs > 0 { Some(reader.matrix("B", states, inputs)?) } else { None };
            modes.push(Mode { a, b, c: reader.matrix("c", 1, states)? });
        }
        Ok(System { states, modes, start, limits, kept })
    }

    /// Whether an input keeps one value.
    pub fn is_kept(&self, input: usize) -> bool {
        self.kept[input].sign() != Sign::NoSign
    }
}

/// The least and the most of each number.
fn bounds(reader: &mut Reader, names: [&str; 2], count: usize) -> Result<[Matrix; 2], Refusal> {
    Ok([reader.matrix(names[0], 1, count)?, reader.matrix(names[1], 1, count)?])
}
