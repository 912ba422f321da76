-- Declared before used: where a chapter prints a line that reads a
-- field, x.name or x->name, the structure must have been printed before,
-- in that listing or an earlier one. Which structure it is we know if x
-- is declared in the same function or file; if not, any structure of the
-- project that has such a field will do. Appendices and exercises come
-- after everything else, and are not looked at.
local c = require "c"
local faults = require "faults"
local files = require "files"

local declared = {}

-- ---- a little more of C ---------------------------------------------
-- The lines of a text without comments and what stands in quotes.
local function bare(lines)
  local result, in_comment = {}, false
  for i, line in ipairs(lines) do
    local pieces
    pieces, in_comment = c.pieces(line, in_comment)
    local parts = {}
    for _, piece in ipairs(pieces) do
      if piece[1] ~= "comment" then table.insert(parts, piece[2]) end
    end
    line = table.concat(parts):gsub('"[^"]*"', '""')
    result[i] = line:match("^%s*#") and "" or line
  end
  return result
end

-- The names that a declaration declares; none if it has a type of its own.
local function declarators(text)
  local names = {}
  for piece in (text .. ","):gmatch("([^,]*),") do
    piece = piece:gsub("%b[]", ""):gsub(":%s*%d+", "")
      :gsub("%f[%w_]const%f[^%w_]", ""):gsub("%f[%w_]restrict%f[^%w_]", "")
    local name = piece:match("^[%s*]*([%a_][%w_]*)%s*$")
    if name then table.insert(names, name) end
  end
  return names
end

-- The members between the braces of a structure: name to the structure
-- that it is or points to, or else to false.
local function members(text, fields)
  fields = fields or {}
  for inner in text:gmatch("%b{}") do members(inner:sub(2, -2), fields) end
  text = text:gsub("%b{}", " ")
  for member in text:gmatch("[^;]+") do
    local pointer = member:match("%(%s*%*%s*[%a%s]-([%a_][%w_]*)%s*[%[%)]")
    local of, rest = member:match("struct%s+([%a_][%w_]*)%s+(.*)$")
    if not of then of, rest = member:match("struct%s+([%a_][%w_]*)(%s*%*.*)$") end
    if pointer then
      fields[pointer] = false
    elseif of then
      for _, name in ipairs(declarators(rest)) do fields[name] = of end
    else
      rest = member:gsub("%b[]", ""):gsub("%b()", "")
      local first, others = rest:match("^([^,]*)(.*)$")
      local name = first:gsub(":%s*%d+", ""):match("([%a_][%w_]*)%s*$")
      if name then fields[name] = false end
      for _, more in ipairs(declarators(others)) do fields[more] = false end
    end
  end
  return fields
end

-- Calls found(name, line, fields) for every structure that is declared.
local function structures(lines, found)
  local text, starts = table.concat(lines, "\n"), 1
  while true do
    local first, last, name =
      text:find("struct%s+([%a_][%w_]*)%s*%f[{]", starts)
    if not first then return end
    local _, line = text:sub(1, first):gsub("\n", "")
    local body = text:match("^%b{}", last + 1)
    if body then found(name, line + 1, members(body:sub(2, -2))) end
    starts = last + 1
  end
end

-- What the variables of a piece of a file are, name to structure; false
-- if two of the same name differ.
local function variables(text)
  local types = {}
  for name, rest in (text:gsub("%f[%w_]struct%f[^%w_]", "\0struct"))
    :gmatch("%zstruct%s+([%a_][%w_]*)([^;=%){%z]*)") do
    for _, variable in ipairs(declarators(rest)) do
      local other = types[variable]
      types[variable] = (other == nil or other == name) and name
    end
  end
  return types
end

