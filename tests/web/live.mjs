// node live.mjs BUILD: every figure that runs asks for a prediction, runs
// when it has one, by the keyboard alone; its answers are the naive ones;
// what the question is about is to be seen in it; each of its buttons can
// be pressed, and keeps the focus; what changes is said by regions that
// were there before; near, once it is warm, takes no more
// than four times what portable code takes outside of a browser; and where
// there is no WebAssembly the picture stands alone. Pictures are left in
// BUILD/web-check.
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { resolve } from "node:path";
import { start } from "../browser/chromium.mjs";

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

// What a screen reader says by itself: the text of regions that were
// there, empty, when the page was.
const mark = (name) => page.evaluate(`${frame(name)}.querySelectorAll(
  "[role=status], [aria-live]").forEach((e) => { e.there = !e.textContent; })`);
const heard = (name) => page.evaluate(`[...${frame(name)}.querySelectorAll(
  "[role=status], [aria-live]")].filter((e) => e.there).map((e) =>
  e.textContent).join(" | ")`);
const focused = () => page.evaluate(
  "document.activeElement.textContent || document.activeElement.tagName");

// A prediction, by keys: into the first field, a choice or a number, and
// Show. Before, Show says what is missing.
async function predict(name) {
  await mark(name);
  check(await page.evaluate(`!${frame(name)}.querySelector(":invalid, "
    + "[aria-invalid=true], [required]")`), "not yet wrong " + name,
    "a field is invalid before anything is entered");
  const button = `${frame(name)}.querySelector("[type=submit]")`;
  await page.evaluate(`${button}.focus()`);
  await page.key("Enter");
  check(/first/.test(await heard(name)), "asks " + name, "Show says nothing");
  await page.evaluate(`${frame(name)}.querySelector("input").focus()`);
  const kind = await page.evaluate("document.activeElement.type");
  if (kind === "radio") await page.key(" ", "Space");
  else await page.send("Input.insertText", { text: "5" });
  await page.evaluate(`${button}.focus()`);
  await page.key("Enter");
  const shown = await until(`${frame(name)}.dataset.shown === "yes"`);
  check(await focused() === "Show", "focus " + name, "Show loses it");
  check(/you said/i.test(await heard(name)), "said " + name,
    "the answer is in no region that was there: " + await heard(name));
  return shown;
}

// The arrows move a cross, and it is said where to; Enter does something,
// and it is said what. The points are listed in words.
async function keys(name) {
  const plane = `${frame(name)}.querySelector("svg[tabindex]")`;
  if (!await page.evaluate(`!!${plane}`)) return;
  await page.evaluate(`${plane}.focus()`);
  const before = await page.evaluate(`${plane}.innerHTML`);
  const places = new Set([await heard(name)]);
  for (let i = 0; i < 8; i++) await page.key("ArrowRight");
  places.add(await heard(name));
  for (let i = 0; i < 6; i++) await page.key("ArrowUp");
  places.add(await heard(name));
  await page.key("Enter");
  places.add(await heard(name));
  check(places.size === 4, "said of keys " + name, [...places].join("; "));
  check(await page.evaluate(`${plane}.innerHTML`) !== before,
    "keys " + name, "nothing changes");
  check(await page.evaluate(`${frame(name)}.querySelectorAll("details li")
    .length`) > 1, "listed " + name, "the points are not told in words");
}

