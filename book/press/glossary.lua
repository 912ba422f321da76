-- The glossary: an appendix made of book/glossary.md, a term a line,
--
--   term | definition | synonyms | ch04
--
-- in any order. The synonyms may be empty; the chapter is the one that
-- explains the term. Each is printed with the page of its first entry in
-- the index; a term without one, with its chapter.
local context = require "context"
local faults = require "faults"
local files = require "files"
local inlines = require "inlines"
local source = require "source"

local glossary = {}

-- The columns of a line, without the spaces around them.
local function columns(line)
  local result = {}
  for column in (line .. " | "):gmatch("%s*(.-)%s*|%f[%s]") do
    table.insert(result, column)
  end
  return result
end

-- Where in the index the term is found first, under its own name, in the
-- plural, or as an initial capital has it.
local function place_of(term, synonyms)
  local indexed = context.book.indexed
  local names = { term }
  for name in (synonyms .. ","):gmatch("%s*(.-)%s*,") do
    table.insert(names, name)
  end
  for _, name in ipairs(names) do
    local found = indexed[name] or indexed[name .. "s"]
      or indexed[name:gsub("s$", "")] or indexed[name:gsub("`", "")]
    if found then return found end
  end
end

local function words(path, text)
  local blocks = pandoc.read(text, context.book.job.dialect).blocks
  if #blocks > 1 then
    faults.add(path, context.here.source.cursor,
      "a line of the glossary holds one sentence")
  end
  return inlines.checked(blocks[1] and blocks[1].content or {})
end

-- As a sentence, whether it was written as one or not.
local function sentence(text)
  return text:gsub("^%l%f[%W]", string.upper):gsub("^%l%l", function(two)
    return two:sub(1, 1):upper() .. two:sub(2)
  end):gsub("([^.?!])$", "%1.")
end

local function printed(path, entry)
  local term, definition, synonyms, chapter = table.unpack(entry)
  definition = sentence(definition)
  context.here.source.cursor = entry.line
  local label = place_of(term, synonyms)
  return context.out.glossary_line { term = words(path, term),
    definition = words(path, definition), synonyms = words(path, synonyms),
    place = label, chapter = chapter }
end

-- The entries of the file, checked.
local function entries_of(path)
  local entries, seen = {}, {}
  for number, line in ipairs(files.lines(path)) do
    local entry = columns(line)
    local name = (entry[1] or ""):lower()
    entry.line = number
    if not line:find("%S") or line:find("^#") or line:find("^<!%-%-") then
      -- between the entries
    elseif #entry ~= 4 or name == "" or entry[2] == "" then
      faults.add(path, number, 'a line of the glossary is "term | '
        .. 'definition | synonyms | chNN"')
    elseif not context.is_chapter("ch:" .. entry[4]) then
      faults.add(path, number, 'there is no chapter "%s"', entry[4])
    elseif seen[name] then
      faults.add(path, number, 'the glossary explains "%s" twice, here and '
        .. "in line %d", entry[1], seen[name])
    else
      seen[name] = number
      table.insert(entries, entry)
    end
  end
  table.sort(entries, function(a, b)
    return a[1]:lower():gsub("[`$]", "") < b[1]:lower():gsub("[`$]", "")
  end)
  return entries
end

-- The appendix, or nothing if there is no glossary.
function glossary.read(job)
  local blocks = pandoc.List()
  if not files.exists(job.glossary) then return blocks end
  local entries = entries_of(job.glossary)
  if #entries == 0 then return blocks end
  context.here = { source = source.open(job.glossary), id = "glossary",
    answers = {} }
  for _, entry in ipairs(entries) do
    blocks:insert(printed(job.glossary, entry))
  end
  return context.out.glossary(blocks)
end

return glossary
