// Starts paths at the eye.
#include "generated/camera.cl"
#include "generated/filter.cl"
#include "generated/shutter.cl"
#include "kernels/samplers/slot.cl"
#include "kernels/samplers/uses.h"

/// Slot i becomes the ray of sample first_sample + i % samples of pixel pixels[i / samples]. Of cameras that do not see everywhere, seen[i] says
/// whether there is one. Where something moves every sample has a time, at which its ray begins where the camera's motion has brought it; where
/// instances move sources[i] keeps it.
kernel void generate_camera_rays(Camera camera, ShutterParams shutter, const global CameraMotion *restrict motion, BatchParams batch, FILTER_PARAMS,
                                 const global uint *restrict pixels, uint count, global Ray *restrict rays, global uint *restrict sources,
                                 global Path *restrict paths, global uint *restrict live, global uchar *restrict seen,
                                 global Sample *restrict samples) {
    const CameraView view = camera_view(camera);
    FOR_EACH_ITEM(i, count) {
        const PixelSample which = pixel_sample(i, batch, pixels);
        const uint pixel = which.pixel, sample = which.sample;
        const uint px = pixel & 0xffffu, py = pixel >> 16;
        const vec2 place = place_in_square(which, batch);
        const float u = filter_place(place.x, filter, filter_table), v = filter_place(place.y, filter, filter_table);
        const bool corner = batch.position == PIXEL_CORNER;
        const float x = corner ? (float)(int)px / (float)(int)(max(camera.width, 2u) - 1u) : ((float)(int)px + u) / (float)(int)camera.width;
        const float y = corner ? (float)(int)py / (float)(int)(max(camera.height, 2u) - 1u) : ((float)(int)py + v) / (float)(int)camera.height;
        const Ray ray = camera_ray(camera.position, view, x, y, sampler_pair(pixel, sample, whole_sample(), USE_LENS, batch));
        const float time = time_of_sample(pixel, sample, batch, shutter);
        rays[i] = moved_with_camera(ray, motion, shutter, time);
        store_time(sources, i, time);
        store_seen(seen, i, view, x, y);

        Path path;
        path.throughput = make3(1.0f, 1.0f, 1.0f);
        path.slot = i, path.depth = 1u;
        path.branch = hash(pixel ^ hash(sample ^ hash(batch.seed + 1u)));
        paths[i] = path;
        live[i] = i;
    }
    // Apart, so that it is one stretch of zeros and not columns of a record.
    const Sample black = {{{0ul, 0ul}, {0ul, 0ul}, {0ul, 0ul}}};
    FOR_EACH_ITEM_SERIALLY(i, count) { samples[i] = black; }
}
