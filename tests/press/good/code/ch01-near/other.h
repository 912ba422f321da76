//> Say what a box is
struct box {
    int low, end;
};
//<
