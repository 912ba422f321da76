-- Turns what pandoc has read of one file into what will be set: follows
-- the blocks in their order through the text, replaces what is ours
-- (CONTRIBUTING.md, "The prose"), and finds the faults. What the things
-- are in LaTeX or in HTML, the edition knows (context.out).
local alternative = require "alternative"
local capture = require "capture"
local context = require "context"
local faults = require "faults"
local files = require "files"
local fragments = require "fragments"
local inlines = require "inlines"
local picture = require "picture"
local words_of = require "words"

local fault, class_of = context.fault, context.class_of
local opening = words_of.opening

local block, code = {}, {}
local here -- the text being woven

-- Which classes there are, and which attributes each of them knows.
local div_attributes = { quick = {}, answer = {}, hint = {},
  reasoning = {}, marking = {} }

-- Of an exercise, for whoever asks for them: woven with the rest, but
-- kept from the book.
local astray = {
  hint = "a hint belongs into an exercise",
  answer = "this answer belongs to no question",
  reasoning = "reasoning belongs into an exercise",
  marking = "advice for marking belongs into an exercise",
}

local code_attributes = {
  fragment = {},
  output = { run = true, status = true, lines = true },
  c = { given = true },
  sh = {}, text = {}, make = {}, tsv = {},
}

-- A text of another kind has blocks of its own.
local weave = { block = block, code = code,
  code_attributes = code_attributes }

-- After a listing, a small letter goes on with the sentence.
local function goes_on(x, previous)
  return x.t == "Para" and previous and previous.t == "CodeBlock"
    and opening(x.content):match("^%l") ~= nil
end

-- What stands before a listing or a small table introduces it.
local function introduces(x, following)
  return x.t == "Para" and following and (following.t == "CodeBlock"
    or following.t == "Table" and #following.caption.long == 0)
end

function weave.blocks(list)
  local result = pandoc.List()
  for i, x in ipairs(list) do
    local handler = block[x.t]
    if goes_on(x, list[i - 1]) then
      result:extend(context.out.continued())
    end
    local new = handler and handler(x) or x
    if new.t then result:insert(new) else result:extend(new) end
    if introduces(x, list[i + 1]) then
      result:extend(context.out.introduces())
    end
  end
  return result
end

-- A figure stands near its mention, as large as it was drawn.
local function figure(image, caption, identifier)
  local name, build = image.src, context.book.job.build
  local words = "(" .. name .. ")"
  here.source:seek(words)
  if identifier == "" then
    fault(words, "this figure needs a label: {#fig:%s}", name)
  end
  context.own_label(identifier, "fig", words)
  for attribute in pairs(image.attributes) do
    fault(words, 'the attribute "%s" is unknown for a figure', attribute)
  end
  local pdf, page
  if not name:match("^[%w-]+$") then
    fault(words, 'a figure is named like its script, without folder and '
      .. 'ending, not "%s"', name)
  else
    pdf, page = picture.find(build, "figures", name)
    if not pdf then
      fault(words, "there is no figure %s in %s/figures or %s/drawings",
        name, build, build)
    end
  end
  if #caption == 0 then fault(words, "this figure needs a caption") end
  context.caption = identifier ~= "" and identifier or nil
  local alternative_text = pdf and alternative.of(name) or ""
  local text = inlines.checked(caption)
  context.caption = nil
  return context.out.figure { name = name, pdf = pdf, page = page,
    label = identifier,
    alternative = alternative_text, caption = text,
    line = here.source.cursor }
end

local function paragraph(x)
  local text = inlines.paragraph(x.content)
  x.content = context.out.paragraph(text, here.source.cursor)
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
  local kind = "numbered"
  for _, class in ipairs(x.classes) do
    if class == "unnumbered" then
      kind = class
    else
      fault("." .. class, 'the class "%s" is unknown for a title', class)
    end
  end
  context.in_title = true
  local text = inlines.paragraph(x.content)
  context.in_title = false
  local title = context.out.header { level = x.level, content = text,
    line = here.source.cursor, label = x.identifier ~= "" and x.identifier,
    kind = here.exercise and "exercise" or here.front and "front" or kind }
  if not title then
    fault(opening(x.content), x.level == 1
      and "a chapter has one title, its first line"
      or "titles are not nested so deeply")
    return pandoc.List()
  end
  if x.identifier ~= "" then
    context.own_label(x.identifier, "sec", "#" .. x.identifier)
  end
  return title
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
    return { inlines.paragraph(item[1]),
      pandoc.List(item[2]):map(weave.blocks) }
  end)
  return x
