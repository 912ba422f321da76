# Brings results straight to their places.
# expect: Carry it first
# why: It is one loop of one line, and on paper it is n steps.
s/        set(ROOM, next\[record.index \/ BUCKET\]++, record);/        set(OUTPUT, record.index, record);/
/const struct record record = get(ROOM, s);/{
N
/OUTPUT/{
N
s/.*/        (void)s;\n    }/
}
}
