-- The exercises of a chapter, from exercises/chNN/K-name/exercise.md:
-- front matter with title, stars, minutes, points, needs and what it
-- trains, then the text. Hints, model answers, reasoning and advice for
-- marking are checked, but kept from the book.
local context = require "context"
local faults = require "faults"
local files = require "files"
local source = require "source"
local weave = require "weave"

local exercises = {}

local stringify = pandoc.utils.stringify
local known = { title = true, stars = true, minutes = true, points = true,
  needs = true, trains = true }

-- Units of time that are whole, from so many minutes on.
local units = {
  { 2400, 2400, "week" }, { 480, 480, "day" }, { 120, 60, "h" },
}

-- "40 min", "3 h", "2 days", "1 week", of working hours.
function exercises.time(minutes)
  for _, unit in ipairs(units) do
    local least, length, name = table.unpack(unit)
    if minutes >= least and minutes % length == 0 then
      local n = minutes // length
      return ("%d~%s%s"):format(n, name, #name > 1 and n > 1 and "s" or "")
    end
  end
  return ("%d~min"):format(minutes)
end

-- Hours, if there are several.
function exercises.roughly(minutes)
  return minutes > 120 and (minutes + 30) // 60 * 60 or minutes
end

local function text_of(meta, key)
  return meta[key] and stringify(meta[key]) or ""
end

local function words(meta, key, path)
  local text = text_of(meta, key)
  if text == "" then
    faults.add(path, 1, 'the exercise needs a line "%s: "', key)
  end
  return context.out.text(text)
end

local function number(meta, key, path, low, high)
  local n = math.tointeger(tonumber(text_of(meta, key)))
  if not n or n < low or n > high then
    faults.add(path, 1, 'the exercise needs a line "%s: ", from %d to %d',
      key, low, high)
    return low
  end
  return n
end

-- Reads an exercise: what its front matter says, its label and number,
-- the blocks of its text, and what is kept from the book, by class.
function exercises.read(job, chapter, path)
  local folder, k, name = path:match("/(ch%d%d)/(%d+)%-([%w-]+)/[^/]*$")
  if not k then
    faults.add(path, 1, "an exercise's folder is called like 1-nearest-pair")
    return nil
  end
  local doc = pandoc.read(files.read(path), job.dialect)
  for key in pairs(doc.meta) do
    if not known[key] then
      faults.add(path, 1, 'the front matter\'s line "%s" is unknown', key)
    end
  end
  local exercise = {
    path = path, label = ("ex:%s-%s"):format(folder, name),
    number = ("%d.%s"):format(chapter.number, k),
    title = words(doc.meta, "title", path),
    stars = number(doc.meta, "stars", path, 1, 5),
    minutes = number(doc.meta, "minutes", path, 1, 10000),
    points = number(doc.meta, "points", path, 1, 1000),
    trains = words(doc.meta, "trains", path),
    needs = context.out.text(text_of(doc.meta, "needs")),
    programmed =
      files.exists((path:gsub("exercise%.md$", "tests.c"))) or false,
  }
  exercise.time = exercises.time(exercise.minutes)
  context.label(exercise.label, path, 1)
  local text = { source = source.open(path), id = chapter.id,
    exercise = true, answers = {},
    kept = { hint = {}, answer = {}, reasoning = {}, marking = {} } }
  exercise.blocks = weave.text(text, doc.blocks)
  exercise.kept = text.kept
  return exercise
end

return exercises
