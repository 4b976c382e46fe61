//! veerman.table1_theory, veerman.table1_numeric, veerman.table1.size, veerman.sec7.omega0, veerman.sec7.system: what
//! the columns of Table 1 are.

use crate::printed_decimal;
use arithmetic::{Interval, Rational, Real, Ring, Signed, rational};
use ledger::{CheckError, Claim, Control, Evidence, Fault, Grade, Outcome, Repair, Run, interval_value};
use models::platoon::table1::{ROWS, Row};
use models::platoon::{Communication, Gains, gain_squared_one_sided, resonance, strongest_one_sided_square, theorem1};

const PRECISION: u32 = 120;

/// A column of the table.
type Column = fn(&Row) -> &'static str;

/// The gains of the table.
fn gains(f: i64) -> Gains<Rational> {
    Gains { f: rational(f, 1), g: rational(-1, 1) }
}

fn in_intervals(gains: &Gains<Rational>) -> Gains<Interval> {
    gains.map(|q| Interval::from_rational(q, PRECISION))
}

/// Whether the enclosed number is the printed decimal to within one unit of its last digit: the table truncates some
/// cells and rounds others.
fn is_printed(x: &Interval, printed: &str) -> Result<bool, CheckError> {
    let (value, unit) = printed_decimal(printed)?;
    let (lo, hi) = x.to_rationals();
    Ok(value.clone() - &unit <= lo && hi <= value + unit)
}

/// How many cells of a column are the enclosed numbers of their rows, and the first one that is not.
fn compare_column(
    column: Column,
    name: &str,
    number: impl Fn(u64) -> Result<Interval, CheckError>,
    offset: i64,
) -> Result<(usize, Option<String>), CheckError> {
    let (mut agreeing, mut first) = (0, None);
    for row in &ROWS {
        let followers = row.n.saturating_add_signed(offset);
        let enclosed = number(followers)?;
        if is_printed(&enclosed, column(row))? {
            agreeing += 1;
        } else if first.is_none() {
            let value = interval_value(&enclosed, 12);
            let text =
                format!("N = {}: {name} prints {}, but for {followers} followers it is {value}", row.n, column(row));
            first = Some(text);
        }
    }
    Ok((agreeing, first))
}

fn certified(part: &str, detail: &str) -> Evidence {
    Evidence::new(Grade::Certified, part, detail).cases(2 * ROWS.len())
}

/// Two columns that are claimed to hold a frequency and an amplitude.
#[derive(Clone, Copy)]
pub struct ColumnsVariant {
    names: (&'static str, &'static str),
    columns: (Column, Column),
    /// Followers of a row: N plus the first of these, or N plus the second, the same for all rows.
    offsets: [i64; 2],
    f: i64,
}

fn swapped(variant: ColumnsVariant) -> ColumnsVariant {
    if variant.names == THEORY {
        ColumnsVariant { names: NUMERIC, columns: (|row| row.nfreq, |row| row.namp), ..variant }
    } else {
        ColumnsVariant { names: THEORY, columns: (|row| row.tfreq, |row| row.tamp), ..variant }
    }
}

const THEORY: (&str, &str) = ("TFREQ", "TAMP");
const NUMERIC: (&str, &str) = ("NFREQ", "NAMP");

