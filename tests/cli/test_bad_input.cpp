// Every careless input: one line that names the place, exit status 2, and no file left behind.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "command_fixture.hpp"

namespace warpgrain::cli {
namespace {

using testing::HasSubstr;

const std::string material =
    R"({"name": "glass", "density": 2500, "youngs_modulus": 1e7, "poisson_ratio": 0.3})";

std::string particle(const std::string& position, const std::string& more = {},
                     const std::string& radius = "0.005") {
  return R"({"material": "glass", "radius": )" + radius + R"(, "position": )" + position + more + "}";
}

std::string scene(const std::string& particles, const std::string& walls = "[]",
                  const std::string& more = {}) {
  return R"({"format": "warpgrain.scene/1", "name": "t", "gravity": [0, 0, 0], "materials": [)" + material +
         R"(], "contacts": [{"between": ["glass", "glass"], "restitution": 0.8, "friction": 0.5}], "particles": )" +
         particles + R"(, "walls": )" + walls + R"(, "time": {"step": "auto", "end": {"steps": 50}})" + more +
         "}";
}

class BadInput : public CommandTest {
 protected:
  // Runs the scene on the reference, with every kind of output asked for.
  void expect_refused(const std::string& text, const std::vector<std::string>& said,
                      const std::string& backend = "host") {
    const std::string file = write("t.json", text);
    EXPECT_EQ(call({"run", "--scene", file, "--backend", backend, "--json", path("r.json"), "--state",
                    path("s.csv")}),
              2);
    EXPECT_EQ(out_, "");
    EXPECT_EQ(error_lines(), 1u) << err_;
    for (const std::string& part : said) EXPECT_THAT(err_, HasSubstr(part));
    EXPECT_FALSE(std::filesystem::exists(path("r.json")));
    EXPECT_FALSE(std::filesystem::exists(path("s.csv")));
  }
};

TEST_F(BadInput, SceneThatIsGoodRuns) {
  const std::string file = write("t.json", scene("[" + particle("[0,0,0]") + "]"));
  EXPECT_EQ(
      call({"run", "--scene", file, "--backend", "host", "--json", path("r.json"), "--state", path("s.csv")}),
      0)
      << err_;
  EXPECT_TRUE(std::filesystem::exists(path("r.json")));
  EXPECT_TRUE(std::filesystem::exists(path("s.csv")));
}

TEST_F(BadInput, UnknownKey) {
  expect_refused(scene("[" + particle("[0,0,0]", R"(, "colour": "red")") + "]"),
                 {"t.json", "particles[0]", "colour"});
}

TEST_F(BadInput, MissingMaterial) {
  std::string text = scene("[" + particle("[0,0,0]") + "]");
  text.replace(text.find("\"particles\": [{\"material\": \"glass\"") + 27, 7, "\"steel\"");
  expect_refused(text, {"t.json", "particles[0].material", "steel", "glass"});
}

TEST_F(BadInput, NotANumber) {
  expect_refused(scene("[" + particle("[0, NaN, 0]") + "]"), {"t.json"});
  expect_refused(scene("[" + particle("[0, null, 0]") + "]"), {"t.json", "particles[0].position[1]"});
  expect_refused(scene("[" + particle("[0, 1e999, 0]") + "]"), {"t.json"});
}

TEST_F(BadInput, ZeroRadius) {
  expect_refused(scene("[" + particle("[0,0,0]", {}, "0") + "]"), {"t.json", "particles[0].radius"});
}

TEST_F(BadInput, TwoParticlesAtOnePoint) {
  expect_refused(scene("[" + particle("[0,0,0]") + "," + particle("[0,0,0]") + "]"), {"t.json", "particles"});
}

TEST_F(BadInput, WallWithoutArea) {
  const std::string walls =
      R"([{"material": "glass", "rectangle": {"corner": [0,0,-1], "edges": [[1,0,0],[2,0,0]]}}])";
  expect_refused(scene("[" + particle("[0,0,0]") + "]", walls), {"t.json", "walls[0].rectangle"});
}

TEST_F(BadInput, StateFileCutInTheMiddle) {
  write("bed.csv", "id,x,y,z,vx,vy,vz,wx,wy,wz,radius\n0,0,0,0,0,0,0,0,0,0,0.005\n1,0.1,0,0,0,0.");
  expect_refused(scene(R"({"file": "bed.csv", "material": "glass"})"), {"bed.csv", "3"});
}

TEST_F(BadInput, ParticleThatLeavesTheDomain) {
  const std::string text =
      scene("[" + particle("[0,0,0]", R"(, "velocity": [1000, 0, 0])") + "]", "[]",
            R"(, "domain": {"lower": [-0.01, -0.01, -0.01], "upper": [0.01, 0.01, 0.01]})");
  for (const std::string backend : {"host", "opencl", "simt"}) {
    SCOPED_TRACE(backend);
    expect_refused(text, {"particle 0", "domain"}, backend);
  }
}

TEST_F(BadInput, MoreContactsThanSlots) {
  // Twenty small spheres overlap one at the origin and each other: more than any slot count for equal radii.
  std::string particles = particle("[0,0,0]");
  for (int k = 0; k < 20; ++k)
    particles += "," + particle("[" + std::to_string(1e-4 * (k + 1)) + ", 1e-5, " +
                                std::to_string(1e-4 * (k % 7)) + "]");
  for (const std::string backend : {"host", "opencl", "simt"}) {
    SCOPED_TRACE(backend);
    expect_refused(scene("[" + particles + "]"), {"particle", "contact"}, backend);
  }
}

TEST_F(BadInput, KernelFileThatDoesNotCompile) {
  write("kernels/contact/branchy.cl", "this is not OpenCL C\n");
  const std::string file = write("t.json", scene("[" + particle("[0,0,0]") + "]"));
  for (const std::string backend : {"opencl", "simt"}) {
    EXPECT_EQ(call({"run", "--scene", file, "--backend", backend, "--kernels", path("kernels"), "--json",
                    path("r.json")}),
              2);
    EXPECT_THAT(err_, HasSubstr("branchy.cl"));
    EXPECT_THAT(err_, HasSubstr(":1:"));
    EXPECT_FALSE(std::filesystem::exists(path("r.json")));
  }
}

TEST_F(BadInput, NumbersThatAreNone) {
  for (const std::vector<std::string>& wrong :
       {std::vector<std::string>{"run", "--scene", "head_on", "--steps", "-1"},
        {"run", "--scene", "head_on", "--steps", "nan"},
        {"run", "--scene", "head_on", "--sample-every", "1.5"},
        {"profile", "--scene", "head_on", "--at-step", "-3"},
        {"compare", "a.json", "b.json", "--fail-above", "nan"},
        {"measure", "k.sim", "--tolerance", "inf"},
        {"paper", "--samples", "-1"},
        {"stability", "--samples", "nan"}}) {
    EXPECT_EQ(call(wrong), 2);
    EXPECT_EQ(error_lines(), 1u) << err_;
    EXPECT_THAT(err_, testing::AnyOf(HasSubstr("expected a whole number from 0 on"),
                                     HasSubstr("expected a finite number")));
    EXPECT_THAT(err_, HasSubstr("'" + wrong.back() + "'"));
  }
}

// Before the work is done, which would take days.
TEST_F(BadInput, PlacesThatNothingCanBeWrittenTo) {
  const std::string file = write("file", "");
  for (const std::vector<std::string>& wrong :
       {std::vector<std::string>{"run", "--json", file + "/r.json"},
        {"run", "--state", folder_.path().string()},
        {"run", "--checkpoint", file},
        {"profile", "--html", "/proc/no/such/place.html"},
        {"sweep", "--out", path("out"), "--json", file + "/i.json"}}) {
    std::vector<std::string> words = wrong;
    words.insert(words.begin() + 1, {"--scene", "settled_bed", "--particles", "20"});
    if (wrong[0] == "run") words.insert(words.end(), {"--steps", "100000000000"});
    EXPECT_EQ(call(words), 2);
    EXPECT_EQ(error_lines(), 1u) << err_;
    EXPECT_THAT(
        err_, testing::AnyOf(HasSubstr("expected a writable place"), HasSubstr("expected a file to write")));
  }
  EXPECT_EQ(call({"run", "--scene", "head_on", "--steps", "5", "--json", path("made/for/it/r.json")}), 0)
      << err_;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "made/for/it/r.json"));
}

