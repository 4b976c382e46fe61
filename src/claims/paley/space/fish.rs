//! paley.eq26, paley.vrep, paley.vatt, paley.eq28, paley.fish28ori, paley.chord, paley.fig7: the fish model.

use super::instances::{StateIdentity, described, identity_graphs, scattered_phasors, state_identity};
use crate::arithmetic::identity::RationalIdentity;
use crate::arithmetic::{ArithmeticError, Complex, Field, Rational, Ring, rational};
use crate::ledger::{CheckError, Claim, Control, Evidence, Fault, Grade, Outcome, Repair, Run};
use crate::oscillator::{
    CircularGains, Interaction, Neighbours, State, Zone, Zones, alignment, circle_centres, circular_control,
    circular_formation, heading_components, misalignment, phasor, quarter_turn, repulsion, steering_towards,
};

/// paley.eq26.
pub struct EulerStep;

/// Positions move by `T^position e^{i theta}` and phases by `T^phase u`.
#[derive(Clone, Copy)]
pub struct StepVariant {
    position: u64,
    phase: u64,
}

/// The increments of a step against those of Euler's method for (1), (2).
struct StepIdentity(StepVariant);

impl StateIdentity for StepIdentity {
    fn particles(&self) -> usize {
        1
    }

    fn sides<T: Field>(&self, constants: &[T], state: &State<T>) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [step, u] = constants else { return Err(ArithmeticError::Domain("two constants")) };
        let z = &state.phasors[0];
        let moved = z.scale(&step.power(self.0.position));
        let euler = z.scale(step);
        let turned = step.power(self.0.phase) * u;
        Ok((vec![moved.re, moved.im, turned], vec![euler.re, euler.im, step.clone() * u]))
    }

    fn allows(&self, constants: &[Rational]) -> bool {
        constants[0] > rational(0, 1)
    }
}

impl Claim for EulerStep {
    type Variant = StepVariant;

    fn id(&self) -> &str {
        "paley.eq26"
    }

    fn derivation(&self) -> &str {
        "The forward Euler method of step h for (1), (2) is r + h e^{i theta}, theta + h u: one step for both equations. (26) moves positions with the step 1 and \
         phases with the step T << 1, which is Euler's method for no h (h = 1 from the first line, h = T from the second). It is so for the first line \
         r + T e^{i theta}; or for a model of speed 1/T, not the unit speed of (1)."
    }

    fn printed(&self) -> StepVariant {
        StepVariant { position: 0, phase: 1 }
    }

    fn repair(&self) -> Option<Repair<StepVariant>> {
        Some(Repair {
            fault: Fault::Misprint,
            statement: "r_k(q+1) = r_k(q) + T e^{i th_k(q)}, th_k(q+1) = th_k(q) + T u_k(q) is the forward Euler method with step T for (1), (2).".to_string(),
            variant: StepVariant { position: 1, phase: 1 },
        })
    }

    fn controls(&self) -> Vec<Control<StepVariant>> {
        vec![
            Control::new("T^2 u", StepVariant { position: 1, phase: 2 }),
            Control::new("T^2 e^{i theta}", StepVariant { position: 2, phase: 1 }),
            Control::new("u without T", StepVariant { position: 1, phase: 0 }),
        ]
    }

    fn examine(&self, variant: &StepVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        state_identity(&StepIdentity(*variant), &["T", "u"], "increments of Euler's method with step T", run)
    }
}

/// paley.vrep and paley.vatt: `v = sign sum rhat_kj` is to point away from the neighbours (`away = 1`) or towards them (-1).
#[derive(Clone, Copy)]
pub struct BehaviourVariant {
    sign: i64,
    away: i64,
    /// The sign with which the behaviour enters (27).
    gain: i64,
}

/// With neighbours at `r_k - d_j e^{i psi_j}`: moving along `v` changes the sum of the distances at the rate `away |v|^2`, and the
/// heading turns towards `v`: `(d/dt) <e^{i theta}, v> = K <i e^{i theta}, v>^2` with `v` held.
struct BehaviourIdentity(BehaviourVariant);

