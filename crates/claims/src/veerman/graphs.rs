//! veerman.nth_neighbour, veerman.onlytwo: other communication graphs on the line.

use super::one_sided::negative_gains;
use arithmetic::identity::RationalIdentity;
use arithmetic::{ArithmeticError, Complex, Field, Rational, Ring, rational};
use ledger::{CheckError, Claim, Control, Evidence, Fault, Grade, Outcome, Repair, Run, interval_value};
use models::platoon::{
    Communication, CommunicationGraph, Gains, amplitude_one_sided, amplitudes_two_sided, gain_squared_one_sided,
    resonance,
};

/// veerman.nth_neighbour.
pub struct NthNeighbour;

/// For every `n >= smallest`: the graph is connected or not, and some followers, or all, stay behind.
#[derive(Clone, Copy)]
pub struct NeighbourVariant {
    smallest: usize,
    connected: bool,
    all_stay: bool,
}

impl Claim for NthNeighbour {
    type Variant = NeighbourVariant;

    fn id(&self) -> &str {
        "veerman.nth_neighbour"
    }

    fn derivation(&self) -> &str {
        "Tracking joins agents whose numbers differ by n, so it stays within the residue classes modulo n; the leader is in the class of \
         0. For n >= 2 agent 1 is in another one: the graph of the agents 0 to N + 1 is not connected, and agents of the other classes, \
         at rest in formation, stay at rest whatever the leader does. For n = 1 the \
         graph is the path of system (2): connected, and everyone follows. The statement needs n >= 2, which it does not say. Agents without an n-th one in front or behind \
         track the other only, like the last car of (2), or nobody."
    }

    fn printed(&self) -> NeighbourVariant {
        NeighbourVariant { smallest: 1, connected: false, all_stay: false }
    }

    fn repair(&self) -> Option<Repair<NeighbourVariant>> {
        Some(Repair {
            fault: Fault::Slip, clauses: Vec::new(),
            statement: "If each agent keeps track of only the n-th agent in front and behind it, with n >= 2, the communication graph \
                        is not connected and therefore some agents will stay behind."
                .to_string(),
            variant: NeighbourVariant { smallest: 2, ..self.printed() },
        })
    }

    fn controls(&self) -> Vec<Control<NeighbourVariant>> {
        let repaired = NeighbourVariant { smallest: 2, ..self.printed() };
        vec![
            Control::new("connected for n >= 2", NeighbourVariant { connected: true, ..repaired }),
            Control::new("all agents stay behind", NeighbourVariant { all_stay: true, ..repaired }),
        ]
    }

    fn examine(&self, variant: &NeighbourVariant, _: &mut Run) -> Result<Outcome, CheckError> {
        const MOST_N: usize = 8;
        const MOST: usize = 14;
        let mut cases = 0;
        for n in variant.smallest..=MOST_N {
            for followers in 1..=MOST {
                let graph = CommunicationGraph::nth_neighbours(n, followers)?;
                let behind = staying_behind(&graph);
                let as_claimed = if variant.all_stay { behind.len() == followers } else { !behind.is_empty() };
                cases += 1;
                if graph.is_connected() != variant.connected || !as_claimed {
                    let what = if graph.is_connected() { "connected" } else { "not connected" };
                    return Ok(Outcome::fails(
                        format!(
                            "n = {n}, N = {}: the graph is {what}, and the followers {behind:?} stay at rest",
                            followers - 1
                        ),
                        Evidence::new(Grade::Exhaustive, "communication graphs", "built and followed exactly"),
                    ));
                }
            }
        }
        let detail = format!("n = {} to {MOST_N}, 1 to {MOST} followers; accelerations exact", variant.smallest);
        Ok(Outcome::Holds(vec![Evidence::new(Grade::Exhaustive, "communication graphs", detail).cases(cases)]))
    }
}

/// The followers outside the leader's reach, if the law indeed leaves them at rest while all others move.
fn staying_behind(graph: &CommunicationGraph) -> Vec<usize> {
    let reached = graph.reached_by_leader();
    let moving = |k: usize| rational(if reached[k] { k as i64 + 1 } else { 0 }, 3);
    let state: Vec<Rational> = (1..=graph.followers()).map(moving).collect();
    let gains = Gains { f: rational(-2, 1), g: rational(-1, 3) };
    let leader = rational(7, 1);
    let forces = graph.accelerations(&gains, (&leader, &leader), &state, &state);
    (1..=graph.followers()).filter(|&k| !reached[k] && forces[k - 1] == rational(0, 1)).collect()
}

