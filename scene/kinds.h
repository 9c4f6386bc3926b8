/// Families' lists of kinds.
#pragma once
#include <cstring>
#include <string_view>
#include <vector>

#include "kernels/core/portable.h"

namespace brandung {

/// The place in its family's list of the kind called `name`, which must be there.
template <class Kind> uint kind_number(const std::vector<Kind> &kinds, std::string_view name) {
    uint number = 0;
    while (kinds[number].name != name) ++number;
    return number;
}

/// Writes `view`, a kind's own record, into the words that its family's record has for it.
template <class View, class Word, std::size_t count> void write_words(const View &view, Word (&words)[count]) {
    static_assert(sizeof(View) <= sizeof words);
    std::memcpy(words, &view, sizeof view);
}

/// The view that was written into a record's words.
template <class View, class Word, std::size_t count> View view_of(const Word (&words)[count]) {
    static_assert(sizeof(View) <= sizeof words);
    View view;
    std::memcpy(&view, words, sizeof view);
    return view;
}

}  // namespace brandung
