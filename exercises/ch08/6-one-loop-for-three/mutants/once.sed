# Asks once.
# expect: It was never given what comes after
# why: Home is asked for before the loop, and the loop measures.
s/^    for (;;) {/    refill(\&lanes, start);\n    for (;;) {/
s/^        refill(&lanes, start);//
