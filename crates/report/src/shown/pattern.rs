//! Which symmetric patterns are stable.

use super::{enclosed, table};
use arithmetic::{ArithmeticError, Cancelled, Complex, Dyadic, Interval, Progress, Rational, Ring, Signed};
use maud::html;
use models::oscillator::FourierFormation;
use num_traits::Zero;

/// The linearisation at the pattern of so many clusters, without what rotation and translation force.
#[derive(Debug, Clone)]
pub struct PatternRow {
    /// Clusters.
    pub clusters: usize,
    /// Eigenvalues 0, of which rotation forces one.
    pub zeros: usize,
    /// Encloses the largest real part of all but those of the symmetries, so 0 or more where there are further eigenvalues 0; nothing where no
    /// others are left.
    pub abscissa: Option<Interval>,
    /// A wave number that attains it.
    pub wave: Option<usize>,
}

/// Why there are no rows.
#[derive(Debug, thiserror::Error)]
pub enum PatternError {
    /// Particles that do not turn.
    #[error("omega0: without turning there are no circles")]
    NoTurning,
    /// More gains than particles.
    #[error("gains: at most {0}, one for each particle")]
    TooManyGains(usize),
    /// More particles than are decided in a while.
    #[error("particles: from 1 to {most}, not {found}")]
    Particles {
        /// What was asked for.
        found: usize,
        /// The limit.
        most: usize,
    },
    /// Modes without their eigenvalues.
    #[error(transparent)]
    Arithmetic(#[from] ArithmeticError),
    /// The work was stopped.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

impl PatternRow {
    /// Most particles: exact cosines of larger orders take minutes.
    pub const MOST_PARTICLES: usize = 60;

    /// Digits that are shown.
    pub const DIGITS: u32 = 18;

    /// A row for each number of clusters that divides the number of particles; `circular` is `omega_0`, not 0, and `K_0`.
    ///
    /// # Errors
    /// [`PatternError`].
    pub fn all(
        particles: usize,
        circular: (&Rational, &Rational),
        gains: &[Rational],
        progress: &dyn Progress,
    ) -> Result<Vec<Self>, PatternError> {
        if !(1..=Self::MOST_PARTICLES).contains(&particles) {
            return Err(PatternError::Particles { found: particles, most: Self::MOST_PARTICLES });
        }
        if circular.0.is_zero() {
            return Err(PatternError::NoTurning);
        }
        if gains.len() > particles {
            return Err(PatternError::TooManyGains(particles));
        }
        let divisors: Vec<usize> = (1..=particles).filter(|m| particles.is_multiple_of(*m)).collect();
        let mut rows = Vec::new();
        for (done, &clusters) in divisors.iter().enumerate() {
            progress.checkpoint()?;
            progress.tell("patterns", done as u64, Some(divisors.len() as u64));
            if let Some(formation) = FourierFormation::pattern(clusters, particles, circular, gains) {
                rows.push(PatternRow::of(clusters, &formation)?);
            }
        }
        Ok(rows)
    }

    /// From its spectrum. Eigenvalues 0 are divided out exactly, and those that rotation does not force count as any other.
    fn of(clusters: usize, formation: &FourierFormation) -> Result<Self, ArithmeticError> {
        let Some(found) = formation.transverse()? else {
            return Ok(PatternRow { clusters, zeros: 1, abscissa: None, wave: None });
        };
        let row =
            PatternRow { clusters, zeros: found.zeros, abscissa: Some(found.abscissa.clone()), wave: Some(found.wave) };
        if found.zeros <= 1 || found.abscissa.is_certainly_positive() {
            return Ok(row);
        }
        let zero = Complex::real(formation.root(0).re.zero());
        let further = (1..=formation.order() / 2).find(|q| formation.neutral(*q).contains(&zero));
        let precision = found.abscissa.precision();
        let least = Dyadic::zero();
        let most = found.abscissa.hi().clone().max(least.clone());
        Ok(PatternRow { abscissa: Some(Interval::between(least, most, precision)), wave: further.or(row.wave), ..row })
    }

    /// `stable` exponentially up to rotation and translation, `unstable`, or `undecided` by the linearisation.
    pub fn verdict(&self) -> &'static str {
        match &self.abscissa {
            Some(x) if x.is_certainly_positive() => "unstable",
            Some(x) if !x.is_certainly_negative() => "undecided",
            _ => "stable",
        }
    }

    /// The enclosure as text.
    pub fn abscissa_text(&self) -> String {
        self.abscissa.as_ref().map_or("none".to_string(), |x| enclosed(x, Self::DIGITS))
    }
}

/// Every pattern with its verdict and a picture.
pub fn patterns(rows: &[PatternRow], gains: &[Rational]) -> String {
    let class = |row: &PatternRow| match row.verdict() {
        "stable" => "holds",
        "unstable" => "false",
        _ => "undecided",
    };
    let cells: Vec<Vec<String>> = rows
        .iter()
        .map(|row| {
            vec![row.clusters.to_string(), row.verdict().to_string(), row.abscissa_text(), row.zeros.to_string()]
        })
        .collect();
    let list: Vec<String> = gains.iter().map(Rational::to_string).collect();
    let shown = html! {
        p { "Under the gains K = (" (list.join(", ")) "), up to rotation and translation:" }
        ul.patterns { @for row in rows {
            li { (picture(row.clusters)) span.chip.(class(row)) { (row.clusters) " cluster" @if row.clusters != 1 { "s" } ": " (row.verdict()) } }
        } }
        (table("Patterns", &["clusters", "verdict", "largest real part, enclosed", "eigenvalues 0"], &cells))
        p.small { "Stable: every eigenvalue of the linearisation but those of the symmetries lies in the left half plane. One eigenvalue 0 belongs to rotation; where there are more, or the largest real part \
                   cannot be told from 0, the linearisation does not decide." }
    };
    shown.into_string()
}

/// The phases of a pattern on a circle.
fn picture(clusters: usize) -> maud::Markup {
    let place = |k: usize| {
        let angle = std::f64::consts::TAU * k as f64 / clusters as f64;
        (format!("{:.1}", 32.0 + 24.0 * angle.cos()), format!("{:.1}", 32.0 - 24.0 * angle.sin()))
    };
    html! {
        svg.network width="64" height="64" viewBox="0 0 64 64" aria-hidden="true" {
            circle.ring cx="32" cy="32" r="24" {}
            @for k in 0..clusters { @let (x, y) = place(k); circle cx=(x) cy=(y) r="4" {} }
        }
    }
}
