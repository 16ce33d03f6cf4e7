// myoloop: the workbench, and its commands without a window.

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <new>
#include <sstream>
#include <string>
#include <system_error>

#include "backend/workbench_backend.hpp"
#include "base/abandonable.hpp"
#include "base/cancellation.hpp"
#include "base/text.hpp"
#include "commands.hpp"
#include "exit_status.hpp"
#include "interrupt.hpp"
#include "options.hpp"
#include "solver/sparse_cholesky.hpp"
#include "standard_output.hpp"
#include "window_glfw.hpp"

namespace myo::app {
namespace {

/// Prints a single line on standard error and returns the status of a wrong call.
int complain(std::string sentence) {
    std::replace(sentence.begin(), sentence.end(), '\n', ' ');
    std::fprintf(stderr, "myoloop: %s\n", sentence.c_str());
    return status_wrong;
}

/// Without a command: opens a file in the workbench, or reports a misspelt command.
int open_or_complain(const std::string& file, const CLI::App& app) {
    std::error_code code;
    if (!file.empty() && !std::filesystem::exists(file, code)) {
        const bool path_like = file.find_first_of("/.") != std::string::npos;
        if (path_like) return complain(file + ": file not found");
        return complain("there is no command or file of this name: " + unknown_word(file, command_names()));
    }
    if (!app.remaining().empty()) return complain(surplus_arguments(app));
    WindowOptions options;
    options.open = file;
    const Result<void> closed = run_window(backend::make_core_backend(), options);
    return closed ? static_cast<int>(status_done) : complain(closed.error().text());
}

/// Prints a note if a command is called by its former name.
void note_former_name(const std::string& word) {
    for (const Subcommand& command : commands())
        if (!word.empty() && command.former_name == word)
            std::fprintf(stderr, "myoloop: note: '%s' is now called '%s'\n", word.c_str(), command.name.c_str());
}

/// Parses the call and runs the command, or opens the window. Returns the exit status.
int run(int argc, char** argv) {
    remember_command_line(argc, argv);
    if (argc > 1) note_former_name(argv[1]);
    CLI::App app("Myoloop: a workbench for soft robots. Without a command it opens the window.", "myoloop");
    app.set_version_flag("--version", "myoloop " MYOLOOP_VERSION);
    // Extra arguments are reported by surplus_arguments(), with a suggestion, instead of by CLI11.
    app.allow_extras();
    std::string file;
    app.add_option("FILE", file, "experiment folder or mesh to open in the workbench")->type_name("");

    // All commands are declared; only the chosen one runs.
    std::map<const CLI::App*, std::function<int()>> actions;
    for (const Subcommand& command : commands()) {
        CLI::App* sub = app.add_subcommand(command.name, command.summary);
        sub->allow_extras();
        if (!command.former_name.empty()) sub->alias(command.former_name);
        actions[sub] = command.declare(*sub);
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& help) {
        std::ostringstream text;
        const int status = app.exit(help, text, text);
        print_text(text.str());
        return status;
    } catch (const CLI::ParseError& error) {
        return complain(error.what());
    }
    const std::vector<CLI::App*> chosen = app.get_subcommands();
    if (chosen.empty()) return open_or_complain(file, app);
    // `file` takes a word that is no command, so "myoloop exp simulate" arrives here.
    if (!file.empty()) return complain("'" + file + "' stands before the command " + chosen.front()->get_name());
    if (chosen.size() > 1)
        return complain("one command at a time: " + chosen[0]->get_name() + " or " + chosen[1]->get_name());
    if (!chosen.front()->remaining().empty()) return complain(surplus_arguments(*chosen.front()));
    // Only for commands: the window catches interrupts itself.
    catch_interrupts();
    // For long loops that receive no Progress of their own.
    const Progress interrupts({}, &interrupt_flag());
    const CancellationScope scope(&interrupts);
    return actions.at(chosen.front())();
}

/// Printed text is a result: if it was lost, the call has failed.
int with_output(int status) {
    const std::string reason = output_failure();
    if (reason.empty()) return status;
    complain("standard output cannot be written: " + reason);
    return status == status_done ? static_cast<int>(status_failed) : status;
}

/// Ends the program. Abandoned work still uses what an orderly end would destroy: then at once, after the output.
int leave(int status) {
    if (abandoned_calls() == 0) return status;
    std::fflush(nullptr);
    std::_Exit(status);
}

}  // namespace
}  // namespace myo::app

int main(int argc, char** argv) {
    // Before any file is opened, see standard_output.hpp. BLAS threads would compete with the program's own.
    myo::app::keep_closed_streams_closed();
    myo::solver::use_one_blas_thread();
    try {
        return myo::app::leave(myo::app::with_output(myo::app::run(argc, argv)));
    } catch (const std::bad_alloc&) {
        std::fputs("myoloop: out of memory; try a coarser mesh (--resolution) or a larger step (--dt)\n", stderr);
        return myo::app::status_failed;
    } catch (const std::exception& error) {
        // Bad input is a Result, so an exception is a mistake of the program: a sentence serves better than SIGABRT.
        myo::app::complain(std::string("stopped by an internal error: ") + error.what());
        return myo::app::leave(myo::app::status_failed);
    }
}
