//! `tracks`: the fish analysis of Paley and others on anyone's trajectories.

use super::interrupt::{self, Watch};
use super::{CliError, output, progress};
use flockproof::arithmetic::Cancelled;
use flockproof::report::{File, Known, Provenance, TracksReport};
use flockproof::tracks::{
    Attributes, BridgeShape, Choices, ChoicesError, Format, FormatError, NearestRule, PositionsUsed, School, Setting,
    Smoothing, Tracks, UnknownName, analyse, delays, largest_lag, named, synthetic_school,
};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

#[derive(clap::Args)]
#[command(after_help = "Times are in seconds, lengths in the unit of x and y, radii of zones in body lengths.\n\n\
Examples:\n  flockproof tracks assets/example_tracks.csv --out out\n  flockproof tracks --synthetic milling --fish 20 --seed mine --out out")]
pub struct Arguments {
    /// Table with the columns t, id, x, y: seconds or dates, a name for each fish, horizontal positions; or one of idtracker.ai, DeepLabCut, SLEAP, trackpy or Ctrax; or an array (.npy) of shape (frames, fish, 2)
    #[arg(value_name = "FILE.csv", required_unless_present = "synthetic", conflicts_with = "synthetic")]
    file: Option<PathBuf>,
    /// Folder for summary.json, tables and pictures; it is made if it is missing
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Columns by other names, such as frame=t,particle=id
    #[arg(long, value_name = "NAME=t,..", value_delimiter = ',', conflicts_with = "synthetic")]
    columns: Vec<String>,
    /// Frames per second, where the column of time holds numbers of frames
    #[arg(long, value_name = "F", value_parser = super::help::finite, conflicts_with = "synthetic")]
    fps: Option<f64>,
    /// The body part that stands for a fish, in tables of DeepLabCut and SLEAP [default: the mean of those that were seen]
    #[arg(long, value_name = "PART", conflicts_with = "synthetic")]
    part: Option<String>,
    /// Body parts with a smaller score or likelihood are not seen
    #[arg(long, value_name = "P", default_value_t = 0.0, value_parser = super::help::finite, conflicts_with = "synthetic")]
    score: f64,
    /// Bridge gaps of at most so many frames; they are marked
    #[arg(long, value_name = "FRAMES", default_value_t = 0, value_parser = clap::value_parser!(u64).range(..=1_000_000))]
    max_gap: u64,
    /// How gaps are bridged: line, or spline (the cubic with positions and velocities at both ends)
    #[arg(long, value_name = "SHAPE", default_value = "line", value_parser = bridge)]
    bridge: (&'static str, BridgeShape),
    /// Use frames in which at least so many fish have a heading [default: all]
    #[arg(long, value_name = "N")]
    min_fish: Option<usize>,
    /// How positions are smoothed before velocities are taken: mean (moving average), savgol (cubics by least squares, Savitzky and Golay) or spline (smoothing spline)
    #[arg(long, value_name = "HOW", default_value = "mean", value_parser = smoothing)]
    smoothing: Smoothing,
    /// Frames that are smoothed over, odd [default: closest to 5 s]
    #[arg(long, value_name = "FRAMES")]
    window: Option<usize>,
    /// Use the smoothed positions for distances and networks too
    #[arg(long)]
    smooth_positions: bool,
    /// Body length in the unit of x and y [default: that in attributes.json beside a table of idtracker.ai, else 5.3, the sidebar's in cm]
    #[arg(long, value_name = "B", value_parser = super::help::finite)]
    body_length: Option<f64>,
    /// Outer radii of repulsion, orientation and attraction in body lengths; the last may be left out
    #[arg(
        long,
        value_name = "R,O[,A]",
        default_value = "1.4,2.4",
        value_delimiter = ',',
        value_parser = super::help::finite
    )]
    zones: Vec<f64>,
    /// Blind spot behind each fish in degrees
    #[arg(long, value_name = "DEGREES", default_value_t = 60.0, value_parser = super::help::finite)]
    blind: f64,
    /// A fish that is no faster than this has no heading
    #[arg(long, value_name = "SPEED", default_value_t = 0.0, value_parser = super::help::finite)]
    still: f64,
    /// For n = 1 always the nearest neighbour, also in the zone of repulsion
    #[arg(long)]
    plain_nearest: bool,
    /// Other numbers of nearest neighbours for which W_1 is computed
    #[arg(long, value_name = "N,..", value_delimiter = ',')]
    nearest: Vec<usize>,
    /// Only these fish
    #[arg(long, value_name = "ID,..", value_delimiter = ',')]
    ids: Vec<String>,
    /// Delays between the headings of each pair, up to so many seconds: who turns first
    #[arg(long, value_name = "SECONDS", value_parser = super::help::finite)]
    delays: Option<f64>,
    /// Circular time shifts for each of the two null models; the time grows with frames x fish^2 x shifts
    #[arg(long, value_name = "SHIFTS", default_value_t = 199)]
    null: usize,
    /// Time of the snapshot in seconds, within the recording [default: the middle]
    #[arg(long, value_name = "T", value_parser = super::help::finite)]
    at: Option<f64>,
    /// Seed of the null models and of a synthetic school
    #[arg(long, value_name = "SEED", default_value = "flockproof")]
    seed: String,
    /// Make a school instead of reading one: polarised, milling, diffuse-milling, independent, coupled; it is written to tracks.csv
    #[arg(long, value_name = "KIND", value_parser = school)]
    synthetic: Option<(&'static str, School)>,
    /// Fish of a synthetic school
    #[arg(long, value_name = "N", default_value_t = 8, requires = "synthetic", conflicts_with = "file", value_parser = clap::value_parser!(u16).range(2..=500))]
    fish: u16,
    /// Frames of a synthetic school
    #[arg(long, value_name = "F", default_value_t = 3000, requires = "synthetic", conflicts_with = "file", value_parser = clap::value_parser!(u32).range(3..=1_000_000))]
    frames: u32,
    /// Print the summary as one JSON document, flockproof.tracks/1
    #[arg(long)]
    json: bool,
}

