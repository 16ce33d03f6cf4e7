#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include "architecture/source_rules.hpp"

namespace myo::test {
namespace {

namespace fs = std::filesystem;
const fs::path project = MYOLOOP_SOURCE_DIR;

std::string content_of(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

bool is_text(const std::string& content) { return content.find('\0') == std::string::npos; }

// Names at the top that are not part of the project: hidden folders of other programs, builds, results.
bool is_foreign(const fs::directory_entry& top) {
    const std::string name = top.path().filename().string();
    return (name[0] == '.' && name != ".ci" && name != ".gitignore") || name == "out" || name.rfind("build", 0) == 0;
}

// Every text file of the project. A hidden file below can be another program's, half written.
std::vector<SourceFile> project_files() {
    std::vector<SourceFile> files;
    const auto add = [&](const fs::path& path) {
        if (fs::file_size(path) > 4'000'000) return;
        SourceFile file{fs::relative(path, project).generic_string(), content_of(path)};
        if (is_text(file.text)) files.push_back(std::move(file));
    };
    for (const fs::directory_entry& top : fs::directory_iterator(project)) {
        if (is_foreign(top)) continue;
        if (top.is_regular_file()) add(top.path());
        if (!top.is_directory()) continue;
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(top.path()))
            if (entry.is_regular_file() && entry.path().filename().string()[0] != '.') add(entry.path());
    }
    std::sort(files.begin(), files.end(), [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
    return files;
}

const std::vector<SourceFile>& files() {
    static const std::vector<SourceFile> all = project_files();
    return all;
}

bool file_exists(const std::string& path) { return fs::is_regular_file(project / path); }

std::string told(const std::vector<Fault>& faults) {
    std::string text;
    for (const Fault& fault : faults) text += "  " + fault + "\n";
    return text;
}

// The faults of one rule over all files.
template <class Rule>
std::string faults_of(const Rule& rule) {
    std::string text;
    for (const SourceFile& file : files()) text += told(rule(file));
    return text;
}

TEST(Architecture, SourcesAreFound) {
    std::set<std::string> tops;
    for (const SourceFile& file : files()) tops.insert(file.path.substr(0, file.path.find('/')));
    for (const char* top : {"core", "ui", "app", "tests", "CMakeLists.txt", "LICENSE"}) EXPECT_TRUE(tops.contains(top)) << top;
    EXPECT_GT(std::count_if(files().begin(), files().end(), [](const SourceFile& f) { return !includes_of(f.text).empty(); }), 50);
}

TEST(Architecture, DependenciesPointUpwards) {
    EXPECT_EQ(faults_of([](const SourceFile& file) { return include_faults(file, file_exists); }), "");
}

TEST(Architecture, EveryModuleHasItsPlaceInTheOrder) {
    std::vector<std::string> folders;
    for (const fs::directory_entry& entry : fs::directory_iterator(project / "core"))
        if (entry.is_directory()) folders.push_back(entry.path().filename().string());
    EXPECT_EQ(told(module_faults(folders)), "");
}

TEST(Architecture, CoreDoesNotPrint) { EXPECT_EQ(faults_of(printing_faults), ""); }

TEST(Architecture, FilesStayShort) { EXPECT_EQ(faults_of(length_faults), ""); }

TEST(Architecture, NoFileNamesAFolderOfOneMachine) { EXPECT_EQ(faults_of(machine_path_faults), ""); }

// The rules can fail: each is broken by a made-up file.

const auto every_file_exists = [](const std::string&) { return true; };
const auto no_file_exists = [](const std::string&) { return false; };

std::size_t include_faults_of(const std::string& path, const std::string& text) {
    return include_faults({path, text}, every_file_exists).size();
}

TEST(IncludeRules, FindEveryWrongDependency) {
    for (std::size_t here = 0; here < module_order.size(); ++here)
        for (std::size_t there = 0; there < module_order.size(); ++there) {
            const std::string path = "core/" + module_order[here] + "/x.hpp";
            EXPECT_EQ(include_faults_of(path, "#include \"" + module_order[there] + "/y.hpp\"\n"), there > here ? 1u : 0u)
                << module_order[here] << " includes " << module_order[there];
        }
}

TEST(IncludeRules, FindDrawingInCore) {
    for (const char* header : {"<imgui.h>", "<GLFW/glfw3.h>", "<GL/osmesa.h>", "<GL/glcorearb.h>", "<EGL/egl.h>", "<imgui_internal.h>"}) {
        EXPECT_EQ(include_faults_of("core/model/x.cpp", std::string("#include ") + header), 1u) << header;
        EXPECT_EQ(include_faults_of("ui/panels/x.cpp", std::string("#include ") + header), 0u) << header;
    }
    const auto only_in_ui = [](const std::string& path) { return path == "ui/viewport/camera.hpp" || path == "app/jobs.hpp"; };
    EXPECT_EQ(include_faults({"core/model/x.cpp", "#include \"viewport/camera.hpp\""}, only_in_ui).size(), 1u);
    EXPECT_EQ(include_faults({"core/model/x.cpp", "#include \"jobs.hpp\""}, only_in_ui).size(), 1u);
    EXPECT_EQ(include_faults({"ui/panels/x.cpp", "#include \"jobs.hpp\""}, only_in_ui).size(), 1u);
    EXPECT_EQ(include_faults({"ui/panels/x.cpp", "#include \"viewport/camera.hpp\""}, only_in_ui).size(), 0u);
    EXPECT_EQ(include_faults({"app/main.cpp", "#include \"jobs.hpp\"\n#include \"viewport/camera.hpp\""}, only_in_ui).size(), 0u);
}

TEST(IncludeRules, FindVtkWhereItDoesNotBelong) {
    EXPECT_EQ(include_faults_of("core/mesh/x.cpp", "#include <vtkCellArray.h>"), 0u);
    EXPECT_EQ(include_faults_of("core/project/x.cpp", "#include <vtkCellArray.h>"), 0u);
    EXPECT_EQ(include_faults_of("core/mesh/x.hpp", "#include <vtkCellArray.h>"), 1u);
    EXPECT_EQ(include_faults_of("core/fem/x.cpp", "  #  include <vtkCellArray.h>"), 1u);
    EXPECT_EQ(include_faults_of("core/fem/x.hpp", "#include <vtkCellArray.h>"), 2u);
}

TEST(IncludeRules, FindFilesThatAreNotThere) {
    const std::vector<Fault> faults = include_faults({"core/fem/x.cpp", "#include <vector>\n\n#include \"base/none.hpp\"\n"}, no_file_exists);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].rfind("core/fem/x.cpp:3: \"base/none.hpp\"", 0), 0u) << faults[0];
}

TEST(IncludeRules, AcceptWhatCMakeMakesFromATemplate) {
    const auto template_only = [](const std::string& path) { return path == "app/versions.hpp.in"; };
    EXPECT_EQ(include_faults({"app/main.cpp", "#include \"versions.hpp\""}, template_only).size(), 0u);
    EXPECT_EQ(include_faults({"core/base/x.cpp", "#include \"versions.hpp\""}, template_only).size(), 1u);
}

TEST(PrintingRule, SeesCodeAndNotComments) {
    for (const char* code : {"std::cout << 1;", "std::cerr << 1;", "printf(\"x\");", "std::printf (\"x\");", "fprintf(stderr, \"x\");",
                             "f(); puts(\"x\");", "int a = 1'000; std::cout << a;", "char c = '\"'; printf(\"x\");"})
        EXPECT_EQ(printing_faults({"core/fem/x.cpp", code}).size(), 1u) << code;
    for (const char* code : {"std::snprintf(b, 8, \"x\");", "vsnprintf(b, 8, f, a);", "// std::cout", "/* printf( \n */ int a;",
                             "const char* a = \"printf(\";", "const char* a = R\"x(std::cout)x\";", "outputs(1);"})
        EXPECT_EQ(printing_faults({"core/fem/x.cpp", code}).size(), 0u) << code;
    EXPECT_EQ(printing_faults({"app/main.cpp", "std::cout << 1;"}).size(), 0u);
    EXPECT_EQ(include_faults_of("core/fem/x.cpp", "#include <iostream>"), 1u);
}

TEST(OtherRules, FindLongFilesMachinePathsAndUnknownModules) {
    EXPECT_EQ(length_faults({"core/fem/x.cpp", std::string(501, '\n')}).size(), 1u);
    EXPECT_EQ(length_faults({"core/fem/x.cpp", std::string(500, '\n')}).size(), 0u);
    const std::string folder = std::string("/ho") + "me/someone/data.csv";
    EXPECT_EQ(machine_path_faults({"README.md", "read " + folder}).size(), 1u);
    EXPECT_EQ(machine_path_faults({"tests/x.cpp", "read(\"" + folder + "\")"}).size(), 1u);
    EXPECT_EQ(machine_path_faults({"README.md", "see example.org" + folder}).size(), 0u);
    EXPECT_EQ(module_faults({"fem", "helpers"}).size(), 1u);
}

}  // namespace
}  // namespace myo::test
