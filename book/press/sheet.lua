-- An assignment: chosen exercises on a few pages, with points, and how
-- to work on them. The book's figures, tables and exercises keep their
-- numbers.
local context = require "context"
local exercises = require "exercises"
local files = require "files"
local latex = require "latex"
local numbering = require "numbering"
local source = require "source"
local weave = require "weave"

local sheet = {}

local function raw_block(text, ...)
  return pandoc.RawBlock("latex", text:format(...))
end

-- ---- the pages --------------------------------------------------------
local function read(job, path)
  local id = path:match("^exercises/(ch%d%d)/")
  return exercises.read(job, { id = id, number = tonumber(id:sub(3)) }, path)
end

-- "3 exercises, 30 points, about 3 h"
local function sum(list)
  local points, minutes = 0, 0
  for _, exercise in ipairs(list) do
    points, minutes = points + exercise.points, minutes + exercise.minutes
  end
  return ("%d exercise%s, %d points, about %s"):format(#list,
    #list == 1 and "" or "s", points, exercises.time(exercises.roughly(minutes)))
end

-- Whether there will be a list of literature.
local function cites(blocks)
  local found = next(context.book.cited) ~= nil
  pandoc.walk_block(pandoc.Div(blocks), {
    Cite = function() found = true end })
  return found
end

-- What it needs, and the chapter in which that is explained.
local function read_in(exercise)
  local chapter = exercise.number:match("^%d+")
  return ("%s%sChapter~%s"):format(exercise.needs,
    exercise.needs == "" and "" or ", from ", chapter)
end

-- The course and its instructor, as `make sheet` was told, or neither.
local function whose()
  local said = {}
  for _, name in ipairs { "COURSE", "INSTRUCTOR" } do
    local value = (os.getenv(name) or ""):gsub("%s+", " ")
    if value ~= "" then table.insert(said, value) end
  end
  return table.concat(said, ", ")
end

function sheet.assemble(job, meta)
  meta.sheet = true
  meta.title = pandoc.MetaString(job.sheet.title)
  local list, blocks = {}, pandoc.List()
  for _, path in ipairs(job.sheet.exercises) do
    table.insert(list, read(job, path))
  end
  for _, exercise in ipairs(list) do
    exercise.needs = read_in(exercise)
    blocks:extend(context.out.exercise(exercise))
    if not exercise.programmed then
      blocks:insert(raw_block("\\markedbyhand"))
    end
  end
  local how = pandoc.read(files.read(job.sheet.how), job.dialect).blocks
  blocks:extend(weave.text({ source = source.open(job.sheet.how),
    id = "front", front = true, answers = {} }, how))
  if cites(blocks) then blocks:insert(raw_block("\\literature")) end
  blocks:insert(pandoc.Div({}, { id = "refs" }))
  blocks:insert(1, raw_block("\\makesheet{%s}{%s}{%s}{%s}",
    latex.text(job.sheet.title), latex.text(job.sheet.due), sum(list),
    latex.text(whose())))
  blocks:insert(1, numbering.latex(numbering.of_book(job)))
  return blocks
end

return sheet
