#include "measurement/c3d_reader.hpp"

#include <cmath>
#include <limits>
#include <set>

#include "base/files.hpp"
#include "base/text.hpp"
#include "measurement/c3d_parameters.hpp"
#include "measurement/c3d_words.hpp"
#include "measurement/marker_labels.hpp"
#include "measurement/trace_reader.hpp"
#include "measurement/units.hpp"

namespace myo::measurement {
namespace {

struct C3dReaderFormat {
    /// Ten kilometres: beyond any capture volume, but easily reached in a damaged file.
    double largest_coordinate_m = 1e4;
};
constexpr C3dReaderFormat c3d_reader_format;

// Position and encoding of the samples in the file.
struct Layout {
    std::size_t points = 0;
    std::size_t frames = 0;
    std::size_t analog_per_frame = 0;  // analog values per frame, to be skipped
    std::size_t data_offset = 0;       // from the start of the file [bytes]
    bool real = true;                  // 32-bit floats; else 16-bit integers times `scale`
    double scale = 1.0;                // of integers and of residuals, positive
    double rate_Hz = 0.0;
    double metres_per_unit = 1.0;
    std::vector<std::string> warnings{};

    std::size_t word_size() const { return real ? 4 : 2; }
    // A point has four words: x, y, z, and residual with camera mask.
    std::size_t frame_size() const { return (4 * points + analog_per_frame) * word_size(); }
    std::size_t end() const { return data_offset + frames * frame_size(); }
};

/// Decodes the points of a C3D file. The parameters take precedence over the header.
class Reader {
public:
    Reader(C3dWords words, C3dParameters parameters, std::string file)
        : words_(words), parameters_(std::move(parameters)), file_(std::move(file)) {}

    Result<Recording> read(std::optional<double> unit_override);

private:
    Error failure(const std::string& what) const { return Error{what, file_}; }
    Result<Layout> layout(std::optional<double> unit_override) const;
    Result<double> unit(std::optional<double> unit_override) const;
    double analog_rate_ratio(double rate_Hz) const;
    double frame_count() const;
    bool fills_file(const Layout& layout) const;
    void choose_frames(Layout& layout) const;
    std::set<std::string> model_outputs() const;
    Result<void> choose_counts(Layout& layout) const;
    std::vector<std::string> labels(std::size_t points) const;
    Result<Recording> samples(const Layout& layout) const;