/// Whether some offset makes every cell of both columns the given numbers; otherwise the first mismatches.
fn examine_columns(
    variant: &ColumnsVariant,
    frequency: impl Fn(u64) -> Result<Interval, CheckError>,
    amplitude: impl Fn(u64) -> Result<Interval, CheckError>,
    detail: &str,
) -> Result<Outcome, CheckError> {
    let mut mismatches = Vec::new();
    let mut offsets = variant.offsets.to_vec();
    offsets.dedup();
    let cases = 2 * ROWS.len() * offsets.len();
    for offset in offsets {
        let frequencies = compare_column(variant.columns.0, variant.names.0, &frequency, offset)?;
        let amplitudes = compare_column(variant.columns.1, variant.names.1, &amplitude, offset)?;
        let agreeing = frequencies.0 + amplitudes.0;
        let followers = if offset == 0 { "N".to_string() } else { format!("N{offset:+}") };
        if agreeing == 2 * ROWS.len() {
            let part = format!("{} and {}, every cell, {followers} followers", variant.names.0, variant.names.1);
            return Ok(Outcome::Holds(vec![certified(&part, detail)]));
        }
        mismatches.extend(frequencies.1);
        mismatches.extend(amplitudes.1);
        mismatches.push(format!("{agreeing} of {} cells agree for {followers} followers", 2 * ROWS.len()));
    }
    let evidence = certified("cell by cell", detail);
    Ok(Outcome::Fails { counterexample: mismatches.join("; "), evidence: vec![evidence.cases(cases)] })
}

/// Whether the columns are the values of Theorem 1.
fn examine_theorem(variant: &ColumnsVariant) -> Result<Outcome, CheckError> {
    let gains = in_intervals(&gains(variant.f));
    examine_columns(
        variant,
        |m| Ok(theorem1::frequency(&gains, m)?),
        |m| Ok(theorem1::amplitude(&gains, m)?),
        "enclosures of the values of Theorem 1 against the printed digits",
    )
}

/// veerman.table1_theory.
pub struct TheoryColumns;

impl Claim for TheoryColumns {
    type Variant = ColumnsVariant;

    fn id(&self) -> &str {
        "veerman.table1_theory"
    }

    fn derivation(&self) -> &str {
        "Theorem 1 for f = g = -1 is omega = pi/(2 sqrt2 M), A = 8 sqrt2 M/pi². No cell of TFREQ or TAMP is one of these \
         values, for M = N + 1 or M = N; every cell of NFREQ and NAMP is, to within one unit of its last digit, for M = N followers. The \
         headings of the two pairs of columns are exchanged."
    }

    fn printed(&self) -> ColumnsVariant {
        ColumnsVariant { names: THEORY, columns: (|row| row.tfreq, |row| row.tamp), offsets: [1, 0], f: -1 }
    }

    fn repair(&self) -> Option<Repair<ColumnsVariant>> {
        Some(Repair {
            fault: Fault::Slip, clauses: Vec::new(),
            statement: "Columns NFREQ and NAMP are the second order approximation values (Theorem 1, f = g = -1, with N in the \
                        place of N + 1), to within one unit of the last printed digit: the headings are exchanged."
                .to_string(),
            variant: ColumnsVariant { offsets: [0, 0], ..swapped(self.printed()) },
        })
    }

    fn controls(&self) -> Vec<Control<ColumnsVariant>> {
        let repaired = swapped(self.printed());
        vec![
            Control::new("NFREQ, NAMP for N + 1 followers", ColumnsVariant { offsets: [1, 1], ..repaired }),
            Control::new("NFREQ with TAMP", ColumnsVariant { columns: (|row| row.nfreq, |row| row.tamp), ..repaired }),
            Control::new("f = -2", ColumnsVariant { f: -2, ..repaired }),
        ]
    }

    fn examine(&self, variant: &ColumnsVariant, _: &mut Run) -> Result<Outcome, CheckError> {
        examine_theorem(variant)
    }
}

/// veerman.table1_numeric.
pub struct NumericColumns;

/// Either the printed claim (the columns are the true resonance to their digits) or what can be said instead.
#[derive(Clone, Copy)]
pub enum NumericVariant {
    /// Every cell is the true resonance, to the printed digits.
    TrueResonance(ColumnsVariant),
    /// TFREQ is nearer to the true resonance than to Theorem 1 in every row, TAMP below the true amplitude, with these
    /// bounds of the relative deviations (in units of 10^-5) in all rows and at N = 128; neither is exact.
    Deviations {
        /// Offset of the number of followers.
        offset: i64,
        /// Of TFREQ.
        frequency: (i64, i64),
        /// Of TAMP.
        amplitude: (i64, i64),
    },
}

