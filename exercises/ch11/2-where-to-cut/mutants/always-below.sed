# Cuts below the median, whatever comes.
# expect: One part is empty
# why: It is right as long as the median is not the least number.
s/if (below == 0)/if (false \&\& below == 0)/;s/#include <stdlib.h>/#include <stdbool.h>\n&/;s/return n - below <= up_to ? below : up_to;/return below;/
