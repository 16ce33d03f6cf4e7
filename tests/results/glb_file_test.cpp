#include "results/glb_file.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>

#include "base/files.hpp"
#include "report/json.hpp"
#include "support/folder.hpp"

namespace myo::results::glb_file_test {
namespace {

using report::Json;

/// A glb file read by the rules of its specification.
struct ReadGlb {
    Json json;
    std::string binary;

    explicit ReadGlb(const std::string& bytes) {
        const auto number = [&](std::size_t at) {
            std::uint32_t value = 0;
            for (std::size_t i = 0; i < 4; ++i)
                value += static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
            return value;
        };
        EXPECT_EQ(bytes.substr(0, 4), "glTF");
        EXPECT_EQ(number(4), 2u);
        EXPECT_EQ(number(8), bytes.size());
        const std::size_t text = number(12);
        EXPECT_EQ(bytes.substr(16, 4), "JSON");
        EXPECT_EQ(text % 4, 0u);
        json = Json::parse(bytes.substr(20, text));
        EXPECT_EQ(bytes.substr(24 + text, 4), std::string("BIN\0", 4));
        binary = bytes.substr(28 + text);
        EXPECT_EQ(number(20 + text), binary.size());
        EXPECT_EQ(json["buffers"][0]["byteLength"], binary.size());
    }

    const Json& primitive() const { return json["meshes"][0]["primitives"][0]; }

