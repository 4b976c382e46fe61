//! Table 1 of Veerman, Stosic and Olvera as printed: sizes and the four columns, digit by digit.

/// One row of Table 1, as printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Row {
    /// The first column.
    pub n: u64,
    /// `NFREQ`: by its heading the frequency obtained by simulation.
    pub nfreq: &'static str,
    /// `NAMP`: by its heading the amplitude obtained by simulation.
    pub namp: &'static str,
    /// `TFREQ`: by its heading the frequency of Theorem 1.
    pub tfreq: &'static str,
    /// `TAMP`: by its heading the amplitude of Theorem 1.
    pub tamp: &'static str,
}

const fn row(n: u64, nfreq: &'static str, namp: &'static str, tfreq: &'static str, tamp: &'static str) -> Row {
    Row { n, nfreq, namp, tfreq, tamp }
}

/// The six printed rows, for `f = g = -1`.
pub const ROWS: [Row; 6] = [
    row(4, "0.2776801836", "4.58527335", "0.2727291", "4.49064609"),
    row(8, "0.1388400918", "9.17054669", "0.1382221", "9.11739657"),
    row(16, "0.0694200459", "18.34109338", "0.06934994", "18.3135253"),
    row(32, "0.0347100229", "36.68218677", "0.03470038", "36.6683866"),
    row(64, "0.0173550115", "73.36437354", "0.017353935", "73.3562112"),
    row(128, "0.0086775057", "146.72874707", "0.008677381", "146.7227220"),
];
