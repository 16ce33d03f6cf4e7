#include "architecture/module_graph.hpp"

#include <functional>
#include <regex>
#include <sstream>
#include <string_view>

namespace myo::test {
namespace {

// Constant from the start: graphs are read before main().
constexpr std::string_view library_prefix = "myoloop_";

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

std::string without_comments(const std::string& text) { return std::regex_replace(text, std::regex("#[^\n]*"), ""); }

void add_links(Module& module, const std::vector<std::string>& words) {
    for (const std::string& word : words)
        if (word.rfind(library_prefix, 0) == 0) module.links.insert(word.substr(library_prefix.size()));
}

/// `myoloop_module(name FOLDER f HEADERS h LINK a b)`.
Module declared_module(const std::vector<std::string>& words) {
    Module module{words.front(), "core", {}, {}};
    for (std::size_t i = 1; i + 1 < words.size(); ++i)
        if (words[i] == "FOLDER") module.folder = words[i + 1];
    add_links(module, {words.begin() + 1, words.end()});
    return module;
}

void find_all_reached(ModuleGraph& graph) {
    for (auto& [name, from] : graph) {
        std::set<std::string>& reaches = from.reaches;
        const std::function<void(const std::string&)> visit = [&](const std::string& other) {
            if (!reaches.insert(other).second) return;
            if (const auto found = graph.find(other); found != graph.end())
                for (const std::string& link : found->second.links) visit(link);
        };
        visit(name);
    }
}

}  // namespace

ModuleGraph read_module_graph(const std::vector<std::string>& cmake_files) {
    static const std::regex call(R"((myoloop_module|target_link_libraries)\s*\(([^)]*)\))");
    ModuleGraph graph{{"app", {"app", "app", {}, {}}}};
    std::vector<std::vector<std::string>> further_links;
    for (const std::string& file : cmake_files) {
        const std::string text = without_comments(file);
        for (std::sregex_iterator i(text.begin(), text.end(), call), end; i != end; ++i) {
            const std::vector<std::string> words = words_of((*i)[2]);
            if (words.empty() || words.front().find('$') != std::string::npos) continue;  // of a function's body
            if ((*i)[1] == "target_link_libraries")
                further_links.push_back(words);
            else if (words.front() != "name")
                graph[words.front()] = declared_module(words);
        }
    }
    for (const std::vector<std::string>& words : further_links) {
        const std::string target = words.front() == "myoloop" ? "app" : words.front();
        const auto found = graph.find(target.rfind(library_prefix, 0) == 0 ? target.substr(library_prefix.size())
                                                                           : target);
        if (found != graph.end()) add_links(found->second, {words.begin() + 1, words.end()});
    }
    for (auto& [name, module] : graph)
        std::erase_if(module.links, [&](const std::string& link) { return !graph.contains(link); });  // libraries
    find_all_reached(graph);
    return graph;
}

const Module* module_of(const ModuleGraph& graph, const std::string& path) {
    const std::size_t top = path.find('/');
    if (top == std::string::npos) return nullptr;
    const std::size_t next = path.find('/', top + 1);
    const std::string layer = path.substr(0, top);
    const std::string name = next == std::string::npos ? layer : path.substr(top + 1, next - top - 1);
    const auto found = graph.find(name);
    return found != graph.end() && found->second.folder == layer ? &found->second : nullptr;
}

std::vector<std::string> cycles(const ModuleGraph& graph) {
    std::vector<std::string> found;
    for (const auto& [name, module] : graph)
        for (const std::string& link : module.links)
            if (graph.at(link).reaches.contains(name)) found.push_back(name + " and " + link);
    return found;
}

}  // namespace myo::test
