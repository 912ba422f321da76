-- The web edition's larger parts: its pages, and the lists at the end.
-- These functions join those of web.lua. A page is a division of class
-- "page" whose id is its address; what else webpages.lua must know to
-- write it stands in its attributes and in `edition.about`.
local context = require "context"
local edition = require "web"
local files = require "files"
local html = require "html"
local webindex = require "webindex"
local weblisting = require "weblisting"

local raw_block, stringify = edition.raw_block, pandoc.utils.stringify

edition.about = { pages = {}, parts = {} } -- in the order of the book

-- A page with its title, what stands above it, its kind and its blocks.
local function page(id, title, kicker, kind, blocks)
  table.insert(edition.about.pages, { id = id, kind = kind,
    title = stringify(title), kicker = kicker })
  blocks:insert(1, pandoc.Header(1, title, pandoc.Attr(
    kind == "chapter" and "ch:" .. id or id)))
  if kicker ~= "" then
    blocks:insert(1, raw_block('<p class="kicker">%s</p>',
      html.text(kicker)))
  end
  return pandoc.Div(blocks, pandoc.Attr(id, { "page" }))
end

local function words(text) return pandoc.List { pandoc.Str(text) } end

-- ---- the text -------------------------------------------------------------
function edition.front(blocks)
  local title = blocks:remove(1)
  return { page("preface", title.content, "", "front", blocks) }
end

