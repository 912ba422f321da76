-- The measured tables, and what prose says about them. A table is
-- tab-separated: lines "# key: value" that say where it comes from, a
-- line of column names, rows. If its first column is called "name", an
-- expression may use its cells: ch02.last.ns is the cell of row "last"
-- and column "ns" in one of the tables book/data/ch02-*.tsv. It must
-- be exactly one.
local faults = require "faults"
local files = require "files"

local values = {}
local tables = {} -- by name: { chapter, path, head, columns, rows }
local used        -- the cells that an expression has named so far

local function cells(line)
  local result = {}
  for cell in (line .. "\t"):gmatch("(.-)\t") do
    table.insert(result, cell)
  end
  return result
end

local function read(path)
  local name = files.name(path)
  local this = {
    name = name, path = path, chapter = name:match("^[^-]+"),
    head = {}, rows = {},
  }
  for number, line in ipairs(files.lines(path)) do
    local key, text = line:match("^#%s*([%w ]+):%s*(.-)%s*$")
    if key then
      this.head[key] = text
    elseif line:match("^#") or line == "" then
      -- only a remark
    elseif not this.columns then
      this.columns = cells(line)
    else
      local row = cells(line)
      if #row ~= #this.columns then
        faults.add(path, number, "%d cells, but %d columns",
          #row, #this.columns)
      end
      table.insert(this.rows, row)
    end
  end
  this.named = this.columns ~= nil and this.columns[1] == "name"
  return this
end

function values.load(paths)
  tables, used = {}, {}
  for _, path in ipairs(paths) do
    local this = read(path)
    tables[this.name] = this
  end
end

-- Every cell that chapter.row.column could mean.
local function find(chapter, row, column)
  local found, row_exists, rows, columns = {}, false, {}, {}
  for _, this in pairs(tables) do
    if this.chapter == chapter and this.named then
      for _, cells_of in ipairs(this.rows) do
        table.insert(rows, cells_of[1])
        if cells_of[1] == row then
          row_exists = true
          for i, name in ipairs(this.columns) do
            table.insert(columns, name)
            if name == column then
              table.insert(found, { cells_of[i], this.path })
            end
          end
        end
      end
    end
  end
  return found, row_exists, rows, columns
end

local function listed(words)
  local seen, list = {}, {}
  for _, word in ipairs(words) do
    if not seen[word] then
      seen[word] = true
      table.insert(list, word)
    end
  end
  table.sort(list)
  return table.concat(list, ", ")
end

local function complain(sentence, ...)
  error({ sentence = sentence:format(...) }, 0)
end

local function cell(chapter, row, column)
  local found, row_exists, rows, columns = find(chapter, row, column)
  if #rows == 0 then
    complain("%s has no table whose rows have names", chapter)
  end
  if #found == 1 then
    table.insert(used, { path = found[1][2], row = row, column = column })
    return tonumber(found[1][1]) or found[1][1]
  elseif #found > 1 then
    complain("%s.%s.%s could be a cell of %s or of %s",
      chapter, row, column, found[1][2], found[2][2])
  elseif row_exists then
    complain('no table of %s has a column "%s" in row "%s"; there are: %s',
      chapter, column, row, listed(columns))
  else
    complain('no table of %s has a row "%s"; there are: %s',
      chapter, row, listed(rows))
  end
end

-- What an expression may use: the tables of chapters, and arithmetic.
local function path_of(chapter)
  return setmetatable({}, { __index = function(_, row)
    return setmetatable({}, { __index = function(_, column)
      return cell(chapter, row, column)
    end })
  end })
end

local scope = setmetatable({
  abs = math.abs, ceil = math.ceil, exp = math.exp, floor = math.floor,
  log = math.log, max = math.max, min = math.min, pi = math.pi,
  sqrt = math.sqrt,
}, { __index = function(_, name)
  if name:match("^ch%d%d$") or name:match("^appendix") then
    return path_of(name)
  end
  complain('"%s" is not known here', name)
end })

-- The expression's value, or nil and what is wrong with it; and the
-- cells that it rests on.
function values.evaluate(expression)
  used = {}
  local chunk = load("return " .. expression, "=", "t", scope)
  if not chunk then
    return nil, ('"%s" is not an expression'):format(expression)
  end
  local good, result = pcall(chunk)
  if not good then
    if type(result) == "table" then return nil, result.sentence end
    return nil, ('"%s" cannot be computed: %s'):format(expression,
      tostring(result):gsub("^:?%d*:%s*", ""))
  end
  if type(result) == "table" or type(result) == "function" or
      result == nil then
    return nil, ('"%s" is not the name of a cell'):format(expression)
  end
  if type(result) == "number" and
      (result ~= result or result == math.huge or result == -math.huge) then
    return nil, ('"%s" is not a finite number'):format(expression)
  end
  return result, nil, used
end

-- ---- printing ------------------------------------------------------
local THIN = "\u{2009}"
local MINUS = "\u{2212}"

-- 13509 as 13,509; numbers below ten thousand stay together.
local function grouped(digits)
  local whole, rest = digits:match("^(%d+)(.*)$")
  if #whole >= 5 then
    whole = whole:reverse():gsub("(%d%d%d)", "%1,"):reverse():gsub("^,", "")
  end
  return whole .. rest
end

local superscripts = {
  ["-"] = "⁻", ["0"] = "⁰", ["1"] = "¹", ["2"] = "²", ["3"] = "³",
  ["4"] = "⁴", ["5"] = "⁵", ["6"] = "⁶", ["7"] = "⁷", ["8"] = "⁸",
  ["9"] = "⁹",
}

local function raised(exponent)
  return (tostring(exponent):gsub(".", superscripts))
end

-- So many significant digits, without an exponent while one can read
-- it: 0.00158, 3.25, 13,500, 4.20 × 10⁻⁹.
local function significant(x, digits)
  if x == math.floor(x) and math.abs(x) < 10 ^ digits then
    return grouped(("%.0f"):format(x))
  end
  local mantissa, exponent =
    (("%%.%de"):format(digits - 1)):format(x):match("^(.-)e(.*)$")
  exponent = math.tointeger(tonumber(exponent))
  if exponent < -7 then
    return mantissa .. THIN .. "×" .. THIN .. "10" .. raised(exponent)
  end
  local decimals = digits - 1 - exponent
  if decimals > 0 then
    return grouped(("%%.%df"):format(decimals):format(x))
  end
  return grouped(("%.0f"):format(tonumber(mantissa .. "e" .. exponent)))
end

local function signed(x, how)
  if x < 0 then return MINUS .. how(-x) end
  return how(x)
end

local units = {
  { 1, "ns", 1000 }, { 1e3, "µs", 1000 }, { 1e6, "ms", 1000 },
  { 1e9, "s", 120 }, { 60e9, "min", 120 }, { 3600e9, "h", math.huge },
}

-- A time in nanoseconds, in the unit that fits. What would be rounded
-- up to 1000 of a unit is 1.00 of the next.
local function seconds(ns, digits)
  for _, unit in ipairs(units) do
    local x = ns / unit[1]
    local rounded = tonumber(("%." .. digits .. "g"):format(x))
    if rounded < unit[3] then
      return significant(x, digits) .. THIN .. unit[2]
    end
  end
end

-- The value as text. `as` is nil, "integer", "percent" or "seconds";
-- digits are significant ones. nil and a reason if that is impossible.
function values.format(value, as, digits)
  digits = digits or 3
  if type(value) ~= "number" then
    if as then return nil, ('"%s" is not a number'):format(value) end
    return tostring(value)
  end
  if as == nil then
    return signed(value, function(x) return significant(x, digits) end)
  elseif as == "integer" then
    return signed(value, function(x)
      return grouped(("%.0f"):format(x))
    end)
  elseif as == "percent" then
    return signed(value, function(x)
      return significant(100 * x, digits) .. "%"
    end)
  elseif as == "seconds" then
    return signed(value, function(x) return seconds(x, digits) end)
  end
  return nil, ('as="%s" is neither integer, percent nor seconds'):format(as)
end

-- ---- where a table was measured -------------------------------------
local months = {
  "January", "February", "March", "April", "May", "June", "July",
  "August", "September", "October", "November", "December",
}

local function short_machine(text)
  return (text:gsub("%(R%)", ""):gsub("%(TM%)", ""):gsub("CPU @ [%w.]+", "")
    :gsub(" %d+%-Core", ""):gsub(" Processor", "")
    :gsub("%s+,", ","):gsub("%s%s+", " "))
end

local function long_date(text)
  local year, month, day = text:match("^(%d+)-(%d+)-(%d+)")
  if not year then return text end
  return ("%d %s %s"):format(day, months[tonumber(month)] or month, year)
end

-- The days of the first measurement and the latest, "23 to 26 November
-- 2026", or nil.
function values.measured()
  local first, latest
  for _, this in pairs(tables) do
    local date = this.head.date
    if date then
      first = first and first < date and first or date
      latest = latest and latest > date and latest or date
    end
  end
  if not latest then return nil end
  first, latest = long_date(first), long_date(latest)
  if first == latest then return latest end
  local day, month = first:match("^(%d+)( .*)$")
  if day and latest:sub(-#month) == month then first = day end
  return first .. " to " .. latest
end

-- Machine, compiler, flags and date of a table, as captions say it, and
-- `setup`, all of its head but the date; or nil and why not.
function values.provenance(name)
  local this = tables[name]
  if not this then return nil, ('there is no table "%s"'):format(name) end
  local head = this.head
  for _, key in ipairs { "machine", "compiler", "flags", "date" } do
    if not head[key] then
      return nil, ('the head of %s has no line "# %s: ..."')
        :format(this.path, key)
    end
  end
  local flags = {}
  for flag in head.flags:gmatch("%S+") do
    if flag:match("^%-O") or flag:match("^%-march") then
      table.insert(flags, flag)
    end
  end
  return {
    machine = short_machine(head.machine),
    compiler = head.compiler:gsub("^(%a+ %d+%.%d+)%S*.*$", "%1"),
    flags = table.concat(flags, " "),
    date = long_date(head.date),
    caches = head.caches ~= "unknown" and head.caches or nil,
    memory = head.memory,
    setup = table.concat({ head.machine, head.compiler, head.flags }, "\n"),
  }
end

return values
