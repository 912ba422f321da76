# Asks for all lanes before every step.
# expect: Only a task that has met all of a cell may ask
# why: It is simplest to ask all lanes before each step, since the answer for the others could be ignored.
/if (lanes->place\[l\] == lanes->end\[l\])/d
