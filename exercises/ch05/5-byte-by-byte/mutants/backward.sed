# A pass reads from the end, but fills the places from the front.
# expect: from the first to the last
# why: The loop as printed in textbooks runs backward, with ends in place of beginnings; they mix the two.
s/struct record record = get(from, i)/struct record record = get(from, n - 1 - i)/
