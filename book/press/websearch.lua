-- The search's index: a script that sets NEAR_AND_FAR to a list of
-- [address, page, title, words], one for each section of the text, so
-- that search.js needs no server to read it from.
local html = require "html"

local websearch = {}

local escapes = { ['"'] = '\\"', ["\\"] = "\\\\", ["<"] = "\\u003c" }

local function quoted(s)
  return '"' .. s:gsub('["\\<]', escapes):gsub("%c", " ") .. '"'
end

local function words(text)
  return (html.plain(text):gsub("%s+", " "):gsub("^ ", ""))
end

-- Cuts a page before its titles of the second and third level.
local function sections(page, text, found)
  local marked = text:gsub('(<h[23][^>]- id=")', "\0%1") .. "\0"
  for piece in marked:gmatch("([^\0]*)\0") do
    local id, title = piece:match('^<h[23][^>]- id="([^"]*)"[^>]*>(.-)</h[23]>')
    table.insert(found, ("[%s,%s,%s,%s]"):format(
      quoted(page.id:gsub("^src:", "") .. ".html" .. (id and "#" .. id or "")),
      quoted((page.kicker ~= "" and page.kicker .. ", " or "") .. page.title),
      quoted(words(title or "")),
      quoted(words((piece:gsub("<h[123].-</h[123]>", "", 1))))))
  end
end

-- Of a file, its name will do, and what its first comment says.
function websearch.index(pages, texts)
  local found = {}
  for _, page in ipairs(pages) do
    if page.kind == "source" then
      table.insert(found, ('[%s,%s,"",%s]'):format(quoted(page.id:gsub(
        "^src:", "") .. ".html"), quoted(page.title), quoted(words(
        texts[page.id]):sub(#page.title + 1, 400))))
    elseif page.kind ~= "search" then
      sections(page, texts[page.id], found)
    end
  end
  return "var NEAR_AND_FAR = [\n" .. table.concat(found, ",\n") .. "\n];\n"
end

return websearch
