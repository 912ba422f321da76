-- The slides of a chapter: chapters/slides/chNN.md, in which every title
-- of the second level begins a slide. What the chapter has is named, not
-- copied: drawings and plots, listings, values, and its aims, tables,
-- lessons and exercises, in blocks of those classes.
local context = require "context"
local alternative = require "alternative"
local exercises = require "exercises"
local faults = require "faults"
local files = require "files"
local inlines = require "inlines"
local latex = require "latex"
local listing = require "listing"
local numbering = require "numbering"
local find_picture = require "picture".find
local parts = require "parts"
local source = require "source"
local values = require "values"
local weave = require "weave"

local slides = {}

local LONGEST = 15  -- lines of a listing that can be read from afar

local raw, raw_block = context.raw, context.raw_block
local chapter       -- whose slides these are

local function fault(words, sentence, ...)
  return context.fault(words, sentence, ...)
end

-- ---- what is named in the chapter ---------------------------------------
local function named(part)
  return function()
    local result = parts.quote(chapter, chapter[part])
    result:insert(1, raw_block("\\begin{chapterpart}"))
    result:insert(raw_block("\\end{chapterpart}"))
    return result
  end
end

for _, part in ipairs { "aims", "needs", "learned" } do
  weave.code[part] = named(part)
  weave.code_attributes[part] = {}
end

-- "1 3-5" as a set of numbers, or all.
local function chosen(text)
  if not text then return nil end
  local set = {}
  for first, last in text:gmatch("(%d+)%-?(%d*)") do
    for i = first, tonumber(last) or first do set[math.tointeger(i)] = true end
  end
  return set
end

local function only(list, set)
  if not set then return pandoc.List(list) end
  local result = pandoc.List()
  for i, x in ipairs(list) do if set[i] then result:insert(x) end end
  return result
end

-- A table of the chapter, or some of its rows and columns.
weave.code_attributes.table = { rows = true, columns = true }
function weave.code.table(x, lines)
  local original = chapter.tables[lines[1]]
  if not original then
    fault(lines[1], "the chapter has no table %s", lines[1])
    return pandoc.List()
  end
  local copy = original:clone()
  local rows, columns = chosen(x.attributes.rows), chosen(x.attributes.columns)
  local head, bodies = copy.head, copy.bodies
  for _, row in ipairs(head.rows) do row.cells = only(row.cells, columns) end
  for _, body in ipairs(bodies) do
    body.body = only(body.body, rows)
    for _, row in ipairs(body.body) do row.cells = only(row.cells, columns) end
  end
  copy.caption = { long = {} }
  copy.colspecs = only(copy.colspecs, columns)
  copy.head, copy.bodies = head, bodies
  return parts.quote(chapter, { copy })
end

weave.code_attributes.exercises = {}
function weave.code.exercises()
  local lines = { "\\begin{slideexercises}" }
  for _, path in ipairs(context.book.job.exercises[chapter.id] or {}) do
    local doc = pandoc.read(files.read(path), context.book.job.dialect)
    local function say(key) return pandoc.utils.stringify(doc.meta[key]) end
    table.insert(lines, ("\\slideexercise{%d.%s}{%s}{%d}{%s}{%s}"):format(
      chapter.number, path:match("/(%d+)%-[^/]*/[^/]*$"),
      latex.text(say("title")), tonumber(say("stars")),
      exercises.time(tonumber(say("minutes"))), latex.text(say("trains"))))
  end
  table.insert(lines, "\\end{slideexercises}")
  return raw_block(table.concat(lines, "\n"))
end

