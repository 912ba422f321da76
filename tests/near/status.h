// The run of near whose check finds a mistake.
#pragma once

void a_mistake_has_status_1(void);
