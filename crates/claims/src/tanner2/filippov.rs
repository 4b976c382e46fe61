//! tanner2.eq10_exist, appA.def4, appA_uniq, appA.thm4: solutions of equations with discontinuous right-hand sides.

use super::figures::other;
use arithmetic::{Rational, Signed, rational};
use ledger::Record;
use ledger::{CheckError, Evidence, Fault, Grade, Outcome, Run};
use models::double_integrator::{Coordinates, Kink, Pair, Potential, Span, State, Way, fork, linked_within, tied};

const PLANE: Coordinates = Coordinates::Cartesian;

/// A right-hand side on the line with one jump: `left` for `x < 0`, `right` for `x >= 0`.
#[derive(Debug, Clone, Copy)]
struct Step {
    left: i64,
    right: i64,
}

impl Step {
    /// Every such field with values -1, 0, 1.
    fn all() -> impl Iterator<Item = Step> {
        (-1..=1).flat_map(|left| (-1..=1).map(move |right| Step { left, right }))
    }

    /// `K[f]` on the side that the solution `x = c t` is on for `t > 0`.
    fn inclusion(self, c: i64) -> Span<Rational> {
        let (left, right) = (rational(self.left, 1), rational(self.right, 1));
        match c.signum() {
            1 => Span { lo: right.clone(), hi: right },
            -1 => Span { lo: left.clone(), hi: left },
            _ => Span { lo: left.clone().min(right.clone()), hi: left.max(right) },
        }
    }

    /// The `c` for which `x = c t` is a Filippov solution from 0.
    fn rays(self) -> Vec<i64> {
        (-1..=1).filter(|&c| self.inclusion(c).contains(&rational(c, 1))).collect()
    }
}

// --- Uniqueness for measurable fields ---

/// The class of fields for which solutions are said to be unique.
#[derive(Clone, Copy)]
pub struct UniqueVariant(fn(i64, i64) -> bool);

fn examine_unique(variant: &UniqueVariant, _run: &mut Run) -> Result<Outcome, CheckError> {
    let mut cases = 0;
    for field in Step::all().filter(|field| variant.0(field.left, field.right)) {
        let rays = field.rays();
        cases += 1;
        if rays.len() != 1 {
            let what = format!(
                "f(x) = {} for x < 0 and {} for x >= 0 is measurable and bounded; from x(0) = 0 there are the solutions x = ct with c = {rays:?}",
                field.left, field.right
            );
            return Ok(Outcome::fails(
                what,
                Evidence::new(Grade::Exact, "solutions from the jump", "the inclusion checked for x = ct"),
            ));
        }
    }
    let detail = "for all one-sided Lipschitz fields: |x - y|² grows at most like exp(2lt), so equal starts stay equal; checked on step fields with values -1, 0, 1";
    Ok(Outcome::Holds(vec![Evidence::new(Grade::Exact, "solutions from the jump", detail).cases(cases)]))
}

pub fn uniqueness() -> Record<UniqueVariant> {
    Record::new(
        "tanner2.appA_uniq",
        "Measurability (with local boundedness) gives existence only. f = sign(x) has the Filippov solutions t, -t and 0 from 0. Uniqueness needs a one-sided bound, (f(x) - f(y)).(x - y) <= l |x - y|² for almost \
         all x, y (Filippov): then the distance of two solutions grows at most like exp(lt).",
        UniqueVariant(|_, _| true),
        examine_unique,
    )
    .repaired(
        Fault::False,
        "The definition gives existence; solutions are unique (forwards) if (f(x) - f(y)).(x - y) <= l |x - y|² for almost all x, y near each point.",
        UniqueVariant(|left, right| right <= left),
    )
    .control("fields bounded by 1", UniqueVariant(|left, right| left.abs() <= 1 && right.abs() <= 1))
    .control("increasing fields", UniqueVariant(|left, right| right >= left))
}

// --- Definition 4 ---

