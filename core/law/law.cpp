#include "law/law.hpp"

#include <cctype>

#include "base/text.hpp"
#include "law/program.hpp"

namespace myo::law {
namespace {

using Part = LawError::Part;

/// Assigns variables and reads the texts of a law in their order.
class Maker {
public:
    explicit Maker(const LawText& text) : text_(text) { law_.place = text.place; }

    /// Throws LawError. The order matters: definitions may use parameters, conditions and states; the texts of states
    /// and the result may use definitions.
    Law made() {
        add_places();
        next_ = Variable::first_free;
        for (std::size_t i = 0; i < text_.parameters.size(); ++i) add_parameter(i);
        for (std::size_t i = 0; i < text_.conditions.size(); ++i) add_condition(i);
        for (std::size_t i = 0; i < text_.states.size(); ++i) add_state(i);
        for (std::size_t i = 0; i < text_.definitions.size(); ++i) add_definition(i);
        for (std::size_t i = 0; i < text_.states.size(); ++i) read_state(i);
        read_result();
        law_.variable_count = next_;
        return std::move(law_);
    }

private:
    [[noreturn]] static void fail(Part part, std::size_t index, const std::string& sentence, std::size_t column = 0) {
        throw LawError{part, index, {column, sentence}};
    }

    /// Vector of three consecutive variables.
    Quantity vector_of(int first, const char* unit) {
        Quantity quantity{Shape::vector, {}, unit_from_words(unit)};
        for (int i = 0; i < 3; ++i) quantity.nodes[static_cast<std::size_t>(i)] = law_.expressions.variable(first + i);
        return quantity;
    }
    Quantity number_of(int variable, const std::optional<Unit>& unit) {
        return {Shape::number, {law_.expressions.variable(variable), -1, -1}, unit};
    }

    /// The names that every law of this place has.
    /// Section 2 of assets/manual/laws.md lists them. A name that has no meaning at a place is left out, so that its
    /// use is an error of the expression.
    void add_places() {
        names_["t"] = number_of(Variable::t, unit_from_words("s"));
        names_["session_time"] = number_of(Variable::session_time, unit_from_words("s"));
        if (text_.place == Place::signal) {
            names_["a"] = number_of(Variable::a, std::nullopt);
            names_["rate"] = number_of(Variable::rate, std::nullopt);
            return;
        }
        names_["x"] = vector_of(Variable::x, "m");
        if (text_.place == Place::camera) return;
        names_["X"] = vector_of(Variable::X, "m");
        names_["v"] = vector_of(Variable::v, "m/s");
        names_["gravity"] = vector_of(Variable::gravity, "m/s2");
        Quantity u = names_["x"];
        for (std::size_t i = 0; i < 3; ++i) u.nodes[i] = law_.expressions.subtract(u.nodes[i], names_["X"].nodes[i]);
        names_["u"] = u;
        if (text_.place == Place::volume) return;
        names_["n"] = vector_of(Variable::n, "");
        if (text_.place != Place::point) names_["area_ratio"] = number_of(Variable::area_ratio, Unit{});
    }

