// Makes the kept images anew: render_golden FOLDER.
#include <cstdio>
#include <exception>

#include "render/golden_views.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: render_golden FOLDER\n");
    return 2;
  }
  try {
    for (const dockyard::GoldenView& view : dockyard::GoldenViews()) {
      dockyard::WritePng(std::string(argv[1]) + "/" + view.name + ".png",
                         DrawGolden(*GoldenYard(view), dockyard::GoldenRig()));
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
