-- The numbers that things have in the book, for what is printed beside
-- it: counted here as LaTeX would.
local context = require "context"
local files = require "files"

local numbering = {}

local function is_figure(block)
  local image = block.t == "Para" and #block.content == 1
    and block.content[1]
  return block.t == "Figure" or image and image.t == "Image"
end

local function figure_label(block)
  if block.identifier and block.identifier ~= "" then
    return block.identifier
  end
  local image = block.content[1]
  return (image.t == "Image" and image or image.content[1]).identifier
end

-- Calls found(label, number) for all that is numbered in a chapter.
local function count(chapter, blocks, found)
  local last = { fig = 0, tab = 0, sec = 0 }
  local function take(kind, label)
    last[kind] = last[kind] + 1
    found(label, ("%d.%d"):format(chapter.number, last[kind]))
  end
  local function walk(list, label)
    for _, block in ipairs(list) do
      if is_figure(block) then
        take("fig", figure_label(block))
      elseif block.t == "Table" and (label or #block.caption.long > 0) then
        take("tab", label or "")
      elseif block.t == "Header" and block.level == 2
        and not block.classes:includes("unnumbered") then
        take("sec", block.identifier)
      elseif block.t == "Div" then
        walk(block.content, block.identifier:match("^tab:.*"))
      end
    end
  end
  walk(blocks)
end

-- The number of every label of the book that has no place of its own
-- here. The press knows these labels then, too.
function numbering.of_book(job)
  local numbers = {}
  local function found(label, number)
    if label == "" or context.book.labels[label] then return end
    context.book.labels[label] = { path = "the book", line = 1 }
    numbers[label] = number
  end
  for _, path in ipairs(job.chapters) do
    local id = files.name(path):match("^ch%d%d")
    local chapter = { number = tonumber(id:sub(3)) }
    found("ch:" .. id, tostring(chapter.number))
    count(chapter, pandoc.read(files.read(path), job.dialect).blocks, found)
  end
  for i, path in ipairs(job.appendices) do
    found("ch:" .. files.name(path), string.char(64 + i))
  end
  for id, paths in pairs(job.exercises) do
    for _, path in ipairs(paths) do
      local k, name = path:match("/(%d+)%-([%w-]+)/[^/]*$")
      found(("ex:%s-%s"):format(id, name),
        ("%d.%s"):format(tonumber(id:sub(3)), k))
    end
  end
  return numbers
end

-- The same for LaTeX.
function numbering.latex(numbers)
  local lines = {}
  for label, number in pairs(numbers) do
    table.insert(lines, ("\\booknumber{%s}{%s}"):format(label, number))
  end
  table.sort(lines)
  return pandoc.RawBlock("latex", table.concat(lines, "\n"))
end

return numbering
