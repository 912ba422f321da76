// Memory has no pages to ask for here: nothing to declare.
#pragma once
