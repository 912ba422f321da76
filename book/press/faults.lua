-- What is wrong with the book, collected so that one run reports all of
-- it: faults, which stop the press, and notes, which do not. Each has
-- the file and line it was found at.
local faults = { list = {}, notes = {} }

local function entry(file, line, sentence, ...)
  if select("#", ...) > 0 then
    sentence = sentence:format(...)
  end
  return { file = file, line = line or 1, sentence = sentence }
end

function faults.add(file, line, sentence, ...)
  table.insert(faults.list, entry(file, line, sentence, ...))
end

function faults.note(file, line, sentence, ...)
  table.insert(faults.notes, entry(file, line, "note: " .. sentence, ...))
end

-- In the order of the files and their lines, each only once.
local function sorted(entries)
  local seen, result = {}, {}
  for i, e in ipairs(entries) do
    local text = ("%s:%d: %s"):format(e.file, e.line, e.sentence)
    if not seen[text] then
      seen[text] = true
      table.insert(result, { e.file, e.line, i, text })
    end
  end
  table.sort(result, function(a, b)
    for k = 1, 3 do
      if a[k] ~= b[k] then return a[k] < b[k] end
    end
    return false
  end)
  for i, r in ipairs(result) do result[i] = r[4] end
  return result
end

-- One fault a line; empty if there is none.
function faults.report()
  return table.concat(sorted(faults.list), "\n")
end

function faults.report_notes()
  return table.concat(sorted(faults.notes), "\n")
end

return faults
