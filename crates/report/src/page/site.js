// Filters of the list of claims. The page is readable without this.
(function () {
  "use strict";
  const form = document.getElementById("filters");
  if (!form) return;
  const rows = Array.from(document.querySelectorAll("#claims tbody tr"), function (row) {
    return { row: row, text: (row.textContent + " " + row.dataset.words).toLowerCase(), data: row.dataset };
  });
  const count = document.getElementById("count"), nothing = document.getElementById("nothing");
  const names = ["words", "paper", "verdict", "fault", "grade", "scope"];

  function apply() {
    const wanted = {};
    names.forEach(function (name) { wanted[name] = form.elements[name].value.trim().toLowerCase(); });
    const words = wanted.words.split(/\s+/).filter(Boolean);
    let shown = 0;
    rows.forEach(function (r) {
      const fits = words.every(function (word) { return r.text.includes(word); }) && names.slice(1).every(function (name) {
        const value = wanted[name];
        return !value || (name === "grade" ? r.data.grade.split(" ").includes(value) : r.data[name] === value);
      });
      r.row.hidden = !fits;
      shown += fits;
    });
    count.textContent = shown === rows.length ? shown + " claims" : shown + " of " + rows.length + " claims";
    nothing.hidden = shown > 0;
    return wanted;
  }

  function remember() {
    const wanted = apply();
    const parts = names.filter(function (name) { return wanted[name]; })
      .map(function (name) { return name + "=" + encodeURIComponent(wanted[name]); });
    history.replaceState(null, "", parts.length ? "#" + parts.join("&") : "#");
  }

  function fromAddress() {
    const asked = new URLSearchParams(location.hash.slice(1));
    // An address without filters names a place on the page.
    if (location.hash.length > 1 && !location.hash.includes("=")) return;
    names.forEach(function (name) { form.elements[name].value = asked.get(name) || ""; });
    apply();
    if (location.hash.includes("=")) form.scrollIntoView();
  }

  form.hidden = false;
  form.addEventListener("input", remember);
  form.addEventListener("submit", function (event) { event.preventDefault(); });
  // At once, not after the fields have been emptied.
  form.addEventListener("reset", function (event) {
    event.preventDefault();
    names.forEach(function (name) { form.elements[name].value = ""; });
    remember();
  });
  document.getElementById("reset-below").addEventListener("click", function () { form.reset(); form.elements.words.focus(); });
  window.addEventListener("hashchange", fromAddress);
  document.addEventListener("keydown", function (event) {
    const typing = /^(INPUT|SELECT|TEXTAREA)$/.test(document.activeElement.tagName);
    if (event.key === "/" && !typing && !event.ctrlKey && !event.metaKey && !event.altKey) {
      event.preventDefault();
      form.elements.words.focus();
      form.elements.words.select();
    } else if (event.key === "Escape" && document.activeElement === form.elements.words) {
      form.elements.words.value = "";
      remember();
    }
  });
  fromAddress();
})();
