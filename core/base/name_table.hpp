#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace myo {

/// The values of an enumeration with the names a person writes them by: one line each registers a value.
template <class Value, std::size_t N>
struct NameTable {
    struct Entry {
        Value value;
        const char* id;
    };
    std::array<Entry, N> entries;

    /// The value's name; empty for a value that is not registered.
    std::string name(Value value) const {
        for (const Entry& entry : entries)
            if (entry.value == value) return entry.id;
        return {};
    }

    std::vector<std::string> names() const {
        std::vector<std::string> list;
        for (const Entry& entry : entries) list.emplace_back(entry.id);
        return list;
    }

    /// False, and `value` untouched, when no value has this name.
    bool find(const std::string& id, Value& value) const {
        for (const Entry& entry : entries)
            if (entry.id == id) {
                value = entry.value;
                return true;
            }
        return false;
    }
};

}  // namespace myo
