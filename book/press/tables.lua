-- Tables as LaTeX with rules above, below and under the head. Columns
-- of numbers are set right. If the whole is wider than the page, long
-- heads go into two lines, and then the widest columns of words are
-- broken, too.
local context = require "context"

local tables = {}

local WIDTH = 77   -- characters of small type on a line of the page
local GAP = 3      -- characters between two columns
local WORDS = 18   -- a column this wide can be broken
local LEFT = 24    -- and needs so many characters on a line

local raw = context.raw

-- What LaTeX makes of its own: code, a reference, a unit. Code is wider.
-- Of what is already HTML, the words between the tags.
local function visible(raw_text, format)
  if format == "html" then
    return (raw_text:gsub("<sup>.*", ""):gsub("<[^>]*>", "")
      :gsub("@@.-@@", "1.1"):gsub("\u{2009}", " "))
  end
  local label = raw_text:match("^\\crossref{(%a+)}")
  if label then return label .. " 1.1" end
  local text = raw_text:gsub("\\index%b{}", ""):gsub("\\termplace%b{}", "")
    :gsub("\\_", "_"):gsub("\\%a+", ""):gsub("[{}\\]", "")
  return raw_text:find("\\code") and text .. ("m"):rep(#text // 5) or text
end

-- A cell as one run of inlines, with what it will look like.
local function flatten(cell)
  local inlines = pandoc.utils.blocks_to_inlines(cell.contents)
  local shown = pandoc.walk_block(pandoc.Plain(inlines), {
    RawInline = function(x)
      return pandoc.Str(visible(x.text, x.format)) end })
  return { inlines = inlines,
    text = pandoc.utils.stringify(shown.content) }
end

local function width(text)
  return utf8.len(text) or #text
end

-- A number, also with a sign, a factor, a unit; or nothing at all.
local function numeric(text)
  text = text:gsub("\u{a0}", " "):gsub("\u{2212}", "-")
    :gsub("\u{d7}", "x"):gsub("\u{b5}", "u")
  return text == "" or text == "\u{2013}" or text == "\u{2014}"
    or width(text) < 16 and text:match("^[<>~]?%s*%-?%d[%d,.]*%s*[%%%a]*$")
      ~= nil
end

-- l, r, c as the writer asked, or else by what the column holds.
local letters = { AlignLeft = "l", AlignRight = "r", AlignCenter = "c" }

local function letter(spec, column)
  if letters[spec[1]] then return letters[spec[1]] end
  for _, cell in ipairs(column.cells) do
    if not numeric(cell.text) then return "l" end
  end
  return "r"
end

-- The columns of the table, each with its head and its cells.
local function columns_of(tbl)
  local columns = {}
  for i in ipairs(tbl.colspecs) do columns[i] = { cells = {} } end
  for _, row in ipairs(tbl.head.rows) do
    for i, cell in ipairs(row.cells) do columns[i].head = flatten(cell) end
  end
  for _, part in ipairs(tbl.bodies) do
    for _, row in ipairs(part.body) do
      for i, cell in ipairs(row.cells) do
        table.insert(columns[i].cells, flatten(cell))
      end
    end
  end
  for i, column in ipairs(columns) do
    column.letter = letter(tbl.colspecs[i], column)
    column.width = 0
    for _, cell in ipairs(column.cells) do
      column.width = math.max(column.width, width(cell.text))
    end
    column.head_width = column.head and width(column.head.text) or 0
  end
  return columns
end

local function total(columns)
  local sum = -GAP
  for _, column in ipairs(columns) do
    sum = sum + math.max(column.width, column.head_width) + GAP
  end
  return sum
end

-- Where the columns of a table that is written otherwise stand: of
-- numbers, at the right.
function tables.aligned(tbl)
  local specs = {}
  for i, column in ipairs(columns_of(tbl)) do
    specs[i] = { column.letter == "r" and "AlignRight"
      or column.letter == "c" and "AlignCenter" or "AlignLeft", nil }
  end
  tbl.colspecs = specs
  return tbl
end

-- Puts a head into two lines of about the same length.
local function break_head(column)
  local inlines = column.head.inlines
  local best, at = column.head_width, nil
  for i, x in ipairs(inlines) do
    if x.t == "Space" or x.t == "SoftBreak" then
      local left = pandoc.List(table.move(inlines, 1, i - 1, 1, {}))
      local right = pandoc.List(table.move(inlines, i + 1, #inlines, 1, {}))
      local wide = math.max(width(pandoc.utils.stringify(left)),
        width(pandoc.utils.stringify(right)))
      if wide < best then best, at = wide, i end
    end
  end
  if at then
    inlines[at] = raw("\\\\")
    inlines:insert(1, raw("\\begin{tabular}[b]{@{}" .. column.letter ..
      "@{}}"))
    inlines:insert(raw("\\end{tabular}"))
    column.head_width = best
  end
end

-- Makes the table fit. Returns whether a column of words is broken.
local function fit(columns)
  if total(columns) <= WIDTH then return false end
  for _, column in ipairs(columns) do
    if column.head_width > column.width then break_head(column) end
  end
  if total(columns) <= WIDTH then return false end
  -- The widest first, until what is left for them is wide enough.
  local order, broken = table.move(columns, 1, #columns, 1, {}), 0
  table.sort(order, function(a, b) return a.width > b.width end)
  for _, column in ipairs(order) do
    local room = WIDTH - total(columns)
    for _, other in ipairs(columns) do
      if other.letter == "Y" then
        room = room + math.max(other.width, other.head_width)
      end
    end
    if column.letter ~= "r" and column.width > WORDS
      and (broken == 0 or room < LEFT * broken) then
      column.letter = "Y"
      broken = broken + 1
    end
  end
  return broken > 0
end

-- The table as one Plain block of raw LaTeX and the cells' inlines.
function tables.latex(tbl)
  local columns = columns_of(tbl)
  local broken = fit(columns)
  local out, spec = pandoc.List(), "@{}"
  for _, column in ipairs(columns) do spec = spec .. column.letter end
  out:insert(raw((broken and "\\begin{tabularx}{\\linewidth}{%s@{}}"
    or "\\begin{tabular}{%s@{}}"):format(spec) .. "\n\\toprule\n"))

  local function row(cell_of, style)
    for i, column in ipairs(columns) do
      if i > 1 then out:insert(raw(" & ")) end
      out:insert(raw(style .. "{"))
      out:extend(cell_of(column).inlines)
      out:insert(raw("}"))
    end
    out:insert(raw(" \\\\\n"))
  end

  if columns[1].head then
    row(function(column) return column.head end, "\\tablehead")
    out:insert(raw("\\midrule\n"))
  end
  for i in ipairs(columns[1].cells) do
    row(function(column) return column.cells[i] end, "")
  end
  out:insert(raw("\\bottomrule\n" ..
    (broken and "\\end{tabularx}" or "\\end{tabular}")))
  return pandoc.Plain(out)
end

return tables
