-- Whole files and their lines.
local files = {}

-- The text, or nil and why not.
function files.read(path)
  local file, why = io.open(path, "rb")
  if not file then return nil, why end
  local text = file:read("a")
  file:close()
  return text
end

function files.write(path, text)
  local file = assert(io.open(path, "wb"))
  assert(file:write(text))
  assert(file:close())
end

-- Makes a folder, and those above it that are missing.
function files.make_folder(path)
  files.succeeds(("mkdir -p '%s'"):format(path))
end

-- A table as Lua source.
function files.source_of(value)
  if type(value) ~= "table" then return ("%q"):format(value) end
  local parts = {}
  for key, item in pairs(value) do
    table.insert(parts, ("[%s]=%s"):format(files.source_of(key),
      files.source_of(item)))
  end
  return "{" .. table.concat(parts, ",") .. "}"
end

function files.exists(path)
  local file = io.open(path, "rb")
  return file ~= nil and file:close()
end

-- The lines of a text, without their ends.
function files.split(text)
  local lines = {}
  for line in (text:gsub("\r\n", "\n"):gsub("\n?$", "\n")):gmatch("(.-)\n") do
    table.insert(lines, line)
  end
  return lines
end

function files.lines(path)
  return files.split(files.read(path) or "")
end

-- "book/data/ch02-speeds.tsv" is called "ch02-speeds".
function files.name(path)
  return (path:gsub("^.*/", ""):gsub("%.[^.]*$", ""))
end

-- What a chapter or an appendix is called: "ch04", "appendix-near".
function files.id(path)
  local name = files.name(path)
  return name:match("^ch%d%d") or name
end

-- Whether a shell command succeeded; texlua's os.execute returns its
-- status, other Luas' whether it is 0.
function files.succeeds(command)
  local result = os.execute(command)
  return result == true or result == 0
end

return files
