# Places the tasks from the last to the first.
# expect: from the first to the last
# why: The textbook's counting sort runs backward, and so keeps the order; with this scan it reverses it.
s/for (uint32_t i = 0; i < n; i++)$/&/
/order\[places/s/= i;/= n - 1 - i;/
/order\[places/s/length\[i\]/length[n - 1 - i]/
