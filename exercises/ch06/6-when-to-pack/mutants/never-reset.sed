# Goes on counting what has been paid for.
# expect: begin to count anew
# why: The sum is right until the first pack, and their example has one.
s/^ *idle = 0;//
