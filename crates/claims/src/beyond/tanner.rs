//! beyond.tanner1.two_agents, turning_triangle; beyond.tanner2.alternating_trees, endless_switching, thm2_stop.

use crate::prelude::*;
use crate::tanner2::fixtures::{PLANE, printed as logarithmic, spring};
use crate::tanner2::switching::{Trees, no_common_configuration};
use algebra::graph::Graph;
use models::double_integrator::{
    AnyPotentials, HeadingDifference, Potential, State, cross, crosses_for_ever, difference, dot, gyroscopic, heading,
    kinetic_energy, potential_gradients, real_decaying_modes, scaled, sum,
};

/// `d/dt ½|v_1 + v_2|² = factor d (v_2 x v_1)/s`, where `d` is the heading difference of the law.
#[derive(Clone, Copy)]
pub struct TotalVariant {
    factor: i64,
    power: u64,
    linked: bool,
    /// What the law takes for the difference of the headings, in clause 2.
    difference: HeadingDifference,
}

/// Positions, speeds, half-angle tangents of the headings, the heading difference and the slope of the potential.
fn total_velocity(variant: &TotalVariant) -> Identity<'_> {
    Identity::new(10, move |at| {
        let velocity = |speed: &Probe, tangent: &Probe| -> Result<[Probe; 2], ArithmeticError> {
            let phasor = models::oscillator::phasor(tangent)?;
            Ok(scaled(speed, &[phasor.re, phasor.im]))
        };
        let state = State {
            positions: vec![[at[0].clone(), at[1].clone()], [at[2].clone(), at[3].clone()]],
            velocities: vec![velocity(&at[4], &at[6])?, velocity(&at[5], &at[7])?],
        };
        let links: &[(usize, usize)] = if variant.linked { &[(0, 1)] } else { &[] };
        let gradients = potential_gradients(&state.positions, links, PLANE, |_, _, _| Ok(at[9].clone()))?;
        let signed = |i: usize| if i == 0 { at[8].clone() } else { -at[8].clone() };
        let moving = state.moving(&gyroscopic(&state, &gradients, links, |i, _| signed(i))?);
        let total = sum(&moving.velocities[0], &moving.velocities[1]);
        let square = PLANE.square(&total);
        let left = (square.clone() * square.ratio(1, 2)).derivative;
        let [v, w] = [&state.velocities[0], &state.velocities[1]];
        let s = PLANE.square(&state.separation(0, 1));
        // w x v is |v_1||v_2| sin(theta_1 - theta_2).
        let right = at[8].clone() * cross(w, v) * at[0].integer(variant.factor);
        // The mechanical energy: the potential g s, and the kinetic energy.
        let square = PLANE.square(&moving.separation(0, 1));
        let energy = arithmetic::Dual::constant(at[9].clone()) * square + kinetic_energy(&moving.velocities, PLANE)?;
        Ok((vec![left, energy.derivative], vec![right.over(&s.power(variant.power))?, at[0].zero()]))
    })
}

/// The rate of `½|v_1 + v_2|²` under the law with this difference of headings, of two linked agents at (0, 0) and (1, 0); potential forces
/// cancel in it. At opposite directions the wrapped difference jumps; there the rate is 0 for any number in its place.
fn never_decreases(variant: &TotalVariant, run: &Run) -> Result<Outcome, CheckError> {
    const PRECISION: u32 = 80;
    let enclose = |q: &Rational| Interval::from_rational(q, PRECISION);
    let vector = |x: i64, y: i64| [rational(x, 1), rational(y, 1)];
    let mut list: Vec<(i64, i64)> =
        (-2..=2).flat_map(|x| (-2..=2).map(move |y| (x, y))).filter(|v| *v != (0, 0)).collect();
    list.sort_by_key(|(x, y)| (x * x + y * y, *x, *y));
    let both = list.iter().flat_map(|v| list.iter().map(move |w| (*v, *w)));
    let cases = both.filter(|((a, b), (c, d))| a * d != b * c || a * c + b * d > 0);
    let detail = "enclosures at least -2^-64, positions (0, 0), (1, 0), velocities with coordinates up to 2 in different directions that are not opposite, or equal ones";
    run.every(certified("the rate of ½|v_1 + v_2|²", detail), cases, |((a, b), (c, d))| {
        let exact = State { positions: vec![vector(0, 0), vector(1, 0)], velocities: vec![vector(a, b), vector(c, d)] };
        let state = exact.map(enclose);
        let angles = [heading(&state.velocities[0])?, heading(&state.velocities[1])?];
        let none = state.velocities.iter().map(|v| v.each_ref().map(Ring::zero)).collect::<Vec<_>>();
        let differ = |i: usize, j: usize| variant.difference.read(angles[i].clone() - &angles[j]);
        let accelerations = gyroscopic(&state, &none, &[(0, 1)], differ)?;
        let total = |list: &[[Interval; 2]]| sum(&list[0], &list[1]);
        let rate = dot(&total(&state.velocities), &total(&accelerations));
        Ok(at_most(&rate, &-rate.one().scaled(-64))?.then(|| {
            format!(
                "two linked agents at (0, 0) and (1, 0) with velocities ({a}, {b}) and ({c}, {d}), headings apart by {:.4} as numbers: ½|v_1 + v_2|² has the rate {:.4}",
                (angles[0].clone() - &angles[1]).to_f64(),
                rate.to_f64()
            )
        }))
    })
}

