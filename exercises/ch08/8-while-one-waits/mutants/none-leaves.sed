# Lets all lanes go on until the longest has arrived.
# expect: gone on after its last step
# why: They pack at the end of the strip, when all have finished.
s/kept += rest > 0;/kept += 1;/
s/left\[kept\] = rest;/left[kept] = rest;\n            if ((int32_t)rest <= -50)\n                return;/
