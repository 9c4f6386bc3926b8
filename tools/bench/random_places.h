/// RandomPlaces: random numbers of which scenes and rays of benches are made.
#pragma once
#include <cmath>
#include <random>

#include "kernels/core/portable.h"

namespace brandung {

/// The engine's bits are the same everywhere; the standard's distributions are not.
class RandomPlaces {
public:
    explicit RandomPlaces(uint seed) : engine_(seed) {}
    float unit() { return static_cast<float>(engine_() >> 8) * 0x1p-24f; }
    vec3 in_cube() {
        const float x = unit(), y = unit();
        return {x, y, unit()};
    }
    vec3 direction() {
        while (true) {
            const vec3 d = 2.0f * in_cube() - 1.0f;
            const float squared = glm::dot(d, d);
            if (squared > 0.01f && squared < 1) return d / std::sqrt(squared);
        }
    }

private:
    std::mt19937 engine_;
};

}  // namespace brandung
