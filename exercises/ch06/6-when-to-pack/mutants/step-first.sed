# Steps before it asks whether there is work.
# expect: There may be none to begin with
s/while (alive > 0) {/do {/
/^    }$/s/}/} while (alive > 0);/
