/// Uses of a sampler beyond those at surfaces, which number from 1 on.
#pragma once

#define USE_LENS 0x10000u
#define USE_TIME 0x10001u
