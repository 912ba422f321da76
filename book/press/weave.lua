-- Turns what pandoc has read of one chapter into what LaTeX will set:
-- follows blocks and inlines in their order through the text, replaces
-- what is ours (CONTRIBUTING.md, "The prose"), and finds the faults.
local capture = require "capture"
local faults = require "faults"
local files = require "files"
local fragments = require "fragments"
local latex = require "latex"
local listing = require "listing"
local numbers = require "numbers"
local tables = require "tables"
local values = require "values"

local weave = {}

local stringify = pandoc.utils.stringify
local book      -- fragments, labels, references, citations, the job
local here      -- the text being woven: source, chapter, questions
local in_table = false

local function raw(text)
  return pandoc.RawInline("latex", text)
end

local function raw_block(text)
  return pandoc.RawBlock("latex", text)
end

local function fault(words, sentence, ...)
  faults.add(here.source.path, here.source:find(words), sentence, ...)
end

-- In the log, LaTeX's complaints follow the place they belong to.
local function mark(line)
  return ("\\pressat{%s:%d}"):format(here.source.path, line)
end

-- ---- words as they stand in the file ----------------------------------
-- The text of inlines as it was typed: in an expression, stars are no
-- emphasis.
local function typed(inlines)
  local parts = {}
  for _, x in ipairs(inlines) do
    if x.t == "Emph" then
      table.insert(parts, "*" .. typed(x.content) .. "*")
    elseif x.t == "Strong" then
      table.insert(parts, "**" .. typed(x.content) .. "**")
    elseif x.t == "Superscript" then
      table.insert(parts, "^" .. typed(x.content) .. "^")
    elseif x.t == "Quoted" then
      local mark_of = x.quotetype == "SingleQuote" and "'" or '"'
      table.insert(parts, mark_of .. typed(x.content) .. mark_of)
    elseif x.content then
      table.insert(parts, typed(x.content))
    else
      table.insert(parts, stringify(x))
    end
  end
  return (table.concat(parts):gsub("\u{2019}", "'")
    :gsub("\u{2013}", "--"):gsub("\u{2026}", "..."))
end

-- The first words that stand in the file one after the other.
local function opening(inlines)
  local words = ""
  for _, x in ipairs(inlines) do
    if x.t == "Str" then
      words = words .. x.text
    elseif x.t == "Space" then
      words = words .. " "
    elseif words:match("%S") then
      break
    elseif x.t == "Code" then
      return x.text
    elseif x.content then
      words = opening(x.content)
      if words ~= "" then break end
    end
    if #words > 50 then break end
  end
  return (words:gsub("%s+$", ""))
end

-- Running text with everything hidden that may hold any number.
local marked = { value = true, reported = true, given = true,
  machine = true, fragment = true }

local function visible(inlines)
  local parts = {}
  for _, x in ipairs(inlines) do
    if x.t == "Str" then
      table.insert(parts, x.text)
    elseif x.t == "Space" or x.t == "SoftBreak" or x.t == "LineBreak" then
      table.insert(parts, " ")
    elseif x.t == "Span" and marked[x.classes[1]] or x.t == "Cite" then
      table.insert(parts, numbers.HIDDEN)
    elseif x.content and x.t ~= "Note" then
      table.insert(parts, visible(x.content))
    else
      table.insert(parts, numbers.HIDDEN)
    end
  end
  return table.concat(parts)
end

local function check_numbers(inlines)
  for _, number in ipairs(numbers.suspicious(visible(inlines))) do
    fault(number, '"%s" looks like a measurement typed by hand: quote a '
      .. "table with {.value}, a report with {.reported}, or mark it "
      .. "{.given}", number)
  end
end

-- ---- attributes -------------------------------------------------------
-- Which classes there are, and which attributes each of them knows.
local span_attributes = {
  value = { as = true, digits = true },
  reported = { by = true },
  given = {},
  claim = { ["if"] = true },
  fragment = {},
  index = { key = true },
  machine = {},
}