TEST_F(BadInput, KernelFolderThatIsNotThere) {
  EXPECT_EQ(call({"run", "--scene", "head_on", "--kernels", path("none")}), 2);
  EXPECT_EQ(error_lines(), 1u) << err_;
  EXPECT_THAT(err_, HasSubstr(path("none")));
}

TEST_F(BadInput, LaunchFiles) {
  write("k.cl", "kernel void add(global int* a) { a[get_global_id(0)] += 1; }\n");
  const auto refused = [&](const std::string& launch, const std::vector<std::string>& said) {
    const std::string file = write("l.sim", launch);
    EXPECT_EQ(call({"profile", file, "--json", path("r.json")}), 2) << launch;
    EXPECT_EQ(error_lines(), 1u) << err_;
    for (const std::string& part : said) EXPECT_THAT(err_, HasSubstr(part));
    EXPECT_FALSE(std::filesystem::exists(path("r.json")));
  };
  refused("k.cl\nsubtract\n32 1 1\n32 1 1\n<size=128 fill=0>\n", {"subtract", "add"});
  refused("none.cl\nadd\n32 1 1\n32 1 1\n<size=128 fill=0>\n", {"none.cl"});
  refused("k.cl\nadd\n32 1 1\n32 1 1\n", {"l.sim", "argument"});
  refused("k.cl\nadd\n32 1\n", {"l.sim"});
  EXPECT_EQ(call({"profile", path("missing.sim"), "--arch", "sm_10"}), 2);
  EXPECT_THAT(err_, HasSubstr("sm_75 to sm_90"));
  EXPECT_EQ(call({"profile", path("missing.sim")}), 2);
  EXPECT_THAT(err_, HasSubstr("missing.sim"));
}

