//! The picture of the regions in which a property holds, fails and is open.

use flockproof::arithmetic::parse_rational;
use flockproof::campaign::sweep::{Table, TableRow};
use flockproof::report::plot::{Axis, Colour, Panel, Picture, Series};
use num_traits::ToPrimitive;
use serde_json::Value;

/// Most members, a panel each.
const MOST_PANELS: usize = 12;

/// What is known of a box, and its colour.
const KINDS: [(&str, Colour); 3] = [("holds", "#138a5e"), ("fails", "#d1580b"), ("open", "#6b6b6b")];

/// One panel for each member, with its boxes.
pub fn picture(table: &Table) -> Result<Picture, String> {
    if table.rows.is_empty() || table.rows.len() > MOST_PANELS {
        let count = table.rows.len();
        return Err(format!(
            "a picture has from 1 to {MOST_PANELS} members, a panel each, and this family has {count}"
        ));
    }
    let columns = if table.rows.len() == 1 { 1 } else { 2 };
    let title = format!("{}: where the property holds, fails and is open", table.id);
    let picture = Picture::new(title).grid(columns, (460.0, 340.0));
    table.rows.iter().try_fold(picture, |picture, row| Ok(picture.panel(panel(table, row)?)))
}

/// The names that stand for intervals.
fn sides(row: &TableRow) -> Vec<&String> {
    let first = row.regions.as_array().and_then(|regions| regions.first());
    first.and_then(|region| region["box"].as_object()).map_or(Vec::new(), |sides| sides.keys().collect())
}

fn panel(table: &Table, row: &TableRow) -> Result<Panel, String> {
    let mut sides = sides(row);
    sides.sort_by_key(|side| table.names.iter().position(|name| name == *side));
    let [x, others @ ..] = &sides[..] else {
        return Err("the store has no regions: `sweep --plot` makes them".to_string());
    };
    let single = table.names.iter().zip(&row.names).filter(|(name, _)| !sides.contains(name));
    let title: Vec<String> = single.map(|(name, value)| format!("{name} = {value}")).collect();
    let y = others.first().map_or_else(|| Axis::linear("").between(0.0, 1.0), |y| Axis::linear(y.as_str()));
    let mut panel = Panel::new(title.join(", "), Axis::linear(x.as_str()), y);
    for (kind, colour) in KINDS {
        let boxes = row.regions.as_array().into_iter().flatten().filter(|region| region["property"] == kind);
        for (k, region) in boxes.enumerate() {
            let (a, b) = ends(region, x)?;
            let (c, d) = others.first().map_or(Ok((0.0, 1.0)), |y| ends(region, y))?;
            // One line in the legend for all of a kind.
            let name = if k == 0 { kind } else { "" };
            panel = panel.series(Series::area(name, [(a, c), (b, c), (b, d), (a, d)]).colour(colour));
        }
    }
    Ok(panel)
}

fn ends(region: &Value, name: &str) -> Result<(f64, f64), String> {
    let end = |k: usize| {
        let number = region["box"][name][k].as_str().and_then(|text| parse_rational(text).ok());
        number.and_then(|q| q.to_f64()).ok_or_else(|| format!("a region without numbers for `{name}`"))
    };
    Ok((end(0)?, end(1)?))
}
