-- Where a picture is: a plot in a PDF of its own, a drawing on a page of
-- the PDF that has all of its chapter.
local files = require "files"

local picture = {}

local pages = {} -- of each list that was read

local function read(path)
  local found = {}
  if files.exists(path) then
    for _, line in ipairs(files.lines(path)) do
      local name, page = line:match("^(%S+)\t(%d+)$")
      if name then found[name] = page end
    end
  end
  return found
end

-- The PDF, without its ending, and the page; nil if there is none. Plots
-- are in the folder `plots` of the build.
function picture.find(build, plots, name)
  if files.exists(("%s/%s/%s.pdf"):format(build, plots, name)) then
    return name, "1"
  end
  local all = name:match("^[^-]+")
  local path = ("%s/drawings/%s.pages"):format(build, all)
  pages[path] = pages[path] or read(path)
  local page = pages[path][name]
  if page then return all, page end
end

return picture