fn relative_deviation(printed: &str, truth: &Interval) -> Result<Interval, CheckError> {
    let (value, _) = printed_decimal(printed)?;
    let difference = Interval::from_rational(&value, PRECISION) - truth;
    Ok(arithmetic::Field::over(&difference, truth)?)
}

/// What holds of TFREQ and TAMP.
fn examine_deviations(
    offset: i64,
    frequency: (i64, i64),
    amplitude: (i64, i64),
    run: &mut Run,
) -> Result<Outcome, CheckError> {
    let intervals = in_intervals(&gains(-1));
    let within = |deviation: &Interval, bound: i64| {
        let limit = Interval::from_rational(&rational(bound, 100_000), PRECISION);
        (limit.clone() - deviation).is_certainly_positive() && (limit + deviation).is_certainly_positive()
    };
    let detail = "the true resonance enclosed to 30 digits";
    let fails = |what: String| Ok(Outcome::fails(what, certified("deviations", detail)));
    let truth = |m: u64| Ok::<_, CheckError>(resonance(&gains(-1), m, 30)?);
    let frequencies = compare_column(|row| row.tfreq, "TFREQ", |m| truth(m).map(|found| found.omega), offset)?;
    let amplitudes = compare_column(|row| row.tamp, "TAMP", |m| truth(m).map(|found| found.amplitude), offset)?;
    if frequencies.0 + amplitudes.0 > 0 {
        return fails("a cell is correct to the digits printed".to_string());
    }
    for row in &ROWS {
        run.checkpoint()?;
        let m = row.n.saturating_add_signed(offset);
        let truth = truth(m)?;
        let (omega, size) =
            (relative_deviation(row.tfreq, &truth.omega)?, relative_deviation(row.tamp, &truth.amplitude)?);
        run.value(&format!("true_omega_{m}_followers"), interval_value(&truth.omega, 15));
        run.value(&format!("true_amplitude_{m}_followers"), interval_value(&truth.amplitude, 15));
        run.value(&format!("tfreq_relative_deviation_N_{}", row.n), interval_value(&omega, 4));
        run.value(&format!("tamp_relative_deviation_N_{}", row.n), interval_value(&size, 4));
        let printed = Interval::from_rational(&printed_decimal(row.tfreq)?.0, PRECISION);
        let distance = |from: &Interval| (printed.clone() - from).magnitude();
        let to_theory = printed.clone() - theorem1::frequency(&intervals, m)?;
        if distance(&truth.omega) >= to_theory.lo().absolute().min(to_theory.hi().absolute()) {
            return fails(format!("N = {}: TFREQ is nearer to Theorem 1", row.n));
        }
        if !size.is_certainly_negative() {
            return fails(format!("N = {}: TAMP is not below the true amplitude", row.n));
        }
        let bounds = if row.n == 128 { (frequency.1, amplitude.1) } else { (frequency.0, amplitude.0) };
        if !within(&omega, bounds.0) || !within(&size, bounds.1) {
            return fails(format!(
                "N = {}: the relative deviations are {} and {}",
                row.n,
                interval_value(&omega, 4),
                interval_value(&size, 4)
            ));
        }
    }
    Ok(Outcome::Holds(vec![certified("TFREQ and TAMP against the true resonance of N followers", detail)]))
}

impl Claim for NumericColumns {
    type Variant = NumericVariant;

    fn id(&self) -> &str {
        "veerman.table1_numeric"
    }

    fn derivation(&self) -> &str {
        "The claim is read as: every cell is the resonance to the digits printed (the text: \"we show only the relevant digits\"). \
         The true resonance is enclosed rigorously (notes/resonance.md). NFREQ and NAMP are not its values, for N + 1 or N \
         followers; they are Theorem 1 (veerman.table1_theory). The other pair, TFREQ and TAMP, is what a simulation may have \
         given: TFREQ is nearer to the true frequency of N followers than to Theorem 1 in every row, but TAMP lies below the \
         true amplitude in every row, so neither column is correct to the digits it shows. By which procedure it came about \
         is not established here; beyond.veerman.table1_reading has one that comes close."
    }

