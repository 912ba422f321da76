-- The printed edition: what each thing of the text is in LaTeX, in the
-- words of template.tex. The web edition has the same functions, in
-- web.lua; weave.lua and what it calls know neither.
local context = require "context"
local latex = require "latex"
local listing = require "listing"
local tables = require "tables"

local edition = { format = "latex" }

local raw, raw_block, mark = context.raw, context.raw_block, context.mark

-- Words that are not from a paragraph: titles, names.
edition.text = latex.text

-- ---- in a sentence ------------------------------------------------------
function edition.tie() return raw("~") end

function edition.code(text) return raw(latex.inline_code(text)) end

function edition.crossref(kind, label)
  return raw(("\\crossref{%s}{%s}"):format(kind, label))
end

-- The text of a value: plain, but for the space before its unit and an
-- exponent.
function edition.value(text)
  local result = pandoc.List()
  local number, unit = text:match("^(.-)\u{2009}(%D*)$")
  if number then
    result:extend { pandoc.Str(number), raw("\\,"), pandoc.Str(unit) }
  elseif text:find("\u{2009}") then
    result:insert(raw(latex.text(text)))
  else
    result:insert(pandoc.Str(text))
  end
  return result
end

function edition.reported(content, by)
  content:insert(raw(("\\%s{%s}{%s}"):format(context.in_table
    and "reportedintable" or "reported", by, by:sub(1, 1))))
  return content
end

function edition.claim(content, _, holds)
  if holds == false then content:insert(raw("\\doesnothold{}")) end
  return content
end

function edition.mention(fragment)
  return raw(listing.mention(fragment))
end

-- What makeindex would take for its own.
local function index_safe(text)
  return (text:gsub('[!@|"]', '"%0'))
end

-- makeindex knows nothing of accents.
local plain = { ["á"] = "a", ["ä"] = "a", ["é"] = "e", ["è"] = "e",
  ["ï"] = "i", ["ö"] = "o", ["ü"] = "u" }

local function in_its_place(entry)
  local sorted = entry:gsub("[\xc2-\xdf][\x80-\xbf]", plain)
  return sorted == entry and entry or sorted .. "@" .. entry
end

-- An entry of the index: a key, or else its words, which may be code;
-- where the glossary sends, its place; the entry that this one sends to.
function edition.index(e)
  local entry
  if e.key then
    entry = in_its_place(latex.text(e.key:gsub('[@|"]', '"%0')))
  elseif e.is_code then
    entry = e.words:gsub("[^%w ]", "") .. "@" ..
      index_safe(latex.inline_code(e.words))
  else
    entry = latex.text(index_safe(e.words))
  end
  if e.see then
    entry = ("%s|see{%s}"):format(entry, latex.text(index_safe(e.see)))
  end
  return raw((e.place and "\\termplace{" .. e.place .. "}" or "")
    .. "\\index{" .. entry .. "}")
end

function edition.machine(where)
  local parts = { latex.text(where.machine) }
  for _, part in ipairs { "caches", "memory", "compiler" } do
    if where[part] then
      table.insert(parts, (latex.text(where[part]):gsub("[^,]+",
        function(words) return "\\mbox{" .. words:gsub("^ ", "") .. "}" end)
        :gsub(",", ", ")))
    end
  end
  table.insert(parts, latex.inline_code(where.flags))
  table.insert(parts, "\\mbox{" .. latex.text(where.date) .. "}")
  return raw(table.concat(parts, ", "))
end

-- ---- blocks -------------------------------------------------------------
-- After a listing, the sentence goes on.
function edition.continued()
  return { raw_block("\\continued") }
end

-- What stands before a listing or a small table introduces it.
function edition.introduces()
  return { raw_block("\\introduces") }
end

function edition.asterism() return raw_block("\\asterism") end

function edition.paragraph(content, line)
  content:insert(1, raw(mark(line)))
  return content
end

local function captioned(caption, label)
  caption:insert(1, raw("\\caption{" .. (label and "\\label{" .. label .. "}"
    or "")))
  caption:insert(raw("}"))
  return pandoc.Plain(caption)
