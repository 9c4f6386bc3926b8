#include "tools/inspection_json.h"

#include <fmt/format.h>

#include <cmath>

#include "runtime/inspection/reasons.h"
#include "scene/filters/filter.h"
#include "scene/vectors.h"
#include "tools/scene_objects.h"

namespace brandung {
namespace {

using nlohmann::json;

const char *const ray_kinds[RAY_KINDS] = {"camera", "reflected", "refracted", "shadow"};

json decimal(float value) { return std::isfinite(value) ? json(value) : json(nullptr); }
std::string hex(float value) { return fmt::format("{:a}", value); }

json number(float value) { return {{"decimal", decimal(value)}, {"hex", hex(value)}}; }
json vector(vec3 v) { return {{"decimal", {decimal(v.x), decimal(v.y), decimal(v.z)}}, {"hex", {hex(v.x), hex(v.y), hex(v.z)}}}; }

/// Sums of fixed point, per channel.
using Total = std::array<__int128, 3>;

std::string digits(unsigned __int128 value) {
    const std::string last(1, static_cast<char>('0' + static_cast<int>(value % 10)));
    return value < 10 ? last : digits(value / 10) + last;
}
std::string text(__int128 value) {
    return value < 0 ? "-" + digits(-static_cast<unsigned __int128>(value)) : digits(static_cast<unsigned __int128>(value));
}
json fixed(const Total &total) { return {text(total[0]), text(total[1]), text(total[2])}; }
Total widened(const FixedPoint &sum) { return {sum[0], sum[1], sum[2]}; }
__int128 widened(Integer128 sum) { return static_cast<__int128>(static_cast<unsigned __int128>(sum.high) << 64 | sum.low); }

Total widened(const Sample &sample) { return {widened(sample.sum[0]), widened(sample.sum[1]), widened(sample.sum[2])}; }

/// Describes the rays of one scene, and keeps the running total of a sample.
class Describer {
public:
    Describer(const Scene &scene, const CompiledScene &compiled) : scene_(scene), compiled_(compiled), objects_(scene) {}

    json sample(const InspectedSample &sample) {
        total_ = {}, rays_ = 0;
        json tree = ray(sample.ray);
        json result = {{"number", sample.number}, {"ray", tree}, {"sum", fixed(widened(sample.sum))}, {"weighed", fixed(widened(sample.weighed))}};
        if (sample.ray.time) result["time"] = scene_.shutter.open + double(*sample.ray.time) * (scene_.shutter.close - scene_.shutter.open);
        return result;
    }

private:
    const Material &material_of(const TracedRay &ray) const { return scene_.materials[ray.point.material].record; }

    json hit(const Hit &hit, uint instance) {
        if (hit.primitive == NO_HIT) return nullptr;
        json result = objects_.primitive(hit.primitive, instance);
        result.update({{"t", number(hit.t)}, {"u", number(hit.u)}, {"v", number(hit.v)}});
        return result;
    }

    json faces(const std::vector<PassedFace> &passed) {
        json list = json::array();
        for (const PassedFace &face : passed) {
            json one = hit(face.hit, face.instance);
            one.update({{"point", vector(face.p)}, {"side", face.enters != 0 ? "enters" : "leaves"}, {"transmission", vector(face.transmission)}});
            list.push_back(one);
        }
        return list;
    }

    /// What is left behind where a ray passes faces that are no interfaces.
    json passed(const TracedRay &ray) {
        if (!ray.passed_faces()) return nullptr;
        return {{"from", vector(ray.begun.origin)}, {"faces", faces(ray.passed)}};
    }

    json surface(const TracedRay &ray) const {
        const HitDescription &d = ray.description;
        return {{"point", vector(d.p)},
                {"error", vector(d.error)},
                {"geometric_normal", vector(d.geometric)},
                {"shading_normal", vector(d.normal)},
                {"side", glm::dot(d.geometric, ray.ray.direction) < 0 ? "enters" : "leaves"},
                {"material", scene_.materials[ray.point.material].name},
                {"cosine", number(d.cosine)},
                {"origin_lit_side", vector(ray.point.origin)},
                {"origin_other_side", vector(ray.interface.beyond)}};
    }

