-- Tables as LaTeX with rules above, below and under the head. Columns
-- of numbers are set right; if the whole is wider than the page, the
-- widest columns of words are broken into lines.
local tables = {}

local WIDTH = 77   -- characters of small type on a line of the page
local GAP = 3      -- characters between two columns
local WORDS = 18   -- a column this wide can be broken

local function tex(text)
  return pandoc.RawInline("latex", text)
end

-- A cell as one run of inlines, and what it will look like.
local function flatten(cell)
  local inlines = pandoc.utils.blocks_to_inlines(cell.contents or cell[5])
  return inlines, pandoc.utils.stringify(inlines)
end

-- Numbers, also with a unit, a sign, a factor; or nothing at all.
local function numeric(text)
  text = text:gsub("[\u{2009}\u{a0}]", " ")
  return text == "" or text == "–" or text == "—"
    or text:match("^[≈<>~]?%s*[−-]?%d[%d,.]*%s*[%%%a×µ]*$") ~= nil
      and #text < 16
end

-- l, r, c as the writer asked, or else by what the column holds.
local function alignment(spec, column)
  local asked = spec[1]
  if asked == "AlignRight" then return "r" end
  if asked == "AlignCenter" then return "c" end
  if asked == "AlignLeft" then return "l" end
  for _, text in ipairs(column) do
    if not numeric(text) then return "l" end
  end
  return "r"
end

local function rows_of(tbl)
  local head, body = {}, {}
  for _, row in ipairs(tbl.head.rows or tbl.head[2]) do
    table.insert(head, row.cells or row[2])
  end
  for _, part in ipairs(tbl.bodies) do
    for _, row in ipairs(part.body) do
      table.insert(body, row.cells or row[2])
    end
  end
  return head, body
end

-- The letters for tabularx, given the text of all cells by column. A
-- column must be broken (X) if the table does not fit otherwise.
local function columns(specs, heads, texts)
  local widths, letters, total = {}, {}, -GAP
  for i, spec in ipairs(specs) do
    letters[i] = alignment(spec, texts[i])
    widths[i] = 0
    for _, list in ipairs { heads[i], texts[i] } do
      for _, text in ipairs(list) do
        widths[i] = math.max(widths[i], utf8.len(text) or #text)
      end
    end
    total = total + widths[i] + GAP
  end
  local broken = false
  if total > WIDTH then
    for i, width in ipairs(widths) do
      if width > WORDS and letters[i] ~= "r" then
        letters[i] = "X"
        broken = true
      end
    end
  end
  return table.concat(letters), broken
end

-- The table as one Plain block of raw LaTeX and the cells' inlines.
function tables.latex(tbl)
  local head, body = rows_of(tbl)
  local heads, texts, out = {}, {}, pandoc.List()
  for i = 1, #tbl.colspecs do heads[i], texts[i] = {}, {} end

  local function row(cells, into, bold)
    for i, cell in ipairs(cells) do
      local inlines, text = flatten(cell)
      table.insert(into[i], text)
      if i > 1 then out:insert(tex(" & ")) end
      if bold then out:insert(tex("\\tablehead{")) end
      out:extend(inlines)
      if bold then out:insert(tex("}")) end
    end
    out:insert(tex(" \\\\\n"))
  end

  for _, cells in ipairs(head) do row(cells, heads, true) end
  if #head > 0 then out:insert(tex("\\midrule\n")) end
  for _, cells in ipairs(body) do row(cells, texts, false) end

  local letters, broken = columns(tbl.colspecs, heads, texts)
  local open = broken and "\\begin{tabularx}{\\linewidth}{@{}" .. letters
    or "\\begin{tabular}{@{}" .. letters
  local close = broken and "\\end{tabularx}" or "\\end{tabular}"
  out:insert(1, tex(open .. "@{}}\n\\toprule\n"))
  out:insert(tex("\\bottomrule\n" .. close))
  return pandoc.Plain(out)
end

return tables
