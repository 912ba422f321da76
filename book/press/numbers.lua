-- Finds numbers in running text that look measured: with a decimal
-- point, or followed by a unit. Such a number comes from a table, or
-- from someone else's report, or is a definition, and then it is marked
-- as such; unmarked, somebody typed it by hand.
local numbers = {}

-- Stands for whatever must not be looked at: code, formulas, marked
-- numbers. It is neither letter nor digit.
numbers.HIDDEN = "\1"

local units = {}
for unit in ([[
  ns us ms s sec second seconds min minute minutes hour hours day
  days cycle cycles % percent KB kB MB GB TB KiB MiB GiB TiB Hz kHz MHz
  GHz flops FLOPS Gflops GFLOPS Mflops MFLOPS
]]):gmatch("%S+") do
  units[unit] = true
end

function numbers.is_unit(word)
  return units[(word:gsub("µ", "u"):gsub("[.,;:)]+$", ""))] == true
end

local compared = {}
for word in ("faster slower as more fewer less longer"):gmatch("%S+") do
  compared[word] = true
end

local function unit_after(text, at)
  local space, word = text:match("^([ -]?)([%a%%]+)", at)
  if not word or space == "" and word == "s" then -- the 1980s
    return nil
  elseif units[word] then
    return space .. word
  elseif space == "" and word == "x" and not text:match("^x%d", at) then
    return word
  end
  local next_word = text:match("^ times (%a+)", at)
  return compared[next_word] and " times " .. next_word
end

-- The suspicious numbers of a text, each with its unit.
function numbers.suspicious(text)
  local found, at = {}, 1
  text = text:gsub("µ", "u"):gsub("μ", "u"):gsub("×", "x"):gsub("\u{a0}", " ")
  while true do
    local first, last = text:find("%d[%d,.]*", at)
    if not first then return found end
    at = last + 1
    local number = text:sub(first, last):gsub("[.,]+$", "")
    local before = text:sub(1, first - 1)
    local in_word = before:match("[%w_]$") or before:match("%a%-$")
    if not in_word then
      local unit = unit_after(text, first + #number)
      if unit or number:match("%d%.%d") then
        table.insert(found, number .. (unit or ""))
      end
    end
  end
end

return numbers