    C3dWords words_;
    C3dParameters parameters_;
    std::string file_;
};

bool usable_count(double value) { return std::isfinite(value) && value >= 1.0 && value < 4294967296.0; }

// Frame count, in order of precedence: LONG_FRAMES, FRAMES, the TRIAL range, the range in the header.
// FRAMES as a 16-bit word holds at most "65535 or more", and some writers store only its low word.
double Reader::frame_count() const {
    const std::optional<double> long_frames = parameters_.number("POINT:LONG_FRAMES");
    if (long_frames && usable_count(*long_frames)) return *long_frames;
    double trial = 0.0;
    // TRIAL fields are 32-bit numbers stored as two 16-bit words.
    const auto long_word = [&](const std::string& name) -> double {
        const std::optional<double> low = parameters_.number(name, 0);
        if (!low) return 0.0;
        return *low + 65536.0 * parameters_.number(name, 1).value_or(0.0);
    };
    if (parameters_.contains("TRIAL:ACTUAL_END_FIELD")) {
        const double first = long_word("TRIAL:ACTUAL_START_FIELD");
        trial = long_word("TRIAL:ACTUAL_END_FIELD") - (first >= 1.0 ? first : 1.0) + 1.0;
    }
    const double frames = parameters_.number("POINT:FRAMES").value_or(0.0);
    const bool word_is_full = parameters_.is_word("POINT:FRAMES") && frames >= 65535.0;
    const bool low_word_only = parameters_.is_word("POINT:FRAMES") && usable_count(trial) && trial > 65535.0 &&
                               std::fmod(trial, 65536.0) == frames;
    // FRAMES is trusted unless it is saturated or equals only the low word of the TRIAL range.
    if (usable_count(frames) && !word_is_full && !low_word_only) return frames;
    if (usable_count(trial)) return trial;
    if (usable_count(frames)) return frames;
    return static_cast<double>(words_.word(8)) - static_cast<double>(words_.word(6)) + 1.0;
}

Result<double> Reader::unit(std::optional<double> unit_override) const {
    const std::vector<std::string> units = parameters_.texts("POINT:UNITS");
    std::string name;
    // Some writers store one string per axis, others one character per string.
    if (!units.empty())
        name = units.size() == 2 && units[0].size() == 1 && units[1].size() == 1 ? units[0] + units[1] : units[0];
    return recording_unit("POINT:UNITS", name, unit_override, file_);
}

double Reader::analog_rate_ratio(double rate_Hz) const {
    const double ratio = parameters_.number("ANALOG:RATE").value_or(0.0) / rate_Hz;
    if (std::isfinite(ratio) && ratio >= 0.5 && ratio < 65536.0) return std::round(ratio);
    return std::max(1.0, static_cast<double>(words_.word(18)));  // header word: analog samples per frame
}

// Whether the samples end within the last block of the file, as they do if the counts are right.
bool Reader::fills_file(const Layout& layout) const {
    return layout.end() <= words_.size() && words_.size() - layout.end() < c3d_format.block_size;
}

// Point and analog counts are stored in the parameters and in the header. The parameters take precedence; if the two
// disagree, the file size must confirm one of them.
Result<void> Reader::choose_counts(Layout& layout) const {
    const auto header_points = static_cast<std::size_t>(words_.word(2));
    const auto header_analog = static_cast<std::size_t>(words_.word(4));
    layout.points = static_cast<std::size_t>(
        parameters_.number("POINT:USED").value_or(static_cast<double>(header_points)));
    layout.analog_per_frame = header_analog;
    if (const std::optional<double> channels = parameters_.number("ANALOG:USED");
        channels && *channels >= 0.0 && *channels < 65536.0) {
        layout.analog_per_frame = static_cast<std::size_t>(*channels * analog_rate_ratio(layout.rate_Hz));
    }
    if (layout.points == header_points && layout.analog_per_frame == header_analog) return {};
    if (fills_file(layout)) return {};
    Layout by_header = layout;
    by_header.points = header_points;
    by_header.analog_per_frame = header_analog;
    if (header_points > 0 && fills_file(by_header)) {
        layout = by_header;
        return {};
    }
    if (layout.points != header_points) {
        return failure("POINT:USED says " + std::to_string(layout.points) + " points, the header (byte 2) " +
                       std::to_string(header_points) + ", and the file size fits neither");
    }
    return failure("the ANALOG group says " + std::to_string(layout.analog_per_frame) +
                   " analog values per frame, the header (byte 4) " + std::to_string(header_analog) +
                   ", and the file size fits neither");
}

/// Why a file of `size` bytes is too short for the layout.
std::string too_short(const Layout& layout, std::size_t size) {
    return "ends at byte " + std::to_string(size) + ", but " + std::to_string(layout.frames) + " frames of " +
           std::to_string(layout.points) + " points from byte " + std::to_string(layout.data_offset) + " need " +
           std::to_string(layout.end()) + " bytes";
}

// Some writers count one frame more in FRAMES than in the header. The header is right if its frames fill the file and
// nothing but padding follows them.
void Reader::choose_frames(Layout& layout) const {
    Layout by_header = layout;
    const int header_frames = static_cast<int>(words_.word(8)) - static_cast<int>(words_.word(6)) + 1;
    if (header_frames < 1 || static_cast<std::size_t>(header_frames) >= layout.frames) return;
    by_header.frames = static_cast<std::size_t>(header_frames);
    if (!fills_file(by_header)) return;
    const std::string_view rest = words_.text(by_header.end(), words_.size() - by_header.end());
    if (layout.end() <= words_.size() && rest.find_first_not_of('\0') != std::string_view::npos) return;
    by_header.warnings.push_back("POINT:FRAMES says " + std::to_string(layout.frames) +
                                 " frames, header and file hold " + std::to_string(by_header.frames) +
                                 ", which are read");
    layout = by_header;
}

/// Labels of points that are no positions: angles, forces and other outputs of a model, in units of their own. The
/// parameters named in TYPE_GROUPS list them; modelled markers are positions.
std::set<std::string> Reader::model_outputs() const {
    std::vector<std::string> groups{"ANGLES", "FORCES", "MOMENTS", "POWERS", "SCALARS", "REACTIONS"};
    for (const std::string& group : parameters_.texts("POINT:TYPE_GROUPS"))
        if (group.find("MARKER") == std::string::npos && group != "LABELS") groups.push_back(group);
    std::set<std::string> outputs;
    for (const std::string& group : groups)
        for (int part = 1;; ++part) {
            const std::vector<std::string> labels = parameters_.texts("POINT:" + group +
                                                                      (part == 1 ? "" : std::to_string(part)));
            if (labels.empty()) break;
            outputs.insert(labels.begin(), labels.end());
        }
    outputs.erase("");
    return outputs;
}

Result<Layout> Reader::layout(std::optional<double> unit_override) const {
    Layout layout;
    const double scale = parameters_.number("POINT:SCALE").value_or(words_.real(12));
    if (!std::isfinite(scale) || scale == 0.0) return failure("POINT:SCALE is not a number other than 0");
    // Format convention: a negative scale means float data.
    layout.real = scale < 0.0;
    layout.scale = std::abs(scale);
    layout.rate_Hz = parameters_.number("POINT:RATE").value_or(0.0);
    // Fall back to the header.
    if (!(layout.rate_Hz > 0.0)) layout.rate_Hz = words_.real(20);
    if (!std::isfinite(layout.rate_Hz) || layout.rate_Hz < 1e-6 || layout.rate_Hz > 1e7)
        return failure("POINT:RATE is no frame rate (" + format_number(layout.rate_Hz) + " Hz)");
    const double frames = frame_count();
    if (!usable_count(frames)) return failure("holds no frames (POINT:FRAMES)");
    layout.frames = static_cast<std::size_t>(frames);
    // DATA_START counts blocks of 512 bytes from 1; block 1 is the header.
    const double header_start = words_.word(16);
    double start = parameters_.number("POINT:DATA_START").value_or(header_start);
    if (!(start >= 2.0)) start = header_start;
    if (!(start >= 2.0)) return failure("POINT:DATA_START is no block behind the header");
    layout.data_offset = (static_cast<std::size_t>(std::min(start, 65535.0)) - 1) * c3d_format.block_size;

    if (Result<void> counts = choose_counts(layout); !counts) return counts.error();
    if (layout.points == 0) return failure("holds no 3D points (POINT:USED is 0)");
    choose_frames(layout);
    if (layout.end() > words_.size()) return failure(too_short(layout, words_.size()));
    const Result<double> unit_m = unit(unit_override);
    if (!unit_m) return unit_m.error();
    layout.metres_per_unit = *unit_m;
    return layout;
}

// Labels of the points, made unique. Long lists continue in LABELS2, LABELS3, ...
std::vector<std::string> Reader::labels(std::size_t points) const {
    std::vector<std::string> result;
    for (int part = 1; result.size() < points; ++part) {
        const std::string name = part == 1 ? "POINT:LABELS" : "POINT:LABELS" + std::to_string(part);
        const std::vector<std::string> more = parameters_.texts(name);
        if (more.empty()) break;
        result.insert(result.end(), more.begin(), more.end());
    }
    result.resize(points);
    for (std::size_t i = 0; i < points; ++i)
        if (result[i].empty()) result[i] = "point " + std::to_string(i + 1);
    make_unique(result);
    return result;
}

/// A recording of the labels, still without positions.
Recording c3d_recording(const Layout& layout, const std::vector<std::string>& labels) {
    const auto frame_count = static_cast<Eigen::Index>(layout.frames);
    Recording recording;
    recording.labels = labels;
    recording.rate_Hz = layout.rate_Hz;
    recording.metres_per_unit = layout.metres_per_unit;
    recording.warnings = layout.warnings;
    recording.time_s.resize(frame_count);
    for (Eigen::Index t = 0; t < frame_count; ++t) recording.time_s(t) = static_cast<double>(t) / layout.rate_Hz;
    recording.tracks.assign(labels.size(), Eigen::Matrix3Xd(3, frame_count));
    recording.residual_m.assign(labels.size(), Eigen::VectorXd(frame_count));
    return recording;
}

Result<Recording> Reader::samples(const Layout& layout) const {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto frame_count = static_cast<Eigen::Index>(layout.frames);
    std::vector<std::string> names = labels(layout.points);
    std::vector<std::size_t> points;
    const std::set<std::string> outputs = model_outputs();
    for (std::size_t point = 0; point < names.size(); ++point)
        if (outputs.count(names[point]) == 0) points.push_back(point);
    if (points.empty()) return failure("holds outputs of a model only, no measured points");
    for (std::size_t i = 0; i < points.size(); ++i) names[i] = names[points[i]];
    names.resize(points.size());
    Recording recording = c3d_recording(layout, names);
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (Eigen::Index t = 0; t < frame_count; ++t) {
            const std::size_t at = layout.data_offset + static_cast<std::size_t>(t) * layout.frame_size() +
                                   4 * points[i] * layout.word_size();
            Eigen::Vector3d position;
            for (Eigen::Index axis = 0; axis < 3; ++axis) {
                const std::size_t offset = at + static_cast<std::size_t>(axis) * layout.word_size();
                position(axis) = layout.real ? words_.real(offset) : layout.scale * words_.signed_word(offset);
            }
            const double fourth = layout.real ? words_.real(at + 12) : static_cast<double>(words_.signed_word(at + 6));
            // See read_c3d() for the occlusion rules.
            const bool occluded = !(fourth >= 0.0) || position.hasNaN() || (fourth == 0.0 && position.isZero(0.0));
            position *= layout.metres_per_unit;
            if (!occluded && !(position.cwiseAbs().maxCoeff() <= c3d_reader_format.largest_coordinate_m)) {
                return failure("'" + recording.labels[i] + "' is more than 10 km away in frame " +
                               std::to_string(t + 1) + " (byte " + std::to_string(at) +
                               "); the file is damaged or its unit wrong");
            }
            // The low byte of the fourth word is the residual in units of the scale, in float files as well.
            const double steps = std::fmod(std::trunc(fourth), 256.0);
            recording.tracks[i].col(t) = occluded ? Eigen::Vector3d::Constant(nan) : position;
            recording.residual_m[i](t) = occluded ? nan : steps * layout.scale * layout.metres_per_unit;
        }
    }
    return recording;
}

Result<Recording> Reader::read(std::optional<double> unit_override) {
    const Result<Layout> found = layout(unit_override);
    if (!found) return found.error();
    return samples(*found);
}

/// Byte where the parameter section starts, by the header of the file.
Result<std::size_t> parameters_start_of(std::string_view bytes, const std::string& file) {
    if (bytes.size() < c3d_format.block_size) {
        return Error{"is no C3D file: " + std::to_string(bytes.size()) + " bytes are too few for its header of 512",
                     file};
    }
    const auto byte_at = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    if (byte_at(1) != 0x50) {
        return Error{"is no C3D file: byte 1 is " + std::to_string(int{byte_at(1)}) + ", not the format's mark 80",
                     file};
    }
    const std::size_t parameters_block = byte_at(0);
    if (parameters_block < 2) return Error{"is damaged: byte 0 of the header points to no parameter section", file};
    const std::size_t parameters_start = (parameters_block - 1) * c3d_format.block_size;
    if (parameters_start + 4 > bytes.size()) {
        return Error{"is cut off: the parameter section should start at byte " + std::to_string(parameters_start) +
                         ", the file ends at byte " + std::to_string(bytes.size()),
                     file};
    }
    return parameters_start;
}

}  // namespace

