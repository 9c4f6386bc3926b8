// Whitted's integrator (CACM 23(6) 1980): what happens at a hit. The loop over these kernels is runtime/integrators/whitted.cpp.
#include "generated/constants.h"
#include "generated/instances.cl"
#include "generated/interior.cl"
#include "generated/shadow_filter.cl"
#include "generated/tints.cl"
#include "kernels/bsdfs/bsdf.cl"
#include "kernels/bsdfs/emitted.cl"
#include "kernels/core/load.cl"
#include "kernels/core/params.h"
#include "kernels/core/random.cl"
#include "kernels/core/refraction.cl"
#include "kernels/core/scene.cl"
#include "kernels/core/sides.cl"
#include "kernels/core/spawn.cl"
#include "kernels/lights/light.cl"

/// Tells the random number for the choice of a child from others of the same ray.
#define CHOICE_OF_CHILD 0x68bc21ebu

FUNCTION bool worth_tracing(Spectrum throughput, WhittedParams params, uint flags) {
    const float weight = largest(throughput);
    return (weight >= params.threshold) & ((weight > 0.0f) | ((flags & MATERIAL_SPAWNS_ALWAYS) != 0u));
}

/// One of a hit's two children is followed, as likely as what it counts in the most important channel; its weight makes up for that.
typedef struct {
    bool reflected;  ///< which
    float weight;    ///< 1 / probability; 0 where neither counts
} Choice;

FUNCTION Choice choose_child(Split split, uint branch) {
    const float reflected = largest(split.reflected), refracted = largest(split.refracted), both = reflected + refracted;
    Choice choice;
    choice.reflected = unit_interval(hash(branch ^ CHOICE_OF_CHILD)) * both < reflected;
    const float chosen = choice.reflected ? reflected : refracted;
    choice.weight = chosen > 0.0f ? both / chosen : 0.0f;
    return choice;
}