end

function edition.figure(f)
  local plot = f.pdf and ("\\plot{%s}{%s}{%s}"):format(f.pdf, f.page,
    latex.pdf_text(f.alternative)) or ""
  return pandoc.List {
    raw_block(("%s\\begin{figure}\\centering\n%s"):format(mark(f.line), plot)),
    captioned(f.caption, f.label), raw_block("\\end{figure}"),
  }
end

-- Titles: of the front matter, of chapters, without a number.
local titles = {
  exercise = { "exercisehead", "exercisehead", "exercisehead",
    "exercisehead", "exercisehead", "exercisehead" },
  front = { "addchap", "section*", "subsection*" },
  numbered = { false, "section", "subsection", "subsubsection" },
  unnumbered = { false, "section*", "subsection*", "subsubsection*" },
}

-- A title, or nil if there is none of this level.
function edition.header(h)
  local command = titles[h.kind][h.level]
  if not command then return nil end
  h.content:insert(1, raw(mark(h.line) .. "\\" .. command .. "{"))
  h.content:insert(raw("}"))
  if h.label then h.content:insert(raw("\\label{" .. h.label .. "}")) end
  return pandoc.Plain(h.content)
end

function edition.table(t)
  local set = tables.latex(t.table)
  if not t.caption then
    return pandoc.List { raw_block(mark(t.line) .. "\\begin{smalltable}"),
      set, raw_block("\\end{smalltable}") }
  end
  return pandoc.List {
    raw_block(mark(t.line) .. "\\begin{table}"),
    captioned(t.caption, t.label),
    raw_block("\\centering\\tablefont"), set, raw_block("\\end{table}"),
  }
end

-- The question for here, and the answer for the end of the chapter.
function edition.quick(q)
  q.question:insert(1, raw_block(
    ("%s\\begin{quick}{%s}"):format(mark(q.line), q.name)))
  q.question:insert(raw_block("\\end{quick}"))
  q.answer:insert(1, raw_block(("\\begin{quickanswer}{%s}"):format(q.name)))
  q.answer:insert(raw_block("\\end{quickanswer}"))
  return q.question, q.answer
end

function edition.fragment(fragment, line)
  return raw_block(mark(line) .. listing.fragment(fragment))
end

-- Code that is no part of a program; or what is not even code.
function edition.illustration(lines, line, is_c)
  return raw_block(mark(line) .. (is_c and listing.illustration
    or listing.plain)(lines))
end

function edition.output(command, lines, line)
  return raw_block(mark(line) .. listing.output(command, lines))
end

-- ---- exercises ----------------------------------------------------------
function edition.exercise(e)
  local blocks = pandoc.List(e.blocks)
  blocks:insert(1, raw_block(
    ("\\pressat{%s:1}\\exercise{%s}{%s}{%s}{%d}{%s}{%d}{%s}"):format(e.path,
      e.number, e.label, e.title, e.stars, e.time,
      e.points, e.programmed and "programmed" or "on paper")))
  blocks:insert(raw_block(("\\tryexercise{%s}{%s}"):format(e.needs,
    e.programmed and e.number or "")))
  return blocks
end

-- ---- the glossary ---------------------------------------------------------
function edition.glossary_line(g)
  local result = pandoc.List { raw("\\glossaryline{") }
  result:extend(g.term)
  result:insert(raw("}{"))
  result:extend(g.definition)
  result:insert(raw("}{"))
  result:extend(g.synonyms)
  result:insert(raw(g.place
    and ("}{\\hyperref[%s]{Page~\\pageref*{%s}}.}"):format(g.place, g.place)
    or ("}{\\crossref{Chapter}{ch:%s}.}"):format(g.chapter)))
  return pandoc.Plain(result)
end

function edition.glossary(lines)
  lines:insert(1, raw_block(mark(1) .. "\\openglossary"))
  lines:insert(raw_block("\\closeglossary"))
  return lines
end

return edition
