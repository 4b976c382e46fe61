// The pages of `flockproof report --out DIR` in Chromium: node check.mjs DIR [FOLDER FOR SCREENSHOTS]
//
// Asked of every page: no message of an error on the console, no request but for files of the site, every link and anchor
// leads somewhere, most counterexamples are drawn, and at 320 pixels nothing is wider than the window and no table has to be scrolled. Of one page of each kind, light and dark: axe finds
// nothing. Of the list of claims: filters, search and keyboard. Of the motions: they run.
//
// With FLOCKPROOF=path of the program, the live pages too, under `flockproof serve`: they give what the command line prints, by keyboard
// alone; progress is shown, and work can be stopped.
import { chromium } from "playwright-core";
import fs from "node:fs";
import path from "node:path";
import { execFile, spawn } from "node:child_process";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

const site = path.resolve(process.argv[2] ?? "target/site");
const shots = process.argv[3] && path.resolve(process.argv[3]);
const axe = fs.readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const failures = [];
const expect = (is, what) => { if (!is) { failures.push(what); console.error("FAILED  " + what); } };
const address = (page) => pathToFileURL(path.join(site, page)).href;

function pagesIn(folder) {
  return fs.readdirSync(path.join(site, folder), { withFileTypes: true }).flatMap((entry) => {
    const name = path.join(folder, entry.name);
    return entry.isDirectory() ? pagesIn(name) : name.endsWith(".html") ? [name] : [];
  }).sort();
}
const pages = pagesIn("");

// One page of each kind, where there is most on it.
const kinds = ["index.html", "results.html", "guarantees.html", "graph.html", "glossary.html", "papers/index.html", "papers/veerman.html",
  "papers/paley.html", "errata/index.html", "errata/paley.html", "claims/paley.eq21.html", "claims/paley.bal.circ.html", "claims/chazelle.ex15.html",
  "claims/veerman.table1_numeric.html", "claims/tanner2.thm2_stop.html", "claims/beyond.chazelle.tower.html", "notes/settling.html",
  "coq/veerman_theorem1.html", "explore/index.html", "explore/four-birds.html", "explore/patterns.html", "explore/live-flock.html"];

/** Most counterexamples are drawn, by their sentence, a figure or a motion. */
function checkCounterexamples() {
  const texts = pages.filter((page) => page.startsWith("claims/")).map((page) => fs.readFileSync(path.join(site, page), "utf8"));
  const all = texts.filter((text) => text.includes('id="counterexample"'));
  const drawn = all.filter((text) => /class="drawings"|<figure class="shown"|See it move/.test(text));
  expect(2 * drawn.length >= all.length, `only ${drawn.length} of ${all.length} counterexamples are drawn`);
  console.log(`${all.length} counterexamples, ${drawn.length} drawn`);
}

