//! What is run, in words: equations, order of updates, and how each ambiguous word of a rule is read.

use super::flock::Flock;
use super::hysteresis::Hysteresis;
use super::kinematic::KinematicFlock;
use super::weights::Weights;
use algebra::matrix::RationalMatrix;
use arithmetic::Rational;

/// The declaration of a flock of model D, with or without a constant control.
pub fn declaration(flock: &Flock, control: Option<&RationalMatrix>) -> String {
    let weights = match flock.weights() {
        Weights::Lazy => "c_i = 2/(3 d_i)".to_string(),
        Weights::Vicsek => "c_i = 1/(d_i + 1)".to_string(),
        Weights::Given(c) => format!("c = {}", list(c)),
    };
    let control = control.map_or_else(String::new, |matrix| {
        let rows: Vec<String> = matrix.to_rows().iter().map(|row| list(row)).collect();
        format!("control: the stacked vector v(t+1) so found is multiplied by the rows {};\n", rows.join(", "))
    });
    format!(
        "model D, {} in dimension {}: for t = 1, 2, ..\n\
         x(t) = x(t-1) + v(t); then G_t: edge i-j if |x_i(t) - x_j(t)| <= 1;\n\
         then v_i(t+1) = v_i(t) + c_i sum over j of (v_j(t) - v_i(t)),\n\
         j the neighbours of i in G_t, {weights};\n\
         {control}{};\n\
         G_0 by distance alone; a bird without neighbours keeps its velocity.",
        birds(flock.birds()),
        flock.dimension(),
        hysteresis(flock.hysteresis(), flock.birds())
    )
}

/// The declaration of a flock of model K, with or without a constant control.
pub fn kinematic_declaration(flock: &KinematicFlock, control: Option<&[Rational]>) -> String {
    let (sum, control) = match control {
        Some(kappa) => ("kappa_i + ", format!("control: kappa = {}, at every t;\n", list(kappa))),
        None => ("", String::new()),
    };
    format!(
        "model K, {} in the plane, sigma = {}: for t = 1, 2, ..\n\
         x_i(t) = x_i(t-1) + sigma (cos theta_i(t), sin theta_i(t));\n\
         then G_t: edge i-j if |x_i(t) - x_j(t)| <= 1;\n\
         then theta_i(t+1) = {sum}(theta_i(t) + sum over neighbours in G_t of theta_j(t))/(d_i + 1);\n\
         {control}headings in radians, averaged as numbers; 0 <= theta_i(1) < 2 pi, later ones not reduced;\n\
         {};\n\
         the extra rule the paper mentions for model K but does not state is left out;\n\
         G_0 by distance alone; a bird without neighbours keeps its heading.\n\
         Headings are exact; positions are enclosed and refined until every comparison is decided.",
        birds(flock.birds()),
        flock.speed(),
        hysteresis(flock.hysteresis(), flock.birds())
    )
}

fn list(numbers: &[Rational]) -> String {
    format!("({})", numbers.iter().map(ToString::to_string).collect::<Vec<_>>().join(", "))
}

fn hysteresis(rule: &Hysteresis, birds: usize) -> String {
    let threshold = match rule {
        Hysteresis::None => return "no hysteresis".to_string(),
        Hysteresis::Constant(threshold) => threshold.to_string(),
        Hysteresis::Paper => format!("{birds}^(-{birds}^4)"),
    };
    format!(
        "hysteresis: an edge of G_(t-1), however it came about, stays in G_t where\n\
         | |x_i(t) - x_j(t)| - |x_i(t-1) - x_j(t-1)| | < {threshold}, strictly"
    )
}

fn birds(count: usize) -> String {
    if count == 1 { "1 bird".to_string() } else { format!("{count} birds") }
}
