-- JSON by its grammar, as far as an autograder needs it: a function from
-- text to value, which raises an error where there is none.
local text, at

local function bad(what)
  error(string.format("byte %d: %s", at, what), 0)
end

local function skip() at = text:match("^[ \t\r\n]*()", at) end

local function expect(word)
  if text:sub(at, at + #word - 1) ~= word then bad("expected " .. word) end
  at = at + #word
end

local function string_value()
  local first = at
  expect('"')
  while text:sub(at, at) ~= '"' do
    local c = text:byte(at) or bad("a string without an end")
    if c < 32 then bad("a control character") end
    if c == 92 then
      local escaped = text:match('^\\["\\/bfnrt]()', at)
        or text:match("^\\u%x%x%x%x()", at)
      at = escaped or bad("an unknown escape")
    else
      at = at + 1
    end
  end
  at = at + 1
  return text:sub(first + 1, at - 2)
end

local value

local function list(close, take)
  at = at + 1
  skip()
  if text:sub(at, at) == close then at = at + 1 return end
  repeat
    skip()
    take()
    skip()
    local more = text:sub(at, at) == ","
    if more then at = at + 1 end
  until not more
  expect(close)
end

function value()
  skip()
  local c = text:sub(at, at)
  if c == '"' then return string_value() end
  if c == "{" then
    local object = {}
    list("}", function()
      local key = string_value()
      skip()
      expect(":")
      if object[key] ~= nil then bad("twice " .. key) end
      object[key] = value()
    end)
    return object
  end
  if c == "[" then
    local array = {}
    list("]", function() array[#array + 1] = value() end)
    return array
  end
  if text:match("^%-?0%d", at) then bad("a number that begins with 0") end
  local stop = text:match("^%-?%d+()", at) or bad("no value")
  stop = text:match("^%.%d+()", stop) or stop
  stop = text:match("^[eE][+-]?%d+()", stop) or stop
  local number = tonumber(text:sub(at, stop - 1))
  at = stop
  return number
end

return function(what)
  text, at = what, 1
  if not utf8.len(text) then error("is not UTF-8", 0) end
  local result = value()
  skip()
  if at <= #text then bad("something behind the end") end
  return result
end
