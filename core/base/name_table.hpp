#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace myo {

/// Values of an enumeration and their names in files and messages. Adding a value takes one line in the table.
template <class Value, std::size_t N>
struct NameTable {
    struct Entry {
        Value value;
        const char* id;  // name in files and on the command line
    };
    std::array<Entry, N> entries;

    /// Name of a value; empty if the value is not in the table.
    std::string name(Value value) const {
        for (const Entry& entry : entries)
            if (entry.value == value) return entry.id;
        return {};
    }

    /// All names in the order of the table, for messages that list the choices.
    std::vector<std::string> names() const {
        std::vector<std::string> list;
        for (const Entry& entry : entries) list.emplace_back(entry.id);
        return list;
    }

    /// Looks up a value by name. Returns false and leaves `value` unchanged if no entry has this name.
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
