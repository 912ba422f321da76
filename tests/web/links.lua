-- texlua links.lua FOLDER: in every page under it, each id is given once,
-- each link leads to a file and an id that are there, nothing is loaded
-- from another host, and the page is smaller than a megabyte.
local lfs = require "lfs"

local folder = arg[1]
local LARGEST = 1000000 -- bytes of a page

local pages, order = {}, {}

local function read(path)
  local file = assert(io.open(path, "rb"))
  local text = file:read("a")
  file:close()
  return text
end

local function collect(path)
  for name in lfs.dir(folder .. path) do
    local this = path .. "/" .. name
    local mode = lfs.attributes(folder .. this, "mode")
    if name == "." or name == ".." then
      -- not below
    elseif mode == "directory" then
      collect(this)
    elseif name:match("%.html$") then
      pages[this] = { text = read(folder .. this), ids = {} }
      table.insert(order, this)
    end
  end
end

local failed = {}
local function fail(page, sentence, ...)
  table.insert(failed, page .. ": " .. sentence:format(...))
end

-- The path that a link of this page means.
local function joined(page, target)
  local path = page:match("^(.*)/") .. "/" .. target
  local before
  repeat
    before = path
    path = path:gsub("/[^/]+/%.%./", "/", 1)
  until path == before
  return path
end

local function follow(page, target)
  if target:match("^https?:") or target:match("^mailto:") then return end
  local file, id = target:match("^([^#?]*)%??[^#]*#?(.*)$")
  local path = file == "" and page or joined(page, file)
  if not pages[path] and not lfs.attributes(folder .. path, "mode") then
    fail(page, "there is no %s", target)
  elseif id ~= "" and pages[path] and not pages[path].ids[id] then
    fail(page, "no %s in %s", id, path)
  end
end

collect("")
table.sort(order)
for _, name in ipairs(order) do
  local page = pages[name]
  if #page.text > LARGEST then fail(name, "%d bytes", #page.text) end
  for id in page.text:gmatch('[%s]id="([^"]*)"') do
    if page.ids[id] then fail(name, "the id %s is given twice", id) end
    page.ids[id] = true
  end
end
local links = 0
for _, name in ipairs(order) do
  local text = pages[name].text
  for target in text:gmatch('<a [^>]-href="([^"]*)"') do
    links = links + 1
    follow(name, target)
  end
  for tag, attribute, target in text:gmatch('<(%a+)[^>]-%s(%a+)="([^"]*)"') do
    if (attribute == "src" or tag == "link" and attribute == "href") then
      if target:match("^%a+:") or target:match("^//") then
        fail(name, "loads %s", target)
      end
      follow(name, target)
    end
  end
  for src in text:gmatch(' src="([^"]*)"') do follow(name, src) end
end

for i = 1, math.min(#failed, 40) do print("not ok link: " .. failed[i]) end
if #failed == 0 then
  print(("ok links: %d on %d pages"):format(links, #order))
end
