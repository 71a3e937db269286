// The printed results and the files of `dockyard wheel`.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/soil/single_wheel.h"
#include "sim/soil/wheel_data.h"

namespace dockyard {

struct WheelRow {
  double load_n = 0.0, beta_deg = 0.0, slip = 0.0;
  SingleWheelResult result;
  bool buried = false;                  // its axle is below the ground
  std::vector<std::string> warnings{};  // premises that do not hold

  /// Whether the means are a result: of forces that no longer change, on a wheel above the ground.
  bool holds() const { return result.steady && !buried; }
};

/// One result, a line for each quantity.
void PrintWheelResult(const WheelRow& row);
/// A line of the sweep's table, with its head if asked.
void PrintWheelRow(const WheelRow& row, bool with_head);
/// An object, or for a sweep a list of objects.
std::string WheelJson(const std::vector<WheelRow>& table, bool as_list);

/// drawbar.svg's and sinkage.svg's text: curves over slip, one for each side slip and load, with
/// the measured rows as squares in the colour of their side slip; rows of other side slips are left
/// out.
std::string DrawbarPlot(const std::vector<WheelRow>& table,
                        const std::vector<MeasuredRow>& measured);
std::string SinkagePlot(const std::vector<WheelRow>& table,
                        const std::vector<MeasuredRow>& measured);
/// sweep.csv, drawbar.svg and sinkage.svg into the folder. Throws IoError.
void WriteWheelSweep(const std::vector<WheelRow>& table, const std::vector<MeasuredRow>& measured,
                     const std::filesystem::path& folder);

}  // namespace dockyard