/// veerman.onlytwo.
pub struct OnlyTwo;

/// Which degrees p = 0 to 3 occur as growth `M^p` of the peak response; the family of degree p is claimed to have the degree `p + shift`.
#[derive(Clone, Copy)]
pub struct GrowthVariant {
    occurs: [bool; 4],
    shift: u32,
}

/// Everyone tracks the leader: all amplitudes are 1/gamma.
struct Star(usize);

impl RationalIdentity for Star {
    fn variables(&self) -> usize {
        3
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [f, g, w] = at else { return Err(ArithmeticError::Domain("three variables")) };
        let gains = Gains { f: f.clone(), g: g.clone() };
        let graph = CommunicationGraph::star(self.0).map_err(|_| ArithmeticError::Domain("followers"))?;
        let one = amplitude_one_sided(&gains, w, 1)?;
        Ok((parts(graph.response(&gains, w)?), parts(vec![one; self.0])))
    }

    fn in_domain(&self, at: &[Rational]) -> bool {
        negative_gains(at)
    }
}

/// `platoons` two-sided platoons of `length` cars in series: the last car has the power of the single platoon's last amplitude.
struct Series {
    length: usize,
    platoons: usize,
}

impl RationalIdentity for Series {
    fn variables(&self) -> usize {
        3
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [f, g, w] = at else { return Err(ArithmeticError::Domain("three variables")) };
        let gains = Gains { f: f.clone(), g: g.clone() };
        let graph = CommunicationGraph::in_series(&vec![self.length; self.platoons])
            .map_err(|_| ArithmeticError::Domain("followers"))?;
        let last = |amplitudes: Vec<Complex<T>>| amplitudes.last().cloned().ok_or(ArithmeticError::Domain("followers"));
        let whole = last(graph.response(&gains, w)?)?;
        let single = last(amplitudes_two_sided(&gains, w, self.length)?)?;
        Ok((parts(vec![whole]), parts(vec![single.power(self.platoons as u64)])))
    }

    fn in_domain(&self, at: &[Rational]) -> bool {
        negative_gains(at)
    }
}

fn parts<T>(numbers: Vec<Complex<T>>) -> Vec<T> {
    numbers.into_iter().flat_map(|z| [z.re, z.im]).collect()
}

impl Claim for OnlyTwo {
    type Variant = GrowthVariant;

    fn id(&self) -> &str {
        "veerman.onlytwo"
    }

    fn derivation(&self) -> &str {
        "Put two two-sided platoons of m cars behind each other: car m ignores the car behind it and so leads the second platoon. Every \
         car tracks only its nearest cars, with a directed path from the leader to every agent. The last car responds with a_m², a_m = 1/T_m(gamma), so \
         the peak is A_m² = (M/2)²/X² + O(1): quadratic in M = 2m. With p platoons it is (M/p)^p/X^p, and with sqrt M platoons of sqrt M cars neither polynomial \
         nor exponential. If everyone tracks the leader all amplitudes are 1/gamma and the peak does not grow at all. The \
         experiments of the paper are not described; graphs in which all inner cars follow one rule are not settled by these examples."
    }

    fn printed(&self) -> GrowthVariant {
        GrowthVariant { occurs: [false, true, false, false], shift: 0 }
    }

    fn repair(&self) -> Option<Repair<GrowthVariant>> {
        Some(Repair {
            fault: Fault::False, clauses: Vec::new(),
            statement: "Exponential and linear growth both occur, but they are not the only possibilities: for every p >= 0 there \
                        are communication graphs of agents on a line, with a directed path from the leader to every agent, whose peak \
                        response grows like N^p (p two-sided flocks in series; for p = 0 every agent tracks the leader)."
                .to_string(),
            variant: GrowthVariant { occurs: [true; 4], shift: 0 },
        })
    }

