#!/bin/sh
# The appendix has a line for every intrinsic that the programs call: the
# name's operation, or all but its width, stands in its tables.
root=$(cd "$(dirname "$0")/../.." && pwd)
appendix=$root/chapters/appendix-intrinsics.md
tables=$(grep '^|' "$appendix" | grep -o '`[^`]*`' | tr -d '`')
missing=
for name in $(grep -rhoE '\b_mm(256|512)?_[a-z0-9_]+' "$root/code" \
    --include='*.c' --include='*.h' | sort -u); do
    whole=$(echo "$name" | sed -E 's/^_mm(256|512)?_//')
    bare=$(echo "$whole" | sed -E 's/^maskz?_//; s/_mask$//')
    operation=$(echo "$bare" | sed -E 's/_?(pd|ps|ss|sd|ep[iu][0-9]+x?|si[0-9]+)$//')
    case $operation in cast*) operation=cast... ;; esac
    operation=${operation%f128}
    found=
    for listed in $tables; do
        case $listed in "$operation" | "$bare" | "maskz_$operation" | \
            "mask_$operation") found=yes ;; esac
    done
    [ -n "$found" ] || missing="$missing $name"
done
if [ -n "$missing" ]; then
    echo "not ok intrinsics: chapters/appendix-intrinsics.md explains not$missing"
else
    echo "ok intrinsics"
fi
