-- Exam questions and exercises for courses' systems: Moodle's XML, and
-- for Canvas QTI 1.2, a file for each chapter and a manifest, which
-- exercises/course/export packs. Written to job.export:
--
--   moodle.xml                   all of it, in categories
--   chapters/moodle-exam-ch04.xml, ...   the parts of it
--   canvas/imsmanifest.xml       names the files beside it
--   canvas/exam-ch04.xml, ...    the questions of a chapter
--   canvas/exercises-ch04.xml    its exercises, as files to hand in
local context = require "context"
local exam = require "exam"
local files = require "files"
local numbering = require "numbering"
local values = require "values"

local export = {}

local numbers -- of what the book has numbered
local names = { fig = "Figure", tab = "Table", sec = "Section",
  ch = "Chapter", ex = "Exercise" }

-- ---- from our Markdown to HTML ----------------------------------------
local plain = {}

function plain.Span(x)
  if x.classes[1] == "value" then
    local value = values.evaluate(pandoc.utils.stringify(x.content))
    return pandoc.Str(values.format(value, x.attributes.as,
      tonumber(x.attributes.digits)) or "?")
  end
  return x.content
end

function plain.Cite(x)
  local label = x.citations[1].id
  local kind = names[label:match("^(%a+):")]
  return kind and pandoc.Str(("%s %s"):format(kind, numbers[label] or "?"))
    or pandoc.Str("(" .. label .. ")")
end

function plain.CodeBlock(x)
  local command = x.attributes.run
  return pandoc.CodeBlock(command and "$ " .. command or x.text)
end

function plain.Image(x)
  return pandoc.Str("(the book's picture " .. x.src .. ")")
end

function plain.Div(x) return x.content end
function plain.RawInline() return {} end
function plain.RawBlock() return {} end

local function html(blocks)
  local doc = pandoc.Pandoc(pandoc.walk_block(pandoc.Div(blocks),
    plain).content)
  return pandoc.write(doc, "html", { html_math_method = "mathjax",
    wrap_text = "wrap-none" })
end

local escapes = { ["&"] = "&amp;", ["<"] = "&lt;", [">"] = "&gt;",
  ['"'] = "&quot;" }
local function escape(text) return (text:gsub('[&<>"]', escapes)) end

-- A template's @NAME@ replaced by values that are XML already.
local function fill(template, t)
  return (template:gsub("@(%u+)@", function(name) return t[name] end))
end

-- ---- Moodle -----------------------------------------------------------
local moodle = {}

moodle.question = [[
<question type="@TYPE@">
<name><text>@TITLE@</text></name>
<questiontext format="html"><text>@TEXT@</text></questiontext>
<generalfeedback format="html"><text>@REASON@</text></generalfeedback>
<defaultgrade>@POINTS@</defaultgrade>
<penalty>0.3333333</penalty>
<hidden>0</hidden>
@BODY@</question>
]]

local function moodle_answer(right, text, more)
  return ('<answer fraction="%d" format="%s"><text>%s</text>%s<feedback '
    .. 'format="html"><text></text></feedback></answer>\n'):format(
    right and 100 or 0, more and "moodle_auto_format" or "html",
    escape(text), more or "")
end

-- How a free answer is given: in words, or as a file.
local function moodle_essay(reason, attached)
  return fill([[
<responseformat>@FORMAT@</responseformat>
<responserequired>@REQUIRED@</responserequired>
<responsefieldlines>15</responsefieldlines>
<attachments>@FILES@</attachments>
<attachmentsrequired>@FILES@</attachmentsrequired>
<graderinfo format="html"><text>@REASON@</text></graderinfo>
<responsetemplate format="html"><text></text></responsetemplate>
]], { FORMAT = attached and "noinline" or "editor", FILES = attached and "1"
  or "0", REQUIRED = attached and "0" or "1", REASON = reason })
end