function edition.part(part)
  table.insert(edition.about.parts, { title = part.title,
    number = part.number, before = #edition.about.pages + 1 })
  return {}
end

function edition.appendices()
  table.insert(edition.about.parts, { title = "Appendices",
    before = #edition.about.pages + 1 })
  return {}
end

function edition.chapter(chapter, title, blocks)
  local number = edition.chapter_number(chapter.id)
  edition.numbers["ch:" .. chapter.id] = number
  if #chapter.exercises > 0 then
    blocks:insert(pandoc.Header(2, words("Exercises"),
      pandoc.Attr(chapter.id .. "-exercises")))
  end
  for _, e in ipairs(chapter.exercises) do blocks:extend(edition.exercise(e)) end
  return { page(chapter.id, title, (chapter.number and "Chapter "
    or "Appendix ") .. number, "chapter", blocks) }
end

-- ---- the glossary ---------------------------------------------------------
function edition.glossary_line(g) return g end

function edition.glossary(list)
  local blocks = pandoc.List { raw_block("<dl>") }
  for _, g in ipairs(list) do
    local place = g.place and edition.places[g.place]
    local link = place and place ~= "" and ('<a class="where" href="#%s">'
      .. '%s</a>'):format(g.place, (place:find("%.") and "Section "
      or "Chapter ") .. place) or ('<a class="where" href="#ch:%s">Chapter '
      .. '@@ch:%s@@</a>'):format(g.chapter, g.chapter)
    local synonyms = pandoc.List()
    if #g.synonyms > 0 then
      synonyms:insert(pandoc.RawInline("html", " Also: "))
      synonyms:insert(pandoc.Emph(g.synonyms))
      synonyms:insert(pandoc.Str("."))
    end
    blocks:extend { raw_block("<dt>"), pandoc.Plain(g.term),
      raw_block("</dt><dd>"), pandoc.Plain(g.definition),
      pandoc.Plain(synonyms), raw_block(" %s</dd>", link) }
  end
  blocks:insert(raw_block("</dl>"))
  return { page("glossary", words("Glossary"), "", "list", blocks) }
end

-- ---- the lists at the end ---------------------------------------------
local function list_of_exercises(chapters)
  local rows = {}
  for _, chapter in ipairs(chapters) do
    for _, e in ipairs(chapter.exercises) do
      table.insert(rows, ('<tr><th scope="row" class="number">%s</th><td><a '
        .. 'href="#%s">%s</a></td><td>%s</td><td><span role="img" aria-label="%d of 5 '
        .. 'stars">%s</span></td><td class="right">%s</td><td class="right">'
        .. '%d</td><td>%s</td></tr>'):format(e.number, e.label, e.title,
        e.trains, e.stars, ("★"):rep(e.stars), e.time:gsub("~", "\u{a0}"),
        e.points, e.programmed and "program" or "paper"))
    end
  end
  return page("exercises", words("List of exercises"), "", "list",
    pandoc.List { raw_block('<div class="table" tabindex="0" role="group" '
    .. 'aria-label="List of exercises"><table><thead>'
    .. "<tr><th>no.</th><th>what to do</th><th>what it trains</th>"
    .. "<th>difficulty</th><th>time</th><th>points</th><th>kind</th></tr>"
    .. "</thead><tbody>%s</tbody></table></div>", table.concat(rows, "\n")) })
end

-- Every file has a page, and a line here with the fragments it is cut in.
local function list_of_files(all)
  local shown, paths = {}, { table.unpack(all) }
  table.sort(paths, function(a, b)
    local x, y = a:match("^(.*)/") or "", b:match("^(.*)/") or ""
    return x < y or x == y and a < b
  end)
  for _, f in ipairs(context.book.fragments.list) do
    shown[f.file] = shown[f.file] or {}
    if f.shown then
      table.insert(shown[f.file], ('<a href="#%s" title="%s">%s</a>'):format(
        weblisting.id(f), html.text(f.title), f.number or "?"))
    end
  end
  local lines, folder = {}, nil
  for _, path in ipairs(paths) do
    local this = path:match("^(.*)/") or "the project's folder"
    if this ~= folder then
      table.insert(lines, ('%s<h2 id="files-%s">%s</h2><ul>'):format(
        folder and "</ul>" or "", html.slug(this), html.text(this)))
    end
    folder = this
    table.insert(lines, ('<li><a class="file" href="src:%s">%s</a> %s</li>')
      :format(path, html.text(path:match("[^/]*$")), shown[path]
      and table.concat(shown[path], ", ") or ""))
  end
  return page("files", words("Files"), "", "list", pandoc.List {
    raw_block("%s</ul>", table.concat(lines, "\n")) })
end

local function table_of(path)
  local head, rows, columns, seen = {}, {}, nil, {}
  for _, line in ipairs(files.lines(path)) do
    if line:match("^#") then
      table.insert(head, html.text((line:gsub("^#%s*", ""))))
    elseif line ~= "" then
      local cells = {}
      for cell in (line .. "\t"):gmatch("(.-)\t") do
        table.insert(cells, html.text(cell))
      end
      if columns then
        local slug = html.slug(cells[1])
        local id = columns == "name" and not seen[slug] and ' id="row-'
          .. slug .. '"' or ""
        seen[slug] = true
        table.insert(rows, ('<tr%s><th scope="row">%s</th>%s</tr>'):format(
          id, table.remove(cells, 1), #cells == 0 and "" or "<td>"
          .. table.concat(cells, "</td><td>") .. "</td>"))
      else
        columns = cells[1]
        table.insert(rows, "<thead><tr><th>" .. table.concat(cells,
          "</th><th>") .. "</th></tr></thead><tbody>")
      end
    end
  end
  return ('<p class="head">%s</p><div class="table" tabindex="0" '
    .. 'role="group" aria-label="%s"><table class="data">%s</tbody></table>'
    .. '</div>'):format(table.concat(head, "<br>"), html.text(path),
    table.concat(rows, "\n"))
end

local function file(path)
  local text = path:match("%.tsv$") and table_of(path)
    or weblisting.file(path, files.lines(path), context.book.fragments)
  local title = page("src:" .. path, words(path), "", "source",
    pandoc.List { raw_block("%s", text) })
  return title
end

function edition.closing(chapters)
  local paths = context.book.job.files
  local blocks = pandoc.List { list_of_exercises(chapters),
    list_of_files(paths),
    page("bibliography", words("Bibliography"), "", "list",
      pandoc.List { pandoc.Div({}, pandoc.Attr("refs")) }),
    page("terms", words("Index"), "", "list", pandoc.List {
      raw_block("%s", webindex.written(edition.entries, edition.places)) }),
    page("search", words("Search"), "", "search", pandoc.List {
      raw_block("%s", files.read(
        context.book.job.press .. "/../web/search.html")) }) }
  for _, path in ipairs(paths) do blocks:insert(file(path)) end
  return blocks
end

-- For webpages.lua, which is another filter.
function edition.meta(meta, job)
  local about = edition.about
  for _, key in ipairs { "title", "subtitle", "edition", "author" } do
    about[key] = stringify(meta[key] or "")
  end
  about.colophon = pandoc.write(pandoc.Pandoc(meta.colophon or {}), "html")
  about.measured = meta.measured and stringify(meta.measured)
  about.version, about.numbers = job.version, edition.numbers
  files.write(job.folder .. "/about.lua", "return "
    .. files.source_of(about) .. "\n")
end

return edition