/// Children of live item i: the mirrored ray in slot base + i, and where BRANCHING is 2 the refracted one in slot base + count + i, in the media
/// `beyond`. Where FOLLOWS_ONE, one of both, chosen at random (Cook, Porter & Carpenter, SIGGRAPH 1984), in slot base + i. They leave a primitive in
/// instance instances[i], where scenes have some. A shading normal may lead a ray to the wrong side of the surface; then its mirror image at the
/// surface leaves instead.
kernel void spawn_whitted(SCENE_PARAMS, WhittedParams params, LIVE_PARAMS, const global Path *restrict paths,
                          const global SurfacePoint *restrict points, const global SurfaceInterface *restrict interfaces,
                          const global vec3 *restrict directions, const global uint *restrict instances, const global uint *restrict interiors,
                          const global uint *restrict beyond, uint base, global Ray *restrict children, global Path *restrict child_paths,
                          global uint *restrict child_sources, global uint *restrict child_interiors, global uchar *restrict child_alive) {
    const Scene scene = SCENE;
    const global Material *materials = SCENE_ARRAY(scene, Material, materials);
    const global uint *list = live + first;
    global Ray *first_rays = children + base, *second_rays = first_rays + count;
    global Path *first_paths = child_paths + base, *second_paths = first_paths + count;
    global uchar *first_alive = child_alive, *second_alive = child_alive + count;
    FOR_EACH_ITEM(i, count) {
        const uint k = list[i];
        const Path path = load(paths + k);
        const SurfacePoint surface = load(points + i);
        const SurfaceInterface interface = load(interfaces + i);
        const vec3 wo = load(directions + i);
        const uint primitive = SURFACE_PRIMITIVE(surface.flags);
        const Sides sides = sides_of(surface, interface);
        const vec3 normal = sides.normal, geometric = sides.geometric;
        const global Material *material = materials + surface.material;
        const bool goes_on = (surface.flags & SURFACE_HIT) != 0u && path.depth < params.max_depth;

        const float projection = dot3(wo, normal), cosine = minimum(maximum(projection, 0.0f), 1.0f);
        const float cosine_squared_beyond = refracted_cosine_squared(cosine, interface.eta);
        const bool transmits = TRANSMITS && (material->flags & MATERIAL_TRANSMITS) != 0u;
        const bool total = transmits & (cosine_squared_beyond < 0.0f);
        const bool reflects = ((material->flags & MATERIAL_REFLECTS) != 0u) | total, refracts = transmits & !total;
        const Split split = bsdf_split(material, cosine, cosine_squared_beyond, interface.eta, total);
        const Spectrum reflected = times(path.throughput, split.reflected), refracted = times(path.throughput, split.refracted);
        const vec3 mirrored = unit(folded(minus(scaled(normal, 2.0f * projection), wo), geometric));
        const float bend = interface.eta * cosine - sqrt(maximum(cosine_squared_beyond, 0.0f));
        const vec3 bent = unit(folded(minus(scaled(normal, bend), scaled(wo, interface.eta)), negate(geometric)));

        // The first child: the mirrored ray, or the one that is chosen.
        const Choice choice = choose_child(split, path.branch);
        const bool mirrors = !FOLLOWS_ONE | (choice.reflected & reflects) | !refracts;
        const Ray mirrored_ray = ray_spawn(sides.near, mirrored, RAY_REFLECTED, primitive),
                  bent_ray = ray_spawn(sides.far, bent, RAY_REFRACTED, primitive);
        Path child = path;
        child.depth = path.depth + 1u;
        child.throughput = scaled(where(mirrors, reflected, refracted), (FOLLOWS_ONE & reflects & refracts) ? choice.weight : 1.0f);
        child.branch = hash(path.branch * 2u + (mirrors ? 0u : 1u));
        interior_choose(mirrors, interiors, k, beyond, i, child_interiors, base + i);
        store_instance(child_sources, base + i, instance_at(instances, i));
        first_rays[i] = where(mirrors, mirrored_ray, bent_ray);
        first_paths[i] = child;
        first_alive[i] = goes_on & (mirrors ? reflects : refracts) & worth_tracing(child.throughput, params, material->flags);

        if (BRANCHING == 2u) {
            interior_copy(beyond, i, child_interiors, base + count + i);
            second_rays[i] = bent_ray;
            store_instance(child_sources, base + count + i, instance_at(instances, i));
            child.throughput = refracted;
            child.branch = hash(path.branch * 2u + 1u);
            second_paths[i] = child;
            second_alive[i] = goes_on & refracts & worth_tracing(refracted, params, material->flags);
        }
    }
}

/// Work-items (chunk, row): the shadow ray from hit i to light first_light + row, at row * stride + i; alive where the light faces the surface.
/// Where it faces the shading normal only, the ray goes through the surface itself, and meets it.
kernel void spawn_shadow_rays(SCENE_PARAMS, LIVE_PARAMS, uint first_light, uint stride, const global Path *restrict paths,
                              const global uint *restrict instances, const global SurfacePoint *restrict points,
                              const global SurfaceInterface *restrict interfaces, global Ray *restrict shadow_rays, global uchar *restrict alive) {
    const Scene scene = SCENE;
    const global uint *list = live + first;
    const uint row = get_global_id(1);
    const Light light = SCENE_ARRAY(scene, Light, lights)[first_light + row];
    global Ray *row_rays = shadow_rays + row * stride;
    global uchar *row_alive = alive + row * stride;
    FOR_EACH_ITEM(i, count) {
        const SurfacePoint surface = load(points + i);
        const LightSample sample = light_sample(scene, light, surface.origin, paths[list[i]].branch, instance_at(instances, i));
        const bool leaves = !SHADING_NORMALS || dot3(load(interfaces + i).geometric, sample.ray_direction) > 0.0f;
        row_rays[i] = ray_to_light(surface.origin, sample.ray_direction, sample.distance, leaves ? SURFACE_PRIMITIVE(surface.flags) : NO_HIT);
        row_alive[i] = light_refusals(surface, sample) == 0u;
    }
}

