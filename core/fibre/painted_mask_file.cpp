#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.hpp"
#include "base/text.hpp"
#include "fibre/painted_mask.hpp"

namespace myo::fibre {
namespace {

constexpr std::string_view header = "x_m,y_m,z_m,weight,fibre_x,fibre_y,fibre_z";
constexpr std::string_view size_words = "# cell_size_m,";
struct PaintedMaskFileFormat {
    std::size_t columns = 7;
};
constexpr PaintedMaskFileFormat painted_mask_file_format;

using Row = std::array<double, painted_mask_file_format.columns>;

/// Parses and validates one row; the direction is normalised exactly.
Result<Row> read_row(std::string_view line, const std::string& where) {
    Row row{};
    std::size_t count = 1;
    for (const char c : line) count += c == ',' ? 1u : 0u;
    if (count != painted_mask_file_format.columns)
        return Error{"has " + std::to_string(count) + " fields, expected " +
                         std::to_string(painted_mask_file_format.columns) + " (" + std::string(header) + ")",
                     where};
    for (std::size_t i = 0; i < painted_mask_file_format.columns; ++i) {
        const std::size_t comma = std::min(line.find(','), line.size());
        if (!parse_number(line.substr(0, comma), row[i]) || !std::isfinite(row[i]))
            return Error{"field " + std::to_string(i + 1) + " is '" + std::string(line.substr(0, comma)) +
                             "', expected a number",
                         where};
        line.remove_prefix(std::min(comma + 1, line.size()));
    }
    if (row[3] < 0.0 || row[3] > 1.0)
        return Error{"the weight is " + format_number(row[3]) + ", expected 0 to 1", where};
    const double length = std::hypot(row[4], row[5], row[6]);
    if (row[3] > 0.0 && !(std::abs(length - 1.0) <= 0.01))
        return Error{"the fibre must be a unit vector, not one of length " + format_number(length, 4), where};
    for (std::size_t i = 4; i < painted_mask_file_format.columns; ++i) row[i] = row[3] > 0.0 ? row[i] / length : 0.0;
    return row;
}

PaintedMask mask_of(const std::vector<Row>& rows, double cell_size_m) {
    const auto count = static_cast<Eigen::Index>(rows.size());
    PaintedMask mask{cell_size_m, Eigen::Matrix3Xd(3, count), Eigen::VectorXd(count), Eigen::Matrix3Xd(3, count)};
    for (Eigen::Index i = 0; i < count; ++i) {
        const Row& row = rows[static_cast<std::size_t>(i)];
        mask.centroids_m.col(i) << row[0], row[1], row[2];
        mask.weights(i) = row[3];
        mask.directions.col(i) << row[4], row[5], row[6];
    }
    return mask;
}

}  // namespace

Result<void> write_painted_mask(const std::filesystem::path& path, const PaintedMask& mask) {
    std::string
        text = "# painted muscle: rest frame, m; weight 0 to 1, 0 for unpainted neighbours; fibre a unit vector\n";
    text += std::string(size_words) + format_number(mask.cell_size_m, 17) + "\n" + std::string(header) + "\n";
    for (Eigen::Index i = 0; i < mask.count(); ++i) {
        const Eigen::Vector3d x = mask.centroids_m.col(i), m = mask.directions.col(i);
        const Row row{x(0), x(1), x(2), mask.weights(i), m(0), m(1), m(2)};
        for (std::size_t k = 0; k < painted_mask_file_format.columns; ++k)
            text += (k > 0 ? "," : "") + format_number(row[k], 17);
        text += '\n';
    }
    return write_file(path, text);
}

Result<PaintedMask> read_painted_mask(const std::filesystem::path& path) {
    const Result<std::string> content = read_file(path);
    if (!content) return content.error();
    double cell_size_m = 0.0;
    bool has_header = false, painted = false;
    std::vector<Row> rows;
    int number = 0;
    for (std::string_view rest = *content; !rest.empty();) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        std::string_view line = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
        const std::string where = path.string() + ":" + std::to_string(++number);
        if (line.starts_with(size_words)) {
            if (!parse_number(line.substr(size_words.size()), cell_size_m) || !(cell_size_m > 0.0))
                return Error{"the cell size is '" + std::string(line.substr(size_words.size())) +
                                 "', expected a positive number [m]",
                             where};
        } else if (line.empty() || line.front() == '#') {
            continue;
        } else if (!has_header) {
            if (line != header)
                return Error{
                    "begins with '" + std::string(line.substr(0, 60)) + "', expected the header " + std::string(header),
                    where};
            has_header = true;
        } else {
            const Result<Row> row = read_row(line, where);
            if (!row) return row.error();
            painted = painted || (*row)[3] > 0.0;
            rows.push_back(*row);
        }
    }
    if (!has_header) return Error{"is empty, expected the header " + std::string(header), path.string() + ":1"};
    if (!(cell_size_m > 0.0))
        return Error{"does not say the cell size, expected a line '" + std::string(size_words) + "0.005'",
                     path.string()};
    if (!painted) return Error{"has no element of a weight above 0", path.string()};
    return mask_of(rows, cell_size_m);
}

}  // namespace myo::fibre
