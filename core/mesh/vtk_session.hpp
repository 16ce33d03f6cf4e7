#pragma once

#include <mutex>
#include <string>

namespace myo::mesh {

/// Keeps VTK's messages off the screen while a reader or writer of it works, and collects them.
///
/// VTK reports through one output window for the whole process, so sessions exclude one another. Only .cpp files that
/// call VTK include this.
class VtkSession {
public:
    VtkSession();
    ~VtkSession();
    VtkSession(const VtkSession&) = delete;
    VtkSession& operator=(const VtkSession&) = delete;

    /// Whether VTK has complained so far.
    bool complained() const;

private:
    struct Window;
    std::unique_lock<std::mutex> lock_;
    Window* window_ = nullptr;
    void* previous_ = nullptr;
    int previous_verbosity_ = 0;
};

}  // namespace myo::mesh