pub fn two_agents() -> Record<TotalVariant> {
    Record::new(
        "beyond.tanner1.two_agents",
        "Of two linked agents potential forces cancel in v_1 + v_2, and the alignment forces give d/dt ½|v_1 + v_2|² = 2 d |v_1||v_2| sin(theta_1 - theta_2)/s, for any number d in place of theta_1 - theta_2. With d in [-pi, pi] and equal to it modulo 2 pi, d sin d >= 0. The raw difference may lie \
         beyond pi, and then the sum of the velocities loses length.",
        TotalVariant { factor: 2, power: 1, linked: true, difference: HeadingDifference::Wrapped },
        |variant, run| {
            let names = ["x1", "y1", "x2", "y2", "speed 1", "speed 2", "tan(theta_1/2)", "tan(theta_2/2)", "d", "V'"];
            let rates = run.identity(&total_velocity(variant), &names, "the rates of ½|v_1 + v_2|² and of the energy, any potential")?;
            Run::all([
                Ok(rates.on([1, 3]).for_all()),
                never_decreases(variant, run).on([2]),
                argued(&[2], "d sin d >= 0, however many jumps", "notes/tanner1.md, Two agents, steps 1 to 3"),
            ])
        },
    )
    .clauses(&[
        "Two linked agents under (4), (5), neither at rest and not in one place: d/dt ½|v_1 + v_2|² = 2 |v_1||v_2| d sin(theta_1 - \
         theta_2)/|r_12|², where d is what the law takes for theta_1 - theta_2.",
        "With d wrapped to (-pi, pi], |v_1 + v_2| of two linked agents never decreases as long as the motion lasts.",
        "The mechanical energy of two linked agents is constant as long as the motion lasts.",
    ])
    .stated("replaces tanner1, eq (9), for two agents", "")
    .altered("half of it", |v| v.factor = 1)
    .altered("over the fourth power of the distance", |v| v.power = 2)
    .altered("not linked", |v| v.linked = false)
    .altered("raw differences in clause 2", |v| v.difference = HeadingDifference::Raw)
}

/// `omega` over `sqrt(3/2)`, and the whole turns by which heading differences are off the wrapped ones.
#[derive(Clone, Copy)]
pub struct TriangleVariant {
    rate: i64,
    whole_turns: [i64; 3],
}

pub fn turning_triangle() -> Record<TriangleVariant> {
    Record::new(
        "beyond.tanner1.turning_triangle",
        "The potential forces on an equilateral triangle with its centre at the origin are -6 V'(s) r_i, as the positions sum to zero: they keep it turning with omega² = 6 V'(s). Each agent has the two others' headings a third of a turn to its left and to its right, at equal distances: wrapped differences cancel. \
         The law is the same in turned coordinates, so this holds at all times. The motion fulfils the hypotheses of Proposition IV.3 (connected graph, finite V_t).",
        TriangleVariant { rate: 1, whole_turns: [0; 3] },
        |variant, _| {
            let evidence = exact("accelerations, headings, sides",
                "in the field of the cosines of multiples of pi/12, which has sqrt 2 and sqrt 3; at all times since the law is the same in turned coordinates",
            );
            let TriangleVariant { rate, whole_turns } = *variant;
            let potential = logarithmic();
            Ok(match models::double_integrator::turning_triangle(&potential, &rational(rate, 1), whole_turns)? {
                true => Outcome::Holds(vec![evidence.for_all()]),
                false => Outcome::fails(
                    format!("omega = {rate} sqrt(3/2), heading differences off the wrapped ones by {whole_turns:?} turns: the accelerations are not -omega² r_i"),
                    evidence,
                ),
            })
        },
    )
    .stated(
        "beside tanner1, Proposition IV.3",
        "Three linked agents on an equilateral triangle of squared side 2 that turns about its centre with omega² = 6 V'(2) = 3/2, V = 1/s \
         + log s, s the squared distance, move so for ever under (4), (5) with heading differences wrapped to (-pi, pi]: the headings stay \
         a third of a turn apart.",
    )
    .altered("omega² = 6", |v| v.rate = 2)
    .altered("heading differences as in (2)", |v| v.whole_turns = [1, 0, 0])
}

