# Goes through all points again for each neighbor.
# expect: gone through again
# why: The nearest is easy, so they ask for it k times, each time beyond the one before. Right, and k times the work.
/uint32_t found = 0;/,/^    }$/c\
    for (uint32_t place = 0; place < k; place++) {\
        distances2[place] = INFINITY;\
        for (uint32_t j = 0; j < points.n; j++) {\
            double d2 = distance2(points.x[j] - points.x[i],\
                                  points.y[j] - points.y[i]);\
            int before = place > 0 \&\& (d2 < distances2[place - 1] ||\
                (d2 == distances2[place - 1] \&\& j <= neighbors[place - 1]));\
            if (j != i \&\& !before \&\& d2 < distances2[place]) {\
                neighbors[place] = j;\
                distances2[place] = d2;\
            }\
        }\
    }