/// Frame step of synthetic schools in seconds.
const STEP: f64 = 0.1;
/// The file of a synthetic school.
const SCHOOL: &str = "tracks.csv";
/// Most positions of a synthetic school.
const LARGEST_SCHOOL: usize = 5_000_000;
/// More shifts than this say nothing more.
const MOST_SHIFTS: usize = 100_000;

fn smoothing(name: &str) -> Result<Smoothing, UnknownName> {
    named(&Smoothing::ALL, name).map(|(_, smoothing)| smoothing)
}

fn bridge(name: &str) -> Result<(&'static str, BridgeShape), UnknownName> {
    named(&BridgeShape::ALL, name)
}

fn school(name: &str) -> Result<(&'static str, School), UnknownName> {
    named(&School::ALL, &name.replace("polarized", "polarised"))
}

/// A choice that makes no sense, with its option.
fn wrong(error: &ChoicesError) -> CliError {
    CliError::Use(match error.choice() {
        Some(choice) => format!("--{}: {error}", choice.replace('_', "-")),
        None => error.to_string(),
    })
}

/// The trajectories, where they come from, and whether they were made here.
fn tracks(arguments: &Arguments) -> Result<(Tracks, String, Value), CliError> {
    if let Some((name, school)) = arguments.synthetic {
        let (fish, frames) = (usize::from(arguments.fish), arguments.frames as usize);
        if fish * frames > LARGEST_SCHOOL {
            return Err(CliError::Use(format!(
                "--frames {frames} for {fish} fish are more than {LARGEST_SCHOOL} positions"
            )));
        }
        let setting = Setting {
            fish,
            frames,
            step: STEP,
            body_length: body_length(arguments, None),
            seed: arguments.seed.clone(),
        };
        let origin = json!({"synthetic": name, "fish": fish, "frames": frames, "step": STEP});
        let source = format!("synthetic school: {name}, seed {}", arguments.seed);
        return Ok((synthetic_school(school, &setting), source, origin));
    }
    let path = arguments.file.as_deref().unwrap_or(Path::new(""));
    let read = output::read_bytes(path)?;
    let format = Format::new(&arguments.columns, arguments.fps).map_err(|error| {
        CliError::Use(format!("--{}: {error}", if matches!(error, FormatError::Rate(_)) { "fps" } else { "columns" }))
    })?;
    if arguments.score < 0.0 {
        return Err(CliError::Use(format!("--score {} is below 0", arguments.score)));
    }
    let format = format.of_parts(arguments.part.clone(), arguments.score);
    if is_read_in_python(&read.0) {
        let how = "it is one of the files of trackers that are read in Python: flockproof.tracks(FILE)";
        return Err(CliError::file(path, how));
    }
    let (tracks, origin) = if Tracks::is_npy(&read.0) {
        (Tracks::from_npy(&read.0, &format), read.1)
    } else {
        let input = output::text(path, read)?;
        (Tracks::from_table(&input.text, &format), input.origin)
    };
    let tracks = tracks.map_err(|error| CliError::file(path, error))?;
    // The name only, so that the same file gives the same output wherever it is.
    let name = path.file_name().unwrap_or(path.as_os_str());
    Ok((tracks, name.to_string_lossy().into_owned(), origin))
}

