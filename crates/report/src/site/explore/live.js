// Asks the program that serves the page, and shows its answer.
(function () {
  "use strict";
  const form = document.getElementById("ask"), state = document.getElementById("state"), table = document.getElementById("answer");
  if (!form || !location.protocol.startsWith("http")) return;
  document.getElementById("away").hidden = true;
  form.hidden = false;
  let asked = null;

  function rows(list) {
    table.replaceChildren();
    list.forEach(function (cells, k) {
      const row = table.insertRow();
      cells.forEach(function (cell) {
        const place = document.createElement(k === 0 ? "th" : "td");
        if (k === 0) place.scope = "col";
        place.textContent = cell;
        row.append(place);
      });
    });
  }
  function value(x) {
    if (x === null || x === undefined) return "";
    if (Array.isArray(x)) return x.map(value).join(" ");
    if (typeof x === "object") return "lo" in x ? "[" + x.lo + ", " + x.hi + "]" : JSON.stringify(x);
    return String(x);
  }
  const shown = {
    resonance: function (a) {
      const of = a.theorem1 || {};
      return [["", "certified", "Theorem 1"], ["frequency", value(a.omega), value(of.omega)], ["amplitude", value(a.amplitude), value(of.amplitude)]];
    },
    spectrum: function (a) {
      const list = a.eigenvalues || a.values || [];
      return [["eigenvalue", "multiplicity"]].concat(list.map(function (e) {
        return [value(e.value || e.re || { lo: e.lo, hi: e.hi }) + (e.im ? " + i " + value(e.im) : ""), value(e.multiplicity)];
      }));
    },
    flock: function (a) {
      const edges = function (list) { return (list || []).map(function (e) { return e.join("-"); }).join(" "); };
      return [["t", "links that come", "links that go"]].concat((a.switches || []).map(function (s) { return [s.t, edges(s.gained), edges(s.lost)]; }),
        [["steady from", value(a.steady_from), value(a.why)], ["flocks", value((a.flocks || []).map(function (f) { return "{" + f.join(",") + "}"; })), ""]]);
    }
  };

  form.addEventListener("submit", async function (event) {
    event.preventDefault();
    if (asked) asked.abort();
    asked = new AbortController();
    const what = form.dataset.ask, fields = {};
    Array.from(form.elements).forEach(function (e) { if (e.name) fields[e.name] = e.value.trim(); });
    state.textContent = "asking";
    table.replaceChildren();
    try {
      const body = what === "flock" ? fields.flock : JSON.stringify(fields);
      const reply = await fetch("/api/" + what, { method: "POST", headers: { "Content-Type": "application/json" }, body: body, signal: asked.signal });
      if (!reply.ok) { state.textContent = (await reply.text()).trim(); return; }
      rows(shown[what](await reply.json()));
      state.textContent = "answered";
    } catch (error) {
      if (error.name !== "AbortError") state.textContent = "no answer: " + error.message;
    }
  });

  const canvas = document.getElementById("birds");
  if (!canvas) return;
  const pen = canvas.getContext("2d"), text = form.elements.flock, unit = 64, fine = 16;
  let from = null;
  const read = function () { try { return JSON.parse(text.value); } catch (error) { return null; } };
  const number = function (q) { const p = String(q).split("/"); return Number(p[0]) / Number(p[1] || 1); };
  // Places are multiples of 1/16, so that the flock is exact.
  const exact = function (x) { const k = Math.round(x * fine); return k % fine === 0 ? String(k / fine) : k + "/" + fine; };
  const place = function (event) {
    const box = canvas.getBoundingClientRect(), s = canvas.width / box.width;
    return [((event.clientX - box.left) * s - canvas.width / 2) / unit, (canvas.height / 2 - (event.clientY - box.top) * s) / unit];
  };
  function draw() {
    const flock = read(), style = getComputedStyle(document.documentElement);
    pen.clearRect(0, 0, canvas.width, canvas.height);
    if (!flock || !Array.isArray(flock.positions)) return;
    flock.positions.forEach(function (r, k) {
      const v = (flock.velocities || [])[k] || [];
      const x = canvas.width / 2 + unit * number(r[0]), y = canvas.height / 2 - unit * number(r[1] || 0);
      pen.strokeStyle = style.getPropertyValue("--soft"); pen.fillStyle = style.getPropertyValue("--bad"); pen.lineWidth = 2;
      pen.beginPath(); pen.moveTo(x, y); pen.lineTo(x + 4 * unit * number(v[0] || 0), y - 4 * unit * number(v[1] || 0)); pen.stroke();
      pen.beginPath(); pen.arc(x, y, 5, 0, 2 * Math.PI); pen.fill();
    });
  }
  function write(flock) { text.value = JSON.stringify(flock); draw(); }
  canvas.addEventListener("pointerdown", function (event) { from = place(event); canvas.setPointerCapture(event.pointerId); });
  canvas.addEventListener("pointerup", function (event) {
    const flock = read(), to = place(event);
    if (!from || !flock) return;
    flock.positions.push([exact(from[0]), exact(from[1])]);
    flock.velocities.push([exact((to[0] - from[0]) / 4), exact((to[1] - from[1]) / 4)]);
    from = null;
    write(flock);
  });
  document.getElementById("clear").addEventListener("click", function () {
    write({ model: "D", dimension: 2, weights: "lazy", hysteresis: "paper", positions: [], velocities: [] });
  });
  text.addEventListener("input", draw);
  draw();
})();
