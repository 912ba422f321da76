-- An assignment: chosen exercises on a few pages, with points, and how
-- to work on them. The book's figures, tables and exercises keep their
-- numbers, which are counted here as LaTeX would.
local context = require "context"
local exercises = require "exercises"
local files = require "files"
local latex = require "latex"
local source = require "source"
local weave = require "weave"

local sheet = {}

local function raw_block(text, ...)
  return pandoc.RawBlock("latex", text:format(...))
end

-- ---- numbers ----------------------------------------------------------
local function is_figure(block)
  local image = block.t == "Para" and #block.content == 1
    and block.content[1]
  return block.t == "Figure" or image and image.t == "Image"
end

local function figure_label(block)
  if block.identifier and block.identifier ~= "" then
    return block.identifier
  end
  local image = block.content[1]
  return (image.t == "Image" and image or image.content[1]).identifier
end

-- Calls found(label, number) for all that is numbered in a chapter.
local function count(chapter, blocks, found)
  local last = { fig = 0, tab = 0, sec = 0 }
  local function take(kind, label)
    last[kind] = last[kind] + 1
    found(label, ("%d.%d"):format(chapter.number, last[kind]))
  end
  local function walk(list, label)
    for _, block in ipairs(list) do
      if is_figure(block) then
        take("fig", figure_label(block))
      elseif block.t == "Table" and (label or #block.caption.long > 0) then
        take("tab", label or "")
      elseif block.t == "Header" and block.level == 2
        and not block.classes:includes("unnumbered") then
        take("sec", block.identifier)
      elseif block.t == "Div" then
        walk(block.content, block.identifier:match("^tab:.*"))
      end
    end
  end
  walk(blocks)
end

-- Every label of the book, its number, for LaTeX; the press knows them
-- then, too.
local function book_numbers(job)
  local lines = {}
  local function found(label, number)
    if label == "" or context.book.labels[label] then return end
    context.book.labels[label] = { path = "the book", line = 1 }
    table.insert(lines, ("\\booknumber{%s}{%s}"):format(label, number))
  end
  for _, path in ipairs(job.chapters) do
    local id = files.name(path):match("^ch%d%d")
    local chapter = { number = tonumber(id:sub(3)) }
    found("ch:" .. id, tostring(chapter.number))
    count(chapter, pandoc.read(files.read(path), job.dialect).blocks, found)
  end
  for id, paths in pairs(job.exercises) do
    for _, path in ipairs(paths) do
      local k, name = path:match("/(%d+)%-([%w-]+)/[^/]*$")
      found(("ex:%s-%s"):format(id, name),
        ("%d.%s"):format(tonumber(id:sub(3)), k))
    end
  end
  return raw_block("%s", table.concat(lines, "\n"))
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
  if minutes > 120 then minutes = (minutes + 30) // 60 * 60 end
  return ("%d exercise%s, %d points, about %s"):format(#list,
    #list == 1 and "" or "s", points, exercises.time(minutes))
end

-- Whether there will be a list of literature.
local function cites(blocks)
  local found = next(context.book.cited) ~= nil
  pandoc.walk_block(pandoc.Div(blocks), {
    Cite = function() found = true end })
  return found
end

function sheet.assemble(job, meta)
  meta.sheet = true
  meta.title = pandoc.MetaString(job.sheet.title)
  local list, blocks = {}, pandoc.List()
  for _, path in ipairs(job.sheet.exercises) do
    table.insert(list, read(job, path))
  end
  for _, exercise in ipairs(list) do
    blocks:extend(exercises.printed(exercise))
    if not exercise.programmed then
      blocks:insert(raw_block("\\markedbyhand"))
    end
  end
  local how = pandoc.read(files.read(job.sheet.how), job.dialect).blocks
  blocks:extend(weave.text({ source = source.open(job.sheet.how),
    id = "front", front = true, answers = {} }, how))
  if cites(blocks) then blocks:insert(raw_block("\\literature")) end
  blocks:insert(pandoc.Div({}, { id = "refs" }))
  blocks:insert(1, raw_block("\\makesheet{%s}{%s}{%s}",
    latex.text(job.sheet.title), latex.text(job.sheet.due), sum(list)))
  blocks:insert(1, book_numbers(job))
  return blocks
end

return sheet