    fn controls(&self) -> Vec<Control<GrowthVariant>> {
        let occurs = |occurs| GrowthVariant { occurs, shift: 0 };
        vec![
            Control::new("bounded growth too, but no other", occurs([true, true, false, false])),
            Control::new("up to quadratic growth", occurs([true, true, true, false])),
            Control::new("no linear growth", occurs([true, false, true, true])),
            Control::new("p platoons grow like M^(p+1)", GrowthVariant { occurs: [true; 4], shift: 1 }),
        ]
    }

    fn examine(&self, variant: &GrowthVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let mut results = Vec::new();
        // The quadratic case first: it needs the nearest cars only.
        for degree in [2, 1, 3, 0] {
            results.push(growth(degree, variant, run)?);
        }
        if results.iter().all(|result| matches!(result, Outcome::Holds(_))) {
            let part = "everyone tracks the leader: all amplitudes are 1/gamma, 3 followers";
            results.push(run.identity(&Star(3), &["f", "g", "w"], part)?);
            for (length, platoons) in [(2, 1), (1, 2), (2, 2), (1, 3)] {
                let part = format!("{platoons} platoons of {length} in series: the power of a_{length}");
                results.push(run.identity(&Series { length, platoons }, &["f", "g", "w"], &part)?);
            }
        }
        results.push(exponential()?);
        Run::all(results.into_iter().map(Ok))
    }
}

/// Certifies how the peak of the family of degree p grows from m cars per platoon to 8m and 64m: by `8^degree` up to 1 per cent.
fn growth(p: u32, variant: &GrowthVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let gains = Gains { f: rational(-1, 1), g: rational(-1, 1) };
    let degree = p + variant.shift;
    let mut grows = true;
    let mut peaks = Vec::new();
    for m in [32u64, 256, 2048] {
        // For p = 0 the peak is that of one follower, whatever M.
        let single = resonance(&gains, if p == 0 { 1 } else { m }, 20)?.amplitude;
        peaks.push(single.power(u64::from(p.max(1))));
    }
    for pair in peaks.windows(2) {
        let ratio = pair[1].over(&pair[0])? * pair[0].rational(&rational(1, 8i64.pow(degree)));
        let (lo, hi) = ratio.to_rationals();
        grows &= lo > rational(99, 100) && hi < rational(101, 100);
    }
    let name = if p == 0 { "everyone tracks the leader".to_string() } else { format!("{p} platoons in series") };
    let numbers: Vec<String> = peaks.iter().map(|peak| interval_value(peak, 8)).collect();
    let detail = format!("peaks {} for platoons of 32, 256, 2048 cars, f = g = -1", numbers.join(", "));
    run.value(&format!("peak_degree_{p}_platoons_of_256"), numbers[1].clone());
    let evidence = Evidence::new(Grade::Certified, name.clone(), detail).cases(peaks.len());
    let claimed = variant.occurs.get(p as usize).copied().unwrap_or(false);
    if grows != claimed {
        let grown = if grows { "grows" } else { "does not grow" };
        let what = format!("{name}, f = g = -1: the peak {grown} like M^{degree}: {}", numbers.join(", "));
        return Ok(Outcome::Fails { counterexample: what, evidence: vec![evidence] });
    }
    Ok(Outcome::Holds(vec![evidence]))
}

/// System (1) grows exponentially: the peak is the M-th power of a number above 1, exactly that of the graph.
fn exponential() -> Result<Outcome, CheckError> {
    let gains = Gains { f: rational(-1, 1), g: rational(-1, 1) };
    let w = rational(1, 1);
    let gain = gain_squared_one_sided(&gains, &w.square())?;
    for followers in 1..=8 {
        let last = CommunicationGraph::of(Communication::Front, followers)?.response(&gains, &w)?.pop();
        let size = last.map(|a| a.norm_squared());
        let evidence = Evidence::new(Grade::Exact, "exponential growth", "solved exactly");
        if size != Some(gain.power(followers as u64)) || gain <= rational(1, 1) {
            return Ok(Outcome::fails(format!("system (1), {followers} followers, w = 1"), evidence));
        }
    }
    let detail = "system (1), f = g = -1, w = 1: |a_M|² = 2^M exactly, 1 to 8 followers";
    Ok(Outcome::Holds(vec![Evidence::new(Grade::Exact, "exponential growth", detail).cases(8)]))
}
