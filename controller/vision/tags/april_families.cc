#include "controller/vision/tags/april_families.h"

#include <apriltag/tag16h5.h>
#include <apriltag/tag25h9.h>
#include <apriltag/tag36h11.h>
#include <apriltag/tagStandard41h12.h>
#include <apriltag/tagStandard52h13.h>

#include <array>

namespace dockyard {
namespace {

struct Entry {
  const char* name;
  apriltag_family_t* (*create)();
  void (*destroy)(apriltag_family_t*);
};
constexpr std::array kEntries{
    Entry{"tag16h5", tag16h5_create, tag16h5_destroy},
    Entry{"tag25h9", tag25h9_create, tag25h9_destroy},
    Entry{"tag36h11", tag36h11_create, tag36h11_destroy},
    Entry{"tagStandard41h12", tagStandard41h12_create, tagStandard41h12_destroy},
    Entry{"tagStandard52h13", tagStandard52h13_create, tagStandard52h13_destroy}};

}  // namespace

std::vector<std::string> AprilFamilyNames() {
  std::vector<std::string> names;
  for (const Entry& entry : kEntries) names.push_back(entry.name);
  return names;
}

AprilFamily AprilFamilyNamed(const std::string& name) {
  for (const Entry& entry : kEntries) {
    if (name == entry.name) return {entry.create(), entry.destroy};
  }
  return {nullptr, [](apriltag_family_t*) {}};
}

}  // namespace dockyard
