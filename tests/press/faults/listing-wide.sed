# code/ch01-near/near.c
# expect: code/ch01-near/near.c:22: this line would be 87 columns wide, and the page has 72
22s|;|; // and here somebody goes on at length, for no reason at all, it seems|