Result<Recording> read_c3d(const std::filesystem::path& path, std::optional<double> metres_per_unit) {
    const std::string file = path.string();
    const Result<std::string> content = read_file(path);
    if (!content) return content.error();
    const std::string_view bytes = *content;
    const Result<std::size_t> start = parameters_start_of(bytes, file);
    if (!start) return start.error();
    const std::size_t parameters_start = *start;
    const int code = static_cast<unsigned char>(bytes[parameters_start + 3]);
    const std::optional<C3dProcessor> processor = c3d_processor(static_cast<unsigned char>(code));
    if (!processor)
        return Error{"has the unknown processor code " + std::to_string(code) + " at byte " +
                         std::to_string(parameters_start + 3) + " (84 Intel, 85 DEC and 86 SGI are known)",
                     file};
    const C3dWords words(bytes, *processor);
    Result<C3dParameters> parameters = read_c3d_parameters(words, parameters_start, file);
    if (!parameters) return parameters.error();
    return Reader(words, std::move(*parameters), file).read(metres_per_unit);
}

TraceReader c3d_reader() {
    return {.id = "c3d",
            .label = "C3D",
            .endings = {".c3d"},
            .signature = "a binary file",
            .of_cameras = true,
            .with_other_markers = true,
            .may_lack_unit = true,
            .recognise = [](std::string_view content) -> std::optional<TraceSource> {
                // The number of the parameter block, then the byte 0x50; the header alone is 512 bytes long.
                if (content.size() <= 512 || static_cast<unsigned char>(content[1]) != 0x50) return std::nullopt;
                return TraceSource{.format = "c3d"};
            },
            .read = [](const std::filesystem::path& path,
                       const TraceSource& source) { return read_c3d(path, source.metres_per_unit); }};
}

}  // namespace myo::measurement
