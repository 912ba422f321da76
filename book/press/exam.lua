-- Exam questions, of book/manual/exam/chNN.md. A title of the second
-- level begins a question and says of which kind it is, and its points:
--
--   ## Title {.choice points=2}    one of a list of tasks, - [x], is right
--   ## Title {.number points=2 answer=8 tolerance=0}
--   ## Title {.essay points=6}
--
-- and the division "answer" says why, or how an essay is marked.
local context = require "context"
local faults = require "faults"
local files = require "files"
local latex = require "latex"
local source = require "source"
local weave = require "weave"

local exam = {}

local FEWEST, MOST = 3, 6 -- options of a choice
local kinds = { choice = "one is right", number = "a number",
  essay = "in words" }

-- Takes the box from the head of a task: whether it was checked.
local function checked(item)
  local content = item[1].content
  local box = content[1] and content[1].text
  if box ~= "\u{2610}" and box ~= "\u{2612}" then return nil end
  local rest = pandoc.List { table.unpack(content, 3) }
  item[1] = pandoc.Plain(rest)
  return box == "\u{2612}"
end

local function options(list, path, line)
  local result, right = {}, 0
  for _, item in ipairs(list.content) do
    local blocks = pandoc.List(item)
    local is_right = checked(blocks)
    if is_right == nil then
      faults.add(path, line, "an option begins with [ ] or [x]")
    end
    right = right + (is_right and 1 or 0)
    table.insert(result, { right = is_right, blocks = blocks })
  end
  if right ~= 1 or #result < FEWEST or #result > MOST then
    faults.add(path, line, "of %d options %d are right: one of %d to %d "
      .. "should be", #result, right, FEWEST, MOST)
  end
  return result
end

local function number(text, path, line, what)
  local n = tonumber(text or "")
  if not n or n < 0 then
    faults.add(path, line, "a question needs %s", what)
  end
  return n or 0
end

local function question(header, text)
  local path, a = text.path, header.attributes
  local title = pandoc.utils.stringify(header.content)
  local line = text:seek("## " .. title)
  local kind = header.classes[1]
  if not kinds[kind] then
    faults.add(path, line, "a question is a choice, a number or an essay")
    kind = "essay"
  end
  local q = { kind = kind, title = title, line = line, text = pandoc.List(),
    points = math.tointeger(number(a.points, path, line, "points=")) or 0 }
  if kind == "number" then
    q.answer = number(a.answer, path, line, "answer=")
    q.tolerance = number(a.tolerance, path, line, "tolerance=")
  end
  return q
end

local function add(q, block, path)
  if block.t == "Div" and block.classes[1] == "answer" then
    q.reason = block.content
  elseif q.kind == "choice" and block.t == "BulletList" then
    q.options = options(block, path, q.line)
  else
    q.text:insert(block)
  end
end

-- The questions of a file.
function exam.read(path, dialect)
  local text, list = source.open(path), {}
  local doc = pandoc.read(files.read(path), dialect)
  for _, block in ipairs(doc.blocks) do
    if block.t == "Header" then
      table.insert(list, question(block, text))
    elseif #list == 0 then
      faults.add(path, 1, "questions begin with a title: ## ...")
    else
      add(list[#list], block, path)
    end
  end
  for _, q in ipairs(list) do
    if not q.reason or #q.text == 0 or q.kind == "choice" and not q.options then
      faults.add(path, q.line, "this question has no text, no options or "
        .. "no answer")
      q.reason, q.options = q.reason or pandoc.List(), q.options or {}
    end
  end
  return list
end

-- What to say before the reason: which option, or which number.
function exam.short(q)
  if q.kind == "number" then
    local text = math.tointeger(q.answer) or q.answer
    return q.tolerance > 0 and ("%s, give or take %s"):format(text,
      math.tointeger(q.tolerance) or q.tolerance) or tostring(text)
  end
  for i, option in ipairs(q.options or {}) do
    if option.right then return "(" .. string.char(96 + i) .. ")" end
  end
  return nil
end

-- The questions of a chapter as the manual prints them.
function exam.printed(path)
  local blocks = pandoc.List()
  local here = { source = source.open(path), id = files.id(path),
    front = true, answers = {} }
  for _, q in ipairs(exam.read(path, context.book.job.dialect)) do
    blocks:insert(pandoc.RawBlock("latex",
      ("\\pressat{%s:%d}\\examquestion{%s}{%d}{%s}"):format(path, q.line,
        latex.prose(q.title), q.points, kinds[q.kind])))
    blocks:extend(weave.text(here, q.text))
    if q.options then
      local items = {}
      for i, option in ipairs(q.options) do items[i] = option.blocks end
      blocks:extend(weave.text(here, pandoc.List { pandoc.OrderedList(items,
        pandoc.ListAttributes(1, "LowerAlpha", "TwoParens")) }))
    end
    blocks:insert(pandoc.RawBlock("latex", ("\\examanswer{%s}"):format(
      exam.short(q) or "")))
    blocks:extend(weave.text(here, pandoc.List(q.reason)))
  end
  return blocks
end

return exam
