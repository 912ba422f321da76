# Counts down while i > 0, and leaves out place 0.
# expect: Place 0 is never written
# why: "Count down while i > 0" is how it is usually written, and with an unsigned index there is nothing below.
s/i = n; i-- > 0;/i = n; --i > 0;/
s/for (uint32_t i = n/if (n > 0) &/
