# The sign jumps to the next number to be drawn.
# expect: never served
# why: The lock shall be free afterward, and free means that both numbers are equal.
s/mine + 1,$/atomic_load(\&lock->next) + 0 * mine,/
