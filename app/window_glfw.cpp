#include "window_glfw.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <imgui.h>

#include <array>
#include <atomic>
#include <chrono>
#include <string>
#include <utility>

#include "backend/user_files.hpp"
#include "commands/window_title.hpp"
#include "interrupt.hpp"
#include "panels/workbench_window.hpp"
#include "platform/gl.hpp"

namespace myo::app {
namespace {

using Clock = std::chrono::steady_clock;

// GLFW reports errors through a callback without context; only the last sentence is needed.
std::string& last_glfw_error() {
    static std::string text;
    return text;
}

/// Lifetime of the GLFW library.
struct GlfwLibrary {
    bool ready = false;
    GlfwLibrary() {
        glfwSetErrorCallback([](int, const char* text) { last_glfw_error() = text; });
        ready = glfwInit() == GLFW_TRUE;
    }
    ~GlfwLibrary() {
        if (ready) glfwTerminate();
    }
    GlfwLibrary(const GlfwLibrary&) = delete;
    GlfwLibrary& operator=(const GlfwLibrary&) = delete;
};

/// Deleter of a window for std::unique_ptr.
struct DestroyWindow {
    void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
};

/// ImGui's number of a key that has no letter; -1: another key.
int named_key(int key) {
    static constexpr std::pair<int, int> keys[] = {{GLFW_KEY_TAB, ImGuiKey_Tab},
                                                   {GLFW_KEY_F1, ui::platform::key_f1},
                                                   {GLFW_KEY_LEFT, ImGuiKey_LeftArrow},
                                                   {GLFW_KEY_RIGHT, ImGuiKey_RightArrow},
                                                   {GLFW_KEY_UP, ImGuiKey_UpArrow},
                                                   {GLFW_KEY_DOWN, ImGuiKey_DownArrow},
                                                   {GLFW_KEY_PAGE_UP, ImGuiKey_PageUp},
                                                   {GLFW_KEY_PAGE_DOWN, ImGuiKey_PageDown},
                                                   {GLFW_KEY_HOME, ImGuiKey_Home},
                                                   {GLFW_KEY_END, ImGuiKey_End},
                                                   {GLFW_KEY_INSERT, ImGuiKey_Insert},
                                                   {GLFW_KEY_DELETE, ImGuiKey_Delete},
                                                   {GLFW_KEY_BACKSPACE, ImGuiKey_Backspace},
                                                   {GLFW_KEY_SPACE, ImGuiKey_Space},
                                                   {GLFW_KEY_ENTER, ImGuiKey_Enter},
                                                   {GLFW_KEY_ESCAPE, ImGuiKey_Escape},
                                                   {GLFW_KEY_KP_ENTER, ImGuiKey_KeyPadEnter}};
    for (const auto& [glfw, imgui] : keys) {
        if (glfw == key) return imgui;
    }
    return -1;
}

/// Number of the key of a character; -1: the window does not use it.
int character_key(char character) {
    switch (character) {
        case 'a': return ImGuiKey_A;
        case 'c': return ImGuiKey_C;
        case 'v': return ImGuiKey_V;
        case 'x': return ImGuiKey_X;
        case 'y': return ImGuiKey_Y;
        case 'z': return ImGuiKey_Z;
        case 'b': return ui::platform::key_b;
        case 'd': return ui::platform::key_d;
        case 'e': return ui::platform::key_e;
        case 'f': return ui::platform::key_f;
        case 'k': return ui::platform::key_k;
        case 'm': return ui::platform::key_m;
        case 'o': return ui::platform::key_o;
        case 'p': return ui::platform::key_p;
        case 'q': return ui::platform::key_q;
        case 'r': return ui::platform::key_r;
        case 's': return ui::platform::key_s;
        case '0': return ui::platform::key_0;
        case '1': return ui::platform::key_1;
        case '2': return ui::platform::key_2;
        case '3': return ui::platform::key_3;
        case '4': return ui::platform::key_4;
        case '+':
        case '=': return ui::platform::key_plus;
        case '-': return ui::platform::key_minus;
        default: return -1;
    }
}

/// ImGui key of a GLFW key, or -1.
int key_of(int key) {
    if (const int named = named_key(key); named >= 0) return named;
    // Letters by their label, so that Ctrl+Z follows the keyboard layout.
    const char* name = glfwGetKeyName(key, 0);
    if (name == nullptr || name[0] == '\0' || name[1] != '\0') return -1;
    return character_key(name[0]);
}

/// Modifier keys out of the bits of GLFW.
ui::platform::Modifiers modifiers_of(int bits) {
    return {(bits & GLFW_MOD_CONTROL) != 0, (bits & GLFW_MOD_SHIFT) != 0, (bits & GLFW_MOD_ALT) != 0};
}

/// The workbench that run_window() has stored with the window.
ui::panels::WorkbenchWindow& workbench_of(GLFWwindow* window) {
    return *static_cast<ui::panels::WorkbenchWindow*>(glfwGetWindowUserPointer(window));
}

// Input is queued and handled with the next frame, both off screen and in the window.
void push(GLFWwindow* window, const ui::platform::InputEvent& event) {
    workbench_of(window).input().push(event);
    workbench_of(window).wake();
}

/// Queues a position of the mouse, given in screen coordinates.
void push_cursor(GLFWwindow* w, double x, double y) {
    // Screen coordinates to pixels; they differ on high-resolution displays.
    int screen = 1, pixels = 1, ignored = 0;
    glfwGetWindowSize(w, &screen, &ignored);
    glfwGetFramebufferSize(w, &pixels, &ignored);
    const double ratio = static_cast<double>(pixels) / std::max(1, screen);
    push(w, ui::platform::MouseMoved{static_cast<float>(x * ratio), static_cast<float>(y * ratio)});
}

/// Connects input and redraw requests of the window to the workbench.
void set_callbacks(GLFWwindow* window) {
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) { push_cursor(w, x, y); });
    glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
        // A mouse outside of the window is over nothing.
        if (entered == GLFW_FALSE) push(w, ui::platform::MouseMoved{-1e6f, -1e6f});
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int mods) {
        push(w, ui::platform::MouseButton{button, action == GLFW_PRESS, modifiers_of(mods)});
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
        push(w, ui::platform::MouseWheel{static_cast<float>(x), static_cast<float>(y)});
    });
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int mods) {
        // ImGui repeats a held key by itself as long as frames are drawn.
        if (action == GLFW_REPEAT) return workbench_of(w).wake();
        const int known = key_of(key);
        if (known >= 0) push(w, ui::platform::KeyPressed{known, action == GLFW_PRESS, modifiers_of(mods)});
    });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned character) { push(w, ui::platform::TextTyped{character}); });
    glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
        workbench_of(w).drop({paths, paths + count});
        workbench_of(w).wake();
    });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { workbench_of(w).wake(); });
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { workbench_of(w).wake(); });
}

