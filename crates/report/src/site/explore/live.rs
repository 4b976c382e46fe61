//! Pages that ask the program while they are looked at: under `flockproof serve`.

use maud::{Markup, html};

/// A live page.
pub(in super::super) struct Live {
    /// The name of the page.
    pub name: &'static str,
    pub title: &'static str,
    about: &'static str,
    /// The question it asks, and the command that answers the same.
    ask: &'static str,
    command: &'static str,
    fields: &'static [Field],
    /// Whether flocks are drawn.
    draws: bool,
}

/// What is asked for: name, label, what stands there at first.
type Field = (&'static str, &'static str, &'static str);

/// All of them.
pub(in super::super) const LIVE: &[Live] = &[
    Live {
        name: "live-resonance",
        title: "Resonance of a platoon",
        about: "The frequency at which the last car of a two-sided platoon swings most, and how much, with certified digits, beside Theorem 1.",
        ask: "resonance",
        command: "flockproof resonance --followers 128 --f -1 --g -1 --digits 15 --json",
        fields: &[("followers", "Followers", "128"), ("f", "f", "-1"), ("g", "g", "-1")],
        draws: false,
    },
    Live {
        name: "live-spectra",
        title: "Spectra of graphs",
        about: "Eigenvalues of a matrix of a graph, enclosed. Graphs: ring:12, path:30, complete:5, star:7, circulant:12:1,3 and others. \
                Matrices: laplacian, out-degree, in-degree, normalised, walk, adjacency.",
        ask: "spectrum",
        command: "flockproof spectrum --graph ring:12 --json",
        fields: &[("graph", "Graph", "ring:12"), ("kind", "Matrix", "laplacian")],
        draws: false,
    },
    Live {
        name: "live-flock",
        title: "A flock of your own, settled exactly",
        about: "Averaging birds in the plane: drag to set a bird and its velocity, or write them. The program finds every switch of the network, \
                and whether it can ever change again.",
        ask: "flock",
        command: "flockproof flock settle FILE --json",
        fields: &[],
        draws: true,
    },
];

/// What a flock is at first.
const BIRDS: &str = "{\"model\": \"D\", \"dimension\": 2, \"weights\": \"lazy\", \"hysteresis\": \"paper\",\n \
                     \"positions\": [[\"0\", \"0\"], [\"1/2\", \"1/4\"], [\"2\", \"0\"]],\n \"velocities\": [[\"1/8\", \"0\"], [\"0\", \"1/8\"], [\"-1/8\", \"0\"]]}";

/// The page.
pub(super) fn body(live: &Live) -> Markup {
    html! {
        h1 { (live.title) }
        p.lead { (live.about) }
        p #away { "This page asks the program. Start it with " code { "flockproof serve" } " and open the address that it prints; or ask on the command line: "
            code { (live.command) } "." }
        form #ask data-ask=(live.ask) hidden {
            @for (name, label, value) in live.fields {
                label { span { (label) } input name=(name) value=(value) autocomplete="off" spellcheck="false"; }
            }
            @if live.draws {
                canvas #birds width="640" height="360" role="img" aria-label="The birds and their velocities, as written below" {}
                label.words { span { "The flock" } textarea name="flock" rows="6" spellcheck="false" { (BIRDS) } }
            }
            button type="submit" { "Ask" }
            @if live.draws { " " button type="button" #clear { "No birds" } }
        }
        p #state role="status" {}
        div.wide tabindex="0" role="region" aria-label="Answer" { table #answer {} }
        script src="../live.js" defer {}
    }
}
