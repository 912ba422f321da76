# Not the new strip but the whole block is looked at.
# expect: only the new strip
# why: They write the search of a block as a function, and call it for the larger block.
s/struct block strip = extend(&block, nearest);/extend(\&block, nearest); struct block strip = block;/
