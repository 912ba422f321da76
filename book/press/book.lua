-- The press inside pandoc: a filter that puts the book together. What
-- is to be read stands in job.lua, which press.lua has written; faults
-- and notes go back to it in files beside the job.
local job = dofile(os.getenv("PRESS_JOB"))
package.path = job.press .. "/?.lua;" .. package.path

local context = require "context"
local declared = require "declared"
local emblem = require "emblem"
local exercises = require "exercises"
local faults = require "faults"
local files = require "files"
local fragments = require "fragments"
local glossary = require "glossary"
local latex = require "latex"
local manual = require "manual"
local numbering = require "numbering"
local sheet = require "sheet"
local source = require "source"
local values = require "values"
local weave = require "weave"

local stringify = pandoc.utils.stringify

local function raw_block(text, ...)
  return pandoc.RawBlock("latex", text:format(...))
end

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

local function exercises_of(chapter, list)
  local result, listed = pandoc.List(), #list
  for _, path in ipairs(job.exercises[chapter.id] or {}) do
    local exercise = exercises.read(job, chapter, path)
    if #result == 0 then
      result:insert(raw_block("\\exercises{%s}", chapter.id))
    end
    if exercise then
      result:extend(exercises.printed(exercise))
      if #list == listed and listed > 0 then
        table.insert(list, "\\nextchapterslines")
      end
      table.insert(list, exercises.line(exercise))
    end
  end
  return result
end

local function answers_to(chapter)
  local result = pandoc.List()
  if #chapter.answers > 0 then
    result:insert(raw_block("\\answers{%s}", chapter.id))
  end
  for _, answer in ipairs(chapter.answers) do result:extend(answer) end
  return result
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
local function read_chapter(path, chapter, exercise_list)
  local doc = pandoc.read(files.read(path), job.dialect)
  local text = source.open(path)
  local title = doc.blocks[1]
  if not title or title.t ~= "Header" or title.level ~= 1 then
    faults.add(path, 1, "a chapter begins with its title")
    title = pandoc.Header(1, { pandoc.Str("?") })
  else
    doc.blocks:remove(1)
  end
  chapter.source, chapter.answers = text, {}
  context.label("ch:" .. chapter.id, path, 1)
  local blocks = weave.text(chapter, doc.blocks)
  local opened = pandoc.Plain(title.content)
  opened.content:insert(1, pandoc.RawInline("latex",
    ("\\pressat{%s:1}\\openchapter{%s}{%s}{"):format(path, chapter.id,
      chapter.number or "")))
  opened.content:insert(pandoc.RawInline("latex", "}"))
  blocks:insert(1, opened)
  blocks:extend(answers_to(chapter))
  if chapter.number then
    blocks:extend(exercises_of(chapter, exercise_list))
  end
  blocks:insert(raw_block("\\closechapter{%s}", chapter.id))
  if made_for_listings(title, path) then
    blocks:insert(1, raw_block("\\openlistings"))
    blocks:insert(raw_block("\\closelistings"))
  end
  return blocks
end

-- ---- the lists at the end ---------------------------------------------
-- For every file the pages that print some of it, in its own order.
local function index_of_files()
  local labels, paths = {}, {}
  for _, fragment in ipairs(book.fragments.list) do
    local path = fragment.file
    if fragment.shown and not labels[path] then
      labels[path] = {}
      table.insert(paths, path)
    end
    if fragment.shown then
      table.insert(labels[path], ("frag:%d"):format(fragment.id))
    end
  end
  table.sort(paths)
  local lines, folder = { "\\fileindex" }, nil
  for _, path in ipairs(paths) do
    local this = path:match("^(.*)/")
    if folder and this ~= folder then table.insert(lines, "\\indexspace") end
    folder = this
    table.insert(lines, ("\\fileindexline{%s}{%s}"):format(
      latex.text(path:gsub("^code/", "")), table.concat(labels[path], ",")))
  end
  table.insert(lines, "\\closefileindex")
  return raw_block("%s", table.concat(lines, "\n"))
end

local function assemble(meta)
  local blocks, exercise_list = pandoc.List(), {}
  local front = pandoc.read(files.read(job.front), job.dialect)
  for key, value in pairs(front.meta) do meta[key] = value end
  blocks:insert(raw_block("\\frontmatter\\makebook"))
  blocks:extend(weave.text({ source = source.open(job.front),
    id = "front", front = true, answers = {} }, front.blocks))
  blocks:insert(raw_block("\\mainmatter"))
  local part
  for _, path in ipairs(job.chapters) do
    local id = files.id(path)
    local number = tonumber(id:sub(3))
    local this = part_of(front.meta.parts, number)
    if this and (not part or part.number ~= this.number) then
      blocks:insert(raw_block("\\openpart{%d}{%s}", this.number,
        latex.text(this.title)))
      part = this
    end
    blocks:extend(read_chapter(path, { id = id, number = number },
      exercise_list))
  end
  if #job.appendices > 0 then
    blocks:insert(raw_block("\\openappendices"))
  end
  for _, path in ipairs(job.appendices) do
    blocks:extend(read_chapter(path, { id = files.name(path) },
      exercise_list))
  end
  blocks:extend(glossary.read(job))
  blocks:insert(raw_block("\\openbackmatter"))
  if #exercise_list > 0 then
    blocks:insert(raw_block(
      "\\begin{listofexercises}\n%s\n\\end{listofexercises}",
      table.concat(exercise_list, "\n")))
  end
  blocks:insert(index_of_files())
  blocks:insert(raw_block("\\literature"))
  blocks:insert(pandoc.Div({}, { id = "refs" }))
  blocks:insert(raw_block("\\printindex"))
  return blocks
end

-- A single chapter or appendix, for whoever writes it: what is elsewhere
-- has its number, but no page.
local function only(meta)
  local front = pandoc.read(files.read(job.front), job.dialect)
  for key, value in pairs(front.meta) do meta[key] = value end
  meta.elsewhere = true
  meta["suppress-bibliography"] = true
  local blocks = pandoc.List()
  for _, list in ipairs { job.chapters, job.appendices } do
    for _, path in ipairs(list) do
      if files.id(path) == job.only then
        if list == job.appendices then
          blocks:insert(raw_block("\\openappendices"))
        end
        blocks:extend(read_chapter(path, { id = job.only,
          number = tonumber(job.only:match("^ch(%d%d)$")) }, {}))
      end
    end
  end
  blocks:insert(1, raw_block("\\mainmatter"))
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
  doc.meta.emblem = pandoc.MetaInlines { pandoc.RawInline("latex", emblem) }
  doc.meta.figures = pandoc.MetaInlines { pandoc.RawInline("latex",
    ("{%s/figures/}{%s/drawings/}"):format(job.slides
      and job.build .. "/slides" or job.build, job.build)) }
  context.check_references()
  check_declared(doc.meta)
  files.write(job.folder .. "/faults", faults.report())
  files.write(job.folder .. "/notes", faults.report_notes())
  return doc
end
