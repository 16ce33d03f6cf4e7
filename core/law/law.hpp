#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "law/parser.hpp"

namespace myo::law {

/// Where a law acts.
/// Forces act on the free surface, a point of it, the volume, or the clamped faces; `signal` replaces the actuation,
/// `camera` the seen positions. Section 2 of assets/manual/laws.md states the names and keys of each.
enum class Place { surface, point, volume, clamp, signal, camera };

/// Numbers of the variables of a law; those of parameters, states and conditions follow.
/// A vector takes three consecutive numbers. All vectors are in the mesh frame.
struct Variable {
    static constexpr int x = 0;              // place now [m], 3
    static constexpr int v = 3;              // velocity [m/s], 3
    static constexpr int X = 6;              // place at rest [m], 3
    static constexpr int n = 9;              // outward unit normal now, 3
    static constexpr int area_ratio = 12;    // area now over area at rest
    static constexpr int t = 13;             // time of the trial [s]
    static constexpr int gravity = 14;       // [m/s2], 3
    static constexpr int session_time = 17;  // of the trial within the session [s]
    static constexpr int a = 18;             // signal less its passive value
    static constexpr int rate = 19;          // slope of a [1/s]
    static constexpr int first_free = 20;
};

/// A key by which a law states what it does, and what its expression must be.
struct ResultKey {
    std::string key;  // with its unit
    Shape shape;
    std::string unit;  // words; empty: that of the signal, which is not checked
    bool is_energy = false;
};
/// Keys of a place; a law has one of them.
/// The file of a law states one of them, such as traction_Pa of a surface.
const std::vector<ResultKey>& result_keys(Place place);

/// A law as it is written in its file, before any expression is read.
struct LawText {
    struct Parameter {
        std::string name;
        Shape shape = Shape::number;
        std::optional<std::string> unit;  // words, "signal" for that of the signal; empty: from the name's ending
    };
    struct State {
        std::string name, initial, rate;
        std::optional<std::string> unit;
    };
    Place place = Place::surface;
    // Names must be new within the law, across parameters, conditions, states and definitions.
    std::vector<Parameter> parameters;
    std::vector<std::string> conditions;   // names of test conditions of the trials
    std::vector<std::string> definitions;  // "name = expression", each may use those before it
    std::vector<State> states;
    ResultKey key;
    std::string result;
};

/// A law that can be evaluated. Its terms are complete but for derivatives, which are added when programs are made.
/// Variables are numbered by Variable; those of parameters, conditions and states follow from first_free on.
struct Law {
    struct Parameter {
        std::string name;
        Shape shape = Shape::number;
        int variable = 0;  // first of one, or of three
        int count() const { return shape == Shape::vector ? 3 : 1; }
    };
    struct State {
        std::string name;
        int variable = 0;
        Node initial = -1;
        Node rate = -1;  // [1/s] times the unit of the state
    };
    struct Condition {
        std::string name;
        int variable = 0;
    };
    Place place = Place::surface;
    Expressions expressions;
    std::vector<Parameter> parameters;
    std::vector<State> states;
    std::vector<Condition> conditions;
    bool is_energy = false;
    std::array<Node, 3> result{-1, -1, -1};  // force, traction, place; the first alone of an energy or a signal
    // Length of the vector of variable values that programs of this law take.
    int variable_count = 0;

    /// Sum of the components of all parameters: length of the vector of their values.
    int number_count() const;
};

/// What is wrong with a law: in which text, and where in it.
/// ExpressionError::column counts in that text; for a definition it counts from the beginning of "name = ...".
struct LawError {
    enum class Part { parameter, condition, definition, state, state_initial, state_rate, result };
    Part part = Part::result;
    std::size_t index = 0;  // of the parameter, definition or state
    ExpressionError error;
};

/// Reads all expressions of a law and checks names, shapes and units.
/// @param text  `key` is one of result_keys() of its place
/// @return      the law, or the first error; nothing is thrown
std::variant<Law, LawError> make_law(const LawText& text);

/// Whether the program of a law chooses between values anywhere, so that its slopes may jump.
/// Solvers then expect corners. Also true if the choice is in a term that the result does not use.
bool has_choices(const Law& law);

}  // namespace myo::law
