-- The picture on the title page, as PDF drawing commands: points in a
-- disc; from each a stroke to its nearest neighbor, and a hair to its
-- furthest.
local N, RADIUS, CENTER = 420, 118, 120

-- The same points on every machine.
local state = 1
local function uniform()
  state = (state * 16807) % 2147483647
  return state / 2147483647
end

local x, y = {}, {}
for i = 1, N do
  local r, angle = RADIUS * math.sqrt(uniform()), 2 * math.pi * uniform()
  x[i], y[i] = CENTER + r * math.cos(angle), CENTER + r * math.sin(angle)
end

local near, far = {}, {}
for i = 1, N do
  local least, most = math.huge, -1
  for j = 1, N do
    local d = (x[i] - x[j]) ^ 2 + (y[i] - y[j]) ^ 2
    if j ~= i and d < least then least, near[i] = d, j end
    if d > most then most, far[i] = d, j end
  end
end

local draw = {}
local function lines(to, style)
  table.insert(draw, style)
  for i = 1, N do
    table.insert(draw, ("%.1f %.1f m %.1f %.1f l S"):format(
      x[i], y[i], x[to[i]], y[to[i]]))
  end
end

table.insert(draw, "q 1 J")
lines(far, "0.12 w 0.62 0.70 0.80 RG")
lines(near, "0.9 w 0.07 0.21 0.37 RG")
table.insert(draw, "2.1 w")
for i = 1, N do -- a stroke without length and a round pen is a dot
  table.insert(draw, ("%.1f %.1f m %.1f %.1f l S"):format(
    x[i], y[i], x[i], y[i]))
end
table.insert(draw, "Q")
return table.concat(draw, " ")