// ImGui has no clipboard of the system by itself.
void share_clipboard(GLFWwindow* window) {
    ImGuiIO& io = ImGui::GetIO();
    io.ClipboardUserData = window;
    io.SetClipboardTextFn = [](void* data, const char* text) {
        glfwSetClipboardString(static_cast<GLFWwindow*>(data), text);
    };
    io.GetClipboardTextFn = [](void* data) { return glfwGetClipboardString(static_cast<GLFWwindow*>(data)); };
}

/// Mouse cursors of the workbench.
class Pointers {
public:
    Pointers()
        : text_(glfwCreateStandardCursor(GLFW_IBEAM_CURSOR)),
          sideways_(glfwCreateStandardCursor(GLFW_HRESIZE_CURSOR)),
          upright_(glfwCreateStandardCursor(GLFW_VRESIZE_CURSOR)) {}
    void apply(GLFWwindow* window) {
        const ImGuiMouseCursor wanted = ImGui::GetMouseCursor();
        if (wanted == shown_) return;
        shown_ = wanted;
        GLFWcursor* cursor = nullptr;
        if (wanted == ImGuiMouseCursor_TextInput) cursor = text_;
        if (wanted == ImGuiMouseCursor_ResizeEW) cursor = sideways_;
        if (wanted == ImGuiMouseCursor_ResizeNS) cursor = upright_;
        glfwSetCursor(window, cursor);
    }

private:
    GLFWcursor* text_;
    GLFWcursor* sideways_;
    GLFWcursor* upright_;
    ImGuiMouseCursor shown_ = ImGuiMouseCursor_Arrow;
};

