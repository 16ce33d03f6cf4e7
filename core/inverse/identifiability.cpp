#include "inverse/identifiability.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "base/decompositions.hpp"
#include "base/text.hpp"
#include "inverse/least_squares.hpp"

namespace myo::inverse {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

const Parameter& at(const std::vector<Parameter>& parameters, Index i) {
    return parameters[static_cast<std::size_t>(i)];
}

/// Change of the residuals if each parameter changes by its scale; 0 for fixed parameters.
VectorXd influence(const std::vector<Parameter>& parameters, const MatrixXd& J) {
    VectorXd norms(J.cols());
    for (Index i = 0; i < J.cols(); ++i)
        norms(i) = at(parameters, i).is_fixed() ? 0.0 : at(parameters, i).scale * J.col(i).norm();
    return norms;
}

/// Connected groups in the null space: the projector P couples parameters whose changes compensate each other.
std::vector<std::vector<Index>> connected(const MatrixXd& P, double least) {
    std::vector<std::vector<Index>> groups;
    std::vector<bool> taken(static_cast<std::size_t>(P.rows()), false);
    for (Index i = 0; i < P.rows(); ++i) {
        if (taken[static_cast<std::size_t>(i)] || P(i, i) < least) continue;
        std::vector<Index> group{i};
        taken[static_cast<std::size_t>(i)] = true;
        for (std::size_t k = 0; k < group.size(); ++k)
            for (Index j = 0; j < P.rows(); ++j) {
                if (taken[static_cast<std::size_t>(j)] || P(j, j) < least || std::abs(P(group[k], j)) < least) continue;
                taken[static_cast<std::size_t>(j)] = true;
                group.push_back(j);
            }
        std::sort(group.begin(), group.end());
        groups.push_back(std::move(group));
    }
    return groups;
}

/// Description of a connected group.
///
/// @param P        projector onto the null space, in units of the column norms
/// @param lengths  column norms of the parameters in P
/// @param seen     indices of these parameters
Undetermined undetermined_group(const MatrixXd& P, const VectorXd& lengths, const std::vector<Index>& group,
                                const std::vector<Index>& seen) {
    Undetermined result;
    for (const Index i : group) result.parameters.push_back(seen[static_cast<std::size_t>(i)]);
    const SymmetricEigen own = symmetric_eigen(P(group, group));
    // The trace of a projector is its rank: the number of combinations not determined.
    result.combinations = static_cast<Index>(group.size()) - static_cast<Index>(std::lround(own.values.sum()));
    // With one determined combination, its gradient is the direction orthogonal to the null space.
    if (result.combinations == 1) result.gradient = own.vectors.col(0).cwiseProduct(lengths(group));
    return result;
}

/// "a · b^2 / c" with exponents relative to the first.
std::string powers(const std::vector<Parameter>& parameters, const std::vector<Index>& members,
                   const VectorXd& exponents) {
    std::string text;
    for (std::size_t k = 0; k < members.size(); ++k) {
        const double e = exponents(static_cast<Index>(k)) / exponents(0);
        text += k == 0 ? "" : e < 0.0 ? " / " : " · ";
        text += at(parameters, members[k]).name;
        if (const std::string power = format_number(std::abs(e), 2); power != "1") text += "^" + power;
    }
    return text;
}

/// "a + 2 b - c" with weights relative to the first.
std::string sum(const std::vector<Parameter>& parameters, const std::vector<Index>& members, const VectorXd& weights) {
    std::string text;
    for (std::size_t k = 0; k < members.size(); ++k) {
        const double w = weights(static_cast<Index>(k)) / weights(0);
        text += k == 0 ? "" : w < 0.0 ? " - " : " + ";
        if (const std::string factor = format_number(std::abs(w), 2); factor != "1") text += factor + " ";
        text += at(parameters, members[k]).name;
    }
    return text;
}

/// Text of the determined combination. For positive parameters the relative gradient gives the exponents.
std::string combination(const std::vector<Parameter>& parameters, const Undetermined& group, const VectorXd& values) {
    const auto& members = group.parameters;
    const bool positive = std::all_of(members.begin(), members.end(),
                                      [&](Index i) { return at(parameters, i).lower >= 0.0 && values(i) > 0.0; });
    return positive ? powers(parameters, members, group.gradient.cwiseProduct(values(members)))
                    : sum(parameters, members, group.gradient);
}

}  // namespace

std::vector<bool> without_influence(const std::vector<Parameter>& parameters, const MatrixXd& J,
                                    const IdentifiabilityPolicy& policy) {
    assert(J.cols() == static_cast<Index>(parameters.size()));
    const VectorXd size = influence(parameters, J);
    const double least = size.size() > 0 ? policy.derivative_accuracy * size.maxCoeff() : 0.0;
    std::vector<bool> flat;
    for (Index i = 0; i < size.size(); ++i) flat.push_back(!at(parameters, i).is_fixed() && !(size(i) > least));
    return flat;
}

