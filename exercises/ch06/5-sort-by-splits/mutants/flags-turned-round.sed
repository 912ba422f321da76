# Scans the zeros, for which the flags have to be turned round.
# expect: Scan them as they
# why: "Number of zeros before it" asks for a scan of zeros, so they make zeros.
s/scan(flags)/scan(subtract(constant(n, 1), flags))/
s/n - ones.total/ones.total/
s/choose(flags, add(first, ones.before), zeros)/choose(flags, add(first, zeros), ones.before)/
