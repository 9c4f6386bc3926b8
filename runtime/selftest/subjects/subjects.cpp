/// The list of subjects.
#include "runtime/selftest/subjects/list.h"

namespace brandung {

const std::vector<SubjectEntry> &subjects() {
    static const std::vector<SubjectEntry> list = [] {
        std::vector<SubjectEntry> entries;
        add_math(entries);
        add_crossings(entries);
        return entries;
    }();
    return list;
}

}  // namespace brandung