// A button that cannot be pressed any more keeps the focus.
async function buttons(name) {
  const all = `[...${frame(name)}.querySelectorAll(".panel button")].filter(
    (b) => !/Save/.test(b.textContent))`;
  const count = await page.evaluate(all + ".length"), lost = [];
  for (let i = 0; i < count; i++) {
    await page.evaluate(`${all}[${i}].focus()`);
    for (let k = 0; k < 3; k++) await page.key("Enter");
    if (!await page.evaluate(`document.activeElement === ${all}[${i}]`)) {
      lost.push(await page.evaluate(`${all}[${i}].textContent`));
    }
  }
  check(lost.length === 0, "buttons " + name, lost.join(", ")
    + " cannot be focused or lose the focus");
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

// Takes an entry of the list with this label.
function choose(name, label, k) {
  return page.evaluate(`(() => { const s = [...${frame(name)}
    .querySelectorAll("label")].find((l) =>
      l.textContent.startsWith("${label}")).querySelector("select"); s.selectedIndex = ${k};
    s.dispatchEvent(new Event("change")); })()`);
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
  if (await page.evaluate(`"asked" in live.shown["${name}"]`)) {
    check(await page.evaluate(`live.shown["${name}"].asked()`) === true,
      "asked " + name, "what the question is about is not there");
  }
  await page.evaluate(`${frame(name)}.scrollIntoView()`);
  writeFileSync(`${out}/${name}.png`, await page.picture());
  await keys(name);
  await mouse(name);
  await buttons(name);
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

// ---- what is no list of cells ---------------------------------------------
await page.go(`file://${web}/ch04.html`);
await predict("ch04-count-scan-place");
await page.evaluate(`(() => { const i = ${frame("ch04-count-scan-place")}
  .querySelector(".panel input"); i.value = "9 1";
  i.dispatchEvent(new Event("change")); })()`);
check(/“9 1”/.test(await heard("ch04-count-scan-place")),
  "wrong cells are answered", await heard("ch04-count-scan-place"));

// ---- what a figure asks about happens in it --------------------------------
const press = (name, label) => page.evaluate(`[...${frame(name)}
  .querySelectorAll(".panel button")].find((b) => b.textContent === "${label}")
  .click()`);
const status = (name) => page.evaluate(
  `${frame(name)}.querySelector("[role=status]").textContent`);

await page.go(`file://${web}/ch09.html`);
await predict("ch09-three-spans");
await press("ch09-three-spans", "Next that is not sure");
check(/It is not sure/.test(await status("ch09-three-spans")),
  "some queries are not sure", await status("ch09-three-spans"));
await choose("ch09-three-spans", "Points in a cell", 3);
check(/All 200 are sure/.test(await status("ch09-three-spans")),
  "with four in a cell all are", await status("ch09-three-spans"));

await page.go(`file://${web}/ch10.html`);
await predict("ch10-corner-trick");
const trick = () => page.evaluate(`live.shown["ch10-corner-trick"].state()`);
const whole = await trick();
check(whole.corner === 0 && whole.outside > 0 && !whole.wrong,
  "an empty corner is not enough", JSON.stringify(whole));
for (let k = 0; k < whole.outside; k++) {
  await press("ch10-corner-trick", "Take the furthest away");
}
const broken = await trick();
check(broken.outside === 0 && broken.wrong, "no point outside is",
  JSON.stringify(broken));

await page.go(`file://${web}/ch11.html`);
await predict("ch11-pieces");
const counts = await page.evaluate(`live.shown["ch11-pieces"].counts`);
check(counts[2] === Math.max(...counts) && counts[0] < 10,
  "towns are cut into the most pieces", counts.join(" "));

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

check(await page.evaluate(`[...${frame("ch01-near")}.querySelectorAll("button")]
  .find((b) => /Save/.test(b.textContent)).ariaDisabled`) === "true",
  "nothing to save after a file that is refused", "the points before it could be saved");
await page.evaluate(`${near}.open(new File(["-7,0\\n3,4\\n0,1\\n"],
  "three.csv"))`);
const straight = await page.evaluate(said);
await choose("ch01-near", "Geometry", 1);
const around = await page.evaluate(said);
check(/three.csv/.test(straight) && /three.csv/.test(around)
  && /wraps around is -7, 0 to 3, 4/.test(around), "near answers anew in "
  + "another geometry", around);

// ---- by the mouse, and by a button ----------------------------------------
const arrows = `live.shown["ch01-arrows"]`;
await predict("ch01-arrows");
const dot = await page.evaluate(`(() => {
  const dot = ${frame("ch01-arrows")}.querySelector("circle.dot");
  dot.scrollIntoView({ block: "center" });
  const r = dot.getBoundingClientRect();
  return [r.left + r.width / 2, r.top + r.height / 2]; })()`);
for (const [type, move] of [["mousePressed", 0], ["mouseMoved", 12],
  ["mouseMoved", 24], ["mouseReleased", 24]]) {
  await page.send("Input.dispatchMouseEvent", { type, x: dot[0] + move,
    y: dot[1], button: "left", buttons: 1, clickCount: 1 });
}
check(await page.evaluate(`${arrows}.points()`) === 12, "a point is dragged",
  "a point more, or one less");
await page.click(dot[0] + 24, dot[1]);
check(await page.evaluate(`${arrows}.points()`) === 11,
  "and is where it was dragged", "a click there takes nothing away");

await page.go(`file://${web}/ch08.html`);
await predict("ch08-strip");
const strip = await page.evaluate(`(() => { const f = ${frame("ch08-strip")};
  [...f.querySelectorAll("button")].find((b) =>
    /longer/.test(b.textContent)).click();
  return f.querySelector("[role=status]").textContent; })()`);
check(/Not packed, 81 of 192 lanes had work: 42%/.test(strip),
  "a longer search, and the lanes that wait for it", strip);

// ---- where there is no WebAssembly ---------------------------------------
await page.send("Page.addScriptToEvaluateOnNewDocument",
  { source: "delete globalThis.WebAssembly" });
await page.go(`file://${web}/ch04.html`);
check(await page.evaluate("!document.querySelector('.live')")
  && page.complaints.length === 0, "the picture stands alone",
  page.complaints.join("; "));

await browser.close();
process.exit(failures ? 1 : 0);
