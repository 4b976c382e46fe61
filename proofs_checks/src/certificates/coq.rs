//! Certificates as theorems: files for the Coq development whose proofs are one evaluation.

use super::{Certificate, Inertia, Limit, Peak, Product, Switches};
use algebra::matrix::RationalMatrix;
use arithmetic::{Rational, common_denominator, lcm};
use models::averaging::Weights;
use num_bigint::BigInt;
use num_traits::{Signed, ToPrimitive};

/// A certificate and the name of its theorem.
#[derive(Debug, Clone)]
pub struct CoqTheorem {
    /// Letters, digits and underscores.
    pub name: String,
    /// What is proved.
    pub certificate: Certificate,
}

/// The file of one kind of certificates; `None` where none of these can be stated there: rectangular factors, flocks off the
/// line or with given weights, and platoons of more than 16 followers are left to the other checker.
pub fn coq_file(kind: &str, theorems: &[CoqTheorem]) -> Option<String> {
    let of_kind = theorems.iter().filter(|theorem| theorem.certificate.kind() == kind);
    let stated: Vec<String> = of_kind.filter_map(|theorem| statement(&theorem.name, &theorem.certificate)).collect();
    let (standard, libraries): (&str, &[&str]) = match kind {
        "limit" => ("ZArith QArith List", &["certificate_matrices", "certificate_limits"]),
        "switches" => ("ZArith QArith List", &["certificate_matrices", "certificate_flocks"]),
        "inertia" => ("ZArith QArith List", &["certificate_matrices", "certificate_inertia"]),
        "peak" => ("Reals ZArith QArith List", &["certificate_peaks"]),
        _ => ("ZArith QArith List", &["certificate_matrices"]),
    };
    let imports: String =
        libraries.iter().map(|library| format!("From Flockproof Require Import {library}.\n")).collect();
    (!stated.is_empty()).then(|| {
        format!(
            "(* Written by `flockproof certify --coq`. *)\nFrom Coq Require Import {standard}.\n{imports}Import \
             ListNotations.\nOpen Scope Z_scope.\n\n{}",
            stated.join("\n")
        )
    })
}

fn statement(name: &str, certificate: &Certificate) -> Option<String> {
    match certificate {
        Certificate::Product(product) => product_theorem(name, product),
        Certificate::Limit(limit) => Some(limit_theorem(name, limit)),
        Certificate::Switches(switches) => switches_theorem(name, switches),
        Certificate::Inertia(inertia) => inertia_theorem(name, inertia),
        Certificate::Peak(peak) => peak_theorem(name, peak),
    }
}

/// What closes every generated proof: the check is evaluated once, by the kernel.
fn proof(certificate: &str) -> String {
    format!("Proof. {certificate} vm_cast_no_check (eq_refl true). Qed.\n")
}

fn integer(x: &BigInt) -> String {
    if x.is_negative() { format!("({x})") } else { x.to_string() }
}

fn integers(list: &[BigInt]) -> String {
    format!("[{}]", list.iter().map(integer).collect::<Vec<_>>().join("; "))
}

fn fraction(q: &Rational) -> String {
    format!("({} # {})", integer(&q.numer()), q.denom())
}

/// Of type `zmat`.
fn matrix(matrix: &RationalMatrix) -> String {
    let rows: Vec<String> = (0..matrix.rows()).map(|i| integers(matrix.row(i))).collect();
    format!("([{}],\n  {}%positive)", rows.join(";\n   "), matrix.denominator())
}

/// A matrix of one row, of type `list Z * positive`.
fn list(row: &RationalMatrix) -> String {
    format!("({}, {}%positive)", integers(row.row(0)), row.denominator())
}

fn product_theorem(name: &str, product: &Product) -> Option<String> {
    let order = product.factors.first()?.rows();
    if product.factors.iter().any(|p| p.rows() != order || p.cols() != order) {
        return None;
    }
    let factors: Vec<String> = product.factors.iter().map(matrix).collect();
    Some(format!(
        "Definition {name}_factors : list zmat := [\n  {}].\nTheorem {name} :\n  (forall M, In M {name}_factors -> stochastic {order} (val \
         M)) /\\\n  is_tau1 {order} (prodq {order} {name}_factors) {}.\n{}",
        factors.join(";\n  "),
        fraction(&product.tau),
        proof("apply product_certificate.")
    ))
}

fn limit_theorem(name: &str, limit: &Limit) -> String {
    let (n, k, c) = (limit.p.rows(), limit.power, fraction(&limit.tau));
    format!(
        "Definition {name}_P : zmat :=\n  {}.\nDefinition {name}_pi : list Z * positive :=\n  {}.\nDefinition {name}_Gamma : zmat :=\n  \
         {}.\nTheorem {name} :\n  converges {n} (val {name}_P) (vec {name}_pi) (val {name}_Gamma) {k} {c}.\n{}",
        matrix(&limit.p),
        list(&limit.pi),
        matrix(&limit.gamma),
        proof("apply limit_certificate.")
    )
}

