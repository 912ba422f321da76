# Compares each number with both bounds, twice.
# expect: Two bounds from a sample
# why: Two tests in one condition read well.
s/            else if (!is_less(high, k))/            else if (!is_less(high, k) \&\& !is_less(high, k) \&\& !is_less(k, low) \&\& !is_less(k, low))/;s/            if (is_less(k, low))/            if (is_less(k, low) + is_less(k, low) + is_less(k, low) > 2)/
