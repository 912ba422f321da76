-- The instructor's manual: the texts of book/manual, which hold the
-- plans of a course, and every exercise with all that the book keeps
-- back. What is numbered in the book has its number there.
local context = require "context"
local exam = require "exam"
local exercises = require "exercises"
local faults = require "faults"
local files = require "files"
local latex = require "latex"
local listing = require "listing"
local numbering = require "numbering"
local parts = require "parts"
local source = require "source"
local weave = require "weave"

local manual = {}

local numbers           -- of what the book has numbered
local by_number = {}    -- the exercises
local weeks             -- of the plan at hand

local function raw_block(text, ...)
  return pandoc.RawBlock("latex", text:format(...))
end

local function fault(words, sentence, ...)
  return context.fault(words, sentence, ...)
end

-- ---- the plans --------------------------------------------------------
local function command(lines)
  for i, line in ipairs(lines) do lines[i] = latex.code(line) end
  return raw_block("\\begin{commands}\n%s\n\\end{commands}",
    "\\codeline{" .. table.concat(lines, "}\n\\codeline{") .. "}")
end

-- What is shown in a lecture: commands, of which a test runs each, or
-- the one that the attribute "quick" names.
function weave.code.demo(_, lines)
  local shown = {}
  for i, line in ipairs(lines) do shown[i] = "$ " .. line end
  return command(shown)
end

local names = { ch = "Chapter", sec = "Section" }

-- "sec:line..sec:ways ch:ch05" as Sections 4.1 to 4.4, Chapter 5.
local function reading(text)
  local parts = {}
  for word in text:gmatch("%S+") do
    local first, last = word:match("^(.-)%.%.(.+)$")
    local from, to = numbers[first or word], numbers[last]
    local kind = names[word:match("^(%a+):")]
    if not kind or not from or last and not to then
      fault('read="', 'the book has nothing to read that is "%s"', word)
    elseif to then
      table.insert(parts, ("%ss~%s to~%s"):format(kind, from, to))
    else
      table.insert(parts, ("%s~%s"):format(kind, from))
    end
  end
  return table.concat(parts, ", ")
end

local function link(exercise)
  return ("\\hyperref[%s]{\\mbox{%s}}"):format(exercise.label,
    exercise.number)
end

-- A sheet as it is set. Exercises to choose one of make a sheet each,
-- and are worth the same.
local function set(list, choose)
  local titles, points, minutes = {}, 0, 0
  for _, e in ipairs(list) do
    table.insert(titles, ("%s~\\textit{%s}"):format(link(e), e.title))
    points, minutes = points + e.points, minutes + e.minutes
    if choose and (e.points ~= list[1].points or
      e.minutes ~= list[1].minutes) then
      fault('choose="', "who chooses %s has more or less to do", e.number)
    end
  end
  if choose then points, minutes = list[1].points, list[1].minutes end
  local time = exercises.time(exercises.roughly(minutes))
  return raw_block("\\manualitem{Set} %s%s: %d~points, about %s.\\par",
    choose and "one of " or "", table.concat(titles, ", "), points, time),
    time
end

local function sheets(list, a)
  if not a.choose then
    return command { ('$ make sheet EXERCISES="%s" \\'):format(a.exercises),
      ('    TITLE="%s" DUE="..."'):format(a.sheet) }
  end
  local lines = {}
  for i, e in ipairs(list) do
    lines[i] = ('$ make sheet EXERCISES="%s" TITLE="%s %s" DUE="..."')
      :format(e.number, a.sheet, e.number)
  end
  return command(lines)
end

-- What is read in a week, and the sheet that is set.
function weave.code.week(x)
  local a, list, links = x.attributes, {}, {}
  for word in (a.exercises or ""):gmatch("%S+") do
    local exercise = by_number[word]
    if not exercise then
      fault('exercises="', 'there is no exercise %s', word)
    else
      table.insert(list, exercise)
      table.insert(links, link(exercise))
    end
  end
  if #links == 0 or not a.read or not a.sheet then
    fault("{.week", "a week needs read, sheet and exercises")
    return pandoc.List()
  end
  if a.choose and a.choose ~= "one" then
    fault('choose="', 'only one can be chosen, choose="one"')
  end
  local read, task, time = reading(a.read), set(list, a.choose)
  table.insert(weeks, { title = weeks.title, read = read,
    links = (a.choose and "one of " or "") .. table.concat(links, ", "),
    time = time })
  return pandoc.List {
    raw_block("\\manualitem{Read} %s.\\par", read),
    task,
    sheets(list, a),
  }
