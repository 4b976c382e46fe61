//! `prove` with a program in the place of coqc: what is kept between runs, and whose folder and which axioms are refused. The program
//! writes down each file that it is asked to compile, and compiles it to its own text after a line.

use super::{file, folder};
use flockproof::kernel::files;
use std::collections::BTreeSet;
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Says of all theorems that they rest on no axiom, or on the one that `AXIOM` names; `Locate` tells `FULL`, from the file `LIBRARY`.
const COQC: &str = r#"#!/bin/sh
case "$1" in
  --print-version) echo 8.0 4.0; exit 0;;
  -where) echo "$HERE/coq"; exit 0;;
esac
for name in "$@"; do :; done
stem=${name%.v}
echo "$stem" >> "$HERE/compiled"
{ echo "compiled"; cat "$name"; } > "$stem.vo"
grep -o 'idtac "== axioms ==\|^Locate Library\|^Locate' "$name" | while read -r line; do
  case "$line" in
    idtac*) echo "== axioms =="
      case "$stem" in axioms_of_*) if [ -n "$AXIOM" ]; then echo "Axioms:"; echo "$AXIOM : False"; else echo "Closed under the global context"; fi;; esac;;
    "Locate Library") echo "It has been loaded from file"; echo "$LIBRARY";;
    Locate) echo "Constant $FULL";;
  esac
done
exit 0
"#;

/// A folder with the program in it.
struct Bench {
    here: PathBuf,
}

impl Bench {
    fn new(name: &str) -> Self {
        let here = folder(name);
        let coqc = file(&here, "coqc", COQC.as_bytes());
        std::fs::set_permissions(coqc, PermissionsExt::from_mode(0o755)).expect("chmod");
        Bench { here }
    }

    fn out(&self) -> PathBuf {
        self.here.join("out")
    }

    fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_flockproof"));
        let path = format!("{}:{}", self.here.display(), std::env::var("PATH").expect("a path"));
        command.arg("prove").args(arguments).env("PATH", path).env("HERE", &self.here).env_remove("AXIOM");
        command
    }

    /// The files of the development that a run compiles.
    fn compiled(&self, more: &[&str]) -> BTreeSet<String> {
        self.asked(more).into_iter().filter(|name| files().iter().any(|file| file.name == *name)).collect()
    }

    /// All that coqc is asked to read in a run, those files that only ask for axioms too.
    fn asked(&self, more: &[&str]) -> BTreeSet<String> {
        let list = self.here.join("compiled");
        let _ = std::fs::remove_file(&list);
        let out = self.out().display().to_string();
        self.command(&[&["--out", &out], more].concat()).output().expect("it ends");
        let names = std::fs::read_to_string(&list).unwrap_or_default();
        names.lines().map(String::from).collect()
    }
}

/// A file and all that need it.
fn resting_on(name: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::from([name.to_string()]);
    for file in files() {
        if file.needs.iter().any(|need| found.contains(*need)) {
            found.insert(file.name.to_string());
        }
    }
    found
}

#[test]
fn what_is_kept_is_the_compiled_files_themselves() {
    let bench = Bench::new("prove_kept");
    let all: BTreeSet<String> = files().iter().map(|file| file.name.to_string()).collect();
    assert_eq!(bench.compiled(&[]), all);
    assert_eq!(bench.asked(&[]), BTreeSet::new(), "nothing has changed");
    // Axioms that were noted for another file, or of other theorems, are asked for again.
    let noted = bench.out().join("chazelle_angle.axioms");
    let text = std::fs::read_to_string(&noted).expect("it is there");
    for altered in [
        text.replacen("chazelle_angle ", "chazelle_angle 0", 1),
        text.replace("lifted_birds", "lifted"),
        text.clone() + "none\n",
    ] {
        assert_ne!(text, altered);
        std::fs::write(&noted, altered).expect("it is written");
        assert_eq!(bench.asked(&[]), BTreeSet::from(["axioms_of_chazelle_angle".to_string()]));
        assert_eq!(std::fs::read_to_string(&noted).expect("it is there"), text);
    }
    // A trivial theorem in the place of a file, beside the mark of the true one: it is compiled anew, and is then as it was.
    let exchanged = bench.out().join("chazelle_angle.vo");
    let before = std::fs::read(&exchanged).expect("it is compiled");
    std::fs::write(&exchanged, "Theorem angle_le : True. Proof. exact I. Qed.").expect("it is written");
    assert_eq!(bench.compiled(&[]), BTreeSet::from(["chazelle_angle".to_string()]));
    assert_eq!(std::fs::read(&exchanged).expect("it is there"), before);
    // One whose own mark was exchanged with it: what needs it was compiled against another file, and is compiled anew.
    let mark = bench.out().join("chazelle_model.done");
    let object = bench.out().join("chazelle_model.vo");
    std::fs::write(&object, "other").expect("it is written");
    let text = std::fs::read_to_string(&mark).expect("it is there");
    let digest = text.split_whitespace().last().expect("a digest").to_string();
    std::fs::write(&mark, text.replace(&digest, &flockproof::kernel::digest_of(b"other"))).expect("it is written");
    let without: BTreeSet<String> =
        resting_on("chazelle_model").into_iter().filter(|name| name != "chazelle_model").collect();
    let again = bench.compiled(&[]);
    assert!(!again.is_empty() && again.is_subset(&without), "{again:?}");
    let mut direct = files().iter().filter(|file| file.needs.contains(&"chazelle_model"));
    assert!(direct.all(|file| again.contains(file.name)), "{again:?}");
    assert_eq!(bench.compiled(&["--fresh"]), all, "--fresh compiles all");
}

