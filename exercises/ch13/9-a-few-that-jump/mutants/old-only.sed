# Takes out only the one that was kept last.
# expect: Were both lists in order
# why: The new one is put where the old one was, and is not compared again.
s/^            room\[out++\] = box;//
s/room\[out++\] = order\[--kept\];/room[out++] = order[kept - 1];\n            order[kept - 1] = box;/
