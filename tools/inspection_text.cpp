#include "tools/inspection_text.h"

#include <fmt/format.h>

#include <cstdlib>

namespace brandung {
namespace {

using nlohmann::json;

std::string text_of(const json &value) { return value.is_string() ? value.get<std::string>() : value.dump(); }
std::string decimal(const json &value, const json &hex) { return value.is_null() ? text_of(hex) : fmt::format("{:g}", value.get<double>()); }

/// "0.5 1 0 [0x1p-1 0x1p+0 0x0p+0]"; three equal ones, bit for bit, only once.
std::string floats(const json &value) {
    const json &decimals = value["decimal"], &hexes = value["hex"];
    if (!decimals.is_array()) return fmt::format("{} [{}]", decimal(decimals, hexes), text_of(hexes));
    if (hexes[0] == hexes[1] && hexes[1] == hexes[2]) return fmt::format("{} each [{}]", decimal(decimals[0], hexes[0]), text_of(hexes[0]));
    std::string left, right;
    for (std::size_t i = 0; i < 3; ++i) left += decimal(decimals[i], hexes[i]) + " ", right += (i > 0 ? " " : "") + text_of(hexes[i]);
    return left + "[" + right + "]";
}
bool is_black(const json &value) { return value["decimal"] == json({0.0f, 0.0f, 0.0f}); }

std::string fixed_point(const json &value) { return fmt::format("{} {} {}", text_of(value[0]), text_of(value[1]), text_of(value[2])); }
/// Of fixed point, in decimal.
std::string radiance(const json &value) {
    const auto channel = [](const json &text) { return fmt::format("{:.4g}", std::strtod(text_of(text).c_str(), nullptr) * 0x1p-32); };
    return fmt::format("{} {} {}", channel(value[0]), channel(value[1]), channel(value[2]));
}

/// "triangle 3 of shape 1 in group "tree", scene.json:12: /groups/0/objects/1".
std::string shape(const json &s) {
    return fmt::format("shape {}{}{}", text_of(s["shape"]), s["group"].is_null() ? "" : " in group \"" + text_of(s["group"]) + "\"",
                       s["place"].is_null() ? "" : ", " + text_of(s["place"]));
}
std::string primitive(const json &p) {
    const json &instance = p["instance"];
    const std::string placed = instance.is_null() ? "" : "; in instance " + text_of(instance["number"]);
    const std::string place = instance.is_null() || instance["place"].is_null() ? "" : ", " + text_of(instance["place"]);
    const std::string source = p["source"].is_null() ? "" : ", " + text_of(p["source"]);
    return fmt::format("primitive {}, \"{}\": {} {} of {}{}{}{}", text_of(p["primitive"]), text_of(p["material"]), text_of(p["kind"]),
                       text_of(p["primitive_of_shape"]), shape(p), source, placed, place);
}

/// Lines of a tree.
class Lines {
public:
    void line(const std::string &what) { text_ += prefix_ + what + "\n"; }
    void field(const std::string &name, const std::string &value) { line(fmt::format("{:<18} {}", name, value)); }
    /// What `write` adds hangs on `what`.
    template <class Write> void branch(const std::string &what, bool last, Write write) {
        text_ += prefix_ + (last ? "└─ " : "├─ ") + what + "\n";
        indented(last ? "   " : "│  ", write);
    }
    template <class Write> void indented(const std::string &by, Write write) {
        const std::size_t length = prefix_.size();
        prefix_ += by;
        write();
        prefix_.resize(length);
    }
    const std::string &text() const { return text_; }

private:
    std::string text_, prefix_;
};

// ---- the tree, a line per ray ----------------------------------------------------------------------------------------------------------------

/// Transparent things are entered and left, others are hit.
std::string encounter(const json &ray) {
    const std::string side = text_of(ray["surface"]["side"]);
    for (const json &child : ray["children"])
        if (child["kind"] == "refracted" && child["possible"]) return side;
    return side == "enters" ? "hits" : "hits the back of";
}

std::string what_it_meets(const json &ray) {
    if (ray["hit"].is_null()) return "meets nothing";
    return fmt::format("{} \"{}\", {} {}", encounter(ray), text_of(ray["hit"]["material"]), text_of(ray["hit"]["kind"]),
                       text_of(ray["hit"]["primitive"]));
}

void write_tree(Lines &lines, const json &ray, bool last);

void write_branch(Lines &lines, const json &child, bool last) {
    if (child["spawned"])
        write_tree(lines, child["ray"], last);
    else
        lines.branch(fmt::format("no {}: {}", text_of(child["kind"]), text_of(child["why_not"])), last, [] {});
}

std::string part(const json &ray) {
    return ray.contains("part") ? fmt::format(", part {} of {}", text_of(ray["part"]["number"]), text_of(ray["part"]["of"])) : "";
}

/// The ray and what the surface that it hits could spawn.
void write_tree(Lines &lines, const json &ray, bool last) {
    const std::string line =
        fmt::format("{} {} {}: adds {}", text_of(ray["number"]), text_of(ray["kind"]), what_it_meets(ray), radiance(ray["subtotal"]));
    std::vector<const json *> children;
    for (const json &child : ray["children"])
        if (child["possible"]) children.push_back(&child);
    lines.branch(line, last, [&] {
        for (const json *child : children) write_branch(lines, *child, child == children.back());
    });
}

// ---- all that is known of each ray -----------------------------------------------------------------------------------------------------------

std::string media(const json &list) {
    std::string text;
    for (const json &medium : list)
        text += (text.empty() ? "" : ", ") + text_of(medium["material"]) + (medium["times"] > 1 ? " x " + text_of(medium["times"]) : "");
    return text.empty() ? "none" : text;
}

std::string faces(const json &list) { return fmt::format("{} face{}", list.size(), list.size() == 1 ? "" : "s"); }

void write_passed(Lines &lines, const json &passed) {
    lines.field("spawned at", floats(passed["from"]));
    lines.field("  passes", faces(passed["faces"]) + " that are no interfaces: the medium that counts stays");
    for (const json &face : passed["faces"]) lines.field("  " + text_of(face["side"]), fmt::format("{}; t {}", primitive(face), floats(face["t"])));
}

void write_hit(Lines &lines, const json &ray) {
    const json &hit = ray["hit"], &surface = ray["surface"], &interface = ray["interface"];
    lines.field("hits", primitive(hit));
    if (surface["material"] != hit["material"]) lines.field("  chosen", "\"" + text_of(surface["material"]) + "\"");
    lines.field("  t, u, v", fmt::format("{}, {}, {}", floats(hit["t"]), floats(hit["u"]), floats(hit["v"])));
    lines.field("point", floats(surface["point"]));
    lines.field("  error bound", floats(surface["error"]));
    lines.field("geometric normal", floats(surface["geometric_normal"]));
    lines.field("shading normal", surface["shading_normal"] == surface["geometric_normal"] ? "the same" : floats(surface["shading_normal"]));
    lines.field("side", fmt::format("{}; cosine {}", text_of(surface["side"]), floats(surface["cosine"])));
    if (interface.is_null()) return;
    lines.field("media", fmt::format("before: {}; behind: {}", media(interface["media_before"]), media(interface["media_behind"])));
    lines.field("eta", floats(interface["eta"]) + (interface["total_internal_reflection"] ? "; total internal reflection if it transmits" : ""));
}

std::string light_state(const json &light) {
    if (!light["asked"]) return "not asked: " + text_of(light["why_not"]);
    const std::string through = light["passed"].empty() ? "" : " through " + faces(light["passed"]);
    if (light["visible"]) return fmt::format("visible{}; adds {}", through, floats(light["contribution"]));
    return light["blocker"].is_null() ? "hidden" + through : fmt::format("hidden{} by {}", through, primitive(light["blocker"]));
}

/// "stratum 0,1 of 2 x 2" of a grid, "stratum 3 of 4" of others.
std::string stratum(const json &stratum) {
    if (stratum.contains("cell")) return fmt::format("stratum {} of {}", text_of(stratum["cell"]), text_of(stratum["cells"]));
    const std::string rows = text_of(stratum["rows"]);
    return fmt::format("stratum {},{} of {} x {}", text_of(stratum["column"]), text_of(stratum["row"]), rows, rows);
}

std::string name_of_light(const json &light) {
    if (!light["emissive"].is_null()) return fmt::format("light of row {}", text_of(light["row"]));
    return light["light"].is_null() ? "background asked" : fmt::format("light {}, {}", text_of(light["light"]), text_of(light["kind"]));
}

/// Of paths, which choose one light.
void write_choice(Lines &lines, const json &light) {
    lines.field("  chance", floats(light["chance"]));
    if (!light["density"].is_null()) lines.field("  its density", floats(light["density"]));
    lines.field("  irradiance", floats(light["irradiance"]));
    lines.field("  BSDF x cosine", floats(light["bsdf"]));
    lines.field("  BSDF's density", floats(light["bsdf_density"]));
    lines.field("  weight", floats(light["weight"]));
}

void write_light(Lines &lines, const json &light) {
    const json &emissive = light["emissive"];
    const std::string name = name_of_light(light);
    lines.field(name, light_state(light));
    if (!emissive.is_null())
        lines.field("  emissive", fmt::format("\"{}\", {}; {}", text_of(emissive["material"]), shape(emissive), stratum(emissive["stratum"])));
    if (light.contains("chance")) write_choice(lines, light);
    if (!light["asked"]) return;
    lines.field("  from", floats(light["origin"]));
    lines.field("  direction", floats(light["direction"]));
    lines.field("  t_max", floats(light["t_max"]));
    if (!light["blocker"].is_null()) lines.field("  t of what hides", floats(light["blocker"]["t"]));
    for (const json &face : light["passed"])
        lines.field("  " + text_of(face["side"]),
                    fmt::format("{}; t {}; lets through {}", primitive(face), floats(face["t"]), floats(face["transmission"])));
    if (!light["filter"].is_null()) lines.field("  filter", floats(light["filter"]));
    lines.field(light["visible"] ? "  radiance" : "  hidden radiance", floats(light["radiance"]));
}

void write_child(Lines &lines, const json &child) {
    const std::string name = text_of(child["kind"]) + " ray";
    lines.field(name, child["spawned"] ? "ray " + text_of(child["ray"]["number"]) : "none: " + text_of(child["why_not"]));
    if (!child["possible"] || child["weight"].is_null()) return;
    lines.field("  weight", floats(child["weight"]));
    lines.field("  direction", floats(child["direction"]));
    if (!child.contains("roulette")) return;
    lines.field("  density", floats(child["density"]));
    lines.field("  BSDF / density", floats(child["bsdf"]));
    lines.field("  chance to go on", fmt::format("{}; roulette {}", floats(child["chance"]), floats(child["roulette"])));
}

void write_contribution(Lines &lines, const json &contribution) {
    lines.field("contribution", floats(contribution["radiance"]) + (contribution["refused"] ? "; refused, since not finite" : ""));
    lines.field("  fixed point", fixed_point(contribution["fixed_point"]));
    lines.field("  total so far", fixed_point(contribution["running_total"]));
}

void write_fields(Lines &lines, const json &ray) {
    lines.field("throughput", floats(ray["throughput"]));
    if (!ray["passed"].is_null()) write_passed(lines, ray["passed"]);
    lines.field("origin", floats(ray["origin"]));
    lines.field("direction", floats(ray["direction"]));
    if (!ray["hit"].is_null()) write_hit(lines, ray);
    if (!ray["tints"].is_null()) {
        lines.field("tint of diffuse", floats(ray["tints"]["diffuse"]));
        lines.field("  of specular", floats(ray["tints"]["specular"]));
    }
    for (const char *name : {"background", "emission", "ambient"})
        if (!is_black(ray["unlit"][name])) lines.field(name, floats(ray["unlit"][name]));
    if (ray["unlit"].contains("weight") && !is_black(ray["unlit"]["radiance"])) lines.field("  its weight", floats(ray["unlit"]["weight"]));
    for (const json &light : ray["lights"]) write_light(lines, light);
    for (const json &contribution : ray["contributions"]) write_contribution(lines, contribution);
    for (const json &child : ray["children"]) write_child(lines, child);
}

void write_details(Lines &lines, const json &ray) {
    lines.line(fmt::format("ray {}: {}, depth {}{}, {}", text_of(ray["number"]), text_of(ray["kind"]), text_of(ray["depth"]), part(ray),
                           what_it_meets(ray)));
    lines.indented("  ", [&] { write_fields(lines, ray); });
    for (const json &child : ray["children"])
        if (child["spawned"]) write_details(lines, child["ray"]);
}

}  // namespace

std::string inspection_text(const json &inspection, bool brief) {
    Lines lines;
    const char *limit = inspection.contains("roulette_depth") ? "roulette_depth" : "threshold";
    lines.line(fmt::format("{}, pixel {},{} of {} x {}: {} spp, seed {}, {}, max_depth {}, {} {}", text_of(inspection["scene"]),
                           text_of(inspection["x"]), text_of(inspection["y"]), text_of(inspection["width"]), text_of(inspection["height"]),
                           text_of(inspection["spp"]), text_of(inspection["seed"]), text_of(inspection["integrator"]),
                           text_of(inspection["max_depth"]), limit, text_of(inspection[limit])));
    for (const json &sample : inspection["samples"]) {
        const std::string time = sample.contains("time") ? " at time " + text_of(sample["time"]) : "";
        lines.line(fmt::format("sample {}{}: {}", text_of(sample["number"]), time, radiance(sample["sum"])));
        write_tree(lines, sample["ray"], true);
        if (!brief) write_details(lines, sample["ray"]);
        lines.field("sum of sample " + text_of(sample["number"]), fixed_point(sample["sum"]));
        if (sample["weighed"] != sample["sum"]) lines.field("  weighed by filter", fixed_point(sample["weighed"]));
    }
    const json &pixel = inspection["pixel"];
    lines.field("sum of pixel", fmt::format("{} in {} samples", fixed_point(pixel["fixed_point"]), text_of(pixel["samples"])));
    lines.field(inspection["splat"] ? "mean of its own samples, which count in the pixels about it too" : "pixel", floats(pixel["radiance"]));
    return lines.text();
}

}  // namespace brandung