/// Whether a file begins as HDF5 does (also `.slp`, `.nc`), an archive of NumPy, a table of MATLAB or a pickle.
fn is_read_in_python(bytes: &[u8]) -> bool {
    let begins: [&[u8]; 4] = [b"\x89HDF\r\n\x1a\n", b"PK\x03\x04", b"MATLAB 5.0 MAT-file", b"\x80"];
    begins.iter().any(|begin| bytes.starts_with(begin))
}

/// What is said of the body length beside the table.
fn beside(arguments: &Arguments, tracks: &Tracks) -> Option<f64> {
    let file = arguments.file.as_deref().filter(|path| *path != Path::new("-"));
    let (path, name) = file.zip(Attributes::file(tracks.form))?;
    let said = output::read_input(&path.with_file_name(name)).ok()?;
    Attributes::read(&said.text)?.body_length
}

fn body_length(arguments: &Arguments, beside: Option<f64>) -> f64 {
    arguments.body_length.or(beside).unwrap_or(Choices::BODY_LENGTH_OF_SIDEBAR)
}

/// Units, and where rate and body length come from.
fn known(arguments: &Arguments, tracks: &Tracks, beside: Option<f64>) -> Known<'static> {
    let body_length = match (arguments.body_length, beside) {
        (Some(_), _) => Known::CHOSEN,
        (None, Some(_)) => "attributes.json of idtracker.ai",
        (None, None) => Known::OF_SIDEBAR,
    };
    let times = if arguments.fps.is_some() { "frames, and their rate is chosen" } else { Known::IN_FILE };
    match arguments.synthetic {
        Some(_) => Known { times: "made", body_length, ..Known::of_sidebar() },
        None => Known { unit: tracks.form.unit(), times, body_length },
    }
}

fn choices(arguments: &Arguments, tracks: &Tracks, body_length: f64) -> Result<Choices, CliError> {
    let sidebar = Choices::of_sidebar(tracks.step);
    let zones = Choices::radii_of_zones(&arguments.zones).map_err(|error| wrong(&error))?;
    Ok(Choices {
        smoothing: arguments.smoothing,
        window: arguments.window.unwrap_or(sidebar.window),
        positions: if arguments.smooth_positions { PositionsUsed::Smoothed } else { PositionsUsed::File },
        body_length,
        zones,
        blind: arguments.blind,
        still: arguments.still,
        rule: if arguments.plain_nearest { NearestRule::Nearest } else { NearestRule::SecondInRepulsion },
        nearest: arguments.nearest.clone(),
        min_fish: arguments.min_fish,
    })
}

