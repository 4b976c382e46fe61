//! Figure 2 of Paley and others: eigenvectors of the cyclic graph C_12 as polygons.

use super::paley::{BLUE, RED, circle};
use super::{Reproduced, csv};
use crate::plot::{Axis, Panel, Picture, Series};
use arithmetic::Complex;
use ledger::{CheckError, exact_value};
use runs::PARTICLES;
use runs::figure2::{Columns, Polygon};
use std::fmt::Write;

/// The phasors in floats.
fn vertices(polygon: &Polygon) -> Result<Vec<(f64, f64)>, CheckError> {
    let float = |z: &Complex<_>| -> Result<(f64, f64), CheckError> {
        let part = |x: &arithmetic::RealCyclotomic| Ok::<f64, CheckError>(x.enclose(64)?.to_f64());
        Ok((part(&z.re)?, part(&z.im)?))
    };
    polygon.phasors.iter().map(float).collect()
}

fn panel(title: String, vertices: &[(f64, f64)]) -> Panel {
    let ticks = [-1.0, 0.0, 1.0];
    let axis = |label: &str| Axis::linear(label).between(-1.25, 1.25).ticks(ticks);
    Panel::new(title, axis("real part"), axis("imaginary part"))
        .equal_scales()
        .series(circle((0.0, 0.0), 1.0).colour("#b4bfc6"))
        .series(Series::line("", vertices.iter().chain(vertices.first()).copied()).colour(BLUE).size(1.4))
        .series(Series::points("", vertices.iter().copied()).colour(RED).size(4.0))
}

pub(super) fn reproduce() -> Result<Reproduced, CheckError> {
    let mut text = "Columns e^(2 pi i (m-1)(k-1)/12) of the Fourier matrix, k = 1..12; all exact\n\
         (roots of unity). Edges join neighbours on C_12.\n\n\
         \x20 m  eigenvalue                         L f = value f  regular  pattern\n"
        .to_string();
    let mut picture = Picture::new("Figure 2: eigenvectors of the Laplacian of C_12").grid(4, (290.0, 300.0));
    let mut table = Vec::new();
    for m in 1..=PARTICLES as i64 {
        let (polygon, value) = Columns::PRINTED.column(m);
        let vertices = vertices(&polygon)?;
        let yes = |yes: bool| if yes { "yes" } else { "NO" };
        let clusters = polygon.clusters.map_or("none".to_string(), |clusters| format!("({clusters},12)"));
        let value = exact_value(&value)?;
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "{m:3}  {value:34} {:13}  {:7}  {clusters}",
            yes(polygon.has_value),
            yes(polygon.regular && value == exact_value(&polygon.squared_edge)?)
        );
        let near: f64 = polygon.squared_edge.enclose(64)?.to_f64();
        picture = picture.panel(panel(format!("m = {m}: λ = {near:.4}, {clusters}"), &vertices));
        for (k, (x, y)) in vertices.iter().enumerate() {
            table.push([
                m.to_string(),
                (k + 1).to_string(),
                format!("{x:.12}"),
                format!("{y:.12}"),
                format!("{near:.12}"),
            ]);
        }
    }
    let rhombus = Polygon::rhombus();
    let _ = writeln!(
        text,
        "\nRegular: all edges have one length, whose square is the eigenvalue, and turn by\n\
         one angle (paley.fig2, holds). The caption's \"if e^(i theta) is an eigenvector\n\
         of L, then theta forms a symmetric pattern\" is false (paley.fig2.caption):\n\
         phases 0, 1/6, 1/2, 2/3 turns in turn are an eigenvector for 2 ({}) and\n\
         {} (picture paley.fig2-rhombus).",
        if rhombus.has_value { "exactly" } else { "NOT" },
        if rhombus.clusters.is_none() { "no symmetric pattern" } else { "a symmetric pattern" },
    );
    let counterexample = Picture::new("An eigenvector that is no symmetric pattern")
        .grid(1, (420.0, 400.0))
        .panel(panel("phases 0, 1/6, 1/2, 2/3 turns in turn: λ = 2".to_string(), &vertices(&rhombus)?));
    Ok(Reproduced::new(text)
        .table("", csv("column,k,x,y,eigenvalue", table))
        .picture("", picture)
        .picture("rhombus", counterexample))
}
