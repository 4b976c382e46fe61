//! The decision of "at every point of a domain one of these functions has its sign": points first, then boxes with derivatives, then polynomials.

mod attained;
mod bernstein;
mod elimination;
mod exact;
mod extended;
mod faces;
mod goals;
mod image;
mod local;
mod parted;
mod periods;
mod places;
mod points;
mod prover;
mod reduction;
mod rewritten;
mod roots;
mod scale;
mod solutions;
mod subdivision;
mod surfaces;
mod tail;

use crate::function::{Function, Literal, Side};
use crate::sums::Certificate;
use arithmetic::{Cancelled, Progress, Rational};
use extended::Extended;
pub use places::Place;

/// How it was decided.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Method {
    /// Enclosures on boxes.
    Enclosures,
    /// Slopes of one sign: the least value lies on a side of the box.
    Slopes,
    /// A positive definite matrix of second derivatives: the function is convex on the box, and its least value is known.
    Convexity,
    /// An expansion at a zero of higher order, in one number.
    Expansion,
    /// Expansions far out, or beside a number at which there is no slope, in one number.
    Ends,
    /// Exact signs between the roots of polynomials in one number.
    Roots,
    /// Coefficients in Bernstein's basis.
    Bernstein,
    /// A sum of squares.
    Squares,
    /// Two literals that contradict each other's negations.
    Tautology,
}

impl Method {
    /// In a sentence.
    pub fn words(self) -> &'static str {
        match self {
            Method::Enclosures => "enclosures",
            Method::Slopes => "slopes of one sign",
            Method::Convexity => "convexity around the least value",
            Method::Expansion => "expansion at a zero",
            Method::Ends => "expansions at the ends",
            Method::Roots => "exact roots",
            Method::Bernstein => "Bernstein coefficients",
            Method::Squares => "sums of squares",
            Method::Tautology => "a guard that says the same",
        }
    }
}

/// What was proved, and how.
#[derive(Debug, Clone, Default)]
pub struct Proof {
    /// All that was used.
    pub methods: Vec<Method>,
    /// Points at which a literal that may be 0 is 0.
    pub zeros: Vec<Vec<Rational>>,
    /// Points at which a literal is 0 and some numbers are not rational, or not simple: a number in closed form for each variable.
    pub places: Vec<Vec<Place>>,
    /// Sums of squares; empty where none was needed.
    pub certificates: Vec<Certificate>,
    /// Boxes that were looked at.
    pub boxes: u64,
}

impl Proof {
    /// With what proves something else as well.
    fn add(&mut self, other: Proof) {
        self.methods.extend(other.methods);
        self.methods.sort_unstable();
        self.methods.dedup();
        self.zeros.extend(other.zeros);
        self.places.extend(other.places);
        self.certificates.extend(other.certificates);
        self.boxes += other.boxes;
    }

    /// Without points, which belong to other numbers.
    fn without_points(self) -> Self {
        Proof { zeros: Vec::new(), places: Vec::new(), ..self }
    }
}

/// What was left open.
#[derive(Debug, Clone)]
pub struct Open {
    /// In words.
    pub why: String,
    /// Boxes that are open.
    pub boxes: Vec<Vec<Side>>,
    /// Their share of the volume, where the domain is bounded.
    pub share: Option<f64>,
    /// Boxes that were looked at.
    pub looked: u64,
    /// Degrees of the sums of squares that were tried in vain.
    pub degrees: Vec<u32>,
}

impl Open {
    /// A point at which the sign could not be told.
    pub fn at_point(why: String) -> Self {
        Open { why, boxes: Vec::new(), share: None, looked: 0, degrees: Vec::new() }
    }
}

/// The decision.
#[derive(Debug, Clone)]
pub enum Decision {
    /// Some literal is true at every point.
    Holds(Proof),
    /// All literals are false at this point, exactly or by enclosure.
    Fails(Vec<Rational>),
    /// All literals are false at this point, exactly: a number in closed form for each variable.
    FailsAt(Vec<Place>),
    /// Neither was established.
    Undecided(Open),
}

