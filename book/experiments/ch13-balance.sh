#!/bin/sh
# Who has the contacts: threads by triangle and by pair
exec "$BUILD/ch13/balance" ${FULL:+200 200}
