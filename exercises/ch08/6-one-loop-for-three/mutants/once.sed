# Asks once.
# expect: It never asked what comes after
s/^    for (;;) {/    refill(\&lanes, start);\n    for (;;) {/
s/^        refill(&lanes, start);//
