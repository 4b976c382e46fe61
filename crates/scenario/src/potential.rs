//! The potential of a pair as a configuration names it.

use super::error::{ConfigError, Problem};
use super::source::Section;
use arithmetic::{ArithmeticError, Rational, rational};
use models::double_integrator::{self, Potential, Slope};

/// A potential with its slope over floats.
#[derive(Debug, Clone)]
pub(super) struct PairPotential {
    potential: Potential,
    slope: Slope<f64>,
    value: double_integrator::Value<f64>,
    formula: String,
}

#[derive(Clone, Copy)]
enum Named {
    None,
    Log,
    Spring,
    Inflection,
}

const NAMES: [(&str, Named); 4] = [
    ("inverse-square-log", Named::Log),
    ("inverse-square-spring", Named::Spring),
    ("inflection", Named::Inflection),
    ("none", Named::None),
];

impl PairPotential {
    /// Keys of the section `[law]`.
    pub const KEYS: [&'static str; 4] = ["potential", "minimum", "stiffness", "at"];

    /// Reads `potential` and the numbers that belong to it.
    pub fn read(law: &Section) -> Result<Self, ConfigError> {
        let entry = law.need("potential", &NAMES.map(|(name, _)| name).join(", "))?;
        if entry.is_table() {
            return PairPotential::from_slope(&entry.table("law.potential")?);
        }
        let named = entry.choice(&NAMES)?;
        let keys: &[&str] = match named {
            Named::None => &[],
            Named::Log => &["minimum"],
            Named::Spring => &["minimum", "stiffness"],
            Named::Inflection => &["at"],
        };
        for key in PairPotential::KEYS.iter().skip(1).filter(|key| !keys.contains(key)) {
            if let Some(unused) = law.get(key) {
                return Err(unused.range(format!("left out: the potential \"{}\" has no such number", entry.word()?)));
            }
        }
        let positive = |key: &str, default: i64| match law.get(key) {
            None => Ok(rational(default, 1)),
            Some(entry) => {
                entry.positive()?;
                entry.exact()
            }
        };
        let (minimum, stiffness) = (positive("minimum", 1)?, positive("stiffness", 1)?);
        let (potential, formula) = match named {
            Named::None => (Potential::new(Vec::new(), (rational(1, 1), rational(0, 1))), "0".to_string()),
            Named::Log => (
                Potential::inverse_square_log(&minimum),
                format!("m/s + log(s/m), m = {minimum}: 1/|r|² + log |r|² for m = 1"),
            ),
            Named::Spring => (
                Potential::inverse_square_spring(&minimum, &stiffness),
                format!("k (s/m + m/s - 2), m = {minimum}, k = {stiffness}"),
            ),
            Named::Inflection => {
                let at = law.need("at", "a number above 1")?;
                let place = at.exact()?;
                if place <= rational(1, 1) {
                    return Err(at.range("a number above 1"));
                }
                let formula = format!("the integral of (s - 1)(s - a)²(s + a/(a + 2))/s² with V(1) = 0, a = {place}");
                (Potential::with_inflection(&place), formula)
            }
        };
        PairPotential::new(potential, formula).map_err(|error| entry.problem(error))
    }

    /// `{ slope = [[exponent, coefficient], ..], at = s, value = V }`.
    fn from_slope(table: &Section) -> Result<Self, ConfigError> {
        const EXPECTED: &str = "a list of pairs [exponent, coefficient]";
        table.allow(&["slope", "at", "value"], "")?;
        let mut terms: Vec<(i32, Rational)> = Vec::new();
        for term in table.need("slope", EXPECTED)?.items(EXPECTED)? {
            let pair = term.items(EXPECTED)?;
            let [exponent, coefficient] = &pair[..] else {
                return Err(term.problem(Problem::Shape(EXPECTED.to_string())));
            };
            let power = exponent.exact()?;
            let size = power.is_integer().then(|| i32::try_from(power.to_integer()).ok()).flatten();
            let power = size.filter(|k| k.abs() <= 64).ok_or_else(|| exponent.range("an integer from -64 to 64"))?;
            if terms.iter().any(|(known, _)| *known == power) {
                return Err(exponent.range("an exponent that is not there yet"));
            }
            coefficient.number()?;
            terms.push((power, coefficient.exact()?));
        }
        let at = table.need("at", "a squared distance at which the value is known")?;
        let value = table.need("value", "the potential there")?;
        let (place, height) = (at.exact()?, value.exact()?);
        at.positive()?;
        value.number()?;
        let sum = terms.iter().map(|(k, c)| format!("{c} s^{k}")).collect::<Vec<_>>().join(" + ");
        let formula = format!("the integral of {sum} with V({place}) = {height}");
        let potential = Potential::new(terms, (place, height));
        PairPotential::new(potential, formula).map_err(|error| value.problem(error))
    }

    fn new(potential: Potential, formula: String) -> Result<Self, ArithmeticError> {
        let (slope, value) = (potential.slope_over(&1.0), potential.value_over(&1.0)?);
        Ok(PairPotential { potential, slope, value, formula })
    }

    /// The potential itself.
    pub fn exact(&self) -> &Potential {
        &self.potential
    }

    /// `V(s)` at a squared distance.
    pub fn value(&self, s: &f64) -> Result<f64, ArithmeticError> {
        self.value.at(s)
    }

    /// `V'(s)`.
    pub fn slope(&self, s: &f64) -> Result<f64, ArithmeticError> {
        self.slope.at(s)
    }

    /// The potential in words.
    pub fn declaration(&self) -> String {
        let kind = match self.potential.check_definition3() {
            Ok(()) => String::new(),
            Err(error) => format!("; not one of Definition 3 of the paper: {error}"),
        };
        format!("V_ij with s = |r_ij|²: {}{kind}", self.formula)
    }
}