impl RationalIdentity for BehaviourIdentity {
    fn variables(&self) -> usize {
        5
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [gain, theta, first, second, third] = at else { return Err(ArithmeticError::Domain("five variables")) };
        let heading = phasor(theta)?;
        let away = [phasor(first)?, phasor(second)?, phasor(third)?];
        let sum = repulsion(&heading, &away);
        let v = sum.scale(&gain.integer(self.0.sign));
        // d/de |r_k + e v - r_j| = <v, rhat_kj>
        let distances = away.iter().fold(gain.zero(), |rate, unit| rate + v.dot(unit));
        let turning = steering_towards(&heading, &v) * gain * gain.integer(self.0.gain);
        let rate = quarter_turn(&heading).scale(&turning).dot(&v);
        let square = steering_towards(&heading, &v).square();
        Ok((vec![distances, rate], vec![v.norm_squared() * gain.integer(self.0.away), square * gain]))
    }

    fn in_domain(&self, at: &[Rational]) -> bool {
        at[0] > rational(0, 1)
    }

    fn components(&self) -> Vec<String> {
        vec!["the rate of the sum of distances along v".to_string(), "the rate of <e^{i theta}, v>".to_string()]
    }
}

fn examine_behaviour(variant: &BehaviourVariant, run: &Run) -> Result<Outcome, CheckError> {
    let names = ["K", "tan(theta/2)", "tan(psi_1/2)", "tan(psi_2/2)", "tan(psi_3/2)"];
    let part = "v away from (or towards) the neighbours, rhat_kj = e^{i psi_j}, and steering towards v";
    run.identity(&BehaviourIdentity(*variant), &names, part)
}

/// paley.vrep.
pub struct RepulsionField;

impl Claim for RepulsionField {
    type Variant = BehaviourVariant;

    fn id(&self) -> &str {
        "paley.vrep"
    }

    fn derivation(&self) -> &str {
        "r_kj = r_k - r_j (defined in the text on shape controls) points from j to k, away from the neighbour. Moving along v changes the sum of distances to \
         the neighbours at the rate <v, sum rhat_kj>: it is -|v|^2 for the printed v^rep = -sum rhat_kj, and (27) with K_rep > 0 steers towards v. So the \
         printed field attracts. The sign belongs to the convention r_j - r_k (reference [19]); here v^rep = +sum rhat_kj repels."
    }

    fn printed(&self) -> BehaviourVariant {
        BehaviourVariant { sign: -1, away: 1, gain: 1 }
    }

    fn repair(&self) -> Option<Repair<BehaviourVariant>> {
        Some(Repair {
            fault: Fault::Misprint,
            statement: "v_k^rep = sum_{j in N_k^rep} rhat_kj with rhat_kj = (r_k - r_j)/|r_k - r_j| (or - sum with rhat_jk); with K_rep > 0 it produces repulsion."
                .to_string(),
            variant: BehaviourVariant { sign: 1, away: 1, gain: 1 },
        })
    }

    fn controls(&self) -> Vec<Control<BehaviourVariant>> {
        vec![
            Control::new("sum rhat_kj attracts", BehaviourVariant { sign: 1, away: -1, gain: 1 }),
            Control::new("K_rep < 0", BehaviourVariant { sign: 1, away: 1, gain: -1 }),
        ]
    }

    fn examine(&self, variant: &BehaviourVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        examine_behaviour(variant, run)
    }
}

/// paley.vatt.
pub struct AttractionField;

impl Claim for AttractionField {
    type Variant = BehaviourVariant;

    fn id(&self) -> &str {
        "paley.vatt"
    }

    fn derivation(&self) -> &str {
        "As for paley.vrep: rhat_kj points away from the neighbour, so the printed v^att = sum rhat_kj increases the sum of distances at the rate |v|^2. With \
         r_kj = r_k - r_j attraction is v^att = -sum rhat_kj."
    }

    fn printed(&self) -> BehaviourVariant {
        BehaviourVariant { sign: 1, away: -1, gain: 1 }
    }

    fn repair(&self) -> Option<Repair<BehaviourVariant>> {
        Some(Repair {
            fault: Fault::Misprint,
            statement: "v_k^att = - sum_{j in N_k^att} rhat_kj with rhat_kj = (r_k - r_j)/|r_k - r_j| (or sum with rhat_jk); with K_att > 0 it produces attraction."
                .to_string(),
            variant: BehaviourVariant { sign: -1, away: -1, gain: 1 },
        })
    }

