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

// Import of a motion capture recording as a trial.

namespace myo::ui::commands {

/// What the user adds where the file does not say it.
struct ReadingOptions {
    std::optional<double> metres_per_unit;  // empty: as in the file, or not chosen yet if the file has none
    double rate_Hz = 0.0;                   // sample rate; 0: as in the file
    bool zero_is_occluded = false;          // the position (0, 0, 0) means that the marker was not seen

    bool operator==(const ReadingOptions&) const = default;
};

/// Content of a motion capture file, in the cameras' frame.
struct RecordingFile {
    std::filesystem::path path;
    std::string format;                                       // for display: "C3D"
    bool asks_unit = false;                                   // the file has no length unit
    bool asks_rate = false;                                   // the file has no sample rate
    ReadingOptions reading;                                   // options that it was read with
    std::shared_ptr<const measurement::Recording> recording;  // never null
    std::vector<double> seen;       // per label, share of the samples in which it was seen, 0 to 1
    std::optional<double> start_s;  // first large motion, in the file's time; empty: none found
    std::string start_message;      // how start_s was found, one sentence
};

/// Assignment of a label of the recording to a marker.
struct ImportedMarker {
    std::string name;                       // empty: the label is not imported
    std::optional<Eigen::Vector3d> rest_m;  // position picked by the user, on a body without declared markers

    bool operator==(const ImportedMarker&) const = default;
};

/// All decisions of the user in the import.
struct ImportChoices {
    // camera axis (1, 2, 3 = x, y, z) that the body's x, y, z point along; negative: opposite
    std::array<int, 3> axes{1, 2, 3};
    bool turns = true;  // the markers at rest determine rotation and translation; otherwise only the translation
    std::vector<ImportedMarker> markers;  // per label
    double start_s = 0.0;                 // time in the file that becomes t = 0
    bool fit = true;                      // role fit; otherwise validate
    bool straight = true;                 // starts in the straight rest shape; otherwise in equilibrium under its loads
    std::string trial;                    // name of the new trial
    std::filesystem::path folder;         // of the experiment; empty: the open experiment

    bool operator==(const ImportChoices&) const = default;
};

/// Consequences of the choices, computed by the backend.
struct ImportView {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();   // cameras' frame to body frame
    Eigen::Vector3d translation_m = Eigen::Vector3d::Zero();  // added after the rotation
    Eigen::Matrix3Xd before_m;   // 3 x labels: mean positions before the start, body frame; NaN = not seen
    Eigen::Matrix3Xd target_m;   // 3 x labels: marker positions at rest; NaN = unknown
    Eigen::VectorXd residual_m;  // per label, distance of the two [m]; NaN = unknown
    double rms_m = 0.0;          // of all distances; NaN without any
    std::string placed_by;       // how the frame was found: "turned and shifted by 5 markers"
    std::string problem;         // why the trial cannot be added yet; empty: it can
};

/// Converts a label to a marker name: letters, digits, - and _ only; other characters become _, except next to a -.
std::string marker_name(const std::string& label);

/// Assigns the declared marker of this name to a label, and removes it from any other label.
void assign_marker(ImportChoices& choices, std::size_t label, const std::string& declared);

/// An import in progress. Replaced as a whole by each change.
struct RecordingImport {
    RecordingFile file;                 // as it was read
    ImportChoices choices;              // of the user so far
    ImportView view;                    // that follows from both
    std::vector<SceneMarker> declared;  // markers of the experiment; empty for a plain mesh
    int label = 0;                      // index of the selected label
    // a click in the view assigns the selected label to a declared marker, or places it on a plain mesh
    bool placing = false;
};

}  // namespace myo::ui::commands
