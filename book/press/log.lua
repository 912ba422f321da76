-- Reads LaTeX's log. The press has LaTeX write "@@file:line" into it
-- before every block, so a complaint about a block belongs to the last
-- place named above it. What LaTeX finds out only when it ships a page,
-- or at the very end, has words instead, to look for in the sources.
local log = {}

-- What in a line is a fault, how we say it, and the words to look for.
local complaints = {
  { "^Overfull \\([hv])box %(([%d.]+)pt too", function(box, excess)
    return ("this is %.1f pt too %s for the page"):format(
      tonumber(excess), box == "h" and "wide" or "high")
  end },
  { "^Missing character: There is no (%S+) (%b()) in font ([^:/]*)",
    function(character, code, font)
      return ("the font %s has no %s %s"):format(
        font:gsub("[%[%]]", ""), character, code), character
    end },
  { "^LaTeX Warning: Reference [`'](.-)' on page %S+ undefined",
    function(label)
      -- The press has complained already about a fragment not shown.
      if label:match("^frag:") then return nil end
      return ('there is nothing with the label "%s"'):format(label)
    end },
  { "^LaTeX Warning: Label [`'](.-)' multiply defined",
    function(label)
      return ('the label "%s" exists twice'):format(label),
        "{" .. label .. "}"
    end },
  { "^! ([^ ].*)$", function(message)
    return "LaTeX says: " .. message
  end },
  { "^%S-:%d+: (.*)$", function(message)
    return "LaTeX says: " .. message
  end },
}

-- The faults of a log, as a list of { file, line, sentence, words }.
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
      local sentence, words
      if captures[1] then
        sentence, words = complaint[2](table.unpack(captures))
      end
      if sentence then
        table.insert(found, { file, line, sentence, words })
        break
      end
    end
  end
  return found
end

return log
