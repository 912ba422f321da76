# Measures before it looks whether there is a point.
# expect: An empty span has no first place
# why: A do-while loop: surely there is a first vector.
s/place < span\[s\].end;/place == span[s].begin || place < span[s].end;/
