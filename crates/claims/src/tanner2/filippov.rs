//! tanner2.eq10_exist, appA.def4, appA_uniq, appA.thm4: solutions of equations with discontinuous right-hand sides.

use super::fixtures::{PLANE, spring};
use crate::prelude::*;
use arithmetic::Signed;
use models::double_integrator::{Branch, Kink, Pair, Span, State, StepField, Way, fork, linked_within, tied};

/// The class of fields for which solutions are said to be unique.
#[derive(Clone, Copy)]
enum Class {
    Measurable,
    Continuous,
    /// `(f(x) - f(y)) (x - y) <= l (x - y)²`.
    OneSided,
}

/// A field on the line by its values.
type Field = dyn Fn(i64, u32) -> Rational;

impl Class {
    /// Whether a field, given at `sign/4^k`, is of the class near 0: at `k = 6` to 8, with `l = 16`.
    fn holds(self, field: &Field) -> bool {
        let near = |k: u32| {
            let half = rational(1, 4_i64.pow(k));
            let pairs = [(1, -1), (1, 0), (0, -1)];
            let apart = |(a, b): (i64, i64)| (field(a, k) - field(b, k), rational(a - b, 1) * &half);
            pairs.into_iter().map(apart).all(|(change, way)| match self {
                Class::Measurable => true,
                Class::Continuous => &change * &change <= rational(1, 256),
                Class::OneSided => change * &way <= rational(16, 1) * &way * &way,
            })
        };
        (6..=8).all(near)
    }
}

/// The class, and whether solutions are said to be unique backwards in time too.
#[derive(Clone, Copy)]
pub struct UniqueVariant {
    class: Class,
    backwards: bool,
}

/// `f(x) = 2 sqrt|x|` at `sign/4^k`, and whether `x = 0` and `x = t²` solve `xdot = f(x)` at `t = 1/2^k` from the same start.
fn root_branches(class: Class) -> Option<String> {
    let root = |sign: i64, k: u32| rational(2 * sign.abs(), 2_i64.pow(k));
    let branches = (6..=8).all(|k| {
        let rate = rational(2, 2_i64.pow(k));
        root(1, k) == rate && root(0, k) == rational(0, 1)
    });
    (class.holds(&root) && branches)
        .then(|| "f(x) = 2 sqrt|x|: from x(0) = 0 there are the solutions x = 0 and x = t²".to_string())
}

/// Speeds of rays, each by itself: what lies between two of them is none.
fn speeds(rays: &[i64]) -> String {
    rays.iter().map(|c| format!("c = {c}")).collect::<Vec<_>>().join(" and ")
}

fn examine_unique(variant: &UniqueVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    // Where a step jumps its value does not matter for almost all x, y: the sides are compared.
    let member = |step: &StepField| {
        let (left, right) = (step.left, step.right);
        variant.class.holds(&move |sign, _| rational(if sign < 0 { left } else { right }, 1))
    };
    let fields = StepField::all().filter(member);
    let detail = "the inclusion checked for x = ct, step fields with values -1, 0, 1";
    let rays = run.instances("solutions from the jump", detail, fields, |field| {
        let StepField { left, right } = field;
        let into: Vec<i64> = StepField { left: -left, right: -right }.rays();
        Ok(if field.rays().len() != 1 {
            Some(format!(
                "f(x) = {left} for x < 0 and {right} for x >= 0 is measurable and bounded; from x(0) = 0 there are the solutions x = ct with {}",
                speeds(&field.rays())
            ))
        } else {
            let several = variant.backwards && into.len() != 1;
            several.then(|| format!("f(x) = {left} for x < 0 and {right} for x >= 0: x = -ct with {} all end in x(0) = 0", speeds(&into)))
        })
    });
    let detail = "2 sqrt|x|, which x = 0 and x = t² solve, is not of the class";
    let root =
        run.instances("a continuous field with a root", detail, [variant.class], |class| Ok(root_branches(class)));
    Run::all([
        rays.checks("step 1"),
        root.checks("step 1"),
        argued(&[1], "one-sided bounds", "notes/tanner2.md, Appendix, step 1"),
    ])
}