TEST_F(BadInput, Calls) {
  const auto refused = [&](const std::vector<std::string>& words, const std::vector<std::string>& said) {
    EXPECT_EQ(call(words), 2);
    EXPECT_EQ(error_lines(), 1u) << err_;
    for (const std::string& part : said) EXPECT_THAT(err_, HasSubstr(part));
  };
  refused({"walk"}, {"walk", "list", "run", "profile", "sweep"});
  refused({}, {"subcommand"});
  refused({"run"}, {"--scene"});
  refused({"run", "--scene", "slot"}, {"slot", "slit"});
  refused({"run", "--scene", "head_on", "--stepps", "3"}, {"--stepps", "--steps"});
  refused({"run", "--scene", "head_on", "--backend", "hots"}, {"hots", "host"});
  refused({"run", "--scene", "head_on", "--order", "cel"}, {"cel", "unsorted"});
  refused({"run", "--scene", "head_on", "--variant", "branchy/cells"}, {"branchy/cells"});
  refused({"run", "--scene", "head_on", "--particles", "8"}, {"particles", "fill"});
  refused({"run", "--scene", "slit", "--particles", "0"}, {"--particles", "above 0"});
  refused({"run", "--scene", "head_on", "--device", "no such device"}, {"no such device"});
  refused({"list", "scene"}, {"scene", "scenes"});
  refused({"profile"}, {"launch file"});
  refused({"profile", "--scene", "head_on", "--width", "12"}, {"12", "32"});
  refused({"profile", "--scene", "head_on", "--policy", "x"}, {"'x'", "loop_postdom"});
  refused({"profile", "--what-if", "width=8", "k.sim"}, {"'k.sim'", "width, policy, order and pool"});
  refused({"profile", "k.sim", "--what-if", "lanes=8"}, {"'lanes'", "width, policy, order, pool"});
  refused({"profile", "k.sim", "--what-if", "width=eight"}, {"'eight'", "whole number"});
  refused({"profile", "k.sim", "--what-if", "policy=x"}, {"'x'", "loop_postdom"});
  refused({"profile", "k.sim", "--what-if", "order=random"}, {"'random'", "sorted:KEY"});
  refused({"sweep", "--scene", "head_on", "--out", path("o"), "--axis", "order"}, {"order", "name=value"});
  refused({"sweep", "--scene", "head_on", "--out", path("o"), "--shard", "0/2"}, {"0/2"});
}

}  // namespace
}  // namespace warpgrain::cli
