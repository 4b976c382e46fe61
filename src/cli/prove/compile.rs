//! Running coqc over the development.

use flockproof::arithmetic::Progress;
use flockproof::kernel::{AxiomSet, Source, Theorem, Transcript};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::fs::{File, TryLockError};
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread::JoinHandle;
use std::time::Duration;

/// How Coq is installed where it is missing.
pub const INSTALL: &str = "apt-get install --no-install-recommends coq libcoq-interval libcoq-flocq libcoq-coquelicot \
                           libcoq-mathcomp-ssreflect libcoq-mathcomp-algebra libcoq-mathcomp-algebra-tactics \
                           libcoq-mathcomp-zify";

/// Why a development was not built.
#[derive(Debug, thiserror::Error)]
pub enum ProveError {
    /// There is no coqc.
    #[error("coqc was not found; on Debian or Ubuntu: {INSTALL}")]
    NoCoq,
    /// A file that could not be written or read, or a program that could not be run.
    #[error("{}: {}", path.display(), crate::cli::output::sentence(error))]
    File {
        /// The file.
        path: PathBuf,
        /// What happened.
        error: io::Error,
    },
    /// Another run compiles in the folder.
    #[error("{} is in use by another run; choose a folder with --out", .0.display())]
    InUse(PathBuf),
    /// coqc refused a file.
    #[error("coqc refuses {file}: {message}")]
    Refused {
        /// The file.
        file: String,
        /// The first lines of what coqc said.
        message: String,
    },
    /// A theorem rests on an axiom that is not allowed.
    #[error("{theorem} rests on the axiom {axiom}, which is not allowed")]
    Axiom {
        /// `file.name`.
        theorem: String,
        /// The axiom.
        axiom: String,
    },
    /// Stopped before the end.
    #[error("the work was interrupted; what was compiled is kept in {}", .0.display())]
    Interrupted(PathBuf),
}

/// How often it is asked whether a running coqc should be ended.
const TICK: Duration = Duration::from_millis(20);

/// A folder in which the development is compiled, by one run at a time.
pub struct Workshop {
    folder: PathBuf,
    /// Locked as long as this run lasts, however it ends.
    _lock: File,
    /// The version of Coq.
    pub coq: String,
}

impl Workshop {
    /// Opens the folder, or the first of `folder-2`, `folder-3`, .. that no other run uses.
    ///
    /// # Errors
    /// [`ProveError::NoCoq`], [`ProveError::File`].
    pub fn open_first_free(folder: &Path) -> Result<Self, ProveError> {
        let mut tried = Self::open(folder);
        for number in 2.. {
            if !matches!(tried, Err(ProveError::InUse(_))) {
                break;
            }
            let mut name = folder.as_os_str().to_owned();
            name.push(format!("-{number}"));
            tried = Self::open(Path::new(&name));
        }
        tried
    }

    /// Makes the folder and asks for the version of Coq.
    ///
    /// # Errors
    /// [`ProveError::NoCoq`], [`ProveError::File`], [`ProveError::InUse`].
    pub fn open(folder: &Path) -> Result<Self, ProveError> {
        let version = Command::new("coqc").arg("--print-version").output().map_err(|error| match error.kind() {
            io::ErrorKind::NotFound => ProveError::NoCoq,
            _ => ProveError::File { path: PathBuf::from("coqc"), error },
        })?;
        let coq = String::from_utf8_lossy(&version.stdout).split_whitespace().next().unwrap_or("unknown").to_string();
        std::fs::create_dir_all(folder).map_err(|error| ProveError::File { path: folder.to_path_buf(), error })?;
        // coqc runs inside the folder.
        let folder = folder.canonicalize().map_err(|error| ProveError::File { path: folder.to_path_buf(), error })?;
        let path = folder.join("in_use");
        let failed = |error| ProveError::File { path: path.clone(), error };
        let lock = File::create(&path).map_err(failed)?;
        match lock.try_lock() {
            Ok(()) => Ok(Workshop { folder, _lock: lock, coq }),
            Err(TryLockError::WouldBlock) => Err(ProveError::InUse(folder)),
            // Some network file systems know no locks.
            Err(TryLockError::Error(error)) if error.kind() == io::ErrorKind::Unsupported => {
                Ok(Workshop { folder, _lock: lock, coq })
            }
            Err(TryLockError::Error(error)) => Err(failed(error)),
        }
    }

