-- Writes the table of the whole journey into README.md, between two
-- lines that mark its place, so that no number there is typed by hand.
--
--   texlua book/press/readme.lua [--check] README.md JOURNEY.tsv
--
-- --check changes nothing, and ends with status 1 if the table that
-- stands there is not the one that the measurements give.
local here = arg[0]:match("^(.*)/[^/]*$") or "."
package.path = here .. "/?.lua;" .. package.path

local files = require "files"
local values = require "values"

local FIRST = "<!-- The journey: written by make readme -->"
local LAST = "<!-- The journey ends. -->"

local function stop(...)
  io.stderr:write("readme: ", string.format(...), "\n")
  os.exit(1)
end

-- The rows of a table, each a map from column to cell.
local function rows_of(path)
  local columns, rows
  for _, line in ipairs(files.lines(path)) do
    if not line:match("^#") and line ~= "" then
      local cells = {}
      for cell in (line .. "\t"):gmatch("(.-)\t") do
        table.insert(cells, cell)
      end
      if not columns then
        columns, rows = cells, {}
      else
        local row = {}
        for i, column in ipairs(columns) do row[column] = cells[i] end
        table.insert(rows, row)
      end
    end
  end
  return rows or stop("%s: expected a table, found none", path)
end

-- The time for all n points; what takes none is not there.
local function time(cell, n)
  local ns = tonumber(cell)
  return ns and values.format(n * ns, "seconds", 2) or ""
end

local function name_of(row)
  return (row.name:gsub("_", "-"))
end

local function line(...)
  return "| " .. table.concat({ ... }, " | ") .. " |"
end

local function journey(path)
  local rows, n, fewer = rows_of(path), 0, math.huge
  for _, row in ipairs(rows) do
    n, fewer = math.max(n, tonumber(row.n)), math.min(fewer, tonumber(row.n))
  end
  local out = {
    line("program", "chapter", "finds", "one thread",
      "all threads", "wraparound, one thread"),
    "|:--|--:|:--|--:|--:|--:|",
  }
  for _, row in ipairs(rows) do
    table.insert(out, line("`" .. name_of(row) .. "`",
      row.chapter, row.answers, time(row.standard, n),
      time(row.standard_all, n), time(row.wraparound, n)))
  end
  values.load { path }
  local from, why = values.provenance(files.name(path))
  if not from then stop("%s", why) end
  local first, last = rows[1], rows[1]
  for _, row in ipairs(rows) do
    if row.answers == first.answers then last = row end
  end
  table.insert(out, "")
  local slow = fewer < n and " (the slowest answered for fewer and were"
    .. " scaled up)" or ""
  table.insert(out, ("Time to answer for all of %s uniform points%s; %s, %s,"
    .. " %s. On one thread, `%s` is %s times as fast as `%s`."):format(
      values.format(n, "integer"), slow, from.machine, from.compiler,
      from.date, name_of(last),
      values.format(first.standard / last.standard, nil, 2),
      name_of(first)))
  return table.concat(out, "\n")
end

-- ---- the command line -------------------------------------------------
local check = arg[1] == "--check"
local readme, data = arg[check and 2 or 1], arg[check and 3 or 2]
if not data then stop("say readme.lua [--check] README.md JOURNEY.tsv") end
local text = files.read(readme) or stop("cannot read %s", readme)
local _, first = text:find(FIRST .. "\n", 1, true)
local last = first and text:find("\n" .. LAST, first, true)
if not last then
  stop('%s: expected the lines "%s" and "%s"', readme, FIRST, LAST)
end
local new = text:sub(1, first) .. "\n" .. journey(data) .. "\n"
  .. text:sub(last)
if check and new ~= text then
  stop("%s: the table is not what %s gives; say make readme", readme, data)
elseif not check then
  files.write(readme, new)
end
