# Keeps every copy.
# expect: is to be kept once
# why: The broad phases of the chapter report each pair once.
s/if (next.one == last.one && next.other == last.other)/if (next.one == next.other)/
