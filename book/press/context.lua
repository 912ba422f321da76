-- What is being woven: the book, the text at hand, and the place in its
-- file, for faults and for LaTeX's log.
local faults = require "faults"

local context = {
  book = nil,       -- fragments, labels, references, citations, the job
  out = nil,        -- the edition: what each thing is in LaTeX or HTML
  here = nil,       -- source, chapter's id, its answers; kind of text
  in_table = false,
  in_title = false, -- which has no links: it is a link in the contents
  caption = nil,    -- the label of the table or figure it belongs to
}

function context.raw(text)
  return pandoc.RawInline("latex", text)
end

function context.raw_block(text)
  return pandoc.RawBlock("latex", text)
end

-- A fault where these words stand in the file.
function context.fault(words, sentence, ...)
  local source = context.here.source
  faults.add(source.path, source:find(words), sentence, ...)
end

-- In the log, LaTeX's complaints follow the place they belong to.
function context.mark(line)
  return ("\\pressat{%s:%d}"):format(context.here.source.path, line)
end

-- ---- classes and attributes ---------------------------------------------
-- The class of an element, if it is one of the known, each of which has
-- its own set of attributes.
function context.class_of(element, known, what, words)
  local class = element.classes[1]
  if not class then
    context.fault(words, "this %s has no class", what)
  elseif not known[class] then
    context.fault(words, 'the class "%s" is unknown for a %s', class, what)
    return nil
  else
    if element.identifier ~= "" then
      context.fault(words, 'a %s of class "%s" has no label', what, class)
    end
    for name in pairs(element.attributes) do
      if not known[class][name] then
        context.fault(words, 'the attribute "%s" is unknown for a %s of '
          .. 'class "%s"', name, what, class)
      end
    end
  end
  return class
end

function context.integer(text, words, what)
  local n = math.tointeger(tonumber(text))
  if text and not (n and n >= 0) then
    context.fault(words, '%s="%s" is not a whole number', what, text)
  end
  return n
end

-- ---- labels and references ----------------------------------------------
function context.label(label, path, line)
  local labels = context.book.labels
  local first = labels[label]
  if first then
    faults.add(path, line, 'the label "%s" exists twice, here and at %s:%d',
      label, first.path, first.line)
  else
    labels[label] = { path = path, line = line }
  end
end

-- A label that a chapter gives; none is "".
function context.own_label(label, kind, words)
  local source = context.here.source
  if label ~= "" and not label:match("^" .. kind .. ":.") then
    context.fault(words, 'the label "%s" should begin with "%s:"', label,
      kind)
  elseif label ~= "" then
    context.label(label, source.path, source:find("#" .. label))
  end
end

local kinds = {
  fig = "Figure", tab = "Table", sec = "Section", ch = "Chapter",
  ex = "Exercise",
}

-- "Table 2.1", if such labels are ours.
function context.crossref(label)
  local kind = kinds[label:match("^(%a+):")]
  if label:match("^ch:appendix") then kind = "Appendix" end
  return kind and context.out.crossref(kind, label)
end

function context.is_chapter(label)
  for _, path in ipairs(context.book.job.chapters) do
    if label == "ch:" .. path:match("([^/]*)$"):match("^ch%d%d") then
      return true
    end
  end
  return false
end

-- A reference if the key is one of ours, nil if it is literature.
function context.reference(label)
  local text = context.crossref(label)
  if not text then return nil end
  local source = context.here.source
  table.insert(context.book.references, { label = label,
    path = source.path, line = source:find("@" .. label) })
  return text
end

-- The index has an entry of that name; another one sends there. The
-- first place of an entry is where the glossary sends, unless it is in a
-- title or a caption, which TeX sets more than once.
function context.indexed(entry)
  local indexed, place = context.book.indexed, nil
  if not indexed[entry] and not context.in_title
    and not context.caption then
    context.book.terms = context.book.terms + 1
    indexed[entry] = ("term:%d"):format(context.book.terms)
    place = indexed[entry]
  end
  indexed[entry] = indexed[entry] or false
  return place
end

function context.see(entry, words)
  local source = context.here.source
  table.insert(context.book.sent, { entry = entry, path = source.path,
    line = source:find(words) })
end

-- When everything has been read, every label must be there, and every
-- entry of the index that another one names.
function context.check_references()
  for _, r in ipairs(context.book.references) do
    if not context.book.labels[r.label] then
      faults.add(r.path, r.line, 'there is nothing with the label "%s"',
        r.label)
    end
  end
  if context.book.job.only then return end
  for _, s in ipairs(context.book.sent) do
    if context.book.indexed[s.entry] == nil then
      faults.add(s.path, s.line, 'the index has no entry "%s" to see',
        s.entry)
    end
  end
end

return context
