# Asks first whether the triangles meet.
# expect: Neighbors need no dear question
# why: It is the question that the exercise is about, so it comes first.
s/if (!share_node(corner\[next.one\], corner\[next.other\]) &&/if (triangles_meet(next.one, next.other) \&\&/
s/^            triangles_meet(next.one, next.other))/            !share_node(corner[next.one], corner[next.other]))/