    fn printed(&self) -> NumericVariant {
        NumericVariant::TrueResonance(ColumnsVariant {
            names: NUMERIC,
            columns: (|row| row.nfreq, |row| row.namp),
            offsets: [1, 0],
            f: -1,
        })
    }

    fn repair(&self) -> Option<Repair<NumericVariant>> {
        Some(Repair {
            fault: Fault::False, clauses: Vec::new(),
            statement: "Columns NFREQ and NAMP are the values of Theorem 1 for N followers. Of the other two, TFREQ is nearer to \
                        the true resonance frequency of N followers than to Theorem 1 in every row (relative deviation at most \
                        0.14 % in all rows and 0.001 % at N = 128), and TAMP is below the true resonance amplitude in every row (by at \
                        most 3.53 % in all rows and 0.006 % at N = 128); no cell of either is correct to the digits printed."
                .to_string(),
            variant: NumericVariant::Deviations { offset: 0, frequency: (140, 1), amplitude: (3530, 6) },
        })
    }

    fn controls(&self) -> Vec<Control<NumericVariant>> {
        let NumericVariant::TrueResonance(printed) = self.printed() else { return Vec::new() };
        vec![
            Control::new(
                "TFREQ, TAMP are the true resonance to their digits",
                NumericVariant::TrueResonance(swapped(printed)),
            ),
            Control::new(
                "the deviations for N + 1 followers",
                NumericVariant::Deviations { offset: 1, frequency: (140, 1), amplitude: (3530, 6) },
            ),
            Control::new(
                "TFREQ within 0.13 %",
                NumericVariant::Deviations { offset: 0, frequency: (130, 1), amplitude: (3530, 6) },
            ),
        ]
    }

    fn examine(&self, variant: &NumericVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        match variant {
            NumericVariant::TrueResonance(columns) => examine_columns(
                columns,
                |m| Ok(resonance(&gains(columns.f), m, 30)?.omega),
                |m| Ok(resonance(&gains(columns.f), m, 30)?.amplitude),
                "enclosures of the true resonance against the printed digits",
            ),
            NumericVariant::Deviations { offset, frequency, amplitude } => {
                examine_deviations(*offset, *frequency, *amplitude, run)
            }
        }
    }
}

/// veerman.table1.size.
pub struct Size;

impl Claim for Size {
    /// Followers of the row N: N plus this.
    type Variant = i64;

    fn id(&self) -> &str {
        "veerman.table1.size"
    }

    fn derivation(&self) -> &str {
        "Every cell of NFREQ and NAMP is Theorem 1 with N in the place of the number of followers, and TFREQ is within 0.15 % \
         of the true resonance of N followers; for N + 1 followers all four columns are off by a factor of about (N + 1)/N. So \
         the rows refer to N followers, N + 1 cars with the leader."
    }

    fn printed(&self) -> i64 {
        1
    }

    fn repair(&self) -> Option<Repair<i64>> {
        Some(Repair {
            fault: Fault::Slip, clauses: Vec::new(),
            statement: "The rows of Table 1 refer to flocks of size N+1 (including the leader), that is, N followers, with N the \
                        first column."
                .to_string(),
            variant: 0,
        })
    }

    fn controls(&self) -> Vec<Control<i64>> {
        vec![Control::new("N - 1 followers", -1), Control::new("N + 2 followers", 2)]
    }

    fn examine(&self, offset: &i64, run: &mut Run) -> Result<Outcome, CheckError> {
        let columns = ColumnsVariant {
            names: NUMERIC,
            columns: (|row| row.nfreq, |row| row.namp),
            offsets: [*offset, *offset],
            f: -1,
        };
        let near = examine_near(*offset, run)?;
        let leading = examine_theorem(&columns)?;
        Run::all([Ok(near), Ok(leading)])
    }
}

