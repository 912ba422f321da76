# Asks for all lanes before every step.
# expect: Only who has met all of a cell may ask
/if (lanes->place\[l\] == lanes->end\[l\])/d
