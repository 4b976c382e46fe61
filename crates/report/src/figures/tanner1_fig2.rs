//! Figure 2 of Tanner, Jadbabaie and Pappas, part I: the potential of two agents.

use super::{Reproduced, csv};
use crate::plot::{Axis, Panel, Picture, Series};
use arithmetic::rational;
use ledger::CheckError;
use models::double_integrator::Potential;

pub(super) fn reproduce() -> Result<Reproduced, CheckError> {
    let printed = Potential::inverse_square_log(&rational(1, 1));
    let spring = Potential::inverse_square_spring(&rational(1, 1), &rational(1, 1));
    let points: Vec<f64> = (1..=208).map(|k| 0.2436 + 0.0133 * f64::from(k)).collect();
    let values = |potential: &Potential| {
        points.iter().map(|r| Ok((*r, potential.value(&(r * r))?))).collect::<Result<Vec<_>, CheckError>>()
    };
    // The force along the line through both, minus dV/dr = -2 r V'(s).
    let force = points.iter().map(|r| Ok((*r, -2.0 * r * printed.slope(&(r * r))?)));
    let force = force.collect::<Result<Vec<_>, CheckError>>()?;
    let (logarithm, spring) = (values(&printed)?, values(&spring)?);
    let strongest = force.iter().map(|(r, f)| (*r, -f)).max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or_default();
    let text = format!(
        "The printed choice V = 1/r² + log r² and the force on an agent, which the paper\n\
         does not draw. Beside it V = r² + 1/r² - 2, which other figures use.\n\n\
         \x20 minimum at r = 1, V = 1; V = 2 at r = 0.564 and 2.511\n\
         \x20 strongest attraction: {:.4} at r = {:.3} (exactly 4/(3 sqrt 3) = 0.7698\n\
         \x20 at sqrt 3); it falls like 2/r, so that V has no bound but grows slowly:\n\
         \x20 V = 10 at r = 148, V = 20 at r = 22026\n",
        strongest.1, strongest.0
    );
    let rows =
        logarithm.iter().zip(&force).zip(&spring).map(|(((r, v), (_, f)), (_, w))| {
            [format!("{r:.4}"), format!("{v:.8}"), format!("{f:.8}"), format!("{w:.8}")]
        });
    let csv = csv("distance,potential,force,spring_potential", rows);
    let distance = || Axis::linear("distance r (m)").between(0.0, 3.0);
    let picture = Picture::new("Figure 2: the potential of two agents")
        .grid(2, (480.0, 360.0))
        .panel(
            Panel::new("a) potential", distance(), Axis::linear("V").between(0.0, 8.0))
                .series(Series::line("1/r² + log r² (printed)", logarithm))
                .series(Series::dashed("r² + 1/r² − 2", spring)),
        )
        .panel(
            Panel::new("b) force (positive: apart)", distance(), Axis::linear("−dV/dr").between(-1.5, 6.0))
                .series(Series::line("of the printed potential", force))
                .series(Series::line("", [(0.0, 0.0), (3.0, 0.0)]).colour("#555555").size(1.0)),
        );
    Ok(Reproduced::new(text).table("", csv).picture("", picture))
}
