-- Text made safe for LaTeX.
local latex = {}

local special = {
  ["\\"] = "\\textbackslash{}", ["{"] = "\\{", ["}"] = "\\}",
  ["$"] = "\\$", ["&"] = "\\&", ["#"] = "\\#", ["%"] = "\\%",
  ["_"] = "\\_", ["^"] = "\\textasciicircum{}",
  ["~"] = "\\textasciitilde{}",
}

-- Running text. A thin space (U+2009) keeps number and unit together.
function latex.text(s)
  return (s:gsub("[\\{}$&#%%_^~]", special):gsub("\u{2009}", "\\,"))
end

-- The same for the typewriter, where a space is a column.
function latex.code(s)
  return (s:gsub("[\\{}$&#%%_^~]", special):gsub(" ", "\\ "))
end

-- Code within a sentence may break after these, never elsewhere.
function latex.inline_code(s)
  local text = latex.code(s):gsub("([/,.%(]%f[^/,.%(])", "%1\\allowbreak{}")
  text = text:gsub("(\\_)(%w)", "%1\\allowbreak{}%2")
    :gsub("%-", "\\mbox{-}")
  return "\\code{" .. text:gsub("\\ ", " ") .. "}"
end

return latex