/// How much may be tried.
#[derive(Debug, Clone, Copy)]
pub struct Effort {
    /// Most boxes.
    pub boxes: u64,
    /// Whether sums of squares are looked for.
    pub squares: bool,
    /// Whether sums of squares come first, so that there is a certificate wherever there can be one.
    pub certified: bool,
    /// Whether whoever asks also decides, by clauses with the same other literals, that every function has a value where it matters. Else what is concluded
    /// from one point for others needs values at all points between.
    pub conditions: bool,
}

impl Default for Effort {
    fn default() -> Self {
        Effort { boxes: 20_000, squares: true, certified: false, conditions: false }
    }
}

/// With more numbers than these polynomials are looked at before boxes, and only those of degree 2, without premises.
const MANY: usize = 10;

/// Boxes before polynomials are looked at.
const FIRST_BOXES: u64 = 300;

/// Decides whether at every point of the domain some literal is true.
///
/// # Errors
/// [`Cancelled`].
pub fn decide<F: Function>(
    clause: &[Literal<F>],
    domain: &[Side],
    effort: Effort,
    progress: &dyn Progress,
) -> Result<Decision, Cancelled> {
    let period = periods::narrowed(clause, domain);
    let domain = period.as_deref().unwrap_or(domain);
    let (equations, used) = reduction::equations(clause, domain);
    if equations.is_empty() {
        return on_rest(clause, domain, effort, progress);
    }
    let (literals, sides) = reduction::reduced(clause, domain, &equations, &used);
    let restored = |point: Vec<Rational>| reduction::restored(&point, &equations);
    Ok(match on_rest(&literals, &sides, effort, progress)? {
        Decision::Holds(mut proof) => {
            proof.zeros = proof.zeros.into_iter().map(restored).collect();
            proof.places.clear();
            Decision::Holds(proof)
        }
        Decision::Fails(point) => Decision::Fails(restored(point)),
        // The variables that were replaced have no rational values there.
        Decision::FailsAt(places) => {
            let list: Vec<String> = places.iter().map(ToString::to_string).collect();
            Decision::Undecided(Open::at_point(format!("it fails where the other numbers are {}", list.join(", "))))
        }
        Decision::Undecided(mut open) => {
            for sides in &mut open.boxes {
                equations.iter().for_each(|(variable, _)| sides[*variable] = domain[*variable].clone());
            }
            Decision::Undecided(Open { share: None, ..open })
        }
    })
}

/// Whether a literal is true at a point, exactly or by enclosure.
pub fn is_true_at<F: Function>(clause: &[Literal<F>], point: &[Rational]) -> bool {
    matches!(local::at_point(clause, point), local::Signs::Holds { .. })
}

/// Whether a literal is true at a point in closed form, exactly.
pub fn is_true_in_closed_form<F: Function>(clause: &[Literal<F>], places: &[Place]) -> bool {
    matches!(places::truth(clause, places), local::Signs::Holds { .. })
}

/// A point of the domain at which the function of a literal is 0, which is proved: a number in closed form for each variable, or an enclosure of it.
pub fn zero<F: Function>(literal: &Literal<F>, domain: &[Side]) -> Option<Vec<Place>> {
    attained::zero(literal, domain)
}

/// A point at which a literal that has to be strict is 0, and all others are false.
fn fails_at_zero<F: Function>(clause: &[Literal<F>], domain: &[Side]) -> Option<Vec<Place>> {
    let strict = |literal: &&Literal<F>| !literal.compared.admits(arithmetic::Sign::Zero);
    clause.iter().enumerate().filter(|(_, literal)| strict(literal)).find_map(|(k, literal)| {
        let places = attained::zero(literal, domain)?;
        let mut others = clause.iter().enumerate().filter(|(j, _)| *j != k).map(|(_, own)| own);
        let is_false = |own: &Literal<F>| places::truth(std::slice::from_ref(own), &places) == local::Signs::Fails;
        others.all(is_false).then_some(places)
    })
}

/// Where no literal in one variable is true.
fn on_rest<F: Function>(
    clause: &[Literal<F>],
    domain: &[Side],
    effort: Effort,
    progress: &dyn Progress,
) -> Result<Decision, Cancelled> {
    let Some(rest) = reduction::narrowed(clause, domain) else {
        return Ok(Decision::Holds(Proof { methods: vec![Method::Enclosures], ..Proof::default() }));
    };
    let decision = on_box(clause, &rest, effort, progress)?;
    let same = rest.iter().zip(domain).all(|(part, whole)| part.as_point().is_some() == whole.as_point().is_some());
    let whole = subdivision::volume(domain).filter(|whole| same && *whole > 0.0);
    let volumes = subdivision::volume(&rest).zip(whole);
    Ok(match decision {
        Decision::Undecided(open) => {
            let share = open.share.zip(volumes).map(|(share, (part, whole))| share * (part / whole).min(1.0));
            Decision::Undecided(Open { share, ..open })
        }
        decided => decided,
    })
}

