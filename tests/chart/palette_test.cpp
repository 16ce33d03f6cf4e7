#include "chart/palette.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <cmath>
#include <string>

namespace myo::chart {
namespace {

Eigen::Vector3d linear_rgb(std::string_view colour) {
    Eigen::Vector3d rgb;
    for (int i = 0; i < 3; ++i) {
        const double c = std::stoi(std::string(colour.substr(static_cast<std::size_t>(1 + 2 * i), 2)), nullptr, 16) /
                         255.0;
        rgb[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    }
    return rgb;
}

double luminance(const Eigen::Vector3d& rgb) { return Eigen::Vector3d(0.2126, 0.7152, 0.0722).dot(rgb); }

Eigen::Vector3d lab(Eigen::Vector3d rgb) {
    rgb = rgb.cwiseMax(0.0).cwiseMin(1.0);
    const Eigen::Vector3d xyz(Eigen::Vector3d(0.4124, 0.3576, 0.1805).dot(rgb) / 0.9505, luminance(rgb),
                              Eigen::Vector3d(0.0193, 0.1192, 0.9505).dot(rgb) / 1.089);
    const Eigen::Vector3d f = xyz.unaryExpr(
        [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; });
    return {116.0 * f[1] - 16.0, 500.0 * (f[0] - f[1]), 200.0 * (f[1] - f[2])};
}

TEST(Palette, StandsOutOnPaper) {
    for (const std::string_view colour : series_palette)
        EXPECT_GE(1.05 / (luminance(linear_rgb(colour)) + 0.05), 3.0) << colour;  // WCAG 2.1, graphical objects
    EXPECT_GE(1.05 / (luminance(linear_rgb(ink::quiet)) + 0.05), 4.5);            // small text
}

// Full protanopia, deuteranopia and tritanopia after Machado, Oliveira & Fernandes 2009.
TEST(Palette, StaysApartWithoutOneKindOfCone) {
    Eigen::Matrix3d protan, deutan, tritan;
    protan << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998;
    deutan << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881;
    tritan << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900;
    for (const Eigen::Matrix3d& vision : {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), protan, deutan, tritan})
        for (std::size_t i = 0; i < series_palette.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_GT(
                    (lab(vision * linear_rgb(series_palette[i])) - lab(vision * linear_rgb(series_palette[j]))).norm(),
                    30.0)
                    << series_palette[i] << " " << series_palette[j];
}

}  // namespace
}  // namespace myo::chart