/// What a solution has to fulfil almost everywhere.
#[derive(Clone, Copy)]
pub enum SolutionVariant {
    /// `xdot = K[f](x)` as sets.
    Equal,
    /// `xdot` is one of `K[f](x)`.
    Member,
    /// `xdot` is one of the limits of `f`, without the hull.
    Limit,
    /// `xdot = f(x)`.
    Classical,
}

fn examine_solution(variant: &SolutionVariant, _run: &mut Run) -> Result<Outcome, CheckError> {
    let mut cases = 0;
    for field in Step::all() {
        let solves = |c: i64| {
            let (span, rate) = (field.inclusion(c), rational(c, 1));
            match variant {
                SolutionVariant::Equal => span.lo == rate && span.hi == rate,
                SolutionVariant::Member => span.contains(&rate),
                SolutionVariant::Limit => span.lo == rate || span.hi == rate,
                SolutionVariant::Classical => c == if c < 0 { field.left } else { field.right },
            }
        };
        cases += 1;
        if !(-1..=1).any(solves) {
            let what = format!(
                "f(x) = {} for x < 0 and {} for x >= 0: no solution starts from 0, not even x = 0, where K[f](0) = [{}, {}]",
                field.left,
                field.right,
                field.inclusion(0).lo,
                field.inclusion(0).hi
            );
            return Ok(Outcome::fails(
                what,
                Evidence::new(Grade::Exact, "solutions from the jump", "every ray and the point 0"),
            ));
        }
    }
    let detail =
        "bounded measurable fields have solutions by the inclusion (Filippov); step fields with values -1, 0, 1";
    Ok(Outcome::Holds(vec![Evidence::new(Grade::Exact, "solutions from the jump", detail).cases(cases)]))
}

pub fn definition4() -> Record<SolutionVariant> {
    Record::new(
        "tanner2.appA.def4",
        "K[f](x) is a set; with an equality sign x = 0 would not solve xdot = -sign(x), where K[f](0) = [-1, 1], and nothing else starts there. The text after the definition has it right: the tangent vector belongs to \
         the hull.",
        SolutionVariant::Equal,
        examine_solution,
    )
    .repaired(Fault::Slip, "... and for almost all t, xdot is an element of K[f](x).", SolutionVariant::Member)
    .control("without the convex hull", SolutionVariant::Limit)
    .control("xdot = f(x)", SolutionVariant::Classical)
}

// --- Theorem 4 ---

/// The chain rule with `V` of `arguments(n)` variables, with or without the 1 for the time, almost everywhere or everywhere.
#[derive(Clone, Copy)]
pub struct ChainRuleVariant {
    arguments: fn(usize) -> usize,
    time: bool,
    everywhere: bool,
}

fn examine_chain_rule(variant: &ChainRuleVariant, _run: &mut Run) -> Result<Outcome, CheckError> {
    for dimension in 1..=3 {
        if (variant.arguments)(dimension) != dimension + 1 {
            let what = format!(
                "x in R^{dimension}: V has {} arguments, but (x(t), t) has {}",
                (variant.arguments)(dimension),
                dimension + 1
            );
            return Ok(Outcome::fails(what, Evidence::new(Grade::Text, "the domain of V", "dimensions compared")));
        }
    }
    // V = |x| + 3t is Lipschitz and regular; x = ct solves a step field. At x = 0 the generalised gradient is [-1, 1] x {3}.
    let one = rational(1, 1);
    let absolute = Kink { left: -one.clone(), right: one.clone() };
    let own = rational(if variant.time { 3 } else { 0 }, 1);
    let mut cases = 0;
    for field in Step::all() {
        for c in field.rays() {
            let rate = absolute.directional(&rational(c, 1)) + rational(3, 1);
            let hull = field.inclusion(c);
            let slopes = match c.signum() {
                1 => vec![one.clone()],
                -1 => vec![-one.clone()],
                // The intersection over all z in [-1, 1]: -1, 0 and 1 give it for an interval K.
                _ => vec![-one.clone(), rational(0, 1), one.clone()],
            };
            let spans = slopes.iter().map(|z| {
                let ends = [&hull.lo * z + &own, &hull.hi * z + &own];
                let [a, b] = ends;
                Span { lo: a.clone().min(b.clone()), hi: a.max(b) }
            });
            let inside = spans.into_iter().all(|span| span.contains(&rate));
            cases += 1;
            if !inside {
                let what = format!("V = |x| + 3t along x = {c}t: dV/dt = {rate} is not in the set");
                return Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "the chain rule", "exact sets")));
            }
        }
    }
    // x = t - 1 solves xdot = 1 and passes the kink of V at t = 1, where V has two one-sided rates.
    if variant.everywhere && absolute.directional(&one) != -absolute.directional(&-one.clone()) {
        let what = "V = |x| along x = t - 1: V has no derivative at t = 1".to_string();
        return Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "the chain rule", "one-sided rates")));
    }
    let detail = "for all: where x(t) and V(x(t), t) are differentiable, regularity makes z.(xdot, 1) the same for every z of the gradient (notes/tanner2.md); V = |x| + 3t along rays of step fields";
    Ok(Outcome::Holds(vec![Evidence::new(Grade::Exact, "the chain rule", detail).cases(cases)]))
}

