# All locks share one sign.
# expect: must not stand in a global variable
# why: They had one lock, and its numbers were global before they moved into a structure.
s/^void acquire/static _Atomic uint32_t drawn, shown;\
&/; s/&lock->next/\&drawn/; s/&lock->serving/\&shown/
