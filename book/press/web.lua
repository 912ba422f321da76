-- The web edition: what each thing of the text is in HTML. The printed
-- edition has the same functions, in print.lua. A link is "#id", whatever
-- page the id is on, and "@@label@@" stands for the number of what has
-- the label: webpages.lua knows both when all pages are there.
local context = require "context"
local files = require "files"
local html = require "html"
local tables = require "tables"
local weblisting = require "weblisting"

local edition = {
  format = "html",
  numbers = {}, -- of labels
  entries = {}, -- of the index, in the order of the text
  places = {},  -- where the glossary sends: the section of every place
}

local counters = {}  -- of a chapter: sections, figures, tables, ...
local sections = {}  -- the section of a chapter that we are in
local taken = {}     -- ids of titles

local function raw(text, ...)
  return pandoc.RawInline("html", select("#", ...) > 0
    and text:format(...) or text)
end

local function raw_block(text, ...)
  return pandoc.RawBlock("html", select("#", ...) > 0
    and text:format(...) or text)
end

edition.text, edition.raw_block = html.text, raw_block

-- ---- numbers --------------------------------------------------------------
-- 4 for chapter 4, B for the second appendix, "" elsewhere.
function edition.chapter_number(id)
  local number = id:match("^ch(%d%d)$")
  if number then return tostring(math.tointeger(tonumber(number))) end
  for i, path in ipairs(context.book.job.appendices) do
    if files.id(path) == id then return string.char(64 + i) end
  end
  return ""
end

-- The next number of its kind in this chapter, which is the label's.
local function number(kind, label)
  local id = context.here.id
  counters[id] = counters[id] or {}
  local n = (counters[id][kind] or 0) + 1
  counters[id][kind] = n
  local text = ("%s.%d"):format(edition.chapter_number(id), n)
  if label and label ~= "" then edition.numbers[label] = text end
  return text
end

-- ---- in a sentence ------------------------------------------------------
function edition.tie() return pandoc.Str("\u{a0}") end

function edition.code(text) return pandoc.Code(text) end

function edition.crossref(kind, label)
  return raw('<a href="#%s">%s\u{a0}@@%s@@</a>', label, kind, label)
end

-- What an expression rests on, in words, and the first of its rows.
local function rests_on(expression, cells)
  local paths, seen = {}, {}
  for _, cell in ipairs(cells or {}) do
    if not seen[cell.path] then table.insert(paths, cell.path) end
    seen[cell.path] = true
  end
  local first = cells and cells[1]
  return html.text(expression .. (first and "\u{2002}from "
    .. table.concat(paths, ", ") or "")), first and ("src:%s#row-%s")
    :format(first.path, html.slug(first.row))
end

-- A number leads to the row where it was measured.
function edition.value(text, expression, cells)
  local source, href = rests_on(expression, cells)
  if not href or context.in_title then return pandoc.Str(text) end
  return raw('<a class="value" href="%s" title="%s">%s</a>', href, source,
    html.text(text))
end

function edition.reported(content, by)
  content:insert(raw('<sup><a class="by" href="#ref-%s" '
    .. 'title="reported there">%s</a></sup>', by, by:sub(1, 1)))
  return content
end

-- A claim ends with a link to what it was checked with, which is seen
-- when the claim is pointed at, or the link has the focus.
function edition.claim(content, condition, holds, cells)
  if context.in_title then return content end
  local source, href = rests_on(condition or "?", cells)
  content:insert(1, raw('<span class="claim">'))
  if holds == false then
    content:insert(raw(' <em class="false">(on this machine it does not '
      .. 'hold)</em>'))
  end
  if href then
    content:insert(raw('<a class="checked" href="%s" title="%s"><span '
      .. 'class="unseen">%s</span></a>', href, source, holds and "checked"
      or "does not hold"))
  end
  content:insert(raw("</span>"))
  return content
end

function edition.mention(fragment)
  return raw("%s", weblisting.mention(fragment))
end

