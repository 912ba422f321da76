-- Runs LuaLaTeX until the page numbers stand still, with the index
-- made on the way, and reads what LaTeX thinks of the result.
local faults = require "faults"
local files = require "files"
local log = require "log"

local typeset = {}

local MOST_RUNS = 6

-- What the next run will read: if none of it changed, we are done.
local function state(folder)
  local parts = {}
  for _, ending in ipairs { "aux", "toc", "ind", "out" } do
    table.insert(parts, files.read(folder .. "/book." .. ending) or "")
  end
  return table.concat(parts, "\0")
end

local function run(folder, command)
  return files.succeeds(("cd '%s' && max_print_line=10000 %s " ..
    ">>typeset.out 2>&1 </dev/null"):format(folder, command))
end

-- The page ranges of the chapters, from the labels at their ends.
local function write_pages(folder, chapters)
  local pages = {}
  for line in files.read(folder .. "/book.aux"):gmatch("[^\n]+") do
    local label, page = line:match("^\\newlabel{(.-)}{{.-}{(%w+)}")
    if label then pages[label] = page end
  end
  local lines = {}
  for _, chapter in ipairs(chapters) do
    table.insert(lines, table.concat({ chapter.number, chapter.title,
      pages["ch:" .. chapter.id], pages["end:" .. chapter.id] }, "\t"))
  end
  files.write(folder .. "/pages.tsv", table.concat(lines, "\n") .. "\n")
end

-- Notes the pages of the chapters that are not two thirds full, but for
-- a chapter's last.
local FULL = 66

local function note_holes(folder, text)
  local within = {}
  for _, line in ipairs(files.lines(folder .. "/pages.tsv")) do
    local first, last = line:match("\t(%d+)\t(%d+)$")
    for page = tonumber(first or 1), tonumber(last or 1) - 1 do
      within[page] = true
    end
  end
  for page, share in text:gmatch("\n@@page (%d+) (%d+)") do
    if within[tonumber(page)] and tonumber(share) < FULL then
      faults.note("page " .. page, 1, "only %d%% of this page is full",
        tonumber(share))
    end
  end
end

-- The first place among the sources where the words stand.
local function locate(words, sources)
  for _, path in ipairs(sources) do
    for number, line in ipairs(files.lines(path)) do
      if line:find(words, 1, true) then return path, number end
    end
  end
end

-- Makes book.pdf and pages.tsv of book.tex, and collects the faults. If
-- LaTeX gives up there is neither, whatever an earlier run left. A draft
-- has a limit of runs, no index, and pages that need not settle.
function typeset.run(folder, chapters, sources, limit)
  for _, name in ipairs { "typeset.out", "book.log", "book.pdf" } do
    os.remove(folder .. "/" .. name)
  end
  local before, good
  for _ = 1, limit or MOST_RUNS do
    before = state(folder)
    good = run(folder,
      "lualatex -interaction=nonstopmode -halt-on-error book.tex")
    if good and not limit and files.exists(folder .. "/book.idx") then
      good = run(folder, "makeindex -q -s index.ist book.idx")
    end
    if not good or state(folder) == before then break end
  end
  local text = files.read(folder .. "/book.log")
  if not text then
    faults.add("book.tex", 1, "lualatex could not be run")
    return
  end
  for _, fault in ipairs(log.faults(text)) do
    local path, line = fault[1], fault[2]
    if fault[4] then
      local other_path, other_line = locate(fault[4], sources)
      path, line = other_path or path, other_line or line
    end
    -- A first run that stopped knew no label.
    if good or not fault[3]:find("^there is nothing") then
      faults.add(path, line, "%s", fault[3])
    end
  end
  if good then
    write_pages(folder, chapters)
    note_holes(folder, text)
  else
    os.remove(folder .. "/book.pdf")
  end
  if #faults.list > 0 then return end
  if not good then
    faults.add("book.tex", 1, "LaTeX gave up: see %s/typeset.out", folder)
  elseif state(folder) ~= before and not limit then
    faults.add("book.tex", 1, "the pages do not settle in %d runs of LaTeX",
      MOST_RUNS)
  end
end

return typeset
