-- What must be run to be printed: illustrations are compiled, output is
-- captured. The commands run in the project's root; where they say
-- build/ they mean the folder that the book is built in.
local files = require "files"

local capture = {}

-- A sentence lifted out of a function may still say `return x;`.
local WARNINGS = "-Wno-return-type -Werror=implicit-function-declaration " ..
  "-Werror=implicit-int -Werror=int-conversion " ..
  "-Werror=incompatible-pointer-types"

-- Runs the command; returns what it printed, on both channels, and the
-- status it ended with.
local function run(command)
  local pipe = io.popen("{ " .. command .. "\n} 2>&1 </dev/null", "r")
  local text = pipe:read("a")
  local _, how, status = pipe:close()
  return text, how == "signal" and 128 + status or status
end

-- Compiles a C text: a file, with C's own headers above it, or, if there
-- are parameters, a function's body, with the workbench's as well. #line
-- makes the compiler's message name the place in the chapter. Returns
-- whether it compiled, and the first error as line and sentence.
function capture.compile(job, text, path, line, parameters)
  local program = {}
  for _, header in ipairs(job.headers) do
    if parameters or header:match("^<") then
      table.insert(program, "#include " .. header)
    end
  end
  if parameters then
    table.insert(program, ("void illustration(%s)\n{"):format(parameters))
  end
  table.insert(program, ('#line %d "%s"'):format(line, path))
  table.insert(program, text)
  if parameters then table.insert(program, "}") end
  local file = job.folder .. "/illustration.c"
  files.write(file, table.concat(program, "\n") .. "\n")
  local output, status = run(("%s -std=c17 -fopenmp -D_GNU_SOURCE %s " ..
    "-Icode -c -o /dev/null '%s'"):format(job.cc, WARNINGS, file))
  if status == 0 then return true end
  local at, message = output:match(":(%d+):[%d:]* [%a ]*error: ([^\n]*)")
  return false, tonumber(at) or line, message or files.split(output)[1]
end

-- What the command of a chapter prints and its status.
function capture.output(job, command)
  local place = job.build:gsub("%%", "%%%%")
  local text, status =
    run((command:gsub("%f[%w_./]build/", place .. "/")))
  local lines = files.split(text)
  if text == "" then lines = {} end
  for i, line in ipairs(lines) do
    local at = 1
    while at do -- what the chapter calls build/ is called so here too
      local first, last = line:find(job.build .. "/", at, true)
      if first then
        line = line:sub(1, first - 1) .. "build/" .. line:sub(last + 1)
      end
      at = first
    end
    while line:find("\t", 1, true) do -- tabs, as a terminal shows them
      local before = line:match("^[^\t]*")
      local width = utf8.len(before) or #before
      line = line:gsub("\t", (" "):rep(8 - width % 8), 1)
    end
    lines[i] = line:gsub("%s+$", "")
  end
  return lines, status
end

return capture
