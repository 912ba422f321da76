-- Text made safe for HTML, and the small parts that pages are made of.
local html = {}

-- Between two of @ a page has what is filled in later.
local special = { ["@"] = "&#64;", ["&"] = "&amp;", ["<"] = "&lt;",
  [">"] = "&gt;", ['"'] = "&quot;" }

function html.text(s) return (s:gsub('[@&<>"]', special)) end

-- HTML as plain words, without what only leads to a claim's check.
local entities = { amp = "&", lt = "<", gt = ">", quot = '"' }

function html.plain(s)
  return (s:gsub("<annotation.-</annotation>", "")
    :gsub('<a class="checked".-</a>', "")
    :gsub('<svg.-</svg>', ""):gsub("<[^>]*>", "")
    :gsub("&(%a+);", entities):gsub("&#(%d+);", function(n)
      return utf8.char(tonumber(n)) end))
end

-- A name for an address: small letters, digits and hyphens.
function html.slug(s)
  return (s:lower():gsub("[^%w]+", "-"):gsub("^%-", ""):gsub("%-$", ""))
end

-- A template's @NAME@ replaced by what is HTML already.
function html.fill(template, values)
  return (template:gsub("@(%u+)@", values))
end

return html
