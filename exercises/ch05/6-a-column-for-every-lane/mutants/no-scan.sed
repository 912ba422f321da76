# It places without the scan.
# expect: scan_counts() was called 0 times
# why: They count, and place by counts.
s/scan_counts();//
