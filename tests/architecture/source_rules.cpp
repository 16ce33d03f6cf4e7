#include "architecture/source_rules.hpp"

#include <algorithm>
#include <array>
#include <regex>
#include <sstream>

namespace myo::test {
namespace {

std::string first_folder(const std::string& path) { return path.substr(0, path.find('/')); }

std::string folder_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? std::string{} : path.substr(0, slash + 1);
}

bool ends_with(const std::string& text, std::string_view end) {
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

bool is_cpp(const std::string& path) { return ends_with(path, ".cpp") || ends_with(path, ".hpp"); }

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

Fault fault(const SourceFile& file, int line, const std::string& why) {
    return file.path + ":" + std::to_string(line) + ": " + why;
}

// Folders in which a file may look for a quoted name, nearest layer first.
std::vector<std::string> search_folders(const std::string& path) {
    const std::string layer = first_folder(path);
    if (layer == "core") return {"core/"};
    if (layer == "ui") return {"ui/", "core/"};
    if (layer == "app") return {folder_of(path), "app/", "ui/", "core/"};
    return {folder_of(path), "tests/", "app/", "ui/", "core/"};
}

std::string find_included(const SourceFile& file, const Include& include, const FileExists& exists) {
    for (const std::string& folder : search_folders(file.path))
        // CMake makes x.hpp from x.hpp.in.
        if (exists(folder + include.name) || exists(folder + include.name + ".in")) return folder + include.name;
    return {};
}

bool draws(const std::string& header) {
    for (const char* prefix :
         {"imgui", "GLFW/", "GL/", "GLES", "EGL/", "epoxy/", "glad/", "stb_", "ft2build", "freetype"})
        if (header.rfind(prefix, 0) == 0) return true;
    return false;
}

std::vector<Fault> core_include_faults(const SourceFile& file, const Include& include) {
    std::vector<Fault> faults;
    const bool vtk = include.name.rfind("vtk", 0) == 0;
    if (draws(include.name))
        faults.push_back(fault(file, include.line, "core includes " + include.name + ", which draws"));
    if (vtk && ends_with(file.path, ".hpp"))
        faults.push_back(fault(file, include.line, "a header of core includes VTK"));
    if (vtk && file.path.rfind("core/mesh/", 0) != 0)
        faults.push_back(fault(file, include.line, "only core/mesh uses VTK"));
    if (include.name == "iostream") faults.push_back(fault(file, include.line, "core does not print"));
    return faults;
}

/// Modules that CMake does not link. Tests may use every module.
std::vector<Fault> dependency_faults(const ModuleGraph& graph, const SourceFile& file, const std::string& included,
                                     int line) {
    const Module *const here = module_of(graph, file.path), *const there = module_of(graph, included);
    if (!here || !there || here->reaches.contains(there->name)) return {};
    return {fault(file, line, here->name + " includes " + there->name + ", which it does not link")};
}

/// Text of C++ without comments and, unless they are kept, without the content of literals; lines stay.
std::string blanked(std::string_view text, bool keep_literals) {
    std::string out(text);
    const auto blank = [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < std::min(to, out.size()); ++i)
            if (out[i] != '\n') out[i] = ' ';
    };
    for (std::size_t i = 0; i < text.size();) {
        if (text.substr(i, 2) == "//") {
            const std::size_t end = std::min(text.find('\n', i), text.size());
            blank(i, end);
            i = end;
        } else if (text.substr(i, 2) == "/*") {
            const std::size_t end = std::min(text.find("*/", i + 2), text.size() - 2) + 2;
            blank(i, end);
            i = end;
        } else if (text.substr(i, 2) == "R\"") {
            const std::size_t open = std::min(text.find('(', i), text.size());
            const std::string close = ")" + std::string(text.substr(i + 2, open - i - 2)) + "\"";
            const std::size_t end = std::min(text.find(close, open), text.size() - close.size()) + close.size();
            if (!keep_literals) blank(i, end);
            i = end;
        } else if (text[i] == '"' ||
                   (text[i] == '\'' && (i == 0 || !std::isalnum(static_cast<unsigned char>(text[i - 1]))))) {
            std::size_t end = i + 1;  // a quote after a letter or digit separates digits: 1'000
            while (end < text.size() && text[end] != text[i] && text[end] != '\n') end += text[end] == '\\' ? 2 : 1;
            if (!keep_literals) blank(i + 1, end);
            i = end + 1;
        } else {
            ++i;
        }
    }
    return out;
}

}  // namespace

