-- The words of a paragraph: as they were typed, the first of them, and
-- those in which a number would be read as a measurement.
local numbers = require "numbers"

local words = {}

local stringify = pandoc.utils.stringify

-- As it was typed: in an expression, stars are no emphasis.
function words.typed(inlines)
  local parts = {}
  for _, x in ipairs(inlines) do
    if x.t == "Emph" then
      table.insert(parts, "*" .. words.typed(x.content) .. "*")
    elseif x.t == "Strong" then
      table.insert(parts, "**" .. words.typed(x.content) .. "**")
    elseif x.t == "Superscript" then
      table.insert(parts, "^" .. words.typed(x.content) .. "^")
    elseif x.t == "Quoted" then
      local mark = x.quotetype == "SingleQuote" and "'" or '"'
      table.insert(parts, mark .. words.typed(x.content) .. mark)
    elseif x.content then
      table.insert(parts, words.typed(x.content))
    else
      table.insert(parts, stringify(x))
    end
  end
  return (table.concat(parts):gsub("\u{2019}", "'")
    :gsub("\u{2013}", "--"):gsub("\u{2026}", "..."))
end

-- The first words that stand in the file one after the other.
function words.opening(inlines)
  local text = ""
  for _, x in ipairs(inlines) do
    if x.t == "Str" then
      text = text .. x.text
    elseif x.t == "Space" then
      text = text .. " "
    elseif text:match("%S") then
      break
    elseif x.t == "Code" then
      return x.text
    elseif x.content then
      text = words.opening(x.content)
      if text ~= "" then break end
    end
    if #text > 50 then break end
  end
  return (text:gsub("%s+$", ""))
end

-- Where any number may stand.
local marked = { value = true, reported = true, given = true,
  machine = true, fragment = true }

local function visible(inlines)
  local parts = {}
  for _, x in ipairs(inlines) do
    if x.t == "Str" then
      table.insert(parts, x.text)
    elseif x.t == "Space" or x.t == "SoftBreak" or x.t == "LineBreak" then
      table.insert(parts, " ")
    elseif x.t == "Span" and marked[x.classes[1]] or x.t == "Cite" then
      table.insert(parts, numbers.HIDDEN)
    elseif x.content and x.t ~= "Note" then
      table.insert(parts, visible(x.content))
    else
      table.insert(parts, numbers.HIDDEN)
    end
  end
  return table.concat(parts)
end

-- The numbers that look as if somebody had typed a measurement.
function words.measured(inlines)
  return numbers.suspicious(visible(inlines))
end

return words
