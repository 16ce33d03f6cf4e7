#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

namespace myo {

/// Hash of lists of numbers and of texts, computed from their bits.
///
/// Reproducible between runs and between machines of the same byte order. All NaN hash to one value.
/// Source: FNV-1a (Fowler, Noll, Vo).
class Fingerprint {
public:
    /// Appends `count` numbers to the hashed sequence.
    void add(const double* values, std::ptrdiff_t count) {
        for (std::ptrdiff_t k = 0; k < count; ++k) {
            const double value = std::isnan(values[k]) ? std::numeric_limits<double>::quiet_NaN() : values[k];
            const auto* const bytes = reinterpret_cast<const unsigned char*>(&value);
            for (std::size_t i = 0; i < sizeof value; ++i) hash_ = (hash_ ^ bytes[i]) * 1099511628211u;
        }
    }
    void add(double value) { add(&value, 1); }
    /// Appends a text and its length, so that parts of texts cannot move from one to the next.
    void add_text(std::string_view text) {
        for (const char c : text) hash_ = (hash_ ^ static_cast<unsigned char>(c)) * 1099511628211u;
        add(static_cast<double>(text.size()));
    }
    /// Appends the entries of a dense matrix of doubles in storage order.
    template <class Matrix>
    void add_all(const Matrix& values) {
        add(values.data(), values.size());
    }

    std::uint64_t value() const { return hash_; }

private:
    // The offset basis of FNV-1a without its last digit: any start serves, and stored fingerprints were made with this.
    std::uint64_t hash_ = 1469598103934665603u;
};

}  // namespace myo