    fn controls(&self) -> Vec<Control<BehaviourVariant>> {
        vec![
            Control::new("-sum rhat_kj repels", BehaviourVariant { sign: -1, away: 1, gain: 1 }),
            Control::new("K_att < 0", BehaviourVariant { sign: -1, away: -1, gain: -1 }),
        ]
    }

    fn examine(&self, variant: &BehaviourVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        examine_behaviour(variant, run)
    }
}

/// paley.eq28.
pub struct LaplacianForm;

/// `u = w + orientation K_ori <i z, L^ori z> + attraction K_att <i z, L^att r>` for (27) with `v^att = field sum rhat_kj`.
#[derive(Clone, Copy)]
pub struct FormVariant {
    orientation: i64,
    attraction: i64,
    field: i64,
}

/// The first fish with neighbours at distance 1, where normalising changes nothing: (27), (28), and what the terms do.
struct FormIdentity(FormVariant);

impl RationalIdentity for FormIdentity {
    fn variables(&self) -> usize {
        8
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [k_ori, k_att, own, tangents @ ..] = at else { return Err(ArithmeticError::Domain("eight variables")) };
        let turning = own;
        let phasors: Vec<Complex<T>> = tangents[..3].iter().map(phasor).collect::<Result<_, _>>()?;
        let away: Vec<Complex<T>> = tangents[3..].iter().map(phasor).collect::<Result<_, _>>()?;
        let origin = Complex::real(own.zero());
        let positions: Vec<Complex<T>> = [origin].into_iter().chain(away.iter().map(|unit| -unit.clone())).collect();
        let z = &phasors[0];
        let network = Neighbours::complete(3);
        let integer = |n: i64| own.integer(n);
        // (27) with the printed or the corrected field of attraction
        let v_att = repulsion(z, &away).scale(&integer(self.0.field));
        let v_ori = alignment(z, &phasors[1..]);
        let desired = v_ori.scale(k_ori) + v_att.scale(k_att);
        let steering = turning.clone() + steering_towards(z, &desired);
        // (28)
        let aligning = misalignment(&network, &phasors)[0].clone() * k_ori * integer(self.0.orientation);
        let turned: Vec<Complex<T>> = phasors.iter().map(quarter_turn).collect();
        let attracting =
            heading_components(&network, &turned, &positions)[0].clone() * k_att * integer(self.0.attraction);
        let form = turning.clone() + &aligning + &attracting;
        // Attraction: the term steers towards -sum r_kj; alignment: towards sum e^{i theta_j}.
        let towards = -network.laplacian_of(&positions)[0].clone();
        let mates = phasors[1].clone() + &phasors[2];
        let right = vec![form, attracting, aligning];
        Ok((vec![steering, steering_towards(z, &towards) * k_att, steering_towards(z, &mates) * k_ori], right))
    }

    fn in_domain(&self, at: &[Rational]) -> bool {
        at[0] > rational(0, 1) && at[1] > rational(0, 1)
    }

    fn components(&self) -> Vec<String> {
        ["(27) and (28)", "steering towards the neighbours", "steering to their headings"].map(String::from).to_vec()
    }
}

impl Claim for LaplacianForm {
    type Variant = FormVariant;

    fn id(&self) -> &str {
        "paley.eq28"
    }

    fn derivation(&self) -> &str {
        "Reading: \"approximated\" means r_kj in the place of rhat_kj (equal at distance 1). <i z, z + sum z_j> = -<i z, L_k^ori z>: the alignment term is exact. sum r_kj = \
         L_k^att r, so (28) follows from (27) with the printed v^att, whose sign is wrong (paley.vatt): K_att <i z, L_k^att r> steers along r_k - mean of \
         the neighbours, away from them. The attraction behaviour is -K_att <i z, L_k^att r>."
    }

    fn printed(&self) -> FormVariant {
        FormVariant { orientation: -1, attraction: 1, field: 1 }
    }

