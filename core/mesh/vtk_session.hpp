#pragma once

#include <mutex>
#include <string>

namespace myo::mesh {

/// Suppresses VTK's messages in its scope and records whether there were any.
///
/// VTK reports through one output window per process, so only one session exists at a time; others wait. Include this
/// only in .cpp files that call VTK.
class VtkSession {
public:
    VtkSession();
    ~VtkSession();
    VtkSession(const VtkSession&) = delete;
    VtkSession& operator=(const VtkSession&) = delete;

    /// True if VTK reported an error or warning in this session.
    bool complained() const;

private:
    struct Window;
    std::unique_lock<std::mutex> lock_;
    Window* window_ = nullptr;    // installed window
    void* previous_ = nullptr;    // window to be restored
    int previous_verbosity_ = 0;  // log level to be restored
};

}  // namespace myo::mesh