local div_attributes = { quick = {}, answer = {}, hint = {} }

local code_attributes = {
  fragment = {},
  output = { run = true, status = true, lines = true },
  c = { given = true },
  sh = {}, text = {}, make = {}, tsv = {},
}

-- The class of an element, if it is one of ours and well spelled.
local function class_of(element, known, what, words)
  local class = element.classes[1]
  if not class then
    fault(words, "this %s has no class", what)
  elseif not known[class] then
    fault(words, 'the class "%s" is unknown for a %s', class, what)
    return nil
  else
    for name in pairs(element.attributes) do
      if not known[class][name] then
        fault(words, 'the attribute "%s" is unknown for a %s of class "%s"',
          name, what, class)
      end
    end
  end
  return class
end

local function integer(text, words, what)
  local n = math.tointeger(tonumber(text))
  if text and not (n and n >= 0) then
    fault(words, '%s="%s" is not a whole number', what, text)
  end
  return n
end

-- ---- labels and references ----------------------------------------------
function weave.label(label, path, line)
  local first = book.labels[label]
  if first then
    faults.add(path, line, 'the label "%s" exists twice, here and at %s:%d',
      label, first.path, first.line)
  else
    book.labels[label] = { path = path, line = line }
  end
end

local function own_label(label, kind, words)
  if label ~= "" and not label:match("^" .. kind .. ":.") then
    fault(words, 'the label "%s" should begin with "%s:"', label, kind)
  elseif label ~= "" then
    weave.label(label, here.source.path, here.source:find("#" .. label))
  end
end

local kinds = {
  fig = "Figure", tab = "Table", sec = "Section", ch = "Chapter",
  ex = "Exercise",
}

local function reference(label, kind)
  table.insert(book.references, { label = label, path = here.source.path,
    line = here.source:find("@" .. label) })
  if kind == "ch" and label:match("^ch:appendix") then
    kind = "Appendix"
  else
    kind = kinds[kind]
  end
  return raw(("\\crossref{%s}{%s}"):format(kind, label))
end

function weave.check_references()
  for _, r in ipairs(book.references) do
    if not book.labels[r.label] then
      faults.add(r.path, r.line, 'there is nothing with the label "%s"',
        r.label)
    end
  end
end

-- ---- inlines ----------------------------------------------------------
local inline, span = {}, {}

local function inlines(list)
  local result = pandoc.List()
  for _, x in ipairs(list) do
    local handler = inline[x.t]
    if handler then
      local new = handler(x)
      if new.t then result:insert(new) else result:extend(new) end
    elseif x.content then
      x.content = inlines(x.content)
      result:insert(x)
    else
      result:insert(x)
    end
  end
  return result
end

function inline.Code(x)
  if #x.classes > 0 then
    fault(x.text, 'the class "%s" is unknown for code in a sentence',
      x.classes[1])
  end
  return raw(latex.inline_code(x.text))
end

function inline.Cite(x)
  local result = pandoc.List()
  local literature = 0
  for _, citation in ipairs(x.citations) do
    local kind = citation.id:match("^(%a+):")
    if kinds[kind] then
      if #result > 0 then result:insert(pandoc.Str(", ")) end
      result:insert(reference(citation.id, kind))
    else
      literature = literature + 1
      if not book.bibliography[citation.id] then
        fault("@" .. citation.id,
          'references.bib has no entry "%s"', citation.id)
      end
    end
  end
  if literature == 0 then return result end
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
  local cursor = here.source.cursor
  x.content = weave.blocks(x.content)
  here.source.cursor = cursor
  return x
end

function inline.RawInline(x)
  if x.format == "html" and x.text:match("^<!%-%-") then
    return pandoc.List()
  end
  if x.format ~= "tex" and x.format ~= "latex" then
    fault(x.text, "raw %s cannot be printed", x.format)
  end
  return x
end

