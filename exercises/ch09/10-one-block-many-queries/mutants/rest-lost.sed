# Goes through whole lanes only.
# expect: also the last ones of it
# why: The loop ends where eight lanes no longer fit.
s/c < buffer->n; c += LANES/c + LANES <= buffer->n; c += LANES/