    json media(const std::vector<uint> &entries) const {
        json list = json::array();
        for (const uint entry : entries)
            if (entry != 0) list.push_back({{"material", scene_.materials[(entry >> 8) - 1].name}, {"times", entry & 0xffu}});
        return list;
    }
    json interface(const TracedRay &ray) const {
        const float squared = ray.description.cosine_squared_beyond;
        return {{"media_before", media(ray.before)},
                {"media_behind", media(ray.behind)},
                {"eta", number(ray.interface.eta)},
                {"cosine_squared_beyond", number(squared)},
                {"total_internal_reflection", squared < 0}};
    }

    /// What textures and vertex colours multiply.
    json tints(const TracedRay &ray) const {
        if (!ray.tints) return nullptr;
        return {{"diffuse", vector(ray.tints->diffuse)}, {"specular", vector(ray.tints->specular)}};
    }

    json unlit(const TracedRay &ray) const {
        const bool hits = ray.hits();
        const Spectrum black(0), tint = ray.tints ? ray.tints->diffuse : Spectrum(1);
        json result = {{"emission", vector(hits ? ray.description.emission : black)},
                       {"ambient", vector(hits ? ray.description.ambient * tint : black)},
                       {"background", vector(hits      ? black
                                             : ray.met ? ray.met->radiance
                                                       : ray.unlit)},
                       {"radiance", vector(ray.unlit)}};
        if (ray.met) result["weight"] = number(ray.met->weight);
        return result;
    }

    json light(const TracedRay &ray, const TracedLight &light) {
        const bool counts = light.asked && light.visible;
        json result = objects_.light(light.row);
        result.update({{"origin", vector(light.ray.origin)},
                       {"direction", vector(light.ray.direction)},
                       {"t_max", number(light.ray.t_max)},
                       {"asked", light.asked},
                       {"why_not", why_not_asked(light)},
                       {"visible", light.visible},
                       {"blocker", light.asked && !light.visible ? hit(light.blocker, light.blocker_instance) : json(nullptr)},
                       {"passed", faces(light.passed)},
                       {"filter", light.visible && light.filter ? vector(*light.filter) : json(nullptr)},
                       {"radiance", vector(light.radiance)},
                       {"contribution", vector(counts ? light.radiance * ray.path.throughput : Spectrum(0))}});
        if (light.chosen) add_choice(*light.chosen, result);
        return result;
    }

    /// How a path has chosen a light, and what its material makes of that.
    static void add_choice(const AskedDescription &chosen, json &light) {
        const float density = 1 / chosen.inverse_density;
        light.update({{"chance", number(chosen.chance)},
                      {"density", chosen.inverse_density > 0 ? number(density) : json(nullptr)},
                      {"irradiance", vector(chosen.irradiance)},
                      {"bsdf", vector(chosen.value)},
                      {"bsdf_density", number(chosen.pdf)},
                      {"weight", number(chosen.weight)}});
    }

    /// Adds each block's contribution to the running total.
    json contributions(const TracedRay &ray) {
        json list = json::array();
        for (const TracedLightBlock &block : ray.lights) {
            const FixedPoint sum = fixed_point(block.contribution);
            for (std::size_t c = 0; c < 3; ++c) total_[c] += sum[c];
            json rows = json::array();
            for (const TracedLight &light : block.lights) rows.push_back(light.row);
            list.push_back({{"rows", rows},
                            {"radiance", vector(block.contribution)},
                            {"fixed_point", fixed(widened(sum))},
                            {"refused", !is_finite(block.contribution)},
                            {"running_total", fixed(total_)}});
        }
        return list;
    }

    json child(const TracedRay &parent, uint kind) {
        const TracedChild *child = child_of_kind(parent, kind);
        return {{"kind", ray_kinds[kind]},
                {"possible", can_spawn(parent, kind, material_of(parent))},
                {"spawned", child && child->traced},
                {"why_not", why_not_spawned(parent, kind, material_of(parent), scene_.integrator)},
                {"weight", child ? vector(child->weight) : json(nullptr)},
                {"direction", child ? vector(child->ray.direction) : json(nullptr)},
                {"ray", child && child->traced ? ray(*child->traced) : json(nullptr)}};
    }

