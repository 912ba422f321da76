-- A strict reading of JSON, for what autograders write:
--   texlua json.lua FILE [NAME...]
-- Ends with 1 if FILE is no JSON, or prints what stands under the names.
local file = assert(io.open(arg[1], "rb"))
local text = file:read("a")
file:close()

local function fail(at, why)
  io.stderr:write(("%s: byte %d: %s\n"):format(arg[1], at, why))
  os.exit(1)
end

local function skip(at)
  return text:match("^[ \t\r\n]*()", at)
end

local value

local function string_at(at)
  local i = at + 1
  while true do
    local c = text:sub(i, i)
    if c == '"' then return text:sub(at + 1, i - 1), i + 1 end
    if c == "" or c:byte() < 32 then fail(i, "in a string") end
    if c == "\\" then
      local after = text:match('^["\\/bfnrt]()', i + 1)
        or text:match("^u%x%x%x%x()", i + 1)
      i = after or fail(i, "an unknown escape")
    else
      i = i + 1
    end
  end
end

-- Members of an object or elements of an array, up to the closing sign.
local function members(at, closing, each)
  at = skip(at + 1)
  if text:sub(at, at) == closing then return at + 1 end
  while true do
    at = skip(each(skip(at)))
    local c = text:sub(at, at)
    if c == closing then return at + 1 end
    if c ~= "," then fail(at, "expected , or " .. closing) end
    at = at + 1
  end
end

local function object(at)
  local result = {}
  return result, members(at, "}", function(place)
    if text:sub(place, place) ~= '"' then fail(place, "expected a name") end
    local name, after = string_at(place)
    if result[name] ~= nil then fail(place, "the name is there twice") end
    after = skip(after)
    if text:sub(after, after) ~= ":" then fail(after, "expected :") end
    result[name], after = value(skip(after + 1))
    return after
  end)
end

local function array(at)
  local result = {}
  return result, members(at, "]", function(place)
    local element, after = value(place)
    table.insert(result, element)
    return after
  end)
end

local function number(at)
  local whole, after = text:match("^(%-?%d+)()", at)
  if not whole or whole:match("^%-?0%d") then fail(at, "what is this?") end
  after = text:match("^%.%d+()", after) or after
  after = text:match("^[eE][+-]?%d+()", after) or after
  return tonumber(text:sub(at, after - 1)), after
end

function value(at)
  local c = text:sub(at, at)
  if c == "{" then return object(at) end
  if c == "[" then return array(at) end
  if c == '"' then return string_at(at) end
  for word, meaning in pairs { ["true"] = true, ["false"] = false } do
    if text:sub(at, at + #word - 1) == word then return meaning, at + #word end
  end
  if text:sub(at, at + 3) == "null" then return nil, at + 4 end
  return number(at)
end

if not utf8.len(text) then fail(1, "this is no UTF-8") end
local result, last = value(skip(1))
if skip(last) <= #text then fail(last, "something follows") end
for i = 2, #arg do result = result[tonumber(arg[i]) or arg[i]] end
if #arg > 1 then print(result) end
