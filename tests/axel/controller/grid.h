// The starts of the Mars Yard grid, from the table that the campaign runs.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "controller/geometry/pose.h"
#include "support/source_tree.h"

namespace dockyard::axel {

struct GridStart {
  int run = 0;
  bool loose = false;
  DockingCoords at;
};

inline std::vector<GridStart> MarsYardGrid() {
  std::ifstream file(SourceFile("scenarios/mars_yard_40.csv"));
  std::vector<GridStart> starts;
  std::string line;
  std::getline(file, line);  // run,day,region,soil,light,r_m,alpha_deg,heading_deg
  while (std::getline(file, line)) {
    std::istringstream row(line);
    std::vector<std::string> cells;
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    starts.push_back({std::stoi(cells.at(0)),
                      cells.at(3) == "loose",
                      {std::stod(cells.at(5)), Radians(std::stod(cells.at(6))),
                       Radians(std::stod(cells.at(7)))}});
  }
  EXPECT_EQ(starts.size(), 40u);
  return starts;
}

}  // namespace dockyard::axel
