#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "measurement/recording.hpp"

namespace myo::test {

enum class Processor { intel = 84, dec = 85, sgi = 86 };

/// How a test wants its C3D file; the defaults give a plain, valid one.
struct C3dOptions {
    Processor processor = Processor::intel;
    bool real = true;
    double scale = 1e-4;      // always positive here; written negative for float data
    std::string units = "m";  // empty = no POINT:UNITS
    double units_per_metre = 1.0;
    bool labels = true;
    int analog_channels = -1;  // -1 = no ANALOG group, 0 = a group that says 0
    int analog_per_frame = 1;  // samples of each channel per frame
    int parameter_block = 2;
    int spare_blocks = 0;              // between parameters and data
    std::string frames_as = "FRAMES";  // "FRAMES", "FRAMES real", "LONG_FRAMES", "TRIAL", "header"
    bool header_rate_only = false;
    bool groups_last = false;                   // group records behind the parameters that belong to them
    int residual_steps = 5;                     // fourth word of seen samples
    double occluded_word = -1.0;                // fourth word of occluded samples
    int more_frames = 0;                        // that POINT:FRAMES counts beyond the header
    bool end_mark = true;                       // false: the last record points on, and other bytes follow in its block
    std::vector<std::string> angles = {};       // named in POINT:ANGLES
    std::vector<std::string> own_outputs = {};  // named in POINT:LOADS, which POINT:TYPE_GROUPS names
};

/// Writes numbers as one of the three machines does.
class C3dBytes {
public:
    explicit C3dBytes(Processor processor) : processor_(processor) {}

    std::string bytes;

    void byte(int value) { bytes += static_cast<char>(value & 0xFF); }
    void word(int value) {
        const bool big = processor_ == Processor::sgi;
        byte(big ? value >> 8 : value);
        byte(big ? value : value >> 8);
    }
    void real(double value) {
        const std::uint32_t pattern = processor_ == Processor::dec
                                          ? vax(value)
                                          : std::bit_cast<std::uint32_t>(static_cast<float>(value));
        const int high = static_cast<int>(pattern >> 16U);
        const int low = static_cast<int>(pattern & 0xFFFFU);
        const bool high_first = processor_ != Processor::intel;
        word(high_first ? high : low);
        word(high_first ? low : high);
    }
    void text(const std::string& value) { bytes += value; }
    void pad(std::size_t size) { bytes.resize(size, '\0'); }

private:
    static std::uint32_t vax(double value) {
        if (value == 0.0) return 0;
        int exponent = 0;
        const double mantissa = std::frexp(std::abs(static_cast<double>(static_cast<float>(value))), &exponent);
        const auto digits = static_cast<std::uint32_t>(std::ldexp(mantissa, 24));
        return (value < 0.0 ? 0x80000000U : 0U) | static_cast<std::uint32_t>(exponent + 128) << 23U |
               (digits & 0x7FFFFFU);
    }

    Processor processor_;
};

class C3dParameterWriter {
public:
    explicit C3dParameterWriter(Processor processor) : out_(processor), processor_(processor) {}

    void group(int id, const std::string& name) {
        C3dBytes body(processor_);
        body.byte(0);
        record(-id, name, body.bytes);
    }
    void words(int id, const std::string& name, const std::vector<int>& values, bool scalar) {
        C3dBytes body(processor_);
        dimensions(body, 2, scalar, static_cast<int>(values.size()));
        for (const int value : values) body.word(value);
        body.byte(0);
        record(id, name, body.bytes);
    }
    void real(int id, const std::string& name, double value) {
        C3dBytes body(processor_);
        dimensions(body, 4, true, 1);
        body.real(value);
        body.byte(0);
        record(id, name, body.bytes);
    }
    void texts(int id, const std::string& name, const std::vector<std::string>& values, int length) {
        C3dBytes body(processor_);
        body.byte(-1);
        body.byte(2);
        body.byte(length);
        body.byte(static_cast<int>(values.size()));
        for (std::string value : values) {
            value.resize(static_cast<std::size_t>(length), ' ');
            body.text(value);
        }
        body.byte(0);
        record(id, name, body.bytes);
    }
    std::string records() const { return out_.bytes; }
    std::string finish() {
        out_.byte(0);
        out_.byte(0);
        return out_.bytes;
    }

private:
    static void dimensions(C3dBytes& body, int type, bool scalar, int count) {
        body.byte(type);
        body.byte(scalar ? 0 : 1);
        if (!scalar) body.byte(count);
    }
    void record(int id, const std::string& name, const std::string& body) {
        out_.byte(static_cast<int>(name.size()));
        out_.byte(id);
        out_.text(name);
        out_.word(static_cast<int>(body.size()) + 2);
        out_.text(body);
    }

