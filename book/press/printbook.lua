-- The printed edition's larger parts: front matter, parts, chapters, and
-- the lists at the end. These functions join those of print.lua.
local context = require "context"
local edition = require "print"
local emblem = require "emblem"
local latex = require "latex"

local raw_block = context.raw_block

function edition.front(blocks)
  blocks:insert(1, raw_block("\\frontmatter\\makebook"))
  blocks:insert(raw_block("\\mainmatter"))
  return blocks
end

function edition.part(part)
  return { raw_block(("\\openpart{%d}{%s}"):format(part.number,
    latex.text(part.title))) }
end

function edition.appendices()
  return { raw_block("\\openappendices") }
end

local function exercises_of(chapter)
  local result = pandoc.List()
  if #chapter.exercises > 0 then
    result:insert(raw_block(("\\exercises{%s}"):format(chapter.id)))
  end
  for _, e in ipairs(chapter.exercises) do
    result:extend(edition.exercise(e))
  end
  return result
end

local function answers_to(chapter)
  local result = pandoc.List()
  if #chapter.answers > 0 then
    result:insert(raw_block(("\\answers{%s}"):format(chapter.id)))
  end
  for _, answer in ipairs(chapter.answers) do result:extend(answer) end
  return result
end

-- Its text, the answers, the exercises; some pages are made for listings.
function edition.chapter(chapter, title, blocks)
  title:insert(1, pandoc.RawInline("latex",
    ("\\pressat{%s:1}\\openchapter{%s}{%s}{"):format(chapter.path,
      chapter.id, chapter.number or "")))
  title:insert(pandoc.RawInline("latex", "}"))
  blocks:insert(1, pandoc.Plain(title))
  blocks:extend(answers_to(chapter))
  blocks:extend(exercises_of(chapter))
  blocks:insert(raw_block(("\\closechapter{%s}"):format(chapter.id)))
  if chapter.for_listings then
    blocks:insert(1, raw_block("\\openlistings"))
    blocks:insert(raw_block("\\closelistings"))
  end
  return blocks
end

-- ---- the lists at the end ---------------------------------------------
local function exercise_line(e)
  return ("\\exerciseline{%s}{%s}{%s}{%d}{%s}{%d}{%s}{%s}"):format(e.number,
    e.label, e.title, e.stars, e.time, e.points,
    e.programmed and "program" or "paper", e.trains)
end

local function list_of_exercises(chapters)
  local lines = {}
  for _, chapter in ipairs(chapters) do
    if #lines > 0 and #chapter.exercises > 0 then
      table.insert(lines, "\\nextchapterslines")
    end
    for _, e in ipairs(chapter.exercises) do
      table.insert(lines, exercise_line(e))
    end
  end
  return #lines > 0 and raw_block(
    ("\\begin{listofexercises}\n%s\n\\end{listofexercises}"):format(
    table.concat(lines, "\n"))) or nil
end

-- For every file the pages that print some of it, in its own order.
local function index_of_files()
  local labels, paths = {}, {}
  for _, fragment in ipairs(context.book.fragments.list) do
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
  return raw_block(table.concat(lines, "\n"))
end

function edition.closing(chapters)
  local blocks = pandoc.List { raw_block("\\openbackmatter") }
  local list = list_of_exercises(chapters)
  if list then blocks:insert(list) end
  blocks:extend { index_of_files(), raw_block("\\literature"),
    pandoc.Div({}, { id = "refs" }), raw_block("\\printindex") }
  return blocks
end

function edition.only(blocks, is_appendix)
  if is_appendix then blocks:insert(1, raw_block("\\openappendices")) end
  blocks:insert(1, raw_block("\\mainmatter"))
  return blocks
end

-- What the template wants to know.
function edition.meta(meta, job)
  meta.emblem = pandoc.MetaInlines { pandoc.RawInline("latex", emblem) }
  meta.figures = pandoc.MetaInlines { pandoc.RawInline("latex",
    ("{%s/figures/}{%s/drawings/}"):format(job.slides
      and job.build .. "/slides" or job.build, job.build)) }
end

return edition