function moodle.body(q, reason)
  if q.kind == "essay" then return moodle_essay(reason, q.file) end
  if q.kind == "number" then
    return moodle_answer(true, exam.short { kind = "number",
      answer = q.answer, tolerance = 0 },
      ("<tolerance>%s</tolerance>"):format(q.tolerance))
  end
  local parts = { "<single>true</single>\n<shuffleanswers>true"
    .. "</shuffleanswers>\n<answernumbering>abc</answernumbering>\n" }
  for _, option in ipairs(q.options) do
    table.insert(parts, moodle_answer(option.right, html(option.blocks)))
  end
  return table.concat(parts)
end

local types = { choice = "multichoice", number = "numerical",
  essay = "essay" }

function moodle.write(q)
  local reason = escape(html(q.reason))
  return fill(moodle.question, { TYPE = types[q.kind],
    TITLE = escape(q.title), TEXT = escape(html(q.text)),
    REASON = q.kind == "essay" and "" or reason, POINTS = tostring(q.points),
    BODY = moodle.body(q, reason) })
end

function moodle.category(name)
  return ('<question type="category"><category><text>$course$/top/%s'
    .. "</text></category></question>\n"):format(escape(name))
end

-- ---- QTI 1.2, as Canvas reads it ----------------------------------------
local qti = {}

qti.item = [[
<item ident="@IDENT@" title="@TITLE@">
<itemmetadata><qtimetadata>
<qtimetadatafield><fieldlabel>question_type</fieldlabel><fieldentry>@TYPE@</fieldentry></qtimetadatafield>
<qtimetadatafield><fieldlabel>points_possible</fieldlabel><fieldentry>@POINTS@</fieldentry></qtimetadatafield>
</qtimetadata></itemmetadata>
@RUBRIC@<presentation>
<material><mattext texttype="text/html">@TEXT@</mattext></material>
@RESPONSE@</presentation>
<resprocessing>
<outcomes><decvar maxvalue="100" minvalue="0" varname="SCORE" vartype="Decimal"/></outcomes>
<respcondition continue="No"><conditionvar>@CONDITION@</conditionvar>@SET@</respcondition>
</resprocessing>
<itemfeedback ident="general_fb"><flow_mat><material><mattext texttype="text/html">@REASON@</mattext></material></flow_mat></itemfeedback>
</item>
]]

local SET = '<setvar action="Set" varname="SCORE">100</setvar>'
local TYPED = [[
<response_str ident="response1" rcardinality="Single"><render_fib><response_label ident="answer1" rshuffle="No"/></render_fib></response_str>
]]

local function qti_choice(q)
  local parts, right = { '<response_lid ident="response1" '
    .. 'rcardinality="Single"><render_choice>\n' }, nil
  for i, option in ipairs(q.options) do
    table.insert(parts, ('<response_label ident="%d"><material><mattext '
      .. 'texttype="text/html">%s</mattext></material></response_label>\n')
      :format(i, escape(html(option.blocks))))
    if option.right then right = i end
  end
  table.insert(parts, "</render_choice></response_lid>\n")
  return { TYPE = "multiple_choice_question", RESPONSE = table.concat(parts),
    CONDITION = ('<varequal respident="response1">%d</varequal>')
      :format(right or 1), SET = SET }
end

local function qti_number(q)
  return { TYPE = "numerical_question", SET = SET,
    RESPONSE = (TYPED:gsub("<render_fib>",
      '<render_fib fibtype="Decimal">')),
    CONDITION = ('<or><varequal respident="response1">%s</varequal><and>'
      .. '<vargte respident="response1">%s</vargte><varlte '
      .. 'respident="response1">%s</varlte></and></or>'):format(q.answer,
      q.answer - q.tolerance, q.answer + q.tolerance) }
end

local function qti_essay(q)
  return { TYPE = q.file and "file_upload_question" or "essay_question",
    RESPONSE = q.file and "" or TYPED, CONDITION = "<other/>", SET = "" }
end

-- How an answer is marked, for those who mark it.
local function qti_rubric(reason)
  return ('<rubric view="Scorer"><material><mattext texttype="text/html">'
    .. "%s</mattext></material></rubric>\n"):format(reason)
end

local responses = { choice = qti_choice, number = qti_number,
  essay = qti_essay }

