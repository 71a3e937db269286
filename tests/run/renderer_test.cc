#include "sim/plant/renderer.h"

#include <gmock/gmock.h>

#include <cstdlib>

#include "models/read/config_error.h"

namespace dockyard {
namespace {

/// Sets DOCKYARD_GL for a test.
class Gl {
 public:
  explicit Gl(const char* word) { ::setenv("DOCKYARD_GL", word, 1); }
  ~Gl() { ::unsetenv("DOCKYARD_GL"); }
  Gl(const Gl&) = delete;
  Gl& operator=(const Gl&) = delete;
};

std::string Value(const std::vector<Fact>& facts, const std::string& name) {
  for (const Fact& fact : facts) {
    if (fact.name == name) return fact.value;
  }
  return "(no such fact)";
}

TEST(GlWord, IsOsMesaUnlessTheEnvironmentSaysOtherwise) {
  EXPECT_EQ(GlWord(), "osmesa");
  for (const char* word : {"", "osmesa"}) {
    const Gl chosen(word);
    EXPECT_EQ(GlWord(), "osmesa");
  }
  const Gl chosen("egl");
  EXPECT_EQ(GlWord(), "egl");
}

TEST(GlWord, RefusesOtherWords) {
  const Gl chosen("vulkan");
  try {
    MakeRenderer();
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(),
                 "the environment's DOCKYARD_GL: expected osmesa or egl, found 'vulkan'");
  }
}

TEST(RendererFacts, NameMesaOfBothBackEnds) {
  for (const char* word : {"osmesa", "egl"}) {
    const Gl chosen(word);
    const std::vector<Fact> facts = RendererFacts();
    EXPECT_EQ(Value(facts, "gl"), word);
    EXPECT_FALSE(Value(facts, "gl_vendor").empty());
    EXPECT_THAT(Value(facts, "gl_renderer"), testing::HasSubstr("llvmpipe"));
    EXPECT_THAT(Value(facts, "gl_version"), testing::HasSubstr("Mesa"));
  }
}

TEST(KeptRenderer, IsOneForTheProcessAndRefusesToDrawInItsChild) {
  KeptRenderer kept;
  StereoRenderer& first = kept.Get();
  EXPECT_EQ(&kept.Get(), &first);
  EXPECT_DEATH(kept.Get(), "check failed");  // the statement runs in a forked child
}

}  // namespace
}  // namespace dockyard
