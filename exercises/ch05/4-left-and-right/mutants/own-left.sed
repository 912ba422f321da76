# A thread's right ones stand behind its own left ones.
# expect: behind the left ones of all threads
s/r = lefts + (from - left\[t\])/r = from + mine/
