# Keeps spans without points.
# expect: need not be a span
# why: An empty span does no harm to a search, only to the count of spans.
/if (begin == end)/,+1d
