// A Collada document made safe for an importer. assimp 5.2.5 follows counts, strides and instances
// as the file states them.
#pragma once

#include <string>

namespace dockyard {

/// The document reduced to its geometry and scene, written anew from the checked parts. Throws
/// ConfigError with line and column: XML that does not parse or that ScanXml refuses, a DOCTYPE,
/// arrays that do not hold as many numbers as their count, accessors beyond their array, indices
/// beyond their source, faces that do not add up to their count, skins, nodes that contain
/// themselves or more than 10 000 nodes once instances are followed.
std::string CheckedCollada(const std::string& text, const std::string& file);

}  // namespace dockyard
