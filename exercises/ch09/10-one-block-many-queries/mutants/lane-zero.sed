# Answers with lane 0.
# expect: does each lane take part
# why: In a plain loop best was the answer.
s/for (int l = 1; l < LANES; l++)/for (int l = 1; l < 1; l++)/