    /// A part of a path's bundle, or the only one.
    json part(const TracedRay &parent, const TracedChild &child) {
        const NextDescription &chosen = child.chosen.value();
        return {{"kind", ray_kinds[RAY_KIND(child.ray.tag)]},
                {"possible", true},
                {"spawned", child.traced != nullptr},
                {"why_not", why_not_continued(parent, child, scene_.integrator)},
                {"weight", vector(child.weight)},
                {"direction", vector(child.ray.direction)},
                {"density", number(chosen.pdf)},
                {"bsdf", vector(chosen.scattered)},
                {"chance", number(chosen.survival)},
                {"roulette", number(chosen.roulette)},
                {"ray", child.traced ? ray(*child.traced) : json(nullptr)}};
    }

    json ray(const TracedRay &ray) {
        const Total before = total_;
        json result = {{"number", rays_++},
                       {"kind", ray_kinds[RAY_KIND(ray.ray.tag)]},
                       {"depth", surface_number(ray)},
                       {"throughput", vector(ray.path.throughput)},
                       {"origin", vector(ray.ray.origin)},
                       {"direction", vector(ray.ray.direction)},
                       {"passed", passed(ray)},
                       {"hit", hit(ray.hit, ray.instance)},
                       {"surface", nullptr},
                       {"interface", nullptr},
                       {"tints", tints(ray)},
                       {"unlit", unlit(ray)},
                       {"lights", json::array()},
                       {"contributions", contributions(ray)},
                       {"children", json::array()}};
        if (scene_.integrator.type == "distributed") result["part"] = {{"number", part_of_sample(ray).number}, {"of", part_of_sample(ray).count}};
        if (ray.hits()) add_hit(ray, result);
        result["subtotal"] = fixed({total_[0] - before[0], total_[1] - before[1], total_[2] - before[2]});
        return result;
    }

    void add_hit(const TracedRay &ray, json &result) {
        result["surface"] = surface(ray);
        if (compiled_.transmits) result["interface"] = interface(ray);
        for (const TracedLightBlock &block : ray.lights)
            for (const TracedLight &each : block.lights) result["lights"].push_back(light(ray, each));
        if (scene_.integrator.traces_paths()) {
            for (const TracedChild &each : ray.children) result["children"].push_back(part(ray, each));
            return;
        }
        if (compiled_.reflects || compiled_.transmits) result["children"].push_back(child(ray, RAY_REFLECTED));
        if (compiled_.transmits) result["children"].push_back(child(ray, RAY_REFRACTED));
    }

    const Scene &scene_;
    const CompiledScene &compiled_;
    SceneObjects objects_;
    Total total_{};  ///< of the sample so far
    uint rays_ = 0;  ///< of the sample so far
};

json pixel_value(const InspectedPixel &pixel) {
    Total sum;
    for (std::size_t c = 0; c < 3; ++c) sum[c] = widened(pixel.film.sums[0][c]) + widened(pixel.film.sums[1][c]);
    return {{"samples", pixel.film.counts[0] + pixel.film.counts[1]}, {"fixed_point", fixed(sum)}, {"radiance", vector(pixel.radiance)}};
}

}  // namespace

json inspection_json(const Scene &scene, const CompiledScene &compiled, const InspectedPixel &pixel, uint x, uint y) {
    Describer describer(scene, compiled);
    json samples = json::array();
    for (const InspectedSample &sample : pixel.samples) samples.push_back(describer.sample(sample));
    json result = {{"scene", scene.file},
                   {"x", x},
                   {"y", y},
                   {"width", scene.film.width},
                   {"height", scene.film.height},
                   {"spp", scene.film.spp},
                   {"splat", splats(scene.film)},
                   {"seed", scene.film.seed},
                   {"integrator", scene.integrator.type},
                   {"max_depth", scene.integrator.max_depth},
                   {"threshold", scene.integrator.threshold},
                   {"samples", samples},
                   {"pixel", pixel_value(pixel)}};
    if (scene.integrator.traces_paths()) result["roulette_depth"] = scene.integrator.roulette_depth;
    return result;
}

}  // namespace brandung
