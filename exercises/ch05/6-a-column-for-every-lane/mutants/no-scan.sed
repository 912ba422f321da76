# It places without the scan.
# expect: scan_counts() was called 0 times
s/scan_counts();//
