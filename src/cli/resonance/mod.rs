//! `resonance`: the main resonance of a platoon: certified for the two-sided one, computed for any communication graph.

mod certified;
mod network;
mod peak;
mod responses;
mod state;
mod sweep;

pub use certified::Certified;

use super::{CliError, output};
use flockproof::arithmetic::{Rational, parse_rational};
use flockproof::platoon::{Gains, Line, LineError, Parameter, read_numbers};
use std::path::PathBuf;
use std::process::ExitCode;

#[derive(clap::Args)]
#[command(
    after_help = "Frequencies are in radians per unit of time, amplitudes are those of a car for a leader that swings with amplitude 1. Without --graph, or with \
front-and-back, equal gains and the last car, the resonance is certified, for up to 10^12 followers. For other graphs stability is decided and the \
peak is certified for up to 100 followers, for --state up to 200 states; beyond, the peak is searched in floating point, and the output says so.\n\n\
An edge i j of a graph says that car i keeps track of car j; what it tracks is weighted to a sum of one. The leader is the vertex `leader` or the \
first one, or that of --from.\n\n\
Asymmetric and heterogeneous platoons: each number may be a list, one for each follower. The weights of a car ahead and behind are scaled to a sum of one (one of \
them alone: the other is the rest to one), so that the last car has the weight 1 ahead; --ahead 1/2 is the platoon without weights. Without --f, \
--f-ahead and --f-behind are the gains of the two links themselves, below 0; likewise --g.\n\n\
Examples:\n  flockproof resonance --followers 128 --f -1 --g -1\n  flockproof resonance --followers 1000000000 --f=-1/2 --g=-3 --digits 12 --json\n  \
flockproof resonance --graph front --followers 20 --f -1 --g -1 --to 10\n  flockproof resonance --graph circulant:9:1,2 --f -1 --g -2\n  \
flockproof resonance --followers 20 --f -1 --g -1 --ahead 0.6 --behind 0.4 --plot bode.svg\n  \
flockproof resonance --followers 3 --f -1,-2,-1 --g -1 --f-ahead 0.6,0.5,1 --g-ahead 1 --response 0.1..10:5\n  \
flockproof resonance --followers 16 --sweep f=-4..-1:4,g=-2..-1:3"
)]
pub struct Arguments {
    /// Number of followers, from 1 to 10^12; with --graph front up to 2000, and as long as the amplitude is below 10^308
    #[arg(long, value_name = "M")]
    followers: Option<u64>,
    /// Gain of the positions: an integer, a fraction or a decimal below 0; or one for each follower, -1,-2,-1
    #[arg(long, value_name = "F", allow_hyphen_values = true, required_unless_present_any = ["sweep", "state", "f_ahead"])]
    f: Option<String>,
    /// Gain of the velocities, likewise
    #[arg(long, value_name = "G", allow_hyphen_values = true, required_unless_present_any = ["sweep", "state", "g_ahead"])]
    g: Option<String>,
    /// Weight of the car ahead, for positions and velocities: one, or one for each follower, 0.6,0.5,..
    #[arg(long, value_name = "W", allow_hyphen_values = true)]
    ahead: Option<String>,
    /// Weight of the car behind, likewise
    #[arg(long, value_name = "W", allow_hyphen_values = true)]
    behind: Option<String>,
    /// Weight of the car ahead for positions only; without --f the gain of that link
    #[arg(long, value_name = "W", allow_hyphen_values = true)]
    f_ahead: Option<String>,
    /// Weight of the car behind for positions only; without --f the gain of that link
    #[arg(long, value_name = "W", allow_hyphen_values = true)]
    f_behind: Option<String>,
    /// Weight of the car ahead for velocities only; without --g the gain of that link
    #[arg(long, value_name = "W", allow_hyphen_values = true)]
    g_ahead: Option<String>,
    /// Weight of the car behind for velocities only; without --g the gain of that link
    #[arg(long, value_name = "W", allow_hyphen_values = true)]
    g_behind: Option<String>,
    /// Who keeps track of whom: front, front-and-back, a graph such as circulant:9:1,2, or a file as `spectrum` reads it
    #[arg(long, value_name = "GRAPH", default_value = "front-and-back")]
    graph: String,
    /// The vertex that leads: its number from 1, or its name [default: leader, or the first]
    #[arg(long, value_name = "VERTEX")]
    from: Option<String>,
    /// The car that is looked at: a follower from 1, or of a graph the number or name of a vertex [default: the last]
    #[arg(long, value_name = "CAR")]
    to: Option<String>,
    /// The vertices of the edge list are numbered from 0
    #[arg(long)]
    zero_based: bool,
    /// A table over values of the gains, evenly spaced: NAME=FROM..TO:COUNT or NAME=VALUE, joined by commas
    #[arg(long, value_name = "f=..,g=..", allow_hyphen_values = true)]
    sweep: Option<String>,
    /// The peak of x' = A x + B u, y = C x + D u instead: a folder with A, B, C and perhaps D as .csv or .npy; u is the leader's position, or
    /// position and velocity
    #[arg(long, value_name = "DIR", conflicts_with_all = ["followers", "f", "g", "graph", "from", "to", "zero_based", "sweep", "export", "certificate", "ahead", "behind", "f_ahead", "f_behind", "g_ahead", "g_behind", "cars"])]
    state: Option<PathBuf>,
    /// Frequency responses as a table: amplitude and phase at these angular frequencies, 1/10,1,2, or COUNT of them from FROM to TO in equal ratios
    #[arg(long, value_name = "W,..|FROM..TO:COUNT")]
    response: Option<String>,
    /// Bode's diagram, magnitude and phase, as .svg or .png; over the frequencies of --response FROM..TO:COUNT, if given
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
    /// The cars of --response and --plot, as --to names them, joined by commas [default: that of --to]
    #[arg(long, value_name = "CAR,..")]
    cars: Option<String>,
    /// Significant digits, from 1 to 10000
    #[arg(long, value_name = "D", default_value_t = 25, value_parser = clap::value_parser!(u32).range(1..=10000))]
    digits: u32,
    /// Print one JSON document: flockproof.resonance/1, for other graphs flockproof.response/1, of --sweep flockproof.resonance-sweep/1, of --state flockproof.state-response/1
    #[arg(long)]
    json: bool,
    /// Write the matrices of x' = A x + B u, y = C x as CSV, NumPy, Matrix Market and MATLAB files to this folder
    #[arg(long, value_name = "DIR")]
    export: Option<PathBuf>,
    /// Write the peak as a certificate, for at most 96 followers, see proofs_checks/README.md
    #[arg(long, value_name = "OUT")]
    certificate: Option<PathBuf>,
}

