#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include "architecture/definitions.hpp"
#include "architecture/module_graph.hpp"
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

const ModuleGraph& graph() {
    static const ModuleGraph declared = [] {
        std::vector<std::string> texts;
        for (const char* folder : {"core", "ui", "app"})
            texts.push_back(content_of(project / folder / "CMakeLists.txt"));
        return read_module_graph(texts);
    }();
    return declared;
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
    for (const char* top : {"core", "ui", "app", "tests", "CMakeLists.txt", "LICENSE"})
        EXPECT_TRUE(tops.contains(top)) << top;
    EXPECT_GT(
        std::count_if(files().begin(), files().end(), [](const SourceFile& f) { return !includes_of(f.text).empty(); }),
        50);
}

TEST(Architecture, FilesIncludeOnlyModulesThatTheirOwnLinks) {
    EXPECT_EQ(faults_of([](const SourceFile& file) { return include_faults(graph(), file, file_exists); }), "");
}

TEST(Architecture, ModulesFormNoCycle) { EXPECT_EQ(cycles(graph()), std::vector<std::string>{}); }

TEST(Architecture, EveryFolderIsAModule) {
    std::vector<std::string> folders;
    for (const char* layer : {"core", "ui", "app"})
        for (const fs::directory_entry& entry : fs::directory_iterator(project / layer))
            if (entry.is_directory()) folders.push_back(layer + ("/" + entry.path().filename().string()));
    EXPECT_GT(folders.size(), 20u);
    EXPECT_EQ(told(module_faults(graph(), folders)), "");
}

TEST(Architecture, EveryModuleHasItsOwnNamespace) {
    EXPECT_EQ(faults_of([](const SourceFile& file) { return namespace_faults(graph(), file); }), "");
}

TEST(Architecture, NoTwoClassesShareAName) { EXPECT_EQ(told(definition_faults(files())), ""); }

TEST(Architecture, CoreDoesNotPrint) { EXPECT_EQ(faults_of(printing_faults), ""); }

TEST(Architecture, FilesStayShort) { EXPECT_EQ(faults_of(length_faults), ""); }

TEST(Architecture, TuningNumbersAreInPolicies) { EXPECT_EQ(faults_of(tuning_faults), ""); }

TEST(Architecture, PhasesOfTheDiagnosisAreGivenTheirPolicy) { EXPECT_EQ(faults_of(global_policy_faults), ""); }

TEST(Architecture, EffectsAreNamedInTheirOwnFilesOnly) {
    const std::map<std::string, std::string> effects = effect_files(files());
    // One id per entry of the list in the catalogue, whose definition is no entry.
    const std::string catalogue = content_of(project / "core/effect/catalogue.cpp");
    std::size_t entries = 0;
    for (std::size_t at = 0; (at = catalogue.find(" entry(", at)) != std::string::npos; ++at) ++entries;
    EXPECT_EQ(effects.size(), entries);
    EXPECT_EQ(faults_of([&](const SourceFile& file) { return effect_id_faults(effects, file); }), "");
}

TEST(Architecture, NoFileNamesAFolderOfOneMachine) { EXPECT_EQ(faults_of(machine_path_faults), ""); }

// The rules can fail: each is broken by a made-up file.

const auto every_file_exists = [](const std::string&) { return true; };
const auto no_file_exists = [](const std::string&) { return false; };

/// Three modules of core in a row, one of ui on the first, and the program on all.
const ModuleGraph small_graph = read_module_graph(
    {"myoloop_module(mesh LINK Eigen3::Eigen)\n"
     "myoloop_module(fem LINK myoloop_mesh) # myoloop_model\n"
     "myoloop_module(model HEADERS base LINK\n  myoloop_fem)\n",
     "myoloop_module(panels FOLDER ui LINK)\n"
     "target_link_libraries(myoloop_panels PUBLIC myoloop_mesh imgui)",
     "target_link_libraries(myoloop PRIVATE myoloop_model myoloop_panels)"});

std::size_t include_faults_of(const std::string& path, const std::string& text) {
    return include_faults(small_graph, {path, text}, every_file_exists).size();
}