pub fn alternating_trees() -> Record<Trees> {
    let printed = Trees::two_paths();
    Record::new(
        "beyond.tanner2.alternating_trees",
        "If the velocities agreed in the limit, the three distances of the tree in use would tend to the desired one, at the switches too, where all six would be near it: impossible in the plane. So switching between connected graphs can keep a flock from ever agreeing, from any start.",
        printed.clone(),
        |variant, _| no_common_configuration(variant),
    )
    .stated(
        "sharpens tanner2, Abstract (arbitrary switching)",
        "Four agents in the plane under (4) with V = s + 1/s - 2, s the squared distance, and the links 1-2-3-4 and 2-4-1-3 in turn, each \
         for the same fixed time T > 0: in no motion that lasts for all time do the velocities agree in the limit.",
    )
    .altered("in space", |v| v.dimension = 3)
    .altered("one tree only", |v| v.trees = [printed.trees[0].clone(), printed.trees[0].clone()])
}

/// A start near the rhombus from which `|r_13| = R` is out of reach: at rest, symmetric, with sides 1 and squared diagonals `3 - e` and
/// `1 + e`. `Q` does not increase, and where `|r_13| = R` it is at least `V(R²)`, as no potential is negative.
fn out_of_reach(potential: &Potential, square: &Rational) -> Result<Option<String>, CheckError> {
    let value = |s: &Rational| potential.rational_value(s);
    let needed = value(square)?;
    let energy = |k: i32| -> Result<Rational, CheckError> {
        let e = rational(1, 10).pow(k);
        let sides = value(&rational(1, 1))? * rational(4, 1);
        Ok(value(&(rational(3, 1) - &e))? + value(&(rational(1, 1) + e))? + sides)
    };
    let energies = (1..=6).map(energy).collect::<Result<Vec<_>, _>>()?;
    Ok(energies.iter().all(|q| *q < needed).then(|| {
        format!(
            "R² = {square}, four agents at rest with sides 1 and squared diagonals 3 - e, 1 + e, e = 1/10, ..., 1/10^6: the energy Q, {} at e = 1/10, is less than V(R²) = {needed}, which it would need at |r_13| = R: the pair never gets there",
            energies[0]
        )
    }))
}

/// Symmetric motions near the rhombus that do not turn, so that one of them does not pass `R` any more.
fn settles_without_turning(potential: &Potential, square: &Rational) -> Result<Option<String>, CheckError> {
    Ok(real_decaying_modes(potential, square)?.map(|real| {
        format!(
            "R² = {square}: with the link 1-3 all {real} modes of symmetric motions near the rhombus decay without turning; one that tends to it along the slowest of them with |r_13| < R does not pass R any more"
        )
    }))
}

fn examine_endless(setting: &(Potential, Rational), _run: &mut Run) -> Result<Outcome, CheckError> {
    let (potential, square) = setting;
    if potential.check_definition3().is_ok()
        && let Some(what) = out_of_reach(potential, square)?
    {
        return Ok(Outcome::fails(what, exact("a start near the rhombus", "values of Q, exact rationals")));
    }
    let evidence = exact(
        "motions near two equilateral triangles side by side",
        "characteristic polynomials of the symmetric modes with and without the link: stable, no real root (Sturm, Routh)",
    );
    let fulfilled = potential.check_definition3().is_ok();
    if let Some(what) = settles_without_turning(potential, square)?.filter(|_| fulfilled) {
        return Ok(Outcome::fails(what, evidence));
    }
    if fulfilled && crosses_for_ever(potential, square)? {
        return Run::all([
            holds(evidence).checks("step 3"),
            argued(&[1], "the motions near it", "notes/tanner2.md, Endless switching, steps 1 to 4"),
        ]);
    }
    Ok(Outcome::Undecided(format!("R² = {square}: the modes do not decide what symmetric motions nearby do")))
}