    /// Throws unless the name is a word that has no meaning yet.
    void need_new(const std::string& name, Part part, std::size_t index) const {
        bool is_word = !name.empty() && std::isdigit(static_cast<unsigned char>(name.front())) == 0;
        for (const char c : name) is_word = is_word && (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_');
        if (!is_word)
            fail(part, index, "\"" + name + "\" is no name: letters, digits and underscores make one, no digit first");
        if (is_reserved(name) || names_.count(name) > 0)
            fail(part, index, "the name \"" + name + "\" has a meaning already");
    }

    /// Throws if the name ends in a unit with a prefix, as gap_mm: its value would be read in SI units.
    void need_plain_ending(const std::string& name, Part part, std::size_t index) const {
        const std::string ending = prefixed_ending(name);
        if (!ending.empty())
            fail(part, index,
                 "the name \"" + name + "\" ends in " + ending +
                     ", but laws take SI units without prefixes: m, Pa, N, s");
    }

    /// Unit from words; throws where unit_from_words() has no result.
    std::optional<Unit> unit_of(const std::string& words, Part part, std::size_t index) const {
        const std::optional<Unit> unit = unit_from_words(words);
        if (!unit)
            fail(part, index,
                 "\"" + words + "\" is not a unit; SI units without prefixes are known, and rad for angles");
        return unit;
    }

    void add_parameter(std::size_t index) {
        const LawText::Parameter& declared = text_.parameters[index];
        need_new(declared.name, Part::parameter, index);
        need_plain_ending(declared.name, Part::parameter, index);
        // The declared unit goes before that of the name. The unit of a signal is not known here and fits everywhere.
        const std::string words = declared.unit.value_or(unit_of_name(declared.name));
        const std::optional<Unit> unit = words == "signal" ? std::nullopt : unit_of(words, Part::parameter, index);
        Law::Parameter parameter{declared.name, declared.shape, next_};
        next_ += parameter.count();
        names_[declared.name] = parameter.shape == Shape::vector ? vector_of(parameter.variable, "")
                                                                 : number_of(parameter.variable, unit);
        names_[declared.name].unit = unit;
        law_.parameters.push_back(std::move(parameter));
    }

    void add_condition(std::size_t index) {
        const std::string& name = text_.conditions[index];
        need_new(name, Part::condition, index);
        law_.conditions.push_back({name, next_});
        // A condition whose name ends in no unit fits everywhere.
        const std::string words = unit_of_name(name);
        names_[name] = number_of(next_++, words.empty() ? std::nullopt : unit_from_words(words));
    }

    void add_state(std::size_t index) {
        const LawText::State& declared = text_.states[index];
        need_new(declared.name, Part::state, index);
        need_plain_ending(declared.name, Part::state, index);
        const std::string words = declared.unit.value_or(unit_of_name(declared.name));
        // A state without a unit in its name may have that of the signal: any unit fits.
        const bool is_open = words.empty() || words == "signal";
        law_.states.push_back({declared.name, next_, -1, -1});
        names_[declared.name] = number_of(next_++, is_open ? std::nullopt : unit_of(words, Part::state, index));
    }

    void add_definition(std::size_t index) {
        const std::string& text = text_.definitions[index];
        const std::size_t sign = text.find('=');
        if (sign == std::string::npos || sign == 0)
            fail(Part::definition, index, "a definition is written \"name = expression\"");
        // The name is what stands before the first "=", without white space around it.
        const std::size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t", sign - 1);
        const std::string name = first < sign && last != std::string::npos ? text.substr(first, last + 1 - first) : "";
        need_new(name, Part::definition, index);
        std::variant<Quantity, ExpressionError> result = parsed(std::string_view(text).substr(sign + 1), names_,
                                                                law_.expressions);
        if (const auto* const error = std::get_if<ExpressionError>(&result))
            fail(Part::definition, index, error->sentence, error->column + sign + 1);
        Quantity quantity = std::get<Quantity>(result);
        // A name that ends in a unit says what it should be.
        const std::string words = unit_of_name(name);
        const std::optional<Unit> named = words.empty() ? std::nullopt : unit_from_words(words);
        if (named && quantity.unit && *named != *quantity.unit && !is_zero(quantity, law_.expressions))
            fail(Part::definition, index,
                 "\"" + name + "\" has the unit " + to_string(*quantity.unit) + ", and its name says " +
                     to_string(*named),
                 sign + 1);
        if (named) quantity.unit = named;
        names_[name] = quantity;
    }

    /// Node of an expression that must be a number; its error becomes one of the law's part.
    Node read(const std::string& text, const std::optional<Unit>& unit, Part part, std::size_t index,
              const Names& names) {
        const auto result = parsed_as(text, names, Shape::number, unit, law_.expressions);
        if (const auto* const error = std::get_if<ExpressionError>(&result))
            fail(part, index, error->sentence, error->column);
        return std::get<Quantity>(result).node();
    }

    void read_state(std::size_t index) {
        const LawText::State& declared = text_.states[index];
        Law::State& state = law_.states[index];
        const std::optional<Unit> unit = names_[declared.name].unit;
        // At the start no state has a value yet.
        Names at_start = names_;
        for (const LawText::State& other : text_.states) at_start.erase(other.name);
        state.initial = read(declared.initial, unit, Part::state_initial, index, at_start);
        // Definitions keep their states.
        const Program initial(law_.expressions, {state.initial});
        for (const Law::State& other : law_.states)
            if (initial.uses(other.variable))
                fail(Part::state_initial, index,
                     "no state has a value at the start, and a definition in it uses \"" + other.name + "\"");
        // A rate has the unit of its state per second; without one it fits everywhere.
        state.rate = read(declared.rate, unit ? std::optional(*unit / *unit_from_words("s")) : std::nullopt,
                          Part::state_rate, index, names_);
    }

    void read_result() {
        // The unit follows from the key, such as Pa from traction_Pa; a law of a signal has that of the signal.
        const std::optional<Unit> unit = text_.key.unit.empty() ? std::nullopt : unit_from_words(text_.key.unit);
        const auto result = parsed_as(text_.result, names_, text_.key.shape, unit, law_.expressions);
        if (const auto* const error = std::get_if<ExpressionError>(&result))
            fail(Part::result, 0, error->sentence, error->column);
        law_.result = std::get<Quantity>(result).nodes;
        law_.is_energy = text_.key.is_energy;
        if (!law_.is_energy) return;
        // The force is -dE/dx at fixed velocity and normal: an energy of v, n or the area would give a wrong one. The
        // normal at a point is that at rest, and so a constant.
        const Program program(law_.expressions, {law_.result[0]});
        for (int i = 0; i < 3; ++i)
            if (program.uses(Variable::v + i) || (text_.place != Place::point && program.uses(Variable::n + i)) ||
                program.uses(Variable::area_ratio))
                fail(Part::result, 0, "an energy depends on places alone, not on v, n or area_ratio; state the force");
    }

    const LawText& text_;
    Law law_;
    Names names_;
    int next_ = 0;
};

}  // namespace

const std::vector<ResultKey>& result_keys(Place place) {
    static const std::vector<ResultKey> surface = {{"traction_Pa", Shape::vector, "Pa", false},
                                                   {"energy_J_per_m2", Shape::number, "J/m2", true}},
                                        point = {{"force_N", Shape::vector, "N", false},
                                                 {"energy_J", Shape::number, "J", true}},
                                        volume = {{"force_N_per_m3", Shape::vector, "N/m3", false},
                                                  {"energy_J_per_m3", Shape::number, "J/m3", true}},
                                        signal = {{"signal", Shape::number, "", false}},
                                        camera = {{"seen_m", Shape::vector, "m", false}};
    switch (place) {
        case Place::surface:
        case Place::clamp: return surface;
        case Place::point: return point;
        case Place::volume: return volume;
        case Place::signal: return signal;
        case Place::camera: return camera;
    }
    return surface;
}

int Law::number_count() const {
    int count = 0;
    for (const Parameter& parameter : parameters) count += parameter.count();
    return count;
}

std::variant<Law, LawError> make_law(const LawText& text) {
    try {
        return Maker(text).made();
    } catch (const LawError& error) {
        return error;
    }
}

bool has_choices(const Law& law) {
    for (std::size_t i = 0; i < law.expressions.size(); ++i)
        if (law.expressions.term(static_cast<Node>(i)).operation == Operation::choose) return true;
    return false;
}

}  // namespace myo::law
