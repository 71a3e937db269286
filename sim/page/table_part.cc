#include "sim/page/table_part.h"

#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "controller/base/number_text.h"

namespace dockyard {
namespace {

constexpr std::size_t kMostTexts = 1000;  // a dictionary; nobody picks one of more

/// Columns one after the other.
class Table {
 public:
  explicit Table(Payload& payload) : payload_(payload) {}

  template <class T>
  void Add(const std::string& name, const std::string& unit, const char* kind,
           const std::vector<T>& numbers) {
    columns_.push_back(
        {{"name", name}, {"unit", unit}, {"kind", kind}, {"blob", payload_.AddNumbers(numbers)}});
  }

  /// False where there are too many different ones.
  bool AddTexts(const std::string& name, const std::vector<std::string>& texts) {
    std::map<std::string, std::uint16_t> places;
    std::vector<std::string> dictionary;
    std::vector<std::uint16_t> codes;
    codes.reserve(texts.size());
    for (const std::string& text : texts) {
      const auto [at, fresh] = places.emplace(text, static_cast<std::uint16_t>(dictionary.size()));
      if (fresh) dictionary.push_back(text);
      if (dictionary.size() > kMostTexts) return false;
      codes.push_back(at->second);
    }
    Add(name, "", "u16", codes);
    columns_.back()["dictionary"] = dictionary;
    return true;
  }

  Json Take(std::size_t rows) { return {{"rows", rows}, {"columns", std::move(columns_)}}; }

 private:
  Payload& payload_;
  Json columns_ = Json::array();
};

template <class T, class Value>
std::vector<T> Each(std::size_t count, const Value& value) {
  std::vector<T> values;
  values.reserve(count);
  for (std::size_t i = 0; i < count; ++i) values.push_back(static_cast<T>(value(i)));
  return values;
}

/// All as numbers; none if one is no number.
std::optional<std::vector<double>> Numbers(const std::vector<std::string>& texts) {
  std::vector<double> numbers;
  numbers.reserve(texts.size());
  for (const std::string& text : texts) {
    const auto number = NumberFromText(text);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

/// "deg" of "start.alpha_deg"; empty where the name ends in no unit of ours.
std::string UnitOf(const std::string& label) {
  for (const char* unit : {"deg", "rad", "m", "kg", "s", "a", "n", "kpa"}) {
    if (label.ends_with(std::string("_") + unit)) {
      return unit == std::string("a") ? "A" : unit == std::string("n") ? "N" : unit;
    }
  }
  return "";
}

void AddStarts(const std::vector<Pose2>& starts, Table& table) {
  const auto add = [&](const char* name, const char* unit, double Pose2::*part) {
    table.Add(name, unit, "f32",
              Each<float>(starts.size(), [&](std::size_t i) { return starts[i].*part; }));
  };
  add("start_x_m", "m", &Pose2::x);
  add("start_y_m", "m", &Pose2::y);
  add("start_heading_rad", "rad", &Pose2::heading);
}

}  // namespace

Json TablePart(const FinishedRuns& runs, const RowColumns& columns,
               const std::vector<Pose2>& starts, Payload& payload,
               std::vector<std::string>& left_out) {
  const std::vector<RunResult>& rows = runs.results;
  const std::size_t count = rows.size();
  Table table(payload);
  const auto texts = [&](const auto& text) {
    return Each<std::string>(count, [&](std::size_t i) { return text(rows[i]); });
  };
  table.Add("run", "", "i32",
            Each<std::int32_t>(count, [&](std::size_t i) { return rows[i].run; }));
  table.AddTexts("outcome", texts([](const RunResult& row) { return row.outcome; }));
  table.Add("success", "", "u8",
            Each<std::uint8_t>(count, [&](std::size_t i) { return rows[i].success ? 1 : 0; }));
  table.AddTexts("controller", texts([](const RunResult& row) { return row.controller; }));
  for (std::size_t label = 0; label < columns.labels.size(); ++label) {
    const std::string& name = columns.labels[label];
    const auto values = texts([&](const RunResult& row) { return row.labels.at(label); });
    if (const auto numbers = Numbers(values)) {
      table.Add(name, UnitOf(name), "f64", *numbers);
    } else if (!table.AddTexts(name, values)) {
      left_out.push_back("The column " + name + " has more than " + std::to_string(kMostTexts) +
                         " different texts; results.csv has it.");
    }
  }
  if (!starts.empty()) AddStarts(starts, table);
  table.Add("sim_time_s", "s", "f32",
            Each<float>(count, [&](std::size_t i) { return rows[i].sim_time_s; }));
  table.Add("images", "", "i32",
            Each<std::int32_t>(count, [&](std::size_t i) { return rows[i].images; }));
  for (std::size_t m = 0; m < columns.measures.size(); ++m) {
    const Column& measure = columns.measures[m];
    table.Add(measure.name, measure.unit, "f32", Each<float>(count, [&](std::size_t i) {
                const auto& measures = rows[i].measures;
                return m < measures.size() ? measures[m] : std::nan("");
              }));
  }
  if (runs.timings.size() == count) {
    const auto add = [&](const char* name, double RunTiming::*part) {
      table.Add(name, "s", "f32",
                Each<float>(count, [&](std::size_t i) { return runs.timings[i].*part; }));
    };
    add("cpu_time_s", &RunTiming::cpu_time_s);
    add("wall_time_s", &RunTiming::wall_time_s);
  }
  return table.Take(count);
}

}  // namespace dockyard