-- A listing is shown as often as one likes, if it is short.
function weave.code.fragment(_, lines)
  local result = pandoc.List()
  for _, title in ipairs(lines) do
    title = title:match("^%s*(.-)%s*$")
    local fragment = context.book.fragments.by_title[title]
    if not fragment then
      fault(title, 'no fragment is called "%s"', title)
    else
      if #fragment.items > LONGEST then
        fault(title, '"%s" has %d lines, and a slide %d', title,
          #fragment.items, LONGEST)
      end
      result:insert(raw_block(listing.fragment(fragment)))
    end
  end
  return result
end

-- ---- a slide --------------------------------------------------------------
local function is_picture(block)
  local image = block.t == "Figure" and block.content[1].content[1]
    or block.t == "Para" and #block.content == 1 and block.content[1]
  return image and image.t == "Image" and image or nil
end

-- The command that sets a drawing or a plot.
local function picture(image)
  local name, build = image.src, context.book.job.build
  local pdf, page = find_picture(build, "slides/figures", name)
  if not pdf then
    fault("(" .. name .. ")", "there is no figure %s", name)
    return ""
  end
  return ("{%s}{%s}{%s}"):format(pdf, page, latex.text(alternative.of(name)))
end

local div = weave.block.Div
function weave.block.Div(x)
  if x.classes[1] ~= "predict" then return div(x) end
  local result = weave.blocks(x.content)
  result:insert(1, raw_block("\\begin{predict}"))
  result:insert(raw_block("\\end{predict}"))
  return result
end

-- The text before the picture and behind it are measured, and the picture
-- gets what is left; beside it, the text has the left half.
local function with_picture(blocks, at, here)
  local image = is_picture(blocks[at])
  local before = pandoc.List { table.unpack(blocks, 1, at - 1) }
  local after = pandoc.List { table.unpack(blocks, at + 1) }
  if image.classes[1] == "beside" then
    before:extend(after)
    local result = weave.text(here, before)
    result:insert(1, raw_block("\\begin{besidetext}"))
    result:insert(raw_block("\\end{besidetext}\\besidepicture" ..
      picture(image)))
    return result
  end
  local result = pandoc.List()
  for i, part in ipairs { before, after } do
    local name = i == 1 and "textbefore" or "textafter"
    result:insert(raw_block("\\begin{" .. name .. "}"))
    result:extend(weave.text(here, part))
    result:insert(raw_block("\\end{" .. name .. "}"))
  end
  result:insert(raw_block("\\slidepicture" .. picture(image)))
  return result
end

local function slide(title, blocks, here)
  here.source:seek(pandoc.utils.stringify(title))
  context.here = here
  local head = inlines.checked(title.content)
  head:insert(1, raw(context.mark(here.source.cursor)
    .. "\\begin{frame}[t]\\frametitle{"))
  head:insert(raw("}"))
  local at
  for i, block in ipairs(blocks) do
    if is_picture(block) then
      if at then fault(is_picture(block).src, "a slide has one picture") end
      at = at or i
    end
  end
  local result = at and with_picture(blocks, at, here)
    or weave.text(here, blocks)
  result:insert(1, pandoc.Plain(head))
  result:insert(raw_block("\\end{frame}"))
  return result
end

-- On what the chapter's first measurement was made.
local function machine()
  local name = files.read(chapter.path):match("%[([%w-]+)%]{%.machine}")
  local where = name and values.provenance(name)
  return where and ("%s, %s, %s"):format(latex.text(where.machine),
    latex.text(where.compiler or ""), latex.text(where.date)) or ""
end

-- The slides of one file.
local function read(job, path)
  local id = files.id(path)
  chapter = nil
  for _, text in ipairs(job.chapters) do
    if files.id(text) == id then chapter = parts.read(job, text) end
  end
  if not chapter then
    faults.add(path, 1, "there is no chapter %s", id)
    return pandoc.List()
  end
  local doc = pandoc.read(files.read(path), job.dialect)
  local here = { source = source.open(path), id = id, answers = {} }
  local blocks, title, held = pandoc.List(), nil, pandoc.List()
  local function close()
    if title then blocks:extend(slide(title, held, here)) end
    held = pandoc.List()
  end
  for _, block in ipairs(doc.blocks) do
    if block.t == "Header" and block.level == 2 then
      close()
      title = block
    elseif not title then
      faults.add(path, 1, "slides begin with a title: ## ...")
    else
      held:insert(block)
    end
  end
  close()
  blocks:insert(1, raw_block(("\\titleslide{%d}{%s}{%s}"):format(
    chapter.number, latex.text(pandoc.utils.stringify(chapter.title)),
    machine())))
  return blocks
end

function slides.assemble(job, meta)
  meta["suppress-bibliography"] = true
  local numbers = numbering.of_book(job)
  local blocks = pandoc.List()
  for _, path in ipairs(job.slides) do blocks:extend(read(job, path)) end
  blocks:insert(1, numbering.latex(numbers))
  meta.title = chapter
    and pandoc.MetaString(pandoc.utils.stringify(chapter.title))
  return blocks
end

return slides
