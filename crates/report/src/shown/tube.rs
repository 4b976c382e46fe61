//! Quantities over time, for all motions of a set at once.

use crate::plot::{Axis, Panel, Picture, Series, literal};
use motion::sets::Tube;
use question::{Question, Tubes};

const WORST: &str = "#c22f2f";
const OTHERS: &str = "#6b6b6b";

/// A panel for each quantity of a question: the tube of all starts, with runs in it.
pub fn tubes(question: &Question, drawn: &Tubes) -> Picture {
    let panels = drawn.tubes.iter().map(|tube| panel(tube, ["all starts, enclosed", "the worst of them"], drawn.worst));
    let picture = panels.fold(Picture::new(question.id()), Picture::panel);
    match drawn.worst.and_then(|worst| drawn.runs.get(worst)) {
        Some(worst) => picture.caption(&format!("The worst of the starts that are drawn: {worst}.")),
        None => picture,
    }
}

/// One quantity: the enclosure of all motions, single ones, and the worst of these.
pub(super) fn panel(tube: &Tube, [all, bad]: [&str; 2], worst: Option<usize>) -> Panel {
    let mut panel = Panel::new("", Axis::linear("t"), Axis::linear(literal(&tube.quantity)));
    for (number, part) in together(&tube.sections).enumerate() {
        let name = if number == 0 { all } else { "" };
        panel = panel.series(Series::area(name, outline(part)).colour(crate::plot::PALETTE[0]));
    }
    let lines = tube.runs.iter().enumerate().filter(|(run, _)| Some(*run) != worst);
    for (number, (_, run)) in lines.enumerate() {
        let name = if number == 0 { "single starts" } else { "" };
        panel = panel.series(Series::line(name, middles(run)).colour(OTHERS).size(0.9));
    }
    match worst.and_then(|worst| tube.runs.get(worst)) {
        Some(run) => panel.series(Series::line(bad, middles(run)).colour(WORST)),
        None => panel,
    }
}

/// Sections that follow each other and have values.
fn together(sections: &[[f64; 4]]) -> impl Iterator<Item = &[[f64; 4]]> {
    let parts = sections.chunk_by(|a, b| a[1] == b[0] && a[2].is_finite() == b[2].is_finite());
    parts.filter(|part| part[0][2].is_finite() && part[0][3].is_finite())
}

fn outline(part: &[[f64; 4]]) -> Vec<(f64, f64)> {
    let above = part.iter().flat_map(|[from, to, _, hi]| [(*from, *hi), (*to, *hi)]);
    let below = part.iter().rev().flat_map(|[from, to, lo, _]| [(*to, *lo), (*from, *lo)]);
    above.chain(below).collect()
}

fn middles(sections: &[[f64; 4]]) -> impl Iterator<Item = (f64, f64)> + '_ {
    sections.iter().map(|[from, to, lo, hi]| (f64::midpoint(*from, *to), f64::midpoint(*lo, *hi)))
}
