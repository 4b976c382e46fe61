//! Running coqc over the development.

use flockproof::arithmetic::Progress;
use flockproof::kernel::{AxiomSet, Forbidden, Source, Theorem, Transcript, digest_of, scan};
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
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
    /// A file says what it may not say.
    #[error(transparent)]
    Forbidden(#[from] Forbidden),
    /// A file has the name of one of Coq's libraries.
    #[error("{name}.v has the name of a file of Coq's libraries, {}", library.display())]
    NameOfLibrary {
        /// The name without `.v`.
        name: String,
        /// The file of the library.
        library: PathBuf,
    },
    /// A folder in which somebody else may write what passes for compiled.
    #[error("{} {why}; choose a folder of your own with --out", folder.display())]
    NotOwn {
        /// The folder.
        folder: PathBuf,
        /// What is wrong with it.
        why: &'static str,
    },
    /// There is no folder for what is kept.
    #[error("neither XDG_CACHE_HOME nor HOME names a folder to keep what is compiled; choose one with --out")]
    NoCache,
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
    /// The folder of Coq's own libraries.
    library: PathBuf,
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
        let ask = |option: &str| {
            Command::new("coqc").arg(option).output().map_err(|error| match error.kind() {
                io::ErrorKind::NotFound => ProveError::NoCoq,
                _ => ProveError::File { path: PathBuf::from("coqc"), error },
            })
        };
        let version = ask("--print-version")?;
        let library = PathBuf::from(String::from_utf8_lossy(&ask("-where")?.stdout).trim());
        let coq = String::from_utf8_lossy(&version.stdout).split_whitespace().next().unwrap_or("unknown").to_string();
        std::fs::create_dir_all(folder).map_err(|error| ProveError::File { path: folder.to_path_buf(), error })?;
        // coqc runs inside the folder.
        let folder = folder.canonicalize().map_err(|error| ProveError::File { path: folder.to_path_buf(), error })?;
        let path = folder.join("in_use");
        let failed = |error| ProveError::File { path: path.clone(), error };
        check_own(&folder)?;
        let lock = File::create(&path).map_err(failed)?;
        match lock.try_lock() {
            Ok(()) => Ok(Workshop { folder, _lock: lock, coq, library }),
            Err(TryLockError::WouldBlock) => Err(ProveError::InUse(folder)),
            // Some network file systems know no locks.
            Err(TryLockError::Error(error)) if error.kind() == io::ErrorKind::Unsupported => {
                Ok(Workshop { folder, _lock: lock, coq, library })
            }
            Err(TryLockError::Error(error)) => Err(failed(error)),
        }
    }

    /// Forgets what earlier runs compiled.
    ///
    /// # Errors
    /// [`ProveError::File`].
    pub fn forget(&self, sources: &[Source]) -> Result<(), ProveError> {
        let kept = |end| sources.iter().map(move |source| self.path(source.name, end));
        for path in kept("done").chain(kept("axioms")) {
            match std::fs::remove_file(&path) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(ProveError::File { path, error }),
                _ => {}
            }
        }
        Ok(())
    }

    /// Compiles a file whose needs are compiled. One that an earlier run compiled is left alone where its mark has the version of Coq,
    /// the digest of its sources, and those of the compiled files, its own and all that it needs, as they are now.
    ///
    /// # Errors
    /// [`ProveError::Refused`], [`ProveError::Forbidden`], [`ProveError::File`].
    pub fn compile(&self, source: &Source, progress: &dyn Progress) -> Result<(), ProveError> {
        scan(source.name, source.text)?;
        let mark = self.path(source.name, "done");
        if std::fs::read_to_string(&mark).is_ok_and(|done| self.mark(source).is_some_and(|now| now == done)) {
            return Ok(());
        }
        self.run(source.name, source.text, progress)?;
        let digest = self.mark(source).unwrap_or_default();
        std::fs::write(&mark, digest).map_err(|error| ProveError::File { path: mark, error })
    }

    /// What a compiled file rests on; nothing where one is missing.
    fn mark(&self, source: &Source) -> Option<String> {
        let mut text = format!("{} {}\n", self.coq, source.digest);
        for name in source.needs.iter().chain([&source.name]) {
            let object = std::fs::read(self.path(name, "vo")).ok()?;
            text += &format!("{name} {}\n", digest_of(&object));
        }
        Some(text)
    }

    /// The axioms under the theorems of one compiled file, in their order. What an earlier run was told of the same theorems is taken where the mark that it
    /// noted is the one of now.
    ///
    /// # Errors
    /// [`ProveError::Refused`], [`ProveError::File`], [`ProveError::Axiom`].
    pub fn axioms(
        &self,
        source: &Source,
        theorems: &[&Theorem],
        progress: &dyn Progress,
    ) -> Result<Vec<AxiomSet>, ProveError> {
        let kept = self.path(source.name, "axioms");
        let paths = theorems.iter().map(|theorem| theorem.path() + "\n").collect::<String>();
        let asked = self.mark(source).unwrap_or_default() + &paths;
        let told = std::fs::read_to_string(&kept).unwrap_or_default();
        if let Some(words) = told.strip_prefix(&asked)
            && let Some(axioms) = words.lines().map(AxiomSet::parse).collect::<Option<Vec<_>>>()
            && axioms.len() == theorems.len()
        {
            return Ok(axioms);
        }
        let axioms = self.ask_axioms(source.name, theorems, progress)?;
        let words = axioms.iter().map(|axioms| format!("{}\n", axioms.words())).collect::<String>();
        std::fs::write(&kept, asked + &words).map_err(|error| ProveError::File { path: kept, error })?;
        Ok(axioms)
    }

    /// The same, asked of coqc.
    fn ask_axioms(
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
        let mut named = Vec::new();
        for part in parts {
            named.push(named_axioms(part).ok_or_else(|| refused("the axioms of a theorem were not printed"))?);
        }
        let full = self.full_names(file, named.iter().flatten().copied().collect(), progress)?;
        let known = |axiom: &&str| full.get(*axiom).cloned().unwrap_or_else(|| (*axiom).to_string());
        theorems
            .iter()
            .zip(named)
            .map(|(theorem, axioms)| {
                let axioms: Vec<String> = axioms.iter().map(known).collect();
                AxiomSet::of(axioms.iter().map(String::as_str))
                    .map_err(|axiom| ProveError::Axiom { theorem: theorem.path(), axiom })
            })
            .collect()
    }

    /// Compiles statements of theorems that are compiled.
    ///
    /// # Errors
    /// [`ProveError::Refused`], [`ProveError::File`].
    pub fn state(&self, statements: &str, progress: &dyn Progress) -> Result<(), ProveError> {
        self.run("statements", statements, progress).map(drop)
    }

    /// The full names of axioms, by the names that Coq prints where this file is known. One whose library was not read from the folder of
    /// Coq's own ones is named by the file that it was read from.
    fn full_names(
        &self,
        file: &str,
        axioms: BTreeSet<&str>,
        progress: &dyn Progress,
    ) -> Result<BTreeMap<String, String>, ProveError> {
        if axioms.is_empty() {
            return Ok(BTreeMap::new());
        }
        let ask = |sentences: String, name: &str| -> Result<Vec<String>, ProveError> {
            let output = self.run(name, &format!("From Flockproof Require {file}.\n{sentences}"), progress)?;
            let said = String::from_utf8_lossy(&output.stdout).into_owned();
            Ok(said.split(MARK).skip(1).map(|part| part.split_whitespace().collect::<Vec<_>>().join(" ")).collect())
        };
        let mark = format!("Goal True. idtac \"{MARK}\". Abort.\n");
        let located: String = axioms.iter().map(|axiom| format!("{mark}Locate {axiom}.\n")).collect();
        let located = ask(located, &format!("names_in_{file}"))?;
        // `Constant Coq.Logic.Classical_Prop.classic`: what the name means comes first, others that it hides after it.
        let full: Vec<String> = located
            .iter()
            .map(|said| {
                said.strip_prefix("Constant ").and_then(|rest| rest.split(' ').next()).unwrap_or_default().into()
            })
            .collect();
        let library = |name: &str| name.rsplit_once('.').map_or(String::new(), |(library, _)| library.to_string());
        let asked = full.iter().map(|name| match library(name).as_str() {
            "" => mark.clone(),
            library => format!("{mark}Locate Library {library}.\n"),
        });
        let read = ask(asked.collect(), &format!("libraries_of_{file}"))?;
        let own = self.library.join("theories").display().to_string();
        let names = axioms.iter().zip(full.iter().zip(&read)).map(|(axiom, (full, read))| {
            let from = read.split(" loaded from file ").nth(1).unwrap_or(read);
            let name = if from.starts_with(&own) { full.clone() } else { format!("{full} of {from}") };
            (axiom.to_string(), name)
        });
        Ok(names.collect())
    }

    /// Refuses sources that have the names of Coq's own files: what they say could pass for those.
    ///
    /// # Errors
    /// [`ProveError::NameOfLibrary`].
    pub fn check_names(&self, sources: &[Source]) -> Result<(), ProveError> {
        let mut open = vec![self.library.clone()];
        while let Some(folder) = open.pop() {
            for path in std::fs::read_dir(&folder).into_iter().flatten().flatten().map(|entry| entry.path()) {
                if path.is_dir() {
                    open.push(path);
                } else if path.extension().is_some_and(|end| end == "vo")
                    && let Some(source) = sources.iter().find(|s| path.file_stem().is_some_and(|stem| stem == s.name))
                {
                    return Err(ProveError::NameOfLibrary { name: source.name.to_string(), library: path });
                }
            }
        }
        Ok(())
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
            .args(["-q", "-Q", ".", "Flockproof", "-w", "-notation-overridden,-ambiguous-paths"])
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

/// Refuses a folder of another user, or one in which everyone may write: what lies there may come from anyone. A file that this run makes tells
/// who it is.
#[cfg(unix)]
fn check_own(folder: &Path) -> Result<(), ProveError> {
    use std::os::unix::fs::MetadataExt;
    let failed = |error| ProveError::File { path: folder.to_path_buf(), error };
    let probe = folder.join(format!("owner-{}", std::process::id()));
    let refused = |why| Err(ProveError::NotOwn { folder: folder.to_path_buf(), why });
    let made = match File::create_new(&probe) {
        Err(error) if error.kind() == io::ErrorKind::PermissionDenied => return refused("is not writable"),
        made => made.and_then(|file| file.metadata()).map_err(failed)?,
    };
    std::fs::remove_file(&probe).map_err(failed)?;
    let owned = std::fs::metadata(folder).map_err(failed)?;
    match (owned.uid() == made.uid(), owned.mode() & 0o002 == 0) {
        (false, _) => refused("belongs to another user"),
        (_, false) => refused("is open for everyone to write"),
        _ => Ok(()),
    }
}

/// Elsewhere the folders of users are their own.
#[cfg(not(unix))]
fn check_own(_: &Path) -> Result<(), ProveError> {
    Ok(())
}

/// The folder of the user's own in which compiled proofs are kept.
///
/// # Errors
/// [`ProveError::NoCache`].
pub fn cache() -> Result<PathBuf, ProveError> {
    let named = |name: &str| std::env::var_os(name).map(PathBuf::from).filter(|path| path.is_absolute());
    let folder =
        named("XDG_CACHE_HOME").or_else(|| Some(named("HOME")?.join(".cache"))).or_else(|| named("LOCALAPPDATA"));
    Ok(folder.ok_or(ProveError::NoCache)?.join("flockproof").join("proofs"))
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
    workshop.check_names(sources)?;
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
        let axioms = workshop.axioms(source, &proved, progress)?;
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
