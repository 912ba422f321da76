// node browser.mjs BUILD: opens the pages in Chromium as files, without a
// server: nothing is complained about, nothing asked of another host,
// nothing wider than a window, nothing that axe finds serious, by day and
// by night; rows with heads, names with their formulas, no silent stops;
// with scripts and without. Pictures of three widths and what
// a screen reader is told are left in BUILD/web-check.
import { mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { resolve } from "node:path";
import { start } from "./chromium.mjs";

const build = resolve(process.argv[2]), out = build + "/web-check";
const axe = readFileSync(out + "/node_modules/axe-core/axe.min.js", "utf8");
const url = (name) => "file://" + build + "/web/" + name;
const text = readdirSync(build + "/web").filter((n) => n.endsWith(".html"));
const sources = ["code/near/near.c.html", "Makefile.html",
  "book/data/ch10-journey.tsv.html", "code/ch04-cell-sort/cells.c.html"]
  .filter((n) => { try { readFileSync(build + "/web/" + n); return true; }
    catch { return false; } });
const widths = [360, 800, 1400];
const shown = ["index.html", "ch04.html", "glossary.html", "terms.html",
  "search.html", sources[0]];
let failures = 0;

function check(good, name, why = "") {
  if (!good) failures++;
  console.log(`${good ? "ok" : "not ok"} ${name}${good ? "" : ": " + why}`);
}

mkdirSync(out + "/pictures", { recursive: true });
const browser = await start();
const page = await browser.open();

// By night only the colors are others.
async function accessible(name, scheme) {
  await page.scheme(scheme);
  await page.evaluate(axe + ";0");
  const found = await page.evaluate(`axe.run(document, { resultTypes:
    ["violations"]${scheme === "dark" ? ', runOnly: ["color-contrast"]' : ""}
    }).then((r) => r.violations.filter((v) =>
    v.impact === "serious" || v.impact === "critical").map((v) => v.id + " (" +
    v.nodes.length + "): " + v.nodes[0].html.slice(0, 160)))`);
  check(found.length === 0, `accessible ${name} ${scheme}`, found.join("; "));
}

// What axe lets pass: the first cell of a row is its head, a table's name
// has its caption's formulas, and whatever the keys stop at has a name and
// a role; code has its text.
async function told(name) {
  const found = await page.evaluate(`(() => {
    const faults = [], all = (where, s) => [...where.querySelectorAll(s)];
    for (const row of all(document, ".table tbody tr")) {
      const cell = row.cells[0];
      if (cell.textContent && cell.scope !== "row") faults.push("no head: "
        + row.textContent.slice(0, 60));
    }
    for (const caption of all(document, "caption")) {
      const label = caption.parentNode.getAttribute("aria-label") || "";
      for (const part of all(caption, "math mi, math mn")) {
        if (!label.includes(part.textContent)) faults.push("the name lacks "
          + part.textContent + ": " + caption.textContent.slice(0, 60));
      }
    }
    for (const e of all(document, "main [tabindex]:not(pre)")) {
      if (!e.getAttribute("role") || !e.getAttribute("aria-label")) faults
        .push("a silent stop: " + e.outerHTML.slice(0, 80));
    }
    return faults; })()`);
  check(found.length === 0, "told " + name, found.slice(0, 3).join("; "));
}

for (const name of [...text, ...sources]) {
  await page.size(1400);
  await page.go(url(name));
  check(page.complaints.length === 0, "quiet " + name,
    page.complaints.slice(0, 3).join("; "));
  const others = page.requests.filter((r) => !/^(file|data|blob):/.test(r));
  check(others.length === 0, "alone " + name, others.join(", "));
  for (const scheme of ["light", "dark"]) await accessible(name, scheme);
  await told(name);
  await page.scheme("light");
  for (const width of widths) {
    await page.size(width);
    const wide = await page.evaluate("document.documentElement.scrollWidth");
    check(wide <= width, `narrow ${name} ${width}`, `it is ${wide} wide`);
    if (shown.includes(name)) {
      writeFileSync(`${out}/pictures/${name.replace(/\W/g, "-")}-${width}.png`,
        await page.picture());
    }
  }
}

// ---- a whole screen at night -----------------------------------------------
await page.size(1400);
await page.scheme("dark");
await page.go(url("ch04.html") + "#fig:ch04-placement");
writeFileSync(out + "/pictures/dark.png", await page.picture());
await page.scheme("light");

// ---- the search ------------------------------------------------------------
await page.go(url("search.html") + "?q=birthday+paradox");
check(await page.evaluate(
  "document.querySelector('#results a').href.includes('ch05.html')"),
  "search finds a chapter", "not chapter 5 first");
await page.evaluate("document.getElementById('words').value = ''");
await page.evaluate("document.getElementById('words').focus()");
await page.send("Input.insertText", { text: "lost update" });
check(await page.evaluate("document.querySelectorAll('#results li').length") > 1,
  "search as one types", "nothing found");

// ---- without scripts -----------------------------------------------------
await page.send("Emulation.setScriptExecutionDisabled", { value: true });
await page.go(url("ch04.html"));
writeFileSync(out + "/pictures/without-scripts.png", await page.picture());
const seen = await page.send("DOM.getDocument", { depth: 0 });
const summary = await page.send("DOM.querySelectorAll",
  { nodeId: seen.root.nodeId, selector: ".quick summary" });
check(summary.nodeIds.length > 0, "questions without scripts");
await page.send("Emulation.setScriptExecutionDisabled", { value: false });

// ---- what a screen reader is told --------------------------------------------
await page.send("Accessibility.enable");
await page.go(url("ch04.html"));
const { nodes } = await page.send("Accessibility.getFullAXTree");
const byId = new Map(nodes.map((n) => [n.nodeId, n]));
const lines = [];
(function tell(node, depth) {
  const role = node.role?.value, name = node.name?.value || "";
  const told = !node.ignored && !["InlineTextBox", "StaticText", "generic",
    "none"].includes(role) || role === "StaticText";
  if (told) lines.push("  ".repeat(depth) + role + (name ? ": " + name : ""));
  if (role === "StaticText") return;
  for (const id of node.childIds || []) {
    if (byId.has(id)) tell(byId.get(id), depth + (told ? 1 : 0));
  }
})(nodes[0], 0);
writeFileSync(out + "/ch04-as-told.txt", lines.join("\n") + "\n");
const unnamed = lines.filter((l) => /^\s*image$/.test(l)).length;
check(unnamed === 0, "every picture is told", unnamed + " are not");
check(lines.some((l) => l.includes("main")) && lines.some((l) =>
  l.includes("navigation: Book")), "landmarks");

// Where a number or a claim comes from is said once: not in the name.
const within = (s) => nodes.filter((n) => !n.ignored && s(n.role?.value));
const generic = within((r) => r === "generic").filter((n) => n.name?.value);
check(generic.length === 0, "no names without a role",
  generic.slice(0, 3).map((n) => n.name.value).join("; "));
const unheaded = within((r) => r === "table").filter((n) => !(function has(m) {
  return m.role?.value === "rowheader"
    || (m.childIds || []).some((id) => byId.has(id) && has(byId.get(id)));
})(n));
check(unheaded.length === 0, "row headers", unheaded.length + " tables");
for (const kind of [".value", ".claim > a"]) {
  const { result } = await page.send("Runtime.evaluate", { expression:
    `document.querySelector("${kind}").focus({ focusVisible: true });
    document.activeElement` });
  const of = await page.send("Accessibility.getPartialAXTree",
    { objectId: result.objectId, fetchRelatives: false });
  const { name, description } = of.nodes[0];
  check(!name.value.includes("book/data")
    && description?.value.includes("book/data"), "said once " + kind,
    `the name is "${name.value}", the description "${description?.value}"`);
}

await browser.close();
process.exit(failures ? 1 : 0);
