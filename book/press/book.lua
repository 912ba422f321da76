-- The press inside pandoc: a filter that puts the book together. What
-- is to be read stands in job.lua, which press.lua has written; faults
-- and notes go back to it in files beside the job.
local job = dofile(os.getenv("PRESS_JOB"))
package.path = job.press .. "/?.lua;" .. package.path

local context = require "context"
local declared = require "declared"
local exercises = require "exercises"
local faults = require "faults"
local files = require "files"
local fragments = require "fragments"
local glossary = require "glossary"
local manual = require "manual"
local numbering = require "numbering"
local sheet = require "sheet"
local source = require "source"
local values = require "values"
local weave = require "weave"

local stringify = pandoc.utils.stringify

-- The keys of a BibTeX file.
local function keys_of(path)
  local keys = {}
  for _, line in ipairs(files.lines(path)) do
    local key = line:match("^%s*@%a+%s*{%s*([^,%s]+)%s*,")
    if key then keys[key] = true end
  end
  return keys
end

local book = {
  job = job, labels = {}, references = {}, cited = {},
  indexed = {}, sent = {}, terms = 0, mentions = {},
  fragments = fragments.read(job.code),
  bibliography = keys_of(job.bibliography),
}
values.load(job.data)
context.book = book
context.out = require(job.web and "webbook" or "printbook")

-- ---- parts and chapters ---------------------------------------------
-- The part a chapter belongs to: the last that begins at or before it.
local function part_of(parts, number)
  local found
  for i, part in ipairs(parts or {}) do
    if number >= tonumber(stringify(part.first)) then
      found = { number = i, title = stringify(part.title) }
    end
  end
  return found
end

local function exercises_of(chapter)
  local list = pandoc.List()
  for _, path in ipairs(chapter.number and job.exercises[chapter.id] or {}) do
    list:insert(exercises.read(job, chapter, path))
  end
  return list
end

-- A title of class "listings" opens pages that are made for programs.
local function made_for_listings(title, path)
  for _, class in ipairs(title.classes) do
    if class ~= "listings" then
      faults.add(path, 1, 'the class "%s" is unknown for a chapter', class)
    end
  end
  return title.classes[1] == "listings"
end

-- A chapter's blocks: its text, the answers, the exercises. The first
-- line of its file is its title.
local function read_chapter(path, chapter)
  local doc = pandoc.read(files.read(path), job.dialect)
  local text = source.open(path)
  local title = doc.blocks[1]
  if not title or title.t ~= "Header" or title.level ~= 1 then
    faults.add(path, 1, "a chapter begins with its title")
    title = pandoc.Header(1, { pandoc.Str("?") })
  else
    doc.blocks:remove(1)
  end
  chapter.path, chapter.source, chapter.answers = path, text, {}
  context.label("ch:" .. chapter.id, path, 1)
  chapter.for_listings = made_for_listings(title, path)
  local blocks = weave.text(chapter, doc.blocks)
  chapter.exercises = exercises_of(chapter)
  return context.out.chapter(chapter, pandoc.List(title.content), blocks)
end

-- ---- the whole book ---------------------------------------------------
local function assemble(meta)
  local blocks, chapters = pandoc.List(), {}
  local front = pandoc.read(files.read(job.front), job.dialect)
  for key, value in pairs(front.meta) do meta[key] = value end
  blocks:extend(context.out.front(weave.text({
    source = source.open(job.front), id = "front", front = true,
    answers = {} }, front.blocks)))
  local part
  for _, path in ipairs(job.chapters) do
    local id = files.id(path)
    local chapter = { id = id, number = tonumber(id:sub(3)) }
    local this = part_of(front.meta.parts, chapter.number)
    if this and (not part or part.number ~= this.number) then
      blocks:extend(context.out.part(this))
      part = this
    end
    blocks:extend(read_chapter(path, chapter))
    table.insert(chapters, chapter)
  end
  if #job.appendices > 0 then
    blocks:extend(context.out.appendices())
  end
  for _, path in ipairs(job.appendices) do
    blocks:extend(read_chapter(path, { id = files.name(path) }))
  end
  blocks:extend(glossary.read(job))
  blocks:extend(context.out.closing(chapters))
  return blocks
end

-- A single chapter or appendix, for whoever writes it: what is elsewhere
-- has its number, but no page.
local function only(meta)
  local front = pandoc.read(files.read(job.front), job.dialect)
  for key, value in pairs(front.meta) do meta[key] = value end
  meta.elsewhere = true
  meta["suppress-bibliography"] = true
  local blocks, is_appendix = pandoc.List(), false
  for _, list in ipairs { job.chapters, job.appendices } do
    for _, path in ipairs(list) do
      if files.id(path) == job.only then
        is_appendix = list == job.appendices
        blocks:extend(read_chapter(path, { id = job.only,
          number = tonumber(job.only:match("^ch(%d%d)$")) }))
      end
    end
  end
  blocks = context.out.only(blocks, is_appendix)
  blocks:insert(1, numbering.latex(numbering.of_book(job)))
  return blocks
end

-- Sources of numbers are in the bibliography, cited or not.
local function also_cited()
  local citations = pandoc.List()
  for key in pairs(book.cited) do
    citations:insert(pandoc.Citation(key, "NormalCitation"))
  end
  if #citations == 0 then return nil end
  return pandoc.MetaInlines { pandoc.Cite({ pandoc.Str("") }, citations) }
end

-- Chapters that front.md lists as "undeclared" are not yet held to it.
local function check_declared(meta)
  if job.sheet or job.manual or job.slides or job.export then
    return
  end
  local spared = {}
  for _, id in ipairs(meta.undeclared or {}) do
    spared[stringify(id)] = true
  end
  declared.check(job.chapters, book.fragments, spared, job.only)
end

function Pandoc(doc)
  if job.sheet then
    doc.blocks = sheet.assemble(job, doc.meta)
  elseif job.export then
    doc.blocks = require "export".assemble(job)
  elseif job.slides then
    doc.blocks = require "slides".assemble(job, doc.meta)
  elseif job.manual then
    doc.blocks = manual.assemble(job, doc.meta)
  elseif job.only then
    doc.blocks = only(doc.meta)
  else
    doc.blocks = assemble(doc.meta)
    fragments.check_shown(book.fragments)
    for _, mention in ipairs(book.mentions) do
      if not mention.fragment.shown then
        faults.add(mention.path, mention.line,
          'no chapter shows the fragment "%s", which is mentioned here',
          mention.fragment.title)
      end
    end
  end
  local measured = values.measured()
  doc.meta.measured = measured and pandoc.MetaString(measured)
  doc.meta.nocite = also_cited()
  doc.meta.version = job.version and pandoc.MetaString(job.version)
  context.out.meta(doc.meta, job)
  context.check_references()
  check_declared(doc.meta)
  files.write(job.folder .. "/faults", faults.report())
  files.write(job.folder .. "/notes", faults.report_notes())
  return doc
end