function inline.Link(x)
  x.content = inlines(x.content)
  if x.target:match("^#") then
    fault(x.target, "refer to %s with @", x.target)
  end
  return x
end

function inline.Span(x)
  local words = typed(x.content)
  local class = class_of(x, span_attributes, "span",
    x.classes[1] and "." .. x.classes[1] or words)
  if class then return span[class](x, words) end
  return inlines(x.content)
end

function span.value(x, expression)
  local words = "[" .. expression .. "]"
  local value, why = values.evaluate(expression)
  local text
  if value ~= nil then
    text, why = values.format(value, x.attributes.as,
      integer(x.attributes.digits, words, "digits"))
  end
  if not text then
    fault(words, "%s", why)
    text = "?"
  end
  return raw(latex.text(text))
end

function span.given(x)
  return inlines(x.content)
end

function span.reported(x, words)
  local by = x.attributes.by
  if not by then
    fault("[" .. words .. "]", "a reported number needs its source: by=...")
  elseif not book.bibliography[by] then
    fault("[" .. words .. "]", 'references.bib has no entry "%s"', by)
  else
    book.cited[by] = true
  end
  local result = inlines(x.content)
  result:insert(raw(("\\%s{%s}{%s}"):format(
    in_table and "reportedintable" or "reported", by, (by or ""):sub(1, 1))))
  return result
end

function span.claim(x, sentence)
  local condition = x.attributes["if"]
  local words = sentence:sub(1, 40)
  local result = inlines(x.content)
  local holds, why = nil, "a claim needs its condition: if=\"...\""
  if condition then
    words = condition
    holds, why = values.evaluate(condition)
    if holds ~= nil and type(holds) ~= "boolean" then
      why = ('"%s" is neither true nor false'):format(condition)
      holds = nil
    end
  end
  if holds == nil then
    fault(words, "%s", why)
  elseif not holds then
    faults.note(here.source.path, here.source:find(words),
      'on this machine it does not hold: "%s" (%s)', stringify(result),
      condition)
    result:insert(raw("\\doesnothold{}"))
  end
  return result
end

function span.fragment(_, title)
  local fragment = book.fragments.by_title[title]
  if not fragment then
    fault("[" .. title .. "]", 'no fragment is called "%s"', title)
    return pandoc.Str("?")
  end
  return raw(listing.mention(fragment))
end

-- What makeindex would take for its own.
local function index_safe(text)
  return (text:gsub('[!@|"]', '"%0'))
end

function span.index(x, words)
  local key = x.attributes.key
  local entry
  if key then
    entry = latex.text(key:gsub('[@|"]', '"%0'))
  elseif words == "" then
    fault("{.index", "an index entry needs words or a key")
    return pandoc.List()
  elseif #x.content == 1 and x.content[1].t == "Code" then
    entry = index_safe(words) .. "@" ..
      index_safe(latex.inline_code(words))
  else
    entry = latex.text(index_safe(words))
  end
  local result = inlines(x.content)
  result:insert(raw("\\index{" .. entry .. "}"))
  return result
end

-- On what a table was measured: [ch02-speeds]{.machine}.
function span.machine(_, name)
  local parts, why = values.provenance(name)
  if not parts then
    fault("[" .. name .. "]", "%s", why)
    return pandoc.List()
  end
  for i, part in ipairs(parts) do
    local text, is_code = part[1], part[2]
    text = is_code and latex.inline_code(text) or latex.text(text)
    parts[i] = i > 1 and not is_code and text:gsub(" ", "~") or text
  end
  return raw(table.concat(parts, ", "))
end

-- A paragraph's worth of inlines: its numbers are checked together.
local function sentences(list)
  here.source:seek(opening(list))
  check_numbers(list)
  return inlines(list)
end

-- ---- blocks -----------------------------------------------------------
local block, code = {}, {}

-- After a listing, a small letter goes on with the sentence.
local function goes_on(x, previous)
  return x.t == "Para" and previous and previous.t == "CodeBlock"
    and opening(x.content):match("^%l") ~= nil
