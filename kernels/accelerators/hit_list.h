/// Lists of hits.
#pragma once

#define HIT_LIST_SIZE 8u  ///< so many are kept, the first ones; a list that is full says that there may be more
