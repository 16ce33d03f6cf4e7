#include "viewport/camera.hpp"

#include <gtest/gtest.h>

#include "viewport/color_map.hpp"
#include "viewport/view_overlay.hpp"

namespace myo::ui {
namespace {

const viewport::ViewSize view_size{800, 500};
const Box looked_at{{0.0, 0.0, 0.0}, {0.1, 0.03, 0.03}};

TEST(Camera, TargetFallsOnTheMiddle) {
    const viewport::Camera camera = viewport::fit({}, view_size, looked_at);
    const auto p = viewport::project(camera, view_size, camera.target);
    ASSERT_TRUE(p);
    EXPECT_NEAR(p->x(), 400.0, 1e-9);
    EXPECT_NEAR(p->y(), 250.0, 1e-9);
    EXPECT_NEAR(p->z(), camera.distance, 1e-12);
}

TEST(Camera, FitShowsEveryCornerFromEverySide) {
    for (double yaw = -3.0; yaw < 3.0; yaw += 0.7) {
        for (double pitch : {-1.5, -0.3, 0.9}) {
            viewport::Camera camera;
            camera.yaw = yaw;
            camera.pitch = pitch;
            for (const viewport::ViewSize& view : {view_size, viewport::ViewSize{300, 900}}) {
                camera = viewport::fit(camera, view, looked_at);
                for (int corner = 0; corner < 8; ++corner) {
                    const Eigen::Vector3d p((corner & 1) * 0.1, (corner >> 1 & 1) * 0.03, (corner >> 2) * 0.03);
                    const auto pixel = viewport::project(camera, view, p);
                    ASSERT_TRUE(pixel);
                    EXPECT_GT(pixel->x(), 0.0);
                    EXPECT_LT(pixel->x(), view.width);
                    EXPECT_GT(pixel->y(), 0.0);
                    EXPECT_LT(pixel->y(), view.height);
                }
            }
        }
    }
}

TEST(Camera, ZoomKeepsThePointUnderTheCursor) {
    const viewport::Camera before = viewport::fit({}, view_size, looked_at);
    const Eigen::Vector2d cursor(650.0, 120.0);
    const viewport::CameraAxes axes = viewport::camera_axes(before);
    const double scale = viewport::metres_per_pixel(before, view_size);
    const Eigen::Vector3d point = before.target + scale * (250.0 * axes.right + 130.0 * axes.up);
    const viewport::Camera after = viewport::zoom(before, view_size, 0.5, cursor);
    const auto pixel = viewport::project(after, view_size, point);
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(pixel->x(), cursor.x(), 1e-6);
    EXPECT_NEAR(pixel->y(), cursor.y(), 1e-6);
    EXPECT_NEAR(after.distance, 0.5 * before.distance, 1e-12);
}

TEST(Camera, PanMovesTheTargetPlaneWithTheMouse) {
    const viewport::Camera before = viewport::fit({}, view_size, looked_at);
    const auto pixel = viewport::project(viewport::pan(before, view_size, 30.0, -12.0), view_size, before.target);
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(pixel->x(), 430.0, 1e-6);
    EXPECT_NEAR(pixel->y(), 238.0, 1e-6);
}

TEST(Camera, StandardViewsLookAlongTheAxes) {
    const viewport::Camera camera = viewport::fit({}, view_size, looked_at);
    // From -y, x runs to the right and z upwards.
    const viewport::Camera side = viewport::turn_to(camera, viewport::StandardView::from_y);
    const auto origin = viewport::project(side, view_size, side.target);
    const auto along_x = viewport::project(side, view_size, side.target + Eigen::Vector3d(0.01, 0, 0));
    const auto along_z = viewport::project(side, view_size, side.target + Eigen::Vector3d(0, 0, 0.01));
    EXPECT_GT(along_x->x(), origin->x() + 1.0);
    EXPECT_NEAR(along_x->y(), origin->y(), 1e-9);
    EXPECT_LT(along_z->y(), origin->y() - 1.0);
    // From above, x right and y upwards.
    const viewport::Camera top = viewport::turn_to(camera, viewport::StandardView::from_z);
    EXPECT_GT(viewport::project(top, view_size, top.target + Eigen::Vector3d(0.01, 0, 0))->x(), 401.0);
    EXPECT_LT(viewport::project(top, view_size, top.target + Eigen::Vector3d(0, 0.01, 0))->y(), 249.0);
}

TEST(Camera, TheSameStandardViewAgainGoesToTheOtherSide) {
    const viewport::Camera camera = viewport::fit({}, view_size, looked_at);
    for (const viewport::StandardView view :
         {viewport::StandardView::from_x, viewport::StandardView::from_y, viewport::StandardView::from_z}) {
        const viewport::Camera once = viewport::turn_to_or_round(camera, view),
                               twice = viewport::turn_to_or_round(once, view);
        EXPECT_NEAR(viewport::camera_axes(once).back.dot(viewport::camera_axes(twice).back), -1.0, 1e-5);
        EXPECT_TRUE(viewport::turn_to_or_round(twice, view) == once);
    }
}

TEST(Camera, PointsBehindTheEyeHaveNoPixel) {
    const viewport::Camera camera = viewport::fit({}, view_size, looked_at);
    EXPECT_FALSE(viewport::project(camera, view_size,
                                   camera.target + 2.0 * camera.distance * viewport::camera_axes(camera).back));
}

/// Relative luminance of an sRGB colour, between 0 and 1 (IEC 61966-2-1).
double luminance(const Eigen::Vector3f& color) {
    const auto linear = [](float level) {
        return level <= 0.04045f ? level / 12.92f : std::pow((level + 0.055f) / 1.055f, 2.4f);
    };
    return static_cast<double>(0.2126f * linear(color[0]) + 0.7152f * linear(color[1]) + 0.0722f * linear(color[2]));
}

TEST(ColorMap, LightnessRises) {
    for (const viewport::ColorMap& map : viewport::color_maps()) {
        double last = -1.0;
        for (int i = 0; i <= 50; ++i) {
            const Eigen::Vector3f c = map.color(i / 50.0);
            const double light = luminance(c);
            EXPECT_GT(light, last) << map.id << " at " << i;
            last = light;
        }
    }
}

TEST(ScaleBar, IsANiceLengthThatFits) {
    for (double scale = 1e-6; scale < 1e-2; scale *= 1.37) {
        const viewport::ScaleBar bar = viewport::make_scale_bar(scale, 120.0, "m");
        EXPECT_LE(bar.pixels, 120.0 * (1.0 + 1e-9));
        EXPECT_GT(bar.pixels, 40.0);
        EXPECT_NEAR(bar.length, bar.pixels * scale, 1e-12);
    }
    EXPECT_EQ(viewport::make_scale_bar(0.2e-3, 120.0, "m").label, "20 mm");
    EXPECT_EQ(viewport::make_scale_bar(0.01e-3, 120.0, "m").label, "1 mm");
    EXPECT_EQ(viewport::make_scale_bar(0.001e-3, 120.0, "m").label, "100 \xc2\xb5m");
}

}  // namespace
}  // namespace myo::ui