    fn repair(&self) -> Option<Repair<FormVariant>> {
        Some(Repair {
            fault: Fault::Misprint,
            statement: "u_k = w_k - K_ori <i e^{i th_k}, L_k^ori e^{i th}> - K_att <i e^{i th_k}, L_k^att r>, from (27) with v_k^att = - sum rhat_kj.".to_string(),
            variant: FormVariant { orientation: -1, attraction: -1, field: -1 },
        })
    }

    fn controls(&self) -> Vec<Control<FormVariant>> {
        vec![
            Control::new(
                "(28) with -K_att from the printed (27)",
                FormVariant { orientation: -1, attraction: -1, field: 1 },
            ),
            Control::new("+K_ori", FormVariant { orientation: 1, attraction: -1, field: -1 }),
            Control::new(
                "printed (28) from the corrected (27)",
                FormVariant { orientation: -1, attraction: 1, field: -1 },
            ),
        ]
    }

    fn examine(&self, variant: &FormVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let names = ["K_ori", "K_att", "w", "t_1", "t_2", "t_3", "tan(psi_2/2)", "tan(psi_3/2)"];
        let part = "one fish with two neighbours at distance 1, rhat_kj = e^{i psi_j}, t = tan(theta/2)";
        run.identity(&FormIdentity(*variant), &names, part)
    }
}

/// paley.fish28ori.
pub struct Comparison;

/// `K_1 - K_0 = -factor N K_ori`; the spacing terms differ by `i^turns`; perpendicular where `K_1 != 0`, or also for `K_1 = 0`.
#[derive(Clone, Copy)]
pub struct ComparisonVariant {
    factor: (i64, i64),
    turns: u32,
    without_orientation: bool,
}

struct ComparisonIdentity {
    variant: ComparisonVariant,
    network: Neighbours,
}

impl StateIdentity for ComparisonIdentity {
    fn particles(&self) -> usize {
        self.network.particles()
    }

    fn sides<T: Field>(&self, constants: &[T], state: &State<T>) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [omega, spacing, k_ori] = constants else { return Err(ArithmeticError::Domain("three constants")) };
        let (network, particles) = (&self.network, self.particles() as i64);
        let (p, q) = self.variant.factor;
        let orientation = spacing.clone() - omega.ratio(p * particles, q) * k_ori;
        let gains = CircularGains { omega: omega.clone(), spacing: spacing.clone(), orientation };
        // (22), and the fish terms with K_att = omega K_0/N, the factor i put back by turning the heading.
        let left = circular_control(&gains, network, network, state)?;
        let share = omega.ratio(1, particles) * omega * spacing;
        let turned: Vec<_> =
            state.phasors.iter().map(|z| (0..self.variant.turns).fold(z.clone(), |z, _| quarter_turn(&z))).collect();
        let attracting = heading_components(network, &turned, &state.positions);
        let aligning = misalignment(network, &state.phasors);
        let fish = attracting.into_iter().zip(aligning).map(|(a, o)| omega.clone() + a * &share - o * k_ori);
        let mut right: Vec<T> = fish.collect();
        // <e^{i theta_k}, L_k r> = sigma_k + tau_k/omega
        let mut left = left;
        left.extend(heading_components(network, &state.phasors, &state.positions));
        let sigma = heading_components(network, &state.phasors, &circle_centres(omega, state)?);
        let inverse = omega.recip()?;
        right.extend(sigma.into_iter().zip(misalignment(network, &state.phasors)).map(|(s, t)| s + t * &inverse));
        Ok((left, right))
    }
}

impl Claim for Comparison {
    type Variant = ComparisonVariant;

    fn id(&self) -> &str {
        "paley.fish28ori"
    }

    fn derivation(&self) -> &str {
        "Readings: the gains of the spacing terms are matched, K_att = w0 K_0/N; the factor i sits on the heading, <e^{i theta}, x> against <i e^{i theta}, x> \
         (with the corrected sign of (28) it is -i); the circular control is (22) with K_1 != 0, as under (21), on an undirected connected graph. (K_1 - \
         K_0)/N = -K_ori gives equal alignment terms. <e^{i theta_k}, L_k r> = sigma_k + tau_k/w0. By V = K_0 S - K_1 w0^-2 W_1 every solution of (22) tends \
         to states with K_0 sigma_k + K_1 tau_k/w0 = 0 turning at w0; tau_k is constant there and sigma_k has mean zero, so both vanish: the motion of \
         each particle is perpendicular to rtilde_k (or rtilde_k = 0). With K_1 = 0 it need not be: two particles a quarter turn apart."
    }

