-- The contents: of a page, from its titles, and of the book.
local html = require "html"

local webcontents = {}

-- A title as the contents have it: without links of its own.
local function bare(title)
  return (title:gsub("</?a[^>]*>", ""):gsub('<span id="[^"]*"></span>', ""))
end

-- The titles of the second level, each an item that leads there.
local function items(text, address)
  local lines = {}
  for id, title in text:gmatch('<h2[^>]- id="([^"]*)"[^>]*>(.-)</h2>') do
    table.insert(lines, ('<li><a href="%s#%s">%s</a></li>'):format(address,
      id, bare(title)))
  end
  return lines
end

function webcontents.of_page(text)
  local lines = items(text, "")
  if #lines < 2 then return "" end
  return '<nav class="sections" aria-labelledby="here"><p id="here">On this '
    .. "page</p><ul>" .. table.concat(lines, "\n") .. "</ul></nav>"
end

-- The emblem of the title page, whose strokes are written for a PDF:
-- those that lead to the furthest point, to the nearest, and the points.
local function emblem()
  local paths, classes = {}, { "far", "near", "points" }
  for strokes in (require "emblem"):gsub("[%d.]+ w", "|"):gmatch("|([^|]*)") do
    local path = {}
    for a, b, c, d in strokes:gmatch(
      "([%d.]+) ([%d.]+) m ([%d.]+) ([%d.]+) l S") do
      table.insert(path, ("M%s %sL%s %s"):format(a, b, c, d))
    end
    table.insert(paths, ('<path class="%s" d="%s"/>'):format(
      table.remove(classes, 1), table.concat(path)))
  end
  return '<svg class="emblem" viewBox="0 0 240 240" aria-hidden="true">'
    .. table.concat(paths) .. "</svg>"
end

local function line(page, texts)
  local number = page.kicker:match("%S+$") or ""
  local sections = page.kind == "chapter" and items(texts[page.id],
    page.id .. ".html") or {}
  local title = texts[page.id]:match("<h1[^>]*>(.-)</h1>") or page.title
  return ('<li><p><span class="number">%s</span> <a class="chapter" '
    .. 'href="%s.html">%s</a></p>%s</li>'):format(number, page.id,
    bare(title), #sections > 0 and ('<details><summary>%d sections<span '
    .. 'class="unseen"> of %s</span></summary><ul>%s</ul></details>'):format(
    #sections, html.text(page.title), table.concat(sections, "\n")) or "")
end

-- Parts begin before one of the pages; what is not in the text stands
-- after the last.
function webcontents.of_book(about, texts)
  local lines, open, opens, ended = {}, false, {}, false
  for _, part in ipairs(about.parts) do opens[part.before] = part end
  local function group(title)
    table.insert(lines, (open and "</ol></section>" or "") .. (
      '<section><h2>%s</h2><ol>'):format(title))
    open = true
  end
  for i, page in ipairs(about.pages) do
    if page.kind == "source" then break end
    local part = opens[i]
    if part then
      group((part.number and ('<span class="number">Part %s</span> ')
        :format(("I II III IV V VI"):match(("%S+ "):rep(part.number - 1)
        .. "(%S+)")) or "") .. html.text(part.title))
    elseif not open then
      group("To begin")
    elseif page.kind ~= "chapter" and not ended then
      group("To look things up")
      ended = true
    end
    table.insert(lines, line(page, texts))
  end
  local edition = about.edition .. (about.version and ", version "
    .. about.version or "") .. (about.measured and "; measured "
    .. about.measured or "")
  return ('<div class="cover"><h1>%s</h1><p class="subtitle">%s</p>%s<p '
    .. 'class="edition">%s</p></div>%s</ol></section><footer class="colophon">%s</footer>'):format(
    html.text(about.title), html.text(about.subtitle), emblem(),
    html.text(edition), table.concat(lines, "\n"), about.colophon)
end

return webcontents