end

weave.code_attributes.demo = { quick = true }
weave.code_attributes.week = { read = true, sheet = true,
  exercises = true, choose = true }

-- A plan's weeks in one table.
local function overview(list)
  local lines = {}
  for _, week in ipairs(list) do
    table.insert(lines, ("%s & %s & %s & %s\\\\"):format(week.title,
      week.read, week.links, week.time))
  end
  return raw_block("\\begin{overview}\n%s\n\\end{overview}",
    table.concat(lines, "\n"))
end

-- ---- what each chapter teaches ----------------------------------------
-- Its aims and what it needs, as its own head tells them.
local function teaches(path)
  local chapter = parts.read(context.book.job, path)
  local title = latex.prose(pandoc.utils.stringify(chapter.title))
  local blocks = pandoc.List { raw_block("\\addsec{%d\\enskip %s}",
    chapter.number, title) }
  blocks:extend(parts.quote(chapter, chapter.aims))
  blocks:extend(parts.quote(chapter, chapter.needs))
  return blocks
end

local function aims(job)
  local blocks = pandoc.List { raw_block("\\addchap{What each chapter "
    .. "teaches and needs}At the end of a chapter, students can do what "
    .. "stands here: its own head says so.\\par") }
  for _, path in ipairs(job.chapters) do blocks:extend(teaches(path)) end
  return blocks
end

-- ---- the exam -----------------------------------------------------------
local function questions(job)
  if #job.exams == 0 then return pandoc.List() end
  local blocks = pandoc.List { raw_block("\\addchap{Exam questions}") }
  for _, path in ipairs(job.exams) do
    blocks:insert(raw_block("\\addsec{Chapter %d}",
      tonumber(files.id(path):sub(3))))
    blocks:extend(exam.printed(path))
  end
  return blocks
end

-- ---- a text ---------------------------------------------------------------
-- One of the texts. A plan's second-level titles name its weeks, and a
-- table of them stands before the first.
local function chapter(path)
  local doc = pandoc.read(files.read(path), context.book.job.dialect)
  local text = source.open(path)
  local title = doc.blocks[1]
  doc.blocks:remove(1)
  weeks = {}
  local blocks, first = pandoc.List(), nil
  local here = { source = text, id = files.name(path), front = true,
    answers = {} }
  for _, block in ipairs(doc.blocks) do
    if block.t == "Header" then
      weeks.title = latex.text(pandoc.utils.stringify(block.content))
      first = first or #blocks + 1
    end
    blocks:extend(weave.text(here, pandoc.List { block }))
  end
  if #weeks > 0 then blocks:insert(first, overview(weeks)) end
  blocks:insert(1, raw_block("\\pressat{%s:1}\\addchap{%s}", path,
    latex.text(pandoc.utils.stringify(title.content))))
  return blocks
end

