/// Parameters: named, typed values of one object of a scene file, with the place of each for errors.
#pragma once
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "kernels/core/portable.h"
#include "scene/document.h"

namespace brandung {

/// Numbers and vectors are refused beyond this magnitude: the square of a length must fit into a float, with room for sums and products.
inline constexpr double max_magnitude = 1e15;

/// A view of one JSON object. Each getter marks its key as known; `expect_all_known` refuses the others.
class Parameters {
public:
    Parameters(const Document &document, std::string pointer);

    bool has(const std::string &name) const;
    bool is_object(const std::string &name) const;
    bool is_text(const std::string &name) const;  ///< not a number, array, ...

    // Single values. Without a fallback, a missing one is an error.
    float number(const std::string &name, std::optional<float> fallback = {}) const;
    float positive(const std::string &name, std::optional<float> fallback = {}) const;
    float not_negative(const std::string &name, std::optional<float> fallback = {}) const;
    uint integer(const std::string &name, std::optional<uint> fallback = {}, uint low = 0, uint high = 0xffffffffu) const;
    bool boolean(const std::string &name, std::optional<bool> fallback = {}) const;
    std::string text(const std::string &name, const std::optional<std::string> &fallback = {}) const;
    /// The index of one of `choices`.
    uint choice(const std::string &name, const std::vector<std::string> &choices, std::optional<uint> fallback = {}) const;
    vec3 vector(const std::string &name, std::optional<vec3> fallback = {}) const;
    /// One number for all three or an array of three.
    vec3 factors(const std::string &name) const;
    /// An array of so many.
    std::vector<float> numbers(const std::string &name, std::size_t count) const;
    /// One number for all three or an array of three; none negative, none beyond the range of a float.
    Spectrum spectrum(const std::string &name, std::optional<Spectrum> fallback = {}) const;
    /// The same, none beyond 1.
    Spectrum fraction(const std::string &name, std::optional<Spectrum> fallback = {}) const;

    // Arrays; empty if absent.
    std::vector<uint> integers(const std::string &name) const;
    std::vector<std::string> texts(const std::string &name) const;
    std::vector<vec2> pairs(const std::string &name) const;    ///< an array of arrays of two numbers
    std::vector<vec3> vectors(const std::string &name) const;  ///< an array of arrays of three numbers

    Parameters child(const std::string &name) const;                  ///< an object; an empty one if absent
    std::vector<Parameters> children(const std::string &name) const;  ///< an array of objects, empty if absent
    /// The same, where one object stands for an array of it.
    std::vector<Parameters> one_or_more(const std::string &name) const;

    /// Whom to tell how far a file has been read that the object names.
    const ReadProgress &progress() const { return document_->progress; }

    /// Refuses the object where the named value is absent.
    void expect(const std::string &name) const;
    void expect_all_known() const;
    /// `file:line: pointer`, of the named value or of the object itself if the name is empty or absent; for errors that are found later.
    std::string place(const std::string &name) const;
    /// `file:line: pointer: why`, of the same.
    [[noreturn]] void fail(const std::string &name, const std::string &why) const;
    /// The same of an element of the named array, which must have it.
    [[noreturn]] void fail_element(const std::string &name, std::size_t index, const std::string &why) const;

private:
    const nlohmann::json *find(const std::string &name) const;
    template <class Read> auto read(const std::string &name, Read read_value) const;
    template <class T, class Read> T read_or(const std::string &name, const std::optional<T> &fallback, Read read_value) const;
    std::string pointer_to(const std::string &name) const;
    [[noreturn]] void fail_missing(const std::string &name) const;

    const Document *document_;
    std::string pointer_;
    const nlohmann::json *object_;
    std::shared_ptr<std::set<std::string>> known_ = std::make_shared<std::set<std::string>>();
};

}  // namespace brandung