pub fn run(arguments: &Arguments) -> Result<ExitCode, CliError> {
    if arguments.null > MOST_SHIFTS {
        return Err(CliError::Use(format!("--null {} is more than {MOST_SHIFTS} shifts", arguments.null)));
    }
    let (tracks, source, origin) = tracks(arguments)?;
    let refuse = |error: &dyn std::fmt::Display| CliError::Use(format!("{source}: {error}"));
    let tracks = if arguments.ids.is_empty() {
        tracks
    } else {
        tracks.only(&arguments.ids).map_err(|error| CliError::Use(format!("--ids: {error}")))?
    };
    if arguments.max_gap == 0 && arguments.bridge.1 != BridgeShape::Line {
        return Err(CliError::Use(format!("--bridge {} bridges nothing without --max-gap", arguments.bridge.0)));
    }
    let tracks = tracks.bridge(arguments.max_gap, arguments.bridge.1);
    let beside = beside(arguments, &tracks);
    let length = body_length(arguments, beside);
    let choices = choices(arguments, &tracks, length)?;
    if let (Some(at), [first, .., last]) = (arguments.at, tracks.frames.as_slice())
        && !(first.time..=last.time).contains(&at)
    {
        let (from, to) = (first.time, last.time);
        return Err(CliError::Use(format!("--at {at}: the recording goes from t = {from} to {to}")));
    }
    choices.check(tracks.fish()).map_err(|error| wrong(&error))?;
    if let Some(seconds) = arguments.delays {
        largest_lag(&tracks, seconds).map_err(|error| CliError::Use(format!("--delays: {error}")))?;
    }
    output::make_folder(&arguments.out)?;
    if arguments.synthetic.is_some() {
        output::write_file(&arguments.out.join(SCHOOL), tracks.to_csv().as_bytes())?;
    }
    let configuration = json!({
        "command": "tracks", "file": origin, "columns": arguments.columns, "fps": arguments.fps,
        "part": arguments.part, "score": arguments.score,
        "max_gap": arguments.max_gap, "bridge": arguments.bridge.0, "min_fish": arguments.min_fish, "ids": arguments.ids, "smoothing": arguments.smoothing.name(), "window": arguments.window,
        "smooth_positions": arguments.smooth_positions, "body_length": length, "zones": arguments.zones,
        "blind": arguments.blind, "still": arguments.still, "plain_nearest": arguments.plain_nearest,
        "nearest": arguments.nearest, "delays": arguments.delays, "null": arguments.null, "at": arguments.at,
    });
    let provenance = Provenance::new("flockproof.tracks/1", Some(&arguments.seed), configuration);
    let watch = Watch::with(progress::bar());
    let analysis = match analyse(&tracks, &choices, &watch) {
        Err(ChoicesError::Cancelled(Cancelled)) => {
            watch.finish();
            eprintln!("interrupted before there was anything to write");
            return Ok(interrupt::status(false));
        }
        analysis => analysis.map_err(|error| refuse(&error))?,
    };
    let (reached, frames) = (analysis.frames.len(), tracks.frames.len());
    let tracks = if reached < frames { tracks.first(reached) } else { tracks };
    let mut report = TracksReport {
        source: &source,
        tracks: &tracks,
        analysis: &analysis,
        null: None,
        delays: None,
        snapshot_at: arguments.at,
        known: known(arguments, &tracks, beside),
    };
    // The null models take longest: what was measured is written before them, whatever becomes of them.
    interrupt::finishing();
    let files = write(arguments, report.tables(&provenance))?;
    let measured = said(arguments, &report, &provenance, &files);
    let interrupted = || {
        watch.finish();
        print(arguments, &measured)?;
        let measured =
            if reached < frames { format!("the first {reached} of {frames} frames") } else { "all frames".to_string() };
        eprintln!("interrupted: what was measured of {measured} is written, without null models and pictures");
        Ok(interrupt::status(false))
    };
    if reached < frames || interrupt::happened() {
        return interrupted();
    }
    interrupt::keep(&measured);
    interrupt::working();
    let found = arguments.delays.map(|seconds| delays(&tracks, &analysis.motion, seconds, &watch)).transpose();
    let null = analysis.null_models(arguments.null, &arguments.seed, &watch);
    interrupt::finishing();
    interrupt::kept();
    let (Ok(null), Ok(found)) = (null, found) else { return interrupted() };
    watch.finish();
    report.null = null.as_ref();
    report.delays = found.as_ref();
    let mut files = write(arguments, report.tables(&provenance))?;
    // Who stops the work does not wait for pictures.
    let complete = !interrupt::happened();
    if complete {
        files.extend(write(arguments, report.pictures().map_err(|error| refuse(&error))?)?);
    }
    print(arguments, &said(arguments, &report, &provenance, &files))?;
    if !complete {
        eprintln!("interrupted: everything is written but the pictures");
    }
    Ok(interrupt::status(complete))
}

/// Writes files and returns their names.
fn write(arguments: &Arguments, files: Vec<File>) -> Result<Vec<String>, CliError> {
    let put = |file: File| {
        output::write_file(&arguments.out.join(&file.name), &file.contents)?;
        Ok(file.name)
    };
    files.into_iter().map(put).collect()
}

fn print(arguments: &Arguments, said: &str) -> Result<(), CliError> {
    if arguments.json { output::print_raw(said) } else { output::print(said) }
}

/// What is printed: the summary, or the text and the names of the files.
fn said(arguments: &Arguments, report: &TracksReport, provenance: &Provenance, files: &[String]) -> String {
    if arguments.json {
        return format!("{:#}\n", provenance.stamp(report.summary()));
    }
    let written = format!("{}\nwritten to {}: {}", provenance.line(), arguments.out.display(), files.join(", "));
    let stale = stale(arguments, files);
    let stale =
        if stale.is_empty() { String::new() } else { format!("\nof an earlier run there: {}", stale.join(", ")) };
    format!("{}\n{}\n", report.text(), textwrap::fill(&format!("{written}{stale}"), 80))
}

/// Files of other choices that lie in the folder and are not of this run.
fn stale(arguments: &Arguments, written: &[String]) -> Vec<&'static str> {
    let ours = |name: &str| written.iter().any(|file| file == name) || arguments.synthetic.is_some() && name == SCHOOL;
    let old = |name: &&str| arguments.out.join(name).exists() && !ours(name);
    TracksReport::NOT_ALWAYS.into_iter().filter(old).collect()
}