end

function block.LineBlock(x)
  x.content = pandoc.List(x.content):map(inlines.paragraph)
  return x
end

function block.HorizontalRule()
  return context.out.asterism()
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
  return pandoc.utils.blocks_to_inlines(x.caption.long)
end

local function cells_woven(x)
  local function row(r)
    for _, cell in ipairs(r.cells) do
      local content = cell.contents
      for _, b in ipairs(content) do
        if not b.content or b.t ~= "Plain" and b.t ~= "Para" then
          fault("|", "a cell of a table holds words, nothing else")
        else
          b.content = inlines.paragraph(b.content)
        end
      end
    end
  end
  context.in_table = true
  for _, r in ipairs(x.head.rows) do row(r) end
  for _, part in ipairs(x.bodies) do
    for _, r in ipairs(part.body) do row(r) end
  end
  context.in_table = false
end

local function set_table(x, label)
  local caption = caption_of(x)
  local line = here.source.cursor
  cells_woven(x)
  if #caption == 0 and not label then
    return context.out.table { table = x, line = line }
  end
  if #caption == 0 then fault("#" .. label, "this table needs a caption") end
  context.caption = label
  caption = inlines.paragraph(caption)
  context.caption = nil
  return context.out.table { table = x, line = line, label = label,
    caption = caption }
end

function block.Table(x)
  return set_table(x, nil)
end

-- ---- divisions --------------------------------------------------------
local function labelled_table(x)
  local label = x.identifier
  here.source:seek("#" .. label)
  context.own_label(label, "tab", "#" .. label)
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
  local kept
  question, kept = context.out.quick { name = name, line = line,
    question = question, number = #here.answers + 1,
    answer = answer and weave.blocks(answer.content) or pandoc.List() }
  table.insert(here.answers, kept)
  return question
end

function block.Div(x)
  if #x.classes == 0 and x.identifier:match("^tab:") then
    return labelled_table(x)
  end
  local words = "::: " .. (x.classes[1] or "")
  if not here.source:ahead(words) then
    words = "::: {." .. (x.classes[1] or "")
  end
  local class = class_of(x, div_attributes, "division", words)
  if class == "quick" then
    return quick(x)
  elseif astray[class] then
    local kept = here.kept and here.kept[class] or {}
    here.source:seek(words)
    if not here.kept then
      fault(words, "%s", astray[class])
    elseif kept[1] and class ~= "hint" then
      fault(words, 'the exercise has two divisions "%s"', class)
    end
    table.insert(kept, weave.blocks(x.content))
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

function code.fragment(x, lines)
  local result = pandoc.List()
  if here.exercise then
    fault(lines[1], "an exercise shows no fragments")
  end
  for _, title in ipairs(lines) do
    title = title:match("^%s*(.-)%s*$")
    local fragment = context.book.fragments.by_title[title]
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
      result:insert(context.out.fragment(fragment, line))
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
  local compiled, line, message = capture.compile(context.book.job, x.text,
    here.source.path, first, given)
  if not compiled and not fails then
    faults.add(here.source.path, line, "this does not compile: %s", message)
  elseif compiled and fails then
    faults.add(here.source.path, first,
      "this is said to fail, but it compiles")
  end
  return context.out.illustration(lines, first, true)
end

function code.output(x)
  local command = x.attributes.run
  if not command then
    fault("{.output", "output needs its command: run=\"...\"")
    return pandoc.List()
  end
  local line = here.source:seek('"' .. command .. '"')
  local words = '"' .. command .. '"'
  local expected = context.integer(x.attributes.status, words, "status") or 0
  local shown = context.integer(x.attributes.lines, words, "lines")
  if x.text:match("%S") then
    fault(words, "output is captured, not typed: leave the block empty")
  end
  local lines, status = capture.output(context.book.job, command)
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
  return context.out.output(command, lines, line)
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
  return context.out.illustration(lines, first, false)
end

-- ---- a whole text -----------------------------------------------------
-- Weaves the blocks of one file. `text` has its source, the chapter's
-- id, whether it is an exercise or the front matter, and collects the
-- answers.
function weave.text(text, blocks)
  here = text
  context.here = text
  return weave.blocks(blocks)
end

return weave