/// The gains of one option: one, or one for each follower.
fn numbers(name: &str, text: &str) -> Result<Vec<Rational>, CliError> {
    read_numbers(text).map_err(|error| CliError::Use(format!("--{name}: {error}")))
}

/// Whether a text would be a list of numbers with commas in place of what is between them.
fn lacks_commas(text: &str) -> bool {
    let parts: Vec<&str> = text.split([' ', '\t', ';']).filter(|part| !part.is_empty()).collect();
    parts.len() > 1 && read_numbers(&parts.join(",")).is_ok()
}

/// A parameter as the option that gives it.
fn option_of(parameter: Parameter) -> String {
    format!("--{}", parameter.name().replace('_', "-"))
}

/// What is wrong with a platoon on a line, in the words of the command line.
fn line_error(error: &LineError) -> CliError {
    CliError::Use(error.told(option_of))
}

impl Arguments {
    /// What is given of a parameter.
    fn of(&self, parameter: Parameter) -> Option<&str> {
        let text = match parameter {
            Parameter::F => &self.f,
            Parameter::G => &self.g,
            Parameter::Ahead => &self.ahead,
            Parameter::Behind => &self.behind,
            Parameter::FAhead => &self.f_ahead,
            Parameter::FBehind => &self.f_behind,
            Parameter::GAhead => &self.g_ahead,
            Parameter::GBehind => &self.g_behind,
        };
        text.as_deref()
    }

    /// Gains and weights.
    fn line(&self) -> Result<Line, CliError> {
        let mut line = Line::default();
        for (_, parameter) in Parameter::NAMES {
            if let Some(text) = self.of(parameter) {
                let read = numbers(&option_of(parameter)[2..], text).map_err(|error| match error {
                    CliError::Use(why) if lacks_commas(text) => CliError::Use(format!("{why}; a list is 0.6,0.5,1")),
                    other => other,
                });
                line = line.with(parameter, read?);
            }
        }
        Ok(line)
    }
}

/// One pair of gains for all followers.
pub fn equal_gains(f: &str, g: &str) -> Result<Gains<Rational>, CliError> {
    let one = |name: &str, text: &str| parse_rational(text).map_err(|error| CliError::Use(format!("{name}: {error}")));
    Ok(Gains { f: one("f", f)?, g: one("g", g)? })
}

/// Whether the resonance of these arguments can be certified.
fn is_certified(arguments: &Arguments) -> bool {
    let last = match (&arguments.to, arguments.followers) {
        (None, _) => true,
        (Some(to), Some(followers)) => *to == followers.to_string(),
        _ => false,
    };
    arguments.graph == "front-and-back"
        && arguments.from.is_none()
        && last
        && arguments.export.is_none()
        && !arguments.zero_based
        && arguments.cars.is_none()
        && !Parameter::NAMES.iter().any(|(_, parameter)| parameter.is_of_a_side() && arguments.of(*parameter).is_some())
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    if arguments.cars.is_some() && arguments.response.is_none() && arguments.plot.is_none() {
        let why =
            "--cars names the cars of --response and --plot, and neither is given; the car of the peak is that of --to";
        return Err(CliError::Use(why.to_string()));
    }
    if let Some(folder) = &arguments.state {
        return state::run(arguments, folder);
    }
    if arguments.sweep.is_some() {
        return sweep::run(arguments);
    }
    arguments.plot.as_deref().map_or(Ok(()), output::check_writable)?;
    let line = arguments.line()?;
    match (line.get(Parameter::F), line.get(Parameter::G)) {
        (Some([f]), Some([g])) if is_certified(arguments) => {
            certified::run(arguments, &Gains { f: f.clone(), g: g.clone() })
        }
        _ if arguments.certificate.is_some() => {
            let why = "--certificate: only the two-sided platoon with equal gains has one, for its last car";
            Err(CliError::Use(why.to_string()))
        }
        _ => network::run(arguments, &line),
    }
}

/// The number of followers, which has to be told where no graph tells it.
fn followers(arguments: &Arguments) -> Result<u64, CliError> {
    let missing = || CliError::Use("--followers M is needed: how many cars are behind the leader".to_string());
    arguments.followers.ok_or_else(missing)
}
