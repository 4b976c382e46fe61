//! Reading a flock from JSON.
//!
//! `{"model": "D", "dimension": 1, "weights": "lazy" | "vicsek" | {"c": ["1/3", ..]}, "positions": [["0"], ..],
//! "velocities": [["1/8"], ..], "hysteresis": "none" | "paper" | "1/1024"}`; numbers are texts or JSON numbers, read exactly. `ids`
//! may name the birds and `control` give the matrix of equation (1.2), as many rows as birds times dimensions.
//!
//! `{"model": "K", "speed": "1/10", "headings": ["0", "1/2", ..], "positions": [["0", "0"], ..], "hysteresis": ..}`, headings in
//! radians; `kappa` may give one number for each bird, as in equation (1.1).

use super::flock::{Flock, Start, check_control};
use super::hysteresis::Hysteresis;
use super::kinematic::{KinematicFlock, check_kappa};
use super::kinematic_start::KinematicStart;
use super::weights::{FlockError, Weights};
use algebra::matrix::{MatrixError, RationalMatrix};
use arithmetic::{Complex, NumberError, Rational, parse_rational, shown};
use num_traits::Signed;
use serde_json::{Map, Value};

/// A flock as a file describes it.
#[derive(Debug, Clone, PartialEq)]
pub struct FlockFile {
    /// The model and its start.
    pub model: Model,
    /// Names of the birds, where the file gives them.
    pub ids: Option<Vec<String>>,
}

/// A model with its initial conditions.
#[derive(Debug, Clone, PartialEq)]
pub enum Model {
    /// Velocities are averaged.
    D {
        /// Initial conditions.
        start: Start,
        /// A matrix that multiplies the velocities in every step.
        control: Option<RationalMatrix>,
    },
    /// Headings are averaged.
    K {
        /// Initial conditions.
        start: KinematicStart,
        /// Numbers that are added to the headings in every step.
        control: Option<Vec<Rational>>,
    },
}