fn inertia_theorem(name: &str, inertia: &Inertia) -> Option<String> {
    let n = inertia.a.rows();
    // A = M D M^T for the rows of L in the order of A.
    let rows = inertia.l.to_rows();
    let mut ordered = rows.clone();
    for (row, &pivot) in rows.iter().zip(&inertia.pivots) {
        ordered[pivot].clone_from(row);
    }
    let m = RationalMatrix::from_rows(&ordered).ok()?;
    let (k, d) = (m.inverse().ok()?.reduced(), super::text::list(&inertia.d).ok()?);
    let (positive, negative, _) = inertia.counts();
    Some(format!(
        "Definition {name}_A : zmat :=\n  {}.\nTheorem {name} : has_inertia {n} (val {name}_A) {positive} {negative}.\n{}",
        matrix(&inertia.a),
        proof(&format!("apply (inertia_certificate _ _\n  {}\n  {}\n  {}).", matrix(&m), list(&d), matrix(&k)))
    ))
}

/// With more followers one evaluation takes minutes.
const MOST_FOLLOWERS: u64 = 16;
/// How often an interval is halved.
const HALVINGS: usize = 64;

fn peak_theorem(name: &str, peak: &Peak) -> Option<String> {
    if peak.followers > MOST_FOLLOWERS {
        return None;
    }
    let peak = peak.for_coq().ok()?;
    let (low, high) = &peak.frequency;
    // Both ends over one denominator.
    let unit = common_denominator([low, high]);
    let end = |q: &Rational| format!("({} # {unit})", q.numer() * (&unit / q.denom()));
    let reals = |numbers: &[String]| numbers.iter().map(|q| format!("(Q2R {q})")).collect::<Vec<_>>().join(" ");
    Some(format!(
        "Theorem {name} :\n  has_peak {} {}\n    {}\n    {}.\n{}",
        reals(&[fraction(&peak.gains.f), fraction(&peak.gains.g)]),
        peak.followers - 1,
        reals(&[end(low), end(high)]),
        reals(&[fraction(&peak.amplitude.0), fraction(&peak.amplitude.1)]),
        proof(&format!("apply (peak_certificate _ _ _ _ _ {} _ _ {HALVINGS}).", fraction(&peak.at)))
    ))
}

fn switches_theorem(name: &str, switches: &Switches) -> Option<String> {
    let (birds, dimension) = (switches.positions.rows(), switches.positions.cols());
    let (weight, weights) = match &switches.start.weights {
        Weights::Lazy => ("lazy_weight", Weights::Lazy),
        Weights::Vicsek => ("vicsek_weight", Weights::Vicsek),
        Weights::Given(_) => return None,
    };
    if dimension != 1 {
        return None;
    }
    // c times the multiple for every number of neighbours.
    let all: Vec<Rational> = (0..birds).map(|d| weights.of(d, 0)).collect::<Option<_>>()?;
    let multiple = common_denominator(&all);
    let factors: Vec<BigInt> = all.iter().map(|c| c.numer() * (&multiple / c.denom())).collect();
    // Positions and velocities over one denominator.
    let unit = lcm(switches.positions.denominator(), switches.velocities.denominator());
    let column = |matrix: &RationalMatrix| -> Vec<BigInt> {
        let factor = &unit / matrix.denominator();
        (0..birds).map(|i| &matrix.row(i)[0] * &factor).collect()
    };
    let threshold = switches.threshold.clone().unwrap_or_else(|| Rational::from_integer(BigInt::ZERO));
    let edges = |network: &algebra::graph::Graph| {
        let edges: Vec<String> = network.edges().iter().map(|(i, j)| format!("({i}, {j})")).collect();
        format!("[{}]", edges.join("; "))
    };
    let later: Vec<String> =
        switches.networks[1..].iter().map(|(t, network)| format!("({t}, {})", edges(network))).collect();
    let until = switches.until.to_usize()?;
    Some(format!(
        "Definition {name}_x : list Z := {}.\nDefinition {name}_v : list Z := {}.\nDefinition {name}_unit : positive := \
         {unit}.\nDefinition {name}_threshold : Q := {}.\nDefinition {name}_first : list (nat * nat) := {}%nat.\nDefinition {name}_later : \
         networks := [\n  {}]%nat.\nTheorem {name} :\n  forall t, (t <= {until})%nat -> forall i j, (i < j < {birds})%nat ->\n  edge (run \
         {birds} {weight} {name}_threshold\n    (start (fun i => get {name}_x i # {name}_unit) (fun i => get {name}_v i # {name}_unit)) t) \
         i j =\n  listed (network_at {name}_first {name}_later t) i j.\n{}",
        integers(&column(&switches.positions)),
        integers(&column(&switches.velocities)),
        fraction(&threshold),
        edges(&switches.networks[0].1),
        later.join(";\n  "),
        proof(&format!(
            "apply (switches_certificate {birds} {weight} {multiple} {} {name}_threshold\n  {name}_x {name}_v {name}_unit {name}_first \
             {name}_later {until}).",
            integers(&factors)
        ))
    ))
}
