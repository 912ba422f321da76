# Asks about every copy, and drops it afterward.
# expect: its copies stand side by side
# why: What has come before is looked for among the contacts, last of all.
# points: 7
s/if (next.one == last.one && next.other == last.other)/const bool before = next.one == last.one \&\& next.other == last.other;\n        if (false)/
s/^            triangles_meet(next.one, next.other))/            triangles_meet(next.one, next.other) \&\& !before)/
