//! Table 1 of Veerman, Stosic and Olvera beside our enclosures, as text, CSV and picture.

use super::PictureError;
use crate::arithmetic::{Field, Interval, Rational, decimal, decimals, parse_rational, rational};
use crate::ledger::CheckError;
use crate::platoon::table1::{ROWS, Row};
use crate::platoon::{Gains, resonance, theorem1};
use plotters::prelude::*;
use std::fmt::Write;

/// One printed cell with what it can be compared to.
#[derive(Debug, Clone)]
pub struct Cell {
    /// Heading of the column.
    pub column: &'static str,
    /// The printed digits.
    pub printed: &'static str,
    /// Enclosure of the relative deviation from the true resonance of N followers.
    pub from_truth: Interval,
    /// Enclosure of the relative deviation from Theorem 1 for N followers.
    pub from_theorem: Interval,
}

/// One row: the true resonance, Theorem 1, and the four printed cells.
#[derive(Debug, Clone)]
pub struct Table1Row {
    /// The first column; the number of followers (veerman.table1.size).
    pub n: u64,
    /// True frequency and amplitude.
    pub truth: [Interval; 2],
    /// Frequency and amplitude of Theorem 1.
    pub theorem: [Interval; 2],
    /// NFREQ, TFREQ, NAMP, TAMP.
    pub cells: [Cell; 4],
}

/// Table 1 with enclosures.
#[derive(Debug, Clone)]
pub struct Table1 {
    /// The six rows.
    pub rows: Vec<Table1Row>,
}

const PRECISION: u32 = 120;
const DIGITS: u32 = 12;

/// Computes every enclosure of the table (f = g = -1).
///
/// # Errors
/// [`CheckError`] where a resonance could not be enclosed.
pub fn table1() -> Result<Table1, CheckError> {
    Ok(Table1 { rows: ROWS.iter().map(enclose).collect::<Result<_, _>>()? })
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
    pub fn text(&self) -> String {
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
    pub fn csv(&self) -> String {
        let mut text = String::from(
            "N,column,printed,certified_lo,certified_hi,theorem1_lo,theorem1_hi,\
             deviation_from_certified_lo,deviation_from_certified_hi,deviation_from_theorem1_lo,deviation_from_theorem1_hi\n",
        );
        for row in &self.rows {
            for (k, cell) in row.cells.iter().enumerate() {
                let mut fields = vec![row.n.to_string(), cell.column.to_string(), cell.printed.to_string()];
                for (x, digits) in [
                    (&row.truth[k / 2], DIGITS),
                    (&row.theorem[k / 2], DIGITS),
                    (&cell.from_truth, 6),
                    (&cell.from_theorem, 6),
                ] {
                    let (lo, hi) = decimals(x, digits);
                    fields.extend([lo, hi]);
                }
                text.push_str(&fields.join(","));
                text.push('\n');
            }
        }
        text
    }

    /// Size of the relative deviation of each printed column from the certified resonance, against N, both logarithmic.
    ///
    /// # Errors
    /// [`PictureError::Drawing`].
    pub fn svg(&self) -> Result<String, PictureError> {
        let mut svg = String::new();
        let refuse = |error: String| PictureError::Drawing(error);
        let area = SVGBackend::with_string(&mut svg, (760, 520)).into_drawing_area();
        self.draw(&area).map_err(|error| refuse(error.to_string()))?;
        area.present().map_err(|error| refuse(error.to_string()))?;
        drop(area);
        Ok(svg)
    }

    fn draw<B: DrawingBackend>(
        &self,
        area: &DrawingArea<B, plotters::coord::Shift>,
    ) -> Result<(), DrawingAreaErrorKind<B::ErrorType>> {
        area.fill(&WHITE)?;
        let mut chart = ChartBuilder::on(area)
            .caption("Table 1: printed columns against the certified resonance", ("sans-serif", 18))
            .margin(14)
            .x_label_area_size(42)
            .y_label_area_size(70)
            .build_cartesian_2d((3.5f64..150.0).log_scale(), (3e-7f64..0.1).log_scale())?;
        chart
            .configure_mesh()
            .x_desc("N (followers)")
            .y_desc("relative deviation, absolute value")
            .label_style(("sans-serif", 13))
            .x_labels(5)
            .max_light_lines(0)
            .x_label_formatter(&|x| format!("{x:.0}"))
            .y_label_formatter(&|y| format!("{y:.0e}"))
            .draw()?;
        let colours = [RGBColor(0, 90, 160), RGBColor(200, 80, 0), RGBColor(0, 130, 90), RGBColor(150, 30, 110)];
        for (k, colour) in colours.into_iter().enumerate() {
            let point = |row: &Table1Row| (row.n as f64, row.cells[k].from_truth.to_f64().abs());
            let points: Vec<(f64, f64)> = self.rows.iter().map(point).collect();
            chart
                .draw_series(LineSeries::new(points.clone(), colour.stroke_width(2)))?
                .label(self.heading(k))
                .legend(move |(x, y)| PathElement::new(vec![(x, y), (x + 22, y)], colour.stroke_width(2)));
            chart.draw_series(points.into_iter().map(|p| Circle::new(p, 4, colour.filled())))?;
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperRight)
            .label_font(("sans-serif", 14))
            .background_style(WHITE)
            .border_style(BLACK)
            .draw()?;
        Ok(())
    }
}
