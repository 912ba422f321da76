-- Code, output and whole files as HTML. Links are written as the pages'
-- filter (webpages.lua) expects them: "#id" wherever the id is, and
-- "src:code/near/near.c#L12" for a line of a file.
local c = require "c"
local html = require "html"

local weblisting = {}

local tags = { keyword = "b", comment = "i" }

function weblisting.code_line(line, in_comment)
  local pieces
  pieces, in_comment = c.pieces(line, in_comment)
  for i, piece in ipairs(pieces) do
    local tag, text = tags[piece[1]], html.text(piece[2])
    pieces[i] = tag and ("<%s>%s</%s>"):format(tag, text, tag) or text
  end
  return table.concat(pieces), in_comment
end

-- Lines of code can be wider than a window: then they are moved, by keys
-- too.
local function pre(lines, class)
  return ('<pre class="%s" tabindex="0"><code>%s\n</code></pre>'):format(
    class, table.concat(lines, "\n"))
end

function weblisting.id(fragment)
  return "frag-" .. html.slug(fragment.title)
end

local function bracketed(fragment, href)
  return ('<a class="title" href="%s">⟨<i>%s</i>⟩</a>'):format(href,
    html.text(fragment.title))
end

-- Where a chapter shows it, or else its line in the file.
local function link(fragment)
  return bracketed(fragment, ("#%s|src:%s#L%d"):format(
    weblisting.id(fragment), fragment.file, fragment.line))
end

weblisting.mention = link

-- A fragment with its title, where it is in its file, and where it is
-- used; a nested fragment is its title.
function weblisting.fragment(fragment, number)
  local lines, in_comment = {}, false
  for _, item in ipairs(fragment.items) do
    local line
    if item.child then
      line = (" "):rep(item.indent - fragment.indent) .. link(item.child)
    else
      line, in_comment = weblisting.code_line(item.text, in_comment)
    end
    table.insert(lines, line)
  end
  local place = fragment.file:gsub("^code/", "")
  local used = fragment.parent and ('<p class="used">Used in %s</p>'):format(
    link(fragment.parent)) or ""
  return ('<figure class="fragment" id="%s"><figcaption><span class="name">'
    .. '⟨<span class="number">%s</span> <i>%s</i>⟩</span> <a class="file" '
    .. 'href="src:%s#L%d">%s%s, lines %d–%d</a></figcaption>%s%s</figure>')
    :format(weblisting.id(fragment), number, html.text(fragment.title),
      fragment.file, fragment.line, html.text(place), fragment.within
      and ", " .. fragment.within .. "()" or "", fragment.line + 1,
      fragment.last - 1, pre(lines, "code"), used)
end

function weblisting.illustration(lines, is_c)
  local result, in_comment = {}, false
  for i, line in ipairs(lines) do
    if is_c then
      result[i], in_comment = weblisting.code_line(line, in_comment)
    else
      result[i] = html.text(line)
    end
  end
  return pre(result, "illustration")
end

function weblisting.output(command, lines)
  local result = {}
  for i, line in ipairs(lines) do result[i] = html.text(line) end
  return ('<figure class="output"><figcaption><code>$ %s</code></figcaption>'
    .. '%s</figure>'):format(html.text(command), pre(result, "captured"))
end

-- ---- whole files --------------------------------------------------------
-- A file of C: where a fragment opens, its title leads to the chapter
-- that shows it.
local function c_lines(lines, by_title)
  local result, in_comment = {}, false
  for i, line in ipairs(lines) do
    local indent, title = line:match("^(%s*)//>%s*(.-)%s*$")
    local fragment = title and by_title[title]
    if fragment and fragment.shown then
      result[i] = ('%s<i>//&gt;</i> <a class="title" href="#%s">%s</a> '
        .. '<span class="number">%s</span>'):format(indent,
        weblisting.id(fragment), html.text(title), fragment.number or "")
    else
      result[i], in_comment = weblisting.code_line(line, in_comment)
    end
  end
  return result
end

-- Of other languages only what is a comment from its first column on.
local function other_lines(lines, mark)
  local result = {}
  for i, line in ipairs(lines) do
    local text = html.text(line)
    result[i] = mark and line:find("^%s*" .. mark)
      and "<i>" .. text .. "</i>" or text
  end
  return result
end

local marks = { lua = "%-%-", tex = "%%", gp = "#", sh = "#", mk = "#",
  ist = "%%" }

-- The lines of a file, each with its number.
function weblisting.file(path, lines, fragments)
  local kind = path:match("%.(%w+)$")
  local result = (kind == "c" or kind == "h" or kind == "cc")
    and c_lines(lines, fragments.by_title)
    or other_lines(lines, marks[kind] or not kind and "#")
  for i, line in ipairs(result) do
    result[i] = ('<span class="line" id="L%d">%s\n</span>'):format(i, line)
  end
  return ('<pre class="source" tabindex="0"><code>%s</code></pre>'):format(
    table.concat(result))
end

return weblisting
