# Only survivors are written.
# expect: write the hole
s/values\[i\] = keep\[i\] ? values\[--left\] : hole;/if (keep[i]) values[i] = values[--left];/
