//! Names that are exchanged for each other.

type Pairs = &'static [(&'static str, &'static str)];

/// Methods with the same arguments.
pub const METHODS: Pairs = &[
    ("min", "max"),
    ("floor", "ceil"),
    ("any", "all"),
    ("next_up", "next_down"),
    ("lo", "hi"),
    ("lower", "upper"),
    ("low", "high"),
    ("first", "last"),
    ("sin", "cos"),
    ("sinh", "cosh"),
    ("re", "im"),
    ("one", "zero"),
    ("is_positive", "is_negative"),
    ("is_some", "is_none"),
    ("is_ok", "is_err"),
    ("numer", "denom"),
    ("rows", "cols"),
    ("saturating_add", "saturating_sub"),
    ("checked_add", "checked_sub"),
    ("mul_rounded", "div_rounded"),
    ("min_by", "max_by"),
    ("min_by_key", "max_by_key"),
    ("position", "rposition"),
    ("skip", "take"),
    ("union", "intersection"),
    ("is_odd", "is_even"),
];

/// Methods without arguments that are left out.
pub const DROPPED: &[&str] = &["abs", "absolute", "negated", "sqrt", "square", "conj", "conjugate", "recip", "rev"];

/// Methods and functions whose two arguments may be exchanged.
pub const COMMUTATIVE: &[&str] = &["min", "max", "gcd", "lcm", "swap", "sum", "product", "overlaps", "hull", "dot"];

/// Last words of paths.
pub const PATHS: Pairs = &[
    ("Down", "Up"),
    ("Plus", "Minus"),
    ("Positive", "Negative"),
    ("Less", "Greater"),
    ("zero", "one"),
    ("INFINITY", "NEG_INFINITY"),
    ("MIN", "MAX"),
    ("min", "max"),
    ("sin", "cos"),
];

/// Fields.
pub const FIELDS: Pairs = &[
    ("lo", "hi"),
    ("low", "high"),
    ("lower", "upper"),
    ("re", "im"),
    ("x", "y"),
    ("0", "1"),
    ("numerator", "denominator"),
    ("positions", "velocities"),
    ("position", "velocity"),
    ("front", "back"),
    ("left", "right"),
    ("value", "derivative"),
    ("rows", "cols"),
    ("f", "g"),
];

/// The other one of a pair.
pub fn other(pairs: Pairs, name: &str) -> Option<&'static str> {
    pairs.iter().find_map(|&(a, b)| match name {
        _ if name == a => Some(b),
        _ if name == b => Some(a),
        _ => None,
    })
}