-- For every line the variables that are known there: the function's,
-- whose parameters stand above its opening brace, and then the file's.
local function scopes(lines)
  local result, outside, head = {}, {}, {}
  local function close(last)
    local types = variables(table.concat(head, "\n"))
    for k = last - #head + 1, last do result[k] = types end
    head = {}
  end
  local inside = false
  for i, line in ipairs(lines) do
    table.insert(head, line)
    if line == "{" then
      inside = true
    elseif line:match("^}") then
      if not inside then table.move(head, 1, #head, #outside + 1, outside) end
      close(i)
      inside = false
    elseif not inside and (line == "" or line:match(";%s*$")) then
      table.move(head, 1, #head, #outside + 1, outside)
      close(i)
    end
  end
  close(#lines)
  return result, variables(table.concat(outside, "\n"))
end

local function tokens(line)
  local result = {}
  line = line:gsub("%->", "\1")
  local at = 1
  while at <= #line do
    local token = line:match("^[%a_][%w_]*", at) or line:match("^%d[%w_.]*", at)
      or line:sub(at, at)
    if not token:match("^%s") then table.insert(result, token) end
    at = at + #token
  end
  return result
end

local function is_access(token) return token == "." or token == "\1" end

-- The token before the one at i, or before the index whose end it is.
local function before_index(list, i)
  local depth = 0
  while list[i] == "]" do
    repeat
      depth = depth + (list[i] == "]" and 1 or list[i] == "[" and -1 or 0)
      i = i - 1
    until depth == 0 or i < 1
  end
  return i
end

-- ---- the project's structures -----------------------------------------
local Project = {}
Project.__index = Project

function Project.new(fragments)
  local self = setmetatable({ by_name = {}, by_field = {}, scopes = {},
    globals = {}, printed = {}, holds = {} }, Project)
  local paths = {}
  for _, fragment in ipairs(fragments.list) do
    for _, item in ipairs(fragment.items) do
      if item.line then
        paths[fragment.file] = paths[fragment.file] or {}
        paths[fragment.file][item.line] = fragment
      end
    end
  end
  local sorted = {}
  for path in pairs(paths) do table.insert(sorted, path) end
  table.sort(sorted)
  for _, path in ipairs(sorted) do self:read(path, paths[path]) end
  return self
end

-- The files that one includes, as far as they are ours.
local function includes(path)
  local result = {}
  for _, line in ipairs(files.lines(path)) do
    local name = line:match('^%s*#%s*include%s*"([^"]+)"')
    if name then table.insert(result, "code/" .. name) end
  end
  return result
end

function Project:read(path, holder)
  local lines = bare(files.lines(path))
  structures(lines, function(name, line, fields)
    local structure = { name = name, file = path, line = line,
      fields = fields }
    self.by_name[name] = self.by_name[name] or {}
    table.insert(self.by_name[name], structure)
    for field in pairs(fields) do
      self.by_field[field] = self.by_field[field] or {}
      table.insert(self.by_field[field], structure)
    end
    local fragment = holder[line]
    if fragment then
      self.holds[fragment] = self.holds[fragment] or {}
      table.insert(self.holds[fragment], structure)
    end
  end)
  self.scopes[path], self.globals[path] = scopes(lines)
end

-- The structure of that name that a file means: its own, or that of a
-- file that it includes; of all others the first.
function Project:named(name, path)
  local all = name and self.by_name[name]
  if not all or #all == 1 then return all and all[1] end
  local queue, seen = { path }, {}
  for _, file in ipairs(queue) do
    for _, structure in ipairs(seen[file] and {} or all) do
      if structure.file == file then return structure end
    end
    if not seen[file] then
      for _, other in ipairs(includes(file)) do table.insert(queue, other) end
    end
    seen[file] = true
  end
  return all[1]
end

-- The structure that the expression ending with token i is or points to.
function Project:type_of(list, i, path, line)
  i = before_index(list, i)
  local name = list[i]
  if not name or not name:match("^[%a_]") then return nil end
  if is_access(list[i - 1]) then
    local outer = self:type_of(list, i - 2, path, line)
    return outer and self:named(outer.fields[name], path)
  end
  local scope = path and self.scopes[path][line] or {}
  local of = scope[name]
  if of == nil and path then of = self.globals[path][name] end
  return self:named(of, path)
end

function Project:print_structures(fragment)
  for _, structure in ipairs(self.holds[fragment] or {}) do
    self.printed[structure] = true
  end
end

-- Calls missing(field, structure) for what a line reads too early.
function Project:check(text, path, line, missing)
  local list = tokens(text)
  for i = 2, #list - 1 do
    local field, owner = list[i + 1], list[i - 1]
    local having = is_access(list[i]) and field:match("^[%a_]")
      and owner:match("^[%a_%]%)]") and self.by_field[field]
    if having then
      local of = self:type_of(list, i - 1, path, line)
      if of and of.fields[field] ~= nil then
        if not self.printed[of] then missing(field, of) end
      else
        local one = false
        for _, structure in ipairs(having) do
          one = one or self.printed[structure]
        end
        if not one then missing(field, having[1]) end
      end
    end
  end
end

-- ---- the listings of a chapter ------------------------------------------
-- Calls shown(class, text, line) for every line of code of a text.
local function listings(path, shown)
  local class, fence
  for number, line in ipairs(files.lines(path)) do
    local marks, words = line:match("^%s*(```+)%s*(.*)$")
    if fence and marks == fence and words == "" then
      class, fence = nil, nil
      shown(nil, "", number)
    elseif fence then
      shown(class, line, number)
    elseif marks then
      fence, class = marks, words:match("^{?%.?(%w+)") or "text"
    end
  end
end

-- Checks the chapters in the order of the book. `spared` are the ids of
-- those whose faults are not reported; `only`, if any, is the one whose
-- faults are.
function declared.check(chapters, fragments, spared, only)
  local project = Project.new(fragments)
  for _, chapter in ipairs(chapters) do
    local id = files.id(chapter)
    local reported, said = only == id or not only and not spared[id], {}
    local function fault(line, field, structure, file, number)
      local key = line .. structure.name
      if reported and not said[key] then
        said[key] = true
        faults.add(chapter, line, '"%s" is read here%s, and struct %s '
          .. "(%s:%d) has not been printed yet", field,
          file and (" (%s:%d)"):format(file, number) or "",
          structure.name, structure.file, structure.line)
      end
    end
    local block, first = {}, nil
    local function fragment_shown(title, line)
      local fragment = fragments.by_title[title:match("^%s*(.-)%s*$")]
      if not fragment then return end
      project:print_structures(fragment)
      local lines = {}
      for i, item in ipairs(fragment.items) do lines[i] = item.text or "" end
      for i, text in ipairs(bare(lines)) do
        local number = fragment.items[i].line
        project:check(text, fragment.file, number, function(field, structure)
          fault(line, field, structure, fragment.file, number)
        end)
      end
    end
    local function illustration_shown()
      local lines, own = bare(block), {}
      structures(lines, function(name, _, fields)
        for field in pairs(fields) do own[field] = true end
        for _, structure in ipairs(project.by_name[name] or {}) do
          project.printed[structure] = true
        end
      end)
      for i, text in ipairs(lines) do
        project:check(text, nil, nil, function(field, structure)
          if own[field] then return end
          fault(first + i - 1, field, structure)
        end)
      end
    end
    listings(chapter, function(class, text, line)
      if class == "fragment" then
        fragment_shown(text, line)
      elseif class == "c" then
        first = first or line
        table.insert(block, text)
      elseif not class and first then
        illustration_shown()
        block, first = {}, nil
      end
    end)
  end
end

return declared
