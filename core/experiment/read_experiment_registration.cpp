#include "experiment/read_experiment_tables.hpp"

namespace myo::experiment {

RegistrationDeclaration read_registration(const toml::TomlReader& document, std::vector<std::string>& warnings) {
    RegistrationDeclaration declared;
    if (!document.has("registration")) return declared;
    const toml::TomlReader registration = document.table("registration",
                                                         {"known", "method", "max_translation_m", "max_rotation_deg"});
    declared.known = registration.boolean_or("known", true);
    if (declared.known)
        registration.reject("method", "has no meaning while the registration is known; write known = false");
    // `limited` has no word: it is what a registration without a method means.
    if (registration.has("method"))
        declared.method = registration.choice<RegistrationMethod>("method",
                                                                  {{"rest_pose", RegistrationMethod::rest_pose}});

    const bool limited = !declared.known && declared.method == RegistrationMethod::limited;
    // Limits are required exactly for method `limited`; otherwise they are accepted, ignored and reported.
    const auto limit = [&](const std::string& key, const toml::NumberRange& range) {
        if (limited && !registration.has(key))
            registration.fail(key, "required when known = false and no method is given");
        const double value = registration.number_or(key, 0.0, range);
        if (!limited && registration.has(key))
            warnings.push_back(registration.path_of(key) + ": ignored, the registration " +
                               (declared.known ? "is known" : "by rest pose has no limits"));
        return limited ? value : 0.0;
    };
    declared.max_translation_m = limit("max_translation_m", toml::not_negative());
    declared.max_rotation_deg = limit("max_rotation_deg", toml::between(0.0, 180.0));
    return declared;
}

}  // namespace myo::experiment
