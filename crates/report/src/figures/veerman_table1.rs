//! Table 1 of Veerman, Stosic and Olvera beside our enclosures, as text, CSV and picture.

use super::Reproduced;
use crate::plot::{Axis, Panel, Picture, Series};
use arithmetic::{Field, Interval, Rational, decimal, decimals, parse_rational, rational};
use ledger::CheckError;
use models::platoon::{Gains, resonance, theorem1};
use runs::table1::{ROWS, Row};
use std::fmt::Write;

/// One printed cell with what it can be compared to.
#[derive(Debug, Clone)]
struct Cell {
    /// Heading of the column.
    column: &'static str,
    /// The printed digits.
    printed: &'static str,
    /// Enclosure of the relative deviation from the true resonance of N followers.
    from_truth: Interval,
    /// Enclosure of the relative deviation from Theorem 1 for N followers.
    from_theorem: Interval,
}

/// One row: the true resonance, Theorem 1, and the four printed cells.
#[derive(Debug, Clone)]
struct Table1Row {
    /// The first column; the number of followers (veerman.table1.size).
    n: u64,
    /// True frequency and amplitude.
    truth: [Interval; 2],
    /// Frequency and amplitude of Theorem 1.
    theorem: [Interval; 2],
    /// NFREQ, TFREQ, NAMP, TAMP.
    cells: [Cell; 4],
}

/// Table 1 with enclosures.
#[derive(Debug, Clone)]
struct Table1 {
    /// The six rows.
    rows: Vec<Table1Row>,
}

const PRECISION: u32 = 120;
const DIGITS: u32 = 12;

/// Computes every enclosure of the table (f = g = -1).
pub(super) fn reproduce() -> Result<Reproduced, CheckError> {
    let table = Table1 { rows: ROWS.iter().map(enclose).collect::<Result<_, _>>()? };
    Ok(Reproduced::new(table.text()).table("", table.csv()).picture("", table.picture()))
}

fn enclose(row: &Row) -> Result<Table1Row, CheckError> {
    let gains = Gains { f: rational(-1, 1), g: rational(-1, 1) };
    let found = resonance(&gains, row.n, 30)?;
    let intervals = gains.map(|q| Interval::from_rational(q, PRECISION));
    let truth = [found.omega.with_precision(PRECISION), found.amplitude.with_precision(PRECISION)];
    let theorem = [theorem1::frequency(&intervals, row.n)?, theorem1::amplitude(&intervals, row.n)?];
    let cell = |column, printed: &'static str, k: usize| -> Result<Cell, CheckError> {
        let value: Rational = parse_rational(printed).map_err(|error| CheckError::Other(error.to_string()))?;
        let value = Interval::from_rational(&value, PRECISION);
        let deviation = |from: &Interval| (value.clone() - from).over(from);
        Ok(Cell { column, printed, from_truth: deviation(&truth[k])?, from_theorem: deviation(&theorem[k])? })
    };
    let cells = [
        cell("NFREQ", row.nfreq, 0)?,
        cell("TFREQ", row.tfreq, 0)?,
        cell("NAMP", row.namp, 1)?,
        cell("TAMP", row.tamp, 1)?,
    ];
    Ok(Table1Row { n: row.n, truth, theorem, cells })
}

/// The midpoint of an enclosure to `digits` significant digits, rounded towards minus infinity.
fn shown(x: &Interval, digits: u32) -> String {
    let (lo, hi) = x.to_rationals();
    decimal(&((lo + hi) / rational(2, 1)), digits, false)
}

fn deviation(x: &Interval) -> String {
    format!("{:+.1e}", x.to_f64())
}

impl Table1 {
    /// The table for a terminal of 80 columns.
    fn text(&self) -> String {
        let mut text = String::from(
            "Table 1 (f = g = -1), each printed cell beside the certified resonance of N\n\
             followers and Theorem 1 with N followers; deviations are relative.\n\n",
        );
        for (k, name) in ["frequency", "amplitude"].into_iter().enumerate() {
            let columns = [self.heading(2 * k), self.heading(2 * k + 1)];
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{:>3} {name:>12}|{:>12} {:>17}|{:>12}", "", columns[0], "", columns[1]);
            let _ = writeln!(
                text,
                "{:>3} {:>12}|{:>12} {:>8} {:>8}|{:>12} {:>8} {:>8}",
                "N", "certified", "printed", "-cert.", "-Thm 1", "printed", "-cert.", "-Thm 1"
            );
            for row in &self.rows {
                let [left, right] = [&row.cells[2 * k], &row.cells[2 * k + 1]];
                let _ = writeln!(
                    text,
                    "{:>3} {:>12}|{:>12} {:>8} {:>8}|{:>12} {:>8} {:>8}",
                    row.n,
                    shown(&row.truth[k], 9),
                    left.printed,
                    deviation(&left.from_truth),
                    deviation(&left.from_theorem),
                    right.printed,
                    deviation(&right.from_truth),
                    deviation(&right.from_theorem),
                );
            }
            text.push('\n');
        }
        text.push_str(
            "NFREQ and NAMP are Theorem 1 to within a unit of the last digit, not\n\
             simulations; TFREQ and TAMP are not Theorem 1. More: explain\n\
             veerman.table1_theory, veerman.table1_numeric, veerman.table1.size\n",
        );
        text
    }

    fn heading(&self, k: usize) -> &'static str {
        self.rows.first().map_or("", |row| row.cells[k].column)
    }

    /// One line per printed cell, with outward rounded enclosures.
    fn csv(&self) -> String {
        let row = |row: &Table1Row, k: usize| {
            let cell = &row.cells[k];
            let mut fields = vec![row.n.to_string(), cell.column.to_string(), cell.printed.to_string()];
            let columns = [
                (&row.truth[k / 2], DIGITS),
                (&row.theorem[k / 2], DIGITS),
                (&cell.from_truth, 6),
                (&cell.from_theorem, 6),
            ];
            fields.extend(columns.into_iter().flat_map(|(x, digits)| <[String; 2]>::from(decimals(x, digits))));
            fields
        };
        super::csv(
            "N,column,printed,certified_lo,certified_hi,theorem1_lo,theorem1_hi,\
             deviation_from_certified_lo,deviation_from_certified_hi,deviation_from_theorem1_lo,deviation_from_theorem1_hi",
            self.rows.iter().flat_map(|r| (0..4).map(move |k| row(r, k))),
        )
    }

    /// Size of the relative deviation of each printed column from the certified resonance, against N.
    fn picture(&self) -> Picture {
        let mut panel = Panel::new(
            "",
            Axis::log("N (followers)").ticks(self.rows.iter().map(|row| row.n as f64).collect::<Vec<_>>()),
            Axis::log("relative deviation, absolute value"),
        );
        for k in 0..4 {
            let point = |row: &Table1Row| (row.n as f64, row.cells[k].from_truth.to_f64().abs());
            panel = panel.series(Series::joined(self.heading(k), self.rows.iter().map(point)));
        }
        Picture::new("Table 1: printed columns against the certified resonance").panel(panel)
    }
}
