# Packs a task away before its last step.
# expect: one step short
# why: The test is made on the steps that were left before this one.
s/kept += rest > 0/kept += rest > 1/