    /// Compiles a file whose needs are compiled; one that an earlier run compiled from the same sources with the same
    /// Coq is left alone.
    ///
    /// # Errors
    /// [`ProveError::Refused`], [`ProveError::File`].
    pub fn compile(&self, source: &Source, progress: &dyn Progress) -> Result<(), ProveError> {
        let (mark, object) = (self.path(source.name, "done"), self.path(source.name, "vo"));
        let digest = format!("{} {}", self.coq, source.digest);
        if object.is_file() && std::fs::read_to_string(&mark).is_ok_and(|done| done == digest) {
            return Ok(());
        }
        self.run(source.name, source.text, progress)?;
        std::fs::write(&mark, digest).map_err(|error| ProveError::File { path: mark, error })
    }

    /// The axioms under the theorems of one compiled file, in their order.
    ///
    /// # Errors
    /// [`ProveError::Refused`], [`ProveError::File`], [`ProveError::Axiom`].
    pub fn axioms(
        &self,
        file: &str,
        theorems: &[&Theorem],
        progress: &dyn Progress,
    ) -> Result<Vec<AxiomSet>, ProveError> {
        let mut text = format!("From Flockproof Require {file}.\n");
        for theorem in theorems {
            text.push_str(&format!("Goal True. idtac \"{MARK}\". Abort.\nPrint Assumptions {}.\n", theorem.path()));
        }
        let output = self.run(&format!("axioms_of_{file}"), &text, progress)?;
        let said = String::from_utf8_lossy(&output.stdout).into_owned();
        let refused = |message: &str| ProveError::Refused { file: file.to_string(), message: message.to_string() };
        let parts: Vec<&str> = said.split(MARK).skip(1).collect();
        if parts.len() != theorems.len() {
            return Err(refused("the axioms of its theorems were not all printed"));
        }
        theorems
            .iter()
            .zip(parts)
            .map(|(theorem, part)| {
                let axioms = named_axioms(part).ok_or_else(|| refused("the axioms of a theorem were not printed"))?;
                AxiomSet::of(axioms).map_err(|axiom| ProveError::Axiom { theorem: theorem.path(), axiom })
            })
            .collect()
    }

    fn path(&self, name: &str, extension: &str) -> PathBuf {
        self.folder.join(format!("{name}.{extension}"))
    }

    /// Runs coqc; `progress` may end it.
    fn run(&self, name: &str, text: &str, progress: &dyn Progress) -> Result<Output, ProveError> {
        let path = self.path(name, "v");
        let failed = |error| ProveError::File { path: path.clone(), error };
        self.checkpoint(progress)?;
        std::fs::write(&path, text).map_err(failed)?;
        let mut coqc = Command::new("coqc")
            .args(["-Q", ".", "Flockproof", "-w", "-notation-overridden,-ambiguous-paths"])
            .arg(format!("{name}.v"))
            .current_dir(&self.folder)
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .map_err(failed)?;
        // Both pipes are emptied while it runs, so that it never waits for us.
        let (said, complained) = (drain(coqc.stdout.take()), drain(coqc.stderr.take()));
        let status = loop {
            if let Some(status) = coqc.try_wait().map_err(failed)? {
                break status;
            }
            if let Err(stopped) = self.checkpoint(progress) {
                coqc.kill().and_then(|()| coqc.wait()).map_err(failed)?;
                return Err(stopped);
            }
            std::thread::sleep(TICK);
        };
        let output =
            Output { status, stdout: said.join().unwrap_or_default(), stderr: complained.join().unwrap_or_default() };
        if output.status.success() {
            return Ok(output);
        }
        let message: Vec<String> =
            String::from_utf8_lossy(&output.stderr).lines().take(8).map(|line| line.trim().to_string()).collect();
        Err(ProveError::Refused { file: format!("{name}.v"), message: message.join(" ") })
    }

