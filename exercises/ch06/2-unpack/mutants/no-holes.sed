# Only survivors are written.
# expect: write the hole
# why: They see the survivors in their right places, and zeros between, in a fresh array.
s/values\[i\] = keep\[i\] ? values\[--left\] : hole;/if (keep[i]) values[i] = values[--left];/
