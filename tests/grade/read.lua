-- Reads what make grade has written, strictly, and holds it against what
-- was expected: usage  texlua read.lua FOLDER NAME...
-- FOLDER/NAME has grade/results.json, grade/junit.xml, what was said,
-- the status, and `expected`: the score, words of the report, and
-- words that it must not have.

local function read(name)
  local file = io.open(name, "rb")
  if not file then return "" end
  local text = file:read("a")
  file:close()
  return text
end

package.path = arg[0]:gsub("[^/]*$", "") .. "../?.lua;" .. package.path
local json = require "json"

-- ---- Gradescope's format ----------------------------------------------

local kinds = {
  score = "number", max_score = "number", status = "string",
  name = "string", number = "string", output = "string",
  visibility = "string", extra_data = "table",
}

local function check_results(results)
  local total = 0
  if type(results.tests) ~= "table" or #results.tests == 0 then
    error("has no tests", 0)
  end
  for _, test in ipairs(results.tests) do
    for key, kind in pairs(kinds) do
      if type(test[key]) ~= kind then error("a test's " .. key, 0) end
    end
    for key in pairs(test) do
      if not kinds[key] then error("an unknown key " .. key, 0) end
    end
    if test.status ~= "passed" and test.status ~= "failed" then
      error("status " .. test.status, 0)
    end
    if test.score > test.max_score then error("too many points", 0) end
    total = total + test.score
  end
  for _, entry in ipairs(results.leaderboard or {}) do
    if type(entry.name) ~= "string" or type(entry.value) ~= "number" or
      entry.order ~= "asc" then
      error("the leaderboard", 0)
    end
  end
  if type(results.score) ~= "number" or type(results.output) ~= "string" then
    error("no score, or no output", 0)
  end
  return total
end

-- ---- XML: tags that match, nothing that must be escaped ----------------

local function check_xml(what)
  if not utf8.len(what) then error("junit.xml is not UTF-8", 0) end
  local open = {}
  for between, tag in what:gmatch("([^<]*)<([^>]*)>") do
    if between:find("[^%s]") then error("text in junit.xml", 0) end
    local name = tag:match("^/?[%w?]+")
    if tag:sub(1, 1) == "/" then
      if table.remove(open) ~= name:sub(2) then error("a stray </", 0) end
    elseif not tag:find("[/?]$") then
      open[#open + 1] = name
    end
    local rest = tag:gsub('%w+="[^"<&]*"', ""):gsub("&#?%w+;", "")
    rest = tag:gsub("&#%d+;", ""):gsub('[%w]+="[^"<&]*"', "")
    if rest:find('["&<]') then error("an attribute of junit.xml", 0) end
  end
  if #open > 0 then error("junit.xml has no end", 0) end
  if what:find("[%z\1-\8\11-\31\127]") then error("a control character", 0) end
end

-- ---- all of them ------------------------------------------------------

local function check(case)
  if read(case .. "/status") ~= "0\n" then
    error("make grade failed: " .. read(case .. "/errors"), 0)
  end
  local results = json(read(case .. "/grade/results.json"))
  local total = check_results(results)
  check_xml(read(case .. "/grade/junit.xml"))
  local said = read(case .. "/said")
  local last = json(said:match("([^\n]*)\n$") or "")
  local score, words, never =
    read(case .. "/expected"):match("(.-)\n(.-)\n(.-)\n?$")
  local told = results.output
  for _, test in ipairs(results.tests) do told = told .. test.output end
  told = told:gsub("\\n", " "):gsub(" +", " ")
  if said:find("[%z\1-\8\11-\31\127]") then error("raw control bytes", 0) end
  if total ~= (tonumber(score) or total) or not told:find(words, 1, true) then
    error(string.format("score %s, not %s, or not '%s': %s", total, score,
      words, told:sub(1, 1500)), 0)
  end
  if never ~= "" and told:find(never, 1, true) then
    error("it says '" .. never .. "': " .. told:sub(1, 1500), 0)
  end
  if not last.scores or not next(last.scores) then
    error("no line for Autolab", 0)
  end
end

for k = 2, #arg do
  local good, why = pcall(check, arg[1] .. "/" .. arg[k])
  if good then
    print("ok " .. arg[k])
  else
    print("not ok " .. arg[k] .. ": " .. tostring(why):gsub("\n", " "))
  end
end
