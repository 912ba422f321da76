# The counts of a lane stand together, not those of a cell.
# expect: not together by cells
# why: A histogram for each lane is drawn as an array for each lane.
s/static uint32_t step/static uint32_t cells(uint32_t n, const uint32_t *cell)\
{\
    uint32_t most = 0;\
    for (uint32_t i = 0; i < n; i++)\
        most = cell[i] > most ? cell[i] : most;\
    return most + 1;\
}\
&/
s/cell\[i\] \* LANES + lanes/lanes * cells(n, cell) + cell[i]/
