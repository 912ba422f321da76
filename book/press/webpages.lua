-- After citeproc: writes the pages of the web edition. Every division of
-- class "page" becomes a file; then links find their pages, and numbers
-- their labels.
local job = dofile(os.getenv("PRESS_JOB"))
package.path = job.press .. "/?.lua;" .. package.path

local files = require "files"
local html = require "html"
local webcontents = require "webcontents"
local websearch = require "websearch"

local folder, out = job.folder, job.web
local about = dofile(folder .. "/about.lua")
local template = assert(files.read(job.press .. "/../web/page.html"))

local options = { html_math_method = "mathml", wrap_text = "wrap-none" }

-- "src:code/near/near.c" is code/near/near.c.html.
local function address(id)
  return (id:gsub("^src:", "")) .. ".html"
end

-- Where an id is, from this page on.
local places = {}

local function to(page, id)
  if page.ids[id] then return "#" .. id end
  local place = places[id]
  if not place then return nil end
  return page.root .. address(place) .. (place == id:gsub("^ch:", "") and ""
    or "#" .. id)
end

local lost = {} -- links that lead nowhere

local function link(page, target)
  local first, second = target:match("^(.-)|(.*)$")
  first = first or target
  local found
  if first:match("^#") then
    found = to(page, first:sub(2))
  elseif first:match("^src:") then
    local path, line = first:match("^src:([^#]*)(#?.*)$")
    found = places["src:" .. path] and page.root .. path .. ".html" .. line
  else
    return target
  end
  if not found and second then return link(page, second) end
  if not found then table.insert(lost,
    address(page.id) .. ': a link leads nowhere: "' .. target .. '"') end
  return found or target
end

local function resolved(page)
  local text = page.html:gsub('href="([^"]*)"', function(target)
    return 'href="' .. link(page, target) .. '"'
  end)
  return (text:gsub("@@(.-)@@", function(label)
    return about.numbers[label] or "?"
  end):gsub("@ROOT@", page.root))
end

-- In TeX a parenthesis is as tall as what it holds only if told so. In
-- pandoc's MathML it always is, and stands apart for it: here, only
-- where something tall is.
local function low(math)
  if math:find("<mfrac>") or math:find("<munder") or math:find("<mover") then
    return math
  end
  return (math:gsub('stretchy="true"', 'stretchy="false"'))
end

-- A formula of a line in words that a name can hold, from its TeX.
local signs = { cdot = "·", times = "×", le = "≤", ge = "≥", ll = "≪",
  sqrt = "√", ell = "ℓ", alpha = "α", beta = "β", lambda = "λ", mu = "µ",
  pi = "π", varepsilon = "ε", epsilon = "ε", infty = "∞", approx = "≈",
  log = "log ", min = "min ", max = "max ", ldots = "…", dots = "…" }

local function spoken(math)
  local tex = math:match("<annotation[^>]*>(.-)</annotation>") or html.plain(math)
  return (tex:gsub("\\t?frac%s*(%w)%s*(%w)", "%1/%2")
    :gsub("\\t?frac(%b{})%s*(%b{})", function(a, b)
      return a:sub(2, -2) .. "/" .. b:sub(2, -2) end)
    :gsub("\\mathrm", ""):gsub("\\[,;! ]", " ")
    :gsub("\\(%a+)%s*", function(name) return signs[name] or name .. " " end)
    :gsub("[{}]", ""):gsub("%s+", " "))
end

-- What a caption's formulas say does not get into its table's name by
-- itself.
local function named(caption)
  if not caption:find("<math") then return nil end
  local words = html.plain(caption:gsub("<math.-</math>", spoken))
    :gsub('[&<>"]', { ["&"] = "&amp;", ["<"] = "&lt;", [">"] = "&gt;",
      ['"'] = "&quot;" }):gsub("%s+", " ")
  return ('<table aria-label="%s">\n<caption>%s</caption>'):format(words,
    caption)
end

-- A cell of the first column is the head of its row; an empty one is no
-- head at all.
local function with_heads(tbl)
  return (tbl:gsub("<th([^>]*)></th>", "<td%1></td>")
    :gsub("(<tbody.*)", function(body)
      return (body:gsub("<th([^>]*)>", function(attributes)
        return not attributes:find("scope=") and '<th scope="row"'
          .. attributes .. ">" or nil
      end))
    end)
    :gsub("^<table>%s*<caption>(.-)</caption>", named))
end

local function written(blocks)
  return (pandoc.write(pandoc.Pandoc(blocks), "html", options)
    :gsub("<table>.-</table>", with_heads):gsub("<math.-</math>", low))
end

local function read_pages(doc)
  local pages, by_id = {}, {}
  for i, this in ipairs(about.pages) do
    this.number, by_id[this.id], pages[i] = i, this, this
  end
  for _, block in ipairs(doc.blocks) do
    local page = block.t == "Div" and block.classes:includes("page")
      and by_id[block.identifier]
    if page then
      page.html = written(block.content)
      page.root = ("../"):rep(select(2, address(page.id):gsub("/", "")))
      page.ids = {}
      for id in page.html:gmatch(' id="([^"]*)"') do
        page.ids[id] = true
        places[id] = places[id] or page.id
      end
      places[page.id] = page.id
    end
  end
  return pages
end

-- ---- a page in its frame --------------------------------------------------
local function neighbor(pages, page, step, word)
  local other = page.kind ~= "source" and pages[page.number + step]
  if not other or other.kind == "source" or other.kind == "search" then
    return ""
  end
  return ('<a rel="%s" href="%s%s">%s</a>'):format(word, page.root,
    address(other.id), (step < 0 and "← " or "") .. html.text(
    (other.kicker or "") ~= "" and other.kicker .. ", " .. other.title
    or other.title) .. (step > 0 and " →" or ""))
end

-- The scripts of those pictures that can also run.
local function scripts(page, text)
  local lines = {}
  for name in text:gmatch('data%-figure="([^"]*)"') do
    if files.exists(job.press .. "/../web/live/" .. name .. ".js") then
      table.insert(lines, name)
    end
  end
  if #lines > 0 then table.move({ "live", "draw", table.unpack(lines) }, 1,
    #lines + 2, 1, lines) end
  for i, name in ipairs(lines) do
    lines[i] = ('<script src="%slive/%s.js" defer></script>'):format(
      page.root, name)
  end
  return table.concat(lines, "\n")
end

local function write(page, pages)
  local path = address(page.id)
  local text = resolved(page)
  files.make_folder(out .. "/" .. (path:match("^(.*)/") or ""))
  files.write(out .. "/" .. path, html.fill(template, {
    TITLE = html.text(page.title), KIND = page.kind, ROOT = page.root,
    BODY = text, SCRIPTS = scripts(page, text), SECTIONS = webcontents.of_page(text),
    PREVIOUS = neighbor(pages, page, -1, "prev"),
    NEXT = neighbor(pages, page, 1, "next") }))
  return text
end

function Pandoc(doc)
  local pages, texts = read_pages(doc), {}
  for _, page in ipairs(pages) do texts[page.id] = write(page, pages) end
  local contents = { id = "index", title = about.title, kind = "contents",
    root = "", number = -1, ids = {}, html = webcontents.of_book(about, texts) }
  write(contents, pages)
  files.write(out .. "/index.js", websearch.index(pages, texts))
  files.write(folder .. "/lost", table.concat(lost, "\n"))
  return pandoc.Pandoc({})
end