/// Saves unsaved work for recovery every ten seconds, and changed preferences.
class Keeper {
public:
    explicit Keeper(ui::commands::Workbench& workbench)
        : workbench_(workbench), preferences_(workbench.state().preferences) {}

    void tick(Clock::time_point now) {
        if (now - last_ < std::chrono::seconds(10)) return;
        last_ = now;
        if (const auto file = backend::recovery_file(); !file.empty()) workbench_.autosave(file);
        keep_preferences();
    }

    /// Saves the latest state before an abnormal end.
    void rescue() {
        keep_preferences();
        workbench_.finish_autosave();  // an earlier save that is still running
        if (const auto file = backend::recovery_file(); !file.empty()) workbench_.autosave(file);
        workbench_.finish_autosave();
    }

    /// After a regular end the recovery files are no longer needed.
    void end() {
        keep_preferences();
        workbench_.finish_autosave();
        std::error_code ignored;
        if (const auto file = backend::recovery_file(); !file.empty()) {
            std::filesystem::remove(file, ignored);
            std::filesystem::remove_all(std::filesystem::path(file).replace_extension(".files"), ignored);
        }
    }

private:
    /// Writes the preferences if they have changed since the last time. A failure is a warning in the log.
    void keep_preferences() {
        const ui::commands::Preferences& now = workbench_.state().preferences;
        const auto file = backend::preferences_file();
        if (file.empty() || now == preferences_) return;
        preferences_ = now;
        if (const Result<void> written = backend::write_preferences(file, now); !written)
            workbench_.execute(ui::commands::LogMessage{ui::commands::LogLevel::warning,
                                                        "Preferences cannot be saved: " + written.error().text()});
    }

    ui::commands::Workbench& workbench_;
    ui::commands::Preferences preferences_;
    Clock::time_point last_ = Clock::now();
};

/// Applies stored preferences and offers unsaved work of earlier runs.
void take_up(ui::commands::Workbench& workbench) {
    if (const auto file = backend::preferences_file(); !file.empty()) {
        if (const Result<ui::commands::Preferences> kept = backend::read_preferences(file))
            workbench.execute(ui::commands::UsePreferences{*kept});
        else
            workbench.execute(ui::commands::LogMessage{ui::commands::LogLevel::warning,
                                                       "Preferences are ignored: " + kept.error().text()});
    }
    if (const auto file = backend::recovery_file(); !file.empty())
        workbench.execute(ui::commands::OfferRecovery{backend::found_recoveries(file.parent_path())});
}

/// The workbench asks about unsaved work first.
void ask_to_close(GLFWwindow* window, ui::commands::Workbench& workbench, ui::panels::WorkbenchWindow& view) {
    glfwSetWindowShouldClose(window, GLFW_FALSE);
    workbench.execute(ui::commands::Quit{});
    view.wake();
}

/// Waits for events; returns whether a frame is to be drawn. `works`: a job runs.
bool wait_for_frame(ui::panels::WorkbenchWindow& view, bool works) {
    if (view.must_draw()) {
        glfwPollEvents();
    } else {
        // The elapsed time of a running job is displayed even if it reports nothing.
        glfwWaitEventsTimeout(works ? 0.2 : 1.0);
        if (works) view.wake();
        if (!view.must_draw()) return false;
    }
    return true;
}

