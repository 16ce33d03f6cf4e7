#include "architecture/definitions.hpp"

#include <algorithm>
#include <map>
#include <regex>

namespace myo::test {
namespace {

struct Token {
    std::string text;
    int line = 0;
};

/// Words, `::` and single signs of code without comments, literals and preprocessor lines.
std::vector<Token> tokens_of(const std::string& text) {
    const std::string code = code_only(text);
    std::vector<Token> tokens;
    int line = 1;
    bool line_start = true;
    for (std::size_t i = 0; i < code.size();) {
        const char c = code[i];
        if (c == '\n') {
            ++line;
            ++i;
            line_start = true;
        } else if (std::isspace(static_cast<unsigned char>(c))) {
            ++i;
        } else if (c == '#' && line_start) {
            while (i < code.size() && (code[i] != '\n' || code[i - 1] == '\\')) line += code[i++] == '\n' ? 1 : 0;
        } else {
            std::size_t end = i + 1;
            if (std::isalnum(static_cast<unsigned char>(c)) || c == '_')
                while (end < code.size() && (std::isalnum(static_cast<unsigned char>(code[end])) || code[end] == '_'))
                    ++end;
            else if (code.compare(i, 2, "::") == 0)
                ++end;
            tokens.push_back({code.substr(i, end - i), line});
            i = end;
            line_start = false;
        }
    }
    return tokens;
}

struct NamespaceBlock {
    std::string name;
    int line = 0;
    bool only_declares = true;  // classes and enumerations, without their bodies
};

struct Structure {
    std::vector<Definition> definitions;
    std::vector<NamespaceBlock> blocks;  // named ones
};

enum class ScopeKind { named, anonymous, other };
struct Scope {
    ScopeKind kind = ScopeKind::other;
    std::string name;
    std::size_t block = 0;  // of a named one
};

class Reader {
public:
    explicit Reader(const std::string& text) : tokens_(tokens_of(text)) {}

    Structure read() {
        while (at_ < tokens_.size()) step();
        return std::move(structure_);
    }

private:
    std::string at(std::size_t i) const { return i < tokens_.size() ? tokens_[i].text : std::string{}; }

    bool in_namespace() const {
        return std::all_of(scopes_.begin(), scopes_.end(), [](const Scope& s) { return s.kind != ScopeKind::other; });
    }
    bool is_anonymous() const {
        return std::any_of(scopes_.begin(), scopes_.end(),
                           [](const Scope& s) { return s.kind == ScopeKind::anonymous; });
    }
    std::string qualified(const std::string& name) const {
        std::string text;
        for (const Scope& scope : scopes_) text += scope.name + "::";
        return text + name;
    }

    void holds_more() {
        if (!scopes_.empty() && scopes_.back().kind == ScopeKind::named)
            structure_.blocks[scopes_.back().block].only_declares = false;
    }

    void step() {
        const std::string& word = tokens_[at_].text;
        if (word == "}") {
            if (!scopes_.empty()) scopes_.pop_back();
            ++at_;
        } else if (word == "{") {
            scopes_.push_back({});
            ++at_;
        } else if (word == "namespace" && in_namespace()) {
            open_namespace();
        } else if (in_namespace() && (word == "struct" || word == "class" || word == "enum")) {
            class_or_enumeration();
        } else {
            if (in_namespace() && word != ";") holds_more();
            ++at_;
        }
    }

    void open_namespace() {
        const int line = tokens_[at_].line;
        std::string name;
        for (++at_; at_ < tokens_.size() && at(at_) != "{" && at(at_) != "=" && at(at_) != ";"; ++at_) name += at(at_);
        if (at(at_) != "{") return;  // an alias
        ++at_;
        if (name.empty()) {
            holds_more();
            scopes_.push_back({ScopeKind::anonymous, "", 0});
            return;
        }
        if (!scopes_.empty()) holds_more();
        structure_.blocks.push_back({qualified(name), line, true});
        scopes_.push_back({ScopeKind::named, name, structure_.blocks.size() - 1});
    }

    /// `struct X {`, `class X final : public Y {`, `enum class X : int {`; `struct X;` declares only.
    void class_or_enumeration() {
        std::size_t i = at_ + 1;
        if (at(i) == "class" || at(i) == "struct") ++i;
        const std::string name = at(i);
        if (at(i + 1) == ";") {
            at_ = i + 2;
            return;
        }
        holds_more();
        const bool defines = at(i + 1) == "{" || at(i + 1) == ":" || at(i + 1) == "final";
        if (defines && !is_anonymous()) structure_.definitions.push_back({qualified(name), tokens_[at_].line});
        at_ = i + 1;
        if (!defines) return;
        while (at_ < tokens_.size() && at(at_) != "{" && at(at_) != ";") ++at_;
    }

    std::vector<Token> tokens_;
    std::size_t at_ = 0;
    std::vector<Scope> scopes_;
    Structure structure_;
};

bool is_source(const std::string& path) {
    return path.size() > 4 && (path.ends_with(".cpp") || path.ends_with(".hpp"));
}

std::string own_namespace(const Module& module) {
    if (module.name == "base") return "myo";
    return module.folder == "ui" ? "myo::ui::" + module.name : "myo::" + module.name;
}

}  // namespace

std::vector<Definition> definitions_of(const SourceFile& file) { return Reader(file.text).read().definitions; }

std::vector<Fault> definition_faults(const std::vector<SourceFile>& files) {
    std::map<std::string, std::string> first;
    std::vector<Fault> faults;
    for (const SourceFile& file : files) {
        if (!is_source(file.path) || file.path.starts_with("tests/")) continue;
        for (const Definition& definition : definitions_of(file)) {
            const std::string place = file.path + ":" + std::to_string(definition.line);
            const auto [other, is_first] = first.try_emplace(definition.name, place);
            if (!is_first) faults.push_back(place + ": defines " + definition.name + ", as " + other->second + " does");
        }
    }
    return faults;
}

std::vector<Fault> namespace_faults(const ModuleGraph& graph, const SourceFile& file) {
    const Module* const module = module_of(graph, file.path);
    if (!module || !is_source(file.path)) return {};
    const std::string own = own_namespace(*module);
    std::vector<Fault> faults;
    for (const NamespaceBlock& block : Reader(file.text).read().blocks) {
        if (!block.name.starts_with("myo")) continue;  // specialisations of a library's templates
        const bool inside = block.name == own || block.name.starts_with(own + "::");
        if (!inside && !block.only_declares)
            faults.push_back(file.path + ":" + std::to_string(block.line) + ": opens " + block.name + ", not " + own);
    }
    return faults;
}

}  // namespace myo::test
