# Lets all tasks wait for the fullest cell.
# expect: rounds of nested loops
# why: They rewrite figure 8, with fewer vectors.
s/^        measure(lanes.n, lanes.task, lanes.place);/        for (uint32_t busy = 1; busy > 0;) {\n            uint32_t task[STRIP], place[STRIP];\n            busy = 0;\n            for (uint32_t l = 0; l < lanes.n; l++)\n                if (lanes.place[l] < lanes.end[l]) {\n                    task[busy] = lanes.task[l];\n                    place[busy++] = lanes.place[l]++;\n                }\n            if (busy > 0)\n                measure(busy, task, place);\n        }/
/^        for (uint32_t l = 0; l < lanes.n; l++)$/,+1d