std::vector<Index> sufficient_parameters(const std::vector<Parameter>& parameters, const MatrixXd& J,
                                         const std::vector<Index>& first, const IdentifiabilityPolicy& policy) {
    const std::vector<bool> flat = without_influence(parameters, J, policy);
    MatrixXd rest = J;  // parts of the columns orthogonal to the chosen ones
    std::vector<Index> chosen, open;
    const auto take_out = [&](Index i) {
        const double length = rest.col(i).norm();
        if (!(length > 0.0)) return;
        const VectorXd direction = rest.col(i) / length;
        // Two passes of Gram-Schmidt, because one loses orthogonality for nearly dependent columns.
        for (int pass = 0; pass < 2; ++pass) rest -= direction * (direction.transpose() * rest);
    };
    for (Index i = 0; i < J.cols(); ++i) {
        if (std::find(first.begin(), first.end(), i) != first.end())
            chosen.push_back(i);
        else if (!at(parameters, i).is_fixed() && !flat[static_cast<std::size_t>(i)])
            open.push_back(i);
    }
    for (const Index i : chosen) take_out(i);
    while (true) {
        std::erase_if(open,
                      [&](Index i) { return !(rest.col(i).norm() > policy.derivative_accuracy * J.col(i).norm()); });
        if (open.empty()) break;
        const auto most = std::max_element(open.begin(), open.end(), [&](Index a, Index b) {
            return at(parameters, a).scale * rest.col(a).norm() < at(parameters, b).scale * rest.col(b).norm();
        });
        const Index next = *most;
        open.erase(most);
        chosen.push_back(next);
        take_out(next);
    }
    std::sort(chosen.begin(), chosen.end());
    return chosen;
}

Identifiability identifiability(const std::vector<Parameter>& parameters, const MatrixXd& J, double variance,
                                const IdentifiabilityPolicy& policy) {
    const Index n = J.cols();
    Identifiability result{
        VectorXd::Constant(n, std::numeric_limits<double>::quiet_NaN()), MatrixXd::Identity(n, n), {}};
    const std::vector<bool> flat = without_influence(parameters, J, policy);
    std::vector<Index> seen;
    for (Index i = 0; i < n; ++i) {
        if (at(parameters, i).is_fixed())
            result.deviations(i) = 0.0;
        else if (flat[static_cast<std::size_t>(i)])
            result.undetermined.push_back({{i}, 0, {}});
        else
            seen.push_back(i);
    }
    if (seen.empty()) return result;

    // Normalised columns: eigenvalues of J'J then measure linear dependence only.
    MatrixXd unit = J(Eigen::all, seen);
    const VectorXd lengths = unit.colwise().norm();
    unit.array().rowwise() /= lengths.transpose().array();
    const SymmetricEigen eigen = symmetric_eigen(unit.transpose() * unit);
    // Eigenvalues are squared singular values.
    const double least = policy.derivative_accuracy * policy.derivative_accuracy * eigen.values.tail(1)(0);
    Index unseen = 0;
    while (unseen < eigen.values.size() && !(eigen.values(unseen) > least)) ++unseen;
    const MatrixXd null = eigen.vectors.leftCols(unseen), rest = eigen.vectors.rightCols(eigen.values.size() - unseen);
    const MatrixXd P = null * null.transpose();
    std::vector<bool> determined(seen.size(), true);
    for (const std::vector<Index>& group : connected(P, policy.participation * policy.participation)) {
        result.undetermined.push_back(undetermined_group(P, lengths, group, seen));
        for (const Index i : group) determined[static_cast<std::size_t>(i)] = false;
    }
    const MatrixXd covariance = variance * rest * eigen.values.tail(rest.cols()).cwiseInverse().asDiagonal() *
                                rest.transpose();
    const VectorXd deviation = covariance.diagonal().cwiseSqrt();
    for (std::size_t a = 0; a < seen.size(); ++a) {
        if (!determined[a]) continue;
        const auto i = static_cast<Index>(a);
        result.deviations(seen[a]) = deviation(i) / lengths(i);
        for (std::size_t b = 0; b < a; ++b) {
            if (!determined[b]) continue;
            const auto j = static_cast<Index>(b);
            result.correlation(seen[a], seen[b]) = result.correlation(seen[b], seen[a]) = covariance(i, j) /
                                                                                          (deviation(i) * deviation(j));
        }
    }
    return result;
}

std::string undetermined_reason(const std::vector<Parameter>& parameters, const std::vector<Undetermined>& undetermined,
                                const VectorXd& values, Index parameter) {
    for (const Undetermined& group : undetermined) {
        const auto& members = group.parameters;
        if (std::find(members.begin(), members.end(), parameter) == members.end()) continue;
        if (members.size() == 1) return "it has no influence on the data";
        std::vector<std::string> others;
        for (const Index i : members)
            if (i != parameter) others.push_back(at(parameters, i).name);
        const std::string among = join(others, ", ");
        if (group.combinations == 1)
            return "the data determine only its combination with " + among + ": " +
                   combination(parameters, group, values);
        return "the data determine only " + std::to_string(group.combinations) + " combinations of it with " + among;
    }
    return {};
}

}  // namespace myo::inverse