    fn printed(&self) -> ComparisonVariant {
        ComparisonVariant { factor: (1, 1), turns: 0, without_orientation: false }
    }

    fn controls(&self) -> Vec<Control<ComparisonVariant>> {
        let printed = self.printed();
        vec![
            Control::new("K_1 - K_0 = -K_ori", ComparisonVariant { factor: (1, 4), ..printed }),
            Control::new("the factor i left in the spacing term", ComparisonVariant { turns: 1, ..printed }),
            Control::new("perpendicular for K_1 = 0 too", ComparisonVariant { without_orientation: true, ..printed }),
        ]
    }

    fn examine(&self, variant: &ComparisonVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        // Circular formations that turn at omega under (22): for K_1 = 0 all of them, otherwise those with tau = 0.
        let omega = rational(1, 10);
        let quarter = vec![Complex::real(rational(1, 1)), quarter_turn(&Complex::real(rational(1, 1)))];
        let opposite = vec![quarter[0].clone(), -quarter[0].clone()];
        let mut formations = vec![(rational(1, 1), opposite), (rational(-1, 1), vec![quarter[0].clone(); 2])];
        if variant.without_orientation {
            formations.push((rational(0, 1), quarter));
        }
        let network = Neighbours::complete(2);
        let count = formations.len();
        for (orientation, phasors) in formations {
            let state = circular_formation(&omega, &phasors)?;
            let gains = CircularGains { omega: omega.clone(), spacing: rational(1, 1), orientation };
            let rests = circular_control(&gains, &network, &network, &state)?.iter().all(|u| *u == omega);
            let forward = heading_components(&network, &state.phasors, &state.positions);
            if rests && forward.iter().any(|f| *f != rational(0, 1)) {
                let what = format!(
                    "K_1 = {}, two particles a quarter turn apart on a circle: <e^(i th_1), L_1 r> = {}",
                    gains.orientation, forward[0]
                );
                return Ok(Outcome::fails(
                    what,
                    Evidence::new(Grade::Exact, "perpendicular", "an exact circular formation"),
                ));
            }
        }
        let identities = identity_graphs(run).into_iter().filter(|g| g.order() > 1).map(|graph| {
            let identity = ComparisonIdentity { variant: *variant, network: Neighbours::of(&graph) };
            let part = format!("terms of (22) and (28), {}", described(&graph));
            state_identity(&identity, &["w0", "K_0", "K_ori"], &part, run)
        });
        let perpendicular = Evidence::new(
            Grade::Exact,
            "perpendicular motion in the limit",
            "proof in notes/paley_particles.md; exact circular formations with K_1 > 0 and K_1 < 0",
        );
        Run::all(identities.chain([Ok(Outcome::Holds(vec![perpendicular.cases(count)]))]))
    }
}

/// paley.chord.
pub struct Chord;

/// The distance of clusters `steps` places apart is `factor sin(pi steps'/M)`.
#[derive(Clone, Copy)]
pub struct ChordVariant {
    factor: i64,
    /// Twice the angle in the sine over the angle between clusters: 1 for half of it.
    doubled: u64,
}

impl RationalIdentity for ChordVariant {
    fn variables(&self) -> usize {
        1
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        // e^{i a} with a = pi/M or any angle; the clusters are at 1 and e^{2 i a}.
        let half = phasor(&at[0])?;
        let distance = (half.square() - Complex::real(at[0].one())).norm_squared();
        let sine = half.power(self.doubled).im;
        Ok((vec![distance], vec![sine.square() * at[0].integer(self.factor * self.factor)]))
    }
}

impl Claim for Chord {
    type Variant = ChordVariant;

    fn id(&self) -> &str {
        "paley.chord"
    }

    fn derivation(&self) -> &str {
        "Neighbouring clusters at 1 and e^{2 pi i/M}: |1 - e^{2 i a}|^2 = 4 sin^2 a with a = pi/M, and sin a > 0 for M >= 2. An identity in a, hence for M = 2, 8, 12 \
         and every other M."
    }

