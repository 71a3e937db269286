// A log with one of its attachments changed, its check values made anew.
#pragma once

#include <filesystem>
#include <functional>

#include "sim/mcap/mcap_writer.h"

namespace dockyard {

/// Writes the log again, every attachment of it passed through.
void EditLog(const std::filesystem::path& file,
             const std::function<void(McapAttachment&)>& attachment, bool compress = true);

/// The same bytes with all check values made anew, as far as the records can be followed.
std::string WithCheckValues(std::string log);

}  // namespace dockyard
