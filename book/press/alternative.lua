-- The text alternatives of the illustrations: what one of them shows, in
-- words, from the comment at the head of its source. In a drawing it
-- begins with "% Alt:", in a figure's script with "# alt:", and goes on
-- in the lines of comment below.
local faults = require "faults"
local files = require "files"

local alternative = {}

local FEWEST = 5 -- words that can say what a picture shows

local kinds = {
  { "book/drawings/%s.tex", "^%%%s*[Aa]lt:%s*(.*)$", "^%%%s*(.*)$", "% Alt:" },
  { "book/figures/%s.gp", "^#%s*[Aa]lt:%s*(.*)$", "^#%s*(.*)$", "# alt:" },
}

local function read(path, first, further)
  local parts = {}
  for _, line in ipairs(files.lines(path)) do
    local opened = line:match(first)
    local more = #parts > 0 and line:match(further)
    if opened then
      table.insert(parts, opened)
    elseif more and more ~= "" and not more:match("^demo:") then
      table.insert(parts, more)
    elseif #parts > 0 then
      break
    end
  end
  return table.concat(parts, " ")
end

-- The words for the illustration of that name, or "" with a fault.
function alternative.of(name)
  for _, kind in ipairs(kinds) do
    local path = kind[1]:format(name)
    if files.exists(path) then
      local text = read(path, kind[2], kind[3])
      local _, count = text:gsub("%S+", "")
      if count < FEWEST then
        faults.add(path, 1, 'this has no text alternative: "%s ..." says '
          .. "what it shows to those who cannot see it", kind[4])
      end
      return text
    end
  end
  return ""
end

return alternative
