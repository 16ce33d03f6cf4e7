#pragma once

#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace myo::test {

/// Reads markup the way an XML parser would and tells the first thing that is wrong; empty when it is well formed.
/// Covers what the reports use: elements, quoted attributes, the five entities and one doctype.
inline std::string markup_fault(std::string_view text) {
    std::vector<std::string> open;
    std::size_t i = 0;
    const auto at = [&](const std::string& what) { return what + " at byte " + std::to_string(i); };
    const auto entity_ok = [&](std::size_t from) {
        for (const std::string_view known : {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"})
            if (text.substr(from, known.size()) == known) return true;
        return false;
    };
    const auto name_end = [&](std::size_t from) {
        while (from < text.size() &&
               (std::isalnum(static_cast<unsigned char>(text[from])) || text[from] == '-' || text[from] == ':'))
            ++from;
        return from;
    };
    bool root_closed = false;
    while (i < text.size()) {
        const auto byte = static_cast<unsigned char>(text[i]);
        if (byte < 0x20 && text[i] != '\n' && text[i] != '\t' && text[i] != '\r') return at("control character");
        if (text[i] == '&' && !entity_ok(i)) return at("bare ampersand");
        if (text[i] != '<') {
            if (open.empty() && !std::isspace(byte)) return at("text outside the root");
            ++i;
            continue;
        }
        if (text.substr(i, 9) == "<!DOCTYPE") {
            i = text.find('>', i) + 1;
            continue;
        }
        if (text[i + 1] == '/') {
            const std::size_t end = name_end(i + 2);
            const std::string name(text.substr(i + 2, end - i - 2));
            if (open.empty() || open.back() != name) return at("</" + name + "> closes nothing");
            if (text[end] != '>') return at("broken end tag");
            open.pop_back();
            root_closed = open.empty();
            i = end + 1;
            continue;
        }
        if (root_closed) return at("second root");
        std::size_t end = name_end(i + 1);
        if (end == i + 1) return at("bare <");
        const std::string name(text.substr(i + 1, end - i - 1));
        std::vector<std::string> seen;
        while (end < text.size() && text[end] == ' ') {
            const std::size_t key = end + 1, key_end = name_end(key);
            const std::string attribute(text.substr(key, key_end - key));
            for (const std::string& other : seen)
                if (other == attribute) return at("attribute " + attribute + " twice in " + name);
            seen.push_back(attribute);
            if (text.substr(key_end, 2) != "=\"") return at("attribute without a quoted value in " + name);
            end = key_end + 2;
            for (; end < text.size() && text[end] != '"'; ++end) {
                if (text[end] == '<') return at("< in an attribute");
                if (text[end] == '&' && !entity_ok(end)) return at("bare ampersand in an attribute");
            }
            ++end;
        }
        if (text.substr(end, 2) == "/>") {
            i = end + 2;
        } else if (end < text.size() && text[end] == '>') {
            open.push_back(name);
            i = end + 1;
        } else {
            return at("broken tag " + name);
        }
    }
    return open.empty() ? std::string{} : "<" + open.back() + "> is not closed";
}

/// Whether a number in the text is not one (nan, inf in a place of numbers).
inline bool holds_non_number(const std::string& svg) {
    for (const char* bad : {"nan", "NaN", "inf\"", "inf ", "-inf", "Infinity"})
        if (svg.find(bad) != std::string::npos) return true;
    return false;
}

inline int count_of(std::string_view text, std::string_view what) {
    int count = 0;
    for (std::size_t i = text.find(what); i != std::string_view::npos; i = text.find(what, i + what.size())) ++count;
    return count;
}

}  // namespace myo::test
