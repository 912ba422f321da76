# Not the new strip but the whole block is looked at.
# expect: only the new strip
s/struct block strip = extend(&block, nearest);/extend(\&block, nearest); struct block strip = block;/
