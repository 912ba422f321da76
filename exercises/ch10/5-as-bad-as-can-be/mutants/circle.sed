# Rounds points of a circle to whole numbers.
# expect: rounding has moved them
# why: It is what the chapter says about circles.
/^    uint32_t most = /i\
    double u = 1, v = 0, h = side / 2.0;\
    for (uint32_t k = 0; k < points.n; k++) {\
        points.x[k] = (uint32_t)(h + h * u + 0.5);\
        points.y[k] = (uint32_t)(h + h * v + 0.5);\
        double w = 0.9999802607 * u - 0.0062831440 * v;\
        v = 0.0062831440 * u + 0.9999802607 * v;\
        u = w;\
    }\
    return;