/// Why a file does not describe a flock.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ReadFlockError {
    /// Not JSON.
    #[error("not valid JSON: {0}")]
    Json(String),
    /// Not an object.
    #[error("a flock is a JSON object such as {{\"model\": \"D\", ..}}")]
    NoObject,
    /// A field that is missing.
    #[error("the field `{0}` is missing")]
    Missing(&'static str),
    /// A field that is not known.
    #[error("there is no field `{}`", shown(.0))]
    Unknown(String),
    /// A field of the other model.
    #[error("model {model} has no field `{field}`: {why}")]
    OtherModel {
        /// The model of the file.
        model: &'static str,
        /// The field.
        field: &'static str,
        /// What the model has instead.
        why: &'static str,
    },
    /// A field of another shape.
    #[error("`{field}` should be {expected}")]
    Shape {
        /// The field.
        field: String,
        /// What it should be.
        expected: &'static str,
    },
    /// A number that cannot be read.
    #[error("`{field}`: {error}")]
    Number {
        /// The field, with the position in it.
        field: String,
        /// What is wrong.
        error: NumberError,
    },
    /// Two birds with the same id.
    #[error("the id `{}` is given to two birds", shown(.0))]
    CoincidentIds(String),
    /// Not as many ids as birds.
    #[error("there are {birds} birds but {ids} ids")]
    Ids {
        /// Number of birds.
        birds: usize,
        /// Number of ids.
        ids: usize,
    },
    /// The stated dimension is another.
    #[error("`dimension` is {stated}, but the positions have {found} coordinates")]
    Dimension {
        /// As stated.
        stated: String,
        /// As found.
        found: usize,
    },
    /// A control that is no matrix.
    #[error("`control`: {0}")]
    Control(MatrixError),
    /// Not a flock.
    #[error(transparent)]
    Flock(#[from] FlockError),
}

const FIELDS: [&str; 11] = [
    "model",
    "dimension",
    "weights",
    "positions",
    "velocities",
    "hysteresis",
    "ids",
    "control",
    "speed",
    "headings",
    "kappa",
];

/// Fields that one model does not have, and why.
const NOT_IN_D: [(&str, &str); 3] = [
    ("speed", "the velocities say how fast the birds are"),
    ("headings", "it averages `velocities`"),
    ("kappa", "its control is the matrix `control`"),
];
const NOT_IN_K: [(&str, &str); 3] = [
    ("weights", "its weights are always 1/(d_i + 1)"),
    ("velocities", "it has one `speed` and `headings`"),
    ("control", "its control is `kappa`, one number for each bird"),
];

/// Reads a flock.
///
/// # Errors
/// [`ReadFlockError`] with the field at fault.
pub fn read_flock(text: &str) -> Result<FlockFile, ReadFlockError> {
    flock_of(algebra::json::parse(text).map_err(ReadFlockError::Json)?)
}

/// The flock of a document that was parsed.
///
/// # Errors
/// [`ReadFlockError`] with the field at fault.
pub fn flock_of(value: Value) -> Result<FlockFile, ReadFlockError> {
    let Value::Object(fields) = value else { return Err(ReadFlockError::NoObject) };
    if let Some(unknown) = fields.keys().find(|key| !FIELDS.contains(&key.as_str())) {
        return Err(ReadFlockError::Unknown(unknown.clone()));
    }
    let (model, birds, dimension) = match field(&fields, "model")?.as_str() {
        Some("D") => {
            refuse_fields(&fields, "D", &NOT_IN_D)?;
            let (start, control) = dynamic(&fields)?;
            let (birds, dimension) = (start.positions.len(), start.positions[0].len());
            (Model::D { start, control }, birds, dimension)
        }
        Some("K") => {
            refuse_fields(&fields, "K", &NOT_IN_K)?;
            let (start, control) = kinematic(&fields)?;
            let birds = start.positions.len();
            (Model::K { start, control }, birds, 2)
        }
        _ => return Err(shape("model", "\"D\" or \"K\"")),
    };
    if let Some(stated) = fields.get("dimension").filter(|d| d.as_u64() != Some(dimension as u64)) {
        return Err(ReadFlockError::Dimension { stated: stated.to_string(), found: dimension });
    }
    let ids = ids(fields.get("ids"), birds)?;
    Ok(FlockFile { model, ids })
}

fn refuse_fields(
    fields: &Map<String, Value>,
    model: &'static str,
    list: &[(&'static str, &'static str)],
) -> Result<(), ReadFlockError> {
    match list.iter().find(|(field, _)| fields.contains_key(*field)) {
        Some(&(field, why)) => Err(ReadFlockError::OtherModel { model, field, why }),
        None => Ok(()),
    }
}

fn dynamic(fields: &Map<String, Value>) -> Result<(Start, Option<RationalMatrix>), ReadFlockError> {
    let start = Start {
        positions: vectors(fields, "positions")?,
        velocities: vectors(fields, "velocities")?,
        weights: weights(field(fields, "weights")?)?,
        hysteresis: hysteresis(fields.get("hysteresis"))?,
    };
    // Everything that makes a flock is checked once, there.
    let flock = Flock::new(&start)?;
    if !fields.contains_key("control") {
        return Ok((start, None));
    }
    let rows = rows(fields, "control", "a list of the rows of a matrix", "row")?;
    let control = RationalMatrix::from_rows(&rows).map_err(ReadFlockError::Control)?;
    check_control(&control, flock.birds(), flock.dimension())?;
    Ok((start, Some(control)))
}

fn kinematic(fields: &Map<String, Value>) -> Result<(KinematicStart, Option<Vec<Rational>>), ReadFlockError> {
    let mut positions = Vec::new();
    for (i, row) in vectors(fields, "positions")?.into_iter().enumerate() {
        let point: Result<[Rational; 2], _> = row.try_into();
        let [re, im] = point.map_err(|row| FlockError::Coordinates {
            what: "position",
            bird: i + 1,
            dimension: 2,
            found: row.len(),
        })?;
        positions.push(Complex::new(re, im));
    }
    let start = KinematicStart {
        speed: number(field(fields, "speed")?, || "speed".to_string())?,
        positions,
        headings: numbers(field(fields, "headings")?, "headings")?,
        hysteresis: hysteresis(fields.get("hysteresis"))?,
    };
    let flock = KinematicFlock::new(&start)?;
    let kappa = fields.get("kappa").map(|kappa| numbers(kappa, "kappa")).transpose()?;
    kappa.iter().try_for_each(|kappa| check_kappa(kappa, flock.birds()))?;
    Ok((start, kappa))
}

fn field<'a>(fields: &'a Map<String, Value>, name: &'static str) -> Result<&'a Value, ReadFlockError> {
    fields.get(name).ok_or(ReadFlockError::Missing(name))
}

fn shape(field: &str, expected: &'static str) -> ReadFlockError {
    ReadFlockError::Shape { field: field.to_string(), expected }
}

fn number(value: &Value, field: impl Fn() -> String) -> Result<Rational, ReadFlockError> {
    let text = match value {
        Value::String(text) => text.clone(),
        Value::Number(number) => number.to_string(),
        _ => return Err(ReadFlockError::Shape { field: field(), expected: "a number" }),
    };
    parse_rational(&text).map_err(|error| ReadFlockError::Number { field: field(), error })
}

fn vectors(fields: &Map<String, Value>, name: &'static str) -> Result<Vec<Vec<Rational>>, ReadFlockError> {
    rows(fields, name, "a list with one list of coordinates for each bird", "bird")
}

/// A list of lists of numbers; `each` is what one of them belongs to.
fn rows(
    fields: &Map<String, Value>,
    name: &'static str,
    expected: &'static str,
    each: &str,
) -> Result<Vec<Vec<Rational>>, ReadFlockError> {
    let rows = field(fields, name)?.as_array().ok_or_else(|| shape(name, expected))?;
    let row = |(i, row): (usize, &Value)| {
        let coordinates = row.as_array().ok_or_else(|| shape(name, expected))?;
        let entry = |(k, value): (usize, &Value)| number(value, || format!("{name}, {each} {}, {}", i + 1, k + 1));
        coordinates.iter().enumerate().map(entry).collect()
    };
    rows.iter().enumerate().map(row).collect()
}

fn numbers(value: &Value, name: &'static str) -> Result<Vec<Rational>, ReadFlockError> {
    let list = value.as_array().ok_or_else(|| shape(name, "a list with one number for each bird"))?;
    let entry = |(i, value)| number(value, || format!("{name}, bird {}", i + 1));
    list.iter().enumerate().map(entry).collect()
}

fn weights(value: &Value) -> Result<Weights, ReadFlockError> {
    const EXPECTED: &str = "\"lazy\", \"vicsek\" or {\"c\": [one number for each bird]}";
    match value {
        Value::String(name) if name == "lazy" => Ok(Weights::Lazy),
        Value::String(name) if name == "vicsek" => Ok(Weights::Vicsek),
        Value::Object(given) if given.len() == 1 => {
            let list = given.get("c").and_then(Value::as_array).ok_or_else(|| shape("weights", EXPECTED))?;
            let entry = |(i, value)| number(value, || format!("weights, c_{}", i + 1));
            Ok(Weights::Given(list.iter().enumerate().map(entry).collect::<Result<_, _>>()?))
        }
        _ => Err(shape("weights", EXPECTED)),
    }
}

fn hysteresis(value: Option<&Value>) -> Result<Hysteresis, ReadFlockError> {
    match value.and_then(Value::as_str) {
        None if value.is_none() => Ok(Hysteresis::None),
        Some("none") => Ok(Hysteresis::None),
        Some("paper") => Ok(Hysteresis::Paper),
        _ => {
            let threshold = number(value.unwrap_or(&Value::Null), || "hysteresis".to_string())?;
            if threshold.is_negative() {
                return Err(FlockError::NegativeHysteresis(threshold.to_string()).into());
            }
            Ok(Hysteresis::Constant(threshold))
        }
    }
}

fn ids(value: Option<&Value>, birds: usize) -> Result<Option<Vec<String>>, ReadFlockError> {
    let Some(value) = value else { return Ok(None) };
    let list = value.as_array().ok_or_else(|| shape("ids", "a list with one name for each bird"))?;
    if list.len() != birds {
        return Err(ReadFlockError::Ids { birds, ids: list.len() });
    }
    let name = |value: &Value| value.as_str().map_or_else(|| value.to_string(), str::to_string);
    let names: Vec<String> = list.iter().map(name).collect();
    let twice = names.iter().enumerate().find(|(k, name)| names[..*k].contains(name));
    match twice {
        Some((_, name)) => Err(ReadFlockError::CoincidentIds(name.clone())),
        None => Ok(Some(names)),
    }
}
