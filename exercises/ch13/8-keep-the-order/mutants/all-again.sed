# Carries each end to the very beginning.
# expect: need not be looked at again
# why: The loop is left by its condition only.
s/^            if (in_order(place - 1))/            if (!in_order(place - 1))/
s/^                break;/                pass(place - 1);/
s/^            pass(place - 1);//
