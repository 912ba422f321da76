-- The press: chapters, code, exercises and data in, the book out.
--
--   texlua book/press/press.lua [--solutions] [--check | --draft]
--                               [--only NAME] [--root DIR] [--build DIR]
--   texlua book/press/press.lua --sheet PDF TITLE DUE HOW EXERCISE.MD...
--   texlua book/press/press.lua --slides SLIDES.MD [--check | --draft]
--   texlua book/press/press.lua --export DIR
--   texlua book/press/press.lua --web DIR
--
-- Writes BUILD/near-and-far.pdf, and BUILD/book/pages.tsv with the pages
-- of every chapter. Programs must have been built and figures drawn
-- before. A fault is reported as "file:line: sentence"; then there is no
-- book, and the exit status is 1. --check does everything but LaTeX;
-- --draft sets what there is, faults and all, as BUILD/draft.pdf; with
-- --only ch04, or an appendix, just that one, as BUILD/draft-ch04.pdf,
-- in two runs of LaTeX: pages elsewhere are then printed as ??.
-- --solutions makes the instructor's manual, BUILD/solutions.pdf, instead.
-- --sheet prints chosen exercises as an assignment, which ends with the
-- Markdown file HOW. --slides makes BUILD/slides/ch04.pdf of a chapter's
-- slides; of a folder, --check looks at all. --export writes exam questions
-- and exercises for courses' systems to DIR, in which is a folder canvas.
-- --web writes the web edition's pages to DIR.
local lfs = require "lfs"

local here = arg[0]:match("^(.*)/[^/]*$") or "."
if not here:match("^/") then here = lfs.currentdir() .. "/" .. here end
package.path = here .. "/?.lua;" .. package.path

local faults = require "faults"
local files = require "files"
local typeset = require "typeset"

local function usage(sentence)
  io.stderr:write("press: ", sentence, "\n")
  os.exit(2)
end

local function absolute(path)
  if path:match("^/") then return path end
  return (lfs.currentdir() .. "/" .. path)
end

-- ---- the command line -------------------------------------------------
local root, build, mode, sheet = lfs.currentdir(), nil, nil, nil
local manual, only, slides, export, web = false, nil, nil, nil, nil
local i = 1
while arg[i] do
  if arg[i] == "--check" or arg[i] == "--draft" then
    mode = arg[i]
  elseif arg[i] == "--solutions" then
    manual = true
  elseif arg[i] == "--only" and arg[i + 1] then
    i = i + 1
    only = arg[i]
  elseif arg[i] == "--slides" and arg[i + 1] then
    i = i + 1
    slides = arg[i]
  elseif arg[i] == "--export" and arg[i + 1] then
    i = i + 1
    export, mode = absolute(arg[i]), "--check"
  elseif arg[i] == "--web" and arg[i + 1] then
    i = i + 1
    web, mode = absolute(arg[i]), "--check"
  elseif arg[i] == "--root" and arg[i + 1] then
    i = i + 1
    root = absolute(arg[i])
  elseif arg[i] == "--build" and arg[i + 1] then
    i = i + 1
    build = absolute(arg[i])
  elseif arg[i] == "--sheet" and arg[i + 5] then
    sheet = { pdf = absolute(arg[i + 1]), title = arg[i + 2],
      due = arg[i + 3], how = absolute(arg[i + 4]),
      exercises = { table.unpack(arg, i + 5) } }
    i = #arg
  else
    usage("what is " .. arg[i] .. "?")
  end
  i = i + 1
end
if not lfs.chdir(root) then usage("there is no folder " .. root) end
build = build or root .. "/build"

-- ---- what there is ----------------------------------------------------
-- Names in order; of exercises 9-this comes before 10-that.
local function in_order(a, b)
  local m, n = tonumber(a:match("^(%d+)%-")), tonumber(b:match("^(%d+)%-"))
  if m and n and m ~= n then return m < n end
  return a < b
end

-- All files below a folder, in order, whose path matches.
local function below(folder, pattern, found)
  found = found or {}
  if lfs.attributes(folder, "mode") ~= "directory" then return found end
  local names = {}
  for name in lfs.dir(folder) do
    if not name:match("^%.") then table.insert(names, name) end
  end
  table.sort(names, in_order)
  for _, name in ipairs(names) do
    local path = folder .. "/" .. name
    if lfs.attributes(path, "mode") == "directory" then
      below(path, pattern, found)
    elseif path:match(pattern) then
      table.insert(found, path)
    end
  end
  return found
end

local folder = build .. (sheet and "/sheet" or manual and "/solutions"
  or slides and "/slides/" .. files.id(slides) or export and "/exported"
  or web and "/woven" or only and "/draft-" .. only or "/book")
files.make_folder(folder)

local job = {
  press = here, folder = folder, build = build,
  cc = os.getenv("CC") or "cc",
  dialect = "markdown-auto_identifiers",
  front = "book/front.md", bibliography = "book/references.bib",
  code = below("code", "[^~]$"),
  data = below("book/data", "%.tsv$"),
  chapters = below("chapters", "^chapters/ch%d%d[^/]*%.md$"),
  appendices = below("chapters", "^chapters/appendix%-[^/]*%.md$"),
  glossary = "book/glossary.md",
  -- The newest in the list of changes.
  version = (files.read("CHANGES.md") or ""):match("\n## *([^%s,]+)"),
  exercises = {}, headers = {}, sheet = sheet, only = only,
  export = export, web = web, exams = below("book/manual/exam", "/ch%d%d[^/]*%.md$"),
  slides = slides and (lfs.attributes(slides, "mode") == "directory"
    and below(slides, "/ch%d%d[^/]*%.md$") or { slides }),
}
if manual then
  job.manual = { front = "book/manual/front.md",
    texts = below("book/manual", "/%d[^/]*%.md$") }