/// TFREQ within 0.15 % of the true resonance frequency.
fn examine_near(offset: i64, run: &mut Run) -> Result<Outcome, CheckError> {
    let limit = Interval::from_rational(&rational(15, 10_000), PRECISION);
    for row in &ROWS {
        run.checkpoint()?;
        let m = row.n.saturating_add_signed(offset);
        let truth = resonance(&gains(-1), m, 30)?;
        let deviation = relative_deviation(row.tfreq, &truth.omega)?;
        if deviation.magnitude() >= *limit.lo() {
            return Ok(Outcome::fails(
                format!(
                    "N = {}: TFREQ is {}, the resonance of {m} followers {}",
                    row.n,
                    row.tfreq,
                    interval_value(&truth.omega, 12)
                ),
                certified("TFREQ", "the true resonance"),
            ));
        }
    }
    Ok(Outcome::Holds(vec![certified(
        "TFREQ within 0.15 % of the true resonance of N followers",
        "enclosed to 30 digits",
    )]))
}

/// veerman.sec7.omega0.
pub struct FirstGuess;

/// `omega_0 = pi sqrt2/(divisor (N + offset))`.
#[derive(Clone, Copy)]
pub struct FirstGuessVariant {
    divisor: i64,
    offset: i64,
}

impl Claim for FirstGuess {
    type Variant = FirstGuessVariant;

    fn id(&self) -> &str {
        "veerman.sec7.omega0"
    }

    fn derivation(&self) -> &str {
        "sqrt|f| pi/((N+1) 2 sqrt2) for f = -1 and pi sqrt2/(4(N+1)) are positive and have the squares pi²/(8 (N+1)²) and \
         2 pi²/(16 (N+1)²), which are equal."
    }

    fn printed(&self) -> FirstGuessVariant {
        FirstGuessVariant { divisor: 4, offset: 1 }
    }

    fn controls(&self) -> Vec<Control<FirstGuessVariant>> {
        vec![
            Control::new("pi sqrt2/(2(N+1))", FirstGuessVariant { divisor: 2, offset: 1 }),
            Control::new("pi sqrt2/(4N)", FirstGuessVariant { divisor: 4, offset: 0 }),
        ]
    }

    fn examine(&self, variant: &FirstGuessVariant, _: &mut Run) -> Result<Outcome, CheckError> {
        let gains = in_intervals(&gains(-1));
        for n in [1i64, 4, 128] {
            // The squares over pi², exactly.
            let theorem = rational(1, 8 * (n + 1) * (n + 1));
            let guess = rational(2, 1) / rational(variant.divisor * (n + variant.offset), 1).square();
            let root = Interval::from_rational(&guess, PRECISION).sqrt()?;
            let enclosed = root.pi() * root;
            if theorem != guess || !enclosed.overlaps(&theorem1::frequency(&gains, n as u64 + 1)?) {
                return Ok(Outcome::fails(
                    format!("N = {n}: the squares over pi² are {theorem} and {guess}"),
                    Evidence::new(Grade::Exact, "the squares", "rational"),
                ));
            }
        }
        Ok(Outcome::Holds(vec![Evidence::new(
            Grade::Exact,
            "the formula, for every N",
            "both sides are positive and proportional to 1/(N+1); their squares over pi² are equal rationals",
        )]))
    }
}

/// veerman.sec7.system.
pub struct WhichSystem;

/// Which equation the experiments are claimed to concern, for N + `more` followers or a multiple, and which section is
/// claimed to treat the other one.
#[derive(Clone, Copy)]
pub struct SystemVariant {
    communication: Communication,
    factor: u64,
    more: u64,
    section_of_other: u32,
}

/// The section that treats a system.
fn section(communication: Communication) -> u32 {
    match communication {
        Communication::Front => 3,
        Communication::FrontAndBack => 4,
    }
}

/// Frequency and amplitude at which the last of `m` cars responds most.
fn strongest(communication: Communication, m: u64) -> Result<(Interval, Interval), CheckError> {
    match communication {
        Communication::Front => {
            let intervals = in_intervals(&gains(-1));
            let square = strongest_one_sided_square(&intervals)?;
            let gain = gain_squared_one_sided(&intervals, &square)?;
            Ok((square.sqrt()?, gain.power(m).sqrt()?))
        }
        Communication::FrontAndBack => {
            let found = resonance(&gains(-1), m, 20)?;
            Ok((found.omega, found.amplitude))
        }
    }
}