    C3dBytes out_;
    Processor processor_;
};

inline std::string c3d_parameter_section(const measurement::Recording& recording, const C3dOptions& options,
                                         int data_block) {
    const int points = static_cast<int>(recording.labels.size());
    const int frames = static_cast<int>(recording.sample_count());
    C3dParameterWriter writer(options.processor);
    const auto groups = [&] {
        writer.group(1, "POINT");
        if (options.analog_channels >= 0) writer.group(2, "ANALOG");
        if (options.frames_as == "TRIAL") writer.group(3, "TRIAL");
    };
    if (!options.groups_last) groups();
    writer.words(1, "USED", {points}, true);
    writer.real(1, "SCALE", options.real ? -options.scale : options.scale);
    if (!options.header_rate_only) writer.real(1, "RATE", recording.rate_Hz);
    writer.words(1, "DATA_START", {data_block}, true);
    if (options.frames_as == "FRAMES real")
        writer.real(1, "FRAMES", frames);
    else if (options.frames_as != "header")
        writer.words(1, "FRAMES", {std::min(frames + options.more_frames, 65535)}, true);
    if (options.frames_as == "LONG_FRAMES") writer.real(1, "LONG_FRAMES", frames);
    if (options.frames_as == "TRIAL") {
        writer.words(3, "ACTUAL_START_FIELD", {1, 0}, false);
        writer.words(3, "ACTUAL_END_FIELD", {frames % 65536, frames / 65536}, false);
    }
    if (options.labels) {
        for (std::size_t first = 0, part = 1; first < recording.labels.size(); first += 255, ++part) {
            const auto end = std::min(first + 255, recording.labels.size());
            const std::vector<std::string> names(recording.labels.begin() + static_cast<std::ptrdiff_t>(first),
                                                 recording.labels.begin() + static_cast<std::ptrdiff_t>(end));
            writer.texts(1, part == 1 ? "LABELS" : "LABELS" + std::to_string(part), names, 20);
        }
    }
    if (!options.units.empty()) writer.texts(1, "UNITS", {options.units}, 4);
    if (!options.angles.empty()) writer.texts(1, "ANGLES", options.angles, 20);
    if (!options.own_outputs.empty()) {
        writer.texts(1, "LOADS", options.own_outputs, 20);
        writer.texts(1, "TYPE_GROUPS", {"LOADS"}, 8);
    }
    if (options.analog_channels >= 0) {
        writer.words(2, "USED", {options.analog_channels}, true);
        writer.real(2, "RATE", recording.rate_Hz * options.analog_per_frame);
    }
    if (options.groups_last) groups();
    return options.end_mark ? writer.finish() : writer.records();
}

/// The bytes of a C3D file that holds the recording.
inline std::string c3d_file(const measurement::Recording& recording, const C3dOptions& options = {}) {
    constexpr std::size_t block = 512;
    const int points = static_cast<int>(recording.labels.size());
    const int frames = static_cast<int>(recording.sample_count());
    const int analog = std::max(options.analog_channels, 0) * options.analog_per_frame;
    const std::size_t section = c3d_parameter_section(recording, options, 1).size() + 4;
    const int section_blocks = static_cast<int>((section + block - 1) / block);
    const int data_block = options.parameter_block + section_blocks + options.spare_blocks;

    C3dBytes out(options.processor);
    out.byte(options.parameter_block);
    out.byte(0x50);
    out.word(points);
    out.word(analog);
    out.word(1);
    out.word(std::min(frames, 65535));
    out.word(10);
    out.real(options.real ? -options.scale : options.scale);
    out.word(data_block);
    out.word(options.analog_channels > 0 ? options.analog_per_frame : 0);
    out.real(recording.rate_Hz);
    out.pad(block * static_cast<std::size_t>(options.parameter_block - 1));
    out.byte(1);
    out.byte(0x50);
    out.byte(section_blocks);
    out.byte(static_cast<int>(options.processor));
    out.text(c3d_parameter_section(recording, options, data_block));
    if (!options.end_mark) out.bytes.resize(block * static_cast<std::size_t>(data_block - 1), '\7');
    out.pad(block * static_cast<std::size_t>(data_block - 1));

    const auto number = [&](double value) {
        if (options.real)
            out.real(value);
        else
            out.word(static_cast<int>(std::lround(value)));
    };
    for (Eigen::Index t = 0; t < frames; ++t) {
        for (const Eigen::Matrix3Xd& track : recording.tracks) {
            const bool seen = track.col(t).allFinite();
            for (Eigen::Index axis = 0; axis < 3; ++axis) {
                const double value = seen ? track(axis, t) * options.units_per_metre : 0.0;
                number(options.real ? value : value / options.scale);
            }
            number(seen ? options.residual_steps : options.occluded_word);
        }
        for (int k = 0; k < analog; ++k) number(-1000.0 - k);
    }
    out.pad((out.bytes.size() + block - 1) / block * block);
    return out.bytes;
}

}  // namespace myo::test
