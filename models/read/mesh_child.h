// A mesh importer in a process of its own. What it sends back is checked as if it were a file.
#pragma once

#include <functional>
#include <string>

#include "models/parts/mesh.h"
#include "models/read/guarded_work.h"

namespace dockyard {

// The slowest file allowed (500 000 triangles as binary STL) took 2.5 s of processor time and 1.0
// GiB, the longest answer has 42 MB. The wall time leaves room for a machine with much else to do.
inline constexpr WorkLimits kImportLimits{.cpu_s = 30,
                                          .wall_s = 120.0,
                                          .memory_bytes = std::size_t{2} << 30,
                                          .answer_bytes = std::size_t{64} << 20};

/// The mesh that `import` gives in a child process. Throws ConfigError that begins with the file's
/// name: the importer's own; "the mesh importer crashed", "took more than N s" or "M MiB"; or that
/// the answer holds no usable mesh.
TriangleMesh MeshFromChild(const std::string& file, const WorkLimits& limits,
                           const std::function<TriangleMesh()>& import);

/// The bytes that the child sends, and back. DecodeMesh throws ConfigError, naming the file: a
/// length that does not fit the counts, counts beyond the limits of mesh_loader.h, a coordinate
/// that is not finite or too large, an index out of range.
std::string EncodeMesh(const TriangleMesh& mesh);
TriangleMesh DecodeMesh(const std::string& bytes, const std::string& file);

}  // namespace dockyard
