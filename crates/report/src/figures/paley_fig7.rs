//! Figure 7 of Paley and others: the perceptual zones of a fish.

use super::paley::{BLACK, BLUE, GREEN, ORANGE, RED, zone_outline};
use super::{Reproduced, csv};
use crate::plot::{Axis, Panel, Picture, Series};
use arithmetic::Complex;
use ledger::CheckError;
use models::oscillator::Zone;
use runs::zones_of_figure_7;
use std::f64::consts::{FRAC_PI_2, PI};
use std::fmt::Write;

/// Grid points on half of each axis, for the areas.
const HALF: i32 = 400;

pub(super) fn reproduce() -> Result<Reproduced, CheckError> {
    let zones = zones_of_figure_7(&1.0);
    let half_blind = zones.blind_cosine_squared.sqrt().acos();
    // The fish at the origin swims upwards.
    let (at, heading) = (Complex::new(0.0, 0.0), FRAC_PI_2);
    let up = Complex::new(0.0, 1.0);
    let mut text = format!(
        "The drawing gives no numbers. Chosen (as in paley.fig7): outer radii {}, {} and {},\n\
         blind spot alpha = {:.0} degrees (Figure 8's), fish at 0 heading up.\n\n\
         \x20 zone           from  to  area by the law  area of the drawn sector\n",
        zones.repulsion,
        zones.orientation,
        zones.attraction,
        2.0 * half_blind.to_degrees()
    );
    let mut panel = Panel::new("", Axis::linear("x"), Axis::linear("y")).equal_scales();
    let mut table = Vec::new();
    let reach = 1.05 * zones.attraction;
    let step = reach / f64::from(HALF);
    for (zone, name, colour, inner, outer) in [
        (Zone::Attraction, "attraction (ZA)", GREEN, zones.orientation, zones.attraction),
        (Zone::Orientation, "orientation (ZO)", ORANGE, zones.repulsion, zones.orientation),
        (Zone::Repulsion, "repulsion (ZR)", RED, 0.0, zones.repulsion),
    ] {
        let outline = zone_outline(&zones, (inner, outer), &at, heading);
        table.extend(outline.iter().map(|(x, y)| [name.to_string(), format!("{x:.6}"), format!("{y:.6}")]));
        panel = panel.series(Series::area(name, outline).colour(colour));
        // The law itself, asked at the points of a grid.
        let grid = || (-HALF..=HALF).map(|k| f64::from(k) * step);
        let sensed = |(x, y): &(f64, f64)| zones.senses(zone, &up, &Complex::new(*x, *y));
        let count = grid().flat_map(|x| grid().map(move |y| (x, y))).filter(sensed).count();
        let sector = (PI - half_blind) * (outer * outer - inner * inner);
        // Writing to a string cannot fail.
        let _ = writeln!(text, "  {name:16} {inner:3}  {outer:2}  {:15.3}  {sector:24.3}", count as f64 * step * step);
    }
    let ray = |side: f64| {
        let angle = heading + PI + side * half_blind;
        [(0.0, 0.0), (zones.attraction * angle.cos(), zones.attraction * angle.sin())]
    };
    panel = panel
        .series(Series::line("edge of the blind spot", ray(1.0)).colour(BLUE))
        .series(Series::line("", ray(-1.0)).colour(BLUE))
        .series(Series::arrows("", [((0.0, -0.6), (0.0, 1.2))]).colour(BLACK).size(2.6));
    let _ = writeln!(
        text,
        "\nArea by the law: points of a grid of step {step:.4} at which Zones::senses says\n\
         that the fish senses another. Definitions as printed (paley.fig7); the\n\
         zones are annuli that share their boundaries, the blind spot an open wedge."
    );
    let picture = Picture::new("Figure 7: zones of a fish and its blind spot").grid(1, (640.0, 600.0)).panel(panel);
    Ok(Reproduced::new(text).table("", csv("zone,x,y", table)).picture("", picture))
}