TEST(ModuleGraph, IsReadFromCMake) {
    EXPECT_EQ(small_graph.at("model").links, (std::set<std::string>{"fem"}));
    EXPECT_EQ(small_graph.at("model").reaches, (std::set<std::string>{"mesh", "fem", "model"}));
    EXPECT_EQ(small_graph.at("panels").reaches, (std::set<std::string>{"mesh", "panels"}));
    EXPECT_EQ(small_graph.at("app").reaches, (std::set<std::string>{"mesh", "fem", "model", "panels", "app"}));
    EXPECT_EQ(module_of(small_graph, "ui/panels/x.cpp")->name, "panels");
    EXPECT_EQ(module_of(small_graph, "app/main.cpp")->name, "app");
    EXPECT_EQ(module_of(small_graph, "core/panels/x.cpp"), nullptr);
    EXPECT_TRUE(cycles(small_graph).empty());
    EXPECT_EQ(cycles(read_module_graph({"myoloop_module(a LINK myoloop_b)\nmyoloop_module(b LINK myoloop_a)"})).size(),
              2u);
}

TEST(IncludeRules, FindEveryModuleThatIsNotLinked) {
    const auto includes = [](const std::string& path, const std::string& name) {
        const auto only_there = [&](const std::string& file) { return file == "core/" + name; };
        return include_faults(small_graph, {path, "#include \"" + name + "\"\n"}, only_there).size();
    };
    EXPECT_EQ(includes("core/model/x.cpp", "mesh/y.hpp"), 0u);
    EXPECT_EQ(includes("core/model/x.cpp", "fem/y.hpp"), 0u);
    EXPECT_EQ(includes("core/fem/x.cpp", "model/y.hpp"), 1u);
    EXPECT_EQ(includes("core/mesh/x.cpp", "fem/y.hpp"), 1u);
    EXPECT_EQ(includes("ui/panels/x.cpp", "mesh/y.hpp"), 0u);
    EXPECT_EQ(includes("ui/panels/x.cpp", "model/y.hpp"), 1u);
    EXPECT_EQ(includes("app/main.cpp", "model/y.hpp"), 0u);
}

TEST(IncludeRules, FindDrawingInCore) {
    for (const char* header :
         {"<imgui.h>", "<GLFW/glfw3.h>", "<GL/osmesa.h>", "<GL/glcorearb.h>", "<EGL/egl.h>", "<imgui_internal.h>"}) {
        EXPECT_EQ(include_faults_of("core/model/x.cpp", std::string("#include ") + header), 1u) << header;
        EXPECT_EQ(include_faults_of("ui/panels/x.cpp", std::string("#include ") + header), 0u) << header;
    }
    const auto only_in_ui = [](const std::string& path) {
        return path == "ui/viewport/camera.hpp" || path == "app/jobs.hpp";
    };
    EXPECT_EQ(include_faults(small_graph, {"core/model/x.cpp", "#include \"viewport/camera.hpp\""}, only_in_ui).size(),
              1u);
    EXPECT_EQ(include_faults(small_graph, {"core/model/x.cpp", "#include \"jobs.hpp\""}, only_in_ui).size(), 1u);
    EXPECT_EQ(include_faults(small_graph, {"ui/panels/x.cpp", "#include \"jobs.hpp\""}, only_in_ui).size(), 1u);
    EXPECT_EQ(include_faults(small_graph, {"ui/panels/x.cpp", "#include \"viewport/camera.hpp\""}, only_in_ui).size(),
              0u);
    EXPECT_EQ(include_faults(small_graph, {"app/main.cpp", "#include \"jobs.hpp\"\n#include \"viewport/camera.hpp\""},
                             only_in_ui)
                  .size(),
              0u);
}

TEST(IncludeRules, FindVtkWhereItDoesNotBelong) {
    EXPECT_EQ(include_faults_of("core/mesh/x.cpp", "#include <vtkCellArray.h>"), 0u);
    EXPECT_EQ(include_faults_of("core/project/x.cpp", "#include <vtkCellArray.h>"), 1u);
    EXPECT_EQ(include_faults_of("core/mesh/x.hpp", "#include <vtkCellArray.h>"), 1u);
    EXPECT_EQ(include_faults_of("core/fem/x.cpp", "  #  include <vtkCellArray.h>"), 1u);
    EXPECT_EQ(include_faults_of("core/fem/x.hpp", "#include <vtkCellArray.h>"), 2u);
}

TEST(IncludeRules, FindFilesThatAreNotThere) {
    const std::vector<Fault> faults = include_faults(
        small_graph, {"core/fem/x.cpp", "#include <vector>\n\n#include \"base/none.hpp\"\n"}, no_file_exists);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_EQ(faults[0].rfind("core/fem/x.cpp:3: \"base/none.hpp\"", 0), 0u) << faults[0];
}