end

function weave.blocks(list)
  local result = pandoc.List()
  for i, x in ipairs(list) do
    local handler = block[x.t]
    if goes_on(x, list[i - 1]) then
      result:insert(raw_block("\\continued"))
    end
    local new = handler and handler(x) or x
    if new.t then result:insert(new) else result:extend(new) end
  end
  return result
end

-- A figure stands near its mention, as large as it was drawn.
local function figure(image, caption, identifier)
  local name = image.src
  here.source:seek("(" .. name .. ")")
  local words = "(" .. name .. ")"
  if identifier == "" then
    fault(words, "this figure needs a label: {#fig:%s}", name)
  end
  own_label(identifier, "fig", words)
  for attribute in pairs(image.attributes) do
    fault(words, 'the attribute "%s" is unknown for a figure', attribute)
  end
  local plot = ""
  if not name:match("^[%w-]+$") then
    fault(words, 'a figure is named like its script, without folder and '
      .. 'ending, not "%s"', name)
  elseif not files.exists(book.job.build .. "/figures/" .. name .. ".pdf")
  then
    fault(words, "there is no figure %s.pdf in %s/figures", name,
      book.job.build)
  else
    plot = "\\plot{" .. name .. "}"
  end
  if #caption == 0 then fault(words, "this figure needs a caption") end
  check_numbers(caption)
  local text = inlines(caption)
  text:insert(1, raw(("\\caption{\\label{%s}"):format(identifier)))
  text:insert(raw("}"))
  return pandoc.List {
    raw_block(("%s\\begin{figure}\\centering\n%s")
      :format(mark(here.source.cursor), plot)),
    pandoc.Plain(text), raw_block("\\end{figure}"),
  }
end

local function paragraph(x)
  local text = sentences(x.content)
  text:insert(1, raw(mark(here.source.cursor)))
  x.content = text
  return x
end

function block.Para(x)
  local image = x.content[1]
  if #x.content == 1 and image.t == "Image" then
    return figure(image, image.caption, image.identifier)
  end
  return paragraph(x)
end

block.Plain = paragraph

-- Newer versions of pandoc know figures themselves.
function block.Figure(x)
  local image = x.content[1].content[1]
  local identifier = x.identifier ~= "" and x.identifier
    or image.identifier
  return figure(image, pandoc.utils.blocks_to_inlines(x.caption.long),
    identifier)
end

function block.Header(x)
  x.content = sentences(x.content)
  local place = mark(here.source.cursor)
  if here.exercise then
    return raw_block(place .. "\\exercisehead{" .. latex.text(
      stringify(x.content)) .. "}")
  elseif here.front then
    x.content:insert(1, raw(x.level == 1 and "\\addchap{" or "\\section*{"))
    x.content:insert(raw("}"))
    return pandoc.List { raw_block(place), pandoc.Plain(x.content) }
  elseif x.level == 1 then
    fault(opening(x.content), "a chapter has one title, its first line")
  end
  own_label(x.identifier, "sec", "#" .. x.identifier)
  return pandoc.List { raw_block(place), x }
end

local function lists(x)
  x.content = pandoc.List(x.content):map(weave.blocks)
  return x
end

block.BulletList, block.OrderedList = lists, lists

function block.BlockQuote(x)
  x.content = weave.blocks(x.content)
  return x
end

function block.DefinitionList(x)
  x.content = pandoc.List(x.content):map(function(item)
    return { sentences(item[1]), pandoc.List(item[2]):map(weave.blocks) }
  end)
  return x
end

function block.LineBlock(x)
  x.content = pandoc.List(x.content):map(sentences)
  return x
end

function block.HorizontalRule()
  return raw_block("\\asterism")
end

function block.RawBlock(x)
  if x.format == "html" and x.text:match("^<!%-%-") then
    return pandoc.List()
  end
  if x.format ~= "tex" and x.format ~= "latex" then
    fault(x.text:match("[^\n]*"), "raw %s cannot be printed", x.format)
  end
  return x
