// node live.mjs BUILD: every figure that runs asks for a prediction, runs
// when it has one, by the keyboard alone; its answers are the naive ones;
// each of its buttons can be pressed; near, once it is warm, takes no more
// than four times what portable code takes outside of a browser; and where
// there is no WebAssembly the picture stands alone. Pictures are left in
// BUILD/web-check.
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { resolve } from "node:path";
import { start } from "./chromium.mjs";

const build = resolve(process.argv[2]), web = build + "/web";
const out = build + "/web-check/live";
const axe = readFileSync(build
  + "/web-check/node_modules/axe-core/axe.min.js", "utf8");
const helpers = ["live", "draw", "near"];
const names = readdirSync(web + "/live").map((n) => n.replace(/\.js$/, ""))
  .filter((n) => !helpers.includes(n));
let failures = 0;

function check(good, name, why = "") {
  if (!good) failures++;
  console.log(`${good ? "ok" : "not ok"} ${name}${good ? "" : ": " + why}`);
}

mkdirSync(out, { recursive: true });
const browser = await start();
const page = await browser.open();
await page.size(1000, 1000);
const frame = (name) => `document.getElementById("live-${name}").parentNode`;

async function until(expression, tries = 100) {
  for (let i = 0; i < tries; i++) {
    if (await page.evaluate(expression)) return true;
    await new Promise((r) => setTimeout(r, 100));
  }
  return false;
}

// A prediction, by keys: into the first field, a choice or a number, and
// Enter.
async function predict(name) {
  await page.evaluate(`${frame(name)}.querySelector("input").focus()`);
  const kind = await page.evaluate("document.activeElement.type");
  if (kind === "radio") await page.key(" ", "Space");
  else await page.send("Input.insertText", { text: "5" });
  await page.key("Enter");
  return until(`${frame(name)}.dataset.shown === "yes"`);
}

async function keys(name) {
  const plane = `${frame(name)}.querySelector("svg[tabindex]")`;
  if (!await page.evaluate(`!!${plane}`)) return;
  const said = `${frame(name)}.querySelector("[role=status]").textContent`;
  await page.evaluate(`${plane}.focus()`);
  const before = await page.evaluate(said + `+ ${plane}.innerHTML`);
  for (let i = 0; i < 8; i++) await page.key("ArrowRight");
  for (let i = 0; i < 6; i++) await page.key("ArrowUp");
  await page.key("Enter");
  check(await page.evaluate(said + `+ ${plane}.innerHTML`) !== before,
    "keys " + name, "nothing changes");
}

async function mouse(name) {
  const plane = `${frame(name)}.querySelector(".asks")`;
  if (!await page.evaluate(`!!${plane}`)) return;
  await page.evaluate(`${plane}.scrollIntoView({ block: "center" })`);
  const at = await page.evaluate(`(() => { const r = ${plane}
    .getBoundingClientRect(); return [r.left + r.width * 0.3,
    r.top + r.height * 0.3]; })()`);
  const before = await page.evaluate(`${plane}.innerHTML`);
  await page.click(...at);
  check(await page.evaluate(`${plane}.innerHTML`) !== before, "mouse " + name,
    "nothing changes");
}

for (const name of names) {
  await page.go(`file://${web}/${name.slice(0, 4)}.html`);
  const there = await page.evaluate(
    `!!document.getElementById("live-${name}")`);
  check(there, "there " + name, "the chapter has no such figure");
  if (!there) continue;
  check(await predict(name), "runs " + name, await page.evaluate(
    `${frame(name)}.textContent`));
  if (!await page.evaluate(`"${name}" in live.shown`)) continue;
  check(await page.evaluate(`live.shown["${name}"].check()`) === true,
    "right " + name, "another answer than the naive one");
  await page.evaluate(`${frame(name)}.scrollIntoView()`);
  writeFileSync(`${out}/${name}.png`, await page.picture());
  await keys(name);
  await mouse(name);
  await page.evaluate(`${frame(name)}.querySelectorAll(".panel button")
    .forEach((b) => { if (!/Save/.test(b.textContent)) b.click(); })`);
  await page.evaluate(`${frame(name)}.querySelectorAll("select").forEach((s) =>
    { s.selectedIndex = 1; s.dispatchEvent(new Event("change")); })`);
  check(page.complaints.length === 0, "quiet " + name,
    page.complaints.join("; "));
  await page.evaluate(axe + ";0");
  const found = await page.evaluate(`axe.run(${frame(name)}).then((r) =>
    r.violations.filter((v) => /serious|critical/.test(v.impact)).map((v) =>
    v.id + " " + v.nodes[0].html.slice(0, 150)).join("; "))`);
  check(found === "", "accessible " + name, found);
}

// ---- near, with files ----------------------------------------------------
await page.go(`file://${web}/ch01.html`);
await predict("ch01-near");
const near = `live.shown["ch01-near"]`;
const said = `${frame("ch01-near")}.querySelector("[role=status]").textContent`;
const took = Math.min(await page.evaluate(`${near}.took()`),
  await page.evaluate(`${near}.took()`));
check(took < 500, `near answers for 100,000 points, in ${took.toFixed(0)} ms`,
  "too slow");
let warm = Infinity;
for (let i = 0; i < 15; i++)
  warm = Math.min(warm, await page.evaluate(`${near}.again()`));
const trials = execFileSync(build + "/near", ["-n", "100000", "-a",
  "by-sample", "-t", "1", "-r", "15", "--timing"],
  { env: { ...process.env, NEAR_ISA: "portable" }, encoding: "utf8" });
const outside = Math.min(...trials.trim().split("\n").slice(1)
  .map((line) => line.split("\t")[5] / 1e6));
check(warm < 4 * outside, `near, when it is warm, in ${warm.toFixed(1)} ms, `
  + `${(warm / outside).toFixed(1)} times what it takes outside`,
  "more than four times");
await page.evaluate(`${near}.open(new File(["x,y\\n0,0\\n3,4\\n0,1\\n"],
  "cities.csv"))`);
check(/cities.csv: both answers for 3 points/.test(await page.evaluate(said)),
  "near reads a file", await page.evaluate(said));
await page.evaluate(`${near}.open(new File(["x,y\\n1,2\\n12.5,abc\\n"],
  "cities.csv"))`);
check(/cities.csv:3: expected two numbers/.test(await page.evaluate(said)),
  "near refuses a file", await page.evaluate(said));

// ---- where there is no WebAssembly ---------------------------------------
await page.send("Page.addScriptToEvaluateOnNewDocument",
  { source: "delete globalThis.WebAssembly" });
await page.go(`file://${web}/ch04.html`);
check(await page.evaluate("!document.querySelector('.live')")
  && page.complaints.length === 0, "the picture stands alone",
  page.complaints.join("; "));

await browser.close();
process.exit(failures ? 1 : 0);
