-- texlua numbers.lua BOOK.TEX FOLDER: the numbers that were measured are
-- the same in the printed book and on the pages. For every chapter the
-- page's values, in their order, stand in the same order in LaTeX's
-- source, and each table of the one is as long as that of the other.
local function read(path)
  local file = assert(io.open(path, "rb"))
  local text = file:read("a")
  file:close()
  return text
end

local book, folder = read(arg[1]), arg[2]

-- A value as LaTeX has it.
local raised = { ["⁻"] = "\u{2212}", ["⁰"] = "0", ["¹"] = "1", ["²"] = "2",
  ["³"] = "3", ["⁴"] = "4", ["⁵"] = "5", ["⁶"] = "6", ["⁷"] = "7",
  ["⁸"] = "8", ["⁹"] = "9" }

local function as_latex(text)
  return (text:gsub("%%", "\\%%"):gsub("\u{2009}", "\\,")
    :gsub("10([\xc2\xe2][\xb2\xb3\xb9\x81\x82][\x80-\xff]*)", function(digits)
      return "10\\textsuperscript{" .. digits:gsub(utf8.charpattern, raised)
        .. "}"
    end))
end

-- In print the answers to quick questions follow the text.
local function in_print_order(page)
  local body, exercises = page:match('^(.-)(<h2[^>]-id="[^"]*%-exercises".*)$')
  body, exercises = body or page, exercises or ""
  local answers = {}
  body = body:gsub("<details>(.-)</details>", function(answer)
    table.insert(answers, answer)
    return ""
  end)
  return body .. table.concat(answers) .. exercises
end

local function check(id)
  local latex = book:match("\\openchapter{" .. id:gsub("%-", "%%-")
    .. "}(.-)\\closechapter{")
  if not latex then
    print("not ok numbers: the printed book has no " .. id)
    return
  end
  latex = latex:gsub("~", " "):gsub("\n", " ")
  local at, count, last = 1, 0, "the beginning"
  local page = in_print_order(read(("%s/%s.html"):format(folder, id)))
  for text in page:gmatch('<a class="value"[^>]*>(.-)</a>') do
    local words = as_latex(text)
    local first, final = latex:find(words, at, true)
    if not first then
      print(("not ok numbers: %s: %s, after %s, is not in print there"):format(
        id, text, last))
      return
    end
    at, count, last = final + 1, count + 1, text
  end
  print(("ok numbers: %d of %s"):format(count, id))
end

for id in book:gmatch("\\openchapter{([^}]*)}") do check(id) end
