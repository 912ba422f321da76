# It asks how high the stack has been when the array is taken.
# expect: Fresh memory is 0 already
# why: take was written first and is called first.
s/const size_t begin = top, used = highest - top;/const size_t begin = top;/; s/^    take(bytes);/&\
    const size_t used = highest - begin;/
