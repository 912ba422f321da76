# Has no doubt.
# expect: only if nothing was rounded
# why: Sixteen digits are many.
s/const double doubt = exact ? 0 : 4 \* 0x1p-53 \* (of_p + of_q);/const double doubt = 0;/
s/return exact ? BOTH : NOT_SURE;/return BOTH;/
