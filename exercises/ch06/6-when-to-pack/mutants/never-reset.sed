# Goes on counting what has been paid for.
# expect: begin to count anew
s/^ *idle = 0;//
