//> Say what a span is
struct span {
    int first, end; // from first to the one before end
    const char *label[2];
    struct span *next;
};
//<

//> Count what spans hold
static inline int length_of(const struct span *span)
{
    int n = 0;
    for (; span; span = span->next) n += span->end - span->first;
    return n;
}
//<
