/// How the slots that compact.cl packs are cut up.
#pragma once

#define COMPACT_CHUNK 256u  ///< slots of a work-item
