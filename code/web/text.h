// A text that a page hands over: it stands in for the file that the
// readers of points open.
#pragma once
#include <stdint.h>

// Room for so many bytes, and a null character behind them. What was
// there before is given up.
char *text_room(uint32_t bytes);
