-- What stands in a sentence: code, references, and the spans of
-- CONTRIBUTING.md, "The prose".
local context = require "context"
local faults = require "faults"
local numbers = require "numbers"
local values = require "values"
local words_of = require "words"

local fault = context.fault

local inlines = {}
local inline, span = {}, {}

-- Which spans there are, and which attributes each of them knows.
local span_attributes = {
  value = { as = true, digits = true },
  reported = { by = true },
  given = {},
  claim = { ["if"] = true },
  fragment = {},
  index = { key = true, see = true },
  machine = {},
}

-- Between a number and its unit, or its power of ten, no line ends.
local function is_tie(list, i)
  local before, after = list[i - 1], list[i + 1]
  return list[i].t == "Space" and before and before.t == "Span"
    and after and (after.t == "Str" and numbers.is_unit(after.text)
      or after.t == "Math" and after.text:match("^\\cdot") ~= nil)
end

-- Whether a sentence begins with this word.
local function begins(list, i)
  local before, last = list[i - 1], list[i - 2]
  return not before or (before.t == "Space" or before.t == "SoftBreak")
    and last and last.t == "Str" and last.text:match("[.?!]\"?$") ~= nil
end

-- "chapter 4" is a link and stays on one line, if the book has one.
local function with_chapters_linked(list)
  if context.in_title then return list end
  local result = pandoc.List()
  for _, x in ipairs(list) do
    local word, space = result[#result - 1], result[#result]
    local bracket, chapter, number, rest
    if x.t == "Str" and space and space.t == "Space"
      and word and word.t == "Str" then
      bracket, chapter = word.text:match("^(%(?)([Cc]hapter)$")
      number, rest = x.text:match("^(%d+)(.*)$")
    end
    local label = chapter and number
      and ("ch:ch%02d"):format(math.tointeger(number))
    if label and context.is_chapter(label) then
      result:remove()
      result:remove()
      if bracket ~= "" then result:insert(pandoc.Str(bracket)) end
      result:insert(context.out.crossref(chapter, label))
      if rest ~= "" then result:insert(pandoc.Str(rest)) end
    else
      result:insert(x)
    end
  end
  return result
end

-- A sentence that would only say "the same machine" is left out, with
-- what leads to it.
local function without_same(list, i, result)
  local following, space = list[i + 1], result[#result]
  local before = result[#result - 1]
  if not (following and following.t == "Str" and following.text:match("^%.")
    and space and (space.t == "Space" or space.t == "SoftBreak")
    and before and before.t == "Str" and before.text:match("[.;,:]$")) then
    return false
  end
  result:remove()
  before.text = before.text:gsub("[.;,:]$", "")
  return true
end

local function woven(list)
  local result = pandoc.List()
  list = with_chapters_linked(list)
  for i, x in ipairs(list) do
    local handler = inline[x.t]
    if is_tie(list, i) then
      result:insert(context.out.tie())
    elseif handler then
      local new = handler(x, begins(list, i))
      if new.t == "Str" and x.t == "Span" and x.classes[1] == "machine"
        and without_same(list, i, result) then
        -- the full stop that follows ends the sentence before
      elseif new.t then result:insert(new) else result:extend(new) end
    elseif x.content then
      x.content = woven(x.content)
      result:insert(x)
    else
      result:insert(x)
    end
  end
  return result
end

-- A span that pandoc has not taken for one: [@su][]{.index} is none,
-- and there are none inside of a formula.
function inline.Str(x)
  if x.text:match("{%.%a") then
    fault(x.text, 'this is printed as it stands: "%s"', x.text)
  end
  return x
end

inline.Math = inline.Str

function inline.Code(x)
  if #x.classes > 0 then
    fault(x.text, 'the class "%s" is unknown for code in a sentence',
      x.classes[1])
  end
  return context.out.code(x.text)
end

function inline.Cite(x)
  local result, literature = pandoc.List(), false
  for _, citation in ipairs(x.citations) do
    local reference = context.reference(citation.id)
    if reference then
      if #result > 0 then result:insert(pandoc.Str(", ")) end
      result:insert(reference)
    else
      literature = true
      if not context.book.bibliography[citation.id] then
        fault("@" .. citation.id,
          'references.bib has no entry "%s"', citation.id)
      end
    end
  end
  if not literature then return result end
  if #result > 0 then
    fault("@" .. x.citations[1].id,
      "literature and labels cannot share their brackets")
  end
  return x
end

function inline.Image(x)
  fault("(" .. x.src .. ")", "a figure must be a paragraph of its own")
  return pandoc.List()
end

-- A footnote's words are elsewhere in the file than the sentence's.
function inline.Note(x)
  local cursor = context.here.source.cursor
  x.content = require("weave").blocks(x.content)
  context.here.source.cursor = cursor
  return x
end

function inline.RawInline(x)
  if x.format == "html" and x.text:match("^<!%-%-") then
    return pandoc.List()
  end
  if x.format ~= "tex" and x.format ~= context.out.format then
    fault(x.text, "raw %s cannot be printed", x.format)
  end
  return x
end

function inline.Link(x)
  x.content = woven(x.content)
  if x.target:match("^#") then
    fault(x.target, "refer to %s with @", x.target)
  end
  return x
end

function inline.Span(x, begins_sentence)
  local words = words_of.typed(x.content)
  local class = context.class_of(x, span_attributes, "span",
    x.classes[1] and "." .. x.classes[1] or words)
  if class then return span[class](x, words, begins_sentence) end
  return woven(x.content)
end

function span.value(x, expression)
  local words = "[" .. expression .. "]"
  local value, why, cells = values.evaluate(expression)
  local text
  if value ~= nil then
    text, why = values.format(value, x.attributes.as,
      context.integer(x.attributes.digits, words, "digits"))
  end
  if not text then
    fault(words, "%s", why)
    text = "?"
  end
  return context.out.value(text, expression, cells)
end

function span.given(x)
  return woven(x.content)
end

function span.reported(x, words)
  local by = x.attributes.by
  if not by then
    fault("[" .. words .. "]", "a reported number needs its source: by=...")
  elseif not context.book.bibliography[by] then
    fault("[" .. words .. "]", 'references.bib has no entry "%s"', by)
  else
    context.book.cited[by] = true
  end
  by = by or "?"
  return context.out.reported(woven(x.content), by)
end

function span.claim(x, sentence)
  local condition = x.attributes["if"]
  local words = sentence:sub(1, 40)
  local result = woven(x.content)
  local holds, why, cells = nil, "a claim needs its condition: if=\"...\""
  if condition then
    words = condition
    holds, why, cells = values.evaluate(condition)
    if holds ~= nil and type(holds) ~= "boolean" then
      why = ('"%s" is neither true nor false'):format(condition)
      holds = nil
    end
  end
  if holds == nil then
    fault(words, "%s", why)
  elseif not holds then
    local source = context.here.source
    faults.note(source.path, source:find(words),
      'on this machine it does not hold: "%s" (%s)',
      pandoc.utils.stringify(result), condition)
  end
  return context.out.claim(result, condition, holds, cells)
end

function span.fragment(_, title)
  local fragment = context.book.fragments.by_title[title]
  if not fragment then
    fault("[" .. title .. "]", 'no fragment is called "%s"', title)
    return pandoc.Str("?")
  end
  local source = context.here.source
  table.insert(context.book.mentions, { fragment = fragment,
    path = source.path, line = source:find("[" .. title .. "]") })
  return context.out.mention(fragment)
end

-- A capital that only begins the sentence is not the index's.
local function uncapitalized(words)
  return (words:gsub("^%u%f[^%u][^%u]*$", function(all)
    return all:sub(1, 1):lower() .. all:sub(2)
  end))
end

function span.index(x, words, begins_sentence)
  local key, see = x.attributes.key, x.attributes.see
  if not key and words == "" then
    fault("{.index", "an index entry needs words or a key")
    return pandoc.List()
  end
  local is_code = #x.content == 1 and x.content[1].t == "Code"
  local entry = words
  if begins_sentence and not is_code then entry = uncapitalized(words) end
  local place
  if see then
    context.see(see, words == "" and key or words)
  else
    place = context.indexed(key and key:match("^[^!]*")
      or begins_sentence and uncapitalized(words) or words)
  end
  local result = woven(x.content)
  result:insert(context.out.index { key = key, words = entry,
    is_code = is_code, see = see, place = place })
  return result
end

-- On what a table was measured: [ch02-speeds]{.machine}. The first
-- caption of a chapter says it in full; another one only if it was
-- another machine or compiler.
function span.machine(_, name)
  local where, why = values.provenance(name)
  if not where then
    fault("[" .. name .. "]", "%s", why)
    return pandoc.List()
  end
  local here = context.here
  if context.caption and here.measured == where.setup then
    return pandoc.Str("the same machine")
  end
  if context.caption then here.measured = here.measured or where.setup end
  return context.out.machine(where)
end

-- A paragraph's worth of inlines: its place in the file is found by its
-- first words, and its numbers are checked.
function inlines.paragraph(list)
  context.here.source:seek(words_of.opening(list))
  return inlines.checked(list)
end

-- The same, where the file has been found already.
function inlines.checked(list)
  for _, number in ipairs(words_of.measured(list)) do
    fault(number, '"%s" looks like a measurement typed by hand: quote a '
      .. "table with {.value}, a report with {.reported}, or mark it "
      .. "{.given}", number)
  end
  return woven(list)
end

return inlines

