#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace myo {

/// Description of bad input for the user.
struct Error {
    std::string what;   // one sentence
    std::string where;  // file and line, or key; may be empty

    /// "where: what"; only "what" if the location is unknown.
    std::string text() const { return where.empty() ? what : where + ": " + what; }
};

/// A value, or the error that explains its absence. Interface of std::expected, which GCC 12 lacks in C++20.
///
/// value() and operator* assert has_value(); error() asserts the opposite.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : content_(std::move(value)) {}
    Result(Error error) : content_(std::move(error)) {}

    bool has_value() const { return content_.index() == 0; }
    explicit operator bool() const { return has_value(); }

    const T& value() const& {
        assert(has_value());
        return std::get<0>(content_);
    }
    T& value() & {
        assert(has_value());
        return std::get<0>(content_);
    }
    T&& value() && {
        assert(has_value());
        return std::get<0>(std::move(content_));
    }
    const Error& error() const {
        assert(!has_value());
        return std::get<1>(content_);
    }

    const T& operator*() const& { return value(); }
    T& operator*() & { return value(); }
    T&& operator*() && { return std::move(*this).value(); }
    const T* operator->() const { return &value(); }
    T* operator->() { return &value(); }

private:
    std::variant<T, Error> content_;
};

/// Success without a value, or an error.
template <>
class [[nodiscard]] Result<void> {
public:
    Result() = default;
    Result(Error error) : error_(std::move(error)), failed_(true) {}

    bool has_value() const { return !failed_; }
    explicit operator bool() const { return has_value(); }
    const Error& error() const {
        assert(failed_);
        return error_;
    }

private:
    Error error_;
    bool failed_ = false;
};

}  // namespace myo
