// Each kind of hostile input, 600 mutations of it: each is read or refused as bad input, nothing
// else happens. scripts/fuzz reads far more, and follows what is new.
#include <gmock/gmock.h>

#include "fuzz/kind.h"
#include "fuzz/mutated.h"

namespace dockyard {

/// What GoogleTest shows of a kind.
void PrintTo(const NamedKind& kind, std::ostream* out) { *out << kind.name; }

namespace {

// A process for each import would take minutes.
const MeshFuzzOptions kSomeImports{.unguarded = false, .crash_dir = {}, .import_every = 10};

class Mutations : public testing::TestWithParam<NamedKind> {};

#if defined(__SANITIZE_ADDRESS__) || (defined(__clang__) && __has_feature(address_sanitizer))
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

/// Not optimised and sanitized, 600 of each kind take minutes. The optimised test has them all,
/// scripts/fuzz 10^5 under sanitizers.
constexpr int kCount = kSanitized ? 300 : 600;

TEST_P(Mutations, AreReadOrRefused) {
  const FuzzKind kind = GetParam().make();
  // A search of two images takes 0.1 s, not optimised, and finds discs in nearly all.
  const bool pixels = kind.name == "pixels";
  const int count = pixels ? 20 : kCount;
  const std::vector<std::string> seeds = kind.seeds();
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    EXPECT_TRUE(kind.read(seeds[i])) << "seed " << i;
  }
  RandomStream random(1);
  int read = 0;
  for (int i = 0; i < count; ++i) {
    const std::string& seed = seeds[static_cast<std::size_t>(i) % seeds.size()];
    if (kind.read(Mutated(seed, random))) ++read;
  }
  // Else the mutations try nothing: of most kinds a third is refused.
  EXPECT_GT(read, count / 50);
  EXPECT_GT(count - read, pixels ? -1 : count / 20);
}

INSTANTIATE_TEST_SUITE_P(Each, Mutations, testing::ValuesIn(AllFuzzKinds(kSomeImports)),
                         [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace dockyard
