-- Tests of the press's modules that need no pandoc:
--   texlua modules.lua PRESS HERE
package.path = arg[1] .. "/?.lua;" .. package.path
local here = arg[2]

local c = require "c"
local files = require "files"
local log = require "log"
local numbers = require "numbers"
local values = require "values"

local function equal(name, found, expected)
  if found == expected then
    print("ok " .. name)
  else
    print(("not ok %s: expected %s, found %s"):format(name,
      tostring(expected), tostring(found)))
  end
end

-- ---- values -----------------------------------------------------------
for _, case in ipairs {
  { 3.14159, nil, nil, "3.14" }, { 3.14159, nil, 5, "3.1416" },
  { 0.00158207, nil, 6, "0.00158207" }, { 0.001, nil, nil, "0.00100" },
  { 13509, nil, nil, "13,500" }, { 13509, "integer", nil, "13,509" },
  { 9999, "integer", nil, "9999" }, { 1e9, nil, nil, "1,000,000,000" },
  { 999.7, nil, nil, "1000" }, { 99.96, nil, nil, "100" },
  { 9.996, nil, nil, "10.0" }, { 8, nil, nil, "8" }, { 0, nil, nil, "0" },
  { -2.5, nil, 2, "−2.5" }, { 0.5, "percent", nil, "50%" },
  { 0.12345, "percent", nil, "12.3%" },
  { 4.2e-9, nil, 2, "4.2\u{2009}×\u{2009}10⁻⁹" },
  { 280, "seconds", nil, "280\u{2009}ns" },
  { 3251234.5, "seconds", 2, "3.3\u{2009}ms" },
  { 999.9, "seconds", nil, "1.00\u{2009}µs" },
  { 6.1e9, "seconds", 2, "6.1\u{2009}s" },
  { 119e9, "seconds", nil, "119\u{2009}s" },
  { 600e9, "seconds", nil, "10\u{2009}min" },
  { 1e13, "seconds", 2, "2.8\u{2009}h" }, { "naive", nil, nil, "naive" },
} do
  local value, as, digits, expected = table.unpack(case)
  equal(("format %s %s %s"):format(value, as or "plain", digits or 3),
    values.format(value, as, digits), expected)
end

values.load { here .. "/good/book/data/ch01-speeds.tsv" }
equal("evaluate a cell", values.evaluate("ch01.first.ns"), 3251234.5)
equal("evaluate a word", values.evaluate("ch01.first.name"), "first")
equal("evaluate a claim",
  values.evaluate("ch01.second.ns < ch01.first.ns"), true)
equal("evaluate a function", values.evaluate("sqrt(16) + abs(-1)"), 5.0)
equal("evaluate no assignment", values.evaluate("1; x = 2"), nil)

-- ---- numbers ------------------------------------------------------------
for text, expected in pairs {
  ["it took 3.2 ms."] = "3.2 ms", ["in 12 seconds"] = "12 seconds",
  ["a 10-second run"] = "10-second", ["40% of it"] = "40%",
  ["8x faster"] = "8x", ["8× as fast"] = "8x",
  ["twice 2.5."] = "2.5", ["85 GB, at 3 GHz"] = "85 GB|3 GHz",
  ["5 times faster"] = "5 times faster", ["30 µs"] = "30 us",
  ["in 1975"] = "", ["the 1980s"] = "", ["100,000 points"] = "",
  ["1/2 of n"] = "", ["AVX-512 and x86-64"] = "", ["C11, C17."] = "",
  ["a 3×3 block"] = "", ["32-bit numbers"] = "", ["10 points"] = "",
  ["a block of 3 by 3."] = "", ["in chapter 2, so"] = "",
  ["\1 seconds"] = "", ["5 times nothing"] = "", ["PDP-10 cycles"] = "",
} do
  equal("number in: " .. text:gsub("\1", "?"),
    table.concat(numbers.suspicious(text), "|"), expected)
end

-- ---- C ------------------------------------------------------------------
local function tokens(line, open)
  local pieces, still = c.pieces(line, open)
  local parts = {}
  for _, piece in ipairs(pieces) do
    table.insert(parts, piece[1]:sub(1, 1) .. "[" .. piece[2] .. "]")
  end
  return table.concat(parts) .. (still and "..." or "")
end
equal("keywords", tokens("int x = if0;"), "k[int]p[ x = if0;]")
equal("a string is no comment", tokens('f("// \\" no");'),
  'p[f("// \\" no");]')
equal("a character", tokens("'\"' // yes"), "p['\"' ]c[// yes]")
equal("a comment begins", tokens("x /* on"), "p[x ]c[/* on]...")
equal("a comment goes on", tokens("and on", true), "c[and on]...")
equal("a comment ends", tokens("done */ int", true),
  "c[done */]p[ ]k[int]")
equal("a slash", tokens("a / b /**/ c"), "p[a / b ]c[/**/]p[ c]")

-- ---- the log ------------------------------------------------------------
local found = {}
for _, fault in ipairs(log.faults(files.read(here .. "/latex.log"))) do
  table.insert(found, ("%s:%d: %s"):format(table.unpack(fault)))
end
for i, expected in ipairs(files.lines(here .. "/latex.faults")) do
  equal("log " .. i, found[i], expected)
end
equal("faults in the log", #found, #files.lines(here .. "/latex.faults"))
