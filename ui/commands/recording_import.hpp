#pragma once

#include <Eigen/Core>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands/scene_marker.hpp"
#include "measurement/recording.hpp"

// A recording on its way to become a trial.

namespace myo::ui::commands {

/// Of files that may be one, in small letters.
inline const std::vector<std::string> recording_endings{".c3d", ".tsv", ".csv", ".txt"};

/// What a person knows of a recording where its file does not say it.
struct ReadingOptions {
    std::optional<double> metres_per_unit;  // empty: as the file says
    double rate_Hz = 0.0;                   // 0: as the file says
    bool zero_is_occluded = false;          // 0, 0, 0 stands for a gap

    bool operator==(const ReadingOptions&) const = default;
};

/// What a file holds, in the cameras' frame.
struct RecordingFile {
    std::filesystem::path path;
    std::string format;      // "C3D"
    bool asks_unit = false;  // the file has none
    bool asks_rate = false;
    ReadingOptions reading;                                   // with which it was read
    std::shared_ptr<const measurement::Recording> recording;  // never null
    std::vector<double> seen;                                 // per label, share of the samples
    std::optional<double> start_s;                            // of the first large motion, in the file's time
    std::string start_message;                                // one sentence about it
};

/// Which marker a label of the recording is.
struct ImportedMarker {
    std::string name;                       // empty: left out
    std::optional<Eigen::Vector3d> rest_m;  // where it was placed by hand, on a body without declared markers

    bool operator==(const ImportedMarker&) const = default;
};

struct ImportChoices {
    std::array<int, 3> axes{1, 2, 3};  // the body's x, y, z points along this axis of the cameras; negative: against it
    bool turns = true;                 // the markers at rest turn and shift the recording; else they shift it only
    std::vector<ImportedMarker> markers;  // per label
    double start_s = 0.0;                 // time in the file that becomes t = 0
    bool fit = true;                      // the trial's role; else it is predicted
    bool straight = true;                 // how it begins; else at rest under its loads
    std::string trial;                    // its name
    std::filesystem::path folder;         // of the experiment; empty: the one that is open

    bool operator==(const ImportChoices&) const = default;
};

/// What follows from them.
struct ImportView {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  // cameras -> body
    Eigen::Vector3d translation_m = Eigen::Vector3d::Zero();
    Eigen::Matrix3Xd before_m;   // 3 x labels: places before the start, in the body's frame; NaN = not seen
    Eigen::Matrix3Xd target_m;   // 3 x labels: where the marker sits at rest; NaN = not known
    Eigen::VectorXd residual_m;  // per label, distance of the two; NaN = not known
    double rms_m = 0.0;          // NaN without any
    std::string placed_by;       // "turned and shifted by 5 markers"
    std::string problem;         // why it cannot become a trial yet; empty: it can
};

/// A label as the name of a marker: letters, digits, - and _ only.
std::string marker_name(const std::string& label);

/// Makes a label the declared marker of this name, which belongs to one label at a time.
void assign_marker(ImportChoices& choices, std::size_t label, const std::string& declared);

struct RecordingImport {
    RecordingFile file;
    ImportChoices choices;
    ImportView view;
    std::vector<SceneMarker> declared;  // markers of the experiment; a plain mesh has none
    int label = 0;                      // the chosen one
    bool placing = false;  // a click says which declared marker the chosen one is, or where it sits on a plain mesh
};

}  // namespace myo::ui::commands
