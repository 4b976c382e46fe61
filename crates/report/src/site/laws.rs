//! The gallery of laws: each with its source, its motion, and a question about it with the answer.

use super::Texts;
use super::explore::RunsError;
use crate::page::player::Motion;
use crate::shown;
use arithmetic::Unwatched;
use maud::{Markup, PreEscaped, html};
use question::{Question, decide};
use scenario::Scenario;

macro_rules! gallery {
    ($($name:literal),* $(,)?) => {
        &[$(Law {
            name: $name,
            file: concat!("assets/laws/", $name, ".toml"),
            question: concat!("assets/laws/questions/", $name, ".toml"),
        }),*]
    };
}

/// A law of the gallery.
pub(super) struct Law {
    /// The name of its page.
    pub name: &'static str,
    /// Its file, a scenario.
    pub file: &'static str,
    question: &'static str,
}

/// All of them.
pub(super) const LAWS: &[Law] = gallery![
    "boids",
    "circling",
    "couzin",
    "cucker_smale",
    "dorsogna",
    "fish",
    "heading_alignment",
    "hegselmann_krause",
    "intelligent_driver",
    "jadbabaie",
    "kuramoto",
    "lazy_averaging",
    "moreau",
    "motsch_tadmor",
    "olfati_saber",
    "phase_model",
    "platoon_behind",
    "platoon_both_sides",
    "sakaguchi",
    "velocity_alignment",
    "vicsek",
];

/// The files that the pages show.
pub(super) fn files() -> impl Iterator<Item = &'static str> {
    LAWS.iter().flat_map(|law| [law.file, law.question])
}

/// The remark at the top of a file.
fn remark(text: &str) -> String {
    let lines = text.lines().map_while(|line| line.strip_prefix('#'));
    lines.map(str::trim).collect::<Vec<_>>().join(" ")
}

/// What a law is called.
fn title<'t>(law: &Law, text: &'t str) -> &'t str {
    let named = text.lines().find_map(|line| line.strip_prefix("name = \""));
    named.and_then(|rest| rest.strip_suffix('"')).unwrap_or(law.name)
}

/// A law with its page and a small picture of its run.
pub(super) struct Shown {
    pub title: String,
    pub body: Markup,
    picture: Option<Markup>,
}

/// The list of laws.
pub(super) fn list(listed: &[(&Law, Shown)]) -> Markup {
    html! {
        h1 { "Laws of the literature" }
        p.lead { "Each is a file that was written without Rust. Each page has its motion, and a question about it with the answer. " a href="../explore/live-law.html" { "Change one, and run it." } }
        ul.shows {
            @for (law, shown) in listed {
                li { a href={ (law.name) ".html" } { @if let Some(picture) = &shown.picture { (picture) } (shown.title) } }
            }
        }
    }
}

/// The page of a law; nothing where its files are not there.
///
/// # Errors
/// The sentence of what could not be computed.
pub(super) fn body(law: &Law, texts: Texts) -> Result<Option<Shown>, RunsError> {
    let Some((text, asked)) = texts(law.file).zip(texts(law.question)) else { return Ok(None) };
    let failed = |error: String| RunsError::Case(format!("{}: {error}", law.name));
    let question = Question::read(asked, &|_| Ok(text.to_string())).map_err(|error| failed(error.to_string()))?;
    let answer = decide(&question, &Unwatched).map_err(|error| failed(error.to_string()))?;
    let run = Scenario::read(text)?.run(&Unwatched);
    let title = title(law, text).to_string();
    let body = html! {
        h1 { (title) }
        p.lead { (remark(text)) }
        (PreEscaped(shown::question(&question, &answer, &Unwatched)))
        p { (remark(asked)) }
        h2 { "A run" }
        (PreEscaped(shown::simulation(&run)))
        details { summary { "The law" } pre tabindex="0" { code { (text) } } }
        p { a href="../explore/live-law.html" { "Change it, and run it." } }
        script src="../explore.js" defer {}
    };
    let picture = Motion::of_outcome(&run, "").map(|motion| motion.thumbnail());
    Ok(Some(Shown { title, body, picture }))
}
