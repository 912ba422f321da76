#!/bin/sh
# From the first version to the last: ns a pair on one core
# demo: table
# Says on the screen what the last step does on this machine.
"$BUILD/ch02/climb" ${FULL:+20000 2000 15} | awk -F '\t' '
    { print; ns[$1] = $2 }
    END {
        if (!("tiles" in ns))
            exit 1
        printf "The multipliers subtract: the limit goes from %.3g to %.3g ns " \
            "here,\nand the program from %.3g (queries) to %.3g ns (tiles), " \
            "standard geometry.\n", ns["limit"], ns["limit_tiles"],
            ns["queries"], ns["tiles"] >"/dev/stderr"
    }'