-- ---- the exercises ----------------------------------------------------
-- The solution as students see it filled in: what is given in the
-- starter is gray. Its opening comment is told by the reasoning.
local function solution(path)
  local lines, part, begun, in_comment = {}, "", false, false
  for _, line in ipairs(files.lines(path)) do
    local mark = line:match("^%s*//%- (%a+)$")
    begun = begun or not line:match("^//")
    if mark then
      part = mark == "end" and "" or mark
    elseif begun and part ~= "starter" and (line ~= "" or
      lines[#lines] and lines[#lines] ~= "") then
      local code
      code, in_comment = listing.code_line(line, in_comment)
      if part == "" and line ~= "" then
        code = "\\startercode{" .. code .. "}"
      end
      table.insert(lines, code)
    end
  end
  if lines[#lines] == "" then table.remove(lines) end
  return raw_block(
    "\\solutionfile{%s}\\begin{solution}\n%s\n\\end{solution}",
    latex.code(path), listing.stacked(lines))
end

-- The mistakes that the mutants plant: what is wrong, why students do
-- it, and words of the message they get.
local function mistakes(folder)
  local items = {}
  local pipe = io.popen("ls '" .. folder .. "/mutants' | sort")
  for name in pipe:lines() do
    local path = folder .. "/mutants/" .. name
    local lines = files.lines(path)
    local what = lines[1]:match("^# (.+)$")
    local said = (lines[2] or ""):match("^# expect: (.+)$")
    local why = (lines[3] or ""):match("^# why: (.+)$")
    if not (what and said and why) then
      faults.add(path, 1, "a mutant's first lines say which mistake, "
        .. '"# expect: ", and "# why: "')
    else
      table.insert(items, ("\\mistake{%s}{%s}{%s}"):format(latex.prose(what),
        latex.prose(why), latex.prose(said)))
    end
  end
  pipe:close()
  return raw_block("\\begin{mistakes}\n%s\n\\end{mistakes}",
    table.concat(items, "\n"))
end

-- A paragraph of advice may begin with "(a)" and go on to "(b)": that is
-- no list of one.
local function unlisted(blocks)
  local result = pandoc.List()
  for _, block in ipairs(blocks) do
    if block.t == "OrderedList" and #block.content == 1 then
      local item = block.content[1]
      for _, inner in ipairs(item) do
        if inner.t == "Para" or inner.t == "Plain" then
          local letter = string.char(96 + block.listAttributes.start)
          inner.content:insert(1, pandoc.Str("(" .. letter .. ") "))
          break
        end
      end
      result:extend(item)
    else
      result:insert(block)
    end
  end
  return result
end

local function kept(exercise, class, blocks, head)
  for i, part in ipairs(exercise.kept[class]) do
    blocks:insert(raw_block("\\manualhead{%s}", #exercise.kept[class] > 1
      and ("%s %d"):format(head, i) or head))
    blocks:extend(class == "marking" and unlisted(part) or part)
  end
  if #exercise.kept[class] == 0 and class ~= "hint" then
    faults.add(exercise.path, 1, 'the manual needs its "::: %s"', class)
  end
end

local function with_all(exercise)
  local folder = exercise.path:match("^(.*)/")
  local blocks = pandoc.List(exercise.blocks)
  blocks:insert(1, raw_block(
    ("\\pressat{%s:1}\\manualexercise{%s}{%s}{%s}{%d}{%s}{%d}{%s}{%s}{%s}")
    :format(exercise.path, exercise.number, exercise.label, exercise.title,
      exercise.stars, exercises.time(exercise.minutes), exercise.points,
      exercise.programmed and "programmed" or "on paper", exercise.trains,
      exercise.needs)))
  if exercise.programmed then
    kept(exercise, "reasoning", blocks, "Solution")
    blocks:insert(solution(folder .. "/solution.c"))
    blocks:insert(raw_block("\\manualhead{Common mistakes}"))
    blocks:insert(mistakes(folder))
  else
    kept(exercise, "answer", blocks, "Answer")
  end
  kept(exercise, "marking", blocks, "Marking")
  kept(exercise, "hint", blocks, "Hint")
  return blocks
end

-- All exercises of a chapter.
local function solutions(path, list)
  local title = files.read(path):match("^# *([^\n{]-) *[\n{]")
  local number = tonumber(path:match("/ch(%d%d)"))
  local blocks = pandoc.List {
    raw_block("\\manualchapter{%d}{%s}", number, latex.prose(title)) }
  for _, exercise in ipairs(list) do blocks:extend(with_all(exercise)) end
  return blocks
end

function manual.assemble(job, meta)
  local front = pandoc.read(files.read(job.manual.front), job.dialect)
  for key, value in pairs(front.meta) do meta[key] = value end
  meta.manual = true
  meta.elsewhere = true
  local read = {}
  for i, path in ipairs(job.chapters) do
    local id = files.name(path):match("^ch%d%d")
    read[i] = {}
    for _, exercise in ipairs(job.exercises[id] or {}) do
      local e = exercises.read(job, { id = id,
        number = tonumber(id:sub(3)) }, exercise)
      if e then
        by_number[e.number] = e
        table.insert(read[i], e)
      end
    end
  end
  numbers = numbering.of_book(job)
  local blocks = pandoc.List { numbering.latex(numbers),
    raw_block("\\frontmatter\\makebook\\mainmatter") }
  blocks:insert(raw_block("\\openpart{1}{The course}"))
  for i, path in ipairs(job.manual.texts) do
    if i == 2 then blocks:extend(aims(job)) end
    blocks:extend(chapter(path))
  end
  blocks:extend(questions(job))
  blocks:insert(raw_block("\\openpart{2}{The exercises}"))
  for i, path in ipairs(job.chapters) do
    if #read[i] > 0 then blocks:extend(solutions(path, read[i])) end
  end
  blocks:insert(raw_block("\\openbackmatter\\literature"))
  blocks:insert(pandoc.Div({}, { id = "refs" }))
  return blocks
end

return manual
