# Steps before it asks whether there is work.
# expect: There may be none to begin with
# why: A do-while loop, because surely there is work.
s/while (alive > 0) {/do {/
/^    }$/s/}/} while (alive > 0);/
