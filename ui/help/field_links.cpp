#include "help/field_links.hpp"

#include <algorithm>
#include <string_view>

namespace myo::ui::help {

const std::vector<FieldLink>& field_links() {
    static const std::vector<FieldLink> links = [] {
        std::vector<FieldLink> all{{"model/material", "theory", "Every law except the projective one"},
                                   {"model/youngs_modulus", "theory", "\xce\xbc = E / (2 (1 + \xce\xbd))"},
                                   {"model/poissons_ratio", "theory", "\xce\xbc = E / (2 (1 + \xce\xbd))"},
                                   {"model/density", "theory", "M a = "},
                                   {"model/damping", "theory", "Kelvin\xe2\x80\x93Voigt damping acts"},
                                   {"model/integrator", "theory", "5. Integrators"},
                                   {"model/time_step", "theory", "A step ends at every jump"},
                                   {"model/spectral_radius", "theory", "by the spectral radius"},
                                   {"model/velocity_force", "theory", "adds energy. A body grows"},
                                   {"model/damping_frequency", "theory", "An integrator adds its own damping ratio"},
                                   {"model/", "theory", "Every law except the projective one"},  // parameters of laws
                                   {"body/element", "theory", "2. Elements"},
                                   {"body/resolution", "theory", "By default a body has about a thousand unknowns"},
                                   {"body/edge_length", "theory", "By default a body has about a thousand unknowns"},
                                   {"fibres/strength", "theory", "6. Muscles"},
                                   {"fibres/stiffness", "theory", "6. Muscles"},
                                   {"fibres/ratio", "theory", "6. Muscles"},
                                   {"fit/", "theory", "8. Inverse problem"},
                                   {"goal/", "experiment", "[[trial.goal]]: where a marker shall be"},
                                   {"obstacle/", "experiment", "[[obstacle]]: rigid, standing still"},
                                   {"part/", "experiment", "[[part]]: material of its own"},
                                   {"probe/standoff", "experiment", "max_standoff_m"},
                                   {"support/", "experiment", "[clamp]"},
                                   {"tendon/", "experiment", "[[tendon]]: a thread that pulls"},
                                   {"chamber/", "experiment", "[[chamber]]: a closed cavity under gauge pressure"},
                                   {"trial/", "experiment", "[[trial]]: at least one"},
                                   {"load/", "experiment", "[[trial.load]]"},
                                   {"effect/", "experiment", "[[effect]]: known or suspected additional physics"}};
        // Longer names first, so that a field's own link is found before that of its group.
        std::stable_sort(all.begin(), all.end(), [](const FieldLink& a, const FieldLink& b) {
            return std::string_view(a.field).size() > std::string_view(b.field).size();
        });
        return all;
    }();
    return links;
}

const FieldLink* link_of(const std::string& field) {
    const auto found = std::find_if(field_links().begin(), field_links().end(), [&](const FieldLink& link) {
        // An entry with a "/" at its end stands for all fields of a group.
        const std::string_view name = link.field;
        return field == name || (name.ends_with('/') && field.starts_with(name));
    });
    return found != field_links().end() ? &*found : nullptr;
}

}  // namespace myo::ui::help
