#include "sim/mcap/mcap_repair.h"

#include "sim/base/bytes.h"
#include "sim/base/crc32.h"
#include "sim/base/files.h"
#include "sim/mcap/mcap_reader.h"

namespace dockyard {

bool RepairMcap(const std::filesystem::path& file) {
  McapReader reader(file);
  while (reader.Next()) {
  }
  if (reader.complete()) return false;
  const McapReader::Rest rest = reader.WhatIsWhole();
  std::string data = ReadWhole(file).value_or("");
  data.resize(rest.keep);
  data += rest.add;
  std::string data_end;
  PutU32(data_end, Crc32(data));
  data += McapRecord(McapOp::kDataEnd, data_end);
  data += rest.summary.Bytes(data.size());
  WriteWhole(file, data);
  return true;
}

}  // namespace dockyard