    fn checkpoint(&self, progress: &dyn Progress) -> Result<(), ProveError> {
        progress.checkpoint().map_err(|_| ProveError::Interrupted(self.folder.clone()))
    }
}

/// Reads all that comes through a pipe, on a thread of its own.
fn drain(pipe: Option<impl Read + Send + 'static>) -> JoinHandle<Vec<u8>> {
    std::thread::spawn(move || {
        let mut bytes = Vec::new();
        // What was read before an error still tells why coqc failed.
        let _ = pipe.map(|mut pipe| pipe.read_to_end(&mut bytes));
        bytes
    })
}

/// Printed before the axioms of each theorem.
const MARK: &str = "== axioms ==";

/// The names in what `Print Assumptions` says: a name opens its line, its type is indented or follows a colon.
fn named_axioms(said: &str) -> Option<Vec<&str>> {
    let mut lines = said.trim().lines();
    match lines.next()? {
        "Closed under the global context" => Some(Vec::new()),
        "Axioms:" => Some(lines.filter(|l| !l.starts_with(' ')).filter_map(|l| l.split_whitespace().next()).collect()),
        _ => None,
    }
}

/// Compiles everything and asks for all axioms, as many files at a time as rayon has threads; `progress` is told of each file that
/// is begun, and may stop it.
///
/// # Errors
/// [`ProveError`].
pub fn prove(
    workshop: &Workshop,
    sources: &[Source],
    theorems: &[Theorem],
    progress: &dyn Progress,
) -> Result<Transcript, ProveError> {
    let proved_in = |source: &Source| -> Vec<&Theorem> { theorems.iter().filter(|t| t.file == source.name).collect() };
    let steps = sources.len() + sources.iter().filter(|source| !proved_in(source).is_empty()).count();
    let begun = AtomicU64::new(0);
    let tell = |source: &Source| {
        progress.tell(source.name, begun.fetch_add(1, Ordering::Relaxed) + 1, Some(steps as u64));
    };
    for level in levels(sources) {
        level.par_iter().try_for_each(|source| {
            tell(source);
            workshop.compile(source, progress)
        })?;
    }
    let axioms = sources.par_iter().map(|source| {
        let proved = proved_in(source);
        if proved.is_empty() {
            return Ok(Vec::new());
        }
        tell(source);
        let axioms = workshop.axioms(source.name, &proved, progress)?;
        Ok(proved.into_iter().map(Theorem::path).zip(axioms).collect())
    });
    let axioms = axioms.collect::<Result<Vec<Vec<_>>, ProveError>>()?;
    Ok(Transcript {
        coq: workshop.coq.clone(),
        digests: sources.iter().map(|source| (source.name.to_string(), source.digest.clone())).collect(),
        theorems: axioms.into_iter().flatten().collect(),
    })
}

/// The files in groups, each of which needs earlier groups only.
fn levels(sources: &[Source]) -> Vec<Vec<&Source>> {
    let mut depths: BTreeMap<&str, usize> = BTreeMap::new();
    let mut levels: Vec<Vec<&Source>> = Vec::new();
    for source in sources {
        let depth = source.needs.iter().filter_map(|need| depths.get(need)).max().map_or(0, |depth| depth + 1);
        depths.insert(source.name, depth);
        if levels.len() <= depth {
            levels.resize_with(depth + 1, Vec::new);
        }
        levels[depth].push(source);
    }
    levels
}
