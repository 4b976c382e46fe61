//! veerman.table1_theory, veerman.table1_numeric, veerman.table1.size, veerman.sec7.omega0, veerman.sec7.system: what
//! the columns of Table 1 are.

use super::{enclosed, gains, within};
use crate::prelude::*;
use crate::printed_decimal;
use arithmetic::Signed;
use models::platoon::{Communication, Gains, gain_squared_one_sided, resonance, strongest_one_sided_square, theorem1};
use runs::table1::{ROWS, Row};

const PRECISION: u32 = 120;

/// A column of the table.
type Column = fn(&Row) -> &'static str;

/// A frequency or an amplitude of so many followers.
type Quantity<'a> = &'a dyn Fn(u64) -> Result<Interval, CheckError>;

const TFREQ: (&str, Column) = ("TFREQ", |row| row.tfreq);
const TAMP: (&str, Column) = ("TAMP", |row| row.tamp);
const NFREQ: (&str, Column) = ("NFREQ", |row| row.nfreq);
const NAMP: (&str, Column) = ("NAMP", |row| row.namp);

/// The gains of the table, or with another `f`.
fn table_gains(f: i64) -> Gains<Rational> {
    gains(((f, 1), (-1, 1)))
}

/// Frequency and amplitude of the resonance of the table's gains.
fn truth(m: u64) -> Result<(Interval, Interval), CheckError> {
    let found = resonance(&table_gains(-1), m, 30)?;
    Ok((found.omega, found.amplitude))
}

/// How many cells of a column are the enclosed numbers of their rows, to within one unit of the last digit (the table truncates some cells
/// and rounds others), or so many, and the first one that is not.
fn compare_column(
    (name, column): (&str, Column),
    number: Quantity,
    (offset, units): (i64, i64),
) -> Result<(usize, Option<String>), CheckError> {
    let (mut agreeing, mut first) = (0, None);
    for row in &ROWS {
        let followers = row.n.saturating_add_signed(offset);
        let (enclosed, (value, unit)) = (number(followers)?, printed_decimal(column(row))?);
        if within(&enclosed, &value, &(unit * rational(units, 1))) {
            agreeing += 1;
        } else {
            let is = || interval_value(&enclosed, 12);
            let text = || {
                format!("N = {}: {name} prints {}, but for {followers} followers it is {}", row.n, column(row), is())
            };
            first = first.or_else(|| Some(text()));
        }
    }
    Ok((agreeing, first))
}

