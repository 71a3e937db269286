// Text for liburdfdom, and what it says about it.
#pragma once

#include <tinyxml.h>
#include <urdf_parser/urdf_parser.h>

#include <string>

namespace dockyard {

std::string TextOfXml(const TiXmlElement& element);

/// Throws ConfigError that begins with `place` when liburdfdom objects to anything.
urdf::ModelInterfaceSharedPtr ParseUrdfText(const std::string& text, const std::string& place);

}  // namespace dockyard
