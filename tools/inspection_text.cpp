#include "tools/inspection_text.h"

#include <fmt/format.h>

namespace brandung {
namespace {

using nlohmann::json;

std::string number(const json &decimal) { return decimal.is_null() ? "inf" : fmt::format("{:g}", decimal.get<double>()); }

/// "1 0.5 0 [0x1p+0 0x1p-1 0x0p+0]"; of equal components one, with as many signs as there are.
std::string floats(const json &value) {
    if (!value["decimal"].is_array())
        return fmt::format("{} [{}]", value["decimal"].is_null() ? value["hex"].get<std::string>() : number(value["decimal"]),
                           value["hex"].get<std::string>());
    std::string decimals, hexes;
    for (std::size_t i = 0; i < 3; ++i) {
        decimals += (i > 0 ? " " : "") + number(value["decimal"][i]);
        hexes += (i > 0 ? " " : "") + value["hex"][i].get<std::string>();
    }
    return decimals + " [" + hexes + "]";
}
std::string fixed_point(const json &value) {
    return fmt::format("{} {} {}", value[0].get<std::string>(), value[1].get<std::string>(), value[2].get<std::string>());
}
bool is_black(const json &value) { return value["decimal"] == json({0.0f, 0.0f, 0.0f}); }

std::string primitive(const json &p) {
    return fmt::format("primitive {}: {} {} of object {}, material \"{}\"", p["primitive"].get<uint64_t>(), p["kind"].get<std::string>(),
                       p["primitive_of_object"].get<uint64_t>(), p["object"].get<uint64_t>(), p["material"].get<std::string>());
}

/// Lines of a tree.
class Lines {
public:
    void line(const std::string &what) { text_ += prefix_ + what + "\n"; }
    void field(const std::string &name, const std::string &value) { line(fmt::format("{:<19}{}", name, value)); }
    /// What `write` adds hangs on `what`.
    template <class Write> void branch(const std::string &what, bool last, Write write) {
        text_ += prefix_ + (last ? "└─ " : "├─ ") + what + "\n";
        const std::size_t length = prefix_.size();
        prefix_ += last ? "   " : "│  ";
        write();
        prefix_.resize(length);
    }
    const std::string &text() const { return text_; }

private:
    std::string text_, prefix_;
};

void write_ray(Lines &lines, const json &ray);

void write_surface(Lines &lines, const json &surface) {
    lines.field("point", floats(surface["point"]));
    lines.field("  error", floats(surface["error"]));
    lines.field("geometric normal", floats(surface["geometric_normal"]));
    if (surface["shading_normal"] != surface["geometric_normal"]) lines.field("shading normal", floats(surface["shading_normal"]));
    lines.field("side", fmt::format("the ray {} at cosine {}", surface["side"].get<std::string>(), floats(surface["cosine"])));
}

std::string media(const json &list) {
    std::string text;
    for (const json &medium : list) {
        const uint64_t times = medium["times"];
        text += (text.empty() ? "" : ", ") + medium["material"].get<std::string>() + (times > 1 ? fmt::format(" ({} times)", times) : "");
    }
    return text.empty() ? "nothing" : text;
}

void write_interface(Lines &lines, const json &interface) {
    lines.field("media", fmt::format("in {}; behind: {}", media(interface["media_before"]), media(interface["media_behind"])));
    lines.field("eta", floats(interface["eta"]) + (interface["total_internal_reflection"] ? ", total internal reflection" : ""));
}

void write_light(Lines &lines, const json &light, bool last) {
    const std::string name = fmt::format("light {} ({}): ", light["light"].get<uint64_t>(), light["kind"].get<std::string>());
    if (!light["asked"]) return lines.branch(name + "not asked, " + light["why_not"].get<std::string>(), last, [] {});
    lines.branch(name + (light["visible"] ? "visible" : "hidden"), last, [&] {
        lines.field("from", floats(light["origin"]));
        lines.field("direction", floats(light["direction"]));
        lines.field("t_max", floats(light["t_max"]));
        if (!light["blocker"].is_null()) lines.field("met", primitive(light["blocker"]) + ", t " + floats(light["blocker"]["t"]));
        lines.field(light["visible"] ? "radiance" : "radiance if visible", floats(light["radiance_if_visible"]));
        if (light["visible"]) lines.field("contribution", floats(light["contribution"]));
    });
}

void write_contribution(Lines &lines, const json &contribution) {
    lines.field("contribution", floats(contribution["radiance"]) + (contribution["refused"] ? ", refused: it is not finite" : ""));
    lines.field("  fixed point", fixed_point(contribution["fixed_point"]));
    lines.field("  running total", fixed_point(contribution["running_total"]));
}

void write_child(Lines &lines, const json &child, bool last) {
    const std::string kind = child["kind"].get<std::string>() + " ray";
    if (!child["spawned"]) return lines.branch(kind + ": none, " + child["why_not"].get<std::string>(), last, [] {});
    lines.branch(kind, last, [&] {
        lines.field("weight", floats(child["weight"]));
        write_ray(lines, child["ray"]);
    });
}

void write_unlit(Lines &lines, const json &unlit) {
    for (const char *name : {"background", "emission", "ambient"})
        if (!is_black(unlit[name])) lines.field(name, floats(unlit[name]));
}

void write_hit(Lines &lines, const json &ray) {
    const json &hit = ray["hit"];
    lines.field("hit", primitive(hit));
    lines.field("  t", floats(hit["t"]));
    lines.field("  u", floats(hit["u"]));
    lines.field("  v", floats(hit["v"]));
    write_surface(lines, ray["surface"]);
    if (!ray["interface"].is_null()) write_interface(lines, ray["interface"]);
}

void write_ray(Lines &lines, const json &ray) {
    lines.field("depth", ray["depth"].dump());
    lines.field("throughput", floats(ray["throughput"]));
    if (!ray["passed"].is_null()) {
        lines.field("passes", "faces where the medium stays the same, from " + floats(ray["passed"]["from"]));
        lines.field("  the first", primitive(ray["passed"]["first"]));
        lines.field("  the last", primitive(ray["passed"]["last"]));
    }
    lines.field("origin", floats(ray["origin"]));
    lines.field("direction", floats(ray["direction"]));
    if (ray["hit"].is_null())
        lines.field("hit", "nothing");
    else
        write_hit(lines, ray);
    write_unlit(lines, ray["unlit"]);
    for (const json &contribution : ray["contributions"]) write_contribution(lines, contribution);
    const json &lights = ray["lights"], &children = ray["children"];
    for (std::size_t i = 0; i < lights.size(); ++i) write_light(lines, lights[i], children.empty() && i + 1 == lights.size());
    for (std::size_t j = 0; j < children.size(); ++j) write_child(lines, children[j], j + 1 == children.size());
}

}  // namespace

std::string inspection_text(const json &inspection) {
    Lines lines;
    lines.line(fmt::format("{}: pixel {},{} of {} x {}, {} spp, seed {}, {}, max_depth {}, threshold {}", inspection["scene"].get<std::string>(),
                           inspection["x"].dump(), inspection["y"].dump(), inspection["width"].dump(), inspection["height"].dump(),
                           inspection["spp"].dump(), inspection["seed"].dump(), inspection["integrator"].get<std::string>(),
                           inspection["max_depth"].dump(), inspection["threshold"].dump()));
    for (const json &sample : inspection["samples"]) {
        lines.branch(fmt::format("sample {}: camera ray", sample["number"].dump()), true, [&] { write_ray(lines, sample["ray"]); });
        lines.field("sample " + sample["number"].dump(), fixed_point(sample["sum"]["fixed_point"]));
    }
    const json &pixel = inspection["pixel"];
    lines.field("pixel", fmt::format("{} samples, sum {}", pixel["samples"].dump(), fixed_point(pixel["fixed_point"])));
    lines.field("  radiance", floats(pixel["radiance"]));
    return lines.text();
}

}  // namespace brandung
