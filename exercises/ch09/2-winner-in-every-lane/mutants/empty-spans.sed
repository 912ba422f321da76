# Measures before it asks whether there is anybody.
# expect: An empty span has no first place
s/place < span\[s\].end;/place == span[s].begin || place < span[s].end;/
