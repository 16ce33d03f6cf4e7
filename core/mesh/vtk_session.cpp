#include "mesh/vtk_session.hpp"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

namespace myo::mesh {
namespace {

/// Lock of the one output window of the process.
std::mutex& one_at_a_time() {
    static std::mutex mutex;
    return mutex;
}

}  // namespace

/// Output window that only records that a message arrived.
struct VtkSession::Window : vtkOutputWindow {
    static Window* make() {
        auto* window = new Window;
        window->InitializeObjectBase();
        return window;
    }
    void DisplayText(const char*) override {}
    void DisplayErrorText(const char*) override { complained = true; }
    void DisplayWarningText(const char*) override { complained = true; }
    void DisplayGenericWarningText(const char*) override { complained = true; }
    void DisplayDebugText(const char*) override {}
    bool complained = false;
};

VtkSession::VtkSession() : lock_(one_at_a_time()), window_(Window::make()) {
    vtkOutputWindow* previous = vtkOutputWindow::GetInstance();
    previous->Register(nullptr);
    previous_ = previous;
    vtkOutputWindow::SetInstance(window_);
    // VTK also writes all messages to its log, which goes to the terminal.
    previous_verbosity_ = vtkLogger::GetCurrentVerbosityCutoff();
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

VtkSession::~VtkSession() {
    vtkLogger::SetStderrVerbosity(static_cast<vtkLogger::Verbosity>(previous_verbosity_));
    auto* previous = static_cast<vtkOutputWindow*>(previous_);
    vtkOutputWindow::SetInstance(previous);
    previous->UnRegister(nullptr);
    window_->Delete();
}

bool VtkSession::complained() const { return window_->complained; }

}  // namespace myo::mesh