std::vector<Include> includes_of(const std::string& text) {
    static const std::regex pattern(R"(^\s*#\s*include\s*(["<])([^">]+)[">])");
    std::vector<Include> includes;
    std::istringstream lines(text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        std::smatch match;
        if (std::regex_search(line, match, pattern)) includes.push_back({match[2], match[1] == "\"", number});
    }
    return includes;
}

std::vector<Fault> include_faults(const ModuleGraph& graph, const SourceFile& file, const FileExists& exists) {
    std::vector<Fault> faults;
    if (!is_cpp(file.path)) return faults;
    const std::string layer = first_folder(file.path);
    for (const Include& include : includes_of(file.text)) {
        if (layer == "core") {
            const std::vector<Fault> more = core_include_faults(file, include);
            faults.insert(faults.end(), more.begin(), more.end());
        }
        if (!include.quoted) continue;
        const std::string found = find_included(file, include, exists);
        if (found.empty()) {
            faults.push_back(
                fault(file, include.line, "\"" + include.name + "\" is no file that this layer may include"));
            continue;
        }
        const std::vector<Fault> more = dependency_faults(graph, file, found, include.line);
        faults.insert(faults.end(), more.begin(), more.end());
    }
    return faults;
}

std::vector<Fault> printing_faults(const SourceFile& file) {
    static const std::regex printing(
        R"((std::cout|std::cerr|std::clog|\bv?f?printf\s*\(|\bf?puts\s*\(|\bputchar\s*\(|\bperror\s*\())");
    std::vector<Fault> faults;
    if (first_folder(file.path) != "core" || !is_cpp(file.path)) return faults;
    std::istringstream lines(code_only(file.text));
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number)
        if (std::smatch match; std::regex_search(line, match, printing))
            faults.push_back(fault(file, number, "core does not print (" + match.str() + ")"));
    return faults;
}

std::vector<Fault> length_faults(const SourceFile& file) {
    // Tests are lists of independent cases.
    const int most = first_folder(file.path) == "tests" ? 500 : 400;
    const auto lines = std::count(file.text.begin(), file.text.end(), '\n');
    if (!is_cpp(file.path) || lines <= most) return {};
    return {fault(file, most + 1, "has " + std::to_string(lines) + " lines; look for the second idea")};
}

std::map<std::string, std::string> effect_files(const std::vector<SourceFile>& files) {
    static const std::regex entry(R"rx(\.id = "(\w+)")rx");
    std::map<std::string, std::string> found;
    for (const SourceFile& file : files) {
        if (file.path.rfind("core/effect/", 0) != 0 || !is_cpp(file.path)) continue;
        for (std::sregex_iterator at(file.text.begin(), file.text.end(), entry), end; at != end; ++at)
            found[(*at)[1]] = file.path;
    }
    return found;
}

std::vector<Fault> effect_id_faults(const std::map<std::string, std::string>& effects, const SourceFile& file) {
    const std::string layer = first_folder(file.path);
    if (!is_cpp(file.path) || (layer != "core" && layer != "app" && layer != "ui")) return {};
    std::vector<Fault> faults;
    std::istringstream code(code_only(file.text)), all(blanked(file.text, true));
    std::string line, with_literals;
    for (int count = 1; std::getline(code, line) && std::getline(all, with_literals); ++count) {
        if (line.rfind("#include", 0) == 0) continue;
        for (std::size_t from = 0; from < with_literals.size(); ++from) {
            // Words of literals are blank in the code.
            if (line[from] != ' ' || !is_word(with_literals[from])) continue;
            std::size_t end = from;
            while (end < with_literals.size() && is_word(with_literals[end])) ++end;
            const auto effect = effects.find(with_literals.substr(from, end - from));
            if (effect != effects.end() && effect->second != file.path)
                faults.push_back(fault(file, count, "names the effect " + effect->first));
            from = end;
        }
    }
    return faults;
}