/// Columns of a chunk: what is needed once per light is fetched once per hit.
typedef struct {
    float diffuse[3][ITEMS_PER_WORK_ITEM], specular[3][ITEMS_PER_WORK_ITEM], exponent[ITEMS_PER_WORK_ITEM], sum[3][ITEMS_PER_WORK_ITEM];
} ShadeColumns;

/// contributions[i]: what hit i adds to its sample by the `lights` lights of this block whose visible[row * stride + i] is set, as far as
/// filters[row * stride + i] lets it through where shadows are filtered, and where `with_unlit` is 1 by what needs no light: background, emission,
/// ambient light.
kernel void shade_whitted(SCENE_PARAMS, LIVE_PARAMS, uint with_unlit, uint first_light, uint lights, uint stride, const global Path *restrict paths,
                          const global uint *restrict instances, const global SurfacePoint *restrict points, const global vec3 *restrict directions,
                          const global Tints *restrict tints, const global uchar *restrict visible, const global Spectrum *restrict filters,
                          global Spectrum *restrict contributions) {
    const Scene scene = SCENE;
    const global Material *materials = SCENE_ARRAY(scene, Material, materials);
    const global uint *list = live + first;
    const Spectrum background = scene.header->background, ambient = scene.header->ambient, black = make3(0.0f, 0.0f, 0.0f);
    const uint begin = chunk_of(count).begin;
    ShadeColumns columns;
    {
        FOR_EACH_ITEM(i, count) {
            const uint flags = points[i].flags;
            const global Material *material = materials + points[i].material;
            const Tints tint = tints_at(tints, i);
            const Spectrum own = plus(emitted(material, flags), times(times(ambient, bsdf_ambient(material)), tint.diffuse));
            const Spectrum unlit = where((flags & SURFACE_HIT) != 0u, own, times(background, tint.diffuse));
            const Spectrum sum = where(with_unlit != 0u, unlit, black);
            Phong phong = bsdf_phong(material);
            phong.diffuse = times(phong.diffuse, tint.diffuse), phong.specular = times(phong.specular, tint.specular);
            const uint c = i - begin;
            columns.sum[0][c] = sum.x, columns.sum[1][c] = sum.y, columns.sum[2][c] = sum.z;
            columns.diffuse[0][c] = phong.diffuse.x, columns.diffuse[1][c] = phong.diffuse.y, columns.diffuse[2][c] = phong.diffuse.z;
            columns.specular[0][c] = phong.specular.x, columns.specular[1][c] = phong.specular.y, columns.specular[2][c] = phong.specular.z;
            columns.exponent[c] = phong.exponent;
        }
    }
    for (uint row = 0u; row < lights; ++row) {
        const Light light = SCENE_ARRAY(scene, Light, lights)[first_light + row];
        const global uchar *row_visible = visible + row * stride;
        FOR_EACH_ITEM(i, count) {
            const uint c = i - begin;
            Phong phong;
            phong.diffuse = make3(columns.diffuse[0][c], columns.diffuse[1][c], columns.diffuse[2][c]);
            phong.specular = make3(columns.specular[0][c], columns.specular[1][c], columns.specular[2][c]);
            phong.exponent = columns.exponent[c];
            const SurfacePoint surface = load(points + i);
            const LightSample sample = light_sample(scene, light, surface.origin, paths[list[i]].branch, instance_at(instances, i));
            const Spectrum irradiance = filtered(sample.irradiance, filters, row * stride + i);
            const Spectrum value = times(phong_local(phong, surface.normal, load(directions + i), sample.direction), irradiance);
            const bool lit = (row_visible[i] != 0) & ((surface.flags & SURFACE_LIT) != 0u);  // reads the whole record: see SurfacePoint
            columns.sum[0][c] += lit ? value.x : 0.0f, columns.sum[1][c] += lit ? value.y : 0.0f, columns.sum[2][c] += lit ? value.z : 0.0f;
        }
    }
    {
        FOR_EACH_ITEM(i, count) {
            const uint c = i - begin;
            const Spectrum sum = make3(columns.sum[0][c], columns.sum[1][c], columns.sum[2][c]);
            contributions[i] = times(sum, load(&paths[list[i]].throughput));
        }
    }
}