function qti.write(q, ident)
  local t = responses[q.kind](q)
  t.IDENT, t.TITLE, t.POINTS = ident, escape(q.title), tostring(q.points)
  t.TEXT = escape(html(q.text))
  -- Students see a feedback: an essay's is for those who mark it.
  local essay, reason = q.kind == "essay", escape(html(q.reason))
  t.REASON = essay and "" or reason
  t.RUBRIC = essay and reason ~= "" and qti_rubric(reason) or ""
  return fill(qti.item, t)
end

qti.head = '<?xml version="1.0" encoding="UTF-8"?>\n'

function qti.assessment(ident, title, list)
  local items = {}
  for i, q in ipairs(list) do
    items[i] = qti.write(q, ("%s-%d"):format(ident, i))
  end
  return ('%s<questestinterop xmlns="http://www.imsglobal.org/xsd/'
    .. 'ims_qtiasiv1p2">\n<assessment ident="%s" title="%s">\n<section '
    .. 'ident="root_section">\n%s</section>\n</assessment>\n'
    .. '</questestinterop>\n'):format(qti.head, ident, escape(title),
    table.concat(items))
end

function qti.manifest(idents)
  local lines = {}
  for i, ident in ipairs(idents) do
    lines[i] = ('<resource identifier="%s" type="imsqti_xmlv1p2"><file '
      .. 'href="%s.xml"/></resource>'):format(ident, ident)
  end
  return ('%s<manifest identifier="near-and-far" xmlns="http://www.'
    .. 'imsglobal.org/xsd/imsccv1p1/imscp_v1p1">\n<metadata><schema>IMS '
    .. 'Content</schema><schemaversion>1.1.3</schemaversion></metadata>\n'
    .. '<organizations/>\n<resources>\n%s\n</resources>\n</manifest>\n')
    :format(qti.head, table.concat(lines, "\n"))
end

-- ---- what there is ------------------------------------------------------
-- An exercise as a question that is answered by a file. What its text
-- keeps back is for those who mark it.
local function exercise(path, number, dialect)
  local doc = pandoc.read(files.read(path), dialect)
  local function say(key) return pandoc.utils.stringify(doc.meta[key] or "") end
  local q = { kind = "essay", file = true, points = tonumber(say("points")),
    title = ("%s: %s"):format(number, say("title")), text = pandoc.List(),
    reason = pandoc.List() }
  for _, block in ipairs(doc.blocks) do
    local class = block.t == "Div" and block.classes[1]
    if class == "answer" or class == "marking" then
      q.reason:extend(block.content)
    elseif not class then
      q.text:insert(block)
    end
  end
  return q
end

local function exercises_of(job, id)
  local list = {}
  for _, path in ipairs(job.exercises[id] or {}) do
    table.insert(list, exercise(path, ("%d.%s"):format(tonumber(id:sub(3)),
      path:match("/(%d+)%-[^/]*/[^/]*$")), job.dialect))
  end
  return list
end

local function quiz(parts)
  return ("%s<quiz>\n%s</quiz>\n"):format(qti.head, table.concat(parts))
end

function export.assemble(job)
  numbers = numbering.of_book(job)
  local all, idents = {}, {}
  local function add(ident, title, list)
    if #list == 0 then return end
    table.insert(idents, ident)
    local part = { moodle.category("Near and Far/" .. title) }
    for _, q in ipairs(list) do table.insert(part, moodle.write(q)) end
    table.insert(all, table.concat(part))
    files.write(("%s/chapters/moodle-%s.xml"):format(job.export, ident),
      quiz(part))
    files.write(("%s/canvas/%s.xml"):format(job.export, ident),
      qti.assessment(ident, title, list))
  end
  for _, path in ipairs(job.exams) do
    local id = files.id(path)
    add("exam-" .. id, ("Chapter %d, exam"):format(tonumber(id:sub(3))),
      exam.read(path, job.dialect))
  end
  for _, path in ipairs(job.chapters) do
    local id = files.id(path)
    add("exercises-" .. id, ("Chapter %d, exercises"):format(
      tonumber(id:sub(3))), exercises_of(job, id))
  end
  files.write(job.export .. "/moodle.xml", quiz(all))
  files.write(job.export .. "/canvas/imsmanifest.xml", qti.manifest(idents))
  return pandoc.List()
end

return export