pub fn uniqueness() -> Record<UniqueVariant> {
    Record::new(
        "tanner2.appA_uniq",
        "Measurability (with local boundedness) gives existence only. f = sign(x) has the Filippov solutions t, -t and 0 from 0. Uniqueness needs a one-sided bound, (f(x) - f(y)).(x - y) <= l |x - y|² for almost \
         all x, y (Filippov): then the distance of two solutions grows at most like exp(lt).",
        UniqueVariant { class: Class::Measurable, backwards: false },
        examine_unique,
    )
    .repaired(
        Fault::False,
        "Filippov solutions of xdot = f(x), f measurable and locally bounded on R^n, are unique (forwards) if (f(x) - f(y)).(x - y) <= l |x \
         - y|² for almost all x, y near each point, with a number l that may depend on the point.",
        UniqueVariant { class: Class::OneSided, backwards: false },
    )
    .altered("backwards in time too", |v| v.backwards = true)
    .altered("if f is continuous", |v| v.class = Class::Continuous)
}

/// What a solution has to fulfil almost everywhere.
#[derive(Clone, Copy)]
pub enum SolutionVariant {
    /// `xdot = K[f](x)` as sets.
    Equal,
    /// `xdot` is one of `K[f](x)`.
    Member,
    /// `xdot` is one of the limits of `f`, without the hull.
    Limit,
    /// `xdot` exists and is one of `K[f](x)` at all times.
    Everywhere,
}

fn examine_solution(variant: &SolutionVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let detail = "every ray and the point 0, step fields with values -1, 0, 1";
    let starts = run.instances("solutions from the jump", detail, StepField::all(), |field| {
        let solves = |c: i64| {
            let (span, rate) = (field.inclusion(c), rational(c, 1));
            match variant {
                SolutionVariant::Equal => span.lo == rate && span.hi == rate,
                SolutionVariant::Member | SolutionVariant::Everywhere => span.contains(&rate),
                SolutionVariant::Limit => span.lo == rate || span.hi == rate,
            }
        };
        let (at, StepField { left, right }) = (field.inclusion(0), field);
        if !(-1..=1).any(solves) {
            return Ok(Some(format!(
                "f(x) = {left} for x < 0 and {right} for x >= 0: no solution starts from 0, not even x = 0, where K[f](0) = [{}, {}]",
                at.lo, at.hi
            )));
        }
        // From 1 a field with right = -1 leads to the jump at t = 1; what goes on with another rate has a corner there.
        let corner = matches!(variant, SolutionVariant::Everywhere) && right == -1 && !solves(-1);
        Ok(corner.then(|| {
            format!("f(x) = {left} for x < 0 and {right} for x >= 0: the solution from 1 reaches 0 at t = 1 with the rate -1 and cannot go on with it")
        }))
    });
    Run::all([
        starts.checks("step 2"),
        argued(&[1], "that the definition has solutions", "notes/tanner2.md, Appendix, step 2"),
    ])
}

pub fn definition4() -> Record<SolutionVariant> {
    Record::new(
        "tanner2.appA.def4",
        "K[f](x) is a set; with an equality sign x = 0 would not solve xdot = -sign(x), where K[f](0) = [-1, 1], and nothing else starts there. The text after the definition has it right: the tangent vector belongs to \
         the hull.",
        SolutionVariant::Equal,
        examine_solution,
    )
    .repaired(
        Fault::Typo,
        "x(.) is a Filippov solution of xdot = f(x), f on R^n measurable and locally bounded, if it is absolutely continuous and for almost \
         all t xdot is an element of K[f](x); then there is a solution from every start for every bounded measurable f.",
        SolutionVariant::Member,
    )
    .control("without the convex hull", SolutionVariant::Limit)
    .control("for all t, not almost all", SolutionVariant::Everywhere)
}

/// The chain rule with `V` of `arguments(n)` variables, with or without the 1 for the time, almost everywhere or everywhere.
#[derive(Clone, Copy)]
pub struct ChainRuleVariant {
    arguments: fn(usize) -> usize,
    time: bool,
    everywhere: bool,
}

/// A ray of a step field along which `V = |x| + 3t` has a rate that is not in the set (A.2).
fn outside_chain_rule(field: StepField, c: i64, time: bool) -> Option<String> {
    let one = rational(1, 1);
    let absolute = Kink { left: -one.clone(), right: one.clone() };
    let own = rational(if time { 3 } else { 0 }, 1);
    let rate = absolute.directional(&rational(c, 1)) + rational(3, 1);
    let hull = field.inclusion(c);
    let slopes = match c.signum() {
        1 => vec![one],
        -1 => vec![-one],
        // The intersection over all z in [-1, 1]: -1, 0 and 1 give it for an interval K.
        _ => vec![-one.clone(), rational(0, 1), one],
    };
    let contains = |z: &Rational| {
        let [a, b] = [&hull.lo * z + &own, &hull.hi * z + &own];
        Span { lo: a.clone().min(b.clone()), hi: a.max(b) }.contains(&rate)
    };
    (!slopes.iter().all(contains)).then(|| format!("V = |x| + 3t along x = {c}t: dV/dt = {rate} is not in the set"))
}