TEST(IncludeRules, AcceptWhatCMakeMakesFromATemplate) {
    const auto template_only = [](const std::string& path) { return path == "app/versions.hpp.in"; };
    EXPECT_EQ(include_faults(small_graph, {"app/main.cpp", "#include \"versions.hpp\""}, template_only).size(), 0u);
    EXPECT_EQ(include_faults(small_graph, {"core/base/x.cpp", "#include \"versions.hpp\""}, template_only).size(), 1u);
}

TEST(NamespaceRule, FindsForeignNamespaces) {
    const auto faults = [](const std::string& path, const std::string& text) {
        return namespace_faults(small_graph, {path, text}).size();
    };
    EXPECT_EQ(faults("core/mesh/x.hpp", "namespace myo::mesh {\nstruct A {};\n}"), 0u);
    EXPECT_EQ(faults("core/mesh/x.hpp", "namespace myo::mesh::tools {\nint a();\n}"), 0u);
    EXPECT_EQ(faults("core/mesh/x.hpp", "namespace myo {\nint a();\n}"), 1u);
    EXPECT_EQ(faults("core/fem/x.hpp", "namespace myo::mesh {\nstruct A {};\n}"), 1u);
    EXPECT_EQ(faults("core/fem/x.hpp", "namespace myo::mesh {\nstruct A;\nenum class B;\n}\nnamespace myo::fem {\n}"),
              0u);
    EXPECT_EQ(faults("ui/panels/x.hpp", "namespace myo::ui::panels {\nint a();\n}"), 0u);
    EXPECT_EQ(faults("ui/panels/x.hpp", "namespace myo::panels {\nint a();\n}"), 1u);
}

TEST(DefinitionRule, FindsOneNameOfTwoClasses) {
    const std::string
        one = "namespace myo::report {\ntemplate <class T>\nstruct Ticks : Base { enum { a }; struct Inner {}; };\n}";
    const auto faults = [&](const std::string& other) {
        return definition_faults({{"core/report/a.hpp", one}, {"core/report/b.hpp", other}}).size();
    };
    EXPECT_EQ(definitions_of({"core/report/a.hpp", one}).size(), 1u);
    EXPECT_EQ(definitions_of({"core/report/a.hpp", one}).front().name, "myo::report::Ticks");
    EXPECT_EQ(faults("namespace myo { namespace report {\nenum class Ticks : int { a };\n} }"), 1u);
    EXPECT_EQ(faults("namespace myo::report { namespace {\nstruct Ticks {};\n} }"), 0u);
    EXPECT_EQ(faults("namespace myo::report {\nstruct Ticks;\nvoid f(struct Ticks* a);\n}"), 0u);
    EXPECT_EQ(faults("namespace myo::report {\nvoid f() { struct Ticks {}; }\n// struct Ticks {\n}"), 0u);
    EXPECT_EQ(faults("namespace myo::ui::plot {\nclass Ticks final {};\n}"), 0u);
}

TEST(PrintingRule, SeesCodeAndNotComments) {
    for (const char* code :
         {"std::cout << 1;", "std::cerr << 1;", "printf(\"x\");", "std::printf (\"x\");", "fprintf(stderr, \"x\");",
          "f(); puts(\"x\");", "int a = 1'000; std::cout << a;", "char c = '\"'; printf(\"x\");"})
        EXPECT_EQ(printing_faults({"core/fem/x.cpp", code}).size(), 1u) << code;
    for (const char* code :
         {"std::snprintf(b, 8, \"x\");", "vsnprintf(b, 8, f, a);", "// std::cout", "/* printf( \n */ int a;",
          "const char* a = \"printf(\";", "const char* a = R\"x(std::cout)x\";", "outputs(1);"})
        EXPECT_EQ(printing_faults({"core/fem/x.cpp", code}).size(), 0u) << code;
    EXPECT_EQ(printing_faults({"app/main.cpp", "std::cout << 1;"}).size(), 0u);
    EXPECT_EQ(include_faults_of("core/fem/x.cpp", "#include <iostream>"), 1u);
}