end
for _, path in ipairs(below("exercises", "/exercise%.md$")) do
  local chapter = path:match("^exercises/([^/]*)/")
  job.exercises[chapter] = job.exercises[chapter] or {}
  table.insert(job.exercises[chapter], path)
end
-- What has a page of its own in the web edition.
if web then
  job.files = { "Makefile", "setup" }
  for _, part in ipairs { { "code", "[^~]$" }, { "book/data", "%.tsv$" },
    { "book/drawings", "[^~]$" }, { "book/experiments", "[^~]$" },
    { "book/figures", "%.gp$" }, { "book/press", "[^~]$" },
    { "tests", "^tests/ch%d%d.*%.[ch]$" }, { "tests/corpus", "%.[ch]$" },
    { "tests/near", "%.[ch]$" }, { "tests/instructions", "%.[ch]$" },
    { "tests", "^tests/harness%.[ch]$" } } do
    below(part[1], part[2], job.files)
  end
end
for header in ("inttypes math stdbool stdint stdio stdlib string omp")
  :gmatch("%a+") do
  table.insert(job.headers, "<" .. header .. ".h>")
end
for _, path in ipairs(below("code/common", "%.h$")) do
  table.insert(job.headers, '"' .. path:gsub("^code/", "") .. '"')
end
for _, path in ipairs { job.front, job.bibliography,
  job.manual and job.manual.front or job.slides and job.slides[1] } do
  if not files.exists(path) then faults.add(path, 1, "this file is missing") end
end
if only then
  local there = false
  for _, list in ipairs { job.chapters, job.appendices } do
    for _, path in ipairs(list) do
      there = there or files.id(path) == only
    end
  end
  if not there then usage("no chapter and no appendix is called " .. only) end
  if mode ~= "--check" then mode = "--draft" end
end
if #job.chapters == 0 then faults.add("chapters", 1, "there is no chapter") end

-- ---- the stages ---------------------------------------------------------
-- Prints the faults, one a line, and ends the press if there are any.
-- A draft goes on.
local function stop_at(text)
  if text == "" then return end
  local _, count = text:gsub("[^\n]+", "")
  io.stderr:write(text, "\n", ("press: %d fault%s\n"):format(count,
    count == 1 and "" or "s"))
  if mode ~= "--draft" then os.exit(1) end
end

-- From Markdown to LaTeX, or to the pages of the web edition.
local function weave()
  os.remove(folder .. "/faults")
  files.write(folder .. "/job.lua", "return " .. files.source_of(job) .. "\n")
  files.write(folder .. "/driver.md", "")
  local good = files.succeeds(([[
    export PRESS_JOB='%s/job.lua'
    pandoc --quiet -f markdown '%s/driver.md' \
      --lua-filter='%s/book.lua' --citeproc --bibliography='%s' \
      --lua-filter='%s/bibliography.lua' -M link-citations=true \
      --top-level-division=chapter --wrap=preserve ]]):format(folder, folder,
      here, job.bibliography, here) .. (web
    and ("--lua-filter='%s/webpages.lua' -t html -o '%s/book.html'"):format(
      here, folder)
    or ("-t latex --template='%s/%s.tex' -o '%s/book.tex'"):format(here,
      slides and "slides" or "template", folder)))
  local found = files.read(folder .. "/faults")
  if not good or not found then
    io.stderr:write(found or "", "press: pandoc failed\n")
    os.exit(1)
  end
  local notes = files.read(folder .. "/notes")
  if notes ~= "" then io.stderr:write(notes, "\n") end
  stop_at(found)
end

-- What pages.tsv says of a chapter, but for the pages.
local function about(path)
  local id = files.id(path)
  return { id = id, number = tonumber(id:sub(3)),
    title = files.read(path):match("^# *([^\n{]-) *[\n{]"):gsub("`", "") }
end

stop_at(faults.report())
weave()
if web then stop_at(files.read(folder .. "/lost")) end
if mode == "--check" then os.exit(0) end
files.write(folder .. "/index.ist", files.read(here .. "/index.ist"))
local chapters = {}
for _, path in ipairs((sheet or manual or only or slides) and {}
  or job.chapters) do
  table.insert(chapters, about(path))
end
local sources = below("exercises", "/exercise%.md$")
for _, list in ipairs { job.code, job.chapters, job.appendices, job.data,
  job.manual and job.manual.texts or {}, job.slides or {},
  { job.front, job.bibliography } } do
  table.move(list, 1, #list, #sources + 1, sources)
end
typeset.run(folder, chapters, sources, (only or slides) and 2)
local noted = faults.report_notes()
if noted ~= "" then io.stderr:write(noted, "\n") end
stop_at(faults.report())
local pdf = sheet and sheet.pdf or slides and folder .. ".pdf"
  or build .. (only and "/draft-" .. only
  .. ".pdf" or mode == "--draft" and "/draft.pdf"
  or manual and "/solutions.pdf" or "/near-and-far.pdf")
if not os.rename(folder .. "/book.pdf", pdf) then os.exit(1) end
