-- Where in a chapter's file something stands. Pandoc forgets the lines
-- of what it reads, so we look for the words again: a cursor follows
-- the blocks through the file, and faults are looked for from there.
local files = require "files"

local source = {}
source.__index = source

function source.open(path)
  return setmetatable(
    { path = path, lines = files.lines(path), cursor = 1 }, source)
end

-- Pandoc makes quotes and dashes typographic; the file has plain ones.
local function plain(text)
  return (text:gsub("\u{2019}", "'"):gsub("\u{2018}", "'")
    :gsub("\u{201c}", '"'):gsub("\u{201d}", '"')
    :gsub("\u{2013}", "--"):gsub("\u{2014}", "---")
    :gsub("\u{2026}", "..."):gsub("\u{a0}", " "))
end

-- The line of these words at or after the cursor, or else nil.
function source:ahead(words)
  words = plain(words)
  if words == "" then return nil end
  for number = self.cursor, #self.lines do
    if self.lines[number]:find(words, 1, true) then return number end
  end
end

-- Moves the cursor to the words, if they are still to come.
function source:seek(words)
  self.cursor = self:ahead(words) or self.cursor
  return self.cursor
end

-- Moves the cursor to the line that is just this, but for its indent.
function source:seek_line(line)
  line = line:match("^%s*(.-)%s*$")
  for number = self.cursor, #self.lines do
    if self.lines[number]:match("^%s*(.-)%s*$") == line then
      self.cursor = number
      break
    end
  end
  return self.cursor
end

-- The line of the words: ahead, or anywhere, or as near as we know.
function source:find(words)
  local number = self:ahead(words)
  if number then return number end
  words = plain(words)
  for i = 1, self.cursor - 1 do
    if words ~= "" and self.lines[i]:find(words, 1, true) then return i end
  end
  return self.cursor
end

return source