fn examine_chain_rule(variant: &ChainRuleVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let part = "the domain of V";
    let domains = run.instances(part, "dimensions compared", 1..=3usize, |dimension| {
        let (has, needed) = ((variant.arguments)(dimension), dimension + 1);
        Ok((has != needed).then(|| format!("x in R^{dimension}: V has {has} arguments, but (x(t), t) has {needed}")))
    })?;
    // V = |x| + 3t is Lipschitz and regular; x = ct solves a step field. At x = 0 the generalised gradient is [-1, 1] x {3}.
    let rays = StepField::all().flat_map(|field| field.rays().into_iter().map(move |c| (field, c)));
    let detail = "exact sets, V = |x| + 3t along rays of step fields";
    let chain =
        run.instances("the chain rule", detail, rays, |(field, c)| Ok(outside_chain_rule(field, c, variant.time)))?;
    // x = t - 1 solves xdot = 1 and passes the kink of V at t = 1, where V has two one-sided rates.
    let one = rational(1, 1);
    let absolute = Kink { left: -one.clone(), right: one.clone() };
    if variant.everywhere && absolute.directional(&one) != -absolute.directional(&-one.clone()) {
        let what = "V = |x| along x = t - 1: V has no derivative at t = 1";
        return Ok(Outcome::fails(what, exact("the chain rule", "one-sided rates")));
    }
    let steps = "notes/tanner2.md, Appendix, steps 3 to 5";
    Run::all([Ok(domains).checks("the conclusion"), Ok(chain).checks("step 5"), argued(&[1], "the chain rule", steps)])
}

pub fn chain_rule() -> Record<ChainRuleVariant> {
    Record::new(
        "tanner2.appA.thm4",
        "x(t) lies in R^n, so V(x(t), t) needs V on R^n x R; as printed, V: R x R -> R, it makes sense for n = 1 only. With that the theorem is Shevitz and Paden's: for almost all t, x and V(x(t), t) are \
         differentiable, and regularity gives d/dt V = z.(xdot, 1) for every z of the gradient.",
        ChainRuleVariant { arguments: |_| 2, time: true, everywhere: false },
        examine_chain_rule,
    )
    .repaired_by(
        Fault::Typo,
        "Let x(.) be a Filippov solution to xdot = f(x,t), x in R^n, and V : R^n x R -> R Lipschitz and regular; then V(x(t),t) is absolutely continuous and d/dt V lies almost everywhere in the intersection over xi in dV of xi^T (K[f]; 1).",
        |v| v.arguments = |n| n + 1,
    )
    .altered("K[f] with 0 in place of 1", |v| v.time = false)
    .altered("for every t", |v| v.everywhere = true)
}

/// The starts from which solutions are said to be unique.
#[derive(Clone, Copy)]
enum Starts {
    All,
    /// Those with a connected neighbouring graph.
    Connected,
    /// Those where no tied pair is at relative rest.
    Moving,
    /// Those where every tied pair crosses the threshold: `r_ij . v_ij != 0`.
    Crossing,
}

/// Where solutions are said to be unique, and whether tied links may have weights between 0 and 1 (the convex hull of K).
#[derive(Clone, Copy)]
pub struct StartVariant {
    unique: Starts,
    hull: bool,
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
    let fork = fork(&start.state, &start.square, PLANE, &spring())?;
    if fork.branches.iter().any(|branch| !branch.decided) {
        return Err(CheckError::Other(format!("{}: the ways on are not decided", start.name)));
    }
    let word = |(_, way): &(Pair, Way<Rational>)| match way {
        Way::Leaves => "not linked, with growing distance",
        Way::Enters => "linked, with decreasing distance",
        Way::Stays(_) => "at distance R for a while",
    };
    Ok(fork.branches.iter().map(|branch| branch.ways.iter().map(word).collect::<Vec<_>>().join(", ")).collect())
}

