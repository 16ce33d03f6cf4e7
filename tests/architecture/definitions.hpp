#pragma once

#include <vector>

#include "architecture/module_graph.hpp"
#include "architecture/source_rules.hpp"

namespace myo::test {

/// A class or an enumeration with its body, outside anonymous namespaces.
struct Definition {
    std::string name;  // "myo::report::Ticks"
    int line = 0;
};
std::vector<Definition> definitions_of(const SourceFile& file);

/// Classes and enumerations of one qualified name that several files define.
std::vector<Fault> definition_faults(const std::vector<SourceFile>& files);

/// Namespaces that a module's file opens for more than forward declarations and that are not the module's own:
/// `myo::<module>`, `myo::ui::<module>` in ui, `myo` in base.
std::vector<Fault> namespace_faults(const ModuleGraph& graph, const SourceFile& file);

}  // namespace myo::test
