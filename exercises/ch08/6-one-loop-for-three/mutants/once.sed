# Asks once.
# expect: It never asked what comes after
# why: Home is asked for before the loop, and the loop measures.
s/^    for (;;) {/    refill(\&lanes, start);\n    for (;;) {/
s/^        refill(&lanes, start);//
