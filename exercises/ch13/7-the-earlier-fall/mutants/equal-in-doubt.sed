# Is not sure of equal integers.
# expect: Of integers of at most 2^25
# why: Equal numbers are always within the doubt.
s/return exact ? BOTH : NOT_SURE;/return NOT_SURE;/
