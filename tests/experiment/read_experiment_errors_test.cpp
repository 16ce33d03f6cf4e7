#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/read_experiment.hpp"
#include "support/experiment_folder.hpp"
#include "support/good_experiment.hpp"

namespace myo::experiment {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using namespace testing_support;

// One line of the good experiment spoiled.
struct Mutation {
    std::string from, to;  // replaced in good_toml
    std::string line;      // text whose line in the changed file is to be cited
    std::string key;       // the message begins with it
    std::string word;      // and holds this
};

void PrintTo(const Mutation& m, std::ostream* out) { *out << m.from << " -> " << m.to; }

class SpoiledExperiment : public testing::TestWithParam<Mutation> {};

TEST_P(SpoiledExperiment, IsReportedWithKeyAndLine) {
    const Mutation& m = GetParam();
    const Folder folder("spoiled");
    const std::string toml = replaced(good_toml, m.from, m.to);
    write_files(folder, toml);
    const Result<Experiment> read = read_experiment(folder.path());
    ASSERT_FALSE(read) << m.to;
    const Error& error = read.error();
    EXPECT_EQ(error.where, (folder.path() / "experiment.toml").string() + ":" + std::to_string(line_of(toml, m.line)))
        << error.what;
    EXPECT_THAT(error.what, StartsWith(m.key));
    EXPECT_THAT(error.what, HasSubstr(m.word));
    EXPECT_EQ(error.what.find('\n'), std::string::npos);
}

const std::string box_kind = "kind = \"box\"\nsize_m = [0.1, 0.03, 0.03]\norigin_m = [0.0, 0.0, 0.0]";
const std::string third_trial = "[[trial]]\nname = \"check\"";

const std::vector<Mutation> mutations = {
    // document
    {"experiment/1", "experiment/2", "schema", "schema: ", "experiment/1"},
    {"schema = \"experiment/1\"\n", "", "name", "schema: ", "missing"},
    {"schema =", "shema =", "shema", "shema: unknown key", "\"schema\""},
    {"name = \"tail\"\n", "", "schema", "name: ", "missing"},
    {"name = \"tail\"", "name = \"\"", "name = \"\"", "name: ", "empty"},
    {"name = \"tail\"", "name = 3", "name = 3", "name: ", "must be a string"},
    {"[environment]", "[enviroment]", "[enviroment]", "enviroment: unknown key", "\"environment\""},
    {"name = \"tail\"", "name = \"tail", "name", "this is not valid TOML", "TOML"},
    {"damping_s = 0.003", "density_kg_m3 = 1", "density_kg_m3 = 1\n", "this is not valid TOML", "density_kg_m3"},
    {"[environment]", "[material]", "[material]\ngravity", "this is not valid TOML", "material"},
    // geometry
    {"[geometry]\n" + box_kind, "", "schema", "geometry: ", "missing"},
    {"kind = \"box\"", "kind = \"bock\"", "kind = \"bock\"", "geometry.kind: ", "\"box\""},
    {"kind = \"box\"", "kind = 1", "kind = 1", "geometry.kind: ", "string"},
    {"size_m = [0.1, 0.03, 0.03]\n", "", "[geometry]", "geometry.size_m: ", "missing"},
    {"size_m = [0.1, 0.03, 0.03]", "size_m = [0.1, 0.03]", "size_m", "geometry.size_m: ", "3 numbers"},
    {"size_m = [0.1, 0.03, 0.03]", "size_m = [0.1, 0.03, 0]", "size_m", "geometry.size_m: ", "positive"},
    {"size_m = [0.1, 0.03, 0.03]", "size_m = [0.1, nan, 0.03]", "size_m", "geometry.size_m: ", "finite"},
    {"size_m = [0.1, 0.03, 0.03]", "size_m = [100, 30, 30]", "size_m", "geometry.size_m: ", "unit"},
    {"size_m = [0.1, 0.03, 0.03]", "size_m = [1e-4, 3e-5, 3e-5]", "size_m", "geometry.size_m: ", "unit"},
    {"size_m =", "size =", "size =", "geometry.size: unknown key", "\"size_m\""},
    {"origin_m = [0.0, 0.0, 0.0]", "unit = \"m\"", "unit", "geometry.unit: ", "stl"},
    {box_kind, "kind = \"stl\"\nfile = \"body.stl\"", "[geometry]", "geometry.unit: ", "no default"},
    {box_kind, "kind = \"stl\"\nfile = \"body.stl\"\nunit = \"in\"", "unit", "geometry.unit: ", "mm, um"},
    {box_kind, "kind = \"stl\"\nunit = \"mm\"", "[geometry]", "geometry.file: ", "missing"},
    {box_kind, "kind = \"stl\"\nunit = \"mm\"\nfile = \"nobody.stl\"", "file =", "geometry.file: ", "nobody.stl"},
    {box_kind, "kind = \"stl\"\nunit = \"mm\"\nfile = \"\"", "file =", "geometry.file: ", "file name"},
    {box_kind, "kind = \"stl\"\nunit = \"mm\"\nfile = \"..\"", "file =", "geometry.file: ", "not a file"},
    {box_kind, "kind = \"stl\"\nunit = \"mm\"\nfile = \"body.stl\"\nrotation = [[1,0,0],[0,1,0],[0,0,-1]]", "rotation",
     "geometry.rotation: ", "left-handed"},
    {box_kind, "kind = \"stl\"\nunit = \"mm\"\nfile = \"body.stl\"\nrotation = [[1,0,0],[0,1,0],[0,1,0]]", "rotation",
     "geometry.rotation: ", "orthogonal"},
    {box_kind, "kind = \"stl\"\nunit = \"mm\"\nfile = \"body.stl\"\nrotation = [[1,0,0],[0,1,0]]", "rotation",
     "geometry.rotation: ", "3 rows"},
    // clamp
    {"[clamp]\nbox_m = [[-5e-4, -1e-3, -1e-3], [5e-4, 0.031, 0.031]]", "", "schema", "clamp: ", "missing"},
    {"box_m = [[-5e-4, -1e-3, -1e-3], [5e-4, 0.031, 0.031]]", "", "[clamp]", "clamp.box_m: ", "missing"},
    {"[[-5e-4, -1e-3, -1e-3], [5e-4, 0.031, 0.031]]", "[[-5e-4, -1e-3, 0.04], [5e-4, 0.031, 0.031]]", "box_m",
     "clamp.box_m: ", "z 0.04 > 0.031"},
    {"[[-5e-4, -1e-3, -1e-3], [5e-4, 0.031, 0.031]]", "[[-2, -1, -1], [-1, 1, 1]]", "box_m",
     "clamp.box_m: ", "no material"},
    {"[[-5e-4, -1e-3, -1e-3], [5e-4, 0.031, 0.031]]", "[[-1, -1, -1], [1, 31, 31]]", "box_m",
     "clamp.box_m: ", "holds the whole body, nothing can move"},
    {"[[-5e-4, -1e-3, -1e-3], [5e-4, 0.031, 0.031]]", "[-5e-4, -1e-3]", "box_m", "clamp.box_m: ", "array of 3 numbers"},
    {"[[-5e-4, -1e-3, -1e-3], [5e-4, 0.031, 0.031]]", "[[-5e-4, -1e-3, -1e-3]]", "box_m",
     "clamp.box_m: ", "two corners"},
    {"[[-5e-4, -1e-3, -1e-3], [5e-4, 0.031, 0.031]]", "[[-5e-4, \"a\", -1e-3], [5e-4, 0.031, 0.031]]", "box_m",
     "clamp.box_m: ", "not a string"},
    // material
    {"model = \"neo_hookean\"", "model = \"neohookean\"", "model", "material.model: ", "\"neo_hookean\""},
    {"model = \"neo_hookean\"\n", "", "[material]", "material.model: ", "missing"},
    {"model = \"neo_hookean\"", "model = \"gent\"", "[material]", "material.gent_limit: ", "missing"},
    {"model = \"neo_hookean\"", "model = \"gent\"\ngent_limit = 0", "gent_limit", "material.gent_limit: ", "0.1"},
    {"model = \"neo_hookean\"", "model = \"neo_hookean\"\ngent_limit = 30", "gent_limit",
     "material.gent_limit: ", "no parameter of the law"},
    {"youngs_modulus_Pa =", "youngs_modulus_pa =", "youngs_modulus_pa", "material.youngs_modulus_pa: unknown key",
     "\"youngs_modulus_Pa\""},
    {"youngs_modulus_Pa = 2.6e5", "youngs_modulus_Pa = -2.6e5", "youngs_modulus_Pa",
     "material.youngs_modulus_Pa: ", "positive"},
    {"youngs_modulus_Pa = 2.6e5", "youngs_modulus_Pa = inf", "youngs_modulus_Pa",
     "material.youngs_modulus_Pa: ", "finite"},
    {"youngs_modulus_Pa = 2.6e5", "youngs_modulus_Pa = \"2.6e5\"", "youngs_modulus_Pa",
     "material.youngs_modulus_Pa: ", "must be a number"},
    {"youngs_modulus_Pa = 2.6e5", "youngs_modulus_Pa = true", "youngs_modulus_Pa",
     "material.youngs_modulus_Pa: ", "must be a number"},
    {"youngs_modulus_Pa = 2.6e5", "youngs_modulus_Pa = 2026-01-01", "youngs_modulus_Pa",
     "material.youngs_modulus_Pa: ", "date"},
    {"tolerance = 0.25", "tolerance = 1.5", "tolerance", "material.youngs_modulus_tolerance: ", "below 1"},
    {"tolerance = 0.25", "tolerance = -0.1", "tolerance", "material.youngs_modulus_tolerance: ", "negative"},
    {"poissons_ratio = 0.49", "poissons_ratio = 0.5", "poissons_ratio", "material.poissons_ratio: ", "below 0.5"},
    {"poissons_ratio = 0.49", "poissons_ratio = 0", "poissons_ratio", "material.poissons_ratio: ", "above 0"},
    {"poissons_ratio = 0.49", "poissons_ratio = nan", "poissons_ratio", "material.poissons_ratio: ", "nan"},
    {"density_kg_m3 = 1070", "density_kg_m3 = -1070", "density_kg_m3", "material.density_kg_m3: ", "positive"},
    {"damping_s = 0.003", "damping_s = -0.003", "damping_s", "material.damping_s: ", "negative"},
    {"damping_s = 0.003\n", "", "calibrate", "material.calibrate: ", "damping_s"},
    {"\"youngs_modulus\", \"act", "\"young_modulus\", \"act", "calibrate",
     "material.calibrate: ", "\"youngs_modulus\""},
    {"\"youngs_modulus\", \"act", "\"actuation_level\", \"act", "calibrate", "material.calibrate: ", "twice"},
    {"calibrate = [\"youngs_modulus\", \"actuation_level\"]", "calibrate = \"damping\"", "calibrate",
     "material.calibrate: ", "an array"},
    {"\"youngs_modulus\", \"actuation_level\"", "\"youngs_modulus\"", "actuation_step",
     "trial[1].actuation_step.left: ", "actuation_level"},
    // environment
    {"gravity_m_s2 = [0, 0, -9.8]", "gravity_m_s2 = -9.8", "gravity",
     "environment.gravity_m_s2: ", "array of 3 numbers"},
    {"gravity_m_s2 =", "gravity =", "gravity =", "environment.gravity: unknown key", "\"gravity_m_s2\""},
    // muscles
    {"name = \"left\"", "name = \" \"", "name = \" \"", "muscle[0].name: ", "empty"},
    {"name = \"left\"\n", "", "[[muscle]]", "muscle[0].name: ", "missing"},
    {"name = \"right\"", "name = \"left\" ", "name = \"left\" ", "muscle[1].name: ", "duplicate"},
    {"fibre = [0.999, 0.0, 0.0]", "fibre = [0, 0, 0]", "fibre", "muscle[0].fibre: ", "zero"},
    {"fibre = [0.999, 0.0, 0.0]", "fibre = [1, 1, 0]", "fibre", "muscle[0].fibre: ", "1.414"},
    {"stiffness_Pa = 8e4", "stiffness_Pa = -8e4", "stiffness_Pa", "muscle[0].stiffness_Pa: ", "positive"},
    {"[[0.01, 0.0, 0.0], [0.09, 0.015, 0.03]]", "[[0.2, 0.0, 0.0], [0.3, 0.015, 0.03]]", "box_m = [[0.2",
     "muscle[0].box_m: ", "no material"},
    {"box_m = [[0.01, 0.0, 0.0], [0.09, 0.015, 0.03]]\n", "", "[[muscle]]",
     "muscle[0].box_m: ", "one of box_m, mask, line_m"},
    {"box_m = [[0.01, 0.0, 0.0], [0.09, 0.015, 0.03]]",
     "box_m = [[0.01, 0.0, 0.0], [0.09, 0.015, 0.03]]\nmask = \"signal.csv\"", "mask",
     "muscle[0].mask: ", "combined with box_m"},
    {"box_m = [[0.01, 0.0, 0.0], [0.09, 0.015, 0.03]]", "mask = \"paint.csv\"", "mask",
     "muscle[0].mask: ", "not found"},
    {"box_m = [[0.01, 0.0, 0.0], [0.09, 0.015, 0.03]]",
     "box_m = [[0.01, 0.0, 0.0], [0.09, 0.015, 0.03]]\nradius_m = 0.01", "radius_m", "muscle[0].radius_m: ", "line_m"},
    {"fibre = [0.999, 0.0, 0.0]\n", "", "[[muscle]]", "muscle[0].fibre: ", "missing"},
    {"box_m = [[0.01, 0.0, 0.0], [0.09, 0.015, 0.03]]",
     "line_m = [[0, 0.01, 0.01], [0.1, 0.01, 0.01]]\nradius_m = 0.004", "fibre", "muscle[0].fibre: ", "run along it"},
    {"box_m = [[0.01, 0.0, 0.0], [0.09, 0.015, 0.03]]\nfibre = [0.999, 0.0, 0.0]",
     "line_m = [[0, 0.01, 0.01], [0.1, 0.01, 0.01]]", "[[muscle]]", "muscle[0].radius_m: ", "missing"},
    {"box_m = [[0.01, 0.0, 0.0], [0.09, 0.015, 0.03]]\nfibre = [0.999, 0.0, 0.0]",
     "line_m = [[0, 0.01, 0.01], [0.1, 0.01, 0.01]]\nradius_m = 0", "radius_m", "muscle[0].radius_m: ", "positive"},
    {"box_m = [[0.01, 0.0, 0.0], [0.09, 0.015, 0.03]]\nfibre = [0.999, 0.0, 0.0]",
     "line_m = [[0, 0.01, 0.01]]\nradius_m = 0.004", "line_m", "muscle[0].line_m: ", "two points"},
    {"box_m = [[0.01, 0.0, 0.0], [0.09, 0.015, 0.03]]\nfibre = [0.999, 0.0, 0.0]",
     "line_m = [[0, 0.01], [0.1, 0.01, 0.01]]\nradius_m = 0.004", "line_m", "muscle[0].line_m: ", "3 numbers"},
    {"box_m = [[0.01, 0.0, 0.0], [0.09, 0.015, 0.03]]\nfibre = [0.999, 0.0, 0.0]",
     "line_m = [[0, 0, 0], [0, 0, 0], [0.1, 0, 0]]\nradius_m = 0.004", "line_m",
     "muscle[0].line_m: ", "points 1 and 2"},
    {"muscle = \"left\", ratio", "muscle = \"lift\", ratio", "follows", "muscle[1].follows.muscle: ", "\"left\""},
    {"muscle = \"left\", ratio", "muscle = \"right\", ratio", "follows", "muscle[1].follows.muscle: ", "itself"},
    {"stiffness_Pa = 8e4", "stiffness_Pa = 8e4\nfollows = { muscle = \"right\", ratio = 1 }", "ratio = 1 }",
     "muscle[0].follows.muscle: ", "ring"},
    {"ratio = -0.5", "ration = -0.5", "follows", "muscle[1].follows.ration: unknown key", "\"ratio\""},
    {", ratio = -0.5", "", "follows", "muscle[1].follows.ratio: ", "missing"},
    // registration
    {"known = false", "known = \"false\"", "known", "registration.known: ", "true or false"},
    {"max_translation_m = 0.001\n", "", "[registration]", "registration.max_translation_m: ", "known = false"},
    {"max_rotation_deg = 0.5\n", "", "[registration]", "registration.max_rotation_deg: ", "known = false"},
    {"max_rotation_deg = 0.5", "max_rotation_deg = -0.5", "max_rotation_deg",
     "registration.max_rotation_deg: ", "between 0 and 180"},
    {"max_translation_m = 0.001", "max_translation_m = -1", "max_translation_m",
     "registration.max_translation_m: ", "negative"},
    {"max_translation_m = 0.001", "method = \"rest\"", "method", "registration.method: ", "rest_pose"},
    {"known = false\n", "known = true\nmethod = \"rest_pose\"\n", "method", "registration.method: ", "known = false"},
    // markers
    {"noise_m = 1e-4", "noise_m = 0", "noise_m", "markers.noise_m: ", "positive"},
    {"max_standoff_m = 0.007", "max_standoff_m = -1", "max_standoff_m", "markers.max_standoff_m: ", "negative"},
    {"max_standoff_m = 0.007", "max_standoff_m = 0.007\nplacement_m = -0.001", "placement_m",
     "markers.placement_m: ", "negative"},
    {"max_standoff_m = 0.007", "max_standoff_m = 0.007\nplacement_m = nan", "placement_m",
     "markers.placement_m: ", "finite"},
    {"max_standoff_m = 0.007\n", "", "side = [", "markers.rest_m.side: ", "6 mm off"},
    {"compare = \"displacement\"", "compare = \"displacment\"", "compare", "markers.compare: ", "\"displacement\""},
    {"tip = [0.1, 0.0, 0.024]\nside = [0.05, 0.036, 0.006]\n", "", "[markers.rest_m]",
     "markers.rest_m: ", "at least one"},
    {"tip = [0.1, 0.0, 0.024]", "tip = [0.1, 0.0]", "tip = [", "markers.rest_m.tip: ", "3 numbers"},
    {"tip = [0.1, 0.0, 0.024]", "tip = [0.1, 0.05, 0.024]", "tip = [", "markers.rest_m.tip: ", "20 mm off"},
    {"base = [-0.09", "side = [-0.09", "side = [-0.09", "markers.fixed_m.side: ", "duplicate"},
    {"tip = \"Tip - 1\"", "top = \"Tip - 1\"", "top =", "markers.labels.top: ", "\"tip\""},
    {"tip = \"Tip - 1\"", "tip = \"side\"", "side = [", "markers.rest_m.side: ", "duplicate"},
    {"tip = \"Tip - 1\"", "tip = \"\"", "tip = \"\"", "markers.labels.tip: ", "empty"},
    {"[markers.fixed_m]", "[markers.fixed]", "[markers.fixed]", "markers.fixed: unknown key", "\"fixed_m\""},
    // trials
    {"name = \"release\"", "name = \"step\"", "name = \"step\"\nrole = \"fit\"\ntrace = \"step.txt\"",
     "trial[1].name: ", "duplicate"},
    {"name = \"release\"", "name = \"../release\"", "name = \"../release\"", "trial[0].name: ", "slash"},
    {"name = \"release\"\n", "", "[[trial]]", "trial[0].name: ", "missing"},
    {"role = \"fit\"", "role = \"fitt\"", "role", "trial[0].role: ", "\"fit\""},
    {"trace = \"release.csv\"\n", "", "[[trial]]", "trial[0].trace: ", "missing"},
    {"trace = \"release.csv\"", "trace = \"relief.csv\"", "trace", "trial[0].trace: ", "not found"},
    {"format = \"csv\"", "format = \"cvs\"", "format", "trial[0].format: ", "csv"},
    {"format = \"csv\"\n", "", "[[trial]]", "trial[0].format: ", "missing"},
    {"start = \"straight\"", "start = \"strait\"", "start = ", "trial[0].start: ", "\"straight\""},
    {"session_time_s = 60.0", "session_times = 60.0", "session_times", "trial[0].session_times: unknown key",
     "\"session_time_s\""},
    {"actuation = \"signal.csv\"", "actuation = \"none.csv\"", "actuation = ", "trial[0].actuation: ", "not found"},
    {"end_s = 2.0", "end_s = 0.5", "end_s", "trial[0].end_s: ", "before start_s"},
    {"start_s = 0.5", "start_s = nan", "start_s", "trial[0].start_s: ", "finite"},
    {"condition = { pressure_mbar = 75 }", "condition = { pressure_mbar = \"75\" }", "condition",
     "trial[1].condition.pressure_mbar: ", "number"},
    {"condition = { pressure_mbar = 125 }\n", "", "actuation_step = { left = \"free\" }\n\n[[effect]]",
     "trial[2].actuation_step.left: ", "condition"},
    {"condition = { pressure_mbar = 125 }", "condition = { pressure_bar = 0.125 }",
     "actuation_step = { left = \"free\" }\n\n[[effect]]", "trial[2].actuation_step.left: ", "predict"},
    {"{ left = \"free\" }", "{ lift = \"free\" }", "lift", "trial[1].actuation_step.lift: ", "\"left\""},
    {"{ left = \"free\" }", "{ right = 0.5 }", "right = 0.5", "trial[1].actuation_step.right: ", "follows"},
    {"{ left = \"free\" }", "{ left = \"auto\" }", "auto", "trial[1].actuation_step.left: ", "\"free\""},
    {"{ left = \"free\" }", "{ left = [1] }", "left = [1]", "trial[1].actuation_step.left: ", "number"},
    // columns
    {"columns = {", "colums = {", "colums", "trial[1].colums: unknown key", "\"columns\""},
    {"format = \"columns\"", "format = \"c3d\"", "columns = {", "trial[1].columns: ", "format"},
    {"format = \"qtm_tsv\"", "format = \"columns\"", third_trial, "trial[2].columns: ", "missing"},
    {"unit = \"mm\", sep", "sep", "columns = {", "trial[1].columns.unit: ", "missing"},
    {"unit = \"mm\", sep", "unit = \"in\", sep", "columns = {", "trial[1].columns.unit: ", "unknown value"},
    {"separator = \";\"", "separator = \";;\"", "columns = {", "trial[1].columns.separator: ", "one character"},
    {"separator = \";\"", "separator = \".\"", "columns = {", "trial[1].columns.separator: ", "number"},
    {"rate_Hz = 50", "rate_Hz = 0", "columns = {", "trial[1].columns.rate_Hz: ", "positive"},
    {"[\"side\", \"base\", \"tip\"]", "[\"side\", \"base\", \"tap\"]", "columns = {",
     "trial[1].columns.markers: ", "\"tip\""},
    {"[\"side\", \"base\", \"tip\"]", "[\"side\", \"base\"]", "columns = {", "trial[1].columns.markers: ", "\"tip\""},
    {"[\"side\", \"base\", \"tip\"]", "[\"side\", \"tip\", \"tip\"]", "columns = {",
     "trial[1].columns.markers: ", "twice"},
    {"[\"side\", \"base\", \"tip\"]", "[\"side\", \"base\", \"tip\", \"Tip - 1\"]", "columns = {",
     "trial[1].columns.markers: ", "twice"},
    // loads
    {"kind = \"mass\"", "kind = \"weight\"", "kind = \"weight\"", "trial[0].load[0].kind: ", "mass"},
    {"mass_kg = 0.05", "mass_kg = -0.05", "mass_kg", "trial[0].load[0].mass_kg: ", "negative"},
    {"mass_kg = 0.05", "force_N = [0, 0, 1]", "force_N = [0, 0, 1]", "trial[0].load[0].force_N: ", "mass"},
    {"mass_kg = 0.05", "mass_kg = 0.05\nuntil_s = 0.0", "until_s = 0.0", "trial[0].load[0].until_s: ", "whole trial"},
    {"mass_kg = 0.05\n", "", "[[trial.load]]\nkind = \"mass\"", "trial[0].load[0].mass_kg: ", "missing"},
    {"force_N = [0.0, 0.7, 0.25]", "force_N = [0.0, 0.7, inf]", "force_N", "trial[0].load[1].force_N: ", "finite"},
    {"[[0.0995, -0.001, -0.001], [0.1005, 0.031, 0.031]]", "[[0.0995, -0.001, 0.03], [0.1005, 0.031, 0.01]]",
     "0.03], [0.1005", "trial[0].load[0].box_m: lowest corner is above the highest", "z 0.03 > 0.01"},
    {"[[0.0995, -0.001, -0.001], [0.1005, 0.031, 0.031]]", "[[0.05, 0.01, 0.01], [0.06, 0.02, 0.02]]", "[[0.05, 0.01",
     "trial[0].load[0].box_m: ", "no surface"},
    {"until_s = 0.0", "until_s = -inf", "until_s", "trial[0].load[1].until_s: ", "before it begins"},
    {"from_s = -inf", "from_s = 1.0", "until_s", "trial[0].load[1].until_s: ", "before it begins"},
    {"until_s = 0.0", "until_s = nan", "until_s", "trial[0].load[1].until_s: ", "nan"},
    {"[[trial.load]]\nkind = \"mass\"", "[trial.load]\nkind = \"mass\"", "[[trial.load]]", "this is not valid TOML",
     "load"},
    // effects
    {"id = \"clamp_compliance\"", "id = \"clamp_complience\"", "id = ", "effect[0].id: ", "\"clamp_compliance\""},
    {"id = \"clamp_compliance\"", "id = \"none\"", "id = ", "effect[0].id: ", "verdict"},
    {"id = \"clamp_compliance\"\n", "", "[[effect]]", "effect[0].id: ", "missing"},
    {"stiffness_Pa_per_m = 1.2e7", "stiffness_N_m = 1.2e7", "stiffness_N_m", "effect[0].stiffness_N_m: unknown key",
     "\"stiffness_Pa_per_m\""},
    {"stiffness_Pa_per_m = 1.2e7", "stiffness_Pa_per_m = 0", "stiffness_Pa_per_m",
     "effect[0].stiffness_Pa_per_m: ", "positive"},
    {"stiffness_Pa_per_m = 1.2e7\n", "", "[[effect]]", "effect[0].stiffness_Pa_per_m: ", "missing"},
    {"id = \"clamp_compliance\"\nstiffness_Pa_per_m = 1.2e7", "id = \"gravity_tilt\"\ntilt_deg = 1\naxis = [0, 0, 0]",
     "axis =", "effect[0].axis: ", "has no direction: it is zero"},
    {"calibrate = true", "calibrate = 1", "calibrate = 1", "effect[0].calibrate: ", "true or false"},
    {"[\"tip\", \"side\"]", "[\"tip\", \"sade\"]", "markers = [\"tip\"", "effect[1].markers: ", "\"side\""},
    {"[\"tip\", \"side\"]", "[\"tip\", \"tip\"]", "markers = [\"tip\"", "effect[1].markers: ", "two different"},
    {"trial = \"step\"", "trial = \"stop\"", "trial = \"stop\"", "effect[1].trial: ", "\"step\""},
};

INSTANTIATE_TEST_SUITE_P(ReadExperiment, SpoiledExperiment, testing::ValuesIn(mutations));

TEST(ReadExperiment, NeedsAFitTrial) {
    const Folder folder("no_fit");
    std::string toml = replaced(good_toml, "role = \"fit\"", "role = \"validate\"");
    toml = replaced(toml, "role = \"fit\"", "role = \"validate\"");
    for (int i = 0; i < 2; ++i) toml = replaced(toml, "actuation_step = { left = \"free\" }\n", "");
    write_files(folder, toml);
    const Result<Experiment> read = read_experiment(folder.path());
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().what, StartsWith("trial[0].role: "));
    EXPECT_THAT(read.error().where, testing::EndsWith(":" + std::to_string(line_of(toml, "role"))));