pub fn chain_rule() -> Record<ChainRuleVariant> {
    let printed = ChainRuleVariant { arguments: |_| 2, time: true, everywhere: false };
    let repaired = ChainRuleVariant { arguments: |n| n + 1, ..printed };
    Record::new(
        "tanner2.appA.thm4",
        "x(t) lies in R^n, so V(x(t), t) needs V on R^n x R; as printed, V: R x R -> R, it makes sense for n = 1 only. With that the theorem is Shevitz and Paden's: for almost all t, x and V(x(t), t) are \
         differentiable, and regularity gives d/dt V = z.(xdot, 1) for every z of the gradient.",
        printed,
        examine_chain_rule,
    )
    .repaired(Fault::Slip, "... V: R^n x R -> R ...", repaired)
    .control("K[f] with 0 in place of 1", ChainRuleVariant { time: false, ..repaired })
    .control("for every t", ChainRuleVariant { everywhere: true, ..repaired })
    .control("V of x alone", ChainRuleVariant { arguments: |n| n, ..repaired })
}

// --- Existence and uniqueness for (10) ---

/// The starts from which solutions are said to be unique.
#[derive(Clone, Copy)]
pub enum StartVariant {
    /// All.
    All,
    /// Those with a connected neighbouring graph.
    Connected,
    /// Those where no tied pair is at relative rest.
    Moving,
    /// Those where every tied pair crosses the threshold: `r_ij . v_ij != 0`.
    Crossing,
}

struct Start {
    name: &'static str,
    square: Rational,
    state: State<Rational>,
}

fn starts() -> Vec<Start> {
    let q = |n: i64| rational(n, 1);
    let state = |positions: &[(i64, i64)], velocities: &[(i64, i64)]| State {
        positions: positions.iter().map(|&(x, y)| [q(x), q(y)]).collect(),
        velocities: velocities.iter().map(|&(x, y)| [q(x), q(y)]).collect(),
    };
    let start = |name, square, positions: &[(i64, i64)], velocities: &[(i64, i64)]| Start {
        name,
        square: q(square),
        state: state(positions, velocities),
    };
    vec![
        start("two agents at rest at distance R = 2", 4, &[(0, 0), (2, 0)], &[(0, 0), (0, 0)]),
        start("two agents at distance R = 2, moving across with speeds 1/1", 4, &[(0, 0), (2, 0)], &[(0, 1), (0, 0)]),
        start(
            "three agents at rest in a row at distances 1, R = 2",
            4,
            &[(0, 0), (1, 0), (2, 0)],
            &[(0, 0), (0, 0), (0, 0)],
        ),
        start(
            "three agents at rest at the corners (-1, 0), (1, 0), (0, 1), R = 2",
            4,
            &[(-1, 0), (1, 0), (0, 1)],
            &[(0, 0), (0, 0), (0, 0)],
        ),
        start("two agents at distance R = 2 that approach", 4, &[(0, 0), (2, 0)], &[(1, 0), (0, 0)]),
        start("two agents at distance R = 2 that part", 4, &[(0, 0), (2, 0)], &[(-1, 1), (0, 0)]),
        start("two agents at distance 1, R = 2", 4, &[(0, 0), (1, 0)], &[(0, 1), (0, 0)]),
    ]
}

