# A thread's right ones stand behind its own left ones.
# expect: behind the left ones of all threads
# why: With two threads and a picture of one, the right points seem to begin where one's own left ones end.
s/r = lefts + (from - left\[t\])/r = from + mine/
