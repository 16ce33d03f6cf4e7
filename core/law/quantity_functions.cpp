#include <algorithm>

#include "base/text.hpp"
#include "law/quantities.hpp"

namespace myo::law {
namespace {

/// A function with a fixed number of arguments and their shapes; if(), min() and max() are read separately.
struct Function {
    std::string name;
    std::vector<Shape> arguments;
};

const std::vector<Function>& functions() {
    static const std::vector<Function> all = {
        {"sqrt", {Shape::number}},
        {"exp", {Shape::number}},
        {"log", {Shape::number}},
        {"sin", {Shape::number}},
        {"cos", {Shape::number}},
        {"tan", {Shape::number}},
        {"tanh", {Shape::number}},
        {"atan", {Shape::number}},
        {"abs", {Shape::number}},
        {"step", {Shape::number}},
        {"smooth_step", {Shape::number}},
        {"positive", {Shape::number, Shape::number}},
        {"pow", {Shape::number, Shape::number}},
        {"norm", {Shape::vector}},
        {"dot", {Shape::vector, Shape::vector}},
        {"cross", {Shape::vector, Shape::vector}},
    };
    return all;
}

/// Operation of a function that takes a plain number and gives one; nullopt for all others.
std::optional<Operation> plain_operation(std::string_view name) {
    if (name == "exp") return Operation::exponential;
    if (name == "log") return Operation::logarithm;
    if (name == "sin") return Operation::sine;
    if (name == "cos") return Operation::cosine;
    if (name == "tan") return Operation::tangent;
    if (name == "tanh") return Operation::hyperbolic_tangent;
    if (name == "atan") return Operation::arc_tangent;
    return std::nullopt;
}

}  // namespace

const std::vector<std::string>& function_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list{"if", "min", "max"};
        for (const Function& function : functions()) list.push_back(function.name);
        return list;
    }();
    return names;
}

Quantity Quantities::absolute(const Quantity& a) {
    return of(e_.make(Operation::choose, e_.make(Operation::less, a.node(), e_.constant(0.0)),
                      e_.make(Operation::negate, a.node()), a.node()),
              a.unit);
}

Quantity Quantities::dot(const Quantity& a, const Quantity& b) {
    Node sum = e_.constant(0.0);
    for (std::size_t i = 0; i < 3; ++i) sum = e_.add(sum, e_.multiply(a.nodes[i], b.nodes[i]));
    return of(sum, a.unit && b.unit ? std::optional(*a.unit * *b.unit) : std::nullopt);
}

Quantity Quantities::cross(const Quantity& a, const Quantity& b) {
    Quantity result{Shape::vector, {}, a.unit && b.unit ? std::optional(*a.unit * *b.unit) : std::nullopt};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
        result.nodes[i] = e_.subtract(e_.multiply(a.nodes[j], b.nodes[k]), e_.multiply(a.nodes[k], b.nodes[j]));
    }
    return result;
}

Quantity Quantities::root(const Quantity& a) {
    return of(e_.make(Operation::square_root, a.node()), a.unit ? std::optional(to_power(*a.unit, 0.5)) : std::nullopt);
}

/// s^power (first + second s + third s^2) between 0 and 1; 0 below, `above` from 1 on.
/// Used for steps without a jump, whose derivatives solvers and fits need.
Node Quantities::blended(Node s, int power, const std::array<double, 3>& factors, Node above) {
    const Node zero = e_.constant(0.0), one = e_.constant(1.0);
    Node rise = e_.constant(factors[2]);
    for (const double factor : {factors[1], factors[0]}) rise = e_.add(e_.multiply(rise, s), e_.constant(factor));
    for (int k = 0; k < power; ++k) rise = e_.multiply(rise, s);
    const Node up = e_.make(Operation::choose, e_.make(Operation::less, s, one), rise, above);
    return e_.make(Operation::choose, e_.make(Operation::less, s, zero), zero, up);
}

/// 10 s^3 - 15 s^4 + 6 s^5 between 0 and 1, twice continuously differentiable: the polynomial of least degree whose
/// first and second derivatives are 0 at both ends.
Quantity Quantities::smooth_step(const Quantity& a) {
    return of(blended(a.node(), 3, {10.0, -15.0, 6.0}, e_.constant(1.0)), Unit{});
}

/// Smooth max(0, a): the integral of smooth_step() over the width w about 0, three times continuously differentiable.
/// With s = a / w + 1/2: w (2.5 s^4 - 3 s^5 + s^6) between s = 0 and 1, and a above.
Quantity Quantities::positive(const Quantity& a, const Quantity& width, std::size_t column) {
    const std::optional<Unit> unit = common_unit(a, width, "positive()", column);
    const Node w = width.node(), share = e_.make(Operation::ratio, a.node(), w);
    return of(e_.multiply(w, blended(e_.add(share, e_.constant(0.5)), 4, {2.5, -3.0, 1.0}, share)), unit);
}

