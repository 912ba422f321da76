# Decides.
# expect: cannot be guessed
# why: It is how one would say it.
s/        list\[first\] = number;/        if (less) {\n            list[first++] = number;\n            __asm__ volatile("");\n        } else {\n            room[second++] = number;\n            __asm__ volatile("");\n        }/;/room\[second\] = number;/d;/first += less;/d;/second += !less;/d