/// Main loop: draws frames until the user quits or drawing fails. Without input or a running job it sleeps.
Result<void> draw_frames(GLFWwindow* window, ui::commands::Workbench& workbench, ui::panels::WorkbenchWindow& view,
                         Keeper& keeper) {
    Pointers pointers;
    std::string title;
    auto last = Clock::now();
    while (!workbench.state().quit && !interrupt_flag()) {
        keeper.tick(Clock::now());
        if (glfwWindowShouldClose(window) == GLFW_TRUE) {
            ask_to_close(window, workbench, view);
            continue;
        }
        // Frames are drawn on demand only: an idle window uses no processor time.
        const bool works = workbench.state().works();
        if (!wait_for_frame(view, works)) continue;
        int width = 0, height = 0;
        glfwGetFramebufferSize(window, &width, &height);
        if (width < 1 || height < 1) {
            glfwWaitEventsTimeout(0.2);  // minimised
            continue;
        }
        // Animations advance by the time since the last frame that was drawn.
        const auto now = Clock::now();
        if (const auto drawn = view.draw_frame(width, height, std::chrono::duration<double>(now - last).count());
            !drawn)
            return drawn;
        last = now;
        if (std::string wanted = ui::commands::window_title(workbench.state()); wanted != title) {
            title = std::move(wanted);
            glfwSetWindowTitle(window, title.c_str());
        }
        if (works && !workbench.state().works()) view.wake();  // the result of a job needs several frames to settle
        pointers.apply(window);
        glfwSwapBuffers(window);
    }
    return {};
}

/// The main loop with what must happen at its end, regular or not.
Result<void> run_frames(GLFWwindow* window, ui::commands::Workbench& workbench, ui::panels::WorkbenchWindow& view) {
    Keeper keeper(workbench);
    catch_interrupts();
    try {
        const Result<void> drawn = draw_frames(window, workbench, view, keeper);
        // The end of a session of the desktop asks nothing; unsaved work is offered at the next start.
        if (drawn && !interrupt_flag())
            keeper.end();
        else
            keeper.rescue();
        return drawn;
    } catch (...) {
        keeper.rescue();  // e.g. out of memory
        throw;
    }
}

/// OpenGL 3.3, and a window that is scaled with its monitor.
void request_context() {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
}

}  // namespace

Result<void> run_window(std::shared_ptr<ui::commands::Backend> backend, const WindowOptions& options) {
    const GlfwLibrary library;
    if (!library.ready)
        return Error{
            "cannot open a window: " + last_glfw_error() + ". Without a display, use the subcommands (myoloop --help).",
            ""};
    request_context();
    const std::unique_ptr<GLFWwindow, DestroyWindow> window(
        glfwCreateWindow(options.width, options.height, "Myoloop", nullptr, nullptr));
    if (!window) return Error{"cannot open a window: " + last_glfw_error(), ""};
    glfwMakeContextCurrent(window.get());
    glfwSwapInterval(1);
    if (const auto loaded = ui::platform::gl::load(glfwGetProcAddress); !loaded) return loaded;
    // Background jobs wake the waiting main loop through an empty event.
    ui::commands::Workbench workbench(std::move(backend), [] { glfwPostEmptyEvent(); });
    float across = 1.0f, down = 1.0f;
    glfwGetWindowContentScale(window.get(), &across, &down);
    // Preferences first: they contain theme and scale of the first frame.
    take_up(workbench);
    if (const ui::commands::Preferences& kept = workbench.state().preferences; options.scale || !(kept.scale > 0.0f))
        workbench.execute(ui::commands::SetTheme{kept.theme, options.scale.value_or(across)});
    auto view = ui::panels::WorkbenchWindow::make(workbench);
    if (!view) return view.error();
    glfwSetWindowUserPointer(window.get(), &*view);
    set_callbacks(window.get());
    share_clipboard(window.get());
    if (!options.open.empty()) view->open(options.open);
    return run_frames(window.get(), workbench, *view);
}

}  // namespace myo::app