/// Two columns that are claimed to be a frequency and an amplitude.
#[derive(Clone, Copy)]
pub struct ColumnsVariant {
    columns: [(&'static str, Column); 2],
    /// Followers of a row: N plus the first of these, or N plus the second, the same for all rows.
    offsets: [i64; 2],
    f: i64,
}

/// Whether some offset makes every cell of both columns the given numbers; otherwise the first mismatches. The columns are clauses 1 and 2.
fn examine_columns(variant: &ColumnsVariant, numbers: [Quantity; 2], detail: &str) -> Result<Outcome, CheckError> {
    const PART: &str = "every cell of both columns";
    let mut mismatches = Vec::new();
    let mut offsets = variant.offsets.to_vec();
    offsets.dedup();
    let [(first, _), (second, _)] = variant.columns;
    for &offset in &offsets {
        let found = [0, 1].map(|k| compare_column(variant.columns[k], numbers[k], (offset, 1)));
        let [frequencies, amplitudes] = found;
        let (frequencies, amplitudes) = (frequencies?, amplitudes?);
        let agreeing = frequencies.0 + amplitudes.0;
        let followers = if offset == 0 { "N".to_string() } else { format!("N{offset:+}") };
        if agreeing == 2 * ROWS.len() {
            let detail = format!("{first} and {second}, {followers} followers: {detail}");
            return holds(certified(PART, detail).cases(agreeing).on([1, 2]).for_all());
        }
        mismatches.extend(frequencies.1);
        mismatches.extend(amplitudes.1);
        mismatches.push(format!("{agreeing} of {} cells agree for {followers} followers", 2 * ROWS.len()));
    }
    let evidence = certified(PART, detail).cases(2 * ROWS.len() * offsets.len()).on([1, 2]);
    Ok(Outcome::fails(mismatches.join("; "), evidence))
}

/// Whether the columns are the values of Theorem 1.
fn examine_theorem(variant: &ColumnsVariant) -> Result<Outcome, CheckError> {
    let gains = enclosed(&table_gains(variant.f), PRECISION);
    let numbers: [Quantity; 2] = [&|m| Ok(theorem1::frequency(&gains, m)?), &|m| Ok(theorem1::amplitude(&gains, m)?)];
    examine_columns(variant, numbers, "enclosures of the values of Theorem 1 against the printed digits")
}

pub fn theory_columns() -> Record<ColumnsVariant> {
    Record::new(
        "veerman.table1_theory",
        "Theorem 1 for f = g = -1 is omega = pi/(2 sqrt2 M), A = 8 sqrt2 M/pi². No cell of TFREQ or TAMP is one of these \
         values, for M = N + 1 or M = N; every cell of NFREQ and NAMP is, to within one unit of its last digit, for M = N followers. The \
         headings of the two pairs of columns are exchanged.",
        ColumnsVariant { columns: [TFREQ, TAMP], offsets: [1, 0], f: -1 },
        |variant, _| examine_theorem(variant),
    )
    .clauses(&[
        "Column TFREQ is the second order approximation of the frequency (Theorem 1, f = g = -1).",
        "Column TAMP is that of the amplitude.",
    ])
    .repaired(Fault::Typo, "", ColumnsVariant { columns: [NFREQ, NAMP], offsets: [0, 0], f: -1 })
    .repaired_clauses(&[
        "Column NFREQ is the second order approximation of the frequency (Theorem 1, f = g = -1, with N in the place of N + 1), to within one unit of the last printed digit.",
        "Column NAMP is that of the amplitude, in the same sense.",
    ])
    .altered("NFREQ, NAMP for N + 1 followers", |v| v.offsets = [1, 1])
    .altered("NFREQ with TAMP", |v| v.columns = [NFREQ, TAMP])
    .altered("f = -2", |v| v.f = -2)
}

/// Either the printed claim (the columns are the true resonance to their digits) or what can be said instead.
#[derive(Clone, Copy)]
pub enum NumericVariant {
    /// Every cell is the true resonance, to the printed digits.
    TrueResonance(ColumnsVariant),
    /// What is said in place of that.
    Deviations(DeviationsVariant),
}

/// What is said of TFREQ and TAMP, or two other columns, for N + `offset` followers.
#[derive(Clone, Copy)]
pub struct DeviationsVariant {
    columns: [(&'static str, Column); 2],
    offset: i64,
    /// No cell is the true resonance to within so many units of its last digit.
    units: i64,
    /// Largest relative deviations of the two columns in all rows and in the last one, in units of 10^-6.
    largest: [(i64, i64); 2],
}

fn relative_deviation(printed: &str, truth: &Interval) -> Result<Interval, CheckError> {
    let (value, _) = printed_decimal(printed)?;
    Ok((Interval::from_rational(&value, PRECISION) - truth).over(truth)?)
}

impl DeviationsVariant {
    const TRUE: Self =
        DeviationsVariant { columns: [TFREQ, TAMP], offset: 0, units: 1, largest: [(1400, 10), (35_300, 60)] };

    fn followers(&self, row: &Row) -> u64 {
        row.n.saturating_add_signed(self.offset)
    }

    /// No cell is correct: clause 1.
    fn no_cell(&self) -> Result<Outcome, CheckError> {
        let numbers: [Quantity; 2] = [&|m| Ok(truth(m)?.0), &|m| Ok(truth(m)?.1)];
        let mut correct = None;
        for (column, number) in [NFREQ, NAMP, TFREQ, TAMP].into_iter().zip(numbers.into_iter().cycle()) {
            if compare_column(column, number, (self.offset, self.units))?.0 > 0 {
                let (name, units) = (column.0, self.units);
                correct.get_or_insert(format!("a cell of {name} is correct to within {units} units of the last digit"));
            }
        }
        let part = "every cell against the true resonance of N followers";
        let evidence = certified(part, "enclosed to 30 digits").cases(4 * ROWS.len()).on([1]);
        unless(correct, evidence).for_all()
    }

    /// The printed frequencies are nearer to the resonance than to Theorem 1: clause 2.
    fn nearer(&self, run: &Run) -> Result<Outcome, CheckError> {
        let (name, column) = self.columns[0];
        let gains = enclosed(&table_gains(-1), PRECISION);
        let part = "TFREQ against the resonance and Theorem 1";
        let evidence = certified(part, "the true resonance enclosed to 30 digits").on([2]).for_all();
        run.every(evidence, &ROWS, |row| {
            let m = self.followers(row);
            let printed = Interval::from_rational(&printed_decimal(column(row))?.0, PRECISION);
            let to_theory = printed.clone() - theorem1::frequency(&gains, m)?;
            let to_truth = (printed - &truth(m)?.0).magnitude();
            let farther = to_truth >= to_theory.lo().absolute().min(to_theory.hi().absolute());
            Ok(farther.then(|| format!("N = {}: {name} is nearer to Theorem 1", row.n)))
        })
    }

    /// How far a column is from the resonance: clauses 3, and 4 where it is also said to be below.
    fn deviates(&self, of_amplitude: bool, run: &mut Run) -> Result<Outcome, CheckError> {
        let index = usize::from(of_amplitude);
        let (name, column) = self.columns[index];
        let (part, clause) = [("relative deviations of TFREQ", 3), ("relative deviations of TAMP", 4)][index];
        let mut rows = Vec::new();
        for row in &ROWS {
            let m = self.followers(row);
            let (omega, size) = truth(m)?;
            let (what, truth) = if of_amplitude { ("amplitude", size) } else { ("omega", omega) };
            let relative = relative_deviation(column(row), &truth)?;
            run.value(&format!("true_{what}_{m}_followers"), interval_value(&truth, 15));
            let name = format!("{}_relative_deviation_N_{}", name.to_lowercase(), row.n);
            run.value(&name, interval_value(&relative, 4));
            rows.push((row.n, relative));
        }
        let evidence = certified(part, "the true resonance enclosed to 30 digits").on([clause]).for_all();
        run.every(evidence, rows, |(n, relative)| {
            let (all, last) = self.largest[index];
            let bound = rational(if n == 128 { last } else { all }, 1_000_000);
            let far = !within(&relative, &rational(0, 1), &bound);
            let above = of_amplitude && !relative.is_certainly_negative();
            let what = || format!("N = {n}: the relative deviation of {name} is {}", interval_value(&relative, 4));
            Ok((far || above).then(what))
        })
    }
}

pub fn numeric_columns() -> Record<NumericVariant> {
    let printed = ColumnsVariant { columns: [NFREQ, NAMP], offsets: [1, 0], f: -1 };
    let exchanged = ColumnsVariant { columns: [TFREQ, TAMP], ..printed };
    let deviations = |change: fn(&mut DeviationsVariant)| {
        let mut said = DeviationsVariant::TRUE;
        change(&mut said);
        NumericVariant::Deviations(said)
    };
    Record::new(
        "veerman.table1_numeric",
        "The true resonance is enclosed rigorously (notes/resonance.md). NFREQ and NAMP are not its values, for N + 1 or N \
         followers; they are Theorem 1 (veerman.table1_theory). The other pair, TFREQ and TAMP, is what a simulation may have \
         given: TFREQ is nearer to the true frequency of N followers than to Theorem 1 in every row, but TAMP lies below the \
         true amplitude in every row, so neither column is correct to the digits it shows. By which procedure it came about \
         is not established here; beyond.veerman.table1_reading has one that comes close.",
        NumericVariant::TrueResonance(printed),
        |variant, run| match variant {
            NumericVariant::TrueResonance(columns) => {
                let numbers: [Quantity; 2] = [&|m| Ok(truth(m)?.0), &|m| Ok(truth(m)?.1)];
                examine_columns(columns, numbers, "enclosures of the true resonance against the printed digits")
            }
            NumericVariant::Deviations(said) => Run::all([
                said.no_cell(),
                said.nearer(run),
                said.deviates(false, run),
                said.deviates(true, run),
            ]),
        },
    )
    .reading("Every cell is the resonance to the digits printed (the text: \"we show only the relevant digits\").")
    .clauses(&[
        "Column NFREQ is the resonance frequency of the last member obtained through numerical simulations (f = g = -1).",
        "Column NAMP is its amplitude.",
    ])
    .repaired(Fault::False, "", NumericVariant::Deviations(DeviationsVariant::TRUE))
    .repaired_clauses(&[
        "No cell of Table 1 is the true resonance of N followers (f = g = -1) to within one unit of the last digit printed.",
        "TFREQ is nearer to the true resonance frequency of N followers than to Theorem 1 in every row.",
        "Its relative deviation is at most 0.14 % in all rows and 0.001 % at N = 128.",
        "TAMP is below the true resonance amplitude in every row, by at most 3.53 % in all rows and 0.006 % at N = 128.",
    ])
    .control("TFREQ, TAMP are the true resonance to their digits", NumericVariant::TrueResonance(exchanged))
    .control("the deviations for N - 1 followers", deviations(|v| v.offset = -1))
    .control("NFREQ in the place of TFREQ", deviations(|v| v.columns = [NFREQ, TAMP]))
    .control("no cell is within 1000 units of its last digit", deviations(|v| v.units = 1000))
    .control("0.13 % and 3.5 % in all rows", deviations(|v| v.largest = [(1300, 10), (35_000, 60)]))
    .control("0.0001 % and 0.005 % at N = 128", deviations(|v| v.largest = [(1400, 1), (35_300, 50)]))
}

pub fn size() -> Record<i64> {
    Record::new(
        "veerman.table1.size",
        "Every cell of NFREQ and NAMP is Theorem 1 with N in the place of the number of followers, and TFREQ is within 0.15 % \
         of the true resonance of N followers; for N + 1 followers all four columns are off by a factor of about (N + 1)/N. So \
         the rows refer to N followers, N + 1 cars with the leader.",
        1,
        |offset, run| {
            let columns = ColumnsVariant { columns: [NFREQ, NAMP], offsets: [*offset; 2], f: -1 };
            let leading = examine_theorem(&columns).on([1]);
            Run::all([near_the_resonance(*offset, run), leading])
        },
    )
    .reading("A row refers to a flock whose resonance, and Theorem 1 for it, are near the printed numbers.")
    .repaired(
        Fault::Typo,
        "The rows of Table 1 refer to flocks of size N+1 (including the leader), that is, N followers, with N the first column: the \
         resonance of such a flock, and Theorem 1 for it, are near the printed numbers.",
        0,
    )
    .control("N - 1 followers", -1)
    .control("N + 2 followers", 2)
}

/// TFREQ within 0.15 % of the true resonance frequency.
fn near_the_resonance(offset: i64, run: &Run) -> Result<Outcome, CheckError> {
    let part = "TFREQ within 0.15 % of the true resonance of N followers";
    run.every(certified(part, "enclosed to 30 digits").for_all(), &ROWS, |row| {
        let m = row.n.saturating_add_signed(offset);
        let (omega, _) = truth(m)?;
        let near = within(&relative_deviation(row.tfreq, &omega)?, &rational(0, 1), &rational(15, 10_000));
        let (n, tfreq, is) = (row.n, row.tfreq, interval_value(&omega, 12));
        Ok((!near).then(|| format!("N = {n}: TFREQ is {tfreq}, the resonance of {m} followers {is}")))
    })
}

/// `omega_0 = pi sqrt2/(4 (N + offset))` for this `f`.
#[derive(Clone, Copy)]
pub struct FirstGuessVariant {
    offset: i64,
    f: i64,
}

pub fn first_guess() -> Record<FirstGuessVariant> {
    Record::new(
        "veerman.sec7.omega0",
        "sqrt|f| pi/((N+1) 2 sqrt2) for f = -1 and pi sqrt2/(4(N+1)) are positive and have the squares pi²/(8 (N+1)²) and \
         2 pi²/(16 (N+1)²), which are equal.",
        FirstGuessVariant { offset: 1, f: -1 },
        |variant, run| {
            let gains = enclosed(&table_gains(variant.f), PRECISION);
            let detail = "the squares over pi² are equal rationals, and the square root meets Theorem 1; N = 1, 4, 128";
            run.instances("the squares", detail, [1i64, 4, 128], |n| {
                let theorem = rational(1, 8 * (n + 1) * (n + 1));
                let guess = rational(2, 1) / rational(4 * (n + variant.offset), 1).square();
                let root = Interval::from_rational(&guess, PRECISION).sqrt()?;
                let enclosed = root.pi() * root;
                if theorem != guess {
                    return Ok(Some(format!("N = {n}: the squares over pi² are {theorem} and {guess}")));
                }
                let frequency = theorem1::frequency(&gains, n as u64 + 1)?;
                let (found, is) = (interval_value(&enclosed, 8), interval_value(&frequency, 8));
                Ok((!enclosed.overlaps(&frequency)).then(|| format!("N = {n}: {found}, Theorem 1 has {is}")))
            })
        },
    )
    .altered("pi sqrt2/(4N)", |v| v.offset = 0)
    .altered("Theorem 1 for f = -2", |v| v.f = -2)
}

/// Which equation the experiments are claimed to concern, for N + `more` followers or a multiple.
#[derive(Clone, Copy)]
pub struct SystemVariant {
    communication: Communication,
    factor: u64,
    more: u64,
}

/// Frequency and amplitude at which the last of `m` cars responds most.
fn strongest(communication: Communication, m: u64) -> Result<(Interval, Interval), CheckError> {
    match communication {
        Communication::Front => {
            let intervals = enclosed(&table_gains(-1), PRECISION);
            let square = strongest_one_sided_square(&intervals)?;
            let gain = gain_squared_one_sided(&intervals, &square)?;
            Ok((square.sqrt()?, gain.power(m).sqrt()?))
        }
        Communication::FrontAndBack => truth(m),
    }
}

pub fn which_system() -> Record<SystemVariant> {
    Record::new(
        "veerman.sec7.system",
        "For system (1) and f = g = -1 the last of M cars responds most at w² = sqrt3 - 1, w = 0.8556, with amplitude \
         (1 + 2/sqrt3)^(M/2), about 10^21 for M = 128. Every frequency in Table 1 is below 0.28 and the largest amplitude is 147. \
         For system (2) the frequencies are within 2 % and the amplitudes within 4 % of the resonance of N followers. Section 3, \
         to which the text refers for the other system, treats system (1). So (1) and (2) are exchanged.",
        SystemVariant { communication: Communication::Front, factor: 1, more: 0 },
        |variant, run| {
            let reference =
                Evidence::new(Grade::Text, "the reference", "Section 3 treats system (1), Section 4 system (2)");
            Run::all([all_cells(variant, run), holds(reference)])
        },
    )
    .reading("The experiments concern the system whose resonance Table 1 shows.")
    .repaired_by(
        Fault::Typo,
        "The experiments reported on in detail in Section 7 all concern the system given by Equation (2); the \
         behavior of the system given by Equation (1) is relatively simple and is discussed in Section 3.",
        |v| v.communication = Communication::FrontAndBack,
    )
    .altered("system (2) with 2N followers", |v| v.factor = 2)
    .altered("system (2) with N + 1 followers", |v| v.more = 1)
}

/// All 24 cells are near the resonance of the claimed system.
fn all_cells(variant: &SystemVariant, run: &Run) -> Result<Outcome, CheckError> {
    let detail = "frequencies within 2 %, amplitudes within 4 % of the resonance of the claimed system, enclosed";
    let cases = ROWS.iter().flat_map(|row| [TFREQ, NFREQ, TAMP, NAMP].map(|column| (row, column)));
    run.every(certified("all 24 cells of Table 1", detail).for_all(), cases, |(row, (name, column))| {
        let (omega, amplitude) = strongest(variant.communication, variant.factor * row.n + variant.more)?;
        let (truth, percent) = if name.ends_with("FREQ") { (omega, 2) } else { (amplitude, 4) };
        let near = within(&relative_deviation(column(row), &truth)?, &rational(0, 1), &rational(percent, 100));
        let (n, printed, is) = (row.n, column(row), interval_value(&truth, 8));
        Ok((!near).then(|| format!("N = {n}: {name} is {printed}, the resonance of the claimed system {is}")))
    })
}