pub fn endless_switching() -> Record<(Potential, Rational)> {
    let q = |n: i64| rational(n, 1);
    Record::new(
        "beyond.tanner2.endless_switching",
        "The rhombus is an equilibrium with |r_13| = R exactly. On motions that keep its diagonals the loop is stable on both sides of R and has no real rate there, so every other symmetric motion nearby tends to it in oscillations and passes R for ever, with a graph that is connected at all times. There are such motions from every symmetric start, since the law is symmetric. In the controls there are starts at rest near the rhombus with less energy than a passage of R needs.",
        (Potential::with_inflection(&q(3)), q(3)),
        examine_endless,
    )
    .stated(
        "limits tanner2, end of the proof of Theorem 2",
        "With V' = (s-1)(s-3)²(s+3/5)/s², s the squared distance (a potential of Definition 3, increasing beyond s = 1), and R² = 3, every \
         motion of four agents in the plane under (10) that starts near two equilateral triangles of side 1 side by side, 124 and 324 with \
         the common side 24, so that agents 1 and 3 are at the far ends with |r_13| = R, with nearly equal velocities, and stays mirror \
         symmetric about both diagonals, and is not that rhombus with a common velocity, passes |r_13| = R for ever (near and mirror \
         symmetric up to a common motion).",
    )
    .control("V = s + 1/s - 2, whose slope at R is positive", (spring(), q(3)))
    .control("R² = 4", (Potential::with_inflection(&q(4)), q(4)))
    .control("V' a hundredth of that, so that motions are overdamped", (Potential::with_inflection(&q(3)).times(&rational(1, 100)), q(3)))
}

/// The share of the jump `8 V'(R²) R²` that is claimed, and whether the slope at R may be zero.
#[derive(Clone, Copy)]
pub struct EndsVariant {
    share: (i64, i64),
    flat: bool,
}

/// The second derivative of `|r_e|²` under (4) changes by `-8 g s - 4 r.v` where the link e = (1, 2) is added, whatever the other links
/// and potentials are.
fn jump(graph: Graph, share: (i64, i64)) -> Identity<'static> {
    Identity::new(AnyPotentials::variables(&graph), move |at| {
        let with = AnyPotentials::read(&graph, at)?;
        let Some(link) = with.edges.iter().position(|pair| *pair == (0, 1)) else {
            return Err(ArithmeticError::Domain("a graph in which agents 1 and 2 are linked"));
        };
        let mut without = AnyPotentials::read(&graph, at)?;
        without.edges.remove(link);
        without.slopes.remove(link);
        let (r, v) = (with.state.separation(0, 1), with.state.relative_velocity(0, 1));
        let second = |flock: &AnyPotentials<Probe>| -> Result<Probe, ArithmeticError> {
            let a = flock.accelerations()?;
            Ok(dot(&r, &difference(&a[0], &a[1])) * v[0].integer(2) + PLANE.square(&v) * v[0].integer(2))
        };
        let pull = with.slopes[link].clone() * PLANE.square(&r) * r[0].integer(8) * r[0].ratio(share.0, share.1);
        let right = -pull - dot(&r, &v) * r[0].integer(4);
        Ok((vec![second(&with)? - second(&without)?], vec![right]))
    })
}

fn examine_ends(variant: &EndsVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let three = rational(3, 1);
    if variant.flat && crosses_for_ever(&Potential::with_inflection(&three), &three)? {
        let what = "V' = (s-1)(s-3)²(s+3/5)/s², R² = 3: motions near the rhombus tend to it, where one pair is at R, and that pair passes R for ever";
        return Ok(Outcome::fails(what, exact("switching near the rhombus", "exact modes")));
    }
    let graphs = [Graph::path(2), Graph::path(3), Graph::complete(3), Graph::path(4)];
    let jumps = graphs.into_iter().map(|graph| {
        let names = AnyPotentials::names(&graph);
        let part = format!("the pull of the link 1-2 on |r_12|², edges {:?}, any potentials", graph.edges());
        run.identity(&jump(graph, variant.share), &names, &part).checks("step 2")
    });
    let proof = argued(&[1], "late crossings", "notes/tanner2.md, When switching stops, steps 1 to 5");
    Run::all(jumps.chain([proof]))
}

pub fn switching_ends() -> Record<EndsVariant> {
    Record::new(
        "beyond.tanner2.thm2_stop",
        "With a positive slope the link pulls with a force that jumps at R, so after or before a late crossing the relative speed would change at a rate bounded away from 0 for a fixed time, but it tends to 0.",
        EndsVariant { share: (1, 1), flat: false },
        examine_ends,
    )
    .stated(
        "a part of tanner2, end of the proof of Theorem 2",
        "Take potentials of Definition 3 with a continuous gradient and V_ij'(R) > 0 for all pairs, no two agents in one place at the \
         start, the graph of the links |r_ij| < R connected at all times, and a Filippov solution of (10) with K of the whole vector field. \
         If no limit point of the relative positions has more than one pair at distance R, then from some time on no pair passes from one \
         side of R to the other unless it stays at R for an interval of time in between.",
    )
    .altered("slope zero at R too", |v| v.flat = true)
    .altered("half the pull", |v| v.share = (1, 2))
}