TEST(TuningRule, FindsNumbersOutsidePolicies) {
    const auto faults = [](const std::string& code) { return tuning_faults({"core/fem/x.cpp", code}).size(); };
    EXPECT_EQ(faults("constexpr double most = 3.0;"), 1u);
    EXPECT_EQ(faults("inline constexpr int rounds = 3, others = 4;  // why"), 1u);
    EXPECT_EQ(faults("void f() {\n    constexpr std::size_t count = 16;\n}"), 1u);
    EXPECT_EQ(faults("constexpr double share = 1.0 / 3.0;"), 1u);
    EXPECT_EQ(faults("struct XPolicy {\n    double most = 3.0;\n};\nconstexpr XPolicy x_policy;"), 0u);
    EXPECT_EQ(faults("constexpr int at_once = x_policy.at_once;"), 0u);
    EXPECT_EQ(faults("struct A {\n    static constexpr int nodes = 8;\n};"), 0u);
    EXPECT_EQ(faults("constexpr double weights[] = {1.0, 2.0};"), 0u);
    EXPECT_EQ(faults("constexpr double none = std::numeric_limits<double>::quiet_NaN();"), 0u);
    EXPECT_EQ(faults("// constexpr double most = 3.0;"), 0u);
    EXPECT_EQ(tuning_faults({"tests/fem/x.cpp", "constexpr double most = 3.0;"}).size(), 0u);
}

TEST(GlobalPolicyRule, FindsPoliciesThatNoArgumentCarries) {
    const auto faults = [](const std::string& code) {
        return global_policy_faults({"core/diagnosis/fit/x.cpp", code}).size();
    };
    EXPECT_EQ(faults("inline constexpr DiagnosisPolicy defaults;"), 1u);
    EXPECT_EQ(faults("return diagnosis_policy.force.max_runs;"), 1u);
    EXPECT_EQ(faults("void f(const DiagnosisPolicy& policy = diagnosis_policy);"), 1u);
    EXPECT_EQ(faults("#include \"diagnosis/diagnosis_policy.hpp\"\nvoid f(const ForcePolicy& policy);"), 0u);
    EXPECT_EQ(faults("const ForcePolicy policy_;  // see diagnosis_policy"), 0u);
    EXPECT_EQ(global_policy_faults({"core/setup/x.cpp", "mesh_policy.most;"}).size(), 0u);
    EXPECT_EQ(global_policy_faults({"core/diagnosis/report/x.cpp", "report_policy.most;"}).size(), 0u);
}

TEST(EffectRule, FindsIdsInLiteralsOfOtherFiles) {
    const std::map<std::string, std::string> effects = effect_files(
        {{"core/effect/patch.cpp", "Effect patch() { return {.id = \"soft_patch\", .apply = apply}; }"},
         {"core/model/x.cpp", "return {.id = \"other\"};"}});
    EXPECT_EQ(effects, (std::map<std::string, std::string>{{"soft_patch", "core/effect/patch.cpp"}}));
    const auto faults = [&](const std::string& path, const std::string& code) {
        return effect_id_faults(effects, {path, code}).size();
    };
    EXPECT_EQ(faults("core/setup/x.cpp", "if (id == \"soft_patch\") f();"), 1u);
    EXPECT_EQ(faults("ui/panels/x.cpp", "f(\"a\", \"effect soft_patch: bad\");\nf(\"b+soft_patch\");"), 2u);
    EXPECT_EQ(faults("app/x.cpp", "const char* text = R\"(soft_patch)\";"), 1u);
    EXPECT_EQ(faults("app/x.cpp", "soft_patch();  // as \"soft_patch\""), 0u);
    EXPECT_EQ(faults("app/x.cpp", "#include \"material/soft_patch.hpp\"\nf(\"soft_patches\");"), 0u);
    EXPECT_EQ(faults("core/effect/patch.cpp", "f(\"soft_patch\");"), 0u);
    EXPECT_EQ(faults("tests/effect/x.cpp", "f(\"soft_patch\");"), 0u);
}

TEST(OtherRules, FindLongFilesMachinePathsAndUnknownModules) {
    EXPECT_EQ(length_faults({"core/fem/x.cpp", std::string(401, '\n')}).size(), 1u);
    EXPECT_EQ(length_faults({"core/fem/x.cpp", std::string(400, '\n')}).size(), 0u);
    EXPECT_EQ(length_faults({"tests/fem/x.cpp", std::string(500, '\n')}).size(), 0u);
    EXPECT_EQ(length_faults({"tests/fem/x.cpp", std::string(501, '\n')}).size(), 1u);
    const std::string folder = std::string("/ho") + "me/someone/data.csv";
    EXPECT_EQ(machine_path_faults({"README.md", "read " + folder}).size(), 1u);
    EXPECT_EQ(machine_path_faults({"tests/x.cpp", "read(\"" + folder + "\")"}).size(), 1u);
    EXPECT_EQ(machine_path_faults({"README.md", "see example.org" + folder}).size(), 0u);
    EXPECT_EQ(module_faults(small_graph, {"core/fem", "core/helpers", "ui/panels"}).size(), 1u);
}

}  // namespace
}  // namespace myo::test