fn refused(output: &Output, words: &str) {
    let error = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(2), "{error}");
    assert!(error.contains(words) && error.trim_end().lines().count() == 1, "{error}");
}

#[test]
fn a_folder_that_others_may_write_is_refused() {
    let bench = Bench::new("prove_folder");
    let out = bench.out();
    std::fs::create_dir_all(&out).expect("a folder");
    std::fs::set_permissions(&out, PermissionsExt::from_mode(0o777)).expect("chmod");
    let out = out.display().to_string();
    refused(&bench.command(&["--out", &out]).output().expect("it ends"), "is open for everyone to write");
    // Nor is anything kept where the user has no folder.
    let mut homeless = bench.command(&[]);
    refused(
        &homeless.env_remove("HOME").env_remove("XDG_CACHE_HOME").output().expect("it ends"),
        "choose one with --out",
    );
    // A folder of root, for everyone else.
    if std::env::var("USER").is_ok_and(|user| user != "root") && Path::new("/usr").exists() {
        let output = bench.command(&["--out", "/usr"]).output().expect("it ends");
        assert_eq!(output.status.code(), Some(2));
    }
}

#[test]
fn without_a_folder_the_cache_of_the_user_is_used() {
    let bench = Bench::new("prove_cache");
    let home = bench.here.join("home");
    let output = bench.command(&[]).env("HOME", &home).env_remove("XDG_CACHE_HOME").output().expect("it ends");
    assert!(home.join(".cache/flockproof/proofs/chazelle_angle.done").is_file(), "{output:?}");
    bench.command(&[]).env("XDG_CACHE_HOME", bench.here.join("cache")).output().expect("it ends");
    assert!(bench.here.join("cache/flockproof/proofs/chazelle_angle.done").is_file());
}

/// An axiom counts by its full name and by the file that its library was read from.
#[test]
fn axioms_are_allowed_by_their_full_names() {
    let bench = Bench::new("prove_axioms");
    let out = bench.out().display().to_string();
    let own = format!("{}/coq/theories/Logic/Classical_Prop.vo", bench.here.display());
    let with = |full: &str, library: &str| {
        let mut command = bench.command(&["--fresh", "--out", &out]);
        command.env("AXIOM", "Classical_Prop.classic").env("FULL", full).env("LIBRARY", library);
        command.output().expect("it ends")
    };
    let classic = "Coq.Logic.Classical_Prop.classic";
    let allowed = with(classic, &own);
    let said = String::from_utf8_lossy(&allowed.stdout).into_owned();
    assert!(said.contains("reals+classic") && allowed.status.code() == Some(1), "{said}");
    refused(
        &with("Flockproof.Classical_Prop.classic", &format!("{out}/Classical_Prop.vo")),
        "Flockproof.Classical_Prop.classic",
    );
    refused(&with(classic, &format!("{out}/Classical_Prop.vo")), "which is not allowed");
    // A file of the project with the name of a library.
    let library = bench.here.join("coq/user-contrib/Any");
    std::fs::create_dir_all(&library).expect("a folder");
    std::fs::write(library.join("chazelle_angle.vo"), "").expect("a file");
    refused(&with(classic, &own), "chazelle_angle.v has the name of a file of Coq's libraries");
}

#[test]
fn one_claim_needs_only_its_own_files() {
    let bench = Bench::new("prove_claim");
    let theorems = flockproof::kernel::proofs_of("chazelle.tau1");
    let own: Vec<&str> = theorems.map(|(theorem, _)| theorem.file).collect();
    let wanted: BTreeSet<String> = flockproof::kernel::needed(&own).iter().map(|file| file.name.to_string()).collect();
    assert_eq!(bench.compiled(&["--claim", "chazelle.tau1"]), wanted);
    super::assert_refused(&["prove", "--claim", "chazelle.nothing"], "chazelle.nothing");
}
