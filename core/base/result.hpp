#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace myo {

/// Bad input, told to a person: one clear sentence, and where it stands (file and line, or key).
struct Error {
    std::string what;
    std::string where;

    /// "where: what", or only "what" when no place is known.
    std::string text() const { return where.empty() ? what : where + ": " + what; }
};

/// A value, or the reason why there is none. Spelled like std::expected, which GCC 12 lacks in C++20.
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

/// Success without a value.
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
