#include "scene/spelling.h"

#include <algorithm>
#include <numeric>

namespace brandung {
namespace {

/// Letters to insert, delete or exchange to come from one to the other (Levenshtein 1966).
std::size_t letters_between(const std::string &a, const std::string &b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0]++;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t exchanged = diagonal + (a[i] != b[j]);
            diagonal = row[j + 1];
            row[j + 1] = std::min({exchanged, row[j] + 1, diagonal + 1});
        }
    }
    return row.back();
}

}  // namespace

bool resembles(const std::string &word, const std::string &name) {
    return letters_between(word, name) <= std::min<std::size_t>({2, word.size() / 2, name.size() / 2});
}

std::vector<std::string> by_likeness(const std::string &word, std::vector<std::string> names) {
    const auto is_nearer = [&](const std::string &a, const std::string &b) { return letters_between(word, a) < letters_between(word, b); };
    std::stable_sort(names.begin(), names.end(), is_nearer);
    return names;
}

}  // namespace brandung