fn means(variant: Starts, start: &Start) -> bool {
    let ties = tied(&start.state.positions, &start.square, PLANE);
    let rate = |&(i, j): &Pair| PLANE.product(&start.state.separation(i, j), &start.state.relative_velocity(i, j));
    let still = |&(i, j): &Pair| start.state.relative_velocity(i, j).iter().all(|x| *x == rational(0, 1));
    match variant {
        Starts::All => true,
        Starts::Connected => linked_within(&start.state.positions, &start.square, PLANE).is_connected(),
        Starts::Moving => !ties.iter().any(still),
        Starts::Crossing => ties.iter().all(|pair| rate(pair).sign() != Some(arithmetic::Sign::Zero)),
    }
}

fn examine_starts(variant: &StartVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let list = starts().into_iter().filter(|start| means(variant.unique, start));
    let detail = "exact second derivatives of |r_ij|² on both sides, starts of two and three agents";
    let ways = run.instances("solutions of (10) from ties", detail, list, |start| {
        let ways = ways_on(&start)?;
        let all = ways.join("; or ");
        Ok((ways.len() > 1).then(|| format!("V = s + 1/s - 2, {}: the pair can go on {all}", start.name)))
    })?;
    let steps = "notes/tanner2.md, Existence and uniqueness, steps 1 to 4";
    Run::all([
        Ok(ways.on([2])).checks("step 4"),
        some_way(variant.hull, run).checks("step 1").on([1]),
        argued(&[1, 2], "solutions of (10)", steps),
    ])
}

/// Three agents at rest in a row, R below the desired distance. Agent 3 pushes agent 2 towards agent 1; with the link in
/// force agents 1 and 2 would part, without it they would approach.
fn held_at_the_threshold() -> Start {
    let q = |n: i64| rational(n, 20);
    let state = State { positions: [0, 10, 19].map(|x| [q(x), q(0)]).to_vec(), velocities: vec![[q(0), q(0)]; 3] };
    Start { name: "three agents at rest at (0, 0), (1/2, 0), (19/20, 0), R = 1/2", square: rational(1, 4), state }
}

/// A solution goes on from ties of every kind.
fn some_way(hull: bool, run: &Run) -> Result<Outcome, CheckError> {
    let list = starts().into_iter().chain([held_at_the_threshold()]);
    let detail =
        "starts with tied pairs that pass, leave, enter or are held there; exact weights and second derivatives";
    run.instances("a way on from ties", detail, list, |start| {
        let fork = fork(&start.state, &start.square, PLANE, &spring())?;
        let held = |branch: &Branch<Rational>| branch.ways.iter().any(|(_, way)| matches!(way, Way::Stays(_)));
        let on = fork.branches.iter().any(|branch| branch.decided && (hull || !held(branch)));
        Ok((!on).then(|| format!("V = s + 1/s - 2, {}: no solution goes on", start.name)))
    })
}

pub fn existence() -> Record<StartVariant> {
    Record::new(
        "tanner2.eq10_exist",
        "Boundedness of u gives existence, not uniqueness. At |r_ij| = R with r_ij.v_ij = 0 the second derivative of |r_ij|² jumps from a - 8 V'(R²) R² (linked) to a (not linked). Two agents at rest at distance R: staying \
         at rest is a solution, and moving towards each other is another one; they may also wait for any time first. With a > 0 > a - 8 V'(R²) R² there are three ways on, on connected graphs too.",
        StartVariant { unique: Starts::All, hull: true },
        examine_starts,
    )
    .repaired_by(Fault::False, "", |v| v.unique = Starts::Crossing)
    .repaired_clauses(&[
        "With potentials of Definition 3 with a continuous gradient and K of the whole vector field, from every start in which no two \
         agents are in one place (10) has a solution for all time.",
        "If the gradients are locally Lipschitz, the solution is unique as long as no pair has |r_ij| = R and r_ij.v_ij = 0 at the same time.",
    ])
    .clauses(&[
        "Existence of the solutions of (10) is guaranteed by the boundedness of u_i.",
        "Uniqueness of the solutions of (10) is guaranteed by the boundedness of u_i.",
    ])
    .reading("K of the whole vector field, potentials of Definition 3 with a locally Lipschitz gradient")
    .altered("with a connected graph", |v| v.unique = Starts::Connected)
    .altered("unless a tied pair is at relative rest", |v| v.unique = Starts::Moving)
    .altered("without the convex hull", |v| v.hull = false)
}