/// In words, the ways in which the pairs at the threshold can go on.
fn ways_on(start: &Start) -> Result<Vec<String>, CheckError> {
    let one = rational(1, 1);
    let potential = Potential::inverse_square_spring(&one, &one);
    let fork = fork(&start.state, &start.square, PLANE, &potential).map_err(other)?;
    if fork.branches.iter().any(|branch| !branch.decided) {
        return Err(other(format!("{}: the ways on are not decided", start.name)));
    }
    let word = |(_, way): &(Pair, Way<Rational>)| match way {
        Way::Leaves => "not linked, with growing distance",
        Way::Enters => "linked, with falling distance",
        Way::Stays(_) => "at distance R for a while",
    };
    Ok(fork.branches.iter().map(|branch| branch.ways.iter().map(word).collect::<Vec<_>>().join(", ")).collect())
}

fn examine_starts(variant: &StartVariant, _run: &mut Run) -> Result<Outcome, CheckError> {
    let mut cases = 0;
    for start in starts() {
        let ties = tied(&start.state.positions, &start.square, PLANE);
        let rate = |&(i, j): &Pair| PLANE.product(&start.state.separation(i, j), &start.state.relative_velocity(i, j));
        let still = |&(i, j): &Pair| start.state.relative_velocity(i, j).iter().all(|x| *x == rational(0, 1));
        let meant = match variant {
            StartVariant::All => true,
            StartVariant::Connected => linked_within(&start.state.positions, &start.square, PLANE).is_connected(),
            StartVariant::Moving => !ties.iter().any(still),
            StartVariant::Crossing => ties.iter().all(|pair| rate(pair).sign() != Some(arithmetic::Sign::Zero)),
        };
        if !meant {
            continue;
        }
        cases += 1;
        let ways = ways_on(&start)?;
        if ways.len() > 1 {
            let what = format!("V = s + 1/s - 2, {}: the pair can go on {}", start.name, ways.join("; or "));
            let detail = "exact second derivatives of |r_ij|² on both sides";
            return Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "solutions of (10) from ties", detail)));
        }
    }
    let detail = "existence: K[u] is bounded near the start, closed and convex (Filippov). Uniqueness while every pair at |r_ij| = R has r_ij.v_ij != 0: the rate of |r_ij|² does not jump, so each pair passes \
                  at once and the motion is smooth on both sides (notes/tanner2.md); starts of two and three agents";
    Ok(Outcome::Holds(vec![Evidence::new(Grade::Exact, "solutions of (10) from ties", detail).cases(cases)]))
}

pub fn existence() -> Record<StartVariant> {
    Record::new(
        "tanner2.eq10_exist",
        "Boundedness of u gives existence, not uniqueness. At |r_ij| = R with r_ij.v_ij = 0 the second derivative of |r_ij|² jumps from a - 8 V'(R²) R² (linked) to a (not linked). Two agents at rest at distance R: staying \
         at rest is a solution, and falling together is another one; they may also wait for any time first. With a > 0 > a - 8 V'(R²) R² there are three ways on, on connected graphs too.",
        StartVariant::All,
        examine_starts,
    )
    .repaired(
        Fault::False,
        "Solutions of (10) exist for as long as no two agents collide; they are unique as long as no pair has |r_ij| = R and r_ij.v_ij = 0 at the same time.",
        StartVariant::Crossing,
    )
    .control("with a connected graph", StartVariant::Connected)
    .control("unless a tied pair is at relative rest", StartVariant::Moving)
}
