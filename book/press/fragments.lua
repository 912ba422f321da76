-- The fragments of the C files. `//> Title` opens one, `//<` closes it;
-- they nest; a title names one fragment in the whole book. A fragment
-- holds lines and, in their places, the fragments nested in it. A line
-- belongs to the innermost fragment around it. In the modules that the
-- chapters teach no line may be outside of all of them, and each must
-- be shown; what only uses them, experiments and the command line, has
-- fragments where a chapter shows some of it, as has some of the
-- workbench.
local faults = require "faults"
local files = require "files"

local fragments = {}

local COLUMNS = 72
fragments.COLUMNS = COLUMNS

-- For every line of a file the name of the function it is in the body
-- of: clang-format puts a body's braces into the first column.
local function functions(lines)
  local inside, current, head = {}, nil, ""
  for i, line in ipairs(lines) do
    if line == "{" then
      current = head:match("([%a_][%w_]*)%s*%(")
    elseif line:match("^}") then
      inside[i] = current
      current, head = nil, ""
    elseif line:match("^%s*//") or line:match("^#") or line == "" then
      head = current and head or ""
    elseif not current then
      head = line:match(";%s*$") and "" or head .. " " .. line
    end
    inside[i] = inside[i] or current
  end
  return inside
end

-- Blank lines at a fragment's ends say nothing.
local function trim(fragment)
  local items = fragment.items
  local function blank(item) return item and item.text == "" end
  while blank(items[1]) do table.remove(items, 1) end
  while blank(items[#items]) do table.remove(items) end
end

-- The same in the instructions of AVX2 as is printed in those of AVX-512.
local twins = {
  ["code/ch06-pack-scan/avx2.c"] = true,
  ["code/ch08-vector-spiral/lanes_avx2.h"] = true,
  ["code/ch08-vector-spiral/fused_avx2.c"] = true,
  ["code/ch09-row-spans/avx2_spans.c"] = true,
}

-- Whether the book shows every line of this file: the modules of the
-- chapters, but neither the workbench nor what only uses the modules.
local function is_taught(path)
  return path:match("^code/ch%d%d") ~= nil
    and not path:match("/experiments/") and not twins[path]
end

local function read_file(path, found)
  local lines = files.lines(path)
  local inside = functions(lines)
  local open = {}
  local outside = false
  for number, line in ipairs(lines) do
    local indent, title = line:match("^(%s*)//>%s*(.-)%s*$")
    local current = open[#open]
    if title == "" then
      faults.add(path, number, "this fragment has no title")
      title = "?"
    end
    if title then
      local fragment = {
        title = title, file = path, line = number, parent = current,
        indent = #indent, within = inside[number], items = {},
      }
      table.insert(found, fragment)
      fragment.id = #found
      table.insert(open, fragment)
      if current then
        table.insert(current.items, { child = fragment, indent = #indent })
      end
    elseif line:match("^%s*//<%s*$") then
      if not current then
        faults.add(path, number, "this //< closes no fragment")
      end
      if current then current.last = number end
      table.remove(open)
    elseif current then
      local cut = math.min(current.indent, #line:match("^ *"))
      local text = line:sub(cut + 1):gsub("%s+$", "")
      table.insert(current.items, { text = text, line = number })
      local width = utf8.len(text) or #text
      if width > COLUMNS then
        faults.add(path, number,
          "this line would be %d columns wide, and the page has %d",
          width, COLUMNS)
      end
    elseif line:match("%S") and not outside and is_taught(path) then
      outside = true
      faults.add(path, number, "this line is in no fragment")
    end
    if current then outside = false end
  end
  for _, fragment in ipairs(open) do
    faults.add(path, fragment.line, 'the fragment "%s" is never closed',
      fragment.title)
  end
end

-- All fragments of the files, in order, and by title.
function fragments.read(paths)
  local found, by_title = {}, {}
  for _, path in ipairs(paths) do read_file(path, found) end
  for _, fragment in ipairs(found) do
    trim(fragment)
    if #fragment.items == 0 then
      faults.add(fragment.file, fragment.line,
        'the fragment "%s" is empty', fragment.title)
    end
    local first = by_title[fragment.title]
    if first then
      faults.add(fragment.file, fragment.line,
        'the fragment "%s" exists twice, here and at %s:%d',
        fragment.title, first.file, first.line)
    else
      by_title[fragment.title] = fragment
    end
  end
  return { list = found, by_title = by_title }
end

-- Every fragment must have been shown by now.
function fragments.check_shown(all)
  for _, fragment in ipairs(all.list) do
    local needed = is_taught(fragment.file)
      or fragment.parent and fragment.parent.shown
    if needed and not fragment.shown
      and all.by_title[fragment.title] == fragment then
      faults.add(fragment.file, fragment.line,
        'no chapter shows the fragment "%s"', fragment.title)
    end
  end
end

return fragments