Quantity Quantities::extreme(bool largest, const std::vector<Quantity>& arguments, std::size_t column) {
    const std::string name = largest ? "max" : "min";
    if (arguments.size() < 2) throw ExpressionError{column, name + "() needs two numbers or more"};
    Quantity result = arguments.front();
    need(result, Shape::number, "what " + name + "() is given", column);
    for (std::size_t i = 1; i < arguments.size(); ++i) {
        const Quantity& next = arguments[i];
        need(next, Shape::number, "what " + name + "() is given", column);
        const std::optional<Unit> unit = common_unit(result, next, name + "()", column);
        // Among equal arguments max() keeps the earlier one and min() the later one, and with it its slope.
        const Node less = e_.make(Operation::less, result.node(), next.node());
        result = of(largest ? e_.make(Operation::choose, less, next.node(), result.node())
                            : e_.make(Operation::choose, less, result.node(), next.node()),
                    unit);
    }
    return result;
}

Quantity Quantities::choice(const std::vector<Quantity>& arguments, std::size_t column) {
    if (arguments.size() != 3) throw ExpressionError{column, "if() needs a condition and two values"};
    const Quantity &condition = arguments[0], &then = arguments[1], &other = arguments[2];
    need(condition, Shape::condition, "the first argument of if()", column);
    // The number 0 stands for the zero vector as well.
    const bool mixed = then.shape != other.shape;
    const auto stands_in = [&](const Quantity& a, const Quantity& vector_beside) {
        return a.shape == Shape::number && is_zero(a, e_) && vector_beside.shape == Shape::vector;
    };
    if (mixed && !stands_in(then, other) && !stands_in(other, then))
        throw ExpressionError{column, std::string("the two values of if() are ") + to_string(then.shape) + " and " +
                                          to_string(other.shape)};
    Quantity result{mixed ? Shape::vector : then.shape, {-1, -1, -1}, common_unit(then, other, "if()", column)};
    const auto part = [&](const Quantity& a, std::size_t i) { return a.shape == result.shape ? a.nodes[i] : a.node(); };
    for (std::size_t i = 0; i < (result.shape == Shape::vector ? 3u : 1u); ++i)
        result.nodes[i] = e_.make(Operation::choose, condition.node(), part(then, i), part(other, i));
    return result;
}

Quantity Quantities::call(std::string_view name, const std::vector<Quantity>& arguments, std::size_t column) {
    // Functions whose arguments have no fixed number or shapes come first, then the checks that all others share.
    if (name == "if") return choice(arguments, column);
    if (name == "max" || name == "min") return extreme(name == "max", arguments, column);
    const auto found = std::find_if(functions().begin(), functions().end(),
                                    [&](const Function& function) { return function.name == name; });
    const std::string words = std::string(name) + "()";
    if (found == functions().end()) {
        const std::string near = closest_word(name, function_names());
        throw ExpressionError{column, "no function " + words + " is known" +
                                          (near.empty() ? "; there are " + join(function_names())
                                                        : "; the closest one is " + near + "()")};
    }
    if (arguments.size() != found->arguments.size())
        throw ExpressionError{column, words + " takes " + std::to_string(found->arguments.size()) + " argument" +
                                          (found->arguments.size() > 1 ? "s" : "") + ", not " +
                                          std::to_string(arguments.size())};
    for (std::size_t i = 0; i < arguments.size(); ++i)
        need(arguments[i], found->arguments[i], "what " + words + " is given", column);
    const Quantity& a = arguments.front();
    if (const std::optional<Operation> operation = plain_operation(name)) {
        need_plain(a, "what " + words + " is given", column);
        return of(e_.make(*operation, a.node()), Unit{});
    }
    if (name == "sqrt") return root(a);
    if (name == "abs") return absolute(a);
    if (name == "norm") return root(dot(a, a));
    if (name == "dot") return dot(a, arguments[1]);
    if (name == "cross") return cross(a, arguments[1]);
    if (name == "positive") return positive(a, arguments[1], column);
    if (name == "pow") return power(a, arguments[1], column);
    if (name == "step")
        return of(e_.make(Operation::choose, e_.make(Operation::less, a.node(), e_.constant(0.0)), e_.constant(0.0),
                          e_.constant(1.0)),
                  Unit{});
    // Only smooth_step() is left.
    need_plain(a, "what " + words + " is given", column);
    return smooth_step(a);
}

}  // namespace myo::law
