//! paley.eq28, paley.fish28ori: the steering of a fish beside the circular control.

use super::instances::{StateIdentity, described, identity_graphs, state_identity};
use arithmetic::identity::RationalIdentity;
use arithmetic::{ArithmeticError, Complex, Field, Rational, rational};
use ledger::{CheckError, Claim, Control, Evidence, Fault, Grade, Outcome, Repair, Run};
use models::oscillator::{
    CircularGains, Interaction, Neighbours, State, alignment, circle_centres, circular_control, circular_formation,
    heading_components, misalignment, phasor, quarter_turn, repulsion, steering_towards,
};

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
            fault: Fault::Slip, clauses: Vec::new(),
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
        "Readings: the gains of the spacing terms are matched, K_att = w0 K_0/N, so that w0 > 0 (K_att and K_0 are positive); the factor i sits on the heading, <e^{i theta}, x> against <i e^{i theta}, x> \
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