end

-- ---- tables -----------------------------------------------------------
local function caption_of(x)
  return pandoc.utils.blocks_to_inlines(x.caption.long or x.caption[2])
end

local function cells_woven(x)
  local function row(r)
    for _, cell in ipairs(r.cells or r[2]) do
      local content = cell.contents or cell[5]
      for _, b in ipairs(content) do
        if not b.content or b.t ~= "Plain" and b.t ~= "Para" then
          fault("|", "a cell of a table holds words, nothing else")
        else
          b.content = sentences(b.content)
        end
      end
    end
  end
  in_table = true
  for _, r in ipairs(x.head.rows or x.head[2]) do row(r) end
  for _, part in ipairs(x.bodies) do
    for _, r in ipairs(part.body) do row(r) end
  end
  in_table = false
  return tables.latex(x)
end

local function set_table(x, label)
  local caption = caption_of(x)
  local place = mark(here.source.cursor)
  local woven = cells_woven(x)
  if #caption == 0 and not label then
    return pandoc.List { raw_block(place .. "\\begin{smalltable}"), woven,
      raw_block("\\end{smalltable}") }
  end
  if #caption == 0 then fault("#" .. label, "this table needs a caption") end
  caption = sentences(caption)
  local name = label and "\\label{" .. label .. "}" or ""
  caption:insert(1, raw("\\caption{" .. name))
  caption:insert(raw("}"))
  return pandoc.List {
    raw_block(place .. "\\begin{table}"), pandoc.Plain(caption),
    raw_block("\\centering\\tablefont"), woven, raw_block("\\end{table}"),
  }
end

function block.Table(x)
  return set_table(x, nil)
end

-- ---- divisions --------------------------------------------------------
local function labelled_table(x)
  local label = x.identifier
  here.source:seek("#" .. label)
  own_label(label, "tab", "#" .. label)
  local result, found = pandoc.List(), 0
  for _, b in ipairs(x.content) do
    if b.t == "Table" then
      found = found + 1
      result:extend(set_table(b, label))
    end
  end
  if found ~= 1 or #x.content ~= 1 then
    fault("#" .. label, "around a label stands one table, nothing else")
  end
  return result
end