std::vector<Fault> tuning_faults(const SourceFile& file) {
    // Facts of a geometry, a rule or a protocol: another value would be wrong, not better or worse.
    static const std::array<std::string, 7> structural = {
        "core/fem/assumed_strain.hpp",                       // points and weights of the quadrature
        "core/mesh/connectivity.cpp",                        // corners of a face
        "core/mesh/tetgen_exchange.hpp",                     // exit codes and magic number of the worker
        "core/measurement/trace_csv.cpp",                    // an absent column
        "core/chart/chart.hpp",                              // colours that are no slots
        "core/diagnosis/report/diagnosis_report_parts.hpp",  // colour slots
        "core/solver/factor_block.hpp"};                     // block size of the storage layout
    static const std::regex declaration(
        R"(^(.*)\bconstexpr\s+(?:double|float|int|long|std::size_t|std::uint64_t|(?:Eigen::)?Index))"
        R"(\s+([^;()]*=[^;]*);)");
    static const std::regex derived(R"(numeric_limits|numbers::|sizeof|decltype|Policy|_policy\.)");
    static const std::regex number(R"(=\s*[-+]?[\d.]|[-+*/(]\s*\d)");
    if (file.path.rfind("core/", 0) != 0 || !is_cpp(file.path)) return {};
    if (std::find(structural.begin(), structural.end(), file.path) != structural.end()) return {};
    std::vector<Fault> faults;
    std::istringstream lines(code_only(file.text));
    std::string line;
    for (int count = 1; std::getline(lines, line); ++count) {
        std::smatch match;
        if (!std::regex_search(line, match, declaration)) continue;
        const std::string before = match[1], body = match[2];
        const bool member = before.find("static") != std::string::npos;
        const bool array = body.substr(0, body.find('=')).find('[') != std::string::npos;
        if (!member && !array && !std::regex_search(body, derived) && std::regex_search(body, number))
            faults.push_back(fault(file, count, "a number outside a policy: " + body));
    }
    return faults;
}

std::vector<Fault> global_policy_faults(const SourceFile& file) {
    static const std::regex global(R"(\b\w+_policy\b|\bconstexpr\s+\w*Policy\b)");
    if (file.path.rfind("core/diagnosis/", 0) != 0 || file.path.rfind("core/diagnosis/report/", 0) == 0) return {};
    if (!is_cpp(file.path)) return {};
    std::vector<Fault> faults;
    std::istringstream lines(code_only(file.text));
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number)
        if (std::smatch match; std::regex_search(line, match, global))
            faults.push_back(fault(file, number, "a policy that no argument carries: " + match.str()));
    return faults;
}

std::vector<Fault> machine_path_faults(const SourceFile& file) {
    // Written in two parts, or this file would break the rule itself.
    static const std::array<std::string, 5> roots = {std::string("/wo") + "rk/", std::string("/tm") + "p/",
                                                     std::string("/ho") + "me/", std::string("/ro") + "ot/",
                                                     std::string("/Us") + "ers/"};
    std::vector<Fault> faults;
    std::istringstream lines(file.text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number)
        for (const std::string& root : roots) {
            const std::size_t at = line.find(root);
            // "a/tmp/" is part of a relative path or of an address.
            const bool absolute = at != std::string::npos &&
                                  (at == 0 || (!std::isalnum(static_cast<unsigned char>(line[at - 1])) &&
                                               line[at - 1] != '.' && line[at - 1] != '}'));
            if (absolute) faults.push_back(fault(file, number, "names " + root + ", a folder of one machine"));
        }
    return faults;
}

std::vector<Fault> module_faults(const ModuleGraph& graph, const std::vector<std::string>& folders) {
    std::vector<Fault> faults;
    for (const std::string& folder : folders)
        if (!module_of(graph, folder + "/x.cpp")) faults.push_back(folder + ": CMake declares no module of this name");
    return faults;
}

std::string code_only(std::string_view text) { return blanked(text, false); }

}  // namespace myo::test
