-- Code and output as LaTeX. The template says what it looks like: every
-- line becomes a \codeline, every listing knows whether it may break.
local c = require "c"
local latex = require "latex"

local listing = {}

local SHORT = 7 -- a listing of so many lines stays on one page
local LONG = 30 -- one of more may also break for a smaller hole
local HEAD = 4  -- where it breaks, at least so many lines come before
local TAIL = 3  -- and so many after, not counting braces

function listing.code_line(line, in_comment)
  local pieces
  pieces, in_comment = c.pieces(line, in_comment)
  for i, piece in ipairs(pieces) do
    local kind, text = piece[1], latex.code(piece[2])
    if kind == "keyword" then
      text = "\\keyword{" .. text .. "}"
    elseif kind == "comment" then
      text = "\\comment{" .. text .. "}"
    end
    pieces[i] = text
  end
  return table.concat(pieces), in_comment
end

-- Whether something ends with this line of LaTeX, and the next is
-- neither a brace nor what else happens.
local function is_end(line, following)
  return (line:find(";$") or line:find("\\},?$")
      or line:find("\\comment{.*}$") or line:find("\\nestedfragment{")
      or line:find("^\\#include"))
    and not following:find("^[\\ ]*\\[{}]")
    and not following:find("^[\\ ]*\\keyword{else}")
end

-- What a file includes, which the appendix of programs leaves out.
local function is_include(line)
  return line:find("^\\#include") or line:find("^\\#pragma.*once")
end

-- What stands between line i and the next, with so many to come.
local function between(lines, i, to_come)
  if #lines <= SHORT or i < HEAD or to_come < TAIL then
    return "\\nobreak"
  elseif lines[i] == "" then
    return "\\breakhere"
  elseif is_end(lines[i], lines[i + 1]) then
    return #lines > LONG and "\\breakifneeded" or "\\breakifpressed"
  end
  return "\\nobreak"
end

-- The lines one below the other. A listing that has to break does so at
-- a blank line, if there is one, or else between statements.
function listing.stacked(lines)
  local result, to_come = {}, 0
  for _, line in ipairs(lines) do
    if line:find("%w") then to_come = to_come + 1 end
  end
  for i, line in ipairs(lines) do
    table.insert(result, line == "" and "\\codeblank" or
      (is_include(line) and "\\codeinclude{" or "\\codeline{")
      .. line .. "}")
    if line:find("%w") then to_come = to_come - 1 end
    if i < #lines then
      table.insert(result, between(lines, i, to_come))
    end
  end
  return table.concat(result, "\n")
end

-- A nested fragment, on its line: its title and where it is.
local function nested(item, indent)
  return ("%s\\nestedfragment{frag:%d}{%s}"):format(
    ("\\ "):rep(item.indent - indent), item.child.id,
    latex.text(item.child.title))
end

-- A fragment with its title and where it is used.
function listing.fragment(fragment)
  local lines, in_comment = {}, false
  for _, item in ipairs(fragment.items) do
    if item.child then
      table.insert(lines, nested(item, fragment.indent))
    else
      local line
      line, in_comment = listing.code_line(item.text, in_comment)
      table.insert(lines, line)
    end
  end
  local place = "\\filename{" ..
    latex.text(fragment.file:gsub("^code/", "")) .. "}"
  if fragment.within then
    place = place .. ", \\filename{" .. latex.text(fragment.within) .. "()}"
  end
  local used = ""
  if fragment.parent then
    used = ("\\usedin{frag:%d}{%s}"):format(fragment.parent.id,
      latex.text(fragment.parent.title))
  end
  return ("\\begin{fragment}{frag:%d}{%s}{%s}{%s}\n%s\n\\end{fragment}"):format(
    fragment.id, latex.text(fragment.title), place, used,
    listing.stacked(lines))
end

-- A fragment named in running text.
function listing.mention(fragment)
  return ("\\fragmentmention{frag:%d}{%s}"):format(fragment.id,
    latex.text(fragment.title))
end

-- Code that is no part of a program.
function listing.illustration(lines)
  local result, in_comment = {}, false
  for i, line in ipairs(lines) do
    result[i], in_comment = listing.code_line(line, in_comment)
  end
  return "\\begin{illustration}\n" .. listing.stacked(result) ..
    "\n\\end{illustration}"
end

-- What is neither C nor captured: commands to type, a file's format.
function listing.plain(lines)
  local result = {}
  for i, line in ipairs(lines) do result[i] = latex.code(line) end
  return "\\begin{illustration}\n" .. listing.stacked(result) ..
    "\n\\end{illustration}"
end

-- A command and what it printed, in a box, unless that is long.
function listing.output(command, lines)
  local result = {}
  for i, line in ipairs(lines) do result[i] = latex.code(line) end
  local environment = #lines > LONG and "longcaptured" or "captured"
  return ("\\begin{%s}{%s}\n%s\n\\end{%s}"):format(environment,
    latex.code(command), listing.stacked(result), environment)
end

return listing
