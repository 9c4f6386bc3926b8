// Access to the scene's arena.
#pragma once
#include "kernels/core/scene.h"
#include "kernels/textures/texture.h"

typedef struct {
    const global SceneHeader *header;
    const global uchar *arena;
    const global Texel *texels;  ///< where a kernel has them, else 0
} Scene;
#define SCENE_PARAMS const global SceneHeader *restrict scene_header, const global uchar *restrict scene_arena
#define SCENE ((Scene){scene_header, scene_arena, 0})
#define SCENE_WITH_TEXELS ((Scene){scene_header, scene_arena, scene_texels})
/// The records of a span, as a typed pointer.
#define RECORDS(scene, Record, span) ((const global Record *)((scene).arena + 64ul * (span).offset))
/// The same of a span of the header.
#define SCENE_ARRAY(scene, Record, span) RECORDS(scene, Record, (scene).header->span)

/// A list of live indices, or part of it: item i of a stage is live[first + i].
#define LIVE_PARAMS const global uint *restrict live, uint first, uint count
