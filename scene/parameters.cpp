/// Typed values of one object of a scene file.
#include "scene/parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/spelling.h"

namespace brandung {
namespace {

using nlohmann::json;

/// Why a value cannot be what it should; `steps` lead from the value asked for to the one at fault.
struct Refusal {
    std::string why, steps;
};

/// A value as an error message shows it.
std::string shown(const json &value) {
    if (value.is_object()) return "an object";
    if (value.is_array()) return "an array of " + std::to_string(value.size());
    const std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
    return text.size() <= 40 ? text : text.substr(0, 37) + "...";
}

[[noreturn]] void refuse(const std::string &wanted, const json &value) { throw Refusal{"must be " + wanted + ", got " + shown(value), ""}; }

template <class Read> auto read_elements(const json &array, Read read_element) {
    if (!array.is_array()) refuse("an array", array);
    std::vector<decltype(read_element(array))> result;
    result.reserve(array.size());
    for (const json &element : array) try {
            result.push_back(read_element(element));
        } catch (Refusal &refusal) {
            refusal.steps = "/" + std::to_string(result.size()) + refusal.steps;
            throw;
        }
    return result;
}

float read_float(const json &value) {
    if (!value.is_number()) refuse("a number", value);
    const double number = value.get<double>();
    if (std::abs(number) > std::numeric_limits<float>::max()) refuse("within the range of a float", value);
    return static_cast<float>(number);
}

float read_number(const json &value) {
    const float number = read_float(value);
    if (std::abs(value.get<double>()) > max_magnitude)
        refuse("at most 1e15 in magnitude (its square must fit into a float with room to spare)", value);
    return number;
}

float read_positive(const json &value) {
    const float number = read_number(value);
    if (!(number > 0)) refuse("positive", value);
    return number;
}

float read_not_negative(const json &value) {
    const float number = read_number(value);
    if (number < 0) refuse("not negative", value);
    return number;
}

float read_weight(const json &value) {
    const float number = read_float(value);
    if (number < 0) refuse("not negative", value);
    return number;
}

uint read_integer(const json &value, uint low, uint high) {
    const double number = value.is_number() ? value.get<double>() : -1;
    if (!(number >= low && number <= high && number == std::floor(number)))
        refuse("a whole number from " + std::to_string(low) + " to " + std::to_string(high), value);
    return static_cast<uint>(number);
}

bool read_boolean(const json &value) {
    if (!value.is_boolean()) refuse("true or false", value);
    return value.get<bool>();
}

std::string read_text_value(const json &value) {
    if (!value.is_string()) refuse("a text", value);
    return value.get<std::string>();
}

void expect_length(const json &value, std::size_t length) {
    if (!value.is_array() || value.size() != length) refuse("an array of " + std::to_string(length) + " numbers", value);
}

vec2 read_pair(const json &value) {
    expect_length(value, 2);
    const std::vector<float> v = read_elements(value, read_number);
    return {v[0], v[1]};
}

vec3 read_vector(const json &value) {
    expect_length(value, 3);
    const std::vector<float> v = read_elements(value, read_number);
    return {v[0], v[1], v[2]};
}

float read_share(const json &value) {
    const float number = read_weight(value);
    if (number > 1) refuse("at most 1", value);
    return number;
}

/// One number for all three or an array of three, each read by `read_part`.
Spectrum read_spectrum_of(const json &value, float (*read_part)(const json &)) {
    if (value.is_number()) return Spectrum(read_part(value));
    if (!value.is_array() || value.size() != 3) refuse("a number or an array of 3 numbers", value);
    const std::vector<float> v = read_elements(value, read_part);
    return {v[0], v[1], v[2]};
}

Spectrum read_spectrum(const json &value) { return read_spectrum_of(value, read_weight); }
Spectrum read_fraction(const json &value) { return read_spectrum_of(value, read_share); }

std::string joined(const std::vector<std::string> &names) {
    std::string result;
    for (const std::string &name : names) result += (result.empty() ? "" : ", ") + name;
    return result;
}

}  // namespace

Parameters::Parameters(const Document &document, std::string pointer) : document_(&document), pointer_(std::move(pointer)) {
    static const json nothing = json::object();
    const json::json_pointer way(pointer_);
    object_ = document.root.contains(way) ? &document.root.at(way) : &nothing;
    if (!object_->is_object()) fail("", "must be an object, got " + shown(*object_));
}

template <class Read> auto Parameters::read(const std::string &name, Read read_value) const {
    const json *value = find(name);
    if (!value) fail_missing(name);
    try {
        return read_value(*value);
    } catch (const Refusal &refusal) {
        fail_at(*document_, pointer_ + "/" + pointer_step(name) + refusal.steps, refusal.why);
    }
}

template <class T, class Read> T Parameters::read_or(const std::string &name, const std::optional<T> &fallback, Read read_value) const {
    return fallback && !has(name) ? *fallback : read(name, read_value);
}

const json *Parameters::find(const std::string &name) const {
    known_->insert(name);
    const auto found = object_->find(name);
    return found == object_->end() ? nullptr : &*found;
}

bool Parameters::has(const std::string &name) const { return find(name) != nullptr; }

bool Parameters::is_object(const std::string &name) const { return has(name) && find(name)->is_object(); }
bool Parameters::is_text(const std::string &name) const {
    const json *value = find(name);
    return value && value->is_string();
}

float Parameters::number(const std::string &name, std::optional<float> fallback) const { return read_or(name, fallback, read_number); }
float Parameters::positive(const std::string &name, std::optional<float> fallback) const { return read_or(name, fallback, read_positive); }
float Parameters::not_negative(const std::string &name, std::optional<float> fallback) const { return read_or(name, fallback, read_not_negative); }
bool Parameters::boolean(const std::string &name, std::optional<bool> fallback) const { return read_or(name, fallback, read_boolean); }
std::string Parameters::text(const std::string &name, const std::optional<std::string> &fallback) const {
    return read_or(name, fallback, read_text_value);
}
vec3 Parameters::vector(const std::string &name, std::optional<vec3> fallback) const { return read_or(name, fallback, read_vector); }
Spectrum Parameters::spectrum(const std::string &name, std::optional<Spectrum> fallback) const { return read_or(name, fallback, read_spectrum); }
Spectrum Parameters::fraction(const std::string &name, std::optional<Spectrum> fallback) const { return read_or(name, fallback, read_fraction); }

vec3 Parameters::factors(const std::string &name) const {
    return read(name, [](const json &value) { return read_spectrum_of(value, read_number); });
}

std::vector<float> Parameters::numbers(const std::string &name, std::size_t count) const {
    return read(name, [=](const json &value) {
        expect_length(value, count);
        return read_elements(value, read_number);
    });
}

uint Parameters::integer(const std::string &name, std::optional<uint> fallback, uint low, uint high) const {
    return read_or(name, fallback, [=](const json &value) { return read_integer(value, low, high); });
}

uint Parameters::choice(const std::string &name, const std::vector<std::string> &choices, std::optional<uint> fallback) const {
    return read_or(name, fallback, [&](const json &value) {
        const auto found = std::find(choices.begin(), choices.end(), read_text_value(value));
        if (found == choices.end()) refuse("one of " + joined(choices), value);
        return static_cast<uint>(found - choices.begin());
    });
}

std::vector<uint> Parameters::integers(const std::string &name) const {
    const auto read_any = [](const json &value) { return read_integer(value, 0, 0xffffffffu); };
    return read_or(name, std::optional(std::vector<uint>()), [&](const json &value) { return read_elements(value, read_any); });
}

std::vector<std::string> Parameters::texts(const std::string &name) const {
    return read_or(name, std::optional(std::vector<std::string>()), [](const json &value) { return read_elements(value, read_text_value); });
}

std::vector<vec2> Parameters::pairs(const std::string &name) const {
    return read_or(name, std::optional(std::vector<vec2>()), [](const json &value) { return read_elements(value, read_pair); });
}

std::vector<vec3> Parameters::vectors(const std::string &name) const {
    return read_or(name, std::optional(std::vector<vec3>()), [](const json &value) { return read_elements(value, read_vector); });
}

Parameters Parameters::child(const std::string &name) const {
    find(name);
    return {*document_, pointer_ + "/" + pointer_step(name)};
}

std::vector<Parameters> Parameters::children(const std::string &name) const {
    const json *value = find(name);
    std::vector<Parameters> result;
    if (value && !value->is_array()) fail(name, "must be an array, got " + shown(*value));
    for (std::size_t i = 0; value && i < value->size(); ++i)
        result.emplace_back(*document_, pointer_ + "/" + pointer_step(name) + "/" + std::to_string(i));
    return result;
}

std::vector<Parameters> Parameters::one_or_more(const std::string &name) const {
    const json *value = find(name);
    if (value && value->is_object()) return {child(name)};
    return children(name);
}

void Parameters::expect(const std::string &name) const {
    if (!find(name)) fail_missing(name);
}

void Parameters::expect_all_known() const {
    for (auto item = object_->begin(); item != object_->end(); ++item) {
        const std::string &key = item.key();
        if (known_->contains(key)) continue;
        const std::vector<std::string> names = by_likeness(key, {known_->begin(), known_->end()});
        if (!names.empty() && resembles(key, names[0])) fail(key, "unknown key; is \"" + names[0] + "\" meant?");
        fail(key, "unknown key; known here: " + joined(names));
    }
}

void Parameters::fail_missing(const std::string &name) const {
    std::string why = "\"" + name + "\" is missing";
    for (const auto &[key, value] : object_->items())
        if (!known_->contains(key) && resembles(key, name)) why += "; \"" + key + "\" is unknown";
    fail("", why);
}

std::string Parameters::pointer_to(const std::string &name) const {
    const bool present = !name.empty() && object_->contains(name);
    return present ? pointer_ + "/" + pointer_step(name) : pointer_;
}

std::string Parameters::place(const std::string &name) const { return place_of(*document_, pointer_to(name)); }
void Parameters::fail(const std::string &name, const std::string &why) const { fail_at(*document_, pointer_to(name), why); }

void Parameters::fail_element(const std::string &name, std::size_t index, const std::string &why) const {
    fail_at(*document_, pointer_ + "/" + pointer_step(name) + "/" + std::to_string(index), why);
}

}  // namespace brandung