    /// Numbers of an accessor, which has as many as its view has room for.
    template <class Number>
    Eigen::Matrix<Number, 3, Eigen::Dynamic> triples(const Json& number, int component_type, int target) const {
        const Json& accessor = json["accessors"][number.get<std::size_t>()];
        const Json& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
        EXPECT_EQ(accessor["componentType"], component_type);
        EXPECT_EQ(view["target"], target);
        const bool vectors = accessor["type"] == "VEC3";
        const auto count = accessor["count"].get<Eigen::Index>();
        Eigen::Matrix<Number, 3, Eigen::Dynamic> values(3, vectors ? count : count / 3);
        const auto size = static_cast<std::size_t>(values.size()) * sizeof(Number);
        EXPECT_EQ(view["byteLength"], size);
        EXPECT_LE(view["byteOffset"].get<std::size_t>() + size, binary.size());
        std::memcpy(values.data(), binary.data() + view["byteOffset"].get<std::size_t>(), size);
        return values;
    }
    Eigen::Matrix3Xf attribute(const char* name) const {
        return triples<float>(primitive()["attributes"][name], 5126, 34962);
    }
};

/// Written to a folder of its own and read again.
ReadGlb written(const mesh::SurfaceMesh& surface, const Eigen::Matrix3Xf& colours = {}) {
    const test::Folder folder("glb_file");
    EXPECT_TRUE(write_glb(folder.path() / "body.glb", surface, colours));
    return ReadGlb(*read_file(folder.path() / "body.glb"));
}

/// Triangles of area 1 in the plane z = 0 and of area 3 in the plane y = 0, with a common edge, and a lonely vertex.
mesh::SurfaceMesh angle() {
    mesh::SurfaceMesh surface;
    surface.vertices.resize(3, 5);
    surface.vertices << 0, 1, 0, 0, 9, 0, 0, 2, 0, 9, 0, 0, 0, 6, -9;
    surface.triangles.resize(3, 2);
    surface.triangles << 0, 0, 1, 1, 2, 3;
    return surface;
}

TEST(GlbFile, HoldsTheSurfaceAsItIs) {
    const mesh::SurfaceMesh surface = mesh::box_surface({{-0.1, 0.0, 0.2}, {0.3, 0.05, 0.25}});
    const ReadGlb glb = written(surface);
    EXPECT_EQ(glb.attribute("POSITION"), surface.vertices.cast<float>());
    const auto indices = glb.triples<std::uint32_t>(glb.primitive()["indices"], 5125, 34963);
    EXPECT_EQ(indices.cast<int>(), surface.triangles);
    EXPECT_EQ(glb.primitive()["mode"], 4) << "triangles";
    EXPECT_EQ(glb.json["asset"]["version"], "2.0");
    // Bounds of the positions are demanded, and of these alone.
    const Json& positions = glb.json["accessors"][glb.primitive()["attributes"]["POSITION"].get<std::size_t>()];
    const Json& normals = glb.json["accessors"][glb.primitive()["attributes"]["NORMAL"].get<std::size_t>()];
    EXPECT_FALSE(normals.contains("min"));
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(positions["min"][static_cast<std::size_t>(i)].get<float>(),
                  glb.attribute("POSITION").row(i).minCoeff());
        EXPECT_EQ(positions["max"][static_cast<std::size_t>(i)].get<float>(),
                  glb.attribute("POSITION").row(i).maxCoeff());
    }
}

TEST(GlbFile, TurnsUpwardsFromZToY) {
    const Json rotation = written(angle()).json["nodes"][0]["rotation"];
    ASSERT_EQ(rotation.size(), 4u);
    // The format has x, y, z, w.
    const Eigen::Quaterniond turn(rotation[3].get<double>(), rotation[0].get<double>(), rotation[1].get<double>(),
                                  rotation[2].get<double>());
    EXPECT_NEAR(turn.norm(), 1.0, 1e-12);
    EXPECT_LT((turn * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitY()).norm(), 1e-12);
    EXPECT_LT((turn * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitX()).norm(), 1e-12);
}

TEST(GlbFile, NormalsAreMeansByArea) {
    const Eigen::Matrix3Xf normals = written(angle()).attribute("NORMAL");
    ASSERT_EQ(normals.cols(), 5);
    const Eigen::Vector3f both = Eigen::Vector3f(0.0f, -3.0f, 1.0f).normalized();
    for (const Eigen::Index shared : {0, 1}) EXPECT_LT((normals.col(shared) - both).norm(), 1e-6f) << shared;
    EXPECT_LT((normals.col(2) - Eigen::Vector3f::UnitZ()).norm(), 1e-6f);
    EXPECT_LT((normals.col(3) + Eigen::Vector3f::UnitY()).norm(), 1e-6f);
    EXPECT_NEAR(normals.col(4).norm(), 1.0f, 1e-6f) << "also where there is no triangle";
    // Normals of a closed body point outwards.
    const mesh::SurfaceMesh box = mesh::box_surface({{-1.0, -2.0, -3.0}, {1.0, 2.0, 3.0}});
    const Eigen::Matrix3Xf outward = written(box).attribute("NORMAL");
    for (Eigen::Index v = 0; v < outward.cols(); ++v) {
        EXPECT_NEAR(outward.col(v).norm(), 1.0f, 1e-6f);
        EXPECT_GT(outward.col(v).cwiseProduct(box.vertices.col(v).cast<float>()).minCoeff(), 0.0f) << v;
    }
}

TEST(GlbFile, ColoursAreLinear) {
    Eigen::Matrix3Xf colours(3, 5);
    colours << 0.0f, 1.0f, 0.5f, 0.04f, 0.2f, 0.0f, 1.0f, 0.5f, 0.04f, 0.4f, 0.0f, 1.0f, 0.5f, 0.04f, 0.8f;
    const ReadGlb glb = written(angle(), colours);
    const Eigen::Matrix3Xf shown = glb.attribute("COLOR_0");
    ASSERT_EQ(shown.cols(), 5);
    // IEC 61966-2-1: a line up to 0.04045, a power of 2.4 beyond.
    EXPECT_EQ(shown(0, 0), 0.0f);
    EXPECT_NEAR(shown(0, 1), 1.0f, 1e-6f);
    EXPECT_NEAR(shown(0, 2), 0.2140411f, 1e-6f);
    EXPECT_NEAR(shown(0, 3), 0.04f / 12.92f, 1e-7f);
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(shown(i, 4), std::pow((colours(i, 4) + 0.055) / 1.055, 2.4), 1e-6) << "red, green and blue";
    const auto base = [](const ReadGlb& one) {
        return one.json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"];
    };
    // Viewers multiply by the base colour.
    EXPECT_EQ(base(glb), Json::array({1.0, 1.0, 1.0, 1.0}));
    const ReadGlb grey = written(angle());
    EXPECT_FALSE(grey.primitive()["attributes"].contains("COLOR_0"));
    EXPECT_LT(base(grey)[0].get<double>(), 1.0);
    EXPECT_EQ(base(grey)[0], base(grey)[2]);
    EXPECT_EQ(base(grey)[3], 1.0);
}

TEST(GlbFile, IsNotWrittenWithoutASurfaceOrAFolder) {
    const test::Folder folder("glb_none");
    mesh::SurfaceMesh empty = angle();
    empty.triangles.resize(3, 0);
    const Result<void> none = write_glb(folder.path() / "none.glb", empty, {});
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().what, "there is no surface to write");
    EXPECT_EQ(none.error().where, folder.str("none.glb"));
    EXPECT_FALSE(folder.has("none.glb"));
    folder.write("file", "");
    EXPECT_FALSE(write_glb(folder.path() / "file" / "body.glb", angle(), {}));
}

}  // namespace
}  // namespace myo::results::glb_file_test