-- An entry of the index stands for this place, or sends to another one.
function edition.index(e)
  if e.see then
    table.insert(edition.entries, { entry = e.key or e.words, see = e.see,
      is_code = not e.key and e.is_code })
    return raw("")
  end
  local id = e.place or ("place:%d"):format(#edition.entries)
  local here = context.here.id
  edition.places[id] = sections[here] or edition.chapter_number(here)
  table.insert(edition.entries, { entry = e.key or e.words, id = id,
    is_code = not e.key and e.is_code })
  return raw('<span id="%s"></span>', id)
end

function edition.machine(where)
  local parts = {}
  for _, part in ipairs { "machine", "caches", "memory", "compiler" } do
    table.insert(parts, where[part] and html.text(where[part]))
  end
  table.insert(parts, "<code>" .. html.text(where.flags) .. "</code>")
  table.insert(parts, html.text(where.date))
  return raw("%s", table.concat(parts, ", "))
end

-- ---- blocks -------------------------------------------------------------
function edition.continued() return {} end
function edition.introduces() return {} end
function edition.asterism() return pandoc.HorizontalRule() end
function edition.paragraph(content) return content end

-- A caption begins with what is captioned, and its number.
local function captioned(caption, kind, text)
  caption:insert(1, raw('<span class="number">%s\u{a0}%s.</span> ', kind,
    text))
  return caption
end

-- How large it was drawn.
local function size(build, name)
  for _, folder in ipairs { "drawings", "figures" } do
    local svg = files.read(("%s/pictures/%s/%s.svg"):format(build, folder,
      name))
    local width, height = (svg or ""):match(
      '<svg[^>]- width="([%d.]+)[pt"][^>]- height="([%d.]+)')
    if width then return tonumber(width), tonumber(height) end
  end
  return 360, 240
end

local LARGER = 1.85 -- pixels of the screen for a point of print

function edition.figure(f)
  local width, height = size(context.book.job.build, f.name)
  return pandoc.List {
    raw_block('<figure class="picture" id="%s" data-figure="%s"><img '
      .. 'src="@ROOT@pictures/%s.svg" alt="%s" width="%.0f" height="%.0f" '
      .. 'loading="lazy"><figcaption>', f.label, f.name, f.name,
      html.text(f.alternative), width * LARGER, height * LARGER),
    pandoc.Plain(captioned(f.caption, "Figure", number("fig", f.label))),
    raw_block("</figcaption></figure>"),
  }
end

-- Within an exercise, titles stand below the exercise's own.
function edition.header(h)
  local kind, level, text = h.kind, h.level, nil
  if kind == "numbered" or kind == "unnumbered" then
    if level == 1 or level > 4 then return nil end
  elseif kind == "exercise" then
    level = 4
  end
  local id = h.label or context.here.id .. "-"
    .. html.slug(pandoc.utils.stringify(h.content))
  taken[id] = (taken[id] or 0) + 1
  if taken[id] > 1 then id = id .. "-" .. taken[id] end
  if kind == "numbered" and level == 2 then
    text = number("sec", h.label)
    sections[context.here.id] = text
    h.content:insert(1, raw('<span class="number">%s</span> ', text))
  elseif h.label then
    edition.numbers[h.label] = sections[context.here.id]
  end
  return pandoc.Header(level, h.content, pandoc.Attr(id))
end

-- The first column names the rows. What has a caption can be moved by
-- keys, and says which it is.
function edition.table(t)
  local tbl, attributes = tables.aligned(t.table), ""
  for _, part in ipairs(tbl.bodies) do part.row_head_columns = 1 end
  if t.caption then
    local text = number("tab", t.label)
    attributes = (' id="%s" tabindex="0" role="group" aria-label="Table %s"')
      :format(t.label or "", text)
    tbl.caption = { long = { pandoc.Plain(captioned(t.caption, "Table",
      text)) } }
  end
  return pandoc.List { raw_block('<div class="table"%s>', attributes),
    tbl, raw_block("</div>") }
end

-- The answer unfolds where the question is.
function edition.quick(q)
  local blocks = q.question
  blocks:insert(1, raw_block('<div class="quick" id="quick-%s"><p '
    .. 'class="kicker">Quick question %s.%d</p>', q.name,
    edition.chapter_number(context.here.id), q.number))
  blocks:insert(raw_block("<details><summary>Answer</summary>"))
  blocks:extend(q.answer)
  blocks:insert(raw_block("</details></div>"))
  return blocks, pandoc.List()
end

function edition.fragment(fragment)
  fragment.number = number("fragment")
  return raw_block("%s", weblisting.fragment(fragment, fragment.number))
end

function edition.illustration(lines, _, is_c)
  return raw_block("%s", weblisting.illustration(lines, is_c))
end

function edition.output(command, lines)
  return raw_block("%s", weblisting.output(command, lines))
end

function edition.exercise(e)
  local blocks = pandoc.List(e.blocks)
  edition.numbers[e.label] = e.number
  blocks:insert(1, raw_block('<section class="exercise" id="%s"><h3><span '
    .. 'class="number">Exercise %s</span> <i>%s</i></h3><p class="meta">'
    .. '<span role="img" aria-label="%d of 5 stars">%s</span>, %s, %d '
    .. 'points, %s</p>', e.label, e.number, e.title, e.stars,
    ("★"):rep(e.stars), e.time:gsub("~", "\u{a0}"), e.points,
    e.programmed and "programmed" or "on paper"))
  blocks:insert(raw_block('<p class="meta">%s%s</p></section>',
    e.needs ~= "" and "Needs " .. e.needs .. ". " or "", e.programmed
    and "<code>make exercise" .. e.number .. "</code>" or ""))
  return blocks
end

return edition