    write_files(folder, good_toml.substr(0, good_toml.find("[[trial]]")));
    const Result<Experiment> none = read_experiment(folder.path());
    ASSERT_FALSE(none);
    EXPECT_THAT(none.error().what, StartsWith("trial: "));
    write_files(folder, "trial = 3\n" + good_toml.substr(0, good_toml.find("[[trial]]")));
    EXPECT_THAT(read_experiment(folder.path()).error().what, HasSubstr("[[trial]]"));
}

TEST(ReadExperiment, RestPoseNeedsThreePointsOffALine) {
    const Folder folder("rest_pose");
    const std::string toml = replaced(good_toml, "max_translation_m = 0.001\nmax_rotation_deg = 0.5",
                                      "method = \"rest_pose\"");
    write_files(folder, toml);
    EXPECT_TRUE(read_experiment(folder.path()));
    // tip (0.1, 0, 0.024), base and side on one line
    const std::string line = replaced(replaced(toml, "base = [-0.09, -0.01, 0.0]", "base = [0.0, 0.072, -0.012]"),
                                      "side = [0.05, 0.036, 0.006]", "side = [0.05, 0.036, 0.006] ");
    write_files(folder, line);
    const Result<Experiment> read = read_experiment(folder.path());
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().what, StartsWith("registration.method: "));
}

TEST(ReadExperiment, SurvivesGarbage) {
    const Folder folder("garbage");
    for (std::size_t cut = 0; cut < good_toml.size(); cut += 37) {  // truncated anywhere
        write_files(folder, good_toml.substr(0, cut));
        const Result<Experiment> read = read_experiment(folder.path());
        EXPECT_TRUE(read || !read.error().what.empty());
    }
    for (const std::string& content :
         {std::string(), std::string(1000, '\0'), std::string("\xff\xfe\x00x", 4), "a=" + std::string(100000, '['),
          std::string("schema = \"experiment/1\"\nname=1e999")}) {
        write_files(folder, content);
        const Result<Experiment> read = read_experiment(folder.path());
        ASSERT_FALSE(read);
        EXPECT_LT(read.error().what.size(), 400u);
    }
}

}  // namespace
}  // namespace myo::experiment