/** Links and anchors, by reading the files. */
function checkLinks() {
  const anchors = new Map(pages.map((page) => {
    const text = fs.readFileSync(path.join(site, page), "utf8");
    return [page, new Set([...text.matchAll(/ id="([^"]+)"/g)].map((m) => m[1]))];
  }));
  let count = 0;
  for (const page of pages) {
    const text = fs.readFileSync(path.join(site, page), "utf8");
    const ids = [...text.matchAll(/ id="([^"]+)"/g)].map((m) => m[1]);
    expect(new Set(ids).size === ids.length, `${page}: an id is there twice: ${ids.find((id, k) => ids.indexOf(id) !== k)}`);
    for (const [, link] of text.matchAll(/ (?:href|src)="([^"]*)"/g)) {
      if (link.startsWith("data:")) continue;
      count += 1;
      expect(!/^(https?:)?\/\//.test(link), `${page}: ${link} leads outside`);
      const [to, anchor] = link.replaceAll("&amp;", "&").split("#");
      const target = to ? path.normalize(path.join(path.dirname(page), to)) : page;
      expect(fs.existsSync(path.join(site, target)), `${page}: ${link} leads nowhere`);
      // Filters of the list stand behind the #, too.
      if (anchor && !anchor.includes("=")) expect(anchors.get(target)?.has(decodeURIComponent(anchor)), `${page}: ${link} has no such place`);
    }
  }
  console.log(`${pages.length} pages, ${count} links`);
}

/** A tab that reports errors and requests of the page that it shows; from the file system, or from a server. */
async function reporter(context, server) {
  const tab = await context.newPage();
  // As a last resort, on machines that do other work too.
  tab.setDefaultTimeout(120000);
  let page = "";
  const own = server ? (url) => url.startsWith(server) || url.startsWith("data:") : (url) => /^(file|data):/.test(url);
  tab.on("console", (message) => expect(message.type() !== "error", `${page}: ${message.text()}`));
  tab.on("pageerror", (error) => expect(false, `${page}: ${error}`));
  tab.on("request", (request) => expect(own(request.url()), `${page}: asks for ${request.url()}`));
  const show = (next) => { page = next; return tab.goto(server ? server + page : address(page)); };
  return { tab, show };
}

async function open(context, page, server) {
  const { tab, show } = await reporter(context, server);
  await show(page);
  return tab;
}

/** Shows the pages one after the other in a few tabs, and does the same with each. A new tab takes longer than a page. */
async function each(context, list, check, server) {
  const left = [...list];
  const work = async () => {
    const { tab, show } = await reporter(context, server);
    for (let page = left.shift(); page !== undefined; page = left.shift()) {
      await show(page);
      await check(tab, page);
    }
    await tab.close();
  };
  await Promise.all([work(), work()]);
}

/** How wide a page is in its window, and what is to blame. */
function width(tab) {
  return tab.evaluate(() => {
    const root = document.documentElement, wide = root.scrollWidth;
    const who = [...document.querySelectorAll("main *")].find((e) => e.getBoundingClientRect().right > innerWidth + 1 && !e.closest(".wide, pre, .picture"));
    return [wide, who ? who.outerHTML.slice(0, 120) : ""];
  });
}

/** How the first table begins that has to be scrolled, in its own box or in one around it. */
function scrolled(tab) {
  return tab.evaluate(() => {
    const scrolls = (e) => e.scrollWidth > e.clientWidth + 1 && /auto|scroll/.test(getComputedStyle(e).overflowX);
    const inside = (e) => e && e !== document.body && (scrolls(e) || inside(e.parentElement));
    const table = [...document.querySelectorAll("main table")].find(inside);
    return table ? table.textContent.slice(0, 60) : "";
  });
}

/**
 * Marks three of the elements with text that look alike: colour, size and weight of the letters, and all that lies behind them; axe leaves single
 * letters to the reader. Contrast depends on nothing else, and to look for what lies behind each of the 20000 signs of the formulas of the list takes
 * axe a minute.
 */
function markLooks() {
  const known = new Map([[null, ""]]), seen = new Map();
  const behind = (e) => {
    if (!known.has(e)) {
      const s = getComputedStyle(e), clear = /^rgba\(.*, 0\)$/.test(s.backgroundColor) && s.backgroundImage === "none";
      const own = [clear ? "" : s.backgroundColor + s.backgroundImage, s.opacity === "1" ? "" : s.opacity, s.position === "static" ? "" : s.position];
      known.set(e, behind(e.parentElement) + own.join(""));
    }
    return known.get(e);
  };
  for (const e of document.body.querySelectorAll("*")) {
    const text = [...e.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.nodeValue.trim() !== "");
    if (!(text || e.matches("input, select, textarea, button")) || !e.checkVisibility()) continue;
    const s = getComputedStyle(e);
    const look = [behind(e), s.color, s.fontSize, s.fontWeight, s.textShadow, s.visibility, e.matches(":disabled"), e.tagName, e.textContent.trim().length > 1].join("|");
    seen.set(look, (seen.get(look) ?? 0) + 1);
    if (seen.get(look) <= 3) e.setAttribute("data-look", "");
  }
}

/** What axe finds. */
async function checkAxe(tab, name) {
  await tab.evaluate(axe);
  await tab.evaluate(markLooks);
  await tab.evaluate(() => window.axe.configure({ rules: [{ id: "color-contrast", selector: "[data-look]" }] }));
  const found = await tab.evaluate(async () => (await window.axe.run({ resultTypes: ["violations"] })).violations);
  for (const violation of found) {
    const node = violation.nodes[0];
    expect(false, `${name}: ${violation.id}, ${violation.nodes.length} times: ${node.html.slice(0, 140)} (${node.any[0]?.message ?? violation.help})`);
  }
}

async function checkNarrow(browser) {
  const context = await browser.newContext({ viewport: { width: 320, height: 640 } });
  await each(context, pages, async (tab, page) => {
    const [wide, who] = await width(tab);
    expect(wide <= 320, `${page}: ${wide} pixels wide in a window of 320: ${who}`);
    const table = await scrolled(tab);
    expect(table === "", `${page}: a table has to be scrolled in a window of 320: ${table}`);
    if (shots && kinds.includes(page)) await tab.screenshot({ path: path.join(shots, page.replaceAll("/", "-") + ".narrow.png") });
  });
  await context.close();
}

async function checkKinds(browser) {
  for (const colorScheme of ["light", "dark"]) {
    const context = await browser.newContext({ viewport: { width: 1200, height: 900 }, colorScheme });
    await each(context, kinds.filter((page) => pages.includes(page)), async (tab, page) => {
      await checkAxe(tab, `${page}, ${colorScheme}`);
      if (shots) await tab.screenshot({ path: path.join(shots, `${page.replaceAll("/", "-")}.${colorScheme}.png`) });
    });
    await context.close();
  }
}

async function checkList(browser) {
  const context = await browser.newContext({ viewport: { width: 1200, height: 900 } });
  const tab = await open(context, "index.html");
  const ledger = JSON.parse(fs.readFileSync(path.join(site, "data/ledger.json"), "utf8")).claims;
  const shown = () => tab.locator("#claims tbody tr:visible").count();
  const said = () => tab.locator("#count").textContent();
  expect(await shown() === ledger.length, "all claims are listed");
  await tab.selectOption("select[name=verdict]", "false");
  expect(await shown() === ledger.filter((c) => c.verdict === "false").length, "the filter of verdicts");
  await tab.selectOption("select[name=paper]", "paley");
  const both = ledger.filter((c) => c.verdict === "false" && c.paper === "paley").length;
  expect(await shown() === both && (await said()).startsWith(`${both} of`), "two filters at once");
  expect((await tab.evaluate(() => location.hash)).includes("paper=paley"), "the address remembers the filters");
  await tab.reload();
  expect(await shown() === both, "filters from the address");
  await tab.click("button[type=reset]");
  expect(await shown() === ledger.length, "show all");
  await tab.selectOption("select[name=grade]", "kernel");
  const kernel = ledger.filter((c) => c.evidence.some((e) => e.grade === "kernel")).length;
  expect(await shown() === kernel, "the filter of grades");
  await tab.click("button[type=reset]");
  await tab.selectOption("select[name=fault]", "typo");
  expect(await shown() === ledger.filter((c) => c.fault === "typo").length, "the filter of faults");
  await tab.click("button[type=reset]");
  // By keyboard alone: to the search, to the first claim, to its page.
  await tab.keyboard.press("/");
  await tab.keyboard.type("resonance K_nothing");
  expect(await shown() === 0 && await tab.locator("#nothing").isVisible(), "no claim is like that");
  await tab.keyboard.press("Escape");
  expect(await shown() === ledger.length, "escape empties the search");
  await tab.keyboard.type("thm1_omega");
  expect(await shown() === 1, "search by id");
  for (let k = 0; k < 9 && !(await tab.evaluate(() => document.activeElement.closest("#claims") !== null)); k++) await tab.keyboard.press("Tab");
  await tab.keyboard.press("Enter");
  await tab.waitForURL(/claims\/veerman\.thm1_omega\.html$/, { timeout: 60000 }).catch(() => expect(false, "the keyboard leads to a claim"));
  await tab.close();
  // Without JavaScript the list is whole.
  const plain = await browser.newContext({ javaScriptEnabled: false });
  const still = await plain.newPage();
  await still.goto(address("index.html"));
  expect(await still.locator("#claims tbody tr:visible").count() === ledger.length, "the list without JavaScript");
  await plain.close();
  await context.close();
}

async function checkMotions(browser) {
  const context = await browser.newContext({ viewport: { width: 900, height: 900 } });
  await each(context, pages.filter((page) => page.startsWith("explore/") && !/index|live-/.test(page)), async (tab, page) => {
    const picture = () => tab.evaluate(() => document.querySelector("canvas").toDataURL());
    const time = () => tab.locator(".live output").first().textContent();
    const first = await picture();
    await tab.locator(".on").first().click();
    const second = await time();
    expect(second !== "t = 0", `${page}: a step on`);
    await tab.locator(".time").first().focus();
    await tab.keyboard.press("End");
    const end = await time();
    expect(end !== second && await picture() !== first, `${page}: to the end by the slider`);
    if (shots) await tab.screenshot({ path: path.join(shots, page.replaceAll("/", "-") + ".end.png") });
    await tab.keyboard.press("Home");
    await tab.locator(".play").first().click();
    await tab.waitForFunction(() => !/^t = 0$/.test(document.querySelector(".live output").textContent), null, { timeout: 60000 })
      .catch(() => expect(false, `${page}: it plays`));
  });
  await context.close();
}

/** What the program prints for these arguments, with this standard input; `check` tells by its status that a statement is false. */
function printed(list, input) {
  return new Promise((resolve, reject) => {
    const program = execFile(process.env.FLOCKPROOF, list, { maxBuffer: 1 << 28 }, (_, text) => { try { resolve(JSON.parse(text)); } catch (error) { reject(error); } });
    // Who reads no input may have ended before it is written.
    program.stdin.on("error", () => {});
    program.stdin.end(input);
  });
}

// For each live page what it asks at first, on the command line; texts are those of its fields.
const asked = {
  "live-resonance": () => [["resonance", "--followers", "128", "--f", "-1", "--g", "-1", "--digits", "15", "--json"]],
  "live-spectra": () => [["spectrum", "--graph", "ring:12", "--json"]],
  "live-flock": (text) => [["flock", "settle", "-", "--json"], text("flock")],
  "live-patterns": () => [["pattern", "--particles", "12", "--gains", "1/5,1/5,-1/25", "--json"]],
  "live-question": (text) => [["check", "-", "--replay", fs.mkdtempSync("/tmp/flockproof-"), "--json"], text("question")],
  "live-scenario": (text) => [["simulate", "-", "--json"], text("scenario")],
  "live-law": (text) => [["simulate", "-", "--json"], text("scenario")],
  "live-reach": (text) => [["reach", "-", "--json"], text("system")],
};
const endless = `[question]\nid = "endless"\nbudget = 1000000000\n[for]\nn = "1..1000000000"\n[holds]\nproperty = "n > 0"\ncontrols = ["n > 5"]\n`;

/** The server of the live pages: its address, which it says when the site is made, and its end. */
function serve() {
  const program = spawn(process.env.FLOCKPROOF, ["serve", "--port", "0", "--no-figures", "--ledger", path.join(site, "data/ledger.json")], { stdio: ["ignore", "pipe", "inherit"] });
  const home = new Promise((resolve, reject) => {
    program.stdout.once("data", (data) => resolve(String(data).split(" ")[0]));
    program.once("error", reject).once("exit", (status) => reject(new Error(`serve has ended with status ${status}`)));
  });
  // Other checks may fail before anybody waits for it.
  home.catch(() => {});
  return { home, end: () => program.kill("SIGTERM") };
}

const long = { timeout: 120000 };
const answered = (tab, page) => tab.waitForFunction(() => document.getElementById("state").textContent === "answered", null, long)
  .catch(async () => expect(false, `${page}: ${await tab.locator("#state").textContent()}`));

/** The live pages, as `serve` shows them. */
async function checkLive(browser, home) {
  const own = new Map();
  for (const colorScheme of ["light", "dark"]) {
    const context = await browser.newContext({ viewport: { width: colorScheme === "dark" ? 320 : 1200, height: 900 }, colorScheme });
    await each(context, pages.filter((page) => page.startsWith("explore/live-")), (tab, page) => checkAnswer(tab, page, colorScheme, own), home);
    await context.close();
  }
  const context = await browser.newContext({ viewport: { width: 1200, height: 900 } });
  await checkDrawing(context, home);
  await checkQuestions(context, home);
  await context.close();
}

/** A live page by keyboard alone, its answer against that of the command line, which `own` remembers, and how it looks. */
async function checkAnswer(tab, page, colorScheme, own) {
  const name = path.basename(page, ".html");
  for (let k = 0; k < 60 && (await tab.evaluate(() => document.activeElement.id)) !== "go"; k++) await tab.keyboard.press("Tab");
  expect((await tab.evaluate(() => document.activeElement.id)) === "go", `${page}: the keyboard leads to the button`);
  await tab.keyboard.press("Enter");
  await answered(tab, page);
  const shown = JSON.parse((await tab.locator("#document pre code").textContent()) || "{}");
  if (asked[name]) {
    const fields = await tab.evaluate(() => Object.fromEntries([...document.getElementById("ask").elements].filter((e) => e.name).map((e) => [e.name, e.value])));
    const [list, input] = asked[name]((field) => fields[field]);
    const key = JSON.stringify([list.filter((word) => !word.startsWith("/tmp/flockproof-")), input]);
    if (!own.has(key)) own.set(key, await printed(list, input ?? ""));
    if (name === "live-question") own.get(key).replay = null;
    expect(JSON.stringify(own.get(key)) === JSON.stringify(shown), `${page}: another answer than that of the command line`);
  } else expect(shown.accepted === true, `${page}: the certificate is accepted`);
  const [wide, who] = await width(tab);
  if (colorScheme === "dark") expect(wide <= 320, `${page}, answered: ${wide} pixels wide in a window of 320: ${who}`);
  await checkAxe(tab, `${page}, answered, ${colorScheme}`);
  if (await tab.locator("#answer .live").count()) {
    const before = await tab.evaluate(() => document.querySelector("#answer canvas").toDataURL());
    await tab.locator("#answer .time").first().focus();
    await tab.keyboard.press("End");
    expect(before !== await tab.evaluate(() => document.querySelector("#answer canvas").toDataURL()), `${page}: the motion moves`);
  }
  if (shots) await tab.screenshot({ path: path.join(shots, `${page.replaceAll("/", "-")}.answered.${colorScheme}.png`), fullPage: true });
}

/** Every example of a question has an answer; progress, its end, and what is refused. */
async function checkQuestions(context, home) {
  const tab = await open(context, "explore/live-question.html", home);
  for (const name of await tab.locator("#example option").allTextContents()) {
    await tab.selectOption("#example", name);
    await tab.click("#go");
    await answered(tab, name);
    if (shots) await tab.screenshot({ path: path.join(shots, `live-question.${name.replaceAll(" ", "-")}.png`), fullPage: true });
  }
  await tab.fill("textarea[name=question]", endless);
  await tab.click("#go");
  await tab.waitForFunction(() => /cases, \d+ of 1000000000/.test(document.getElementById("stage").textContent), null, long)
    .catch(() => expect(false, "progress is shown"));
  if (shots) await tab.screenshot({ path: path.join(shots, "live-question.progress.png") });
  await tab.click("#stop");
  await tab.waitForFunction(() => document.getElementById("state").textContent === "stopped", null, long).catch(() => expect(false, "it stops"));
  expect(await tab.locator("#stop").isDisabled(), "nothing more can be stopped");
  // What is wrong is said in a sentence, and a page opens no file. The status of a refusal is an error on the console of the browser.
  tab.removeAllListeners("console");
  await tab.fill("textarea[name=beside]", "");
  await tab.fill("textarea[name=question]", endless.replace('budget = 1000000000', 'scenario = "/etc/passwd"'));
  await tab.click("#go");
  await tab.waitForFunction(() => /opens no files/.test(document.getElementById("state").textContent), null, long).catch(() => expect(false, "it opens no files"));
  await tab.close();
}

/** A graph and a flock by mouse. */
async function checkDrawing(context, home) {
  const tab = await open(context, "explore/live-spectra.html", home);
  await tab.click("#clear");
  const box = await tab.locator("#drawing").boundingBox();
  const at = (x, y) => [box.x + x * box.width, box.y + y * box.height];
  const drag = async (a, b) => { await tab.mouse.move(...a); await tab.mouse.down(); await tab.mouse.move(...b); await tab.mouse.up(); };
  const corners = [at(0.3, 0.3), at(0.7, 0.3), at(0.5, 0.7)];
  for (const corner of corners) await drag(corner, corner);
  for (const k of [0, 1, 2]) await drag(corners[k], corners[(k + 1) % 3]);
  const edges = await tab.inputValue("textarea[name=edges]");
  expect(edges === "vertices 3\n1 2\n2 3\n3 1\n", `a triangle was drawn: ${edges}`);
  if (shots) await tab.screenshot({ path: path.join(shots, "live-spectra.drawn.png") });
  await tab.click("#go");
  await answered(tab, "a drawn graph");
  const shown = JSON.parse(await tab.locator("#document pre code").textContent());
  expect(JSON.stringify(shown) === JSON.stringify(await printed(["spectrum", "--graph", "-", "--json"], edges)), "the spectrum of a drawn graph");
  await tab.goto(home + "explore/live-flock.html");
  await tab.click("#clear");
  await drag(at(0.2, 0.5), at(0.3, 0.4));
  const flock = JSON.parse(await tab.inputValue("textarea[name=flock]"));
  expect(flock.positions.length === 1 && flock.velocities[0].some((x) => x !== "0"), "a bird was drawn with its velocity");
  for (const broken of ["", "{", "[]", "null", '{"positions": [null], "velocities": [7]}']) {
    await tab.fill("textarea[name=flock]", broken);
    await drag(at(0.4, 0.5), at(0.5, 0.4));
  }
  await tab.fill("textarea[name=flock]", "7");
  await drag(at(0.4, 0.5), at(0.5, 0.4));
  expect(/no flock/.test(await tab.locator("#state").textContent()), "what is no flock cannot be drawn upon, and the page says so");
  await tab.close();
}

/** Does this and tells how long it took. */
async function timed(name, work) {
  const begun = performance.now();
  await work();
  console.log(`${name}: ${Math.round((performance.now() - begun) / 1000)} s`);
}

checkLinks();
checkCounterexamples();
if (shots) fs.mkdirSync(shots, { recursive: true });
const server = process.env.FLOCKPROOF ? serve() : undefined;
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox", "--allow-file-access-from-files"] });
try {
  await timed("one page of each kind", () => checkKinds(browser));
  await timed("all pages in a narrow window", () => checkNarrow(browser));
  await timed("the list of claims", () => checkList(browser));
  await timed("the motions", () => checkMotions(browser));
  if (server) await timed("the live pages", async () => checkLive(browser, await server.home));
} finally {
  server?.end();
  await browser.close();
}
console.log(failures.length === 0 ? "the site is as it should be" : `${failures.length} failures`);
process.exitCode = failures.length === 0 ? 0 : 1;
