-- Text made safe for LaTeX.
local latex = {}

local special = {
  ["\\"] = "\\textbackslash{}", ["{"] = "\\{", ["}"] = "\\}",
  ["$"] = "\\$", ["&"] = "\\&", ["#"] = "\\#", ["%"] = "\\%",
  ["_"] = "\\_", ["^"] = "\\textasciicircum{}",
  ["~"] = "\\textasciitilde{}",
}

-- The fonts have no raised minus: an exponent is digits, raised.
local raised = {
  ["⁻"] = "\u{2212}", ["⁰"] = "0", ["¹"] = "1", ["²"] = "2", ["³"] = "3",
  ["⁴"] = "4", ["⁵"] = "5", ["⁶"] = "6", ["⁷"] = "7", ["⁸"] = "8",
  ["⁹"] = "9",
}

local function exponent(digits)
  return "10\\textsuperscript{" .. digits:gsub(utf8.charpattern, raised)
    .. "}"
end

-- Running text. A thin space (U+2009) keeps number and unit together.
function latex.text(s)
  return (s:gsub("[\\{}$&#%%_^~]", special):gsub("\u{2009}", "\\,")
    :gsub("10([\xc2\xe2][\xb2\xb3\xb9\x81\x82][\x80-\xff]*)", exponent))
end

-- Text for the PDF's own use, which no font sets: UTF-16, in hexadecimal.
function latex.pdf_text(s)
  local units = { "FEFF" }
  for _, code in utf8.codes(s) do
    if code < 0x10000 then
      table.insert(units, ("%04X"):format(code))
    else
      table.insert(units, ("%04X%04X"):format(
        0xD800 + ((code - 0x10000) >> 10), 0xDC00 + (code & 0x3FF)))
    end
  end
  return table.concat(units)
end

-- Words from a comment or a title: quotes become typographic, and what
-- stands between backticks is code.
function latex.prose(s)
  local parts = {}
  for words, code in (s .. "``"):gmatch("([^`]*)`([^`]*)`") do
    words = latex.text(words):gsub('"([^"]*)"', "\u{201c}%1\u{201d}")
      :gsub("'", "\u{2019}")
    table.insert(parts, words)
    if code ~= "" then table.insert(parts, latex.inline_code(code)) end
  end
  return table.concat(parts)
end

-- The same for the typewriter, where a space is a column.
function latex.code(s)
  return (s:gsub("[\\{}$&#%%_^~]", special):gsub(" ", "\\ "))
end

-- Code within a sentence stays whole if it is short; a longer piece may
-- break after these, never elsewhere.
local WHOLE = 20

function latex.inline_code(s)
  local text = latex.code(s)
  if (utf8.len(s) or #s) <= WHOLE then
    return "\\code{\\mbox{" .. text .. "}}"
  end
  text = text:gsub("([/,(]%f[^/,(])", "%1\\codebreak{}")
    :gsub("%-", "\\mbox{-}")
  if not s:find("[/, (]") then
    text = text:gsub("([%w)])(\\_)(%w)", "%1%2\\codebreak{}%3")
  end
  return "\\code{" .. text:gsub("\\ ", " ") .. "}"
end

return latex