impl Claim for WhichSystem {
    type Variant = SystemVariant;

    fn id(&self) -> &str {
        "veerman.sec7.system"
    }

    fn derivation(&self) -> &str {
        "For system (1) and f = g = -1 the last of M cars responds most at w² = sqrt3 - 1, w = 0.8556, with amplitude \
         (1 + 2/sqrt3)^(M/2), about 10^21 for M = 128. Every frequency in Table 1 is below 0.28 and the largest amplitude is 147. \
         For system (2) the frequencies are within 2 % and the amplitudes within 4 % of the resonance of N followers. Section 3, \
         to which the text refers for the other system, treats system (1). So (1) and (2) are exchanged."
    }

    fn printed(&self) -> SystemVariant {
        SystemVariant { communication: Communication::Front, factor: 1, more: 0, section_of_other: 3 }
    }

    fn repair(&self) -> Option<Repair<SystemVariant>> {
        Some(Repair {
            fault: Fault::Slip, clauses: Vec::new(),
            statement: "The experiments reported on in detail in Section 7 all concern the system given by Equation (2); the \
                        behavior of the system given by Equation (1) is relatively simple and is discussed in Section 3."
                .to_string(),
            variant: REPAIRED_SYSTEM,
        })
    }

    fn controls(&self) -> Vec<Control<SystemVariant>> {
        vec![
            Control::new("system (2) with 2N followers", SystemVariant { factor: 2, ..REPAIRED_SYSTEM }),
            Control::new("system (2) with N + 1 followers", SystemVariant { more: 1, ..REPAIRED_SYSTEM }),
            Control::new("system (1), treated elsewhere", SystemVariant { section_of_other: 4, ..self.printed() }),
            Control::new("the other system in Section 4", SystemVariant { section_of_other: 4, ..REPAIRED_SYSTEM }),
        ]
    }

    fn examine(&self, variant: &SystemVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        for row in &ROWS {
            run.checkpoint()?;
            let (omega, amplitude) = strongest(variant.communication, variant.factor * row.n + variant.more)?;
            for (name, printed, truth, percent) in [
                ("TFREQ", row.tfreq, &omega, 2),
                ("NFREQ", row.nfreq, &omega, 2),
                ("TAMP", row.tamp, &amplitude, 4),
                ("NAMP", row.namp, &amplitude, 4),
            ] {
                let limit = Interval::from_rational(&rational(percent, 100), PRECISION);
                if relative_deviation(printed, truth)?.magnitude() >= *limit.lo() {
                    let enclosed = interval_value(truth, 8);
                    return Ok(Outcome::fails(
                        format!("N = {}: {name} is {printed}, the resonance of the claimed system {enclosed}", row.n),
                        Evidence::new(Grade::Certified, "Table 1", "the resonance of the claimed system, enclosed"),
                    ));
                }
            }
        }
        let other = match variant.communication {
            Communication::Front => Communication::FrontAndBack,
            Communication::FrontAndBack => Communication::Front,
        };
        let reference =
            Evidence::new(Grade::Text, "the reference", "Section 3 treats system (1), Section 4 system (2)");
        if section(other) != variant.section_of_other {
            return Ok(Outcome::fails(format!("the other system is treated in Section {}", section(other)), reference));
        }
        let detail = "frequencies within 2 %, amplitudes within 4 % of the resonance of the claimed system, enclosed";
        Ok(Outcome::Holds(vec![
            Evidence::new(Grade::Certified, "all 24 cells of Table 1", detail).cases(4 * ROWS.len()),
            reference,
        ]))
    }
}

const REPAIRED_SYSTEM: SystemVariant =
    SystemVariant { communication: Communication::FrontAndBack, factor: 1, more: 0, section_of_other: 3 };
