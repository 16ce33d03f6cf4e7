#include "experiment/read_experiment_tables.hpp"

namespace myo::experiment {

std::vector<SensorDeclaration> read_sensors(const toml::TomlReader& document) {
    std::vector<SensorDeclaration> sensors;
    for (const toml::TomlReader& table : document.tables("sensor", {"name", "kind", "of", "noise"})) {
        SensorDeclaration sensor;
        sensor.name = table.name("name");
        if (sensor.name.find(',') != std::string::npos)
            table.fail("name", "heads columns of the sensors' file, so it must not hold a comma");
        sensor.kind = table.choice<SensorKind>("kind", {{"reaction", SensorKind::reaction},
                                                        {"chamber_volume", SensorKind::chamber_volume},
                                                        {"tendon_tension", SensorKind::tendon_tension},
                                                        {"tendon_shortening", SensorKind::tendon_shortening}});
        if (sensor.kind == SensorKind::reaction)
            table.reject("of", "belongs to sensors of a chamber or a tendon; a reaction is that of the support");
        else
            sensor.of = table.text("of");
        sensor.noise = table.number("noise", toml::positive());
        sensors.push_back(sensor);
    }
    return sensors;
}

}  // namespace myo::experiment
