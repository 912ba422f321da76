-- Reads LaTeX's log. The press has LaTeX write "@@file:line" into it
-- before every block, so each complaint belongs to the last place named
-- above it.
local log = {}

-- What in a line is a fault, and how we say it. A function may look at
-- the line's number in the log for more.
local complaints = {
  { "^Overfull \\([hv])box %(([%d.]+)pt too", function(box, excess)
    return ("this is %s pt too %s for the page"):format(excess,
      box == "h" and "wide" or "high")
  end },
  { "^Missing character: There is no (.-) in font ([^:/]*)",
    function(character, font)
      return ("the font %s has no %s"):format(
        font:gsub("[%[%]]", ""), character)
    end },
  { "^LaTeX Warning: Reference [`'](.-)' on page %S+ undefined",
    function(label)
      return ('there is nothing with the label "%s"'):format(label)
    end },
  { "^LaTeX Warning: Label [`'](.-)' multiply defined",
    function(label)
      return ('the label "%s" exists twice'):format(label)
    end },
  { "^! ([^ ].*)$", function(message)
    return "LaTeX says: " .. message
  end },
  { "^%S-:%d+: (.*)$", function(message)
    return "LaTeX says: " .. message
  end },
}

-- The faults of a log, as a list of { file, line, sentence }.
function log.faults(text)
  local found = {}
  local file, line = "book.tex", 1
  for entry in (text .. "\n"):gmatch("(.-)\n") do
    local at_file, at_line = entry:match("^@@(.-):(%d+)$")
    if at_file then
      file, line = at_file, tonumber(at_line)
    end
    for _, complaint in ipairs(complaints) do
      local captures = { entry:match(complaint[1]) }
      if captures[1] then
        table.insert(found,
          { file, line, complaint[2](table.unpack(captures)) })
        break
      end
    end
  end
  return found
end

return log
