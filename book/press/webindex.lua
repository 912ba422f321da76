-- The index: entries with the places where they stand, an entry within
-- another below it. A place is called by its section.
local html = require "html"

local webindex = {}

local plain = { ["á"] = "a", ["ä"] = "a", ["é"] = "e", ["è"] = "e",
  ["ï"] = "i", ["ö"] = "o", ["ü"] = "u" }

local function key(words)
  return words:gsub("[\xc2-\xdf][\x80-\xbf]", plain):lower()
    :gsub("[^%w ]", "")
end

-- Entries by name, each with its places, those below it, and others that
-- it sends to.
local function gathered(entries)
  local top = {}
  local function at(list, name, e)
    list[name] = list[name] or { name = name, below = {}, places = {},
      see = {}, is_code = e.is_code }
    return list[name]
  end
  for _, e in ipairs(entries) do
    local first, rest = e.entry:match("^(.-)!(.*)$")
    local entry = at(top, first or e.entry, e)
    if rest then entry = at(entry.below, rest, e) end
    if e.see then
      entry.see[e.see] = true
    else
      table.insert(entry.places, e.id)
    end
  end
  return top
end

local function sorted(list)
  local names = {}
  for name in pairs(list) do table.insert(names, name) end
  table.sort(names, function(a, b)
    local x, y = key(a), key(b)
    if x ~= y then return x < y end
    return a < b
  end)
  return names
end

function webindex.id(name) return "index-" .. html.slug(name) end

-- Each section once, with a link to the first place in it.
local function links(entry, where)
  local parts, seen = {}, {}
  for _, id in ipairs(entry.places) do
    local section = where[id] ~= "" and where[id] or "preface"
    if not seen[section] then
      table.insert(parts, ('<a href="#%s">%s</a>'):format(id, section))
    end
    seen[section] = true
  end
  for _, name in ipairs(sorted(entry.see)) do
    table.insert(parts, ('<i>see</i> <a href="#%s">%s</a>'):format(
      webindex.id(name), html.text(name)))
  end
  return table.concat(parts, ", ")
end

local function name_of(entry)
  local text = html.text(entry.name)
  return entry.is_code and "<code>" .. text .. "</code>" or text
end

local function below(entry, where)
  local lines = {}
  for _, name in ipairs(sorted(entry.below)) do
    local e = entry.below[name]
    table.insert(lines, ("<li>%s %s</li>"):format(name_of(e),
      links(e, where)))
  end
  return #lines > 0 and "<ul>" .. table.concat(lines) .. "</ul>" or ""
end

function webindex.written(entries, where)
  local top, lines, letter = gathered(entries), {}, nil
  for _, name in ipairs(sorted(top)) do
    local this = key(name):match("^%a") or "0"
    if this ~= letter then
      table.insert(lines, ('%s<h2 id="letter-%s">%s</h2><ul>'):format(letter
        and "</ul>" or "", this, this == "0" and "0–9" or this:upper()))
    end
    letter = this
    table.insert(lines, ('<li id="%s">%s %s%s</li>'):format(webindex.id(name),
      name_of(top[name]), links(top[name], where), below(top[name], where)))
  end
  return '<div class="terms">' .. table.concat(lines, "\n") .. "</ul></div>"
end

return webindex