    fn printed(&self) -> ChordVariant {
        ChordVariant { factor: 2, doubled: 1 }
    }

    fn controls(&self) -> Vec<Control<ChordVariant>> {
        vec![
            Control::new("sin(pi/M)", ChordVariant { factor: 1, doubled: 1 }),
            Control::new("2 sin(2 pi/M)", ChordVariant { factor: 2, doubled: 2 }),
        ]
    }

    fn examine(&self, variant: &ChordVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        run.identity(variant, &["tan(a/2)"], "|1 - e^{2 i a}|^2 = 4 sin^2 a, a = pi/M")
    }
}

/// paley.fig7.
pub struct PerceptualZones;

/// The order of the outer radii and the side of the blind spot.
#[derive(Clone, Copy)]
pub struct ZonesVariant {
    swapped: bool,
    ahead: bool,
    /// `cos^2` of half the blind angle that is claimed.
    claimed: (i64, i64),
}

impl Claim for PerceptualZones {
    type Variant = ZonesVariant;

    fn id(&self) -> &str {
        "paley.fig7"
    }

    fn derivation(&self) -> &str {
        "Definitions, read off the figure and the text: what is checked is that the zones as coded are these. A point is in the zone of repulsion, orientation or \
         attraction by its distance alone (annuli around the fish, both boundaries counted, so that a boundary belongs to two), unless it lies in the \
         open wedge of angular width alpha_k around the direction opposite to the heading; decided exactly on a grid for alpha = 60 degrees and rational headings."
    }

    fn printed(&self) -> ZonesVariant {
        ZonesVariant { swapped: false, ahead: false, claimed: (3, 4) }
    }

    fn controls(&self) -> Vec<Control<ZonesVariant>> {
        let printed = self.printed();
        vec![
            Control::new("attraction inside orientation", ZonesVariant { swapped: true, ..printed }),
            Control::new("blind spot in front", ZonesVariant { ahead: true, ..printed }),
            Control::new("a blind spot of 90 degrees", ZonesVariant { claimed: (1, 2), ..printed }),
        ]
    }

    fn examine(&self, variant: &ZonesVariant, _run: &mut Run) -> Result<Outcome, CheckError> {
        const REACH: i64 = 8;
        let radius = |r: i64| rational(r, 1);
        let zones = Zones {
            repulsion: radius(2),
            orientation: radius(4),
            attraction: radius(7),
            blind_cosine_squared: rational(3, 4),
        };
        let bounds = if variant.swapped { [(0, 2), (4, 7), (2, 4)] } else { [(0, 2), (2, 4), (4, 7)] };
        let mut points = 0;
        for heading in scattered_phasors(6)? {
            for (x, y) in (-REACH..=REACH).flat_map(|x| (-REACH..=REACH).map(move |y| (x, y))) {
                // In the frame of the fish: x ahead, y to the left.
                let offset = heading.clone() * Complex::new(radius(x), radius(y));
                let (behind, square) = (if variant.ahead { x } else { -x }, x * x + y * y);
                let (p, q) = variant.claimed;
                let blind = behind > 0 && q * behind * behind > p * square;
                for (zone, (inner, outer)) in
                    [Zone::Repulsion, Zone::Orientation, Zone::Attraction].into_iter().zip(bounds)
                {
                    points += 1;
                    let inside = inner * inner <= square && square <= outer * outer && !blind;
                    if zones.senses(zone, &heading, &offset) != inside {
                        let what = format!("{zone:?}: the point {x} ahead and {y} to the left of the fish");
                        return Ok(Outcome::fails(
                            what,
                            Evidence::new(Grade::Exact, "zones", "exact distances and angles"),
                        ));
                    }
                }
            }
        }
        let detail = "annuli by distance and a wedge behind, six rational headings, a grid of 17 x 17 points each";
        Ok(Outcome::Holds(vec![
            Evidence::new(Grade::Exhaustive, "zones and blind spot as coded", detail).cases(points),
            Evidence::new(Grade::Text, "figure", "the caption agrees with the text on the zones"),
        ]))
    }
}
