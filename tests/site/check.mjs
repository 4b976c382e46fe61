// The pages of `flockproof report --out DIR` in Chromium: node check.mjs DIR [FOLDER FOR SCREENSHOTS]
//
// Asked of every page: no message of an error on the console, no request but for files of the site, every link and anchor
// leads somewhere, and at 320 pixels nothing is wider than the window. Of one page of each kind, light and dark: axe finds
// nothing. Of the list of claims: filters, search and keyboard. Of the motions: they run.
import { chromium } from "playwright-core";
import fs from "node:fs";
import path from "node:path";
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
  "papers/paley.html", "errata/index.html", "errata/paley.html", "claims/paley.eq21.html", "claims/chazelle.ex15.html",
  "claims/veerman.table1_numeric.html", "claims/tanner2.thm2_stop.html", "claims/beyond.chazelle.tower.html", "notes/settling.html",
  "coq/veerman_theorem1.html", "explore/index.html", "explore/four-birds.html", "explore/patterns.html", "explore/live-flock.html"];

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

/** A page that reports errors and requests. */
async function open(context, page) {
  const tab = await context.newPage();
  tab.on("console", (message) => expect(message.type() !== "error", `${page}: ${message.text()}`));
  tab.on("pageerror", (error) => expect(false, `${page}: ${error}`));
  tab.on("request", (request) => expect(/^(file|data):/.test(request.url()), `${page}: asks for ${request.url()}`));
  await tab.goto(address(page));
  return tab;
}

async function checkNarrow(browser) {
  const context = await browser.newContext({ viewport: { width: 320, height: 640 } });
  for (const page of pages) {
    const tab = await open(context, page);
    const [wide, who] = await tab.evaluate(() => {
      const root = document.documentElement, wide = root.scrollWidth;
      const who = [...document.querySelectorAll("main *")].find((e) => e.getBoundingClientRect().right > innerWidth + 1 && !e.closest(".wide, pre"));
      return [wide, who ? who.outerHTML.slice(0, 120) : ""];
    });
    expect(wide <= 320, `${page}: ${wide} pixels wide in a window of 320: ${who}`);
    if (shots && kinds.includes(page)) await tab.screenshot({ path: path.join(shots, page.replaceAll("/", "-") + ".narrow.png") });
    await tab.close();
  }
  await context.close();
}

async function checkKinds(browser) {
  for (const colorScheme of ["light", "dark"]) {
    const context = await browser.newContext({ viewport: { width: 1200, height: 900 }, colorScheme });
    for (const page of kinds.filter((page) => pages.includes(page))) {
      const tab = await open(context, page);
      await tab.evaluate(axe);
      const found = await tab.evaluate(async () => (await window.axe.run({ resultTypes: ["violations"] })).violations);
      for (const violation of found) {
        const node = violation.nodes[0];
        expect(false, `${page}, ${colorScheme}: ${violation.id}, ${violation.nodes.length} times: ${node.html.slice(0, 140)} (${node.any[0]?.message ?? violation.help})`);
      }
      if (shots) await tab.screenshot({ path: path.join(shots, `${page.replaceAll("/", "-")}.${colorScheme}.png`) });
      await tab.close();
    }
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
  for (const page of pages.filter((page) => page.startsWith("explore/") && !/index|live-/.test(page))) {
    const tab = await open(context, page);
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
    await tab.close();
  }
  await context.close();
}

checkLinks();
if (shots) fs.mkdirSync(shots, { recursive: true });
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox", "--allow-file-access-from-files"] });
try {
  await checkList(browser);
  await checkMotions(browser);
  await checkKinds(browser);
  await checkNarrow(browser);
} finally {
  await browser.close();
}
console.log(failures.length === 0 ? "the site is as it should be" : `${failures.length} failures`);
process.exitCode = failures.length === 0 ? 0 : 1;
