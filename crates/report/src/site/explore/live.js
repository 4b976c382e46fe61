// Asks the program that serves the page, shows how far it is and its answer; an answer that is not wanted any more is stopped.
(function () {
  "use strict";
  const form = document.getElementById("ask");
  if (!form || !location.protocol.startsWith("http")) return;
  const of = function (id) { return document.getElementById(id); };
  const state = of("state"), answer = of("answer"), work = of("work"), bar = of("bar"), stage = of("stage"), json = of("document");
  const fields = form.elements;
  let asked = null;
  of("away").hidden = true;
  form.hidden = false;

  function question() {
    // A flock is its own JSON.
    if (form.dataset.ask === "flock") return fields.flock.value;
    const all = {};
    Array.from(fields).forEach(function (e) { if (e.name) all[e.name] = e.tagName === "TEXTAREA" ? e.value : e.value.trim(); });
    return JSON.stringify(all);
  }

  /** What became of it; `wrong` where there is something to mend. */
  function say(what, wrong) {
    state.textContent = what;
    state.classList.toggle("wrong", Boolean(wrong));
  }

  function tell(progress) {
    stage.textContent = progress.stage + (progress.total ? ", " + progress.done + " of " + progress.total : progress.done ? ", " + progress.done : "");
    if (progress.total) { bar.max = progress.total; bar.value = progress.done; } else bar.removeAttribute("value");
  }

  function show(said) {
    if (said.progress) tell(said.progress);
    if (said.refused) say(said.refused, true);
    if (!said.answer) return;
    answer.innerHTML = said.shown;
    answer.querySelectorAll("section.live").forEach(window.flockproofPlayer);
    json.querySelector("code").textContent = JSON.stringify(said.answer, null, 2);
    json.hidden = false;
    say("answered");
  }

  /** The lines of a reply as they come. */
  async function read(reply) {
    const reader = reply.body.getReader(), decoder = new TextDecoder();
    let rest = "";
    for (;;) {
      const part = await reader.read();
      if (part.done) break;
      rest += decoder.decode(part.value, { stream: true });
      const lines = rest.split("\n");
      rest = lines.pop();
      lines.filter(Boolean).forEach(function (line) { show(JSON.parse(line)); });
    }
  }

  function busy(is) { of("stop").disabled = !is; work.hidden = !is; if (is) tell({ stage: "begun" }); }

  form.addEventListener("submit", async function (event) {
    event.preventDefault();
    if (asked) asked.abort();
    const own = asked = new AbortController();
    say("asking");
    answer.replaceChildren();
    json.hidden = true;
    busy(true);
    try {
      const reply = await fetch("/api/" + form.dataset.ask, {
        method: "POST", headers: { "Content-Type": "application/json" }, body: question(), signal: own.signal
      });
      if (reply.ok) await read(reply); else say((await reply.text()).trim(), true);
      if (state.textContent === "asking") say("the answer broke off", true);
    } catch (error) {
      if (own === asked) { if (error.name === "AbortError") say("stopped"); else say("no answer: " + error.message, true); }
    }
    if (own === asked) busy(false);
  });
  of("stop").addEventListener("click", function () { if (asked) asked.abort(); });

  const example = of("example");
  if (example) example.addEventListener("change", function () {
    document.querySelectorAll("template[data-example]").forEach(function (template) {
      if (template.dataset.example !== example.value) return;
      template.content.querySelectorAll("textarea").forEach(function (e) { fields[e.dataset.name].value = e.value; });
    });
  });
  const file = of("file");
  if (file) file.addEventListener("change", async function () {
    if (!file.files.length) return;
    if (file.files[0].size > 4 << 20) { say("the file is longer than 4 MiB", true); return; }
    fields.certificate.value = await file.files[0].text();
    say(file.files[0].name + " was read");
  });

  const canvas = of("drawing");
  if (!canvas) return;
  const pen = canvas.getContext("2d"), text = fields[canvas.dataset.field];
  const place = function (event) {
    const box = canvas.getBoundingClientRect(), s = canvas.width / box.width;
    return [(event.clientX - box.left) * s, (event.clientY - box.top) * s];
  };
  const colour = function (name) { return getComputedStyle(document.documentElement).getPropertyValue(name); };
  function line(a, b) { pen.beginPath(); pen.moveTo(a[0], a[1]); pen.lineTo(b[0], b[1]); pen.stroke(); }
  function disc(at, radius) { pen.beginPath(); pen.arc(at[0], at[1], radius, 0, 2 * Math.PI); pen.fill(); }

  function flock() {
    const unit = 64, fine = 16, middle = [canvas.width / 2, canvas.height / 2];
    const parsed = function () {
      try {
        const birds = JSON.parse(text.value);
        return birds && Array.isArray(birds.positions) && Array.isArray(birds.velocities) ? birds : null;
      } catch (error) { return null; }
    };
    const number = function (q) { const p = String(q).split("/"); return Number(p[0]) / Number(p[1] || 1); };
    // Places are multiples of 1/16, so that the flock is exact.
    const exact = function (x) { const k = Math.round(x * fine); return k % fine === 0 ? String(k / fine) : k + "/" + fine; };
    return {
      draw: function () {
        const birds = parsed();
        if (!birds) return;
        birds.positions.forEach(function (row, k) {
          const r = row || [], v = birds.velocities[k] || [];
          const at = [middle[0] + unit * number(r[0]), middle[1] - unit * number(r[1] || 0)];
          pen.strokeStyle = colour("--soft"); pen.fillStyle = colour("--bad"); pen.lineWidth = 2;
          line(at, [at[0] + 4 * unit * number(v[0] || 0), at[1] - 4 * unit * number(v[1] || 0)]);
          disc(at, 5);
        });
      },
      add: function (from, to) {
        const birds = parsed();
        if (!birds) { say("what is written below is no flock; Empty begins a new one", true); return; }
        birds.positions.push([exact((from[0] - middle[0]) / unit), exact((middle[1] - from[1]) / unit)]);
        birds.velocities.push([exact((to[0] - from[0]) / unit / 4), exact((from[1] - to[1]) / unit / 4)]);
        text.value = JSON.stringify(birds);
      },
      clear: function () { text.value = JSON.stringify({ model: "D", dimension: 2, weights: "lazy", hysteresis: "paper", positions: [], velocities: [] }); }
    };
  }

  function graph() {
    const near = 18;
    let places = [];
    const parsed = function () {
      const lines = text.value.split("\n").map(function (l) { return l.replace(/#.*/, "").trim(); }).filter(Boolean);
      const head = lines.find(function (l) { return /^vertices\s/.test(l); });
      const edges = lines.filter(function (l) { return /^\d+\s+\d+/.test(l); }).map(function (l) { return l.split(/\s+/).slice(0, 2).map(Number); });
      const largest = edges.reduce(function (m, e) { return Math.max(m, e[0], e[1]); }, 0);
      return { order: Math.min(200, Math.max(head ? Number(head.split(/\s+/)[1]) || 0 : 0, largest)), edges: edges };
    };
    const at = function (k, order) {
      const angle = 2 * Math.PI * (k / order - 0.25);
      return places[k] || [canvas.width / 2 + 140 * Math.cos(angle), canvas.height / 2 + 140 * Math.sin(angle)];
    };
    const found = function (where) {
      const order = parsed().order;
      for (let k = 0; k < order; k++) { const p = at(k, order); if (Math.hypot(p[0] - where[0], p[1] - where[1]) < near) return k; }
      return -1;
    };
    const write = function (g) {
      text.value = "vertices " + g.order + "\n" + g.edges.map(function (e) { return e[0] + " " + e[1] + "\n"; }).join("");
      fields.graph.value = "";
    };
    return {
      draw: function () {
        const g = parsed();
        // A graph that has a name is asked for by its name, not as it is drawn.
        canvas.classList.toggle("unused", fields.graph.value.trim() !== "");
        pen.strokeStyle = colour("--link"); pen.lineWidth = 2; pen.textAlign = "center"; pen.textBaseline = "middle"; pen.font = "12px system-ui, sans-serif";
        g.edges.forEach(function (e) { line(at(e[0] - 1, g.order), at(e[1] - 1, g.order)); });
        for (let k = 0; k < g.order; k++) {
          pen.fillStyle = colour("--ink"); disc(at(k, g.order), 10);
          pen.fillStyle = colour("--paper"); pen.fillText(String(k + 1), at(k, g.order)[0], at(k, g.order)[1]);
        }
      },
      add: function (from, to) {
        const g = parsed(), i = found(from), j = found(to);
        // Where vertices stood before stays.
        for (let k = 0; k < g.order; k++) places[k] = at(k, g.order);
        if (i < 0) { places[g.order] = from; g.order += 1; } else if (j >= 0 && i !== j) {
          const same = function (e) { return Math.min(e[0], e[1]) === Math.min(i, j) + 1 && Math.max(e[0], e[1]) === Math.max(i, j) + 1; };
          if (g.edges.some(same)) g.edges = g.edges.filter(function (e) { return !same(e); }); else g.edges.push([i + 1, j + 1]);
        }
        write(g);
      },
      clear: function () { places = []; write({ order: 0, edges: [] }); }
    };
  }

  const drawing = canvas.dataset.draws === "graph" ? graph() : flock();
  let from = null;
  function draw() { pen.clearRect(0, 0, canvas.width, canvas.height); drawing.draw(); }
  canvas.addEventListener("pointerdown", function (event) { from = place(event); canvas.setPointerCapture(event.pointerId); });
  canvas.addEventListener("pointerup", function (event) {
    if (!from) return;
    drawing.add(from, place(event));
    from = null;
    draw();
  });
  of("clear").addEventListener("click", function () { drawing.clear(); draw(); });
  form.addEventListener("input", draw);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
  draw();
})();
