-- The exercises of a chapter, from exercises/chNN/K-name/exercise.md:
-- front matter with title, stars, minutes, points and needs, then the
-- text. Hints and model answers are checked, but not printed.
local context = require "context"
local faults = require "faults"
local files = require "files"
local latex = require "latex"
local source = require "source"
local weave = require "weave"

local exercises = {}

local stringify = pandoc.utils.stringify
local known = { title = true, stars = true, minutes = true, points = true,
  needs = true }

local function raw_block(text)
  return pandoc.RawBlock("latex", text)
end

local function number(meta, key, path, low, high)
  local n = math.tointeger(tonumber(meta[key] and stringify(meta[key]) or ""))
  if not n or n < low or n > high then
    faults.add(path, 1, 'the exercise needs a line "%s: ", from %d to %d',
      key, low, high)
    return low
  end
  return n
end

-- The exercise's blocks, and its line for the list of exercises.
function exercises.read(job, chapter, path)
  local folder, k, name = path:match("/(ch%d%d)/(%d+)%-([%w-]+)/[^/]*$")
  if not k then
    faults.add(path, 1, "an exercise's folder is called like 1-nearest-pair")
    return pandoc.List(), nil
  end
  local doc = pandoc.read(files.read(path), job.dialect)
  for key in pairs(doc.meta) do
    if not known[key] then
      faults.add(path, 1, 'the front matter\'s line "%s" is unknown', key)
    end
  end
  local title = doc.meta.title and stringify(doc.meta.title) or ""
  if title == "" then
    faults.add(path, 1, 'the exercise needs a line "title: "')
  end
  local stars = number(doc.meta, "stars", path, 1, 5)
  local minutes = number(doc.meta, "minutes", path, 1, 10000)
  local points = number(doc.meta, "points", path, 1, 1000)
  local programmed =
    files.exists((path:gsub("exercise%.md$", "solution.c")))
  local label = ("ex:%s-%s"):format(folder, name)
  local full = ("%d.%s"):format(chapter.number, k)
  context.label(label, path, 1)

  local blocks = weave.text({ source = source.open(path), id = chapter.id,
    exercise = true, answers = {} }, doc.blocks)
  blocks:insert(1, raw_block(
    ("\\pressat{%s:1}\\exercise{%s}{%s}{%s}{%d}{%d}{%d}{%s}"):format(path,
      full, label, latex.text(title), stars, minutes, points,
      programmed and "programmed" or "on paper")))
  blocks:insert(raw_block(("\\tryexercise{%s}{%s}"):format(
    doc.meta.needs and latex.text(stringify(doc.meta.needs)) or "",
    programmed and full or "")))
  return blocks, ("\\exerciseline{%s}{%s}{%s}{%d}{%d}"):format(full, label,
    latex.text(title), stars, minutes)
end

return exercises
