#pragma once

#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include "base/result.hpp"

namespace myo::mesh {

/// Splits a text into blank-separated words and tracks the line number for messages.
class TextScanner {
public:
    /// @param text  must outlive the scanner
    /// @param path  named in errors
    TextScanner(std::string_view text, std::string path) : text_(text), path_(std::move(path)) {}

    /// Next word on any line; empty at the end of the text.
    std::string_view word() {
        while (at_ < text_.size() && blank(text_[at_])) step();
        return take();
    }
    /// Next word on the current line; empty at its end.
    std::string_view word_on_line() {
        while (at_ < text_.size() && text_[at_] != '\n' && blank(text_[at_])) ++at_;
        return take();
    }
    /// Skips the rest of the line. Returns false at the end of the text.
    bool next_line() {
        while (at_ < text_.size() && text_[at_] != '\n') ++at_;
        if (at_ >= text_.size()) return false;
        step();
        return true;
    }
    /// True if only blanks are left; skips them.
    bool at_end() {
        while (at_ < text_.size() && blank(text_[at_])) step();
        return at_ >= text_.size();
    }

    /// Next word as a finite number; false otherwise.
    bool number(double& value) { return parse(word(), value) && std::isfinite(value); }
    /// Next word on the current line as a finite number; false otherwise.
    bool number_on_line(double& value) { return parse(word_on_line(), value) && std::isfinite(value); }
    /// Next word as an integer; false otherwise.
    bool integer(long long& value) { return parse(word(), value); }
    /// Next word on the current line as an integer; false otherwise.
    bool integer_on_line(long long& value) { return parse(word_on_line(), value); }

    /// Parses a complete word; independent of the locale.
    template <class T>
    static bool parse(std::string_view word, T& value) {
        if (!word.empty() && word.front() == '+') word.remove_prefix(1);
        const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
        return !word.empty() && code == std::errc{} && end == word.data() + word.size();
    }

    /// Current line, from 1.
    int line() const { return line_; }
    /// Length of the text in bytes, an upper bound of any count in the file.
    std::size_t size() const { return text_.size(); }
    /// Error at the current line.
    Error error(std::string what) const { return {std::move(what), path_ + ":" + std::to_string(line_)}; }

private:
    static bool blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v'; }
    /// Advances by one character and counts lines.
    void step() {
        if (text_[at_] == '\n') ++line_;
        ++at_;
    }
    /// Word at the current position.
    std::string_view take() {
        const std::size_t begin = at_;
        while (at_ < text_.size() && !blank(text_[at_])) ++at_;
        return text_.substr(begin, at_ - begin);
    }

    std::string_view text_;
    std::string path_;
    std::size_t at_ = 0;
    int line_ = 1;
};

}  // namespace myo::mesh