fn on_box<F: Function>(
    clause: &[Literal<F>],
    domain: &[Side],
    effort: Effort,
    progress: &dyn Progress,
) -> Result<Decision, Cancelled> {
    let found = points::search(clause, domain, progress)?;
    if let Some(at) = found.counterexample {
        return Ok(Decision::Fails(at));
    }
    // Boxes of many numbers say little, and cost much.
    if (effort.certified || places::free(domain).len() > MANY)
        && let goals::Outcome::Proved(proof) =
            goals::prove(clause, domain, Effort { certified: true, ..effort }, progress)?
    {
        return Ok(with_zeros(Decision::Holds(proof), found.zeros));
    }
    let effort = Effort { certified: false, ..effort };
    let first = Effort { boxes: FIRST_BOXES.min(effort.boxes), ..effort };
    let open = match subdivision::divide(clause, domain, &[], first, progress)? {
        Decision::Undecided(open) => open,
        decided => return Ok(with_zeros(decided, found.zeros)),
    };
    let places = places::zeros(clause, domain);
    if let Some(places) = places.iter().find_map(|place| place.fails(clause, domain)) {
        return Ok(Decision::FailsAt(places));
    }
    if !places.is_empty()
        && let Decision::Holds(mut proof) = subdivision::divide(clause, domain, &places, first, progress)?
    {
        let point: Vec<Rational> = domain.iter().map(Side::middle).collect();
        let free = places::only_free(domain).unwrap_or_default();
        proof.places = places.iter().map(|place| place.on_line(&point, free)).collect();
        return Ok(with_zeros(Decision::Holds(proof), found.zeros));
    }
    if let Some(places) = fails_at_zero(clause, domain) {
        return Ok(Decision::FailsAt(places));
    }
    if let Some(places) = surfaces::fails_on(clause, domain) {
        return Ok(Decision::FailsAt(places));
    }
    if let Some(decision) = faces::decided(clause, domain, effort, progress)? {
        return Ok(with_zeros(decision, found.zeros));
    }
    // An equation is never shown by boxes.
    let effort = match clause.iter().all(|literal| literal.compared == crate::function::Compared::Zero) {
        true => Effort { boxes: FIRST_BOXES.min(effort.boxes), ..effort },
        false => effort,
    };
    let degrees = match goals::prove(clause, domain, effort, progress)? {
        goals::Outcome::Proved(mut proof) => {
            proof.boxes += open.looked;
            proof.methods.sort_unstable();
            proof.methods.dedup();
            return Ok(with_zeros(Decision::Holds(proof), found.zeros));
        }
        goals::Outcome::Open(degrees) => degrees,
    };
    if let Some(decision) = rewritten::decided(clause, domain, effort, progress)? {
        return Ok(with_zeros(decision, found.zeros));
    }
    let rest = if effort.boxes <= FIRST_BOXES {
        Decision::Undecided(open)
    } else {
        subdivision::divide(clause, domain, &places, effort, progress)?
    };
    Ok(match rest {
        Decision::Undecided(all) => {
            let several = || places::all_but_equal(clause, all.boxes.first()?, domain);
            let told = match places::only_free(domain) {
                Some(_) => places::coincidence(clause, domain),
                None => several(),
            };
            let why = match told {
                Some(told) => format!("{}; {told}", all.why),
                None => all.why,
            };
            Decision::Undecided(Open { degrees, why, ..all })
        }
        decided => with_zeros(decided, found.zeros),
    })
}

fn with_zeros(decision: Decision, zeros: Vec<Vec<Rational>>) -> Decision {
    match decision {
        Decision::Holds(mut proof) => {
            zeros.into_iter().for_each(|zero| {
                if !proof.zeros.contains(&zero) {
                    proof.zeros.push(zero)
                }
            });
            Decision::Holds(proof)
        }
        other => other,
    }
}