-- The question here, the answer at the end of the chapter.
local function quick(x)
  here.source:seek("::: quick")
  local line = here.source.cursor
  local question, answer = pandoc.List(), nil
  for _, b in ipairs(x.content) do
    if b.t == "Div" and b.classes[1] == "answer" then
      answer = b
    else
      question:insert(b)
    end
  end
  if not answer or #answer.content == 0 then
    faults.add(here.source.path, line, "this quick question has no answer")
  end
  if #question == 0 then
    faults.add(here.source.path, line, "this quick question asks nothing")
  end
  local name = ("%s-%d"):format(here.id, #here.answers + 1)
  question = weave.blocks(question)
  question:insert(1, raw_block(
    ("%s\\begin{quick}{%s}"):format(mark(line), name)))
  question:insert(raw_block("\\end{quick}"))
  local woven = answer and weave.blocks(answer.content) or pandoc.List()
  woven:insert(1, raw_block(("\\begin{quickanswer}{%s}"):format(name)))
  woven:insert(raw_block("\\end{quickanswer}"))
  table.insert(here.answers, woven)
  return question
end

function block.Div(x)
  if #x.classes == 0 and x.identifier:match("^tab:") then
    return labelled_table(x)
  end
  local class = class_of(x, div_attributes, "division",
    x.classes[1] and "::: " .. x.classes[1] or ":::")
  if class == "quick" then
    return quick(x)
  elseif class == "answer" or class == "hint" then
    -- Of an exercise, for the instructor and for `make hint`: checked
    -- with the rest, but not printed.
    if not here.exercise then
      fault("::: " .. class, class == "hint"
        and "a hint belongs into an exercise"
        or "this answer belongs to no question")
    end
    weave.blocks(x.content)
    return pandoc.List()
  end
  return weave.blocks(x.content)
end

-- ---- code -------------------------------------------------------------
local function check_width(lines, first_line)
  for i, line in ipairs(lines) do
    local width = utf8.len(line) or #line
    if width > fragments.COLUMNS then
      faults.add(here.source.path, first_line and first_line + i - 1
        or here.source.cursor, "this line is %d columns wide, and the "
        .. "page has %d: %s", width, fragments.COLUMNS, line)
    end
  end
end

function code.fragment(x)
  local result = pandoc.List()
  for _, title in ipairs(files.split(x.text)) do
    title = title:match("^%s*(.-)%s*$")
    local fragment = book.fragments.by_title[title]
    local line = here.source:seek_line(title)
    if title == "" then
      -- nothing between two titles
    elseif not fragment then
      faults.add(here.source.path, line, 'no fragment is called "%s"', title)
    elseif fragment.shown then
      faults.add(here.source.path, line,
        'the fragment "%s" is shown twice, here and at %s', title,
        fragment.shown)
    else
      fragment.shown = ("%s:%d"):format(here.source.path, line)
      fragment.chapter = here.id
      result:insert(raw_block(mark(line) .. listing.fragment(fragment)))
    end
  end
  return result
end

function code.c(x, lines)
  local first = here.source:seek_line(lines[1])
  check_width(lines, first)
  local fails, body = false, false
  for i = 2, #x.classes do
    if x.classes[i] == "fails" then fails = true
    elseif x.classes[i] == "body" then body = true
    else fault(lines[1], 'the class "%s" is unknown for C', x.classes[i])
    end
  end
  local given = body and (x.attributes.given or "void") or nil
  local compiled, line, message = capture.compile(book.job, x.text,
    here.source.path, first, given)
  if not compiled and not fails then
    faults.add(here.source.path, line, "this does not compile: %s", message)
  elseif compiled and fails then
    faults.add(here.source.path, first,
      "this is said to fail, but it compiles")
  end
  return raw_block(mark(first) .. listing.illustration(lines))
end

function code.output(x)
  local command = x.attributes.run
  if not command then
    fault("{.output", "output needs its command: run=\"...\"")
    return pandoc.List()
  end
  local line = here.source:seek('"' .. command .. '"')
  local words = '"' .. command .. '"'
  local expected = integer(x.attributes.status, words, "status") or 0
  local shown = integer(x.attributes.lines, words, "lines")
  if x.text:match("%S") then
    fault(words, "output is captured, not typed: leave the block empty")
  end
  local lines, status = capture.output(book.job, command)
  if status ~= expected then
    fault(words, '"%s" ended with status %d, not %d; it said: %s', command,
      status, expected, lines[#lines] or "nothing")
  end
  if shown and shown < #lines then
    lines = table.move(lines, 1, shown, 1, {})
    table.insert(lines, "...")
  end
  check_width(lines)
  check_width({ "$ " .. command }, line)
  return raw_block(mark(line) .. listing.output(command, lines))
end

function block.CodeBlock(x)
  local lines = files.split(x.text)
  local class = x.classes[1]
  if #x.classes > 0 then
    class = class_of(x, code_attributes, "code block",
      x.classes[1] == "output" and "{.output" or lines[1])
  end
  if code[class] then return code[class](x, lines) end
  local first = here.source:seek_line(lines[1])
  check_width(lines, first)
  return raw_block(mark(first) .. listing.plain(lines))
end

-- ---- a whole text -----------------------------------------------------
-- The book that everything woven from now on belongs to.
function weave.into(the_book)
  book = the_book
end

-- Weaves the blocks of one file. `text` has its source, the chapter's
-- id, whether it is an exercise, and collects the answers.
function weave.text(text, blocks)
  here = text
  return weave.blocks(blocks)
end

return weave
