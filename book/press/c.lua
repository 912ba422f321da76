-- A light touch of C: cuts lines of code into keywords, comments and
-- the rest. Strings are recognized so that what they quote is left
-- alone. A comment may run on over several lines.
local c = {}

local keywords = {}
for word in ([[
  auto break case char const continue default do double else enum extern
  float for goto if inline int long register restrict return short
  signed sizeof static struct switch typedef union unsigned void
  volatile while _Alignas _Alignof _Atomic _Bool _Generic _Noreturn
  _Static_assert _Thread_local
]]):gmatch("%S+") do
  keywords[word] = true
end

local function quoted(line, at)
  local quote, i = line:sub(at, at), at + 1
  while i <= #line and line:sub(i, i) ~= quote do
    i = i + (line:sub(i, i) == "\\" and 2 or 1)
  end
  return line:sub(at, i)
end

-- The pieces of a line, each { kind, text }, kind one of "plain",
-- "keyword", "comment"; and whether a /* comment is still open.
function c.pieces(line, in_comment)
  local pieces, at = {}, 1
  local function add(kind, text)
    local last = pieces[#pieces]
    if last and last[1] == kind then
      last[2] = last[2] .. text
    elseif text ~= "" then
      table.insert(pieces, { kind, text })
    end
    at = at + #text
  end
  while at <= #line do
    local two = line:sub(at, at + 1)
    if in_comment or two == "/*" then
      local from = in_comment and at or at + 2
      local _, last = line:find("*/", from, true)
      in_comment = last == nil
      add("comment", line:sub(at, last))
    elseif two == "//" then
      add("comment", line:sub(at))
    elseif line:match('^["\']', at) then
      add("plain", quoted(line, at))
    elseif line:match("^[%a_]", at) then
      local word = line:match("^[%w_]+", at)
      add(keywords[word] and "keyword" or "plain", word)
    elseif line:match("^%d", at) then
      add("plain", line:match("^[%w_.']+", at))
    else
      add("plain", line:sub(at, at))
    end
  end
  return pieces, in_comment
end

return c
