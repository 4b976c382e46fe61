// Draws the motions of a page: play, step, drag.
(function () {
  "use strict";
  const SECONDS = 20;

  function player(place) {
    const run = JSON.parse(place.querySelector("script[type='application/json']").textContent);
    const canvas = place.querySelector("canvas"), pen = canvas.getContext("2d");
    const play = place.querySelector(".play"), slider = place.querySelector(".time"), said = place.querySelector("output");
    const last = run.times.length - 1, agents = run.points[0].length / 2;
    let now = 0, playing = false, begun = 0;

    // Places as they are seen: from the middle of the agents where the run asks for it.
    const frames = run.points.map(function (list) {
      let mx = 0, my = 0;
      if (run.follow) for (let i = 0; i < agents; i++) { mx += list[2 * i] / agents; my += list[2 * i + 1] / agents; }
      return list.map(function (z, k) { return z - (k % 2 ? my : mx); });
    });
    let x0 = Infinity, x1 = -Infinity, y0 = Infinity, y1 = -Infinity;
    frames.forEach(function (list) {
      for (let i = 0; i < agents; i++) {
        x0 = Math.min(x0, list[2 * i]); x1 = Math.max(x1, list[2 * i]);
        y0 = Math.min(y0, list[2 * i + 1]); y1 = Math.max(y1, list[2 * i + 1]);
      }
    });
    const padX = 0.08 * (x1 - x0) || 1, padY = 0.12 * (y1 - y0) || 1;
    x0 -= padX; x1 += padX; y0 -= padY; y1 += padY;

    let scale, width, height;
    function size() {
      scale = window.devicePixelRatio || 1;
      width = canvas.clientWidth; height = Math.round(width * 0.5625);
      canvas.width = width * scale; canvas.height = height * scale;
    }

    function colours() {
      const style = getComputedStyle(document.documentElement);
      const of = function (name) { return style.getPropertyValue(name).trim(); };
      return { ink: of("--ink"), soft: of("--soft"), line: of("--line"), link: of("--link"), bad: of("--bad") };
    }

    function draw() {
      const c = colours(), margin = 34;
      let sx = (width - 2 * margin) / (x1 - x0), sy = (height - 2 * margin) / (y1 - y0);
      if (run.equal) sx = sy = Math.min(sx, sy);
      const at = function (x, y) {
        return [width / 2 + (x - (x0 + x1) / 2) * sx, height / 2 - (y - (y0 + y1) / 2) * sy];
      };
      pen.setTransform(scale, 0, 0, scale, 0, 0);
      pen.clearRect(0, 0, width, height);
      axes(c, at, margin);
      const list = frames[now];
      pen.lineWidth = 1; pen.strokeStyle = c.soft; pen.globalAlpha = 0.45;
      for (let i = 0; run.trail && i < agents; i++) {
        pen.beginPath();
        for (let k = Math.max(0, now - run.trail); k <= now; k++) {
          const p = at(frames[k][2 * i], frames[k][2 * i + 1]);
          if (k === Math.max(0, now - run.trail)) pen.moveTo(p[0], p[1]); else pen.lineTo(p[0], p[1]);
        }
        pen.stroke();
      }
      pen.globalAlpha = 1; pen.strokeStyle = c.link; pen.lineWidth = 2;
      run.kinds[run.links[now]].forEach(function (pair) {
        const a = at(list[2 * pair[0]], list[2 * pair[0] + 1]), b = at(list[2 * pair[1]], list[2 * pair[1] + 1]);
        pen.beginPath(); pen.moveTo(a[0], a[1]); pen.lineTo(b[0], b[1]); pen.stroke();
      });
      const towards = run.directions[now];
      for (let i = 0; i < agents; i++) {
        const p = at(list[2 * i], list[2 * i + 1]);
        pen.fillStyle = c.bad; pen.strokeStyle = c.ink; pen.lineWidth = 1.5;
        if (towards) {
          const length = Math.hypot(towards[2 * i], towards[2 * i + 1]);
          if (length > 1e-9) {
            const ux = towards[2 * i] / length, uy = -towards[2 * i + 1] / length;
            pen.beginPath(); pen.moveTo(p[0], p[1]); pen.lineTo(p[0] + 15 * ux, p[1] + 15 * uy); pen.stroke();
          }
        }
        pen.beginPath(); pen.arc(p[0], p[1], 5, 0, 2 * Math.PI); pen.fill();
      }
    }

    function ticks(low, high, count) {
      const raw = (high - low) / count, decade = Math.pow(10, Math.floor(Math.log10(raw)));
      const step = [1, 2, 5, 10].map(function (m) { return m * decade; }).find(function (s) { return s >= raw; });
      const out = [];
      for (let k = Math.ceil(low / step); k * step <= high; k++) out.push(+(k * step).toPrecision(6));
      return out;
    }

    function axes(c, at, margin) {
      pen.strokeStyle = c.line; pen.fillStyle = c.soft; pen.lineWidth = 1; pen.font = "12px system-ui, sans-serif";
      pen.textAlign = "center"; pen.textBaseline = "top";
      const left = at(x0, 0)[0], right = at(x1, 0)[0];
      ticks(x0, x1, width > 500 ? 8 : 4).forEach(function (x) {
        const p = at(x, y0)[0];
        pen.beginPath(); pen.moveTo(p, margin - 14); pen.lineTo(p, height - margin + 4); pen.stroke();
        pen.fillText(String(x), p, height - margin + 7);
      });
      pen.textAlign = "right"; pen.textBaseline = "middle";
      if (run.labels[1]) ticks(y0, y1, 5).forEach(function (y) {
        const p = at(x0, y)[1];
        if (p < 12 || p > height - margin) return;
        pen.beginPath(); pen.moveTo(Math.max(left, margin), p); pen.lineTo(Math.min(right, width - 8), p); pen.stroke();
        pen.fillText(String(y), Math.max(left, margin) - 4, p);
      });
      pen.textAlign = "right"; pen.textBaseline = "bottom";
      pen.fillText(run.labels[0], width - 6, height - 4);
      pen.textAlign = "left"; pen.textBaseline = "top";
      pen.fillText(run.labels[1], 6, 4);
    }

    function show(k) {
      now = Math.max(0, Math.min(last, k));
      slider.value = now;
      const text = run.said.length ? run.said[now] : "t = " + run.times[now];
      said.textContent = text;
      slider.setAttribute("aria-valuetext", text);
      draw();
    }

    function tick(time) {
      if (!playing) return;
      const k = Math.floor((time - begun) / 1000 / SECONDS * last);
      if (k >= last) { show(last); stop(); return; }
      if (k !== now) show(k);
      requestAnimationFrame(tick);
    }
    function start() {
      if (now >= last) now = 0;
      playing = true; play.textContent = "Pause";
      begun = performance.now() - now / last * SECONDS * 1000;
      requestAnimationFrame(tick);
    }
    function stop() { playing = false; play.textContent = "Play"; }

    play.addEventListener("click", function () { if (playing) stop(); else start(); });
    place.querySelector(".back").addEventListener("click", function () { stop(); show(now - 1); });
    place.querySelector(".on").addEventListener("click", function () { stop(); show(now + 1); });
    slider.addEventListener("input", function () { stop(); show(Number(slider.value)); });
    window.addEventListener("resize", function () { size(); draw(); });
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
    place.querySelector(".controls").hidden = false;
    size(); show(0);
  }

  // For motions that come later.
  window.flockproofPlayer = player;
  document.querySelectorAll("section.live").forEach(player);
})();
