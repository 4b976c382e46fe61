//! Figure 1 of Veerman, Stosic and Olvera: the response of the last car over the frequency.

use super::veerman::{UNIT, certified, steps};
use super::{Reproduced, csv};
use crate::plot::{Axis, Panel, Picture, Series};
use ledger::CheckError;
use models::platoon::inverse_square_two_sided;

pub(super) fn reproduce() -> Result<Reproduced, CheckError> {
    let mut picture =
        Picture::new("Figure 1: the response of the last of N followers, f = g = −1").grid(2, (520.0, 400.0));
    let mut rows = Vec::new();
    let mut text = String::from("ln |a_N| over the frequency of the leader, f = g = -1 (as printed).\n\n");
    for (followers, end) in [(100u64, 0.15), (1000, 0.015)] {
        let response =
            |w: f64| -> Result<f64, CheckError> { Ok(-0.5 * inverse_square_two_sided(&UNIT, &w, followers)?.ln()) };
        let (w, amplitude) = certified(followers)?;
        // The main peak is much narrower than a step of the even grid.
        let near = steps(-1.0, 1.0, 400).map(|u| w * (1.0 + 0.2 * u.powi(5)));
        let mut frequencies: Vec<f64> = steps(end / 3000.0, end, 2999).chain(near).collect();
        frequencies.sort_by(f64::total_cmp);
        let points = frequencies.into_iter().map(|w| Ok((w, response(w)?))).collect::<Result<Vec<_>, CheckError>>()?;
        text.push_str(&format!("  N = {followers:4}: certified peak at w = {w:.8}, |a_N| = {amplitude:.4}\n"));
        rows.extend(points.iter().map(|(w, a)| [followers.to_string(), format!("{w:.10}"), format!("{a:.8}")]));
        let panel = Panel::new(
            format!("N = {followers}"),
            Axis::linear("ω (rad per unit of time)").between(0.0, end),
            Axis::linear("ln |a_N|"),
        )
        .series(Series::line("response", points))
        .series(Series::crosses("certified peak", [(w, amplitude.ln())]));
        picture = picture.panel(panel);
    }
    text.push_str("The paper reads \"about w = 0.011\" for 100 and a tenth of it for 1000.\n");
    Ok(Reproduced::new(text).table("", csv("N,omega,ln_amplitude", rows)).picture("", picture))
}
