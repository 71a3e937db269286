// A mesh importer that crashes, loops, waits, eats memory or lies costs a message and no more.
#include <gmock/gmock.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstring>
#include <fstream>
#include <limits>
#include <new>
#include <thread>

#include "models/read/mesh_child.h"
#include "models/read/mesh_loader.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

// Short ones for the tests.
constexpr WorkLimits kLimits{
    .cpu_s = 1, .wall_s = 30.0, .memory_bytes = 64u << 20, .answer_bytes = 1u << 20};

TriangleMesh Triangle() {
  TriangleMesh mesh;
  mesh.vertices = {{0.1, -2.0, 3.0}, {1.0, 0.0, 0.0}, {0.0, 1e-30, 999.0}};
  mesh.triangles = {{0, 1, 2}, {2, 1, 0}};
  return mesh;
}

std::string MessageOf(const std::function<TriangleMesh()>& import,
                      const WorkLimits& limits = kLimits) {
  try {
    MeshFromChild("a.obj", limits, import);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "(no error)";
}

TEST(MeshChild, GivesTheImportersMeshBitForBit) {
  const TriangleMesh mesh = MeshFromChild("a.obj", kLimits, Triangle);
  EXPECT_EQ(mesh.vertices, Triangle().vertices);
  EXPECT_EQ(mesh.triangles, Triangle().triangles);
}

TEST(MeshChild, GivesTheImportersOwnRefusal) {
  EXPECT_EQ(MessageOf([]() -> TriangleMesh { throw ConfigError("a.obj: no good"); }),
            "a.obj: no good");
}

TEST(MeshChild, ACrashIsAMessage) {
  EXPECT_EQ(MessageOf([]() -> TriangleMesh {
              ::signal(SIGSEGV, SIG_DFL);  // sanitizers catch it
              ::raise(SIGSEGV);
              return {};
            }),
            "a.obj: not a usable mesh: the mesh importer crashed: killed by signal 11 "
            "(Segmentation fault)");
  EXPECT_THAT(MessageOf([]() -> TriangleMesh { std::abort(); }),
              HasSubstr("the mesh importer crashed: killed by signal 6"));
  EXPECT_THAT(MessageOf([]() -> TriangleMesh { throw 1; }),
              HasSubstr("the mesh importer crashed: ended with exit code 1"));
}

TEST(MeshChild, ALoopEndsAtItsProcessorTime) {
  EXPECT_EQ(MessageOf([]() -> TriangleMesh {
              for (std::atomic<int> i = 0;; ++i) {
              }
            }),
            "a.obj: not a usable mesh: the mesh importer took more than 1 s of processor time");
}

TEST(MeshChild, AWaitEndsAtItsTime) {
  WorkLimits limits = kLimits;
  limits.wall_s = 1.0;
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(MessageOf(
                []() -> TriangleMesh {
                  std::this_thread::sleep_for(std::chrono::minutes(10));
                  return {};
                },
                limits),
            "a.obj: not a usable mesh: the mesh importer took more than 1 s");
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  EXPECT_LT(took.count(), 20.0);
}

// AddressSanitizer reserves terabytes: under it there is no limit to test.
#if !defined(__SANITIZE_ADDRESS__) && !(defined(__clang__) && __has_feature(address_sanitizer))
TEST(MeshChild, MemoryEndsAtItsLimitEvenWhereTheImporterCatchesIt) {
  EXPECT_EQ(MessageOf([]() -> TriangleMesh {
              try {
                std::string(1u << 28, 'x');
              } catch (const std::bad_alloc&) {
              }
              return Triangle();
            }),
            "a.obj: not a usable mesh: the mesh importer took more than 64 MiB of memory");
  EXPECT_EQ(MessageOf([]() -> TriangleMesh {
              return std::string(1u << 24, 'x').empty() ? TriangleMesh() : Triangle();
            }),
            "(no error)");
}
#endif

TEST(MeshChild, WritesNoFile) {
  const ScratchFolder folder;
  const std::string file = (folder.path() / "out.txt").string();
  EXPECT_THAT(MessageOf([&]() -> TriangleMesh {
                std::ofstream(file) << "something" << std::flush;
                return Triangle();
              }),
              HasSubstr("the mesh importer crashed: killed by signal 25"));
  EXPECT_EQ(Slurp(file), "");
}

TEST(MeshChild, AnAnswerThatIsTooLongIsRefused) {
  TriangleMesh mesh = Triangle();
  mesh.vertices.resize(100000, mesh.vertices[0]);
  EXPECT_EQ(MessageOf([&] { return mesh; }),
            "a.obj: not a usable mesh: the mesh importer answered with too much");
}

TEST(MeshChild, TheMeshIsCheckedAgain) {
  TriangleMesh mesh = Triangle();
  mesh.triangles[1][2] = 3;
  EXPECT_THAT(MessageOf([&] { return mesh; }), HasSubstr("a vertex index out of range"));
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1000.5, -2e9}) {
    mesh = Triangle();
    mesh.vertices[2].z() = bad;
    EXPECT_THAT(MessageOf([&] { return mesh; }), HasSubstr("a coordinate that is not finite"));
  }
  EXPECT_THAT(MessageOf([] { return TriangleMesh(); }), HasSubstr("0 vertices and 0 triangles"));
}

TEST(MeshChild, BytesOfAnotherLengthThanTheirCountsAreRefused) {
  const std::string bytes = EncodeMesh(Triangle());
  EXPECT_EQ(DecodeMesh(bytes, "a.obj").triangles, Triangle().triangles);
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_THROW(DecodeMesh(bytes.substr(0, length), "a.obj"), ConfigError) << length;
  }
  EXPECT_THROW(DecodeMesh(bytes + '\0', "a.obj"), ConfigError);
  for (const std::size_t count : {0u, 4u}) {
    std::string many = bytes;
    std::memset(many.data() + count, 0xff, 4);
    EXPECT_THROW(DecodeMesh(many, "a.obj"), ConfigError) << count;
  }
}

TEST(MeshChild, LeavesNoChildAndNoDescriptorBehind) {
  const auto descriptors = [] {
    return std::distance(std::filesystem::directory_iterator("/proc/self/fd"),
                         std::filesystem::directory_iterator());
  };
  const auto before = descriptors();
  for (int i = 0; i < 3; ++i) MessageOf(Triangle);
  MessageOf([]() -> TriangleMesh { std::abort(); });
  EXPECT_EQ(descriptors(), before);
}

}  // namespace
}  // namespace dockyard
