//! A run as one HTML file that plays it: no other file, no request.

use scenario::{Outcome, Row};
use std::fmt::Write;

/// Most pictures of an animation, and most agents in one.
const MOST_PICTURES: usize = 300;
const MOST_AGENTS: usize = 2000;

/// A page with a slider over the rows of the trajectory; nothing for models without positions.
pub fn animation(outcome: &Outcome) -> Option<String> {
    let agents = outcome.rows.first().map_or(0, |row| row.frame.positions.len());
    if agents == 0 {
        return None;
    }
    let every = outcome.rows.len().div_ceil(MOST_PICTURES).max(1);
    let rows: Vec<&Row> = outcome.rows.iter().step_by(every).collect();
    let (shown, step) = (agents.min(MOST_AGENTS), agents.div_ceil(MOST_AGENTS));
    let mut frames = String::new();
    for row in &rows {
        let places = row.frame.positions.iter().step_by(step).map(|r| {
            // On a line the second coordinate is zero.
            let y = r.get(1).copied().unwrap_or(0.0);
            format!("[{},{}]", number(r[0]), number(y))
        });
        let places: Vec<String> = places.collect();
        // Writing to a string cannot fail.
        let _ = writeln!(frames, "[{},[{}]],", number(row.time), places.join(","));
    }
    let title = format!("{}, {agents} agents, {} of them shown", outcome.model, agents.div_ceil(step).min(shown));
    Some(PAGE.replace("@title@", &title).replace("@frames@", &frames))
}

/// Five digits are more than a screen shows; what is not finite is not drawn.
fn number(x: f64) -> String {
    if x.is_finite() { format!("{x:.5e}") } else { "null".to_string() }
}

const PAGE: &str = r##"<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>@title@</title>
<style>body{font-family:sans-serif;margin:1em}canvas{border:1px solid #999;max-width:100%}input{width:30em;max-width:70%}</style></head>
<body><p>@title@</p><canvas id="c" width="760" height="620"></canvas>
<p><button id="p">pause</button> <input id="s" type="range" min="0" value="0"> t = <span id="t"></span></p>
<script>
"use strict";
const frames = [
@frames@];
const canvas = document.getElementById("c"), pen = canvas.getContext("2d"), slider = document.getElementById("s");
let low = [Infinity, Infinity], high = [-Infinity, -Infinity];
for (const [, places] of frames) for (const place of places) for (const k of [0, 1]) if (place[k] !== null) {
  low[k] = Math.min(low[k], place[k]); high[k] = Math.max(high[k], place[k]);
}
const margin = 20, span = Math.max((high[0] - low[0]) / (canvas.width - 2 * margin), (high[1] - low[1]) / (canvas.height - 2 * margin), 1e-300);
const middle = [0, 1].map(k => (low[k] + high[k]) / 2);
let at = 0, playing = true;
slider.max = frames.length - 1;
function draw() {
  const [time, places] = frames[at];
  pen.clearRect(0, 0, canvas.width, canvas.height);
  pen.fillStyle = "#1f6fb4";
  for (const [x, y] of places) {
    if (x === null || y === null) continue;
    pen.beginPath();
    pen.arc(canvas.width / 2 + (x - middle[0]) / span, canvas.height / 2 - (y - middle[1]) / span, 2.5, 0, 7);
    pen.fill();
  }
  document.getElementById("t").textContent = time;
  slider.value = at;
}
slider.oninput = () => { at = Number(slider.value); playing = false; draw(); };
document.getElementById("p").onclick = () => { playing = !playing; };
setInterval(() => { if (playing) { at = (at + 1) % frames.length; draw(); } }, 50);
draw();
</script></body></html>
"##;
