-- After citeproc: every entry of the bibliography becomes a \reference
-- that a citation can link to, whatever the version of pandoc.
local function tex(text)
  return pandoc.RawInline("latex", text)
end

-- Who has no year is called by name alone.
local function without_nodate(list)
  for i = #list, 3, -1 do
    if list[i].text == "n.d." then
      list[i - 2].text = list[i - 2].text:gsub(",$", "")
      list:remove(i)
      list:remove(i - 1)
    end
  end
  return list
end

local function entry(div)
  local content = pandoc.utils.blocks_to_inlines(div.content)
  content = without_nodate(content)
  content:insert(1, tex("\\reference{" .. div.identifier .. "}{"))
  content:insert(tex("}"))
  return pandoc.Plain(content)
end

function Div(div)
  if div.identifier == "refs" and FORMAT == "html" then
    return pandoc.walk_block(div, { Inlines = without_nodate })
  elseif div.identifier == "refs" then
    return pandoc.List(div.content):map(entry)
  end
end

-- A citation is its links, and nothing more.
function Cite(cite)
  return pandoc.walk_inline(cite, { Inlines = without_nodate }).content
end
