-- Parts of a chapter that are also printed elsewhere, on slides and in
-- the instructor's manual: what its head says that a reader will be able
-- to do and needs, its tables, and what it says was learned.
local context = require "context"
local faults = require "faults"
local files = require "files"
local source = require "source"
local weave = require "weave"

local parts = {}

local stringify = pandoc.utils.stringify

local function is_aims(text)
  return text:match("able to[:.]?$") or text:match("you can[:.]?$")
    or text:match("^What you will be able to do")
    or text:match("^At the end of this chapter you will be able to ")
end

local function is_needs(text)
  return text:match("^You need ") or text:match("^What you need%.")
end

-- A paragraph without the bold words that introduce it.
local function unheaded(paragraph, pattern)
  local content = pandoc.List(paragraph.content)
  if content[1].t == "Strong" and stringify(content[1]):match(pattern) then
    content:remove(1)
    if content[1].t == "Space" or content[1].t == "SoftBreak" then
      content:remove(1)
    end
  end
  return pandoc.Para(content)
end

-- The sentences of a paragraph up to one that sends elsewhere: what is
-- needed, not what may be skipped.
local function heads(blocks, chapter)
  for i, block in ipairs(blocks) do
    if block.t == "Header" and block.level == 2 then return end
    local text = block.t == "Para" and stringify(block) or ""
    if is_aims(text) and not chapter.aims then
      local following = blocks[i + 1]
      chapter.aims = following and following.t == "BulletList"
        and pandoc.List { following }
        or pandoc.List { unheaded(block, "^What you will be able") }
    elseif is_needs(text) and not chapter.needs then
      chapter.needs = pandoc.List { unheaded(block, "^What you need") }
    end
  end
end

local function below_title(blocks, chapter)
  local learned = false
  for _, block in ipairs(blocks) do
    if block.t == "Header" then
      learned = stringify(block) == "What we learned"
    elseif learned then
      chapter.learned:insert(block)
    elseif block.t == "Div" and block.identifier:match("^tab:") then
      chapter.tables[block.identifier] = block.content[1]
    end
  end
end

-- The chapter in this file.
function parts.read(job, path)
  local doc = pandoc.read(files.read(path), job.dialect)
  local chapter = { path = path, id = files.id(path),
    title = doc.blocks[1].content, tables = {}, learned = pandoc.List() }
  chapter.number = tonumber(chapter.id:sub(3))
  heads(doc.blocks, chapter)
  below_title(doc.blocks, chapter)
  for _, part in ipairs { "aims", "needs" } do
    if not chapter[part] then
      faults.add(path, 1, "the chapter's head does not tell its %s", part)
      chapter[part] = pandoc.List()
    end
  end
  return chapter
end

-- Some of its blocks, woven where they are quoted: faults in them are
-- found in the chapter's own file.
function parts.quote(chapter, blocks)
  local here = context.here
  local result = weave.text({ source = source.open(chapter.path),
    id = chapter.id, answers = {} }, pandoc.List(blocks))
  weave.text(here, pandoc.List())
  return result
end

return parts
