//! The quantities of a question over time, for all starts of its boxes at once.

use crate::plot::{Axis, Panel, Picture, Series};
use question::{Question, Tubes};

const WORST: &str = "#c22f2f";
const OTHERS: &str = "#6b6b6b";

/// A panel for each quantity: the tube of all starts, with runs in it.
pub fn tubes(question: &Question, drawn: &Tubes) -> Picture {
    let mut picture = Picture::new(question.id());
    for tube in &drawn.tubes {
        // In a label an underscore would begin an index.
        let quantity = tube.quantity.replace('_', " ");
        let mut panel = Panel::new("", Axis::linear("t"), Axis::linear(quantity));
        for (number, part) in together(&tube.sections).enumerate() {
            let name = if number == 0 { "all starts, enclosed" } else { "" };
            panel = panel.series(Series::area(name, outline(part)).colour(crate::plot::PALETTE[0]));
        }
        let lines = tube.runs.iter().enumerate().filter(|(run, _)| Some(*run) != drawn.worst);
        for (number, (_, run)) in lines.enumerate() {
            let name = if number == 0 { "single starts" } else { "" };
            panel = panel.series(Series::line(name, middles(run)).colour(OTHERS).size(0.9));
        }
        if let Some(run) = drawn.worst.and_then(|worst| tube.runs.get(worst)) {
            panel = panel.series(Series::line("the worst of them", middles(run)).colour(WORST));
        }
        picture = picture.panel(panel);
    }
    match drawn.worst.and_then(|worst| drawn.runs.get(worst)) {
        Some(worst) => picture.caption(&format!("The worst of the starts that are drawn: {worst}.")),
        None => picture,
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
