#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace myo::measurement {

/// Positions of one marker as an affine map of the principal motions of the others.
///
/// The motions are those of the samples in which all other markers are visible; where some are hidden, the visible ones
/// give the coordinates along these motions. Markers hidden in half of the marker's samples take no part.
/// Source: Federolf 2013 for principal components of marker motions; Rousseeuw 1984 for trimmed squares.
class MarkerPredictor {
public:
    /// @param tracks   one per marker, 3 x T [m], NaN where occluded; must outlive the object
    /// @param sigma_m  standard deviation of the noise per coordinate; 0 if unknown
    /// @param without  markers that take no part
    MarkerPredictor(const std::vector<Eigen::Matrix3Xd>& tracks, std::size_t marker, double sigma_m,
                    const std::vector<std::size_t>& without = {});

    /// Whether at least two other markers predict it.
    bool is_usable() const { return modes_.rows() > 0; }
    /// Samples in which the marker is visible and predicted, ascending.
    const std::vector<Eigen::Index>& samples() const { return samples_; }

    /// A fitted map.
    struct Fit {
        Eigen::MatrixXd map;         // (modes + 1) x 3
        Eigen::MatrixXd covariance;  // inverse of the normal matrix
        double largest_m = 0.0;      // distance among the fitted samples
        double rms_m = 0.0;          // of their distances
    };
    /// Least squares over all samples outside the places [first, end); empty if these are too few.
    ///
    /// @param trimmed  leaves out the quarter of the samples that fit worst
    std::optional<Fit> fit(std::size_t first = 0, std::size_t end = 0, bool trimmed = true) const;

    /// Sample at a place minus its prediction [m].
    Eigen::Vector3d residual(const Fit& fit, std::size_t place) const;
    double distance(const Fit& fit, std::size_t place) const { return residual(fit, place).norm(); }
    /// Factor by which the error of a prediction grows with its distance from the fitted samples: sqrt(1 + leverage).
    double widening(const Fit& fit, std::size_t place) const;
    /// Largest distance of another marker from the principal motions [m]: what these leave unexplained in a sample.
    double unexplained_m(std::size_t place) const { return unexplained_m_[place]; }

private:
    bool set_motions(const std::vector<Eigen::Matrix3Xd>& tracks, double sigma_m);
    void add_sample(const std::vector<Eigen::Matrix3Xd>& tracks, Eigen::Index t, std::vector<double>& modes);

    const Eigen::Matrix3Xd& track_;
    std::vector<std::size_t> others_;
    Eigen::VectorXd mean_m_;     // of the others' coordinates
    Eigen::MatrixXd motions_;    // principal motions, orthonormal columns
    Eigen::VectorXd amplitude_;  // standard deviation along them [m]
    std::vector<Eigen::Index> samples_;
    Eigen::MatrixXd modes_;   // (modes + 1) x samples: coordinates of unit variance, and ones
    Eigen::MatrixXd places_;  // 3 x samples [m]
    std::vector<double> unexplained_m_;
};

}  // namespace myo::measurement
