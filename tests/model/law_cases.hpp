#pragma once

#include <gtest/gtest.h>

#include <string>

#include "model/law_force.hpp"

namespace myo::test {

/// Laws of forces for tests of their derivatives: their texts, and values of their numbers.
struct LawCase {
    law::LawText text;
    std::vector<double> numbers;
};

inline LawCase law_case(const std::string& name) {
    using law::Place;
    using law::Shape;
    LawCase c;
    const auto acts = [&](Place place, std::size_t key, const char* result) {
        c.text.place = place;
        c.text.key = law::result_keys(place)[key];
        c.text.result = result;
    };
    const auto number = [&](const char* parameter, double value) {
        c.text.parameters.push_back({parameter, Shape::number, {}});
        c.numbers.push_back(value);
    };
    if (name == "drag") {
        acts(Place::surface, 0, "-c_kg_m3 * norm(v) * v");
        number("c_kg_m3", 900.0);
    }
    if (name == "bed") {
        acts(Place::surface, 0, "-k_Pa_per_m * u - q_Pa_per_m3 * dot(u, u) * u");
        number("k_Pa_per_m", 3e5);
        number("q_Pa_per_m3", 1e11);
    }
    if (name == "bed_energy") {
        acts(Place::surface, 1, "0.5 * k_Pa_per_m * dot(u, u) + c_J_per_m2 * cos(norm(u) / 1e-3[m])");
        number("k_Pa_per_m", 3e5);
        number("c_J_per_m2", 0.5);
    }
    if (name == "wind") {
        acts(Place::surface, 0, "[0, p_Pa, 0.5 * p_Pa]");
        number("p_Pa", 30.0);
    }
    if (name == "stream") {
        acts(Place::surface, 0, "c_Pa_s_m * (0.3[m/s] * [1, 0, 0] - v)");
        number("c_Pa_s_m", 20.0);
    }
    if (name == "damper") {  // places and velocities
        acts(Place::surface, 0, "-k_Pa_per_m * u - c_Pa_s_m * v");
        number("k_Pa_per_m", 3e5);
        number("c_Pa_s_m", 20.0);
    }
    if (name == "pressure") {
        acts(Place::surface, 0, "-p_Pa * area_ratio * n * (1 + x.z / 0.1[m])");
        number("p_Pa", 4e3);
    }
    if (name == "wet_drag") {  // drag below a smooth level
        acts(Place::surface, 0, "-c_kg_m3 * norm(v) * v * smooth_step((level_m - x.z) / 0.1[m])");
        number("c_kg_m3", 900.0);
        number("level_m", 0.065);
    }
    if (name == "lift") {
        acts(Place::surface, 0, "c_Pa_s_m * cross([0, 0, 1], v) - d_Pa_s_m * dot(n, v) * n");
        number("c_Pa_s_m", 15.0);
        number("d_Pa_s_m", 25.0);
    }
    if (name == "point") {
        acts(Place::point, 0, "-k_N_m * u - c_N_s_per_m * v * exp(-norm(u) / 1e-3[m]) + f_N * n");
        number("k_N_m", 300.0);
        number("c_N_s_per_m", 2.0);
        number("f_N", 0.1);
    }
    if (name == "volume") {
        acts(Place::volume, 0, "wind_N_per_m3 * (1 + x.y / 0.1[m]) + rho_kg_m3 * gravity * sin(3 * t / 1[s])");
        c.text.parameters.push_back({"wind_N_per_m3", Shape::vector, {}});
        c.numbers = {1e3, 2e3, -500.0};
        number("rho_kg_m3", 500.0);
    }
    return c;
}

inline std::shared_ptr<const model::LawPrograms> compiled(const LawCase& c) {
    auto made = law::make_law(c.text);
    const auto* const error = std::get_if<law::LawError>(&made);
    EXPECT_EQ(error, nullptr) << (error ? error->error.sentence : "");
    return model::law_programs(
        std::get<law::Law>(std::move(made)),
        Eigen::Map<const Eigen::VectorXd>(c.numbers.data(), static_cast<Eigen::Index>(c.numbers.size())));
}

/// Element of a law on a body, at nodes of the given cell if it acts at a point.
inline model::ForceElementPointer law_element(const model::Body& body, const std::string& name, int cell) {
    const LawCase c = law_case(name);
    const auto programs = compiled(c);
    std::vector<model::LawCarrier> carriers = model::law_points_of_faces(body, model::free_faces(body));
    if (c.text.place == law::Place::volume) carriers = model::law_points_of_cells(body);
    if (c.text.place == law::Place::point) {
        const auto nodes = body.mesh.cells.col(cell);
        carriers = model::law_point(body, cell, {nodes.begin(), nodes.end()},
                                    Eigen::VectorXd::Constant(nodes.size(), 1.0 / static_cast<double>(nodes.size())),
                                    Eigen::Vector3d(1.0, 2.0, -0.5).normalized());
    }
    const Eigen::VectorXd numbers = Eigen::Map<const Eigen::VectorXd>(c.numbers.data(),
                                                                      static_cast<Eigen::Index>(c.numbers.size()));
    return model::law_force(programs, std::make_shared<const std::vector<model::LawCarrier>>(std::move(carriers)),
                            {{0.0, 1.0, -9.81}, 0.0, {}}, numbers, 0.1 * numbers.cwiseAbs());
}

}  // namespace myo::test
